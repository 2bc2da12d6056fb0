// SPDX-License-Identifier: MIT
#include "tool/output.h"

#include <cstdio>

#ifdef SHD_RENDER_WITH_COLOR
#include <shd/color.h>
#endif

#include "tool/failure.h"

namespace {

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

#ifdef SHD_RENDER_WITH_COLOR
using Color = Owned<shd_color, shd_color_release>;
#endif

}  // namespace

void check_output_name(const Options& options) {
  const std::string& name = options.output;
  for (const char* end : {".png", ".tif", ".tiff", ".exr"}) {
    if (ends_with(name, end) && !(options.aovs && !ends_with(name, ".exr"))) return;
  }
  throw Failure(kExitUsage, options.aovs ? "--aov: \"" + name + "\" does not end in .exr"
                                         : "-o: \"" + name + "\" does not end in .png, .tif or .exr");
}

std::string picture_name(const Options& options, uint32_t picture) {
  if (options.turntable == 0 && options.frames == 0) return options.output;
  char number[16];
  std::snprintf(number, sizeof number, "-%04u", picture + 1);
  const size_t dot = options.output.rfind('.');
  return options.output.substr(0, dot) + number + options.output.substr(dot);
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
