// SPDX-License-Identifier: MIT
// shd-check: judges texture lookups of any implementation by <shd/bounds.h>.
#include <cstdio>

#include "command/program.h"
#include "tool/check/judge.h"
#include "tool/check/picture.h"

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

int judge(const Options& options, const Case& judged) {
  const Bounds bounds = find_bounds(judged, options.bounds);
  size_t illegal = 0;
  for (size_t row = 0; row < judged.lookups.count; ++row) {
    const int channel = worst_channel(judged, bounds, row);
    if (channel < 0) continue;
    if (illegal++ < options.list) describe(judged, bounds, row, channel);
  }
  std::printf("%zu of %zu lookups are not legal\n", illegal, judged.lookups.count);
  return illegal ? kExitFailed : kExitOk;
}

/// Handles of a run, released at its end.
struct Handles {
  shd_context* context = nullptr;
  shd_texture* texture = nullptr;
  shd_sampler* sampler = nullptr;

  ~Handles() {
    shd_sampler_release(sampler);
    shd_texture_release(texture);
    shd_context_release(context);
  }
};

int run(Options options) {
  Handles handles;
  check(shd_context_create(nullptr, &handles.context), "context");
  // The probes and levels that are printed are those of the API.
  options.sampler.profile = options.rules == SHD_RULES_D3D11 ? SHD_PROFILE_D3D11 : SHD_PROFILE_VULKAN;
  check(shd_sampler_create(handles.context, &options.sampler, &handles.sampler), "sampler", kExitUsage);
  Table table = read_table(options.lookups, options.columns);
  handles.texture = make_texture(handles.context, options);
  if (!options.results.empty()) add_results(handles.context, options, channels_of(handles.texture), &table);
  std::vector<uint32_t> layers;
  Case judged = make_case(options, table, &layers);
  judged.texture = handles.texture;
  judged.sampler = handles.sampler;
  return judge(options, judged);
}

}  // namespace

int main(int argc, char** argv) {
  const auto body = [&] {
    Options options;
    return read_options(argc, argv, options) ? run(options) : kExitOk;
  };
  return command::run("shd-check", body, kExitInput);
}
