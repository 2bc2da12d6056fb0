// SPDX-License-Identifier: MIT
#include "occlusion/ray_batch.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "data/data.h"
#include "data/hash.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "occlusion/ray_batch.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "simd/angle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::occlusion::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::SineCosinePi;

/// A coordinate of the unit square, [0, 1): the upper 24 bits of a word.
template <class D, class VU>
HWY_INLINE hn::Vec<D> Unit(D d, VU bits) {
  const hn::RebindToSigned<D> di;
  return hn::ConvertTo(d, hn::BitCast(di, hn::ShiftRight<8>(bits))) * hn::Set(d, 0x1p-24f);
}

/// Cosine-weighted directions: points of the unit disc, lifted to the hemisphere (Malley's method: Pharr, Jakob and
/// Humphreys, "Physically Based Rendering", 3rd edition, 13.6.3).
void AppendRays(const RaySet& set, const RayOrigin& at, size_t begin, size_t end, RayBatch& out) {
  const hn::ScalableTag<float> d;
  const hn::RebindToUnsigned<decltype(d)> du;
  float* const origin[3] = {out.ox, out.oy, out.oz};
  float* const direction[3] = {out.dx, out.dy, out.dz};
  size_t to = out.count;
  for (size_t i = begin; i < end; i += hn::Lanes(d), to += hn::Lanes(d)) {
    const auto u = Unit(d, hn::LoadU(du, &set.u[i]) + hn::Set(du, at.shift[0]));
    const auto v = Unit(d, hn::LoadU(du, &set.v[i]) + hn::Set(du, at.shift[1]));
    const auto angle = SineCosinePi(d, v + v);
    const auto r = hn::Sqrt(u), z = hn::Sqrt(hn::Set(d, 1.0f) - u);
    const auto x = r * angle.cosine, y = r * angle.sine;
    for (int c = 0; c < 3; ++c) {
      const auto flat = hn::Set(d, at.tangent[c]) * x + hn::Set(d, at.bitangent[c]) * y;
      hn::StoreU(flat + hn::Set(d, at.normal[c]) * z, d, direction[c] + to);
      hn::StoreU(hn::Set(d, at.origin[c]), d, origin[c] + to);
    }
  }
  out.count += end - begin;
}

}  // namespace shd::occlusion::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::occlusion {

HWY_EXPORT(AppendRays);

namespace {

using data::kHashStep;
using data::mix_bits;

uint32_t bits_of(float value) {
  uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

uint32_t reversed(uint32_t bits) {
  uint32_t result = 0;
  for (int i = 0; i < 32; ++i) result |= (bits >> i & 1u) << (31 - i);
  return result;
}

/// An orthonormal basis around the normal (Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017).
void set_basis(RayOrigin* out) {
  const float x = out->normal[0], y = out->normal[1], z = out->normal[2];
  const float sign = std::copysign(1.0f, z), a = -1.0f / (sign + z), b = x * y * a;
  const float tangent[3] = {1.0f + sign * x * x * a, sign * b, -sign * x};
  const float bitangent[3] = {b, sign + y * y * a, -y};
  std::copy_n(tangent, 3, out->tangent);
  std::copy_n(bitangent, 3, out->bitangent);
}

}  // namespace

RaySet make_ray_set(const core::Allocator& allocator, uint32_t count) {
  RaySet set = {count, core::Array<uint32_t>(allocator, data::padded(count)),
                core::Array<uint32_t>(allocator, data::padded(count))};
  const auto step = static_cast<uint32_t>((uint64_t{1} << 32) / count);
  for (uint32_t i = 0; i < set.u.size(); ++i) {
    set.u[i] = i * step;
    set.v[i] = reversed(i);
  }
  return set;
}

void allocate(const core::Allocator& allocator, float length, RayBatch* out) {
  constexpr size_t kRows = kRayBatch + data::kRowPad;
  out->block = core::Array<float>(allocator, 7 * kRows);
  float* next = out->block.data();
  for (float** column : {&out->ox, &out->oy, &out->oz, &out->dx, &out->dy, &out->dz, &out->length}) {
    *column = next;
    next += kRows;
  }
  std::fill_n(out->length, kRows, length);
  out->blocked = core::Array<uint32_t>(allocator, kRayBatch);
}

bool make_origin(const Points& points, size_t index, const Options& options, RayOrigin* out) {
  double n[3], squared = 0.0;
  float largest = 0.0f;
  uint32_t hash = options.seed;
  for (int c = 0; c < 3; ++c) {
    const float p = points.position[c][index];
    if (!std::isfinite(p)) return false;
    largest = std::max(largest, std::fabs(p));
    n[c] = static_cast<double>(points.normal[c][index]);
    squared += n[c] * n[c];
    hash = mix_bits(bits_of(p + 0.0f) + mix_bits(bits_of(points.normal[c][index] + 0.0f) + hash + kHashStep));
  }
  if (!(squared > 0.0) || !std::isfinite(squared)) return false;
  const double length = std::sqrt(squared);
  // 64 units in the last place: positions, rays and intersections are rounded to a few of them.
  const float lift = options.bias + std::max(largest * 0x1p-18f, 1e-20f);
  for (int c = 0; c < 3; ++c) {
    out->normal[c] = static_cast<float>(n[c] / length);
    out->origin[c] = points.position[c][index] + out->normal[c] * lift;
  }
  set_basis(out);
  out->shift[0] = hash;
  out->shift[1] = mix_bits(hash + kHashStep);
  return true;
}

void append_rays(const core::SimdTarget& simd, const RaySet& set, const RayOrigin& origin, size_t begin, size_t end,
                 RayBatch* out) {
  SHD_DISPATCH(AppendRays, simd)(set, origin, begin, end, *out);
}

}  // namespace shd::occlusion
#endif  // HWY_ONCE
