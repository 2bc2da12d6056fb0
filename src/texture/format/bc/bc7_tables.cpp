// SPDX-License-Identifier: MIT
#include "texture/format/bc/bc7_tables.h"

namespace shd::texture::bc7 {
namespace {

/// Sets the window of a field at a position [bits], whose highest bit is moved to bit `to` of a lane.
constexpr void set_window(uint32_t position, uint32_t size, uint32_t to, uint8_t* window, uint16_t* factor) {
  window[0] = static_cast<uint8_t>(position / 8);
  window[1] = static_cast<uint8_t>(position / 8 + 1);
  *factor = static_cast<uint16_t>(1u << (to + 1 - size - position % 8));
}

/// Returns the first row of a mode in kAnchors.
constexpr uint32_t anchor_row_of(uint32_t mode) {
  return mode == 0 ? 192 : mode < 4 ? 64 * (mode - 1) : mode == 7 ? 128 : 208;
}

constexpr void set_endpoints(const Mode& m, uint32_t start, ModeTable* out) {
  const uint32_t count = 2 * m.subsets, alpha = start + 3 * count * m.color, p = alpha + count * m.alpha;
  for (uint32_t lane = 0; lane < kEnds; ++lane) {
    const uint32_t subset = lane % 16 / 4, c = lane % 4, k = 2 * subset + lane / 16, n = c < 3 ? m.color : m.alpha;
    if (subset >= m.subsets || n == 0) continue;
    set_window(c < 3 ? start + (c * count + k) * n : alpha + k * n, n, 15, &out->window[2 * lane], &out->factor[lane]);
    if (!m.endpoint_p && !m.shared_p) continue;
    set_window(p + (m.shared_p ? subset : k), 1, 15 - n, &out->p_window[2 * lane], &out->p_factor[lane]);
  }
}

constexpr ModeTable table_of(uint32_t mode) {
  ModeTable out = {};
  const Mode& m = kModes[mode];
  const uint32_t start = mode + 1 + m.partition + m.rotation + m.selection, p = m.endpoint_p | m.shared_p;
  set_endpoints(m, start, &out);
  for (uint32_t lane = 0; lane < 8; ++lane) {
    const uint32_t n = lane % 4 < 3 ? m.color : m.alpha;
    out.fill[lane] = n == 0 ? 255 : 0;
    if (n == 0) continue;
    out.keep[lane] = static_cast<uint16_t>(0xffff << (16 - n));
    out.p_keep[lane] = static_cast<uint16_t>(p << (15 - n));
    out.repeat[lane] = static_cast<uint16_t>(1u << (16 - n - p));
  }
  out.partition_shift = mode + 1;
  out.partition_mask = (1u << m.partition) - 1;
  out.subsets = m.subsets == 1 ? 128 : 64 * (m.subsets - 2);
  out.anchors = anchor_row_of(mode);
  out.bits = m.index;
  const uint32_t count = 2 * m.subsets, p_bits = m.endpoint_p ? count : m.shared_p ? m.subsets : 0;
  const uint32_t end = start + count * (3 * m.color + m.alpha) + p_bits;
  out.separate = m.second_index > 0;
  out.index_shift = out.separate ? end : end - 64;
  return out;
}

constexpr ModeTable reserved() {
  ModeTable out = {};
  out.subsets = 128;
  out.anchors = anchor_row_of(6);
  out.bits = 4;
  return out;
}

constexpr ModeTables make_modes() {
  ModeTables out = {};
  for (uint32_t mode = 0; mode < 8; ++mode) out.mode[mode] = table_of(mode);
  out.mode[8] = reserved();
  return out;
}

constexpr Subsets make_subsets() {
  Subsets out = {};
  for (uint32_t partition = 0; partition < 64; ++partition) {
    for (uint32_t i = 0; i < 16; ++i) {
      out.row[partition].texel[i] = static_cast<uint8_t>(4 * (kTwoSubsets[partition] >> (2 * i) & 3));
      out.row[64 + partition].texel[i] = static_cast<uint8_t>(4 * (kThreeSubsets[partition] >> (2 * i) & 3));
    }
  }
  return out;
}

constexpr Anchors make_anchors() {
  Anchors out = {};
  for (AnchorRow& row : out.row) row = {63, 63};
  for (uint32_t mode = 0; mode < 4; ++mode) {  // mode 7 has the rows of mode 3
    const Mode& m = kModes[mode];
    for (uint32_t partition = 0; partition < 1u << m.partition; ++partition) {
      const uint32_t a = m.subsets == 2 ? kAnchorOfTwo[partition] : kAnchorsOfThree[0][partition];
      const uint32_t b = m.subsets == 2 ? a : kAnchorsOfThree[1][partition];
      AnchorRow& row = out.row[anchor_row_of(mode) + partition];
      row.second = static_cast<uint8_t>(m.index * (a < b ? a : b) + m.index - 2);
      if (m.subsets == 3) row.last = static_cast<uint8_t>(m.index * (a < b ? b : a) + m.index - 3);
    }
  }
  return out;
}

constexpr IndexTables make_indices() {
  IndexTables out = {};
  for (uint32_t bits = 2; bits <= 4; ++bits) {
    IndexTable& table = out.of_bits[bits - 2];
    for (uint32_t i = 0; i < 16; ++i) {
      set_window(bits * i, bits, 15, &table.window[2 * i], &table.factor[i]);
      table.weight[i] = kWeights[bits - 2][i >> (4 - bits)];
    }
  }
  return out;
}

}  // namespace

constexpr ModeTables kModeTables = make_modes();
constexpr Subsets kSubsets = make_subsets();
constexpr Anchors kAnchors = make_anchors();
constexpr IndexTables kIndexTables = make_indices();

}  // namespace shd::texture::bc7
