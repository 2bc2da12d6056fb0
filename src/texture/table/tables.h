// SPDX-License-Identifier: MIT
/// @file
/// Contract of table/: the tables that filters read beside the base: mip levels, ripmap levels and sums of areas. They
/// are built from level 0 when a texture is made, and again over the texels that an update writes (build.cpp,
/// update.cpp). Images of the caller are made from images of the caller by the same code: mip levels (mip_build.h),
/// normals of heights (height_normals.h) and moments of normals (normal_moments.h). read.h copies tables out.
#pragma once

#include "texture/store/storage.h"

namespace shd::texture {

/// Returns whether shd built the mip levels. Otherwise the texture has none, or the caller gave them.
inline bool has_built_levels(const Texture& texture) {
  return texture.tables & SHD_TABLE_MIPMAP && !texture.levels_given;
}

/// Returns the number of unrounded averages that build_mip_levels() keeps for one layer.
size_t mip_sums_size(const Texture& texture);

/// Computes the levels 1.. of a layer over a region of the base, from level 0 of the layer (mip.cpp).
/// Every texel is the average of the base level over its area, in linear light, rounded once to the stored format:
/// unorm and binary16 to nearest even, binary32 to nearest, sRGB to the nearest code.
/// `sums` [mip_sums_size()] holds unrounded averages. Averages over the region are written. Averages over the rest of
/// the layer are read; an earlier call for the same layer has written them.
void build_mip_levels(const core::Context& context, Texture* texture, uint32_t layer, const Region& region,
                      double* sums);

/// Returns the box of all texels of the base of a 3D texture.
inline Box whole_box(const Texture& texture) {
  return {{0, texture.width}, {0, texture.height}, {0, texture.depth}};
}

/// mip_sums_size() and build_mip_levels() of a 3D texture, over a box of the base (mip_slices.cpp).
size_t slice_sums_size(const Texture& texture);
void build_slice_levels(const core::Context& context, Texture* texture, const Box& box, double* sums);

/// Returns the number of doubles that build_ripmap_levels() needs as scratch.
size_t ripmap_scratch_size(const core::Context& context, const Texture& texture);

/// Computes the ripmap levels of a layer over a region of the base, from level 0 of the layer (ripmap.cpp). Texels are
/// averages like those of build_mip_levels(). Reads all columns of the base rows under these texels.
void build_ripmap_levels(const core::Context& context, Texture* texture, uint32_t layer, const Region& region,
                         double* scratch);

}  // namespace shd::texture
