// SPDX-License-Identifier: MIT
#include "abi/solid.h"

#include <algorithm>
#include <atomic>

#include "abi/batch.h"
#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "procedural/solid.h"

namespace shd::abi {
namespace {

shd_result check_kind(const char* name, const shd_solid_desc& desc) {
  SHD_TRY(check_enum(FieldName(name, "kind"), desc.kind, 0, SHD_SOLID_WOOD));
  SHD_TRY(check_enum(FieldName(name, "sum"), desc.sum, 0, SHD_SOLID_SUM_TURBULENCE));
  SHD_TRY(check_enum(FieldName(name, "gradients"), desc.gradients, 0, SHD_SOLID_GRADIENTS_TABLE));
  SHD_TRY(check_enum(FieldName(name, "fade"), desc.fade, 0, SHD_SOLID_FADE_LINEAR));
  return check_enum(FieldName(name, "distance"), desc.distance, 0, SHD_SOLID_DISTANCE_F2_F1);
}

shd_result check_numbers(const char* name, const shd_solid_desc& desc) {
  SHD_TRY(check_range(FieldName(name, "size"), double{desc.size}, 1e-30, 1e30));
  SHD_TRY(check_count(FieldName(name, "octaves"), desc.octaves, 1, procedural::kMaxOctaves));
  SHD_TRY(check_range(FieldName(name, "lacunarity"), double{desc.lacunarity}, 1.0, 16.0));
  SHD_TRY(check_range(FieldName(name, "gain"), double{desc.gain}, 0.0, 1.0));
  SHD_TRY(check_range(FieldName(name, "distortion"), double{desc.distortion}, 0.0, 1000.0));
  SHD_TRY(check_values(FieldName(name, "range"), desc.range, 2, -1e6, 1e6));
  SHD_TRY(check_count(FieldName(name, "color_count"), desc.color_count, 2, SHD_MAX_SOLID_COLORS));
  for (uint32_t i = 0; i < desc.color_count; ++i) {
    char color[24];
    std::snprintf(color, sizeof color, "colors[%u]", i);
    SHD_TRY(check_values(FieldName(name, color), desc.colors[i], 4, -1e6, 1e6));
  }
  return SHD_OK;
}

}  // namespace

shd_result read_solid(const char* name, const shd_solid_desc* in, shd_solid_desc* out) {
  *out = shd_solid_desc_default();
  SHD_TRY(read_desc(name, in, false, out));
  SHD_TRY(check_kind(name, *out));
  return check_numbers(name, *out);
}

}  // namespace shd::abi

namespace {

using namespace shd;
using namespace shd::abi;

enum SolidInput { kX, kY, kZ, kFilterWidth, kSolidInputs };
enum SolidOutput { kValue, kGradient, kColor = kGradient + 3, kSolidOutputs = kColor + 4 };
using SolidBatch = Batch<kSolidInputs, kSolidOutputs>;
using SolidPiece = Piece<kSolidInputs, kSolidOutputs>;

void set_columns(const shd_solid_points& points, const shd_solid_values& values, SolidBatch* batch) {
  batch->count = points.count;
  for (int c = 0; c < 3; ++c) {
    const auto k = static_cast<size_t>(c);
    batch->in[k] = in_column("points.position", points.position[c], Need::kRequired, c);
    batch->out[kGradient + k] = out_column("values.gradient", values.gradient[c], Need::kOptional, c);
  }
  batch->in[kFilterWidth] = in_column("points.width", points.width, Need::kOptional);
  batch->out[kValue] = out_column("values.value", values.value, Need::kOptional);
  for (int c = 0; c < 4; ++c) {
    batch->out[kColor + static_cast<size_t>(c)] = out_column("values.channel", values.channel[c], Need::kOptional, c);
  }
}

shd_result check_solid_batch(const SolidBatch& batch) {
  SHD_TRY(check_batch(batch));
  bool wanted = batch.count == 0;
  for (const OutColumn& column : batch.out) wanted = wanted || column.data;
  if (wanted) return SHD_OK;
  return core::fail(SHD_ERROR_INVALID_ARGUMENT, "values.value: NULL, and no gradient or colour");
}

/// Rows that are evaluated together; columns that the caller lacks but kernels write have this length.
constexpr size_t kRows = 256;

/// Evaluates up to kRows rows. Returns the number of places that are not finite.
size_t evaluate_rows(const procedural::Solid& solid, const core::SimdTarget& simd, const SolidPiece& piece) {
  alignas(64) float own_value[kRows], ignored[kRows];
  const auto or_own = [](float* column, float* own) { return column ? column : own; };
  procedural::Values out = {or_own(piece.out_floats(kValue), own_value), {}};
  if (piece.out[kGradient] || piece.out[kGradient + 1] || piece.out[kGradient + 2]) {
    for (size_t c = 0; c < 3; ++c) out.gradient[c] = or_own(piece.out_floats(kGradient + c), ignored);
  }
  const procedural::Places places = {piece.count, piece.floats(kX), piece.floats(kY), piece.floats(kZ),
                                     piece.floats(kFilterWidth)};
  const size_t bad = procedural::evaluate(solid, simd, places, out);
  float* color[4];
  bool has_color = false;
  for (size_t c = 0; c < 4; ++c) {
    color[c] = piece.out_floats(kColor + c);
    has_color = has_color || color[c];
  }
  if (has_color) procedural::find_colors(solid, simd, out.value, piece.count, color);
  return bad;
}

}  // namespace

extern "C" shd_result shd_solid_evaluate(shd_context* context, const shd_solid_desc* desc,
                                         const shd_solid_points* points, shd_solid_values* out) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_context(context));
    shd_solid_desc read;
    SHD_TRY(read_solid("solid", desc, &read));
    shd_solid_points in = shd_solid_points_default();
    SHD_TRY(read_desc("points", points, false, &in));
    shd_solid_values values = shd_solid_values_default();
    SHD_TRY(read_desc("values", out, false, &values));
    SolidBatch batch;
    set_columns(in, values, &batch);
    SHD_TRY(check_solid_batch(batch));
    const core::Context& owner = context_of(context);
    procedural::Solid solid;
    procedural::build(read, &solid);
    std::atomic<size_t> bad{0};
    run_batch(owner, batch, [&](const SolidPiece& piece) {
      size_t found = 0;
      for (size_t first = 0; first < piece.count; first += kRows) {
        found += evaluate_rows(solid, owner.simd, part_of(piece, first, std::min(kRows, piece.count - first)));
      }
      if (found) bad.fetch_add(found, std::memory_order_relaxed);
    });
    values.nonfinite_count = bad.load(std::memory_order_relaxed);
    write_desc(values, out);
    return SHD_OK;
  });
}
