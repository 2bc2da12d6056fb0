// SPDX-License-Identifier: MIT
#include "raster/fragments.h"

#include "raster/tile_words.h"

namespace shd::raster {
namespace {

/// Visits every column of the table once, for allocation.
template <class Visit>
void visit_columns(Fragments& f, Visit visit) {
  for (uint32_t** column : {&f.pixel, &f.mask, &f.triangle}) {
    visit(reinterpret_cast<void**>(column));
  }
  for (float** column :
       {&f.x,  &f.y,     &f.depth, &f.bary[0], &f.bary[1], &f.bary[2], &f.px,   &f.py,   &f.pz,   &f.nx,   &f.ny,
        &f.nz, &f.ox,    &f.oy,    &f.oz,      &f.u,       &f.v,       &f.dudx, &f.dvdx, &f.dudy, &f.dvdy, &f.u1,
        &f.v1, &f.du1dx, &f.dv1dx, &f.du1dy,   &f.dv1dy,   &f.tx,      &f.ty,   &f.tz,   &f.tw}) {
    visit(reinterpret_cast<void**>(column));
  }
  for (float*& column : f.dpdx) visit(reinterpret_cast<void**>(&column));
  for (float*& column : f.dpdy) visit(reinterpret_cast<void**>(&column));
  for (float*& column : f.attribute) visit(reinterpret_cast<void**>(&column));
}

/// Adds a run for each triangle visible in a pixel. Returns the number of samples without a triangle.
template <uint32_t kSamples>
size_t add_mixed_pixel(const Tile& tile, size_t pixel, core::Buffer<SlotRun>* runs) {
  const uint32_t* slots = tile.slot.data() + pixel * kSamples;
  const auto begin = static_cast<uint16_t>(pixel), end = static_cast<uint16_t>(pixel + 1);
  size_t bare = 0;
  for (uint32_t rest = (1u << kSamples) - 1; rest;) {
    const uint32_t slot = slots[__builtin_ctz(rest)];
    uint32_t mask = 0;
    for (uint32_t k = 0; k < kSamples; ++k) mask |= static_cast<uint32_t>(slots[k] == slot) << k;
    if (slot != kNoSlot) {
      runs->push_back({slot, {begin, end, mask}});
    } else {
      bare = static_cast<size_t>(__builtin_popcount(mask));
    }
    rest &= ~mask;
  }
  return bare;
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

/// Divides the covered pixels of a tile into runs. Returns the number of samples without a triangle.
template <uint32_t kSamples>
size_t find_runs(const Tile& tile, TileOrder* out) {
  const uint64_t* changes = out->changes.data();
  core::Buffer<SlotRun>* runs = &out->found;
  constexpr uint32_t kAll = (1u << kSamples) - 1;
  size_t bare = 0;
  for (size_t begin = 0; begin < kTilePixels;) {
    const uint32_t slot = tile.slot[begin * kSamples];
    const size_t end = next_bit(changes, begin * kSamples + 1, kTilePixels * kSamples) / kSamples;
    if (end == begin) {
      const size_t bare_samples = add_mixed_pixel<kSamples>(tile, begin, runs);
      if (bare_samples) out->bare.push_back({static_cast<uint16_t>(begin), static_cast<uint16_t>(begin + 1), kAll});
      bare += bare_samples;
      ++begin;
      continue;
    }
    const PixelRun run = {static_cast<uint16_t>(begin), static_cast<uint16_t>(end), kAll};
    if (slot == kNoSlot) {
      bare += (end - begin) * kSamples;
      out->bare.push_back(run);
    } else {
      runs->push_back({slot, run});
    }
    begin = end;
  }
  return bare;
}

size_t find_runs(const Tile& tile, TileOrder* out) {
  switch (tile.samples) {
    case 1: return find_runs<1>(tile, out);
    case 2: return find_runs<2>(tile, out);
    case 4: return find_runs<4>(tile, out);
    case 8: return find_runs<8>(tile, out);
    default: return find_runs<16>(tile, out);
  }
}

}  // namespace

void allocate(const core::Allocator& allocator, Fragments* out) {
  size_t columns = 0;
  visit_columns(*out, [&](void**) { ++columns; });
  out->block = core::Array<float>(allocator, columns * kColumn);
  out->block.fill_zero();
  float* next = out->block.data();
  visit_columns(*out, [&](void** column) {
    *column = next;
    next += kColumn;
  });
  out->count = 0;
}

void allocate(const core::Allocator& allocator, uint32_t samples, TileOrder* out) {
  out->changes = core::Array<uint64_t>(allocator, kTilePixels * samples / 64);
  out->found.attach(allocator);
  out->start.attach(allocator);
  out->run.attach(allocator);
  out->bare.attach(allocator);
}

void sort_pixels(const core::SimdTarget& simd, const Tile& tile, size_t slot_count, TileOrder* out) {
  out->start.resize(slot_count + 1);
  for (size_t slot = 0; slot <= slot_count; ++slot) out->start[slot] = 0;
  out->found.clear();
  out->bare.clear();
  if (tile.sole_slot != kNoSlot) {
    out->found.push_back({tile.sole_slot, {0, kTilePixels, (1u << tile.samples) - 1}});
    out->covered_samples = tile.slot.size();
  } else {
    find_changes(simd, tile.slot.data(), tile.slot.size(), out->changes.data());
    out->covered_samples = tile.slot.size() - find_runs(tile, out);
  }
  for (size_t i = 0; i < out->found.size(); ++i) ++out->start[out->found[i].slot];
  uint32_t total = 0;
  for (size_t slot = 0; slot <= slot_count; ++slot) {
    const uint32_t count = out->start[slot];
    out->start[slot] = total;
    total += count;
  }
  out->run.resize(total);
  // While runs are placed, each start advances to the start of the next slot; the loop after it restores the starts.
  for (size_t i = 0; i < out->found.size(); ++i) out->run[out->start[out->found[i].slot]++] = out->found[i].run;
  for (size_t slot = slot_count; slot > 0; --slot) out->start[slot] = out->start[slot - 1];
  out->start[0] = 0;
}

}  // namespace shd::raster
