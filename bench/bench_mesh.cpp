// SPDX-License-Identifier: MIT
// mesh/<variant>/triangles:<count>: shd_mesh_create of a sphere of 708 x 708 squares with given normals, on one thread;
// items are triangles. plain only copies and checks; tangents also computes tangents; tangents_unindexed has three
// separate vertices per triangle; mirrored has u = |2 u - 1|, so that a line of vertices is split.
// mesh/{uniform,adaptive,displaced}/segments:<n>: shd_mesh_tessellate of a sphere of 32 x 32 squares with tangents, on
// one thread; items are output triangles.
#include <cmath>

#include "bench.h"

namespace shd::bench {
namespace {

constexpr uint32_t kSide = 708, kCoarseSide = 32;

/// Rows of position, normal and uv, and index triples.
struct Sphere {
  std::vector<float> rows;
  std::vector<uint32_t> indices;
};

Sphere make_sphere(uint32_t side, bool mirrored) {
  Sphere sphere;
  for (uint32_t y = 0; y <= side; ++y) {
    for (uint32_t x = 0; x <= side; ++x) {
      const float u = static_cast<float>(x) / static_cast<float>(side),
                  v = static_cast<float>(y) / static_cast<float>(side);
      const double a = 6.283185307179586 * static_cast<double>(u), b = 3.141592653589793 * static_cast<double>(v);
      const float n[3] = {static_cast<float>(std::cos(a) * std::sin(b)), static_cast<float>(std::cos(b)),
                          static_cast<float>(-std::sin(a) * std::sin(b))};
      for (const float value : {n[0], n[1], n[2], n[0], n[1], n[2], mirrored ? std::fabs(2 * u - 1) : u, v}) {
        sphere.rows.push_back(value);
      }
    }
  }
  for (uint32_t y = 0; y < side; ++y) {
    for (uint32_t x = 0; x < side; ++x) {
      const uint32_t a = y * (side + 1) + x, b = a + side + 1;
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

shd_mesh_desc desc_of(const Sphere& sphere, uint32_t flags) {
  shd_mesh_desc desc = shd_mesh_desc_default();
  constexpr size_t kStride = 8 * sizeof(float);
  desc.vertex_count = static_cast<uint32_t>(sphere.rows.size() / 8);
  for (size_t c = 0; c < 3; ++c) desc.position[c] = {&sphere.rows[c], kStride};
  for (size_t c = 0; c < 3; ++c) desc.normal[c] = {&sphere.rows[3 + c], kStride};
  for (size_t c = 0; c < 2; ++c) desc.uv[c] = {&sphere.rows[6 + c], kStride};
  desc.indices.data = sphere.indices.data();
  desc.index_count = sphere.indices.size();
  desc.flags = flags;
  return desc;
}

void run(benchmark::State& state, const Sphere& sphere, uint32_t flags) {
  shd_context* context = make_context(SHD_SIMD_BEST);
  const shd_mesh_desc desc = desc_of(sphere, flags);
  const auto create = [&] {
    shd_mesh* mesh = nullptr;
    check(shd_mesh_create(context, &desc, &mesh));
    shd_mesh_release(mesh);
  };
  create();  // a virtual machine provides memory slowly the first time
  for (auto _ : state) create();
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(sphere.indices.size() / 3));
  shd_context_release(context);
}

shd_texture* make_heights(shd_context* context) {
  constexpr uint32_t kTexels = 1024;
  std::vector<float> texels(size_t{kTexels} * kTexels);
  uint32_t random = 1;
  for (float& texel : texels) {
    random = random * 1664525u + 1013904223u;
    texel = static_cast<float>(random >> 8) * 0x1p-24f;
  }
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = SHD_FORMAT_R32F;
  desc.width = desc.height = kTexels;
  desc.texels = texels.data();
  shd_texture* texture = nullptr;
  check(shd_texture_create(context, &desc, &texture));
  return texture;
}

void run_tessellate(benchmark::State& state, shd_tessellation_mode mode, uint32_t segments, float amplitude) {
  shd_context* context = make_context(SHD_SIMD_BEST);
  const Sphere sphere = make_sphere(kCoarseSide, false);
  const shd_mesh_desc mesh_desc = desc_of(sphere, SHD_MESH_TANGENTS);
  shd_mesh* mesh = nullptr;
  check(shd_mesh_create(context, &mesh_desc, &mesh));
  shd_texture* heights = make_heights(context);
  shd_tessellation_desc desc = shd_tessellation_desc_default();
  desc.mode = mode;
  desc.segments = segments;
  desc.edge_length = 0.14f / static_cast<float>(segments);  // the longest edges are 0.14 long
  desc.displacement = heights;
  desc.amplitude = amplitude;
  int64_t triangles = 0;
  const auto tessellate = [&] {
    shd_mesh* cut = nullptr;
    shd_mesh_info info = shd_mesh_info_default();
    check(shd_mesh_tessellate(context, mesh, &desc, &cut));
    check(shd_mesh_get_info(cut, &info));
    triangles += info.triangle_count;
    shd_mesh_release(cut);
  };
  tessellate();
  triangles = 0;
  for (auto _ : state) tessellate();
  state.SetItemsProcessed(triangles);
  shd_mesh_release(mesh);
  shd_texture_release(heights);
  shd_context_release(context);
}

}  // namespace

void register_mesh() {
  const auto add = [](const char* what, bool mirrored, bool indexed, uint32_t flags) {
    const std::string name = std::string("mesh/") + what + "/triangles:" + std::to_string(2 * kSide * kSide);
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
      const Sphere sphere = make_sphere(kSide, mirrored);
      run(state, indexed ? sphere : unindexed(sphere), flags);
    })->Unit(benchmark::kMillisecond);
  };
  add("plain", false, true, SHD_MESH_NONE);
  add("tangents", false, true, SHD_MESH_TANGENTS);
  add("tangents_mirrored", true, true, SHD_MESH_TANGENTS);
  add("tangents_unindexed", false, false, SHD_MESH_TANGENTS);
  const auto add_tessellate = [](const char* what, shd_tessellation_mode mode, uint32_t segments, float amplitude) {
    const std::string name = std::string("mesh/") + what + "/segments:" + std::to_string(segments);
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
      run_tessellate(state, mode, segments, amplitude);
    })->Unit(benchmark::kMillisecond);
  };
  add_tessellate("uniform", SHD_TESSELLATION_MODE_UNIFORM, 22, 0.0f);
  add_tessellate("adaptive", SHD_TESSELLATION_MODE_ADAPTIVE, 32, 0.0f);
  add_tessellate("displaced", SHD_TESSELLATION_MODE_UNIFORM, 22, 0.01f);
}

}  // namespace shd::bench
