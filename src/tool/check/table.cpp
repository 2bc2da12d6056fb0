// SPDX-License-Identifier: MIT
#include "tool/check/table.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "command/failure.h"
#include "core/number.h"
#include "core/regular_file.h"

std::string read_file(const std::string& path) {
  const shd::core::RegularFile opened = shd::core::open_regular(path.c_str());
  if (opened.other_kind) throw Failure(kExitInput, path + ": is not a regular file");
  if (opened.error) throw Failure(kExitInput, path + ": cannot be opened: " + std::strerror(opened.error));
  std::string bytes(static_cast<size_t>(opened.size), 0);
  int error = 0;
  bytes.resize(shd::core::read_at(opened.file.fd, 0, bytes.size(), bytes.data(), &error));
  if (error) throw Failure(kExitInput, path + ": cannot be read: " + std::strerror(error));
  return bytes;
}

const std::vector<float>* Table::find(const std::string& name) const {
  for (const auto& column : columns) {
    if (column.first == name) return &column.second;
  }
  return nullptr;
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> out(1);
  for (const char c : text) {
    if (c == ',') {
      out.emplace_back();
    } else if (c != ' ' && c != '\t' && c != '\r' && c != '"') {
      out.back() += c;
    }
  }
  return out;
}

namespace {

void add_columns(const std::string& path, const std::vector<std::string>& names, Table* table) {
  for (const std::string& name : names) {
    if (name.empty()) throw Failure(kExitInput, path + ": a column has no name");
    if (table->find(name)) throw Failure(kExitInput, path + ": two columns have the name " + name);
    table->columns.push_back({name, {}});
  }
}

float number_of(const std::string& path, size_t line, const std::string& text) {
  double value = 0;
  if (!shd::core::to_number(text, &value)) {
    throw Failure(kExitInput, path + ": line " + std::to_string(line) + ": \"" + text + "\" is not a number");
  }
  return static_cast<float>(value);
}

}  // namespace

Table read_csv(const std::string& path, const std::string& bytes) {
  Table table;
  size_t line = 0;
  for (size_t begin = 0; begin < bytes.size();) {
    const size_t end = std::min(bytes.find('\n', begin), bytes.size());
    const std::string text = bytes.substr(begin, end - begin);
    begin = end + 1;
    ++line;
    if (text.empty() || text[0] == '#' || text == "\r") continue;
    const std::vector<std::string> parts = split(text);
    if (table.columns.empty()) {
      add_columns(path, parts, &table);
      continue;
    }
    if (parts.size() != table.columns.size()) {
      throw Failure(kExitInput, path + ": line " + std::to_string(line) + " has " + std::to_string(parts.size()) +
                                    " numbers, but the first line names " + std::to_string(table.columns.size()));
    }
    for (size_t c = 0; c < parts.size(); ++c) {
      table.columns[c].second.push_back(number_of(path, line, parts[c]));
    }
  }
  if (table.columns.empty()) throw Failure(kExitInput, path + ": empty; the first line names the columns");
  return table;
}

/// "SHDLOOK1", uint32 columns, uint64 rows, the names in 16 bytes each, then each column as binary32; little-endian.
Table read_binary(const std::string& path, const std::string& bytes) {
  constexpr size_t kHeader = 20, kName = 16, kMostColumns = 64;
  uint32_t columns = 0;
  uint64_t rows = 0;
  if (bytes.size() < kHeader) throw Failure(kExitInput, path + ": shorter than the header of SHDLOOK1");
  std::memcpy(&columns, bytes.data() + 8, sizeof columns);
  std::memcpy(&rows, bytes.data() + 12, sizeof rows);
  if (columns == 0 || columns > kMostColumns) {
    throw Failure(kExitInput, path + ": " + std::to_string(columns) + " columns are not in 1..64");
  }
  const size_t first = kHeader + columns * kName;
  const bool fits = rows <= bytes.size() / 4 && bytes.size() == first + columns * rows * sizeof(float);
  if (!fits) {
    throw Failure(kExitInput, path + ": " + std::to_string(bytes.size()) + " bytes are not " + std::to_string(columns) +
                                  " columns of " + std::to_string(rows) + " rows");
  }
  Table table;
  std::vector<std::string> names;
  for (size_t c = 0; c < columns; ++c) {
    const char* const name = bytes.data() + kHeader + c * kName;
    names.emplace_back(name, strnlen(name, kName));
  }
  add_columns(path, names, &table);
  for (size_t c = 0; c < columns; ++c) {
    table.columns[c].second.resize(rows);
    if (rows) std::memcpy(table.columns[c].second.data(), bytes.data() + first + c * rows * 4, rows * 4);
  }
  return table;
}

Table read_table(const std::string& path, const std::vector<std::string>& names) {
  const std::string bytes = read_file(path);
  if (bytes.compare(0, 6, "\x93NUMPY") == 0) return read_npy_table(path, bytes, names);
  if (bytes.compare(0, 8, "SHDLOOK1") == 0) return read_binary(path, bytes);
  return read_csv(path, bytes);
}
