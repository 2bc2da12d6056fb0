// SPDX-License-Identifier: MIT
// Tables of textures, read into columns.
#pragma once

#include <vector>

#include <shd/shd.h>

#include "support/check.h"

namespace shd::tests
{

/// The fields of a shd_table_desc.
struct TablePart {
    shd_table table;
    shd_table_view view = SHD_TABLE_VIEW_LEVEL;
    uint32_t layer = 0, level_u = 0, level_v = 0;
};

inline shd_table_desc table_desc(const TablePart &part)
{
    shd_table_desc desc = shd_table_desc_default();
    desc.table = part.table;
    desc.view = part.view;
    desc.layer = part.layer;
    desc.level_u = part.level_u, desc.level_v = part.level_v;
    return desc;
}

inline shd_table_info table_info(const shd_texture *texture, const TablePart &part)
{
    const shd_table_desc desc = table_desc(part);
    shd_table_info info = shd_table_info_default();
    shd_assert_ok(shd_texture_get_table_info(texture, &desc, &info));
    return info;
}

/// A level, sums or a picture of a texture. Nothing is written behind its columns.
struct TableRead {
    shd_table_desc desc;
    shd_table_info info;
    std::vector<float> column[4];

    TableRead(const shd_texture *texture, const TablePart &part)
        : desc(table_desc(part)), info(table_info(texture, part))
    {
        const size_t count = size_t{info.width} * info.height;
        shd_f32_out out[4] = {};
        for (int c = 0; c < 4; ++c) {
            column[c].assign(count + 1, -7.0f);
            out[c].data = column[c].data();
        }
        shd_assert_ok(shd_texture_read_table(texture, &desc, out));
        for (auto &values : column) {
            assert_true(values.back() == -7.0f);
            values.pop_back();
        }
    }
    float at(int c, uint32_t x, uint32_t y) const { return column[c][size_t{y} * info.width + x]; }
};

}  // namespace shd::tests
