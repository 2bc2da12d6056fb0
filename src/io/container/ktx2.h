// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "io/container/texture_file.h"
#include "io/file/byte_reader.h"

/// Parts of a KTX 2.0 file. The numbers are those of Khronos, "KTX File Format Specification 2.0" (2021), section 3,
/// and "Data Format Specification 1.3" (2020), section 5.
namespace shd::io {

constexpr unsigned char kKtx2Identifier[12] = {0xab, 'K', 'T', 'X', ' ', '2', '0', 0xbb, '\r', '\n', 0x1a, '\n'};
constexpr uint64_t kKtx2Header = 80;  // bytes before the level index
constexpr uint64_t kKtx2Level = 24;   // bytes of an entry of the level index

/// Basic descriptor block.
constexpr uint32_t kDfdBlockHeader = 24;  // bytes before the samples
constexpr uint32_t kDfdSample = 16;       // bytes of a sample
constexpr uint32_t kDfdVersion = 2;
constexpr uint32_t kModelRgbsda = 1;
constexpr uint32_t kModelBc1 = 128;  // the models of BC2 to BC7 follow
constexpr uint32_t kModelAstc = 162;
constexpr uint32_t kModelEtc1s = 163;
constexpr uint32_t kModelUastc = 166;
constexpr uint32_t kModelUastcHdr = 167;   // blocks of 4 x 4 texels
constexpr uint32_t kModelUastcHdr6 = 168;  // blocks of 6 x 6 texels
constexpr uint32_t kTransferLinear = 1;
constexpr uint32_t kTransferSrgb = 2;
constexpr uint32_t kPrimariesBt709 = 1;
constexpr uint32_t kFlagPremultiplied = 1;

/// Fields of a data format descriptor.
struct Descriptor {
  uint32_t model = 0, transfer = 0, flags = 0;
  uint32_t block_width = 1, block_height = 1, block_depth = 1;
  uint32_t plane_size = 0;  // bytes of a unit; 0 = not stated
};

/// Reads the basic descriptor block. Throws Failure.
Descriptor read_descriptor(ByteReader& in, Span span);

/// Throws Failure unless the descriptor is one of this storage. `code` is the VkFormat.
void check_descriptor(const Descriptor& descriptor, const Storage& storage, uint32_t code, bool supercompressed);

/// The colour model of a storage.
uint32_t model_of(const Storage& storage);

/// Reads KTXswizzle and KTXorientation. Throws Failure for entries that do not fit.
void read_key_values(ByteReader& in, Span span, TextureFile* parsed);

}  // namespace shd::io
