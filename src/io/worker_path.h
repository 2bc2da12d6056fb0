// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace shd::io {

/// shd-io-worker beside this library (or program, when linked statically), else in its place in the installed
/// tree around it, else where it was configured to be installed. The last one need not exist.
std::string default_worker_path();

}  // namespace shd::io
