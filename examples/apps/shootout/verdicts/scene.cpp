// SPDX-License-Identifier: MIT
// Textures and lookups of verdicts.
#include <algorithm>
#include <cmath>
#include <random>

#include "verdicts.h"

namespace shootout {
namespace {

/// Uniform in [0, 1), the same on every machine.
double unit(std::mt19937_64* random) {
  return static_cast<double>((*random)() >> 11) * 0x1p-53;
}
double between(std::mt19937_64* random, double low, double high) {
  return low + (high - low) * unit(random);
}

using Value = std::function<double(uint32_t level, double x, double y, uint32_t channel)>;

Texture make_pyramid(const std::string& name, const std::string& title, uint32_t edge, const Value& value) {
  Texture texture;
  texture.name = name;
  texture.title = title;
  texture.edge = edge;
  for (uint32_t level = 0; level < level_count(texture); ++level) {
    const uint32_t size = level_edge(texture, level);
    for (uint32_t i = 0; i < size * size; ++i) {
      for (uint32_t c = 0; c < 4; ++c) {
        const double v = value(level, (i % size + 0.5) / size, (i / size + 0.5) / size, c);
        texture.rgba.push_back(static_cast<uint8_t>(std::lround(255.0 * std::min(std::max(v, 0.0), 1.0))));
      }
    }
  }
  return texture;
}

double level_colour(uint32_t level, uint32_t channel) {
  return 0.12 + 0.076 * ((level * 5 + channel * 2) % 11);
}

/// 0 to 1 and back over a period of 1.
double triangle(double x) {
  return std::fabs(2.0 * (x - std::floor(x)) - 1.0);
}

}  // namespace

uint32_t level_edge(const Texture& texture, uint32_t level) {
  return std::max(texture.edge >> level, 1u);
}

uint32_t level_count(const Texture& texture) {
  uint32_t count = 1;
  while (texture.edge >> count) ++count;
  return count;
}

const uint8_t* level_texels(const Texture& texture, uint32_t level) {
  size_t offset = 0;
  for (uint32_t l = 0; l < level; ++l) offset += size_t{level_edge(texture, l)} * level_edge(texture, l) * 4;
  return &texture.rgba[offset];
}

std::vector<Texture> judged_textures() {
  std::mt19937_64 random(7);
  const auto noise = [&](uint32_t level, double, double, uint32_t c) {
    return 0.3 * level_colour(level, c) + 0.7 * unit(&random);
  };
  const auto ramp = [](uint32_t level, double x, double y, uint32_t c) {
    return 0.9 * triangle((c & 1 ? y : x) + (c & 2 ? 0.5 * std::sin(6.283185307 * y) : 0.0)) + 0.1 * (level & 1);
  };
  const auto flat = [](uint32_t level, double, double, uint32_t c) { return level_colour(level, c); };
  return {make_pyramid("noise", "Noise, 256 x 256", 256, noise), make_pyramid("ramp", "Ramps, 256 x 256", 256, ramp),
          make_pyramid("levels", "A colour a level, 256 x 256", 256, flat),
          make_pyramid("noise_200", "Noise, 200 x 200", 200, noise)};
}

Lookups random_footprints(size_t count, uint32_t edge, uint64_t seed) {
  constexpr double kTurn = 6.283185307179586;
  std::mt19937_64 random(seed);
  Lookups q;
  const auto place = [&] {
    const double x = between(&random, -0.5, 1.5);
    return static_cast<float>(random() % 8 ? x : std::floor(x * 2 * edge) / (2 * edge));
  };
  for (size_t i = 0; i < count; ++i) {
    q.u.push_back(place());
    q.v.push_back(place());
    const double longer = std::exp2(between(&random, -3, 6)) / edge;
    const double shorter = longer * std::exp2(-between(&random, 0, 4));
    const double angle = between(&random, 0, kTurn), turn = i % 2 ? between(&random, 0, kTurn) : 0.0;
    const double p[2] = {longer * std::cos(angle), longer * std::sin(angle)};
    const double r[2] = {-shorter * std::sin(angle), shorter * std::cos(angle)};
    const double c = std::cos(turn), s = std::sin(turn);
    q.dudx.push_back(static_cast<float>(c * p[0] + s * r[0]));
    q.dvdx.push_back(static_cast<float>(c * p[1] + s * r[1]));
    q.dudy.push_back(static_cast<float>(c * r[0] - s * p[0]));
    q.dvdy.push_back(static_cast<float>(c * r[1] - s * p[1]));
  }
  return q;
}

Lookups lookups_at(const Lookups& q, const std::vector<size_t>& indices) {
  Lookups out;
  const auto gather = [&](const std::vector<float>& from, std::vector<float>* to) {
    if (from.empty()) return;
    to->reserve(indices.size());
    for (const size_t i : indices) to->push_back(from[i]);
  };
  gather(q.u, &out.u);
  gather(q.v, &out.v);
  gather(q.dudx, &out.dudx);
  gather(q.dvdx, &out.dvdx);
  gather(q.dudy, &out.dudy);
  gather(q.dvdy, &out.dvdy);
  gather(q.lod, &out.lod);
  return out;
}

}  // namespace shootout
