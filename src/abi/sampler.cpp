// SPDX-License-Identifier: MIT
#include <shd/sampler.h>

#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "texture/texture.h"

namespace {

using namespace shd;
using namespace shd::abi;

/// SHD_FILTER_STOCHASTIC estimates filters whose weights are positive.
shd_result check_stochastic_filter(shd_filter filter) {
  switch (enum_bits(filter)) {
    case SHD_FILTER_TRILINEAR:
    case SHD_FILTER_BILINEAR:
    case SHD_FILTER_BICUBIC:
    case SHD_FILTER_ANISOTROPIC:
    case SHD_FILTER_EWA: return SHD_OK;
    default:
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "sampler.stochastic_filter: %u is not a filter that can be sampled",
                        enum_bits(filter));
  }
}

/// Negative weights are no probabilities: of the cubic kernels only the B-spline has none.
shd_result check_stochastic_cubic(const shd_sampler_desc& desc) {
  if (desc.filter != SHD_FILTER_STOCHASTIC || desc.stochastic_filter != SHD_FILTER_BICUBIC) return SHD_OK;
  if (desc.cubic == SHD_CUBIC_B_SPLINE) return SHD_OK;
  return core::fail(SHD_ERROR_INVALID_ARGUMENT,
                    "sampler.cubic: %u is not SHD_CUBIC_B_SPLINE, the only one that can be sampled",
                    enum_bits(desc.cubic));
}

/// Quads are the lookups of filters on mip levels.
shd_result check_stochastic_quad(const shd_sampler_desc& desc) {
  if (desc.filter != SHD_FILTER_STOCHASTIC || desc.stochastic != SHD_STOCHASTIC_QUAD) return SHD_OK;
  if (desc.stochastic_filter == SHD_FILTER_TRILINEAR || desc.stochastic_filter == SHD_FILTER_ANISOTROPIC) return SHD_OK;
  return core::fail(SHD_ERROR_INVALID_ARGUMENT,
                    "sampler.stochastic: SHD_STOCHASTIC_QUAD needs SHD_FILTER_TRILINEAR or SHD_FILTER_ANISOTROPIC, not "
                    "sampler.stochastic_filter: %u",
                    enum_bits(desc.stochastic_filter));
}

shd_result check_footprint(const shd_sampler_desc& desc) {
  SHD_TRY(check_range("sampler.lod_bias", static_cast<double>(desc.lod_bias), -15, 15));
  SHD_TRY(check_range("sampler.lod_min", static_cast<double>(desc.lod_min), 0, 32));
  SHD_TRY(check_range("sampler.lod_max", static_cast<double>(desc.lod_max), 0, 32));
  SHD_TRY(check_range("sampler.width_x", static_cast<double>(desc.width_x), 0, 64));
  SHD_TRY(check_range("sampler.width_y", static_cast<double>(desc.width_y), 0, 64));
  SHD_TRY(check_range("sampler.blur_u", static_cast<double>(desc.blur_u), 0, 1));
  SHD_TRY(check_range("sampler.blur_v", static_cast<double>(desc.blur_v), 0, 1));
  SHD_TRY(check_range("sampler.max_anisotropy", static_cast<double>(desc.max_anisotropy), 1, 64));
  SHD_TRY(check_range("sampler.probe_slack", static_cast<double>(desc.probe_slack), 0, 1));
  SHD_TRY(check_range("sampler.level_blend", static_cast<double>(desc.level_blend), 0, 1));
  if (desc.max_texels != 0 && desc.max_texels < 32) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "sampler.max_texels: %u is neither 0 nor 32 or more",
                      desc.max_texels);
  }
  return check_range("sampler.tolerance", static_cast<double>(desc.tolerance), 0x1p-12, 1);
}

shd_result check_sampler_desc(const shd_sampler_desc& desc) {
  SHD_TRY(check_enum("sampler.filter", desc.filter, SHD_FILTER_TRILINEAR, texture::last_filter()));
  SHD_TRY(
      check_enum("sampler.magnification", desc.magnification, SHD_MAGNIFICATION_DEFAULT, SHD_MAGNIFICATION_HERMITE));
  SHD_TRY(check_enum("sampler.wrap_u", desc.wrap_u, SHD_WRAP_REPEAT, SHD_WRAP_MIRROR_ONCE));
  SHD_TRY(check_enum("sampler.wrap_v", desc.wrap_v, SHD_WRAP_REPEAT, SHD_WRAP_MIRROR_ONCE));
  SHD_TRY(check_enum("sampler.wrap_w", desc.wrap_w, SHD_WRAP_REPEAT, SHD_WRAP_MIRROR_ONCE));
  SHD_TRY(check_enum("sampler.missing_tiles", desc.missing_tiles, SHD_MISSING_TILES_WAIT, SHD_MISSING_TILES_COARSER));
  SHD_TRY(check_count("sampler.compares", desc.compares, 0, 1));
  SHD_TRY(check_enum("sampler.compare", desc.compare, SHD_COMPARE_LESS, SHD_COMPARE_NEVER));
  SHD_TRY(check_finite("sampler.border", desc.border, 4));
  SHD_TRY(check_footprint(desc));
  SHD_TRY(check_enum("sampler.probe_weights", desc.probe_weights, SHD_PROBE_WEIGHTS_EQUAL, SHD_PROBE_WEIGHTS_GAUSSIAN));
  SHD_TRY(check_enum("sampler.cubic", desc.cubic, SHD_CUBIC_CATMULL_ROM, SHD_CUBIC_MITCHELL));
  SHD_TRY(check_enum("sampler.box", desc.box, SHD_BOX_BOUNDING, SHD_BOX_ORIENTED));
  SHD_TRY(check_enum("sampler.profile", desc.profile, SHD_PROFILE_LEAST_ERROR, SHD_PROFILE_EXACT));
  SHD_TRY(check_enum("sampler.precision", desc.precision, SHD_PRECISION_FULL, SHD_PRECISION_FAST));
  SHD_TRY(check_stochastic_filter(desc.stochastic_filter));
  SHD_TRY(check_stochastic_cubic(desc));
  SHD_TRY(check_enum("sampler.stochastic", desc.stochastic, SHD_STOCHASTIC_TEXEL, SHD_STOCHASTIC_QUAD));
  return check_stochastic_quad(desc);
}

}  // namespace

extern "C" {

shd_result shd_sampler_create(shd_context* context, const shd_sampler_desc* desc, shd_sampler** out_sampler) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_not_null("out_sampler", out_sampler));
    *out_sampler = nullptr;
    SHD_TRY(check_context(context));
    shd_sampler_desc read = shd_sampler_desc_default();
    SHD_TRY(read_desc("sampler", desc, true, &read));
    SHD_TRY(check_sampler_desc(read));

    core::Context& owner = context_of(context);
    auto* body = core::create<texture::Sampler>(owner.allocator);
    *body = texture::make_sampler(read);
    make_handle(owner, core::ObjectType::kSampler, body, out_sampler);
    return SHD_OK;
  });
}

void shd_sampler_retain(shd_sampler* sampler) {
  retain_handle(sampler, core::ObjectType::kSampler);
}

void shd_sampler_release(shd_sampler* sampler) {
  release_handle(sampler, core::ObjectType::kSampler);
}

}  // extern "C"
