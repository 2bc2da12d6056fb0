// SPDX-License-Identifier: MIT
#include "abi/desc.h"

#include <cstring>

#include <shd/color.h>
#include <shd/desc.h>
#include <shd/io.h>
#include <shd/scene.h>
#include <shd/shd.h>
#include <shd/texture_file.h>
#include <shd/volume_file.h>

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

shd_result read_pixels_or_blocks(const char* name, const shd_image* in, shd_image* out) {
  const auto takes = [](shd_format) { return true; };
  return image::read_image<true>(core::fail, takes, name, in, out);
}

shd_result check_apart(const char* a_name, const shd_image& a, const char* b_name, const shd_image& b) {
  const auto a_begin = reinterpret_cast<uintptr_t>(a.pixels), b_begin = reinterpret_cast<uintptr_t>(b.pixels);
  const size_t a_row = a.width * image::format_info(a.format).pixel_size;
  const size_t b_row = b.width * image::format_info(b.format).pixel_size;
  for (uint32_t i = 0, j = 0; i < a.height && j < b.height;) {  // images may lie beside each other in a larger one
    const uintptr_t a_at = a_begin + i * a.row_stride, b_at = b_begin + j * b.row_stride;
    if (a_at + a_row <= b_at) {
      ++i;
    } else if (b_at + b_row <= a_at) {
      ++j;
    } else {
      return fail(SHD_ERROR_INVALID_ARGUMENT, "%s.pixels: overlaps %s.pixels", a_name, b_name);
    }
  }
  return SHD_OK;
}

namespace {

template <class Desc>
shd_result write_defaults(const Desc& defaults, void* ptr, size_t size) {
  SHD_TRY(core::check_size(fail, "desc_init", "size", size, core::DescSize<Desc>::kRule));
  const auto struct_size = static_cast<uint32_t>(size);
  std::memcpy(ptr, &struct_size, sizeof struct_size);
  core::write_desc_bytes(&defaults, sizeof defaults, ptr);
  return SHD_OK;
}

}  // namespace
}  // namespace shd::abi

extern "C" {

shd_result shd_desc_init(shd_desc_kind kind, void* ptr, size_t size) {
  using shd::abi::write_defaults;
  SHD_TRY(shd::abi::check_not_null("desc_init.ptr", ptr));
  switch (shd::abi::enum_bits(kind)) {
    case SHD_DESC_KIND_CONTEXT_DESC: return write_defaults(shd_context_desc_default(), ptr, size);
    case SHD_DESC_KIND_IMAGE: return write_defaults(shd_image_default(), ptr, size);
    case SHD_DESC_KIND_TEXTURE_DESC: return write_defaults(shd_texture_desc_default(), ptr, size);
    case SHD_DESC_KIND_TEXTURE_INFO: return write_defaults(shd_texture_info_default(), ptr, size);
    case SHD_DESC_KIND_MIP_DESC: return write_defaults(shd_mip_desc_default(), ptr, size);
    case SHD_DESC_KIND_SAMPLER_DESC: return write_defaults(shd_sampler_desc_default(), ptr, size);
    case SHD_DESC_KIND_LOOKUPS: return write_defaults(shd_lookups_default(), ptr, size);
    case SHD_DESC_KIND_TEXELS: return write_defaults(shd_texels_default(), ptr, size);
    case SHD_DESC_KIND_LEVELS: return write_defaults(shd_levels_default(), ptr, size);
    case SHD_DESC_KIND_EXPLANATION: return write_defaults(shd_explanation_default(), ptr, size);
    case SHD_DESC_KIND_RAY_DIFFERENTIALS: return write_defaults(shd_ray_differentials_default(), ptr, size);
    case SHD_DESC_KIND_RAY_CONES: return write_defaults(shd_ray_cones_default(), ptr, size);
    case SHD_DESC_KIND_DERIVATIVES: return write_defaults(shd_derivatives_default(), ptr, size);
    case SHD_DESC_KIND_MESH_DESC: return write_defaults(shd_mesh_desc_default(), ptr, size);
    case SHD_DESC_KIND_MESH_INFO: return write_defaults(shd_mesh_info_default(), ptr, size);
    case SHD_DESC_KIND_EDGES_DESC: return write_defaults(shd_edges_desc_default(), ptr, size);
    case SHD_DESC_KIND_EDGES: return write_defaults(shd_edges_default(), ptr, size);
    case SHD_DESC_KIND_TESSELLATION_DESC: return write_defaults(shd_tessellation_desc_default(), ptr, size);
    case SHD_DESC_KIND_MATERIAL_DESC: return write_defaults(shd_material_desc_default(), ptr, size);
    case SHD_DESC_KIND_SLOT: return write_defaults(shd_slot_default(SHD_SLOT_DIFFUSE), ptr, size);
    case SHD_DESC_KIND_LIGHT_DESC: return write_defaults(shd_light_desc_default(), ptr, size);
    case SHD_DESC_KIND_SHADOW_DESC: return write_defaults(shd_shadow_desc_default(), ptr, size);
    case SHD_DESC_KIND_SHADOW_RENDER_DESC: return write_defaults(shd_shadow_render_desc_default(), ptr, size);
    case SHD_DESC_KIND_SHADOW_LOOKUPS: return write_defaults(shd_shadow_lookups_default(), ptr, size);
    case SHD_DESC_KIND_FRAMEBUFFER_DESC: return write_defaults(shd_framebuffer_desc_default(), ptr, size);
    case SHD_DESC_KIND_FRAMEBUFFER_INFO: return write_defaults(shd_framebuffer_info_default(), ptr, size);
    case SHD_DESC_KIND_PLANE_VIEW: return write_defaults(shd_plane_view_default(), ptr, size);
    case SHD_DESC_KIND_CAMERA: return write_defaults(shd_camera_default(), ptr, size);
    case SHD_DESC_KIND_DRAW: return write_defaults(shd_draw_default(), ptr, size);
    case SHD_DESC_KIND_RENDER_DESC: return write_defaults(shd_render_desc_default(), ptr, size);
    case SHD_DESC_KIND_RENDER_STATS: return write_defaults(shd_render_stats_default(), ptr, size);
    case SHD_DESC_KIND_COLOR_DESC: return write_defaults(shd_color_desc_default(), ptr, size);
    case SHD_DESC_KIND_LOAD_DESC: return write_defaults(shd_load_desc_default(), ptr, size);
    case SHD_DESC_KIND_SAVE_DESC: return write_defaults(shd_save_desc_default(), ptr, size);
    case SHD_DESC_KIND_BITMAP_INFO: return write_defaults(shd_bitmap_info_default(), ptr, size);
    case SHD_DESC_KIND_RAW_DESC: return write_defaults(shd_raw_desc_default(), ptr, size);
    case SHD_DESC_KIND_STACK_DESC: return write_defaults(shd_stack_desc_default(), ptr, size);
    case SHD_DESC_KIND_VDB_DESC: return write_defaults(shd_vdb_desc_default(), ptr, size);
    case SHD_DESC_KIND_VDB_INFO: return write_defaults(shd_vdb_info_default(), ptr, size);
    case SHD_DESC_KIND_TEXTURE_FILE_INFO: return write_defaults(shd_texture_file_info_default(), ptr, size);
    case SHD_DESC_KIND_KTX2_DESC: return write_defaults(shd_ktx2_desc_default(), ptr, size);
    case SHD_DESC_KIND_SHAPE_DESC: return write_defaults(shd_shape_desc_default(), ptr, size);
    case SHD_DESC_KIND_SHAPE_COLUMNS: return write_defaults(shd_shape_columns_default(), ptr, size);
    case SHD_DESC_KIND_SCENE_DESC: return write_defaults(shd_scene_desc_default(), ptr, size);
    case SHD_DESC_KIND_SCENE_INFO: return write_defaults(shd_scene_info_default(), ptr, size);
    case SHD_DESC_KIND_SCENE_INSTANCE: return write_defaults(shd_scene_instance_default(), ptr, size);
    case SHD_DESC_KIND_SOLID_DESC: return write_defaults(shd_solid_desc_default(), ptr, size);
    case SHD_DESC_KIND_SOLID_POINTS: return write_defaults(shd_solid_points_default(), ptr, size);
    case SHD_DESC_KIND_SOLID_VALUES: return write_defaults(shd_solid_values_default(), ptr, size);
    case SHD_DESC_KIND_POLYGON_DESC: return write_defaults(shd_polygon_desc_default(), ptr, size);
    case SHD_DESC_KIND_POLYGON_POINTS: return write_defaults(shd_polygon_points_default(), ptr, size);
    case SHD_DESC_KIND_POLYGON_WEIGHTS: return write_defaults(shd_polygon_weights_default(), ptr, size);
    case SHD_DESC_KIND_ENVIRONMENT_DESC: return write_defaults(shd_environment_desc_default(), ptr, size);
    case SHD_DESC_KIND_ENVIRONMENT_INFO: return write_defaults(shd_environment_info_default(), ptr, size);
    case SHD_DESC_KIND_ENVIRONMENT_LOOKUPS: return write_defaults(shd_environment_lookups_default(), ptr, size);
    case SHD_DESC_KIND_ENVIRONMENT_LIGHT: return write_defaults(shd_environment_light_default(), ptr, size);
    case SHD_DESC_KIND_DIRECTIONS: return write_defaults(shd_directions_default(), ptr, size);
    case SHD_DESC_KIND_PROJECTED_POINTS: return write_defaults(shd_projected_points_default(), ptr, size);
    case SHD_DESC_KIND_IMAGE_POINTS: return write_defaults(shd_image_points_default(), ptr, size);
    case SHD_DESC_KIND_POINT_DIRECTIONS: return write_defaults(shd_point_directions_default(), ptr, size);
    case SHD_DESC_KIND_DIRECTION_IMAGES: return write_defaults(shd_direction_images_default(), ptr, size);
    case SHD_DESC_KIND_VOLUME_DESC: return write_defaults(shd_volume_desc_default(), ptr, size);
    case SHD_DESC_KIND_VOLUME_DRAW: return write_defaults(shd_volume_draw_default(), ptr, size);
    case SHD_DESC_KIND_BAKE_DESC: return write_defaults(shd_bake_desc_default(), ptr, size);
    case SHD_DESC_KIND_BAKE_STATS: return write_defaults(shd_bake_stats_default(), ptr, size);
    case SHD_DESC_KIND_OCCLUSION_DESC: return write_defaults(shd_occlusion_desc_default(), ptr, size);
    case SHD_DESC_KIND_OCCLUSION_POINTS: return write_defaults(shd_occlusion_points_default(), ptr, size);
    case SHD_DESC_KIND_OCCLUSION_ATLAS: return write_defaults(shd_occlusion_atlas_default(), ptr, size);
    case SHD_DESC_KIND_BOUNDS_DESC: return write_defaults(shd_bounds_desc_default(), ptr, size);
    default:
      return shd::core::fail(SHD_ERROR_INVALID_ARGUMENT, "desc_init.kind: %u is not a desc", shd::abi::enum_bits(kind));
  }
}

}  // extern "C"
