// SPDX-License-Identifier: MIT
/// Everything that decides the pixels of the viewport, as plain values. Equal states give equal pictures.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>

#include <shd/shd.h>

#include "orbit.h"

namespace viewer {

/// Value that a picture shows.
enum class Show { kModel, kNormals, kUv, kLevel, kBarycentrics, kOverdraw, kDepth };

/// Settings of the sampler of all textures.
struct Sampling {
  shd_filter filter = SHD_FILTER_ANISOTROPIC;
  float max_anisotropy = 16.0f;  // 1..64
  shd_precision precision = SHD_PRECISION_FULL;
  float lod_bias = 0.0f;  // -15..15
  shd_profile profile = SHD_PROFILE_LEAST_ERROR;
  auto tie() const { return std::tie(filter, max_anisotropy, precision, lod_bias, profile); }
};

/// Reflectance of the model. The floor keeps its own.
struct Surface {
  bool from_file = true;  // a file's materials stay as they are
  shd_model model = SHD_MODEL_METALLIC_ROUGHNESS;
  std::array<float, 3> color = {1.0f, 1.0f, 1.0f};                              // multiplies the texture, linear
  float roughness = 0.14f, metallic = 0.0f, clearcoat = 0.0f, specular = 0.3f;  // 0..1
  float exponent = 60.0f;                                                       // 0..1000
  auto tie() const { return std::tie(from_file, model, color, roughness, metallic, clearcoat, specular, exponent); }
};

/// Settings that may differ between the two sides of a wipe.
struct Side {
  Sampling sampling;
  Surface surface;
  Show show = Show::kModel;
  uint32_t samples = 4;  // 1 or 4
  auto tie() const { return std::tuple_cat(sampling.tie(), surface.tie(), std::tie(show, samples)); }
};

/// Model, texture and floor.
struct Content {
  std::string model = "teapot";     // a shape, or the path of a model file
  std::string texture = "default";  // "default", "porcelain", "tiles", "none", or the path of an image
  bool floor = true;
  bool occlusion = true;  // ambient occlusion at the vertices of the model
  auto tie() const { return std::tie(model, texture, floor, occlusion); }
};

struct Lighting {
  float azimuth = -38.0f, elevation = 42.0f;  // direction to the light [deg]
  float intensity = 0.80f;
  float ambient = 0.0f;
  bool shadows = true;
  std::string environment = "studio";  // "studio", "none", or the path of a lat-long image
  float environment_intensity = 0.42f;
  auto tie() const {
    return std::tie(azimuth, elevation, intensity, ambient, shadows, environment, environment_intensity);
  }
};

/// A display and view of libshd_color; both empty = the plain sRGB curve of libshd.
struct Display {
  std::string display, view;
  auto tie() const { return std::tie(display, view); }
};

/// A pixel of the picture.
struct Pixel {
  uint32_t x = 0, y = 0;
  auto tie() const { return std::tie(x, y); }
};

struct State {
  Content content;
  Lighting lighting;
  Display display;
  Orbit orbit;
  Side side[2];          // A and B
  bool wipe = false;     // both sides are rendered
  float divider = 0.5f;  // A is left of this part of the width
  uint32_t width = 900, height = 760;
  std::optional<Pixel> pick;  // pixel whose lookup is explained
};

template <class T>
auto operator==(const T& a, const T& b) -> decltype(a.tie() == b.tie()) {
  return a.tie() == b.tie();
}
template <class T>
auto operator!=(const T& a, const T& b) -> decltype(a.tie() == b.tie()) {
  return !(a.tie() == b.tie());
}

/// Equal apart from the pick and the divider, which change no rendered pixel.
bool same_pixels(const State& a, const State& b);

/// First column of the picture that shows side B; the width without a wipe.
uint32_t divider_column(const State& state);

/// Number of the side that a pixel shows: 0 = A, 1 = B.
int side_at(const State& state, uint32_t x);

/// One value of an enum: the word of the command line and the text of the panels.
struct Choice {
  const char* word;
  const char* label;
  int value;
};

template <size_t N>
using Choices = std::array<Choice, N>;

extern const Choices<14> kFilters;
extern const Choices<5> kProfiles;
extern const Choices<2> kPrecisions;
extern const Choices<10> kModels;
extern const Choices<7> kShows;
extern const Choices<5> kShapes;

/// Label of a value; "?" for one that is not listed.
template <size_t N>
const char* label_of(const Choices<N>& choices, int value) {
  for (const Choice& choice : choices) {
    if (choice.value == value) return choice.label;
  }
  return "?";
}

/// Tables that lookups with this filter need.
shd_table_flags tables_of(shd_filter filter);

/// Tables that the shown sides need.
shd_table_flags tables_of(const State& state);

enum class FileKind { kEnvironment, kTexture, kModel, kOther };

/// Returns what a file is by its extension.
FileKind kind_of_file(const std::string& path);

/// Shows a file that was dropped on the window or chosen: an environment, a texture, or else a model.
void open_file(State& state, const std::string& path);

/// The settings that side B begins with: those of side A with another filter, trilinear or anisotropic.
Side other_side(const Side& side);

/// The shape of that word, or none for the path of a file.
std::optional<shd_shape> shape_of(const std::string& model);

}  // namespace viewer
