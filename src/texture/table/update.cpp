// SPDX-License-Identifier: MIT
#include "texture/store/rows.h"
#include "texture/table/summed_area.h"
#include "texture/table/tables.h"

namespace shd::texture {
namespace {

/// Memory of an update, allocated before anything is written.
struct Scratch {
  core::Array<double> mip_sums;  // the texture takes these two
  core::Array<uint32_t> mip_sums_ready;
  core::Array<double> ripmap;            // scratch of build_ripmap_levels()
  core::Array<uint32_t> nonfinite_sums;  // the texture takes it if it needs the table
};

Scratch make_scratch(const core::Context& context, const Texture& texture) {
  Scratch scratch;
  if (has_built_levels(texture) && texture.mip_sums_ready.size() == 0) {
    const size_t size = core::checked_mul(mip_sums_size(texture), texture.layers);
    scratch.mip_sums = core::Array<double>(context.allocator, size);
    scratch.mip_sums_ready = core::Array<uint32_t>(context.allocator, texture.layers);
    scratch.mip_sums_ready.fill_zero();
  }
  if (texture.tables & SHD_TABLE_RIPMAP) {
    scratch.ripmap = core::Array<double>(context.allocator, ripmap_scratch_size(context, texture));
  }
  if (texture.tables & SHD_TABLE_SUMMED_AREA && spare_sums_size(texture) > 0) {
    scratch.nonfinite_sums = core::Array<uint32_t>(context.allocator, spare_sums_size(texture));
  }
  return scratch;
}

/// Rebuilds the mip levels over a region, or of the whole layer if its sums are missing. The sums count as missing
/// until the rebuild is complete, so that the next update repairs a layer after a failed update.
void update_mip_levels(const core::Context& context, uint32_t image, const Region& region, Texture* texture) {
  const uint32_t layer = texture->depth != 0 ? 0 : image;  // a 3D texture has one layer
  uint32_t& ready = texture->mip_sums_ready[layer];
  const size_t size = mip_sums_size(*texture);
  const bool partial = size == 0 || ready;
  ready = 0;
  double* sums = texture->mip_sums.data() + layer * size;
  if (texture->depth != 0) {
    const Box box = {region.x, region.y, {image, image + 1}};
    build_slice_levels(context, texture, partial ? box : whole_box(*texture), sums);
  } else {
    build_mip_levels(context, texture, layer, partial ? region : whole(*texture), sums);
  }
  ready = 1;
}

/// Rebuilds all tables that depend on a region of the base of a layer or slice.
void rebuild(const core::Context& context, uint32_t layer, const Region& region, Scratch* scratch, Texture* texture) {
  if (has_built_levels(*texture)) update_mip_levels(context, layer, region, texture);
  if (texture->tables & SHD_TABLE_RIPMAP) build_ripmap_levels(context, texture, layer, region, scratch->ripmap.data());
  if (texture->tables & SHD_TABLE_SUMMED_AREA) update_summed_area(context, layer, &scratch->nonfinite_sums, texture);
}

}  // namespace

void update(const core::Context& context, uint32_t layer, uint32_t x, uint32_t y, const shd_image& texels,
            Texture* texture) {
  Scratch scratch = make_scratch(context, *texture);
  if (scratch.mip_sums_ready.size() > 0) {
    texture->mip_sums = static_cast<core::Array<double>&&>(scratch.mip_sums);
    texture->mip_sums_ready = static_cast<core::Array<uint32_t>&&>(scratch.mip_sums_ready);
  }
  const Region region = {{x, x + texels.width}, {y, y + texels.height}};
  if (texture->borrowed) return rebuild(context, layer, region, &scratch, texture);
  const GivenTexels given = {static_cast<const uint8_t*>(texels.pixels), texels.row_stride,
                             image::format_info(texels.format)};
  for_rows(context, region.y, [&](uint32_t row, uint32_t) {
    copy_rows(given, layer, 0, region, {row, row + 1}, texture);
  });
  rebuild(context, layer, region, &scratch, texture);
}

}  // namespace shd::texture
