// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <memory>
#include <string>

#include "io/maketx/options.h"

/// The conversion of --colorconvert, by libshd_color.
class Converter {
 public:
  virtual ~Converter() = default;
  /// Converts `count` pixels of r, g, b, a in place; alpha stays. Throws Failure.
  virtual void convert(float* pixels, size_t count) const = 0;
};

/// Path, size and time of the config of --colorconvert, for the key of an output. Empty without --colorconvert, and for
/// the built-in config.
std::string config_text(const Options& options);

/// Null without --colorconvert. Throws Failure (kExitUsage) for colour spaces that the config does not have, and in a
/// build without libshd_color.
std::unique_ptr<Converter> make_converter(const Options& options);
