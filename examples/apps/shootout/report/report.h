// SPDX-License-Identifier: MIT
#pragma once

#include "../cost.h"
#include "../figures.h"
#include "../verdicts/verdicts.h"

namespace shootout {

/// Machine, compiler and commit of a run.
struct Machine {
  std::string cpu, compiler, commit, date;
  unsigned cores = 0;
};
Machine this_machine();

/// Every measurement as JSON and as CSV, one line a picture.
std::string json_of(const Options& options, const Machine& machine, const Measurements& m, const Costs& costs);
std::string csv_of(const Measurements& m, const Costs& costs);

/// The pictures of the page as JSON: frames, maps of FLIP, textures, levels, figures.
std::string pictures_json(const Options& options, const Measurements& m);
/// The taps of a grid of pixels, as JSON.
std::string taps_json(const Options& options, const Measurements& m);

/// Writes shootout.html, shootout.json, shootout.csv and verdicts.json into options.out; the page is made of the files
/// in options.web.
void write_report(const Options& options, const Measurements& m, const Costs& costs, const Verdicts& verdicts);
/// Writes a whole file; fails with its path.
void write_file(const std::string& path, const std::string& text);

}  // namespace shootout
