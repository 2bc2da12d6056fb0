// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

namespace shd::color {

/// For each definition of a config, the definitions that it uses: name -> names.
using References = std::map<std::string, std::vector<std::string>>;

/// Throws Failure: SHD_ERROR_CORRUPT for a circle, SHD_ERROR_LIMIT for a chain longer than 64. OpenColorIO follows
/// references recursively and would overflow the stack.
void check_references(const std::string& config_name, const References& references);

}  // namespace shd::color
