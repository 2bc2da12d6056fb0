/* SPDX-License-Identifier: MIT */
/* shd/transform.h: every refusal, and every function against another method in long double. */
#include "ref/transform_ref.h"
#include "support/check.h"

#include <shd/transform.h>
#include <shd/view.h>

#define BAD SHD_ERROR_INVALID_ARGUMENT
#define COUNT(table) (sizeof(table) / sizeof(table)[0])

/* Half an ulp of float, and a margin for the rounding of double. */
static const double k_round = 5.97e-8;

static const float k_identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

static void fill_garbage(float *m, size_t count)
{
    size_t i;
    for (i = 0; i < count; ++i) m[i] = -77.0f;
}

static void assert_garbage(const char *what, const float *m, size_t count)
{
    size_t i;
    for (i = 0; i < count; ++i) {
        if (m[i] != -77.0f) fail_msg("%s: element %zu was written", what, i);
    }
}

/* Projections. */

struct perspective_case {
    const char *name;
    float fov_y, aspect, near_plane, far_plane;
    int order;
    const char *message; /* NULL = success */
};

static const struct perspective_case k_perspective[] = {
    {"perspective/plain", 0.8f, 1.5f, 0.1f, 100, 0, NULL},
    {"perspective/reversed", 0.8f, 1.5f, 0.1f, 100, 1, NULL},
    {"perspective/infinite", 1.2f, 0.7f, 0.25f, INFINITY, 0, NULL},
    {"perspective/infinite_reversed", 1.2f, 0.7f, 0.25f, INFINITY, 1, NULL},
    {"perspective/far_1e30", 1.2f, 0.7f, 1e-3f, 1e30f, 1, NULL},
    {"perspective/fov_0", 0, 1, 1, 2, 0, "perspective.fov_y: 0 is not above 0"},
    {"perspective/fov_nan", NAN, 1, 1, 2, 0, "perspective.fov_y: "},
    {"perspective/fov_pi", 3.14159274f, 1, 1, 2, 0, "perspective.fov_y: 3.14159 is not below pi"},
    {"perspective/aspect_0", 1, 0, 1, 2, 0, "perspective.aspect: 0 is not above 0"},
    {"perspective/aspect_inf", 1, INFINITY, 1, 2, 0, "perspective.aspect: inf"},
    {"perspective/near_0", 1, 1, 0, 2, 0, "perspective.near_plane: 0"},
    {"perspective/near_inf", 1, 1, INFINITY, INFINITY, 0, "perspective.near_plane: inf"},
    {"perspective/far_is_near", 1, 1, 2, 2, 0, "perspective.far_plane: 2 is not above near_plane 2"},
    {"perspective/far_nan", 1, 1, 2, NAN, 0, "perspective.far_plane: "},
    {"perspective/far_minus_inf", 1, 1, 2, -INFINITY, 0, "perspective.far_plane: -inf"},
    {"perspective/order_2", 1, 1, 1, 2, 2, "perspective.order: 2 is not in 0..1"},
    {"perspective/beyond_float", 1e-30f, 1e-30f, 1, 2, 0, "perspective: the result exceeds the range of float"},
};

/* A corner of the view volume is mapped to (1, 1, depth). */
static void check_corner(const char *name, const float *m, long double x, long double y, long double distance,
                         long double depth, double tolerance)
{
    const long double corner[4] = {x, y, -distance, 1};
    long double clip[4];
    shd_ref_apply(m, corner, clip);
    shd_assert_close(name, 0, (double)(clip[0] / clip[3]), 1, 3e-7, 0);
    shd_assert_close(name, 1, (double)(clip[1] / clip[3]), 1, 3e-7, 0);
    shd_assert_close(name, 2, (double)(clip[2] / clip[3]), (double)depth, tolerance, 0);
}

static void test_perspective(void **state)
{
    const struct perspective_case *c = (const struct perspective_case *)*state;
    const long double far_plane = isinf(c->far_plane) ? 1e15L : (long double)c->far_plane;
    long double top;
    float m[16];
    shd_depth_order order;
    memcpy(&order, &c->order, sizeof order);
    fill_garbage(m, 16);
    shd_assert_result(c->name, shd_matrix_perspective(c->fov_y, c->aspect, c->near_plane, c->far_plane, order, m),
                      c->message ? BAD : SHD_OK, c->message);
    if (c->message) {
        assert_garbage(c->name, m, 16);
        return;
    }
    top = tanl(0.5L * (long double)c->fov_y);
    shd_assert_close(c->name, 5, m[5], (double)(1 / top), 0, k_round);
    shd_assert_close(c->name, 6, m[0], (double)(1 / (top * (long double)c->aspect)), 0, k_round);
    check_corner(c->name, m, top * (long double)c->near_plane * (long double)c->aspect,
                 top * (long double)c->near_plane, c->near_plane, c->order, 3e-7);
    check_corner(c->name, m, top * far_plane * (long double)c->aspect, top * far_plane, far_plane, !c->order, 3e-7);
}

/* The forward projection of a camera, bit for bit. */
static void test_same_as_camera(void **state)
{
    shd_camera camera = shd_camera_default();
    shd_view view;
    float m[16];
    (void)state;
    camera.aspect = 1.7f;
    camera.eye[0] = 2.5f;
    camera.up[0] = 0.3f;
    shd_assert_ok(shd_view_from_camera(&camera, &view));
    shd_assert_ok(shd_matrix_perspective(camera.fov_y, camera.aspect, camera.near_plane, camera.far_plane,
                                         SHD_DEPTH_ORDER_FORWARD, m));
    assert_memory_equal(m, view.view_to_clip, sizeof m);
    shd_assert_ok(shd_matrix_look_at(camera.eye, camera.target, camera.up, m));
    assert_memory_equal(m, view.world_to_view, sizeof m);
}

static void test_orthographic(void **state)
{
    const float box[4] = {-3, 5, -0.5f, 2};
    int order;
    (void)state;
    for (order = 0; order < 2; ++order) {
        float m[16];
        long double low[4] = {-3, -0.5L, 2, 1}, clip[4];
        shd_assert_ok(shd_matrix_orthographic(box, -2, 9, (shd_depth_order)order, m));
        check_corner("orthographic far", m, 5, 2, 9, !order, 3e-7);
        shd_ref_apply(m, low, clip);
        shd_assert_close("orthographic near", 0, (double)clip[0], -1, 3e-7, 0);
        shd_assert_close("orthographic near", 1, (double)clip[1], -1, 3e-7, 0);
        shd_assert_close("orthographic near", 2, (double)clip[2], order, 3e-7, 0);
        assert_true(clip[3] == 1);
    }
}

/* Refusals. */

struct call {
    float a[16], b[16], out[16];
};

static shd_result call_orthographic(struct call *c)
{
    return shd_matrix_orthographic(c->a, c->b[0], c->b[1], SHD_DEPTH_ORDER_FORWARD, c->out);
}
static shd_result call_look_at(struct call *c) { return shd_matrix_look_at(c->a, c->a + 3, c->b, c->out); }
static shd_result call_trs(struct call *c) { return shd_matrix_from_trs(c->a, c->a + 4, c->b, c->out); }
static shd_result call_multiply(struct call *c) { return shd_matrix_multiply(c->a, c->b, c->out); }
static shd_result call_invert(struct call *c) { return shd_matrix_invert(c->a, c->out); }
static shd_result call_normal(struct call *c) { return shd_matrix_normal(c->a, c->out); }
static shd_result call_point(struct call *c) { return shd_matrix_transform_point(c->a, c->b, c->out); }
static shd_result call_direction(struct call *c) { return shd_matrix_transform_direction(c->a, c->b, c->out); }

struct refusal {
    const char *name;
    shd_result (*call)(struct call *c);
    float a[16], b[16];
    const char *message;
};

static const struct refusal k_refusals[] = {
    {"orthographic/width_0", call_orthographic, {1, 1, 0, 1}, {0, 1}, "orthographic.rectangle: its width is 0"},
    {"orthographic/height_0", call_orthographic, {0, 1, 2, 2}, {0, 1}, "orthographic.rectangle: its height is 0"},
    {"orthographic/nan", call_orthographic, {0, 1, NAN, 2}, {0, 1}, "orthographic.rectangle[2]: "},
    {"orthographic/near_inf", call_orthographic, {0, 1, 0, 1}, {-INFINITY, 1}, "orthographic.near_plane[0]: -inf"},
    {"orthographic/far_inf", call_orthographic, {0, 1, 0, 1}, {0, INFINITY}, "orthographic.far_plane[0]: inf"},
    {"orthographic/far_is_near", call_orthographic, {0, 1, 0, 1}, {3, 3}, "far_plane: 3 is not above near_plane 3"},
    {"orthographic/thin", call_orthographic, {0, 1e-44f, 0, 1}, {0, 1}, "orthographic: the result exceeds the range"},
    {"look_at/target_is_eye", call_look_at, {1, 2, 3, 1, 2, 3}, {0, 1, 0}, "look_at.target: is the eye"},
    {"look_at/up_0", call_look_at, {1, 2, 3}, {0, 0, 0}, "look_at.up: (0, 0, 0) has no direction"},
    {"look_at/up_along", call_look_at, {0, 0, 3}, {0, 0, 5}, "look_at.up: lies along the line of sight"},
    {"look_at/eye_nan", call_look_at, {0, NAN, 3}, {0, 1, 0}, "look_at.eye[1]: "},
    {"look_at/far_out", call_look_at, {3.4e38f, 3.4e38f, 3.4e38f}, {0, 1, 0}, "look_at: the result exceeds"},
    {"trs/rotation_0", call_trs, {0}, {1, 1, 1}, "trs.rotation: (0, 0, 0, 0) is no rotation"},
    {"trs/translation_inf", call_trs, {0, INFINITY, 0, 0, 0, 0, 0, 1}, {1, 1, 1}, "trs.translation[1]: inf"},
    {"trs/rotation_nan", call_trs, {0, 0, 0, 0, 0, 0, NAN, 1}, {1, 1, 1}, "trs.rotation[2]: "},
    {"trs/scale_nan", call_trs, {0, 0, 0, 0, 0, 0, 0, 1}, {1, 1, NAN}, "trs.scale[2]: "},
    {"multiply/nan", call_multiply, {0}, {0, 0, 0, 0, 0, NAN}, "b[5]: "},
    {"multiply/inf", call_multiply, {0, 0, 0, 0, INFINITY}, {0}, "a[4]: inf is not finite"},
    {"multiply/overflow", call_multiply, {3e38f}, {3e38f}, "multiply: the result exceeds the range of float"},
    {"invert/zero", call_invert, {0}, {0}, "matrix: has no inverse"},
    {"invert/nan", call_invert, {NAN}, {0}, "matrix[0]: "},
    {"invert/flat", call_invert, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 4, 5, 6, 1}, {0}, "matrix: has no inverse"},
    {"invert/rank_2", call_invert, {1, 4, 7, 0, 2, 5, 8, 0, 3, 6, 9, 0, 0, 0, 0, 1}, {0}, "matrix: has no inverse"},
    {"invert/rank_3",
     call_invert,
     {1.1f, 2.2f, 3.3f, 4.4f, 5, 7, 11, 13, 2.2f, 4.4f, 6.6f, 8.8f, 1, 0, 1, 0},
     {0},
     "matrix: has no inverse"},
    {"invert/beyond_float",
     call_invert,
     {1e-40f, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1},
     {0},
     "invert: the result exceeds the range of float"},
    {"normal/flat", call_normal, {1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, {0}, "matrix: has no inverse"},
    {"normal/nan", call_normal, {0, 0, 0, 0, NAN}, {0}, "matrix[4]: "},
    {"point/w_0", call_point, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -1, 0, 0, 0, 0}, {1, 2, 0}, "point: its w"},
    {"point/nan", call_point, {1}, {1, NAN, 0}, "point[1]: "},
    {"point/overflow", call_point, {2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, {3e38f}, "point: the result"},
    {"direction/overflow", call_direction, {2}, {3e38f}, "direction: the result exceeds the range of float"},
    {"direction/inf", call_direction, {2}, {0, 0, INFINITY}, "direction[2]: inf"},
};

static void test_refusal(void **state)
{
    const struct refusal *r = (const struct refusal *)*state;
    struct call c;
    memcpy(c.a, r->a, sizeof c.a);
    memcpy(c.b, r->b, sizeof c.b);
    fill_garbage(c.out, 16);
    shd_assert_result(r->name, r->call(&c), BAD, r->message);
    assert_garbage(r->name, c.out, 16);
}

static void test_null(void **state)
{
    const float *m = k_identity;
    float out[16];
    (void)state;
    shd_assert_result("perspective", shd_matrix_perspective(1, 1, 1, 2, SHD_DEPTH_ORDER_FORWARD, NULL), BAD,
                      "out_matrix: NULL");
    shd_assert_result("ortho", shd_matrix_orthographic(NULL, 1, 2, SHD_DEPTH_ORDER_FORWARD, out), BAD,
                      "orthographic.rectangle: NULL");
    shd_assert_result("ortho", shd_matrix_orthographic(m, 1, 2, SHD_DEPTH_ORDER_FORWARD, NULL), BAD, "out_matrix");
    shd_assert_result("look_at", shd_matrix_look_at(NULL, m, m, out), BAD, "look_at.eye: NULL");
    shd_assert_result("look_at", shd_matrix_look_at(m, NULL, m, out), BAD, "look_at.target: NULL");
    shd_assert_result("look_at", shd_matrix_look_at(m, m, NULL, out), BAD, "look_at.up: NULL");
    shd_assert_result("look_at", shd_matrix_look_at(m, m + 4, m, NULL), BAD, "out_matrix: NULL");
    shd_assert_result("trs", shd_matrix_from_trs(NULL, NULL, NULL, NULL), BAD, "out_matrix: NULL");
    shd_assert_result("multiply", shd_matrix_multiply(NULL, m, out), BAD, "a: NULL");
    shd_assert_result("multiply", shd_matrix_multiply(m, NULL, out), BAD, "b: NULL");
    shd_assert_result("multiply", shd_matrix_multiply(m, m, NULL), BAD, "out_matrix: NULL");
    shd_assert_result("invert", shd_matrix_invert(NULL, out), BAD, "matrix: NULL");
    shd_assert_result("invert", shd_matrix_invert(m, NULL), BAD, "out_matrix: NULL");
    shd_assert_result("normal", shd_matrix_normal(NULL, out), BAD, "matrix: NULL");
    shd_assert_result("normal", shd_matrix_normal(m, NULL), BAD, "out_3x3: NULL");
    shd_assert_result("point", shd_matrix_transform_point(NULL, m, out), BAD, "matrix: NULL");
    shd_assert_result("point", shd_matrix_transform_point(m, NULL, out), BAD, "point: NULL");
    shd_assert_result("point", shd_matrix_transform_point(m, m, NULL), BAD, "out_point: NULL");
    shd_assert_result("direction", shd_matrix_transform_direction(NULL, m, out), BAD, "matrix: NULL");
    shd_assert_result("direction", shd_matrix_transform_direction(m, NULL, out), BAD, "direction: NULL");
    shd_assert_result("direction", shd_matrix_transform_direction(m, m, NULL), BAD, "out_direction: NULL");
    shd_assert_ok(shd_matrix_from_trs(NULL, NULL, NULL, out));
    assert_memory_equal(out, k_identity, sizeof out);
}

/* Random matrices: products, placements and inverses. */

/* Any number in [-1, 1), by Knuth's linear congruence. */
static float any(uint64_t *state)
{
    *state = *state * 6364136223846793005ull + 1442695040888963407ull;
    return (float)((double)(*state >> 40) / 8388608.0 - 1);
}

static void test_trs(void **state)
{
    uint64_t random = 7;
    int i, axis, r;
    (void)state;
    for (i = 0; i < 2000; ++i) {
        float t[3], q[4], s[3], m[16];
        const float size = i % 3 == 0 ? 1e-18f : i % 3 == 1 ? 1 : 1e18f;
        for (r = 0; r < 3; ++r) {
            t[r] = 10 * any(&random);
            s[r] = 3 * any(&random);
        }
        for (r = 0; r < 4; ++r) q[r] = size * any(&random);
        shd_assert_ok(shd_matrix_from_trs(t, q, s, m));
        for (axis = 0; axis < 3; ++axis) {
            long double unit[3] = {0, 0, 0}, turned[3];
            unit[axis] = 1;
            shd_ref_rotate(q, unit, turned);
            for (r = 0; r < 3; ++r) {
                const double want = (double)(turned[r] * (long double)s[axis]);
                shd_assert_close("trs", (size_t)(4 * axis + r), m[4 * axis + r], want, 1e-14, k_round);
            }
        }
        assert_true(m[12] == t[0] && m[13] == t[1] && m[14] == t[2]);
        assert_true(m[3] == 0 && m[7] == 0 && m[11] == 0 && m[15] == 1);
    }
}

static void test_multiply(void **state)
{
    uint64_t random = 8;
    int i, k, c;
    (void)state;
    for (i = 0; i < 1000; ++i) {
        float a[16], b[16], product[16], in_place[16];
        for (k = 0; k < 16; ++k) {
            a[k] = any(&random);
            b[k] = any(&random);
        }
        shd_assert_ok(shd_matrix_multiply(a, b, product));
        for (c = 0; c < 4; ++c) {
            long double column[4], want[4];
            for (k = 0; k < 4; ++k) column[k] = b[4 * c + k];
            shd_ref_apply(a, column, want);
            for (k = 0; k < 4; ++k) {
                shd_assert_close("multiply", (size_t)(4 * c + k), product[4 * c + k], (double)want[k], 1e-15, k_round);
            }
        }
        memcpy(in_place, a, sizeof a);
        shd_assert_ok(shd_matrix_multiply(in_place, b, in_place));
        assert_memory_equal(in_place, product, sizeof product);
        memcpy(in_place, b, sizeof b);
        shd_assert_ok(shd_matrix_multiply(a, in_place, in_place));
        assert_memory_equal(in_place, product, sizeof product);
    }
}

/* Every element is within half an ulp, plus a margin for the condition number of the matrix in double. */
static void check_inverse(const char *name, const float *m, int size, const float *got, int step)
{
    long double want[16], largest_in = 0, largest_out = 0;
    double slack;
    int r, c;
    assert_true(shd_ref_invert(m, size, want) != 0);
    for (c = 0; c < size; ++c) {
        for (r = 0; r < size; ++r) {
            largest_in = fmaxl(largest_in, fabsl((long double)m[4 * c + r]));
            largest_out = fmaxl(largest_out, fabsl(want[4 * c + r]));
        }
    }
    slack = (double)(1e-14L * largest_out * (1 + largest_in * largest_out));
    for (c = 0; c < size; ++c) {
        for (r = 0; r < size; ++r) {
            const double value = step == 3 ? got[3 * r + c] : got[4 * c + r]; /* normals are transposed */
            shd_assert_close(name, (size_t)(4 * c + r), value, (double)want[4 * c + r], slack, k_round);
        }
    }
}

static void test_inverse_random(void **state)
{
    uint64_t random = 9;
    int i, k;
    (void)state;
    for (i = 0; i < 4000; ++i) {
        float m[16], inverse[16], normal[9];
        for (k = 0; k < 16; ++k) m[k] = any(&random);
        if (i % 2) {
            m[3] = m[7] = m[11] = 0;
            m[15] = 1;
        }
        shd_assert_ok(shd_matrix_invert(m, inverse));
        check_inverse("inverse", m, 4, inverse, 4);
        if (i % 2) assert_true(inverse[3] == 0 && inverse[7] == 0 && inverse[11] == 0 && inverse[15] == 1);
        shd_assert_ok(shd_matrix_normal(m, normal));
        check_inverse("normal", m, 3, normal, 3);
        shd_assert_ok(shd_matrix_invert(m, m));
        assert_memory_equal(m, inverse, sizeof m);
    }
}

/* Matrices with axes of very different scales, and projections with distant planes, are not singular. */
static void test_inverse_scales(void **state)
{
    float m[16], inverse[16];
    int i, k;
    (void)state;
    for (i = 0; i < 3; ++i) {
        memcpy(m, k_identity, sizeof m);
        m[5 * i] = 1e-30f;
        m[5 * ((i + 1) % 3)] = 1e30f;
        m[12] = 4;
        shd_assert_ok(shd_matrix_invert(m, inverse));
        for (k = 0; k < 3; ++k) shd_assert_close("scales", (size_t)k, inverse[5 * k], 1 / (double)m[5 * k], 0, k_round);
    }
    for (i = 0; i < 2; ++i) {
        shd_assert_ok(shd_matrix_perspective(0.7f, 1.6f, 1e-3f, i ? INFINITY : 1e6f, SHD_DEPTH_ORDER_REVERSED, m));
        shd_assert_ok(shd_matrix_invert(m, inverse));
        shd_assert_ok(shd_matrix_multiply(m, inverse, m));
        for (k = 0; k < 16; ++k) shd_assert_close("projection", (size_t)k, m[k], k_identity[k], 2e-7, 0);
    }
}

/* A nearly singular matrix is refused or gives a correct inverse; never NaN. */
static void test_inverse_slivers(void **state)
{
    int exponent, refused = 0, k;
    (void)state;
    for (exponent = 0; exponent >= -60; --exponent) {
        float m[16], inverse[16];
        memcpy(m, k_identity, sizeof m);
        m[4] = 1; /* columns (1, 0, 0) and (1, e, 0) */
        m[5] = (float)ldexp(1, exponent);
        m[1] = 0.0f;
        if (shd_matrix_invert(m, inverse) == SHD_OK) {
            for (k = 0; k < 16; ++k) assert_true(isfinite(inverse[k]));
            shd_assert_close("sliver", (size_t)-exponent, inverse[5], ldexp(1, -exponent), 0, 1e-6);
        } else {
            ++refused;
        }
    }
    assert_int_equal(refused, 0); /* triangular: scaling makes the columns independent */
    for (exponent = -1; exponent >= -23; --exponent) {
        float m[16], inverse[16];
        memcpy(m, k_identity, sizeof m);
        m[0] = m[1] = m[4] = 1;
        m[5] = 1 + (float)ldexp(1, exponent);
        shd_assert_ok(shd_matrix_invert(m, inverse));
        shd_assert_close("close columns", (size_t)-exponent, inverse[5], ldexp(1, -exponent), 0, 1e-6);
    }
}

static void test_transform(void **state)
{
    uint64_t random = 10;
    int i, k;
    (void)state;
    for (i = 0; i < 1000; ++i) {
        float m[16], p[3], out[3];
        long double point[4], direction[4], want[4];
        for (k = 0; k < 16; ++k) m[k] = any(&random);
        for (k = 0; k < 3; ++k) point[k] = direction[k] = p[k] = any(&random);
        point[3] = 1;
        direction[3] = 0;
        shd_ref_apply(m, point, want);
        if (fabsl(want[3]) > 1e-3L) {
            shd_assert_ok(shd_matrix_transform_point(m, p, out));
            for (k = 0; k < 3; ++k) {
                shd_assert_close("point", (size_t)k, out[k], (double)(want[k] / want[3]), 1e-10, k_round);
            }
        }
        shd_ref_apply(m, direction, want);
        shd_assert_ok(shd_matrix_transform_direction(m, p, p));
        for (k = 0; k < 3; ++k) shd_assert_close("direction", (size_t)k, p[k], (double)want[k], 1e-15, k_round);
    }
}

/* The bits of one result of each function: every machine and compiler must give them. */
static void test_bits(void **state)
{
    const float rectangle[4] = {-1.1f, 1.3f, -0.7f, 0.9f}, t[3] = {1, -2, 3}, q[4] = {0.1f, 0.7f, -0.3f, 0.6f};
    const float s[3] = {1.5f, 0.3f, 2};
    float m[4][16], normal[9], point[3];
    uint64_t hash = SHD_HASH_START;
    (void)state;
    shd_assert_ok(shd_matrix_perspective(0.9f, 1.77f, 0.3f, 70, SHD_DEPTH_ORDER_REVERSED, m[0]));
    shd_assert_ok(shd_matrix_orthographic(rectangle, 0.1f, 9.7f, SHD_DEPTH_ORDER_FORWARD, m[1]));
    shd_assert_ok(shd_matrix_from_trs(t, q, s, m[2]));
    shd_assert_ok(shd_matrix_multiply(m[0], m[2], m[3]));
    shd_assert_ok(shd_matrix_invert(m[3], m[3]));
    shd_assert_ok(shd_matrix_normal(m[2], normal));
    shd_assert_ok(shd_matrix_transform_point(m[3], t, point));
    hash = shd_hash(hash, m, sizeof m);
    hash = shd_hash(hash, normal, sizeof normal);
    hash = shd_hash(hash, point, sizeof point);
    assert_int_equal(hash, 0x9eedcaf26132da21ull);
}

int main(void)
{
    static struct CMUnitTest tests[COUNT(k_perspective) + COUNT(k_refusals) + 12];
    size_t n = 0, i;
    for (i = 0; i < COUNT(k_perspective); ++i) {
        tests[n++] =
            (struct CMUnitTest){k_perspective[i].name, test_perspective, NULL, NULL, (void *)&k_perspective[i]};
    }
    for (i = 0; i < COUNT(k_refusals); ++i) {
        tests[n++] = (struct CMUnitTest){k_refusals[i].name, test_refusal, NULL, NULL, (void *)&k_refusals[i]};
    }
    tests[n++] = (struct CMUnitTest){"same_as_camera", test_same_as_camera, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"orthographic", test_orthographic, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"null", test_null, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"trs_2000", test_trs, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"multiply_1000", test_multiply, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"inverse/random_4000", test_inverse_random, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"inverse/scales", test_inverse_scales, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"inverse/slivers", test_inverse_slivers, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"transform_1000", test_transform, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"bits", test_bits, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.transform", tests, n, NULL, NULL);
}
