// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "tool/handles.h"
#include "tool/options.h"

/// The model to draw: the scene of a file or a shape, optionally with a floor.

/// A mesh, with the vertices and triangles that are needed to place a camera.
struct Geometry {
  std::string name;               // as in the file; may be empty
  Mesh own;                       // owner of a shape's mesh; empty for meshes of the scene
  shd_mesh* mesh = nullptr;       // null = drawn by others
  std::vector<float> position;    // [vertex][3]
  std::vector<uint32_t> indices;  // [triangle][3]
};

/// Description of a material before the options change it.
struct Surface {
  std::string name;
  shd_material_desc desc;
  bool is_floor = false;  // the options for the model do not apply to the floor
};

/// A geometry placed in the world.
struct Instance {
  size_t geometry = 0, surface = 0;
  shd_cull cull = SHD_CULL_NONE;
  std::array<float, 16> object_to_world = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};  // column-major
};

struct Model {
  Scene scene;  // scene of a file; empty for shapes
  std::vector<Geometry> geometries;
  std::vector<Surface> surfaces;
  std::vector<Instance> instances;
};

/// A box in world space; low is above high if it is empty.
struct Box {
  double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL};
  double high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
};

/// An animation of a file, and its first and last time [s].
struct Animation {
  uint32_t index = 0;
  double first = 0, last = 0;
};

/// A sphere around everything in world space, and the height of the lowest vertex.
struct Bounds {
  std::array<float, 3> center = {0, 0, 0};
  float radius = 1.0f;
  float bottom = -1.0f;
};

/// Loads the file or makes the shape that the options name. Problems with parts of a file are reported on stderr.
/// Throws Failure.
Model make_model(shd_context* context, const Options& options);

/// Adds a square floor under the model, four radii to each side.
void add_floor(shd_context* context, const Options& options, const Bounds& bounds, Model& model);

/// The animation that the options name. Throws Failure that lists those of the file.
Animation find_animation(const Options& options, const Model& model);

/// The pose of a model by an animation.
Model pose_model(const Model& model, const Animation& animation, double seconds);

/// Box of all placed vertices that triangles use, ignoring non-finite vertices.
Box box_of(const Model& model);

void grow(Box& box, const Box& by);

/// The corners of a box as vertices, without a mesh: something for a camera to show.
Model box_model(const Box& box);

/// Sphere around the box of all placed vertices that triangles use, ignoring non-finite vertices.
Bounds bounds_of(const Model& model);
