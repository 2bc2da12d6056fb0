// SPDX-License-Identifier: MIT
/// @file
/// Contract of store/: where the texels of a texture lie, and what depends on it.
///
/// | file            | contents                                                                  |
/// |-----------------|---------------------------------------------------------------------------|
/// | storage.h, .cpp | levels, units and their numbers; texels in memory                         |
/// | level_count.cpp | the number of levels of a size; shd-maketx has this file, too             |
/// | span.h, rows.h  | ranges and regions of texels; a task for each of some rows                |
/// | image_list.h    | the images that a desc gives for the levels                               |
/// | memory.cpp      | textures in memory: copies of texels, borrowed texels                     |
/// | bc/             | compressed blocks in memory, and a cache of decoded blocks                |
/// | tiles/          | tiles from a callback of the host, in a cache of a fixed size             |
/// | level-inl.h     | a level in registers: addresses in memory, places for other stores        |
/// | place-inl.h     | the placements of the stores on one target                                |
/// | reader.h, .cpp  | single texels of any store, for oracles                                   |
///
/// A new store is a folder with its functions, an enumerator of Store, rows of functions_of() and store_of(), a row of
/// PlaceOf() if it places streams, its name in support.cpp, kStores in support.h, and the checks of its fields in
/// abi/texture_desc.cpp.
#pragma once

#include <cstddef>
#include <cstdint>

#include "texture/stream.h"
#include "texture/texture.h"

namespace shd::texture {

/// Memory for texels that are decoded or copied, and the unit that they are of.
struct TexelMemory {
  uint32_t unit = UINT32_MAX;
  alignas(16) uint8_t texels[16 * 8];  // a block, [4][4], or one texel
};

/// The lookups of a call: run(body, placement) filters them all.
struct CallBody {
  void (*run)(const void* body, const Placement& placement);
  const void* body;
};

/// The functions of a store.
struct StoreRow {
  /// Sets the layout, and copies or borrows the texels of a checked desc. The sizes, the format and the number of
  /// levels of `texture` are set.
  void (*fill)(const core::Context& context, const shd_texture_desc& desc, Texture* texture);

  /// Returns the first byte of texel (x, y) of a unit, as it is stored or decoded; it may be in `memory`. Loads a tile;
  /// throws Failure if that fails.
  const uint8_t* (*texel)(const Texture& texture, uint32_t unit, uint32_t x, uint32_t y, TexelMemory* memory);

  /// Copies a level of an image as it is stored, and as texels that are decoded.
  void (*read_level)(const core::Context& context, const Texture& texture, uint32_t image, uint32_t level,
                     const shd_image& out);
  void (*decode_level)(const core::Context& context, const Texture& texture, uint32_t image, uint32_t level,
                       const shd_image& out);

  /// Why texels cannot be written, as the end of "in tiles, ..."; null if they can.
  const char* no_update;

  /// Stores that place streams have the following; for others all are null.

  /// Runs a call of lookups with a placement, whose state is this call's.
  void (*call)(const Texture& texture, const CallBody& body);
  /// Begins a batch of `count` lookups. `needed`: null, or [count] the finest levels that lookups can use if texels are
  /// not at hand; then nothing waits for texels.
  void (*begin)(void* state, size_t count, uint8_t* needed);
  /// Between these two a call holds nothing that loads of texels could wait for.
  void (*pause)(void* state);
  void (*resume)(void* state);
};

/// Returns the functions of a store.
const StoreRow& functions_of(Store store);

/// Runs body(placement) as a call of lookups of a texture whose streams are placed.
template <class Body>
void call(const Texture& texture, const Body& body) {
  functions_of(texture.store)
      .call(
          texture,
          {[](const void* data, const Placement& placement) { (*static_cast<const Body*>(data))(placement); }, &body});
}

/// Returns the store of a checked desc.
Store store_of(const shd_texture_desc& desc);

extern const StoreRow kMemoryStore, kBcStore, kTileStore, kBcTileStore;

}  // namespace shd::texture
