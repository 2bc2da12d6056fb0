// SPDX-License-Identifier: MIT
#include "scene/columns.h"

#include <cstddef>
#include <utility>

namespace shd::scene {
namespace {

/// Rows of a column, each of `width` numbers.
template <class Number>
void take_rows(const std::vector<uint32_t>& rows, size_t width, std::vector<Number>& column) {
  if (column.empty()) return;
  std::vector<Number> out;
  out.reserve(rows.size() * width);
  for (const uint32_t row : rows) {
    const auto from = column.begin() + static_cast<std::ptrdiff_t>(row * width);
    out.insert(out.end(), from, from + static_cast<std::ptrdiff_t>(width));
  }
  column = std::move(out);
}

}  // namespace

void take_vertices(Geometry& g, const std::vector<uint32_t>& vertices) {
  for (std::vector<float>* column : {&g.position, &g.normal}) take_rows(vertices, 3, *column);
  for (std::vector<float>* column : {&g.tangent, &g.color}) take_rows(vertices, 4, *column);
  for (std::vector<float>* column : {&g.uv, &g.uv1}) take_rows(vertices, 2, *column);
  take_rows(vertices, g.influences, g.joint);
  take_rows(vertices, g.influences, g.weight);
  for (MorphTarget& morph : g.morphs) {
    for (std::vector<float>* column : {&morph.position, &morph.normal, &morph.tangent}) take_rows(vertices, 3, *column);
  }
}

}  // namespace shd::scene
