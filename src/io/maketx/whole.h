// SPDX-License-Identifier: MIT
/// @file
/// Parts of a run that holds a whole image in memory: a context of libshd, the format, and the check of --memory.
#pragma once
#include <cstdint>

#include <shd/context.h>
#include <shd/image.h>

#include "io/maketx/source.h"

/// A context with the threads of the options.
struct Context {
  explicit Context(const Options& options);
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  ~Context() { shd_context_release(handle); }
  shd_context* handle = nullptr;
};

shd_format format_of(const Image& image);

/// Throws Failure (kExitUsage) if an option needs more than --memory.
void require_memory(const Options& options, const char* option, uint64_t bytes);
