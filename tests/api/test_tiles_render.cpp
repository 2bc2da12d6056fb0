// SPDX-License-Identifier: MIT
// Frames with textures in tiles: the pixels of the same textures in memory, callbacks that fail, and a pyramid in
// borrowed memory.
#include <array>

#include "support/scene.h"
#include "support/tiles.h"

namespace shd::tests
{
namespace
{

constexpr uint32_t kWidth = 203, kHeight = 151, kSide = 256;

struct Case {
    const char *name;
    shd_filter filter;
    shd_precision precision;
    shd_format color;
    uint32_t workers, samples;
    uint64_t budget;
};
constexpr uint64_t kSmall = 4 * 1024 + 65536;
const Case kCases[] = {
    {"planes", SHD_FILTER_TRILINEAR, SHD_PRECISION_FULL, SHD_FORMAT_RGBA32F, 1, 1, 1 << 22},
    {"pixels", SHD_FILTER_ANISOTROPIC, SHD_PRECISION_FULL, SHD_FORMAT_RGBA8, 4, 1, 1 << 22},
    {"samples", SHD_FILTER_BILINEAR, SHD_PRECISION_FULL, SHD_FORMAT_RGBA8, 2, 4, 1 << 20},
    {"small cache", SHD_FILTER_EWA, SHD_PRECISION_FULL, SHD_FORMAT_RGBA8, 4, 1, kSmall},
    {"fast", SHD_FILTER_TRILINEAR, SHD_PRECISION_FAST, SHD_FORMAT_RGBA8, 2, 1, kSmall},
};

/// A scene whose draws have one texture, in memory or in tiles.
struct Frame {
    shd_context *context = nullptr;
    shd_scene scene;
    shd_sampler *sampler = nullptr;
    std::vector<unsigned char> texels = std::vector<unsigned char>(kSide * kSide * 4);
    shd_texture_desc desc = shd_texture_desc_default();
    shd_texture *texture = nullptr;

    explicit Frame(const Case &of)
    {
        shd_context_desc context_desc = shd_context_desc_default();
        context_desc.worker_count = of.workers;
        shd_assert_ok(shd_context_create(&context_desc, &context));
        shd_scene_open(&scene, SHD_SCENE_MIXED, context);
        shd_sampler_desc sampler_desc = shd_sampler_desc_default();
        sampler_desc.filter = of.filter;
        sampler_desc.precision = of.precision;
        shd_assert_ok(shd_sampler_create(context, &sampler_desc, &sampler));
        for (size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<unsigned char>(i * 73 + i / 119);
        desc.format = SHD_FORMAT_RGBA8;
        desc.width = desc.height = kSide;
        desc.texels = texels.data();
        desc.tables = SHD_TABLE_MIPMAP;
        shd_assert_ok(shd_texture_create(context, &desc, &texture));
    }
    ~Frame()
    {
        shd_texture_release(texture);
        shd_sampler_release(sampler);
        shd_scene_close(&scene);
        shd_context_release(context);
    }
    Frame(const Frame &) = delete;
    Frame &operator=(const Frame &) = delete;

    shd_result draw(const Case &of, shd_texture *with, shd_sampler *by, std::vector<unsigned char> *pixels)
    {
        shd_material_desc material_desc = shd_material_desc_default();
        material_desc.model = SHD_MODEL_UNLIT;
        shd_slot slot = shd_slot_texture(SHD_SLOT_DIFFUSE, with, by);
        material_desc.slots = &slot;
        material_desc.slot_count = 1;
        shd_material *material = nullptr;
        shd_assert_ok(shd_material_create(context, &material_desc, &material));
        for (size_t i = 0; i < scene.desc.draw_count; ++i) scene.draw[i].material = material;
        shd_framebuffer_desc framebuffer_desc = shd_framebuffer_desc_default();
        framebuffer_desc.width = kWidth;
        framebuffer_desc.height = kHeight;
        framebuffer_desc.sample_count = of.samples;
        framebuffer_desc.color_format = of.color;
        shd_framebuffer *framebuffer = nullptr;
        shd_assert_ok(shd_framebuffer_create(context, &framebuffer_desc, &framebuffer));
        shd_render_desc frame = scene.desc;
        frame.framebuffer = framebuffer;
        const shd_result result = shd_render(context, &frame);
        shd_image view = shd_image_default();
        view.format = of.color;
        view.width = kWidth;
        view.height = kHeight;
        pixels->assign(shd_format_size(of.color) * kWidth * kHeight, 0);
        view.pixels = pixels->data();
        if (result == SHD_OK) shd_assert_ok(shd_framebuffer_read_color(framebuffer, &view));
        shd_framebuffer_release(framebuffer);
        shd_material_release(material);
        return result;
    }
};

void test_frames(void **)
{
    for (const Case &each : kCases) {
        Frame frame(each);
        TileSource source(frame.texture);
        shd_tile_cache *cache = make_tile_cache(frame.context, 1024, each.budget);
        const shd_texture_desc desc = source.desc(frame.desc, frame.texture, cache);
        shd_texture *tiled = nullptr;
        shd_assert_ok(shd_texture_create(frame.context, &desc, &tiled));
        // SHD_PRECISION_FAST has no effect on tiles.
        shd_sampler_desc full = shd_sampler_desc_default();
        full.filter = each.filter;
        shd_sampler *sampler = nullptr;
        shd_assert_ok(shd_sampler_create(frame.context, &full, &sampler));
        std::vector<unsigned char> want, got;
        shd_assert_ok(frame.draw(each, frame.texture, sampler, &want));

        source.fail_at = 5;
        shd_assert_result(each.name, frame.draw(each, tiled, frame.sampler, &got), SHD_ERROR_CALLBACK,
                          "texture.tiles.load returned SHD_ERROR_IO");
        source.fail_at = -1;
        shd_assert_ok(frame.draw(each, tiled, frame.sampler, &got));
        if (want != got) fail_msg("%s: the frames differ", each.name);
        size_t lit = 0;
        for (unsigned char byte : got) lit += byte != 0;
        assert_true(lit > got.size() / 10);
        shd_sampler_release(sampler);
        shd_texture_release(tiled);
        shd_tile_cache_release(cache);
    }
}

/// All levels one after another in the caller's memory.
struct Pyramid {
    std::vector<unsigned char> memory;
    std::array<shd_image, 8> levels;
    shd_texture_desc desc = shd_texture_desc_default();

    explicit Pyramid(const TileSource &source) : memory(SHD_TEXTURE_PADDING)
    {
        size_t size = 0;
        for (const auto &level : source.level) size += level.texels.size();
        memory.resize(size + SHD_TEXTURE_PADDING);
        size_t at = 0;
        for (uint32_t l = 0; l < source.levels; ++l) {
            const auto &level = source.level[l];
            std::memcpy(&memory[at], level.texels.data(), level.texels.size());
            if (l > 0) {
                shd_image &image = levels[l - 1] = shd_image_default();
                image.format = SHD_FORMAT_RGBA8;
                image.width = level.width;
                image.height = level.height;
                image.pixels = &memory[at];
            }
            at += level.texels.size();
        }
        desc.format = SHD_FORMAT_RGBA8;
        desc.width = source.level[0].width;
        desc.height = source.level[0].height;
        desc.texels = memory.data();
        desc.tables = SHD_TABLE_MIPMAP;
        desc.level_count = source.levels - 1;
        desc.level_images = levels.data();
        desc.flags = SHD_TEXTURE_BORROW | SHD_TEXTURE_BORROW_LEVELS;
    }
};

void test_borrowed_levels(void **)
{
    Frame frame(kCases[1]);
    TileSource source(frame.texture);
    Pyramid pyramid(source);
    shd_texture *borrowed = nullptr;
    shd_assert_ok(shd_texture_create(frame.context, &pyramid.desc, &borrowed));
    shd_texture_info info = shd_texture_info_default();
    shd_assert_ok(shd_texture_get_info(borrowed, &info));
    assert_int_equal(info.flags, SHD_TEXTURE_BORROW | SHD_TEXTURE_BORROW_LEVELS);
    assert_int_equal(info.byte_size, 0);
    std::vector<unsigned char> want, got;
    shd_assert_ok(frame.draw(kCases[1], frame.texture, frame.sampler, &want));
    shd_assert_ok(frame.draw(kCases[1], borrowed, frame.sampler, &got));
    assert_true(want == got);
    shd_image image = shd_image_default();
    image.format = SHD_FORMAT_RGBA8, image.width = image.height = 1;
    shd_assert_result("update", shd_texture_update(borrowed, 0, 0, 0, &image), SHD_ERROR_UNSUPPORTED,
                      "its levels are borrowed");
    shd_texture_release(borrowed);
}

void test_bad_levels(void **)
{
    Frame frame(kCases[1]);
    TileSource source(frame.texture);
    const struct {
        void (*edit)(Pyramid *pyramid);
        shd_result result;
        const char *message;
    } cases[] = {
        {[](Pyramid *p) { p->desc.flags = SHD_TEXTURE_BORROW_LEVELS; }, SHD_ERROR_INVALID_ARGUMENT,
         "texture.flags: SHD_TEXTURE_BORROW_LEVELS without SHD_TEXTURE_BORROW"},
        {[](Pyramid *p) { p->desc.level_count = 0; }, SHD_ERROR_INVALID_ARGUMENT, "texture.level_count 0"},
        {[](Pyramid *p) { p->levels[2].pixels = p->memory.data(); }, SHD_ERROR_INVALID_ARGUMENT,
         "texture.level_images[2].pixels: not behind the finer level"},
        {[](Pyramid *p) { p->levels[1].row_stride = 65 * 4; }, SHD_ERROR_INVALID_ARGUMENT,
         "texture.level_images[1].row_stride: not packed"},
        {[](Pyramid *p) { p->desc.tables |= SHD_TABLE_RIPMAP; }, SHD_ERROR_INVALID_ARGUMENT, "SHD_TABLE_MIPMAP alone"},
    };
    for (const auto &each : cases) {
        Pyramid pyramid(source);
        each.edit(&pyramid);
        shd_texture *borrowed = nullptr;
        shd_assert_result(each.message, shd_texture_create(frame.context, &pyramid.desc, &borrowed), each.result,
                          each.message);
        assert_null(borrowed);
    }
}

}  // namespace
}  // namespace shd::tests

int main(void)
{
    using namespace shd::tests;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_frames),
        cmocka_unit_test(test_borrowed_levels),
        cmocka_unit_test(test_bad_levels),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
