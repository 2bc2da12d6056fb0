// SPDX-License-Identifier: MIT
// How a filter becomes kernels. A Kernel has
//
//   template <class F> static size_t run(texture, sampler, lookups, out)
//
// for a format class F, and is compiled for values, for their gradient and to record itself.

#if defined(SHD_TEXTURE_KERNEL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_KERNEL_INL_H_
#undef SHD_TEXTURE_KERNEL_INL_H_
#else
#define SHD_TEXTURE_KERNEL_INL_H_
#endif

#include <type_traits>

#include <hwy/highway.h>

#include "texture/batch-inl.h"
#include "texture/gradient-inl.h"
#include "texture/record-inl.h"
#include "texture/sample.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Vectors that a kernel of format class F runs on.
template <class F>
struct TagOf {
  using Type = BatchTag;
};
template <>
struct TagOf<Recorded> {
  using Type = hn::CappedTag<float, 1>;
};

/// body(std::bool_constant<kBorder>()) with what the sampler's wraps need.
template <class F, class Body>
HWY_INLINE size_t WithBorder(const Sampler& sampler, const Body& body) {
  if constexpr (kIsGradient<F>) return body(std::true_type());
  if (has_border(sampler)) return body(std::true_type());
  if constexpr (!kIsGradient<F>) return body(std::false_type());
}

/// Filter<F, kBorder>{texture, sampler} on every vector of a batch.
template <template <class, bool> class Filter, class F>
HWY_INLINE size_t ForEachPoint(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
  return WithBorder<F>(sampler, [&](auto border) {
    return ForEachVector<typename TagOf<F>::Type>(texture, Filter<F, decltype(border)::value>{texture, sampler}, in,
                                                  out);
  });
}

template <class Kernel>
struct OfTexture {
  const Texture& texture;
  const Sampler& sampler;
  const Lookups& in;
  const Texels& out;

  template <class F>
  HWY_INLINE size_t run() const {
    return Kernel::template run<F>(texture, sampler, in, out);
  }
};
template <class Kernel>
struct GradientOfTexture {
  const Texture& texture;
  const Sampler& sampler;
  const Lookups& in;
  const Texels& out;

  template <class F>
  HWY_INLINE size_t run() const {
    return Kernel::template run<Gradient<F>>(texture, sampler, in, out);
  }
};

template <class Kernel>
size_t RunValues(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
  return ForFormat(texture, OfTexture<Kernel>{texture, sampler, in, out});
}
template <class Kernel>
size_t RunGradient(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
  return ForFormat(texture, GradientOfTexture<Kernel>{texture, sampler, in, out});
}

template <class Kernel, bool kGradient>
FilterKernels KernelsOf() {
  FilterKernels kernels = {RunValues<Kernel>, nullptr, nullptr};
  if constexpr (kGradient) kernels.gradient = RunGradient<Kernel>;
#if HWY_TARGET == HWY_STATIC_TARGET
  kernels.record = Kernel::template run<Recorded>;
#endif
  return kernels;
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_KERNEL_INL_H_
