// SPDX-License-Identifier: MIT
#include "explanation.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstring>

namespace viewer {
namespace {

constexpr int kMargin = 2;       // texels shown around the taps
constexpr int kMostTexels = 96;  // per side of a view

/// Columns of one lookup.
shd_lookups one(const Lookup& lookup) {
  shd::lookups lookups;
  lookups.count = 1;
  lookups.u = shd_f32_column(&lookup.u, 0), lookups.v = shd_f32_column(&lookup.v, 0);
  lookups.dudx = shd_f32_column(&lookup.dudx, 0), lookups.dvdx = shd_f32_column(&lookup.dvdx, 0);
  lookups.dudy = shd_f32_column(&lookup.dudy, 0), lookups.dvdy = shd_f32_column(&lookup.dvdy, 0);
  return lookups;
}

/// A blend of the tree, as shd/explain.h defines it.
float blend(float a, float b, float s) {
  if (s == 0.0f) return a;
  const float v = a + s * (b - a);
  if (std::isfinite(v)) return v;
  const float w = (1.0f - s) * a + s * b;
  return std::isfinite(a) && std::isfinite(b) ? std::clamp(w, -FLT_MAX, FLT_MAX) : w;
}

/// Repeats the blends of channel `c` of the result.
float replay(const std::vector<shd_tap>& taps, const std::vector<shd_blend_step>& blends, const shd_explanation& e,
             int c) {
  const uint32_t source = e.channel_source[c];
  if (source >= 4) return e.result[c];  // the texture's fill
  std::vector<float> nodes;
  for (const shd_tap& tap : taps) nodes.push_back(tap.value[source]);
  for (const shd_blend_step& step : blends) nodes.push_back(blend(nodes[step.a], nodes[step.b], step.s));
  if (nodes.empty()) return 0.0f;
  const float v = nodes.back();
  return e.scale_low[source] == 0.0f ? v : v * e.scale_high[source] + v * e.scale_low[source];
}

float weighted_sum(const std::vector<shd_tap>& taps, const shd_explanation& e, int c) {
  const uint32_t source = e.channel_source[c];
  if (source >= 4) return e.result[c];
  const double scale = e.scale_low[source] == 0.0f ? 1.0 : double(e.scale_high[source]) + e.scale_low[source];
  double sum = 0.0;
  for (const shd_tap& tap : taps) sum += tap.weight == 0.0f ? 0.0 : double(tap.weight) * tap.value[source];
  return static_cast<float>(sum * scale);
}

uint32_t halved(uint32_t size, uint32_t level) {
  return std::max(size >> std::min(level, 31u), 1u);
}

uint8_t encoded(float linear) {
  if (!(linear > 0.0f)) return 0;
  const float x = std::min(linear, 1.0f);
  const float code = x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
  return static_cast<uint8_t>(std::lround(255.0f * code));
}

float fraction(float x) {
  return std::isfinite(x) ? x - std::floor(x) : 0.0f;
}

/// Reads the texels of a view: lookups at their centres, with footprints of one texel of the level. A ripmap has more
/// levels than a mipmap.
void read_texels(shd_context* context, const shd_texture* texture, const Explanation& e, shd_wrap wrap_u,
                 shd_wrap wrap_v, LevelView& view) {
  const bool is_mip = view.level_u == view.level_v;
  shd::sampler_desc desc;
  desc.filter = is_mip ? SHD_FILTER_NEAREST_MIP : SHD_FILTER_RIPMAP;
  desc.profile = SHD_PROFILE_EXACT;
  desc.wrap_u = wrap_u, desc.wrap_v = wrap_v;
  const shd::sampler sampler = shd::sampler_create(context, &desc);
  const size_t count = size_t(view.columns) * size_t(view.rows);
  const std::vector<float> dudx(count, std::ldexp(1.0f, int(view.level_u)) / float(e.width));
  const std::vector<float> dvdy(count, std::ldexp(1.0f, int(view.level_v)) / float(e.height));
  const std::vector<float> lod(count, float(view.level_u));
  std::vector<float> u, v, channel[4];
  for (int row = 0; row < view.rows; ++row) {
    for (int column = 0; column < view.columns; ++column) {
      u.push_back((float(view.x + column) + 0.5f) / float(view.width));
      v.push_back((float(view.y + row) + 0.5f) / float(view.height));
    }
  }
  shd::lookups lookups;
  lookups.count = count;
  lookups.u = shd::in(u), lookups.v = shd::in(v);
  if (is_mip) lookups.lod = shd::in(lod);
  if (!is_mip) lookups.dudx = shd::in(dudx), lookups.dvdy = shd::in(dvdy);
  shd::texels texels;
  for (size_t c = 0; c < 4; ++c) {
    channel[c].resize(count);
    texels.channel[c] = shd::out(channel[c]);
  }
  shd::texture_sample(texture, sampler, &lookups, &texels);
  view.pixels.resize(4 * count);
  for (size_t i = 0; i < count; ++i) {
    for (size_t c = 0; c < 4; ++c) view.pixels[4 * i + c] = c < 3 ? encoded(channel[c][i]) : 255;
  }
}

/// Sets the window of texels: the taps and the footprint, limited around the point of the lookup.
void place(const std::vector<Tap>& taps, LevelView& view) {
  int low[2], high[2];
  for (int axis = 0; axis < 2; ++axis) {
    const float reach = std::hypot(view.footprint[0][axis], view.footprint[1][axis]);
    const float limit = std::min(reach, 0.5f * kMostTexels);
    low[axis] = static_cast<int>(std::floor(view.center[axis] - limit));
    high[axis] = static_cast<int>(std::floor(view.center[axis] + limit));
  }
  for (const Tap& tap : taps) {
    if (tap.tap.level_u != view.level_u || tap.tap.level_v != view.level_v || tap.tap.border) continue;
    const int at[2] = {tap.x, tap.y};
    for (int axis = 0; axis < 2; ++axis) {
      low[axis] = std::min(low[axis], at[axis]);
      high[axis] = std::max(high[axis], at[axis]);
    }
  }
  // The shorter side gets more texels, so that the view has about the shape of its place on the screen.
  const int spans[2] = {high[0] - low[0] + 1 + 2 * kMargin, high[1] - low[1] + 1 + 2 * kMargin};
  const int wanted[2] = {std::max(spans[0], spans[1] * 8 / 7), std::max(spans[1], spans[0] * 7 / 8)};
  int* const first[2] = {&view.x, &view.y};
  int* const count[2] = {&view.columns, &view.rows};
  for (int axis = 0; axis < 2; ++axis) {
    const int middle = static_cast<int>(std::floor(view.center[axis])), extra = wanted[axis] - spans[axis];
    const int last = std::min(high[axis] + kMargin + extra / 2, middle + kMostTexels / 2);
    *first[axis] = std::max(low[axis] - kMargin - (extra + 1) / 2, middle - kMostTexels / 2);
    *count[axis] = last - *first[axis] + 1;
  }
}

LevelView& view_of(const shd_tap& tap, Explanation& e) {
  for (LevelView& view : e.levels) {
    if (view.level_u == tap.level_u && view.level_v == tap.level_v) return view;
  }
  e.levels.emplace_back();
  LevelView& view = e.levels.back();
  view.level_u = tap.level_u, view.level_v = tap.level_v;
  view.width = halved(e.width, tap.level_u), view.height = halved(e.height, tap.level_v);
  return view;
}

/// Calls shd_texture_explain() twice: for the counts, then with memory.
shd_explanation ask(const shd_texture* texture, const shd_sampler* sampler, const shd_lookups& lookups,
                    std::vector<shd_tap>& taps, std::vector<shd_blend_step>& blends) {
  shd::explanation e;
  shd::texture_explain(texture, sampler, &lookups, 0, &e);
  taps.resize(e.tap_count);
  blends.resize(e.blend_count);
  e.taps = taps.data(), e.tap_capacity = e.tap_count;
  e.blends = blends.data(), e.blend_capacity = e.blend_count;
  shd::texture_explain(texture, sampler, &lookups, 0, &e);
  return e;
}

void sample(const shd_texture* texture, const shd_sampler* sampler, const shd_lookups& lookups,
            std::array<float, 4>& out) {
  shd::texels texels;
  for (size_t c = 0; c < 4; ++c) texels.channel[c] = shd_f32_out_column(&out[c], 0);
  shd::texture_sample(texture, sampler, &lookups, &texels);
}

}  // namespace

Lookup transformed(const Lookup& in, const float* t) {
  Lookup out;
  out.u = t[0] * in.u + t[1] * in.v + t[2];
  out.v = t[3] * in.u + t[4] * in.v + t[5];
  out.dudx = t[0] * in.dudx + t[1] * in.dvdx;
  out.dvdx = t[3] * in.dudx + t[4] * in.dvdx;
  out.dudy = t[0] * in.dudy + t[1] * in.dvdy;
  out.dvdy = t[3] * in.dudy + t[4] * in.dvdy;
  return out;
}

int unwrapped(uint32_t texel, uint32_t size, shd_wrap wrap, float near) {
  const int i = static_cast<int>(texel), n = static_cast<int>(size);
  const auto closest = [near](int first, int period) {
    return first + period * static_cast<int>(std::lround((near - (float(first) + 0.5f)) / float(period)));
  };
  if (wrap == SHD_WRAP_REPEAT) return closest(i, n);
  if (wrap != SHD_WRAP_MIRROR) return i;
  const int even = closest(i, 2 * n), odd = closest(-1 - i, 2 * n);
  return std::abs(float(even) + 0.5f - near) <= std::abs(float(odd) + 0.5f - near) ? even : odd;
}

void explain(shd_context* context, const shd_texture* texture, const shd_sampler* sampler, shd_wrap wrap_u,
             shd_wrap wrap_v, Explanation& out) {
  const shd_texture_info info = shd::texture_get_info(texture);
  out.width = info.width, out.height = info.height, out.level_count = info.level_count;
  const shd_lookups lookups = one(out.lookup);
  sample(texture, sampler, lookups, out.sampled);
  std::vector<shd_tap> taps;
  std::vector<shd_blend_step> blends;
  const shd_explanation e = ask(texture, sampler, lookups, taps, blends);
  out.filter = e.filter;
  out.lod = e.lod;
  out.replay_is_exact = true;
  for (int c = 0; c < 4; ++c) {
    const float again = replay(taps, blends, e, c);
    out.explained[c] = e.result[c];
    out.weighted[c] = weighted_sum(taps, e, c);
    if (std::memcmp(&again, &e.result[c], sizeof again) != 0) out.replay_is_exact = false;
  }
  const float u = wrap_u == SHD_WRAP_REPEAT ? fraction(out.lookup.u) : out.lookup.u;
  const float v = wrap_v == SHD_WRAP_REPEAT ? fraction(out.lookup.v) : out.lookup.v;
  for (const shd_tap& tap : taps) {
    LevelView& view = view_of(tap, out);
    const float across = float(view.width) / float(info.width), down = float(view.height) / float(info.height);
    view.share += tap.weight;
    view.center[0] = u * float(view.width), view.center[1] = v * float(view.height);
    view.footprint[0][0] = e.longer_axis[0] * across, view.footprint[0][1] = e.longer_axis[1] * down;
    view.footprint[1][0] = e.shorter_axis[0] * across, view.footprint[1][1] = e.shorter_axis[1] * down;
    out.taps.push_back({tap, unwrapped(tap.x, view.width, wrap_u, view.center[0]),
                        unwrapped(tap.y, view.height, wrap_v, view.center[1])});
  }
  for (LevelView& view : out.levels) {
    place(out.taps, view);
    read_texels(context, texture, out, wrap_u, wrap_v, view);
  }
  std::stable_sort(out.levels.begin(), out.levels.end(),
                   [](const LevelView& a, const LevelView& b) { return a.share > b.share; });
}

float weighted_error(const Explanation& explanation) {
  float error = 0.0f;
  for (size_t c = 0; c < 4; ++c) error = std::max(error, std::abs(explanation.weighted[c] - explanation.sampled[c]));
  return error;
}

}  // namespace viewer
