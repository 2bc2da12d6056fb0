// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <shd/shd.h>

/// A light of the command line. Positions are in radii of the model around its centre; directions point to the light.
struct LightOption {
  bool directional = false;
  std::array<float, 3> place = {0, 0, 0};
  std::array<float, 3> color = {1, 1, 1};
};

enum class LightPreset { kStudio, kHeadlight, kNone };

/// The command line, checked.
struct Options {
  bool help = false;
  std::string model;  // empty = the teapot
  std::string output = "out.png";
  uint32_t width = 960, height = 640;
  float azimuth = 30.0f, elevation = 20.0f;  // [deg]
  float distance = 0.0f;                     // [radii of the model]; 0 = the whole model fits
  float fov = 35.0f;                         // vertical [deg]
  shd_filter filter = SHD_FILTER_TRILINEAR;
  shd_model reflectance = SHD_MODEL_BLINN_PHONG;
  shd_frequency frequency = SHD_FREQUENCY_PHONG;
  std::vector<LightOption> lights;
  std::optional<LightPreset> preset;  // absent = studio, or none when lights are given
  std::array<float, 3> ambient = {0.15f, 0.15f, 0.15f};
  std::optional<float> exponent, specular;
  std::string texture;  // replaces the model's; "checker" = built in
  int tessellation = 16;
  bool color = true;
  std::string display = "sRGB", view = "ACES 1.0 SDR-video";
  std::array<float, 4> background = {0, 0, 0, 0};  // linear, straight alpha
  bool aov = false;
  uint32_t threads = 0;
  shd_simd simd = SHD_SIMD_BEST;
  bool progress = false, stats = false;
};

/// Throws Failure (kExitUsage) that names the option and what it takes.
Options parse_options(int argc, const char* const* argv);

/// Text of `--help`.
const char* help_text();
