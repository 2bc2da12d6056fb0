// SPDX-License-Identifier: MIT
#include "texture/oracle/bounds/cells.h"

#include <algorithm>
#include <cmath>

#include "texture/store/storage.h"

namespace shd::texture {
namespace {

/// Returns a range of coordinates with the same texels and not much more than one image, or two of MIRROR.
Range within_image(shd_wrap wrap, const Range& range, double n) {
  const double period = wrap == SHD_WRAP_MIRROR ? 2.0 * n : n;
  if (wrap == SHD_WRAP_REPEAT || wrap == SHD_WRAP_MIRROR) return range.length() >= period ? Range{0.0, period} : range;
  const double first = wrap == SHD_WRAP_MIRROR_ONCE ? -n - 2.0 : -2.0;
  const auto clamp = [&](double x) { return std::min(std::max(x, first), n + 2.0); };
  return {clamp(range.low), clamp(range.high)};
}

/// Returns the rectangle with both axes within the image, or false if it is too wide to be searched.
bool searchable(const Plane& plane, double shift, Rect* rect) {
  const Sampler& sampler = *plane.sampler;
  const bool cube = plane.texture->projection == SHD_PROJECTION_CUBE;
  rect->x = within_image(cube ? SHD_WRAP_CLAMP : sampler.wrap_u, rect->x, static_cast<double>(plane.width));
  rect->y = within_image(cube ? SHD_WRAP_CLAMP : sampler.wrap_v, rect->y, static_cast<double>(plane.height));
  rect->x = {rect->x.low - shift, rect->x.high - shift};
  rect->y = {rect->y.low - shift, rect->y.high - shift};
  const auto fits = [](double length, int64_t size) {
    return length <= static_cast<double>(2 * std::max(size, kMaxCells) + 8);
  };
  const auto wide = [](double length, int64_t size) {
    return size > kMaxCells && length > static_cast<double>(kMaxCells);
  };
  return fits(rect->x.length(), plane.width) && fits(rect->y.length(), plane.height) &&
         !wide(rect->x.length(), plane.width) && !wide(rect->y.length(), plane.height);
}

/// The four texels of a cell, and the part of the cell that a rectangle covers.
struct Cell {
  Color texel[4];
  Range s, t;
};

double bilinear(const double (&texel)[4], double s, double t) {
  const double top = (1.0 - s) * texel[0] + s * texel[1], bottom = (1.0 - s) * texel[2] + s * texel[3];
  return (1.0 - t) * top + t * bottom;
}

/// A bilinear function has its extremes on a rectangle at the corners.
Range cell_range(const Cell& cell, int c, double weight_error) {
  Range out, all;
  double low[4], high[4];
  for (int k = 0; k < 4; ++k) {
    const Range& value = cell.texel[k].channel[c];
    low[k] = value.low;
    high[k] = value.high;
    all.add(value);
  }
  if (!std::isfinite(all.low) || !std::isfinite(all.high)) return unbounded();
  for (const double s : {cell.s.low, cell.s.high}) {
    for (const double t : {cell.t.low, cell.t.high}) {
      out.add({bilinear(low, s, t), bilinear(high, s, t)});
    }
  }
  const Range slack = widened(out, weight_error * all.length());
  return {std::max(slack.low, all.low), std::min(slack.high, all.high)};
}

/// The part [0, 1] of cell i that a range covers.
Range part_of_cell(const Range& range, double i) {
  return {std::max(range.low - i, 0.0), std::min(range.high - i, 1.0)};
}

void load_column(const Plane& plane, int64_t i, int64_t j, int side, Cell* cell) {
  cell->texel[side] = texel_range(plane, i, j);
  cell->texel[2 + side] = texel_range(plane, i, j + 1);
}

void add_row(const Plane& plane, const Rect& rect, int64_t j, Color* out) {
  Cell cell;
  cell.t = part_of_cell(rect.y, static_cast<double>(j));
  const auto first = static_cast<int64_t>(std::floor(rect.x.low)), last = static_cast<int64_t>(std::floor(rect.x.high));
  load_column(plane, first, j, 1, &cell);
  for (int64_t i = first; i <= last; ++i) {
    cell.texel[0] = cell.texel[1];
    cell.texel[2] = cell.texel[3];
    load_column(plane, i + 1, j, 1, &cell);
    cell.s = part_of_cell(rect.x, static_cast<double>(i));
    for (uint32_t c = 0; c < plane.texture->channels; ++c) {
      out->channel[c].add(cell_range(cell, static_cast<int>(c), plane.model->weight));
    }
  }
}

}  // namespace

void add_bilinear(const Plane& plane, const Rect& given, Color* out) {
  Rect rect = given;
  if (!searchable(plane, 0.5, &rect)) return out->add(format_range(*plane.texture, *plane.sampler));
  const auto last = static_cast<int64_t>(std::floor(rect.y.high));
  for (auto j = static_cast<int64_t>(std::floor(rect.y.low)); j <= last; ++j) add_row(plane, rect, j, out);
}

void add_nearest(const Plane& plane, const Rect& given, Color* out) {
  Rect rect = given;
  if (!searchable(plane, 0.0, &rect)) return out->add(format_range(*plane.texture, *plane.sampler));
  // The far edge of a face of a cube belongs to its last texel.
  const bool cube = plane.texture->projection == SHD_PROJECTION_CUBE;
  const auto index = [&](double x) {
    const auto i = static_cast<int64_t>(std::floor(x));
    return cube ? std::min(std::max(i, int64_t{0}), plane.width - 1) : i;
  };
  for (int64_t j = index(rect.y.low); j <= index(rect.y.high); ++j) {
    for (int64_t i = index(rect.x.low); i <= index(rect.x.high); ++i) out->add(texel_range(plane, i, j));
  }
}

void add_everywhere(const Plane& plane, Color* out) {
  if (plane.width > kMaxCells || plane.height > kMaxCells) {
    return out->add(format_range(*plane.texture, *plane.sampler));
  }
  const bool cube = plane.texture->projection == SHD_PROJECTION_CUBE;
  Plane face = plane;
  for (face.layer = cube ? 0 : plane.layer; face.layer < (cube ? 6 : plane.layer + 1); ++face.layer) {
    for (int64_t j = 0; j < plane.height; ++j) {
      for (int64_t i = 0; i < plane.width; ++i) out->add(texel_range(face, i, j));
    }
  }
  if (has_border(*plane.texture, *plane.sampler)) out->add(texel_range(plane, -1, -1));
}

}  // namespace shd::texture
