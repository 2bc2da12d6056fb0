/* SPDX-License-Identifier: MIT */
/* Frames in the light of an environment: every model against the texels as directional lights, backgrounds against
   lookups, rotation, occlusion, windows and workers, and every wrong argument. */
#include "support/check.h"

#include <shd/shd.h>

#include "ref/environment_ref.h"
#include "support/noise.h"
#include "support/rows.h"

enum { EDGE = 48, WIDTH = 32, HEIGHT = 16, LIGHTS = WIDTH * HEIGHT };

static shd_context *g_context;
static shd_environment *g_environment;
static float g_texels[3 * LIGHTS];
static shd_light *g_lights[LIGHTS];

/** A smooth sky with a bright side. */
static void fill_sky(void)
{
    for (size_t i = 0; i < LIGHTS; ++i) {
        long double n[3];
        double away;
        ref_unproject(SHD_PROJECTION_LAT_LONG, (i % WIDTH + 0.5L) / WIDTH, (i / WIDTH + 0.5L) / HEIGHT, 0, n);
        away = (double)(n[0] * 0.6L + n[1] * 0.64L + n[2] * 0.48L);
        g_texels[3 * i] = (float)(0.2 + 0.1 * (double)n[1] + 2.0 * pow(fmax(away, 0.0), 8.0));
        g_texels[3 * i + 1] = (float)(0.3 + 0.2 * (double)n[1]);
        g_texels[3 * i + 2] = (float)(0.4 - 0.3 * (double)n[0]);
    }
}

static void make_lights(void)
{
    shd_image image = shd_image_default();
    shd_environment_desc desc = shd_environment_desc_default();
    ref_environment ref;
    fill_sky();
    image.format = SHD_FORMAT_RGB32F;
    image.width = WIDTH, image.height = HEIGHT;
    image.pixels = g_texels;
    desc.image = &image;
    desc.irradiance = SHD_IRRADIANCE_CONVOLVED;
    shd_assert_ok(shd_environment_create(g_context, &desc, &g_environment));
    ref = ref_environment_of(SHD_PROJECTION_LAT_LONG, &image);
    for (size_t i = 0; i < LIGHTS; ++i) {
        shd_light_desc light = shd_light_desc_default();
        light.kind = SHD_LIGHT_KIND_DIRECTIONAL;
        for (int c = 0; c < 3; ++c) {
            light.direction[c] = (float)-ref.lights[i].direction[c];
            light.intensity[c] = (float)(ref.lights[i].radiance[c] * ref.lights[i].solid_angle);
        }
        shd_assert_ok(shd_light_create(g_context, &light, &g_lights[i]));
    }
    free(ref.lights);
}

struct picture {
    float plane[4][EDGE * EDGE];
};

/** A sphere, or nothing without a material. */
struct scene {
    shd_mesh *mesh;
    shd_draw draw;
    shd_camera camera;
    shd_render_desc desc;
};

static void open_scene(struct scene *scene, shd_material *material)
{
    shd_shape_desc shape = shd_shape_desc_default();
    shape.segments[0] = 48, shape.segments[1] = 24;
    shd_assert_ok(shd_mesh_create_shape(g_context, &shape, SHD_MESH_NONE, &scene->mesh));
    scene->draw = shd_draw_default();
    scene->draw.mesh = scene->mesh;
    scene->draw.material = material;
    scene->camera = shd_camera_default();
    scene->desc = shd_render_desc_default();
    scene->desc.camera = &scene->camera;
    scene->desc.draws = &scene->draw;
    scene->desc.draw_count = material ? 1 : 0;
    scene->desc.environment = g_environment;
}

/** Renders a window of a picture of EDGE x EDGE pixels on a context. */
static void render_window(shd_context *context, struct scene *scene, uint32_t x, uint32_t y, uint32_t edge,
                          struct picture *out)
{
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    desc.width = desc.height = edge;
    shd_assert_ok(shd_framebuffer_create(context, &desc, &scene->desc.framebuffer));
    scene->desc.picture_width = scene->desc.picture_height = EDGE;
    scene->desc.crop_x = x, scene->desc.crop_y = y;
    shd_assert_ok(shd_render(context, &scene->desc));
    for (int c = 0; c < 4; ++c) {
        const shd_f32_out to = shd_f32_out_column(out->plane[c], 0); /* packed rows of the window */
        shd_assert_ok(shd_framebuffer_read_plane(scene->desc.framebuffer, (shd_plane)(SHD_PLANE_R + c), &to));
    }
    shd_framebuffer_release(scene->desc.framebuffer);
}
static void render(struct scene *scene, struct picture *out) { render_window(g_context, scene, 0, 0, EDGE, out); }

static void close_scene(struct scene *scene) { shd_mesh_release(scene->mesh); }

/** Largest and root mean square difference of two pictures, divided by the largest value of the channel in `want`. */
static void compare(const char *what, const struct picture *got, const struct picture *want, double max_error,
                    double rms_error)
{
    double worst = 0.0, squares = 0.0;
    size_t count = 0;
    for (int c = 0; c < 3; ++c) {
        double largest = 0.0;
        for (size_t i = 0; i < EDGE * EDGE; ++i) largest = fmax(largest, (double)want->plane[c][i]);
        for (size_t i = 0; i < EDGE * EDGE; ++i) {
            const double error = fabs((double)got->plane[c][i] - (double)want->plane[c][i]) / largest;
            if (want->plane[3][i] == 0.0f) continue;
            if (!(error <= worst)) worst = error;
            squares += error * error;
            ++count;
        }
    }
    if (getenv("SHD_TEST_VERBOSE")) printf("%s: %.5f %.5f\n", what, worst, sqrt(squares / (double)count));
    assert_true(count > 1000);
    if (!(worst <= max_error) || !(sqrt(squares / (double)count) <= rms_error)) {
        fail_msg("%s: largest error %.5f, mean %.5f", what, worst, sqrt(squares / (double)count));
    }
}

struct model_case {
    const char *name;
    shd_model model;
    shd_frequency frequency;
    float exponent, roughness, metallic;
    double max_error, rms_error;
};
static const struct model_case k_models[] = {
    {"model/lambert", SHD_MODEL_LAMBERT, SHD_FREQUENCY_PHONG, 0, 0, 0, 0.01, 0.005},
    {"model/lambert/gouraud", SHD_MODEL_LAMBERT, SHD_FREQUENCY_GOURAUD, 0, 0, 0, 0.01, 0.005},
    {"model/lambert/flat", SHD_MODEL_LAMBERT, SHD_FREQUENCY_FLAT, 0, 0, 0, 0.01, 0.005},
    {"model/phong/4", SHD_MODEL_PHONG, SHD_FREQUENCY_PHONG, 4, 0, 0, 0.1, 0.02},
    {"model/phong/20", SHD_MODEL_PHONG, SHD_FREQUENCY_PHONG, 20, 0, 0, 0.1, 0.02},
    {"model/phong/20/gouraud", SHD_MODEL_PHONG, SHD_FREQUENCY_GOURAUD, 20, 0, 0, 0.1, 0.02},
    {"model/blinn_phong/10", SHD_MODEL_BLINN_PHONG, SHD_FREQUENCY_PHONG, 10, 0, 0, 0.1, 0.02},
    {"model/blinn_phong/60", SHD_MODEL_BLINN_PHONG, SHD_FREQUENCY_PHONG, 60, 0, 0, 0.1, 0.02},
    {"model/normalized/30", SHD_MODEL_BLINN_PHONG_NORMALIZED, SHD_FREQUENCY_PHONG, 30, 0, 0, 0.1, 0.02},
    {"model/combined/30", SHD_MODEL_COMBINED, SHD_FREQUENCY_PHONG, 30, 0, 0, 0.1, 0.02},
    {"model/metal/0.4", SHD_MODEL_METALLIC_ROUGHNESS, SHD_FREQUENCY_PHONG, 0, 0.4f, 1, 0.45, 0.035},
    {"model/metal/0.7", SHD_MODEL_METALLIC_ROUGHNESS, SHD_FREQUENCY_PHONG, 0, 0.7f, 1, 0.45, 0.035},
    {"model/metal/1", SHD_MODEL_METALLIC_ROUGHNESS, SHD_FREQUENCY_PHONG, 0, 1, 1, 0.45, 0.035},
    {"model/dielectric/0.4", SHD_MODEL_METALLIC_ROUGHNESS, SHD_FREQUENCY_PHONG, 0, 0.4f, 0, 0.3, 0.02},
    {"model/dielectric/1", SHD_MODEL_METALLIC_ROUGHNESS, SHD_FREQUENCY_PHONG, 0, 1, 0, 0.05, 0.01},
    {"model/gooch", SHD_MODEL_GOOCH, SHD_FREQUENCY_PHONG, 0, 0, 0, 1, 1},
};

static shd_material *make_material(const struct model_case *row)
{
    shd_material_desc desc = shd_material_desc_default();
    shd_material *material = NULL;
    desc.model = row->model;
    desc.exponent = row->exponent;
    desc.roughness = row->roughness;
    desc.metallic = row->metallic;
    desc.diffuse[0] = 0.9f, desc.diffuse[1] = 0.6f, desc.diffuse[2] = 0.3f;
    shd_assert_ok(shd_material_create(g_context, &desc, &material));
    return material;
}

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

static double dot3(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/** Snell's law: the direction of a ray `in` after a surface with the normal n towards it; eta = ratio of indices. */
static void refract(const double *in, const double *n, double eta, double *out)
{
    const double cosine = -dot3(in, n);
    const double inside = sqrt(1.0 - eta * eta * (1.0 - cosine * cosine));
    for (int c = 0; c < 3; ++c) out[c] = eta * in[c] + (eta * cosine - inside) * n[c];
}

/** A glass sphere refracts as two refractions of each ray at the sphere, and reflects as Schlick's formula. */
static void test_glass(void **state)
{
    static struct picture got;
    static float through[3][EDGE * EDGE], mirrored[3][EDGE * EDGE], color[2][3][EDGE * EDGE], fresnel[EDGE * EDGE];
    static int hit[EDGE * EDGE];
    shd_material_desc desc = shd_material_desc_default();
    shd_material *material = NULL;
    struct scene scene;
    int checked = 0;
    (void)state;
    desc.model = SHD_MODEL_GLASS;
    desc.roughness = 0.0f;
    desc.ior = 1.4f;
    desc.diffuse[0] = 0.5f, desc.diffuse[1] = desc.diffuse[2] = 1.0f;
    shd_assert_ok(shd_material_create(g_context, &desc, &material));
    open_scene(&scene, material);
    render(&scene, &got);
    for (size_t i = 0; i < EDGE * EDGE; ++i) {
        const double x = tan(0.4) * (2.0 * ((double)(i % EDGE) + 0.5) / EDGE - 1.0);
        const double y = tan(0.4) * (1.0 - 2.0 * ((double)(i / EDGE) + 0.5) / EDGE);
        const double length = sqrt(1.0 + x * x + y * y), in[3] = {x / length, y / length, -1.0 / length};
        const double eye[3] = {0.0, 0.0, 3.0}, b = dot3(in, eye), root = b * b - 8.0;
        double n[3], t[3], exit[3], out[3], cosine, f0 = 0.4 / 2.4;
        hit[i] = root > 0.3; /* not at the silhouette, where the mesh differs from the sphere */
        if (!hit[i]) continue;
        for (int c = 0; c < 3; ++c) n[c] = eye[c] - (b + sqrt(root)) * in[c];
        refract(in, n, 1.0 / 1.4, t);
        for (int c = 0; c < 3; ++c) exit[c] = -(n[c] - 2.0 * dot3(n, t) * t[c]);
        refract(t, exit, 1.4, out);
        cosine = -dot3(in, n);
        f0 *= f0;
        fresnel[i] = (float)(f0 + (1.0 - f0) * pow(1.0 - cosine, 5.0));
        for (int c = 0; c < 3; ++c) {
            through[c][i] = (float)out[c];
            mirrored[c][i] = (float)(in[c] + 2.0 * cosine * n[c]);
        }
    }
    for (int k = 0; k < 2; ++k) {
        shd_environment_lookups lookups = shd_environment_lookups_default();
        shd_environment_light light = shd_environment_light_default();
        lookups.count = EDGE * EDGE;
        for (int c = 0; c < 3; ++c) {
            lookups.direction[c] = shd_f32_column(k ? mirrored[c] : through[c], 0);
            light.rgb[c] = shd_f32_out_column(color[k][c], 0);
        }
        shd_assert_ok(shd_environment_radiance(g_environment, &lookups, &light));
    }
    for (size_t i = 0; i < EDGE * EDGE; ++i) {
        if (!hit[i]) continue;
        for (int c = 0; c < 3; ++c) {
            const double f = (double)fresnel[i], tint = c ? 1.0 : 0.5;
            const double want = tint * (1.0 - f) * (double)color[0][c][i] + f * (double)color[1][c][i];
            shd_assert_close("glass", 3 * i + (size_t)c, (double)got.plane[c][i], want, 0.03, 0.06);
        }
        ++checked;
    }
    assert_true(checked > 600);
    close_scene(&scene);
    shd_material_release(material);
}

/** A coat takes c F of the light, and reflects it as a mirror-white metal of its roughness; with and without lights. */
struct coat_case {
    const char *name;
    int lit, mapped;
};
static const struct coat_case k_coats[] = {
    {"coat/lights", 1, 0}, {"coat/environment", 0, 0}, {"coat/lights/mapped", 1, 1}, {"coat/environment/mapped", 0, 1}};

static void test_coat(void **state)
{
    const struct coat_case *row = (const struct coat_case *)*state;
    static struct picture base, layer, coated;
    static const unsigned char tilted[4] = {190, 100, 220, 255}, straight[4] = {128, 128, 255, 255};
    shd_texture *texture[2];
    shd_slot slots[2];
    shd_material *material[3];
    struct scene scene;
    int checked = 0;
    for (int k = 0; k < 2; ++k) {
        shd_texture_desc desc = shd_texture_desc_default();
        desc.format = SHD_FORMAT_RGBA8;
        desc.width = desc.height = 1;
        desc.texels = k ? tilted : straight;
        shd_assert_ok(shd_texture_create(g_context, &desc, &texture[k]));
    }
    for (int k = 0; k < 3; ++k) { /* the base, the coat as a metal with its normal, both */
        shd_material_desc desc = shd_material_desc_default();
        desc.model = SHD_MODEL_METALLIC_ROUGHNESS;
        desc.roughness = k == 1 ? 0.45f : 0.8f;
        desc.metallic = k == 1 ? 1.0f : 0.0f;
        desc.diffuse[0] = desc.diffuse[1] = desc.diffuse[2] = k == 1 ? 1.0f : 0.4f;
        desc.clearcoat = k == 2 ? 0.75f : 0.0f;
        desc.clearcoat_roughness = 0.45f;
        slots[0] = shd_slot_texture(SHD_SLOT_NORMAL, texture[row->mapped && k == 1], NULL);
        slots[1] = shd_slot_texture(SHD_SLOT_CLEARCOAT_NORMAL, texture[1], NULL);
        desc.slots = slots;
        desc.slot_count = row->mapped ? (k == 2 ? 2 : 1) : 0;
        shd_assert_ok(shd_material_create(g_context, &desc, &material[k]));
    }
    open_scene(&scene, NULL);
    scene.desc.draw_count = 1;
    if (row->lit) {
        scene.desc.environment = NULL;
        scene.desc.lights = (const shd_light *const *)g_lights;
        scene.desc.light_count = LIGHTS;
    }
    for (int k = 0; k < 3; ++k) {
        scene.draw.material = material[k];
        render(&scene, k == 0 ? &base : k == 1 ? &layer : &coated);
    }
    for (size_t i = 0; i < EDGE * EDGE; ++i) {
        /* Two channels give c F; the third one must have the same. */
        const double b = (double)base.plane[0][i], l = (double)layer.plane[0][i], d = l - b;
        double part;
        if (base.plane[3][i] == 0.0f || fabs(d) < 0.02) continue;
        part = ((double)coated.plane[0][i] - b) / d;
        if (!row->mapped) assert_true(part > 0.02 && part < 0.76);
        for (int c = 1; c < 3; ++c) {
            const double want = (double)base.plane[c][i] * (1.0 - part) + (double)layer.plane[c][i] * part;
            shd_assert_close(row->name, i, (double)coated.plane[c][i], want, 2e-3, 2e-3);
        }
        if (i == EDGE / 2 * EDGE + EDGE / 2 && !row->mapped) shd_assert_close("F0", i, part, 0.03, 2e-3, 0.0);
        ++checked;
    }
    assert_true(checked > 300);
    close_scene(&scene);
    for (int k = 0; k < 3; ++k) shd_material_release(material[k]);
    for (int k = 0; k < 2; ++k) shd_texture_release(texture[k]);
}

/** An environment of fine noise. */
static shd_environment *make_noise(void)
{
    enum { NOISE_WIDTH = 256, NOISE_HEIGHT = 128 };
    static float texels[3 * NOISE_WIDTH * NOISE_HEIGHT];
    shd_image image = shd_image_default();
    shd_environment_desc desc = shd_environment_desc_default();
    shd_environment *noise = NULL;
    uint32_t seed = 5;
    for (size_t i = 0; i < sizeof texels / sizeof texels[0]; ++i) texels[i] = (float)(shd_noise(&seed) >> 31);
    image.format = SHD_FORMAT_RGB32F;
    image.width = NOISE_WIDTH, image.height = NOISE_HEIGHT;
    image.pixels = texels;
    desc.image = &image;
    shd_assert_ok(shd_environment_create(g_context, &desc, &noise));
    return noise;
}

/** Reflections of fine noise in a mirror sphere are near the average over each pixel. */
static void test_mirror(void **state)
{
    static const struct model_case k_row = {"", SHD_MODEL_METALLIC_ROUGHNESS, SHD_FREQUENCY_PHONG, 0, 0, 1, 0, 0};
    static struct picture got, want;
    shd_environment *noise = make_noise();
    shd_material *material = make_material(&k_row);
    struct scene scene;
    (void)state;
    open_scene(&scene, material);
    scene.desc.environment = noise;
    render(&scene, &got);
    scene.desc.supersampling = 8;
    render(&scene, &want);
    compare("mirror", &got, &want, 0.6, 0.1);
    close_scene(&scene);
    shd_environment_release(noise);
    shd_material_release(material);
}

/** A narrow lobe is widened by its pixel, whether its exponent is that of the material or of a slot. */
static void test_exponent_slot(void **state)
{
    static const float k_exponent = 1e5f;
    static struct picture picture[2];
    shd_environment *noise = make_noise();
    shd_material_desc desc = shd_material_desc_default();
    shd_texture_desc texture_desc = shd_texture_desc_default();
    shd_slot slot = shd_slot_default(SHD_SLOT_EXPONENT);
    (void)state;
    texture_desc.format = SHD_FORMAT_R32F;
    texture_desc.width = texture_desc.height = 1;
    texture_desc.texels = &k_exponent;
    slot.source = SHD_SLOT_SOURCE_TEXTURE;
    shd_assert_ok(shd_texture_create(g_context, &texture_desc, &slot.texture));
    shd_assert_ok(shd_sampler_create(g_context, NULL, &slot.sampler));
    desc.model = SHD_MODEL_PHONG;
    desc.slots = &slot;
    for (int k = 0; k < 2; ++k) {
        shd_material *material = NULL;
        struct scene scene;
        desc.slot_count = (uint32_t)k;
        desc.exponent = k ? 1.0f : k_exponent;
        shd_assert_ok(shd_material_create(g_context, &desc, &material));
        open_scene(&scene, material);
        scene.desc.environment = noise;
        render(&scene, &picture[k]);
        close_scene(&scene);
        shd_material_release(material);
    }
    compare("slot", &picture[1], &picture[0], 1e-6, 1e-7);
    shd_texture_release(slot.texture);
    shd_sampler_release(slot.sampler);
    shd_environment_release(noise);
}

struct background_case {
    const char *name;
    float roughness;
    int orthographic;
};
static const struct background_case k_backgrounds[] = {
    {"background/sharp", 0.0f, 0},
    {"background/blurred", 0.5f, 0},
    {"background/orthographic", 0.3f, 1},
};

/** Pixels have the radiance of the line of sight through their centre. */
static void test_background(void **state)
{
    const struct background_case *row = (const struct background_case *)*state;
    static struct picture got;
    static float direction[3][EDGE * EDGE], roughness[EDGE * EDGE], want[3][EDGE * EDGE];
    shd_environment_lookups lookups = shd_environment_lookups_default();
    shd_environment_light light = shd_environment_light_default();
    struct scene scene;
    open_scene(&scene, NULL);
    scene.desc.background = SHD_BACKGROUND_ENVIRONMENT;
    scene.desc.background_roughness = row->roughness;
    scene.desc.environment_intensity = 3.0f;
    scene.camera.eye[0] = 1.0f, scene.camera.eye[1] = 2.0f, scene.camera.eye[2] = 2.0f;
    if (row->orthographic) {
        shd_assert_ok(shd_view_from_camera(&scene.camera, &scene.desc.view));
        scene.desc.camera = NULL;
        memset(scene.desc.view.view_to_clip, 0, sizeof scene.desc.view.view_to_clip);
        scene.desc.view.view_to_clip[0] = scene.desc.view.view_to_clip[5] = 0.5f;
        scene.desc.view.view_to_clip[10] = -0.01f;
        scene.desc.view.view_to_clip[15] = 1.0f;
    }
    render(&scene, &got);
    for (size_t i = 0; i < EDGE * EDGE; ++i) {
        /* right = (0.894, 0, -0.447), up = (-0.298, 0.745, -0.596), forward = (-1, -2, -2) / 3 */
        const double scale = row->orthographic ? 0.0 : tan(0.4);
        const double x = scale * (2.0 * ((double)(i % EDGE) + 0.5) / EDGE - 1.0);
        const double y = scale * (1.0 - 2.0 * ((double)(i / EDGE) + 0.5) / EDGE);
        const double root = sqrt(5.0), up = 3.0 * root;
        direction[0][i] = (float)(-1.0 / 3.0 + x * 2.0 / root + y * -2.0 / up);
        direction[1][i] = (float)(-2.0 / 3.0 + y * 5.0 / up);
        direction[2][i] = (float)(-2.0 / 3.0 + x * -1.0 / root + y * -4.0 / up);
        roughness[i] = row->roughness;
    }
    lookups.count = EDGE * EDGE;
    for (int c = 0; c < 3; ++c) {
        lookups.direction[c] = shd_f32_column(direction[c], 0);
        light.rgb[c] = shd_f32_out_column(want[c], 0);
    }
    if (row->roughness > 0.0f) lookups.roughness = shd_f32_column(roughness, 0);
    shd_assert_ok(shd_environment_radiance(g_environment, &lookups, &light));
    for (size_t i = 0; i < EDGE * EDGE; ++i) {
        for (int c = 0; c < 3; ++c) {
            shd_assert_close(row->name, i, (double)got.plane[c][i], 3.0 * (double)want[c][i], 1e-4, 1e-3);
        }
        assert_true(got.plane[3][i] == 1.0f);
    }
    close_scene(&scene);
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
    assert_int_equal(stats.nonfinite_fragments, 0);
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

static int open_context(void **state)
{
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &g_context));
    make_lights();
    return 0;
}
static int close_context(void **state)
{
    (void)state;
    for (size_t i = 0; i < LIGHTS; ++i) shd_light_release(g_lights[i]);
    shd_environment_release(g_environment);
    shd_context_release(g_context);
    return 0;
}

int main(void)
{
    ADD_ROWS(k_models, test_model);
    ADD_ROWS(k_backgrounds, test_background);
    ADD_ROWS(k_coats, test_coat);
    ADD_ROWS(k_refusals, test_desc);
    add("glass", test_glass, NULL);
    add("mirror", test_mirror, NULL);
    add("exponent_slot", test_exponent_slot, NULL);
    add("combination", test_combination, NULL);
    add("rotation", test_rotation, NULL);
    add("same_bits", test_same_bits, NULL);
    add("tables", test_tables, NULL);
    return _cmocka_run_group_tests("render_environment", g_tests, g_count, open_context, close_context);
}
