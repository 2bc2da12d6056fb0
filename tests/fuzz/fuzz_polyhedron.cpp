// SPDX-License-Identifier: MIT
// Random cages and points, valid and invalid. Weights and sums of values are finite, weights have the sum 1, nothing is
// written beside the columns, and every target gives the same bits.
#include <algorithm>
#include <array>

#include "barycentric.h"
#include "host.h"
#include "mutator.h"

namespace shd::fuzz {
namespace {

constexpr size_t kMaxPoints = 40, kMostValues = 3;

/// A closed mesh. Every coordinate is -1, 0 or 1.
struct Solid {
  std::vector<std::array<float, 3>> vertex;
  std::vector<uint32_t> index;
};
const Solid kSolids[] = {
    {{{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}},
    {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
     {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5}},
    {{{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 1}},
     {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5}}};

struct Case {
  shd_polyhedron_desc desc = shd_polyhedron_desc_default();
  std::vector<float> vertex[3], point[3], value[kMostValues];
  std::vector<uint32_t> index;
  size_t out_step = 1, value_count = 1;
  uint64_t budget = 0;
};

void choose_cage(Source& source, Case& c) {
  const Solid& solid = kSolids[source.below(3)];
  const bool hostile = source.one_in(8);
  const float bend = source.one_in(2) ? 0.0f : source.real();
  for (const auto& vertex : solid.vertex) {
    for (size_t k = 0; k < 3; ++k) {
      c.vertex[k].push_back(hostile ? source.hostile() : vertex[k] + bend * source.real());
    }
  }
  c.index = solid.index;
  if (source.one_in(8)) c.index[source.below(static_cast<uint32_t>(c.index.size()))] = source.below(10);
  if (source.one_in(8)) std::reverse(c.index.begin(), c.index.end());
  if (source.one_in(16)) c.index.resize(source.below(static_cast<uint32_t>(c.index.size()) + 1));
  c.desc.vertex_count = solid.vertex.size();
  c.desc.index_count = c.index.size();
  if (source.one_in(32)) c.desc.vertex_count = source.below(static_cast<uint32_t>(c.desc.vertex_count) + 1);
}

void choose_case(Source& source, Case& c) {
  c.budget = choose_budget(source);
  c.desc.kind = source.constant<shd_barycentric>(2);
  choose_cage(source, c);
  const size_t count = source.below(kMaxPoints + 1);
  const bool hostile = source.one_in(3);
  for (std::vector<float>& column : c.point) {
    for (size_t i = 0; i < count; ++i) column.push_back(hostile ? source.hostile() : 1.5f * source.real());
  }
  c.value_count = 1 + source.below(kMostValues);
  const bool are_hostile = source.one_in(8);
  for (std::vector<float>& column : c.value) {
    for (size_t i = 0; i < c.vertex[0].size(); ++i) {
      column.push_back(are_hostile ? source.hostile() : source.real());
    }
  }
  c.out_step = 1 + source.below(2);
}

/// Results of one run.
struct Output {
  bool made = false, blended = false;
  size_t outside_count = 0, nonfinite_count = 0;
  std::vector<float> numbers;
};

void keep(const std::vector<Column<float>>& columns, size_t count, std::vector<float>* numbers) {
  for (const Column<float>& column : columns) {
    column.check_canaries(count);
    for (size_t i = 0; i < count; ++i) numbers->push_back(column[i]);
  }
}

/// Columns of results, as a call takes them.
struct Results {
  std::vector<Column<float>> columns;
  std::vector<shd_f32_out> out;

  Results(size_t column_count, size_t count, size_t step) : columns(column_count, Column<float>(count, step, kCanary)) {
    for (Column<float>& column : columns) out.push_back(to_column(column));
  }
};

void evaluate(const Case& c, const Host& host, const shd_polyhedron* polyhedron, const shd_polyhedron_points& points,
              Output& output) {
  Results results(c.desc.vertex_count, points.count, c.out_step);
  shd_polyhedron_weights weights = shd_polyhedron_weights_default();
  weights.weight = results.out.data();
  weights.weight_count = results.out.size();
  output.made = host.ok(shd_polyhedron_evaluate(polyhedron, &points, &weights));
  SHD_FUZZ_CHECK(weights.outside_count <= points.count && weights.nonfinite_count <= points.count);
  output.outside_count = weights.outside_count;
  output.nonfinite_count = weights.nonfinite_count;
  keep(results.columns, output.made ? points.count : 0, &output.numbers);
  for (size_t i = 0; i < points.count && output.made; ++i) check_sum(results.columns, i);
}

void interpolate(const Case& c, const Host& host, const shd_polyhedron* polyhedron, const shd_polyhedron_points& points,
                 Output& output) {
  Results results(c.value_count, points.count, c.out_step);
  shd_polyhedron_values values = shd_polyhedron_values_default();
  shd_f32_in in[kMostValues];
  for (size_t k = 0; k < c.value_count; ++k) in[k] = shd_f32_column(c.value[k].data(), 0);
  values.value_count = c.value_count;
  values.vertex_value = in;
  values.value = results.out.data();
  output.blended = host.ok(shd_polyhedron_interpolate(polyhedron, &points, &values));
  if (output.blended) {
    SHD_FUZZ_CHECK(values.outside_count == output.outside_count || !output.made);
    SHD_FUZZ_CHECK(values.nonfinite_count == output.nonfinite_count || !output.made);
  }
  const size_t first = output.numbers.size();
  keep(results.columns, output.blended ? points.count : 0, &output.numbers);
  for (size_t i = first; i < output.numbers.size(); ++i) SHD_FUZZ_CHECK(std::isfinite(output.numbers[i]));
}

void run(const Case& c, shd_simd simd, Output& output) {
  Host host(simd, c.budget);
  if (!host.context) return;
  shd_polyhedron_desc desc = c.desc;
  shd_polyhedron_points points = shd_polyhedron_points_default();
  points.count = c.point[0].size();
  for (int k = 0; k < 3; ++k) {
    desc.position[k] = shd_f32_column(c.vertex[k].data(), 0);
    points.position[k] = shd_f32_column(c.point[k].data(), 0);
  }
  desc.indices = shd_u32_column(c.index.data(), 0);
  shd_polyhedron* polyhedron = nullptr;
  if (host.ok(shd_polyhedron_create(host.context, &desc, &polyhedron))) {
    evaluate(c, host, polyhedron, points, output);
    interpolate(c, host, polyhedron, points, output);
  } else {
    SHD_FUZZ_CHECK(!polyhedron);
  }
  shd_polyhedron_release(polyhedron);
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
    SHD_FUZZ_CHECK(best.made == baseline.made && best.blended == baseline.blended);
    SHD_FUZZ_CHECK(best.outside_count == baseline.outside_count);
    SHD_FUZZ_CHECK(best.nonfinite_count == baseline.nonfinite_count && same_values(best.numbers, baseline.numbers));
  });
  return 0;
}
