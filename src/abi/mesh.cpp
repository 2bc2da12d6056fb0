// SPDX-License-Identifier: MIT
#include <shd/mesh.h>

#include <cstdio>

#include "abi/desc.h"
#include "abi/draws.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "data/column.h"
#include "geometry/mesh.h"

namespace {

using namespace shd;
using namespace shd::abi;

constexpr core::ObjectType kMeshType = core::ObjectType::kMesh;
constexpr uint32_t kMaxVertices = 1u << 28;

/// All columns of an attribute are there or none is, and each fits in memory.
shd_result check_attribute(const char* name, const shd_f32_in* columns, int size, uint32_t count) {
  char field[32];
  for (int c = 0; c < size; ++c) {
    std::snprintf(field, sizeof field, "mesh.%s[%d]", name, c);
    if (!columns[c].data != !columns[0].data) {
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "mesh.%s[%d].data: NULL, but another column is set; all %d or none",
                        name, columns[c].data ? 0 : c, size);
    }
    SHD_TRY(check_column(field, columns[c], count));
  }
  return SHD_OK;
}

shd_result check_columns(const shd_mesh_desc& desc) {
  if (desc.vertex_count > 0) {
    char field[32];
    for (int axis = 0; axis < 3; ++axis) {
      std::snprintf(field, sizeof field, "mesh.position[%d].data", axis);
      SHD_TRY(check_not_null(field, desc.position[axis].data));
    }
    SHD_TRY(check_attribute("position", desc.position, 3, desc.vertex_count));
  }
  SHD_TRY(check_attribute("normal", desc.normal, 3, desc.vertex_count));
  SHD_TRY(check_attribute("uv", desc.uv, 2, desc.vertex_count));
  SHD_TRY(check_attribute("uv1", desc.uv1, 2, desc.vertex_count));
  SHD_TRY(check_count("mesh.attribute_count", desc.attribute_count, 0, SHD_MAX_ATTRIBUTES));
  if (desc.attribute_count) SHD_TRY(check_not_null("mesh.attributes", desc.attributes));
  for (uint32_t c = 0; c < desc.attribute_count; ++c) {
    char field[32];
    std::snprintf(field, sizeof field, "mesh.attributes[%u]", c);
    SHD_TRY(check_column(field, desc.attributes[c], desc.vertex_count));
  }
  return check_attribute("tangent", desc.tangent, 4, desc.vertex_count);
}

shd_result check_uv_projection(const shd_mesh_desc& desc) {
  SHD_TRY(check_enum("mesh.uv_projection", desc.uv_projection, 0, SHD_UV_PROJECTION_BOX));
  if (desc.uv_projection == SHD_UV_PROJECTION_NONE) return SHD_OK;
  SHD_TRY(check_matrix("mesh.object_to_projection", desc.object_to_projection));
  if (!desc.uv[0].data) return SHD_OK;
  return core::fail(SHD_ERROR_INVALID_ARGUMENT, "mesh.uv_projection: %u, but mesh.uv is set too",
                    enum_bits(desc.uv_projection));
}

shd_result check_indices(const shd_mesh_desc& desc) {
  const bool indexed = desc.indices.data || desc.indices16.data;
  size_t count = desc.index_count;
  const char* field = "mesh.index_count";
  if (desc.indices.data && desc.indices16.data) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "mesh.indices16.data: set, but mesh.indices is too");
  }
  if (!indexed) {
    SHD_TRY(check_count("mesh.index_count without indices", count, 0, desc.vertex_count));
    if (count == 0) {
      count = desc.vertex_count;
      field = "mesh.vertex_count without indices";
    }
  }
  const bool separate = desc.topology == SHD_TOPOLOGY_TRIANGLES;
  SHD_TRY(check_count(field, count, 0, separate ? 3 * geometry::kMaxTriangles : geometry::kMaxTriangles + 2));
  if (separate && count % 3 != 0) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: %zu is not a multiple of 3", field, count);
  }
  SHD_TRY(check_column("mesh.indices", desc.indices, count));
  return check_column("mesh.indices16", desc.indices16, count);
}

shd_result check_mesh_desc(const shd_mesh_desc& desc) {
  SHD_TRY(check_count("mesh.vertex_count", desc.vertex_count, 0, kMaxVertices));
  SHD_TRY(check_enum("mesh.normal_weight", desc.normal_weight, SHD_NORMAL_WEIGHT_AREA, SHD_NORMAL_WEIGHT_ANGLE));
  SHD_TRY(check_flags("mesh.flags", desc.flags, SHD_MESH_KEEP_NONFINITE | SHD_MESH_TANGENTS | SHD_MESH_ADJACENCY));
  SHD_TRY(check_enum("mesh.topology", desc.topology, SHD_TOPOLOGY_TRIANGLES, SHD_TOPOLOGY_FAN));
  SHD_TRY(check_columns(desc));
  SHD_TRY(check_uv_projection(desc));
  return check_indices(desc);
}

using Column = core::Array<float>;

/// Copies the columns that pick(body, columns) points at; one that the mesh lacks reads as 0.
template <class Pick>
shd_result read_columns(const shd_mesh* mesh, const shd_f32_out* out, int count, const Pick& pick) {
  static const char* const kFields[4] = {"out[0]", "out[1]", "out[2]", "out[3]"};
  const geometry::Mesh* body = nullptr;
  SHD_TRY(read_handle("mesh", mesh, kMeshType, &body));
  SHD_TRY(check_not_null("out", out));
  for (int c = 0; c < count; ++c) SHD_TRY(check_column(kFields[c], out[c], body->vertex_count));
  const Column* columns[4];
  pick(*body, columns);
  for (int c = 0; c < count; ++c) {
    if (!out[c].data) continue;
    const Column& column = *columns[c];
    for (size_t i = 0; i < body->vertex_count; ++i) data::store(out[c], i, column.size() ? column[i] : 0.0f);
  }
  return SHD_OK;
}

}  // namespace

extern "C" {

shd_result shd_mesh_create(shd_context* context, const shd_mesh_desc* desc, shd_mesh** out_mesh) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_not_null("out_mesh", out_mesh));
    *out_mesh = nullptr;
    SHD_TRY(check_context(context));
    shd_mesh_desc read = shd_mesh_desc_default();
    SHD_TRY(read_desc("mesh", desc, false, &read));
    SHD_TRY(check_mesh_desc(read));
    core::Context& owner = context_of(context);
    geometry::Mesh mesh{};
    geometry::build(owner, read, &mesh);
    make_handle(owner, kMeshType, core::create<geometry::Mesh>(owner.allocator, std::move(mesh)), out_mesh);
    return SHD_OK;
  });
}

void shd_mesh_retain(shd_mesh* mesh) {
  retain_handle(mesh, kMeshType);
}

void shd_mesh_release(shd_mesh* mesh) {
  release_handle(mesh, kMeshType);
}

shd_result shd_mesh_get_info(const shd_mesh* mesh, shd_mesh_info* out_info) {
  return guard([&]() -> shd_result {
    SHD_TRY(begin_output("out_info", out_info));
    const geometry::Mesh* body = nullptr;
    SHD_TRY(read_handle("mesh", mesh, kMeshType, &body));
    write_desc(body->info, out_info);
    return SHD_OK;
  });
}

shd_result shd_mesh_read_normals(const shd_mesh* mesh, const shd_f32_out* out) {
  return guard([&] {
    return read_columns(mesh, out, 3, [](const geometry::Mesh& body, const Column** columns) {
      columns[0] = &body.nx, columns[1] = &body.ny, columns[2] = &body.nz;
    });
  });
}

shd_result shd_mesh_read_positions(const shd_mesh* mesh, const shd_f32_out* out) {
  return guard([&] {
    return read_columns(mesh, out, 3, [](const geometry::Mesh& body, const Column** columns) {
      columns[0] = &body.px, columns[1] = &body.py, columns[2] = &body.pz;
    });
  });
}

shd_result shd_mesh_read_uv(const shd_mesh* mesh, const shd_f32_out* out) {
  return guard([&] {
    return read_columns(mesh, out, 2, [](const geometry::Mesh& body, const Column** columns) {
      columns[0] = &body.u, columns[1] = &body.v;
    });
  });
}

shd_result shd_mesh_read_tangents(const shd_mesh* mesh, const shd_f32_out* out) {
  return guard([&] {
    return read_columns(mesh, out, 4, [](const geometry::Mesh& body, const Column** columns) {
      columns[0] = &body.tx, columns[1] = &body.ty, columns[2] = &body.tz, columns[3] = &body.tw;
    });
  });
}

shd_result shd_mesh_read_uv1(const shd_mesh* mesh, const shd_f32_out* out) {
  return guard([&] {
    return read_columns(mesh, out, 2, [](const geometry::Mesh& body, const Column** columns) {
      columns[0] = &body.u1, columns[1] = &body.v1;
    });
  });
}

shd_result shd_mesh_read_attribute(const shd_mesh* mesh, uint32_t index, const shd_f32_out* out) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_count("index", index, 0, SHD_MAX_ATTRIBUTES - 1));
    return read_columns(
        mesh, out, 1, [&](const geometry::Mesh& body, const Column** columns) { columns[0] = &body.attribute[index]; });
  });
}

shd_result shd_mesh_read_indices(const shd_mesh* mesh, const shd_u32_out* out) {
  return guard([&]() -> shd_result {
    const geometry::Mesh* body = nullptr;
    SHD_TRY(read_handle("mesh", mesh, kMeshType, &body));
    SHD_TRY(check_not_null("out", out));
    SHD_TRY(check_column("out", *out, body->indices.size()));
    if (!out->data) return SHD_OK;
    for (size_t i = 0; i < body->indices.size(); ++i) data::store(*out, i, body->indices[i]);
    return SHD_OK;
  });
}

}  // extern "C"
