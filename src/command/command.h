// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: command, the common base of the programs.
///
/// Invariants: uses only the public headers of shd. An error is a Failure with a sentence for the user and an exit code.
///
/// | file      | contents               |
/// |-----------|------------------------|
/// | failure.h | failures, exit codes   |
#pragma once
