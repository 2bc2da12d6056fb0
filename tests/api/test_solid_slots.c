/* SPDX-License-Identifier: MIT */
/* Solid textures in slots: the colours of frames are those of shd_solid_evaluate() at the places of the pixels. */
#include "support/context.h"
#include "support/frame.h"
#include "support/slots.h"

enum { k_size = 24, k_pixels = k_size * k_size };

/* A frame of one quad with an unlit material. */
typedef struct scene {
    shd_frame f;
    shd_material_desc material;
    shd_slot_list slots;
    shd_solid_desc solid;
    float quad[48];
} scene;

static void open_scene(scene *s)
{
    static const float k_colors[3][4] = {{0.05f, 0.1f, 0.2f, 0.25f}, {0.7f, 0.5f, 0.4f, 0.5f}, {1, 1, 0.9f, 0.75f}};
    int c;
    memset(s, 0, sizeof *s);
    shd_frame_open(&s->f, k_size, k_size);
    shd_frame_quad(-1, -1, 1, 1, 0.25f, 0.75f, s->quad);
    s->material = shd_material_desc_default();
    s->material.model = SHD_MODEL_UNLIT;
    for (c = 0; c < 3; ++c) s->material.diffuse[c] = 1.0f;
    s->solid = shd_solid_desc_default();
    s->solid.kind = SHD_SOLID_MARBLE;
    s->solid.octaves = 4;
    s->solid.size = 0.4f;
    s->solid.distortion = 2;
    s->solid.color_count = 3;
    memcpy(s->solid.colors, k_colors, sizeof k_colors);
}

static shd_slot *add_solid(scene *s, shd_slot_target target, shd_place_space space)
{
    shd_slot *slot = shd_slot_list_add(&s->slots, &s->material, shd_slot_solid(target, &s->solid));
    slot->place_space = space;
    return slot;
}

/* Places and widths of the pixels, and the values there. */
struct pixels {
    float place[3][k_pixels], width[k_pixels], color[4][k_pixels];
};
static struct pixels g;

static void evaluate(const shd_solid_desc *solid)
{
    shd_solid_points points = shd_solid_points_default();
    shd_solid_values values = shd_solid_values_default();
    int c;
    points.count = k_pixels;
    for (c = 0; c < 3; ++c) points.position[c].data = g.place[c];
    points.width.data = g.width;
    for (c = 0; c < 4; ++c) values.channel[c].data = g.color[c];
    shd_assert_ok(shd_solid_evaluate(g_context, solid, &points, &values));
}

/* World positions of the pixels of the quad under the identity view, and the length of a pixel step: to the right in x
   and z, down in y. */
static void find_quad_places(void)
{
    const double step = 2.0 / k_size, depth = 0.5 / k_size;
    int i;
    for (i = 0; i < k_pixels; ++i) {
        const double x = (i % k_size + 0.5) * step - 1, y = 1 - (i / k_size + 0.5) * step;
        g.place[0][i] = (float)x;
        g.place[1][i] = (float)y;
        g.place[2][i] = (float)(0.5 + 0.25 * x);
        g.width[i] = (float)sqrt(step * step + depth * depth);
    }
}

static void expect_colors(const scene *s, double error)
{
    size_t i;
    int c;
    for (i = 0; i < k_pixels; ++i) {
        assert_true(s->f.triangle[i] < 2);
        for (c = 0; c < 3; ++c) {
            shd_assert_close("colour", i, (double)s->f.plane[c][i], (double)g.color[c][i], error, 0);
        }
    }
}

/* World space, at every frequency, with factors of the width; the material has a copy of the desc. */
static void test_world(void **state)
{
    int frequency, i;
    (void)state;
    for (frequency = SHD_FREQUENCY_PHONG; frequency <= SHD_FREQUENCY_FLAT; ++frequency) {
        scene s;
        open_scene(&s);
        add_solid(&s, SHD_SLOT_DIFFUSE, SHD_PLACE_SPACE_WORLD)->place_width = (float)(2 - frequency);
        find_quad_places();
        for (i = 0; i < k_pixels; ++i) g.width[i] *= (float)(2 - frequency);
        evaluate(&s.solid);
        shd_frame_draw(&s.f, s.quad, 6, &s.material)->frequency = (shd_frequency)frequency;
        memset(&s.solid, 0, sizeof s.solid);
        shd_frame_render(&s.f);
        expect_colors(&s, 2e-5);
        shd_frame_close(&s.f);
    }
}

/* Object space through a matrix, and the transform of the slot after it. */
static void test_object(void **state)
{
    static const float k_to_world[16] = {0, 2, 0, 0, -4, 0, 0, 0, 0, 0, 1, 0, 0.5f, 0.25f, 0, 1};
    static const float k_place[16] = {3, 0, 0, 0, 0, 0, 0.5f, 0, 0, -1, 0, 0, 7, -2, 1, 1};
    scene s;
    shd_draw *draw;
    int i;
    (void)state;
    open_scene(&s);
    memcpy(add_solid(&s, SHD_SLOT_DIFFUSE, SHD_PLACE_SPACE_OBJECT)->place_transform, k_place, sizeof k_place);
    draw = shd_frame_draw(&s.f, s.quad, 6, &s.material);
    memcpy(draw->object_to_world, k_to_world, sizeof k_to_world);
    shd_frame_render(&s.f);
    for (i = 0; i < k_pixels; ++i) {
        /* (X, Y) = (-4 y + 1/2, 2 x + 1/4) and z = 1/2 + x / 4 */
        const double step = 2.0 / k_size;
        const double world_x = (i % k_size + 0.5) * step - 1, world_y = 1 - (i / k_size + 0.5) * step;
        const double x = (world_y - 0.25) / 2, y = (0.5 - world_x) / 4, z = 0.5 + x / 4;
        const double right = 0.5 * step / 4, down[3] = {3 * step / 2, step / 8, 0};
        g.place[0][i] = (float)(3 * x + 7);
        g.place[1][i] = (float)(-z - 2);
        g.place[2][i] = (float)(0.5 * y + 1);
        g.width[i] = (float)fmax(right, sqrt(down[0] * down[0] + down[1] * down[1]));
    }
    evaluate(&s.solid);
    expect_colors(&s, 5e-5);
    shd_frame_close(&s.f);
}

/* A matrix without an inverse puts all places at the origin. */
static void test_singular(void **state)
{
    scene s;
    int i;
    (void)state;
    open_scene(&s);
    add_solid(&s, SHD_SLOT_DIFFUSE, SHD_PLACE_SPACE_OBJECT);
    shd_frame_draw(&s.f, s.quad, 6, &s.material)->object_to_world[10] = 0;
    shd_frame_render(&s.f);
    memset(&g, 0, sizeof g);
    evaluate(&s.solid);
    for (i = 1; i < k_pixels; ++i) assert_true(s.f.plane[0][i] == s.f.plane[0][0]);
    expect_colors(&s, 0);
    shd_frame_close(&s.f);
}

/* A plane in perspective: widths are the exact derivatives of the position, here by differences of the rays' hits. */
static void hit(const double *eye, double x, double y, double *out)
{
    /* A camera that looks along -z with half angles of 45 degrees, above the plane y = 0. */
    const double direction[3] = {x, y, -1};
    const double t = -eye[1] / direction[1];
    int c;
    for (c = 0; c < 3; ++c) out[c] = eye[c] + t * direction[c];
}

static void test_perspective(void **state)
{
    static const float k_floor[4][3] = {{-90, 0, 5}, {90, 0, 5}, {90, 0, -200}, {-90, 0, -200}};
    static const int k_order[6] = {0, 1, 2, 0, 2, 3};
    const double eye[3] = {0.3, 2, 1}, step = 2.0 / k_size, h = 1e-4;
    shd_camera camera = shd_camera_default();
    scene s;
    int i, c, first = k_size / 2 + 1;
    (void)state;
    open_scene(&s);
    s.solid.kind = SHD_SOLID_PERLIN;
    s.solid.size = 2;
    for (i = 0; i < 6; ++i) memcpy(s.quad + 8 * i, k_floor[k_order[i]], sizeof k_floor[0]);
    for (c = 0; c < 3; ++c) {
        camera.eye[c] = (float)eye[c];
        camera.target[c] = (float)(eye[c] - (c == 2));
    }
    camera.fov_y = 1.57079633f;
    camera.aspect = 1;
    camera.near_plane = 0.1f;
    camera.far_plane = 1000;
    shd_assert_ok(shd_view_from_camera(&camera, &s.f.desc.view));
    add_solid(&s, SHD_SLOT_DIFFUSE, SHD_PLACE_SPACE_WORLD);
    shd_frame_draw(&s.f, s.quad, 6, &s.material);
    shd_frame_render(&s.f);
    memset(&g, 0, sizeof g);
    for (i = first * k_size; i < k_pixels; ++i) {
        const double x = (i % k_size + 0.5) * step - 1, y = 1 - (i / k_size + 0.5) * step;
        double at[3], right[3], down[3], lengths[2] = {0, 0};
        hit(eye, x, y, at);
        hit(eye, x + h * step, y, right);
        hit(eye, x, y - h * step, down);
        for (c = 0; c < 3; ++c) {
            g.place[c][i] = (float)at[c];
            lengths[0] += (right[c] - at[c]) * (right[c] - at[c]) / (h * h);
            lengths[1] += (down[c] - at[c]) * (down[c] - at[c]) / (h * h);
        }
        g.width[i] = (float)sqrt(fmax(lengths[0], lengths[1]));
    }
    evaluate(&s.solid);
    for (i = first * k_size; i < k_pixels; ++i) {
        shd_assert_close("floor", (size_t)i, (double)s.f.plane[0][i], (double)g.color[0][i], 1e-3, 0);
    }
    shd_frame_close(&s.f);
}

/* Scalars take one channel; colours with opacity take the fourth. */
static void test_channels(void **state)
{
    uint32_t channel;
    (void)state;
    for (channel = 0; channel < 5; ++channel) {
        scene s;
        size_t i;
        open_scene(&s);
        s.material.blend = SHD_BLEND_STRAIGHT;
        add_solid(&s, channel < 4 ? SHD_SLOT_OPACITY : SHD_SLOT_DIFFUSE, SHD_PLACE_SPACE_WORLD)->channel = channel % 4;
        shd_frame_draw(&s.f, s.quad, 6, &s.material);
        shd_frame_render(&s.f);
        find_quad_places();
        evaluate(&s.solid);
        for (i = 0; i < k_pixels; ++i) {
            const double want = (double)g.color[channel < 4 ? channel : 3][i];
            shd_assert_close("opacity", i, (double)s.f.plane[SHD_PLANE_A][i], want, 2e-5, 0);
        }
        shd_frame_close(&s.f);
    }
}

/* A procedure and a fragment program evaluate the solid texture at their fragments. */
static void color_of(const shd_solid_desc *solid, const shd_fragments *in, float *const *out)
{
    shd_solid_points points = shd_solid_points_default();
    shd_solid_values values = shd_solid_values_default();
    int c;
    points.count = in->count;
    points.position[0].data = in->px;
    points.position[1].data = in->py;
    points.position[2].data = in->pz;
    for (c = 0; c < 3; ++c) values.channel[c].data = out[c];
    if (shd_solid_evaluate(g_context, solid, &points, &values) != SHD_OK) memset(out[0], 0, in->count * sizeof(float));
}
static void procedure(const shd_fragments *in, float *const out[4], void *user_data)
{
    color_of((const shd_solid_desc *)user_data, in, out);
}
static void program(const shd_fragments *in, shd_radiance *out, void *user_data)
{
    float *const columns[3] = {out->r, out->g, out->b};
    color_of((const shd_solid_desc *)user_data, in, columns);
}

static void test_programs(void **state)
{
    static float want[3][k_pixels];
    int kind, c;
    (void)state;
    for (kind = 0; kind < 3; ++kind) {
        scene s;
        open_scene(&s);
        s.solid.octaves = 1; /* no band limit at this width */
        s.solid.kind = SHD_SOLID_SIMPLEX;
        if (kind == 0) add_solid(&s, SHD_SLOT_DIFFUSE, SHD_PLACE_SPACE_WORLD);
        if (kind == 1) {
            shd_slot_list_add(&s.slots, &s.material, shd_slot_procedure(SHD_SLOT_DIFFUSE, procedure, &s.solid));
        }
        if (kind == 2) {
            s.material.model = SHD_MODEL_PROGRAM;
            s.material.program.fragment = program;
            s.material.program.user_data = &s.solid;
        }
        shd_frame_draw(&s.f, s.quad, 6, &s.material);
        shd_frame_render(&s.f);
        for (c = 0; c < 3; ++c) {
            if (kind == 0) memcpy(want[c], s.f.plane[c], sizeof want[c]);
            assert_memory_equal(s.f.plane[c], want[c], sizeof want[c]);
        }
        shd_frame_close(&s.f);
    }
}

int main(void)
{
    static const struct CMUnitTest k_tests[] = {
        {"world", test_world, NULL, NULL, NULL},       {"object", test_object, NULL, NULL, NULL},
        {"singular", test_singular, NULL, NULL, NULL}, {"perspective", test_perspective, NULL, NULL, NULL},
        {"channels", test_channels, NULL, NULL, NULL}, {"programs", test_programs, NULL, NULL, NULL},
    };
    return cmocka_run_group_tests_name("api.solid_slots", k_tests, set_up, tear_down);
}
