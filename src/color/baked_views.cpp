// SPDX-License-Identifier: MIT
#include "color/baked_views.h"

#include <cstdio>
#include <tuple>

#include "color/bake.h"
#include "core/failure.h"
#include "core/fp_env.h"
#include "core/printable.h"

namespace shd::color {
namespace {

constexpr int kLargestDeviation = 3;
constexpr size_t kChannelsPerOneAbove = 1000;  // one channel in 1000 may differ by more than one code

bool is_within_bound(const Deviation& deviation) {
  return deviation.largest <= kLargestDeviation && deviation.above_one * kChannelsPerOneAbove <= deviation.channels;
}

}  // namespace

bool ViewKey::operator<(const ViewKey& other) const {
  return std::tie(from, display, view) < std::tie(other.from, other.display, other.view);
}

bool BakedViews::find_baked(const ViewKey& key, const Program** out) const {
  const std::lock_guard<core::ForkMutex> lock(mutex_);
  const auto found = programs_.find(key);
  if (found == programs_.end()) return false;
  *out = found->second.get();
  return true;
}

const Program* BakedViews::find(const ViewKey& key, const Transform& exact) const {
  const Program* found = nullptr;
  if (find_baked(key, &found)) return found;
  std::string warning;
  std::unique_ptr<Program> program = bake_within_bound(key, exact, &warning);  // without the lock: it calls the host
  bool first = false;
  {
    const std::lock_guard<core::ForkMutex> lock(mutex_);
    const auto placed = programs_.try_emplace(key, std::move(program));
    first = placed.second;
    found = placed.first->second.get();
  }
  if (first && !found) shd_context_log(context_, SHD_LOG_LEVEL_WARNING, warning.c_str());
  return found;
}

std::unique_ptr<Program> BakedViews::bake_within_bound(const ViewKey& key, const Transform& exact,
                                                       std::string* warning) const {
  const core::FpScope environment;
  char reason[96] = "a part of it fits no table";
  std::vector<Part> parts;
  try {
    parts = config_.display_parts(key.from, key.display, key.view);
  } catch (const core::Failure&) {
    parts.assign(1, Part());  // OpenColorIO cannot split it
  }
  for (int size = 0; size < kTableSizes; ++size) {
    std::unique_ptr<Program> program = bake(context_, parts, size);
    if (!program) break;
    const Deviation deviation = measure(*program, exact);
    if (is_within_bound(deviation)) return program;
    std::snprintf(reason, sizeof reason, "off by up to %d codes, %zu of %zu channels by more than 1", deviation.largest,
                  deviation.above_one, deviation.channels);
  }
  char line[512];
  std::snprintf(
      line, sizeof line,
      "color: view '%.96s' of display '%.96s' from '%.96s' is not baked: %s; 8-bit images take the exact path",
      key.view.c_str(), key.display.c_str(), key.from.c_str(), reason);
  core::make_printable(line, std::char_traits<char>::length(line));
  *warning = line;
  return nullptr;
}

}  // namespace shd::color
