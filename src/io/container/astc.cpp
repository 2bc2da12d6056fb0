// SPDX-License-Identifier: MIT
#include "io/container/astc.h"

#ifdef SHD_WITH_ASTCENC
#include <astcenc.h>
#endif

#include <new>

#include "core/failure.h"

namespace shd::io {

#ifdef SHD_WITH_ASTCENC

namespace {

void require_astc(astcenc_error result) {
  if (result == ASTCENC_SUCCESS) return;
  if (result == ASTCENC_ERR_OUT_OF_MEM) throw std::bad_alloc();
  core::refuse(SHD_ERROR_INTERNAL, "libastcenc: %s", astcenc_get_error_string(result));
}

astcenc_profile profile_of(shd_format format) {
  if (format == SHD_FORMAT_RGBA16F) return ASTCENC_PRF_HDR;
  return format == SHD_FORMAT_RGBA8_SRGB ? ASTCENC_PRF_LDR_SRGB : ASTCENC_PRF_LDR;
}

}  // namespace

AstcDecoder::AstcDecoder(const Storage& storage) : storage_(storage) {
  astcenc_config config;
  require_astc(astcenc_config_init(profile_of(storage.format), storage.block_width, storage.block_height, 1,
                                   ASTCENC_PRE_FASTEST, ASTCENC_FLG_DECOMPRESS_ONLY, &config));
  astcenc_context* context = nullptr;
  require_astc(astcenc_context_alloc(&config, 1, &context));
  context_ = context;
}

AstcDecoder::~AstcDecoder() {
  if (context_) astcenc_context_free(static_cast<astcenc_context*>(context_));
}

void AstcDecoder::decode(const unsigned char* blocks, uint32_t width, uint32_t height, unsigned char* texels) {
  constexpr astcenc_swizzle kSwizzle = {ASTCENC_SWZ_R, ASTCENC_SWZ_G, ASTCENC_SWZ_B, ASTCENC_SWZ_A};
  void* slice = texels;
  astcenc_image image = {};
  image.dim_x = width;
  image.dim_y = height;
  image.dim_z = 1;
  image.data_type = storage_.format == SHD_FORMAT_RGBA16F ? ASTCENC_TYPE_F16 : ASTCENC_TYPE_U8;
  image.data = &slice;
  const size_t columns = (size_t{width} + storage_.block_width - 1) / storage_.block_width;
  const size_t rows = (size_t{height} + storage_.block_height - 1) / storage_.block_height;
  auto* const context = static_cast<astcenc_context*>(context_);
  require_astc(astcenc_decompress_image(context, blocks, columns * rows * storage_.unit_size, &image, &kSwizzle, 0));
  require_astc(astcenc_decompress_reset(context));
}

#else

AstcDecoder::AstcDecoder(const Storage& storage) : storage_(storage) {
  core::refuse(SHD_ERROR_UNSUPPORTED,
               "KTX2: ASTC blocks of %u x %u: this libshd_io was built without libastcenc (Debian: libastcenc-dev)",
               storage.block_width, storage.block_height);
}

AstcDecoder::~AstcDecoder() = default;

void AstcDecoder::decode(const unsigned char*, uint32_t, uint32_t, unsigned char*) {}

#endif

}  // namespace shd::io
