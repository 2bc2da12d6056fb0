// SPDX-License-Identifier: MIT
// Triangles whose box in the tile is at most 8 x 8 pixels, set up one per lane. Samples and depths are those of
// traverse-inl.h.
#if defined(SHD_RASTER_SMALL_TRIANGLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_RASTER_SMALL_TRIANGLES_INL_H_
#undef SHD_RASTER_SMALL_TRIANGLES_INL_H_
#else
#define SHD_RASTER_SMALL_TRIANGLES_INL_H_
#endif

#include <algorithm>
#include <cstdint>
#include <cstring>

#include <hwy/highway.h>

#include "raster/traverse-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr int32_t kSmallBox = 8;  // most pixels along the sides of the box

/// Most subpixels along the sides of a small triangle, which may reach beyond the tile. All products of two lengths and
/// their sums fit int32, and all lengths are exact in float.
constexpr int32_t kSmallSide = 1 << 12;

/// A mask holds the pixels of kMaskColumns columns of a box, row by row from bit 0.
constexpr int32_t kMaskColumns = 4;
constexpr size_t kMasks = kSmallBox / kMaskColumns;

/// As many triangles as a vector has lanes. Depths are as in DepthPlane, but relative to the first pixel of the box.
struct SmallTriangles {
  static constexpr size_t kMax = hn::MaxLanes(Tag());

  uint32_t is_small;  // bits of the triangles; the others are undefined here
  alignas(64) int32_t x[kMax], y[kMax], columns[kMax], rows[kMax];  // box in the tile
  alignas(64) float from_x[kMax], from_y[kMax];                     // the first pixel, from the origin of the plane
  alignas(64) float dx[kMax], dy[kMax], low[kMax], high[kMax];
  alignas(64) float base[kMaxSamples][kMax];
  alignas(64) uint32_t covered[kMaxSamples][kMasks][kMax];
};

/// The vertices of a group of triangles.
struct GroupCorners {
  Int x[3], y[3];
  V z[3];
};

/// Loads triangles; lanes from `count` on repeat the last of them.
HWY_INLINE GroupCorners LoadGroup(const geometry::ScreenTriangle* triangles, const uint32_t* entries, size_t count) {
  const hn::RebindToSigned<Tag> di;
  static_assert(sizeof(geometry::ScreenTriangle) == 48, "three rows of four 32-bit values");
  alignas(64) int32_t part[3][4 * SmallTriangles::kMax];
  for (size_t i = 0; i < hn::Lanes(di); ++i) {
    const char* from = reinterpret_cast<const char*>(triangles + entries[std::min(i, count - 1)]);
    for (size_t k = 0; k < 3; ++k) std::memcpy(part[k] + 4 * i, from + 16 * k, 16);
  }
  GroupCorners out;
  Int z0, z1, z2, unused;
  hn::LoadInterleaved4(di, part[0], out.x[0], out.x[1], out.x[2], out.y[0]);
  hn::LoadInterleaved4(di, part[1], out.y[1], out.y[2], z0, z1);
  hn::LoadInterleaved4(di, part[2], z2, unused, unused, unused);
  out.z[0] = hn::BitCast(Tag(), z0);
  out.z[1] = hn::BitCast(Tag(), z1);
  out.z[2] = hn::BitCast(Tag(), z2);
  return out;
}

/// Finds the boxes of a group in the tile, and which triangles are small.
HWY_INLINE void FindBoxes(const CoverArea& area, const GroupCorners& t, SmallTriangles& out) {
  const hn::RebindToSigned<Tag> di;
  const geometry::SampleExtent& samples = area.pattern.extent;
  const auto min_x = hn::Min(hn::Min(t.x[0], t.x[1]), t.x[2]), max_x = hn::Max(hn::Max(t.x[0], t.x[1]), t.x[2]);
  const auto min_y = hn::Min(hn::Min(t.y[0], t.y[1]), t.y[2]), max_y = hn::Max(hn::Max(t.y[0], t.y[1]), t.y[2]);
  const auto first = [&](Int edge, int32_t reach, int32_t limit) {
    const auto pixel = hn::ShiftRight<geometry::kSubpixelBits>(edge + hn::Set(di, geometry::kSubpixels - 1 - reach));
    return hn::Max(pixel, hn::Set(di, limit));
  };
  const auto last = [&](Int edge, int32_t reach, int32_t limit) {
    return hn::Min(hn::ShiftRight<geometry::kSubpixelBits>(edge - hn::Set(di, reach)), hn::Set(di, limit));
  };
  const auto left = first(min_x, samples.max_x, area.box.min_x), top = first(min_y, samples.max_y, area.box.min_y);
  const auto columns = last(max_x, samples.min_x, area.box.max_x) - left + hn::Set(di, 1);
  const auto rows = last(max_y, samples.min_y, area.box.max_y) - top + hn::Set(di, 1);
  const auto sides = (max_x - min_x) | (max_y - min_y);
  // A side is too long if it has bits beyond kSmallSide - 1. A box is too large if columns - 1 or rows - 1 has bits
  // beyond kSmallBox - 1; the sign bit is one of them and marks an empty box.
  const auto spans = (columns - hn::Set(di, 1)) | (rows - hn::Set(di, 1));
  const auto excess = hn::AndNot(hn::Set(di, kSmallSide - 1), sides) | hn::AndNot(hn::Set(di, kSmallBox - 1), spans);
  uint8_t bytes[8] = {};
  hn::StoreMaskBits(di, hn::Eq(excess, hn::Zero(di)), bytes);
  out.is_small = static_cast<uint32_t>(bytes[0]) | static_cast<uint32_t>(bytes[1]) << 8;
  hn::Store(left - hn::Set(di, area.left), di, out.x);
  hn::Store(top - hn::Set(di, area.top), di, out.y);
  hn::Store(columns, di, out.columns);
  hn::Store(rows, di, out.rows);
}

/// An edge function of each triangle in whole pixels, at a sample of the first pixel of its box, as edge_at() finds it.
struct SmallEdge {
  Int value, a, b;
};

HWY_INLINE SmallEdge MakeSmallEdge(const GroupCorners& t, int k, Int sample_x, Int sample_y) {
  const hn::RebindToSigned<Tag> di;
  const int next = k == 2 ? 0 : k + 1;
  const auto a = t.y[k] - t.y[next], b = t.x[next] - t.x[k], zero = hn::Zero(di);
  const auto owns_boundary = hn::Or(hn::Gt(a, zero), hn::And(hn::Eq(a, zero), hn::Gt(b, zero)));
  const auto value = a * (sample_x - t.x[k]) + b * (sample_y - t.y[k]);
  const auto inner = value - hn::IfThenZeroElse(owns_boundary, hn::Set(di, 1));
  return {hn::ShiftRight<geometry::kSubpixelBits>(inner), a, b};
}

/// The pixels that have a sample on the inner side of all edges, in kMaskColumns columns and some rows.
HWY_INLINE Int CoveredPixels(SmallEdge edge0, SmallEdge edge1, SmallEdge edge2, int32_t rows) {
  const hn::RebindToSigned<Tag> di;
  const hn::RebindToUnsigned<Tag> du;
  const auto sign = hn::Set(di, static_cast<int32_t>(0x80000000u));
  auto outside = hn::Zero(du);
  for (int32_t row = 0; row < rows; ++row) {
    auto side0 = edge0.value, side1 = edge1.value, side2 = edge2.value;
    for (int32_t column = 0; column < kMaskColumns; ++column) {
      const auto is_outside = hn::And(side0 | side1 | side2, sign);
      outside = hn::ShiftRight<1>(outside) | hn::BitCast(du, is_outside);
      side0 = side0 + edge0.a;
      side1 = side1 + edge1.a;
      side2 = side2 + edge2.a;
    }
    edge0.value = edge0.value + edge0.b;
    edge1.value = edge1.value + edge1.b;
    edge2.value = edge2.value + edge2.b;
  }
  const auto inside = hn::Not(hn::BitCast(di, outside));
  return hn::BitCast(di, hn::ShiftRightSame(hn::BitCast(du, inside), 32 - kMaskColumns * rows));
}

/// Finds the masks of all samples.
HWY_INLINE void FindCovered(const SamplePattern& pattern, const CoverArea& area, const GroupCorners& t,
                            SmallTriangles& out) {
  const hn::RebindToSigned<Tag> di;
  int32_t most_columns = 0, most_rows = 0;
  for (uint32_t rest = out.is_small; rest; rest &= rest - 1) {
    most_columns = std::max(most_columns, out.columns[__builtin_ctz(rest)]);
    most_rows = std::max(most_rows, out.rows[__builtin_ctz(rest)]);
  }
  const auto left = hn::ShiftLeft<geometry::kSubpixelBits>(hn::Load(di, out.x) + hn::Set(di, area.left));
  const auto top = hn::ShiftLeft<geometry::kSubpixelBits>(hn::Load(di, out.y) + hn::Set(di, area.top));
  for (uint32_t s = 0; s < pattern.count; ++s) {
    const auto x = left + hn::Set(di, pattern.point[s].x), y = top + hn::Set(di, pattern.point[s].y);
    SmallEdge edge[3] = {MakeSmallEdge(t, 0, x, y), MakeSmallEdge(t, 1, x, y), MakeSmallEdge(t, 2, x, y)};
    for (int32_t m = 0; m * kMaskColumns < most_columns; ++m) {
      const auto covered = CoveredPixels(edge[0], edge[1], edge[2], most_rows);
      hn::Store(hn::BitCast(hn::RebindToUnsigned<Tag>(), covered), hn::RebindToUnsigned<Tag>(), out.covered[s][m]);
      for (SmallEdge& e : edge) e.value = e.value + hn::ShiftLeft<2>(e.a);
    }
  }
}

/// make_depth_slope() and plane_at() without bias.
HWY_INLINE void FindPlanes(const SamplePattern& pattern, const CoverArea& area, const GroupCorners& t,
                           SmallTriangles& out) {
  const Tag d;
  const hn::RebindToSigned<Tag> di;
  const hn::ScalableTag<double> dd;
  const hn::Rebind<float, decltype(dd)> df;
  alignas(64) float side[4][SmallTriangles::kMax], step[2][SmallTriangles::kMax], z[3][SmallTriangles::kMax];
  const Int sides[4] = {t.x[1] - t.x[0], t.y[1] - t.y[0], t.x[2] - t.x[0], t.y[2] - t.y[0]};
  for (int k = 0; k < 4; ++k) hn::Store(hn::ConvertTo(d, sides[k]), d, side[k]);
  for (int k = 0; k < 3; ++k) hn::Store(t.z[k], d, z[k]);
  const auto subpixel = hn::Set(di, geometry::kSubpixels - 1);
  const auto to_pixels = hn::Set(d, 1.0f / geometry::kSubpixels);
  hn::Store(hn::ConvertTo(d, hn::Zero(di) - (t.x[0] & subpixel)) * to_pixels, d, step[0]);
  hn::Store(hn::ConvertTo(d, hn::Zero(di) - (t.y[0] & subpixel)) * to_pixels, d, step[1]);
  const auto origin_x = hn::ShiftRight<geometry::kSubpixelBits>(t.x[0]) - hn::Set(di, area.left);
  const auto origin_y = hn::ShiftRight<geometry::kSubpixelBits>(t.y[0]) - hn::Set(di, area.top);
  hn::Store(hn::ConvertTo(d, hn::Load(di, out.x) - origin_x), d, out.from_x);
  hn::Store(hn::ConvertTo(d, hn::Load(di, out.y) - origin_y), d, out.from_y);
  // As std::min() and std::max(), which keep the first of equal values.
  const auto low = hn::IfThenElse(hn::Lt(t.z[1], t.z[0]), t.z[1], t.z[0]);
  const auto high = hn::IfThenElse(hn::Lt(t.z[0], t.z[1]), t.z[1], t.z[0]);
  hn::Store(hn::IfThenElse(hn::Lt(t.z[2], low), t.z[2], low), d, out.low);
  hn::Store(hn::IfThenElse(hn::Lt(high, t.z[2]), t.z[2], high), d, out.high);
  for (size_t i = 0; i < hn::Lanes(d); i += hn::Lanes(dd)) {
    const auto wide = [&](const float* from) { return hn::PromoteTo(dd, hn::Load(df, from + i)); };
    const auto x1 = wide(side[0]), y1 = wide(side[1]), x2 = wide(side[2]), y2 = wide(side[3]);
    const auto z0 = wide(z[0]), z1 = wide(z[1]) - z0, z2 = wide(z[2]) - z0;
    const auto scale = hn::Set(dd, geometry::kSubpixels) / (x1 * y2 - x2 * y1);
    const auto dx = (z1 * y2 - z2 * y1) * scale, dy = (z2 * x1 - z1 * x2) * scale;
    const auto at_vertex = z0 + hn::Set(dd, 0.0);  // the bias, which turns -0 into 0
    hn::Store(hn::DemoteTo(df, dx), df, out.dx + i);
    hn::Store(hn::DemoteTo(df, dy), df, out.dy + i);
    for (uint32_t s = 0; s < pattern.count; ++s) {
      const auto step_x = wide(step[0]) + hn::Set(dd, pattern.pixel_x[s]);
      const auto step_y = wide(step[1]) + hn::Set(dd, pattern.pixel_y[s]);
      hn::Store(hn::DemoteTo(df, at_vertex + dx * step_x + dy * step_y), df, out.base[s] + i);
    }
  }
}

/// Sets up `count` triangles, at most as many as a vector has lanes. The draw must have no depth bias.
HWY_NOINLINE void SetUpSmall(const CoverArea& area, const geometry::ScreenTriangle* triangles, const uint32_t* entries,
                             size_t count, SmallTriangles& out) {
  const GroupCorners corners = LoadGroup(triangles, entries, count);
  FindBoxes(area, corners, out);
  out.is_small &= (1u << count) - 1;
  if (!out.is_small) return;
  FindCovered(area.pattern, area, corners, out);
  FindPlanes(area.pattern, area, corners, out);
}

/// Offsets of the pixels of a mask from its first one.
struct MaskOffsets {
  int32_t at[32];
  float x[32], y[32];
};

constexpr MaskOffsets make_mask_offsets() {
  MaskOffsets out = {};
  for (int32_t bit = 0; bit < 32; ++bit) {
    const int32_t x = bit % kMaskColumns, y = bit / kMaskColumns;
    out.at[bit] = y * kTile + x;
    out.x[bit] = static_cast<float>(x);
    out.y[bit] = static_cast<float>(y);
  }
  return out;
}
constexpr MaskOffsets kMaskOffsets = make_mask_offsets();

/// The pixels of mask m that lie in a box.
HWY_INLINE uint32_t InBox(int32_t columns, int32_t rows, int32_t m) {
  const int32_t in_mask = std::min(columns - m * kMaskColumns, kMaskColumns);
  const uint32_t row = 0xfu >> (kMaskColumns - in_mask);
  return row * 0x11111111u & 0xffffffffu >> (32 - kMaskColumns * rows);
}

/// Calls body(at, z) for the covered samples of small triangle i: position in the tile and depth.
template <Samples kSamples, class Body>
HWY_INLINE void ForEachSmall(const SmallTriangles& t, size_t i, uint32_t sample_count, const Body& body) {
  const uint32_t samples = kSamples == Samples::kSingle ? 1 : sample_count;
  const float low = t.low[i], high = t.high[i], dx = t.dx[i], dy = t.dy[i];
  for (int32_t m = 0; m * kMaskColumns < t.columns[i]; ++m) {
    const int32_t first = t.y[i] * kTile + t.x[i] + m * kMaskColumns;
    const float from_x = t.from_x[i] + static_cast<float>(m * kMaskColumns), from_y = t.from_y[i];
    const uint32_t in_box = InBox(t.columns[i], t.rows[i], m);
    for (uint32_t s = 0; s < samples; ++s) {
      const float base = t.base[s][i];
      for (uint32_t rest = t.covered[s][m][i] & in_box; rest; rest &= rest - 1) {
        const int bit = __builtin_ctz(rest);
        const float row = base + dy * (from_y + kMaskOffsets.y[bit]);
        const float z = dx * (from_x + kMaskOffsets.x[bit]) + row;
        const float above = z > low ? z : low;
        body(static_cast<size_t>(first + kMaskOffsets.at[bit]) * samples + s, above < high ? above : high);
      }
    }
  }
}

}  // namespace shd::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
