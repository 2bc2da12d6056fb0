// SPDX-License-Identifier: MIT
/// @file
/// Owners, structs and functions of shd.hpp. Written by generate.py; do not edit.
#ifndef SHD_API_HPP
#define SHD_API_HPP

#include <shd/bake.h>
#include <shd/base.h>
#include <shd/bounds.h>
#if __has_include(<shd/color.h>)
#include <shd/color.h>
#endif
#include <shd/column.h>
#include <shd/context.h>
#include <shd/desc.h>
#include <shd/draw.h>
#include <shd/edges.h>
#if __has_include(<shd/embree.h>)
#include <shd/embree.h>
#endif
#include <shd/environment.h>
#include <shd/explain.h>
#include <shd/extension.h>
#include <shd/footprint.h>
#include <shd/fragments.h>
#include <shd/framebuffer.h>
#include <shd/image.h>
#if __has_include(<shd/io.h>)
#include <shd/io.h>
#endif
#include <shd/light.h>
#include <shd/lookup.h>
#include <shd/material.h>
#include <shd/mesh.h>
#include <shd/mip.h>
#include <shd/names.h>
#include <shd/occlusion.h>
#include <shd/polygon.h>
#include <shd/polyhedron.h>
#include <shd/present.h>
#include <shd/projection.h>
#include <shd/render.h>
#include <shd/result.h>
#include <shd/sampler.h>
#if __has_include(<shd/scene.h>)
#include <shd/scene.h>
#endif
#include <shd/shadow.h>
#include <shd/shapes.h>
#include <shd/slot.h>
#include <shd/solid.h>
#include <shd/table.h>
#include <shd/tessellate.h>
#include <shd/texture.h>
#if __has_include(<shd/texture_file.h>)
#include <shd/texture_file.h>
#endif
#include <shd/tile_cache.h>
#if __has_include(<shd/tile_file.h>)
#include <shd/tile_file.h>
#endif
#include <shd/tiles.h>
#include <shd/transform.h>
#include <shd/uv_projection.h>
#include <shd/vertices.h>
#include <shd/view.h>
#include <shd/volume.h>
#if __has_include(<shd/volume_file.h>)
#include <shd/volume_file.h>
#endif
#include <shd/wrap.h>

#include "shd.hpp"

// clang-format off
namespace shd {

#if __has_include(<shd/color.h>)
/// An OpenColorIO config and the transforms built from it so far.
using color = owner<shd_color, shd_color_retain, shd_color_release>;
#endif
/// Owner of the allocator, executor and log that its objects use.
using context = owner<shd_context, shd_context_retain, shd_context_release>;
#if __has_include(<shd/embree.h>)
/// The triangles of draws, in a tree.
using embree = owner<shd_embree, shd_embree_retain, shd_embree_release>;
#endif
/// Light from all directions.
using environment = owner<shd_environment, shd_environment_retain, shd_environment_release>;
/// A set of planes with the same width and height.
using framebuffer = owner<shd_framebuffer, shd_framebuffer_retain, shd_framebuffer_release>;
#if __has_include(<shd/io.h>)
/// The pixels of a file, without conversion.
using bitmap = owner<shd_bitmap, shd_bitmap_retain, shd_bitmap_release>;
#endif
/// A source of light in world space.
using light = owner<shd_light, shd_light_retain, shd_light_release>;
/// Reflectance of a surface.
using material = owner<shd_material, shd_material_retain, shd_material_release>;
/// Vertices and triangles, in object space.
using mesh = owner<shd_mesh, shd_mesh_retain, shd_mesh_release>;
/// A closed triangle mesh with the kind of its coordinates.
using polyhedron = owner<shd_polyhedron, shd_polyhedron_retain, shd_polyhedron_release>;
/// A filter with its settings, for any texture.
using sampler = owner<shd_sampler, shd_sampler_retain, shd_sampler_release>;
#if __has_include(<shd/scene.h>)
/// A model file in memory.
using scene = owner<shd_scene, shd_scene_retain, shd_scene_release>;
#endif
/// Depths as seen from a light.
using shadow = owner<shd_shadow, shd_shadow_retain, shd_shadow_release>;
/// A two-dimensional texture, an array of them, a 3D texture or a texture of directions, with its tables.
using texture = owner<shd_texture, shd_texture_retain, shd_texture_release>;
/// Memory for the tiles of textures.
using tile_cache = owner<shd_tile_cache, shd_tile_cache_retain, shd_tile_cache_release>;
/// A density field with its transfer function.
using volume = owner<shd_volume, shd_volume_retain, shd_volume_release>;

// Structs of C that start with their defaults.
struct bake_stats : shd_bake_stats {
  bake_stats() noexcept : shd_bake_stats(shd_bake_stats_default()) {}
  bake_stats(const shd_bake_stats& values) noexcept : shd_bake_stats(values) {}
};
struct bake_desc : shd_bake_desc {
  bake_desc() noexcept : shd_bake_desc(shd_bake_desc_default()) {}
  bake_desc(const shd_bake_desc& values) noexcept : shd_bake_desc(values) {}
};
struct bounds_desc : shd_bounds_desc {
  bounds_desc() noexcept : shd_bounds_desc(shd_bounds_desc_default()) {}
  bounds_desc(const shd_bounds_desc& values) noexcept : shd_bounds_desc(values) {}
};
#if __has_include(<shd/color.h>)
struct color_desc : shd_color_desc {
  color_desc() noexcept : shd_color_desc(shd_color_desc_default()) {}
  color_desc(const shd_color_desc& values) noexcept : shd_color_desc(values) {}
};
#endif
struct context_desc : shd_context_desc {
  context_desc() noexcept : shd_context_desc(shd_context_desc_default()) {}
  context_desc(const shd_context_desc& values) noexcept : shd_context_desc(values) {}
};
struct draw : shd_draw {
  draw() noexcept : shd_draw(shd_draw_default()) {}
  draw(const shd_draw& values) noexcept : shd_draw(values) {}
};
struct edges_desc : shd_edges_desc {
  edges_desc() noexcept : shd_edges_desc(shd_edges_desc_default()) {}
  edges_desc(const shd_edges_desc& values) noexcept : shd_edges_desc(values) {}
};
struct edges : shd_edges {
  edges() noexcept : shd_edges(shd_edges_default()) {}
  edges(const shd_edges& values) noexcept : shd_edges(values) {}
};
struct environment_desc : shd_environment_desc {
  environment_desc() noexcept : shd_environment_desc(shd_environment_desc_default()) {}
  environment_desc(const shd_environment_desc& values) noexcept : shd_environment_desc(values) {}
};
struct environment_info : shd_environment_info {
  environment_info() noexcept : shd_environment_info(shd_environment_info_default()) {}
  environment_info(const shd_environment_info& values) noexcept : shd_environment_info(values) {}
};
struct environment_lookups : shd_environment_lookups {
  environment_lookups() noexcept : shd_environment_lookups(shd_environment_lookups_default()) {}
  environment_lookups(const shd_environment_lookups& values) noexcept : shd_environment_lookups(values) {}
};
struct environment_values : shd_environment_values {
  environment_values() noexcept : shd_environment_values(shd_environment_values_default()) {}
  environment_values(const shd_environment_values& values) noexcept : shd_environment_values(values) {}
};
struct explanation : shd_explanation {
  explanation() noexcept : shd_explanation(shd_explanation_default()) {}
  explanation(const shd_explanation& values) noexcept : shd_explanation(values) {}
};
struct derivatives : shd_derivatives {
  derivatives() noexcept : shd_derivatives(shd_derivatives_default()) {}
  derivatives(const shd_derivatives& values) noexcept : shd_derivatives(values) {}
};
struct ray_differentials : shd_ray_differentials {
  ray_differentials() noexcept : shd_ray_differentials(shd_ray_differentials_default()) {}
  ray_differentials(const shd_ray_differentials& values) noexcept : shd_ray_differentials(values) {}
};
struct ray_cones : shd_ray_cones {
  ray_cones() noexcept : shd_ray_cones(shd_ray_cones_default()) {}
  ray_cones(const shd_ray_cones& values) noexcept : shd_ray_cones(values) {}
};
struct framebuffer_desc : shd_framebuffer_desc {
  framebuffer_desc() noexcept : shd_framebuffer_desc(shd_framebuffer_desc_default()) {}
  framebuffer_desc(const shd_framebuffer_desc& values) noexcept : shd_framebuffer_desc(values) {}
};
struct framebuffer_info : shd_framebuffer_info {
  framebuffer_info() noexcept : shd_framebuffer_info(shd_framebuffer_info_default()) {}
  framebuffer_info(const shd_framebuffer_info& values) noexcept : shd_framebuffer_info(values) {}
};
struct plane_view : shd_plane_view {
  plane_view() noexcept : shd_plane_view(shd_plane_view_default()) {}
  plane_view(const shd_plane_view& values) noexcept : shd_plane_view(values) {}
};
struct image : shd_image {
  image() noexcept : shd_image(shd_image_default()) {}
  image(const shd_image& values) noexcept : shd_image(values) {}
};
#if __has_include(<shd/io.h>)
struct load_desc : shd_load_desc {
  load_desc() noexcept : shd_load_desc(shd_load_desc_default()) {}
  load_desc(const shd_load_desc& values) noexcept : shd_load_desc(values) {}
};
struct bitmap_info : shd_bitmap_info {
  bitmap_info() noexcept : shd_bitmap_info(shd_bitmap_info_default()) {}
  bitmap_info(const shd_bitmap_info& values) noexcept : shd_bitmap_info(values) {}
};
struct save_desc : shd_save_desc {
  save_desc() noexcept : shd_save_desc(shd_save_desc_default()) {}
  save_desc(const shd_save_desc& values) noexcept : shd_save_desc(values) {}
};
#endif
struct light_desc : shd_light_desc {
  light_desc() noexcept : shd_light_desc(shd_light_desc_default()) {}
  light_desc(const shd_light_desc& values) noexcept : shd_light_desc(values) {}
};
struct lookups : shd_lookups {
  lookups() noexcept : shd_lookups(shd_lookups_default()) {}
  lookups(const shd_lookups& values) noexcept : shd_lookups(values) {}
};
struct texels : shd_texels {
  texels() noexcept : shd_texels(shd_texels_default()) {}
  texels(const shd_texels& values) noexcept : shd_texels(values) {}
};
struct levels : shd_levels {
  levels() noexcept : shd_levels(shd_levels_default()) {}
  levels(const shd_levels& values) noexcept : shd_levels(values) {}
};
struct material_desc : shd_material_desc {
  material_desc() noexcept : shd_material_desc(shd_material_desc_default()) {}
  material_desc(const shd_material_desc& values) noexcept : shd_material_desc(values) {}
};
struct mesh_desc : shd_mesh_desc {
  mesh_desc() noexcept : shd_mesh_desc(shd_mesh_desc_default()) {}
  mesh_desc(const shd_mesh_desc& values) noexcept : shd_mesh_desc(values) {}
};
struct mesh_info : shd_mesh_info {
  mesh_info() noexcept : shd_mesh_info(shd_mesh_info_default()) {}
  mesh_info(const shd_mesh_info& values) noexcept : shd_mesh_info(values) {}
};
struct mip_desc : shd_mip_desc {
  mip_desc() noexcept : shd_mip_desc(shd_mip_desc_default()) {}
  mip_desc(const shd_mip_desc& values) noexcept : shd_mip_desc(values) {}
};
struct normals_desc : shd_normals_desc {
  normals_desc() noexcept : shd_normals_desc(shd_normals_desc_default()) {}
  normals_desc(const shd_normals_desc& values) noexcept : shd_normals_desc(values) {}
};
struct occlusion_desc : shd_occlusion_desc {
  occlusion_desc() noexcept : shd_occlusion_desc(shd_occlusion_desc_default()) {}
  occlusion_desc(const shd_occlusion_desc& values) noexcept : shd_occlusion_desc(values) {}
};
struct occlusion_points : shd_occlusion_points {
  occlusion_points() noexcept : shd_occlusion_points(shd_occlusion_points_default()) {}
  occlusion_points(const shd_occlusion_points& values) noexcept : shd_occlusion_points(values) {}
};
struct occlusion_values : shd_occlusion_values {
  occlusion_values() noexcept : shd_occlusion_values(shd_occlusion_values_default()) {}
  occlusion_values(const shd_occlusion_values& values) noexcept : shd_occlusion_values(values) {}
};
struct occlusion_atlas : shd_occlusion_atlas {
  occlusion_atlas() noexcept : shd_occlusion_atlas(shd_occlusion_atlas_default()) {}
  occlusion_atlas(const shd_occlusion_atlas& values) noexcept : shd_occlusion_atlas(values) {}
};
struct polygon_desc : shd_polygon_desc {
  polygon_desc() noexcept : shd_polygon_desc(shd_polygon_desc_default()) {}
  polygon_desc(const shd_polygon_desc& values) noexcept : shd_polygon_desc(values) {}
};
struct polygon_points : shd_polygon_points {
  polygon_points() noexcept : shd_polygon_points(shd_polygon_points_default()) {}
  polygon_points(const shd_polygon_points& values) noexcept : shd_polygon_points(values) {}
};
struct polygon_weights : shd_polygon_weights {
  polygon_weights() noexcept : shd_polygon_weights(shd_polygon_weights_default()) {}
  polygon_weights(const shd_polygon_weights& values) noexcept : shd_polygon_weights(values) {}
};
struct polyhedron_desc : shd_polyhedron_desc {
  polyhedron_desc() noexcept : shd_polyhedron_desc(shd_polyhedron_desc_default()) {}
  polyhedron_desc(const shd_polyhedron_desc& values) noexcept : shd_polyhedron_desc(values) {}
};
struct polyhedron_points : shd_polyhedron_points {
  polyhedron_points() noexcept : shd_polyhedron_points(shd_polyhedron_points_default()) {}
  polyhedron_points(const shd_polyhedron_points& values) noexcept : shd_polyhedron_points(values) {}
};
struct polyhedron_weights : shd_polyhedron_weights {
  polyhedron_weights() noexcept : shd_polyhedron_weights(shd_polyhedron_weights_default()) {}
  polyhedron_weights(const shd_polyhedron_weights& values) noexcept : shd_polyhedron_weights(values) {}
};
struct polyhedron_values : shd_polyhedron_values {
  polyhedron_values() noexcept : shd_polyhedron_values(shd_polyhedron_values_default()) {}
  polyhedron_values(const shd_polyhedron_values& values) noexcept : shd_polyhedron_values(values) {}
};
struct directions : shd_directions {
  directions() noexcept : shd_directions(shd_directions_default()) {}
  directions(const shd_directions& values) noexcept : shd_directions(values) {}
};
struct projected_points : shd_projected_points {
  projected_points() noexcept : shd_projected_points(shd_projected_points_default()) {}
  projected_points(const shd_projected_points& values) noexcept : shd_projected_points(values) {}
};
struct image_points : shd_image_points {
  image_points() noexcept : shd_image_points(shd_image_points_default()) {}
  image_points(const shd_image_points& values) noexcept : shd_image_points(values) {}
};
struct point_directions : shd_point_directions {
  point_directions() noexcept : shd_point_directions(shd_point_directions_default()) {}
  point_directions(const shd_point_directions& values) noexcept : shd_point_directions(values) {}
};
struct direction_images : shd_direction_images {
  direction_images() noexcept : shd_direction_images(shd_direction_images_default()) {}
  direction_images(const shd_direction_images& values) noexcept : shd_direction_images(values) {}
};
struct render_stats : shd_render_stats {
  render_stats() noexcept : shd_render_stats(shd_render_stats_default()) {}
  render_stats(const shd_render_stats& values) noexcept : shd_render_stats(values) {}
};
struct render_desc : shd_render_desc {
  render_desc() noexcept : shd_render_desc(shd_render_desc_default()) {}
  render_desc(const shd_render_desc& values) noexcept : shd_render_desc(values) {}
};
struct sampler_desc : shd_sampler_desc {
  sampler_desc() noexcept : shd_sampler_desc(shd_sampler_desc_default()) {}
  sampler_desc(const shd_sampler_desc& values) noexcept : shd_sampler_desc(values) {}
};
#if __has_include(<shd/scene.h>)
struct scene_desc : shd_scene_desc {
  scene_desc() noexcept : shd_scene_desc(shd_scene_desc_default()) {}
  scene_desc(const shd_scene_desc& values) noexcept : shd_scene_desc(values) {}
};
struct scene_info : shd_scene_info {
  scene_info() noexcept : shd_scene_info(shd_scene_info_default()) {}
  scene_info(const shd_scene_info& values) noexcept : shd_scene_info(values) {}
};
struct scene_instance : shd_scene_instance {
  scene_instance() noexcept : shd_scene_instance(shd_scene_instance_default()) {}
  scene_instance(const shd_scene_instance& values) noexcept : shd_scene_instance(values) {}
};
#endif
struct shadow_desc : shd_shadow_desc {
  shadow_desc() noexcept : shd_shadow_desc(shd_shadow_desc_default()) {}
  shadow_desc(const shd_shadow_desc& values) noexcept : shd_shadow_desc(values) {}
};
struct shadow_render_desc : shd_shadow_render_desc {
  shadow_render_desc() noexcept : shd_shadow_render_desc(shd_shadow_render_desc_default()) {}
  shadow_render_desc(const shd_shadow_render_desc& values) noexcept : shd_shadow_render_desc(values) {}
};
struct shadow_info : shd_shadow_info {
  shadow_info() noexcept : shd_shadow_info(shd_shadow_info_default()) {}
  shadow_info(const shd_shadow_info& values) noexcept : shd_shadow_info(values) {}
};
struct shadow_lookups : shd_shadow_lookups {
  shadow_lookups() noexcept : shd_shadow_lookups(shd_shadow_lookups_default()) {}
  shadow_lookups(const shd_shadow_lookups& values) noexcept : shd_shadow_lookups(values) {}
};
struct shadow_values : shd_shadow_values {
  shadow_values() noexcept : shd_shadow_values(shd_shadow_values_default()) {}
  shadow_values(const shd_shadow_values& values) noexcept : shd_shadow_values(values) {}
};
struct shape_desc : shd_shape_desc {
  shape_desc() noexcept : shd_shape_desc(shd_shape_desc_default()) {}
  shape_desc(const shd_shape_desc& values) noexcept : shd_shape_desc(values) {}
};
struct shape_columns : shd_shape_columns {
  shape_columns() noexcept : shd_shape_columns(shd_shape_columns_default()) {}
  shape_columns(const shd_shape_columns& values) noexcept : shd_shape_columns(values) {}
};
struct slot : shd_slot {
  slot() noexcept : shd_slot(shd_slot_default()) {}
  slot(const shd_slot& values) noexcept : shd_slot(values) {}
};
struct solid_desc : shd_solid_desc {
  solid_desc() noexcept : shd_solid_desc(shd_solid_desc_default()) {}
  solid_desc(const shd_solid_desc& values) noexcept : shd_solid_desc(values) {}
};
struct solid_points : shd_solid_points {
  solid_points() noexcept : shd_solid_points(shd_solid_points_default()) {}
  solid_points(const shd_solid_points& values) noexcept : shd_solid_points(values) {}
};
struct solid_values : shd_solid_values {
  solid_values() noexcept : shd_solid_values(shd_solid_values_default()) {}
  solid_values(const shd_solid_values& values) noexcept : shd_solid_values(values) {}
};
struct table_desc : shd_table_desc {
  table_desc() noexcept : shd_table_desc(shd_table_desc_default()) {}
  table_desc(const shd_table_desc& values) noexcept : shd_table_desc(values) {}
};
struct table_info : shd_table_info {
  table_info() noexcept : shd_table_info(shd_table_info_default()) {}
  table_info(const shd_table_info& values) noexcept : shd_table_info(values) {}
};
struct tessellation_desc : shd_tessellation_desc {
  tessellation_desc() noexcept : shd_tessellation_desc(shd_tessellation_desc_default()) {}
  tessellation_desc(const shd_tessellation_desc& values) noexcept : shd_tessellation_desc(values) {}
};
struct texture_desc : shd_texture_desc {
  texture_desc() noexcept : shd_texture_desc(shd_texture_desc_default()) {}
  texture_desc(const shd_texture_desc& values) noexcept : shd_texture_desc(values) {}
};
struct texture_info : shd_texture_info {
  texture_info() noexcept : shd_texture_info(shd_texture_info_default()) {}
  texture_info(const shd_texture_info& values) noexcept : shd_texture_info(values) {}
};
#if __has_include(<shd/texture_file.h>)
struct texture_file_info : shd_texture_file_info {
  texture_file_info() noexcept : shd_texture_file_info(shd_texture_file_info_default()) {}
  texture_file_info(const shd_texture_file_info& values) noexcept : shd_texture_file_info(values) {}
};
struct ktx2_desc : shd_ktx2_desc {
  ktx2_desc() noexcept : shd_ktx2_desc(shd_ktx2_desc_default()) {}
  ktx2_desc(const shd_ktx2_desc& values) noexcept : shd_ktx2_desc(values) {}
};
#endif
struct tile_cache_desc : shd_tile_cache_desc {
  tile_cache_desc() noexcept : shd_tile_cache_desc(shd_tile_cache_desc_default()) {}
  tile_cache_desc(const shd_tile_cache_desc& values) noexcept : shd_tile_cache_desc(values) {}
};
struct tile_cache_stats : shd_tile_cache_stats {
  tile_cache_stats() noexcept : shd_tile_cache_stats(shd_tile_cache_stats_default()) {}
  tile_cache_stats(const shd_tile_cache_stats& values) noexcept : shd_tile_cache_stats(values) {}
};
#if __has_include(<shd/tile_file.h>)
struct tile_file_desc : shd_tile_file_desc {
  tile_file_desc() noexcept : shd_tile_file_desc(shd_tile_file_desc_default()) {}
  tile_file_desc(const shd_tile_file_desc& values) noexcept : shd_tile_file_desc(values) {}
};
struct tile_file_info : shd_tile_file_info {
  tile_file_info() noexcept : shd_tile_file_info(shd_tile_file_info_default()) {}
  tile_file_info(const shd_tile_file_info& values) noexcept : shd_tile_file_info(values) {}
};
#endif
struct tile_region : shd_tile_region {
  tile_region() noexcept : shd_tile_region(shd_tile_region_default()) {}
  tile_region(const shd_tile_region& values) noexcept : shd_tile_region(values) {}
};
struct camera : shd_camera {
  camera() noexcept : shd_camera(shd_camera_default()) {}
  camera(const shd_camera& values) noexcept : shd_camera(values) {}
};
struct volume_desc : shd_volume_desc {
  volume_desc() noexcept : shd_volume_desc(shd_volume_desc_default()) {}
  volume_desc(const shd_volume_desc& values) noexcept : shd_volume_desc(values) {}
};
struct volume_draw : shd_volume_draw {
  volume_draw() noexcept : shd_volume_draw(shd_volume_draw_default()) {}
  volume_draw(const shd_volume_draw& values) noexcept : shd_volume_draw(values) {}
};
#if __has_include(<shd/volume_file.h>)
struct raw_desc : shd_raw_desc {
  raw_desc() noexcept : shd_raw_desc(shd_raw_desc_default()) {}
  raw_desc(const shd_raw_desc& values) noexcept : shd_raw_desc(values) {}
};
struct stack_desc : shd_stack_desc {
  stack_desc() noexcept : shd_stack_desc(shd_stack_desc_default()) {}
  stack_desc(const shd_stack_desc& values) noexcept : shd_stack_desc(values) {}
};
struct vdb_desc : shd_vdb_desc {
  vdb_desc() noexcept : shd_vdb_desc(shd_vdb_desc_default()) {}
  vdb_desc(const shd_vdb_desc& values) noexcept : shd_vdb_desc(values) {}
};
struct vdb_info : shd_vdb_info {
  vdb_info() noexcept : shd_vdb_info(shd_vdb_info_default()) {}
  vdb_info(const shd_vdb_info& values) noexcept : shd_vdb_info(values) {}
};
#endif

#if __has_include(<shd/color.h>)
/// Read a config. See shd_color_create().
[[nodiscard]] inline shd_result color_create(
    shd_context* context_,
    const shd_color_desc* desc,
    shd::color& out_color) noexcept {
  shd_color* handle = nullptr;
  const shd_result result = shd_color_create(context_, desc, &handle);
  out_color.reset(handle);
  return result;
}

#endif
/// Make a context. See shd_context_create().
[[nodiscard]] inline shd_result context_create(const shd_context_desc* desc, shd::context& out_context) noexcept {
  shd_context* handle = nullptr;
  const shd_result result = shd_context_create(desc, &handle);
  out_context.reset(handle);
  return result;
}

#if __has_include(<shd/embree.h>)
/// Build a tree of the triangles of draws. Triangles with a position that is not finite are left out. See
/// shd_embree_create().
[[nodiscard]] inline shd_result embree_create(
    shd_context* context_,
    const shd_draw* draws,
    size_t draw_count,
    shd::embree& out_embree) noexcept {
  shd_embree* handle = nullptr;
  const shd_result result = shd_embree_create(context_, draws, draw_count, &handle);
  out_embree.reset(handle);
  return result;
}

#endif
/// Make an environment on the executor of the context. See shd_environment_create().
[[nodiscard]] inline shd_result environment_create(
    shd_context* context_,
    const shd_environment_desc* desc,
    shd::environment& out_environment) noexcept {
  shd_environment* handle = nullptr;
  const shd_result result = shd_environment_create(context_, desc, &handle);
  out_environment.reset(handle);
  return result;
}

/// Make a framebuffer: colour 0, depth 1, AOVs 0, triangle and draw 0xffffffff. See shd_framebuffer_create().
[[nodiscard]] inline shd_result framebuffer_create(
    shd_context* context_,
    const shd_framebuffer_desc* desc,
    shd::framebuffer& out_framebuffer) noexcept {
  shd_framebuffer* handle = nullptr;
  const shd_result result = shd_framebuffer_create(context_, desc, &handle);
  out_framebuffer.reset(handle);
  return result;
}

#if __has_include(<shd/io.h>)
/// Read an image file. See shd_bitmap_load().
[[nodiscard]] inline shd_result bitmap_load(
    shd_context* context_,
    const char* path,
    const shd_load_desc* desc,
    shd::bitmap& out_bitmap) noexcept {
  shd_bitmap* handle = nullptr;
  const shd_result result = shd_bitmap_load(context_, path, desc, &handle);
  out_bitmap.reset(handle);
  return result;
}

/// Read an image file that is in memory, as shd_bitmap_load() does. See shd_bitmap_load_memory().
[[nodiscard]] inline shd_result bitmap_load_memory(
    shd_context* context_,
    const void* bytes,
    size_t size,
    const shd_load_desc* desc,
    shd::bitmap& out_bitmap) noexcept {
  shd_bitmap* handle = nullptr;
  const shd_result result = shd_bitmap_load_memory(context_, bytes, size, desc, &handle);
  out_bitmap.reset(handle);
  return result;
}

/// Make a texture from a file. The content decides its kind: See shd_texture_load().
[[nodiscard]] inline shd_result texture_load(
    shd_context* context_,
    const char* path,
    const shd_load_desc* desc,
    shd::texture& out_texture) noexcept {
  shd_texture* handle = nullptr;
  const shd_result result = shd_texture_load(context_, path, desc, &handle);
  out_texture.reset(handle);
  return result;
}

/// Make a texture from a file that is in memory, as shd_texture_load() does. desc.stack is SHD_ERROR_INVALID_ARGUMENT.
/// See shd_texture_load_memory().
[[nodiscard]] inline shd_result texture_load_memory(
    shd_context* context_,
    const void* bytes,
    size_t size,
    const shd_load_desc* desc,
    shd::texture& out_texture) noexcept {
  shd_texture* handle = nullptr;
  const shd_result result = shd_texture_load_memory(context_, bytes, size, desc, &handle);
  out_texture.reset(handle);
  return result;
}

#endif
/// Make a light. See shd_light_create().
[[nodiscard]] inline shd_result light_create(
    shd_context* context_,
    const shd_light_desc* desc,
    shd::light& out_light) noexcept {
  shd_light* handle = nullptr;
  const shd_result result = shd_light_create(context_, desc, &handle);
  out_light.reset(handle);
  return result;
}

/// Make a material. See shd_material_create().
[[nodiscard]] inline shd_result material_create(
    shd_context* context_,
    const shd_material_desc* desc,
    shd::material& out_material) noexcept {
  shd_material* handle = nullptr;
  const shd_result result = shd_material_create(context_, desc, &handle);
  out_material.reset(handle);
  return result;
}

/// Copy and check vertices and indices; compute normals if there are none. See shd_mesh_create().
[[nodiscard]] inline shd_result mesh_create(
    shd_context* context_,
    const shd_mesh_desc* desc,
    shd::mesh& out_mesh) noexcept {
  shd_mesh* handle = nullptr;
  const shd_result result = shd_mesh_create(context_, desc, &handle);
  out_mesh.reset(handle);
  return result;
}

/// Make the mesh of a shape: shd_shape_fill() and shd_mesh_create() in one call. See shd_mesh_create_shape().
[[nodiscard]] inline shd_result mesh_create_shape(
    shd_context* context_,
    const shd_shape_desc* desc,
    shd_mesh_flags flags,
    shd::mesh& out_mesh) noexcept {
  shd_mesh* handle = nullptr;
  const shd_result result = shd_mesh_create_shape(context_, desc, flags, &handle);
  out_mesh.reset(handle);
  return result;
}

/// Copy and check vertices and triangles. See shd_polyhedron_create().
[[nodiscard]] inline shd_result polyhedron_create(
    shd_context* context_,
    const shd_polyhedron_desc* desc,
    shd::polyhedron& out_polyhedron) noexcept {
  shd_polyhedron* handle = nullptr;
  const shd_result result = shd_polyhedron_create(context_, desc, &handle);
  out_polyhedron.reset(handle);
  return result;
}

/// Make a sampler. See shd_sampler_create().
[[nodiscard]] inline shd_result sampler_create(
    shd_context* context_,
    const shd_sampler_desc* desc,
    shd::sampler& out_sampler) noexcept {
  shd_sampler* handle = nullptr;
  const shd_result result = shd_sampler_create(context_, desc, &handle);
  out_sampler.reset(handle);
  return result;
}

#if __has_include(<shd/scene.h>)
/// Read a model file. See shd_scene_load().
[[nodiscard]] inline shd_result scene_load(
    shd_context* context_,
    const char* path,
    const shd_scene_desc* desc,
    shd::scene& out_scene) noexcept {
  shd_scene* handle = nullptr;
  const shd_result result = shd_scene_load(context_, path, desc, &handle);
  out_scene.reset(handle);
  return result;
}

/// Read a model file in memory. The files that it names come from shd_scene_desc.find. See shd_scene_load_memory().
[[nodiscard]] inline shd_result scene_load_memory(
    shd_context* context_,
    const void* bytes,
    size_t size,
    const char* name,
    const shd_scene_desc* desc,
    shd::scene& out_scene) noexcept {
  shd_scene* handle = nullptr;
  const shd_result result = shd_scene_load_memory(context_, bytes, size, name, desc, &handle);
  out_scene.reset(handle);
  return result;
}

/// Make a scene of the file at some second of an animation, with all that nodes move: instances, skins, morph targets,
/// lights and cameras. Interpolation is that of glTF 2.0, appendix C. The new scene does not depend on the pose of
/// `scene`. It shares materials, textures and all meshes without skins and morph targets with it; parts keep their
/// indices, except instances, lights and cameras whose numbers are out of range in the pose, which give a warning. See
/// shd_scene_pose().
[[nodiscard]] inline shd_result scene_pose(
    const shd_scene* scene_,
    size_t animation,
    double seconds,
    shd::scene& out_scene) noexcept {
  shd_scene* handle = nullptr;
  const shd_result result = shd_scene_pose(scene_, animation, seconds, &handle);
  out_scene.reset(handle);
  return result;
}

#endif
/// Make a shadow without a map. Call shd_shadow_render() before any lookup. See shd_shadow_create().
[[nodiscard]] inline shd_result shadow_create(
    shd_context* context_,
    const shd_shadow_desc* desc,
    shd::shadow& out_shadow) noexcept {
  shd_shadow* handle = nullptr;
  const shd_result result = shd_shadow_create(context_, desc, &handle);
  out_shadow.reset(handle);
  return result;
}

/// Make a mesh of smaller triangles. See shd_mesh_tessellate().
[[nodiscard]] inline shd_result mesh_tessellate(
    shd_context* context_,
    const shd_mesh* mesh_,
    const shd_tessellation_desc* desc,
    shd::mesh& out_mesh) noexcept {
  shd_mesh* handle = nullptr;
  const shd_result result = shd_mesh_tessellate(context_, mesh_, desc, &handle);
  out_mesh.reset(handle);
  return result;
}

/// Make a texture: copy or borrow texels, and build the tables. See shd_texture_create().
[[nodiscard]] inline shd_result texture_create(
    shd_context* context_,
    const shd_texture_desc* desc,
    shd::texture& out_texture) noexcept {
  shd_texture* handle = nullptr;
  const shd_result result = shd_texture_create(context_, desc, &handle);
  out_texture.reset(handle);
  return result;
}

/// Make a tile cache. See shd_tile_cache_create().
[[nodiscard]] inline shd_result tile_cache_create(
    shd_context* context_,
    const shd_tile_cache_desc* desc,
    shd::tile_cache& out_cache) noexcept {
  shd_tile_cache* handle = nullptr;
  const shd_result result = shd_tile_cache_create(context_, desc, &handle);
  out_cache.reset(handle);
  return result;
}

#if __has_include(<shd/tile_file.h>)
/// Open a tiled file, or a UDIM set, as a texture. See shd_texture_open().
[[nodiscard]] inline shd_result texture_open(
    shd_context* context_,
    const char* path,
    const shd_tile_file_desc* desc,
    shd::texture& out_texture,
    shd_tile_file_info* out_info) noexcept {
  shd_texture* handle = nullptr;
  const shd_result result = shd_texture_open(context_, path, desc, &handle, out_info);
  out_texture.reset(handle);
  return result;
}

#endif
/// Make a volume. Finds the range of density in each block of the texture, so that rays skip blocks without extinction;
/// the pictures have the same bits as without skipping. A texture in tiles loads each tile of its base level once; a
/// tile that cannot be loaded fails the call. See shd_volume_create().
[[nodiscard]] inline shd_result volume_create(
    shd_context* context_,
    const shd_volume_desc* desc,
    shd::volume& out_volume) noexcept {
  shd_volume* handle = nullptr;
  const shd_result result = shd_volume_create(context_, desc, &handle);
  out_volume.reset(handle);
  return result;
}


#ifdef __cpp_exceptions
/// Shade the surfaces of draws into a framebuffer at their texture coordinates. See shd_bake().
inline void bake(shd_context* context_, const shd_render_desc* frame, const shd_bake_desc* desc) {
  check(shd_bake(context_, frame, desc));
}

/// Get the precision that the rules of a graphics API require at least. See shd_bounds_desc_from_rules().
inline shd_bounds_desc bounds_desc_from_rules(shd_rules rules) {
  shd_bounds_desc made = shd_bounds_desc_default();
  check(shd_bounds_desc_from_rules(rules, &made));
  return made;
}

/// Compute the legal values of `lookups->count` lookups. See shd_texture_bounds().
inline void texture_bounds(
    const shd_texture* texture_,
    const shd_sampler* sampler_,
    const shd_lookups* lookups,
    const shd_bounds_desc* desc,
    shd_texels* lower,
    shd_texels* upper) {
  check(shd_texture_bounds(texture_, sampler_, lookups, desc, lower, upper));
}

#if __has_include(<shd/color.h>)
/// Read a config. See shd_color_create().
inline shd::color color_create(shd_context* context_, const shd_color_desc* desc) {
  shd::color made;
  check(color_create(context_, desc, made));
  return made;
}

/// Transform a framebuffer for a display. See shd_color_apply_display().
inline void color_apply_display(
    const shd_color* color_,
    const shd_framebuffer* framebuffer_,
    const char* display,
    const char* view,
    const shd_image* out_) {
  check(shd_color_apply_display(color_, framebuffer_, display, view, out_));
}

/// Render a frame and transform it for a display, tile by tile. See shd_color_render().
inline void color_render(
    const shd_color* color_,
    const shd_render_desc* render,
    const char* display,
    const char* view,
    const shd_image* out_) {
  check(shd_color_render(color_, render, display, view, out_));
}

/// Callback for shd_display.apply that calls shd_color_apply_display(), so that one call saves a display image:
/// `save.display.apply = shd_color_apply_view, save.display.user_data = &view`. See shd_color_apply_view().
inline void color_apply_view(
    const shd_framebuffer* framebuffer_,
    const shd_image* out_,
    void* color_view) {
  check(shd_color_apply_view(framebuffer_, out_, color_view));
}

/// Transform an image for a display, as shd_color_apply_display() does with a framebuffer. See
/// shd_color_apply_display_image().
inline void color_apply_display_image(
    const shd_color* color_,
    const shd_image* in_,
    const char* from_space,
    const char* display,
    const char* view,
    const shd_image* out_) {
  check(shd_color_apply_display_image(color_, in_, from_space, display, view, out_));
}

/// Convert an image from one colour space to another in place. See shd_color_convert().
inline void color_convert(
    const shd_color* color_,
    const shd_image* in_out,
    const char* from_space,
    const char* to_space) {
  check(shd_color_convert(color_, in_out, from_space, to_space));
}

#endif
/// Make a context. See shd_context_create().
inline shd::context context_create(const shd_context_desc* desc) {
  shd::context made;
  check(context_create(desc, made));
  return made;
}

/// Write the defaults of a sized struct into the caller's memory and set its struct_size. See shd_desc_init().
inline void desc_init(shd_desc_kind kind, void* ptr, size_t size) {
  check(shd_desc_init(kind, ptr, size));
}

/// Find all edges of the requested kinds in a mesh. Each edge is listed once, in the order of the edges' first
/// triangles. See shd_mesh_find_edges().
inline void mesh_find_edges(
    const shd_mesh* mesh_,
    const shd_edges_desc* desc,
    size_t capacity,
    const shd_edges* out_,
    size_t* out_count) {
  check(shd_mesh_find_edges(mesh_, desc, capacity, out_, out_count));
}

#if __has_include(<shd/embree.h>)
/// Build a tree of the triangles of draws. Triangles with a position that is not finite are left out. See
/// shd_embree_create().
inline shd::embree embree_create(shd_context* context_, const shd_draw* draws, size_t draw_count) {
  shd::embree made;
  check(embree_create(context_, draws, draw_count, made));
  return made;
}

/// Get the tracer of a tree. See shd_embree_get_tracer().
inline shd_tracer embree_get_tracer(const shd_embree* embree_) {
  shd_tracer made = {};
  check(shd_embree_get_tracer(embree_, &made));
  return made;
}

#endif
/// Make an environment on the executor of the context. See shd_environment_create().
inline shd::environment environment_create(shd_context* context_, const shd_environment_desc* desc) {
  shd::environment made;
  check(environment_create(context_, desc, made));
  return made;
}

/// Get the properties of an environment. See shd_environment_get_info().
inline shd_environment_info environment_get_info(const shd_environment* environment_) {
  shd_environment_info made = shd_environment_info_default();
  check(shd_environment_get_info(environment_, &made));
  return made;
}

/// Look up the irradiance of surfaces whose normals are the directions, on the executor of the environment's context.
/// See shd_environment_sample_irradiance().
inline void environment_sample_irradiance(
    const shd_environment* environment_,
    const shd_environment_lookups* lookups,
    shd_environment_values* out_) {
  check(shd_environment_sample_irradiance(environment_, lookups, out_));
}

/// Look up the radiance, or its mean over lobes, on the executor of the environment's context. See
/// shd_environment_sample_radiance().
inline void environment_sample_radiance(
    const shd_environment* environment_,
    const shd_environment_lookups* lookups,
    shd_environment_values* out_) {
  check(shd_environment_sample_radiance(environment_, lookups, out_));
}

/// Explain lookup `index` of a batch. Call once without memory for the counts, then again with it. See
/// shd_texture_explain().
inline void texture_explain(
    const shd_texture* texture_,
    const shd_sampler* sampler_,
    const shd_lookups* lookups,
    size_t index,
    shd_explanation* explanation) {
  check(shd_texture_explain(texture_, sampler_, lookups, index, explanation));
}

/// Compute derivatives from ray differentials. See shd_derivatives_from_differentials().
inline void derivatives_from_differentials(
    shd_context* context_,
    const shd_ray_differentials* rays,
    shd_derivatives* out_) {
  check(shd_derivatives_from_differentials(context_, rays, out_));
}

/// Compute derivatives from ray cones. See shd_derivatives_from_cones().
inline void derivatives_from_cones(
    shd_context* context_,
    const shd_ray_cones* cones,
    shd_derivatives* out_) {
  check(shd_derivatives_from_cones(context_, cones, out_));
}

/// Make a framebuffer: colour 0, depth 1, AOVs 0, triangle and draw 0xffffffff. See shd_framebuffer_create().
inline shd::framebuffer framebuffer_create(shd_context* context_, const shd_framebuffer_desc* desc) {
  shd::framebuffer made;
  check(framebuffer_create(context_, desc, made));
  return made;
}

/// Get size and planes of a framebuffer. See shd_framebuffer_get_info().
inline shd_framebuffer_info framebuffer_get_info(const shd_framebuffer* framebuffer_) {
  shd_framebuffer_info made = shd_framebuffer_info_default();
  check(shd_framebuffer_get_info(framebuffer_, &made));
  return made;
}

/// Get the position of a sample in its pixel. Positions and order are the standard sample locations of the Vulkan 1.3
/// specification ("Multisampling"), which are those of Direct3D 11's standard pattern. They are multiples of 1/16
/// pixel. See shd_sample_position().
inline void sample_position(size_t sample_count, size_t index, float* out_x, float* out_y) {
  check(shd_sample_position(sample_count, index, out_x, out_y));
}

/// Get a plane without copying. See shd_framebuffer_view_plane().
inline shd_plane_view framebuffer_view_plane(const shd_framebuffer* framebuffer_, shd_plane plane) {
  shd_plane_view made = shd_plane_view_default();
  check(shd_framebuffer_view_plane(framebuffer_, plane, &made));
  return made;
}

/// Get interleaved colour without copying. See shd_framebuffer_view_color().
inline shd_image framebuffer_view_color(const shd_framebuffer* framebuffer_) {
  shd_image made = shd_image_default();
  check(shd_framebuffer_view_color(framebuffer_, &made));
  return made;
}

/// Copy a float plane into a column. R, G, B and A are decoded to linear floats if colour is interleaved. See
/// shd_framebuffer_read_plane().
inline void framebuffer_read_plane(
    const shd_framebuffer* framebuffer_,
    shd_plane plane,
    const shd_f32_out* out_) {
  check(shd_framebuffer_read_plane(framebuffer_, plane, out_));
}

/// Copy a plane of uint32_t into a column. See shd_framebuffer_read_u32_plane().
inline void framebuffer_read_u32_plane(
    const shd_framebuffer* framebuffer_,
    shd_plane plane,
    const shd_u32_out* out_) {
  check(shd_framebuffer_read_u32_plane(framebuffer_, plane, out_));
}

/// Copy colour as interleaved RGBA. Pixels of the framebuffer's own color_format are copied bit by bit. See
/// shd_framebuffer_read_color().
inline void framebuffer_read_color(const shd_framebuffer* framebuffer_, const shd_image* out_) {
  check(shd_framebuffer_read_color(framebuffer_, out_));
}

#if __has_include(<shd/io.h>)
/// Read an image file. See shd_bitmap_load().
inline shd::bitmap bitmap_load(shd_context* context_, const char* path, const shd_load_desc* desc) {
  shd::bitmap made;
  check(bitmap_load(context_, path, desc, made));
  return made;
}

/// Read an image file that is in memory, as shd_bitmap_load() does. See shd_bitmap_load_memory().
inline shd::bitmap bitmap_load_memory(
    shd_context* context_,
    const void* bytes,
    size_t size,
    const shd_load_desc* desc) {
  shd::bitmap made;
  check(bitmap_load_memory(context_, bytes, size, desc, made));
  return made;
}

/// Get the pixels without copying. See shd_bitmap_get_image().
inline shd_image bitmap_get_image(const shd_bitmap* bitmap_) {
  shd_image made = shd_image_default();
  check(shd_bitmap_get_image(bitmap_, &made));
  return made;
}

/// Get format and properties of a loaded file. See shd_bitmap_get_info().
inline shd_bitmap_info bitmap_get_info(const shd_bitmap* bitmap_) {
  shd_bitmap_info made = shd_bitmap_info_default();
  check(shd_bitmap_get_info(bitmap_, &made));
  return made;
}

/// Make a texture from a file. The content decides its kind: See shd_texture_load().
inline shd::texture texture_load(shd_context* context_, const char* path, const shd_load_desc* desc) {
  shd::texture made;
  check(texture_load(context_, path, desc, made));
  return made;
}

/// Make a texture from a file that is in memory, as shd_texture_load() does. desc.stack is SHD_ERROR_INVALID_ARGUMENT.
/// See shd_texture_load_memory().
inline shd::texture texture_load_memory(
    shd_context* context_,
    const void* bytes,
    size_t size,
    const shd_load_desc* desc) {
  shd::texture made;
  check(texture_load_memory(context_, bytes, size, desc, made));
  return made;
}

/// Write a framebuffer. The extension of `path` decides the format: See shd_framebuffer_save().
inline void framebuffer_save(
    const shd_framebuffer* framebuffer_,
    const char* path,
    const shd_save_desc* desc) {
  check(shd_framebuffer_save(framebuffer_, path, desc));
}

/// Write an image without conversion. Paths and files are handled as by shd_framebuffer_save(). See shd_image_save().
inline void image_save(const shd_image* image, const char* path, const shd_save_desc* desc) {
  check(shd_image_save(image, path, desc));
}

#endif
/// Make a light. See shd_light_create().
inline shd::light light_create(shd_context* context_, const shd_light_desc* desc) {
  shd::light made;
  check(light_create(context_, desc, made));
  return made;
}

/// Filter `lookups->count` points of a texture. See shd_texture_sample().
inline void texture_sample(
    const shd_texture* texture_,
    const shd_sampler* sampler_,
    const shd_lookups* lookups,
    shd_texels* out_) {
  check(shd_texture_sample(texture_, sampler_, lookups, out_));
}

/// Compute the levels of detail of `lookups->count` points, as trilinear filtering uses them. See
/// shd_texture_query_levels().
inline void texture_query_levels(
    const shd_texture* texture_,
    const shd_sampler* sampler_,
    const shd_lookups* lookups,
    shd_levels* out_) {
  check(shd_texture_query_levels(texture_, sampler_, lookups, out_));
}

/// Make a material. See shd_material_create().
inline shd::material material_create(shd_context* context_, const shd_material_desc* desc) {
  shd::material made;
  check(material_create(context_, desc, made));
  return made;
}

/// Copy and check vertices and indices; compute normals if there are none. See shd_mesh_create().
inline shd::mesh mesh_create(shd_context* context_, const shd_mesh_desc* desc) {
  shd::mesh made;
  check(mesh_create(context_, desc, made));
  return made;
}

/// Make the mesh of a shape: shd_shape_fill() and shd_mesh_create() in one call. See shd_mesh_create_shape().
inline shd::mesh mesh_create_shape(
    shd_context* context_,
    const shd_shape_desc* desc,
    shd_mesh_flags flags) {
  shd::mesh made;
  check(mesh_create_shape(context_, desc, flags, made));
  return made;
}

/// Get counts and bounds of a mesh. See shd_mesh_get_info().
inline shd_mesh_info mesh_get_info(const shd_mesh* mesh_) {
  shd_mesh_info made = shd_mesh_info_default();
  check(shd_mesh_get_info(mesh_, &made));
  return made;
}

/// Copy the positions out, object space. See shd_mesh_read_positions().
inline void mesh_read_positions(const shd_mesh* mesh_, const shd_f32_out* out_) {
  check(shd_mesh_read_positions(mesh_, out_));
}

/// Copy the unit vertex normals out, given or computed. See shd_mesh_read_normals().
inline void mesh_read_normals(const shd_mesh* mesh_, const shd_f32_out* out_) {
  check(shd_mesh_read_normals(mesh_, out_));
}

/// Copy the tangents out, given or computed; 0 if the mesh has none. See shd_mesh_read_tangents().
inline void mesh_read_tangents(const shd_mesh* mesh_, const shd_f32_out* out_) {
  check(shd_mesh_read_tangents(mesh_, out_));
}

/// Copy the texture coordinates out; 0 if the mesh has none. See shd_mesh_read_uv().
inline void mesh_read_uv(const shd_mesh* mesh_, const shd_f32_out* out_) {
  check(shd_mesh_read_uv(mesh_, out_));
}

/// Copy the second set of texture coordinates out; 0 if the mesh has none. See shd_mesh_read_uv1().
inline void mesh_read_uv1(const shd_mesh* mesh_, const shd_f32_out* out_) {
  check(shd_mesh_read_uv1(mesh_, out_));
}

/// Copy one of the caller's own columns out; 0 if it was absent. See shd_mesh_read_attribute().
inline void mesh_read_attribute(const shd_mesh* mesh_, uint32_t index, const shd_f32_out* out_) {
  check(shd_mesh_read_attribute(mesh_, index, out_));
}

/// Copy the indices out as separate triangles, also for strips and fans. See shd_mesh_read_indices().
inline void mesh_read_indices(const shd_mesh* mesh_, const shd_u32_out* out_) {
  check(shd_mesh_read_indices(mesh_, out_));
}

/// Make mip levels 1..level_count of an image, in the caller's memory, on the context's executor. See shd_mip_build().
inline void mip_build(
    shd_context* context_,
    const shd_image* base,
    const shd_mip_desc* desc,
    size_t level_count,
    const shd_image* levels) {
  check(shd_mip_build(context_, base, desc, level_count, levels));
}

/// Make the normal map of a height map (Blinn, "Simulation of Wrinkled Surfaces", 1978). See shd_mip_build_normals().
inline void mip_build_normals(
    shd_context* context_,
    const shd_image* heights,
    const shd_normals_desc* desc,
    const shd_image* out_) {
  check(shd_mip_build_normals(context_, heights, desc, out_));
}

/// Turn a normal map into the moments of its slopes, whose averages keep the roughness of normals. See
/// shd_mip_build_moments().
inline void mip_build_moments(
    shd_context* context_,
    const shd_image* normals,
    const shd_image* out_,
    const shd_image* mixed) {
  check(shd_mip_build_moments(context_, normals, out_, mixed));
}

/// Compute the occlusion of points. See shd_occlusion_compute().
inline void occlusion_compute(
    shd_context* context_,
    const shd_occlusion_desc* desc,
    const shd_occlusion_points* points,
    shd_occlusion_values* out_) {
  check(shd_occlusion_compute(context_, desc, points, out_));
}

/// Compute the occlusion of the vertices of a draw, with their vertex normals. Its mesh and object_to_world are read.
/// See shd_occlusion_compute_vertices().
inline void occlusion_compute_vertices(
    shd_context* context_,
    const shd_occlusion_desc* desc,
    const shd_draw* draw,
    const shd_f32_out* out_) {
  check(shd_occlusion_compute_vertices(context_, desc, draw, out_));
}

/// Compute the occlusion of the texels of a texture, each at the point where shd_bake() shades it. See
/// shd_occlusion_bake().
inline void occlusion_bake(
    shd_context* context_,
    const shd_occlusion_desc* desc,
    const shd_occlusion_atlas* atlas,
    const shd_f32_out* out_) {
  check(shd_occlusion_bake(context_, desc, atlas, out_));
}

/// Compute the barycentric coordinates of points. See shd_polygon_evaluate().
inline void polygon_evaluate(
    shd_context* context_,
    const shd_polygon_desc* desc,
    const shd_polygon_points* points,
    shd_polygon_weights* out_) {
  check(shd_polygon_evaluate(context_, desc, points, out_));
}

/// Copy and check vertices and triangles. See shd_polyhedron_create().
inline shd::polyhedron polyhedron_create(shd_context* context_, const shd_polyhedron_desc* desc) {
  shd::polyhedron made;
  check(polyhedron_create(context_, desc, made));
  return made;
}

/// Compute the barycentric coordinates of points. See shd_polyhedron_evaluate().
inline void polyhedron_evaluate(
    const shd_polyhedron* polyhedron_,
    const shd_polyhedron_points* points,
    shd_polyhedron_weights* out_) {
  check(shd_polyhedron_evaluate(polyhedron_, points, out_));
}

/// Interpolate values of the vertices at points, without storing the coordinates. See shd_polyhedron_interpolate().
inline void polyhedron_interpolate(
    const shd_polyhedron* polyhedron_,
    const shd_polyhedron_points* points,
    shd_polyhedron_values* out_) {
  check(shd_polyhedron_interpolate(polyhedron_, points, out_));
}

/// Project directions to points of an image, with derivatives. See shd_projection_project().
inline void projection_project(
    shd_context* context_,
    const shd_directions* directions,
    shd_projected_points* out_) {
  check(shd_projection_project(context_, directions, out_));
}

/// Compute the directions of points of an image. See shd_projection_unproject().
inline void projection_unproject(
    shd_context* context_,
    const shd_image_points* points,
    shd_point_directions* out_) {
  check(shd_projection_unproject(context_, points, out_));
}

/// Convert images of directions to another projection, layout, size or format. See shd_projection_convert().
inline void projection_convert(
    shd_context* context_,
    const shd_direction_images* from,
    const shd_direction_images* to) {
  check(shd_projection_convert(context_, from, to));
}

/// Render a frame. See shd_render().
inline void render(shd_context* context_, const shd_render_desc* desc) {
  check(shd_render(context_, desc));
}

/// Make a sampler. See shd_sampler_create().
inline shd::sampler sampler_create(shd_context* context_, const shd_sampler_desc* desc) {
  shd::sampler made;
  check(sampler_create(context_, desc, made));
  return made;
}

#if __has_include(<shd/scene.h>)
/// Read a model file. See shd_scene_load().
inline shd::scene scene_load(shd_context* context_, const char* path, const shd_scene_desc* desc) {
  shd::scene made;
  check(scene_load(context_, path, desc, made));
  return made;
}

/// Read a model file in memory. The files that it names come from shd_scene_desc.find. See shd_scene_load_memory().
inline shd::scene scene_load_memory(
    shd_context* context_,
    const void* bytes,
    size_t size,
    const char* name,
    const shd_scene_desc* desc) {
  shd::scene made;
  check(scene_load_memory(context_, bytes, size, name, desc, made));
  return made;
}

/// Counts and bounds of a scene. See shd_scene_get_info().
inline shd_scene_info scene_get_info(const shd_scene* scene_) {
  shd_scene_info made = shd_scene_info_default();
  check(shd_scene_get_info(scene_, &made));
  return made;
}

/// The desc of a material, as a starting point for variants of it. See shd_scene_get_material_desc().
inline shd_material_desc scene_get_material_desc(const shd_scene* scene_, size_t index) {
  shd_material_desc made = shd_material_desc_default();
  check(shd_scene_get_material_desc(scene_, index, &made));
  return made;
}

/// The desc of a light. See shd_scene_get_light_desc().
inline shd_light_desc scene_get_light_desc(const shd_scene* scene_, size_t index) {
  shd_light_desc made = shd_light_desc_default();
  check(shd_scene_get_light_desc(scene_, index, &made));
  return made;
}

/// A camera of the file. If the file has no aspect, it is 0, which means the aspect of the picture. If the file has no
/// near and far plane, they enclose the whole model. See shd_scene_get_camera().
inline shd_camera scene_get_camera(const shd_scene* scene_, size_t index) {
  shd_camera made = shd_camera_default();
  check(shd_scene_get_camera(scene_, index, &made));
  return made;
}

/// An instance of the scene. See shd_scene_get_instance().
inline shd_scene_instance scene_get_instance(const shd_scene* scene_, size_t index) {
  shd_scene_instance made = shd_scene_instance_default();
  check(shd_scene_get_instance(scene_, index, &made));
  return made;
}

/// Set draws, draw_count, lights and light_count of a frame: one draw for each instance, in their order, and the lights
/// of the file. All other fields stay as they are. The caller sets the camera and the framebuffer, and adds lights if
/// the file has none. See shd_scene_fill_render().
inline void scene_fill_render(const shd_scene* scene_, shd_render_desc* in_out_render) {
  check(shd_scene_fill_render(scene_, in_out_render));
}

/// The times of an animation [s]: its first key and its last one. Poses before and after are those of the keys. Its
/// name is that of SHD_SCENE_PART_ANIMATION. See shd_scene_get_animation_times().
inline void scene_get_animation_times(
    const shd_scene* scene_,
    size_t index,
    double* out_first,
    double* out_last) {
  check(shd_scene_get_animation_times(scene_, index, out_first, out_last));
}

/// Make a scene of the file at some second of an animation, with all that nodes move: instances, skins, morph targets,
/// lights and cameras. Interpolation is that of glTF 2.0, appendix C. The new scene does not depend on the pose of
/// `scene`. It shares materials, textures and all meshes without skins and morph targets with it; parts keep their
/// indices, except instances, lights and cameras whose numbers are out of range in the pose, which give a warning. See
/// shd_scene_pose().
inline shd::scene scene_pose(const shd_scene* scene_, size_t animation, double seconds) {
  shd::scene made;
  check(scene_pose(scene_, animation, seconds, made));
  return made;
}

#endif
/// Make a shadow without a map. Call shd_shadow_render() before any lookup. See shd_shadow_create().
inline shd::shadow shadow_create(shd_context* context_, const shd_shadow_desc* desc) {
  shd::shadow made;
  check(shadow_create(context_, desc, made));
  return made;
}

/// Render the map and replace the previous one. On failure the previous map stays. See shd_shadow_render().
inline void shadow_render(
    shd_context* context_,
    shd_shadow* shadow_,
    const shd_shadow_render_desc* desc) {
  check(shd_shadow_render(context_, shadow_, desc));
}

/// Get size and range of a rendered map. See shd_shadow_get_info().
inline shd_shadow_info shadow_get_info(const shd_shadow* shadow_) {
  shd_shadow_info made = shd_shadow_info_default();
  check(shd_shadow_get_info(shadow_, &made));
  return made;
}

/// Copy a face of the map out, as its filter reads it, row by row from the top. See shd_shadow_read_map().
inline void shadow_read_map(const shd_shadow* shadow_, uint32_t face, const shd_f32_out* out_) {
  check(shd_shadow_read_map(shadow_, face, out_));
}

/// Compute the fraction of the light that reaches each point, 0 (in shadow) to 1 (lit), as frames do. See
/// shd_shadow_sample().
inline void shadow_sample(
    const shd_shadow* shadow_,
    const shd_shadow_lookups* lookups,
    shd_shadow_values* out_) {
  check(shd_shadow_sample(shadow_, lookups, out_));
}

/// Compute the numbers of vertices and indices of a shape. See shd_shape_count().
inline void shape_count(const shd_shape_desc* desc, size_t* out_vertex_count, size_t* out_index_count) {
  check(shd_shape_count(desc, out_vertex_count, out_index_count));
}

/// Write a shape. Elements beyond the numbers from shd_shape_count() do not change. See shd_shape_fill().
inline void shape_fill(const shd_shape_desc* desc, const shd_shape_columns* columns) {
  check(shd_shape_fill(desc, columns));
}

/// Evaluate a solid texture at `points->count` points. See shd_solid_evaluate().
inline void solid_evaluate(
    shd_context* context_,
    const shd_solid_desc* desc,
    const shd_solid_points* points,
    shd_solid_values* out_) {
  check(shd_solid_evaluate(context_, desc, points, out_));
}

/// Get the size of a level, of sums or of a picture. See shd_texture_get_table_info().
inline shd_table_info texture_get_table_info(const shd_texture* texture_, const shd_table_desc* desc) {
  shd_table_info made = shd_table_info_default();
  check(shd_texture_get_table_info(texture_, desc, &made));
  return made;
}

/// Copy a level, sums or a picture into columns, on the executor of the texture's context. See
/// shd_texture_read_table().
inline void texture_read_table(
    const shd_texture* texture_,
    const shd_table_desc* desc,
    const shd_f32_out* out_) {
  check(shd_texture_read_table(texture_, desc, out_));
}

/// Make a mesh of smaller triangles. See shd_mesh_tessellate().
inline shd::mesh mesh_tessellate(
    shd_context* context_,
    const shd_mesh* mesh_,
    const shd_tessellation_desc* desc) {
  shd::mesh made;
  check(mesh_tessellate(context_, mesh_, desc, made));
  return made;
}

/// Make a texture: copy or borrow texels, and build the tables. See shd_texture_create().
inline shd::texture texture_create(shd_context* context_, const shd_texture_desc* desc) {
  shd::texture made;
  check(texture_create(context_, desc, made));
  return made;
}

/// Get size, format and memory of a texture. See shd_texture_get_info().
inline shd_texture_info texture_get_info(const shd_texture* texture_) {
  shd_texture_info made = shd_texture_info_default();
  check(shd_texture_get_info(texture_, &made));
  return made;
}

/// Copy one mip level of a layer, or a slice of it in 3D, out as stored: sRGB stays encoded, and the swizzle does not
/// apply. The fourth channel of a format of three is 0 here, while lookups give `fill`. Tiles of blocks are read again.
/// shd_texture_read_table() gives linear values of all tables. See shd_texture_read_level().
inline void texture_read_level(
    const shd_texture* texture_,
    uint32_t layer,
    uint32_t level,
    const shd_image* out_) {
  check(shd_texture_read_level(texture_, layer, level, out_));
}

/// Write a rectangle of the base level of one layer or slice, and rebuild the tables that depend on it. Textures of
/// compressed blocks give SHD_ERROR_UNSUPPORTED. See shd_texture_update().
inline void texture_update(
    shd_texture* texture_,
    uint32_t layer,
    uint32_t x,
    uint32_t y,
    const shd_image* texels) {
  check(shd_texture_update(texture_, layer, x, y, texels));
}

#if __has_include(<shd/texture_file.h>)
/// Write a texture to a KTX 2.0 file: all levels, layers, slices and faces, as stored. Blocks stay compressed. The
/// swizzle of the texture is not written. See shd_texture_save_ktx2().
inline void texture_save_ktx2(const shd_texture* texture_, const char* path, const shd_ktx2_desc* desc) {
  check(shd_texture_save_ktx2(texture_, path, desc));
}

#endif
/// Make a tile cache. See shd_tile_cache_create().
inline shd::tile_cache tile_cache_create(shd_context* context_, const shd_tile_cache_desc* desc) {
  shd::tile_cache made;
  check(tile_cache_create(context_, desc, made));
  return made;
}

/// Get the counters of a cache. See shd_tile_cache_get_stats().
inline shd_tile_cache_stats tile_cache_get_stats(const shd_tile_cache* cache) {
  shd_tile_cache_stats made = shd_tile_cache_stats_default();
  check(shd_tile_cache_get_stats(cache, &made));
  return made;
}

/// Load tiles that lookups with SHD_MISSING_TILES_COARSER did not find, the latest request first. A cache keeps the
/// latest requests: up to 4096, or fewer if it has fewer tiles. An engine calls this on the threads that stream. See
/// shd_tile_cache_load_requested().
inline void tile_cache_load_requested(shd_tile_cache* cache, size_t max_tiles, size_t* out_loaded_count) {
  check(shd_tile_cache_load_requested(cache, max_tiles, out_loaded_count));
}

#if __has_include(<shd/tile_file.h>)
/// Open a tiled file, or a UDIM set, as a texture. See shd_texture_open().
inline shd::texture texture_open(
    shd_context* context_,
    const char* path,
    const shd_tile_file_desc* desc,
    shd_tile_file_info* out_info) {
  shd::texture made;
  check(texture_open(context_, path, desc, made, out_info));
  return made;
}

#endif
/// Load the tiles of a region that are not resident. They may be evicted again, also by later tiles of the region if it
/// is larger than the cache. See shd_texture_load_tiles().
inline void texture_load_tiles(const shd_texture* texture_, const shd_tile_region* region) {
  check(shd_texture_load_tiles(texture_, region));
}

/// Load the tiles of a region, and keep them until shd_texture_unpin_tiles(). Each call counts. Half of the tiles of a
/// cache can be pinned; more give SHD_ERROR_LIMIT. If the call fails, it pins no tile. See shd_texture_pin_tiles().
inline void texture_pin_tiles(const shd_texture* texture_, const shd_tile_region* region) {
  check(shd_texture_pin_tiles(texture_, region));
}

/// Undo one shd_texture_pin_tiles() of the same region. A region with a tile that is not pinned gives
/// SHD_ERROR_INVALID_ARGUMENT, and nothing changes. See shd_texture_unpin_tiles().
inline void texture_unpin_tiles(const shd_texture* texture_, const shd_tile_region* region) {
  check(shd_texture_unpin_tiles(texture_, region));
}

/// Drop the tiles of a region, and the tiles of all coarser levels that cover it, because their source has changed.
/// Lookups that begin later load them again; lookups that run meanwhile may use either content. Pinned tiles stay
/// pinned. This call loads them again. If a load fails, it returns the error, and the next call that needs a tile loads
/// it. See shd_texture_drop_tiles().
inline void texture_drop_tiles(const shd_texture* texture_, const shd_tile_region* region) {
  check(shd_texture_drop_tiles(texture_, region));
}

/// Perspective projection, view to clip space. With SHD_DEPTH_ORDER_FORWARD and a finite far plane it has the bits of
/// shd_view_from_camera(). See shd_matrix_perspective().
inline void matrix_perspective(
    float fov_y,
    float aspect,
    float near_plane,
    float far_plane,
    shd_depth_order order,
    float* out_matrix) {
  check(shd_matrix_perspective(fov_y, aspect, near_plane, far_plane, order, out_matrix));
}

/// Parallel projection, view to clip space. See shd_matrix_orthographic().
inline void matrix_orthographic(
    const float* rectangle,
    float near_plane,
    float far_plane,
    shd_depth_order order,
    float* out_matrix) {
  check(shd_matrix_orthographic(rectangle, near_plane, far_plane, order, out_matrix));
}

/// Rigid transform from world to view space: the eye is at the origin, the target on -Z. It has the bits of
/// shd_view_from_camera(). See shd_matrix_look_at().
inline void matrix_look_at(const float* eye, const float* target, const float* up, float* out_matrix) {
  check(shd_matrix_look_at(eye, target, up, out_matrix));
}

/// translation * rotation * scale, as glTF 2.0 places nodes. See shd_matrix_from_trs().
inline void matrix_from_trs(
    const float* translation,
    const float* rotation,
    const float* scale,
    float* out_matrix) {
  check(shd_matrix_from_trs(translation, rotation, scale, out_matrix));
}

/// The product a b. Applied to a vector, b acts first. See shd_matrix_multiply().
inline void matrix_multiply(const float* a, const float* b, float* out_matrix) {
  check(shd_matrix_multiply(a, b, out_matrix));
}

/// The inverse. An affine matrix, with (0, 0, 0, 1) as its last row, has an affine inverse. See shd_matrix_invert().
inline void matrix_invert(const float* matrix, float* out_matrix) {
  check(shd_matrix_invert(matrix, out_matrix));
}

/// The matrix for normals that belongs to `matrix`: the inverse transpose of its upper left 3 x 3. Transformed normals
/// are not unit vectors and need normalising. shd_render() transforms normals by itself. See shd_matrix_normal().
inline void matrix_normal(const float* matrix, float* out_3x3) {
  check(shd_matrix_normal(matrix, out_3x3));
}

/// A point, (x, y, z, 1), transformed and divided by its w. See shd_matrix_transform_point().
inline void matrix_transform_point(const float* matrix, const float* point, float* out_point) {
  check(shd_matrix_transform_point(matrix, point, out_point));
}

/// A direction, (x, y, z, 0), transformed; the translation and the last row of the matrix have no effect. See
/// shd_matrix_transform_direction().
inline void matrix_transform_direction(
    const float* matrix,
    const float* direction,
    float* out_direction) {
  check(shd_matrix_transform_direction(matrix, direction, out_direction));
}

/// Compute the view of a camera; the same bits on every machine. An aspect of 0 counts as 1 here, because there is no
/// picture. Frames that take the camera itself (shd_render_desc.camera) use the aspect of their picture. See
/// shd_view_from_camera().
inline shd_view view_from_camera(const shd_camera* camera) {
  shd_view made = {};
  check(shd_view_from_camera(camera, &made));
  return made;
}

/// Move a camera so that a box fills its picture, such as the bounds of a scene. The camera keeps its direction (from
/// eye to target), up, fov_y and aspect. Its target becomes the centre of the box. Its eye moves as near as the eight
/// corners allow, and 4 % further. Its planes enclose the ball around the box, which may turn about its centre. Set the
/// aspect of the picture before: an aspect of 0 counts as 1 here. See shd_camera_frame_box().
inline void camera_frame_box(shd_camera* camera, const float* bounds_min, const float* bounds_max) {
  check(shd_camera_frame_box(camera, bounds_min, bounds_max));
}

/// Make a volume. Finds the range of density in each block of the texture, so that rays skip blocks without extinction;
/// the pictures have the same bits as without skipping. A texture in tiles loads each tile of its base level once; a
/// tile that cannot be loaded fails the call. See shd_volume_create().
inline shd::volume volume_create(shd_context* context_, const shd_volume_desc* desc) {
  shd::volume made;
  check(volume_create(context_, desc, made));
  return made;
}

#endif

}  // namespace shd
// clang-format on
#endif  // SHD_API_HPP
