/* SPDX-License-Identifier: MIT */
/* Projections, conversions and lookups of directions as a number, which is equal for every SIMD target and worker
 * count. */
#ifndef SHD_TESTS_SUPPORT_DIRECTION_HASH_H
#define SHD_TESTS_SUPPORT_DIRECTION_HASH_H

#include "support/check.h"
#include "support/noise.h"

#include <shd/shd.h>

enum { SHD_DIRECTION_POINTS = 17011, SHD_DIRECTION_SIZE = 13 };

struct shd_direction_columns {
    float n[9][SHD_DIRECTION_POINTS]; /* direction, its change in x, its change in y */
    float out[7][SHD_DIRECTION_POINTS];
    uint32_t face[SHD_DIRECTION_POINTS];
    float texels[6 * 2 * SHD_DIRECTION_SIZE * SHD_DIRECTION_SIZE];
};

static inline void shd_fill_directions(struct shd_direction_columns *columns)
{
    static const float k_special[] = {0.0f, -0.0f, 1.0f, -1.0f, 1e-30f, 3e38f, NAN, INFINITY};
    uint32_t bits = 5;
    size_t i;
    int c;
    for (i = 0; i < SHD_DIRECTION_POINTS; ++i) {
        /* Footprints from a thousandth of the sphere to all of it; some long and thin. */
        const float size = 2.0f / (float)(1 << (i % 12));
        for (c = 0; c < 9; ++c) {
            float x;
            shd_noise(&bits);
            x = (float)(bits >> 8) / 8388608.0f - 1.0f;
            if (i % 16 == 7 && c < 3) x = k_special[(bits >> 9) % 8];
            if (i % 97 == 9) x = k_special[(bits >> 9) % 8];
            columns->n[c][i] = c < 3 ? x : c < 6 ? x * size : x * size * (i % 3 ? 1.0f : 0.1f);
        }
    }
    for (i = 0; i < sizeof columns->texels / sizeof *columns->texels; ++i) {
        shd_noise(&bits);
        columns->texels[i] = (float)(bits >> 8) / 8388608.0f;
    }
}

static inline uint64_t shd_hash_projection(shd_context *context, shd_projection projection,
                                           struct shd_direction_columns *columns, uint64_t hash)
{
    shd_directions in = shd_directions_default();
    shd_projected_points points = shd_projected_points_default();
    shd_image_points back = shd_image_points_default();
    shd_point_directions directions = shd_point_directions_default();
    int c;
    in.projection = back.projection = projection;
    in.count = back.count = SHD_DIRECTION_POINTS;
    for (c = 0; c < 3; ++c) {
        in.direction[c] = shd_f32_column(columns->n[c], 0);
        in.direction_dx[c] = shd_f32_column(columns->n[3 + c], 0);
        in.direction_dy[c] = shd_f32_column(columns->n[6 + c], 0);
        directions.direction[c] = shd_f32_out_column(columns->out[2 + c], 0);
    }
    points.u = shd_f32_out_column(columns->out[0], 0), points.v = shd_f32_out_column(columns->out[1], 0);
    points.dudx = shd_f32_out_column(columns->out[2], 0), points.dvdx = shd_f32_out_column(columns->out[3], 0);
    points.dudy = shd_f32_out_column(columns->out[4], 0), points.dvdy = shd_f32_out_column(columns->out[5], 0);
    points.face = shd_u32_out_column(columns->face, 0);
    shd_assert_ok(shd_projection_project(context, &in, &points));
    hash = shd_hash(hash, columns->out, 6 * sizeof columns->out[0]);
    hash = shd_hash(hash, columns->face, sizeof columns->face);
    back.u = shd_f32_column(columns->out[0], 0), back.v = shd_f32_column(columns->out[1], 0);
    back.face = shd_u32_column(columns->face, 0);
    directions.solid_angle = shd_f32_out_column(columns->out[5], 0);
    shd_assert_ok(shd_projection_unproject(context, &back, &directions));
    return shd_hash(hash, columns->out[2], 4 * sizeof columns->out[0]);
}

static inline uint64_t shd_hash_direction_lookups(shd_context *context, shd_projection projection,
                                                  struct shd_direction_columns *columns, uint64_t hash)
{
    static const shd_filter k_direction_filters[] = {
        SHD_FILTER_NEAREST,   SHD_FILTER_BILINEAR,    SHD_FILTER_NEAREST_MIP, SHD_FILTER_BILINEAR_MIP,
        SHD_FILTER_TRILINEAR, SHD_FILTER_ANISOTROPIC, SHD_FILTER_EWA,
    };
    shd_texture_desc desc = shd_texture_desc_default();
    shd_lookups in = shd_lookups_default();
    shd_texels out = shd_texels_default();
    shd_texture *texture = NULL;
    size_t filter;
    desc.format = SHD_FORMAT_R32F;
    desc.height = SHD_DIRECTION_SIZE;
    desc.width = projection == SHD_PROJECTION_LAT_LONG ? 2 * SHD_DIRECTION_SIZE : SHD_DIRECTION_SIZE;
    desc.layer_count = projection == SHD_PROJECTION_CUBE ? 6 : 1;
    desc.projection = projection;
    if (projection) desc.kind = SHD_TEXTURE_KIND_DIRECTIONS;
    desc.texels = columns->texels;
    desc.tables = SHD_TABLE_MIPMAP;
    shd_assert_ok(shd_texture_create(context, &desc, &texture));
    in.count = SHD_DIRECTION_POINTS;
    in.u = shd_f32_column(columns->n[0], 0), in.v = shd_f32_column(columns->n[1], 0);
    in.w = shd_f32_column(columns->n[2], 0);
    in.dudx = shd_f32_column(columns->n[3], 0), in.dvdx = shd_f32_column(columns->n[4], 0);
    in.dwdx = shd_f32_column(columns->n[5], 0);
    in.dudy = shd_f32_column(columns->n[6], 0), in.dvdy = shd_f32_column(columns->n[7], 0);
    in.dwdy = shd_f32_column(columns->n[8], 0);
    out.channel[0] = shd_f32_out_column(columns->out[0], 0);
    for (filter = 0; filter < sizeof k_direction_filters / sizeof *k_direction_filters; ++filter) {
        shd_sampler_desc sampler_desc = shd_sampler_desc_default();
        shd_sampler *sampler = NULL;
        uint64_t nonfinite;
        size_t i;
        sampler_desc.filter = k_direction_filters[filter];
        shd_assert_ok(shd_sampler_create(context, &sampler_desc, &sampler));
        shd_assert_ok(shd_texture_sample(texture, sampler, &in, &out));
        for (i = 0; i < SHD_DIRECTION_POINTS; ++i) assert_true(columns->out[0][i] >= 0 && columns->out[0][i] <= 2);
        hash = shd_hash(hash, columns->out[0], sizeof columns->out[0]);
        nonfinite = out.nonfinite_count; /* size_t has four bytes on some machines */
        hash = shd_hash(hash, &nonfinite, sizeof nonfinite);
        shd_sampler_release(sampler);
    }
    shd_texture_release(texture);
    return hash;
}

/** Points, directions, lookups with every filter, and conversions, of every projection. */
static inline uint64_t shd_direction_hash(const shd_context_desc *desc)
{
    static struct shd_direction_columns columns;
    static float converted[5 * 5 * 6];
    uint64_t hash = SHD_HASH_START;
    shd_context *context = NULL;
    int projection;
    shd_fill_directions(&columns);
    shd_assert_ok(shd_context_create(desc, &context));
    for (projection = SHD_PROJECTION_LAT_LONG; projection <= SHD_PROJECTION_OCTAHEDRAL; ++projection) {
        shd_direction_images from = shd_direction_images_default(), to = shd_direction_images_default();
        shd_image source = shd_image_default(), target = shd_image_default();
        hash = shd_hash_projection(context, (shd_projection)projection, &columns, hash);
        hash = shd_hash_direction_lookups(context, (shd_projection)projection, &columns, hash);
        source.format = target.format = SHD_FORMAT_R32F;
        source.width = 2 * SHD_DIRECTION_SIZE, source.height = SHD_DIRECTION_SIZE;
        source.pixels = columns.texels, target.pixels = converted;
        target.width = projection == SHD_PROJECTION_CUBE ? 30 : 5, target.height = 5;
        from.projection = SHD_PROJECTION_LAT_LONG, to.projection = (shd_projection)projection;
        from.images = &source, to.images = &target;
        to.layout = SHD_CUBE_LAYOUT_ROW;
        shd_assert_ok(shd_projection_convert(context, &from, &to));
        hash = shd_hash(hash, converted, target.width * target.height * sizeof(float));
    }
    shd_context_release(context);
    return hash;
}

#endif /* SHD_TESTS_SUPPORT_DIRECTION_HASH_H */
