// SPDX-License-Identifier: MIT
#include "tool/check/judge.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "command/failure.h"

namespace {

constexpr const char* kChannels[4] = {"r", "g", "b", "a"};

struct Input {
  const char* name;
  shd_f32_in shd_lookups::*column;
};
constexpr Input kInputs[] = {{"u", &shd_lookups::u},
                             {"v", &shd_lookups::v},
                             {"w", &shd_lookups::w},
                             {"dudx", &shd_lookups::dudx},
                             {"dvdx", &shd_lookups::dvdx},
                             {"dwdx", &shd_lookups::dwdx},
                             {"dudy", &shd_lookups::dudy},
                             {"dvdy", &shd_lookups::dvdy},
                             {"dwdy", &shd_lookups::dwdy},
                             {"lod", &shd_lookups::lod},
                             {"reference", &shd_lookups::reference}};

bool is_known(const std::string& name) {
  for (const Input& input : kInputs) {
    if (name == input.name) return true;
  }
  return name == "layer" || std::find(std::begin(kChannels), std::end(kChannels), name) != std::end(kChannels);
}

uint32_t layer_of(float value) {
  return value >= 0.0f && value < 65536.0f ? static_cast<uint32_t>(value) : value > 0.0f ? 65535u : 0u;
}

/// Distance of a value from its bounds; infinite for NaN, unless nothing bounds it.
float distance(float value, float low, float high) {
  if (std::isnan(value)) return std::isinf(low) && std::isinf(high) ? 0.0f : INFINITY;
  return value < low ? low - value : value > high ? value - high : 0.0f;
}

void print_taps(const Case& judged, size_t row) {
  std::vector<shd_tap> taps(4096);
  shd_explanation explanation = shd_explanation_default();
  explanation.taps = taps.data();
  explanation.tap_capacity = static_cast<uint32_t>(taps.size());
  if (shd_texture_explain(judged.texture, judged.sampler, &judged.lookups, row, &explanation) != SHD_OK) return;
  const size_t count = std::min<size_t>(explanation.tap_count, taps.size()), shown = std::min<size_t>(count, 16);
  std::printf("    texels (layer level x y: weight):");
  for (size_t i = 0; i < shown; ++i) {
    const shd_tap& tap = taps[i];
    std::printf(" (%u %u %u %u%s: %.3g)", tap.layer, tap.level_u, tap.x, tap.y, tap.border ? " border" : "",
                static_cast<double>(tap.weight));
  }
  std::printf(count > shown ? " and %zu more\n" : "\n", count - shown);
}

}  // namespace

Case make_case(const Options& options, const Table& table, std::vector<uint32_t>* layers) {
  Case out = {};
  out.lookups = shd_lookups_default();
  out.lookups.count = table.rows();
  for (const auto& column : table.columns) {
    if (!is_known(column.first))
      throw Failure(kExitInput, options.lookups + ": column " + column.first + " is not known");
  }
  for (const Input& input : kInputs) {
    if (const auto* column = table.find(input.name)) (out.lookups.*input.column).data = column->data();
  }
  if (!table.find("u") || !table.find("v")) throw Failure(kExitInput, options.lookups + ": no columns u and v");
  if (const auto* column = table.find("layer")) {
    for (const float value : *column) layers->push_back(layer_of(value));
    out.lookups.layer.data = layers->data();
  }
  bool any = false;
  for (int c = 0; c < 4; ++c) any = (out.result[c] = table.find(kChannels[c])) || any;
  if (!any) throw Failure(kExitInput, options.lookups + ": no column r, g, b or a, and no --results");
  return out;
}

Bounds find_bounds(const Case& judged, const shd_bounds_desc& desc) {
  Bounds out;
  shd_texels lower = shd_texels_default(), upper = shd_texels_default();
  for (int c = 0; c < 4; ++c) {
    out.low[c].resize(judged.lookups.count);
    out.high[c].resize(judged.lookups.count);
    lower.channel[c].data = out.low[c].data();
    upper.channel[c].data = out.high[c].data();
  }
  check(shd_texture_bounds(judged.texture, judged.sampler, &judged.lookups, &desc, &lower, &upper), "bounds",
        kExitUsage);
  return out;
}

int worst_channel(const Case& judged, const Bounds& bounds, size_t row) {
  int worst = -1;
  float farthest = 0.0f;
  for (int c = 0; c < 4; ++c) {
    if (!judged.result[c]) continue;
    const float away = distance((*judged.result[c])[row], bounds.low[c][row], bounds.high[c][row]);
    if (away > farthest) {
      farthest = away;
      worst = c;
    }
  }
  return worst;
}

void describe(const Case& judged, const Bounds& bounds, size_t row, int channel) {
  const float value = (*judged.result[channel])[row], low = bounds.low[channel][row], high = bounds.high[channel][row];
  const float nearest = value > high ? high : low;
  std::printf("row %zu: %s = %.9g is not in %.9g..%.9g; nearest legal value %.9g\n", row, kChannels[channel],
              static_cast<double>(value), static_cast<double>(low), static_cast<double>(high),
              static_cast<double>(nearest));
  print_taps(judged, row);
}
