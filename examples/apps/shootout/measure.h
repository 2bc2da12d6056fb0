// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>

#include "metrics/metrics.h"
#include "peers.h"
#include "settings.h"
#include "textures.h"
#include "workloads/workload.h"

namespace shootout {

struct Options {
  uint32_t edge = 192, texture_edge = 1024, samples = 24;
  uint32_t movie_edge = 64, movie_samples = 8;
  uint32_t threads = 0;       // 0 = one a core
  size_t verdicts = 1000000;  // lookups of each implementation that are judged
  bool quick = false, only_verdicts = false;
  std::string photograph = "/usr/share/xplanet/images/earth.jpg";
  std::string web, out = "out/shootout", figure;
};

struct Errors {
  double psnr, ssim, mean, max, flip;
};

/// One picture of the shoot-out.
struct Row {
  size_t workload, texture, setting;
  Errors samples, exact;             // against supersampling, and against SHD_FILTER_EXACT after shading
  std::optional<Spectrum> spectrum;  // for smooth workloads
  std::string hash;                  // hash of the picture
};

/// One movie.
struct MotionRow {
  size_t workload, texture, setting;
  Motion motion;
};

/// A frame of the page.
struct Frame {
  size_t workload, texture, setting;
  Picture picture;
  std::vector<float> flip;  // error map against supersampling; empty for truth
};
constexpr size_t kTruthSetting = SIZE_MAX;

/// Root mean square error of the cells of the rosette, and the contrast of the level curve's columns over the truth's.
struct RosetteRow {
  size_t setting;
  std::vector<double> errors;
};
struct LevelRow {
  size_t setting;
  std::vector<double> contrast;
};

struct Measurements {
  std::vector<Workload> workloads, movies;
  std::vector<Workload> spectra;  // the workloads with frames of half the edge
  std::vector<Texture> textures;
  std::vector<Setting> settings;
  std::vector<Row> rows;
  std::vector<MotionRow> motions;
  std::vector<RosetteRow> rosette;
  std::vector<LevelRow> levels;
  std::vector<Frame> frames;
};

/// Runs body(0..count - 1) on `threads` threads; the first exception ends the run and is thrown again.
void in_parallel(size_t count, uint32_t threads, const std::function<void(size_t)>& body);

/// Whether the page shows the pictures of this workload with this texture.
bool is_shown(const Measurements& m, size_t workload, size_t texture);

/// Filters and judges everything. Prints progress.
Measurements measure(const Options& options);

}  // namespace shootout
