// SPDX-License-Identifier: MIT
// The forms of a verdict that other programs read.
#include <cmath>
#include <cstdio>
#include <memory>

#include "command/values.h"
#include "tool/check/report.h"

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// The shortest text that gives the same float again. JSON has no NaN and no infinity: these are texts.
std::string digits_of(float value, bool json) {
  char text[40];
  std::snprintf(text, sizeof text, "%.9g", static_cast<double>(value));
  return json && !std::isfinite(value) ? "\"" + std::string(text) + "\"" : text;
}

/// The number of a row, its lookup, and the result, bounds and excess of each channel. `add` receives name and value.
template <class Add>
void visit_fields(const Case& judged, const Bounds& bounds, size_t place, bool json, Add add) {
  add("row", std::to_string(judged.row[place]));
  for (size_t i = 0; i < kInputs; ++i) {
    if (!judged.column[i].empty()) add(kInputNames[i], digits_of(judged.column[i][place], json));
  }
  if (!judged.layer.empty()) add("layer", std::to_string(judged.layer[place]));
  for (size_t c = 0; c < 4; ++c) {
    if (judged.result[c].empty()) continue;
    const std::string name = kChannelNames[c];
    add(name, digits_of(judged.result[c][place], json));
    add(name + "_low", digits_of(bounds.low[c][place], json));
    add(name + "_high", digits_of(bounds.high[c][place], json));
    add(name + "_excess", digits_of(excess(judged, bounds, place, c), json));
  }
}

void write_csv(std::FILE* file, const Case& judged, const Bounds& bounds) {
  std::string line = "row";
  for (size_t i = 0; i < kInputs; ++i) {
    if (!judged.column[i].empty()) line += std::string(",") + kInputNames[i];
  }
  if (!judged.layer.empty()) line += ",layer";
  for (size_t c = 0; c < 4; ++c) {
    const std::string name = kChannelNames[c];
    if (!judged.result[c].empty()) line += "," + name + "," + name + "_low," + name + "_high," + name + "_excess";
  }
  std::fprintf(file, "%s,legal\n", line.c_str());
  for (size_t place = 0; place < judged.count(); ++place) {
    line.clear();
    visit_fields(judged, bounds, place, false,
                 [&](const std::string&, const std::string& value) { line += value + ","; });
    std::fprintf(file, "%s%d\n", line.c_str(), worst_channel(judged, bounds, place) < 0);
  }
}

void write_finding(std::FILE* file, const Finding& finding, bool last) {
  std::fprintf(file, "    {\"options\": \"%s\", \"text\": \"%s\", \"legal\": %zu, \"explained\": %zu}%s\n",
               finding.options.c_str(), finding.text.c_str(), finding.legal, finding.explained, last ? "" : ",");
}

void write_json(std::FILE* file, const Case& judged, const Bounds& bounds, const Verdict& verdict) {
  std::fprintf(file, "{\n  \"lookups\": %zu,\n  \"refused\": %zu,\n  \"refusals\": [\n", judged.count(),
               verdict.refusals.size());
  for (size_t i = 0; i < verdict.refusals.size(); ++i) {
    std::string line;
    visit_fields(judged, bounds, verdict.refusals[i].place, true,
                 [&](const std::string& name, const std::string& value) {
                   line += (line.empty() ? "\"" : ", \"") + name + "\": " + value;
                 });
    std::fprintf(file, "    {%s}%s\n", line.c_str(), i + 1 < verdict.refusals.size() ? "," : "");
  }
  std::fprintf(file, "  ]");
  if (verdict.diagnosed) {
    const Diagnosis& diagnosis = verdict.diagnosis;
    std::fprintf(file, ",\n  \"hypotheses\": %zu,\n  \"diagnosis\": [\n", diagnosis.hypotheses);
    for (size_t i = 0; i < diagnosis.findings.size(); ++i)
      write_finding(file, diagnosis.findings[i], i + 1 == diagnosis.findings.size());
    std::fprintf(file, "  ]");
  }
  std::fprintf(file, "\n}\n");
}

}  // namespace

void write_report(const std::string& path, const Case& judged, const Bounds& bounds, const Verdict& verdict) {
  const bool json = command::ends_with(path, ".json");
  File file(std::fopen(path.c_str(), "w"), std::fclose);
  if (!file) throw Failure(kExitOutput, path + ": cannot be written");
  if (json) write_json(file.get(), judged, bounds, verdict);
  if (!json) write_csv(file.get(), judged, bounds);
  const bool failed = std::ferror(file.get());
  if (std::fclose(file.release()) != 0 || failed) throw Failure(kExitOutput, path + ": cannot be written");
}
