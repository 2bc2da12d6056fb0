// SPDX-License-Identifier: MIT
#include "texture/format/record.h"

#include "texture/stream.h"

namespace shd::texture {
namespace {

/// Writes the columns that adjacent texels leave out.
void write_neighbours(size_t e, size_t lanes, Stream* stream) {
  const bool quad = stream->op[e] & kQuad;
  auto& index = stream->index;
  const size_t at = e * lanes;
  const int32_t upper = index[quad ? 0 : 2][at];
  for (int32_t k = 0; quad && k < 4; ++k) index[k][at] = upper + k % 2;
  stream->op[e] = static_cast<uint16_t>(stream->op[e] & ~kNeighbours);
}

}  // namespace

void place_taps(void* recording, size_t end, size_t lanes, Stream* stream) {
  auto& record = *static_cast<Recording*>(recording);
  for (size_t e = 0; e < end; ++e) {
    if (stream->op[e] & kNeighbours) write_neighbours(e, lanes, stream);
    for (size_t k = 0; k < stream->texels_of(e); ++k) {
      int32_t& x = stream->index[k][e * lanes];
      const int32_t y = stream->places->y[stream->row_of(e, k)][e * lanes];
      const int32_t first = stream->places->first[stream->image_of(e, k)][e * lanes];
      const bool border = (x | y) < 0;
      SHD_ASSERT(record.place_count < Recording::kMaxTaps);
      record.places[record.place_count] = {border ? 0 : static_cast<uint32_t>(x), border ? 0 : static_cast<uint32_t>(y),
                                           static_cast<uint32_t>(first), border};
      x = static_cast<int32_t>(record.place_count++);
    }
  }
}

}  // namespace shd::texture
