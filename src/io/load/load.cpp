// SPDX-License-Identifier: MIT
#include "io/load/load.h"

#include "core/failure.h"
#include "io/check/jpeg_header.h"
#include "io/check/scrub.h"
#include "io/check/sniff.h"
#include "io/codec/codec.h"
#include "io/container/texture_load.h"
#include "io/vdb/vdb.h"

namespace shd::io {

shd_file_format accept(const unsigned char* bytes, size_t size, const LoadOptions& options) {
  if (size == 0) core::refuse(SHD_ERROR_CORRUPT, "the file is empty");
  shd_file_format format = sniff(bytes, size);
  const bool any = (options.formats & SHD_FILE_FORMAT_ANY) != 0;
  if (format == SHD_FILE_FORMAT_NONE) {
    if (!any) core::refuse(SHD_ERROR_UNSUPPORTED, "the content is of no known image format");
    return SHD_FILE_FORMAT_ANY;
  }
  if (!any && (options.formats & static_cast<uint32_t>(format)) == 0) {
    core::refuse(SHD_ERROR_UNSUPPORTED, "the content is %s, which load.formats does not allow", format_name(format));
  }
  check_header(format, bytes, size, options.limits);
  return format;
}

Bitmap load(unsigned char* bytes, size_t size, const LoadOptions& options, const Memory& memory,
            const Deadline& deadline, const Sink* sink) {
  if (options.parts == Parts::kGrid) return decode_grid(bytes, size, options, memory, deadline, sink);
  if (options.parts == Parts::kTexture || options.parts == Parts::kTextureImage) {
    return load_texture_file(bytes, size, options, memory, sink);
  }
  const shd_file_format format = accept(bytes, size, options);
  const bool complete = format != SHD_FILE_FORMAT_JPEG || jpeg_is_complete(bytes, size);
  const bool strict = (options.flags & SHD_LOAD_PARTIAL) == 0;
  if (!complete && strict) core::refuse(SHD_ERROR_CORRUPT, "JPEG: the end is missing");
  const size_t scrubbed = scrub(format, bytes, size, strict);
  // Checked again as the decoder will see it: removed segments could have hidden another frame header.
  if (format == SHD_FILE_FORMAT_JPEG) {
    check_jpeg_header(bytes, scrubbed, size, options.limits);
    check_jpeg_scans(bytes, scrubbed);
  }
  return decode({format, bytes, scrubbed, size, complete}, options, memory, deadline, sink);
}

}  // namespace shd::io
