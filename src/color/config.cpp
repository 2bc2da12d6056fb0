// SPDX-License-Identifier: MIT
#include "color/config.h"

#include "color/parts.h"
#include "extension/error.h"

namespace shd::color {
using extension::refuse;

std::string quoted_list(const std::vector<std::string>& names) {
  constexpr size_t kLongest = 640;
  std::string list;
  for (const std::string& name : names) {
    const std::string next = (list.empty() ? "'" : ", '") + name + "'";
    if (list.size() + next.size() > kLongest) return list + ", ...";
    list += next;
  }
  return list;
}

const Display* Catalog::find_display(const char* name) const {
  if (!name) return default_display;
  for (const Display& display : displays) {
    if (display.name == name) return &display;
  }
  return nullptr;
}

const Display& Catalog::display(const char* name) const {
  if (const Display* found = find_display(name)) return *found;
  if (!name) refuse(SHD_ERROR_NOT_FOUND, "display: the config has none");
  std::vector<std::string> names;
  for (const Display& display : displays) names.push_back(display.name);
  refuse(SHD_ERROR_NOT_FOUND, "display: no '%.128s'; there are %s", name, quoted_list(names).c_str());
}

const std::string& Catalog::view(const Display& display, const char* name) {
  const std::string wanted = name ? name : display.default_view;
  for (const std::string& view : display.views) {
    if (view == wanted) return view;
  }
  refuse(SHD_ERROR_NOT_FOUND, "view: no '%.128s' on display '%.128s'; there are %s", wanted.c_str(),
         display.name.c_str(), quoted_list(display.views).c_str());
}

template <class Build>
TransformRef Config::cached(const std::vector<std::string>& key, Build&& build) const {
  const std::lock_guard<core::ForkMutex> lock(mutex_);
  TransformRef& slot = cache_[key];
  if (!slot) slot = build();
  return slot;
}

TransformRef Config::to_display(const std::string& from, const std::string& display, const std::string& view) const {
  return cached({from, display, view}, [&] { return build_to_display(from, display, view); });
}

std::vector<Part> Config::display_parts(const std::string& from, const std::string& display,
                                        const std::string& view) const {
  const std::lock_guard<core::ForkMutex> lock(mutex_);
  return split_to_display(from, display, view);
}

TransformRef Config::between(const std::string& from, const std::string& to) const {
  return cached({from, to}, [&] { return build_between(from, to); });
}

}  // namespace shd::color
