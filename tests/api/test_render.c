/* SPDX-License-Identifier: MIT */
/* shd_render: every invalid field of its descs; a refused call changes nothing. */
#include "support/scene.h"

/* A frame with two draws and two lights, and with a larger record for each draw, as from a newer header. */
struct newer_draw {
    shd_draw draw;
    uint32_t later[3]; /* struct_size is then not a multiple of 8 */
};
struct frame {
    shd_context *context;
    shd_scene scene;
    shd_draw draws[3];
    char newer_bytes[3 * sizeof(struct newer_draw)];
    const shd_light *lights[3];
    shd_render_desc desc;
    shd_render_stats stats;
    shd_mesh *dead_mesh;
    shd_region region;
};

static void open_frame(struct frame *f)
{
    shd_mesh_desc empty = shd_mesh_desc_default();
    memset(f, 0, sizeof *f);
    shd_assert_ok(shd_context_create(NULL, &f->context));
    shd_scene_open(&f->scene, SHD_SCENE_SMALL, f->context);
    (void)shd_scene_render(&f->scene);
    shd_assert_ok(shd_mesh_create(f->context, &empty, &f->dead_mesh));
    shd_mesh_release(f->dead_mesh);
    memcpy(f->draws, f->scene.draw, sizeof f->draws);
    f->lights[0] = f->scene.light[0];
    f->lights[1] = f->lights[2] = f->scene.light[1];
    f->desc = f->scene.desc;
    f->desc.draws = f->draws;
    f->desc.draw_count = 2;
    f->desc.lights = f->lights;
    f->desc.light_count = 2;
    f->stats = shd_render_stats_default();
    f->desc.stats = &f->stats;
}

static void close_frame(struct frame *f)
{
    shd_scene_close(&f->scene);
    shd_context_release(f->context);
}

/* The draws as records `size` bytes apart. */
static void widen(struct frame *f, uint32_t size)
{
    size_t i;
    for (i = 0; i < 3; ++i) {
        shd_draw draw = f->draws[i];
        draw.struct_size = size;
        memcpy(f->newer_bytes + i * size, &draw, sizeof draw);
    }
    f->desc.draws = (const shd_draw *)(const void *)f->newer_bytes;
}
static void set_later(struct frame *f, size_t draw)
{
    const uint32_t one = 1;
    widen(f, sizeof(struct newer_draw));
    memcpy(f->newer_bytes + draw * sizeof(struct newer_draw) + sizeof(shd_draw), &one, sizeof one);
}

static void edit_nothing(struct frame *f) { (void)f; }
static void size_zero(struct frame *f) { f->desc.struct_size = 0; }
static void size_small(struct frame *f) { f->desc.struct_size = 15; }
static void size_half(struct frame *f) { f->desc.struct_size = offsetof(shd_render_desc, camera) + 4; }
static void size_huge(struct frame *f) { f->desc.struct_size = 0xffffffffu; }
static void picture_narrow(struct frame *f) { f->desc.picture_width = 99; }
static void picture_low(struct frame *f) { f->desc.picture_height = 1; }
static void picture_wide(struct frame *f) { f->desc.picture_width = 65537; }
static void picture_high(struct frame *f) { f->desc.picture_height = 0xffffffffu; }
static void picture_largest(struct frame *f)
{
    f->desc.picture_width = f->desc.picture_height = 65536;
    f->desc.crop_x = 65536 - 100;
    f->desc.crop_y = 65536 - 70;
}
static void supersample(struct frame *f, uint32_t n, uint32_t width, uint32_t height)
{
    f->desc.supersampling = n;
    f->desc.picture_width = width;
    f->desc.picture_height = height;
}
static void supersampling_1(struct frame *f) { supersample(f, 1, 65536, 65536); }
static void supersampling_10(struct frame *f) { supersample(f, 10, 0, 0); }
static void supersampling_17(struct frame *f) { supersample(f, 17, 0, 0); }
static void supersampling_huge(struct frame *f) { supersample(f, 0xffffffffu, 0, 0); }
static void supersampling_fits(struct frame *f) { supersample(f, 8, 8192, 8192); }
static void supersampling_wide(struct frame *f) { supersample(f, 16, 4097, 0); }
static void supersampling_high(struct frame *f) { supersample(f, 3, 0, 21846); }
static void pass_1(struct frame *f) { f->desc.pass_triangles = 1; }
static void pass_1023(struct frame *f) { f->desc.pass_triangles = 1023; }
static void pass_1024(struct frame *f) { f->desc.pass_triangles = 1024; }
static void pass_most(struct frame *f) { f->desc.pass_triangles = 0x7fffffffu; }
static void pass_2_31(struct frame *f) { f->desc.pass_triangles = 0x80000000u; }
static void crop_alone(struct frame *f) { f->desc.crop_x = 1; }
static void crop_beyond(struct frame *f)
{
    f->desc.picture_height = 100;
    f->desc.crop_y = 31;
}
static void crop_negative(struct frame *f) { f->desc.crop_y = (uint32_t)-1; }
static void set_viewport(struct frame *f, uint32_t x, uint32_t y, uint32_t width, uint32_t height)
{
    const shd_region region = {x, y, width, height};
    f->region = region;
    f->desc.viewport = &f->region;
}
static void set_scissor(struct frame *f, uint32_t x, uint32_t y, uint32_t width, uint32_t height)
{
    set_viewport(f, x, y, width, height);
    f->desc.viewport = NULL;
    f->desc.scissor = &f->region;
}
static void viewport_all(struct frame *f) { set_viewport(f, 0, 0, 100, 70); }
static void viewport_corner(struct frame *f) { set_viewport(f, 99, 69, 1, 1); }
static void viewport_width_0(struct frame *f) { set_viewport(f, 0, 0, 0, 70); }
static void viewport_height_0(struct frame *f) { set_viewport(f, 0, 0, 100, 0); }
static void viewport_negative(struct frame *f) { set_viewport(f, (uint32_t)-1, 0, 10, 10); }
static void viewport_outside(struct frame *f) { set_viewport(f, 0, 70, 10, 10); }
static void viewport_wide(struct frame *f) { set_viewport(f, 1, 0, 100, 70); }
static void viewport_huge(struct frame *f) { set_viewport(f, 1, 1, 99, 0xffffffffu); }
static void scissor_empty(struct frame *f) { set_scissor(f, 100, 70, 0, 0); }
static void scissor_negative(struct frame *f) { set_scissor(f, 0, (uint32_t)-5, 10, 10); }
static void scissor_outside(struct frame *f) { set_scissor(f, 101, 0, 0, 0); }
static void scissor_wide(struct frame *f) { set_scissor(f, 50, 0, 51, 70); }
static void scissor_high(struct frame *f) { set_scissor(f, 50, 1, 50, 70); }
static void flags(struct frame *f) { f->desc.flags = 5; }
static void clear_nan(struct frame *f) { f->desc.clear_color[2] = NAN; }
static void clear_inf(struct frame *f) { f->desc.clear_color[0] = -INFINITY; }
static void depth_low(struct frame *f) { f->desc.clear_depth = -0.001f; }
static void depth_high(struct frame *f) { f->desc.clear_depth = 1.001f; }
static void depth_nan(struct frame *f) { f->desc.clear_depth = NAN; }
static void view_nan(struct frame *f) { f->desc.view.world_to_view[5] = NAN; }
static void view_inf(struct frame *f) { f->desc.view.world_to_view[12] = INFINITY; }
static void clip_nan(struct frame *f) { f->desc.view.view_to_clip[15] = NAN; }
static void clip_inf(struct frame *f) { f->desc.view.view_to_clip[0] = -INFINITY; }
static void eye_nan(struct frame *f) { f->desc.view.eye[2] = NAN; }
static void visibility_3(struct frame *f) { f->desc.visibility = (shd_visibility)3; }
static void visibility_negative(struct frame *f) { f->desc.visibility = (shd_visibility)-1; }
static void framebuffer_null(struct frame *f) { f->desc.framebuffer = NULL; }
static void framebuffer_mesh(struct frame *f) { f->desc.framebuffer = (shd_framebuffer *)f->scene.mesh[0]; }
static void draws_null(struct frame *f) { f->desc.draws = NULL; }
static void draws_many(struct frame *f) { f->desc.draw_count = (1u << 20) + 1; }
static void draws_huge(struct frame *f) { f->desc.draw_count = (size_t)-1; }
static void draws_none(struct frame *f) { f->desc.draw_count = 0; }
static void draws_none_null(struct frame *f)
{
    f->desc.draw_count = 0;
    f->desc.draws = NULL;
}
static void lights_null(struct frame *f) { f->desc.lights = NULL; }
static void lights_many(struct frame *f) { f->desc.light_count = (1u << 20) + 1; }
static void lights_none(struct frame *f)
{
    f->desc.lights = NULL;
    f->desc.light_count = 0;
}
static void light_0_null(struct frame *f) { f->lights[0] = NULL; }
static void light_1_mesh(struct frame *f) { f->lights[1] = (const shd_light *)f->scene.mesh[0]; }
static void draw_0_size_0(struct frame *f) { f->draws[0].struct_size = 0; }
static void draw_0_size_5(struct frame *f) { f->draws[0].struct_size = 5; }
static void draw_0_size_half(struct frame *f) { f->draws[0].struct_size = offsetof(shd_draw, material) + 4; }
static void draw_1_size(struct frame *f) { f->draws[1].struct_size += 8; }
static void draw_1_size_0(struct frame *f) { f->draws[1].struct_size = 0; }
static void draw_0_frequency(struct frame *f) { f->draws[0].frequency = (shd_frequency)3; }
static void draw_1_frequency(struct frame *f) { f->draws[1].frequency = SHD_FREQUENCY_MAX_ENUM; }
static void draw_1_cull(struct frame *f) { f->draws[1].cull = (shd_cull)-1; }
static void draw_1_compare(struct frame *f) { f->draws[1].compare = (shd_compare)8; }
static void draw_1_flags(struct frame *f) { f->draws[1].flags = SHD_DRAW_SAMPLE_SHADING | 8; }
static void draw_1_bias(struct frame *f) { f->draws[1].depth_bias = NAN; }
static void draw_1_slope(struct frame *f) { f->draws[1].depth_bias_slope = INFINITY; }
static void draw_1_matrix_nan(struct frame *f) { f->draws[1].object_to_world[13] = NAN; }
static void draw_1_matrix_inf(struct frame *f) { f->draws[1].object_to_world[0] = INFINITY; }
static void draw_1_projective(struct frame *f) { f->draws[1].object_to_world[11] = 0.5f; }
static void draw_0_last_zero(struct frame *f) { f->draws[0].object_to_world[15] = 0.0f; }
static void draw_1_mesh_null(struct frame *f) { f->draws[1].mesh = NULL; }
static void draw_1_mesh_dead(struct frame *f) { f->draws[1].mesh = f->dead_mesh; }
static void draw_1_mesh_light(struct frame *f) { f->draws[1].mesh = (const shd_mesh *)f->scene.light[0]; }
static void draw_0_material_null(struct frame *f) { f->draws[0].material = NULL; }
static void draw_1_material_texture(struct frame *f)
{
    f->draws[1].material = (const shd_material *)f->scene.texture[0];
}
static void third_draw_bad_but_unused(struct frame *f) { f->draws[2].mesh = NULL; }
static void third_light_bad_but_unused(struct frame *f) { f->lights[2] = NULL; }
static void newer_draws(struct frame *f) { widen(f, sizeof(struct newer_draw)); }
static void newer_draw_0_set(struct frame *f) { set_later(f, 0); }
static void newer_draw_1_set(struct frame *f) { set_later(f, 1); }
static void newer_draws_odd(struct frame *f) { widen(f, (uint32_t)sizeof(shd_draw) + 1); }

struct edit_case {
    const char *name;
    void (*edit)(struct frame *f);
    shd_result expected;
    const char *message;
};
#define REFUSED SHD_ERROR_INVALID_ARGUMENT
static const struct edit_case k_edits[] = {
    {"nothing_wrong", edit_nothing, SHD_OK, ""},
    {"struct_size/0", size_zero, REFUSED, "render.struct_size: 0 is below"},
    {"struct_size/15", size_small, REFUSED, "render.struct_size: 15 is below 16"},
    {"struct_size/half_a_pointer", size_half, REFUSED, "is not a multiple of 8, the alignment of the struct"},
    {"struct_size/huge", size_huge, REFUSED, "render.struct_size: 4294967295"},
    {"picture_width/below_framebuffer", picture_narrow, REFUSED, "render.picture_width: 99 is not in 100..65536"},
    {"picture_height/below_framebuffer", picture_low, REFUSED, "render.picture_height: 1 is not in 70..65536"},
    {"picture_width/65537", picture_wide, REFUSED, "render.picture_width: 65537 is not in 100..65536"},
    {"picture_height/uint32_max", picture_high, REFUSED, "render.picture_height: 4294967295 is not in 70..65536"},
    {"picture/65536", picture_largest, SHD_OK, ""},
    {"crop_x/without_picture", crop_alone, REFUSED, "render.crop_x: 1 is not in 0..0"},
    {"crop_y/beyond", crop_beyond, REFUSED, "render.crop_y: 31 is not in 0..30"},
    {"crop_y/-1", crop_negative, REFUSED, "render.crop_y: 4294967295 is not in 0..0"},
    {"viewport/all", viewport_all, SHD_OK, ""},
    {"viewport/last_pixel", viewport_corner, SHD_OK, ""},
    {"viewport.width/0", viewport_width_0, REFUSED, "render.viewport.width: 0 is not in 1..100"},
    {"viewport.height/0", viewport_height_0, REFUSED, "render.viewport.height: 0 is not in 1..70"},
    {"viewport.x/-1", viewport_negative, REFUSED, "render.viewport.x: 4294967295 is not in 0..99"},
    {"viewport.y/outside", viewport_outside, REFUSED, "render.viewport.y: 70 is not in 0..69"},
    {"viewport.width/beyond", viewport_wide, REFUSED, "render.viewport.width: 100 is not in 1..99"},
    {"viewport.height/uint32_max", viewport_huge, REFUSED, "render.viewport.height: 4294967295 is not in 1..69"},
    {"scissor/empty", scissor_empty, SHD_OK, ""},
    {"scissor.y/-5", scissor_negative, REFUSED, "render.scissor.y: 4294967291 is not in 0..70"},
    {"scissor.x/outside", scissor_outside, REFUSED, "render.scissor.x: 101 is not in 0..100"},
    {"scissor.width/beyond", scissor_wide, REFUSED, "render.scissor.width: 51 is not in 0..50"},
    {"scissor.height/beyond", scissor_high, REFUSED, "render.scissor.height: 70 is not in 0..69"},
    {"supersampling/1", supersampling_1, SHD_OK, ""},
    {"supersampling/10", supersampling_10, SHD_OK, ""},
    {"supersampling/17", supersampling_17, REFUSED, "render.supersampling: 17 is not in 1..16"},
    {"supersampling/uint32_max", supersampling_huge, REFUSED, "render.supersampling: 4294967295 is not in 1..16"},
    {"supersampling/picture_fits", supersampling_fits, SHD_OK, ""},
    {"supersampling/picture_too_wide", supersampling_wide, REFUSED,
     "render.supersampling: 16 times a picture of 4097 x 70 exceeds 65536 pixels a side"},
    {"supersampling/picture_too_high", supersampling_high, REFUSED,
     "render.supersampling: 3 times a picture of 100 x 21846 exceeds 65536 pixels a side"},
    {"pass_triangles/1", pass_1, REFUSED, "render.pass_triangles: 1 is not in 1024..2147483647"},
    {"pass_triangles/1023", pass_1023, REFUSED, "render.pass_triangles: 1023 is not in 1024..2147483647"},
    {"pass_triangles/1024", pass_1024, SHD_OK, ""},
    {"pass_triangles/most", pass_most, SHD_OK, ""},
    {"pass_triangles/2^31", pass_2_31, REFUSED, "render.pass_triangles: 2147483648 is not in 1024..2147483647"},
    {"flags/unknown", flags, SHD_ERROR_UNSUPPORTED, "render.flags: bits 0x4 "},
    {"clear_color/nan", clear_nan, REFUSED, "render.clear_color[2]: nan is not finite"},
    {"clear_color/inf", clear_inf, REFUSED, "render.clear_color[0]: -inf is not finite"},
    {"clear_depth/below", depth_low, REFUSED, "render.clear_depth: -0.001 is not in 0..1"},
    {"clear_depth/above", depth_high, REFUSED, "render.clear_depth: 1.001"},
    {"clear_depth/nan", depth_nan, REFUSED, "render.clear_depth: nan"},
    {"world_to_view/nan", view_nan, REFUSED, "render.view.world_to_view[5]: nan"},
    {"world_to_view/inf", view_inf, REFUSED, "render.view.world_to_view[12]: inf"},
    {"view_to_clip/nan", clip_nan, REFUSED, "render.view.view_to_clip[15]: nan"},
    {"view_to_clip/inf", clip_inf, REFUSED, "render.view.view_to_clip[0]: -inf"},
    {"eye/nan", eye_nan, REFUSED, "render.view.eye[2]: nan"},
    {"visibility/3", visibility_3, REFUSED, "render.visibility: 3 is not in 0..2"},
    {"visibility/-1", visibility_negative, REFUSED, "render.visibility: 4294967295 is not in 0..2"},
    {"framebuffer/null", framebuffer_null, REFUSED, "render.framebuffer: NULL"},
    {"framebuffer/mesh", framebuffer_mesh, REFUSED, "render.framebuffer: not a live handle of its type"},
    {"draws/null", draws_null, REFUSED, "render.draws: NULL"},
    {"draws/2^20+1", draws_many, REFUSED, "render.draw_count: 1048577 is not in 0..1048576"},
    {"draws/size_max", draws_huge, REFUSED, "render.draw_count: 18446744073709551615"},
    {"draws/none", draws_none, SHD_OK, ""},
    {"draws/none_and_null", draws_none_null, SHD_OK, ""},
    {"lights/null", lights_null, REFUSED, "render.lights: NULL"},
    {"lights/2^20+1", lights_many, REFUSED, "render.light_count: 1048577"},
    {"lights/none", lights_none, SHD_OK, ""},
    {"lights[0]/null", light_0_null, REFUSED, "render.lights[0]: light: NULL"},
    {"lights[1]/mesh", light_1_mesh, REFUSED, "render.lights[1]: light: not a live handle of its type"},
    {"lights[2]/beyond_count", third_light_bad_but_unused, SHD_OK, ""},
    {"draws[0].struct_size/0", draw_0_size_0, REFUSED, "render.draws[0]: draw.struct_size: 0"},
    {"draws[0].struct_size/5", draw_0_size_5, REFUSED, "render.draws[0]: draw.struct_size: 5"},
    {"draws[0].struct_size/half_a_pointer", draw_0_size_half, REFUSED, "draw.struct_size: 20 is not a multiple of 8"},
    {"draws[1].struct_size/differs", draw_1_size, REFUSED, " differs from that of draws[0]"},
    {"draws[1].struct_size/0", draw_1_size_0, REFUSED, "render.draws[1].struct_size: 0 differs"},
    {"draws[0].frequency/3", draw_0_frequency, REFUSED, "render.draws[0]: draw.frequency: 3"},
    {"draws[1].frequency/max", draw_1_frequency, REFUSED, "render.draws[1]: draw.frequency: 2147483647"},
    {"draws[1].cull/-1", draw_1_cull, REFUSED, "render.draws[1]: draw.cull: 4294967295 is not in 0..2"},
    {"draws[1].compare/8", draw_1_compare, REFUSED, "render.draws[1]: draw.compare: 8 is not in 0..7"},
    {"draws[1].flags/8", draw_1_flags, SHD_ERROR_UNSUPPORTED, "render.draws[1]: draw.flags: bits 0x8 "},
    {"draws[1].depth_bias/nan", draw_1_bias, REFUSED, "render.draws[1]: draw.depth_bias: nan"},
    {"draws[1].depth_bias_slope/inf", draw_1_slope, REFUSED, "render.draws[1]: draw.depth_bias_slope"},
    {"draws[1].object_to_world/nan", draw_1_matrix_nan, REFUSED, "render.draws[1]: draw.object_to_world[13]: nan"},
    {"draws[1].object_to_world/inf", draw_1_matrix_inf, REFUSED, "render.draws[1]: draw.object_to_world[0]: inf"},
    {"draws[1].object_to_world/projective", draw_1_projective, REFUSED,
     "render.draws[1]: draw.object_to_world: the last row is not 0 0 0 1"},
    {"draws[0].object_to_world/zero_corner", draw_0_last_zero, REFUSED, "render.draws[0]: draw.object_to_world"},
    {"draws[1].mesh/null", draw_1_mesh_null, REFUSED, "render.draws[1]: draw.mesh: NULL"},
    {"draws[1].mesh/released", draw_1_mesh_dead, REFUSED, "render.draws[1]: draw.mesh: not a live handle"},
    {"draws[1].mesh/light", draw_1_mesh_light, REFUSED, "render.draws[1]: draw.mesh: not a live handle of its type"},
    {"draws[0].material/null", draw_0_material_null, SHD_OK, ""},
    {"draws[1].material/texture", draw_1_material_texture, REFUSED, "render.draws[1]: draw.material: not a live"},
    {"draws[2]/beyond_count", third_draw_bad_but_unused, SHD_OK, ""},
    {"newer_draws/zero_tail", newer_draws, SHD_OK, ""},
    {"newer_draws/tail_of_0_set", newer_draw_0_set, SHD_ERROR_UNSUPPORTED, "render.draws[0]: draw: byte "},
    {"newer_draws/tail_of_1_set", newer_draw_1_set, SHD_ERROR_UNSUPPORTED, "render.draws[1]: draw: byte "},
    {"newer_draws/odd_size", newer_draws_odd, REFUSED, "render.draws[0]: draw.struct_size: 153 is not a multiple of 8"},
};

static int is_zero(const shd_render_stats *stats)
{
    const shd_render_stats zero = shd_render_stats_default();
    return memcmp(stats, &zero, sizeof zero) == 0;
}

/* Statistics as the caller may have left them: every byte behind struct_size is set. */
static void spoil(shd_render_stats *stats)
{
    memset(stats, 0xee, sizeof *stats);
    stats->struct_size = sizeof *stats;
}

static void test_edit(void **state)
{
    const struct edit_case *c = (const struct edit_case *)*state;
    struct frame f;
    uint64_t before;
    open_frame(&f);
    before = shd_hash_framebuffer(f.scene.framebuffer);
    c->edit(&f);
    spoil(&f.stats);
    shd_assert_result(c->name, shd_render(f.context, &f.desc), c->expected, c->message);
    if (c->expected != SHD_OK) {
        assert_true(shd_hash_framebuffer(f.scene.framebuffer) == before);
        if (f.desc.struct_size == sizeof f.desc) assert_true(is_zero(&f.stats));
    } else {
        assert_true(f.stats.triangle_count == (f.desc.draw_count ? 2 + 48u : 0u));
    }
    close_frame(&f);
}

static void test_null_desc(void **state)
{
    struct frame f;
    (void)state;
    open_frame(&f);
    shd_assert_result("desc", shd_render(f.context, NULL), REFUSED, "render: NULL");
    spoil(&f.stats);
    shd_assert_result("context", shd_render(NULL, &f.desc), REFUSED, "context: NULL");
    assert_true(is_zero(&f.stats));
    spoil(&f.stats);
    shd_assert_result("context", shd_render((shd_context *)f.scene.mesh[0], &f.desc), REFUSED,
                      "context: not a live handle");
    assert_true(is_zero(&f.stats));
    f.desc.stats = NULL;
    shd_assert_ok(shd_render(f.context, &f.desc));
    close_frame(&f);
}

/* A desc from a newer header: its tail must be zero. */
static void test_newer_desc(void **state)
{
    struct {
        shd_render_desc desc;
        uint64_t later;
    } newer;
    struct frame f;
    uint64_t want;
    (void)state;
    open_frame(&f);
    shd_assert_ok(shd_render(f.context, &f.desc));
    want = shd_hash_framebuffer(f.scene.framebuffer);
    newer.desc = f.desc;
    newer.desc.struct_size = (uint32_t)sizeof newer;
    newer.later = 0;
    shd_assert_ok(shd_render(f.context, &newer.desc));
    assert_true(shd_hash_framebuffer(f.scene.framebuffer) == want);
    newer.later = 1;
    shd_assert_result("set tail", shd_render(f.context, &newer.desc), SHD_ERROR_UNSUPPORTED, "is set");
    assert_true(shd_hash_framebuffer(f.scene.framebuffer) == want);
    widen(&f, sizeof(struct newer_draw));
    shd_assert_ok(shd_render(f.context, &f.desc));
    assert_true(shd_hash_framebuffer(f.scene.framebuffer) == want);
    close_frame(&f);
}

/* A context renders objects of another context. */
static void test_other_context(void **state)
{
    shd_context *other = NULL;
    struct frame f;
    uint64_t want;
    (void)state;
    open_frame(&f);
    shd_assert_ok(shd_render(f.context, &f.desc));
    want = shd_hash_framebuffer(f.scene.framebuffer);
    shd_assert_ok(shd_context_create(NULL, &other));
    f.desc.clear_color[0] = 0.5f;
    shd_assert_ok(shd_render(other, &f.desc));
    assert_true(shd_hash_framebuffer(f.scene.framebuffer) != want);
    f.desc.clear_color[0] = 0.0f;
    shd_assert_ok(shd_render(other, &f.desc));
    assert_true(shd_hash_framebuffer(f.scene.framebuffer) == want);
    shd_context_release(other);
    close_frame(&f);
}

int main(void)
{
    static struct CMUnitTest tests[sizeof k_edits / sizeof k_edits[0] + 3];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_edits / sizeof k_edits[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_edits[i].name, test_edit, NULL, NULL, (void *)&k_edits[i]};
    }
    tests[n++] = (struct CMUnitTest){"null_desc", test_null_desc, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"newer_desc", test_newer_desc, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"other_context", test_other_context, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.render", tests, n, NULL, NULL);
}
