/* SPDX-License-Identifier: MIT */
/* Sharp images of an environment: glass, clear coats, mirrors, narrow lobes, and the background. */
#include "support/sky.h"

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
        shd_environment_values light = shd_environment_values_default();
        lookups.count = EDGE * EDGE;
        for (int c = 0; c < 3; ++c) {
            lookups.direction[c] = shd_f32_column(k ? mirrored[c] : through[c], 0);
            light.channel[c] = shd_f32_out_column(color[k][c], 0);
        }
        shd_assert_ok(shd_environment_sample_radiance(g_environment, &lookups, &light));
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
    shd_slot slot = shd_slot_vertex(SHD_SLOT_EXPONENT, 0);
    slot.source = SHD_SLOT_SOURCE_CONSTANT;
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
    shd_environment_values light = shd_environment_values_default();
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
        light.channel[c] = shd_f32_out_column(want[c], 0);
    }
    if (row->roughness > 0.0f) lookups.roughness = shd_f32_column(roughness, 0);
    shd_assert_ok(shd_environment_sample_radiance(g_environment, &lookups, &light));
    for (size_t i = 0; i < EDGE * EDGE; ++i) {
        for (int c = 0; c < 3; ++c) {
            shd_assert_close(row->name, i, (double)got.plane[c][i], 3.0 * (double)want[c][i], 1e-4, 1e-3);
        }
        assert_true(got.plane[3][i] == 1.0f);
    }
    close_scene(&scene);
}

int main(void)
{
    ADD_ROWS(k_backgrounds, test_background);
    ADD_ROWS(k_coats, test_coat);
    add("glass", test_glass, NULL);
    add("mirror", test_mirror, NULL);
    add("exponent_slot", test_exponent_slot, NULL);
    return _cmocka_run_group_tests("render_reflection", g_tests, g_count, open_context, close_context);
}
