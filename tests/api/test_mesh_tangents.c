/* SPDX-License-Identifier: MIT */
/* SHD_MESH_TANGENTS through the API: computed tangents, tangents of degenerate input, added vertices, and reading
 * columns back. */
#include "support/fault_allocator.h"

#include <shd/mesh.h>

#define BAD SHD_ERROR_INVALID_ARGUMENT
enum { WIDE = 5, VERTICES = 2 * WIDE, TRIANGLES = 2 * (WIDE - 1), MORE = VERTICES + 8 };

static const float k_nan = (float)NAN;
static shd_context *g_context;

/* A strip of four squares side by side in the plane z = 0, facing +z; u right, v down. */
struct strip {
    shd_f32_in attributes[4];
    float p[3][VERTICES], n[3][VERTICES], uv[2][VERTICES], t[4][VERTICES], a[VERTICES];
    uint32_t indices[3 * TRIANGLES];
    shd_mesh_desc desc;
};

static void make_strip(struct strip *s)
{
    uint32_t i, c;
    memset(s, 0, sizeof *s);
    s->desc = shd_mesh_desc_default();
    for (i = 0; i < VERTICES; ++i) {
        s->p[0][i] = (float)(i % WIDE);
        s->p[1][i] = (float)(i / WIDE);
        s->n[2][i] = 1;
        s->uv[0][i] = s->p[0][i] / (WIDE - 1);
        s->uv[1][i] = 1 - s->p[1][i];
        s->a[i] = 10 + (float)i;
    }
    for (i = 0; i + 1 < WIDE; ++i) {
        const uint32_t quad[6] = {i, i + 1, i + 1 + WIDE, i, i + 1 + WIDE, i + WIDE};
        memcpy(s->indices + 6 * i, quad, sizeof quad);
    }
    s->desc.vertex_count = VERTICES;
    s->desc.indices.data = s->indices;
    s->desc.index_count = 3 * TRIANGLES;
    s->desc.flags = SHD_MESH_TANGENTS;
    for (c = 0; c < 3; ++c) s->desc.position[c].data = s->p[c];
    for (c = 0; c < 3; ++c) s->desc.normal[c].data = s->n[c];
    for (c = 0; c < 2; ++c) s->desc.uv[c].data = s->uv[c];
    for (c = 0; c < 2; ++c) s->desc.uv1[c].data = s->uv[1 - c];
    s->attributes[3].data = s->a;
    s->desc.attributes = s->attributes;
    s->desc.attribute_count = 4;
}

static void as_it_is(struct strip *s) { (void)s; }
static void mirrored(struct strip *s)
{
    int i;
    for (i = 0; i < VERTICES; ++i) s->uv[0][i] = 1 - s->uv[0][i];
}
static void mirrored_right(struct strip *s)
{
    int i;
    for (i = 0; i < VERTICES; ++i) s->uv[0][i] = (float)fabs((double)s->p[0][i] - 2);
}
static void no_uv(struct strip *s) { s->desc.uv[0].data = s->desc.uv[1].data = NULL; }
static void uv_zero(struct strip *s) { memset(s->uv, 0, sizeof s->uv); }
static void uv_constant_u(struct strip *s) { memset(s->uv[0], 0, sizeof s->uv[0]); }
static void uv_nan(struct strip *s)
{
    int i;
    for (i = 0; i < VERTICES; ++i) s->uv[0][i] = s->uv[1][i] = k_nan;
}
static void uv_inf_of_one(struct strip *s) { s->uv[0][WIDE] = (float)INFINITY; }
static void uv_flt_max(struct strip *s)
{
    int i;
    for (i = 0; i < VERTICES; ++i) s->uv[0][i] *= 3e38f;
}
static void degenerate_end(struct strip *s)
{
    s->uv[0][4] = s->uv[0][9] = s->uv[0][3] = s->uv[0][8] = 0.5f;
    s->uv[1][4] = s->uv[1][9] = s->uv[1][3] = s->uv[1][8] = 0.5f;
}
static void normal_zero(struct strip *s) { memset(s->n, 0, sizeof s->n); }
static void normal_nan(struct strip *s) { s->n[1][0] = s->n[2][WIDE] = k_nan; }
static void normal_computed(struct strip *s)
{
    s->desc.normal[0].data = s->desc.normal[1].data = s->desc.normal[2].data = NULL;
}
static void no_triangles(struct strip *s) { s->desc.index_count = 0; }
static void one_place(struct strip *s) { memset(s->p, 0, sizeof s->p); }
static void empty(struct strip *s)
{
    s->desc = shd_mesh_desc_default();
    s->desc.flags = SHD_MESH_TANGENTS;
}
static void given(struct strip *s)
{
    int i;
    for (i = 0; i < VERTICES; ++i) s->t[1][i] = 2, s->t[3][i] = -1;
    for (i = 0; i < 4; ++i) s->desc.tangent[i].data = s->t[i];
}
static void given_nan(struct strip *s)
{
    given(s);
    s->t[2][0] = k_nan;
}
static void no_flag(struct strip *s) { s->desc.flags = 0; }
static void position_nan(struct strip *s)
{
    s->p[1][9] = k_nan;
    s->desc.flags |= SHD_MESH_KEEP_NONFINITE;
}

static const struct tangent_case {
    const char *name;
    void (*edit)(struct strip *s);
    uint32_t tangentless, split;
    float first[4]; /* tangent of the first vertex */
    float last[4];  /* tangent of the last vertex */
} k_cases[] = {
    {"upright", as_it_is, 0, 0, {1, 0, 0, 1}, {1, 0, 0, 1}},
    {"mirrored", mirrored, 0, 0, {-1, 0, 0, -1}, {-1, 0, 0, -1}},
    {"mirrored_right_half", mirrored_right, 0, 2, {-1, 0, 0, -1}, {1, 0, 0, 1}},
    {"uv_missing", no_uv, 10, 0, {1, 0, 0, 1}, {1, 0, 0, 1}},
    {"uv_all_0", uv_zero, 10, 0, {1, 0, 0, 1}, {1, 0, 0, 1}},
    {"uv_on_a_line", uv_constant_u, 10, 0, {1, 0, 0, 1}, {1, 0, 0, 1}},
    {"uv_nan", uv_nan, 10, 0, {1, 0, 0, 1}, {1, 0, 0, 1}},
    {"uv_inf_counts_as_0", uv_inf_of_one, 0, 0, {1, 0, 0, 1}, {1, 0, 0, 1}},
    {"uv_3e38", uv_flt_max, 0, 0, {1, 0, 0, 1}, {1, 0, 0, 1}},
    {"uv_degenerate_at_one_end", degenerate_end, 4, 0, {1, 0, 0, 1}, {1, 0, 0, 1}},
    {"normal_zero", normal_zero, 0, 0, {1, 0, 0, 1}, {1, 0, 0, 1}},
    {"normal_nan", normal_nan, 0, 0, {1, 0, 0, 1}, {1, 0, 0, 1}},
    {"normal_computed", normal_computed, 0, 0, {1, 0, 0, 1}, {1, 0, 0, 1}},
    {"no_triangles", no_triangles, 10, 0, {1, 0, 0, 1}, {1, 0, 0, 1}},
    {"all_in_one_place", one_place, 10, 0, {1, 0, 0, 1}, {1, 0, 0, 1}},
    {"empty", empty, 0, 0, {0, 0, 0, 0}, {0, 0, 0, 0}},
    {"given_stay_as_they_are", given, 0, 0, {0, 2, 0, -1}, {0, 2, 0, -1}},
    {"given_nan", given_nan, 0, 0, {0, 0, 0, -1}, {0, 2, 0, -1}},
    {"no_flag_no_tangents", no_flag, 0, 0, {0, 0, 0, 0}, {0, 0, 0, 0}},
    {"position_nan", position_nan, 2, 0, {1, 0, 0, 1}, {1, 0, 0, 1}},
};

static void read_tangents(const shd_mesh *mesh, float t[4][MORE])
{
    shd_f32_out out[4];
    int c;
    for (c = 0; c < 4; ++c) out[c] = (shd_f32_out){t[c], 0};
    shd_assert_ok(shd_mesh_read_tangents(mesh, out));
}

static void test_tangents(void **state)
{
    const struct tangent_case *c = (const struct tangent_case *)*state;
    static struct strip s;
    shd_mesh *mesh = NULL;
    shd_mesh_info info = shd_mesh_info_default();
    float t[4][MORE];
    uint32_t k, last;
    make_strip(&s);
    c->edit(&s);
    shd_assert_ok(shd_mesh_create(g_context, &s.desc, &mesh));
    shd_assert_ok(shd_mesh_get_info(mesh, &info));
    assert_int_equal(info.tangentless_count, c->tangentless);
    assert_int_equal(info.split_count, c->split);
    assert_int_equal(info.vertex_count, s.desc.vertex_count + c->split);
    read_tangents(mesh, t);
    last = info.vertex_count ? info.vertex_count - 1 : 0;
    for (k = 0; k < 4 && info.vertex_count; ++k) {
        shd_assert_close("first", k, t[k][0], c->first[k], 1e-6, 0);
        shd_assert_close("last", k, t[k][last], c->last[k], 1e-6, 0);
    }
    shd_mesh_release(mesh);
}

/* The two vertices that are added where mirrored faces meet have copies of every column, and only the mirrored faces
 * use them. */
static void test_split(void **state)
{
    static struct strip s;
    shd_mesh *mesh = NULL;
    float column[12][MORE];
    uint32_t indices[3 * TRIANGLES], i, c;
    shd_f32_out out[12];
    const shd_u32_out index_out = {indices, 0};
    static const uint32_t k_sources[2] = {2, 7};
    (void)state;
    make_strip(&s);
    mirrored_right(&s);
    shd_assert_ok(shd_mesh_create(g_context, &s.desc, &mesh));
    for (c = 0; c < 12; ++c) out[c] = (shd_f32_out){column[c], 0};
    shd_assert_ok(shd_mesh_read_positions(mesh, out));
    shd_assert_ok(shd_mesh_read_normals(mesh, out + 3));
    shd_assert_ok(shd_mesh_read_uv(mesh, out + 6));
    shd_assert_ok(shd_mesh_read_uv1(mesh, out + 8));
    shd_assert_ok(shd_mesh_read_attribute(mesh, 3, out + 10));
    shd_assert_ok(shd_mesh_read_attribute(mesh, 2, out + 11));
    for (i = 0; i < VERTICES + 2; ++i) {
        const uint32_t source = i < VERTICES ? i : k_sources[i - VERTICES];
        for (c = 0; c < 3; ++c) {
            assert_true(column[c][i] == s.p[c][source]);
            assert_true(column[3 + c][i] == s.n[c][source]);
        }
        for (c = 0; c < 2; ++c) {
            assert_true(column[6 + c][i] == s.uv[c][source]);
            assert_true(column[8 + c][i] == s.uv[1 - c][source]);
        }
        assert_true(column[10][i] == s.a[source] && column[11][i] == 0.0f);
    }
    shd_assert_ok(shd_mesh_read_indices(mesh, &index_out));
    for (i = 0; i < 3 * TRIANGLES; ++i) {
        const uint32_t want = i < 12 || s.indices[i] % WIDE != 2 ? s.indices[i] : VERTICES + s.indices[i] / WIDE;
        assert_int_equal(indices[i], want);
    }
    shd_mesh_release(mesh);
}

static void test_bad_reads(void **state)
{
    static struct strip s;
    shd_mesh *mesh = NULL;
    float t[4][MORE];
    uint32_t indices[3 * TRIANGLES];
    shd_f32_out out[4] = {{t[0], 0}, {NULL, 0}, {NULL, 0}, {t[3], 2}};
    shd_u32_out index_out = {indices, 6};
    (void)state;
    make_strip(&s);
    shd_assert_ok(shd_mesh_create(g_context, &s.desc, &mesh));
    shd_assert_result("null", shd_mesh_read_tangents(NULL, out), BAD, "mesh: NULL");
    shd_assert_result("null", shd_mesh_read_positions(NULL, out), BAD, "mesh: NULL");
    shd_assert_result("null", shd_mesh_read_uv(NULL, out), BAD, "mesh: NULL");
    shd_assert_result("null", shd_mesh_read_uv1(NULL, out), BAD, "mesh: NULL");
    shd_assert_result("null", shd_mesh_read_attribute(NULL, 0, out), BAD, "mesh: NULL");
    shd_assert_result("null", shd_mesh_read_indices(NULL, &index_out), BAD, "mesh: NULL");
    shd_assert_result("out", shd_mesh_read_tangents(mesh, NULL), BAD, "out: NULL");
    shd_assert_result("out", shd_mesh_read_attribute(mesh, 0, NULL), BAD, "out: NULL");
    shd_assert_result("out", shd_mesh_read_indices(mesh, NULL), BAD, "out: NULL");
    t[0][0] = 77;
    shd_assert_result("stride", shd_mesh_read_tangents(mesh, out), BAD, "out[3].stride: 2");
    assert_true(t[0][0] == 77);
    shd_assert_result("stride", shd_mesh_read_indices(mesh, &index_out), BAD, "out.stride: 6");
    shd_assert_result("index", shd_mesh_read_attribute(mesh, 8, out), BAD, "index: 8 is not in 0..7");
    index_out.data = NULL;
    index_out.stride = 0;
    shd_assert_ok(shd_mesh_read_indices(mesh, &index_out)); /* nothing wanted */
    shd_mesh_release(mesh);
}

/* Every allocation fails in turn. */
static void test_out_of_memory(void **state)
{
    static struct strip s;
    shd_fault_allocator memory;
    shd_context_desc context_desc = shd_fault_context_desc(&memory);
    shd_context *context = NULL;
    shd_mesh *mesh = NULL;
    size_t n, before;
    (void)state;
    memset(&memory, 0, sizeof memory);
    make_strip(&s);
    mirrored_right(&s);
    shd_assert_ok(shd_context_create(&context_desc, &context));
    shd_assert_ok(shd_mesh_create(context, &s.desc, &mesh)); /* a slab of handles stays */
    shd_mesh_release(mesh);
    before = memory.live_bytes;
    for (n = 1;; ++n) {
        shd_result result;
        shd_fault_arm(&memory, n, 0);
        result = shd_mesh_create(context, &s.desc, &mesh);
        if (result == SHD_OK) break;
        shd_assert_result("create", result, SHD_ERROR_OUT_OF_MEMORY, "out of memory");
        assert_null(mesh);
        assert_int_equal(memory.live_bytes, before);
    }
    assert_true(n > 20);
    shd_mesh_release(mesh);
    shd_context_release(context);
    shd_assert_all_freed("out_of_memory", &memory);
}

#define COUNT(table) (sizeof(table) / sizeof(table)[0])

int main(void)
{
    static struct CMUnitTest tests[COUNT(k_cases) + 3];
    size_t n = 0, i;
    int failed;
    if (shd_context_create(NULL, &g_context) != SHD_OK) return 1;
    for (i = 0; i < COUNT(k_cases); ++i) {
        tests[n++] = (struct CMUnitTest){k_cases[i].name, test_tangents, NULL, NULL, (void *)&k_cases[i]};
    }
    tests[n++] = (struct CMUnitTest){"split", test_split, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"bad_reads", test_bad_reads, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"out_of_memory", test_out_of_memory, NULL, NULL, NULL};
    failed = _cmocka_run_group_tests("api.mesh_tangents", tests, n, NULL, NULL);
    shd_context_release(g_context);
    return failed;
}
