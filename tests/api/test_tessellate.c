/* SPDX-License-Identifier: MIT */
/* shd_mesh_tessellate: every field of the desc, limits before memory, displacement against lookups, closed meshes that
   stay closed, normals and seams, the same bits for any worker count and target, and allocations that fail. */
#define _POSIX_C_SOURCE 200809L
#include "support/fault_allocator.h"
#include "support/pool.h"

#include <shd/shd.h>

#define BAD SHD_ERROR_INVALID_ARGUMENT
enum { COLUMNS = 12, TEXELS = 16 };

static shd_context *g_context;

/* A mesh read back; free with drop(). */
struct readback {
    uint32_t vertex_count, triangle_count;
    float *column[COLUMNS]; /* position, normal, uv, tangent */
    uint32_t *index;
};

static struct readback read_mesh(const shd_mesh *mesh)
{
    struct readback r;
    shd_mesh_info info = shd_mesh_info_default();
    shd_f32_out out[COLUMNS];
    shd_u32_out index;
    int c;
    shd_assert_ok(shd_mesh_get_info(mesh, &info));
    r.vertex_count = info.vertex_count;
    r.triangle_count = info.triangle_count;
    for (c = 0; c < COLUMNS; ++c) {
        r.column[c] = (float *)malloc(sizeof(float) * (info.vertex_count + 1));
        out[c].data = r.column[c];
        out[c].stride = 0;
    }
    r.index = (uint32_t *)malloc(sizeof(uint32_t) * (3 * (size_t)info.triangle_count + 1));
    index.data = r.index;
    index.stride = 0;
    shd_assert_ok(shd_mesh_read_positions(mesh, out));
    shd_assert_ok(shd_mesh_read_normals(mesh, out + 3));
    shd_assert_ok(shd_mesh_read_uv(mesh, out + 6));
    shd_assert_ok(shd_mesh_read_tangents(mesh, out + 8));
    shd_assert_ok(shd_mesh_read_indices(mesh, &index));
    return r;
}

static void drop(struct readback *r)
{
    int c;
    for (c = 0; c < COLUMNS; ++c) free(r->column[c]);
    free(r->index);
}

static uint64_t hash_mesh(const shd_mesh *mesh)
{
    struct readback r = read_mesh(mesh);
    uint64_t hash = SHD_HASH_START;
    int c;
    for (c = 0; c < COLUMNS; ++c) hash = shd_hash(hash, r.column[c], sizeof(float) * r.vertex_count);
    hash = shd_hash(hash, r.index, sizeof(uint32_t) * 3 * r.triangle_count);
    drop(&r);
    return hash;
}

/* The square [0, 1]^2 at z = 0 as two triangles, with v down as in a picture. */
static shd_mesh *make_square(shd_context *context, uint32_t flags)
{
    static const float k_rows[4][8] = {
        {0, 0, 0, 0, 0, 1, 0, 1}, {1, 0, 0, 0, 0, 1, 1, 1}, {1, 1, 0, 0, 0, 1, 1, 0}, {0, 1, 0, 0, 0, 1, 0, 0}};
    static const uint32_t k_indices[6] = {0, 1, 2, 0, 2, 3};
    shd_mesh_desc desc = shd_mesh_desc_default();
    shd_mesh *mesh = NULL;
    int c;
    desc.vertex_count = 4;
    for (c = 0; c < 8; ++c) {
        shd_f32_in *column = c < 3 ? &desc.position[c] : c < 6 ? &desc.normal[c - 3] : &desc.uv[c - 6];
        column->data = &k_rows[0][c];
        column->stride = sizeof k_rows[0];
    }
    desc.indices.data = k_indices;
    desc.index_count = 6;
    desc.flags = flags;
    shd_assert_ok(shd_mesh_create(context, &desc, &mesh));
    return mesh;
}

/* A cube of six sides, each with its own vertices, normal and uv; with `smooth`, normals point away from the middle. */
static shd_mesh *make_cube(shd_context *context, int smooth)
{
    float rows[24][8];
    uint32_t indices[36];
    shd_mesh_desc desc = shd_mesh_desc_default();
    shd_mesh *mesh = NULL;
    uint32_t n = 0, i = 0;
    int axis, sign, k, c;
    memset(rows, 0, sizeof rows);
    for (axis = 0; axis < 3; ++axis) {
        for (sign = -1; sign <= 1; sign += 2) {
            const uint32_t quad[6] = {n, n + 1, n + 2, n, n + 2, n + 3};
            memcpy(indices + i, quad, sizeof quad);
            i += 6;
            for (k = 0; k < 4; ++k, ++n) {
                const float a = k == 1 || k == 2 ? 1.0f : -1.0f, b = k >= 2 ? 1.0f : -1.0f;
                rows[n][axis] = (float)sign;
                rows[n][(axis + 1) % 3] = (float)sign * a;
                rows[n][(axis + 2) % 3] = b;
                rows[n][3 + axis] = (float)sign;
                if (smooth) memcpy(rows[n] + 3, rows[n], 3 * sizeof(float));
                rows[n][6] = 0.5f + 0.5f * a;
                rows[n][7] = 0.5f + 0.5f * b;
            }
        }
    }
    desc.vertex_count = 24;
    for (c = 0; c < 8; ++c) {
        shd_f32_in *column = c < 3 ? &desc.position[c] : c < 6 ? &desc.normal[c - 3] : &desc.uv[c - 6];
        column->data = &rows[0][c];
        column->stride = sizeof rows[0];
    }
    desc.indices.data = indices;
    desc.index_count = 36;
    desc.flags = SHD_MESH_TANGENTS;
    shd_assert_ok(shd_mesh_create(context, &desc, &mesh));
    return mesh;
}

/* Heights: `value` everywhere, or with `noise` anything in [0, 1). */
static shd_texture *make_heights(shd_context *context, float value, int noise)
{
    float texels[TEXELS * TEXELS];
    shd_texture_desc desc = shd_texture_desc_default();
    shd_texture *texture = NULL;
    uint64_t state = 5;
    int i;
    for (i = 0; i < TEXELS * TEXELS; ++i) {
        state = state * 6364136223846793005ull + 1442695040888963407ull;
        texels[i] = noise ? (float)(state >> 40) / 16777216.0f : value;
    }
    desc.format = SHD_FORMAT_R32F;
    desc.width = desc.height = TEXELS;
    desc.texels = texels;
    shd_assert_ok(shd_texture_create(context, &desc, &texture));
    return texture;
}

static shd_tessellation_desc uniform(uint32_t segments)
{
    shd_tessellation_desc desc = shd_tessellation_desc_default();
    desc.segments = segments;
    return desc;
}

static shd_mesh *tessellated(shd_context *context, const shd_mesh *mesh, const shd_tessellation_desc *desc)
{
    shd_mesh *out = NULL;
    shd_assert_ok(shd_mesh_tessellate(context, mesh, desc, &out));
    return out;
}

/* Refusals. */

static shd_view g_view;
static float g_matrix[16];
static void nothing(shd_tessellation_desc *d) { (void)d; }
static void size_0(shd_tessellation_desc *d) { d->struct_size = 0; }
static void mode_2(shd_tessellation_desc *d) { d->mode = (shd_tessellation_mode)2; }
static void segments_0(shd_tessellation_desc *d) { d->segments = 0; }
static void segments_1025(shd_tessellation_desc *d) { d->segments = 1025; }
static void segments_max(shd_tessellation_desc *d) { d->segments = 0xffffffffu; }
static void max_segments_0(shd_tessellation_desc *d) { d->max_segments = 0; }
static void max_segments_1025(shd_tessellation_desc *d) { d->max_segments = 1025; }
static void edge_length_0(shd_tessellation_desc *d) { d->edge_length = 0; }
static void edge_length_nan(shd_tessellation_desc *d) { d->edge_length = (float)NAN; }
static void edge_length_inf(shd_tessellation_desc *d) { d->edge_length = (float)INFINITY; }
static void height_0(shd_tessellation_desc *d) { d->picture_width = 1; }
static void height_65537(shd_tessellation_desc *d)
{
    d->picture_width = 1;
    d->picture_height = 65537;
}
static void normals_3(shd_tessellation_desc *d) { d->normals = (shd_displaced_normals)3; }
static void max_triangles_0(shd_tessellation_desc *d) { d->max_triangles = 0; }
static void max_triangles_max(shd_tessellation_desc *d) { d->max_triangles = UINT32_MAX; }
static void amplitude_1e30(shd_tessellation_desc *d) { d->amplitude = 1e30f; }
static void amplitude_nan(shd_tessellation_desc *d) { d->amplitude = (float)NAN; }
static void amplitude_minus_inf(shd_tessellation_desc *d) { d->amplitude = -(float)INFINITY; }
static void offset_nan(shd_tessellation_desc *d) { d->offset = (float)NAN; }
static void offset_2e12(shd_tessellation_desc *d) { d->offset = 2e12f; }
static void lod_33(shd_tessellation_desc *d) { d->lod = 33; }
static void view_nan(shd_tessellation_desc *d)
{
    g_view.view_to_clip[7] = (float)NAN;
    d->view = g_view;
}
static void matrix_inf(shd_tessellation_desc *d)
{
    g_matrix[3] = (float)INFINITY;
    memcpy(d->object_to_world, g_matrix, sizeof d->object_to_world);
}
static void foreign_texture(shd_tessellation_desc *d) { d->displacement = (const shd_texture *)g_matrix; }
static void foreign_sampler(shd_tessellation_desc *d) { d->sampler = (const shd_sampler *)g_matrix; }
static void too_many_uniform(shd_tessellation_desc *d)
{
    d->segments = 10;
    d->max_triangles = 199;
}
static void too_many_of_1024(shd_tessellation_desc *d)
{
    d->segments = 1024;
    d->max_triangles = 2097151;
}
static void too_many_adaptive(shd_tessellation_desc *d)
{
    d->mode = SHD_TESSELLATION_MODE_ADAPTIVE;
    d->edge_length = 1e-30f;
    d->max_segments = 1024;
    d->max_triangles = 1000000;
}

static const struct refusal {
    const char *name;
    void (*edit)(shd_tessellation_desc *desc);
    const char *message;
} k_refusals[] = {
    {"refused/struct_size_0", size_0, "tessellation.struct_size: 0"},
    {"refused/mode_2", mode_2, "tessellation.mode: 2 is not in 0..1"},
    {"refused/segments_0", segments_0, "tessellation.segments: 0 is not in 1..1024"},
    {"refused/segments_1025", segments_1025, "tessellation.segments: 1025 is not in 1..1024"},
    {"refused/segments_2^32-1", segments_max, "tessellation.segments: 4294967295 is not in 1..1024"},
    {"refused/max_segments_0", max_segments_0, "tessellation.max_segments: 0 is not in 1..1024"},
    {"refused/max_segments_1025", max_segments_1025, "tessellation.max_segments: 1025 is not in 1..1024"},
    {"refused/edge_length_0", edge_length_0, "tessellation.edge_length: 0 is not above 0"},
    {"refused/edge_length_nan", edge_length_nan, "tessellation.edge_length: nan is not above 0"},
    {"refused/edge_length_inf", edge_length_inf, "tessellation.edge_length: inf is not above 0"},
    {"refused/height_0", height_0, "tessellation.picture_height: 0 is not in 1..65536"},
    {"refused/height_65537", height_65537, "tessellation.picture_height: 65537 is not in 1..65536"},
    {"refused/normals_3", normals_3, "tessellation.normals: 3 is not in 0..2"},
    {"refused/max_triangles_0", max_triangles_0, "tessellation.max_triangles: 0 is not in 1..268435456"},
    {"refused/max_triangles_uint32_max", max_triangles_max, "tessellation.max_triangles: 4294967295 is not in"},
    {"refused/amplitude_1e30", amplitude_1e30, "tessellation.amplitude: 1e+30 is not in -1e+12..1e+12"},
    {"refused/amplitude_nan", amplitude_nan, "tessellation.amplitude: nan is not in -1e+12..1e+12"},
    {"refused/amplitude_-inf", amplitude_minus_inf, "tessellation.amplitude: -inf is not in"},
    {"refused/offset_nan", offset_nan, "tessellation.offset: nan is not in"},
    {"refused/offset_2e12", offset_2e12, "tessellation.offset: 2e+12 is not in"},
    {"refused/lod_33", lod_33, "tessellation.lod: 33 is not in -32..32"},
    {"refused/view_nan", view_nan, "tessellation.view.view_to_clip[7]: nan"},
    {"refused/object_to_world_inf", matrix_inf, "tessellation.object_to_world[3]: inf"},
    {"refused/displacement_is_no_texture", foreign_texture, "tessellation.displacement: not a live handle"},
    {"refused/sampler_is_no_sampler", foreign_sampler, "tessellation.sampler: not a live handle"},
    {"refused/200_triangles_of_199", too_many_uniform,
     "tessellation.max_triangles: 199, but the 2 triangles become 200"},
    {"refused/2^21_triangles_of_2^21-1", too_many_of_1024,
     "tessellation.max_triangles: 2097151, but the 2 triangles become 2097152"},
    {"refused/adaptive_above_a_million", too_many_adaptive,
     "tessellation.max_triangles: 1000000, but the 2 triangles become at least 10"},
};

static void test_refusal(void **state)
{
    const struct refusal *c = (const struct refusal *)*state;
    shd_fault_allocator memory;
    shd_context_desc context_desc = shd_fault_context_desc(&memory);
    shd_context *context = NULL;
    shd_tessellation_desc desc = shd_tessellation_desc_default();
    shd_mesh *mesh, *out = (shd_mesh *)&desc;
    memset(&memory, 0, sizeof memory);
    memset(&g_view, 0, sizeof g_view);
    memset(g_matrix, 0, sizeof g_matrix);
    shd_assert_ok(shd_context_create(&context_desc, &context));
    mesh = make_square(context, 0);
    c->edit(&desc);
    shd_fault_arm(&memory, 0, 0);
    shd_assert_result(c->name, shd_mesh_tessellate(context, mesh, &desc, &out), BAD, c->message);
    assert_null(out);
    assert_int_equal(memory.calls, 0); /* before anything is allocated */
    shd_mesh_release(mesh);
    shd_context_release(context);
    shd_assert_all_freed(c->name, &memory);
}

static void test_null(void **state)
{
    shd_tessellation_desc desc = shd_tessellation_desc_default();
    shd_mesh *mesh = make_square(g_context, 0), *out = (shd_mesh *)&desc;
    (void)state;
    nothing(&desc);
    shd_assert_result("context", shd_mesh_tessellate(NULL, mesh, &desc, &out), BAD, "context: NULL");
    assert_null(out);
    shd_assert_result("mesh", shd_mesh_tessellate(g_context, NULL, &desc, &out), BAD, "mesh: NULL");
    shd_assert_result("desc", shd_mesh_tessellate(g_context, mesh, NULL, &out), BAD, "tessellation: NULL");
    shd_assert_result("out", shd_mesh_tessellate(g_context, mesh, &desc, NULL), BAD, "out_mesh: NULL");
    shd_mesh_release(mesh);
}

/* A sampler whose filter needs a table that the texture lacks is refused, as in a lookup. */
static void test_missing_table(void **state)
{
    shd_sampler_desc sampler_desc = shd_sampler_desc_default();
    shd_sampler *sampler = NULL;
    shd_texture *heights = make_heights(g_context, 1, 0);
    shd_tessellation_desc desc = uniform(2);
    shd_mesh *mesh = make_square(g_context, 0), *out = NULL;
    (void)state;
    sampler_desc.filter = SHD_FILTER_RIPMAP;
    shd_assert_ok(shd_sampler_create(g_context, &sampler_desc, &sampler));
    desc.displacement = heights;
    desc.sampler = sampler;
    desc.amplitude = 1;
    shd_assert_result("ripmap", shd_mesh_tessellate(g_context, mesh, &desc, &out), BAD, "RIPMAP");
    assert_null(out);
    shd_mesh_release(mesh);
    shd_texture_release(heights);
    shd_sampler_release(sampler);
}

/* With one part for each edge and without displacement, the result is the mesh itself. */
static void test_identity(void **state)
{
    shd_mesh *mesh = make_cube(g_context, 1), *out;
    shd_texture *heights = make_heights(g_context, 0, 1);
    shd_tessellation_desc desc = uniform(1);
    (void)state;
    out = tessellated(g_context, mesh, &desc);
    assert_true(hash_mesh(out) == hash_mesh(mesh));
    shd_mesh_release(out);
    desc.displacement = heights; /* amplitude 0 */
    out = tessellated(g_context, mesh, &desc);
    assert_true(hash_mesh(out) == hash_mesh(mesh));
    shd_mesh_release(out);
    shd_mesh_release(mesh);
    shd_texture_release(heights);
}

static void test_empty(void **state)
{
    shd_mesh_desc mesh_desc = shd_mesh_desc_default();
    shd_texture *heights = make_heights(g_context, 0, 1);
    shd_tessellation_desc desc = uniform(1024);
    shd_mesh *mesh = NULL, *out;
    shd_mesh_info info = shd_mesh_info_default();
    (void)state;
    desc.displacement = heights;
    desc.amplitude = 1;
    shd_assert_ok(shd_mesh_create(g_context, &mesh_desc, &mesh));
    out = tessellated(g_context, mesh, &desc);
    shd_assert_ok(shd_mesh_get_info(out, &info));
    assert_true(info.vertex_count == 0 && info.triangle_count == 0);
    shd_mesh_release(out);
    shd_mesh_release(mesh);
    shd_texture_release(heights);
}

/* Heights of a square are amplitude * (lookup - offset); a square of n parts has (n + 1)^2 vertices. */
static void test_heights(void **state)
{
    shd_mesh *mesh = make_square(g_context, SHD_MESH_TANGENTS), *out;
    shd_texture *heights = make_heights(g_context, 0, 1);
    shd_sampler *sampler = NULL;
    shd_sampler_desc sampler_desc = shd_sampler_desc_default();
    shd_tessellation_desc desc = uniform(37);
    struct readback r;
    float *want;
    uint32_t i;
    (void)state;
    sampler_desc.filter = SHD_FILTER_BICUBIC;
    sampler_desc.wrap_u = sampler_desc.wrap_v = SHD_WRAP_MIRROR;
    shd_assert_ok(shd_sampler_create(g_context, &sampler_desc, &sampler));
    desc.displacement = heights;
    desc.sampler = sampler;
    desc.amplitude = -0.75f;
    desc.offset = 0.25f;
    desc.normals = SHD_DISPLACED_NORMALS_KEPT;
    out = tessellated(g_context, mesh, &desc);
    r = read_mesh(out);
    assert_int_equal(r.vertex_count, 38 * 38);
    want = (float *)malloc(sizeof(float) * r.vertex_count);
    {
        shd_lookups lookups = shd_lookups_default();
        shd_texels texels;
        memset(&texels, 0, sizeof texels);
        lookups.count = r.vertex_count;
        lookups.u.data = r.column[6];
        lookups.v.data = r.column[7];
        texels.channel[0].data = want;
        shd_assert_ok(shd_texture_sample(heights, sampler, &lookups, &texels));
    }
    for (i = 0; i < r.vertex_count; ++i) {
        shd_assert_close("u", i, r.column[6][i], r.column[0][i], 1e-7, 0);
        shd_assert_close("v", i, r.column[7][i], 1 - (double)r.column[1][i], 1e-7, 0);
        shd_assert_close("z", i, r.column[2][i], -0.75 * ((double)want[i] - 0.25), 1e-7, 1e-7);
        assert_true(r.column[5][i] == 1.0f && r.column[8][i] == 1.0f && r.column[11][i] == 1.0f);
    }
    free(want);
    drop(&r);
    shd_mesh_release(out);
    shd_mesh_release(mesh);
    shd_sampler_release(sampler);
    shd_texture_release(heights);
}

/* A ramp: the whole surface has one normal, and tangents lie in the surface. */
static void test_normals_of_a_ramp(void **state)
{
    static const float k_ramp[2] = {-0.5f, 1.5f}; /* u between the centres of two texels */
    shd_texture_desc texture_desc = shd_texture_desc_default();
    shd_texture *ramp = NULL;
    shd_sampler_desc sampler_desc = shd_sampler_desc_default();
    shd_sampler *sampler = NULL;
    shd_tessellation_desc desc = uniform(8);
    shd_mesh *mesh = make_square(g_context, SHD_MESH_TANGENTS), *out;
    struct readback r;
    uint32_t i;
    int c;
    (void)state;
    texture_desc.format = SHD_FORMAT_R32F;
    texture_desc.width = 2;
    texture_desc.height = 1;
    texture_desc.texels = k_ramp;
    shd_assert_ok(shd_texture_create(g_context, &texture_desc, &ramp));
    sampler_desc.wrap_u = SHD_WRAP_CLAMP;
    shd_assert_ok(shd_sampler_create(g_context, &sampler_desc, &sampler));
    desc.displacement = ramp;
    desc.sampler = sampler;
    desc.amplitude = 0.25f; /* slope 0.25 * 2 / 0.5 = 1 between u = 1/4 and 3/4, flat beside */
    out = tessellated(g_context, mesh, &desc);
    r = read_mesh(out);
    for (i = 0; i < r.vertex_count; ++i) {
        const double half = sqrt(0.5), u = (double)r.column[6][i];
        const int inside = u > 0.26 && u < 0.74, beside = u < 0.24 || u > 0.76;
        const double want[6] = {inside ? -half : 0, 0, inside ? half : 1, inside ? half : 1, 0, inside ? half : 0};
        for (c = 0; c < 6 && (inside || beside); ++c) {
            shd_assert_close("frame", 6 * i + (uint32_t)c, r.column[c < 3 ? 3 + c : 5 + c][i], want[c], 1e-6, 0);
        }
    }
    drop(&r);
    shd_mesh_release(out);
    shd_mesh_release(mesh);
    shd_sampler_release(sampler);
    shd_texture_release(ramp);
}

/* A constant height leaves TILTED normals where they were; normals of FACES are those that a mesh of the displaced
   vertices computes by area. */
static void test_normals_of_options(void **state)
{
    shd_mesh *square = make_square(g_context, 0), *cube = make_cube(g_context, 1), *a, *b, *again = NULL;
    shd_texture *constant = make_heights(g_context, 0.5f, 0), *noise = make_heights(g_context, 0, 1);
    shd_tessellation_desc desc = uniform(13);
    shd_mesh_desc mesh_desc = shd_mesh_desc_default();
    struct readback r, kept;
    uint32_t i, c;
    (void)state;
    desc.amplitude = 0.4f;
    desc.displacement = constant;
    a = tessellated(g_context, cube, &desc);
    desc.normals = SHD_DISPLACED_NORMALS_KEPT;
    b = tessellated(g_context, cube, &desc);
    r = read_mesh(a);
    kept = read_mesh(b);
    for (i = 0; i < r.vertex_count; ++i) {
        for (c = 0; c < 6; ++c) shd_assert_close("tilted", 6 * i + c, r.column[c][i], kept.column[c][i], 3e-7, 0);
    }
    drop(&r);
    drop(&kept);
    shd_mesh_release(a);
    shd_mesh_release(b);

    desc.displacement = noise;
    desc.normals = SHD_DISPLACED_NORMALS_FACES;
    a = tessellated(g_context, square, &desc);
    r = read_mesh(a);
    mesh_desc.vertex_count = r.vertex_count;
    for (c = 0; c < 3; ++c) mesh_desc.position[c].data = r.column[c];
    mesh_desc.indices.data = r.index;
    mesh_desc.index_count = 3 * (size_t)r.triangle_count;
    shd_assert_ok(shd_mesh_create(g_context, &mesh_desc, &again));
    kept = read_mesh(again);
    for (i = 0; i < r.vertex_count; ++i) {
        for (c = 3; c < 6; ++c) shd_assert_close("faces", 3 * i + c, r.column[c][i], kept.column[c][i], 1.5e-7, 0);
    }
    drop(&r);
    drop(&kept);
    shd_mesh_release(a);
    shd_mesh_release(again);
    shd_mesh_release(square);
    shd_mesh_release(cube);
    shd_texture_release(constant);
    shd_texture_release(noise);
}

static int compare_sides(const void *a, const void *b) { return memcmp(a, b, 6 * sizeof(float)); }

/* Every edge, identified by the bits of its positions, occurs once in each direction. */
static void assert_closed(const char *name, const struct readback *r)
{
    const size_t count = 3 * (size_t)r->triangle_count;
    float(*sides)[6] = (float(*)[6])malloc(count * sizeof *sides);
    size_t i;
    int k;
    for (i = 0; i < count; ++i) {
        const uint32_t a = r->index[i], b = r->index[i % 3 == 2 ? i - 2 : i + 1];
        for (k = 0; k < 3; ++k) {
            sides[i][k] = r->column[k][a];
            sides[i][3 + k] = r->column[k][b];
        }
    }
    qsort(sides, count, sizeof *sides, compare_sides);
    for (i = 0; i < count; ++i) {
        float back[6];
        memcpy(back, sides[i] + 3, 3 * sizeof(float));
        memcpy(back + 3, sides[i], 3 * sizeof(float));
        if (i && !memcmp(sides[i], sides[i - 1], sizeof *sides)) fail_msg("%s: side %zu runs twice", name, i);
        if (!bsearch(back, sides, count, sizeof *sides, compare_sides)) fail_msg("%s: side %zu is open", name, i);
    }
    free(sides);
}

struct closed_case {
    const char *name;
    int smooth, noise, adaptive;
    shd_displaced_normals normals;
};
static const struct closed_case k_closed[] = {
    {"closed/creases_constant", 0, 0, 0, SHD_DISPLACED_NORMALS_TILTED},
    {"closed/creases_noise", 0, 1, 0, SHD_DISPLACED_NORMALS_TILTED},
    {"closed/creases_noise_kept", 0, 1, 0, SHD_DISPLACED_NORMALS_KEPT},
    {"closed/creases_noise_adaptive", 0, 1, 1, SHD_DISPLACED_NORMALS_TILTED},
    {"closed/smooth_constant", 1, 0, 0, SHD_DISPLACED_NORMALS_TILTED},
    {"closed/smooth_noise", 1, 1, 0, SHD_DISPLACED_NORMALS_TILTED},
    {"closed/smooth_noise_faces", 1, 1, 0, SHD_DISPLACED_NORMALS_FACES},
    {"closed/smooth_noise_adaptive", 1, 1, 1, SHD_DISPLACED_NORMALS_TILTED},
};

/* A cube whose sides meet in seams of uv, and of normals unless smooth, stays closed when displaced. If it is
 * smooth, normals are continuous across seams. */
static void test_closed(void **state)
{
    const struct closed_case *c = (const struct closed_case *)*state;
    shd_mesh *mesh = make_cube(g_context, c->smooth), *out;
    shd_texture *heights = make_heights(g_context, 0.5f, c->noise);
    shd_tessellation_desc desc = uniform(11);
    shd_camera camera = shd_camera_default();
    shd_view view;
    struct readback r;
    uint32_t i, k, met = 0;
    camera.eye[0] = 2.5f;
    camera.eye[1] = 1.0f;
    shd_assert_ok(shd_view_from_camera(&camera, &view));
    if (c->adaptive) {
        desc.mode = SHD_TESSELLATION_MODE_ADAPTIVE;
        desc.view = view;
        desc.edge_length = 20;
        desc.picture_width = desc.picture_height = 400;
    }
    desc.displacement = heights;
    desc.amplitude = 0.3f;
    desc.normals = c->normals;
    out = tessellated(g_context, mesh, &desc);
    r = read_mesh(out);
    assert_true(r.triangle_count > 500);
    assert_closed(c->name, &r);
    for (i = 0; i < r.vertex_count; ++i) {
        const double n[3] = {(double)r.column[3][i], (double)r.column[4][i], (double)r.column[5][i]};
        const double t[3] = {(double)r.column[8][i], (double)r.column[9][i], (double)r.column[10][i]};
        shd_assert_close("normal", i, n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 4e-7, 0);
        shd_assert_close("tangent", i, t[0] * t[0] + t[1] * t[1] + t[2] * t[2], 1, 4e-7, 0);
        for (k = 0; c->smooth && k < i && r.vertex_count < 2000; ++k) {
            if (r.column[0][i] != r.column[0][k] || r.column[1][i] != r.column[1][k]) continue;
            if (r.column[2][i] != r.column[2][k]) continue;
            ++met;
            assert_true(r.column[3][i] == r.column[3][k] && r.column[4][i] == r.column[4][k]);
            assert_true(r.column[5][i] == r.column[5][k]);
        }
    }
    if (c->smooth && !c->adaptive) assert_true(met > 100);
    drop(&r);
    shd_mesh_release(out);
    shd_mesh_release(mesh);
    shd_texture_release(heights);
}

struct height_case {
    const char *name;
    float texel, amplitude, offset, want;
};
static const struct height_case k_heights[] = {
    {"height/1_times_2", 1, 2, 0, 2},
    {"height/offset", 0.5f, 2, 1, -1},
    {"height/nan_is_0", (float)NAN, 1, 0, 0},
    {"height/inf_is_0", INFINITY, 1, 0, 0},
    {"height/3e38_times_1", 3e38f, 1, 0, 3e38f},
    {"height/3e38_times_1e12_is_0", 3e38f, 1e12f, 0, 0},
    {"height/amplitude_1e12", 1, 1e12f, 0, 1e12f},
    {"height/denormal", 1e-40f, 1, 0, 1e-40f},
};

static void test_height(void **state)
{
    const struct height_case *c = (const struct height_case *)*state;
    shd_mesh *mesh = make_square(g_context, 0), *out;
    shd_texture *heights = make_heights(g_context, c->texel, 0);
    shd_tessellation_desc desc = uniform(3);
    struct readback r;
    shd_mesh_info info = shd_mesh_info_default();
    uint32_t i;
    desc.displacement = heights;
    desc.amplitude = c->amplitude;
    desc.offset = c->offset;
    out = tessellated(g_context, mesh, &desc);
    shd_assert_ok(shd_mesh_get_info(out, &info));
    assert_int_equal(info.nonfinite_count, 0);
    r = read_mesh(out);
    for (i = 0; i < r.vertex_count; ++i) {
        shd_assert_close(c->name, i, r.column[2][i], c->want, 1e-44, 2e-7);
        shd_assert_close("normal", i, r.column[5][i], 1, 1e-6, 0);
    }
    drop(&r);
    shd_mesh_release(out);
    shd_mesh_release(mesh);
    shd_texture_release(heights);
}

/* Vertices that are not finite stay unchanged, and do not affect others. */
static void test_nonfinite(void **state)
{
    static const float k_x[4] = {0, 1, 0, (float)NAN}, k_y[4] = {0, 0, 1, 1}, k_z[4] = {0, 0, 0, INFINITY};
    static const uint32_t k_indices[9] = {0, 1, 2, 2, 1, 3, 3, 3, 0};
    shd_mesh_desc mesh_desc = shd_mesh_desc_default();
    shd_texture *heights = make_heights(g_context, 1, 0);
    shd_mesh *mesh = NULL, *out;
    int adaptive;
    (void)state;
    mesh_desc.vertex_count = 4;
    mesh_desc.position[0].data = k_x;
    mesh_desc.position[1].data = k_y;
    mesh_desc.position[2].data = k_z;
    mesh_desc.indices.data = k_indices;
    mesh_desc.index_count = 9;
    mesh_desc.flags = SHD_MESH_KEEP_NONFINITE | SHD_MESH_TANGENTS;
    shd_assert_ok(shd_mesh_create(g_context, &mesh_desc, &mesh));
    for (adaptive = 0; adaptive < 2; ++adaptive) {
        shd_tessellation_desc desc = uniform(6);
        struct readback r;
        uint32_t t, k;
        desc.mode = adaptive ? SHD_TESSELLATION_MODE_ADAPTIVE : SHD_TESSELLATION_MODE_UNIFORM;
        desc.edge_length = 0.2f;
        desc.displacement = heights;
        desc.amplitude = 1;
        out = tessellated(g_context, mesh, &desc);
        r = read_mesh(out);
        for (t = 0; t < (adaptive ? 25u : 36u); ++t) {
            for (k = 0; k < 3; ++k) {
                const uint32_t v = r.index[3 * t + k];
                shd_assert_close("z", v, r.column[2][v], 1, 1e-6, 0);
            }
        }
        drop(&r);
        shd_mesh_release(out);
    }
    shd_mesh_release(mesh);
    shd_texture_release(heights);
}

/* Vertices on an edge between different handedness have either, and no value between. */
static void test_handedness(void **state)
{
    static const float k_rows[4][12] = {{0, 0, 0, 0, 0, 1, 0, 1, 1, 0, 0, 1},
                                        {1, 0, 0, 0, 0, 1, 1, 1, 1, 0, 0, -1},
                                        {1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 0, -1},
                                        {0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 1}};
    static const uint32_t k_indices[6] = {0, 1, 2, 0, 2, 3};
    shd_mesh_desc mesh_desc = shd_mesh_desc_default();
    const shd_tessellation_desc desc = uniform(5);
    shd_mesh *mesh = NULL, *out;
    struct readback r;
    uint32_t i, negative = 0;
    int c;
    (void)state;
    mesh_desc.vertex_count = 4;
    for (c = 0; c < 12; ++c) {
        shd_f32_in *column = c < 3   ? &mesh_desc.position[c]
                             : c < 6 ? &mesh_desc.normal[c - 3]
                             : c < 8 ? &mesh_desc.uv[c - 6]
                                     : &mesh_desc.tangent[c - 8];
        *column = shd_f32_column(&k_rows[0][c], sizeof k_rows[0]);
    }
    mesh_desc.indices.data = k_indices;
    mesh_desc.index_count = 6;
    shd_assert_ok(shd_mesh_create(g_context, &mesh_desc, &mesh));
    out = tessellated(g_context, mesh, &desc);
    r = read_mesh(out);
    assert_int_equal(r.vertex_count, 36);
    for (i = 0; i < r.vertex_count; ++i) {
        const float tw = r.column[11][i];
        if (tw != 1.0f && tw != -1.0f) fail_msg("vertex %u: tw %g", i, (double)tw);
        negative += tw < 0;
    }
    assert_int_equal(negative, 18); /* the half with x > 0.5 */
    drop(&r);
    shd_mesh_release(out);
    shd_mesh_release(mesh);
}

/* Results have the same bits for every worker count and SIMD target. */
static void test_bits(void **state)
{
    uint64_t want = 0;
    size_t run;
    (void)state;
    for (run = 0; run < 4 + SHD_SIMD_WASM - SHD_SIMD_SCALAR + 1; ++run) {
        static const uint32_t k_workers[4] = {1, 2, 3, 16};
        static shd_pool pool = {0, SHD_POOL_RANDOM, 3};
        shd_context_desc context_desc = shd_context_desc_default();
        shd_context *context = NULL;
        shd_mesh *mesh, *out;
        shd_texture *heights;
        shd_tessellation_desc desc = uniform(90);
        uint64_t hash;
        if (run < 4) {
            pool.worker_count = k_workers[run];
            context_desc.executor.parallel_for = shd_pool_parallel_for;
            context_desc.executor.user_data = &pool;
            context_desc.executor.worker_count = pool.worker_count;
        } else {
            context_desc.simd = (shd_simd)(SHD_SIMD_SCALAR + (int)(run - 4));
        }
        if (shd_context_create(&context_desc, &context) != SHD_OK) continue;
        mesh = make_cube(context, 1);
        heights = make_heights(context, 0, 1);
        desc.displacement = heights;
        desc.amplitude = 0.2f;
        out = tessellated(context, mesh, &desc);
        hash = hash_mesh(out);
        if (run == 0) want = hash;
        assert_true(hash == want);
        shd_mesh_release(out);
        shd_mesh_release(mesh);
        shd_texture_release(heights);
        shd_context_release(context);
    }
}

/* Every allocation fails in turn. */
static void test_out_of_memory(void **state)
{
    shd_fault_allocator memory;
    shd_context_desc context_desc = shd_fault_context_desc(&memory);
    shd_context *context = NULL;
    shd_mesh *mesh, *out = NULL;
    shd_texture *heights;
    shd_tessellation_desc desc = uniform(5);
    size_t n, before;
    (void)state;
    memset(&memory, 0, sizeof memory);
    shd_assert_ok(shd_context_create(&context_desc, &context));
    mesh = make_cube(context, 1);
    heights = make_heights(context, 0, 1);
    desc.displacement = heights;
    desc.amplitude = 0.2f;
    before = memory.live_bytes;
    for (n = 1;; ++n) {
        shd_result result;
        shd_fault_arm(&memory, n, 0);
        result = shd_mesh_tessellate(context, mesh, &desc, &out);
        if (result == SHD_OK) break;
        shd_assert_result("tessellate", result, SHD_ERROR_OUT_OF_MEMORY, "out of memory");
        assert_null(out);
        assert_int_equal(memory.live_bytes, before);
    }
    assert_true(n > 30);
    shd_mesh_release(out);
    shd_mesh_release(mesh);
    shd_texture_release(heights);
    shd_context_release(context);
    shd_assert_all_freed("out_of_memory", &memory);
}

#define COUNT(table) (sizeof(table) / sizeof(table)[0])

int main(void)
{
    static struct CMUnitTest tests[COUNT(k_refusals) + COUNT(k_closed) + COUNT(k_heights) + 11];
    size_t n = 0, i;
    int failed;
    if (shd_context_create(NULL, &g_context) != SHD_OK) return 1;
    for (i = 0; i < COUNT(k_refusals); ++i) {
        tests[n++] = (struct CMUnitTest){k_refusals[i].name, test_refusal, NULL, NULL, (void *)&k_refusals[i]};
    }
    for (i = 0; i < COUNT(k_closed); ++i) {
        tests[n++] = (struct CMUnitTest){k_closed[i].name, test_closed, NULL, NULL, (void *)&k_closed[i]};
    }
    for (i = 0; i < COUNT(k_heights); ++i) {
        tests[n++] = (struct CMUnitTest){k_heights[i].name, test_height, NULL, NULL, (void *)&k_heights[i]};
    }
    tests[n++] = (struct CMUnitTest){"null_arguments", test_null, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"missing_table", test_missing_table, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"identity", test_identity, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"empty", test_empty, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"heights", test_heights, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"normals_of_a_ramp", test_normals_of_a_ramp, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"normals_of_options", test_normals_of_options, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"nonfinite", test_nonfinite, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"handedness", test_handedness, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"bits", test_bits, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"out_of_memory", test_out_of_memory, NULL, NULL, NULL};
    failed = _cmocka_run_group_tests("api.tessellate", tests, n, NULL, NULL);
    shd_context_release(g_context);
    return failed;
}
