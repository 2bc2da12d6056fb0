/* SPDX-License-Identifier: MIT */
/* shd/shapes.h: every refusal; closed edges, winding, uv and normals of every shape at many tessellations; areas and
 * volumes that converge to the exact values; strides and absent columns; the bits. */
#include <stdlib.h>

#include "ref/shapes_ref.h"
#include "support/check.h"

#include <shd/mesh.h>
#include <shd/shapes.h>

#define BAD SHD_ERROR_INVALID_ARGUMENT
#define COUNT(table) (sizeof(table) / sizeof(table)[0])

/* A shape in allocated memory, interleaved: position, normal, uv. Free with drop(). */
struct filled {
    size_t vertex_count, index_count;
    float *position, *normal, *uv;
    uint32_t *index;
};

static struct filled fill(const shd_shape_desc *desc)
{
    struct filled f;
    shd_shape_columns columns = shd_shape_columns_default();
    int c;
    shd_assert_ok(shd_shape_count(desc, &f.vertex_count, &f.index_count));
    f.position = (float *)malloc(sizeof(float) * 3 * f.vertex_count);
    f.normal = (float *)malloc(sizeof(float) * 3 * f.vertex_count);
    f.uv = (float *)malloc(sizeof(float) * 2 * f.vertex_count);
    f.index = (uint32_t *)malloc(sizeof(uint32_t) * f.index_count);
    columns.vertex_count = f.vertex_count;
    columns.index_count = f.index_count;
    for (c = 0; c < 3; ++c) {
        columns.position[c].data = f.position + c;
        columns.normal[c].data = f.normal + c;
        columns.position[c].stride = columns.normal[c].stride = 3 * sizeof(float);
    }
    for (c = 0; c < 2; ++c) {
        columns.uv[c].data = f.uv + c;
        columns.uv[c].stride = 2 * sizeof(float);
    }
    columns.indices.data = f.index;
    shd_assert_ok(shd_shape_fill(desc, &columns));
    return f;
}

static void drop(struct filled *f)
{
    free(f->position);
    free(f->normal);
    free(f->uv);
    free(f->index);
}

static shd_shape_desc shape_of(shd_shape shape, uint32_t a, uint32_t b, uint32_t c)
{
    shd_shape_desc desc = shd_shape_desc_default();
    desc.kind = shape;
    desc.segments[0] = a;
    desc.segments[1] = b;
    desc.segments[2] = c;
    return desc;
}

/* Edges. */

static const float *g_position; /* array that compare_places() reads */

static int compare_places(const void *a, const void *b)
{
    const uint32_t i = *(const uint32_t *)a, j = *(const uint32_t *)b;
    const int order = memcmp(g_position + 3 * (size_t)i, g_position + 3 * (size_t)j, 3 * sizeof(float));
    return order ? order : i < j ? -1 : i > j;
}

static int compare_edges(const void *a, const void *b)
{
    const uint64_t i = *(const uint64_t *)a, j = *(const uint64_t *)b;
    return i < j ? -1 : i > j;
}

/* The first vertex with the same bits of position, for each vertex. */
static uint32_t *weld(const struct filled *f)
{
    uint32_t *order = (uint32_t *)malloc(sizeof(uint32_t) * f->vertex_count);
    uint32_t *first = (uint32_t *)malloc(sizeof(uint32_t) * f->vertex_count);
    uint32_t i;
    for (i = 0; i < f->vertex_count; ++i) order[i] = i;
    g_position = f->position;
    qsort(order, f->vertex_count, sizeof *order, compare_places);
    for (i = 0; i < f->vertex_count; ++i) {
        const int same = i > 0 && memcmp(f->position + 3 * (size_t)order[i], f->position + 3 * (size_t)order[i - 1],
                                         3 * sizeof(float)) == 0;
        first[order[i]] = same ? first[order[i - 1]] : order[i];
    }
    free(order);
    return first;
}

/* Returns the number of edges without a partner in the opposite direction. Fails for two edges in the same
 * direction. */
static size_t count_open_edges(const char *name, const struct filled *f)
{
    uint32_t *first = weld(f);
    uint64_t *edge = (uint64_t *)malloc(sizeof(uint64_t) * f->index_count);
    size_t i, open = 0;
    for (i = 0; i < f->index_count; ++i) {
        const uint32_t a = first[f->index[i]], b = first[f->index[i % 3 == 2 ? i - 2 : i + 1]];
        if (a == b) fail_msg("%s: triangle %zu has two corners in one place", name, i / 3);
        edge[i] = (uint64_t)a << 32 | b;
    }
    qsort(edge, f->index_count, sizeof *edge, compare_edges);
    for (i = 0; i < f->index_count; ++i) {
        const uint64_t back = edge[i] << 32 | edge[i] >> 32;
        if (i > 0 && edge[i] == edge[i - 1]) fail_msg("%s: two triangles run along one edge the same way", name);
        open += bsearch(&back, edge, f->index_count, sizeof *edge, compare_edges) == NULL;
    }
    free(edge);
    free(first);
    return open;
}

/* Every shape, with the smallest numbers of segments and with odd and even numbers. */

struct shape_case {
    const char *name;
    shd_shape shape;
    uint32_t segments[3];
    uint32_t vertices, triangles;
    size_t open_edges;
};

static const struct shape_case k_shapes[] = {
    {"sphere/3_2", SHD_SHAPE_SPHERE, {3, 2, 0}, 10, 6, 0},
    {"sphere/4_2", SHD_SHAPE_SPHERE, {4, 2, 0}, 13, 8, 0},
    {"sphere/3_3", SHD_SHAPE_SPHERE, {3, 3, 0}, 14, 12, 0},
    {"sphere/default", SHD_SHAPE_SPHERE, {0, 0, 0}, 559, 960, 0},
    {"sphere/31_17", SHD_SHAPE_SPHERE, {31, 17, 9}, 574, 992, 0},
    {"sphere/7_200", SHD_SHAPE_SPHERE, {7, 200, 0}, 1606, 2786, 0},
    {"box/default", SHD_SHAPE_BOX, {0, 0, 0}, 24, 12, 0},
    {"box/1_2_3", SHD_SHAPE_BOX, {1, 2, 3}, 52, 44, 0},
    {"box/7_1_5", SHD_SHAPE_BOX, {7, 1, 5}, 152, 188, 0},
    {"plane/default", SHD_SHAPE_PLANE, {0, 0, 0}, 4, 2, 4},
    {"plane/3_5", SHD_SHAPE_PLANE, {3, 5000, 5}, 24, 30, 16},
    {"torus/3_3", SHD_SHAPE_TORUS, {3, 3, 0}, 16, 18, 0},
    {"torus/default", SHD_SHAPE_TORUS, {0, 0, 0}, 1225, 2304, 0},
    {"torus/5_64", SHD_SHAPE_TORUS, {5, 64, 0}, 390, 640, 0},
    {"teapot/2", SHD_SHAPE_TEAPOT, {2, 0, 0}, 280, 240, 32},
    {"teapot/3", SHD_SHAPE_TEAPOT, {3, 0, 0}, 504, 552, 48},
    {"teapot/default", SHD_SHAPE_TEAPOT, {0, 0, 0}, 2584, 4032, 128},
    {"teapot/17", SHD_SHAPE_TEAPOT, {17, 0, 0}, 10360, 18360, 272},
};

static void check_indices(const char *name, const struct filled *f)
{
    unsigned char *used = (unsigned char *)calloc(f->vertex_count, 1);
    size_t i;
    for (i = 0; i < f->index_count; ++i) {
        if (f->index[i] >= f->vertex_count) fail_msg("%s: index %zu is %u", name, i, f->index[i]);
        used[f->index[i]] = 1;
    }
    for (i = 0; i < f->vertex_count; ++i) {
        if (!used[i]) fail_msg("%s: no triangle has vertex %zu", name, i);
    }
    free(used);
}

/* Triangles have area, and uv have the same orientation: with v down, counter-clockwise triangles have a negative
 * area in uv. */
static void check_triangles(const char *name, const struct filled *f)
{
    size_t i;
    for (i = 0; i < f->index_count; i += 3) {
        const float *a = f->uv + 2 * (size_t)f->index[i], *b = f->uv + 2 * (size_t)f->index[i + 1];
        const float *c = f->uv + 2 * (size_t)f->index[i + 2];
        const double area =
            ((double)b[0] - a[0]) * ((double)c[1] - a[1]) - ((double)c[0] - a[0]) * ((double)b[1] - a[1]);
        long double n[3];
        shd_ref_cross(f->position, f->index + i, n);
        if (!(n[0] * n[0] + n[1] * n[1] + n[2] * n[2] > 0)) fail_msg("%s: triangle %zu has no area", name, i / 3);
        if (!(area < 0)) fail_msg("%s: triangle %zu has uv area %g", name, i / 3, area);
    }
}

static void check_normals(const char *name, const struct filled *f)
{
    size_t i;
    for (i = 0; i < f->vertex_count; ++i) {
        const float *n = f->normal + 3 * i;
        const double square = (double)n[0] * n[0] + (double)n[1] * n[1] + (double)n[2] * n[2];
        shd_assert_close(name, i, sqrt(square), 1, 6e-8, 0); /* three components rounded to float */
    }
}

static void test_shape(void **state)
{
    const struct shape_case *c = (const struct shape_case *)*state;
    const shd_shape_desc desc = shape_of(c->shape, c->segments[0], c->segments[1], c->segments[2]);
    struct filled f = fill(&desc);
    size_t i;
    assert_int_equal(f.vertex_count, c->vertices);
    assert_int_equal(f.index_count, 3 * (size_t)c->triangles);
    check_indices(c->name, &f);
    check_triangles(c->name, &f);
    check_normals(c->name, &f);
    assert_int_equal(count_open_edges(c->name, &f), c->open_edges);
    for (i = 0; i < 2 * (size_t)f.vertex_count && c->shape != SHD_SHAPE_TEAPOT; ++i) {
        assert_true(f.uv[i] >= 0 && f.uv[i] <= 1);
    }
    for (i = 0; i < 3 * (size_t)f.vertex_count; ++i) {
        assert_false(signbit(f.position[i]) && f.position[i] == 0); /* no -0: equal positions, equal bits */
    }
    drop(&f);
}

/* Vertices on the surface and their normals, by equations. */
static void test_equations(void **state)
{
    shd_shape_desc descs[] = {shape_of(SHD_SHAPE_SPHERE, 37, 23, 0), shape_of(SHD_SHAPE_TORUS, 41, 19, 0)};
    size_t k, i;
    int c;
    (void)state;
    descs[0].radius = 3.7f;
    descs[1].radius = 2.5f;
    descs[1].tube_radius = 1.125f;
    for (k = 0; k < 2; ++k) {
        struct filled f = fill(&descs[k]);
        for (i = 0; i < f.vertex_count; ++i) {
            long double n[3];
            const long double distance = shd_ref_shape_distance(&descs[k], f.position + 3 * i, n);
            shd_assert_close("distance", i, (double)distance, 0, 4e-7, 0);
            for (c = 0; c < 3; ++c) shd_assert_close("normal", i, f.normal[3 * i + (size_t)c], (double)n[c], 4e-7, 0);
        }
        drop(&f);
    }
}

/* Normals are on the front side of every triangle around their vertex. */
static void test_outwards(void **state)
{
    static const struct shape_case *c;
    size_t k, i;
    (void)state;
    for (k = 0; k < COUNT(k_shapes); ++k) {
        shd_shape_desc desc;
        struct filled f;
        c = &k_shapes[k];
        if (c->shape == SHD_SHAPE_TEAPOT && c->triangles < 4000) continue; /* too coarse */
        desc = shape_of(c->shape, c->segments[0], c->segments[1], c->segments[2]);
        f = fill(&desc);
        for (i = 0; i < f.index_count; ++i) {
            const float *n = f.normal + 3 * (size_t)f.index[i];
            long double face[3];
            shd_ref_cross(f.position, f.index + i - i % 3, face);
            if (!(face[0] * n[0] + face[1] * n[1] + face[2] * n[2] > 0)) {
                fail_msg("%s: corner %zu of triangle %zu", c->name, i % 3, i / 3);
            }
        }
        drop(&f);
    }
}

/* Areas and volumes. */

struct measure {
    long double area, volume;
};

static struct measure measure(shd_shape_desc desc, uint32_t a, uint32_t b)
{
    struct measure m;
    struct filled f;
    desc.segments[0] = a;
    desc.segments[1] = b;
    f = fill(&desc);
    m.area = shd_ref_mesh_area(f.position, f.index, f.index_count);
    m.volume = shd_ref_mesh_volume(f.position, f.index, f.index_count);
    drop(&f);
    return m;
}

/* Doubling the segments reduces the error to a quarter. */
static void check_convergence(const char *name, shd_shape_desc desc)
{
    const long double area = shd_ref_shape_area(&desc), volume = shd_ref_shape_volume(&desc);
    const struct measure coarse = measure(desc, 64, 32), fine = measure(desc, 128, 64);
    shd_assert_close(name, 0, (double)((area - coarse.area) / (area - fine.area)), 4, 0.02, 0);
    shd_assert_close(name, 1, (double)((volume - coarse.volume) / (volume - fine.volume)), 4, 0.02, 0);
    shd_assert_close(name, 2, (double)fine.area, (double)area, 0, 2e-3);
    shd_assert_close(name, 3, (double)fine.volume, (double)volume, 0, 4e-3);
}

static void test_measures(void **state)
{
    shd_shape_desc box = shape_of(SHD_SHAPE_BOX, 3, 4, 5), plane = shape_of(SHD_SHAPE_PLANE, 3, 0, 4);
    shd_shape_desc torus = shape_of(SHD_SHAPE_TORUS, 0, 0, 0), sphere = shape_of(SHD_SHAPE_SPHERE, 0, 0, 0);
    struct filled f;
    (void)state;
    sphere.radius = 1.5f;
    torus.radius = 2;
    torus.tube_radius = 0.75f;
    check_convergence("sphere", sphere);
    check_convergence("torus", torus);
    box.size[0] = plane.size[0] = 3;
    box.size[1] = 0.25f;
    box.size[2] = plane.size[2] = 7;
    f = fill(&box);
    shd_assert_close("box area", 0, (double)shd_ref_mesh_area(f.position, f.index, f.index_count),
                     (double)shd_ref_shape_area(&box), 0, 1e-6);
    shd_assert_close("box volume", 0, (double)shd_ref_mesh_volume(f.position, f.index, f.index_count),
                     (double)shd_ref_shape_volume(&box), 0, 1e-6);
    drop(&f);
    f = fill(&plane);
    shd_assert_close("plane area", 0, (double)shd_ref_mesh_area(f.position, f.index, f.index_count),
                     (double)shd_ref_shape_area(&plane), 0, 1e-6);
    drop(&f);
}

/* The teapot has no formula: its area and volume converge, and its position is as documented in the header. */
static void test_teapot(void **state)
{
    const shd_shape_desc desc = shape_of(SHD_SHAPE_TEAPOT, 0, 0, 0);
    const struct measure m[3] = {measure(desc, 16, 0), measure(desc, 32, 0), measure(desc, 64, 0)};
    struct filled f = fill(&desc);
    float low[3] = {9, 9, 9}, high[3] = {-9, -9, -9};
    size_t i;
    (void)state;
    shd_assert_close("area", 0, (double)((m[1].area - m[0].area) / (m[2].area - m[1].area)), 4, 0.2, 0);
    shd_assert_close("volume", 0, (double)((m[1].volume - m[0].volume) / (m[2].volume - m[1].volume)), 4, 0.2, 0);
    assert_true(m[2].volume > 10 && m[2].volume < 30);
    for (i = 0; i < 3 * (size_t)f.vertex_count; ++i) {
        low[i % 3] = fminf(low[i % 3], f.position[i]);
        high[i % 3] = fmaxf(high[i % 3], f.position[i]);
    }
    assert_true(low[1] == 0);
    assert_true(high[1] == 3.15f);
    shd_assert_close("spout", 0, high[0], 3.4349, 0.01, 0);
    shd_assert_close("handle", 0, low[0], -3, 0.03, 0);
    assert_true(high[2] == 2 && low[2] == -2);
    drop(&f);
}

/* Meshes accept shapes without changes: every vertex gets a tangent, and no seam needs additional vertices. */
static void test_tangents(void **state)
{
    shd_context *context = NULL;
    size_t k;
    int c;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    for (k = 0; k < COUNT(k_shapes); ++k) {
        const struct shape_case *s = &k_shapes[k];
        const shd_shape_desc desc = shape_of(s->shape, s->segments[0], s->segments[1], s->segments[2]);
        struct filled f = fill(&desc);
        shd_mesh_desc made = shd_mesh_desc_default();
        shd_mesh_info info = shd_mesh_info_default();
        shd_mesh *mesh = NULL;
        uint32_t splits; /* at most */
        made.vertex_count = f.vertex_count;
        made.indices.data = f.index;
        made.index_count = f.index_count;
        made.flags = SHD_MESH_TANGENTS;
        for (c = 0; c < 3; ++c) {
            made.position[c].data = f.position + c;
            made.normal[c].data = f.normal + c;
            made.position[c].stride = made.normal[c].stride = 3 * sizeof(float);
        }
        for (c = 0; c < 2; ++c) {
            made.uv[c].data = f.uv + c;
            made.uv[c].stride = 2 * sizeof(float);
        }
        shd_assert_ok(shd_mesh_create(context, &made, &mesh));
        shd_assert_ok(shd_mesh_get_info(mesh, &info));
        /* With two latitudes, a vertex on the equator has triangles of two longitudes that share no edge. */
        splits = s->shape == SHD_SHAPE_SPHERE && s->segments[1] == 2 ? s->segments[0] - 1 : 0;
        if (info.split_count > splits || info.tangentless_count || info.normalless_count) {
            fail_msg("%s: %u split, %u without tangent", s->name, info.split_count, info.tangentless_count);
        }
        shd_mesh_release(mesh);
        drop(&f);
    }
    shd_context_release(context);
}

/* Packed columns, some of them absent, get the same values as interleaved ones, and nothing is written beyond them. */
static void test_columns(void **state)
{
    size_t k, i;
    int absent, c;
    (void)state;
    for (k = 0; k < COUNT(k_shapes); ++k) {
        const struct shape_case *s = &k_shapes[k];
        const shd_shape_desc desc = shape_of(s->shape, s->segments[0], s->segments[1], s->segments[2]);
        struct filled f = fill(&desc);
        const size_t room = f.vertex_count + 1;
        float *packed = (float *)malloc(sizeof(float) * 8 * room);
        uint32_t *index = (uint32_t *)malloc(sizeof(uint32_t) * (f.index_count + 1));
        for (absent = -1; absent < 9; ++absent) {
            shd_shape_columns columns = shd_shape_columns_default();
            for (i = 0; i < 8 * room; ++i) packed[i] = -77;
            index[f.index_count] = 77;
            for (c = 0; c < 8; ++c) {
                shd_f32_out *column = c < 3   ? &columns.position[c]
                                      : c < 6 ? &columns.normal[c - 3]
                                              : &columns.uv[c - 6];
                if (c != absent) column->data = packed + (size_t)c * room;
            }
            columns.vertex_count = f.vertex_count;
            if (absent != 8) columns.indices.data = index;
            columns.index_count = absent == 8 ? 0 : f.index_count;
            shd_assert_ok(shd_shape_fill(&desc, &columns));
            for (c = 0; c < 8; ++c) {
                const float *want = c < 3 ? f.position + c : c < 6 ? f.normal + c - 3 : f.uv + c - 6;
                const size_t step = c < 6 ? 3 : 2;
                for (i = 0; i < f.vertex_count; ++i) {
                    assert_true(packed[(size_t)c * room + i] == (c == absent ? -77 : want[step * i]));
                }
                assert_true(packed[(size_t)c * room + f.vertex_count] == -77);
            }
            assert_memory_equal(index, f.index, sizeof(uint32_t) * f.index_count);
            assert_int_equal(index[f.index_count], 77);
        }
        free(packed);
        free(index);
        drop(&f);
    }
}

/* The largest counts are computed without making the shapes; one large shape is made. */
static void test_large(void **state)
{
    shd_shape_desc desc = shape_of(SHD_SHAPE_BOX, 4096, 4096, 4096);
    size_t vertices, indices;
    struct filled f;
    (void)state;
    shd_assert_ok(shd_shape_count(&desc, &vertices, &indices));
    assert_int_equal(vertices, 6 * 4097 * 4097);
    assert_int_equal(indices, (size_t)36 * 4096 * 4096);
    desc = shape_of(SHD_SHAPE_TEAPOT, 256, 0, 0);
    shd_assert_ok(shd_shape_count(&desc, &vertices, &indices));
    assert_int_equal(vertices, 32 * 257 * 257 - 8);
    desc = shape_of(SHD_SHAPE_SPHERE, 4096, 64, 0);
    f = fill(&desc);
    assert_int_equal(count_open_edges("large", &f), 0);
    drop(&f);
}

/* Refusals. */

static void edit_size(shd_shape_desc *d) { d->struct_size = 4; }
static void edit_shape(shd_shape_desc *d)
{
    const uint32_t unknown = 5;
    memcpy(&d->kind, &unknown, sizeof unknown);
}
static void edit_radius_0(shd_shape_desc *d) { d->radius = 0; }
static void edit_radius_nan(shd_shape_desc *d) { d->radius = (float)NAN; }
static void edit_radius_inf(shd_shape_desc *d) { d->radius = INFINITY; }
static void edit_around(shd_shape_desc *d) { d->segments[0] = 2; }
static void edit_down(shd_shape_desc *d) { d->segments[1] = 1; }
static void edit_many(shd_shape_desc *d) { d->segments[1] = 4097; }
static void edit_tube(shd_shape_desc *d)
{
    d->kind = SHD_SHAPE_TORUS;
    d->tube_radius = 1;
}
static void edit_tube_negative(shd_shape_desc *d)
{
    d->kind = SHD_SHAPE_TORUS;
    d->tube_radius = -0.5f;
}
static void edit_torus_tube_2(shd_shape_desc *d)
{
    d->kind = SHD_SHAPE_TORUS;
    d->segments[1] = 2;
}
static void edit_box(shd_shape_desc *d)
{
    d->kind = SHD_SHAPE_BOX;
    d->size[1] = -1;
}
static void edit_box_many(shd_shape_desc *d)
{
    d->kind = SHD_SHAPE_BOX;
    d->segments[2] = 5000;
}
static void edit_plane(shd_shape_desc *d)
{
    d->kind = SHD_SHAPE_PLANE;
    d->size[2] = 0;
}
static void edit_teapot_1(shd_shape_desc *d)
{
    d->kind = SHD_SHAPE_TEAPOT;
    d->segments[0] = 1;
}
static void edit_teapot(shd_shape_desc *d)
{
    d->kind = SHD_SHAPE_TEAPOT;
    d->segments[0] = 257;
}

struct refusal {
    const char *name;
    void (*edit)(shd_shape_desc *desc);
    const char *message;
};

static const struct refusal k_refusals[] = {
    {"refused/struct_size", edit_size, "shape.struct_size: 4"},
    {"refused/shape_5", edit_shape, "shape.kind: 5 is not in 0..4"},
    {"refused/radius_0", edit_radius_0, "shape.radius: 0 is not in 1e-30..1e+30"},
    {"refused/radius_nan", edit_radius_nan, "shape.radius: "},
    {"refused/radius_inf", edit_radius_inf, "shape.radius: inf"},
    {"refused/sphere_around_2", edit_around, "shape.segments[0]: 2 is not in 3..4096"},
    {"refused/sphere_down_1", edit_down, "shape.segments[1]: 1 is not in 2..4096"},
    {"refused/sphere_down_4097", edit_many, "shape.segments[1]: 4097 is not in 2..4096"},
    {"refused/tube_is_radius", edit_tube, "shape.tube_radius: 1 is not below radius 1"},
    {"refused/tube_negative", edit_tube_negative, "shape.tube_radius: -0.5"},
    {"refused/torus_tube_2", edit_torus_tube_2, "shape.segments[1]: 2 is not in 3..4096"},
    {"refused/box_size", edit_box, "shape.size[1]: -1"},
    {"refused/box_segments", edit_box_many, "shape.segments[2]: 5000 is not in 1..4096"},
    {"refused/plane_size", edit_plane, "shape.size[2]: 0"},
    {"refused/teapot_1", edit_teapot_1, "shape.segments[0]: 1 is not in 2..256"},
    {"refused/teapot_257", edit_teapot, "shape.segments[0]: 257 is not in 2..256"},
};

static void test_refusal(void **state)
{
    const struct refusal *r = (const struct refusal *)*state;
    shd_shape_desc desc = shd_shape_desc_default();
    shd_shape_columns columns = shd_shape_columns_default();
    size_t vertices = 7, indices = 7;
    r->edit(&desc);
    shd_assert_result(r->name, shd_shape_count(&desc, &vertices, &indices), BAD, r->message);
    assert_true(vertices == 0 && indices == 0);
    shd_assert_result(r->name, shd_shape_fill(&desc, &columns), BAD, r->message);
}

static void test_refused_columns(void **state)
{
    float room[600];
    uint32_t index[3000];
    shd_shape_columns columns = shd_shape_columns_default();
    size_t vertices, indices;
    (void)state;
    shd_assert_result("count", shd_shape_count(NULL, NULL, &indices), BAD, "out_vertex_count: NULL");
    shd_assert_result("count", shd_shape_count(NULL, &vertices, NULL), BAD, "out_index_count: NULL");
    shd_assert_result("fill", shd_shape_fill(NULL, NULL), BAD, "columns: NULL");
    room[0] = -77;
    columns.uv[1].data = room;
    columns.vertex_count = 558;
    shd_assert_result("fill", shd_shape_fill(NULL, &columns), BAD, "columns.vertex_count: 558 is not in 559..");
    columns.vertex_count = 600;
    columns.indices.data = index;
    columns.index_count = 2879;
    shd_assert_result("fill", shd_shape_fill(NULL, &columns), BAD, "columns.index_count: 2879 is not in 2880..");
    columns.index_count = 3000;
    columns.uv[1].stride = 5;
    shd_assert_result("fill", shd_shape_fill(NULL, &columns), BAD, "columns.uv[1].stride: 5");
    columns.uv[1].stride = 0;
    columns.struct_size = 4;
    shd_assert_result("fill", shd_shape_fill(NULL, &columns), BAD, "columns.struct_size: 4");
    assert_true(room[0] == -77);
    columns.struct_size = (uint32_t)sizeof columns;
    shd_assert_ok(shd_shape_fill(NULL, &columns));
    assert_true(room[0] == 0);
}

/* The bits: every machine and compiler must give them. */
static void test_bits(void **state)
{
    uint64_t hash = SHD_HASH_START;
    size_t k;
    (void)state;
    for (k = 0; k < COUNT(k_shapes); ++k) {
        const struct shape_case *s = &k_shapes[k];
        shd_shape_desc desc = shape_of(s->shape, s->segments[0], s->segments[1], s->segments[2]);
        struct filled f;
        desc.radius = 1.7f;
        desc.size[1] = 0.3f;
        f = fill(&desc);
        hash = shd_hash(hash, f.position, sizeof(float) * 3 * f.vertex_count);
        hash = shd_hash(hash, f.normal, sizeof(float) * 3 * f.vertex_count);
        hash = shd_hash(hash, f.uv, sizeof(float) * 2 * f.vertex_count);
        hash = shd_hash(hash, f.index, sizeof(uint32_t) * f.index_count);
        drop(&f);
    }
    assert_int_equal(hash, 0x79e69dcbac15b1d9ull);
}

int main(void)
{
    static struct CMUnitTest tests[COUNT(k_shapes) + COUNT(k_refusals) + 12];
    size_t n = 0, i;
    for (i = 0; i < COUNT(k_shapes); ++i) {
        tests[n++] = (struct CMUnitTest){k_shapes[i].name, test_shape, NULL, NULL, (void *)&k_shapes[i]};
    }
    for (i = 0; i < COUNT(k_refusals); ++i) {
        tests[n++] = (struct CMUnitTest){k_refusals[i].name, test_refusal, NULL, NULL, (void *)&k_refusals[i]};
    }
    tests[n++] = (struct CMUnitTest){"refused/columns", test_refused_columns, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"equations", test_equations, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"outwards", test_outwards, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"measures", test_measures, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"teapot", test_teapot, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"tangents", test_tangents, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"columns", test_columns, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"large", test_large, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"bits", test_bits, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.shapes", tests, n, NULL, NULL);
}
