// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "core/read_desc.h"
#include "io/abi/common.h"
#include "io/abi/loads.h"
#include "io/bitmap/levels.h"
#include "io/bitmap/raw_voxels.h"
#include "io/file/numbered_path.h"
#include "io/file/printable.h"
#include "io/file/read_file.h"

namespace shd::extension {

namespace {

/// Texels of a 3D texture: [depth][height][width] of `format`.
struct Voxels {
  shd_format format = SHD_FORMAT_NONE;
  uint32_t width = 0, height = 0, depth = 0;
  io::Buffer texels;
};

shd_result make_texture(shd_context* context, const Voxels& voxels, uint32_t tables, shd_texture** out_texture) {
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = voxels.format;
  desc.width = voxels.width;
  desc.height = voxels.height;
  desc.kind = SHD_TEXTURE_KIND_3D;
  desc.depth = voxels.depth;
  desc.texels = voxels.texels.data();
  desc.tables = tables;
  return shd_texture_create(context, &desc, out_texture);
}

/// Loads of volumes accept these flags; `kind` names the load in the message.
void check_volume_load(const char* kind, const LoadRequest& request, uint32_t flags) {
  if (request.desc.flags & ~flags) {
    refuse(SHD_ERROR_UNSUPPORTED, "load.flags: bits 0x%x have no meaning for %s", request.desc.flags & ~flags, kind);
  }
  if (request.desc.tables & ~uint32_t{SHD_TABLE_MIPMAP}) {
    refuse(SHD_ERROR_UNSUPPORTED, "load.tables: 0x%x, but a 3D texture has SHD_TABLE_MIPMAP at most",
           request.desc.tables);
  }
}

void require_side(const char* field, uint32_t value) {
  if (value < 1 || value > io::kMaxSide) refuse(SHD_ERROR_INVALID_ARGUMENT, "%s: %u is not in 1..65536", field, value);
}

// Files of voxels.

shd_raw_desc read_raw_desc(const shd_raw_desc* in) {
  shd_raw_desc desc = shd_raw_desc_default();
  read_desc("raw", in, &desc);
  require_side("raw.width", desc.width);
  require_side("raw.height", desc.height);
  require_side("raw.depth", desc.depth);
  if (core::enum_bits(desc.sample) > SHD_RAW_SAMPLE_I32) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "raw.sample: %u is not a shd_raw_sample", core::enum_bits(desc.sample));
  }
  if (desc.channel_count < 1 || desc.channel_count > 4) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "raw.channel_count: %zu is not in 1..4", desc.channel_count);
  }
  if (core::enum_bits(desc.byte_order) > SHD_BYTE_ORDER_BIG) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "raw.byte_order: %u is not a shd_byte_order", core::enum_bits(desc.byte_order));
  }
  return desc;
}

/// Offset of the first voxel. Throws Failure unless the file has the size of the desc.
uint64_t find_voxels(const shd_raw_desc& raw, uint64_t bytes, uint64_t file_size) {
  const bool rest = raw.header_bytes == SHD_RAW_HEADER_REST;
  const uint64_t header = rest ? file_size - std::min(file_size, bytes) : raw.header_bytes;
  if (header <= file_size && file_size - header == bytes) return header;
  const auto wide = [](uint64_t value) { return static_cast<unsigned long long>(value); };
  refuse(SHD_ERROR_CORRUPT, "the file has %llu bytes, not %llu of a header and %llu of %u x %u x %u voxels",
         wide(file_size), wide(header), wide(bytes), raw.width, raw.height, raw.depth);
}

/// Memory for texels of this size. Throws Failure beyond the budgets.
io::Buffer allocate_texels(shd_context* context, const io::Limits& limits, const Voxels& voxels, uint64_t file_size) {
  io::check_volume(limits, voxels.width, voxels.height, voxels.depth);
  const uint64_t count = uint64_t{voxels.width} * voxels.height * voxels.depth;
  return io::Buffer(memory_of(context),
                    io::check_bytes(limits, count, shd_format_size(voxels.format), static_cast<size_t>(file_size)));
}

/// Copies bytes of a file.
void read_at(const Input& input, uint64_t at, size_t size, unsigned char* out) {
  if (input.bytes) {
    std::memcpy(out, input.bytes + at, size);
  } else {
    io::read_bytes_at(input.file.file.fd, at, size, out);
  }
}

Voxels load_voxels(shd_context* context, const Input& input, const shd_raw_desc& raw, const LoadRequest& request) {
  const io::Limits& limits = request.options.limits;
  Voxels voxels = {io::raw_format(raw.sample, raw.channel_count), raw.width, raw.height, raw.depth, {}};
  io::check_volume(limits, raw.width, raw.height, raw.depth);
  const size_t numbers = size_t{raw.width} * raw.height * raw.depth * raw.channel_count;
  const size_t bytes = numbers * io::raw_sample_size(raw.sample);
  const uint64_t header = find_voxels(raw, bytes, input.size);
  voxels.texels = allocate_texels(context, limits, voxels, input.size);
  if (io::raw_is_stored(raw.sample)) {
    read_at(input, header, bytes, voxels.texels.data());
    io::order_bytes(raw.byte_order, raw.sample, numbers, voxels.texels.data());
  } else {
    const io::Buffer stored(memory_of(context), bytes);
    read_at(input, header, bytes, stored.data());
    io::order_bytes(raw.byte_order, raw.sample, numbers, stored.data());
    io::raw_to_floats(raw.sample, numbers, stored.data(), reinterpret_cast<float*>(voxels.texels.data()));
  }
  if (request.desc.flags & SHD_LOAD_FLIP_V) {
    io::flip_rows(raw.width * shd_format_size(voxels.format), raw.height, raw.depth, voxels.texels.data());
  }
  return voxels;
}

// Stacks.

shd_stack_desc read_stack_desc(const shd_stack_desc* in) {
  shd_stack_desc desc = shd_stack_desc_default();
  read_desc("stack", in, &desc);
  if (desc.path_count > io::kMaxSide) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "stack.path_count: %zu is not in 0..65536", desc.path_count);
  }
  if (desc.path_count > 0 && !desc.paths) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "stack.paths: NULL, but path_count is %zu", desc.path_count);
  }
  for (uint32_t i = 0; i < desc.path_count; ++i) {
    if (!desc.paths[i] || !*desc.paths[i]) {
      refuse(SHD_ERROR_INVALID_ARGUMENT, "stack.paths[%u]: %s", i, desc.paths[i] ? "empty" : "NULL");
    }
  }
  if ((desc.path_count > 0) == (desc.pattern != nullptr)) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "stack.pattern: %s",
           desc.pattern ? "given together with paths" : "NULL, and no paths");
  }
  if (desc.pattern && (desc.last < desc.first || desc.last - desc.first >= io::kMaxSide)) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "stack.last: %u is not in first..first + 65535, first is %u", desc.last,
           desc.first);
  }
  return desc;
}

std::vector<std::string> stack_paths(const shd_stack_desc& desc) {
  std::vector<std::string> paths;
  if (desc.pattern) {
    const io::NumberedPath numbered(desc.pattern);
    for (uint32_t k = 0; k <= desc.last - desc.first; ++k) paths.push_back(numbered.path(desc.first + k));
  } else {
    paths.assign(desc.paths, desc.paths + desc.path_count);
  }
  return paths;
}

void check_encoding(const LoadRequest& request, shd_format format) {
  const bool bytes = format == SHD_FORMAT_R8_SRGB || format == SHD_FORMAT_RGBA8_SRGB;
  if (request.options.encoding == SHD_COLOR_ENCODING_SRGB && !bytes) {
    refuse(SHD_ERROR_UNSUPPORTED, "load.encoding: SRGB, but the slices are not of 8 bits");
  }
}

/// A file of a stack.
io::Bitmap load_slice(shd_context* context, const std::string& path, const LoadRequest& request) {
  const Input input = open_input(path.c_str(), request);
  return with_path(input, [&] { return load_bitmap(context, input, request); });
}

/// All parts of one file.
Voxels load_pages(shd_context* context, const std::string& path, LoadRequest request) {
  request.options.parts = io::Parts::kSlices;
  io::Bitmap bitmap = load_slice(context, path, request);
  return {bitmap.format, bitmap.width, bitmap.height, bitmap.depth, std::move(bitmap.pixels)};
}

/// One file a slice.
Voxels load_slices(shd_context* context, const std::vector<std::string>& paths, LoadRequest request) {
  Voxels voxels;
  request.options.parts = io::Parts::kSlice;
  size_t size = 0;  // bytes of a slice
  for (size_t k = 0; k < paths.size(); ++k) {
    const io::Bitmap slice = load_slice(context, paths[k], request);
    if (k == 0) {
      voxels = {slice.format, slice.width, slice.height, static_cast<uint32_t>(paths.size()), {}};
      size = size_t{slice.width} * slice.height * io::bitmap_pixel_size(slice.format);
      // Each file has been checked against max_ratio by itself.
      io::Limits limits = request.options.limits;
      limits.ratio = HUGE_VAL;
      voxels.texels = allocate_texels(context, limits, voxels, 0);
    }
    if (slice.width != voxels.width || slice.height != voxels.height || slice.format != voxels.format) {
      refuse(SHD_ERROR_CORRUPT, "\"%s\": slice %zu has %u x %u pixels of format %d, slice 0 has %u x %u of format %d",
             io::printable(paths[k]).c_str(), k, slice.width, slice.height, static_cast<int>(slice.format),
             voxels.width, voxels.height, static_cast<int>(voxels.format));
    }
    std::memcpy(voxels.texels.data() + k * size, slice.pixels.data(), size);
  }
  return voxels;
}

// OpenVDB.

shd_vdb_desc read_vdb_desc(const shd_vdb_desc* in) {
  shd_vdb_desc desc = shd_vdb_desc_default();
  read_desc("vdb", in, &desc);
  require_flags("vdb.flags", desc.flags, SHD_VDB_BOX);
  if (desc.grid && (!*desc.grid || std::strlen(desc.grid) > 255)) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "vdb.grid: %s", *desc.grid ? "longer than 255 bytes" : "empty");
  }
  constexpr int32_t kMost = 1 << 30;
  for (int a = 0; a < 3 && (desc.flags & SHD_VDB_BOX); ++a) {
    const int32_t low = desc.bounds_min[a], high = desc.bounds_max[a];
    if (low < -kMost || low > kMost) {
      refuse(SHD_ERROR_INVALID_ARGUMENT, "vdb.bounds_min[%d]: %d is not in -2^30..2^30", a, low);
    }
    if (high < low || high > kMost) {
      refuse(SHD_ERROR_INVALID_ARGUMENT, "vdb.bounds_max[%d]: %d is not in bounds_min..2^30, bounds_min is %d", a, high,
             low);
    }
  }
  return desc;
}

io::GridRequest grid_request(const shd_vdb_desc& desc) {
  io::GridRequest grid;
  grid.flags = desc.flags;
  std::copy(std::begin(desc.bounds_min), std::end(desc.bounds_min), grid.box_min);
  std::copy(std::begin(desc.bounds_max), std::end(desc.bounds_max), grid.box_max);
  if (desc.grid) std::memcpy(grid.name, desc.grid, std::strlen(desc.grid));
  return grid;
}

/// The centre of a voxel lies at its place in index space, and the box reaches half a voxel beyond the outer ones.
shd_vdb_info describe_grid(const io::Bitmap& bitmap) {
  const io::GridInfo& grid = bitmap.grid;
  shd_vdb_info info = shd_vdb_info_default();
  info.grid_class = static_cast<shd_vdb_class>(grid.grid_class);
  std::copy(std::begin(grid.index_min), std::end(grid.index_min), info.index_min);
  info.background = grid.background;
  info.active_voxel_count = grid.active_voxels;
  const double side[3] = {double(bitmap.width), double(bitmap.height), double(bitmap.depth)};
  for (size_t row = 0; row < 4; ++row) {
    double corner = grid.index_to_world[12 + row];
    for (size_t column = 0; column < 3; ++column) {
      const double step = grid.index_to_world[4 * column + row];
      corner += step * (grid.index_min[column] - 0.5);
      info.object_to_world[4 * column + row] = static_cast<float>(step * side[column]);
    }
    info.object_to_world[12 + row] = static_cast<float>(corner);
  }
  std::copy(std::begin(grid.name), std::end(grid.name), info.grid);
  return info;
}

}  // namespace

shd_result load_raw_texture(shd_context* context, const Input& input, const LoadRequest& request,
                            shd_texture** out_texture) {
  const shd_raw_desc desc = read_raw_desc(request.desc.raw);
  check_volume_load("a file of voxels", request, SHD_LOAD_IN_PROCESS | SHD_LOAD_FLIP_V);
  return make_texture(context, load_voxels(context, input, desc, request), request.desc.tables, out_texture);
}

shd_result load_stack_texture(shd_context* context, const LoadRequest& given, shd_texture** out_texture) {
  const std::vector<std::string> paths = stack_paths(read_stack_desc(given.desc.stack));
  LoadRequest request = given;
  check_volume_load("a stack", request, SHD_LOAD_IN_PROCESS | SHD_LOAD_PARTIAL | SHD_LOAD_FLIP_V);
  // The numbers of slices are kept unless the caller says that they are sRGB.
  if (request.options.encoding == SHD_COLOR_ENCODING_AUTO) request.options.encoding = SHD_COLOR_ENCODING_DATA;
  const Voxels voxels =
      paths.size() == 1 ? load_pages(context, paths[0], request) : load_slices(context, paths, request);
  check_encoding(request, voxels.format);
  return make_texture(context, voxels, request.desc.tables, out_texture);
}

shd_result load_grid_texture(shd_context* context, const Input& input, LoadRequest request, shd_texture** out_texture) {
  const shd_vdb_desc desc = read_vdb_desc(request.desc.vdb);
  check_volume_load("OpenVDB", request, SHD_LOAD_IN_PROCESS);
  require_format(request, SHD_FILE_FORMAT_VDB, "OpenVDB");
  request.options.parts = io::Parts::kGrid;
  request.options.grid = grid_request(desc);
  io::Bitmap bitmap = load_input(context, input, request);
  const shd_vdb_info info = describe_grid(bitmap);
  const Voxels voxels = {bitmap.format, bitmap.width, bitmap.height, bitmap.depth, std::move(bitmap.pixels)};
  const shd_result result = make_texture(context, voxels, request.desc.tables, out_texture);
  if (result == SHD_OK && request.desc.vdb_info) write_desc(info, request.desc.vdb_info);
  return result;
}

}  // namespace shd::extension
