// SPDX-License-Identifier: MIT
#include <cstring>

#include "color/program.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "color/show.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "image/encode-inl.h"
#include "simd/gather-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::color::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::ScalableTag<float>;
using DI = hn::RebindToSigned<DF>;
using DU = hn::RebindToUnsigned<DF>;
using VF = hn::Vec<DF>;
using VI = hn::Vec<DI>;
using VU = hn::Vec<DU>;

constexpr size_t kBlock = 512;  // pixels whose three channels pass all stages in the first-level cache
constexpr float kLargestInput = 1e12f;

/// Straight colour of a block; whole vectors, so that the last one may hold leftovers.
struct Block {
  alignas(64) float r[kBlock], g[kBlock], b[kBlock], a[kBlock];
};

HWY_INLINE VF Set(float value) {
  return hn::Set(DF(), value);
}

/// Clamps to low..high; NaN becomes 0, which lies between them.
HWY_INLINE VF Clean(VF v, float low, float high) {
  const VF number = hn::IfThenElseZero(hn::Eq(v, v), v);
  return hn::Min(hn::Max(number, Set(low)), Set(high));
}

/// Distance of a number's key from `first`, with the key clamped to first..last.
HWY_INLINE VU KeyOffset(VF v, int32_t first, int32_t last) {
  const DI di;
  const DU du;
  const VI bits = hn::BitCast(di, v);
  const VI key = hn::Xor(bits, hn::And(hn::ShiftRight<31>(bits), hn::Set(di, 0x7fffffff)));
  const VI clamped = hn::Min(hn::Max(key, hn::Set(di, first)), hn::Set(di, last));
  return hn::BitCast(du, clamped) - hn::Set(du, static_cast<uint32_t>(first));
}

/// Runs f(r, g, b) on every vector.
template <class F>
HWY_INLINE void ForEach(Block* block, size_t count, const F& f) {
  const DF d;
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    VF r = hn::Load(d, block->r + i), g = hn::Load(d, block->g + i), b = hn::Load(d, block->b + i);
    f(r, g, b);
    hn::Store(r, d, block->r + i);
    hn::Store(g, d, block->g + i);
    hn::Store(b, d, block->b + i);
  }
}

/// The straight colour of premultiplied pixels.
HWY_INLINE void Unpremultiply(VF& r, VF& g, VF& b, VF& a) {
  const DF d;
  const auto clean = [](VF v) { return Clean(v, -kLargestInput, kLargestInput); };
  a = Clean(a, 0.0f, 1.0f);
  r = clean(r), g = clean(g), b = clean(b);
  if (hn::AllTrue(d, hn::Eq(a, Set(1.0f)))) return;
  const auto visible = hn::Gt(a, hn::Zero(d));
  const VF divisor = hn::IfThenElse(visible, a, Set(1.0f));
  r = hn::IfThenElseZero(visible, clean(r / divisor));
  g = hn::IfThenElseZero(visible, clean(g / divisor));
  b = hn::IfThenElseZero(visible, clean(b / divisor));
}

/// Loads one vector, of pixels at `plane`, to `at` in the block.
HWY_INLINE void LoadPixels(const float* const plane[4], Block* block, size_t at) {
  const DF d;
  VF r = hn::LoadU(d, plane[0]), g = hn::LoadU(d, plane[1]), b = hn::LoadU(d, plane[2]), a = hn::LoadU(d, plane[3]);
  Unpremultiply(r, g, b, a);
  hn::Store(r, d, block->r + at);
  hn::Store(g, d, block->g + at);
  hn::Store(b, d, block->b + at);
  hn::Store(a, d, block->a + at);
}

/// Loads `count` pixels to `at`; a last vector is filled with zeros.
HWY_INLINE void LoadRow(const float* const plane[4], size_t count, Block* block, size_t at) {
  const size_t lanes = hn::Lanes(DF());
  size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    const float* const from[4] = {plane[0] + i, plane[1] + i, plane[2] + i, plane[3] + i};
    LoadPixels(from, block, at + i);
  }
  if (i == count) return;
  float rest[4][hn::MaxLanes(DF())] = {};
  for (size_t c = 0; c < 4; ++c) std::memcpy(rest[c], plane[c] + i, (count - i) * sizeof(float));
  const float* const from[4] = {rest[0], rest[1], rest[2], rest[3]};
  LoadPixels(from, block, at + i);
}

HWY_INLINE void RunMatrix(const Stage& stage, Block* block, size_t count) {
  const float(&m)[3][4] = stage.matrix;
  const auto clamp = [&](VF v) HWY_ATTR { return hn::Min(hn::Max(v, Set(stage.low)), Set(stage.high)); };
  ForEach(block, count, [&](VF& r, VF& g, VF& b) HWY_ATTR {
    const VF x = r, y = g, z = b;
    r = clamp(Set(m[0][0]) * x + Set(m[0][1]) * y + Set(m[0][2]) * z + Set(m[0][3]));
    g = clamp(Set(m[1][0]) * x + Set(m[1][1]) * y + Set(m[1][2]) * z + Set(m[1][3]));
    b = clamp(Set(m[2][0]) * x + Set(m[2][1]) * y + Set(m[2][2]) * z + Set(m[2][3]));
  });
}

HWY_INLINE void RunClamp(float low, float high, Block* block, size_t count) {
  ForEach(block, count, [&](VF& r, VF& g, VF& b) HWY_ATTR {
    r = hn::Min(hn::Max(r, Set(low)), Set(high));
    g = hn::Min(hn::Max(g, Set(low)), Set(high));
    b = hn::Min(hn::Max(b, Set(low)), Set(high));
  });
}

HWY_INLINE VF Curve(const Curves& curves, int channel, VF v) {
  const DF d;
  const DI di;
  const VU offset = KeyOffset(v, curves.first, curves.last);
  const VI step = hn::BitCast(di, hn::ShiftRightSame(offset, curves.shift));
  VF left, right;
  simd::HWY_NAMESPACE::GatherPairs(d, curves.value[channel], step, &left, &right);
  const VI low = hn::And(hn::BitCast(di, offset), hn::Set(di, (1 << curves.shift) - 1));
  const VF scale = hn::BitCast(d, hn::Set(di, (127 - curves.shift) << 23));
  return left + (right - left) * (hn::ConvertTo(d, low) * scale);
}

HWY_INLINE void RunCurves(const Curves& curves, Block* block, size_t count) {
  ForEach(block, count, [&](VF& r, VF& g, VF& b) HWY_ATTR {
    r = Curve(curves, 0, r);
    g = Curve(curves, 1, g);
    b = Curve(curves, 2, b);
  });
}

/// Saturation as the modules of ACES 1.0 measure it: dark noise counts as grey.
HWY_INLINE VF Saturation(VF r, VF g, VF b) {
  const VF least = Set(1e-10f);
  const VF low = hn::Min(r, hn::Min(g, b)), high = hn::Max(r, hn::Max(g, b));
  return (hn::Max(high, least) - hn::Max(low, least)) / hn::Max(high, Set(1e-2f));
}

/// Glow module of the ACES 1.0 reference rendering transform: gain 0.05, mid 0.08.
HWY_INLINE void RunGlow(Block* block, size_t count) {
  ForEach(block, count, [&](VF& r, VF& g, VF& b) HWY_ATTR {
    const DF d;
    const VF one = Set(1.0f), half = Set(0.5f);
    const VF squares = b * (b - g) + g * (g - r) + r * (r - b);
    const VF chroma = hn::Sqrt(hn::Max(squares, hn::Zero(d)));
    const VF yc = (b + g + r + Set(1.75f) * chroma) * Set(1.0f / 3.0f);
    const auto is_bright = hn::Ge(yc, Set(0.16f));
    if (hn::AllTrue(d, is_bright)) return;
    const VF x = (Saturation(r, g, b) - Set(0.4f)) * Set(5.0f);
    const VF t = hn::Max(one - half * hn::Abs(x), hn::Zero(d));
    const VF gain = Set(0.05f) * half * (one + hn::CopySign(one - t * t, x));
    const VF divisor = hn::Max(yc, Set(0.05f));
    VF glow = hn::IfThenElse(hn::Le(yc, Set(0.16f / 3.0f)), gain, gain * (Set(0.08f) / divisor - half));
    glow = hn::IfThenZeroElse(is_bright, glow) + one;
    r = r * glow, g = g * glow, b = b * glow;
  });
}

/// Red modifier of the ACES 1.0 reference rendering transform: scale 0.82, pivot 0.03. The table holds the weight of
/// hue over y / (x + |y|), where x and y are the hue's cosine and sine times chroma.
HWY_INLINE void RunRedModifier(const float* weights, Block* block, size_t count) {
  ForEach(block, count, [&](VF& r, VF& g, VF& b) HWY_ATTR {
    const DF d;
    const DI di;
    const VF x = Set(2.0f) * r - (g + b);
    const VF y = Set(1.73205081f) * (g - b);
    // Weights are 0 from 67.5 degrees on, whose tangent is 2.41.
    const auto reddish = hn::Gt(Set(2.5f) * x, hn::Abs(y));
    if (hn::AllFalse(d, reddish)) return;
    const VF divisor = hn::IfThenElse(reddish, x + hn::Abs(y), Set(1.0f));
    const VF ratio = hn::IfThenElseZero(reddish, y / divisor);
    const VF at = ratio * Set(kHueSteps / 2.0f) + Set(kHueSteps / 2.0f);
    const VI step = hn::Min(hn::ConvertTo(di, at), hn::Set(di, kHueSteps - 1));
    VF left, right;
    simd::HWY_NAMESPACE::GatherPairs(d, weights, step, &left, &right);
    const VF weight = left + (right - left) * (at - hn::ConvertTo(d, step));
    const VF change = weight * Saturation(r, g, b) * (Set(0.03f) - r) * Set(0.18f);
    r = r + hn::IfThenElseZero(reddish, change);
  });
}

HWY_INLINE void RunSurround(const Stage& stage, Block* block, size_t count) {
  ForEach(block, count, [&](VF& r, VF& g, VF& b) HWY_ATTR {
    const VF sum = Set(stage.luminance[0]) * r + Set(stage.luminance[1]) * g + Set(stage.luminance[2]) * b;
    const VF gain = Curve(stage.curves, 0, hn::Max(sum, Set(stage.floor)));
    r = r * gain, g = g * gain, b = b * gain;
  });
}

/// Coordinate in nodes, clamped to the lattice.
HWY_INLINE VF Coordinate(const Lattice& lattice, VF v) {
  const VF inside = hn::Min(hn::Max(v, hn::Zero(DF())), Set(1.0f));
  return inside * Set(static_cast<float>(lattice.nodes - 1));
}

/// A point of a lattice: the lowest node of its cell as an index of floats, and the position in the cell.
struct Cell {
  VI node;
  VF r, g, b;
};

HWY_INLINE Cell FindCell(const Lattice& lattice, VF r, VF g, VF b) {
  const DF d;
  const DI di;
  const VI nodes = hn::Set(di, lattice.nodes), last = hn::Set(di, lattice.nodes - 2);
  r = Coordinate(lattice, r), g = Coordinate(lattice, g), b = Coordinate(lattice, b);
  const VI x = hn::Min(hn::ConvertTo(di, r), last), y = hn::Min(hn::ConvertTo(di, g), last);
  const VI z = hn::Min(hn::ConvertTo(di, b), last);
  const VI index = (x * nodes + y) * nodes + z;
  return {hn::ShiftLeft<2>(index), r - hn::ConvertTo(d, x), g - hn::ConvertTo(d, y), b - hn::ConvertTo(d, z)};
}

/// Adds weight times the colour of a node.
HWY_INLINE void AddNode(const float* nodes, VI node, VF weight, VF (&sum)[3]) {
  const DF d;
  const DI di;
  VF red, green;
  simd::HWY_NAMESPACE::GatherPairs(d, nodes, node, &red, &green);
  const VF blue = hn::GatherIndex(d, nodes, node + hn::Set(di, 2));
  sum[0] = sum[0] + weight * red;
  sum[1] = sum[1] + weight * green;
  sum[2] = sum[2] + weight * blue;
}

/// Tetrahedral interpolation: Sakamoto and Itooka, US patent 4275413 (1981).
HWY_INLINE void Tetrahedral(const Lattice& lattice, const Cell& cell, VF (&sum)[3]) {
  const DI di;
  const VF high = hn::Max(cell.r, hn::Max(cell.g, cell.b)), low = hn::Min(cell.r, hn::Min(cell.g, cell.b));
  const VF middle = hn::Max(hn::Min(cell.r, cell.g), hn::Min(hn::Max(cell.r, cell.g), cell.b));
  const auto rg = hn::RebindMask(di, hn::Ge(cell.r, cell.g)), gb = hn::RebindMask(di, hn::Ge(cell.g, cell.b));
  const auto rb = hn::RebindMask(di, hn::Ge(cell.r, cell.b));
  const VI r = hn::Set(di, 4 * lattice.nodes * lattice.nodes), g = hn::Set(di, 4 * lattice.nodes);
  const VI b = hn::Set(di, 4);
  const VI first = hn::IfThenElse(hn::And(rg, rb), r, hn::IfThenElse(hn::AndNot(rg, gb), g, b));
  const VI last = hn::IfThenElse(hn::And(gb, rb), b, hn::IfThenElse(hn::Or(rg, rb), g, r));
  AddNode(lattice.node, cell.node, Set(1.0f) - high, sum);
  AddNode(lattice.node, cell.node + first, high - middle, sum);
  AddNode(lattice.node, cell.node + (r + g + b - last), middle - low, sum);
  AddNode(lattice.node, cell.node + (r + g + b), low, sum);
}

HWY_INLINE void Trilinear(const Lattice& lattice, const Cell& cell, VF (&sum)[3]) {
  const DI di;
  const VF one = Set(1.0f);
  for (int corner = 0; corner < 8; ++corner) {
    const bool r = corner & 4, g = corner & 2, b = corner & 1;
    const int step = ((r * lattice.nodes + g) * lattice.nodes + b) * 4;
    const VF weight = (r ? cell.r : one - cell.r) * (g ? cell.g : one - cell.g) * (b ? cell.b : one - cell.b);
    AddNode(lattice.node, cell.node + hn::Set(di, step), weight, sum);
  }
}

HWY_INLINE void RunLattice(const Lattice& lattice, Block* block, size_t count) {
  ForEach(block, count, [&](VF& r, VF& g, VF& b) HWY_ATTR {
    const Cell cell = FindCell(lattice, r, g, b);
    VF sum[3] = {hn::Zero(DF()), hn::Zero(DF()), hn::Zero(DF())};
    if (lattice.tetrahedral) {
      Tetrahedral(lattice, cell, sum);
    } else {
      Trilinear(lattice, cell, sum);
    }
    r = sum[0], g = sum[1], b = sum[2];
  });
}

HWY_INLINE void RunStage(const Stage& stage, Block* block, size_t count) {
  switch (stage.kind) {
    case StageKind::kMatrix: return RunMatrix(stage, block, count);
    case StageKind::kClamp: return RunClamp(stage.low, stage.high, block, count);
    case StageKind::kCurves: return RunCurves(stage.curves, block, count);
    case StageKind::kGlow: return RunGlow(block, count);
    case StageKind::kRedModifier: return RunRedModifier(stage.hue_weight, block, count);
    case StageKind::kSurround: return RunSurround(stage, block, count);
    case StageKind::kLattice: return RunLattice(stage.lattice, block, count);
  }
}

HWY_INLINE VU Code(const Codes& codes, int channel, VF v) {
  const DI di;
  const DU du;
  const VU offset = KeyOffset(v, codes.first, codes.last);
  const VI step = hn::BitCast(di, hn::ShiftRightSame(offset, codes.shift));
  const VU word = hn::GatherIndex(du, codes.word[channel], step);
  const VI low = hn::And(hn::BitCast(di, offset), hn::Set(di, (1 << codes.shift) - 1));
  const auto reached = hn::Not(hn::Lt(low, hn::BitCast(di, hn::ShiftRight<16>(word))));
  const VU code = hn::IfThenElse(hn::RebindMask(du, reached), hn::ShiftRight<8>(word), word);
  return hn::And(code, hn::Set(du, 0xffu));
}

/// One vector of straight colour and clean alpha as RGBA8.
HWY_INLINE VU Pixels(const Codes& codes, VF r, VF g, VF b, VF a) {
  const DF d;
  const DU du;
  const VU alpha = image::HWY_NAMESPACE::UnormCode<8>(a);
  const VU pixels = hn::Or(hn::Or(Code(codes, 0, r), hn::ShiftLeft<8>(Code(codes, 1, g))),
                           hn::Or(hn::ShiftLeft<16>(Code(codes, 2, b)), hn::ShiftLeft<24>(alpha)));
  return hn::IfThenElseZero(hn::RebindMask(du, hn::Gt(a, hn::Zero(d))), pixels);
}

/// Stores `count` pixels from `at` on.
HWY_INLINE void StoreRow(const Codes& codes, const Block& block, size_t at, size_t count, unsigned char* out) {
  const DF d;
  const size_t lanes = hn::Lanes(d);
  for (size_t i = 0; i < count; i += lanes) {
    const VU pixels = Pixels(codes, hn::Load(d, block.r + at + i), hn::Load(d, block.g + at + i),
                             hn::Load(d, block.b + at + i), hn::Load(d, block.a + at + i));
    alignas(64) uint32_t words[hn::MaxLanes(DU())];
    hn::Store(pixels, DU(), words);
    if (i + lanes <= count) {
      std::memcpy(out + 4 * i, words, 4 * lanes);
    } else {
      std::memcpy(out + 4 * i, words, 4 * (count - i));
    }
  }
}

const float* PixelAt(const Rectangle& pixels, size_t channel, size_t row, size_t column) {
  const auto* bytes = reinterpret_cast<const unsigned char*>(pixels.plane[channel]);
  return reinterpret_cast<const float*>(bytes + row * pixels.row_stride[channel]) + column;
}

/// Rows of at most kBlock pixels, as many as fill a block.
void ShowBlock(const Program& program, const Rectangle& pixels, size_t row, size_t rows, size_t column, size_t width,
               size_t pitch) {
  Block block;
  for (size_t y = 0; y < rows; ++y) {
    const float* plane[4];
    for (size_t c = 0; c < 4; ++c) plane[c] = PixelAt(pixels, c, row + y, column);
    LoadRow(plane, width, &block, y * pitch);
  }
  for (const Stage& stage : program.stages) RunStage(stage, &block, rows * pitch);
  for (size_t y = 0; y < rows; ++y) {
    StoreRow(program.codes, block, y * pitch, width, pixels.out + (row + y) * pixels.out_stride + 4 * column);
  }
}

void Show(const Program& program, const Rectangle& pixels) {
  const size_t lanes = hn::Lanes(DF());
  for (size_t column = 0; column < pixels.width; column += kBlock) {
    const size_t width = HWY_MIN(kBlock, pixels.width - column);
    const size_t pitch = (width + lanes - 1) / lanes * lanes, most = kBlock / pitch;
    for (size_t row = 0; row < pixels.height; row += most) {
      ShowBlock(program, pixels, row, HWY_MIN(most, pixels.height - row), column, width, pitch);
    }
  }
}

}  // namespace shd::color::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::color {
namespace {
HWY_EXPORT(Show);
}  // namespace

void show(const core::SimdTarget& simd, const Program& program, const Rectangle& pixels) {
  SHD_DISPATCH(Show, simd)(program, pixels);
}

}  // namespace shd::color
#endif
