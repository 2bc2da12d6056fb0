// SPDX-License-Identifier: MIT
// Workloads of one footprint, or of one in each cell, and movies of planes.
#include <algorithm>
#include <cmath>

#include "workload.h"

namespace shootout {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// A number in [0, 1) from a position and a key. Multipliers are those of xxHash32 (Collet 2012).
double random_at(uint32_t x, uint32_t y, uint32_t key) {
  uint32_t h = x * 0x9E3779B1u + y * 0x85EBCA77u + key * 0xC2B2AE3Du;
  h = (h ^ (h >> 15)) * 0x85EBCA77u;
  h = (h ^ (h >> 13)) * 0xC2B2AE3Du;
  return (h ^ (h >> 16)) / 4294967296.0;
}

Point turned(double x, double y, double angle) {
  return {std::cos(angle) * x - std::sin(angle) * y, std::sin(angle) * x + std::cos(angle) * y};
}

Workload random_workload(uint32_t edge, uint32_t texture_edge) {
  Workload workload;
  workload.name = "random";
  workload.title = "Random lookups";
  workload.edge = edge;
  workload.smooth = false;
  workload.at = [texture_edge](uint32_t x, uint32_t y, double dx, double dy) {
    const double minor = std::exp2(3 * random_at(x, y, 2)) / texture_edge, ratio = std::exp2(3 * random_at(x, y, 3));
    const Point step = turned(dx * minor * ratio, dy * minor, kPi * random_at(x, y, 4));
    return Point{random_at(x, y, 0) + step.u, random_at(x, y, 1) + step.v};
  };
  return workload;
}

/// Cells of parallel footprints 1.5 texels wide. Each cell begins at a place of its own.
Workload rosette(uint32_t edge, uint32_t texture_edge) {
  Workload workload;
  workload.name = "rosette";
  workload.title = "Angle rosette: 0 to 90 degrees, ratios of 1 to 64";
  workload.edge = edge;
  workload.smooth = false;
  const uint32_t cell = edge / kRosetteCells;
  workload.at = [=](uint32_t x, uint32_t y, double dx, double dy) {
    const uint32_t column = std::min(x / cell, kRosetteCells - 1), row = std::min(y / cell, kRosetteCells - 1);
    const double width = 1.5 / texture_edge;
    // Steps of golden ratios spread the pixels of a cell over the texture, as long footprints overlap.
    const double place = (y % cell) * cell + x % cell;
    const Point step = turned(dx * width * rosette_ratio(row), dy * width, rosette_angle(column));
    return Point{std::fmod(random_at(column, row, 0) + 0.7548776662 * place, 1.0) + step.u,
                 std::fmod(random_at(column, row, 1) + 0.5698402910 * place, 1.0) + step.v};
  };
  return workload;
}

Workload movie(uint32_t edge, const std::string& name, const std::string& title,
               const std::function<Point(double frame, double x, double y)>& at) {
  Workload workload;
  workload.name = name;
  workload.title = title;
  workload.edge = edge * kMovieColumns;
  workload.frames = kMovieFrames;
  workload.smooth = false;
  workload.at = [=](uint32_t x, uint32_t y, double dx, double dy) {
    const uint32_t frame = std::min(y / edge * kMovieColumns + x / edge, kMovieFrames - 1);
    return at(frame, (x % edge + 0.5 + dx) / edge, (y % edge + 0.5 + dy) / edge);
  };
  return workload;
}

}  // namespace

double rosette_angle(uint32_t column) {
  return kPi / 2 * column / (kRosetteCells - 1);
}

double rosette_ratio(uint32_t row) {
  return std::exp2(6.0 * row / (kRosetteCells - 1));
}

double level_curve_lod(uint32_t column, uint32_t edge) {
  return -2.0 + 8.0 * (column + 0.5) / edge;
}

Workload level_curve(uint32_t edge, uint32_t texture_edge) {
  Workload workload;
  workload.name = "level_curve";
  workload.title = "Level transfer";
  workload.edge = edge;
  workload.smooth = false;
  workload.at = [=](uint32_t x, uint32_t y, double dx, double dy) {
    const double width = std::exp2(level_curve_lod(x, edge)) / texture_edge;
    return Point{random_at(x, y, 5) + dx * width, random_at(x, y, 6) + dy * width};
  };
  return workload;
}

Workload plane_workload(uint32_t edge, uint32_t texture_edge, double texels, double angle, Point move,
                        const std::string& name, const std::string& title) {
  Workload workload;
  workload.name = name;
  workload.title = title;
  workload.edge = edge;
  const double scale = texels / texture_edge;
  const auto at = [=](double x, double y) {
    const Point p = turned(scale * (x - edge / 2.0), scale * (y - edge / 2.0), angle);
    return Point{0.5 + move.u + p.u, 0.5 + move.v + p.v};
  };
  workload.at = [=](uint32_t x, uint32_t y, double dx, double dy) { return at(x + 0.5 + dx, y + 0.5 + dy); };
  workload.surface = shd::bench::quad_surface(1.0f);
  for (int corner = 0; corner < 4; ++corner) {
    const Point p = at(corner & 1 ? edge : 0.0, corner & 2 ? edge : 0.0);
    workload.surface->uv[corner][0] = static_cast<float>(p.u);
    workload.surface->uv[corner][1] = static_cast<float>(p.v);
  }
  return workload;
}

std::vector<Workload> still_workloads(uint32_t edge, uint32_t texture_edge) {
  using shd::bench::Shape;
  std::vector<Workload> all;
  // The scenes have their footprints at 256 pixels and 1024 texels.
  const double zoom = edge * 4.0 / texture_edge;
  const auto scene = [&](Shape shape, const char* name, const char* title) {
    all.push_back(scene_workload({shape, edge, zoom}, name, title));
  };
  scene(Shape::kFloor, "floor", "Floor in perspective");
  scene(Shape::kTurnedFloor, "floor_45", "Floor, texture turned by 45 degrees");
  scene(Shape::kTunnel, "tunnel", "Tunnel");
  scene(Shape::kSphere, "sphere", "Sphere");
  scene(Shape::kZoom, "conformal", "Conformal zoom: circles of 1.3 to 8 texels");
  all.push_back(
      plane_workload(edge, texture_edge, 1.0, 0.0, {0.0, 0.0}, "one_to_one", "One texel a pixel, in register"));
  all.push_back(plane_workload(edge, texture_edge, 1.0, 0.3, {0.0, 0.0}, "one_to_one_turned",
                               "One texel a pixel, turned by 17 degrees"));
  for (const int factor : {2, 8, 64}) {
    const std::string text = std::to_string(factor);
    all.push_back(plane_workload(edge, texture_edge, 1.0 / factor, 0.0, {0.013, 0.021}, "magnified_" + text,
                                 "Magnified " + text + " times"));
  }
  all.push_back(random_workload(edge, texture_edge));
  all.push_back(rosette(edge, texture_edge));
  return all;
}

std::vector<Workload> movies(uint32_t edge, uint32_t texture_edge) {
  const double texel = 1.0 / texture_edge;
  std::vector<Workload> all;
  all.push_back(
      movie(edge, "zoom", "60 frames of a zoom out, 1 to 8 texels a pixel", [=](double t, double x, double y) {
        const double scale = edge * texel * std::exp2(3 * t / (kMovieFrames - 1));
        return Point{0.47 + scale * (x - 0.5), 0.53 + scale * (y - 0.5)};
      }));
  shd::bench::Scene scene = {shd::bench::Shape::kFloor, edge, edge * 4.0 * texel};
  all.push_back(movie(edge, "pan", "60 frames of a flight over the floor", [=](double t, double x, double y) {
    shd::bench::Scene moved = scene;
    moved.move = 0.05 * t / (kMovieFrames - 1);
    return shd::bench::point_of(moved, x * edge, y * edge);
  }));
  return all;
}

}  // namespace shootout
