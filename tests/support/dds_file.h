/* SPDX-License-Identifier: MIT */
/* Headers of DDS files (Microsoft, "Programming Guide for DDS"). */
#ifndef SHD_TESTS_SUPPORT_DDS_FILE_H
#define SHD_TESTS_SUPPORT_DDS_FILE_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

enum { SHD_DDS_HEADER = 148 };

static inline void shd_dds_put(unsigned char *to, uint32_t value)
{
    int i;
    for (i = 0; i < 4; ++i) to[i] = (unsigned char)(value >> (8 * i));
}

/**
 * Writes the header of an image of one level, at most SHD_DDS_HEADER bytes. Returns its size.
 * @param code         four-character code of the format; "DX10" = a second header with dxgi_format follows
 * @param dxgi_format  0 for other codes
 */
static inline size_t shd_dds_header(const char *code, uint32_t dxgi_format, uint32_t width, uint32_t height,
                                    uint32_t data_size, unsigned char *out)
{
    memset(out, 0, SHD_DDS_HEADER);
    memcpy(out, "DDS ", 4);
    shd_dds_put(out + 4, 124);
    shd_dds_put(out + 8, 0x81007);
    shd_dds_put(out + 12, height);
    shd_dds_put(out + 16, width);
    shd_dds_put(out + 20, data_size);
    shd_dds_put(out + 76, 32);
    shd_dds_put(out + 80, 4);
    memcpy(out + 84, code, 4);
    shd_dds_put(out + 108, 0x1000);
    if (dxgi_format == 0) return 128;
    shd_dds_put(out + 128, dxgi_format);
    shd_dds_put(out + 132, 3); /* two-dimensional */
    shd_dds_put(out + 140, 1); /* one layer */
    return SHD_DDS_HEADER;
}

#endif /* SHD_TESTS_SUPPORT_DDS_FILE_H */
