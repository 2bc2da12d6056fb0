// SPDX-License-Identifier: MIT
#include "texture/table/normal_moments.h"

#include <cmath>

#include "core/executor.h"
#include "image/format.h"
#include "texture/format/formats.h"

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

template <class In, class Out, class Mixed>
void convert_row(Rows row, uint32_t width) {
  for (uint32_t x = 0; x < width; ++x, row.normal += In::kSize, row.out += Out::kSize) {
    double n[4], moment[4] = {};
    In::load(row.normal, n);
    for (size_t c = 0; c < 3 && !In::kFloat; ++c) n[c] = 2 * n[c] / In::one(c) - 1;
    find_slopes(n, moment);
    Out::store(moment, row.out);
    Out::load(row.out, moment);  // square the rounded slopes, so that their rounding adds no variance
    moment[2] = moment[0] * moment[0];
    moment[3] = moment[1] * moment[1];
    Out::store(moment, row.out);
    if (!row.mixed) continue;
    const double product[4] = {moment[0] * moment[1]};
    Mixed::store(product, row.mixed);
    row.mixed += Mixed::kSize;
  }
}

template <class In, class Out, class Mixed>
void convert(const core::Context& context, const shd_image& normals, const shd_image& out, const shd_image* mixed) {
  core::parallel_for(context, out.height, [&](uint32_t y, uint32_t) {
    const Rows row = {static_cast<const uint8_t*>(normals.pixels) + y * normals.row_stride,
                      static_cast<uint8_t*>(out.pixels) + y * out.row_stride,
                      mixed ? static_cast<uint8_t*>(mixed->pixels) + y * mixed->row_stride : nullptr};
    convert_row<In, Out, Mixed>(row, out.width);
  });
}

}  // namespace

void write_moments(const core::Context& context, const shd_image& normals, const shd_image& out,
                   const shd_image* mixed) {
  const image::FormatInfo format = image::format_info(normals.format);
  const bool is_srgb = format.component == image::Component::kSrgb8;
  const image::Component component = is_srgb ? image::Component::kUnorm8 : format.component;
  const bool is_half = out.format == SHD_FORMAT_RGBA16F, mixed_is_half = mixed && mixed->format == SHD_FORMAT_R16F;
  visit_codec(component, format.channels, [&](auto codec) {
    using In = decltype(codec);
    if constexpr (In::kChannels >= 3) {
      const auto run = [&](auto out_codec) {
        using Out = decltype(out_codec);
        if (mixed_is_half) {
          convert<In, Out, Float16Codec<1>>(context, normals, out, mixed);
        } else {
          convert<In, Out, Float32Codec<1>>(context, normals, out, mixed);
        }
      };
      is_half ? run(Float16Codec<4>()) : run(Float32Codec<4>());
    }
  });
}

}  // namespace shd::texture
