// SPDX-License-Identifier: MIT
#include <shd/footprint.h>

#include "abi/batch.h"
#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "texture/domain/ray_footprint.h"

namespace {

using namespace shd;
using namespace shd::abi;
using texture::Step;
using texture::Surface;

constexpr size_t kStepOutputs = 4;

/// Columns of shd_ray_differentials. Columns of three components begin at x.
enum DifferentialColumn {
  kDpdu = 0,
  kDpdv = 3,
  kDirection = 6,
  kDistance = 9,
  kOriginDx = 10,
  kOriginDy = 13,
  kDirectionDx = 16,
  kDirectionDy = 19,
  kDifferentialColumns = 22
};
/// Columns of shd_ray_cones; the first nine are those of DifferentialColumn.
enum ConeColumn { kWidth = 9, kConeColumns = 10 };

template <size_t kIn>
void set_derivatives(const shd_derivatives& out, Batch<kIn, kStepOutputs>* batch) {
  batch->out = {out_column("derivatives.dudx", out.dudx, Need::kOptional),
                out_column("derivatives.dvdx", out.dvdx, Need::kOptional),
                out_column("derivatives.dudy", out.dudy, Need::kOptional),
                out_column("derivatives.dvdy", out.dvdy, Need::kOptional)};
}

/// Element i of a column of a piece; 0 where the column is absent.
template <size_t kIn>
double value_at(const Piece<kIn, kStepOutputs>& piece, size_t column, size_t i) {
  return piece.in[column] ? static_cast<double>(piece.floats(column)[i]) : 0.0;
}
template <size_t kIn>
data::Vec3d vector_at(const Piece<kIn, kStepOutputs>& piece, size_t column, size_t i) {
  return {value_at(piece, column, i), value_at(piece, column + 1, i), value_at(piece, column + 2, i)};
}

template <size_t kIn>
void store_steps(const Piece<kIn, kStepOutputs>& piece, size_t i, const Step& x, const Step& y) {
  const float values[kStepOutputs] = {x.du, x.dv, y.du, y.dv};
  for (size_t c = 0; c < kStepOutputs; ++c) {
    if (piece.out[c]) piece.out_floats(c)[i] = values[c];
  }
}

void trace_differentials(const Piece<kDifferentialColumns, kStepOutputs>& piece) {
  for (size_t i = 0; i < piece.count; ++i) {
    const Surface surface = {vector_at(piece, kDpdu, i), vector_at(piece, kDpdv, i)};
    const data::Vec3d direction = vector_at(piece, kDirection, i);
    const double distance = value_at(piece, kDistance, i);
    store_steps(piece, i,
                step_of_differential(surface, direction, distance, vector_at(piece, kOriginDx, i),
                                     vector_at(piece, kDirectionDx, i)),
                step_of_differential(surface, direction, distance, vector_at(piece, kOriginDy, i),
                                     vector_at(piece, kDirectionDy, i)));
  }
}

void trace_cones(const Piece<kConeColumns, kStepOutputs>& piece) {
  for (size_t i = 0; i < piece.count; ++i) {
    const Surface surface = {vector_at(piece, kDpdu, i), vector_at(piece, kDpdv, i)};
    const texture::ConeSteps steps =
        steps_of_cone(surface, vector_at(piece, kDirection, i), value_at(piece, kWidth, i));
    store_steps(piece, i, steps.along, steps.across);
  }
}

}  // namespace

extern "C" {

shd_result shd_derivatives_from_differentials(shd_context* context, const shd_ray_differentials* rays,
                                              shd_derivatives* out) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_context(context));
    shd_ray_differentials in = shd_ray_differentials_default();
    SHD_TRY(read_desc("rays", rays, false, &in));
    shd_derivatives derivatives = shd_derivatives_default();
    SHD_TRY(read_desc("derivatives", out, false, &derivatives));
    Batch<kDifferentialColumns, kStepOutputs> batch;
    batch.count = in.count;
    InColumn* const columns = batch.in.data();
    set_vector("rays.dpdu", in.dpdu, Need::kRequired, columns + kDpdu);
    set_vector("rays.dpdv", in.dpdv, Need::kRequired, columns + kDpdv);
    set_vector("rays.direction", in.direction, Need::kRequired, columns + kDirection);
    columns[kDistance] = in_column("rays.distance", in.distance, Need::kOptional);
    set_vector("rays.origin_dx", in.origin_dx, Need::kOptional, columns + kOriginDx);
    set_vector("rays.origin_dy", in.origin_dy, Need::kOptional, columns + kOriginDy);
    set_vector("rays.direction_dx", in.direction_dx, Need::kOptional, columns + kDirectionDx);
    set_vector("rays.direction_dy", in.direction_dy, Need::kOptional, columns + kDirectionDy);
    set_derivatives(derivatives, &batch);
    SHD_TRY(check_batch(batch));
    derivatives.nonfinite_count = run_counting(context_of(context), batch, batch.in.size(), trace_differentials);
    write_desc(derivatives, out);
    return SHD_OK;
  });
}

shd_result shd_derivatives_from_cones(shd_context* context, const shd_ray_cones* cones, shd_derivatives* out) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_context(context));
    shd_ray_cones in = shd_ray_cones_default();
    SHD_TRY(read_desc("cones", cones, false, &in));
    shd_derivatives derivatives = shd_derivatives_default();
    SHD_TRY(read_desc("derivatives", out, false, &derivatives));
    Batch<kConeColumns, kStepOutputs> batch;
    batch.count = in.count;
    InColumn* const columns = batch.in.data();
    set_vector("cones.dpdu", in.dpdu, Need::kRequired, columns + kDpdu);
    set_vector("cones.dpdv", in.dpdv, Need::kRequired, columns + kDpdv);
    set_vector("cones.direction", in.direction, Need::kRequired, columns + kDirection);
    columns[kWidth] = in_column("cones.width", in.width, Need::kRequired);
    set_derivatives(derivatives, &batch);
    SHD_TRY(check_batch(batch));
    derivatives.nonfinite_count = run_counting(context_of(context), batch, batch.in.size(), trace_cones);
    write_desc(derivatives, out);
    return SHD_OK;
  });
}

}  // extern "C"
