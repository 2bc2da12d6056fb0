// SPDX-License-Identifier: MIT
#include "command/suggest.h"

#include <algorithm>
#include <utility>

#include "command/values.h"

namespace command {
namespace {

std::string without_dashes(const std::string& name) {
  return name.substr(std::min(name.find_first_not_of('-'), name.size()));
}

/// The number of letters to insert, remove, replace or swap with their neighbour. Damerau, "A technique for computer
/// detection and correction of spelling errors" (1964), in the form of the optimal string alignment.
size_t distance(const std::string& a, const std::string& b) {
  std::vector<size_t> before, last, row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    before = std::exchange(last, row);
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

std::string suggestion(const std::string& word, const std::vector<std::string>& names) {
  const std::string given = without_dashes(word);
  size_t nearest = (given.size() + 1) / 4 + 1;  // mistakes that are too many
  std::string found;
  for (const std::string& name : names) {
    const std::string plain = without_dashes(name);
    const bool begun = given.size() > 2 && plain.compare(0, given.size(), given) == 0;
    const size_t mistakes = begun ? 1 : distance(given, plain);
    if (mistakes >= nearest || mistakes >= plain.size()) continue;
    nearest = mistakes;
    found = name;
  }
  return found.empty() ? "" : ": did you mean " + found + "?";
}

void refuse(const std::string& option, const std::string& value, const std::string& wanted,
            const std::vector<std::string>& names) {
  std::string hint;
  for (const std::string& part : split(value, ',')) {
    const bool known = std::find(names.begin(), names.end(), part) != names.end();
    if (!known && hint.empty()) hint = suggestion(part, names);
  }
  ::refuse(option, value, wanted + hint);
}

}  // namespace command
