// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace shd::scene {

/// The file that a model written on another machine means by `name`: as it stands, relative to `folder`, with the
/// backslashes of Windows, whatever the case of its letters, or at last by its bare name beside the model.
/// Returns `name` when there is no such file.
std::string find_file(const std::string& folder, const std::string& name);

}  // namespace shd::scene
