// SPDX-License-Identifier: MIT
#include "abi/desc.h"

#include <cstring>

#include <shd/color.h>
#include <shd/desc.h>
#include <shd/io.h>
#include <shd/scene.h>
#include <shd/shd.h>

#include "image/read_image.h"

namespace shd::abi {

using core::fail;

shd_result check_range(const char* field, double value, double low, double high) {
  if (value >= low && value <= high) return SHD_OK;
  return fail(SHD_ERROR_INVALID_ARGUMENT, "%s: %g is not in %g..%g", field, value, low, high);
}

shd_result check_count(const char* field, uint64_t value, uint64_t low, uint64_t high) {
  if (value >= low && value <= high) return SHD_OK;
  return fail(SHD_ERROR_INVALID_ARGUMENT, "%s: %llu is not in %llu..%llu", field,
              static_cast<unsigned long long>(value), static_cast<unsigned long long>(low),
              static_cast<unsigned long long>(high));
}

shd_result check_zero(const char* field, uint64_t value) {
  if (value == 0) return SHD_OK;
  return fail(SHD_ERROR_INVALID_ARGUMENT, "%s: %llu is not 0", field, static_cast<unsigned long long>(value));
}

shd_result check_flags(const char* field, uint32_t value, uint32_t known) {
  if ((value & ~known) == 0) return SHD_OK;
  return fail(SHD_ERROR_UNSUPPORTED, "%s: bits 0x%x are not known", field, value & ~known);
}

shd_result check_not_null(const char* field, const void* pointer) {
  if (pointer) return SHD_OK;
  return fail(SHD_ERROR_INVALID_ARGUMENT, "%s: NULL", field);
}

shd_result check_finite(const char* field, const float* values, size_t count) {
  for (size_t i = 0; i < count; ++i) {
    if (!std::isfinite(values[i])) {
      return fail(SHD_ERROR_INVALID_ARGUMENT, "%s[%zu]: %g is not finite", field, i, static_cast<double>(values[i]));
    }
  }
  return SHD_OK;
}

shd_result check_values(const char* field, const float* values, size_t count, double low, double high) {
  for (size_t i = 0; i < count; ++i) {
    const double value = static_cast<double>(values[i]);
    if (!(value >= low && value <= high)) {
      return fail(SHD_ERROR_INVALID_ARGUMENT, "%s[%zu]: %g is not in %g..%g", field, i, value, low, high);
    }
  }
  return SHD_OK;
}

shd_result check_column(const char* field, const void* data, size_t stride, size_t count, size_t size) {
  if (!data || count == 0) return SHD_OK;
  if (reinterpret_cast<uintptr_t>(data) % size != 0) {
    return fail(SHD_ERROR_INVALID_ARGUMENT, "%s.data: not aligned to %zu bytes", field, size);
  }
  if (stride % size != 0) {
    return fail(SHD_ERROR_INVALID_ARGUMENT, "%s.stride: %zu is not a multiple of %zu", field, stride, size);
  }
  size_t bytes;
  if (__builtin_mul_overflow(stride ? stride : size, count, &bytes) || bytes > PTRDIFF_MAX) {
    return fail(SHD_ERROR_INVALID_ARGUMENT, "%s: %zu elements of stride %zu exceed the address space", field, count,
                stride);
  }
  return SHD_OK;
}

shd_result read_image(const char* name, const shd_image* in, shd_image* out) {
  const auto takes = [](shd_format) { return true; };
  return image::read_image(core::fail, takes, name, in, out);
}

namespace {

template <class Desc>
shd_result write_defaults(const Desc& defaults, void* ptr, size_t size) {
  if (size < sizeof(Desc)) {
    return fail(SHD_ERROR_INVALID_ARGUMENT, "desc_init.size: %zu is below %zu", size, sizeof(Desc));
  }
  if (size > (1u << 16)) return fail(SHD_ERROR_INVALID_ARGUMENT, "desc_init.size: %zu is above 65536", size);
  std::memset(ptr, 0, size);
  std::memcpy(ptr, &defaults, sizeof defaults);
  const auto struct_size = static_cast<uint32_t>(size);
  std::memcpy(ptr, &struct_size, sizeof struct_size);
  return SHD_OK;
}

}  // namespace
}  // namespace shd::abi

extern "C" {

shd_result shd_desc_init(shd_desc_kind kind, void* ptr, size_t size) {
  using shd::abi::write_defaults;
  SHD_TRY(shd::abi::check_not_null("desc_init.ptr", ptr));
  switch (shd::abi::enum_bits(kind)) {
    case SHD_DESC_CONTEXT: return write_defaults(shd_context_desc_default(), ptr, size);
    case SHD_DESC_TEXTURE: return write_defaults(shd_texture_desc_default(), ptr, size);
    case SHD_DESC_SAMPLER: return write_defaults(shd_sampler_desc_default(), ptr, size);
    case SHD_DESC_LOOKUPS: return write_defaults(shd_lookups_default(), ptr, size);
    case SHD_DESC_MESH: return write_defaults(shd_mesh_desc_default(), ptr, size);
    case SHD_DESC_MATERIAL: return write_defaults(shd_material_desc_default(), ptr, size);
    case SHD_DESC_LIGHT: return write_defaults(shd_light_desc_default(), ptr, size);
    case SHD_DESC_FRAMEBUFFER: return write_defaults(shd_framebuffer_desc_default(), ptr, size);
    case SHD_DESC_DRAW: return write_defaults(shd_draw_default(), ptr, size);
    case SHD_DESC_RENDER: return write_defaults(shd_render_desc_default(), ptr, size);
    case SHD_DESC_IMAGE: return write_defaults(shd_image_default(), ptr, size);
    case SHD_DESC_CAMERA: return write_defaults(shd_camera_default(), ptr, size);
    case SHD_DESC_COLOR: return write_defaults(shd_color_desc_default(), ptr, size);
    case SHD_DESC_LOAD: return write_defaults(shd_load_desc_default(), ptr, size);
    case SHD_DESC_SAVE: return write_defaults(shd_save_desc_default(), ptr, size);
    case SHD_DESC_RAY_DIFFERENTIALS: return write_defaults(shd_ray_differentials_default(), ptr, size);
    case SHD_DESC_RAY_CONES: return write_defaults(shd_ray_cones_default(), ptr, size);
    case SHD_DESC_EXPLANATION: return write_defaults(shd_explanation_default(), ptr, size);
    case SHD_DESC_MIP: return write_defaults(shd_mip_desc_default(), ptr, size);
    case SHD_DESC_EDGES: return write_defaults(shd_edges_desc_default(), ptr, size);
    case SHD_DESC_SHADOW: return write_defaults(shd_shadow_desc_default(), ptr, size);
    case SHD_DESC_SHADOW_RENDER: return write_defaults(shd_shadow_render_desc_default(), ptr, size);
    case SHD_DESC_SHADOW_LOOKUPS: return write_defaults(shd_shadow_lookups_default(), ptr, size);
    case SHD_DESC_TESSELLATION: return write_defaults(shd_tessellation_desc_default(), ptr, size);
    case SHD_DESC_SHAPE: return write_defaults(shd_shape_desc_default(), ptr, size);
    case SHD_DESC_SHAPE_COLUMNS: return write_defaults(shd_shape_columns_default(), ptr, size);
    case SHD_DESC_SCENE: return write_defaults(shd_scene_desc_default(), ptr, size);
    case SHD_DESC_SCENE_INFO: return write_defaults(shd_scene_info_default(), ptr, size);
    case SHD_DESC_SCENE_INSTANCE: return write_defaults(shd_scene_instance_default(), ptr, size);
    default:
      return shd::core::fail(SHD_ERROR_INVALID_ARGUMENT, "desc_init.kind: %u is not a desc", shd::abi::enum_bits(kind));
  }
}

}  // extern "C"
