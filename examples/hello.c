/* SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <stdlib.h>

#include <shd/shd.h>

static void require(shd_result result)
{
    if (result == SHD_OK) return;
    fprintf(stderr, "hello: %s\n", shd_last_error());
    exit(EXIT_FAILURE);
}

int main(void)
{
    const uint8_t pixels[4] = {0, 255, 255, 255}; /* 2 x 2 texels of one channel */
    const float u = 0.5f, v = 0.5f;               /* the corner that all four share */
    float red = 0.0f;
    shd_context *context = NULL;
    shd_texture *texture = NULL;
    shd_sampler *sampler = NULL;
    shd_texture_desc desc = shd_texture_desc_default();
    shd_lookups where = shd_lookups_default();
    shd_texels out = shd_texels_default();

    desc.width = 2;
    desc.height = 2;
    desc.format = SHD_FORMAT_R8;
    desc.texels = pixels;
    require(shd_context_create(NULL, &context)); /* NULL = all defaults */
    require(shd_texture_create(context, &desc, &texture));
    require(shd_sampler_create(context, NULL, &sampler));

    where.count = 1;
    where.u.data = &u;
    where.v.data = &v;
    out.channel[0].data = &red;
    require(shd_texture_sample(texture, sampler, &where, &out));
    printf("the middle of the texture is %.2f\n", red);

    shd_sampler_release(sampler);
    shd_texture_release(texture);
    shd_context_release(context);
    return red == 0.75f ? EXIT_SUCCESS : EXIT_FAILURE;
}
