// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "geometry/vertex.h"
#include "raster/fragments.h"

namespace shd::raster {

/// Planes are defined over cells of kTile x kTile pixels, on a grid that starts at the top left corner of the picture.
/// Tiles start at the corner of the framebuffer: a tile of a window may touch four cells.
struct Cell {
  int32_t left, top;  // first pixel in the picture

  bool operator==(const Cell& other) const { return left == other.left && top == other.top; }
};
inline Cell cell_of(int32_t x, int32_t y) {
  return {x & -kTile, y & -kTile};
}
/// The cell of a pixel of a tile whose first pixel is (left, top).
inline Cell cell_of(int32_t left, int32_t top, uint32_t pixel) {
  return cell_of(left + static_cast<int32_t>(pixel % kTile), top + static_cast<int32_t>(pixel / kTile));
}

/// A linear function of the raster position: at_middle + dx x + dy y, where x and y are relative to the middle of a
/// cell [pixels]. T is float, or a vector of equal values (lit_rows-inl.h).
template <class T>
struct PlaneOf {
  T at_middle, dx, dy;
};
using Plane = PlaneOf<float>;

/// A texture coordinate of a triangle. The coordinate minus `base`, times the inverse of w, is a plane.
template <class T>
struct CoordinatePlaneOf {
  PlaneOf<T> offset;
  T base;       // near the coordinate at the middle of the cell, within those of the corners
  T low, high;  // range of the corners, minus base
};
using CoordinatePlane = CoordinatePlaneOf<float>;

/// The attributes of a triangle as functions of the position in one cell. A value that is linear on the triangle is the
/// quotient of a plane and of the plane `inverse_w`. The planes of barycentric coordinates are the cross products of
/// the corners in homogeneous raster coordinates (Olano and Greer, "Triangle Scan Conversion Using 2D Homogeneous
/// Coordinates", 1997), computed in double and rounded once, in units of the largest inverse of w in the cell. With
/// Vertices::affine the corners are projected first, so that w is 1 and values are linear on the screen.
template <class T>
struct TrianglePlanesOf {
  T middle_x, middle_y;         // middle of the cell [pixels]
  PlaneOf<T> inverse_w;         // in 0..1 where the triangle is visible, up to rounding
  PlaneOf<T> b1, b2;            // planes of the weights of corners 1 and 2
  CoordinatePlaneOf<T> u, v;    // first uv set
  CoordinatePlaneOf<T> u1, v1;  // second uv set, if the vertices have one
};
using TrianglePlanes = TrianglePlanesOf<float>;

/// Least inverse of w that pixels divide by, as part of the largest one in the cell. Smaller ones are rounding errors.
constexpr float kLeastInverseW = 0x1p-24f;

/// Finds the planes of a triangle in a cell. Corners without area, or whose planes
/// leave the range of float, have constant planes: weights of a third, and the means of the texture coordinates.
/// Finite vertices give finite planes, and finite values and derivatives at all pixels of the cell.
/// @param row     the triangle's rows of `vertices`
/// @param wanted  kTexture and kTexture1: sets whose planes are found
void find_planes(const geometry::Vertices& vertices, const uint32_t (&row)[3], const Cell& cell, uint32_t wanted,
                 TrianglePlanes* out);

/// Whether the derivatives of linear values are the same at all pixels, because the corners have one w.
inline bool is_affine(const TrianglePlanes& planes) {
  return planes.inverse_w.dx == 0.0f && planes.inverse_w.dy == 0.0f;
}

}  // namespace shd::raster
