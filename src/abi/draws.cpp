// SPDX-License-Identifier: MIT
#include "abi/draws.h"

#include <cstdio>
#include <cstring>

#include "abi/desc.h"
#include "abi/handle.h"

namespace shd::abi {
namespace {

/// Matrices of a draw: its own, or those of its instances.
struct Instances {
  const float* matrices;
  size_t count;
};

shd_result read_draw(const shd_draw* in, frame::Draw* out, Instances* instances) {
  shd_draw draw = shd_draw_default();
  SHD_TRY(read_desc("draw", in, false, &draw));
  SHD_TRY(check_enum("draw.frequency", draw.frequency, 0, SHD_FREQUENCY_FLAT));
  SHD_TRY(check_enum("draw.cull", draw.cull, 0, SHD_CULL_FRONT));
  SHD_TRY(check_enum("draw.compare", draw.compare, 0, SHD_COMPARE_NEVER));
  SHD_TRY(check_flags("draw.flags", draw.flags, SHD_DRAW_KEEP_DEPTH | SHD_DRAW_SAMPLE_SHADING | SHD_DRAW_AFFINE));
  SHD_TRY(check_range("draw.depth_bias", static_cast<double>(draw.depth_bias), -1.0, 1.0));
  SHD_TRY(check_finite("draw.depth_bias_slope", &draw.depth_bias_slope, 1));
  SHD_TRY(check_matrix("draw.object_to_world", draw.object_to_world));
  SHD_TRY(read_handle("draw.mesh", draw.mesh, core::ObjectType::kMesh, &out->mesh));
  out->begin = 0;
  out->end = out->mesh->triangle_count;
  out->material = nullptr;
  if (draw.material) SHD_TRY(read_handle("draw.material", draw.material, core::ObjectType::kMaterial, &out->material));
  SHD_TRY(check_count("draw.instance_count", draw.instance_count, 0, kMaxItems));
  if (draw.instance_count) SHD_TRY(check_not_null("draw.instances", draw.instances));
  SHD_TRY(check_enum("draw.fill", draw.fill, 0, SHD_FILL_LINES));
  SHD_TRY(check_range("draw.fill_width", static_cast<double>(draw.fill_width), 1.0 / 16, 64.0));
  SHD_TRY(check_flags("draw.edges", draw.edges, SHD_EDGE_ALL));
  SHD_TRY(check_range("draw.crease_cosine", static_cast<double>(draw.crease_cosine), -1.0, 1.0));
  if (draw.fill == SHD_FILL_LINES && !out->mesh->has_adjacency) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "draw.mesh: made without SHD_MESH_ADJACENCY");
  }
  *instances = {draw.instances, draw.instance_count};
  out->frequency = draw.frequency;
  out->cull = draw.cull;
  out->depth = {draw.compare, !(draw.flags & SHD_DRAW_KEEP_DEPTH), draw.depth_bias, draw.depth_bias_slope};
  out->depth_falls = draw.compare == SHD_COMPARE_GREATER || draw.compare == SHD_COMPARE_GREATER_EQUAL;
  out->sample_shading = (draw.flags & SHD_DRAW_SAMPLE_SHADING) != 0;
  out->affine = (draw.flags & SHD_DRAW_AFFINE) != 0;
  out->uniforms = draw.uniforms;
  out->outline = {draw.fill, geometry::outline_reach(draw.fill_width), draw.edges, draw.crease_cosine};
  std::memcpy(out->object_to_world, draw.object_to_world, sizeof out->object_to_world);
  return SHD_OK;
}

/// Appends a draw, or its instances as draws of their own. The matrices may lie at any address.
shd_result append_draw(frame::Draw draw, const Instances& instances, core::Buffer<frame::Draw>* out) {
  const size_t count = instances.count ? instances.count : 1;
  if (out->size() + count > kMaxItems) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "draw.instance_count: %zu after %zu in other draws exceed %llu",
                      count, out->size(), static_cast<unsigned long long>(kMaxItems));
  }
  const size_t first = out->size();
  for (size_t i = 0; i < instances.count; ++i) {
    draw.instance = static_cast<uint32_t>(i);
    std::memcpy(draw.object_to_world, instances.matrices + 16 * i, sizeof draw.object_to_world);
    char field[48];
    std::snprintf(field, sizeof field, "draw.instances[%zu]", i);
    SHD_TRY(check_matrix(field, draw.object_to_world));
    out->push_back(draw);
  }
  if (out->size() == first) out->push_back(draw);
  return SHD_OK;
}

}  // namespace

shd_result check_matrix(const char* field, const float m[16]) {
  SHD_TRY(check_finite(field, m, 16));
  if (m[3] != 0.0f || m[7] != 0.0f || m[11] != 0.0f || m[15] != 1.0f) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: the last row is not 0 0 0 1", field);
  }
  return SHD_OK;
}

shd_result in_element(shd_result result, const char* desc, const char* array, size_t index) {
  return result == SHD_OK ? result : core::fail_within(result, "%s.%s[%zu]: ", desc, array, index);
}

shd_result read_draws(const char* desc, const shd_draw* draws, size_t count, core::Buffer<frame::Draw>* out) {
  const auto* bytes = reinterpret_cast<const char*>(draws);
  uint32_t stride = 0;
  if (count) std::memcpy(&stride, bytes, sizeof stride);
  for (size_t i = 0; i < count; ++i) {
    const char* draw = bytes + i * stride;  // a newer header's size need not be a multiple of our alignment
    uint32_t size;
    std::memcpy(&size, draw, sizeof size);
    if (size != stride) {
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s.draws[%zu].struct_size: %u differs from that of draws[0], %u",
                        desc, i, size, stride);
    }
    frame::Draw read = {};
    read.index = static_cast<uint32_t>(i);
    Instances instances = {};
    SHD_TRY(in_element(read_draw(reinterpret_cast<const shd_draw*>(draw), &read, &instances), desc, "draws", i));
    SHD_TRY(in_element(append_draw(read, instances, out), desc, "draws", i));
  }
  return SHD_OK;
}

}  // namespace shd::abi
