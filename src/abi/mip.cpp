// SPDX-License-Identifier: MIT
#include <shd/mip.h>

#include <cstdio>

#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "abi/levels.h"
#include "image/format.h"
#include "texture/store/storage.h"
#include "texture/table/height_normals.h"
#include "texture/table/mip_build.h"
#include "texture/table/normal_moments.h"

namespace {

using namespace shd;
using namespace shd::abi;

constexpr uint64_t kMaxBasePixels = uint64_t{1} << 28;

shd_result check_mip_desc(const shd_mip_desc& desc, size_t channels) {
  SHD_TRY(check_enum("mip.kernel", desc.kernel, SHD_MIP_KERNEL_BOX, SHD_MIP_KERNEL_LANCZOS));
  SHD_TRY(check_enum("mip.source", desc.source, SHD_MIP_SOURCE_BASE, SHD_MIP_SOURCE_PREVIOUS));
  SHD_TRY(check_enum("mip.content", desc.content, SHD_TEXEL_CONTENT_COLOR, SHD_TEXEL_CONTENT_ALPHA_WEIGHTED));
  SHD_TRY(check_enum("mip.wrap_u", desc.wrap_u, SHD_WRAP_REPEAT, SHD_WRAP_MIRROR_ONCE));
  SHD_TRY(check_enum("mip.wrap_v", desc.wrap_v, SHD_WRAP_REPEAT, SHD_WRAP_MIRROR_ONCE));
  SHD_TRY(check_range("mip.alpha_cutoff", static_cast<double>(desc.alpha_cutoff), 0, 1));
  if (desc.content == SHD_TEXEL_CONTENT_NORMAL && channels < 3) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "mip.content: normals need 3 or 4 channels, not %zu", channels);
  }
  if (desc.content == SHD_TEXEL_CONTENT_ALPHA_COVERAGE && channels != 4) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "mip.content: alpha coverage needs 4 channels, not %zu", channels);
  }
  if (desc.content == SHD_TEXEL_CONTENT_ALPHA_WEIGHTED && channels != 4) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "mip.content: weights by alpha need 4 channels, not %zu", channels);
  }
  return SHD_OK;
}

/// That levels overlap neither the base nor each other.
shd_result check_levels_apart(const shd_image& base, uint32_t count, const shd_image* levels) {
  for (uint32_t i = 0; i < count; ++i) {
    const shd_image level = texture::image_at(levels, i);
    char name[32], other[32];
    std::snprintf(name, sizeof name, "levels[%u]", i);
    SHD_TRY(check_apart(name, level, "base", base));
    for (uint32_t j = 0; j < i; ++j) {
      std::snprintf(other, sizeof other, "levels[%u]", j);
      SHD_TRY(check_apart(name, level, other, texture::image_at(levels, j)));
    }
  }
  return SHD_OK;
}

/// That an image has the size of another one, and memory of its own.
shd_result check_twin(const char* name, const shd_image& image, const char* other_name, const shd_image& other) {
  char field[32];
  std::snprintf(field, sizeof field, "%s.width", name);
  SHD_TRY(check_count(field, image.width, other.width, other.width));
  std::snprintf(field, sizeof field, "%s.height", name);
  SHD_TRY(check_count(field, image.height, other.height, other.height));
  return check_apart(name, image, other_name, other);
}

/// Reads an image of normals.
shd_result read_normals(const char* name, const shd_image* image, shd_image* out) {
  SHD_TRY(read_image(name, image, out));
  const size_t channels = image::format_info(out->format).channels;
  if (channels >= 3) return SHD_OK;
  return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s.format: normals need 3 or 4 channels, not %zu", name, channels);
}

shd_result check_normals_desc(const shd_normals_desc& desc) {
  SHD_TRY(check_range("normals.scale", static_cast<double>(desc.scale), -1e6, 1e6));
  SHD_TRY(check_enum("normals.slope", desc.slope, SHD_HEIGHT_SLOPE_CENTRAL, SHD_HEIGHT_SLOPE_SOBEL));
  SHD_TRY(check_enum("normals.wrap_u", desc.wrap_u, SHD_WRAP_REPEAT, SHD_WRAP_MIRROR_ONCE));
  return check_enum("normals.wrap_v", desc.wrap_v, SHD_WRAP_REPEAT, SHD_WRAP_MIRROR_ONCE);
}

/// The formats of an image of moments.
struct MomentFormats {
  shd_format half, full;
};

/// Reads an image for moments of the normals in `from`.
shd_result read_moments(const char* name, const shd_image* image, const char* channels, MomentFormats formats,
                        const shd_image& from, shd_image* to) {
  SHD_TRY(read_image(name, image, to));
  if (to->format != formats.half && to->format != formats.full) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s.format: %d is neither %s16F nor %s32F", name,
                      static_cast<int>(to->format), channels, channels);
  }
  return check_twin(name, *to, "normals", from);
}

}  // namespace

extern "C" {

shd_result shd_mip_build(shd_context* context, const shd_image* base, const shd_mip_desc* desc, size_t level_count,
                         const shd_image* levels) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_context(context));
    shd_image image;
    SHD_TRY(read_image("base", base, &image));
    SHD_TRY(check_count("base.width * base.height", uint64_t{image.width} * image.height, 1, kMaxBasePixels));
    shd_mip_desc read = shd_mip_desc_default();
    SHD_TRY(read_desc("mip", desc, false, &read));
    SHD_TRY(check_mip_desc(read, image::format_info(image.format).channels));
    SHD_TRY(check_count("level_count", level_count, 0, texture::full_level_count(image.width, image.height) - 1));
    const auto count = static_cast<uint32_t>(level_count);
    SHD_TRY(check_levels("levels", levels, 1, count, image.format, image.width, image.height));
    SHD_TRY(check_levels_apart(image, count, levels));
    texture::build_levels(context_of(context), image, read, count,
                          [&](uint32_t level) { return texture::image_at(levels, level - 1); });
    return SHD_OK;
  });
}

shd_result shd_mip_build_normals(shd_context* context, const shd_image* heights, const shd_normals_desc* desc,
                                 const shd_image* out) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_context(context));
    shd_image from, to;
    SHD_TRY(read_image("heights", heights, &from));
    SHD_TRY(check_count("heights.width * heights.height", uint64_t{from.width} * from.height, 1, kMaxBasePixels));
    shd_normals_desc read = shd_normals_desc_default();
    SHD_TRY(read_desc("normals", desc, true, &read));
    SHD_TRY(check_normals_desc(read));
    SHD_TRY(read_normals("out", out, &to));
    SHD_TRY(check_twin("out", to, "heights", from));
    texture::write_normals(context_of(context), from, read, to);
    return SHD_OK;
  });
}

shd_result shd_mip_build_moments(shd_context* context, const shd_image* normals, const shd_image* out,
                                 const shd_image* mixed) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_context(context));
    shd_image from, to, product;
    SHD_TRY(read_normals("normals", normals, &from));
    SHD_TRY(read_moments("out", out, "RGBA", {SHD_FORMAT_RGBA16F, SHD_FORMAT_RGBA32F}, from, &to));
    if (mixed) {
      SHD_TRY(read_moments("mixed", mixed, "R", {SHD_FORMAT_R16F, SHD_FORMAT_R32F}, from, &product));
      SHD_TRY(check_apart("mixed", product, "out", to));
    }
    texture::write_moments(context_of(context), from, to, mixed ? &product : nullptr);
    return SHD_OK;
  });
}

}  // extern "C"
