// SPDX-License-Identifier: MIT
#include <shd/occlusion.h>

#include <cmath>

#include "abi/bake.h"
#include "abi/batch.h"
#include "abi/desc.h"
#include "abi/draws.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "core/scratch.h"
#include "data/column.h"
#include "film/dilate.h"
#include "occlusion/atlas.h"
#include "occlusion/depth_maps.h"
#include "occlusion/trace.h"

namespace {

using namespace shd;
using namespace shd::abi;

constexpr uint32_t kMaxRays = 65536, kMaxSize = 16384, kMaxDilation = 1024;

/// A checked shd_occlusion_desc.
struct Query {
  occlusion::Options options;
  core::Buffer<frame::Draw> occluders;
};

shd_result read_query(const core::Context& context, const shd_occlusion_desc& desc, Query* out) {
  SHD_TRY(check_count("occlusion.ray_count", desc.ray_count, 1, kMaxRays));
  if (!(desc.radius > 0.0f)) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "occlusion.radius: %g is not above 0",
                      static_cast<double>(desc.radius));
  }
  SHD_TRY(check_range("occlusion.bias", static_cast<double>(desc.bias), 0.0, 1e9));
  SHD_TRY(check_count("occlusion.map_size", desc.map_size, 16, 8192));
  out->options = {static_cast<uint32_t>(desc.ray_count), desc.seed, desc.radius, desc.bias, desc.map_size, desc.tracer};
  out->occluders.attach(context.allocator);
  if (desc.tracer.trace) return SHD_OK;
  SHD_TRY(check_count("occlusion.draw_count", desc.draw_count, 0, kMaxItems));
  if (desc.draw_count) SHD_TRY(check_not_null("occlusion.draws", desc.draws));
  return read_draws("occlusion", desc.draws, desc.draw_count, &out->occluders);
}

void compute(const core::Context& context, const Query& query, const occlusion::Points& points) {
  if (query.options.tracer.trace) {
    occlusion::trace(context, query.options, points);
  } else {
    occlusion::sum_depth_maps(context, query.options, query.occluders.data(), query.occluders.size(), points);
  }
}

/// Packed columns of positions, normals and values.
struct PointColumns {
  core::Array<float> position[3], normal[3], value;

  PointColumns(const core::Allocator& allocator, size_t count) : value(allocator, count) {
    for (int c = 0; c < 3; ++c) {
      position[c] = core::Array<float>(allocator, count);
      normal[c] = core::Array<float>(allocator, count);
    }
  }
  occlusion::Points points() {
    occlusion::Points out = {value.size(), {}, {}, value.data()};
    for (int c = 0; c < 3; ++c) {
      out.position[c] = position[c].data();
      out.normal[c] = normal[c].data();
    }
    return out;
  }
};

void store_values(const core::Array<float>& values, const shd_f32_out& out) {
  for (size_t i = 0; i < values.size(); ++i) data::store(out, i, values[i]);
}

shd_result compute_points(const core::Context& context, const Query& query, const shd_occlusion_points* points,
                          shd_occlusion_values* out) {
  shd_occlusion_points read = shd_occlusion_points_default();
  SHD_TRY(read_desc("points", points, false, &read));
  shd_occlusion_values values = shd_occlusion_values_default();
  SHD_TRY(read_desc("values", out, false, &values));
  Batch<6, 1> batch;
  batch.count = read.count;
  for (int c = 0; c < 3; ++c) {
    batch.in[c] = in_column("points.position", read.position[c], Need::kRequired, c);
    batch.in[3 + c] = in_column("points.normal", read.normal[c], Need::kRequired, c);
  }
  batch.out[0] = out_column("values.visibility", values.visibility, Need::kRequired);
  SHD_TRY(check_batch(batch));
  PointColumns columns(context.allocator, read.count);
  for (size_t i = 0; i < read.count; ++i) {
    for (int c = 0; c < 3; ++c) {
      columns.position[c][i] = data::load(read.position[c], i);
      columns.normal[c][i] = data::load(read.normal[c], i);
    }
  }
  const occlusion::Points own = columns.points();
  compute(context, query, own);
  store_values(columns.value, values.visibility);
  values.nonfinite_count = count_nonfinite(
      Piece<6, 1>{read.count,
                  {own.position[0], own.position[1], own.position[2], own.normal[0], own.normal[1], own.normal[2]},
                  {nullptr}});
  write_desc(values, out);
  return SHD_OK;
}

/// Vertices of a mesh in world space. Arithmetic is in double and rounded once.
void place_vertices(const geometry::Mesh& mesh, const float m[16], PointColumns* out) {
  const shd_view view = {};
  const geometry::Transform transform = geometry::make_transform(view, m, {0, 0, 1, 1}, {0, 0, 0, 0});
  for (size_t i = 0; i < mesh.vertex_count; ++i) {
    const double p[3] = {static_cast<double>(mesh.px[i]), static_cast<double>(mesh.py[i]),
                         static_cast<double>(mesh.pz[i])};
    const double n[3] = {static_cast<double>(mesh.nx[i]), static_cast<double>(mesh.ny[i]),
                         static_cast<double>(mesh.nz[i])};
    for (int r = 0; r < 3; ++r) {
      double position = static_cast<double>(m[12 + r]), normal = 0.0;
      for (int c = 0; c < 3; ++c) {
        position += static_cast<double>(m[4 * c + r]) * p[c];
        normal += static_cast<double>(transform.normal[3 * c + r]) * n[c];
      }
      out->position[r][i] = static_cast<float>(position);
      out->normal[r][i] = static_cast<float>(normal);
    }
  }
}

shd_result compute_vertices(const core::Context& context, const Query& query, const shd_draw* draw,
                            const shd_f32_out* out) {
  shd_draw read = shd_draw_default();
  SHD_TRY(read_desc("draw", draw, false, &read));
  const geometry::Mesh* mesh = nullptr;
  SHD_TRY(read_handle("draw.mesh", read.mesh, core::ObjectType::kMesh, &mesh));
  SHD_TRY(check_matrix("draw.object_to_world", read.object_to_world));
  if (read.instance_count != 0) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT,
                      "draw.instance_count: %zu, but the vertices of one instance are taken", read.instance_count);
  }
  SHD_TRY(check_not_null("out", out));
  if (mesh->vertex_count) SHD_TRY(check_not_null("out.data", out->data));
  SHD_TRY(check_column("out", *out, mesh->vertex_count));
  PointColumns columns(context.allocator, mesh->vertex_count);
  place_vertices(*mesh, read.object_to_world, &columns);
  compute(context, query, columns.points());
  store_values(columns.value, *out);
  return SHD_OK;
}

shd_result check_atlas(const shd_occlusion_atlas& atlas, const shd_f32_out* out) {
  SHD_TRY(check_count("occlusion_atlas.width", atlas.width, 1, kMaxSize));
  SHD_TRY(check_count("occlusion_atlas.height", atlas.height, 1, kMaxSize));
  SHD_TRY(check_count("occlusion_atlas.uv_set", atlas.uv_set, 0, 1));
  SHD_TRY(check_count("occlusion_atlas.dilation", atlas.dilation, 0, kMaxDilation));
  SHD_TRY(check_finite("occlusion_atlas.empty", &atlas.empty, 1));
  SHD_TRY(check_count("occlusion_atlas.draw_count", atlas.draw_count, 0, kMaxItems));
  if (atlas.draw_count) SHD_TRY(check_not_null("occlusion_atlas.draws", atlas.draws));
  SHD_TRY(check_not_null("out", out));
  SHD_TRY(check_not_null("out.data", out->data));
  const uint64_t texels = uint64_t{atlas.width} * atlas.height;
  SHD_TRY(check_column("out", *out, texels));
  return check_states("occlusion_atlas.states", atlas.states, texels);
}

/// Continues values to empty texels, and marks these as dilated.
void dilate_values(const core::Context& context, const shd_occlusion_atlas& atlas, uint8_t* texels,
                   core::Array<float>* values) {
  if (atlas.dilation == 0) return;
  const core::Array<uint32_t> nearest =
      film::nearest_texels(context, atlas.width, atlas.height, atlas.dilation, texels);
  for (size_t i = 0; i < values->size(); ++i) {
    if (nearest[i] == film::kNoTexel) continue;
    (*values)[i] = (*values)[nearest[i]];
    texels[i] = film::kTexelDilated;
  }
}

shd_result bake(const core::Context& context, const Query& query, const shd_occlusion_atlas& atlas,
                const shd_f32_out* out, shd_bake_stats* stats) {
  SHD_TRY(check_atlas(atlas, out));
  core::Buffer<frame::Draw> draws(context.allocator);
  SHD_TRY(read_draws("occlusion_atlas", atlas.draws, atlas.draw_count, &draws));
  occlusion::AtlasPoints found = {};
  occlusion::find_points(context, {atlas.width, atlas.height, atlas.uv_set}, draws.data(), draws.size(), &found);
  core::Array<float> value(context.allocator, found.texel.size());
  occlusion::Points points = {found.texel.size(), {}, {}, value.data()};
  for (int c = 0; c < 3; ++c) {
    points.position[c] = found.position[c].data();
    points.normal[c] = found.normal[c].data();
  }
  compute(context, query, points);
  core::Array<float> values(context.allocator, size_t{atlas.width} * atlas.height);
  for (float& texel : values) texel = atlas.empty;
  for (size_t i = 0; i < value.size(); ++i) values[found.texel[i]] = value[i];
  dilate_values(context, atlas, found.bake.texels.data(), &values);
  store_values(values, *out);
  *stats = finish_bake(found.bake, found.stats, atlas.states);
  return SHD_OK;
}

/// Runs body(context, query) with the memory of one call.
template <class Body>
shd_result with_query(shd_context* context, const shd_occlusion_desc* desc, const Body& body) {
  SHD_TRY(check_context(context));
  shd_occlusion_desc read = shd_occlusion_desc_default();
  SHD_TRY(read_desc("occlusion", desc, true, &read));
  core::ScratchScope scratch(context_of(context));
  Query query = {};
  SHD_TRY(read_query(scratch.context, read, &query));
  return body(scratch.context, query);
}

}  // namespace

extern "C" {

shd_result shd_occlusion_compute(shd_context* context, const shd_occlusion_desc* desc,
                                 const shd_occlusion_points* points, shd_occlusion_values* out) {
  return guard([&] {
    return with_query(context, desc, [&](const core::Context& scratch, const Query& query) {
      return compute_points(scratch, query, points, out);
    });
  });
}

shd_result shd_occlusion_compute_vertices(shd_context* context, const shd_occlusion_desc* desc, const shd_draw* draw,
                                          const shd_f32_out* out) {
  return guard([&] {
    return with_query(context, desc, [&](const core::Context& scratch, const Query& query) {
      return compute_vertices(scratch, query, draw, out);
    });
  });
}

shd_result shd_occlusion_bake(shd_context* context, const shd_occlusion_desc* desc, const shd_occlusion_atlas* atlas,
                              const shd_f32_out* out) {
  shd_bake_stats* wanted = nullptr;
  shd_bake_stats stats = {};
  const shd_result result = guard([&]() -> shd_result {
    shd_occlusion_atlas read = shd_occlusion_atlas_default();
    SHD_TRY(read_desc("occlusion_atlas", atlas, false, &read));
    if (read.stats) SHD_TRY(begin_output("occlusion_atlas.stats", read.stats));
    wanted = read.stats;
    return with_query(context, desc, [&](const core::Context& scratch, const Query& query) {
      return bake(scratch, query, read, out, &stats);
    });
  });
  if (result == SHD_OK && wanted) write_desc(stats, wanted);
  return result;
}

}  // extern "C"
