// SPDX-License-Identifier: MIT
// Metrics of pairs whose values are known.
#include <cmath>
#include <cstdio>

#include "../metrics/metrics.h"
#include "../report/json.h"
#include "../report/png.h"
#include "../truth.h"

namespace shootout {
namespace {

int failures = 0;

void expect(const char* what, double got, double want, double tolerance) {
  if (std::fabs(got - want) <= tolerance) return;
  std::printf("%s: %.9g, not %.9g\n", what, got, want);
  ++failures;
}

Picture uniform(uint32_t edge, float r, float g, float b) {
  Picture picture(edge, edge);
  for (size_t i = 0; i < picture.pixels(); ++i) {
    picture.rgb[3 * i] = r;
    picture.rgb[3 * i + 1] = g;
    picture.rgb[3 * i + 2] = b;
  }
  return picture;
}

/// A grey wave along x of `cycles` cycles a picture around 1/2.
void add_wave(Picture* picture, double cycles, double amplitude) {
  for (uint32_t y = 0; y < picture->height; ++y) {
    for (uint32_t x = 0; x < picture->width; ++x) {
      const double value = amplitude * std::sin(2.0 * 3.14159265358979 * cycles * x / picture->width);
      for (size_t c = 0; c < 3; ++c) picture->at(x, y)[c] += static_cast<float>(value);
    }
  }
}

void test_differences() {
  const Picture a = uniform(16, 0.5f, 0.5f, 0.5f), b = uniform(16, 0.6f, 0.6f, 0.6f);
  expect("psnr of a tenth", psnr(a, b), 20.0, 1e-4);
  expect("psnr of equal pictures", psnr(a, a), kBestPsnr, 0.0);
  Picture spot = a;
  spot.at(3, 5)[1] = 1.0f;
  expect("mean of a spot", difference(spot, a).mean, 0.5 / (16 * 16 * 3), 1e-9);
  expect("max of a spot", difference(spot, a).max, 0.5, 0.0);
  expect("psnr of a spot", psnr(spot, a), -10.0 * std::log10(0.25 / (16 * 16 * 3)), 1e-6);
}

void test_ssim() {
  const Picture a = uniform(32, 0.5f, 0.5f, 0.5f), b = uniform(32, 0.6f, 0.6f, 0.6f);
  // Without variance it is (2 a b + C1) / (a^2 + b^2 + C1), C1 = 0.01^2.
  expect("ssim of greys", ssim(a, b), 0.6001 / 0.6101, 1e-4);
  Picture wave = a, inverse = a;
  add_wave(&wave, 8, 0.4);
  add_wave(&inverse, 8, -0.4);
  expect("ssim of equal waves", ssim(wave, wave), 1.0, 1e-9);
  expect("ssim of opposite waves", ssim(wave, inverse), -0.99, 0.02);
}

double flip_of(const Picture& a, const Picture& b) {
  return mean_of(flip_map(flip_input(a), flip_input(b)));
}

void test_flip() {
  // Uniform pictures have no features, so the error is the paper's colour term. The values follow from its equations
  // and CIELAB by hand.
  const Picture black = uniform(40, 0, 0, 0), white = uniform(40, 1, 1, 1);
  expect("flip of equal pictures", flip_of(white, white), 0.0, 0.0);
  expect("flip of black and white", flip_of(black, white), 0.9674, 1e-3);
  expect("flip of greys", flip_of(uniform(40, 0.5f, 0.5f, 0.5f), uniform(40, 0.6f, 0.6f, 0.6f)), 0.2850, 1e-3);
  expect("flip of red and cyan", flip_of(uniform(40, 1, 0, 0), uniform(40, 0, 1, 1)), 0.9799, 1e-3);
  expect("flip of green and blue, the largest", flip_of(uniform(40, 0, 1, 0), uniform(40, 0, 0, 1)), 1.0, 1e-3);
  // Edges that only one picture has raise the error beyond that of the colours.
  Picture wave = uniform(40, 0.5f, 0.5f, 0.5f);
  add_wave(&wave, 4, 0.2);
  const FlipInput grey = flip_input(uniform(40, 0.5f, 0.5f, 0.5f)), waves = flip_input(wave);
  FlipInput without_features = waves;
  without_features.edges = grey.edges;
  without_features.points = grey.points;
  const double with = mean_of(flip_map(waves, grey)), without = mean_of(flip_map(without_features, grey));
  if (!(with > 1.05 * without)) {
    std::printf("flip: edges do not raise the error: %g, %g\n", with, without);
    ++failures;
  }
  expect("flip, both ways round", mean_of(flip_map(grey, waves)), with, 1e-12);
}

void test_spectrum() {
  // Four values a pixel: 64 pixels. 8 cycles lie below the Nyquist frequency of 32 cycles, 96 above it.
  Picture truth = uniform(256, 0.5f, 0.5f, 0.5f), weak = truth, aliased = truth;
  add_wave(&truth, 8, 0.2);
  add_wave(&weak, 8, 0.1);
  add_wave(&aliased, 8, 0.2);
  add_wave(&aliased, 96, 0.1);
  expect("blur of equal pictures", spectrum(truth, truth, 4).blur, 0.0, 1e-12);
  expect("blur of half the contrast", spectrum(weak, truth, 4).blur, 0.75, 1e-3);
  expect("aliasing of half the contrast", spectrum(weak, truth, 4).aliasing, 0.0, 1e-6);
  expect("aliasing of a fine wave", spectrum(aliased, truth, 4).aliasing, 0.25, 1e-3);
  expect("blur of a fine wave", spectrum(aliased, truth, 4).blur, 0.0, 1e-3);
  double values[16] = {};
  values[2] = 1.0;  // a step of one sample turns by 45 degrees a frequency
  fourier(values, 8);
  expect("fourier, real part", values[2 * 3], std::cos(3 * 3.14159265358979 / 4), 1e-12);
  expect("fourier, imaginary part", values[2 * 3 + 1], -std::sin(3 * 3.14159265358979 / 4), 1e-12);
}

void test_motion() {
  constexpr uint32_t kEdge = 4, kColumns = 2, kFrames = 6;
  Picture truth(kEdge * kColumns, kEdge * 3), constant = truth, blinking = truth;
  for (uint32_t y = 0; y < truth.height; ++y) {
    for (uint32_t x = 0; x < truth.width; ++x) {
      const bool odd = (y / kEdge * kColumns + x / kEdge) & 1;
      std::fill(constant.at(x, y), constant.at(x, y) + 3, 0.1f);
      std::fill(blinking.at(x, y), blinking.at(x, y) + 3, odd ? 0.1f : -0.1f);
    }
  }
  expect("flicker of a constant error", motion(constant, truth, kEdge, kColumns, kFrames).flicker, 0.0, 1e-7);
  expect("psnr of a constant error", motion(constant, truth, kEdge, kColumns, kFrames).psnr, 20.0, 1e-4);
  expect("flicker of a blinking error", motion(blinking, truth, kEdge, kColumns, kFrames).flicker, 0.4, 1e-6);
}

void test_truth() {
  const Texture text = make_texture("text", 128, "");
  const Workload plane = plane_workload(16, 128, 3.0, 0.4, {0.1, 0.2}, "plane", "");
  const Picture coarse = supersample(plane, text, 16), fine = supersample(plane, text, 16, 4);
  double largest = 0.0;
  for (uint32_t y = 0; y < 16; ++y) {
    for (uint32_t x = 0; x < 16; ++x) {
      for (size_t c = 0; c < 3; ++c) {
        largest = std::max(largest, std::fabs(static_cast<double>(coarse.at(x, y)[c] - fine.at(4 * x, 4 * y)[c])));
      }
    }
  }
  expect("samples at the centres of pixels, by both ways", largest, 0.0, 1e-6);
}

void test_formats() {
  Json json;
  json.begin_object()
      .member("a\"<", std::nan(""))
      .key("b")
      .begin_array()
      .value(1.5)
      .value("x\n")
      .end_array()
      .end_object();
  if (json.text() != "{\"a\\u0022\\u003c\":null,\"b\":[1.5,\"x\\u000a\"]}") {
    std::printf("json: %s\n", json.text().c_str());
    ++failures;
  }
  const std::string uri = data_uri("shd!");
  if (uri != "data:image/png;base64,c2hkIQ==") {
    std::printf("base64: %s\n", uri.c_str());
    ++failures;
  }
  if (hash_of("", 0) != "cbf29ce484222325" || hash_of("a", 1) != "af63dc4c8601ec8c") {
    std::printf("hash: not FNV-1a\n");
    ++failures;
  }
}

}  // namespace
}  // namespace shootout

int main() {
  using namespace shootout;
  test_differences();
  test_ssim();
  test_flip();
  test_spectrum();
  test_motion();
  test_truth();
  test_formats();
  if (failures == 0) std::printf("metrics: all checks passed\n");
  return failures == 0 ? 0 : 1;
}
