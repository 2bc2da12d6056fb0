// SPDX-License-Identifier: MIT
#include "tool/settings.h"

#include <algorithm>

#include "command/suggest.h"
#include "command/values.h"

namespace {

/// Options of the whole picture, and those that do not change it.
constexpr const char* kShared[] = {"output",      "compression", "size",       "hash",      "aov",     "aovs",
                                   "cryptomatte", "compare",     "difference", "zoom",      "display", "view",
                                   "no-color",    "dither",      "turntable",  "animation", "time",    "frames",
                                   "threads",     "simd",        "progress",   "stats"};

std::vector<std::string> option_names(const command::Program& program) {
  std::vector<std::string> names;
  for (const command::Group& group : program.groups) {
    for (const command::Option& option : group.options) {
      names.push_back(command::split(option.names, ',').back().substr(2));
    }
  }
  return names;
}

/// The name at the front of a part: letters and dashes up to its end or to "=". Empty if there is none.
std::string name_of(const std::string& part) {
  const size_t dashes = part.rfind("--", 0) == 0 ? 2 : 0;
  const size_t end = std::min(part.find('='), part.size());
  const std::string name = part.substr(dashes, end - dashes);
  const bool is_name = name.find_first_not_of("abcdefghijklmnopqrstuvwxyz-") == std::string::npos;
  return is_name ? name : "";
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Whether a part begins an option, rightly named or not.
bool begins_option(const std::vector<std::string>& names, const std::string& part) {
  const std::string name = name_of(part);
  return contains(names, name) || (!name.empty() && part.find('=') != std::string::npos);
}

void add_part(const std::vector<std::string>& names, const std::string& part, std::vector<std::string>& setting) {
  if (!setting.empty() && !begins_option(names, part)) {
    setting.back() += "," + part;
    return;
  }
  const std::string name = name_of(part);
  const std::string given = name.empty() ? part : name;
  const bool is_shared = std::find(std::begin(kShared), std::end(kShared), name) != std::end(kShared);
  refuse_if(is_shared, "--compare: --" + name + " is the same for all pictures");
  refuse_if(!contains(names, name),
            "--compare: \"" + given + "\" is not an option" + command::suggestion(given, names));
  setting.push_back((part.rfind("--", 0) == 0 ? "" : "--") + part);
}

}  // namespace

std::vector<std::vector<std::string>> cut_settings(const std::string& text, const command::Program& program) {
  const std::vector<std::string> names = option_names(program);
  std::vector<std::vector<std::string>> settings;
  for (const std::string& piece : command::split(text, ':')) {
    const bool begins = piece.empty() || begins_option(names, command::split(piece, ',').front());
    if (!settings.empty() && !begins && !settings.back().empty()) {
      settings.back().back() += ":";
    } else {
      settings.emplace_back();
    }
    std::vector<std::string>& setting = settings.back();
    if (piece.empty()) continue;
    bool continues = !setting.empty();
    for (const std::string& part : command::split(piece, ',')) {
      if (continues) {
        setting.back() += part;
        continues = false;
      } else {
        add_part(names, part, setting);
      }
    }
  }
  return settings;
}
