// SPDX-License-Identifier: MIT
// Conversion between projections: a texel of the target is the average of bilinear lookups of the source over its solid
// angle, by the midpoint rule.
#include "texture/convert/convert.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/executor.h"
#include "core/status.h"
#include "data/trig.h"
#include "image/pixels.h"
#include "projection/projection.h"
#include "texture/convert/floats.h"
#include "texture/format/texel_codec.h"
#include "texture/lookup/sample.h"
#include "texture/store/rows.h"
#include "texture/store/storage.h"

namespace shd::texture {
namespace {

constexpr size_t kPart = 256;  // samples in a batch

uint8_t* pixel_of(const DirectionFaces& faces, uint32_t face, uint32_t x, uint32_t y) {
  const FacePixels& pixels = faces.face[face];
  const size_t size = image::format_info(faces.format).pixel_size;
  const uint32_t column = pixels.turned ? faces.width - 1 - x : x, row = pixels.turned ? faces.height - 1 - y : y;
  return pixels.first + row * pixels.row_stride + column * size;
}

/// Texels of the source as floats.
DirectionFloats decode(const core::Context& context, const DirectionFaces& from) {
  DirectionFloats decoded = {from.projection, from.width, from.height, {}};
  allocate(context.allocator, &decoded);
  const auto size = static_cast<ptrdiff_t>(image::format_info(from.format).pixel_size);
  for_rows(context, {0, projection::face_count(from.projection) * from.height}, [&](uint32_t row, uint32_t) {
    const uint32_t face = row / from.height;
    image::decode_pixels(from.format, pixel_of(from, face, 0, row % from.height), from.face[face].turned ? -size : size,
                         from.width, decoded.texels.data() + size_t{row} * from.width * 4);
  });
  return decoded;
}

void encode(const DirectionFaces& to, uint32_t face, uint32_t x, uint32_t y, const double* value) {
  const image::FormatInfo format = image::format_info(to.format);
  const TexelCodec& codec = codec_of(format.component, format.channels);
  double stored[4];
  for (size_t c = 0; c < codec.channels; ++c) stored[c] = codec.clamp(c, value[c] * codec.one[c]);
  codec.store(stored, 1, pixel_of(to, face, x, y));
}

/// Faces of the same size: a change of layout or format.
void copy_texels(const core::Context& context, const DirectionFaces& from, const DirectionFaces& to) {
  const uint32_t faces = projection::face_count(from.projection);
  const DirectionFloats decoded = decode(context, from);
  for_rows(context, {0, faces * to.height}, [&](uint32_t row, uint32_t) {
    const float* texel = decoded.texels.data() + size_t{row} * to.width * 4;
    for (uint32_t x = 0; x < to.width; ++x, texel += 4) {
      double value[4];
      for (size_t c = 0; c < 4; ++c) value[c] = static_cast<double>(texel[c]);
      encode(to, row / to.height, x, row % to.height, value);
    }
  });
}

/// Product of the lengths of the sides of a texel [rad^2]: the largest one, without the rim of MIRROR_BALL.
double texel_size(const DirectionFaces& image) {
  const double square = static_cast<double>(image.width) * image.height;
  switch (image.projection) {
    case SHD_PROJECTION_LAT_LONG: return 2.0 * data::kPi * data::kPi / square;
    case SHD_PROJECTION_MIRROR_BALL: return 16.0 / square;
    case SHD_PROJECTION_ANGULAR: return 4.0 * data::kPi * data::kPi / square;
    case SHD_PROJECTION_CUBE: return 4.0 / square;
    case SHD_PROJECTION_OCTAHEDRAL: return 24.0 / square;
    case SHD_PROJECTION_NONE:
    case SHD_PROJECTION_MAX_ENUM: break;
  }
  SHD_UNREACHABLE();
}

/// Angle between texels of the source, so that at most about 64 samples are taken for each texel of the target and 16
/// for each of the source. It is below the angle in images whose texels are squares on the equator.
double least_angle(const DirectionFaces& from, const DirectionFaces& to) {
  const double ratio = static_cast<double>(from.width) * from.height /
                       (static_cast<double>(to.width) * to.height * projection::face_count(to.projection));
  return 2.0 * std::sqrt(texel_size(to) / (64.0 + 16.0 * ratio));
}

/// cos(pi t) for t in 0..1.
double cosine_pi(double t) {
  return t > 0.5 ? -data::cos(data::kPi * (1.0 - t)) : data::cos(data::kPi * t);
}

/// Sets texel (x, y) of a smaller image of latitude and longitude to the mean of the texels that it covers.
void average(const DirectionFloats& from, uint32_t x, uint32_t y, const DirectionFloats& to, float* texel) {
  const double left = static_cast<double>(x) * from.width / to.width, right = (x + 1.0) * from.width / to.width;
  const double top = static_cast<double>(y) * from.height / to.height, bottom = (y + 1.0) * from.height / to.height;
  double sum[4] = {}, total = 0.0;
  for (auto j = static_cast<uint32_t>(top); j < from.height && j < bottom; ++j) {
    const double row = cosine_pi(std::max(top, static_cast<double>(j)) / from.height) -
                       cosine_pi(std::min(bottom, j + 1.0) / from.height);
    for (auto i = static_cast<uint32_t>(left); i < from.width && i < right; ++i) {
      const double weight = row * (std::min(right, i + 1.0) - std::max(left, static_cast<double>(i)));
      if (!(weight > 0.0)) continue;
      const float* const part = from.texels.data() + 4 * (size_t{j} * from.width + i);
      for (size_t c = 0; c < 4; ++c) sum[c] += weight * static_cast<double>(part[c]);
      total += weight;
    }
  }
  for (size_t c = 0; c < 4; ++c) texel[c] = static_cast<float>(sum[c] / total);
}

/// Makes the texels of an image of latitude and longitude no narrower than `angle` on the equator, and no lower.
void widen_texels(const core::Context& context, double angle, DirectionFloats* image) {
  const auto most = [&](double circle, uint32_t size) {
    return static_cast<uint32_t>(std::clamp(std::floor(circle / angle), 1.0, static_cast<double>(size)));
  };
  DirectionFloats wide = {image->projection, most(2.0 * data::kPi, image->width), most(data::kPi, image->height), {}};
  if (wide.width == image->width && wide.height == image->height) return;
  allocate(context.allocator, &wide);
  for_rows(context, {0, wide.height}, [&](uint32_t y, uint32_t) {
    float* texel = wide.texels.data() + 4 * size_t{y} * wide.width;
    for (uint32_t x = 0; x < wide.width; ++x, texel += 4) average(*image, x, y, wide, texel);
  });
  *image = std::move(wide);
}

/// Angle between neighbouring texels, at the narrowest ones; on the equator of LAT_LONG [rad].
double texel_angle(const Texture& source) {
  switch (source.projection) {
    case SHD_PROJECTION_LAT_LONG: return std::min(data::kPi / source.height, 2.0 * data::kPi / source.width);
    case SHD_PROJECTION_ANGULAR: return 3.0 / source.width;
    case SHD_PROJECTION_CUBE: return 1.0 / source.width;
    case SHD_PROJECTION_MIRROR_BALL:
    case SHD_PROJECTION_OCTAHEDRAL: return 2.0 / source.width;
    case SHD_PROJECTION_NONE:
    case SHD_PROJECTION_MAX_ENUM: break;
  }
  SHD_UNREACHABLE();
}

/// The samples of one batch.
struct Samples {
  size_t count = 0;
  float u[kPart], v[kPart];
  bool inside[kPart];  // in the disc of the target, if it has one
  uint32_t face[kPart];
  float direction[3][kPart], density[kPart];
  float value[4][kPart];
};

/// Weighted sums of a texel: of the samples inside the disc, and of all.
struct Sums {
  double value[2][4] = {}, weight[2] = {};

  void add(const Samples& samples, size_t i) {
    const auto weight_of_all = static_cast<double>(samples.density[i]);
    for (int k = samples.inside[i] ? 0 : 1; k < 2; ++k) {
      for (size_t c = 0; c < 4; ++c) value[k][c] += weight_of_all * static_cast<double>(samples.value[c][i]);
      weight[k] += weight_of_all;
    }
  }
};

/// Number of samples along the sides of a texel.
struct SampleCounts {
  uint32_t across, down;
};

struct Conversion {
  const core::Context& context;
  const Texture& source;
  const Sampler& sampler;
  const DirectionFaces& to;
  bool disc;

  void find_directions(Samples* s) const {
    projection::unproject(to.projection, context.simd, {s->count, s->u, s->v, s->face},
                          {{s->direction[0], s->direction[1], s->direction[2]}, s->density});
  }

  SampleCounts samples_in(uint32_t x, uint32_t y) const {
    auto extent = projection::texel_extent(to.projection, to.width, to.height, x, y);
    // Rows at the poles have as many columns as the equator.
    const bool both = to.projection == SHD_PROJECTION_LAT_LONG && source.projection == SHD_PROJECTION_LAT_LONG;
    if (both) extent.along_u = 2.0 * data::kPi / to.width;
    const double per_angle = 2.0 / texel_angle(source), most = 16.0 * std::max(source.width, source.height);
    const auto count = [&](double along) {
      return static_cast<uint32_t>(std::clamp(std::ceil(along * per_angle), 2.0, most));
    };
    return {count(extent.along_u), count(extent.along_v)};
  }

  /// Places a sample. Beyond the rim it is where the image continues: at 2 - r on the opposite side.
  void place(double u, double v, uint32_t face, Samples* s) const {
    const size_t i = s->count++;
    const double p = 2.0 * u - 1.0, q = 2.0 * v - 1.0, squared = p * p + q * q;
    s->inside[i] = !disc || squared <= 1.0;
    if (!s->inside[i]) {
      const double r = std::sqrt(squared), scale = (r - 2.0) / r;
      u = 0.5 + 0.5 * p * scale, v = 0.5 + 0.5 * q * scale;
    }
    s->u[i] = static_cast<float>(u), s->v[i] = static_cast<float>(v);
    s->face[i] = face;
  }

  void look_up(Samples* s) const {
    find_directions(s);
    Lookups lookups = {};
    lookups.count = s->count;
    lookups.u = s->direction[0], lookups.v = s->direction[1], lookups.w = s->direction[2];
    Texels texels = {};
    for (size_t c = 0; c < 4; ++c) texels.channel[c] = s->value[c];
    sample(source, sampler, context.simd, lookups, texels);
  }

  void convert_texel(uint32_t face, uint32_t x, uint32_t y, Samples* s) const {
    Sums sums;
    const SampleCounts counts = samples_in(x, y);
    const auto total = uint64_t{counts.across} * counts.down;
    for (uint64_t first = 0; first < total; first += kPart) {
      s->count = 0;
      for (uint64_t i = first; i < total && i < first + kPart; ++i) {
        place((x + (static_cast<double>(i % counts.across) + 0.5) / counts.across) / to.width,
              (y + (static_cast<double>(i / counts.across) + 0.5) / counts.down) / to.height, face, s);
      }
      look_up(s);
      for (size_t i = 0; i < s->count; ++i) sums.add(*s, i);
    }
    const int part = sums.weight[0] > 0.0 ? 0 : 1;
    double value[4];
    for (size_t c = 0; c < 4; ++c) value[c] = sums.value[part][c] / sums.weight[part];
    encode(to, face, x, y, value);
  }

  void convert_row(uint32_t face, uint32_t y) const {
    Samples s;
    for (uint32_t x = 0; x < to.width; ++x) convert_texel(face, x, y, &s);
  }
};

}  // namespace

void convert(const core::Context& context, const DirectionFaces& from, const DirectionFaces& to) {
  if (from.projection == to.projection && from.width == to.width && from.height == to.height) {
    return copy_texels(context, from, to);
  }
  DirectionFloats decoded = decode(context, from);
  if (from.projection == SHD_PROJECTION_LAT_LONG) widen_texels(context, least_angle(from, to), &decoded);
  Texture source;
  borrow(context, decoded, &source);
  const Sampler sampler = sampler_of(SHD_FILTER_BILINEAR);
  const Conversion conversion = {context, source, sampler, to, projection::is_disc(to.projection)};
  for_rows(context, {0, projection::face_count(to.projection) * to.height},
           [&](uint32_t row, uint32_t) { conversion.convert_row(row / to.height, row % to.height); });
}

}  // namespace shd::texture
