// SPDX-License-Identifier: MIT
#include "io/container/ktx2.h"

#include <algorithm>
#include <cstring>

#include "core/failure.h"
#include "image/format.h"
#include "io/bitmap/levels.h"

namespace shd::io {

namespace {

constexpr const char* kKtx2Name = "KTX2";

/// A part of the file that the header names; empty parts may lie anywhere.
Span read_part(const ByteReader& in, const char* name, uint64_t offset, uint64_t size, uint64_t first) {
  if (size != 0 && (offset < first || !in.file_has(offset, size))) {
    core::refuse(SHD_ERROR_CORRUPT, "KTX2: %s at %llu of %llu bytes is not in %llu..%llu of the file", name,
                 wide(offset), wide(size), wide(first), wide(in.file_size()));
  }
  return {offset, size};
}

[[noreturn]] void refuse_basis(uint32_t model) {
  core::refuse(SHD_ERROR_UNSUPPORTED,
               "KTX2: Basis Universal (%s). No package of Debian has its transcoder: transcode the file to BC7 or "
               "BC6H before it is loaded, as `ktx transcode` of KTX-Software does",
               model == kModelUastc                                  ? "UASTC"
               : model == kModelUastcHdr || model == kModelUastcHdr6 ? "UASTC HDR"
                                                                     : "ETC1S, BasisLZ");
}

/// Sizes and counts of the header.
void read_header(ByteReader& in, TextureFile* parsed) {
  shd_texture_file_info& info = parsed->info;
  info.kind = SHD_TEXTURE_FILE_KIND_KTX2;
  info.file_code = in.u32(12);
  info.width = in.u32(20);
  info.height = in.u32(24);
  info.depth = in.u32(28);
  info.layer_count = in.u32(32);
  info.face_count = in.u32(36);
  info.level_count = std::max(in.u32(40), 1u);  // 0 leaves the levels to the reader
  const uint32_t scheme = in.u32(44);
  if (!in.ok) core::refuse(SHD_ERROR_CORRUPT, "KTX2: %zu bytes end within the header", in.size);
  if (scheme > SHD_SUPERCOMPRESSION_ZLIB) {
    core::refuse(SHD_ERROR_UNSUPPORTED, "KTX2: supercompressionScheme %u is not in 0..3", scheme);
  }
  info.supercompression = static_cast<shd_supercompression>(scheme);
  if (info.layer_count != 0) info.flags |= SHD_TEXTURE_FILE_ARRAY;
  info.layer_count = std::max<size_t>(info.layer_count, 1);
  if (info.height == 0 && info.depth != 0) {
    core::refuse(SHD_ERROR_CORRUPT, "KTX2: pixelHeight 0, but pixelDepth %u", info.depth);
  }
  if (info.height == 0 && info.width != 0) info.height = 1;
}

/// Size of the numbers of a storage, as typeSize states it.
uint32_t type_size(const Storage& storage) {
  if (storage.block_width > 1) return 1;
  return static_cast<uint32_t>(image::format_info(storage.format).channel_size);
}

void choose_storage(const Descriptor& descriptor, uint32_t stated_type_size, shd_color_encoding encoding,
                    TextureFile* parsed) {
  const uint32_t code = parsed->info.file_code;
  const bool supercompressed = parsed->info.supercompression != SHD_SUPERCOMPRESSION_NONE;
  const uint32_t model = descriptor.model;
  const bool basis = model == kModelEtc1s || (model >= kModelUastc && model <= kModelUastcHdr6);
  if (basis || parsed->info.supercompression == SHD_SUPERCOMPRESSION_BASIS_LZ) refuse_basis(descriptor.model);
  Storage& storage = parsed->storage = storage_of_vulkan(code);
  if (storage.format == SHD_FORMAT_NONE) {
    core::refuse(SHD_ERROR_UNSUPPORTED, "KTX2: vkFormat %u is not a format of shd; docs/compressed.md lists them",
                 code);
  }
  if (stated_type_size != type_size(storage)) {
    core::refuse(SHD_ERROR_CORRUPT, "KTX2: typeSize %u, but vkFormat %u has %u", stated_type_size, code,
                 type_size(storage));
  }
  check_descriptor(descriptor, storage, code, supercompressed);
  const bool srgb_format = without_srgb(storage.format) != storage.format;
  const bool srgb_curve = descriptor.transfer == kTransferSrgb;
  if (encoding == SHD_COLOR_ENCODING_AUTO && srgb_format != srgb_curve && with_srgb(storage.format)) {
    core::refuse(SHD_ERROR_CORRUPT, "KTX2: vkFormat %u, but transfer %u in the descriptor: set color_space", code,
                 descriptor.transfer);
  }
  const bool linear = descriptor.transfer <= kTransferLinear;
  storage.format = choose_curve(kKtx2Name, storage.format,
                                srgb_curve ? Declared::kSrgb
                                : linear   ? Declared::kLinear
                                           : Declared::kOther,
                                encoding);
  if (descriptor.flags & kFlagPremultiplied) parsed->info.flags |= SHD_TEXTURE_FILE_PREMULTIPLIED;
}

/// Level l of the index.
void read_level(ByteReader& in, uint32_t l, uint64_t first, TextureFile* parsed) {
  const uint64_t at = kKtx2Header + l * kKtx2Level;
  const Span level = read_part(in, "a level", in.u64(at), in.u64(at + 8), first);
  const uint64_t unpacked = in.u64(at + 16);
  const uint64_t image = image_size(*parsed, l);
  const uint64_t wanted = image * parsed->images;
  if (unpacked != wanted) {
    core::refuse(SHD_ERROR_CORRUPT, "KTX2: uncompressedByteLength of level %u is %llu, not %llu", l, wide(unpacked),
                 wide(wanted));
  }
  const bool stored = parsed->info.supercompression == SHD_SUPERCOMPRESSION_NONE;
  if (level.size == 0 || (stored && level.size != wanted)) {
    core::refuse(SHD_ERROR_CORRUPT, "KTX2: byteLength of level %u is %llu, not %llu", l, wide(level.size),
                 wide(wanted));
  }
  parsed->levels[l] = level;
  parsed->image_stride[l] = image;
}

/// No two parts share a byte.
void check_apart(const TextureFile& parsed, Span descriptor, Span values) {
  Span parts[kMaxFileLevels + 2] = {descriptor, values};
  const uint32_t count = parsed.info.level_count + 2;
  std::copy(parsed.levels, parsed.levels + parsed.info.level_count, parts + 2);
  std::sort(parts, parts + count, [](const Span& a, const Span& b) { return a.offset < b.offset; });
  const Span* before = nullptr;
  for (uint32_t i = 0; i < count; ++i) {
    if (parts[i].size == 0) continue;
    if (before && before->offset + before->size > parts[i].offset) {
      core::refuse(SHD_ERROR_CORRUPT, "KTX2: the part at %llu of %llu bytes overlaps the one at %llu",
                   wide(before->offset), wide(before->size), wide(parts[i].offset));
    }
    before = &parts[i];
  }
}

}  // namespace

bool is_ktx2(const unsigned char* bytes, size_t size) {
  return size >= sizeof kKtx2Identifier && std::memcmp(bytes, kKtx2Identifier, sizeof kKtx2Identifier) == 0;
}

TextureFile parse_ktx2(ByteReader in, shd_color_encoding encoding, const Limits& limits) {
  TextureFile parsed;
  read_header(in, &parsed);
  if (parsed.info.level_count > kMaxFileLevels) {
    core::refuse(SHD_ERROR_CORRUPT, "KTX2: %zu levels are above %u", parsed.info.level_count, kMaxFileLevels);
  }
  const uint64_t first = kKtx2Header + parsed.info.level_count * kKtx2Level;
  if (!in.has(0, first)) core::refuse(SHD_ERROR_CORRUPT, "KTX2: %zu bytes end within the level index", in.size);
  const Span descriptor = read_part(in, "the data format descriptor", in.u32(48), in.u32(52), first);
  const Span values = read_part(in, "the key/value data", in.u32(56), in.u32(60), first);
  (void)read_part(in, "the supercompression data", in.u64(64), in.u64(72), first);
  for (const Span& part : {descriptor, values}) {
    if (part.size == 0 || in.has(part.offset, part.size)) continue;
    core::refuse(SHD_ERROR_LIMIT, "KTX2: data before the levels end beyond the first %zu bytes of the file", in.size);
  }
  choose_storage(read_descriptor(in, descriptor), in.u32(16), encoding, &parsed);
  if (in.u64(72) != 0) {
    core::refuse(SHD_ERROR_CORRUPT, "KTX2: sgdByteLength %llu, but supercompressionScheme %d has no such data",
                 wide(in.u64(72)), static_cast<int>(parsed.info.supercompression));
  }
  check_sizes(kKtx2Name, limits, &parsed);
  for (uint32_t l = 0; l < parsed.info.level_count; ++l) read_level(in, l, first, &parsed);
  check_apart(parsed, descriptor, values);
  read_key_values(in, values, &parsed);
  parsed.info.format = parsed.storage.format;
  return parsed;
}

}  // namespace shd::io
