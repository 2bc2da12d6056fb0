// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "color/memory.h"
#include "core/simd_target.h"

namespace shd::color {

/// Floats in ascending order have ascending keys: the bits of positive floats, mirrored below them for negative ones.
inline int32_t mirror_key(int32_t bits) {
  return bits ^ ((bits >> 31) & 0x7fffffff);  // its own inverse
}

/// Functions of one number per channel, at `first`, `first` + 2^shift and so on as keys; linear in the key between
/// them, which is linear in the number. Constant outside.
struct Curves {
  const float* value[3];  // [steps + 1]
  int32_t first, last;    // keys
  int shift;
};

/// 8-bit codes of one number per channel. At most one code changes in a step of 2^shift keys. A word holds the first
/// code of its step in bits 0..7, the code from the change on in bits 8..15, and the distance of the change from the
/// start of the step in bits 16..31.
struct Codes {
  const uint32_t* word[3];
  int32_t first, last;  // keys
  int shift;            // 1..16
};

/// Colours on a grid of nodes^3 over 0..1, blue fastest, four floats each. Constant outside.
struct Lattice {
  const float* node;
  int32_t nodes;
  bool tetrahedral;  // else trilinear
};

enum class StageKind { kMatrix, kClamp, kCurves, kGlow, kRedModifier, kSurround, kLattice };

struct Stage {
  StageKind kind;
  float matrix[3][4];
  float low, high;  // limits of kClamp, and of the results of kMatrix
  float luminance[3], floor;
  const float* hue_weight;  // [kHueSteps + 1]
  Curves curves;            // a surround has one, its gain over luminance
  Lattice lattice;
};

constexpr int kHueSteps = 2048;

/// A baked display transform. Numbers never overflow: the bake bounds them.
struct Program {
  std::vector<Stage> stages;
  Codes codes;
  std::vector<Array> arrays;  // own what the stages and codes point to

  size_t bytes() const;
};

/// Premultiplied pixels and their place in an RGBA8 image.
struct Rectangle {
  const float* plane[4];
  size_t row_stride[4];  // bytes
  size_t width, height;
  unsigned char* out;
  size_t out_stride;  // bytes
};

/// Brings pixels to RGBA8, as unpremultiply(), a transform and store_pixels() do. The bits are those of every other
/// target, and do not depend on the rectangle.
void show(const core::SimdTarget& simd, const Program& program, const Rectangle& pixels);

/// One row of `count` pixels.
inline void show(const core::SimdTarget& simd, const Program& program, const float* const plane[4], size_t count,
                 void* out) {
  show(simd, program, {{plane[0], plane[1], plane[2], plane[3]}, {}, count, 1, static_cast<unsigned char*>(out), 0});
}

}  // namespace shd::color
