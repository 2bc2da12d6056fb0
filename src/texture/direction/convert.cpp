// SPDX-License-Identifier: MIT
// Conversion between projections: a texel of the target is the average of bilinear lookups of the source over its solid
// angle, by the midpoint rule.
#include "texture/direction/convert.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/executor.h"
#include "data/trig.h"
#include "projection/projection.h"
#include "texture/format/formats.h"
#include "texture/sample.h"
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

/// Texels of the source as RGBA floats, [face][height][width][4].
core::Array<float> decode(const core::Context& context, const DirectionFaces& from, uint32_t faces) {
  const size_t texels = size_t{from.width} * from.height;
  core::Array<float> decoded(context.allocator, core::checked_mul(texels * faces, 4));
  const image::FormatInfo format = image::format_info(from.format);
  for_rows(context, {0, faces * from.height}, [&](uint32_t row, uint32_t) {
    float* to = decoded.data() + size_t{row} * from.width * 4;
    visit_codec(format.component, format.channels, [&](auto codec) {
      using Codec = decltype(codec);
      for (uint32_t x = 0; x < from.width; ++x, to += 4) {
        double value[Codec::kChannels];
        Codec::load(pixel_of(from, row / from.height, x, row % from.height), value);
        to[0] = to[1] = to[2] = 0.0f, to[3] = 1.0f;
        for (size_t c = 0; c < Codec::kChannels; ++c) to[c] = static_cast<float>(value[c] / Codec::one(c));
      }
    });
  });
  return decoded;
}

void encode(const DirectionFaces& to, uint32_t face, uint32_t x, uint32_t y, const double* value) {
  const image::FormatInfo format = image::format_info(to.format);
  visit_codec(format.component, format.channels, [&](auto codec) {
    using Codec = decltype(codec);
    double stored[Codec::kChannels];
    for (size_t c = 0; c < Codec::kChannels; ++c) stored[c] = clamp_stored<Codec>(c, value[c] * Codec::one(c));
    Codec::store(stored, pixel_of(to, face, x, y));
  });
}

/// Faces of the same size: a change of layout or format.
void copy_texels(const core::Context& context, const DirectionFaces& from, const DirectionFaces& to) {
  const uint32_t faces = projection::face_count(from.projection);
  const core::Array<float> decoded = decode(context, from, faces);
  for_rows(context, {0, faces * to.height}, [&](uint32_t row, uint32_t) {
    const float* texel = decoded.data() + size_t{row} * to.width * 4;
    for (uint32_t x = 0; x < to.width; ++x, texel += 4) {
      double value[4];
      for (size_t c = 0; c < 4; ++c) value[c] = static_cast<double>(texel[c]);
      encode(to, row / to.height, x, row % to.height, value);
    }
  });
}

void make_source(const core::Context& context, const DirectionFaces& from, Texture* out) {
  const uint32_t faces = projection::face_count(from.projection);
  const core::Array<float> decoded = decode(context, from, faces);
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = SHD_FORMAT_RGBA32F;
  desc.width = from.width, desc.height = from.height, desc.layers = faces;
  desc.projection = from.projection;
  desc.texels = decoded.data();
  build(context, desc, out);
}

/// Angle between neighbouring texels, at the narrowest ones; on the equator of LAT_LONG [rad].
double texel_angle(const Texture& source) {
  switch (source.projection) {
    case SHD_PROJECTION_LAT_LONG: return std::min(data::kPi / source.height, 2.0 * data::kPi / source.width);
    case SHD_PROJECTION_ANGULAR: return 3.0 / source.width;
    case SHD_PROJECTION_CUBE: return 1.0 / source.width;
    default: return 2.0 / source.width;
  }
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

/// Directions of the ends of an edge of a texel.
struct Edge {
  double end[2][3];
};

double square_of_chord(const double* a, const double* b) {
  double sum = 0.0;
  for (int c = 0; c < 3; ++c) sum += (a[c] - b[c]) * (a[c] - b[c]);
  return sum;
}

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

  /// Directions of the upper and the lower end of the left edge of texel x.
  Edge edge_at(uint32_t face, uint32_t x, uint32_t y, Samples* s) const {
    s->count = 2;
    for (uint32_t k = 0; k < 2; ++k) {
      s->u[k] = static_cast<float>(static_cast<double>(x) / to.width);
      s->v[k] = static_cast<float>(static_cast<double>(y + k) / to.height);
      s->face[k] = face;
    }
    find_directions(s);
    Edge edge;
    for (int k = 0; k < 2; ++k) {
      for (int c = 0; c < 3; ++c) edge.end[k][c] = static_cast<double>(s->direction[c][k]);
    }
    return edge;
  }

  /// Number of samples along a side of a texel between two edges.
  uint32_t samples_along(const Edge& left, const Edge& right) const {
    const double longest =
        std::max(std::max(square_of_chord(left.end[0], right.end[0]), square_of_chord(left.end[1], right.end[1])),
                 std::max(square_of_chord(left.end[0], left.end[1]), square_of_chord(right.end[0], right.end[1])));
    const double samples = std::ceil(2.0 * std::sqrt(longest) / texel_angle(source));
    const uint32_t most = 2 * std::max(source.width, source.height) + 2;
    return std::min(most, std::max(2u, static_cast<uint32_t>(samples)));
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

  void convert_texel(uint32_t face, uint32_t x, uint32_t y, uint32_t side, Samples* s) const {
    Sums sums;
    const auto total = uint64_t{side} * side;
    for (uint64_t first = 0; first < total; first += kPart) {
      s->count = 0;
      for (uint64_t i = first; i < total && i < first + kPart; ++i) {
        place((x + (static_cast<double>(i % side) + 0.5) / side) / to.width,
              (y + (static_cast<double>(i / side) + 0.5) / side) / to.height, face, s);
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
    Edge left = edge_at(face, 0, y, &s);
    for (uint32_t x = 0; x < to.width; ++x) {
      const Edge right = edge_at(face, x + 1, y, &s);
      convert_texel(face, x, y, samples_along(left, right), &s);
      left = right;
    }
  }
};

}  // namespace

void convert(const core::Context& context, const DirectionFaces& from, const DirectionFaces& to) {
  if (from.projection == to.projection && from.width == to.width && from.height == to.height) {
    return copy_texels(context, from, to);
  }
  Texture source;
  make_source(context, from, &source);
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.filter = SHD_FILTER_BILINEAR;
  const Sampler sampler = make_sampler(desc);
  const bool disc = to.projection == SHD_PROJECTION_MIRROR_BALL || to.projection == SHD_PROJECTION_ANGULAR;
  const Conversion conversion = {context, source, sampler, to, disc};
  for_rows(context, {0, projection::face_count(to.projection) * to.height},
           [&](uint32_t row, uint32_t) { conversion.convert_row(row / to.height, row % to.height); });
}

}  // namespace shd::texture
