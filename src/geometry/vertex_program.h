// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/vertices.h>
#include <shd/view.h>

#include "core/allocator.h"
#include "core/simd_target.h"
#include "geometry/mesh.h"
#include "geometry/vertex.h"

namespace shd::geometry {

/// Largest number of vertices in one call of a program; a multiple of data::kRowPad. The columns of a batch stay in L2.
constexpr size_t kVertexBatch = 512;

/// A caller's program for the vertices of one draw, and its inputs.
struct VertexProgram {
  shd_vertex_fn function;
  void* user_data;
  const void* uniforms;
  const shd_view* view;
  const float* object_to_world;
  uint32_t draw, instance;
  uint32_t varying_count;
};

/// The outputs of a program: scratch of one worker, columns of kVertexBatch elements in one block.
struct VertexColumns {
  core::Array<float> block;
  float *x, *y, *z, *w;  // clip space
  float *px, *py, *pz;   // position, world space
  float *nx, *ny, *nz;   // normal, world space
  float *u, *v;          // texture coordinates
  float* varying[SHD_MAX_VARYINGS];
};

/// Throws std::bad_alloc.
void allocate(const core::Allocator& allocator, VertexColumns* out);

/// The vertices that a program runs on.
struct NumberedMesh {
  const Mesh& mesh;
  const uint32_t* numbers;  // [vertex] number passed to the program; null = 0, 1, 2, ...
};

/// Like transform_vertices, but the program may change every vertex before it is projected. A vertex that the program
/// does not change keeps its bits. Throws Failure if the program threw.
/// @param out  with room for the program's varyings
void run_vertex_program(const core::SimdTarget& simd, const NumberedMesh& vertices, const Transform& transform,
                        const VertexProgram& program, const VertexRange& range, VertexColumns* scratch, Vertices* out);

}  // namespace shd::geometry
