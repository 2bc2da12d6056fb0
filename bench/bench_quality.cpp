// SPDX-License-Identifier: MIT
// quality/<filter>/<shd or peer>/<picture>: similarity of one 512 x 512 frame of the floor to 24 x 24 samples per pixel
// (psnr_db), and for the exact filter to 64 x 64 (psnr64_db). The bits of shd are equal on every target. In
// <picture>_45 the texture is turned by 45 degrees, where axis-aligned filters blur.
#include <fstream>
#include <map>
#include <memory>

#include "supersample.h"
#include "texture_setup.h"

namespace shd::bench {
namespace {

constexpr uint32_t kQualityFrame = 512;
constexpr uint32_t kQualityTexture = 2048;
[[maybe_unused]] constexpr char kPhotograph[] = "/usr/share/xplanet/images/earth.jpg";
/// Two and a half texels per pixel in front, fifty across at the horizon: most of the frame is minified.
constexpr Floor kFloor = {20.0f, 1.25f, kQualityFrame};
constexpr Floor kTurnedFloor = {20.0f, 1.25f, kQualityFrame, true};

/// Name of the photograph, or of noise if the file or its reader is missing.
std::string photograph_name() {
#ifdef SHD_BENCH_OIIO
  if (std::ifstream(kPhotograph).good()) return "earth";
#endif
  return "noise";
}

const Picture& picture_of(const std::string& name) {
  static std::map<std::string, Picture> cache;
  Picture& picture = cache[name];
  if (!picture.rgba.empty()) return picture;
  if (name == "checker") picture = make_checker(kQualityTexture, 64);
  if (name == "noise") picture = make_noise(kQualityTexture);
#ifdef SHD_BENCH_OIIO
  if (name == "earth") picture = {name, kQualityTexture, load_rgba8(kPhotograph, kQualityTexture)};
#endif
  return picture;
}

const std::vector<float>& truth(const Floor& floor, const Picture& picture, int samples) {
  static std::map<std::string, std::vector<float>> cache;
  const std::string name = picture.name + (floor.turned ? "_45" : "") + "-truth" + std::to_string(samples);
  std::vector<float>& image = cache[name];
  if (image.empty()) {
    image = supersample(floor, picture, samples);
    maybe_write("quality-" + name, image);
  }
  return image;
}

std::vector<float> image_of(const Filter& filter, const std::string& who, const Floor& floor, const Picture& picture) {
  static const Lookups straight = floor_lookups(kFloor), turned = floor_lookups(kTurnedFloor);
  const Lookups& lookups = floor.turned ? turned : straight;
  if (who == "shd") return filtered_image(filter, lookups, picture.edge, picture.rgba);
  std::unique_ptr<Peer> pass;
#ifdef SHD_BENCH_OSMESA
  if (who == "llvmpipe")
    pass = make_llvmpipe_surface(floor_surface(floor), floor.frame, picture.edge, picture.rgba, filter.peer);
#endif
#ifdef SHD_BENCH_LAVAPIPE
  if (who == "lavapipe") pass = make_lavapipe(lookups, picture.edge, picture.rgba, filter.peer);
#endif
#ifdef SHD_BENCH_OIIO
  if (who == "openimageio") pass = make_openimageio(lookups, picture.edge, picture.rgba, filter.peer);
#endif
  pass->run();
  return pass->image();
}

void run(benchmark::State& state, const Filter& filter, const std::string& who, const Floor& floor,
         const std::string& name) {
  const Picture& picture = picture_of(name);
  if (picture.rgba.empty()) return state.SkipWithError("the picture cannot be read");
  std::vector<float> image;
  for (auto _ : state) image = image_of(filter, who, floor, picture);
  maybe_write("quality-" + name + (floor.turned ? "_45-" : "-") + filter.name + "-" + who, image);
  state.counters["psnr_db"] = psnr(image, truth(floor, picture, 24));
  if (filter.filter == SHD_FILTER_EXACT) state.counters["psnr64_db"] = psnr(image, truth(floor, picture, 64));
}

void add(const Filter& filter, const std::string& who, const Floor& floor, const std::string& picture) {
  const std::string name = std::string("quality/") + filter.name + "/" + who + "/" + picture;
  benchmark::RegisterBenchmark((floor.turned ? name + "_45" : name).c_str(),
                               [=](benchmark::State& state) { run(state, filter, who, floor, picture); })
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
}

/// Axis-aligned filters, and two others.
bool is_turned(const Filter& filter) {
  return filter.filter == SHD_FILTER_RIPMAP || filter.filter == SHD_FILTER_SUMMED_AREA ||
         filter.filter == SHD_FILTER_ANISOTROPIC || filter.filter == SHD_FILTER_EWA;
}

}  // namespace

void register_quality() {
  for (const std::string& picture : {std::string("checker"), photograph_name()}) {
    for (const Filter& filter : kFilters) {
      add(filter, "shd", kFloor, picture);
      if (is_turned(filter) && picture == "checker") add(filter, "shd", kTurnedFloor, picture);
      if (!has_own_peers(filter)) continue;
#ifdef SHD_BENCH_OSMESA
      add(filter, "llvmpipe", kFloor, picture);
#endif
#ifdef SHD_BENCH_LAVAPIPE
      if (lavapipe_problem().empty()) add(filter, "lavapipe", kFloor, picture);
#endif
#ifdef SHD_BENCH_OIIO
      add(filter, "openimageio", kFloor, picture);
#endif
    }
  }
}

}  // namespace shd::bench
