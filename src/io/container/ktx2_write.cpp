// SPDX-License-Identifier: MIT
#include "io/container/ktx2_write.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <string>

#include "core/failure.h"
#include "image/format.h"
#include "io/container/inflate.h"
#include "io/container/ktx2.h"

namespace shd::io {

namespace {

using Bytes = std::vector<unsigned char>;

void put(Bytes* out, uint64_t value, size_t size) {
  for (size_t i = 0; i < size; ++i) out->push_back(static_cast<unsigned char>(value >> 8 * i));
}

void set(Bytes* out, size_t at, uint64_t value, size_t size) {
  for (size_t i = 0; i < size; ++i) (*out)[at + i] = static_cast<unsigned char>(value >> 8 * i);
}

/// The VkFormat of a format without unpacking.
uint32_t vulkan_of(shd_format format) {
  for (uint32_t code = 1; code < 200; ++code) {
    const Storage storage = storage_of_vulkan(code);
    if (storage.format == format && storage.unpack == Unpack::kNone) return code;
  }
  core::refuse(SHD_ERROR_INTERNAL, "no VkFormat for format %d", static_cast<int>(format));
}

/// A sample of a data format descriptor. Data Format Specification 1.3, section 5.9.
struct DescriptorSample {
  uint32_t offset, bits, channel, low, high;
};
constexpr uint32_t kChannelAlpha = 15, kLinearFlag = 0x10, kExponentFlag = 0x20, kSignedFlag = 0x40, kFloatFlag = 0x80;
constexpr uint32_t kMostUnsigned = 0xffffffff, kMostSigned = 0x7fffffff, kLeastSigned = 0x80000000;
constexpr uint32_t kOne = 0x3f800000, kMinusOne = 0xbf800000;  // bits of 1.0 and -1.0

std::vector<DescriptorSample> samples_of_blocks(shd_format format) {
  const bool srgb = without_srgb(format) != format;
  const uint32_t alpha = kChannelAlpha | (srgb ? kLinearFlag : 0);
  switch (without_srgb(format)) {
    case SHD_FORMAT_BC1_RGB: return {{0, 64, 0, 0, kMostUnsigned}};
    case SHD_FORMAT_BC1_RGBA: return {{0, 64, 1, 0, kMostUnsigned}};  // BC1A_ALPHAPRESENT
    case SHD_FORMAT_BC2:
    case SHD_FORMAT_BC3: return {{0, 64, alpha, 0, kMostUnsigned}, {64, 64, 0, 0, kMostUnsigned}};
    case SHD_FORMAT_BC4: return {{0, 64, 0, 0, kMostUnsigned}};
    case SHD_FORMAT_BC4_SNORM: return {{0, 64, kSignedFlag, kLeastSigned, kMostSigned}};
    case SHD_FORMAT_BC5: return {{0, 64, 0, 0, kMostUnsigned}, {64, 64, 1, 0, kMostUnsigned}};
    case SHD_FORMAT_BC5_SNORM:
      return {{0, 64, kSignedFlag, kLeastSigned, kMostSigned}, {64, 64, kSignedFlag | 1, kLeastSigned, kMostSigned}};
    case SHD_FORMAT_BC6H_UFLOAT: return {{0, 128, kFloatFlag, 0, kOne}};
    case SHD_FORMAT_BC6H_SFLOAT: return {{0, 128, kFloatFlag | kSignedFlag, kMinusOne, kOne}};
    default: return {{0, 128, 0, 0, kMostUnsigned}};
  }
}

/// Each channel has a sample of its number, whose value 1 is 8448, and one of the exponent, whose bias is 15.
std::vector<DescriptorSample> samples_of_rgb9e5() {
  std::vector<DescriptorSample> samples;
  for (uint32_t c = 0; c < 3; ++c) {
    samples.push_back({9 * c, 9, c, 0, 8448});
    samples.push_back({27, 5, c | kExponentFlag, 15, 31});
  }
  return samples;
}

std::vector<DescriptorSample> samples_of(shd_format format) {
  if (format == SHD_FORMAT_RGB9E5) return samples_of_rgb9e5();
  if (image::block_info(format).block_size != 0) return samples_of_blocks(format);
  const image::FormatInfo info = image::format_info(format);
  const bool floats = info.component == image::Component::kFloat16 || info.component == image::Component::kFloat32;
  const bool srgb = info.component == image::Component::kSrgb8;
  const auto bits = static_cast<uint32_t>(8 * info.channel_size);
  std::vector<DescriptorSample> samples;
  for (uint32_t c = 0; c < info.channels; ++c) {
    const uint32_t channel = c == 3 ? kChannelAlpha | (srgb ? kLinearFlag : 0) : c;
    const uint32_t low = floats ? kMinusOne : 0, high = floats ? kOne : (1u << bits) - 1;
    samples.push_back({c * bits, bits, channel | (floats ? kFloatFlag | kSignedFlag : 0), low, high});
  }
  return samples;
}

Bytes make_descriptor(const Storage& storage) {
  const std::vector<DescriptorSample> samples = samples_of(storage.format);
  const auto block = kDfdBlockHeader + static_cast<uint32_t>(samples.size()) * kDfdSample;
  const bool srgb = without_srgb(storage.format) != storage.format;
  Bytes out;
  put(&out, 4 + block, 4);
  put(&out, 0, 4);  // Khronos, basic
  put(&out, kDfdVersion, 2);
  put(&out, block, 2);
  put(&out, model_of(storage), 1);
  put(&out, kPrimariesBt709, 1);
  put(&out, srgb ? kTransferSrgb : kTransferLinear, 1);
  put(&out, 0, 1);  // straight alpha
  put(&out, storage.block_width - 1, 1);
  put(&out, storage.block_height - 1, 1);
  put(&out, 0, 2);
  put(&out, storage.unit_size, 8);
  for (const DescriptorSample& sample : samples) {
    put(&out, sample.offset, 2);
    put(&out, sample.bits - 1, 1);
    put(&out, sample.channel, 1);
    put(&out, 0, 4);
    put(&out, sample.low, 4);
    put(&out, sample.high, 4);
  }
  return out;
}

void put_value(Bytes* out, const char* key, const std::string& value) {
  const size_t length = std::strlen(key) + 1 + value.size() + 1;
  put(out, length, 4);
  out->insert(out->end(), key, key + std::strlen(key) + 1);
  out->insert(out->end(), value.c_str(), value.c_str() + value.size() + 1);
  out->resize((out->size() + 3) / 4 * 4);
}

Bytes make_values(const Ktx2Content& content) {
  Bytes out;
  put_value(&out, "KTXorientation", content.depth != 0 ? "rdo" : "rd");
  put_value(&out, "KTXwriter", "shd");
  return out;
}

Bytes make_header(const Ktx2Content& content, const Storage& storage, shd_supercompression scheme) {
  Bytes out(kKtx2Identifier, kKtx2Identifier + sizeof kKtx2Identifier);
  const bool blocks = storage.block_width > 1;
  put(&out, vulkan_of(content.format), 4);
  put(&out, blocks ? 1 : image::format_info(content.format).channel_size, 4);
  put(&out, content.width, 4);
  put(&out, content.height, 4);
  put(&out, content.depth, 4);
  put(&out, content.layers, 4);
  put(&out, content.faces, 4);
  put(&out, content.levels.size(), 4);
  put(&out, static_cast<uint32_t>(scheme), 4);
  out.resize(kKtx2Header + content.levels.size() * kKtx2Level);
  return out;
}

/// Appends a part, and writes its offset and size at `index`, as numbers of `number` bytes.
void append(Bytes* out, const Bytes& part, size_t alignment, size_t index, size_t number) {
  out->resize((out->size() + alignment - 1) / alignment * alignment);
  set(out, index, out->size(), number);
  set(out, index + number, part.size(), number);
  out->insert(out->end(), part.begin(), part.end());
}

}  // namespace

Bytes write_ktx2(const Ktx2Content& content, shd_supercompression scheme, int32_t effort) {
  const Storage storage = plain_storage(content.format);
  const bool compressed = scheme != SHD_SUPERCOMPRESSION_NONE;
  Bytes out = make_header(content, storage, scheme);
  append(&out, make_descriptor(storage), 4, 48, 4);
  append(&out, make_values(content), 4, 56, 4);
  for (size_t l = content.levels.size(); l-- > 0;) {  // the smallest level comes first
    const Bytes& level = content.levels[l];
    const size_t index = kKtx2Header + l * kKtx2Level;
    const size_t alignment = compressed ? 1 : std::lcm(storage.unit_size, 4u);
    append(&out, compressed ? deflate_level(scheme, effort, level) : level, alignment, index, 8);
    set(&out, index + 16, level.size(), 8);
  }
  return out;
}

}  // namespace shd::io
