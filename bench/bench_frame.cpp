// SPDX-License-Identifier: MIT
// frame/spheres/<triangles>/<target or peer>: 1024 x 1024 pixels, one thread, a mipmapped RGBA8 texture with trilinear
// lookups, two point lights, Blinn-Phong per fragment, back faces culled. Items are triangles.
// frame/<variant>/<triangles>/<target>: the same with several samples, depth alone, or spheres that are half
// transparent; over_spheres is its time by that of the plain frame.
#include <algorithm>
#include <memory>

#include "bench.h"
#include "peers/peers.h"
#include "workload.h"

namespace shd::bench {
namespace {

/// The three frames: 8 x 256, 64 x 1,560 and 1,000 x 1,000 triangles.
const std::vector<Spheres>& frames() {
  static const std::vector<Spheres> all = {make_spheres("2k", 16, 9, 2), make_spheres("100k", 30, 27, 4),
                                           make_spheres("1M", 25, 21, 10)};
  return all;
}

/// How a frame differs from the plain one.
struct Variant {
  const char* name;
  uint32_t samples;
  bool shaded;
  shd_blend_mode blend;
};
constexpr Variant kPlain = {"spheres", 1, true, SHD_BLEND_OPAQUE};
constexpr Variant kVariants[] = {
    {"msaa4", 4, true, SHD_BLEND_OPAQUE},      {"msaa16", 16, true, SHD_BLEND_OPAQUE},
    {"depth", 1, false, SHD_BLEND_OPAQUE},     {"blended", 1, true, SHD_BLEND_PREMULTIPLIED},
    {"weighted", 1, true, SHD_BLEND_WEIGHTED}, {"sorted", 1, true, SHD_BLEND_SORTED}};

std::string row_name(const Spheres& spheres, const std::string& who, const Variant& variant = kPlain) {
  return std::string("frame/") + variant.name + "/" + spheres.name + "/" + who;
}

const std::vector<uint8_t>& texels() {
  static const std::vector<uint8_t> all = make_rgba8(kFrameTextureEdge);
  return all;
}

/// A scene in the library's objects, and its frame.
class Scene {
 public:
  Scene(const Spheres& spheres, shd_simd simd, const Variant& variant = kPlain) : context_(make_context(simd)) {
    make_texture();
    make_mesh(spheres);
    make_material(variant);
    make_lights();
    shd_framebuffer_desc framebuffer = shd_framebuffer_desc_default();
    framebuffer.width = framebuffer.height = kFrameEdge;
    framebuffer.samples = variant.samples;
    check(shd_framebuffer_create(context_, &framebuffer, &framebuffer_));
    for (size_t i = 0; i < spheres.sphere_count(); ++i) {
      shd_draw draw = shd_draw_default();
      draw.mesh = mesh_;
      draw.material = variant.shaded ? material_ : nullptr;
      draw.cull = SHD_CULL_BACK;
      std::copy_n(&spheres.object_to_world[16 * i], 16, draw.object_to_world);
      draws_.push_back(draw);
    }
    desc_.framebuffer = framebuffer_;
    desc_.view = spheres.view;
    desc_.draws = draws_.data();
    desc_.draw_count = draws_.size();
    desc_.lights = lights_;
    desc_.light_count = 2;
    desc_.stats = &stats_;
  }
  ~Scene() {
    shd_framebuffer_release(framebuffer_);
    for (shd_light* light : lights_) shd_light_release(light);
    shd_material_release(material_);
    shd_mesh_release(mesh_);
    shd_texture_release(texture_);
    shd_context_release(context_);
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  void render() { check(shd_render(context_, &desc_)); }
  const shd_render_stats& stats() const { return stats_; }

  std::vector<float> image() const {
    std::vector<float> rgba(kLookupCount * 4);
    shd_image out = shd_image_default();
    out.format = SHD_FORMAT_RGBA32F;
    out.width = out.height = kFrameEdge;
    out.pixels = rgba.data();
    check(shd_framebuffer_read_color(framebuffer_, &out));
    return rgba;
  }

 private:
  void make_texture() {
    shd_texture_desc desc = shd_texture_desc_default();
    desc.format = SHD_FORMAT_RGBA8;
    desc.width = desc.height = kFrameTextureEdge;
    desc.texels = texels().data();
    desc.tables = SHD_TABLE_MIPMAP;
    check(shd_texture_create(context_, &desc, &texture_));
  }
  void make_mesh(const Spheres& spheres) {
    shd_mesh_desc desc = shd_mesh_desc_default();
    desc.vertex_count = static_cast<uint32_t>(spheres.position[0].size());
    for (int k = 0; k < 3; ++k) desc.position[k].data = desc.normal[k].data = spheres.position[k].data();
    for (int k = 0; k < 2; ++k) desc.uv[k].data = spheres.uv[k].data();
    desc.indices.data = spheres.indices.data();
    desc.index_count = spheres.indices.size();
    check(shd_mesh_create(context_, &desc, &mesh_));
  }
  void make_material(const Variant& variant) {
    shd_material_desc desc = shd_material_desc_default();
    desc.blend = variant.blend;
    desc.opacity = 0.5f;
    desc.model = SHD_MODEL_BLINN_PHONG;
    for (int c = 0; c < 3; ++c) {
      desc.ambient[c] = 0.0f;
      desc.diffuse[c] = kDiffuse;
      desc.specular[c] = kSpecular;
    }
    desc.exponent = kExponent;
    desc.diffuse_texture = texture_;
    check(shd_material_create(context_, &desc, &material_));
  }
  void make_lights() {
    for (int i = 0; i < 2; ++i) {
      shd_light_desc desc = shd_light_desc_default();
      std::copy_n(kLights[i].position, 3, desc.position);
      std::copy_n(kLights[i].intensity, 3, desc.intensity);
      check(shd_light_create(context_, &desc, &lights_[i]));
    }
  }

  shd_context* context_;
  shd_texture* texture_ = nullptr;
  shd_mesh* mesh_ = nullptr;
  shd_material* material_ = nullptr;
  shd_light* lights_[2] = {};
  shd_framebuffer* framebuffer_ = nullptr;
  std::vector<shd_draw> draws_;
  shd_render_stats stats_ = {};
  shd_render_desc desc_ = shd_render_desc_default();
};

void finish(benchmark::State& state, const Spheres& spheres) {
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(spheres.triangle_count()));
  state.counters["triangles"] = static_cast<double>(spheres.triangle_count());
}

void run_shd(benchmark::State& state, const Spheres& spheres, const Target& target, const Variant& variant) {
  Scene scene(spheres, target.simd, variant);
  scene.render();
  const Stopwatch watch;
  for (auto _ : state) scene.render();
  const double rate = watch.items_per_second(static_cast<double>(state.iterations()));
  finish(state, spheres);
  state.counters["fragments"] = static_cast<double>(scene.stats().fragments);
  record_rate(row_name(spheres, target.name, variant), rate);
  const double plain = recorded_rate(row_name(spheres, target.name));
  if (variant.name != kPlain.name && plain > 0.0) state.counters["over_spheres"] = plain / rate;
  const double other = recorded_rate(row_name(spheres, "llvmpipe", variant));
  if (other > 0.0) state.counters["ratio_llvmpipe"] = rate / other;
}

#ifdef SHD_BENCH_OSMESA
void run_llvmpipe(benchmark::State& state, const Spheres& spheres) {
  const std::unique_ptr<Peer> peer = make_llvmpipe_spheres(spheres, texels());
  peer->run();
  const Stopwatch watch;
  for (auto _ : state) peer->run();
  record_rate(row_name(spheres, "llvmpipe"), watch.items_per_second(static_cast<double>(state.iterations())));
  finish(state, spheres);
  Scene scene(spheres, SHD_SIMD_BEST);
  scene.render();
  const std::vector<float> ours = scene.image(), theirs = peer->image();
  const Difference difference = compare(ours, theirs);
  state.counters["mean_difference"] = difference.mean;
  state.counters["max_difference"] = difference.max;
  maybe_write("spheres-" + spheres.name + "-llvmpipe", theirs);
  maybe_write("spheres-" + spheres.name + "-shd", ours);
}
#endif

template <class Body>
void add(const std::string& name, Body body) {
  benchmark::RegisterBenchmark(name.c_str(), body)->Unit(benchmark::kMillisecond);
}

}  // namespace

void register_frame_peers() {
#ifdef SHD_BENCH_OSMESA
  for (const Spheres& spheres : frames()) {
    add(row_name(spheres, "llvmpipe"), [&spheres](benchmark::State& state) { run_llvmpipe(state, spheres); });
  }
#endif
}

void register_frame() {
  for (const Spheres& spheres : frames()) {
    for (const Target& target : targets()) {
      add(row_name(spheres, target.name),
          [&spheres, target](benchmark::State& state) { run_shd(state, spheres, target, kPlain); });
    }
    for (const Variant& variant : kVariants) {
      for (const Target& target : targets()) {
        add(row_name(spheres, target.name, variant),
            [&spheres, target, &variant](benchmark::State& state) { run_shd(state, spheres, target, variant); });
      }
    }
  }
}

}  // namespace shd::bench
