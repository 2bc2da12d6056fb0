// SPDX-License-Identifier: MIT
// Derivatives of values in the components of directions: those in the coordinates of the image, which the filters
// compute for a block of lookups, times the Jacobian of the projection.
#include "texture/stream.h"

#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/filter/directions_gradient.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "simd/tail-inl.h"
#include "texture/domain/project-inl.h"
#include "texture/filter/directions-inl.h"
#include "texture/format/consume-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::StoreFirst;
namespace {

/// Returns slope * rate for a finite rate. A rate of 0 gives 0, and finite slopes give finite products.
template <class D, class V>
HWY_INLINE V BoundedProduct(D d, V slope, V rate) {
  return hn::IfThenZeroElse(hn::Eq(rate, hn::Zero(d)), ClampWhere(d, IsFinite(d, slope), slope * rate));
}

/// Writes the derivative in one component of the directions. All zeros become +0.
void WriteComponent(size_t count, const float* du, const float* dv, const float* rate_u, const float* rate_v,
                    float* out) {
  const BatchTag d;
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto a = BoundedProduct(d, hn::Load(d, du + i), hn::Load(d, rate_u + i));
    const auto b = BoundedProduct(d, hn::Load(d, dv + i), hn::Load(d, rate_v + i));
    const auto sum = ClampWhere(d, hn::And(IsFinite(d, a), IsFinite(d, b)), a + b) + hn::Zero(d);
    StoreFirst(d, hn::IfThenElse(hn::Eq(sum, sum), sum, hn::Set(d, std::numeric_limits<float>::quiet_NaN())), count - i,
               out + i);
  }
}

}  // namespace

size_t RunDirectionGradient(const FilterCall& call) {
  const RunFilter filter = DirectionFilterOf(call.sampler.filter);
  DirectionRates rates;
  alignas(64) float slopes[2][4][kBlock];
  size_t nonfinite = 0;
  for (size_t first = 0; first < call.in.count; first += kBlock) {
    const Lookups block = block_of(call.in, first);
    const Texels out = part_of(call.out, first);
    Texels flat = {};
    for (size_t c = 0; c < 4; ++c) {
      const bool wanted = out.du[c] || out.dv[c] || out.dw[c];
      flat.du[c] = wanted ? slopes[0][c] : nullptr, flat.dv[c] = wanted ? slopes[1][c] : nullptr;
    }
    nonfinite += filter({call.texture, call.sampler, block, flat, call.format, nullptr, nullptr, call.placement});
    ProjectRates(call.texture, block, &rates);
    for (size_t c = 0; c < 4; ++c) {
      for (size_t axis = 0; axis < 3; ++axis) {
        float* const column = out.column(4 + 4 * axis + c);
        if (column) WriteComponent(block.count, flat.du[c], flat.dv[c], rates.u[axis], rates.v[axis], column);
      }
    }
  }
  return nonfinite;
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
