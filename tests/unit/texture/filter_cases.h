// SPDX-License-Identifier: MIT
// Properties of every filter, as checks whose parameters differ between filters: the sampler, the texture, the oracle.
#pragma once

#include "points.h"

namespace fixture {

struct SizeCase {
  const char* name;
  uint32_t width, height;
};
constexpr SizeCase kSizes[] = {
    {"1x1", 1, 1},       {"1x7", 1, 7},           {"5x3", 5, 3},       {"64x64", 64, 64},
    {"128x32", 128, 32}, {"1023x511", 1023, 511}, {"4096x1", 4096, 1},
};
constexpr size_t kSizeCount = sizeof kSizes / sizeof kSizes[0];

/// Names a test of every size "<prefix>/<size>". Returns the number of sizes.
inline size_t add_sizes(const char* prefix, CMUnitTestFunction test, CMUnitTest* tests) {
  static char names[kSizeCount][32];
  for (size_t i = 0; i < kSizeCount; ++i) {
    snprintf(names[i], sizeof names[i], "%s/%s", prefix, kSizes[i].name);
    tests[i] = {names[i], test, nullptr, nullptr, const_cast<SizeCase*>(&kSizes[i])};
  }
  return kSizeCount;
}

/// A filter with wrap pair 0..24, repeating, and a border colour that occurs in no texture. Its levels are those of the
/// oracles: log2 of the longer axis.
inline shd_sampler_desc wrap_desc(shd_filter filter, uint32_t pair) {
  const float border[] = {0.25f, -1.5f, 2.0f, 0.75f};
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.filter = filter;
  desc.profile = SHD_PROFILE_EXACT;
  desc.wrap_u = static_cast<shd_wrap>(pair % 5);
  desc.wrap_v = static_cast<shd_wrap>(pair / 5 % 5);
  memcpy(desc.border, border, sizeof border);
  return desc;
}

/// Runs a batch on every target. All targets must give equal bits, which are left in `batch`, and equal numbers of
/// lookups with non-finite inputs, which is returned.
inline size_t run_everywhere(const Texture& texture, const shd_sampler_desc& desc, const Lookups& lookups,
                             Batch* batch) {
  static float first_out[4][kMaxPoints + 64];
  size_t first_nonfinite = 0;
  bool first = true;
  for_each_target([&](int64_t target) {
    const size_t nonfinite = run(texture, make_sampler(desc), target, lookups, batch);
    if (first) {
      memcpy(first_out, batch->out, sizeof first_out);
      first_nonfinite = nonfinite;
    }
    first = false;
    assert_memory_equal(first_out, batch->out, sizeof first_out);
    assert_int_equal(nonfinite, first_nonfinite);
  });
  return first_nonfinite;
}

/// Two samplers must give equal bits on every target, for the same points in both batches.
inline void check_same_bits(const Texture& texture, const shd_sampler_desc& one, const shd_sampler_desc& other,
                            bool lod, Batch* batch, Batch* other_batch) {
  for_each_target([&](int64_t target) {
    run(texture, make_sampler(one), target, batch->lookups(!lod, lod), batch);
    run(texture, make_sampler(other), target, other_batch->lookups(!lod, lod), other_batch);
    assert_memory_equal(other_batch->out, batch->out, sizeof batch->out);
  });
}

/// Runs the points of make_points on every target, then check_point(image, i) for each point.
template <class CheckPoint>
void check_against_oracle(const Texture& texture, const shd_sampler_desc& desc, const Lookups& lookups, Batch* batch,
                          CheckPoint&& check_point) {
  ref::Level levels[shd::texture::kMaxLevels];
  const ref::Image image = oracle_image(texture, desc, levels);
  assert_int_equal(run_everywhere(texture, desc, lookups, batch), kNonfinitePoints);
  for (size_t i = 0; i < batch->count; ++i) check_point(image, i);
}

/// Repeats one texel, which depends only on the format.
inline void constant_texels(shd_format format, size_t count, uint8_t* texels) {
  const size_t bytes = shd_format_size(format);
  random_texels(format, 1, 4242, texels);
  for (size_t i = 1; i < count; ++i) memcpy(texels + i * bytes, texels, bytes);
}

/// A texture of constant_texels gives exactly their value, for any coordinates and footprint.
inline void check_constant(const Texture& texture, const shd_sampler_desc& desc, bool derivatives) {
  static Batch batch;
  uint8_t texel[16];
  constant_texels(texture.format, 1, texel);
  make_points(&batch);
  for_each_target([&](int64_t target) {
    run(texture, make_sampler(desc), target, batch.lookups(derivatives, false), &batch);
    for (int c = 0; c < 4; ++c) {
      const auto want = static_cast<float>(ref::decode(texture.format, texel, c));
      for (size_t i = 0; i < batch.count; ++i) assert_true(batch.out[c][i] == want);
    }
  });
}

/// Runs check_constant with a mipmap, for every format and the `pairs` samplers that never read the border.
template <class MakeDesc>
void check_constant_mipmap(uint32_t pairs, MakeDesc&& make_desc) {
  for (const shd_format format : kFormats) {
    uint8_t texels[16 * 16 * 16];
    constant_texels(format, 16 * 16, texels);
    Texture* texture = make_texture(format, 16, 16, texels, true);
    for (uint32_t pair = 0; pair < pairs; ++pair) {
      const shd_sampler_desc desc = make_desc(pair);
      if (desc.wrap_u == SHD_WRAP_BORDER || desc.wrap_v == SHD_WRAP_BORDER) continue;
      check_constant(*texture, desc, true);
    }
    free_texture(texture);
  }
}

/// Fills the memory of the next calls with values that are no levels, indices or addresses, so that a call that reads
/// what it did not write fails always.
[[gnu::noinline]] inline void poison_stack() {
  volatile uint32_t words[4096];
  for (volatile uint32_t& word : words) word = 0x7e7e7e7eu;
}

/// Every tail length, 0 too, gives the bits of the whole batch and writes nothing after it.
inline void check_tails(const Texture& texture, const shd_sampler_desc& desc, bool derivatives) {
  static Batch whole, tail;
  const Sampler sampler = make_sampler(desc);
  make_points(&whole);
  make_points(&tail);
  for_each_target([&](int64_t target) {
    run(texture, sampler, target, whole.lookups(derivatives, false), &whole);
    for (size_t count = 0; count <= 35; ++count) {
      tail.count = count;
      poison_stack();
      run(texture, sampler, target, tail.lookups(derivatives, false), &tail);
      for (size_t c = 0; c < 4; ++c) assert_memory_equal(tail.out[c], whole.out[c], count * sizeof(float));
    }
  });
}

/// Runs check_tails for every format; with derivatives, the texture has a mipmap.
inline void check_tails_of_formats(const shd_sampler_desc& desc, bool derivatives) {
  for (const shd_format format : kFormats) {
    Texture* texture = random_texture(format, 64, 32, derivatives);
    check_tails(*texture, desc, derivatives);
    free_texture(texture);
  }
}

/// A channel that is not requested is not written, and the other channels do not change.
inline void check_unwanted_channels(const Texture& texture, const shd_sampler_desc& desc) {
  static Batch all, one;
  const Sampler sampler = make_sampler(desc);
  make_points(&all);
  one.count = all.count;
  const Lookups lookups = all.lookups(true, false);
  for_each_target([&](int64_t target) {
    run(texture, sampler, target, lookups, &all);
    for (size_t wanted = 0; wanted < 4; ++wanted) {
      one.set_canaries();
      Texels out = {};
      out.channel[wanted] = one.out[wanted];
      shd::texture::sample(texture, sampler, shd::core::simd_target_from_bit(target), lookups, out);
      one.check_canaries();
      assert_memory_equal(one.out[wanted], all.out[wanted], one.count * sizeof(float));
      for (size_t c = 0; c < 4; ++c) {
        if (c == wanted) continue;
        for (size_t i = 0; i < one.count; ++i) assert_memory_equal(&one.out[c][i], &kCanary, sizeof kCanary);
      }
    }
  });
}

/// Derivatives mixed from `values` of any bits: finite texels give values between the smallest and the largest of them,
/// equal on every target.
template <size_t kValues, class MakeDesc>
void check_hostile_derivatives(const float (&values)[kValues], uint32_t rounds, MakeDesc&& make_desc) {
  static Batch batch;
  Texture* texture = random_texture(SHD_FORMAT_RGBA32F, 61, 37, true);
  Random random{99};
  make_points(&batch);
  for (uint32_t round = 0; round < rounds; ++round) {
    for (size_t i = 0; i < kPoints; ++i) {
      for (float* column : {batch.dudx, batch.dvdx, batch.dudy, batch.dvdy})
        column[i] = values[(random.next() >> 16) % kValues];
    }
    run_everywhere(*texture, make_desc(round), batch.lookups(true, false), &batch);
    for (const auto& column : batch.out) {
      for (size_t i = 0; i < kPoints; ++i) assert_true(column[i] >= -8.001f && column[i] <= 8.001f);
    }
  }
  free_texture(texture);
}

/// Runs check_hostile_derivatives for a filter with probes or an ellipse, with bias, width and blur.
template <class MakeDesc>
void check_hostile_footprints(MakeDesc&& make_desc) {
  const float values[] = {0, -1e-45f, 1e-30f, -1e-3f, 0.3f, 1e10f, -1e30f, 3.4e38f, INFINITY, NAN};
  check_hostile_derivatives(values, 60, [&](uint32_t round) {
    shd_sampler_desc desc = make_desc(round);
    desc.lod_bias = round % 3 == 0 ? -15.0f : 0.0f;
    desc.width_x = round % 4 == 0 ? 64.0f : 1.0f;
    desc.blur_v = round % 5 == 0 ? 0.5f : 0.0f;
    return desc;
  });
}

/// Hostile footprints: every mix of sizes from zero to infinity.
inline void make_hostile_points(Batch* batch) {
  const float entries[] = {0,    1e-30f, 1e-10f, 1e-6f, 1e-3f,          0.1f,     1,         20,
                           1e4f, 1e10f,  1e30f,  1e38f, 3.40282347e38f, INFINITY, -INFINITY, NAN};
  Random random{11};
  make_points(batch);
  batch->count = kMaxPoints;
  for (size_t i = 0; i < kMaxPoints; ++i) {
    if (i >= kPoints) {
      batch->u[i] = batch->u[i % kPoints];
      batch->v[i] = batch->v[i % kPoints];
    }
    for (float* column : {batch->dudx, batch->dvdx, batch->dudy, batch->dvdy}) {
      column[i] = entries[random.next() >> 28] * (random.next() >> 31 ? 1.0f : -0.75f);
    }
    if (i % 4 == 1) batch->dvdx[i] = batch->dudy[i] = 0;
    batch->lod[i] = entries[i % 16];
  }
}

/// An infinite derivative gives the coarsest level.
inline void check_infinite(const shd_sampler_desc& desc) {
  static Batch batch;
  Texture* texture = random_texture(SHD_FORMAT_RGBA32F, 64, 64, true);
  const auto* coarsest = reinterpret_cast<const float*>(shd::texture::row_of(*texture, 0, 6, 0));
  make_points(&batch);
  for (size_t i = 0; i < kPoints; ++i) batch.dvdx[i] = i % 2 ? INFINITY : -INFINITY;
  for_each_target([&](int64_t target) {
    run(*texture, make_sampler(desc), target, batch.lookups(true, false), &batch);
    for (int c = 0; c < 4; ++c) {
      for (size_t i = 0; i < kPoints; ++i) assert_true(batch.out[c][i] == coarsest[c]);
    }
  });
  free_texture(texture);
}

/// Non-finite texels, all in column 9 of 16, are ignored if their weight is 0: for a footprint along column `beside`,
/// in texels, and past the last tap of a lane. They do count at `inside`.
inline void check_nonfinite_column(const shd_sampler_desc& desc, float inside, float beside) {
  static Batch batch;
  float texels[16 * 16 * 4];
  for (size_t i = 0; i < 256; ++i) {
    for (size_t c = 0; c < 4; ++c) texels[4 * i + c] = i % 16 == 9 ? (c % 2 ? NAN : INFINITY) : 1;
  }
  Texture* texture = make_texture(SHD_FORMAT_RGBA32F, 16, 16, reinterpret_cast<uint8_t*>(texels), false);
  batch.count = 64;
  for (size_t i = 0; i < 64; ++i) {
    batch.u[i] = (i % 5 == 4 ? inside : beside) / 16;
    batch.v[i] = 0.5f;
    batch.dudx[i] = batch.dudy[i] = 0;
    batch.dvdx[i] = 1.0f / 16;
    batch.dvdy[i] = i % 3 ? 8.0f / 16 : 0;
  }
  for_each_target([&](int64_t target) {
    run(*texture, make_sampler(desc), target, batch.lookups(true, false), &batch);
    for (const auto& column : batch.out) {
      for (size_t i = 0; i < 64; ++i) {
        if (i % 5 == 4) assert_false(isfinite(column[i]));
        if (i % 5 != 4) assert_true(column[i] == 1);
      }
    }
  });
  free_texture(texture);
}

/// Each lane reads its own layer.
inline void check_layers(const shd_sampler_desc& sampler_desc) {
  static Batch of_array, of_layer;
  constexpr size_t kTexels = 32 * 16, kLayers = 3;
  auto* texels = static_cast<uint8_t*>(malloc(kTexels * kLayers * 4));
  random_texels(SHD_FORMAT_RGBA8, kTexels * kLayers, 5, texels);
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = SHD_FORMAT_RGBA8;
  desc.width = 32;
  desc.height = 16;
  desc.layer_count = kLayers;
  desc.texels = texels;
  desc.tables = SHD_TABLE_MIPMAP;
  auto* array = shd::core::create<Texture>(context()->allocator);
  shd::texture::build(*context(), desc, array);
  make_points(&of_array);
  make_points(&of_layer);
  static uint32_t layer[kMaxPoints];
  for (size_t i = 0; i < kPoints; ++i) layer[i] = static_cast<uint32_t>(i * 7 % 4);  // 3 is beyond the last layer
  const Sampler sampler = make_sampler(sampler_desc);
  for (uint32_t l = 0; l < kLayers; ++l) {
    Texture* single = make_texture(SHD_FORMAT_RGBA8, 32, 16, texels + l * kTexels * 4, true);
    for_each_target([&](int64_t target) {
      Lookups lookups = of_array.lookups(true, false);
      run(*single, sampler, target, lookups, &of_layer);
      lookups.layer = layer;
      run(*array, sampler, target, lookups, &of_array);
      for (size_t i = 0; i < kPoints; ++i) {
        if ((layer[i] < kLayers ? layer[i] : kLayers - 1) != l) continue;
        for (size_t c = 0; c < 4; ++c) assert_memory_equal(&of_layer.out[c][i], &of_array.out[c][i], sizeof(float));
      }
    });
    free_texture(single);
  }
  free_texture(array);
  free(texels);
}

}  // namespace fixture
