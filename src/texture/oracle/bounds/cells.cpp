// SPDX-License-Identifier: MIT
#include "texture/oracle/bounds/cells.h"

#include <algorithm>
#include <cmath>

#include "projection/projection.h"
#include "texture/oracle/bounds/fold.h"
#include "texture/store/storage.h"

namespace shd::texture {
namespace {

bool is_deep(const Plane& plane) {
  return plane.call->texture.depth != 0;
}
int64_t max_cells(const Plane& plane) {
  return is_deep(plane) ? kMaxDeepCells : kMaxCells;
}

/// Returns a range of coordinates with the same texels and not much more than one image, or two of MIRROR.
Range within_image(shd_wrap wrap, const Range& range, double n) {
  const double period = wrap == SHD_WRAP_MIRROR ? 2.0 * n : n;
  if (wrap == SHD_WRAP_REPEAT || wrap == SHD_WRAP_MIRROR) return range.length() >= period ? Range{0.0, period} : range;
  const double first = wrap == SHD_WRAP_MIRROR_ONCE ? -n - 2.0 : -2.0;
  const auto clamp = [&](double x) { return std::min(std::max(x, first), n + 2.0); };
  return {clamp(range.low), clamp(range.high)};
}

/// Brings all axes within the image and moves them by -shift. Returns false if the box is too wide to be searched.
bool searchable(const Plane& plane, double shift, PointBox* box) {
  const int64_t most = max_cells(plane);
  for (int a = 0; a < axes_of(plane.call->texture); ++a) {
    Range& range = box->axis[a];
    // Points of a map that is folded lie within one image of its edges, and those of other maps inside (place.cpp).
    if (!folds_far(plane.call->texture.projection)) {
      range = within_image(wrap_of(*plane.call, a), range, static_cast<double>(plane.size[a]));
    }
    range = {range.low - shift, range.high - shift};
    const double length = range.length();
    if (!(length <= static_cast<double>(2 * std::max(plane.size[a], most) + 8))) return false;
    if (plane.size[a] > most && length > static_cast<double>(most)) return false;
  }
  return true;
}

/// The 2^n texels of a cell, and the part of the cell that a box covers.
template <int kAxes>
struct Cell {
  static constexpr int kTexels = 1 << kAxes;
  Color texel[kTexels];  // bit a of the number: the second texel on axis a
  Range part[kAxes];
};

template <int kAxes>
double linear(const double (&texel)[1 << kAxes], const double (&share)[kAxes]) {
  double value[1 << kAxes];
  std::copy(texel, texel + (1 << kAxes), value);
  for (int a = 0; a < kAxes; ++a) {
    for (int k = 0; k < 1 << (kAxes - 1 - a); ++k) {
      value[k] = (1.0 - share[a]) * value[2 * k] + share[a] * value[2 * k + 1];
    }
  }
  return value[0];
}

/// A multilinear function has its extremes on a box at the corners.
template <int kAxes>
Range cell_range(const Cell<kAxes>& cell, int c, double weight_error) {
  constexpr int kTexels = Cell<kAxes>::kTexels;
  Range out, all;
  double low[kTexels], high[kTexels];
  for (int k = 0; k < kTexels; ++k) {
    const Range& value = cell.texel[k].channel[c];
    low[k] = value.low;
    high[k] = value.high;
    all.add(value);
  }
  if (!std::isfinite(all.low) || !std::isfinite(all.high)) return unbounded();
  for (int corner = 0; corner < kTexels; ++corner) {
    double share[kAxes];
    for (int a = 0; a < kAxes; ++a) share[a] = corner >> a & 1 ? cell.part[a].high : cell.part[a].low;
    out.add({linear<kAxes>(low, share), linear<kAxes>(high, share)});
  }
  const Range slack = widened(out, weight_error * all.length());
  return {std::max(slack.low, all.low), std::min(slack.high, all.high)};
}

/// The part [0, 1] of cell i that a range covers.
Range part_of_cell(const Range& range, int64_t i) {
  const auto first = static_cast<double>(i);
  return {std::max(range.low - first, 0.0), std::min(range.high - first, 1.0)};
}

/// First and last cell of a range.
struct Cells {
  int64_t first, last;
};
Cells cells_of(const Range& range) {
  return {static_cast<int64_t>(std::floor(range.low)), static_cast<int64_t>(std::floor(range.high))};
}

/// Loads the texels of column i as the second ones of a cell, after the former second ones became the first ones.
template <int kAxes>
void load_column(const Plane& plane, int64_t i, int64_t j, int64_t k, Cell<kAxes>* cell) {
  for (int n = 0; n < Cell<kAxes>::kTexels; n += 2) {
    cell->texel[n] = cell->texel[n + 1];
    cell->texel[n + 1] = texel_range(plane, i, j + (n >> 1 & 1), k + (n >> 2));
  }
}

template <int kAxes>
void add_row(const Plane& plane, const PointBox& box, int64_t j, int64_t k, Color* out) {
  Cell<kAxes> cell;
  cell.part[1] = part_of_cell(box.axis[1], j);
  if (kAxes == 3) cell.part[kAxes - 1] = part_of_cell(box.axis[2], k);
  const Cells x = cells_of(box.axis[0]);
  load_column<kAxes>(plane, x.first, j, k, &cell);
  for (int64_t i = x.first; i <= x.last; ++i) {
    load_column<kAxes>(plane, i + 1, j, k, &cell);
    cell.part[0] = part_of_cell(box.axis[0], i);
    for (uint32_t c = 0; c < plane.call->texture.channels; ++c) {
      out->channel[c].add(cell_range<kAxes>(cell, static_cast<int>(c), plane.call->model.weight));
    }
  }
}

}  // namespace

void add_linear(const Plane& plane, const PointBox& given, Color* out) {
  const Texture& texture = plane.call->texture;
  PointBox box = given;
  if (!searchable(plane, 0.5, &box)) return out->add(format_range(texture, plane.call->sampler));
  const Cells y = cells_of(box.axis[1]), z = is_deep(plane) ? cells_of(box.axis[2]) : Cells{0, 0};
  for (int64_t k = z.first; k <= z.last; ++k) {
    for (int64_t j = y.first; j <= y.last; ++j) {
      is_deep(plane) ? add_row<3>(plane, box, j, k, out) : add_row<2>(plane, box, j, k, out);
    }
  }
}

void add_nearest(const Plane& plane, const PointBox& given, Color* out) {
  const Texture& texture = plane.call->texture;
  PointBox box = given;
  if (!searchable(plane, 0.0, &box)) return out->add(format_range(texture, plane.call->sampler));
  const bool folds = texture.projection != SHD_PROJECTION_NONE;
  Cells cells[3] = {};
  for (int a = 0; a < axes_of(texture); ++a) {
    cells[a] = cells_of(box.axis[a]);
    if (!folds) continue;
    // The far edge of an image of directions belongs to its last texel, and nothing is folded.
    const auto clamp = [&](int64_t i) { return std::min(std::max(i, int64_t{0}), plane.size[a] - 1); };
    cells[a] = {clamp(cells[a].first), clamp(cells[a].last)};
  }
  for (int64_t k = cells[2].first; k <= cells[2].last; ++k) {
    for (int64_t j = cells[1].first; j <= cells[1].last; ++j) {
      for (int64_t i = cells[0].first; i <= cells[0].last; ++i) {
        out->add(folds ? stored_range(plane, plane.layer, i, j) : texel_range(plane, i, j, k));
      }
    }
  }
}

void add_everywhere(const Plane& plane, Color* out) {
  const BoundsCall& call = *plane.call;
  for (const int64_t size : plane.size) {
    if (size > max_cells(plane)) return out->add(format_range(call.texture, call.sampler));
  }
  const uint32_t faces = projection::face_count(call.texture.projection);
  const uint32_t first = faces > 1 || is_deep(plane) ? 0 : plane.layer;
  const uint32_t count = faces > 1 ? faces : static_cast<uint32_t>(plane.size[2]);
  for (uint32_t image = first; image < first + count; ++image) {
    for (int64_t j = 0; j < plane.size[1]; ++j) {
      for (int64_t i = 0; i < plane.size[0]; ++i) out->add(stored_range(plane, image, i, j));
    }
  }
  if (has_border(call.texture, call.sampler)) out->add(texel_range(plane, -1, -1, -1));
}

}  // namespace shd::texture
