// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace shd::io {

/// Checks a DDS header (Microsoft, "Programming Guide for DDS"). Refuses cube maps, volumes, unknown pixel formats, and
/// files that are too short for their first level. The decoder does not check these.
void check_dds_header(const unsigned char* bytes, size_t size);

/// Number of mip levels for which the file is long enough, down to 1 x 1, after check_dds_header(). The decoder does
/// not report the end of the file.
uint32_t dds_whole_levels(const unsigned char* bytes, size_t size);

}  // namespace shd::io
