// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "texture/store/tiles/tile.h"

namespace shd::texture {

/// A tile that a lookup did not find.
struct TileRequest {
  TileKey key;    // 0 = none
  uint64_t turn;  // number of the latest request
};

/// The latest requests. A request has one place; another one at this place replaces it. Guarded by the cache.
class TileRequests {
 public:
  /// `places` are zero and outlive the requests; `capacity` is a power of two.
  void attach(TileRequest* places, uint32_t capacity);

  void add(TileKey key);
  void remove(TileKey key);
  /// Removes the requests of a texture.
  void remove_texture(uint32_t number);
  /// Removes the latest request of a texture, 0 = of any, and returns its key; 0 if there is none.
  TileKey take_latest(uint32_t number);
  uint32_t size() const { return size_; }

 private:
  TileRequest& place_of(TileKey key);
  void clear(TileRequest* place);

  TileRequest* places_ = nullptr;
  uint32_t mask_ = 0;
  uint32_t size_ = 0;
  uint64_t turn_ = 0;
};

}  // namespace shd::texture
