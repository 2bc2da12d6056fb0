// SPDX-License-Identifier: MIT
#include "scenes.h"

#include <algorithm>
#include <cmath>

namespace shd::bench {
namespace {

constexpr double kPi = 3.14159265358979323846;

Point floor_point(double x, double y) {
  constexpr double kFar = 12.0, kScale = 0.4;
  const double z = 1.0 / (1.0 / kFar + (1.0 - 1.0 / kFar) * y);
  return {kScale * (x - 0.5) * z, kScale * z};
}

Point sphere_point(double x, double y) {
  constexpr double kScale = 0.3, kHalf = 0.69;
  const double px = kHalf * (2 * x - 1), py = kHalf * (2 * y - 1);
  const double pz = std::sqrt(std::max(1 - px * px - py * py, 1e-9));
  return {kScale * std::atan2(px, pz), kScale * std::asin(py)};
}

Point tunnel_point(double x, double y) {
  const double px = 2 * x - 1, py = 2 * y - 1, radius = std::sqrt(px * px + py * py);
  return {std::atan2(py, px) / (2 * kPi), 0.3 / (radius + 0.08)};
}

/// Shares of a sample at t = -1/2..1/2 from the centre of its pixel: of the pixel and of the nearest neighbour.
struct TentShare {
  explicit TentShare(double t) : own(1 - std::fabs(t)), other(std::fabs(t)), step(t < 0 ? -1 : 1) {}
  double own, other;
  int step;
};

/// Sums of one row of samples for each pixel of the frame's row, under both pixel filters.
struct RowSums {
  explicit RowSums(uint32_t frame) : edge(static_cast<int>(frame)), box(size_t{frame} * 3), tent(size_t{frame} * 3) {}

  void add(int x, const TentShare& share, const double (&color)[3]) {
    const int neighbour = x + share.step;
    for (size_t c = 0; c < 3; ++c) {
      if (x >= 0 && x < edge) box[static_cast<size_t>(x) * 3 + c] += color[c];
      if (x >= 0 && x < edge) tent[static_cast<size_t>(x) * 3 + c] += share.own * color[c];
      if (neighbour >= 0 && neighbour < edge) tent[static_cast<size_t>(neighbour) * 3 + c] += share.other * color[c];
    }
  }

  int edge;
  std::vector<double> box, tent;
};

/// Adds `scale` times the sums to row y of an image, if the row exists.
void add_row(const std::vector<double>& sums, int y, uint32_t frame, double scale, std::vector<double>* image) {
  if (y < 0 || y >= static_cast<int>(frame)) return;
  double* row = &(*image)[static_cast<size_t>(y) * frame * 3];
  for (size_t i = 0; i < sums.size(); ++i) row[i] += scale * sums[i];
}

std::vector<float> rgba_of(const std::vector<double>& rgb) {
  std::vector<float> image(rgb.size() / 3 * 4, 1.0f);
  for (size_t i = 0; i < rgb.size(); ++i) image[i / 3 * 4 + i % 3] = static_cast<float>(rgb[i]);
  return image;
}

}  // namespace

const char* name_of(Shape shape) {
  constexpr const char* kNames[] = {"floor", "floor_45", "sphere", "tunnel", "zoom", "plane"};
  return kNames[static_cast<size_t>(shape)];
}

Point point_of(const Scene& scene, double x, double y) {
  const double p = x / scene.frame, q = y / scene.frame;
  Point at = {};
  switch (scene.shape) {
    case Shape::kFloor: at = floor_point(p, q); break;
    case Shape::kTurnedFloor: {
      const Point straight = floor_point(p, q);
      at = {std::sqrt(0.5) * (straight.u - straight.v), std::sqrt(0.5) * (straight.u + straight.v)};
      break;
    }
    case Shape::kSphere: at = sphere_point(p, q); break;
    case Shape::kTunnel: at = tunnel_point(p, q); break;
    case Shape::kZoom: {
      const double a = p + 0.2, b = q + 0.2;
      at = {0.59 * (a * a - b * b), 0.59 * 2 * a * b};
      break;
    }
    case Shape::kPlane: at = {p - 0.5, q - 0.5}; break;
  }
  return {at.u * scene.zoom, at.v * scene.zoom + scene.move};
}

void add_lookup(const std::function<Point(double dx, double dy)>& point, Lookups* out) {
  constexpr double kStep = 1e-3;
  const Point at = point(0, 0), left = point(-kStep, 0), right = point(kStep, 0);
  const Point above = point(0, -kStep), below = point(0, kStep);
  const auto add = [](std::vector<float>* column, double value) { column->push_back(static_cast<float>(value)); };
  add(&out->u, at.u);
  add(&out->v, at.v);
  add(&out->dudx, (right.u - left.u) / (2 * kStep));
  add(&out->dvdx, (right.v - left.v) / (2 * kStep));
  add(&out->dudy, (below.u - above.u) / (2 * kStep));
  add(&out->dvdy, (below.v - above.v) / (2 * kStep));
}

Lookups scene_lookups(const Scene& scene) {
  Lookups q;
  for (uint32_t row = 0; row < scene.frame; ++row) {
    for (uint32_t column = 0; column < scene.frame; ++column) {
      const auto point = [&](double dx, double dy) { return point_of(scene, column + 0.5 + dx, row + 0.5 + dy); };
      add_lookup(point, &q);
    }
  }
  return q;
}

Truth supersample(const Scene& scene, const Picture& picture, int samples) {
  const int edge = static_cast<int>(scene.frame);
  const double scale = 1.0 / (255.0 * samples * samples);
  std::vector<double> box(size_t{scene.frame} * scene.frame * 3), tent(box.size());
  for (int y = -1; y <= edge; ++y) {
    for (int sub_y = 0; sub_y < samples; ++sub_y) {
      const double ty = (sub_y + 0.5) / samples - 0.5;
      RowSums sums(scene.frame);
      for (int x = -1; x <= edge; ++x) {
        for (int sub_x = 0; sub_x < samples; ++sub_x) {
          const double tx = (sub_x + 0.5) / samples - 0.5;
          const Point at = point_of(scene, x + 0.5 + tx, y + 0.5 + ty);
          double color[3] = {};
          add_bilinear(picture, at.u, at.v, color);
          sums.add(x, TentShare(tx), color);
        }
      }
      const TentShare share(ty);
      add_row(sums.box, y, scene.frame, scale, &box);
      add_row(sums.tent, y, scene.frame, scale * share.own, &tent);
      add_row(sums.tent, y + share.step, scene.frame, scale * share.other, &tent);
    }
  }
  return {rgba_of(box), rgba_of(tent)};
}

Picture make_zone_plate(uint32_t edge) {
  Picture picture{"zone_plate", edge, std::vector<uint8_t>(size_t{edge} * edge * 4, 255)};
  for (uint32_t y = 0; y < edge; ++y) {
    for (uint32_t x = 0; x < edge; ++x) {
      const double px = x + 0.5 - edge / 2.0, py = y + 0.5 - edge / 2.0;
      const double value = 0.5 + 0.5 * std::cos(kPi * (px * px + py * py) / (2.0 * edge));
      for (size_t c = 0; c < 3; ++c) {
        picture.rgba[(size_t{y} * edge + x) * 4 + c] = static_cast<uint8_t>(std::lround(255.0 * value));
      }
    }
  }
  return picture;
}

double mean_square_error(const std::vector<float>& rgba, const std::vector<float>& truth) {
  double sum = 0.0;
  for (size_t i = 0; i < truth.size(); ++i) {
    if (i % 4 == 3) continue;
    const double difference = static_cast<double>(std::clamp(rgba[i], 0.0f, 1.0f)) - static_cast<double>(truth[i]);
    sum += difference * difference;
  }
  return sum / (static_cast<double>(truth.size()) * 0.75);
}

}  // namespace shd::bench
