// SPDX-License-Identifier: MIT
// shadow/<filter>/<light>/<target>/<floor or random>/size:<texels>: visibility of 256 Ki points with normals on a floor
// under 400 posts, row by row or at random, from one thread. A map of 256 x 256 texels stays in cache, a map of 4096 x
// 4096 does not. shadow/draw/<light>/size: rendering such a map of 4800 triangles; items are texels.
#include <random>
#include <vector>

#include "bench.h"

namespace shd::bench {
namespace {

constexpr size_t kEdge = 512;
constexpr size_t kPoints = kEdge * kEdge;
constexpr int kPosts = 20;  // a side

struct Filter {
  const char* name;
  shd_shadow_filter filter;
  uint32_t taps;
};
constexpr Filter kFilters[] = {{"hard", SHD_SHADOW_FILTER_HARD, 1},
                               {"pcf_3x3", SHD_SHADOW_FILTER_PCF, 3},
                               {"pcf_7x7", SHD_SHADOW_FILTER_PCF, 7},
                               {"variance", SHD_SHADOW_FILTER_VARIANCE, 5},
                               {"summed_area_variance", SHD_SHADOW_FILTER_SUMMED_AREA_VARIANCE, 1},
                               {"pcss_3x3", SHD_SHADOW_FILTER_PCSS, 3},
                               {"pcss_7x7", SHD_SHADOW_FILTER_PCSS, 7}};
struct Light {
  const char* name;
  shd_light_kind kind;
};
constexpr Light kLights[] = {{"directional", SHD_LIGHT_KIND_DIRECTIONAL}, {"point", SHD_LIGHT_KIND_POINT}};
constexpr uint32_t kSizes[] = {256, 4096};

/// A floor -1..1 and posts on it.
class PostScene {
 public:
  PostScene(shd_simd simd, shd_light_kind kind, const Filter& filter, uint32_t size) : context_(make_context(simd)) {
    add_box(-1.0f, -0.1f, -1.0f, 1.0f, 0.0f, 1.0f);
    for (int i = 0; i < kPosts * kPosts; ++i) {
      const float x = -0.95f + 0.1f * static_cast<float>(i % kPosts),
                  z = -0.95f + 0.1f * static_cast<float>(i / kPosts);
      add_box(x - 0.01f, 0.0f, z - 0.01f, x + 0.01f, 0.02f + 0.003f * static_cast<float>(i % 37), z + 0.01f);
    }
    make_mesh();
    draw_ = shd_draw_default();
    draw_.mesh = mesh_;
    shd_light_desc light = shd_light_desc_default();
    light.kind = kind;
    light.position[1] = 1.5f;
    light.direction[0] = 0.7f;
    light.direction[2] = 0.4f;
    check(shd_light_create(context_, &light, &light_));
    shd_shadow_desc desc = shd_shadow_desc_default();
    desc.size = size;
    desc.filter = filter.filter;
    desc.taps = filter.taps;
    desc.filter_size = 0.01f;
    desc.light_size = 0.1f;
    check(shd_shadow_create(context_, &desc, &shadow_));
    render();
  }
  ~PostScene() {
    shd_shadow_release(shadow_);
    shd_light_release(light_);
    shd_mesh_release(mesh_);
    shd_context_release(context_);
  }
  PostScene(const PostScene&) = delete;
  PostScene& operator=(const PostScene&) = delete;

  void render() const {
    shd_shadow_render_desc desc = shd_shadow_render_desc_default();
    desc.light = light_;
    desc.draws = &draw_;
    desc.draw_count = 1;
    check(shd_shadow_render(context_, shadow_, &desc));
  }
  void sample(const shd_shadow_lookups& lookups, std::vector<float>* out) const {
    shd_shadow_values values = shd_shadow_values_default();
    values.visibility.data = out->data();
    check(shd_shadow_sample(shadow_, &lookups, &values));
  }

 private:
  void add_box(float x0, float y0, float z0, float x1, float y1, float z1) {
    const auto first = static_cast<uint32_t>(x_.size());
    for (int i = 0; i < 8; ++i) {
      x_.push_back(i & 1 ? x1 : x0);
      y_.push_back(i & 2 ? y1 : y0);
      z_.push_back(i & 4 ? z1 : z0);
    }
    for (const uint32_t i :
         {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3}) {
      indices_.push_back(first + i);
    }
  }
  void make_mesh() {
    shd_mesh_desc desc = shd_mesh_desc_default();
    desc.vertex_count = static_cast<uint32_t>(x_.size());
    desc.position[0].data = x_.data();
    desc.position[1].data = y_.data();
    desc.position[2].data = z_.data();
    desc.indices.data = indices_.data();
    desc.index_count = indices_.size();
    check(shd_mesh_create(context_, &desc, &mesh_));
  }

  shd_context* context_;
  std::vector<float> x_, y_, z_;
  std::vector<uint32_t> indices_;
  shd_mesh* mesh_ = nullptr;
  shd_draw draw_;
  shd_light* light_ = nullptr;
  shd_shadow* shadow_ = nullptr;
};

/// Points on the floor.
struct Points {
  std::vector<float> x, y, z, up;
  shd_shadow_lookups lookups = shd_shadow_lookups_default();

  explicit Points(bool is_random) : x(kPoints), y(kPoints, 0.0f), z(kPoints), up(kPoints, 1.0f) {
    std::mt19937 random(1);
    for (size_t i = 0; i < kPoints; ++i) {
      const auto place = [&](size_t step) {
        const double part = is_random ? static_cast<double>(random()) * 0x1p-32 : static_cast<double>(step) / kEdge;
        return static_cast<float>(2.0 * part - 1.0);
      };
      x[i] = place(i % kEdge);
      z[i] = place(i / kEdge);
    }
    lookups.count = kPoints;
    lookups.position[0].data = x.data();
    lookups.position[1].data = y.data();
    lookups.position[2].data = z.data();
    lookups.normal[0].data = lookups.normal[2].data = y.data();
    lookups.normal[1].data = up.data();
  }
};

void run_sample(benchmark::State& state, const Target& target, const Filter& filter, const Light& light, bool is_random,
                uint32_t size) {
  const PostScene scene(target.simd, light.kind, filter, size);
  const Points points(is_random);
  std::vector<float> out(kPoints);
  for (auto _ : state) scene.sample(points.lookups, &out);
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(kPoints));
}

void run_draw(benchmark::State& state, const Target& target, const Filter& filter, const Light& light, uint32_t size) {
  const PostScene scene(target.simd, light.kind, filter, size);
  for (auto _ : state) scene.render();
  const int64_t faces = light.kind == SHD_LIGHT_KIND_POINT ? 6 : 1;
  state.SetItemsProcessed(state.iterations() * faces * size * size);
}

template <class Body>
void add(const std::string& name, Body body) {
  benchmark::RegisterBenchmark(name.c_str(), body)->Unit(benchmark::kMillisecond);
}

}  // namespace

void register_shadow() {
  for (const Target& target : targets()) {
    for (const Filter& filter : kFilters) {
      for (const Light& light : kLights) {
        const std::string name = "shadow/" + std::string(filter.name) + "/" + light.name + "/" + target.name;
        for (const uint32_t size : kSizes) {
          const std::string end = "/size:" + std::to_string(size);
          if (size > 1024 && light.kind == SHD_LIGHT_KIND_POINT) continue;
          for (const bool is_random : {false, true}) {
            add(name + (is_random ? "/random" : "/floor") + end,
                [=](benchmark::State& state) { run_sample(state, target, filter, light, is_random, size); });
          }
        }
      }
    }
    for (const Filter& filter : {kFilters[0], kFilters[3], kFilters[4]}) {
      for (const Light& light : kLights) {
        add("shadow/draw/" + std::string(filter.name) + "/" + light.name + "/" + target.name + "/size:1024",
            [=](benchmark::State& state) { run_draw(state, target, filter, light, 1024); });
      }
    }
  }
}

}  // namespace shd::bench
