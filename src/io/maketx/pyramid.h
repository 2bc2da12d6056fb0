// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "texture/table/mip_stream.h"

/// Mip levels of rows that arrive in bands, for any format.
class Pyramid {
 public:
  virtual ~Pyramid() = default;
  /// Adds rows of the base; `out` [levels] gets the rows of level 1, 2 and so on that they complete.
  virtual void push(const shd::texture::StreamRows& rows, uint8_t* const* out) = 0;
  /// Numbers that continue the pyramid after its last push.
  virtual std::vector<double>& state() = 0;
};

/// `normal` needs three or four channels that are not sRGB.
std::unique_ptr<Pyramid> make_pyramid(shd::image::Component component, size_t channels, bool normal, uint32_t width,
                                      uint32_t height);

/// Memory of the state of a pyramid, at most [bytes].
uint64_t pyramid_bytes(size_t channels, bool normal, uint32_t width, uint32_t height);
