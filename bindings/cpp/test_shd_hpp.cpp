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
#include <string>
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

void* allocate(std::size_t size, std::size_t alignment, void* user_data) {
  Counter& counter = *static_cast<Counter*>(user_data);
  ++counter.live, ++counter.total;
  return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}

void release(void* memory, std::size_t, std::size_t, void* user_data) {
  --static_cast<Counter*>(user_data)->live;
  std::free(memory);
}

shd::context counted(Counter& counter) {
  shd::context_desc desc;
  desc.worker_count = 1;
  desc.allocator = {allocate, release, &counter};
  return shd::context_create(&desc);
}

shd::texture checker(shd_context* context) {
  const std::array<float, 4> texels = {0, 1, 1, 0};
  shd::texture_desc desc;
  desc.format = SHD_FORMAT_R32F;
  desc.width = desc.height = 2;
  desc.texels = texels.data();
  return shd::texture_create(context, &desc);
}

/// Structs have the bytes of C's, start with the defaults, and take a struct of C.
void test_structs() {
  static_assert(sizeof(shd::texture_desc) == sizeof(shd_texture_desc));
  const shd::sampler_desc made;
  const shd_sampler_desc wanted = shd_sampler_desc_default();
  expect(made.struct_size == sizeof wanted && made.filter == wanted.filter, "structs/defaults");
  expect(made.max_anisotropy == wanted.max_anisotropy, "structs/defaults of numbers");
  shd::slot slot = shd_slot_vertex(SHD_SLOT_DIFFUSE, 2);
  expect(slot.target == SHD_SLOT_DIFFUSE, "structs/from a struct of C");
  slot = shd_slot_default();
  expect(slot.target == shd_slot_default().target, "structs/assigned");
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
    shd::sampler_desc desc;
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
  std::vector<float> numbers = {1.0f, 2.0f};
  expect(shd::in(shd::span<float>(numbers)).data == numbers.data(), "column/temporary span");
  expect(shd::in(std::as_const(numbers)).data == numbers.data(), "column/constant");
  expect(shd::out(shd::span<float>(numbers)).data == numbers.data(), "column/temporary span of results");

  Counter counter;
  {
    const shd::context context = counted(counter);
    const shd::texture texture = checker(context);
    shd::lookups lookups;
    shd::texels texels;
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
  shd::texture_desc desc;
  desc.format = SHD_FORMAT_BC1_RGB;
  desc.width = desc.height = 4;
  desc.texels = bc1;
  const shd::texture first = shd::texture_create(context, &desc);
  shd::image level;
  level.format = desc.format = SHD_FORMAT_BC7;
  level.width = level.height = 2;
  desc.texels = level.pixels = bc7;
  desc.tables = SHD_TABLE_MIPMAP;
  desc.level_images = &level;
  desc.level_count = 1;
  const shd::texture second = shd::texture_create(context, &desc);
  const float u = 0.375f, v = 0.125f;
  float blue = 0.0f, green = 0.0f;
  shd::lookups lookups;
  shd::texels texels;
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
      for (std::uint32_t y = 0; y < tile.area.height; ++y) {
        auto* row = static_cast<std::uint8_t*>(tile.texels) + y * tile.row_stride;
        for (std::uint32_t x = 0; x < tile.area.width; ++x) row[x] = texel(tile.area.x + x, tile.area.y + y);
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
  shd::lookups lookups;
  shd::texels texels;
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
  shd::tile_cache_desc cache_desc;
  cache_desc.tile_bytes = 1024, cache_desc.budget_bytes = 1 << 20;
  const shd::tile_cache cache = shd::tile_cache_create(context, &cache_desc);
  shd::texture_desc desc;
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
  expect(stats.load_count == static_cast<std::uint64_t>(calls) && stats.failed_tile_count > 0, "tiles/loads");
  texture.reset();
  expect(kept.use_count() == 1, "tiles/released");
  desc.layer_count = 0;
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
  shd::tile_file_desc desc;
  desc.cache = cache;
  desc.encoding = SHD_COLOR_ENCODING_LINEAR;
  shd::tile_file_info info;
  const shd::texture file = shd::texture_open(context, SHD_TEST_TILED_FILE, &desc, &info);
  expect(info.file_count == 1 && info.tile_width == 16, "file/info");
  std::array<std::uint8_t, 256> texels;
  for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<std::uint8_t>(i);
  shd::texture_desc memory;
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

#ifdef SHD_TEST_SCENE
/// A triangle whose buffer is the file a.bin, with an animation to x = 4 in 2 s, and a texture that no file has.
constexpr char kModel[] = R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
  "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
  "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
  "textures": [{"source": 0}], "images": [{"uri": "none.png"}], "buffers": [{"uri": "a.bin", "byteLength": 68}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 8},
                  {"buffer": 0, "byteOffset": 44, "byteLength": 24}],
  "accessors": [
    {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
    {"bufferView": 1, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0], "max": [2]},
    {"bufferView": 2, "componentType": 5126, "count": 2, "type": "VEC3"}],
  "animations": [{"name": "Move", "samplers": [{"input": 1, "output": 2}],
                  "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}]})";
constexpr float kBuffer[17] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 4, 0, 0};

void test_scene() {
  const shd::context context = shd::context_create(nullptr);
  const shd::span<const unsigned char> model(reinterpret_cast<const unsigned char*>(kModel), sizeof kModel - 1);
  const shd::span<const unsigned char> buffer(reinterpret_cast<const unsigned char*>(kBuffer), sizeof kBuffer);
  shd::scene_desc desc;
  for (const shd_scene_flags flags : {SHD_SCENE_NONE, SHD_SCENE_IN_PROCESS}) {
    desc.flags = flags;
    const shd::scene scene = shd::scene_load_memory(context, model, nullptr, &desc, [&](const char* name) {
      return std::strcmp(name, "a.bin") == 0 ? buffer : shd::span<const unsigned char>();
    });
    const shd_scene_info info = shd::scene_get_info(scene);
    expect(info.triangle_count == 1 && info.animation_count == 1, "scene/info");
    bool warned = false;
    for (std::uint32_t i = 0; i < info.warning_count; ++i) {
      warned = warned || std::strstr(shd_scene_get_warning(scene, i), "none.png");
    }
    expect(warned, "scene/warning");
    double first = -1, last = -1;
    shd::scene_get_animation_times(scene, 0, &first, &last);
    const shd::scene pose = shd::scene_pose(scene, 0, 0.5 * (first + last));
    expect(shd::scene_get_instance(pose, 0).object_to_world[12] == 2.0f, "scene/pose");
    std::string problem;
    try {
      shd::scene_load_memory(context, model, nullptr, &desc,
                             [](const char* name) -> shd::span<const unsigned char> { throw std::out_of_range(name); });
    } catch (const std::out_of_range& thrown) {
      problem = thrown.what();
    }
    expect(problem == "a.bin", "scene/exception of the function");
    bool refused = false;
    try {
      shd::scene_load_memory(context, model.data(), model.size(), nullptr, &desc);
    } catch (const shd::error& failure) {
      refused = std::strstr(failure.what(), "a.bin") != nullptr;
    }
    expect(refused, "scene/no files");
  }
}

/// A texture of the bytes of a DDS file of 2 x 2 texels RGBA8.
void test_texture_memory() {
  const shd::context context = shd::context_create(nullptr);
  std::array<std::uint32_t, 36> file = {0x20534444, 124, 0x1007, 2, 2};
  file[19] = 32, file[20] = 0x41, file[22] = 32, file[27] = 0x1000;
  file[23] = 0xff, file[24] = 0xff00, file[25] = 0xff0000, file[26] = 0xff000000;
  for (std::uint32_t i = 32; i < 36; ++i) file[i] = 0xff000000 + i;
  shd::texture_file_info info;
  shd::load_desc desc;
  desc.info = &info;
  const shd::texture texture = shd::texture_load_memory(context, file.data(), sizeof file, &desc);
  expect(info.kind == SHD_TEXTURE_FILE_KIND_DDS && info.level_count == 1, "texture/info");
  std::array<std::uint32_t, 4> texels = {};
  shd::image image;
  image.format = shd::texture_get_info(texture).format;
  image.width = image.height = 2;
  image.pixels = texels.data();
  shd::texture_read_level(texture, 0, 0, &image);
  expect(std::memcmp(texels.data(), file.data() + 32, sizeof texels) == 0, "texture/texels");
}
#endif

}  // namespace

int main() {
  test_blocks();
  test_tiles();
#ifdef SHD_TEST_TILED_FILE
  test_tiled_file();
#endif
#ifdef SHD_TEST_SCENE
  test_scene();
  test_texture_memory();
#endif
  test_structs();
  test_ownership();
  test_errors();
  test_columns();
  std::printf("shd.hpp: %d failures\n", g_failures);
  return g_failures ? EXIT_FAILURE : EXIT_SUCCESS;
}
