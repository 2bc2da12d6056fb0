// SPDX-License-Identifier: MIT
#pragma once

#include <shd/io.h>

#include "io/io.h"

/// Load descs, and the load of a file.
namespace shd::extension {

/// A load desc, read and checked.
struct LoadRequest {
  shd_load_desc desc = shd_load_desc_default();
  io::LoadOptions options;
};

/// Throws Failure (SHD_ERROR_UNSUPPORTED) if `value` has other bits than `known`.
void require_flags(const char* field, uint32_t value, uint32_t known);

/// Reads and checks a desc; null has the defaults. Throws Failure.
LoadRequest read_load_desc(const shd_load_desc* in);

/// Whether the load decodes in this process.
bool in_process(const LoadRequest& request);

/// Loads a file. Throws Failure that names the path.
io::Bitmap load_path(shd_context* context, const char* path, const LoadRequest& request);

}  // namespace shd::extension
