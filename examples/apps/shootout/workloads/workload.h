// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "../../../../bench/scenes.h"

namespace shootout {

using shd::bench::Lookups;
using Point = shd::bench::Point;

/// A map from a square frame to the texture, one lookup a pixel.
struct Workload {
  std::string name, title;
  uint32_t edge = 0;    // width and height of the frame [pixels]
  uint32_t frames = 1;  // frames of a movie side by side, in rows of kMovieColumns
  bool smooth = true;   // neighbouring pixels meet; else each pixel or cell has a map of its own
  /// The point of the texture at (dx, dy) pixels from the centre of pixel (x, y).
  std::function<Point(uint32_t x, uint32_t y, double dx, double dy)> at;
  /// The map as a quadrilateral, for rasterisers, which compute their own derivatives.
  std::optional<shd::bench::Surface> surface;

  size_t count() const { return size_t{edge} * edge; }
};

constexpr uint32_t kMovieColumns = 8, kMovieFrames = 60;

/// Cells of the rosette: angles of 0 to 90 degrees across, ratios of 1 to 64 down.
constexpr uint32_t kRosetteCells = 16;
double rosette_angle(uint32_t column);
double rosette_ratio(uint32_t row);

/// Footprints of the columns of the level curve, from 1/4 to 64 texels.
double level_curve_lod(uint32_t column, uint32_t edge);

/// Every still workload with frames of edge x edge pixels, for textures of `texture_edge` texels.
std::vector<Workload> still_workloads(uint32_t edge, uint32_t texture_edge);
/// The zoom and the pan, with frames of edge x edge pixels.
std::vector<Workload> movies(uint32_t edge, uint32_t texture_edge);
/// A square footprint in each column, from 1/4 to 64 texels, at random places.
Workload level_curve(uint32_t edge, uint32_t texture_edge);

/// Lookups at `phases` x `phases` places a pixel from its centre, in frame order. Derivatives are central differences
/// in doubles.
Lookups lookups_of(const Workload& workload, uint32_t phases = 1);

/// A workload of one of the scenes of shd-bench.
Workload scene_workload(const shd::bench::Scene& scene, const std::string& name, const std::string& title);
/// The plane that fills the frame with `texels` texels a pixel, turned by `angle` [rad] and moved by (u, v).
Workload plane_workload(uint32_t edge, uint32_t texture_edge, double texels, double angle, Point move,
                        const std::string& name, const std::string& title);

}  // namespace shootout
