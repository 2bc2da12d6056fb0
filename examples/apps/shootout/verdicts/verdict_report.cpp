// SPDX-License-Identifier: MIT
// Verdicts as JSON and as text.
#include <algorithm>
#include <cstdio>

#include "../report/json.h"
#include "verdicts.h"

namespace shootout {
namespace {

void write_names(const char* key, const std::vector<std::string>& names, Json* json) {
  json->key(key).begin_array();
  for (const std::string& name : names) json->value(name);
  json->end_array();
}

void write_departures(const Verdicts& verdicts, Json* json) {
  json->key("departures").begin_object();
  for (const auto& [family, departures] : verdicts.departures) {
    json->key(family).begin_array();
    for (const Departure& departure : departures) {
      json->begin_object().member("name", departure.name).member("text", departure.text).end_object();
    }
    json->end_array();
  }
  json->end_object();
}

void write_tally(const Tally& tally, Json* json) {
  const auto count = [&](const char* key, size_t number) { json->member(key, static_cast<double>(number), 15); };
  json->begin_object();
  count("i", tally.implementation);
  count("f", tally.filter);
  count("r", tally.rules);
  count("judged", tally.judged);
  count("refused", tally.refused);
  count("unexplained", tally.unexplained);
  json->key("explained").begin_array();
  for (const size_t number : tally.explained) json->value(static_cast<double>(number), 15);
  json->end_array();
  json->member("farthest", static_cast<double>(tally.farthest), 4);
  json->member("farthest_unexplained", static_cast<double>(tally.farthest_unexplained), 4);
  json->member("example", tally.example).end_object();
}

/// The share of refused lookups, such as "1.20 %".
std::string share(size_t refused, size_t judged) {
  char text[64];
  if (judged == 0) return "-";
  if (refused == 0) return "0";
  std::snprintf(text, sizeof text, "%.2f %%", 100.0 * static_cast<double>(refused) / static_cast<double>(judged));
  return text;
}

/// One line a filter, with the share of refused lookups of each preset, summed over the targets of shd or of one peer.
void print_shares(const Verdicts& verdicts, const std::string& family) {
  for (size_t f = 0; f < kJudgedFilterCount; ++f) {
    size_t most = 0, judged[kJudgedRulesCount] = {}, refused[kJudgedRulesCount] = {};
    for (const Tally& tally : verdicts.tallies) {
      if (tally.filter != f || verdicts.implementations[tally.implementation].family != family) continue;
      judged[tally.rules] += tally.judged;
      refused[tally.rules] += tally.refused;
      most = std::max(most, judged[tally.rules]);
    }
    std::printf("%-12s %-20s %10zu", family.c_str(), name_of(kJudgedFilters[f]), most);
    for (size_t r = 0; r < kJudgedRulesCount; ++r) std::printf(" %13s", share(refused[r], judged[r]).c_str());
    std::printf("\n");
  }
}

void print_reasons(const Verdicts& verdicts) {
  std::printf("reasons of refusals\n");
  for (const Tally& tally : verdicts.tallies) {
    if (tally.refused == 0) continue;
    const Implementation& implementation = verdicts.implementations[tally.implementation];
    std::printf("  %s, %s, %s: %zu refused, the farthest %.3g of 255", implementation.name.c_str(),
                name_of(kJudgedFilters[tally.filter]), kJudgedRules[tally.rules].name, tally.refused,
                255.0 * static_cast<double>(tally.farthest));
    const std::vector<Departure>& departures = verdicts.departures.at(implementation.family);
    for (size_t d = 0; d < departures.size(); ++d) {
      if (tally.explained[d]) std::printf("; %s %zu", departures[d].name.c_str(), tally.explained[d]);
    }
    std::printf("; not explained %zu\n", tally.unexplained);
    if (tally.unexplained) {
      std::printf("    up to %.3g of 255: %s\n", 255.0 * static_cast<double>(tally.farthest_unexplained),
                  tally.example.c_str());
    }
  }
}

}  // namespace

std::string json_of(const Verdicts& verdicts) {
  std::vector<std::string> names, filters, rules, textures;
  for (const Implementation& implementation : verdicts.implementations) names.push_back(implementation.name);
  for (const shd_filter filter : kJudgedFilters) filters.push_back(name_of(filter));
  for (const JudgedRules& preset : kJudgedRules) rules.push_back(preset.name);
  for (const Texture& texture : judged_textures()) textures.push_back(texture.title);
  Json json;
  json.begin_object().member("lookups", static_cast<double>(verdicts.lookups), 15);
  json.member("seconds", verdicts.seconds, 4);
  write_names("implementations", names, &json);
  write_names("filters", filters, &json);
  write_names("rules", rules, &json);
  write_names("textures", textures, &json);
  write_names("missing", missing_peers(), &json);
  json.key("families").begin_array();
  for (const Implementation& implementation : verdicts.implementations) json.value(implementation.family);
  json.end_array();
  write_departures(verdicts, &json);
  json.key("rows").begin_array();
  for (const Tally& tally : verdicts.tallies) {
    if (tally.judged) write_tally(tally, &json);
  }
  return json.end_array().end_object().text();
}

void print(const Verdicts& verdicts) {
  for (const std::string& peer : missing_peers()) std::printf("not judged: %s\n", peer.c_str());
  std::printf("%-12s %-20s %10s", "refused", "filter", "judged");
  for (const JudgedRules& rules : kJudgedRules) std::printf(" %13s", rules.name);
  std::printf("\n");
  std::vector<std::string> families;
  for (const Implementation& implementation : verdicts.implementations) {
    if (!families.empty() && families.back() == implementation.family) continue;
    families.push_back(implementation.family);
    print_shares(verdicts, implementation.family);
  }
  print_reasons(verdicts);
  std::printf("%zu lookups of each of %zu implementations in %.0f s; shd: %zu refused\n", verdicts.lookups,
              verdicts.implementations.size(), verdicts.seconds, own_refusals(verdicts));
}

}  // namespace shootout
