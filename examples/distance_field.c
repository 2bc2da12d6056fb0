/* SPDX-License-Identifier: MIT */
/* A scene without meshes: a fragment program over one triangle marches rays through a distance field (Hart, "Sphere
   Tracing", 1996), with soft shadows, one reflection and marble from a solid texture. `distance_field WIDTH` draws a
   larger picture. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <shd/shd.h>
#ifdef EXAMPLE_HAS_IO
#include <shd/io.h>
#endif

enum { SMALL = 192, LARGEST = 4096, MAX_STEPS = 96 };

typedef struct {
    float x, y, z;
} vec3;

static vec3 vec(float x, float y, float z)
{
    const vec3 v = {x, y, z};
    return v;
}
static vec3 add(vec3 a, vec3 b)
{
    return vec(a.x + b.x, a.y + b.y, a.z + b.z);
}
static vec3 scale(float s, vec3 a)
{
    return vec(s * a.x, s * a.y, s * a.z);
}
static float dot(vec3 a, vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
static vec3 unit(vec3 a)
{
    return scale(1.0f / sqrtf(dot(a, a)), a);
}
static float clamp(float t, float low, float high)
{
    return fminf(fmaxf(t, low), high);
}

/* ---- the distance field ---- */

static float ball(vec3 p, vec3 centre, float radius)
{
    const vec3 d = add(p, scale(-1, centre));
    return sqrtf(dot(d, d)) - radius;
}

/* A box with half sides `half`, rounded by `round`. */
static float rounded_box(vec3 p, vec3 centre, vec3 half, float round)
{
    const float x = fabsf(p.x - centre.x) - half.x, y = fabsf(p.y - centre.y) - half.y;
    const float z = fabsf(p.z - centre.z) - half.z;
    const vec3 outside = vec(fmaxf(x, 0), fmaxf(y, 0), fmaxf(z, 0));
    return sqrtf(dot(outside, outside)) + fminf(fmaxf(x, fmaxf(y, z)), 0) - round;
}

/* A ring around the y axis. */
static float ring(vec3 p, vec3 centre, float radius, float tube)
{
    const float x = p.x - centre.x, y = p.y - centre.y, z = p.z - centre.z;
    const float across = sqrtf(x * x + z * z) - radius;
    return sqrtf(across * across + y * y) - tube;
}

/* The smaller distance, with a smooth seam of width k. */
static float blend(float a, float b, float k)
{
    const float h = fmaxf(k - fabsf(a - b), 0) / k;
    return fminf(a, b) - 0.25f * h * h * k;
}

enum { FLOOR, BALL, PEDESTAL };

static float distance(vec3 p, int *thing)
{
    const float ground = p.y;
    const float drop = blend(ball(p, vec(0, 1.35f, 0), 0.55f), ball(p, vec(0.45f, 1.9f, 0.1f), 0.3f), 0.35f);
    const float base = rounded_box(p, vec(0, 0.3f, 0), vec(0.5f, 0.25f, 0.5f), 0.08f);
    const float stand = fminf(base, ring(p, vec(0, 0.12f, 0), 1.15f, 0.12f));
    const float nearest = fminf(ground, fminf(drop, stand));
    if (thing) *thing = nearest == ground ? FLOOR : nearest == drop ? BALL : PEDESTAL;
    return nearest;
}

static vec3 normal_at(vec3 p)
{
    const float h = 1e-3f;
    return unit(vec(distance(add(p, vec(h, 0, 0)), NULL) - distance(add(p, vec(-h, 0, 0)), NULL),
                    distance(add(p, vec(0, h, 0)), NULL) - distance(add(p, vec(0, -h, 0)), NULL),
                    distance(add(p, vec(0, 0, h)), NULL) - distance(add(p, vec(0, 0, -h)), NULL)));
}

/* ---- light ---- */

/* Steps along a ray by the distance to the nearest surface. Returns the length to a hit, or a negative number. */
static float march(vec3 from, vec3 direction, int *thing)
{
    float t = 0.01f;
    int i;
    for (i = 0; i < MAX_STEPS && t < 40; ++i) {
        const float d = distance(add(from, scale(t, direction)), thing);
        if (d < 4e-4f * t) return t;
        t += d;
    }
    return -1;
}

/* The part of the sun that is visible from a point: the smallest angle between its ray and a surface. */
static float sunlight(vec3 from, vec3 to_sun)
{
    float t = 0.03f, light = 1;
    int i;
    for (i = 0; i < 48 && t < 8 && light > 0.01f; ++i) {
        const float d = distance(add(from, scale(t, to_sun)), NULL);
        light = fminf(light, 10 * d / t);
        t += clamp(d, 0.02f, 0.4f);
    }
    light = clamp(light, 0, 1);
    return light * light * (3 - 2 * light);
}

static vec3 sky(vec3 direction)
{
    const float t = clamp(direction.y, 0, 1);
    return vec(0.7f - 0.5f * t, 0.8f - 0.4f * t, 0.95f - 0.2f * t);
}

/* The marble of the pedestal, at one place. */
static vec3 marble_at(shd_context *context, vec3 p)
{
    shd_solid_desc desc = shd_solid_desc_default();
    shd_solid_points points = shd_solid_points_default();
    shd_solid_values values = shd_solid_values_default();
    float value = 0;
    desc.kind = SHD_SOLID_MARBLE;
    desc.size = 0.3f;
    desc.octaves = 5;
    desc.distortion = 3;
    points.count = 1;
    points.position[0] = shd_f32_column(&p.x, 0);
    points.position[1] = shd_f32_column(&p.y, 0);
    points.position[2] = shd_f32_column(&p.z, 0);
    values.value = shd_f32_out_column(&value, 0);
    if (shd_solid_evaluate(context, &desc, &points, &values) != SHD_OK) value = 0;
    return vec(0.25f + 0.6f * value, 0.27f + 0.58f * value, 0.3f + 0.52f * value);
}

static vec3 surface_color(shd_context *context, vec3 p, int thing)
{
    if (thing == BALL) return vec(0.75f, 0.12f, 0.05f);
    if (thing == PEDESTAL) return marble_at(context, p);
    return fmodf(fabsf(floorf(p.x) + floorf(p.z)), 2) < 1 ? vec(0.55f, 0.55f, 0.5f) : vec(0.12f, 0.13f, 0.15f);
}

static vec3 shade(shd_context *context, vec3 p, vec3 n, vec3 view, int thing)
{
    const vec3 to_sun = unit(vec(-0.6f, 0.6f, 0.4f));
    const float lambert = fmaxf(dot(n, to_sun), 0), up = 0.5f + 0.5f * n.y;
    const vec3 h = unit(add(to_sun, scale(-1, view)));
    const float sun = lambert > 0 ? sunlight(add(p, scale(2e-3f, n)), to_sun) : 0;
    const float gloss = thing == FLOOR ? 0.1f : 0.5f;
    const float lit = 0.95f * sun * lambert, shine = gloss * sun * powf(fmaxf(dot(n, h), 0), 60);
    const vec3 k = surface_color(context, p, thing);
    return vec(k.x * (lit + 0.22f * up) + shine, k.y * (lit + 0.25f * up) + shine, k.z * (lit + 0.3f * up) + shine);
}

/* Radiance along a ray, with at most `bounces` mirror reflections. */
static vec3 trace(shd_context *context, vec3 from, vec3 direction, int bounces)
{
    int thing = FLOOR;
    const float t = march(from, direction, &thing);
    vec3 p, n, color;
    float fresnel, fog;
    if (t < 0) return sky(direction);
    p = add(from, scale(t, direction));
    n = normal_at(p);
    color = shade(context, p, n, direction, thing);
    if (bounces > 0) {
        const vec3 mirrored = add(direction, scale(-2 * dot(direction, n), n));
        fresnel = (thing == BALL ? 0.1f : 0.05f) + 0.5f * powf(1 - clamp(-dot(direction, n), 0, 1), 5);
        color = add(scale(1 - fresnel, color),
                    scale(fresnel, trace(context, add(p, scale(2e-3f, n)), mirrored, bounces - 1)));
    }
    fog = 1 - expf(-0.002f * t * t);
    return add(scale(1 - fog, color), scale(fog, sky(direction)));
}

/* ---- the program: one ray for each fragment ---- */

struct picture {
    shd_context *context;
    uint32_t width, height;
};

static void march_fragments(const shd_fragments *in, shd_radiance *out, void *user_data)
{
    const struct picture *const picture = (const struct picture *)user_data;
    const vec3 eye = vec(2.1f, 1.9f, 3.9f), forward = unit(add(vec(0, 0.85f, 0), scale(-1, eye)));
    const vec3 right = unit(vec(-forward.z, 0, forward.x));
    const vec3 up = vec(right.y * forward.z - right.z * forward.y, right.z * forward.x - right.x * forward.z,
                        right.x * forward.y - right.y * forward.x);
    size_t i;
    for (i = 0; i < in->count; ++i) {
        const float x = (2 * in->x[i] - (float)picture->width) / (float)picture->height;
        const float y = 1 - 2 * in->y[i] / (float)picture->height;
        const vec3 direction = unit(add(scale(2.2f, forward), add(scale(x, right), scale(y, up))));
        const vec3 color = trace(picture->context, eye, direction, 1);
        out->r[i] = color.x, out->g[i] = color.y, out->b[i] = color.z;
    }
}

static shd_result render(shd_context *context, struct picture *picture, uint8_t *pixels)
{
    /* One triangle that covers the picture: the default view takes positions as clip coordinates. */
    static const float k_x[3] = {-1, 3, -1}, k_y[3] = {-1, -1, 3}, k_z[3] = {0.5f, 0.5f, 0.5f};
    shd_mesh_desc md = shd_mesh_desc_default();
    shd_material_desc material_desc = shd_material_desc_default();
    shd_framebuffer_desc fd = shd_framebuffer_desc_default();
    shd_draw draw = shd_draw_default();
    shd_render_desc rd = shd_render_desc_default();
    shd_image image = shd_image_default();
    shd_mesh *mesh = NULL;
    shd_material *material = NULL;
    shd_framebuffer *framebuffer = NULL;
    shd_result result;
    md.vertex_count = 3;
    md.position[0].data = k_x, md.position[1].data = k_y, md.position[2].data = k_z;
    material_desc.model = SHD_MODEL_PROGRAM;
    material_desc.program.fragment = march_fragments;
    material_desc.program.user_data = picture;
    fd.width = picture->width, fd.height = picture->height;
    fd.sample_count = picture->width > SMALL ? 4 : 1;
    result = shd_mesh_create(context, &md, &mesh);
    if (result == SHD_OK) result = shd_material_create(context, &material_desc, &material);
    if (result == SHD_OK) result = shd_framebuffer_create(context, &fd, &framebuffer);
    draw.mesh = mesh, draw.material = material;
    draw.flags = SHD_DRAW_SAMPLE_SHADING; /* one ray for each sample */
    rd.framebuffer = framebuffer;
    rd.draws = &draw, rd.draw_count = 1;
    if (result == SHD_OK) result = shd_render(context, &rd);
    image.format = SHD_FORMAT_RGBA8_SRGB;
    image.width = picture->width, image.height = picture->height;
    image.pixels = pixels;
    if (result == SHD_OK) result = shd_framebuffer_read_color(framebuffer, &image);
#ifdef EXAMPLE_HAS_IO
    if (result == SHD_OK) result = shd_image_save(&image, "distance_field.png", NULL);
#endif
    shd_framebuffer_release(framebuffer);
    shd_material_release(material);
    shd_mesh_release(mesh);
    return result;
}

/* The drop is red where the sun shines on it, and the sky above is blue. */
static int is_right(const struct picture *picture, const uint8_t *pixels)
{
    const size_t x = (size_t)picture->width * 23 / 50, y = (size_t)picture->height * 31 / 100;
    const uint8_t *const drop = pixels + 4 * (y * picture->width + x);
    const uint8_t *const top = pixels + 4 * (size_t)(picture->width / 8);
    return drop[0] > drop[2] + 40 && top[2] > top[0];
}

int main(int argc, char **argv)
{
    shd_context *context = NULL;
    struct picture picture;
    uint8_t *pixels;
    const long width = argc > 1 ? strtol(argv[1], NULL, 10) : SMALL;
    int good;
    picture.width = (uint32_t)(width < 16 ? 16 : width > LARGEST ? LARGEST : width);
    picture.height = picture.width * 5 / 8;
    pixels = (uint8_t *)calloc((size_t)picture.width * picture.height, 4);
    good = pixels && shd_context_create(NULL, &context) == SHD_OK;
    picture.context = context;
    good = good && render(context, &picture, pixels) == SHD_OK && is_right(&picture, pixels);
    if (!good) fprintf(stderr, "distance_field: wrong picture or error: %s\n", shd_last_error());
    shd_context_release(context);
    free(pixels);
    return good ? 0 : 1;
}
