// SPDX-License-Identifier: MIT
#include <shd/embree.h>

#include <cmath>
#include <cstring>
#include <memory>

#include "embree/tree.h"
#include "extension/desc.h"
#include "extension/guard.h"

namespace {

using namespace shd;
using namespace shd::extension;

constexpr uint32_t kEmbreeType = 0x454d4252;  // 'EMBR'
constexpr uint64_t kMaxDraws = uint64_t{1} << 20;

using embree::Tree;

shd_object* object_of(const shd_embree* handle) {
  return reinterpret_cast<shd_object*>(const_cast<shd_embree*>(handle));
}

/// Throws Failure unless a matrix is finite and affine.
void check_matrix(size_t draw, const float* m) {
  for (int i = 0; i < 16; ++i) {
    if (!std::isfinite(m[i])) {
      refuse(SHD_ERROR_INVALID_ARGUMENT, "embree.draws[%zu]: element %d of a matrix is %g, not finite", draw, i,
             static_cast<double>(m[i]));
    }
  }
  if (m[3] != 0.0f || m[7] != 0.0f || m[11] != 0.0f || m[15] != 1.0f) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "embree.draws[%zu]: the last row of a matrix is not 0 0 0 1", draw);
  }
}

/// Adds a draw with its instances. Returns their number.
size_t add_draw(size_t index, const shd_draw& draw, uint64_t room, Tree* tree) {
  const embree::Triangles triangles = embree::read_triangles(draw.mesh);
  if (draw.instance_count > room) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "embree.draws[%zu].instance_count: %zu, but all draws have at most 2^20", index,
           draw.instance_count);
  }
  if (draw.instance_count == 0) {
    check_matrix(index, draw.object_to_world);
    tree->add(triangles, draw.object_to_world);
    return 1;
  }
  if (!draw.instances) refuse(SHD_ERROR_INVALID_ARGUMENT, "embree.draws[%zu].instances: NULL", index);
  for (size_t i = 0; i < draw.instance_count; ++i) {
    check_matrix(index, draw.instances + 16 * i);
    tree->add(triangles, draw.instances + 16 * i);
  }
  return draw.instance_count;
}

/// The draws lie struct_size bytes apart, as the caller's header laid them out.
void add_draws(const shd_draw* draws, size_t count, Tree* tree) {
  const auto* bytes = reinterpret_cast<const char*>(draws);
  uint32_t stride = 0;
  if (count) std::memcpy(&stride, bytes, sizeof stride);
  uint64_t done = 0;
  for (size_t i = 0; i < count; ++i) {
    const auto* in = reinterpret_cast<const shd_draw*>(bytes + i * stride);
    uint32_t size;
    std::memcpy(&size, in, sizeof size);
    if (size != stride) {
      refuse(SHD_ERROR_INVALID_ARGUMENT, "embree.draws[%zu].struct_size: %u differs from that of draws[0], %u", i, size,
             stride);
    }
    shd_draw draw = shd_draw_default();
    read_desc("draw", in, &draw);
    if (!draw.mesh) refuse(SHD_ERROR_INVALID_ARGUMENT, "embree.draws[%zu].mesh: NULL", i);
    done += add_draw(i, draw, kMaxDraws - done, tree);
  }
}

void trace(const shd_rays* rays, uint32_t* blocked, void* user_data) {
  static_cast<const Tree*>(user_data)->trace(*rays, blocked);
}

}  // namespace

extern "C" {

shd_result shd_embree_create(shd_context* context, const shd_draw* draws, size_t draw_count, shd_embree** out_embree) {
  return guard([&]() -> shd_result {
    if (!out_embree) refuse(SHD_ERROR_INVALID_ARGUMENT, "out_embree: NULL");
    *out_embree = nullptr;
    require_context(context);
    if (draw_count > kMaxDraws) {
      refuse(SHD_ERROR_INVALID_ARGUMENT, "embree.draw_count: %zu is not in 0..%llu", draw_count,
             static_cast<unsigned long long>(kMaxDraws));
    }
    if (draw_count && !draws) refuse(SHD_ERROR_INVALID_ARGUMENT, "embree.draws: NULL");
    auto tree = std::make_unique<Tree>();
    add_draws(draws, draw_count, tree.get());
    tree->build();
    const auto destroy = [](void* memory) { delete static_cast<Tree*>(memory); };
    shd_object* object = nullptr;
    require(shd_object_create(context, kEmbreeType, tree.get(), destroy, &object));
    (void)tree.release();
    *out_embree = reinterpret_cast<shd_embree*>(object);
    return SHD_OK;
  });
}

void shd_embree_retain(shd_embree* embree) {
  shd_object_retain(object_of(embree), kEmbreeType);
}

void shd_embree_release(shd_embree* embree) {
  shd_object_release(object_of(embree), kEmbreeType);
}

shd_result shd_embree_get_tracer(const shd_embree* embree, shd_tracer* out_tracer) {
  return guard([&]() -> shd_result {
    if (!out_tracer) refuse(SHD_ERROR_INVALID_ARGUMENT, "out_tracer: NULL");
    *out_tracer = shd_tracer{nullptr, nullptr};
    if (!embree) refuse(SHD_ERROR_INVALID_ARGUMENT, "embree: NULL");
    void* tree = shd_object_get_body(object_of(embree), kEmbreeType);
    if (!tree) throw Failure(SHD_ERROR_INVALID_ARGUMENT, shd_last_error());
    *out_tracer = shd_tracer{trace, tree};
    return SHD_OK;
  });
}

}  // extern "C"
