// SPDX-License-Identifier: MIT
#pragma once

#include <OpenImageIO/imageio.h>

#include <atomic>
#include <cstring>
#include <memory>
#include <string>

#include "core/failure.h"
#include "core/fork.h"

namespace shd::io {

/// Calls of OpenImageIO, which has locks of its own. They are attached by the functions of the module.
inline core::ForkGate g_image_files(core::ForkLevel::kImageFiles);

/// Call before pixels of a file are read or written; `format` is the name in OpenImageIO. OpenEXR gives its work to
/// threads, which a child does not have: throws Failure there.
inline void begin_pixels(const char* format) {
  static std::atomic<uint32_t> first_use{0};  // generation + 1 of the process that used OpenEXR first, or 0
  if (std::strcmp(format, "openexr") != 0) return;
  uint32_t first = 0;
  const uint32_t own = core::fork_generation() + 1;
  if (first_use.compare_exchange_strong(first, own, std::memory_order_relaxed) || first == own) return;
  core::refuse(SHD_ERROR_UNSUPPORTED, "OpenEXR: a parent of this process used it before fork() and has its threads");
}

/// An input or output whose pending errors are fetched at the end of its life, because OpenImageIO prints errors that
/// are not fetched.
template <class Handle>
struct Quiet {
  std::unique_ptr<Handle> handle;
  std::string error() {
    std::string text = handle ? handle->geterror() : std::string();
    if (text.empty()) text = OIIO::geterror();
    return text.empty() ? "no reason given" : text;
  }
  ~Quiet() {
    const core::ForkGate::Scope inside(g_image_files);
    try {
      if (handle) {
        handle->close();
        (void)handle->geterror();
      }
      handle.reset();
      (void)OIIO::geterror();
    } catch (...) {
      handle.reset();
    }
  }
};

}  // namespace shd::io
