// SPDX-License-Identifier: MIT
// The samples of a tile that a triangle covers, vector by vector. Samples are ordered as in the tile: all samples of
// one pixel, then all samples of the next.
#if defined(SHD_RASTER_TRAVERSE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_RASTER_TRAVERSE_INL_H_
#undef SHD_RASTER_TRAVERSE_INL_H_
#else
#define SHD_RASTER_TRAVERSE_INL_H_
#endif

#include <cstdint>

#include <hwy/highway.h>

#include "raster/tile.h"
#include "raster/triangle_setup.h"
#include "simd/double-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::ScalableTag<float>;
using V = hn::Vec<Tag>;
using MaskV = hn::Mask<Tag>;
using Int = hn::Vec<hn::RebindToSigned<Tag>>;

/// Number of samples per pixel: one, as many as fit into a vector, or more.
enum class Samples { kSingle, kOneVector, kVectors };

/// The part of a narrow triangle that repeats along the rows: its edge functions and the origin of its depth, at the
/// samples of the pixels that fill a vector, or of one pixel.
template <Samples kSamples>
class Period {
 public:
  HWY_INLINE explicit Period(const TriangleSetup& t) : pattern_(*t.pattern) {
    const auto lanes = static_cast<int32_t>(hn::Lanes(Tag())), samples = static_cast<int32_t>(pattern_.count);
    length = kSamples == Samples::kVectors ? samples : lanes;
    pixels = kSamples == Samples::kVectors ? 1 : lanes / samples;
    SetBase(t.slope);
    for (int32_t at = 0; kSamples == Samples::kVectors && at < length; at += lanes) {
      for (int k = 0; k < 3; ++k) hn::Store(edge(t.line[k], at), hn::RebindToSigned<Tag>(), edge_[k] + at);
    }
  }

  HWY_INLINE Int column(int32_t at) const { return hn::LoadU(hn::RebindToSigned<Tag>(), pattern_.column + at); }
  HWY_INLINE V base(int32_t at) const { return hn::Load(Tag(), base_ + at); }

  /// edge_at() for the lanes from `at` on, as the sum of whole pixels and of the rest, which is rounded down.
  HWY_INLINE Int edge(const EdgeLine& line, int32_t at) const {
    const hn::RebindToSigned<Tag> di;
    const auto a = hn::Set(di, static_cast<int32_t>(line.a)), b = hn::Set(di, static_cast<int32_t>(line.b));
    const auto whole = hn::Set(di, static_cast<int32_t>(line.value >> geometry::kSubpixelBits));
    const auto part = hn::Set(di, static_cast<int32_t>(line.value & (geometry::kSubpixels - 1)));
    const auto x = a * hn::LoadU(di, pattern_.x + at), y = b * hn::LoadU(di, pattern_.y + at);
    const auto in_pixel = hn::ShiftRight<geometry::kSubpixelBits>(part + (x + y));
    return whole + in_pixel + a * column(at);
  }

  HWY_INLINE Int stored_edge(int k, int32_t at) const { return hn::Load(hn::RebindToSigned<Tag>(), edge_[k] + at); }

  int32_t length, pixels;  // in samples and in pixels

 private:
  /// plane_at().base for every lane.
  HWY_INLINE void SetBase(const DepthSlope& slope) {
    const hn::ScalableTag<double> d;
    const DepthOrigin origin = origin_of(slope);
    for (int32_t at = 0; at < length; at += static_cast<int32_t>(hn::Lanes(d))) {
      const auto step_x = hn::Set(d, origin.step_x) + hn::LoadU(d, pattern_.pixel_x + at);
      const auto step_y = hn::Set(d, origin.step_y) + hn::LoadU(d, pattern_.pixel_y + at);
      const auto along_x = hn::Set(d, slope.z) + hn::Set(d, slope.dx) * step_x;
      const hn::Rebind<float, decltype(d)> df;
      hn::StoreU(hn::DemoteTo(df, along_x + hn::Set(d, slope.dy) * step_y), df, base_ + at);
    }
  }

  const SamplePattern& pattern_;
  alignas(64) float base_[kMaxSamples];
  alignas(64) int32_t edge_[3][kSamples == Samples::kVectors ? kMaxSamples : 1];
};

/// Specialisation for one sample per pixel.
template <>
class Period<Samples::kSingle> {
 public:
  HWY_INLINE explicit Period(const TriangleSetup& t)
      : length(static_cast<int32_t>(hn::Lanes(Tag()))),
        pixels(length),
        point_(t.pattern->point[0]),
        base_(hn::Set(Tag(), plane_at(t.slope, point_).base)) {}

  HWY_INLINE Int column(int32_t) const { return hn::Iota(hn::RebindToSigned<Tag>(), 0); }
  HWY_INLINE V base(int32_t) const { return base_; }
  HWY_INLINE Int edge(const EdgeLine& line, int32_t) const {
    const hn::RebindToSigned<Tag> di;
    const auto steps = hn::Set(di, static_cast<int32_t>(line.a)) * hn::Iota(di, 0);
    return hn::Set(di, static_cast<int32_t>(edge_at(line, point_).value)) + steps;
  }
  HWY_INLINE Int stored_edge(int, int32_t) const { return hn::Zero(hn::RebindToSigned<Tag>()); }

  const int32_t length, pixels;

 private:
  const SamplePoint point_;
  const V base_;
};

/// Values of one edge function: at the first vector of the row, at the current vector, and the steps to the next vector
/// and to the next row.
struct EdgeWalk {
  template <Samples kSamples>
  HWY_INLINE EdgeWalk(const EdgeLine& line, const Period<kSamples>& period, int32_t x, int32_t y) {
    const hn::RebindToSigned<Tag> di;
    const auto a = static_cast<int32_t>(line.a), b = static_cast<int32_t>(line.b);
    row = hn::Set(di, a * x + b * y);
    if (kSamples != Samples::kVectors) row = row + period.edge(line, 0);
    right = hn::Set(di, a * period.pixels);
    down = hn::Set(di, b);
  }
  HWY_INLINE void BeginRow() { here = row; }
  HWY_INLINE void NextVector() { here = here + right; }
  HWY_INLINE void NextRow() { row = row + down; }

  Int row, here, right, down;
};

/// Calls body(at, inside, z) for every vector with covered samples: `at` is the position of its first sample in the
/// tile, z are the depths. Unless Variant::kClipped, the box must be the box of the triangle in the tile.
template <class Variant, class Body>
HWY_INLINE void ForEachCovered(const TriangleSetup& t, const Body& body) {
  constexpr Samples kSamples = Variant::kSamples;
  constexpr bool kStored = kSamples == Samples::kVectors;
  const Tag d;
  const hn::RebindToSigned<Tag> di;
  const auto lanes = static_cast<int32_t>(hn::Lanes(d));
  const int32_t samples = kSamples == Samples::kSingle ? 1 : static_cast<int32_t>(t.pattern->count);
  const Period<kSamples> period(t);
  const int32_t length = kStored ? period.length : lanes, pixels = period.pixels, first_x = t.box.min_x & -pixels;
  const DepthPlane plane = plane_at(t.slope, t.pattern->point[0]);
  const auto low = hn::Set(d, plane.low), high = hn::Set(d, plane.high), slope = hn::Set(d, plane.dx);
  const auto before = hn::Set(di, t.box.min_x - 1), behind = hn::Set(di, t.box.max_x + 1);
  const auto to_origin = hn::Set(di, t.left - plane.x0);
  EdgeWalk edge0(t.line[0], period, first_x, t.box.min_y), edge1(t.line[1], period, first_x, t.box.min_y);
  EdgeWalk edge2(t.line[2], period, first_x, t.box.min_y);
  for (int32_t y = t.box.min_y; y <= t.box.max_y; ++y) {
    const auto depth = hn::Set(d, plane.dy * static_cast<float>(t.top + y - plane.y0));
    for (EdgeWalk* edge : {&edge0, &edge1, &edge2}) edge->BeginRow();
    for (int32_t x = first_x; x <= t.box.max_x; x += pixels) {
      for (int32_t i = 0; i < length; i += lanes) {
        const auto side0 = kStored ? edge0.here + period.stored_edge(0, i) : edge0.here;
        const auto side1 = kStored ? edge1.here + period.stored_edge(1, i) : edge1.here;
        const auto side2 = kStored ? edge2.here + period.stored_edge(2, i) : edge2.here;
        auto in = hn::Gt(side0 | side1 | side2, hn::Set(di, -1));
        const auto column = hn::Set(di, x) + period.column(i);
        if (Variant::kClipped) in = hn::And(in, hn::And(hn::Gt(column, before), hn::Gt(behind, column)));
        const auto inside = hn::RebindMask(d, in);
        if (hn::AllFalse(d, inside)) continue;
        const auto from_origin = hn::ConvertTo(d, column + to_origin);
        const auto row = period.base(i) + depth;
        const auto z = hn::Min(hn::Max(slope * from_origin + row, low), high);
        body(static_cast<size_t>((y * kTile + x) * samples + i), inside, z);
      }
      for (EdgeWalk* edge : {&edge0, &edge1, &edge2}) edge->NextVector();
    }
    for (EdgeWalk* edge : {&edge0, &edge1, &edge2}) edge->NextRow();
  }
}

}  // namespace shd::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
