// SPDX-License-Identifier: MIT
#include "tool/check/case.h"

#include <algorithm>
#include <numeric>

#include "command/failure.h"
#include "command/names.h"

const std::array<const char*, kInputs> kInputNames = {"u",    "v",    "w",    "dudx", "dvdx",     "dwdx",
                                                      "dudy", "dvdy", "dwdy", "lod",  "reference"};
const std::array<const char*, 4> kChannelNames = {"r", "g", "b", "a"};

namespace {

template <class Names>
bool contains(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

uint32_t layer_of(float value) {
  return value >= 0.0f && value < 65536.0f ? static_cast<uint32_t>(value) : value > 0.0f ? 65535u : 0u;
}

template <class T>
std::vector<T> pick(const std::vector<T>& all, const std::vector<size_t>& places) {
  std::vector<T> out;
  if (all.empty()) return out;
  for (const size_t place : places) out.push_back(all[place]);
  return out;
}

}  // namespace

Case make_case(const Options& options, const Table& table) {
  const auto fail = [&](const std::string& text) { throw Failure(kExitInput, options.lookups + ": " + text); };
  Case out;
  out.sampler = options.sampler, out.rules = options.rules;
  for (const auto& row : command::kRules) out.bounds_of_rules[row.value] = bounds_of(options, row.value);
  out.bounds = out.bounds_of_rules[out.rules];
  out.decode = options.srgb ? Decode::kSrgb : Decode::kAsStored;
  for (const auto& column : table.columns) {
    const std::string& name = column.first;
    const bool known = name == "layer" || contains(kInputNames, name) || contains(kChannelNames, name);
    if (!known) fail("column " + name + " is not known");
  }
  for (size_t i = 0; i < kInputs; ++i) {
    if (const auto* column = table.find(kInputNames[i])) out.column[i] = *column;
  }
  if (!table.find("u") || !table.find("v")) fail("no columns u and v");
  if (const auto* column = table.find("layer")) {
    std::transform(column->begin(), column->end(), std::back_inserter(out.layer), layer_of);
  }
  bool any = false;
  for (size_t c = 0; c < 4; ++c) {
    const auto* column = table.find(kChannelNames[c]);
    if (column) out.result[c] = *column, any = true;
  }
  if (!any) fail("no column r, g, b or a, and no --results");
  out.row.resize(table.rows());
  std::iota(out.row.begin(), out.row.end(), size_t{0});
  return out;
}

Case select_rows(const Case& all, const std::vector<size_t>& places) {
  Case out = {};
  out.sampler = all.sampler, out.rules = all.rules, out.bounds = all.bounds, out.bounds_of_rules = all.bounds_of_rules;
  out.decode = all.decode, out.curve = all.curve, out.shift = all.shift;
  for (size_t i = 0; i < kInputs; ++i) out.column[i] = pick(all.column[i], places);
  for (size_t c = 0; c < 4; ++c) out.result[c] = pick(all.result[c], places);
  out.layer = pick(all.layer, places);
  out.row = pick(all.row, places);
  return out;
}

shd_lookups lookups_of(const Case& judged) {
  constexpr shd_f32_in shd_lookups::*kColumns[kInputs] = {
      &shd_lookups::u,    &shd_lookups::v,    &shd_lookups::w,        &shd_lookups::dudx,
      &shd_lookups::dvdx, &shd_lookups::dwdx, &shd_lookups::dudy,     &shd_lookups::dvdy,
      &shd_lookups::dwdy, &shd_lookups::lod,  &shd_lookups::reference};
  shd_lookups out = shd_lookups_default();
  out.count = judged.count();
  for (size_t i = 0; i < kInputs; ++i) {
    if (!judged.column[i].empty()) (out.*kColumns[i]).data = judged.column[i].data();
  }
  if (!judged.layer.empty()) out.layer.data = judged.layer.data();
  return out;
}
