/* SPDX-License-Identifier: MIT */
#ifndef SHD_TESTS_SUPPORT_IMAGE_H
#define SHD_TESTS_SUPPORT_IMAGE_H

#include <shd/image.h>

/** An image over memory of the test. */
static inline shd_image shd_test_image(shd_format format, uint32_t width, uint32_t height, void *pixels)
{
    shd_image image = shd_image_default();
    image.format = format;
    image.width = width;
    image.height = height;
    image.pixels = pixels;
    return image;
}

#endif /* SHD_TESTS_SUPPORT_IMAGE_H */
