/* SPDX-License-Identifier: MIT */
/* Descs that shd_bake refuses. */
#include "support/bake_frame.h"
#include "support/rows.h"

static const shd_region k_region = {0, 0, 4, 4};
struct bad_case {
    const char *name;
    void (*edit)(shd_render_desc *frame, shd_bake_desc *bake);
    const char *message;
};
static void bad_uv_set(shd_render_desc *f, shd_bake_desc *b) { (void)f, b->uv_set = 2; }
static void bad_dilation(shd_render_desc *f, shd_bake_desc *b) { (void)f, b->dilation = 1025; }
static void bad_states(shd_render_desc *f, shd_bake_desc *b) { (void)f, b->states.stride = 3; }
static void bad_framebuffer(shd_render_desc *f, shd_bake_desc *b) { (void)b, f->framebuffer = NULL; }
static void bad_flags(shd_render_desc *f, shd_bake_desc *b) { (void)b, f->flags = SHD_RENDER_LOAD; }
static void bad_visibility(shd_render_desc *f, shd_bake_desc *b) { (void)b, f->visibility = SHD_VISIBILITY_NEWELL; }
static void bad_picture(shd_render_desc *f, shd_bake_desc *b) { (void)b, f->picture_width = 99; }
static void bad_crop(shd_render_desc *f, shd_bake_desc *b) { (void)b, f->crop_y = 1; }
static void bad_viewport(shd_render_desc *f, shd_bake_desc *b) { (void)b, f->viewport = &k_region; }
static void bad_scissor(shd_render_desc *f, shd_bake_desc *b) { (void)b, f->scissor = &k_region; }
static void bad_supersampling(shd_render_desc *f, shd_bake_desc *b) { (void)b, f->supersampling = 2; }
static void bad_background(shd_render_desc *f, shd_bake_desc *b)
{
    (void)b, f->background = SHD_BACKGROUND_ENVIRONMENT;
}
static shd_result present_tile(const shd_present_tile *tile, void *user_data)
{
    (void)tile, (void)user_data;
    return SHD_OK;
}
static void bad_present(shd_render_desc *f, shd_bake_desc *b) { (void)b, f->present.tile = present_tile; }
static void bad_volumes(shd_render_desc *f, shd_bake_desc *b) { (void)b, f->volume_count = 1; }
static void bad_clear(shd_render_desc *f, shd_bake_desc *b) { (void)b, f->clear_color[2] = NAN; }
static void bad_draws(shd_render_desc *f, shd_bake_desc *b) { (void)b, f->draws = NULL; }
static void bad_material(shd_render_desc *f, shd_bake_desc *b)
{
    static shd_draw draw;
    (void)b;
    draw = f->draws[0];
    draw.material = NULL;
    f->draws = &draw;
}
static const struct bad_case k_bad[] = {
    {"bad/uv_set", bad_uv_set, "bake.uv_set: 2 is not in 0..1"},
    {"bad/dilation", bad_dilation, "bake.dilation: 1025 is not in 0..1024"},
    {"bad/states", bad_states, "bake.states.stride: 3"},
    {"bad/framebuffer", bad_framebuffer, "render.framebuffer: NULL"},
    {"bad/flags", bad_flags, "render.flags: a bake takes"},
    {"bad/visibility", bad_visibility, "render.visibility: a bake takes"},
    {"bad/picture", bad_picture, "render.picture_width and picture_height: a bake takes"},
    {"bad/crop", bad_crop, "render.crop_x and crop_y: a bake takes"},
    {"bad/viewport", bad_viewport, "render.viewport: a bake takes"},
    {"bad/scissor", bad_scissor, "render.scissor: a bake takes"},
    {"bad/supersampling", bad_supersampling, "render.supersampling: a bake takes"},
    {"bad/background", bad_background, "render.background: a bake takes"},
    {"bad/present", bad_present, "render.present: a bake takes"},
    {"bad/volumes", bad_volumes, "render.volume_count: a bake takes"},
    {"bad/clear_color", bad_clear, "render.clear_color[2]: nan"},
    {"bad/draws", bad_draws, "render.draws: NULL"},
    {"bad/material", bad_material, "render.draws[0]: draw.material: NULL, but a bake shades every draw"},
};

static void test_bad(void **state)
{
    const struct bad_case *c = (const struct bad_case *)*state;
    shd_frame f;
    float vertices[48];
    const shd_material_desc material = program_desc();
    shd_bake_desc desc = shd_bake_desc_default();
    shd_bake_stats stats = shd_bake_stats_default();
    open_frame(&f);
    set_quad(vertices, 0, 0, 1, 1);
    (void)shd_frame_draw(&f, vertices, 6, &material);
    stats.triangle_count = 7;
    desc.stats = &stats;
    desc.states.data = g_states;
    c->edit(&f.desc, &desc);
    shd_assert_result(c->name, shd_bake(f.context, &f.desc, &desc), SHD_ERROR_INVALID_ARGUMENT, c->message);
    assert_int_equal(stats.triangle_count, 0);
    shd_frame_close(&f);
}

static void test_bad_handles(void **state)
{
    shd_frame f;
    shd_framebuffer_desc four = shd_framebuffer_desc_default();
    shd_framebuffer *samples = NULL;
    (void)state;
    open_frame(&f);
    shd_assert_result("context", shd_bake(NULL, &f.desc, NULL), SHD_ERROR_INVALID_ARGUMENT, "context: NULL");
    shd_assert_result("frame", shd_bake(f.context, NULL, NULL), SHD_ERROR_INVALID_ARGUMENT, "render: NULL");
    four.width = four.height = 8;
    four.sample_count = 4;
    shd_assert_ok(shd_framebuffer_create(f.context, &four, &samples));
    f.desc.framebuffer = samples;
    shd_assert_result("samples", shd_bake(f.context, &f.desc, NULL), SHD_ERROR_INVALID_ARGUMENT,
                      "render.framebuffer: 4 samples a pixel, but a bake takes 1");
    shd_framebuffer_release(samples);
    shd_frame_close(&f);
}

int main(void)
{
    ADD_ROWS(k_bad, test_bad);
    add("bad_handles", test_bad_handles, NULL);
    return _cmocka_run_group_tests("api.bake_bad", g_tests, g_count, NULL, NULL);
}
