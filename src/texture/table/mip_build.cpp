// SPDX-License-Identifier: MIT
// One level by a separable kernel. For each level row, weighted rows of the source are summed into one row of doubles;
// then weighted columns of this row are summed.
#include "texture/table/mip_build.h"

#include <algorithm>

#include "core/executor.h"
#include "image/format.h"
#include "texture/format/formats.h"
#include "texture/table/mip_normal.h"
#include "texture/table/mip_weights.h"

namespace shd::texture {
namespace {

/// Weight of colours under alpha 0.
constexpr double kInvisible = 0x1p-20;

template <class Codec>
struct Filter {
  static constexpr size_t kChannels = Codec::kChannels;
  const shd_image& source;
  const shd_image& level;
  const AxisWeights& across;
  const AxisWeights& down;
  bool normal, lengths, weighted;
  float* alpha;

  /// The weight of a colour by its alpha, relative to the alpha of an opaque texel.
  static double weight_of(double alpha) { return std::max(alpha / Codec::one(3), 0.0) + kInvisible; }

  /// Decodes the texels of a source row to numbers, normals to vectors, and colours by their weight.
  void decode(const uint8_t* row, double* to) const {
    for (uint32_t x = 0; x < source.width; ++x, row += Codec::kSize, to += kChannels) {
      Codec::load(row, to);
      if constexpr (kChannels >= 3) {
        if (normal) decode_normal<Codec>(lengths, to);
      }
      if constexpr (kChannels == 4) {
        if (!weighted) continue;
        for (size_t c = 0; c < 3; ++c) to[c] *= weight_of(to[3]);
      }
    }
  }

  /// Computes level row y. `row` and `column` are scratch for one decoded source row each.
  void run(uint32_t y, double* __restrict row, double* __restrict column) const {
    const size_t size = source.width * kChannels;
    for (size_t i = 0; i < size; ++i) column[i] = 0;
    for (size_t tap = down.first[y]; tap < down.first[y + 1]; ++tap) {
      decode(static_cast<const uint8_t*>(source.pixels) + down.texel[tap] * source.row_stride, row);
      const double weight = down.weight[tap];
      for (size_t i = 0; i < size; ++i) column[i] += weight * row[i];
    }
    uint8_t* texel = static_cast<uint8_t*>(level.pixels) + y * level.row_stride;
    for (uint32_t x = 0; x < level.width; ++x, texel += Codec::kSize) store(x, y, column, texel);
  }

  void store(uint32_t x, uint32_t y, const double* column, uint8_t* texel) const {
    double sum[kChannels] = {};
    for (size_t tap = across.first[x]; tap < across.first[x + 1]; ++tap) {
      const double* value = column + across.texel[tap] * kChannels;
      for (size_t c = 0; c < kChannels; ++c) sum[c] += across.weight[tap] * value[c];
    }
    for (size_t c = 0; c < kChannels; ++c) sum[c] /= across.total * down.total;
    if constexpr (kChannels >= 3) {
      if (normal) encode_normal<Codec>(sum);
    }
    if constexpr (kChannels == 4) {
      if (weighted) {
        for (size_t c = 0; c < 3; ++c) sum[c] /= weight_of(sum[3]);
      }
    }
    for (size_t c = 0; c < kChannels; ++c) sum[c] = clamp_stored<Codec>(c, sum[c]);
    Codec::store(sum, texel);
    if constexpr (kChannels == 4) {
      if (alpha) alpha[size_t{y} * level.width + x] = static_cast<float>(sum[3] / Codec::one(3));
    }
  }
};

template <class Codec>
void filter_code(const core::Context& context, const Filter<Codec>& filter) {
  const size_t size = filter.source.width * Codec::kChannels;
  const uint32_t workers = context.executor.worker_count ? context.executor.worker_count : 1;
  core::Array<double> rows(context.allocator, core::checked_mul(core::checked_mul(size, 2), workers));
  core::parallel_for(context, filter.level.height, [&](uint32_t y, uint32_t worker) {
    double* row = rows.data() + size_t{worker} * 2 * size;
    filter.run(y, row, row + size);
  });
}

}  // namespace

void filter_level(const core::Context& context, const shd_image& source, const shd_mip_desc& desc, bool lengths,
                  const shd_image& level, float* alpha) {
  const image::FormatInfo format = image::format_info(source.format);
  const bool weighted = desc.content == SHD_TEXEL_CONTENT_ALPHA_WEIGHTED;
  const bool light =
      weighted || desc.content == SHD_TEXEL_CONTENT_COLOR || desc.content == SHD_TEXEL_CONTENT_ALPHA_COVERAGE;
  const bool as_unorm = format.component == image::Component::kSrgb8 && !light;
  const image::Component component = as_unorm ? image::Component::kUnorm8 : format.component;
  const AxisWeights across = make_axis_weights(context.allocator, desc.kernel, desc.wrap_u, source.width, level.width);
  const AxisWeights down = make_axis_weights(context.allocator, desc.kernel, desc.wrap_v, source.height, level.height);
  const bool normal = desc.content == SHD_TEXEL_CONTENT_NORMAL;
  visit_codec(component, format.channels, [&](auto codec) {
    using Codec = decltype(codec);
    filter_code<Codec>(context, {source, level, across, down, normal, lengths, weighted, alpha});
  });
}

}  // namespace shd::texture
