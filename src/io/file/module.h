// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>

#include <shd/result.h>

#include "core/failure.h"
#include "core/guard.h"

namespace shd::io {

/// Opens a module in its place in the installed tree, otherwise beside this library, and returns its variable `symbol`,
/// which begins with a version. Throws Failure; a later call tries again.
const void* open_module(const char* file, const char* symbol);

/// Throws what a function of a module has returned as a result with a text.
void require_module_ok(shd_result result, const char* text);

/// Runs the body of a function of a module: exceptions become a result, and a text of core::kErrorTextSize bytes.
template <class Body>
shd_result contain(char* text, Body&& body) noexcept {
  const auto report = [text](shd_result code, const char* what) {
    std::snprintf(text, core::kErrorTextSize, "%s", what);
    return code;
  };
  return core::guard(report, [&] {
    body();
    return SHD_OK;
  });
}

}  // namespace shd::io
