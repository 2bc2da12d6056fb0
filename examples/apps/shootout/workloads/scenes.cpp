// SPDX-License-Identifier: MIT
// Workloads whose maps are the scenes of shd-bench.
#include "workload.h"

namespace shootout {

using shd::bench::Scene;
using shd::bench::Shape;

Workload scene_workload(const Scene& scene, const std::string& name, const std::string& title) {
  Workload workload;
  workload.name = name;
  workload.title = title;
  workload.edge = scene.frame;
  workload.at = [scene](uint32_t x, uint32_t y, double dx, double dy) {
    return shd::bench::point_of(scene, x + 0.5 + dx, y + 0.5 + dy);
  };
  if ((scene.shape == Shape::kFloor || scene.shape == Shape::kTurnedFloor) && scene.move == 0.0) {
    // The distance and the scale of the scene, in the terms of shd::bench::Floor.
    shd::bench::Floor floor = {12.0f, 0.4f * static_cast<float>(scene.zoom), scene.frame};
    workload.surface = shd::bench::floor_surface(floor);
    if (scene.shape == Shape::kTurnedFloor) {
      for (auto& uv : workload.surface->uv) {
        const float u = uv[0], v = uv[1], root = 0.70710678f;
        uv[0] = root * (u - v);
        uv[1] = root * (u + v);
      }
    }
  }
  return workload;
}

}  // namespace shootout
