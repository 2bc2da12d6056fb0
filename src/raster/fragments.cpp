// SPDX-License-Identifier: MIT
#include "raster/fragments.h"

#include <cstring>

namespace shd::raster {
namespace {

/// Every column of the table, once: what allocation needs to know.
template <class Visit>
void visit_columns(Fragments& f, Visit visit) {
  for (uint32_t** column : {&f.pixel, &f.mask, &f.triangle, &f.vertex[0], &f.vertex[1], &f.vertex[2]}) {
    visit(reinterpret_cast<void**>(column));
  }
  for (float** column :
       {&f.x,  &f.y,  &f.depth, &f.bary[0], &f.bary[1], &f.bary[2], &f.px,   &f.py,   &f.pz,   &f.nx,  &f.ny,
        &f.nz, &f.ox, &f.oy,    &f.oz,      &f.u,       &f.v,       &f.dudx, &f.dvdx, &f.dudy, &f.dvdy}) {
    visit(reinterpret_cast<void**>(column));
  }
}

/// The samples of a pixel that show what its sample k shows; 0 where an earlier one shows it too.
uint32_t samples_like(const Tile& tile, size_t pixel, uint32_t k) {
  const uint32_t slot = tile.slot[pixel * tile.samples + k];
  uint32_t mask = 0;
  for (uint32_t j = 0; j < tile.samples; ++j) {
    if (tile.slot[pixel * tile.samples + j] != slot) continue;
    if (j < k) return 0;
    mask |= 1u << j;
  }
  return mask;
}

/// Whether all of an even number of samples of a pixel show the same.
bool is_uniform(const Tile& tile, size_t pixel) {
  const uint32_t* slots = tile.slot.data() + pixel * tile.samples;
  const uint64_t both = uint64_t{slots[0]} << 32 | slots[0];
  uint64_t different = 0;
  for (uint32_t k = 0; k < tile.samples; k += 2) {
    uint64_t two;
    std::memcpy(&two, slots + k, sizeof two);
    different |= two ^ both;
  }
  return different == 0;
}

/// Cuts the covered pixels of a tile with one sample a pixel into runs.
void find_single_runs(const Tile& tile, core::Buffer<PixelRun>* runs) {
  const uint32_t* slots = tile.slot.data();
  runs->clear();
  for (size_t begin = 0; begin < kTilePixels;) {
    const uint32_t slot = slots[begin];
    size_t end = begin + 1;
    while (end < kTilePixels && slots[end] == slot) ++end;
    if (slot != kNoSlot) runs->push_back({slot, static_cast<uint16_t>(begin), static_cast<uint16_t>(end), 1});
    begin = end;
  }
}

/// The same with several.
void find_runs(const Tile& tile, core::Buffer<PixelRun>* runs) {
  const uint32_t all = (1u << tile.samples) - 1;
  runs->clear();
  for (size_t begin = 0; begin < kTilePixels;) {
    if (!is_uniform(tile, begin)) {
      for (uint32_t k = 0; k < tile.samples; ++k) {
        const uint32_t slot = tile.slot[begin * tile.samples + k];
        const uint32_t mask = slot == kNoSlot ? 0 : samples_like(tile, begin, k);
        if (mask) runs->push_back({slot, static_cast<uint16_t>(begin), static_cast<uint16_t>(begin + 1), mask});
      }
      ++begin;
      continue;
    }
    const uint32_t slot = tile.slot[begin * tile.samples];
    size_t end = begin + 1;
    while (end < kTilePixels && tile.slot[end * tile.samples] == slot && is_uniform(tile, end)) ++end;
    if (slot != kNoSlot) runs->push_back({slot, static_cast<uint16_t>(begin), static_cast<uint16_t>(end), all});
    begin = end;
  }
}

}  // namespace

void allocate(const core::Allocator& allocator, Fragments* out) {
  size_t columns = 0;
  visit_columns(*out, [&](void**) { ++columns; });
  out->block = core::Array<float>(allocator, columns * kBatch);
  out->block.fill_zero();
  float* next = out->block.data();
  visit_columns(*out, [&](void** column) {
    *column = next;
    next += kBatch;
  });
  out->count = 0;
}

void sort_pixels(const Tile& tile, size_t slot_count, TileOrder* out) {
  out->start.resize(slot_count + 1);
  for (size_t slot = 0; slot <= slot_count; ++slot) out->start[slot] = 0;
  (tile.samples == 1 ? find_single_runs : find_runs)(tile, &out->run);
  for (size_t i = 0; i < out->run.size(); ++i) {
    out->start[out->run[i].slot] += uint32_t{out->run[i].end} - out->run[i].begin;
  }
  uint32_t total = 0;
  for (size_t slot = 0; slot <= slot_count; ++slot) {
    const uint32_t count = out->start[slot];
    out->start[slot] = total;
    total += count;
  }
  out->pixel.resize(total);
  // Each cell runs to the start of the next slot while pixels are placed, and is set back afterwards.
  for (size_t i = 0; i < out->run.size(); ++i) {
    const PixelRun& run = out->run[i];
    VisiblePixel* pixel = out->pixel.data() + out->start[run.slot];
    out->start[run.slot] += uint32_t{run.end} - run.begin;
    for (uint32_t p = run.begin; p < run.end; ++p) {
      *pixel++ = {static_cast<uint16_t>(p), static_cast<uint16_t>(run.mask)};
    }
  }
  for (size_t slot = slot_count; slot > 0; --slot) out->start[slot] = out->start[slot - 1];
  out->start[0] = 0;
}

}  // namespace shd::raster
