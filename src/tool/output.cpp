// SPDX-License-Identifier: MIT
#include "tool/output.h"

#include <cstdio>
#include <cstring>
#include <vector>

#ifdef SHD_RENDER_WITH_COLOR
#include <shd/color.h>
#endif

#include "command/failure.h"

namespace {

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::string output_of(const Options& options) {
  return options.output.empty() && !options.hash ? "out.png" : options.output;
}

#ifdef SHD_RENDER_WITH_COLOR
using Color = Owned<shd_color, shd_color_release>;
#endif

}  // namespace

void check_output_name(const Options& options) {
  const std::string name = output_of(options);
  if (name.empty() && options.aovs) throw Failure(kExitUsage, "--hash: --aov and --aovs need -o FILE.exr");
  if (name.empty()) return;
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

void save_picture(shd_context* context, const shd_framebuffer* framebuffer, const Options& options,
                  const std::string& name) {
  shd_save_desc desc = shd_save_desc_default();
  const bool is_linear = ends_with(name, ".exr");
  if (!is_linear) desc.bit_depth = 8;
  if (options.dither) desc.dither = SHD_DITHER_ORDERED;
#ifdef SHD_RENDER_WITH_COLOR
  Color color;
  shd_color_view view = {nullptr, options.display.c_str(), options.view.c_str()};
  if (options.color && !is_linear) {
    check(shd_color_create(context, nullptr, color.out()), "colour config");
    view.color = color.get();
    desc.display = {shd_color_apply_view, &view};
  }
#else
  (void)context;
#endif
  check(shd_framebuffer_save(framebuffer, name.c_str(), &desc), name, kExitOutput);
}
