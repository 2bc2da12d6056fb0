// SPDX-License-Identifier: MIT
// Rays through volumes: against the oracle, with the same bits on every target, with and without blocks that are
// skipped, and for every split into batches. Opacities, boxes and rays at their limits.
#include "unit/texture/fixture.h"

#include "ref/volume_ref.h"
#include "volume/march.h"

namespace {

using namespace fixture;
using shd::volume::Ray;

constexpr uint32_t kWidth = 61, kHeight = 40, kDepth = 33;
constexpr size_t kTestRays = 300;

float t_texels[kWidth * kHeight * kDepth];
shd::volume::March t_march;

/// Smooth densities with empty parts.
void make_density() {
  for (uint32_t i = 0; i < kWidth * kHeight * kDepth; ++i) {
    const double x = (i % kWidth) / double{kWidth} - 0.5, y = (i / kWidth % kHeight) / double{kHeight} - 0.5;
    const double z = (i / kWidth / kHeight) / double{kDepth} - 0.4;
    const double value = 1 - 9 * (x * x + y * y + z * z) + 0.3 * sin(9 * x + 5 * y);
    t_texels[i] = static_cast<float>(fmax(value, 0));
  }
}

Texture* make_solid() {
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = SHD_FORMAT_R32F;
  desc.width = kWidth;
  desc.height = kHeight;
  desc.depth = kDepth;
  desc.texels = t_texels;
  auto* texture = shd::core::create<Texture>(context()->allocator);
  shd::texture::build(*context(), desc, texture);
  return texture;
}

constexpr double k_points[4][5] = {
    {0.1, 0, 1, 0.5, 0.25}, {0.4, 3, 0.5, 1, 0.1}, {0.7, 0.5, 0.2, 0.3, 2}, {1.0, 30, 1, 1, 1}};

/// A volume that does not own its texture.
shd::volume::Volume* make_volume(const Texture& texture) {
  static float column[5][4];
  shd_volume_desc desc = shd_volume_desc_default();
  for (size_t i = 0; i < 4; ++i) {
    for (size_t c = 0; c < 5; ++c) column[c][i] = static_cast<float>(k_points[i][c]);
  }
  desc.point_count = 4;
  desc.density.data = column[0];
  desc.extinction.data = column[1];
  for (size_t c = 0; c < 3; ++c) desc.color[c].data = column[2 + c];
  auto* volume = shd::core::create<shd::volume::Volume>(context()->allocator);
  volume->texture = &texture;
  volume->material = nullptr;
  shd::volume::build(*context(), desc, volume);
  return volume;
}
void free_volume(shd::volume::Volume* volume) {
  shd::core::destroy(context()->allocator, volume);
}

/// Rays between two random points on a sphere around the box, some along an axis.
void make_rays(Ray* rays) {
  Random random{31};
  for (size_t i = 0; i < kTestRays; ++i) {
    Ray& ray = rays[i];
    ray.count = 1 + random.next() % 150;
    ray.offset = random.real(0, 1);
    ray.dt = random.real(0.01f, 0.2f);
    for (int c = 0; c < 3; ++c) {
      const float from = random.real(0, 1),
                  to = i % 7 == 0 && c != static_cast<int>(i / 7 % 3) ? from : random.real(0, 1);
      ray.origin[c] = from;
      ray.step[c] = (to - from) / static_cast<float>(ray.count);
      ray.world_origin[c] = ray.world_step[c] = 0;
    }
  }
}

void march_all(const shd::volume::Volume& volume, const Ray* rays, size_t batch, int64_t target, float (*out)[4]) {
  for (size_t first = 0; first < kTestRays; first += batch) {
    t_march.count = kTestRays - first < batch ? kTestRays - first : batch;
    memcpy(t_march.ray, rays + first, t_march.count * sizeof *rays);
    shd::volume::march(shd::core::simd_target_from_bit(target), volume, nullptr, &t_march);
    memcpy(out + first, t_march.color, t_march.count * sizeof *out);
  }
}

void test_march(void**) {
  static Ray rays[kTestRays];
  static float first[kTestRays][4], other[kTestRays][4];
  make_density();
  make_rays(rays);
  Texture* texture = make_solid();
  shd::volume::Volume* volume = make_volume(*texture);
  size_t skipped = 0;
  for (const uint8_t distance : volume->distance) skipped += distance > 0;
  assert_true(skipped > volume->distance.size() / 8);
  march_all(*volume, rays, shd::volume::kRays, hwy::SupportedAndGeneratedTargets()[0], first);
  for_each_target([&](int64_t target) {
    for (const size_t batch : {shd::volume::kRays, size_t{1}, size_t{7}}) {
      march_all(*volume, rays, batch, target, other);
      assert_memory_equal(first, other, sizeof first);
    }
  });
  volume->distance.fill_zero();  // skips nothing
  march_all(*volume, rays, shd::volume::kRays, hwy::SupportedAndGeneratedTargets()[0], other);
  assert_memory_equal(first, other, sizeof first);

  shd_sampler_desc sampler = shd_sampler_desc_default();
  sampler.wrap_u = sampler.wrap_v = sampler.wrap_w = SHD_WRAP_CLAMP;
  const ref::SolidLevel level = {reinterpret_cast<const uint8_t*>(t_texels), kWidth, kHeight, kDepth};
  const ref::Solid solid = {SHD_FORMAT_R32F, &level, 1, &sampler};
  size_t opaque = 0;
  for (size_t i = 0; i < kTestRays; ++i) {
    const Ray& r = rays[i];
    double want[4];
    const auto place = [](const float(&v)[3]) {
      return ref::Place{static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
    };
    ref::march(solid, {k_points, 4}, place(r.origin), place(r.step), static_cast<double>(r.offset),
               static_cast<double>(r.dt), static_cast<int>(r.count), want);
    opaque += want[3] > 0.999;
    // Where the opacity of both is near the limit, one of them may take a step more.
    const double slack = want[3] > 0.9985 ? 1.6e-3 : 4e-5;
    for (int c = 0; c < 4; ++c) shd_assert_close("ray", i, static_cast<double>(first[i][c]), want[c], slack, 0);
  }
  assert_true(opaque > 20);
  free_volume(volume);
  free_texture(texture);
}

/// Opacities keep their digits from 0 to infinity, and stay in [0, 1].
void test_opacity(void**) {
  static shd::volume::Transfer function;
  alignas(64) static float density[256], dt[256], out[4][256];
  function.count = 1;
  function.point[0] = {0, 0, {1, 0.5f, 0.25f, 2}, {0, 0, 0, 0}};
  for (size_t i = 0; i < 256; ++i) {
    density[i] = i % 2 ? 5.0f : -5.0f;
    dt[i] = i < 2 ? 0 : i > 252 ? INFINITY : exp2f(static_cast<float>(i) / 5.0f - 40);
  }
  for_each_target([&](int64_t target) {
    shd::volume::transfer(shd::core::simd_target_from_bit(target), function, density, dt, 256,
                          {out[0], {out[1], out[2], out[3]}});
    for (size_t i = 0; i < 256; ++i) {
      const double want = -expm1(-static_cast<double>(dt[i]));
      shd_assert_close("opacity", i, static_cast<double>(out[0][i]), want, 0, 4e-7);
      assert_true(out[0][i] >= 0 && out[0][i] <= 1);
      assert_true(out[1][i] == 0.5f && out[3][i] == 2);
    }
  });
}

/// Values between points, at jumps, outside and for densities that are not finite.
void test_transfer(void**) {
  static shd::volume::Transfer function;
  const float point[5] = {-1, 0.5f, 0.5f, 2, 3e38f}, sigma[5] = {1, 2, 7, 8, 9};
  alignas(64) static float density[64], dt[64], out[4][64];
  function.count = 5;
  for (size_t i = 0; i < 5; ++i) {
    const double width = i < 4 ? static_cast<double>(point[i + 1]) - static_cast<double>(point[i]) : 0;
    function.density[i] = point[i];
    function.point[i] = {point[i],
                         width > 0 ? static_cast<float>(1 / width) : 0,
                         {sigma[i], 0, 0, sigma[i]},
                         {i < 4 ? sigma[i + 1] - sigma[i] : 0, 0, 0, i < 4 ? sigma[i + 1] - sigma[i] : 0}};
  }
  const float in[] = {-INFINITY, -3e38f, -1, -0.25f, 0.49999997f, 0.5f, 1.25f, 2, 1e38f, 3e38f, INFINITY, NAN, 0};
  const float want[] = {1, 1, 1, 1.5f, 2, 7, 7.5f, 8, 8.3333333f, 9, 9, 1.6666667f, 1.6666667f};
  memcpy(density, in, sizeof in);
  for_each_target([&](int64_t target) {
    shd::volume::transfer(shd::core::simd_target_from_bit(target), function, density, dt, 13,
                          {out[0], {out[1], out[2], out[3]}});
    for (size_t i = 0; i < 13; ++i) {
      shd_assert_close("value", i, static_cast<double>(out[3][i]), static_cast<double>(want[i]), 0, 1e-6);
      assert_true(out[0][i] == 0);  // dt = 0
    }
  });
  function.point[0].value[0] = function.point[1].value[0] = function.point[0].slope[0] = 0;
  function.point[1].slope[0] = 7;
  assert_false(shd::volume::is_visible(function, -9, 0.25f));
  assert_true(shd::volume::is_visible(function, -9, 0.5f));
  assert_true(shd::volume::is_visible(function, 0.75f, 0.75f));
}

struct box_case {
  const char* name;
  double origin[3], direction[3], end;
  float step;
  uint32_t count;  // 0 = no ray
  double length;
};
const box_case k_boxes[] = {
    {"through", {-1, 0.5, 0.5}, {1, 0, 0}, 100, 0.25f, 4, 1},
    {"from_inside", {0.25, 0.5, 0.5}, {1, 0, 0}, 100, 0.25f, 3, 0.75},
    {"ends_inside", {-1, 0.5, 0.5}, {1, 0, 0}, 1.5, 0.25f, 2, 0.5},
    {"ends_before", {-1, 0.5, 0.5}, {1, 0, 0}, 1, 0.25f, 0, 0},
    {"behind", {2, 0.5, 0.5}, {1, 0, 0}, 100, 0.25f, 0, 0},
    {"beside", {-1, 1.5, 0.5}, {1, 0, 0}, 100, 0.25f, 0, 0},
    {"in_a_face", {-1, 1, 0.5}, {1, 0, 0}, 100, 0.25f, 4, 1},
    {"beyond_a_face", {-1, 1 + 1e-9, 0.5}, {1, 0, 0}, 100, 0.25f, 0, 0},
    {"along_an_edge", {-1, 0, 0}, {1, 0, 0}, 100, 0.3f, 4, 1},
    {"through_a_corner", {-1, 1, 0.5}, {0.70710678, -0.70710678, 0}, 100, 1, 0, 0},
    {"endless", {-1, 0.5, 0.5}, {1, 0, 0}, INFINITY, 1e12f, 1, 1},
    {"tiny_steps", {-1, 0.5, 0.5}, {1, 0, 0}, 100, 1e-30f, SHD_MAX_VOLUME_STEPS, 1},
    {"smallest_step", {-1, 0.5, 0.5}, {1, 0, 0}, 100, 1e-45f, SHD_MAX_VOLUME_STEPS, 1},
    {"nan_origin", {NAN, 0.5, 0.5}, {1, 0, 0}, 100, 0.25f, 0, 0},
    {"nan_direction", {-1, 0.5, 0.5}, {NAN, 0, 0}, 100, 0.25f, 0, 0},
    {"nan_end", {-1, 0.5, 0.5}, {1, 0, 0}, NAN, 0.25f, 0, 0},
};

void test_box(void** state) {
  const auto& c = *static_cast<const box_case*>(*state);
  const float identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  const double low[3] = {0, 0, 0}, high[3] = {1, 1, 1};
  shd::volume::WorldToBox box;
  assert_true(shd::volume::make_world_to_box(identity, low, high, &box));
  const shd::volume::Sight sight = {
      {c.origin[0], c.origin[1], c.origin[2]}, {c.direction[0], c.direction[1], c.direction[2]}, INFINITY, true};
  Ray ray = {};
  const bool found = shd::volume::make_ray(sight, box, c.end, c.step, &ray);
  assert_int_equal(found, c.count != 0);
  if (!found) return;
  assert_int_equal(ray.count, c.count);
  shd_assert_close(c.name, 0, static_cast<double>(ray.dt) * ray.count, c.length, 1e-6, 0);
}

void test_matrices(void**) {
  const double low[3] = {-1, 0, 2}, high[3] = {1, 4, 3};
  float matrix[16] = {2, 0, 0, 0, 0, 1, 0, 0, 0.5f, 0, 1, 0, 5, 6, 7, 1};
  shd::volume::WorldToBox box;
  assert_true(shd::volume::make_world_to_box(matrix, low, high, &box));
  // The corner (1, 4, 3) of the box in the world.
  const double world[3] = {2 * 1 + 0.5 * 3 + 5, 4 + 6, 3 + 7};
  for (int r = 0; r < 3; ++r) {
    double at = box.row[r][3];
    for (int k = 0; k < 3; ++k) at += box.row[r][k] * world[k];
    shd_assert_close("corner", static_cast<size_t>(r), at, 1, 1e-12, 0);
  }
  matrix[0] = 0;
  assert_false(shd::volume::make_world_to_box(matrix, low, high, &box));
}

}  // namespace

int main() {
  CMUnitTest tests[32];
  size_t n = 0;
  tests[n++] = {"march", test_march, nullptr, nullptr, nullptr};
  tests[n++] = {"opacity", test_opacity, nullptr, nullptr, nullptr};
  tests[n++] = {"transfer", test_transfer, nullptr, nullptr, nullptr};
  tests[n++] = {"matrices", test_matrices, nullptr, nullptr, nullptr};
  for (const box_case& c : k_boxes) {
    tests[n++] = {c.name, test_box, nullptr, nullptr, const_cast<box_case*>(&c)};
  }
  return _cmocka_run_group_tests("unit.volume.march", tests, n, nullptr, nullptr);
}
