// SPDX-License-Identifier: MIT
/// shd-viewer: a window that shows a model, and explains the texture lookup of each pixel.
#include <cstdio>

#include "app.h"
#include "command/program.h"

namespace {

/// Writes the viewport without a window. Returns the exit code.
int write_picture(viewer::Options options) {
  const float scale = options.scale > 0.0f ? options.scale : 1.0f;
  const viewer::Layout layout = viewer::layout_of(options.width, options.height, scale);
  options.state.width = static_cast<uint32_t>(layout.viewport.width);
  options.state.height = static_cast<uint32_t>(layout.viewport.height);
  viewer::Stage stage(options.threads);
  const viewer::Picture picture = stage.show(options.state, shd_progress{}, nullptr);
  const uint32_t divider = viewer::divider_column(options.state);
  std::string error = picture.error;
  if (error.empty()) error = viewer::save_viewport(picture, divider, options.picture);
  if (error.empty()) return 0;
  std::fprintf(stderr, "shd-viewer: %s\n", error.c_str());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  return command::run("shd-viewer", [&] {
    viewer::Options options;
    if (!viewer::read_options(argc, argv, options)) return 0;
    if (!options.picture.empty()) return write_picture(options);
    viewer::App app(options);
    if (!options.screenshot.empty()) return app.screenshot();
    app.run();
    return 0;
  });
}
