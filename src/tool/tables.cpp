// SPDX-License-Identifier: MIT
#include "tool/tables.h"

#include <algorithm>

#include "command/failure.h"
#include "tool/lights.h"
#include "tool/shadows.h"
#include "tool/textures.h"

namespace {

shd_table table_of(Table table) {
  if (table == Table::kRipmap) return SHD_TABLE_RIPMAP;
  return table == Table::kSummedArea ? SHD_TABLE_SUMMED_AREA : SHD_TABLE_MIPMAP;
}

}  // namespace

Picture show_table(shd_context* context, const Options& options) {
  shd_table_desc desc = shd_table_desc_default();
  desc.table = table_of(*options.table);
  desc.view = SHD_TABLE_VIEW_PICTURE;
  const Texture texture = options.texture == "checker" ? make_checker(context, desc.table)
                                                       : load_texture(context, options.texture, false, desc.table);
  shd_table_info info = shd_table_info_default();
  check(shd_texture_get_table_info(texture.get(), &desc, &info), "--table");
  Picture picture = blank_picture(info.width, info.height, {});
  shd_f32_out out[4];
  for (size_t c = 0; c < 4; ++c) out[c] = shd_f32_out_column(picture.rgba.data() + c, 4 * sizeof(float));
  check(shd_texture_read_table(texture.get(), &desc, out), "--table");
  return picture;
}

Picture show_shadow_map(const Stage& stage, const Frame& frame) {
  const std::vector<StageLight> lights =
      make_lights(stage.context, stage.options, stage.model, stage.bounds, frame.camera);
  const std::vector<Shadow> shadows = make_shadows(stage.context, stage.options, stage.bounds, frame.draws, lights);
  const auto cast =
      std::find_if(shadows.begin(), shadows.end(), [](const Shadow& shadow) { return shadow.get() != nullptr; });
  refuse_if(cast == shadows.end(), "--table shadow-map: no light casts a shadow");
  shd_shadow_info info = shd_shadow_info_default();
  check(shd_shadow_get_info(cast->get(), &info), "--table");
  const auto faces = static_cast<uint32_t>(info.face_count);
  std::vector<float> depths(size_t{info.width} * info.height);
  Picture picture = blank_picture(faces * info.width, info.height, {1, 1, 1, 1});
  for (uint32_t face = 0; face < faces; ++face) {
    const shd_f32_out out[2] = {shd_f32_out_column(depths.data(), 0), shd_f32_out_column(nullptr, 0)};
    check(shd_shadow_read_map(cast->get(), face, out), "--table");
    for (uint32_t i = 0; i < depths.size(); ++i) {
      const float grey = (std::min(depths[i], info.far_plane) - info.near_plane) / (info.far_plane - info.near_plane);
      std::fill_n(pixel_of(picture, face * info.width + i % info.width, i / info.width), 3, grey);
    }
  }
  return picture;
}
