// SPDX-License-Identifier: MIT
#include "tool/check/columns.h"

#include <algorithm>
#include <cmath>

namespace {

/// The derivatives of an axis: d/dx is 3 behind it, and d/dy is 6 behind it.
Input derivative(Input axis, int step) {
  return static_cast<Input>(axis + 3 * step);
}

/// Derivatives of a row in texels of level 0.
struct Footprint {
  float x, y;  // lengths of d/dx and d/dy
};

float value_at(const Case& judged, Input input, size_t i) {
  return judged.has(input) ? judged.column[input][i] : 0.0f;
}

Footprint footprint_at(const Case& judged, size_t i, float width, float height) {
  return {std::hypot(value_at(judged, kDudx, i) * width, value_at(judged, kDvdx, i) * height),
          std::hypot(value_at(judged, kDudy, i) * width, value_at(judged, kDvdy, i) * height)};
}

}  // namespace

void move_coordinates(Case& judged, float du, float dv) {
  for (float& u : judged.column[kU]) u += du;
  for (float& v : judged.column[kV]) v += dv;
}

void scale(Case& judged, std::initializer_list<Input> columns, float factor) {
  for (const Input input : columns) {
    for (float& x : judged.column[input]) x *= factor;
  }
}

void swap_columns(Case& judged, Input one, Input other) {
  // An absent column is zeros.
  for (const Input input : {one, other}) {
    if (!judged.has(input)) judged.column[input].assign(judged.count(), 0.0f);
  }
  std::swap(judged.column[one], judged.column[other]);
}

void swap_axes(Case& judged, Input one, Input other) {
  for (int step = 0; step < 3; ++step) {
    const Input a = derivative(one, step), b = derivative(other, step);
    if (judged.has(a) || judged.has(b)) swap_columns(judged, a, b);
  }
}

void flip_axis(Case& judged, Input axis, bool is_direction) {
  for (float& x : judged.column[axis]) x = is_direction ? -x : 1.0f - x;
  scale(judged, {derivative(axis, 1), derivative(axis, 2)}, -1.0f);
}

void scale_levels(Case& judged, float factor, float width, float height) {
  scale(judged, {kLod}, factor);
  if (judged.has(kLod)) return;
  for (size_t i = 0; i < judged.count(); ++i) {
    const Footprint size = footprint_at(judged, i, width, height);
    const float longer = std::max(size.x, size.y);
    if (!(longer > 0.0f) || std::isinf(longer)) continue;
    const float times = std::pow(longer, factor - 1.0f);
    for (const Input input : {kDudx, kDvdx, kDudy, kDvdy}) {
      if (judged.has(input)) judged.column[input][i] *= times;
    }
  }
}

void keep_shorter_axis(Case& judged, float width, float height) {
  for (size_t i = 0; i < judged.count(); ++i) {
    const Footprint size = footprint_at(judged, i, width, height);
    const auto take = [&](Input to, Input from) {
      const float value = value_at(judged, from, i);
      if (judged.has(to)) judged.column[to][i] = value;
    };
    const bool x_is_shorter = size.x < size.y;
    take(x_is_shorter ? kDudy : kDudx, x_is_shorter ? kDudx : kDudy);
    take(x_is_shorter ? kDvdy : kDvdx, x_is_shorter ? kDvdx : kDvdy);
  }
}
