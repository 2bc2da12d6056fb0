// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace shd::scene {

/// Finds the file `name` of a model that may have been written on another machine. Tries the name unchanged, relative
/// to `folder`, with the backslashes of Windows, ignoring case, and finally the bare name beside the model. Returns
/// `name` if there is no such file.
std::string find_file(const std::string& folder, const std::string& name);

}  // namespace shd::scene
