// SPDX-License-Identifier: MIT
/// @file
/// BC7 as tables: one kernel decodes the blocks of all modes, without a branch that depends on the mode of a block.
///
/// A field of n bits, n < 9, lies within 16 bits that start at a byte. A shuffle of bytes moves these 16 bits to a
/// lane, and a product with a power of two moves the field to the top of the lane.
#pragma once

#include <cstdint>

#include "texture/format/bc/bc7.h"

namespace shd::texture::bc7 {

/// Lanes of 16 bits that hold an endpoint each: four channels of subsets 0 to 3 of the first endpoint, then of the
/// second one.
constexpr uint32_t kEnds = 32;

struct ModeTable {
  alignas(64) uint8_t window[2 * kEnds];  // bytes of the field of a lane
  uint16_t factor[kEnds];                 // moves the field to the top of its lane
  uint8_t p_window[2 * kEnds];            // bytes of the lowest bit, if it is stored apart
  uint16_t p_factor[kEnds];               // moves this bit below the field
  uint16_t keep[8], p_keep[8];            // bits of the field, and the bit below it
  uint16_t repeat[8];                     // moves the bits of a lane below themselves, in the upper half of a product
  uint16_t fill[8];                       // 255 in lanes of an alpha that the mode lacks
  uint32_t partition_shift, partition_mask;
  uint32_t subsets;      // row of kSubsets of partition 0
  uint32_t anchors;      // row of kAnchors of partition 0
  uint32_t bits;         // in an index
  uint32_t index_shift;  // position of the indices in the upper word; modes 4 and 5: position of the endpoints' end
  uint32_t separate;     // modes 4 and 5
};

/// Tables of the modes; the last one is the reserved mode, which gives zeros.
struct ModeTables {
  ModeTable mode[9];
};
extern const ModeTables kModeTables;

/// Four times the subset of each texel: 64 partitions of two subsets, 64 of three, one of one.
struct SubsetRow {
  alignas(16) uint8_t texel[16];
};
struct Subsets {
  SubsetRow row[129];
};
extern const Subsets kSubsets;

/// Positions of the bits that the indices of the last and the second anchor lack, in the stored indices. 63: none.
struct AnchorRow {
  uint8_t last, second;
};
struct Anchors {
  AnchorRow row[209];  // 64 rows of modes 1, 2, and 3 with 7; 16 rows of mode 0; one row of modes with one subset
};
extern const Anchors kAnchors;

/// Weights of 16 indices of 2, 3 or 4 bits: windows as those of endpoints, and a table of the four bits at the
/// top of a lane.
struct IndexTable {
  alignas(32) uint8_t window[32];
  uint16_t factor[16];
  uint8_t weight[16];
};
struct IndexTables {
  IndexTable of_bits[3];
};
extern const IndexTables kIndexTables;

}  // namespace shd::texture::bc7
