// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>

#include "../shd_pass.h"
#include "json.h"
#include "png.h"
#include "report.h"

namespace shootout {
namespace {

constexpr uint32_t kTapGrid = 9;  // pixels along each axis of a frame whose taps the page has
constexpr const char* kTapSettings[] = {"bilinear",     "bilinear_mip",   "trilinear",          "ripmap",
                                        "one_level_16", "anisotropic_16", "anisotropic_vulkan", "anisotropic_oiio",
                                        "ewa_16"};

std::string frame_key(const Measurements& m, const Frame& frame) {
  const std::string setting = frame.setting == kTruthSetting ? "truth" : m.settings[frame.setting].name;
  return m.workloads[frame.workload].name + "/" + m.textures[frame.texture].name + "/" + setting;
}

void write_levels(const Options& options, const Measurements& m, Json* json) {
  constexpr struct {
    const char* name;
    shd_profile profile;
  } kProfiles[] = {{"Least error (default)", SHD_PROFILE_LEAST_ERROR},
                   {"log2 of the longer axis", SHD_PROFILE_EXACT},
                   {"Vulkan", SHD_PROFILE_VULKAN},
                   {"OpenImageIO", SHD_PROFILE_OIIO}};
  json->key("levels").begin_array();
  for (const Workload& workload : m.workloads) {
    if (!workload.smooth || workload.name.rfind("magnified", 0) == 0) continue;
    for (const auto& profile : kProfiles) {
      for (const bool nearest : {false, true}) {
        const Picture picture = level_picture(workload, options.texture_edge, profile.profile, nearest);
        json->begin_object().member("workload", workload.title).member("profile", profile.name);
        json->member("nearest", nearest ? 1.0 : 0.0).member("hash", hash_of(picture));
        json->member("png", data_uri(png_of(picture))).end_object();
      }
    }
  }
  json->end_array();
}

/// A texture as the page draws it below footprints, at most 512 pixels wide.
Picture reduced(const Texture& texture) {
  const uint32_t factor = std::max(texture.edge / 512, 1u), edge = texture.edge / factor;
  Picture picture(edge, edge);
  for (uint32_t y = 0; y < texture.edge; ++y) {
    for (uint32_t x = 0; x < texture.edge; ++x) {
      for (size_t c = 0; c < 3; ++c) {
        picture.at(x / factor, y / factor)[c] +=
            static_cast<float>(texture.rgba[(size_t{y} * texture.edge + x) * 4 + c]) / (255.0f * factor * factor);
      }
    }
  }
  return picture;
}

/// The different taps of a lookup with the sums of their weights.
void write_taps(const std::vector<shd_tap>& taps, Json* json) {
  std::map<std::array<uint32_t, 4>, double> sums;
  for (const shd_tap& tap : taps) sums[{tap.level_u, tap.level_v, tap.x, tap.y}] += static_cast<double>(tap.weight);
  json->begin_array();
  for (const auto& [place, weight] : sums) {
    for (const uint32_t value : place) json->value(static_cast<double>(value));
    json->value(std::round(weight * 1e4), 6);
  }
  json->end_array();
}

}  // namespace

std::string pictures_json(const Options& options, const Measurements& m) {
  Json json;
  json.begin_object().key("frames").begin_object();
  for (const Frame& frame : m.frames) json.member(frame_key(m, frame), data_uri(png_of(frame.picture)));
  json.end_object().key("flips").begin_object();
  for (const Frame& frame : m.frames) {
    if (!frame.flip.empty()) json.member(frame_key(m, frame), data_uri(half_png_of(frame.flip, frame.picture.width)));
  }
  json.end_object().key("textures").begin_object();
  for (const Texture& texture : m.textures) json.member(texture.name, data_uri(png_of(reduced(texture))));
  json.end_object();
  write_levels(options, m, &json);
  json.key("figures").begin_array();
  for (const FigureName& name : figure_names()) {
    const Figure figure = make_figure(name.name, options.quick ? 64 : 256);
    json.begin_object().member("name", figure.name).member("title", figure.title);
    json.member("hash", hash_of(figure.picture)).member("png", data_uri(png_of(figure.picture))).end_object();
  }
  json.end_array().end_object();
  return json.text();
}

std::string taps_json(const Options& options, const Measurements& m) {
  const Texture blank = {"", "", Shading::kColour, options.texture_edge,
                         std::vector<uint8_t>(size_t{options.texture_edge} * options.texture_edge * 4)};
  Json json;
  json.begin_array();
  for (const Workload& workload : m.workloads) {
    if (!workload.smooth) continue;
    const Lookups q = lookups_of(workload);
    json.begin_object().member("workload", workload.name).member("grid", static_cast<double>(kTapGrid));
    json.key("lookups").begin_array();
    std::vector<size_t> picked;
    for (uint32_t i = 0; i < kTapGrid * kTapGrid; ++i) {
      const uint32_t x = (2 * (i % kTapGrid) + 1) * workload.edge / (2 * kTapGrid);
      const uint32_t y = (2 * (i / kTapGrid) + 1) * workload.edge / (2 * kTapGrid);
      picked.push_back(size_t{y} * workload.edge + x);
      json.begin_array().value(static_cast<double>(x)).value(static_cast<double>(y));
      for (const auto* column : {&q.u, &q.v, &q.dudx, &q.dvdx, &q.dudy, &q.dvdy}) {
        json.value(static_cast<double>((*column)[picked.back()]), 7);
      }
      json.end_array();
    }
    json.end_array().key("taps").begin_object();
    for (const char* name : kTapSettings) {
      const ShdPass pass(blank, setting_named(m.settings, name));
      json.key(name).begin_array();
      for (const size_t index : picked) {
        std::vector<shd_tap> taps;
        shd_explanation explanation;
        pass.explain(q, index, &taps, &explanation);
        write_taps(taps, &json);
      }
      json.end_array();
    }
    json.end_object().end_object();
  }
  json.end_array();
  return json.text();
}

}  // namespace shootout
