// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace shd::bench {

/// Translates the short options: `-h` to `--help`, `--list` to `--benchmark_list_tests=true`. Prints the groups of rows
/// if --help is among the arguments; Google Benchmark then prints its own options and ends the program.
void read_usage(int argc, char** argv);

/// Returns the status of the program after `matched` rows ran. Without any, prints what was searched and where.
int status_of(size_t matched);

/// Prints the peers that this build lacks, one a line.
void print_missing_peers();

}  // namespace shd::bench
