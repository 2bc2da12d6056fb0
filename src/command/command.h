// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: command, the common base of the programs.
///
/// Input:      the options of a program, declared once: name, value, variable, text.
/// Output:     variables set from the command line; --help, the manual page and the completion of bash.
/// Invariants: uses only the public headers of shd, and core/number.h. An error is a Failure with a sentence for the
///             user and an exit code.
///             CLI11 splits the command line, and only parse.cpp includes it.
///
/// | file      | contents                                                          |
/// |-----------|-------------------------------------------------------------------|
/// | failure.h | failures, exit codes                                              |
/// | program.h | declarations of a program; run.cpp: its exit code; parse.cpp      |
/// | values.h  | readers of values: numbers, names, sizes, lists                   |
/// | names.h   | names of enum values: those of shd/names.h, with dashes           |
/// | suggest.h | the name that a misspelt word may mean                            |
/// | pages.h   | the text of --help, the manual page, the completion of bash       |
#pragma once
