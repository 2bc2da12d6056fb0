// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: polygon, barycentric coordinates of points on simple polygons and in polyhedra.
///
/// Input:      vertices of a polygon in order, or of a closed triangle mesh, a cage; points.
/// Output:     a weight for each vertex at each point.
/// Invariants: everything is computed in double, except mean value coordinates in cages: those are in floats at points
///             where a bound of the error shows that floats suffice. The weights of a point sum to 1, and do not depend
///             on other points.
///
/// | file            | contents                                                              |
/// |-----------------|-----------------------------------------------------------------------|
/// | coordinates.h   | barycentric coordinates in closed form, and flaws of polygons         |
/// | harmonic.h      | harmonic coordinates, by linear elements                              |
/// | triangulate.h   | constrained Delaunay triangulations of polygons                       |
/// | sparse_solver.h | sparse linear systems; the only user of Eigen                         |
/// | cage.h          | closed triangle meshes: checks, edges, faces, nearest points          |
/// | cage_points.h   | points of a call, through the kernels, on the executor                |
/// | cage_weights.h  | kernels: coordinates in cages, sums of values with them as weights    |
#pragma once
