// SPDX-License-Identifier: MIT
// The elliptical weighted average of a 3D texture in doubles, over the bounding box of the ellipsoid.
#pragma once

#include "ref/ewa_ref.h"
#include "ref/slices_ref.h"

namespace ref {

/// The levels and the axes in the plane of the footprint are those of 2D.
inline Image flat_of(const Solid& solid) {
  return {solid.format, nullptr, solid.level_count, solid.sampler};
}
inline double ewa_lod(const Solid& solid, const Spread& s) {
  return ewa_lod(flat_of(solid), Ellipse{s.a, s.b, 0, 0});
}

/// Squares of the half axes: along, across and normal to the plane.
struct Ellipsoid {
  double aa, bb, cc;
};
inline Ellipsoid ellipsoid(const Solid& solid, const Spread& s, int level) {
  const Ellipse2 flat = ewa_axes(flat_of(solid), Ellipse{s.a, s.b, 0, 0}, level);
  const double width = s.normal.u == 0 && s.normal.v == 0 && s.normal.w == 0 ? 0 : fmin(64 * s.b / s.a, 1);
  return {flat.aa, flat.bb, 1 + (1 - width * width) * (flat.bb - 1)};
}

inline double dot(const Place& a, const Place& b) {
  return a.u * b.u + a.v * b.v + a.w * b.w;
}

/// All channels on one level, at a place moved in normalised coordinates.
inline void ewa(const Solid& solid, const Spread& s, int level, const Place& p, const Place& moved, double out[4]) {
  const SolidLevel& l = solid.levels[level];
  const shd_sampler_desc& sampler = *solid.sampler;
  const Ellipsoid e = ellipsoid(solid, s, level);
  const double share = ewa_bilinear_share(flat_of(solid), Ellipse{s.a, s.b, 0, 0});
  const Place centre = {ewa_centre(sampler.wrap_u, p.u, moved.u, static_cast<double>(l.width)),
                        ewa_centre(sampler.wrap_v, p.v, moved.v, static_cast<double>(l.height)),
                        ewa_centre(sampler.wrap_w, p.w, moved.w, static_cast<double>(l.depth))};
  // Half the sides of the bounding box. Q = bb I + (aa - bb) axis axis^T + (cc - bb) normal normal^T.
  const auto reach = [&](double axis, double normal) {
    return sqrt(e.bb + (e.aa - e.bb) * axis * axis + (e.cc - e.bb) * normal * normal);
  };
  const Place box = {reach(s.axis.u, s.normal.u), reach(s.axis.v, s.normal.v), reach(s.axis.w, s.normal.w)};
  const auto begin = [](double x, double half) { return static_cast<int64_t>(ceil(x - half)); };
  const auto end = [](double x, double half) { return static_cast<int64_t>(floor(x + half)) + 1; };
  double sum[4] = {0, 0, 0, 0}, total = 0;
  for (int64_t z = begin(centre.w, box.w); share < 1 && z < end(centre.w, box.w); ++z) {
    for (int64_t y = begin(centre.v, box.v); y < end(centre.v, box.v); ++y) {
      for (int64_t x = begin(centre.u, box.u); x < end(centre.u, box.u); ++x) {
        const Place d = {static_cast<double>(x) - centre.u, static_cast<double>(y) - centre.v,
                         static_cast<double>(z) - centre.w};
        const double along = dot(d, s.axis), normal = dot(d, s.normal);
        const double across2 = fmax(dot(d, d) - along * along - normal * normal, 0);
        const double square = along * along / e.aa + across2 / e.bb + normal * normal / e.cc;
        if (square >= 1) continue;
        const double weight = exp(-2 * square) - exp(-2.0);
        for (int c = 0; c < 4; ++c) sum[c] += weight * texel(solid, level, x, y, z, c);
        total += weight;
      }
    }
  }
  const Place at = {reduce(sampler.wrap_u, p.u) + moved.u, reduce(sampler.wrap_v, p.v) + moved.v,
                    reduce(sampler.wrap_w, p.w) + moved.w};
  for (int c = 0; c < 4; ++c) {
    out[c] = mix(share < 1 ? sum[c] / total : 0, share > 0 ? linear(solid, level, at, c) : 0, share);
  }
}

}  // namespace ref
