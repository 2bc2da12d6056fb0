// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace shd::bench {

/// Compresses RGBA8 texels [edge][edge] to BC1, with the corners of the bounding box of a block as endpoints. Edges
/// below 4 are extended.
std::vector<uint8_t> encode_bc1(const std::vector<uint8_t>& rgba, uint32_t edge);

/// Compresses RGBA8 texels [edge][edge] to BC7 in mode 6, with the same endpoints.
std::vector<uint8_t> encode_bc7(const std::vector<uint8_t>& rgba, uint32_t edge);

/// Returns the averages of 2 x 2 texels.
std::vector<uint8_t> halved(const std::vector<uint8_t>& rgba, uint32_t edge);

}  // namespace shd::bench
