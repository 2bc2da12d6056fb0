// SPDX-License-Identifier: MIT
#include "io/maketx/color.h"

#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "command/failure.h"
#include "command/suggest.h"

#ifdef SHD_MAKETX_WITH_COLOR
#include <shd/color.h>
#endif

namespace {

#ifdef SHD_MAKETX_WITH_COLOR

class OcioConverter : public Converter {
 public:
  explicit OcioConverter(const Options& options) : from_(options.color_from), to_(options.color_to) {
    check(shd_context_create(nullptr, &context_), "context");
    check(shd_color_create(context_, nullptr, &color_), "colour config");
    for (const std::string* const space : {&from_, &to_}) {
      float pixel[4] = {0, 0, 0, 1};
      if (run(pixel, 1, *space, *space) != SHD_OK) refuse_space(*space);
    }
  }
  ~OcioConverter() override {
    shd_color_release(color_);
    shd_context_release(context_);
  }
  void convert(float* pixels, size_t count) const override { check(run(pixels, count, from_, to_), "--colorconvert"); }

 private:
  shd_result run(float* pixels, size_t count, const std::string& from, const std::string& to) const {
    shd_image image = shd_image_default();
    image.format = SHD_FORMAT_RGBA32F;
    image.width = static_cast<uint32_t>(count);
    image.height = 1;
    image.pixels = pixels;
    return shd_color_convert(color_, &image, from.c_str(), to.c_str());
  }

  [[noreturn]] void refuse_space(const std::string& space) const {
    std::vector<std::string> names;
    for (size_t i = 0; i < shd_color_get_space_count(color_); ++i) {
      names.push_back(shd_color_get_space_name(color_, i));
    }
    command::refuse("--colorconvert", space, "a colour space or role of the config", names);
  }

  shd_context* context_ = nullptr;
  shd_color* color_ = nullptr;
  std::string from_, to_;
};

#endif

}  // namespace

std::string config_text(const Options& options) {
  const char* const config = std::getenv("OCIO");
  if (options.color_from.empty() || !config || !*config) return "";
  struct stat status;
  if (::stat(config, &status) != 0) return std::string("\n") + config;   // make_converter() refuses it
  std::string text = "\n" + std::filesystem::absolute(config).string();  // a config finds its tables beside itself
  for (const int64_t number :
       {int64_t{status.st_size}, int64_t{status.st_mtim.tv_sec}, int64_t{status.st_mtim.tv_nsec}}) {
    text += "\n" + std::to_string(number);
  }
  return text;
}

std::unique_ptr<Converter> make_converter(const Options& options) {
  if (options.color_from.empty()) return nullptr;
#ifdef SHD_MAKETX_WITH_COLOR
  return std::make_unique<OcioConverter>(options);
#else
  throw Failure(kExitUsage, "--colorconvert: this shd-maketx was built without libshd_color and OpenColorIO");
#endif
}
