/* SPDX-License-Identifier: MIT */
/* Common code of the colour tests: images, framebuffers with given pixels, reference curves. */
#ifndef SHD_TESTS_SUPPORT_COLOR_H
#define SHD_TESTS_SUPPORT_COLOR_H

#include <stdlib.h>

#include <shd/color.h>

#include "support/check.h"
#include "support/image.h"

#define SHD_ACES_VIEW "ACES 1.0 SDR-video"

/** sRGB transfer curves: IEC 61966-2-1. */
static inline double shd_srgb_encode(double x)
{
    return x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1.0 / 2.4) - 0.055;
}
static inline double shd_srgb_decode(double x) { return x <= 0.04045 ? x / 12.92 : pow((x + 0.055) / 1.055, 2.4); }

/** A context with `workers` workers and the colour of the built-in config. */
static inline shd_color *shd_test_color(uint32_t workers, shd_context **out_context)
{
    shd_context_desc desc = shd_context_desc_default();
    shd_color_desc color_desc = shd_color_desc_default();
    shd_color *color = NULL;
    desc.worker_count = workers;
    shd_assert_ok(shd_context_create(&desc, out_context));
    color_desc.config_text = shd_color_default_config();
    shd_assert_ok(shd_color_create(*out_context, &color_desc, &color));
    return color;
}

/** A framebuffer with these interleaved RGBA pixels. Planes are viewed in place, so a test can write them. */
static inline shd_framebuffer *shd_test_framebuffer(shd_context *context, uint32_t width, uint32_t height,
                                                    const float *rgba)
{
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    shd_framebuffer *framebuffer = NULL;
    uint32_t x, y, c;
    desc.width = width;
    desc.height = height;
    shd_assert_ok(shd_framebuffer_create(context, &desc, &framebuffer));
    for (c = 0; c < 4; ++c) {
        shd_plane_view view = shd_plane_view_default();
        shd_assert_ok(shd_framebuffer_view_plane(framebuffer, (shd_plane)(SHD_PLANE_R + (int)c), &view));
        for (y = 0; y < height; ++y) {
            float *row = (float *)((uintptr_t)view.f32 + y * view.row_stride);
            for (x = 0; x < width; ++x) row[x] = rgba[4 * ((size_t)y * width + x) + c];
        }
    }
    return framebuffer;
}

/** Scattered values in 0..2, a function of the index. */
static inline float shd_test_value(size_t i) { return (float)((i * 2654435761u >> 7) % 4099u) / 2048.0f; }

/** Value of a binary16. */
static inline double shd_test_half(uint16_t half)
{
    const double sign = half & 0x8000 ? -1.0 : 1.0;
    const int exponent = (half >> 10) & 31;
    const double fraction = half & 1023;
    if (exponent == 31) return fraction != 0.0 ? (double)NAN : sign * (double)INFINITY;
    if (exponent == 0) return sign * ldexp(fraction, -24);
    return sign * ldexp(1024.0 + fraction, exponent - 25);
}

/** Channel `index` of an image of any four-channel format. */
static inline double shd_test_channel(const shd_image *image, size_t index)
{
    switch (image->format) {
        case SHD_FORMAT_RGBA8:
        case SHD_FORMAT_RGBA8_SRGB: return ((const uint8_t *)image->pixels)[index] / 255.0;
        case SHD_FORMAT_RGBA16: return ((const uint16_t *)image->pixels)[index] / 65535.0;
        case SHD_FORMAT_RGBA16F: return shd_test_half(((const uint16_t *)image->pixels)[index]);
        default: return (double)((const float *)image->pixels)[index];
    }
}

#endif /* SHD_TESTS_SUPPORT_COLOR_H */
