// SPDX-License-Identifier: MIT
#include "geometry/vertex_program.h"

#include <algorithm>
#include <exception>

#include "core/status.h"
#include "data/data.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geometry/vertex_program.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "geometry/vertex-inl.h"
#include "simd/finite-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::geometry::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::IsFinite;
using simd::HWY_NAMESPACE::Load3;
using simd::HWY_NAMESPACE::Normalize;
using simd::HWY_NAMESPACE::Store3;
using simd::HWY_NAMESPACE::Vec3V;

/// Writes vertices [begin, begin + rows), transformed by the matrices, as the program's initial outputs.
void BeginVertices(const Mesh& mesh, const Transform& transform, size_t begin, size_t rows, const VertexColumns& c) {
  const hn::ScalableTag<float> d;
  for (size_t i = 0; i < rows; i += hn::Lanes(d)) {
    const size_t at = begin + i;
    const auto p = Load3(d, mesh.px.data(), mesh.py.data(), mesh.pz.data(), at);
    const auto n = Load3(d, mesh.nx.data(), mesh.ny.data(), mesh.nz.data(), at);
    hn::Store(TransformRow(d, transform.clip, 0, p), d, c.x + i);
    hn::Store(TransformRow(d, transform.clip, 1, p), d, c.y + i);
    hn::Store(TransformRow(d, transform.clip, 2, p), d, c.z + i);
    hn::Store(TransformRow(d, transform.clip, 3, p), d, c.w + i);
    Store3(d, WorldPosition(d, transform, p), c.px, c.py, c.pz, i);
    Store3(d, WorldNormal(d, transform, n), c.nx, c.ny, c.nz, i);
    hn::Store(hn::Load(d, &mesh.u[at]), d, c.u + i);
    hn::Store(hn::Load(d, &mesh.v[at]), d, c.v + i);
  }
}

/// Raster coordinate of a clip coordinate. Where the program left x and w unchanged, the result is bit-equal to the
/// transform without a program.
template <class D, class V>
HWY_INLINE V RasterCoordinate(D d, const Transform& transform, int axis, V x, V w, hn::Mask<D> same_w,
                              const Vec3V<V>& p) {
  const float half = axis == 0 ? transform.half[0] : -transform.half[1];
  const V mapped = hn::Set(d, transform.centre[axis]) * w + hn::Set(d, half) * x;
  const auto same = hn::And(same_w, hn::Eq(x, TransformRow(d, transform.clip, axis, p)));
  return hn::IfThenElse(same, TransformRow(d, transform.raster, axis, p), mapped);
}

/// Whether lanes i and up are finite in the columns that reach the fragments unchanged: u, v and the varyings.
template <class D>
HWY_INLINE hn::Mask<D> FiniteAttributes(D d, const VertexColumns& c, uint32_t varying_count, size_t i) {
  auto finite = hn::And(IsFinite(d, hn::Load(d, c.u + i)), IsFinite(d, hn::Load(d, c.v + i)));
  for (uint32_t k = 0; k < varying_count; ++k) finite = hn::And(finite, IsFinite(d, hn::Load(d, c.varying[k] + i)));
  return finite;
}

/// Projects vertices [begin, begin + rows) from the outputs of a program.
void FinishVertices(const Mesh& mesh, const Transform& transform, const VertexColumns& c, size_t begin, size_t rows,
                    size_t row, Vertices& out) {
  const hn::ScalableTag<float> d;
  using V = hn::Vec<decltype(d)>;
  for (size_t i = 0; i < rows; i += hn::Lanes(d)) {
    const size_t at = begin + i;
    const auto p = Load3(d, mesh.px.data(), mesh.py.data(), mesh.pz.data(), at);
    const V z = hn::Load(d, c.z + i), w = hn::Load(d, c.w + i);
    const auto same_w = hn::Eq(w, TransformRow(d, transform.clip, 3, p));
    const V x = RasterCoordinate(d, transform, 0, hn::Load(d, c.x + i), w, same_w, p);
    const V y = RasterCoordinate(d, transform, 1, hn::Load(d, c.y + i), w, same_w, p);

    const Vec3V<V> world = Load3(d, c.px, c.py, c.pz, i), given = Load3(d, c.nx, c.ny, c.nz, i);
    const auto n = Load3(d, mesh.nx.data(), mesh.ny.data(), mesh.nz.data(), at);
    const Vec3V<V> fixed = WorldNormal(d, transform, n), unit = Normalize(d, given);
    const auto same = hn::And(hn::And(hn::Eq(given.x, fixed.x), hn::Eq(given.y, fixed.y)), hn::Eq(given.z, fixed.z));

    auto finite = hn::And(hn::And(IsFinite(d, x), IsFinite(d, y)), hn::And(IsFinite(d, z), IsFinite(d, w)));
    finite = hn::And(finite, hn::And(IsFinite(d, world), IsFinite(d, given)));
    finite = hn::And(finite, FiniteAttributes(d, c, out.varying_count, i));
    const Vec3V<V> normal = {hn::IfThenElse(same, fixed.x, unit.x), hn::IfThenElse(same, fixed.y, unit.y),
                             hn::IfThenElse(same, fixed.z, unit.z)};
    StorePositions(d, world, hn::Load(d, c.u + i), row + i, out);
    StoreNormals(d, normal, hn::Load(d, c.v + i), row + i, out);
    StoreRaster(d, transform, Homogeneous<V>{x, y, z, w}, finite, row + i, out);
  }
}

}  // namespace shd::geometry::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::geometry {

HWY_EXPORT(BeginVertices);
HWY_EXPORT(FinishVertices);

namespace {

static_assert(kVertexBatch % data::kRowPad == 0, "batches are whole vectors");

void call(const VertexProgram& program, const shd_vertices& in, shd_vertex_outputs* out) {
  try {
    program.function(&in, out, program.user_data);
  } catch (const std::exception& error) {
    core::refuse(SHD_ERROR_CALLBACK, "material.program.vertex threw in render.draws[%u]: %s", program.draw,
                 error.what());
  } catch (...) {
    core::refuse(SHD_ERROR_CALLBACK, "material.program.vertex threw in render.draws[%u]", program.draw);
  }
}

/// Calls a program for `count` vertices from `first` on; they use the rows of its columns from `row` on.
void run(const Mesh& mesh, const VertexProgram& program, size_t first, uint32_t number, size_t count, size_t row,
         const VertexColumns& c) {
  shd_vertices in = {};
  in.struct_size = sizeof in;
  in.draw = program.draw;
  in.instance = program.instance;
  in.first = number;
  in.count = count;
  in.px = &mesh.px[first], in.py = &mesh.py[first], in.pz = &mesh.pz[first];
  in.nx = &mesh.nx[first], in.ny = &mesh.ny[first], in.nz = &mesh.nz[first];
  in.u = &mesh.u[first], in.v = &mesh.v[first];
  if (mesh.u1.size()) in.u1 = &mesh.u1[first], in.v1 = &mesh.v1[first];
  const float* attribute[SHD_MAX_ATTRIBUTES] = {};
  for (uint32_t k = 0; k < SHD_MAX_ATTRIBUTES; ++k) {
    if (mesh.attribute[k].size()) attribute[k] = &mesh.attribute[k][first];
  }
  in.attribute_count = SHD_MAX_ATTRIBUTES;
  in.attribute = attribute;
  if (mesh.tx.size()) {
    in.tx = &mesh.tx[first], in.ty = &mesh.ty[first], in.tz = &mesh.tz[first], in.tw = &mesh.tw[first];
  }
  in.object_to_world = program.object_to_world;
  in.world_to_view = program.view->world_to_view;
  in.view_to_clip = program.view->view_to_clip;
  in.eye = program.view->eye;
  in.uniforms = program.uniforms;
  shd_vertex_outputs out = {};
  out.struct_size = sizeof out;
  out.varying_count = program.varying_count;
  out.x = c.x + row, out.y = c.y + row, out.z = c.z + row, out.w = c.w + row;
  out.px = c.px + row, out.py = c.py + row, out.pz = c.pz + row;
  out.nx = c.nx + row, out.ny = c.ny + row, out.nz = c.nz + row;
  out.u = c.u + row, out.v = c.v + row;
  float* varying[SHD_MAX_VARYINGS];
  for (uint32_t k = 0; k < program.varying_count; ++k) varying[k] = c.varying[k] + row;
  out.varying = varying;
  call(program, in, &out);
#ifndef NDEBUG
  if (in.count != count) {
    core::refuse(SHD_ERROR_CALLBACK, "material.program.vertex changed the count in render.draws[%u]", program.draw);
  }
#endif
}

/// Calls a program for a batch: once for each run of consecutive vertex numbers.
void run_batch(const NumberedMesh& vertices, const VertexProgram& program, size_t first, size_t count,
               const VertexColumns& c) {
  const uint32_t* numbers = vertices.numbers;
  if (!numbers) return run(vertices.mesh, program, first, static_cast<uint32_t>(first), count, 0, c);
  numbers += first;
  for (size_t begin = 0, end = 0; begin < count; begin = end) {
    for (end = begin + 1; end < count && numbers[end] == numbers[end - 1] + 1; ++end) {
    }
    run(vertices.mesh, program, first + begin, numbers[begin], end - begin, begin, c);
  }
}

}  // namespace

void allocate(const core::Allocator& allocator, VertexColumns* out) {
  float** const columns[] = {&out->x,  &out->y,  &out->z,  &out->w,  &out->px, &out->py,
                             &out->pz, &out->nx, &out->ny, &out->nz, &out->u,  &out->v};
  constexpr size_t kFixed = sizeof columns / sizeof columns[0];
  out->block = core::Array<float>(allocator, (kFixed + SHD_MAX_VARYINGS) * kVertexBatch);
  float* next = out->block.data();
  const auto take = [&] {
    float* column = next;
    next += kVertexBatch;
    return column;
  };
  for (float** column : columns) *column = take();
  for (float*& column : out->varying) column = take();
}

void run_vertex_program(const core::SimdTarget& simd, const NumberedMesh& vertices, const Transform& transform,
                        const VertexProgram& program, const VertexRange& range, VertexColumns* scratch, Vertices* out) {
  const Mesh& mesh = vertices.mesh;
  const uint32_t varying_count = program.varying_count;
  for (size_t first = range.begin; first < range.end; first += kVertexBatch) {
    const size_t rows = std::min(kVertexBatch, range.end - first), to = range.row + (first - range.begin);
    SHD_DISPATCH(BeginVertices, simd)(mesh, transform, first, rows, *scratch);
    for (uint32_t k = 0; k < varying_count; ++k) std::fill_n(scratch->varying[k], rows, 0.0f);
    run_batch(vertices, program, first, std::min<size_t>(rows, mesh.vertex_count - first), *scratch);
    SHD_DISPATCH(FinishVertices, simd)(mesh, transform, *scratch, first, rows, to, *out);
    for (uint32_t k = 0; k < varying_count; ++k) {
      float* column = &out->varying[to * varying_count + k];
      for (size_t i = 0; i < rows; ++i) column[i * varying_count] = scratch->varying[k][i];
    }
  }
}

}  // namespace shd::geometry
#endif  // HWY_ONCE
