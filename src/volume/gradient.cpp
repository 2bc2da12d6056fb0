// SPDX-License-Identifier: MIT
// Normals of density by central differences over two texels (Levoy, "Display of Surfaces from Volume Data", IEEE
// Computer Graphics and Applications 8(3), 1988), and the shading of points with them.
#include "volume/gradient.h"

#include <cmath>

#include "data/data.h"
#include "data/vec3.h"
#include "texture/lookup/sample.h"
#include "volume/volume.h"

namespace shd::volume {
namespace {

using data::Vec3;

/// Looks up the densities one texel before and behind `count` points on each axis: row 2 axis, and row 2 axis + 1.
void look_up_neighbours(const core::SimdTarget& simd, const Volume& volume, const Points& points, size_t count,
                        GradientScratch* s) {
  const texture::Texture& texture = *volume.texture;
  const uint32_t size[3] = {texture.width, texture.height, texture.depth};
  const float* const at[3] = {points.u, points.v, points.w};
  for (int row = 0; row < 6; ++row) {
    for (int c = 0; c < 3; ++c) {
      float* to = s->place[c] + static_cast<size_t>(row) * count;
      const float texel = c == row / 2 ? (row % 2 ? 1.0f : -1.0f) / static_cast<float>(size[c]) : 0.0f;
      for (size_t i = 0; i < count; ++i) to[i] = at[c][s->point[i]] + texel;
    }
  }
  texture::Lookups lookups = {};
  lookups.count = 6 * count;
  lookups.u = s->place[0];
  lookups.v = s->place[1];
  lookups.w = s->place[2];
  texture::Texels texels = {};
  texels.channel[0] = s->density;
  texture::sample(texture, volume.sampler, simd, lookups, texels);
}

/// Returns the unit vector against the gradient of density in world space, or `toward` without a gradient.
Vec3 normal_at(const Volume& volume, const WorldToBox& box, const GradientScratch& s, size_t count, size_t i,
               const Vec3& toward) {
  const uint32_t size[3] = {volume.texture->width, volume.texture->height, volume.texture->depth};
  float world[3] = {};
  for (size_t c = 0; c < 3; ++c) {
    const float before = s.density[2 * c * count + i], behind = s.density[(2 * c + 1) * count + i];
    const float slope = 0.5f * (behind - before) * static_cast<float>(size[c]);
    for (int k = 0; k < 3; ++k) world[k] -= slope * static_cast<float>(box.row[c][k]);
  }
  const Vec3 normal = data::normalized(Vec3{world[0], world[1], world[2]});
  const bool is_known = std::isfinite(normal.x + normal.y + normal.z) && !data::is_zero(normal);
  return is_known ? normal : toward;
}

/// Sets the point `to` of the workspace.
void set_point(const Points& points, uint32_t from, const Vec3& normal, const Vec3& toward, size_t to,
               shade::Workspace* w) {
  const Ray& ray = points.rays[points.ray[from]];
  const float t = static_cast<float>(points.step[from]) + ray.offset;
  raster::Fragments& f = w->points;
  f.px[to] = ray.world_origin[0] + t * ray.world_step[0];
  f.py[to] = ray.world_origin[1] + t * ray.world_step[1];
  f.pz[to] = ray.world_origin[2] + t * ray.world_step[2];
  f.nx[to] = normal.x;
  f.ny[to] = normal.y;
  f.nz[to] = normal.z;
  f.ox[to] = toward.x;
  f.oy[to] = toward.y;
  f.oz[to] = toward.z;
  for (int c = 0; c < 3; ++c) w->columns.slot[SHD_SLOT_DIFFUSE][c][to] = points.color[c][from];
}

/// Shades the points whose indices are in the scratch memory.
void shade_some(const core::SimdTarget& simd, const Volume& volume, const PointShading& shading, const Points& points,
                size_t count, GradientScratch* s) {
  look_up_neighbours(simd, volume, points, count, s);
  const bool two_sided = (volume.material->flags & SHD_MATERIAL_DOUBLE_SIDED) != 0;
  shade::Workspace* w = shading.workspace;
  for (size_t i = 0; i < count; ++i) {
    const Ray& ray = points.rays[points.ray[s->point[i]]];
    const Vec3 toward = data::normalized(Vec3{-ray.world_step[0], -ray.world_step[1], -ray.world_step[2]});
    Vec3 normal = normal_at(volume, shading.box, *s, count, i, toward);
    if (two_sided && data::dot(normal, toward) < 0.0f) normal = -1.0f * normal;
    set_point(points, s->point[i], normal, toward, i, w);
  }
  for (size_t i = count; i < data::padded(count); ++i) {
    const Vec3 toward = {w->points.ox[count - 1], w->points.oy[count - 1], w->points.oz[count - 1]};
    set_point(points, s->point[count - 1], toward, toward, i, w);
  }
  w->points.count = count;
  shade::shade_points(simd, *volume.material, shading.lights, w);
  for (size_t i = 0; i < count; ++i) {
    for (size_t c = 0; c < 3; ++c) points.color[c][s->point[i]] = w->columns.point_radiance.channel[c][i];
  }
}

}  // namespace

void shade(const core::SimdTarget& simd, const Volume& volume, const PointShading& shading, const Points& points,
           GradientScratch* scratch) {
  size_t count = 0;
  for (size_t i = 0; i < points.count; ++i) {
    if (!(points.opacity[i] > 0.0f)) continue;
    scratch->point[count++] = static_cast<uint32_t>(i);
    if (count < kShadedPoints) continue;
    shade_some(simd, volume, shading, points, count, scratch);
    count = 0;
  }
  if (count > 0) shade_some(simd, volume, shading, points, count, scratch);
}

}  // namespace shd::volume
