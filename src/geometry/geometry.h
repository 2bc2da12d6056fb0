// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: geometry, (mesh -> triangles on the pixel grid).
///
/// Input:      the caller's columns of vertices and triangles; per frame a view and an object-to-world matrix.
/// Output:     a Mesh with unit normals; per frame its Vertices in raster and world space, and the ScreenTriangles that
///             may show.
/// Units:      positions in object space; angles in radians.
/// Invariants: a Mesh never changes once built; every index is below vertex_count; uv, normals and tangents are
///             finite; positions are finite unless the caller asked to keep others. A normal or tangent with a
///             component that is not finite counts as the zero vector; u, v and handedness count one by one.
///             Sums run over faces in index order, in double, on one thread: the bits never depend on workers.
///
/// | file             | what                                                                        |
/// |------------------|-----------------------------------------------------------------------------|
/// | mesh.h           | Mesh, and its making from the caller's columns                              |
/// | indices.h        | triangles, strips and fans of 16- or 32-bit indices as index triples        |
/// | edges.h          | which triangles share each edge                                             |
/// | face.h           | area and normal of one triangle, place and normal of a vertex               |
/// | feature_edges.h  | edges of line drawings: silhouettes, creases, borders                       |
/// | normals.h        | vertex normals from faces, weighted by area, corner angle or not at all     |
/// | tangents.h       | tangents to the MikkTSpace convention, and the vertices they add            |
/// | tangent_groups.h | corners that share a tangent, and its sum                                   |
/// | tessellate.h     | a mesh of smaller triangles, with all its columns                           |
/// | split_edges.h    | edges of a mesh, and how many parts each has                                |
/// | cut.h            | the vertices and triangles of a mesh whose edges have parts                 |
/// | row_pattern.h    | a triangle with sides of given parts, in rows                               |
/// | displace.h       | vertices moved along their normals by a texture                             |
/// | weld.h           | vertices of equal columns as one                                            |
/// | buckets.h        | numbers sorted by another, as corners by their vertex                       |
/// | vertex.h         | kernel: vertices of a draw to raster, world and normal space, with outcodes |
/// | vertex_program.h | the same with a program of the caller's in between                          |
/// | vertex-inl.h     | what those two kernels share                                                |
/// | vertex_window.h  | the vertices that a part of a draw needs                                    |
/// | attributes.h     | tangents, a second uv set and the caller's columns at the same rows         |
/// | clip.h           | a triangle cut at the near and far plane and the guard band                 |
/// | pixel_box.h      | boxes of pixels                                                             |
/// | outline.h        | edges and vertices of triangles as rectangles                               |
/// | emit.h           | the outcome of one triangle on the pixel grid                               |
/// | assemble.h       | culling, clipping and counting: mesh triangles to ScreenTriangle            |
#pragma once
