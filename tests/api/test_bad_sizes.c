/* SPDX-License-Identifier: MIT */
/* Sizes of 0, negative sizes, and sizes whose product leaves 32 or 64 bits: each call is refused before it allocates
 * memory, and writes nothing. */
#include "support/fault_allocator.h"
#include "support/rows.h"

#include <shd/shd.h>

static uint64_t k_memory[64]; /* input of every call, and output that must stay 0 */

static shd_texture_desc texture_of(uint32_t width, uint32_t height, uint32_t layers)
{
    shd_texture_desc desc = shd_texture_desc_default();
    desc.format = SHD_FORMAT_RGBA32F;
    desc.width = width;
    desc.height = height;
    desc.layer_count = layers;
    desc.texels = k_memory;
    return desc;
}
static shd_result make_texture(shd_context *context, const shd_texture_desc *desc)
{
    shd_texture *texture = (shd_texture *)k_memory;
    const shd_result result = shd_texture_create(context, desc, &texture);
    assert_null(texture);
    return result;
}
static shd_result make_size(shd_context *context, uint32_t width, uint32_t height, uint32_t layers)
{
    const shd_texture_desc desc = texture_of(width, height, layers);
    return make_texture(context, &desc);
}
static shd_result make_strides(shd_context *context, size_t row_stride, size_t layer_stride)
{
    shd_texture_desc desc = texture_of(4, 4, 3);
    desc.row_stride = row_stride;
    desc.layer_stride = layer_stride;
    return make_texture(context, &desc);
}
static shd_result make_levels(shd_context *context, uint32_t count)
{
    static shd_image levels[64];
    shd_texture_desc desc = texture_of(4, 4, 1);
    desc.tables = SHD_TABLE_MIPMAP;
    desc.level_images = levels;
    desc.level_count = count;
    return make_texture(context, &desc);
}
static shd_result texture_0(shd_context *c) { return make_size(c, 0, 0, 1); }
static shd_result texture_no_layers(shd_context *c) { return make_size(c, 1, 1, 0); }
static shd_result texture_minus_1(shd_context *c) { return make_size(c, (uint32_t)-1, (uint32_t)-1, 1); }
static shd_result texture_minus_1_layers(shd_context *c) { return make_size(c, 1, 1, (uint32_t)-1); }
static shd_result texture_2_16(shd_context *c) { return make_size(c, 65536, 65536, 1); }
static shd_result texture_2_31(shd_context *c) { return make_size(c, 0x80000000u, 2, 1); }
static shd_result texture_2_43(shd_context *c) { return make_size(c, 65536, 65536, 2048); }
static shd_result texture_row(shd_context *c) { return make_strides(c, (size_t)1 << 62, 0); }
static shd_result texture_row_max(shd_context *c) { return make_strides(c, SIZE_MAX - 3, 0); }
static shd_result texture_layer(shd_context *c) { return make_strides(c, 64, (size_t)1 << 63); }
static shd_result texture_layer_small(shd_context *c) { return make_strides(c, 1024, 1024); }
static shd_result texture_33_levels(shd_context *c) { return make_levels(c, 33); }
static shd_result texture_minus_1_level(shd_context *c) { return make_levels(c, (uint32_t)-1); }

static shd_result make_framebuffer(shd_context *context, uint32_t width, uint32_t height, uint32_t samples)
{
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    shd_framebuffer *framebuffer = (shd_framebuffer *)k_memory;
    shd_result result;
    desc.width = width;
    desc.height = height;
    desc.sample_count = samples;
    desc.aovs = SHD_AOV_UV;
    result = shd_framebuffer_create(context, &desc, &framebuffer);
    assert_null(framebuffer);
    return result;
}
static shd_result framebuffer_0(shd_context *c) { return make_framebuffer(c, 0, 0, 1); }
static shd_result framebuffer_32768(shd_context *c) { return make_framebuffer(c, 32768, 32768, 1); }
static shd_result framebuffer_2_31(shd_context *c) { return make_framebuffer(c, 0x80000000u, 0x80000000u, 16); }
static shd_result framebuffer_minus_1(shd_context *c) { return make_framebuffer(c, 1, (uint32_t)-1, 1); }
static shd_result framebuffer_samples(shd_context *c) { return make_framebuffer(c, 1, 1, (uint32_t)-1); }

static shd_result make_shadow(shd_context *context, uint32_t size)
{
    shd_shadow_desc desc = shd_shadow_desc_default();
    shd_shadow *shadow = (shd_shadow *)k_memory;
    shd_result result;
    desc.size = size;
    result = shd_shadow_create(context, &desc, &shadow);
    assert_null(shadow);
    return result;
}
static shd_result shadow_0(shd_context *c) { return make_shadow(c, 0); }
static shd_result shadow_65536(shd_context *c) { return make_shadow(c, 65536); }
static shd_result shadow_minus_1(shd_context *c) { return make_shadow(c, (uint32_t)-1); }

static shd_result make_mesh(shd_context *context, uint32_t vertices, size_t indices, size_t stride)
{
    shd_mesh_desc desc = shd_mesh_desc_default();
    shd_mesh *mesh = (shd_mesh *)k_memory;
    shd_result result;
    int c;
    desc.vertex_count = vertices;
    for (c = 0; c < 3; ++c) desc.position[c] = shd_f32_column((const float *)(const void *)k_memory, stride);
    desc.indices.data = indices ? (const uint32_t *)(const void *)k_memory : NULL;
    desc.indices.stride = stride;
    desc.index_count = indices;
    result = shd_mesh_create(context, &desc, &mesh);
    assert_null(mesh);
    return result;
}
static shd_result mesh_minus_1(shd_context *c) { return make_mesh(c, (uint32_t)-1, 0, 0); }
static shd_result mesh_2_31(shd_context *c) { return make_mesh(c, 0x80000000u, 0, 0); }
static shd_result mesh_indices_max(shd_context *c) { return make_mesh(c, 3, SIZE_MAX / 3 * 3, 0); }
static shd_result mesh_indices_2_62(shd_context *c) { return make_mesh(c, 3, ((size_t)1 << 62) / 3 * 3, 0); }
static shd_result mesh_stride(shd_context *c) { return make_mesh(c, 9, 3, (size_t)1 << 62); }

static shd_result make_mip(shd_context *context, uint32_t width, uint32_t height, uint32_t count)
{
    static shd_image levels[64];
    const shd_mip_desc desc = shd_mip_desc_default();
    shd_image base = shd_image_default();
    base.format = SHD_FORMAT_RGBA32F;
    base.width = width;
    base.height = height;
    base.pixels = k_memory;
    return shd_mip_build(context, &base, &desc, count, levels);
}
static shd_result mip_0(shd_context *c) { return make_mip(c, 0, 0, 0); }
static shd_result mip_2_16(shd_context *c) { return make_mip(c, 65536, 65536, 16); }
static shd_result mip_minus_1(shd_context *c) { return make_mip(c, (uint32_t)-1, 1, 0); }
static shd_result mip_33_levels(shd_context *c) { return make_mip(c, 2, 2, 33); }
static shd_result moments_0(shd_context *c)
{
    shd_image image = shd_image_default();
    image.format = SHD_FORMAT_RGBA32F;
    image.pixels = k_memory;
    return shd_mip_build_moments(c, &image, &image, NULL);
}

static shd_result normals_minus_1(shd_context *c)
{
    shd_image image = shd_image_default();
    image.format = SHD_FORMAT_R8;
    image.width = (uint32_t)-1;
    image.height = 1;
    image.pixels = k_memory;
    return shd_mip_build_normals(c, &image, NULL, &image);
}

static shd_result make_shape(shd_context *context, uint32_t across, uint32_t down)
{
    shd_shape_desc desc = shd_shape_desc_default();
    shd_mesh *mesh = (shd_mesh *)k_memory;
    shd_result result;
    desc.segments[0] = across;
    desc.segments[1] = down;
    result = shd_mesh_create_shape(context, &desc, SHD_MESH_NONE, &mesh);
    assert_null(mesh);
    return result;
}
static shd_result shape_minus_1(shd_context *c) { return make_shape(c, (uint32_t)-1, (uint32_t)-1); }
static shd_result shape_2_16(shd_context *c) { return make_shape(c, 65536, 65536); }

struct size_case {
    const char *name;
    shd_result (*call)(shd_context *context);
    const char *message;
};
static const struct size_case k_sizes[] = {
    {"texture/0x0", texture_0, "texture.width: 0 is not in 1..65536"},
    {"texture/0_layers", texture_no_layers, "texture.layer_count: 0 is not in 1..2048"},
    {"texture/-1x-1", texture_minus_1, "texture.width: 4294967295"},
    {"texture/-1_layers", texture_minus_1_layers, "texture.layer_count: 4294967295"},
    {"texture/2^32_texels", texture_2_16, "texture.width * texture.height * texture.layer_count: 4294967296"},
    {"texture/2^31_wide", texture_2_31, "texture.width: 2147483648"},
    {"texture/2^43_texels", texture_2_43, "texture.width * texture.height * texture.layer_count: 8796093022208"},
    {"texture/row_stride_2^62", texture_row, "exceeds the address space"},
    {"texture/row_stride_size_max", texture_row_max, "exceeds the address space"},
    {"texture/layer_stride_2^63", texture_layer, "exceeds the address space"},
    {"texture/layer_stride_below_rows", texture_layer_small, "texture.layer_stride: 1024 is below"},
    {"texture/33_levels", texture_33_levels, "texture.level_count: 33 is not in 0..2"},
    {"texture/-1_levels", texture_minus_1_level, "texture.level_count: 4294967295"},
    {"framebuffer/0x0", framebuffer_0, "framebuffer.width: 0"},
    {"framebuffer/32768x32768", framebuffer_32768, "framebuffer.width: 32768 is not in 1..16384"},
    {"framebuffer/2^31x2^31x16", framebuffer_2_31, "framebuffer.width: 2147483648"},
    {"framebuffer/1x-1", framebuffer_minus_1, "framebuffer.height: 4294967295"},
    {"framebuffer/-1_samples", framebuffer_samples, "framebuffer.sample_count: 4294967295"},
    {"shadow/0", shadow_0, "shadow.size: 0 is not in 16..8192"},
    {"shadow/65536", shadow_65536, "shadow.size: 65536"},
    {"shadow/-1", shadow_minus_1, "shadow.size: 4294967295"},
    {"mesh/-1_vertices", mesh_minus_1, "mesh.vertex_count: 4294967295"},
    {"mesh/2^31_vertices", mesh_2_31, "mesh.vertex_count: 2147483648"},
    {"mesh/size_max_indices", mesh_indices_max, "mesh.index_count: 1844674407370955161"},
    {"mesh/2^62_indices", mesh_indices_2_62, "mesh.index_count: 461168601842738790"},
    {"mesh/stride_2^62", mesh_stride, "elements of stride"},
    {"mip/0x0", mip_0, "base.width: 0"},
    {"mip/2^32_pixels", mip_2_16, "base.width * base.height: 4294967296"},
    {"mip/-1x1", mip_minus_1, "base.width: 4294967295"},
    {"mip/33_levels", mip_33_levels, "level_count: 33 is not in 0..1"},
    {"normal_moments/0x0", moments_0, "normals.width: 0"},
    {"normals_of_heights/-1x1", normals_minus_1, "heights.width: 4294967295"},
    {"shape/-1x-1_segments", shape_minus_1, "shape.segments[0]: 4294967295"},
    {"shape/2^32_segments", shape_2_16, "shape.segments[0]: 65536"},
};

static void test_size(void **state)
{
    const struct size_case *c = (const struct size_case *)*state;
    shd_fault_allocator memory;
    shd_context_desc desc = shd_fault_context_desc(&memory);
    shd_context *context = NULL;
    size_t before, i;
    memset(&memory, 0, sizeof memory);
    shd_assert_ok(shd_context_create(&desc, &context));
    shd_fault_arm(&memory, 0, 0);
    before = memory.live_bytes;
    shd_assert_result(c->name, c->call(context), SHD_ERROR_INVALID_ARGUMENT, c->message);
    assert_int_equal(memory.calls, 0); /* before anything is allocated */
    assert_int_equal(memory.live_bytes, before);
    for (i = 0; i < sizeof k_memory / sizeof k_memory[0]; ++i) assert_true(k_memory[i] == 0);
    shd_context_release(context);
    shd_assert_all_freed(c->name, &memory);
}

int main(void)
{
    ADD_ROWS(k_sizes, test_size);
    return _cmocka_run_group_tests("api.bad_sizes", g_tests, g_count, NULL, NULL);
}
