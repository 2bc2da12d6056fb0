// SPDX-License-Identifier: MIT
#include "shapes.h"

#include <algorithm>
#include <cmath>

namespace {

/// Adds rows and columns of squares over vertices that are stored row by row. The squares are counter-clockwise if rows
/// run down and columns run to the right.
void add_grid(Geometry& out, uint32_t rows, uint32_t columns) {
  for (uint32_t j = 0; j < rows; ++j) {
    for (uint32_t i = 0; i < columns; ++i) {
      const uint32_t a = j * (columns + 1) + i, b = a + columns + 1;
      for (const uint32_t vertex : {a, b, b + 1, a, b + 1, a + 1}) out.indices.push_back(vertex);
    }
  }
}

void add_vertex(Geometry& out, const std::array<double, 3>& point, const std::array<double, 3>& normal, double u,
                double v) {
  for (const double c : point) out.position.push_back(static_cast<float>(c));
  for (const double c : normal) out.normal.push_back(static_cast<float>(c));
  out.uv.push_back(static_cast<float>(u));
  out.uv.push_back(static_cast<float>(v));
}

Model model_of(Geometry geometry, const char* name) {
  Model model;
  model.geometries.push_back(std::move(geometry));
  Surface surface;
  surface.name = name;
  surface.diffuse = {0.62f, 0.6f, 0.56f};
  model.surfaces.push_back(surface);
  model.instances.push_back(Instance{});
  return model;
}

}  // namespace

Model make_sphere(int steps) {
  constexpr double kPi = 3.14159265358979;
  const int around = 4 * steps, down = 2 * steps;
  Geometry geometry;
  for (int j = 0; j <= down; ++j) {
    for (int i = 0; i <= around; ++i) {
      const double turn = 2.0 * kPi * i / around - kPi, fall = kPi * j / down;
      const std::array<double, 3> n = {std::sin(fall) * std::sin(turn), std::cos(fall),
                                       std::sin(fall) * std::cos(turn)};
      add_vertex(geometry, n, n, static_cast<double>(i) / around, static_cast<double>(j) / down);
    }
  }
  add_grid(geometry, static_cast<uint32_t>(down), static_cast<uint32_t>(around));
  return model_of(std::move(geometry), "sphere");
}

Model make_plane(int steps) {
  Geometry geometry;
  for (int j = 0; j <= steps; ++j) {
    for (int i = 0; i <= steps; ++i) {
      const double u = static_cast<double>(i) / steps, v = static_cast<double>(j) / steps;
      add_vertex(geometry, {2 * u - 1, 0, 2 * v - 1}, {0, 1, 0}, u, v);
    }
  }
  add_grid(geometry, static_cast<uint32_t>(steps), static_cast<uint32_t>(steps));
  return model_of(std::move(geometry), "plane");
}

void add_floor(Model& model, const Bounds& bounds) {
  Instance instance;
  instance.geometry = model.geometries.size();
  instance.surface = model.surfaces.size();
  model.geometries.push_back(std::move(make_plane(1).geometries.front()));
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
