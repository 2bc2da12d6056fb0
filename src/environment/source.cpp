// SPDX-License-Identifier: MIT
#include "environment/source.h"

#include <algorithm>
#include <cmath>

#include "core/executor.h"
#include "core/status.h"
#include "data/trig.h"
#include "image/pixels.h"
#include "projection/projection.h"
#include "texture/lookup/sample.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "environment/source.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "environment/harmonics-inl.h"

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
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const size_t strand = i % kStrands;
    const V weight = hn::Load(d, solid_angle + i);
    const auto n = simd::HWY_NAMESPACE::Load3(d, direction[0], direction[1], direction[2], i);
    HarmonicBasis<V> basis(d, n);
    basis.value[7] = (hn::Set(d, 3.0f) * n.z) * n.z - hn::Set(d, 1.0f);  // rounded in the order of the stored sums
    for (int c = 0; c < 3; ++c) {
      const V light = weight * hn::Load(d, color[c] + i);
      for (int k = 0; k < kHarmonics; ++k) {
        float* sum = sums->strand[c * kHarmonics + k] + strand;
        hn::Store(hn::Load(d, sum) + light * basis.value[k], d, sum);
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

size_t padded_width(size_t width) {
  return (width + kStrands - 1) / kStrands * kStrands;
}

/// The radiance of a channel, within 0..kMaxRadiance. NaN fails the first comparison.
float clean(float value, uint64_t* replaced) {
  if (value >= 0.0f && value <= kMaxRadiance) return value;
  ++*replaced;
  return value > kMaxRadiance ? kMaxRadiance : 0.0f;
}

/// Decodes row y of the image.
uint64_t decode_row(const shd_image& image, uint32_t y, float* texel) {
  const image::FormatInfo format = image::format_info(image.format);
  const auto* pixels = static_cast<const uint8_t*>(image.pixels) + y * image.row_stride;
  image::decode_pixels(image.format, pixels, static_cast<ptrdiff_t>(format.pixel_size), image.width, texel);
  uint64_t replaced = 0;
  for (uint32_t x = 0; x < image.width; ++x, texel += 4) {
    for (size_t c = 0; c < std::min<size_t>(format.channels, 3); ++c) texel[c] = clean(texel[c], &replaced);
    if (format.channels == 1) texel[1] = texel[2] = texel[0];
    texel[3] = 1.0f;
  }
  return replaced;
}

/// Parts of texels along one axis.
uint32_t parts_of(double wanted, uint32_t size) {
  return static_cast<uint32_t>(std::max(1.0, std::ceil(wanted / size)));
}

/// Size of an image whose texels are no larger than those of an octahedral map of `cells` rows.
struct ImageSize {
  double columns, rows;
};
ImageSize size_like(shd_projection projection, double cells) {
  switch (projection) {
    case SHD_PROJECTION_LAT_LONG: return {1.4 * cells, 0.7 * cells};
    case SHD_PROJECTION_ANGULAR: return {1.4 * cells, 1.4 * cells};
    case SHD_PROJECTION_CUBE: return {0.5 * cells, 0.5 * cells};
    case SHD_PROJECTION_MIRROR_BALL:
    case SHD_PROJECTION_OCTAHEDRAL: return {cells, cells};
    case SHD_PROJECTION_NONE:
    case SHD_PROJECTION_MAX_ENUM: break;
  }
  SHD_UNREACHABLE();
}

/// Divides texels that are larger than cells.
void divide(Source* source) {
  const ImageSize size = size_like(source->image.projection, cell_size(*source));
  source->across = parts_of(size.columns, source->image.width);
  source->down = parts_of(size.rows, source->image.height);
}

/// MIRROR_BALL and ANGULAR: sets the texels with their centres outside the disc, if a part of them lies inside.
void continue_disc(const core::Context& context, Source* source) {
  const uint32_t size = source->image.width;
  texture::Texture texture;
  texture::borrow(context, source->image, &texture);
  const texture::Sampler sampler = texture::sampler_of(SHD_FILTER_BILINEAR);
  core::Array<float> columns(context.allocator, size_t{7} * size);
  core::Array<uint32_t> outside(context.allocator, size);
  float* column[7];
  for (size_t c = 0; c < 7; ++c) column[c] = columns.data() + c * size;
  float *const *const n = column, *const *const value = column + 3, *const solid_angle = column[6];
  for (uint32_t y = 0; y < size; ++y) {
    const projection::PointDirections out = {{n[0], n[1], n[2]}, solid_angle};
    projection::find_texels(source->image.projection, context.simd, {size, size, 0, y}, out);
    const double q = (2.0 * y + 1.0) / size - 1.0;
    size_t count = 0;
    for (uint32_t x = 0; x < size; ++x) {
      const double p = (2.0 * x + 1.0) / size - 1.0;
      if (p * p + q * q <= 1.0 || !(solid_angle[x] > 0.0f)) continue;
      for (int c = 0; c < 3; ++c) n[c][count] = n[c][x];
      outside[count++] = x;
    }
    texture::Lookups in = {};
    in.count = count, in.u = n[0], in.v = n[1], in.w = n[2];
    texture::sample(texture, sampler, context.simd, in, {{value[0], value[1], value[2], nullptr}, {}, {}});
    for (size_t i = 0; i < count; ++i) {
      float* texel = source->image.texels.data() + 4 * (size_t{y} * size + outside[i]);
      for (int c = 0; c < 3; ++c) texel[c] = value[c][i];
    }
  }
}

/// Columns of one row for AddRow.
struct RowColors {
  core::Array<float> block;
  float* channel[3];

  RowColors(const core::Allocator& allocator, size_t width) : block(allocator, 3 * padded_width(width)) {
    block.fill_zero();
    for (size_t c = 0; c < 3; ++c) channel[c] = block.data() + c * padded_width(width);
  }
};

/// Integrates row y of the image.
void integrate_row(const core::SimdTarget& simd, const Source& source, uint32_t y, RowDirections* row,
                   const RowColors& colors, double* sums) {
  const float* texel = source.row(y);
  for (size_t x = 0; x < row->width; texel += 4) {
    for (uint32_t part = 0; part < source.across; ++part, ++x) {
      for (int c = 0; c < 3; ++c) colors.channel[c][x] = texel[c];
    }
  }
  std::fill_n(sums, kSums, 0.0);
  for (uint32_t part = 0; part < source.down; ++part) {
    find_directions(simd, source, y * source.down + part, row);
    RowSums strands = {};
    const float* const direction[3] = {row->x, row->y, row->z};
    SHD_DISPATCH(AddRow, simd)(padded_width(row->width), direction, row->solid_angle, colors.channel, &strands);
    for (int k = 0; k < kSums; ++k) {
      for (const float strand : strands.strand[k]) sums[k] += static_cast<double>(strand);
    }
  }
}

/// Calls body(row, sums of the row) for all rows, by tasks with their own scratch memory.
void integrate(const core::Context& context, Source* out) {
  constexpr uint32_t kMaxTasks = 256;
  const uint32_t rows = out->image.height * out->faces(), tasks = std::min(rows, kMaxTasks);
  core::Array<double> sums(context.allocator, size_t{rows} * kSums);
  core::parallel_for(context, tasks, [&](uint32_t task, uint32_t) {
    RowDirections row(context.allocator, *out);
    const RowColors colors(context.allocator, row.width);
    const auto end = static_cast<uint32_t>(uint64_t{rows} * (task + 1) / tasks);
    for (auto y = static_cast<uint32_t>(uint64_t{rows} * task / tasks); y < end; ++y) {
      integrate_row(context.simd, *out, y, &row, colors, &sums[size_t{y} * kSums]);
    }
  });
  double total[kSums] = {};
  for (size_t i = 0; i < sums.size(); ++i) total[i % kSums] += sums[i];
  out->scale = 4.0 * data::kPi / total[kSums - 1];
  for (int k = 0; k < kSums - 1; ++k) out->moments[k / kHarmonics][k % kHarmonics] = total[k] * out->scale;
}

}  // namespace

uint32_t Source::faces() const {
  return projection::face_count(image.projection);
}

uint32_t cell_size(const Source& source) {
  constexpr uint32_t kLeast = 64, kMost = 512;
  uint32_t size = kLeast;
  while (size < kMost && 2 * uint64_t{size} * size < source.texels()) size *= 2;
  return size;
}

RowDirections::RowDirections(const core::Allocator& allocator, const Source& source)
    : width(size_t{source.image.width} * source.across), block(allocator, 4 * padded_width(width)) {
  block.fill_zero();
  const size_t padded = padded_width(width);
  x = block.data(), y = x + padded, z = y + padded, solid_angle = z + padded;
}

void find_directions(const core::SimdTarget& simd, const Source& source, uint32_t y, RowDirections* out) {
  const uint32_t height = source.image.height * source.down;
  projection::find_texels(source.image.projection, simd,
                          {static_cast<uint32_t>(out->width), height, y / height, y % height},
                          {{out->x, out->y, out->z}, out->solid_angle});
}

void read_source(const core::Context& context, shd_projection projection, const shd_image& image, Source* out) {
  out->image.projection = projection;
  out->image.width = image.width, out->image.height = image.height / projection::face_count(projection);
  texture::allocate(context.allocator, &out->image);
  divide(out);
  core::Array<uint64_t> replaced(context.allocator, image.height);
  constexpr uint32_t kRowsPerTask = 16;
  core::parallel_for(context, (image.height + kRowsPerTask - 1) / kRowsPerTask, [&](uint32_t task, uint32_t) {
    const uint32_t first = task * kRowsPerTask;
    for (uint32_t y = first; y < std::min(image.height, first + kRowsPerTask); ++y) {
      replaced[y] = decode_row(image, y, out->image.texels.data() + 4 * size_t{y} * image.width);
    }
  });
  out->replaced = 0;
  for (uint32_t y = 0; y < image.height; ++y) out->replaced += replaced[y];
  if (projection::is_disc(projection)) continue_disc(context, out);
  integrate(context, out);
}

}  // namespace shd::environment
#endif  // HWY_ONCE
