// SPDX-License-Identifier: MIT
// Every cell of the table of support that works, on noise, against the double oracle of its filter and domain on every
// SIMD target: values, derivatives, explanations, bounds, fixed point and comparisons. All targets have the same bits.
#include <cmath>
#include <memory>

#include "support_oracle.h"

#include "support/check.h"
#include "support/statistics.h"

namespace {

using namespace cells;
using shd::tests::hoeffding;

/// A cell on one shape with one set of wraps.
struct Case {
  SupportCell cell;
  const Shape& shape;
  size_t wraps;
  const Expected& want;
  const CellLookups& lookups;

  std::string text() const { return text_of(cell) + ", " + shape.stored.name + ", wraps " + std::to_string(wraps); }
  double tolerance() const { return tolerance_of(cell.filter) + (cell.use == Use::kFast ? 0x1p-11 : 0.0); }
};

void fail_at(const Case& at, const char* what, size_t i, const ref::Value& got, const ref::Value& want) {
  const ref::UnitLookup l = at.lookups.at(i);
  fail_msg("%s: %s of lookup %zu (%g %g %g; %g %g %g; %g %g %g): %g %g %g %g, not %g %g %g %g", at.text().c_str(), what,
           i, l.p[0], l.p[1], l.p[2], l.dx[0], l.dx[1], l.dx[2], l.dy[0], l.dy[1], l.dy[2], got[0], got[1], got[2],
           got[3], want[0], want[1], want[2], want[3]);
}

/// Compares columns with the oracle where it is known, which is at more than half of the lookups.
void check_columns(const Case& at, const char* what, const Results& results, size_t first,
                   const std::array<ref::Value, kCount>& want, double tolerance) {
  size_t checked = 0;
  for (size_t i = 0; i < kCount; ++i) {
    if (!is_known(want[i])) continue;
    ++checked;
    const ref::Value got = results.at(first, i);
    if (!(difference(got, want[i]) <= tolerance)) fail_at(at, what, i, got, want[i]);
  }
  if (2 * checked <= kCount) fail_msg("%s: only %zu %s", at.text().c_str(), checked, what);
}

/// Each pick is a texel of the filter that it estimates. The means of picks, of a lookup and of all, are its values.
void check_picks(const Case& at, const shd_texture* texture, const shd_sampler* sampler) {
  constexpr size_t kRounds = 300;
  CellLookups lookups = at.lookups;
  Random random{11};
  std::array<ref::Value, kCount> sum = {};
  ref::Value error = {};
  for (size_t round = 0; round < kRounds; ++round) {
    Results picks;
    for (uint32_t& word : lookups.random) word = static_cast<uint32_t>(random.bits());
    shd_assert_ok(call(Use::kValues, at.cell.domain, texture, sampler, lookups, &picks));
    for (size_t i = 0; i < kCount; ++i) {
      const ref::Value got = picks.at(0, i);
      if (is_known(at.want.value[i]) && !at.want.filter.is_tap(lookups.at(i), got, 1e-6))
        fail_at(at, "a pick", i, got, at.want.value[i]);
      for (size_t c = 0; c < 4; ++c) sum[i][c] += got[c] / kRounds;
    }
  }
  size_t known = 0;
  for (size_t i = 0; i < kCount; ++i) {
    if (!is_known(at.want.value[i])) continue;
    ++known;
    if (difference(sum[i], at.want.value[i]) > hoeffding(1, kRounds) + 1e-3)
      fail_at(at, "the mean", i, sum[i], at.want.value[i]);
    for (size_t c = 0; c < 4; ++c) error[c] += sum[i][c] - at.want.value[i][c];
  }
  for (double& x : error) x /= static_cast<double>(known);
  const double bound = hoeffding(1, static_cast<double>(known * kRounds)) + 1e-3;
  if (2 * known <= kCount || difference(error, {}) > bound)
    fail_msg("%s: the mean of %zu means is %g off", at.text().c_str(), known, difference(error, {}));
}

void check_slopes(const Case& at, const Results& results) {
  const char* const names[3] = {"d/du", "d/dv", "d/dw"};
  for (size_t axis = 0; axis < (at.cell.domain == Domain::kPlane ? 2 : 3); ++axis) {
    check_columns(at, names[axis], results, 4 + 4 * axis, at.want.slope[axis], at.want.slope_tolerance(axis));
  }
}

/// An explanation has the bits of the value. The oracle's texels, times the weights of the taps, add up to the value.
void check_explanations(const Case& at, const shd_texture* texture, const shd_sampler* sampler,
                        const Results& results) {
  static shd_tap taps[8192];
  const shd_lookups in = at.lookups.in();
  for (size_t i = 0; i < kCount; ++i) {
    shd_explanation e = shd_explanation_default();
    e.taps = taps, e.tap_capacity = sizeof taps / sizeof *taps;
    shd_assert_ok(shd_texture_explain(texture, sampler, &in, i, &e));
    assert_in_range(e.tap_count, 1, e.tap_capacity);
    const ref::Value got = results.at(0, i), explained = results.at(4, i);
    if (std::memcmp(&got, &explained, sizeof got) != 0) fail_at(at, "the explained result", i, explained, got);
    ref::Value sum = {};
    for (uint32_t k = 0; k < e.tap_count; ++k) {
      const shd_tap& tap = taps[k];
      for (size_t c = 0; c < 4; ++c) {
        const int channel = static_cast<int>(c);
        const double texel = tap.border
                                 ? static_cast<double>(at.want.filter.image().sampler.border[c])
                                 : at.want.filter.texel(static_cast<int>(tap.layer), static_cast<int>(tap.level_u),
                                                        static_cast<int>(tap.level_v), tap.x, tap.y, tap.z, channel);
        sum[c] += static_cast<double>(tap.weight) * texel;
      }
    }
    if (difference(sum, got) > tolerance_of(at.cell.filter)) fail_at(at, "the sum of taps", i, sum, got);
  }
}

/// Bounds contain the oracle's value and the library's. At least half of them are narrow. Units may choose the places
/// and the weights of probes, so that half the bounds of ANISOTROPIC are narrower than the range of texels.
void check_bounds(const Case& at, const std::array<ref::Value, kCount>& want, const Results& results) {
  const double width = at.cell.filter == SHD_FILTER_ANISOTROPIC ? 0.6 : 5e-3;
  size_t narrow = 0, known = 0;
  for (size_t i = 0; i < kCount; ++i) {
    if (!is_known(want[i])) continue;
    const ref::Value low = results.at(4, i), high = results.at(8, i), got = results.at(0, i);
    ++known;
    for (size_t c = 0; c < 4; ++c) {
      const double value = want[i][c];
      if (!(low[c] <= value && value <= high[c])) fail_at(at, "the lower bound and value", i, low, want[i]);
      if (!(low[c] <= got[c] && got[c] <= high[c])) fail_at(at, "the lower bound and result", i, low, got);
    }
    narrow += difference(low, high) < width;
  }
  if (2 * narrow < known || 2 * known <= kCount)
    fail_msg("%s: %zu of %zu bounds are narrow", at.text().c_str(), narrow, known);
}

/// Whether a cell in fixed point has lines of probes of its own (shd_precision).
bool has_fast_lines(const Case& at) {
  const bool lines = at.cell.use == Use::kFast && at.cell.filter == SHD_FILTER_ANISOTROPIC;
  return lines && kWraps[at.wraps][0] != SHD_WRAP_BORDER;
}

/// Fixed point has other bits than full precision, so that the cell has fixed point at all. Its lines are those of a
/// smaller level_blend, whose values unit.texture.level_blend checks.
void check_fixed(const Case& at, const shd_texture* texture, shd_context* context, const Results& results) {
  shd_sampler_desc desc = sampler_desc(at.cell.filter, Use::kValues, at.wraps);
  if (has_fast_lines(at)) desc.level_blend = 0.28125f;
  shd_sampler* sampler = nullptr;
  Results full;
  shd_assert_ok(shd_sampler_create(context, &desc, &sampler));
  shd_assert_ok(call(Use::kValues, at.cell.domain, texture, sampler, at.lookups, &full));
  shd_sampler_release(sampler);
  for (size_t i = 0; has_fast_lines(at) && i < kCount; ++i) {
    if (difference(full.at(0, i), results.at(0, i)) > at.tolerance())
      fail_at(at, "values", i, results.at(0, i), full.at(0, i));
  }
  const bool has_border = desc.wrap_u == SHD_WRAP_BORDER;
  if ((std::memcmp(full.out, results.out, sizeof full.out) == 0) != has_border)
    fail_msg("%s: fixed point %s", at.text().c_str(), has_border ? "with a border" : "has the bits of floats");
}

/// Runs a cell and checks it. Returns its results.
Results check_case(const Case& at, const Textures& textures, const std::array<ref::Value, kCount>& compared) {
  const size_t shape = static_cast<size_t>(&at.shape - kShapes);
  const shd_texture* const texture = textures.at(shape, at.cell.store);
  const shd_sampler_desc desc = sampler_desc(at.cell.filter, at.cell.use, at.wraps);
  shd_sampler* sampler = nullptr;
  Results results;
  shd_assert_ok(shd_sampler_create(textures.context(), &desc, &sampler));
  const shd_result result = call(at.cell.use, at.cell.domain, texture, sampler, at.lookups, &results);
  if (result != SHD_OK) fail_msg("%s: %s", at.text().c_str(), shd_last_error());
  const bool picks = at.cell.filter == SHD_FILTER_STOCHASTIC;
  if (at.cell.use == Use::kComparison) {
    check_columns(at, "comparisons", results, 0, compared, at.tolerance());
  } else if (!picks && !has_fast_lines(at)) {
    check_columns(at, "values", results, 0, at.want.value, at.tolerance());
  }
  switch (at.cell.use) {
    case Use::kValues:
      if (picks) check_picks(at, texture, sampler);
      break;
    case Use::kGradients: check_slopes(at, results); break;
    case Use::kExplanation: check_explanations(at, texture, sampler, results); break;
    case Use::kBounds: check_bounds(at, at.want.value, results); break;
    case Use::kFast: check_fixed(at, texture, textures.context(), results); break;
    case Use::kComparison: {
      Results bounds;
      shd_assert_ok(call(Use::kBounds, at.cell.domain, texture, sampler, at.lookups, &bounds));
      check_bounds(at, compared, bounds);
      break;
    }
  }
  shd_sampler_release(sampler);
  return results;
}

/// A filter on a shape with a set of wraps, in all stores and for all uses.
struct Column {
  size_t shape, wraps;
  shd_filter filter;
};

/// Calls body(cell) for the cells of a column that work.
template <class Body>
void for_each_cell_of(const Column& column, const Body& body) {
  for_each_cell([&](const SupportCell& cell) {
    const Shape& shape = kShapes[column.shape];
    if (cell.filter == column.filter && cell.domain == shape.domain && has_store(shape, cell.store) &&
        !refusal_of(cell))
      body(cell);
  });
}

struct Answers {
  OracleTexels texels;
  CellLookups lookups;
  std::unique_ptr<Expected> want;
  std::array<ref::Value, kCount> compared = {};
  std::vector<Results> first;  // results of the first target, cell by cell

  explicit Answers(const Column& column) : texels(kShapes[column.shape]), lookups(kShapes[column.shape]) {
    bool slopes = false, compares = false;
    for_each_cell_of(column, [&](const SupportCell& cell) {
      slopes = slopes || cell.use == Use::kGradients;
      compares = compares || cell.use == Use::kComparison;
    });
    const shd_sampler_desc desc = sampler_desc(column.filter, Use::kValues, column.wraps);
    want = std::make_unique<Expected>(texels.image(desc), lookups, slopes);
    if (compares) compared = compared_values(kShapes[column.shape], desc, lookups);
  }
};

void check_column(const Column& column, int simd, const Textures& textures, Answers* answers) {
  size_t number = 0;
  for_each_cell_of(column, [&](const SupportCell& cell) {
    const Case at = {cell, kShapes[column.shape], column.wraps, *answers->want, answers->lookups};
    const Results results = check_case(at, textures, answers->compared);
    if (number == answers->first.size()) answers->first.push_back(results);
    if (std::memcmp(answers->first[number].out, results.out, sizeof results.out) != 0)
      fail_msg("%s: other bits on target %d", at.text().c_str(), simd);
    ++number;
  });
}

/// All cells of a filter that work. `state` is the filter.
void test_filter(void** state) {
  const shd_filter filter = *static_cast<const shd_filter*>(*state);
  std::vector<Column> columns;
  std::vector<std::unique_ptr<Answers>> answers;
  for (size_t shape = 0; shape < kShapeCount; ++shape) {
    const bool wraps = kShapes[shape].domain != Domain::kDirections;
    if (refusal_of({filter, kShapes[shape].domain, Store::kMemory, Use::kValues})) continue;
    for (size_t set = 0; set < (wraps ? kWrapSets : 1); ++set) {
      columns.push_back({shape, set, filter});
      answers.push_back(std::make_unique<Answers>(columns.back()));
    }
  }
  for_each_cell([&](const SupportCell& cell) {
    const auto has_cell = [&](const Shape& shape) {
      return shape.domain == cell.domain && has_store(shape, cell.store);
    };
    assert_true(std::any_of(kShapes, kShapes + kShapeCount, has_cell));
  });
  for_each_target([&](int simd, const Textures& textures) {
    for (size_t i = 0; i < columns.size(); ++i) check_column(columns[i], simd, textures, answers[i].get());
  });
}

}  // namespace

int main() {
  CMUnitTest tests[kFilterCount];
  for (size_t i = 0; i < kFilterCount; ++i) {
    tests[i] = {shd::core::value_name(kFilters[i]), test_filter, nullptr, nullptr,
                const_cast<shd_filter*>(&kFilters[i])};
  }
  return _cmocka_run_group_tests("unit.texture.support_cells", tests, kFilterCount, nullptr, nullptr);
}
