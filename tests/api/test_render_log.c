/* SPDX-License-Identifier: MIT */
/* Reasons of a black frame, in the log and the statistics: a draw has no material, or its material no light. */
#include "support/frame.h"

struct lines {
    int count;
    shd_log_level level;
    char text[4][200];
};
static void write_line(shd_log_level level, const char *message, void *user_data)
{
    struct lines *lines = (struct lines *)user_data;
    lines->level = level;
    if (lines->count < 4) snprintf(lines->text[lines->count], sizeof lines->text[0], "%s", message);
    ++lines->count;
}

enum { BARE = 1, DARK = 2 }; /* expected lines */

struct log_case {
    const char *name;
    shd_model model;
    float emission;
    int has_material, has_light, supersampling, lines, draws; /* draws: black ones */
};
static const struct log_case k_cases[] = {
    {"lit", SHD_MODEL_LAMBERT, 0, 1, 1, 1, 0, 0},
    {"no_light", SHD_MODEL_LAMBERT, 0, 1, 0, 1, DARK, 2},
    {"no_light_metallic", SHD_MODEL_METALLIC_ROUGHNESS, 0, 1, 0, 1, DARK, 2},
    {"no_light_supersampled", SHD_MODEL_PHONG, 0, 1, 0, 2, DARK, 2},
    {"no_light_unlit", SHD_MODEL_UNLIT, 0, 1, 0, 1, 0, 0},
    {"no_light_emission", SHD_MODEL_LAMBERT, 0.5f, 1, 0, 1, 0, 0},
    {"no_material", SHD_MODEL_LAMBERT, 0, 0, 1, 1, BARE, 1},
    {"no_material_no_light", SHD_MODEL_LAMBERT, 0, 0, 0, 1, BARE | DARK, 2},
};

/* Draw 0 has two instances; draw 1 is like it but has always a material. */
static void test_lines(void **state)
{
    const struct log_case *c = (const struct log_case *)*state;
    static const float k_instances[32] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1,
                                          1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    shd_context_desc context_desc = shd_context_desc_default();
    shd_material_desc material = shd_material_desc_default();
    shd_render_stats stats = shd_render_stats_default();
    struct lines lines;
    float quad[48];
    shd_context *silent;
    shd_frame f;
    int line = 0;
    shd_frame_open(&f, 8, 8);
    silent = f.context;
    memset(&lines, 0, sizeof lines);
    context_desc.log.write = write_line;
    context_desc.log.user_data = &lines;
    shd_assert_ok(shd_context_create(&context_desc, &f.context));
    material.model = c->model;
    material.emission[1] = c->emission;
    shd_frame_quad(-1, -1, 1, 1, 0.5f, 0.5f, quad);
    shd_frame_draw(&f, quad, 6, &material);
    shd_frame_draw(&f, quad, 6, &material);
    f.draw[0].instances = k_instances;
    f.draw[0].instance_count = 2;
    if (!c->has_material) f.draw[0].material = NULL;
    if (c->has_light) shd_frame_ambient(&f);
    f.desc.supersampling = (uint32_t)c->supersampling;
    f.desc.stats = &stats;
    shd_assert_ok(shd_render(f.context, &f.desc));
    assert_int_equal(stats.black_draw_count, c->draws);
    assert_int_equal(lines.count, !!(c->lines & BARE) + !!(c->lines & DARK));
    if (c->lines & BARE) {
        assert_string_equal(lines.text[line++],
                            "render.draws[0]: no material, so no colour is written (draws like it: 1)");
    }
    if (c->lines & DARK) {
        assert_string_equal(lines.text[line++],
                            c->has_material
                                ? "render.draws[0]: no lights and no environment, so it is black (draws like it: 2)"
                                : "render.draws[1]: no lights and no environment, so it is black (draws like it: 1)");
    }
    if (line) assert_int_equal(lines.level, SHD_LOG_LEVEL_INFO);
    shd_context_release(silent);
    shd_frame_close(&f);
}

int main(void)
{
    enum { COUNT = sizeof k_cases / sizeof k_cases[0] };
    struct CMUnitTest tests[COUNT];
    size_t i;
    memset(tests, 0, sizeof tests);
    for (i = 0; i < COUNT; ++i) {
        tests[i].name = k_cases[i].name;
        tests[i].test_func = test_lines;
        tests[i].initial_state = (void *)(uintptr_t)&k_cases[i];
    }
    return _cmocka_run_group_tests("api.render_log", tests, COUNT, NULL, NULL);
}
