// SPDX-License-Identifier: MIT
// The only user of OpenVDB. Nothing here runs on several threads.
#include "io/vdb/vdb.h"

#include <openvdb/openvdb.h>
#include <openvdb/tools/Count.h>
#include <openvdb/tools/Dense.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/failure.h"
#include "core/printable.h"
#include "io/file/memory_file.h"
#include "io/file/printable.h"
#include "io/vdb/header.h"

namespace shd::io {

namespace {

/// Decoded between two checks of the deadline. Small slabs keep the child of a worker and its host busy concurrently.
constexpr size_t kSlabBytes = size_t{1} << 18;

/// Coordinates beyond overflow in OpenVDB.
constexpr int64_t kMaxCoordinate = int64_t{1} << 30;

/// The voxels [min, max] on each axis.
struct Box {
  int64_t min[3], max[3];
  uint64_t side(int axis) const { return static_cast<uint64_t>(max[axis] - min[axis] + 1); }
};

/// Throws Failure unless the box is within the budgets.
void check_box(const Box& box, const Limits& limits, size_t file_size) {
  for (int a = 0; a < 3; ++a) {
    if (box.min[a] > box.max[a]) core::refuse(SHD_ERROR_CORRUPT, "OpenVDB: a box that ends before it begins");
    if (box.min[a] < -kMaxCoordinate || box.max[a] > kMaxCoordinate) {
      core::refuse(SHD_ERROR_LIMIT, "OpenVDB: voxels beyond 2^30");
    }
  }
  check_volume(limits, box.side(0), box.side(1), box.side(2));
  check_bytes(limits, box.side(0) * box.side(1) * box.side(2), sizeof(float), file_size);
}

Box box_of(const openvdb::Coord& min, const openvdb::Coord& max) {
  return {{min.x(), min.y(), min.z()}, {max.x(), max.y(), max.z()}};
}

bool chooses_box(const LoadOptions& options) {
  return (options.grid.flags & SHD_VDB_BOX) != 0;
}

/// Refuses a box that the metadata of the grid declares beyond the budgets, before the tree is read.
void check_declared_box(const openvdb::GridBase& grid, const LoadOptions& options, size_t file_size) {
  using openvdb::Vec3IMetadata;
  const auto min = grid.getMetadata<Vec3IMetadata>(openvdb::GridBase::META_FILE_BBOX_MIN);
  const auto max = grid.getMetadata<Vec3IMetadata>(openvdb::GridBase::META_FILE_BBOX_MAX);
  if (!min || !max || chooses_box(options)) return;
  const Box box = box_of(openvdb::Coord(min->value()), openvdb::Coord(max->value()));
  for (int a = 0; a < 3; ++a) {
    if (box.min[a] > box.max[a]) return;  // no active voxels
  }
  check_box(box, options.limits, file_size);
}

Box choose_box(const openvdb::GridBase& grid, const LoadOptions& options, size_t file_size) {
  Box box;
  if (chooses_box(options)) {
    for (int a = 0; a < 3; ++a) {
      box.min[a] = options.grid.box_min[a];
      box.max[a] = options.grid.box_max[a];
    }
  } else {
    openvdb::CoordBBox bounds;
    if (!grid.baseTree().evalActiveVoxelBoundingBox(bounds)) {
      core::refuse(SHD_ERROR_UNSUPPORTED, "OpenVDB: the grid has no active voxels: set vdb.flags and a box");
    }
    box = box_of(bounds.min(), bounds.max());
  }
  check_box(box, options.limits, file_size);
  return box;
}

uint32_t class_of(const openvdb::GridBase& grid) {
  switch (grid.getGridClass()) {
    case openvdb::GRID_LEVEL_SET: return SHD_VDB_CLASS_LEVEL_SET;
    case openvdb::GRID_FOG_VOLUME: return SHD_VDB_CLASS_FOG_VOLUME;
    default: return SHD_VDB_CLASS_UNKNOWN;
  }
}

template <class Grid>
void describe(const Grid& grid, const Box& box, Bitmap* out) {
  GridInfo& info = out->grid;
  for (int a = 0; a < 3; ++a) info.index_min[a] = static_cast<int32_t>(box.min[a]);
  info.background = static_cast<float>(grid.background());
  info.grid_class = class_of(grid);
  info.active_voxels = openvdb::tools::countActiveVoxels(grid.tree(), false);
  // Rows of OpenVDB's matrices are columns here, because it multiplies row vectors.
  const openvdb::Mat4d map = grid.transform().baseMap()->getAffineMap()->getMat4();
  for (int i = 0; i < 16; ++i) info.index_to_world[i] = map.asPointer()[i];
  const std::string name = grid.getName();
  std::memcpy(info.name, name.c_str(), std::min(name.size(), sizeof info.name - 1));
  core::make_printable(info.name, std::strlen(info.name));
  out->format = SHD_FORMAT_R32F;
  out->width = static_cast<uint32_t>(box.side(0));
  out->height = static_cast<uint32_t>(box.side(1));
  out->depth = static_cast<uint32_t>(box.side(2));
  out->info.file_format = SHD_FILE_FORMAT_ANY;
  out->info.channel_count = 1;
  std::memcpy(out->color_space, "data", 5);
}

/// Fills slices from `first` on, of which `count` begin at `texels`.
template <class Grid>
void fill_slab(const Grid& grid, const Box& box, uint32_t first, uint32_t count, float* texels) {
  const auto coordinate = [](int64_t value) { return static_cast<int32_t>(value); };
  const openvdb::Coord min(coordinate(box.min[0]), coordinate(box.min[1]), coordinate(box.min[2] + first));
  const openvdb::Coord max(coordinate(box.max[0]), coordinate(box.max[1]), coordinate(box.min[2] + first + count - 1));
  openvdb::tools::Dense<float, openvdb::tools::LayoutXYZ> dense(openvdb::CoordBBox(min, max), texels);
  openvdb::tools::copyToDense(grid, dense, true);
}

template <class Grid>
Bitmap sample(const Grid& grid, const Box& box, const Memory& memory, const Deadline& deadline, const Sink* sink) {
  Bitmap out;
  describe(grid, box, &out);
  const size_t slice = size_t{out.width} * out.height * sizeof(float);
  if (!sink) out.pixels = Buffer(memory, slice * out.depth);
  if (sink) sink->begin(sink->owner, out, kSingle);
  const auto step = static_cast<uint32_t>(std::clamp<size_t>(kSlabBytes / slice, 1, out.depth));
  for (uint32_t z = 0; z < out.depth; z += step) {
    deadline.check();
    const uint32_t count = std::min(step, out.depth - z);
    unsigned char* const slab = sink ? sink->room(sink->owner, slice * count) : out.pixels.data() + size_t{z} * slice;
    fill_slab(grid, box, z, count, reinterpret_cast<float*>(slab));
    if (sink) sink->take(sink->owner, slab, slice * count);
  }
  return out;
}

Bitmap read_grid(const MemoryFile& memory_file, size_t size, const VdbGrid& chosen, const LoadOptions& options,
                 const Memory& memory, const Deadline& deadline, const Sink* sink) {
  openvdb::initialize();
  openvdb::io::File file(memory_file.path());
  file.open(false);
  const std::string name = openvdb::io::GridDescriptor::nameAsString(chosen.unique_name);
  check_declared_box(*file.readGridMetadata(name), options, size);
  deadline.check();
  const openvdb::GridBase::Ptr grid = file.readGrid(name);
  if (!grid->transform().isLinear()) {
    core::refuse(SHD_ERROR_UNSUPPORTED, "OpenVDB: the transform of the grid is not affine");
  }
  const Box box = choose_box(*grid, options, size);
  // A child of the worker ends without destructors. The one of a tree would start threads.
  if (sink) new openvdb::GridBase::Ptr(grid);
  if (const auto floats = openvdb::gridPtrCast<openvdb::FloatGrid>(grid)) {
    return sample(*floats, box, memory, deadline, sink);
  }
  if (const auto doubles = openvdb::gridPtrCast<openvdb::DoubleGrid>(grid)) {
    return sample(*doubles, box, memory, deadline, sink);
  }
  core::refuse(SHD_ERROR_CORRUPT, "OpenVDB: the grid has another type than its header");
}

}  // namespace

Bitmap decode_grid(const unsigned char* bytes, size_t size, const LoadOptions& options, const Memory& memory,
                   const Deadline& deadline, const Sink* sink) {
  const std::vector<VdbGrid> grids = list_vdb_grids(bytes, size);
  const VdbGrid& chosen = grids[find_vdb_grid(grids, options.grid.name[0] ? options.grid.name : nullptr)];
  const MemoryFile memory_file(true, bytes, size);
  try {
    return read_grid(memory_file, size, chosen, options, memory, deadline, sink);
  } catch (const core::Failure&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    core::refuse(SHD_ERROR_CORRUPT, "OpenVDB: %s", printable(memory_file.without_path(error.what())).c_str());
  }
}

}  // namespace shd::io
