// SPDX-License-Identifier: MIT
// LDR-FLIP after Andersson et al., "FLIP: A Difference Evaluator for Alternating Images" (2020). Section numbers are
// the paper's.
#include <cmath>

#include "convolve.h"
#include "metrics.h"

namespace shootout {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kWhite[3] = {0.950428545, 1.0, 1.088900371};  // D65 of linear sRGB (1, 1, 1)

using Colour = std::array<double, 3>;
using Planes = std::vector<Plane>;

double linear(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

Colour xyz_of(const Colour& rgb) {
  return {0.41238656 * rgb[0] + 0.35759149 * rgb[1] + 0.18045049 * rgb[2],
          0.21263682 * rgb[0] + 0.71518298 * rgb[1] + 0.07218020 * rgb[2],
          0.01933062 * rgb[0] + 0.11919716 * rgb[1] + 0.95037259 * rgb[2]};
}

Colour linear_of(const Colour& xyz) {
  return {3.24100326 * xyz[0] - 1.53739899 * xyz[1] - 0.49861587 * xyz[2],
          -0.96922426 * xyz[0] + 1.87592999 * xyz[1] + 0.04155422 * xyz[2],
          0.05563942 * xyz[0] - 0.20401120 * xyz[1] + 1.05714897 * xyz[2]};
}

/// YyCxCz, the linear opponent space of the contrast sensitivity functions (4.1.1).
Colour opponent_of(const Colour& xyz) {
  const double x = xyz[0] / kWhite[0], y = xyz[1] / kWhite[1], z = xyz[2] / kWhite[2];
  return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

Colour xyz_of_opponent(const Colour& c) {
  const double y = (c[0] + 16.0) / 116.0;
  return {(y + c[1] / 500.0) * kWhite[0], y * kWhite[1], (y - c[2] / 200.0) * kWhite[2]};
}

/// CIELAB with the Hunt effect: chroma is scaled by lightness (4.1.2).
Colour hunt_lab_of(const Colour& xyz) {
  const auto f = [](double t) {
    constexpr double kDelta = 6.0 / 29.0;
    return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3.0 * kDelta * kDelta) + 4.0 / 29.0;
  };
  const double x = f(xyz[0] / kWhite[0]), y = f(xyz[1] / kWhite[1]), z = f(xyz[2] / kWhite[2]);
  const double lightness = 116.0 * y - 16.0;
  return {lightness, 0.01 * lightness * 500.0 * (x - y), 0.01 * lightness * 200.0 * (y - z)};
}

/// HyAB: city-block distance of lightness and chroma (Abasi, Tehran and Fairchild 2020).
double distance(const Colour& a, const Colour& b) {
  return std::fabs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

Planes opponent_planes(const Picture& picture) {
  Planes planes(3, Plane(static_cast<int>(picture.width), static_cast<int>(picture.height)));
  for (size_t i = 0; i < picture.pixels(); ++i) {
    Colour rgb;
    for (size_t c = 0; c < 3; ++c) rgb[c] = linear(static_cast<double>(picture.rgb[3 * i + c]));
    const Colour opponent = opponent_of(xyz_of(rgb));
    for (size_t c = 0; c < 3; ++c) planes[c].values[i] = static_cast<float>(opponent[c]);
  }
  return planes;
}

/// One Gaussian of a contrast sensitivity function: amplitude and width of its spectrum.
struct Lobe {
  double a, b;
};

/// Filters a plane with the sum of the lobes; the kernel sums to 1.
Plane sensitivity(const Plane& plane, const std::vector<Lobe>& lobes, double pixels_per_degree) {
  constexpr double kWidest = 0.04;  // widest lobe; it sets the radius of every kernel
  const int radius = static_cast<int>(std::ceil(3.0 * std::sqrt(kWidest / (2.0 * kPi * kPi)) * pixels_per_degree));
  Plane out(plane.width, plane.height);
  double total = 0.0;
  for (const Lobe& lobe : lobes) {
    std::vector<double> kernel;
    double sum = 0.0;
    for (int k = -radius; k <= radius; ++k) {
      const double x = k / pixels_per_degree;
      kernel.push_back(std::exp(-kPi * kPi * x * x / lobe.b));
      sum += kernel.back();
    }
    const double amplitude = lobe.a * std::sqrt(kPi / lobe.b);
    const Plane part = convolve(plane, kernel, kernel);
    for (size_t i = 0; i < out.values.size(); ++i) out.values[i] += static_cast<float>(amplitude) * part.values[i];
    total += amplitude * sum * sum;
  }
  for (float& value : out.values) value = static_cast<float>(static_cast<double>(value) / total);
  return out;
}

/// The filtered colours of a picture as Hunt-adjusted CIELAB (4.1).
std::vector<Colour> perceived(const Planes& planes, double pixels_per_degree) {
  const Plane a = sensitivity(planes[0], {{1.0, 0.0047}}, pixels_per_degree);
  const Plane rg = sensitivity(planes[1], {{1.0, 0.0053}}, pixels_per_degree);
  const Plane by = sensitivity(planes[2], {{34.1, 0.04}, {13.5, 0.025}}, pixels_per_degree);
  std::vector<Colour> colours(a.values.size());
  for (size_t i = 0; i < colours.size(); ++i) {
    Colour rgb = linear_of(xyz_of_opponent(
        {static_cast<double>(a.values[i]), static_cast<double>(rg.values[i]), static_cast<double>(by.values[i])}));
    for (double& value : rgb) value = std::clamp(value, 0.0, 1.0);
    colours[i] = hunt_lab_of(xyz_of(rgb));
  }
  return colours;
}

/// Gaussian and its first or second derivative; positive and negative weights each sum to 1 and -1 (4.2).
struct FeatureKernels {
  std::vector<double> gaussian, first, second;

  explicit FeatureKernels(double pixels_per_degree) {
    const double sigma = 0.5 * 0.082 * pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(3.0 * sigma));
    for (int k = -radius; k <= radius; ++k) {
      const double g = std::exp(-k * k / (2.0 * sigma * sigma));
      gaussian.push_back(g);
      first.push_back(-k * g);
      second.push_back((k * k / (sigma * sigma) - 1.0) * g);
    }
    for (std::vector<double>* kernel : {&gaussian, &first, &second}) normalise(kernel);
  }
  static void normalise(std::vector<double>* kernel) {
    double positive = 0.0, negative = 0.0;
    for (const double w : *kernel) (w > 0.0 ? positive : negative) += std::fabs(w);
    for (double& w : *kernel) w /= w > 0.0 ? positive : negative;
  }
};

void find_features(const Plane& luminance, const FeatureKernels& kernels, FlipInput* input) {
  Plane y = luminance;
  for (float& value : y.values) value = (value + 16.0f) / 116.0f;
  const Plane ex = convolve(y, kernels.first, kernels.gaussian), ey = convolve(y, kernels.gaussian, kernels.first);
  const Plane px = convolve(y, kernels.second, kernels.gaussian), py = convolve(y, kernels.gaussian, kernels.second);
  for (size_t i = 0; i < y.values.size(); ++i) {
    input->edges.push_back(std::hypot(static_cast<double>(ex.values[i]), static_cast<double>(ey.values[i])));
    input->points.push_back(std::hypot(static_cast<double>(px.values[i]), static_cast<double>(py.values[i])));
  }
}

/// Compresses large colour differences: 0.4 of the largest one becomes 0.95 (4.1.3).
double redistributed(double delta, double largest) {
  constexpr double kPc = 0.4, kPt = 0.95;
  const double knee = kPc * largest;
  return delta < knee ? kPt / knee * delta : kPt + (delta - knee) / (largest - knee) * (1.0 - kPt);
}

}  // namespace

FlipInput flip_input(const Picture& picture, double pixels_per_degree) {
  const Planes planes = opponent_planes(picture);
  FlipInput input;
  input.colours = perceived(planes, pixels_per_degree);
  find_features(planes[0], FeatureKernels(pixels_per_degree), &input);
  return input;
}

std::vector<float> flip_map(const FlipInput& a, const FlipInput& b) {
  constexpr double kQc = 0.7, kQf = 0.5;
  const double largest =
      std::pow(distance(hunt_lab_of(xyz_of({0.0, 1.0, 0.0})), hunt_lab_of(xyz_of({0.0, 0.0, 1.0}))), kQc);
  std::vector<float> map(a.colours.size());
  for (size_t i = 0; i < map.size(); ++i) {
    const double colour = redistributed(std::pow(distance(a.colours[i], b.colours[i]), kQc), largest);
    const double feature =
        std::max(std::fabs(a.edges[i] - b.edges[i]), std::fabs(a.points[i] - b.points[i])) / std::sqrt(2.0);
    map[i] = static_cast<float>(std::pow(colour, 1.0 - std::min(std::pow(feature, kQf), 1.0)));
  }
  return map;
}

}  // namespace shootout
