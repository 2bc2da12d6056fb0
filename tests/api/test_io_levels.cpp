// SPDX-License-Identifier: MIT
// Mip levels of files: OpenImageIO and this test write files whose levels are no averages of their base. A level must
// have the bits of the base of a file that holds this level alone.
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <string>
#include <vector>

#include <shd/shd.h>

#include "support/fault_allocator.h"
#include "support/io_files.h"

namespace
{

enum { kRoundUp = 1, kUntagged = 2, kOtherSize = 4, kOffset = 8, kOtherType = 16, kBlocks = 32, kMissing = 64 };

/// A file of `levels` mip levels; the first one is level `first` of a base of width x height.
struct File {
    const char *name;
    int width, height, levels;
    OIIO::TypeDesc::BASETYPE type;
    int channels;
    int traits;
};

shd_context *g_context;

int side(int base, int level, bool up)
{
    for (; level > 0; --level) base = std::max(1, (base + up) / 2);
    return base;
}

/// Texels of a level, each level with a pattern of its own.
std::vector<float> texels_of(int width, int height, int channels, int level)
{
    std::vector<float> out(static_cast<size_t>(width) * height * channels);
    for (size_t i = 0; i < out.size(); ++i) {
        out[i] = static_cast<float>((i * 7 + static_cast<size_t>(level) * 61 + i / 5) % 256) / 255;
    }
    return out;
}

void put32(std::vector<unsigned char> &to, size_t at, uint32_t value)
{
    for (size_t i = 0; i < 4; ++i) to[at + i] = static_cast<unsigned char>(value >> 8 * i);
}

/// BGRA texels or blocks of DXT1 behind a Direct3D 9 header (Microsoft, "Programming Guide for DDS").
void write_dds(const File &file, const std::string &path, int first)
{
    std::vector<unsigned char> bytes(128);
    std::copy_n("DDS ", 4, bytes.begin());
    put32(bytes, 4, 124);
    put32(bytes, 8, 0x2100f);
    put32(bytes, 12, static_cast<uint32_t>(side(file.height, first, false)));
    put32(bytes, 16, static_cast<uint32_t>(side(file.width, first, false)));
    put32(bytes, 28, static_cast<uint32_t>(file.levels));
    put32(bytes, 76, 32);
    put32(bytes, 80, file.traits & kBlocks ? 4 : 0x41);
    if (file.traits & kBlocks) std::copy_n("DXT1", 4, bytes.begin() + 84);
    put32(bytes, 88, 32);
    put32(bytes, 92, 0xff0000);
    put32(bytes, 96, 0xff00);
    put32(bytes, 100, 0xff);
    put32(bytes, 104, 0xff000000);
    put32(bytes, 108, 0x401008);
    for (int l = first; l < first + file.levels; ++l) {
        const int width = side(file.width, l, false), height = side(file.height, l, false);
        const bool blocks = (file.traits & kBlocks) != 0;
        for (const float value :
             blocks ? texels_of((width + 3) / 4, (height + 3) / 4, 8, l) : texels_of(width, height, 4, l)) {
            bytes.push_back(static_cast<unsigned char>(value * 255 + 0.5f));
        }
    }
    io_write(path.c_str(), bytes.data(), bytes.size());
}

OIIO::ImageSpec spec_of(const File &file, int level)
{
    const bool up = (file.traits & kRoundUp) != 0;
    OIIO::ImageSpec spec(side(file.width, level, up), side(file.height, level, up), file.channels, file.type);
    if ((file.traits & kOtherSize) && level == 1) spec.width = spec.full_width = spec.width + 1;
    if ((file.traits & kOtherType) && level == 1) spec.set_format(OIIO::TypeUInt16);
    spec.tile_width = spec.tile_height = 16;
    if (file.traits & kOffset) {
        spec.x = 2;
        spec.full_width += 2;
    }
    spec.attribute("openexr:roundingmode", up ? 1 : 0);
    const bool tagged = file.levels > 1 || (file.traits & kMissing);
    if (tagged) spec.attribute("openexr:levelmode", 1);
    if (tagged && !(file.traits & kUntagged)) spec.attribute("textureformat", "Plain Texture");
    return spec;
}

/// Writes levels [first, first + file.levels).
std::string write_file(const File &file, int first)
{
    const std::string name = file.name;
    const std::string kind = name.substr(0, name.find('/'));
    const std::string path = io_path(("file." + kind).c_str());
    if (kind == "dds") {
        write_dds(file, path, first);
        return path;
    }
    const auto out = OIIO::ImageOutput::create(path);
    assert_true(out != nullptr);
    for (int l = first; l < first + file.levels; ++l) {
        OIIO::ImageSpec spec = spec_of(file, l);
        if (!out->supports("tiles")) spec.tile_width = spec.tile_height = 0;
        // OpenImageIO's writer of TIFF appends pages; its reader takes the pages of a tagged file as levels.
        const auto append = kind == "exr" ? OIIO::ImageOutput::AppendMIPLevel : OIIO::ImageOutput::AppendSubimage;
        const auto mode = l > first ? append : OIIO::ImageOutput::Create;
        const bool opened = out->open(path, spec, mode);
        if (!opened) fail_msg("%s: %s", file.name, out->geterror().c_str());
        const std::vector<float> texels = texels_of(spec.width, spec.height, file.channels, l);
        assert_true(out->write_image(OIIO::TypeFloat, texels.data()));
    }
    assert_true(out->close());
    return path;
}

struct Texels {
    shd_texture_info info;
    std::vector<std::vector<unsigned char>> levels;
};

/// Reads all levels of a texture and releases it.
Texels take_texels(shd_texture *texture)
{
    Texels out = {shd_texture_info_default(), {}};
    shd_assert_ok(shd_texture_get_info(texture, &out.info));
    for (uint32_t l = 0; l < out.info.level_count; ++l) {
        shd_image image = shd_image_default();
        image.format = out.info.format;
        image.width = std::max(1u, out.info.width >> l);
        image.height = std::max(1u, out.info.height >> l);
        const size_t block = shd_format_block_size(image.format);
        out.levels.emplace_back(block ? block * ((image.width + 3) / 4) * ((image.height + 3) / 4)
                                      : shd_format_size(image.format) * image.width * image.height);
        image.pixels = out.levels.back().data();
        shd_assert_ok(shd_texture_read_level(texture, 0, l, &image));
    }
    shd_texture_release(texture);
    return out;
}

shd_load_desc load_desc(uint32_t flags)
{
    shd_load_desc desc = shd_load_desc_default();
    desc.flags = flags;
    return desc;
}

Texels load(const std::string &path, uint32_t flags)
{
    const shd_load_desc desc = load_desc(flags);
    shd_texture *texture = nullptr;
    shd_assert_ok(shd_texture_load(g_context, path.c_str(), &desc, &texture));
    return take_texels(texture);
}

/// The files. `expected` levels of the texture; 0 = refused with `message`, -1 = all levels, built by shd.
struct Case {
    File file;
    int expected;
    const char *message;
};

const auto kU8 = OIIO::TypeDesc::UINT8, kU16 = OIIO::TypeDesc::UINT16;
const auto kHalf = OIIO::TypeDesc::HALF, kFloat = OIIO::TypeDesc::FLOAT;

const Case k_cases[] = {
    {{"exr/half", 32, 32, 6, kHalf, 4, 0}, 6, ""},
    {{"exr/float_oblong", 64, 16, 7, kFloat, 3, 0}, 7, ""},
    {{"exr/odd", 45, 21, 6, kHalf, 4, 0}, 6, ""},
    {{"exr/row", 33, 1, 6, kHalf, 1, 0}, 6, ""},
    {{"exr/round_up_same_sizes", 32, 16, 6, kHalf, 4, kRoundUp}, 6, ""},
    {{"exr/round_up", 45, 21, 7, kHalf, 4, kRoundUp}, 0, "mip level 1 has 23 x 11 pixels, not 22 x 10 (rounded down)"},
    {{"exr/data_window", 32, 32, 6, kHalf, 4, kOffset}, 0, "data window is not its display window"},
    {{"exr/no_levels", 45, 21, 1, kHalf, 4, 0}, -1, ""},
    {{"tif/bytes", 32, 32, 6, kU8, 4, 0}, 6, ""},
    {{"tif/rgb", 45, 21, 6, kU8, 3, 0}, 6, ""},
    {{"tif/words", 19, 32, 6, kU16, 4, 0}, 6, ""}, /* converted to linear floats */
    {{"tif/grey", 32, 32, 6, kU16, 1, 0}, 6, ""},
    {{"tif/float", 32, 8, 6, kFloat, 4, 0}, 6, ""},
    {{"tif/short", 32, 32, 3, kU8, 4, 0}, 3, ""},
    {{"tif/other_size", 32, 32, 3, kU8, 4, kOtherSize}, 0, "mip level 1 has 17 x 16 pixels, not 16 x 16"},
    {{"tif/other_type", 32, 32, 3, kU8, 4, kOtherType}, 0, "mip level 1 has other channels than the base"},
    {{"tif/pages", 32, 32, 6, kU8, 4, kUntagged}, -1, ""}, /* pages are no levels */
    {{"tif/no_levels", 45, 21, 1, kU8, 4, 0}, -1, ""},
    {{"dds/bytes", 32, 32, 6, kU8, 4, 0}, 6, ""},
    {{"dds/odd", 45, 21, 6, kU8, 4, 0}, 6, ""},
    {{"dds/bc1", 45, 21, 6, kU8, 4, kBlocks}, 6, ""},
    {{"dds/short", 32, 32, 4, kU8, 4, 0}, 4, ""},
    {{"dds/no_levels", 32, 32, 1, kU8, 4, 0}, -1, ""},
    {{"png/no_levels", 19, 7, 1, kU8, 4, 0}, -1, ""},
    {{"tif/1x1", 1, 1, 1, kU8, 4, 0}, -1, ""},
};

/// The base alone, with levels built by shd, and each level alone.
struct Parts {
    Texels built;
    std::vector<std::vector<unsigned char>> alone;
};

Parts load_parts(File file, uint32_t flags)
{
    const int levels = file.levels;
    file.levels = 1;
    Parts parts = {load(write_file(file, 0), flags), {}};
    for (int l = 0; l < levels; ++l) parts.alone.push_back(load(write_file(file, l), flags).levels[0]);
    return parts;
}

void test_case(void **state)
{
    const Case &c = *static_cast<const Case *>(*state);
    const std::string name = c.file.name;
    for (const uint32_t flags : {0, SHD_LOAD_IN_PROCESS + 0, SHD_LOAD_FLIP_V + 0, SHD_LOAD_IN_PROCESS | SHD_LOAD_FLIP_V,
                                 SHD_LOAD_PARTIAL + 0}) {
        if (c.expected == 0) {
            const shd_load_desc desc = load_desc(flags | SHD_LOAD_FILE_LEVELS);
            shd_texture *texture = reinterpret_cast<shd_texture *>(g_context);
            const std::string path = write_file(c.file, 0);
            shd_assert_result(c.file.name, shd_texture_load(g_context, path.c_str(), &desc, &texture),
                              SHD_ERROR_UNSUPPORTED, c.message);
            assert_null(texture);
            (void)load(path, flags);
            continue;
        }
        if (c.file.traits & kBlocks && flags & SHD_LOAD_FLIP_V) {
            const shd_load_desc desc = load_desc(flags | SHD_LOAD_FILE_LEVELS);
            shd_texture *texture = nullptr;
            shd_assert_result(c.file.name, shd_texture_load(g_context, write_file(c.file, 0).c_str(), &desc, &texture),
                              SHD_ERROR_UNSUPPORTED, "rows within blocks");
            continue;
        }
        const Parts parts = load_parts(c.file, flags);
        const std::string path = write_file(c.file, 0);
        const Texels plain = load(path, flags), given = load(path, flags | SHD_LOAD_FILE_LEVELS);
        assert_int_equal(plain.info.format, given.info.format);
        const bool always = name.rfind("dds", 0) == 0 && c.expected > 0;  // DDS gives its levels without the flag
        assert_true(plain.levels == (always ? parts.alone : parts.built.levels));
        if (c.expected < 0) {
            assert_true(given.levels == plain.levels);
            continue;
        }
        assert_int_equal(given.info.level_count, c.expected);
        assert_true(given.levels == parts.alone);
        for (size_t l = 1; !always && l < given.levels.size(); ++l) assert_true(given.levels[l] != plain.levels[l]);
    }
}

/// A texture that OpenImageIO's maketx makes: the same levels as OpenImageIO reads.
void test_maketx(void **)
{
    const std::string path = io_path("made.tx");
    OIIO::ImageBuf image(OIIO::ImageSpec(100, 60, 4, OIIO::TypeDesc::UINT8));
    const std::vector<float> texels = texels_of(100, 60, 4, 0);
    assert_true(image.set_pixels(image.roi(), OIIO::TypeFloat, texels.data()));
    OIIO::ImageSpec config;
    config.attribute("maketx:filtername", "lanczos3");
    config.attribute("maketx:resize", 0);
    const bool made = OIIO::ImageBufAlgo::make_texture(OIIO::ImageBufAlgo::MakeTxTexture, image, path, config);
    assert_true(made);
    const Texels loaded = load(path, SHD_LOAD_FILE_LEVELS);
    assert_int_equal(loaded.info.level_count, 7);
    for (int l = 0; l < 7; ++l) {
        const OIIO::ImageBuf level(path, 0, l);
        std::vector<unsigned char> want(loaded.levels[static_cast<size_t>(l)].size());
        assert_true(level.get_pixels(level.roi(), OIIO::TypeDesc::UINT8, want.data()));
        assert_true(want == loaded.levels[static_cast<size_t>(l)]);
    }
}

struct BudgetCase {
    const char *name;
    uint64_t pixels, bytes;
    uint32_t flags;
    const char *message; /* "" = the load succeeds */
};

/// 16 x 16 bytes with 5 levels have 341 pixels.
const BudgetCase k_budgets[] = {
    {"budget/pixels_exact", 341, 0, SHD_LOAD_FILE_LEVELS, ""},
    {"budget/pixels", 340, 0, SHD_LOAD_FILE_LEVELS, "all mip levels have 341 pixels, above load.max_pixels 340"},
    {"budget/pixels_of_base", 256, 0, 0, ""},
    {"budget/bytes_exact", 0, 341 * 4, SHD_LOAD_FILE_LEVELS, ""},
    {"budget/bytes", 0, 341 * 4 - 1, SHD_LOAD_FILE_LEVELS, "1364 decoded bytes are above load.max_bytes 1363"},
    {"budget/bytes_of_base", 0, 256 * 4, 0, ""},
};

void test_budget(void **state)
{
    const BudgetCase &c = *static_cast<const BudgetCase *>(*state);
    const std::string path = write_file({"tif", 16, 16, 5, kU8, 4, 0}, 0);
    for (const uint32_t mode : {0, SHD_LOAD_IN_PROCESS + 0}) {
        shd_load_desc desc = load_desc(c.flags | mode);
        if (c.pixels) desc.max_pixels = c.pixels;
        if (c.bytes) desc.max_bytes = c.bytes;
        shd_texture *texture = nullptr;
        const shd_result result = shd_texture_load(g_context, path.c_str(), &desc, &texture);
        shd_assert_result(c.name, result, *c.message ? SHD_ERROR_LIMIT : SHD_OK, c.message);
        shd_texture_release(texture);
    }
}

/// A ratio of decoded bytes that the levels exceed, but not the base.
void test_ratio(void **)
{
    const std::string path = write_file({"tif", 2048, 2048, 12, kU8, 4, 0}, 0);
    shd_load_desc desc = load_desc(0);
    desc.max_ratio = 0.9;
    shd_texture *texture = nullptr;
    shd_assert_ok(shd_texture_load(g_context, path.c_str(), &desc, &texture));
    shd_texture_release(texture);
    desc.flags = SHD_LOAD_FILE_LEVELS;
    shd_assert_result("ratio", shd_texture_load(g_context, path.c_str(), &desc, &texture), SHD_ERROR_LIMIT,
                      "22369620 decoded bytes from");
}

/// The flag and the tables, and bitmaps, which have one level.
void test_desc(void **)
{
    const std::string path = write_file({"tif", 16, 16, 5, kU8, 4, 0}, 0);
    shd_load_desc desc = load_desc(SHD_LOAD_FILE_LEVELS);
    shd_bitmap *bitmap = nullptr;
    shd_texture *texture = nullptr;
    shd_image image = shd_image_default();
    desc.tables = SHD_TABLE_SUMMED_AREA;
    shd_assert_result("tables", shd_texture_load(g_context, path.c_str(), &desc, &texture), SHD_ERROR_INVALID_ARGUMENT,
                      "load.flags: SHD_LOAD_FILE_LEVELS, but load.tables 0x4 has no SHD_TABLE_MIPMAP");
    assert_null(texture);
    desc.max_pixels = 256;
    shd_assert_ok(shd_bitmap_load(g_context, path.c_str(), &desc, &bitmap));
    shd_assert_ok(shd_bitmap_get_image(bitmap, &image));
    assert_true(image.width == 16 && image.height == 16);
    shd_bitmap_release(bitmap);
    desc = load_desc(SHD_LOAD_FILE_LEVELS);
    desc.tables = SHD_TABLE_MIPMAP | SHD_TABLE_RIPMAP | SHD_TABLE_SUMMED_AREA;
    shd_assert_ok(shd_texture_load(g_context, path.c_str(), &desc, &texture));
    assert_int_equal(take_texels(texture).info.level_count, 5);
}

/// An OpenEXR file whose header promises levels that are missing: an error, or with SHD_LOAD_PARTIAL levels of shd.
void test_missing(void **)
{
    const std::string path = write_file({"exr", 64, 64, 1, kHalf, 4, kMissing}, 0);
    const Texels plain = load(path, 0);
    for (const uint32_t mode : {0, SHD_LOAD_IN_PROCESS + 0}) {
        const shd_load_desc desc = load_desc(SHD_LOAD_FILE_LEVELS | mode);
        shd_texture *texture = nullptr;
        shd_assert_result("missing", shd_texture_load(g_context, path.c_str(), &desc, &texture), SHD_ERROR_CORRUPT,
                          "OpenEXR: mip level 1: damaged: ");
        assert_true(load(path, SHD_LOAD_FILE_LEVELS | SHD_LOAD_PARTIAL | mode).levels == plain.levels);
    }
}

/// A file that is cut off: an error, or with SHD_LOAD_PARTIAL the whole levels before the end.
void test_cut(void **state)
{
    const File &file = *static_cast<const File *>(*state);
    const Texels whole = load(write_file(file, 0), SHD_LOAD_FILE_LEVELS);
    const io_bytes bytes = io_read(write_file(file, 0).c_str());
    const std::string path = io_path("cut");
    uint32_t fewest = whole.info.level_count, most = 0;
    for (size_t size = bytes.size - 1; size > bytes.size / 8; size -= std::min<size_t>(size, 1 + bytes.size / 60)) {
        io_write(path.c_str(), bytes.data, size);
        for (const uint32_t mode : {SHD_LOAD_IN_PROCESS + 0, 0}) {
            shd_load_desc desc = load_desc(SHD_LOAD_FILE_LEVELS | mode);
            shd_texture *texture = nullptr;
            shd_result result = shd_texture_load(g_context, path.c_str(), &desc, &texture);
            if (result != SHD_ERROR_CORRUPT) fail_msg("%s: %zu bytes: %s", file.name, size, shd_result_name(result));
            desc.flags |= SHD_LOAD_PARTIAL;
            result = shd_texture_load(g_context, path.c_str(), &desc, &texture);
            if (result != SHD_OK) continue;
            const Texels part = take_texels(texture);
            assert_true(part.info.width == whole.info.width && part.info.height == whole.info.height);
            if (part.levels[0] != whole.levels[0]) continue;  // the base is damaged, too
            const size_t full = whole.levels.size(), count = part.levels.size();
            // Levels of the file up to the damage, or all levels built by shd if the damage begins with the first one.
            const bool given = count > 1 && part.levels[1] == whole.levels[1];
            const bool no_mipmap = (file.traits & kBlocks) && count == 1;  // shd builds no levels of blocks
            assert_true(no_mipmap || (given ? count < full : count == full));
            for (size_t l = 0; given && l < count; ++l) assert_true(part.levels[l] == whole.levels[l]);
            fewest = std::min(fewest, given ? static_cast<uint32_t>(part.info.level_count) : 1);
            most = std::max(most, given ? static_cast<uint32_t>(part.info.level_count) : 1);
        }
    }
    print_message("%s: %u to %u whole levels\n", file.name, fewest, most);
    assert_true(fewest < most);
    free(bytes.data);
}
/// A file with wrong bytes: an error or some pixels, each time the same.
void test_damaged(void **state)
{
    const File &file = *static_cast<const File *>(*state);
    const io_bytes bytes = io_read(write_file(file, 0).c_str());
    uint64_t random = 20221122;
    int loaded = 0;
    for (int i = 0; i < 120; ++i) {
        std::vector<unsigned char> damaged(bytes.data, bytes.data + bytes.size);
        for (int k = 0; k <= i % 3; ++k) {
            const size_t range = i % 2 ? bytes.size : std::min<size_t>(bytes.size, 512);
            damaged[io_random(&random) % range] = static_cast<unsigned char>(io_random(&random));
        }
        const shd_load_desc desc = load_desc(SHD_LOAD_FILE_LEVELS | (i % 4 == 3 ? SHD_LOAD_PARTIAL : 0));
        shd_result result[2];
        Texels texels[2];
        for (int k = 0; k < 2; ++k) {
            shd_texture *texture = nullptr;
            result[k] = shd_texture_load_memory(g_context, damaged.data(), damaged.size(), &desc, &texture);
            assert_true((texture != nullptr) == (result[k] == SHD_OK));
            if (texture) texels[k] = take_texels(texture);
        }
        assert_int_equal(result[0], result[1]);
        assert_int_not_equal(result[0], SHD_ERROR_INTERNAL);
        assert_true(texels[0].levels == texels[1].levels);
        loaded += result[0] == SHD_OK;
    }
    print_message("%s: %d of 120 loads succeed\n", file.name, loaded);
    free(bytes.data);
}

const File k_cut[] = {
    {"exr/cut", 64, 64, 7, kHalf, 4, 0},
    {"dds/cut", 32, 32, 6, kU8, 4, 0},
    {"dds/cut_bc1", 45, 21, 6, kU8, 4, kBlocks},
};
const File k_damaged[] = {
    {"exr/damaged", 64, 64, 7, kHalf, 4, 0},
    {"tif/damaged", 45, 21, 6, kU8, 4, 0},
    {"dds/damaged", 45, 21, 6, kU8, 4, kBlocks},
};

/// Each allocation fails in turn, alone and with all later ones.
void test_memory(void **)
{
    const std::string path = write_file({"tif", 16, 16, 5, kU16, 4, 0}, 0);
    for (const uint32_t mode : {0, SHD_LOAD_IN_PROCESS + 0}) {
        for (const int persistent : {0, 1}) {
            const shd_load_desc desc = load_desc(SHD_LOAD_FILE_LEVELS | mode);
            shd_fault_allocator memory = {};
            const shd_context_desc context_desc = shd_fault_context_desc(&memory);
            shd_context *context = nullptr;
            shd_assert_ok(shd_context_create(&context_desc, &context));
            shd_texture *first = nullptr;
            shd_assert_ok(shd_texture_load(context, path.c_str(), &desc, &first));
            shd_texture_release(first);
            const size_t blocks = memory.live_blocks;  // a context keeps memory of its first object
            size_t n = 1;
            for (;; ++n) {
                shd_texture *texture = nullptr;
                shd_fault_arm(&memory, n, persistent);
                const shd_result result = shd_texture_load(context, path.c_str(), &desc, &texture);
                shd_fault_arm(&memory, 0, 0);
                if (result == SHD_OK) assert_int_equal(take_texels(texture).info.level_count, 5);
                assert_int_equal(memory.live_blocks, blocks);
                if (result == SHD_OK) break;
                shd_assert_result("memory", result, SHD_ERROR_OUT_OF_MEMORY, "");
            }
            assert_true(n > 3);
            shd_context_release(context);
            shd_assert_all_freed("levels", &memory);
        }
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
    for (const Case &c : k_cases) add(c.file.name, test_case, &c);
    add("maketx", test_maketx, nullptr);
    for (const BudgetCase &c : k_budgets) add(c.name, test_budget, &c);
    add("exr/missing", test_missing, nullptr);
    add("budget/ratio", test_ratio, nullptr);
    add("desc", test_desc, nullptr);
    for (const File &c : k_cut) add(c.name, test_cut, &c);
    for (const File &c : k_damaged) add(c.name, test_damaged, &c);
    add("memory", test_memory, nullptr);
    const int failed = _cmocka_run_group_tests("api.io_levels", tests.data(), tests.size(), nullptr, nullptr);
    shd_context_release(g_context);
    io_remove_folder(&state);
    return failed;
}
