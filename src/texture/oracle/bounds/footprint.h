// SPDX-License-Identifier: MIT
#pragma once

#include "texture/oracle/bounds/model.h"
#include "texture/oracle/bounds/range.h"
#include "texture/texture.h"

namespace shd::texture {

/// Components along u, v and w. w is 0 unless the texture is 3D.
struct Vector {
  double part[3];
};

/// Derivatives of a point, normalised; no NaN. Footprints are of derivatives times the sampler's widths.
struct Steps {
  Vector x, y;
  double error_x = 0.0, error_y = 0.0;  // largest error of each component
};

/// The legal footprints of a lookup.
struct BoundsFootprint {
  Range lambda;        // levels of detail before bias and clamps; infinite at size 0 or infinity
  Range probe_lambda;  // levels of detail of anisotropic lookups
  double reach;        // probes lie within +-reach of an axis
  int axis_count;      // axes along which probes may lie
  Vector axis[3];      // normalised
  double slop;         // error of the ends of the axes [base texels]
  bool round;          // the axes have no certain direction: probes lie within reach * |axis[0]| in any direction
  bool everywhere;     // probes may lie anywhere
};

/// Returns the footprints of derivatives. `given_lod` replaces them unless it is null.
BoundsFootprint bounds_footprint(const Texture& texture, const Sampler& sampler, const BoundsModel& model,
                                 const Steps& steps, const double* given_lod);

/// Returns the levels of detail of a texture after bias, clamps and rounding.
Range final_levels(const Texture& texture, const Sampler& sampler, const BoundsModel& model, const Range& lambda);

/// Returns whether lookups may be magnified, or minified.
struct Magnified {
  bool near, far;
};
Magnified magnified(const Sampler& sampler, const BoundsModel& model, const Range& lambda);

}  // namespace shd::texture
