// SPDX-License-Identifier: MIT
#include "film/framebuffer.h"

#include <algorithm>
#include <utility>

#include "shade/columns.h"

namespace shd::film {
namespace {

constexpr size_t kRowMultiple = core::kAlignment / sizeof(float);
constexpr size_t kLargeBytes = size_t{4} << 20;  // more than the second caches of most processors

template <class T>
void build_plane(const core::Allocator& allocator, size_t count, double empty, core::Array<T>* out) {
  *out = core::Array<T>(allocator, count);
  std::fill(out->begin(), out->end(), static_cast<T>(empty));
}

}  // namespace

void build(const core::Context& context, const shd_framebuffer_desc& desc, Framebuffer* out) {
  Framebuffer framebuffer{};
  framebuffer.width = desc.width;
  framebuffer.height = desc.height;
  framebuffer.color_format = desc.color_format;
  framebuffer.samples = desc.sample_count;
  framebuffer.aovs = desc.aovs;
  framebuffer.stride = (desc.width + kRowMultiple - 1) / kRowMultiple * kRowMultiple;
  const size_t count = core::checked_mul(framebuffer.stride, desc.height);
  for (uint32_t p = 0; p < kPlaneCount; ++p) {
    if (!has_plane(framebuffer, p)) continue;
    if (kPlanes[p].is_integer) {
      build_plane(context.allocator, count, kPlanes[p].empty, &framebuffer.u32_plane[p]);
    } else {
      build_plane(context.allocator, count, kPlanes[p].empty, &framebuffer.plane[p]);
    }
  }
  if (!has_color_planes(framebuffer)) {
    build_plane(context.allocator, core::checked_mul(count, shd_format_size(desc.color_format)), 0.0,
                &framebuffer.pixels);
  }
  framebuffer.is_large = byte_size(framebuffer) > kLargeBytes;
  *out = std::move(framebuffer);
}

uint8_t* pixel_at(Framebuffer* framebuffer, size_t x, size_t y) {
  return framebuffer->pixels.data() + (y * framebuffer->stride + x) * shd_format_size(framebuffer->color_format);
}

const uint8_t* pixel_at(const Framebuffer& framebuffer, size_t x, size_t y) {
  return framebuffer.pixels.data() + (y * framebuffer.stride + x) * shd_format_size(framebuffer.color_format);
}

bool has_plane(const Framebuffer& framebuffer, uint32_t plane) {
  return wants_plane(framebuffer.aovs, plane) && (plane >= SHD_PLANE_DEPTH || has_color_planes(framebuffer));
}

uint32_t targets_of(const Framebuffer& framebuffer) {
  uint32_t targets = 1;
  for (uint32_t t = 1; t < shade::kMaxTargets; ++t) {
    if (wants_plane(framebuffer.aovs, target_plane(t))) targets |= 1u << t;
  }
  return targets;
}

size_t byte_size(const Framebuffer& framebuffer) {
  size_t bytes = 0;
  for (const core::Array<float>& plane : framebuffer.plane) bytes += plane.size() * sizeof(float);
  for (const core::Array<uint32_t>& plane : framebuffer.u32_plane) bytes += plane.size() * sizeof(uint32_t);
  bytes += framebuffer.pixels.size();
  return bytes;
}

}  // namespace shd::film
