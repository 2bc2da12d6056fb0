// SPDX-License-Identifier: MIT
// Anisotropic lookups in 3D textures: probes along the longer axis of the footprint, as in 2D (anisotropic-inl.h). The
// quads of all probes on the finer level form the first average, those on the coarser level the second. The share of a
// quad in its average is its weight by the sum of the weights so far; the weight is that of the probe times that of the
// slice.
#include "texture/stream.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/filter/slices_anisotropic.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/filter/anisotropic-inl.h"
#include "texture/filter/filters-inl.h"
#include "texture/filter/slices-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

/// Shares of the two quads of a probe of weight w after probes of a total weight. Derivatives: with the first share f =
/// (1 - s) w / (total + (1 - s) w), df/ds = -w total / (total + (1 - s) w)^2; the second share is s w / (total + w).
/// The first probe starts the average, so its second share is s.
template <class D>
struct ProbeShares {
  DeepShare<D> first, second;

  HWY_INLINE ProbeShares(D d, const LinearTaps<D>& z, hn::Vec<D> total, hn::Vec<D> weight, bool starts) {
    using V = hn::Vec<D>;
    if (starts) {
      first.value = first.rate = hn::Zero(d);
      second.value = z.s;
      second.rate = z.rate;
      return;
    }
    const V one = hn::Set(d, 1.0f), zero = hn::Zero(d);
    const V front = (one - z.s) * weight, sum = total + front, all = total + weight;
    const auto any = hn::Gt(sum, zero);
    const V divisor = hn::IfThenElse(any, sum, one);
    first.value = hn::IfThenElseZero(any, front / divisor);
    first.rate = hn::Neg(weight * total / (divisor * divisor)) * z.rate;
    second.value = z.s * weight / all;
    second.rate = weight / all * z.rate;
  }
};

struct AnisotropicInSlices : OnSlices<PlaceProbeBlock> {
  using OnSlices::OnSlices;

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const PlaceProbeBlock& block, size_t i, Sink& sink) const {
    using V = hn::Vec<D>;
    const ProbeLine<D> line(d, sampler, block, i);
    const LevelNumbers<D> levels(d, texture, hn::Load(d, block.lod + i));
    const Slices<D> high = SlicesAt(d, texture, levels.high), low = SlicesAt(d, texture, levels.low);
    const V middle = hn::Load(d, block.w + i);
    const V step_w = ProbeLine<D>::Distance(d, sampler.wrap_w, hn::Load(d, block.step_w + i));
    const V reach = hn::Load(d, block.reach + i);
    const float max_probes = hn::GetLane(hn::MaxOfLanes(d, line.probes));
    V total = hn::Zero(d);
    for (float k = 0.0f; k < max_probes; k += 1.0f) {
      // Finished lanes repeat their last probe with weight 0.
      const V position = line.position(d, hn::Set(d, k));
      const V u = line.u_at(position), v = line.v_at(position);
      const V w = ProbeLine<D>::at(sampler.wrap_w, middle, position, step_w);
      const V full =
          sampler.probe_weights == SHD_PROBE_WEIGHTS_EQUAL ? hn::Set(d, 1.0f) : ProbeGaussian(d, position / reach);
      const V weight = hn::IfThenElseZero(hn::Lt(hn::Set(d, k), line.probes), full);
      for (uint32_t second = 0;; second = kSecond) {
        emit_probe(d, second ? low : high, u, v, w, total, weight, k == 0.0f, second, sink);
        if (!levels.blended || second) break;
      }
      total = total + weight;
    }
    if (levels.blended) sink.merge(d, levels.fraction);
    sink.finish();
  }

 private:
  template <class D, class Sink>
  HWY_INLINE void emit_probe(D d, const Slices<D>& slices, hn::Vec<D> u, hn::Vec<D> v, hn::Vec<D> w, hn::Vec<D> total,
                             hn::Vec<D> weight, bool starts, uint32_t second, Sink& sink) const {
    const Cube<D> cube(d, sampler, slices, u, v, w);
    const ProbeShares<D> shares(d, cube.z, total, weight, starts);
    cube.emit_first(d, (starts ? kStart : kBlend) | second, sink, shares.first);
    cube.emit_second(d, kBlend | second, sink, shares.second);
  }
};

}  // namespace

size_t RunAnisotropicInSlices(const FilterCall& call) {
  return Run<AnisotropicInSlices>(call);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
