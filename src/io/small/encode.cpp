// SPDX-License-Identifier: MIT
// Encoding without OpenImageIO.
#include <cstring>

#include "core/failure.h"
#include "io/small/rows.h"

namespace shd::io {

namespace {

struct Writer {
  const char* name;
  std::vector<unsigned char> (*encode)(const EncodeJob& job);
};

constexpr Writer kWriters[] = {{"png", encode_png}, {"hdr", encode_hdr}};

}  // namespace

std::vector<unsigned char> encode(const EncodeJob& job) {
  for (const Writer& writer : kWriters) {
    if (std::strcmp(writer.name, job.writer) == 0) return writer.encode(job);
  }
  core::refuse(SHD_ERROR_UNSUPPORTED, "this build writes .png and .hdr, because it has no OpenImageIO for %s",
               job.writer);
}

}  // namespace shd::io
