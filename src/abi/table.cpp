// SPDX-License-Identifier: MIT
#include <shd/table.h>

#include "abi/batch.h"
#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "texture/store/storage.h"
#include "texture/table/read.h"

namespace {

using namespace shd;
using namespace shd::abi;

shd_result check_table(const texture::Texture& texture, const shd_table& table) {
  const char* name = nullptr;
  switch (enum_bits(table)) {
    case SHD_TABLE_MIPMAP: name = "SHD_TABLE_MIPMAP"; break;
    case SHD_TABLE_RIPMAP: name = "SHD_TABLE_RIPMAP"; break;
    case SHD_TABLE_SUMMED_AREA: name = "SHD_TABLE_SUMMED_AREA"; break;
    default:
      return core::fail(SHD_ERROR_INVALID_ARGUMENT,
                        "table.table: %u is not SHD_TABLE_MIPMAP, SHD_TABLE_RIPMAP or SHD_TABLE_SUMMED_AREA",
                        enum_bits(table));
  }
  if (texture.tables & enum_bits(table)) return SHD_OK;
  return core::fail(SHD_ERROR_INVALID_ARGUMENT, "table.table: %s, but the texture does not have it", name);
}

shd_result check_part(const texture::Texture& texture, const shd_table_desc& desc) {
  const texture::TablePoint levels = texture::table_levels(texture, desc.table);
  SHD_TRY(check_count("table.level_u", desc.level_u, 0, levels.x - 1));
  SHD_TRY(check_count("table.level_v", desc.level_v, 0, levels.y - 1));
  if (desc.table == SHD_TABLE_MIPMAP && desc.level_u != desc.level_v) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "table.level_v: %u is not level_u, %u, of SHD_TABLE_MIPMAP",
                      desc.level_v, desc.level_u);
  }
  const uint32_t level = desc.view == SHD_TABLE_VIEW_PICTURE ? 0 : desc.level_u;
  const uint32_t images = texture.depth != 0 ? texture::level_size(texture.depth, level) : texture.layers;
  return check_count("table.layer", desc.layer, 0, images - 1);
}

shd_result read_view(const shd_texture* texture, const shd_table_desc* in, const texture::Texture** body,
                     texture::TableView* view) {
  SHD_TRY(read_handle("texture", texture, core::ObjectType::kTexture, body));
  shd_table_desc desc = shd_table_desc_default();
  SHD_TRY(read_desc("table", in, false, &desc));
  SHD_TRY(check_table(**body, desc.table));
  SHD_TRY(check_enum("table.view", desc.view, 0, SHD_TABLE_VIEW_PICTURE));
  SHD_TRY(check_part(**body, desc));
  *view = {desc.table, desc.view == SHD_TABLE_VIEW_PICTURE, desc.layer, desc.level_u, desc.level_v};
  return SHD_OK;
}

}  // namespace

extern "C" {

shd_result shd_texture_get_table_info(const shd_texture* texture, const shd_table_desc* desc,
                                      shd_table_info* out_info) {
  return guard([&]() -> shd_result {
    SHD_TRY(begin_output("out_info", out_info));
    const texture::Texture* body;
    texture::TableView view;
    SHD_TRY(read_view(texture, desc, &body, &view));
    const texture::TablePoint size = texture::table_size(*body, view);
    const texture::TablePoint levels = texture::table_levels(*body, view.table);
    const texture::TablePoint place = view.is_picture ? texture::level_place(*body, view) : texture::TablePoint{0, 0};
    shd_table_info info = shd_table_info_default();
    info.width = size.x;
    info.height = size.y;
    info.level_count_u = levels.x;
    info.level_count_v = levels.y;
    info.x = place.x;
    info.y = place.y;
    write_desc(info, out_info);
    return SHD_OK;
  });
}

shd_result shd_texture_read_table(const shd_texture* texture, const shd_table_desc* desc, const shd_f32_out* out) {
  return guard([&]() -> shd_result {
    const texture::Texture* body;
    texture::TableView view;
    SHD_TRY(read_view(texture, desc, &body, &view));
    const texture::TablePoint size = texture::table_size(*body, view);
    SHD_TRY(check_outputs<4>(out, uint64_t{size.x} * size.y));
    texture::read_table(*object_of(texture)->context, *body, view, out);
    return SHD_OK;
  });
}

}  // extern "C"
