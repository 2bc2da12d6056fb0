// SPDX-License-Identifier: MIT
// The header of an OpenVDB file as io::Archive and io::GridDescriptor of OpenVDB write it (version 222 and later of the
// file format). OpenVDB itself believes each count and offset.
#include "io/vdb/header.h"

#include <algorithm>

#include "core/failure.h"
#include "io/file/byte_reader.h"
#include "io/file/printable.h"

namespace shd::io {

namespace {

constexpr uint32_t kOldest = 222;
constexpr uint32_t kMaxGrids = 65536;
constexpr size_t kUuid = 36;         // characters of the identity of the file
constexpr char kSeparator = '\x1e';  // between a name and the number of a further grid of the name
constexpr const char* kFloatTree = "Tree_float_5_4_3";
constexpr const char* kDoubleTree = "Tree_double_5_4_3";
constexpr const char* kHalfSuffix = "_HalfFloat";  // floats that the file stores as halves

/// Reads forwards.
struct Cursor {
  ByteReader in;
  uint64_t at = 0;

  uint64_t number(size_t size) {
    const uint64_t value = in.number(at, size);
    at += size;
    return value;
  }
  void skip(uint64_t size) {
    if (!in.has(at, size)) in.ok = false;
    if (in.ok) at += size;
  }
  std::string text() {
    const uint64_t size = number(4);
    const uint64_t start = at;
    skip(size);
    return in.ok ? std::string(reinterpret_cast<const char*>(in.bytes + start), static_cast<size_t>(size))
                 : std::string();
  }
  void require(const char* what) const {
    if (!in.ok) core::refuse(SHD_ERROR_CORRUPT, "OpenVDB: %s is cut off", what);
  }
};

void read_file_header(Cursor& cursor) {
  if (!cursor.in.is(0, " BDV\0\0\0\0", 8)) core::refuse(SHD_ERROR_UNSUPPORTED, "the content is not OpenVDB");
  cursor.skip(8);
  const auto version = static_cast<uint32_t>(cursor.number(4));
  cursor.skip(8);  // version of the library
  const bool has_offsets = cursor.number(1) != 0;
  cursor.skip(kUuid);
  cursor.require("the header");
  if (version < kOldest) {
    core::refuse(SHD_ERROR_UNSUPPORTED, "OpenVDB: version %u of the file is below %u", version, kOldest);
  }
  if (!has_offsets) core::refuse(SHD_ERROR_UNSUPPORTED, "OpenVDB: a stream, without offsets of grids");
  const auto entries = static_cast<uint32_t>(cursor.number(4));
  for (uint32_t i = 0; i < entries && cursor.in.ok; ++i) {
    (void)cursor.text();  // name and type
    (void)cursor.text();
    cursor.skip(cursor.number(4));
  }
  cursor.require("the metadata");
}

VdbGrid read_grid(Cursor& cursor) {
  VdbGrid grid = {cursor.text(), cursor.text(), cursor.text()};
  const uint64_t begin = cursor.number(8), blocks = cursor.number(8), end = cursor.number(8);
  cursor.require("a grid");
  if (end > cursor.in.size) core::refuse(SHD_ERROR_CORRUPT, "OpenVDB: a grid is cut off");
  const bool has_tree = grid.parent.empty();
  if (begin < cursor.at || end < begin || (has_tree && (blocks < begin || blocks > end))) {
    core::refuse(SHD_ERROR_CORRUPT, "OpenVDB: a grid at wrong offsets");
  }
  cursor.at = end;
  return grid;
}

/// Refuses parents that are absent or have parents themselves, because OpenVDB follows them without an end.
void check_parents(const std::vector<VdbGrid>& grids) {
  for (const VdbGrid& grid : grids) {
    if (grid.parent.empty()) continue;
    const auto parent =
        std::find_if(grids.begin(), grids.end(), [&](const VdbGrid& row) { return row.unique_name == grid.parent; });
    if (parent == grids.end() || !parent->parent.empty()) {
      core::refuse(SHD_ERROR_CORRUPT, "OpenVDB: a grid shares the tree of a grid that has none");
    }
  }
}

/// Whether a grid has this name, or the name with its number as OpenVDB prints it: density[1].
bool has_name(const VdbGrid& grid, const std::string& name) {
  const size_t end = grid.unique_name.find(kSeparator);
  const std::string base = grid.unique_name.substr(0, end);
  if (end == std::string::npos) return base == name;
  return base == name || base + "[" + grid.unique_name.substr(end + 1) + "]" == name;
}

bool is_tree(const std::string& type, const char* tree) {
  return type == tree || type == std::string(tree) + kHalfSuffix;
}

}  // namespace

std::vector<VdbGrid> list_vdb_grids(const unsigned char* bytes, size_t size) {
  Cursor cursor = {{bytes, size, false}};
  read_file_header(cursor);
  const auto count = static_cast<uint32_t>(cursor.number(4));
  cursor.require("the list of grids");
  if (count > kMaxGrids) core::refuse(SHD_ERROR_LIMIT, "OpenVDB: %u grids are above %u", count, kMaxGrids);
  std::vector<VdbGrid> grids;
  for (uint32_t i = 0; i < count; ++i) grids.push_back(read_grid(cursor));
  check_parents(grids);
  return grids;
}

size_t find_vdb_grid(const std::vector<VdbGrid>& grids, const char* name) {
  const auto usable = [](const VdbGrid& grid) { return is_tree(grid.type, kFloatTree) || is_double_tree(grid.type); };
  const auto found = std::find_if(grids.begin(), grids.end(),
                                  [&](const VdbGrid& grid) { return name ? has_name(grid, name) : usable(grid); });
  if (found == grids.end() && !name) core::refuse(SHD_ERROR_UNSUPPORTED, "OpenVDB: no grid of float or double");
  if (found == grids.end()) {
    core::refuse(SHD_ERROR_NOT_FOUND, "vdb.grid: the file has no grid \"%s\"", printable(name).c_str());
  }
  if (!usable(*found)) {
    core::refuse(SHD_ERROR_UNSUPPORTED, "vdb.grid: \"%s\" is a %s, not a grid of float or double",
                 printable(found->unique_name).c_str(), printable(found->type).c_str());
  }
  return static_cast<size_t>(found - grids.begin());
}

bool is_double_tree(const std::string& type) {
  return is_tree(type, kDoubleTree);
}

}  // namespace shd::io
