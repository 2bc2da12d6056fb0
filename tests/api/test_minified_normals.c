/* SPDX-License-Identifier: MIT */
/* Minified normal maps whose levels keep their roughness, against 64 shaded samples a pixel: pictures of a sphere with
 * creases of slopes up to 1, several creases a pixel, and the highlight of grooves on a plane. Most of the error that
 * is left comes from slopes that are not Gaussian within a pixel and from the footprint of EWA, which is wider than a
 * pixel unless its lod_bias is negative ("sharp"). */
#include "support/check.h"

#include <shd/shd.h>

enum { MAP = 256, SIDE = 96, LEVELS = 8 };

static float g_normals[MAP * MAP * 4], g_moments[MAP * MAP * 4], g_mixed[MAP * MAP];
static float g_levels[LEVELS][MAP * MAP];
static float g_truth[SIDE * SIDE * 4], g_picture[SIDE * SIDE * 4];

/* Encodings of the normal map. */
enum keep { KEEP_NONE, KEEP_TOKSVIG, KEEP_LEAN, KEEP_COUNT };

struct world {
    shd_context *context;
    shd_framebuffer *framebuffer;
    shd_texture *normals, *moments, *mixed;
    shd_mesh *mesh;
    shd_sampler *sampler;
};

static shd_image make_image(shd_format format, uint32_t side, void *pixels)
{
    shd_image image = shd_image_default();
    image.format = format;
    image.width = image.height = side;
    image.pixels = pixels;
    return image;
}

/* Creases along v, which bend by `bend`: slopes are sums of waves in u. */
static void fill_normals(double bend)
{
    const double turn = 6.283185307179586;
    int x, y;
    for (y = 0; y < MAP; ++y) {
        for (x = 0; x < MAP; ++x) {
            const double u = (x + 0.5) / MAP, v = (y + 0.5) / MAP;
            const double wave = u + bend * 0.02 * sin(turn * 3 * v);
            const double along = bend * 0.02 * 3 * turn * cos(turn * 3 * v);
            const double slope = 0.35 * sin(turn * 7 * wave) + 0.35 * sin(turn * 11 * wave + 1) +
                                 0.35 * sin(turn * 17 * wave + 2) + 0.35 * sin(turn * 23 * wave + 4) +
                                 0.25 * sin(turn * 31 * wave + 5);
            const double slope_v = slope * along * (bend > 0);
            const double length = sqrt(1 + slope * slope + slope_v * slope_v);
            float *n = g_normals + 4 * (y * MAP + x);
            n[0] = (float)(slope / length);
            n[1] = (float)(-slope_v / length);
            n[2] = (float)(1 / length);
            n[3] = 1;
        }
    }
}

static shd_texture *make_normals(struct world *w)
{
    shd_image levels[LEVELS];
    const shd_image base = make_image(SHD_FORMAT_RGBA32F, MAP, g_normals);
    shd_mip_desc mip = shd_mip_desc_default();
    shd_texture_desc desc = shd_texture_desc_default();
    shd_texture *texture = NULL;
    int l;
    for (l = 0; l < LEVELS; ++l) levels[l] = make_image(SHD_FORMAT_RGBA32F, MAP >> (l + 1), g_levels[l]);
    mip.content = SHD_TEXEL_CONTENT_NORMAL;
    shd_assert_ok(shd_mip_build(w->context, &base, &mip, LEVELS, levels));
    desc.format = SHD_FORMAT_RGBA32F;
    desc.width = desc.height = MAP;
    desc.texels = g_normals;
    desc.tables = SHD_TABLE_MIPMAP;
    desc.level_images = levels;
    desc.level_count = LEVELS;
    shd_assert_ok(shd_texture_create(w->context, &desc, &texture));
    return texture;
}

static shd_texture *make_data(struct world *w, shd_format format, const float *texels)
{
    shd_texture_desc desc = shd_texture_desc_default();
    shd_texture *texture = NULL;
    desc.format = format;
    desc.width = desc.height = MAP;
    desc.texels = texels;
    desc.tables = SHD_TABLE_MIPMAP;
    shd_assert_ok(shd_texture_create(w->context, &desc, &texture));
    return texture;
}

static void set_up(struct world *w, shd_shape shape, double bend, float lod_bias)
{
    const shd_image normals = make_image(SHD_FORMAT_RGBA32F, MAP, g_normals);
    const shd_image moments = make_image(SHD_FORMAT_RGBA32F, MAP, g_moments);
    const shd_image mixed = make_image(SHD_FORMAT_R32F, MAP, g_mixed);
    shd_framebuffer_desc framebuffer = shd_framebuffer_desc_default();
    shd_shape_desc form = shd_shape_desc_default();
    shd_sampler_desc sampler = shd_sampler_desc_default();
    memset(w, 0, sizeof *w);
    shd_assert_ok(shd_context_create(NULL, &w->context));
    fill_normals(bend);
    shd_assert_ok(shd_mip_build_moments(w->context, &normals, &moments, &mixed));
    w->normals = make_normals(w);
    w->moments = make_data(w, SHD_FORMAT_RGBA32F, g_moments);
    w->mixed = make_data(w, SHD_FORMAT_R32F, g_mixed);
    framebuffer.width = framebuffer.height = SIDE;
    shd_assert_ok(shd_framebuffer_create(w->context, &framebuffer, &w->framebuffer));
    form.kind = shape;
    form.segments[0] = form.segments[1] = shape == SHD_SHAPE_SPHERE ? 96 : 1;
    shd_assert_ok(shd_mesh_create_shape(w->context, &form, SHD_MESH_TANGENTS, &w->mesh));
    sampler.filter = SHD_FILTER_EWA;
    sampler.lod_bias = lod_bias;
    sampler.wrap_u = sampler.wrap_v = SHD_WRAP_REPEAT;
    shd_assert_ok(shd_sampler_create(w->context, &sampler, &w->sampler));
}

static void tear_down(struct world *w)
{
    shd_sampler_release(w->sampler);
    shd_mesh_release(w->mesh);
    shd_texture_release(w->mixed);
    shd_texture_release(w->moments);
    shd_texture_release(w->normals);
    shd_framebuffer_release(w->framebuffer);
    shd_context_release(w->context);
}

static shd_material *make_material(struct world *w, shd_material_desc desc, enum keep keep, float uv_scale)
{
    static const shd_normal_encoding k_encodings[] = {SHD_NORMAL_ENCODING_XYZ, SHD_NORMAL_ENCODING_TOKSVIG,
                                                      SHD_NORMAL_ENCODING_MOMENTS};
    shd_texture *const texture = keep == KEEP_LEAN ? w->moments : w->normals;
    shd_slot slots[2];
    shd_material *material = NULL;
    int i;
    slots[0] = shd_slot_texture(SHD_SLOT_NORMAL, texture, w->sampler);
    slots[1] = shd_slot_texture(SHD_SLOT_NORMAL_MIXED, w->mixed, w->sampler);
    for (i = 0; i < 2; ++i) slots[i].uv_transform[0] = slots[i].uv_transform[4] = uv_scale;
    desc.normal_encoding = k_encodings[keep];
    desc.slots = slots;
    desc.slot_count = 2;
    shd_assert_ok(shd_material_create(w->context, &desc, &material));
    return material;
}

struct scene {
    shd_material_desc material;
    enum keep keep;
    float uv_scale;
    shd_camera camera;
    float light[3];
    uint32_t supersampling;
};

static void render(struct world *w, const struct scene *scene, float *out)
{
    shd_light_desc light = shd_light_desc_default();
    shd_render_desc desc = shd_render_desc_default();
    shd_draw draw = shd_draw_default();
    shd_image image = make_image(SHD_FORMAT_RGBA32F, SIDE, out);
    shd_light *sun = NULL;
    const shd_light *lights[1];
    shd_material *const material = make_material(w, scene->material, scene->keep, scene->uv_scale);
    int c;
    light.kind = SHD_LIGHT_KIND_DIRECTIONAL;
    for (c = 0; c < 3; ++c) {
        light.direction[c] = -scene->light[c];
        light.intensity[c] = 1.7f;
    }
    shd_assert_ok(shd_light_create(w->context, &light, &sun));
    lights[0] = sun;
    draw.mesh = w->mesh;
    draw.material = material;
    draw.frequency = SHD_FREQUENCY_PHONG;
    desc.framebuffer = w->framebuffer;
    desc.camera = &scene->camera;
    desc.draws = &draw;
    desc.draw_count = 1;
    desc.lights = lights;
    desc.light_count = 1;
    desc.supersampling = scene->supersampling;
    shd_assert_ok(shd_render(w->context, &desc));
    shd_assert_ok(shd_framebuffer_read_color(w->framebuffer, &image));
    shd_light_release(sun);
    shd_material_release(material);
}

/* RMS of linear red, green and blue over the pixels that the surface covers. */
static double rms_of_pictures(void)
{
    double sum = 0;
    int i, c, count = 0;
    for (i = 0; i < SIDE * SIDE; ++i) {
        if (g_truth[4 * i + 3] < 1 || g_picture[4 * i + 3] < 1) continue;
        for (c = 0; c < 3; ++c) {
            const double off = (double)(g_picture[4 * i + c] - g_truth[4 * i + c]);
            sum += off * off;
        }
        ++count;
    }
    assert_in_range(count, SIDE * SIDE / 3, SIDE * SIDE);
    return sqrt(sum / (3.0 * count));
}

struct sphere_case {
    const char *name;
    shd_model model;
    float roughness, metallic, lod_bias;
    double bound;
};
static const struct sphere_case k_spheres[] = {
    {"sphere/blinn_phong", SHD_MODEL_BLINN_PHONG, 0, 0, 0, 0.0238},
    {"sphere/blinn_phong/sharp", SHD_MODEL_BLINN_PHONG, 0, 0, -0.5f, 0.0222},
    {"sphere/metallic_roughness", SHD_MODEL_METALLIC_ROUGHNESS, 0.4f, 0, 0, 0.0113},
    {"sphere/metallic_roughness/sharp", SHD_MODEL_METALLIC_ROUGHNESS, 0.4f, 0, -0.5f, 0.0096},
    {"sphere/metal/0.5", SHD_MODEL_METALLIC_ROUGHNESS, 0.5f, 1, 0, 0.054},
    {"sphere/metal/0.5/sharp", SHD_MODEL_METALLIC_ROUGHNESS, 0.5f, 1, -0.5f, 0.0445},
    {"sphere/metal/0.7", SHD_MODEL_METALLIC_ROUGHNESS, 0.7f, 1, 0, 0.0168},
    {"sphere/metal/0.7/sharp", SHD_MODEL_METALLIC_ROUGHNESS, 0.7f, 1, -0.5f, 0.013},
};
enum { SPHERES = sizeof k_spheres / sizeof k_spheres[0] };

static void test_sphere(void **state)
{
    const struct sphere_case *c = (const struct sphere_case *)*state;
    struct scene scene = {shd_material_desc_default(), KEEP_NONE, 8, shd_camera_default(), {-0.5f, 0.9f, 0.9f}, 8};
    struct world w;
    double rms[KEEP_COUNT];
    int keep, k;
    scene.material.model = c->model;
    scene.material.exponent = 200;
    scene.material.roughness = c->roughness;
    for (k = 0; k < 3; ++k) {
        scene.material.specular[k] = 0.8f;
        scene.material.diffuse[k] = c->model == SHD_MODEL_BLINN_PHONG ? 0.2f : 0.6f + 0.2f * c->metallic;
    }
    scene.material.metallic = c->metallic;
    set_up(&w, SHD_SHAPE_SPHERE, 1, c->lod_bias);
    render(&w, &scene, g_truth);
    scene.supersampling = 1;
    for (keep = 0; keep < KEEP_COUNT; ++keep) {
        scene.keep = (enum keep)keep;
        render(&w, &scene, g_picture);
        rms[keep] = rms_of_pictures();
    }
    print_message("  RMS: none %.4f, Toksvig %.4f, LEAN %.4f\n", rms[0], rms[1], rms[2]);
    tear_down(&w);
    assert_true(rms[KEEP_LEAN] < c->bound);
    assert_true(rms[KEEP_LEAN] < 0.65 * rms[KEEP_TOKSVIG] && rms[KEEP_LEAN] < 0.5 * rms[KEEP_NONE]);
}

/* Deviations of a highlight along x and y, in pixels, of the light above a tenth of the peak. */
static void find_extent(double out[2])
{
    double sum = 0, mean[2] = {0, 0}, square[2] = {0, 0}, peak = 0;
    int x, y, k;
    for (k = 0; k < SIDE * SIDE; ++k) peak = fmax(peak, (double)g_picture[4 * k]);
    for (y = 0; y < SIDE; ++y) {
        for (x = 0; x < SIDE; ++x) {
            const double value = (double)g_picture[4 * (y * SIDE + x)], at[2] = {x, y};
            if (value < 0.1 * peak) continue;
            sum += value;
            for (k = 0; k < 2; ++k) {
                mean[k] += value * at[k];
                square[k] += value * at[k] * at[k];
            }
        }
    }
    for (k = 0; k < 2; ++k) out[k] = sqrt(square[k] / sum - mean[k] / sum * (mean[k] / sum));
}

/* Grooves in u only spread the highlight along u. The mean variance of Toksvig spreads it along both. */
static void test_grooves(void **state)
{
    const shd_model model = *(const shd_model *)*state;
    struct scene scene = {shd_material_desc_default(), KEEP_LEAN, 64, shd_camera_default(), {0, 1, 0}, 1};
    struct world w;
    double extent[KEEP_COUNT][2];
    int keep, c;
    scene.material.model = model;
    scene.material.exponent = 200;
    scene.material.roughness = 0.35f;
    scene.material.metallic = 1;
    scene.material.ambient_share = 0;
    for (c = 0; c < 3; ++c) {
        scene.material.diffuse[c] = model == SHD_MODEL_METALLIC_ROUGHNESS ? 1.0f : 0.0f;
        scene.material.specular[c] = 1;
        scene.camera.eye[c] = c == 1 ? 1.2f : 0.0f;
        scene.camera.up[c] = c == 2 ? -1.0f : 0.0f;
    }
    scene.camera.fov_y = 1.3f;
    set_up(&w, SHD_SHAPE_PLANE, 0, 0);
    for (keep = KEEP_TOKSVIG; keep < KEEP_COUNT; ++keep) {
        scene.keep = (enum keep)keep;
        render(&w, &scene, g_picture);
        find_extent(extent[keep]);
        print_message("  %s: %.2f x %.2f pixels\n", keep == KEEP_LEAN ? "LEAN" : "Toksvig", extent[keep][0],
                      extent[keep][1]);
    }
    tear_down(&w);
    assert_true(extent[KEEP_TOKSVIG][0] < 1.2 * extent[KEEP_TOKSVIG][1]);
    assert_true(extent[KEEP_LEAN][0] > 2 * extent[KEEP_LEAN][1]);
}

int main(void)
{
    static const shd_model k_models[] = {SHD_MODEL_BLINN_PHONG, SHD_MODEL_METALLIC_ROUGHNESS};
    struct CMUnitTest tests[SPHERES + 2];
    size_t n = 0, i;
    for (i = 0; i < SPHERES; ++i)
        tests[n++] = (struct CMUnitTest){k_spheres[i].name, test_sphere, NULL, NULL, (void *)&k_spheres[i]};
    tests[n++] = (struct CMUnitTest){"grooves/blinn_phong", test_grooves, NULL, NULL, (void *)&k_models[0]};
    tests[n++] = (struct CMUnitTest){"grooves/metallic_roughness", test_grooves, NULL, NULL, (void *)&k_models[1]};
    return _cmocka_run_group_tests("api.minified_normals", tests, n, NULL, NULL);
}
