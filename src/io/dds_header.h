// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace shd::io {

/// Checks a DDS header (Microsoft, "Programming Guide for DDS"). Refuses cube maps, volumes, unknown pixel formats, and
/// files that are too short for their first level. The decoder does not check these.
void check_dds_header(const unsigned char* bytes, size_t size);

}  // namespace shd::io
