// SPDX-License-Identifier: MIT
#include "occlusion/atlas.h"

#include "film/framebuffer.h"
#include "material/material.h"

namespace shd::occlusion {
namespace {

/// A view at the origin, which vertices without a program do not depend on.
shd_view any_view() {
  shd_view view = {};
  for (int i = 0; i < 16; i += 5) view.world_to_view[i] = view.view_to_clip[i] = 1.0f;
  return view;
}

void add_points(const film::Framebuffer& framebuffer, AtlasPoints* out) {
  for (uint32_t y = 0; y < framebuffer.height; ++y) {
    for (uint32_t x = 0; x < framebuffer.width; ++x) {
      const uint32_t texel = y * framebuffer.width + x;
      if (!out->bake.texels[texel]) continue;
      const size_t at = y * framebuffer.stride + x;
      out->texel.push_back(texel);
      for (uint32_t c = 0; c < 3; ++c) {
        out->position[c].push_back(framebuffer.plane[SHD_PLANE_PX + c][at]);
        out->normal[c].push_back(framebuffer.plane[SHD_PLANE_NX + c][at]);
      }
    }
  }
}

}  // namespace

void find_points(const core::Context& context, const AtlasSize& size, frame::Draw* draws, size_t draw_count,
                 AtlasPoints* out) {
  shd_material_desc desc = shd_material_desc_default();
  desc.model = SHD_MODEL_UNLIT;
  const material::SlotInput slots[material::kSlotCount] = {};
  material::Material material;
  material::build(desc, slots, &material);
  for (size_t i = 0; i < draw_count; ++i) {
    draws[i].material = &material;
    draws[i].frequency = SHD_FREQUENCY_PHONG;
    draws[i].depth = {SHD_COMPARE_LESS, true, 0.0f, 0.0f};
  }
  film::Framebuffer framebuffer{};
  shd_framebuffer_desc planes = shd_framebuffer_desc_default();
  planes.width = size.width;
  planes.height = size.height;
  planes.aovs = SHD_AOV_POSITION | SHD_AOV_NORMAL;
  film::build(context, planes, &framebuffer);
  frame::Frame frame = {};
  frame.framebuffer = &framebuffer;
  frame.view = any_view();
  frame.draws = draws;
  frame.draw_count = draw_count;
  out->bake.uv_set = size.uv_set;
  frame::bake(context, frame, &out->bake, &out->stats);
  out->texel.attach(context.allocator);
  for (int c = 0; c < 3; ++c) {
    out->position[c].attach(context.allocator);
    out->normal[c].attach(context.allocator);
  }
  add_points(framebuffer, out);
}

}  // namespace shd::occlusion
