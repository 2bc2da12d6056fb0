// SPDX-License-Identifier: MIT
#include "workload.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>

namespace shd::bench {
namespace {

std::map<std::string, double>& rates() {
  static std::map<std::string, double> map;
  return map;
}

void append_vertex(Spheres& s, uint32_t slice, uint32_t stack) {
  const float phi = 6.28318531f * static_cast<float>(slice) / static_cast<float>(s.slices);
  const float theta = 3.14159265f * static_cast<float>(stack) / static_cast<float>(s.stacks);
  s.position[0].push_back(std::sin(theta) * std::cos(phi));
  s.position[1].push_back(std::cos(theta));
  s.position[2].push_back(-std::sin(theta) * std::sin(phi));
  s.uv[0].push_back(2.0f * static_cast<float>(slice) / static_cast<float>(s.slices));
  s.uv[1].push_back(static_cast<float>(stack) / static_cast<float>(s.stacks));
}

void append_quad(Spheres& s, uint32_t slice, uint32_t stack) {
  const uint32_t row = s.slices + 1;
  const uint32_t a = stack * row + slice, b = a + row;
  if (stack > 0) s.indices.insert(s.indices.end(), {a, b, a + 1});
  if (stack + 1 < s.stacks) s.indices.insert(s.indices.end(), {a + 1, b, b + 1});
}

/// Turns a point by 45 degrees.
void turn(float* u, float* v) {
  constexpr float kRoot = 0.70710678f;
  const float x = *u, y = *v;
  *u = kRoot * (x - y);
  *v = kRoot * (x + y);
}

}  // namespace

std::vector<uint8_t> make_rgba8(uint32_t edge) {
  std::mt19937 random(1);
  std::vector<uint8_t> texels(size_t{edge} * edge * 4);
  for (uint32_t y = 0; y < edge; ++y) {
    for (uint32_t x = 0; x < edge; ++x) {
      const float fx = 6.28318531f * static_cast<float>(x) / static_cast<float>(edge);
      const float fy = 6.28318531f * static_cast<float>(y) / static_cast<float>(edge);
      const float waves[4] = {std::sin(8.0f * fx), std::sin(5.0f * fy), std::sin(3.0f * fx + 4.0f * fy), 1.0f};
      for (int c = 0; c < 4; ++c) {
        const float noise = static_cast<float>(random() % 64) - 32.0f;
        const float value = c == 3 ? 255.0f : 150.0f + 60.0f * waves[c] + noise;
        texels[(size_t{y} * edge + x) * 4 + c] = static_cast<uint8_t>(value);
      }
    }
  }
  return texels;
}

Surface floor_surface(const Floor& floor) {
  Surface surface = {};
  for (int corner = 0; corner < 4; ++corner) {
    const bool right = corner & 1, bottom = corner & 2;
    const float z = floor.z(bottom ? floor.edge() : 0.0f);
    const float clip[4] = {right ? z : -z, bottom ? -z : z, 0.0f, z};
    std::copy_n(clip, 4, surface.clip[corner]);
    surface.uv[corner][0] = floor.u(right ? floor.edge() : 0.0f, z);
    surface.uv[corner][1] = floor.v(z);
  }
  return surface;
}

Surface quad_surface(float repeat) {
  Surface surface = {};
  for (int corner = 0; corner < 4; ++corner) {
    const bool right = corner & 1, bottom = corner & 2;
    const float clip[4] = {right ? 1.0f : -1.0f, bottom ? -1.0f : 1.0f, 0.0f, 1.0f};
    std::copy_n(clip, 4, surface.clip[corner]);
    surface.uv[corner][0] = right ? repeat : 0.0f;
    surface.uv[corner][1] = bottom ? repeat : 0.0f;
  }
  return surface;
}

Lookups floor_lookups(const Floor& floor) {
  Lookups q;
  for (std::vector<float>* column : {&q.u, &q.v, &q.dudx, &q.dvdx, &q.dudy, &q.dvdy}) {
    column->resize(size_t{floor.frame} * floor.frame);
  }
  for (uint32_t y = 0; y < floor.frame; ++y) {
    const float z = floor.z(static_cast<float>(y) + 0.5f);
    const float dzdy = -z * z * (1.0f - 1.0f / floor.far) / floor.edge();
    for (uint32_t x = 0; x < floor.frame; ++x) {
      const size_t i = size_t{y} * floor.frame + x;
      q.u[i] = floor.u(static_cast<float>(x) + 0.5f, z);
      q.v[i] = floor.v(z);
      q.dudx[i] = floor.scale * z / floor.edge();
      q.dvdx[i] = 0.0f;
      q.dudy[i] = floor.u(static_cast<float>(x) + 0.5f, dzdy);
      q.dvdy[i] = floor.scale * dzdy;
      if (!floor.turned) continue;
      turn(&q.u[i], &q.v[i]);
      turn(&q.dudx[i], &q.dvdx[i]);
      turn(&q.dudy[i], &q.dvdy[i]);
    }
  }
  return q;
}

Lookups random_lookups(uint32_t edge, float texels) {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  Lookups q;
  q.u.resize(kLookupCount);
  q.v.resize(kLookupCount);
  for (size_t i = 0; i < kLookupCount; ++i) {
    q.u[i] = uniform(random);
    q.v[i] = uniform(random);
  }
  q.dudx.assign(kLookupCount, texels / static_cast<float>(edge));
  q.dvdy = q.dudx;
  q.dvdx.assign(kLookupCount, 0.0f);
  q.dudy = q.dvdx;
  return q;
}

Spheres make_spheres(const std::string& name, uint32_t slices, uint32_t stacks, uint32_t per_axis) {
  Spheres s;
  s.name = name;
  s.slices = slices;
  s.stacks = stacks;
  s.per_axis = per_axis;
  for (uint32_t stack = 0; stack <= stacks; ++stack) {
    for (uint32_t slice = 0; slice <= slices; ++slice) append_vertex(s, slice, stack);
  }
  for (uint32_t stack = 0; stack < stacks; ++stack) {
    for (uint32_t slice = 0; slice < slices; ++slice) append_quad(s, slice, stack);
  }
  const float cell = 2.0f / static_cast<float>(per_axis), radius = 0.47f * cell;
  for (uint32_t i = 0; i < s.sphere_count(); ++i) {
    const uint32_t place[3] = {i % per_axis, i / per_axis % per_axis, i / per_axis / per_axis};
    float matrix[16] = {};
    for (int k = 0; k < 3; ++k) {
      matrix[5 * k] = radius;
      matrix[12 + k] = -1.0f + cell * (static_cast<float>(place[k]) + 0.5f);
    }
    matrix[15] = 1.0f;
    s.object_to_world.insert(s.object_to_world.end(), matrix, matrix + 16);
  }
  shd_camera camera = shd_camera_default();
  const float eye[3] = {1.45f, 1.25f, 2.7f};
  std::copy(eye, eye + 3, camera.eye);
  camera.near_plane = 0.5f;
  camera.far_plane = 20.0f;
  if (shd_view_from_camera(&camera, &s.view) != SHD_OK) std::abort();
  return s;
}

Spheres merge(const std::string& name, const Spheres& spheres) {
  Spheres out = make_spheres(name, spheres.slices, spheres.stacks, 1);
  out.indices.clear();
  for (int k = 0; k < 3; ++k) out.position[k].clear();
  for (auto& uv : out.uv) uv.clear();
  out.object_to_world = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  for (size_t i = 0; i < spheres.sphere_count(); ++i) {
    const float* matrix = &spheres.object_to_world[16 * i];
    const auto first = static_cast<uint32_t>(out.position[0].size());
    for (int k = 0; k < 3; ++k) {
      for (const float x : spheres.position[k]) out.position[k].push_back(matrix[5 * k] * x + matrix[12 + k]);
    }
    for (int k = 0; k < 2; ++k) out.uv[k].insert(out.uv[k].end(), spheres.uv[k].begin(), spheres.uv[k].end());
    for (const uint32_t index : spheres.indices) out.indices.push_back(first + index);
  }
  return out;
}

Difference compare(const std::vector<float>& a, const std::vector<float>& b) {
  Difference d;
  size_t count = 0;
  for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (i % 4 == 3) continue;
    const double difference = std::fabs(std::clamp(a[i], 0.0f, 1.0f) - std::clamp(b[i], 0.0f, 1.0f));
    d.mean += difference;
    d.max = std::max(d.max, difference);
    ++count;
  }
  d.mean /= static_cast<double>(std::max<size_t>(count, 1));
  return d;
}

void maybe_write(const std::string& name, const std::vector<float>& rgba) {
  const char* folder = std::getenv("SHD_BENCH_WRITE");
  std::FILE* file = folder ? std::fopen((std::string(folder) + "/" + name + ".ppm").c_str(), "wb") : nullptr;
  if (!file) return;
  const auto edge = static_cast<unsigned>(std::lround(std::sqrt(static_cast<double>(rgba.size() / 4))));
  std::fprintf(file, "P6\n%u %u\n255\n", edge, edge);
  for (size_t i = 0; i < rgba.size(); ++i) {
    if (i % 4 != 3) std::fputc(static_cast<int>(std::clamp(rgba[i], 0.0f, 1.0f) * 255.0f + 0.5f), file);
  }
  std::fclose(file);
}

void record_rate(const std::string& row, double items_per_second) {
  rates()[row] = items_per_second;
}

double recorded_rate(const std::string& row) {
  const auto found = rates().find(row);
  return found == rates().end() ? 0.0 : found->second;
}

}  // namespace shd::bench
