// SPDX-License-Identifier: MIT
// default/<filter>/<rule>: the error of one rule of the level of detail, width or bias over five scenes and every
// picture, under a box of one pixel and a tent of two. The defaults of shd_profile are chosen from these rows.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>

#include "scenes.h"
#include "texture_setup.h"

namespace shd::bench {
namespace {

constexpr uint32_t kFrame = 256, kEdge = 1024, kMovingFrame = 96;
constexpr int kSamples = 24, kMovingSamples = 12, kMovingFrames = 60;

struct Test {
  Picture picture;
  bool photograph;
};

/// The synthetic pictures, and the photographs of the folder in SHD_BENCH_PHOTOGRAPHS.
const std::vector<Test>& tests() {
  static std::vector<Test> tests;
  if (!tests.empty()) return tests;
  tests = {{make_checker(kEdge, 32), false}, {make_noise(kEdge), false}, {make_zone_plate(kEdge), false}};
#ifdef SHD_BENCH_OIIO
  const char* folder = std::getenv("SHD_BENCH_PHOTOGRAPHS");
  std::vector<std::filesystem::path> files;
  if (folder) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    Picture picture{file.stem(), kEdge, load_rgba8(file, kEdge)};
    if (!picture.rgba.empty()) tests.push_back({picture, true});
  }
#endif
  return tests;
}

const Truth& truth_of(const Scene& scene, const Picture& picture, int samples) {
  static std::map<std::string, Truth> cache;
  const std::string name = picture.name + "-" + name_of(scene.shape) + std::to_string(scene.zoom) + "-" +
                           std::to_string(scene.move) + "-" + std::to_string(samples);
  Truth& truth = cache[name];
  if (truth.box.empty()) truth = supersample(scene, picture, samples);
  return truth;
}

/// Level of detail of half axes s1 >= s2 in texels.
using Rule = std::function<double(double s1, double s2)>;

/// A way to filter: a filter of shd with a rule for the `lod` column, or a peer.
struct Candidate {
  std::string name;
  Filter filter;
  Rule rule = nullptr;
  bool peer = false;
};

/// Fills the column `lod` by a rule.
void give_levels(const Rule& rule, Lookups* q) {
  q->lod.resize(q->count());
  for (size_t i = 0; i < q->count(); ++i) {
    const double edge = kEdge;
    const double a = edge * static_cast<double>(q->dudx[i]), b = edge * static_cast<double>(q->dvdx[i]);
    const double c = edge * static_cast<double>(q->dudy[i]), e = edge * static_cast<double>(q->dvdy[i]);
    const double mean = (a * a + b * b + c * c + e * e) / 2, determinant = std::fabs(a * e - b * c);
    const double root = std::sqrt(std::max(mean * mean - determinant * determinant, 0.0));
    const double s1 = std::sqrt(mean + root);
    q->lod[i] = static_cast<float>(rule(s1, determinant / s1));
  }
}

std::vector<float> image_of(const Candidate& candidate, const Scene& scene, const Picture& picture) {
  Lookups lookups = scene_lookups(scene);
#ifdef SHD_BENCH_OIIO
  if (candidate.peer) {
    const auto pass = make_openimageio(lookups, picture.edge, picture.rgba, candidate.filter.peer);
    pass->run();
    return pass->image();
  }
#endif
  if (candidate.rule) give_levels(candidate.rule, &lookups);
  return filtered_image(candidate.filter, lookups, picture.edge, picture.rgba);
}

double decibels(double error) {
  return -10 * std::log10(error);
}

/// Mean of decibels, and decibels of the mean error.
struct Score {
  double sum = 0, error = 0, count = 0;
  void add(double square) {
    sum += decibels(square);
    error += square;
    ++count;
  }
};

/// Root mean square of the second difference in time of the error of moving frames.
double flicker_of(const Candidate& candidate, bool flight) {
  double sum = 0, count = 0;
  for (const Test& test : tests()) {
    std::vector<float> before[2];
    for (int t = 0; t < kMovingFrames; ++t) {
      const double phase = static_cast<double>(t) / (kMovingFrames - 1);
      Scene scene = {flight ? Shape::kFloor : Shape::kPlane, kMovingFrame};
      scene.zoom = flight ? 0.4 : 0.12 * std::exp2(2 * phase);
      scene.move = flight ? 0.05 * phase : 0;
      const Truth& truth = truth_of(scene, test.picture, kMovingSamples);
      std::vector<float> error = image_of(candidate, scene, test.picture);
      for (size_t i = 0; i < error.size(); ++i) error[i] -= truth.box[i];
      for (size_t i = 0; t >= 2 && i < error.size(); ++i) {
        const double second =
            static_cast<double>(error[i]) - 2 * static_cast<double>(before[1][i]) + static_cast<double>(before[0][i]);
        if (i % 4 == 3) continue;
        sum += second * second;
        ++count;
      }
      before[0].swap(before[1]);
      before[1].swap(error);
    }
  }
  return std::sqrt(sum / count);
}

/// Mean squared error under the box of each picture of the peer of the same name.
const std::vector<double>& peer_errors(PeerFilter filter) {
  static std::map<PeerFilter, std::vector<double>> cache;
  std::vector<double>& errors = cache[filter];
  if (!errors.empty()) return errors;
  Candidate peer = {"", {}, nullptr, true};
  peer.filter.peer = filter;
  for (const Test& test : tests()) {
    for (const Shape shape : kStills) {
      const Scene scene = {shape, kFrame};
      errors.push_back(
          mean_square_error(image_of(peer, scene, test.picture), truth_of(scene, test.picture, kSamples).box));
    }
  }
  return errors;
}

void run(benchmark::State& state, const Candidate& candidate) {
  Score box[2], tent[2];
  std::vector<double> errors;
  for (auto _ : state) {
    for (const Test& test : tests()) {
      for (const Shape shape : kStills) {
        const Scene scene = {shape, kFrame};
        const Truth& truth = truth_of(scene, test.picture, kSamples);
        const std::vector<float> image = image_of(candidate, scene, test.picture);
        maybe_write("default-" + candidate.name + "-" + test.picture.name + "-" + name_of(shape), image);
        errors.push_back(mean_square_error(image, truth.box));
        box[test.photograph].add(errors.back());
        tent[test.photograph].add(mean_square_error(image, truth.tent));
      }
    }
  }
  for (int photograph = 0; photograph < 2; ++photograph) {
    if (box[photograph].count == 0) continue;
    const std::string kind = photograph ? "photo" : "synth";
    state.counters[kind + "_box"] = box[photograph].sum / box[photograph].count;
    state.counters[kind + "_tent"] = tent[photograph].sum / tent[photograph].count;
  }
  const double all = box[0].sum + tent[0].sum + box[1].sum + tent[1].sum;
  state.counters["mean"] = all / (2 * (box[0].count + box[1].count));
  if (std::getenv("SHD_BENCH_FLICKER")) {
    state.counters["flick_zoom"] = flicker_of(candidate, false);
    state.counters["flick_flight"] = flicker_of(candidate, true);
  }
#ifdef SHD_BENCH_OIIO
  if (candidate.peer || candidate.filter.peer == PeerFilter::kNone) return;
  const std::vector<double>& peer = peer_errors(candidate.filter.peer);
  double behind = 0;
  double worst = 1e9;
  for (size_t i = 0; i < errors.size(); ++i) {
    behind += errors[i] > peer[i];
    if (std::getenv("SHD_BENCH_DETAIL"))
      std::fprintf(stderr, "%s %s %s %.2f %.2f\n", candidate.name.c_str(), tests()[i / 5].picture.name.c_str(),
                   name_of(kStills[i % 5]), decibels(errors[i]), decibels(peer[i]));
    worst = std::min(worst, decibels(errors[i]) - decibels(peer[i]));
  }
  state.counters["behind"] = behind;
  state.counters["worst"] = worst;
#endif
}

void add(const Candidate& candidate) {
  benchmark::RegisterBenchmark(("default/" + candidate.name).c_str(),
                               [=](benchmark::State& state) { run(state, candidate); })
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
}

const Filter& filter_named(const char* name) {
  for (const Filter& filter : kFilters) {
    if (filter.name == name) return filter;
  }
  std::abort();
}

std::string signed_name(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%+.3g", value);
  return text;
}

void add_rules(const char* name) {
  const Filter& filter = filter_named(name);
  const auto rms = [](double s1, double s2) { return std::log2(std::sqrt((s1 * s1 + s2 * s2) / 2)); };
  const auto longer = [](double s1, double) { return std::log2(s1); };
  const auto middle = [](double s1, double s2) { return std::log2(s1 * s2) / 2; };
  const auto mean = [](double s1, double s2) { return std::log2((s1 + s2) / 2); };
  for (const double bias : {0.0, -0.25, -0.375, -0.5, -0.625, -0.75, -1.0}) {
    const auto with = [&](const char* rule, const Rule& level) {
      add({std::string(name) + "/" + rule + signed_name(bias), filter,
           [=](double s1, double s2) { return level(s1, s2) + bias; }});
    };
    with("longer", longer);
    with("rms", rms);
    with("mean", mean);
    with("geometric", middle);
  }
}

}  // namespace

void register_defaults() {
  for (const Filter& filter : kFilters) {
    if (!filter.reads_derivatives || filter.every != 1 || filter.precision != SHD_PRECISION_FULL) continue;
    if (filter.filter == SHD_FILTER_STOCHASTIC) continue;
    const std::string name = filter.name;
    add({name + "/default", filter});
    if (has_own_peers(filter)) add({name + "/openimageio", filter, nullptr, true});
    if (filter.profile != SHD_PROFILE_LEAST_ERROR) continue;
    for (const double bias : {0.0, -0.125, -0.25, -0.375, -0.5, -0.625, -0.75}) {
      Filter biased = filter;
      biased.profile = SHD_PROFILE_EXACT;
      biased.bias = static_cast<float>(bias);
      add({name + "/exact" + signed_name(bias), biased});
    }
  }
  for (const char* name : {"nearest_mip", "bilinear_mip", "trilinear"}) add_rules(name);
  for (const float limit : {1.0f, 2.0f, 4.0f, 8.0f}) {
    for (const shd_profile profile : {SHD_PROFILE_LEAST_ERROR, SHD_PROFILE_EXACT}) {
      Filter filter = filter_named("anisotropic");
      filter.profile = profile;
      filter.max_anisotropy = limit;
      filter.peer = PeerFilter::kNone;
      const char* rule = profile == SHD_PROFILE_EXACT ? "/exact" : "/least_error";
      add({"anisotropic" + std::to_string(static_cast<int>(limit)) + rule, filter});
    }
  }
}

}  // namespace shd::bench
