// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

/// What is to be drawn, as plain data: an importer or the teapot makes it, scene.cpp turns it into shd objects.

/// Triangles in object space, counter-clockwise seen from the front.
struct Geometry {
  std::vector<float> position;    // [vertex][3]
  std::vector<float> normal;      // [vertex][3], or empty: shd computes them
  std::vector<float> uv;          // [vertex][2], v down, or empty
  std::vector<uint32_t> indices;  // [triangle][3]
};

/// Where a texture comes from: a file, or bytes that the model carries.
struct TextureSource {
  std::string path;                 // file to load, or the name of an embedded one
  std::vector<unsigned char> file;  // a whole image file in memory; empty = not embedded so
  std::vector<unsigned char> rgba;  // [height][width][4], sRGB; empty = not embedded so
  uint32_t width = 0, height = 0;   // of rgba
};

/// Reflectance, scene-linear.
struct Surface {
  std::string name;
  std::array<float, 3> diffuse = {0.8f, 0.8f, 0.8f};
  std::array<float, 3> specular = {0.25f, 0.25f, 0.25f};
  float exponent = 40.0f;
  int texture = -1;            // index into Model::textures
  int wrap_u = 0, wrap_v = 0;  // shd_wrap
};

/// A geometry placed in the world.
struct Instance {
  size_t geometry = 0, surface = 0;
  std::array<float, 16> object_to_world = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};  // column-major
};

struct Model {
  std::vector<Geometry> geometries;
  std::vector<Surface> surfaces;
  std::vector<TextureSource> textures;
  std::vector<Instance> instances;
};

/// A sphere around everything, world space.
struct Bounds {
  std::array<float, 3> center = {0, 0, 0};
  float radius = 1.0f;
};

/// Sphere around the box of all placed vertices that triangles use; non-finite ones are left out.
Bounds bounds_of(const Model& model);
