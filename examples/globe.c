/* SPDX-License-Identifier: MIT */
/* A globe by one fragment program that looks up two textures: day on the side of the sun, with relief and a glint on
   the sea, lights of cities at night, and a blue rim of air. `globe DAY NIGHT` takes maps of latitude and longitude
   from files; without them the continents are made up. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <shd/shd.h>
#ifdef EXAMPLE_HAS_IO
#include <shd/io.h>
#endif

enum { SIZE = 640, MAP_WIDTH = 256, MAP_HEIGHT = 128, ROWS = 256, LOOKUPS = 4 };

static const float k_sun[3] = {-0.66f, 0.22f, 0.7183f}; /* unit, towards the sun */

struct globe {
    shd_context *context;
    shd_texture *day, *night;
    shd_sampler *sampler;
    shd_material *material;
    shd_mesh *mesh;
    shd_framebuffer *framebuffer;
};

static float dot(const float *a, const float *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
static float clamp(float t)
{
    return fminf(fmaxf(t, 0.0f), 1.0f);
}
static float smooth(float low, float high, float x)
{
    const float t = clamp((x - low) / (high - low));
    return t * t * (3.0f - 2.0f * t);
}

/* ---- the fragment program ---- */

/* Colours of the maps at a block of fragments: the day here, one texel to the east, one to the south, and the night. */
struct block {
    float rgb[LOOKUPS][3][ROWS];
};

/* Linear light of `texture` at rows [first, first + count), shifted by (du, dv). */
static int look_up(const shd_texture *texture, const shd_sampler *sampler, const shd_fragments *in, size_t first,
                   size_t count, float du, float dv, float (*rgb)[ROWS])
{
    float u[ROWS], v[ROWS];
    shd_lookups lookups = shd_lookups_default();
    shd_texels texels = shd_texels_default();
    size_t i;
    for (i = 0; i < count; ++i) u[i] = in->u[first + i] + du, v[i] = in->v[first + i] + dv;
    lookups.count = count;
    lookups.u.data = u, lookups.v.data = v;
    lookups.dudx.data = in->dudx + first, lookups.dvdx.data = in->dvdx + first;
    lookups.dudy.data = in->dudy + first, lookups.dvdy.data = in->dvdy + first;
    for (i = 0; i < 3; ++i) texels.channel[i].data = rgb[i];
    return shd_texture_sample(texture, sampler, &lookups, &texels) == SHD_OK;
}

/* 1 on land, 0 where blue prevails: the sea. */
static float land(const struct block *b, int which, size_t i)
{
    const float red = b->rgb[which][0][i], blue = b->rgb[which][2][i];
    return smooth(-0.02f, 0.02f, red - 0.75f * blue);
}

/* The height of the ground, guessed from its brightness. */
static float height(const struct block *b, int which, size_t i)
{
    return land(b, which, i) * (b->rgb[which][0][i] + b->rgb[which][1][i]);
}

/* The normal, tilted by the heights of the texels to the east and to the south. */
static void relief(const shd_fragments *in, const struct block *b, size_t first, size_t i, float *n)
{
    const size_t row = first + i;
    const float t[3] = {in->tx[row], in->ty[row], in->tz[row]};
    const float here = height(b, 0, i);
    const float east = 0.8f * (height(b, 1, i) - here), south = 0.8f * (height(b, 2, i) - here);
    float length;
    int c;
    n[0] = in->nx[row], n[1] = in->ny[row], n[2] = in->nz[row];
    {
        const float up[3] = {n[1] * t[2] - n[2] * t[1], n[2] * t[0] - n[0] * t[2], n[0] * t[1] - n[1] * t[0]};
        for (c = 0; c < 3; ++c) n[c] += south * in->tw[row] * up[c] - east * t[c];
    }
    length = sqrtf(dot(n, n));
    for (c = 0; c < 3; ++c) n[c] /= length;
}

static void shade(const shd_fragments *in, const struct block *b, size_t first, size_t i, float *rgb)
{
    static const float k_air[3] = {0.25f, 0.5f, 1.0f};
    const size_t row = first + i;
    const float smooth_n[3] = {in->nx[row], in->ny[row], in->nz[row]};
    const float o[3] = {in->ox[row], in->oy[row], in->oz[row]};
    float n[3], h[3], sun, level, glint, rim, dark;
    int c;
    relief(in, b, first, i, n);
    for (c = 0; c < 3; ++c) h[c] = o[c] + k_sun[c];
    level = dot(smooth_n, k_sun); /* sine of the altitude of the sun */
    sun = fmaxf(dot(n, k_sun), 0.0f) * smooth(-0.05f, 0.15f, level);
    glint = (1.0f - land(b, 0, i)) * 1.5f * powf(fmaxf(dot(smooth_n, h), 0.0f) / sqrtf(dot(h, h)), 60.0f);
    rim = powf(1.0f - clamp(dot(smooth_n, o)), 4.0f) * smooth(-0.3f, 0.4f, level);
    dark = smooth(0.1f, -0.15f, level);
    for (c = 0; c < 3; ++c) {
        rgb[c] = sun * (2.0f * b->rgb[0][c][i] + glint) + 2.0f * dark * b->rgb[3][c][i] + 0.9f * rim * k_air[c];
    }
}

/* Shades blocks of 256 fragments, so that their colours stay in cache. */
static void globe_program(const shd_fragments *in, shd_radiance *out, void *user_data)
{
    const struct globe *globe = (const struct globe *)user_data;
    const float east = 1.0f / 1024, south = 1.0f / 512;
    struct block b;
    size_t first, i;
    for (first = 0; first < in->count; first += ROWS) {
        const size_t count = in->count - first < ROWS ? in->count - first : ROWS;
        if (!look_up(globe->day, globe->sampler, in, first, count, 0, 0, b.rgb[0]) ||
            !look_up(globe->day, globe->sampler, in, first, count, east, 0, b.rgb[1]) ||
            !look_up(globe->day, globe->sampler, in, first, count, 0, south, b.rgb[2]) ||
            !look_up(globe->night, globe->sampler, in, first, count, 0, 0, b.rgb[3])) {
            return; /* black */
        }
        for (i = 0; i < count; ++i) {
            float rgb[3];
            shade(in, &b, first, i, rgb);
            out->r[first + i] = rgb[0], out->g[first + i] = rgb[1], out->b[first + i] = rgb[2];
        }
    }
}

/* ---- maps ---- */

/* Land where a sum of waves is high, with towns where two faster waves meet. */
static void paint(unsigned char *day, unsigned char *night)
{
    static const unsigned char k_sea[4] = {10, 40, 110, 255}, k_land[4] = {110, 120, 60, 255};
    int x, y, c;
    for (y = 0; y < MAP_HEIGHT; ++y) {
        for (x = 0; x < MAP_WIDTH; ++x) {
            const float s = 6.2831853f * (float)x / MAP_WIDTH, t = 3.1415927f * (float)y / MAP_HEIGHT;
            const float ground = sinf(2 * s + sinf(3 * t)) + sinf(3 * s - 4 * t) * cosf(2 * t) - 0.3f * cosf(5 * s);
            const int town = ground > 0.3f && sinf(37 * s) * sinf(41 * t) > 0.9f;
            for (c = 0; c < 4; ++c) {
                day[4 * (y * MAP_WIDTH + x) + c] = ground > 0.3f ? k_land[c] : k_sea[c];
                night[4 * (y * MAP_WIDTH + x) + c] = (unsigned char)(town ? 255 - 60 * c : 0);
            }
        }
    }
}

static shd_result paint_maps(struct globe *g)
{
    unsigned char *day = (unsigned char *)malloc(4 * MAP_WIDTH * MAP_HEIGHT);
    unsigned char *night = (unsigned char *)malloc(4 * MAP_WIDTH * MAP_HEIGHT);
    shd_texture_desc td = shd_texture_desc_default();
    shd_result result = SHD_ERROR_OUT_OF_MEMORY;
    td.width = MAP_WIDTH, td.height = MAP_HEIGHT;
    td.format = SHD_FORMAT_RGBA8_SRGB;
    td.tables = SHD_TABLE_MIPMAP;
    if (day && night) {
        paint(day, night);
        td.texels = day;
        result = shd_texture_create(g->context, &td, &g->day);
        td.texels = night;
        if (result == SHD_OK) result = shd_texture_create(g->context, &td, &g->night);
    }
    free(day), free(night);
    return result;
}

static shd_result load_maps(struct globe *g, const char *day, const char *night)
{
#ifdef EXAMPLE_HAS_IO
    const shd_result result = shd_texture_load(g->context, day, NULL, &g->day);
    return result == SHD_OK ? shd_texture_load(g->context, night, NULL, &g->night) : result;
#else
    fprintf(stderr, "globe: built without libshd_io: %s and %s are not read\n", day, night);
    return paint_maps(g);
#endif
}

/* ---- the frame ---- */

static shd_result make(struct globe *g, int argc, char **argv)
{
    shd_sampler_desc sd = shd_sampler_desc_default();
    shd_material_desc md = shd_material_desc_default();
    shd_framebuffer_desc fd = shd_framebuffer_desc_default();
    shd_shape_desc sphere = shd_shape_desc_default();
    shd_result result = shd_context_create(NULL, &g->context);
    if (result == SHD_OK) result = argc == 3 ? load_maps(g, argv[1], argv[2]) : paint_maps(g);
    sd.filter = SHD_FILTER_ANISOTROPIC;
    sd.wrap_v = SHD_WRAP_CLAMP;
    if (result == SHD_OK) result = shd_sampler_create(g->context, &sd, &g->sampler);
    md.model = SHD_MODEL_PROGRAM;
    md.program.fragment = globe_program;
    md.program.user_data = g;
    if (result == SHD_OK) result = shd_material_create(g->context, &md, &g->material);
    sphere.segments[0] = 128, sphere.segments[1] = 64;
    if (result == SHD_OK) result = shd_mesh_create_shape(g->context, &sphere, SHD_MESH_NONE, &g->mesh);
    fd.width = fd.height = SIZE;
    fd.sample_count = 4;
    return result == SHD_OK ? shd_framebuffer_create(g->context, &fd, &g->framebuffer) : result;
}

static shd_result render(struct globe *g)
{
    shd_draw draw = shd_draw_default();
    shd_render_desc rd = shd_render_desc_default();
    shd_camera camera = shd_camera_default();
    camera.eye[0] = 2.2f, camera.eye[1] = 1.5f, camera.eye[2] = 3.15f; /* over Arabia, in the evening */
    camera.fov_y = 0.54f;
    draw.mesh = g->mesh, draw.material = g->material;
    rd.framebuffer = g->framebuffer;
    rd.camera = &camera;
    rd.clear_color[3] = 1.0f;
    rd.draws = &draw, rd.draw_count = 1;
    return shd_render(g->context, &rd);
}

/* The globe covers the middle; the corners are empty space. */
static int check(const shd_framebuffer *framebuffer)
{
    shd_plane_view blue = shd_plane_view_default();
    size_t row;
    if (shd_framebuffer_view_plane(framebuffer, SHD_PLANE_B, &blue) != SHD_OK) return 0;
    row = blue.row_stride / sizeof(float);
    return blue.f32[SIZE / 2 * row + SIZE / 2] > 0.0f && blue.f32[0] == 0.0f;
}

int main(int argc, char **argv)
{
    struct globe g = {NULL};
    int good = make(&g, argc, argv) == SHD_OK && render(&g) == SHD_OK && check(g.framebuffer);
#ifdef EXAMPLE_HAS_IO
    good = good && shd_framebuffer_save(g.framebuffer, "globe.png", NULL) == SHD_OK && puts("globe.png written") >= 0;
#endif
    if (!good) fprintf(stderr, "globe: wrong picture or error: %s\n", shd_last_error());
    shd_framebuffer_release(g.framebuffer);
    shd_mesh_release(g.mesh);
    shd_material_release(g.material);
    shd_sampler_release(g.sampler);
    shd_texture_release(g.night), shd_texture_release(g.day);
    shd_context_release(g.context);
    return good ? 0 : 1;
}
