// SPDX-License-Identifier: MIT
#include "raster/coverage.h"

#include <cstdlib>
#include <cstring>
#include <type_traits>

#include "raster/edge.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/coverage.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

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

/// One triangle at one sample.
struct Span {
  Edge edge[3];
  DepthPlane plane;
  geometry::PixelBox box;  // of the tile
  int32_t left, top;       // of the tile in the frame
};

/// Lets `body(at, inside, z)` see every vector with a covered sample: edges that fit int32 over the tile. Without
/// kClipped nothing that the edges let in lies outside the box.
template <bool kClipped, class Body>
HWY_INLINE void ForEachNarrow(const Span& s, const Body& body) {
  const Tag d;
  const hn::RebindToSigned<Tag> di;
  const auto lanes = static_cast<int32_t>(hn::Lanes(d));
  const auto iota = hn::Iota(di, 0);
  int32_t a[3], b[3], value[3];
  for (int k = 0; k < 3; ++k) {
    a[k] = static_cast<int32_t>(s.edge[k].a);
    b[k] = static_cast<int32_t>(s.edge[k].b);
    value[k] = static_cast<int32_t>(s.edge[k].value);
  }
  const auto step0 = hn::Mul(hn::Set(di, a[0]), iota);
  const auto step1 = hn::Mul(hn::Set(di, a[1]), iota);
  const auto step2 = hn::Mul(hn::Set(di, a[2]), iota);
  const auto low = hn::Set(d, s.plane.low), high = hn::Set(d, s.plane.high);
  const auto slope = hn::Set(d, s.plane.dx);
  const auto before = hn::Set(di, s.box.min_x - 1), behind = hn::Set(di, s.box.max_x + 1);
  const int32_t first_x = s.box.min_x / lanes * lanes;
  for (int32_t y = s.box.min_y; y <= s.box.max_y; ++y) {
    const float row_depth = s.plane.base + s.plane.dy * static_cast<float>(s.top + y - s.plane.y0);
    const auto row = hn::Set(d, row_depth);
    for (int32_t x = first_x; x <= s.box.max_x; x += lanes) {
      const auto e0 = hn::Add(hn::Set(di, value[0] + a[0] * x + b[0] * y), step0);
      const auto e1 = hn::Add(hn::Set(di, value[1] + a[1] * x + b[1] * y), step1);
      const auto e2 = hn::Add(hn::Set(di, value[2] + a[2] * x + b[2] * y), step2);
      const auto column = hn::Add(iota, hn::Set(di, x));
      auto in = hn::Gt(hn::Or(hn::Or(e0, e1), e2), hn::Set(di, -1));
      if (kClipped) in = hn::And(in, hn::And(hn::Gt(column, before), hn::Gt(behind, column)));
      const auto inside = hn::RebindMask(d, in);
      if (hn::AllFalse(d, inside)) continue;
      const auto from_origin = hn::ConvertTo(d, hn::Add(column, hn::Set(di, s.left - s.plane.x0)));
      const auto z = hn::Min(hn::Max(hn::Add(hn::Mul(slope, from_origin), row), low), high);
      body(static_cast<size_t>(y * kTile + x), inside, z);
    }
  }
}

/// The same for edges too long for int32: sides one pixel at a time in int64.
template <class Body>
HWY_INLINE void ForEachWide(const Span& s, const Body& body) {
  const Tag d;
  const hn::RebindToUnsigned<Tag> du;
  const auto lanes = static_cast<int32_t>(hn::Lanes(d));
  alignas(64) uint32_t covered[hn::MaxLanes(Tag())];
  alignas(64) float z[hn::MaxLanes(Tag())];
  for (int32_t y = s.box.min_y; y <= s.box.max_y; ++y) {
    for (int32_t first = s.box.min_x / lanes * lanes; first <= s.box.max_x; first += lanes) {
      for (int32_t i = 0; i < lanes; ++i) {
        const int32_t x = first + i;
        int64_t sides = 0;
        for (const Edge& edge : s.edge) sides |= edge.value + edge.a * x + edge.b * y;
        covered[i] = sides >= 0 && x >= s.box.min_x && x <= s.box.max_x;
        z[i] = depth_at(s.plane, s.left + x, s.top + y);
      }
      const auto inside = hn::RebindMask(d, hn::Ne(hn::Load(du, covered), hn::Zero(du)));
      if (hn::AllFalse(d, inside)) continue;
      body(static_cast<size_t>(y * kTile + first), inside, hn::Load(d, z));
    }
  }
}

/// A triangle over a tile, whatever the sample.
class Setup {
 public:
  Setup(const geometry::ScreenTriangle& t, const CoverArea& area)
      : edge{make_edge_line(t, 0, area.left, area.top), make_edge_line(t, 1, area.left, area.top),
             make_edge_line(t, 2, area.left, area.top)} {}

  /// Found when a sample first needs it.
  HWY_INLINE const DepthSlope& depth(const geometry::ScreenTriangle& triangle, const DepthState& state) {
    if (!has_depth_) depth_ = make_depth_slope(triangle, state);
    has_depth_ = true;
    return depth_;
  }

  const EdgeLine edge[3];

 private:
  bool has_depth_ = false;
  DepthSlope depth_ = {};
};

/// body(at, inside, z) for every vector of pixels with a sample in the triangle.
template <class Body>
HWY_INLINE void ForEachCovered(const geometry::ScreenTriangle& triangle, const CoverArea& area, const DepthState& state,
                               SamplePoint sample, Setup* setup, const Body& body) {
  Span s;
  bool narrow = true;
  for (int k = 0; k < 3; ++k) {
    if (edge_at(setup->edge[k], sample, &s.edge[k]) == EdgeSide::kOutside) return;
    narrow &= std::abs(s.edge[k].a) <= kNarrowStep && std::abs(s.edge[k].b) <= kNarrowStep;
  }
  const geometry::PixelBox box =
      geometry::intersection(geometry::pixel_box(triangle, {sample.x, sample.x, sample.y, sample.y}), area.box);
  if (geometry::is_empty(box)) return;
  s.plane = plane_at(setup->depth(triangle, state), sample);
  s.left = area.left;
  s.top = area.top;
  s.box = {box.min_x - area.left, box.min_y - area.top, box.max_x - area.left, box.max_y - area.top};
  const bool clipped = area.box.max_x - area.box.min_x != kTile - 1;
  if (!narrow) return ForEachWide(s, body);
  clipped ? ForEachNarrow<true>(s, body) : ForEachNarrow<false>(s, body);
}

template <shd_compare kCompare>
void CoverWith(const CoverArea& area, const DepthState& state, const geometry::ScreenTriangle* triangles,
               const uint32_t* entries, size_t count, uint32_t first_slot, Tile& tile) {
  const Tag d;
  const hn::RebindToUnsigned<Tag> du;
  const bool has_slots = first_slot != kNoSlot;
  for (size_t i = 0; i < count; ++i) {
    const geometry::ScreenTriangle& triangle = triangles[entries[i]];
    Setup setup(triangle, area);
    const auto id = hn::Set(du, first_slot + static_cast<uint32_t>(i));
    for (uint32_t k = 0; k < area.pattern.count; ++k) {
      float* depth = tile.depth.data() + k * kTilePixels;
      uint32_t* slot = tile.slot.data() + k * kTilePixels;
      ForEachCovered(triangle, area, state, area.pattern.point[k], &setup, [&](size_t at, MaskV inside, V z) {
        const auto stored = hn::Load(d, depth + at);
        const auto pass = hn::And(inside, Passes<kCompare>(z, stored));
        if (state.writes) hn::Store(hn::IfThenElse(pass, z, stored), d, depth + at);
        if (has_slots) {
          hn::Store(hn::IfThenElse(hn::RebindMask(du, pass), id, hn::Load(du, slot + at)), du, slot + at);
        }
      });
    }
  }
}

template <shd_compare kCompare>
void MaskWith(const CoverArea& area, const DepthState& state, const geometry::ScreenTriangle& triangle,
              const Tile& tile, CoverMask& out) {
  const Tag d;
  const hn::RebindToUnsigned<Tag> du;
  Setup setup(triangle, area);
  for (uint32_t k = 0; k < area.pattern.count; ++k) {
    const float* depth = tile.depth.data() + k * kTilePixels;
    const auto bit = hn::Set(du, 1u << k);
    ForEachCovered(triangle, area, state, area.pattern.point[k], &setup, [&](size_t at, MaskV inside, V z) {
      const auto pass = hn::And(inside, Passes<kCompare>(z, hn::Load(d, depth + at)));
      const auto added = hn::IfThenElseZero(hn::RebindMask(du, pass), bit);
      hn::Store(hn::Or(hn::Load(du, out.bits + at), added), du, out.bits + at);
    });
  }
}

/// body(constant) with the comparison as a constant.
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
  WithCompare(state.compare, [&](auto compare) {
    CoverWith<decltype(compare)::value>(area, state, triangles, entries, count, first_slot, tile);
  });
}

void Mask(const CoverArea& area, const DepthState& state, const geometry::ScreenTriangle& triangle, const Tile& tile,
          CoverMask& out) {
  WithCompare(state.compare,
              [&](auto compare) { MaskWith<decltype(compare)::value>(area, state, triangle, tile, out); });
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
