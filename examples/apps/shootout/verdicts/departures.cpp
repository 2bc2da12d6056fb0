// SPDX-License-Identifier: MIT
// Reasons of refusals, the smallest first. docs/bounds.md has the experiments behind them.
#include "models.h"
#include "verdicts.h"

namespace shootout {
namespace {

using Concerns = std::function<bool(shd_filter filter)>;
using Change = std::function<void(shd_bounds_desc* desc, Batch* batch, Lookups* lookups)>;
using Model = std::function<std::vector<float>(const JudgedTexture& texture, const Batch& batch)>;

bool all_filters(shd_filter) {
  return true;
}
bool all_isotropic(shd_filter filter) {
  return filter != SHD_FILTER_ANISOTROPIC;
}
bool with_levels(shd_filter filter) {
  return filter != SHD_FILTER_NEAREST && filter != SHD_FILTER_BILINEAR;
}
bool without_levels(shd_filter filter) {
  return !with_levels(filter);
}
bool isotropic_levels(shd_filter filter) {
  return with_levels(filter) && all_isotropic(filter);
}
bool only_trilinear(shd_filter filter) {
  return filter == SHD_FILTER_TRILINEAR;
}
bool only_anisotropic(shd_filter filter) {
  return filter == SHD_FILTER_ANISOTROPIC;
}

/// Other numbers in the rules, or other lookups.
Departure relaxed(const std::string& name, const std::string& text, const Concerns& concerns, const Change& change) {
  return {name, text, concerns, [=](const JudgedTexture& texture, const Batch& batch, const shd_bounds_desc& desc) {
            shd_bounds_desc other = desc;
            Lookups q = batch.lookups;
            Batch moved = {batch.texture, batch.filter, q};
            change(&other, &moved, &q);
            return limits_of(texture, moved, other);
          }};
}

/// Values of a model, +-`error`.
Departure modelled(const std::string& name, const std::string& text, float error, const Model& values) {
  return {name, text, only_anisotropic, [=](const JudgedTexture& texture, const Batch& batch, const shd_bounds_desc&) {
            Limits limits;
            limits.lower = limits.upper = values(texture, batch);
            for (float& x : limits.lower) x -= error;
            for (float& x : limits.upper) x += error;
            return limits;
          }};
}

constexpr float kCode = 1.0f / 255.0f;

/// Results with fewer bits: 7 for results within a code, 6 for results within two.
Change bits(uint32_t count) {
  return [=](shd_bounds_desc* desc, Batch*, Lookups*) { desc->result_bits = count; };
}

Change linear_logarithm(uint32_t result_bits) {
  return [=](shd_bounds_desc* desc, Batch* batch, Lookups* q) {
    desc->result_bits = result_bits;
    q->lod = llvmpipe_levels(batch->texture, *q);
  };
}

std::vector<Departure> of_openimageio() {
  return {
      relaxed("level of the width",
              "The size of a footprint is the largest part of its derivatives in units of the texture. The coarser "
              "level is the first one on which it is at most a texel, and its share is linear in the size.",
              isotropic_levels,
              [](shd_bounds_desc*, Batch* batch, Lookups* q) {
                q->lod = openimageio_levels(batch->texture, *q, batch->filter != SHD_FILTER_TRILINEAR);
              }),
      modelled("Gaussian probes",
               "Up to 31 probes of Gaussian weight lie on a line of almost twice the longer axis. Shares of levels are "
               "linear in the width of the shorter axis.",
               kCode / 4.0f, [](const JudgedTexture& texture, const Batch& batch) {
                 return texture.sample(batch.lookups, judged_sampler(SHD_FILTER_ANISOTROPIC, SHD_PROFILE_OIIO));
               })};
}

std::vector<Departure> of_mesa() {
  const auto ellipse = [](bool texel_before) {
    return [=](const JudgedTexture&, const Batch& batch) {
      return llvmpipe_ellipses(batch.texture, batch.lookups, texel_before);
    };
  };
  return {relaxed("linear logarithm",
                  "The logarithm of the squared size is linear between powers of two, so that a level is up to 0.043 "
                  "off.",
                  only_trilinear, linear_logarithm(8)),
          relaxed("8-bit steps",
                  "Blends along u, along v and between levels are each rounded to 8 bits, so that a result is up to a "
                  "code off, not half a code.",
                  all_isotropic, bits(7)),
          relaxed("linear logarithm, 8-bit steps", "Both of these departures.", only_trilinear, linear_logarithm(7)),
          relaxed("linear logarithm, three 8-bit steps", "Both, and the three roundings add up to more than a code.",
                  only_trilinear, linear_logarithm(6)),
          modelled("ellipse",
                   "Anisotropic lookups average the texels of one level under an elliptical Gaussian (Heckbert 1989), "
                   "not probes on a line. The level is that of the shorter column, rounded down.",
                   0.6f * kCode, ellipse(false)),
          modelled("ellipse, texel before",
                   "The ellipse reads texel i of n at the rounded number i / n, which lies in texel i - 1 for some i "
                   "where n is not a power of two.",
                   0.6f * kCode, ellipse(true))};
}

/// For implementations without a list of their own.
std::vector<Departure> of_anything() {
  const auto every_rule = [](shd_bounds_desc* desc, Batch*, Lookups*) {
    desc->level_rules = SHD_LEVEL_RULE_LENGTHS | SHD_LEVEL_RULE_ELLIPSE | SHD_LEVEL_RULE_VULKAN | SHD_LEVEL_RULE_OPENGL;
  };
  const auto half_texel = [](shd_bounds_desc*, Batch* batch, Lookups* q) {
    const float half = 0.5f / static_cast<float>(batch->texture.edge);
    for (float& u : q->u) u += half;
    for (float& v : q->v) v += half;
  };
  return {relaxed("one code", "Results are up to a code of 8 bits off.", all_filters, bits(7)),
          relaxed("level of another API", "The level of detail is legal in another API.", with_levels, every_rule),
          relaxed("half a texel", "Centres of texels are taken for their corners.", without_levels, half_texel)};
}

}  // namespace

std::vector<Departure> departures_of(const std::string& family) {
  if (family == "OpenImageIO") return of_openimageio();
  if (family == "llvmpipe" || family == "lavapipe") return of_mesa();
  return of_anything();
}

}  // namespace shootout
