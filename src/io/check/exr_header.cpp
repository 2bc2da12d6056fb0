// SPDX-License-Identifier: MIT
#include "io/check/exr_header.h"

#include <cstring>

#include "core/failure.h"
#include "io/file/byte_reader.h"
#include "io/file/printable.h"

namespace shd::io {

namespace {

constexpr uint32_t kDeepBit = 0x800;
constexpr uint32_t kMultiPartBit = 0x1000;
constexpr size_t kMaxName = 255;
constexpr size_t kMaxParts = 1024;

/// One attribute: name, type, and offset and size of its value.
struct Attribute {
  const char* name;
  const char* type;
  uint64_t value;
  uint64_t size;
};

/// Length of the zero-terminated text at `at`. Throws Failure if it is above kMaxName.
size_t text_length(const ByteReader& in, uint64_t at) {
  for (size_t i = 0; i <= kMaxName && in.has(at, i + 1); ++i) {
    if (in.bytes[at + i] == 0) return i;
  }
  core::refuse(SHD_ERROR_CORRUPT, "OpenEXR header is cut off or has a name above %zu bytes", kMaxName);
}

/// Reads the attribute at *at and advances to the next one. Returns false at the end of a header.
bool next_attribute(ByteReader& in, uint64_t* at, Attribute* out) {
  const size_t name = text_length(in, *at);
  out->name = reinterpret_cast<const char*>(in.bytes + *at);
  *at += name + 1;
  if (name == 0) return false;
  out->type = reinterpret_cast<const char*>(in.bytes + *at);
  *at += text_length(in, *at) + 1;
  out->size = in.u32(*at);
  out->value = *at + 4;
  if (!in.ok || !in.has(out->value, out->size)) core::refuse(SHD_ERROR_CORRUPT, "OpenEXR attribute is cut off");
  *at = out->value + out->size;
  return true;
}

void check_window(ByteReader& in, const Attribute& attribute, const Limits& limits) {
  int64_t side[4];
  for (size_t i = 0; i < 4; ++i) side[i] = static_cast<int32_t>(in.u32(attribute.value + 4 * i));
  const int64_t width = side[2] - side[0] + 1;
  const int64_t height = side[3] - side[1] + 1;
  const bool data = std::strcmp(attribute.name, "dataWindow") == 0;
  check_extent(limits, data ? "data window" : "display window", static_cast<uint64_t>(width < 0 ? 0 : width),
               static_cast<uint64_t>(height < 0 ? 0 : height));
}

/// A channel consists of its name, type, pLinear with three reserved bytes, and the two samplings.
void check_channels(ByteReader& in, const Attribute& attribute) {
  const uint64_t end = attribute.value + attribute.size;
  for (uint64_t at = attribute.value; at < end;) {
    const size_t name = text_length(in, at);
    if (name == 0) return;
    const uint64_t fields = at + name + 1;
    const bool plain = in.u32(fields + 8) == 1 && in.u32(fields + 12) == 1;
    if (!in.ok) core::refuse(SHD_ERROR_CORRUPT, "OpenEXR channel list is cut off");
    if (!plain) {
      core::refuse(SHD_ERROR_UNSUPPORTED, "OpenEXR channel \"%s\" is subsampled",
                   printable(reinterpret_cast<const char*>(in.bytes + at)).c_str());
    }
    at = fields + 16;
  }
}

/// Refuses "deepscanline" and "deeptile"; the text has no terminating zero.
void check_type(const ByteReader& in, const Attribute& attribute) {
  if (attribute.size >= 4 && in.is(attribute.value, "deep", 4)) {
    core::refuse(SHD_ERROR_UNSUPPORTED, "deep OpenEXR images are not supported");
  }
}

/// Checks one header. Returns false for the empty header that ends a multi-part list.
bool check_part(ByteReader& in, uint64_t* at, const Limits& limits) {
  Attribute attribute;
  bool any = false;
  while (next_attribute(in, at, &attribute)) {
    any = true;
    const bool window =
        std::strcmp(attribute.name, "dataWindow") == 0 || std::strcmp(attribute.name, "displayWindow") == 0;
    if (window && std::strcmp(attribute.type, "box2i") == 0) check_window(in, attribute, limits);
    if (std::strcmp(attribute.name, "channels") == 0) check_channels(in, attribute);
    if (std::strcmp(attribute.name, "type") == 0) check_type(in, attribute);
  }
  return any;
}

}  // namespace

void check_exr_header(const unsigned char* bytes, size_t size, const Limits& limits) {
  ByteReader in{bytes, size, false};
  const uint32_t version = in.u32(4);
  if (!in.ok) core::refuse(SHD_ERROR_CORRUPT, "OpenEXR header is cut off");
  if (version & kDeepBit) core::refuse(SHD_ERROR_UNSUPPORTED, "deep OpenEXR images are not supported");
  uint64_t at = 8;
  size_t parts = 0;
  const bool multi_part = (version & kMultiPartBit) != 0;
  while (check_part(in, &at, limits) && multi_part) {
    if (++parts > kMaxParts) core::refuse(SHD_ERROR_LIMIT, "OpenEXR file of more than %zu parts", kMaxParts);
  }
}

}  // namespace shd::io
