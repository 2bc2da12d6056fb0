// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "color/source.h"
#include "core/fork.h"

namespace shd::color {

/// A transform that can be applied. apply() may run on several threads concurrently.
class Transform {
 public:
  virtual ~Transform() = default;
  /// Transforms planes of `count` values in place.
  virtual void apply(float* r, float* g, float* b, size_t count) const = 0;
};
using TransformRef = std::shared_ptr<const Transform>;

struct Part;

struct Display {
  std::string name;
  std::string default_view;
  std::vector<std::string> views;
};

/// The names in a config, copied once so that they can be read without a lock.
struct Catalog {
  std::vector<Display> displays;
  std::vector<std::string> spaces;
  const Display* default_display = nullptr;

  /// A null name selects the default display. Throws Failure (SHD_ERROR_NOT_FOUND) with the names of all displays.
  const Display& display(const char* name) const;
  /// A null name selects the default display. Returns null if there is no such display.
  const Display* find_display(const char* name) const;
  static const std::string& view(const Display& display, const char* name);
};

/// Names as 'a', 'b', 'c'; as many as fit into a message.
std::string quoted_list(const std::vector<std::string>& names);

/// A loaded config with a cache of the transforms built from it.
class Config {
 public:
  virtual ~Config() = default;

  /// Makes the config usable in children. Throws std::bad_alloc.
  void attach() { mutex_.attach(); }
  const Catalog& catalog() const { return catalog_; }
  /// Canonical name of a colour space, alias or role. Throws Failure (SHD_ERROR_NOT_FOUND) that names `field`.
  virtual std::string space(const char* field, const char* name) const = 0;
  /// Transform from colour space `from` to a display and view; the names must be names of the catalog.
  TransformRef to_display(const std::string& from, const std::string& display, const std::string& view) const;
  /// The parts of that transform, for baking.
  std::vector<Part> display_parts(const std::string& from, const std::string& display, const std::string& view) const;
  TransformRef between(const std::string& from, const std::string& to) const;

 protected:
  virtual TransformRef build_to_display(const std::string& from, const std::string& display,
                                        const std::string& view) const = 0;
  virtual std::vector<Part> split_to_display(const std::string& from, const std::string& display,
                                             const std::string& view) const = 0;
  virtual TransformRef build_between(const std::string& from, const std::string& to) const = 0;
  Catalog catalog_;

 private:
  template <class Build>
  TransformRef cached(const std::vector<std::string>& key, Build&& build) const;

  // guards cache_, and the building of transforms, because OpenColorIO shares its caches
  mutable core::ForkMutex mutex_{core::ForkLevel::kColorConfig};
  mutable std::map<std::vector<std::string>, TransformRef> cache_;
};

/// Parses and checks a config; throws Failure.
std::unique_ptr<Config> load_config(const Source& source);

}  // namespace shd::color
