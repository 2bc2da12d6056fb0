// SPDX-License-Identifier: MIT
#include "io/bitmap/raw_voxels.h"

#include <algorithm>
#include <cstring>

namespace shd::io {

namespace {

bool machine_is_little() {
  const uint16_t one = 1;
  unsigned char first;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

template <class T>
void convert(size_t count, const unsigned char* in, float* out) {
  for (size_t i = 0; i < count; ++i) {
    T value;
    std::memcpy(&value, in + i * sizeof value, sizeof value);
    out[i] = static_cast<float>(value);
  }
}

}  // namespace

size_t raw_sample_size(shd_raw_sample sample) {
  switch (sample) {
    case SHD_RAW_SAMPLE_U8:
    case SHD_RAW_SAMPLE_I8: return 1;
    case SHD_RAW_SAMPLE_U16:
    case SHD_RAW_SAMPLE_I16:
    case SHD_RAW_SAMPLE_F16: return 2;
    case SHD_RAW_SAMPLE_U32:
    case SHD_RAW_SAMPLE_I32:
    case SHD_RAW_SAMPLE_F32: return 4;
    default: return 0;
  }
}

shd_format raw_format(shd_raw_sample sample, uint32_t channels) {
  constexpr shd_format kBytes[] = {SHD_FORMAT_R8, SHD_FORMAT_RG8, SHD_FORMAT_RGB8, SHD_FORMAT_RGBA8};
  constexpr shd_format kWords[] = {SHD_FORMAT_R16, SHD_FORMAT_RG16, SHD_FORMAT_RGB16, SHD_FORMAT_RGBA16};
  constexpr shd_format kHalves[] = {SHD_FORMAT_R16F, SHD_FORMAT_RG16F, SHD_FORMAT_RGB16F, SHD_FORMAT_RGBA16F};
  constexpr shd_format kFloats[] = {SHD_FORMAT_R32F, SHD_FORMAT_RG32F, SHD_FORMAT_RGB32F, SHD_FORMAT_RGBA32F};
  switch (sample) {
    case SHD_RAW_SAMPLE_U8: return kBytes[channels - 1];
    case SHD_RAW_SAMPLE_U16: return kWords[channels - 1];
    case SHD_RAW_SAMPLE_F16: return kHalves[channels - 1];
    default: return kFloats[channels - 1];
  }
}

bool raw_is_stored(shd_raw_sample sample) {
  return sample == SHD_RAW_SAMPLE_U8 || sample == SHD_RAW_SAMPLE_U16 || sample == SHD_RAW_SAMPLE_F16 ||
         sample == SHD_RAW_SAMPLE_F32;
}

void order_bytes(shd_byte_order order, shd_raw_sample sample, size_t count, unsigned char* bytes) {
  const size_t size = raw_sample_size(sample);
  if (size == 1 || (order == SHD_BYTE_ORDER_LITTLE) == machine_is_little()) return;
  for (size_t i = 0; i < count; ++i) std::reverse(bytes + i * size, bytes + (i + 1) * size);
}

void raw_to_floats(shd_raw_sample sample, size_t count, const unsigned char* in, float* out) {
  switch (sample) {
    case SHD_RAW_SAMPLE_I8: convert<int8_t>(count, in, out); break;
    case SHD_RAW_SAMPLE_I16: convert<int16_t>(count, in, out); break;
    case SHD_RAW_SAMPLE_U32: convert<uint32_t>(count, in, out); break;
    default: convert<int32_t>(count, in, out); break;
  }
}

void flip_rows(size_t row, uint32_t height, uint32_t depth, unsigned char* voxels) {
  for (uint32_t z = 0; z < depth; ++z) {
    unsigned char* const slice = voxels + z * height * row;
    for (uint32_t y = 0; y < height / 2; ++y) {
      std::swap_ranges(slice + y * row, slice + (y + 1) * row, slice + (height - 1 - y) * row);
    }
  }
}

}  // namespace shd::io
