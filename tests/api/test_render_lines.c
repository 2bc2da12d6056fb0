/* SPDX-License-Identifier: MIT */
/* Line drawings: exact pixels of a cube, the edges that shd_mesh_find_edges finds drawn one by one, hidden lines,
   instances, passes and windows, and refusals. */
#include "support/frame.h"
#include "support/scene.h"
#include "support/shapes.h"

enum { EDGE = 128, MAX_EDGES = 3 * SHD_SHAPE_TRIANGLES };

static shd_test_shape g_shape;

static shd_draw *add_draw(shd_frame *f, shd_mesh *mesh, const shd_material_desc *material)
{
    const size_t which = f->desc.draw_count++;
    f->mesh[which] = mesh;
    shd_assert_ok(shd_material_create(f->context, material, &f->material[which]));
    f->draw[which] = shd_draw_default();
    f->draw[which].mesh = mesh;
    f->draw[which].material = f->material[which];
    return &f->draw[which];
}

static shd_draw *add_lines(shd_frame *f, shd_mesh *mesh)
{
    const shd_material_desc white = shd_frame_plain(1, 1, 1);
    shd_draw *draw = add_draw(f, mesh, &white);
    draw->fill = SHD_FILL_LINES;
    return draw;
}

static void start_shape(void (*make)(shd_test_shape *s, uint32_t n), uint32_t n)
{
    memset(&g_shape, 0, sizeof g_shape);
    make(&g_shape, n);
}

static shd_mesh *make_mesh(const shd_frame *f) { return shd_test_shape_mesh(f->context, &g_shape, SHD_MESH_ADJACENCY); }

static void look_from(shd_frame *f, float x, float y, float z)
{
    shd_camera camera = shd_camera_default();
    camera.eye[0] = x;
    camera.eye[1] = y;
    camera.eye[2] = z;
    shd_assert_ok(shd_view_from_camera(&camera, &f->desc.view));
}

static void check_counts(const shd_frame *f)
{
    const shd_render_stats *s = &f->stats;
    assert_int_equal(s->nonfinite_triangle_count + s->outside_triangle_count + s->culled_triangle_count +
                         s->empty_triangle_count + s->rasterized_triangle_count,
                     s->triangle_count);
}

/* A cube seen along an axis in a parallel projection: a square of lines two pixels wide, with square ends. */
static void test_square(void **state)
{
    const shd_cull cull = (shd_cull) * (const int *)*state;
    uint32_t i, x, y;
    shd_draw *draw;
    shd_frame f;
    shd_frame_open(&f, EDGE, EDGE);
    start_shape(shd_test_shape_cube, 1);
    draw = add_lines(&f, make_mesh(&f));
    draw->fill_width = 2;
    draw->cull = cull;
    for (i = 0; i < 3; ++i) draw->object_to_world[5 * i] = i == 2 ? 0.25f : 0.5f;
    draw->object_to_world[14] = 0.5f;
    shd_frame_ambient(&f);
    shd_frame_render(&f);
    for (y = 0; y < EDGE; ++y) {
        for (x = 0; x < EDGE; ++x) {
            const int inside_x = x >= 32 && x < 96, inside_y = y >= 32 && y < 96;
            const int on_x = x == 31 || x == 32 || x == 95 || x == 96, on_y = y == 31 || y == 32 || y == 95 || y == 96;
            const int want = (on_x && inside_y) || (on_y && inside_x);
            assert_int_equal(f.plane[SHD_PLANE_R][y * EDGE + x] == 1, want);
            if (want) assert_true(f.plane[SHD_PLANE_DEPTH][y * EDGE + x] == 0.25f);
        }
    }
    assert_int_equal(f.stats.triangle_count, 12);
    check_counts(&f);
    shd_frame_close(&f);
}

/* ---- edge by edge ---- */

struct edges_case {
    const char *name;
    void (*make)(shd_test_shape *s, uint32_t n);
    uint32_t n, kinds;
    float crease_cosine, width, scale[3], at[3];
    int is_orthographic;
    uint32_t samples;
};
static const struct edges_case k_edges[] = {
    {"edges/cube", shd_test_shape_cube, 1, SHD_EDGE_ALL, 0.5f, 1, {0.7f, 0.7f, 0.7f}, {0, 0, 0}, 0, 1},
    {"edges/cube_wide", shd_test_shape_cube, 1, SHD_EDGE_ALL, 0.5f, 5, {0.5f, 0.8f, -0.3f}, {0.1f, 0, -0.2f}, 0, 4},
    {"edges/cube_silhouette",
     shd_test_shape_cube,
     2,
     SHD_EDGE_SILHOUETTE,
     0,
     2,
     {0.7f, 0.6f, 0.5f},
     {0, 0.1f, 0},
     0,
     1},
    {"edges/cube_orthographic", shd_test_shape_cube, 1, SHD_EDGE_ALL, 0.5f, 1, {0.7f, 0.6f, 0.5f}, {0, 0.1f, 0}, 1, 1},
    {"edges/sphere", shd_test_shape_sphere, 6, SHD_EDGE_SILHOUETTE, 0, 2, {1, 1, 1}, {0, 0, 0}, 0, 1},
    {"edges/sphere_mirrored",
     shd_test_shape_sphere,
     6,
     SHD_EDGE_SILHOUETTE,
     0,
     2,
     {-1, 0.8f, 1.2f},
     {0.1f, 0, 0},
     0,
     2},
    {"edges/sphere_orthographic",
     shd_test_shape_sphere,
     6,
     SHD_EDGE_SILHOUETTE,
     0,
     1,
     {0.9f, 0.8f, 1},
     {0, 0, 0},
     1,
     1},
    {"edges/sphere_creases", shd_test_shape_sphere, 4, SHD_EDGE_CREASE, 0.96f, 1, {0.9f, 0.9f, 0.9f}, {0, 0, 0}, 0, 1},
    {"edges/sphere_around_the_eye", shd_test_shape_sphere, 4, SHD_EDGE_ALL, 0.96f, 1, {9, 9, 9}, {0, 0, 0}, 0, 1},
    {"edges/moebius", shd_test_shape_moebius, 20, SHD_EDGE_ALL, 0.5f, 1.5f, {0.8f, 0.8f, 0.8f}, {0, 0, 0}, 0, 4},
    {"edges/book", shd_test_shape_book, 4, SHD_EDGE_ALL, 0.5f, 3, {0.8f, 0.8f, 0.3f}, {0, 0, 0}, 0, 1},
    {"edges/book_spine", shd_test_shape_book, 4, SHD_EDGE_NONMANIFOLD, 0.5f, 3, {0.8f, 0.8f, 0.3f}, {0, 0, 0}, 0, 1},
    {"edges/book_borders", shd_test_shape_book, 4, SHD_EDGE_BORDER, 0.5f, 3, {0.8f, 0.8f, 0.3f}, {0, 0, 0}, 0, 1},
    {"edges/none", shd_test_shape_cube, 1, SHD_EDGE_NONE, 0.5f, 3, {0.8f, 0.8f, 0.3f}, {0, 0, 0}, 0, 1},
};

/* The edges as degenerate triangles. */
static shd_mesh *edges_as_triangles(const shd_frame *f, const shd_mesh *mesh, const shd_edges_desc *desc)
{
    static uint32_t vertex[2][MAX_EDGES];
    shd_edges out = shd_edges_default();
    size_t count = 0, i;
    for (i = 0; i < 2; ++i) out.vertex[i].data = vertex[i];
    shd_assert_ok(shd_mesh_find_edges(mesh, desc, MAX_EDGES, &out, &count));
    assert_true(count <= SHD_SHAPE_TRIANGLES);
    for (i = 0; i < count; ++i) {
        g_shape.indices[3 * i] = vertex[0][i];
        g_shape.indices[3 * i + 1] = g_shape.indices[3 * i + 2] = vertex[1][i];
    }
    g_shape.triangles = (uint32_t)count;
    return shd_test_shape_mesh(f->context, &g_shape, 0);
}

static void make_orthographic(shd_view *view)
{
    memset(view->view_to_clip, 0, sizeof view->view_to_clip);
    view->view_to_clip[0] = view->view_to_clip[5] = 0.6f;
    view->view_to_clip[10] = -0.1f;
    view->view_to_clip[15] = 1;
}

/* Draws lines; then draws the edges that are found for the frame's eye in object space as wireframes. */
static void test_edges(void **state)
{
    const struct edges_case *c = (const struct edges_case *)*state;
    static float lines[2][EDGE * EDGE];
    shd_edges_desc desc = shd_edges_desc_default();
    uint32_t i, lit = 0;
    shd_draw *draw;
    shd_frame f;
    shd_frame_open_samples(&f, EDGE, EDGE, c->samples);
    look_from(&f, 1.7f, 1.3f, 2.1f);
    if (c->is_orthographic) make_orthographic(&f.desc.view);
    start_shape(c->make, c->n);
    draw = add_lines(&f, make_mesh(&f));
    draw->fill_width = c->width;
    draw->edges = desc.edges = c->kinds;
    draw->crease_cosine = desc.crease_cosine = c->crease_cosine;
    for (i = 0; i < 3; ++i) {
        const float towards = f.desc.view.world_to_view[4 * i + 2];
        draw->object_to_world[5 * i] = c->scale[i];
        draw->object_to_world[12 + i] = c->at[i];
        desc.eye[i] = (c->is_orthographic ? towards : f.desc.view.eye[i] - c->at[i]) / c->scale[i];
    }
    desc.eye[3] = c->is_orthographic ? 0.0f : 1.0f;
    shd_frame_ambient(&f);
    shd_frame_render(&f);
    check_counts(&f);
    memcpy(lines[0], f.plane[SHD_PLANE_R], sizeof lines[0]);
    memcpy(lines[1], f.plane[SHD_PLANE_DEPTH], sizeof lines[1]);
    f.mesh[1] = edges_as_triangles(&f, f.mesh[0], &desc);
    draw->mesh = f.mesh[1];
    draw->fill = SHD_FILL_WIREFRAME;
    shd_frame_render(&f);
    for (i = 0; i < EDGE * EDGE; ++i) lit += lines[0][i] > 0;
    assert_true(c->kinds ? lit > 40 : lit == 0);
    assert_memory_equal(lines[0], f.plane[SHD_PLANE_R], sizeof lines[0]);
    assert_memory_equal(lines[1], f.plane[SHD_PLANE_DEPTH], sizeof lines[1]);
    shd_frame_close(&f);
}

/* ---- hidden lines ---- */

static void project(const shd_view *view, const float p[3], float pixel[2])
{
    float v[4], clip[4];
    int r;
    for (r = 0; r < 4; ++r) {
        const float *m = view->world_to_view + r;
        v[r] = m[0] * p[0] + m[4] * p[1] + m[8] * p[2] + m[12];
    }
    for (r = 0; r < 4; ++r) {
        const float *m = view->view_to_clip + r;
        clip[r] = m[0] * v[0] + m[4] * v[1] + m[8] * v[2] + m[12] * v[3];
    }
    pixel[0] = (clip[0] / clip[3] + 1) * EDGE / 2;
    pixel[1] = (1 - clip[1] / clip[3]) * EDGE / 2;
}

/* A cube with a corner in front has nine visible edges and three hidden ones; without a depth test all are visible.
 * The solid cube is drawn without colour, only to hide lines. */
static void test_hidden(void **state)
{
    const int overlay = *(const int *)*state;
    const float eye[3] = {3.0f, 2.5f, 2.2f};
    const shd_material_desc unused = shd_material_desc_default();
    int axis, side, shown = 0, i;
    shd_draw *solid, *lines;
    shd_frame f;
    shd_frame_open(&f, EDGE, EDGE);
    look_from(&f, eye[0], eye[1], eye[2]);
    start_shape(shd_test_shape_cube, 3);
    solid = add_draw(&f, make_mesh(&f), &unused);
    solid->material = NULL;
    solid->depth_bias = 1e-5f;
    solid->depth_bias_slope = 2;
    lines = add_lines(&f, make_mesh(&f));
    lines->fill_width = 2;
    lines->compare = overlay ? SHD_COMPARE_ALWAYS : SHD_COMPARE_LESS_EQUAL;
    for (i = 0; i < 3; ++i) solid->object_to_world[5 * i] = lines->object_to_world[5 * i] = 0.8f;
    shd_frame_ambient(&f);
    shd_frame_render(&f);
    for (axis = 0; axis < 3; ++axis) {
        for (side = 0; side < 4; ++side) { /* a point at a third of the edge, away from corners and other edges */
            const int is_back = side == 3;
            float p[3], pixel[2];
            p[axis] = 0.8f / 3;
            p[(axis + 1) % 3] = side & 1 ? -0.8f : 0.8f;
            p[(axis + 2) % 3] = side & 2 ? -0.8f : 0.8f;
            project(&f.desc.view, p, pixel);
            i = (int)pixel[1] * EDGE + (int)pixel[0];
            assert_int_equal(f.plane[SHD_PLANE_R][i] == 1, overlay || !is_back);
            shown += f.plane[SHD_PLANE_R][i] == 1;
        }
    }
    assert_int_equal(shown, overlay ? 12 : 9);
    shd_frame_close(&f);
}

/* ---- lines in frames ---- */

/* Each instance is like a separate draw and has its own silhouette. */
static void test_instances(void **state)
{
    static float matrices[2][16], planes[2][EDGE * EDGE];
    shd_draw *draw;
    shd_frame f;
    int i;
    (void)state;
    shd_frame_open(&f, EDGE, EDGE);
    look_from(&f, 0.3f, 0.4f, 4);
    start_shape(shd_test_shape_sphere, 5);
    draw = add_lines(&f, make_mesh(&f));
    for (i = 0; i < 2; ++i) {
        memcpy(matrices[i], draw->object_to_world, sizeof matrices[i]);
        matrices[i][0] = i ? -0.4f : 0.5f;
        matrices[i][12] = i ? 0.8f : -0.8f;
    }
    draw->edges = SHD_EDGE_SILHOUETTE;
    draw->instances = matrices[0];
    draw->instance_count = 2;
    shd_frame_ambient(&f);
    shd_frame_render(&f);
    memcpy(planes[0], f.plane[SHD_PLANE_R], sizeof planes[0]);
    memcpy(planes[1], f.plane[SHD_PLANE_DEPTH], sizeof planes[1]);
    f.draw[1] = *draw;
    f.desc.draw_count = 2;
    for (i = 0; i < 2; ++i) {
        f.draw[i].instance_count = 0;
        memcpy(f.draw[i].object_to_world, matrices[i], sizeof matrices[i]);
    }
    shd_frame_render(&f);
    assert_memory_equal(planes[0], f.plane[SHD_PLANE_R], sizeof planes[0]);
    assert_memory_equal(planes[1], f.plane[SHD_PLANE_DEPTH], sizeof planes[1]);
    assert_true(f.stats.rasterized_triangle_count > 40);
    shd_frame_close(&f);
}

static void lean(const shd_vertices *in, shd_vertex_outputs *out, void *user_data)
{
    size_t i;
    (void)user_data;
    for (i = 0; i < in->count; ++i) out->x[i] += in->pz[i];
}

/* A vertex program moves lines, but silhouettes are computed from the mesh. */
static void test_vertex_program(void **state)
{
    shd_material_desc moved = shd_frame_plain(1, 1, 1);
    uint64_t lines, without;
    shd_frame f;
    (void)state;
    shd_frame_open(&f, EDGE, EDGE);
    look_from(&f, 1, 2, 3);
    start_shape(shd_test_shape_sphere, 5);
    add_lines(&f, make_mesh(&f))->edges = SHD_EDGE_SILHOUETTE;
    shd_frame_ambient(&f);
    shd_frame_render(&f);
    lines = f.stats.rasterized_triangle_count;
    without = f.stats.culled_triangle_count;
    assert_true(lines > 20);
    moved.program.vertex = lean;
    shd_material_release(f.material[0]);
    shd_assert_ok(shd_material_create(f.context, &moved, &f.material[0]));
    f.draw[0].material = f.material[0];
    shd_frame_render(&f);
    assert_true(f.stats.culled_triangle_count == without && f.stats.rasterized_triangle_count == lines);
    shd_frame_close(&f);
}

/* A matrix without a centre of projection and a matrix that flattens: frames are finite and defined. */
static void test_singular(void **state)
{
    shd_draw *draw;
    shd_frame f;
    (void)state;
    shd_frame_open(&f, EDGE, EDGE);
    start_shape(shd_test_shape_sphere, 4);
    draw = add_lines(&f, make_mesh(&f));
    draw->edges = SHD_EDGE_SILHOUETTE;
    draw->object_to_world[10] = 0; /* the sphere as a disc: its silhouette is the rim */
    shd_frame_ambient(&f);
    shd_frame_render(&f);
    assert_int_equal(f.stats.outside_triangle_count, 0);
    assert_true(f.stats.rasterized_triangle_count > 10 && f.stats.rasterized_triangle_count < 40);
    draw->object_to_world[0] = 0; /* flattened to a line: every edge is a silhouette */
    shd_frame_render(&f);
    assert_true(f.stats.rasterized_triangle_count > 100);
    draw->object_to_world[5] = 0;
    shd_frame_render(&f);
    assert_int_equal(f.stats.rasterized_triangle_count, 0);
    check_counts(&f);
    shd_frame_close(&f);
}

/* The scene of lines, rendered in passes and in windows. */
static void test_passes(void **state)
{
    shd_context *context = NULL;
    uint64_t want, pixels;
    shd_scene s;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_scene_open(&s, SHD_SCENE_LINES, context);
    want = shd_scene_render(&s);
    assert_true(s.stats.triangle_count > 4096 && s.stats.fragment_count > 5000 && s.stats.clipped_triangle_count > 0);
    pixels = shd_hash_framebuffer(s.framebuffer);
    s.desc.pass_triangles = 1024;
    (void)shd_scene_render(&s);
    assert_true(shd_hash_framebuffer(s.framebuffer) == pixels);
    s.desc.pass_triangles = 1500;
    (void)shd_scene_render(&s);
    assert_true(shd_hash_framebuffer(s.framebuffer) == pixels);
    s.desc.pass_triangles = 1 << 21;
    assert_true(shd_scene_render(&s) == want);
    shd_scene_close(&s);
    shd_context_release(context);
}

/* ---- refusals ---- */

static void bad_kinds(shd_draw *d) { d->edges = 0x10; }
static void bad_crease_nan(shd_draw *d) { d->crease_cosine = (float)NAN; }
static void bad_crease_high(shd_draw *d) { d->crease_cosine = 1.5f; }
static void bad_crease_low(shd_draw *d) { d->crease_cosine = -2; }
static void bad_solid_crease(shd_draw *d)
{
    d->fill = SHD_FILL_SOLID;
    d->crease_cosine = (float)INFINITY;
}
struct bad_case {
    const char *name;
    void (*edit)(shd_draw *d);
    shd_result result;
    const char *message;
};
static const struct bad_case k_bad[] = {
    {"refused/kinds", bad_kinds, SHD_ERROR_UNSUPPORTED, "render.draws[0]: draw.edges: "},
    {"refused/crease_nan", bad_crease_nan, SHD_ERROR_INVALID_ARGUMENT, "render.draws[0]: draw.crease_cosine: nan"},
    {"refused/crease_high", bad_crease_high, SHD_ERROR_INVALID_ARGUMENT, "draw.crease_cosine: 1.5 is not in -1..1"},
    {"refused/crease_low", bad_crease_low, SHD_ERROR_INVALID_ARGUMENT, "draw.crease_cosine: -2 is not in -1..1"},
    {"refused/solid_crease", bad_solid_crease, SHD_ERROR_INVALID_ARGUMENT, "draw.crease_cosine: inf"},
};

static void test_bad(void **state)
{
    const struct bad_case *c = (const struct bad_case *)*state;
    shd_frame f;
    shd_frame_open(&f, EDGE, EDGE);
    start_shape(shd_test_shape_cube, 1);
    c->edit(add_lines(&f, make_mesh(&f)));
    shd_assert_result(c->name, shd_render(f.context, &f.desc), c->result, c->message);
    shd_frame_close(&f);
}

static void test_without_adjacency(void **state)
{
    shd_frame f;
    (void)state;
    shd_frame_open(&f, EDGE, EDGE);
    start_shape(shd_test_shape_cube, 1);
    add_lines(&f, shd_test_shape_mesh(f.context, &g_shape, 0))->edges = 0;
    shd_assert_result("mesh", shd_render(f.context, &f.desc), SHD_ERROR_INVALID_ARGUMENT,
                      "render.draws[0]: draw.mesh: made without SHD_MESH_ADJACENCY");
    f.draw[0].fill = SHD_FILL_WIREFRAME;
    shd_assert_ok(shd_render(f.context, &f.desc));
    assert_true(shd_draw_default().edges == SHD_EDGE_ALL && shd_draw_default().crease_cosine == 0.5f);
    shd_frame_close(&f);
}

int main(void)
{
    static const int k_numbers[3] = {0, 1, 2};
    static struct CMUnitTest tests[50];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_edges / sizeof k_edges[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_edges[i].name, test_edges, NULL, NULL, (void *)&k_edges[i]};
    }
    for (i = 0; i < sizeof k_bad / sizeof k_bad[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_bad[i].name, test_bad, NULL, NULL, (void *)&k_bad[i]};
    }
    tests[n++] = (struct CMUnitTest){"refused/without_adjacency", test_without_adjacency, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"square/cull_none", test_square, NULL, NULL, (void *)&k_numbers[0]};
    tests[n++] = (struct CMUnitTest){"square/cull_back", test_square, NULL, NULL, (void *)&k_numbers[1]};
    tests[n++] = (struct CMUnitTest){"square/cull_front", test_square, NULL, NULL, (void *)&k_numbers[2]};
    tests[n++] = (struct CMUnitTest){"hidden_lines", test_hidden, NULL, NULL, (void *)&k_numbers[0]};
    tests[n++] = (struct CMUnitTest){"overlay", test_hidden, NULL, NULL, (void *)&k_numbers[1]};
    tests[n++] = (struct CMUnitTest){"instances", test_instances, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"vertex_program", test_vertex_program, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"singular", test_singular, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"passes", test_passes, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.render_lines", tests, n, NULL, NULL);
}
