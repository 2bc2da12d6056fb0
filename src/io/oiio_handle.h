// SPDX-License-Identifier: MIT
#pragma once

#include <OpenImageIO/imageio.h>

#include <memory>
#include <string>

namespace shd::io {

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
