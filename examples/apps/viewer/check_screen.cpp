// SPDX-License-Identifier: MIT
/// Compares a screenshot of the viewer with a picture that is rendered here, without a window.
///
///     check_screen SCREENSHOT [options of the viewer]
///     check_screen SCREENSHOT --error
///
/// All options are those of the screenshot. Pixels near marks that the window draws over the picture are left out:
/// the divider with its labels, the ring around the picked pixel, and the magnifier, whose cells are checked.
/// With --error the window must show a message.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include <shd/io.h>

#include "layout.h"
#include "options.h"
#include "stage.h"

namespace {

using namespace viewer;

constexpr int kDividerMark = 22, kLabelRows = 48, kLabelColumns = 330, kPickMark = 16;

bool is_marked(const Options& options, int x, int y) {
  const State& state = options.state;
  if (state.wipe) {
    const int away = std::abs(x - static_cast<int>(divider_column(state)));
    const int middle = std::abs(y - static_cast<int>(state.height / 2));
    if (away <= 2 || (away <= kDividerMark && middle <= kDividerMark)) return true;
    if (y < kLabelRows && away < kLabelColumns) return true;
  }
  if (state.pick && std::abs(x - static_cast<int>(state.pick->x)) <= kPickMark &&
      std::abs(y - static_cast<int>(state.pick->y)) <= kPickMark) {
    return true;
  }
  const MagnifierLayout place = magnifier_layout({0, 0, int(state.width), int(state.height)}, 1.0f);
  const int right = place.x + place.cell * kMagnifiedColumns + place.margin, top = place.y - place.margin;
  return options.magnify && x <= right && y >= top - 1;
}

/// Pixels of the window, RGBA. Empty if the file cannot be read or has another size.
std::vector<uint8_t> read_window(shd_context* context, const char* path, const Options& options) {
  shd::load_desc desc;
  desc.flags = SHD_LOAD_IN_PROCESS;  // the viewer has just written the file
  const shd::bitmap bitmap = shd::bitmap_load(context, path, &desc);
  const shd_image image = shd::bitmap_get_image(bitmap);
  if (static_cast<int>(image.width) != options.width || static_cast<int>(image.height) != options.height) return {};
  if (shd_format_size(image.format) != 4) return {};
  std::vector<uint8_t> pixels(size_t{4} * image.width * image.height);
  const size_t stride = image.row_stride ? image.row_stride : size_t{4} * image.width;
  for (uint32_t y = 0; y < image.height; ++y) {
    std::memcpy(&pixels[size_t{4} * image.width * y], static_cast<const uint8_t*>(image.pixels) + y * stride,
                size_t{4} * image.width);
  }
  return pixels;
}

/// The panel shows texts: bright pixels on a dark ground.
bool has_panel(const std::vector<uint8_t>& window, const Options& options, const Rect& panel) {
  size_t bright = 0, dark = 0;
  for (int y = 0; y < panel.height; ++y) {
    for (int x = panel.x; x < panel.x + panel.width; ++x) {
      const uint8_t* p = &window[4 * (size_t(y) * size_t(options.width) + size_t(x))];
      bright += p[1] > 170, dark += p[1] < 80;
    }
  }
  return bright > 1500 && dark > size_t(panel.width) * size_t(panel.height) / 2;
}

/// Each cell of the magnifier has the colour of its pixel near its corner, where no number is.
bool has_magnifier(const std::vector<uint8_t>& window, const std::vector<uint8_t>& wanted, const Options& options) {
  const State& state = options.state;
  const MagnifierLayout place = magnifier_layout({0, 0, int(state.width), int(state.height)}, 1.0f);
  const Pixel first = first_magnified(*options.magnify, state.width, state.height);
  for (int row = 0; row < kMagnifiedRows; ++row) {
    for (int column = 0; column < kMagnifiedColumns; ++column) {
      const int x = place.x + column * place.cell + 4, y = place.y + row * place.cell + 4;
      const uint8_t* shown = &window[4 * (size_t(y) * size_t(options.width) + size_t(x))];
      const size_t pixel = size_t(first.y + uint32_t(row)) * state.width + first.x + uint32_t(column);
      if (std::memcmp(shown, &wanted[4 * pixel], 3) != 0) return false;
    }
  }
  return true;
}

/// A window without a picture, whose middle is the message: its ground and its red bar.
int check_error(const char* path) {
  const shd::context context = shd::context_create(nullptr);
  const std::vector<uint8_t> window = read_window(context, path, Options());
  size_t ground = 0, bar = 0;
  for (size_t i = 0; i < window.size(); i += 4) {
    ground += window[i] > 50 && window[i] < 70 && window[i + 1] > 30 && window[i + 1] < 45;
    bar += window[i] > 200 && window[i + 1] > 70 && window[i + 1] < 100 && window[i + 2] < 90;
  }
  std::printf("%s: %zu pixels of the message, %zu of its bar\n", path, ground, bar);
  return ground > 20000 && bar > 300 ? 0 : 1;
}

int compare(const char* path, Options options) {
  const Layout layout = layout_of(options.width, options.height, options.scale > 0.0f ? options.scale : 1.0f);
  options.state.width = static_cast<uint32_t>(layout.viewport.width);
  options.state.height = static_cast<uint32_t>(layout.viewport.height);
  const shd::context context = shd::context_create(nullptr);
  const std::vector<uint8_t> window = read_window(context, path, options);
  if (window.empty()) return std::printf("%s: not a window of %d x %d\n", path, options.width, options.height), 1;
  if (!has_panel(window, options, layout.panel)) return std::printf("%s: the panel is empty\n", path), 1;
  Stage stage(options.threads);
  const Picture picture = stage.show(options.state, shd_progress{}, nullptr);
  if (!picture.error.empty()) return std::printf("%s\n", picture.error.c_str()), 1;
  const std::vector<uint8_t> wanted = compose(picture, divider_column(options.state));
  if (options.magnify && !has_magnifier(window, wanted, options)) {
    return std::printf("%s: the magnifier shows other pixels\n", path), 1;
  }
  size_t compared = 0, different = 0, bright = 0;
  for (int y = 0; y < layout.viewport.height; ++y) {
    for (int x = 0; x < layout.viewport.width; ++x) {
      if (is_marked(options, x, y)) continue;
      const uint8_t* a = &window[4 * (size_t(y) * size_t(options.width) + size_t(x))];
      const uint8_t* b = &wanted[4 * (size_t(y) * options.state.width + size_t(x))];
      different += std::memcmp(a, b, 3) != 0;
      bright += b[1] > 90;
      ++compared;
    }
  }
  std::printf("%s: %zu of %zu pixels differ, hash %016llx\n", path, different, compared,
              static_cast<unsigned long long>(hash_of(wanted)));
  const bool is_picture = bright > compared / 50 && compared > 1000;
  if (!is_picture) std::printf("%s: the picture is empty\n", path);
  return different == 0 && is_picture ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return std::puts("usage: check_screen SCREENSHOT [options]"), 2;
  try {
    if (argc == 3 && std::strcmp(argv[2], "--error") == 0) return check_error(argv[1]);
    Options options;
    return read_options(argc - 1, argv + 1, options) ? compare(argv[1], options) : 2;
  } catch (const std::exception& error) {
    std::printf("%s: %s\n", argv[1], error.what());
    return 1;
  }
}
