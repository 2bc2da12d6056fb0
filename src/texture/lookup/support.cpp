// SPDX-License-Identifier: MIT
#include "texture/support.h"

namespace shd::texture {
namespace {

template <class... Values>
constexpr uint32_t bits(Values... values) {
  return ((1u << static_cast<uint32_t>(values)) | ... | 0u);
}

constexpr uint32_t kAny = ~0u;
constexpr const char* kFull = "the values are those of SHD_PRECISION_FULL";

/// Cells that do not work: filters x domains x stores x uses. The first row that has a cell gives the reason.
struct Refusal {
  uint32_t filters, domains, stores, uses;
  const char* reason;
};

constexpr Refusal kRefusals[] = {
    // Filters of a domain.
    {bits(SHD_FILTER_RIPMAP, SHD_FILTER_SUMMED_AREA), bits(Domain::kSlices), kAny, kAny, "its tables are 2D"},
    {bits(SHD_FILTER_RIPMAP, SHD_FILTER_SUMMED_AREA), bits(Domain::kDirections), kAny, kAny,
     "a box of its table is no box on the other side of an edge"},
    // Uses.
    {bits(SHD_FILTER_NEAREST, SHD_FILTER_NEAREST_MIP, SHD_FILTER_NEAREST_MIP_LINEAR, SHD_FILTER_STOCHASTIC), kAny, kAny,
     bits(Use::kGradients), "its values have steps"},
    {bits(SHD_FILTER_SUMMED_AREA, SHD_FILTER_EXACT), kAny, kAny, bits(Use::kGradients),
     "it is not a tree of blends with derivatives"},
    {bits(SHD_FILTER_SUMMED_AREA, SHD_FILTER_EXACT), kAny, kAny, bits(Use::kExplanation), "it is not a tree of blends"},
    {bits(SHD_FILTER_BICUBIC, SHD_FILTER_RIPMAP, SHD_FILTER_SUMMED_AREA, SHD_FILTER_EWA, SHD_FILTER_STOCHASTIC,
          SHD_FILTER_EXACT, SHD_FILTER_HERMITE),
     kAny, kAny, bits(Use::kBounds, Use::kComparison), "no standard defines the filter"},
    // Fixed point: the other cells have the values of SHD_PRECISION_FULL.
    {~bits(SHD_FILTER_BILINEAR, SHD_FILTER_BILINEAR_MIP, SHD_FILTER_TRILINEAR, SHD_FILTER_ANISOTROPIC), kAny, kAny,
     bits(Use::kFast), kFull},
    {kAny, bits(Domain::kSlices, Domain::kDirections), kAny, bits(Use::kFast), kFull},
    {kAny, kAny, ~bits(Store::kMemory, Store::kBorrowed), bits(Use::kFast), kFull},
};

}  // namespace

const char* refusal_of(const SupportCell& cell) {
  for (const Refusal& row : kRefusals) {
    if (row.filters & bits(cell.filter) && row.domains & bits(cell.domain) && row.stores & bits(cell.store) &&
        row.uses & bits(cell.use)) {
      return row.reason;
    }
  }
  return nullptr;
}

Domain domain_of(const Texture& texture) {
  if (texture.depth != 0) return Domain::kSlices;
  return texture.projection != SHD_PROJECTION_NONE ? Domain::kDirections : Domain::kPlane;
}

const char* name_of(Domain domain) {
  constexpr const char* kNames[kDomains] = {"2D", "3D", "directions"};
  return kNames[static_cast<uint32_t>(domain)];
}

const char* name_of(Store store) {
  switch (store) {
    case Store::kMemory: return "memory";
    case Store::kBorrowed: return "borrowed memory";
    case Store::kBc: return "compressed blocks";
    case Store::kTiles: return "tiles";
    case Store::kTilesOfBc: return "tiles of compressed blocks";
  }
  return "unknown";
}

const char* name_of(Use use) {
  constexpr const char* kNames[kUses] = {"values", "derivatives", "explanation", "bounds", "fixed point", "comparison"};
  return kNames[static_cast<uint32_t>(use)];
}

}  // namespace shd::texture
