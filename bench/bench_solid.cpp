// SPDX-License-Identifier: MIT
// solid/<kind>/<target>: shd_solid_evaluate of 4096 random places in 256^3 cells, one octave, on one thread; items are
// evaluations. _gradient rows also compute the gradient, _color rows the colours; _6_octaves and _banded sum six
// octaves, the latter with widths that keep about three.
#include <string>

#include "bench.h"

namespace shd::bench {
namespace {

constexpr size_t kPlaces = 4096;

struct Kind {
  const char* name;
  shd_solid kind;
  shd_solid_gradients gradients;
  shd_solid_fade fade;
  shd_solid_distance distance;
};
constexpr shd_solid_gradients kHashed = SHD_SOLID_GRADIENTS_HASHED, kTable = SHD_SOLID_GRADIENTS_TABLE;
constexpr shd_solid_fade kQuintic = SHD_SOLID_FADE_QUINTIC, kCubic = SHD_SOLID_FADE_CUBIC;
constexpr shd_solid_distance kF1 = SHD_SOLID_DISTANCE_F1;
constexpr Kind kKinds[] = {
    {"stripes", SHD_SOLID_STRIPES, kHashed, kQuintic, kF1},
    {"checker", SHD_SOLID_CHECKER, kHashed, kQuintic, kF1},
    {"perlin", SHD_SOLID_PERLIN, kHashed, kQuintic, kF1},
    {"perlin_table", SHD_SOLID_PERLIN, kTable, kCubic, kF1},
    {"value", SHD_SOLID_VALUE, kHashed, kQuintic, kF1},
    {"simplex", SHD_SOLID_SIMPLEX, kHashed, kQuintic, kF1},
    {"worley_f1", SHD_SOLID_WORLEY, kHashed, kQuintic, kF1},
    {"worley_f2_f1", SHD_SOLID_WORLEY, kHashed, kQuintic, SHD_SOLID_DISTANCE_F2_F1},
    {"marble", SHD_SOLID_MARBLE, kHashed, kQuintic, kF1},
    {"wood", SHD_SOLID_WOOD, kHashed, kQuintic, kF1},
};

struct Variant {
  const char* suffix;
  uint32_t octaves;
  bool has_gradient, has_color, has_width;
};
constexpr Variant kVariants[] = {{"", 1, false, false, false},
                                 {"_gradient", 1, true, false, false},
                                 {"_color", 1, false, true, false},
                                 {"_6_octaves", 6, false, false, false},
                                 {"_banded", 6, false, false, true}};

/// Random places and widths, and columns for the results.
struct Columns {
  std::vector<float> in[4], out[8];

  Columns() {
    uint32_t random = 1;
    const auto next = [&] {
      random = random * 1664525u + 1013904223u;
      return static_cast<float>(random >> 8) * 0x1p-24f;
    };
    for (auto& column : in) column.resize(kPlaces);
    for (auto& column : out) column.resize(kPlaces);
    for (size_t i = 0; i < kPlaces; ++i) {
      for (size_t c = 0; c < 3; ++c) in[c][i] = 256.0f * next() - 128.0f;
      in[3][i] = 0.05f + 0.1f * next();
    }
  }
};

void run(benchmark::State& state, shd_simd simd, const Kind& kind, const Variant& variant) {
  static Columns columns;
  shd_context* context = make_context(simd);
  shd_solid_desc desc = shd_solid_desc_default();
  desc.kind = kind.kind;
  desc.gradients = kind.gradients;
  desc.fade = kind.fade;
  desc.distance = kind.distance;
  desc.octaves = variant.octaves;
  shd_solid_points points = shd_solid_points_default();
  points.count = kPlaces;
  for (size_t c = 0; c < 3; ++c) points.position[c].data = columns.in[c].data();
  if (variant.has_width) points.width.data = columns.in[3].data();
  shd_solid_values values = shd_solid_values_default();
  if (!variant.has_color) values.value.data = columns.out[0].data();
  for (size_t c = 0; c < 3 && variant.has_gradient; ++c) values.gradient[c].data = columns.out[1 + c].data();
  for (size_t c = 0; c < 4 && variant.has_color; ++c) values.channel[c].data = columns.out[4 + c].data();
  for (auto _ : state) check(shd_solid_evaluate(context, &desc, &points, &values));
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(kPlaces));
  shd_context_release(context);
}

bool is_measured(const Kind& kind, const Variant& variant) {
  const bool is_wave = kind.kind == SHD_SOLID_STRIPES || kind.kind == SHD_SOLID_CHECKER;
  return variant.octaves == 1 || !is_wave;
}

}  // namespace

void register_solid() {
  for (const Kind& kind : kKinds) {
    for (const Variant& variant : kVariants) {
      if (!is_measured(kind, variant)) continue;
      for (const Target& target : targets()) {
        const std::string name = std::string("solid/") + kind.name + variant.suffix + "/" + target.name;
        benchmark::RegisterBenchmark(name.c_str(), [&kind, &variant, simd = target.simd](benchmark::State& state) {
          run(state, simd, kind, variant);
        });
      }
    }
  }
}

}  // namespace shd::bench
