// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "command/program.h"

namespace command {

/// The text of an option on all pages, with its values and its default.
std::string describe(const Option& option);

/// The text of --help, at most 100 columns wide.
std::string help_text(const Program& program);

/// The manual page, in the macros of man(7).
std::string manual_page(const Program& program);

/// A script that completes the options and the names of their values in bash.
std::string bash_completion(const Program& program);

}  // namespace command
