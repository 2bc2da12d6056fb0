// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <shd/shd.h>

/// The workload of shd and its peers, built outside the timed loop with fixed seeds.
namespace shd::bench {

/// One lookup per pixel of a square frame.
constexpr uint32_t kFrameEdge = 1024;
constexpr size_t kLookupCount = size_t{kFrameEdge} * kFrameEdge;

/// Texels of a square texture: smooth waves with noise on top, four 8-bit channels, packed, row 0 on top.
std::vector<uint8_t> make_rgba8(uint32_t edge);

/// A plane that recedes to `far` times the distance of its nearest row, seen over a frame of frame x frame pixels. At
/// (x, y) pixels from the top left: 1/z = 1/far + (1 - 1/far) y / frame, u = scale (x / frame - 1/2) z, v = scale z.
/// A turned floor has (u, v) turned by 45 degrees.
struct Floor {
  float far = 20.0f;
  float scale = 0.25f;
  uint32_t frame = kFrameEdge;
  bool turned = false;

  /// A floor with the same footprint in texels for any size: half a texel across the nearest pixel.
  static Floor of_texture(uint32_t edge) { return {20.0f, 512.0f / static_cast<float>(edge)}; }
  float edge() const { return static_cast<float>(frame); }
  float z(float y) const { return 1.0f / (1.0f / far + (1.0f - 1.0f / far) * y / edge()); }
  float u(float x, float z) const { return scale * (x / edge() - 0.5f) * z; }
  float v(float z) const { return scale * z; }
};

/// A quadrilateral that fills a frame: corners top left, top right, bottom left, bottom right.
struct Surface {
  float clip[4][4];  // x, y, z, w
  float uv[4][2];
};
Surface floor_surface(const Floor& floor);
/// A surface that faces the eye, with `repeat` repetitions of the texture along both axes.
Surface quad_surface(float repeat);

/// Columns of lookups with analytic derivatives, a whole number of frame rows, in frame order.
struct Lookups {
  std::vector<float> u, v, dudx, dvdx, dudy, dvdy;
  std::vector<float> lod;  // in place of the derivatives; may be empty

  size_t count() const { return u.size(); }
};

Lookups floor_lookups(const Floor& floor);
/// kLookupCount lookups, uniform in [0, 1)^2, with a footprint of `texels` texels along both axes.
Lookups random_lookups(uint32_t edge, float texels);

/// Spheres on a cubic grid in [-1, 1]^3, one mesh drawn many times.
struct Spheres {
  std::string name;
  uint32_t slices, stacks, per_axis;

  std::vector<float> position[3], uv[2];  // normals are the positions: the mesh is the unit sphere
  std::vector<uint32_t> indices;
  std::vector<float> object_to_world;  // 16 per sphere, column-major
  shd_view view;

  size_t sphere_count() const { return size_t{per_axis} * per_axis * per_axis; }
  size_t triangle_count() const { return indices.size() / 3 * sphere_count(); }
};

Spheres make_spheres(const std::string& name, uint32_t slices, uint32_t stacks, uint32_t per_axis);

/// The same triangles in one mesh, whose matrix is the identity. Normals are the positions here too.
Spheres merge(const std::string& name, const Spheres& spheres);

/// The two point lights and the one material of every frame.
struct PointLight {
  float position[3];
  float intensity[3];
};
constexpr PointLight kLights[2] = {{{3.0f, 4.0f, 5.0f}, {60.0f, 58.0f, 55.0f}},
                                   {{-4.0f, 1.0f, 3.0f}, {12.0f, 14.0f, 18.0f}}};
constexpr float kDiffuse = 0.7f;
constexpr float kSpecular = 0.3f;
constexpr float kExponent = 32.0f;
constexpr uint32_t kFrameTextureEdge = 1024;

/// Mean and largest absolute difference of two RGBA images, r, g, b only, both clamped to [0, 1].
struct Difference {
  double mean = 0.0, max = 0.0;
};
Difference compare(const std::vector<float>& a, const std::vector<float>& b);

/// Writes r, g, b of a square image as a binary PPM to the folder in the environment variable SHD_BENCH_WRITE, if set.
void maybe_write(const std::string& name, const std::vector<float>& rgba);

/// Stores a rate of a peer, for the ratio column of later rows.
void record_rate(const std::string& row, double items_per_second);
/// Returns 0 if the peer did not run.
double recorded_rate(const std::string& row);

}  // namespace shd::bench
