// SPDX-License-Identifier: MIT
#pragma once

#include <shd/extension.h>
#include <shd/image.h>

#include "core/read_desc.h"
#include "extension/error.h"
#include "image/read_image.h"

namespace shd::extension {

/// Copies the caller's desc over the defaults in `out`; a null `in` keeps the defaults. Throws Failure.
template <class Desc>
void read_desc(const char* name, const Desc* in, Desc* out) {
  if (in) require(core::read_desc_bytes(fail, name, in, sizeof(Desc), out, sizeof(Desc)));
}

/// A caller's image of R8 or of four channels, with its row stride filled in. Throws Failure.
inline shd_image read_image(const char* name, const shd_image* in) {
  const auto takes = [](shd_format format) {
    return format == SHD_FORMAT_R8 || image::format_info(format).channels == 4;
  };
  shd_image image;
  require(image::read_image(fail, takes, name, in, &image));
  return image;
}

/// Throws Failure unless `context` is a live handle.
inline void require_context(const shd_context* context) {
  if (shd_context_worker_count(context) != 0) return;
  refuse(SHD_ERROR_INVALID_ARGUMENT, context ? "context: not a live handle" : "context: NULL");
}

}  // namespace shd::extension
