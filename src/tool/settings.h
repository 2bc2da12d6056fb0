// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "command/program.h"

/// Cuts the settings of `--compare` into arguments of a command line, such as "--filter=ewa". Settings are between
/// colons, options between commas. A part that does not begin with the name of an option belongs to the value before
/// it. Throws Failure (kExitUsage).
std::vector<std::vector<std::string>> cut_settings(const std::string& text, const command::Program& program);
