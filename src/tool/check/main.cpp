// SPDX-License-Identifier: MIT
// shd-check: judges texture lookups of any implementation by <shd/bounds.h>.
#include <algorithm>

#include "command/program.h"
#include "tool/check/report.h"

namespace {

/// Adds the channels of an image of results to a table, as many as the texture has.
void add_results(shd_context* context, const Options& options, size_t channels, Table* table) {
  const Picture picture = read_picture(context, options.results, false);
  const std::vector<std::vector<float>> columns = float_columns(options.results, picture);
  const size_t count = columns.front().size();
  if (count != table->rows()) {
    throw Failure(kExitInput, options.results + ": " + std::to_string(count) + " pixels, but " +
                                  std::to_string(table->rows()) + " lookups");
  }
  for (size_t c = 0; c < columns.size() && c < channels; ++c) {
    const std::string name(1, "rgba"[c]);
    if (table->find(name)) throw Failure(kExitInput, options.lookups + ": column " + name + " beside --results");
    table->columns.push_back({name, columns[c]});
  }
}

int judge(const Options& options, Textures& textures, const Case& judged) {
  const Bounds bounds = find_bounds(textures, judged);
  Verdict verdict;
  verdict.refusals = find_refusals(judged, bounds);
  for (size_t i = 0; i < std::min(verdict.refusals.size(), options.list); ++i)
    describe(textures, judged, bounds, verdict.refusals[i]);
  summarize(judged, verdict.refusals);
  if (options.diagnose) {
    std::vector<bool> refused(judged.count(), false);
    for (const Refusal& refusal : verdict.refusals) refused[refusal.place] = true;
    verdict.diagnosed = true;
    verdict.diagnosis = diagnose(textures, judged, refused);
    print_diagnosis(verdict.diagnosis);
  }
  if (!options.report.empty()) write_report(options.report, judged, bounds, verdict);
  return verdict.refusals.empty() ? kExitOk : kExitFailed;
}

int run(const Options& options) {
  Context context;
  check(shd_context_create(nullptr, context.out()), "context");
  Table table = read_table(options.lookups, options.columns);
  Textures textures(context.get(), options);
  if (!options.results.empty()) add_results(context.get(), options, channels_of(textures.base()), &table);
  Case judged = make_case(options, table);
  assume(options.assumed, textures, judged);
  return judge(options, textures, judged);
}

}  // namespace

int main(int argc, char** argv) {
  const auto body = [&] {
    Options options;
    return read_options(argc, argv, options) ? run(options) : kExitOk;
  };
  return command::run("shd-check", body, kExitInput);
}
