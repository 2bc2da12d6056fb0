/* SPDX-License-Identifier: MIT */
/* Vertex programs: their inputs and outputs; an unchanged vertex keeps its bits. */
#include "support/frame.h"
#include "support/pool.h"
#include "support/scene.h"

/* Programs that change nothing: one does nothing, one writes the values that are already there. */
static void leave(const shd_vertices *in, shd_vertex_outputs *out, void *user_data)
{
    (void)in;
    (void)out;
    (void)user_data;
}
static void rewrite(const shd_vertices *in, shd_vertex_outputs *out, void *user_data)
{
    float *const columns[] = {out->x,  out->y,  out->z,  out->w,  out->px, out->py,
                              out->pz, out->nx, out->ny, out->nz, out->u,  out->v};
    size_t c, i;
    (void)user_data;
    for (c = 0; c < sizeof columns / sizeof columns[0]; ++c) {
        for (i = 0; i < in->count; ++i) columns[c][i] = columns[c][i] == 0 ? 0.0f : 1.0f * columns[c][i];
    }
}

static uint64_t hash_with(shd_scene_kind kind, shd_vertex_fn vertex)
{
    shd_context *context = NULL;
    shd_scene s;
    uint64_t hash;
    size_t step;
    shd_assert_ok(shd_context_create(NULL, &context));
    memset(&s, 0, sizeof s);
    s.kind = kind;
    s.vertex = vertex;
    s.context = context;
    for (step = 0; step < SHD_SCENE_STEPS; ++step) shd_assert_ok(shd_scene_step(&s, step));
    shd_scene_compose(&s);
    hash = shd_scene_render(&s);
    shd_scene_close(&s);
    shd_context_release(context);
    return hash;
}

static void test_identity(void **state)
{
    int kind;
    (void)state;
    for (kind = SHD_SCENE_MIXED; kind <= SHD_SCENE_GLASS; ++kind) {
        const uint64_t want = hash_with((shd_scene_kind)kind, NULL);
        if (hash_with((shd_scene_kind)kind, leave) != want) fail_msg("scene %d: other bits", kind);
        if (hash_with((shd_scene_kind)kind, rewrite) != want) fail_msg("scene %d, values written: other bits", kind);
    }
}

/* A program that computes positions on the screen without the positions of the mesh. */
static void full_screen(const shd_vertices *in, shd_vertex_outputs *out, void *user_data)
{
    static const float k_x[6] = {-1, 1, 1, -1, 1, -1}, k_y[6] = {-1, -1, 1, -1, 1, 1};
    const float w = *(const float *)user_data;
    size_t i;
    for (i = 0; i < in->count; ++i) {
        const size_t k = (in->first + i) % 6;
        out->x[i] = w * k_x[k];
        out->y[i] = w * k_y[k];
        out->z[i] = 0.25f * w;
        out->w[i] = w;
        out->px[i] = (float)k;
        out->py[i] = out->pz[i] = 7.0f;
        out->nx[i] = 3.0f;
        out->ny[i] = 0.0f;
        out->nz[i] = 4.0f;
        out->u[i] = 0.5f * (k_x[k] + 1.0f);
        out->v[i] = 0.5f * (1.0f - k_y[k]);
    }
}

static const float k_w[] = {1.0f, 0.001f, 1024.0f, 1e-15f, 1e15f};

static void test_full_screen(void **state)
{
    float w = *(const float *)*state;
    float vertices[6 * 8];
    shd_material_desc m = shd_frame_plain(0.5f, 0.25f, 1.0f);
    shd_frame f;
    size_t i;
    for (i = 0; i < 48; ++i) vertices[i] = 3.0f + (float)i;
    m.program.vertex = full_screen;
    m.program.user_data = &w;
    shd_frame_open(&f, 50, 30);
    shd_frame_draw(&f, vertices, 6, &m);
    shd_frame_ambient(&f);
    shd_frame_render(&f);
    assert_int_equal(f.stats.fragment_count, 50 * 30);
    for (i = 0; i < 50 * 30; ++i) {
        shd_assert_close("depth", i, (double)f.plane[SHD_PLANE_DEPTH][i], 0.25, 1e-6, 0);
        shd_assert_close("r", i, (double)f.plane[SHD_PLANE_R][i], 0.5, 1e-6, 0);
        shd_assert_close("u", i, (double)f.plane[SHD_PLANE_U][i], (i % 50 + 0.5) / 50, 2e-6, 0);
        shd_assert_close("v", i, (double)f.plane[SHD_PLANE_V][i], ((double)(i / 50) + 0.5) / 30, 2e-6, 0);
        shd_assert_close("nx", i, (double)f.plane[SHD_PLANE_NX][i], 0.6, 1e-6, 0);
        shd_assert_close("nz", i, (double)f.plane[SHD_PLANE_NZ][i], 0.8, 1e-6, 0);
    }
    shd_frame_close(&f);
}

/* Halves clip-space x and y. */
static void halve(const shd_vertices *in, shd_vertex_outputs *out, void *user_data)
{
    size_t i;
    (void)user_data;
    for (i = 0; i < in->count; ++i) {
        out->x[i] *= 0.5f;
        out->y[i] *= 0.5f;
    }
}

/* Positions that a program moves stay relative to the viewport: half of it, around its middle, is covered. */
static void test_viewport(void **state)
{
    static const shd_region k_viewport = {8, 16, 32, 24};
    shd_material_desc m = shd_frame_plain(1, 1, 1);
    float quad[48];
    shd_frame f;
    uint32_t i;
    (void)state;
    m.program.vertex = halve;
    shd_frame_open(&f, 64, 64);
    f.desc.viewport = &k_viewport;
    shd_frame_quad(-1, -1, 1, 1, 0.5f, 0.5f, quad);
    shd_frame_draw(&f, quad, 6, &m);
    shd_frame_ambient(&f);
    shd_frame_render(&f);
    assert_int_equal(f.stats.fragment_count, 16 * 12);
    for (i = 0; i < 64 * 64; ++i) {
        const uint32_t x = i % 64, y = i / 64;
        assert_int_equal(f.triangle[i] != 0xffffffffu, x >= 16 && x < 32 && y >= 22 && y < 34);
    }
    shd_frame_close(&f);
}

/* A curved patch of k_cells x k_cells cells, in records of eight floats; three records are a triangle. */
enum { k_cells = 20, k_patch = k_cells * k_cells * 6 };
static float patch_height(float x, float y) { return 0.2f * (x * x - 0.5f * x * y + 0.25f * y); }
static void make_patch(float out[k_patch * 8], int displaced)
{
    static const int k_dx[6] = {0, 1, 1, 0, 1, 0}, k_dy[6] = {0, 0, 1, 0, 1, 1};
    size_t i;
    for (i = 0; i < k_patch; ++i) {
        const int cell = (int)i / 6, k = (int)i % 6;
        const float x = 1.6f * (float)(cell % k_cells + k_dx[k]) / k_cells - 0.8f;
        const float y = 1.6f * (float)(cell / k_cells + k_dy[k]) / k_cells - 0.8f;
        float *v = out + 8 * i;
        int c;
        v[0] = x;
        v[1] = y;
        v[2] = 0.5f;
        v[3] = 0.0f;
        v[4] = 0.6f;
        v[5] = 0.8f;
        v[6] = 0.5f * (x + 1.0f);
        v[7] = 0.5f * (y + 1.0f);
        for (c = 0; c < 3 && displaced; ++c) v[c] += patch_height(x, y) * v[3 + c];
    }
}

/* Displaces vertices as make_patch() does, for the identity view. */
static void displace(const shd_vertices *in, shd_vertex_outputs *out, void *user_data)
{
    size_t i;
    (void)user_data;
    for (i = 0; i < in->count; ++i) {
        const float height = patch_height(in->px[i], in->py[i]);
        out->x[i] = out->px[i] = in->px[i] + height * in->nx[i];
        out->y[i] = out->py[i] = in->py[i] + height * in->ny[i];
        out->z[i] = out->pz[i] = in->pz[i] + height * in->nz[i];
    }
}

/* Renders the patch as the second draw of a frame with draws of other models. */
static void render_patch(shd_frame *f, int by_program, shd_model model, shd_frequency frequency)
{
    static float vertices[k_patch * 8];
    float quad[48];
    shd_material_desc m = shd_frame_plain(0.1f, 0.2f, 0.3f);
    shd_light_desc lamp = shd_light_desc_default();
    shd_frame_open(f, 64, 64);
    shd_frame_quad(-1, -1, 1, 1, 0.3f, 0.7f, quad);
    shd_frame_draw(f, quad, 6, &m);
    m.model = model;
    m.program.fragment = model == SHD_MODEL_PROGRAM ? shd_scene_program : NULL;
    m.program.vertex = by_program ? displace : NULL;
    make_patch(vertices, !by_program);
    shd_frame_draw(f, vertices, k_patch, &m)->frequency = frequency;
    lamp.position[2] = -2.0f;
    shd_frame_light(f, &lamp);
    shd_frame_ambient(f);
    f->desc.view.eye[2] = -3.0f;
    shd_frame_render(f);
}

static void test_displacement(void **state)
{
    int model, frequency, plane;
    (void)state;
    for (model = SHD_MODEL_LAMBERT; model <= SHD_MODEL_PROGRAM; ++model) {
        for (frequency = SHD_FREQUENCY_PHONG; frequency <= SHD_FREQUENCY_FLAT; ++frequency) {
            shd_frame built, programmed;
            render_patch(&built, 0, (shd_model)model, (shd_frequency)frequency);
            render_patch(&programmed, 1, (shd_model)model, (shd_frequency)frequency);
            assert_true(built.stats.rasterized_triangle_count > 500);
            assert_int_equal(built.stats.rasterized_triangle_count, programmed.stats.rasterized_triangle_count);
            for (plane = SHD_PLANE_R; plane <= SHD_PLANE_NZ; ++plane) {
                if (!built.plane[plane]) continue;
                if (memcmp(built.plane[plane], programmed.plane[plane], 64 * 64 * sizeof(float)) != 0) {
                    fail_msg("model %d, frequency %d, plane %d: other bits", model, frequency, plane);
                }
            }
            shd_frame_close(&built);
            shd_frame_close(&programmed);
        }
    }
}

/* A value that is not finite, in column `column` of vertex `vertex`. */
struct spoil {
    const char *name;
    int column; /* column of shd_vertex_outputs, in order; 12 = varying 0, 13 = varying 2 */
    float value;
};
static void spoil(const shd_vertices *in, shd_vertex_outputs *out, void *user_data)
{
    const struct spoil *s = (const struct spoil *)user_data;
    float *const columns[] = {out->x,  out->y,  out->z,  out->w, out->px, out->py,         out->pz,
                              out->nx, out->ny, out->nz, out->u, out->v,  out->varying[0], out->varying[2]};
    size_t i;
    for (i = 0; i < in->count; ++i) {
        if (in->first + i == 4) columns[s->column][i] = s->value;
    }
}
#define SPOILS(value)                                                                                               \
    {"nonfinite/x_" #value, 0, value}, {"nonfinite/y_" #value, 1, value}, {"nonfinite/z_" #value, 2, value},        \
        {"nonfinite/w_" #value, 3, value}, {"nonfinite/px_" #value, 4, value}, {"nonfinite/py_" #value, 5, value},  \
        {"nonfinite/pz_" #value, 6, value}, {"nonfinite/nx_" #value, 7, value}, {"nonfinite/ny_" #value, 8, value}, \
        {"nonfinite/nz_" #value, 9, value}, {"nonfinite/u_" #value, 10, value}, {"nonfinite/v_" #value, 11, value}, \
        {"nonfinite/varying_0_" #value, 12, value},                                                                 \
    {                                                                                                               \
        "nonfinite/varying_2_" #value, 13, value                                                                    \
    }
static const struct spoil k_spoils[] = {SPOILS((float)NAN), SPOILS((float)INFINITY), SPOILS(-(float)INFINITY)};

static void test_nonfinite(void **state)
{
    struct spoil s = *(const struct spoil *)*state;
    shd_material_desc m = shd_frame_plain(1, 1, 1);
    float quad[48];
    shd_frame f;
    size_t i;
    m.program.vertex = spoil;
    m.program.user_data = &s;
    m.varying_count = 3;
    shd_frame_open(&f, 16, 16);
    shd_frame_quad(-1, -1, 1, 1, 0.5f, 0.5f, quad);
    shd_frame_draw(&f, quad, 6, &m);
    shd_frame_render(&f);
    assert_int_equal(f.stats.nonfinite_triangle_count, 1);
    assert_int_equal(f.stats.rasterized_triangle_count, 1);
    assert_int_equal(f.stats.nonfinite_fragment_count, 0);
    for (i = 0; i < 256; ++i) assert_true(f.triangle[i] == 0 || f.triangle[i] == 0xffffffffu);
    shd_frame_close(&f);
}

/* Vertices with w <= 0 or far outside are clipped like any other vertex. */
static void behind(const shd_vertices *in, shd_vertex_outputs *out, void *user_data)
{
    const float w = *(const float *)user_data;
    size_t i;
    for (i = 0; i < in->count; ++i) {
        if ((in->first + i) % 3 != 1) continue;
        out->x[i] = 3e6f;
        out->z[i] = 0.5f * w;
        out->w[i] = w;
    }
}
static void test_behind(void **state)
{
    float w = *(const float *)*state;
    shd_material_desc m = shd_frame_plain(1, 1, 1);
    float quad[48];
    shd_frame f;
    size_t i;
    m.program.vertex = behind;
    m.program.user_data = &w;
    shd_frame_open(&f, 40, 40);
    shd_frame_quad(-0.5f, -0.5f, 0.5f, 0.5f, 0.5f, 0.5f, quad);
    shd_frame_draw(&f, quad, 6, &m);
    shd_frame_ambient(&f);
    shd_frame_render(&f);
    assert_int_equal(f.stats.clipped_triangle_count, 2);
    assert_int_equal(f.stats.nonfinite_triangle_count, 0);
    assert_int_equal(f.stats.nonfinite_fragment_count, 0);
    assert_true(f.stats.fragment_count > 100);
    for (i = 0; i < 1600; ++i) {
        assert_true(isfinite(f.plane[SHD_PLANE_DEPTH][i]) && isfinite(f.plane[SHD_PLANE_U][i]));
    }
    shd_frame_close(&f);
}

/* Calls of a program, counted by draw, instance and vertex. */
enum { k_vertices = 1300, k_instances = 3 };
struct heard {
    int calls[2][k_instances][k_vertices];
    int largest, mistakes;
    const shd_render_desc *desc;
    const float *instances;
    int tangents; /* and a second uv set and an attribute */
};
static void listen(const shd_vertices *in, shd_vertex_outputs *out, void *user_data)
{
    struct heard *h = (struct heard *)user_data;
    const shd_draw *draw = &h->desc->draws[in->draw];
    const float *world = draw->instance_count ? h->instances + 16 * in->instance : draw->object_to_world;
    size_t i;
    h->mistakes += in->struct_size != sizeof *in || out->struct_size != sizeof *out || in->count == 0;
    h->mistakes += in->draw > 1 || in->instance >= k_instances || in->first + in->count > k_vertices;
    if (h->mistakes) return;
    h->mistakes += in->uniforms != draw->uniforms || out->varying_count != 2 || !out->varying[0] || !out->varying[1];
    h->mistakes += memcmp(in->object_to_world, world, 16 * sizeof(float)) != 0;
    h->mistakes += memcmp(in->world_to_view, h->desc->view.world_to_view, 16 * sizeof(float)) != 0;
    h->mistakes += memcmp(in->view_to_clip, h->desc->view.view_to_clip, 16 * sizeof(float)) != 0;
    h->mistakes += memcmp(in->eye, h->desc->view.eye, 3 * sizeof(float)) != 0;
    h->mistakes += h->tangents ? !in->tx || !in->ty || !in->tz || !in->tw : in->tx || in->ty || in->tz || in->tw;
    h->mistakes += in->attribute_count != SHD_MAX_ATTRIBUTES || !in->attribute;
    if (h->mistakes) return;
    h->mistakes += h->tangents ? !in->u1 || !in->v1 || !in->attribute[1] : in->u1 || in->v1 || in->attribute[1];
    h->mistakes += in->attribute[0] || in->attribute[2] || in->attribute[SHD_MAX_ATTRIBUTES - 1];
    if ((int)in->count > h->largest) h->largest = (int)in->count;
    for (i = 0; i < in->count; ++i) {
        const float id = (float)(in->first + i);
        ++h->calls[in->draw][in->instance][in->first + i];
        h->mistakes += in->px[i] != id || in->py[i] != 2 * id || in->pz[i] != 1 || in->u[i] != -id || in->v[i] != 0.5f;
        h->mistakes += in->nx[i] != 0 || in->ny[i] != 0 || in->nz[i] != 1;
        h->mistakes += in->tx && (in->tx[i] != 1 || in->ty[i] != id || in->tz[i] != 0 || in->tw[i] != -1);
        h->mistakes += in->u1 && (in->u1[i] != 3 * id || in->v1[i] != 4);
        h->mistakes += in->attribute[1] && in->attribute[1][i] != 5 * id;
        h->mistakes += out->varying[0][i] != 0 || out->varying[1][i] != 0;
        h->mistakes += out->px[i] != world[0] * id + world[12] || out->u[i] != -id;
        out->varying[0][i] = out->varying[1][i] = 5; /* must not appear in the next call */
    }
}

static shd_mesh *make_points(shd_context *context, int tangents)
{
    static float columns[15][k_vertices];
    shd_mesh_desc desc = shd_mesh_desc_default();
    shd_f32_in attributes[2] = {{NULL, 0}, {columns[14], 0}};
    shd_mesh *mesh = NULL;
    size_t c, i;
    for (i = 0; i < k_vertices; ++i) {
        const float id = (float)i, record[15] = {id, 2 * id, 1, 0, 0, 7, -id, 0.5f, 1, id, 0, -1, 3 * id, 4, 5 * id};
        for (c = 0; c < 15; ++c) columns[c][i] = record[c];
    }
    desc.vertex_count = k_vertices;
    for (c = 0; c < 3; ++c) desc.position[c].data = columns[c];
    for (c = 0; c < 3; ++c) desc.normal[c].data = columns[3 + c];
    for (c = 0; c < 2; ++c) desc.uv[c].data = columns[6 + c];
    for (c = 0; c < 4 && tangents; ++c) desc.tangent[c].data = columns[8 + c];
    for (c = 0; c < 2 && tangents; ++c) desc.uv1[c].data = columns[12 + c];
    if (tangents) desc.attributes = attributes, desc.attribute_count = 2;
    desc.index_count = k_vertices / 3 * 3;
    shd_assert_ok(shd_mesh_create(context, &desc, &mesh));
    return mesh;
}

static void test_inputs(void **state)
{
    static struct heard h;
    float instances[k_instances][16] = {{0}};
    shd_material_desc m = shd_frame_plain(1, 1, 1);
    shd_context_desc one = shd_context_desc_default();
    float quad[48];
    shd_frame f;
    size_t i, k;
    memset(&h, 0, sizeof h);
    h.tangents = *state != NULL;
    for (i = 0; i < k_instances; ++i) {
        for (k = 0; k < 16; k += 5) instances[i][k] = k == 0 ? (float)(1 << i) : 1.0f;
        instances[i][12] = 8.0f * (float)i;
    }
    m.program.vertex = listen;
    m.program.user_data = &h;
    m.varying_count = 2;
    one.worker_count = 1; /* so that the record needs no lock */
    shd_frame_open(&f, 16, 16);
    shd_frame_quad(-1, -1, 1, 1, 0, 0, quad);
    for (i = 0; i < 2; ++i) {
        shd_draw *draw = shd_frame_draw(&f, quad, 6, &m);
        shd_mesh_release(f.mesh[i]);
        draw->mesh = f.mesh[i] = make_points(f.context, h.tangents);
        draw->uniforms = &instances[i];
    }
    f.draw[1].instances = instances[0];
    f.draw[1].instance_count = k_instances;
    f.desc.view.eye[1] = 2.5f;
    f.desc.view.world_to_view[12] = 4.0f;
    h.desc = &f.desc;
    h.instances = instances[0];
    shd_context_release(f.context);
    shd_assert_ok(shd_context_create(&one, &f.context));
    shd_frame_render(&f);
    assert_int_equal(h.mistakes, 0);
    assert_true(h.largest <= 512 && h.largest >= 100);
    for (i = 0; i < k_vertices; ++i) {
        assert_int_equal(h.calls[0][0][i], 1);
        for (k = 0; k < k_instances; ++k) assert_int_equal(h.calls[1][k][i], 1);
    }
    shd_frame_close(&f);
}

/* A draw without a material and an empty mesh call no program. */
static void must_not_run(const shd_vertices *in, shd_vertex_outputs *out, void *user_data)
{
    (void)in;
    (void)out;
    *(int *)user_data = 1;
}
static void test_not_called(void **state)
{
    shd_mesh_desc empty = shd_mesh_desc_default();
    shd_material_desc m = shd_frame_plain(1, 1, 1);
    int called = 0;
    float quad[48];
    shd_frame f;
    (void)state;
    m.program.vertex = must_not_run;
    m.program.user_data = &called;
    m.varying_count = SHD_MAX_VARYINGS;
    shd_frame_open(&f, 16, 16);
    shd_frame_quad(-1, -1, 1, 1, 0.5f, 0.5f, quad);
    shd_frame_draw(&f, quad, 6, &m);
    shd_mesh_release(f.mesh[0]);
    f.mesh[0] = NULL;
    shd_assert_ok(shd_mesh_create(f.context, &empty, &f.mesh[0]));
    f.draw[0].mesh = f.mesh[0];
    shd_frame_draw(&f, quad, 6, &m)->material = NULL;
    shd_frame_render(&f);
    assert_int_equal(called, 0);
    assert_int_equal(f.stats.rasterized_triangle_count, 2);
    shd_frame_close(&f);
}

/* The same bits for any SIMD target, worker count and order of the calls. */
static uint64_t hash_on(const shd_context_desc *desc)
{
    shd_context *context = NULL;
    shd_scene s;
    uint64_t hash;
    shd_assert_ok(shd_context_create(desc, &context));
    shd_scene_open(&s, SHD_SCENE_MOVED, context);
    hash = shd_scene_render(&s);
    shd_scene_close(&s);
    shd_context_release(context);
    return hash;
}
static void test_same_bits(void **state)
{
    static const uint32_t k_workers[] = {1, 2, 3, 8};
    const uint64_t want = hash_on(NULL);
    int simd, order;
    size_t i;
    (void)state;
    assert_true(want != hash_with(SHD_SCENE_GLASS, NULL));
    for (i = 0; i < sizeof k_workers / sizeof k_workers[0]; ++i) {
        for (simd = SHD_SIMD_SCALAR; simd <= SHD_SIMD_WASM; ++simd) {
            shd_context_desc desc = shd_context_desc_default();
            shd_context *probe = NULL;
            desc.simd = (shd_simd)simd;
            desc.worker_count = k_workers[i];
            if (shd_context_create(&desc, &probe) != SHD_OK) continue;
            shd_context_release(probe);
            if (hash_on(&desc) != want) fail_msg("SIMD target %d, %u workers: other bits", simd, k_workers[i]);
        }
        for (order = SHD_POOL_FORWARD; order <= SHD_POOL_RANDOM; ++order) {
            shd_pool pool;
            shd_context_desc desc;
            pool.worker_count = k_workers[i];
            pool.order = (shd_pool_order)order;
            pool.seed = (uint32_t)i;
            desc = shd_pool_context_desc(&pool);
            if (hash_on(&desc) != want) fail_msg("order %d, %u workers: other bits", order, k_workers[i]);
        }
    }
}

int main(void)
{
    static const float k_behind[] = {0.0f, -0.0f, -1.0f, -1e-30f, 1e-35f, -1e6f};
    static struct CMUnitTest tests[64];
    size_t n = 0, i;
    tests[n++] = (struct CMUnitTest){"identity", test_identity, NULL, NULL, NULL};
    for (i = 0; i < sizeof k_w / sizeof k_w[0]; ++i) {
        tests[n++] = (struct CMUnitTest){"full_screen", test_full_screen, NULL, NULL, (void *)&k_w[i]};
    }
    tests[n++] = (struct CMUnitTest){"viewport", test_viewport, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"displacement", test_displacement, NULL, NULL, NULL};
    for (i = 0; i < sizeof k_spoils / sizeof k_spoils[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_spoils[i].name, test_nonfinite, NULL, NULL, (void *)&k_spoils[i]};
    }
    for (i = 0; i < sizeof k_behind / sizeof k_behind[0]; ++i) {
        tests[n++] = (struct CMUnitTest){"behind", test_behind, NULL, NULL, (void *)&k_behind[i]};
    }
    tests[n++] = (struct CMUnitTest){"inputs", test_inputs, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"inputs/tangents", test_inputs, NULL, NULL, (void *)&k_w[0]};
    tests[n++] = (struct CMUnitTest){"not_called", test_not_called, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"same_bits", test_same_bits, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.vertex_program", tests, n, NULL, NULL);
}
