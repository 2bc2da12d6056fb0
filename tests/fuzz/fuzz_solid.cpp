// SPDX-License-Identifier: MIT
// Random solid textures at random places, valid and invalid. Values lie in the range of their kind, gradients and
// colours are finite, nothing is written beside the columns, and every target gives the same bits.
#include "host.h"
#include "mutator.h"

namespace shd::fuzz {
namespace {

constexpr size_t kMaxPlaces = 20, kOutputs = 8;  // value, gradient, color

struct Case {
  shd_solid_desc desc = shd_solid_desc_default();
  size_t count = 0, in_step = 1, out_step = 1;
  std::vector<float> columns[4];  // x, y, z, width
  uint32_t outputs = 0;           // bits
  bool has_width = false;
  uint64_t budget = 0;
};

void choose_desc(Source& source, shd_solid_desc& desc) {
  desc.kind = source.constant<shd_solid>(SHD_SOLID_WOOD + 1);
  desc.seed = source.word();
  desc.octaves = source.one_in(32) ? source.word() : 1 + source.below(32);
  desc.sum = source.constant<shd_solid_sum>(2);
  desc.gradients = source.constant<shd_solid_gradients>(2);
  desc.fade = source.constant<shd_solid_fade>(3);
  desc.distance = source.constant<shd_solid_distance>(3);
  desc.size = source.one_in(2) ? 1.0f : std::exp2(source.real(-100.0f, 100.0f));
  desc.lacunarity = source.real(1.0f, 16.0f);
  desc.gain = source.real(0.0f, 1.0f);
  desc.distortion = source.real(0.0f, 1000.0f);
  for (float& value : desc.range) value = source.one_in(4) ? source.hostile() : 0.0f;
  desc.color_count = 2 + source.below(SHD_MAX_SOLID_COLORS);
  for (auto& color : desc.colors) {
    for (float& component : color) component = source.real();
  }
}

void choose_case(Source& source, Case& c) {
  c.budget = choose_budget(source);
  choose_desc(source, c.desc);
  c.count = source.below(kMaxPlaces + 1);
  c.in_step = 1 + source.below(2);
  c.out_step = 1 + source.below(2);
  c.has_width = source.one_in(2);
  c.outputs = source.one_in(4) ? source.below(1 << kOutputs) : (1 << kOutputs) - 1;
  const bool hostile = source.one_in(3);
  for (std::vector<float>& column : c.columns) {
    column.resize(c.count * c.in_step + 1);
    for (size_t i = 0; i < c.count; ++i) column[i * c.in_step] = hostile ? source.hostile() : 9.0f * source.real();
  }
}

/// Results of one run.
struct Output {
  bool made = false;
  size_t nonfinite_count = 0;
  std::vector<float> values;
};

void check_value(const Case& c, size_t column, float value) {
  const bool is_signed =
      c.desc.kind >= SHD_SOLID_PERLIN && c.desc.kind <= SHD_SOLID_SIMPLEX && c.desc.sum != SHD_SOLID_SUM_TURBULENCE;
  SHD_FUZZ_CHECK(std::isfinite(value));
  if (column == 0) SHD_FUZZ_CHECK(value >= (is_signed ? -1.0f : 0.0f) && value <= 1.0f);
}

void run(const Case& c, shd_simd simd, Output& output) {
  Host host(simd, c.budget);
  if (!host.context) return;
  shd_solid_points points = shd_solid_points_default();
  shd_solid_values values = shd_solid_values_default();
  points.count = c.count;
  for (size_t k = 0; k < 3; ++k) points.position[k] = shd_f32_column(c.columns[k].data(), 4 * c.in_step);
  if (c.has_width) points.width = shd_f32_column(c.columns[3].data(), 4 * c.in_step);
  std::vector<Column<float>> columns(kOutputs, Column<float>(c.count, c.out_step, kCanary));
  for (size_t k = 0; k < kOutputs; ++k) {
    shd_f32_out* const to = k == 0 ? &values.value : k < 4 ? &values.gradient[k - 1] : &values.channel[k - 4];
    if (c.outputs >> k & 1) *to = to_column(columns[k]);
  }
  output.made = host.ok(shd_solid_evaluate(host.context, &c.desc, &points, &values));
  SHD_FUZZ_CHECK(values.nonfinite_count <= c.count);
  output.nonfinite_count = values.nonfinite_count;
  for (size_t k = 0; k < kOutputs; ++k) {
    const bool is_written = output.made && c.outputs >> k & 1;
    columns[k].check_canaries(is_written ? c.count : 0);
    for (size_t i = 0; i < c.count && is_written; ++i) {
      check_value(c, k, columns[k][i]);
      output.values.push_back(columns[k][i]);
    }
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
    SHD_FUZZ_CHECK(best.made == baseline.made && best.nonfinite_count == baseline.nonfinite_count);
    SHD_FUZZ_CHECK(best.values.size() == baseline.values.size());
    const size_t bytes = best.values.size() * sizeof(float);
    SHD_FUZZ_CHECK(bytes == 0 || std::memcmp(best.values.data(), baseline.values.data(), bytes) == 0);
  });
  return 0;
}
