// SPDX-License-Identifier: MIT
// Lookups of lavapipe beside those of shd with the rules of Vulkan, on small textures. Exits 77, the code of a skipped
// test, where lavapipe is missing.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <stdexcept>

#include "../settings.h"
#include "../shd_pass.h"

namespace {

#ifdef SHD_BENCH_LAVAPIPE

using shd::bench::Lookups;
using shd::bench::PeerFilter;

constexpr uint32_t kEdge = 32;
int failures = 0;

void expect(bool good, const char* what, double value) {
  if (good) return;
  std::printf("%s: %.9g\n", what, value);
  ++failures;
}

shootout::Texture noise() {
  shootout::Texture texture;
  texture.edge = kEdge;
  std::mt19937 random(7);
  for (size_t i = 0; i < size_t{kEdge} * kEdge * 4; ++i) texture.rgba.push_back(static_cast<uint8_t>(random()));
  return texture;
}

/// Stripes of two texels along v.
shootout::Texture stripes() {
  shootout::Texture texture;
  texture.edge = kEdge;
  for (size_t i = 0; i < size_t{kEdge} * kEdge; ++i) texture.rgba.insert(texture.rgba.end(), 4, i & 2 ? 255 : 0);
  return texture;
}

/// Random places from -2 to 3. Axes are of x and y texels times a factor of 0.8..1.2, so that nearest levels are clear.
Lookups lookups(size_t count, float x, float y) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> place(-2.0f, 3.0f), factor(0.8f, 1.2f);
  Lookups q;
  for (size_t i = 0; i < count; ++i) {
    const float scale = factor(random) / static_cast<float>(kEdge);
    q.u.push_back(place(random));
    q.v.push_back(place(random));
    q.dudx.push_back(x * scale);
    q.dvdx.push_back(0.0f);
    q.dudy.push_back(0.0f);
    q.dvdy.push_back(y * scale);
  }
  return q;
}

std::vector<float> lavapipe(const shootout::Texture& texture, const Lookups& q, PeerFilter filter) {
  const auto pass = shd::bench::make_lavapipe(q, texture.edge, texture.rgba, filter);
  pass->run();
  return pass->image();
}

/// The largest difference from shd's filter.
double largest_difference(const Lookups& q, shd_filter filter, PeerFilter peer) {
  const shootout::Texture texture = noise();
  shootout::Setting setting;
  setting.sampler = shd_sampler_desc_default();
  setting.sampler.filter = filter;
  setting.sampler.profile = SHD_PROFILE_VULKAN;
  const std::vector<float> want = shootout::ShdPass(texture, setting).filter(q), got = lavapipe(texture, q, peer);
  double largest = want.size() == got.size() ? 0.0 : 1.0;
  for (size_t i = 0; i < std::min(want.size(), got.size()); ++i) {
    largest = std::max(largest, std::fabs(static_cast<double>(want[i]) - static_cast<double>(got[i])));
  }
  return largest;
}

void test_texels() {
  constexpr double kEqual = 1e-6;  // the last bits of a byte / 255
  constexpr double kStep = 1.0 / 255.0;
  for (const size_t count : {1, 5, 255, 257, 4000}) {
    const double d = largest_difference(lookups(count, 1.0f, 1.0f), SHD_FILTER_NEAREST, PeerFilter::kNearest);
    expect(d < kEqual, "nearest differs by", d);
  }
  for (float texels = 1.0f; texels <= kEdge; texels *= 2.0f) {
    const Lookups q = lookups(1000, texels, texels);
    const double d = largest_difference(q, SHD_FILTER_NEAREST_MIP, PeerFilter::kNearestMip);
    expect(d < kEqual, "nearest of the nearest level differs by", d);
  }
  const Lookups q = lookups(4000, 4.0f, 4.0f);
  // Mesa has logarithms of a few digits, and fractions of 8 bits.
  double d = largest_difference(q, SHD_FILTER_BILINEAR, PeerFilter::kBilinear);
  expect(d < 2.0 * kStep, "bilinear differs by", d);
  d = largest_difference(q, SHD_FILTER_TRILINEAR, PeerFilter::kTrilinear);
  expect(d < 8.0 * kStep, "trilinear differs by", d);
}

/// The range of values over the stripes.
double contrast(PeerFilter filter, float x, float y) {
  const std::vector<float> rgba = lavapipe(stripes(), lookups(1000, x, y), filter);
  const auto [low, high] = std::minmax_element(rgba.begin(), rgba.end());
  return static_cast<double>(*high) - static_cast<double>(*low);
}

/// The anisotropic filter keeps stripes along the longer axis, and averages stripes across it.
void test_axes() {
  const double along = contrast(PeerFilter::kAnisotropic16, 1.0f, 8.0f);
  const double across = contrast(PeerFilter::kAnisotropic16, 8.0f, 1.0f);
  expect(along > 0.8, "anisotropic, stripes along the longer axis: contrast", along);
  expect(across < 0.4, "anisotropic, stripes across the longer axis: contrast", across);
  const double isotropic = contrast(PeerFilter::kTrilinear, 1.0f, 8.0f);
  expect(isotropic < 0.1, "trilinear, stripes along the longer axis: contrast", isotropic);
}

/// A lookup does not depend on the lookups next to it, whose levels are others.
void test_neighbours() {
  const shootout::Texture texture = noise();
  Lookups all = lookups(16, 2.0f, 1.0f);
  for (size_t i = 0; i < all.count(); ++i) {
    all.dudx[i] *= static_cast<float>(1u << i % 5);
    all.dvdy[i] *= static_cast<float>(1u << i % 4);
  }
  for (const PeerFilter filter : {PeerFilter::kNearestMip, PeerFilter::kTrilinear, PeerFilter::kAnisotropic16}) {
    const std::vector<float> together = lavapipe(texture, all, filter);
    for (size_t i = 0; i < all.count(); ++i) {
      Lookups one = {{all.u[i]}, {all.v[i]}, {all.dudx[i]}, {all.dvdx[i]}, {all.dudy[i]}, {all.dvdy[i]}, {}};
      const std::vector<float> alone = lavapipe(texture, one, filter);
      const auto near = [](float a, float b) { return std::fabs(a - b) < 1e-5f; };
      const bool equal = std::equal(alone.begin(), alone.end(), together.begin() + static_cast<ptrdiff_t>(4 * i), near);
      expect(equal, "neighbours change lookup", static_cast<double>(i));
    }
  }
}

void test_refresh() {
  const shootout::Texture texture = noise();
  Lookups q = lookups(64, 1.0f, 1.0f);
  const auto pass = shd::bench::make_lavapipe(q, texture.edge, texture.rgba, PeerFilter::kNearest);
  pass->run();
  const std::vector<float> before = pass->image();
  std::reverse(q.u.begin(), q.u.end());
  std::reverse(q.v.begin(), q.v.end());
  pass->refresh();
  pass->run();
  const std::vector<float> after = pass->image();
  for (size_t i = 0; i < before.size(); i += 4) {
    const bool equal = std::equal(&before[i], &before[i] + 4, &after[before.size() - 4 - i]);
    expect(equal, "new lookups are not filtered, number", static_cast<double>(i / 4));
  }
}

void test_empty() {
  try {
    lavapipe(noise(), Lookups(), PeerFilter::kNearest);
    expect(false, "lookups are accepted, number", 0.0);
  } catch (const std::runtime_error& e) {
    expect(std::string(e.what()).find("lookups.count: 0") != std::string::npos, e.what(), 0.0);
  }
}

int run() {
  const std::string problem = shd::bench::lavapipe_problem();
  if (!problem.empty()) {
    std::printf("skipped: %s (Debian package mesa-vulkan-drivers)\n", problem.c_str());
    return 77;
  }
  std::printf("%s\n", shd::bench::lavapipe_description().c_str());
  test_texels();
  test_axes();
  test_neighbours();
  test_refresh();
  test_empty();
  if (failures == 0) std::printf("lavapipe: all checks passed\n");
  return failures ? 1 : 0;
}

#else

int run() {
  std::printf("skipped: built without lavapipe (Debian packages libvulkan-dev, glslang-tools)\n");
  return 77;
}

#endif

}  // namespace

int main() {
  return run();
}
