/* SPDX-License-Identifier: MIT */
/* The texels of 3D textures that were loaded from files. */
#ifndef SHD_TESTS_SUPPORT_VOLUME_FILES_H
#define SHD_TESTS_SUPPORT_VOLUME_FILES_H

#include "support/io_files.h"

#include <shd/volume_file.h>

/** Reads the base level of a 3D texture, [depth][height][width]; the caller must free() it. */
static inline io_bytes io_read_texels(const shd_texture *texture, shd_texture_info *info)
{
    io_bytes out = {NULL, 0};
    size_t slice;
    uint32_t z;
    *info = shd_texture_info_default();
    shd_assert_ok(shd_texture_get_info(texture, info));
    slice = shd_format_size(info->format) * info->width * info->height;
    out.size = slice * info->depth;
    out.data = (unsigned char *)malloc(out.size + 1);
    for (z = 0; z < info->depth; ++z) {
        shd_image image = shd_image_default();
        image.format = info->format;
        image.width = info->width;
        image.height = info->height;
        image.pixels = out.data + z * slice;
        shd_assert_ok(shd_texture_read_level(texture, z, 0, &image));
    }
    return out;
}

#endif /* SHD_TESTS_SUPPORT_VOLUME_FILES_H */
