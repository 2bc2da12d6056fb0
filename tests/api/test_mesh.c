/* SPDX-License-Identifier: MIT */
/* Meshes: every field of the desc, columns of every layout, counts and bounds, normals. */
#include "support/check.h"

#include <shd/mesh.h>

static const float k_nan = (float)NAN;
static const float k_inf = (float)INFINITY;

static const float k_x[9] = {0, 1, 0, 0, 1, 0, 5, 6, 5};
static const float k_y[9] = {0, 0, 1, 0, 0, 1, -2, -2, -1};
static const float k_z[9] = {0, 0, 0, 3, 3, 3, 0, 0, 0};
static const uint32_t k_indices[9] = {0, 1, 2, 3, 4, 5, 6, 7, 8};
static const uint32_t k_index_12[9] = {0, 1, 2, 3, 4, 5, 6, 12, 8};
static const uint32_t k_index_max[3] = {0, 0xffffffffu, 2};
static const uint32_t k_index_equal[3] = {0, 1, 9};
static const float k_with_nan[9] = {0, 0, 1, (float)NAN, 0, 1, -2, -2, -1};
static const float k_with_minus_inf[9] = {0, 0, 1, 0, 0, 1, -2, -2, -INFINITY};
static const uint32_t k_repeated[6] = {0, 1, 2, 0, 0, 0};

/* Nine vertices, three triangles. */
static shd_mesh_desc nine(void)
{
    shd_mesh_desc desc = shd_mesh_desc_default();
    desc.vertex_count = 9;
    desc.position[0].data = k_x;
    desc.position[1].data = k_y;
    desc.position[2].data = k_z;
    return desc;
}

static void edit_nothing(shd_mesh_desc *d) { (void)d; }
static void edit_size_zero(shd_mesh_desc *d) { d->struct_size = 0; }
static void edit_empty(shd_mesh_desc *d) { *d = shd_mesh_desc_default(); }
static void edit_empty_with_index(shd_mesh_desc *d)
{
    edit_empty(d);
    d->indices.data = k_indices;
    d->index_count = 3;
}
static void edit_no_triangles(shd_mesh_desc *d) { d->indices.data = k_indices; }
static void edit_vertices_max(shd_mesh_desc *d) { d->vertex_count = 0xffffffffu; }
static void edit_vertices_above(shd_mesh_desc *d) { d->vertex_count = (1u << 28) + 1; }
static void edit_vertices_8(shd_mesh_desc *d) { d->vertex_count = 8; }
static void edit_first_six(shd_mesh_desc *d) { d->index_count = 6; }
static void edit_twelve_unindexed(shd_mesh_desc *d) { d->index_count = 12; }
static void edit_indices(shd_mesh_desc *d)
{
    d->indices.data = k_indices;
    d->index_count = 9;
}
static void edit_indices_7(shd_mesh_desc *d)
{
    d->indices.data = k_indices;
    d->index_count = 7;
}
static void edit_index_12(shd_mesh_desc *d)
{
    d->indices.data = k_index_12;
    d->index_count = 9;
}
static void edit_index_max(shd_mesh_desc *d)
{
    d->indices.data = k_index_max;
    d->index_count = 3;
}
static void edit_index_equal(shd_mesh_desc *d)
{
    d->indices.data = k_index_equal;
    d->index_count = 3;
}
static void edit_index_repeated(shd_mesh_desc *d)
{
    d->indices.data = k_repeated;
    d->index_count = 6;
}
static void edit_index_count_above(shd_mesh_desc *d)
{
    d->indices.data = k_indices;
    d->index_count = ((size_t)3 << 28) + 3;
}
static void edit_index_count_max(shd_mesh_desc *d)
{
    d->indices.data = k_indices;
    d->index_count = SIZE_MAX;
}
static void edit_index_stride_odd(shd_mesh_desc *d)
{
    edit_indices(d);
    d->indices.stride = 6;
}
static void edit_index_stride_huge(shd_mesh_desc *d)
{
    edit_indices(d);
    d->indices.stride = SIZE_MAX - 3;
}
static void edit_index_misaligned(shd_mesh_desc *d)
{
    edit_indices(d);
    d->indices.data = (const uint32_t *)(const void *)((const char *)k_indices + 1);
}
static void edit_index_zero_stride_wide(shd_mesh_desc *d)
{
    d->indices.data = k_indices;
    d->indices.stride = 12; /* 0, 3, 6 */
    d->index_count = 3;
}
static void edit_no_x(shd_mesh_desc *d) { d->position[0].data = NULL; }
static void edit_no_z(shd_mesh_desc *d) { d->position[2].data = NULL; }
static void edit_nan(shd_mesh_desc *d) { d->position[1].data = k_with_nan; }
static void edit_minus_inf(shd_mesh_desc *d) { d->position[2].data = k_with_minus_inf; }
static void edit_keep_nan(shd_mesh_desc *d)
{
    d->position[1].data = k_with_nan;
    d->flags = SHD_MESH_KEEP_NONFINITE;
}
static void edit_stride_2(shd_mesh_desc *d) { d->position[0].stride = 2; }
static void edit_stride_huge(shd_mesh_desc *d) { d->position[1].stride = SIZE_MAX / 4 + 1; }
static void edit_misaligned(shd_mesh_desc *d)
{
    d->position[2].data = (const float *)(const void *)((const char *)k_z + 2);
}
static void edit_flags(shd_mesh_desc *d) { d->flags = 0x80000008u; }
static void edit_weight(shd_mesh_desc *d) { d->normal_weight = (shd_normal_weight)3; }
static void edit_weight_negative(shd_mesh_desc *d) { d->normal_weight = (shd_normal_weight)-1; }
static void edit_half_normal(shd_mesh_desc *d) { d->normal[1].data = k_y; }
static void edit_two_normals(shd_mesh_desc *d) { d->normal[0].data = d->normal[1].data = k_x; }
static void edit_half_uv(shd_mesh_desc *d) { d->uv[0].data = k_x; }
static void edit_half_tangent(shd_mesh_desc *d) { d->tangent[0].data = d->tangent[1].data = d->tangent[2].data = k_x; }
static void edit_normal_stride(shd_mesh_desc *d)
{
    d->normal[0].data = d->normal[1].data = d->normal[2].data = k_x;
    d->normal[2].stride = 5;
}
static void edit_everything(shd_mesh_desc *d)
{
    int c;
    edit_indices(d);
    for (c = 0; c < 3; ++c) d->normal[c].data = k_x;
    for (c = 0; c < 2; ++c) d->uv[c].data = k_with_nan;
    for (c = 0; c < 4; ++c) d->tangent[c].data = k_with_minus_inf;
}

struct create_case {
    const char *name;
    void (*edit)(shd_mesh_desc *desc);
    shd_result expected;
    const char *message;
    uint32_t vertices, triangles, normalless, nonfinite;
};

#define BAD SHD_ERROR_INVALID_ARGUMENT
static const struct create_case k_create[] = {
    {"create/unindexed_9", edit_nothing, SHD_OK, "", 9, 3, 0, 0},
    {"create/indexed_9", edit_indices, SHD_OK, "", 9, 3, 0, 0},
    {"create/unindexed_first_6", edit_first_six, SHD_OK, "", 9, 2, 3, 0},
    {"create/empty", edit_empty, SHD_OK, "", 0, 0, 0, 0},
    {"create/vertices_without_triangles", edit_no_triangles, SHD_OK, "", 9, 0, 9, 0},
    {"create/index_stride_12", edit_index_zero_stride_wide, SHD_OK, "", 9, 1, 6, 0},
    {"create/degenerate_triangle", edit_index_repeated, SHD_OK, "", 9, 2, 6, 0},
    {"create/every_column_with_nonfinite", edit_everything, SHD_OK, "", 9, 3, 4, 0},
    {"create/keep_nan", edit_keep_nan, SHD_OK, "", 9, 3, 3, 1},
    {"create/struct_size_0", edit_size_zero, BAD, "mesh.struct_size: 0", 0, 0, 0, 0},
    {"create/vertex_count_uint32_max", edit_vertices_max, BAD, "mesh.vertex_count: 4294967295 is not in 0..268435456",
     0, 0, 0, 0},
    {"create/vertex_count_above", edit_vertices_above, BAD, "mesh.vertex_count: 268435457", 0, 0, 0, 0},
    {"create/vertex_count_8_unindexed", edit_vertices_8, BAD,
     "mesh.vertex_count without indices: 8 is not a multiple of 3", 0, 0, 0, 0},
    {"create/index_count_12_unindexed", edit_twelve_unindexed, BAD,
     "mesh.index_count without indices: 12 is not in 0..9", 0, 0, 0, 0},
    {"create/index_count_7", edit_indices_7, BAD, "mesh.index_count: 7 is not a multiple of 3", 0, 0, 0, 0},
    {"create/index_count_above", edit_index_count_above, BAD, "mesh.index_count: 805306371", 0, 0, 0, 0},
    {"create/index_count_size_max", edit_index_count_max, BAD, "mesh.index_count: ", 0, 0, 0, 0},
    {"create/index_12_of_9", edit_index_12, BAD, "mesh.indices[7]: 12 is not below vertex_count 9", 0, 0, 0, 0},
    {"create/index_uint32_max", edit_index_max, BAD, "mesh.indices[1]: 4294967295 is not below vertex_count 9", 0, 0, 0,
     0},
    {"create/index_9_of_9", edit_index_equal, BAD, "mesh.indices[2]: 9 is not below vertex_count 9", 0, 0, 0, 0},
    {"create/index_of_nothing", edit_empty_with_index, BAD, "mesh.indices[0]: 0 is not below vertex_count 0", 0, 0, 0,
     0},
    {"create/index_stride_6", edit_index_stride_odd, BAD, "mesh.indices.stride: 6", 0, 0, 0, 0},
    {"create/index_stride_overflow", edit_index_stride_huge, BAD, "mesh.indices: 9 elements of stride", 0, 0, 0, 0},
    {"create/index_misaligned", edit_index_misaligned, BAD, "mesh.indices.data: not aligned", 0, 0, 0, 0},
    {"create/no_x", edit_no_x, BAD, "mesh.position[0].data: NULL", 0, 0, 0, 0},
    {"create/no_z", edit_no_z, BAD, "mesh.position[2].data: NULL", 0, 0, 0, 0},
    {"create/nan_y_3", edit_nan, BAD, "mesh.position[1][3]: nan is not finite", 0, 0, 0, 0},
    {"create/minus_inf_z_8", edit_minus_inf, BAD, "mesh.position[2][8]: -inf is not finite", 0, 0, 0, 0},
    {"create/position_stride_2", edit_stride_2, BAD, "mesh.position[0].stride: 2 is not a multiple of 4", 0, 0, 0, 0},
    {"create/position_stride_overflow", edit_stride_huge, BAD, "mesh.position[1]: 9 elements of stride", 0, 0, 0, 0},
    {"create/position_misaligned", edit_misaligned, BAD, "mesh.position[2].data: not aligned", 0, 0, 0, 0},
    {"create/flags_unknown", edit_flags, SHD_ERROR_UNSUPPORTED, "mesh.flags: bits 0x80000008", 0, 0, 0, 0},
    {"create/normal_weight_3", edit_weight, BAD, "mesh.normal_weight: 3 is not in 0..2", 0, 0, 0, 0},
    {"create/normal_weight_negative", edit_weight_negative, BAD, "mesh.normal_weight: ", 0, 0, 0, 0},
    {"create/normal_y_only", edit_half_normal, BAD, "mesh.normal[0].data: NULL", 0, 0, 0, 0},
    {"create/normal_without_z", edit_two_normals, BAD, "mesh.normal[2].data: NULL, but another column is set", 0, 0, 0,
     0},
    {"create/u_without_v", edit_half_uv, BAD, "mesh.uv[1].data: NULL, but another column is set; all 2 or none", 0, 0,
     0, 0},
    {"create/tangent_without_handedness", edit_half_tangent, BAD, "mesh.tangent[3].data: NULL", 0, 0, 0, 0},
    {"create/normal_stride_5", edit_normal_stride, BAD, "mesh.normal[2].stride: 5", 0, 0, 0, 0},
};

static shd_context *g_context;

static void test_create(void **state)
{
    const struct create_case *c = (const struct create_case *)*state;
    shd_mesh_desc desc = nine();
    shd_mesh *mesh = (shd_mesh *)&desc;
    shd_mesh_info info = shd_mesh_info_default();
    c->edit(&desc);
    shd_assert_result(c->name, shd_mesh_create(g_context, &desc, &mesh), c->expected, c->message);
    if (c->expected != SHD_OK) {
        assert_null(mesh);
        return;
    }
    shd_assert_ok(shd_mesh_get_info(mesh, &info));
    assert_int_equal(info.vertex_count, c->vertices);
    assert_int_equal(info.triangle_count, c->triangles);
    assert_int_equal(info.normalless_count, c->normalless);
    assert_int_equal(info.nonfinite_count, c->nonfinite);
    shd_mesh_release(mesh);
}

static void test_null(void **state)
{
    shd_mesh *mesh = (shd_mesh *)&g_context;
    shd_mesh_info info, zero;
    shd_f32_out out[3] = {{NULL, 0}, {NULL, 0}, {NULL, 0}};
    shd_mesh_desc desc = nine();
    (void)state;
    memset(&info, 0x55, sizeof info);
    memset(&zero, 0, sizeof zero); /* the padding, too */
    info.struct_size = zero.struct_size = sizeof info;
    shd_assert_result("desc", shd_mesh_create(g_context, NULL, &mesh), BAD, "mesh: NULL");
    assert_null(mesh);
    shd_assert_result("info", shd_mesh_get_info(NULL, &info), BAD, "mesh: NULL");
    assert_memory_equal(&info, &zero, sizeof info);
    shd_assert_result("normals", shd_mesh_read_normals(NULL, out), BAD, "mesh: NULL");
    shd_assert_ok(shd_mesh_create(g_context, &desc, &mesh));
    shd_assert_result("out_info", shd_mesh_get_info(mesh, NULL), BAD, "out_info: NULL");
    shd_assert_result("out", shd_mesh_read_normals(mesh, NULL), BAD, "out: NULL");
    shd_assert_ok(shd_mesh_read_normals(mesh, out)); /* nothing wanted */
    shd_mesh_release(mesh);
}

static void test_bounds(void **state)
{
    static const float k_far[9] = {0, 1, 0, 0, 1, 0, 3e38f, 6, -3e38f};
    shd_mesh_desc desc = nine();
    shd_mesh *mesh = NULL;
    shd_mesh_info info = shd_mesh_info_default();
    (void)state;
    desc.position[0].data = k_far;
    desc.position[1].data = k_with_nan; /* vertex 3 is not part of the bounds */
    desc.flags = SHD_MESH_KEEP_NONFINITE;
    shd_assert_ok(shd_mesh_create(g_context, &desc, &mesh));
    shd_assert_ok(shd_mesh_get_info(mesh, &info));
    assert_true(info.bounds_min[0] == -3e38f && info.bounds_max[0] == 3e38f);
    assert_true(info.bounds_min[1] == -2.0f && info.bounds_max[1] == 1.0f);
    assert_true(info.bounds_min[2] == 0.0f && info.bounds_max[2] == 3.0f);
    shd_mesh_release(mesh);
}

static void test_bounds_of_nothing_finite(void **state)
{
    const float all[3] = {k_nan, k_inf, -k_inf};
    shd_mesh_desc desc = shd_mesh_desc_default();
    shd_mesh *mesh = NULL;
    shd_mesh_info info = shd_mesh_info_default();
    int c;
    (void)state;
    desc.vertex_count = 3;
    for (c = 0; c < 3; ++c) desc.position[c].data = all;
    desc.flags = SHD_MESH_KEEP_NONFINITE;
    shd_assert_ok(shd_mesh_create(g_context, &desc, &mesh));
    shd_assert_ok(shd_mesh_get_info(mesh, &info));
    assert_int_equal(info.nonfinite_count, 3);
    assert_int_equal(info.normalless_count, 3);
    for (c = 0; c < 3; ++c) assert_true(info.bounds_min[c] == 0.0f && info.bounds_max[c] == 0.0f);
    shd_mesh_release(mesh);
}

/* Interleaved records, packed columns and reversed memory order give the same mesh. */
struct vertex {
    float position[3];
    uint32_t tag;
    float normal[3];
    float uv[2];
};

static uint64_t hash_normals(const shd_mesh *mesh, uint32_t count, size_t stride_floats)
{
    static float buffer[3 * 64 * 8];
    shd_f32_out out[3];
    uint64_t hash = SHD_HASH_START;
    uint32_t i;
    int c;
    for (c = 0; c < 3; ++c) {
        out[c].data = buffer + (stride_floats == 1 ? (size_t)c * count : (size_t)c);
        out[c].stride = stride_floats * sizeof(float);
    }
    for (i = 0; i < sizeof buffer / sizeof buffer[0]; ++i) buffer[i] = 777.0f;
    shd_assert_ok(shd_mesh_read_normals(mesh, out));
    for (i = 0; i < count; ++i) {
        for (c = 0; c < 3; ++c) hash = shd_hash(hash, out[c].data + i * stride_floats, sizeof(float));
    }
    if (stride_floats == 8) { /* floats between the elements do not change */
        for (i = 0; i < count; ++i) assert_true(buffer[8 * i + 3] == 777.0f && buffer[8 * i + 7] == 777.0f);
        assert_true(buffer[8 * count] == 777.0f);
    }
    return hash;
}

static void test_layouts(void **state)
{
    struct vertex records[9];
    float columns[8][9];
    shd_mesh_desc soa = nine(), aos = nine();
    shd_mesh *a = NULL, *b = NULL;
    int i, c, given;
    (void)state;
    for (i = 0; i < 9; ++i) {
        const float position[3] = {k_x[i], k_y[i], k_z[i]};
        records[i].tag = 0xffffffffu;
        for (c = 0; c < 3; ++c) {
            records[i].position[c] = position[c];
            records[i].normal[c] = columns[c][i] = (float)(i * i - 3 * c + 1);
        }
        for (c = 0; c < 2; ++c) records[i].uv[c] = columns[3 + c][i] = 0.25f * (float)(i + c);
    }
    for (given = 0; given < 2; ++given) {
        for (c = 0; c < 3; ++c) {
            aos.position[c].data = &records[0].position[c];
            aos.position[c].stride = sizeof records[0];
            if (given) {
                aos.normal[c].data = &records[0].normal[c];
                aos.normal[c].stride = sizeof records[0];
                soa.normal[c].data = columns[c];
            }
        }
        for (c = 0; c < 2; ++c) {
            aos.uv[c].data = &records[0].uv[c];
            aos.uv[c].stride = sizeof records[0];
            soa.uv[c].data = columns[3 + c];
        }
        shd_assert_ok(shd_mesh_create(g_context, &soa, &a));
        shd_assert_ok(shd_mesh_create(g_context, &aos, &b));
        assert_true(hash_normals(a, 9, 1) == hash_normals(b, 9, 8));
        shd_mesh_release(a);
        shd_mesh_release(b);
    }
}

struct normal_case {
    const char *name;
    float given[3];
    double want[3];
    uint32_t normalless;
};
static const struct normal_case k_normals[] = {
    {"given_normal/unit", {0, 1, 0}, {0, 1, 0}, 0},
    {"given_normal/long", {3, 0, -4}, {0.6, 0, -0.8}, 0},
    {"given_normal/1e38", {1e38f, 1e38f, 0}, {0.70710678118654752, 0.70710678118654752, 0}, 0},
    {"given_normal/denormal", {0, -1e-44f, 0}, {0, -1, 0}, 0},
    {"given_normal/zero", {0, -0.0f, 0}, {0, 0, 1}, 1},
    {"given_normal/nan", {1, (float)NAN, 0}, {0, 0, 1}, 1},
    {"given_normal/inf", {1, 0, INFINITY}, {0, 0, 1}, 1},
};

static void test_given_normal(void **state)
{
    const struct normal_case *c = (const struct normal_case *)*state;
    const float p[3] = {0, 0, 0};
    float got[3];
    shd_f32_out out[3];
    shd_mesh_desc desc = shd_mesh_desc_default();
    shd_mesh *mesh = NULL;
    shd_mesh_info info = shd_mesh_info_default();
    const uint32_t none = 0;
    int i;
    desc.vertex_count = 1;
    desc.indices.data = &none;
    for (i = 0; i < 3; ++i) {
        desc.position[i].data = &p[i];
        desc.normal[i].data = &c->given[i];
        out[i].data = &got[i];
        out[i].stride = 0;
    }
    shd_assert_ok(shd_mesh_create(g_context, &desc, &mesh));
    shd_assert_ok(shd_mesh_read_normals(mesh, out));
    shd_assert_ok(shd_mesh_get_info(mesh, &info));
    for (i = 0; i < 3; ++i) shd_assert_close(c->name, (size_t)i, got[i], c->want[i], 1.5e-7, 0);
    assert_int_equal(info.normalless_count, c->normalless);
    shd_mesh_release(mesh);
}

static void test_bad_normal_columns(void **state)
{
    float buffer[16];
    shd_f32_out out[3] = {{NULL, 0}, {NULL, 0}, {NULL, 0}};
    shd_mesh_desc desc = nine();
    shd_mesh *mesh = NULL;
    (void)state;
    shd_assert_ok(shd_mesh_create(g_context, &desc, &mesh));
    out[1].data = buffer;
    out[1].stride = 3;
    shd_assert_result("stride", shd_mesh_read_normals(mesh, out), BAD, "out[1].stride: 3");
    out[1].stride = SIZE_MAX - 3;
    shd_assert_result("overflow", shd_mesh_read_normals(mesh, out), BAD, "out[1]: 9 elements");
    shd_mesh_release(mesh);
}

/* Everything is copied: the caller may free its memory immediately. */
static void test_copied(void **state)
{
    float x[3] = {0, 1, 0}, y[3] = {0, 0, 1}, z[3] = {0, 0, 0};
    shd_mesh_desc desc = shd_mesh_desc_default();
    shd_mesh *mesh = NULL;
    uint64_t before;
    (void)state;
    desc.vertex_count = 3;
    desc.position[0].data = x;
    desc.position[1].data = y;
    desc.position[2].data = z;
    shd_assert_ok(shd_mesh_create(g_context, &desc, &mesh));
    before = hash_normals(mesh, 3, 1);
    memset(x, 0xff, sizeof x);
    memset(y, 0xff, sizeof y);
    memset(z, 0xff, sizeof z);
    assert_true(hash_normals(mesh, 3, 1) == before);
    shd_mesh_release(mesh);
}

#define COUNT(table) (sizeof(table) / sizeof(table)[0])

int main(void)
{
    static struct CMUnitTest tests[COUNT(k_create) + COUNT(k_normals) + 8];
    size_t n = 0, i;
    int failed;
    if (shd_context_create(NULL, &g_context) != SHD_OK) return 1;
    for (i = 0; i < COUNT(k_create); ++i) {
        tests[n++] = (struct CMUnitTest){k_create[i].name, test_create, NULL, NULL, (void *)&k_create[i]};
    }
    for (i = 0; i < COUNT(k_normals); ++i) {
        tests[n++] = (struct CMUnitTest){k_normals[i].name, test_given_normal, NULL, NULL, (void *)&k_normals[i]};
    }
    tests[n++] = (struct CMUnitTest){"null_arguments", test_null, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"bounds", test_bounds, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"bounds_of_nothing_finite", test_bounds_of_nothing_finite, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"layouts", test_layouts, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"read_normals/bad_columns", test_bad_normal_columns, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"copied", test_copied, NULL, NULL, NULL};
    failed = _cmocka_run_group_tests("api.mesh", tests, n, NULL, NULL);
    shd_context_release(g_context);
    return failed;
}
