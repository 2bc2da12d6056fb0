// SPDX-License-Identifier: MIT
#include "raster/fragments.h"

#include "raster/changes.h"

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

/// A run for each triangle that a pixel shows.
void add_mixed_pixel(const Tile& tile, size_t pixel, core::Buffer<PixelRun>* runs) {
  const uint32_t* slots = tile.slot.data() + pixel * tile.samples;
  const auto begin = static_cast<uint16_t>(pixel), end = static_cast<uint16_t>(pixel + 1);
  for (uint32_t rest = (1u << tile.samples) - 1; rest;) {
    const uint32_t slot = slots[__builtin_ctz(rest)];
    uint32_t mask = 0;
    for (uint32_t k = 0; k < tile.samples; ++k) mask |= static_cast<uint32_t>(slots[k] == slot) << k;
    if (slot != kNoSlot) runs->push_back({slot, begin, end, mask});
    rest &= ~mask;
  }
}

/// The first set bit from `from` on, or `count`.
size_t next_bit(const uint64_t* bits, size_t from, size_t count) {
  if (from >= count) return count;
  uint64_t word = bits[from / 64] >> (from % 64) << (from % 64);
  for (size_t i = from / 64;; word = bits[i]) {
    if (word) return 64 * i + static_cast<size_t>(__builtin_ctzll(word));
    if (64 * ++i >= count) return count;
  }
}

/// Cuts the covered pixels of a tile into runs.
/// @param changes  where slots are not the slot before
void find_runs(const Tile& tile, const uint64_t* changes, core::Buffer<PixelRun>* runs) {
  const uint32_t samples = tile.samples, all = (1u << samples) - 1;
  runs->clear();
  for (size_t begin = 0; begin < kTilePixels;) {
    const uint32_t slot = tile.slot[begin * samples];
    const size_t end = next_bit(changes, begin * samples + 1, kTilePixels * samples) / samples;
    if (end > begin) {
      if (slot != kNoSlot) runs->push_back({slot, static_cast<uint16_t>(begin), static_cast<uint16_t>(end), all});
      begin = end;
      continue;
    }
    add_mixed_pixel(tile, begin, runs);
    ++begin;
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

void allocate(const core::Allocator& allocator, uint32_t samples, TileOrder* out) {
  out->changes = core::Array<uint64_t>(allocator, kTilePixels * samples / 64);
  out->run.attach(allocator);
  out->start.attach(allocator);
  out->pixel.attach(allocator);
}

void sort_pixels(const core::SimdTarget& simd, const Tile& tile, size_t slot_count, TileOrder* out) {
  out->start.resize(slot_count + 1);
  for (size_t slot = 0; slot <= slot_count; ++slot) out->start[slot] = 0;
  find_changes(simd, tile.slot.data(), tile.slot.size(), out->changes.data());
  find_runs(tile, out->changes.data(), &out->run);
  out->covered_samples = 0;
  for (size_t i = 0; i < out->run.size(); ++i) {
    const PixelRun& run = out->run[i];
    const uint32_t pixels = uint32_t{run.end} - run.begin;
    out->start[run.slot] += pixels;
    out->covered_samples += tile.samples == 1 ? pixels : pixels * static_cast<uint32_t>(__builtin_popcount(run.mask));
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
