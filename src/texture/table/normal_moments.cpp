// SPDX-License-Identifier: MIT
#include "texture/table/normal_moments.h"

#include <cmath>

#include "core/executor.h"
#include "image/format.h"
#include "texture/format/texel_codec.h"

namespace shd::texture {
namespace {

/// Computes the slopes bx, by of a normal of any length. They are 0 if the length is 0, infinite or NaN.
void find_slopes(const double* n, double* slope) {
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  slope[0] = slope[1] = 0.0;
  if (!(length > 0.0) || std::isinf(length)) return;
  const double z = n[2] > kMinNormalZ * length ? n[2] : kMinNormalZ * length;
  slope[0] = n[0] / z;
  slope[1] = n[1] / z;
}

/// Rows of the three images; `mixed` may be null.
struct Rows {
  const uint8_t* normal;
  uint8_t *out, *mixed;
};

/// Codecs of the three images; `mixed` may be null.
struct Codecs {
  const TexelCodec *normal, *out, *mixed;
};

void convert_row(const Codecs& codec, Rows row, uint32_t width) {
  for (uint32_t x = 0; x < width; ++x, row.normal += codec.normal->size, row.out += codec.out->size) {
    double n[4], moment[4] = {};
    codec.normal->load(row.normal, 1, n);
    for (size_t c = 0; c < 3 && !codec.normal->is_float; ++c) n[c] = 2 * n[c] / codec.normal->one[c] - 1;
    find_slopes(n, moment);
    codec.out->store(moment, 1, row.out);
    codec.out->load(row.out, 1, moment);  // square the rounded slopes, so that their rounding adds no variance
    moment[2] = moment[0] * moment[0];
    moment[3] = moment[1] * moment[1];
    codec.out->store(moment, 1, row.out);
    if (!row.mixed) continue;
    const double product = moment[0] * moment[1];
    codec.mixed->store(&product, 1, row.mixed);
    row.mixed += codec.mixed->size;
  }
}

}  // namespace

void write_moments(const core::Context& context, const shd_image& normals, const shd_image& out,
                   const shd_image* mixed) {
  const Codecs codecs = {&codec_of_numbers(normals.format), &codec_of_numbers(out.format),
                         mixed ? &codec_of_numbers(mixed->format) : nullptr};
  core::parallel_for(context, out.height, [&](uint32_t y, uint32_t) {
    const Rows row = {static_cast<const uint8_t*>(normals.pixels) + y * normals.row_stride,
                      static_cast<uint8_t*>(out.pixels) + y * out.row_stride,
                      mixed ? static_cast<uint8_t*>(mixed->pixels) + y * mixed->row_stride : nullptr};
    convert_row(codecs, row, out.width);
  });
}

}  // namespace shd::texture
