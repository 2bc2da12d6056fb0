// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "color/config.h"

namespace shd::color {

/// Effect of one part of a transform on r, g, b.
enum class PartKind {
  kMatrix,       // rows of `matrix`: three factors and an offset
  kClamp,        // each channel to low..high
  kCurve,        // each channel by itself, through `transform`
  kGlow,         // ACES 1.0 glow module
  kRedModifier,  // ACES 1.0 red modifier
  kSurround,     // times max(floor, luminance)^exponent
  kLut3d,        // `nodes` on a grid over 0..1, blue fastest
  kOther,        // mixes channels in an unknown way
};

/// One part of a transform. Parts applied one after another are the transform.
struct Part {
  PartKind kind = PartKind::kOther;
  double matrix[3][4] = {};
  float low = 0.0f, high = 0.0f;
  float luminance[3] = {};
  float floor = 0.0f, exponent = 0.0f;
  unsigned grid = 0;  // nodes per axis
  bool tetrahedral = false;
  std::vector<float> nodes;  // [grid][grid][grid][4], the fourth unused
  TransformRef transform;    // kCurve
};

}  // namespace shd::color
