// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iterator>

#include "command/failure.h"
#include "tool/samples.h"
#include "tool/show.h"

namespace {

/// A value of each sample of a picture, NaN where nothing is drawn.
struct Field {
  Options options;                         // options with the size of the supersampled picture
  std::vector<std::vector<float>> sample;  // [sample of a pixel][height][width]
  float low = HUGE_VALF, high = -HUGE_VALF;
};

using ReadValues = std::function<std::vector<float>(const shd_framebuffer*)>;

Field read_field(const Stage& stage, const Frame& frame, shd_aov_flags aovs, const ReadValues& read) {
  Field field;
  field.options = stage.options;
  field.options.width *= stage.options.supersampling;
  field.options.height *= stage.options.supersampling;
  field.options.supersampling = 1;
  const auto visit = [&](size_t, const shd_framebuffer* framebuffer) {
    const std::vector<uint32_t> draw = read_numbers(framebuffer, SHD_PLANE_DRAW);
    std::vector<float>& values = field.sample.emplace_back(read(framebuffer));
    for (size_t i = 0; i < values.size(); ++i) {
      if (draw[i] == kNothing) values[i] = NAN;
      if (!std::isfinite(values[i])) continue;
      field.low = std::min(field.low, values[i]);
      field.high = std::max(field.high, values[i]);
    }
  };
  visit_samples(stage.context, field.options, frame.camera.view, frame.draws, aovs | SHD_AOV_DRAW, visit);
  return field;
}

/// The mean over the samples of a pixel of their colours. Samples that show nothing have the background.
Picture color_field(const Stage& stage, const Field& field, const std::function<void(float, Rgb&)>& color_of) {
  Picture large = blank_picture(field.options.width, field.options.height, {});
  const float share = 1.0f / static_cast<float>(field.sample.size());
  for (const std::vector<float>& values : field.sample) {
    for (size_t i = 0; i < values.size(); ++i) {
      const std::array<float, 4>& background = stage.options.background;
      Rgb color = {background[0], background[1], background[2]};
      const bool is_drawn = !std::isnan(values[i]);
      if (is_drawn) color_of(values[i], color);
      for (size_t c = 0; c < 3; ++c) large.rgba[4 * i + c] += share * color[c];
      large.rgba[4 * i + 3] += share * (is_drawn ? 1.0f : background[3]);
    }
  }
  return reduce_picture(large, stage.options.supersampling);
}

/// Where a value lies between the lowest and the highest one.
float part_of(const Field& field, float value) {
  return field.high > field.low ? (value - field.low) / (field.high - field.low) : 0.0f;
}

/// The colours of mip levels; levels in between have colours in between (after Williams, "Pyramidal Parametrics", 1983,
/// whose pictures show levels as they are stored).
Rgb level_color(float level) {
  constexpr Rgb kLevels[] = {{0.05f, 0.1f, 0.8f},   {0.0f, 0.55f, 0.75f},  {0.05f, 0.6f, 0.08f}, {0.9f, 0.8f, 0.05f},
                             {0.95f, 0.35f, 0.02f}, {0.75f, 0.02f, 0.03f}, {0.6f, 0.03f, 0.5f},  {0.2f, 0.08f, 0.5f},
                             {0.35f, 0.35f, 0.35f}, {0.9f, 0.9f, 0.9f}};
  constexpr float kLast = std::size(kLevels) - 1;
  const float at = std::clamp(level, 0.0f, kLast);
  const auto low = static_cast<size_t>(std::min(at, kLast - 1.0f));
  Rgb color;
  for (size_t c = 0; c < 3; ++c) {
    color[c] = kLevels[low][c] + (at - static_cast<float>(low)) * (kLevels[low + 1][c] - kLevels[low][c]);
  }
  return color;
}

Picture color_levels(const Stage& stage, const Field& field) {
  if (field.low <= field.high) std::fprintf(stderr, "shd-render: levels %.4g to %.4g\n", field.low, field.high);
  return color_field(stage, field, [](float level, Rgb& color) { color = level_color(level); });
}

std::vector<float> to_floats(const std::vector<uint32_t>& numbers) {
  return {numbers.begin(), numbers.end()};
}

}  // namespace

Picture show_depth(const Stage& stage, const Frame& frame) {
  const float* const m = frame.camera.view.world_to_view;
  const Field field = read_field(stage, frame, SHD_AOV_POSITION, [m](const shd_framebuffer* framebuffer) {
    std::vector<float> x = read_floats(framebuffer, SHD_PLANE_PX);
    const std::vector<float> y = read_floats(framebuffer, SHD_PLANE_PY), z = read_floats(framebuffer, SHD_PLANE_PZ);
    for (size_t i = 0; i < x.size(); ++i) x[i] = -(m[2] * x[i] + m[6] * y[i] + m[10] * z[i] + m[14]);
    return x;
  });
  if (field.low <= field.high) std::fprintf(stderr, "shd-render: distances %.5g to %.5g\n", field.low, field.high);
  return color_field(stage, field, [&field](float distance, Rgb& color) {
    color.fill(std::pow(1.0f - 0.9f * part_of(field, distance), 2.2f));  // even steps on a display
  });
}

Picture show_position(const Stage& stage, const Frame& frame) {
  const Box box = box_of(stage.model);
  Picture out;
  for (int axis = 0; axis < 3; ++axis) {
    const auto plane = static_cast<shd_plane>(SHD_PLANE_PX + axis);
    const Field field = read_field(stage, frame, SHD_AOV_POSITION, [plane](const shd_framebuffer* framebuffer) {
      return read_floats(framebuffer, plane);
    });
    const auto low = static_cast<float>(box.low[axis]), size = static_cast<float>(box.high[axis] - box.low[axis]);
    const Picture one = color_field(stage, field, [&](float at, Rgb& color) {
      color.fill(size > 0.0f ? std::clamp((at - low) / size, 0.0f, 1.0f) : 0.5f);
    });
    if (axis == 0) out = one;
    for (size_t i = 0; i < one.rgba.size(); i += 4) out.rgba[i + axis] = one.rgba[i + axis];
  }
  return out;
}

Picture show_overdraw(const Stage& stage, const Frame& frame) {
  Frame all;
  all.camera = frame.camera;
  all.draws.draws = frame.draws.draws;
  for (shd_draw& draw : all.draws.draws) draw.compare = SHD_COMPARE_ALWAYS;  // hidden fragments count, too
  double sum = 0, drawn = 0;
  const Field field = read_field(stage, all, SHD_AOV_OVERDRAW, [&](const shd_framebuffer* framebuffer) {
    const std::vector<uint32_t> counts = read_numbers(framebuffer, SHD_PLANE_OVERDRAW);
    for (const uint32_t count : counts) sum += count, drawn += count > 0;
    return to_floats(counts);
  });
  const float most = std::max(field.high, 0.0f);
  std::fprintf(stderr, "shd-render: overdraw: up to %.0f fragments of a pixel, %.2f where something is drawn\n", most,
               drawn > 0 ? sum / drawn : 0.0);
  return color_field(stage, field, [most](float count, Rgb& color) {
    color = ramp_color(most > 1.0f ? (count - 1.0f) / (most - 1.0f) : 0.0f);
  });
}

Picture show_level(const Stage& stage, const Frame& frame) {
  return color_levels(stage, read_field(stage, frame, SHD_AOV_LEVEL, [](const shd_framebuffer* framebuffer) {
                        return read_floats(framebuffer, SHD_PLANE_LOD);
                      }));
}

Picture show_nearest_level(const Stage& stage, const Frame& frame) {
  return color_levels(stage, read_field(stage, frame, SHD_AOV_LEVEL, [](const shd_framebuffer* framebuffer) {
                        return to_floats(read_numbers(framebuffer, SHD_PLANE_LEVEL));
                      }));
}
