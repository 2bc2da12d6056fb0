// SPDX-License-Identifier: MIT
/// @file
/// Tables as columns of linear floats, for people: one level, the sums of a layer, or a whole table as a picture.
#pragma once

#include "texture/texture.h"

namespace shd::texture {

/// A checked shd_table_desc.
struct TableView {
  shd_table table;
  bool is_picture;
  uint32_t image;  // layer or slice
  uint32_t i, j;   // level_u and level_v
};

/// A size or a place in a picture [elements].
struct TablePoint {
  uint32_t x, y;
};

/// Returns the number of levels across and down.
TablePoint table_levels(const Texture& texture, shd_table table);

/// Returns the size of what a view reads.
TablePoint table_size(const Texture& texture, const TableView& view);

/// Returns the place of the view's level in the picture of the table.
TablePoint level_place(const Texture& texture, const TableView& view);

/// Reads a view into four columns of table_size() elements; columns without data are left out. Throws std::bad_alloc,
/// or Failure if a tile does not load.
void read_table(const core::Context& context, const Texture& texture, const TableView& view, const shd_f32_out* out);

}  // namespace shd::texture
