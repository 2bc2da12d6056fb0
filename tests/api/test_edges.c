/* SPDX-License-Identifier: MIT */
/* Edges of meshes by kind: against an oracle that compares every pair of edges, on shapes with known drawings; columns;
 * refusals.
 */
#include "support/noise.h"
#include "support/shapes.h"

#include <stdlib.h>

#include <shd/shd.h>

#include "ref/edges_ref.h"

static shd_context *g_context;
static shd_test_shape g_shape;

enum { k_max_edges = 3 * SHD_SHAPE_TRIANGLES };
static shd_ref_edge g_want[k_max_edges];
static uint32_t g_vertex[2][k_max_edges], g_triangle[2][k_max_edges], g_kinds[k_max_edges];

static shd_edges columns(void)
{
    shd_edges out = shd_edges_default();
    int i;
    for (i = 0; i < 2; ++i) out.vertex[i].data = g_vertex[i];
    for (i = 0; i < 2; ++i) out.triangle[i].data = g_triangle[i];
    out.kinds.data = g_kinds;
    return out;
}

static shd_edges_desc seen_from(float x, float y, float z, float w)
{
    shd_edges_desc desc = shd_edges_desc_default();
    desc.eye[0] = x;
    desc.eye[1] = y;
    desc.eye[2] = z;
    desc.eye[3] = w;
    return desc;
}

static size_t find(const shd_mesh *mesh, const shd_edges_desc *desc)
{
    const shd_edges out = columns();
    size_t count = 99;
    shd_assert_ok(shd_mesh_find_edges(mesh, desc, k_max_edges, &out, &count));
    assert_true(count <= k_max_edges);
    return count;
}

static size_t count_of(const shd_mesh *mesh, uint32_t kinds, float x, float y, float z, float w)
{
    shd_edges_desc desc = seen_from(x, y, z, w);
    desc.edges = kinds;
    return find(mesh, &desc);
}

/* ---- against the oracle ---- */

static void make_cube(void) { shd_test_shape_cube(&g_shape, 1); }
static void make_cube_of_cells(void) { shd_test_shape_cube(&g_shape, 3); }
static void make_sphere(void) { shd_test_shape_sphere(&g_shape, 5); }
static void make_grid(void) { shd_test_shape_grid(&g_shape, 7, 4); }
static void make_book_of_2(void) { shd_test_shape_book(&g_shape, 2); }
static void make_book_of_5(void) { shd_test_shape_book(&g_shape, 5); }
static void make_moebius(void) { shd_test_shape_moebius(&g_shape, 24); }
static void make_lattice(void) { shd_test_shape_lattice(&g_shape, 60, 3); }
static void make_dense_lattice(void) { shd_test_shape_lattice(&g_shape, 300, 4); }
static void make_twice(void)
{
    shd_test_shape_cube(&g_shape, 1);
    shd_test_shape_cube(&g_shape, 1);
}
static void make_two_sided(void)
{
    (void)shd_test_shape_vertex(&g_shape, 0, 0, 0);
    (void)shd_test_shape_vertex(&g_shape, 1, 0, 0);
    (void)shd_test_shape_vertex(&g_shape, 0, 1, 0);
    shd_test_shape_triangle(&g_shape, 0, 1, 2);
    shd_test_shape_triangle(&g_shape, 2, 1, 0);
}
/* A cone of 16 triangles with 16 vertices at its tip, and with triangles degenerated to edges at tip and rim. */
static void make_degenerate(void)
{
    uint32_t i;
    for (i = 0; i < 16; ++i) {
        const double a = 6.283185307179586 * i / 16, b = 6.283185307179586 * ((i + 1) % 16) / 16;
        const uint32_t tip = shd_test_shape_vertex(&g_shape, 0, 0, 1);
        const uint32_t p = shd_test_shape_vertex(&g_shape, (float)cos(a), (float)sin(a), 0);
        const uint32_t q = shd_test_shape_vertex(&g_shape, (float)cos(b), (float)sin(b), 0);
        shd_test_shape_triangle(&g_shape, tip, p, q);
        shd_test_shape_triangle(&g_shape, tip, tip, q);
        shd_test_shape_triangle(&g_shape, p, q, q);
        shd_test_shape_triangle(&g_shape, i ? tip - 3 : tip, q, tip);
        shd_test_shape_triangle(&g_shape, p, p, p);
    }
}
static void make_tiny(void)
{
    uint32_t i;
    shd_test_shape_sphere(&g_shape, 2);
    for (i = 0; i < 3 * g_shape.vertices; ++i) g_shape.position[i] *= 1e-41f;
}
static void make_huge(void)
{
    uint32_t i;
    shd_test_shape_sphere(&g_shape, 2);
    for (i = 0; i < 3 * g_shape.vertices; ++i) g_shape.position[i] *= 3e38f;
}
static void make_nonfinite(void)
{
    shd_test_shape_sphere(&g_shape, 3);
    g_shape.position[3 * 5] = (float)NAN;
    g_shape.position[3 * 20 + 1] = (float)INFINITY;
    g_shape.position[3 * 21 + 1] = (float)INFINITY;
    g_shape.position[3 * 40 + 2] = -(float)INFINITY;
}

struct shape_case {
    const char *name;
    void (*make)(void);
    float scale; /* scale of eye positions */
};
static const struct shape_case k_shapes[] = {
    {"oracle/cube", make_cube, 3},
    {"oracle/cube_of_cells", make_cube_of_cells, 3},
    {"oracle/sphere", make_sphere, 3},
    {"oracle/grid", make_grid, 9},
    {"oracle/book_of_2", make_book_of_2, 3},
    {"oracle/book_of_5", make_book_of_5, 3},
    {"oracle/moebius", make_moebius, 3},
    {"oracle/lattice", make_lattice, 3},
    {"oracle/dense_lattice", make_dense_lattice, 3},
    {"oracle/everything_twice", make_twice, 3},
    {"oracle/two_sided", make_two_sided, 3},
    {"oracle/degenerate", make_degenerate, 3},
    {"oracle/tiny", make_tiny, 3e-41f},
    {"oracle/huge", make_huge, 3e38f},
    {"oracle/nonfinite", make_nonfinite, 3},
};

static float next_random(uint32_t *seed)
{
    shd_noise(seed);
    return 2 * (float)(*seed >> 8) / 16777216.0f - 1;
}

/* The result has the edges of the oracle, except for kinds that depend on rounding. */
static void compare(const char *name, const shd_edges_desc *desc, size_t want, size_t got)
{
    size_t i, row = 0;
    for (i = 0; i < want; ++i) {
        const shd_ref_edge *e = &g_want[i];
        const int is_next = row < got && g_vertex[0][row] == e->vertex[0] && g_vertex[1][row] == e->vertex[1] &&
                            g_triangle[0][row] == e->triangle[0];
        const uint32_t kinds = is_next ? g_kinds[row] : 0;
        if (is_next) {
            assert_true(kinds != 0 && (kinds & ~desc->edges) == 0);
            assert_int_equal(g_triangle[1][row], e->triangle[1]);
            ++row;
        }
        if (kinds == (e->kinds & desc->edges) || e->margin < 1e-12) continue;
        fail_msg("%s: edge %u-%u of triangles %u %u: kinds %u, want %u (margin %g)", name, e->vertex[0], e->vertex[1],
                 e->triangle[0], e->triangle[1], kinds, e->kinds, e->margin);
    }
    assert_int_equal(row, got);
}

static void test_oracle(void **state)
{
    const struct shape_case *c = (const struct shape_case *)*state;
    const shd_ref_mesh ref = {g_shape.position, g_shape.indices, 0};
    shd_ref_mesh of = ref;
    uint32_t seed = 1;
    shd_mesh *mesh;
    int i;
    memset(&g_shape, 0, sizeof g_shape);
    c->make();
    of.triangles = g_shape.triangles;
    mesh = shd_test_shape_mesh(g_context, &g_shape, SHD_MESH_ADJACENCY | SHD_MESH_KEEP_NONFINITE);
    for (i = 0; i < (g_shape.triangles > 200 ? 6 : 25); ++i) {
        const float x = c->scale * next_random(&seed), y = c->scale * next_random(&seed);
        shd_edges_desc desc = seen_from(x, y, c->scale * next_random(&seed), i % 3 ? 1.0f : 0.0f);
        if (i % 5 == 4) desc.edges = 1u << i / 5 % 4;
        desc.crease_cosine = next_random(&seed);
        compare(c->name, &desc, shd_ref_find_edges(&of, &desc, g_want), find(mesh, &desc));
    }
    shd_mesh_release(mesh);
}

/* ---- known shapes ---- */

static shd_mesh *make(void (*shape)(void))
{
    memset(&g_shape, 0, sizeof g_shape);
    shape();
    return shd_test_shape_mesh(g_context, &g_shape, SHD_MESH_ADJACENCY);
}

/* Twelve creases. The silhouette has 6 of them if the eye is in front of a corner or an edge, and 4 if it is in
 * front of a side. */
static void test_cube(void **state)
{
    shd_mesh *mesh = make(make_cube);
    shd_edges_desc desc = seen_from(0, 0, 5, 1);
    (void)state;
    assert_int_equal(find(mesh, &desc), 12);
    assert_int_equal(count_of(mesh, SHD_EDGE_CREASE, 5, 0, 0, 1), 12);
    assert_int_equal(count_of(mesh, SHD_EDGE_SILHOUETTE, 5, 0, 0, 1), 4);
    assert_int_equal(count_of(mesh, SHD_EDGE_SILHOUETTE, 5, 4, 0.5f, 1), 6);
    assert_int_equal(count_of(mesh, SHD_EDGE_SILHOUETTE, 5, 4, 3, 1), 6);
    assert_int_equal(count_of(mesh, SHD_EDGE_SILHOUETTE, 0.5f, 0.25f, -0.5f, 1), 0); /* inside */
    assert_int_equal(count_of(mesh, SHD_EDGE_SILHOUETTE, 3, 2, 1, 0), 6);
    assert_int_equal(count_of(mesh, SHD_EDGE_SILHOUETTE, -3, -2, -1, 0), 6);
    /* All edges of a side that is seen edge-on are silhouettes, including its diagonal. */
    assert_int_equal(count_of(mesh, SHD_EDGE_SILHOUETTE, 0, 0, 1, 0), 16);
    assert_int_equal(count_of(mesh, SHD_EDGE_BORDER | SHD_EDGE_NONMANIFOLD, 0, 0, 1, 0), 0);
    desc.crease_cosine = -0.01f;
    desc.edges = SHD_EDGE_CREASE;
    assert_int_equal(find(mesh, &desc), 0);
    desc.crease_cosine = 0;
    assert_int_equal(find(mesh, &desc), 12);
    desc.crease_cosine = 1; /* diagonals have the cosine 1 */
    assert_int_equal(find(mesh, &desc), 18);
    desc.edges = SHD_EDGE_NONE;
    assert_int_equal(find(mesh, &desc), 0);
    shd_mesh_release(mesh);
}

/* Scaling the homogeneous point of the eye changes nothing; a direction is the limit of points far away. */
static void test_eye(void **state)
{
    shd_mesh *mesh = make(make_sphere);
    shd_edges_desc desc = seen_from(1, 2, 3, 1);
    size_t count, i;
    static uint32_t kinds[k_max_edges];
    (void)state;
    desc.crease_cosine = 1;
    count = find(mesh, &desc);
    memcpy(kinds, g_kinds, count * sizeof *kinds);
    for (i = 0; i < 4; ++i) desc.eye[i] *= -4;
    assert_int_equal(find(mesh, &desc), count);
    assert_memory_equal(kinds, g_kinds, count * sizeof *kinds);
    desc = seen_from(1e9f, 2e9f, 3e9f, 1);
    desc.crease_cosine = 1;
    assert_int_equal(find(mesh, &desc), count);
    memcpy(kinds, g_kinds, count * sizeof *kinds);
    desc = seen_from(1, 2, 3, 0);
    desc.crease_cosine = 1;
    assert_int_equal(find(mesh, &desc), count);
    assert_memory_equal(kinds, g_kinds, count * sizeof *kinds);
    shd_mesh_release(mesh);
}

/* Silhouettes of a closed surface are closed: an even number of their edges meets at each position. */
static void test_closed(void **state)
{
    shd_mesh *mesh = make(make_sphere);
    uint32_t seed = 7;
    int n;
    (void)state;
    for (n = 0; n < 60; ++n) {
        shd_edges_desc desc = seen_from(3 * next_random(&seed), 3 * next_random(&seed), 3 * next_random(&seed), 1);
        const float *p = desc.eye;
        size_t count, i, j;
        const int is_outside = p[0] * p[0] + p[1] * p[1] + p[2] * p[2] > 1;
        desc.edges = SHD_EDGE_SILHOUETTE;
        count = find(mesh, &desc);
        assert_true((count > 0) >= is_outside);
        for (i = 0; i < 2 * count; ++i) {
            const float *at = g_shape.position + 3 * (size_t)g_vertex[i % 2][i / 2];
            size_t meet = 0;
            for (j = 0; j < 2 * count; ++j) {
                meet += memcmp(at, g_shape.position + 3 * (size_t)g_vertex[j % 2][j / 2], 3 * sizeof *at) == 0;
            }
            assert_int_equal(meet % 2, 0);
        }
    }
    shd_mesh_release(mesh);
}

static void test_borders(void **state)
{
    shd_mesh *mesh = make(make_grid);
    (void)state;
    assert_int_equal(count_of(mesh, SHD_EDGE_ALL, 3, 2, 5, 1), 2 * (7 + 4));
    assert_int_equal(count_of(mesh, SHD_EDGE_BORDER, 3, 2, 5, 1), 2 * (7 + 4));
    shd_mesh_release(mesh);
    mesh = make(make_degenerate); /* a cone, open below */
    assert_int_equal(count_of(mesh, SHD_EDGE_BORDER, 3, 2, 5, 1), 16);
    assert_int_equal(count_of(mesh, SHD_EDGE_SILHOUETTE, 3, 0.1f, 0.2f, 1), 2);
    assert_int_equal(count_of(mesh, SHD_EDGE_NONMANIFOLD, 3, 2, 5, 1), 0);
    shd_mesh_release(mesh);
}

/* Edges of more than two triangles; a Moebius strip, which has one side and one border. */
static void test_nonmanifold(void **state)
{
    shd_mesh *mesh = make(make_book_of_5);
    shd_edges_desc desc = seen_from(3, 1, 0.1f, 1);
    (void)state;
    assert_int_equal(count_of(mesh, SHD_EDGE_NONMANIFOLD, 3, 2, 5, 1), 1);
    assert_int_equal(count_of(mesh, SHD_EDGE_BORDER, 3, 2, 5, 1), 10);
    assert_int_equal(count_of(mesh, SHD_EDGE_SILHOUETTE | SHD_EDGE_CREASE, 3, 2, 5, 1), 0);
    shd_mesh_release(mesh);
    mesh = make(make_twice);
    assert_int_equal(count_of(mesh, SHD_EDGE_ALL, 3, 2, 5, 1), 18);
    assert_int_equal(count_of(mesh, SHD_EDGE_NONMANIFOLD, 3, 2, 5, 1), 18);
    shd_mesh_release(mesh);
    mesh = make(make_moebius);
    desc.edges = SHD_EDGE_BORDER | SHD_EDGE_NONMANIFOLD;
    assert_int_equal(find(mesh, &desc), 48);
    desc.edges = SHD_EDGE_CREASE; /* the twist at the joint makes no crease */
    assert_int_equal(find(mesh, &desc), 0);
    shd_mesh_release(mesh);
}

static void test_empty(void **state)
{
    shd_mesh *mesh;
    (void)state;
    memset(&g_shape, 0, sizeof g_shape);
    mesh = shd_test_shape_mesh(g_context, &g_shape, SHD_MESH_ADJACENCY);
    assert_int_equal(count_of(mesh, SHD_EDGE_ALL, 0, 0, 1, 0), 0);
    shd_mesh_release(mesh);
    (void)shd_test_shape_vertex(&g_shape, 0, 0, 0);
    mesh = shd_test_shape_mesh(g_context, &g_shape, SHD_MESH_ADJACENCY);
    assert_int_equal(count_of(mesh, SHD_EDGE_ALL, 0, 0, 1, 0), 0);
    shd_mesh_release(mesh);
}

/* Many vertices at few positions, and a vertex with very many triangles. */
static void test_crowded(void **state)
{
    enum { COUNT = 100000 };
    float *p = (float *)malloc(3 * (COUNT + 2) * sizeof *p);
    uint32_t *indices = (uint32_t *)malloc(3 * (size_t)COUNT * sizeof *indices);
    shd_mesh_desc desc = shd_mesh_desc_default();
    shd_edges_desc all = seen_from(0, 0, 1, 0);
    shd_mesh *mesh = NULL;
    size_t count = 0;
    uint32_t i, c;
    (void)state;
    assert_true(p && indices);
    for (i = 0; i < COUNT + 2; ++i) {
        const double angle = 3.0 * i / COUNT;
        p[3 * i] = i ? (float)cos(angle) : 0;
        p[3 * i + 1] = i ? (float)sin(angle) : 0;
        p[3 * i + 2] = i % 2 ? 0.5f : 0;
    }
    for (i = 0; i < COUNT; ++i) {
        indices[3 * i] = 0;
        indices[3 * i + 1] = i + 1;
        indices[3 * i + 2] = i + 2;
    }
    desc.vertex_count = COUNT + 2;
    for (c = 0; c < 3; ++c) desc.position[c] = (shd_f32_in){p + c, 3 * sizeof *p};
    desc.indices.data = indices;
    desc.index_count = 3 * (size_t)COUNT;
    desc.flags = SHD_MESH_ADJACENCY;
    shd_assert_ok(shd_mesh_create(g_context, &desc, &mesh));
    all.edges = SHD_EDGE_BORDER;
    shd_assert_ok(shd_mesh_find_edges(mesh, &all, 0, NULL, &count));
    assert_int_equal(count, COUNT + 2);
    shd_mesh_release(mesh);
    for (i = 0; i < COUNT + 2; ++i) {
        p[3 * i] = i % 3 == 1;
        p[3 * i + 1] = i % 3 == 2;
        p[3 * i + 2] = 0;
    }
    for (i = 0; i < COUNT; ++i) indices[3 * i] = i;
    shd_assert_ok(shd_mesh_create(g_context, &desc, &mesh));
    all.edges = SHD_EDGE_ALL;
    shd_assert_ok(shd_mesh_find_edges(mesh, &all, 0, NULL, &count));
    assert_int_equal(count, 3);
    shd_mesh_release(mesh);
    free(p);
    free(indices);
}

/* ---- columns ---- */

static void test_columns(void **state)
{
    struct record {
        uint32_t kinds, before, vertex, after;
    } records[20];
    shd_mesh *mesh = make(make_cube);
    const shd_edges_desc desc = seen_from(4, 3, 2, 1);
    shd_edges out = columns();
    size_t count = 0, i, capacity;
    (void)state;
    assert_int_equal(find(mesh, &desc), 12);
    for (capacity = 0; capacity < 14; ++capacity) {
        memset(records, 0xee, sizeof records);
        out = shd_edges_default();
        out.kinds = shd_u32_out_column(&records[0].kinds, sizeof records[0]);
        out.vertex[1] = shd_u32_out_column(&records[0].vertex, sizeof records[0]);
        shd_assert_ok(shd_mesh_find_edges(mesh, &desc, capacity, capacity ? &out : NULL, &count));
        assert_int_equal(count, 12);
        for (i = 0; i < 20; ++i) {
            const int is_written = i < capacity && i < 12;
            assert_int_equal(records[i].kinds, is_written ? g_kinds[i] : 0xeeeeeeeeu);
            assert_int_equal(records[i].vertex, is_written ? g_vertex[1][i] : 0xeeeeeeeeu);
            assert_true(records[i].before == 0xeeeeeeeeu && records[i].after == 0xeeeeeeeeu);
        }
    }
    shd_mesh_release(mesh);
}

/* ---- refusals ---- */

static void bad_kinds(shd_edges_desc *d) { d->edges = 16; }
static void bad_eye_nan(shd_edges_desc *d) { d->eye[1] = (float)NAN; }
static void bad_eye_inf(shd_edges_desc *d) { d->eye[3] = (float)INFINITY; }
static void bad_eye_zero(shd_edges_desc *d) { d->eye[2] = 0; }
static void bad_crease_nan(shd_edges_desc *d) { d->crease_cosine = (float)NAN; }
static void bad_crease_high(shd_edges_desc *d) { d->crease_cosine = 1.001f; }
static void bad_crease_low(shd_edges_desc *d) { d->crease_cosine = -1.001f; }
static void bad_size(shd_edges_desc *d) { d->struct_size = 7; }

struct bad_case {
    const char *name;
    void (*edit)(shd_edges_desc *d);
    const char *message;
    shd_result result; /* SHD_OK = invalid argument */
};
static const struct bad_case k_bad[] = {
    {"refused/kinds", bad_kinds, "edges.edges: ", SHD_ERROR_UNSUPPORTED},
    {"refused/eye_nan", bad_eye_nan, "edges.eye[1]: ", SHD_OK},
    {"refused/eye_inf", bad_eye_inf, "edges.eye[3]: ", SHD_OK},
    {"refused/eye_zero", bad_eye_zero, "edges.eye: 0 is neither a point nor a direction", SHD_OK},
    {"refused/crease_nan", bad_crease_nan, "edges.crease_cosine: ", SHD_OK},
    {"refused/crease_high", bad_crease_high, "edges.crease_cosine: ", SHD_OK},
    {"refused/crease_low", bad_crease_low, "edges.crease_cosine: ", SHD_OK},
    {"refused/struct_size", bad_size, "edges.struct_size: ", SHD_OK},
};

static void test_bad(void **state)
{
    const struct bad_case *c = (const struct bad_case *)*state;
    shd_mesh *mesh = make(make_cube);
    shd_edges_desc desc = shd_edges_desc_default();
    const shd_edges out = columns();
    size_t count = 9;
    c->edit(&desc);
    memset(g_kinds, 0xee, sizeof g_kinds);
    shd_assert_result(c->name, shd_mesh_find_edges(mesh, &desc, 20, &out, &count),
                      c->result ? c->result : SHD_ERROR_INVALID_ARGUMENT, c->message);
    assert_int_equal(count, 0);
    assert_int_equal(g_kinds[0], 0xeeeeeeeeu);
    shd_mesh_release(mesh);
}

static void test_bad_arguments(void **state)
{
    shd_mesh *mesh = make(make_cube), *plain;
    const shd_edges_desc desc = shd_edges_desc_default();
    shd_edges out = columns();
    shd_mesh_info info = shd_mesh_info_default();
    size_t count = 9;
    (void)state;
    plain = shd_test_shape_mesh(g_context, &g_shape, 0);
    shd_assert_result("plain", shd_mesh_find_edges(plain, &desc, 20, &out, &count), SHD_ERROR_INVALID_ARGUMENT,
                      "mesh: made without SHD_MESH_ADJACENCY");
    shd_assert_result("mesh", shd_mesh_find_edges(NULL, &desc, 20, &out, &count), SHD_ERROR_INVALID_ARGUMENT,
                      "mesh: NULL");
    shd_assert_result("desc", shd_mesh_find_edges(mesh, NULL, 20, &out, &count), SHD_ERROR_INVALID_ARGUMENT,
                      "edges: NULL");
    shd_assert_result("out", shd_mesh_find_edges(mesh, &desc, 1, NULL, &count), SHD_ERROR_INVALID_ARGUMENT,
                      "out: NULL");
    shd_assert_result("count", shd_mesh_find_edges(mesh, &desc, 1, &out, NULL), SHD_ERROR_INVALID_ARGUMENT,
                      "out_count: NULL");
    out.triangle[1].stride = 6;
    shd_assert_result("stride", shd_mesh_find_edges(mesh, &desc, 20, &out, &count), SHD_ERROR_INVALID_ARGUMENT,
                      "out.triangle[1]");
    out.triangle[1].stride = 0;
    out.vertex[1].data = (uint32_t *)(void *)((char *)g_kinds + 2);
    shd_assert_result("alignment", shd_mesh_find_edges(mesh, &desc, 20, &out, &count), SHD_ERROR_INVALID_ARGUMENT,
                      "out.vertex[1]");
    assert_int_equal(count, 0);
    shd_assert_ok(shd_mesh_get_info(mesh, &info));
    assert_int_equal(info.triangle_count, 12);
    shd_mesh_release(plain);
    shd_mesh_release(mesh);
}

int main(void)
{
    static struct CMUnitTest tests[60];
    size_t n = 0, i;
    int failed;
    for (i = 0; i < sizeof k_shapes / sizeof k_shapes[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_shapes[i].name, test_oracle, NULL, NULL, (void *)&k_shapes[i]};
    }
    for (i = 0; i < sizeof k_bad / sizeof k_bad[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_bad[i].name, test_bad, NULL, NULL, (void *)&k_bad[i]};
    }
    tests[n++] = (struct CMUnitTest){"cube", test_cube, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"eye", test_eye, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"closed", test_closed, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"borders", test_borders, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"nonmanifold", test_nonmanifold, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"empty", test_empty, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"crowded", test_crowded, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"columns", test_columns, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"refused/arguments", test_bad_arguments, NULL, NULL, NULL};
    shd_assert_ok(shd_context_create(NULL, &g_context));
    failed = _cmocka_run_group_tests("api.edges", tests, n, NULL, NULL);
    shd_context_release(g_context);
    return failed;
}
