// SPDX-License-Identifier: MIT
// Owners release what they own, also when a call throws: a counting allocator must end at 0.
#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <shd.hpp>
#include <vector>

namespace {

int g_failures = 0;

void expect(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "failed: %s\n", what);
  ++g_failures;
}

struct Counter {
  std::atomic<long> live{0}, total{0};
};

void* allocate(void* user_data, std::size_t size, std::size_t alignment) {
  Counter& counter = *static_cast<Counter*>(user_data);
  ++counter.live, ++counter.total;
  return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}

void release(void* user_data, void* memory, std::size_t, std::size_t) {
  --static_cast<Counter*>(user_data)->live;
  std::free(memory);
}

shd::context counted(Counter& counter) {
  shd_context_desc desc = shd_context_desc_default();
  desc.worker_count = 1;
  desc.allocator = {allocate, release, &counter};
  return shd::context_create(&desc);
}

shd::texture checker(shd_context* context) {
  const std::array<float, 4> texels = {0, 1, 1, 0};
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = SHD_FORMAT_R32F;
  desc.width = desc.height = 2;
  desc.texels = texels.data();
  return shd::texture_create(context, &desc);
}

void test_ownership() {
  Counter counter;
  {
    const shd::context context = counted(counter);
    shd::texture first = checker(context);
    shd::texture second = std::move(first);
    expect(!first && second, "move/construct");
    first = std::move(second);
    expect(first && !second, "move/assign");
    shd::texture& self = first;
    first = std::move(self);
    expect(static_cast<bool>(first), "move/self");
    const shd::texture shared = first.share();
    first.reset();
    expect(shd::texture_get_info(shared).width == 2, "share/lives on");
    const shd::texture retained = shd::retain<shd::texture>(shared.get());
    expect(retained.get() == shared.get(), "retain/same object");
    shd_texture* raw = checker(context).detach();
    shd_texture_release(raw);
  }
  expect(counter.total > 0 && counter.live == 0, "ownership/no leak");
  static_assert(!std::is_copy_constructible_v<shd::texture> && !std::is_copy_assignable_v<shd::texture>);
  static_assert(std::is_nothrow_move_constructible_v<shd::texture> && std::is_nothrow_move_assignable_v<shd::texture>);
  static_assert(std::is_convertible_v<shd::texture&, const shd_texture*>);
  static_assert(!std::is_convertible_v<shd::texture, shd_texture*>, "a temporary would release its object at once");
}

void test_errors() {
  Counter counter;
  {
    const shd::context context = counted(counter);
    const shd::texture kept = checker(context);
    shd_sampler_desc desc = shd_sampler_desc_default();
    desc.max_anisotropy = -1.0f;
    bool thrown = false;
    try {
      const shd::sampler sampler = shd::sampler_create(context, &desc);
    } catch (const shd::error& failure) {
      thrown = failure.result() == SHD_ERROR_INVALID_ARGUMENT && std::strstr(failure.what(), "max_anisotropy");
    }
    expect(thrown, "error/message");
    shd::sampler sampler = shd::sampler_create(context, nullptr);
    expect(shd::sampler_create(context, &desc, sampler) == SHD_ERROR_INVALID_ARGUMENT && !sampler,
           "error/no exception");
    expect(shd::sampler_create(context, nullptr, sampler) == SHD_OK && sampler, "create/no exception");
    shd::texture released = checker(context);
    shd_texture* stale = released.get();
    released.reset();
    thrown = false;
    try {
      shd::texture_get_info(stale);
    } catch (const shd::error& failure) {
      thrown = failure.result() == SHD_ERROR_INVALID_ARGUMENT;
    }
    expect(thrown, "error/use after release");
  }
  expect(counter.total > 0 && counter.live == 0, "errors/no leak");
}

void test_columns() {
  struct Record {
    float u, v;
  };
  std::vector<Record> records = {{0.25f, 0.5f}, {0.75f, 0.5f}};
  const shd_f32_in v = shd::in(records, &Record::v);
  expect(v.data == &records[0].v && v.stride == sizeof(Record), "column/record");
  expect(shd::in(std::vector<Record>(), &Record::u).data == nullptr, "column/empty");
  const std::uint32_t indices[3] = {0, 1, 2};
  expect(shd::in(indices).data == indices && shd::in(indices).stride == 0, "column/array");
  std::array<std::uint16_t, 2> small = {1, 2};
  expect(shd::in(small).data == small.data(), "column/u16");

  Counter counter;
  {
    const shd::context context = counted(counter);
    const shd::texture texture = checker(context);
    shd_lookups lookups = shd_lookups_default();
    shd_texels texels = shd_texels_default();
    std::vector<Record> result(2, Record{-1.0f, -1.0f});
    lookups.count = 2;
    lookups.u = shd::in(records, &Record::u), lookups.v = v;
    texels.channel[0] = shd::out(result, &Record::v);
    const shd::sampler sampler = shd::sampler_create(context, nullptr);
    shd::texture_sample(texture, sampler, &lookups, &texels);
    expect(result[0].v == 0.5f && result[1].v == 0.5f && result[0].u == -1.0f, "column/lookup");
  }
  expect(counter.total > 0 && counter.live == 0, "columns/no leak");
}

/// Compressed blocks: the first row of BC1 is red, blue and colours between them; BC7 is one colour, in mode 6.
void test_blocks() {
  static std::uint8_t bc1[8] = {0x00, 0xf8, 0x1f, 0x00, 0xe4, 0, 0, 0};
  static std::uint8_t bc7[16] = {192, 255, 159, 66, 1, 0, 254, 255, 1, 0, 0, 0, 0, 0, 0, 0};
  const shd::context context = shd::context_create(nullptr);
  const shd::sampler sampler = shd::sampler_create(context, nullptr);
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = SHD_FORMAT_BC1_RGB;
  desc.width = desc.height = 4;
  desc.texels = bc1;
  const shd::texture first = shd::texture_create(context, &desc);
  shd_image level = shd_image_default();
  level.format = desc.format = SHD_FORMAT_BC7;
  level.width = level.height = 2;
  desc.texels = level.pixels = bc7;
  desc.tables = SHD_TABLE_MIPMAP;
  desc.levels = &level;
  desc.level_count = 1;
  const shd::texture second = shd::texture_create(context, &desc);
  const float u = 0.375f, v = 0.125f;
  float blue = 0.0f, green = 0.0f;
  shd_lookups lookups = shd_lookups_default();
  shd_texels texels = shd_texels_default();
  lookups.count = 1;
  lookups.u.data = &u, lookups.v.data = &v;
  texels.channel[2].data = &blue;
  shd::texture_sample(first, sampler, &lookups, &texels);
  texels.channel[2].data = nullptr, texels.channel[1].data = &green;
  shd::texture_sample(second, sampler, &lookups, &texels);
  expect(blue == 1.0f && green == 41.0f / 255.0f, "blocks/lookup");
  level.width = 3;
  bool refused = false;
  try {
    shd::texture_create(context, &desc);
  } catch (const std::exception&) {
    refused = true;
  }
  expect(refused, "blocks/level of another size");
}

}  // namespace

int main() {
  test_blocks();
  test_ownership();
  test_errors();
  test_columns();
  std::printf("shd.hpp: %d failures\n", g_failures);
  return g_failures ? EXIT_FAILURE : EXIT_SUCCESS;
}
