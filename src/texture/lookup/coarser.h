// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "texture/lookup/gathered.h"
#include "texture/texture.h"

namespace shd::texture {

/// Returns a sampler that reads no level finer than `level`.
Sampler sampler_from_level(const Sampler& sampler, uint32_t level);

/// Returns the lookups whose `needed` is `level`, in `rows`.
size_t rows_of_level(const uint8_t* needed, size_t count, uint32_t level, uint16_t* rows);

/// Sets the outputs of lookups that found no level, and the column `coarser`.
void finish_coarser(const Texture& texture, const uint8_t* needed, size_t count, const Texels& out);

/// Filters from the finest levels whose tiles are resident. filter(sampler, in, out, needed) filters a batch with zeros
/// for texels that are not resident, sets `needed` of the lookups that read such texels to the level after theirs, and
/// returns the number of lookups that are not finite. Returns this number.
template <class Filter>
size_t sample_coarser(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out,
                      const Filter& filter) {
  size_t nonfinite = 0;
  for (size_t first = 0; first < in.count; first += kPart) {
    const Lookups block = part_of(in, first, std::min(kPart, in.count - first));
    const Texels to = part_of(out, first);
    uint8_t needed[kPart] = {};
    nonfinite += filter(sampler, block, to, needed);
    for (uint32_t level = 1; level < texture.level_count; ++level) {
      uint16_t rows[kPart];
      const size_t count = rows_of_level(needed, block.count, level, rows);
      if (count == 0) continue;
      Gathered gathered;
      uint8_t again[kPart] = {};
      filter(sampler_from_level(sampler, level), gathered.load(block, rows, count), gathered.wanted(to), again);
      gathered.scatter(rows, count, to);
      for (size_t i = 0; i < count; ++i) needed[rows[i]] = std::max(needed[rows[i]], again[i]);
    }
    finish_coarser(texture, needed, block.count, to);
  }
  return nonfinite;
}

}  // namespace shd::texture
