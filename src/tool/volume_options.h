// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include <shd/volume_file.h>

/// The volume of the command line.
struct VolumeOptions {
  std::string file;                   // .vdb, a pattern or a file of pages, or voxels of `size`; empty = no volume
  std::array<uint32_t, 3> size = {};  // voxels of a file without a format; 0 = another file
  shd_raw_sample sample = SHD_RAW_SAMPLE_U8;
  shd_byte_order order = SHD_BYTE_ORDER_LITTLE;
  uint64_t header = 0;                        // [bytes]
  uint32_t first = 0, last = 0;               // numbers of a pattern
  std::string grid;                           // name in a .vdb file; empty = the first one
  std::array<float, 3> spacing = {1, 1, 1};   // distances of voxels along x, y and z
  bool slices_up = false;                     // the axis of the slices is +Y, not -Z
  std::optional<std::array<float, 2>> range;  // densities of the transfer function; absent = all densities
  float density = 1.0f;                       // factor of extinction
};

/// Handles options of the volume. Returns false if `name` is not one. Throws Failure (kExitUsage).
bool set_volume_value(const std::string& name, const std::string& value, VolumeOptions& out);
