// SPDX-License-Identifier: MIT
// PNG and JPEG files of every kind, by libpng and libjpeg.
#pragma once

#include <cstdio>
// After <cstdio>, which it needs.
#include <jpeglib.h>
#include <png.h>

#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

namespace shd_test
{

using FileBytes = std::vector<unsigned char>;

/// Numbers of a picture that are not smooth, so that wrong places and orders are seen.
inline unsigned noise(uint32_t x, uint32_t y, uint32_t c)
{
    uint32_t h = x * 0x9e3779b1u ^ y * 0x85ebca77u ^ c * 0xc2b2ae3du;
    h = (h ^ h >> 15) * 0x2c1b3c6du;
    return (h ^ h >> 13) & 0xffff;
}

/// A PNG file to write.
struct PngKind {
    std::string name;
    int color = PNG_COLOR_TYPE_RGB;
    int bits = 8;
    bool transparency = false;  // tRNS
    bool interlaced = false;
    double gamma = 0;  // gAMA; -1 = sRGB; 0 = none
    uint32_t width = 37, height = 29;
};

inline void write_png_bytes(png_structp png, png_bytep bytes, size_t size)
{
    auto *out = static_cast<FileBytes *>(png_get_io_ptr(png));
    out->insert(out->end(), bytes, bytes + size);
}

inline void set_png_transparency(png_structp png, png_infop info, const PngKind &kind)
{
    unsigned char alphas[256];
    for (unsigned i = 0; i < 256; ++i) alphas[i] = static_cast<unsigned char>(255 - 37 * i);
    png_color_16 key = {};
    key.gray = key.red = static_cast<png_uint_16>(noise(3, 3, 0) & ((1u << kind.bits) - 1));
    key.green = static_cast<png_uint_16>(noise(3, 3, 1) & ((1u << kind.bits) - 1));
    key.blue = static_cast<png_uint_16>(noise(3, 3, 2) & ((1u << kind.bits) - 1));
    png_set_tRNS(png, info, alphas, (1 << std::min(kind.bits, 8)) - (kind.bits > 1), &key);
}

/// The rows of a file of this kind, packed and big-endian as the file has them.
inline std::vector<FileBytes> png_rows(const PngKind &kind, size_t channels)
{
    std::vector<FileBytes> rows(kind.height);
    for (uint32_t y = 0; y < kind.height; ++y) {
        FileBytes &row = rows[y];
        row.resize((kind.width * channels * static_cast<size_t>(kind.bits) + 7) / 8);
        for (size_t i = 0; i < kind.width * channels; ++i) {
            const unsigned value = noise(static_cast<uint32_t>(i / channels), y, static_cast<uint32_t>(i % channels));
            if (kind.bits == 16) {
                row[2 * i] = static_cast<unsigned char>(value >> 8);
                row[2 * i + 1] = static_cast<unsigned char>(value & 0xff);
            } else {
                const size_t bit = i * static_cast<size_t>(kind.bits);
                const unsigned code = value & ((1u << kind.bits) - 1);
                row[bit / 8] =
                    static_cast<unsigned char>(row[bit / 8] | code << (8 - kind.bits - static_cast<int>(bit % 8)));
            }
        }
    }
    return rows;
}

inline FileBytes make_png(const PngKind &kind)
{
    FileBytes out;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(png, &out, write_png_bytes, nullptr);
    png_set_IHDR(png, info, kind.width, kind.height, kind.bits, kind.color,
                 kind.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    if (kind.color == PNG_COLOR_TYPE_PALETTE) {
        std::vector<png_color> colors(size_t{1} << kind.bits);
        for (uint32_t i = 0; i < colors.size(); ++i) {
            colors[i] = {static_cast<png_byte>(noise(i, 7, 0)), static_cast<png_byte>(noise(i, 7, 1)),
                         static_cast<png_byte>(noise(i, 7, 2))};
        }
        png_set_PLTE(png, info, colors.data(), static_cast<int>(colors.size()));
    }
    if (kind.transparency) set_png_transparency(png, info, kind);
    if (kind.gamma > 0) png_set_gAMA(png, info, kind.gamma);
    if (kind.gamma < 0) png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(png, info);
    std::vector<FileBytes> rows = png_rows(kind, png_get_channels(png, info));
    std::vector<png_bytep> pointers;
    for (FileBytes &row : rows) pointers.push_back(row.data());
    png_write_image(png, pointers.data());
    png_write_end(png, nullptr);
    png_destroy_write_struct(&png, &info);
    return out;
}

/// A JPEG file to write.
struct JpegKind {
    std::string name;
    int components = 3;
    J_COLOR_SPACE in = JCS_RGB, stored = JCS_YCbCr;
    int sampling_x = 2, sampling_y = 2;  // factors of the first component
    bool progressive = false, arithmetic = false;
    unsigned restart = 0;  // MCUs between restart markers
    int quality = 75;
    uint32_t width = 83, height = 61;
};

inline FileBytes make_jpeg(const JpegKind &kind)
{
    jpeg_compress_struct encoder = {};
    jpeg_error_mgr errors;
    unsigned char *bytes = nullptr;
    unsigned long size = 0;
    encoder.err = jpeg_std_error(&errors);
    jpeg_create_compress(&encoder);
    jpeg_mem_dest(&encoder, &bytes, &size);
    encoder.image_width = kind.width;
    encoder.image_height = kind.height;
    encoder.input_components = kind.components;
    encoder.in_color_space = kind.in;
    jpeg_set_defaults(&encoder);
    jpeg_set_colorspace(&encoder, kind.stored);
    jpeg_set_quality(&encoder, kind.quality, TRUE);
    encoder.comp_info[0].h_samp_factor = kind.sampling_x;
    encoder.comp_info[0].v_samp_factor = kind.sampling_y;
    encoder.restart_interval = kind.restart;
    encoder.arith_code = kind.arithmetic ? TRUE : FALSE;
    if (kind.progressive) jpeg_simple_progression(&encoder);
    jpeg_start_compress(&encoder, TRUE);
    FileBytes row(size_t{kind.width} * static_cast<size_t>(kind.components));
    for (uint32_t y = 0; y < kind.height; ++y) {
        for (size_t i = 0; i < row.size(); ++i) {
            const auto c = static_cast<uint32_t>(i % static_cast<size_t>(kind.components));
            const auto x = static_cast<uint32_t>(i / static_cast<size_t>(kind.components));
            row[i] = static_cast<unsigned char>((x * (3 + c) + y * 2 + (noise(x / 4, y / 4, c) & 63)) & 0xff);
        }
        JSAMPROW at = row.data();
        jpeg_write_scanlines(&encoder, &at, 1);
    }
    jpeg_finish_compress(&encoder);
    jpeg_destroy_compress(&encoder);
    const FileBytes out(bytes, bytes + size);
    std::free(bytes);
    return out;
}

}  // namespace shd_test
