// SPDX-License-Identifier: MIT
#pragma once

#include "io/bitmap/bitmap.h"

namespace shd::io {

/// Kinds of files that decoders of images do not read.
enum class Container { kImage, kTexture, kGrid };

/// Bytes of a file that container_of() needs.
constexpr size_t kContainerBytes = 12;

/// The kind of a file by its first bytes.
Container container_of(const unsigned char* bytes, size_t size);

/// Loads a KTX2 or DDS file for Parts::kTexture and kTextureImage. The sink may be null; with one, `bytes` must live as
/// long as what it takes.
Bitmap load_texture_file(const unsigned char* bytes, size_t size, const LoadOptions& options, const Memory& memory,
                         const Sink* sink);

/// Throws Failure unless a layout from another process is one that load_texture_file() can give for the options.
void check_layout(const TextureLayout& layout, const LoadOptions& options);

}  // namespace shd::io
