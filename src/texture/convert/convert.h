// SPDX-License-Identifier: MIT
/// @file
/// Contract of convert/: images of directions from one projection to another, and cubes from one layout to another.
/// Each texel of the result is an average of the source over the texel's directions.
#pragma once

#include <cstdint>

#include <shd/image.h>
#include <shd/projection.h>

#include "core/context.h"
#include "projection/projection.h"

namespace shd::texture {

/// One face of images of directions, in the caller's memory.
struct FacePixels {
  uint8_t* first;  // pixel (0, 0) of the face
  size_t row_stride;
  bool turned;  // stored turned by half a turn
};

/// All directions: the faces of a projection.
struct DirectionFaces {
  shd_projection projection;
  shd_format format;
  uint32_t width, height;  // size of a face [texels]
  FacePixels face[projection::most_faces()];
};

/// Checked images as faces. `images` has an element for each face for SHD_CUBE_LAYOUT_FACES, otherwise one.
DirectionFaces faces_of(shd_projection projection, shd_cube_layout layout, const shd_image* images);

/// Size of the image of a layout in faces; 1 x 1 for six images.
struct LayoutSize {
  uint32_t across, down;
};
LayoutSize layout_size(shd_cube_layout layout);

/// Writes 0 to the parts of a cross without a face.
void clear_unused(shd_cube_layout layout, const shd_image& image);

/// Averages `from` over the texels of `to`. Throws std::bad_alloc before anything is written.
void convert(const core::Context& context, const DirectionFaces& from, const DirectionFaces& to);

}  // namespace shd::texture
