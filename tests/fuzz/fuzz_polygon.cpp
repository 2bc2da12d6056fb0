// SPDX-License-Identifier: MIT
// Random polygons and points, valid and invalid. Weights are finite and have the sum 1, nothing is written beside the
// columns, and every target gives the same bits.
#include "barycentric.h"
#include "host.h"
#include "mutator.h"

namespace shd::fuzz {
namespace {

constexpr uint32_t kMaxVertices = 12;
constexpr size_t kMaxPoints = 20;

struct Case {
  shd_polygon_desc desc = shd_polygon_desc_default();
  std::vector<float> vertex[2], point[2];
  size_t out_step = 1;
  uint64_t budget = 0;
};

void choose_vertices(Source& source, Case& c) {
  const uint32_t count = source.one_in(16) ? source.below(4) : source.between(3, kMaxVertices);
  const bool is_round = source.one_in(2), hostile = source.one_in(8);
  for (uint32_t i = 0; i < count; ++i) {
    const float angle = 6.2831853f * static_cast<float>(i) / static_cast<float>(count);
    const float radius = is_round ? 1.0f : 1.25f + source.real();
    c.vertex[0].push_back(hostile ? source.hostile() : radius * std::cos(angle));
    c.vertex[1].push_back(hostile ? source.hostile() : radius * std::sin(angle));
  }
  c.desc.vertex_count = source.one_in(64) ? source.word() : count;
  if (c.desc.vertex_count > count && c.desc.vertex_count <= SHD_MAX_POLYGON_VERTICES) c.desc.vertex_count = count;
}

void choose_case(Source& source, Case& c) {
  c.budget = choose_budget(source);
  c.desc.kind = source.constant<shd_barycentric>(4);
  c.desc.segments = source.one_in(16) ? source.word() : 1 + source.below(4);
  if (c.desc.segments > 8 && c.desc.segments <= 256) c.desc.segments = 8;  // larger ones are slow
  choose_vertices(source, c);
  const size_t count = source.below(kMaxPoints + 1);
  const bool hostile = source.one_in(3);
  for (std::vector<float>& column : c.point) {
    for (size_t i = 0; i < count; ++i) column.push_back(hostile ? source.hostile() : 2.0f * source.real());
  }
  c.out_step = 1 + source.below(2);
}

/// Results of one run.
struct Output {
  bool made = false;
  size_t outside_count = 0, nonfinite_count = 0;
  std::vector<float> weights;
};

void run(const Case& c, shd_simd simd, Output& output) {
  Host host(simd, c.budget);
  if (!host.context) return;
  shd_polygon_desc desc = c.desc;
  shd_polygon_points points = shd_polygon_points_default();
  shd_polygon_weights weights = shd_polygon_weights_default();
  const size_t count = points.count = c.point[0].size();
  std::vector<Column<float>> columns(c.vertex[0].size(), Column<float>(count, c.out_step, kCanary));
  std::vector<shd_f32_out> out;
  for (Column<float>& column : columns) out.push_back(to_column(column));
  for (int k = 0; k < 2; ++k) {
    desc.vertex[k] = shd_f32_column(c.vertex[k].data(), 0);
    points.position[k] = shd_f32_column(c.point[k].data(), 0);
  }
  weights.weight = out.data();
  weights.weight_count = static_cast<uint32_t>(out.size());
  output.made = host.ok(shd_polygon_evaluate(host.context, &desc, &points, &weights));
  SHD_FUZZ_CHECK(weights.outside_count <= count && weights.nonfinite_count <= count);
  output.outside_count = weights.outside_count;
  output.nonfinite_count = weights.nonfinite_count;
  for (const Column<float>& column : columns) {
    column.check_canaries(output.made ? count : 0);
    for (size_t i = 0; i < count && output.made; ++i) output.weights.push_back(column[i]);
  }
  for (size_t i = 0; i < count && output.made; ++i) check_sum(columns, i);
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
    SHD_FUZZ_CHECK(best.made == baseline.made && best.outside_count == baseline.outside_count);
    SHD_FUZZ_CHECK(best.nonfinite_count == baseline.nonfinite_count && same_values(best.weights, baseline.weights));
  });
  return 0;
}
