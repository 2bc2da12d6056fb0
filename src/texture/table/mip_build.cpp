// SPDX-License-Identifier: MIT
// One level by a separable kernel. For each level row, weighted rows of the source are summed into one row of doubles;
// then weighted columns of this row are summed.
#include "texture/table/mip_build.h"

#include <algorithm>

#include "core/executor.h"
#include "image/format.h"
#include "texture/format/texel_codec.h"
#include "texture/table/mip_normal.h"
#include "texture/table/mip_weights.h"

namespace shd::texture {
namespace {

/// Weight of colours under alpha 0.
constexpr double kInvisible = 0x1p-20;

struct Filter {
  const TexelCodec& codec;
  const shd_image& source;
  const shd_image& level;
  const AxisWeights& across;
  const AxisWeights& down;
  bool normal, lengths, weighted;
  float* alpha;

  /// The weight of a colour by its alpha, relative to the alpha of an opaque texel.
  double weight_of(double number) const { return std::max(number / codec.one[3], 0.0) + kInvisible; }

  /// Decodes the texels of a source row to numbers, normals to vectors, and colours by their weight.
  void decode(const uint8_t* row, double* to) const {
    codec.load(row, source.width, to);
    if (!normal && !weighted) return;
    for (uint32_t x = 0; x < source.width; ++x, to += codec.channels) {
      if (normal) decode_normal(codec, lengths, to);
      for (size_t c = 0; c < 3 && weighted; ++c) to[c] *= weight_of(to[3]);
    }
  }

  /// Computes level row y. `row` and `column` are scratch for one decoded source row each.
  void run(uint32_t y, double* __restrict row, double* __restrict column) const {
    const size_t size = source.width * codec.channels;
    for (size_t i = 0; i < size; ++i) column[i] = 0;
    for (size_t tap = down.first[y]; tap < down.first[y + 1]; ++tap) {
      decode(static_cast<const uint8_t*>(source.pixels) + down.texel[tap] * source.row_stride, row);
      const double weight = down.weight[tap];
      for (size_t i = 0; i < size; ++i) column[i] += weight * row[i];
    }
    uint8_t* texel = static_cast<uint8_t*>(level.pixels) + y * level.row_stride;
    for (uint32_t x = 0; x < level.width; ++x, texel += codec.size) store(x, y, column, texel);
  }

  void store(uint32_t x, uint32_t y, const double* column, uint8_t* texel) const {
    double sum[4] = {};
    with_channels(codec.channels, [&](auto channels) {
      for (size_t tap = across.first[x]; tap < across.first[x + 1]; ++tap) {
        const double* value = column + across.texel[tap] * channels;
        for (size_t c = 0; c < channels; ++c) sum[c] += across.weight[tap] * value[c];
      }
    });
    for (size_t c = 0; c < codec.channels; ++c) sum[c] /= across.total * down.total;
    if (normal) encode_normal(codec, sum);
    for (size_t c = 0; c < 3 && weighted; ++c) sum[c] /= weight_of(sum[3]);
    for (size_t c = 0; c < codec.channels; ++c) sum[c] = codec.clamp(c, sum[c]);
    codec.store(sum, 1, texel);
    if (alpha) alpha[size_t{y} * level.width + x] = static_cast<float>(sum[3] / codec.one[3]);
  }
};

}  // namespace

void filter_level(const core::Context& context, const shd_image& source, const shd_mip_desc& desc, bool lengths,
                  const shd_image& level, float* alpha) {
  const image::FormatInfo format = image::format_info(source.format);
  const bool weighted = desc.content == SHD_TEXEL_CONTENT_ALPHA_WEIGHTED;
  const bool light =
      weighted || desc.content == SHD_TEXEL_CONTENT_COLOR || desc.content == SHD_TEXEL_CONTENT_ALPHA_COVERAGE;
  const AxisWeights across = make_axis_weights(context.allocator, desc.kernel, desc.wrap_u, source.width, level.width);
  const AxisWeights down = make_axis_weights(context.allocator, desc.kernel, desc.wrap_v, source.height, level.height);
  const TexelCodec& codec = light ? codec_of(format.component, format.channels) : codec_of_numbers(source.format);
  const bool normal = desc.content == SHD_TEXEL_CONTENT_NORMAL && codec.channels >= 3;
  const bool has_alpha = codec.channels == 4;
  const Filter filter = {
      codec, source, level, across, down, normal, lengths, weighted && has_alpha, has_alpha ? alpha : nullptr};
  const size_t size = source.width * codec.channels;
  const uint32_t workers = context.executor.worker_count ? context.executor.worker_count : 1;
  core::Array<double> rows(context.allocator, core::checked_mul(core::checked_mul(size, 2), workers));
  core::parallel_for(context, level.height, [&](uint32_t y, uint32_t worker) {
    double* row = rows.data() + size_t{worker} * 2 * size;
    filter.run(y, row, row + size);
  });
}

}  // namespace shd::texture
