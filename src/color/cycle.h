// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

namespace shd::color {

/// Which definitions a definition in a config leans on: name -> names.
using References = std::map<std::string, std::vector<std::string>>;

/// Throws CORRUPT for a circle and LIMIT for a chain longer than 64. OpenColorIO follows references by recursion
/// and would overflow the stack.
void check_references(const std::string& config_name, const References& references);

}  // namespace shd::color
