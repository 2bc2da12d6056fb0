// SPDX-License-Identifier: MIT
#include "raster/coverage.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <type_traits>

#include "raster/edge.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/coverage.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/depth_bounds-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::ScalableTag<float>;
using V = hn::Vec<Tag>;
using MaskV = hn::Mask<Tag>;

/// Depth tests by the name that API and kernels share.
template <shd_compare kCompare>
HWY_INLINE MaskV Passes(V z, V stored) {
  switch (kCompare) {
    case SHD_COMPARE_LESS_EQUAL: return hn::Le(z, stored);
    case SHD_COMPARE_EQUAL: return hn::Eq(z, stored);
    case SHD_COMPARE_GREATER_EQUAL: return hn::Ge(z, stored);
    case SHD_COMPARE_GREATER: return hn::Gt(z, stored);
    case SHD_COMPARE_NOT_EQUAL: return hn::Not(hn::Eq(z, stored));
    case SHD_COMPARE_ALWAYS: return hn::Eq(z, z);
    case SHD_COMPARE_NEVER: return hn::Lt(z, z);
    default: return hn::Lt(z, stored);
  }
}

/// A triangle over a tile. Samples lie in rows as the tile has them: those of one pixel, then those of the next.
struct Span {
  const SamplePattern& pattern;
  EdgeLine line[3];  // 0 where all samples of the tile are inside
  DepthSlope slope;
  geometry::PixelBox box;  // of the tile
  int32_t left, top;       // of the tile in the frame
};

enum class Samples { kSingle, kOneVector, kVectors };  // of a pixel: one; as many as fit a vector; more

/// What repeats along the rows of a triangle: edges that fit int32 and the origin of depth at the samples of as many
/// pixels as fill a vector, or of one.
template <Samples kSamples>
class Period {
 public:
  using Int = hn::Vec<hn::RebindToSigned<Tag>>;

  HWY_INLINE explicit Period(const Span& s) : pattern_(s.pattern) {
    const auto lanes = static_cast<int32_t>(hn::Lanes(Tag())), samples = static_cast<int32_t>(s.pattern.count);
    length = kSamples == Samples::kVectors ? samples : lanes;
    pixels = kSamples == Samples::kVectors ? 1 : lanes / samples;
    PlaceDepth(s.slope);
    for (int32_t at = 0; kSamples == Samples::kVectors && at < length; at += lanes) {
      for (int k = 0; k < 3; ++k) hn::Store(edge(s.line[k], at), hn::RebindToSigned<Tag>(), edge_[k] + at);
    }
  }

  HWY_INLINE Int column(int32_t at) const { return hn::LoadU(hn::RebindToSigned<Tag>(), pattern_.column + at); }
  HWY_INLINE V base(int32_t at) const { return hn::Load(Tag(), base_ + at); }

  /// edge_at() for lanes from `at` on: the pixels' part in whole pixels, the rest before rounding.
  HWY_INLINE Int edge(const EdgeLine& line, int32_t at) const {
    const hn::RebindToSigned<Tag> di;
    const auto a = hn::Set(di, static_cast<int32_t>(line.a)), b = hn::Set(di, static_cast<int32_t>(line.b));
    const auto whole = hn::Set(di, static_cast<int32_t>(line.value >> geometry::kSubpixelBits));
    const auto part = hn::Set(di, static_cast<int32_t>(line.value & (geometry::kSubpixels - 1)));
    const auto x = hn::Mul(a, hn::LoadU(di, pattern_.x + at)), y = hn::Mul(b, hn::LoadU(di, pattern_.y + at));
    const auto in_pixel = hn::ShiftRight<geometry::kSubpixelBits>(hn::Add(part, hn::Add(x, y)));
    return hn::Add(hn::Add(whole, in_pixel), hn::Mul(a, column(at)));
  }

  HWY_INLINE Int stored_edge(int k, int32_t at) const { return hn::Load(hn::RebindToSigned<Tag>(), edge_[k] + at); }

  int32_t length, pixels;  // in samples and in pixels

 private:
  /// plane_at().base for every lane.
  HWY_INLINE void PlaceDepth(const DepthSlope& slope) {
    const hn::ScalableTag<double> d;
    const DepthOrigin origin = origin_of(slope);
    for (int32_t at = 0; at < length; at += static_cast<int32_t>(hn::Lanes(d))) {
      const auto step_x = hn::Add(hn::Set(d, origin.step_x), hn::LoadU(d, pattern_.pixel_x + at));
      const auto step_y = hn::Add(hn::Set(d, origin.step_y), hn::LoadU(d, pattern_.pixel_y + at));
      const auto along_x = hn::Add(hn::Set(d, slope.z), hn::Mul(hn::Set(d, slope.dx), step_x));
      const hn::Rebind<float, decltype(d)> df;
      hn::StoreU(hn::DemoteTo(df, hn::Add(along_x, hn::Mul(hn::Set(d, slope.dy), step_y))), df, base_ + at);
    }
  }

  const SamplePattern& pattern_;
  alignas(64) float base_[kMaxSamples];
  alignas(64) int32_t edge_[3][kSamples == Samples::kVectors ? kMaxSamples : 1];
};

/// With one sample a pixel.
template <>
class Period<Samples::kSingle> {
 public:
  using Int = hn::Vec<hn::RebindToSigned<Tag>>;

  HWY_INLINE explicit Period(const Span& s)
      : length(static_cast<int32_t>(hn::Lanes(Tag()))),
        pixels(length),
        point_(s.pattern.point[0]),
        base_(hn::Set(Tag(), plane_at(s.slope, point_).base)) {}

  HWY_INLINE Int column(int32_t) const { return hn::Iota(hn::RebindToSigned<Tag>(), 0); }
  HWY_INLINE V base(int32_t) const { return base_; }
  HWY_INLINE Int edge(const EdgeLine& line, int32_t) const {
    const hn::RebindToSigned<Tag> di;
    const auto steps = hn::Mul(hn::Set(di, static_cast<int32_t>(line.a)), hn::Iota(di, 0));
    return hn::Add(hn::Set(di, static_cast<int32_t>(edge_at(line, point_).value)), steps);
  }
  HWY_INLINE Int stored_edge(int, int32_t) const { return hn::Zero(hn::RebindToSigned<Tag>()); }

  const int32_t length, pixels;

 private:
  const SamplePoint point_;
  const V base_;
};

/// An edge at the first vector of a triangle's rows, and its steps.
struct EdgeSteps {
  HWY_INLINE EdgeSteps(const EdgeLine& line, int32_t x, int32_t y, int32_t pixels)
      : a(static_cast<int32_t>(line.a)), b(static_cast<int32_t>(line.b)), start(a * x + b * y), right(a * pixels) {}
  int32_t a, b, start, right;
};

/// Lets `body(at, inside, z)` see every vector with a covered sample: edges that fit int32 over the tile. Without
/// kClipped nothing that the edges let in lies outside the box.
template <Samples kSamples, bool kClipped, class Body>
HWY_INLINE void ForEachNarrow(const Span& s, const Body& body) {
  constexpr bool kOne = kSamples != Samples::kVectors;
  const Tag d;
  const hn::RebindToSigned<Tag> di;
  const auto lanes = static_cast<int32_t>(hn::Lanes(d));
  const int32_t samples = kSamples == Samples::kSingle ? 1 : static_cast<int32_t>(s.pattern.count);
  const Period<kSamples> period(s);
  const int32_t length = kOne ? lanes : period.length, pixels = period.pixels;
  const DepthPlane plane = plane_at(s.slope, s.pattern.point[0]);
  const auto low = hn::Set(d, plane.low), high = hn::Set(d, plane.high), slope = hn::Set(d, plane.dx);
  const auto before = hn::Set(di, s.box.min_x - 1), behind = hn::Set(di, s.box.max_x + 1);
  const auto to_origin = hn::Set(di, s.left - plane.x0);
  const int32_t first_x = s.box.min_x & -pixels;
  const EdgeSteps steps0(s.line[0], first_x, s.box.min_y, pixels), steps1(s.line[1], first_x, s.box.min_y, pixels);
  const EdgeSteps steps2(s.line[2], first_x, s.box.min_y, pixels);
  auto row0 = hn::Set(di, steps0.start), row1 = hn::Set(di, steps1.start), row2 = hn::Set(di, steps2.start);
  if (kOne) {
    row0 = hn::Add(row0, period.edge(s.line[0], 0));
    row1 = hn::Add(row1, period.edge(s.line[1], 0));
    row2 = hn::Add(row2, period.edge(s.line[2], 0));
  }
  const auto right0 = hn::Set(di, steps0.right), right1 = hn::Set(di, steps1.right), right2 = hn::Set(di, steps2.right);
  const auto down0 = hn::Set(di, steps0.b), down1 = hn::Set(di, steps1.b), down2 = hn::Set(di, steps2.b);
  for (int32_t y = s.box.min_y; y <= s.box.max_y; ++y) {
    const auto depth = hn::Set(d, plane.dy * static_cast<float>(s.top + y - plane.y0));
    auto e0 = row0, e1 = row1, e2 = row2;
    for (int32_t x = first_x; x <= s.box.max_x; x += pixels) {
      for (int32_t i = 0; i < length; i += lanes) {
        const auto side0 = kOne ? e0 : hn::Add(e0, period.stored_edge(0, i));
        const auto side1 = kOne ? e1 : hn::Add(e1, period.stored_edge(1, i));
        const auto side2 = kOne ? e2 : hn::Add(e2, period.stored_edge(2, i));
        auto in = hn::Gt(hn::Or(hn::Or(side0, side1), side2), hn::Set(di, -1));
        const auto column = hn::Add(hn::Set(di, x), period.column(i));
        if (kClipped) in = hn::And(in, hn::And(hn::Gt(column, before), hn::Gt(behind, column)));
        const auto inside = hn::RebindMask(d, in);
        if (hn::AllFalse(d, inside)) continue;
        const auto from_origin = hn::ConvertTo(d, hn::Add(column, to_origin));
        const auto row = hn::Add(period.base(i), depth);
        const auto z = hn::Min(hn::Max(hn::Add(hn::Mul(slope, from_origin), row), low), high);
        body(static_cast<size_t>((y * kTile + x) * samples + i), inside, z);
      }
      e0 = hn::Add(e0, right0);
      e1 = hn::Add(e1, right1);
      e2 = hn::Add(e2, right2);
    }
    row0 = hn::Add(row0, down0);
    row1 = hn::Add(row1, down1);
    row2 = hn::Add(row2, down2);
  }
}

/// The same for edges too long for int32: sides one sample at a time in int64.
template <class Body>
HWY_INLINE void ForEachWide(const Span& s, const Body& body) {
  const Tag d;
  const hn::RebindToUnsigned<Tag> du;
  const auto lanes = static_cast<int32_t>(hn::Lanes(d)), samples = static_cast<int32_t>(s.pattern.count);
  alignas(64) uint32_t covered[hn::MaxLanes(Tag())];
  alignas(64) float z[hn::MaxLanes(Tag())];
  DepthPlane plane[kMaxSamples];
  for (int32_t k = 0; k < samples; ++k) plane[k] = plane_at(s.slope, s.pattern.point[k]);
  for (int32_t y = s.box.min_y; y <= s.box.max_y; ++y) {
    for (int32_t at = s.box.min_x * samples / lanes * lanes; at < (s.box.max_x + 1) * samples; at += lanes) {
      for (int32_t i = 0; i < lanes; ++i) {
        const int32_t x = (at + i) / samples, sample = (at + i) % samples;
        covered[i] = x >= s.box.min_x && x <= s.box.max_x && covers(s.line, x, y, s.pattern.point[sample]);
        z[i] = depth_at(plane[sample], s.left + x, s.top + y);
      }
      const auto inside = hn::RebindMask(d, hn::Ne(hn::Load(du, covered), hn::Zero(du)));
      if (hn::AllFalse(d, inside)) continue;
      body(static_cast<size_t>(y * kTile * samples + at), inside, hn::Load(d, z));
    }
  }
}

/// body(at, inside, z) for every vector of samples that has some in the triangle; `at` is the place of its first one in
/// the tile.
/// @param box  pixels of the tile that the triangle may touch, not empty
template <Samples kSamples, class Body>
HWY_INLINE void ForEachCovered(const geometry::ScreenTriangle& triangle, const CoverArea& area, const DepthState& state,
                               const geometry::PixelBox& box, const Body& body) {
  Span s = {area.pattern, {}, {}, box, area.left, area.top};
  bool narrow = true;
  for (int k = 0; k < 3; ++k) {
    s.line[k] = make_edge_line(triangle, k, area.left, area.top);
    const EdgeSide side = side_of(s.line[k], area.pattern.extent);
    if (side == EdgeSide::kOutside) return;
    if (side == EdgeSide::kInside) s.line[k] = {0, 0, 0};
    narrow &= std::abs(s.line[k].a) <= kNarrowStep && std::abs(s.line[k].b) <= kNarrowStep;
  }
  s.slope = make_depth_slope(triangle, state);
  const bool clipped = area.box.max_x - area.box.min_x != kTile - 1;
  if (!narrow) return ForEachWide(s, body);
  clipped ? ForEachNarrow<kSamples, true>(s, body) : ForEachNarrow<kSamples, false>(s, body);
}

/// Pixels of the tile that a triangle may touch.
HWY_INLINE geometry::PixelBox BoxInTile(const geometry::ScreenTriangle& triangle, const CoverArea& area) {
  const geometry::PixelBox box = geometry::intersection(geometry::pixel_box(triangle, area.pattern.extent), area.box);
  return {box.min_x - area.left, box.min_y - area.top, box.max_x - area.left, box.max_y - area.top};
}

/// Smaller boxes cost less to cover than to look up.
constexpr int32_t kLeastBoundedPixels = 128;

template <shd_compare kCompare, Samples kSamples>
void CoverWith(const CoverArea& area, const DepthState& state, const geometry::ScreenTriangle* triangles,
               const uint32_t* entries, size_t count, uint32_t first_slot, Tile& tile) {
  const Tag d;
  const hn::RebindToUnsigned<Tag> du;
  const bool has_slots = first_slot != kNoSlot;
  const bool is_biased = state.bias != 0.0f || state.slope_bias != 0.0f;
  Bounds<trend_of(kCompare)> bounds(tile);
  if (trend_of(kCompare) == DepthTrend::kUnknown && state.writes) forget_bounds(&tile);
  float* depth = tile.depth.data();
  uint32_t* slot = tile.slot.data();
  for (size_t i = 0; i < count; ++i) {
    const geometry::ScreenTriangle& triangle = triangles[entries[i]];
    const geometry::PixelBox box = BoxInTile(triangle, area);
    if (geometry::is_empty(box)) continue;
    const int32_t pixels = (box.max_x - box.min_x + 1) * (box.max_y - box.min_y + 1);
    if (pixels >= kLeastBoundedPixels && !is_biased && !bounds.MayPass(BlockBox(box), triangle)) continue;
    const auto id = hn::Set(du, first_slot + static_cast<uint32_t>(i));
    ForEachCovered<kSamples>(triangle, area, state, box, [&](size_t at, MaskV inside, V z) {
      const auto stored = hn::Load(d, depth + at);
      const auto pass = hn::And(inside, Passes<kCompare>(z, stored));
      if (state.writes) hn::Store(hn::IfThenElse(pass, z, stored), d, depth + at);
      if (has_slots) {
        hn::Store(hn::IfThenElse(hn::RebindMask(du, pass), id, hn::Load(du, slot + at)), du, slot + at);
      }
    });
  }
}

/// Adds the samples of a vector, of which the first lies at `at`, to the masks of their pixels.
template <class M>
HWY_INLINE void AddToMasks(M pass, size_t at, uint32_t samples, uint32_t* bits) {
  const Tag d;
  uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, pass, bytes);
  uint32_t rest = static_cast<uint32_t>(bytes[0]) | static_cast<uint32_t>(bytes[1]) << 8;
  uint32_t* pixel = bits + at / samples;
  const uint32_t all = (1u << samples) - 1;
  for (uint32_t shift = static_cast<uint32_t>(at % samples); rest; rest >>= samples, ++pixel) {
    *pixel |= (rest & all) << shift;
  }
}

template <shd_compare kCompare, Samples kSamples>
void MaskWith(const CoverArea& area, const DepthState& state, const geometry::ScreenTriangle& triangle,
              const Tile& tile, CoverMask& out) {
  static_assert(hn::MaxLanes(Tag()) <= 16, "two bytes of mask");
  const Tag d;
  const float* depth = tile.depth.data();
  ForEachCovered<kSamples>(triangle, area, state, BoxInTile(triangle, area), [&](size_t at, MaskV inside, V z) {
    const auto pass = hn::And(inside, Passes<kCompare>(z, hn::Load(d, depth + at)));
    AddToMasks(pass, at, area.pattern.count, out.bits);
  });
}

/// body(constant) with the kind of samples, and with the comparison.
template <class Body>
void WithSamples(uint32_t count, const Body& body) {
  if (count == 1) return body(std::integral_constant<Samples, Samples::kSingle>());
  if (count <= hn::Lanes(Tag())) return body(std::integral_constant<Samples, Samples::kOneVector>());
  return body(std::integral_constant<Samples, Samples::kVectors>());
}
template <class Body>
void WithCompare(shd_compare compare, const Body& body) {
  switch (compare) {
    case SHD_COMPARE_LESS_EQUAL: return body(std::integral_constant<shd_compare, SHD_COMPARE_LESS_EQUAL>());
    case SHD_COMPARE_EQUAL: return body(std::integral_constant<shd_compare, SHD_COMPARE_EQUAL>());
    case SHD_COMPARE_GREATER_EQUAL: return body(std::integral_constant<shd_compare, SHD_COMPARE_GREATER_EQUAL>());
    case SHD_COMPARE_GREATER: return body(std::integral_constant<shd_compare, SHD_COMPARE_GREATER>());
    case SHD_COMPARE_NOT_EQUAL: return body(std::integral_constant<shd_compare, SHD_COMPARE_NOT_EQUAL>());
    case SHD_COMPARE_ALWAYS: return body(std::integral_constant<shd_compare, SHD_COMPARE_ALWAYS>());
    case SHD_COMPARE_NEVER: return body(std::integral_constant<shd_compare, SHD_COMPARE_NEVER>());
    default: return body(std::integral_constant<shd_compare, SHD_COMPARE_LESS>());
  }
}

void Cover(const CoverArea& area, const DepthState& state, const geometry::ScreenTriangle* triangles,
           const uint32_t* entries, size_t count, uint32_t first_slot, Tile& tile) {
  WithSamples(area.pattern.count, [&](auto samples) {
    WithCompare(state.compare, [&](auto compare) {
      CoverWith<decltype(compare)::value, decltype(samples)::value>(area, state, triangles, entries, count, first_slot,
                                                                    tile);
    });
  });
}

void Mask(const CoverArea& area, const DepthState& state, const geometry::ScreenTriangle& triangle, const Tile& tile,
          CoverMask& out) {
  WithSamples(area.pattern.count, [&](auto samples) {
    WithCompare(state.compare, [&](auto compare) {
      MaskWith<decltype(compare)::value, decltype(samples)::value>(area, state, triangle, tile, out);
    });
  });
}

}  // namespace shd::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::raster {

HWY_EXPORT(Cover);
HWY_EXPORT(Mask);

void cover(const core::SimdTarget& simd, const CoverArea& area, const DepthState& state,
           const geometry::ScreenTriangle* triangles, const uint32_t* entries, size_t count, uint32_t first_slot,
           Tile* tile) {
  SHD_DISPATCH(Cover, simd)(area, state, triangles, entries, count, first_slot, *tile);
}

void cover_mask(const core::SimdTarget& simd, const CoverArea& area, const DepthState& state,
                const geometry::ScreenTriangle& triangle, const Tile& tile, CoverMask* out) {
  const geometry::PixelBox box = geometry::intersection(geometry::pixel_box(triangle, area.pattern.extent), area.box);
  out->box = {box.min_x - area.left, box.min_y - area.top, box.max_x - area.left, box.max_y - area.top};
  if (geometry::is_empty(out->box)) return;
  const int32_t first = out->box.min_x & ~15, end = (out->box.max_x | 15) + 1;  // kernels touch whole vectors
  for (int32_t y = out->box.min_y; y <= out->box.max_y; ++y) {
    std::memset(out->bits + y * kTile + first, 0, static_cast<size_t>(end - first) * sizeof(uint32_t));
  }
  SHD_DISPATCH(Mask, simd)(area, state, triangle, tile, *out);
}

}  // namespace shd::raster
#endif  // HWY_ONCE
