// SPDX-License-Identifier: MIT
#include "environment/source.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/executor.h"
#include "data/trig.h"
#include "image/format.h"
#include "image/half.h"
#include "image/srgb.h"
#include "projection/projection.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "environment/source.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef SHD_ENVIRONMENT_SOURCE_CPP_
#define SHD_ENVIRONMENT_SOURCE_CPP_
namespace shd::environment {
namespace {

constexpr size_t kStrands = 16;  // partial sums of a row: element i is added to strand i % 16 on every target
constexpr int kSums = 3 * kHarmonics + 1;

/// Sums over one row: radiance times harmonics, and the solid angle.
struct RowSums {
  alignas(64) float strand[kSums][kStrands];
};

}  // namespace
}  // namespace shd::environment
#endif  // SHD_ENVIRONMENT_SOURCE_CPP_

HWY_BEFORE_NAMESPACE();
namespace shd::environment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Adds a row of a multiple of kStrands texels, whose columns are padded with 0.
void AddRow(size_t count, const float* const* direction, const float* solid_angle, const float* const* color,
            RowSums* sums) {
  const hn::CappedTag<float, kStrands> d;
  using V = hn::Vec<decltype(d)>;
  const V one = hn::Set(d, 1.0f), three = hn::Set(d, 3.0f);
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const size_t strand = i % kStrands;
    const V x = hn::Load(d, direction[0] + i), y = hn::Load(d, direction[1] + i), z = hn::Load(d, direction[2] + i);
    const V weight = hn::Load(d, solid_angle + i);
    const V basis[kHarmonics] = {one, x, y, z, x * y, y * z, x * z, three * z * z - one, x * x - y * y};
    for (int c = 0; c < 3; ++c) {
      const V light = weight * hn::Load(d, color[c] + i);
      for (int k = 0; k < kHarmonics; ++k) {
        float* sum = sums->strand[c * kHarmonics + k] + strand;
        hn::Store(hn::Load(d, sum) + light * basis[k], d, sum);
      }
    }
    float* sum = sums->strand[kSums - 1] + strand;
    hn::Store(hn::Load(d, sum) + weight, d, sum);
  }
}

}  // namespace shd::environment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::environment {
namespace {

HWY_EXPORT(AddRow);

size_t padded_width(uint32_t width) {
  return (size_t{width} + kStrands - 1) / kStrands * kStrands;
}

float decode(image::Component component, const uint8_t* channel) {
  uint16_t half;
  float value;
  switch (component) {
    case image::Component::kUnorm8: return static_cast<float>(*channel) / 255.0f;
    case image::Component::kSrgb8: return image::srgb8_to_linear(*channel);
    case image::Component::kUnorm16:
      std::memcpy(&half, channel, sizeof half);
      return static_cast<float>(half) / 65535.0f;
    case image::Component::kFloat16: std::memcpy(&half, channel, sizeof half); return image::half_to_float(half);
    default: std::memcpy(&value, channel, sizeof value); return value;
  }
}

/// The radiance of a channel, within 0..kMaxRadiance. NaN fails the first comparison.
float clean(float value, uint64_t* replaced) {
  if (value >= 0.0f && value <= kMaxRadiance) return value;
  ++*replaced;
  return value > kMaxRadiance ? kMaxRadiance : 0.0f;
}

/// Decodes row y to the texels of `out`.
uint64_t decode_row(const shd_image& image, uint32_t y, float* texel) {
  const image::FormatInfo format = image::format_info(image.format);
  const auto* pixel = static_cast<const uint8_t*>(image.pixels) + y * image.row_stride;
  uint64_t replaced = 0;
  for (uint32_t x = 0; x < image.width; ++x, pixel += format.pixel_size, texel += 4) {
    if (format.channels == 1) {
      texel[0] = texel[1] = texel[2] = clean(decode(format.component, pixel), &replaced);
      continue;
    }
    for (size_t c = 0; c < 3; ++c) {
      texel[c] =
          c < format.channels ? clean(decode(format.component, pixel + c * format.channel_size), &replaced) : 0.0f;
    }
  }
  return replaced;
}

/// Columns of one row for AddRow.
struct RowColors {
  core::Array<float> block;
  float* channel[3];

  RowColors(const core::Allocator& allocator, uint32_t width) : block(allocator, 3 * padded_width(width)) {
    block.fill_zero();
    for (size_t c = 0; c < 3; ++c) channel[c] = block.data() + c * padded_width(width);
  }
};

/// Decodes row y, marks the texels that show a direction, and integrates it.
uint64_t read_row(const core::SimdTarget& simd, const shd_image& image, uint32_t y, RowDirections* row,
                  const RowColors& colors, Source* out, double* sums) {
  float* texel = out->texels.data() + 4 * size_t{y} * out->width;
  const uint64_t replaced = decode_row(image, y, texel);
  find_directions(simd, *out, y, row);
  for (uint32_t x = 0; x < out->width; ++x, texel += 4) {
    texel[3] = row->solid_angle[x] > 0.0f ? 1.0f : 0.0f;
    for (int c = 0; c < 3; ++c) colors.channel[c][x] = texel[c];
  }
  RowSums strands = {};
  const float* const direction[3] = {row->x, row->y, row->z};
  SHD_DISPATCH(AddRow, simd)(padded_width(out->width), direction, row->solid_angle, colors.channel, &strands);
  for (int k = 0; k < kSums; ++k) {
    sums[k] = 0.0;
    for (const float strand : strands.strand[k]) sums[k] += static_cast<double>(strand);
  }
  return replaced;
}

}  // namespace

RowDirections::RowDirections(const core::Allocator& allocator, uint32_t width)
    : block(allocator, 4 * padded_width(width)) {
  block.fill_zero();
  const size_t padded = padded_width(width);
  x = block.data(), y = x + padded, z = y + padded, solid_angle = z + padded;
}

void find_directions(const core::SimdTarget& simd, const Source& source, uint32_t y, RowDirections* out) {
  constexpr size_t kPart = 256;
  const uint32_t faces = projection::face_count(source.projection), face_height = source.height / faces;
  const auto rows = static_cast<float>(face_height), columns = static_cast<float>(source.width);
  float u[kPart], v[kPart];
  uint32_t face[kPart];
  std::fill_n(v, kPart, (static_cast<float>(y % face_height) + 0.5f) / rows);
  std::fill_n(face, kPart, y / face_height);
  for (size_t x = 0; x < source.width; x += kPart) {
    const size_t count = std::min<size_t>(kPart, source.width - x);
    for (size_t i = 0; i < count; ++i) u[i] = (static_cast<float>(x + i) + 0.5f) / columns;
    projection::unproject(source.projection, simd, {count, u, v, face},
                          {{out->x + x, out->y + x, out->z + x}, out->solid_angle + x});
    for (size_t i = 0; i < count; ++i) out->solid_angle[x + i] /= rows * columns;
  }
}

void read_source(const core::Context& context, shd_projection projection, const shd_image& image, Source* out) {
  constexpr uint32_t kMaxTasks = 256;
  out->projection = projection;
  out->width = image.width, out->height = image.height;
  out->texels = core::Array<float>(context.allocator, 4 * size_t{image.width} * image.height);
  core::Array<double> sums(context.allocator, size_t{image.height} * kSums);
  core::Array<uint64_t> replaced(context.allocator, image.height);
  const uint32_t tasks = std::min(image.height, kMaxTasks);
  core::parallel_for(context, tasks, [&](uint32_t task, uint32_t) {
    RowDirections row(context.allocator, out->width);
    const RowColors colors(context.allocator, out->width);
    const auto end = static_cast<uint32_t>(uint64_t{image.height} * (task + 1) / tasks);
    for (auto y = static_cast<uint32_t>(uint64_t{image.height} * task / tasks); y < end; ++y) {
      replaced[y] = read_row(context.simd, image, y, &row, colors, out, &sums[size_t{y} * kSums]);
    }
  });
  double total[kSums] = {};
  out->replaced = 0;
  for (uint32_t y = 0; y < image.height; ++y) {
    for (int k = 0; k < kSums; ++k) total[k] += sums[size_t{y} * kSums + k];
    out->replaced += replaced[y];
  }
  out->scale = 4.0 * data::kPi / total[kSums - 1];
  for (int k = 0; k < kSums - 1; ++k) out->moments[k / kHarmonics][k % kHarmonics] = total[k] * out->scale;
}

}  // namespace shd::environment
#endif  // HWY_ONCE
