/* SPDX-License-Identifier: MIT */
/* Textures of compressed blocks: what is refused, what is stored, and what other functions make of them. */
#include "support/check.h"
#include "support/image.h"

#include <shd/shd.h>

enum { WIDTH = 18, HEIGHT = 10, ACROSS = 5, DOWN = 3, SIDE = 48, MAX_TAPS = 64 };

static unsigned char g_blocks[ACROSS * DOWN * 6 * 16 + 7], g_level_1[3 * 2 * 16], g_level_2[2 * 1 * 16];
static unsigned char g_texels[WIDTH * HEIGHT * 4];
static shd_context *g_context;

static int setup(void **state)
{
    size_t i;
    (void)state;
    for (i = 0; i < sizeof g_blocks; ++i) g_blocks[i] = (unsigned char)(i * 37 + i / 50 + 1);
    for (i = 0; i < sizeof g_level_1; ++i) g_level_1[i] = (unsigned char)(i * 91 + 5);
    for (i = 0; i < sizeof g_level_2; ++i) g_level_2[i] = (unsigned char)(i * 53 + 9);
    return shd_context_create(NULL, &g_context) == SHD_OK ? 0 : -1;
}
static int teardown(void **state)
{
    (void)state;
    shd_context_release(g_context);
    return 0;
}

static shd_texture_desc of_blocks(shd_format format)
{
    shd_texture_desc desc = shd_texture_desc_default();
    desc.format = format;
    desc.width = WIDTH;
    desc.height = HEIGHT;
    desc.texels = g_blocks;
    return desc;
}

static shd_texture *create(const shd_texture_desc *desc)
{
    shd_texture *texture = NULL;
    shd_assert_ok(shd_texture_create(g_context, desc, &texture));
    return texture;
}

static void test_sizes(void **state)
{
    (void)state;
    assert_int_equal(shd_format_size(SHD_FORMAT_BC7), 0);
    assert_int_equal(shd_format_size(SHD_FORMAT_RGBA8), 4);
    assert_int_equal(shd_format_block_size(SHD_FORMAT_RGBA8), 0);
    assert_int_equal(shd_format_size(SHD_FORMAT_RGB9E5), 4);
    assert_int_equal(shd_format_block_size((shd_format)0x7ffffff0), 0);
    assert_int_equal(shd_format_block_size(SHD_FORMAT_BC1_RGB), 8);
    assert_int_equal(shd_format_block_size(SHD_FORMAT_BC4_SNORM), 8);
    assert_int_equal(shd_format_block_size(SHD_FORMAT_BC6H_SFLOAT), 16);
    assert_int_equal(shd_format_block_size(SHD_FORMAT_BC7_SRGB), 16);
}

static shd_image g_levels[2];

static void edit_nothing(shd_texture_desc *d) { (void)d; }
static void edit_levels(shd_texture_desc *d)
{
    d->tables = SHD_TABLE_MIPMAP;
    d->level_images = g_levels;
    d->level_count = 2;
}
static void edit_odd_address(shd_texture_desc *d) { d->texels = g_blocks + 7; }
static void edit_gaps(shd_texture_desc *d) { d->row_stride = ACROSS * 16 + 3; }
static void edit_cube(shd_texture_desc *d)
{
    d->width = d->height = 12;
    d->layer_count = 6;
    d->kind = SHD_TEXTURE_KIND_DIRECTIONS, d->projection = SHD_PROJECTION_CUBE;
}
static void edit_borrow(shd_texture_desc *d) { d->flags = SHD_TEXTURE_BORROW; }
static void edit_borrow_gaps(shd_texture_desc *d)
{
    edit_borrow(d);
    edit_gaps(d);
}
static void edit_unknown(shd_texture_desc *d) { d->format = (shd_format)38; }
static void edit_narrow(shd_texture_desc *d) { d->row_stride = ACROSS * 16 - 1; }
static void edit_low_layers(shd_texture_desc *d)
{
    d->layer_count = 2;
    d->layer_stride = ACROSS * DOWN * 16 - 1;
}
static void edit_depth(shd_texture_desc *d) { d->kind = SHD_TEXTURE_KIND_3D, d->depth = 2, d->layer_stride = 1; }
static void edit_no_levels(shd_texture_desc *d) { d->tables = SHD_TABLE_MIPMAP; }
static void edit_other_levels(shd_texture_desc *d)
{
    edit_levels(d);
    g_levels[1].format = SHD_FORMAT_BC3;
}
static void edit_large_level(shd_texture_desc *d)
{
    edit_levels(d);
    g_levels[0].width = 12;
}
static void edit_truncated_level(shd_texture_desc *d)
{
    edit_levels(d);
    g_levels[0].row_stride = 47;
}
static void edit_null(shd_texture_desc *d) { d->texels = NULL; }

static const struct create_case {
    const char *name;
    void (*edit)(shd_texture_desc *desc);
    shd_result result;
    const char *message;
} k_create[] = {
    {"create/base", edit_nothing, SHD_OK, ""},
    {"create/levels", edit_levels, SHD_OK, ""},
    {"create/odd_address", edit_odd_address, SHD_OK, ""},
    {"create/gaps", edit_gaps, SHD_OK, ""},
    {"create/cube", edit_cube, SHD_OK, ""},
    {"create/borrow", edit_borrow, SHD_OK, ""},
    {"create/borrow_gaps", edit_borrow_gaps, SHD_ERROR_INVALID_ARGUMENT,
     "texture.flags: SHD_TEXTURE_BORROW, but texture.row_stride 83, not 80"},
    {"create/unknown", edit_unknown, SHD_ERROR_INVALID_ARGUMENT, "texture.format: 38 is not a format"},
    {"create/narrow", edit_narrow, SHD_ERROR_INVALID_ARGUMENT, "texture.row_stride: 79 is below 80"},
    {"create/low_layers", edit_low_layers, SHD_ERROR_INVALID_ARGUMENT, "texture.layer_stride: 239 is below 240"},
    {"create/no_slices", edit_depth, SHD_ERROR_INVALID_ARGUMENT, "texture.layer_stride: 1 is below 240"},
    {"create/no_levels", edit_no_levels, SHD_ERROR_UNSUPPORTED,
     "texture.level_count: 0, but mip levels of compressed blocks must be given in texture.level_images"},
    {"create/other_levels", edit_other_levels, SHD_ERROR_INVALID_ARGUMENT,
     "texture.level_images[1].format: 27 is not the base's 35"},
    {"create/large_level", edit_large_level, SHD_ERROR_INVALID_ARGUMENT, "texture.level_images[0].width: 12"},
    {"create/truncated_level", edit_truncated_level, SHD_ERROR_INVALID_ARGUMENT,
     "texture.level_images[0].row_stride: 47 is below 48"},
    {"create/null", edit_null, SHD_ERROR_INVALID_ARGUMENT, "texture.texels: NULL"},
};

static void set_levels(void)
{
    g_levels[0] = shd_test_image(SHD_FORMAT_BC7, 9, 5, g_level_1);
    g_levels[1] = shd_test_image(SHD_FORMAT_BC7, 4, 2, g_level_2);
}

static void test_create(void **state)
{
    const struct create_case *c = (const struct create_case *)*state;
    shd_texture_desc desc = of_blocks(SHD_FORMAT_BC7);
    shd_texture *texture = (shd_texture *)&desc;
    set_levels();
    c->edit(&desc);
    shd_assert_result(c->name, shd_texture_create(g_context, &desc, &texture), c->result, c->message);
    if (c->result != SHD_OK) assert_null(texture);
    shd_texture_release(texture);
}

/* Blocks come back as they were given, and take an eighth or a quarter of the memory of RGBA8. */
static void test_stored(void **state)
{
    unsigned char rows[DOWN][ACROSS * 16];
    shd_image out = shd_test_image(SHD_FORMAT_BC7, WIDTH, HEIGHT, rows);
    shd_texture_desc desc = of_blocks(SHD_FORMAT_BC7);
    shd_texture_info info = shd_texture_info_default();
    shd_texture *texture;
    int y;
    (void)state;
    set_levels();
    edit_levels(&desc);
    desc.row_stride = ACROSS * 16 + 3;
    texture = create(&desc);
    shd_assert_ok(shd_texture_get_info(texture, &info));
    assert_int_equal(info.format, SHD_FORMAT_BC7);
    assert_int_equal(info.level_count, 3);
    assert_int_equal(info.byte_size, 16 * (ACROSS * DOWN + 3 * 2 + 1));
    shd_assert_ok(shd_texture_read_level(texture, 0, 0, &out));
    for (y = 0; y < DOWN; ++y) assert_memory_equal(rows[y], g_blocks + y * (ACROSS * 16 + 3), ACROSS * 16);
    out.width = 9;
    out.height = 5;
    shd_assert_ok(shd_texture_read_level(texture, 0, 1, &out));
    assert_memory_equal(rows, g_level_1, sizeof g_level_1);
    out.format = SHD_FORMAT_RGBA8;
    out.pixels = g_texels;
    shd_assert_result("read as texels", shd_texture_read_level(texture, 0, 1, &out), SHD_ERROR_INVALID_ARGUMENT,
                      "out.format: 2 is not the texture's 35");
    shd_texture_release(texture);
}

static void test_update(void **state)
{
    const shd_image texels = shd_test_image(SHD_FORMAT_RGBA8, 1, 1, g_texels);
    const shd_texture_desc desc = of_blocks(SHD_FORMAT_BC1_RGBA);
    shd_texture *texture = create(&desc);
    (void)state;
    shd_assert_result("update", shd_texture_update(texture, 0, 0, 0, &texels), SHD_ERROR_UNSUPPORTED,
                      "texture: in compressed blocks, which cannot be updated");
    shd_texture_release(texture);
}

/* Functions of pixels refuse blocks, with a message of their own. */
static void test_pixels_only(void **state)
{
    const shd_image blocks = shd_test_image(SHD_FORMAT_BC7, 8, 8, g_blocks);
    shd_image level = shd_test_image(SHD_FORMAT_BC7, 4, 4, g_texels);
    shd_framebuffer_desc fd = shd_framebuffer_desc_default();
    shd_environment_desc ed = shd_environment_desc_default();
    shd_framebuffer *framebuffer = NULL;
    shd_environment *environment = NULL;
    const char *const message = "has compressed blocks, which only textures take";
    (void)state;
    shd_assert_result("mip", shd_mip_build(g_context, &blocks, NULL, 1, &level), SHD_ERROR_INVALID_ARGUMENT, message);
    shd_assert_result("moments", shd_mip_build_moments(g_context, &blocks, &level, NULL), SHD_ERROR_INVALID_ARGUMENT,
                      message);
    ed.image = &blocks;
    shd_assert_result("environment", shd_environment_create(g_context, &ed, &environment), SHD_ERROR_INVALID_ARGUMENT,
                      message);
    fd.width = fd.height = 8;
    fd.color_format = SHD_FORMAT_BC7;
    shd_assert_result("framebuffer", shd_framebuffer_create(g_context, &fd, &framebuffer), SHD_ERROR_INVALID_ARGUMENT,
                      "framebuffer.color_format");
    fd.color_format = SHD_FORMAT_RGBA8;
    shd_assert_ok(shd_framebuffer_create(g_context, &fd, &framebuffer));
    shd_assert_result("read", shd_framebuffer_read_color(framebuffer, &blocks), SHD_ERROR_INVALID_ARGUMENT, message);
    shd_framebuffer_release(framebuffer);
}

/* Values of all texels with SHD_FILTER_NEAREST. */
static void read_texels(const shd_texture *texture, float (*out)[4])
{
    static float u[WIDTH * HEIGHT], v[WIDTH * HEIGHT];
    shd_sampler_desc sd = shd_sampler_desc_default();
    shd_lookups lookups = shd_lookups_default();
    shd_texels texels = shd_texels_default();
    shd_sampler *sampler = NULL;
    int i;
    for (i = 0; i < WIDTH * HEIGHT; ++i) {
        u[i] = ((float)(i % WIDTH) + 0.5f) / WIDTH;
        v[i] = ((float)(i / WIDTH) + 0.5f) / HEIGHT;
    }
    sd.filter = SHD_FILTER_NEAREST;
    shd_assert_ok(shd_sampler_create(g_context, &sd, &sampler));
    lookups.count = WIDTH * HEIGHT;
    lookups.u.data = u;
    lookups.v.data = v;
    for (i = 0; i < 4; ++i) {
        texels.channel[i].data = &out[0][i];
        texels.channel[i].stride = sizeof *out;
    }
    shd_assert_ok(shd_texture_sample(texture, sampler, &lookups, &texels));
    shd_sampler_release(sampler);
}

/* Borrowed blocks are read where they are, with the values of copied ones. */
static void test_borrowed(void **state)
{
    static float copied[WIDTH * HEIGHT][4], borrowed[WIDTH * HEIGHT][4];
    shd_texture_desc desc = of_blocks(SHD_FORMAT_BC7);
    shd_texture_info info = shd_texture_info_default();
    shd_texture *texture;
    (void)state;
    texture = create(&desc);
    read_texels(texture, copied);
    shd_texture_release(texture);
    desc.flags = SHD_TEXTURE_BORROW;
    texture = create(&desc);
    shd_assert_ok(shd_texture_get_info(texture, &info));
    assert_int_equal(info.byte_size, 0);
    assert_int_equal(info.flags, SHD_TEXTURE_BORROW);
    read_texels(texture, borrowed);
    assert_memory_equal(copied, borrowed, sizeof copied);
    shd_texture_release(texture);
}

/* The weighted taps of an explanation are the result, and its bounds contain the result. */
static void test_explained(void **state)
{
    shd_sampler_desc sd = shd_sampler_desc_default();
    shd_lookups lookups = shd_lookups_default();
    shd_explanation why = shd_explanation_default();
    shd_texels low = shd_texels_default(), high = shd_texels_default();
    shd_bounds_desc bounds = shd_bounds_desc_default();
    shd_texture_desc desc = of_blocks(SHD_FORMAT_BC7);
    shd_tap taps[MAX_TAPS];
    shd_sampler *sampler = NULL;
    shd_texture *texture;
    const float u = 0.43f, v = 0.61f;
    float least = 0, most = 0;
    double sum = 0;
    uint32_t i;
    (void)state;
    set_levels();
    edit_levels(&desc);
    texture = create(&desc);
    sd.filter = SHD_FILTER_BILINEAR;
    shd_assert_ok(shd_sampler_create(g_context, &sd, &sampler));
    lookups.count = 1;
    lookups.u.data = &u;
    lookups.v.data = &v;
    why.taps = taps;
    why.tap_capacity = MAX_TAPS;
    shd_assert_ok(shd_texture_explain(texture, sampler, &lookups, 0, &why));
    assert_int_equal(why.tap_count, 4);
    for (i = 0; i < why.tap_count; ++i) sum += (double)taps[i].weight * (double)taps[i].value[0] / 255;
    shd_assert_close("taps", 0, sum, (double)why.result[0], 1e-6, 0);
    low.channel[0].data = &least;
    high.channel[0].data = &most;
    shd_assert_ok(shd_texture_bounds(texture, sampler, &lookups, &bounds, &low, &high));
    assert_true(least <= why.result[0] && why.result[0] <= most);
    shd_sampler_release(sampler);
    shd_texture_release(texture);
}

/* A normal map of two channels; z is rebuilt. */
static void render_normals(shd_texture *normals, float *out)
{
    shd_framebuffer_desc fd = shd_framebuffer_desc_default();
    shd_shape_desc form = shd_shape_desc_default();
    shd_sampler_desc sd = shd_sampler_desc_default();
    shd_material_desc md = shd_material_desc_default();
    shd_light_desc ld = shd_light_desc_default();
    shd_render_desc rd = shd_render_desc_default();
    shd_camera camera = shd_camera_default();
    shd_draw draw = shd_draw_default();
    shd_image image = shd_test_image(SHD_FORMAT_RGBA32F, SIDE, SIDE, out);
    shd_framebuffer *framebuffer = NULL;
    shd_sampler *sampler = NULL;
    shd_material *material = NULL;
    shd_light *light = NULL;
    const shd_light *lights[1];
    shd_mesh *mesh = NULL;
    shd_slot slot;
    fd.width = fd.height = SIDE;
    shd_assert_ok(shd_framebuffer_create(g_context, &fd, &framebuffer));
    form.kind = SHD_SHAPE_SPHERE;
    form.segments[0] = form.segments[1] = 24;
    shd_assert_ok(shd_mesh_create_shape(g_context, &form, SHD_MESH_TANGENTS, &mesh));
    sd.filter = SHD_FILTER_BILINEAR;
    shd_assert_ok(shd_sampler_create(g_context, &sd, &sampler));
    if (normals) {
        slot = shd_slot_texture(SHD_SLOT_NORMAL, normals, sampler);
        md.slots = &slot;
        md.slot_count = 1;
        md.normal_encoding = SHD_NORMAL_ENCODING_XY;
    }
    shd_assert_ok(shd_material_create(g_context, &md, &material));
    ld.kind = SHD_LIGHT_KIND_DIRECTIONAL;
    ld.direction[0] = -0.4f;
    ld.direction[2] = -0.9f;
    shd_assert_ok(shd_light_create(g_context, &ld, &light));
    lights[0] = light;
    camera.eye[2] = 3;
    draw.mesh = mesh;
    draw.material = material;
    draw.frequency = SHD_FREQUENCY_PHONG;
    rd.framebuffer = framebuffer;
    rd.camera = &camera;
    rd.draws = &draw;
    rd.draw_count = 1;
    rd.lights = lights;
    rd.light_count = 1;
    shd_assert_ok(shd_render(g_context, &rd));
    shd_assert_ok(shd_framebuffer_read_color(framebuffer, &image));
    shd_light_release(light);
    shd_material_release(material);
    shd_sampler_release(sampler);
    shd_mesh_release(mesh);
    shd_framebuffer_release(framebuffer);
}

/* BC5 whose blocks have one value each, against texels of the same values. */
static void test_normals(void **state)
{
    static float plain[SIDE * SIDE * 4], blocks_out[SIDE * SIDE * 4], texels_out[SIDE * SIDE * 4];
    static unsigned char blocks[4 * 4 * 16];
    static uint16_t codes[16 * 16 * 2];
    static float values[16 * 16 * 2];
    int is_signed, x, y, c;
    (void)state;
    render_normals(NULL, plain);
    for (is_signed = 0; is_signed < 2; ++is_signed) {
        shd_texture_desc desc = shd_texture_desc_default();
        shd_texture *texture;
        for (y = 0; y < 16; ++y) {
            for (x = 0; x < 16; ++x) {
                for (c = 0; c < 2; ++c) {
                    unsigned char *block = blocks + (y / 4 * 4 + x / 4) * 16 + 8 * c;
                    const int code = (is_signed ? 3 : 100) + 11 * (x / 4) + 7 * (y / 4) * (c + 1);
                    block[0] = block[1] = (unsigned char)code;
                    codes[(y * 16 + x) * 2 + c] = (uint16_t)(code * 257);
                    values[(y * 16 + x) * 2 + c] = (float)code / 127.0f;
                }
            }
        }
        desc.width = desc.height = 16;
        desc.format = is_signed ? SHD_FORMAT_BC5_SNORM : SHD_FORMAT_BC5;
        desc.texels = blocks;
        texture = create(&desc);
        render_normals(texture, blocks_out);
        shd_texture_release(texture);
        desc.format = is_signed ? SHD_FORMAT_RG32F : SHD_FORMAT_RG16;
        desc.texels = is_signed ? (const void *)values : (const void *)codes;
        texture = create(&desc);
        render_normals(texture, texels_out);
        shd_texture_release(texture);
        assert_memory_equal(blocks_out, texels_out, sizeof texels_out);
        assert_memory_not_equal(blocks_out, plain, sizeof plain);
    }
}

int main(void)
{
    enum { CASES = sizeof k_create / sizeof *k_create };
    struct CMUnitTest tests[CASES + 7] = {
        cmocka_unit_test(test_sizes),       cmocka_unit_test(test_stored),   cmocka_unit_test(test_update),
        cmocka_unit_test(test_pixels_only), cmocka_unit_test(test_borrowed), cmocka_unit_test(test_explained),
        cmocka_unit_test(test_normals),
    };
    size_t i;
    for (i = 0; i < CASES; ++i) {
        const struct CMUnitTest test = {k_create[i].name, test_create, NULL, NULL, (void *)(uintptr_t)&k_create[i]};
        tests[7 + i] = test;
    }
    return cmocka_run_group_tests(tests, setup, teardown);
}
