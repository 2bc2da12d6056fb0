// SPDX-License-Identifier: MIT
// Verdicts: nothing of shd is refused, errors of an implementation are found, and counts add up.
#include <cstdio>

#include "../verdicts/verdicts.h"

namespace shootout {
namespace {

int failures = 0;

void check(bool good, const std::string& what) {
  if (good) return;
  std::printf("failed: %s\n", what.c_str());
  ++failures;
}

/// shd with other lookups or values.
Implementation broken(const std::string& name, const std::function<void(Lookups*)>& before,
                      const std::function<void(std::vector<float>*)>& after) {
  Implementation out;
  out.name = name;
  out.family = "broken";
  out.filter = [=](const Batch& batch, shd_profile profile) {
    const JudgedTexture texture(batch.texture, SHD_SIMD_BEST, 1);
    Lookups q = batch.lookups;
    if (before) before(&q);
    std::vector<float> values = texture.sample(q, judged_sampler(batch.filter, profile));
    if (after) after(&values);
    return values;
  };
  return out;
}

std::vector<Implementation> broken_implementations() {
  const auto half_texel = [](Lookups* q) {
    for (float& u : q->u) u += 0.5f / 256;
    for (float& v : q->v) v += 0.5f / 256;
  };
  const auto level_off = [](Lookups* q) {
    for (auto* column : {&q->dudx, &q->dvdx, &q->dudy, &q->dvdy}) {
      for (float& d : *column) d *= 2;
    }
  };
  const auto seven_bits = [](std::vector<float>* values) {
    for (float& x : *values) x = static_cast<float>(static_cast<int>(x * 127 + 0.5f)) / 127;
  };
  const auto not_finite = [](std::vector<float>* values) { (*values)[5] = 0.0f / 0.0f * (*values)[5]; };
  return {broken("half texel", half_texel, nullptr), broken("level", level_off, nullptr),
          broken("seven bits", nullptr, seven_bits), broken("NaN", nullptr, not_finite)};
}

const Tally& tally_of(const Verdicts& verdicts, size_t implementation, shd_filter filter, size_t rules) {
  for (const Tally& tally : verdicts.tallies) {
    if (tally.implementation == implementation && kJudgedFilters[tally.filter] == filter && tally.rules == rules) {
      return tally;
    }
  }
  return verdicts.tallies.front();
}

size_t explained_by(const Verdicts& verdicts, const Tally& tally, const std::string& name) {
  const auto& departures = verdicts.departures.at(verdicts.implementations[tally.implementation].family);
  for (size_t d = 0; d < departures.size(); ++d) {
    if (departures[d].name == name) return tally.explained[d];
  }
  return 0;
}

/// Whether a peer has the version whose rules the departures have.
bool is_studied(const std::string& family) {
  const std::string version = family == "OpenImageIO" ? "OpenImageIO 2.4." : "Mesa 22.3.";
  for (const std::string& description : peer_descriptions()) {
    if (description.find(family) == 0 && description.find(version) != std::string::npos) return true;
  }
  return false;
}

void check_counts(const Verdicts& verdicts) {
  for (const Tally& tally : verdicts.tallies) {
    const Implementation& who = verdicts.implementations[tally.implementation];
    const std::string what =
        who.name + ", " + name_of(kJudgedFilters[tally.filter]) + ", " + kJudgedRules[tally.rules].name;
    size_t sum = tally.unexplained;
    for (const size_t number : tally.explained) sum += number;
    check(sum == tally.refused && tally.refused <= tally.judged, what + ": the counts do not add up");
    // The default rules judge shd alone, and not the levels of FAST ANISOTROPIC.
    const bool fast_levels = who.is_fast && kJudgedFilters[tally.filter] == SHD_FILTER_ANISOTROPIC;
    const bool is_judged = !kJudgedRules[tally.rules].own || (who.is_own && !fast_levels);
    check((tally.judged > 0) == is_judged, what + (is_judged ? ": not judged" : ": judged"));
    check((tally.refused > 0) == (tally.farthest > 0.0f), what + ": no distance");
    if (who.is_own) check(tally.refused == 0, what + ": " + std::to_string(tally.refused) + " of shd refused");
    if (who.is_own || who.family == "broken" || tally.unexplained == 0) continue;
    const std::string message = what + ": refusals without a reason, such as " + tally.example;
    check(!is_studied(who.family), message);
    if (!is_studied(who.family)) std::printf("another version: %s\n", message.c_str());
  }
  check(own_refusals(verdicts) == 0, "shd is refused");
}

void check_peers(const Verdicts& verdicts) {
  for (const std::string peer : {"OpenImageIO", "llvmpipe", "lavapipe"}) {
    size_t named = 0;
    for (const Implementation& who : verdicts.implementations) named += who.family == peer;
    for (const std::string& message : missing_peers()) named += message.find(peer) != std::string::npos;
    check(named == 1, peer + " is neither judged nor named as missing");
  }
}

void check_broken(const Verdicts& verdicts, size_t first) {
  const Tally& moved = tally_of(verdicts, first, SHD_FILTER_BILINEAR, 1);
  check(moved.refused > moved.judged / 10, "half a texel is not refused");
  check(explained_by(verdicts, moved, "half a texel") > moved.refused / 2, "half a texel is not the reason");
  check(tally_of(verdicts, first, SHD_FILTER_TRILINEAR, 0).unexplained > 0, "half a texel is explained with levels");
  check(tally_of(verdicts, first + 1, SHD_FILTER_TRILINEAR, 0).unexplained > 0, "a wrong level is explained");
  check(tally_of(verdicts, first + 1, SHD_FILTER_BILINEAR, 0).refused == 0, "a level refuses a filter without levels");
  const Tally& bits = tally_of(verdicts, first + 2, SHD_FILTER_NEAREST, 0);
  check(bits.refused > bits.judged / 10 && explained_by(verdicts, bits, "one code") == bits.refused,
        "seven bits are not the reason");
  const Tally& nan = tally_of(verdicts, first + 3, SHD_FILTER_NEAREST, 0);
  check(nan.refused == judged_textures().size() && nan.unexplained == nan.refused, "NaN is legal");
}

}  // namespace
}  // namespace shootout

int main() {
  using namespace shootout;
  std::vector<Implementation> all = judged_implementations();
  const size_t first = all.size();
  for (Implementation& implementation : broken_implementations()) all.push_back(std::move(implementation));
  const Verdicts verdicts = judge(std::move(all), 20000);
  check_counts(verdicts);
  check_peers(verdicts);
  check_broken(verdicts, first);
  if (failures == 0) std::printf("verdicts: all checks passed, %zu lookups of each implementation\n", verdicts.lookups);
  return failures == 0 ? 0 : 1;
}
