// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/// Bytes of a whole file. Throws Failure.
std::string read_file(const std::string& path);

/// Named columns of one length.
struct Table {
  std::vector<std::pair<std::string, std::vector<float>>> columns;

  /// Returns a column, or null.
  const std::vector<float>* find(const std::string& name) const;
  size_t rows() const { return columns.empty() ? 0 : columns.front().second.size(); }
};

/// Reads a table of lookups: a .npy file, a file of SHDLOOK1, or CSV with a line of names. `names` are the columns of
/// a .npy file of two dimensions. Throws Failure, which names the file and the place.
Table read_table(const std::string& path, const std::vector<std::string>& names);

/// Parts of read_table().
Table read_csv(const std::string& path, const std::string& bytes);
Table read_binary(const std::string& path, const std::string& bytes);
Table read_npy_table(const std::string& path, const std::string& bytes, const std::vector<std::string>& names);

/// Cuts a text at commas.
std::vector<std::string> split(const std::string& text);
