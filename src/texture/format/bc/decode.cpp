// SPDX-License-Identifier: MIT
#include "texture/format/bc/decode.h"

namespace shd::texture {

DecodeBc decoder_of(shd_format format) {
  switch (format) {
    case SHD_FORMAT_BC1_RGB:
    case SHD_FORMAT_BC1_RGB_SRGB: return decode_bc1_rgb;
    case SHD_FORMAT_BC1_RGBA:
    case SHD_FORMAT_BC1_RGBA_SRGB: return decode_bc1_rgba;
    case SHD_FORMAT_BC2:
    case SHD_FORMAT_BC2_SRGB: return decode_bc2;
    case SHD_FORMAT_BC3:
    case SHD_FORMAT_BC3_SRGB: return decode_bc3;
    case SHD_FORMAT_BC4: return decode_bc4;
    case SHD_FORMAT_BC4_SNORM: return decode_bc4_snorm;
    case SHD_FORMAT_BC5: return decode_bc5;
    case SHD_FORMAT_BC5_SNORM: return decode_bc5_snorm;
    case SHD_FORMAT_BC6H_UFLOAT: return decode_bc6h_ufloat;
    case SHD_FORMAT_BC6H_SFLOAT: return decode_bc6h_sfloat;
    case SHD_FORMAT_BC7:
    case SHD_FORMAT_BC7_SRGB: return decode_bc7;
    default: return nullptr;
  }
}

}  // namespace shd::texture
