// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include <shd/occlusion.h>

namespace shd::embree {

/// A mesh as triangles, in object space.
struct Triangles {
  std::vector<float> position;    // x, y, z of each vertex
  std::vector<uint32_t> indices;  // three for each triangle
};

/// Triangles of a mesh whose positions are finite. Throws Failure.
Triangles read_triangles(const shd_mesh* mesh);

/// An Embree scene.
class Tree {
 public:
  Tree();
  ~Tree();
  Tree(const Tree&) = delete;
  Tree& operator=(const Tree&) = delete;

  /// Adds triangles, transformed by a matrix in double and rounded once. Throws Failure.
  void add(const Triangles& triangles, const float object_to_world[16]);
  /// Builds the tree after the last triangles. Throws Failure.
  void build();
  /// Sets blocked[i] for the rays that meet a triangle. Any thread.
  void trace(const shd_rays& rays, uint32_t* blocked) const;

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace shd::embree
