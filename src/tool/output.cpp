// SPDX-License-Identifier: MIT
#include "tool/output.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <vector>

#include <sys/stat.h>

#include "command/suggest.h"
#include "command/values.h"

namespace {

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::string output_of(const Options& options) {
  return options.output.empty() && !options.hash ? "out.png" : options.output;
}

#ifdef SHD_RENDER_WITH_COLOR
void check_name(const char* option, const std::string& value, const std::vector<std::string>& names) {
  if (std::find(names.begin(), names.end(), value) != names.end()) return;
  command::refuse(option, value, "one of " + command::join(names), names);
}
#endif

}  // namespace

void check_output_name(const Options& options) {
  const std::string name = output_of(options);
  if (name.empty() && options.aovs) throw Failure(kExitUsage, "--hash: --aov and --aovs need -o FILE.exr");
  if (name.empty()) return;
  const size_t folder = name.rfind('/') + 1;
  struct stat status;
  if (folder > 0 && ::stat(name.substr(0, folder).c_str(), &status) != 0) {
    throw Failure(kExitOutput, "-o: there is no folder \"" + name.substr(0, folder) + "\"");
  }
  for (const char* end : {".png", ".tif", ".tiff", ".exr"}) {
    if (ends_with(name, end) && !(options.aovs && !ends_with(name, ".exr"))) return;
  }
  throw Failure(kExitUsage, options.aovs ? "--aov: \"" + name + "\" does not end in .exr"
                                         : "-o: \"" + name + "\" does not end in .png, .tif or .exr");
}

std::string picture_name(const Options& options, uint32_t picture) {
  const std::string name = output_of(options);
  if ((options.turntable == 0 && options.frames == 0) || name.empty()) return name;
  char number[16];
  std::snprintf(number, sizeof number, "-%04u", picture + 1);
  const size_t dot = name.rfind('.');
  return name.substr(0, dot) + number + name.substr(dot);
}

uint64_t picture_hash(const shd_framebuffer* framebuffer, const Options& options) {
  const size_t count = size_t{options.width} * options.height;
  std::vector<float> planes[4];
  for (int c = 0; c < 4; ++c) {
    planes[c].resize(count);
    const shd_f32_out out = shd_f32_out_column(planes[c].data(), 0);
    check(shd_framebuffer_read_plane(framebuffer, static_cast<shd_plane>(SHD_PLANE_R + c), &out), "hash");
  }
  // Fowler, Noll and Vo, "The FNV Non-Cryptographic Hash Algorithm", FNV-1a; the lowest byte of a float first.
  uint64_t hash = 0xcbf29ce484222325;
  for (size_t i = 0; i < count; ++i) {
    for (const std::vector<float>& plane : planes) {
      uint32_t bits;
      std::memcpy(&bits, &plane[i], sizeof bits);
      for (int shift = 0; shift < 32; shift += 8) hash = (hash ^ (bits >> shift & 0xff)) * 0x100000001b3;
    }
  }
  return hash;
}

Color open_color([[maybe_unused]] shd_context* context, [[maybe_unused]] const Options& options) {
  Color color;
#ifdef SHD_RENDER_WITH_COLOR
  const std::string name = output_of(options);
  if (!options.color || name.empty() || ends_with(name, ".exr")) return color;
  check(shd_color_create(context, nullptr, color.out()), "colour config");
  std::vector<std::string> displays, views;
  for (uint32_t i = 0; i < shd_color_get_display_count(color.get()); ++i) {
    displays.push_back(shd_color_get_display_name(color.get(), i));
  }
  check_name("--display", options.display, displays);
  const char* const display = options.display.c_str();
  for (uint32_t i = 0; i < shd_color_get_view_count(color.get(), display); ++i) {
    views.push_back(shd_color_get_view_name(color.get(), display, i));
  }
  check_name("--view", options.view, views);
#endif
  return color;
}

void save_picture([[maybe_unused]] const Color& color, const shd_framebuffer* framebuffer, const Options& options,
                  const std::string& name) {
  shd_save_desc desc = shd_save_desc_default();
  if (!ends_with(name, ".exr")) desc.bit_depth = 8;
  if (options.dither) desc.dither = SHD_DITHER_ORDERED;
#ifdef SHD_RENDER_WITH_COLOR
  shd_color_view view = {color.get(), options.display.c_str(), options.view.c_str()};
  if (color.get()) desc.display = {shd_color_apply_view, &view};
#endif
  check(shd_framebuffer_save(framebuffer, name.c_str(), &desc), name, kExitOutput);
}
