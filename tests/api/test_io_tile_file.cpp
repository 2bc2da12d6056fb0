// SPDX-License-Identifier: MIT
// Textures in tiled files against textures in memory that were made from the same levels; damaged files; UDIM sets.
#include <shd/shd.h>
#include <shd/tile_file.h>

#include <OpenImageIO/imageio.h>

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "support/check.h"

namespace
{

struct Kind {
    shd_format format;
    OIIO::TypeDesc::BASETYPE type;
    int channels;
};
constexpr Kind kKinds[] = {
    {SHD_FORMAT_R8, OIIO::TypeDesc::UINT8, 1},         {SHD_FORMAT_RG8, OIIO::TypeDesc::UINT8, 2},
    {SHD_FORMAT_RGB8_SRGB, OIIO::TypeDesc::UINT8, 3},  {SHD_FORMAT_RGB8, OIIO::TypeDesc::UINT8, 3},
    {SHD_FORMAT_RGBA8_SRGB, OIIO::TypeDesc::UINT8, 4}, {SHD_FORMAT_RGB16, OIIO::TypeDesc::UINT16, 3},
    {SHD_FORMAT_RGBA16, OIIO::TypeDesc::UINT16, 4},    {SHD_FORMAT_R16F, OIIO::TypeDesc::HALF, 1},
    {SHD_FORMAT_RGB16F, OIIO::TypeDesc::HALF, 3},      {SHD_FORMAT_RGBA16F, OIIO::TypeDesc::HALF, 4},
    {SHD_FORMAT_RGB32F, OIIO::TypeDesc::FLOAT, 3},     {SHD_FORMAT_RGBA32F, OIIO::TypeDesc::FLOAT, 4}};

shd_context *g_context;
std::string g_folder;

std::string in_folder(const std::string &name) { return g_folder + "/" + name; }

/// Packed texels of an image, and its levels by libshd.
struct Picture {
    Kind kind;
    uint32_t width, height;
    std::vector<std::vector<unsigned char>> levels;

    uint32_t side(uint32_t base, size_t level) const { return std::max(1u, base >> level); }
    shd_image image(size_t level)
    {
        shd_image image = shd_image_default();
        image.format = kind.format;
        image.width = side(width, level);
        image.height = side(height, level);
        image.pixels = levels[level].data();
        return image;
    }
};

Picture make_picture(const Kind &kind, uint32_t width, uint32_t height, uint32_t seed)
{
    Picture picture{kind, width, height, {}};
    std::mt19937 random(seed);
    std::vector<float> numbers(size_t{width} * height * static_cast<size_t>(kind.channels));
    for (float &number : numbers) number = static_cast<float>(random() % 1024) / 1023.0f;
    const size_t pixel = shd_format_size(kind.format);
    picture.levels.emplace_back(size_t{width} * height * pixel);
    OIIO::convert_types(OIIO::TypeFloat, numbers.data(), OIIO::TypeDesc(kind.type), picture.levels[0].data(),
                        static_cast<int>(numbers.size()));
    for (uint32_t l = 1; std::max(width, height) >> l; ++l) {
        picture.levels.emplace_back(size_t{picture.side(width, l)} * picture.side(height, l) * pixel);
    }
    std::vector<shd_image> images;
    for (size_t l = 0; l < picture.levels.size(); ++l) images.push_back(picture.image(l));
    const shd_mip_desc desc = shd_mip_desc_default();
    shd_assert_ok(shd_mip_build(g_context, &images[0], &desc, static_cast<uint32_t>(images.size()) - 1, &images[1]));
    return picture;
}

/// Writes levels as a tiled file, or only some of them.
void write_picture(Picture &picture, const std::string &path, int tile, size_t count, uint32_t wrong_level = 0)
{
    const auto out = OIIO::ImageOutput::create(path);
    const bool exr = path.find(".exr") != std::string::npos;
    for (size_t l = 0; l < count; ++l) {
        OIIO::ImageSpec spec(static_cast<int>(picture.side(picture.width, l)),
                             static_cast<int>(picture.side(picture.height, l)), picture.kind.channels,
                             OIIO::TypeDesc(picture.kind.type));
        if (l > 0 && l == wrong_level) spec.width = spec.full_width = spec.width - 1;
        spec.tile_width = tile;
        spec.tile_height = tile;
        spec.attribute("compression", "zip");
        spec.attribute("tiff:half", 1);
        spec.attribute("textureformat", "Plain Texture");
        spec.attribute("oiio:UnassociatedAlpha", exr ? 0 : 1);
        spec.attribute("openexr:levelmode", count > 1 ? 1 : 0);
        const bool srgb = picture.kind.format == SHD_FORMAT_RGB8_SRGB || picture.kind.format == SHD_FORMAT_RGBA8_SRGB;
        spec.attribute("oiio:ColorSpace", srgb ? "sRGB" : "Linear");
        const auto append =
            out->supports("mipmap") ? OIIO::ImageOutput::AppendMIPLevel : OIIO::ImageOutput::AppendSubimage;
        assert_true(out->open(path, spec, l == 0 ? OIIO::ImageOutput::Create : append));
        assert_true(out->write_image(spec.format, picture.levels[l].data()));
    }
    assert_true(out->close());
}

shd_texture *make_resident(Picture &picture, size_t count)
{
    std::vector<shd_image> levels;
    for (size_t l = 1; l < count; ++l) levels.push_back(picture.image(l));
    shd_texture_desc desc = shd_texture_desc_default();
    desc.format = picture.kind.format;
    desc.width = picture.width;
    desc.height = picture.height;
    desc.texels = picture.levels[0].data();
    desc.tables = SHD_TABLE_MIPMAP;
    desc.level_images = levels.data();
    desc.level_count = static_cast<uint32_t>(levels.size());
    shd_texture *texture = nullptr;
    shd_assert_ok(shd_texture_create(g_context, &desc, &texture));
    return texture;
}

shd_tile_cache *make_cache(uint32_t tile_bytes, uint64_t budget)
{
    shd_tile_cache_desc desc = shd_tile_cache_desc_default();
    desc.tile_bytes = tile_bytes;
    desc.budget_bytes = budget;
    shd_tile_cache *cache = nullptr;
    shd_assert_ok(shd_tile_cache_create(g_context, &desc, &cache));
    return cache;
}

shd_color_encoding encoding_of(const Kind &kind)
{
    const bool srgb = kind.format == SHD_FORMAT_RGB8_SRGB || kind.format == SHD_FORMAT_RGBA8_SRGB;
    return srgb ? SHD_COLOR_ENCODING_SRGB : SHD_COLOR_ENCODING_LINEAR;
}

shd_result open_texture(const std::string &path, shd_tile_cache *cache, shd_color_encoding encoding,
                        shd_texture **texture, shd_tile_file_info *info = nullptr)
{
    shd_tile_file_desc desc = shd_tile_file_desc_default();
    desc.cache = cache;
    desc.encoding = encoding;
    desc.max_readers = 3;
    desc.fill[0] = 0.25f;
    desc.fill[3] = 0.5f;
    return shd_texture_open(g_context, path.c_str(), &desc, texture, info);
}

/// Lookups of all sizes, everywhere.
struct Batch {
    std::vector<float> u, v, s, out[4];

    explicit Batch(size_t count, uint32_t seed = 1)
    {
        std::mt19937 random(seed);
        for (size_t i = 0; i < count; ++i) {
            u.push_back(static_cast<float>(random() % 4096) / 2048.0f - 0.5f);
            v.push_back(static_cast<float>(random() % 4096) / 2048.0f - 0.5f);
            s.push_back(1.0f / static_cast<float>(1u << random() % 12));
        }
        for (auto &channel : out) channel.resize(count);
    }

    shd_result look_up(const shd_texture *texture, shd_filter filter)
    {
        shd_sampler_desc desc = shd_sampler_desc_default();
        desc.filter = filter;
        shd_sampler *sampler = nullptr;
        shd_assert_ok(shd_sampler_create(g_context, &desc, &sampler));
        shd_lookups lookups = shd_lookups_default();
        lookups.count = u.size();
        lookups.u.data = u.data();
        lookups.v.data = v.data();
        lookups.dudx.data = s.data();
        lookups.dvdy.data = s.data();
        shd_texels texels = shd_texels_default();
        for (int c = 0; c < 4; ++c) texels.channel[c].data = out[c].data();
        const shd_result result = shd_texture_sample(texture, sampler, &lookups, &texels);
        shd_sampler_release(sampler);
        return result;
    }
};

void expect_same(const shd_texture *file, const shd_texture *resident, uint32_t seed = 1)
{
    for (const shd_filter filter : {SHD_FILTER_NEAREST, SHD_FILTER_TRILINEAR, SHD_FILTER_ANISOTROPIC}) {
        Batch a(800, seed), b(800, seed);
        shd_assert_ok(a.look_up(file, filter));
        shd_assert_ok(b.look_up(resident, filter));
        for (int c = 0; c < 4; ++c) assert_memory_equal(a.out[c].data(), b.out[c].data(), a.u.size() * sizeof(float));
    }
}

void gives_bits_of_memory(void **)
{
    shd_tile_cache *small = make_cache(1024, 1 << 18);
    shd_tile_cache *large = make_cache(65536, 1 << 22);
    for (const Kind &kind : kKinds) {
        for (const uint32_t size : {256u, 200u}) {
            Picture picture = make_picture(kind, size, size == 200 ? 120 : 256, 3);
            const size_t count = size == 200 ? 5 : picture.levels.size();
            for (const char *const name : {"a.tx", "a.exr"}) {
                if (name[2] == 'e' && kind.type != OIIO::TypeDesc::HALF && kind.type != OIIO::TypeDesc::FLOAT) continue;
                const std::string path = in_folder(name);
                const size_t kept = name[2] == 'e' ? picture.levels.size() : count;  // OpenEXR promises all of them
                write_picture(picture, path, size == 200 ? 48 : 64, kept);
                shd_texture *resident = make_resident(picture, kept);
                for (shd_tile_cache *const cache : {small, large}) {
                    shd_texture *texture = nullptr;
                    shd_tile_file_info info = shd_tile_file_info_default();
                    shd_assert_ok(open_texture(path, cache, encoding_of(kind), &texture, &info));
                    assert_int_equal(info.tile_width, size == 200 ? 48 : 64);
                    assert_int_equal(info.file_count, 1);
                    shd_texture_info flags = shd_texture_info_default();
                    const bool premultiplied = name[2] == 'e' && kind.channels == 4;
                    shd_assert_ok(shd_texture_get_info(texture, &flags));
                    assert_int_equal(flags.flags, premultiplied ? SHD_TEXTURE_PREMULTIPLIED : SHD_TEXTURE_NONE);
                    expect_same(texture, resident);
                    shd_texture_release(texture);
                }
                shd_texture_release(resident);
            }
        }
    }
    shd_tile_cache_release(small);
    shd_tile_cache_release(large);
}

std::vector<char> read_bytes(const std::string &path)
{
    std::ifstream file(path, std::ios::binary);
    return std::vector<char>(std::istreambuf_iterator<char>(file), {});
}
void write_bytes(const std::string &path, const char *bytes, size_t size)
{
    std::ofstream(path, std::ios::binary).write(bytes, static_cast<std::streamsize>(size));
}

void names_damage(void **)
{
    Picture picture = make_picture(kKinds[4], 512, 512, 5);
    const std::string path = in_folder("damaged.tx");
    write_picture(picture, path, 64, picture.levels.size());
    const std::vector<char> good = read_bytes(path);
    std::vector<char> bad = good;
    std::fill(bad.begin() + 100000, bad.begin() + 200000, '\x55');
    shd_tile_cache *cache = make_cache(16384, 1 << 20);
    shd_texture *texture = nullptr, *resident = make_resident(picture, picture.levels.size());
    shd_assert_ok(open_texture(path, cache, SHD_COLOR_ENCODING_AUTO, &texture));
    Batch batch(4000);
    // The same file, so that readers that are open see the damage.
    for (const size_t size : {bad.size(), size_t{150000}}) {
        write_bytes(path, bad.data(), size);
        assert_int_equal(batch.look_up(texture, SHD_FILTER_NEAREST), SHD_ERROR_CALLBACK);
        assert_non_null(strstr(shd_last_error(), "damaged.tx"));
        // The second one lacks the directories of its levels, too.
        if (size == bad.size()) assert_non_null(strstr(shd_last_error(), "mip level 0, columns"));
    }
    write_bytes(path, good.data(), good.size());
    expect_same(texture, resident);
    shd_texture_release(texture);
    shd_texture_release(resident);
    for (const size_t size : {size_t{0}, size_t{4}, size_t{100}, good.size() / 2, good.size() - 50}) {
        write_bytes(path, good.data(), size);
        texture = nullptr;
        if (open_texture(path, cache, SHD_COLOR_ENCODING_AUTO, &texture) == SHD_OK) {
            assert_int_not_equal(batch.look_up(texture, SHD_FILTER_TRILINEAR), SHD_OK);
            shd_texture_release(texture);
        } else {
            assert_non_null(strstr(shd_last_error(), "damaged.tx"));
            assert_null(texture);
        }
    }
    shd_tile_cache_release(cache);
}

void expect_refused(const std::string &path, shd_tile_cache *cache, shd_color_encoding encoding, shd_result code,
                    const char *text)
{
    shd_texture *texture = nullptr;
    assert_int_equal(open_texture(path, cache, encoding, &texture), code);
    assert_null(texture);
    if (!strstr(shd_last_error(), text)) fail_msg("\"%s\" does not contain \"%s\"", shd_last_error(), text);
}

void refuses(void **)
{
    shd_tile_cache *cache = make_cache(16384, 1 << 20);
    shd_texture *texture = nullptr;
    shd_tile_file_desc desc = shd_tile_file_desc_default();
    assert_int_equal(shd_texture_open(g_context, "a.tx", nullptr, &texture, nullptr), SHD_ERROR_INVALID_ARGUMENT);
    assert_int_equal(shd_texture_open(g_context, "a.tx", &desc, &texture, nullptr), SHD_ERROR_INVALID_ARGUMENT);
    assert_non_null(strstr(shd_last_error(), "tile_file.cache"));
    desc.cache = cache;
    assert_int_equal(shd_texture_open(nullptr, "a.tx", &desc, &texture, nullptr), SHD_ERROR_INVALID_ARGUMENT);
    assert_int_equal(shd_texture_open(g_context, nullptr, &desc, &texture, nullptr), SHD_ERROR_INVALID_ARGUMENT);
    assert_int_equal(shd_texture_open(g_context, "", &desc, &texture, nullptr), SHD_ERROR_INVALID_ARGUMENT);
    assert_int_equal(shd_texture_open(g_context, "a.tx", &desc, nullptr, nullptr), SHD_ERROR_INVALID_ARGUMENT);
    desc.max_readers = 5000;
    assert_int_equal(shd_texture_open(g_context, "a.tx", &desc, &texture, nullptr), SHD_ERROR_INVALID_ARGUMENT);
    assert_non_null(strstr(shd_last_error(), "max_readers"));
    Picture picture = make_picture(kKinds[5], 256, 128, 5);
    const std::string path = in_folder("odd.tx");
    const auto linear = SHD_COLOR_ENCODING_LINEAR;
    expect_refused(in_folder("absent.tx"), cache, linear, SHD_ERROR_NOT_FOUND, "absent.tx");
    write_picture(picture, path, 64, 1);
    expect_refused(path, cache, linear, SHD_ERROR_UNSUPPORTED, "no mip levels: convert it with shd-maketx");
    write_picture(picture, path, 0, 1);
    expect_refused(path, cache, linear, SHD_ERROR_UNSUPPORTED, "not tiled");
    write_picture(picture, path, 64, 4, 2);
    expect_refused(path, cache, linear, SHD_ERROR_UNSUPPORTED, "mip level 2 has 63 x 32 texels, not 64 x 32");
    write_picture(picture, path, 64, 9);
    expect_refused(path, cache, SHD_COLOR_ENCODING_SRGB, SHD_ERROR_UNSUPPORTED, "colour space \"sRGB\"");
    expect_refused(in_folder("none.<UDIM>.tx"), cache, linear, SHD_ERROR_NOT_FOUND, "none.<UDIM>.tx");
    expect_refused(in_folder("<UDIM>.<UDIM>.tx"), cache, linear, SHD_ERROR_INVALID_ARGUMENT, "one <UDIM>");
    write_picture(picture, in_folder("mixed.1001.tx"), 64, 9);
    Picture other = make_picture(kKinds[5], 128, 128, 5);
    write_picture(other, in_folder("mixed.1002.tx"), 64, 8);
    expect_refused(in_folder("mixed.<UDIM>.tx"), cache, linear, SHD_ERROR_UNSUPPORTED, "differ from those of");
    shd_tile_cache_release(cache);
}

/// The picture of a set of 2 x 2 files, of which the upper right one is absent.
Picture make_set(const Kind &kind, uint32_t side)
{
    Picture whole = make_picture(kind, 2 * side, 2 * side, 1);
    const size_t pixel = shd_format_size(kind.format);
    const char *const names[2][2] = {{"set.1011.tx", nullptr}, {"set.1001.tx", "set.1002.tx"}};
    for (uint32_t row = 0; row < 2; ++row) {
        for (uint32_t column = 0; column < 2; ++column) {
            Picture part = make_picture(kind, side, side, 7 + 2 * row + column);
            if (names[row][column]) write_picture(part, in_folder(names[row][column]), 64, part.levels.size());
            for (size_t l = 0; l < part.levels.size(); ++l) {
                const uint32_t size = part.side(side, l);
                for (uint32_t y = 0; y < size; ++y) {
                    for (uint32_t x = 0; x < size; ++x) {
                        unsigned char *to = &whole.levels[l][((row * size + y) * 2 * size + column * size + x) * pixel];
                        const unsigned char fill[] = {64, 0, 0, 128};
                        memcpy(to, names[row][column] ? &part.levels[l][(y * size + x) * pixel] : fill, pixel);
                    }
                }
            }
        }
    }
    return whole;
}

void reads_sets(void **)
{
    const Kind kind = {SHD_FORMAT_RGBA8, OIIO::TypeDesc::UINT8, 4};
    Picture whole = make_set(kind, 128);
    const size_t count = whole.levels.size() - 1;  // down to 2 x 2
    shd_texture *texture = nullptr, *resident = make_resident(whole, count);
    shd_tile_cache *cache = make_cache(1024, 1 << 18);
    shd_tile_file_info info = shd_tile_file_info_default();
    shd_assert_ok(open_texture(in_folder("set.<UDIM>.tx"), cache, SHD_COLOR_ENCODING_LINEAR, &texture, &info));
    assert_int_equal(info.column_count, 2);
    assert_int_equal(info.row_count, 2);
    assert_int_equal(info.file_count, 3);
    expect_same(texture, resident);
    shd_texture_release(texture);
    shd_texture_release(resident);
    shd_tile_cache_release(cache);
}

void reads_with_many_threads(void **)
{
    Picture picture = make_picture(kKinds[4], 1024, 512, 5);
    const std::string path = in_folder("threads.tx");
    write_picture(picture, path, 64, picture.levels.size());
    shd_tile_cache *cache = make_cache(4096, 1 << 18);  // tiles are evicted and read again
    shd_texture *texture = nullptr, *resident = make_resident(picture, picture.levels.size());
    shd_assert_ok(open_texture(path, cache, SHD_COLOR_ENCODING_AUTO, &texture));
    std::vector<std::thread> threads;
    std::vector<int> same(16);
    for (uint32_t t = 0; t < 16; ++t) {
        threads.emplace_back([&, t] {
            Batch a(2000, t), b(2000, t);
            bool equal = a.look_up(texture, SHD_FILTER_TRILINEAR) == SHD_OK &&
                         b.look_up(resident, SHD_FILTER_TRILINEAR) == SHD_OK;
            for (int c = 0; c < 4; ++c) equal = equal && a.out[c] == b.out[c];
            same[t] = equal;
        });
    }
    for (std::thread &thread : threads) thread.join();
    for (const int equal : same) assert_true(equal);
    shd_tile_cache_stats stats = shd_tile_cache_stats_default();
    shd_assert_ok(shd_tile_cache_get_stats(cache, &stats));
    assert_true(stats.loaded_tile_count > stats.tile_count);  // some were read again
    shd_texture_release(texture);
    shd_texture_release(resident);
    shd_tile_cache_release(cache);
}

int set_up(void **)
{
    char folder[] = "/tmp/shd_texture_file_XXXXXX";
    if (!mkdtemp(folder)) return -1;
    g_folder = folder;
    return shd_context_create(nullptr, &g_context) == SHD_OK ? 0 : -1;
}

int tear_down(void **)
{
    shd_context_release(g_context);
    for (const char *const name : {"a.tx", "a.exr", "damaged.tx", "odd.tx", "mixed.1001.tx", "mixed.1002.tx",
                                   "set.1001.tx", "set.1002.tx", "set.1011.tx", "threads.tx"}) {
        (void)!unlink(in_folder(name).c_str());
    }
    return rmdir(g_folder.c_str());
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {cmocka_unit_test(gives_bits_of_memory), cmocka_unit_test(names_damage),
                                cmocka_unit_test(refuses), cmocka_unit_test(reads_sets),
                                cmocka_unit_test(reads_with_many_threads)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
