// SPDX-License-Identifier: MIT
// Textures, samplers and lookups that show every step of a texture unit, for tests of <shd/bounds.h>.
#pragma once

#include <memory>
#include <vector>

#include <shd/shd.h>

#include "ref/unit_filter_ref.h"
#include "support/check.h"
#include "support/context.h"
#include "support/random.h"

namespace shd::tests
{

/// Contents of a texture: noise about a colour of each level and layer; ramps; these colours alone; or few white
/// texels, which show reads of texels that a lookup must not read.
enum class Picture { kNoise, kRamp, kLevels, kDots };

struct SceneTexture {
    shd_format format;
    uint32_t width, height, layers, depth;
    shd_projection projection;
    Picture picture;

    bool has_directions() const { return projection != SHD_PROJECTION_NONE; }
};

constexpr SceneTexture kSceneTextures[] = {
    {SHD_FORMAT_RGBA8, 64, 32, 1, 0, SHD_PROJECTION_NONE, Picture::kNoise},
    {SHD_FORMAT_RGBA8_SRGB, 37, 21, 1, 0, SHD_PROJECTION_NONE, Picture::kNoise},
    {SHD_FORMAT_RGBA32F, 64, 64, 1, 0, SHD_PROJECTION_NONE, Picture::kRamp},
    {SHD_FORMAT_RGBA8_SRGB, 64, 64, 1, 0, SHD_PROJECTION_NONE, Picture::kLevels},
    {SHD_FORMAT_RGBA16, 17, 33, 3, 0, SHD_PROJECTION_NONE, Picture::kNoise},
    {SHD_FORMAT_RGBA8, 16, 16, 6, 0, SHD_PROJECTION_CUBE, Picture::kNoise},
    {SHD_FORMAT_RGBA8_SRGB, 32, 32, 6, 0, SHD_PROJECTION_CUBE, Picture::kLevels},
    {SHD_FORMAT_RGBA8, 64, 64, 1, 0, SHD_PROJECTION_NONE, Picture::kDots},
    {SHD_FORMAT_RGBA8, 16, 8, 1, 9, SHD_PROJECTION_NONE, Picture::kNoise},
    {SHD_FORMAT_RGBA8_SRGB, 5, 13, 1, 16, SHD_PROJECTION_NONE, Picture::kNoise},
    {SHD_FORMAT_RGBA16, 1, 1, 1, 1, SHD_PROJECTION_NONE, Picture::kNoise},
    {SHD_FORMAT_RGBA32F, 16, 16, 1, 12, SHD_PROJECTION_NONE, Picture::kLevels},
    {SHD_FORMAT_RGBA8, 32, 32, 1, 0, SHD_PROJECTION_OCTAHEDRAL, Picture::kNoise},
    {SHD_FORMAT_RGBA16, 13, 13, 3, 0, SHD_PROJECTION_OCTAHEDRAL, Picture::kNoise},
    {SHD_FORMAT_RGBA8, 32, 32, 1, 0, SHD_PROJECTION_MIRROR_BALL, Picture::kNoise},
    {SHD_FORMAT_RGBA8_SRGB, 21, 21, 2, 0, SHD_PROJECTION_ANGULAR, Picture::kNoise},
};

constexpr shd_filter kBoundedFilters[] = {SHD_FILTER_NEAREST,           SHD_FILTER_BILINEAR,  SHD_FILTER_NEAREST_MIP,
                                          SHD_FILTER_BILINEAR_MIP,      SHD_FILTER_TRILINEAR, SHD_FILTER_ANISOTROPIC,
                                          SHD_FILTER_NEAREST_MIP_LINEAR};

/// One texture with its levels, in the library and for the oracle.
class ScenePixels
{
   public:
    ScenePixels(shd_context *context, const SceneTexture &kind, Random *random)
    {
        image = {kind.format, 1, static_cast<int>(kind.layers), kind.projection, kind.depth, {}, {}};
        while ((kind.width | kind.height | kind.depth) >> image.level_count) ++image.level_count;
        const auto levels = static_cast<uint32_t>(image.level_count);
        bytes.resize(size_t{kind.layers} * levels);
        for (uint32_t layer = 0; layer < kind.layers; ++layer) {
            for (uint32_t level = 0; level < levels; ++level) fill(kind, layer, level, random);
        }
        create(context, kind);
    }
    ~ScenePixels() { shd_texture_release(texture); }
    ScenePixels(const ScenePixels &) = delete;
    ScenePixels &operator=(const ScenePixels &) = delete;

    ref::UnitImage image;
    shd_texture *texture = nullptr;

   private:
    static double value(const SceneTexture &kind, uint32_t layer, uint32_t level, double x, double y, uint32_t c,
                        Random *random)
    {
        const double base = 0.12 + 0.76 * ((level * 5 + layer * 3 + c * 2) % 11) / 10.0;
        switch (kind.picture) {
            case Picture::kRamp: return 2.0 * (c & 1 ? y : x) + (c & 2 ? 0.5 * x * y : 0.1 * level);
            case Picture::kLevels: return base;
            case Picture::kDots: return random->whole(0, 31) ? 0.0 : 1.0;
            default: return 0.3 * base + 0.7 * random->unit();
        }
    }

    void fill(const SceneTexture &kind, uint32_t layer, uint32_t level, Random *random)
    {
        const uint32_t w = std::max(kind.width >> level, 1u), h = std::max(kind.height >> level, 1u);
        const uint32_t rows = h * std::max(kind.depth >> level, 1u);
        const size_t size = shd_format_size(kind.format) / 4;
        std::vector<uint8_t> &to = bytes[size_t{layer} * static_cast<size_t>(image.level_count) + level];
        to.resize(size_t{w} * rows * 4 * size);
        for (size_t i = 0; i < size_t{w} * rows * 4; ++i) {
            const size_t texel = i / 4;
            const double v = value(kind, layer, level, (static_cast<double>(texel % w) + 0.5) / w,
                                   (static_cast<double>(texel / w % h) + 0.5) / h, i % 4, random);
            const auto real = static_cast<float>(v);
            const auto code = static_cast<uint16_t>(v * 65535);
            if (size == 4) memcpy(&to[i * 4], &real, 4);
            if (size == 2) memcpy(&to[i * 2], &code, 2);
            if (size == 1) to[i] = static_cast<uint8_t>(code >> 8);
        }
        image.levels.push_back({to.data(), w, h});
    }

    void create(shd_context *context, const SceneTexture &kind)
    {
        const auto levels = static_cast<uint32_t>(image.level_count);
        std::vector<uint8_t> base;
        std::vector<shd_image> rest;
        for (uint32_t layer = 0; layer < kind.layers; ++layer) {
            const std::vector<uint8_t> *from = &bytes[size_t{layer} * levels];
            base.insert(base.end(), from[0].begin(), from[0].end());
            for (uint32_t level = 1; level < levels; ++level) {
                shd_image given = shd_image_default();
                given.format = kind.format;
                given.width = std::max(kind.width >> level, 1u), given.height = std::max(kind.height >> level, 1u);
                const size_t slice = size_t{given.width} * given.height * shd_format_size(kind.format);
                for (size_t at = 0; at < from[level].size(); at += slice) {
                    given.pixels = const_cast<uint8_t *>(from[level].data()) + at;
                    rest.push_back(given);
                }
            }
        }
        shd_texture_desc desc = shd_texture_desc_default();
        desc.format = kind.format, desc.width = kind.width, desc.height = kind.height, desc.layer_count = kind.layers;
        desc.depth = kind.depth, desc.projection = kind.projection;
        if (kind.depth) desc.kind = SHD_TEXTURE_KIND_3D;
        if (kind.projection) desc.kind = SHD_TEXTURE_KIND_DIRECTIONS;
        desc.texels = base.data(), desc.tables = SHD_TABLE_MIPMAP;
        desc.level_images = rest.data(), desc.level_count = levels - 1;
        shd_assert_ok(shd_texture_create(context, &desc, &texture));
    }

    std::vector<std::vector<uint8_t>> bytes;
};

/// Columns of lookups.
struct SceneLookups {
    std::vector<float> column[9];  // u, v, w, d/dx of them, d/dy of them
    std::vector<float> lod;        // empty = none
    std::vector<uint32_t> layer;

    size_t count() const { return layer.size(); }

    void add(const SceneTexture &kind, bool with_lod, Random *random)
    {
        float p[3];
        for (float &x : p) {
            x = random->whole(0, 3) ? random->real(0, 1) : random->real(-1.6, 2.6);
            if (!random->whole(0, 7)) x = static_cast<float>(std::floor(x * 128)) / 128;
            if (kind.has_directions()) x = random->whole(0, 9) ? 2 * x - 1 : std::copysign(1.0f, x - 0.5f);
        }
        if (kind.has_directions() && p[0] == 0 && p[1] == 0 && p[2] == 0) p[2] = 1;
        const double size = std::exp2(random->in(-1.5, 5)) / kind.width * (kind.has_directions() ? 2 : 1);
        const double ratio = random->whole(0, 3) ? std::exp2(random->in(0, 5)) : 1.0;
        float d[6] = {};
        for (int i = 0; i < 6; ++i) {
            const double part = random->in(-1, 1) * size / (i >= 3 ? ratio : 1.0);
            const uint32_t across = i % 3 == 1 ? kind.height : i % 3 == 2 && kind.depth ? kind.depth : kind.width;
            d[i] = static_cast<float>(part * kind.width / across);
        }
        if (!random->whole(0, 15)) std::fill(d, d + 6, 0.0f);
        for (int i = 0; i < 3; ++i) column[i].push_back(p[i]);
        for (int i = 0; i < 6; ++i) column[3 + i].push_back(d[i]);
        if (with_lod) lod.push_back(random->real(-1, 7));
        layer.push_back(
            kind.projection == SHD_PROJECTION_CUBE ? 0 : static_cast<uint32_t>(random->whole(0, kind.layers - 1)));
    }

    shd_lookups columns() const
    {
        shd_lookups in = shd_lookups_default();
        in.count = count();
        shd_f32_in *const to[9] = {&in.u, &in.v, &in.w, &in.dudx, &in.dvdx, &in.dwdx, &in.dudy, &in.dvdy, &in.dwdy};
        for (int i = 0; i < 9; ++i) *to[i] = shd_f32_column(column[i].data(), 0);
        if (!lod.empty()) in.lod = shd_f32_column(lod.data(), 0);
        in.layer = shd_u32_column(layer.data(), 0);
        return in;
    }

    ref::UnitLookup at(size_t i) const
    {
        ref::UnitLookup out = {};
        for (size_t c = 0; c < 3; ++c) {
            out.p[c] = static_cast<double>(column[c][i]);
            out.dx[c] = static_cast<double>(column[3 + c][i]);
            out.dy[c] = static_cast<double>(column[6 + c][i]);
        }
        out.has_lod = !lod.empty();
        out.lod = out.has_lod ? static_cast<double>(lod[i]) : 0;
        out.layer = static_cast<int>(layer[i]);
        return out;
    }
};

/// Four columns of values.
struct SceneValues {
    std::vector<float> channel[4];

    shd_texels columns(size_t count)
    {
        shd_texels out = shd_texels_default();
        for (int c = 0; c < 4; ++c) {
            channel[c].resize(count);
            out.channel[c] = shd_f32_out_column(channel[c].data(), 0);
        }
        return out;
    }
};

/// A texture with a sampler and lookups. `image` has the texture's levels and the sampler's desc.
struct Scene {
    SceneTexture kind;
    const ScenePixels *pixels;
    ref::UnitImage image;
    SceneLookups lookups;

    shd_sampler *sampler(shd_context *context) const
    {
        shd_sampler *out = nullptr;
        shd_assert_ok(shd_sampler_create(context, &image.sampler, &out));
        return out;
    }
};

inline shd_sampler_desc scene_sampler(const SceneTexture &kind, shd_filter filter, int variant, Random *random)
{
    shd_sampler_desc desc = shd_sampler_desc_default();
    desc.filter = filter;
    desc.profile = kind.depth ? SHD_PROFILE_EXACT : SHD_PROFILE_VULKAN;
    desc.wrap_u = static_cast<shd_wrap>(random->whole(0, 4));
    desc.wrap_v = static_cast<shd_wrap>(random->whole(0, 4));
    if (kind.depth) desc.wrap_w = static_cast<shd_wrap>(random->whole(0, 4));
    for (float &x : desc.border) x = random->real(0.2, 1);
    if (variant == 1) desc.lod_bias = random->whole(0, 1) ? 0.7f : -0.6f;
    if (variant == 2) desc.lod_min = 1.25f, desc.lod_max = 3.5f;
    desc.max_anisotropy = variant == 0 ? 16.0f : variant == 1 ? 4.0f : 6.0f;
    return desc;
}

/// Every texture with every filter and three samplers each.
class Scenes
{
   public:
    Scenes(shd_context *context, size_t lookups, uint64_t seed)
    {
        Random random{seed};
        for (const SceneTexture &kind : kSceneTextures) {
            pixels.push_back(std::make_unique<ScenePixels>(context, kind, &random));
            for (shd_filter filter : kBoundedFilters) {
                for (int variant = 0; variant < 3; ++variant) add(kind, filter, variant, lookups, &random);
            }
        }
    }

    std::vector<Scene> list;

   private:
    void add(const SceneTexture &kind, shd_filter filter, int variant, size_t lookups, Random *random)
    {
        Scene scene = {kind, pixels.back().get(), pixels.back()->image, {}};
        scene.image.sampler = scene_sampler(kind, filter, variant, random);
        const bool with_lod = variant == 2 && random->whole(0, 1);
        for (size_t i = 0; i < lookups; ++i) scene.lookups.add(kind, with_lod, random);
        list.push_back(std::move(scene));
    }

    std::vector<std::unique_ptr<ScenePixels>> pixels;
};

/// The bounds of a scene, or of another texture with its sampler and lookups.
struct SceneBounds {
    SceneValues lower, upper;

    SceneBounds(shd_context *context, const Scene &scene, const shd_bounds_desc &desc)
        : SceneBounds(context, scene, desc, scene.pixels->texture)
    {
    }
    SceneBounds(shd_context *context, const Scene &scene, const shd_bounds_desc &desc, const shd_texture *texture)
    {
        shd_sampler *sampler = scene.sampler(context);
        const shd_lookups in = scene.lookups.columns();
        shd_texels low = lower.columns(in.count), high = upper.columns(in.count);
        shd_assert_ok(shd_texture_bounds(texture, sampler, &in, &desc, &low, &high));
        shd_sampler_release(sampler);
    }

    /// The first channel of a value that is not legal, or -1.
    int illegal(size_t i, const double (&value)[4]) const
    {
        for (int c = 0; c < 4; ++c) {
            const auto rounded = static_cast<float>(value[c]);
            if (!(lower.channel[c][i] <= rounded && rounded <= upper.channel[c][i])) return c;
        }
        return -1;
    }
};

inline shd_bounds_desc preset(shd_rules rules)
{
    shd_bounds_desc desc = shd_bounds_desc_default();
    shd_assert_ok(shd_bounds_desc_from_rules(rules, &desc));
    return desc;
}

/// A random unit that the rules allow.
inline ref::Unit legal_unit(const shd_bounds_desc &rules, Random *random)
{
    ref::Unit unit;
    const auto bits = [&](uint32_t least) {
        const int extra[] = {0, 0, 1, 2, 4, 16};
        return static_cast<int>(least) + extra[random->whole(0, 5)];
    };
    unit.subtexel_bits = bits(rules.subtexel_bits), unit.level_bits = bits(rules.level_bits);
    for (ref::Rounding &rounding : unit.rounding) rounding = static_cast<ref::Rounding>(random->whole(0, 2));
    unit.level_rounding = static_cast<ref::Rounding>(random->whole(0, 2));
    // Binary32 products take part of the error of coordinates.
    const double error = static_cast<double>(rules.coordinate_error) - 0x1p-23;
    for (double &x : unit.coordinate_error) x = random->whole(0, 2) ? 0 : random->whole(0, 1) ? error : -error;
    unit.level_error = random->in(-1, 1) * static_cast<double>(rules.level_error);
    unit.weight_bits = random->whole(0, 1) ? static_cast<int>(rules.weight_bits) + 1 : 0;
    unit.result_bits = rules.result_bits && random->whole(0, 1) ? bits(rules.result_bits) : 0;
    do {
        unit.rule = 1u << random->whole(0, 3);
    } while (!(unit.rule & rules.level_rules));
    unit.stretch = random->whole(0, 2) ? random->unit() : random->whole(0, 1);
    unit.lower_tie = random->whole(0, 1);
    unit.floats = random->whole(0, 1);
    unit.srgb_error = random->in(-1, 1) * static_cast<double>(rules.srgb_error);
    unit.isotropy = random->whole(0, 2) ? 0 : random->unit();
    unit.vulkan_places = random->whole(0, 1);
    unit.probe_falloff = random->whole(0, 1) ? 0 : random->in(0, 3);
    unit.face_tie = (unit.lower_tie ? 1 : 0) + (unit.floats ? 1 : 0);
    return unit;
}

}  // namespace shd::tests
