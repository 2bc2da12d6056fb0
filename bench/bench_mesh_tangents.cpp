// SPDX-License-Identifier: MIT
// mesh/<what>/triangles:<count>: shd_mesh_create of a sphere of 708 x 708 squares with given normals, on one thread;
// items are triangles. plain copies and checks alone; tangents computes them as well; tangents_unindexed has three
// vertices of its own for each triangle, mirrored has u = |2 u - 1|, so that a line of vertices is split.
#include <cmath>

#include "bench.h"

namespace shd::bench {
namespace {

constexpr uint32_t kSide = 708;

/// Rows of position, normal, uv, and triangles.
struct Sphere {
  std::vector<float> rows;
  std::vector<uint32_t> indices;
};

Sphere make_sphere(bool mirrored) {
  Sphere sphere;
  for (uint32_t y = 0; y <= kSide; ++y) {
    for (uint32_t x = 0; x <= kSide; ++x) {
      const float u = static_cast<float>(x) / kSide, v = static_cast<float>(y) / kSide;
      const double a = 6.283185307179586 * static_cast<double>(u), b = 3.141592653589793 * static_cast<double>(v);
      const float n[3] = {static_cast<float>(std::cos(a) * std::sin(b)), static_cast<float>(std::cos(b)),
                          static_cast<float>(-std::sin(a) * std::sin(b))};
      for (const float value : {n[0], n[1], n[2], n[0], n[1], n[2], mirrored ? std::fabs(2 * u - 1) : u, v}) {
        sphere.rows.push_back(value);
      }
    }
  }
  for (uint32_t y = 0; y < kSide; ++y) {
    for (uint32_t x = 0; x < kSide; ++x) {
      const uint32_t a = y * (kSide + 1) + x, b = a + kSide + 1;
      for (const uint32_t i : {a, b, b + 1, a, b + 1, a + 1}) sphere.indices.push_back(i);
    }
  }
  return sphere;
}

Sphere unindexed(const Sphere& from) {
  Sphere sphere;
  for (const uint32_t i : from.indices) {
    sphere.indices.push_back(static_cast<uint32_t>(sphere.indices.size()));
    sphere.rows.insert(sphere.rows.end(), from.rows.begin() + 8 * i, from.rows.begin() + 8 * i + 8);
  }
  return sphere;
}

void run(benchmark::State& state, const Sphere& sphere, uint32_t flags) {
  shd_context* context = make_context(SHD_SIMD_BEST);
  shd_mesh_desc desc = shd_mesh_desc_default();
  constexpr size_t kStride = 8 * sizeof(float);
  desc.vertex_count = static_cast<uint32_t>(sphere.rows.size() / 8);
  for (size_t c = 0; c < 3; ++c) desc.position[c] = {&sphere.rows[c], kStride};
  for (size_t c = 0; c < 3; ++c) desc.normal[c] = {&sphere.rows[3 + c], kStride};
  for (size_t c = 0; c < 2; ++c) desc.uv[c] = {&sphere.rows[6 + c], kStride};
  desc.indices.data = sphere.indices.data();
  desc.index_count = sphere.indices.size();
  desc.flags = flags;
  const auto create = [&] {
    shd_mesh* mesh = nullptr;
    check(shd_mesh_create(context, &desc, &mesh));
    shd_mesh_release(mesh);
  };
  create();  // a virtual machine hands out memory slowly the first time
  for (auto _ : state) create();
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(sphere.indices.size() / 3));
  shd_context_release(context);
}

}  // namespace

void register_mesh_tangents() {
  const auto add = [](const char* what, bool mirrored, bool indexed, uint32_t flags) {
    const std::string name = std::string("mesh/") + what + "/triangles:" + std::to_string(2 * kSide * kSide);
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
      const Sphere sphere = make_sphere(mirrored);
      run(state, indexed ? sphere : unindexed(sphere), flags);
    })->Unit(benchmark::kMillisecond);
  };
  add("plain", false, true, SHD_MESH_NONE);
  add("tangents", false, true, SHD_MESH_TANGENTS);
  add("tangents_mirrored", true, true, SHD_MESH_TANGENTS);
  add("tangents_unindexed", false, false, SHD_MESH_TANGENTS);
}

}  // namespace shd::bench
