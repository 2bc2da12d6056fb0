// SPDX-License-Identifier: MIT
#include "embree/tree.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include "core/fork.h"
#include "extension/error.h"

namespace shd::embree {
namespace {

using extension::refuse;
using extension::require;

/// Calls of Embree, except those that trace, which take no lock.
core::ForkGate g_build(core::ForkLevel::kTree);

const char* name_of(RTCError error) {
  switch (error) {
    case RTC_ERROR_OUT_OF_MEMORY: return "out of memory";
    case RTC_ERROR_UNSUPPORTED_CPU: return "unsupported processor";
    case RTC_ERROR_INVALID_ARGUMENT: return "invalid argument";
    case RTC_ERROR_INVALID_OPERATION: return "invalid operation";
    case RTC_ERROR_CANCELLED: return "cancelled";
    default: return "unknown error";
  }
}

/// Throws the error of a device, if it has one.
void check(RTCDevice device) {
  const RTCError error = rtcGetDeviceError(device);
  if (error == RTC_ERROR_NONE) return;
  const shd_result result = error == RTC_ERROR_OUT_OF_MEMORY ? SHD_ERROR_OUT_OF_MEMORY : SHD_ERROR_INTERNAL;
  refuse(result, "embree: %s", name_of(error));
}

bool is_finite(const float* position) {
  return std::isfinite(position[0]) && std::isfinite(position[1]) && std::isfinite(position[2]);
}

}  // namespace

struct Tree::Body {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  ~Body() {
    const core::ForkGate::Scope inside(g_build);
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }
};

Triangles read_triangles(const shd_mesh* mesh) {
  shd_mesh_info info = shd_mesh_info_default();
  require(shd_mesh_get_info(mesh, &info));
  Triangles out;
  out.position.resize(size_t{3} * info.vertex_count);
  std::vector<uint32_t> indices(size_t{3} * info.triangle_count);
  if (indices.empty() || out.position.empty()) return out;
  const shd_f32_out columns[3] = {{&out.position[0], 12}, {&out.position[1], 12}, {&out.position[2], 12}};
  const shd_u32_out index_column = {indices.data(), 0};
  require(shd_mesh_read_positions(mesh, columns));
  require(shd_mesh_read_indices(mesh, &index_column));
  for (size_t i = 0; i < indices.size(); i += 3) {
    bool finite = true;
    for (size_t k = 0; k < 3; ++k) finite &= is_finite(&out.position[size_t{3} * indices[i + k]]);
    if (finite) out.indices.insert(out.indices.end(), indices.begin() + i, indices.begin() + i + 3);
  }
  for (float& value : out.position) value = std::isfinite(value) ? value : 0.0f;
  return out;
}

Tree::Tree() : body_(std::make_unique<Body>()) {
  g_build.attach();
  const core::ForkGate::Scope inside(g_build);
  body_->device = rtcNewDevice(nullptr);
  check(body_->device);
  if (!body_->device) refuse(SHD_ERROR_INTERNAL, "embree: no device");
  body_->scene = rtcNewScene(body_->device);
  check(body_->device);
  // With the robust flag no box is missed by rounding, so the answer for a ray is that of its triangles alone.
  rtcSetSceneFlags(body_->scene, RTC_SCENE_FLAG_ROBUST);
}

Tree::~Tree() = default;

void Tree::add(const Triangles& triangles, const float object_to_world[16]) {
  const size_t vertices = triangles.position.size() / 3, count = triangles.indices.size() / 3;
  if (count == 0) return;
  const core::ForkGate::Scope inside(g_build);
  const RTCGeometry geometry = rtcNewGeometry(body_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* position = static_cast<float*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), vertices));
  auto* index = static_cast<uint32_t*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(uint32_t), count));
  if (position && index) {
    for (size_t i = 0; i < vertices; ++i) {
      for (size_t r = 0; r < 3; ++r) {
        double sum = static_cast<double>(object_to_world[12 + r]);
        for (size_t c = 0; c < 3; ++c) {
          sum += static_cast<double>(object_to_world[4 * c + r]) * static_cast<double>(triangles.position[3 * i + c]);
        }
        position[3 * i + r] = static_cast<float>(sum);
      }
    }
    std::copy(triangles.indices.begin(), triangles.indices.end(), index);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(body_->scene, geometry);
  }
  rtcReleaseGeometry(geometry);
  check(body_->device);
}

void Tree::build() {
  const core::ForkGate::Scope inside(g_build);
  rtcCommitScene(body_->scene);
  check(body_->device);
}

void Tree::trace(const shd_rays& rays, uint32_t* blocked) const {
#if RTC_VERSION_MAJOR < 4
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
#endif
  for (size_t i = 0; i < rays.count; ++i) {
    RTCRay ray = {};
    ray.org_x = rays.ox[i];
    ray.org_y = rays.oy[i];
    ray.org_z = rays.oz[i];
    ray.dir_x = rays.dx[i];
    ray.dir_y = rays.dy[i];
    ray.dir_z = rays.dz[i];
    ray.tfar = rays.length[i] < FLT_MAX ? rays.length[i] : std::numeric_limits<float>::infinity();
    ray.mask = 0xffffffffu;
#if RTC_VERSION_MAJOR < 4
    rtcOccluded1(body_->scene, &context, &ray);
#else
    rtcOccluded1(body_->scene, &ray, nullptr);
#endif
    blocked[i] = ray.tfar < 0.0f;
  }
}

}  // namespace shd::embree
