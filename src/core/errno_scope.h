// SPDX-License-Identifier: MIT
#pragma once

#include <cerrno>

namespace shd::core {

/// Restores the host's errno at the end of a scope. For example, a failing malloc sets errno.
class ErrnoScope {
 public:
  ErrnoScope() : saved_(errno) {}
  ~ErrnoScope() { errno = saved_; }
  ErrnoScope(const ErrnoScope&) = delete;
  ErrnoScope& operator=(const ErrnoScope&) = delete;

 private:
  int saved_;
};

}  // namespace shd::core
