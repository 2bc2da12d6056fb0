// SPDX-License-Identifier: MIT
// Textures, samplers and points for the texture tests. All objects are on the heap or in static storage, because cmocka
// leaves a failing test by longjmp.
#pragma once

#include "support/check.h"

#include <math.h>
#include <stdlib.h>

#include <hwy/highway.h>

#include "core/context.h"
#include "core/simd_target.h"
#include "image/format.h"
#include "ref/texture_ref.h"
#include "texture/lookup/sample.h"
#include "texture/store/storage.h"
#include "texture/texture.h"

namespace fixture {

using shd::image::Component;
using shd::texture::Lookups;
using shd::texture::make_sampler;
using shd::texture::Sampler;
using shd::texture::Texels;
using shd::texture::Texture;

/// Every component type, and every number of channels.
constexpr shd_format kFormats[] = {SHD_FORMAT_R8,      SHD_FORMAT_RG8_SRGB, SHD_FORMAT_RGBA8,   SHD_FORMAT_RGBA8_SRGB,
                                   SHD_FORMAT_R16,     SHD_FORMAT_RG16,     SHD_FORMAT_RGBA16,  SHD_FORMAT_R16F,
                                   SHD_FORMAT_RGBA16F, SHD_FORMAT_RG32F,    SHD_FORMAT_RGBA32F, SHD_FORMAT_RGB9E5};
constexpr size_t kMaxPoints = 512;
constexpr uint32_t kCanary = 0x7fc0beefu;

/// The quick generator of Numerical Recipes: reproducible, and sufficient to pick test points.
struct Random {
  uint32_t state;
  uint32_t next() { return state = state * 1664525u + 1013904223u; }
  /// Uniform in [low, high).
  float real(float low, float high) { return low + (high - low) * static_cast<float>(next() >> 8) * 0x1p-24f; }
};

inline shd::core::Context* context() {
  static shd::core::Context* made = shd::core::create_context(shd_context_desc_default());
  return made;
}

/// Largest magnitude of the random texels of a format.
inline double magnitude(shd_format format) {
  return shd::image::is_unorm(shd::image::format_info(format).component) ? 1 : 8;
}

/// Random texels; floats in [-8, 8), shared exponents in [0, 8).
inline void random_texels(shd_format format, size_t count, uint32_t seed, uint8_t* texels) {
  Random random{seed};
  const size_t channels = shd::image::format_info(format).channels;
  const Component component = shd::image::format_info(format).component;
  for (size_t i = 0; component == Component::kRgb9e5 && i < count; ++i) {
    const uint32_t numbers = random.next() >> 5, exponent = 13 + (random.next() >> 16) % 6;
    const uint32_t word = exponent << 27 | numbers;
    memcpy(texels + 4 * i, &word, 4);
  }
  for (size_t i = 0; component != Component::kRgb9e5 && i < count * channels; ++i) {
    const float value = random.real(-8, 8);
    const auto half = static_cast<uint16_t>((random.next() >> 16 & 0x8fff) | 0x3000);  // 2^-3..2^0, both signs
    const uint16_t code = static_cast<uint16_t>(random.next() >> 16);
    if (component == Component::kFloat32) {
      memcpy(texels + 4 * i, &value, 4);
    } else if (component == Component::kFloat16) {
      memcpy(texels + 2 * i, &half, 2);
    } else if (component == Component::kUnorm16) {
      memcpy(texels + 2 * i, &code, 2);
    } else {
      texels[i] = static_cast<uint8_t>(random.next() >> 24);
    }
  }
}

/// Makes a texture from texels in memory.
inline Texture* make_texture(shd_format format, uint32_t width, uint32_t height, const uint8_t* texels, bool mipmap) {
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = format;
  desc.width = width;
  desc.height = height;
  desc.texels = texels;
  desc.tables = mipmap ? SHD_TABLE_MIPMAP : SHD_TABLE_NONE;
  auto* texture = shd::core::create<Texture>(context()->allocator);
  shd::texture::build(*context(), desc, texture);
  return texture;
}
inline Texture* random_texture(shd_format format, uint32_t width, uint32_t height, bool mipmap) {
  auto* texels = static_cast<uint8_t*>(malloc(size_t{width} * height * 16));
  random_texels(format, size_t{width} * height, width * 31 + height, texels);
  Texture* texture = make_texture(format, width, height, texels, mipmap);
  free(texels);
  return texture;
}
inline void free_texture(Texture* texture) {
  shd::core::destroy(context()->allocator, texture);
}

/// A context whose executor runs tasks backwards on one thread; the order must not affect results.
inline shd::core::Context* backwards_context() {
  shd_context_desc desc = shd_context_desc_default();
  desc.executor.worker_count = 1;
  desc.executor.parallel_for = [](size_t count, shd_task_fn task, void* data, void*) -> shd_result {
    for (size_t i = count; i-- > 0;) task(i, 0, data);
    return SHD_OK;
  };
  return shd::core::create_context(desc);
}

/// The levels of a texture in the form of the oracle; `levels` has room for all of them.
inline ref::Image oracle_image(const Texture& texture, const shd_sampler_desc& sampler, ref::Level* levels) {
  for (uint32_t l = 0; l < texture.level_count; ++l) {
    levels[l] = {shd::texture::row_of(texture, 0, l, 0), shd::texture::level_size(texture.width, l),
                 shd::texture::level_size(texture.height, l)};
  }
  return {texture.format, levels, static_cast<int>(texture.level_count), &sampler};
}

/// Columns of points and of their results.
struct Batch {
  size_t count;
  float u[kMaxPoints], v[kMaxPoints];
  float dudx[kMaxPoints], dvdx[kMaxPoints], dudy[kMaxPoints], dvdy[kMaxPoints], lod[kMaxPoints];
  float out[4][kMaxPoints + 64];

  Lookups lookups(bool derivatives, bool with_lod) const {
    const bool j = derivatives;
    return {count,
            u,
            v,
            j ? dudx : nullptr,
            j ? dvdx : nullptr,
            j ? dudy : nullptr,
            j ? dvdy : nullptr,
            with_lod ? lod : nullptr,
            nullptr,
            nullptr};
  }
  void set_canaries() {
    for (auto& column : out) {
      for (float& value : column) memcpy(&value, &kCanary, sizeof value);
    }
  }
  void check_canaries() const {
    for (const auto& column : out) {
      for (size_t i = count; i < kMaxPoints + 64; ++i) assert_memory_equal(&column[i], &kCanary, sizeof kCanary);
    }
  }
};

/// Runs a batch on one target, with all four channels.
inline size_t run(const Texture& texture, const Sampler& sampler, int64_t target, const Lookups& lookups,
                  Batch* batch) {
  batch->set_canaries();
  const Texels out = {{batch->out[0], batch->out[1], batch->out[2], batch->out[3]}, {}, {}};
  const size_t nonfinite =
      shd::texture::sample(texture, sampler, shd::core::simd_target_from_bit(target), lookups, out);
  batch->check_canaries();
  return nonfinite;
}

/// Calls body(target) for every Highway target that can run here.
template <class Body>
void for_each_target(Body&& body) {
  for (const int64_t target : hwy::SupportedAndGeneratedTargets()) body(target);
}

/// Writes the derivatives of lookups in u and v: [2][channel][point]. Derivatives that are not computed are 0.
inline void run_gradient(const Texture& texture, const Sampler& sampler, int64_t target, const Lookups& lookups,
                         float (&gradient)[2][4][kMaxPoints]) {
  memset(gradient, 0, sizeof gradient);
  Texels out = {};
  for (size_t c = 0; c < 4; ++c) {
    out.du[c] = gradient[0][c];
    out.dv[c] = gradient[1][c];
  }
  shd::texture::sample(texture, sampler, shd::core::simd_target_from_bit(target), lookups, out);
}

}  // namespace fixture
