/* SPDX-License-Identifier: MIT */
/* Height maps without a slope: a constant one, one of a single texel, and texels that are not finite do not tilt the
 * normal of the surface, for normals along every axis. */
#include "support/frame.h"
#include "support/rows.h"

enum { EDGE = 12 };

struct flat_case {
    const char *name;
    uint32_t size;
    float height, step; /* height of the first texel; step from one texel to the next */
};
static const struct flat_case k_flat[] = {
    {"flat/1x1", 1, 0.5f, 0},      {"flat/constant", 4, 0.25f, 0}, {"flat/zero", 4, 0, 0},
    {"flat/1e-30", 4, 1e-30f, 0},  {"flat/negative", 4, -3, 0},    {"flat/1x1_of_1e30", 1, 1e30f, 0},
    {"flat/nan", 4, NAN, 0},       {"flat/inf", 4, INFINITY, 0},   {"flat/1x1_of_nan", 1, NAN, 0},
    {"tilted", 4, 0.25f, 0.0625f},
};
static const float k_normals[6][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

/* Renders a quad with this vertex normal as colours; without a texture there is no bump. */
static void render_normals(const float normal[3], const struct flat_case *c, shd_bump bump, float out[3][EDGE * EDGE])
{
    float vertices[48], heights[16];
    shd_material_desc material = shd_material_desc_default();
    shd_texture_desc texture_desc = shd_texture_desc_default();
    shd_texture *texture = NULL;
    shd_slot slot;
    shd_frame f;
    int i, k;
    shd_frame_open(&f, EDGE, EDGE);
    shd_frame_quad(-1, -1, 1, 1, 0.5f, 0.5f, vertices);
    for (i = 0; i < 6; ++i) memcpy(vertices + 8 * i + 3, normal, 3 * sizeof(float));
    material.debug_view = SHD_DEBUG_VIEW_NORMAL;
    if (c) {
        for (i = 0; i < 16; ++i) heights[i] = c->height + c->step * (float)i;
        texture_desc.format = SHD_FORMAT_R32F;
        texture_desc.width = texture_desc.height = c->size;
        texture_desc.texels = heights;
        texture_desc.tables = SHD_TABLE_MIPMAP;
        shd_assert_ok(shd_texture_create(f.context, &texture_desc, &texture));
        slot = shd_slot_texture(SHD_SLOT_HEIGHT, texture, NULL);
        material.slots = &slot;
        material.slot_count = 1;
        material.bump = bump;
        material.bump_scale = 5;
    }
    shd_frame_draw(&f, vertices, 6, &material);
    shd_frame_render(&f);
    assert_int_equal(f.stats.fragment_count, EDGE * EDGE);
    for (k = 0; k < 3; ++k) memcpy(out[k], f.plane[k], sizeof out[k]);
    shd_texture_release(texture);
    shd_frame_close(&f);
}

static void test_flat(void **state)
{
    const struct flat_case *c = (const struct flat_case *)*state;
    static float plain[3][EDGE * EDGE], bumped[3][EDGE * EDGE];
    int axis, bump;
    for (axis = 0; axis < 6; ++axis) {
        render_normals(k_normals[axis], NULL, (shd_bump)0, plain);
        shd_assert_close("plain", 0, (double)plain[axis / 2][0], axis % 2 ? 0 : 1, 1e-6, 0);
        for (bump = 0; bump < 3; ++bump) {
            render_normals(k_normals[axis], c, (shd_bump)bump, bumped);
            /* The last row tilts a normal across the quad, which shows that the heights are used. */
            if (c->step != 0 && bump != SHD_BUMP_NONE && axis >= 4) {
                assert_true(memcmp(plain, bumped, sizeof plain) != 0);
            } else if (c->step == 0 && memcmp(plain, bumped, sizeof plain) != 0) {
                fail_msg("%s, normal %d, bump %d: (%g, %g, %g), not (%g, %g, %g)", c->name, axis, bump,
                         (double)bumped[0][0], (double)bumped[1][0], (double)bumped[2][0], (double)plain[0][0],
                         (double)plain[1][0], (double)plain[2][0]);
            }
        }
    }
}

int main(void)
{
    ADD_ROWS(k_flat, test_flat);
    return _cmocka_run_group_tests("api.bump_flat", g_tests, g_count, NULL, NULL);
}
