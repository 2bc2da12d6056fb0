// SPDX-License-Identifier: MIT
// texture/3d_<filter>/<format>/<target>/<floor or random>/edge:128: one lookup per pixel of a 1024 x 1024 frame, in a
// 3D texture of 128^3 texels. ratio_2d is the rate over that of the same lookups in a 2D texture of 1024 x 2048 texels
// (texture/2d_<filter>/...). The floor is a plane that crosses the slices; random lookups have a footprint of 1.5
// texels.
//
// volume/<scene>/<target>: a head of 256^3 texels on 512 x 512 pixels, in steps of a texel: its surface with lights
// (skin), or as fog (fog), and a cloud.
#include <memory>

#include "../examples/density.h"
#include "texture_setup.h"

namespace shd::bench {
namespace {

constexpr uint32_t kEdge = 128, kVolumeEdge = 256, kFrame = 512;

struct SolidFilter {
  const char* name;
  shd_filter filter;
};
constexpr SolidFilter kSolidFilters[] = {{"nearest", SHD_FILTER_NEAREST},
                                         {"bilinear", SHD_FILTER_BILINEAR},
                                         {"trilinear", SHD_FILTER_TRILINEAR},
                                         {"anisotropic", SHD_FILTER_ANISOTROPIC}};
constexpr Format kSolidFormats[] = {kFormats[0], kFormats[1], kFormats[4]};

std::string row_name(int dimensions, const char* filter, const char* format, const std::string& target,
                     const std::string& pattern) {
  return "texture/" + std::to_string(dimensions) + "d_" + filter + "/" + format + "/" + target + "/" + pattern +
         "/edge:" + std::to_string(kEdge);
}

const Lookups& lookups(const std::string& pattern) {
  static const Lookups floor = floor_lookups(Floor::of_texture(kEdge)), random = random_lookups(kEdge, 1.5f);
  return pattern == "floor" ? floor : random;
}

/// Third coordinates: of a slanted plane, or random, and their derivatives.
struct Depths {
  std::vector<float> w, dwdx, dwdy;

  explicit Depths(const std::string& pattern) {
    const Lookups& q = lookups(pattern);
    uint32_t state = 9;
    for (size_t i = 0; i < q.count(); ++i) {
      state = state * 1664525u + 1013904223u;
      const bool floor = pattern == "floor";
      w.push_back(floor ? 0.4f * (q.u[i] + q.v[i]) : static_cast<float>(state >> 8) * 0x1p-24f);
      dwdx.push_back(floor ? 0.4f * (q.dudx[i] + q.dvdx[i]) : 0.0f);
      dwdy.push_back(floor ? 0.4f * (q.dudy[i] + q.dvdy[i]) : 0.0f);
    }
  }
};
const Depths& depths(const std::string& pattern) {
  static const Depths floor("floor"), random("random");
  return pattern == "floor" ? floor : random;
}

/// A texture of 2^21 texels in three or two dimensions, and a sampler.
struct Objects {
  shd_context* context;
  shd_texture* texture = nullptr;
  shd_sampler* sampler = nullptr;

  Objects(const Target& target, shd_filter filter, const Format& format, int dimensions)
      : context(make_context(target.simd)) {
    std::vector<uint8_t> rgba;
    for (int k = 0; k < 2; ++k) {
      const std::vector<uint8_t> half = make_rgba8(1024);
      rgba.insert(rgba.end(), half.begin(), half.end());
    }
    const std::vector<uint8_t> texels = convert(rgba, format);
    shd_texture_desc desc = shd_texture_desc_default();
    desc.format = format.format;
    desc.width = dimensions == 3 ? kEdge : 1024;
    desc.height = dimensions == 3 ? kEdge : 2048;
    desc.depth = dimensions == 3 ? kEdge : 0;
    if (dimensions == 3) desc.kind = SHD_TEXTURE_KIND_3D;
    desc.texels = texels.data();
    desc.tables = SHD_TABLE_MIPMAP;
    check(shd_texture_create(context, &desc, &texture));
    shd_sampler_desc sampler_desc = shd_sampler_desc_default();
    sampler_desc.filter = filter;
    check(shd_sampler_create(context, &sampler_desc, &sampler));
  }
  ~Objects() {
    shd_texture_release(texture);
    shd_sampler_release(sampler);
    shd_context_release(context);
  }
  Objects(const Objects&) = delete;
  Objects& operator=(const Objects&) = delete;
};

void run_lookups(benchmark::State& state, const Target& target, const SolidFilter& filter, const Format& format,
                 const std::string& pattern, int dimensions) {
  const Objects objects(target, filter.filter, format, dimensions);
  const Lookups& q = lookups(pattern);
  const Depths& deep = depths(pattern);
  shd_lookups columns = shd_lookups_default();
  columns.count = q.count();
  columns.u.data = q.u.data();
  columns.v.data = q.v.data();
  columns.w.data = deep.w.data();
  if (filter.filter == SHD_FILTER_TRILINEAR || filter.filter == SHD_FILTER_ANISOTROPIC) {
    // In 2D, the texels of a pixel are as many as in 3D.
    columns.dudx.data = q.dudx.data();
    columns.dvdx.data = q.dvdx.data();
    columns.dudy.data = q.dudy.data();
    columns.dvdy.data = q.dvdy.data();
    columns.dwdx.data = deep.dwdx.data();
    columns.dwdy.data = deep.dwdy.data();
  }
  std::vector<float> channels[4];
  shd_texels out = shd_texels_default();
  for (int c = 0; c < format.channels; ++c) {
    channels[c].resize(columns.count);
    out.channel[c].data = channels[c].data();
  }
  check(shd_texture_sample(objects.texture, objects.sampler, &columns, &out));
  const Stopwatch watch;
  for (auto _ : state) check(shd_texture_sample(objects.texture, objects.sampler, &columns, &out));
  const double rate =
      watch.items_per_second(static_cast<double>(state.iterations()) * static_cast<double>(columns.count));
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(columns.count));
  const std::string flat = row_name(2, filter.name, format.name, target.name, pattern);
  if (dimensions == 2) return record_rate(flat, rate);
  const double of_flat = recorded_rate(flat);
  if (of_flat > 0.0) state.counters["ratio_2d"] = rate / of_flat;
}

/// A scene of one volume.
struct VolumeScene {
  const char* name;
  float (*density)(float, float, float);
  float points[4], extinction[4];
  bool shaded;
};
constexpr VolumeScene kScenes[] = {
    {"skin", head_density, {0.25f, 0.35f, 0.6f, 1.0f}, {0.0f, 40.0f, 120.0f, 200.0f}, true},
    {"bone", head_density, {0.25f, 0.35f, 0.6f, 1.0f}, {0.0f, 40.0f, 120.0f, 200.0f}, false},
    {"fog", head_density, {0.05f, 0.2f, 0.3f, 1.0f}, {0.0f, 0.5f, 2.0f, 4.0f}, false},
    {"cloud", cloud_density, {0.05f, 0.3f, 0.6f, 1.0f}, {0.0f, 6.0f, 12.0f, 20.0f}, false},
};

void run_volume(benchmark::State& state, const Target& target, const VolumeScene& scene) {
  shd_context* context = make_context(target.simd);
  std::vector<uint8_t> texels(size_t{kVolumeEdge} * kVolumeEdge * kVolumeEdge);
  fill_density(scene.density, kVolumeEdge, texels.data());
  shd_texture_desc texture_desc = shd_texture_desc_default();
  texture_desc.format = SHD_FORMAT_R8;
  texture_desc.kind = SHD_TEXTURE_KIND_3D;
  texture_desc.width = texture_desc.height = texture_desc.depth = kVolumeEdge;
  texture_desc.texels = texels.data();
  shd_texture* texture = nullptr;
  check(shd_texture_create(context, &texture_desc, &texture));
  shd_material* material = nullptr;
  check(shd_material_create(context, nullptr, &material));
  shd_light_desc light_desc = shd_light_desc_default();
  light_desc.kind = SHD_LIGHT_KIND_DIRECTIONAL;
  shd_light* light = nullptr;
  check(shd_light_create(context, &light_desc, &light));
  shd_volume_desc desc = shd_volume_desc_default();
  desc.texture = texture;
  desc.point_count = 4;
  desc.density = shd_f32_column(scene.points, 0);
  desc.extinction = shd_f32_column(scene.extinction, 0);
  for (float& corner : desc.bounds_min) corner = -1.0f;
  desc.step = 2.0f / kVolumeEdge;
  desc.material = scene.shaded ? material : nullptr;
  shd_volume* volume = nullptr;
  check(shd_volume_create(context, &desc, &volume));
  shd_framebuffer_desc frame_desc = shd_framebuffer_desc_default();
  frame_desc.width = frame_desc.height = kFrame;
  shd_framebuffer* framebuffer = nullptr;
  check(shd_framebuffer_create(context, &frame_desc, &framebuffer));
  shd_volume_draw draw = shd_volume_draw_default();
  draw.volume = volume;
  shd_camera camera = shd_camera_default();
  camera.eye[0] = 1.4f;
  camera.eye[1] = 0.9f;
  camera.eye[2] = 2.6f;
  shd_render_desc render = shd_render_desc_default();
  render.framebuffer = framebuffer;
  render.camera = &camera;
  const shd_light* lights[] = {light};
  render.lights = lights;
  render.light_count = 1;
  render.volumes = &draw;
  render.volume_count = 1;
  check(shd_render(context, &render));
  for (auto _ : state) check(shd_render(context, &render));
  state.SetItemsProcessed(state.iterations() * kFrame * kFrame);
  shd_framebuffer_release(framebuffer);
  shd_volume_release(volume);
  shd_light_release(light);
  shd_material_release(material);
  shd_texture_release(texture);
  shd_context_release(context);
}

}  // namespace

void register_volume() {
  for (const Target& target : targets()) {
    for (const SolidFilter& filter : kSolidFilters) {
      for (const Format& format : kSolidFormats) {
        for (const std::string pattern : {"floor", "random"}) {
          for (const int dimensions : {2, 3}) {
            benchmark::RegisterBenchmark(row_name(dimensions, filter.name, format.name, target.name, pattern).c_str(),
                                         [=, &filter, &format](benchmark::State& state) {
                                           run_lookups(state, target, filter, format, pattern, dimensions);
                                         })
                ->Unit(benchmark::kMillisecond);
          }
        }
      }
    }
    for (const VolumeScene& scene : kScenes) {
      benchmark::RegisterBenchmark((std::string("volume/") + scene.name + "/" + target.name).c_str(),
                                   [target, &scene](benchmark::State& state) { run_volume(state, target, scene); })
          ->Unit(benchmark::kMillisecond);
    }
  }
}

}  // namespace shd::bench
