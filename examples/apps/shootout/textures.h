// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "picture.h"

namespace shootout {

/// The way from filtered texels to the colours of a frame.
enum class Shading {
  kColour,    // red, green and blue as they are
  kNormal,    // Blinn-Phong light on a tangent-space normal
  kAlphaTest  // the colour where alpha is at least 1/2, else the sky
};

/// A square RGBA8 texture, repeated over the plane.
struct Texture {
  std::string name, title;
  Shading shading = Shading::kColour;
  uint32_t edge = 0;  // a power of two
  std::vector<uint8_t> rgba;
};

/// The textures of the report. A photograph that cannot be read is replaced by noise with the spectrum of photographs.
std::vector<Texture> all_textures(uint32_t edge, const std::string& photograph);
/// A texture of all_textures() by its name; fails for an unknown name.
Texture make_texture(const std::string& name, uint32_t edge, const std::string& photograph);
/// Black or white texels at random, for the level curve.
Texture make_white_noise(uint32_t edge);

/// Shades one filtered or sampled value [0, 1].
void shade(Shading shading, const float rgba[4], float rgb[3]);
/// Shades packed RGBA values into a picture of edge x edge pixels.
Picture shade(Shading shading, const std::vector<float>& rgba, uint32_t edge);

}  // namespace shootout
