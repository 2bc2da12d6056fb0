// SPDX-License-Identifier: MIT
#include "tool/draws.h"

#include <algorithm>
#include <cmath>

#include "command/failure.h"

namespace {

/// Tessellates the mesh of an instance into triangles of a few pixels and displaces them by the heights.
Mesh displace(shd_context* context, const Options& options, const Camera& camera, const Instance& instance,
              const shd_mesh* mesh, const shd_texture* height) {
  shd_tessellation_desc desc = shd_tessellation_desc_default();
  desc.mode = SHD_TESSELLATION_MODE_ADAPTIVE;
  desc.max_segments = 512;
  desc.edge_length = options.edge_length;
  desc.picture_width = options.width;
  desc.picture_height = options.height;
  desc.view = camera.view;
  std::copy_n(instance.object_to_world.data(), 16, desc.object_to_world);
  desc.displacement = height;
  desc.amplitude = options.displacement;
  desc.lod = 2.0f;  // mean of several texels, because single texels are smaller than the triangles
  Mesh displaced;
  check(shd_mesh_tessellate(context, mesh, &desc, displaced.out()), "displacement");
  return displaced;
}

/// Adds lines on top of the surfaces, whose depth is biased away from them.
void add_lines(const Options& options, const Material& ink, Draws& out) {
  for (size_t i = 0; i < out.solid_count; ++i) {
    shd_draw line = out.draws[i];
    out.draws[i].depth_bias = 1e-5f;
    out.draws[i].depth_bias_slope = 0.5f * options.line_width + 1.0f;
    line.material = ink.get();
    line.fill = SHD_FILL_LINES;
    line.fill_width = options.line_width;
    line.edges = SHD_EDGE_SILHOUETTE | SHD_EDGE_CREASE | SHD_EDGE_BORDER;
    line.crease_cosine = std::cos(options.crease * 3.14159265f / 180.0f);
    line.compare = SHD_COMPARE_LESS_EQUAL;
    out.draws.push_back(line);
    out.instance.push_back(out.instance[i]);
  }
}

}  // namespace

Paint make_paint(shd_context* context, const Options& options, const Model& model, const shd_slot& uv) {
  Paint paint;
  paint.extras = make_extras(context, options, uv);
  const shd_model reflectance = model_of(options, model);
  for (const Surface& surface : model.surfaces) {
    shd_slot& diffuse = paint.diffuse.emplace_back();
    paint.materials.push_back(
        make_material(context, options, reflectance, surface, paint.extras, paint.samplers, diffuse));
  }
  shd_material_desc ink = shd_material_desc_default();
  ink.model = SHD_MODEL_UNLIT;
  for (float& c : ink.diffuse) c = 0.01f;
  check(shd_material_create(context, &ink, paint.ink.out()), "ink");
  return paint;
}

Draws make_draws(shd_context* context, const Options& options, const Model& model, const Paint& paint,
                 const Camera& camera) {
  Draws out;
  for (const Instance& instance : model.instances) {
    shd_draw draw = shd_draw_default();
    draw.mesh = model.geometries[instance.geometry].mesh;
    if (!draw.mesh) continue;  // the extent of a volume
    if (options.displacement != 0.0f && !model.surfaces[instance.surface].is_floor) {
      out.displaced.push_back(displace(context, options, camera, instance, draw.mesh, paint.extras.height.get()));
      draw.mesh = out.displaced.back().get();
    }
    draw.material = paint.materials[instance.surface].get();
    draw.frequency = options.frequency;
    draw.cull = instance.cull;
    if (options.sample_shading) draw.flags |= SHD_DRAW_SAMPLE_SHADING;
    if (options.affine) draw.flags |= SHD_DRAW_AFFINE;
    if (options.wire_width > 0.0f) {
      draw.fill = SHD_FILL_WIREFRAME;
      draw.fill_width = options.wire_width;
    }
    std::copy(instance.object_to_world.begin(), instance.object_to_world.end(), draw.object_to_world);
    out.draws.push_back(draw);
    out.instance.push_back(static_cast<size_t>(&instance - model.instances.data()));
  }
  out.solid_count = out.draws.size();
  if (options.line_width > 0.0f) add_lines(options, paint.ink, out);
  return out;
}
