// SPDX-License-Identifier: MIT
#include "measure.h"

#include <atomic>
#include <cmath>
#include <cstdio>
#include <exception>
#include <mutex>
#include <thread>

#include "shd_pass.h"
#include "truth.h"

namespace shootout {
namespace {

constexpr uint32_t kPhases = 4;  // places of spectra along each axis of a pixel

/// Whether the spectra of a workload and texture are measured. Spectra take 16 times the lookups, so their frames have
/// half the edge, with the same footprints.
bool has_spectrum(const Workload& workload, const Texture& texture) {
  const bool minified = workload.smooth && workload.name.rfind("magnified", 0) != 0 && workload.name != "one_to_one";
  return minified && (texture.name == "checker" || texture.name == "zone_plate");
}

/// Frames of the peers for one texture, which only the main thread can make: [workload][setting].
struct PeerFrames {
  std::vector<std::vector<Picture>> pictures, dense, movies;
};

PeerFrames peer_frames(const Measurements& m, const Texture& texture) {
  Peers peers(texture);
  PeerFrames frames;
  const auto all = [&](const std::vector<Workload>& workloads, uint32_t phases) {
    std::vector<std::vector<Picture>> out(workloads.size(), std::vector<Picture>(m.settings.size()));
    for (size_t w = 0; w < workloads.size(); ++w) {
      if (phases > 1 && !has_spectrum(workloads[w], texture)) continue;
      const Lookups q = lookups_of(workloads[w], phases);
      for (size_t s = 0; s < m.settings.size(); ++s) {
        if (m.settings[s].who == Who::kShd) continue;
        out[w][s] =
            shade(texture.shading, peers.filter(m.settings[s], workloads[w], q, phases), workloads[w].edge * phases);
      }
    }
    return out;
  };
  frames.pictures = all(m.workloads, 1);
  frames.dense = all(m.spectra, kPhases);
  frames.movies = all(m.movies, 1);
  return frames;
}

/// A picture with what comparisons need of it.
struct Judged {
  Picture picture;
  FlipInput flip;
  explicit Judged(Picture p) : picture(std::move(p)), flip(flip_input(picture)) {}
};

Errors errors_of(const Judged& judged, const Judged& truth, std::vector<float>* map) {
  const Difference d = difference(judged.picture, truth.picture);
  *map = flip_map(judged.flip, truth.flip);
  return {psnr(judged.picture, truth.picture), ssim(judged.picture, truth.picture), d.mean, d.max, mean_of(*map)};
}

std::vector<double> rosette_errors(const Picture& picture, const Picture& truth) {
  const uint32_t cell = picture.width / kRosetteCells;
  std::vector<double> errors;
  for (uint32_t k = 0; k < kRosetteCells * kRosetteCells; ++k) {
    double sum = 0.0;
    for (uint32_t i = 0; i < cell * cell; ++i) {
      const uint32_t x = k % kRosetteCells * cell + i % cell, y = k / kRosetteCells * cell + i / cell;
      for (size_t c = 0; c < 3; ++c) {
        const double d = static_cast<double>(picture.at(x, y)[c]) - static_cast<double>(truth.at(x, y)[c]);
        sum += d * d;
      }
    }
    errors.push_back(std::sqrt(sum / (3.0 * cell * cell)));
  }
  return errors;
}

/// All settings on one workload and texture.
class Cell {
 public:
  Cell(const Options& options, const Measurements& m, const std::vector<ShdPass>& passes, size_t workload,
       size_t texture)
      : m_(m), passes_(passes), w_(workload), t_(texture), options_(options) {}

  void run(const PeerFrames& peers) {
    const Workload& workload = m_.workloads[w_];
    const Texture& texture = m_.textures[t_];
    const bool dense = has_spectrum(workload, texture);
    const Workload& half = m_.spectra[w_];
    const Lookups q = lookups_of(workload), q_dense = dense ? lookups_of(half, kPhases) : Lookups();
    const Judged truth(supersample(workload, texture, options_.samples));
    const Picture dense_truth = dense ? supersample(half, texture, kDenseSamples, kPhases) : Picture();
    const size_t last = last_shd();
    const Judged exact(shade(texture.shading, passes_[last].filter(q), workload.edge));
    keep(kTruthSetting, truth.picture, {});
    for (size_t s = 0; s < m_.settings.size(); ++s) {
      const bool own = m_.settings[s].who == Who::kShd;
      const Judged judged(own ? shade(texture.shading, passes_[s].filter(q), workload.edge) : peers.pictures[w_][s]);
      Row row = {w_, t_, s, {}, {}, {}, hash_of(judged.picture)};
      std::vector<float> map, map_exact;
      row.samples = errors_of(judged, truth, &map);
      row.exact = errors_of(judged, exact, &map_exact);
      if (dense && s != last) {
        const Picture fine =
            own ? shade(texture.shading, passes_[s].filter(q_dense), half.edge * kPhases) : peers.dense[w_][s];
        row.spectrum = spectrum(fine, dense_truth, kPhases);
      }
      rows.push_back(row);
      keep(s, judged.picture, std::move(map));
      if (workload.name == "rosette" && texture.name == "photograph") {
        rosette.push_back({s, rosette_errors(judged.picture, truth.picture)});
      }
    }
  }

  std::vector<Row> rows;
  std::vector<Frame> frames;
  std::vector<RosetteRow> rosette;

 private:
  static constexpr uint32_t kDenseSamples = 16;

  /// SHD_FILTER_EXACT, the last setting of shd.
  size_t last_shd() const { return passes_.size() - 1; }
  void keep(size_t setting, const Picture& picture, std::vector<float> map) {
    const bool shown = setting == kTruthSetting || m_.settings[setting].pictured;
    if (shown && is_shown(m_, w_, t_)) frames.push_back({w_, t_, setting, picture, std::move(map)});
  }

  const Measurements& m_;
  const std::vector<ShdPass>& passes_;
  size_t w_, t_;
  const Options& options_;
};

std::vector<MotionRow> movie_rows(const Options& options, const Measurements& m, const std::vector<ShdPass>& passes,
                                  const PeerFrames& peers, size_t movie, size_t texture) {
  const Workload& workload = m.movies[movie];
  const Texture& texels = m.textures[texture];
  const Lookups q = lookups_of(workload);
  const Picture truth = supersample(workload, texels, options.movie_samples);
  std::vector<MotionRow> rows;
  for (size_t s = 0; s < m.settings.size(); ++s) {
    if (m.settings[s].sampler.filter == SHD_FILTER_EXACT) continue;  // minutes for movies
    const Picture picture = m.settings[s].who == Who::kShd ? shade(texels.shading, passes[s].filter(q), workload.edge)
                                                           : peers.movies[movie][s];
    rows.push_back({movie, texture, s, motion(picture, truth, options.movie_edge, kMovieColumns, kMovieFrames)});
  }
  return rows;
}

/// Standard deviation of the luma of each column.
std::vector<double> column_contrast(const Picture& picture) {
  std::vector<double> contrast;
  for (uint32_t x = 0; x < picture.width; ++x) {
    double sum = 0.0, squares = 0.0;
    for (uint32_t y = 0; y < picture.height; ++y) {
      const auto value = static_cast<double>(picture.at(x, y)[1]);
      sum += value;
      squares += value * value;
    }
    const double mean = sum / picture.height;
    contrast.push_back(std::sqrt(std::max(squares / picture.height - mean * mean, 0.0)));
  }
  return contrast;
}

void measure_levels(const Options& options, Measurements* m) {
  const Texture noise = make_white_noise(options.texture_edge);
  const Workload workload = level_curve(options.edge, options.texture_edge);
  const Lookups q = lookups_of(workload);
  // Samples are too few for 64 x 64 independent texels, so the truth is SHD_FILTER_EXACT.
  const ShdPass exact(noise, setting_named(m->settings, "exact"));
  const std::vector<double> truth = column_contrast(shade(Shading::kColour, exact.filter(q), workload.edge));
  Peers peers(noise);
  for (size_t s = 0; s < m->settings.size(); ++s) {
    const Setting& setting = m->settings[s];
    if (setting.sampler.filter == SHD_FILTER_EXACT) continue;
    const std::vector<float> rgba =
        setting.who == Who::kShd ? ShdPass(noise, setting).filter(q) : peers.filter(setting, workload, q);
    LevelRow row = {s, column_contrast(shade(Shading::kColour, rgba, workload.edge))};
    for (size_t i = 0; i < truth.size(); ++i) row.contrast[i] /= std::max(truth[i], 1e-6);
    m->levels.push_back(row);
  }
}

void measure_texture(const Options& options, size_t texture, Measurements* m) {
  std::printf("   %s\n", m->textures[texture].title.c_str());
  std::fflush(stdout);
  const PeerFrames peers = peer_frames(*m, m->textures[texture]);
  std::vector<ShdPass> passes;
  for (const Setting& setting : m->settings) {
    if (setting.who == Who::kShd) passes.emplace_back(m->textures[texture], setting);
  }
  std::mutex mutex;
  const size_t stills = m->workloads.size();
  in_parallel(stills + m->movies.size(), options.threads, [&](size_t i) {
    if (i >= stills) {
      const auto rows = movie_rows(options, *m, passes, peers, i - stills, texture);
      const std::lock_guard<std::mutex> lock(mutex);
      m->motions.insert(m->motions.end(), rows.begin(), rows.end());
      return;
    }
    Cell cell(options, *m, passes, i, texture);
    cell.run(peers);
    const std::lock_guard<std::mutex> lock(mutex);
    m->rows.insert(m->rows.end(), cell.rows.begin(), cell.rows.end());
    m->rosette.insert(m->rosette.end(), cell.rosette.begin(), cell.rosette.end());
    for (Frame& frame : cell.frames) m->frames.push_back(std::move(frame));
  });
}

}  // namespace

void in_parallel(size_t count, uint32_t threads, const std::function<void(size_t)>& body) {
  std::atomic<size_t> next{0};
  std::exception_ptr failure;
  std::mutex mutex;
  const auto work = [&] {
    for (size_t i = next++; i < count; i = next++) {
      try {
        body(i);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(mutex);
        if (!failure) failure = std::current_exception();
        next = count;
      }
    }
  };
  if (threads == 0) threads = std::max(std::thread::hardware_concurrency(), 1u);
  std::vector<std::thread> others;
  for (uint32_t i = 1; i < threads; ++i) others.emplace_back(work);
  work();
  for (std::thread& other : others) other.join();
  if (failure) std::rethrow_exception(failure);
}

bool is_shown(const Measurements& m, size_t workload, size_t texture) {
  const std::string &w = m.workloads[workload].name, &t = m.textures[texture].name;
  if (t == "checker") return w == "floor" || w == "floor_45" || w == "tunnel";
  if (t == "zone_plate") return w == "conformal" || w == "one_to_one_turned";
  if (t == "photograph") return w == "sphere";
  if (t == "text") return w == "one_to_one" || w == "magnified_2" || w == "magnified_8" || w == "magnified_64";
  return w == "floor_45";
}

Measurements measure(const Options& options) {
  Measurements m;
  m.workloads = still_workloads(options.edge, options.texture_edge);
  m.spectra = still_workloads(options.edge / 2, options.texture_edge);
  m.movies = movies(options.movie_edge, options.texture_edge);
  m.settings = all_settings();
  if (options.quick) {
    for (const char* name : {"checker", "text"}) {
      m.textures.push_back(make_texture(name, options.texture_edge, options.photograph));
    }
  } else {
    m.textures = all_textures(options.texture_edge, options.photograph);
  }
  for (size_t t = 0; t < m.textures.size(); ++t) measure_texture(options, t, &m);
  measure_levels(options, &m);
  return m;
}

}  // namespace shootout
