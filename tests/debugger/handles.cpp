// SPDX-License-Identifier: MIT
// Handles of every type for debugger.handles. The headers of the library give the debugger its types, as the debug
// information of libshd does.
#include <shd/shd.h>

#include <cstdio>

#include "environment/environment.h"
#include "film/framebuffer.h"
#include "geometry/mesh.h"
#include "light/light.h"
#include "light/shadow.h"
#include "material/material.h"
#include "texture/texture.h"
#include "volume/volume.h"

namespace {

#define REQUIRE(call)                                            \
  do {                                                           \
    if ((call) != SHD_OK) {                                      \
      std::fprintf(stderr, "%s: %s\n", #call, shd_last_error()); \
      return 1;                                                  \
    }                                                            \
  } while (0)

/// The debugger stops here.
[[gnu::noinline]] int stop() {
  asm volatile("");
  return 0;
}

/// Keeps types that are only behind handles in the debug information.
shd::core::Object* g_object;
shd::core::ObjectType g_type;
shd::texture::Texture* g_texture;
shd::texture::Sampler* g_sampler;
shd::geometry::Mesh* g_mesh;
shd::material::Material* g_material;
shd::light::LightBody* g_light;
shd::light::Shadow* g_shadow;
shd::film::Framebuffer* g_framebuffer;
shd::environment::Environment* g_environment;
shd::volume::Volume* g_volume;

}  // namespace

int main() {
  shd_context* context = nullptr;
  REQUIRE(shd_context_create(nullptr, &context));

  const unsigned char texels[2 * 3 * 4] = {};
  shd_texture_desc texture_desc = shd_texture_desc_default();
  texture_desc.width = 2, texture_desc.height = 3;
  texture_desc.format = SHD_FORMAT_RGBA8;
  texture_desc.texels = texels;
  shd_texture* texture = nullptr;
  REQUIRE(shd_texture_create(context, &texture_desc, &texture));
  texture_desc.kind = SHD_TEXTURE_KIND_3D, texture_desc.depth = 3, texture_desc.height = 1;
  shd_texture *solid = nullptr, *none = nullptr;
  REQUIRE(shd_texture_create(context, &texture_desc, &solid));
  shd_sampler* sampler = nullptr;
  REQUIRE(shd_sampler_create(context, nullptr, &sampler));

  const float zero[3] = {0, 0, 1};
  shd_mesh_desc mesh_desc = shd_mesh_desc_default();
  mesh_desc.vertex_count = 3;
  for (auto& column : mesh_desc.position) column = shd_f32_column(zero, 0);
  shd_mesh* mesh = nullptr;
  REQUIRE(shd_mesh_create(context, &mesh_desc, &mesh));
  shd_material* material = nullptr;
  REQUIRE(shd_material_create(context, nullptr, &material));
  shd_light* light = nullptr;
  REQUIRE(shd_light_create(context, nullptr, &light));
  shd_shadow* shadow = nullptr;
  REQUIRE(shd_shadow_create(context, nullptr, &shadow));
  shd_framebuffer_desc size = shd_framebuffer_desc_default();
  size.width = 5, size.height = 4;
  shd_framebuffer* framebuffer = nullptr;
  REQUIRE(shd_framebuffer_create(context, &size, &framebuffer));
  shd_sampler* released = nullptr;
  REQUIRE(shd_sampler_create(context, nullptr, &released));
  shd_sampler_release(released);
  const auto* mistyped = reinterpret_cast<const shd_mesh*>(texture);
  const shd_texture* const kept = texture;
  shd_texture_retain(texture);

  const int status = stop() + (mistyped ? 0 : 1) + (kept ? 0 : 1) + (none ? 1 : 0);
  std::printf("%p %p %p %p %p %p %p %p %p %p %p %d\n", static_cast<void*>(&g_object), static_cast<void*>(&g_type),
              static_cast<void*>(&g_texture), static_cast<void*>(&g_sampler), static_cast<void*>(&g_mesh),
              static_cast<void*>(&g_material), static_cast<void*>(&g_light), static_cast<void*>(&g_shadow),
              static_cast<void*>(&g_framebuffer), static_cast<void*>(&g_environment), static_cast<void*>(&g_volume),
              status);
  return status;
}
