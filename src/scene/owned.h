// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include <shd/shd.h>

namespace shd::scene {

/// Releases the shd handle that it owns: `Owned<shd_mesh, shd_mesh_release>`.
template <class Handle, void (*release)(Handle*)>
struct Owned {
  Owned() = default;
  Owned(Owned&& other) noexcept : handle(std::exchange(other.handle, nullptr)) {}
  Owned& operator=(Owned&& other) noexcept {
    std::swap(handle, other.handle);
    return *this;
  }
  ~Owned() { release(handle); }
  Handle* get() const { return handle; }
  /// Address for an out parameter; the object must be empty.
  Handle** out() { return &handle; }

  Handle* handle = nullptr;
};

using Texture = Owned<shd_texture, shd_texture_release>;
using Sampler = Owned<shd_sampler, shd_sampler_release>;
using Mesh = Owned<shd_mesh, shd_mesh_release>;
using Material = Owned<shd_material, shd_material_release>;
using Light = Owned<shd_light, shd_light_release>;

}  // namespace shd::scene
