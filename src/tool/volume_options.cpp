// SPDX-License-Identifier: MIT
#include "tool/volume_options.h"

#include <cmath>
#include <cstdio>
#include <cstring>

#include "command/failure.h"

namespace {

/// Whether `text` is a number, and ends behind it.
bool read(const char*& text, float* out) {
  int length = 0;
  if (std::sscanf(text, "%f%n", out, &length) != 1 || !std::isfinite(*out)) return false;
  text += length;
  return true;
}

/// Reads `count` numbers with a separator between them.
bool read_list(const std::string& value, char separator, float* out, int count) {
  const char* text = value.c_str();
  for (int i = 0; i < count; ++i) {
    if (i > 0 && *text++ != separator) return false;
    if (!read(text, out + i)) return false;
  }
  return *text == 0;
}

bool is_whole(float number, float low, float high) {
  return number >= low && number <= high && number == std::floor(number);
}

void read_size(const std::string& name, const std::string& value, VolumeOptions& out) {
  const char* wanted = "WIDTHxHEIGHTxDEPTH, each 1..65536";
  float sides[3];
  if (!read_list(value, 'x', sides, 3)) refuse(name, value, wanted);
  for (size_t a = 0; a < 3; ++a) {
    if (!is_whole(sides[a], 1, 65536)) refuse(name, value, wanted);
    out.size[a] = static_cast<uint32_t>(sides[a]);
  }
}

/// u8, i16be ...
void read_format(const std::string& name, const std::string& value, VolumeOptions& out) {
  constexpr const char* kNames[] = {"u8", "u16", "f16", "f32", "i8", "i16", "u32", "i32"};
  const bool big = value.size() > 2 && value.compare(value.size() - 2, 2, "be") == 0;
  const std::string kind = big ? value.substr(0, value.size() - 2) : value;
  for (int i = 0; i < 8; ++i) {
    if (kind != kNames[i]) continue;
    out.sample = static_cast<shd_raw_sample>(i);
    out.order = big ? SHD_BYTE_ORDER_BIG : SHD_BYTE_ORDER_LITTLE;
    return;
  }
  refuse(name, value, "u8, u16, u32, i8, i16, i32, f16 or f32, with be behind it for the highest byte first");
}

void read_header(const std::string& name, const std::string& value, VolumeOptions& out) {
  float bytes;
  if (value == "rest") {
    out.header = SHD_RAW_HEADER_REST;
  } else if (read_list(value, ',', &bytes, 1) && is_whole(bytes, 0, 16777216)) {
    out.header = static_cast<uint64_t>(bytes);
  } else {
    refuse(name, value, "a number of bytes 0..16777216, or rest");
  }
}

void read_slices(const std::string& name, const std::string& value, VolumeOptions& out) {
  float ends[2];
  if (!read_list(value, ',', ends, 2) || !is_whole(ends[0], 0, 16777215) || !is_whole(ends[1], ends[0], 16777215)) {
    refuse(name, value, "FIRST,LAST: whole numbers, the last one not smaller");
  }
  out.first = static_cast<uint32_t>(ends[0]);
  out.last = static_cast<uint32_t>(ends[1]);
}

void read_spacing(const std::string& name, const std::string& value, VolumeOptions& out) {
  if (!read_list(value, ',', out.spacing.data(), 3)) refuse(name, value, "X,Y,Z");
  for (const float s : out.spacing) {
    if (!(s >= 1e-6f && s <= 1e6f)) refuse(name, value, "X,Y,Z, each 1e-6..1e6");
  }
}

void read_range(const std::string& name, const std::string& value, VolumeOptions& out) {
  std::array<float, 2> range{};
  if (!read_list(value, ',', range.data(), 2) || !(range[0] < range[1])) refuse(name, value, "LOW,HIGH, rising");
  out.range = range;
}

}  // namespace

bool set_volume_value(const std::string& name, const std::string& value, VolumeOptions& out) {
  if (name == "--volume") {
    if (value.empty()) refuse(name, value, "the name of a file");
    return out.file = value, true;
  }
  if (name == "--volume-size") return read_size(name, value, out), true;
  if (name == "--volume-format") return read_format(name, value, out), true;
  if (name == "--volume-header") return read_header(name, value, out), true;
  if (name == "--volume-slices") return read_slices(name, value, out), true;
  if (name == "--volume-grid") return out.grid = value, true;
  if (name == "--volume-spacing") return read_spacing(name, value, out), true;
  if (name == "--volume-range") return read_range(name, value, out), true;
  if (name == "--volume-up") {
    if (value != "y" && value != "z") refuse(name, value, "y or z");
    return out.slices_up = value == "z", true;
  }
  if (name == "--volume-density") {
    if (!read_list(value, ',', &out.density, 1) || out.density < 0 || out.density > 1e6f) {
      refuse(name, value, "a number 0..1e6");
    }
    return true;
  }
  return false;
}
