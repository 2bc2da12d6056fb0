// SPDX-License-Identifier: MIT
#include <shd/shadow.h>

#include "abi/batch.h"
#include "abi/desc.h"
#include "abi/draws.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "core/scratch.h"
#include "frame/shadow_map.h"
#include "light/shadow.h"

namespace {

using namespace shd;
using namespace shd::abi;

constexpr core::ObjectType kShadowType = core::ObjectType::kShadow;
constexpr double kMaxLength = 1e9;

shd_result check_distance(const char* field, float value) {
  return check_range(field, static_cast<double>(value), 0.0, kMaxLength);
}

shd_result check_shadow_desc(const shd_shadow_desc& desc) {
  SHD_TRY(check_count("shadow.size", desc.size, 16, 8192));
  SHD_TRY(check_enum("shadow.filter", desc.filter, 0, SHD_SHADOW_FILTER_PCSS));
  SHD_TRY(check_count("shadow.taps", desc.taps, 1, light::kMaxTaps));
  SHD_TRY(check_distance("shadow.filter_size", desc.filter_size));
  SHD_TRY(check_distance("shadow.light_size", desc.light_size));
  SHD_TRY(check_distance("shadow.bias", desc.bias));
  SHD_TRY(check_range("shadow.bias_slope", static_cast<double>(desc.bias_slope), 0.0, 1000.0));
  SHD_TRY(check_distance("shadow.normal_offset", desc.normal_offset));
  SHD_TRY(check_enum("shadow.caster_cull", desc.caster_cull, 0, SHD_CULL_FRONT));
  SHD_TRY(check_range("shadow.bleed", static_cast<double>(desc.bleed), 0.0, static_cast<double>(0.99f)));
  return check_distance("shadow.min_variance", desc.min_variance);
}

shd_result check_planes(const shd_shadow_render_desc& desc, const light::Light& light, frame::ShadowFrame* out) {
  SHD_TRY(check_finite("shadow_render.near_plane", &desc.near_plane, 1));
  SHD_TRY(check_finite("shadow_render.far_plane", &desc.far_plane, 1));
  out->near = desc.near_plane;
  out->far = desc.far_plane;
  out->has_planes = desc.near_plane != 0.0f || desc.far_plane != 0.0f;
  if (!out->has_planes) return SHD_OK;
  const double near = static_cast<double>(desc.near_plane), far = static_cast<double>(desc.far_plane);
  if (light.kind == SHD_LIGHT_KIND_DIRECTIONAL) {
    SHD_TRY(check_range("shadow_render.near_plane", near, -kMaxLength, kMaxLength));
  } else {
    SHD_TRY(check_range("shadow_render.near_plane", near, 1e-9, kMaxLength));
  }
  SHD_TRY(check_range("shadow_render.far_plane", far, -kMaxLength, kMaxLength));
  if (!(near < far)) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "shadow_render.far_plane: %g is not above near_plane, %g", far, near);
  }
  return SHD_OK;
}

shd_result check_bounds(const shd_shadow_render_desc& desc, frame::ShadowFrame* out) {
  SHD_TRY(check_finite("shadow_render.bounds_min", desc.bounds_min, 3));
  SHD_TRY(check_finite("shadow_render.bounds_max", desc.bounds_max, 3));
  for (int k = 0; k < 3; ++k) {
    if (desc.bounds_min[k] > desc.bounds_max[k]) {
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "shadow_render.bounds_max[%d]: %g is below bounds_min, %g", k,
                        static_cast<double>(desc.bounds_max[k]), static_cast<double>(desc.bounds_min[k]));
    }
    out->bounds_min[k] = desc.bounds_min[k];
    out->bounds_max[k] = desc.bounds_max[k];
  }
  out->has_bounds = !is_zero(desc.bounds_min) || !is_zero(desc.bounds_max);
  return SHD_OK;
}

shd_result render_shadow(const core::Context& context, const core::Context& owner, const shd_shadow_render_desc& desc,
                         light::Shadow* shadow) {
  SHD_TRY(check_count("shadow_render.draw_count", desc.draw_count, 0, kMaxItems));
  if (desc.draw_count) SHD_TRY(check_not_null("shadow_render.draws", desc.draws));
  const light::LightBody* body = nullptr;
  SHD_TRY(read_handle("shadow_render.light", desc.light, core::ObjectType::kLight, &body));
  if (body->light.kind == SHD_LIGHT_KIND_AMBIENT) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "shadow_render.light: AMBIENT casts no shadows");
  }
  frame::ShadowFrame frame = {};
  frame.light = &body->light;
  SHD_TRY(check_planes(desc, body->light, &frame));
  SHD_TRY(check_bounds(desc, &frame));
  core::Buffer<frame::Draw> draws(context.allocator);
  SHD_TRY(read_draws("shadow_render", desc.draws, desc.draw_count, &draws));
  frame.draws = draws.data();
  frame.draw_count = draws.size();
  frame::render_shadow(context, owner, frame, shadow);
  return SHD_OK;
}

shd_result check_rendered(const light::Shadow& shadow) {
  if (shadow.is_rendered) return SHD_OK;
  return core::fail(SHD_ERROR_INVALID_ARGUMENT, "shadow: it was not rendered yet");
}

/// Positions and normals in, light out.
using ShadowBatch = Batch<6, 1>;

shd_result read_batch(const shd_shadow_lookups* in, const shd_shadow_values* out, ShadowBatch* batch,
                      shd_shadow_values* values) {
  shd_shadow_lookups read = shd_shadow_lookups_default();
  SHD_TRY(read_desc("lookups", in, false, &read));
  const bool has_normals = read.normal[0].data || read.normal[1].data || read.normal[2].data;
  batch->count = read.count;
  for (int c = 0; c < 3; ++c) {
    batch->in[c] = in_column("lookups.position", read.position[c], Need::kRequired, c);
    batch->in[3 + c] = in_column("lookups.normal", read.normal[c], has_normals ? Need::kRequired : Need::kOptional, c);
  }
  *values = shd_shadow_values_default();
  SHD_TRY(read_desc("values", out, false, values));
  batch->out[0] = out_column("values.visibility", values->visibility, Need::kRequired);
  return check_batch(*batch);
}

/// Returns the number of points that are not finite.
size_t sample_batch(const core::Context& context, const light::Shadow& shadow, const ShadowBatch& batch) {
  return run_counting(context, batch, batch.in.size(), [&](const Piece<6, 1>& piece) {
    light::ShadowLookups lookups = {piece.count, {}, {}};
    for (size_t c = 0; c < 3; ++c) {
      lookups.position[c] = piece.floats(c);
      lookups.normal[c] = piece.floats(3 + c);
    }
    light::sample_shadow(context.simd, shadow, lookups, piece.out_floats(0));
  });
}

}  // namespace

extern "C" {

shd_result shd_shadow_create(shd_context* context, const shd_shadow_desc* desc, shd_shadow** out_shadow) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_not_null("out_shadow", out_shadow));
    *out_shadow = nullptr;
    SHD_TRY(check_context(context));
    shd_shadow_desc read = shd_shadow_desc_default();
    SHD_TRY(read_desc("shadow", desc, true, &read));
    SHD_TRY(check_shadow_desc(read));
    core::Context& owner = context_of(context);
    auto* shadow = core::create<light::Shadow>(owner.allocator);
    shadow->options = {read.size,          read.filter,     read.taps,        read.caster_cull,
                       read.filter_size,   read.light_size, read.bias,        read.bias_slope,
                       read.normal_offset, read.bleed,      read.min_variance};
    make_handle(owner, kShadowType, shadow, out_shadow);
    return SHD_OK;
  });
}

void shd_shadow_retain(shd_shadow* shadow) {
  retain_handle(shadow, kShadowType);
}

void shd_shadow_release(shd_shadow* shadow) {
  release_handle(shadow, kShadowType);
}

shd_result shd_shadow_render(shd_context* context, shd_shadow* shadow, const shd_shadow_render_desc* desc) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_context(context));
    light::Shadow* body = nullptr;
    SHD_TRY(read_handle("shadow", shadow, kShadowType, &body));
    shd_shadow_render_desc read = shd_shadow_render_desc_default();
    SHD_TRY(read_desc("shadow_render", desc, false, &read));
    core::ScratchScope scratch(context_of(context));
    return render_shadow(scratch.context, *object_of(shadow)->context, read, body);
  });
}

shd_result shd_shadow_get_info(const shd_shadow* shadow, shd_shadow_info* out_info) {
  return guard([&]() -> shd_result {
    SHD_TRY(begin_output("out_info", out_info));
    const light::Shadow* body = nullptr;
    SHD_TRY(read_handle("shadow", shadow, kShadowType, &body));
    shd_shadow_info info = shd_shadow_info_default();
    info.filter = body->options.filter;
    info.width = info.height = light::face_size(body->options);
    if (body->is_rendered) {
      info.face_count = body->map.placement.face_count;
      const double origin = light::origin_depth(body->map.placement);
      info.near_plane = static_cast<float>(static_cast<double>(body->map.placement.near) + origin);
      info.far_plane = static_cast<float>(static_cast<double>(body->map.placement.far) + origin);
      info.byte_size = light::byte_size(body->map);
    }
    write_desc(info, out_info);
    return SHD_OK;
  });
}

shd_result shd_shadow_read_map(const shd_shadow* shadow, uint32_t face, const shd_f32_out* out) {
  return guard([&]() -> shd_result {
    const light::Shadow* body = nullptr;
    SHD_TRY(read_handle("shadow", shadow, kShadowType, &body));
    SHD_TRY(check_rendered(*body));
    SHD_TRY(check_count("face", face, 0, body->map.placement.face_count - 1));
    const uint32_t size = light::face_size(body->options);
    SHD_TRY(check_outputs<2>(out, uint64_t{size} * size));
    if (out[1].data && body->map.depth.size()) {
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "out[1].data: not NULL, but filter %d has depths alone",
                        static_cast<int>(body->options.filter));
    }
    light::read_face(*body, face, out);
    return SHD_OK;
  });
}

shd_result shd_shadow_sample(const shd_shadow* shadow, const shd_shadow_lookups* lookups, shd_shadow_values* out) {
  return guard([&]() -> shd_result {
    const light::Shadow* body = nullptr;
    SHD_TRY(read_handle("shadow", shadow, kShadowType, &body));
    ShadowBatch batch;
    shd_shadow_values values;
    SHD_TRY(read_batch(lookups, out, &batch, &values));
    SHD_TRY(check_rendered(*body));
    values.nonfinite_count = sample_batch(*object_of(shadow)->context, *body, batch);
    write_desc(values, out);
    return SHD_OK;
  });
}

}  // extern "C"
