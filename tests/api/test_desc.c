/* SPDX-License-Identifier: MIT */
/* shd_desc_init writes what the inline defaults return, into structs of any later size, and refuses the rest. */
#include "support/check.h"

#include <shd/color.h>
#include <shd/io.h>
#include <shd/scene.h>
#include <shd/shd.h>

enum { LARGEST = 4096 };

struct kind_case {
    const char *name;
    shd_desc_kind kind;
    size_t size;
    void (*defaults)(void *out);
};

#define DEFAULTS(type, noun)                 \
    static void defaults_##noun(void *p)     \
    {                                        \
        const type value = noun##_default(); \
        memcpy(p, &value, sizeof value);     \
    }
DEFAULTS(shd_context_desc, shd_context_desc)
DEFAULTS(shd_texture_desc, shd_texture_desc)
DEFAULTS(shd_sampler_desc, shd_sampler_desc)
DEFAULTS(shd_lookups, shd_lookups)
DEFAULTS(shd_mesh_desc, shd_mesh_desc)
DEFAULTS(shd_material_desc, shd_material_desc)
DEFAULTS(shd_light_desc, shd_light_desc)
DEFAULTS(shd_framebuffer_desc, shd_framebuffer_desc)
DEFAULTS(shd_draw, shd_draw)
DEFAULTS(shd_render_desc, shd_render_desc)
DEFAULTS(shd_image, shd_image)
DEFAULTS(shd_camera, shd_camera)
DEFAULTS(shd_color_desc, shd_color_desc)
DEFAULTS(shd_load_desc, shd_load_desc)
DEFAULTS(shd_save_desc, shd_save_desc)
DEFAULTS(shd_ray_differentials, shd_ray_differentials)
DEFAULTS(shd_ray_cones, shd_ray_cones)
DEFAULTS(shd_explanation, shd_explanation)
DEFAULTS(shd_mip_desc, shd_mip_desc)
DEFAULTS(shd_edges_desc, shd_edges_desc)
DEFAULTS(shd_shadow_desc, shd_shadow_desc)
DEFAULTS(shd_shadow_render_desc, shd_shadow_render_desc)
DEFAULTS(shd_shadow_lookups, shd_shadow_lookups)
DEFAULTS(shd_tessellation_desc, shd_tessellation_desc)
DEFAULTS(shd_shape_desc, shd_shape_desc)
DEFAULTS(shd_shape_columns, shd_shape_columns)
DEFAULTS(shd_scene_desc, shd_scene_desc)
DEFAULTS(shd_scene_info, shd_scene_info)
DEFAULTS(shd_scene_instance, shd_scene_instance)

static const struct kind_case k_kinds[] = {
    {"context", SHD_DESC_CONTEXT, sizeof(shd_context_desc), defaults_shd_context_desc},
    {"texture", SHD_DESC_TEXTURE, sizeof(shd_texture_desc), defaults_shd_texture_desc},
    {"sampler", SHD_DESC_SAMPLER, sizeof(shd_sampler_desc), defaults_shd_sampler_desc},
    {"lookups", SHD_DESC_LOOKUPS, sizeof(shd_lookups), defaults_shd_lookups},
    {"mesh", SHD_DESC_MESH, sizeof(shd_mesh_desc), defaults_shd_mesh_desc},
    {"material", SHD_DESC_MATERIAL, sizeof(shd_material_desc), defaults_shd_material_desc},
    {"light", SHD_DESC_LIGHT, sizeof(shd_light_desc), defaults_shd_light_desc},
    {"framebuffer", SHD_DESC_FRAMEBUFFER, sizeof(shd_framebuffer_desc), defaults_shd_framebuffer_desc},
    {"draw", SHD_DESC_DRAW, sizeof(shd_draw), defaults_shd_draw},
    {"render", SHD_DESC_RENDER, sizeof(shd_render_desc), defaults_shd_render_desc},
    {"image", SHD_DESC_IMAGE, sizeof(shd_image), defaults_shd_image},
    {"camera", SHD_DESC_CAMERA, sizeof(shd_camera), defaults_shd_camera},
    {"color", SHD_DESC_COLOR, sizeof(shd_color_desc), defaults_shd_color_desc},
    {"load", SHD_DESC_LOAD, sizeof(shd_load_desc), defaults_shd_load_desc},
    {"save", SHD_DESC_SAVE, sizeof(shd_save_desc), defaults_shd_save_desc},
    {"ray_differentials", SHD_DESC_RAY_DIFFERENTIALS, sizeof(shd_ray_differentials), defaults_shd_ray_differentials},
    {"ray_cones", SHD_DESC_RAY_CONES, sizeof(shd_ray_cones), defaults_shd_ray_cones},
    {"explanation", SHD_DESC_EXPLANATION, sizeof(shd_explanation), defaults_shd_explanation},
    {"mip", SHD_DESC_MIP, sizeof(shd_mip_desc), defaults_shd_mip_desc},
    {"edges", SHD_DESC_EDGES, sizeof(shd_edges_desc), defaults_shd_edges_desc},
    {"shadow", SHD_DESC_SHADOW, sizeof(shd_shadow_desc), defaults_shd_shadow_desc},
    {"shadow_render", SHD_DESC_SHADOW_RENDER, sizeof(shd_shadow_render_desc), defaults_shd_shadow_render_desc},
    {"shadow_lookups", SHD_DESC_SHADOW_LOOKUPS, sizeof(shd_shadow_lookups), defaults_shd_shadow_lookups},
    {"tessellation", SHD_DESC_TESSELLATION, sizeof(shd_tessellation_desc), defaults_shd_tessellation_desc},
    {"shape", SHD_DESC_SHAPE, sizeof(shd_shape_desc), defaults_shd_shape_desc},
    {"shape_columns", SHD_DESC_SHAPE_COLUMNS, sizeof(shd_shape_columns), defaults_shd_shape_columns},
    {"scene", SHD_DESC_SCENE, sizeof(shd_scene_desc), defaults_shd_scene_desc},
    {"scene_info", SHD_DESC_SCENE_INFO, sizeof(shd_scene_info), defaults_shd_scene_info},
    {"scene_instance", SHD_DESC_SCENE_INSTANCE, sizeof(shd_scene_instance), defaults_shd_scene_instance},
};

static void test_kind(void **state)
{
    const struct kind_case *c = (const struct kind_case *)*state;
    union {
        unsigned char bytes[LARGEST];
        double aligned;
    } got, want, untouched;
    uint32_t size;
    assert_true(c->size + 24 <= LARGEST);

    memset(got.bytes, 0xa5, LARGEST);
    memset(want.bytes, 0xa5, LARGEST);
    memset(untouched.bytes, 0xa5, LARGEST);
    c->defaults(want.bytes);
    shd_assert_ok(shd_desc_init(c->kind, got.bytes, c->size));
    assert_memory_equal(got.bytes, want.bytes, LARGEST);

    /* A later header's struct: the known part, then zero. */
    size = (uint32_t)(c->size + 16);
    memset(want.bytes + c->size, 0, 16);
    memcpy(want.bytes, &size, sizeof size);
    shd_assert_ok(shd_desc_init(c->kind, got.bytes, size));
    assert_memory_equal(got.bytes, want.bytes, LARGEST);

    memset(got.bytes, 0xa5, LARGEST);
    shd_assert_result("small", shd_desc_init(c->kind, got.bytes, c->size - 1), SHD_ERROR_INVALID_ARGUMENT,
                      "desc_init.size");
    shd_assert_result("huge", shd_desc_init(c->kind, got.bytes, 65537), SHD_ERROR_INVALID_ARGUMENT,
                      "desc_init.size: 65537 is above 65536");
    shd_assert_result("null", shd_desc_init(c->kind, NULL, c->size), SHD_ERROR_INVALID_ARGUMENT, "desc_init.ptr: NULL");
    assert_memory_equal(got.bytes, untouched.bytes, LARGEST);
}

static void test_unknown_kinds(void **state)
{
    const int32_t kinds[] = {0, 999, 1000, 0x7fffffff, -1};
    unsigned char bytes[LARGEST];
    size_t i;
    (void)state;
    for (i = 0; i < sizeof kinds / sizeof kinds[0]; ++i) {
        shd_desc_kind kind;
        memcpy(&kind, &kinds[i], sizeof kind);
        shd_assert_result("unknown", shd_desc_init(kind, bytes, sizeof bytes), SHD_ERROR_INVALID_ARGUMENT,
                          "is not a desc");
    }
}

int main(void)
{
    struct CMUnitTest tests[40];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_kinds / sizeof k_kinds[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_kinds[i].name, test_kind, NULL, NULL, (void *)&k_kinds[i]};
    }
    tests[n++] = (struct CMUnitTest){"unknown_kinds", test_unknown_kinds, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.desc", tests, n, NULL, NULL);
}
