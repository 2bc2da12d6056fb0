// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace shd::io {

/// Largest number of pages of a TIFF that becomes a volume; the metadata of further ones is not removed.
constexpr uint32_t kMaxPages = 1024;

/// Number of pages of a TIFF. Throws Failure if the chain of directories leaves the file, is a circle, or has more than
/// kMaxPages.
uint32_t count_tiff_pages(const unsigned char* bytes, size_t size);

}  // namespace shd::io
