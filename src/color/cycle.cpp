// SPDX-License-Identifier: MIT
#include "color/cycle.h"

#include <algorithm>

#include "extension/error.h"

namespace shd::color {
namespace {

constexpr int kLongestChain = 64;
constexpr int kInProgress = -1;

struct Walk {
  const std::string& config_name;
  const References& references;
  std::map<std::string, int> lengths;  // longest chain below a finished definition, or kInProgress

  int visit(const std::string& name, int depth) {
    const auto known = lengths.find(name);
    if (known != lengths.end()) {
      if (known->second != kInProgress) return known->second;
      extension::refuse(SHD_ERROR_CORRUPT, "%s: '%.256s' is defined in a circle", config_name.c_str(), name.c_str());
    }
    if (depth > kLongestChain) refuse_chain(name);
    lengths[name] = kInProgress;
    int longest = 0;
    const auto below = references.find(name);
    if (below != references.end()) {
      for (const std::string& next : below->second) longest = std::max(longest, 1 + visit(next, depth + 1));
    }
    if (longest > kLongestChain) refuse_chain(name);
    lengths[name] = longest;
    return longest;
  }

  [[noreturn]] void refuse_chain(const std::string& name) const {
    extension::refuse(SHD_ERROR_LIMIT, "%s: '%.256s' is defined by a chain of more than %d others", config_name.c_str(),
                      name.c_str(), kLongestChain);
  }
};

}  // namespace

void check_references(const std::string& config_name, const References& references) {
  Walk walk{config_name, references, {}};
  for (const auto& entry : references) walk.visit(entry.first, 0);
}

}  // namespace shd::color
