// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/view.h>

#include "core/allocator.h"
#include "core/context.h"
#include "geometry/mesh.h"
#include "geometry/pixel_box.h"

namespace shd::geometry {

/// Raster coordinates are fixed point with this many fractional bits.
constexpr int kSubpixelBits = 8;
constexpr int32_t kSubpixels = 1 << kSubpixelBits;

/// Largest |raster coordinate| that is not clipped [pixels]. It is 2^28 in fixed point, so that products of differences
/// fit in int64 with room to spare.
constexpr float kGuardBand = 1048576.0f;

/// Smallest W that is not clipped away.
constexpr float kMinW = 0x1p-100f;

/// Limits that a vertex lies beyond. A triangle is outside if its three vertices share a bit.
enum Outcode : uint32_t {
  kOutLeft = 1,
  kOutRight = 2,
  kOutTop = 4,
  kOutBottom = 8,
  kOutNear = 16,       // Z < 0
  kOutFar = 32,        // Z > W
  kOutBehind = 64,     // W < kMinW
  kOutGuard = 128,     // beyond kGuardBand: must be clipped
  kOutNonfinite = 256  // NaN or infinite: the triangle is dropped
};
constexpr uint32_t kOutside = kOutLeft | kOutRight | kOutTop | kOutBottom | kOutNear | kOutFar | kOutBehind;
constexpr uint32_t kMustClip = kOutNear | kOutFar | kOutBehind | kOutGuard;

/// A vertex on the pixel grid; x, y and z are undefined where outcode & kMustClip.
struct ScreenVertex {
  int32_t x, y;  // raster position in 1 / kSubpixels pixel, origin at the top left corner, y down
  float z;       // depth, 0 near .. 1 far
  uint32_t outcode;
};

/// Matrices of one draw, column-major.
struct Transform {
  float raster[16];   // object space to (X, Y, Z, W): raster position (X / W, Y / W) in pixels, y down; depth Z / W
  float world[16];    // object space to world space; affine
  float normal[9];    // object space normals to world space, up to length: cofactors times the sign of det
  float orientation;  // sign of det: -1 where the matrix mirrors
  float left, top, right, bottom;  // limits of the visible pixels [pixels]
  float clip[16];                  // object space to clip space (x, y, z, w); z and w are Z and W
  float half[2], centre[2];        // viewport [pixels]: X = centre w + half x, Y = centre w - half y
};

/// The rectangle of the picture that NDC -1..1 maps to [pixels].
struct Viewport {
  uint32_t x, y, width, height;
};

/// The products are computed in double and rounded once.
/// @param visible  the visible pixels; triangles beyond them may count as outside
Transform make_transform(const shd_view& view, const float object_to_world[16], const Viewport& viewport,
                         const PixelBox& visible);

/// Transformed vertices of one draw or of a part of it. The layout is rows of four, not columns: a fragment gathers all
/// of a vertex, and a row lies in one cache line. Texture coordinates u and v fill the rows of positions and normals:
/// see u_of() and v_of().
struct Vertices {
  core::Array<ScreenVertex> screen;  // [padded]
  core::Array<float> raster;         // [padded][4] X, Y, Z, W
  core::Array<float> world;          // [padded][4] x, y, z, u
  core::Array<float> normal;         // [padded][4] x, y, z (unit, world space), v
  core::Array<float> varying;        // [padded][varying_count] outputs of a vertex program
  uint32_t varying_count = 0;
  core::Array<float> tangent;       // [padded][4] x, y, z (world space), handedness; or empty
  core::Array<float> texture1;      // [padded][4] u, v of the second set, 0, 0; or empty
  core::Array<float> attribute[2];  // [padded][4] columns of the mesh, 0 if absent; or empty
  bool has_attribute[SHD_MAX_ATTRIBUTES] = {};
  bool affine = false;  // attributes are linear on the screen, not on the triangle (SHD_DRAW_AFFINE)

  // Rows of the corners of each triangle: see row_of().
  const uint32_t* indices = nullptr;  // indices of the mesh, or own_indices
  uint32_t first_triangle = 0;        // triangle of the mesh whose corner is indices[0]
  uint32_t first_index = 0;           // index of row 0
  core::Array<uint32_t> own_indices;  // one per corner if the vertices are scattered, otherwise empty
  const uint32_t* corners = nullptr;  // [row] vertex of the mesh if scattered, otherwise null
};

/// Row of corner k of a triangle of the mesh.
inline uint32_t row_of(const Vertices& vertices, size_t triangle, size_t k) {
  return vertices.indices[3 * (triangle - vertices.first_triangle) + k] - vertices.first_index;
}

/// One component of the rows of a [padded][4] array.
struct RowComponent {
  const float* rows;  // [padded][4]
  uint32_t component;

  float operator[](size_t row) const { return rows[4 * row + component]; }
};

/// Texture coordinates of the first set, and of the second set if vertices.texture1 is not empty.
inline RowComponent u_of(const Vertices& vertices) {
  return {vertices.world.data(), 3};
}
inline RowComponent v_of(const Vertices& vertices) {
  return {vertices.normal.data(), 3};
}
inline RowComponent u1_of(const Vertices& vertices) {
  return {vertices.texture1.data(), 0};
}
inline RowComponent v1_of(const Vertices& vertices) {
  return {vertices.texture1.data(), 1};
}

/// Vertices [begin, end) of a mesh, and the row of the first of them. Kernels need multiples of data::kRowPad.
struct VertexRange {
  size_t begin, end;
  size_t row;
};

/// Allocates a number of rows, a multiple of data::kRowPad. Throws std::bad_alloc.
void allocate_rows(const core::Allocator& allocator, size_t rows, uint32_t varying_count, Vertices* out);

/// Allocates a row for every vertex of a mesh. Throws std::bad_alloc.
void allocate(const core::Allocator& allocator, const Mesh& mesh, uint32_t varying_count, Vertices* out);

/// Transforms vertices of a mesh by the matrices alone.
void transform_vertices(const core::SimdTarget& simd, const Mesh& mesh, const Transform& transform,
                        const VertexRange& range, Vertices* out);

}  // namespace shd::geometry
