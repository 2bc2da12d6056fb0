// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "io/maketx/source.h"
#include "texture/table/mip_stream.h"

/// Mip levels of rows that arrive in bands, for any format.
class Pyramid {
 public:
  virtual ~Pyramid() = default;
  /// Adds rows of the base; `out` [levels] gets the rows of level 1, 2 and so on that they complete.
  virtual void push(const shd::texture::StreamRows& rows, uint8_t* const* out) = 0;
  /// Numbers that continue the pyramid after its last push.
  virtual std::vector<double>& state() = 0;
  /// Whether the last push completes all rows of the levels, and the others none: the image is in memory.
  virtual bool is_whole() const { return false; }
};

/// --normal needs three or four channels that are not sRGB.
std::unique_ptr<Pyramid> make_pyramid(const Options& options, const Image& image);

/// Memory of a pyramid, at most [bytes].
uint64_t pyramid_bytes(const Options& options, const Image& image);
