// SPDX-License-Identifier: MIT
#include "core/failure.h"
#include "image/format.h"
#include "io/container/ktx2.h"

namespace shd::io {

Descriptor read_descriptor(ByteReader& in, Span span) {
  constexpr uint32_t kTotal = 4;  // the number of bytes comes first
  if (span.size < kTotal + kDfdBlockHeader || in.u32(span.offset) != span.size) {
    core::refuse(SHD_ERROR_CORRUPT, "KTX2: dfdByteLength %llu, but the descriptor has %u bytes",
                 static_cast<unsigned long long>(span.size), in.u32(span.offset));
  }
  const uint64_t at = span.offset + kTotal;
  const uint32_t block = in.u16(at + 6);
  const bool basic = in.u32(at) == 0;
  if (!basic || block < kDfdBlockHeader || block > span.size - kTotal || (block - kDfdBlockHeader) % kDfdSample != 0) {
    core::refuse(SHD_ERROR_CORRUPT, "KTX2: a data format descriptor of type 0x%x and %u bytes", in.u32(at), block);
  }
  Descriptor descriptor;
  descriptor.model = in.u8(at + 8);
  descriptor.transfer = in.u8(at + 10);
  descriptor.flags = in.u8(at + 11);
  descriptor.block_width = in.u8(at + 12) + 1;
  descriptor.block_height = in.u8(at + 13) + 1;
  descriptor.block_depth = in.u8(at + 14) + 1;
  descriptor.plane_size = in.u8(at + 16);
  return descriptor;
}

uint32_t model_of(const Storage& storage) {
  if (storage.unpack == Unpack::kAstc) return kModelAstc;
  switch (without_srgb(storage.format)) {
    case SHD_FORMAT_BC1_RGB:
    case SHD_FORMAT_BC1_RGBA: return kModelBc1;
    case SHD_FORMAT_BC2: return kModelBc1 + 1;
    case SHD_FORMAT_BC3: return kModelBc1 + 2;
    case SHD_FORMAT_BC4:
    case SHD_FORMAT_BC4_SNORM: return kModelBc1 + 3;
    case SHD_FORMAT_BC5:
    case SHD_FORMAT_BC5_SNORM: return kModelBc1 + 4;
    case SHD_FORMAT_BC6H_UFLOAT:
    case SHD_FORMAT_BC6H_SFLOAT: return kModelBc1 + 5;
    case SHD_FORMAT_BC7: return kModelBc1 + 6;
    default: return kModelRgbsda;
  }
}

void check_descriptor(const Descriptor& descriptor, const Storage& storage, uint32_t code, bool supercompressed) {
  if (descriptor.model != model_of(storage)) {
    core::refuse(SHD_ERROR_CORRUPT, "KTX2: vkFormat %u, but the colour model of the descriptor is %u, not %u", code,
                 descriptor.model, model_of(storage));
  }
  if (descriptor.block_width != storage.block_width || descriptor.block_height != storage.block_height ||
      descriptor.block_depth != 1) {
    core::refuse(SHD_ERROR_CORRUPT, "KTX2: vkFormat %u, but the blocks of the descriptor have %u x %u x %u texels",
                 code, descriptor.block_width, descriptor.block_height, descriptor.block_depth);
  }
  // Writers of supercompressed files may state 0 (section 4.3 of the KTX specification).
  const bool stated = descriptor.plane_size != 0 || !supercompressed;
  if (stated && descriptor.plane_size != storage.unit_size) {
    core::refuse(SHD_ERROR_CORRUPT, "KTX2: vkFormat %u, but bytesPlane0 of the descriptor is %u, not %u", code,
                 descriptor.plane_size, storage.unit_size);
  }
}

}  // namespace shd::io
