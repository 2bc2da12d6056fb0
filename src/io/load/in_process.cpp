// SPDX-License-Identifier: MIT
#include <cstring>

#include "io/file/read_file.h"
#include "io/load/isolate.h"
#include "io/load/load.h"

namespace shd::io {

Bitmap load_in_process(const Source& source, const LoadOptions& options, const Memory& memory,
                       const Deadline& deadline) {
  if (source.bytes && options.parts > Parts::kSlices) {  // only decoders of images write into the bytes
    return load(const_cast<unsigned char*>(source.bytes), source.size, options, memory, deadline, nullptr);
  }
  Buffer bytes;
  if (source.bytes) {
    bytes = Buffer(memory, source.size);
    std::memcpy(bytes.data(), source.bytes, source.size);
  } else {
    bytes = read_bytes(source.file, source.size, memory);
  }
  return load(bytes.data(), bytes.size(), options, memory, deadline, nullptr);
}

}  // namespace shd::io
