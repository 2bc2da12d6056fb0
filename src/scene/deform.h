// SPDX-License-Identifier: MIT
#pragma once

#include "scene/pose.h"

namespace shd::scene {

/// A mesh of a scene: a geometry, and what gives its vertices their places.
struct MeshRow {
  uint32_t geometry = 0;
  int32_t skin = -1;       // its joints place the vertices in the world; -1 = a node places the mesh
  int32_t node = -1;       // weights of morph targets; -1 = no targets
  bool second_uv = false;  // a normal map is read at uv1, so that tangents by uv would turn it
};

/// The vertices of a geometry in one pose: in object space, or in world space with a skin.
struct Vertices {
  std::array<double, 3> origin = {0, 0, 0};  // added to all positions
  std::vector<float> position;               // [vertex][3]
  std::vector<float> normal;                 // [vertex][3], or empty
  std::vector<float> tangent;                // [vertex][4], or empty
  std::vector<uint32_t> indices;             // [triangle][3]
};

/// The vertices of a row that has morph targets or a skin. Targets are added by their weights (glTF 2.0, 3.7.2.2), then
/// each vertex moves by the mean of its joints' matrices (3.7.3.3); a vertex without weights stays. Normals move by the
/// inverse transpose, and triangles that a skin mirrors turn around, so that their front stays outside.
Vertices deform(const Model& model, const MeshRow& row, const Pose& pose);

}  // namespace shd::scene
