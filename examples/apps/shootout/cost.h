// SPDX-License-Identifier: MIT
#pragma once

#include "measure.h"

namespace shootout {

/// The cost of a lookup of one workload with one setting. NaN = not available.
struct CostRow {
  size_t workload, setting;
  double texels, most_texels;  // mean and largest number of texels, or of sums, that a lookup reads
  double bytes;                // mean number of bytes of different texels
  double whole_ns, cached_ns;  // time of a lookup: over the whole frame, and of 256 lookups again and again
};

/// The cost of a texture with one setting.
struct TableRow {
  size_t setting;
  double build_ms;
  size_t bytes;
};

struct Costs {
  std::vector<CostRow> lookups;
  std::vector<TableRow> tables;
};
/// Counts texels on every `step`th lookup, and times everything on the calling thread. Prints progress.
Costs measure_costs(const Options& options, const Measurements& m);

/// Whether shd has the least error among settings of at most `budget` texels.
struct FrontRow {
  size_t workload, texture;
  Who peer;
  double budget;
  size_t own, other;    // the best settings; SIZE_MAX = none within the budget
  double lead;          // PSNR of shd less that of the peer [dB]
  double default_lead;  // the lead of shd's SHD_PROFILE_LEAST_ERROR alone [dB]
};
constexpr double kBudgets[] = {4, 8, 12, 16, 24, 32};
/// Differences of PSNR that are not counted [dB]: values of llvmpipe have 8 bits.
constexpr double kTie = 0.05;
/// PSNR above which pictures count as equal to the truth [dB]: an error of a fortieth of a step of 8 bits.
constexpr double kNoError = 80;
std::vector<FrontRow> fronts(const Measurements& m, const Costs& costs);

}  // namespace shootout
