// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: geometry, (mesh -> triangles on the pixel grid).
///
/// Input:      the caller's columns of vertices and triangles; per frame a view and an object-to-world matrix.
/// Output:     a Mesh with unit normals; per frame its Vertices in raster and world space, and the ScreenTriangles
///             that may be visible.
/// Units:      positions in object space; angles in radians.
/// Invariants: a Mesh never changes once built; every index is below vertex_count; uv, normals and tangents are
///             finite; positions are finite unless the caller asked to keep non-finite ones. A normal or tangent with
///             a non-finite component is replaced by the zero vector; u, v and handedness are replaced one by one.
///             Sums run over faces in index order, in double, on one thread, so that the bits never depend on workers.
///
/// | file             | contents                                                                    |
/// |------------------|-----------------------------------------------------------------------------|
/// | mesh.h           | Mesh, built from the caller's columns                                       |
/// | indices.h        | triangles, strips and fans of 16- or 32-bit indices as index triples        |
/// | edges.h          | adjacency: the triangles that share each edge                               |
/// | face.h           | area and normal of a triangle, position and normal of a vertex              |
/// | feature_edges.h  | edges of line drawings: silhouettes, creases, borders                       |
/// | normals.h        | vertex normals from faces, weighted by area, corner angle or not at all     |
/// | uv_projection.h  | texture coordinates from positions, and the vertices that they add          |
/// | copies.h         | copies of vertices with all their columns                                   |
/// | tangents.h       | tangents to the MikkTSpace convention, and the vertices that they add       |
/// | tangent_groups.h | corners that share a tangent, and the sum of their directions               |
/// | tessellate.h     | a mesh of smaller triangles, with all its columns                           |
/// | split_edges.h    | edges of a mesh, and the number of parts of each                            |
/// | cut.h            | vertices and triangles of a mesh whose edges are split into parts           |
/// | row_pattern.h    | subdivision of a triangle into rows, from the numbers of parts of its sides |
/// | displace.h       | vertices moved along their normals by a texture                             |
/// | weld.h           | merging of vertices with equal columns                                      |
/// | buckets.h        | bucket sort of indices, such as corners by their vertex                     |
/// | vertex.h         | kernel: vertices of a draw to raster, world and normal space, with outcodes |
/// | vertex_program.h | kernel: the same transform with a program of the caller in between          |
/// | vertex-inl.h     | code shared by these two kernels                                            |
/// | vertex_window.h  | the vertices that a part of a draw needs                                    |
/// | unwrap.h         | vertices at their texture coordinates, for bakes                            |
/// | attributes.h     | tangents, a second uv set and the caller's columns in the same rows         |
/// | clip.h           | clipping of triangles at the near and far plane and the guard band          |
/// | pixel_box.h      | boxes of pixels                                                             |
/// | outline.h        | edges and vertices of triangles as rectangles                               |
/// | emit.h           | the outcome of one triangle on the pixel grid                               |
/// | assemble.h       | culling, clipping and counting: mesh triangles to ScreenTriangle            |
#pragma once
