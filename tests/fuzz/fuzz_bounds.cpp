// SPDX-License-Identifier: MIT
// Random textures, samplers, lookups and models of precision for shd_texture_bounds(). No call may crash, leak or write
// outside its columns. Bounds are a clear error or lower <= upper, never NaN, and have the same bits on every SIMD
// target. Where the model allows the arithmetic of shd, the values of shd_texture_sample() are inside.
#include "lookup_case.h"
#include "mutator.h"

namespace shd::fuzz {
namespace {

constexpr uint32_t kRuleBits = 31;  // every shd_level_rule

struct BoundsCase : LookupCase {
  shd_bounds_desc desc = shd_bounds_desc_default();
  bool is_default = false;  // NULL instead of a desc
};

/// Mostly samplers that have bounds.
void choose_bounded_sampler(Source& source, BoundsCase& c) {
  shd_sampler_desc& desc = c.sampler;
  choose_sampler(source, desc);
  constexpr shd_filter kBounded[] = {SHD_FILTER_NEAREST,           SHD_FILTER_BILINEAR,  SHD_FILTER_NEAREST_MIP,
                                     SHD_FILTER_BILINEAR_MIP,      SHD_FILTER_TRILINEAR, SHD_FILTER_ANISOTROPIC,
                                     SHD_FILTER_NEAREST_MIP_LINEAR};
  const shd_filter filter = kBounded[source.below(7)];
  if (source.one_in(32)) return;
  desc.filter = filter;
  constexpr shd_magnification kMagnifications[] = {SHD_MAGNIFICATION_DEFAULT, SHD_MAGNIFICATION_NEAREST,
                                                   SHD_MAGNIFICATION_BILINEAR};
  desc.magnification = kMagnifications[source.below(3)];
  if (filter == SHD_FILTER_ANISOTROPIC && desc.magnification == SHD_MAGNIFICATION_NEAREST) {
    desc.magnification = SHD_MAGNIFICATION_DEFAULT;  // ANISOTROPIC with NEAREST has no bounds
  }
  desc.blur_u = desc.blur_v = 0.0f;
  desc.level_blend = 1.0f;
}

void choose_bounded_texture(Source& source, BoundsCase& c) {
  const bool is_large = source.one_in(8);  // an axis of more than 64 texels
  choose_texture(source, c.texture, is_large ? 80 : 9);
  if (!source.one_in(32)) c.texture.desc.tables |= SHD_TABLE_MIPMAP;
  choose_lookups(source, c);
  if (!source.one_in(4)) c.columns[6].clear();  // the level of detail comes from derivatives
  // Channels of `lower`, of `upper`, and derivatives, which bounds do not have.
  c.outputs = source.one_in(4) ? source.below(256) : 255;
  if (source.one_in(64)) c.outputs |= source.below(16) << 8;
  if (source.one_in(3)) return choose_slices(source, c);
  if (!source.one_in(2)) return;
  choose_directions(source, c);
}

/// Numbers of a model, most of them in range.
void choose_numbers(Source& source, shd_bounds_desc& desc) {
  const auto bits = [&](uint32_t* to) {
    if (source.one_in(2)) *to = source.one_in(16) ? source.word() : source.between(0, 25);
  };
  const auto error = [&](float* to, float most) {
    if (source.one_in(2)) *to = source.real(0, most);
  };
  bits(&desc.subtexel_bits);
  bits(&desc.level_bits);
  bits(&desc.weight_bits);
  bits(&desc.result_bits);
  error(&desc.coordinate_error, 0.0625f);
  error(&desc.derivative_error, 0.5f);
  error(&desc.level_error, 16.0f);
  error(&desc.relative_error, 1.0f);
  error(&desc.srgb_error, 1.0f);
}

/// A preset, a preset with the rules of the sampler's profile, or numbers of its own.
void choose_model(Source& source, BoundsCase& c) {
  const auto rules = source.constant<shd_rules>(4);
  const shd_result result = shd_bounds_desc_from_rules(rules, &c.desc);
  SHD_FUZZ_CHECK(result == (rules <= SHD_RULES_OPENGL ? SHD_OK : SHD_ERROR_INVALID_ARGUMENT));
  c.is_default = source.one_in(16);
  if (source.one_in(2)) c.desc.level_rules = SHD_LEVEL_RULE_PROFILE;
  if (source.one_in(4)) c.desc.level_rules = source.flags(kRuleBits);
  if (source.one_in(4)) choose_numbers(source, c.desc);
  if (source.one_in(64)) c.desc.struct_size = source.one_in(2) ? source.below(16) : 0x80000000u | source.word();
}

void choose_case(Source& source, BoundsCase& c) {
  c.budget = choose_budget(source);
  choose_bounded_sampler(source, c);
  choose_bounded_texture(source, c);
  choose_model(source, c);
}

/// Whether a model has a definition of the footprint that shd follows in this profile.
bool has_rule_of(shd_profile profile, uint32_t rules) {
  if (rules & SHD_LEVEL_RULE_PROFILE) return true;
  if (profile == SHD_PROFILE_VULKAN) return rules & SHD_LEVEL_RULE_LENGTHS;
  return profile != SHD_PROFILE_LEAST_ERROR && rules & SHD_LEVEL_RULE_ELLIPSE;
}

/// Whether a model that the library accepts has no more precision than the rules of Direct3D 11, to which shd's
/// arithmetic conforms.
bool allows_shd(const shd_bounds_desc& desc, shd_profile profile) {
  shd_bounds_desc most = shd_bounds_desc_default();
  SHD_FUZZ_CHECK(shd_bounds_desc_from_rules(SHD_RULES_D3D11, &most) == SHD_OK);
  return profile != SHD_PROFILE_OIIO && has_rule_of(profile, desc.level_rules) &&
         desc.subtexel_bits <= most.subtexel_bits && desc.level_bits <= most.level_bits && desc.weight_bits != 0 &&
         desc.weight_bits <= most.weight_bits && desc.result_bits != 0 && desc.result_bits <= most.result_bits &&
         desc.coordinate_error >= most.coordinate_error && desc.level_error >= most.level_error &&
         desc.relative_error >= most.relative_error && desc.srgb_error >= most.srgb_error;
}

/// Four columns of one call.
struct Columns {
  Columns(const BoundsCase& c, uint32_t channels, uint32_t derivatives)
      : values(4, Column<float>(c.count, c.out_step, kCanary)), wanted(channels) {
    for (size_t k = 0; k < 4; ++k) {
      if (wanted >> k & 1) texels.channel[k] = to_column(values[k]);
      if (derivatives >> k & 1) texels.du[k] = to_column(values[k]);
    }
  }

  void check_canaries(bool made) const {
    for (size_t k = 0; k < 4; ++k) values[k].check_canaries(made && wanted >> k & 1 ? values[k].size() : 0);
  }

  std::vector<Column<float>> values;
  uint32_t wanted;
  shd_texels texels = shd_texels_default();
};

/// Results of one run.
struct Output {
  bool made = false;
  size_t nonfinite_count = 0;
  std::vector<float> values;
};

/// NaN is legal where a texel of the lookup is not finite.
bool is_inside(float value, float low, float high) {
  return std::isnan(value) ? low == -HUGE_VALF && high == HUGE_VALF : low <= value && value <= high;
}

void compare_with_sample(const Host& host, const BoundsCase& c, const Objects& o, const Columns& lower,
                         const Columns& upper) {
  const shd_lookups lookups = make_lookups(c);
  Columns own(c, 15, 0);
  if (!host.ok(shd_texture_sample(o.texture, o.sampler, &lookups, &own.texels))) return;
  SHD_FUZZ_CHECK(own.texels.nonfinite_count == lower.texels.nonfinite_count);
  if (!allows_shd(c.is_default ? shd_bounds_desc_default() : c.desc, c.sampler.profile)) return;
  for (size_t k = 0; k < 4; ++k) {
    for (size_t i = 0; i < c.count; ++i) {
      const float low = lower.wanted >> k & 1 ? lower.values[k][i] : -HUGE_VALF;
      const float high = upper.wanted >> k & 1 ? upper.values[k][i] : HUGE_VALF;
      SHD_FUZZ_CHECK(is_inside(own.values[k][i], low, high));
    }
  }
}

void find_bounds(const Host& host, const BoundsCase& c, const Objects& o, Output& output) {
  const shd_lookups lookups = make_lookups(c);
  const uint32_t derivatives = c.outputs >> 8 & 15;
  Columns lower(c, c.outputs & 15, derivatives), upper(c, c.outputs >> 4 & 15, 0);
  output.made = host.ok(shd_texture_bounds(o.texture, o.sampler, &lookups, c.is_default ? nullptr : &c.desc,
                                           &lower.texels, &upper.texels));
  SHD_FUZZ_CHECK(!output.made || derivatives == 0);
  lower.check_canaries(output.made);
  upper.check_canaries(output.made);
  for (size_t k = 0; k < 4; ++k) {
    for (size_t i = 0; i < c.count; ++i) {
      const float low = lower.values[k][i], high = upper.values[k][i];
      output.values.insert(output.values.end(), {low, high});
      if (!output.made) continue;
      SHD_FUZZ_CHECK(!std::isnan(low) && !std::isnan(high));
      if (lower.wanted & upper.wanted & 1u << k) SHD_FUZZ_CHECK(low <= high);
    }
  }
  if (!output.made) return;
  output.nonfinite_count = lower.texels.nonfinite_count;
  SHD_FUZZ_CHECK(output.nonfinite_count <= c.count && output.nonfinite_count == upper.texels.nonfinite_count);
  compare_with_sample(host, c, o, lower, upper);
}

/// Runs the case on one target.
void run(const BoundsCase& c, shd_simd simd, Output& output) {
  Host host(simd, c.budget);
  if (!host.context) return;
  Objects o;
  if (host.ok(shd_texture_create(host.context, &c.texture.desc, &o.texture)) &&
      host.ok(shd_sampler_create(host.context, &c.sampler, &o.sampler))) {
    find_bounds(host, c, o, output);
  } else {
    SHD_FUZZ_CHECK(!o.sampler);
  }
}

}  // namespace

void describe(Source& source) {
  BoundsCase c;
  choose_case(source, c);
}

}  // namespace shd::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace shd::fuzz;
  compare_targets<BoundsCase, Output>(data, size, choose_case, run, [](const Output& best, const Output& baseline) {
    SHD_FUZZ_CHECK(baseline.made == best.made);
    SHD_FUZZ_CHECK(best.nonfinite_count == baseline.nonfinite_count);
    SHD_FUZZ_CHECK(same_values(best.values, baseline.values));
  });
  return 0;
}
