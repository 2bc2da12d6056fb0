// SPDX-License-Identifier: MIT
#include "tool/check/report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "command/failure.h"

namespace {

double number(float value) {
  return static_cast<double>(value);
}

void print_taps(Textures& textures, const Case& judged, size_t place) {
  if (!is_stored(judged.decode) || judged.is_shifted()) return;  // a lookup that the library cannot make
  std::vector<shd_tap> taps(4096);
  shd_explanation explanation = shd_explanation_default();
  explanation.taps = taps.data();
  explanation.tap_capacity = static_cast<uint32_t>(taps.size());
  const Sampler sampler = make_sampler(textures.context(), judged);
  const shd_lookups lookups = lookups_of(judged);
  if (shd_texture_explain(textures.get(judged.decode), sampler.get(), &lookups, place, &explanation) != SHD_OK) return;
  const size_t count = std::min<size_t>(explanation.tap_count, taps.size()), shown = std::min<size_t>(count, 16);
  std::printf("    texels (layer level x y: weight):");
  for (size_t i = 0; i < shown; ++i) {
    const shd_tap& tap = taps[i];
    std::printf(" (%u %u %u %u%s: %.3g)", tap.layer, tap.level_u, tap.x, tap.y, tap.border ? " border" : "",
                number(tap.weight));
  }
  std::printf(count > shown ? " and %zu more\n" : "\n", count - shown);
}

std::string lookups_text(size_t count, size_t of) {
  return std::to_string(count) + " of " + std::to_string(of);
}

}  // namespace

std::vector<Refusal> find_refusals(const Case& judged, const Bounds& bounds) {
  std::vector<Refusal> out;
  for (size_t place = 0; place < judged.count(); ++place) {
    const int worst = worst_channel(judged, bounds, place);
    if (worst < 0) continue;
    const auto channel = static_cast<size_t>(worst);
    out.push_back({place, channel, excess(judged, bounds, place, channel)});
  }
  std::stable_sort(out.begin(), out.end(), [](const Refusal& a, const Refusal& b) { return a.excess > b.excess; });
  return out;
}

void describe(Textures& textures, const Case& judged, const Bounds& bounds, const Refusal& refusal) {
  const float value = judged.result[refusal.channel][refusal.place];
  const float low = bounds.low[refusal.channel][refusal.place], high = bounds.high[refusal.channel][refusal.place];
  std::printf("row %zu: %s = %.9g is not in %.9g..%.9g; nearest legal value %.9g, %.3g away\n",
              judged.row[refusal.place], kChannelNames[refusal.channel], number(value), number(low), number(high),
              number(value > high ? high : low), number(refusal.excess));
  std::printf("    lookup:");
  for (size_t i = 0; i < kInputs; ++i) {
    if (!judged.column[i].empty()) std::printf(" %s %.9g", kInputNames[i], number(judged.column[i][refusal.place]));
  }
  if (!judged.layer.empty()) std::printf(" layer %u", judged.layer[refusal.place]);
  std::printf("\n");
  print_taps(textures, judged, refusal.place);
}

void summarize(const Case& judged, const std::vector<Refusal>& refusals) {
  std::printf("%s lookups are not legal", lookups_text(refusals.size(), judged.count()).c_str());
  if (!refusals.empty()) {
    const Refusal& worst = refusals.front();
    std::printf("; the farthest is %.3g outside, %s of row %zu", number(worst.excess), kChannelNames[worst.channel],
                judged.row[worst.place]);
  }
  std::printf("\n");
}

void print_diagnosis(const Diagnosis& diagnosis) {
  if (diagnosis.not_finite)
    std::printf("diagnosis: %zu results are NaN or infinite, and no hypothesis is about them\n", diagnosis.not_finite);
  if (diagnosis.refused == 0) {
    if (!diagnosis.not_finite) std::printf("diagnosis: nothing to explain\n");
    return;
  }
  const std::string tried =
      std::to_string(diagnosis.hypotheses) + " hypotheses" + (diagnosis.tried_pairs ? " and their pairs" : "");
  if (diagnosis.findings.empty()) {
    const Finding& best = diagnosis.best;
    std::printf("diagnosis: none of %s explains half of the %zu refused lookups", tried.c_str(), diagnosis.refused);
    if (best.explained) std::printf("; %s explains %zu", best.options.c_str(), best.explained);
    std::printf("\n");
    return;
  }
  std::printf("diagnosis by %s:\n", tried.c_str());
  for (const Finding& finding : diagnosis.findings) {
    std::printf("    legal in %s with %s\n        %s\n", lookups_text(finding.legal, diagnosis.rows).c_str(),
                finding.options.c_str(), finding.text.c_str());
  }
  if (diagnosis.complete == 0) std::printf("    none of them explains all lookups\n");
  if (diagnosis.complete > 1)
    std::printf("    %zu explain all lookups; they differ in other lookups only\n", diagnosis.complete);
}
