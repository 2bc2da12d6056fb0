/* SPDX-License-Identifier: MIT */
/* shd_desc_init writes the values that the inline defaults return, into structs of any size that contains the
 * required fields. */
#include "support/check.h"

#include <shd/color.h>
#include <shd/io.h>
#include <shd/scene.h>
#include <shd/shd.h>
#include <shd/texture_file.h>
#include <shd/volume_file.h>

enum { LARGEST = 4096 };

struct kind_case {
    const char *name;
    shd_desc_kind kind;
    size_t size, alignment;
    size_t required; /* size up to the end of the last required field */
    void (*defaults)(void *out);
};

#define DEFAULTS(type)                       \
    static void defaults_##type(void *p)     \
    {                                        \
        const type value = type##_default(); \
        memcpy(p, &value, sizeof value);     \
    }
DEFAULTS(shd_context_desc)
DEFAULTS(shd_image)
DEFAULTS(shd_texture_desc)
DEFAULTS(shd_texture_info)
DEFAULTS(shd_mip_desc)
DEFAULTS(shd_sampler_desc)
DEFAULTS(shd_lookups)
DEFAULTS(shd_texels)
DEFAULTS(shd_levels)
DEFAULTS(shd_explanation)
DEFAULTS(shd_ray_differentials)
DEFAULTS(shd_ray_cones)
DEFAULTS(shd_solid_desc)
DEFAULTS(shd_polygon_desc)
DEFAULTS(shd_polygon_points)
DEFAULTS(shd_polygon_weights)
DEFAULTS(shd_solid_points)
DEFAULTS(shd_solid_values)
DEFAULTS(shd_bake_desc)
DEFAULTS(shd_bake_stats)
DEFAULTS(shd_occlusion_desc)
DEFAULTS(shd_occlusion_points)
DEFAULTS(shd_occlusion_atlas)
DEFAULTS(shd_bounds_desc)
DEFAULTS(shd_derivatives)
DEFAULTS(shd_mesh_desc)
DEFAULTS(shd_mesh_info)
DEFAULTS(shd_edges_desc)
DEFAULTS(shd_edges)
DEFAULTS(shd_tessellation_desc)
DEFAULTS(shd_material_desc)
DEFAULTS(shd_light_desc)
DEFAULTS(shd_shadow_desc)
DEFAULTS(shd_shadow_render_desc)
DEFAULTS(shd_shadow_lookups)
DEFAULTS(shd_environment_desc)
DEFAULTS(shd_environment_info)
DEFAULTS(shd_environment_lookups)
DEFAULTS(shd_environment_light)
DEFAULTS(shd_framebuffer_desc)
DEFAULTS(shd_framebuffer_info)
DEFAULTS(shd_plane_view)
DEFAULTS(shd_camera)
DEFAULTS(shd_draw)
DEFAULTS(shd_render_desc)
DEFAULTS(shd_render_stats)
DEFAULTS(shd_color_desc)
DEFAULTS(shd_load_desc)
DEFAULTS(shd_save_desc)
DEFAULTS(shd_bitmap_info)
DEFAULTS(shd_raw_desc)
DEFAULTS(shd_stack_desc)
DEFAULTS(shd_vdb_desc)
DEFAULTS(shd_vdb_info)
DEFAULTS(shd_texture_file_info)
DEFAULTS(shd_ktx2_desc)
DEFAULTS(shd_shape_desc)
DEFAULTS(shd_shape_columns)
DEFAULTS(shd_scene_desc)
DEFAULTS(shd_scene_info)
DEFAULTS(shd_scene_instance)
DEFAULTS(shd_directions)
DEFAULTS(shd_projected_points)
DEFAULTS(shd_image_points)
DEFAULTS(shd_point_directions)
DEFAULTS(shd_direction_images)
DEFAULTS(shd_volume_desc)
DEFAULTS(shd_volume_draw)
static void defaults_shd_slot(void *p)
{
    const shd_slot value = shd_slot_default(SHD_SLOT_DIFFUSE);
    memcpy(p, &value, sizeof value);
}

#define ALIGNMENT(type) \
    offsetof(            \
        struct {         \
            char first;  \
            type second; \
        },               \
        second)
/* Two columns of the table. */
#define REQUIRED(type, field) ALIGNMENT(type), (offsetof(type, field) + sizeof(((type *)0)->field))

static const struct kind_case k_kinds[] = {
    {"context_desc", SHD_DESC_KIND_CONTEXT_DESC, sizeof(shd_context_desc), REQUIRED(shd_context_desc, simd),
     defaults_shd_context_desc},
    {"image", SHD_DESC_KIND_IMAGE, sizeof(shd_image), REQUIRED(shd_image, pixels), defaults_shd_image},
    {"texture_desc", SHD_DESC_KIND_TEXTURE_DESC, sizeof(shd_texture_desc), REQUIRED(shd_texture_desc, texels),
     defaults_shd_texture_desc},
    {"texture_info", SHD_DESC_KIND_TEXTURE_INFO, sizeof(shd_texture_info), REQUIRED(shd_texture_info, height),
     defaults_shd_texture_info},
    {"mip_desc", SHD_DESC_KIND_MIP_DESC, sizeof(shd_mip_desc), REQUIRED(shd_mip_desc, content), defaults_shd_mip_desc},
    {"sampler_desc", SHD_DESC_KIND_SAMPLER_DESC, sizeof(shd_sampler_desc), REQUIRED(shd_sampler_desc, filter),
     defaults_shd_sampler_desc},
    {"lookups", SHD_DESC_KIND_LOOKUPS, sizeof(shd_lookups), REQUIRED(shd_lookups, v), defaults_shd_lookups},
    {"texels", SHD_DESC_KIND_TEXELS, sizeof(shd_texels), REQUIRED(shd_texels, channel), defaults_shd_texels},
    {"levels", SHD_DESC_KIND_LEVELS, sizeof(shd_levels), REQUIRED(shd_levels, lod), defaults_shd_levels},
    {"explanation", SHD_DESC_KIND_EXPLANATION, sizeof(shd_explanation), REQUIRED(shd_explanation, blend_count),
     defaults_shd_explanation},
    {"ray_differentials", SHD_DESC_KIND_RAY_DIFFERENTIALS, sizeof(shd_ray_differentials),
     REQUIRED(shd_ray_differentials, direction), defaults_shd_ray_differentials},
    {"ray_cones", SHD_DESC_KIND_RAY_CONES, sizeof(shd_ray_cones), REQUIRED(shd_ray_cones, width),
     defaults_shd_ray_cones},
    {"derivatives", SHD_DESC_KIND_DERIVATIVES, sizeof(shd_derivatives), REQUIRED(shd_derivatives, dudx),
     defaults_shd_derivatives},
    {"mesh_desc", SHD_DESC_KIND_MESH_DESC, sizeof(shd_mesh_desc), REQUIRED(shd_mesh_desc, position),
     defaults_shd_mesh_desc},
    {"mesh_info", SHD_DESC_KIND_MESH_INFO, sizeof(shd_mesh_info), REQUIRED(shd_mesh_info, triangle_count),
     defaults_shd_mesh_info},
    {"edges_desc", SHD_DESC_KIND_EDGES_DESC, sizeof(shd_edges_desc), REQUIRED(shd_edges_desc, edges),
     defaults_shd_edges_desc},
    {"edges", SHD_DESC_KIND_EDGES, sizeof(shd_edges), REQUIRED(shd_edges, vertex), defaults_shd_edges},
    {"tessellation_desc", SHD_DESC_KIND_TESSELLATION_DESC, sizeof(shd_tessellation_desc),
     REQUIRED(shd_tessellation_desc, mode), defaults_shd_tessellation_desc},
    {"polygon_desc", SHD_DESC_KIND_POLYGON_DESC, sizeof(shd_polygon_desc), REQUIRED(shd_polygon_desc, vertex_count),
     defaults_shd_polygon_desc},
    {"polygon_points", SHD_DESC_KIND_POLYGON_POINTS, sizeof(shd_polygon_points), REQUIRED(shd_polygon_points, position),
     defaults_shd_polygon_points},
    {"polygon_weights", SHD_DESC_KIND_POLYGON_WEIGHTS, sizeof(shd_polygon_weights),
     REQUIRED(shd_polygon_weights, weight), defaults_shd_polygon_weights},
    {"solid_desc", SHD_DESC_KIND_SOLID_DESC, sizeof(shd_solid_desc), REQUIRED(shd_solid_desc, kind),
     defaults_shd_solid_desc},
    {"solid_points", SHD_DESC_KIND_SOLID_POINTS, sizeof(shd_solid_points), REQUIRED(shd_solid_points, position),
     defaults_shd_solid_points},
    {"solid_values", SHD_DESC_KIND_SOLID_VALUES, sizeof(shd_solid_values), REQUIRED(shd_solid_values, value),
     defaults_shd_solid_values},
    {"bake_desc", SHD_DESC_KIND_BAKE_DESC, sizeof(shd_bake_desc), REQUIRED(shd_bake_desc, dilation),
     defaults_shd_bake_desc},
    {"bake_stats", SHD_DESC_KIND_BAKE_STATS, sizeof(shd_bake_stats), REQUIRED(shd_bake_stats, triangles),
     defaults_shd_bake_stats},
    {"occlusion_desc", SHD_DESC_KIND_OCCLUSION_DESC, sizeof(shd_occlusion_desc), REQUIRED(shd_occlusion_desc, rays),
     defaults_shd_occlusion_desc},
    {"occlusion_points", SHD_DESC_KIND_OCCLUSION_POINTS, sizeof(shd_occlusion_points),
     REQUIRED(shd_occlusion_points, normal), defaults_shd_occlusion_points},
    {"occlusion_atlas", SHD_DESC_KIND_OCCLUSION_ATLAS, sizeof(shd_occlusion_atlas),
     REQUIRED(shd_occlusion_atlas, height), defaults_shd_occlusion_atlas},
    {"bounds_desc", SHD_DESC_KIND_BOUNDS_DESC, sizeof(shd_bounds_desc), REQUIRED(shd_bounds_desc, srgb_error),
     defaults_shd_bounds_desc},
    {"material_desc", SHD_DESC_KIND_MATERIAL_DESC, sizeof(shd_material_desc), REQUIRED(shd_material_desc, model),
     defaults_shd_material_desc},
    {"slot", SHD_DESC_KIND_SLOT, sizeof(shd_slot), REQUIRED(shd_slot, user_data), defaults_shd_slot},
    {"light_desc", SHD_DESC_KIND_LIGHT_DESC, sizeof(shd_light_desc), REQUIRED(shd_light_desc, position),
     defaults_shd_light_desc},
    {"shadow_desc", SHD_DESC_KIND_SHADOW_DESC, sizeof(shd_shadow_desc), REQUIRED(shd_shadow_desc, filter),
     defaults_shd_shadow_desc},
    {"shadow_render_desc", SHD_DESC_KIND_SHADOW_RENDER_DESC, sizeof(shd_shadow_render_desc),
     REQUIRED(shd_shadow_render_desc, light), defaults_shd_shadow_render_desc},
    {"shadow_lookups", SHD_DESC_KIND_SHADOW_LOOKUPS, sizeof(shd_shadow_lookups), REQUIRED(shd_shadow_lookups, position),
     defaults_shd_shadow_lookups},
    {"framebuffer_desc", SHD_DESC_KIND_FRAMEBUFFER_DESC, sizeof(shd_framebuffer_desc),
     REQUIRED(shd_framebuffer_desc, height), defaults_shd_framebuffer_desc},
    {"framebuffer_info", SHD_DESC_KIND_FRAMEBUFFER_INFO, sizeof(shd_framebuffer_info),
     REQUIRED(shd_framebuffer_info, height), defaults_shd_framebuffer_info},
    {"plane_view", SHD_DESC_KIND_PLANE_VIEW, sizeof(shd_plane_view), REQUIRED(shd_plane_view, f32),
     defaults_shd_plane_view},
    {"camera", SHD_DESC_KIND_CAMERA, sizeof(shd_camera), REQUIRED(shd_camera, target), defaults_shd_camera},
    {"draw", SHD_DESC_KIND_DRAW, sizeof(shd_draw), REQUIRED(shd_draw, mesh), defaults_shd_draw},
    {"render_desc", SHD_DESC_KIND_RENDER_DESC, sizeof(shd_render_desc), REQUIRED(shd_render_desc, framebuffer),
     defaults_shd_render_desc},
    {"render_stats", SHD_DESC_KIND_RENDER_STATS, sizeof(shd_render_stats), REQUIRED(shd_render_stats, rasterised),
     defaults_shd_render_stats},
    {"color_desc", SHD_DESC_KIND_COLOR_DESC, sizeof(shd_color_desc), REQUIRED(shd_color_desc, config_path),
     defaults_shd_color_desc},
    {"load_desc", SHD_DESC_KIND_LOAD_DESC, sizeof(shd_load_desc), REQUIRED(shd_load_desc, formats),
     defaults_shd_load_desc},
    {"save_desc", SHD_DESC_KIND_SAVE_DESC, sizeof(shd_save_desc), REQUIRED(shd_save_desc, bit_depth),
     defaults_shd_save_desc},
    {"bitmap_info", SHD_DESC_KIND_BITMAP_INFO, sizeof(shd_bitmap_info), REQUIRED(shd_bitmap_info, file_format),
     defaults_shd_bitmap_info},
    {"raw_desc", SHD_DESC_KIND_RAW_DESC, sizeof(shd_raw_desc), REQUIRED(shd_raw_desc, depth), defaults_shd_raw_desc},
    {"stack_desc", SHD_DESC_KIND_STACK_DESC, sizeof(shd_stack_desc), REQUIRED(shd_stack_desc, pattern),
     defaults_shd_stack_desc},
    {"vdb_desc", SHD_DESC_KIND_VDB_DESC, sizeof(shd_vdb_desc), REQUIRED(shd_vdb_desc, flags), defaults_shd_vdb_desc},
    {"vdb_info", SHD_DESC_KIND_VDB_INFO, sizeof(shd_vdb_info), REQUIRED(shd_vdb_info, background),
     defaults_shd_vdb_info},
    {"texture_file_info", SHD_DESC_KIND_TEXTURE_FILE_INFO, sizeof(shd_texture_file_info),
     REQUIRED(shd_texture_file_info, level_count), defaults_shd_texture_file_info},
    {"ktx2_desc", SHD_DESC_KIND_KTX2_DESC, sizeof(shd_ktx2_desc), REQUIRED(shd_ktx2_desc, supercompression),
     defaults_shd_ktx2_desc},
    {"shape_desc", SHD_DESC_KIND_SHAPE_DESC, sizeof(shd_shape_desc), REQUIRED(shd_shape_desc, shape),
     defaults_shd_shape_desc},
    {"shape_columns", SHD_DESC_KIND_SHAPE_COLUMNS, sizeof(shd_shape_columns), REQUIRED(shd_shape_columns, position),
     defaults_shd_shape_columns},
    {"scene_desc", SHD_DESC_KIND_SCENE_DESC, sizeof(shd_scene_desc), REQUIRED(shd_scene_desc, flags),
     defaults_shd_scene_desc},
    {"scene_info", SHD_DESC_KIND_SCENE_INFO, sizeof(shd_scene_info), REQUIRED(shd_scene_info, instance_count),
     defaults_shd_scene_info},
    {"scene_instance", SHD_DESC_KIND_SCENE_INSTANCE, sizeof(shd_scene_instance),
     REQUIRED(shd_scene_instance, object_to_world), defaults_shd_scene_instance},
    {"environment_desc", SHD_DESC_KIND_ENVIRONMENT_DESC, sizeof(shd_environment_desc),
     REQUIRED(shd_environment_desc, image), defaults_shd_environment_desc},
    {"environment_info", SHD_DESC_KIND_ENVIRONMENT_INFO, sizeof(shd_environment_info),
     REQUIRED(shd_environment_info, map_size), defaults_shd_environment_info},
    {"environment_lookups", SHD_DESC_KIND_ENVIRONMENT_LOOKUPS, sizeof(shd_environment_lookups),
     REQUIRED(shd_environment_lookups, direction), defaults_shd_environment_lookups},
    {"environment_light", SHD_DESC_KIND_ENVIRONMENT_LIGHT, sizeof(shd_environment_light),
     REQUIRED(shd_environment_light, rgb), defaults_shd_environment_light},
    {"directions", SHD_DESC_KIND_DIRECTIONS, sizeof(shd_directions), REQUIRED(shd_directions, direction),
     defaults_shd_directions},
    {"projected_points", SHD_DESC_KIND_PROJECTED_POINTS, sizeof(shd_projected_points),
     REQUIRED(shd_projected_points, u), defaults_shd_projected_points},
    {"image_points", SHD_DESC_KIND_IMAGE_POINTS, sizeof(shd_image_points), REQUIRED(shd_image_points, v),
     defaults_shd_image_points},
    {"point_directions", SHD_DESC_KIND_POINT_DIRECTIONS, sizeof(shd_point_directions),
     REQUIRED(shd_point_directions, direction), defaults_shd_point_directions},
    {"direction_images", SHD_DESC_KIND_DIRECTION_IMAGES, sizeof(shd_direction_images),
     REQUIRED(shd_direction_images, images), defaults_shd_direction_images},
    {"volume_desc", SHD_DESC_KIND_VOLUME_DESC, sizeof(shd_volume_desc), REQUIRED(shd_volume_desc, extinction),
     defaults_shd_volume_desc},
    {"volume_draw", SHD_DESC_KIND_VOLUME_DRAW, sizeof(shd_volume_draw), REQUIRED(shd_volume_draw, volume),
     defaults_shd_volume_draw},
};

/* Padding bytes are unspecified, so both structs get the same bytes there. */
static void level_padding(const char *name, size_t end, unsigned char *a, unsigned char *b)
{
    static const struct {
        const char *type;
        size_t offset, size;
    } k_padding[] = {
#define SHD_STRUCT(type, size)
#define SHD_FIELD(type, field, offset, size)
#define SHD_PADDING(type, offset, size) {#type, offset, size},
#include "../abi/layout_color.inc"
#include "../abi/layout_io.inc"
#include "../abi/layout_scene.inc"
#include "../abi/layout_shd.inc"
        {"shd_context_desc", offsetof(shd_context_desc, executor) + offsetof(shd_executor, worker_count) + 4, 4},
    };
    size_t i;
    for (i = 0; i < sizeof k_padding / sizeof k_padding[0]; ++i) {
        if (strcmp(k_padding[i].type + strlen("shd_"), name) || k_padding[i].offset + k_padding[i].size > end) continue;
        memset(a + k_padding[i].offset, 0, k_padding[i].size);
        memset(b + k_padding[i].offset, 0, k_padding[i].size);
    }
}

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
    level_padding(c->name, c->size, got.bytes, want.bytes);
    assert_memory_equal(got.bytes, want.bytes, LARGEST);

    /* A later header's struct: the known part, then zero. */
    size = (uint32_t)(c->size + 16);
    memset(want.bytes + c->size, 0, 16);
    memcpy(want.bytes, &size, sizeof size);
    shd_assert_ok(shd_desc_init(c->kind, got.bytes, size));
    level_padding(c->name, c->size, got.bytes, want.bytes);
    assert_memory_equal(got.bytes, want.bytes, LARGEST);

    /* An older header's struct: the first fields, and nothing behind them. Other sizes are those of no header. */
    for (size = (uint32_t)c->required; size < c->size; ++size) {
        memset(got.bytes, 0xa5, LARGEST);
        if (size % c->alignment != 0) {
            const size_t smallest = (c->required + c->alignment - 1) / c->alignment * c->alignment;
            shd_assert_result(c->name, shd_desc_init(c->kind, got.bytes, size), SHD_ERROR_INVALID_ARGUMENT,
                              size < smallest ? "is below" : "is not a multiple of");
            assert_memory_equal(got.bytes, untouched.bytes, LARGEST);
            continue;
        }
        memset(want.bytes, 0xa5, LARGEST);
        c->defaults(want.bytes);
        memset(want.bytes + size, 0xa5, c->size - size);
        memcpy(want.bytes, &size, sizeof size);
        shd_assert_ok(shd_desc_init(c->kind, got.bytes, size));
        level_padding(c->name, size, got.bytes, want.bytes);
        assert_memory_equal(got.bytes, want.bytes, LARGEST);
    }

    memset(got.bytes, 0xa5, LARGEST);
    shd_assert_result("small", shd_desc_init(c->kind, got.bytes, c->required - 1), SHD_ERROR_INVALID_ARGUMENT,
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
    struct CMUnitTest tests[sizeof k_kinds / sizeof k_kinds[0] + 8];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_kinds / sizeof k_kinds[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_kinds[i].name, test_kind, NULL, NULL, (void *)&k_kinds[i]};
    }
    tests[n++] = (struct CMUnitTest){"unknown_kinds", test_unknown_kinds, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.desc", tests, n, NULL, NULL);
}
