// SPDX-License-Identifier: MIT
#include "texture/store/normal_moments.h"

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

template <class In, class Out>
void convert_row(const uint8_t* normal, uint8_t* out, uint32_t width) {
  for (uint32_t x = 0; x < width; ++x, normal += In::kSize, out += Out::kSize) {
    double n[4], moment[4] = {};
    In::load(normal, n);
    for (size_t c = 0; c < 3 && !In::kFloat; ++c) n[c] = 2 * n[c] / In::one(c) - 1;
    find_slopes(n, moment);
    Out::store(moment, out);
    Out::load(out, moment);  // square the rounded slopes, so that their rounding adds no variance
    moment[2] = moment[0] * moment[0];
    moment[3] = moment[1] * moment[1];
    Out::store(moment, out);
  }
}

template <class In, class Out>
void convert(const core::Context& context, const shd_image& normals, const shd_image& out) {
  core::parallel_for(context, out.height, [&](uint32_t y, uint32_t) {
    convert_row<In, Out>(static_cast<const uint8_t*>(normals.pixels) + y * normals.row_stride,
                         static_cast<uint8_t*>(out.pixels) + y * out.row_stride, out.width);
  });
}

}  // namespace

void write_moments(const core::Context& context, const shd_image& normals, const shd_image& out) {
  const image::FormatInfo format = image::format_info(normals.format);
  const bool is_srgb = format.component == image::Component::kSrgb8;
  const image::Component component = is_srgb ? image::Component::kUnorm8 : format.component;
  visit_codec(component, format.channels, [&](auto codec) {
    using In = decltype(codec);
    if constexpr (In::kChannels >= 3) {
      if (out.format == SHD_FORMAT_RGBA16F) {
        convert<In, Float16Codec<4>>(context, normals, out);
      } else {
        convert<In, Float32Codec<4>>(context, normals, out);
      }
    }
  });
}

}  // namespace shd::texture
