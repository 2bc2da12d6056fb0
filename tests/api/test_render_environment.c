/* SPDX-License-Identifier: MIT */
/* Frames in the light of an environment: every model against the texels as directional lights, rotation, occlusion,
   windows and workers, and every wrong argument. */
#include "support/sky.h"

static const struct model_case k_models[] = {
    {"model/lambert", SHD_MODEL_LAMBERT, SHD_FREQUENCY_PHONG, 0, 0, 0, 0.01, 0.005},
    {"model/lambert/gouraud", SHD_MODEL_LAMBERT, SHD_FREQUENCY_GOURAUD, 0, 0, 0, 0.01, 0.005},
    {"model/lambert/flat", SHD_MODEL_LAMBERT, SHD_FREQUENCY_FLAT, 0, 0, 0, 0.01, 0.005},
    {"model/phong/4", SHD_MODEL_PHONG, SHD_FREQUENCY_PHONG, 4, 0, 0, 0.1, 0.02},
    {"model/phong/20", SHD_MODEL_PHONG, SHD_FREQUENCY_PHONG, 20, 0, 0, 0.1, 0.02},
    {"model/phong/20/gouraud", SHD_MODEL_PHONG, SHD_FREQUENCY_GOURAUD, 20, 0, 0, 0.1, 0.02},
    {"model/blinn_phong/10", SHD_MODEL_BLINN_PHONG, SHD_FREQUENCY_PHONG, 10, 0, 0, 0.1, 0.02},
    {"model/blinn_phong/60", SHD_MODEL_BLINN_PHONG, SHD_FREQUENCY_PHONG, 60, 0, 0, 0.1, 0.02},
    {"model/blinn_phong/2", SHD_MODEL_BLINN_PHONG, SHD_FREQUENCY_PHONG, 2, 0, 0, 0.15, 0.04},
    {"model/blinn_phong/8", SHD_MODEL_BLINN_PHONG, SHD_FREQUENCY_PHONG, 8, 0, 0, 0.1, 0.02},
    {"model/blinn_phong/200", SHD_MODEL_BLINN_PHONG, SHD_FREQUENCY_PHONG, 200, 0, 0, 0.1, 0.02},
    {"model/normalized/2", SHD_MODEL_BLINN_PHONG_NORMALIZED, SHD_FREQUENCY_PHONG, 2, 0, 0, 0.15, 0.04},
    {"model/normalized/8", SHD_MODEL_BLINN_PHONG_NORMALIZED, SHD_FREQUENCY_PHONG, 8, 0, 0, 0.15, 0.04},
    {"model/normalized/200", SHD_MODEL_BLINN_PHONG_NORMALIZED, SHD_FREQUENCY_PHONG, 200, 0, 0, 0.1, 0.02},
    {"model/normalized/30", SHD_MODEL_BLINN_PHONG_NORMALIZED, SHD_FREQUENCY_PHONG, 30, 0, 0, 0.1, 0.02},
    {"model/combined/30", SHD_MODEL_COMBINED, SHD_FREQUENCY_PHONG, 30, 0, 0, 0.1, 0.02},
    {"model/metal/0.4", SHD_MODEL_METALLIC_ROUGHNESS, SHD_FREQUENCY_PHONG, 0, 0.4f, 1, 0.45, 0.035},
    {"model/metal/0.7", SHD_MODEL_METALLIC_ROUGHNESS, SHD_FREQUENCY_PHONG, 0, 0.7f, 1, 0.45, 0.035},
    {"model/metal/1", SHD_MODEL_METALLIC_ROUGHNESS, SHD_FREQUENCY_PHONG, 0, 1, 1, 0.45, 0.035},
    {"model/dielectric/0.4", SHD_MODEL_METALLIC_ROUGHNESS, SHD_FREQUENCY_PHONG, 0, 0.4f, 0, 0.3, 0.02},
    {"model/dielectric/1", SHD_MODEL_METALLIC_ROUGHNESS, SHD_FREQUENCY_PHONG, 0, 1, 0, 0.05, 0.01},
    {"model/gooch", SHD_MODEL_GOOCH, SHD_FREQUENCY_PHONG, 0, 0, 0, 1, 1},
};

/** An environment gives about the light of its texels as directional lights. */
static void test_model(void **state)
{
    const struct model_case *row = (const struct model_case *)*state;
    shd_material *material = make_material(row);
    static struct picture got, want;
    struct scene scene;
    open_scene(&scene, material);
    scene.draw.frequency = row->frequency;
    render(&scene, &got);
    scene.desc.environment = NULL;
    if (row->model == SHD_MODEL_GOOCH) { /* it reflects no environment */
        render(&scene, &want);
        assert_memory_equal(&got, &want, sizeof got);
    } else {
        scene.desc.lights = (const shd_light *const *)g_lights;
        scene.desc.light_count = LIGHTS;
        render(&scene, &want);
        compare(row->name, &got, &want, row->max_error, row->rms_error);
    }
    close_scene(&scene);
    shd_material_release(material);
}

/** Intensity scales, lights add, and occlusion multiplies the environment alone. */
static void test_combination(void **state)
{
    static const struct model_case k_row = {"", SHD_MODEL_METALLIC_ROUGHNESS, SHD_FREQUENCY_PHONG, 0, 0.5f, 0.5f, 0, 0};
    static struct picture environment, light, both, occluded;
    const shd_light *lights[1] = {g_lights[100]};
    shd_material *material = make_material(&k_row), *dark = NULL;
    shd_material_desc desc = shd_material_desc_default();
    float occlusion[1] = {0.25f};
    shd_texture_desc texture_desc = shd_texture_desc_default();
    shd_texture *texture = NULL;
    shd_slot slot;
    struct scene scene;
    (void)state;
    texture_desc.format = SHD_FORMAT_R32F;
    texture_desc.width = texture_desc.height = 1;
    texture_desc.texels = occlusion;
    shd_assert_ok(shd_texture_create(g_context, &texture_desc, &texture));
    slot = shd_slot_texture(SHD_SLOT_OCCLUSION, texture, NULL);
    desc.model = k_row.model;
    desc.roughness = k_row.roughness;
    desc.metallic = k_row.metallic;
    desc.diffuse[0] = 0.9f, desc.diffuse[1] = 0.6f, desc.diffuse[2] = 0.3f;
    desc.slots = &slot;
    desc.slot_count = 1;
    shd_assert_ok(shd_material_create(g_context, &desc, &dark));
    open_scene(&scene, material);
    scene.desc.environment_intensity = 2.0f;
    render(&scene, &environment);
    scene.desc.lights = lights;
    scene.desc.light_count = 1;
    render(&scene, &both);
    scene.draw.material = dark;
    render(&scene, &occluded);
    scene.desc.environment = NULL;
    render(&scene, &light);
    for (size_t i = 0; i < 3 * EDGE * EDGE; ++i) {
        const size_t c = i / (EDGE * EDGE), k = i % (EDGE * EDGE);
        const double e = (double)environment.plane[c][k], l = (double)light.plane[c][k];
        shd_assert_close("both", i, (double)both.plane[c][k], e + l, 1e-6, 1e-6);
        shd_assert_close("occluded", i, (double)occluded.plane[c][k], 0.25 * e + l, 1e-6, 1e-6);
    }
    scene.desc.environment = g_environment;
    scene.desc.light_count = 0;
    scene.draw.material = material;
    scene.desc.environment_intensity = 1.0f;
    render(&scene, &light);
    compare("half", &light, &light, 0.0, 0.0);
    for (size_t i = 0; i < EDGE * EDGE; ++i) {
        shd_assert_close("intensity", i, (double)environment.plane[0][i], 2.0 * (double)light.plane[0][i], 1e-7, 1e-6);
    }
    close_scene(&scene);
    shd_material_release(material);
    shd_material_release(dark);
    shd_texture_release(texture);
}

/** A turned environment under a turned camera gives the same picture of a sphere. */
static void test_rotation(void **state)
{
    static const struct model_case k_row = {"", SHD_MODEL_PHONG, SHD_FREQUENCY_PHONG, 9, 0, 0, 0, 0};
    static struct picture straight, turned;
    shd_material *material = make_material(&k_row);
    struct scene scene;
    (void)state;
    open_scene(&scene, material);
    scene.desc.background = SHD_BACKGROUND_ENVIRONMENT;
    render(&scene, &straight);
    /* A quarter turn about +Y: +Z becomes +X. */
    memset(scene.desc.environment_to_world, 0, sizeof scene.desc.environment_to_world);
    scene.desc.environment_to_world[2] = -1.0f;
    scene.desc.environment_to_world[4] = 1.0f;
    scene.desc.environment_to_world[6] = 1.0f;
    scene.camera.eye[0] = 3.0f, scene.camera.eye[2] = 0.0f;
    render(&scene, &turned);
    compare("rotation", &turned, &straight, 0.002, 0.0005);
    close_scene(&scene);
    shd_material_release(material);
}

/** Windows, workers, SIMD targets and passes give the same bits. */
static void test_same_bits(void **state)
{
    static const struct model_case k_row = {"", SHD_MODEL_METALLIC_ROUGHNESS, SHD_FREQUENCY_PHONG, 0, 0.3f, 0.5f, 0, 0};
    static struct picture whole, part;
    shd_material *material = make_material(&k_row);
    struct scene scene;
    int tried = 0;
    (void)state;
    open_scene(&scene, material);
    scene.desc.background = SHD_BACKGROUND_ENVIRONMENT;
    render(&scene, &whole);
    render_window(g_context, &scene, 11, 17, 31, &part);
    for (size_t i = 0; i < 31 * 31; ++i) {
        for (int c = 0; c < 4; ++c) {
            const size_t at = (i / 31 + 17) * EDGE + i % 31 + 11;
            assert_true(part.plane[c][i] == whole.plane[c][at]);
        }
    }
    scene.desc.pass_triangles = 1024;
    for (int simd = SHD_SIMD_BASELINE; simd <= SHD_SIMD_WASM; ++simd) {
        shd_context_desc desc = shd_context_desc_default();
        shd_context *context = NULL;
        desc.simd = (shd_simd)simd;
        desc.worker_count = simd % 2 ? 1 : 3;
        if (shd_context_create(&desc, &context) != SHD_OK) continue;
        render_window(context, &scene, 0, 0, EDGE, &part);
        assert_memory_equal(&part, &whole, sizeof part);
        shd_context_release(context);
        ++tried;
    }
    assert_true(tried >= 1);
    close_scene(&scene);
    shd_material_release(material);
}

static void edit_nothing(shd_render_desc *d) { (void)d; }
static void edit_intensity(shd_render_desc *d) { d->environment_intensity = -1.0f; }
static void edit_intensity_nan(shd_render_desc *d) { d->environment_intensity = (float)NAN; }
static void edit_bright(shd_render_desc *d) { d->environment_intensity = 1e12f; }
static void edit_rotation_nan(shd_render_desc *d) { d->environment_to_world[3] = (float)NAN; }
static void edit_rotation_0(shd_render_desc *d) { d->environment_to_world[4] = 0.0f; }
static void edit_rotation_skewed(shd_render_desc *d) { d->environment_to_world[1] = 0.1f; }
static void edit_mirrored(shd_render_desc *d) { d->environment_to_world[0] = -1.0f; }
static void edit_background(shd_render_desc *d) { d->background = (shd_background)2; }
static void edit_background_alone(shd_render_desc *d)
{
    d->environment = NULL;
    d->background = SHD_BACKGROUND_ENVIRONMENT;
}
static void edit_blur(shd_render_desc *d) { d->background_roughness = 1.5f; }
static void edit_handle(shd_render_desc *d) { d->environment = (const shd_environment *)(const void *)g_lights[0]; }
static void edit_none(shd_render_desc *d) { d->environment = NULL; }

struct refusal_case {
    const char *name;
    void (*edit)(shd_render_desc *desc);
    shd_result expected;
    const char *message;
};
static const struct refusal_case k_refusals[] = {
    {"desc/default", edit_nothing, SHD_OK, ""},
    {"desc/none", edit_none, SHD_OK, ""},
    {"desc/bright", edit_bright, SHD_OK, ""},
    {"desc/mirrored", edit_mirrored, SHD_OK, ""},
    {"desc/intensity", edit_intensity, SHD_ERROR_INVALID_ARGUMENT,
     "render.environment_intensity: -1 is not in 0..1e+12"},
    {"desc/intensity_nan", edit_intensity_nan, SHD_ERROR_INVALID_ARGUMENT, "render.environment_intensity: "},
    {"desc/rotation_nan", edit_rotation_nan, SHD_ERROR_INVALID_ARGUMENT, "render.environment_to_world[3]: "},
    {"desc/rotation_0", edit_rotation_0, SHD_ERROR_INVALID_ARGUMENT,
     "render.environment_to_world: columns 1 and 1 have the product 0, not 1"},
    {"desc/rotation_skewed", edit_rotation_skewed, SHD_ERROR_INVALID_ARGUMENT,
     "render.environment_to_world: columns 0"},
    {"desc/background", edit_background, SHD_ERROR_INVALID_ARGUMENT, "render.background: 2 is not in 0..1"},
    {"desc/background_alone", edit_background_alone, SHD_ERROR_INVALID_ARGUMENT,
     "render.background: SHD_BACKGROUND_ENVIRONMENT, but render.environment is NULL"},
    {"desc/blur", edit_blur, SHD_ERROR_INVALID_ARGUMENT, "render.background_roughness: 1.5 is not in 0..1"},
    {"desc/handle", edit_handle, SHD_ERROR_INVALID_ARGUMENT, "render.environment: not a live handle of its type"},
};

static void test_desc(void **state)
{
    static const struct model_case k_row = {"", SHD_MODEL_TOON, SHD_FREQUENCY_PHONG, 5, 0, 0, 0, 0};
    const struct refusal_case *row = (const struct refusal_case *)*state;
    shd_material *material = make_material(&k_row);
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    shd_render_stats stats = shd_render_stats_default();
    struct scene scene;
    open_scene(&scene, material);
    desc.width = desc.height = 16;
    shd_assert_ok(shd_framebuffer_create(g_context, &desc, &scene.desc.framebuffer));
    scene.desc.stats = &stats;
    row->edit(&scene.desc);
    shd_assert_result(row->name, shd_render(g_context, &scene.desc), row->expected, row->message);
    assert_int_equal(stats.nonfinite_fragment_count, 0);
    shd_framebuffer_release(scene.desc.framebuffer);
    close_scene(&scene);
    shd_material_release(material);
}

/** Environments without the tables that a frame takes are refused by name. */
static void test_tables(void **state)
{
    static const struct model_case k_rows[] = {
        {"SHD_ENVIRONMENT_TABLE_PHONG, which the model of render.draws[0]", SHD_MODEL_PHONG, SHD_FREQUENCY_PHONG, 9, 0,
         0, 0, 0},
        {"SHD_ENVIRONMENT_TABLE_GGX, which the model of render.draws[0]", SHD_MODEL_METALLIC_ROUGHNESS,
         SHD_FREQUENCY_PHONG, 9, 0, 0, 0, 0},
        {NULL, SHD_MODEL_LAMBERT, SHD_FREQUENCY_PHONG, 9, 0, 0, 0, 0},
        {NULL, SHD_MODEL_UNLIT, SHD_FREQUENCY_PHONG, 9, 0, 0, 0, 0},
    };
    shd_image image = shd_image_default();
    shd_environment_desc desc = shd_environment_desc_default();
    shd_environment *bare = NULL;
    shd_framebuffer_desc framebuffer = shd_framebuffer_desc_default();
    (void)state;
    image.format = SHD_FORMAT_RGB32F;
    image.width = WIDTH, image.height = HEIGHT;
    image.pixels = g_texels;
    desc.image = &image;
    desc.tables = SHD_ENVIRONMENT_TABLE_NONE;
    shd_assert_ok(shd_environment_create(g_context, &desc, &bare));
    framebuffer.width = framebuffer.height = 16;
    for (size_t i = 0; i < sizeof k_rows / sizeof k_rows[0]; ++i) {
        shd_material *material = make_material(&k_rows[i]);
        struct scene scene;
        open_scene(&scene, material);
        scene.desc.environment = bare;
        shd_assert_ok(shd_framebuffer_create(g_context, &framebuffer, &scene.desc.framebuffer));
        shd_assert_result("table", shd_render(g_context, &scene.desc),
                          k_rows[i].name ? SHD_ERROR_INVALID_ARGUMENT : SHD_OK, k_rows[i].name);
        scene.desc.draw_count = 0;
        scene.desc.background = SHD_BACKGROUND_ENVIRONMENT;
        shd_assert_result("background", shd_render(g_context, &scene.desc), SHD_ERROR_INVALID_ARGUMENT,
                          "SHD_ENVIRONMENT_TABLE_RADIANCE, which the background takes");
        scene.desc.background_roughness = 0.5f;
        shd_assert_result("background", shd_render(g_context, &scene.desc), SHD_ERROR_INVALID_ARGUMENT,
                          "SHD_ENVIRONMENT_TABLE_GGX, which the background takes");
        shd_framebuffer_release(scene.desc.framebuffer);
        close_scene(&scene);
        shd_material_release(material);
    }
    shd_environment_release(bare);
}

int main(void)
{
    ADD_ROWS(k_models, test_model);
    ADD_ROWS(k_refusals, test_desc);
    add("combination", test_combination, NULL);
    add("rotation", test_rotation, NULL);
    add("same_bits", test_same_bits, NULL);
    add("tables", test_tables, NULL);
    return _cmocka_run_group_tests("render_environment", g_tests, g_count, open_context, close_context);
}
