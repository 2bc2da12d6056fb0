// SPDX-License-Identifier: MIT
#include "textures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>

#include "../../../bench/peers/peers.h"
#include "../../../bench/scenes.h"

namespace shootout {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Fills a texture from a function of the texel's centre in texels that gives r, g, b, a in [0, 1].
std::vector<uint8_t> filled(uint32_t edge, const std::function<void(double x, double y, double rgba[4])>& texel) {
  std::vector<uint8_t> bytes(size_t{edge} * edge * 4);
  for (uint32_t y = 0; y < edge; ++y) {
    for (uint32_t x = 0; x < edge; ++x) {
      double rgba[4] = {0.0, 0.0, 0.0, 1.0};
      texel(x + 0.5, y + 0.5, rgba);
      for (size_t c = 0; c < 4; ++c) {
        bytes[(size_t{y} * edge + x) * 4 + c] =
            static_cast<uint8_t>(std::lround(255.0 * std::clamp(rgba[c], 0.0, 1.0)));
      }
    }
  }
  return bytes;
}

/// Rows of a 5 x 7 font for the digits and some capitals, one bit a dot, drawn for this program.
struct Glyph {
  uint8_t rows[7];
};
constexpr Glyph kGlyphs[] = {
    {{14, 17, 19, 21, 25, 17, 14}}, {{4, 12, 4, 4, 4, 4, 14}},      {{14, 17, 1, 6, 8, 16, 31}},
    {{14, 17, 1, 6, 1, 17, 14}},    {{2, 6, 10, 18, 31, 2, 2}},     {{31, 16, 30, 1, 1, 17, 14}},
    {{14, 16, 30, 17, 17, 17, 14}}, {{31, 1, 2, 4, 8, 8, 8}},       {{14, 17, 17, 14, 17, 17, 14}},
    {{14, 17, 17, 15, 1, 1, 14}},   {{14, 17, 17, 31, 17, 17, 17}}, {{30, 17, 17, 30, 17, 17, 30}},
    {{14, 17, 16, 16, 16, 17, 14}}, {{30, 17, 17, 17, 17, 17, 30}}, {{31, 16, 16, 30, 16, 16, 31}},
    {{31, 16, 16, 30, 16, 16, 16}}, {{0, 0, 0, 0, 0, 0, 0}}};

std::vector<uint8_t> text(uint32_t edge) {
  std::mt19937 random(5);
  constexpr uint32_t kDot = 2, kAcross = 8 * kDot, kDown = 10 * kDot;
  std::vector<uint8_t> letters(size_t{edge / kAcross + 1} * (edge / kDown + 1));
  for (uint8_t& letter : letters) letter = static_cast<uint8_t>(random() % (sizeof kGlyphs / sizeof *kGlyphs));
  return filled(edge, [&](double x, double y, double rgba[4]) {
    const auto px = static_cast<uint32_t>(x), py = static_cast<uint32_t>(y);
    const Glyph& glyph = kGlyphs[letters[size_t{py / kDown} * (edge / kAcross + 1) + px / kAcross]];
    const uint32_t dot_x = px % kAcross / kDot, dot_y = py % kDown / kDot;
    const bool ink = dot_x < 5 && dot_y < 7 && (glyph.rows[dot_y] >> (4 - dot_x) & 1);
    rgba[0] = ink ? 0.08 : 0.96;
    rgba[1] = ink ? 0.08 : 0.95;
    rgba[2] = ink ? 0.14 : 0.90;
  });
}

/// Studs on a plate with a fine weave, as normals of a height.
std::vector<uint8_t> normals(uint32_t edge) {
  const auto height = [](double x, double y) {
    const double sx = std::remainder(x, 64.0), sy = std::remainder(y, 64.0);
    const double stud = std::max(0.0, 1.0 - (sx * sx + sy * sy) / (22.0 * 22.0));
    return 14.0 * std::sqrt(stud) + 0.6 * std::sin(kPi * x / 4) * std::sin(kPi * y / 4);
  };
  return filled(edge, [&](double x, double y, double rgba[4]) {
    const double dx = (height(x + 0.5, y) - height(x - 0.5, y)), dy = (height(x, y + 0.5) - height(x, y - 0.5));
    const double length = std::sqrt(dx * dx + dy * dy + 1.0);
    rgba[0] = 0.5 - 0.5 * dx / length;
    rgba[1] = 0.5 - 0.5 * dy / length;
    rgba[2] = 0.5 + 0.5 / length;
  });
}

struct Leaf {
  double x, y, angle, length, green;
};

/// Leaves as pointed ovals at random places; alpha is their coverage.
std::vector<uint8_t> foliage(uint32_t edge) {
  std::mt19937 random(11);
  const auto uniform = [&] { return random() / 4294967296.0; };
  std::vector<Leaf> leaves;
  for (uint32_t i = 0; i < edge / 2; ++i) {
    leaves.push_back({edge * uniform(), edge * uniform(), 2 * kPi * uniform(), 20.0 + 30.0 * uniform(), uniform()});
  }
  std::vector<uint8_t> bytes(size_t{edge} * edge * 4, 0);
  for (size_t i = 0; i < size_t{edge} * edge; ++i) {
    constexpr uint8_t kUnder[4] = {40, 70, 25, 0};  // near the leaves' colours, as bleeding is not what is measured
    std::copy_n(kUnder, 4, &bytes[4 * i]);
  }
  for (const Leaf& leaf : leaves) {
    const auto reach = static_cast<int>(leaf.length);
    for (int dy = -reach; dy <= reach; ++dy) {
      for (int dx = -reach; dx <= reach; ++dx) {
        const double along = (std::cos(leaf.angle) * dx + std::sin(leaf.angle) * dy) / leaf.length;
        const double across = (-std::sin(leaf.angle) * dx + std::cos(leaf.angle) * dy) / leaf.length;
        const double inside = (0.3 * (1.0 - along * along) - std::fabs(across)) * leaf.length;
        if (inside <= -0.5) continue;
        const uint32_t x = static_cast<uint32_t>(static_cast<int>(leaf.x) + dx) & (edge - 1);
        const uint32_t y = static_cast<uint32_t>(static_cast<int>(leaf.y) + dy) & (edge - 1);
        uint8_t* texel = &bytes[(size_t{y} * edge + x) * 4];
        const double vein = std::fabs(across) * leaf.length < 0.8 ? 0.75 : 1.0;
        texel[0] = static_cast<uint8_t>(vein * (40 + 60 * leaf.green));
        texel[1] = static_cast<uint8_t>(vein * (95 + 80 * leaf.green));
        texel[2] = static_cast<uint8_t>(vein * (25 + 25 * leaf.green));
        texel[3] = std::max(texel[3], static_cast<uint8_t>(255.0 * std::clamp(inside + 0.5, 0.0, 1.0)));
      }
    }
  }
  return bytes;
}

Texture photograph_or_noise(uint32_t edge, const std::string& path) {
#ifdef SHD_BENCH_OIIO
  std::vector<uint8_t> texels = shd::bench::load_rgba8(path, edge);
  if (!texels.empty()) return {"photograph", "Photograph: " + path, Shading::kColour, edge, std::move(texels)};
#else
  (void)path;
#endif
  return {"photograph", "Noise with the spectrum of photographs", Shading::kColour, edge,
          shd::bench::make_noise(edge).rgba};
}

constexpr const char* kNames[] = {"checker", "zone_plate", "photograph", "text", "normal_map", "foliage"};

}  // namespace

Texture make_texture(const std::string& name, uint32_t edge, const std::string& photograph) {
  if (name == "checker") {
    return {name, "Checkerboard of 32 texels", Shading::kColour, edge, shd::bench::make_checker(edge, 32).rgba};
  }
  if (name == "zone_plate") {
    return {name, "Zone plate", Shading::kColour, edge, shd::bench::make_zone_plate(edge).rgba};
  }
  if (name == "photograph") return photograph_or_noise(edge, photograph);
  if (name == "text") return {name, "Text", Shading::kColour, edge, text(edge)};
  if (name == "normal_map") return {name, "Normal map, judged after shading", Shading::kNormal, edge, normals(edge)};
  if (name == "foliage") return {name, "Foliage with an alpha test", Shading::kAlphaTest, edge, foliage(edge)};
  throw std::invalid_argument("texture: " + name +
                              " is not one of checker, zone_plate, photograph, text, normal_map, foliage");
}

std::vector<Texture> all_textures(uint32_t edge, const std::string& photograph) {
  std::vector<Texture> all;
  for (const char* name : kNames) all.push_back(make_texture(name, edge, photograph));
  return all;
}

Texture make_white_noise(uint32_t edge) {
  std::mt19937 random(7);
  return {"white_noise", "White noise", Shading::kColour, edge,
          filled(edge, [&](double, double, double rgba[4]) { rgba[0] = rgba[1] = rgba[2] = random() & 1; })};
}

}  // namespace shootout
