// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: polygon, barycentric coordinates of points on simple polygons.
///
/// Input:      vertices of a polygon in order, points.
/// Output:     a weight for each vertex at each point.
/// Invariants: everything is computed in double; the weights of a point sum to 1.
///
/// | file            | contents                                                              |
/// |-----------------|-----------------------------------------------------------------------|
/// | coordinates.h   | barycentric coordinates in closed form, and flaws of polygons         |
/// | harmonic.h      | harmonic coordinates, by linear elements                              |
/// | triangulate.h   | constrained Delaunay triangulations of polygons                       |
/// | sparse_solver.h | sparse linear systems; the only user of Eigen                         |
#pragma once
