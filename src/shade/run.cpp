// SPDX-License-Identifier: MIT
#include "shade/run.h"

#include <algorithm>

#include "data/data.h"
#include "raster/interpolate.h"
#include "shade/combine.h"
#include "shade/cull.h"
#include "shade/frames.h"
#include "shade/frequency.h"
#include "shade/illuminate.h"
#include "shade/modulation.h"
#include "shade/needs.h"
#include "shade/parallax.h"
#include "shade/parameters.h"
#include "shade/program.h"
#include "shade/show.h"
#include "shade/surface.h"

namespace shd::shade {
namespace {

/// Completes x, y, depth, triangle to vertices and interpolated attributes.
void complete_fragments(const core::SimdTarget& simd, const DrawShading& shading, const float eye[3], uint32_t wanted,
                        raster::Fragments* f) {
  // Rows up to the next whole vector repeat the last one.
  for (size_t i = f->count; i < data::padded(f->count); ++i) {
    f->x[i] = f->x[f->count - 1];
    f->y[i] = f->y[f->count - 1];
    f->depth[i] = f->depth[f->count - 1];
    f->triangle[i] = f->triangle[f->count - 1];
  }
  const geometry::Vertices& vertices = *shading.vertices;
  for (size_t begin = 0, end; begin < data::padded(f->count); begin = end) {
    const uint32_t triangle = f->triangle[begin];
    for (end = begin + 1; end < data::padded(f->count) && f->triangle[end] == triangle;) ++end;
    for (size_t k = 0; k < 3; ++k) std::fill(f->vertex[k] + begin, f->vertex[k] + end, row_of(vertices, triangle, k));
  }
  raster::interpolate(simd, vertices, eye, wanted, f);
}

/// Rows of Gouraud and flat shading, one set for each triangle of the batch; columns.row says which is whose.
void make_rows(const DrawShading& shading, const float eye[3], Workspace* w) {
  const bool flat = shading.frequency == SHD_FREQUENCY_FLAT;
  raster::Fragments& f = w->fragments;
  size_t next = 0;
  for (size_t i = 0; i < f.count; ++i) {
    if (i == 0 || f.triangle[i] != f.triangle[i - 1]) {
      if (flat) {
        set_centroid(*shading.vertices, eye, shading.orientation, f.triangle[i], next, &w->rows);
      } else {
        set_corners(*shading.vertices, eye, f.triangle[i], next, &w->rows);
      }
      next += flat ? 1 : 3;
    }
    w->columns.row[i] = static_cast<uint32_t>(next - (flat ? 1 : 3));
  }
  for (size_t i = f.count; i < data::padded(f.count); ++i) w->columns.row[i] = w->columns.row[f.count - 1];
  w->rows.count = next;
}

/// One value per row to one per fragment.
void spread(const core::SimdTarget& simd, const DrawShading& shading, const Workspace& w, const float* in, float* out) {
  if (shading.frequency == SHD_FREQUENCY_FLAT) {
    spread_centroids(w.columns.row, w.fragments.count, in, out);
  } else {
    spread_corners(simd, w.fragments, w.columns.row, in, out);
  }
}

/// Normals of rows to the fragments.
void spread_normals(const core::SimdTarget& simd, const DrawShading& shading, Workspace* w) {
  spread(simd, shading, *w, w->rows.nx, w->fragments.nx);
  spread(simd, shading, *w, w->rows.ny, w->fragments.ny);
  spread(simd, shading, *w, w->rows.nz, w->fragments.nz);
}

/// Varyings of the rows that a program is about to see.
void make_varyings(const core::SimdTarget& simd, const DrawShading& shading, Workspace* w) {
  const geometry::Vertices& vertices = *shading.vertices;
  const shd_interpolation* modes = shading.material->interpolation;
  if (vertices.varying_count == 0) return;
  if (shading.frequency == SHD_FREQUENCY_PHONG) {
    raster::interpolate_varyings(simd, vertices, modes, w->fragments, &w->varyings);
  } else if (shading.frequency == SHD_FREQUENCY_FLAT) {
    set_centroid_varyings(vertices, modes, w->rows, &w->varyings);
  } else {
    set_corner_varyings(vertices, modes, w->rows, &w->varyings);
  }
}

/// Lobes of rows under the lights that reach them, those with a texture or a shadow a few at a time.
void light_rows(const core::SimdTarget& simd, const material::Material& material, const Shape& shape,
                const LightTable& lights, const raster::Fragments& rows, Workspace* w, Lobes* out) {
  const bool all_count = material.model == SHD_MODEL_GOOCH;
  size_t count = lights.count;
  if (all_count) {
    for (size_t i = 0; i < count; ++i) w->reaching[i] = static_cast<uint32_t>(i);
  } else {
    count = cull_lights(simd, lights, rows, w->reaching.data());
  }
  LightGroup group = {false, false};
  for (size_t next = 0; !group.finishes; group.continues = true) {
    size_t taken = 0, modulated = 0;
    for (; next < count; ++next, ++taken) {
      const light::Light& light = lights.lights[w->reaching[next]];
      w->active[taken] = {&light, {nullptr, nullptr, nullptr}};
      const light::Shadow* shadow = lights.any_shadow ? lights.shadows[w->reaching[next]] : nullptr;
      if (all_count || !is_modulated(light, shadow)) continue;
      if (modulated == kModulated) break;
      w->active[taken] = modulate(simd, light, shadow, rows, modulated++, &w->columns);
    }
    group.finishes = next == count;
    illuminate(simd, material, shape, w->active.data(), taken, rows, group, out);
  }
}

/// Colour of models without lights, into the first lobe of the fragments.
void show(const core::SimdTarget& simd, const DrawShading& shading, const shd_view& view, Workspace* w) {
  const material::Material& material = *shading.material;
  const raster::Fragments& f = w->fragments;
  float* const* out = w->columns.lobes.lobe[0];
  switch (material.model) {
    case SHD_MODEL_MATCAP: return show_matcap(simd, material, view, f, &w->columns);
    case SHD_MODEL_SHOW_NORMAL: return show_normals(f, out);
    case SHD_MODEL_SHOW_UV: return show_uv(f, out);
    case SHD_MODEL_SHOW_LEVEL: return show_levels(simd, material, f, &w->columns);
    case SHD_MODEL_SHOW_BARYCENTRICS: return show_barycentrics(f, out);
    default: return;
  }
}

/// Radiance of a model.
void shade_model(const core::SimdTarget& simd, const DrawShading& shading, const LightTable& lights,
                 const shd_view& view, Workspace* w) {
  const material::Material& material = *shading.material;
  const bool per_fragment = shading.frequency == SHD_FREQUENCY_PHONG;
  Columns& columns = w->columns;
  raster::Fragments& rows = per_fragment ? w->fragments : w->rows;
  const material::ModelInfo info = material::info_of(material.model);
  Parameters parameters = {};
  clear_targets(w->fragments.count, &columns.radiance);
  make_bases({shading, rows, w->varyings, per_fragment}, &rows, &columns);
  if (per_fragment && material.parallax_depth > 0.0f && material::has_slot(material, SHD_SLOT_HEIGHT)) {
    shift_by_heights(simd, {shading, rows, w->varyings, true}, &rows, &columns);
  }
  Shape shape = {};
  if (lights.any_shadow && info.lobes) keep_shadow_normals(rows, &columns);
  if (info.has_normal)
    shape = shape_surface(simd, {shading, rows, w->varyings, per_fragment}, &rows, &columns, &parameters);
  if (!per_fragment && (shading.frequency == SHD_FREQUENCY_FLAT || !info.lobes)) spread_normals(simd, shading, w);
  look_up_slots(simd, {shading, w->fragments, w->varyings, true}, ~material::kShapingSlots, &columns, &parameters);
  if (info.lobes) {
    light_rows(simd, material, shape, lights, rows, w, per_fragment ? &columns.lobes : &columns.row_lobes);
    for (uint32_t k = 0; k < info.lobes && !per_fragment; ++k) {
      for (int c = 0; c < 3; ++c) spread(simd, shading, *w, columns.row_lobes.lobe[k][c], columns.lobes.lobe[k][c]);
    }
  } else {
    show(simd, shading, view, w);
  }
  combine(simd, material, lights, columns.lobes, parameters, w->fragments.count, &columns.radiance);
}

/// Radiance of the caller's program.
void shade_program(const core::SimdTarget& simd, const DrawShading& shading, Workspace* w) {
  const material::Material& material = *shading.material;
  const bool per_fragment = shading.frequency == SHD_FREQUENCY_PHONG;
  Columns& columns = w->columns;
  raster::Fragments& rows = per_fragment ? w->fragments : w->rows;
  if (shading.vertices->tangent.size() == 0) {
    make_bases({shading, rows, w->varyings, per_fragment}, &rows, &columns);
  }
  if (material.flags & SHD_DOUBLE_SIDED) face_normals(*shading.vertices, shading.orientation, &rows);
  uint32_t* discard = per_fragment ? columns.discard : columns.row_discard;
  make_varyings(simd, shading, w);
  run_program(shading, rows, w->varyings, discard, per_fragment ? &columns.radiance : &columns.row_radiance);
  if (per_fragment) return;
  if (shading.frequency == SHD_FREQUENCY_FLAT) spread_normals(simd, shading, w);
  if (material.flags & SHD_MATERIAL_DISCARDS) {
    for (size_t i = 0; i < w->fragments.count; ++i) columns.discard[i] = columns.row_discard[columns.row[i]];
  }
  for (uint32_t c = 0; c < 4 * kMaxTargets; ++c) {
    if (!columns.radiance.channel[c]) continue;
    spread(simd, shading, *w, columns.row_radiance.channel[c], columns.radiance.channel[c]);
  }
}

}  // namespace

void allocate(const core::Allocator& allocator, const WorkspaceSize& size, Workspace* out) {
  raster::allocate(allocator, size.varying_count, &out->varyings);
  raster::allocate(allocator, &out->fragments);
  raster::allocate(allocator, &out->rows);
  allocate(allocator, size.targets, &out->columns);
  out->reaching = core::Array<uint32_t>(allocator, data::padded(size.light_count));
  out->active = core::Array<ActiveLight>(allocator, data::padded(size.light_count));
}

void shade_batch(const core::SimdTarget& simd, const DrawShading& shading, const LightTable& lights,
                 const shd_view& view, Workspace* w) {
  complete_fragments(simd, shading, view.eye, shading.wanted | needed_columns(shading, lights), &w->fragments);
  if (shading.frequency != SHD_FREQUENCY_PHONG) make_rows(shading, view.eye, w);
  if (shading.material->model == SHD_MODEL_PROGRAM) return shade_program(simd, shading, w);
  if (shows_rows(*shading.material)) make_varyings(simd, shading, w);
  shade_model(simd, shading, lights, view, w);
}

}  // namespace shd::shade
