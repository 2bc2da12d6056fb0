// SPDX-License-Identifier: MIT
#pragma once

#include "texture/texture.h"

namespace shd::texture {

/// The tables of a texture whose store has only levels: a texture in memory, made of its decoded levels.
struct DecodedTexture {
  Texture texture;
  const core::Allocator* allocator;
};

/// Builds the ripmap and the sums of a texture of bc or tiles, if it has these tables. Reads all its levels. Throws
/// std::bad_alloc, or Failure if a tile does not load, and then keeps nothing.
void build_decoded(const core::Context& context, Texture* texture);

/// Returns the texture that a filter reads: the decoded one for filters with tables of their own.
inline const Texture& read_by(const Texture& texture, shd_filter filter) {
  const bool has_table = filter == SHD_FILTER_RIPMAP || filter == SHD_FILTER_SUMMED_AREA;
  return has_table && texture.decoded ? texture.decoded->texture : texture;
}

}  // namespace shd::texture
