/* SPDX-License-Identifier: MIT */
/* Look up a batch of texels: a row of points across a checkerboard, sharp at one end and far away at the other. */
#include <math.h>
#include <stdio.h>

#include <shd/shd.h>

enum { SIZE = 512, COUNT = 1000 };

static const struct {
    shd_filter filter;
    const char *name;
} filters[] = {
    {SHD_FILTER_TRILINEAR, "trilinear"},     {SHD_FILTER_RIPMAP, "ripmap"}, {SHD_FILTER_SUMMED_AREA, "summed-area"},
    {SHD_FILTER_ANISOTROPIC, "anisotropic"}, {SHD_FILTER_EWA, "EWA"},
};
enum { FILTERS = sizeof filters / sizeof filters[0] };

static uint8_t pixels[SIZE][SIZE][4];
static float u[COUNT], v[COUNT], dudx[COUNT], dvdy[COUNT], r[COUNT], g[COUNT], b[COUNT], a[COUNT];

/* Squares of 8 x 8 texels, white and black. */
static void draw_checkerboard(void)
{
    int x, y;
    for (y = 0; y < SIZE; ++y) {
        for (x = 0; x < SIZE; ++x) {
            uint8_t value = (x / 8 + y / 8) % 2 ? 0 : 255;
            pixels[y][x][0] = pixels[y][x][1] = pixels[y][x][2] = value;
            pixels[y][x][3] = 255;
        }
    }
}

/* Point i is the middle of a white square, seen through a pixel that covers from 1/8 to 512 texels. */
static void place_points(void)
{
    int i;
    for (i = 0; i < COUNT; ++i) {
        u[i] = (float)(i % 32 * 16 + 4) / SIZE;
        v[i] = 4.0f / SIZE;
        dudx[i] = dvdy[i] = exp2f(-3.0f + 12.0f * (float)i / (COUNT - 1)) / SIZE;
    }
}

static int check(void)
{
    int i;
    for (i = 0; i < COUNT; ++i) {
        float texels = dudx[i] * SIZE;
        if (g[i] != r[i] || b[i] != r[i] || a[i] != 1.0f) return 0;
        if (texels <= 1.0f && r[i] != 1.0f) return 0;                /* near: the square itself */
        if (texels >= 64.0f && fabsf(r[i] - 0.5f) > 0.01f) return 0; /* far: the average, in linear light */
        if (!(r[i] >= 0.47f && r[i] <= 1.0f)) return 0;              /* never other values */
    }
    return 1;
}

int main(void)
{
    shd_context *context = NULL;
    shd_texture *texture = NULL;
    shd_sampler *sampler = NULL;
    shd_texture_desc td = shd_texture_desc_default();
    shd_sampler_desc sd = shd_sampler_desc_default();
    shd_lookups q = shd_lookups_default();
    shd_texels out = {0};
    int good = 0, i;

    draw_checkerboard();
    place_points();

    td.width = td.height = SIZE;
    td.format = SHD_FORMAT_RGBA8_SRGB;
    td.texels = pixels;
    td.tables = SHD_TABLE_MIPMAP | SHD_TABLE_RIPMAP | SHD_TABLE_SUMMED_AREA;
    sd.wrap_u = sd.wrap_v = SHD_WRAP_REPEAT;
    sd.max_anisotropy = 16.0f;

    q.count = COUNT;
    q.u.data = u, q.v.data = v;
    q.dudx.data = dudx, q.dvdy.data = dvdy; /* dvdx and dudy are absent: 0 */
    out.channel[0].data = r, out.channel[1].data = g, out.channel[2].data = b, out.channel[3].data = a;

    if (shd_context_create(NULL, &context) != SHD_OK ||         /* NULL desc = all defaults */
        shd_texture_create(context, &td, &texture) != SHD_OK) { /* copies the pixels, builds the tables */
        fprintf(stderr, "lookup: %s\n", shd_last_error());
    }
    for (i = 0; texture && i < FILTERS; ++i) {
        sd.filter = filters[i].filter;
        if (shd_sampler_create(context, &sd, &sampler) != SHD_OK ||
            shd_texture_sample(texture, sampler, &q, &out) != SHD_OK) {
            fprintf(stderr, "lookup: %s\n", shd_last_error());
        } else {
            int as_expected = check();
            good += as_expected;
            printf("%d lookups on %s, %s: near %.3f, far %.3f: %s\n", COUNT, shd_context_get_simd_target(context),
                   filters[i].name, r[0], r[COUNT - 1], as_expected ? "as expected" : "WRONG");
        }
        shd_sampler_release(sampler);
        sampler = NULL;
    }
    shd_texture_release(texture);
    shd_context_release(context);
    return good == FILTERS ? 0 : 1;
}
