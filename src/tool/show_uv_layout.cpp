// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "command/failure.h"
#include "tool/show.h"

namespace {

/// Triangles in texture space.
struct Layout {
  shd_slot slot = shd_slot_default();  // slot of their texture; no texture = all triangles
  std::vector<float> uv;               // [vertex][2]
  std::vector<uint32_t> indices;       // [triangle][3]
};

void add_triangles(const Geometry& geometry, Layout& layout) {
  const size_t before = layout.uv.size(), count = geometry.position.size() / 3;
  layout.uv.resize(before + 2 * count);
  float* const uv = layout.uv.data() + before;
  const shd_f32_out columns[2] = {{uv, 2 * sizeof(float)}, {uv + 1, 2 * sizeof(float)}};
  const bool second = layout.slot.uv_set == 1;
  check(second ? shd_mesh_read_uv1(geometry.mesh, columns) : shd_mesh_read_uv(geometry.mesh, columns), "mesh");
  const float* const t = layout.slot.uv_transform;
  for (size_t i = 0; i < count; ++i) {
    const float u = uv[2 * i], v = uv[2 * i + 1];
    uv[2 * i] = t[0] * u + t[1] * v + t[2];
    uv[2 * i + 1] = t[3] * u + t[4] * v + t[5];
  }
  for (const uint32_t index : geometry.indices) layout.indices.push_back(static_cast<uint32_t>(before / 2) + index);
}

/// The triangles of the first texture of the model, or all without a texture. The floor has none of its own.
Layout make_layout(const Stage& stage) {
  Layout layout;
  const Model& model = stage.model;
  std::vector<const shd_texture*> others;
  for (const shd_slot& slot : stage.paint.diffuse) {
    if (slot.texture && !layout.slot.texture) layout.slot = slot;
    const bool is_new = slot.texture && slot.texture != layout.slot.texture &&
                        std::find(others.begin(), others.end(), slot.texture) == others.end();
    if (is_new) others.push_back(slot.texture);
  }
  std::vector<size_t> added;
  for (const Instance& instance : model.instances) {
    const bool has = std::find(added.begin(), added.end(), instance.geometry) != added.end();
    const bool is_other = stage.paint.diffuse[instance.surface].texture != layout.slot.texture;
    if (has || is_other || model.surfaces[instance.surface].is_floor) continue;
    added.push_back(instance.geometry);
    add_triangles(model.geometries[instance.geometry], layout);
  }
  if (!others.empty()) {
    std::fprintf(stderr, "shd-render: --show uv-layout shows one texture of %zu\n", others.size() + 1);
  }
  return layout;
}

/// Where texture space is in the picture: x = left + scale_x u, y = top + scale_y v, in pixels.
struct Placement {
  float low[2] = {0, 0}, high[2] = {1, 1};  // the part that is shown
  float left, top, scale_x, scale_y;
};

Placement place_layout(const Options& options, const Layout& layout) {
  Placement place = {};
  for (int c = 0; c < 2; ++c) place.low[c] = 0.0f, place.high[c] = 1.0f;
  for (const uint32_t index : layout.indices) {
    for (size_t c = 0; c < 2; ++c) {
      const float value = std::clamp(layout.uv[2 * index + c], -1e4f, 1e4f);
      place.low[c] = std::min(place.low[c], value);
      place.high[c] = std::max(place.high[c], value);
    }
  }
  float aspect = 1.0f;  // aspect of the unit square
  if (layout.slot.texture) {
    shd_texture_info info = shd_texture_info_default();
    check(shd_texture_get_info(layout.slot.texture, &info), "texture");
    aspect = static_cast<float>(info.width) / static_cast<float>(info.height);
  }
  const auto width = static_cast<float>(options.width), height = static_cast<float>(options.height);
  const float size_u = place.high[0] - place.low[0], size_v = place.high[1] - place.low[1];
  place.scale_y = 0.94f * std::min(width / (aspect * size_u), height / size_v);
  place.scale_x = aspect * place.scale_y;
  place.left = 0.5f * (width - place.scale_x * (place.low[0] + place.high[0]));
  place.top = 0.5f * (height - place.scale_y * (place.low[1] + place.high[1]));
  return place;
}

/// A mesh whose positions are texture coordinates, in normalised device coordinates.
Mesh make_flat_mesh(const Stage& stage, const Placement& place, const std::vector<float>& uv,
                    const std::vector<uint32_t>& indices) {
  const auto width = static_cast<float>(stage.options.width), height = static_cast<float>(stage.options.height);
  std::vector<float> position(uv.size() / 2 * 3, 0.5f);
  for (size_t i = 0; i < uv.size() / 2; ++i) {
    position[3 * i] = 2.0f * (place.left + place.scale_x * uv[2 * i]) / width - 1.0f;
    position[3 * i + 1] = 1.0f - 2.0f * (place.top + place.scale_y * uv[2 * i + 1]) / height;
  }
  shd_mesh_desc desc = shd_mesh_desc_default();
  desc.vertex_count = uv.size() / 2;
  for (size_t c = 0; c < 3; ++c) desc.position[c] = {position.data() + c, 3 * sizeof(float)};
  for (size_t c = 0; c < 2; ++c) desc.uv[c] = {uv.data() + c, 2 * sizeof(float)};
  desc.indices.data = indices.data();
  desc.index_count = indices.size();
  desc.flags = SHD_MESH_KEEP_NONFINITE;
  Mesh mesh;
  check(shd_mesh_create(stage.context, &desc, mesh.out()), "--show uv-layout");
  return mesh;
}

Material make_flat(const Stage& stage, const shd_slot& slot, const Rgb& color) {
  shd_slot own = slot;  // the coordinates are transformed
  std::copy_n(shd_slot_default().uv_transform, 6, own.uv_transform);
  own.uv_set = 0;
  shd_material_desc desc = shd_material_desc_default();
  desc.model = SHD_MODEL_UNLIT;
  std::copy(color.begin(), color.end(), desc.diffuse);
  desc.slots = &own;
  desc.slot_count = own.texture ? 1 : 0;
  Material material;
  check(shd_material_create(stage.context, &desc, material.out()), "--show uv-layout");
  return material;
}

shd_draw make_flat_draw(const Mesh& mesh, const Material& material, shd_fill fill, float width) {
  shd_draw draw = shd_draw_default();
  draw.mesh = mesh.get();
  draw.material = material.get();
  draw.compare = SHD_COMPARE_ALWAYS;
  draw.fill = fill;
  draw.fill_width = width;
  return draw;
}

}  // namespace

Picture show_uv_layout(const Stage& stage, const Frame&) {
  const Layout layout = make_layout(stage);
  const Placement place = place_layout(stage.options, layout);
  const float *low = place.low, *high = place.high;
  const Mesh sheet = make_flat_mesh(stage, place, {low[0], low[1], high[0], low[1], high[0], high[1], low[0], high[1]},
                                    {0, 1, 2, 0, 2, 3});
  const Mesh triangles = make_flat_mesh(stage, place, layout.uv, layout.indices);
  const Material dim = make_flat(stage, layout.slot, {0.3f, 0.3f, 0.3f});
  const Material full = make_flat(stage, layout.slot, {1, 1, 1}),
                 gray = make_flat(stage, layout.slot, {0.6f, 0.6f, 0.6f});
  const Material ink = make_flat(stage, shd_slot_default(), {1.0f, 0.35f, 0.0f});
  const shd_draw draws[] = {make_flat_draw(sheet, dim, SHD_FILL_SOLID, 1),
                            make_flat_draw(triangles, layout.slot.texture ? full : gray, SHD_FILL_SOLID, 1),
                            make_flat_draw(triangles, ink, SHD_FILL_WIREFRAME, 1),
                            make_flat_draw(triangles, ink, SHD_FILL_POINTS, 3)};
  shd_render_desc desc = shd_render_desc_default();
  desc.framebuffer = stage.framebuffer.get();
  desc.draws = draws;
  desc.draw_count = std::size(draws);
  for (size_t c = 0; c < 4; ++c) desc.clear_color[c] = stage.options.background[c];
  check(shd_render(stage.context, &desc), "--show uv-layout");
  Picture picture = read_picture(stage.framebuffer.get());
  const float x0 = place.left, x1 = x0 + place.scale_x, y0 = place.top, y1 = y0 + place.scale_y;
  paint_stroke(picture, {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}, {x0, y0}}, 2.0f, {1, 1, 1});
  return picture;
}
