// SPDX-License-Identifier: MIT
#pragma once
#include <stdexcept>
#include <string>

#include <shd/result.h>

/// Exit codes, as listed by `--help`.
enum ExitCode : int { kExitOk = 0, kExitFailed = 1, kExitUsage = 2, kExitInput = 3, kExitOutput = 4 };

/// An error that ends the program: a sentence for the user and the exit code.
struct Failure : std::runtime_error {
  Failure(ExitCode exit_code, const std::string& text) : std::runtime_error(text), code(exit_code) {}
  ExitCode code;
};

/// Refuses the value of an option of the command line.
[[noreturn]] inline void refuse(const std::string& option, const std::string& value, const std::string& wanted) {
  throw Failure(kExitUsage, option + ": \"" + value + "\" is not " + wanted);
}

/// Refuses options that do not fit together.
inline void refuse_if(bool wrong, const std::string& text) {
  if (wrong) throw Failure(kExitUsage, text);
}

/// Turns a failed shd call into a Failure that names the attempted action.
inline void check(shd_result result, const std::string& what, ExitCode code = kExitFailed) {
  if (result != SHD_OK) throw Failure(code, what + ": " + shd_last_error());
}
