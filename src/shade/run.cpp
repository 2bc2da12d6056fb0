// SPDX-License-Identifier: MIT
#include "shade/run.h"

#include <algorithm>

#include "data/data.h"
#include "raster/interpolate.h"
#include "shade/combine.h"
#include "shade/cull.h"
#include "shade/frequency.h"
#include "shade/illuminate.h"
#include "shade/modulation.h"
#include "shade/needs.h"
#include "shade/parallax.h"
#include "shade/parameters.h"
#include "shade/program.h"
#include "shade/reflection.h"
#include "shade/surface.h"
#include "shade/surround.h"
#include "shade/tangent_frames.h"

namespace shd::shade {
namespace {

/// Fills the interpolated attributes of fragments whose x, y, pixel, depth and triangle are set.
void complete_fragments(const core::SimdTarget& simd, const DrawShading& shading, const float eye[3], uint32_t wanted,
                        raster::Fragments* f) {
  // Fragments up to the next whole vector repeat the last one.
  for (size_t i = f->count; i < data::padded(f->count); ++i) {
    f->x[i] = f->x[f->count - 1];
    f->y[i] = f->y[f->count - 1];
    f->depth[i] = f->depth[f->count - 1];
    f->triangle[i] = f->triangle[f->count - 1];
    f->pixel[i] = f->pixel[f->count - 1];
  }
  raster::interpolate(simd, *shading.vertices, eye, wanted, f);
}

/// Makes the points of Gouraud or flat shading for each triangle of the batch, and columns.point.
void make_points(const DrawShading& shading, const float eye[3], Workspace* w) {
  const bool flat = shading.frequency == SHD_FREQUENCY_FLAT;
  raster::Fragments& f = w->fragments;
  size_t next = 0;
  for (size_t i = 0; i < f.count; ++i) {
    if (i == 0 || f.triangle[i] != f.triangle[i - 1]) {
      if (flat) {
        set_centroid(*shading.vertices, eye, shading.orientation, f.triangle[i], next, &w->points);
      } else {
        set_corners(*shading.vertices, eye, f.triangle[i], next, &w->points);
      }
      next += flat ? 1 : 3;
    }
    w->columns.point[i] = static_cast<uint32_t>(next - (flat ? 1 : 3));
  }
  for (size_t i = f.count; i < data::padded(f.count); ++i) w->columns.point[i] = w->columns.point[f.count - 1];
  w->points.count = next;
}

/// Interpolates a column of the points to the fragments.
void spread(const core::SimdTarget& simd, const DrawShading& shading, const Workspace& w, const float* in, float* out) {
  if (shading.frequency == SHD_FREQUENCY_FLAT) {
    spread_centroids(w.columns.point, w.fragments.count, in, out);
  } else {
    spread_corners(simd, w.fragments, w.columns.point, in, out);
  }
}

/// Interpolates the normals of the points to the fragments.
void spread_normals(const core::SimdTarget& simd, const DrawShading& shading, Workspace* w) {
  spread(simd, shading, *w, w->points.nx, w->fragments.nx);
  spread(simd, shading, *w, w->points.ny, w->fragments.ny);
  spread(simd, shading, *w, w->points.nz, w->fragments.nz);
}

/// Computes the varyings of the points, for a program or procedures.
void make_varyings(const core::SimdTarget& simd, const DrawShading& shading, Workspace* w) {
  const geometry::Vertices& vertices = *shading.vertices;
  const shd_interpolation* modes = shading.material->interpolation;
  if (vertices.varying_count == 0) return;
  if (shading.frequency == SHD_FREQUENCY_PHONG) {
    raster::interpolate_varyings(simd, vertices, modes, w->fragments, &w->varyings);
  } else if (shading.frequency == SHD_FREQUENCY_FLAT) {
    set_centroid_varyings(vertices, modes, w->points, &w->varyings);
  } else {
    set_corner_varyings(vertices, modes, w->points, &w->varyings);
  }
}

/// Finds the indices of the lights that affect points; returns their count.
size_t find_affecting(const core::SimdTarget& simd, const LightTable& lights, const raster::Fragments& points,
                      bool ignores_irradiance, uint32_t* affecting) {
  if (!ignores_irradiance) return cull_lights(simd, lights, points, affecting);
  for (size_t i = 0; i < lights.count; ++i) affecting[i] = static_cast<uint32_t>(i);
  return lights.count;
}

/// Computes the lobes of points, with at most kModulated lights with a cookie or a shadow per group.
void light_points(const core::SimdTarget& simd, const material::Material& material, const LobeShape& shape,
                  const LightTable& lights, const raster::Fragments& points, Workspace* w, material::Lobes* out) {
  const bool ignores_irradiance = material::info_of(material.model).ignores_irradiance;
  const size_t count = find_affecting(simd, lights, points, ignores_irradiance, w->affecting.data());
  LightGroup group = {false, false};
  for (size_t next = 0; !group.finishes; group.continues = true) {
    size_t taken = 0, modulated = 0;
    for (; next < count; ++next, ++taken) {
      const light::Light& light = lights.lights[w->affecting[next]];
      w->active[taken] = {&light, {nullptr, nullptr, nullptr}};
      const light::Shadow* shadow = lights.any_shadow ? lights.shadows[w->affecting[next]] : nullptr;
      if (ignores_irradiance || !is_modulated(light, shadow)) continue;
      if (modulated == kModulated) break;
      w->active[taken] = modulate(simd, light, shadow, points, modulated++, &w->columns);
    }
    group.finishes = next == count;
    illuminate(simd, material, shape, w->active.data(), taken, points, group, out);
  }
}

/// Whether lobes may be so narrow that the size of pixels matters.
bool reflects_sharply(const material::Material& material) {
  constexpr float kRough = 0.35f, kWide = 60.0f;
  if (material::info_of(material.model).environment_tables & SHD_ENVIRONMENT_TABLE_GGX) {
    const bool has_coat = material.model == material::ModelKey::kClearCoat;
    return material.roughness < kRough || material::has_slot(material, SHD_SLOT_ROUGHNESS) ||
           (has_coat && material.coat_roughness < kRough) || material::has_slot(material, SHD_SLOT_CLEARCOAT_ROUGHNESS);
  }
  return material::info_of(material.model).environment_tables != 0 &&
         (material.exponent > kWide || material::has_slot(material, SHD_SLOT_EXPONENT));
}

/// Adds the light of the environment, computed at the points, to the lobes of the fragments.
void add_environment(const core::SimdTarget& simd, const DrawShading& shading, const LobeShape& shape,
                     const EnvironmentLight& environment, const float eye[3], const material::Parameters& parameters,
                     Workspace* w) {
  const material::Material& material = *shading.material;
  const bool per_fragment = shading.frequency == SHD_FREQUENCY_PHONG;
  Columns& columns = w->columns;
  if (per_fragment) {
    const bool is_sharp = reflects_sharply(material);
    if (is_sharp) find_reflected_variance(*shading.vertices, eye, w->fragments, columns.variance);
    surround(simd, material, shape, environment, w->fragments, &parameters, is_sharp ? columns.variance : nullptr,
             &columns.lobes);
    return;
  }
  surround(simd, material, shape, environment, w->points, nullptr, nullptr, &columns.point_environment);
  for (uint32_t k = 0; k < 3 * material::info_of(material.model).lobes; ++k) {
    spread(simd, shading, *w, columns.point_environment.lobe[k / 3][k % 3], columns.environment.lobe[k / 3][k % 3]);
  }
  add_surroundings(simd, material, parameters, columns.environment, w->fragments.count, &columns.lobes);
}

/// Shades a batch with a reflectance model.
void shade_model(const core::SimdTarget& simd, const DrawShading& shading, const LightTable& lights,
                 const shd_view& view, Workspace* w) {
  const material::Material& material = *shading.material;
  const bool per_fragment = shading.frequency == SHD_FREQUENCY_PHONG;
  Columns& columns = w->columns;
  raster::Fragments& points = per_fragment ? w->fragments : w->points;
  const material::ModelInfo& info = material::info_of(material.model);
  material::Parameters parameters = {};
  clear_targets(w->fragments.count, &columns.radiance);
  make_tangent_bases({shading, points, w->varyings, per_fragment}, &points, &columns);
  if (per_fragment && material.parallax_depth > 0.0f && material::has_slot(material, SHD_SLOT_HEIGHT)) {
    shift_by_heights(simd, {shading, points, w->varyings, true}, &points, &columns);
  }
  LobeShape shape = {};
  if (lights.any_shadow && info.lobes) keep_shadow_normals(points, &columns);
  if (info.has_normal)
    shape = evaluate_surface(simd, {shading, points, w->varyings, per_fragment}, &points, &columns, &parameters);
  if (!per_fragment && (shading.frequency == SHD_FREQUENCY_FLAT || !info.lobes)) spread_normals(simd, shading, w);
  look_up_slots(simd, {shading, w->fragments, w->varyings, true}, ~material::kShapingSlots, &columns, &parameters);
  if (info.lobes) {
    light_points(simd, material, shape, lights, points, w, per_fragment ? &columns.lobes : &columns.point_lobes);
    for (uint32_t k = 0; k < info.lobes && !per_fragment; ++k) {
      for (int c = 0; c < 3; ++c) spread(simd, shading, *w, columns.point_lobes.lobe[k][c], columns.lobes.lobe[k][c]);
    }
    if (lights.environment.map && info.reflects_environment) {
      add_environment(simd, shading, shape, lights.environment, view.eye, parameters, w);
    }
  } else {
    material::show({simd, material, view, w->fragments, shading.object_to_world, columns.uv}, columns.lobes.lobe[0]);
  }
  w->nonfinite = combine(simd, material, lights, columns.lobes, parameters, w->fragments.count, &columns.radiance);
}

/// Shades a batch with a program of the caller.
void shade_program(const core::SimdTarget& simd, const DrawShading& shading, Workspace* w) {
  const material::Material& material = *shading.material;
  const bool per_fragment = shading.frequency == SHD_FREQUENCY_PHONG;
  Columns& columns = w->columns;
  raster::Fragments& points = per_fragment ? w->fragments : w->points;
  if (shading.vertices->tangent.size() == 0) {
    make_tangent_bases({shading, points, w->varyings, per_fragment}, &points, &columns);
  }
  if (material.flags & SHD_MATERIAL_DOUBLE_SIDED && !shading.keeps_sides)
    face_normals(*shading.vertices, shading.orientation, &points);
  uint32_t* discard = per_fragment ? columns.discard : columns.point_discard;
  make_varyings(simd, shading, w);
  run_program(shading, points, w->varyings, discard, per_fragment ? &columns.radiance : &columns.point_radiance);
  if (per_fragment) return;
  if (shading.frequency == SHD_FREQUENCY_FLAT) spread_normals(simd, shading, w);
  if (material.flags & SHD_MATERIAL_DISCARDS) {
    for (size_t i = 0; i < w->fragments.count; ++i) columns.discard[i] = columns.point_discard[columns.point[i]];
  }
  for (uint32_t c = 0; c < 4 * kMaxTargets; ++c) {
    if (!columns.radiance.channel[c]) continue;
    spread(simd, shading, *w, columns.point_radiance.channel[c], columns.radiance.channel[c]);
  }
}

}  // namespace

void allocate(const core::Allocator& allocator, const WorkspaceSize& size, Workspace* out) {
  raster::allocate(allocator, size.varying_count, &out->varyings);
  raster::allocate(allocator, &out->fragments);
  raster::allocate(allocator, &out->points);
  allocate(allocator, size.targets, &out->columns);
  out->affecting = core::Array<uint32_t>(allocator, data::padded(size.light_count));
  out->active = core::Array<ActiveLight>(allocator, data::padded(size.light_count));
}

void shade_points(const core::SimdTarget& simd, const material::Material& material, const LightTable& lights,
                  Workspace* w) {
  Columns& columns = w->columns;
  if (lights.any_shadow) keep_shadow_normals(w->points, &columns);
  light_points(simd, material, {}, lights, w->points, w, &columns.point_lobes);
  material::Parameters parameters = {};
  for (int c = 0; c < 3; ++c) parameters.value[SHD_SLOT_DIFFUSE][c] = columns.slot[SHD_SLOT_DIFFUSE][c];
  combine(simd, material, lights, columns.point_lobes, parameters, w->points.count, &columns.point_radiance);
}

void shade_batch(const core::SimdTarget& simd, const DrawShading& shading, const LightTable& lights,
                 const shd_view& view, Workspace* w) {
  complete_fragments(simd, shading, view.eye, shading.wanted | needed_columns(shading, lights), &w->fragments);
  if (shading.frequency != SHD_FREQUENCY_PHONG) make_points(shading, view.eye, w);
  if (shading.material->model == SHD_MODEL_PROGRAM) {
    shade_program(simd, shading, w);
    w->nonfinite = count_nonfinite(simd, w->columns.radiance, w->fragments.count);
    return;
  }
  if (runs_caller_code(*shading.material)) make_varyings(simd, shading, w);
  shade_model(simd, shading, lights, view, w);
}

}  // namespace shd::shade
