// SPDX-License-Identifier: MIT
// The cells of the table of support: a texture of noise for each domain in every store, lookups of it, and the call
// that a cell names.
#pragma once

#include <algorithm>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include <shd/shd.h>

#include "core/enum_names.h"
#include "core/object.h"
#include "ref/unit_ref.h"
#include "support/stored_textures.h"
#include "texture/support.h"
#include "texture/texture.h"

namespace cells {

using namespace shd::texture;
using shd::tests::Random;

constexpr shd_filter kFilters[] = {SHD_FILTER_NEAREST,
                                   SHD_FILTER_BILINEAR,
                                   SHD_FILTER_BICUBIC,
                                   SHD_FILTER_NEAREST_MIP,
                                   SHD_FILTER_BILINEAR_MIP,
                                   SHD_FILTER_TRILINEAR,
                                   SHD_FILTER_RIPMAP,
                                   SHD_FILTER_SUMMED_AREA,
                                   SHD_FILTER_ANISOTROPIC,
                                   SHD_FILTER_EWA,
                                   SHD_FILTER_STOCHASTIC,
                                   SHD_FILTER_EXACT,
                                   SHD_FILTER_NEAREST_MIP_LINEAR,
                                   SHD_FILTER_HERMITE};
constexpr size_t kFilterCount = sizeof kFilters / sizeof *kFilters;

template <class Body>
void for_each_cell(const Body& body) {
  for (const shd_filter filter : kFilters) {
    for (uint32_t domain = 0; domain < kDomains; ++domain) {
      for (uint32_t store = 0; store < kStores; ++store) {
        for (uint32_t use = 0; use < kUses; ++use) {
          body(SupportCell{filter, static_cast<Domain>(domain), static_cast<Store>(store), static_cast<Use>(use)});
        }
      }
    }
  }
}

inline std::string text_of(const SupportCell& cell) {
  return std::string(shd::core::value_name(cell.filter)) + ", " + name_of(cell.domain) + ", " + name_of(cell.store) +
         ", " + name_of(cell.use);
}

// ---- Textures ----

/// A shape of a domain. Tiles have 32 x 16 texels.
struct Shape {
  Domain domain;
  shd::tests::TextureShape stored;
};
constexpr Shape kShapes[] = {
    {Domain::kPlane, {"2D", 37, 21, 1, 0, SHD_PROJECTION_NONE}},
    {Domain::kPlane, {"array", 35, 18, 3, 0, SHD_PROJECTION_NONE}},
    {Domain::kSlices, {"3D", 34, 19, 1, 7, SHD_PROJECTION_NONE}},
    {Domain::kDirections, {"CUBE", 23, 23, 6, 0, SHD_PROJECTION_CUBE}},
    {Domain::kDirections, {"OCTAHEDRAL", 37, 37, 1, 0, SHD_PROJECTION_OCTAHEDRAL}},
};
constexpr size_t kShapeCount = sizeof kShapes / sizeof *kShapes;

/// By Store.
constexpr shd::tests::StoredForm kForms[kStores] = {{"memory", false, false, false},
                                                    {"borrowed", false, true, false},
                                                    {"blocks", true, false, false},
                                                    {"tiles", false, false, true},
                                                    {"tiles of blocks", true, false, true}};

/// Whether a shape has textures of a store: only one layer can be borrowed.
inline bool has_store(const Shape& shape, Store store) {
  return store != Store::kBorrowed || shape.stored.layers == 1;
}

/// The context of a SIMD target, and the textures of all shapes and stores.
class Textures {
 public:
  explicit Textures(shd_context* context) : context_(context) {
    shd_tile_cache_desc desc = shd_tile_cache_desc_default();
    desc.tile_bytes = 2048;
    desc.budget_bytes = 1 << 20;
    shd_assert_ok(shd_tile_cache_create(context, &desc, &cache_));
    for (size_t shape = 0; shape < kShapeCount; ++shape) {
      for (uint32_t store = 0; store < kStores; ++store) {
        const bool flat = kShapes[shape].domain == Domain::kPlane;
        levels_.push_back(std::make_unique<shd::tests::StoredLevels>(kShapes[shape].stored));
        textures_.push_back(
            shd::tests::create(context, levels_.back().get(), kForms[store],
                               SHD_TABLE_MIPMAP | (flat ? SHD_TABLE_RIPMAP | SHD_TABLE_SUMMED_AREA : 0u), cache_));
        if (has_store(kShapes[shape], static_cast<Store>(store))) check_cell(shape, static_cast<Store>(store));
      }
    }
  }
  ~Textures() {
    for (shd_texture* texture : textures_) shd_texture_release(texture);
    shd_tile_cache_release(cache_);
    shd_context_release(context_);
  }
  Textures(const Textures&) = delete;
  Textures& operator=(const Textures&) = delete;

  shd_context* context() const { return context_; }
  const shd_texture* at(size_t shape, Store store) const {
    return textures_[shape * kStores + static_cast<uint32_t>(store)];
  }

 private:
  /// The texture has the domain of its shape and the store.
  void check_cell(size_t shape, Store store) const {
    const auto* const object = reinterpret_cast<const shd::core::Object*>(at(shape, store));
    const auto* const texture =
        static_cast<const Texture*>(shd::core::body_of(object, static_cast<uint32_t>(shd::core::ObjectType::kTexture)));
    assert_true(texture->store == store && domain_of(*texture) == kShapes[shape].domain);
  }

  shd_context* context_;
  shd_tile_cache* cache_ = nullptr;
  std::vector<std::unique_ptr<shd::tests::StoredLevels>> levels_;
  std::vector<shd_texture*> textures_;
};

/// Calls body(simd, textures) for every SIMD target.
template <class Body>
void for_each_target(const Body& body) {
  for (int simd = SHD_SIMD_SCALAR; simd <= SHD_SIMD_WASM; ++simd) {
    shd_context_desc desc = shd_context_desc_default();
    desc.simd = static_cast<shd_simd>(simd);
    shd_context* context = nullptr;
    if (shd_context_create(&desc, &context) == SHD_OK) body(simd, Textures(context));
  }
}

// ---- CellLookups ----

/// Sets of wraps. Textures of directions have none.
constexpr size_t kWrapSets = 2;
constexpr shd_wrap kWraps[kWrapSets][3] = {{SHD_WRAP_REPEAT, SHD_WRAP_MIRROR, SHD_WRAP_CLAMP},
                                           {SHD_WRAP_BORDER, SHD_WRAP_MIRROR_ONCE, SHD_WRAP_REPEAT}};

/// A sampler whose levels and probes are those of the oracles.
inline shd_sampler_desc sampler_desc(shd_filter filter, Use use, size_t wraps) {
  const float border[] = {0.25f, 0.75f, 0.5f, 0.125f};
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.filter = filter;
  desc.profile = SHD_PROFILE_EXACT;
  desc.probe_slack = 0.0f;
  desc.max_anisotropy = 6.0f;
  desc.cubic = SHD_CUBIC_MITCHELL;
  desc.wrap_u = kWraps[wraps][0], desc.wrap_v = kWraps[wraps][1], desc.wrap_w = kWraps[wraps][2];
  std::memcpy(desc.border, border, sizeof border);
  desc.compares = use == Use::kComparison;
  desc.precision = use == Use::kFast ? SHD_PRECISION_FAST : SHD_PRECISION_FULL;
  return desc;
}

constexpr size_t kCount = 43;  // leaves a tail on every target
constexpr float kReferences[] = {80.5f / 255.0f, 127.5f / 255.0f, 180.5f / 255.0f};

/// The lookups of a shape: inside, beyond the wraps, at edges, corners and seams. Footprints are empty, magnified,
/// round, long, and larger than the texture.
struct CellLookups {
  float column[9][kCount], reference[kCount];
  uint32_t layer[kCount], random[kCount];

  explicit CellLookups(const Shape& shape) {
    const shd::tests::TextureShape& s = shape.stored;
    const bool directions = shape.domain == Domain::kDirections;
    const uint32_t size[3] = {s.width, s.height, s.depth ? s.depth : s.width};
    Random generator{s.width * 77u + s.height};
    for (size_t i = 0; i < kCount; ++i) {
      double place[3], footprint[6];
      directions ? set_direction(i, &generator, place) : set_place(i, &generator, place);
      set_footprint(i, &generator, footprint);
      for (size_t c = 0; c < 3; ++c) column[c][i] = static_cast<float>(place[c]);
      for (size_t c = 0; c < 6; ++c) {
        // A face of the cube spans directions of length 2.
        const double texel = directions ? 2.0 / size[0] : 1.0 / size[c % 3];
        column[3 + c][i] = static_cast<float>(footprint[c] * texel);
      }
      reference[i] = kReferences[i % 3];
      layer[i] = directions ? 0 : static_cast<uint32_t>(i / 5) % s.layers;
      random[i] = static_cast<uint32_t>(generator.bits());
    }
  }

  shd_lookups in() const {
    shd_lookups in = shd_lookups_default();
    in.count = kCount;
    shd_f32_in* const ins[9] = {&in.u, &in.v, &in.w, &in.dudx, &in.dvdx, &in.dwdx, &in.dudy, &in.dvdy, &in.dwdy};
    for (int c = 0; c < 9; ++c) *ins[c] = shd_f32_column(column[c], 0);
    in.reference = shd_f32_column(reference, 0);
    in.layer = shd_u32_column(layer, 0);
    in.random = shd_u32_column(random, 0);
    return in;
  }

  ref::UnitLookup at(size_t i) const {
    ref::UnitLookup out = {};
    for (size_t c = 0; c < 3; ++c) {
      out.p[c] = static_cast<double>(column[c][i]);
      out.dx[c] = static_cast<double>(column[3 + c][i]);
      out.dy[c] = static_cast<double>(column[6 + c][i]);
    }
    out.layer = static_cast<int>(layer[i]);
    return out;
  }

 private:
  static void set_place(size_t i, Random* random, double (&place)[3]) {
    for (size_t c = 0; c < 3; ++c) {
      place[c] = i % 3 == 0 ? random->in(-1.4, 2.4) : random->in(0.0, 1.0);
      if (i % 7 == c) place[c] = (i % 2 ? 1.0 : 0.0) + random->in(-0.01, 0.01);  // an edge
    }
  }

  static void set_direction(size_t i, Random* random, double (&n)[3]) {
    for (double& x : n) x = random->in(-1.0, 1.0);
    const size_t c = i % 3, j = (c + 1) % 3, k = (c + 2) % 3;
    if (i % 4 == 1) n[j] = std::copysign(n[c] * random->in(0.96, 1.04), n[j]);  // an edge of a face
    if (i % 8 == 5) n[k] = std::copysign(n[c] * random->in(0.93, 1.07), n[k]);  // a corner
    if (i % 4 == 2) n[j] *= 0.05, n[2] = -std::fabs(n[2]);                      // a folded edge of an octahedral map
    double largest = 0.0;
    for (const double x : n) largest = std::fmax(largest, std::fabs(x));
    for (double& x : n) x /= largest;
  }

  /// Changes in texels.
  static void set_footprint(size_t i, Random* random, double (&d)[6]) {
    const double longest[5] = {0.0, 0.5, 4.0, 9.0, 3.0}, shortest[5] = {0.0, 0.4, 3.0, 1.5, 0.3};
    for (size_t c = 0; c < 6; ++c) {
      const double length = c < 3 ? longest[i % 5] : shortest[i % 5];
      d[c] = length * random->in(0.4, 0.8) * (random->bits() & 1 ? 1.0 : -1.0);
      if (i % 10 == 7 && c % 3 != 1) d[c] = 0.0;
      if (i == 22) d[c] *= 16.0;
    }
  }
};

// ---- Calls ----

/// Columns that a cell writes: its values, and then derivatives, explained values, or bounds.
struct Results {
  float out[16][kCount];

  Results() { std::memset(out, 0, sizeof out); }
  ref::Value at(size_t first, size_t i) const {
    ref::Value value;
    for (size_t c = 0; c < 4; ++c) value[c] = static_cast<double>(out[first + c][i]);
    return value;
  }
  void set(size_t first, shd_f32_out* channels) {
    for (size_t c = 0; c < 4; ++c) channels[c] = shd_f32_out_column(out[first + c], 0);
  }
};

/// The bounds of the rules of SHD_PROFILE_EXACT, with little room.
inline shd_bounds_desc bounds_desc() {
  shd_bounds_desc desc = shd_bounds_desc_default();
  desc.level_rules = SHD_LEVEL_RULE_PROFILE;
  desc.subtexel_bits = desc.level_bits = 10;
  desc.weight_bits = desc.result_bits = 0;
  return desc;
}

/// Calls the functions of a use.
inline shd_result call(Use use, Domain domain, const shd_texture* texture, const shd_sampler* sampler,
                       const CellLookups& lookups, Results* results) {
  const shd_lookups in = lookups.in();
  shd_texels texels = shd_texels_default(), lower = shd_texels_default();
  results->set(0, texels.channel);
  const shd_result values = shd_texture_sample(texture, sampler, &in, &texels);
  if (values != SHD_OK) return values;
  if (use == Use::kGradients) {
    results->set(4, texels.du);
    results->set(8, texels.dv);
    if (domain != Domain::kPlane) results->set(12, texels.dw);
    return shd_texture_sample(texture, sampler, &in, &texels);
  }
  if (use == Use::kBounds) {
    const shd_bounds_desc desc = bounds_desc();
    results->set(4, lower.channel);
    results->set(8, texels.channel);
    return shd_texture_bounds(texture, sampler, &in, &desc, &lower, &texels);
  }
  if (use != Use::kExplanation) return SHD_OK;
  shd_explanation explanation = shd_explanation_default();
  for (size_t i = 0; i < kCount; ++i) {
    const shd_result result = shd_texture_explain(texture, sampler, &in, i, &explanation);
    if (result != SHD_OK) return result;
    for (size_t c = 0; c < 4; ++c) results->out[4 + c][i] = explanation.result[c];
  }
  return SHD_OK;
}

}  // namespace cells
