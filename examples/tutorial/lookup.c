/* SPDX-License-Identifier: MIT */
/* A texture of 4 x 4 texels, enlarged by two filters, from nothing to lookup.png. */
#include <stdio.h>
#include <stdlib.h>

#include <shd/io.h>
#include <shd/shd.h>

enum { SIZE = 240, COUNT = SIZE * SIZE };

static void require(shd_result result)
{
    if (result == SHD_OK) return;
    fprintf(stderr, "lookup: %s\n", shd_last_error());
    exit(EXIT_FAILURE);
}

int main(void)
{
    static const uint8_t texels[16] = {20, 90, 160, 230, 90, 250, 40, 160, 160, 40, 250, 90, 230, 160, 90, 20};
    static const shd_filter filters[2] = {SHD_FILTER_NEAREST, SHD_FILTER_BILINEAR};
    static float u[COUNT], v[COUNT], grey[COUNT];
    static uint8_t pixels[SIZE][2 * SIZE]; /* the two pictures side by side */
    shd_texture_desc texture_desc = shd_texture_desc_default();
    shd_sampler_desc sampler_desc = shd_sampler_desc_default();
    shd_lookups where = shd_lookups_default();
    shd_texels out = shd_texels_default();
    shd_image image = shd_image_default();
    shd_context *context = NULL;
    shd_texture *texture = NULL;
    shd_sampler *sampler = NULL;
    int i, k;

    require(shd_context_create(NULL, &context)); /* NULL: all defaults */
    texture_desc.format = SHD_FORMAT_R8;
    texture_desc.width = texture_desc.height = 4;
    texture_desc.texels = texels;
    require(shd_texture_create(context, &texture_desc, &texture));

    for (i = 0; i < COUNT; ++i) { /* the centre of each pixel, as a point of the texture */
        u[i] = ((float)(i % SIZE) + 0.5f) / SIZE;
        v[i] = ((float)(i / SIZE) + 0.5f) / SIZE;
    }
    where.count = COUNT;
    where.u = shd_f32_column(u, 0); /* 0: the floats lie side by side */
    where.v = shd_f32_column(v, 0);
    out.channel[0] = shd_f32_out_column(grey, 0);
    for (k = 0; k < 2; ++k) {
        sampler_desc.filter = filters[k];
        sampler_desc.wrap_u = sampler_desc.wrap_v = SHD_WRAP_CLAMP;
        require(shd_sampler_create(context, &sampler_desc, &sampler));
        require(shd_texture_sample(texture, sampler, &where, &out));
        for (i = 0; i < COUNT; ++i) pixels[i / SIZE][k * SIZE + i % SIZE] = (uint8_t)(255 * grey[i] + 0.5f);
        shd_sampler_release(sampler);
    }

    image.format = SHD_FORMAT_R8;
    image.width = 2 * SIZE, image.height = SIZE;
    image.pixels = pixels;
    require(shd_image_save(&image, "lookup.png", NULL));

    shd_texture_release(texture);
    shd_context_release(context);
    return EXIT_SUCCESS;
}
