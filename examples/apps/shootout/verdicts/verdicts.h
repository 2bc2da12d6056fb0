// SPDX-License-Identifier: MIT
/// @file
/// Lookups of shd and of its peers, judged by shd_texture_bounds(), with the reason of each refusal.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <shd.hpp>
#include <string>
#include <vector>

#include "../peers.h"

namespace shootout {

constexpr shd_filter kJudgedFilters[] = {SHD_FILTER_NEAREST,      SHD_FILTER_BILINEAR,  SHD_FILTER_NEAREST_MIP,
                                         SHD_FILTER_BILINEAR_MIP, SHD_FILTER_TRILINEAR, SHD_FILTER_ANISOTROPIC};
constexpr size_t kJudgedFilterCount = sizeof kJudgedFilters / sizeof kJudgedFilters[0];
const char* name_of(shd_filter filter);

struct JudgedRules {
  shd_rules rules;
  const char* name;
  shd_profile profile;  // shd's profile of these rules
  bool own;             // the level of detail of the profile with the bits of the rules: for shd alone
};
constexpr JudgedRules kJudgedRules[] = {{SHD_RULES_VULKAN, "Vulkan", SHD_PROFILE_VULKAN, false},
                                        {SHD_RULES_D3D11, "Direct3D 11", SHD_PROFILE_D3D11, false},
                                        {SHD_RULES_WEBGPU, "WebGPU", SHD_PROFILE_VULKAN, false},
                                        {SHD_RULES_OPENGL, "OpenGL", SHD_PROFILE_VULKAN, false},
                                        {SHD_RULES_D3D11, "shd's default", SHD_PROFILE_LEAST_ERROR, true}};
constexpr size_t kJudgedRulesCount = sizeof kJudgedRules / sizeof kJudgedRules[0];

/// Textures whose texels are all levels, one after another: no level is an average of another one, so that a wrong
/// level shows.
std::vector<Texture> judged_textures();
/// Size of a level, and the place of its first texel among the texels.
uint32_t level_edge(const Texture& texture, uint32_t level);
uint32_t level_count(const Texture& texture);
const uint8_t* level_texels(const Texture& texture, uint32_t level);

/// Lookups at random places, some of them on borders and centres of texels. The longer axes of the footprints have 1/8
/// to 64 texels and any direction; their ratios are 1 to 16. The derivatives of half of them are the axes.
Lookups random_footprints(size_t count, uint32_t edge, uint64_t seed);
/// The lookups at some indices.
Lookups lookups_at(const Lookups& q, const std::vector<size_t>& indices);

/// Texture and filter of a batch of lookups.
struct Batch {
  const Texture& texture;
  shd_filter filter;
  const Lookups& lookups;
};

/// Texture and context of shd with the given levels.
class JudgedTexture {
 public:
  JudgedTexture(const Texture& texture, shd_simd simd, uint32_t workers);
  std::vector<float> sample(const Lookups& q, const shd_sampler_desc& sampler) const;

  shd::context context;
  shd::texture texture;
};
shd_sampler_desc judged_sampler(shd_filter filter, shd_profile profile);

/// Legal values of lookups, as packed RGBA.
struct Limits {
  std::vector<float> lower, upper;

  /// Distance of a value from its limits; 0 = legal. `i` is an index of the limits, `value` has four channels.
  float outside(size_t i, const float* value) const;
};
Limits limits_of(const JudgedTexture& texture, const Batch& batch, const shd_bounds_desc& desc,
                 shd_profile profile = SHD_PROFILE_VULKAN);

/// A thing that filters: a target of shd, or a peer.
struct Implementation {
  std::string name, family;  // the family has a list of departures
  /// Packed RGBA of every lookup. shd's results depend on the profile of the rules.
  std::function<std::vector<float>(const Batch& batch, shd_profile profile)> filter;
  bool is_own = false;   // a target of shd, judged by shd's default rules too
  bool is_fast = false;  // with SHD_PRECISION_FAST, whose levels of ANISOTROPIC the default rules have no bounds for
};
/// Every target of shd with both precisions, then the peers of this build.
std::vector<Implementation> judged_implementations();

/// A reason of refusals: the legal values of rules that have this departure, or a model of the implementation.
struct Departure {
  std::string name, text;
  std::function<bool(shd_filter filter)> concerns;
  std::function<Limits(const JudgedTexture& texture, const Batch& batch, const shd_bounds_desc& desc)> limits;
};
/// Departures of a family, the smallest first.
std::vector<Departure> departures_of(const std::string& family);

/// Verdicts on one implementation, filter and preset.
struct Tally {
  size_t implementation, filter, rules;
  size_t judged = 0, refused = 0, unexplained = 0;
  std::vector<size_t> explained;  // by departure of the family
  float farthest = 0.0f;          // largest distance of a refused value from its bounds
  float farthest_unexplained = 0.0f;
  std::string example;  // an unexplained lookup
};
struct Verdicts {
  std::vector<Implementation> implementations;
  std::map<std::string, std::vector<Departure>> departures;  // by family
  std::vector<Tally> tallies;
  size_t lookups = 0;  // judged lookups of each implementation
  double seconds = 0.0;
};

/// Judges about `count` lookups of each implementation. The share of anisotropic lookups is small, because their bounds
/// take longest.
Verdicts judge(std::vector<Implementation> implementations, size_t count);

/// Refused values of targets of shd: an error of shd, or of the bounds.
size_t own_refusals(const Verdicts& verdicts);
/// The verdicts as JSON, and as lines of text.
std::string json_of(const Verdicts& verdicts);
void print(const Verdicts& verdicts);

}  // namespace shootout
