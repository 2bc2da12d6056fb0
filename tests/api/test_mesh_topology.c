/* SPDX-License-Identifier: MIT */
/* Strips, fans and 16-bit indices: the frame has the same bits as with separate triangles. */
#include "support/frame.h"
#include "support/noise.h"

enum { VERTICES = 12, MOST = 24 };

struct topology_case {
    const char *name;
    shd_topology topology;
    size_t count; /* indices */
    uint32_t indices[MOST];
    size_t triangles;
    uint32_t triples[3 * MOST];
};
#define R 0xffffffffu
#define STRIP SHD_TOPOLOGY_STRIP
#define FAN SHD_TOPOLOGY_FAN
static const struct topology_case k_cases[] = {
    {"triangles/2", SHD_TOPOLOGY_TRIANGLES, 6, {0, 1, 2, 5, 4, 3}, 2, {0, 1, 2, 5, 4, 3}},
    {"strip/0", STRIP, 0, {0}, 0, {0}},
    {"strip/1", STRIP, 1, {0}, 0, {0}},
    {"strip/2", STRIP, 2, {0, 1}, 0, {0}},
    {"strip/3", STRIP, 3, {0, 1, 2}, 1, {0, 1, 2}},
    {"strip/4", STRIP, 4, {0, 1, 2, 3}, 2, {0, 1, 2, 1, 3, 2}},
    {"strip/6", STRIP, 6, {0, 1, 2, 3, 4, 5}, 4, {0, 1, 2, 1, 3, 2, 2, 3, 4, 3, 5, 4}},
    {"strip/degenerate", STRIP, 7, {0, 1, 2, 2, 5, 5, 6}, 5, {0, 1, 2, 1, 2, 2, 2, 2, 5, 2, 5, 5, 5, 5, 6}},
    {"strip/restart", STRIP, 9, {0, 1, 2, 3, R, 4, 5, 6, 7}, 4, {0, 1, 2, 1, 3, 2, 4, 5, 6, 5, 7, 6}},
    {"strip/restart_after_odd", STRIP, 8, {0, 1, 2, R, 4, 5, 6, 7}, 3, {0, 1, 2, 4, 5, 6, 5, 7, 6}},
    {"strip/restarts_alone", STRIP, 5, {R, R, R, R, R}, 0, {0}},
    {"strip/restart_too_soon", STRIP, 8, {0, 1, R, 2, 3, R, 4, R}, 0, {0}},
    {"strip/restart_at_both_ends", STRIP, 6, {R, R, 3, 4, 5, R}, 1, {3, 4, 5}},
    {"fan/0", FAN, 0, {0}, 0, {0}},
    {"fan/1", FAN, 1, {0}, 0, {0}},
    {"fan/2", FAN, 2, {0, 1}, 0, {0}},
    {"fan/3", FAN, 3, {0, 1, 2}, 1, {0, 1, 2}},
    {"fan/4", FAN, 4, {0, 1, 2, 3}, 2, {0, 1, 2, 0, 2, 3}},
    {"fan/6", FAN, 6, {3, 1, 2, 0, 4, 5}, 4, {3, 1, 2, 3, 2, 0, 3, 0, 4, 3, 4, 5}},
    {"fan/degenerate", FAN, 5, {0, 1, 1, 0, 2}, 3, {0, 1, 1, 0, 1, 0, 0, 0, 2}},
    {"fan/restart", FAN, 9, {0, 1, 2, 3, R, 7, 5, 6, 8}, 4, {0, 1, 2, 0, 2, 3, 7, 5, 6, 7, 6, 8}},
    {"fan/restart_too_soon", FAN, 6, {0, 1, R, 2, R, R}, 0, {0}},
};

/* Vertices at random positions in the frame. */
static shd_mesh_desc make_desc(float vertices[VERTICES][5])
{
    shd_mesh_desc desc = shd_mesh_desc_default();
    uint32_t state = 3;
    int i, c;
    for (i = 0; i < VERTICES; ++i) {
        for (c = 0; c < 5; ++c) {
            shd_noise(&state);
            vertices[i][c] = (float)(state >> 8) * 0x1p-24f * (c < 2 ? 2.0f : 1.0f) - (c < 2 ? 1.0f : 0.0f);
        }
    }
    for (c = 0; c < 5; ++c) {
        shd_f32_in *column = c < 3 ? &desc.position[c] : &desc.uv[c - 3];
        column->data = vertices[0] + c;
        column->stride = sizeof vertices[0];
    }
    desc.vertex_count = VERTICES;
    return desc;
}

/* Hash of colour, depth, normals, uv and triangle of a frame of the mesh. */
static uint64_t render(const shd_mesh_desc *desc, size_t triangles)
{
    shd_material_desc material = shd_frame_plain(1, 0.5f, 0.25f);
    uint64_t hash = SHD_HASH_START;
    shd_mesh_info info = shd_mesh_info_default();
    shd_frame f;
    int plane;
    shd_frame_open(&f, 40, 30);
    shd_assert_ok(shd_mesh_create(f.context, desc, &f.mesh[0]));
    shd_assert_ok(shd_mesh_get_info(f.mesh[0], &info));
    assert_int_equal(info.triangle_count, triangles);
    shd_assert_ok(shd_material_create(f.context, &material, &f.material[0]));
    f.draw[0] = shd_draw_default();
    f.draw[0].mesh = f.mesh[0];
    f.draw[0].material = f.material[0];
    f.draw[0].cull = SHD_CULL_BACK;
    f.desc.draw_count = 1;
    shd_frame_ambient(&f);
    shd_frame_render(&f);
    assert_int_equal(f.stats.triangle_count, triangles);
    for (plane = 0; plane < SHD_PLANE_TRIANGLE; ++plane) {
        hash = shd_hash(hash, f.plane[plane], 40 * 30 * sizeof(float));
    }
    hash = shd_hash(hash, f.triangle, 40 * 30 * sizeof(uint32_t));
    shd_frame_close(&f);
    return hash;
}

static void test_frame(void **state)
{
    const struct topology_case *c = (const struct topology_case *)*state;
    float vertices[VERTICES][5];
    shd_mesh_desc desc = make_desc(vertices);
    uint16_t narrow[MOST], spread[3 * MOST];
    uint64_t want;
    size_t i;
    for (i = 0; i < c->count; ++i) spread[3 * i] = narrow[i] = (uint16_t)c->indices[i];
    desc.indices.data = c->triples;
    desc.index_count = 3 * c->triangles;
    want = render(&desc, c->triangles);
    desc.topology = c->topology;
    desc.index_count = c->count;
    desc.indices.data = c->indices;
    assert_true(render(&desc, c->triangles) == want);
    desc.indices.data = NULL;
    desc.indices16.data = narrow;
    assert_true(render(&desc, c->triangles) == want);
    desc.indices16.data = spread;
    desc.indices16.stride = 6;
    assert_true(render(&desc, c->triangles) == want);
}

/* Without indices a strip or fan runs through the vertices. */
static void test_unindexed(void **state)
{
    static const shd_topology k_topologies[2] = {SHD_TOPOLOGY_STRIP, SHD_TOPOLOGY_FAN};
    uint32_t count;
    int i;
    (void)state;
    for (i = 0; i < 2; ++i) {
        for (count = 0; count <= 5; ++count) {
            static const uint32_t k_order[5] = {0, 1, 2, 3, 4};
            const size_t triangles = count < 3 ? 0 : count - 2;
            float vertices[VERTICES][5];
            shd_mesh_desc desc = make_desc(vertices);
            uint64_t want;
            desc.topology = k_topologies[i];
            desc.vertex_count = count;
            desc.indices.data = k_order;
            desc.index_count = count;
            want = render(&desc, triangles);
            desc.indices.data = NULL;
            assert_true(render(&desc, triangles) == want); /* the first `count` of all vertices */
            desc.index_count = 0;
            assert_true(render(&desc, triangles) == want);
        }
    }
}

/* In separate triangles 0xffff is an ordinary vertex number. */
static void test_last_of_16_bits(void **state)
{
    static const uint16_t k_indices[3] = {0, 1, 0xffff};
    static float zero[65536];
    shd_mesh_desc desc = shd_mesh_desc_default();
    shd_context *context = NULL;
    shd_mesh *mesh = NULL;
    shd_mesh_info info = shd_mesh_info_default();
    int c;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    for (c = 0; c < 3; ++c) desc.position[c].data = zero;
    desc.indices16.data = k_indices;
    desc.index_count = 3;
    desc.vertex_count = 65535;
    shd_assert_result("65535", shd_mesh_create(context, &desc, &mesh), SHD_ERROR_INVALID_ARGUMENT,
                      "mesh.indices16[2]: 65535 is not below vertex_count 65535");
    desc.vertex_count = 65536;
    shd_assert_ok(shd_mesh_create(context, &desc, &mesh));
    shd_assert_ok(shd_mesh_get_info(mesh, &info));
    assert_int_equal(info.triangle_count, 1);
    shd_mesh_release(mesh);
    desc.topology = SHD_TOPOLOGY_STRIP;
    shd_assert_ok(shd_mesh_create(context, &desc, &mesh));
    shd_assert_ok(shd_mesh_get_info(mesh, &info));
    assert_int_equal(info.triangle_count, 0);
    shd_mesh_release(mesh);
    shd_context_release(context);
}

static const uint16_t k_narrow[9] = {0, 1, 2, 3, 0xfffe, 5, 6, 7, 8};
static const uint32_t k_restarts[3] = {R, R, R};
static const uint32_t k_wide[9] = {0, 1, 2, 3, 12, 5, 6, 7, 8};
static void both(shd_mesh_desc *d) { d->indices.data = k_wide; }
static void stride_3(shd_mesh_desc *d) { d->indices16.stride = 3; }
static void stride_huge(shd_mesh_desc *d) { d->indices16.stride = SIZE_MAX - 1; }
static void misaligned(shd_mesh_desc *d)
{
    d->indices16.data = (const uint16_t *)(const void *)((const char *)k_narrow + 1);
}
static void nothing(shd_mesh_desc *d) { (void)d; }
static void of_triangles_7(shd_mesh_desc *d)
{
    d->topology = SHD_TOPOLOGY_TRIANGLES;
    d->index_count = 7;
}
static void restart_of_triangles(shd_mesh_desc *d)
{
    d->topology = SHD_TOPOLOGY_TRIANGLES;
    d->indices16.data = NULL;
    d->indices.data = k_restarts;
    d->index_count = 3;
}
static void wide_12(shd_mesh_desc *d)
{
    d->indices16.data = NULL;
    d->indices.data = k_wide;
}
static void strip_above(shd_mesh_desc *d) { d->index_count = ((size_t)1 << 28) + 3; }
static void fan_max(shd_mesh_desc *d)
{
    d->topology = SHD_TOPOLOGY_FAN;
    d->index_count = SIZE_MAX;
}
static void unindexed_above(shd_mesh_desc *d)
{
    d->indices16.data = NULL;
    d->index_count = 13;
}
static void topology_3(shd_mesh_desc *d) { d->topology = (shd_topology)3; }

static const struct refusal {
    const char *name;
    void (*edit)(shd_mesh_desc *desc);
    const char *message;
} k_refusals[] = {
    {"refused/narrow_65534", nothing, "mesh.indices16[4]: 65534 is not below vertex_count 12"},
    {"refused/wide_12", wide_12, "mesh.indices[4]: 12 is not below vertex_count 12"},
    {"refused/both", both, "mesh.indices16.data: set, but mesh.indices is too"},
    {"refused/stride_3", stride_3, "mesh.indices16.stride: 3 is not a multiple of 2"},
    {"refused/stride_overflow", stride_huge, "mesh.indices16: 9 elements of stride"},
    {"refused/misaligned", misaligned, "mesh.indices16.data: not aligned to 2 bytes"},
    {"refused/triangles_7", of_triangles_7, "mesh.index_count: 7 is not a multiple of 3"},
    {"refused/restart_of_triangles", restart_of_triangles, "mesh.indices[0]: 4294967295 is not below vertex_count 12"},
    {"refused/strip_2^28+3", strip_above, "mesh.index_count: 268435459 is not in 0..268435458"},
    {"refused/fan_size_max", fan_max, "mesh.index_count: 18446744073709551615 is not in 0..268435458"},
    {"refused/unindexed_13", unindexed_above, "mesh.index_count without indices: 13 is not in 0..12"},
    {"refused/topology_3", topology_3, "mesh.topology: 3 is not in 0..2"},
};

static void test_refusal(void **state)
{
    const struct refusal *c = (const struct refusal *)*state;
    float vertices[VERTICES][5];
    shd_mesh_desc desc = make_desc(vertices);
    shd_context *context = NULL;
    shd_mesh *mesh = (shd_mesh *)&desc;
    shd_assert_ok(shd_context_create(NULL, &context));
    desc.topology = SHD_TOPOLOGY_STRIP;
    desc.indices16.data = k_narrow;
    desc.index_count = 9;
    c->edit(&desc);
    shd_assert_result(c->name, shd_mesh_create(context, &desc, &mesh), SHD_ERROR_INVALID_ARGUMENT, c->message);
    assert_null(mesh);
    shd_context_release(context);
}

#define COUNT(table) (sizeof(table) / sizeof(table)[0])

int main(void)
{
    static struct CMUnitTest tests[COUNT(k_cases) + COUNT(k_refusals) + 2];
    size_t n = 0, i;
    for (i = 0; i < COUNT(k_cases); ++i) {
        tests[n++] = (struct CMUnitTest){k_cases[i].name, test_frame, NULL, NULL, (void *)&k_cases[i]};
    }
    for (i = 0; i < COUNT(k_refusals); ++i) {
        tests[n++] = (struct CMUnitTest){k_refusals[i].name, test_refusal, NULL, NULL, (void *)&k_refusals[i]};
    }
    tests[n++] = (struct CMUnitTest){"unindexed", test_unindexed, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"last_of_16_bits", test_last_of_16_bits, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.mesh_topology", tests, n, NULL, NULL);
}
