// SPDX-License-Identifier: MIT
#include "geometry/attributes.h"

namespace shd::geometry {
namespace {

bool has_any(const core::Array<float>* columns, size_t count) {
  for (size_t i = 0; i < count; ++i) {
    if (columns[i].size()) return true;
  }
  return false;
}

/// Interleaves four columns into rows of four; absent columns read as 0.
void interleave(const core::Array<float>* const columns[4], size_t begin, size_t end, float* rows) {
  for (size_t c = 0; c < 4; ++c) {
    const bool is_there = columns[c] && columns[c]->size();
    const float* from = is_there ? columns[c]->data() : nullptr;
    for (size_t i = begin; i < end; ++i) rows[4 * (i - begin) + c] = from ? from[i] : 0.0f;
  }
}

void transform_tangents(const Mesh& mesh, const Transform& transform, size_t begin, size_t end, float* rows) {
  const float* m = transform.world;
  for (size_t i = begin; i < end; ++i) {
    const float x = mesh.tx[i], y = mesh.ty[i], z = mesh.tz[i];
    float* row = rows + 4 * (i - begin);
    for (int r = 0; r < 3; ++r) row[r] = m[r] * x + m[4 + r] * y + m[8 + r] * z;
    row[3] = mesh.tw[i] * transform.orientation;
  }
}

}  // namespace

void allocate_attributes(const core::Allocator& allocator, const Mesh& mesh, uint32_t wanted, Vertices* out) {
  const size_t size = core::checked_mul(out->screen.size(), 4);
  if (wanted & kExtraTangent && mesh.tx.size()) out->tangent = core::Array<float>(allocator, size);
  if (wanted & kExtraTexture1 && mesh.u1.size()) out->texture1 = core::Array<float>(allocator, size);
  for (int k = 0; wanted & kExtraAttributes && k < 2; ++k) {
    if (has_any(mesh.attribute + 4 * k, 4)) out->attribute[k] = core::Array<float>(allocator, size);
  }
  for (int k = 0; wanted & kExtraAttributes && k < SHD_MAX_ATTRIBUTES; ++k) {
    out->has_attribute[k] = mesh.attribute[k].size() != 0;
  }
}

void transform_attributes(const Mesh& mesh, const Transform& transform, const VertexRange& range, Vertices* out) {
  const auto [begin, end, row] = range;
  if (out->tangent.size()) transform_tangents(mesh, transform, begin, end, &out->tangent[4 * row]);
  if (out->texture1.size()) {
    const core::Array<float>* const columns[4] = {&mesh.u1, &mesh.v1, nullptr, nullptr};
    interleave(columns, begin, end, &out->texture1[4 * row]);
  }
  for (int k = 0; k < 2; ++k) {
    if (out->attribute[k].size() == 0) continue;
    const core::Array<float>* const columns[4] = {&mesh.attribute[4 * k], &mesh.attribute[4 * k + 1],
                                                  &mesh.attribute[4 * k + 2], &mesh.attribute[4 * k + 3]};
    interleave(columns, begin, end, &out->attribute[k][4 * row]);
  }
}

}  // namespace shd::geometry
