// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "io/container/texture_file.h"

namespace shd::io {

/// A decoder of ASTC blocks of one size.
class AstcDecoder {
 public:
  /// `storage` is one of Unpack::kAstc. Throws Failure (SHD_ERROR_UNSUPPORTED) if this build has no libastcenc.
  explicit AstcDecoder(const Storage& storage);
  AstcDecoder(const AstcDecoder&) = delete;
  AstcDecoder& operator=(const AstcDecoder&) = delete;
  ~AstcDecoder();

  /// Decodes a slice of width x height texels into packed rows of the format of the storage. Every bit pattern of a
  /// block has a value. Throws Failure.
  void decode(const unsigned char* blocks, uint32_t width, uint32_t height, unsigned char* texels);

 private:
  Storage storage_;
  void* context_ = nullptr;
};

}  // namespace shd::io
