// SPDX-License-Identifier: MIT
#include <shd/footprint.h>

#include <cstdio>

#include "abi/desc.h"
#include "abi/guard.h"
#include "data/column.h"
#include "texture/footprint/ray_footprint.h"

namespace {

using namespace shd;
using namespace shd::abi;
using texture::Step;
using texture::Surface;
using texture::Triple;

/// Three columns x, y, z of `count` elements.
shd_result check_triple(const char* field, const shd_f32_in* columns, size_t count, bool required) {
  for (size_t c = 0; c < 3; ++c) {
    char name[64];
    std::snprintf(name, sizeof name, "%s[%zu]", field, c);
    SHD_TRY(check_column(name, columns[c], count));
    if (required && count > 0 && !columns[c].data) {
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s.data: NULL", name);
    }
  }
  return SHD_OK;
}

shd_result check_derivatives(const shd_derivatives* out, size_t count) {
  SHD_TRY(check_not_null("derivatives", out));
  SHD_TRY(check_column("derivatives.dudx", out->dudx, count));
  SHD_TRY(check_column("derivatives.dvdx", out->dvdx, count));
  SHD_TRY(check_column("derivatives.dudy", out->dudy, count));
  return check_column("derivatives.dvdy", out->dvdy, count);
}

double load_or_zero(const shd_f32_in& column, size_t i) {
  return column.data ? static_cast<double>(data::load(column, i)) : 0.0;
}
Triple load_triple(const shd_f32_in* columns, size_t i) {
  return {load_or_zero(columns[0], i), load_or_zero(columns[1], i), load_or_zero(columns[2], i)};
}

void store_steps(const shd_derivatives& out, size_t i, const Step& x, const Step& y) {
  if (out.dudx.data) data::store(out.dudx, i, x.du);
  if (out.dvdx.data) data::store(out.dvdx, i, x.dv);
  if (out.dudy.data) data::store(out.dudy, i, y.du);
  if (out.dvdy.data) data::store(out.dvdy, i, y.dv);
}

}  // namespace

extern "C" {

shd_result shd_derivatives_from_differentials(const shd_ray_differentials* rays, const shd_derivatives* out) {
  return guard([&]() -> shd_result {
    shd_ray_differentials in = shd_ray_differentials_default();
    SHD_TRY(read_desc("rays", rays, false, &in));
    SHD_TRY(check_zero("rays.reserved", in.reserved));
    SHD_TRY(check_derivatives(out, in.count));
    SHD_TRY(check_triple("rays.dpdu", in.dpdu, in.count, true));
    SHD_TRY(check_triple("rays.dpdv", in.dpdv, in.count, true));
    SHD_TRY(check_triple("rays.direction", in.direction, in.count, true));
    SHD_TRY(check_column("rays.distance", in.distance, in.count));
    SHD_TRY(check_triple("rays.origin_dx", in.origin_dx, in.count, false));
    SHD_TRY(check_triple("rays.origin_dy", in.origin_dy, in.count, false));
    SHD_TRY(check_triple("rays.direction_dx", in.direction_dx, in.count, false));
    SHD_TRY(check_triple("rays.direction_dy", in.direction_dy, in.count, false));
    for (size_t i = 0; i < in.count; ++i) {
      const Surface surface = {load_triple(in.dpdu, i), load_triple(in.dpdv, i)};
      const Triple direction = load_triple(in.direction, i);
      const double distance = load_or_zero(in.distance, i);
      store_steps(*out, i,
                  step_of_differential(surface, direction, distance, load_triple(in.origin_dx, i),
                                       load_triple(in.direction_dx, i)),
                  step_of_differential(surface, direction, distance, load_triple(in.origin_dy, i),
                                       load_triple(in.direction_dy, i)));
    }
    return SHD_OK;
  });
}

shd_result shd_derivatives_from_cones(const shd_ray_cones* cones, const shd_derivatives* out) {
  return guard([&]() -> shd_result {
    shd_ray_cones in = shd_ray_cones_default();
    SHD_TRY(read_desc("cones", cones, false, &in));
    SHD_TRY(check_zero("cones.reserved", in.reserved));
    SHD_TRY(check_derivatives(out, in.count));
    SHD_TRY(check_triple("cones.dpdu", in.dpdu, in.count, true));
    SHD_TRY(check_triple("cones.dpdv", in.dpdv, in.count, true));
    SHD_TRY(check_triple("cones.direction", in.direction, in.count, true));
    SHD_TRY(check_column("cones.width", in.width, in.count));
    if (in.count > 0) SHD_TRY(check_not_null("cones.width.data", in.width.data));
    for (size_t i = 0; i < in.count; ++i) {
      const Surface surface = {load_triple(in.dpdu, i), load_triple(in.dpdv, i)};
      const texture::ConeSteps steps = steps_of_cone(surface, load_triple(in.direction, i), load_or_zero(in.width, i));
      store_steps(*out, i, steps.along, steps.across);
    }
    return SHD_OK;
  });
}

}  // extern "C"
