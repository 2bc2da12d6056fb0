// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

namespace command {

/// Refuses the value of an option, and suggests the name that it may mean. The value may be a list of names.
[[noreturn]] void refuse(const std::string& option, const std::string& value, const std::string& wanted,
                         const std::vector<std::string>& names);

/// Returns ": did you mean NAME?" for the name that is nearest to a misspelt word, or "" if no name is near. Dashes in
/// front of the word and the names do not count.
std::string suggestion(const std::string& word, const std::vector<std::string>& names);

}  // namespace command
