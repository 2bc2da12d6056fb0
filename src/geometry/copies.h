// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/allocator.h"
#include "data/data.h"
#include "geometry/mesh.h"

namespace shd::geometry {

/// Appends `count` copies of vertices; copy i has the columns of vertex source_of(i). Adds to vertex_count and
/// info.split_count. Throws std::bad_alloc.
template <class SourceOf>
void append_copies(const core::Allocator& allocator, size_t count, const SourceOf& source_of, Mesh* mesh) {
  const size_t before = mesh->vertex_count;
  const size_t after = before + count;
  for_each_column(mesh, [&](core::Array<float>* column) {
    if (column->size() == 0) return;
    core::Array<float> larger(allocator, data::padded(after));
    std::memcpy(larger.data(), column->data(), before * sizeof(float));
    for (size_t i = before; i < after; ++i) larger[i] = (*column)[source_of(i - before)];
    for (size_t i = after; i < larger.size(); ++i) larger[i] = 0.0f;
    *column = std::move(larger);
  });
  mesh->vertex_count = static_cast<uint32_t>(after);
  mesh->info.split_count += count;
}

}  // namespace shd::geometry
