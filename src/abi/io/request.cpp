// SPDX-License-Identifier: MIT
#include "abi/io/request.h"

#include <cmath>

#include "abi/io/common.h"
#include "io/isolate.h"
#include "io/load.h"
#include "io/printable.h"
#include "io/read_file.h"

namespace shd::extension {

namespace {

/// A budget where 0 is the default and everything else must be positive and finite.
double positive(const char* field, double value, double standard) {
  if (value == 0) return standard;
  if (!(value > 0) || !std::isfinite(value)) refuse(SHD_ERROR_INVALID_ARGUMENT, "%s: %g is not positive", field, value);
  return value;
}

}  // namespace

void require_flags(const char* field, uint32_t value, uint32_t known) {
  if (value & ~known) refuse(SHD_ERROR_UNSUPPORTED, "%s: bits 0x%x are not known", field, value & ~known);
}

LoadRequest read_load_desc(const shd_load_desc* in) {
  LoadRequest request;
  shd_load_desc& desc = request.desc;
  read_desc("load", in, &desc);
  constexpr uint32_t kFormats = 0x1fff | SHD_FILE_FORMAT_ANY;
  require_flags("load.formats", desc.formats, kFormats);
  require_flags("load.flags", desc.flags,
                SHD_LOAD_IN_PROCESS | SHD_LOAD_PARTIAL | SHD_LOAD_FLIP_V | SHD_LOAD_FILE_LEVELS);
  if (static_cast<uint32_t>(desc.color_space) > SHD_COLOR_ENCODING_DATA) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "load.color_space: %d is not a shd_color_encoding",
           static_cast<int>(desc.color_space));
  }
  if (desc.subimage > 65535) refuse(SHD_ERROR_INVALID_ARGUMENT, "load.subimage: %u is not in 0..65535", desc.subimage);
  if (desc.worker_path && !*desc.worker_path) refuse(SHD_ERROR_INVALID_ARGUMENT, "load.worker_path: empty");
  io::LoadOptions& options = request.options;
  if (desc.formats) options.formats = desc.formats;
  options.flags = desc.flags;
  options.encoding = desc.color_space;
  options.subimage = desc.subimage;
  io::Limits& limits = options.limits;
  if (desc.max_file_bytes) limits.file_bytes = desc.max_file_bytes;
  if (desc.max_pixels) limits.pixels = desc.max_pixels;
  if (desc.max_bytes) limits.bytes = desc.max_bytes;
  limits.ratio = positive("load.max_ratio", desc.max_ratio, limits.ratio);
  limits.seconds = positive("load.time_limit", desc.time_limit, limits.seconds);
  return request;
}

bool in_process(const LoadRequest& request) {
  return (request.desc.flags & SHD_LOAD_IN_PROCESS) != 0;
}

io::Bitmap load_path(shd_context* context, const char* path, const LoadRequest& request) {
  require_path(path);
  const io::OpenFile file = io::open_file(path, request.options.limits);
  const io::Deadline deadline(request.options.limits.seconds);
  const io::Memory memory = memory_of(context);
  try {
    if (!in_process(request)) {
      const io::Source source = {file.file.fd, nullptr, file.size};
      return io::load_isolated(request.desc.worker_path, source, request.options, memory, deadline);
    }
    const io::Buffer bytes = io::read_bytes(file.file.fd, file.size, memory);
    return io::load(bytes.data(), bytes.size(), request.options, memory, deadline, nullptr);
  } catch (const Failure& failure) {
    refuse(failure.code, "\"%s\": %s", io::printable(path).c_str(), failure.what());
  }
}

}  // namespace shd::extension
