// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

namespace shd::scene {

/// Bytes that someone else owns.
struct Bytes {
  const unsigned char* data = nullptr;
  size_t size = 0;
};

/// The files that a model names. The host decides what a name may mean, so that a reader opens nothing.
class Files {
 public:
  virtual ~Files() = default;
  /// The whole file `name`, relative to the folder of the model; null if there is none that may be read. The bytes stay
  /// until *this ends; a second call gives the same ones. Throws Failure beyond a budget and after the deadline.
  virtual const Bytes* find(const std::string& name) = 0;
};

}  // namespace shd::scene
