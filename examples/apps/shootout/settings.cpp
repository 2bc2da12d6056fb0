// SPDX-License-Identifier: MIT
#include "settings.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <map>
#include <stdexcept>

namespace shootout {
namespace {

using shd::bench::PeerFilter;

Setting row(const std::string& name, const std::string& title, shd_filter filter,
            const std::function<void(shd_sampler_desc*)>& change = nullptr, shd_table_flags tables = SHD_TABLE_MIPMAP) {
  Setting setting;
  setting.name = name;
  setting.title = title;
  setting.sampler = shd_sampler_desc_default();
  setting.sampler.filter = filter;
  setting.tables = tables;
  if (change) change(&setting.sampler);
  return setting;
}

Setting profile(const std::string& name, const std::string& title, shd_filter filter, shd_profile rules) {
  return row(name, title, filter, [=](shd_sampler_desc* d) { d->profile = rules; });
}

/// Probes of 4 texels on the nearer level alone, with the largest ratio for a number of texels. Where the nearer level
/// is the finer one, probes are up to sqrt(2) times as narrow, and up to ceil(sqrt(2) ratio - 1/8) cover the footprint.
Setting one_level(int texels) {
  const std::string text = std::to_string(texels);
  return row("one_level_" + text, "Anisotropic, one level, at most " + text + " texels", SHD_FILTER_ANISOTROPIC,
             [=](shd_sampler_desc* d) {
               d->max_anisotropy = 0.7f * static_cast<float>(texels) / 4.0f;
               d->level_blend = 0.0f;
             });
}

Setting anisotropic(int ratio) {
  const std::string text = std::to_string(ratio);
  return row("anisotropic_" + text, "Anisotropic " + text, SHD_FILTER_ANISOTROPIC,
             [=](shd_sampler_desc* d) { d->max_anisotropy = static_cast<float>(ratio); });
}

void add_shd(std::vector<Setting>* all) {
  all->push_back(row("nearest", "Nearest", SHD_FILTER_NEAREST));
  all->push_back(row("bilinear", "Bilinear", SHD_FILTER_BILINEAR));
  all->push_back(row("bicubic", "Bicubic, Catmull-Rom", SHD_FILTER_BICUBIC));
  all->push_back(row("bicubic_b_spline", "Bicubic, B-spline", SHD_FILTER_BICUBIC,
                     [](shd_sampler_desc* d) { d->cubic = SHD_CUBIC_B_SPLINE; }));
  all->push_back(row("nearest_mip", "Nearest on the nearest level", SHD_FILTER_NEAREST_MIP));
  all->push_back(row("bilinear_mip", "Bilinear on the nearest level", SHD_FILTER_BILINEAR_MIP));
  all->push_back(row("trilinear", "Trilinear", SHD_FILTER_TRILINEAR));
  all->push_back(
      profile("trilinear_exact", "Trilinear, level log2 of the longer axis", SHD_FILTER_TRILINEAR, SHD_PROFILE_EXACT));
  const auto peer_rules = [&](const char* name, const char* title, shd_filter filter) {
    all->push_back(
        profile(std::string(name) + "_vulkan", std::string(title) + ", rules of Vulkan", filter, SHD_PROFILE_VULKAN));
    all->push_back(
        profile(std::string(name) + "_oiio", std::string(title) + ", rules of OpenImageIO", filter, SHD_PROFILE_OIIO));
  };
  peer_rules("bilinear_mip", "Bilinear on the nearest level", SHD_FILTER_BILINEAR_MIP);
  peer_rules("trilinear", "Trilinear", SHD_FILTER_TRILINEAR);
  all->push_back(row("ripmap", "Ripmap", SHD_FILTER_RIPMAP, nullptr, SHD_TABLE_RIPMAP));
  all->push_back(
      row("summed_area", "Summed area, bounding box", SHD_FILTER_SUMMED_AREA, nullptr, SHD_TABLE_SUMMED_AREA));
  all->push_back(row(
      "summed_area_oriented", "Summed area, oriented boxes", SHD_FILTER_SUMMED_AREA,
      [](shd_sampler_desc* d) { d->box = SHD_BOX_ORIENTED; }, SHD_TABLE_SUMMED_AREA));
  for (const int texels : {8, 12, 16, 24, 32}) all->push_back(one_level(texels));
  for (const int ratio : {2, 4, 8, 16}) all->push_back(anisotropic(ratio));
  all->push_back(row("anisotropic_16_fast", "Anisotropic 16, fast precision", SHD_FILTER_ANISOTROPIC,
                     [](shd_sampler_desc* d) { d->precision = SHD_PRECISION_FAST; }));
  all->push_back(row("anisotropic_32_texels", "Anisotropic 16, at most 32 texels", SHD_FILTER_ANISOTROPIC,
                     [](shd_sampler_desc* d) { d->max_texels = 32; }));
  const auto rules = [&](const char* name, const char* title, shd_profile p) {
    all->push_back(profile(std::string("anisotropic_") + name, std::string("Anisotropic 16, rules of ") + title,
                           SHD_FILTER_ANISOTROPIC, p));
  };
  rules("exact", "log2 of the shorter axis", SHD_PROFILE_EXACT);
  rules("vulkan", "Vulkan", SHD_PROFILE_VULKAN);
  rules("d3d11", "Direct3D 11", SHD_PROFILE_D3D11);
  rules("oiio", "OpenImageIO", SHD_PROFILE_OIIO);
  all->push_back(row("ewa_16", "EWA 16", SHD_FILTER_EWA));
  all->push_back(
      row("ewa_32_texels", "EWA, at most 32 texels", SHD_FILTER_EWA, [](shd_sampler_desc* d) { d->max_texels = 32; }));
  all->push_back(row("stochastic", "Stochastic trilinear", SHD_FILTER_STOCHASTIC));
  all->push_back(row("stochastic_anisotropic", "Stochastic anisotropic", SHD_FILTER_STOCHASTIC,
                     [](shd_sampler_desc* d) { d->stochastic_filter = SHD_FILTER_ANISOTROPIC; }));
  all->push_back(row("exact", "Exact", SHD_FILTER_EXACT));
}

struct PeerRow {
  const char *name, *title;
  PeerFilter filter;
  shd_filter counted;
};
constexpr PeerRow kPeerRows[] = {
    {"nearest", "nearest", PeerFilter::kNearest, SHD_FILTER_NEAREST},
    {"bilinear", "bilinear", PeerFilter::kBilinear, SHD_FILTER_BILINEAR},
    {"nearest_mip", "nearest, one level", PeerFilter::kNearestMip, SHD_FILTER_NEAREST_MIP},
    {"bilinear_mip", "bilinear, one level", PeerFilter::kBilinearMip, SHD_FILTER_BILINEAR_MIP},
    {"trilinear", "trilinear", PeerFilter::kTrilinear, SHD_FILTER_TRILINEAR},
    {"anisotropic_16", "anisotropic 16", PeerFilter::kAnisotropic16, SHD_FILTER_ANISOTROPIC}};

/// The version in a description such as "Mesa 22.3.6", without its last part.
[[maybe_unused]] double mesa_version(const std::string& description) {
  const size_t at = description.find("Mesa ");
  return at == std::string::npos ? 0.0 : std::strtod(description.c_str() + at + 5, nullptr);
}

[[maybe_unused]] void add_peer(std::vector<Setting>* all, Who who, shd_profile rules, double mesa = 0.0) {
  for (const PeerRow& peer : kPeerRows) {
    Setting setting = profile(std::string(name_of(who)) + "_" + peer.name,
                              std::string(name_of(who)) + ", " + peer.title, peer.counted, rules);
    setting.who = who;
    setting.peer = peer.filter;
    setting.estimated = who != Who::kOpenImageIO && peer.filter == PeerFilter::kAnisotropic16;
    setting.mesa = mesa;
    all->push_back(setting);
  }
}

/// Settings whose pictures look like those of another one. The page leaves these pictures out to stay small.
constexpr const char* kAlike[] = {"anisotropic_16_fast", "anisotropic_2",         "anisotropic_8",
                                  "anisotropic_d3d11",   "bilinear_mip_vulkan",   "bilinear_mip_oiio",
                                  "trilinear_vulkan",    "trilinear_oiio",        "one_level_12",
                                  "one_level_24",        "stochastic_anisotropic"};

/// Messages of the peers that were dropped.
std::map<Who, std::string>& dropped() {
  static std::map<Who, std::string> all;
  return all;
}

}  // namespace

const char* name_of(Who who) {
  constexpr const char* kNames[] = {"shd", "OpenImageIO", "llvmpipe", "lavapipe"};
  return kNames[static_cast<size_t>(who)];
}

std::vector<Setting> all_settings() {
  std::vector<Setting> all;
  add_shd(&all);
#ifdef SHD_BENCH_OIIO
  add_peer(&all, Who::kOpenImageIO, SHD_PROFILE_OIIO);
#endif
#ifdef SHD_BENCH_OSMESA
  add_peer(&all, Who::kLlvmpipe, SHD_PROFILE_VULKAN, mesa_version(shd::bench::llvmpipe_description()));
#endif
#ifdef SHD_BENCH_LAVAPIPE
  if (shd::bench::lavapipe_problem().empty()) {
    add_peer(&all, Who::kLavapipe, SHD_PROFILE_VULKAN, mesa_version(shd::bench::lavapipe_description()));
  }
#endif
  const auto is_dropped = [](const Setting& setting) { return dropped().count(setting.who) > 0; };
  all.erase(std::remove_if(all.begin(), all.end(), is_dropped), all.end());
  const auto of_llvmpipe = [](const Setting& setting) { return setting.who == Who::kLlvmpipe; };
  const bool has_llvmpipe = std::any_of(all.begin(), all.end(), of_llvmpipe);
  for (Setting& setting : all) {
    const bool alike = setting.who == Who::kLavapipe && setting.peer != PeerFilter::kAnisotropic16;
    if (alike && has_llvmpipe) setting.pictured = false;
    for (const char* name : kAlike) setting.pictured = setting.pictured && setting.name != name;
  }
  return all;
}

std::vector<std::string> missing_peers() {
  std::vector<std::string> missing;
#ifndef SHD_BENCH_OIIO
  missing.push_back("OpenImageIO (Debian package libopenimageio-dev)");
#endif
#ifndef SHD_BENCH_OSMESA
  missing.push_back("llvmpipe through OSMesa (Debian package libosmesa6-dev)");
#endif
#ifdef SHD_BENCH_LAVAPIPE
  const std::string problem = shd::bench::lavapipe_problem();
  if (!problem.empty()) missing.push_back(problem + " (Debian package mesa-vulkan-drivers)");
#else
  missing.push_back("lavapipe (Debian packages libvulkan-dev, glslang-tools, mesa-vulkan-drivers)");
#endif
  for (const auto& [who, message] : dropped()) missing.push_back(message);
  return missing;
}

void drop_peer(Who who, const std::string& message) {
  dropped()[who] = message;
}

std::vector<std::string> peer_descriptions() {
  std::vector<std::string> all;
#ifdef SHD_BENCH_OIIO
  all.push_back("OpenImageIO " + shd::bench::openimageio_description());
#endif
#ifdef SHD_BENCH_OSMESA
  all.push_back("llvmpipe through OSMesa: " + shd::bench::llvmpipe_description());
#endif
#ifdef SHD_BENCH_LAVAPIPE
  if (shd::bench::lavapipe_problem().empty()) all.push_back("lavapipe: " + shd::bench::lavapipe_description());
#endif
  return all;
}

const Setting& setting_named(const std::vector<Setting>& settings, const std::string& name) {
  for (const Setting& setting : settings) {
    if (setting.name == name) return setting;
  }
  throw std::invalid_argument("setting: " + name + " is not in the list of --list");
}

}  // namespace shootout
