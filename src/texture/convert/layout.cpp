// SPDX-License-Identifier: MIT
#include <cstring>

#include "image/format.h"
#include "texture/convert/convert.h"

namespace shd::texture {
namespace {

struct Cell {
  uint32_t x, y;
};

/// Cell of each face.
constexpr Cell kHorizontal[6] = {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}};
constexpr Cell kVertical[6] = {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {1, 3}};

Cell cell_of(shd_cube_layout layout, uint32_t face) {
  switch (layout) {
    case SHD_CUBE_LAYOUT_ROW: return {face, 0};
    case SHD_CUBE_LAYOUT_COLUMN: return {0, face};
    case SHD_CUBE_LAYOUT_HORIZONTAL_CROSS: return kHorizontal[face];
    case SHD_CUBE_LAYOUT_VERTICAL_CROSS: return kVertical[face];
    default: return {0, 0};
  }
}

}  // namespace

LayoutSize layout_size(shd_cube_layout layout) {
  switch (layout) {
    case SHD_CUBE_LAYOUT_ROW: return {6, 1};
    case SHD_CUBE_LAYOUT_COLUMN: return {1, 6};
    case SHD_CUBE_LAYOUT_HORIZONTAL_CROSS: return {4, 3};
    case SHD_CUBE_LAYOUT_VERTICAL_CROSS: return {3, 4};
    default: return {1, 1};
  }
}

DirectionFaces faces_of(shd_projection projection, shd_cube_layout layout, const shd_image* images) {
  DirectionFaces faces = {projection, images[0].format, images[0].width, images[0].height, {}};
  const size_t pixel = image::format_info(faces.format).pixel_size;
  const auto pixels_of = [](const shd_image& image) { return static_cast<uint8_t*>(image.pixels); };
  const LayoutSize size = layout_size(layout);
  faces.width /= size.across;
  faces.height /= size.down;
  for (uint32_t f = 0; f < projection::face_count(projection); ++f) {
    const shd_image& image = images[layout == SHD_CUBE_LAYOUT_FACES ? f : 0];
    const Cell cell = cell_of(layout, f);
    const size_t row = size_t{cell.y} * faces.height, column = size_t{cell.x} * faces.width;
    faces.face[f] = {pixels_of(image) + row * image.row_stride + column * pixel, image.row_stride,
                     layout == SHD_CUBE_LAYOUT_VERTICAL_CROSS && f == 5};
  }
  return faces;
}

void clear_unused(shd_cube_layout layout, const shd_image& image) {
  const LayoutSize size = layout_size(layout);
  const uint32_t width = image.width / size.across, height = image.height / size.down;
  const size_t bytes = width * image::format_info(image.format).pixel_size;
  for (uint32_t y = 0; y < size.down; ++y) {
    for (uint32_t x = 0; x < size.across; ++x) {
      bool used = false;
      for (uint32_t f = 0; f < 6; ++f) used = used || (cell_of(layout, f).x == x && cell_of(layout, f).y == y);
      for (uint32_t row = 0; !used && row < height; ++row) {
        std::memset(static_cast<uint8_t*>(image.pixels) + (size_t{y} * height + row) * image.row_stride + x * bytes, 0,
                    bytes);
      }
    }
  }
}

}  // namespace shd::texture
