// SPDX-License-Identifier: MIT
// Random textures, samplers and lookups, valid and invalid. No call may crash, leak, write outside its columns, give a
// non-finite value from finite texels, or give other bits on another SIMD target. The replay of an explanation gives
// the bits of the lookup.
#include "mutator.h"
#include "texture_case.h"

#include <cfloat>

namespace shd::fuzz {
namespace {

constexpr size_t kMaxLookups = 8;
constexpr size_t kOutputs = 16;  // channel, du, dv, dw
constexpr int kColumns = 10;
constexpr uint32_t kMaxTaps = 4096;

/// The arguments that one input describes, so that they can run on several contexts.
struct Case {
  TextureCase texture;
  shd_sampler_desc sampler = shd_sampler_desc_default();
  size_t count = 0;
  std::vector<float> columns[kColumns];  // u, v, dudx, dvdx, dudy, dvdy, lod, w, dwdx, dwdy
  size_t steps[kColumns] = {};
  std::vector<uint32_t> integers[2];  // layer, random
  uint32_t outputs = 0;               // bits
  size_t out_step = 1;
  uint64_t budget = 0;
};

void choose_column(Source& source, Case& c, int k, float scale) {
  c.steps[k] = 1 + source.below(2);
  const bool hostile = source.one_in(4);
  c.columns[k].resize(c.count == 0 ? 1 : (c.count - 1) * c.steps[k] + 1);
  for (size_t i = 0; i < c.count; ++i) {
    c.columns[k][i * c.steps[k]] = hostile ? source.hostile() : scale * source.real();
  }
}

void choose_lookups(Source& source, Case& c) {
  c.count = source.below(kMaxLookups + 1);
  for (int k = 0; k < 7; ++k) {
    if (k >= 2 && source.one_in(k == 6 ? 2 : 8)) continue;
    choose_column(source, c, k, k < 2 ? 2.0f : k < 6 ? 0.5f : 4.0f);
  }
  for (std::vector<uint32_t>& column : c.integers) {
    if (!source.one_in(4)) continue;
    column.resize(c.count + 1);
    for (size_t i = 0; i < c.count; ++i) column[i] = source.one_in(2) ? source.word() : source.below(4);
  }
  c.outputs = source.one_in(4) ? source.below(1 << 12) : 15;
  c.out_step = 1 + source.below(2);
}

/// Turns the layers of a texture into slices.
void choose_slices(Source& source, Case& c) {
  if (!source.one_in(4) || c.texture.desc.layers > 3) return;  // more layers have no texels
  c.texture.desc.depth = c.texture.desc.layers;
  c.texture.desc.layers = 1;
  c.texture.desc.level_count = 0;
  if (!source.one_in(8)) c.texture.desc.tables &= SHD_TABLE_MIPMAP;
  c.sampler.wrap_w = static_cast<shd_wrap>(source.below(source.one_in(16) ? 8 : 5));
  if (!source.one_in(8)) c.sampler.profile = SHD_PROFILE_LEAST_ERROR;
  if (!source.one_in(8)) c.sampler.blur_u = c.sampler.blur_v = 0.0f;
  for (int k = 7; k < kColumns; ++k) {
    if (!source.one_in(8)) choose_column(source, c, k, k == 7 ? 2.0f : 0.5f);
  }
  if (source.one_in(4)) c.outputs |= source.below(16) << 12;
}

/// Makes the texture one of directions, of at most 5 x 5 texels a face.
void choose_directions(Source& source, Case& c) {
  shd_texture_desc& desc = c.texture.desc;
  desc.projection = source.constant<shd_projection>(6);
  for (int k = 7; k < 10; ++k) {
    if (!source.one_in(16)) choose_column(source, c, k, k == 7 ? 2.0f : 0.5f);
  }
  if (!desc.texels || desc.width - 1 >= 9 || desc.height - 1 >= 9 || desc.layers > 6 || desc.flags || source.one_in(32))
    return;
  if (desc.projection != SHD_PROJECTION_LAT_LONG) desc.width = desc.height = desc.width < 5 ? desc.width : 5;
  if (desc.projection == SHD_PROJECTION_CUBE) desc.layers = 6;
  if (!source.one_in(32)) desc.tables &= SHD_TABLE_MIPMAP;
  const size_t pixel = shd_format_size(desc.format);
  const size_t stride = desc.row_stride ? desc.row_stride : desc.width * pixel;
  const size_t given = c.texture.texels.size(), size = stride * desc.height * desc.layers;
  for (size_t i = given; given > 0 && i < size; ++i) c.texture.texels.push_back(c.texture.texels[i - given]);
  desc.texels = c.texture.texels.data();
}

void choose_case(Source& source, Case& c) {
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

shd_lookups make_lookups(const Case& c) {
  shd_lookups lookups = shd_lookups_default();
  lookups.count = c.count;
  shd_f32_in* columns[kColumns] = {&lookups.u,    &lookups.v,   &lookups.dudx, &lookups.dvdx, &lookups.dudy,
                                   &lookups.dvdy, &lookups.lod, &lookups.w,    &lookups.dwdx, &lookups.dwdy};
  for (int k = 0; k < kColumns; ++k) {
    if (!c.columns[k].empty()) *columns[k] = shd_f32_column(c.columns[k].data(), 4 * c.steps[k]);
  }
  if (!c.integers[0].empty()) lookups.layer.data = c.integers[0].data();
  if (!c.integers[1].empty()) lookups.random.data = c.integers[1].data();
  return lookups;
}

/// Results of one run.
struct Output {
  bool made = false;
  size_t nonfinite_count = 0;
  std::vector<float> values;
};

struct Objects {
  shd_texture* texture = nullptr;
  shd_sampler* sampler = nullptr;
  ~Objects() {
    shd_sampler_release(sampler);
    shd_texture_release(texture);
  }
};

/// Whether shd/lookup.h promises that every value is finite.
bool promises_finite(const Case& c) {
  const shd_format format = c.texture.desc.format;
  if (is_half(format) || is_float(format)) return c.texture.finite;
  for (const float border : c.sampler.border) {
    if (std::fabs(border) > 1e30f) return false;
  }
  return true;
}

void sample(const Host& host, const Case& c, const Objects& o, Output& output) {
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

void query_levels(const Host& host, const Case& c, const Objects& o, Output& output) {
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

void check_taps(const Case& c, const shd_explanation& e) {
  SHD_FUZZ_CHECK(e.tap_count > 0 && e.tap_count <= kMaxTaps && e.blend_count < e.tap_count);
  for (uint32_t i = 0; i < e.tap_count; ++i) {
    const shd_tap& tap = e.taps[i];
    SHD_FUZZ_CHECK(tap.layer < c.texture.desc.layers && tap.level_u < 32 && tap.level_v < 32);
    const uint32_t width = c.texture.desc.width >> tap.level_u, height = c.texture.desc.height >> tap.level_v;
    const uint32_t depth = c.texture.desc.depth >> tap.level_u;
    SHD_FUZZ_CHECK(tap.z < (depth ? depth : 1));
    SHD_FUZZ_CHECK(tap.border == 1 ||
                   (tap.border == 0 && tap.x < (width ? width : 1) && tap.y < (height ? height : 1)));
  }
}

void explain(const Host& host, const Case& c, const Objects& o, const Output& output) {
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
void run(const Case& c, shd_simd simd, Output& output) {
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
  Case c;
  choose_case(source, c);
}

}  // namespace shd::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace shd::fuzz;
  compare_targets<Case, Output>(data, size, choose_case, run, [](const Output& best, const Output& baseline) {
    SHD_FUZZ_CHECK(baseline.made == best.made);
    SHD_FUZZ_CHECK(best.nonfinite_count == baseline.nonfinite_count);
    SHD_FUZZ_CHECK(same_values(best.values, baseline.values));
  });
  return 0;
}
