// SPDX-License-Identifier: MIT
#include "texture/table/height_normals.h"

#include <cmath>
#include <cstdint>

#include "core/allocator.h"
#include "core/executor.h"
#include "image/format.h"
#include "texture/format/texel_codec.h"
#include "texture/table/mip_normal.h"
#include "texture/table/mip_weights.h"

namespace shd::texture {
namespace {

/// The heights of an image, also beyond its edges.
class Heights {
 public:
  Heights(const shd_image& image, const shd_normals_desc& desc)
      : image_(image), desc_(desc), codec_(codec_of_numbers(image.format)) {}

  /// Decodes row y of image rows to [width + 2] heights: those from -1 to width.
  void read_row(int64_t y, double* out) const {
    const int64_t width = image_.width, from = wrapped(desc_.wrap_v, y, image_.height);
    if (from < 0) {
      for (int64_t x = 0; x < width + 2; ++x) out[x] = 0.0;
      return;
    }
    const uint8_t* row = static_cast<const uint8_t*>(image_.pixels) + static_cast<size_t>(from) * image_.row_stride;
    double* to = out + 1;
    for_runs(codec_, row, image_.width, [&](const double* numbers, size_t run) {
      for (size_t i = 0; i < run; ++i) {
        const double height = numbers[i * codec_.channels] / codec_.one[0];
        *to++ = std::isfinite(height) ? height : 0.0;
      }
    });
    const int64_t left = wrapped(desc_.wrap_u, -1, width), right = wrapped(desc_.wrap_u, width, width);
    out[0] = left < 0 ? 0.0 : out[1 + left];
    out[width + 1] = right < 0 ? 0.0 : out[1 + right];
  }

 private:
  const shd_image& image_;
  const shd_normals_desc& desc_;
  const TexelCodec& codec_;
};

/// A slope along x; `row[1][x]` is the texel, `row[0]` and `row[2]` are the rows above and below.
double slope_across(shd_height_slope slope, const double* const row[3], int64_t x) {
  if (slope == SHD_HEIGHT_SLOPE_FORWARD) return row[1][x + 1] - row[1][x];
  const double central = 0.5 * (row[1][x + 1] - row[1][x - 1]);
  if (slope == SHD_HEIGHT_SLOPE_CENTRAL) return central;
  const double above = 0.5 * (row[0][x + 1] - row[0][x - 1]), below = 0.5 * (row[2][x + 1] - row[2][x - 1]);
  return 0.5 * central + 0.25 * (above + below);
}

/// A slope along y, as slope_across().
double slope_down(shd_height_slope slope, const double* const row[3], int64_t x) {
  if (slope == SHD_HEIGHT_SLOPE_FORWARD) return row[2][x] - row[1][x];
  const double central = 0.5 * (row[2][x] - row[0][x]);
  if (slope == SHD_HEIGHT_SLOPE_CENTRAL) return central;
  const double left = 0.5 * (row[2][x - 1] - row[0][x - 1]), right = 0.5 * (row[2][x + 1] - row[0][x + 1]);
  return 0.5 * central + 0.25 * (left + right);
}

void write_row(const TexelCodec& codec, const shd_normals_desc& desc, const double* const row[3], uint32_t width,
               uint8_t* out) {
  const double scale = static_cast<double>(desc.scale);
  for (uint32_t x = 0; x < width; ++x, out += codec.size) {
    const double across = scale * slope_across(desc.slope, row, x), down = scale * slope_down(desc.slope, row, x);
    const double largest = std::fmax(1.0, std::fmax(std::fabs(across), std::fabs(down)));  // keeps squares in range
    double n[4] = {0.0 - across / largest, down / largest, 1.0 / largest, 0.0};
    encode_normal(codec, n);
    if (codec.channels == 4) n[3] = codec.one[3];  // the length of a unit vector
    codec.store(n, 1, out);
  }
}

}  // namespace

void write_normals(const core::Context& context, const shd_image& heights, const shd_normals_desc& desc,
                   const shd_image& out) {
  const Heights source(heights, desc);
  const TexelCodec& codec = codec_of_numbers(out.format);
  const size_t length = size_t{out.width} + 2;
  const size_t workers = context.executor.worker_count ? context.executor.worker_count : 1;
  core::Array<double> rows(context.allocator, core::checked_mul(3 * length, workers));
  core::parallel_for(context, out.height, [&](uint32_t y, uint32_t worker) {
    const double* row[3];
    for (size_t i = 0; i < 3; ++i) {
      double* const heights_of_row = rows.data() + (3 * worker + i) * length;
      source.read_row(int64_t{y} + static_cast<int64_t>(i) - 1, heights_of_row);
      row[i] = heights_of_row + 1;
    }
    write_row(codec, desc, row, out.width, static_cast<uint8_t*>(out.pixels) + y * out.row_stride);
  });
}

}  // namespace shd::texture
