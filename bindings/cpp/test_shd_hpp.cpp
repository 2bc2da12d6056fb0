// SPDX-License-Identifier: MIT
// Owners release what they own, also when a call throws: a counting allocator must end at 0.
#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <shd.hpp>
#include <stdexcept>
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

constexpr std::uint32_t kWidth = 100, kHeight = 70;

/// Writes the texel (31 x + 17 y) mod 256 at (x, y).
struct Load {
  int* calls;
  bool* fails;
  std::shared_ptr<int> kept;
  void operator()(shd::span<const shd_tile> tiles) const {
    ++*calls;
    if (*fails) throw std::runtime_error("no tile");
    for (const shd_tile& tile : tiles) {
      for (std::uint32_t y = 0; y < tile.height; ++y) {
        auto* row = static_cast<std::uint8_t*>(tile.texels) + y * tile.row_stride;
        for (std::uint32_t x = 0; x < tile.width; ++x) row[x] = texel(tile.x + x, tile.y + y);
      }
    }
  }
  static std::uint8_t texel(std::uint32_t x, std::uint32_t y) { return static_cast<std::uint8_t>(31 * x + 17 * y); }
};

std::array<float, 200> look_up(const shd::context& context, const shd::texture& texture) {
  std::array<float, 200> u, v, out = {};
  for (std::size_t i = 0; i < u.size(); ++i) {
    u[i] = static_cast<float>(i * 37 % 200) / 200;
    v[i] = static_cast<float>(i * 91 % 200) / 200;
  }
  shd_lookups lookups = shd_lookups_default();
  shd_texels texels = shd_texels_default();
  lookups.count = u.size();
  lookups.u = shd::in(u), lookups.v = shd::in(v);
  texels.channel[0] = shd::out(out);
  const shd::sampler sampler = shd::sampler_create(context, nullptr);
  shd::texture_sample(texture, sampler, &lookups, &texels);
  return out;
}

/// Tiles that a function object writes: its bits, its exception, and when it is destroyed.
void test_tiles() {
  int calls = 0;
  bool fails = false;
  const auto kept = std::make_shared<int>(1);
  const shd::context context = shd::context_create(nullptr);
  shd_tile_cache_desc cache_desc = shd_tile_cache_desc_default();
  cache_desc.tile_bytes = 1024, cache_desc.budget_bytes = 1 << 20;
  const shd::tile_cache cache = shd::tile_cache_create(context, &cache_desc);
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = SHD_FORMAT_R8;
  desc.width = kWidth, desc.height = kHeight;
  std::vector<std::uint8_t> texels(kWidth * kHeight);
  for (std::uint32_t i = 0; i < texels.size(); ++i) texels[i] = Load::texel(i % kWidth, i / kWidth);
  desc.texels = texels.data();
  const shd::texture memory = shd::texture_create(context, &desc);
  desc.texels = nullptr;
  shd::texture texture = shd::texture_create(context, &desc, cache, Load{&calls, &fails, kept});
  expect(kept.use_count() == 2, "tiles/one copy of the function");
  fails = true;
  bool thrown = false;
  try {
    look_up(context, texture);
  } catch (const shd::error& failure) {
    thrown = failure.result() == SHD_ERROR_CALLBACK && std::strstr(failure.what(), "no tile");
  }
  expect(thrown, "tiles/exception");
  fails = false;
  expect(look_up(context, texture) == look_up(context, memory), "tiles/bits");
  const shd_tile_cache_stats stats = shd::tile_cache_get_stats(cache);
  expect(stats.loads == static_cast<std::uint64_t>(calls) && stats.failed_tiles > 0, "tiles/loads");
  texture.reset();
  expect(kept.use_count() == 1, "tiles/released");
  desc.depth = 2;
  thrown = false;
  try {
    texture = shd::texture_create(context, &desc, cache, Load{&calls, &fails, kept});
  } catch (const shd::error&) {
    thrown = true;
  }
  expect(thrown && kept.use_count() == 1, "tiles/refused");
}

#ifdef SHD_TEST_TILED_FILE
void test_tiled_file() {
  const shd::context context = shd::context_create(nullptr);
  const shd::tile_cache cache = shd::tile_cache_create(context, nullptr);
  shd_tile_file_desc desc = shd_tile_file_desc_default();
  desc.cache = cache;
  desc.color_space = SHD_COLOR_ENCODING_LINEAR;
  shd_tile_file_info info = shd_tile_file_info_default();
  const shd::texture file = shd::texture_open(context, SHD_TEST_TILED_FILE, &desc, &info);
  expect(info.files == 1 && info.tile_width == 16, "file/info");
  std::array<std::uint8_t, 256> texels;
  for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<std::uint8_t>(i);
  shd_texture_desc memory = shd_texture_desc_default();
  memory.format = SHD_FORMAT_R8;
  memory.width = memory.height = 16;
  memory.texels = texels.data();
  const shd::texture copy = shd::texture_create(context, &memory);
  expect(look_up(context, file) == look_up(context, copy), "file/bits");
  shd::texture missing;
  expect(shd::texture_open(context, "nothing.tif", &desc, missing, nullptr) == SHD_ERROR_NOT_FOUND && !missing,
         "file/not found");
}
#endif

}  // namespace

int main() {
  test_blocks();
  test_tiles();
#ifdef SHD_TEST_TILED_FILE
  test_tiled_file();
#endif
  test_ownership();
  test_errors();
  test_columns();
  std::printf("shd.hpp: %d failures\n", g_failures);
  return g_failures ? EXIT_FAILURE : EXIT_SUCCESS;
}
