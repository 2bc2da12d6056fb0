/* SPDX-License-Identifier: MIT */
/* Cameras: every field, and transformed points against double arithmetic. */
#include "support/check.h"

#include <shd/view.h>

static const double k_pi = 3.14159265358979323846;

static void set3(float *v, float x, float y, float z)
{
    v[0] = x;
    v[1] = y;
    v[2] = z;
}

static void edit_nothing(shd_camera *c) { (void)c; }
static void edit_size(shd_camera *c) { c->struct_size = 8; }
static void edit_fov_0(shd_camera *c) { c->fov_y = 0; }
static void edit_fov_negative(shd_camera *c) { c->fov_y = -0.5f; }
static void edit_fov_pi(shd_camera *c) { c->fov_y = 3.14159274f; }
static void edit_fov_below_pi(shd_camera *c) { c->fov_y = 3.1415925f; }
static void edit_fov_nan(shd_camera *c) { c->fov_y = (float)NAN; }
static void edit_fov_denormal(shd_camera *c) { c->fov_y = 1e-45f; }
static void edit_fov_narrow(shd_camera *c) { c->fov_y = 1e-6f; }
static void edit_aspect_0(shd_camera *c) { c->aspect = 0; }
static void edit_aspect_negative(shd_camera *c) { c->aspect = -1; }
static void edit_aspect_nan(shd_camera *c) { c->aspect = (float)NAN; }
static void edit_aspect_inf(shd_camera *c) { c->aspect = INFINITY; }
static void edit_aspect_tiny(shd_camera *c) { c->aspect = 1e-42f; }
static void edit_near_0(shd_camera *c) { c->near_plane = 0; }
static void edit_near_nan(shd_camera *c) { c->near_plane = (float)NAN; }
static void edit_near_is_far(shd_camera *c) { c->near_plane = c->far_plane; }
static void edit_near_beyond_far(shd_camera *c) { c->near_plane = 200; }
static void edit_near_just_below_far(shd_camera *c) { c->near_plane = 99.99999f; }
static void edit_far_inf(shd_camera *c) { c->far_plane = INFINITY; }
static void edit_far_max(shd_camera *c) { c->far_plane = 3.4e38f; }
static void edit_planes_huge(shd_camera *c)
{
    c->near_plane = 3.3e38f;
    c->far_plane = 3.4e38f;
}
static void edit_eye_nan(shd_camera *c) { c->eye[1] = (float)NAN; }
static void edit_eye_inf(shd_camera *c) { c->eye[0] = INFINITY; }
static void edit_target_nan(shd_camera *c) { c->target[2] = (float)NAN; }
static void edit_target_is_eye(shd_camera *c) { set3(c->target, 0, -0.0f, 3); }
static void edit_up_nan(shd_camera *c) { c->up[0] = (float)NAN; }
static void edit_up_0(shd_camera *c) { set3(c->up, 0, 0, 0); }
static void edit_up_along(shd_camera *c) { set3(c->up, 0, 0, -7); }
static void edit_up_nearly_along(shd_camera *c) { set3(c->up, 1e-8f, 0, 1); }
static void edit_up_slanted(shd_camera *c) { set3(c->up, 1e-3f, 0, 1); }
static void edit_up_denormal(shd_camera *c) { set3(c->up, 0, 1e-45f, 0); }
static void edit_up_huge(shd_camera *c) { set3(c->up, 3e38f, 3e38f, 3e38f); }
static void edit_far_apart(shd_camera *c)
{
    set3(c->eye, 3e38f, 0, 0);
    set3(c->target, -3e38f, 0, 0);
}
static void edit_eye_out_of_range(shd_camera *c)
{
    set3(c->eye, 3.4e38f, 3.4e38f, 3.4e38f);
    set3(c->target, 0, 0, 0);
}
static void edit_oblique(shd_camera *c)
{
    set3(c->eye, 4, -5, 6);
    set3(c->target, 1, 2, -3);
    set3(c->up, 0.3f, 5, 0.2f);
    c->fov_y = 1.3f;
    c->aspect = 1.777f;
    c->near_plane = 0.5f;
    c->far_plane = 70;
}

struct camera_case {
    const char *name;
    void (*edit)(shd_camera *camera);
    shd_result expected;
    const char *message;
};

#define BAD SHD_ERROR_INVALID_ARGUMENT
static const struct camera_case k_cameras[] = {
    {"camera/defaults", edit_nothing, SHD_OK, ""},
    {"camera/oblique", edit_oblique, SHD_OK, ""},
    {"camera/fov_below_pi", edit_fov_below_pi, SHD_OK, ""},
    {"camera/fov_1e-6", edit_fov_narrow, SHD_OK, ""},
    {"camera/near_just_below_far", edit_near_just_below_far, SHD_OK, ""},
    {"camera/far_3.4e38", edit_far_max, SHD_OK, ""},
    {"camera/up_slanted", edit_up_slanted, SHD_OK, ""},
    {"camera/up_denormal", edit_up_denormal, SHD_OK, ""},
    {"camera/up_3e38", edit_up_huge, SHD_OK, ""},
    {"camera/eye_and_target_6e38_apart", edit_far_apart, SHD_OK, ""},
    {"camera/struct_size_8", edit_size, BAD, "camera.struct_size: 8"},
    {"camera/fov_0", edit_fov_0, BAD, "camera.fov_y: 0 is not above 0"},
    {"camera/fov_negative", edit_fov_negative, BAD, "camera.fov_y: -0.5"},
    {"camera/fov_pi", edit_fov_pi, BAD, "camera.fov_y: 3.14159 is not below pi"},
    {"camera/fov_nan", edit_fov_nan, BAD, "camera.fov_y: "},
    {"camera/fov_denormal", edit_fov_denormal, BAD, "camera: its view_to_clip"},
    {"camera/aspect_0", edit_aspect_0, SHD_OK, ""},
    {"camera/aspect_negative", edit_aspect_negative, BAD, "camera.aspect: -1 is not above 0"},
    {"camera/aspect_nan", edit_aspect_nan, BAD, "camera.aspect: "},
    {"camera/aspect_inf", edit_aspect_inf, BAD, "camera.aspect: inf"},
    {"camera/aspect_denormal", edit_aspect_tiny, BAD, "camera: its view_to_clip"},
    {"camera/near_0", edit_near_0, BAD, "camera.near_plane: 0"},
    {"camera/near_nan", edit_near_nan, BAD, "camera.near_plane: "},
    {"camera/near_is_far", edit_near_is_far, BAD, "camera.far_plane: 100 is not above near_plane 100"},
    {"camera/near_beyond_far", edit_near_beyond_far, BAD, "camera.far_plane: 100 is not above near_plane 200"},
    {"camera/far_inf", edit_far_inf, BAD, "camera.far_plane: inf"},
    {"camera/planes_near_flt_max", edit_planes_huge, BAD, "camera: its view_to_clip"},
    {"camera/eye_nan", edit_eye_nan, BAD, "camera.eye[1]: "},
    {"camera/eye_inf", edit_eye_inf, BAD, "camera.eye[0]: inf is not finite"},
    {"camera/target_nan", edit_target_nan, BAD, "camera.target[2]: "},
    {"camera/target_is_eye", edit_target_is_eye, BAD, "camera.target: is the eye"},
    {"camera/up_nan", edit_up_nan, BAD, "camera.up[0]: "},
    {"camera/up_0", edit_up_0, BAD, "camera.up: (0, 0, 0)"},
    {"camera/up_along_the_line_of_sight", edit_up_along, BAD, "camera.up: lies along the line of sight"},
    {"camera/up_1e-8_off_the_line_of_sight", edit_up_nearly_along, BAD, "camera.up: lies along"},
    {"camera/eye_beyond_float", edit_eye_out_of_range, BAD, "camera: its world_to_view"},
};

static void transform(const float *m, const double *in, double *out)
{
    int r, c;
    for (r = 0; r < 4; ++r) {
        out[r] = 0;
        for (c = 0; c < 4; ++c) out[r] += (double)m[4 * c + r] * in[c];
    }
}

/* The view is rigid, right-handed and finite. It maps the eye to the origin and the target to -Z; up stays up. */
static void check_rigid(const char *name, const shd_camera *camera, const shd_view *view)
{
    const float *m = view->world_to_view;
    double eye[4], target[4], up[4], scale = 0, to_target = 0;
    int a, b, k;
    for (a = 0; a < 16; ++a) assert_true(isfinite(m[a]) && isfinite(view->view_to_clip[a]));
    for (a = 0; a < 3; ++a) {
        for (b = 0; b < 3; ++b) {
            double sum = 0;
            for (k = 0; k < 3; ++k) sum += (double)m[4 * k + a] * m[4 * k + b];
            shd_assert_close(name, (size_t)(3 * a + b), sum, a == b, 3e-7, 0);
        }
    }
    shd_assert_close(name, 9,
                     (double)m[0] * ((double)m[5] * m[10] - (double)m[9] * m[6]) -
                         (double)m[4] * ((double)m[1] * m[10] - (double)m[9] * m[2]) +
                         (double)m[8] * ((double)m[1] * m[6] - (double)m[5] * m[2]),
                     1, 5e-7, 0);
    assert_true(m[3] == 0 && m[7] == 0 && m[11] == 0 && m[15] == 1);
    for (a = 0; a < 3; ++a) {
        eye[a] = camera->eye[a];
        target[a] = camera->target[a];
        up[a] = camera->up[a];
        scale += fabs(eye[a]) + fabs(target[a]);
        to_target += (target[a] - eye[a]) * (target[a] - eye[a]);
        assert_true(view->eye[a] == camera->eye[a]);
    }
    eye[3] = target[3] = 1;
    up[3] = 0;
    {
        double at[4], ahead[4], above[4];
        transform(m, eye, at);
        transform(m, target, ahead);
        transform(m, up, above);
        for (a = 0; a < 3; ++a) shd_assert_close(name, (size_t)(10 + a), at[a], 0, 3e-7 * scale, 0);
        for (a = 0; a < 2; ++a) shd_assert_close(name, (size_t)(20 + a), ahead[a], 0, 3e-7 * scale, 0);
        shd_assert_close(name, 22, ahead[2], -sqrt(to_target), 3e-7 * scale, 0);
        assert_true(above[1] > 0);
    }
}

/* Corners of the frustum are mapped to the corners of clip space. */
static void check_projection(const char *name, const shd_camera *camera, const shd_view *view)
{
    const double tangent = tan(0.5 * (double)camera->fov_y);
    int i;
    for (i = 0; i < 2; ++i) {
        const double distance = i ? camera->far_plane : camera->near_plane;
        const double corner[4] = {distance * tangent * (camera->aspect != 0 ? camera->aspect : 1), distance * tangent,
                                  -distance, 1};
        double clip[4];
        transform(view->view_to_clip, corner, clip);
        shd_assert_close(name, (size_t)(30 + 4 * i), clip[0] / clip[3], 1, 3e-7, 0);
        shd_assert_close(name, (size_t)(31 + 4 * i), clip[1] / clip[3], 1, 3e-7, 0);
        /* depth carries the rounding of two float coefficients of size far / (far - near) */
        shd_assert_close(name, (size_t)(32 + 4 * i), clip[2] / clip[3], i,
                         1.5e-7 * camera->far_plane / ((double)camera->far_plane - camera->near_plane), 0);
        shd_assert_close(name, (size_t)(33 + 4 * i), clip[3], distance, 0, 0);
    }
    shd_assert_close(name, 40, view->view_to_clip[5], 1 / tangent, 0, 1e-7);
}

static void test_camera(void **state)
{
    const struct camera_case *c = (const struct camera_case *)*state;
    shd_camera camera = shd_camera_default();
    shd_view view, zero;
    memset(&view, 0xff, sizeof view);
    memset(&zero, 0, sizeof zero);
    c->edit(&camera);
    shd_assert_result(c->name, shd_view_from_camera(&camera, &view), c->expected, c->message);
    if (c->expected == SHD_OK) {
        check_rigid(c->name, &camera, &view);
        check_projection(c->name, &camera, &view);
    } else {
        assert_memory_equal(&view, &zero, sizeof view);
    }
}

static void test_null(void **state)
{
    shd_camera camera = shd_camera_default();
    shd_view view, zero;
    (void)state;
    memset(&view, 0xff, sizeof view);
    memset(&zero, 0, sizeof zero);
    shd_assert_result("camera", shd_view_from_camera(NULL, &view), BAD, "camera: NULL");
    assert_memory_equal(&view, &zero, sizeof view);
    shd_assert_result("view", shd_view_from_camera(&camera, NULL), BAD, "out_view: NULL");
}

/* Many cameras, every angle of view: the focal length differs from the correctly rounded one by at most one ulp. */
static void test_sweep(void **state)
{
    int i;
    (void)state;
    for (i = 1; i < 4096; ++i) {
        shd_camera camera = shd_camera_default();
        shd_view view;
        camera.fov_y = (float)(k_pi * i / 4096);
        set3(camera.eye, (float)sin(i), (float)cos(i * 0.7), (float)sin(i * 0.3) + 2);
        shd_assert_ok(shd_view_from_camera(&camera, &view));
        shd_assert_close("focal", (size_t)i, view.view_to_clip[5], 1 / tan(0.5 * (double)camera.fov_y), 0, 6e-8);
        check_rigid("sweep", &camera, &view);
    }
}

/* The bits of one oblique camera: every machine and compiler must give them. */
static void test_bits(void **state)
{
    shd_camera camera = shd_camera_default();
    struct {
        shd_view view;
        uint32_t zero; /* hashed too */
    } bits;
    (void)state;
    memset(&bits, 0, sizeof bits);
    edit_oblique(&camera);
    shd_assert_ok(shd_view_from_camera(&camera, &bits.view));
    assert_int_equal(shd_hash(SHD_HASH_START, &bits, sizeof bits), 0x6e74224b1922b5dfull);
}

struct box_case {
    const char *name;
    float low[3], high[3];
    void (*edit)(shd_camera *camera);
    shd_result expected;
    const char *message;
};

static void edit_wide(shd_camera *c) { c->aspect = 3; }
static void edit_tall(shd_camera *c)
{
    edit_oblique(c);
    c->aspect = 0.25f;
}
static void edit_nearly_pi(shd_camera *c) { c->fov_y = 3.1f; }

static const struct box_case k_boxes[] = {
    {"box/cube", {-1, -1, -1}, {1, 1, 1}, edit_nothing, SHD_OK, ""},
    {"box/wide_picture", {-1, -2, 5}, {3, 4, 6}, edit_wide, SHD_OK, ""},
    {"box/tall_picture", {-1, -2, 5}, {3, 4, 6}, edit_tall, SHD_OK, ""},
    {"box/oblique", {100, 200, -300}, {101, 207, -290}, edit_oblique, SHD_OK, ""},
    {"box/wide_angle", {0, 0, 0}, {1, 1, 1}, edit_nearly_pi, SHD_OK, ""},
    {"box/flat", {-1, 0, -1}, {1, 0, 1}, edit_nothing, SHD_OK, ""},
    {"box/line_of_sight", {0, 0, -1}, {0, 0, 1}, edit_nothing, SHD_OK, ""},
    {"box/line", {0, 0, 0}, {0, 7, 0}, edit_oblique, SHD_OK, ""},
    {"box/1e-30", {0, 0, 0}, {1e-30f, 1e-30f, 1e-30f}, edit_oblique, SHD_OK, ""},
    {"box/1e37", {-1e37f, -1e37f, 0}, {1e37f, 1e37f, 1e37f}, edit_oblique, SHD_OK, ""},
    {"box/point", {3, 4, 5}, {3, 4, 5}, edit_nothing, BAD, "bounds_max: is bounds_min"},
    {"box/reversed", {0, 2, 0}, {1, 1, 1}, edit_nothing, BAD, "bounds_max[1]: 1 is below bounds_min[1], 2"},
    {"box/nan", {0, 0, (float)NAN}, {1, 1, 1}, edit_nothing, BAD, "bounds_min[2]: "},
    {"box/inf", {0, 0, 0}, {1, INFINITY, 1}, edit_nothing, BAD, "bounds_max[1]: inf is not finite"},
    {"box/lost_in_rounding", {1e8f, 1e8f, 1e8f}, {1.00000008e8f, 1e8f, 1e8f}, edit_nothing, BAD, "bounds_max: the box"},
    {"box/largest", {-3e38f, -3e38f, -3e38f}, {3e38f, 3e38f, 3e38f}, edit_nothing, BAD, "bounds_max: the box"},
    {"box/no_camera", {0, 0, 0}, {1, 1, 1}, edit_target_is_eye, BAD, "camera.target: is the eye"},
    {"box/no_lens", {0, 0, 0}, {1, 1, 1}, edit_fov_pi, BAD, "camera.fov_y: 3.14159"},
};

/* The corners of the box in the view of the camera lie in the picture and between the planes. From a place without the
 * margin of 4 %, the outermost one lies on the edge. The floats of the camera are 1e-7 of its place away. */
static void check_framed(const struct box_case *c, const shd_camera *camera, const shd_view *view)
{
    double outermost = 0, edge = 0, size = 0, distance = 0, slack;
    int corner, axis;
    for (axis = 0; axis < 3; ++axis) size += (double)c->high[axis] - c->low[axis];
    slack = 1e-6 * (fabs((double)camera->eye[0]) + fabs((double)camera->eye[1]) + fabs((double)camera->eye[2])) / size;
    for (axis = 0; axis < 3; ++axis) distance += pow((double)camera->eye[axis] - camera->target[axis], 2);
    distance = sqrt(distance);
    for (corner = 0; corner < 8; ++corner) {
        double at[4], seen[4], clip[4];
        for (axis = 0; axis < 3; ++axis) at[axis] = (corner >> axis & 1) ? c->high[axis] : c->low[axis];
        at[3] = 1;
        transform(view->world_to_view, at, seen);
        transform(view->view_to_clip, seen, clip);
        assert_true(-seen[2] >= camera->near_plane * (1 - slack) && -seen[2] <= camera->far_plane * (1 + slack));
        outermost = fmax(outermost, fmax(fabs(clip[0]), fabs(clip[1])) / clip[3]);
        seen[2] += distance * (1 - 1 / 1.04);
        transform(view->view_to_clip, seen, clip);
        edge = fmax(edge, fmax(fabs(clip[0]), fabs(clip[1])) / clip[3]);
    }
    assert_true(outermost < 1);
    if (strcmp(c->name, "box/line_of_sight") != 0) shd_assert_close(c->name, 50, edge, 1, 1e-4 + 50 * slack, 0);
}

static void test_box(void **state)
{
    const struct box_case *c = (const struct box_case *)*state;
    shd_camera camera = shd_camera_default(), before;
    shd_view view, first;
    int axis;
    c->edit(&camera);
    before = camera;
    shd_assert_result(c->name, shd_camera_frame_box(&camera, c->low, c->high), c->expected, c->message);
    if (c->expected != SHD_OK) {
        assert_memory_equal(&camera, &before, sizeof camera);
        return;
    }
    shd_assert_ok(shd_view_from_camera(&before, &first));
    shd_assert_ok(shd_view_from_camera(&camera, &view));
    for (axis = 0; axis < 11; ++axis) {
        shd_assert_close(c->name, (size_t)axis, view.world_to_view[axis], first.world_to_view[axis], 2e-5, 0);
    }
    assert_true(camera.fov_y == before.fov_y && camera.aspect == before.aspect);
    assert_memory_equal(camera.up, before.up, sizeof camera.up);
    check_framed(c, &camera, &view);
}

/* The distance of a cube of side 2 that is seen along an axis: its nearer face is 1 from the centre, and 45 degrees of
 * view hold half of its side at a distance of 1 / tan(22.5 degrees). */
static void test_known_distance(void **state)
{
    const float low[3] = {4, 5, 6}, high[3] = {6, 7, 8};
    shd_camera camera = shd_camera_default();
    (void)state;
    camera.fov_y = (float)(k_pi / 4);
    shd_assert_ok(shd_camera_frame_box(&camera, low, high));
    shd_assert_close("distance", 0, camera.eye[2] - 7, 1.04 * (1 + 1 / tan(k_pi / 8)), 0, 1e-6);
    shd_assert_close("x", 0, camera.eye[0], 5, 0, 0);
    shd_assert_close("y", 0, camera.eye[1], 6, 0, 0);
    shd_assert_close("far", 0, camera.far_plane, camera.eye[2] - 7 + 1.01 * sqrt(3), 0, 1e-6);
    shd_assert_close("near", 0, camera.near_plane, camera.eye[2] - 7 - 1.01 * sqrt(3), 0, 1e-6);
}

static void test_box_null(void **state)
{
    const float low[3] = {0, 0, 0}, high[3] = {1, 1, 1};
    shd_camera camera = shd_camera_default();
    (void)state;
    shd_assert_result("camera", shd_camera_frame_box(NULL, low, high), BAD, "camera: NULL");
    shd_assert_result("low", shd_camera_frame_box(&camera, NULL, high), BAD, "bounds_min: NULL");
    shd_assert_result("high", shd_camera_frame_box(&camera, low, NULL), BAD, "bounds_max: NULL");
}

#define COUNT(table) (sizeof(table) / sizeof(table)[0])

int main(void)
{
    static struct CMUnitTest tests[COUNT(k_cameras) + COUNT(k_boxes) + 5];
    size_t n = 0, i;
    for (i = 0; i < COUNT(k_cameras); ++i) {
        tests[n++] = (struct CMUnitTest){k_cameras[i].name, test_camera, NULL, NULL, (void *)&k_cameras[i]};
    }
    for (i = 0; i < COUNT(k_boxes); ++i) {
        tests[n++] = (struct CMUnitTest){k_boxes[i].name, test_box, NULL, NULL, (void *)&k_boxes[i]};
    }
    tests[n++] = (struct CMUnitTest){"box/known_distance", test_known_distance, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"box/null_arguments", test_box_null, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"null_arguments", test_null, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"sweep_4095", test_sweep, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"bits", test_bits, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.view", tests, n, NULL, NULL);
}
