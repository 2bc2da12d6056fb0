// SPDX-License-Identifier: MIT
// Where filters and formats of one target meet.
#include "texture/sample.h"

#include "core/simd_target.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/explain/record-inl.h"
#include "texture/filter/filters-inl.h"
#include "texture/format/formats-inl.h"
#include "texture/fused-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {

RunFilter FilterOf(shd_filter filter) {
  switch (filter) {
#define SHD_TEXTURE_CASE(name, run, gradient) \
  case name: return run;
    SHD_TEXTURE_FILTERS(SHD_TEXTURE_CASE)
#undef SHD_TEXTURE_CASE
    default: return RunTrilinear;
  }
}

FormatKernels FormatOf(image::Component component) {
  switch (component) {
#define SHD_TEXTURE_CASE(name, codec, kernels) \
  case image::Component::name: return kernels();
    SHD_TEXTURE_FORMATS(SHD_TEXTURE_CASE)
#undef SHD_TEXTURE_CASE
  }
  return Float32Kernels();
}

size_t RunBatch(const Texture& texture, const Sampler& sampler, const Lookups& lookups, const Texels& out,
                Recording* recording) {
  if (!recording && !out.wants_gradient() && !has_border(sampler)) {
    const RunFilter fused = FusedOf(sampler.filter, texture.component);
    if (fused) return fused({texture, sampler, lookups, out, FormatOf(texture.component), nullptr, nullptr});
  }
  const Consume record = recording ? ConsumeStream<RecordedBlend, Recorded, true> : nullptr;
  return FilterOf(sampler.filter)({texture, sampler, lookups, out, FormatOf(texture.component), record, recording});
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::texture {
namespace {
HWY_EXPORT(RunBatch);
}  // namespace

size_t run_filter(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd, const Lookups& lookups,
                  const Texels& out, Recording* recording) {
  return SHD_DISPATCH(RunBatch, simd)(texture, sampler, lookups, out, recording);
}

shd_filter last_filter() {
  shd_filter last = SHD_FILTER_EXACT;
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
    default: return false;
  }
}

}  // namespace shd::texture
#endif
