// SPDX-License-Identifier: MIT
#include <shd/projection.h>

#include <atomic>

#include "abi/batch.h"
#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "projection/projection.h"

namespace {

using namespace shd;
using namespace shd::abi;

/// Columns of shd_directions and shd_projected_points.
enum DirectionColumn { kDirectionX = 0, kStepX = 3, kStepY = 6, kDirectionColumns = 9 };
enum PointColumn { kU, kV, kFace, kDudx, kDvdx, kDudy, kDvdy, kPointColumns };
/// Columns of shd_image_points are the first three of PointColumn; those of shd_point_directions:
enum PointDirectionColumn { kSolidAngle = 3, kPointDirectionColumns = 4 };

constexpr size_t kImagePointColumns = 3;

shd_result check_projection(const char* field, const shd_projection& projection) {
  return check_enum(field, projection, SHD_PROJECTION_LAT_LONG, projection::kLastProjection);
}

projection::Directions directions_of(const Piece<kDirectionColumns, kPointColumns>& piece) {
  projection::Directions in = {piece.count, {}, {}};
  for (size_t c = 0; c < 3; ++c) {
    in.direction[c] = piece.floats(kDirectionX + c);
    in.step[0][c] = piece.floats(kStepX + c);
    in.step[1][c] = piece.floats(kStepY + c);
  }
  return in;
}

projection::Points points_of(const Piece<kDirectionColumns, kPointColumns>& piece) {
  return {piece.out_floats(kU),
          piece.out_floats(kV),
          piece.out_integers(kFace),
          {piece.out_floats(kDudx), piece.out_floats(kDudy)},
          {piece.out_floats(kDvdx), piece.out_floats(kDvdy)}};
}

}  // namespace

extern "C" {

shd_result shd_projection_project(shd_context* context, const shd_directions* directions, shd_projected_points* out) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_context(context));
    shd_directions in = shd_directions_default();
    SHD_TRY(read_desc("directions", directions, false, &in));
    shd_projected_points points = shd_projected_points_default();
    SHD_TRY(read_desc("points", out, false, &points));
    SHD_TRY(check_projection("directions.projection", in.projection));
    Batch<kDirectionColumns, kPointColumns> batch;
    batch.count = in.count;
    set_vector("directions.direction", in.direction, Need::kRequired, &batch.in[kDirectionX]);
    set_vector("directions.direction_dx", in.direction_dx, Need::kOptional, &batch.in[kStepX]);
    set_vector("directions.direction_dy", in.direction_dy, Need::kOptional, &batch.in[kStepY]);
    batch.out = {out_column("points.u", points.u, Need::kOptional),
                 out_column("points.v", points.v, Need::kOptional),
                 out_column("points.face", points.face, Need::kOptional),
                 out_column("points.dudx", points.dudx, Need::kOptional),
                 out_column("points.dvdx", points.dvdx, Need::kOptional),
                 out_column("points.dudy", points.dudy, Need::kOptional),
                 out_column("points.dvdy", points.dvdy, Need::kOptional)};
    SHD_TRY(check_batch(batch));
    std::atomic<size_t> nonfinite{0};
    const core::Context& host = context_of(static_cast<const shd_context*>(context));
    run_batch(host, batch, [&](const auto& piece) {
      nonfinite += projection::project(in.projection, host.simd, directions_of(piece), points_of(piece));
    });
    points.nonfinite_count = nonfinite;
    write_desc(points, out);
    return SHD_OK;
  });
}

shd_result shd_projection_unproject(shd_context* context, const shd_image_points* points, shd_point_directions* out) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_context(context));
    shd_image_points in = shd_image_points_default();
    SHD_TRY(read_desc("points", points, false, &in));
    shd_point_directions directions = shd_point_directions_default();
    SHD_TRY(read_desc("directions", out, false, &directions));
    SHD_TRY(check_projection("points.projection", in.projection));
    Batch<kImagePointColumns, kPointDirectionColumns> batch;
    batch.count = in.count;
    batch.in = {in_column("points.u", in.u, Need::kRequired), in_column("points.v", in.v, Need::kRequired),
                in_column("points.face", in.face, Need::kOptional)};
    for (int c = 0; c < 3; ++c) {
      batch.out[static_cast<size_t>(c)] =
          out_column("directions.direction", directions.direction[c], Need::kOptional, c);
    }
    batch.out[kSolidAngle] = out_column("directions.solid_angle", directions.solid_angle, Need::kOptional);
    SHD_TRY(check_batch(batch));
    std::atomic<size_t> nonfinite{0};
    const core::Context& host = context_of(static_cast<const shd_context*>(context));
    run_batch(host, batch, [&](const auto& piece) {
      nonfinite += projection::unproject(
          in.projection, host.simd, {piece.count, piece.floats(kU), piece.floats(kV), piece.integers(kFace)},
          {{piece.out_floats(0), piece.out_floats(1), piece.out_floats(2)}, piece.out_floats(kSolidAngle)});
    });
    directions.nonfinite_count = nonfinite;
    write_desc(directions, out);
    return SHD_OK;
  });
}

}  // extern "C"
