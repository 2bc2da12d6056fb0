// SPDX-License-Identifier: MIT
#pragma once

namespace shd::color {

/// The built-in config: YAML of OpenColorIO profile version 2. It uses only built-in transforms, no files.
extern const char kDefaultConfig[];

}  // namespace shd::color
