// SPDX-License-Identifier: MIT
#include "film/framebuffer.h"

#include <algorithm>
#include <utility>

namespace shd::film {
namespace {

constexpr size_t kRowMultiple = core::kAlignment / sizeof(float);

bool wants_plane(uint32_t aovs, shd_plane plane) {
  switch (plane) {
    case SHD_PLANE_R:
    case SHD_PLANE_G:
    case SHD_PLANE_B:
    case SHD_PLANE_A:
    case SHD_PLANE_DEPTH: return true;
    case SHD_PLANE_U:
    case SHD_PLANE_V: return (aovs & SHD_AOV_UV) != 0;
    case SHD_PLANE_NX:
    case SHD_PLANE_NY:
    case SHD_PLANE_NZ: return (aovs & SHD_AOV_NORMAL) != 0;
    case SHD_PLANE_TRIANGLE: return (aovs & SHD_AOV_TRIANGLE) != 0;
    default: return false;
  }
}

}  // namespace

void build(const core::Context& context, const shd_framebuffer_desc& desc, Framebuffer* out) {
  Framebuffer framebuffer{};
  framebuffer.width = desc.width;
  framebuffer.height = desc.height;
  framebuffer.samples = desc.samples;
  framebuffer.aovs = desc.aovs;
  framebuffer.stride = (desc.width + kRowMultiple - 1) / kRowMultiple * kRowMultiple;
  const size_t count = core::checked_mul(framebuffer.stride, desc.height);
  for (uint32_t p = 0; p < kFloatPlanes; ++p) {
    if (!wants_plane(desc.aovs, static_cast<shd_plane>(p))) continue;
    core::Array<float>& plane = framebuffer.plane[p];
    plane = core::Array<float>(context.allocator, count);
    std::fill(plane.begin(), plane.end(), p == SHD_PLANE_DEPTH ? 1.0f : 0.0f);
  }
  if (wants_plane(desc.aovs, SHD_PLANE_TRIANGLE)) {
    framebuffer.triangle = core::Array<uint32_t>(context.allocator, count);
    std::fill(framebuffer.triangle.begin(), framebuffer.triangle.end(), kNoTriangle);
  }
  *out = std::move(framebuffer);
}

bool has_plane(const Framebuffer& framebuffer, shd_plane plane) {
  return wants_plane(framebuffer.aovs, plane);
}

size_t byte_size(const Framebuffer& framebuffer) {
  size_t bytes = framebuffer.triangle.size() * sizeof(uint32_t);
  for (const core::Array<float>& plane : framebuffer.plane) bytes += plane.size() * sizeof(float);
  return bytes;
}

}  // namespace shd::film
