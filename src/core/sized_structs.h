// SPDX-License-Identifier: MIT
/// @file
/// The table of the structs that begin with struct_size. C and C++ read it, and tests/abi/resize_headers.py.
///
/// A row has the kind of the struct (SHD_DESC_KIND_...), the struct, its last required field, its last field in 0.1,
/// and its size in 0.1 on LP64. The rows are in the order of shd_desc_kind.
/// Kind, fields and size never change once a version is released. style.abi_structs compares the rows with the headers.
#pragma once

#define SHD_SIZED_STRUCTS(ROW)                                                      \
  ROW(CONTEXT_DESC, shd_context_desc, simd, log, 88)                                \
  ROW(IMAGE, shd_image, pixels, row_stride, 32)                                     \
  ROW(TEXTURE_DESC, shd_texture_desc, texels, tiles, 152)                           \
  ROW(TEXTURE_INFO, shd_texture_info, height, byte_size, 64)                        \
  ROW(MIP_DESC, shd_mip_desc, content, alpha_cutoff, 28)                            \
  ROW(SAMPLER_DESC, shd_sampler_desc, filter, missing_tiles, 132)                   \
  ROW(LOOKUPS, shd_lookups, v, reference, 224)                                      \
  ROW(TEXELS, shd_texels, channel, nonfinite_count, 288)                            \
  ROW(LEVELS, shd_levels, lod, nonfinite_count, 48)                                 \
  ROW(EXPLANATION, shd_explanation, blend_count, shorter_axis, 160)                 \
  ROW(RAY_DIFFERENTIALS, shd_ray_differentials, direction, direction_dy, 368)       \
  ROW(RAY_CONES, shd_ray_cones, width, width, 176)                                  \
  ROW(DERIVATIVES, shd_derivatives, dudx, nonfinite_count, 80)                      \
  ROW(MESH_DESC, shd_mesh_desc, position, index_count, 376)                         \
  ROW(MESH_INFO, shd_mesh_info, triangle_count, split_count, 80)                    \
  ROW(EDGES_DESC, shd_edges_desc, edges, crease_cosine, 28)                         \
  ROW(EDGES, shd_edges, vertex, kinds, 88)                                          \
  ROW(TESSELLATION_DESC, shd_tessellation_desc, mode, normals, 280)                 \
  ROW(MATERIAL_DESC, shd_material_desc, model, varying_count, 224)                  \
  ROW(SLOT, shd_slot, user_data, triplanar_sharpness, 176)                          \
  ROW(LIGHT_DESC, shd_light_desc, position, sampler, 96)                            \
  ROW(SHADOW_DESC, shd_shadow_desc, filter, min_variance, 48)                       \
  ROW(SHADOW_RENDER_DESC, shd_shadow_render_desc, light, bounds_max, 64)            \
  ROW(SHADOW_LOOKUPS, shd_shadow_lookups, position, normal, 112)                    \
  ROW(SHADOW_VALUES, shd_shadow_values, visibility, nonfinite_count, 32)            \
  ROW(FRAMEBUFFER_DESC, shd_framebuffer_desc, height, sample_count, 32)             \
  ROW(FRAMEBUFFER_INFO, shd_framebuffer_info, height, byte_size, 40)                \
  ROW(PLANE_VIEW, shd_plane_view, f32, row_stride, 32)                              \
  ROW(CAMERA, shd_camera, target, far_plane, 56)                                    \
  ROW(DRAW, shd_draw, mesh, crease_cosine, 152)                                     \
  ROW(RENDER_DESC, shd_render_desc, framebuffer, present, 392)                      \
  ROW(RENDER_STATS, shd_render_stats, rasterized_triangle_count, tile_seconds, 152) \
  ROW(COLOR_DESC, shd_color_desc, config_path, working_space, 32)                   \
  ROW(LOAD_DESC, shd_load_desc, formats, vdb_info, 112)                             \
  ROW(SAVE_DESC, shd_save_desc, bit_depth, compression, 80)                         \
  ROW(BITMAP_INFO, shd_bitmap_info, file_format, channel_count, 24)                 \
  ROW(SHAPE_DESC, shd_shape_desc, kind, segments, 40)                               \
  ROW(SHAPE_COLUMNS, shd_shape_columns, position, indices, 168)                     \
  ROW(SCENE_DESC, shd_scene_desc, flags, user_data, 112)                            \
  ROW(SCENE_INFO, shd_scene_info, instance_count, origin, 144)                      \
  ROW(SCENE_INSTANCE, shd_scene_instance, object_to_world, object_to_world, 88)     \
  ROW(SOLID_DESC, shd_solid_desc, kind, colors, 192)                                \
  ROW(SOLID_POINTS, shd_solid_points, position, width, 80)                          \
  ROW(SOLID_VALUES, shd_solid_values, value, nonfinite_count, 144)                  \
  ROW(DIRECTIONS, shd_directions, direction, direction_dy, 160)                     \
  ROW(PROJECTED_POINTS, shd_projected_points, u, nonfinite_count, 128)              \
  ROW(IMAGE_POINTS, shd_image_points, v, face, 64)                                  \
  ROW(POINT_DIRECTIONS, shd_point_directions, direction, nonfinite_count, 80)       \
  ROW(VOLUME_DESC, shd_volume_desc, extinction, seed, 144)                          \
  ROW(VOLUME_DRAW, shd_volume_draw, volume, object_to_world, 80)                    \
  ROW(ENVIRONMENT_DESC, shd_environment_desc, image, tables, 24)                    \
  ROW(ENVIRONMENT_INFO, shd_environment_info, map_size, byte_size, 48)              \
  ROW(ENVIRONMENT_LOOKUPS, shd_environment_lookups, direction, exponent, 96)        \
  ROW(ENVIRONMENT_VALUES, shd_environment_values, channel, nonfinite_count, 64)     \
  ROW(DIRECTION_IMAGES, shd_direction_images, images, images, 24)                   \
  ROW(POLYGON_DESC, shd_polygon_desc, vertex_count, vertex_count, 56)               \
  ROW(POLYGON_POINTS, shd_polygon_points, position, position, 48)                   \
  ROW(POLYGON_WEIGHTS, shd_polygon_weights, weight, nonfinite_count, 40)            \
  ROW(RAW_DESC, shd_raw_desc, depth, header_bytes, 48)                              \
  ROW(STACK_DESC, shd_stack_desc, pattern, last, 40)                                \
  ROW(VDB_DESC, shd_vdb_desc, flags, bounds_max, 40)                                \
  ROW(VDB_INFO, shd_vdb_info, background, grid, 160)                                \
  ROW(BAKE_DESC, shd_bake_desc, dilation, stats, 40)                                \
  ROW(BAKE_STATS, shd_bake_stats, triangle_count, nonfinite_texel_count, 80)        \
  ROW(OCCLUSION_DESC, shd_occlusion_desc, ray_count, draw_count, 64)                \
  ROW(OCCLUSION_POINTS, shd_occlusion_points, normal, normal, 112)                  \
  ROW(OCCLUSION_VALUES, shd_occlusion_values, visibility, nonfinite_count, 32)      \
  ROW(OCCLUSION_ATLAS, shd_occlusion_atlas, height, stats, 64)                      \
  ROW(BOUNDS_DESC, shd_bounds_desc, srgb_error, srgb_error, 44)                     \
  ROW(TEXTURE_FILE_INFO, shd_texture_file_info, level_count, level_count, 64)       \
  ROW(KTX2_DESC, shd_ktx2_desc, supercompression, channel_count, 24)                \
  ROW(TILE_REGION, shd_tile_region, area, area, 28)                                 \
  ROW(TILE_CACHE_DESC, shd_tile_cache_desc, struct_size, budget_bytes, 16)          \
  ROW(TILE_CACHE_STATS, shd_tile_cache_stats, struct_size, wait_count, 96)          \
  ROW(TILE_FILE_DESC, shd_tile_file_desc, cache, fill, 40)                          \
  ROW(TILE_FILE_INFO, shd_tile_file_info, file_count, tile_height, 40)              \
  ROW(NORMALS_DESC, shd_normals_desc, scale, wrap_v, 20)                            \
  ROW(POLYHEDRON_DESC, shd_polyhedron_desc, indices, indices, 88)                   \
  ROW(POLYHEDRON_POINTS, shd_polyhedron_points, position, position, 64)             \
  ROW(POLYHEDRON_WEIGHTS, shd_polyhedron_weights, weight, nonfinite_count, 40)      \
  ROW(POLYHEDRON_VALUES, shd_polyhedron_values, value, nonfinite_count, 48)         \
  ROW(TABLE_DESC, shd_table_desc, table, level_v, 24)                               \
  ROW(TABLE_INFO, shd_table_info, height, y, 28)                                    \
  ROW(SHADOW_INFO, shd_shadow_info, height, byte_size, 40)
