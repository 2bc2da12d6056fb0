// SPDX-License-Identifier: MIT
#include "output.h"

#ifdef SHD_RENDER_WITH_COLOR
#include <shd/color.h>
#endif

#include "failure.h"

namespace {

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

#ifdef SHD_RENDER_WITH_COLOR
using Color = Owned<shd_color, shd_color_release>;

void save_through_display(shd_context* context, const shd_framebuffer* framebuffer, const Options& options) {
  std::vector<unsigned char> pixels(size_t{4} * options.width * options.height);
  shd_image image = shd_image_default();
  image.format = SHD_FORMAT_RGBA8_SRGB;
  image.width = options.width;
  image.height = options.height;
  image.pixels = pixels.data();
  Color color;
  check(shd_color_create(context, nullptr, color.out()), "colour config");
  check(shd_color_apply_display(color.get(), framebuffer, options.display.c_str(), options.view.c_str(), &image),
        "display transform");
  check(shd_image_save(&image, options.output.c_str(), nullptr), options.output, kExitOutput);
}
#endif

}  // namespace

void check_output_name(const Options& options) {
  const std::string& name = options.output;
  for (const char* end : {".png", ".tif", ".tiff", ".exr"}) {
    if (ends_with(name, end) && !(options.aov && !ends_with(name, ".exr"))) return;
  }
  throw Failure(kExitUsage, options.aov ? "--aov: \"" + name + "\" does not end in .exr"
                                        : "-o: \"" + name + "\" does not end in .png, .tif or .exr");
}

void save_picture(shd_context* context, const shd_framebuffer* framebuffer, const Options& options) {
#ifdef SHD_RENDER_WITH_COLOR
  if (options.color && !ends_with(options.output, ".exr")) {
    save_through_display(context, framebuffer, options);
    return;
  }
#endif
  (void)context;
  check(shd_framebuffer_save(framebuffer, options.output.c_str(), nullptr), options.output, kExitOutput);
}
