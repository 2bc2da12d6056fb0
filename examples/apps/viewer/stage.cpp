// SPDX-License-Identifier: MIT
#include "stage.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "false_color.h"

namespace viewer {
namespace {

shd::context make_context(uint32_t workers) {
  shd::context_desc desc;
  desc.worker_count = workers;
  return shd::context_create(&desc);
}

float aspect_of(const State& state) {
  return static_cast<float>(state.width) / static_cast<float>(state.height);
}

shd_debug_view debug_view_of(Show show) {
  switch (show) {
    case Show::kNormals: return SHD_DEBUG_VIEW_NORMAL;
    case Show::kUv: return SHD_DEBUG_VIEW_UV;
    case Show::kLevel: return SHD_DEBUG_VIEW_LEVEL;
    case Show::kBarycentrics: return SHD_DEBUG_VIEW_BARYCENTRICS;
    default: return SHD_DEBUG_VIEW_NONE;
  }
}

bool divides_by_pi(shd_model model) {
  return model == SHD_MODEL_METALLIC_ROUGHNESS || model == SHD_MODEL_BLINN_PHONG_NORMALIZED || model == SHD_MODEL_GLASS;
}

/// One reflectance model for all parts, so that one light suits all of them.
shd_model model_of(const Surface& surface, const Assets& assets) {
  if (!assets.from_file || !surface.from_file) return surface.model;
  for (const SurfaceAsset& asset : assets.surfaces) {
    if (!asset.is_floor && asset.desc.model == SHD_MODEL_METALLIC_ROUGHNESS) return SHD_MODEL_METALLIC_ROUGHNESS;
  }
  return SHD_MODEL_BLINN_PHONG;
}

shd::sampler make_sampler(shd_context* context, const Sampling& sampling, const Wraps& wraps) {
  shd::sampler_desc desc;
  desc.filter = sampling.filter;
  desc.max_anisotropy = sampling.max_anisotropy;
  desc.precision = sampling.precision;
  desc.lod_bias = sampling.lod_bias;
  desc.profile = sampling.profile;
  desc.wrap_u = wraps.u, desc.wrap_v = wraps.v;
  return shd::sampler_create(context, &desc);
}

void set_surface(const Surface& surface, bool has_texture, shd_material_desc& desc) {
  constexpr float kClay[3] = {0.62f, 0.60f, 0.56f};
  for (size_t c = 0; c < 3; ++c) {
    desc.diffuse[c] = surface.color[c] * (has_texture ? 1.0f : kClay[c]);
    desc.specular[c] = surface.specular;
  }
  desc.roughness = surface.roughness;
  desc.metallic = surface.metallic;
  desc.clearcoat = surface.clearcoat;
  desc.exponent = surface.exponent;
}

shd::framebuffer make_framebuffer(shd_context* context, uint32_t width, uint32_t height, uint32_t samples,
                                  shd_aov_flags aovs) {
  shd::framebuffer_desc desc;
  desc.width = width, desc.height = height, desc.sample_count = samples, desc.aovs = aovs;
  return shd::framebuffer_create(context, &desc);
}

bool suits(const shd_framebuffer* framebuffer, uint32_t width, uint32_t height, uint32_t samples, shd_aov_flags aovs) {
  if (!framebuffer) return false;
  const shd_framebuffer_info info = shd::framebuffer_get_info(framebuffer);
  return info.width == width && info.height == height && info.sample_count == samples && info.aovs == aovs;
}

shd_image rgba(std::vector<uint8_t>& pixels, const Image& image, shd_format format) {
  shd::image out;
  out.format = format;
  out.width = image.width, out.height = image.height;
  out.pixels = pixels.data();
  return out;
}

}  // namespace

Stage::Stage(uint32_t workers) : context_(make_context(workers)) {
#ifdef VIEWER_WITH_COLOR
  color_ = shd::color_create(context_, nullptr);
  for (uint32_t d = 0; d < shd_color_get_display_count(color_); ++d) {
    const std::string name = shd_color_get_display_name(color_, d);
    for (uint32_t v = 0; v < shd_color_get_view_count(color_, name.c_str()); ++v) {
      displays_.push_back({name, shd_color_get_view_name(color_, name.c_str(), v)});
    }
  }
#endif
}

void Stage::prepare(const State& state) {
  const shd_table_flags needed = tables_of(state);
  const bool is_new = !content_ || *content_ != state.content || (needed & ~tables_) != 0;
  if (is_new) {
    Assets assets = make_assets(context_, state.content, needed);
    assets_ = std::move(assets);
    content_ = state.content;
    tables_ = needed;
  }
  lights_.prepare(context_, state.lighting, assets_, is_new);
}

shd::material Stage::make_material(const Side& side, shd_model model, const SurfaceAsset& surface, Look& look) const {
  shd_material_desc desc = surface.desc;
  std::vector<shd_slot> slots = surface.slots;
  std::vector<shd::sampler> samplers;
  bool has_texture = false;
  for (size_t i = 0; i < slots.size(); ++i) {
    samplers.emplace_back();
    if (slots[i].source != SHD_SLOT_SOURCE_TEXTURE) continue;
    samplers.back() = make_sampler(context_, side.sampling, surface.wraps[i]);
    slots[i].sampler = samplers.back();
    has_texture = has_texture || slots[i].target == SHD_SLOT_DIFFUSE;
  }
  desc.model = model;
  if (surface.is_floor) desc.model = look.over_pi ? SHD_MODEL_METALLIC_ROUGHNESS : SHD_MODEL_LAMBERT;
  if (!surface.is_floor && (!assets_.from_file || !side.surface.from_file)) {
    set_surface(side.surface, has_texture, desc);
  }
  desc.debug_view = debug_view_of(side.show);
  desc.slots = slots.data(), desc.slot_count = static_cast<uint32_t>(slots.size());
  look.samplers.push_back(std::move(samplers));
  return shd::material_create(context_, &desc);
}

Stage::Look Stage::make_look(const Side& side) const {
  Look look;
  const shd_model model = model_of(side.surface, assets_);
  look.over_pi = divides_by_pi(model);
  for (const SurfaceAsset& surface : assets_.surfaces) {
    look.materials.push_back(make_material(side, model, surface, look));
  }
  for (const Part& part : assets_.parts) {
    shd::draw draw;
    draw.mesh = part.mesh;
    draw.material = look.materials[part.surface];
    std::copy(part.object_to_world.begin(), part.object_to_world.end(), draw.object_to_world);
    look.draws.push_back(draw);
  }
  return look;
}

shd_render_desc Stage::make_frame(const State& state, const Side& side, const Look& look) const {
  const shd_camera camera = camera_of(state.orbit, assets_.bounds, aspect_of(state));
  shd::render_desc frame;
  frame.view = shd::view_from_camera(&camera);
  frame.draws = look.draws.data(), frame.draw_count = look.draws.size();
  lights_.set(look.over_pi, frame);
  if (side.show != Show::kModel) {
    constexpr float kDark[4] = {0.07f, 0.075f, 0.085f, 1.0f};
    std::copy(kDark, kDark + 4, frame.clear_color);
    frame.background = SHD_BACKGROUND_CLEAR;
  }
  return frame;
}

void Stage::encode(const State& state, const Side& side, const shd_framebuffer* framebuffer, Image& image) const {
  image.display.resize(size_t{4} * image.width * image.height);
  if (side.show == Show::kOverdraw) return show_overdraw(framebuffer, image);
  if (side.show == Show::kDepth) {
    return show_depth(framebuffer, camera_of(state.orbit, assets_.bounds, aspect_of(state)), image);
  }
#ifdef VIEWER_WITH_COLOR
  if (side.show == Show::kModel && !state.display.display.empty()) {
    const shd_image out = rgba(image.display, image, SHD_FORMAT_RGBA8);
    return shd::color_apply_display(color_, framebuffer, state.display.display.c_str(), state.display.view.c_str(),
                                    &out);
  }
#else
  if (!state.display.display.empty()) throw std::runtime_error("views of displays: built without libshd_color");
#endif
  // Debug views show numbers, not light, so they are not encoded.
  const shd_format format = side.show == Show::kModel ? SHD_FORMAT_RGBA8_SRGB : SHD_FORMAT_RGBA8;
  const shd_image out = rgba(image.display, image, format);
  shd::framebuffer_read_color(framebuffer, &out);
}

std::shared_ptr<const Image> Stage::render(const State& state, int index, const shd_progress& progress, Tiles* tiles) {
  const Side& side = state.side[index];
  const shd_aov_flags aovs = side.show == Show::kOverdraw ? SHD_AOV_OVERDRAW : SHD_AOV_NONE;
  shd::framebuffer& framebuffer = framebuffers_[index];
  if (!suits(framebuffer, state.width, state.height, side.samples, aovs)) {
    framebuffer = make_framebuffer(context_, state.width, state.height, side.samples, aovs);
  }
  const Look look = make_look(side);
  auto image = std::make_shared<Image>();
  image->width = state.width, image->height = state.height;
  shd_render_desc frame = make_frame(state, side, look);
  frame.framebuffer = framebuffer;
  frame.stats = &image->stats;
  frame.progress = progress;
  if (tiles && side.show != Show::kOverdraw && side.show != Show::kDepth) {
    tiles->begin(state.width, state.height, index, side.show == Show::kModel);
    frame.present = tiles->present();
  }
  const auto start = std::chrono::steady_clock::now();
  shd::render(context_, &frame);
  encode(state, side, framebuffer, *image);
  image->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  image->linear.resize(size_t{4} * image->width * image->height);
  for (int c = 0; c < 4; ++c) {
    const shd_f32_out out = shd_f32_out_column(image->linear.data() + c, 4 * sizeof(float));
    shd::framebuffer_read_plane(framebuffer, static_cast<shd_plane>(SHD_PLANE_R + c), &out);
  }
  return image;
}

Picture Stage::show(const State& state, const shd_progress& progress, const Picture* previous, Tiles* tiles) {
  Picture picture;
  picture.state = state;
  picture.simd = shd_context_get_simd_target(context_);
  picture.workers = shd_context_get_worker_count(context_);
  try {
    const bool is_rendered =
        previous && !previous->cancelled && previous->side[0] && same_pixels(previous->state, state);
    if (!is_rendered) prepare(state);
    for (int i = 0; i < (state.wipe ? 2 : 1); ++i) {
      picture.side[i] = is_rendered ? previous->side[i] : render(state, i, progress, tiles);
    }
    picture.bounds = assets_.bounds;
    picture.triangles = assets_.triangles;
    picture.warnings = assets_.warnings;
    picture.from_file = assets_.from_file;
    if (state.pick) explain_pick(state, picture.explanation);
  } catch (const shd::error& failure) {
    picture.side[0] = picture.side[1] = nullptr;
    picture.cancelled = failure.result() == SHD_ERROR_CANCELLED;
    if (!picture.cancelled) picture.error = failure.what();
  } catch (const std::exception& failure) {
    picture.side[0] = picture.side[1] = nullptr;
    picture.error = failure.what();
  }
  return picture;
}

void Stage::explain_pick(const State& state, Explanation& out) const {
  out.asked = true;
  out.pixel = {std::min(state.pick->x, state.width - 1), std::min(state.pick->y, state.height - 1)};
  out.side = side_at(state, out.pixel.x);
  Side side = state.side[out.side];
  side.show = Show::kModel;
  const Look look = make_look(side);
  // A framebuffer of one pixel, at its place in the picture, has the bits of the whole frame.
  const shd::framebuffer pixel =
      make_framebuffer(context_, 1, 1, side.samples, SHD_AOV_UV | SHD_AOV_DERIVATIVES | SHD_AOV_DRAW);
  shd_render_desc frame = make_frame(state, side, look);
  frame.framebuffer = pixel;
  frame.picture_width = state.width, frame.picture_height = state.height;
  frame.crop_x = out.pixel.x, frame.crop_y = out.pixel.y;
  shd::render(context_, &frame);
  const auto value = [&](shd_plane plane) { return shd::framebuffer_view_plane(pixel, plane).f32[0]; };
  for (int c = 0; c < 4; ++c) out.color[c] = value(static_cast<shd_plane>(SHD_PLANE_R + c));
  const uint32_t draw = shd::framebuffer_view_plane(pixel, SHD_PLANE_DRAW).u32[0];
  if (draw >= assets_.parts.size()) {
    out.note = "No opaque surface covers this pixel.";
    return;
  }
  Lookup lookup;
  lookup.u = value(SHD_PLANE_U), lookup.v = value(SHD_PLANE_V);
  lookup.dudx = value(SHD_PLANE_DUDX), lookup.dvdx = value(SHD_PLANE_DVDX);
  lookup.dudy = value(SHD_PLANE_DUDY), lookup.dvdy = value(SHD_PLANE_DVDY);
  const size_t index = assets_.parts[draw].surface;
  explain_surface(look, assets_.surfaces[index], index, lookup, out);
}

void Stage::explain_surface(const Look& look, const SurfaceAsset& surface, size_t index, const Lookup& lookup,
                            Explanation& out) const {
  out.surface = surface.name.empty() ? "unnamed" : surface.name;
  for (size_t i = 0; i < surface.slots.size(); ++i) {
    const shd_slot& slot = surface.slots[i];
    if (slot.target != SHD_SLOT_DIFFUSE || slot.source != SHD_SLOT_SOURCE_TEXTURE) continue;
    if (slot.uv_set != 0) {
      out.note = "The texture uses the second texture coordinates, which no plane holds.";
      return;
    }
    out.lookup = transformed(lookup, slot.uv_transform);
    try {
      const Wraps& wraps = surface.wraps[i];
      explain(context_, slot.texture, look.samplers[index][i], wraps.u, wraps.v, out);
    } catch (const shd::error& failure) {
      if (failure.result() != SHD_ERROR_UNSUPPORTED) throw;
      out.note = failure.what();  // SUMMED_AREA and EXACT are no blends of texels
    }
    return;
  }
  out.note = "The surface has no diffuse texture.";
}

}  // namespace viewer
