// SPDX-License-Identifier: MIT
//! Sizes and offsets of the structs are those of the C headers on 64-bit machines. Written by generate.py; do not edit.
#![cfg(target_pointer_width = "64")]
use std::mem::MaybeUninit;
use std::ptr::addr_of;

use shd_sys::*;

macro_rules! offset {
    ($type:ty, $field:tt, $offset:expr) => {
        let place = MaybeUninit::<$type>::uninit();
        let base = place.as_ptr();
        // The field is never read; only its address is taken.
        let field = unsafe { addr_of!((*base).$field) } as usize;
        assert_eq!(field - base as usize, $offset, "{}.{}", stringify!($type), stringify!($field));
    };
}

#[test]
fn shd_bake_stats_offsets() {
    offset!(shd_bake_stats, struct_size, 0);
    offset!(shd_bake_stats, triangles, 8);
    offset!(shd_bake_stats, zero_area_triangles, 16);
    offset!(shd_bake_stats, nonfinite_triangles, 24);
    offset!(shd_bake_stats, outside_triangles, 32);
    offset!(shd_bake_stats, centre_texels, 40);
    offset!(shd_bake_stats, touched_texels, 48);
    offset!(shd_bake_stats, dilated_texels, 56);
    offset!(shd_bake_stats, overlapping_texels, 64);
    offset!(shd_bake_stats, nonfinite_texels, 72);
}

#[test]
fn shd_bake_desc_offsets() {
    offset!(shd_bake_desc, struct_size, 0);
    offset!(shd_bake_desc, uv_set, 4);
    offset!(shd_bake_desc, dilation, 8);
    offset!(shd_bake_desc, flags, 12);
    offset!(shd_bake_desc, states, 16);
    offset!(shd_bake_desc, stats, 32);
}

#[test]
fn shd_bounds_desc_offsets() {
    offset!(shd_bounds_desc, struct_size, 0);
    offset!(shd_bounds_desc, level_rules, 4);
    offset!(shd_bounds_desc, subtexel_bits, 8);
    offset!(shd_bounds_desc, level_bits, 12);
    offset!(shd_bounds_desc, weight_bits, 16);
    offset!(shd_bounds_desc, result_bits, 20);
    offset!(shd_bounds_desc, coordinate_error, 24);
    offset!(shd_bounds_desc, derivative_error, 28);
    offset!(shd_bounds_desc, level_error, 32);
    offset!(shd_bounds_desc, relative_error, 36);
    offset!(shd_bounds_desc, srgb_error, 40);
}

#[test]
fn shd_color_desc_offsets() {
    offset!(shd_color_desc, struct_size, 0);
    offset!(shd_color_desc, display_precision, 4);
    offset!(shd_color_desc, config_path, 8);
    offset!(shd_color_desc, config_text, 16);
    offset!(shd_color_desc, working_space, 24);
}

#[test]
fn shd_color_view_offsets() {
    offset!(shd_color_view, color, 0);
    offset!(shd_color_view, display, 8);
    offset!(shd_color_view, view, 16);
}

#[test]
fn shd_f32_in_offsets() {
    offset!(shd_f32_in, data, 0);
    offset!(shd_f32_in, stride, 8);
}

#[test]
fn shd_f32_out_offsets() {
    offset!(shd_f32_out, data, 0);
    offset!(shd_f32_out, stride, 8);
}

#[test]
fn shd_u32_in_offsets() {
    offset!(shd_u32_in, data, 0);
    offset!(shd_u32_in, stride, 8);
}

#[test]
fn shd_u32_out_offsets() {
    offset!(shd_u32_out, data, 0);
    offset!(shd_u32_out, stride, 8);
}

#[test]
fn shd_u16_in_offsets() {
    offset!(shd_u16_in, data, 0);
    offset!(shd_u16_in, stride, 8);
}

#[test]
fn shd_allocator_offsets() {
    offset!(shd_allocator, allocate, 0);
    offset!(shd_allocator, free, 8);
    offset!(shd_allocator, user_data, 16);
}

#[test]
fn shd_executor_offsets() {
    offset!(shd_executor, parallel_for, 0);
    offset!(shd_executor, user_data, 8);
    offset!(shd_executor, worker_count, 16);
}

#[test]
fn shd_log_offsets() {
    offset!(shd_log, write, 0);
    offset!(shd_log, user_data, 8);
}

#[test]
fn shd_context_desc_offsets() {
    offset!(shd_context_desc, struct_size, 0);
    offset!(shd_context_desc, flags, 4);
    offset!(shd_context_desc, worker_count, 8);
    offset!(shd_context_desc, simd, 12);
    offset!(shd_context_desc, allocator, 16);
    offset!(shd_context_desc, executor, 40);
    offset!(shd_context_desc, log, 64);
}

#[test]
fn shd_edges_desc_offsets() {
    offset!(shd_edges_desc, struct_size, 0);
    offset!(shd_edges_desc, edges, 4);
    offset!(shd_edges_desc, eye, 8);
    offset!(shd_edges_desc, crease_cosine, 24);
}

#[test]
fn shd_edges_offsets() {
    offset!(shd_edges, struct_size, 0);
    offset!(shd_edges, vertex, 8);
    offset!(shd_edges, triangle, 40);
    offset!(shd_edges, kinds, 72);
}

#[test]
fn shd_environment_desc_offsets() {
    offset!(shd_environment_desc, struct_size, 0);
    offset!(shd_environment_desc, projection, 4);
    offset!(shd_environment_desc, image, 8);
    offset!(shd_environment_desc, irradiance, 16);
    offset!(shd_environment_desc, tables, 20);
}

#[test]
fn shd_environment_info_offsets() {
    offset!(shd_environment_info, struct_size, 0);
    offset!(shd_environment_info, projection, 4);
    offset!(shd_environment_info, irradiance, 8);
    offset!(shd_environment_info, tables, 12);
    offset!(shd_environment_info, map_size, 16);
    offset!(shd_environment_info, mean, 20);
    offset!(shd_environment_info, replaced_count, 32);
    offset!(shd_environment_info, byte_size, 40);
}

#[test]
fn shd_environment_lookups_offsets() {
    offset!(shd_environment_lookups, struct_size, 0);
    offset!(shd_environment_lookups, count, 8);
    offset!(shd_environment_lookups, direction, 16);
    offset!(shd_environment_lookups, roughness, 64);
    offset!(shd_environment_lookups, exponent, 80);
}

#[test]
fn shd_environment_light_offsets() {
    offset!(shd_environment_light, struct_size, 0);
    offset!(shd_environment_light, rgb, 8);
}

#[test]
fn shd_tap_offsets() {
    offset!(shd_tap, layer, 0);
    offset!(shd_tap, level_u, 4);
    offset!(shd_tap, level_v, 8);
    offset!(shd_tap, x, 12);
    offset!(shd_tap, y, 16);
    offset!(shd_tap, border, 20);
    offset!(shd_tap, weight, 24);
    offset!(shd_tap, value, 28);
    offset!(shd_tap, z, 44);
}

#[test]
fn shd_blend_step_offsets() {
    offset!(shd_blend_step, a, 0);
    offset!(shd_blend_step, b, 4);
    offset!(shd_blend_step, s, 8);
}

#[test]
fn shd_explanation_offsets() {
    offset!(shd_explanation, struct_size, 0);
    offset!(shd_explanation, taps, 8);
    offset!(shd_explanation, blends, 16);
    offset!(shd_explanation, tap_size, 24);
    offset!(shd_explanation, tap_capacity, 28);
    offset!(shd_explanation, tap_count, 32);
    offset!(shd_explanation, blend_size, 36);
    offset!(shd_explanation, blend_capacity, 40);
    offset!(shd_explanation, blend_count, 44);
    offset!(shd_explanation, filter, 48);
    offset!(shd_explanation, result, 52);
    offset!(shd_explanation, lod, 68);
    offset!(shd_explanation, scale_high, 72);
    offset!(shd_explanation, scale_low, 88);
    offset!(shd_explanation, channel_source, 104);
    offset!(shd_explanation, longer_axis, 120);
    offset!(shd_explanation, shorter_axis, 128);
}

#[test]
fn shd_derivatives_offsets() {
    offset!(shd_derivatives, struct_size, 0);
    offset!(shd_derivatives, dudx, 8);
    offset!(shd_derivatives, dvdx, 24);
    offset!(shd_derivatives, dudy, 40);
    offset!(shd_derivatives, dvdy, 56);
}

#[test]
fn shd_ray_differentials_offsets() {
    offset!(shd_ray_differentials, struct_size, 0);
    offset!(shd_ray_differentials, count, 8);
    offset!(shd_ray_differentials, dpdu, 16);
    offset!(shd_ray_differentials, dpdv, 64);
    offset!(shd_ray_differentials, direction, 112);
    offset!(shd_ray_differentials, distance, 160);
    offset!(shd_ray_differentials, origin_dx, 176);
    offset!(shd_ray_differentials, origin_dy, 224);
    offset!(shd_ray_differentials, direction_dx, 272);
    offset!(shd_ray_differentials, direction_dy, 320);
}

#[test]
fn shd_ray_cones_offsets() {
    offset!(shd_ray_cones, struct_size, 0);
    offset!(shd_ray_cones, count, 8);
    offset!(shd_ray_cones, dpdu, 16);
    offset!(shd_ray_cones, dpdv, 64);
    offset!(shd_ray_cones, direction, 112);
    offset!(shd_ray_cones, width, 160);
}

#[test]
fn shd_fragments_offsets() {
    offset!(shd_fragments, struct_size, 0);
    offset!(shd_fragments, draw, 4);
    offset!(shd_fragments, instance, 8);
    offset!(shd_fragments, varying_count, 12);
    offset!(shd_fragments, attribute_count, 16);
    offset!(shd_fragments, count, 24);
    offset!(shd_fragments, uniforms, 32);
    offset!(shd_fragments, x, 40);
    offset!(shd_fragments, y, 48);
    offset!(shd_fragments, depth, 56);
    offset!(shd_fragments, triangle, 64);
    offset!(shd_fragments, px, 72);
    offset!(shd_fragments, py, 80);
    offset!(shd_fragments, pz, 88);
    offset!(shd_fragments, nx, 96);
    offset!(shd_fragments, ny, 104);
    offset!(shd_fragments, nz, 112);
    offset!(shd_fragments, ox, 120);
    offset!(shd_fragments, oy, 128);
    offset!(shd_fragments, oz, 136);
    offset!(shd_fragments, tx, 144);
    offset!(shd_fragments, ty, 152);
    offset!(shd_fragments, tz, 160);
    offset!(shd_fragments, tw, 168);
    offset!(shd_fragments, u, 176);
    offset!(shd_fragments, v, 184);
    offset!(shd_fragments, u1, 192);
    offset!(shd_fragments, v1, 200);
    offset!(shd_fragments, dudx, 208);
    offset!(shd_fragments, dvdx, 216);
    offset!(shd_fragments, dudy, 224);
    offset!(shd_fragments, dvdy, 232);
    offset!(shd_fragments, attribute, 240);
    offset!(shd_fragments, varying, 248);
}

#[test]
fn shd_radiance_offsets() {
    offset!(shd_radiance, struct_size, 0);
    offset!(shd_radiance, target_count, 4);
    offset!(shd_radiance, r, 8);
    offset!(shd_radiance, g, 16);
    offset!(shd_radiance, b, 24);
    offset!(shd_radiance, a, 32);
    offset!(shd_radiance, discard, 40);
    offset!(shd_radiance, target, 48);
}

#[test]
fn shd_framebuffer_desc_offsets() {
    offset!(shd_framebuffer_desc, struct_size, 0);
    offset!(shd_framebuffer_desc, width, 4);
    offset!(shd_framebuffer_desc, height, 8);
    offset!(shd_framebuffer_desc, samples, 12);
    offset!(shd_framebuffer_desc, aovs, 16);
    offset!(shd_framebuffer_desc, color_format, 20);
}

#[test]
fn shd_framebuffer_info_offsets() {
    offset!(shd_framebuffer_info, struct_size, 0);
    offset!(shd_framebuffer_info, width, 4);
    offset!(shd_framebuffer_info, height, 8);
    offset!(shd_framebuffer_info, samples, 12);
    offset!(shd_framebuffer_info, aovs, 16);
    offset!(shd_framebuffer_info, color_format, 20);
    offset!(shd_framebuffer_info, byte_size, 24);
}

#[test]
fn shd_plane_view_offsets() {
    offset!(shd_plane_view, struct_size, 0);
    offset!(shd_plane_view, f32, 8);
    offset!(shd_plane_view, u32, 16);
    offset!(shd_plane_view, row_stride, 24);
}

#[test]
fn shd_display_offsets() {
    offset!(shd_display, apply, 0);
    offset!(shd_display, user_data, 8);
}

#[test]
fn shd_image_offsets() {
    offset!(shd_image, struct_size, 0);
    offset!(shd_image, format, 4);
    offset!(shd_image, width, 8);
    offset!(shd_image, height, 12);
    offset!(shd_image, pixels, 16);
    offset!(shd_image, row_stride, 24);
}

#[test]
fn shd_load_desc_offsets() {
    offset!(shd_load_desc, struct_size, 0);
    offset!(shd_load_desc, formats, 4);
    offset!(shd_load_desc, flags, 8);
    offset!(shd_load_desc, color_space, 12);
    offset!(shd_load_desc, tables, 16);
    offset!(shd_load_desc, subimage, 20);
    offset!(shd_load_desc, max_file_bytes, 24);
    offset!(shd_load_desc, max_pixels, 32);
    offset!(shd_load_desc, max_bytes, 40);
    offset!(shd_load_desc, max_ratio, 48);
    offset!(shd_load_desc, time_limit, 56);
    offset!(shd_load_desc, worker_path, 64);
    offset!(shd_load_desc, raw, 72);
    offset!(shd_load_desc, stack, 80);
    offset!(shd_load_desc, vdb, 88);
    offset!(shd_load_desc, info, 96);
    offset!(shd_load_desc, vdb_info, 104);
}

#[test]
fn shd_bitmap_info_offsets() {
    offset!(shd_bitmap_info, struct_size, 0);
    offset!(shd_bitmap_info, file_format, 4);
    offset!(shd_bitmap_info, channels, 8);
    offset!(shd_bitmap_info, flags, 12);
}

#[test]
fn shd_save_desc_offsets() {
    offset!(shd_save_desc, struct_size, 0);
    offset!(shd_save_desc, bit_depth, 4);
    offset!(shd_save_desc, color_space, 8);
    offset!(shd_save_desc, dither, 12);
    offset!(shd_save_desc, display, 16);
}

#[test]
fn shd_light_desc_offsets() {
    offset!(shd_light_desc, struct_size, 0);
    offset!(shd_light_desc, kind, 4);
    offset!(shd_light_desc, intensity, 8);
    offset!(shd_light_desc, position, 20);
    offset!(shd_light_desc, direction, 32);
    offset!(shd_light_desc, range, 44);
    offset!(shd_light_desc, inner_angle, 48);
    offset!(shd_light_desc, outer_angle, 52);
    offset!(shd_light_desc, up, 56);
    offset!(shd_light_desc, extent, 68);
    offset!(shd_light_desc, texture, 80);
    offset!(shd_light_desc, sampler, 88);
}

#[test]
fn shd_lookups_offsets() {
    offset!(shd_lookups, struct_size, 0);
    offset!(shd_lookups, count, 8);
    offset!(shd_lookups, u, 16);
    offset!(shd_lookups, v, 32);
    offset!(shd_lookups, dudx, 48);
    offset!(shd_lookups, dvdx, 64);
    offset!(shd_lookups, dudy, 80);
    offset!(shd_lookups, dvdy, 96);
    offset!(shd_lookups, lod, 112);
    offset!(shd_lookups, layer, 128);
    offset!(shd_lookups, random, 144);
    offset!(shd_lookups, w, 160);
    offset!(shd_lookups, dwdx, 176);
    offset!(shd_lookups, dwdy, 192);
    offset!(shd_lookups, reference, 208);
}

#[test]
fn shd_texels_offsets() {
    offset!(shd_texels, struct_size, 0);
    offset!(shd_texels, channel, 8);
    offset!(shd_texels, du, 72);
    offset!(shd_texels, dv, 136);
    offset!(shd_texels, nonfinite_count, 200);
    offset!(shd_texels, dw, 208);
    offset!(shd_texels, coarser, 272);
}

#[test]
fn shd_levels_offsets() {
    offset!(shd_levels, struct_size, 0);
    offset!(shd_levels, lod, 8);
    offset!(shd_levels, level, 24);
}

#[test]
fn shd_material_program_offsets() {
    offset!(shd_material_program, fragment, 0);
    offset!(shd_material_program, vertex, 8);
    offset!(shd_material_program, user_data, 16);
}

#[test]
fn shd_material_desc_offsets() {
    offset!(shd_material_desc, struct_size, 0);
    offset!(shd_material_desc, model, 4);
    offset!(shd_material_desc, debug_view, 8);
    offset!(shd_material_desc, flags, 12);
    offset!(shd_material_desc, ambient, 16);
    offset!(shd_material_desc, ambient_share, 28);
    offset!(shd_material_desc, diffuse, 32);
    offset!(shd_material_desc, specular, 44);
    offset!(shd_material_desc, exponent, 56);
    offset!(shd_material_desc, metallic, 60);
    offset!(shd_material_desc, roughness, 64);
    offset!(shd_material_desc, ior, 68);
    offset!(shd_material_desc, emission, 72);
    offset!(shd_material_desc, opacity, 84);
    offset!(shd_material_desc, occlusion_strength, 88);
    offset!(shd_material_desc, slots, 96);
    offset!(shd_material_desc, slot_count, 104);
    offset!(shd_material_desc, normal_encoding, 108);
    offset!(shd_material_desc, normal_scale, 112);
    offset!(shd_material_desc, bump, 116);
    offset!(shd_material_desc, bump_scale, 120);
    offset!(shd_material_desc, parallax_depth, 124);
    offset!(shd_material_desc, parallax_steps, 128);
    offset!(shd_material_desc, warm, 132);
    offset!(shd_material_desc, cool, 144);
    offset!(shd_material_desc, warm_mix, 156);
    offset!(shd_material_desc, cool_mix, 160);
    offset!(shd_material_desc, toon_steps, 164);
    offset!(shd_material_desc, blend, 168);
    offset!(shd_material_desc, alpha_cutoff, 172);
    offset!(shd_material_desc, program, 176);
    offset!(shd_material_desc, interpolation, 200);
    offset!(shd_material_desc, varying_count, 208);
    offset!(shd_material_desc, clearcoat, 216);
    offset!(shd_material_desc, clearcoat_roughness, 220);
}

#[test]
fn shd_mesh_desc_offsets() {
    offset!(shd_mesh_desc, struct_size, 0);
    offset!(shd_mesh_desc, vertex_count, 4);
    offset!(shd_mesh_desc, position, 8);
    offset!(shd_mesh_desc, normal, 56);
    offset!(shd_mesh_desc, normal_weight, 104);
    offset!(shd_mesh_desc, flags, 108);
    offset!(shd_mesh_desc, tangent, 112);
    offset!(shd_mesh_desc, uv, 176);
    offset!(shd_mesh_desc, uv1, 208);
    offset!(shd_mesh_desc, attributes, 240);
    offset!(shd_mesh_desc, attribute_count, 248);
    offset!(shd_mesh_desc, topology, 252);
    offset!(shd_mesh_desc, indices, 256);
    offset!(shd_mesh_desc, indices16, 272);
    offset!(shd_mesh_desc, index_count, 288);
}

#[test]
fn shd_mesh_info_offsets() {
    offset!(shd_mesh_info, struct_size, 0);
    offset!(shd_mesh_info, vertex_count, 4);
    offset!(shd_mesh_info, triangle_count, 8);
    offset!(shd_mesh_info, bounds_min, 12);
    offset!(shd_mesh_info, bounds_max, 24);
    offset!(shd_mesh_info, nonfinite_count, 36);
    offset!(shd_mesh_info, normalless_count, 40);
    offset!(shd_mesh_info, tangentless_count, 44);
    offset!(shd_mesh_info, split_count, 48);
}

#[test]
fn shd_mip_desc_offsets() {
    offset!(shd_mip_desc, struct_size, 0);
    offset!(shd_mip_desc, content, 4);
    offset!(shd_mip_desc, kernel, 8);
    offset!(shd_mip_desc, source, 12);
    offset!(shd_mip_desc, wrap_u, 16);
    offset!(shd_mip_desc, wrap_v, 20);
    offset!(shd_mip_desc, alpha_cutoff, 24);
}

#[test]
fn shd_rays_offsets() {
    offset!(shd_rays, struct_size, 0);
    offset!(shd_rays, count, 8);
    offset!(shd_rays, ox, 16);
    offset!(shd_rays, oy, 24);
    offset!(shd_rays, oz, 32);
    offset!(shd_rays, dx, 40);
    offset!(shd_rays, dy, 48);
    offset!(shd_rays, dz, 56);
    offset!(shd_rays, length, 64);
}

#[test]
fn shd_tracer_offsets() {
    offset!(shd_tracer, trace, 0);
    offset!(shd_tracer, user_data, 8);
}

#[test]
fn shd_occlusion_desc_offsets() {
    offset!(shd_occlusion_desc, struct_size, 0);
    offset!(shd_occlusion_desc, rays, 4);
    offset!(shd_occlusion_desc, seed, 8);
    offset!(shd_occlusion_desc, radius, 12);
    offset!(shd_occlusion_desc, bias, 16);
    offset!(shd_occlusion_desc, map_size, 20);
    offset!(shd_occlusion_desc, tracer, 24);
    offset!(shd_occlusion_desc, draws, 40);
    offset!(shd_occlusion_desc, draw_count, 48);
}

#[test]
fn shd_occlusion_points_offsets() {
    offset!(shd_occlusion_points, struct_size, 0);
    offset!(shd_occlusion_points, count, 8);
    offset!(shd_occlusion_points, position, 16);
    offset!(shd_occlusion_points, normal, 64);
}

#[test]
fn shd_occlusion_atlas_offsets() {
    offset!(shd_occlusion_atlas, struct_size, 0);
    offset!(shd_occlusion_atlas, width, 4);
    offset!(shd_occlusion_atlas, height, 8);
    offset!(shd_occlusion_atlas, uv_set, 12);
    offset!(shd_occlusion_atlas, dilation, 16);
    offset!(shd_occlusion_atlas, empty, 20);
    offset!(shd_occlusion_atlas, draws, 24);
    offset!(shd_occlusion_atlas, draw_count, 32);
    offset!(shd_occlusion_atlas, states, 40);
    offset!(shd_occlusion_atlas, stats, 56);
}

#[test]
fn shd_polygon_desc_offsets() {
    offset!(shd_polygon_desc, struct_size, 0);
    offset!(shd_polygon_desc, kind, 4);
    offset!(shd_polygon_desc, vertex, 8);
    offset!(shd_polygon_desc, vertex_count, 40);
    offset!(shd_polygon_desc, segments, 44);
}

#[test]
fn shd_polygon_points_offsets() {
    offset!(shd_polygon_points, struct_size, 0);
    offset!(shd_polygon_points, count, 8);
    offset!(shd_polygon_points, position, 16);
}

#[test]
fn shd_polygon_weights_offsets() {
    offset!(shd_polygon_weights, struct_size, 0);
    offset!(shd_polygon_weights, weight_count, 4);
    offset!(shd_polygon_weights, weight, 8);
    offset!(shd_polygon_weights, outside_count, 16);
    offset!(shd_polygon_weights, nonfinite_count, 24);
}

#[test]
fn shd_present_tile_offsets() {
    offset!(shd_present_tile, struct_size, 0);
    offset!(shd_present_tile, worker, 4);
    offset!(shd_present_tile, x, 8);
    offset!(shd_present_tile, y, 12);
    offset!(shd_present_tile, width, 16);
    offset!(shd_present_tile, height, 20);
    offset!(shd_present_tile, channel, 24);
    offset!(shd_present_tile, row_stride, 56);
}

#[test]
fn shd_present_offsets() {
    offset!(shd_present, tile, 0);
    offset!(shd_present, user_data, 8);
}

#[test]
fn shd_directions_offsets() {
    offset!(shd_directions, struct_size, 0);
    offset!(shd_directions, projection, 4);
    offset!(shd_directions, count, 8);
    offset!(shd_directions, direction, 16);
    offset!(shd_directions, direction_dx, 64);
    offset!(shd_directions, direction_dy, 112);
}

#[test]
fn shd_projected_points_offsets() {
    offset!(shd_projected_points, struct_size, 0);
    offset!(shd_projected_points, u, 8);
    offset!(shd_projected_points, v, 24);
    offset!(shd_projected_points, face, 40);
    offset!(shd_projected_points, dudx, 56);
    offset!(shd_projected_points, dvdx, 72);
    offset!(shd_projected_points, dudy, 88);
    offset!(shd_projected_points, dvdy, 104);
    offset!(shd_projected_points, nonfinite_count, 120);
}

#[test]
fn shd_image_points_offsets() {
    offset!(shd_image_points, struct_size, 0);
    offset!(shd_image_points, projection, 4);
    offset!(shd_image_points, count, 8);
    offset!(shd_image_points, u, 16);
    offset!(shd_image_points, v, 32);
    offset!(shd_image_points, face, 48);
}

#[test]
fn shd_point_directions_offsets() {
    offset!(shd_point_directions, struct_size, 0);
    offset!(shd_point_directions, direction, 8);
    offset!(shd_point_directions, solid_angle, 56);
    offset!(shd_point_directions, nonfinite_count, 72);
}

#[test]
fn shd_direction_images_offsets() {
    offset!(shd_direction_images, struct_size, 0);
    offset!(shd_direction_images, projection, 4);
    offset!(shd_direction_images, layout, 8);
    offset!(shd_direction_images, images, 16);
}

#[test]
fn shd_draw_offsets() {
    offset!(shd_draw, struct_size, 0);
    offset!(shd_draw, mesh, 8);
    offset!(shd_draw, material, 16);
    offset!(shd_draw, uniforms, 24);
    offset!(shd_draw, object_to_world, 32);
    offset!(shd_draw, instances, 96);
    offset!(shd_draw, instance_count, 104);
    offset!(shd_draw, frequency, 112);
    offset!(shd_draw, flags, 116);
    offset!(shd_draw, cull, 120);
    offset!(shd_draw, compare, 124);
    offset!(shd_draw, depth_bias, 128);
    offset!(shd_draw, depth_bias_slope, 132);
    offset!(shd_draw, fill, 136);
    offset!(shd_draw, fill_width, 140);
    offset!(shd_draw, edges, 144);
    offset!(shd_draw, crease_cosine, 148);
}

#[test]
fn shd_render_stats_offsets() {
    offset!(shd_render_stats, struct_size, 0);
    offset!(shd_render_stats, triangles, 8);
    offset!(shd_render_stats, nonfinite, 16);
    offset!(shd_render_stats, outside, 24);
    offset!(shd_render_stats, culled, 32);
    offset!(shd_render_stats, empty, 40);
    offset!(shd_render_stats, rasterised, 48);
    offset!(shd_render_stats, clipped, 56);
    offset!(shd_render_stats, fragments, 64);
    offset!(shd_render_stats, nonfinite_fragments, 72);
    offset!(shd_render_stats, hidden_samples, 80);
    offset!(shd_render_stats, order_conflicts, 88);
    offset!(shd_render_stats, splits, 96);
    offset!(shd_render_stats, scratch_bytes, 104);
    offset!(shd_render_stats, vertex_seconds, 112);
    offset!(shd_render_stats, assembly_seconds, 120);
    offset!(shd_render_stats, binning_seconds, 128);
    offset!(shd_render_stats, tile_seconds, 136);
}

#[test]
fn shd_progress_offsets() {
    offset!(shd_progress, report, 0);
    offset!(shd_progress, user_data, 8);
}

#[test]
fn shd_region_offsets() {
    offset!(shd_region, x, 0);
    offset!(shd_region, y, 4);
    offset!(shd_region, width, 8);
    offset!(shd_region, height, 12);
}

#[test]
fn shd_render_desc_offsets() {
    offset!(shd_render_desc, struct_size, 0);
    offset!(shd_render_desc, framebuffer, 8);
    offset!(shd_render_desc, clear_color, 16);
    offset!(shd_render_desc, clear_depth, 32);
    offset!(shd_render_desc, flags, 36);
    offset!(shd_render_desc, camera, 40);
    offset!(shd_render_desc, view, 48);
    offset!(shd_render_desc, visibility, 188);
    offset!(shd_render_desc, draws, 192);
    offset!(shd_render_desc, draw_count, 200);
    offset!(shd_render_desc, lights, 208);
    offset!(shd_render_desc, shadows, 216);
    offset!(shd_render_desc, light_count, 224);
    offset!(shd_render_desc, picture_width, 232);
    offset!(shd_render_desc, picture_height, 236);
    offset!(shd_render_desc, crop_x, 240);
    offset!(shd_render_desc, crop_y, 244);
    offset!(shd_render_desc, viewport, 248);
    offset!(shd_render_desc, scissor, 256);
    offset!(shd_render_desc, supersampling, 264);
    offset!(shd_render_desc, pass_triangles, 268);
    offset!(shd_render_desc, stats, 272);
    offset!(shd_render_desc, progress, 280);
    offset!(shd_render_desc, present, 296);
    offset!(shd_render_desc, environment, 312);
    offset!(shd_render_desc, environment_intensity, 320);
    offset!(shd_render_desc, environment_to_world, 324);
    offset!(shd_render_desc, background, 360);
    offset!(shd_render_desc, background_roughness, 364);
    offset!(shd_render_desc, volumes, 368);
    offset!(shd_render_desc, volume_count, 376);
}

#[test]
fn shd_sampler_desc_offsets() {
    offset!(shd_sampler_desc, struct_size, 0);
    offset!(shd_sampler_desc, filter, 4);
    offset!(shd_sampler_desc, magnification, 8);
    offset!(shd_sampler_desc, wrap_u, 12);
    offset!(shd_sampler_desc, wrap_v, 16);
    offset!(shd_sampler_desc, border, 20);
    offset!(shd_sampler_desc, profile, 36);
    offset!(shd_sampler_desc, lod_bias, 40);
    offset!(shd_sampler_desc, lod_min, 44);
    offset!(shd_sampler_desc, lod_max, 48);
    offset!(shd_sampler_desc, width_x, 52);
    offset!(shd_sampler_desc, width_y, 56);
    offset!(shd_sampler_desc, blur_u, 60);
    offset!(shd_sampler_desc, blur_v, 64);
    offset!(shd_sampler_desc, max_anisotropy, 68);
    offset!(shd_sampler_desc, probe_weights, 72);
    offset!(shd_sampler_desc, cubic, 76);
    offset!(shd_sampler_desc, r#box, 80);
    offset!(shd_sampler_desc, tolerance, 84);
    offset!(shd_sampler_desc, stochastic_filter, 88);
    offset!(shd_sampler_desc, seed, 92);
    offset!(shd_sampler_desc, precision, 96);
    offset!(shd_sampler_desc, max_texels, 100);
    offset!(shd_sampler_desc, probe_slack, 104);
    offset!(shd_sampler_desc, level_blend, 108);
    offset!(shd_sampler_desc, stochastic, 112);
    offset!(shd_sampler_desc, wrap_w, 116);
    offset!(shd_sampler_desc, missing_tiles, 120);
    offset!(shd_sampler_desc, compares, 124);
    offset!(shd_sampler_desc, compare, 128);
}

#[test]
fn shd_scene_desc_offsets() {
    offset!(shd_scene_desc, struct_size, 0);
    offset!(shd_scene_desc, flags, 4);
    offset!(shd_scene_desc, mesh_flags, 8);
    offset!(shd_scene_desc, sampler, 16);
    offset!(shd_scene_desc, texture, 24);
    offset!(shd_scene_desc, max_file_bytes, 32);
    offset!(shd_scene_desc, max_vertices, 40);
    offset!(shd_scene_desc, max_triangles, 48);
    offset!(shd_scene_desc, max_nodes, 56);
    offset!(shd_scene_desc, max_instances, 64);
    offset!(shd_scene_desc, max_texture_bytes, 72);
    offset!(shd_scene_desc, time_limit, 80);
    offset!(shd_scene_desc, max_reader_bytes, 88);
    offset!(shd_scene_desc, find, 96);
    offset!(shd_scene_desc, find_user_data, 104);
}

#[test]
fn shd_scene_info_offsets() {
    offset!(shd_scene_info, struct_size, 0);
    offset!(shd_scene_info, mesh_count, 4);
    offset!(shd_scene_info, material_count, 8);
    offset!(shd_scene_info, texture_count, 12);
    offset!(shd_scene_info, light_count, 16);
    offset!(shd_scene_info, camera_count, 20);
    offset!(shd_scene_info, instance_count, 24);
    offset!(shd_scene_info, warning_count, 28);
    offset!(shd_scene_info, vertex_count, 32);
    offset!(shd_scene_info, triangle_count, 40);
    offset!(shd_scene_info, bounds_min, 48);
    offset!(shd_scene_info, bounds_max, 60);
    offset!(shd_scene_info, origin, 72);
    offset!(shd_scene_info, animation_count, 96);
    offset!(shd_scene_info, deformed_mesh_count, 100);
}

#[test]
fn shd_scene_instance_offsets() {
    offset!(shd_scene_instance, struct_size, 0);
    offset!(shd_scene_instance, mesh, 4);
    offset!(shd_scene_instance, material, 8);
    offset!(shd_scene_instance, object_to_world, 12);
    offset!(shd_scene_instance, cull, 76);
}

#[test]
fn shd_shadow_desc_offsets() {
    offset!(shd_shadow_desc, struct_size, 0);
    offset!(shd_shadow_desc, size, 4);
    offset!(shd_shadow_desc, filter, 8);
    offset!(shd_shadow_desc, taps, 12);
    offset!(shd_shadow_desc, filter_size, 16);
    offset!(shd_shadow_desc, light_size, 20);
    offset!(shd_shadow_desc, bias, 24);
    offset!(shd_shadow_desc, bias_slope, 28);
    offset!(shd_shadow_desc, normal_offset, 32);
    offset!(shd_shadow_desc, caster_cull, 36);
    offset!(shd_shadow_desc, bleed, 40);
    offset!(shd_shadow_desc, min_variance, 44);
}

#[test]
fn shd_shadow_render_desc_offsets() {
    offset!(shd_shadow_render_desc, struct_size, 0);
    offset!(shd_shadow_render_desc, light, 8);
    offset!(shd_shadow_render_desc, draws, 16);
    offset!(shd_shadow_render_desc, draw_count, 24);
    offset!(shd_shadow_render_desc, near_plane, 32);
    offset!(shd_shadow_render_desc, far_plane, 36);
    offset!(shd_shadow_render_desc, bounds_min, 40);
    offset!(shd_shadow_render_desc, bounds_max, 52);
}

#[test]
fn shd_shadow_lookups_offsets() {
    offset!(shd_shadow_lookups, struct_size, 0);
    offset!(shd_shadow_lookups, count, 8);
    offset!(shd_shadow_lookups, position, 16);
    offset!(shd_shadow_lookups, normal, 64);
}

#[test]
fn shd_shape_desc_offsets() {
    offset!(shd_shape_desc, struct_size, 0);
    offset!(shd_shape_desc, shape, 4);
    offset!(shd_shape_desc, radius, 8);
    offset!(shd_shape_desc, tube_radius, 12);
    offset!(shd_shape_desc, size, 16);
    offset!(shd_shape_desc, segments, 28);
}

#[test]
fn shd_shape_columns_offsets() {
    offset!(shd_shape_columns, struct_size, 0);
    offset!(shd_shape_columns, vertex_count, 4);
    offset!(shd_shape_columns, index_count, 8);
    offset!(shd_shape_columns, position, 16);
    offset!(shd_shape_columns, normal, 64);
    offset!(shd_shape_columns, uv, 112);
    offset!(shd_shape_columns, indices, 144);
}

#[test]
fn shd_slot_offsets() {
    offset!(shd_slot, struct_size, 0);
    offset!(shd_slot, target, 4);
    offset!(shd_slot, source, 8);
    offset!(shd_slot, attribute, 12);
    offset!(shd_slot, texture, 16);
    offset!(shd_slot, sampler, 24);
    offset!(shd_slot, procedure, 32);
    offset!(shd_slot, user_data, 40);
    offset!(shd_slot, channel, 48);
    offset!(shd_slot, uv_set, 52);
    offset!(shd_slot, uv_transform, 56);
    offset!(shd_slot, solid, 80);
    offset!(shd_slot, place_transform, 88);
    offset!(shd_slot, place_space, 152);
    offset!(shd_slot, place_width, 156);
}

#[test]
fn shd_solid_desc_offsets() {
    offset!(shd_solid_desc, struct_size, 0);
    offset!(shd_solid_desc, kind, 4);
    offset!(shd_solid_desc, seed, 8);
    offset!(shd_solid_desc, size, 12);
    offset!(shd_solid_desc, octaves, 16);
    offset!(shd_solid_desc, lacunarity, 20);
    offset!(shd_solid_desc, gain, 24);
    offset!(shd_solid_desc, sum, 28);
    offset!(shd_solid_desc, gradients, 32);
    offset!(shd_solid_desc, fade, 36);
    offset!(shd_solid_desc, distance, 40);
    offset!(shd_solid_desc, distortion, 44);
    offset!(shd_solid_desc, range, 48);
    offset!(shd_solid_desc, color_count, 56);
    offset!(shd_solid_desc, colors, 60);
}

#[test]
fn shd_solid_points_offsets() {
    offset!(shd_solid_points, struct_size, 0);
    offset!(shd_solid_points, count, 8);
    offset!(shd_solid_points, position, 16);
    offset!(shd_solid_points, width, 64);
}

#[test]
fn shd_solid_values_offsets() {
    offset!(shd_solid_values, struct_size, 0);
    offset!(shd_solid_values, value, 8);
    offset!(shd_solid_values, gradient, 24);
    offset!(shd_solid_values, color, 72);
    offset!(shd_solid_values, nonfinite_count, 136);
}

#[test]
fn shd_tessellation_desc_offsets() {
    offset!(shd_tessellation_desc, struct_size, 0);
    offset!(shd_tessellation_desc, mode, 4);
    offset!(shd_tessellation_desc, segments, 8);
    offset!(shd_tessellation_desc, max_segments, 12);
    offset!(shd_tessellation_desc, edge_length, 16);
    offset!(shd_tessellation_desc, width, 20);
    offset!(shd_tessellation_desc, height, 24);
    offset!(shd_tessellation_desc, max_triangles, 28);
    offset!(shd_tessellation_desc, view, 32);
    offset!(shd_tessellation_desc, object_to_world, 40);
    offset!(shd_tessellation_desc, displacement, 48);
    offset!(shd_tessellation_desc, sampler, 56);
    offset!(shd_tessellation_desc, lod, 64);
    offset!(shd_tessellation_desc, amplitude, 68);
    offset!(shd_tessellation_desc, offset, 72);
    offset!(shd_tessellation_desc, normals, 76);
}

#[test]
fn shd_texture_desc_offsets() {
    offset!(shd_texture_desc, struct_size, 0);
    offset!(shd_texture_desc, format, 4);
    offset!(shd_texture_desc, width, 8);
    offset!(shd_texture_desc, height, 12);
    offset!(shd_texture_desc, texels, 16);
    offset!(shd_texture_desc, row_stride, 24);
    offset!(shd_texture_desc, layer_stride, 32);
    offset!(shd_texture_desc, layers, 40);
    offset!(shd_texture_desc, flags, 44);
    offset!(shd_texture_desc, swizzle, 48);
    offset!(shd_texture_desc, fill, 64);
    offset!(shd_texture_desc, tables, 80);
    offset!(shd_texture_desc, level_count, 84);
    offset!(shd_texture_desc, levels, 88);
    offset!(shd_texture_desc, depth, 96);
    offset!(shd_texture_desc, projection, 100);
    offset!(shd_texture_desc, tiles, 104);
}

#[test]
fn shd_texture_info_offsets() {
    offset!(shd_texture_info, struct_size, 0);
    offset!(shd_texture_info, format, 4);
    offset!(shd_texture_info, width, 8);
    offset!(shd_texture_info, height, 12);
    offset!(shd_texture_info, layers, 16);
    offset!(shd_texture_info, level_count, 20);
    offset!(shd_texture_info, tables, 24);
    offset!(shd_texture_info, flags, 28);
    offset!(shd_texture_info, byte_size, 32);
    offset!(shd_texture_info, depth, 40);
    offset!(shd_texture_info, projection, 44);
}

#[test]
fn shd_texture_file_info_offsets() {
    offset!(shd_texture_file_info, struct_size, 0);
    offset!(shd_texture_file_info, kind, 4);
    offset!(shd_texture_file_info, file_code, 8);
    offset!(shd_texture_file_info, supercompression, 12);
    offset!(shd_texture_file_info, flags, 16);
    offset!(shd_texture_file_info, format, 20);
    offset!(shd_texture_file_info, width, 24);
    offset!(shd_texture_file_info, height, 28);
    offset!(shd_texture_file_info, depth, 32);
    offset!(shd_texture_file_info, layers, 36);
    offset!(shd_texture_file_info, faces, 40);
    offset!(shd_texture_file_info, level_count, 44);
}

#[test]
fn shd_ktx2_desc_offsets() {
    offset!(shd_ktx2_desc, struct_size, 0);
    offset!(shd_ktx2_desc, supercompression, 4);
    offset!(shd_ktx2_desc, effort, 8);
    offset!(shd_ktx2_desc, channels, 12);
}

#[test]
fn shd_tile_cache_desc_offsets() {
    offset!(shd_tile_cache_desc, struct_size, 0);
    offset!(shd_tile_cache_desc, tile_bytes, 4);
    offset!(shd_tile_cache_desc, budget_bytes, 8);
}

#[test]
fn shd_tile_offsets() {
    offset!(shd_tile, layer, 0);
    offset!(shd_tile, level, 4);
    offset!(shd_tile, x, 8);
    offset!(shd_tile, y, 12);
    offset!(shd_tile, width, 16);
    offset!(shd_tile, height, 20);
    offset!(shd_tile, texels, 24);
    offset!(shd_tile, row_stride, 32);
}

#[test]
fn shd_tile_source_offsets() {
    offset!(shd_tile_source, cache, 0);
    offset!(shd_tile_source, load, 8);
    offset!(shd_tile_source, release, 16);
    offset!(shd_tile_source, user_data, 24);
}

#[test]
fn shd_tile_cache_stats_offsets() {
    offset!(shd_tile_cache_stats, struct_size, 0);
    offset!(shd_tile_cache_stats, tile_bytes, 4);
    offset!(shd_tile_cache_stats, budget_bytes, 8);
    offset!(shd_tile_cache_stats, allocated_bytes, 16);
    offset!(shd_tile_cache_stats, tile_count, 24);
    offset!(shd_tile_cache_stats, resident_tiles, 28);
    offset!(shd_tile_cache_stats, pinned_tiles, 32);
    offset!(shd_tile_cache_stats, requested_tiles, 36);
    offset!(shd_tile_cache_stats, loads, 40);
    offset!(shd_tile_cache_stats, loaded_tiles, 48);
    offset!(shd_tile_cache_stats, failed_tiles, 56);
    offset!(shd_tile_cache_stats, evicted_tiles, 64);
    offset!(shd_tile_cache_stats, waits, 72);
}

#[test]
fn shd_tile_file_desc_offsets() {
    offset!(shd_tile_file_desc, struct_size, 0);
    offset!(shd_tile_file_desc, color_space, 4);
    offset!(shd_tile_file_desc, cache, 8);
    offset!(shd_tile_file_desc, max_readers, 16);
    offset!(shd_tile_file_desc, fill, 24);
}

#[test]
fn shd_tile_file_info_offsets() {
    offset!(shd_tile_file_info, struct_size, 0);
    offset!(shd_tile_file_info, columns, 4);
    offset!(shd_tile_file_info, rows, 8);
    offset!(shd_tile_file_info, files, 12);
    offset!(shd_tile_file_info, tile_width, 16);
    offset!(shd_tile_file_info, tile_height, 20);
}

#[test]
fn shd_tile_region_offsets() {
    offset!(shd_tile_region, struct_size, 0);
    offset!(shd_tile_region, layer, 4);
    offset!(shd_tile_region, level, 8);
    offset!(shd_tile_region, x, 12);
    offset!(shd_tile_region, y, 16);
    offset!(shd_tile_region, width, 20);
    offset!(shd_tile_region, height, 24);
}

#[test]
fn shd_vertices_offsets() {
    offset!(shd_vertices, struct_size, 0);
    offset!(shd_vertices, draw, 4);
    offset!(shd_vertices, instance, 8);
    offset!(shd_vertices, first, 12);
    offset!(shd_vertices, attribute_count, 16);
    offset!(shd_vertices, count, 24);
    offset!(shd_vertices, px, 32);
    offset!(shd_vertices, py, 40);
    offset!(shd_vertices, pz, 48);
    offset!(shd_vertices, nx, 56);
    offset!(shd_vertices, ny, 64);
    offset!(shd_vertices, nz, 72);
    offset!(shd_vertices, tx, 80);
    offset!(shd_vertices, ty, 88);
    offset!(shd_vertices, tz, 96);
    offset!(shd_vertices, tw, 104);
    offset!(shd_vertices, u, 112);
    offset!(shd_vertices, v, 120);
    offset!(shd_vertices, u1, 128);
    offset!(shd_vertices, v1, 136);
    offset!(shd_vertices, attribute, 144);
    offset!(shd_vertices, object_to_world, 152);
    offset!(shd_vertices, world_to_view, 160);
    offset!(shd_vertices, view_to_clip, 168);
    offset!(shd_vertices, eye, 176);
    offset!(shd_vertices, uniforms, 184);
}

#[test]
fn shd_vertex_outputs_offsets() {
    offset!(shd_vertex_outputs, struct_size, 0);
    offset!(shd_vertex_outputs, varying_count, 4);
    offset!(shd_vertex_outputs, x, 8);
    offset!(shd_vertex_outputs, y, 16);
    offset!(shd_vertex_outputs, z, 24);
    offset!(shd_vertex_outputs, w, 32);
    offset!(shd_vertex_outputs, px, 40);
    offset!(shd_vertex_outputs, py, 48);
    offset!(shd_vertex_outputs, pz, 56);
    offset!(shd_vertex_outputs, nx, 64);
    offset!(shd_vertex_outputs, ny, 72);
    offset!(shd_vertex_outputs, nz, 80);
    offset!(shd_vertex_outputs, u, 88);
    offset!(shd_vertex_outputs, v, 96);
    offset!(shd_vertex_outputs, varying, 104);
}

#[test]
fn shd_view_offsets() {
    offset!(shd_view, world_to_view, 0);
    offset!(shd_view, view_to_clip, 64);
    offset!(shd_view, eye, 128);
}

#[test]
fn shd_camera_offsets() {
    offset!(shd_camera, struct_size, 0);
    offset!(shd_camera, eye, 4);
    offset!(shd_camera, target, 16);
    offset!(shd_camera, up, 28);
    offset!(shd_camera, fov_y, 40);
    offset!(shd_camera, aspect, 44);
    offset!(shd_camera, near_plane, 48);
    offset!(shd_camera, far_plane, 52);
}

#[test]
fn shd_volume_desc_offsets() {
    offset!(shd_volume_desc, struct_size, 0);
    offset!(shd_volume_desc, point_count, 4);
    offset!(shd_volume_desc, texture, 8);
    offset!(shd_volume_desc, density, 16);
    offset!(shd_volume_desc, extinction, 32);
    offset!(shd_volume_desc, color, 48);
    offset!(shd_volume_desc, material, 96);
    offset!(shd_volume_desc, box_min, 104);
    offset!(shd_volume_desc, box_max, 116);
    offset!(shd_volume_desc, step, 128);
    offset!(shd_volume_desc, jitter, 132);
    offset!(shd_volume_desc, seed, 136);
    offset!(shd_volume_desc, flags, 140);
}

#[test]
fn shd_volume_draw_offsets() {
    offset!(shd_volume_draw, struct_size, 0);
    offset!(shd_volume_draw, volume, 8);
    offset!(shd_volume_draw, object_to_world, 16);
}

#[test]
fn shd_raw_desc_offsets() {
    offset!(shd_raw_desc, struct_size, 0);
    offset!(shd_raw_desc, width, 4);
    offset!(shd_raw_desc, height, 8);
    offset!(shd_raw_desc, depth, 12);
    offset!(shd_raw_desc, sample, 16);
    offset!(shd_raw_desc, channels, 20);
    offset!(shd_raw_desc, byte_order, 24);
    offset!(shd_raw_desc, flags, 28);
    offset!(shd_raw_desc, header_bytes, 32);
}

#[test]
fn shd_stack_desc_offsets() {
    offset!(shd_stack_desc, struct_size, 0);
    offset!(shd_stack_desc, path_count, 4);
    offset!(shd_stack_desc, paths, 8);
    offset!(shd_stack_desc, pattern, 16);
    offset!(shd_stack_desc, first, 24);
    offset!(shd_stack_desc, last, 28);
}

#[test]
fn shd_vdb_desc_offsets() {
    offset!(shd_vdb_desc, struct_size, 0);
    offset!(shd_vdb_desc, flags, 4);
    offset!(shd_vdb_desc, grid, 8);
    offset!(shd_vdb_desc, box_min, 16);
    offset!(shd_vdb_desc, box_max, 28);
}

#[test]
fn shd_vdb_info_offsets() {
    offset!(shd_vdb_info, struct_size, 0);
    offset!(shd_vdb_info, grid_class, 4);
    offset!(shd_vdb_info, index_min, 8);
    offset!(shd_vdb_info, background, 20);
    offset!(shd_vdb_info, active_voxels, 24);
    offset!(shd_vdb_info, object_to_world, 32);
    offset!(shd_vdb_info, grid, 96);
}
