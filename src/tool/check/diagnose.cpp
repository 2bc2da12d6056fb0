// SPDX-License-Identifier: MIT
#include "tool/check/diagnose.h"

#include <algorithm>
#include <cmath>

#include "tool/check/bounds.h"

namespace {

// A part of the rows represents a large table: most refused rows, and most legal rows.
constexpr size_t kMostRows = 2048;
// A pair is tried on refused rows first, then on some of both kinds. The best pairs are tried on all chosen rows.
constexpr size_t kFirstRows = 12, kFirstLegal = 8, kPairRows = 32, kMostPairs = 24;
// Findings, and those of them that stand beside complete ones.
constexpr size_t kMostShown = 8, kMostBeside = 2;

/// Every n-th place, at most `most`.
std::vector<size_t> spread(const std::vector<size_t>& places, size_t most) {
  if (places.size() <= most) return places;
  std::vector<size_t> out;
  for (size_t i = 0; i < most; ++i) out.push_back(places[i * places.size() / most]);
  return out;
}

/// Rows with a flag that each is refused without a hypothesis.
struct Sample {
  Case rows;
  std::vector<bool> refused;
};

Sample sample_of(const Case& judged, const std::vector<size_t>& bad, const std::vector<size_t>& good, size_t most) {
  std::vector<size_t> places = spread(bad, most);
  const size_t count = places.size();
  const std::vector<size_t> others = spread(good, most);
  places.insert(places.end(), others.begin(), others.end());
  Sample out = {select_rows(judged, places), std::vector<bool>(places.size(), false)};
  std::fill_n(out.refused.begin(), count, true);
  return out;
}

using Parts = std::vector<const Hypothesis*>;

struct Score {
  Parts parts;
  size_t legal, explained;
  int width;  // width of the bounds: 2 log2 of their mean, rounded
};

/// Narrow bounds that hold all results are better evidence than wide ones. Steps of sqrt(2) hide small differences.
int width_of(const Case& judged, const Bounds& bounds) {
  double sum = 0;
  size_t count = 0;
  for (size_t c = 0; c < 4; ++c) {
    for (size_t i = 0; i < judged.result[c].size(); ++i, ++count)
      sum += std::min(static_cast<double>(bounds.high[c][i]) - static_cast<double>(bounds.low[c][i]), 1.0);
  }
  return static_cast<int>(std::lround(2 * std::log2(sum / static_cast<double>(count) + 1e-9)));
}

Score score_of(Textures& textures, const Sample& sample, const Parts& parts) {
  Case changed = sample.rows;
  for (const Hypothesis* part : parts) part->change(changed);
  const Bounds bounds = find_bounds(textures, changed);
  Score score = {parts, 0, 0, width_of(changed, bounds)};
  for (size_t i = 0; i < changed.count(); ++i) {
    if (worst_channel(changed, bounds, i) >= 0) continue;
    ++score.legal;
    score.explained += sample.refused[i];
  }
  return score;
}

/// Best first. Equal ones keep the order of the hypotheses.
void rank(std::vector<Score>* scores) {
  std::stable_sort(scores->begin(), scores->end(), [](const Score& a, const Score& b) {
    return a.legal != b.legal ? a.legal > b.legal : a.width < b.width;
  });
}

/// The best pairs of two subjects.
std::vector<Score> try_pairs(Textures& textures, const std::vector<Hypothesis>& all, const Sample& few,
                             const Sample& first, const Sample& sample) {
  std::vector<Score> scores;
  const size_t passes = std::min(kFirstLegal, first.rows.count());
  for (size_t i = 0; i < all.size(); ++i) {
    for (size_t k = i + 1; k < all.size(); ++k) {
      if (all[i].subject == all[k].subject) continue;
      const Parts parts = {&all[i], &all[k]};
      if (score_of(textures, first, parts).legal < passes) continue;
      scores.push_back(score_of(textures, few, parts));
    }
  }
  rank(&scores);
  scores.resize(std::min(scores.size(), kMostPairs));
  for (Score& score : scores) score = score_of(textures, sample, score.parts);
  rank(&scores);
  return scores;
}

/// Keeps the best scores, judged on all rows: complete ones, and two beside them.
void judge_best(Textures& textures, const Sample& whole, std::vector<Score>* scores) {
  size_t count = 0, complete = 0;
  while (count < std::min(scores->size(), kMostShown) && (complete == 0 || count < complete + kMostBeside)) {
    Score& score = (*scores)[count++];
    score = score_of(textures, whole, score.parts);
    complete += score.legal == whole.rows.count();
  }
  scores->resize(count);
  rank(scores);
}

/// Joins options; names of --assume become one list.
Finding finding_of(const Score& score) {
  Finding out = {"", "", score.legal, score.explained};
  std::string names;
  const std::string prefix = "--assume ";
  for (const Hypothesis* part : score.parts) {
    out.text += (out.text.empty() ? "" : "; ") + part->text;
    const bool named = part->option.compare(0, prefix.size(), prefix) == 0;
    if (named) names += (names.empty() ? "" : ",") + part->option.substr(prefix.size());
    if (!named) out.options += (out.options.empty() ? "" : " ") + part->option;
  }
  if (!names.empty()) out.options += (out.options.empty() ? "" : " ") + prefix + names;
  return out;
}

bool is_finite(const Case& judged, size_t i) {
  for (const auto& column : judged.result) {
    if (!column.empty() && !std::isfinite(column[i])) return false;
  }
  return true;
}

}  // namespace

Diagnosis diagnose(Textures& textures, const Case& judged, const std::vector<bool>& refused) {
  Diagnosis out;
  std::vector<size_t> bad, good;
  for (size_t i = 0; i < judged.count(); ++i) {
    if (is_finite(judged, i)) (refused[i] ? bad : good).push_back(i);
    out.not_finite += !is_finite(judged, i) && refused[i];
  }
  out.rows = bad.size() + good.size();
  out.refused = bad.size();
  if (bad.empty()) return out;
  const std::vector<Hypothesis> all = hypotheses_of(judged, textures);
  out.hypotheses = all.size();
  const Sample sample = sample_of(judged, bad, good, kMostRows);
  std::vector<Score> scores;
  for (const Hypothesis& row : all) scores.push_back(score_of(textures, sample, {&row}));
  rank(&scores);
  if (scores.front().legal < sample.rows.count()) {
    out.tried_pairs = true;
    const Sample few = sample_of(judged, bad, good, kPairRows), first = sample_of(judged, bad, {}, kFirstRows);
    for (const Score& pair : try_pairs(textures, all, few, first, sample)) scores.push_back(pair);
    rank(&scores);
  }
  const Sample whole = sample_of(judged, bad, good, judged.count());
  const auto complete = [&](const Score& score) { return score.legal == out.rows; };
  if (whole.rows.count() > sample.rows.count()) judge_best(textures, whole, &scores);
  out.complete = static_cast<size_t>(std::count_if(scores.begin(), scores.end(), complete));
  out.best = finding_of(scores.front());
  const size_t most = out.complete ? std::min(out.complete + kMostBeside, kMostShown) : kMostShown;
  for (const Score& score : scores) {
    const bool explains = 2 * score.explained >= out.refused && score.legal > good.size();
    if (explains && out.findings.size() < most) out.findings.push_back(finding_of(score));
  }
  return out;
}
