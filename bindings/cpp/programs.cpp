// SPDX-License-Identifier: MIT
// The three programs that every binding has, as bindings/c/programs.c: a batch of lookups, a frame, and a fragment
// program. Each prints a hash of its result.
//
//   programs            prints the hashes
//   programs --speed    prints the time of a call of one lookup, and of a batch of 2^20
#include <algorithm>
#include <array>
#include <chrono>
#include <cinttypes>
#include <cstdio>
#include <limits>
#include <shd.hpp>
#include <string_view>
#include <vector>

namespace {

constexpr int kSize = 64, kCount = 16384, kBatch = 1 << 20, kCalls = 200000;
constexpr std::uint32_t kWidth = 320, kHeight = 200;

// FNV-1a of 64 bits (Fowler, Noll and Vo, 1991), byte by byte.
class hash {
 public:
  void add(const void* bytes, std::size_t count) {
    const auto* byte = static_cast<const std::uint8_t*>(bytes);
    for (std::size_t i = 0; i < count; ++i) value_ = (value_ ^ byte[i]) * 0x100000001b3;
  }
  void print(const char* name) const { std::printf("%s %016" PRIx64 "\n", name, value_); }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

shd::texture create_texture(shd_context* context) {
  std::vector<std::uint8_t> texels;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      for (const int value : {x * 4, y * 4, (x ^ y) * 4, 255}) texels.push_back(static_cast<std::uint8_t>(value));
    }
  }
  shd::texture_desc desc;
  desc.width = desc.height = kSize;
  desc.format = SHD_FORMAT_RGBA8_SRGB;
  desc.texels = texels.data();
  desc.tables = SHD_TABLE_MIPMAP;
  return shd::texture_create(context, &desc);
}

shd::sampler create_sampler(shd_context* context, shd_filter filter) {
  shd::sampler_desc desc;
  desc.filter = filter;
  desc.max_anisotropy = 16.0f;
  return shd::sampler_create(context, &desc);
}

// 1. A batch of lookups: footprints of many sizes and directions, filtered with EWA.
struct footprint {
  float u, v, dudx, dvdx, dudy, dvdy;
};

void look_up(shd_context* context) {
  std::vector<footprint> rows;
  for (int i = 0; i < kCount; ++i) {
    rows.push_back({static_cast<float>(i % 128) / 64.0f, static_cast<float>(i / 128) / 128.0f,
                    static_cast<float>(1 + i % 7) / 256.0f, static_cast<float>(i % 5) / 512.0f,
                    static_cast<float>(i % 3) / -512.0f, static_cast<float>(1 + i % 11) / 1024.0f});
  }
  const shd::texture texture = create_texture(context);
  const shd::sampler sampler = create_sampler(context, SHD_FILTER_EWA);
  shd::lookups lookups;
  lookups.count = rows.size();
  lookups.u = shd::in(rows, &footprint::u), lookups.v = shd::in(rows, &footprint::v);
  lookups.dudx = shd::in(rows, &footprint::dudx), lookups.dvdx = shd::in(rows, &footprint::dvdx);
  lookups.dudy = shd::in(rows, &footprint::dudy), lookups.dvdy = shd::in(rows, &footprint::dvdy);
  std::array<std::vector<float>, 4> out;
  shd::texels texels;
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i].resize(rows.size());
    texels.channel[i] = shd::out(out[i]);
  }
  shd::texture_sample(texture, sampler, &lookups, &texels);
  hash result;
  for (const std::vector<float>& channel : out) result.add(channel.data(), channel.size() * sizeof(float));
  result.print("lookup");
}

// Renders a torus of one material in the light of the sun, with four samples a pixel, and prints the hash of its pixels
// as RGBA8 in sRGB.
void draw(shd_context* context, const char* name, const shd_material_desc& material_desc) {
  shd::shape_desc torus;
  torus.kind = SHD_SHAPE_TORUS;
  const shd::mesh mesh = shd::mesh_create_shape(context, &torus, 0);
  const shd::material material = shd::material_create(context, &material_desc);
  shd::light_desc sun_desc;
  sun_desc.kind = SHD_LIGHT_KIND_DIRECTIONAL;
  sun_desc.direction[0] = -0.5f, sun_desc.direction[1] = -1.0f, sun_desc.direction[2] = -0.25f;
  const shd::light sun = shd::light_create(context, &sun_desc);
  shd::framebuffer_desc size;
  size.width = kWidth, size.height = kHeight, size.sample_count = 4;
  const shd::framebuffer framebuffer = shd::framebuffer_create(context, &size);

  shd::camera camera;
  camera.eye[0] = 0.5f, camera.eye[1] = 1.5f, camera.eye[2] = 2.0f;
  shd::draw one;
  one.mesh = mesh, one.material = material;
  const shd_light* const lights[] = {sun};
  shd::render_desc frame;
  frame.framebuffer = framebuffer;
  frame.draws = &one, frame.draw_count = 1;
  frame.lights = lights, frame.light_count = 1;
  frame.camera = &camera;
  shd::render(context, &frame);

  std::vector<std::uint8_t> pixels(std::size_t{kWidth} * kHeight * 4);
  shd::image image;
  image.width = kWidth, image.height = kHeight;
  image.format = SHD_FORMAT_RGBA8_SRGB;
  image.pixels = pixels.data();
  shd::framebuffer_read_color(framebuffer, &image);
  hash result;
  result.add(pixels.data(), pixels.size());
  result.print(name);
}

// 2. A frame: the material has a texture.
void draw_textured(shd_context* context) {
  const shd::texture texture = create_texture(context);
  const shd::sampler sampler = create_sampler(context, SHD_FILTER_TRILINEAR);
  const shd_slot slot = shd_slot_texture(SHD_SLOT_DIFFUSE, texture, sampler);
  shd::material_desc desc;
  desc.model = SHD_MODEL_BLINN_PHONG;
  desc.slots = &slot, desc.slot_count = 1;
  draw(context, "frame", desc);
}

// 3. A fragment program: shows the texture coordinates.
void uv_as_colour(const shd_fragments* in, shd_radiance* out, void* user_data) {
  std::copy_n(in->u, in->count, out->r);
  std::copy_n(in->v, in->count, out->g);
  std::fill_n(out->b, in->count, *static_cast<const float*>(user_data));
}

void draw_program(shd_context* context) {
  float blue = 0.25f;
  shd::material_desc desc;
  desc.model = SHD_MODEL_PROGRAM;
  desc.program.fragment = uv_as_colour;
  desc.program.user_data = &blue;
  draw(context, "program", desc);
}

// Seconds of `calls` calls, the best of seven.
double measure(const shd_texture* texture, const shd_sampler* sampler, const shd_lookups& lookups, shd_texels& texels,
               int calls) {
  using clock = std::chrono::steady_clock;
  double best = std::numeric_limits<double>::infinity();
  for (int trial = 0; trial < 7; ++trial) {
    const clock::time_point start = clock::now();
    for (int i = 0; i < calls; ++i) shd::texture_sample(texture, sampler, &lookups, &texels);
    best = std::min(best, std::chrono::duration<double>(clock::now() - start).count());
  }
  return best;
}

void print_speed() {
  shd::context_desc desc;
  desc.worker_count = 1;
  const shd::context context = shd::context_create(&desc);
  const shd::texture texture = create_texture(context);
  const shd::sampler sampler = create_sampler(context, SHD_FILTER_TRILINEAR);
  std::vector<float> u(kBatch), v(kBatch), lod(kBatch);
  for (int i = 0; i < kBatch; ++i) {
    const auto row = static_cast<std::size_t>(i);
    u[row] = static_cast<float>(i % 1024) / 1024.0f;
    v[row] = static_cast<float>(i / 1024) / 1024.0f;
    lod[row] = static_cast<float>(i % 16) / 8.0f;
  }
  std::array<std::vector<float>, 4> out;
  shd::lookups lookups;
  shd::texels texels;
  lookups.u = shd::in(u), lookups.v = shd::in(v), lookups.lod = shd::in(lod);
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i].resize(kBatch);
    texels.channel[i] = shd::out(out[i]);
  }
  lookups.count = 1;
  std::printf("call %.2f ns\n", 1e9 * measure(texture, sampler, lookups, texels, kCalls) / kCalls);
  lookups.count = kBatch;
  std::printf("batch %.4f ms\n", 1e3 * measure(texture, sampler, lookups, texels, 3) / 3);
}

}  // namespace

int main(int count, char** arguments) {
  try {
    if (count > 1 && std::string_view(arguments[1]) == "--speed") {
      print_speed();
      return 0;
    }
    const shd::context context = shd::context_create(nullptr);
    look_up(context);
    draw_textured(context);
    draw_program(context);
    return 0;
  } catch (const shd::error& failure) {
    std::fprintf(stderr, "programs: %s\n", failure.what());
    return 1;
  }
}
