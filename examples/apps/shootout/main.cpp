// SPDX-License-Identifier: MIT
// shd-shootout: filters of shd and of other libraries beside ground truth. See README.md here.
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "command/values.h"
#include "report/png.h"
#include "report/report.h"
#include "shd_pass.h"

namespace shootout {
namespace {

using namespace command;

void list() {
  Options options;
  const auto heading = [](const char* text) { std::printf("%s\n", text); };
  const auto line = [](const std::string& name, const std::string& title) {
    std::printf("  %-32s %s\n", name.c_str(), title.c_str());
  };
  heading("workloads");
  for (const Workload& workload : still_workloads(options.edge, options.texture_edge))
    line(workload.name, workload.title);
  for (const Workload& workload : movies(options.movie_edge, options.texture_edge)) line(workload.name, workload.title);
  heading("textures");
  for (const Texture& texture : all_textures(64, options.photograph)) line(texture.name, texture.title);
  heading("settings");
  for (const Setting& setting : all_settings()) line(setting.name, setting.title);
  heading("figures");
  for (const FigureName& figure : figure_names()) line(figure.name, figure.title);
  for (const std::string& peer : missing_peers()) std::printf("missing peer: %s\n", peer.c_str());
}

void make_quick(Options* options) {
  options->quick = true;
  options->edge = 64;
  options->texture_edge = 256;
  options->samples = 8;
  options->movie_edge = 16;
  options->movie_samples = 4;
  options->verdicts = 20000;
}

Group option_group(Options& out, bool& lists) {
  const auto quick = [&out](const std::string&) { return make_quick(&out), true; };
  const auto photograph = [&out](const std::string& text) {
    return out.photograph = text, std::filesystem::is_regular_file(text);
  };
  std::vector<std::string> figures = {"all"};
  for (const FigureName& figure : figure_names()) figures.push_back(figure.name);
  return {"Options",
          {{"-o,--output", "FOLDER", file(out.out), "Folder of the report or figure."},
           {"--quick", "", {"", {}, "", quick}, "Small frames and two textures: seconds."},
           {"--figure", "NAME", one_of(out.figure, figures), "One figure of a course as NAME.png, or all."},
           {"--verdicts", "COUNT", initially(marked(number(out.verdicts, 1000, 1e9), out.only_verdicts), ""),
            "Judge COUNT lookups of each implementation, and make no report."},
           {"--photograph",
            "FILE",
            {"a file", {}, "the map of the package xplanet-images", photograph, true},
            "Photograph among the textures."},
           {"--threads", "N", initially(number(out.threads, 1, 256), "one for each core"),
            "Threads for pictures. Times are of one thread."},
           {"--list", "", flag(lists), "Print the names of workloads, textures, settings and figures."}}};
}

/// Returns false if nothing is left to do.
bool read_options(int count, char** arguments, Options* options) {
  bool lists = false;
  const Program program = {"shd-shootout",
                           "compare filters with ground truth and with other libraries",
                           "[options]",
                           "Writes a report, or figures, or verdicts.",
                           {option_group(*options, lists)},
                           {}};
  std::vector<std::string> rest;
  if (!parse(program, count, arguments, rest)) return false;
  if (!rest.empty()) throw Failure(kExitUsage, "\"" + rest[0] + "\" is not an option");
  if (lists) list();
  return !lists;
}

void make_figures(const Options& options) {
  std::filesystem::create_directories(options.out);
  for (const FigureName& name : figure_names()) {
    if (options.figure != "all" && options.figure != name.name) continue;
    const Figure figure = make_figure(name.name, 512);
    const std::string path = options.out + "/" + figure.name + ".png";
    write_file(path, png_of(figure.picture));
    std::printf("%s: %s, hash %s\n", path.c_str(), figure.title.c_str(), hash_of(figure.picture).c_str());
  }
}

void print_fronts(const Measurements& m, const Costs& costs) {
  size_t on = 0, all = 0, on_default = 0;
  for (const FrontRow& row : fronts(m, costs)) {
    ++all;
    on_default += row.default_lead >= -kTie;
    if (row.lead >= -kTie) {
      ++on;
      continue;
    }
    std::printf("   off the front: %s, %s, %s, %g texels: %s is %.2f dB behind %s\n",
                m.workloads[row.workload].name.c_str(), m.textures[row.texture].name.c_str(), name_of(row.peer),
                row.budget, m.settings[row.own].name.c_str(), -row.lead, m.settings[row.other].name.c_str());
  }
  std::printf(
      "   shd is on the front of %zu of %zu workloads x textures x peers x budgets, with its default profile of "
      "%zu\n",
      on, all, on_default);
}

/// A refused value of shd is an error of shd, or of the bounds.
void require_legal(const Verdicts& verdicts) {
  if (const size_t refused = own_refusals(verdicts)) {
    throw std::runtime_error(std::to_string(refused) + " values of shd are not legal");
  }
}

void make_report(const Options& options) {
  for (const std::string& peer : missing_peers()) std::printf("== Left out: %s\n", peer.c_str());
  std::printf("== Pictures\n");
  double start = now();
  const Measurements m = measure(options);
  std::printf("   %.0f s\n== Times and texels\n", now() - start);
  start = now();
  const Costs costs = measure_costs(options, m);
  print_fronts(m, costs);
  std::printf("   %.0f s\n== Verdicts\n", now() - start);
  const Verdicts verdicts = judge(judged_implementations(), options.verdicts);
  print(verdicts);
  std::printf("== Report\n");
  start = now();
  write_report(options, m, costs, verdicts);
  std::printf("   %.0f s\n== Done: %s/shootout.html (%ju bytes)\n", now() - start, options.out.c_str(),
              static_cast<uintmax_t>(std::filesystem::file_size(options.out + "/shootout.html")));
  require_legal(verdicts);
}

void make_verdicts(const Options& options) {
  const Verdicts verdicts = judge(judged_implementations(), options.verdicts);
  print(verdicts);
  std::filesystem::create_directories(options.out);
  write_file(options.out + "/verdicts.json", json_of(verdicts) + "\n");
  require_legal(verdicts);
}

/// A peer that fails is named in the report, which has no rows of it.
void run(const Options& options, void (*make)(const Options& options)) {
  try {
    make(options);
  } catch (const PeerFailure& failure) {
    std::printf("== %s\n   Again without %s\n", failure.what(), name_of(failure.who));
    drop_peer(failure.who, failure.what());
    run(options, make);
  }
}

}  // namespace
}  // namespace shootout

int main(int count, char** arguments) {
  return command::run("shd-shootout", [&] {
    shootout::Options options;
    options.web = SHOOTOUT_WEB;
    if (!shootout::read_options(count, arguments, &options)) return kExitOk;
    if (options.only_verdicts) {
      shootout::run(options, shootout::make_verdicts);
    } else if (options.figure.empty()) {
      shootout::run(options, shootout::make_report);
    } else {
      shootout::make_figures(options);
    }
    return kExitOk;
  });
}
