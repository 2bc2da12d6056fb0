// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "io/maketx/options.h"

/// Whether an output is a folder for files: it ends in / or exists as one.
bool is_folder(const std::string& output);

/// The options of each file: inputs with <UDIM> become the files of the set, and names for a folder end in .tx. Throws
/// Failure for sets without files and for two files of one name.
std::vector<Options> make_jobs(const Options& options);
