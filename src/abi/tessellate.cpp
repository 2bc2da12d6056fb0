// SPDX-License-Identifier: MIT
#include <shd/tessellate.h>

#include <cmath>

#include "abi/camera.h"
#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "abi/lookup.h"
#include "geometry/tessellate.h"
#include "texture/texture.h"

namespace {

using namespace shd;
using namespace shd::abi;

shd_result check_number(const char* field, float value, double limit) {
  return check_range(field, static_cast<double>(value), -limit, limit);
}

shd_result check_view(const shd_view& view) {
  SHD_TRY(check_finite("tessellation.view.world_to_view", view.world_to_view, 16));
  SHD_TRY(check_finite("tessellation.view.view_to_clip", view.view_to_clip, 16));
  return check_finite("tessellation.view.eye", view.eye, 3);
}

shd_result check_tessellation_desc(const shd_tessellation_desc& desc) {
  SHD_TRY(check_enum("tessellation.mode", desc.mode, 0, SHD_TESSELLATION_MODE_ADAPTIVE));
  SHD_TRY(check_count("tessellation.segments", desc.segments, 1, SHD_MAX_TESSELLATION_SEGMENTS));
  SHD_TRY(check_count("tessellation.max_segments", desc.max_segments, 1, SHD_MAX_TESSELLATION_SEGMENTS));
  if (!(desc.edge_length > 0.0f && std::isfinite(desc.edge_length))) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "tessellation.edge_length: %g is not above 0 and finite",
                      static_cast<double>(desc.edge_length));
  }
  SHD_TRY(check_count("tessellation.picture_width", desc.picture_width, 0, 65536));
  SHD_TRY(check_count("tessellation.picture_height", desc.picture_height, desc.picture_width ? 1 : 0, 65536));
  SHD_TRY(check_enum("tessellation.normals", desc.normals, 0, SHD_DISPLACED_NORMALS_FACES));
  SHD_TRY(check_view(desc.view));
  SHD_TRY(check_finite("tessellation.object_to_world", desc.object_to_world, 16));
  SHD_TRY(check_count("tessellation.max_triangles", desc.max_triangles, 1, geometry::kMaxTriangles));
  SHD_TRY(check_number("tessellation.amplitude", desc.amplitude, 1e12));
  SHD_TRY(check_number("tessellation.offset", desc.offset, 1e12));
  return check_number("tessellation.lod", desc.lod, 32.0);
}

/// The texture and sampler of a desc; the texture stays null without one.
struct Displacement {
  const texture::Texture* texture = nullptr;
  const texture::Sampler* sampler = nullptr;
  texture::Sampler default_sampler = texture::make_sampler(shd_sampler_desc_default());
};

shd_result read_displacement(const shd_tessellation_desc& desc, Displacement* out) {
  out->sampler = &out->default_sampler;
  if (desc.sampler) {
    SHD_TRY(read_handle("tessellation.sampler", desc.sampler, core::ObjectType::kSampler, &out->sampler));
  }
  if (!desc.displacement) return SHD_OK;
  SHD_TRY(read_handle("tessellation.displacement", desc.displacement, core::ObjectType::kTexture, &out->texture));
  SHD_TRY(check_flat("tessellation.displacement", *out->texture));
  return check_use(*out->texture, *out->sampler);
}

}  // namespace

extern "C" shd_result shd_mesh_tessellate(shd_context* context, const shd_mesh* mesh, const shd_tessellation_desc* desc,
                                          shd_mesh** out_mesh) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_not_null("out_mesh", out_mesh));
    *out_mesh = nullptr;
    SHD_TRY(check_context(context));
    const geometry::Mesh* source = nullptr;
    SHD_TRY(read_handle("mesh", mesh, core::ObjectType::kMesh, &source));
    shd_tessellation_desc read = shd_tessellation_desc_default();
    SHD_TRY(read_desc("tessellation", desc, false, &read));
    SHD_TRY(check_tessellation_desc(read));
    if (read.camera && read.picture_width != 0) {
      const float height = static_cast<float>(read.picture_height);
      SHD_TRY(read_camera(read.camera, static_cast<float>(read.picture_width) / height, &read.view));
    }
    Displacement displacement;
    SHD_TRY(read_displacement(read, &displacement));
    core::Context& owner = context_of(context);
    geometry::Mesh made{};
    geometry::tessellate(owner, *source, read, displacement.texture, displacement.sampler, &made);
    make_handle(owner, core::ObjectType::kMesh, core::create<geometry::Mesh>(owner.allocator, std::move(made)),
                out_mesh);
    return SHD_OK;
  });
}
