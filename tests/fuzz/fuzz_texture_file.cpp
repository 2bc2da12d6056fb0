// SPDX-License-Identifier: MIT
// KTX2 and DDS files: parsing, decompression and unpacking. They throw nothing but a Failure with a text or bad_alloc,
// read nothing outside the file, and every level that they return has all its bytes. The mutator writes numbers into
// the header and the level index.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <vector>

#include "core/failure.h"
#include "io/container/texture_file.h"

#define SHD_FUZZ_CHECK(condition)                                          \
  do {                                                                     \
    if (!(condition)) {                                                    \
      std::fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition); \
      std::abort();                                                        \
    }                                                                      \
  } while (0)

extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t max_size);

namespace shd::io {
namespace {

uint64_t g_live;  // bytes of buffers

constexpr Memory kMemory = {nullptr,
                            [](void*, size_t size) {
                              g_live += size;
                              return std::malloc(size);
                            },
                            [](void*, void* memory, size_t size) {
                              g_live -= size;
                              std::free(memory);
                            }};

/// Sum of all texels that a texture would read.
uint64_t read_texels(const TextureFile& parsed, const Selection& selection, const TextureTexels& texels) {
  TextureFile unpacked;
  unpacked.info = parsed.info;
  unpacked.storage = plain_storage(parsed.storage.format);
  uint64_t sum = 0;
  for (uint32_t l = 0; l < selection.level_count; ++l) {
    const LevelTexels& level = texels.levels[l];
    for (uint32_t i = 0; i < selection.image_count; ++i) {
      const unsigned char* const image = level.texels + i * level.image_stride;
      for (uint64_t b = 0; b < image_size(unpacked, l); ++b) sum = sum * 31 + image[b];
    }
  }
  return sum;
}

/// Loads the file as libshd_io does. Returns the sum of its texels.
uint64_t run(const std::vector<unsigned char>& bytes, uint8_t choice) {
  Limits limits;
  limits.pixels = 1 << 16;
  limits.bytes = 1 << 20;
  const auto encoding = static_cast<shd_color_encoding>(choice % 4);
  try {
    const TextureFile parsed = parse_texture_file(bytes.data(), bytes.size(), encoding, (choice & 128) != 0, limits);
    SHD_FUZZ_CHECK(parsed.info.format != SHD_FORMAT_NONE && parsed.info.format == parsed.storage.format);
    SHD_FUZZ_CHECK(parsed.info.level_count >= 1 && parsed.info.level_count <= whole_level_count(parsed.info));
    Selection selection;
    selection.image_count = parsed.info.face_count == 6 ? 6 : parsed.info.layer_count;
    selection.first_image = parsed.info.face_count == 6 ? (choice >> 4) % parsed.info.layer_count * 6 : 0;
    selection.level_count = choice & 4 ? 1 : parsed.info.level_count;
    const bool blocks = plain_storage(parsed.info.format).block_width > 1;
    selection.flip_rows = (choice & 8) != 0 && !blocks;
    std::vector<unsigned char> whole = bytes;
    whole.resize(bytes.size() + parsed.absent);
    const TextureTexels texels = unpack_levels(parsed, whole.data(), selection, limits, kMemory);
    return read_texels(parsed, selection, texels);
  } catch (const core::Failure& failure) {
    SHD_FUZZ_CHECK(failure.what()[0] != '\0');
    SHD_FUZZ_CHECK(failure.code == SHD_ERROR_CORRUPT || failure.code == SHD_ERROR_UNSUPPORTED ||
                   failure.code == SHD_ERROR_LIMIT);
    return static_cast<uint64_t>(failure.code);
  }
}

/// Parses a file of which the first bytes are here, as a file whose tiles are read. All images lie in the file.
void check_head(const std::vector<unsigned char>& bytes, uint8_t choice) {
  const std::vector<unsigned char> head(bytes.begin(), bytes.begin() + std::min<size_t>(bytes.size(), choice * 8));
  Limits limits;
  limits.pixels = limits.bytes = limits.texels = UINT64_MAX;
  limits.side = 1 << 20;
  const auto encoding = static_cast<shd_color_encoding>(choice % 4);
  try {
    const TextureFile parsed =
        parse_texture_file(head.data(), head.size(), encoding, false, limits, bytes.size() - head.size());
    for (uint32_t l = 0; l < parsed.info.level_count; ++l) {
      const Span level = parsed.levels[l];
      SHD_FUZZ_CHECK(level.offset <= bytes.size() && level.size <= bytes.size() - level.offset);
      const uint64_t images = parsed.image_stride[l] * (parsed.images - 1) + image_size(parsed, l);
      SHD_FUZZ_CHECK(parsed.info.supercompression != SHD_SUPERCOMPRESSION_NONE || images == level.size);
    }
  } catch (const core::Failure& failure) {
    SHD_FUZZ_CHECK(failure.what()[0] != '\0');
  }
}

void write_number(uint8_t* data, size_t size, uint32_t random) {
  const uint64_t kNumbers[] = {0,      1,       2,          3,           4,           6,    16,       17,
                               0xffff, 0x10000, 0x7fffffff, 0x80000000u, 0xffffffffu, size, size - 1, ~uint64_t{0}};
  const uint64_t value = kNumbers[random % (sizeof kNumbers / sizeof kNumbers[0])];
  const size_t count = random >> 8 & 1 ? 4 : 8;
  // The numbers of the headers lie at multiples of four; the file begins behind the choice.
  const size_t at = 1 + (random >> 10 & 63) * 4;
  if (at + count > size) return;
  for (size_t i = 0; i < count; ++i) data[at + i] = static_cast<uint8_t>(value >> 8 * i);
}

}  // namespace
}  // namespace shd::io

extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size, size_t max_size, unsigned seed) {
  const uint32_t random = seed * 2654435761u ^ seed >> 15;
  if (random % 2 != 0 || size == 0) return LLVMFuzzerMutate(data, size, max_size);
  shd::io::write_number(data, size, random >> 2 ^ random << 13);
  return size;
}

/// The first byte chooses colour space, levels, rows and cube map; the others are the file.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace shd::io;
  if (size == 0) return 0;
  const std::vector<unsigned char> bytes(data + 1, data + size);
  const uint64_t sum = run(bytes, data[0]);
  SHD_FUZZ_CHECK(g_live == 0);
  SHD_FUZZ_CHECK(run(bytes, data[0]) == sum);
  check_head(bytes, data[0]);
  return 0;
}
