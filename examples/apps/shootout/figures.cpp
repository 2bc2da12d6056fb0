// SPDX-License-Identifier: MIT
#include "figures.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "shd_pass.h"
#include "truth.h"

namespace shootout {
namespace {

using shd::bench::Shape;

Workload floor_of(uint32_t edge, uint32_t texture_edge, bool turned) {
  return scene_workload({turned ? Shape::kTurnedFloor : Shape::kFloor, edge, 4.0 * edge / texture_edge}, "floor", "");
}

Picture with(const std::string& setting, const Workload& workload, const Texture& texture) {
  const std::vector<Setting> settings = all_settings();
  const ShdPass pass(texture, setting_named(settings, setting));
  return shade(texture.shading, pass.filter(lookups_of(workload)), workload.edge);
}

/// The mean of 32 x 16 points a pixel.
Picture samples_512(const Workload& workload, const Texture& texture) {
  constexpr uint32_t kAcross = 32, kDown = 16;
  Picture picture(workload.edge, workload.edge);
  std::vector<float> row;
  for (uint32_t y = 0; y < workload.edge * kDown; ++y) {
    sample_row(workload, texture, kAcross, kDown, y, size_t{workload.edge} * kAcross, &row);
    for (size_t i = 0; i < row.size(); ++i) {
      picture.at(static_cast<uint32_t>(i / 3 / kAcross), y / kDown)[i % 3] += row[i] / (kAcross * kDown);
    }
  }
  return picture;
}

/// Two pictures with a white line between them.
Picture beside(const Picture& a, const Picture& b) {
  constexpr uint32_t kLine = 4;
  Picture out(a.width + kLine + b.width, a.height);
  std::fill(out.rgb.begin(), out.rgb.end(), 1.0f);
  for (uint32_t y = 0; y < a.height; ++y) {
    std::copy_n(a.at(0, y), 3 * a.width, out.at(0, y));
    std::copy_n(b.at(0, y), 3 * b.width, out.at(a.width + kLine, y));
  }
  return out;
}

}  // namespace

const std::vector<FigureName>& figure_names() {
  static const std::vector<FigureName> names = {{"point", "Point sampling"},
                                                {"supersampling", "512 samples a pixel"},
                                                {"moire", "A zone plate, 4 texels a pixel: point sampling and EWA"},
                                                {"level", "Mip level D, rounded to the nearest level"},
                                                {"level_continuous", "Mip level D, continuous"},
                                                {"overblur", "Trilinear with D = log2 of the longer axis: overblur"},
                                                {"anisotropic", "Anisotropic, at most 16 probes"},
                                                {"ripmap", "Ripmap on diagonals, beside 512 samples"},
                                                {"summed_area", "Summed-area table on diagonals, beside 512 samples"},
                                                {"ewa", "EWA on diagonals, beside 512 samples"}};
  return names;
}

Figure make_figure(const std::string& name, uint32_t edge) {
  constexpr uint32_t kTextureEdge = 1024;
  const auto found =
      std::find_if(figure_names().begin(), figure_names().end(), [&](const FigureName& f) { return f.name == name; });
  if (found == figure_names().end()) throw std::invalid_argument("--figure: " + name + " is not in the list of --list");
  const auto title = found->title;
  const Workload floor = floor_of(edge, kTextureEdge, false), turned = floor_of(edge, kTextureEdge, true);
  const Texture checker = make_texture("checker", kTextureEdge, "");
  if (name == "point") return {name, title, with("nearest", floor, checker)};
  if (name == "supersampling") return {name, title, samples_512(floor, checker)};
  if (name == "moire") {
    const Texture plate = make_texture("zone_plate", kTextureEdge, "");
    const Workload plane = plane_workload(edge, kTextureEdge, 4.0, 0.0, {0.0, 0.0}, "plane", "");
    return {name, title, beside(with("nearest", plane, plate), with("ewa_16", plane, plate))};
  }
  if (name == "level") return {name, title, level_picture(floor, kTextureEdge, SHD_PROFILE_EXACT, true)};
  if (name == "level_continuous") return {name, title, level_picture(floor, kTextureEdge, SHD_PROFILE_EXACT, false)};
  if (name == "overblur") return {name, title, with("trilinear_exact", floor, checker)};
  if (name == "anisotropic") return {name, title, with("anisotropic_16", floor, checker)};
  const std::string setting = name == "ewa" ? "ewa_16" : name;
  return {name, title, beside(with(setting, turned, checker), samples_512(turned, checker))};
}

void level_colour(double level, bool nearest, float rgb[3]) {
  // The eight colours of Okabe and Ito, "Color Universal Design" (2008), without black, then grey for coarser levels.
  constexpr float kColours[][3] = {{0.00f, 0.45f, 0.70f}, {0.34f, 0.71f, 0.91f}, {0.00f, 0.62f, 0.45f},
                                   {0.94f, 0.89f, 0.26f}, {0.90f, 0.62f, 0.00f}, {0.84f, 0.37f, 0.00f},
                                   {0.80f, 0.47f, 0.65f}, {0.60f, 0.60f, 0.60f}, {0.85f, 0.85f, 0.85f}};
  constexpr double kLast = 8.0;
  const double place = std::clamp(nearest ? std::ceil(level + 0.5) - 1.0 : level, 0.0, kLast);
  const auto first = static_cast<size_t>(place), second = std::min(first + 1, static_cast<size_t>(kLast));
  const auto share = static_cast<float>(place - std::floor(place));
  for (size_t c = 0; c < 3; ++c) rgb[c] = (1.0f - share) * kColours[first][c] + share * kColours[second][c];
}

Picture level_picture(const Workload& workload, uint32_t texture_edge, shd_profile profile, bool nearest) {
  Setting setting;
  setting.sampler = shd_sampler_desc_default();
  setting.sampler.profile = profile;
  const Texture blank = {"", "", Shading::kColour, texture_edge,
                         std::vector<uint8_t>(size_t{texture_edge} * texture_edge * 4)};
  const std::vector<float> levels = ShdPass(blank, setting).levels(lookups_of(workload));
  Picture picture(workload.edge, workload.edge);
  for (size_t i = 0; i < levels.size(); ++i) level_colour(static_cast<double>(levels[i]), nearest, &picture.rgb[3 * i]);
  return picture;
}

}  // namespace shootout
