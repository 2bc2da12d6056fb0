// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include <shd/context.h>

#include "color/parts.h"
#include "color/program.h"

namespace shd::color {

/// Number of sizes of tables, from coarse to fine.
constexpr int kTableSizes = 2;

/// Stages and tables for the parts of a transform. Null if there is no stage for a part, if numbers could overflow, or
/// if a curve's codes change too often for a table. Throws std::bad_alloc.
/// @param size  below kTableSizes
std::unique_ptr<Program> bake(shd_context* context, const std::vector<Part>& parts, int size);

/// Difference of a program from the transform in 8-bit codes, per channel of a fixed set of opaque colours: in gamut,
/// saturated and negative, of 2^-14 to 2^6.
struct Deviation {
  size_t channels = 0;
  size_t above_one = 0;  // channels that differ by more than one code
  int largest = 0;
};
Deviation measure(const Program& program, const Transform& transform);

}  // namespace shd::color
