/* SPDX-License-Identifier: MIT */
/* Normal maps and bumps with computed tangents: up in the texture is up in the picture, and on flat faces the
 * tangents of the mesh equal those that a triangle's own uv give. */
#include "support/frame.h"

enum { SIZE = 48, TEXELS = 32 };

/* Orientation of u and v on the square: the uv of its corners. */
static const struct orient_case {
    const char *name;
    float uv[4][2]; /* at (-, -), (+, -), (+, +), (-, +) of x, y */
    float mirror;   /* x of object_to_world */
} k_cases[] = {
    {"upright", {{0, 1}, {1, 1}, {1, 0}, {0, 0}}, 1},
    {"mirrored_uv", {{1, 1}, {0, 1}, {0, 0}, {1, 0}}, 1},
    {"turned_uv", {{0, 0}, {0, 1}, {1, 1}, {1, 0}}, 1},
    {"mirrored_matrix", {{0, 1}, {1, 1}, {1, 0}, {0, 0}}, -1},
    {"mirrored_uv_and_matrix", {{1, 1}, {0, 1}, {0, 0}, {1, 0}}, -1},
};

/* A dome in the middle of the texture: its heights, or its normals with green up in the picture. */
static shd_texture *make_dome(shd_context *context, int normals)
{
    static float texels[TEXELS * TEXELS][4];
    shd_texture_desc desc = shd_texture_desc_default();
    shd_texture *texture = NULL;
    int x, y;
    for (y = 0; y < TEXELS; ++y) {
        for (x = 0; x < TEXELS; ++x) {
            const double dx = (x + 0.5) / TEXELS - 0.5, dy = 0.5 - (y + 0.5) / TEXELS; /* right and up */
            const double n = sqrt(1 + 16 * (dx * dx + dy * dy));
            float *t = texels[y * TEXELS + x];
            t[0] = (float)(normals ? 4 * dx / n : 20 - 2 * TEXELS * (dx * dx + dy * dy));
            t[1] = (float)(4 * dy / n);
            t[2] = (float)(1 / n);
            t[3] = 1;
        }
    }
    desc.format = SHD_FORMAT_RGBA32F;
    desc.width = desc.height = TEXELS;
    desc.texels = texels;
    shd_assert_ok(shd_texture_create(context, &desc, &texture));
    return texture;
}

struct pictures {
    double normal[2][2][SIZE * SIZE]; /* [mesh has tangents][x, y] of the shown normal */
};

/* Renders a square with the normal map or the bump, and reads its normals from SHD_DEBUG_VIEW_NORMAL. */
static void show(const struct orient_case *c, int bump, int has_tangents, double *x, double *y)
{
    static const float k_place[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    static const uint32_t k_indices[6] = {0, 1, 2, 0, 2, 3};
    float rows[4][8];
    shd_material_desc material = shd_material_desc_default();
    shd_mesh_desc mesh_desc = shd_mesh_desc_default();
    shd_mesh *mesh = NULL;
    shd_draw *draw;
    shd_frame f;
    shd_texture *texture;
    shd_slot slot;
    int i, k;
    shd_frame_open(&f, SIZE, SIZE);
    texture = make_dome(f.context, !bump);
    material.debug_view = SHD_DEBUG_VIEW_NORMAL;
    slot = shd_slot_texture(bump ? SHD_SLOT_HEIGHT : SHD_SLOT_NORMAL, texture, NULL);
    material.slots = &slot;
    material.slot_count = 1;
    material.bump = SHD_BUMP_TEXEL;
    for (i = 0; i < 4; ++i) {
        memset(rows[i], 0, sizeof rows[i]);
        for (k = 0; k < 2; ++k) rows[i][k] = k_place[i][k];
        rows[i][2] = 0.5f;
        rows[i][5] = 1;
        for (k = 0; k < 2; ++k) rows[i][6 + k] = c->uv[i][k];
    }
    mesh_desc.vertex_count = 4;
    for (k = 0; k < 8; ++k) {
        shd_f32_in *column = k < 3 ? &mesh_desc.position[k] : k < 6 ? &mesh_desc.normal[k - 3] : &mesh_desc.uv[k - 6];
        column->data = &rows[0][k];
        column->stride = sizeof rows[0];
    }
    mesh_desc.indices.data = k_indices;
    mesh_desc.index_count = 6;
    mesh_desc.flags = has_tangents ? SHD_MESH_TANGENTS : 0;
    shd_assert_ok(shd_mesh_create(f.context, &mesh_desc, &mesh));
    draw = shd_frame_draw(&f, rows[0], 3, &material);
    draw->mesh = mesh;
    draw->object_to_world[0] = c->mirror;
    draw->cull = SHD_CULL_NONE;
    shd_frame_render(&f);
    for (i = 0; i < SIZE * SIZE; ++i) {
        x[i] = 2 * (double)f.plane[SHD_PLANE_R][i] - 1;
        y[i] = 2 * (double)f.plane[SHD_PLANE_G][i] - 1;
    }
    shd_texture_release(texture);
    shd_mesh_release(mesh);
    shd_frame_close(&f);
}

/* Normals of the dome point away from its middle for every uv orientation and matrix. */
static void test_dome(void **state)
{
    static struct pictures p;
    const struct orient_case *c = (const struct orient_case *)*state;
    int bump, i, k;
    for (bump = 0; bump < 2; ++bump) {
        for (k = 0; k < 2; ++k) show(c, bump, k, p.normal[k][0], p.normal[k][1]);
        for (i = 0; i < SIZE * SIZE; ++i) {
            const double right = (i % SIZE + 0.5) / SIZE - 0.5, up = 0.5 - (i / SIZE + 0.5) / SIZE;
            for (k = 0; k < 2; ++k) {
                shd_assert_close("as the triangle's", (size_t)i, p.normal[1][k][i], p.normal[0][k][i], 1e-5, 0);
            }
            if (fabs(right) > 0.45 || fabs(up) > 0.45) continue; /* the texture repeats */
            if (fabs(right) > 0.1) assert_true(p.normal[1][0][i] * right > 0);
            if (fabs(up) > 0.1) assert_true(p.normal[1][1][i] * up > 0);
        }
    }
}

#define COUNT(table) (sizeof(table) / sizeof(table)[0])

int main(void)
{
    static struct CMUnitTest tests[COUNT(k_cases)];
    size_t i;
    for (i = 0; i < COUNT(k_cases); ++i) {
        tests[i] = (struct CMUnitTest){k_cases[i].name, test_dome, NULL, NULL, (void *)&k_cases[i]};
    }
    return _cmocka_run_group_tests("api.mesh_tangents_render", tests, COUNT(k_cases), NULL, NULL);
}
