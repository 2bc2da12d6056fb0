// SPDX-License-Identifier: MIT
#include "shapes.h"

#include <algorithm>

#include "failure.h"

namespace {

Geometry geometry_of(shd_shape shape, uint32_t steps) {
  shd_shape_desc desc = shd_shape_desc_default();
  desc.shape = shape;
  desc.segments[0] = shape == SHD_SHAPE_SPHERE ? 4 * steps : steps;
  desc.segments[1] = shape == SHD_SHAPE_SPHERE ? 2 * steps : steps;
  desc.segments[2] = steps;
  if (shape == SHD_SHAPE_TEAPOT) desc.segments[0] = std::max(steps, 2u);
  if (shape == SHD_SHAPE_TORUS) desc.segments[0] = 4 * steps, desc.segments[1] = 2 * steps + 1;
  shd_shape_columns columns = shd_shape_columns_default();
  check(shd_shape_count(&desc, &columns.vertex_count, &columns.index_count), "shape");
  Geometry geometry;
  geometry.position.resize(size_t{3} * columns.vertex_count);
  geometry.normal.resize(size_t{3} * columns.vertex_count);
  geometry.uv.resize(size_t{2} * columns.vertex_count);
  geometry.indices.resize(columns.index_count);
  for (size_t c = 0; c < 3; ++c) {
    columns.position[c] = {geometry.position.data() + c, 3 * sizeof(float)};
    columns.normal[c] = {geometry.normal.data() + c, 3 * sizeof(float)};
  }
  for (size_t c = 0; c < 2; ++c) columns.uv[c] = {geometry.uv.data() + c, 2 * sizeof(float)};
  columns.indices.data = geometry.indices.data();
  check(shd_shape_fill(&desc, &columns), "shape");
  return geometry;
}

}  // namespace

Model make_shape(shd_shape shape, int steps) {
  Model model;
  model.geometries.push_back(geometry_of(shape, static_cast<uint32_t>(steps)));
  Surface surface;
  surface.name = "ceramic";
  surface.diffuse = {0.62f, 0.6f, 0.56f};
  model.surfaces.push_back(surface);
  model.instances.push_back(Instance{});
  return model;
}

void add_floor(Model& model, const Bounds& bounds) {
  Instance instance;
  instance.geometry = model.geometries.size();
  instance.surface = model.surfaces.size();
  model.geometries.push_back(geometry_of(SHD_SHAPE_PLANE, 1));
  for (size_t c = 0; c < 3; ++c) instance.object_to_world[5 * c] = 4.0f * bounds.radius;
  for (size_t c = 0; c < 3; ++c) instance.object_to_world[12 + c] = bounds.center[c];
  instance.object_to_world[13] = bounds.bottom;
  model.instances.push_back(instance);
  Surface surface;
  surface.name = "floor";
  surface.diffuse = {0.5f, 0.5f, 0.5f};
  surface.specular = {0, 0, 0};
  surface.is_floor = true;
  model.surfaces.push_back(surface);
}
