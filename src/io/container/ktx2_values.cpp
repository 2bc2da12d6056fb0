// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstring>
#include <string>

#include "core/failure.h"
#include "image/format.h"
#include "io/container/ktx2.h"
#include "io/file/printable.h"

namespace shd::io {

namespace {

/// KTXswizzle: four of "rgba01".
void read_swizzle(const std::string& value, TextureFile* parsed) {
  if (value.size() != 4 || value.find_first_not_of("rgba01") != std::string::npos) {
    core::refuse(SHD_ERROR_CORRUPT, "KTX2: KTXswizzle \"%s\" is not four of r, g, b, a, 0, 1",
                 printable(value).c_str());
  }
  const shd_format format = parsed->storage.format;
  const size_t channels = image::block_info(format).channels + image::format_info(format).channels;
  for (size_t k = 0; k < 4; ++k) {
    const size_t channel = std::string("rgba").find(value[k]);
    if (channel < channels) {
      parsed->swizzle[k] = static_cast<shd_channel>(SHD_CHANNEL_R + channel);
    } else {
      // A number, or a channel that the format lacks: 0, and 1 for alpha (Vulkan 1.3, "Component Substitution").
      parsed->swizzle[k] = SHD_CHANNEL_FILL;
      parsed->fill[k] = value[k] == '1' || value[k] == 'a' ? 1.0f : 0.0f;
    }
  }
}

/// KTXorientation: r or l, d or u, o or i; as many as the texture has dimensions.
void read_orientation(const std::string& value, TextureFile* parsed) {
  constexpr const char* kLetters[3] = {"rl", "du", "oi"};
  bool valid = !value.empty() && value.size() <= 3;
  for (size_t k = 0; valid && k < value.size(); ++k) valid = std::strchr(kLetters[k], value[k]) != nullptr;
  if (!valid) {
    core::refuse(SHD_ERROR_CORRUPT, "KTX2: KTXorientation \"%s\" is not as \"rd\" or \"rdo\"",
                 printable(value).c_str());
  }
  if (value[0] == 'l') parsed->info.flags |= SHD_TEXTURE_FILE_RIGHT_TO_LEFT;
  if (value.size() > 1 && value[1] == 'u') parsed->info.flags |= SHD_TEXTURE_FILE_BOTTOM_UP;
}

}  // namespace

void read_key_values(ByteReader& in, Span span, TextureFile* parsed) {
  const uint64_t end = span.offset + span.size;
  for (uint64_t at = span.offset; at < end;) {
    const uint64_t left = end - at;
    const uint64_t length = left < 4 ? 0 : in.u32(at);
    if (length < 2 || length > left - 4) {
      core::refuse(SHD_ERROR_CORRUPT, "KTX2: an entry of %llu bytes among the last %llu of the key/value data",
                   static_cast<unsigned long long>(length), static_cast<unsigned long long>(left));
    }
    const char* const key = reinterpret_cast<const char*>(in.bytes + at + 4);
    const char* const key_end = static_cast<const char*>(std::memchr(key, 0, length));
    if (!key_end) core::refuse(SHD_ERROR_CORRUPT, "KTX2: a key without an end in the key/value data");
    std::string value(key_end + 1, key + length);
    while (!value.empty() && value.back() == '\0') value.pop_back();
    const std::string name(key, key_end);
    if (name == "KTXswizzle") read_swizzle(value, parsed);
    if (name == "KTXorientation") read_orientation(value, parsed);
    at += std::min(left, 4 + (length + 3) / 4 * 4);
  }
}

}  // namespace shd::io
