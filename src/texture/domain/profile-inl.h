// SPDX-License-Identifier: MIT
// Levels of detail and probes of the profiles. A profile has these members:
//
//   Lambda(d, derivatives)    level of detail of an isotropic lookup, before bias and clamps
//   ProbesOf(d, derivatives)  probes and level of detail of an anisotropic lookup, before bias and clamps
//   NearestLevel(d, lod)      a level of detail whose nearest level is the level that the profile reads at `lod`
//   kLevelSteps               steps per level to which fractions are rounded; 0 = fractions are not rounded

#if defined(SHD_TEXTURE_PROFILE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_PROFILE_INL_H_
#undef SHD_TEXTURE_PROFILE_INL_H_
#else
#define SHD_TEXTURE_PROFILE_INL_H_
#endif

#include <hwy/highway.h>

#include "simd/round-inl.h"
#include "texture/domain/footprint-inl.h"
#include "texture/domain/shapes-inl.h"
#include "texture/store/storage.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;
using simd::HWY_NAMESPACE::RoundUp;

/// A line of probes: probe k = 0..count - 1 lies at the point + (2 k + 1 - count) (step_u, step_v). The weights are
/// equal or exp(-2 x^2), x = (2 k + 1 - count) / reach.
template <class D>
struct Probes {
  hn::Vec<D> step_u, step_v, count, reach, lambda;
};

/// Lengths of the derivatives in x and y, in base texels times 2^-exponent.
template <class D>
struct Lengths {
  hn::Vec<D> x, y;
  hn::Vec<hn::RebindToSigned<D>> exponent;
};

/// Returns the lengths of the derivatives. Both lengths are 0 if a derivative is infinite.
template <class D>
SHD_KERNEL_PART Lengths<D> LengthsOf(D d, const Derivatives<D>& j, float width, float height) {
  using V = hn::Vec<D>;
  const V w = hn::Set(d, width), h = hn::Set(d, height);
  const V ux = j.dudx * w, vx = j.dvdx * h, uy = j.dudy * w, vy = j.dvdy * h;
  const V largest = LargestMagnitude(ux, vx, uy, vy);
  const auto infinite = hn::Eq(largest, hn::Inf(d));
  Lengths<D> lengths;
  lengths.exponent = ExponentOf(d, largest);
  const V down = hn::IfThenZeroElse(infinite, PowerOfTwo(d, hn::Neg(lengths.exponent)));
  const auto length = [&](V u, V v) {
    const V a = hn::IfThenZeroElse(infinite, u * down), b = hn::IfThenZeroElse(infinite, v * down);
    return hn::Sqrt(a * a + b * b);
  };
  lengths.x = length(ux, vx);
  lengths.y = length(uy, vy);
  return lengths;
}

/// Returns log2 of the longer derivative in base texels, clamped to -32..31. Its error is that of HalfLog2().
template <class D, class V = hn::Vec<D>>
SHD_KERNEL_PART V LongerLambda(D d, const Derivatives<D>& j, float width, float height) {
  const V w = hn::Set(d, width), h = hn::Set(d, height);
  const V ux = j.dudx * w, vx = j.dvdx * h, uy = j.dudy * w, vy = j.dvdy * h;
  const V x = ux * ux + vx * vx, y = uy * uy + vy * vy;
  const V bounded = hn::Min(hn::Max(hn::Max(x, y), hn::Set(d, 0x1p-64f)), hn::Set(d, 0x1p62f));
  return hn::Set(d, 0.5f) * simd::HWY_NAMESPACE::Log2(d, bounded);
}

/// Rounds a level of detail to the nearest multiple of 1 / steps.
template <class D, class V>
HWY_INLINE V RoundLevel(D d, V lod, float steps) {
  const V count = hn::Set(d, steps);
  return RoundDown(lod * count + hn::Set(d, 0.5f)) / count;
}

template <class D, class V>
HWY_INLINE V ClampStep(D d, V step) {
  const V limit = hn::Set(d, 0x1p60f);
  return hn::Max(hn::Min(step, limit), hn::Neg(limit));
}

/// SHD_PROFILE_VULKAN: Vulkan 1.3 specification, "Image Operations": "Scale Factor Operation", "Level-of-Detail
/// Operation" and "Texel Anisotropic Filtering". The scale factors are the lengths of the derivatives; the probes are
/// those of the note on anisotropic filtering.
struct VulkanProfile {
  static constexpr float kLevelSteps = 256;  // mipmapPrecisionBits = 8, as most desktop GPUs report
  const Texture& texture;
  const Sampler& sampler;

  template <class D, class V = hn::Vec<D>>
  HWY_INLINE V Lambda(D d, const Derivatives<D>& j) const {
    return LongerLambda(d, j, static_cast<float>(texture.width), static_cast<float>(texture.height));
  }

  template <class D>
  SHD_KERNEL_PART Probes<D> ProbesOf(D d, const Derivatives<D>& j) const {
    using V = hn::Vec<D>;
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
    const Lengths<D> l = LengthsOf(d, j, static_cast<float>(texture.width), static_cast<float>(texture.height));
    const V longer = hn::Max(l.x, l.y), shorter = hn::Min(l.x, l.y);
    const auto none = hn::Eq(longer, zero);
    const V ratio = hn::IfThenElse(none, one, longer) / hn::IfThenElse(none, one, shorter);
    const V eta = hn::Min(ratio, hn::Set(d, sampler.max_anisotropy));
    const auto along_x = hn::Gt(l.x, l.y);
    Probes<D> probes;
    probes.count = RoundUp(eta);
    probes.lambda = Lambda(d, j) - simd::HWY_NAMESPACE::Log2(d, eta);
    // Probe i = 1..N lies at i / (N + 1) - 1/2 of the derivative.
    const V parts = probes.count + probes.count + hn::Set(d, 2.0f);
    probes.step_u = ClampStep(d, hn::IfThenElse(along_x, j.dudx, j.dudy) / parts);
    probes.step_v = ClampStep(d, hn::IfThenElse(along_x, j.dvdx, j.dvdy) / parts);
    probes.reach = probes.count;
    return probes;
  }

  template <class D, class V>
  HWY_INLINE V NearestLevel(D, V lod) const {
    return lod;
  }
};

/// SHD_PROFILE_D3D11: "Direct3D 11.3 Functional Specification", 7.18.10 (level of detail) and 7.18.11 (anisotropy). Its
/// transform of the derivatives to the axes of the implicit ellipse gives the axes of FootprintOf(). It does not
/// transform parallel derivatives, whose footprint has no area. It does not specify the positions of the probes; they
/// are those of VulkanProfile.
struct D3d11Profile {
  static constexpr float kLevelSteps = 256;  // at least 8 bits
  const Texture& texture;
  const Sampler& sampler;

  template <class D>
  struct Major {
    hn::Vec<D> length, lambda;
  };

  /// Returns the longer axis of the ellipse, or the longer derivative if the derivatives are parallel.
  template <class D>
  SHD_KERNEL_PART Major<D> MajorOf(D d, const Derivatives<D>& j, const Footprint<D>& f) const {
    const hn::RebindToSigned<D> di;
    const auto width = static_cast<float>(texture.width), height = static_cast<float>(texture.height);
    const Lengths<D> l = LengthsOf(d, j, width, height);
    const auto parallel = hn::Eq(f.roundness, hn::Zero(d));
    const auto longer = hn::Max(l.x, l.y) * PowerOfTwo(d, hn::Min(l.exponent, hn::Set(di, 98)));
    return {hn::IfThenElse(parallel, longer, f.length),
            hn::IfThenElse(parallel, LongerLambda(d, j, width, height), f.lambda)};
  }

  template <class D, class V = hn::Vec<D>>
  HWY_INLINE V Lambda(D d, const Derivatives<D>& j) const {
    const auto width = static_cast<float>(texture.width), height = static_cast<float>(texture.height);
    return MajorOf(d, j, FootprintOf(d, j, width, height)).lambda;
  }

  template <class D>
  SHD_KERNEL_PART Probes<D> ProbesOf(D d, const Derivatives<D>& j) const {
    using V = hn::Vec<D>;
    const auto width = static_cast<float>(texture.width), height = static_cast<float>(texture.height);
    const V one = hn::Set(d, 1.0f);
    const Footprint<D> f = FootprintOf(d, j, width, height);
    const Major<D> major = MajorOf(d, j, f);
    // length^2 / |det| is the inverse of the roundness.
    const V ratio = one / hn::Max(f.roundness, hn::Set(d, 1.0f / sampler.max_anisotropy));
    Probes<D> probes;
    probes.lambda = major.lambda - simd::HWY_NAMESPACE::Log2(d, ratio);
    // A minor axis below one texel limits the probes to the texels of the major axis.
    probes.count = RoundUp(hn::Min(ratio, hn::Max(major.length, one)));
    const V parts = probes.count + probes.count + hn::Set(d, 2.0f);
    const V step = major.length / parts;
    probes.step_u = ClampStep(d, step * f.u / hn::Set(d, width));
    probes.step_v = ClampStep(d, step * f.v / hn::Set(d, height));
    probes.reach = probes.count;
    return probes;
  }

  /// Returns floor(lod + 1/2) of the fixed-point level of detail.
  template <class D, class V>
  HWY_INLINE V NearestLevel(D d, V lod) const {
    return RoundDown(RoundLevel(d, lod, kLevelSteps) + hn::Set(d, 0.5f));
  }
};

/// SHD_PROFILE_OIIO: TextureSystem of OpenImageIO 2.4 with the default options (conservative filter). Axes are in units
/// of the texture, not in texels. The smaller side of the texture determines the level.
struct OiioProfile {
  static constexpr float kLevelSteps = 0;
  const Texture& texture;
  const Sampler& sampler;
  bool one_level;  // MipModeOneLevel

  /// Returns derivatives times width. OpenImageIO applies width_x to u and width_y to v, not to x and y.
  template <class D>
  HWY_INLINE Derivatives<D> Scaled(D d, const Derivatives<D>& j) const {
    const auto wu = hn::Set(d, sampler.width_x), wv = hn::Set(d, sampler.width_y);
    return {ZeroIfNaN(j.dudx * wu), ZeroIfNaN(j.dvdx * wv), ZeroIfNaN(j.dudy * wu), ZeroIfNaN(j.dvdy * wv)};
  }

  /// Returns the level of detail of a filter whose width is in units of the texture. Let m be the first level where the
  /// width is at most one texel of the smaller side. The result lies between m - 1 and m, at the fraction
  /// 2 * (width in texels of m) - 1.
  template <class D, class V>
  SHD_KERNEL_PART V LambdaOfWidth(D d, V width) const {
    const V one = hn::Set(d, 1.0f), zero = hn::Zero(d);
    V lambda = hn::Set(d, static_cast<float>(texture.level_count - 1));
    for (uint32_t level = texture.level_count; level-- > 1;) {
      const V texels = width * hn::Set(d, smaller_side(level));
      const V blend = hn::Min(hn::Max(texels + texels - one, zero), one);
      const V here = hn::Set(d, static_cast<float>(level - 1)) + (one_level ? one : blend);
      lambda = hn::IfThenElse(hn::Le(texels, one), here, lambda);
    }
    // OpenImageIO stops at level 0. Continue below it as other profiles do, for bias and magnification.
    const V texels = hn::Max(width * hn::Set(d, smaller_side(0)), hn::Set(d, 0x1p-32f));
    const auto magnified = hn::Le(texels, one);
    return hn::IfThenElse(magnified, simd::HWY_NAMESPACE::Log2(d, hn::IfThenElse(magnified, texels, one)), lambda);
  }

  template <class D, class V = hn::Vec<D>>
  SHD_KERNEL_PART V Lambda(D d, const Derivatives<D>& derivatives) const {
    const Derivatives<D> j = Scaled(d, derivatives);
    const float blur = sampler.blur_u > sampler.blur_v ? sampler.blur_u : sampler.blur_v;
    return LambdaOfWidth(d, LargestMagnitude(j.dudx, j.dvdx, j.dudy, j.dvdy) + hn::Set(d, blur));
  }

  /// Returns scaled derivatives. A derivative shorter than 1e-8 is replaced by a vector of this length perpendicular to
  /// the other derivative.
  template <class D>
  SHD_KERNEL_PART Derivatives<D> Adjusted(D d, const Derivatives<D>& derivatives) const {
    using V = hn::Vec<D>;
    const V epsilon = hn::Set(d, 1e-8f), square = hn::Set(d, 1e-16f), zero = hn::Zero(d);
    const Derivatives<D> j = Scaled(d, derivatives);
    const V xx = j.dudx * j.dudx + j.dvdx * j.dvdx;
    const V yy = j.dudy * j.dudy + j.dvdy * j.dvdy;
    const auto tiny_x = hn::Lt(xx, square), tiny_y = hn::Lt(yy, square);
    const auto both = hn::And(tiny_x, tiny_y);
    const V from_y = epsilon / hn::Sqrt(hn::Max(yy, square));
    const V from_x = epsilon / hn::Sqrt(hn::Max(xx, square));
    Derivatives<D> a;
    a.dudx = hn::IfThenElse(tiny_x, ZeroIfNaN(j.dvdy * from_y), j.dudx);
    a.dvdx = hn::IfThenElse(tiny_x, ZeroIfNaN(hn::Neg(j.dudy * from_y)), j.dvdx);
    a.dudy = hn::IfThenElse(tiny_y, ZeroIfNaN(hn::Neg(j.dvdx * from_x)), j.dudy);
    a.dvdy = hn::IfThenElse(tiny_y, ZeroIfNaN(j.dudx * from_x), j.dvdy);
    a.dudx = hn::IfThenElse(both, epsilon, a.dudx);
    a.dvdx = hn::IfThenElse(both, zero, a.dvdx);
    a.dudy = hn::IfThenElse(both, zero, a.dudy);
    a.dvdy = hn::IfThenElse(both, epsilon, a.dvdy);
    return a;
  }

  /// Axes of the ellipse, with blur, and shortened to the limit of anisotropy.
  template <class D>
  struct Axes {
    hn::Vec<D> major, minor, aspect;
    hn::Vec<D> u, v;  // unit vector of the major axis
  };

  template <class D>
  SHD_KERNEL_PART Axes<D> AxesOf(D d, const Derivatives<D>& j) const {
    using V = hn::Vec<D>;
    const V longest = hn::Set(d, 1000.0f), limit = hn::Set(d, sampler.max_anisotropy);
    const Footprint<D> f = FootprintOf(d, Adjusted(d, j), 1.0f, 1.0f);
    Axes<D> axes = {hn::Min(f.length, longest), hn::Min(f.length * f.roundness, longest), limit, f.u, f.v};
    if (sampler.blur_u + sampler.blur_v != 0.0f) {
      const V blur_u = hn::Set(d, sampler.blur_u), blur_v = hn::Set(d, sampler.blur_v);
      const V cosine = hn::Abs(f.u), sine = hn::Abs(f.v);
      const V one = axes.major + (blur_u * cosine + blur_v * sine);
      const V other = axes.minor + (blur_u * sine + blur_v * cosine);
      const auto swapped = hn::Gt(other, one);
      axes.major = hn::Max(one, other);
      axes.minor = hn::Min(one, other);
      axes.u = hn::IfThenElse(swapped, hn::Neg(f.v), f.u);
      axes.v = hn::IfThenElse(swapped, f.u, f.v);
    }
    // The major axis is positive.
    const V aspect = hn::Max(axes.major / axes.minor, hn::Set(d, 1.0f));
    const auto over = hn::Gt(aspect, limit);
    const V between = hn::Set(d, 0.5f) * (axes.major + axes.minor * limit);
    axes.aspect = hn::Min(aspect, limit);
    axes.major = hn::IfThenElse(over, between, axes.major);
    axes.minor = hn::IfThenElse(over, between / limit, axes.minor);
    return axes;
  }

  template <class D>
  SHD_KERNEL_PART Probes<D> ProbesOf(D d, const Derivatives<D>& j) const {
    using V = hn::Vec<D>;
    const V one = hn::Set(d, 1.0f), half = hn::Set(d, 0.5f);
    const Axes<D> axes = AxesOf(d, j);
    Probes<D> probes;
    probes.lambda = LambdaOfWidth(d, axes.minor);
    // If the minor axis is below half a texel of level 0, one probe per half texel of the major axis is enough.
    const V larger = hn::Set(d, static_cast<float>(texture.width > texture.height ? texture.width : texture.height));
    const auto magnified =
        hn::And(hn::Le(axes.minor * hn::Set(d, smaller_side(0)), one), hn::Lt(axes.minor * larger, half));
    const V texels = axes.major * larger;
    const V enough = hn::Min(hn::Max(texels + texels, one), hn::Set(d, sampler.max_anisotropy));
    const V aspect = hn::IfThenElse(magnified, enough, axes.aspect);
    probes.count = hn::Max(RoundDown(aspect + aspect - one), one);
    const V spread = axes.major - axes.minor, step = spread / probes.count;
    probes.step_u = step * axes.u;
    probes.step_v = step * axes.v;
    // Weights are exp(-2 x^2), x = p major / (2 spread), at positions p = -1..1 along the spread.
    const V reach = (probes.count + probes.count) * spread / axes.major;
    probes.reach = hn::Max(reach, hn::Set(d, 0x1p-20f));  // not 0 even for a circle, whose single probe has x = 0
    return probes;
  }

  /// Returns the coarser of both levels, a whole number, which is its own nearest level.
  template <class D, class V>
  HWY_INLINE V NearestLevel(D, V lod) const {
    return RoundUp(lod);
  }

 private:
  float smaller_side(uint32_t level) const {
    const uint32_t width = level_size(texture.width, level), height = level_size(texture.height, level);
    return static_cast<float>(width < height ? width : height);
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_PROFILE_INL_H_
