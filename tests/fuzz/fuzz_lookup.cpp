// SPDX-License-Identifier: MIT
// Random textures, samplers and lookups, valid and invalid. No call may crash, leak, write outside its columns, give a
// non-finite value from finite texels, or give other bits on another SIMD target. The replay of an explanation gives
// the bits of the lookup.
#include "lookup_case.h"
#include "mutator.h"

#include <cfloat>

namespace shd::fuzz {
namespace {

constexpr size_t kOutputs = 16;  // channel, du, dv, dw
constexpr uint32_t kMaxTaps = 4096;

void choose_case(Source& source, LookupCase& c) {
  c.budget = choose_budget(source);
  choose_sampler(source, c.sampler);
  choose_texture(source, c.texture, 9);
  choose_lookups(source, c);
  if (c.sampler.filter == SHD_FILTER_EXACT && c.count > 2) c.count = 2;
  if (source.one_in(3)) {
    choose_directions(source, c);
  } else {
    choose_slices(source, c);
  }
}

/// Results of one run.
struct Output {
  bool made = false;
  size_t nonfinite_count = 0;
  std::vector<float> values;
};

/// Whether shd/lookup.h promises that every value is finite.
bool promises_finite(const LookupCase& c) {
  const shd_format format = c.texture.desc.format;
  if (is_half(format) || is_float(format)) return c.texture.finite;
  for (const float border : c.sampler.border) {
    if (std::fabs(border) > 1e30f) return false;
  }
  return true;
}

void sample(const Host& host, const LookupCase& c, const Objects& o, Output& output) {
  const shd_lookups lookups = make_lookups(c);
  shd_texels out = shd_texels_default();
  shd_f32_out* places[kOutputs];
  for (int k = 0; k < 4; ++k) {
    places[k] = &out.channel[k];
    places[4 + k] = &out.du[k];
    places[8 + k] = &out.dv[k];
    places[12 + k] = &out.dw[k];
  }
  std::vector<Column<float>> columns(kOutputs, Column<float>(c.count, c.out_step, kCanary));
  for (size_t k = 0; k < kOutputs; ++k) {
    if (c.outputs >> k & 1) *places[k] = to_column(columns[k]);
  }
  output.made = host.ok(shd_texture_sample(o.texture, o.sampler, &lookups, &out));
  SHD_FUZZ_CHECK(out.nonfinite_count <= c.count);
  output.nonfinite_count = out.nonfinite_count;
  for (size_t k = 0; k < kOutputs; ++k) {
    columns[k].check_canaries(output.made && c.outputs >> k & 1 ? c.count : 0);
    for (size_t i = 0; i < c.count; ++i) output.values.push_back(columns[k][i]);
  }
  if (!output.made || !promises_finite(c)) return;
  for (const float value : output.values) SHD_FUZZ_CHECK(std::isfinite(value));
}

void query_levels(const Host& host, const LookupCase& c, const Objects& o, Output& output) {
  const shd_lookups lookups = make_lookups(c);
  Column<float> lod(c.count, c.out_step, kCanary);
  Column<uint32_t> level(c.count, c.out_step, kCanaryWord);
  shd_levels out = shd_levels_default();
  out.lod = to_column(lod);
  out.level = to_column(level);
  const bool made = host.ok(shd_texture_query_levels(o.texture, o.sampler, &lookups, &out));
  lod.check_canaries(made ? c.count : 0);
  level.check_canaries(made ? c.count : 0);
  for (size_t i = 0; made && i < c.count; ++i) {
    SHD_FUZZ_CHECK(std::isfinite(lod[i]));
    SHD_FUZZ_CHECK(level[i] <= 32);
    output.values.push_back(lod[i]);
  }
}

/// A blend as shd/explain.h defines it.
float blend(float a, float b, float s) {
  if (s == 0) return a;
  float mixed = a + s * (b - a);
  if (!std::isfinite(mixed)) mixed = (1 - s) * a + s * b;
  if (std::isfinite(a) && std::isfinite(b)) mixed = mixed > FLT_MAX ? FLT_MAX : mixed < -FLT_MAX ? -FLT_MAX : mixed;
  return mixed;
}

/// Stored channel c of the result, computed from the tree of blends.
float replay(const shd_explanation& e, uint32_t c, std::vector<float>& nodes) {
  nodes.clear();
  for (uint32_t i = 0; i < e.tap_count; ++i) nodes.push_back(e.taps[i].value[c]);
  for (uint32_t i = 0; i < e.blend_count; ++i) {
    const shd_blend_step& step = e.blends[i];
    SHD_FUZZ_CHECK(step.a < nodes.size() && step.b < nodes.size());
    nodes.push_back(blend(nodes[step.a], nodes[step.b], step.s));
  }
  const float last = nodes.back();
  return e.scale_low[c] == 0 ? last : last * e.scale_high[c] + last * e.scale_low[c];
}

void check_taps(const LookupCase& c, const shd_explanation& e) {
  SHD_FUZZ_CHECK(e.tap_count > 0 && e.tap_count <= kMaxTaps && e.blend_count < e.tap_count);
  for (uint32_t i = 0; i < e.tap_count; ++i) {
    const shd_tap& tap = e.taps[i];
    SHD_FUZZ_CHECK(tap.layer < c.texture.desc.layer_count && tap.level_u < 32 && tap.level_v < 32);
    const uint32_t width = c.texture.desc.width >> tap.level_u, height = c.texture.desc.height >> tap.level_v;
    const uint32_t depth = c.texture.desc.depth >> tap.level_u;
    SHD_FUZZ_CHECK(tap.z < (depth ? depth : 1));
    SHD_FUZZ_CHECK(tap.border == 1 ||
                   (tap.border == 0 && tap.x < (width ? width : 1) && tap.y < (height ? height : 1)));
  }
}

void explain(const Host& host, const LookupCase& c, const Objects& o, const Output& output) {
  static std::vector<shd_tap> taps(kMaxTaps);
  static std::vector<shd_blend_step> blends(kMaxTaps);
  static std::vector<float> nodes;
  const shd_lookups lookups = make_lookups(c);
  shd_explanation e = shd_explanation_default();
  e.taps = taps.data(), e.tap_capacity = kMaxTaps;
  e.blends = blends.data(), e.blend_capacity = kMaxTaps;
  if (!host.ok(shd_texture_explain(o.texture, o.sampler, &lookups, c.count - 1, &e))) return;
  check_taps(c, e);
  for (uint32_t k = 0; k < 4; ++k) {
    const float want = output.values[k * c.count + c.count - 1];
    const bool is_full = c.sampler.precision == SHD_PRECISION_FULL;  // as explanations are
    if (output.made && is_full && c.outputs >> k & 1) SHD_FUZZ_CHECK(same_value(e.result[k], want));
    SHD_FUZZ_CHECK(e.channel_source[k] <= 4);
    if (e.channel_source[k] < 4) SHD_FUZZ_CHECK(same_value(replay(e, e.channel_source[k], nodes), e.result[k]));
  }
}

/// Runs the case on one target.
void run(const LookupCase& c, shd_simd simd, Output& output) {
  Host host(simd, c.budget);
  if (!host.context) return;
  Objects o;
  if (host.ok(shd_texture_create(host.context, &c.texture.desc, &o.texture)) &&
      host.ok(shd_sampler_create(host.context, &c.sampler, &o.sampler))) {
    sample(host, c, o, output);
    query_levels(host, c, o, output);
    if (c.count > 0) explain(host, c, o, output);
  } else {
    SHD_FUZZ_CHECK(!o.sampler);
  }
}

}  // namespace

void describe(Source& source) {
  LookupCase c;
  choose_case(source, c);
}

}  // namespace shd::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace shd::fuzz;
  compare_targets<LookupCase, Output>(data, size, choose_case, run, [](const Output& best, const Output& baseline) {
    SHD_FUZZ_CHECK(baseline.made == best.made);
    SHD_FUZZ_CHECK(best.nonfinite_count == baseline.nonfinite_count);
    SHD_FUZZ_CHECK(same_values(best.values, baseline.values));
  });
  return 0;
}
