// SPDX-License-Identifier: MIT
#pragma once
#include <utility>

#include <shd/io.h>
#include <shd/scene.h>
#include <shd/shd.h>

/// Releases the shd handle that it owns: `Owned<shd_mesh, shd_mesh_release>`.
template <class Handle, void (*release)(Handle*)>
struct Owned {
  Owned() = default;
  Owned(Owned&& other) noexcept : handle(other.handle) { other.handle = nullptr; }
  Owned& operator=(Owned&& other) noexcept {
    std::swap(handle, other.handle);
    return *this;
  }
  ~Owned() { release(handle); }

  Handle* get() const { return handle; }
  /// Releases the previous handle and returns the address for an out parameter.
  Handle** out() {
    release(handle);
    handle = nullptr;
    return &handle;
  }

  Handle* handle = nullptr;
};

using Context = Owned<shd_context, shd_context_release>;
using Texture = Owned<shd_texture, shd_texture_release>;
using Sampler = Owned<shd_sampler, shd_sampler_release>;
using Mesh = Owned<shd_mesh, shd_mesh_release>;
using Material = Owned<shd_material, shd_material_release>;
using Light = Owned<shd_light, shd_light_release>;
using Shadow = Owned<shd_shadow, shd_shadow_release>;
using Environment = Owned<shd_environment, shd_environment_release>;
using Framebuffer = Owned<shd_framebuffer, shd_framebuffer_release>;
using Bitmap = Owned<shd_bitmap, shd_bitmap_release>;
using Volume = Owned<shd_volume, shd_volume_release>;
using Scene = Owned<shd_scene, shd_scene_release>;
