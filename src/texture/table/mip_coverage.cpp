// SPDX-License-Identifier: MIT
// Scales alpha so that the alpha test keeps its coverage (Castano, "Computing Alpha Mipmaps", 2010). The threshold that
// the wanted number of texels reach is found by bisection over the bits of positive floats, which have the order of the
// floats.
#include <atomic>
#include <cmath>

#include "core/executor.h"
#include "image/format.h"
#include "texture/format/formats.h"
#include "texture/format/texel_codec.h"
#include "texture/table/mip_build.h"

namespace shd::texture {
namespace {

constexpr uint32_t kInfinity = 0x7f800000;

float from_bits(uint32_t bits) {
  float value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

/// Stored alphas next to the cutoff.
struct Cut {
  double scale;       // stored number of alpha 1
  double pass, fail;  // smallest stored number that passes the alpha test, and largest that fails

  Cut(image::Component component, double cutoff) {
    scale = one_of(component, 3);
    pass = std::ceil(cutoff * scale);
    fail = pass - 1;
    const auto value = static_cast<float>(cutoff);
    if (component == image::Component::kFloat32) {
      pass = cutoff;
      uint32_t bits;
      std::memcpy(&bits, &value, sizeof bits);
      fail = static_cast<double>(from_bits(bits - 1));
    } else if (component == image::Component::kFloat16) {
      uint16_t half = image::float_to_half(value);
      if (static_cast<double>(image::half_to_float(half)) < cutoff) ++half;
      pass = static_cast<double>(image::half_to_float(half));
      fail = static_cast<double>(image::half_to_float(static_cast<uint16_t>(half - 1)));
    }
  }
};

/// Returns the codec of one channel of alpha, which is linear in all formats.
const TexelCodec& alpha_codec(image::Component component) {
  return codec_of(component == image::Component::kSrgb8 ? image::Component::kUnorm8 : component, 1);
}

uint64_t count_from(const float* alpha, size_t size, float threshold) {
  uint64_t count = 0;
  for (size_t i = 0; i < size; ++i) count += alpha[i] >= threshold;
  return count;
}

/// Returns a threshold above 0 that about `wanted` values reach.
float find_threshold(const float* alpha, size_t size, uint64_t wanted) {
  const uint64_t at_least = wanted ? wanted : 1;
  uint32_t low = 1, high = kInfinity;  // at_least or more values reach low, fewer reach high
  for (int i = 0; i < 31; ++i) {
    const uint32_t middle = low + (high - low) / 2;
    if (count_from(alpha, size, from_bits(middle)) >= at_least) {
      low = middle;
    } else {
      high = middle;
    }
  }
  const uint64_t many = count_from(alpha, size, from_bits(low)), few = count_from(alpha, size, from_bits(low + 1));
  return from_bits(many > wanted && many - wanted > wanted - few ? low + 1 : low);
}

}  // namespace

uint64_t count_covered(const core::Context& context, const shd_image& image, double cutoff) {
  const image::FormatInfo format = image::format_info(image.format);
  const Cut cut(format.component, cutoff);
  const TexelCodec& codec = alpha_codec(format.component);
  std::atomic<uint64_t> total{0};
  core::parallel_for(context, image.height, [&](uint32_t y, uint32_t) {
    const auto* texel = static_cast<const uint8_t*>(image.pixels) + y * image.row_stride + 3 * format.channel_size;
    uint64_t count = 0;
    for (uint32_t x = 0; x < image.width; ++x, texel += format.pixel_size) {
      double value;
      codec.load(texel, 1, &value);
      count += value >= cut.pass;
    }
    total.fetch_add(count, std::memory_order_relaxed);
  });
  return total.load(std::memory_order_relaxed);
}

void store_covered(const core::Context& context, const float* alpha, double cutoff, uint64_t wanted,
                   const shd_image& level) {
  const image::FormatInfo format = image::format_info(level.format);
  const Cut cut(format.component, cutoff);
  const auto threshold = static_cast<double>(find_threshold(alpha, size_t{level.width} * level.height, wanted));
  const TexelCodec& codec = alpha_codec(format.component);
  const double lowest = codec.is_float ? -codec.largest[0] : 0;  // negative alphas over a small threshold exceed it
  core::parallel_for(context, level.height, [&](uint32_t y, uint32_t) {
    auto* texel = static_cast<uint8_t*>(level.pixels) + y * level.row_stride + 3 * format.channel_size;
    for (uint32_t x = 0; x < level.width; ++x, texel += format.pixel_size) {
      const auto value = static_cast<double>(alpha[size_t{y} * level.width + x]);
      double scaled = value / threshold * cut.pass;
      if (value >= threshold) {
        scaled = scaled > cut.scale ? cut.scale : scaled < cut.pass ? cut.pass : scaled;
      } else if (scaled > cut.fail) {
        scaled = cut.fail;
      } else if (scaled < lowest && std::isfinite(value)) {
        scaled = lowest;
      }
      codec.store(&scaled, 1, texel);
    }
  });
}

}  // namespace shd::texture
