// SPDX-License-Identifier: MIT
// Judged implementations: the targets of shd, and the peers of this build.
#include <algorithm>

#include "../shd_pass.h"
#include "verdicts.h"

namespace shootout {
namespace {

shd_lookups columns_with_levels(const Lookups& q) {
  shd_lookups columns = columns_of(q);
  if (!q.lod.empty()) columns.lod = shd::in(q.lod);
  return columns;
}

shd_texels packed(std::vector<float>* rgba) {
  shd::texels out;
  for (size_t c = 0; c < 4; ++c) out.channel[c] = shd_f32_out_column(rgba->data() + c, 4 * sizeof(float));
  return out;
}

/// A target of shd. Textures are made once for each context.
Implementation own(shd_simd simd, const std::string& target, shd_precision precision) {
  Implementation out;
  out.name = "shd " + target + (precision == SHD_PRECISION_FAST ? ", FAST" : ", FULL");
  out.family = "shd";
  out.is_own = true;
  out.is_fast = precision == SHD_PRECISION_FAST;
  const auto textures = std::make_shared<std::map<std::string, std::unique_ptr<JudgedTexture>>>();
  out.filter = [=](const Batch& batch, shd_profile profile) {
    std::unique_ptr<JudgedTexture>& texture = (*textures)[batch.texture.name];
    if (!texture) texture = std::make_unique<JudgedTexture>(batch.texture, simd, 0);
    shd_sampler_desc sampler = judged_sampler(batch.filter, profile);
    sampler.precision = precision;
    return texture->sample(batch.lookups, sampler);
  };
  return out;
}

void add_own(std::vector<Implementation>* all) {
  std::vector<std::string> seen;
  for (int simd = SHD_SIMD_BASELINE; simd <= SHD_SIMD_WASM; ++simd) {
    shd::context_desc desc;
    desc.simd = static_cast<shd_simd>(simd);
    shd_context* context = nullptr;
    if (shd_context_create(&desc, &context) != SHD_OK) continue;
    const std::string target = shd_context_get_simd_target(context);
    shd_context_release(context);
    if (std::find(seen.begin(), seen.end(), target) != seen.end()) continue;
    seen.push_back(target);
    for (const shd_precision precision : {SHD_PRECISION_FULL, SHD_PRECISION_FAST}) {
      all->push_back(own(desc.simd, target, precision));
    }
  }
}

/// A peer filters one texture with one wrapper.
Implementation peer(Who who) {
  Implementation out;
  out.name = out.family = name_of(who);
  const auto settings = std::make_shared<std::vector<Setting>>(all_settings());
  out.filter = [=](const Batch& batch, shd_profile) {
    for (const Setting& setting : *settings) {
      if (setting.who != who || setting.sampler.filter != batch.filter) continue;
      Peers peers(batch.texture);
      return peers.filter(setting, Workload(), batch.lookups);
    }
    return std::vector<float>();
  };
  return out;
}

}  // namespace

JudgedTexture::JudgedTexture(const Texture& from, shd_simd simd, uint32_t workers) {
  shd::context_desc desc;
  desc.simd = simd;
  desc.worker_count = workers;
  context = shd::context_create(&desc);
  std::vector<shd_image> levels;
  for (uint32_t level = 1; level < level_count(from); ++level) {
    shd::image image;
    image.format = SHD_FORMAT_RGBA8;
    image.width = image.height = level_edge(from, level);
    image.pixels = const_cast<uint8_t*>(level_texels(from, level));
    levels.push_back(image);
  }
  shd::texture_desc made;
  made.format = SHD_FORMAT_RGBA8;
  made.width = made.height = from.edge;
  made.texels = from.rgba.data();
  made.tables = SHD_TABLE_MIPMAP;
  made.level_images = levels.data();
  made.level_count = static_cast<uint32_t>(levels.size());
  texture = shd::texture_create(context, &made);
}

std::vector<float> JudgedTexture::sample(const Lookups& q, const shd_sampler_desc& desc) const {
  const shd::sampler sampler = shd::sampler_create(context, &desc);
  const shd_lookups columns = columns_with_levels(q);
  std::vector<float> rgba(4 * q.count());
  shd_texels out = packed(&rgba);
  shd::check(shd_texture_sample(texture, sampler, &columns, &out));
  return rgba;
}

shd_sampler_desc judged_sampler(shd_filter filter, shd_profile profile) {
  shd::sampler_desc desc;
  desc.filter = filter;
  desc.profile = profile;
  desc.wrap_u = desc.wrap_v = SHD_WRAP_REPEAT;
  desc.max_anisotropy = 16.0f;
  return desc;
}

Limits limits_of(const JudgedTexture& texture, const Batch& batch, const shd_bounds_desc& desc, shd_profile profile) {
  const shd_sampler_desc rules = judged_sampler(batch.filter, profile);
  const shd::sampler sampler = shd::sampler_create(texture.context, &rules);
  const shd_lookups columns = columns_with_levels(batch.lookups);
  Limits limits;
  limits.lower.resize(4 * batch.lookups.count());
  limits.upper.resize(4 * batch.lookups.count());
  shd_texels lower = packed(&limits.lower), upper = packed(&limits.upper);
  shd::check(shd_texture_bounds(texture.texture, sampler, &columns, &desc, &lower, &upper));
  return limits;
}

std::vector<Implementation> judged_implementations() {
  std::vector<Implementation> all;
  add_own(&all);
  std::vector<Who> seen;
  for (const Setting& setting : all_settings()) {
    if (setting.who == Who::kShd || std::find(seen.begin(), seen.end(), setting.who) != seen.end()) continue;
    seen.push_back(setting.who);
    all.push_back(peer(setting.who));
  }
  return all;
}

}  // namespace shootout
