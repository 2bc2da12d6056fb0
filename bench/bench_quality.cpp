// SPDX-License-Identifier: MIT
// quality/<filter>/<shd or peer>/<picture>: how near one 512 x 512 frame of the floor comes to 24 x 24 samples a pixel
// (psnr_db), and for the exact filter to 64 x 64 (psnr64_db). The bits of shd are those of every target.
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
/// Two and a half texels a pixel in front, fifty across at the horizon: most of the frame is minified.
constexpr Floor kFloor = {20.0f, 1.25f, kQualityFrame};

/// The photograph, or noise where that file or its reader is missing.
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

const std::vector<float>& truth(const Picture& picture, int samples) {
  static std::map<std::string, std::vector<float>> cache;
  std::vector<float>& image = cache[picture.name + std::to_string(samples)];
  if (image.empty()) {
    image = supersample(kFloor, picture, samples);
    maybe_write("quality-" + picture.name + "-truth" + std::to_string(samples), image);
  }
  return image;
}

std::vector<float> image_of(const Filter& filter, const std::string& who, const Picture& picture) {
  static const Lookups lookups = floor_lookups(kFloor);
  if (who == "shd") return filtered_image(filter, lookups, picture.edge, picture.rgba);
  std::unique_ptr<Peer> pass;
#ifdef SHD_BENCH_OSMESA
  if (who == "llvmpipe") pass = make_llvmpipe_floor(kFloor, picture.edge, picture.rgba, filter.peer);
#endif
#ifdef SHD_BENCH_OIIO
  if (who == "openimageio") pass = make_openimageio(lookups, picture.edge, picture.rgba, filter.peer);
#endif
  pass->run();
  return pass->image();
}

void run(benchmark::State& state, const Filter& filter, const std::string& who, const std::string& name) {
  const Picture& picture = picture_of(name);
  if (picture.rgba.empty()) return state.SkipWithError("the picture cannot be read");
  std::vector<float> image;
  for (auto _ : state) image = image_of(filter, who, picture);
  if (image.empty()) return state.SkipWithError("not built yet");
  maybe_write("quality-" + name + "-" + filter.name + "-" + who, image);
  state.counters["psnr_db"] = psnr(image, truth(picture, 24));
  if (filter.filter == SHD_FILTER_EXACT) state.counters["psnr64_db"] = psnr(image, truth(picture, 64));
}

void add(const Filter& filter, const std::string& who, const std::string& picture) {
  benchmark::RegisterBenchmark((std::string("quality/") + filter.name + "/" + who + "/" + picture).c_str(),
                               [=](benchmark::State& state) { run(state, filter, who, picture); })
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
}

}  // namespace

void register_quality() {
  for (const std::string& picture : {std::string("checker"), photograph_name()}) {
    for (const Filter& filter : kFilters) {
      add(filter, "shd", picture);
      if (!has_own_peers(filter)) continue;
#ifdef SHD_BENCH_OSMESA
      add(filter, "llvmpipe", picture);
#endif
#ifdef SHD_BENCH_OIIO
      add(filter, "openimageio", picture);
#endif
    }
  }
}

}  // namespace shd::bench
