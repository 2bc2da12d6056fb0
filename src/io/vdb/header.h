// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace shd::io {

/// A grid of an OpenVDB file.
struct VdbGrid {
  std::string unique_name;  // as stored: the name, and for a second grid of the name a separator and a number
  std::string type;         // type of its tree
  std::string parent;       // unique name of the grid whose tree it shares; empty = it has its own
};

/// Lists the grids of an OpenVDB file, in its order. Throws Failure unless the bytes have the header of one, each grid
/// lies within them, and parents are grids with a tree of their own.
std::vector<VdbGrid> list_vdb_grids(const unsigned char* bytes, size_t size);

/// Number of the grid that a load means: of the name, or for a null `name` the first one of float or double. Throws
/// Failure if there is none, or it has another type.
size_t find_vdb_grid(const std::vector<VdbGrid>& grids, const char* name);

/// Whether a type of trees has doubles.
bool is_double_tree(const std::string& type);

}  // namespace shd::io
