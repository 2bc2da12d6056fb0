// SPDX-License-Identifier: MIT
#include "tool/check/diagnose.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

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

/// Whether shd-check takes a pair in this order: a name of --assume must be one of the case that the first part
/// changes.
class Orders {
 public:
  Orders(const Textures& textures, const std::vector<Hypothesis>& all, const Case& judged) {
    for (const Hypothesis& first : all) {
      Case changed = judged;
      first.change(changed);
      std::set<std::string>& names = names_[&first];
      for (const Hypothesis& second : hypotheses_of(changed, textures)) names.insert(assumed_name(second));
    }
  }
  bool takes(const Parts& parts) const {
    const std::string name = assumed_name(*parts[1]);
    return name.empty() || names_.at(parts[0]).count(name) != 0;
  }

 private:
  std::map<const Hypothesis*, std::set<std::string>> names_;  // after each first part
};

/// The best pairs of two subjects. As on the command line, rules come before numbers, and names of --assume last.
std::vector<Score> try_pairs(Textures& textures, const std::vector<Hypothesis>& all, const Sample& few,
                             const Sample& first, const Sample& sample) {
  std::vector<Score> scores;
  const size_t passes = std::min(kFirstLegal, first.rows.count());
  const Orders orders(textures, all, first.rows);
  for (size_t i = 0; i < all.size(); ++i) {
    for (size_t k = i + 1; k < all.size(); ++k) {
      if (all[i].subject == all[k].subject) continue;
      Parts parts = {&all[i], &all[k]};
      const bool swap = all[k].subject == "rules" || (!assumed_name(all[i]).empty() && assumed_name(all[k]).empty());
      if (swap) std::swap(parts[0], parts[1]);
      if (!orders.takes(parts)) continue;
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
  for (const Hypothesis* part : score.parts) {
    out.text += (out.text.empty() ? "" : "; ") + part->text;
    const std::string name = assumed_name(*part);
    std::string& list = name.empty() ? out.options : names;
    list += (list.empty() ? "" : name.empty() ? " " : ",") + (name.empty() ? part->option : name);
  }
  if (!names.empty()) out.options += (out.options.empty() ? "" : " ") + std::string("--assume ") + names;
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
