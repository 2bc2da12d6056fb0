// SPDX-License-Identifier: MIT
#include <shd/texture.h>

#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "abi/texture_desc.h"
#include "image/format.h"
#include "texture/store/storage.h"
#include "texture/store/stores.h"
#include "texture/store/tiles/tile.h"
#include "texture/support.h"
#include "texture/table/decoded.h"
#include "texture/texture.h"

namespace {

using namespace shd;
using namespace shd::abi;

shd_texture_flags flags_of(const texture::Texture& texture) {
  const shd_texture_flags state = texture.premultiplied ? SHD_TEXTURE_PREMULTIPLIED : SHD_TEXTURE_NONE;
  if (!texture.borrowed) return state;
  const bool base_only = texture.borrowed_units <= texture.width * texture.height * texture::image_count(texture);
  return state | SHD_TEXTURE_BORROW | (base_only ? 0u : uint32_t{SHD_TEXTURE_BORROW_LEVELS});
}

/// Whether a texture has texels that an update can write.
shd_result check_updatable(const texture::Texture& texture) {
  if (const char* const reason = texture::functions_of(texture.store).no_update) {
    return core::fail(SHD_ERROR_UNSUPPORTED, "texture: in %s, %s", name_of(texture.store), reason);
  }
  if (flags_of(texture) & SHD_TEXTURE_BORROW_LEVELS) {
    return core::fail(SHD_ERROR_UNSUPPORTED, "texture: its levels are borrowed, so they cannot be updated");
  }
  return SHD_OK;
}

/// The caller's texels of an update; those of a borrowed base level are there already.
shd_result read_update_texels(const texture::Texture& texture, const shd_image* in, shd_image* out) {
  if (!texture.borrowed) return read_image("texels", in, out);
  shd_image image = shd_image_default();
  SHD_TRY(read_desc("texels", in, false, &image));
  if (image.pixels) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texels.pixels: not NULL, but the base level is borrowed");
  }
  image.struct_size = sizeof image;
  image.pixels = const_cast<uint8_t*>(texture.borrowed);
  return read_image("texels", &image, out);
}

/// Texels of an update: their format, and that the rectangle lies in the base level.
shd_result check_update(const texture::Texture& texture, uint32_t layer, uint32_t x, uint32_t y,
                        const shd_image& texels) {
  SHD_TRY(check_count("layer", layer, 0, texture::image_count(texture) - 1));
  SHD_TRY(check_count("x", x, 0, texture.width - 1));
  SHD_TRY(check_count("y", y, 0, texture.height - 1));
  SHD_TRY(check_count("texels.width", texels.width, 1, texture.width - x));
  SHD_TRY(check_count("texels.height", texels.height, 1, texture.height - y));
  if (texels.format != texture.format && texels.format != texture.given_format) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texels.format: %d is not the texture's %d",
                      static_cast<int>(texels.format), static_cast<int>(texture.given_format));
  }
  return SHD_OK;
}

shd_texture_kind kind_of(const texture::Texture& texture) {
  if (texture.depth != 0) return SHD_TEXTURE_KIND_3D;
  return texture.projection != SHD_PROJECTION_NONE ? SHD_TEXTURE_KIND_DIRECTIONS : SHD_TEXTURE_KIND_2D;
}

/// Builds the tables of a texture in tiles, which loads its tiles. Without them there is no texture.
void build_tables_of_tiles(const core::Context& context, texture::Texture* body, shd_texture** texture) {
  try {
    texture::build_decoded(context, body);
  } catch (...) {
    body->tiles->source.release = nullptr;  // the caller keeps its source
    shd_texture_release(*texture);
    *texture = nullptr;
    throw;
  }
}

}  // namespace

extern "C" {

shd_result shd_texture_create(shd_context* context, const shd_texture_desc* desc, shd_texture** out_texture) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_not_null("out_texture", out_texture));
    *out_texture = nullptr;
    SHD_TRY(check_context(context));
    shd_texture_desc read = shd_texture_desc_default();
    SHD_TRY(read_desc("texture", desc, false, &read));
    SHD_TRY(check_kind_fields(&read));
    SHD_TRY(check_texture_desc(read));

    core::Context& owner = context_of(context);
    texture::Texture* body = nullptr;
    const auto build = [&](texture::Texture* made) {
      body = made;
      texture::build(owner, read, made);
      return SHD_OK;
    };
    SHD_TRY(create_handle<texture::Texture>(owner, core::ObjectType::kTexture, build, out_texture));
    if (body->tiles) {
      body->tiles->handle = object_of(*out_texture);
      body->tiles->source.release = read.tiles.release;
      build_tables_of_tiles(owner, body, out_texture);
    }
    return SHD_OK;
  });
}

void shd_texture_retain(shd_texture* texture) {
  retain_handle(texture, core::ObjectType::kTexture);
}

void shd_texture_release(shd_texture* texture) {
  release_handle(texture, core::ObjectType::kTexture);
}

shd_result shd_texture_get_info(const shd_texture* texture, shd_texture_info* out_info) {
  return guard([&]() -> shd_result {
    SHD_TRY(begin_output("out_info", out_info));
    const texture::Texture* body;
    SHD_TRY(read_handle("texture", texture, core::ObjectType::kTexture, &body));
    shd_texture_info info = shd_texture_info_default();
    info.kind = kind_of(*body);
    info.format = body->format;
    info.width = body->width;
    info.height = body->height;
    info.layer_count = body->layers;
    info.level_count = body->level_count;
    info.tables = body->tables;
    info.flags = flags_of(*body);
    info.byte_size = texture::byte_size(*body);
    if (body->decoded) info.byte_size += texture::byte_size(body->decoded->texture);
    info.depth = body->depth;
    info.projection = body->projection;
    write_desc(info, out_info);
    return SHD_OK;
  });
}

shd_result shd_texture_update(shd_texture* texture, uint32_t layer, uint32_t x, uint32_t y, const shd_image* texels) {
  return guard([&]() -> shd_result {
    texture::Texture* body;
    SHD_TRY(read_handle("texture", texture, core::ObjectType::kTexture, &body));
    SHD_TRY(check_updatable(*body));
    shd_image image;
    SHD_TRY(read_update_texels(*body, texels, &image));
    SHD_TRY(check_update(*body, layer, x, y, image));
    texture::update(*object_of(texture)->context, layer, x, y, image, body);
    return SHD_OK;
  });
}

shd_result shd_texture_read_level(const shd_texture* texture, uint32_t layer, uint32_t level, const shd_image* out) {
  return guard([&]() -> shd_result {
    const texture::Texture* body;
    SHD_TRY(read_handle("texture", texture, core::ObjectType::kTexture, &body));
    SHD_TRY(check_count("level", level, 0, body->level_count - 1));
    const uint32_t slices = texture::level_size(body->depth, level);
    SHD_TRY(check_count("layer", layer, 0, (body->depth != 0 ? slices : body->layers) - 1));
    shd_image image;
    SHD_TRY(read_pixels_or_blocks("out", out, &image));
    if (image.format != body->format) {
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "out.format: %d is not the texture's %d",
                        static_cast<int>(image.format), static_cast<int>(body->format));
    }
    const uint32_t width = texture::level_size(body->width, level), height = texture::level_size(body->height, level);
    SHD_TRY(check_count("out.width", image.width, width, width));
    SHD_TRY(check_count("out.height", image.height, height, height));
    texture::functions_of(body->store).read_level(*object_of(texture)->context, *body, layer, level, image);
    return SHD_OK;
  });
}

}  // extern "C"
