// SPDX-License-Identifier: MIT
#include "io/maketx/whole.h"

#include <string>

#include "command/failure.h"

Context::Context(const Options& options) {
  shd_context_desc desc = shd_context_desc_default();
  desc.worker_count = static_cast<uint32_t>(options.threads);
  check(shd_context_create(&desc, &handle), "context");
}

shd_format format_of(const Image& image) {
  for (uint32_t i = 0; i < 64; ++i) {
    const auto format = static_cast<shd_format>(i);
    const shd::image::FormatInfo info = shd::image::format_info(format);
    if (info.channels == image.channels && info.component == image.component) return format;
  }
  return SHD_FORMAT_NONE;
}

void require_memory(const Options& options, const char* option, uint64_t bytes) {
  refuse_if(bytes > options.memory, std::string(option) + " holds the image in memory: --memory " +
                                        std::to_string((bytes >> 20) + 1) + "M, not " +
                                        std::to_string(options.memory >> 20) + "M");
}
