// SPDX-License-Identifier: MIT
/// @file
/// Sizes of the structs that begin with struct_size. Links to nothing.
///
/// Version 0.1 is the first one, so no caller of a released header has less than its layout. The library still accepts
/// smaller structs that contain every required field: later fields have defaults. Only the fields in this table are
/// read from a struct without a check of its struct_size.
///
/// A size is a multiple of the alignment of the struct, as C makes it: other sizes would cut a pointer in two. A field
/// that raises the alignment needs a row that accepts the older sizes too.
///
/// A row names the struct, its last required field, and the size of the struct in 0.1 on LP64. Rows never change once a
/// version is released; tests/abi/resize_headers.py reads them.
#pragma once

#include <cstddef>

#include <shd/color.h>
#include <shd/io.h>
#include <shd/scene.h>
#include <shd/shadow.h>
#include <shd/shd.h>
#include <shd/texture_file.h>
#include <shd/tile_file.h>
#include <shd/volume_file.h>

#include "core/read_desc.h"

namespace shd::core {

/// `kRule` has the struct_size that are accepted, `kFirst` is the size in 0.1.
template <class Desc>
struct DescSize;

constexpr size_t round_up(size_t size, size_t alignment) {
  return (size + alignment - 1) / alignment * alignment;
}

#if defined(__LP64__) || defined(_LP64)
#define SHD_CHECK_FIRST_SIZE(type, size)                                        \
  static_assert(sizeof(type) >= (size), #type " lost a field of 0.1");           \
  static_assert((size) % alignof(type) == 0, #type " has an alignment above that of 0.1")
#else
#define SHD_CHECK_FIRST_SIZE(type, size) static_assert(true, "stated for LP64 only")
#endif
#define SHD_SIZED(type, required, last, size)                                              \
  SHD_CHECK_FIRST_SIZE(type, size);                                                        \
  template <>                                                                              \
  struct DescSize<type> {                                                                  \
    static constexpr size_t kRequired = offsetof(type, required) + sizeof(type::required); \
    static constexpr size_t kFirst = offsetof(type, last) + sizeof(type::last);            \
    static_assert(kRequired <= kFirst, #type);                                             \
    static constexpr SizeRule kRule = {round_up(kRequired, alignof(type)), alignof(type)}; \
  }

// The struct, its last required field, its last field in 0.1, its size in 0.1.
SHD_SIZED(shd_context_desc, simd, log, 80);
SHD_SIZED(shd_image, pixels, row_stride, 32);
SHD_SIZED(shd_texture_desc, texels, levels, 96);
SHD_SIZED(shd_texture_info, height, byte_size, 40);
SHD_SIZED(shd_mip_desc, content, alpha_cutoff, 28);
SHD_SIZED(shd_sampler_desc, filter, precision, 100);
SHD_SIZED(shd_lookups, v, random, 160);
SHD_SIZED(shd_texels, channel, nonfinite_count, 208);
SHD_SIZED(shd_levels, lod, level, 40);
SHD_SIZED(shd_explanation, blend_count, shorter_axis, 136);
SHD_SIZED(shd_ray_differentials, direction, direction_dy, 368);
SHD_SIZED(shd_ray_cones, width, width, 176);
SHD_SIZED(shd_directions, direction, direction_dy, 160);
SHD_SIZED(shd_projected_points, u, nonfinite_count, 128);
SHD_SIZED(shd_image_points, v, face, 64);
SHD_SIZED(shd_point_directions, direction, nonfinite_count, 80);
SHD_SIZED(shd_environment_desc, image, tables, 24);
SHD_SIZED(shd_environment_info, map_size, byte_size, 48);
SHD_SIZED(shd_environment_light, rgb, rgb, 56);
SHD_SIZED(shd_environment_lookups, direction, exponent, 96);
SHD_SIZED(shd_direction_images, images, images, 24);
SHD_SIZED(shd_derivatives, dudx, dvdy, 72);
SHD_SIZED(shd_mesh_desc, position, index_count, 296);
SHD_SIZED(shd_mesh_info, triangle_count, split_count, 52);
SHD_SIZED(shd_edges_desc, edges, crease_cosine, 28);
SHD_SIZED(shd_edges, vertex, kinds, 88);
SHD_SIZED(shd_tessellation_desc, mode, normals, 80);
SHD_SIZED(shd_material_desc, model, clearcoat_roughness, 224);
SHD_SIZED(shd_slot, user_data, place_width, 160);
SHD_SIZED(shd_light_desc, position, sampler, 96);
SHD_SIZED(shd_shadow_desc, filter, min_variance, 48);
SHD_SIZED(shd_shadow_render_desc, light, bounds_max, 64);
SHD_SIZED(shd_shadow_lookups, position, normal, 112);
SHD_SIZED(shd_framebuffer_desc, height, aovs, 20);
SHD_SIZED(shd_framebuffer_info, height, byte_size, 32);
SHD_SIZED(shd_plane_view, f32, row_stride, 32);
SHD_SIZED(shd_camera, target, far_plane, 56);
SHD_SIZED(shd_draw, mesh, crease_cosine, 152);
SHD_SIZED(shd_render_desc, framebuffer, background_roughness, 368);
SHD_SIZED(shd_render_stats, rasterised, tile_seconds, 144);
SHD_SIZED(shd_color_desc, config_path, working_space, 32);
SHD_SIZED(shd_load_desc, formats, worker_path, 72);
SHD_SIZED(shd_save_desc, bit_depth, display, 32);
SHD_SIZED(shd_bitmap_info, file_format, flags, 16);
SHD_SIZED(shd_tile_file_desc, cache, fill, 40);
SHD_SIZED(shd_tile_file_info, files, tile_height, 24);
SHD_SIZED(shd_raw_desc, depth, header_bytes, 40);
SHD_SIZED(shd_stack_desc, pattern, last, 32);
SHD_SIZED(shd_vdb_desc, flags, box_max, 40);
SHD_SIZED(shd_vdb_info, background, grid, 160);
SHD_SIZED(shd_texture_file_info, level_count, level_count, 48);
SHD_SIZED(shd_ktx2_desc, supercompression, channels, 16);
SHD_SIZED(shd_shape_desc, shape, segments, 40);
SHD_SIZED(shd_shape_columns, position, indices, 160);
SHD_SIZED(shd_scene_desc, flags, time_limit, 88);
SHD_SIZED(shd_scene_info, instance_count, bounds_max, 72);
SHD_SIZED(shd_scene_instance, object_to_world, object_to_world, 76);
SHD_SIZED(shd_polygon_desc, vertex_count, segments, 48);
SHD_SIZED(shd_polygon_points, position, position, 48);
SHD_SIZED(shd_polygon_weights, weight, nonfinite_count, 32);
SHD_SIZED(shd_solid_desc, kind, colors, 188);
SHD_SIZED(shd_solid_points, position, width, 80);
SHD_SIZED(shd_solid_values, value, nonfinite_count, 144);
SHD_SIZED(shd_volume_desc, extinction, flags, 144);
SHD_SIZED(shd_volume_draw, volume, object_to_world, 80);
SHD_SIZED(shd_bake_desc, dilation, stats, 40);
SHD_SIZED(shd_bake_stats, triangles, nonfinite_texels, 80);
SHD_SIZED(shd_occlusion_desc, rays, draw_count, 56);
SHD_SIZED(shd_occlusion_points, normal, normal, 112);
SHD_SIZED(shd_occlusion_atlas, height, stats, 64);
SHD_SIZED(shd_bounds_desc, srgb_error, srgb_error, 44);
SHD_SIZED(shd_tile_cache_desc, struct_size, budget_bytes, 16);
SHD_SIZED(shd_tile_cache_stats, struct_size, waits, 80);
SHD_SIZED(shd_tile_region, height, height, 28);
#undef SHD_SIZED
#undef SHD_CHECK_FIRST_SIZE

}  // namespace shd::core
