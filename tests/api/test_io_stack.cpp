// SPDX-License-Identifier: MIT
// Stacks of images as 3D textures: numbered files and pages of one file, texel for texel; slices that differ, files
// that are cut off, limits and descs.
#include <OpenImageIO/half.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <string>
#include <vector>

#include <shd/shd.h>

#include "support/loads.h"
#include "support/volume_files.h"

namespace
{

const auto kU8 = OIIO::TypeDesc::UINT8, kU16 = OIIO::TypeDesc::UINT16;
const auto kHalf = OIIO::TypeDesc::HALF, kFloat = OIIO::TypeDesc::FLOAT;
using Bytes = std::vector<unsigned char>;

shd_context *g_context;

/// Slices of one kind. All numbers are exact in every type.
struct Stack {
    const char *name;  // ends with the extension of its files
    OIIO::TypeDesc::BASETYPE type;
    int channels;
    shd_format format;  // the texture's
    int width = 7, height = 5, depth = 4;
    int tile = 0;
};

const Stack k_stacks[] = {
    {"grey.png", kU8, 1, SHD_FORMAT_R8},
    {"words.png", kU16, 1, SHD_FORMAT_R16},
    {"rgb.png", kU8, 3, SHD_FORMAT_RGBA8},
    {"rgba_words.png", kU16, 4, SHD_FORMAT_RGBA16},
    {"half.exr", kHalf, 1, SHD_FORMAT_R16F},
    {"float.exr", kFloat, 1, SHD_FORMAT_R32F},
    {"rgba_half.exr", kHalf, 4, SHD_FORMAT_RGBA16F},
    {"tiles.exr", kFloat, 1, SHD_FORMAT_R32F, 37, 21, 3, 16},
    {"grey.tif", kU8, 1, SHD_FORMAT_R8},
    {"words.tif", kU16, 1, SHD_FORMAT_R16},
    {"float.tif", kFloat, 1, SHD_FORMAT_R32F},
    {"rgb_float.tif", kFloat, 3, SHD_FORMAT_RGBA32F},
    {"rgb.tif", kU8, 3, SHD_FORMAT_RGBA8},
    {"many.tif", kU8, 1, SHD_FORMAT_R8, 3, 2, 300},
};

bool has_pages(const Stack &stack) { return !std::strstr(stack.name, ".png"); }

/// Numbers of slice z, multiples of 1/255 for 8 bits and of 1/65535 or 1/256 for others.
std::vector<float> numbers_of(const Stack &stack, int z)
{
    std::vector<float> out(static_cast<size_t>(stack.width) * stack.height * stack.channels);
    for (size_t i = 0; i < out.size(); ++i) {
        const auto code = static_cast<float>((i * 37 + static_cast<size_t>(z) * 101 + i / 3) % 251);
        out[i] = stack.type == kU8 ? code / 255.0f : stack.type == kU16 ? code * 257.0f / 65535.0f : code / 256.0f;
    }
    return out;
}

OIIO::ImageSpec spec_of(const Stack &stack)
{
    OIIO::ImageSpec spec(stack.width, stack.height, stack.channels, stack.type);
    spec.tile_width = spec.tile_height = stack.tile;
    if (stack.channels == 4) spec.attribute("oiio:UnassociatedAlpha", 1);
    return spec;
}

void write_slice(const std::string &path, const Stack &stack, int z)
{
    const auto out = OIIO::ImageOutput::create(path);
    assert_true(out && out->open(path, spec_of(stack)));
    assert_true(out->write_image(OIIO::TypeFloat, numbers_of(stack, z).data()));
    assert_true(out->close());
}

/// One file with a page for each slice; page `other`, if any, is one of `different`.
std::string write_pages(const Stack &stack, int other = -1, const Stack *different = nullptr)
{
    const std::string path = io_path((std::string("pages_") + stack.name).c_str());
    const auto out = OIIO::ImageOutput::create(path);
    std::vector<OIIO::ImageSpec> specs;
    for (int z = 0; z < stack.depth; ++z) specs.push_back(spec_of(z == other ? *different : stack));
    assert_true(out != nullptr);
    if (std::strstr(stack.name, ".exr")) {
        assert_true(out->open(path, stack.depth, specs.data()));
    } else {
        assert_true(out->open(path, specs[0]));
    }
    for (int z = 0; z < stack.depth; ++z) {
        const size_t at = static_cast<size_t>(z);
        if (z > 0) assert_true(out->open(path, specs[at], OIIO::ImageOutput::AppendSubimage));
        assert_true(out->write_image(OIIO::TypeFloat, numbers_of(z == other ? *different : stack, z).data()));
    }
    assert_true(out->close());
    return path;
}

/// A number as the texture stores it.
void store(const Stack &stack, float value, unsigned char *out)
{
    const auto byte = static_cast<unsigned char>(value * 255.0f + 0.5f);
    const auto word = static_cast<uint16_t>(value * 65535.0f + 0.5f);
    const half half_value(value);
    switch (stack.type) {
        case kU8: std::memcpy(out, &byte, 1); break;
        case kU16: std::memcpy(out, &word, 2); break;
        case kHalf: std::memcpy(out, &half_value, 2); break;
        default: std::memcpy(out, &value, 4); break;
    }
}

/// Texels of slices [first, depth).
Bytes expected_texels(const Stack &stack, int first, bool flipped)
{
    const size_t size = OIIO::TypeDesc(stack.type).size(), stored = stack.channels == 1 ? 1 : 4;
    Bytes out;
    for (int z = first; z < stack.depth; ++z) {
        const std::vector<float> numbers = numbers_of(stack, z);
        for (int y = 0; y < stack.height; ++y) {
            const int row = flipped ? stack.height - 1 - y : y;
            for (int x = 0; x < stack.width; ++x) {
                for (size_t c = 0; c < stored; ++c) {
                    const int channel = static_cast<int>(c);
                    unsigned char bytes[4];
                    const int at = (row * stack.width + x) * stack.channels + channel;
                    store(stack, channel < stack.channels ? numbers[static_cast<size_t>(at)] : 1.0f, bytes);
                    out.insert(out.end(), bytes, bytes + size);
                }
            }
        }
    }
    return out;
}

void check_texture(const Stack &stack, int first, bool flipped, shd_texture *texture)
{
    shd_texture_info info;
    const io_bytes got = io_read_texels(texture, &info);
    const Bytes want = expected_texels(stack, first, flipped);
    assert_int_equal(info.format, stack.format);
    assert_int_equal(info.width, stack.width);
    assert_int_equal(info.height, stack.height);
    assert_int_equal(info.depth, stack.depth - first);
    assert_int_equal(got.size, want.size());
    assert_memory_equal(got.data, want.data(), want.size());
    std::free(got.data);
    shd_texture_release(texture);
}

std::string pattern_of(const Stack &stack) { return io_path((std::string("slice_%04d_") + stack.name).c_str()); }

std::string slice_path(const Stack &stack, int number)
{
    char name[80];
    std::snprintf(name, sizeof name, "slice_%04d_%s", number, stack.name);
    return io_path(name);
}

shd_result load_pages(const std::string &path, const shd_load_desc *load, shd_texture **texture)
{
    const char *const list[1] = {path.c_str()};
    shd_stack_desc desc = shd_stack_desc_default();
    desc.paths = list;
    desc.path_count = 1;
    return load_stack(g_context, &desc, load, texture);
}

const uint32_t k_flags[] = {0, SHD_LOAD_IN_PROCESS, SHD_LOAD_FLIP_V, SHD_LOAD_IN_PROCESS | SHD_LOAD_FLIP_V,
                            SHD_LOAD_PARTIAL};

/// Files of a pattern from number 9 on, and the same files as a list.
void test_files(void **state)
{
    const Stack &stack = *static_cast<const Stack *>(*state);
    std::vector<std::string> paths;
    std::vector<const char *> list;
    const std::string pattern = pattern_of(stack);
    for (int z = 0; z < stack.depth; ++z) {
        paths.push_back(slice_path(stack, 9 + z));
        write_slice(paths.back(), stack, z);
    }
    for (const std::string &path : paths) list.push_back(path.c_str());
    for (const uint32_t flags : k_flags) {
        shd_stack_desc desc = shd_stack_desc_default();
        shd_load_desc load = shd_load_desc_default();
        shd_texture *texture = nullptr;
        load.flags = flags;
        desc.pattern = pattern.c_str();
        desc.first = 9;
        desc.last = 8 + static_cast<uint32_t>(stack.depth);
        shd_assert_ok(load_stack(g_context, &desc, &load, &texture));
        check_texture(stack, 0, (flags & SHD_LOAD_FLIP_V) != 0, texture);
        desc = shd_stack_desc_default();
        desc.paths = list.data();
        desc.path_count = static_cast<uint32_t>(list.size());
        shd_assert_ok(load_stack(g_context, &desc, &load, &texture));
        check_texture(stack, 0, (flags & SHD_LOAD_FLIP_V) != 0, texture);
    }
}

/// All pages of a file, and those from page 1 on.
void test_pages(void **state)
{
    const Stack &stack = *static_cast<const Stack *>(*state);
    const std::string path = write_pages(stack);
    for (const uint32_t flags : k_flags) {
        for (int first = 0; first < 2; ++first) {
            shd_load_desc load = shd_load_desc_default();
            shd_texture *texture = nullptr;
            load.flags = flags;
            load.subimage = static_cast<uint32_t>(first);
            shd_assert_ok(load_pages(path, &load, &texture));
            check_texture(stack, first, (flags & SHD_LOAD_FLIP_V) != 0, texture);
        }
    }
}

/// A slice that differs from the others, as a file and as a page.
struct Mismatch {
    const char *name;
    Stack stack, other;
    const char *file_message;
    const char *page_message;  // null = the format has no such pages
};
const Mismatch k_mismatches[] = {
    {"mismatch/width",
     {"a.tif", kU8, 1, SHD_FORMAT_R8},
     {"a.tif", kU8, 1, SHD_FORMAT_R8, 8},
     "slice 2 has 8 x 5 pixels",
     "slice 2 has 8 x 5 pixels, slice 0 has 7 x 5"},
    {"mismatch/height",
     {"b.exr", kHalf, 1, SHD_FORMAT_R16F},
     {"b.exr", kHalf, 1, SHD_FORMAT_R16F, 7, 4},
     "slice 2 has 7 x 4 pixels",
     nullptr},
    {"mismatch/type",
     {"c.tif", kU8, 1, SHD_FORMAT_R8},
     {"c.tif", kU16, 1, SHD_FORMAT_R16},
     "of format 12, slice 0",
     "slice 2 has other channels or tiles than slice 0"},
    {"mismatch/channels",
     {"d.exr", kFloat, 1, SHD_FORMAT_R32F},
     {"d.exr", kFloat, 3, SHD_FORMAT_RGBA32F},
     "of format 5, slice 0",
     "slice 2 has other channels or tiles than slice 0"},
    {"mismatch/png",
     {"e.png", kU8, 1, SHD_FORMAT_R8},
     {"e.png", kU8, 3, SHD_FORMAT_RGBA8},
     "of format 2, slice 0",
     nullptr},
};

void test_mismatch(void **state)
{
    const Mismatch &c = *static_cast<const Mismatch *>(*state);
    const std::string pattern = pattern_of(c.stack);
    shd_stack_desc desc = shd_stack_desc_default();
    desc.pattern = pattern.c_str();
    desc.last = 3;
    for (int z = 0; z < c.stack.depth; ++z) write_slice(slice_path(c.stack, z), z == 2 ? c.other : c.stack, z);
    for (const uint32_t flags : {0u, uint32_t{SHD_LOAD_IN_PROCESS}}) {
        shd_load_desc load = shd_load_desc_default();
        shd_texture *texture = reinterpret_cast<shd_texture *>(g_context);
        load.flags = flags;
        shd_assert_result(c.name, load_stack(g_context, &desc, &load, &texture), SHD_ERROR_CORRUPT, c.file_message);
        assert_null(texture);
        if (!c.page_message) continue;
        shd_assert_result(c.name, load_pages(write_pages(c.stack, 2, &c.other), &load, &texture), SHD_ERROR_CORRUPT,
                          c.page_message);
        assert_null(texture);
    }
}

/// Files of pages that are cut off are refused, unless the missing bytes have no effect.
void test_cut(void **state)
{
    const Stack &stack = *static_cast<const Stack *>(*state);
    const io_bytes whole = io_read(write_pages(stack).c_str());
    const Bytes texels = expected_texels(stack, 0, false);
    size_t loaded = 0, count = 0;
    const size_t step = whole.size / 90 + 1;
    for (size_t size = 1; size < whole.size; size += size + 2 * step < whole.size ? step : 1) {
        shd_load_desc load = shd_load_desc_default();
        shd_texture *texture = nullptr;
        const std::string path = io_path((std::string("cut_") + stack.name).c_str());
        io_write(path.c_str(), whole.data, size);
        load.flags = ++count % 16 == 0 ? 0 : SHD_LOAD_IN_PROCESS;
        const shd_result result = load_pages(path, &load, &texture);
        if (result != SHD_OK) {
            assert_true(result == SHD_ERROR_CORRUPT || result == SHD_ERROR_UNSUPPORTED || result == SHD_ERROR_LIMIT);
            assert_null(texture);
            continue;
        }
        ++loaded;
        check_texture(stack, 0, false, texture);
    }
    print_message("%s: %zu of %zu truncations load\n", stack.name, loaded, count);
    std::free(whole.data);
}

/// A chain of `pages` directories of one strip each; the last one refers to `next`.
Bytes make_chain(uint32_t pages, uint32_t next)
{
    static const uint32_t entries[9][3] = {{256, 4, 1},  {257, 4, 1}, {258, 3, 8}, {259, 3, 1}, {262, 3, 1},
                                           {273, 4, 10}, {277, 3, 1}, {278, 4, 1}, {279, 4, 1}};
    Bytes file = {'I', 'I', 42, 0, 12, 0, 0, 0, 1, 0, 77, 0};
    const auto put = [&](uint32_t value, int count) {
        for (int i = 0; i < count; ++i) file.push_back(static_cast<unsigned char>(value >> 8 * i));
    };
    for (uint32_t page = 0; page < pages; ++page) {
        put(9, 2);
        for (const auto &entry : entries) {
            put(entry[0], 2);
            put(entry[1], 2);
            put(1, 4);
            put(entry[2], 4);
        }
        put(page + 1 < pages ? static_cast<uint32_t>(file.size()) + 4 : next, 4);
    }
    return file;
}

struct ChainCase {
    const char *name;
    uint32_t pages, next, subimage;
    shd_result expected;
    const char *message;
};
const ChainCase k_chains[] = {
    {"chain/most", 1024, 0, 0, SHD_OK, ""},
    {"chain/too_many", 1025, 0, 0, SHD_ERROR_LIMIT, "TIFF: more than 1024 pages"},
    {"chain/circle", 3, 12, 0, SHD_ERROR_CORRUPT, "TIFF: strips or tiles beyond the end"},
    {"chain/beyond", 3, 100000, 0, SHD_ERROR_CORRUPT, "TIFF: page 3 is cut off"},
    {"chain/no_page", 3, 0, 3, SHD_ERROR_NOT_FOUND, "load.subimage: the file has no part 3"},
};

void test_chain(void **state)
{
    const ChainCase &c = *static_cast<const ChainCase *>(*state);
    const Bytes file = make_chain(c.pages, c.next);
    const std::string path = io_path("chain.tif");
    io_write(path.c_str(), file.data(), file.size());
    for (const uint32_t flags : {0u, uint32_t{SHD_LOAD_IN_PROCESS}}) {
        shd_load_desc load = shd_load_desc_default();
        shd_texture_info info;
        shd_texture *texture = nullptr;
        load.flags = flags;
        load.subimage = c.subimage;
        shd_assert_result(c.name, load_pages(path, &load, &texture), c.expected, c.message);
        if (c.expected != SHD_OK) continue;
        const io_bytes texels = io_read_texels(texture, &info);
        assert_int_equal(info.depth, c.pages);
        assert_true(std::all_of(texels.data, texels.data + texels.size, [](unsigned char v) { return v == 77; }));
        std::free(texels.data);
        shd_texture_release(texture);
    }
}

/// Changes of a good desc for the stack of four bytes files, and of its load desc.
struct BadCase {
    const char *name;
    shd_result expected;
    const char *message;
    void (*change)(shd_stack_desc &desc, shd_load_desc &load);
};
const char *const k_null[2] = {"a", nullptr}, *const k_empty[2] = {"a", ""};
#define CHANGE [](shd_stack_desc & desc, shd_load_desc & load) -> void
#define ARGUMENT SHD_ERROR_INVALID_ARGUMENT
#define PLACES ARGUMENT, "does not have one place %d, %5d or %05d"

const BadCase k_bad[] = {{"bad/nothing", SHD_OK, "", CHANGE{(void)desc, (void)load;
}  // namespace
}
, {"bad/no_files", ARGUMENT, "stack.pattern: NULL, and no paths", CHANGE{(void)load, desc.pattern = nullptr;
}
}
, {"bad/both", ARGUMENT, "stack.pattern: given together with paths",
   CHANGE{(void)load, desc.paths = k_null, desc.path_count = 1;
}
}
, {"bad/null_paths", ARGUMENT, "stack.paths: NULL, but path_count is 3", CHANGE{(void)load, desc.path_count = 3;
}
}
, {"bad/null_path", ARGUMENT, "stack.paths[1]: NULL",
   CHANGE{(void)load, desc.pattern = nullptr, desc.paths = k_null, desc.path_count = 2;
}
}
, {"bad/empty_path", ARGUMENT, "stack.paths[1]: empty",
   CHANGE{(void)load, desc.pattern = nullptr, desc.paths = k_empty, desc.path_count = 2;
}
}
, {"bad/path_count", ARGUMENT, "stack.path_count: 65537 is not in 0..65536",
   CHANGE{(void)load, desc.path_count = 65537, desc.paths = k_null;
}
}
, {"bad/no_place", ARGUMENT, "has no place", CHANGE{(void)load, desc.pattern = "slice";
}
}
, {"bad/percent", ARGUMENT, "has no place", CHANGE{(void)load, desc.pattern = "100%%d";
}
}
, {"bad/two_places", PLACES, CHANGE{(void)load, desc.pattern = "%d_%d";
}
}
, {"bad/text_place", PLACES, CHANGE{(void)load, desc.pattern = "%s";
}
}
, {"bad/write_place", PLACES, CHANGE{(void)load, desc.pattern = "%n";
}
}
, {"bad/wide_place", PLACES, CHANGE{(void)load, desc.pattern = "%010d";
}
}
, {"bad/zero_place", PLACES, CHANGE{(void)load, desc.pattern = "%0d";
}
}
, {"bad/open_place", PLACES, CHANGE{(void)load, desc.pattern = "slice%";
}
}
, {"bad/order", ARGUMENT, "stack.last: 1 is not in first..first + 65535, first is 2",
   CHANGE{(void)load, desc.first = 2, desc.last = 1;
}
}
, {"bad/too_many", ARGUMENT, "stack.last: 65536 is not in", CHANGE{(void)load, desc.last = 65536;
}
}
, {"bad/absent", SHD_ERROR_NOT_FOUND, "slice_0004_bad.png", CHANGE{(void)load, desc.last = 4;
}
}
, {"bad/levels", SHD_ERROR_UNSUPPORTED, "load.flags: bits 0x8 have no meaning for a stack",
   CHANGE{(void)desc, load.flags = SHD_LOAD_FILE_LEVELS;
}
}
, {"bad/tables", SHD_ERROR_UNSUPPORTED, "load.tables: 0x2", CHANGE{(void)desc, load.tables = SHD_TABLE_RIPMAP;
}
}
, {"bad/slice_pixels", SHD_ERROR_LIMIT, "above load.max_pixels 34", CHANGE{(void)desc, load.max_pixels = 34;
}
}
, {"bad/pixels", SHD_ERROR_LIMIT, "volume of 7 x 5 x 4 voxels is above load.max_pixels 139",
   CHANGE{(void)desc, load.max_pixels = 139;
}
}
, {"bad/bytes", SHD_ERROR_LIMIT, "140 decoded bytes are above load.max_bytes 139",
   CHANGE{(void)desc, load.max_bytes = 139;
}
}
, {"bad/enough", SHD_OK, "", CHANGE{(void)desc, load.max_pixels = load.max_bytes = 140;
}
}
, {"bad/srgb", SHD_OK, "", CHANGE{(void)desc, load.encoding = SHD_COLOR_ENCODING_SRGB;
}
}
,
}
;

void test_bad(void **state)
{
    const BadCase &c = *static_cast<const BadCase *>(*state);
    const Stack stack = {"bad.png", kU8, 1, SHD_FORMAT_R8};
    const std::string pattern = pattern_of(stack);
    shd_stack_desc desc = shd_stack_desc_default();
    shd_load_desc load = shd_load_desc_default();
    shd_texture *texture = reinterpret_cast<shd_texture *>(g_context);
    for (int z = 0; z < stack.depth; ++z) write_slice(slice_path(stack, z), stack, z);
    desc.pattern = pattern.c_str();
    desc.last = 3;
    c.change(desc, load);
    shd_assert_result(c.name, load_stack(g_context, &desc, &load, &texture), c.expected, c.message);
    assert_true((texture != nullptr) == (c.expected == SHD_OK));
    if (texture && load.encoding == SHD_COLOR_ENCODING_SRGB) {
        Stack encoded = stack;
        encoded.format = SHD_FORMAT_R8_SRGB;
        check_texture(encoded, 0, false, texture);
    } else {
        shd_texture_release(texture);
    }
}

/// Budgets of pages, numbers that are not padded, and sRGB without bytes.
void test_others(void **)
{
    const Stack stack = {"others.tif", kU16, 1, SHD_FORMAT_R16};
    const std::string path = write_pages(stack), pattern = io_path("%%%2d.tif");
    shd_load_desc load = shd_load_desc_default();
    shd_stack_desc desc = shd_stack_desc_default();
    shd_texture *texture = nullptr;
    load.max_pixels = 139;
    shd_assert_result("pages", load_pages(path, &load, &texture), SHD_ERROR_LIMIT,
                      "volume of 7 x 5 x 4 voxels is above load.max_pixels 139");
    load.max_pixels = 140;
    load.max_bytes = 279;
    shd_assert_result("pages", load_pages(path, &load, &texture), SHD_ERROR_LIMIT, "above load.max_bytes 279");
    load.max_bytes = 280;
    shd_assert_ok(load_pages(path, &load, &texture));
    check_texture(stack, 0, false, texture);
    load.encoding = SHD_COLOR_ENCODING_SRGB;
    shd_assert_result("sRGB", load_pages(path, &load, &texture), SHD_ERROR_UNSUPPORTED,
                      "load.encoding: SRGB, but the slices are not of 8 bits");
    write_slice(io_path("% 9.tif"), stack, 0);
    write_slice(io_path("%10.tif"), stack, 1);
    desc.pattern = pattern.c_str();
    desc.first = 9;
    desc.last = 10;
    shd_assert_ok(load_stack(g_context, &desc, nullptr, &texture));
    Stack two = stack;
    two.depth = 2;
    check_texture(two, 0, false, texture);
    shd_assert_result("context", load_stack(nullptr, &desc, nullptr, &texture), ARGUMENT, "context: NULL");
    shd_assert_result("out", load_stack(g_context, &desc, nullptr, nullptr), ARGUMENT, "out_texture: NULL");
}

}  // namespace

int main()
{
    std::vector<CMUnitTest> tests;
    std::vector<std::string> names;
    void *state = nullptr;
    names.reserve(3 * std::size(k_stacks));
    const auto add = [&](const char *name, CMUnitTestFunction test, const void *row) {
        tests.push_back({name, test, nullptr, nullptr, const_cast<void *>(row)});
    };
    for (const Stack &stack : k_stacks) {
        if (stack.depth < 10) add(names.emplace_back(std::string("files/") + stack.name).c_str(), test_files, &stack);
        if (!has_pages(stack)) continue;
        add(names.emplace_back(std::string("pages/") + stack.name).c_str(), test_pages, &stack);
        if (stack.depth < 10) add(names.emplace_back(std::string("cut/") + stack.name).c_str(), test_cut, &stack);
    }
    for (const Mismatch &row : k_mismatches) add(row.name, test_mismatch, &row);
    for (const ChainCase &row : k_chains) add(row.name, test_chain, &row);
    for (const BadCase &row : k_bad) add(row.name, test_bad, &row);
    add("others", test_others, nullptr);
    if (io_make_folder(&state) != 0 || shd_context_create(nullptr, &g_context) != SHD_OK) return 1;
    const int failed = _cmocka_run_group_tests("api.io_stack", tests.data(), tests.size(), nullptr, nullptr);
    io_remove_folder(&state);
    shd_context_release(g_context);
    return failed;
}
