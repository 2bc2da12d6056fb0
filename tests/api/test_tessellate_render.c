/* SPDX-License-Identifier: MIT */
/* A tessellated mesh without displacement renders like the original mesh, except for samples on edges and rounding. */
#include "support/frame.h"

enum { SIZE = 160, ACROSS = 12, DOWN = 8 };

/* A sphere of few triangles, three vertices each. Returns the number of vertices. */
static uint32_t make_sphere(float rows[][8])
{
    uint32_t n = 0;
    int x, y, k;
    for (y = 0; y < DOWN; ++y) {
        for (x = 0; x < ACROSS; ++x) {
            static const int k_corner[6][2] = {{0, 0}, {0, 1}, {1, 1}, {0, 0}, {1, 1}, {1, 0}};
            for (k = 0; k < 6; ++k) {
                const int i = x + k_corner[k][0], j = y + k_corner[k][1];
                const double a = 6.283185307179586 * (i % ACROSS) / ACROSS, b = 3.141592653589793 * j / DOWN;
                float *row = rows[n++];
                row[3] = row[0] = (float)(cos(a) * sin(b));
                row[4] = row[1] = (float)cos(b);
                row[5] = row[2] = (float)(-sin(a) * sin(b));
                row[6] = (float)i / ACROSS;
                row[7] = (float)j / DOWN;
            }
        }
    }
    return n;
}

struct render_case {
    const char *name;
    shd_frequency frequency;
    shd_tessellation_mode mode;
    uint32_t segments;
    float edge_length;
    double tolerance;
};
static const struct render_case k_cases[] = {
    {"phong/uniform_1", SHD_FREQUENCY_PHONG, SHD_TESSELLATION_MODE_UNIFORM, 1, 8, 0},
    {"phong/uniform_5", SHD_FREQUENCY_PHONG, SHD_TESSELLATION_MODE_UNIFORM, 5, 8, 2e-3},
    {"phong/adaptive_6_pixels", SHD_FREQUENCY_PHONG, SHD_TESSELLATION_MODE_ADAPTIVE, 1, 6, 2e-3},
    {"flat/uniform_1", SHD_FREQUENCY_FLAT, SHD_TESSELLATION_MODE_UNIFORM, 1, 8, 0},
};

static void render(shd_frame *f, float *color)
{
    int c;
    shd_frame_render(f);
    for (c = 0; c < 3; ++c) memcpy(color + c * SIZE * SIZE, f->plane[SHD_PLANE_R + c], SIZE * SIZE * sizeof(float));
}

static void test_same_picture(void **state)
{
    static float rows[6 * ACROSS * DOWN][8], before[3 * SIZE * SIZE], after[3 * SIZE * SIZE];
    const struct render_case *c = (const struct render_case *)*state;
    shd_material_desc material = shd_material_desc_default();
    shd_light_desc light = shd_light_desc_default();
    shd_tessellation_desc desc = shd_tessellation_desc_default();
    shd_camera camera = shd_camera_default();
    shd_mesh *cut = NULL;
    shd_draw *draw;
    shd_frame f;
    size_t i, differ = 0, lit = 0;
    shd_frame_open(&f, SIZE, SIZE);
    material.model = SHD_MODEL_LAMBERT;
    draw = shd_frame_draw(&f, rows[0], make_sphere(rows), &material);
    draw->frequency = c->frequency;
    light.kind = SHD_LIGHT_KIND_DIRECTIONAL;
    light.direction[0] = -0.5f;
    light.direction[1] = -0.7f;
    light.direction[2] = -0.5f;
    shd_frame_light(&f, &light);
    camera.eye[1] = 1;
    shd_assert_ok(shd_view_from_camera(&camera, &f.desc.view));
    render(&f, before);
    desc.mode = c->mode;
    desc.segments = c->segments;
    desc.edge_length = c->edge_length;
    desc.view = f.desc.view;
    desc.picture_width = desc.picture_height = SIZE;
    shd_assert_ok(shd_mesh_tessellate(f.context, f.mesh[0], &desc, &cut));
    draw->mesh = cut;
    render(&f, after);
    for (i = 0; i < 3 * SIZE * SIZE; ++i) {
        lit += before[i] > 0.01f;
        differ += !(fabs((double)before[i] - (double)after[i]) <= c->tolerance);
    }
    assert_true(lit > SIZE * SIZE / 2);
    if (differ * 500 > lit) fail_msg("%s: %zu of %zu values differ", c->name, differ, lit);
    shd_mesh_release(cut);
    shd_frame_close(&f);
}

#define COUNT(table) (sizeof(table) / sizeof(table)[0])

int main(void)
{
    static struct CMUnitTest tests[COUNT(k_cases)];
    size_t i;
    for (i = 0; i < COUNT(k_cases); ++i) {
        tests[i] = (struct CMUnitTest){k_cases[i].name, test_same_picture, NULL, NULL, (void *)&k_cases[i]};
    }
    return _cmocka_run_group_tests("api.tessellate_render", tests, COUNT(k_cases), NULL, NULL);
}
