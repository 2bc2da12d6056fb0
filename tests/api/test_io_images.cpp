// SPDX-License-Identifier: MIT
// Images whose pixels depend on a field of the header: the unused byte of BMP, the order of the pixels of Radiance HDR,
// channels named X, Y and Z; and the options that make colours linear and weight them by alpha. Files are made here.
#include <OpenImageIO/imageio.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include <shd/shd.h>

#include "support/io_files.h"

namespace
{

shd_context *g_context;

using Bytes = std::vector<unsigned char>;

void put32(Bytes &to, uint32_t value)
{
    for (int i = 0; i < 4; ++i) to.push_back(static_cast<unsigned char>(value >> 8 * i));
}

/// A bitmap and the image of its pixels.
struct Loaded {
    shd_bitmap *bitmap = nullptr;
    shd_image image = shd_image_default();
    explicit Loaded(const Bytes &file, uint32_t flags = 0)
    {
        shd_load_desc desc = shd_load_desc_default();
        desc.flags = flags;
        shd_assert_ok(shd_bitmap_load_memory(g_context, file.data(), file.size(), &desc, &bitmap));
        shd_assert_ok(shd_bitmap_get_image(bitmap, &image));
    }
    ~Loaded() { shd_bitmap_release(bitmap); }
    Loaded(const Loaded &) = delete;
    Loaded &operator=(const Loaded &) = delete;
    const float *floats(uint32_t x, uint32_t y) const
    {
        assert_int_equal(image.format, SHD_FORMAT_RGBA32F);
        return static_cast<const float *>(image.pixels) + (size_t{y} * image.width + x) * 4;
    }
};

/// 2 x 1 pixels of 32 bits (Microsoft, "BITMAPINFOHEADER"): red and blue, the fourth byte is 0.
Bytes make_bmp()
{
    Bytes file = {'B', 'M'};
    put32(file, 54 + 8);
    put32(file, 0);
    put32(file, 54);
    for (const uint32_t field : {40u, 2u, 1u, 1u | 32u << 16, 0u, 8u, 0u, 0u, 0u, 0u}) put32(file, field);
    put32(file, 0x00ff0000);
    put32(file, 0x000000ff);
    return file;
}

/// With BI_RGB the fourth byte is not used, and the picture is opaque.
void test_bmp(void **)
{
    const Loaded loaded(make_bmp());
    const unsigned char expected[8] = {255, 0, 0, 255, 0, 0, 255, 255};
    assert_int_equal(loaded.image.format, SHD_FORMAT_RGBA8_SRGB);
    assert_memory_equal(loaded.image.pixels, expected, 8);
}

/// A resolution string of a picture of 5 x 3 pixels (Ward, "Radiance File Formats").
struct Order {
    const char *name, *resolution;
    bool columns, mirror_x, mirror_y;
};
const Order k_orders[] = {
    {"hdr/-Y+X", "-Y 3 +X 5", false, false, false}, {"hdr/-Y-X", "-Y 3 -X 5", false, true, false},
    {"hdr/+Y+X", "+Y 3 +X 5", false, false, true},  {"hdr/+Y-X", "+Y 3 -X 5", false, true, true},
    {"hdr/+X-Y", "+X 5 -Y 3", true, false, false},  {"hdr/-X-Y", "-X 5 -Y 3", true, true, false},
    {"hdr/+X+Y", "+X 5 +Y 3", true, false, true},   {"hdr/-X+Y", "-X 5 +Y 3", true, true, true},
};

/// Pixel (x, y) of the upright picture is (x + 1, y + 1, 0.5).
Bytes make_hdr(const Order &order)
{
    const std::string head = std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n") + order.resolution + "\n";
    Bytes file(head.begin(), head.end());
    const int lines = order.columns ? 5 : 3, length = order.columns ? 3 : 5;
    for (int line = 0; line < lines; ++line) {
        for (int i = 0; i < length; ++i) {
            const int x = order.columns ? line : i, y = order.columns ? i : line;
            const int u = order.mirror_x ? 4 - x : x, v = order.mirror_y ? 2 - y : y;
            const unsigned char exponent = 128 + 3; /* value = mantissa / 256 * 8 */
            for (const int mantissa : {(u + 1) * 32, (v + 1) * 32, 16})
                file.push_back(static_cast<unsigned char>(mantissa));
            file.push_back(exponent);
        }
    }
    return file;
}

void test_hdr(void **state)
{
    const Order &order = *static_cast<const Order *>(*state);
    for (const uint32_t flags : {0, SHD_LOAD_IN_PROCESS + 0, SHD_LOAD_FLIP_V + 0}) {
        const Loaded loaded(make_hdr(order), flags);
        assert_int_equal(loaded.image.width, 5);
        assert_int_equal(loaded.image.height, 3);
        for (uint32_t y = 0; y < 3; ++y) {
            for (uint32_t x = 0; x < 5; ++x) {
                const float *pixel = loaded.floats(x, flags & SHD_LOAD_FLIP_V ? 2 - y : y);
                const double expected[3] = {x + 1.0, y + 1.0, 0.5};
                for (size_t c = 0; c < 3; ++c) {
                    shd_assert_close(order.name, c, static_cast<double>(pixel[c]), expected[c], 0.04, 0);
                }
            }
        }
    }
}

void test_hdr_xyze(void **)
{
    Bytes file = make_hdr(k_orders[0]);
    const std::string text(file.begin(), file.end());
    file[text.find("rgbe")] = 'x', file[text.find("rgbe") + 1] = 'y', file[text.find("rgbe") + 2] = 'z';
    shd_bitmap *bitmap = nullptr;
    shd_assert_result("xyze", shd_bitmap_load_memory(g_context, file.data(), file.size(), nullptr, &bitmap),
                      SHD_ERROR_UNSUPPORTED, "XYZE, not RGBE");
}

/// Channels of an OpenEXR file with the values .25, .5 and 1, in their order; the expected r, g, b.
struct Channels {
    const char *name;
    std::vector<std::string> names;
    std::array<double, 3> expected;
};
const Channels k_channels[] = {
    {"exr/XYZ", {"X", "Y", "Z"}, {0.25, 0.5, 1}},
    {"exr/YZ", {"Y", "Z"}, {0.25, 0.25, 0.25}}, /* grey with depth */
    {"exr/Y", {"Y"}, {0.25, 0.25, 0.25}},
    {"exr/RGB", {"R", "G", "B"}, {0.25, 0.5, 1}},
};

void test_channels(void **state)
{
    const Channels &c = *static_cast<const Channels *>(*state);
    const std::string path = io_path("channels.exr");
    const auto out = OIIO::ImageOutput::create(path);
    OIIO::ImageSpec spec(1, 1, static_cast<int>(c.names.size()), OIIO::TypeFloat);
    spec.channelnames = c.names;
    const float values[3] = {0.25f, 0.5f, 1};
    assert_true(out->open(path, spec) && out->write_image(OIIO::TypeFloat, values) && out->close());
    const io_bytes bytes = io_read(path.c_str());
    const Loaded loaded(Bytes(bytes.data, bytes.data + bytes.size));
    for (size_t k = 0; k < 3; ++k) {
        shd_assert_close(c.name, k, static_cast<double>(loaded.floats(0, 0)[k]), c.expected[k], 0, 0);
    }
    free(bytes.data);
}

/// A file of these pixels.
template <class Code>
Bytes make_file(shd_format format, uint32_t width, uint32_t height, std::vector<Code> pixels, const char *name)
{
    shd_image image = shd_image_default();
    const char *path = io_path(name);
    image.format = format, image.width = width, image.height = height, image.pixels = pixels.data();
    shd_assert_ok(shd_image_save(&image, path, nullptr));
    const io_bytes bytes = io_read(path);
    const Bytes out(bytes.data, bytes.data + bytes.size);
    free(bytes.data);
    return out;
}

template <class Code>
Bytes make_png(shd_format format, uint32_t width, uint32_t height, std::vector<Code> pixels)
{
    return make_file(format, width, height, pixels, "made.png");
}

double to_light(double code) { return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4); }

/// SHD_LOAD_LINEAR: codes of 16 bits become light by the sRGB curve, bytes keep their format, which has the curve.
void test_linear(void **)
{
    const Bytes words = make_png<uint16_t>(SHD_FORMAT_RGBA16, 1, 1, {48316, 13107, 65535, 32768});
    const double expected[4] = {to_light(48316 / 65535.0), to_light(0.2), 1, 32768 / 65535.0};
    const Loaded light(words, SHD_LOAD_LINEAR), codes(words);
    for (size_t c = 0; c < 4; ++c) {
        shd_assert_close("linear", c, static_cast<double>(light.floats(0, 0)[c]), expected[c], 1e-6, 0);
    }
    assert_string_equal(shd_bitmap_get_color_space(light.bitmap), "Linear Rec.709");
    assert_int_equal(codes.image.format, SHD_FORMAT_RGBA16);
    const Bytes bytes = make_png<unsigned char>(SHD_FORMAT_RGBA8_SRGB, 1, 1, {188, 10, 255, 128});
    const Loaded kept(bytes, SHD_LOAD_LINEAR);
    assert_int_equal(kept.image.format, SHD_FORMAT_RGBA8_SRGB);
    assert_int_equal(static_cast<const unsigned char *>(kept.image.pixels)[0], 188);
}

/// Level `level` of the texture of a PNG.
std::vector<unsigned char> load_level(const Bytes &file, uint32_t flags, uint32_t level)
{
    shd_load_desc desc = shd_load_desc_default();
    shd_texture_info info = shd_texture_info_default();
    shd_image image = shd_image_default();
    shd_texture *texture = nullptr;
    desc.flags = flags;
    shd_assert_ok(shd_texture_load_memory(g_context, file.data(), file.size(), &desc, &texture));
    shd_assert_ok(shd_texture_get_info(texture, &info));
    image.format = info.format, image.width = info.width >> level, image.height = info.height >> level;
    std::vector<unsigned char> out(size_t{4} * image.width * image.height);
    image.pixels = out.data();
    shd_assert_ok(shd_texture_read_level(texture, 0, level, &image));
    shd_texture_release(texture);
    return out;
}

/// Columns of an opaque colour and of an invisible one: levels have the opaque colour and alpha 1/2, and the invisible
/// texels take the colour of their neighbours.
void test_alpha_weighted(void **)
{
    std::vector<unsigned char> pixels;
    for (int i = 0; i < 64; ++i) {
        const unsigned char seen[4] = {200, 30, 0, 255}, unseen[4] = {255, 255, 255, 0};
        pixels.insert(pixels.end(), i % 2 ? unseen : seen, (i % 2 ? unseen : seen) + 4);
    }
    const Bytes file = make_png(SHD_FORMAT_RGBA8_SRGB, 8, 8, pixels);
    const auto base = load_level(file, SHD_LOAD_ALPHA_WEIGHTED, 0), plain = load_level(file, 0, 1);
    for (size_t i = 0; i < 64; ++i) {
        const unsigned char expected[4] = {200, 30, 0, static_cast<unsigned char>(i % 2 ? 0 : 255)};
        assert_memory_equal(&base[4 * i], expected, 4);
    }
    for (uint32_t level = 1; level < 4; ++level) {
        const auto texels = load_level(file, SHD_LOAD_ALPHA_WEIGHTED, level);
        for (size_t i = 0; i < texels.size(); i += 4) {
            const unsigned char expected[4] = {200, 30, 0, 128};
            assert_memory_equal(&texels[i], expected, 4);
        }
    }
    assert_true(plain[1] > 180);  // without the option white shines through
    assert_true(load_level(file, 0, 0) == pixels);
    for (size_t i = 3; i < pixels.size(); i += 4) pixels[i] = 255;  // opaque: the option has no effect
    const Bytes opaque = make_png(SHD_FORMAT_RGBA8_SRGB, 8, 8, pixels);
    assert_true(load_level(opaque, SHD_LOAD_ALPHA_WEIGHTED, 1) == load_level(opaque, 0, 1));
}

/// Texels far from all visible ones take the colour of a coarser level.
void test_alpha_far(void **)
{
    std::vector<unsigned char> pixels(4 * 64, 0);
    const unsigned char seen[4] = {10, 90, 170, 255};
    std::copy(seen, seen + 4, pixels.begin());
    const auto base = load_level(make_png(SHD_FORMAT_RGBA8_SRGB, 8, 8, pixels), SHD_LOAD_ALPHA_WEIGHTED, 0);
    for (size_t i = 0; i < 64; ++i) {
        for (size_t c = 0; c < 3; ++c) assert_int_equal(base[4 * i + c], seen[c]);
        assert_int_equal(base[4 * i + 3], i ? 0 : 255);
    }
}

/// A TIFF of 16 bytes a row with these entries of a directory: tag and value (TIFF 6.0, section 2).
Bytes make_tiff(const std::vector<std::array<uint32_t, 2>> &entries)
{
    Bytes file = {'I', 'I', 42, 0};
    put32(file, 24);
    file.insert(file.end(), 16, 0x92);
    file.push_back(static_cast<unsigned char>(entries.size()));
    file.push_back(0);
    for (const auto &[tag, value] : entries) {
        put32(file, tag | 4u << 16);
        put32(file, 1);
        put32(file, value);
    }
    put32(file, 0);
    return file;
}

/// Defaults of the format that the decoder does not follow are refused: BitsPerSample is 1, and 0 may be white.
void test_tiff(void **)
{
    using Entries = std::vector<std::array<uint32_t, 2>>;
    const Entries grey = {{256, 8}, {257, 1}, {258, 8}, {259, 1}, {262, 1}, {273, 8}, {277, 1}, {278, 1}, {279, 8}};
    Entries bits = grey, white = grey, wide = grey, lab = grey;
    lab[4][1] = 8;
    bits.erase(bits.begin() + 2);
    white[4][1] = 0;
    wide[4][1] = 0, wide[2][1] = 16, wide[8][1] = 16;
    const auto load = [](const Entries &entries, shd_bitmap **bitmap) {
        const Bytes file = make_tiff(entries);
        return shd_bitmap_load_memory(g_context, file.data(), file.size(), nullptr, bitmap);
    };
    shd_bitmap *bitmap = nullptr;
    shd_image image = shd_image_default();
    shd_assert_ok(load(white, &bitmap));
    shd_assert_ok(shd_bitmap_get_image(bitmap, &image));
    assert_int_equal(static_cast<const unsigned char *>(image.pixels)[0], 255 - 0x92);
    shd_bitmap_release(bitmap);
    shd_assert_result("1 bit", load(bits, &bitmap), SHD_ERROR_UNSUPPORTED, "no BitsPerSample, which means 1 bit");
    shd_assert_result("lab", load(lab, &bitmap), SHD_ERROR_UNSUPPORTED, "CIE L*a*b*");
    shd_assert_result("16 bits", load(wide, &bitmap), SHD_ERROR_UNSUPPORTED, "16 bits in which 0 is white");
}

/// PFM has light, unlike the integers of PNM.
void test_pfm(void **)
{
    const std::string header = "PF\n1 1\n-1.0\n";
    const float pixel[3] = {0.25f, 1, 4};
    Bytes file(header.begin(), header.end());
    const auto *bytes = reinterpret_cast<const unsigned char *>(pixel);
    file.insert(file.end(), bytes, bytes + sizeof pixel);
    for (const uint32_t flags : {SHD_LOAD_NONE, SHD_LOAD_LINEAR}) {
        const Loaded loaded(file, flags);
        assert_string_equal(shd_bitmap_get_color_space(loaded.bitmap), "Linear Rec.709");
        assert_memory_equal(loaded.floats(0, 0), pixel, sizeof pixel);
    }
}

/// Two pixels of lossless WebP, written by libwebp: (200, 30, 60) opaque, (10, 220, 40) with alpha 128. The decoder
/// rounds colours times alpha, so codes are right within one.
void test_webp_alpha(void **)
{
    const Bytes file = {0x52, 0x49, 0x46, 0x46, 0x22, 0x00, 0x00, 0x00, 0x57, 0x45, 0x42, 0x50, 0x56, 0x50,
                        0x38, 0x4c, 0x16, 0x00, 0x00, 0x00, 0x2f, 0x01, 0x00, 0x00, 0x10, 0x0f, 0x70, 0x21,
                        0xee, 0x2b, 0xf8, 0x9e, 0x02, 0xe5, 0x7f, 0x80, 0xd1, 0x82, 0x8c, 0xe8, 0x7f, 0x00};
    const int expected[8] = {200, 30, 60, 255, 10, 220, 40, 128};
    shd_load_desc desc = shd_load_desc_default();
    shd_bitmap *bitmap = nullptr;
    shd_image image = shd_image_default();
    const shd_result result = shd_bitmap_load_memory(g_context, file.data(), file.size(), &desc, &bitmap);
    if (result == SHD_ERROR_UNSUPPORTED) skip();  // built without WebP
    shd_assert_ok(result);
    shd_assert_ok(shd_bitmap_get_image(bitmap, &image));
    for (int i = 0; i < 8; ++i) {
        const int code = static_cast<const unsigned char *>(image.pixels)[i];
        assert_true(std::abs(code - expected[i]) <= (i < 4 || i == 7 ? 0 : 1));
    }
    shd_bitmap_release(bitmap);
}

/// SHD_LOAD_PREMULTIPLY: r, g and b of the base times alpha, averages of them in the levels, and the flag.
void test_premultiply(void **)
{
    std::vector<unsigned char> pixels;
    for (int i = 0; i < 16; ++i) {
        const unsigned char rows[4][4] = {{255, 188, 0, 255}, {255, 255, 255, 0}, {188, 0, 255, 51}, {1, 2, 3, 4}};
        pixels.insert(pixels.end(), rows[i % 4], rows[i % 4] + 4);
    }
    // The sRGB curve of 188/255 is .5028865, that of 1/255 to 3/255 is code / 255 / 12.92.
    const double expected[4][4] = {
        {1, .5028865, 0, 1},
        {0, 0, 0, 0},
        {.5028865 * .2, 0, .2, .2},
        {4 / (255 * 255 * 12.92), 8 / (255 * 255 * 12.92), 12 / (255 * 255 * 12.92), 4 / 255.}};
    shd_load_desc desc = shd_load_desc_default();
    shd_texture_info info = shd_texture_info_default();
    shd_sampler_desc plain = shd_sampler_desc_default();
    shd_sampler *sampler = nullptr;
    shd_texture *texture = nullptr;
    shd_assert_ok(shd_sampler_create(g_context, &plain, &sampler));
    const auto load = [&](const Bytes &file) {
        shd_texture_release(texture);
        shd_assert_ok(shd_texture_load_memory(g_context, file.data(), file.size(), &desc, &texture));
        shd_assert_ok(shd_texture_get_info(texture, &info));
    };
    const auto look_up = [&](float u, float v, float level) {
        std::array<float, 4> out = {};
        shd_lookups lookups = shd_lookups_default();
        shd_texels texels = shd_texels_default();
        lookups.count = 1;
        lookups.u = shd_f32_column(&u, 4), lookups.v = shd_f32_column(&v, 4), lookups.lod = shd_f32_column(&level, 4);
        for (size_t c = 0; c < 4; ++c) texels.channel[c] = shd_f32_out_column(&out[c], 4);
        shd_assert_ok(shd_texture_sample(texture, sampler, &lookups, &texels));
        return out;
    };
    desc.flags = SHD_LOAD_PREMULTIPLY;
    load(make_png(SHD_FORMAT_RGBA8_SRGB, 4, 4, pixels));
    assert_true(info.flags == SHD_TEXTURE_PREMULTIPLIED && info.format == SHD_FORMAT_RGBA16F);
    for (uint32_t x = 0; x < 4; ++x) {
        const auto got = look_up((float(x) + .5f) / 4, .5f, 0), mean = look_up(.5f, .5f, 2);
        for (size_t c = 0; c < 4; ++c) {
            const double all = (expected[0][c] + expected[1][c] + expected[2][c] + expected[3][c]) / 4;
            assert_true(std::fabs(double(got[c]) - expected[x][c]) <= expected[x][c] * 0x1p-11 + 0x1p-25);
            assert_true(std::fabs(double(mean[c]) - all) <= all * 0x1p-9);
        }
    }
    desc.flags |= SHD_LOAD_ALPHA_WEIGHTED;
    shd_assert_result("both", shd_texture_load_memory(g_context, pixels.data(), 1, &desc, &texture),
                      SHD_ERROR_INVALID_ARGUMENT, "load.flags: both SHD_LOAD_ALPHA_WEIGHTED and SHD_LOAD_PREMULTIPLY");
    desc.flags = SHD_LOAD_PREMULTIPLY;
    for (size_t i = 3; i < pixels.size(); i += 4) pixels[i] = 255;
    load(make_png(SHD_FORMAT_RGBA8_SRGB, 4, 4, pixels));
    assert_true(info.flags == SHD_TEXTURE_NONE && info.format == SHD_FORMAT_RGBA8_SRGB);
    shd_texture_release(texture);
    shd_sampler_release(sampler);
}

/// Files that are premultiplied give such textures: with any flag, the numbers are those of the file.
void test_premultiplied_file(void **)
{
    const std::vector<float> pixels = {.25f, .5f, 0, .5f, 2, 0, 0, 0};
    const Bytes file = make_file(SHD_FORMAT_RGBA32F, 2, 1, pixels, "premultiplied.exr");
    for (const uint32_t flags : {SHD_LOAD_NONE, SHD_LOAD_PREMULTIPLY, SHD_LOAD_ALPHA_WEIGHTED}) {
        shd_load_desc desc = shd_load_desc_default();
        shd_texture_info info = shd_texture_info_default();
        shd_image image = shd_image_default();
        shd_texture *texture = nullptr;
        std::vector<float> got(8);
        desc.flags = flags;
        shd_assert_ok(shd_texture_load_memory(g_context, file.data(), file.size(), &desc, &texture));
        shd_assert_ok(shd_texture_get_info(texture, &info));
        assert_int_equal(info.flags, SHD_TEXTURE_PREMULTIPLIED);
        image.format = info.format, image.width = 2, image.height = 1, image.pixels = got.data();
        shd_assert_ok(shd_texture_read_level(texture, 0, 0, &image));
        assert_true(got == pixels);
        shd_texture_release(texture);
    }
}

}  // namespace

int main()
{
    std::vector<CMUnitTest> tests;
    const auto add = [&](const char *name, CMUnitTestFunction body, const void *state) {
        tests.push_back({name, body, nullptr, nullptr, const_cast<void *>(state)});
    };
    void *state = nullptr;
    if (io_make_folder(&state) != 0 || shd_context_create(nullptr, &g_context) != SHD_OK) return 1;
    add("bmp/unused_byte", test_bmp, nullptr);
    for (const Order &order : k_orders) add(order.name, test_hdr, &order);
    add("hdr/xyze", test_hdr_xyze, nullptr);
    for (const Channels &c : k_channels) add(c.name, test_channels, &c);
    add("linear", test_linear, nullptr);
    add("alpha_weighted", test_alpha_weighted, nullptr);
    add("alpha_far", test_alpha_far, nullptr);
    add("tiff", test_tiff, nullptr);
    add("pfm", test_pfm, nullptr);
    add("webp_alpha", test_webp_alpha, nullptr);
    add("premultiply", test_premultiply, nullptr);
    add("premultiplied_file", test_premultiplied_file, nullptr);
    const int failed = _cmocka_run_group_tests("api.io_images", tests.data(), tests.size(), nullptr, nullptr);
    shd_context_release(g_context);
    io_remove_folder(&state);
    return failed;
}
