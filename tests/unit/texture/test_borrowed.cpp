// SPDX-License-Identifier: MIT
// Borrowed base levels against copied ones: equal bits for every filter, format and target, with texels that end as
// close before unreadable memory as allowed.
#include "texture/stream.h"

#include "points.h"

#include <sys/mman.h>
#include <unistd.h>

namespace {

using namespace fixture;

struct size_case {
  const char* name;
  uint32_t width, height;
};
const size_case k_sizes[] = {
    {"1x1", 1, 1}, {"1x7", 1, 7}, {"5x3", 5, 3}, {"64x64", 64, 64}, {"1023x511", 1023, 511}, {"4096x1", 4096, 1},
};

constexpr uint32_t kTables = SHD_TABLE_MIPMAP | SHD_TABLE_RIPMAP | SHD_TABLE_SUMMED_AREA;

Batch t_batch, t_copied;
float t_gradient[2][2][4][kMaxPoints];  // copied and borrowed; du and dv

/// Memory whose last bytes, except SHD_TEXTURE_PADDING, end before a page that faults.
struct Guarded {
  uint8_t* pages;
  size_t mapped;
  uint8_t* texels;
};

Guarded make_guarded(size_t size) {
  const auto page = static_cast<size_t>(sysconf(_SC_PAGESIZE));
  const size_t used = (size + SHD_TEXTURE_PADDING + page - 1) / page * page;
  void* pages = mmap(nullptr, used + page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  assert_true(pages != MAP_FAILED);
  auto* bytes = static_cast<uint8_t*>(pages);
  assert_int_equal(mprotect(bytes + used, page, PROT_NONE), 0);
  memset(bytes, 0x5a, used);
  return {bytes, used + page, bytes + used - SHD_TEXTURE_PADDING - size};
}
void free_guarded(const Guarded& guarded) {
  munmap(guarded.pages, guarded.mapped);
}

Texture* build_texture(shd_format format, uint32_t width, uint32_t height, const uint8_t* texels, uint32_t borrow) {
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = format;
  desc.width = width;
  desc.height = height;
  desc.texels = texels;
  desc.tables = kTables;
  desc.flags = borrow ? SHD_TEXTURE_BORROW : SHD_TEXTURE_NONE;
  auto* texture = shd::core::create<Texture>(context()->allocator);
  shd::texture::build(*context(), desc, texture);
  return texture;
}

/// Points that read, in one vector, the last texels of the base, of the caller's levels and of levels made by shd.
void make_corner_points() {
  make_points(&t_batch);
  for (size_t i = 64; i < 96; ++i) {
    t_batch.u[i] = 1.0f - 1e-6f * static_cast<float>(i % 4);
    t_batch.v[i] = 1.0f - 1e-6f * static_cast<float>(i % 3);
    t_batch.lod[i] = i % 2 ? 0.0f : static_cast<float>(i % 5) * 0.5f;
    if (i % 2) t_batch.dudx[i] = t_batch.dvdx[i] = t_batch.dudy[i] = t_batch.dvdy[i] = 0;
  }
}

void check_sampler(const Texture& copied, const Texture& borrowed, const shd_sampler_desc& desc, bool lod) {
  const Sampler sampler = make_sampler(desc);
  const Lookups lookups = t_batch.lookups(!lod, lod);
  for_each_target([&](int64_t target) {
    run(copied, sampler, target, lookups, &t_batch);
    memcpy(t_copied.out, t_batch.out, sizeof t_batch.out);
    run(borrowed, sampler, target, lookups, &t_batch);
    if (memcmp(t_copied.out, t_batch.out, sizeof t_batch.out) != 0) {
      fail_msg("filter %d format %d wraps %d %d lod %d", desc.filter, copied.format, desc.wrap_u, desc.wrap_v, lod);
    }
    if (!shd::texture::has_gradient(desc.filter)) return;
    run_gradient(copied, sampler, target, lookups, t_gradient[0]);
    run_gradient(borrowed, sampler, target, lookups, t_gradient[1]);
    assert_memory_equal(t_gradient[0], t_gradient[1], sizeof t_gradient[0]);
  });
}

/// Runs with and without a border, and with several wraps.
void check_filter(const Texture& copied, const Texture& borrowed, shd_sampler_desc desc) {
  desc.cubic = desc.filter == SHD_FILTER_STOCHASTIC ? SHD_CUBIC_B_SPLINE : SHD_CUBIC_CATMULL_ROM;
  const shd_wrap pairs[][2] = {
      {SHD_WRAP_REPEAT, SHD_WRAP_REPEAT}, {SHD_WRAP_CLAMP, SHD_WRAP_MIRROR}, {SHD_WRAP_BORDER, SHD_WRAP_CLAMP}};
  // The exact filter is slow, and does not fetch with kernels.
  const size_t count = desc.filter == SHD_FILTER_EXACT ? 1 : 3;
  for (size_t k = 0; k < count; ++k) {
    desc.wrap_u = pairs[k][0];
    desc.wrap_v = pairs[k][1];
    check_sampler(copied, borrowed, desc, false);
    if (k == 0 && desc.filter != SHD_FILTER_EXACT) check_sampler(copied, borrowed, desc, true);
  }
}

void test_filters(void** state) {
  const auto& c = *static_cast<const size_case*>(*state);
  make_corner_points();
  for (const shd_format format : kFormats) {
    const size_t count = size_t{c.width} * c.height, size = count * shd_format_size(format);
    const Guarded guarded = make_guarded(size);
    random_texels(format, count, c.width * 31 + c.height, guarded.texels);
    Texture* copied = build_texture(format, c.width, c.height, guarded.texels, 0);
    Texture* borrowed = build_texture(format, c.width, c.height, guarded.texels, 1);
    assert_int_equal(shd::texture::byte_size(*copied) - shd::texture::byte_size(*borrowed), size);
    for (uint32_t filter = SHD_FILTER_TRILINEAR; filter <= SHD_FILTER_EXACT; ++filter) {
      shd_sampler_desc desc = shd_sampler_desc_default();
      desc.filter = static_cast<shd_filter>(filter);
      if (filter == SHD_FILTER_STOCHASTIC) {
        for (const shd_filter stochastic_filter :
             {SHD_FILTER_BILINEAR, SHD_FILTER_BICUBIC, SHD_FILTER_ANISOTROPIC, SHD_FILTER_EWA}) {
          desc.stochastic_filter = stochastic_filter;
          check_filter(*copied, *borrowed, desc);
        }
        desc.stochastic_filter = SHD_FILTER_TRILINEAR;
      }
      check_filter(*copied, *borrowed, desc);
    }
    free_texture(copied);
    free_texture(borrowed);
    free_guarded(guarded);
  }
}

/// Texels are changed in place, followed by an update of their rectangle.
void test_update(void** state) {
  const auto& c = *static_cast<const size_case*>(*state);
  for (const shd_format format : kFormats) {
    const size_t count = size_t{c.width} * c.height, texel = shd_format_size(format);
    const Guarded guarded = make_guarded(count * texel);
    random_texels(format, count, 3, guarded.texels);
    Texture* borrowed = build_texture(format, c.width, c.height, guarded.texels, 1);
    shd_image image = shd_image_default();
    image.format = format;
    for (uint32_t k = 0; k < 3; ++k) {
      const uint32_t x = k * c.width / 3, y = k * c.height / 4;
      image.width = (c.width - x + 1) / 2;
      image.height = (c.height - y + 1) / 2;
      for (uint32_t j = 0; j < image.height; ++j) {
        random_texels(format, image.width, 100 * k + j, guarded.texels + (size_t{y + j} * c.width + x) * texel);
      }
      shd::texture::update(*context(), 0, x, y, image, borrowed);
    }
    Texture* want = build_texture(format, c.width, c.height, guarded.texels, 1);
    assert_int_equal(borrowed->texels.size(), want->texels.size());
    assert_memory_equal(borrowed->texels.data(), want->texels.data(), want->texels.size());
    free_texture(want);
    free_texture(borrowed);
    free_guarded(guarded);
  }
}

/// Every texel has its address in the caller's memory if it is borrowed, and otherwise in the texture's memory. Kernels
/// and prefetches take addresses from TexelSource.
void test_addresses(void**) {
  for (const shd_format format : kFormats) {
    const size_t size = shd_format_size(format) * 5 * 3;
    const Guarded guarded = make_guarded(size);
    random_texels(format, 15, 7, guarded.texels);
    for (uint32_t borrow : {0u, 1u}) {
      Texture* texture = build_texture(format, 5, 3, guarded.texels, borrow);
      const shd::texture::TexelSource source(*texture);
      const size_t own = texture->texels.size() / source.texel_size;
      const uint32_t base = borrow ? 15 : 0;
      assert_int_equal(source.borrowed_texels, base);
      for (uint32_t i = 0; i < base + own; ++i) {
        const uint8_t* first = i < base ? guarded.texels : texture->texels.data();
        assert_ptr_equal(source.texel(i), first + size_t{i < base ? i : i - base} * source.texel_size);
        assert_ptr_equal(source.texel(i), shd::texture::texel_at(*texture, i));
      }
      free_texture(texture);
    }
    free_guarded(guarded);
  }
}

}  // namespace

int main() {
  static char names[2][16][32];
  CMUnitTest tests[32];
  size_t n = 0, i = 0;
  for (const size_case& c : k_sizes) {
    snprintf(names[0][i], sizeof names[0][i], "filters/%s", c.name);
    snprintf(names[1][i], sizeof names[1][i], "update/%s", c.name);
    tests[n++] = {names[0][i], test_filters, nullptr, nullptr, const_cast<size_case*>(&c)};
    tests[n++] = {names[1][i++], test_update, nullptr, nullptr, const_cast<size_case*>(&c)};
  }
  tests[n++] = {"addresses", test_addresses, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.texture.borrowed", tests, n, nullptr, nullptr);
}
