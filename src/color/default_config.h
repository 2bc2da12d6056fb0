// SPDX-License-Identifier: MIT
#pragma once

namespace shd::color {

/// The built-in config: YAML of OpenColorIO profile version 2, made of built-in transforms alone (no files).
extern const char kDefaultConfig[];

}  // namespace shd::color
