/* SPDX-License-Identifier: MIT */
/* Pictures of mip levels on a floor that recedes to the horizon: the nearest level as flat colours, the continuous
 * level of detail as a ramp. Writes levels_nearest.ppm and levels_continuous.ppm. */
#include <math.h>
#include <stdio.h>

#include <shd/shd.h>

enum { SIZE = 256, LEVELS = 9, WIDTH = 480, HEIGHT = 270, COUNT = WIDTH * HEIGHT };

static uint8_t texels[SIZE * SIZE];
static float u[COUNT], v[COUNT], dudx[COUNT], dudy[COUNT], dvdy[COUNT], lod[COUNT];
static uint32_t level[COUNT];

/* A floor at height 1 below the eye, in units of a texture; the horizon is 4 rows above the picture. */
static void place_points(void)
{
    const float focal = 220.0f, horizon = -4.0f;
    int x, y;
    for (y = 0; y < HEIGHT; ++y) {
        const float row = (float)y + 0.5f - horizon;
        for (x = 0; x < WIDTH; ++x) {
            const int i = y * WIDTH + x;
            const float column = (float)x + 0.5f - WIDTH / 2;
            u[i] = column / row;
            v[i] = -focal / row;
            dudx[i] = 1.0f / row; /* dvdx is 0 */
            dudy[i] = -column / (row * row);
            dvdy[i] = focal / (row * row);
        }
    }
}

/* Every level is visible, no level is finer far away than nearby, and each is the nearest to its level of detail. */
static int check(void)
{
    int seen = 0, x, y;
    for (y = 0; y < HEIGHT; ++y) {
        for (x = 0; x < WIDTH; ++x) {
            const int i = y * WIDTH + x;
            if (fabsf(lod[i] - (float)level[i]) > 0.5f || level[i] >= LEVELS) return 0;
            if (y > 0 && lod[i] > lod[i - WIDTH]) return 0;
            seen |= 1 << level[i];
        }
    }
    return seen == (1 << LEVELS) - 1;
}

static int write_picture(const char *name, int continuous)
{
    static const unsigned char colour[LEVELS][3] = {{230, 25, 75},  {245, 130, 48}, {255, 225, 25},
                                                    {60, 180, 75},  {70, 240, 240}, {0, 130, 200},
                                                    {145, 30, 180}, {240, 50, 230}, {128, 128, 128}};
    FILE *file = fopen(name, "wb");
    int i, good;
    if (!file) return 0;
    good = fprintf(file, "P6\n%d %d\n255\n", WIDTH, HEIGHT) > 0;
    for (i = 0; i < COUNT; ++i) {
        const unsigned char grey = (unsigned char)(255.0f * lod[i] / (LEVELS - 1) + 0.5f);
        const unsigned char ramp[3] = {grey, grey, grey};
        good = fwrite(continuous ? ramp : colour[level[i]], 1, 3, file) == 3 && good;
    }
    return fclose(file) == 0 && good;
}

int main(void)
{
    shd_context *context = NULL;
    shd_texture *texture = NULL;
    shd_sampler *sampler = NULL;
    shd_texture_desc td = shd_texture_desc_default();
    shd_lookups q = shd_lookups_default();
    shd_levels out = shd_levels_default();
    int good = 0;

    place_points();
    td.width = td.height = SIZE;
    td.format = SHD_FORMAT_R8;
    td.texels = texels; /* only the levels matter */
    td.tables = SHD_TABLE_MIPMAP;
    q.count = COUNT;
    q.u.data = u, q.v.data = v;
    q.dudx.data = dudx, q.dudy.data = dudy, q.dvdy.data = dvdy;
    out.lod.data = lod, out.level.data = level;

    if (shd_context_create(NULL, &context) != SHD_OK || shd_texture_create(context, &td, &texture) != SHD_OK ||
        shd_sampler_create(context, NULL, &sampler) != SHD_OK || /* NULL desc = trilinear, exact footprints */
        shd_texture_query_levels(texture, sampler, &q, &out) != SHD_OK) {
        fprintf(stderr, "levels: %s\n", shd_last_error());
    } else {
        good = check() && write_picture("levels_nearest.ppm", 0) && write_picture("levels_continuous.ppm", 1);
        printf("levels of detail from %.2f to %.2f: %s\n", lod[COUNT - WIDTH / 2], lod[0],
               good ? "as expected" : "WRONG");
    }
    shd_sampler_release(sampler);
    shd_texture_release(texture);
    shd_context_release(context);
    return good ? 0 : 1;
}
