// SPDX-License-Identifier: MIT
// Rows of quads against streams: equal bits for lookups that share their levels. Lookups of a texture of two layers are
// never filtered by rows, so the same texels as one layer and as the first of two show both ways.
#include "fixture.h"

namespace {

using namespace fixture;

constexpr uint32_t kSizes[][2] = {{1, 1}, {1, 9}, {2, 2}, {7, 5}, {33, 17}, {64, 64}, {300, 2}};
constexpr shd_filter kLinear[] = {SHD_FILTER_BILINEAR, SHD_FILTER_BILINEAR_MIP, SHD_FILTER_TRILINEAR};
constexpr shd_profile kProfiles[] = {SHD_PROFILE_EXACT, SHD_PROFILE_LEAST_ERROR, SHD_PROFILE_VULKAN};
constexpr size_t kCounts[] = {1, 3, 16, 17, 255, 256, 257, 300, 512};

Batch t_batch, t_wanted;

/// Lookups along a line, `step` texels of a texture apart, which share their levels except near `level` 0 and at wraps.
/// `bend` changes the level along the line, so that some blocks share levels and others do not.
void make_line(const uint32_t (&size)[2], float step_x, float step_y, float level, float bend, size_t count) {
  t_batch.count = count;
  for (size_t i = 0; i < count; ++i) {
    const auto x = static_cast<float>(i);
    t_batch.u[i] = -0.75f + x * step_x / static_cast<float>(size[0]);
    t_batch.v[i] = -0.4f + x * step_y / static_cast<float>(size[1]);
    const float footprint = exp2f(level + bend * x / static_cast<float>(kMaxPoints));
    t_batch.dudx[i] = footprint / static_cast<float>(size[0]);
    t_batch.dvdy[i] = footprint / static_cast<float>(size[1]);
    t_batch.dvdx[i] = t_batch.dudy[i] = 0;
    t_batch.lod[i] = level + bend * x / static_cast<float>(kMaxPoints);
  }
}

Texture* make_layers(shd_format format, const uint32_t (&size)[2], uint32_t layers) {
  const size_t texels = size_t{size[0]} * size[1], bytes = texels * shd::image::format_info(format).pixel_size;
  auto* memory = static_cast<uint8_t*>(malloc(2 * texels * 16));
  random_texels(format, texels, size[0] * 31 + size[1], memory);
  memcpy(memory + bytes, memory, bytes);
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = format;
  desc.width = size[0], desc.height = size[1], desc.layer_count = layers;
  desc.texels = memory;
  desc.tables = SHD_TABLE_MIPMAP;
  auto* texture = shd::core::create<Texture>(context()->allocator);
  shd::texture::build(*context(), desc, texture);
  free(memory);
  return texture;
}

/// Runs t_batch on one target, without alpha.
void run_colors(const Texture& texture, const Sampler& sampler, int64_t target, const Lookups& lookups) {
  t_batch.set_canaries();
  const shd::texture::Texels out = {{t_batch.out[0], t_batch.out[1], t_batch.out[2], nullptr}, {}, {}};
  shd::texture::sample(texture, sampler, shd::core::simd_target_from_bit(target), lookups, out);
  t_batch.check_canaries();
}

/// Both textures of one format and size.
struct Pair {
  Texture *rows, *stream;

  Pair(shd_format format, const uint32_t (&size)[2])
      : rows(make_layers(format, size, 1)), stream(make_layers(format, size, 2)) {}
  Pair(const Pair&) = delete;
  ~Pair() {
    free_texture(rows);
    free_texture(stream);
  }

  void check(const shd_sampler_desc& desc, bool with_lod) const {
    const Sampler sampler = make_sampler(desc);
    for_each_target([&](int64_t target) {
      const Lookups lookups = t_batch.lookups(!with_lod, with_lod);
      t_wanted.count = t_batch.count;
      const size_t wanted = run(*stream, sampler, target, lookups, &t_wanted);
      assert_int_equal(run(*rows, sampler, target, lookups, &t_batch), wanted);
      bool same = memcmp(t_batch.out, t_wanted.out, sizeof t_batch.out) == 0;
      run_colors(*rows, sampler, target, lookups);
      same &= memcmp(t_batch.out, t_wanted.out, sizeof t_batch.out / 4 * 3) == 0;
      if (same) return;
      print_error("target %lld, filter %d, wrap %d %d, profile %d, count %zu\n", static_cast<long long>(target),
                  desc.filter, desc.wrap_u, desc.wrap_v, desc.profile, t_batch.count);
      fail();
    });
  }
};

/// Every filter and wrap, along a line.
void check_line(const Pair& textures) {
  for (const shd_filter filter : kLinear) {
    for (const shd_profile profile : kProfiles) {
      for (uint32_t wrap = 0; wrap < 25; ++wrap) {
        shd_sampler_desc desc = shd_sampler_desc_default();
        desc.filter = filter;
        desc.profile = profile;
        desc.wrap_u = static_cast<shd_wrap>(wrap % 5);
        desc.wrap_v = static_cast<shd_wrap>(wrap / 5);
        textures.check(desc, false);
        if (profile == SHD_PROFILE_EXACT) textures.check(desc, true);
      }
    }
  }
}

void test_size(void** state) {
  const auto& size = *static_cast<const uint32_t(*)[2]>(*state);
  for (const shd_format format : kFormats) {
    const Pair textures(format, size);
    const float levels[] = {-1.0f, 0.0f, 0.4f, 1.7f, 2.0f, 30.0f};
    size_t at = 0;
    for (const float level : levels) {
      // Steps to the right and to the left, along columns, and far apart.
      const float steps[][2] = {{0.5f, 0.01f}, {-1.7f, 0.3f}, {0.0f, 1.0f}, {61.0f, -47.0f}};
      make_line(size, steps[at % 4][0], steps[at % 4][1], level, at % 2 ? 0.0f : 2.0f, kCounts[at % 9]);
      ++at;
      check_line(textures);
    }
    // Parts of a block share levels, and the level changes within others.
    make_line(size, -0.6f, 0.2f, 0.3f, 7.0f, 499);
    check_line(textures);
    make_line(size, 0.7f, 0.1f, 0.4f, 0.0f, 300);
    t_batch.u[7] = NAN;
    t_batch.v[100] = INFINITY;
    t_batch.u[299] = 1e30f;
    t_batch.dudx[20] = NAN;
    t_batch.dvdy[40] = INFINITY;
    check_line(textures);
  }
}

}  // namespace

int main() {
  constexpr size_t kCount = sizeof kSizes / sizeof *kSizes;
  CMUnitTest tests[kCount];
  static char names[kCount][16];
  for (size_t i = 0; i < kCount; ++i) {
    snprintf(names[i], sizeof names[i], "%ux%u", kSizes[i][0], kSizes[i][1]);
    tests[i] = cmocka_unit_test_prestate(test_size, const_cast<uint32_t(*)[2]>(&kSizes[i]));
    tests[i].name = names[i];
  }
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
