// SPDX-License-Identifier: MIT
// Random images as environments of all projections, valid and invalid, and lookups of them. Radiance and irradiance are
// finite and not negative, nothing is written beside the columns, and every target gives the same bits.
#include "mutator.h"
#include "texture_case.h"

namespace shd::fuzz {
namespace {

constexpr size_t kMaxLookups = 20, kInputs = 5, kOutputs = 3;

struct Case {
  shd_environment_desc desc = shd_environment_desc_default();
  shd_image image = shd_image_default();
  std::vector<uint8_t> pixels;
  std::vector<float> input[kInputs];  // x, y, z, roughness, exponent
  uint32_t inputs = 0;                // bits
  uint64_t budget = 0;
};

void choose_image(Source& source, Case& c) {
  c.image.format = source.constant<shd_format>(kFormats);
  c.image.width = source.between(1, 9);
  const bool is_wide = c.desc.projection == SHD_PROJECTION_LAT_LONG;
  c.image.height = is_wide ? source.between(1, 9) : c.image.width;
  if (c.desc.projection == SHD_PROJECTION_CUBE) c.image.height *= 6;
  if (source.one_in(32)) c.image.height += 1;
  c.pixels.resize(size_t{c.image.width} * c.image.height * shd_format_size(c.image.format));
  const uint32_t seed = source.below(256);
  Palette(source).fill(c.image.format, c.pixels, seed);
  c.image.pixels = c.pixels.data();
  if (source.one_in(64)) c.image.width = source.word();
}

void choose_case(Source& source, Case& c) {
  c.budget = choose_budget(source);
  c.desc.projection = source.constant<shd_projection>(6);
  c.desc.irradiance = source.one_in(16) ? source.constant<shd_irradiance>(2) : SHD_IRRADIANCE_HARMONICS;
  // Lobes take a hundred times as long as the rest.
  c.desc.tables = source.one_in(32) ? source.flags(SHD_ENVIRONMENT_TABLE_ALL) : source.flags(1);
  choose_image(source, c);
  const size_t count = source.below(kMaxLookups + 1);
  const bool hostile = source.one_in(3);
  for (std::vector<float>& column : c.input) {
    for (size_t i = 0; i < count; ++i) column.push_back(hostile ? source.hostile() : source.real());
  }
  c.inputs = source.one_in(8) ? source.below(4) : 0;
}

/// Results of one run.
struct Output {
  bool made = false;
  uint64_t replaced = 0;
  std::vector<float> values;
};

using LookUp = shd_result (*)(const shd_environment*, const shd_environment_lookups*, shd_environment_values*);

void look_up(const Host& host, const shd_environment* environment, LookUp call, const Case& c, uint32_t inputs,
             Output& output) {
  shd_environment_lookups lookups = shd_environment_lookups_default();
  shd_environment_values light = shd_environment_values_default();
  const size_t count = lookups.count = c.input[0].size();
  for (int k = 0; k < 3; ++k) lookups.direction[k] = shd_f32_column(c.input[k].data(), 0);
  if (inputs & 1) lookups.roughness = shd_f32_column(c.input[3].data(), 0);
  if (inputs & 2) lookups.exponent = shd_f32_column(c.input[4].data(), 0);
  std::vector<Column<float>> columns(kOutputs, Column<float>(count, 2, kCanary));
  for (size_t k = 0; k < kOutputs; ++k) light.channel[k] = to_column(columns[k]);
  const bool made = host.ok(call(environment, &lookups, &light));
  for (const Column<float>& column : columns) {
    column.check_canaries(made ? count : 0);
    for (size_t i = 0; i < count && made; ++i) {
      SHD_FUZZ_CHECK(std::isfinite(column[i]) && column[i] >= 0.0f);
      output.values.push_back(column[i]);
    }
  }
}

void run(const Case& c, shd_simd simd, Output& output) {
  Host host(simd, c.budget);
  if (!host.context) return;
  shd_environment_desc desc = c.desc;
  shd_environment_info info = shd_environment_info_default();
  shd_environment* environment = nullptr;
  desc.image = &c.image;
  output.made = host.ok(shd_environment_create(host.context, &desc, &environment));
  SHD_FUZZ_CHECK(output.made == (environment != nullptr));
  if (!environment) return;
  SHD_FUZZ_CHECK(shd_environment_get_info(environment, &info) == SHD_OK);
  SHD_FUZZ_CHECK(info.replaced_count <= uint64_t{3} * c.image.width * c.image.height);
  output.replaced = info.replaced_count;
  for (const float mean : info.mean) {
    SHD_FUZZ_CHECK(std::isfinite(mean) && mean >= 0.0f);
    output.values.push_back(mean);
  }
  look_up(host, environment, shd_environment_sample_irradiance, c, 0, output);
  look_up(host, environment, shd_environment_sample_radiance, c, c.inputs, output);
  shd_environment_release(environment);
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
    SHD_FUZZ_CHECK(best.made == baseline.made && best.replaced == baseline.replaced);
    SHD_FUZZ_CHECK(same_values(best.values, baseline.values));
  });
  return 0;
}
