// SPDX-License-Identifier: MIT
#include "shade/run.h"

#include <algorithm>
#include <cstring>
#include <exception>

#include "core/status.h"
#include "data/data.h"
#include "raster/interpolate.h"
#include "shade/combine.h"
#include "shade/frequency.h"
#include "shade/illuminate.h"
#include "texture/texture.h"

namespace shd::shade {
namespace {

/// What shading reads of the fragments, as raster::Interpolated bits.
uint32_t needed_columns(const DrawShading& shading, const LightTable& lights) {
  const material::Material& material = *shading.material;
  const bool is_program = material.model == SHD_MODEL_PROGRAM;
  if (shading.frequency == SHD_FREQUENCY_PHONG && is_program) return raster::kInterpolateAll;
  uint32_t needed = material.diffuse_texture ? uint32_t{raster::kTexture} : 0;
  if (shading.frequency == SHD_FREQUENCY_GOURAUD) needed |= raster::kBarycentrics;
  if (shading.frequency != SHD_FREQUENCY_PHONG || material.model == SHD_MODEL_UNLIT) return needed;
  needed |= raster::kNormal;
  if (material.model == SHD_MODEL_BLINN_PHONG) needed |= raster::kToEye;
  for (size_t i = 0; i < lights.count; ++i) {
    if (lights.lights[i].kind == SHD_LIGHT_POINT) needed |= raster::kPosition;
  }
  return needed;
}

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

/// 0 in all targets but colour.
void clear_targets(size_t count, Radiance* radiance) {
  for (uint32_t c = 4; c < 4 * kMaxTargets; ++c) {
    if (radiance->channel[c]) std::memset(radiance->channel[c], 0, count * sizeof(float));
  }
}

/// Calls the program; what it throws becomes a Failure.
void call(const DrawShading& shading, const shd_fragments& in, shd_radiance* out) {
  const shd_material_program& program = shading.material->program;
  try {
    program.fragment(&in, out, program.user_data);
  } catch (const std::exception& error) {
    throw core::Failure(core::fail(SHD_ERROR_CALLBACK, "material.program.fragment threw in render.draws[%u]: %s",
                                   shading.draw, error.what()));
  } catch (...) {
    throw core::Failure(
        core::fail(SHD_ERROR_CALLBACK, "material.program.fragment threw in render.draws[%u]", shading.draw));
  }
}

/// Runs the program for rows whose varyings, if the material has any, are in `varyings`.
void run_program(const DrawShading& shading, const raster::Fragments& f, const raster::Varyings& varyings,
                 uint32_t* discard, Radiance* radiance) {
  for (int c = 0; c < 4; ++c) {
    for (size_t i = 0; i < f.count; ++i) radiance->channel[c][i] = c == 3 ? 1.0f : 0.0f;
  }
  clear_targets(f.count, radiance);
  shd_fragments in = {};
  in.struct_size = sizeof in;
  in.draw = shading.draw;
  in.count = f.count;
  in.x = f.x, in.y = f.y, in.depth = f.depth;
  in.px = f.px, in.py = f.py, in.pz = f.pz;
  in.nx = f.nx, in.ny = f.ny, in.nz = f.nz;
  in.ox = f.ox, in.oy = f.oy, in.oz = f.oz;
  in.u = f.u, in.v = f.v;
  in.dudx = f.dudx, in.dvdx = f.dvdx, in.dudy = f.dudy, in.dvdy = f.dvdy;
  in.triangle = f.triangle;
  in.instance = shading.instance;
  in.uniforms = shading.uniforms;
  in.varying_count = shading.material->varying_count;
  for (uint32_t c = 0; c < in.varying_count; ++c) in.varying[c] = varyings.column[c];
  shd_radiance out = {};
  out.struct_size = sizeof out;
  out.r = radiance->channel[0], out.g = radiance->channel[1], out.b = radiance->channel[2];
  out.a = radiance->channel[3];
  std::memcpy(out.target, radiance->channel + 4, sizeof out.target);
  if (shading.material->flags & SHD_MATERIAL_DISCARDS) {
    std::memset(discard, 0, f.count * sizeof(uint32_t));
    out.discard = discard;
  }
  call(shading, in, &out);
#ifndef NDEBUG
  if (in.count != f.count) {
    throw core::Failure(core::fail(SHD_ERROR_CALLBACK,
                                   "material.program.fragment changed the count in render.draws[%u]", shading.draw));
  }
#endif
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

/// Diffuse texture at the fragments, or null.
const float* const* look_up(const core::SimdTarget& simd, const material::Material& material, Workspace* w) {
  if (!material.diffuse_texture) return nullptr;
  const raster::Fragments& f = w->fragments;
  const texture::Lookups lookups = {f.count, f.u, f.v, f.dudx, f.dvdx, f.dudy, f.dvdy, nullptr, nullptr, nullptr};
  float* alpha = has_opacity(material) ? w->columns.texture[3] : nullptr;
  texture::sample(*material.diffuse_texture, *material.diffuse_sampler, simd, lookups,
                  {{w->columns.texture[0], w->columns.texture[1], w->columns.texture[2], alpha}, {}, {}});
  return w->columns.texture;
}

}  // namespace

void allocate(const core::Allocator& allocator, uint32_t varying_count, uint32_t targets, Workspace* out) {
  raster::allocate(allocator, varying_count, &out->varyings);
  raster::allocate(allocator, &out->fragments);
  raster::allocate(allocator, &out->rows);
  allocate(allocator, targets, &out->columns);
}

void shade_batch(const core::SimdTarget& simd, const DrawShading& shading, const LightTable& lights, const float eye[3],
                 Workspace* w) {
  const material::Material& material = *shading.material;
  const bool per_fragment = shading.frequency == SHD_FREQUENCY_PHONG;
  Columns& columns = w->columns;
  complete_fragments(simd, shading, eye, shading.wanted | needed_columns(shading, lights), &w->fragments);
  if (!per_fragment) make_rows(shading, eye, w);
  if (shading.frequency == SHD_FREQUENCY_FLAT) {
    spread_centroids(columns.row, w->fragments.count, w->rows.nx, w->fragments.nx);
    spread_centroids(columns.row, w->fragments.count, w->rows.ny, w->fragments.ny);
    spread_centroids(columns.row, w->fragments.count, w->rows.nz, w->fragments.nz);
  }
  const raster::Fragments& rows = per_fragment ? w->fragments : w->rows;

  if (material.model == SHD_MODEL_PROGRAM) {
    uint32_t* discard = per_fragment ? columns.discard : columns.row_discard;
    make_varyings(simd, shading, w);
    run_program(shading, rows, w->varyings, discard, per_fragment ? &columns.radiance : &columns.row_radiance);
    if (per_fragment) return;
    if (material.flags & SHD_MATERIAL_DISCARDS) {
      for (size_t i = 0; i < w->fragments.count; ++i) columns.discard[i] = columns.row_discard[columns.row[i]];
    }
    for (uint32_t c = 0; c < 4 * kMaxTargets; ++c) {
      if (!columns.radiance.channel[c]) continue;
      spread(simd, shading, *w, columns.row_radiance.channel[c], columns.radiance.channel[c]);
    }
    return;
  }
  clear_targets(w->fragments.count, &columns.radiance);
  const float* const* texture = look_up(simd, material, w);
  if (material.model == SHD_MODEL_UNLIT) {
    return combine(simd, material, lights, nullptr, texture, w->fragments.count, &columns.radiance);
  }
  illuminate(simd, material, lights, rows, per_fragment ? &columns.lobes : &columns.row_lobes);
  if (!per_fragment) {
    for (int c = 0; c < 3; ++c) {
      spread(simd, shading, *w, columns.row_lobes.diffuse[c], columns.lobes.diffuse[c]);
      spread(simd, shading, *w, columns.row_lobes.specular[c], columns.lobes.specular[c]);
    }
  }
  combine(simd, material, lights, &columns.lobes, texture, w->fragments.count, &columns.radiance);
}

}  // namespace shd::shade
