// SPDX-License-Identifier: MIT
#pragma once

#include <shd/extension.h>
#include <shd/image.h>

#include "core/desc_size.h"
#include "core/read_desc.h"
#include "extension/error.h"
#include "image/read_image.h"

namespace shd::extension {

/// Copies the caller's desc over the defaults in `out`; a null `in` keeps the defaults. Throws Failure.
template <class Desc>
void read_desc(const char* name, const Desc* in, Desc* out) {
  if (in) require(core::read_desc_bytes(fail, name, in, core::DescSize<Desc>::kRule, out, sizeof(Desc)));
}

/// Checks a struct that the library only writes, and clears it: calls that fail leave it zero. Stores a text.
template <class Desc>
shd_result begin_output(const char* name, Desc* out) {
  if (!out) return fail(SHD_ERROR_INVALID_ARGUMENT, "%s: NULL", name);
  const shd_result result = core::check_desc_size(fail, name, out, core::DescSize<Desc>::kRule);
  if (result == SHD_OK) core::clear_desc_bytes(out);
  return result;
}

/// Writes a struct into the caller's, which was begun by begin_output.
template <class Desc>
void write_desc(const Desc& from, Desc* to) {
  core::write_desc_bytes(&from, sizeof from, to);
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
  if (shd_context_get_worker_count(context) != 0) return;
  refuse(SHD_ERROR_INVALID_ARGUMENT, context ? "context: not a live handle" : "context: NULL");
}

}  // namespace shd::extension
