/* SPDX-License-Identifier: MIT */
/* Every scene gives a picture, also with broken vertices, matrices and sizes. Statistics add up, the output is
 * finite, and invisible draws change nothing. */
#include "support/scene.h"

/* A frame with one mesh of loose triangles, a textured Blinn-Phong material and two lights. */
struct frame {
    shd_context *context;
    shd_texture *texture;
    shd_material *material;
    shd_light *light[2];
    shd_mesh *mesh;
    shd_framebuffer *framebuffer;
    shd_draw draw;
    shd_render_desc desc;
    shd_render_stats stats;
    uint32_t width, height;
};

static void make_mesh(struct frame *f, const float *positions, uint32_t vertices)
{
    shd_mesh_desc desc = shd_mesh_desc_default();
    int c;
    desc.vertex_count = vertices;
    for (c = 0; c < 3 && vertices; ++c) {
        desc.position[c] = shd_f32_column(positions + c, 3 * sizeof(float));
    }
    for (c = 0; c < 2; ++c) desc.uv[c] = desc.position[c];
    desc.flags = SHD_MESH_KEEP_NONFINITE;
    shd_assert_ok(shd_mesh_create(f->context, &desc, &f->mesh));
    f->draw.mesh = f->mesh;
}

static void open_frame(struct frame *f, const float *positions, uint32_t vertices, uint32_t width, uint32_t height)
{
    static const unsigned char k_texels[4] = {10, 200, 90, 255};
    shd_texture_desc texture = shd_texture_desc_default();
    shd_material_desc material = shd_material_desc_default();
    shd_light_desc light = shd_light_desc_default();
    shd_framebuffer_desc framebuffer = shd_framebuffer_desc_default();
    shd_slot slot;
    memset(f, 0, sizeof *f);
    shd_assert_ok(shd_context_create(NULL, &f->context));
    texture.format = SHD_FORMAT_R8;
    texture.width = texture.height = 2;
    texture.texels = k_texels;
    texture.tables = SHD_TABLE_MIPMAP;
    shd_assert_ok(shd_texture_create(f->context, &texture, &f->texture));
    material.model = SHD_MODEL_BLINN_PHONG;
    slot = shd_slot_texture(SHD_SLOT_DIFFUSE, f->texture, NULL);
    material.slots = &slot;
    material.slot_count = 1;
    shd_assert_ok(shd_material_create(f->context, &material, &f->material));
    shd_assert_ok(shd_light_create(f->context, &light, &f->light[0]));
    light.kind = SHD_LIGHT_KIND_AMBIENT;
    shd_assert_ok(shd_light_create(f->context, &light, &f->light[1]));
    f->width = framebuffer.width = width;
    f->height = framebuffer.height = height;
    framebuffer.aovs = SHD_AOV_UV | SHD_AOV_NORMAL | SHD_AOV_TRIANGLE;
    shd_assert_ok(shd_framebuffer_create(f->context, &framebuffer, &f->framebuffer));
    f->draw = shd_draw_default();
    f->draw.material = f->material;
    make_mesh(f, positions, vertices);
    f->desc = shd_render_desc_default();
    f->desc.framebuffer = f->framebuffer;
    f->desc.draws = &f->draw;
    f->desc.draw_count = 1;
    f->desc.lights = (const shd_light *const *)f->light;
    f->desc.light_count = 2;
    f->stats = shd_render_stats_default();
    f->desc.stats = &f->stats;
}

static void close_frame(struct frame *f)
{
    shd_framebuffer_release(f->framebuffer);
    shd_mesh_release(f->mesh);
    shd_light_release(f->light[0]);
    shd_light_release(f->light[1]);
    shd_material_release(f->material);
    shd_texture_release(f->texture);
    shd_context_release(f->context);
}

/* Every plane is finite, normals are unit vectors or 0, depth is in range, and the number of covered pixels equals
 * the number of fragments. */
static void expect_sane(const char *what, const struct frame *f)
{
    const shd_render_stats *s = &f->stats;
    shd_plane_view view[SHD_PLANE_TRIANGLE + 1];
    uint64_t covered = 0;
    uint32_t x, y;
    int plane;
    for (plane = 0; plane <= SHD_PLANE_TRIANGLE; ++plane) view[plane] = shd_plane_view_default();
    if (s->triangle_count != s->nonfinite_triangle_count + s->outside_triangle_count + s->culled_triangle_count +
                                 s->empty_triangle_count + s->rasterized_triangle_count) {
        fail_msg("%s: statistics do not add up", what);
    }
    assert_int_equal(s->nonfinite_fragment_count, 0);
    for (plane = 0; plane <= SHD_PLANE_TRIANGLE; ++plane) {
        shd_assert_ok(shd_framebuffer_view_plane(f->framebuffer, (shd_plane)plane, &view[plane]));
    }
    for (y = 0; y < f->height; ++y) {
        for (x = 0; x < f->width; ++x) {
            const size_t at = y * (view[0].row_stride / sizeof(float)) + x;
            const float nx = view[SHD_PLANE_NX].f32[at], ny = view[SHD_PLANE_NY].f32[at];
            const float nz = view[SHD_PLANE_NZ].f32[at], depth = view[SHD_PLANE_DEPTH].f32[at];
            const float length = nx * nx + ny * ny + nz * nz;
            for (plane = 0; plane < SHD_PLANE_TRIANGLE; ++plane) {
                const float value = view[plane].f32[at];
                if (!isfinite(value)) fail_msg("%s: plane %d is %g at %u, %u", what, plane, (double)value, x, y);
            }
            if (!(depth >= 0.0f && depth <= 1.0f)) fail_msg("%s: depth %g", what, (double)depth);
            if (length != 0.0f && !shd_is_close((double)length, 1.0, 1e-5, 0.0)) {
                fail_msg("%s: normal of length^2 %g", what, (double)length);
            }
            covered += view[SHD_PLANE_TRIANGLE].u32[at] != 0xffffffffu;
        }
    }
    if (covered != s->fragment_count) {
        fail_msg("%s: %llu pixels covered, %llu fragments", what, (unsigned long long)covered,
                 (unsigned long long)s->fragment_count);
    }
}

/* The draw as lines and as points: planes are finite and statistics add up. */
static void expect_sane_outlines(const char *what, struct frame *f)
{
    static const float k_widths[] = {0.0625f, 1, 64};
    size_t i;
    for (i = 0; i < 6; ++i) {
        f->draw.fill = i % 2 ? SHD_FILL_POINTS : SHD_FILL_WIREFRAME;
        f->draw.fill_width = k_widths[i / 2];
        shd_assert_ok(shd_render(f->context, &f->desc));
        expect_sane(what, f);
    }
    f->draw.fill = SHD_FILL_SOLID;
    f->draw.fill_width = 1;
}

static const shd_frequency k_frequencies[] = {SHD_FREQUENCY_PHONG, SHD_FREQUENCY_GOURAUD, SHD_FREQUENCY_FLAT};

#define BIG 3e38f
enum outcome { DROPPED_NONFINITE, DROPPED_OUTSIDE, DROPPED_CULLED, DROPPED_EMPTY, DRAWN };
struct triangle_case {
    const char *name;
    float p[9];
    enum outcome outcome;
};
static const struct triangle_case k_triangles[] = {
    {"nan/x0", {NAN, 0, 0.5f, 1, 0, 0.5f, 0, 1, 0.5f}, DROPPED_NONFINITE},
    {"nan/z2", {0, 0, 0.5f, 1, 0, 0.5f, 0, 1, NAN}, DROPPED_NONFINITE},
    {"inf/y1", {0, 0, 0.5f, 1, INFINITY, 0.5f, 0, 1, 0.5f}, DROPPED_NONFINITE},
    {"inf/all", {INFINITY, INFINITY, INFINITY, -INFINITY, -INFINITY, 0, 0, INFINITY, 0}, DROPPED_NONFINITE},
    {"outside/left", {-3, 0, 0.5f, -2, 0, 0.5f, -2, 1, 0.5f}, DROPPED_OUTSIDE},
    {"outside/below", {0, -3, 0.5f, 1, -3, 0.5f, 0, -2, 0.5f}, DROPPED_OUTSIDE},
    {"outside/near", {0, 0, -0.5f, 1, 0, -0.1f, 0, 1, -1}, DROPPED_OUTSIDE},
    {"outside/far", {0, 0, 1.5f, 1, 0, 1.1f, 0, 1, 2}, DROPPED_OUTSIDE},
    {"no_area/one_point", {0.1f, 0.1f, 0.5f, 0.1f, 0.1f, 0.5f, 0.1f, 0.1f, 0.5f}, DROPPED_CULLED},
    {"no_area/duplicate_vertex", {0, 0, 0.5f, 0, 0, 0.5f, 0.5f, 1, 0.5f}, DROPPED_CULLED},
    {"no_area/collinear", {-0.5f, -0.5f, 0.5f, 0, 0, 0.5f, 0.5f, 0.5f, 0.5f}, DROPPED_CULLED},
    {"no_area/edge_on", {0, 0, 0.1f, 0, 0.5f, 0.5f, 0, 0.25f, 0.9f}, DROPPED_CULLED},
    {"sliver/between_centres", {-0.9f, 0.002f, 0.5f, 0.9f, 0.002f, 0.5f, 0.9f, -0.002f, 0.5f}, DROPPED_EMPTY},
    {"denormal", {1e-42f, 0, 0.5f, 0, 1e-44f, 0.5f, 1e-45f, 1e-45f, 0.5f}, DROPPED_CULLED},
    {"plain", {-0.5f, -0.5f, 0.5f, 0.5f, -0.5f, 0.5f, 0, 0.5f, 0.5f}, DRAWN},
    {"depth/on_near_plane", {-0.5f, -0.5f, 0, 0.5f, -0.5f, 0, 0, 0.5f, 0}, DRAWN},
    {"depth/across_near", {-0.5f, -0.5f, -1, 0.5f, -0.5f, 0.5f, 0, 0.5f, 0.5f}, DRAWN},
    {"depth/across_both", {-0.9f, -0.9f, -5, 0.9f, -0.9f, 5, 0, 0.9f, 0.5f}, DRAWN},
    {"huge/1e3", {-1e3f, -1e3f, 0.5f, 1e3f, -1e3f, 0.5f, 0, 1e3f, 0.5f}, DRAWN},
    {"huge/1e6", {-1e6f, -1e6f, 0.5f, 1e6f, -1e6f, 0.5f, 0, 1e6f, 0.5f}, DRAWN},
    {"huge/1e9", {-1e9f, -1e9f, 0.5f, 1e9f, -1e9f, 0.5f, 0, 1e9f, 0.5f}, DRAWN},
    {"huge/1e18", {-1e18f, -1e18f, 0.5f, 1e18f, -1e18f, 0.5f, 0, 1e18f, 0.5f}, DRAWN},
    {"huge/1e24", {-1e24f, -1e24f, 0.5f, 1e24f, -1e24f, 0.5f, 0, 1e24f, 0.5f}, DRAWN},
    {"huge/1e36", {-1e36f, -1e36f, 0.5f, 1e36f, -1e36f, 0.5f, 0, 1e36f, 0.5f}, DRAWN},
    {"huge/sliver_1e6", {-1e6f, 0, 0.5f, 1e6f, 0, 0.5f, 1e6f, 0.1f, 0.5f}, DRAWN},
};

static void test_triangle(void **state)
{
    const struct triangle_case *c = (const struct triangle_case *)*state;
    size_t i;
    for (i = 0; i < 3; ++i) {
        struct frame f;
        open_frame(&f, c->p, 3, 64, 64);
        f.draw.frequency = k_frequencies[i];
        shd_assert_ok(shd_render(f.context, &f.desc));
        expect_sane(c->name, &f);
        assert_int_equal(f.stats.triangle_count, 1);
        assert_int_equal(f.stats.nonfinite_triangle_count, c->outcome == DROPPED_NONFINITE);
        assert_int_equal(f.stats.outside_triangle_count, c->outcome == DROPPED_OUTSIDE);
        assert_int_equal(f.stats.culled_triangle_count, c->outcome == DROPPED_CULLED);
        assert_int_equal(f.stats.empty_triangle_count, c->outcome == DROPPED_EMPTY);
        assert_int_equal(f.stats.rasterized_triangle_count, c->outcome == DRAWN);
        if (c->outcome == DRAWN) assert_true(f.stats.fragment_count > 0);
        if (c->outcome != DRAWN) assert_int_equal(f.stats.fragment_count, 0);
        expect_sane_outlines(c->name, &f);
        if (c->outcome == DROPPED_NONFINITE) assert_int_equal(f.stats.nonfinite_triangle_count, 1);
        close_frame(&f);
    }
}

/* Positions up to the largest float, through a projection: planes are finite and statistics add up. */
static void test_random_huge(void **state)
{
    static const float k_scales[] = {1e-40f, 1e-20f, 1e-3f, 1.0f, 1e3f, 1e6f, 1e12f, 1e19f, 1e30f, BIG};
    enum { k_count = 600 };
    static float p[9 * k_count];
    const size_t scales = sizeof k_scales / sizeof k_scales[0];
    uint32_t seed = 31;
    size_t s, i, k;
    (void)state;
    for (s = 0; s < scales + 1; ++s) {
        struct frame f;
        shd_camera camera = shd_camera_default();
        for (i = 0; i < 9 * k_count; ++i) {
            /* The last round mixes every scale in one triangle. */
            const size_t pick = s < scales ? s : (size_t)(shd_scene_random(&seed) * (float)scales);
            p[i] = k_scales[pick] * (2.0f * shd_scene_random(&seed) - 1.0f);
        }
        open_frame(&f, p, 3 * k_count, 70, 70);
        for (k = 0; k < 6; ++k) {
            char what[64];
            snprintf(what, sizeof what, "scale %zu, variant %zu", s, k);
            f.draw.frequency = k_frequencies[k % 3];
            f.draw.cull = k % 2 ? SHD_CULL_BACK : SHD_CULL_NONE;
            if (k >= 3) shd_assert_ok(shd_view_from_camera(&camera, &f.desc.view));
            shd_assert_ok(shd_render(f.context, &f.desc));
            expect_sane(what, &f);
            expect_sane_outlines(what, &f);
        }
        close_frame(&f);
    }
}

struct matrix_case {
    const char *name;
    int which; /* 0 object_to_world, 1 world_to_view, 2 view_to_clip */
    float m[16];
    int draws_something;
};
static const struct matrix_case k_matrices[] = {
    {"object/zero", 0, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1}, 0},
    {"object/flat_in_x", 0, {0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, 0},
    {"object/flat_in_z", 0, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0.5f, 1}, 1},
    {"object/1e36", 0, {1e36f, 0, 0, 0, 0, 1e36f, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, 1},
    {"object/beyond_float", 0, {1e38f, 0, 0, 0, 0, 1e38f, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, 0},
    {"object/1e-38", 0, {1e-38f, 0, 0, 0, 0, 1e-38f, 0, 0, 0, 0, 1e-38f, 0, 0, 0, 0.5f, 1}, 0},
    {"object/mirror", 0, {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, 1},
    {"object/translated_1e38", 0, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1e38f, 0, 0, 1}, 0},
    {"view/zero", 1, {0}, 0},
    {"view/1e30", 1, {1e30f, 0, 0, 0, 0, 1e30f, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, 1},
    {"clip/zero", 2, {0}, 0},
    {"clip/w_zero", 2, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0}, 0},
    {"clip/w_negative", 2, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1}, 0},
    {"clip/w_tiny", 2, {1e-36f, 0, 0, 0, 0, 1e-36f, 0, 0, 0, 0, 1e-36f, 0, 0, 0, 0, 1e-36f}, 0},
    {"clip/near_is_far", 2, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0.5f, 1}, 1},
    {"clip/all_behind", 2, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, -0.1f, 0}, 0},
    {"clip/max_float", 2, {BIG, 0, 0, 0, 0, BIG, 0, 0, 0, 0, BIG, 0, 0, 0, 0, BIG}, 0},
};

static void test_matrix(void **state)
{
    static const float k_p[9] = {-0.5f, -0.5f, 0.5f, 0.5f, -0.5f, 0.5f, 0.0f, 0.5f, 0.5f};
    const struct matrix_case *c = (const struct matrix_case *)*state;
    size_t i;
    for (i = 0; i < 3; ++i) {
        struct frame f;
        float *m;
        open_frame(&f, k_p, 3, 64, 64);
        f.draw.frequency = k_frequencies[i];
        m = c->which == 0   ? f.draw.object_to_world
            : c->which == 1 ? f.desc.view.world_to_view
                            : f.desc.view.view_to_clip;
        memcpy(m, c->m, sizeof c->m);
        shd_assert_ok(shd_render(f.context, &f.desc));
        expect_sane(c->name, &f);
        if (c->draws_something) assert_true(f.stats.fragment_count > 0);
        if (!c->draws_something && strcmp(c->name, "clip/max_float") != 0 && strcmp(c->name, "clip/w_tiny") != 0) {
            assert_int_equal(f.stats.fragment_count, 0);
        }
        expect_sane_outlines(c->name, &f);
        close_frame(&f);
    }
}

/* The position of a light changes only the brightness. */
static void test_lights_in_odd_places(void **state)
{
    static const float k_p[9] = {-1, -1, 0.5f, 3, -1, 0.5f, -1, 3, 0.5f};
    static const float k_places[][3] = {{0, 0, 0.5f},  {-1, -1, 0.5f},  {0, 0, 1e-30f + 0.5f},
                                        {1e38f, 0, 0}, {BIG, BIG, BIG}, {1e-38f, 0, 0}};
    size_t i, k;
    (void)state;
    for (i = 0; i < sizeof k_places / sizeof k_places[0]; ++i) {
        for (k = 0; k < 3; ++k) {
            struct frame f;
            shd_light_desc light = shd_light_desc_default();
            open_frame(&f, k_p, 3, 65, 65); /* the centre pixel lies at the origin */
            shd_light_release(f.light[0]);
            memcpy(light.position, k_places[i], sizeof light.position);
            light.intensity[0] = light.intensity[1] = light.intensity[2] = 1e12f;
            shd_assert_ok(shd_light_create(f.context, &light, &f.light[0]));
            memcpy(f.desc.view.eye, k_places[i], sizeof light.position);
            f.draw.frequency = k_frequencies[k];
            shd_assert_ok(shd_render(f.context, &f.desc));
            expect_sane("light", &f);
            assert_int_equal(f.stats.fragment_count, 65 * 65);
            close_frame(&f);
        }
    }
}

struct size_case {
    const char *name;
    uint32_t width, height;
};
static const struct size_case k_sizes[] = {
    {"size/1x1", 1, 1},     {"size/16384x1", 16384, 1}, {"size/1x16384", 1, 16384}, {"size/63x65", 63, 65},
    {"size/64x64", 64, 64}, {"size/65x63", 65, 63},     {"size/127x2", 127, 2},
};
static void test_size(void **state)
{
    static const float k_p[9] = {-1, -1, 0.5f, 3, -1, 0.5f, -1, 3, 0.5f};
    const struct size_case *c = (const struct size_case *)*state;
    struct frame f;
    open_frame(&f, k_p, 3, c->width, c->height);
    shd_assert_ok(shd_render(f.context, &f.desc));
    expect_sane(c->name, &f);
    assert_int_equal(f.stats.fragment_count, (uint64_t)c->width * c->height);
    close_frame(&f);
}

static void test_empty_mesh(void **state)
{
    struct frame f;
    uint64_t cleared;
    (void)state;
    open_frame(&f, NULL, 0, 33, 17);
    f.desc.draw_count = 0;
    shd_assert_ok(shd_render(f.context, &f.desc));
    expect_sane("no draws", &f);
    cleared = shd_hash_framebuffer(f.framebuffer);
    f.desc.draw_count = 1;
    shd_assert_ok(shd_render(f.context, &f.desc));
    expect_sane("empty mesh", &f);
    assert_int_equal(f.stats.triangle_count, 0);
    assert_true(shd_hash_framebuffer(f.framebuffer) == cleared);
    f.desc.light_count = 0;
    shd_assert_ok(shd_render(f.context, &f.desc));
    assert_true(shd_hash_framebuffer(f.framebuffer) == cleared);
    close_frame(&f);
}

int main(void)
{
    static struct CMUnitTest tests[sizeof k_triangles / sizeof k_triangles[0] +
                                   sizeof k_matrices / sizeof k_matrices[0] + sizeof k_sizes / sizeof k_sizes[0] + 3];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_triangles / sizeof k_triangles[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_triangles[i].name, test_triangle, NULL, NULL, (void *)&k_triangles[i]};
    }
    for (i = 0; i < sizeof k_matrices / sizeof k_matrices[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_matrices[i].name, test_matrix, NULL, NULL, (void *)&k_matrices[i]};
    }
    for (i = 0; i < sizeof k_sizes / sizeof k_sizes[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_sizes[i].name, test_size, NULL, NULL, (void *)&k_sizes[i]};
    }
    tests[n++] = (struct CMUnitTest){"random_huge", test_random_huge, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"lights_in_odd_places", test_lights_in_odd_places, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"empty_mesh", test_empty_mesh, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.render_total", tests, n, NULL, NULL);
}
