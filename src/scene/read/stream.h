// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include "scene/read/fields.h"

/// Values of fields.h as bytes. Numbers are those of the processor, because both ends are one machine.
namespace shd::scene {

template <class T>
constexpr bool kIsBlock = std::is_arithmetic_v<T> || std::is_enum_v<T>;
static_assert(sizeof(Matrix) == 16 * sizeof(double));

/// Writes values by `send`, void send(const void* bytes, size_t size).
template <class Send>
class FieldWriter {
 public:
  explicit FieldWriter(Send send) : send_(send) {}

  template <class T>
  void operator()(T& value) {
    if constexpr (kIsBlock<T>) {
      send_(&value, sizeof value);
    } else {
      fields(*this, value);
    }
  }
  template <class T, size_t N>
  void operator()(T (&values)[N]) {
    send_(values, sizeof values);
  }
  template <class T, size_t N>
  void operator()(std::array<T, N>& values) {
    block(values.data(), N);
  }
  template <class T>
  void operator()(std::vector<T>& values) {
    count(values.size());
    block(values.data(), values.size());
  }
  void operator()(std::string& text) {
    count(text.size());
    send_(text.data(), text.size());
  }

 private:
  void count(uint64_t number) { send_(&number, sizeof number); }
  template <class T>
  void block(T* values, size_t size) {
    if constexpr (kIsBlock<T> || std::is_same_v<T, Matrix>) {
      send_(values, size * sizeof(T));
    } else {
      for (size_t i = 0; i < size; ++i) (*this)(values[i]);
    }
  }
  Send send_;
};

/// Reads untrusted values by `receive`, void receive(void* bytes, size_t size). All vectors and strings together have
/// at most `budget` bytes. Throws Failure.
template <class Receive>
class FieldReader {
 public:
  FieldReader(Receive receive, uint64_t budget) : receive_(receive), left_(budget) {}

  template <class T>
  void operator()(T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      uint8_t byte = 0;
      receive_(&byte, 1);
      value = byte != 0;
    } else if constexpr (kIsBlock<T>) {
      receive_(&value, sizeof value);
    } else {
      fields(*this, value);
    }
  }
  template <class T, size_t N>
  void operator()(T (&values)[N]) {
    receive_(values, sizeof values);
  }
  template <class T, size_t N>
  void operator()(std::array<T, N>& values) {
    block(values.data(), N);
  }
  template <class T>
  void operator()(std::vector<T>& values) {
    values.resize(count(sizeof(T)));
    block(values.data(), values.size());
  }
  void operator()(std::string& text) {
    text.resize(count(1));
    receive_(text.data(), text.size());
  }

 private:
  size_t count(size_t size_of_each) {
    uint64_t number = 0;
    receive_(&number, sizeof number);
    if (number > left_ / size_of_each) {
      core::refuse(SHD_ERROR_LIMIT, "the contents of the model are above scene.max_reader_bytes");
    }
    left_ -= number * size_of_each;
    return static_cast<size_t>(number);
  }
  template <class T>
  void block(T* values, size_t size) {
    if constexpr (kIsBlock<T> || std::is_same_v<T, Matrix>) {
      receive_(values, size * sizeof(T));
    } else {
      for (size_t i = 0; i < size; ++i) (*this)(values[i]);
    }
  }
  Receive receive_;
  uint64_t left_;
};

}  // namespace shd::scene
