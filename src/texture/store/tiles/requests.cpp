// SPDX-License-Identifier: MIT
#include "texture/store/tiles/requests.h"

namespace shd::texture {

void TileRequests::attach(TileRequest* places, uint32_t capacity) {
  places_ = places;
  mask_ = capacity - 1;
}

TileRequest& TileRequests::place_of(TileKey key) {
  return places_[static_cast<uint32_t>(key * 0x9e3779b97f4a7c15u >> 32) & mask_];
}

void TileRequests::clear(TileRequest* place) {
  if (place->key != 0) --size_;
  *place = {};
}

void TileRequests::add(TileKey key) {
  TileRequest& place = place_of(key);
  if (place.key == 0) ++size_;
  place = {key, ++turn_};
}

void TileRequests::remove(TileKey key) {
  TileRequest& place = place_of(key);
  if (place.key == key) clear(&place);
}

void TileRequests::remove_texture(uint32_t number) {
  for (uint32_t i = 0; i <= mask_; ++i) {
    if (places_[i].key >> 32 == number) clear(&places_[i]);
  }
}

TileKey TileRequests::take_latest(uint32_t number) {
  TileRequest* latest = nullptr;
  for (uint32_t i = 0; i <= mask_ && size_ > 0; ++i) {
    TileRequest& place = places_[i];
    if (place.key == 0 || (number != 0 && place.key >> 32 != number)) continue;
    if (!latest || place.turn > latest->turn) latest = &place;
  }
  if (!latest) return 0;
  const TileKey key = latest->key;
  clear(latest);
  return key;
}

}  // namespace shd::texture
