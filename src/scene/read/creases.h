// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "scene/limits.h"
#include "scene/model.h"
#include "scene/read/positions.h"

namespace shd::scene {

/// Cosine of the greatest angle that computed normals smooth: 60 degrees. Cubes keep their edges.
constexpr double kCrease = 0.5;

/// A corner of a face, whose normal is computed.
struct CreaseCorner {
  uint32_t place;  // corners with the same place smooth each other
  uint32_t face;   // row of the normals of faces
  double cosine;   // least cosine of the angle between this face and those that smooth it
};

/// Normals of corners, each a row of `normals`.
struct CornerNormals {
  std::vector<uint32_t> row;   // [corner]
  std::vector<Point> normals;  // unit vectors
};

/// Means of the faces around the place of each corner, weighted by area, without faces at a greater angle than the
/// corner's cosine. So a surface and its copy that faces the other way do not cancel. Around a place of more than 256
/// faces all of them count. faces: normals of the faces, with their areas as lengths.
CornerNormals crease_normals(const std::vector<CreaseCorner>& corners, const std::vector<Point>& faces, size_t places,
                             const Deadline& deadline);

/// Computes the normals of `count` geometries in the same space, by kCrease. Equal positions are one place, so that
/// seams of textures and colours stay smooth. Vertices at sharp edges are split. Without skins and morph targets.
void add_creased_normals(Geometry* geometries, size_t count, const Limits& limits, const Deadline& deadline);

}  // namespace shd::scene
