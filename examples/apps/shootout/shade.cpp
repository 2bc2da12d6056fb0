// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "textures.h"

namespace shootout {
namespace {

/// Diffuse and specular light after Blinn, "Models of Light Reflection for Computer Synthesized Pictures" (1977), for
/// an eye above the surface. A normal of length 0 has no light.
float lit(const float rgba[4]) {
  constexpr float kLight[3] = {-0.48f, -0.64f, 0.6f}, kHalf[3] = {-0.268328f, -0.357771f, 0.894427f};
  float n[3], length = 0.0f;
  for (size_t c = 0; c < 3; ++c) {
    n[c] = 2.0f * rgba[c] - 1.0f;
    length += n[c] * n[c];
  }
  if (length == 0.0f) return 0.0f;
  const float scale = 1.0f / std::sqrt(length);
  float diffuse = 0.0f, specular = 0.0f;
  for (size_t c = 0; c < 3; ++c) {
    diffuse += scale * n[c] * kLight[c];
    specular += scale * n[c] * kHalf[c];
  }
  return 0.05f + 0.55f * std::max(diffuse, 0.0f) + 0.4f * std::pow(std::max(specular, 0.0f), 60.0f);
}

}  // namespace

void shade(Shading shading, const float rgba[4], float rgb[3]) {
  constexpr float kSky[3] = {0.70f, 0.82f, 0.95f};
  switch (shading) {
    case Shading::kColour: std::copy_n(rgba, 3, rgb); break;
    case Shading::kNormal: rgb[0] = rgb[1] = rgb[2] = lit(rgba); break;
    case Shading::kAlphaTest: std::copy_n(rgba[3] >= 0.5f ? rgba : kSky, 3, rgb); break;
  }
  for (size_t c = 0; c < 3; ++c) rgb[c] = std::clamp(rgb[c], 0.0f, 1.0f);
}

Picture shade(Shading shading, const std::vector<float>& rgba, uint32_t edge) {
  Picture picture(edge, edge);
  for (size_t i = 0; i < picture.pixels(); ++i) shade(shading, &rgba[4 * i], &picture.rgb[3 * i]);
  return picture;
}

}  // namespace shootout
