/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "planet.h"

/* Texels of a row that are computed in one call. The default tile of RGBA8 has 128 x 128 texels. */
enum { ROW = 128, OCTAVES = 17, COLORS = 7 };

static const double k_pi = 3.14159265358979323846;
const float k_planet_sun[3] = {0.30f, 0.42f, 0.8565f};

/* Places of a row on the unit sphere, and the noise there. */
struct row {
    float place[3][ROW], width[ROW], height[ROW], slope[3][ROW];
};

/* Heights at which the land has a colour, and the sRGB codes of the colour. */
static const float k_heights[COLORS] = {0.0f, 0.012f, 0.05f, 0.13f, 0.22f, 0.30f, 0.37f};
static const float k_codes[COLORS][3] = {{196, 184, 146}, {118, 138, 74},  {72, 108, 50},  {88, 104, 56},
                                         {122, 106, 82},  {138, 128, 118}, {240, 242, 246}};

static float mix(float a, float b, float t)
{
    return a + (b - a) * t;
}
static float clamp(float t, float low, float high)
{
    return fminf(fmaxf(t, low), high);
}

/* The noise: continents of half a radius down to hills of two texels. */
static shd_solid_desc terrain(void)
{
    shd_solid_desc desc = shd_solid_desc_default();
    desc.kind = SHD_SOLID_PERLIN;
    desc.seed = 11;
    desc.size = 0.9f;
    desc.octaves = OCTAVES;
    desc.gain = 0.53f;
    return desc;
}

/* Fills a row with places. `width` is the longer side of a texel, so that coarse levels have fewer octaves. */
static void find_places(const shd_tile *tile, uint32_t row, const double (*longitude)[2], struct row *out)
{
    const double texel = ldexp(1.0, (int)tile->level) / PLANET_EDGE;
    const double colatitude = k_pi * ((double)(tile->area.y + row) + 0.5) * texel;
    const double ring = sin(colatitude), up = cos(colatitude);
    const double side = texel * k_pi * fmax(1.0, 2.0 * ring);
    uint32_t i;
    for (i = 0; i < tile->area.width; ++i) {
        out->place[0][i] = (float)(ring * longitude[i][0]);
        out->place[1][i] = (float)up;
        out->place[2][i] = (float)(ring * longitude[i][1]);
        out->width[i] = (float)side;
    }
}

static shd_result evaluate(shd_context *context, uint32_t count, struct row *row)
{
    const shd_solid_desc desc = terrain();
    shd_solid_points points = shd_solid_points_default();
    shd_solid_values values = shd_solid_values_default();
    int c;
    points.count = count;
    for (c = 0; c < 3; ++c) {
        points.position[c].data = row->place[c];
        values.gradient[c].data = row->slope[c];
    }
    points.width.data = row->width;
    values.value.data = row->height;
    return shd_solid_evaluate(context, &desc, &points, &values);
}

/* Brightness of a slope, compared with flat ground. */
static float relief(const struct row *row, uint32_t i)
{
    float up = 0, along = 0, climb = 0;
    int c;
    for (c = 0; c < 3; ++c) {
        up += row->place[c][i] * k_planet_sun[c];
        along += row->slope[c][i] * k_planet_sun[c];
        climb += row->slope[c][i] * row->place[c][i];
    }
    return clamp(1.0f - 0.10f * (along - up * climb), 0.45f, 1.5f);
}

/* Writes a texel: sea by depth, land by height, and snow towards the poles. */
static void paint(const struct row *row, uint32_t i, uint8_t *out)
{
    const float polar = clamp(6.0f * (fabsf(row->place[1][i]) - 0.80f), 0.0f, 1.0f);
    const float height = row->height[i];
    float rgb[3] = {22, 52, 96}, light = 1.0f;
    int c, k = 0;
    if (height < 0.0f) {
        const float shallow = expf(height * 24.0f);
        rgb[0] = mix(rgb[0], 64, shallow), rgb[1] = mix(rgb[1], 128, shallow), rgb[2] = mix(rgb[2], 150, shallow);
    } else {
        const float cold = height + 0.45f * polar;
        while (k < COLORS - 2 && cold > k_heights[k + 1]) ++k;
        light = clamp((cold - k_heights[k]) / (k_heights[k + 1] - k_heights[k]), 0.0f, 1.0f);
        for (c = 0; c < 3; ++c) rgb[c] = mix(k_codes[k][c], k_codes[k + 1][c], light);
        light = mix(1.0f, relief(row, i), clamp(height * 60.0f, 0.0f, 1.0f));
    }
    for (c = 0; c < 3; ++c) out[c] = (uint8_t)(clamp(rgb[c] * light, 0.0f, 255.0f) + 0.5f);
    out[3] = 255;
}

/* Computes one tile. Columns have the same longitude in each of its rows. */
static shd_result load_tile(shd_context *context, const shd_tile *tile)
{
    const double texel = ldexp(1.0, (int)tile->level) / PLANET_EDGE;
    double longitude[ROW][2];
    struct row row;
    uint32_t x, y;
    if (tile->area.width > ROW) return SHD_ERROR_UNSUPPORTED;
    for (x = 0; x < tile->area.width; ++x) {
        const double angle = 2.0 * k_pi * (((double)(tile->area.x + x) + 0.5) * texel - 0.5);
        longitude[x][0] = sin(angle), longitude[x][1] = cos(angle);
    }
    for (y = 0; y < tile->area.height; ++y) {
        uint8_t *const out = (uint8_t *)tile->texels + y * tile->row_stride;
        shd_result result;
        find_places(tile, y, (const double(*)[2])longitude, &row);
        result = evaluate(context, tile->area.width, &row);
        if (result != SHD_OK) return result;
        for (x = 0; x < tile->area.width; ++x) paint(&row, x, out + 4 * x);
    }
    return SHD_OK;
}

/* Called by every thread that looks up; it has no state, so it needs no lock. */
static shd_result load(const shd_tile *tiles, size_t count, void *user_data)
{
    shd_result result = SHD_OK;
    size_t i;
    for (i = 0; i < count && result == SHD_OK; ++i) result = load_tile((shd_context *)user_data, &tiles[i]);
    return result;
}

shd_result planet_create_texture(shd_context *context, shd_tile_cache *cache, shd_texture **out)
{
    shd_texture_desc desc = shd_texture_desc_default();
    desc.format = SHD_FORMAT_RGBA8_SRGB;
    desc.width = desc.height = PLANET_EDGE;
    desc.tables = SHD_TABLE_MIPMAP;
    desc.tiles.cache = cache;
    desc.tiles.load = load;
    desc.tiles.user_data = context; /* retained by the texture */
    return shd_texture_create(context, &desc, out);
}

shd_result planet_pin_coarse_levels(const shd_texture *planet, uint32_t first_level)
{
    shd_tile_region region = shd_tile_region_default();
    shd_result result = SHD_OK;
    for (region.level = first_level; PLANET_EDGE >> region.level != 0 && result == SHD_OK; ++region.level) {
        region.area.width = region.area.height = PLANET_EDGE >> region.level;
        result = shd_texture_pin_tiles(planet, &region);
    }
    return result;
}
