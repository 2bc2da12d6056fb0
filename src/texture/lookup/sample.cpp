// SPDX-License-Identifier: MIT
// Dispatch of a lookup to the kernels of its filter and format on one target; the swizzle of the results.
#include "texture/lookup/sample.h"

#include <algorithm>
#include <cstring>

#include "core/simd_narrow.h"
#include "core/status.h"
#include "data/compare.h"
#include "texture/format/formats.h"
#include "texture/format/record.h"
#include "texture/lookup/coarser.h"
#include "texture/lookup/fast.h"
#include "texture/lookup/magnify.h"
#include "texture/store/stores.h"
#include "texture/table/decoded.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/lookup/sample.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/filter/directions-inl.h"
#include "texture/filter/filters-inl.h"
#include "texture/format/formats-inl.h"
#include "texture/format/record-inl.h"
#include "texture/lookup/fixed_lines-inl.h"
#include "texture/lookup/fused-inl.h"
#include "texture/store/place-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {

RunFilter PlaneFilterOf(shd_filter filter) {
  switch (filter) {
#define SHD_TEXTURE_CASE(name, run, gradient) \
  case name: return run;
    SHD_TEXTURE_FILTERS(SHD_TEXTURE_CASE)
#undef SHD_TEXTURE_CASE
    case SHD_FILTER_MAX_ENUM: break;
  }
  return nullptr;
}

RunFilter SliceFilterOf(shd_filter filter) {
  switch (filter) {
#define SHD_TEXTURE_CASE(name, run) \
  case name: return run;
    SHD_TEXTURE_SLICE_FILTERS(SHD_TEXTURE_CASE)
#undef SHD_TEXTURE_CASE
    default: return nullptr;
  }
}

/// Returns the consumer of values.
Consume ConsumerOf(const Texture& texture, const Sampler& sampler) {
  if (HWY_UNLIKELY(sampler.compares)) return ComparedOf(texture.component);
  return has_border(texture, sampler) ? BorderedOf(texture.component) : ValuesOf(texture.component);
}

/// Returns the filter of the domain of a texture.
RunFilter FilterOf(const Texture& texture, const Sampler& sampler, Gradient gradient) {
  if (HWY_UNLIKELY(texture.depth != 0)) return SliceFilterOf(sampler.filter);
  if (HWY_LIKELY(texture.projection == SHD_PROJECTION_NONE)) return PlaneFilterOf(sampler.filter);
  return gradient == Gradient::kNone ? DirectionFilterOf(sampler.filter) : RunDirectionGradient;
}

/// Only the kernels that a call needs are looked up, which takes a part of the time of a call of one lookup. They are
/// written one by one and never copied: a copy in wider words would wait for these stores. `out` is empty before.
void FindKernels(const Texture& texture, const Sampler& sampler, Gradient gradient, Kernels* out) {
  const image::Component component = texture.component;
  Kernels& kernels = *out;
  if (HWY_UNLIKELY(!is_in_memory(texture))) kernels.place = PlaceOf(texture.store);
  kernels.run = FilterOf(texture, sampler, gradient);
  kernels.record = ConsumeStream<RecordedBlend, Recorded, true>;
  kernels.format.values = ConsumerOf(texture, sampler);
  if (gradient == Gradient::kPlane) kernels.format.gradient = GradientOf(component);
  if (gradient == Gradient::kDeep) kernels.format.gradient = DeepGradientOf(component);
  if (HWY_UNLIKELY(needs_w(texture))) return;
  const bool values = gradient == Gradient::kNone && !has_border(sampler) && !sampler.compares;
  if (values && texture.layers == 1) kernels.format.rows = RowsOf(component);
  if (HWY_UNLIKELY(!is_in_memory(texture))) return;
  if (values) kernels.fused = FusedOf(sampler.filter, component);
  if (HWY_UNLIKELY(has_fast_values(texture, sampler))) {
    kernels.fast = sampler.filter == SHD_FILTER_ANISOTROPIC ? RunFixedLines : kernels.run;
    kernels.fast_format.rows = FixedRowsOf(texture.channels);
    kernels.fast_format.rows_only = true;
  }
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::texture {
namespace {
HWY_EXPORT(FindKernels);
HWY_EXPORT(FewOf);

/// Returns whether every output is the stored channel of its number, as those of textures of four channels usually are.
bool is_stored_as_read(const Texture& texture) {
  constexpr uint32_t kSame[4] = {0, 1, 2, 3};
  return std::memcmp(texture.channel_source, kSame, sizeof kSame) == 0;
}

/// Returns the wanted columns of the stored channels. Column 4 k + c holds values of the stored channel c (k = 0) or
/// their derivatives in u (k = 1) or v (k = 2).
Texels stored_columns(const Texture& texture, const Texels& out) {
  Texels stored = {};
  stored.coarser = out.coarser;
  for (size_t i = 0; i < kOutputColumns; ++i) {
    const uint32_t source = texture.channel_source[i % 4];
    if (source == kFill) continue;
    float*& column = stored.column(i / 4 * 4 + source);
    if (!column) column = out.column(i);
  }
  return stored;
}

Texels without_values(Texels columns) {
  for (float*& channel : columns.channel) channel = nullptr;
  return columns;
}
Texels without_gradient(Texels columns) {
  for (size_t i = 4; i < kOutputColumns; ++i) columns.column(i) = nullptr;
  return columns;
}

/// Writes the columns that stored_columns() left out: constants, and copies of other columns.
void complete_columns(const Texture& texture, const Texels& stored, size_t count, const Texels& out) {
  for (size_t i = 0; i < kOutputColumns; ++i) {
    if (!out.column(i)) continue;
    const uint32_t source = texture.channel_source[i % 4];
    if (source == kFill) {
      std::fill_n(out.column(i), count, i < 4 ? texture.fill[i] : 0.0f);
      continue;
    }
    const float* column = stored.column(i / 4 * 4 + source);
    if (column != out.column(i)) std::memcpy(out.column(i), column, count * sizeof(float));
  }
}

Texels of_columns(const Texels& columns, size_t first, size_t end) {
  Texels some = {};
  for (size_t i = first; i < end; ++i) some.column(i) = columns.column(i);
  return some;
}

/// Calls body(columns) for the wanted columns, in two passes if they need consumers or elements of their own: those of
/// derivatives in w, or all derivatives of textures of directions, and then the others. Returns the result of the first
/// call.
template <class Body>
size_t in_passes(const Texture& texture, const Texels& wanted, const Body& body) {
  if (HWY_LIKELY(!needs_w(texture))) return body(wanted);
  const size_t first = texture.depth != 0 ? 12 : 4;
  const Texels apart = of_columns(wanted, first, kOutputColumns), others = of_columns(wanted, 0, first);
  if (!apart.wants_gradient()) return body(wanted);
  const size_t nonfinite = body(apart);
  if (others.wants_values() || others.wants_gradient()) body(others);
  return nonfinite;
}

/// Filters the stored channels. `wanted` holds their columns, those of one pass. `store`: state of the placement, for
/// textures whose streams are placed.
size_t sample_stored(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd,
                     const Lookups& lookups, const Texels& wanted, Recording* recording, const Placement& store) {
  const bool gradient = wanted.wants_gradient();
  const size_t target = lookups.count <= core::kNarrowLanes ? core::narrow_index(simd) : simd.index;
  Kernels kernels = {};
  const auto find_kernels = [&](Gradient kind) {
    HWY_DISPATCH_TABLE(FindKernels)[target](texture, sampler, kind, &kernels);
  };
  const auto run = [&](RunFilter filter, const FormatKernels& format, const Texels& to) {
    if (HWY_UNLIKELY(recording != nullptr)) {
      return filter({texture,
                     sampler,
                     lookups,
                     to,
                     format,
                     kernels.record,
                     recording,
                     {place_taps, recording, nullptr, recording->columns.data()}});
    }
    return filter({texture,
                   sampler,
                   lookups,
                   to,
                   format,
                   nullptr,
                   nullptr,
                   {kernels.place, store.state, store.origin, store.places}});
  };
  const bool deep = gradient && texture.depth != 0 && wanted.wants_deep_gradient();
  find_kernels(deep ? Gradient::kDeep : gradient ? Gradient::kPlane : Gradient::kNone);
  SHD_ASSERT(kernels.run && kernels.format.values);  // the enums of samplers and textures are checked at creation
  if (recording) return run(kernels.run, kernels.format, wanted);
  if (!kernels.fast) return run(kernels.fused ? kernels.fused : kernels.run, kernels.format, wanted);
  if (!gradient) return run(kernels.fast, kernels.fast_format, wanted);
  if (wanted.wants_values()) run(kernels.fast, kernels.fast_format, without_gradient(wanted));
  return run(kernels.run, kernels.format, without_values(wanted));
}

/// sample_stored() of a texture whose streams are placed. Calls for other textures do not pay for its stack frame.
[[gnu::noinline]] size_t sample_placed(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd,
                                       const Lookups& lookups, const Texels& wanted) {
  const StoreRow& store = functions_of(texture.store);
  size_t nonfinite = 0;
  const auto look_up = [&](const Placement& placement) {
    const auto filter = [&](const Sampler& with, const Lookups& in, const Texels& out, uint8_t* needed) {
      return in_passes(texture, out, [&](const Texels& columns) {
        store.begin(placement.state, in.count, needed);
        return sample_stored(texture, with, simd, in, columns, nullptr, placement);
      });
    };
    const bool coarser = texture.tiles && sampler.missing_tiles == SHD_MISSING_TILES_COARSER;
    nonfinite =
        coarser ? sample_coarser(texture, sampler, lookups, wanted, filter) : filter(sampler, lookups, wanted, nullptr);
  };
  call(texture, look_up);
  return nonfinite;
}

size_t sample_any(const Texture& given, const Sampler& sampler, const core::SimdTarget& simd, const Lookups& lookups,
                  const Texels& wanted, Recording* recording) {
  const Texture& texture = HWY_LIKELY(!given.decoded) ? given : read_by(given, sampler.filter);
  if (HWY_UNLIKELY(wanted.coarser != nullptr)) std::fill_n(wanted.coarser, lookups.count, 0u);
  if (HWY_UNLIKELY(!is_in_memory(texture)) && !recording) {
    return sample_placed(texture, sampler, simd, lookups, wanted);
  }
  return in_passes(texture, wanted, [&](const Texels& columns) {
    return sample_stored(texture, sampler, simd, lookups, columns, recording, {});
  });
}

/// Comparison lookups: the results in r, and constants in the other channels.
[[gnu::noinline]] size_t sample_compared(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd,
                                         const Lookups& lookups, const Texels& out, Recording* recording) {
  const uint32_t source = texture.channel_source[0];
  Texels stored = {};
  stored.coarser = out.coarser;
  if (source != kFill) stored.channel[source] = out.channel[0];
  const size_t nonfinite = sample_any(texture, sampler, simd, lookups, stored, recording);
  for (size_t i = 0; source == kFill && out.channel[0] && i < lookups.count; ++i) {
    const float reference = clamped_reference(texture.component, lookups.reference ? lookups.reference[i] : 0.0f);
    out.channel[0][i] = passes(data::comparison_of(sampler.compare), reference, texture.fill[0]) ? 1.0f : 0.0f;
  }
  for (size_t c = 1; c < 4; ++c) {
    if (out.channel[c]) std::fill_n(out.channel[c], lookups.count, c == 3 ? 1.0f : 0.0f);
  }
  return nonfinite;
}

/// Whether a filter blends the quads of at most two levels.
bool is_linear(shd_filter filter) {
  return filter == SHD_FILTER_BILINEAR || filter == SHD_FILTER_HERMITE || filter == SHD_FILTER_BILINEAR_MIP ||
         filter == SHD_FILTER_TRILINEAR;
}

/// Whether the stored channels of lookups are what a filter of one image in memory gives, in full precision.
bool is_plain(const Texture& texture, const Sampler& sampler, const Texels& out) {
  const bool texels = is_in_memory(texture) && !needs_w(texture) && !texture.decoded && is_stored_as_read(texture);
  const bool values = sampler.magnification == SHD_MAGNIFICATION_DEFAULT && sampler.precision == SHD_PRECISION_FULL &&
                      !sampler.compares && !has_border(sampler);
  return texels && values && !out.coarser && !out.rgba8 && !out.wants_gradient();
}

/// sample() of any number of lookups. Calls of few do not pay for its stack frame.
[[gnu::noinline]] size_t sample_many(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd,
                                     const Lookups& lookups, const Texels& out, Recording* recording) {
  if (sampler.magnification != SHD_MAGNIFICATION_DEFAULT) return sample_magnified(texture, sampler, simd, lookups, out);
  if (HWY_UNLIKELY(sampler.compares)) return sample_compared(texture, sampler, simd, lookups, out, recording);
  if (is_stored_as_read(texture)) return sample_any(texture, sampler, simd, lookups, out, recording);
  const Texels stored = stored_columns(texture, out);
  const size_t nonfinite = sample_any(texture, sampler, simd, lookups, stored, recording);
  complete_columns(texture, stored, lookups.count, out);
  return nonfinite;
}
}  // namespace

size_t sample(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd, const Lookups& lookups,
              const Texels& out, Recording* recording) {
  const bool few = lookups.count != 0 && lookups.count <= core::kNarrowLanes;  // filters emit a vector at least
  if (few && !recording && is_plain(texture, sampler, out)) {
    const auto run = HWY_DISPATCH_TABLE(FewOf)[core::narrow_index(simd)](texture, sampler.filter);
    if (run) return run(texture, sampler, lookups, out);
  }
  return sample_many(texture, sampler, simd, lookups, out, recording);
}

bool writes_rgba8(const Texture& texture, const Sampler& sampler) {
  if (sampler.compares || sampler.magnification != SHD_MAGNIFICATION_DEFAULT) return false;
  if (!is_stored_as_read(texture)) return false;
  if (has_fast_values(texture, sampler)) return true;
  return is_linear(sampler.filter) && !has_border(texture, sampler) && image::is_unorm(texture.component) &&
         is_in_memory(texture) && texture.layers == 1 && !needs_w(texture);
}

shd_filter last_filter() {
  shd_filter last = SHD_FILTER_NEAREST;
#define SHD_TEXTURE_LATER(name, run, gradient) last = name > last ? name : last;
  SHD_TEXTURE_FILTERS(SHD_TEXTURE_LATER)
#undef SHD_TEXTURE_LATER
  return last;
}

bool has_gradient(shd_filter filter) {
  switch (filter) {
#define SHD_TEXTURE_CASE(name, run, gradient) \
  case name: return gradient;
    SHD_TEXTURE_FILTERS(SHD_TEXTURE_CASE)
#undef SHD_TEXTURE_CASE
    case SHD_FILTER_MAX_ENUM: break;
  }
  return false;
}

}  // namespace shd::texture
#endif
