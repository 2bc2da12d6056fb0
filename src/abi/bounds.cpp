// SPDX-License-Identifier: MIT
#include <shd/bounds.h>

#include <array>
#include <atomic>
#include <memory>

#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "abi/lookup.h"
#include "texture/domain/profile.h"
#include "texture/oracle/bounds/bounds.h"
#include "texture/oracle/bounds/fold.h"

namespace {

using namespace shd;
using namespace shd::abi;

constexpr uint32_t kRules = SHD_LEVEL_RULE_LENGTHS | SHD_LEVEL_RULE_ELLIPSE | SHD_LEVEL_RULE_VULKAN |
                            SHD_LEVEL_RULE_OPENGL | SHD_LEVEL_RULE_PROFILE;
constexpr size_t kBounds = 8;  // columns of `lower`, then of `upper`
using BoundsBatch = Batch<kLookupColumns, kBounds>;

shd_result check_model(const shd_bounds_desc& desc) {
  SHD_TRY(check_flags("bounds.level_rules", desc.level_rules, kRules));
  SHD_TRY(check_count("bounds.level_rules", desc.level_rules, 1, kRules));
  SHD_TRY(check_count("bounds.subtexel_bits", desc.subtexel_bits, 2, 24));
  SHD_TRY(check_count("bounds.level_bits", desc.level_bits, 1, 24));
  SHD_TRY(check_count("bounds.weight_bits", desc.weight_bits, 0, 24));
  SHD_TRY(check_count("bounds.result_bits", desc.result_bits, 0, 24));
  SHD_TRY(check_range("bounds.coordinate_error", static_cast<double>(desc.coordinate_error), 0.0, 0.0625));
  SHD_TRY(check_range("bounds.derivative_error", static_cast<double>(desc.derivative_error), 0.0, 0.5));
  SHD_TRY(check_range("bounds.level_error", static_cast<double>(desc.level_error), 0.0, 16.0));
  SHD_TRY(check_range("bounds.relative_error", static_cast<double>(desc.relative_error), 0.0, 1.0));
  return check_range("bounds.srgb_error", static_cast<double>(desc.srgb_error), 0.0, 1.0);
}

/// Whether bounds are defined for a texture and a sampler.
shd_result check_bounded(const texture::Texture& texture, const texture::Sampler& sampler, uint32_t rules) {
  const auto refuse = [](const char* what) { return core::fail(SHD_ERROR_UNSUPPORTED, "%s has no bounds", what); };
  SHD_TRY(check_lookups(texture, sampler, texture::Use::kBounds));
  if (const char* const reason = texture::bounds_refusal_of(texture.projection)) {
    return core::fail(SHD_ERROR_UNSUPPORTED, "texture.projection: %s", reason);
  }
  if (sampler.magnification == SHD_MAGNIFICATION_NEAREST && sampler.filter == SHD_FILTER_ANISOTROPIC) {
    return refuse("sampler.magnification: NEAREST of ANISOTROPIC");
  }
  if (sampler.blur_u != 0.0f || sampler.blur_v != 0.0f) return refuse("sampler.blur_u, blur_v: not 0, which");
  if (sampler.level_steepness != 1.0f) return refuse("sampler.level_blend: not 1, which");
  const bool lines = sampler.filter == SHD_FILTER_ANISOTROPIC && !texture::is_foreign(sampler.profile);
  if (lines && sampler.precision == SHD_PRECISION_FAST) return refuse("sampler.precision: FAST of ANISOTROPIC");
  if (rules & SHD_LEVEL_RULE_PROFILE && sampler.profile == SHD_PROFILE_OIIO) return refuse("sampler.profile: OIIO");
  return SHD_OK;
}

shd_result read_bounds(const char* name, const char* channel, const shd_texels* in, OutColumn* out) {
  shd_texels texels = shd_texels_default();
  SHD_TRY(read_desc(name, in, false, &texels));
  for (int c = 0; c < 4; ++c) {
    if (texels.du[c].data || texels.dv[c].data || texels.dw[c].data) {
      return core::fail(SHD_ERROR_UNSUPPORTED, "%s.du, dv, dw: set, but bounds have no derivatives", name);
    }
    out[c] = out_column(channel, texels.channel[c], Need::kOptional, c);
  }
  return SHD_OK;
}

shd_result check_columns_of(const BoundsBatch& batch) {
  SHD_TRY(check_columns(batch.out.data(), kBounds, batch.count));
  bool wanted = batch.count == 0;
  for (const OutColumn& column : batch.out) wanted = wanted || column.data;
  if (!wanted) return core::fail(SHD_ERROR_INVALID_ARGUMENT, "lower.channel, upper.channel: NULL for all");
  return check_overlap(batch.in.data(), kLookupColumns, batch.out.data(), kBounds, batch.count);
}

size_t find_piece(const texture::Texture& texture, const texture::Sampler& sampler, const texture::BoundsModel& model,
                  const Piece<kLookupColumns, kBounds>& piece) {
  float *lower[4], *upper[4];
  for (size_t c = 0; c < 4; ++c) {
    lower[c] = piece.out_floats(c);
    upper[c] = piece.out_floats(4 + c);
  }
  return texture::find_bounds(texture, sampler, model, lookups_of(piece), lower, upper);
}

void write_count(size_t count, shd_texels* out) {
  constexpr size_t kEnd = offsetof(shd_texels, nonfinite_count) + sizeof out->nonfinite_count;
  if (out->struct_size >= kEnd) out->nonfinite_count = count;
}

}  // namespace

extern "C" {

shd_result shd_bounds_desc_from_rules(shd_rules rules, shd_bounds_desc* out_desc) {
  return guard([&]() -> shd_result {
    SHD_TRY(begin_output("out_desc", out_desc));
    SHD_TRY(check_enum("bounds_preset.rules", rules, SHD_RULES_VULKAN, SHD_RULES_OPENGL));
    write_desc(texture::preset_of(rules), out_desc);
    return SHD_OK;
  });
}

shd_result shd_texture_bounds(const shd_texture* texture, const shd_sampler* sampler, const shd_lookups* lookups,
                              const shd_bounds_desc* desc, shd_texels* lower, shd_texels* upper) {
  return guard([&]() -> shd_result {
    const texture::Texture* texture_body;
    const texture::Sampler* sampler_body;
    SHD_TRY(read_texture_and_sampler(texture, sampler, &texture_body, &sampler_body));
    shd_bounds_desc bounds = shd_bounds_desc_default();
    SHD_TRY(read_desc("bounds", desc, true, &bounds));
    SHD_TRY(check_model(bounds));
    SHD_TRY(check_bounded(*texture_body, *sampler_body, bounds.level_rules));
    BoundsBatch batch;
    SHD_TRY(read_lookups(lookups, *texture_body, &batch.in, &batch.count));
    SHD_TRY(read_bounds("lower", "lower.channel", lower, batch.out.data()));
    SHD_TRY(read_bounds("upper", "upper.channel", upper, batch.out.data() + 4));
    SHD_TRY(check_columns_of(batch));
    const texture::BoundsModel model = texture::make_bounds_model(bounds);
    std::atomic<size_t> nonfinite{0};
    run_batch(*object_of(texture)->context, batch, [&](const Piece<kLookupColumns, kBounds>& piece) {
      const size_t found = find_piece(*texture_body, *sampler_body, model, piece);
      if (found) nonfinite.fetch_add(found, std::memory_order_relaxed);
    });
    write_count(nonfinite.load(std::memory_order_relaxed), lower);
    write_count(nonfinite.load(std::memory_order_relaxed), upper);
    return SHD_OK;
  });
}

}  // extern "C"
