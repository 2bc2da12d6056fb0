// SPDX-License-Identifier: MIT
#include "material/places.h"

#include <cmath>

#include "data/inverse.h"
#include "data/matrix.h"

namespace shd::material {
namespace {

/// Square of the length of a mapped step.
float square_of_step(const PlaceMap& map, float x, float y, float z) {
  float sum = 0.0f;
  for (const auto& m : map.row) {
    const float step = m[0] * x + m[1] * y + m[2] * z;
    sum += step * step;
  }
  return sum;
}

}  // namespace

void find_place_matrix(const Slot& slot, const float object_to_world[16], double out[16]) {
  double place[16], to_space[16];
  for (int i = 0; i < 16; ++i) {
    place[i] = static_cast<double>(slot.place_transform[i]);
    to_space[i] = i % 5 == 0 ? 1.0 : 0.0;
  }
  if (slot.place_space == SHD_PLACE_SPACE_OBJECT && !data::invert(object_to_world, to_space)) {
    for (int i = 0; i < 16; ++i) to_space[i] = i == 15 ? 1.0 : 0.0;
  }
  data::multiply(place, to_space, out);
}

PlaceMap place_map(const Slot& slot, const float object_to_world[16]) {
  double product[16];
  find_place_matrix(slot, object_to_world, product);
  PlaceMap map;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 4; ++c) map.row[r][c] = static_cast<float>(product[4 * c + r]);
  }
  return map;
}

void find_places(const PlaceMap& map, const raster::Fragments& points, float* const out[3]) {
  for (int r = 0; r < 3; ++r) {
    const float* const m = map.row[r];
    const float *x = points.px, *y = points.py, *z = points.pz;
    float* const to = out[r];
    for (size_t i = 0; i < points.count; ++i) to[i] = m[0] * x[i] + m[1] * y[i] + m[2] * z[i] + m[3];
  }
}

void find_widths(const PlaceMap& map, float factor, const raster::Fragments& points, float* out) {
  for (size_t i = 0; i < points.count; ++i) {
    const float right = square_of_step(map, points.dpdx[0][i], points.dpdx[1][i], points.dpdx[2][i]);
    const float down = square_of_step(map, points.dpdy[0][i], points.dpdy[1][i], points.dpdy[2][i]);
    out[i] = factor * std::sqrt(right > down ? right : down);
  }
}

void find_steps(const PlaceMap& map, float factor, const raster::Fragments& points, float* const out[6]) {
  for (int k = 0; k < 6; ++k) {
    const float* const m = map.row[k % 3];
    const float* const* const step = k < 3 ? points.dpdx : points.dpdy;
    const float *x = step[0], *y = step[1], *z = step[2];
    float* const to = out[k];
    for (size_t i = 0; i < points.count; ++i) to[i] = factor * (m[0] * x[i] + m[1] * y[i] + m[2] * z[i]);
  }
}

}  // namespace shd::material
