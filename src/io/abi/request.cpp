// SPDX-License-Identifier: MIT
#include "io/abi/request.h"

#include <algorithm>
#include <cmath>

#include "io/abi/common.h"
#include "io/file/printable.h"
#include "io/file/read_file.h"
#include "io/load/isolate.h"
#include "io/load/load.h"

namespace shd::extension {

namespace {

uint64_t budget(const char* field, uint64_t value) {
  if (value == 0) refuse(SHD_ERROR_INVALID_ARGUMENT, "%s: 0 is below 1", field);
  return value;
}

double positive(const char* field, double value) {
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
  constexpr uint32_t kFormats = 0x7fff | SHD_FILE_FORMAT_ANY;
  require_flags("load.formats", desc.formats, kFormats);
  if (!desc.formats) refuse(SHD_ERROR_INVALID_ARGUMENT, "load.formats: 0 accepts no format");
  require_flags("load.flags", desc.flags,
                SHD_LOAD_IN_PROCESS | SHD_LOAD_PARTIAL | SHD_LOAD_FLIP_V | SHD_LOAD_FILE_LEVELS | SHD_LOAD_LINEAR |
                    SHD_LOAD_ALPHA_WEIGHTED | SHD_LOAD_PREMULTIPLY);
  if (desc.flags & SHD_LOAD_ALPHA_WEIGHTED && desc.flags & SHD_LOAD_PREMULTIPLY) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "load.flags: both SHD_LOAD_ALPHA_WEIGHTED and SHD_LOAD_PREMULTIPLY");
  }
  if (static_cast<uint32_t>(desc.encoding) > SHD_COLOR_ENCODING_DATA) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "load.encoding: %d is not a shd_color_encoding",
           static_cast<int>(desc.encoding));
  }
  if (desc.subimage > 65535) refuse(SHD_ERROR_INVALID_ARGUMENT, "load.subimage: %u is not in 0..65535", desc.subimage);
  if (desc.worker_path && !*desc.worker_path) refuse(SHD_ERROR_INVALID_ARGUMENT, "load.worker_path: empty");
  io::LoadOptions& options = request.options;
  options.formats = desc.formats;
  options.flags = desc.flags;
  options.encoding = desc.encoding;
  options.subimage = desc.subimage;
  io::Limits& limits = options.limits;
  limits.file_bytes = budget("load.max_file_bytes", desc.max_file_bytes);
  limits.pixels = budget("load.max_pixels", desc.max_pixels);
  limits.bytes = budget("load.max_bytes", desc.max_bytes);
  limits.ratio = positive("load.max_ratio", desc.max_ratio);
  limits.seconds = positive("load.time_limit", desc.time_limit);
  return request;
}

bool in_process(const LoadRequest& request) {
  return (request.desc.flags & SHD_LOAD_IN_PROCESS) != 0;
}

Input open_input(const char* path, const LoadRequest& request) {
  require_path(path);
  Input input;
  input.file = io::open_file(path, request.options.limits);
  input.path = path;
  input.size = input.file.size;
  return input;
}

Input memory_input(const void* bytes, size_t size, const LoadRequest& request) {
  if (!bytes) refuse(SHD_ERROR_INVALID_ARGUMENT, "bytes: NULL");
  if (size > request.options.limits.file_bytes) {
    refuse(SHD_ERROR_LIMIT, "size: %zu bytes are above load.max_file_bytes %llu", size,
           static_cast<unsigned long long>(request.options.limits.file_bytes));
  }
  Input input;
  input.bytes = static_cast<const unsigned char*>(bytes);
  input.size = size;
  return input;
}

void refuse_path(const Input& input, const Failure& failure) {
  refuse(failure.code, "\"%s\": %s", io::printable(input.path).c_str(), failure.what());
}

io::Container container_of(const Input& input) {
  if (!input.path) return io::container_of(input.bytes, input.size);
  unsigned char first[io::kContainerBytes] = {};
  const size_t size = std::min(input.size, sizeof first);
  io::read_bytes_at(input.file.file.fd, 0, size, first);
  return io::container_of(first, size);
}

io::Bitmap load_input(shd_context* context, const Input& input, const LoadRequest& request) {
  const io::Deadline deadline(request.options.limits.seconds);
  const io::Memory memory = memory_of(context);
  const bool image = request.options.parts <= io::Parts::kSlices;
  // The header of bytes in memory is checked before a copy or a worker costs anything.
  if (input.bytes && image) io::accept(input.bytes, input.size, request.options);
  const io::Source source = {input.bytes ? -1 : input.file.file.fd, input.bytes, input.size};
  return in_process(request) ? io::load_in_process(source, request.options, memory, deadline)
                             : io::load_isolated(request.desc.worker_path, source, request.options, memory, deadline);
}

}  // namespace shd::extension
