// SPDX-License-Identifier: MIT
/// @file
/// NumPy's .npy files ("NEP 1: A Simple File Format for NumPy Arrays").
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// A field of a structured array, or the whole element.
struct NpyField {
  std::string name;  // empty = not structured
  char kind;         // 'f' or 'u'
  size_t size;       // bytes
  size_t offset;     // in an element [bytes]
};

/// An array in row-major order, little-endian. `data` points into the bytes of the file.
struct Npy {
  std::vector<NpyField> fields;
  std::vector<size_t> shape;
  size_t element_size, count;
  const char* data;
};

/// Throws Failure if the bytes are no array that this program can read.
Npy parse_npy(const std::string& path, const std::string& bytes);

/// Returns element i of a field of an array.
double npy_value(const Npy& array, const NpyField& field, size_t i);
