// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "texture/store/tiles/lease.h"

namespace shd::texture {

/// Some elements of a stream.
struct WaitingElements {
  size_t count = 0;
  uint16_t element[Stream::kMaxElements];

  void add(size_t e) { element[count++] = static_cast<uint16_t>(e); }
};

/// Places the texels of `waiting`, whose tiles are in TileCall::wanted and whose places within the tiles are in
/// Stream::index; the other elements of 0..end - 1 have their places. Loads missing tiles, or, if the call must not
/// wait, marks the lookups that need them. Texels whose tiles the lease cannot keep are copied. The call may have
/// another lease afterwards.
void resolve(TileCall* call, const WaitingElements& waiting, size_t end, size_t lanes, Stream* stream);

}  // namespace shd::texture
