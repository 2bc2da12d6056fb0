// SPDX-License-Identifier: MIT
// Bounds of every lookup, and the counts of values outside.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "../shd_pass.h"
#include "verdicts.h"

namespace shootout {
namespace {

constexpr double kAnisotropicShare = 0.04;

shd_bounds_desc preset_of(size_t rules) {
  shd::bounds_desc desc;
  shd::check(shd_bounds_desc_from_rules(kJudgedRules[rules].rules, &desc));
  if (kJudgedRules[rules].own) desc.level_rules = SHD_LEVEL_RULE_PROFILE;
  return desc;
}

std::string describe(const Batch& batch, size_t i, const float* value) {
  const Lookups& q = batch.lookups;
  char text[256];
  std::snprintf(text, sizeof text, "%s: (%.9g, %.9g), d/dx (%.9g, %.9g), d/dy (%.9g, %.9g): %.7g %.7g %.7g %.7g",
                batch.texture.name.c_str(), static_cast<double>(q.u[i]), static_cast<double>(q.v[i]),
                static_cast<double>(q.dudx[i]), static_cast<double>(q.dvdx[i]), static_cast<double>(q.dudy[i]),
                static_cast<double>(q.dvdy[i]), static_cast<double>(value[0]), static_cast<double>(value[1]),
                static_cast<double>(value[2]), static_cast<double>(value[3]));
  return text;
}

/// Takes the refused lookups that a departure explains out of the list. Returns their number.
size_t explain(const JudgedTexture& texture, const Batch& batch, const Departure& departure,
               const shd_bounds_desc& desc, const std::vector<float>& values, std::vector<size_t>* refused) {
  const Lookups some = lookups_at(batch.lookups, *refused);
  const Limits limits = departure.limits(texture, {batch.texture, batch.filter, some}, desc);
  std::vector<size_t> left;
  for (size_t k = 0; k < refused->size(); ++k) {
    const size_t i = (*refused)[k];
    if (limits.outside(k, &values[4 * i]) > 0.0f) left.push_back(i);
  }
  const size_t explained = refused->size() - left.size();
  refused->swap(left);
  return explained;
}

void judge_batch(const JudgedTexture& texture, const Batch& batch, const Limits& limits,
                 const std::vector<float>& values, const std::vector<Departure>& departures, Tally* tally) {
  std::vector<size_t> refused;
  for (size_t i = 0; i < batch.lookups.count(); ++i) {
    const float outside = limits.outside(i, &values[4 * i]);
    if (outside > 0.0f) refused.push_back(i);
    tally->farthest = std::max(tally->farthest, outside);
  }
  tally->judged += batch.lookups.count();
  tally->refused += refused.size();
  const shd_bounds_desc desc = preset_of(tally->rules);
  for (size_t d = 0; d < departures.size() && !refused.empty(); ++d) {
    if (!departures[d].concerns(batch.filter)) continue;
    tally->explained[d] += explain(texture, batch, departures[d], desc, values, &refused);
  }
  tally->unexplained += refused.size();
  for (const size_t i : refused) {
    const float outside = limits.outside(i, &values[4 * i]);
    if (!(outside > tally->farthest_unexplained)) continue;
    tally->farthest_unexplained = outside;
    tally->example = describe(batch, i, &values[4 * i]);
  }
}

/// Lookups of a batch: a square number, because rasterisers draw them as a frame.
size_t batch_size(shd_filter filter, size_t count, size_t textures) {
  const double share =
      filter == SHD_FILTER_ANISOTROPIC ? kAnisotropicShare : (1.0 - kAnisotropicShare) / (kJudgedFilterCount - 1);
  const double edge = std::ceil(std::sqrt(share * static_cast<double>(count) / static_cast<double>(textures)));
  return static_cast<size_t>(edge * edge);
}

Tally& tally_of(Verdicts* verdicts, size_t implementation, size_t filter, size_t rules) {
  return verdicts->tallies[(implementation * kJudgedFilterCount + filter) * kJudgedRulesCount + rules];
}

void judge_filter(const JudgedTexture& texture, const Batch& batch, size_t filter, Verdicts* verdicts) {
  std::vector<Limits> limits;
  for (size_t r = 0; r < kJudgedRulesCount; ++r) {
    limits.push_back(limits_of(texture, batch, preset_of(r), kJudgedRules[r].profile));
  }
  for (size_t k = 0; k < verdicts->implementations.size(); ++k) {
    const Implementation& implementation = verdicts->implementations[k];
    std::map<shd_profile, std::vector<float>> values;
    for (size_t r = 0; r < kJudgedRulesCount; ++r) {
      const bool has_bounds =
          implementation.is_own && !(implementation.is_fast && batch.filter == SHD_FILTER_ANISOTROPIC);
      if (kJudgedRules[r].own && !has_bounds) continue;
      const shd_profile profile = implementation.is_own ? kJudgedRules[r].profile : SHD_PROFILE_VULKAN;
      std::vector<float>& found = values[profile];
      if (found.empty()) found = implementation.filter(batch, profile);
      if (found.empty()) continue;
      judge_batch(texture, batch, limits[r], found, verdicts->departures[implementation.family],
                  &tally_of(verdicts, k, filter, r));
    }
  }
}

/// Empty tallies, and the departures of each family.
void prepare(Verdicts* verdicts) {
  for (size_t k = 0; k < verdicts->implementations.size(); ++k) {
    const std::string& family = verdicts->implementations[k].family;
    std::vector<Departure>& departures = verdicts->departures[family];
    if (departures.empty()) departures = departures_of(family);
    for (size_t f = 0; f < kJudgedFilterCount; ++f) {
      for (size_t r = 0; r < kJudgedRulesCount; ++r) {
        Tally tally;
        tally.implementation = k;
        tally.filter = f;
        tally.rules = r;
        tally.explained.resize(departures.size());
        verdicts->tallies.push_back(tally);
      }
    }
  }
}

}  // namespace

const char* name_of(shd_filter filter) {
  switch (filter) {
    case SHD_FILTER_NEAREST: return "nearest";
    case SHD_FILTER_BILINEAR: return "bilinear";
    case SHD_FILTER_NEAREST_MIP: return "nearest, one level";
    case SHD_FILTER_BILINEAR_MIP: return "bilinear, one level";
    case SHD_FILTER_TRILINEAR: return "trilinear";
    default: return "anisotropic 16";
  }
}

float Limits::outside(size_t i, const float* value) const {
  float most = 0.0f;
  for (size_t c = 0; c < 4; ++c) {
    const float by = std::max(lower[4 * i + c] - value[c], value[c] - upper[4 * i + c]);
    most = std::isfinite(value[c]) ? std::max(most, by) : HUGE_VALF;
  }
  return most;
}

Verdicts judge(std::vector<Implementation> implementations, size_t count) {
  const double start = now();
  Verdicts verdicts;
  verdicts.implementations = std::move(implementations);
  prepare(&verdicts);
  const std::vector<Texture> textures = judged_textures();
  for (size_t t = 0; t < textures.size(); ++t) {
    const JudgedTexture texture(textures[t], SHD_SIMD_BEST, 0);
    for (size_t f = 0; f < kJudgedFilterCount; ++f) {
      const size_t size = batch_size(kJudgedFilters[f], count, textures.size());
      const Lookups q = random_footprints(size, textures[t].edge, 1 + t * kJudgedFilterCount + f);
      judge_filter(texture, {textures[t], kJudgedFilters[f], q}, f, &verdicts);
      verdicts.lookups += size;
    }
  }
  verdicts.seconds = now() - start;
  return verdicts;
}

size_t own_refusals(const Verdicts& verdicts) {
  size_t refused = 0;
  for (const Tally& tally : verdicts.tallies) {
    if (verdicts.implementations[tally.implementation].is_own) refused += tally.refused;
  }
  return refused;
}

}  // namespace shootout
