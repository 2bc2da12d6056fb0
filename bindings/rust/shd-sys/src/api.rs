// SPDX-License-Identifier: MIT
// The C API. Written by generate.py; do not edit.
#![allow(clippy::too_many_arguments)]
use core::ffi::c_void;
use std::os::raw::c_char;

use crate::Opaque;

pub const SHD_VERSION_MAJOR: u32 = 0;
pub const SHD_VERSION_MINOR: u32 = 1;
pub const SHD_VERSION_PATCH: u32 = 0;
/// Largest number of the caller's own columns besides positions, normals, tangents and uv.
pub const SHD_MAX_ATTRIBUTES: u32 = 8;
/// Largest number of vertices of a polygon.
pub const SHD_MAX_POLYGON_VERTICES: u32 = 256;
/// Largest number of parts in one direction of a shape.
pub const SHD_MAX_SHAPE_SEGMENTS: u32 = 4096;
/// Largest number of parts per side of a patch of the teapot.
pub const SHD_MAX_TEAPOT_SEGMENTS: u32 = 256;
/// Directions in which shapes are divided.
pub const SHD_SHAPE_DIRECTIONS: u32 = 3;
/// Largest number of colours of a solid texture.
pub const SHD_MAX_SOLID_COLORS: u32 = 8;
/// Largest number of parts of an edge.
pub const SHD_MAX_SEGMENTS: u32 = 1024;
/// Bytes behind the last texel of a borrowed base level that lookups may read; their values have no effect.
pub const SHD_TEXTURE_PADDING: usize = 128;
/// Largest number of varyings: values that a vertex program passes to fragments.
pub const SHD_MAX_VARYINGS: u32 = 16;
/// Largest number of steps of a ray through one volume.
pub const SHD_VOLUME_MAX_STEPS: u32 = 4096;

/// Source of the value of a baked texel.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_texel_state(pub u32);
impl shd_texel_state {
    /// no triangle: the clear values of the frame
    pub const EMPTY: Self = Self(0);
    /// a triangle that covers the centre of the texel
    pub const CENTRE: Self = Self(1);
    pub const TOUCHED: Self = Self(2);
    /// a copy of the nearest texel that a triangle shaded
    pub const DILATED: Self = Self(3);
}
pub const SHD_TEXEL_STATE_EMPTY: shd_texel_state = shd_texel_state::EMPTY;
pub const SHD_TEXEL_STATE_CENTRE: shd_texel_state = shd_texel_state::CENTRE;
pub const SHD_TEXEL_STATE_TOUCHED: shd_texel_state = shd_texel_state::TOUCHED;
pub const SHD_TEXEL_STATE_DILATED: shd_texel_state = shd_texel_state::DILATED;
names!(shd_texel_state: EMPTY, CENTRE, TOUCHED, DILATED);

/// Legal definitions of the size p of a footprint, whose level of detail is log2 p; combine with |. Below, x and y are
/// the derivatives in base-level texels. Derivatives of 3D textures have a third component, x_w and y_w, which joins
/// every sum and every maximum.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_level_rule(pub u32);
impl shd_level_rule {
    /// axes x and y: p = max(|x|, |y|). Vulkan's and OpenGL's definition
    pub const LENGTHS: Self = Self(1);
    /// the axes of the ellipse that x and y span, as Direct3D 11 defines
    pub const ELLIPSE: Self = Self(2);
    /// Vulkan's approximations, each of its own size: max(|x_u|, |x_v|) \<= |x| \<= sqrt(2) (|x_u| + |x_v|), and y
    /// likewise.
    pub const VULKAN: Self = Self(4);
    /// OpenGL's: with m_u = max(|x_u|, |y_u|) and m_v = max(|x_v|, |y_v|), max(m_u, m_v) \<= p \<= m_u + m_v.
    pub const OPENGL: Self = Self(8);
    /// The profile of the sampler (shd_profile); not OIIO, which returns SHD_ERROR_UNSUPPORTED.
    pub const PROFILE: Self = Self(16);
}
pub const SHD_LEVEL_RULE_LENGTHS: shd_level_rule = shd_level_rule::LENGTHS;
pub const SHD_LEVEL_RULE_ELLIPSE: shd_level_rule = shd_level_rule::ELLIPSE;
pub const SHD_LEVEL_RULE_VULKAN: shd_level_rule = shd_level_rule::VULKAN;
pub const SHD_LEVEL_RULE_OPENGL: shd_level_rule = shd_level_rule::OPENGL;
pub const SHD_LEVEL_RULE_PROFILE: shd_level_rule = shd_level_rule::PROFILE;
flags!(shd_level_rule);

/// Rules of a graphics API, for shd_bounds_preset().
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_rules(pub u32);
impl shd_rules {
    /// The least precision that Vulkan 1.3 allows: 4 bits of coordinates and of levels; LENGTHS, ELLIPSE, VULKAN.
    pub const VULKAN: Self = Self(0);
    /// Direct3D 11.3: 8 bits of coordinates and of levels; LENGTHS, ELLIPSE.
    pub const D3D11: Self = Self(1);
    /// WebGPU has no rules of its own and runs on other APIs: VULKAN's bits, and the rules of the other three.
    pub const WEBGPU: Self = Self(2);
    /// OpenGL 4.6 has no least number of bits: VULKAN's bits; LENGTHS, OPENGL.
    pub const OPENGL: Self = Self(3);
}
pub const SHD_RULES_VULKAN: shd_rules = shd_rules::VULKAN;
pub const SHD_RULES_D3D11: shd_rules = shd_rules::D3D11;
pub const SHD_RULES_WEBGPU: shd_rules = shd_rules::WEBGPU;
pub const SHD_RULES_OPENGL: shd_rules = shd_rules::OPENGL;
names!(shd_rules: VULKAN, D3D11, WEBGPU, OPENGL);

/// Precision of displays for 8-bit images. Images of other formats are always exact.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_display_precision(pub u32);
impl shd_display_precision {
    /// A view is baked once into tables, which SIMD kernels apply. Codes differ from the exact ones by at most 1 in
    /// 99.9 % of the channels and by at most 3 in the others. The bake measures this on 65,536 colours, in gamut,
    /// saturated and negative, of 2^-14 to 2^6. A view outside this bound is applied exactly, and a line of the
    /// context's log (SHD_LOG_LEVEL_WARNING) reports it once.
    pub const BAKED: Self = Self(0);
    /// OpenColorIO's processor for each pixel
    pub const EXACT: Self = Self(1);
}
pub const SHD_DISPLAY_PRECISION_BAKED: shd_display_precision = shd_display_precision::BAKED;
pub const SHD_DISPLAY_PRECISION_EXACT: shd_display_precision = shd_display_precision::EXACT;
names!(shd_display_precision: BAKED, EXACT);

/// Severity of a line of the log.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_log_level(pub u32);
impl shd_log_level {
    pub const DEBUG: Self = Self(0);
    pub const INFO: Self = Self(1);
    pub const WARNING: Self = Self(2);
    pub const ERROR: Self = Self(3);
}
pub const SHD_LOG_LEVEL_DEBUG: shd_log_level = shd_log_level::DEBUG;
pub const SHD_LOG_LEVEL_INFO: shd_log_level = shd_log_level::INFO;
pub const SHD_LOG_LEVEL_WARNING: shd_log_level = shd_log_level::WARNING;
pub const SHD_LOG_LEVEL_ERROR: shd_log_level = shd_log_level::ERROR;
names!(shd_log_level: DEBUG, INFO, WARNING, ERROR);

/// Instruction set of the kernels. All give the same bits.
///
/// The build (CMake option SHD_SIMD) and the machine decide which ones can be chosen.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_simd(pub u32);
impl shd_simd {
    /// the fastest one of this machine and build
    pub const BEST: Self = Self(0);
    /// the lowest one of this build: runs wherever the library runs
    pub const BASELINE: Self = Self(1);
    /// one lane or generic vectors; only in builds whose baseline it is
    pub const SCALAR: Self = Self(2);
    /// the baseline of x86-64 with a Highway after 1.0.3
    pub const SSE2: Self = Self(3);
    /// in builds with SHD_SIMD=all
    pub const SSSE3: Self = Self(4);
    /// SSE4.2
    pub const SSE4: Self = Self(5);
    pub const AVX2: Self = Self(6);
    /// AVX-512 F, BW, CD, DQ and VL
    pub const AVX512: Self = Self(7);
    pub const NEON: Self = Self(8);
    pub const WASM: Self = Self(9);
}
pub const SHD_SIMD_BEST: shd_simd = shd_simd::BEST;
pub const SHD_SIMD_BASELINE: shd_simd = shd_simd::BASELINE;
pub const SHD_SIMD_SCALAR: shd_simd = shd_simd::SCALAR;
pub const SHD_SIMD_SSE2: shd_simd = shd_simd::SSE2;
pub const SHD_SIMD_SSSE3: shd_simd = shd_simd::SSSE3;
pub const SHD_SIMD_SSE4: shd_simd = shd_simd::SSE4;
pub const SHD_SIMD_AVX2: shd_simd = shd_simd::AVX2;
pub const SHD_SIMD_AVX512: shd_simd = shd_simd::AVX512;
pub const SHD_SIMD_NEON: shd_simd = shd_simd::NEON;
pub const SHD_SIMD_WASM: shd_simd = shd_simd::WASM;
names!(shd_simd: BEST, BASELINE, SCALAR, SSE2, SSSE3, SSE4, AVX2, AVX512, NEON, WASM);

/// Options of a context; combine with |.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_context_flag(pub u32);
impl shd_context_flag {
    pub const DEFAULT: Self = Self(0);
    /// Working memory of a call is allocated and freed block by block. Without this flag the context keeps it for the
    /// next call, so that a loop of equal frames allocates nothing after each worker has drawn a part of a frame, with
    /// one worker after the first frame; see shd_context_trim().
    pub const RETURN_MEMORY: Self = Self(1);
}
pub const SHD_CONTEXT_DEFAULT: shd_context_flag = shd_context_flag::DEFAULT;
pub const SHD_CONTEXT_RETURN_MEMORY: shd_context_flag = shd_context_flag::RETURN_MEMORY;
flags!(shd_context_flag);

/// A sized struct, for shd_desc_init().
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_desc_kind(pub u32);
impl shd_desc_kind {
    pub const NONE: Self = Self(0);
    /// shd_context_desc
    pub const CONTEXT_DESC: Self = Self(1);
    /// shd_image
    pub const IMAGE: Self = Self(2);
    /// shd_texture_desc
    pub const TEXTURE_DESC: Self = Self(3);
    /// shd_texture_info
    pub const TEXTURE_INFO: Self = Self(4);
    /// shd_mip_desc
    pub const MIP_DESC: Self = Self(5);
    /// shd_sampler_desc
    pub const SAMPLER_DESC: Self = Self(6);
    /// shd_lookups
    pub const LOOKUPS: Self = Self(7);
    /// shd_texels
    pub const TEXELS: Self = Self(8);
    /// shd_levels
    pub const LEVELS: Self = Self(9);
    /// shd_explanation; sets tap_size and blend_size to the library's
    pub const EXPLANATION: Self = Self(10);
    /// shd_ray_differentials
    pub const RAY_DIFFERENTIALS: Self = Self(11);
    /// shd_ray_cones
    pub const RAY_CONES: Self = Self(12);
    /// shd_derivatives
    pub const DERIVATIVES: Self = Self(13);
    /// shd_mesh_desc
    pub const MESH_DESC: Self = Self(14);
    /// shd_mesh_info
    pub const MESH_INFO: Self = Self(15);
    /// shd_edges_desc
    pub const EDGES_DESC: Self = Self(16);
    /// shd_edges
    pub const EDGES: Self = Self(17);
    /// shd_tessellation_desc
    pub const TESSELLATION_DESC: Self = Self(18);
    /// shd_material_desc
    pub const MATERIAL_DESC: Self = Self(19);
    /// shd_slot; `target` becomes SHD_SLOT_DIFFUSE
    pub const SLOT: Self = Self(20);
    /// shd_light_desc
    pub const LIGHT_DESC: Self = Self(21);
    /// shd_shadow_desc
    pub const SHADOW_DESC: Self = Self(22);
    /// shd_shadow_render_desc
    pub const SHADOW_RENDER_DESC: Self = Self(23);
    /// shd_shadow_lookups
    pub const SHADOW_LOOKUPS: Self = Self(24);
    /// shd_framebuffer_desc
    pub const FRAMEBUFFER_DESC: Self = Self(25);
    /// shd_framebuffer_info
    pub const FRAMEBUFFER_INFO: Self = Self(26);
    /// shd_plane_view
    pub const PLANE_VIEW: Self = Self(27);
    /// shd_camera
    pub const CAMERA: Self = Self(28);
    /// shd_draw
    pub const DRAW: Self = Self(29);
    /// shd_render_desc
    pub const RENDER_DESC: Self = Self(30);
    /// shd_render_stats
    pub const RENDER_STATS: Self = Self(31);
    /// shd_color_desc, of shd/color.h
    pub const COLOR_DESC: Self = Self(32);
    /// shd_load_desc, of shd/io.h
    pub const LOAD_DESC: Self = Self(33);
    /// shd_save_desc, of shd/io.h
    pub const SAVE_DESC: Self = Self(34);
    /// shd_bitmap_info, of shd/io.h
    pub const BITMAP_INFO: Self = Self(35);
    /// shd_shape_desc
    pub const SHAPE_DESC: Self = Self(36);
    /// shd_shape_columns
    pub const SHAPE_COLUMNS: Self = Self(37);
    /// shd_scene_desc, of shd/scene.h
    pub const SCENE_DESC: Self = Self(38);
    /// shd_scene_info, of shd/scene.h
    pub const SCENE_INFO: Self = Self(39);
    /// shd_scene_instance, of shd/scene.h
    pub const SCENE_INSTANCE: Self = Self(40);
    /// shd_solid_desc
    pub const SOLID_DESC: Self = Self(41);
    /// shd_solid_points
    pub const SOLID_POINTS: Self = Self(42);
    /// shd_solid_values
    pub const SOLID_VALUES: Self = Self(43);
    /// shd_directions
    pub const DIRECTIONS: Self = Self(44);
    /// shd_projected_points
    pub const PROJECTED_POINTS: Self = Self(45);
    /// shd_image_points
    pub const IMAGE_POINTS: Self = Self(46);
    /// shd_point_directions
    pub const POINT_DIRECTIONS: Self = Self(47);
    /// shd_volume_desc
    pub const VOLUME_DESC: Self = Self(48);
    /// shd_volume_draw
    pub const VOLUME_DRAW: Self = Self(49);
    /// shd_environment_desc
    pub const ENVIRONMENT_DESC: Self = Self(50);
    /// shd_environment_info
    pub const ENVIRONMENT_INFO: Self = Self(51);
    /// shd_environment_lookups
    pub const ENVIRONMENT_LOOKUPS: Self = Self(52);
    /// shd_environment_light
    pub const ENVIRONMENT_LIGHT: Self = Self(53);
    /// shd_direction_images
    pub const DIRECTION_IMAGES: Self = Self(54);
    /// shd_polygon_desc
    pub const POLYGON_DESC: Self = Self(55);
    /// shd_polygon_points
    pub const POLYGON_POINTS: Self = Self(56);
    /// shd_polygon_weights
    pub const POLYGON_WEIGHTS: Self = Self(57);
    /// shd_raw_desc, of shd/volume_file.h
    pub const RAW_DESC: Self = Self(58);
    /// shd_stack_desc, of shd/volume_file.h
    pub const STACK_DESC: Self = Self(59);
    /// shd_vdb_desc, of shd/volume_file.h
    pub const VDB_DESC: Self = Self(60);
    /// shd_vdb_info, of shd/volume_file.h
    pub const VDB_INFO: Self = Self(61);
    /// shd_bake_desc
    pub const BAKE_DESC: Self = Self(62);
    /// shd_bake_stats
    pub const BAKE_STATS: Self = Self(63);
    /// shd_occlusion_desc
    pub const OCCLUSION_DESC: Self = Self(64);
    /// shd_occlusion_points
    pub const OCCLUSION_POINTS: Self = Self(65);
    /// shd_occlusion_atlas
    pub const OCCLUSION_ATLAS: Self = Self(66);
    /// shd_bounds_desc
    pub const BOUNDS_DESC: Self = Self(67);
    /// shd_texture_file_info, of shd/texture_file.h
    pub const TEXTURE_FILE_INFO: Self = Self(68);
    /// shd_ktx2_desc, of shd/texture_file.h
    pub const KTX2_DESC: Self = Self(69);
    /// shd_tile_region
    pub const TILE_REGION: Self = Self(70);
    /// shd_tile_cache_desc
    pub const TILE_CACHE_DESC: Self = Self(71);
    /// shd_tile_cache_stats
    pub const TILE_CACHE_STATS: Self = Self(72);
    /// shd_tile_file_desc, of shd/tile_file.h
    pub const TILE_FILE_DESC: Self = Self(73);
    /// shd_tile_file_info, of shd/tile_file.h
    pub const TILE_FILE_INFO: Self = Self(74);
}
pub const SHD_DESC_KIND_NONE: shd_desc_kind = shd_desc_kind::NONE;
pub const SHD_DESC_KIND_CONTEXT_DESC: shd_desc_kind = shd_desc_kind::CONTEXT_DESC;
pub const SHD_DESC_KIND_IMAGE: shd_desc_kind = shd_desc_kind::IMAGE;
pub const SHD_DESC_KIND_TEXTURE_DESC: shd_desc_kind = shd_desc_kind::TEXTURE_DESC;
pub const SHD_DESC_KIND_TEXTURE_INFO: shd_desc_kind = shd_desc_kind::TEXTURE_INFO;
pub const SHD_DESC_KIND_MIP_DESC: shd_desc_kind = shd_desc_kind::MIP_DESC;
pub const SHD_DESC_KIND_SAMPLER_DESC: shd_desc_kind = shd_desc_kind::SAMPLER_DESC;
pub const SHD_DESC_KIND_LOOKUPS: shd_desc_kind = shd_desc_kind::LOOKUPS;
pub const SHD_DESC_KIND_TEXELS: shd_desc_kind = shd_desc_kind::TEXELS;
pub const SHD_DESC_KIND_LEVELS: shd_desc_kind = shd_desc_kind::LEVELS;
pub const SHD_DESC_KIND_EXPLANATION: shd_desc_kind = shd_desc_kind::EXPLANATION;
pub const SHD_DESC_KIND_RAY_DIFFERENTIALS: shd_desc_kind = shd_desc_kind::RAY_DIFFERENTIALS;
pub const SHD_DESC_KIND_RAY_CONES: shd_desc_kind = shd_desc_kind::RAY_CONES;
pub const SHD_DESC_KIND_DERIVATIVES: shd_desc_kind = shd_desc_kind::DERIVATIVES;
pub const SHD_DESC_KIND_MESH_DESC: shd_desc_kind = shd_desc_kind::MESH_DESC;
pub const SHD_DESC_KIND_MESH_INFO: shd_desc_kind = shd_desc_kind::MESH_INFO;
pub const SHD_DESC_KIND_EDGES_DESC: shd_desc_kind = shd_desc_kind::EDGES_DESC;
pub const SHD_DESC_KIND_EDGES: shd_desc_kind = shd_desc_kind::EDGES;
pub const SHD_DESC_KIND_TESSELLATION_DESC: shd_desc_kind = shd_desc_kind::TESSELLATION_DESC;
pub const SHD_DESC_KIND_MATERIAL_DESC: shd_desc_kind = shd_desc_kind::MATERIAL_DESC;
pub const SHD_DESC_KIND_SLOT: shd_desc_kind = shd_desc_kind::SLOT;
pub const SHD_DESC_KIND_LIGHT_DESC: shd_desc_kind = shd_desc_kind::LIGHT_DESC;
pub const SHD_DESC_KIND_SHADOW_DESC: shd_desc_kind = shd_desc_kind::SHADOW_DESC;
pub const SHD_DESC_KIND_SHADOW_RENDER_DESC: shd_desc_kind = shd_desc_kind::SHADOW_RENDER_DESC;
pub const SHD_DESC_KIND_SHADOW_LOOKUPS: shd_desc_kind = shd_desc_kind::SHADOW_LOOKUPS;
pub const SHD_DESC_KIND_FRAMEBUFFER_DESC: shd_desc_kind = shd_desc_kind::FRAMEBUFFER_DESC;
pub const SHD_DESC_KIND_FRAMEBUFFER_INFO: shd_desc_kind = shd_desc_kind::FRAMEBUFFER_INFO;
pub const SHD_DESC_KIND_PLANE_VIEW: shd_desc_kind = shd_desc_kind::PLANE_VIEW;
pub const SHD_DESC_KIND_CAMERA: shd_desc_kind = shd_desc_kind::CAMERA;
pub const SHD_DESC_KIND_DRAW: shd_desc_kind = shd_desc_kind::DRAW;
pub const SHD_DESC_KIND_RENDER_DESC: shd_desc_kind = shd_desc_kind::RENDER_DESC;
pub const SHD_DESC_KIND_RENDER_STATS: shd_desc_kind = shd_desc_kind::RENDER_STATS;
pub const SHD_DESC_KIND_COLOR_DESC: shd_desc_kind = shd_desc_kind::COLOR_DESC;
pub const SHD_DESC_KIND_LOAD_DESC: shd_desc_kind = shd_desc_kind::LOAD_DESC;
pub const SHD_DESC_KIND_SAVE_DESC: shd_desc_kind = shd_desc_kind::SAVE_DESC;
pub const SHD_DESC_KIND_BITMAP_INFO: shd_desc_kind = shd_desc_kind::BITMAP_INFO;
pub const SHD_DESC_KIND_SHAPE_DESC: shd_desc_kind = shd_desc_kind::SHAPE_DESC;
pub const SHD_DESC_KIND_SHAPE_COLUMNS: shd_desc_kind = shd_desc_kind::SHAPE_COLUMNS;
pub const SHD_DESC_KIND_SCENE_DESC: shd_desc_kind = shd_desc_kind::SCENE_DESC;
pub const SHD_DESC_KIND_SCENE_INFO: shd_desc_kind = shd_desc_kind::SCENE_INFO;
pub const SHD_DESC_KIND_SCENE_INSTANCE: shd_desc_kind = shd_desc_kind::SCENE_INSTANCE;
pub const SHD_DESC_KIND_SOLID_DESC: shd_desc_kind = shd_desc_kind::SOLID_DESC;
pub const SHD_DESC_KIND_SOLID_POINTS: shd_desc_kind = shd_desc_kind::SOLID_POINTS;
pub const SHD_DESC_KIND_SOLID_VALUES: shd_desc_kind = shd_desc_kind::SOLID_VALUES;
pub const SHD_DESC_KIND_DIRECTIONS: shd_desc_kind = shd_desc_kind::DIRECTIONS;
pub const SHD_DESC_KIND_PROJECTED_POINTS: shd_desc_kind = shd_desc_kind::PROJECTED_POINTS;
pub const SHD_DESC_KIND_IMAGE_POINTS: shd_desc_kind = shd_desc_kind::IMAGE_POINTS;
pub const SHD_DESC_KIND_POINT_DIRECTIONS: shd_desc_kind = shd_desc_kind::POINT_DIRECTIONS;
pub const SHD_DESC_KIND_VOLUME_DESC: shd_desc_kind = shd_desc_kind::VOLUME_DESC;
pub const SHD_DESC_KIND_VOLUME_DRAW: shd_desc_kind = shd_desc_kind::VOLUME_DRAW;
pub const SHD_DESC_KIND_ENVIRONMENT_DESC: shd_desc_kind = shd_desc_kind::ENVIRONMENT_DESC;
pub const SHD_DESC_KIND_ENVIRONMENT_INFO: shd_desc_kind = shd_desc_kind::ENVIRONMENT_INFO;
pub const SHD_DESC_KIND_ENVIRONMENT_LOOKUPS: shd_desc_kind = shd_desc_kind::ENVIRONMENT_LOOKUPS;
pub const SHD_DESC_KIND_ENVIRONMENT_LIGHT: shd_desc_kind = shd_desc_kind::ENVIRONMENT_LIGHT;
pub const SHD_DESC_KIND_DIRECTION_IMAGES: shd_desc_kind = shd_desc_kind::DIRECTION_IMAGES;
pub const SHD_DESC_KIND_POLYGON_DESC: shd_desc_kind = shd_desc_kind::POLYGON_DESC;
pub const SHD_DESC_KIND_POLYGON_POINTS: shd_desc_kind = shd_desc_kind::POLYGON_POINTS;
pub const SHD_DESC_KIND_POLYGON_WEIGHTS: shd_desc_kind = shd_desc_kind::POLYGON_WEIGHTS;
pub const SHD_DESC_KIND_RAW_DESC: shd_desc_kind = shd_desc_kind::RAW_DESC;
pub const SHD_DESC_KIND_STACK_DESC: shd_desc_kind = shd_desc_kind::STACK_DESC;
pub const SHD_DESC_KIND_VDB_DESC: shd_desc_kind = shd_desc_kind::VDB_DESC;
pub const SHD_DESC_KIND_VDB_INFO: shd_desc_kind = shd_desc_kind::VDB_INFO;
pub const SHD_DESC_KIND_BAKE_DESC: shd_desc_kind = shd_desc_kind::BAKE_DESC;
pub const SHD_DESC_KIND_BAKE_STATS: shd_desc_kind = shd_desc_kind::BAKE_STATS;
pub const SHD_DESC_KIND_OCCLUSION_DESC: shd_desc_kind = shd_desc_kind::OCCLUSION_DESC;
pub const SHD_DESC_KIND_OCCLUSION_POINTS: shd_desc_kind = shd_desc_kind::OCCLUSION_POINTS;
pub const SHD_DESC_KIND_OCCLUSION_ATLAS: shd_desc_kind = shd_desc_kind::OCCLUSION_ATLAS;
pub const SHD_DESC_KIND_BOUNDS_DESC: shd_desc_kind = shd_desc_kind::BOUNDS_DESC;
pub const SHD_DESC_KIND_TEXTURE_FILE_INFO: shd_desc_kind = shd_desc_kind::TEXTURE_FILE_INFO;
pub const SHD_DESC_KIND_KTX2_DESC: shd_desc_kind = shd_desc_kind::KTX2_DESC;
pub const SHD_DESC_KIND_TILE_REGION: shd_desc_kind = shd_desc_kind::TILE_REGION;
pub const SHD_DESC_KIND_TILE_CACHE_DESC: shd_desc_kind = shd_desc_kind::TILE_CACHE_DESC;
pub const SHD_DESC_KIND_TILE_CACHE_STATS: shd_desc_kind = shd_desc_kind::TILE_CACHE_STATS;
pub const SHD_DESC_KIND_TILE_FILE_DESC: shd_desc_kind = shd_desc_kind::TILE_FILE_DESC;
pub const SHD_DESC_KIND_TILE_FILE_INFO: shd_desc_kind = shd_desc_kind::TILE_FILE_INFO;
names!(shd_desc_kind: NONE, CONTEXT_DESC, IMAGE, TEXTURE_DESC, TEXTURE_INFO, MIP_DESC, SAMPLER_DESC, LOOKUPS, TEXELS, LEVELS, EXPLANATION, RAY_DIFFERENTIALS, RAY_CONES, DERIVATIVES, MESH_DESC, MESH_INFO, EDGES_DESC, EDGES, TESSELLATION_DESC, MATERIAL_DESC, SLOT, LIGHT_DESC, SHADOW_DESC, SHADOW_RENDER_DESC, SHADOW_LOOKUPS, FRAMEBUFFER_DESC, FRAMEBUFFER_INFO, PLANE_VIEW, CAMERA, DRAW, RENDER_DESC, RENDER_STATS, COLOR_DESC, LOAD_DESC, SAVE_DESC, BITMAP_INFO, SHAPE_DESC, SHAPE_COLUMNS, SCENE_DESC, SCENE_INFO, SCENE_INSTANCE, SOLID_DESC, SOLID_POINTS, SOLID_VALUES, DIRECTIONS, PROJECTED_POINTS, IMAGE_POINTS, POINT_DIRECTIONS, VOLUME_DESC, VOLUME_DRAW, ENVIRONMENT_DESC, ENVIRONMENT_INFO, ENVIRONMENT_LOOKUPS, ENVIRONMENT_LIGHT, DIRECTION_IMAGES, POLYGON_DESC, POLYGON_POINTS, POLYGON_WEIGHTS, RAW_DESC, STACK_DESC, VDB_DESC, VDB_INFO, BAKE_DESC, BAKE_STATS, OCCLUSION_DESC, OCCLUSION_POINTS, OCCLUSION_ATLAS, BOUNDS_DESC, TEXTURE_FILE_INFO, KTX2_DESC, TILE_REGION, TILE_CACHE_DESC, TILE_CACHE_STATS, TILE_FILE_DESC, TILE_FILE_INFO);

/// Kinds of edges; combine with |.
///
/// An edge of two triangles may be both SILHOUETTE and CREASE. Where both triangles run along it in the same direction,
/// as on a Moebius strip, the second triangle counts as flipped.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_edge(pub u32);
impl shd_edge {
    pub const NONE: Self = Self(0);
    /// Between two triangles of which one faces the eye e and the other does not: f0(e) f1(e) \<= 0 with
    /// f(e) = (e - p) . n, p a corner of the triangle and n its normal.
    pub const SILHOUETTE: Self = Self(1);
    /// between two triangles with unit normals n0 . n1 \<= crease_cosine, in object space
    pub const CREASE: Self = Self(2);
    /// an edge of one triangle
    pub const BORDER: Self = Self(4);
    /// an edge of three triangles or more
    pub const NONMANIFOLD: Self = Self(8);
    /// all kinds
    pub const ALL: Self = Self(15);
}
pub const SHD_EDGE_NONE: shd_edge = shd_edge::NONE;
pub const SHD_EDGE_SILHOUETTE: shd_edge = shd_edge::SILHOUETTE;
pub const SHD_EDGE_CREASE: shd_edge = shd_edge::CREASE;
pub const SHD_EDGE_BORDER: shd_edge = shd_edge::BORDER;
pub const SHD_EDGE_NONMANIFOLD: shd_edge = shd_edge::NONMANIFOLD;
pub const SHD_EDGE_ALL: shd_edge = shd_edge::ALL;
flags!(shd_edge);

/// Method that computes the irradiance.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_irradiance(pub u32);
impl shd_irradiance {
    /// Spherical harmonics of the orders 0 to 2 (Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance
    /// Environment Maps", 2001), at least 0. The error is up to 0.1 of the irradiance of a single light that faces the
    /// surface, and about 0.01 for environments without a sun.
    pub const HARMONICS: Self = Self(0);
    /// a map of 96 x 96 directions: error up to 0.018 of such a light
    pub const CONVOLVED: Self = Self(1);
}
pub const SHD_IRRADIANCE_HARMONICS: shd_irradiance = shd_irradiance::HARMONICS;
pub const SHD_IRRADIANCE_CONVOLVED: shd_irradiance = shd_irradiance::CONVOLVED;
names!(shd_irradiance: HARMONICS, CONVOLVED);

/// Tables of an environment in addition to the irradiance; combine with |.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_environment_table(pub u32);
impl shd_environment_table {
    pub const NONE: Self = Self(0);
    /// the image itself, for backgrounds and mirrors; part of every other table
    pub const RADIANCE: Self = Self(1);
    /// lobes of METALLIC_ROUGHNESS
    pub const GGX: Self = Self(2);
    /// lobes of PHONG, COMBINED, TOON and both models of Blinn
    pub const PHONG: Self = Self(4);
    pub const ALL: Self = Self(7);
}
pub const SHD_ENVIRONMENT_TABLE_NONE: shd_environment_table = shd_environment_table::NONE;
pub const SHD_ENVIRONMENT_TABLE_RADIANCE: shd_environment_table = shd_environment_table::RADIANCE;
pub const SHD_ENVIRONMENT_TABLE_GGX: shd_environment_table = shd_environment_table::GGX;
pub const SHD_ENVIRONMENT_TABLE_PHONG: shd_environment_table = shd_environment_table::PHONG;
pub const SHD_ENVIRONMENT_TABLE_ALL: shd_environment_table = shd_environment_table::ALL;
flags!(shd_environment_table);

/// Optional planes; combine with |.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_aov(pub u32);
impl shd_aov {
    pub const NONE: Self = Self(0);
    /// SHD_PLANE_U, _V
    pub const UV: Self = Self(1);
    /// SHD_PLANE_NX, _NY, _NZ: shading normal, world space
    pub const NORMAL: Self = Self(2);
    /// SHD_PLANE_TRIANGLE
    pub const TRIANGLE: Self = Self(4);
    /// SHD_PLANE_PX, _PY, _PZ: world space
    pub const POSITION: Self = Self(8);
    /// SHD_PLANE_DUDX, _DVDX, _DUDY, _DVDY: of uv, per pixel to the right and down
    pub const DERIVATIVES: Self = Self(16);
    /// SHD_PLANE_B0, _B1, _B2: perspective-correct weights of the triangle's corners
    pub const BARYCENTRICS: Self = Self(32);
    /// SHD_PLANE_LOD, _LEVEL: shd_texture_query_levels() of the diffuse texture
    pub const LEVEL: Self = Self(64);
    /// SHD_PLANE_DRAW
    pub const DRAW: Self = Self(128);
    /// SHD_PLANE_OVERDRAW
    pub const OVERDRAW: Self = Self(256);
    /// SHD_PLANE_TARGET1_R, _G, _B, _A: a colour target besides R, G, B, A
    pub const TARGET1: Self = Self(512);
    /// SHD_PLANE_TARGET2_R, _G, _B, _A
    pub const TARGET2: Self = Self(1024);
    /// SHD_PLANE_TARGET3_R, _G, _B, _A
    pub const TARGET3: Self = Self(2048);
}
pub const SHD_AOV_NONE: shd_aov = shd_aov::NONE;
pub const SHD_AOV_UV: shd_aov = shd_aov::UV;
pub const SHD_AOV_NORMAL: shd_aov = shd_aov::NORMAL;
pub const SHD_AOV_TRIANGLE: shd_aov = shd_aov::TRIANGLE;
pub const SHD_AOV_POSITION: shd_aov = shd_aov::POSITION;
pub const SHD_AOV_DERIVATIVES: shd_aov = shd_aov::DERIVATIVES;
pub const SHD_AOV_BARYCENTRICS: shd_aov = shd_aov::BARYCENTRICS;
pub const SHD_AOV_LEVEL: shd_aov = shd_aov::LEVEL;
pub const SHD_AOV_DRAW: shd_aov = shd_aov::DRAW;
pub const SHD_AOV_OVERDRAW: shd_aov = shd_aov::OVERDRAW;
pub const SHD_AOV_TARGET1: shd_aov = shd_aov::TARGET1;
pub const SHD_AOV_TARGET2: shd_aov = shd_aov::TARGET2;
pub const SHD_AOV_TARGET3: shd_aov = shd_aov::TARGET3;
flags!(shd_aov);

/// One plane of a framebuffer: width * height elements, row by row from the top.
///
/// Planes after SHD_PLANE_DEPTH, except overdraw and targets, hold the values of the last opaque fragment visible at the
/// first sample of a pixel. Blended draws and draws of depth alone do not change them.
///
/// Targets are additional colours of the same samples. Programs write them as shd_radiance.target; other materials write
/// 0 to all four channels. They start as 0. Each target is blended with the material's blend and its own a, except that
/// WEIGHTED and SORTED leave targets unchanged. The alpha test uses the alpha of the main colour target.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_plane(pub u32);
impl shd_plane {
    /// R, G, B and A are in memory only with color_format SHD_FORMAT_RGBA32F
    pub const R: Self = Self(0);
    pub const G: Self = Self(1);
    pub const B: Self = Self(2);
    pub const A: Self = Self(3);
    /// D32F, 0 near .. 1 far
    pub const DEPTH: Self = Self(4);
    pub const U: Self = Self(5);
    pub const V: Self = Self(6);
    pub const NX: Self = Self(7);
    pub const NY: Self = Self(8);
    pub const NZ: Self = Self(9);
    /// uint32_t: triangle index in its mesh, 0xffffffff where nothing was drawn
    pub const TRIANGLE: Self = Self(10);
    pub const PX: Self = Self(11);
    pub const PY: Self = Self(12);
    pub const PZ: Self = Self(13);
    pub const DUDX: Self = Self(14);
    pub const DVDX: Self = Self(15);
    pub const DUDY: Self = Self(16);
    pub const DVDY: Self = Self(17);
    pub const B0: Self = Self(18);
    pub const B1: Self = Self(19);
    pub const B2: Self = Self(20);
    /// continuous level of detail; 0 without texture
    pub const LOD: Self = Self(21);
    /// uint32_t: the mip level nearest to it
    pub const LEVEL: Self = Self(22);
    /// uint32_t: index into shd_render_desc.draws, 0xffffffff where nothing was drawn
    pub const DRAW: Self = Self(23);
    /// uint32_t: number of times that the first sample was drawn, hidden later or not
    pub const OVERDRAW: Self = Self(24);
    pub const TARGET1_R: Self = Self(25);
    pub const TARGET1_G: Self = Self(26);
    pub const TARGET1_B: Self = Self(27);
    pub const TARGET1_A: Self = Self(28);
    pub const TARGET2_R: Self = Self(29);
    pub const TARGET2_G: Self = Self(30);
    pub const TARGET2_B: Self = Self(31);
    pub const TARGET2_A: Self = Self(32);
    pub const TARGET3_R: Self = Self(33);
    pub const TARGET3_G: Self = Self(34);
    pub const TARGET3_B: Self = Self(35);
    pub const TARGET3_A: Self = Self(36);
}
pub const SHD_PLANE_R: shd_plane = shd_plane::R;
pub const SHD_PLANE_G: shd_plane = shd_plane::G;
pub const SHD_PLANE_B: shd_plane = shd_plane::B;
pub const SHD_PLANE_A: shd_plane = shd_plane::A;
pub const SHD_PLANE_DEPTH: shd_plane = shd_plane::DEPTH;
pub const SHD_PLANE_U: shd_plane = shd_plane::U;
pub const SHD_PLANE_V: shd_plane = shd_plane::V;
pub const SHD_PLANE_NX: shd_plane = shd_plane::NX;
pub const SHD_PLANE_NY: shd_plane = shd_plane::NY;
pub const SHD_PLANE_NZ: shd_plane = shd_plane::NZ;
pub const SHD_PLANE_TRIANGLE: shd_plane = shd_plane::TRIANGLE;
pub const SHD_PLANE_PX: shd_plane = shd_plane::PX;
pub const SHD_PLANE_PY: shd_plane = shd_plane::PY;
pub const SHD_PLANE_PZ: shd_plane = shd_plane::PZ;
pub const SHD_PLANE_DUDX: shd_plane = shd_plane::DUDX;
pub const SHD_PLANE_DVDX: shd_plane = shd_plane::DVDX;
pub const SHD_PLANE_DUDY: shd_plane = shd_plane::DUDY;
pub const SHD_PLANE_DVDY: shd_plane = shd_plane::DVDY;
pub const SHD_PLANE_B0: shd_plane = shd_plane::B0;
pub const SHD_PLANE_B1: shd_plane = shd_plane::B1;
pub const SHD_PLANE_B2: shd_plane = shd_plane::B2;
pub const SHD_PLANE_LOD: shd_plane = shd_plane::LOD;
pub const SHD_PLANE_LEVEL: shd_plane = shd_plane::LEVEL;
pub const SHD_PLANE_DRAW: shd_plane = shd_plane::DRAW;
pub const SHD_PLANE_OVERDRAW: shd_plane = shd_plane::OVERDRAW;
pub const SHD_PLANE_TARGET1_R: shd_plane = shd_plane::TARGET1_R;
pub const SHD_PLANE_TARGET1_G: shd_plane = shd_plane::TARGET1_G;
pub const SHD_PLANE_TARGET1_B: shd_plane = shd_plane::TARGET1_B;
pub const SHD_PLANE_TARGET1_A: shd_plane = shd_plane::TARGET1_A;
pub const SHD_PLANE_TARGET2_R: shd_plane = shd_plane::TARGET2_R;
pub const SHD_PLANE_TARGET2_G: shd_plane = shd_plane::TARGET2_G;
pub const SHD_PLANE_TARGET2_B: shd_plane = shd_plane::TARGET2_B;
pub const SHD_PLANE_TARGET2_A: shd_plane = shd_plane::TARGET2_A;
pub const SHD_PLANE_TARGET3_R: shd_plane = shd_plane::TARGET3_R;
pub const SHD_PLANE_TARGET3_G: shd_plane = shd_plane::TARGET3_G;
pub const SHD_PLANE_TARGET3_B: shd_plane = shd_plane::TARGET3_B;
pub const SHD_PLANE_TARGET3_A: shd_plane = shd_plane::TARGET3_A;
names!(shd_plane: R, G, B, A, DEPTH, U, V, NX, NY, NZ, TRIANGLE, PX, PY, PZ, DUDX, DVDX, DUDY, DVDY, B0, B1, B2, LOD, LEVEL, DRAW, OVERDRAW, TARGET1_R, TARGET1_G, TARGET1_B, TARGET1_A, TARGET2_R, TARGET2_G, TARGET2_B, TARGET2_A, TARGET3_R, TARGET3_G, TARGET3_B, TARGET3_A);

/// Storage of one pixel or texel.
///
/// Unsigned integer channels hold value / maximum, in \[0, 1\]; F channels are IEEE 754 binary16 or binary32. All channels
/// are linear, except r, g and b of the _SRGB formats, which are encoded (IEC 61966-2-1). Textures take every format;
/// framebuffers, colour transforms and files list the formats that they take.
///
/// BC formats are blocks of 4 x 4 texels, row by row from the top left (Khronos Data Format Specification 1.3, chapters
/// 18 to 20). Only shd_texture_create() and shd_texture_read_level() take them. docs/compressed.md has their values.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_format(pub u32);
impl shd_format {
    pub const NONE: Self = Self(0);
    pub const R8: Self = Self(1);
    pub const RGBA8: Self = Self(2);
    pub const RGBA8_SRGB: Self = Self(3);
    pub const RGBA16F: Self = Self(4);
    pub const RGBA32F: Self = Self(5);
    pub const RGBA16: Self = Self(6);
    pub const RG8: Self = Self(7);
    pub const RGB8: Self = Self(8);
    pub const R8_SRGB: Self = Self(9);
    pub const RG8_SRGB: Self = Self(10);
    pub const RGB8_SRGB: Self = Self(11);
    pub const R16: Self = Self(12);
    pub const RG16: Self = Self(13);
    pub const RGB16: Self = Self(14);
    pub const R16F: Self = Self(15);
    pub const RG16F: Self = Self(16);
    pub const RGB16F: Self = Self(17);
    pub const R32F: Self = Self(18);
    pub const RG32F: Self = Self(19);
    pub const RGB32F: Self = Self(20);
    /// blocks of 8 bytes; every texel is opaque
    pub const BC1_RGB: Self = Self(21);
    pub const BC1_RGB_SRGB: Self = Self(22);
    /// blocks of 8 bytes; texels may be transparent black
    pub const BC1_RGBA: Self = Self(23);
    pub const BC1_RGBA_SRGB: Self = Self(24);
    /// blocks of 16 bytes, as all of the following except BC4
    pub const BC2: Self = Self(25);
    pub const BC2_SRGB: Self = Self(26);
    pub const BC3: Self = Self(27);
    pub const BC3_SRGB: Self = Self(28);
    /// one channel in 0..1, blocks of 8 bytes
    pub const BC4: Self = Self(29);
    /// one channel in -1..1, blocks of 8 bytes
    pub const BC4_SNORM: Self = Self(30);
    /// two channels in 0..1
    pub const BC5: Self = Self(31);
    /// two channels in -1..1
    pub const BC5_SNORM: Self = Self(32);
    /// three channels from 0 to 65504
    pub const BC6H_UFLOAT: Self = Self(33);
    /// three channels from -65504 to 65504
    pub const BC6H_SFLOAT: Self = Self(34);
    pub const BC7: Self = Self(35);
    pub const BC7_SRGB: Self = Self(36);
    /// one uint32_t: r, g, b as numbers of 9 bits from bit 0 on, e in bits 27 to 31. A channel
    /// is its number times 2^(e - 24): 0 to 65408
    pub const RGB9E5: Self = Self(37);
}
pub const SHD_FORMAT_NONE: shd_format = shd_format::NONE;
pub const SHD_FORMAT_R8: shd_format = shd_format::R8;
pub const SHD_FORMAT_RGBA8: shd_format = shd_format::RGBA8;
pub const SHD_FORMAT_RGBA8_SRGB: shd_format = shd_format::RGBA8_SRGB;
pub const SHD_FORMAT_RGBA16F: shd_format = shd_format::RGBA16F;
pub const SHD_FORMAT_RGBA32F: shd_format = shd_format::RGBA32F;
pub const SHD_FORMAT_RGBA16: shd_format = shd_format::RGBA16;
pub const SHD_FORMAT_RG8: shd_format = shd_format::RG8;
pub const SHD_FORMAT_RGB8: shd_format = shd_format::RGB8;
pub const SHD_FORMAT_R8_SRGB: shd_format = shd_format::R8_SRGB;
pub const SHD_FORMAT_RG8_SRGB: shd_format = shd_format::RG8_SRGB;
pub const SHD_FORMAT_RGB8_SRGB: shd_format = shd_format::RGB8_SRGB;
pub const SHD_FORMAT_R16: shd_format = shd_format::R16;
pub const SHD_FORMAT_RG16: shd_format = shd_format::RG16;
pub const SHD_FORMAT_RGB16: shd_format = shd_format::RGB16;
pub const SHD_FORMAT_R16F: shd_format = shd_format::R16F;
pub const SHD_FORMAT_RG16F: shd_format = shd_format::RG16F;
pub const SHD_FORMAT_RGB16F: shd_format = shd_format::RGB16F;
pub const SHD_FORMAT_R32F: shd_format = shd_format::R32F;
pub const SHD_FORMAT_RG32F: shd_format = shd_format::RG32F;
pub const SHD_FORMAT_RGB32F: shd_format = shd_format::RGB32F;
pub const SHD_FORMAT_BC1_RGB: shd_format = shd_format::BC1_RGB;
pub const SHD_FORMAT_BC1_RGB_SRGB: shd_format = shd_format::BC1_RGB_SRGB;
pub const SHD_FORMAT_BC1_RGBA: shd_format = shd_format::BC1_RGBA;
pub const SHD_FORMAT_BC1_RGBA_SRGB: shd_format = shd_format::BC1_RGBA_SRGB;
pub const SHD_FORMAT_BC2: shd_format = shd_format::BC2;
pub const SHD_FORMAT_BC2_SRGB: shd_format = shd_format::BC2_SRGB;
pub const SHD_FORMAT_BC3: shd_format = shd_format::BC3;
pub const SHD_FORMAT_BC3_SRGB: shd_format = shd_format::BC3_SRGB;
pub const SHD_FORMAT_BC4: shd_format = shd_format::BC4;
pub const SHD_FORMAT_BC4_SNORM: shd_format = shd_format::BC4_SNORM;
pub const SHD_FORMAT_BC5: shd_format = shd_format::BC5;
pub const SHD_FORMAT_BC5_SNORM: shd_format = shd_format::BC5_SNORM;
pub const SHD_FORMAT_BC6H_UFLOAT: shd_format = shd_format::BC6H_UFLOAT;
pub const SHD_FORMAT_BC6H_SFLOAT: shd_format = shd_format::BC6H_SFLOAT;
pub const SHD_FORMAT_BC7: shd_format = shd_format::BC7;
pub const SHD_FORMAT_BC7_SRGB: shd_format = shd_format::BC7_SRGB;
pub const SHD_FORMAT_RGB9E5: shd_format = shd_format::RGB9E5;
names!(shd_format: NONE, R8, RGBA8, RGBA8_SRGB, RGBA16F, RGBA32F, RGBA16, RG8, RGB8, R8_SRGB, RG8_SRGB, RGB8_SRGB, R16, RG16, RGB16, R16F, RG16F, RGB16F, R32F, RG32F, RGB32F, BC1_RGB, BC1_RGB_SRGB, BC1_RGBA, BC1_RGBA_SRGB, BC2, BC2_SRGB, BC3, BC3_SRGB, BC4, BC4_SNORM, BC5, BC5_SNORM, BC6H_UFLOAT, BC6H_SFLOAT, BC7, BC7_SRGB, RGB9E5);

/// File formats that a load may accept; combine with |.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_file_format(pub u32);
impl shd_file_format {
    pub const NONE: Self = Self(0);
    pub const PNG: Self = Self(1);
    pub const JPEG: Self = Self(2);
    pub const EXR: Self = Self(4);
    pub const TIFF: Self = Self(8);
    /// Radiance RGBE
    pub const HDR: Self = Self(16);
    /// recognised by a plausible header, after all others: it has no signature; no
    /// palettes whose first index is not 0
    pub const TGA: Self = Self(32);
    /// uncompressed
    pub const BMP: Self = Self(64);
    /// blocks and pixels (shd/texture_file.h)
    pub const DDS: Self = Self(128);
    pub const WEBP: Self = Self(256);
    /// PBM, PGM, PPM and PFM
    pub const PNM: Self = Self(512);
    pub const PSD: Self = Self(1024);
    pub const DPX: Self = Self(2048);
    pub const GIF: Self = Self(4096);
    /// blocks and pixels (shd/texture_file.h)
    pub const KTX2: Self = Self(8192);
    /// grids of OpenVDB, textures alone (shd/volume_file.h)
    pub const VDB: Self = Self(16384);
    /// PNG, JPEG, EXR, TIFF, HDR, TGA, BMP, DDS, WEBP, PNM, KTX2 and VDB; default of shd_load_desc.formats.
    pub const DEFAULT: Self = Self(25599);
    /// Also every other format of the OpenImageIO build. For trusted files.
    pub const ANY: Self = Self(1073741824);
}
pub const SHD_FILE_FORMAT_NONE: shd_file_format = shd_file_format::NONE;
pub const SHD_FILE_FORMAT_PNG: shd_file_format = shd_file_format::PNG;
pub const SHD_FILE_FORMAT_JPEG: shd_file_format = shd_file_format::JPEG;
pub const SHD_FILE_FORMAT_EXR: shd_file_format = shd_file_format::EXR;
pub const SHD_FILE_FORMAT_TIFF: shd_file_format = shd_file_format::TIFF;
pub const SHD_FILE_FORMAT_HDR: shd_file_format = shd_file_format::HDR;
pub const SHD_FILE_FORMAT_TGA: shd_file_format = shd_file_format::TGA;
pub const SHD_FILE_FORMAT_BMP: shd_file_format = shd_file_format::BMP;
pub const SHD_FILE_FORMAT_DDS: shd_file_format = shd_file_format::DDS;
pub const SHD_FILE_FORMAT_WEBP: shd_file_format = shd_file_format::WEBP;
pub const SHD_FILE_FORMAT_PNM: shd_file_format = shd_file_format::PNM;
pub const SHD_FILE_FORMAT_PSD: shd_file_format = shd_file_format::PSD;
pub const SHD_FILE_FORMAT_DPX: shd_file_format = shd_file_format::DPX;
pub const SHD_FILE_FORMAT_GIF: shd_file_format = shd_file_format::GIF;
pub const SHD_FILE_FORMAT_KTX2: shd_file_format = shd_file_format::KTX2;
pub const SHD_FILE_FORMAT_VDB: shd_file_format = shd_file_format::VDB;
pub const SHD_FILE_FORMAT_DEFAULT: shd_file_format = shd_file_format::DEFAULT;
pub const SHD_FILE_FORMAT_ANY: shd_file_format = shd_file_format::ANY;
flags!(shd_file_format);

/// Encoding of the numbers of a file.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_color_encoding(pub u32);
impl shd_color_encoding {
    /// load: as declared by the file, see shd_bitmap_color_space(); save: by format
    pub const AUTO: Self = Self(0);
    /// r, g, b encoded with the sRGB curve (IEC 61966-2-1)
    pub const SRGB: Self = Self(1);
    /// light, Rec. 709 primaries
    pub const LINEAR: Self = Self(2);
    /// no colour: normals, roughness, masks
    pub const DATA: Self = Self(3);
}
pub const SHD_COLOR_ENCODING_AUTO: shd_color_encoding = shd_color_encoding::AUTO;
pub const SHD_COLOR_ENCODING_SRGB: shd_color_encoding = shd_color_encoding::SRGB;
pub const SHD_COLOR_ENCODING_LINEAR: shd_color_encoding = shd_color_encoding::LINEAR;
pub const SHD_COLOR_ENCODING_DATA: shd_color_encoding = shd_color_encoding::DATA;
names!(shd_color_encoding: AUTO, SRGB, LINEAR, DATA);

/// Options of a load; combine with |.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_load_flag(pub u32);
impl shd_load_flag {
    pub const DEFAULT: Self = Self(0);
    /// Decode in this process, for files that are as trusted as this program. Needs no worker; saves its start, about 2
    /// ms a file and one copy of the pixels. A hostile file can end or take over this process, and time_limit is checked
    /// between bands of rows only.
    pub const IN_PROCESS: Self = Self(1);
    /// a damaged file loads: rows above the damage, zero below, and SHD_BITMAP_PARTIAL is set
    pub const PARTIAL: Self = Self(2);
    /// bottom row first
    pub const FLIP_V: Self = Self(4);
    /// Textures: take the mip levels of an image file, unchanged, instead of averages of its base. OpenEXR, and TIFF as
    /// written by maketx (`.tx`), can have levels; KTX2 and DDS give theirs without the flag. If they end before 1 x 1,
    /// the mipmap of the texture ends there, too. If the file has none, shd builds all of them. Level l must be max(1,
    /// size >> l) wide and high: OpenEXR files of rounding mode ROUND_UP whose sizes differ are SHD_ERROR_UNSUPPORTED,
    /// and so are levels of a file whose data window is not its display window. A damaged level is SHD_ERROR_CORRUPT;
    /// with SHD_LOAD_PARTIAL it and all smaller levels count as absent. Needs SHD_TABLE_MIPMAP in `tables`. Bitmaps have
    /// no levels.
    pub const FILE_LEVELS: Self = Self(8);
    /// Bitmaps: colour becomes linear light by its colour space, as an image that is a light needs it. RGBA8_SRGB, whose
    /// format has the curve, linear 8-bit, half and float pixels stay as they are; all others become RGBA32F, and
    /// shd_bitmap_color_space() is "Linear Rec.709". Primaries are not converted. An unknown colour space is
    /// SHD_ERROR_UNSUPPORTED. Textures are always linear.
    pub const LINEAR: Self = Self(16);
    /// Textures of images with alpha: invisible texels give no fringes. r, g and b of the mip levels are averages
    /// weighted by alpha (SHD_TEXEL_CONTENT_ALPHA_WEIGHTED). Texels of alpha 0, in all levels, take the mean colour of
    /// their visible neighbours, or of the next coarser level if no neighbour is visible; so lookups between a visible
    /// and an invisible texel have the colour of the visible one. For straight alpha. No effect on other textures, on
    /// KTX2 and DDS, and with SHD_LOAD_FILE_LEVELS if the file has levels.
    pub const ALPHA_WEIGHTED: Self = Self(32);
    /// Textures of images with alpha: r, g and b are multiplied by alpha, so that lookups and mip levels are averages
    /// weighted by alpha, without fringes (Porter and Duff, "Compositing Digital Images", 1984). The texture is
    /// SHD_TEXTURE_PREMULTIPLIED; 8-bit texels become RGBA16F. No effect on files that are premultiplied or opaque, and
    /// on KTX2 and DDS. Not with SHD_LOAD_ALPHA_WEIGHTED.
    pub const PREMULTIPLY: Self = Self(64);
}
pub const SHD_LOAD_DEFAULT: shd_load_flag = shd_load_flag::DEFAULT;
pub const SHD_LOAD_IN_PROCESS: shd_load_flag = shd_load_flag::IN_PROCESS;
pub const SHD_LOAD_PARTIAL: shd_load_flag = shd_load_flag::PARTIAL;
pub const SHD_LOAD_FLIP_V: shd_load_flag = shd_load_flag::FLIP_V;
pub const SHD_LOAD_FILE_LEVELS: shd_load_flag = shd_load_flag::FILE_LEVELS;
pub const SHD_LOAD_LINEAR: shd_load_flag = shd_load_flag::LINEAR;
pub const SHD_LOAD_ALPHA_WEIGHTED: shd_load_flag = shd_load_flag::ALPHA_WEIGHTED;
pub const SHD_LOAD_PREMULTIPLY: shd_load_flag = shd_load_flag::PREMULTIPLY;
flags!(shd_load_flag);

/// Properties of a loaded file; combine with |.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_bitmap_flag(pub u32);
impl shd_bitmap_flag {
    pub const NONE: Self = Self(0);
    /// damaged, rows are missing (SHD_LOAD_PARTIAL)
    pub const PARTIAL: Self = Self(1);
    /// r, g, b are multiplied by alpha (EXR, some TIFF); otherwise straight
    pub const PREMULTIPLIED: Self = Self(2);
}
pub const SHD_BITMAP_NONE: shd_bitmap_flag = shd_bitmap_flag::NONE;
pub const SHD_BITMAP_PARTIAL: shd_bitmap_flag = shd_bitmap_flag::PARTIAL;
pub const SHD_BITMAP_PREMULTIPLIED: shd_bitmap_flag = shd_bitmap_flag::PREMULTIPLIED;
flags!(shd_bitmap_flag);

/// Rounding of colour to the codes of an integer format.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_dither(pub u32);
impl shd_dither {
    /// to the nearest
    pub const NONE: Self = Self(0);
    /// Up or down by a fixed pattern of the pixel's position, so that areas keep their mean and gradients show no bands.
    /// Values that equal a code do not change. r, g and b of a pixel share a threshold; alpha is rounded to the nearest.
    pub const ORDERED: Self = Self(1);
}
pub const SHD_DITHER_NONE: shd_dither = shd_dither::NONE;
pub const SHD_DITHER_ORDERED: shd_dither = shd_dither::ORDERED;
names!(shd_dither: NONE, ORDERED);

/// Kind of light.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_light_kind(pub u32);
impl shd_light_kind {
    /// from a point in all directions
    pub const POINT: Self = Self(0);
    /// parallel rays of equal E everywhere
    pub const DIRECTIONAL: Self = Self(1);
    /// I_a, from all directions; ambient lights add up
    pub const AMBIENT: Self = Self(2);
    /// from a point into a cone
    pub const SPOT: Self = Self(3);
}
pub const SHD_LIGHT_KIND_POINT: shd_light_kind = shd_light_kind::POINT;
pub const SHD_LIGHT_KIND_DIRECTIONAL: shd_light_kind = shd_light_kind::DIRECTIONAL;
pub const SHD_LIGHT_KIND_AMBIENT: shd_light_kind = shd_light_kind::AMBIENT;
pub const SHD_LIGHT_KIND_SPOT: shd_light_kind = shd_light_kind::SPOT;
names!(shd_light_kind: POINT, DIRECTIONAL, AMBIENT, SPOT);

/// Reflectance model: the radiance L towards the eye.
///
/// n: unit normal, l: unit vector to a light, v: unit vector to the eye, h = (v + l) / |v + l|, E: irradiance
/// (shd/light.h). Sums are over all lights except ambient lights, whose sum is I_a. k_d, k_a, k_s, p and so on are
/// constants of the material times their slots. "Specular" terms are 0 where n.l \<= 0 (except with
/// SHD_MATERIAL_SPECULAR_UNGATED) and where v + l = 0; 0^0 = 1. Every model adds the emission, and multiplies I_a by the
/// occlusion.
///
/// BLINN_PHONG_NORMALIZED and METALLIC_ROUGHNESS divide the diffuse term by pi, the other models do not: with lights
/// whose intensity is pi times as large, their diffuse surfaces are as bright as those of LAMBERT (shd/light.h).
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_model(pub u32);
impl shd_model {
    /// k_a I_a + sum of k_d E max(0, n.l)
    pub const LAMBERT: Self = Self(0);
    /// Lambert + sum of k_s E max(0, n.h)^p (Blinn 1977)
    pub const BLINN_PHONG: Self = Self(1);
    /// program.fragment
    pub const PROGRAM: Self = Self(2);
    /// k_d, independent of lights and frequency
    pub const UNLIT: Self = Self(3);
    /// Lambert + sum of k_s E max(0, v.r)^p with r = 2 (n.l) n - l (Phong 1975)
    pub const PHONG: Self = Self(4);
    /// k_a I_a + sum of (k_d / pi + k_s N max(0, n.h)^p) E max(0, n.l), N = (p + 2)(p + 4) / (8 pi (2^(-p/2) + p)):
    /// reflects at most the incident light where k_d + k_s \<= 1 (Giesen, "Phong and Blinn-Phong Normalization Factors",
    /// 2009)
    pub const BLINN_PHONG_NORMALIZED: Self = Self(5);
    /// k_d (I_a + sum of E max(0, n.l)) + sum of E k_s max(0, n.h)^p (Shirley and Marschner, "Fundamentals of Computer
    /// Graphics", 2009, 10.2)
    pub const COMBINED: Self = Self(6);
    /// k_w w + (1 - k_w) c with k_w the mean of (1 + n.l) / 2 over the lights, 1/2 without any: w = warm + warm_mix k_d,
    /// c = cool + cool_mix k_d (Gooch et al., "A Non-Photorealistic Lighting Model", 1998)
    pub const GOOCH: Self = Self(7);
    /// Blinn-Phong with n.l rounded up to a multiple of 1 / toon_steps, and max(0, n.h)^p replaced by 0 below 1/2 and by
    /// 1 from 1/2 on
    pub const TOON: Self = Self(8);
    /// Metallic-roughness of glTF 2.0, appendix B: k_a I_a (b (1 - m) + F0) + sum of E max(0, n.l) (b (1 - m) (1 - f)
    /// (1 - (1 - v.h)^5) / pi + F D V), with base colour b = k_d, metallic m, alpha = max(roughness^2, 0.001),
    /// F = F0 + (1 - F0) (1 - v.h)^5, F0 = f (1 - m) + b m, f = ((ior - 1) / (ior + 1))^2, the distribution D of
    /// Trowbridge and Reitz (GGX) and V, the height-correlated masking and shadowing of Smith over 4 (n.l) (n.v), where
    /// n.v counts as at least 1e-4: interpolated normals may face away from the eye. Metals reflect at most the incident
    /// light. Dielectrics exceed it at grazing angles (1.2 at 75 degrees from n, 1.6 at 85), diffuse plus specular
    pub const METALLIC_ROUGHNESS: Self = Self(9);
    /// k_d times SHD_SLOT_MATCAP at (1/2 + x/2, 1/2 - y/2) of the normal in view space; a normal
    /// without a direction reads the middle
    pub const MATCAP: Self = Self(10);
    /// A clear solid: k_a I_a + sum of E max(0, n.l) F D V + k_d (1 - F) T, with F, D and V of METALLIC_ROUGHNESS for
    /// F0 = ((ior - 1) / (ior + 1))^2, and T the radiance of the frame's environment (shd_render_desc.environment) along
    /// the refracted line of sight, 0 without one. The solid counts as a sphere with the normal of the fragment, which
    /// turns the line of sight twice. Other draws are not seen through it
    pub const GLASS: Self = Self(11);
}
pub const SHD_MODEL_LAMBERT: shd_model = shd_model::LAMBERT;
pub const SHD_MODEL_BLINN_PHONG: shd_model = shd_model::BLINN_PHONG;
pub const SHD_MODEL_PROGRAM: shd_model = shd_model::PROGRAM;
pub const SHD_MODEL_UNLIT: shd_model = shd_model::UNLIT;
pub const SHD_MODEL_PHONG: shd_model = shd_model::PHONG;
pub const SHD_MODEL_BLINN_PHONG_NORMALIZED: shd_model = shd_model::BLINN_PHONG_NORMALIZED;
pub const SHD_MODEL_COMBINED: shd_model = shd_model::COMBINED;
pub const SHD_MODEL_GOOCH: shd_model = shd_model::GOOCH;
pub const SHD_MODEL_TOON: shd_model = shd_model::TOON;
pub const SHD_MODEL_METALLIC_ROUGHNESS: shd_model = shd_model::METALLIC_ROUGHNESS;
pub const SHD_MODEL_MATCAP: shd_model = shd_model::MATCAP;
pub const SHD_MODEL_GLASS: shd_model = shd_model::GLASS;
names!(shd_model: LAMBERT, BLINN_PHONG, PROGRAM, UNLIT, PHONG, BLINN_PHONG_NORMALIZED, COMBINED, GOOCH, TOON, METALLIC_ROUGHNESS, MATCAP, GLASS);

/// Debug views of values that the rasteriser computes. They replace the model's radiance L; the emission is added.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_debug_view(pub u32);
impl shd_debug_view {
    /// the model
    pub const NONE: Self = Self(0);
    /// shading normal: (n + 1) / 2
    pub const NORMAL: Self = Self(1);
    /// texture coordinates: (u - floor(u), v - floor(v), 0)
    pub const UV: Self = Self(2);
    /// level of detail of the diffuse texture: blue for level 0, over green, to red for
    /// the last level
    pub const LEVEL: Self = Self(3);
    /// barycentric coordinates in the triangle
    pub const BARYCENTRICS: Self = Self(4);
}
pub const SHD_DEBUG_VIEW_NONE: shd_debug_view = shd_debug_view::NONE;
pub const SHD_DEBUG_VIEW_NORMAL: shd_debug_view = shd_debug_view::NORMAL;
pub const SHD_DEBUG_VIEW_UV: shd_debug_view = shd_debug_view::UV;
pub const SHD_DEBUG_VIEW_LEVEL: shd_debug_view = shd_debug_view::LEVEL;
pub const SHD_DEBUG_VIEW_BARYCENTRICS: shd_debug_view = shd_debug_view::BARYCENTRICS;
names!(shd_debug_view: NONE, NORMAL, UV, LEVEL, BARYCENTRICS);

/// Encoding of a tangent-space normal in the values of SHD_SLOT_NORMAL.
///
/// x points along u, z along the normal, and y up in the image, against v, as in glTF 2.0 (down with
/// SHD_MATERIAL_NORMAL_Y_DOWN). Textures of 8 and 16 bits hold (c + 1) / 2 of a component c; float textures, vertices
/// and procedures hold c itself.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_normal_encoding(pub u32);
impl shd_normal_encoding {
    /// (x, y, z)
    pub const XYZ: Self = Self(0);
    /// (x, y), z = sqrt(1 - x^2 - y^2)
    pub const XY: Self = Self(1);
    /// XYZ with the length of the mean normal as the fourth channel, as shd_mip_build() makes it. The variance of
    /// normals within a pixel widens the specular lobe (Toksvig, "Mipmapping Normal Maps", 2005)
    pub const TOKSVIG: Self = Self(2);
    /// (x / z, y / z) and their squares, in floats, and their product in SHD_SLOT_NORMAL_MIXED, as shd_normal_moments()
    /// makes them. Lobes are averaged over normals with slopes of mean b and covariance S within the pixel (Olano and
    /// Baker, "LEAN Mapping", 2010), so grooves stretch highlights across them. With S = 0 the results are those of XYZ:
    /// - diffuse: the mean of max(0, n.l) over a Gaussian of slopes around the mean normal, divided by
    /// sqrt(1 + trace S);
    /// - max(0, n.h)^p: Laplace's method, that is the lobe of the normal between b and h where its product with the
    /// Gaussian is largest, times the Gaussian there, divided by sqrt(det(1 + p S G)), G being the metric of angles;
    /// - max(0, v.r)^p: the same with 4 p h.l in place of p;
    /// - METALLIC_ROUGHNESS: adaptive Gauss-Hermite quadrature (Naylor and Smith, "Applications of a Method for the
    /// Efficient Computation of Posterior Distributions", 1982): the sum of the lobes of four normals along the longer
    /// axis of S. Normals and weights suit the Gaussian of slopes times a Gaussian around h with the precision
    /// 2 (0.2 + r^2) / (1 + r^2) / alpha^2, r = s / (6 alpha^2) for the larger variance s of S.
    /// GOOCH and TOON use the mean normal only. SHD_FILTER_EWA with a lod_bias of -0.5 to -0.25 is closest to shading
    /// many samples a pixel: its default footprint is wider than a pixel
    pub const MOMENTS: Self = Self(3);
}
pub const SHD_NORMAL_ENCODING_XYZ: shd_normal_encoding = shd_normal_encoding::XYZ;
pub const SHD_NORMAL_ENCODING_XY: shd_normal_encoding = shd_normal_encoding::XY;
pub const SHD_NORMAL_ENCODING_TOKSVIG: shd_normal_encoding = shd_normal_encoding::TOKSVIG;
pub const SHD_NORMAL_ENCODING_MOMENTS: shd_normal_encoding = shd_normal_encoding::MOMENTS;
names!(shd_normal_encoding: XYZ, XY, TOKSVIG, MOMENTS);

/// Tilt of normals by SHD_SLOT_HEIGHT.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_bump(pub u32);
impl shd_bump {
    /// no tilt; heights are for parallax only
    pub const NONE: Self = Self(0);
    /// The normal of the surface moved along n by bump_scale h \[world units\]: n - bump_scale grad h. The gradient on the
    /// surface uses the exact derivative of the filtered height in u and v (Mikkelsen, "Bump Mapping Unparametrized
    /// Surfaces on the GPU", 2010). Filters without derivatives use differences over a texel.
    pub const GRADIENT: Self = Self(1);
    /// (-s (h(u + 1/w, v) - h(u, v)), -s (h(u, v + 1/h) - h(u, v)), 1) along t, v and n, with s = bump_scale:
    /// differences over one texel, independent of the size of the surface (after Blinn, "Simulation of Wrinkled
    /// Surfaces", 1978)
    pub const TEXEL: Self = Self(2);
}
pub const SHD_BUMP_NONE: shd_bump = shd_bump::NONE;
pub const SHD_BUMP_GRADIENT: shd_bump = shd_bump::GRADIENT;
pub const SHD_BUMP_TEXEL: shd_bump = shd_bump::TEXEL;
names!(shd_bump: NONE, GRADIENT, TEXEL);

/// Blending of a fragment of colour c and opacity a onto a sample of colour d and opacity A.
///
/// Models give c = a L with the radiance L and a = opacity times its slot times the alpha of the diffuse slot. For
/// STRAIGHT and OPAQUE they give c = L.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_blend(pub u32);
impl shd_blend {
    /// colour c; A becomes the a of a program, or 1 for a model
    pub const OPAQUE: Self = Self(0);
    /// c + (1 - a) d, a + (1 - a) A: "over" (Porter and Duff 1984)
    pub const PREMULTIPLIED: Self = Self(1);
    /// a c + (1 - a) d, a + (1 - a) A
    pub const STRAIGHT: Self = Self(2);
    /// c + d, A
    pub const ADD: Self = Self(3);
    /// c d + (1 - a) d, A
    pub const MULTIPLY: Self = Self(4);
    /// After all other draws, independent of order: with R the product of 1 - a, w = max(0.01, 3000 (1 - depth)^3) and
    /// C = sum of w c / sum of w a, the result is (1 - R) C + R d, 1 - R + R A. An approximation (McGuire and Bavoil,
    /// "Weighted Blended Order-Independent Transparency", 2013, equation 10). Depth is tested, not written.
    pub const WEIGHTED: Self = Self(5);
    /// After all other draws, PREMULTIPLIED from far to near per sample; equal depths in the order of draws and
    /// triangles. Depth is tested, not written.
    pub const SORTED: Self = Self(6);
}
pub const SHD_BLEND_OPAQUE: shd_blend = shd_blend::OPAQUE;
pub const SHD_BLEND_PREMULTIPLIED: shd_blend = shd_blend::PREMULTIPLIED;
pub const SHD_BLEND_STRAIGHT: shd_blend = shd_blend::STRAIGHT;
pub const SHD_BLEND_ADD: shd_blend = shd_blend::ADD;
pub const SHD_BLEND_MULTIPLY: shd_blend = shd_blend::MULTIPLY;
pub const SHD_BLEND_WEIGHTED: shd_blend = shd_blend::WEIGHTED;
pub const SHD_BLEND_SORTED: shd_blend = shd_blend::SORTED;
names!(shd_blend: OPAQUE, PREMULTIPLIED, STRAIGHT, ADD, MULTIPLY, WEIGHTED, SORTED);

/// Options of a material; combine with |.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_material_flag(pub u32);
impl shd_material_flag {
    pub const NONE: Self = Self(0);
    /// Keep the specular term where n.l \<= 0, as in the textbook formula; by default it is 0 there.
    pub const SPECULAR_UNGATED: Self = Self(1);
    /// Add the ambient term once for each light that is not ambient, instead of once in total.
    pub const AMBIENT_PER_LIGHT: Self = Self(2);
    /// The program may set shd_radiance.discard.
    pub const DISCARDS: Self = Self(4);
    /// Keep the first round(a * sample count) samples of a pixel and drop the others.
    pub const ALPHA_TO_COVERAGE: Self = Self(8);
    /// Flip normals on triangles seen from behind.
    pub const DOUBLE_SIDED: Self = Self(16);
    /// Mapped normals have y down in the image, along v, as usual with Direct3D; default is up, as in glTF.
    pub const NORMAL_Y_DOWN: Self = Self(32);
}
pub const SHD_MATERIAL_NONE: shd_material_flag = shd_material_flag::NONE;
pub const SHD_MATERIAL_SPECULAR_UNGATED: shd_material_flag = shd_material_flag::SPECULAR_UNGATED;
pub const SHD_MATERIAL_AMBIENT_PER_LIGHT: shd_material_flag = shd_material_flag::AMBIENT_PER_LIGHT;
pub const SHD_MATERIAL_DISCARDS: shd_material_flag = shd_material_flag::DISCARDS;
pub const SHD_MATERIAL_ALPHA_TO_COVERAGE: shd_material_flag = shd_material_flag::ALPHA_TO_COVERAGE;
pub const SHD_MATERIAL_DOUBLE_SIDED: shd_material_flag = shd_material_flag::DOUBLE_SIDED;
pub const SHD_MATERIAL_NORMAL_Y_DOWN: shd_material_flag = shd_material_flag::NORMAL_Y_DOWN;
flags!(shd_material_flag);

/// Weights of face normals in computed vertex normals. Degenerate faces contribute nothing.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_normal_weight(pub u32);
impl shd_normal_weight {
    /// sum of face normals times face area (the cross products)
    pub const AREA: Self = Self(0);
    /// plain average of unit face normals
    pub const UNIFORM: Self = Self(1);
    /// weighted by the corner angle (Thuermer and Wuethrich 1998)
    pub const ANGLE: Self = Self(2);
}
pub const SHD_NORMAL_WEIGHT_AREA: shd_normal_weight = shd_normal_weight::AREA;
pub const SHD_NORMAL_WEIGHT_UNIFORM: shd_normal_weight = shd_normal_weight::UNIFORM;
pub const SHD_NORMAL_WEIGHT_ANGLE: shd_normal_weight = shd_normal_weight::ANGLE;
names!(shd_normal_weight: AREA, UNIFORM, ANGLE);

/// Assembly of triangles from indices. A triangle of coincident vertices counts as a triangle, but covers nothing.
/// There is no topology of lines or points: shd_draw.fill draws the edges or the vertices of triangles.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_topology(pub u32);
impl shd_topology {
    /// three indices each: (0, 1, 2), (3, 4, 5), ...
    pub const TRIANGLES: Self = Self(0);
    /// each further index adds a triangle: (0, 1, 2), (1, 3, 2), (2, 3, 4), ...
    pub const STRIP: Self = Self(1);
    /// each further index adds a triangle around vertex 0: (0, 1, 2), (0, 2, 3), ...
    pub const FAN: Self = Self(2);
}
pub const SHD_TOPOLOGY_TRIANGLES: shd_topology = shd_topology::TRIANGLES;
pub const SHD_TOPOLOGY_STRIP: shd_topology = shd_topology::STRIP;
pub const SHD_TOPOLOGY_FAN: shd_topology = shd_topology::FAN;
names!(shd_topology: TRIANGLES, STRIP, FAN);

/// Options of a mesh; combine with |.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_mesh_flag(pub u32);
impl shd_mesh_flag {
    pub const NONE: Self = Self(0);
    /// Accept NaN and infinite positions; rendering drops and counts the triangles that use them.
    pub const KEEP_NONFINITE: Self = Self(1);
    /// Compute tangents when none are given; see tangents. Vertices may be appended to the caller's vertices:
    /// shd_mesh_info.vertex_count is vertex_count + split_count.
    pub const TANGENTS: Self = Self(2);
    /// Find the triangles that share each edge, for shd_mesh_find_edges() and SHD_FILL_LINES. The mesh takes 12 more
    /// bytes per triangle. Its creation temporarily takes another 12 bytes per triangle and 12 per vertex, and linear
    /// time.
    pub const ADJACENCY: Self = Self(4);
}
pub const SHD_MESH_NONE: shd_mesh_flag = shd_mesh_flag::NONE;
pub const SHD_MESH_KEEP_NONFINITE: shd_mesh_flag = shd_mesh_flag::KEEP_NONFINITE;
pub const SHD_MESH_TANGENTS: shd_mesh_flag = shd_mesh_flag::TANGENTS;
pub const SHD_MESH_ADJACENCY: shd_mesh_flag = shd_mesh_flag::ADJACENCY;
flags!(shd_mesh_flag);

/// Filter kernel along one axis, in texels of the new level.
///
/// The weight of a source texel is the integral of the kernel over the texel, for any ratio of sizes. The weights of a
/// level's texel sum to 1, so constant images stay constant.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_mip_kernel(pub u32);
impl shd_mip_kernel {
    /// the texel's own area (Williams 1983)
    pub const BOX: Self = Self(0);
    /// 1 - |x|, radius 1
    pub const TRIANGLE: Self = Self(1);
    /// sinc under a Kaiser window of parameter 4, radius 3
    pub const KAISER: Self = Self(2);
    /// sinc(x) sinc(x / 3), radius 3
    pub const LANCZOS: Self = Self(3);
}
pub const SHD_MIP_KERNEL_BOX: shd_mip_kernel = shd_mip_kernel::BOX;
pub const SHD_MIP_KERNEL_TRIANGLE: shd_mip_kernel = shd_mip_kernel::TRIANGLE;
pub const SHD_MIP_KERNEL_KAISER: shd_mip_kernel = shd_mip_kernel::KAISER;
pub const SHD_MIP_KERNEL_LANCZOS: shd_mip_kernel = shd_mip_kernel::LANCZOS;
names!(shd_mip_kernel: BOX, TRIANGLE, KAISER, LANCZOS);

/// Source of each level.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_mip_source(pub u32);
impl shd_mip_source {
    /// every level is made from the base and rounded once
    pub const BASE: Self = Self(0);
    /// every level is made from the previous, stored level; faster for many levels,
    /// but rounding errors add up
    pub const PREVIOUS: Self = Self(1);
}
pub const SHD_MIP_SOURCE_BASE: shd_mip_source = shd_mip_source::BASE;
pub const SHD_MIP_SOURCE_PREVIOUS: shd_mip_source = shd_mip_source::PREVIOUS;
names!(shd_mip_source: BASE, PREVIOUS);

/// Content of the texels, which decides how they are averaged.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_texel_content(pub u32);
impl shd_texel_content {
    /// light: _SRGB formats are decoded before filtering
    pub const COLOR: Self = Self(0);
    /// numbers: _SRGB formats are filtered without decoding
    pub const DATA: Self = Self(1);
    /// Unit vectors in three or four channels. Integer channels, of _SRGB formats too, hold (n + 1) / 2. Levels are
    /// renormalised; a zero mean becomes (0, 0, 1). The fourth channel of a level is the length of the mean, at most 1;
    /// materials compute a wider specular lobe from it (Toksvig, "Mipmapping Normal Maps", 2005). The caller sets the
    /// fourth channel of the base, 1 for unit vectors.
    pub const NORMAL: Self = Self(2);
    /// as data
    pub const HEIGHT: Self = Self(3);
    /// Colour whose alpha is tested, in four channels. Alpha of every level is scaled so that the share of texels that
    /// reach `alpha_cutoff` is the share of the base (Castano, "Computing Alpha Mipmaps", 2010). The share is exact to
    /// the nearest texel, except where texels of equal alpha lie at the cutoff.
    pub const ALPHA_COVERAGE: Self = Self(4);
    /// Colour with straight alpha, in four channels. r, g and b of a level are averages weighted by alpha, as averages
    /// of premultiplied colour: transparent texels do not shine through (Porter and Duff, "Compositing Digital Images",
    /// 1984). The weight of a texel is max(alpha, 0) + 2^-20, so that colours under alpha 0 alone are averaged, too.
    pub const ALPHA_WEIGHTED: Self = Self(5);
}
pub const SHD_TEXEL_CONTENT_COLOR: shd_texel_content = shd_texel_content::COLOR;
pub const SHD_TEXEL_CONTENT_DATA: shd_texel_content = shd_texel_content::DATA;
pub const SHD_TEXEL_CONTENT_NORMAL: shd_texel_content = shd_texel_content::NORMAL;
pub const SHD_TEXEL_CONTENT_HEIGHT: shd_texel_content = shd_texel_content::HEIGHT;
pub const SHD_TEXEL_CONTENT_ALPHA_COVERAGE: shd_texel_content = shd_texel_content::ALPHA_COVERAGE;
pub const SHD_TEXEL_CONTENT_ALPHA_WEIGHTED: shd_texel_content = shd_texel_content::ALPHA_WEIGHTED;
names!(shd_texel_content: COLOR, DATA, NORMAL, HEIGHT, ALPHA_COVERAGE, ALPHA_WEIGHTED);

/// Kind of generalised barycentric coordinates; the file's comment has the formulas.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_barycentric(pub u32);
impl shd_barycentric {
    /// rational functions on convex polygons
    pub const WACHSPRESS: Self = Self(0);
    /// closed form on simple polygons
    pub const MEAN_VALUE: Self = Self(1);
    /// cotangent weights on convex polygons
    pub const DISCRETE_HARMONIC: Self = Self(2);
    /// solution of the Laplace equation on simple polygons
    pub const HARMONIC: Self = Self(3);
}
pub const SHD_BARYCENTRIC_WACHSPRESS: shd_barycentric = shd_barycentric::WACHSPRESS;
pub const SHD_BARYCENTRIC_MEAN_VALUE: shd_barycentric = shd_barycentric::MEAN_VALUE;
pub const SHD_BARYCENTRIC_DISCRETE_HARMONIC: shd_barycentric = shd_barycentric::DISCRETE_HARMONIC;
pub const SHD_BARYCENTRIC_HARMONIC: shd_barycentric = shd_barycentric::HARMONIC;
names!(shd_barycentric: WACHSPRESS, MEAN_VALUE, DISCRETE_HARMONIC, HARMONIC);

/// Maps from directions to points of images.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_projection(pub u32);
impl shd_projection {
    /// an image that shows no directions
    pub const NONE: Self = Self(0);
    /// longitude across, latitude down; any size, customary: width = 2 height
    pub const LAT_LONG: Self = Self(1);
    /// photograph of a mirror ball; square
    pub const MIRROR_BALL: Self = Self(2);
    /// the distance from the centre is the angle from +Z; square
    pub const ANGULAR: Self = Self(3);
    /// six square faces: +X, -X, +Y, -Y, +Z, -Z
    pub const CUBE: Self = Self(4);
    /// an octahedron unfolded into a square
    pub const OCTAHEDRAL: Self = Self(5);
}
pub const SHD_PROJECTION_NONE: shd_projection = shd_projection::NONE;
pub const SHD_PROJECTION_LAT_LONG: shd_projection = shd_projection::LAT_LONG;
pub const SHD_PROJECTION_MIRROR_BALL: shd_projection = shd_projection::MIRROR_BALL;
pub const SHD_PROJECTION_ANGULAR: shd_projection = shd_projection::ANGULAR;
pub const SHD_PROJECTION_CUBE: shd_projection = shd_projection::CUBE;
pub const SHD_PROJECTION_OCTAHEDRAL: shd_projection = shd_projection::OCTAHEDRAL;
names!(shd_projection: NONE, LAT_LONG, MIRROR_BALL, ANGULAR, CUBE, OCTAHEDRAL);

/// Arrangement of the faces of a cube map in images. n is the size of a face.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_cube_layout(pub u32);
impl shd_cube_layout {
    /// six images of n x n: +X, -X, +Y, -Y, +Z, -Z
    pub const FACES: Self = Self(0);
    /// one image of 6n x n: the faces from left to right
    pub const ROW: Self = Self(1);
    /// one image of n x 6n: the faces from top to bottom
    pub const COLUMN: Self = Self(2);
    /// 4n x 3n: +Y above +Z; -X, +Z, +X, -Z; -Y below +Z
    pub const HORIZONTAL_CROSS: Self = Self(3);
    /// 3n x 4n: +Y; -X, +Z, +X; -Y; -Z turned by half a turn
    pub const VERTICAL_CROSS: Self = Self(4);
}
pub const SHD_CUBE_LAYOUT_FACES: shd_cube_layout = shd_cube_layout::FACES;
pub const SHD_CUBE_LAYOUT_ROW: shd_cube_layout = shd_cube_layout::ROW;
pub const SHD_CUBE_LAYOUT_COLUMN: shd_cube_layout = shd_cube_layout::COLUMN;
pub const SHD_CUBE_LAYOUT_HORIZONTAL_CROSS: shd_cube_layout = shd_cube_layout::HORIZONTAL_CROSS;
pub const SHD_CUBE_LAYOUT_VERTICAL_CROSS: shd_cube_layout = shd_cube_layout::VERTICAL_CROSS;
names!(shd_cube_layout: FACES, ROW, COLUMN, HORIZONTAL_CROSS, VERTICAL_CROSS);

/// Points at which the reflectance model is evaluated. Textures are looked up per fragment at every frequency.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_frequency(pub u32);
impl shd_frequency {
    /// per fragment, with interpolated and renormalised normals (Phong 1975)
    pub const PHONG: Self = Self(0);
    /// per vertex, colours interpolated (Gouraud 1971)
    pub const GOURAUD: Self = Self(1);
    /// once per triangle, with the face normal at the centroid
    pub const FLAT: Self = Self(2);
}
pub const SHD_FREQUENCY_PHONG: shd_frequency = shd_frequency::PHONG;
pub const SHD_FREQUENCY_GOURAUD: shd_frequency = shd_frequency::GOURAUD;
pub const SHD_FREQUENCY_FLAT: shd_frequency = shd_frequency::FLAT;
names!(shd_frequency: PHONG, GOURAUD, FLAT);

/// Triangles that are skipped; front = counter-clockwise on the screen, seen with y up.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_cull(pub u32);
impl shd_cull {
    pub const NONE: Self = Self(0);
    pub const BACK: Self = Self(1);
    pub const FRONT: Self = Self(2);
}
pub const SHD_CULL_NONE: shd_cull = shd_cull::NONE;
pub const SHD_CULL_BACK: shd_cull = shd_cull::BACK;
pub const SHD_CULL_FRONT: shd_cull = shd_cull::FRONT;
names!(shd_cull: NONE, BACK, FRONT);

/// Options of a draw; combine with |.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_draw_flag(pub u32);
impl shd_draw_flag {
    pub const NONE: Self = Self(0);
    /// test depth without writing it
    pub const KEEP_DEPTH: Self = Self(1);
    /// shade every sample at its own position, instead of every pixel once
    pub const SAMPLE_SHADING: Self = Self(2);
}
pub const SHD_DRAW_NONE: shd_draw_flag = shd_draw_flag::NONE;
pub const SHD_DRAW_KEEP_DEPTH: shd_draw_flag = shd_draw_flag::KEEP_DEPTH;
pub const SHD_DRAW_SAMPLE_SHADING: shd_draw_flag = shd_draw_flag::SAMPLE_SHADING;
flags!(shd_draw_flag);

/// Parts of a triangle that are drawn.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_fill(pub u32);
impl shd_fill {
    pub const SOLID: Self = Self(0);
    /// its three edges
    pub const WIREFRAME: Self = Self(1);
    /// its three vertices
    pub const POINTS: Self = Self(2);
    /// its edges of the kinds in shd_draw.edges; for meshes with SHD_MESH_ADJACENCY
    pub const LINES: Self = Self(3);
}
pub const SHD_FILL_SOLID: shd_fill = shd_fill::SOLID;
pub const SHD_FILL_WIREFRAME: shd_fill = shd_fill::WIREFRAME;
pub const SHD_FILL_POINTS: shd_fill = shd_fill::POINTS;
pub const SHD_FILL_LINES: shd_fill = shd_fill::LINES;
names!(shd_fill: SOLID, WIREFRAME, POINTS, LINES);

/// Options of a frame; combine with |.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_render_flag(pub u32);
impl shd_render_flag {
    pub const NONE: Self = Self(0);
    /// fill shd_render_stats.hidden_samples: coverage is computed at least twice
    pub const COUNT_HIDDEN: Self = Self(1);
    /// keep the planes instead of clearing them: each sample starts with the values of its
    /// pixel
    pub const LOAD: Self = Self(2);
}
pub const SHD_RENDER_NONE: shd_render_flag = shd_render_flag::NONE;
pub const SHD_RENDER_COUNT_HIDDEN: shd_render_flag = shd_render_flag::COUNT_HIDDEN;
pub const SHD_RENDER_LOAD: shd_render_flag = shd_render_flag::LOAD;
flags!(shd_render_flag);

/// Method that decides which triangle is visible at a sample.
///
/// PAINTER and NEWELL order the triangles of all draws and paint each over the previous ones. Depths are not compared,
/// as with SHD_COMPARE_ALWAYS; the final depth is that of the triangle painted last. Depth decreases with the distance
/// in draws that compare GREATER or GREATER_EQUAL and increases in all others; biases apply. shd_draw_flag works as
/// usual. Opaque draws are shaded after all of them are painted. PREMULTIPLIED, STRAIGHT, ADD and MULTIPLY take effect
/// in the order of painting. WEIGHTED and SORTED come last and test the painted depths. A draw without a material writes
/// its depth and hides nothing.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_visibility(pub u32);
impl shd_visibility {
    /// the depth of the sample, by the draw's comparison (Catmull 1974)
    pub const DEPTH: Self = Self(0);
    /// The painter's algorithm: triangles by their farthest vertex, far ones first, equal ones in the order of draws and
    /// triangles. The picture is wrong where two triangles overlap and the one painted first is nearer in the overlap;
    /// shd_render_stats.order_conflicts counts these pairs. O(n log n).
    pub const PAINTER: Self = Self(1);
    /// The painter's algorithm with the tests, reordering and cuts of Newell, Newell and Sancha, "A Solution to the
    /// Hidden Surface Problem" (1972). Correct, except where depths differ by less than the effect of a shift by 1/256
    /// pixel, or by less than 2^-23.
    ///
    /// Triangles that overlap cyclically or pass through each other are cut along the plane of one of them. New vertices
    /// lie on the grid of 1/256 pixel. A sample within 1/256 pixel of a cut, or of an edge that was cut, may lie on
    /// either side, and windows of a picture may differ there. Pieces keep the attributes and ids of their triangle.
    /// A triangle is not cut if a piece would have no area on the grid.
    ///
    /// For n triangles there are at most n + 1024 cuts and 1024 n + 2^22 comparisons; order_conflicts counts the
    /// remaining errors. Runs on one thread and takes up to 1000 bytes a triangle.
    pub const NEWELL: Self = Self(2);
}
pub const SHD_VISIBILITY_DEPTH: shd_visibility = shd_visibility::DEPTH;
pub const SHD_VISIBILITY_PAINTER: shd_visibility = shd_visibility::PAINTER;
pub const SHD_VISIBILITY_NEWELL: shd_visibility = shd_visibility::NEWELL;
names!(shd_visibility: DEPTH, PAINTER, NEWELL);

/// Colour of the samples that no draw covers.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_background(pub u32);
impl shd_background {
    /// clear_color
    pub const CLEAR: Self = Self(0);
    /// Radiance of the environment along the line of sight through the centre of the pixel, averaged over the pixel;
    /// a = 1. No effect with SHD_RENDER_LOAD.
    pub const ENVIRONMENT: Self = Self(1);
}
pub const SHD_BACKGROUND_CLEAR: shd_background = shd_background::CLEAR;
pub const SHD_BACKGROUND_ENVIRONMENT: shd_background = shd_background::ENVIRONMENT;
names!(shd_background: CLEAR, ENVIRONMENT);

/// Result of every call that can fail. A call that fails changes nothing.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_result(pub u32);
impl shd_result {
    /// done
    pub const OK: Self = Self(0);
    /// the text names desc, field, value and range
    pub const ERROR_INVALID_ARGUMENT: Self = Self(1);
    /// an allocation failed; nothing leaked, every object is as before
    pub const ERROR_OUT_OF_MEMORY: Self = Self(2);
    /// well formed, but this build or version does not offer it
    pub const ERROR_UNSUPPORTED: Self = Self(3);
    /// a file, colour space, display, view or plane does not exist
    pub const ERROR_NOT_FOUND: Self = Self(4);
    /// reading or writing a file failed
    pub const ERROR_IO: Self = Self(5);
    /// a file is damaged, or its content does not have the claimed format
    pub const ERROR_CORRUPT: Self = Self(6);
    /// a budget that the caller set (pixels, bytes, time) would be exceeded
    pub const ERROR_LIMIT: Self = Self(7);
    /// the host's progress callback requested cancellation
    pub const ERROR_CANCELLED: Self = Self(8);
    /// a host callback reported failure
    pub const ERROR_CALLBACK: Self = Self(9);
    /// a bug in shd or a library below it; please report the text
    pub const ERROR_INTERNAL: Self = Self(10);
}
pub const SHD_OK: shd_result = shd_result::OK;
pub const SHD_ERROR_INVALID_ARGUMENT: shd_result = shd_result::ERROR_INVALID_ARGUMENT;
pub const SHD_ERROR_OUT_OF_MEMORY: shd_result = shd_result::ERROR_OUT_OF_MEMORY;
pub const SHD_ERROR_UNSUPPORTED: shd_result = shd_result::ERROR_UNSUPPORTED;
pub const SHD_ERROR_NOT_FOUND: shd_result = shd_result::ERROR_NOT_FOUND;
pub const SHD_ERROR_IO: shd_result = shd_result::ERROR_IO;
pub const SHD_ERROR_CORRUPT: shd_result = shd_result::ERROR_CORRUPT;
pub const SHD_ERROR_LIMIT: shd_result = shd_result::ERROR_LIMIT;
pub const SHD_ERROR_CANCELLED: shd_result = shd_result::ERROR_CANCELLED;
pub const SHD_ERROR_CALLBACK: shd_result = shd_result::ERROR_CALLBACK;
pub const SHD_ERROR_INTERNAL: shd_result = shd_result::ERROR_INTERNAL;
names!(shd_result: OK, ERROR_INVALID_ARGUMENT, ERROR_OUT_OF_MEMORY, ERROR_UNSUPPORTED, ERROR_NOT_FOUND, ERROR_IO, ERROR_CORRUPT, ERROR_LIMIT, ERROR_CANCELLED, ERROR_CALLBACK, ERROR_INTERNAL);

/// Reconstruction and minification filter.
///
/// Filters that use mip levels read only level 0 of a texture without a mipmap. Ripmap and summed-area lookups are
/// refused if the texture does not have the table.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_filter(pub u32);
impl shd_filter {
    /// Bilinear on the two nearest mip levels, blended by the fraction of the level of detail (Williams 1983).
    pub const TRILINEAR: Self = Self(0);
    /// the texel of level 0 that contains (u, v)
    pub const NEAREST: Self = Self(1);
    /// the four texels of level 0 around (u, v)
    pub const BILINEAR: Self = Self(2);
    /// The 4 x 4 texels of level 0 around (u, v), weighted by the cubic `cubic` (Mitchell and Netravali 1988).
    pub const BICUBIC: Self = Self(3);
    /// the texel of the nearest mip level that contains (u, v)
    pub const NEAREST_MIP: Self = Self(4);
    /// bilinear on the nearest mip level
    pub const BILINEAR_MIP: Self = Self(5);
    /// Bilinear on the four nearest ripmap levels, which halve each axis on its own. Needs SHD_TABLE_RIPMAP.
    pub const RIPMAP: Self = Self(6);
    /// The average of the texels over `box`, where each texel is a square of constant value, from sums over rectangles
    /// (Crow 1984). Needs SHD_TABLE_SUMMED_AREA. Sides of a box are at least 1 texel, which makes magnification
    /// bilinear, and at most 2^22. Bias and clamps of the level of detail apply to log2 of a side; `lod` is a square of
    /// 2^lod texels. If a box touches a texel that is not finite, the result is NaN in its channel.
    pub const SUMMED_AREA: Self = Self(7);
    /// Trilinear probes of the footprint's shorter axis, along the longer one (McCormack et al. 1999).
    pub const ANISOTROPIC: Self = Self(8);
    /// The texels inside the footprint's ellipse, weighted by exp(-2 r^2) - exp(-2) with r from 0 at its centre to 1 on
    /// its edge (Greene and Heckbert 1986), on the mip level on which the footprint's shorter half axis b is 1..2
    /// texels, b >= a / max_anisotropy; on the finest level, b = max(b, 1). Half axes: sqrt(0.84^2 a^2 + c) and
    /// sqrt(0.84^2 b^2 + c) in texels of level l, c = 1 - 0.6127 (1 - 4^-l): Heckbert's reconstruction filter without
    /// the averaging of level l. Bilinear where a is at most one texel of level 0; blended from bilinear to EWA where a
    /// is one to two texels. `lod` is a circle. Reads at most 16 (max_anisotropy + 1) texels, 4 times as many in 3D.
    pub const EWA: Self = Self(9);
    /// An unbiased estimate of the filter that `stochastic_filter` names, from what shd_stochastic picks at random.
    pub const STOCHASTIC: Self = Self(10);
    /// The average of the bilinear reconstruction over the footprint's parallelogram, computed in double: the ground
    /// truth. It uses the finest level on which the parallelogram covers at most 16 / tolerance^2 cells (2^10..2^24). If
    /// it covers more cells even on the coarsest level, it is shortened to this number. `lod` is a square of 2^lod
    /// texels, in 3D a box. docs/filter-exact.md has its definition on images of directions. Slow.
    pub const EXACT: Self = Self(11);
    /// The texels that contain (u, v) of the two nearest mip levels, blended by the fraction of the level of detail:
    /// VK_FILTER_NEAREST with VK_SAMPLER_MIPMAP_MODE_LINEAR, GL_NEAREST_MIPMAP_LINEAR, D3D's MIN_MAG_POINT_MIP_LINEAR.
    pub const NEAREST_MIP_LINEAR: Self = Self(12);
}
pub const SHD_FILTER_TRILINEAR: shd_filter = shd_filter::TRILINEAR;
pub const SHD_FILTER_NEAREST: shd_filter = shd_filter::NEAREST;
pub const SHD_FILTER_BILINEAR: shd_filter = shd_filter::BILINEAR;
pub const SHD_FILTER_BICUBIC: shd_filter = shd_filter::BICUBIC;
pub const SHD_FILTER_NEAREST_MIP: shd_filter = shd_filter::NEAREST_MIP;
pub const SHD_FILTER_BILINEAR_MIP: shd_filter = shd_filter::BILINEAR_MIP;
pub const SHD_FILTER_RIPMAP: shd_filter = shd_filter::RIPMAP;
pub const SHD_FILTER_SUMMED_AREA: shd_filter = shd_filter::SUMMED_AREA;
pub const SHD_FILTER_ANISOTROPIC: shd_filter = shd_filter::ANISOTROPIC;
pub const SHD_FILTER_EWA: shd_filter = shd_filter::EWA;
pub const SHD_FILTER_STOCHASTIC: shd_filter = shd_filter::STOCHASTIC;
pub const SHD_FILTER_EXACT: shd_filter = shd_filter::EXACT;
pub const SHD_FILTER_NEAREST_MIP_LINEAR: shd_filter = shd_filter::NEAREST_MIP_LINEAR;
names!(shd_filter: TRILINEAR, NEAREST, BILINEAR, BICUBIC, NEAREST_MIP, BILINEAR_MIP, RIPMAP, SUMMED_AREA, ANISOTROPIC, EWA, STOCHASTIC, EXACT, NEAREST_MIP_LINEAR);

/// Filter for magnification: where the level of detail of NEAREST_MIP, NEAREST_MIP_LINEAR, BILINEAR_MIP and TRILINEAR is
/// 0 or below, and where the footprint of all other filters is at most one texel long.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_magnification(pub u32);
impl shd_magnification {
    /// the default of the filter: nearest for NEAREST, NEAREST_MIP and
    /// NEAREST_MIP_LINEAR, bicubic for BICUBIC, bilinear for all others
    pub const DEFAULT: Self = Self(0);
    /// SHD_FILTER_NEAREST
    pub const NEAREST: Self = Self(1);
    /// SHD_FILTER_BILINEAR
    pub const BILINEAR: Self = Self(2);
    /// SHD_FILTER_BICUBIC
    pub const BICUBIC: Self = Self(3);
}
pub const SHD_MAGNIFICATION_DEFAULT: shd_magnification = shd_magnification::DEFAULT;
pub const SHD_MAGNIFICATION_NEAREST: shd_magnification = shd_magnification::NEAREST;
pub const SHD_MAGNIFICATION_BILINEAR: shd_magnification = shd_magnification::BILINEAR;
pub const SHD_MAGNIFICATION_BICUBIC: shd_magnification = shd_magnification::BICUBIC;
names!(shd_magnification: DEFAULT, NEAREST, BILINEAR, BICUBIC);

/// Cubic kernels by their (B, C) of Mitchell and Netravali, "Reconstruction Filters in Computer Graphics" (1988).
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_cubic(pub u32);
impl shd_cubic {
    /// (0, 1/2): interpolates, overshoots
    pub const CATMULL_ROM: Self = Self(0);
    /// (1, 0): smooths, never overshoots
    pub const B_SPLINE: Self = Self(1);
    /// (1/3, 1/3): in between
    pub const MITCHELL: Self = Self(2);
}
pub const SHD_CUBIC_CATMULL_ROM: shd_cubic = shd_cubic::CATMULL_ROM;
pub const SHD_CUBIC_B_SPLINE: shd_cubic = shd_cubic::B_SPLINE;
pub const SHD_CUBIC_MITCHELL: shd_cubic = shd_cubic::MITCHELL;
names!(shd_cubic: CATMULL_ROM, B_SPLINE, MITCHELL);

/// Weights of the probes of SHD_FILTER_ANISOTROPIC along the longer axis.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_probe_weights(pub u32);
impl shd_probe_weights {
    /// a box
    pub const EQUAL: Self = Self(0);
    /// exp(-2 x^2), x = -1..1 from end to end of the probes
    pub const GAUSSIAN: Self = Self(1);
}
pub const SHD_PROBE_WEIGHTS_EQUAL: shd_probe_weights = shd_probe_weights::EQUAL;
pub const SHD_PROBE_WEIGHTS_GAUSSIAN: shd_probe_weights = shd_probe_weights::GAUSSIAN;
names!(shd_probe_weights: EQUAL, GAUSSIAN);

/// Area that SHD_FILTER_SUMMED_AREA averages.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_box(pub u32);
impl shd_box {
    /// The bounding rectangle of the footprint's parallelogram: |dudx| + |dudy| by |dvdx| + |dvdy|.
    pub const BOUNDING: Self = Self(0);
    /// The average over the bounding rectangles of N equal parts of the parallelogram along its longer side a. If b is
    /// the other side in texels, N = ceil(|a| / max(|b|, 1)), at most max_anisotropy.
    pub const ORIENTED: Self = Self(1);
}
pub const SHD_BOX_BOUNDING: shd_box = shd_box::BOUNDING;
pub const SHD_BOX_ORIENTED: shd_box = shd_box::ORIENTED;
names!(shd_box: BOUNDING, ORIENTED);

/// Definition of the level of detail, the levels and the probes of NEAREST_MIP, NEAREST_MIP_LINEAR, BILINEAR_MIP,
/// TRILINEAR and ANISOTROPIC.
///
/// LEAST_ERROR differs from EXACT in RIPMAP as well, and in STOCHASTIC of these filters. All other filters are the same
/// in all profiles, because EWA, SUMMED_AREA and EXACT have the least error as they are.
///
/// Mean PSNR \[dB\] of five scenes under a box of one pixel and a tent of two: four photographs, then checker, noise and
/// zone plate. docs/filters.md has more rules and figures, measured by `SHD_BENCH_PHOTOGRAPHS=folder shd-bench
/// --benchmark_filter=^default/` (bench/README.md).
///
/// | filter | LEAST_ERROR | EXACT | OpenImageIO |
/// |---|---|---|---|
/// | BILINEAR_MIP | 41.0 41.2, 34.2 33.5 | 37.0 39.0, 31.9 33.1 | 34.5 36.3, 29.4 31.5 |
/// | TRILINEAR | 42.7 43.0, 36.3 35.1 | 37.5 40.1, 33.3 34.5 | 39.5 41.5, 34.1 34.7 |
/// | ANISOTROPIC (16) | 49.5 46.2, 43.4 37.6 | 46.1 46.6, 42.8 38.9 | 43.8 47.5, 38.1 39.0 |
/// | RIPMAP | 44.4 44.9, 37.7 36.2 | 40.5 43.8, 36.9 37.1 | |
///
/// Below, x and y are the columns of the matrix J of derivatives in base-level texels, a = max_anisotropy, and lambda is
/// the level of detail before bias and clamps.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_profile(pub u32);
impl shd_profile {
    /// The levels of least measured error, a little finer than the footprint. Let s1 >= s2 be the singular values of J,
    /// and rms(x, y) = sqrt((x^2 + y^2) / 2). lambda = log2(rms(s1, s2)) - 3/8. ANISOTROPIC: r = min(s1 / s2, a), lambda
    /// = log2(rms(s1 / r, s2)) - 1/8 - 1 / (4 r), and ceil(r - 1/8) probes along the longer axis. RIPMAP: log2 of the
    /// extent along each axis, less 3/8. The column `lod` of lookups is used as it is.
    pub const LEAST_ERROR: Self = Self(0);
    /// Vulkan 1.3 specification, "Image Operations": lambda = log2(max(|x|, |y|)). ANISOTROPIC: eta = min(longer /
    /// shorter, a) for the longer and the shorter one of x and y, lambda = log2(longer / eta), and ceil(eta) probes of
    /// equal weight at i / (ceil(eta) + 1) - 1/2 of the longer one. Fractions of levels and weights of bilinear lookups
    /// (BILINEAR's too) have 8 bits, as most desktop GPUs report in mipmapPrecisionBits and subTexelPrecisionBits.
    /// Weights of textures with a projection are not rounded.
    pub const VULKAN: Self = Self(1);
    /// Direct3D 11.3 functional specification, 7.18.10 and 7.18.11: lambda = log2(m), with m the major axis of J's
    /// ellipse, or the longer of x and y if they are parallel. ANISOTROPIC: r = min(m^2 / |det J|, a), lambda = log2(m /
    /// r), ceil(min(r, max(m, 1))) probes along m. The specification does not define the places and weights of probes;
    /// shd uses the places and weights of SHD_PROFILE_VULKAN. Fractions of levels and weights of bilinear lookups have
    /// 8 bits, as in SHD_PROFILE_VULKAN, and the nearest level is floor(lod + 1/2).
    pub const D3D11: Self = Self(2);
    /// OpenImageIO 2.4, TextureSystem with default options. The width w of the filter, in units of the texture, is the
    /// largest of |du/dx| .. |dv/dy| plus the larger blur. The coarser level is the first one on which w is at most one
    /// texel of the smaller side; the finer level is the next finer one. The weight of the coarser level is 2 w - 1,
    /// with w in texels of this level; NEAREST_MIP and BILINEAR_MIP use the coarser level. ANISOTROPIC: axes m >= n of
    /// the ellipse in units of the texture, lengthened by blur; where m > a n they become m' = (m + a n) / 2 and n' = m'
    /// / a. Levels by w = n. N = floor(2 m / n - 1) probes, at least 1 and at most one per half texel of level 0, at p
    /// (m - n), p = (2 k + 1 - N) / N, k = 0 to N - 1, of weight exp(-2 x^2), x = p m / (2 (m - n)). `width_x` and
    /// `width_y` scale the derivatives of u and of v, as swidth and twidth do.
    pub const OIIO: Self = Self(3);
    /// As LEAST_ERROR with lambda = log2(s1), log2(s1 / r) for ANISOTROPIC, and without the 3/8 of a level.
    pub const EXACT: Self = Self(4);
}
pub const SHD_PROFILE_LEAST_ERROR: shd_profile = shd_profile::LEAST_ERROR;
pub const SHD_PROFILE_VULKAN: shd_profile = shd_profile::VULKAN;
pub const SHD_PROFILE_D3D11: shd_profile = shd_profile::D3D11;
pub const SHD_PROFILE_OIIO: shd_profile = shd_profile::OIIO;
pub const SHD_PROFILE_EXACT: shd_profile = shd_profile::EXACT;
names!(shd_profile: LEAST_ERROR, VULKAN, D3D11, OIIO, EXACT);

/// Arithmetic of lookups. Each has the same bits on every SIMD target.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_precision(pub u32);
impl shd_precision {
    /// weights and sums are binary32 floats
    pub const FULL: Self = Self(0);
    /// Texels are blended in integers of 16 bits, with fractions of 15 bits. Values are within 2^-11 of
    /// SHD_PRECISION_FULL, an eighth of a step of 8 bits. Where all texels are equal, values have the same bits.
    ///
    /// Levels of detail are the same. In LEAST_ERROR and EXACT, ANISOTROPIC blends levels in a part of the way between
    /// them: it has the levels and probes of a level_blend of at most 9/32. Its values are within
    /// 2^-11 + 2^-22 (width + height) of SHD_PRECISION_FULL with that level_blend, for footprints of up to 4 textures.
    ///
    /// It applies to 2D textures of 8-bit unorm formats of one to four channels, the filters BILINEAR, BILINEAR_MIP,
    /// TRILINEAR and ANISOTROPIC with equal weights of the probes, and every wrap except SHD_WRAP_BORDER. All other
    /// lookups, derivatives of values, and shd_texture_explain() have SHD_PRECISION_FULL.
    ///
    /// Choose it for pictures of 8 bits. Keep SHD_PRECISION_FULL for measurements, and for values whose differences
    /// matter, such as heights and normals.
    pub const FAST: Self = Self(1);
}
pub const SHD_PRECISION_FULL: shd_precision = shd_precision::FULL;
pub const SHD_PRECISION_FAST: shd_precision = shd_precision::FAST;
names!(shd_precision: FULL, FAST);

/// Random choice of SHD_FILTER_STOCHASTIC. The expected value of each is the named filter F = sum of w_k t_k, with the
/// texels t_k and their weights w_k.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_stochastic(pub u32);
impl shd_stochastic {
    /// One texel, with its weight as the probability. Variance: sum of w_k (t_k - F)^2.
    pub const TEXEL: Self = Self(0);
    /// One of the two levels of TRILINEAR, or one probe of ANISOTROPIC and one of its levels; then the bilinear lookup
    /// b_i of its four texels, or eight in 3D. With the probabilities p_i the variance is sum of p_i (b_i - F)^2: the
    /// variance of one texel less the mean variance within a quad. Where the level of detail is at most 0, trilinear has
    /// none. Other filters are refused.
    pub const QUAD: Self = Self(1);
}
pub const SHD_STOCHASTIC_TEXEL: shd_stochastic = shd_stochastic::TEXEL;
pub const SHD_STOCHASTIC_QUAD: shd_stochastic = shd_stochastic::QUAD;
names!(shd_stochastic: TEXEL, QUAD);

/// Lookups where a tile of the texture is not in memory (shd/tile_cache.h). No effect for other textures.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_missing_tiles(pub u32);
impl shd_missing_tiles {
    /// load the tile; the result does not depend on the content of the cache
    pub const WAIT: Self = Self(0);
    /// Never load and wait for no callback: filter from the finest levels with resident tiles, and request missing ones
    /// (shd_tile_cache_load_requested()). A lookup that needs a missing tile of level l is done again with a level of
    /// detail of at least l + 1, and so on; BILINEAR and BICUBIC become BILINEAR_MIP, and NEAREST becomes NEAREST_MIP.
    /// If no tile of any level is resident, the result is 0. shd_texels has the column `coarser`.
    pub const COARSER: Self = Self(1);
}
pub const SHD_MISSING_TILES_WAIT: shd_missing_tiles = shd_missing_tiles::WAIT;
pub const SHD_MISSING_TILES_COARSER: shd_missing_tiles = shd_missing_tiles::COARSER;
names!(shd_missing_tiles: WAIT, COARSER);

/// Comparisons `z OP d`: of a depth z with the depth d of a sample in depth tests, or of a reference z with a texel d in
/// comparison lookups (shd_sampler_desc.compares). If z or d is NaN, every comparison except ALWAYS is false.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_compare(pub u32);
impl shd_compare {
    /// z \< d
    pub const LESS: Self = Self(0);
    /// z \<= d
    pub const LESS_EQUAL: Self = Self(1);
    /// z = d
    pub const EQUAL: Self = Self(2);
    /// z >= d
    pub const GREATER_EQUAL: Self = Self(3);
    /// z > d, for depth that decreases with the distance (clear_depth 0)
    pub const GREATER: Self = Self(4);
    /// z \< d or z > d
    pub const NOT_EQUAL: Self = Self(5);
    /// true
    pub const ALWAYS: Self = Self(6);
    /// false
    pub const NEVER: Self = Self(7);
}
pub const SHD_COMPARE_LESS: shd_compare = shd_compare::LESS;
pub const SHD_COMPARE_LESS_EQUAL: shd_compare = shd_compare::LESS_EQUAL;
pub const SHD_COMPARE_EQUAL: shd_compare = shd_compare::EQUAL;
pub const SHD_COMPARE_GREATER_EQUAL: shd_compare = shd_compare::GREATER_EQUAL;
pub const SHD_COMPARE_GREATER: shd_compare = shd_compare::GREATER;
pub const SHD_COMPARE_NOT_EQUAL: shd_compare = shd_compare::NOT_EQUAL;
pub const SHD_COMPARE_ALWAYS: shd_compare = shd_compare::ALWAYS;
pub const SHD_COMPARE_NEVER: shd_compare = shd_compare::NEVER;
names!(shd_compare: LESS, LESS_EQUAL, EQUAL, GREATER_EQUAL, GREATER, NOT_EQUAL, ALWAYS, NEVER);

/// Options of a load; combine with |.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_scene_flag(pub u32);
impl shd_scene_flag {
    pub const NONE: Self = Self(0);
    /// a texture that cannot be read makes the load fail
    pub const REQUIRE_TEXTURES: Self = Self(1);
    /// textures have the filters of shd_scene_desc.sampler, not those of the file
    pub const HOST_FILTERS: Self = Self(2);
    /// reads the model in this process: faster start, and the file must be trusted
    pub const IN_PROCESS: Self = Self(4);
    /// names of the model may leave its folder: by `..`, absolute paths and links
    pub const ANY_FOLDER: Self = Self(8);
}
pub const SHD_SCENE_NONE: shd_scene_flag = shd_scene_flag::NONE;
pub const SHD_SCENE_REQUIRE_TEXTURES: shd_scene_flag = shd_scene_flag::REQUIRE_TEXTURES;
pub const SHD_SCENE_HOST_FILTERS: shd_scene_flag = shd_scene_flag::HOST_FILTERS;
pub const SHD_SCENE_IN_PROCESS: shd_scene_flag = shd_scene_flag::IN_PROCESS;
pub const SHD_SCENE_ANY_FOLDER: shd_scene_flag = shd_scene_flag::ANY_FOLDER;
flags!(shd_scene_flag);

/// Kinds of parts that have names.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_scene_part(pub u32);
impl shd_scene_part {
    pub const MESH: Self = Self(0);
    pub const MATERIAL: Self = Self(1);
    /// the path of its file
    pub const TEXTURE: Self = Self(2);
    pub const LIGHT: Self = Self(3);
    pub const CAMERA: Self = Self(4);
    pub const ANIMATION: Self = Self(5);
}
pub const SHD_SCENE_PART_MESH: shd_scene_part = shd_scene_part::MESH;
pub const SHD_SCENE_PART_MATERIAL: shd_scene_part = shd_scene_part::MATERIAL;
pub const SHD_SCENE_PART_TEXTURE: shd_scene_part = shd_scene_part::TEXTURE;
pub const SHD_SCENE_PART_LIGHT: shd_scene_part = shd_scene_part::LIGHT;
pub const SHD_SCENE_PART_CAMERA: shd_scene_part = shd_scene_part::CAMERA;
pub const SHD_SCENE_PART_ANIMATION: shd_scene_part = shd_scene_part::ANIMATION;
names!(shd_scene_part: MESH, MATERIAL, TEXTURE, LIGHT, CAMERA, ANIMATION);

/// Computation of visibility from depths.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_shadow_filter(pub u32);
impl shd_shadow_filter {
    /// the nearest texel, 0 or 1
    pub const HARD: Self = Self(0);
    /// The mean of n x n bilinear comparisons a texel apart (Reeves, Salesin and Cook, "Rendering Antialiased Shadows
    /// with Depth Maps", 1987). It varies continuously. Reads (n + 1)^2 texels, n = taps.
    pub const PCF: Self = Self(1);
    /// Chebyshev's bound of the distribution of depths in n x n texels, n = taps, interpolated from four neighbours
    /// (Donnelly and Lauritzen, "Variance Shadow Maps", 2006).
    pub const VARIANCE: Self = Self(2);
    /// Chebyshev's bound over a square of edge length filter_size around the point, from a summed-area table (Lauritzen,
    /// GPU Gems 3, 2007, 8).
    pub const SUMMED_AREA_VARIANCE: Self = Self(3);
    /// Penumbras that widen with the distance to the blockers (Fernando, "Percentage-Closer Soft Shadows", 2005): the
    /// mean depth of blockers from n x n texels, then the mean of n x n bilinear comparisons over the width of the
    /// penumbra, n = taps. Only blockers that a ray from the point to the light meets determine the width, if there are
    /// any (Guennebaud, Barthe and Paulin, "Real-Time Soft Shadow Mapping by Backprojection", 2006). Reads 5 n^2 texels
    /// for any width; in wide penumbras they are not adjacent. The pattern of the texels is shifted at each point
    /// (Cranley and Patterson, 1976) by a hash of the bits of its position, so penumbras have fine noise, less with more
    /// taps. Equal positions have equal patterns in every frame, tile and batch.
    pub const PCSS: Self = Self(4);
}
pub const SHD_SHADOW_FILTER_HARD: shd_shadow_filter = shd_shadow_filter::HARD;
pub const SHD_SHADOW_FILTER_PCF: shd_shadow_filter = shd_shadow_filter::PCF;
pub const SHD_SHADOW_FILTER_VARIANCE: shd_shadow_filter = shd_shadow_filter::VARIANCE;
pub const SHD_SHADOW_FILTER_SUMMED_AREA_VARIANCE: shd_shadow_filter = shd_shadow_filter::SUMMED_AREA_VARIANCE;
pub const SHD_SHADOW_FILTER_PCSS: shd_shadow_filter = shd_shadow_filter::PCSS;
names!(shd_shadow_filter: HARD, PCF, VARIANCE, SUMMED_AREA_VARIANCE, PCSS);

/// Kinds of shapes.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_shape(pub u32);
impl shd_shape {
    /// uses `radius`
    pub const SPHERE: Self = Self(0);
    /// uses `size`
    pub const BOX: Self = Self(1);
    /// a rectangle, size\[0\] by size\[2\]
    pub const PLANE: Self = Self(2);
    /// `radius` of the circle in the middle of the tube, `tube_radius`
    pub const TORUS: Self = Self(3);
    /// The Utah teapot: 32 bicubic Bezier patches by Martin Newell (1975), with the bottom that Frank Crow added ("The
    /// Origins of the Teapot", IEEE Computer Graphics and Applications 7(1), 1987). The body with its bottom, the lid,
    /// the handle and the spout are separate open surfaces that meet or intersect.
    pub const TEAPOT: Self = Self(4);
}
pub const SHD_SHAPE_SPHERE: shd_shape = shd_shape::SPHERE;
pub const SHD_SHAPE_BOX: shd_shape = shd_shape::BOX;
pub const SHD_SHAPE_PLANE: shd_shape = shd_shape::PLANE;
pub const SHD_SHAPE_TORUS: shd_shape = shd_shape::TORUS;
pub const SHD_SHAPE_TEAPOT: shd_shape = shd_shape::TEAPOT;
names!(shd_shape: SPHERE, BOX, PLANE, TORUS, TEAPOT);

/// Coefficient of a material that a slot feeds.
///
/// The value of the slot multiplies the constant of the same name in shd_material_desc, if there is one. Colours have
/// three channels, scalars one.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_slot_target(pub u32);
impl shd_slot_target {
    /// colour k_d or base colour; the fourth channel multiplies opacity
    pub const DIFFUSE: Self = Self(0);
    /// colour k_a
    pub const AMBIENT: Self = Self(1);
    /// colour k_s
    pub const SPECULAR: Self = Self(2);
    /// scalar p
    pub const EXPONENT: Self = Self(3);
    /// scalar
    pub const OPACITY: Self = Self(4);
    /// colour
    pub const EMISSION: Self = Self(5);
    /// scalar
    pub const METALLIC: Self = Self(6);
    /// scalar
    pub const ROUGHNESS: Self = Self(7);
    /// scalar o: ambient light times 1 + occlusion_strength (o - 1)
    pub const OCCLUSION: Self = Self(8);
    /// tangent-space normal in shd_material_desc.normal_encoding
    pub const NORMAL: Self = Self(9);
    /// scalar height, for bumps and parallax; takes 2D textures only
    pub const HEIGHT: Self = Self(10);
    /// colour by the direction of the normal in view; takes 2D textures only
    pub const MATCAP: Self = Self(11);
    /// scalar: mixed moment of slopes; read with SHD_NORMAL_ENCODING_MOMENTS and
    /// SHD_SLOT_NORMAL only. A constant slot gives slopes without covariance
    pub const NORMAL_MIXED: Self = Self(12);
    /// scalar: strength of the clear coat, clamped to 0..1
    pub const CLEARCOAT: Self = Self(13);
    /// scalar: roughness of the clear coat
    pub const CLEARCOAT_ROUGHNESS: Self = Self(14);
    /// tangent-space normal of the clear coat, SHD_NORMAL_ENCODING_XYZ with z > 0
    pub const CLEARCOAT_NORMAL: Self = Self(15);
    pub const TINT: Self = Self(16);
}
pub const SHD_SLOT_DIFFUSE: shd_slot_target = shd_slot_target::DIFFUSE;
pub const SHD_SLOT_AMBIENT: shd_slot_target = shd_slot_target::AMBIENT;
pub const SHD_SLOT_SPECULAR: shd_slot_target = shd_slot_target::SPECULAR;
pub const SHD_SLOT_EXPONENT: shd_slot_target = shd_slot_target::EXPONENT;
pub const SHD_SLOT_OPACITY: shd_slot_target = shd_slot_target::OPACITY;
pub const SHD_SLOT_EMISSION: shd_slot_target = shd_slot_target::EMISSION;
pub const SHD_SLOT_METALLIC: shd_slot_target = shd_slot_target::METALLIC;
pub const SHD_SLOT_ROUGHNESS: shd_slot_target = shd_slot_target::ROUGHNESS;
pub const SHD_SLOT_OCCLUSION: shd_slot_target = shd_slot_target::OCCLUSION;
pub const SHD_SLOT_NORMAL: shd_slot_target = shd_slot_target::NORMAL;
pub const SHD_SLOT_HEIGHT: shd_slot_target = shd_slot_target::HEIGHT;
pub const SHD_SLOT_MATCAP: shd_slot_target = shd_slot_target::MATCAP;
pub const SHD_SLOT_NORMAL_MIXED: shd_slot_target = shd_slot_target::NORMAL_MIXED;
pub const SHD_SLOT_CLEARCOAT: shd_slot_target = shd_slot_target::CLEARCOAT;
pub const SHD_SLOT_CLEARCOAT_ROUGHNESS: shd_slot_target = shd_slot_target::CLEARCOAT_ROUGHNESS;
pub const SHD_SLOT_CLEARCOAT_NORMAL: shd_slot_target = shd_slot_target::CLEARCOAT_NORMAL;
pub const SHD_SLOT_TINT: shd_slot_target = shd_slot_target::TINT;
names!(shd_slot_target: DIFFUSE, AMBIENT, SPECULAR, EXPONENT, OPACITY, EMISSION, METALLIC, ROUGHNESS, OCCLUSION, NORMAL, HEIGHT, MATCAP, NORMAL_MIXED, CLEARCOAT, CLEARCOAT_ROUGHNESS, CLEARCOAT_NORMAL, TINT);

/// Source of the values of a slot.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_slot_source(pub u32);
impl shd_slot_source {
    /// 1; for the normal (0, 0, 1) in tangent space
    pub const CONSTANT: Self = Self(0);
    /// `texture` through `sampler`: 2D at uv, 3D at the place of a point. If it is SHD_TEXTURE_PREMULTIPLIED, the slots
    /// DIFFUSE and TINT have r / a, g / a, b / a of the lookup, or 0 where a is not positive; other slots read the
    /// lookup as it is.
    pub const TEXTURE: Self = Self(1);
    /// interpolated attributes of the mesh from `attribute` on; 1 for absent ones
    pub const VERTEX: Self = Self(2);
    /// `procedure`
    pub const PROCEDURE: Self = Self(3);
    /// colours of `solid` at the place of a point
    pub const SOLID: Self = Self(4);
}
pub const SHD_SLOT_SOURCE_CONSTANT: shd_slot_source = shd_slot_source::CONSTANT;
pub const SHD_SLOT_SOURCE_TEXTURE: shd_slot_source = shd_slot_source::TEXTURE;
pub const SHD_SLOT_SOURCE_VERTEX: shd_slot_source = shd_slot_source::VERTEX;
pub const SHD_SLOT_SOURCE_PROCEDURE: shd_slot_source = shd_slot_source::PROCEDURE;
pub const SHD_SLOT_SOURCE_SOLID: shd_slot_source = shd_slot_source::SOLID;
names!(shd_slot_source: CONSTANT, TEXTURE, VERTEX, PROCEDURE, SOLID);

/// Space of the places at which solid textures are evaluated.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_place_space(pub u32);
impl shd_place_space {
    /// Object space: the position in world space through the inverse of shd_draw.object_to_world. The pattern moves with
    /// the object. If the matrix has no inverse, the place is 0 before place_transform.
    pub const OBJECT: Self = Self(0);
    /// world space: objects move through the pattern
    pub const WORLD: Self = Self(1);
}
pub const SHD_PLACE_SPACE_OBJECT: shd_place_space = shd_place_space::OBJECT;
pub const SHD_PLACE_SPACE_WORLD: shd_place_space = shd_place_space::WORLD;
names!(shd_place_space: OBJECT, WORLD);

/// Pattern of a solid texture; the file's comment has the formulas.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_solid(pub u32);
impl shd_solid {
    /// two colours, across x
    pub const STRIPES: Self = Self(0);
    /// cubes of two colours
    pub const CHECKER: Self = Self(1);
    /// gradient noise on the integer lattice
    pub const PERLIN: Self = Self(2);
    /// interpolated random values
    pub const VALUE: Self = Self(3);
    /// gradient noise on a lattice of tetrahedra
    pub const SIMPLEX: Self = Self(4);
    /// distances to random points
    pub const WORLEY: Self = Self(5);
    /// waves across x, distorted by turbulence
    pub const MARBLE: Self = Self(6);
    /// rings around y, distorted by noise
    pub const WOOD: Self = Self(7);
}
pub const SHD_SOLID_STRIPES: shd_solid = shd_solid::STRIPES;
pub const SHD_SOLID_CHECKER: shd_solid = shd_solid::CHECKER;
pub const SHD_SOLID_PERLIN: shd_solid = shd_solid::PERLIN;
pub const SHD_SOLID_VALUE: shd_solid = shd_solid::VALUE;
pub const SHD_SOLID_SIMPLEX: shd_solid = shd_solid::SIMPLEX;
pub const SHD_SOLID_WORLEY: shd_solid = shd_solid::WORLEY;
pub const SHD_SOLID_MARBLE: shd_solid = shd_solid::MARBLE;
pub const SHD_SOLID_WOOD: shd_solid = shd_solid::WOOD;
names!(shd_solid: STRIPES, CHECKER, PERLIN, VALUE, SIMPLEX, WORLEY, MARBLE, WOOD);

/// Sum of octaves.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_solid_sum(pub u32);
impl shd_solid_sum {
    /// fractional Brownian motion: the sum of n
    pub const FBM: Self = Self(0);
    /// the sum of |n|
    pub const TURBULENCE: Self = Self(1);
}
pub const SHD_SOLID_SUM_FBM: shd_solid_sum = shd_solid_sum::FBM;
pub const SHD_SOLID_SUM_TURBULENCE: shd_solid_sum = shd_solid_sum::TURBULENCE;
names!(shd_solid_sum: FBM, TURBULENCE);

/// Gradients of SHD_SOLID_PERLIN.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_solid_gradients(pub u32);
impl shd_solid_gradients {
    /// twelve gradients, chosen by an integer hash; fastest
    pub const HASHED: Self = Self(0);
    /// 256 random unit vectors, through a permutation table
    pub const TABLE: Self = Self(1);
}
pub const SHD_SOLID_GRADIENTS_HASHED: shd_solid_gradients = shd_solid_gradients::HASHED;
pub const SHD_SOLID_GRADIENTS_TABLE: shd_solid_gradients = shd_solid_gradients::TABLE;
names!(shd_solid_gradients: HASHED, TABLE);

/// Weight of a lattice point at distance t along an axis.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_solid_fade(pub u32);
impl shd_solid_fade {
    /// second derivatives are continuous
    pub const QUINTIC: Self = Self(0);
    /// first derivatives are continuous
    pub const CUBIC: Self = Self(1);
}
pub const SHD_SOLID_FADE_QUINTIC: shd_solid_fade = shd_solid_fade::QUINTIC;
pub const SHD_SOLID_FADE_CUBIC: shd_solid_fade = shd_solid_fade::CUBIC;
names!(shd_solid_fade: QUINTIC, CUBIC);

/// Distance of SHD_SOLID_WORLEY.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_solid_distance(pub u32);
impl shd_solid_distance {
    /// to the nearest feature point
    pub const F1: Self = Self(0);
    /// to the second nearest feature point
    pub const F2: Self = Self(1);
    /// F2 - F1: 0 on the borders between the cells of the points
    pub const F2_F1: Self = Self(2);
}
pub const SHD_SOLID_DISTANCE_F1: shd_solid_distance = shd_solid_distance::F1;
pub const SHD_SOLID_DISTANCE_F2: shd_solid_distance = shd_solid_distance::F2;
pub const SHD_SOLID_DISTANCE_F2_F1: shd_solid_distance = shd_solid_distance::F2_F1;
names!(shd_solid_distance: F1, F2, F2_F1);

/// Number of parts of an edge.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_tessellation_mode(pub u32);
impl shd_tessellation_mode {
    /// `segments` for each edge: a triangle becomes segments^2
    pub const UNIFORM: Self = Self(0);
    /// The smallest number for which no part is longer than `edge_length`. It depends only on the positions of the
    /// edge's two ends, so triangles on both sides agree and no cracks open, even where uv or normals differ.
    pub const ADAPTIVE: Self = Self(1);
}
pub const SHD_TESSELLATION_MODE_UNIFORM: shd_tessellation_mode = shd_tessellation_mode::UNIFORM;
pub const SHD_TESSELLATION_MODE_ADAPTIVE: shd_tessellation_mode = shd_tessellation_mode::ADAPTIVE;
names!(shd_tessellation_mode: UNIFORM, ADAPTIVE);

/// Normals of a displaced mesh.
///
/// The mean of face normals, weighted by area. Vertices that shared position and normal before displacement share the
/// mean. Seams of uv therefore stay smooth, and creases stay sharp.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_displaced_normals(pub u32);
impl shd_displaced_normals {
    /// The previous normals, tilted by the slope of the heights: n - grad h, where grad h is the gradient on the faces
    /// around the vertex before displacement. Coarse triangles with smooth normals keep their smooth look.
    pub const TILTED: Self = Self(0);
    /// the previous normals
    pub const KEPT: Self = Self(1);
    /// the normals of the faces around the vertex after displacement
    pub const FACES: Self = Self(2);
}
pub const SHD_DISPLACED_NORMALS_TILTED: shd_displaced_normals = shd_displaced_normals::TILTED;
pub const SHD_DISPLACED_NORMALS_KEPT: shd_displaced_normals = shd_displaced_normals::KEPT;
pub const SHD_DISPLACED_NORMALS_FACES: shd_displaced_normals = shd_displaced_normals::FACES;
names!(shd_displaced_normals: TILTED, KEPT, FACES);

/// Prefiltered tables of a texture; combine with |.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_table(pub u32);
impl shd_table {
    /// the base level alone
    pub const NONE: Self = Self(0);
    /// levels max(1, floor(size / 2^l)) down to 1 x 1 (Williams 1983); 4/3 of the memory
    pub const MIPMAP: Self = Self(1);
    /// Levels max(1, floor(width / 2^i)) x max(1, floor(height / 2^j)) for every i and j. Takes at most 4 times the
    /// memory, including the mipmap, whose levels are shared. For textures of up to 2^26 texels.
    pub const RIPMAP: Self = Self(2);
    /// Sums over all rectangles at the origin (Crow 1984): (width + 1) x (height + 1) sums for every stored channel and
    /// layer. A sum takes 4 bytes for 8-bit unorm of up to 2^24 texels a layer, else 8, and 4 more where a binary16 or
    /// binary32 texel is not finite. Sums are exact for unorm. For sRGB and floats of magnitude up to m they are within
    /// 2^-51 width height m.
    pub const SUMMED_AREA: Self = Self(4);
}
pub const SHD_TABLE_NONE: shd_table = shd_table::NONE;
pub const SHD_TABLE_MIPMAP: shd_table = shd_table::MIPMAP;
pub const SHD_TABLE_RIPMAP: shd_table = shd_table::RIPMAP;
pub const SHD_TABLE_SUMMED_AREA: shd_table = shd_table::SUMMED_AREA;
flags!(shd_table);

/// Source of an output channel.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_channel(pub u32);
impl shd_channel {
    /// the channel at the same position; `fill` if the format lacks it
    pub const DEFAULT: Self = Self(0);
    pub const R: Self = Self(1);
    pub const G: Self = Self(2);
    pub const B: Self = Self(3);
    pub const A: Self = Self(4);
    /// the element of `fill` at the same position
    pub const FILL: Self = Self(5);
}
pub const SHD_CHANNEL_DEFAULT: shd_channel = shd_channel::DEFAULT;
pub const SHD_CHANNEL_R: shd_channel = shd_channel::R;
pub const SHD_CHANNEL_G: shd_channel = shd_channel::G;
pub const SHD_CHANNEL_B: shd_channel = shd_channel::B;
pub const SHD_CHANNEL_A: shd_channel = shd_channel::A;
pub const SHD_CHANNEL_FILL: shd_channel = shd_channel::FILL;
names!(shd_channel: DEFAULT, R, G, B, A, FILL);

/// Options of a texture; combine with |.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_texture_flag(pub u32);
impl shd_texture_flag {
    pub const NONE: Self = Self(0);
    /// Borrow `texels` until release instead of copying them. Only shd_texture_update() may change them. Requires one
    /// layer of packed rows, or packed slices of packed rows, a format without three channels or RGB9E5, and texels
    /// aligned to min(size of a texel, 4) bytes. SHD_TEXTURE_PADDING bytes behind the last texel must be readable,
    /// because lookups load whole vectors. Blocks need neither the alignment nor the padding, and must not change while
    /// the texture lives, because decoded blocks are kept between calls. Lookups give the same bits as for copied
    /// texels.
    pub const BORROW: Self = Self(1);
    /// With SHD_TEXTURE_BORROW: borrow the mip levels as well. Levels 0, 1, 2 ... then follow one another without gaps
    /// from `texels` on, as in a file that is mapped to memory; `levels` has their addresses. Not for 3D textures, and
    /// not for blocks. shd_texture_update() gives SHD_ERROR_UNSUPPORTED.
    pub const BORROW_LEVELS: Self = Self(2);
    /// The texels are premultiplied: r, g and b are multiplied by a. Lookups give such numbers, too. The slots
    /// SHD_SLOT_DIFFUSE and SHD_SLOT_TINT divide filtered r, g and b by filtered a (shd/slot.h).
    pub const PREMULTIPLIED: Self = Self(4);
}
pub const SHD_TEXTURE_NONE: shd_texture_flag = shd_texture_flag::NONE;
pub const SHD_TEXTURE_BORROW: shd_texture_flag = shd_texture_flag::BORROW;
pub const SHD_TEXTURE_BORROW_LEVELS: shd_texture_flag = shd_texture_flag::BORROW_LEVELS;
pub const SHD_TEXTURE_PREMULTIPLIED: shd_texture_flag = shd_texture_flag::PREMULTIPLIED;
flags!(shd_texture_flag);

/// File formats of textures.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_texture_file_kind(pub u32);
impl shd_texture_file_kind {
    pub const NONE: Self = Self(0);
    pub const KTX2: Self = Self(1);
    pub const DDS: Self = Self(2);
}
pub const SHD_TEXTURE_FILE_KIND_NONE: shd_texture_file_kind = shd_texture_file_kind::NONE;
pub const SHD_TEXTURE_FILE_KIND_KTX2: shd_texture_file_kind = shd_texture_file_kind::KTX2;
pub const SHD_TEXTURE_FILE_KIND_DDS: shd_texture_file_kind = shd_texture_file_kind::DDS;
names!(shd_texture_file_kind: NONE, KTX2, DDS);

/// Compression of the levels of a KTX2 file, around its blocks or pixels. The values are those of the file format.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_supercompression(pub u32);
impl shd_supercompression {
    pub const NONE: Self = Self(0);
    /// SHD_ERROR_UNSUPPORTED
    pub const BASIS_LZ: Self = Self(1);
    /// Zstandard (RFC 8878); optional when libshd_io is built
    pub const ZSTD: Self = Self(2);
    /// zlib (RFC 1950); optional when libshd_io is built
    pub const ZLIB: Self = Self(3);
}
pub const SHD_SUPERCOMPRESSION_NONE: shd_supercompression = shd_supercompression::NONE;
pub const SHD_SUPERCOMPRESSION_BASIS_LZ: shd_supercompression = shd_supercompression::BASIS_LZ;
pub const SHD_SUPERCOMPRESSION_ZSTD: shd_supercompression = shd_supercompression::ZSTD;
pub const SHD_SUPERCOMPRESSION_ZLIB: shd_supercompression = shd_supercompression::ZLIB;
names!(shd_supercompression: NONE, BASIS_LZ, ZSTD, ZLIB);

/// Properties of a texture file; combine with |.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_texture_file_flag(pub u32);
impl shd_texture_file_flag {
    pub const NONE: Self = Self(0);
    /// r, g, b are multiplied by alpha
    pub const PREMULTIPLIED: Self = Self(1);
    /// declared as an array, even of one layer
    pub const ARRAY: Self = Self(2);
    /// The first row is the bottom one (KTXorientation of KTX2). The texture has the rows in the order of the
    /// file, so the picture is upside down, unless SHD_LOAD_FLIP_V reverses it.
    pub const BOTTOM_UP: Self = Self(4);
    /// the first column is the right one (KTXorientation)
    pub const RIGHT_TO_LEFT: Self = Self(8);
}
pub const SHD_TEXTURE_FILE_NONE: shd_texture_file_flag = shd_texture_file_flag::NONE;
pub const SHD_TEXTURE_FILE_PREMULTIPLIED: shd_texture_file_flag = shd_texture_file_flag::PREMULTIPLIED;
pub const SHD_TEXTURE_FILE_ARRAY: shd_texture_file_flag = shd_texture_file_flag::ARRAY;
pub const SHD_TEXTURE_FILE_BOTTOM_UP: shd_texture_file_flag = shd_texture_file_flag::BOTTOM_UP;
pub const SHD_TEXTURE_FILE_RIGHT_TO_LEFT: shd_texture_file_flag = shd_texture_file_flag::RIGHT_TO_LEFT;
flags!(shd_texture_file_flag);

/// Depths of the near and far plane.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_depth_order(pub u32);
impl shd_depth_order {
    /// 0 near .. 1 far
    pub const FORWARD: Self = Self(0);
    /// 1 near .. 0 far, for draws that compare with SHD_COMPARE_GREATER and a clear_depth of 0.
    pub const REVERSED: Self = Self(1);
}
pub const SHD_DEPTH_ORDER_FORWARD: shd_depth_order = shd_depth_order::FORWARD;
pub const SHD_DEPTH_ORDER_REVERSED: shd_depth_order = shd_depth_order::REVERSED;
names!(shd_depth_order: FORWARD, REVERSED);

/// Interpolation of a varying from the three vertices of a triangle to a fragment.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_interpolation(pub u32);
impl shd_interpolation {
    /// Linear on the triangle itself.
    pub const PERSPECTIVE: Self = Self(0);
    /// Linear on the screen between the three projected vertices, also for clipped triangles. If a vertex cannot be
    /// projected (w \< 2^-100, or more than 2^60 pixels away), PERSPECTIVE is used.
    pub const AFFINE: Self = Self(1);
    /// The value of the triangle's first vertex, for all fragments and at every frequency.
    pub const FLAT: Self = Self(2);
}
pub const SHD_INTERPOLATION_PERSPECTIVE: shd_interpolation = shd_interpolation::PERSPECTIVE;
pub const SHD_INTERPOLATION_AFFINE: shd_interpolation = shd_interpolation::AFFINE;
pub const SHD_INTERPOLATION_FLAT: shd_interpolation = shd_interpolation::FLAT;
names!(shd_interpolation: PERSPECTIVE, AFFINE, FLAT);

/// Numbers of a file of voxels.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_raw_sample(pub u32);
impl shd_raw_sample {
    /// the format R8, RG8, RGB8 or RGBA8
    pub const U8: Self = Self(0);
    /// the format R16, RG16, RGB16 or RGBA16
    pub const U16: Self = Self(1);
    /// IEEE 754 binary16; the format R16F, RG16F, RGB16F or RGBA16F
    pub const F16: Self = Self(2);
    /// IEEE 754 binary32; the format R32F, RG32F, RGB32F or RGBA32F
    pub const F32: Self = Self(3);
    /// as F32: the numbers -128..127 themselves
    pub const I8: Self = Self(4);
    /// as F32: the numbers themselves, such as Hounsfield units
    pub const I16: Self = Self(5);
    /// as F32: the numbers themselves, rounded to the nearest binary32
    pub const U32: Self = Self(6);
    /// as F32: the numbers themselves, rounded to the nearest binary32
    pub const I32: Self = Self(7);
}
pub const SHD_RAW_SAMPLE_U8: shd_raw_sample = shd_raw_sample::U8;
pub const SHD_RAW_SAMPLE_U16: shd_raw_sample = shd_raw_sample::U16;
pub const SHD_RAW_SAMPLE_F16: shd_raw_sample = shd_raw_sample::F16;
pub const SHD_RAW_SAMPLE_F32: shd_raw_sample = shd_raw_sample::F32;
pub const SHD_RAW_SAMPLE_I8: shd_raw_sample = shd_raw_sample::I8;
pub const SHD_RAW_SAMPLE_I16: shd_raw_sample = shd_raw_sample::I16;
pub const SHD_RAW_SAMPLE_U32: shd_raw_sample = shd_raw_sample::U32;
pub const SHD_RAW_SAMPLE_I32: shd_raw_sample = shd_raw_sample::I32;
names!(shd_raw_sample: U8, U16, F16, F32, I8, I16, U32, I32);

/// Order of the bytes of a number.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_byte_order(pub u32);
impl shd_byte_order {
    /// lowest byte first
    pub const LITTLE: Self = Self(0);
    /// highest byte first
    pub const BIG: Self = Self(1);
}
pub const SHD_BYTE_ORDER_LITTLE: shd_byte_order = shd_byte_order::LITTLE;
pub const SHD_BYTE_ORDER_BIG: shd_byte_order = shd_byte_order::BIG;
names!(shd_byte_order: LITTLE, BIG);

/// Options of an OpenVDB load; combine with |.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_vdb_flag(pub u32);
impl shd_vdb_flag {
    pub const DEFAULT: Self = Self(0);
    /// sample the box of the desc instead of the bounds of the active voxels
    pub const BOX: Self = Self(1);
}
pub const SHD_VDB_DEFAULT: shd_vdb_flag = shd_vdb_flag::DEFAULT;
pub const SHD_VDB_BOX: shd_vdb_flag = shd_vdb_flag::BOX;
flags!(shd_vdb_flag);

/// Meaning of the numbers of a grid.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_vdb_class(pub u32);
impl shd_vdb_class {
    pub const UNKNOWN: Self = Self(0);
    /// signed distances to a surface \[world units\], negative inside
    pub const LEVEL_SET: Self = Self(1);
    /// densities, 0 outside
    pub const FOG_VOLUME: Self = Self(2);
}
pub const SHD_VDB_CLASS_UNKNOWN: shd_vdb_class = shd_vdb_class::UNKNOWN;
pub const SHD_VDB_CLASS_LEVEL_SET: shd_vdb_class = shd_vdb_class::LEVEL_SET;
pub const SHD_VDB_CLASS_FOG_VOLUME: shd_vdb_class = shd_vdb_class::FOG_VOLUME;
names!(shd_vdb_class: UNKNOWN, LEVEL_SET, FOG_VOLUME);

/// Texel that index i reads along an axis of n texels (Vulkan specification, "Wrapping Operation").
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct shd_wrap(pub u32);
impl shd_wrap {
    /// i mod n
    pub const REPEAT: Self = Self(0);
    /// clamp(i, 0, n - 1)
    pub const CLAMP: Self = Self(1);
    /// repeat with every second copy flipped
    pub const MIRROR: Self = Self(2);
    /// the border colour outside 0..n - 1
    pub const BORDER: Self = Self(3);
    /// one flipped copy below 0, clamped beyond: clamp(i \< 0 ? -1 - i : i, 0, n - 1)
    pub const MIRROR_ONCE: Self = Self(4);
}
pub const SHD_WRAP_REPEAT: shd_wrap = shd_wrap::REPEAT;
pub const SHD_WRAP_CLAMP: shd_wrap = shd_wrap::CLAMP;
pub const SHD_WRAP_MIRROR: shd_wrap = shd_wrap::MIRROR;
pub const SHD_WRAP_BORDER: shd_wrap = shd_wrap::BORDER;
pub const SHD_WRAP_MIRROR_ONCE: shd_wrap = shd_wrap::MIRROR_ONCE;
names!(shd_wrap: REPEAT, CLAMP, MIRROR, BORDER, MIRROR_ONCE);

/// Word of shd_level_rule bits.
pub type shd_level_rules = u32;

/// Word of shd_context_flag bits.
pub type shd_context_flags = u32;

/// Word of shd_edge bits.
pub type shd_edge_flags = u32;

/// Word of shd_environment_table bits.
pub type shd_environment_tables = u32;

/// Word of shd_aov bits.
pub type shd_aov_flags = u32;

/// Word of shd_file_format bits.
pub type shd_file_format_flags = u32;

/// Word of shd_load_flag bits.
pub type shd_load_flags = u32;

/// Word of shd_bitmap_flag bits.
pub type shd_bitmap_flags = u32;

/// Word of shd_material_flag bits.
pub type shd_material_flags = u32;

/// Word of shd_mesh_flag bits.
pub type shd_mesh_flags = u32;

/// Word of shd_draw_flag bits.
pub type shd_draw_flags = u32;

/// Word of shd_render_flag bits.
pub type shd_render_flags = u32;

/// Word of shd_scene_flag bits.
pub type shd_scene_flags = u32;

/// Word of shd_table bits.
pub type shd_table_flags = u32;

/// Word of shd_texture_flag bits.
pub type shd_texture_flags = u32;

/// Word of shd_texture_file_flag bits.
pub type shd_texture_file_flags = u32;

/// Word of shd_vdb_flag bits.
pub type shd_vdb_flags = u32;

/// An OpenColorIO config and the transforms built from it so far.
#[repr(C)]
pub struct shd_color {
    _data: [u8; 0],
    _marker: Opaque,
}

/// Owner of the allocator, executor and log that its objects use.
#[repr(C)]
pub struct shd_context {
    _data: [u8; 0],
    _marker: Opaque,
}

/// The triangles of draws, in a tree.
#[repr(C)]
pub struct shd_embree {
    _data: [u8; 0],
    _marker: Opaque,
}

/// Light from all directions.
#[repr(C)]
pub struct shd_environment {
    _data: [u8; 0],
    _marker: Opaque,
}

/// A handle of the extension's own type.
#[repr(C)]
pub struct shd_object {
    _data: [u8; 0],
    _marker: Opaque,
}

/// A set of planes with the same width and height.
#[repr(C)]
pub struct shd_framebuffer {
    _data: [u8; 0],
    _marker: Opaque,
}

/// The pixels of a file, without conversion.
#[repr(C)]
pub struct shd_bitmap {
    _data: [u8; 0],
    _marker: Opaque,
}

/// A source of light in world space.
#[repr(C)]
pub struct shd_light {
    _data: [u8; 0],
    _marker: Opaque,
}

/// Reflectance of a surface.
#[repr(C)]
pub struct shd_material {
    _data: [u8; 0],
    _marker: Opaque,
}

/// Vertices and triangles, in object space.
#[repr(C)]
pub struct shd_mesh {
    _data: [u8; 0],
    _marker: Opaque,
}

/// A filter with its settings, for any texture.
#[repr(C)]
pub struct shd_sampler {
    _data: [u8; 0],
    _marker: Opaque,
}

/// A model file in memory.
#[repr(C)]
pub struct shd_scene {
    _data: [u8; 0],
    _marker: Opaque,
}

/// Depths as seen from a light.
#[repr(C)]
pub struct shd_shadow {
    _data: [u8; 0],
    _marker: Opaque,
}

/// A two-dimensional texture, an array of them, a 3D texture or a texture of directions, with its tables.
#[repr(C)]
pub struct shd_texture {
    _data: [u8; 0],
    _marker: Opaque,
}

/// Memory for the tiles of textures.
#[repr(C)]
pub struct shd_tile_cache {
    _data: [u8; 0],
    _marker: Opaque,
}

/// A density field with its transfer function.
#[repr(C)]
pub struct shd_volume {
    _data: [u8; 0],
    _marker: Opaque,
}

/// Returns `size` > 0 bytes aligned to `alignment` (a power of two, at least 8), or NULL.
pub type shd_allocator_allocate_fn = Option<unsafe extern "C" fn(user_data: *mut c_void, size: usize, alignment: usize) -> *mut c_void>;

/// Frees memory that `allocate` returned. `size` and `alignment` are those of its allocation; `memory` is never
/// NULL.
pub type shd_allocator_free_fn = Option<unsafe extern "C" fn(user_data: *mut c_void, memory: *mut c_void, size: usize, alignment: usize)>;

/// One task of a parallel_for: `index` in \[0, count), `worker` in \[0, worker_count).
pub type shd_task_fn = Option<unsafe extern "C" fn(task_data: *mut c_void, index: u32, worker: u32)>;

/// Runs task(task_data, i, worker) once for every i in \[0, count), in any order and on any threads, and returns when
/// all are done. Tasks that run concurrently must have different values of `worker`. A result other than SHD_OK
/// makes the call of shd fail with SHD_ERROR_CALLBACK. Runs on the thread that called shd; must not throw or
/// longjmp; may call shd.
pub type shd_executor_parallel_for_fn = Option<unsafe extern "C" fn(user_data: *mut c_void, count: u32, task: shd_task_fn, task_data: *mut c_void) -> shd_result>;

/// Takes one line without newline. Any thread, calls may be concurrent; must not throw, longjmp or call shd.
pub type shd_log_write_fn = Option<unsafe extern "C" fn(user_data: *mut c_void, level: shd_log_level, message: *const c_char)>;

/// called with `body` by the thread that releases the last reference; must not throw
pub type shd_object_create_destroy_fn = Option<unsafe extern "C" fn(body: *mut c_void)>;

/// A fragment program: reads in->count rows and writes the same number of rows.
///
/// The framebuffer keeps all values, even NaN and infinity; shd_render_stats.nonfinite_fragments counts these.
pub type shd_fragment_fn = Option<unsafe extern "C" fn(r#in: *const shd_fragments, out: *mut shd_radiance, user_data: *mut c_void)>;

/// Fills every pixel of `out`, a packed RGBA32F image of the framebuffer's size, with display colour: encoded,
/// straight alpha, 0..1. Runs on the thread of the call that takes the shd_display; must not throw or longjmp. A
/// result other than SHD_OK, with its text from shd_report_error(), becomes the result of the call. NULL = none.
pub type shd_display_apply_fn = Option<unsafe extern "C" fn(user_data: *mut c_void, framebuffer: *const shd_framebuffer, out: *const shd_image) -> shd_result>;

/// A tracer of the host: sets blocked\[i\] to a value other than 0 if ray i meets an occluder. All start as 0.
///
/// Runs on any worker of the executor, and calls may be concurrent. It must not throw, longjmp or call shd.
pub type shd_trace_fn = Option<unsafe extern "C" fn(rays: *const shd_rays, blocked: *mut u32, user_data: *mut c_void)>;

/// Called once for each tile of the framebuffer in no particular order, also for tiles that the frame does not
/// change. In a frame of several passes (shd_render_desc.pass_triangles) this is in the last pass, and with
/// supersampling after the last block. A result other than SHD_OK, with its text from shd_report_error(), becomes
/// the result of the render; tiles that follow are skipped. NULL = none.
pub type shd_present_tile_fn = Option<unsafe extern "C" fn(user_data: *mut c_void, tile: *const shd_present_tile) -> shd_result>;

/// Called after each piece of the frame, with the finished fraction of the frame, (0, 1\]. Runs on any worker; calls
/// are never concurrent. Must not throw, longjmp or call shd. A result other than 0 cancels: the render returns
/// SHD_ERROR_CANCELLED and the framebuffer holds a part of the frame.
pub type shd_progress_report_fn = Option<unsafe extern "C" fn(user_data: *mut c_void, fraction: f32) -> i32>;

/// Answers the names of the model's files, in place of its folder: for archives and memory. The bytes are borrowed
/// until the load returns. SHD_ERROR_NOT_FOUND = no such file; any other result than SHD_OK ends the load. Runs on
/// the thread of the load; must not throw or longjmp. NULL = the folder of the model, or no file for a model in
/// memory.
pub type shd_scene_desc_find_fn = Option<unsafe extern "C" fn(user_data: *mut c_void, name: *const c_char, out_bytes: *mut *const c_void, out_size: *mut usize) -> shd_result>;

/// A function that gives the values of a slot: writes in->count values to each column.
/// @param out  packed columns, initially 1: three for colours, four for the diffuse slot, the tint and for normals, one
/// for scalars; the others are NULL
pub type shd_slot_fn = Option<unsafe extern "C" fn(r#in: *const shd_fragments, out: *const *mut f32, user_data: *mut c_void)>;

/// Writes the texels of tiles of one level of a layer, face or slice, in the format of the texture. Tiles of a
/// compressed texture are written as rows of blocks; the last blocks of a row or column may reach beyond the level. The
/// cache keeps them decoded. It is called without a lock, from any thread that looks texels up, and by several threads
/// at once, sometimes for the same tile, whose memory is then another. It may call shd: see the rules above.
/// @return  SHD_OK, or the reason of a failure. Then no tile of the call is kept, the lookup returns SHD_ERROR_CALLBACK,
/// or SHD_ERROR_CANCELLED for SHD_ERROR_CANCELLED, and the next lookup calls again
pub type shd_load_tiles_fn = Option<unsafe extern "C" fn(user_data: *mut c_void, tiles: *const shd_tile, count: usize) -> shd_result>;

/// called once, after the last `load`, when the texture is destroyed; may be
/// NULL. It is not called if shd_texture_create() fails
pub type shd_tile_source_release_fn = Option<unsafe extern "C" fn(user_data: *mut c_void)>;

/// A vertex program: reads and writes in->count rows.
///
/// Each row must depend on its own inputs alone. Otherwise the frame depends on the grouping of vertices.
pub type shd_vertex_fn = Option<unsafe extern "C" fn(r#in: *const shd_vertices, out: *mut shd_vertex_outputs, user_data: *mut c_void)>;

/// Statistics of a bake.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_bake_stats {
    /// set by shd_bake_stats_default()
    pub struct_size: u32,
    /// in all draws
    pub triangles: u64,
    /// without area in texture coordinates, rounded to 1/256 texel; not baked
    pub zero_area_triangles: u64,
    /// with a position or texture coordinate that is not finite; not baked
    pub nonfinite_triangles: u64,
    /// with a corner outside 0..1; the part inside is baked
    pub outside_triangles: u64,
    /// texels of SHD_TEXEL_STATE_CENTRE
    pub centre_texels: u64,
    /// texels of SHD_TEXEL_STATE_TOUCHED
    pub touched_texels: u64,
    /// texels of SHD_TEXEL_STATE_DILATED
    pub dilated_texels: u64,
    /// texels whose centre several triangles cover
    pub overlapping_texels: u64,
    /// shaded texels whose r, g, b or a is NaN or infinite (kept as written)
    pub nonfinite_texels: u64,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_bake_stats>() == 80);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_bake_stats>() == 8);
init!(shd_bake_stats, SHD_DESC_KIND_BAKE_STATS);

/// Options of a bake; nothing is required.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_bake_desc {
    /// set by shd_bake_desc_default()
    pub struct_size: u32,
    /// texture coordinates at which triangles lie: 0 = uv of the mesh, 1 = uv1; default 0
    pub uv_set: u32,
    /// Largest distance \[texels\], 0..1024, over which empty texels get a copy of the nearest shaded texel, in all planes
    /// except depth: seams then do not mix with the background when the texture is filtered. Distances are between
    /// centres; of equally near texels the one in the upper row is copied, then the left one. Default 0 = none.
    pub dilation: u32,
    /// reserved; 0
    pub flags: u32,
    /// shd_texel_state of width * height texels; default not wanted
    pub states: shd_u32_out,
    /// its struct_size is read; NULL = not wanted; all zero on failure
    pub stats: *mut shd_bake_stats,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_bake_desc>() == 40);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_bake_desc>() == 8);
init!(shd_bake_desc, SHD_DESC_KIND_BAKE_DESC);

/// The precision of implementations. Defaults are the rules of SHD_RULES_VULKAN.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_bounds_desc {
    /// set by shd_bounds_desc_default()
    pub struct_size: u32,
    /// at least one; default LENGTHS | ELLIPSE | VULKAN
    pub level_rules: shd_level_rules,
    /// fraction bits of a texel coordinate, 2..24; default 4
    pub subtexel_bits: u32,
    /// fraction bits of a level of detail, 1..24; default 4
    pub level_bits: u32,
    /// bits of the weights of texels, 1..24; 0 = exact; default 9
    pub weight_bits: u32,
    /// bits of the results of unorm formats, 1..24; 0 = not rounded; default 8
    pub result_bits: u32,
    /// error of a coordinate, relative to max(1, |u|), 0..1/16; default 2^-21
    pub coordinate_error: f32,
    /// relative error of the derivatives, 0..1/2; default 0
    pub derivative_error: f32,
    /// error of a level of detail before bias, 0..16; default 2^-10
    pub level_error: f32,
    /// error of a result relative to the largest texel, 0..1; default 2^-16
    pub relative_error: f32,
    /// error of a decoded sRGB texel \[codes\], 0..1; default 1/2
    pub srgb_error: f32,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_bounds_desc>() == 44);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_bounds_desc>() == 4);
init!(shd_bounds_desc, SHD_DESC_KIND_BOUNDS_DESC);

/// Source of the config. Zero is the default of each field. Strings are borrowed for the call.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_color_desc {
    /// set by shd_color_desc_default()
    pub struct_size: u32,
    /// precision of 8-bit images; default SHD_DISPLAY_PRECISION_BAKED
    pub display_precision: shd_display_precision,
    /// path of a config file, at most 64 MiB; NULL = the file named by the environment
    /// variable OCIO if it is set and not empty, else the built-in config. The config
    /// and the tables that it names must be regular files
    pub config_path: *const c_char,
    /// a config in memory (YAML); then config_path must be NULL and OCIO is not read
    pub config_text: *const c_char,
    /// colour space or role of framebuffers; NULL = the role scene_linear
    pub working_space: *const c_char,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_color_desc>() == 32);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_color_desc>() == 8);
init!(shd_color_desc, SHD_DESC_KIND_COLOR_DESC);

/// A display and one of its views: user_data of a shd_display whose callback is shd_color_apply_view(). Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_color_view {
    /// required; borrowed for the call that takes the shd_display
    pub color: *const shd_color,
    /// NULL = the config's default
    pub display: *const c_char,
    /// NULL = the display's default
    pub view: *const c_char,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_color_view>() == 24);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_color_view>() == 8);
init!(shd_color_view);

/// Column of floats that shd reads. Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_f32_in {
    /// first element; NULL = the column is absent
    pub data: *const f32,
    /// bytes between elements; 0 = packed
    pub stride: usize,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_f32_in>() == 16);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_f32_in>() == 8);
init!(shd_f32_in);

/// Column of floats that shd writes. Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_f32_out {
    /// first element; NULL = not wanted
    pub data: *mut f32,
    /// bytes between elements; 0 = packed
    pub stride: usize,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_f32_out>() == 16);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_f32_out>() == 8);
init!(shd_f32_out);

/// Column of 32-bit unsigned integers that shd reads. Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_u32_in {
    /// first element; NULL = the column is absent
    pub data: *const u32,
    /// bytes between elements; 0 = packed
    pub stride: usize,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_u32_in>() == 16);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_u32_in>() == 8);
init!(shd_u32_in);

/// Column of 32-bit unsigned integers that shd writes. Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_u32_out {
    /// first element; NULL = not wanted
    pub data: *mut u32,
    /// bytes between elements; 0 = packed
    pub stride: usize,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_u32_out>() == 16);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_u32_out>() == 8);
init!(shd_u32_out);

/// Column of 16-bit unsigned integers that shd reads. Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_u16_in {
    /// first element; NULL = the column is absent
    pub data: *const u16,
    /// bytes between elements; 0 = packed
    pub stride: usize,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_u16_in>() == 16);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_u16_in>() == 8);
init!(shd_u16_in);

/// Host memory. Frozen.
///
/// Set both callbacks or neither (then malloc and free). They run on any thread, workers of the executor included. They
/// must not throw, longjmp or call shd.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_allocator {
    /// Returns `size` > 0 bytes aligned to `alignment` (a power of two, at least 8), or NULL.
    pub allocate: shd_allocator_allocate_fn,
    /// Frees memory that `allocate` returned. `size` and `alignment` are those of its allocation; `memory` is never
    /// NULL.
    pub free: shd_allocator_free_fn,
    /// passed to both; borrowed until release of the context
    pub user_data: *mut c_void,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_allocator>() == 24);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_allocator>() == 8);
init!(shd_allocator);

/// Host job system. Frozen.
///
/// Zero = the built-in executor: oneTBB if the library was built with it, else the calling thread. The built-in executor
/// also uses the calling thread if no thread can be started, in contexts that a child process inherits by fork(), and in
/// all contexts of a child whose parent has used oneTBB.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_executor {
    /// Runs task(task_data, i, worker) once for every i in \[0, count), in any order and on any threads, and returns when
    /// all are done. Tasks that run concurrently must have different values of `worker`. A result other than SHD_OK
    /// makes the call of shd fail with SHD_ERROR_CALLBACK. Runs on the thread that called shd; must not throw or
    /// longjmp; may call shd.
    pub parallel_for: shd_executor_parallel_for_fn,
    /// borrowed until release of the context
    pub user_data: *mut c_void,
    /// `worker` is below this number, 1..1024; scratch memory is allocated for this number
    /// of workers
    pub worker_count: u32,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_executor>() == 24);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_executor>() == 8);
init!(shd_executor);

/// Host log. Frozen. Without a log shd writes nothing: it never uses stdout or stderr.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_log {
    /// Takes one line without newline. Any thread, calls may be concurrent; must not throw, longjmp or call shd.
    pub write: shd_log_write_fn,
    /// borrowed until release of the context
    pub user_data: *mut c_void,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_log>() == 16);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_log>() == 8);
init!(shd_log);

/// Options of a context. Zero is the default of each.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_context_desc {
    /// set by shd_context_desc_default()
    pub struct_size: u32,
    /// default 0
    pub flags: shd_context_flags,
    /// threads of the built-in executor, 0..1024, at most one per core; 1 = calling thread;
    /// default 0 = one per core
    pub worker_count: u32,
    /// default SHD_SIMD_BEST; SHD_ERROR_UNSUPPORTED if it cannot run here
    pub simd: shd_simd,
    /// default malloc and free; huge pages are requested for blocks of 8 MiB and more
    pub allocator: shd_allocator,
    /// default built-in
    pub executor: shd_executor,
    /// default none
    pub log: shd_log,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_context_desc>() == 80);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_context_desc>() == 8);
init!(shd_context_desc, SHD_DESC_KIND_CONTEXT_DESC);

/// Edges to find.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_edges_desc {
    /// set by shd_edges_desc_default()
    pub struct_size: u32,
    /// kinds to find; default SHD_EDGE_ALL
    pub edges: shd_edge_flags,
    /// Eye in object space, finite: the point (x, y, z) with w = 1, or with w = 0 the direction to an eye at infinity.
    /// Any other (x, y, z, w) except 0 is the point (x, y, z) / w. Default (0, 0, 1, 0).
    pub eye: [f32; 4],
    /// -1..1; default 0.5: edges of 60 degrees and sharper
    pub crease_cosine: f32,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_edges_desc>() == 28);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_edges_desc>() == 4);
init!(shd_edges_desc, SHD_DESC_KIND_EDGES_DESC);

/// Columns for edges; NULL = not wanted.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_edges {
    /// set by shd_edges_default()
    pub struct_size: u32,
    /// the two ends, in the direction of the first triangle
    pub vertex: [shd_u32_out; 2],
    /// the first triangle, and the other one; 0xffffffff for borders and non-manifold edges
    pub triangle: [shd_u32_out; 2],
    /// shd_edge bits, among the requested ones
    pub kinds: shd_u32_out,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_edges>() == 88);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_edges>() == 8);
init!(shd_edges, SHD_DESC_KIND_EDGES);

/// Image and tables of an environment. Required: image.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_environment_desc {
    /// set by shd_environment_desc_default()
    pub struct_size: u32,
    /// any but SHD_PROJECTION_NONE; default SHD_PROJECTION_LAT_LONG
    pub projection: shd_projection,
    /// Linear radiance, of any format and of 1 x 1 up to 2^26 pixels; borrowed for the call. One channel means grey; the
    /// fourth is ignored. CUBE takes the six faces on top of each other: height = 6 width. MIRROR_BALL, ANGULAR and
    /// OCTAHEDRAL are square. Channels that are negative or NaN count as 0, and those above 1e12 as 1e12;
    /// shd_environment_info counts them.
    pub image: *const shd_image,
    /// default SHD_IRRADIANCE_HARMONICS
    pub irradiance: shd_irradiance,
    /// default SHD_ENVIRONMENT_TABLE_ALL
    pub tables: shd_environment_tables,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_environment_desc>() == 24);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_environment_desc>() == 8);
init!(shd_environment_desc, SHD_DESC_KIND_ENVIRONMENT_DESC);

/// Properties of an environment.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_environment_info {
    /// set by shd_environment_info_default()
    pub struct_size: u32,
    /// as in its desc
    pub projection: shd_projection,
    /// as in its desc
    pub irradiance: shd_irradiance,
    /// as in its desc, with SHD_ENVIRONMENT_TABLE_RADIANCE if there are lobes
    pub tables: shd_environment_tables,
    /// texels a side of the largest map, 0 without SHD_ENVIRONMENT_TABLE_RADIANCE
    pub map_size: u32,
    /// mean radiance of all directions
    pub mean: [f32; 3],
    /// channels of the image that were negative, NaN or above 1e12
    pub replaced_count: u64,
    /// bytes of all tables
    pub byte_size: usize,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_environment_info>() == 48);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_environment_info>() == 8);
init!(shd_environment_info, SHD_DESC_KIND_ENVIRONMENT_INFO);

/// Lookups of an environment, as columns of `count` elements.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_environment_lookups {
    /// set by shd_environment_lookups_default()
    pub struct_size: u32,
    /// number of lookups; 0 is allowed
    pub count: usize,
    /// x, y, z, any length; required. 0, NaN and infinity count as +Z
    pub direction: [shd_f32_in; 3],
    /// Roughness of a GGX lobe around the direction, clamped to 0..1, NaN = 1: the mean of the radiance, weighted by
    /// D(h) n.l with n = v = direction (Karis, "Real Shading in Unreal Engine 4", 2013). Only for environments with
    /// SHD_ENVIRONMENT_TABLE_GGX.
    pub roughness: shd_f32_in,
    /// Exponent p of a Phong lobe around the direction r, clamped to 0..1e6, NaN = 0: the mean of the radiance, weighted
    /// by max(0, r.l)^p. Only for environments with SHD_ENVIRONMENT_TABLE_PHONG. Without roughness and exponent, lookups
    /// give the radiance itself.
    pub exponent: shd_f32_in,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_environment_lookups>() == 96);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_environment_lookups>() == 8);
init!(shd_environment_lookups, SHD_DESC_KIND_ENVIRONMENT_LOOKUPS);

/// Columns for irradiance or radiance; NULL = not wanted.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_environment_light {
    /// set by shd_environment_light_default()
    pub struct_size: u32,
    /// red, green, blue; irradiance, or radiance in the unit of the image
    pub rgb: [shd_f32_out; 3],
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_environment_light>() == 56);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_environment_light>() == 8);
init!(shd_environment_light, SHD_DESC_KIND_ENVIRONMENT_LIGHT);

/// A texel that a lookup reads. Grows with shd_explanation.tap_size.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_tap {
    /// layer of the array
    pub layer: u32,
    /// number of times the width was halved: the mip level, or the ripmap's level across
    pub level_u: u32,
    /// number of times the height was halved: the mip level, or the ripmap's level down
    pub level_v: u32,
    /// column, after wrapping
    pub x: u32,
    /// row, after wrapping
    pub y: u32,
    /// 1 = the border colour instead of the texel, else 0
    pub border: u32,
    /// share of the result; the weights of all taps sum to 1 up to rounding
    pub weight: f32,
    /// stored channels as the blends read them: unorm channels as integers, unless a wrap is
    /// SHD_WRAP_BORDER; comparison lookups: 0 or 1 in the channel of r
    pub value: [f32; 4],
    /// slice of a 3D texture, after wrapping; else 0
    pub z: u32,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_tap>() == 48);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_tap>() == 4);
init!(shd_tap);

/// A blend of two nodes of the tree. Grows with shd_explanation.blend_size.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_blend_step {
    /// node
    pub a: u32,
    /// node
    pub b: u32,
    /// weight of b
    pub s: f32,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_blend_step>() == 12);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_blend_step>() == 4);
init!(shd_blend_step);

/// An explanation, with the caller's memory for its tables.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_explanation {
    /// set by shd_explanation_default()
    pub struct_size: u32,
    /// \[tap_capacity\]; gets the first taps; NULL with a capacity of 0
    pub taps: *mut shd_tap,
    /// \[blend_capacity\]; gets the first blends; NULL with a capacity of 0
    pub blends: *mut shd_blend_step,
    /// bytes of the caller's shd_tap; set by shd_explanation_default()
    pub tap_size: u32,
    /// elements of `taps`
    pub tap_capacity: u32,
    /// written: taps of the lookup
    pub tap_count: u32,
    /// bytes of the caller's shd_blend_step; set by shd_explanation_default()
    pub blend_size: u32,
    /// elements of `blends`
    pub blend_capacity: u32,
    /// written: blends of the lookup; fewer than taps
    pub blend_count: u32,
    /// written: the filter that was used, after magnification
    pub filter: shd_filter,
    /// written: r, g, b, a of shd_texture_sample() with SHD_PRECISION_FULL
    pub result: [f32; 4],
    /// written: level of detail of trilinear in the profile, after bias and clamps
    pub lod: f32,
    /// written: factor from the blends' units to the result, by stored channel
    pub scale_high: [f32; 4],
    /// written: lower bits of that factor
    pub scale_low: [f32; 4],
    /// Written: the stored channel of r, g, b, a of the result; 4 = a constant: `fill`, or 0, 0, 1 of comparisons.
    pub channel_source: [u32; 4],
    /// Written: longer half axis of the footprint's ellipse, u and v in base-level texels, width and blur included;
    /// (2^lod, 0) if the lookup has a level of detail. At most 2^100 long. 3D textures: the first two components.
    pub longer_axis: [f32; 2],
    /// written: the shorter half axis, before any limit of anisotropy; 0 for 3D textures
    pub shorter_axis: [f32; 2],
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_explanation>() == 136);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_explanation>() == 8);
init!(shd_explanation, SHD_DESC_KIND_EXPLANATION);

/// Columns for derivatives per pixel step; NULL = not wanted.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_derivatives {
    /// set by shd_derivatives_default()
    pub struct_size: u32,
    /// du/dx
    pub dudx: shd_f32_out,
    /// dv/dx
    pub dvdx: shd_f32_out,
    /// du/dy
    pub dudy: shd_f32_out,
    /// dv/dy
    pub dvdy: shd_f32_out,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_derivatives>() == 72);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_derivatives>() == 8);
init!(shd_derivatives, SHD_DESC_KIND_DERIVATIVES);

/// Hits of rays with their differentials, as columns of `count` elements; x, y, z in one space.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_ray_differentials {
    /// set by shd_ray_differentials_default()
    pub struct_size: u32,
    /// number of hits; 0 is allowed
    pub count: usize,
    /// change of the surface point with u; required
    pub dpdu: [shd_f32_in; 3],
    /// change of the surface point with v; required
    pub dpdv: [shd_f32_in; 3],
    /// direction of the ray, any length; required
    pub direction: [shd_f32_in; 3],
    /// distance to the hit, in lengths of `direction`; absent = 0
    pub distance: shd_f32_in,
    /// change of the ray's origin per pixel step in x; absent = 0
    pub origin_dx: [shd_f32_in; 3],
    /// change of the ray's origin per pixel step in y; absent = 0
    pub origin_dy: [shd_f32_in; 3],
    /// change of `direction` per pixel step in x; absent = 0
    pub direction_dx: [shd_f32_in; 3],
    /// change of `direction` per pixel step in y; absent = 0
    pub direction_dy: [shd_f32_in; 3],
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_ray_differentials>() == 368);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_ray_differentials>() == 8);
init!(shd_ray_differentials, SHD_DESC_KIND_RAY_DIFFERENTIALS);

/// Hits of rays with their cones, as columns of `count` elements; x, y, z in one space.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_ray_cones {
    /// set by shd_ray_cones_default()
    pub struct_size: u32,
    /// number of hits; 0 is allowed
    pub count: usize,
    /// change of the surface point with u; required
    pub dpdu: [shd_f32_in; 3],
    /// change of the surface point with v; required
    pub dpdv: [shd_f32_in; 3],
    /// direction of the ray, any length; required
    pub direction: [shd_f32_in; 3],
    /// diameter of the cone at the hit, in the units of the points; required
    pub width: shd_f32_in,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_ray_cones>() == 176);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_ray_cones>() == 8);
init!(shd_ray_cones, SHD_DESC_KIND_RAY_CONES);

/// Points to shade, one row each, as packed columns of `count` elements; borrowed for the call.
///
/// A row is a visible fragment at Phong frequency, a vertex at Gouraud frequency, and a triangle's centroid at flat
/// frequency. For vertices and centroids x, y, depth and the derivatives are 0.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_fragments {
    /// size of the library's struct
    pub struct_size: u32,
    /// index into shd_render_desc.draws; the same for every row
    pub draw: u32,
    /// index into shd_draw.instances, 0 without instances; the same for every row
    pub instance: u32,
    /// shd_material_desc.varying_count
    pub varying_count: u32,
    /// number of `attribute` columns
    pub attribute_count: u32,
    /// rows
    pub count: usize,
    /// shd_draw.uniforms
    pub uniforms: *const c_void,
    /// Raster position, pixels from the left edge. It is the centre of the pixel, or the mean of the covered samples if
    /// there are several samples and the triangle does not cover the centre. With SHD_DRAW_SAMPLE_SHADING it is the
    /// position of the sample.
    pub x: *const f32,
    /// raster position, pixels from the top edge, as x
    pub y: *const f32,
    /// depth-buffer value, 0 near .. 1 far
    pub depth: *const f32,
    /// index of the triangle in its mesh
    pub triangle: *const u32,
    /// position, world space
    pub px: *const f32,
    /// position, world space
    pub py: *const f32,
    /// position, world space
    pub pz: *const f32,
    /// shading normal, world space, unit
    pub nx: *const f32,
    /// shading normal, world space, unit
    pub ny: *const f32,
    /// shading normal, world space, unit
    pub nz: *const f32,
    /// wo: towards the eye, world space, unit (0 at the eye itself)
    pub ox: *const f32,
    /// wo: towards the eye, world space, unit (0 at the eye itself)
    pub oy: *const f32,
    /// wo: towards the eye, world space, unit (0 at the eye itself)
    pub oz: *const f32,
    /// Tangent in world space, of any length, and handedness, interpolated from the mesh. If the mesh has no tangents:
    /// the unit tangent of the triangle, or 0 where its uv are degenerate. The bitangent tw (n x t) points to falling v.
    pub tx: *const f32,
    /// Tangent in world space, of any length, and handedness, interpolated from the mesh. If the mesh has no tangents:
    /// the unit tangent of the triangle, or 0 where its uv are degenerate. The bitangent tw (n x t) points to falling v.
    pub ty: *const f32,
    /// Tangent in world space, of any length, and handedness, interpolated from the mesh. If the mesh has no tangents:
    /// the unit tangent of the triangle, or 0 where its uv are degenerate. The bitangent tw (n x t) points to falling v.
    pub tz: *const f32,
    /// Tangent in world space, of any length, and handedness, interpolated from the mesh. If the mesh has no tangents:
    /// the unit tangent of the triangle, or 0 where its uv are degenerate. The bitangent tw (n x t) points to falling v.
    pub tw: *const f32,
    /// texture coordinates, perspective-correct
    pub u: *const f32,
    /// texture coordinates, perspective-correct
    pub v: *const f32,
    /// second set of texture coordinates; 0 if the mesh has none
    pub u1: *const f32,
    /// second set of texture coordinates; 0 if the mesh has none
    pub v1: *const f32,
    /// analytic derivatives of u, v along one pixel to the right
    pub dudx: *const f32,
    /// analytic derivatives of u, v along one pixel to the right
    pub dvdx: *const f32,
    /// analytic derivatives of u, v along one pixel down
    pub dudy: *const f32,
    /// analytic derivatives of u, v along one pixel down
    pub dvdy: *const f32,
    /// \[attribute_count\] columns of the mesh, interpolated; NULL for absent ones
    pub attribute: *const *const f32,
    /// \[varying_count\] columns of the vertex program, interpolated by shd_material_desc.interpolation. At Gouraud
    /// frequency they are the values of the vertex, at flat frequency the mean of the triangle's three vertices. FLAT
    /// varyings have the value of the first vertex at every frequency.
    pub varying: *const *const f32,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_fragments>() == 256);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_fragments>() == 8);
init!(shd_fragments);

/// Output of a program: scene-linear, premultiplied by a. r, g, b start as 0 and a as 1.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_radiance {
    /// size of the library's struct
    pub struct_size: u32,
    /// number of `target` elements: 3
    pub target_count: u32,
    /// packed columns of `count` elements
    pub r: *mut f32,
    /// packed columns of `count` elements
    pub g: *mut f32,
    /// packed columns of `count` elements
    pub b: *mut f32,
    /// packed columns of `count` elements
    pub a: *mut f32,
    /// starts as 0; any other value drops the row. NULL without SHD_MATERIAL_DISCARDS
    pub discard: *mut u32,
    /// \[target_count\] r, g, b, a of SHD_AOV_TARGET1, 2 and 3; start as 0. NULL for
    /// targets that the framebuffer lacks
    pub target: *const [*mut f32; 4],
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_radiance>() == 56);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_radiance>() == 8);
init!(shd_radiance);

/// Size and planes of a framebuffer. Required: width, height.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_framebuffer_desc {
    /// set by shd_framebuffer_desc_default()
    pub struct_size: u32,
    /// pixels, 1..16384
    pub width: u32,
    /// pixels, 1..16384
    pub height: u32,
    /// per pixel: 1, 2, 4, 8 or 16, at shd_sample_position(); default 1
    pub samples: u32,
    /// optional planes; default none
    pub aovs: shd_aov_flags,
    /// Storage of colour: SHD_FORMAT_RGBA32F, four planes; or interleaved SHD_FORMAT_RGBA16F, _RGBA8_SRGB or _RGBA8.
    /// Default SHD_FORMAT_RGBA32F. Targets are planes in any case. shd_render with SHD_RENDER_LOAD reads colour as it
    /// was rounded.
    pub color_format: shd_format,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_framebuffer_desc>() == 24);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_framebuffer_desc>() == 4);
init!(shd_framebuffer_desc, SHD_DESC_KIND_FRAMEBUFFER_DESC);

/// Size and planes of a framebuffer.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_framebuffer_info {
    /// set by shd_framebuffer_info_default()
    pub struct_size: u32,
    /// pixels
    pub width: u32,
    /// pixels
    pub height: u32,
    /// per pixel
    pub samples: u32,
    /// optional planes
    pub aovs: shd_aov_flags,
    /// storage of colour
    pub color_format: shd_format,
    /// bytes of all planes and pixels
    pub byte_size: usize,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_framebuffer_info>() == 32);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_framebuffer_info>() == 8);
init!(shd_framebuffer_info, SHD_DESC_KIND_FRAMEBUFFER_INFO);

/// A plane in place: no copy.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_plane_view {
    /// set by shd_plane_view_default()
    pub struct_size: u32,
    /// \[height\]\[row_stride / 4\]; NULL for planes of uint32_t
    pub f32: *const f32,
    /// \[height\]\[row_stride / 4\]; NULL for planes of floats
    pub u32: *const u32,
    /// bytes between rows
    pub row_stride: usize,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_plane_view>() == 32);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_plane_view>() == 8);
init!(shd_plane_view, SHD_DESC_KIND_PLANE_VIEW);

/// Conversion of linear colour for a display: a transform of libshd_color, or a function of the caller. Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_display {
    /// Fills every pixel of `out`, a packed RGBA32F image of the framebuffer's size, with display colour: encoded,
    /// straight alpha, 0..1. Runs on the thread of the call that takes the shd_display; must not throw or longjmp. A
    /// result other than SHD_OK, with its text from shd_report_error(), becomes the result of the call. NULL = none.
    pub apply: shd_display_apply_fn,
    /// borrowed for the call
    pub user_data: *mut c_void,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_display>() == 16);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_display>() == 8);
init!(shd_display);

/// An image in the caller's memory. Required: format, width, height, pixels.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_image {
    /// set by shd_image_default()
    pub struct_size: u32,
    /// storage of `pixels`
    pub format: shd_format,
    /// pixels, 1..65536
    pub width: u32,
    /// pixels, 1..65536
    pub height: u32,
    /// \[height\]\[width\], row 0 on top; borrowed for the call; blocks are
    /// \[ceil(height / 4)\]\[ceil(width / 4)\]
    pub pixels: *mut c_void,
    /// bytes between rows of pixels or blocks, at least the bytes of a row; 0 = packed
    pub row_stride: usize,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_image>() == 32);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_image>() == 8);
init!(shd_image, SHD_DESC_KIND_IMAGE);

/// Options and budgets of a load. A budget that would be exceeded is SHD_ERROR_LIMIT.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_load_desc {
    /// set by shd_load_desc_default()
    pub struct_size: u32,
    /// formats to accept; default 0 = SHD_FILE_FORMAT_DEFAULT
    pub formats: shd_file_format_flags,
    /// default none
    pub flags: shd_load_flags,
    /// default AUTO; other values override the file's declaration
    pub color_space: shd_color_encoding,
    /// tables of textures; default SHD_TABLE_MIPMAP
    pub tables: shd_table_flags,
    /// part of a multi-part EXR, page of a TIFF, frame of a GIF; default 0
    pub subimage: u32,
    /// size of the file; 0 = 2^30
    pub max_file_bytes: u64,
    /// width * height, of the data and of the display window, and the pixels of all
    /// levels with SHD_LOAD_FILE_LEVELS; 0 = 2^28
    pub max_pixels: u64,
    /// decoded, as RGBA, all levels; 0 = 2^32
    pub max_bytes: u64,
    /// decoded bytes per file byte, for more than 2^24 decoded; 0 = 4000
    pub max_ratio: f64,
    /// \[s\], 0 = 60; kills the child that decodes. With SHD_LOAD_IN_PROCESS it is
    /// checked between bands of rows. A worker that is stopped (SIGSTOP, a debugger)
    /// costs a load all of its time; when it has been silent for two seconds, the
    /// next load starts another one
    pub time_limit: f64,
    /// program that decodes, relative to the working directory at the call; NULL =
    /// shd-io-worker beside libshd_io or in its installed place; borrowed for the
    /// call
    pub worker_path: *const c_char,
    /// textures: the file is voxels of this layout; borrowed for the call; default
    /// NULL
    pub raw: *const shd_raw_desc,
    /// textures: slices of a 3D texture from the files of the desc, without a path;
    /// borrowed for the call; default NULL
    pub stack: *const shd_stack_desc,
    /// textures: grid and box of an OpenVDB file; borrowed for the call; default NULL
    /// = the first grid of float or double, if the content is OpenVDB
    pub vdb: *const shd_vdb_desc,
    /// textures: gets the contents of a KTX2 or DDS file; all zero on failure and for
    /// other files, and its struct_size is read; default NULL
    pub info: *mut shd_texture_file_info,
    /// textures: gets the properties of an OpenVDB grid; all zero on failure and for
    /// other files, and its struct_size is read; default NULL
    pub vdb_info: *mut shd_vdb_info,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_load_desc>() == 112);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_load_desc>() == 8);
init!(shd_load_desc, SHD_DESC_KIND_LOAD_DESC);

/// Format and properties of a loaded file.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_bitmap_info {
    /// set by shd_bitmap_info_default()
    pub struct_size: u32,
    /// SHD_FILE_FORMAT_ANY for a format without a bit of its own
    pub file_format: shd_file_format,
    /// in the file
    pub channels: u32,
    /// properties
    pub flags: shd_bitmap_flags,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_bitmap_info>() == 16);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_bitmap_info>() == 4);
init!(shd_bitmap_info, SHD_DESC_KIND_BITMAP_INFO);

/// Options of a save.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_save_desc {
    /// set by shd_save_desc_default()
    pub struct_size: u32,
    /// a framebuffer's colour: PNG 8 or 16, EXR 16 or 32, TIFF 8, 16 or 32;
    /// default 0 = 8 for PNG, 16 for EXR, 32 for TIFF. For images always 0
    pub bit_depth: u32,
    /// framebuffers in 8 and 16 bits: AUTO and SRGB apply the sRGB curve, LINEAR and
    /// DATA do not. Images: the tag of PNG and EXR; AUTO = by pixel format
    pub color_space: shd_color_encoding,
    /// a framebuffer's colour in 8 and 16 bits; default none
    pub dither: shd_dither,
    /// Replaces the sRGB curve of a framebuffer in 8 and 16 bits; see shd_color_apply_view() in shd/color.h. Default
    /// none.
    pub display: shd_display,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_save_desc>() == 32);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_save_desc>() == 8);
init!(shd_save_desc, SHD_DESC_KIND_SAVE_DESC);

/// Kind, intensity and placement of a light.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_light_desc {
    /// set by shd_light_desc_default()
    pub struct_size: u32,
    /// default SHD_LIGHT_KIND_POINT
    pub kind: shd_light_kind,
    /// I, scene-linear RGB, 0..1e12; default 1. Points and spots: E = 1 at distance r takes
    /// I = r^2
    pub intensity: [f32; 3],
    /// position of points, spots and the cookie of directional lights; world space, finite;
    /// default 0
    pub position: [f32; 3],
    /// directional lights and spots: direction of the light rays, world space, any length
    /// except 0; default (0, -1, 0)
    pub direction: [f32; 3],
    /// points and spots: distance from which E is 0 \[world units\]; default 0 = no limit. Lights
    /// with a finite range are culled beyond it
    pub range: f32,
    /// spots: half angle of the full cone \[rad\], 0..outer_angle; default 0
    pub inner_angle: f32,
    /// spots: half angle of the cone \[rad\], 0.001..pi/2, with a cookie up to 1.55; default
    /// pi/4
    pub outer_angle: f32,
    /// up direction of the cookie and of shadow maps, world space. Orthogonalised against
    /// `direction`; replaced by another direction if parallel to it. Default (0, 1, 0)
    pub up: [f32; 3],
    /// directional lights: width and height of the cookie \[world units\], above 0; default 1.
    /// The centre of the cookie lies on the ray from `position`; with wraps that repeat, the
    /// cookie tiles the plane
    pub extent: [f32; 2],
    /// Light cookie: a texture of colours that multiply E, as seen from the light. It covers the square around the outer
    /// cone of a spot, or a rectangle of size `extent` for a directional light. The fourth channel is ignored. Points
    /// and ambient lights have no cookie. NULL = none; retained.
    pub texture: *mut shd_texture,
    /// sampler of `texture`; NULL = bilinear, black outside; retained
    pub sampler: *mut shd_sampler,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_light_desc>() == 96);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_light_desc>() == 8);
init!(shd_light_desc, SHD_DESC_KIND_LIGHT_DESC);

/// Points to look up, as columns of `count` elements. Required: u, v. Absent columns are NULL.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_lookups {
    /// set by shd_lookups_default()
    pub struct_size: u32,
    /// number of lookups; 0 is allowed
    pub count: usize,
    /// normalised coordinate across; required
    pub u: shd_f32_in,
    /// normalised coordinate down; required
    pub v: shd_f32_in,
    /// du/dx per pixel step; absent = 0
    pub dudx: shd_f32_in,
    /// dv/dx; absent = 0
    pub dvdx: shd_f32_in,
    /// du/dy; absent = 0
    pub dudy: shd_f32_in,
    /// dv/dy; absent = 0
    pub dvdy: shd_f32_in,
    /// log2 of the footprint in base texels; replaces the derivatives, width and blur
    pub lod: shd_f32_in,
    /// layer of the array; absent = 0; numbers beyond the last layer mean the last layer
    pub layer: shd_u32_in,
    /// random bits of SHD_FILTER_STOCHASTIC; absent = hashed from u, v and, if read, w
    pub random: shd_u32_in,
    /// third coordinate: across the slices of a 3D texture, or of a direction; required by these
    /// textures, without effect for others
    pub w: shd_f32_in,
    /// dw/dx per pixel step, where w has effect; absent = 0
    pub dwdx: shd_f32_in,
    /// dw/dy; absent = 0
    pub dwdy: shd_f32_in,
    /// compared with texels by samplers with `compares`; absent = 0
    pub reference: shd_f32_in,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_lookups>() == 224);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_lookups>() == 8);
init!(shd_lookups, SHD_DESC_KIND_LOOKUPS);

/// Columns for the filtered values: linear, and premultiplied only if the texels are.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_texels {
    /// Set by shd_texels_default(). 0 is accepted for the layout of 0.1, so that `shd_texels texels = {0};` works.
    pub struct_size: u32,
    /// r, g, b, a after the texture's swizzle; NULL = not wanted
    pub channel: [shd_f32_out; 4],
    /// d/du and d/dv of the channels, with u and v normalised and the footprint held constant; NULL = not wanted.
    /// Available for BILINEAR, BICUBIC, BILINEAR_MIP, TRILINEAR, RIPMAP, ANISOTROPIC and EWA, and for a magnification
    /// filter in this list; other filters return SHD_ERROR_UNSUPPORTED. BILINEAR has kinks at texel centres; the result
    /// there is the derivative to the right. EWA has kinks where a texel enters the ellipse; the result there is the
    /// derivative of the weights. du, dv and dw of a texture of directions are the derivatives in the three components
    /// of the direction, not normalised, with the footprint held constant in the image.
    pub du: [shd_f32_out; 4],
    pub dv: [shd_f32_out; 4],
    /// written: lookups whose coordinates, derivatives or lod were not finite
    pub nonfinite_count: usize,
    /// d/dw of the channels of a 3D texture or of one of directions, as du; NULL = not wanted.
    /// 2D textures return SHD_ERROR_UNSUPPORTED
    pub dw: [shd_f32_out; 4],
    /// 0 for lookups that found all their tiles. With SHD_MISSING_TILES_COARSER, l + 1 if a tile of level l is missing
    /// and coarser levels were filtered instead. NULL = not wanted.
    pub coarser: shd_u32_out,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_texels>() == 288);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_texels>() == 8);
init!(shd_texels, SHD_DESC_KIND_TEXELS);

/// Columns for levels of detail; NULL = not wanted.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_levels {
    /// set by shd_levels_default()
    pub struct_size: u32,
    /// continuous level of trilinear in the sampler's profile, after bias and clamps
    pub lod: shd_f32_out,
    /// nearest mip level: ceil(lod + 1/2) - 1, or the profile's
    pub level: shd_u32_out,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_levels>() == 40);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_levels>() == 8);
init!(shd_levels, SHD_DESC_KIND_LEVELS);

/// Functions of the caller. Frozen.
///
/// A C++ exception that reaches shd becomes SHD_ERROR_CALLBACK. The frame is undefined if a program throws, longjmps or
/// changes the count.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_material_program {
    /// required for SHD_MODEL_PROGRAM, else NULL
    pub fragment: shd_fragment_fn,
    /// for any model; NULL = only the matrices of view and draw
    pub vertex: shd_vertex_fn,
    /// passed to both; borrowed until release
    pub user_data: *mut c_void,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_material_program>() == 24);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_material_program>() == 8);
init!(shd_material_program);

/// Model and coefficients, scene-linear RGB.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_material_desc {
    /// set by shd_material_desc_default()
    pub struct_size: u32,
    /// default SHD_MODEL_LAMBERT
    pub model: shd_model,
    /// shown instead of the model; default SHD_DEBUG_VIEW_NONE
    pub debug_view: shd_debug_view,
    /// default none
    pub flags: shd_material_flags,
    /// k_a, 0..1e6. Default -1 in all channels: k_a is ambient_share times the diffuse
    /// colour, k_d times its slot. SHD_SLOT_AMBIENT replaces the slot of the diffuse
    /// colour in this product
    pub ambient: [f32; 3],
    /// 0..1; default 1/16; used if ambient is -1. METALLIC_ROUGHNESS multiplies k_a by its
    /// base colour in any case, so k_a is ambient_share there
    pub ambient_share: f32,
    /// k_d or base colour, 0..1e6; default 0.8
    pub diffuse: [f32; 3],
    /// k_s, 0..1e6; default 0.5
    pub specular: [f32; 3],
    /// p, 0..1e6; default 64
    pub exponent: f32,
    /// 0..1; default 0
    pub metallic: f32,
    /// 0..1; default 0.5
    pub roughness: f32,
    /// index of refraction of GLASS, and of METALLIC_ROUGHNESS for the part that is not
    /// metal, 1..10;
    /// default 1.5
    pub ior: f32,
    /// 0..1e12; default 0, so a slot needs a larger value here
    pub emission: [f32; 3],
    /// opacity of models, 0..1; default 1
    pub opacity: f32,
    /// effect of SHD_SLOT_OCCLUSION, 0..1; default 1
    pub occlusion_strength: f32,
    /// \[slot_count\], all with the same struct_size, at most one for each target;
    /// borrowed for the call; coefficients without a slot are constant
    pub slots: *const shd_slot,
    /// default 0
    pub slot_count: u32,
    /// default SHD_NORMAL_ENCODING_XYZ
    pub normal_encoding: shd_normal_encoding,
    /// factor of x and y of mapped normals, -1e3..1e3; default 1
    pub normal_scale: f32,
    /// default SHD_BUMP_NONE
    pub bump: shd_bump,
    /// factor of heights, -1e6..1e6; default 1
    pub bump_scale: f32,
    /// Depth of height 0 below the surface \[world units\], 0..1e6; height 1 lies on the surface. At Phong frequency, all
    /// textures with the uv set of the height are looked up at the point where the line of sight meets the height field
    /// (parallax occlusion mapping, Tatarchuk 2006). The triangles do not move. Default 0 = off.
    pub parallax_depth: f32,
    /// maximum number of lookups of the height per fragment, 2..256; default 24
    pub parallax_steps: u32,
    /// warm colour of GOOCH, 0..1e6; default (0.4, 0.4, 0)
    pub warm: [f32; 3],
    /// cool colour of GOOCH, 0..1e6; default (0, 0, 0.4)
    pub cool: [f32; 3],
    /// share of k_d added to `warm`, 0..1; default 0.6
    pub warm_mix: f32,
    /// share of k_d added to `cool`, 0..1; default 0.2
    pub cool_mix: f32,
    /// steps of TOON, 1..256; default 3
    pub toon_steps: u32,
    /// default SHD_BLEND_OPAQUE
    pub blend: shd_blend,
    /// fragments with a smaller alpha are dropped, 0..1; default 0 = none
    pub alpha_cutoff: f32,
    /// default none
    pub program: shd_material_program,
    /// \[varying_count\]; borrowed for the call; NULL = all
    /// SHD_INTERPOLATION_PERSPECTIVE
    pub interpolation: *const shd_interpolation,
    /// varyings that program.vertex writes, 0..SHD_MAX_VARYINGS; 0 without
    /// program.vertex
    pub varying_count: usize,
    /// Strength c of a clear coat over METALLIC_ROUGHNESS, 0..1; default 0 = none. As KHR_materials_clearcoat of glTF,
    /// with its own roughness and normal n_c and F = 0.04 + 0.96 (1 - |n_c.v|)^5: the model times 1 - c F, plus the sum
    /// of E max(0, n_c.l) c F D V. Without SHD_SLOT_CLEARCOAT_NORMAL, n_c is the normal without normal maps and bumps.
    /// Ambient light and emission are not darkened. No effect on other models.
    pub clearcoat: f32,
    /// 0..1; default 0
    pub clearcoat_roughness: f32,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_material_desc>() == 224);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_material_desc>() == 8);
init!(shd_material_desc, SHD_DESC_KIND_MATERIAL_DESC);

/// Vertices and triangles of a mesh; copied. Required: vertex_count, position.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_mesh_desc {
    /// set by shd_mesh_desc_default()
    pub struct_size: u32,
    /// 0..2^28; 0 makes an empty mesh
    pub vertex_count: u32,
    /// x, y, z, object space; required unless vertex_count is 0
    pub position: [shd_f32_in; 3],
    /// x, y, z, object space, any length; all three or none; computed if absent
    pub normal: [shd_f32_in; 3],
    /// used when `normal` is absent; default SHD_NORMAL_WEIGHT_AREA
    pub normal_weight: shd_normal_weight,
    /// default none
    pub flags: shd_mesh_flags,
    /// x, y, z, object space, and handedness, +1 or -1; see tangents. All four or none; stored unchanged.
    pub tangent: [shd_f32_in; 4],
    /// u, v; both or none; 0 if absent
    pub uv: [shd_f32_in; 2],
    /// u, v of a second set; both or none; 0 if absent
    pub uv1: [shd_f32_in; 2],
    /// \[attribute_count\] columns for materials and programs, such as colours; any may be
    /// absent
    pub attributes: *const shd_f32_in,
    /// 0..SHD_MAX_ATTRIBUTES; default 0
    pub attribute_count: u32,
    /// default SHD_TOPOLOGY_TRIANGLES
    pub topology: shd_topology,
    /// Vertex numbers of the triangles in the order of `topology`; counter-clockwise = front. NULL = indices16; if that
    /// is NULL too, 0, 1, 2, ... In strips and fans the largest number (0xffffffff, or 0xffff in indices16) starts a new
    /// strip or fan.
    pub indices: shd_u32_in,
    /// 16-bit vertex numbers; at most one of indices and indices16 is set
    pub indices16: shd_u16_in,
    /// A multiple of 3 up to 3 * 2^28 for triangles, else up to 2^28 + 2. Without indices: 0 = vertex_count.
    pub index_count: usize,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_mesh_desc>() == 296);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_mesh_desc>() == 8);
init!(shd_mesh_desc, SHD_DESC_KIND_MESH_DESC);

/// Counts and bounds of a mesh.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_mesh_info {
    /// set by shd_mesh_info_default()
    pub struct_size: u32,
    /// including the vertices that SHD_MESH_TANGENTS added
    pub vertex_count: u32,
    /// number of separate triangles, also for strips and fans
    pub triangle_count: u32,
    /// bound of the finite positions; 0 if there are none
    pub bounds_min: [f32; 3],
    /// bound of the finite positions; 0 if there are none
    pub bounds_max: [f32; 3],
    /// vertices with a position that is not finite
    pub nonfinite_count: u32,
    /// vertices whose faces have no area or whose normal was 0; they get (0, 0, 1)
    pub normalless_count: u32,
    /// SHD_MESH_TANGENTS: vertices without a tangent from uv; they get a perpendicular
    /// one
    pub tangentless_count: u32,
    /// SHD_MESH_TANGENTS: vertices that were added
    pub split_count: u32,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_mesh_info>() == 52);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_mesh_info>() == 4);
init!(shd_mesh_info, SHD_DESC_KIND_MESH_INFO);

/// Options of mip levels. Zero is the default of each except alpha_cutoff.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_mip_desc {
    /// set by shd_mip_desc_default()
    pub struct_size: u32,
    /// default SHD_TEXEL_CONTENT_COLOR
    pub content: shd_texel_content,
    /// default SHD_MIP_KERNEL_BOX
    pub kernel: shd_mip_kernel,
    /// default SHD_MIP_SOURCE_BASE
    pub source: shd_mip_source,
    /// texels beyond the edge, for kernels wider than the box; default SHD_WRAP_REPEAT.
    /// With SHD_WRAP_BORDER only texels inside count, with weights scaled to sum 1
    pub wrap_u: shd_wrap,
    /// as wrap_u, for v
    pub wrap_v: shd_wrap,
    /// cutoff of SHD_TEXEL_CONTENT_ALPHA_COVERAGE, 0..1; default 0.5
    pub alpha_cutoff: f32,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_mip_desc>() == 28);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_mip_desc>() == 4);
init!(shd_mip_desc, SHD_DESC_KIND_MIP_DESC);

/// Rays as packed columns of `count` elements, borrowed for the call. They start a little above the surfaces.
/// struct_size goes from the library to the tracer, as in shd/fragments.h.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_rays {
    /// size of the library's struct
    pub struct_size: u32,
    /// number of rays, at least 1
    pub count: usize,
    /// origins, world space
    pub ox: *const f32,
    /// origins, world space
    pub oy: *const f32,
    /// origins, world space
    pub oz: *const f32,
    /// directions, world space, unit
    pub dx: *const f32,
    /// directions, world space, unit
    pub dy: *const f32,
    /// directions, world space, unit
    pub dz: *const f32,
    /// length of each ray, world length, > 0; FLT_MAX or infinity = unlimited
    pub length: *const f32,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_rays>() == 72);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_rays>() == 8);
init!(shd_rays);

/// A tracer and its data. Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_tracer {
    /// NULL = none: depth maps
    pub trace: shd_trace_fn,
    /// passed to `trace`; borrowed for the call
    pub user_data: *mut c_void,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_tracer>() == 16);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_tracer>() == 8);
init!(shd_tracer);

/// Occluders and rays; borrowed for the call. Required: nothing.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_occlusion_desc {
    /// set by shd_occlusion_desc_default()
    pub struct_size: u32,
    /// per point, 1..65536; default 64
    pub rays: u32,
    /// any value; default 0
    pub seed: u32,
    /// world length over which occluders count, > 0; default FLT_MAX = unlimited
    pub radius: f32,
    /// World length by which rays start above the surface, 0..1e9, besides 2^-18 of the largest coordinate of the point.
    /// Depth maps: shd_shadow_desc.bias. Default 0.
    pub bias: f32,
    /// depth maps: edge length \[texels\], 16..8192; default 1024
    pub map_size: u32,
    /// default none
    pub tracer: shd_tracer,
    /// Occluders of the depth maps, as in shd_shadow_render_desc; NULL if draw_count is 0. Not read if there is a
    /// tracer, which has occluders of its own.
    pub draws: *const shd_draw,
    /// up to 2^20
    pub draw_count: usize,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_occlusion_desc>() == 56);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_occlusion_desc>() == 8);
init!(shd_occlusion_desc, SHD_DESC_KIND_OCCLUSION_DESC);

/// Points on surfaces; borrowed for the call.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_occlusion_points {
    /// set by shd_occlusion_points_default()
    pub struct_size: u32,
    /// number of points; 0 is allowed
    pub count: usize,
    /// x, y, z, world space; required unless count is 0
    pub position: [shd_f32_in; 3],
    /// x, y, z, world space, any length; required unless count is 0
    pub normal: [shd_f32_in; 3],
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_occlusion_points>() == 112);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_occlusion_points>() == 8);
init!(shd_occlusion_points, SHD_DESC_KIND_OCCLUSION_POINTS);

/// A texture of occlusion, with the coverage of shd/bake.h. Required: width, height.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_occlusion_atlas {
    /// set by shd_occlusion_atlas_default()
    pub struct_size: u32,
    /// texels, 1..16384
    pub width: u32,
    /// texels, 1..16384
    pub height: u32,
    /// as shd_bake_desc.uv_set: 0 or 1; default 0
    pub uv_set: u32,
    /// as shd_bake_desc.dilation, 0..1024 texels; default 0
    pub dilation: u32,
    /// value of texels that stay empty, finite; default 1
    pub empty: f32,
    /// \[draw_count\] surfaces; mesh, object_to_world and instances are read; NULL if draw_count
    /// is 0
    pub draws: *const shd_draw,
    /// up to 2^20
    pub draw_count: usize,
    /// shd_texel_state of width * height texels; default not wanted
    pub states: shd_u32_out,
    /// statistics; its struct_size is read; NULL = not wanted; all zero on failure
    pub stats: *mut shd_bake_stats,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_occlusion_atlas>() == 64);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_occlusion_atlas>() == 8);
init!(shd_occlusion_atlas, SHD_DESC_KIND_OCCLUSION_ATLAS);

/// A polygon and the kind of its coordinates.
///
/// The polygon is simple: its edges meet in its vertices only, where exactly two of them meet, and no edge is a point.
/// Its vertices run in either direction. Convex kinds need a turn at every vertex.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_polygon_desc {
    /// set by shd_polygon_desc_default()
    pub struct_size: u32,
    /// default SHD_BARYCENTRIC_WACHSPRESS
    pub kind: shd_barycentric,
    /// \[vertex_count\] x and y, finite; required
    pub vertex: [shd_f32_in; 2],
    /// 3..SHD_MAX_POLYGON_VERTICES
    pub vertex_count: u32,
    /// HARMONIC: parts of each side of a triangle, 1..256; default 32. The solution has about
    /// vertex_count segments^2 / 2 nodes. Nodes times vertices are limited to 2^24.
    pub segments: u32,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_polygon_desc>() == 48);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_polygon_desc>() == 8);
init!(shd_polygon_desc, SHD_DESC_KIND_POLYGON_DESC);

/// Points at which coordinates are computed, as columns of `count` elements. Required: position.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_polygon_points {
    /// set by shd_polygon_points_default()
    pub struct_size: u32,
    /// number of points; 0 is allowed
    pub count: usize,
    /// x and y; required
    pub position: [shd_f32_in; 2],
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_polygon_points>() == 48);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_polygon_points>() == 8);
init!(shd_polygon_points, SHD_DESC_KIND_POLYGON_POINTS);

/// Columns for the coordinates.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_polygon_weights {
    /// set by shd_polygon_weights_default()
    pub struct_size: u32,
    /// number of columns; vertex_count of the polygon
    pub weight_count: u32,
    /// \[weight_count\] b_i, one column for each vertex; NULL columns are not wanted
    pub weight: *const shd_f32_out,
    /// written: points outside the polygon
    pub outside_count: usize,
    /// written: points that are not finite
    pub nonfinite_count: usize,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_polygon_weights>() == 32);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_polygon_weights>() == 8);
init!(shd_polygon_weights, SHD_DESC_KIND_POLYGON_WEIGHTS);

/// Colour of a rectangle of the framebuffer: scene-linear, premultiplied by alpha, the average of the samples of each
/// pixel. Its bits are those that a framebuffer with color_format SHD_FORMAT_RGBA32F holds after the frame. Interleaved
/// formats round these values, so a tile is more precise than their pixels; only pixels that the frame leaves unchanged
/// (SHD_RENDER_LOAD, or outside the scissor) are decoded from the framebuffer.
///
/// The struct goes from the library to the callback: struct_size is the size of the library's struct.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_present_tile {
    /// size of the library's struct
    pub struct_size: u32,
    /// below shd_context_worker_count(); calls with one worker are never concurrent
    pub worker: u32,
    /// first column, pixels of the framebuffer from the left
    pub x: u32,
    /// first row, pixels of the framebuffer from the top
    pub y: u32,
    /// columns, 1..64
    pub width: u32,
    /// rows, 1..64
    pub height: u32,
    /// r, g, b and a: \[height\]\[row_stride / 4\]; borrowed for the call
    pub channel: [*const f32; 4],
    /// bytes between rows
    pub row_stride: usize,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_present_tile>() == 64);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_present_tile>() == 8);
init!(shd_present_tile);

/// Host callback for finished tiles. Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_present {
    /// Called once for each tile of the framebuffer in no particular order, also for tiles that the frame does not
    /// change. In a frame of several passes (shd_render_desc.pass_triangles) this is in the last pass, and with
    /// supersampling after the last block. A result other than SHD_OK, with its text from shd_report_error(), becomes
    /// the result of the render; tiles that follow are skipped. NULL = none.
    pub tile: shd_present_tile_fn,
    /// borrowed for the call that takes the shd_present
    pub user_data: *mut c_void,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_present>() == 16);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_present>() == 8);
init!(shd_present);

/// Directions to project, as columns of `count` elements.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_directions {
    /// set by shd_directions_default()
    pub struct_size: u32,
    /// any but SHD_PROJECTION_NONE; required
    pub projection: shd_projection,
    /// number of directions; 0 is allowed
    pub count: usize,
    /// x, y, z, any length; required
    pub direction: [shd_f32_in; 3],
    /// change of `direction` per pixel step in x; absent = 0
    pub direction_dx: [shd_f32_in; 3],
    /// change of `direction` per pixel step in y; absent = 0
    pub direction_dy: [shd_f32_in; 3],
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_directions>() == 160);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_directions>() == 8);
init!(shd_directions, SHD_DESC_KIND_DIRECTIONS);

/// Columns for points of images; NULL = not wanted.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_projected_points {
    /// set by shd_projected_points_default()
    pub struct_size: u32,
    /// across, 0..1
    pub u: shd_f32_out,
    /// down, 0..1
    pub v: shd_f32_out,
    /// face of CUBE, 0..5; 0 for other projections
    pub face: shd_u32_out,
    /// du/dx, within +-1e30; for CUBE on the plane of the face
    pub dudx: shd_f32_out,
    /// dv/dx
    pub dvdx: shd_f32_out,
    /// du/dy
    pub dudy: shd_f32_out,
    /// dv/dy
    pub dvdy: shd_f32_out,
    /// written: directions that count as +Z
    pub nonfinite_count: usize,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_projected_points>() == 128);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_projected_points>() == 8);
init!(shd_projected_points, SHD_DESC_KIND_PROJECTED_POINTS);

/// Points of images, as columns of `count` elements.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_image_points {
    /// set by shd_image_points_default()
    pub struct_size: u32,
    /// any but SHD_PROJECTION_NONE; required
    pub projection: shd_projection,
    /// number of points; 0 is allowed
    pub count: usize,
    /// across, clamped to 0..1; LAT_LONG repeats; required
    pub u: shd_f32_in,
    /// down, clamped to 0..1; required
    pub v: shd_f32_in,
    /// face of CUBE; absent = 0; numbers above 5 mean 5; other projections ignore it
    pub face: shd_u32_in,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_image_points>() == 64);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_image_points>() == 8);
init!(shd_image_points, SHD_DESC_KIND_IMAGE_POINTS);

/// Columns for the directions of points; NULL = not wanted.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_point_directions {
    /// set by shd_point_directions_default()
    pub struct_size: u32,
    /// x, y, z, unit; -Z outside the disc of MIRROR_BALL and ANGULAR
    pub direction: [shd_f32_out; 3],
    /// Solid angle per area of (u, v) at the point \[sr\]; 0 outside the disc. A texel of a small image of n texels has
    /// about the n-th part of it; the integral over the image (six faces) is 4 pi.
    pub solid_angle: shd_f32_out,
    /// written: points with a coordinate that is not finite; it counts as 0
    pub nonfinite_count: usize,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_point_directions>() == 80);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_point_directions>() == 8);
init!(shd_point_directions, SHD_DESC_KIND_POINT_DIRECTIONS);

/// All directions, in one image or six. Required: projection, images.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_direction_images {
    /// set by shd_direction_images_default()
    pub struct_size: u32,
    /// any but SHD_PROJECTION_NONE
    pub projection: shd_projection,
    /// arrangement of CUBE; default six images; others ignore it
    pub layout: shd_cube_layout,
    /// One image, or the six of SHD_CUBE_LAYOUT_FACES, of one struct_size, format and size. Square for MIRROR_BALL,
    /// ANGULAR and OCTAHEDRAL, and the size of the layout for CUBE. Borrowed for the call.
    pub images: *const shd_image,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_direction_images>() == 24);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_direction_images>() == 8);
init!(shd_direction_images, SHD_DESC_KIND_DIRECTION_IMAGES);

/// One mesh in the frame. Required: mesh.
///
/// Lines are rectangles around the edge, as long as the edge, with square ends (OpenGL 4.6 core specification,
/// 14.5, antialiased lines). Points are squares around the vertices. Both lie on the grid of 8 subpixel bits and cover
/// samples as triangles do, so a line or point narrower than 1 may fall between samples. Depth varies along a line and
/// is constant across it; a point has the depth of its vertex. depth_bias_slope uses these depths instead of the
/// triangle's. Attributes are interpolated at the pixel, with barycentric coordinates clamped to the triangle, and
/// texture coordinates clamped to those of its vertices; a triangle without area gives the mean of its corners.
///
/// Culling drops all lines and points of a triangle. A triangle without area is dropped if `cull` is not NONE. Clipping
/// at the near and far plane adds no edges. A vertex beyond these planes has no point, and an edge without length has no
/// line. A shared edge or vertex is drawn once by each of its triangles, with the same samples and depths.
/// SHD_COMPARE_LESS therefore shows it once, but with SHD_DRAW_KEEP_DEPTH a blend is applied several times.
///
/// SHD_FILL_LINES draws each edge of the mesh once, for triangles facing either way: `cull` has no effect. The edge
/// belongs to its first triangle: this triangle's vertices shade it, and it is ordered and counted with this triangle.
/// Silhouettes are found for the centre of projection of world_to_view and view_to_clip (view.eye, if a camera made the
/// view), or for the direction of a parallel projection. They depend on object_to_world and the positions of the mesh;
/// vertex programs have no effect on them.
///
/// A drawing without hidden lines takes two draws. The first draws the mesh as usual (without a material, if only lines
/// shall be visible), with depth_bias 1e-5 and depth_bias_slope fill_width / 2 + 1. This bias moves the surface behind
/// the lines that lie on its front. The second draws the lines with SHD_COMPARE_LESS_EQUAL. Lines over everything use
/// SHD_COMPARE_ALWAYS.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_draw {
    /// set by shd_draw_default(); the same in every element of the array
    pub struct_size: u32,
    /// required; borrowed for the call
    pub mesh: *const shd_mesh,
    /// borrowed for the call; NULL = draw depth only, without programs
    pub material: *const shd_material,
    /// passed to the programs of the material; borrowed for the call; default NULL
    pub uniforms: *const c_void,
    /// affine, finite; default identity
    pub object_to_world: [f32; 16],
    /// Object-to-world matrices, \[instance_count\]\[16\], each affine and finite, instead of object_to_world. The mesh is
    /// drawn with each of them as if by separate draws, in order. Borrowed for the call.
    pub instances: *const f32,
    /// all draws together up to 2^20; default 0 = once, with object_to_world
    pub instance_count: usize,
    /// default SHD_FREQUENCY_PHONG
    pub frequency: shd_frequency,
    /// default none
    pub flags: shd_draw_flags,
    /// default SHD_CULL_NONE
    pub cull: shd_cull,
    /// default SHD_COMPARE_LESS
    pub compare: shd_compare,
    /// added to depth, -1..1; the sum is clamped to 0..1; default 0
    pub depth_bias: f32,
    /// factor of another bias: the larger of |dz/dx| and |dz/dy| per pixel; finite;
    /// default 0
    pub depth_bias_slope: f32,
    /// default SHD_FILL_SOLID
    pub fill: shd_fill,
    /// width of lines and points \[pixels\], 1/16..64; default 0 = 1
    pub fill_width: f32,
    /// edges of SHD_FILL_LINES; default SHD_EDGE_ALL
    pub edges: shd_edge_flags,
    /// threshold of SHD_EDGE_CREASE, as in shd_edges_desc: -1..1; default 0.5
    pub crease_cosine: f32,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_draw>() == 152);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_draw>() == 8);
init!(shd_draw, SHD_DESC_KIND_DRAW);

/// Statistics of a frame: the counts from nonfinite to rasterised add up to `triangles`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_render_stats {
    /// set by shd_render_stats_default()
    pub struct_size: u32,
    /// in all draws
    pub triangles: u64,
    /// dropped: a vertex is NaN or infinite after transformation
    pub nonfinite: u64,
    /// dropped: outside the view volume
    pub outside: u64,
    /// dropped: facing the culled way, without area on the pixel grid, or
    /// (SHD_FILL_LINES) without a visible edge that belongs to the triangle
    pub culled: u64,
    /// dropped: between pixel centres
    pub empty: u64,
    /// drawn, hidden or not
    pub rasterised: u64,
    /// cut by a clip plane, among outside, culled, empty and rasterised
    pub clipped: u64,
    /// shaded; opaque draws count a pixel once for every triangle that is visible in
    /// it, in each pass (shd_render_desc.pass_triangles)
    pub fragments: u64,
    /// fragments whose r, g, b or a was NaN or infinite (kept as written)
    pub nonfinite_fragments: u64,
    /// covered, but failed the depth test before shading; 0 without
    /// SHD_RENDER_COUNT_HIDDEN. Draws that blend or drop fragments may be tested against
    /// stale depth, so their count is approximate
    pub hidden_samples: u64,
    /// PAINTER and NEWELL: pairs of triangles or pieces that overlap on the screen where the one painted first is nearer
    /// somewhere in the overlap, by more than the tolerance of NEWELL. A lower bound where triangles are dense: pairs
    /// are searched in the cells of a grid, and in a cell of n triangles up to 64 n + 1024 pairs are compared.
    pub order_conflicts: u64,
    /// cuts of NEWELL
    pub splits: u64,
    /// peak of working memory, with what the context keeps from earlier calls; depends on
    /// the number of workers
    pub scratch_bytes: u64,
    /// wall-clock time of transforming vertices
    pub vertex_seconds: f64,
    /// wall-clock time of finding visible triangles and clipping them
    pub assembly_seconds: f64,
    /// wall-clock time of sorting triangles by distance (if at all) and into tiles
    pub binning_seconds: f64,
    /// wall-clock time of coverage, shading and blending
    pub tile_seconds: f64,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_render_stats>() == 144);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_render_stats>() == 8);
init!(shd_render_stats, SHD_DESC_KIND_RENDER_STATS);

/// Host progress callback. Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_progress {
    /// Called after each piece of the frame, with the finished fraction of the frame, (0, 1\]. Runs on any worker; calls
    /// are never concurrent. Must not throw, longjmp or call shd. A result other than 0 cancels: the render returns
    /// SHD_ERROR_CANCELLED and the framebuffer holds a part of the frame.
    pub report: shd_progress_report_fn,
    /// borrowed for the call
    pub user_data: *mut c_void,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_progress>() == 16);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_progress>() == 8);
init!(shd_progress);

/// Rectangle of pixels of a picture. Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_region {
    /// first column from the left
    pub x: u32,
    /// first row from the top
    pub y: u32,
    /// columns
    pub width: u32,
    /// rows
    pub height: u32,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_region>() == 16);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_region>() == 4);
init!(shd_region);

/// A whole frame, or a window of it. All pointers are borrowed for the call. Required: framebuffer.
///
/// Draws are projected to the picture. The framebuffer holds the window of the picture that begins at pixel (crop_x,
/// crop_y). Its pixels have the same bits as in the whole picture.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_render_desc {
    /// set by shd_render_desc_default()
    pub struct_size: u32,
    /// required
    pub framebuffer: *mut shd_framebuffer,
    /// linear, premultiplied RGBA; default 0
    pub clear_color: [f32; 4],
    /// 0..1; default 1
    pub clear_depth: f32,
    /// default none
    pub flags: shd_render_flags,
    /// Replaces `view`. An aspect of 0, the default, means the aspect of the viewport, or of the picture if there is no
    /// viewport. NULL = `view`.
    pub camera: *const shd_camera,
    /// default: identity matrices, eye at 0
    pub view: shd_view,
    /// default SHD_VISIBILITY_DEPTH
    pub visibility: shd_visibility,
    /// \[draw_count\], all with the same struct_size, in order; NULL if draw_count is
    /// 0
    pub draws: *const shd_draw,
    /// up to 2^20
    pub draw_count: usize,
    /// \[light_count\]; NULL if light_count is 0
    pub lights: *const *const shd_light,
    /// \[light_count\], each NULL or a shadow of shd/shadow.h that was rendered for a light of the same kind. The light
    /// that reaches a fragment is multiplied by the visibility at its position, with its shading normal. NULL = none.
    pub shadows: *const *const shd_shadow,
    /// up to 2^20
    pub light_count: usize,
    /// pixels, framebuffer size..65536; default 0 = framebuffer size
    pub picture_width: u32,
    /// pixels, framebuffer size..65536; default 0 = framebuffer size
    pub picture_height: u32,
    /// column of the picture at which the framebuffer begins; the framebuffer lies
    /// inside the picture; default 0
    pub crop_x: u32,
    /// row of the picture at which the framebuffer begins; default 0
    pub crop_y: u32,
    /// target of NDC -1..1 in the picture, not empty; cuts triangles, lines and points
    /// at its edge; NULL = the whole picture
    pub viewport: *const shd_region,
    /// pixels of the picture that may change; NULL = all
    pub scissor: *const shd_region,
    /// n, 2..16; 0 and 1 = off. The frame is drawn as a picture n times as large, up to 65536 pixels a side, with the
    /// framebuffer's number of samples in each pixel; crop, viewport and scissor are scaled by n. Colour and targets of
    /// a pixel are the plain average of its n x n pixels; depth and the other planes have the values of the top left
    /// one. Derivatives (and so footprints of textures) and raster positions in programs refer to the large picture;
    /// lines and points are n times as wide in it. With SHD_RENDER_LOAD each of the n x n pixels starts with the pixel's
    /// values. The large picture is drawn in blocks of up to 1024 x 1024 pixels; only one block is in memory. Statistics
    /// are sums over blocks, so a triangle counts in each block.
    pub supersampling: u32,
    /// Largest number of triangles that are processed together, 1024..2^31-1; 0 = 2^21. A larger frame is drawn in
    /// passes. A pass has several whole draws, each of which counts as at least 16 triangles, or a part of one draw. The
    /// framebuffer has the same bits for any number. Draws of SHD_BLEND_WEIGHTED and SHD_BLEND_SORTED form the last pass
    /// together. Only with SHD_VISIBILITY_DEPTH: the other methods order all triangles together.
    ///
    /// Working memory is at most 512 bytes for each of these triangles, 256 for each draw or instance, 24 for each
    /// sample of the framebuffer and 16 more for each of its targets, and 8 MiB for each worker. Additional memory: 4
    /// bytes for each tile of 64 x 64 pixels that a triangle touches beyond dozens, 48 for each piece of a clipped
    /// triangle, 4 for each varying of up to three vertices a triangle, and the triangles of the last pass. A frame in
    /// several passes or with supersampling takes 16 bytes for each pixel of a framebuffer with interleaved colour.
    pub pass_triangles: u32,
    /// statistics; its struct_size is read; NULL = not wanted. All zero on failure, except
    /// where the struct_size or the unknown end of this desc is refused
    pub stats: *mut shd_render_stats,
    /// default none
    pub progress: shd_progress,
    /// receives the finished tiles; default none
    pub present: shd_present,
    /// Light from all directions, in addition to the lights; NULL = none. Every model with lights reflects it, except
    /// GOOCH. It casts no shadows; SHD_SLOT_OCCLUSION multiplies all of its reflected light. It must
    /// have been created with the tables of the models of the draws (shd_environment_desc.tables).
    pub environment: *const shd_environment,
    /// factor of its radiance, 0..1e12; default 1
    pub environment_intensity: f32,
    /// rotation or reflection of its directions, column-major, with orthonormal
    /// columns within 1e-3; default identity
    pub environment_to_world: [f32; 9],
    /// default SHD_BACKGROUND_CLEAR
    pub background: shd_background,
    /// roughness of the GGX lobe that blurs the environment behind the picture, 0..1;
    /// values above 0 need SHD_ENVIRONMENT_TABLE_GGX; default 0 = sharp
    pub background_roughness: f32,
    /// \[volume_count\], all with the same struct_size. They are blended over the finished draws in this order, so the
    /// caller sorts volumes from far to near. A ray of a pixel ends at the depth of a sample, with one march for all
    /// samples of equal depth. Depth decreases with the distance if clear_depth is below 1/2, and increases otherwise.
    /// Depth and planes other than colour keep their values. NULL if volume_count is 0.
    pub volumes: *const shd_volume_draw,
    /// up to 1024; default 0
    pub volume_count: usize,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_render_desc>() == 384);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_render_desc>() == 8);
init!(shd_render_desc, SHD_DESC_KIND_RENDER_DESC);

/// Settings of a sampler.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_sampler_desc {
    /// set by shd_sampler_desc_default()
    pub struct_size: u32,
    /// default SHD_FILTER_TRILINEAR
    pub filter: shd_filter,
    /// default SHD_MAGNIFICATION_DEFAULT
    pub magnification: shd_magnification,
    /// default SHD_WRAP_REPEAT
    pub wrap_u: shd_wrap,
    /// default SHD_WRAP_REPEAT
    pub wrap_v: shd_wrap,
    /// colour of texels outside with SHD_WRAP_BORDER: stored r, g, b, a, linear,
    /// before the swizzle of the texture; channels that come from its `fill` are
    /// `fill` outside, too; finite; default 0
    pub border: [f32; 4],
    /// default SHD_PROFILE_LEAST_ERROR. It also determines which
    /// lookups are magnified (shd_magnification)
    pub profile: shd_profile,
    /// added to the level of detail, -15..15; default 0
    pub lod_bias: f32,
    /// lowest level of detail, 0..32; default 0; it is used where lod_max is lower
    pub lod_min: f32,
    /// highest level of detail, 0..32; default 32
    pub lod_max: f32,
    /// factor of the derivatives in x, 0..64; default 1
    pub width_x: f32,
    /// factor of the derivatives in y, 0..64; default 1
    pub width_y: f32,
    /// blur in u, 0..1, added to the footprint as covariance; default 0
    pub blur_u: f32,
    /// blur in v, 0..1, added to the footprint as covariance; default 0
    pub blur_v: f32,
    /// largest ratio of the footprint's axes, 1..64; default 16
    pub max_anisotropy: f32,
    /// weights of ANISOTROPIC in LEAST_ERROR and EXACT; default SHD_PROBE_WEIGHTS_EQUAL
    pub probe_weights: shd_probe_weights,
    /// kernel of bicubic filters; default SHD_CUBIC_CATMULL_ROM
    pub cubic: shd_cubic,
    /// area of SHD_FILTER_SUMMED_AREA; default SHD_BOX_BOUNDING
    pub r#box: shd_box,
    /// tolerance of SHD_FILTER_EXACT, 2^-12..1; default 2^-6
    pub tolerance: f32,
    /// Filter that SHD_FILTER_STOCHASTIC estimates: BILINEAR, BICUBIC (B-spline only), TRILINEAR, ANISOTROPIC or EWA;
    /// default SHD_FILTER_TRILINEAR.
    pub stochastic_filter: shd_filter,
    /// seed of SHD_FILTER_STOCHASTIC; default 0
    pub seed: u32,
    /// default SHD_PRECISION_FULL
    pub precision: shd_precision,
    /// Largest number of texels that a lookup of ANISOTROPIC or EWA reads; in 3D textures 2 or 4 times as many. 0 = no
    /// limit besides max_anisotropy, or 32 or more; default 0. It limits the ratio of the footprint's axes as
    /// max_anisotropy does: longer footprints use coarser levels.
    pub max_texels: u32,
    /// Length by which a footprint may exceed the probes of ANISOTROPIC in LEAST_ERROR and EXACT before another one is
    /// added, in widths of a probe, 0..1; default 1/8. A footprint r times as long as wide has ceil(r - probe_slack)
    /// probes.
    pub probe_slack: f32,
    /// Part of the way between two mip levels in which TRILINEAR, NEAREST_MIP_LINEAR and ANISOTROPIC in LEAST_ERROR and
    /// EXACT blend them, 0..1; default 1. If f is the fraction of the level of detail, the share of the coarser level is
    /// clamp((f - 1/2) / level_blend + 1/2, 0, 1), and a level without share is not read. With 0, only the nearer level
    /// is read.
    pub level_blend: f32,
    /// random choice of SHD_FILTER_STOCHASTIC; default SHD_STOCHASTIC_TEXEL
    pub stochastic: shd_stochastic,
    /// across the slices of a 3D texture; no effect for others; default SHD_WRAP_REPEAT
    pub wrap_w: shd_wrap,
    /// default SHD_MISSING_TILES_WAIT
    pub missing_tiles: shd_missing_tiles,
    /// 1 = comparison lookups, as texture units have them for shadow maps (percentage-closer filtering; Reeves, Salesin
    /// and Cook 1987; Vulkan 1.3 specification, "Depth Compare Operation"); 0 = lookups return texels; default 0. Each
    /// texel that the filter reads becomes 1 if the comparison of the lookup's `reference` with it is true, else 0. The
    /// filter blends these numbers. The result is in r; g and b are 0, and a is 1.
    ///
    /// A texel is its channel of r after the texture's swizzle, which may be a constant of `fill`. Texels outside with
    /// SHD_WRAP_BORDER have the border colour. UNORM and SRGB formats clamp the reference to \[0, 1\]. Numbers are
    /// compared as floats, after sRGB is decoded.
    ///
    /// Works with NEAREST, BILINEAR, NEAREST_MIP, NEAREST_MIP_LINEAR, BILINEAR_MIP, TRILINEAR and ANISOTROPIC on all
    /// textures. Other filters, derivatives, and samplers of materials, lights and tessellations return
    /// SHD_ERROR_UNSUPPORTED. SHD_PRECISION_FAST has no effect.
    pub compares: u32,
    /// comparison of these lookups; default SHD_COMPARE_LESS
    pub compare: shd_compare,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_sampler_desc>() == 132);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_sampler_desc>() == 4);
init!(shd_sampler_desc, SHD_DESC_KIND_SAMPLER_DESC);

/// Options and budgets of a load. A budget that would be exceeded is SHD_ERROR_LIMIT.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_scene_desc {
    /// set by shd_scene_desc_default()
    pub struct_size: u32,
    /// default none
    pub flags: shd_scene_flags,
    /// flags of all meshes; meshes with uv have tangents, unless a normal map reads uv1;
    /// default none
    pub mesh_flags: shd_mesh_flags,
    /// sampler of all textures; its wraps are replaced by those of the file, and
    /// its filter and magnification where the file has nearest texels or
    /// levels. Borrowed for the call; NULL = trilinear
    pub sampler: *const shd_sampler_desc,
    /// formats, flags, tables and budgets of each texture file; its color_space is
    /// ignored; worker_path is that of the model,
    /// too. Borrowed for the call; NULL = defaults
    pub texture: *const shd_load_desc,
    /// sum of the model and the files that are read with it; 0 = 2^30
    pub max_file_bytes: u64,
    /// sum over all meshes; 0 = 2^26
    pub max_vertices: u64,
    /// sum over all meshes; 0 = 2^26
    pub max_triangles: u64,
    /// 0 = 2^18; always at most 512 deep
    pub max_nodes: u64,
    /// up to 2^20, the maximum of a frame; 0 = 2^18
    pub max_instances: u64,
    /// all textures with their mip levels; 0 = 2^32
    pub max_texture_bytes: u64,
    /// \[s\] 0 = 60. Ends the process that reads; with SHD_SCENE_IN_PROCESS checked
    /// between the steps of a reader
    pub time_limit: f64,
    /// memory of the process that reads, and of what it sends; 0 = 2^32 \[bytes\]
    pub max_reader_bytes: u64,
    /// Answers the names of the model's files, in place of its folder: for archives and memory. The bytes are borrowed
    /// until the load returns. SHD_ERROR_NOT_FOUND = no such file; any other result than SHD_OK ends the load. Runs on
    /// the thread of the load; must not throw or longjmp. NULL = the folder of the model, or no file for a model in
    /// memory.
    pub find: shd_scene_desc_find_fn,
    /// first argument of `find`
    pub find_user_data: *mut c_void,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_scene_desc>() == 112);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_scene_desc>() == 8);
init!(shd_scene_desc, SHD_DESC_KIND_SCENE_DESC);

/// Contents of a file.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_scene_info {
    /// set by shd_scene_info_default()
    pub struct_size: u32,
    /// with triangles
    pub mesh_count: u32,
    /// at least 1
    pub material_count: u32,
    /// that could be read
    pub texture_count: u32,
    /// 0 where the file has none
    pub light_count: u32,
    /// 0 where the file has none
    pub camera_count: u32,
    /// as many as draws
    pub instance_count: u32,
    /// parts of the file that were left out or changed
    pub warning_count: u32,
    /// sum over all meshes, each counted once
    pub vertex_count: u64,
    /// sum over all meshes, each counted once
    pub triangle_count: u64,
    /// lowest x, y, z of all instances, world space
    pub bounds_min: [f32; 3],
    /// highest x, y, z of all instances, world space
    pub bounds_max: [f32; 3],
    /// a place in the world of the file is origin + the place in world space; 0 unless the
    /// model is far away from 0. Equal in all poses
    pub origin: [f64; 3],
    /// 0 where the file has none
    pub animation_count: u32,
    /// meshes with a skin or morph targets, which each pose makes anew
    pub deformed_mesh_count: u32,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_scene_info>() == 104);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_scene_info>() == 8);
init!(shd_scene_info, SHD_DESC_KIND_SCENE_INFO);

/// A mesh placed in the world with a material.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_scene_instance {
    /// set by shd_scene_instance_default()
    pub struct_size: u32,
    /// index for shd_scene_mesh()
    pub mesh: u32,
    /// index for shd_scene_material()
    pub material: u32,
    /// affine, finite
    pub object_to_world: [f32; 16],
    /// faces that its draw skips: SHD_CULL_NONE for surfaces that are double-sided
    pub cull: shd_cull,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_scene_instance>() == 80);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_scene_instance>() == 4);
init!(shd_scene_instance, SHD_DESC_KIND_SCENE_INSTANCE);

/// Options of a shadow.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_shadow_desc {
    /// set by shd_shadow_desc_default()
    pub struct_size: u32,
    /// edge length of each face \[texels\], 16..8192; default 1024
    pub size: u32,
    /// default SHD_SHADOW_FILTER_HARD
    pub filter: shd_shadow_filter,
    /// n of PCF, VARIANCE and PCSS, 1..15; default 3
    pub taps: u32,
    /// SUMMED_AREA_VARIANCE: edge length of the averaged square, world length at the point, 0..1e9; clamped to one texel
    /// to size / 4 texels. Default 0.
    pub filter_size: f32,
    /// PCSS: edge length of the square light, world length, 0..1e9; default 0. For directional lights: width of the
    /// penumbra per distance of blocker and receiver, which is twice the tangent of half the angular size of the light
    /// (the sun: 0.0093). Search and penumbra are at most size / 4 texels wide.
    pub light_size: f32,
    /// points are moved towards the light by this depth, world length, 0..1e9; default 0
    pub bias: f32,
    /// Factor of another bias: the edge length of a texel at the point times 1/4 + s. s is the sum of the |slopes| of
    /// the surface across and along the map, at most 8. A slope is depth over length. The plane of the surface is exact
    /// at each texel, so this bias covers only the difference of the surface from its plane. Without a normal, 1/4 + s
    /// is replaced by 2, or by n + 1 for PCF. 0..1000; default 1.
    pub bias_slope: f32,
    /// before the lookup, points are moved along their normal by this world length, 0..1e9;
    /// default 0. For coarse meshes with smooth normals: about the edge length of a texel
    pub normal_offset: f32,
    /// faces that cast no shadow: BACK faces are turned away from the light, FRONT faces
    /// towards it. Replaces the culling of the draws. Default SHD_CULL_NONE, for open surfaces.
    /// FRONT avoids acne on closed objects without a bias, but light leaks where they touch
    /// other surfaces
    pub caster_cull: shd_cull,
    /// VARIANCE, SUMMED_AREA_VARIANCE: visibilities below this value become 0, 0..0.99;
    /// default 0
    pub bleed: f32,
    /// VARIANCE, SUMMED_AREA_VARIANCE: world length squared, 0..1e9; default 0
    pub min_variance: f32,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_shadow_desc>() == 48);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_shadow_desc>() == 4);
init!(shd_shadow_desc, SHD_DESC_KIND_SHADOW_DESC);

/// Light and draws of a map; borrowed for the call. Required: light.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_shadow_render_desc {
    /// set by shd_shadow_render_desc_default()
    pub struct_size: u32,
    /// required; directional, spot or point
    pub light: *const shd_light,
    /// Draws that cast shadows, as in shd_render_desc; NULL if draw_count is 0. Depth comparison, depth biases and
    /// culling of a draw are ignored; a draw with SHD_DRAW_KEEP_DEPTH casts no shadow. Vertex programs run with the
    /// light's view. Alpha tests and programs that drop fragments apply too, except for draws with WEIGHTED or SORTED
    /// blending. Opacity by itself has no effect.
    pub draws: *const shd_draw,
    /// up to 2^20
    pub draw_count: usize,
    /// Range of depths, near_plane \< far_plane. Surfaces outside cast no shadow. Both 0 = fitted to the draws.
    /// Directional lights: measured from the origin of the world along the direction of the light, any sign. Other
    /// lights: measured from the light along the axis of the face, > 0; a fitted near_plane is at least 1/256 of
    /// far_plane.
    pub near_plane: f32,
    pub far_plane: f32,
    /// Directional lights: the part of the world that needs shadows. Both 0 = the bounds of the draws. Draws between
    /// this part and the light still cast shadows. The size of texels is rounded up in steps of 1/8 to 1/16, and texels
    /// lie at multiples of their size, so shadows do not shimmer while bounds of constant size move.
    pub bounds_min: [f32; 3],
    pub bounds_max: [f32; 3],
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_shadow_render_desc>() == 64);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_shadow_render_desc>() == 8);
init!(shd_shadow_render_desc, SHD_DESC_KIND_SHADOW_RENDER_DESC);

/// Points on surfaces; borrowed for the call.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_shadow_lookups {
    /// set by shd_shadow_lookups_default()
    pub struct_size: u32,
    /// number of points; 0 is allowed
    pub count: usize,
    /// x, y, z, world space; required unless count is 0
    pub position: [shd_f32_in; 3],
    /// unit, world space; all three columns or none
    pub normal: [shd_f32_in; 3],
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_shadow_lookups>() == 112);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_shadow_lookups>() == 8);
init!(shd_shadow_lookups, SHD_DESC_KIND_SHADOW_LOOKUPS);

/// A shape and its subdivision.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_shape_desc {
    /// set by shd_shape_desc_default()
    pub struct_size: u32,
    /// default sphere
    pub shape: shd_shape,
    /// spheres and tori: 1e-30..1e30; default 1
    pub radius: f32,
    /// tori: 1e-30..1e30, below `radius`; default 0.25
    pub tube_radius: f32,
    /// boxes and planes: length along x, y, z, 1e-30..1e30; default 2
    pub size: [f32; 3],
    /// Parts; 0 = the number in brackets. Sphere: around, 3..4096 \[32\], and from pole to pole, 2..4096 \[16\]. Box: along
    /// x, y and z, 1..4096 \[1\]. Plane: \[0\] along x and \[2\] along z, as of `size`, 1..4096 \[1\]. Torus: around the axis,
    /// 3..4096 \[48\], and around the tube, 3..4096 \[24\]. Teapot: along each side of a patch, 2..256 \[8\]. Unused numbers
    /// are ignored, as size\[1\] and segments\[1\] of a plane.
    pub segments: [u32; 3],
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_shape_desc>() == 40);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_shape_desc>() == 4);
init!(shd_shape_desc, SHD_DESC_KIND_SHAPE_DESC);

/// Output columns of a shape. They do not overlap; each may be absent.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_shape_columns {
    /// set by shd_shape_columns_default()
    pub struct_size: u32,
    /// elements in each column of vertices, at least the number from shd_shape_count()
    pub vertex_count: u32,
    /// elements in `indices`, at least the number from shd_shape_count() unless `indices`
    /// is absent
    pub index_count: usize,
    /// x, y, z, object space
    pub position: [shd_f32_out; 3],
    /// x, y, z, unit, outwards
    pub normal: [shd_f32_out; 3],
    /// u, v
    pub uv: [shd_f32_out; 2],
    /// three for each triangle
    pub indices: shd_u32_out,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_shape_columns>() == 160);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_shape_columns>() == 8);
init!(shd_shape_columns, SHD_DESC_KIND_SHAPE_COLUMNS);

/// A source for a coefficient. Required: target, and the fields that the source uses.
///
/// Slots that scale light (diffuse, tint, ambient, specular, opacity, emission, metallic, occlusion, matcap) are looked
/// up for every fragment at every frequency. Slots that shape a lobe (exponent, roughness, normal, normal_mixed, height
/// and those of the clear coat) are looked up where lobes are evaluated: at flat and Gouraud frequency at the centroid
/// or vertex, on level 0.
///
/// Values are not clamped, even if negative. NaN and infinity propagate to the colours of their fragments, which
/// shd_render_stats.nonfinite_fragments counts. There are two exceptions. Exponents are clamped to 0..1e6 (NaN becomes
/// 0) and roughness to 0..1 (NaN becomes 1). The surface keeps its normal where a mapped normal is 0 or not finite, or a
/// slope of heights is not finite.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_slot {
    /// set by shd_slot_default(); the same in every element of an array
    pub struct_size: u32,
    /// the coefficient; each slot of a material has a different one
    pub target: shd_slot_target,
    /// default SHD_SLOT_SOURCE_CONSTANT
    pub source: shd_slot_source,
    /// SHD_SLOT_SOURCE_VERTEX: first column, 0..7; default 0
    pub attribute: u32,
    /// SHD_SLOT_SOURCE_TEXTURE: a 2D texture, or a 3D texture that is looked up at places;
    /// else NULL; retained by the material
    pub texture: *mut shd_texture,
    /// SHD_SLOT_SOURCE_TEXTURE: NULL = default sampler; retained by the material
    pub sampler: *mut shd_sampler,
    /// function of SHD_SLOT_SOURCE_PROCEDURE
    pub procedure: shd_slot_fn,
    /// passed to `procedure`; borrowed until release of the material
    pub user_data: *mut c_void,
    /// channel of the texture or the solid texture for scalars, 0..3; default 0
    pub channel: u32,
    /// coordinates for the texture: 0 = uv of the mesh, 1 = uv1; default 0
    pub uv_set: u32,
    /// (u', v') = (t\[0\] u + t\[1\] v + t\[2\], t\[3\] u + t\[4\] v + t\[5\]), finite; default identity. glTF's
    /// KHR_texture_transform is T R S, with the rotation r and v downwards
    /// t = {sx cos r, sy sin r, ox, -sx sin r, sy cos r, oy}.
    pub uv_transform: [f32; 6],
    /// Solid texture of SHD_SLOT_SOURCE_SOLID, else NULL; copied by the material. Colours take r, g, b and, for the
    /// diffuse slot and normals, a; scalars take `channel`. At Phong frequency, and for slots that scale light, the
    /// width of a pixel is max(|dp/dx|, |dp/dy|), with the exact derivatives of the place p by pixel steps; where lobes
    /// are evaluated at vertices or centroids it is 0. `place_width` multiplies it.
    pub solid: *const shd_solid_desc,
    /// Place = place_transform * position, column-major, affine: the last row is 0, 0, 0, 1; default identity. A solid
    /// texture is evaluated at the place. A 3D texture is looked up at (u, v, w) = place, with the derivatives of the
    /// place by pixel steps times `place_width`: it fills the cube from 0 to 1, and its sampler wraps it.
    pub place_transform: [f32; 16],
    /// space of the position; default SHD_PLACE_SPACE_OBJECT
    pub place_space: shd_place_space,
    /// factor of the width of a pixel, 0..1000; 0 = no band limit, level 0 of
    /// 3D textures; default 1
    pub place_width: f32,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_slot>() == 160);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_slot>() == 8);
init!(shd_slot, SHD_DESC_KIND_SLOT);

/// A solid texture: a pattern, its octaves and its colours. It has no pointers, so a copy is independent.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_solid_desc {
    /// set by shd_solid_desc_default()
    pub struct_size: u32,
    /// default SHD_SOLID_STRIPES
    pub kind: shd_solid,
    /// another seed gives another pattern of the same kind; no effect on STRIPES, CHECKER
    pub seed: u32,
    /// side of a cell or width of a stripe \[units of the positions\], 1e-30..1e30; default 1
    pub size: f32,
    /// Number of octaves of PERLIN, VALUE, SIMPLEX, WORLEY, and of the noise in MARBLE and WOOD, 1..32; default 1. The
    /// sum is N = sum of gain^i n(lacunarity^i p) / sum of gain^i, for i from 0 on. Each octave has a pattern of its
    /// own, except with SHD_SOLID_GRADIENTS_TABLE, as in the classic form.
    pub octaves: u32,
    /// ratio of the frequencies of successive octaves, 1..16; default 2
    pub lacunarity: f32,
    /// ratio of the amplitudes of successive octaves, 0..1; default 1/2
    pub gain: f32,
    /// PERLIN, VALUE and SIMPLEX: default SHD_SOLID_SUM_FBM
    pub sum: shd_solid_sum,
    /// PERLIN: default SHD_SOLID_GRADIENTS_HASHED
    pub gradients: shd_solid_gradients,
    /// PERLIN, VALUE, MARBLE and WOOD: default SHD_SOLID_FADE_QUINTIC
    pub fade: shd_solid_fade,
    /// WORLEY: default SHD_SOLID_DISTANCE_F1
    pub distance: shd_solid_distance,
    /// MARBLE and WOOD: factor of the noise \[cells\], 0..1000; default 1
    pub distortion: f32,
    /// Values of the first and the last colour, -1e6..1e6; equal = the limits of the kind's range; default 0, 0.
    pub range: [f32; 2],
    /// 2..SHD_MAX_SOLID_COLORS; default 2
    pub color_count: u32,
    /// r, g, b, a at equal distances over `range`, linear, -1e6..1e6; values in between are interpolated, values beyond
    /// `range` have the nearest colour. Default black and white, both opaque.
    pub colors: [[f32; 4]; 8],
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_solid_desc>() == 188);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_solid_desc>() == 4);
init!(shd_solid_desc, SHD_DESC_KIND_SOLID_DESC);

/// Points at which a solid texture is evaluated, as columns of `count` elements. Required: position.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_solid_points {
    /// set by shd_solid_points_default()
    pub struct_size: u32,
    /// number of points; 0 is allowed
    pub count: usize,
    /// x, y, z; required
    pub position: [shd_f32_in; 3],
    /// diameter of a pixel at the point \[units of the positions\]; absent = 0: no band limit
    pub width: shd_f32_in,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_solid_points>() == 80);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_solid_points>() == 8);
init!(shd_solid_points, SHD_DESC_KIND_SOLID_POINTS);

/// Columns for the values of a solid texture; NULL = not wanted. At least one is required.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_solid_values {
    /// set by shd_solid_values_default()
    pub struct_size: u32,
    /// the pattern, in the range of its kind
    pub value: shd_f32_out,
    /// d value / dx, dy and dz, with the width held constant, limited to -1e30..1e30. Where the pattern jumps or has no
    /// derivative the result is that of one side, or 0.
    pub gradient: [shd_f32_out; 3],
    /// r, g, b, a of shd_solid_desc.colors at the value, linear
    pub color: [shd_f32_out; 4],
    /// written: points whose position or width is not finite
    pub nonfinite_count: usize,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_solid_values>() == 144);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_solid_values>() == 8);
init!(shd_solid_values, SHD_DESC_KIND_SOLID_VALUES);

/// Options of tessellation and displacement.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_tessellation_desc {
    /// set by shd_tessellation_desc_default()
    pub struct_size: u32,
    /// default SHD_TESSELLATION_MODE_UNIFORM
    pub mode: shd_tessellation_mode,
    /// UNIFORM: parts of an edge, 1..SHD_MAX_SEGMENTS; default 1
    pub segments: u32,
    /// ADAPTIVE: largest number of parts of an edge, 1..SHD_MAX_SEGMENTS; default 64
    pub max_segments: u32,
    /// ADAPTIVE: longest part \[pixels\], without `view` \[world units\]; > 0; default 8
    pub edge_length: f32,
    /// ADAPTIVE with `view`: of the picture \[pixels\], 1..65536; default 1024
    pub width: u32,
    /// ADAPTIVE with `view`: of the picture \[pixels\], 1..65536; default 1024
    pub height: u32,
    /// the call is refused if the result would have more, 1..2^28; default 2^24
    pub max_triangles: u32,
    /// ADAPTIVE: view for lengths in pixels. An edge counts as turned about its middle until it is perpendicular to the
    /// line of sight; its length is then projected to the picture. An edge that passes the eye has max_segments parts,
    /// an edge behind the eye has 1. Borrowed for the call; NULL = lengths in world units.
    pub view: *const shd_view,
    /// ADAPTIVE: \[16\], column-major; borrowed for the call; NULL = identity
    pub object_to_world: *const f32,
    /// channel r is the height; borrowed for the call; NULL = no displacement
    pub displacement: *const shd_texture,
    /// sampler of `displacement`; borrowed for the call; NULL = the default sampler
    pub sampler: *const shd_sampler,
    /// level of detail of the lookups, log2 of base texels, -32..32; default 0
    pub lod: f32,
    /// factor of heights \[object units\], -1e12..1e12; default 0 = no displacement
    pub amplitude: f32,
    /// height that is not displaced, -1e12..1e12; default 0
    pub offset: f32,
    /// used with displacement; default SHD_DISPLACED_NORMALS_TILTED
    pub normals: shd_displaced_normals,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_tessellation_desc>() == 80);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_tessellation_desc>() == 8);
init!(shd_tessellation_desc, SHD_DESC_KIND_TESSELLATION_DESC);

/// Texels and tables of a texture. Required: format, width, height, texels.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_texture_desc {
    /// set by shd_texture_desc_default()
    pub struct_size: u32,
    /// any; no default. RGB8 to RGB32F are stored as RGBA. Blocks stay compressed, and lookups
    /// decode them (docs/compressed.md): the caller gives its mip levels; other tables are
    /// kept decoded
    pub format: shd_format,
    /// texels, 1..65536; width * height * layers at most 2^28; see `tiles` for larger ones
    pub width: u32,
    /// texels, 1..65536
    pub height: u32,
    /// \[layers\]\[height\]\[width\], row 0 on top, aligned to a channel; copied without
    /// SHD_TEXTURE_BORROW. Blocks: \[layers\]\[ceil(height / 4)\]\[ceil(width / 4)\], at any
    /// address
    pub texels: *const c_void,
    /// bytes between rows of texels or blocks, at least the bytes of a row; 0 = packed
    pub row_stride: usize,
    /// bytes between layers, at least the rows of a layer times the row stride; 0 = packed
    pub layer_stride: usize,
    /// images of the array, 1..2048; default 1
    pub layers: u32,
    /// default none
    pub flags: shd_texture_flags,
    /// sources of r, g, b, a of lookups; default SHD_CHANNEL_DEFAULT
    pub swizzle: [shd_channel; 4],
    /// values of channels that the format does not have, in lookups inside and outside the
    /// image; finite; default 0, 0, 0, 1
    pub fill: [f32; 4],
    /// default none
    pub tables: shd_table_flags,
    /// number of `levels` per layer; the mipmap ends with the last one, even if it is
    /// larger than 1 x 1; default 0 = the library builds the levels
    pub level_count: u32,
    /// The caller's mip levels for SHD_TABLE_MIPMAP: \[layers\]\[level_count\], all of one struct_size, of this format;
    /// copied. Element l is level l + 1: max(1, width >> (l + 1)) by max(1, height >> (l + 1)). A ripmap of the same
    /// texture uses them for the levels that it shares with the mipmap. A 3D texture has the max(1, depth >> 1) slices
    /// of level 1 first, then the slices of level 2, and so on.
    pub levels: *const shd_image,
    /// Slices of a 3D texture, 1..65536; default 0 = a 2D texture. width * height * depth is at most 2^28, `layers` is
    /// 1, and SHD_TABLE_MIPMAP is the only table. Texels are \[depth\]\[height\]\[width\], and `layer_stride` is the distance
    /// of slices. Lookups read (u, v, w); w = 0 is the outer face of slice 0. A level halves all three sizes.
    pub depth: u32,
    /// Default SHD_PROJECTION_NONE. With any other one, lookups read (u, v, w) as a direction of any length. `width` and
    /// `height` are equal unless it is LAT_LONG; `layers` of CUBE are the 6 faces +X, -X, +Y, -Y, +Z, -Z; `depth` is 0;
    /// `tables` has SHD_TABLE_MIPMAP at most. Mip levels are averages of texels of one image, unweighted.
    pub projection: shd_projection,
    /// Default none. With a cache, the texture keeps no texels: `texels` is NULL, strides are 0, nothing is borrowed,
    /// and the format has not three channels. `width` and `height` are 1..2^20, and the tiles of all levels and layers
    /// at most 2^30. SHD_TABLE_RIPMAP and SHD_TABLE_SUMMED_AREA are built in memory, of all levels, when the texture is
    /// made; dropped tiles do not change them. The callback writes the mip levels too. `level_count` is their
    /// number, 0 = down to 1 x 1; `levels` is NULL. Coordinates are binary32 floats: beyond 65536 texels, filters have
    /// fewer than 8 bits for the fraction of a texel. SHD_PRECISION_FAST has no effect. SHD_FILTER_EXACT,
    /// shd_texture_explain() and shd_texture_bounds() wait for the tiles that they read, also with
    /// SHD_MISSING_TILES_COARSER.
    pub tiles: shd_tile_source,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_texture_desc>() == 136);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_texture_desc>() == 8);
init!(shd_texture_desc, SHD_DESC_KIND_TEXTURE_DESC);

/// Size, format and memory of a texture.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_texture_info {
    /// set by shd_texture_info_default()
    pub struct_size: u32,
    /// format of every level; RGBA for RGB8 to RGB32F, with _SRGB
    pub format: shd_format,
    /// texels of level 0
    pub width: u32,
    /// texels of level 0
    pub height: u32,
    /// images of the array
    pub layers: u32,
    /// 1; with SHD_TABLE_MIPMAP the number of levels down to 1 x 1, or the number of given
    /// levels + 1
    pub level_count: u32,
    /// tables of the texture
    pub tables: shd_table_flags,
    /// as in its desc
    pub flags: shd_texture_flags,
    /// bytes of all tables and of the data that shd_texture_update() keeps, without a borrowed
    /// base level
    pub byte_size: usize,
    /// slices of level 0; 0 = not a 3D texture
    pub depth: u32,
    /// as in its desc
    pub projection: shd_projection,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_texture_info>() == 48);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_texture_info>() == 8);
init!(shd_texture_info, SHD_DESC_KIND_TEXTURE_INFO);

/// Contents of a texture file.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_texture_file_info {
    /// set by shd_texture_file_info_default()
    pub struct_size: u32,
    /// file format
    pub kind: shd_texture_file_kind,
    /// storage in the file: VkFormat of KTX2; DXGI_FORMAT of DDS, 0 without such a number
    pub file_code: u32,
    /// compression around the levels; NONE for DDS
    pub supercompression: shd_supercompression,
    /// properties
    pub flags: shd_texture_file_flags,
    /// storage in the texture
    pub format: shd_format,
    /// texels of level 0
    pub width: u32,
    /// texels of level 0; 1 for a 1D texture
    pub height: u32,
    /// slices of level 0; 0 = not a 3D texture
    pub depth: u32,
    /// images of the array, or cube maps of an array of cube maps
    pub layers: u32,
    /// 6 for cube maps, otherwise 1
    pub faces: u32,
    /// levels in the file
    pub level_count: u32,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_texture_file_info>() == 48);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_texture_file_info>() == 4);
init!(shd_texture_file_info, SHD_DESC_KIND_TEXTURE_FILE_INFO);

/// Options of a KTX2 file that is written.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_ktx2_desc {
    /// set by shd_ktx2_desc_default()
    pub struct_size: u32,
    /// NONE, ZSTD or ZLIB; default NONE
    pub supercompression: shd_supercompression,
    /// 1..19 for ZSTD, 1..9 for ZLIB; default 0 = that of the library
    pub effort: i32,
    /// 3 = write r, g and b of a texture of four channels. Textures that are made of three channels have four, and the
    /// fourth is 0. Default 0 = all channels.
    pub channels: u32,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_ktx2_desc>() == 16);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_ktx2_desc>() == 4);
init!(shd_ktx2_desc, SHD_DESC_KIND_KTX2_DESC);

/// Size of a tile cache.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_tile_cache_desc {
    /// set by shd_tile_cache_desc_default()
    pub struct_size: u32,
    /// bytes of a tile, a power of two from 1024 to 2^20; default 65536
    pub tile_bytes: u32,
    /// All memory of the cache: tiles, their table, and places for copies of texels; from 4 tiles plus 64 KiB to 2^31
    /// bytes; default 2^28. It is allocated once. A small budget makes lookups slower, because tiles are loaded again.
    /// Half of the tiles can be pinned.
    pub budget_bytes: u64,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_tile_cache_desc>() == 16);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_tile_cache_desc>() == 8);
init!(shd_tile_cache_desc, SHD_DESC_KIND_TILE_CACHE_DESC);

/// A tile that a callback fills. Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_tile {
    /// layer, face, or slice of the level of a 3D texture
    pub layer: u32,
    /// 0 = the base level
    pub level: u32,
    /// first column of the level, a multiple of the width of whole tiles
    pub x: u32,
    /// first row of the level, a multiple of the height of whole tiles
    pub y: u32,
    /// texels to write in a row: the width of a tile, less at the right edge of the level
    pub width: u32,
    /// rows to write; fewer at the lower edge
    pub height: u32,
    /// rows of texels or of blocks, `row_stride` apart; aligned to 64 bytes; content undefined
    pub texels: *mut c_void,
    /// bytes between rows of texels or of blocks
    pub row_stride: usize,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_tile>() == 40);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_tile>() == 8);
init!(shd_tile);

/// Source of the tiles of a texture. Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_tile_source {
    /// retained; NULL = the texture has its texels in memory
    pub cache: *mut shd_tile_cache,
    /// required with `cache`
    pub load: shd_load_tiles_fn,
    /// called once, after the last `load`, when the texture is destroyed; may be
    /// NULL. It is not called if shd_texture_create() fails
    pub release: shd_tile_source_release_fn,
    /// passed to both; borrowed until release of the texture
    pub user_data: *mut c_void,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_tile_source>() == 32);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_tile_source>() == 8);
init!(shd_tile_source);

/// Counters of a tile cache since its creation.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_tile_cache_stats {
    /// set by shd_tile_cache_stats_default()
    pub struct_size: u32,
    /// bytes of a tile
    pub tile_bytes: u32,
    /// as in its desc
    pub budget_bytes: u64,
    /// memory of the cache, at most the budget; it does not change
    pub allocated_bytes: u64,
    /// tiles that fit
    pub tile_count: u32,
    /// tiles in memory now
    pub resident_tiles: u32,
    /// tiles that are pinned now
    pub pinned_tiles: u32,
    /// tiles that shd_tile_cache_load_requested() would load now
    pub requested_tiles: u32,
    /// calls of load callbacks
    pub loads: u64,
    /// tiles that callbacks wrote
    pub loaded_tiles: u64,
    /// tiles of calls that failed
    pub failed_tiles: u64,
    /// tiles that gave their place to others
    pub evicted_tiles: u64,
    /// waits of lookups for tiles that other threads loaded
    pub waits: u64,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_tile_cache_stats>() == 80);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_tile_cache_stats>() == 8);
init!(shd_tile_cache_stats, SHD_DESC_KIND_TILE_CACHE_STATS);

/// Options of a texture in a file. Required: cache.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_tile_file_desc {
    /// set by shd_tile_file_desc_default()
    pub struct_size: u32,
    /// meaning of 8-bit numbers; default AUTO = as declared by the file, sRGB if it
    /// declares nothing. Other numbers must be linear, or be declared so here
    pub color_space: shd_color_encoding,
    /// retained by the texture
    pub cache: *mut shd_tile_cache,
    /// open readers to keep, 1..4096; default 0 = 16. Each has a descriptor and some
    /// memory of OpenImageIO; more exist while more threads read. A KTX2 or DDS file
    /// has one descriptor for all threads
    pub max_readers: usize,
    /// colour of absent files of a set, linear; finite; default 0, 0, 0, 1
    pub fill: [f32; 4],
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_tile_file_desc>() == 40);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_tile_file_desc>() == 8);
init!(shd_tile_file_desc, SHD_DESC_KIND_TILE_FILE_DESC);

/// Files of a texture.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_tile_file_info {
    /// set by shd_tile_file_info_default()
    pub struct_size: u32,
    /// files of a set side by side; 1 for a file
    pub columns: u32,
    /// files of a set one above the other; 1 for a file
    pub rows: u32,
    /// files that exist
    pub files: u32,
    /// texels of a tile of a file. Caches whose tiles are as large or larger read each tile of
    /// a file once. KTX2 and DDS: 4 for blocks, 1 for pixels
    pub tile_width: u32,
    /// texels of a tile of a file
    pub tile_height: u32,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_tile_file_info>() == 24);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_tile_file_info>() == 4);
init!(shd_tile_file_info, SHD_DESC_KIND_TILE_FILE_INFO);

/// A rectangle of a level. Required: width, height.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_tile_region {
    /// set by shd_tile_region_default()
    pub struct_size: u32,
    /// layer, face, or slice of the level of a 3D texture; default 0
    pub layer: u32,
    /// 0..level_count - 1; default 0
    pub level: u32,
    /// first column, in texels of the level; default 0
    pub x: u32,
    /// first row; default 0
    pub y: u32,
    /// 1 or more; x + width is at most the width of the level
    pub width: u32,
    /// 1 or more; y + height is at most the height of the level
    pub height: u32,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_tile_region>() == 28);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_tile_region>() == 4);
init!(shd_tile_region, SHD_DESC_KIND_TILE_REGION);

/// Neighbouring vertices of one draw, one row each, as packed columns of `count` elements; borrowed for the call.
///
/// Every vertex of a triangle is processed for each instance of the draw, up to 512 vertices per call. It is processed
/// once, or once in each pass that needs it if the frame has several passes (shd_render_desc.pass_triangles). The
/// grouping of vertices and the order of calls are unspecified.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_vertices {
    /// size of the library's struct
    pub struct_size: u32,
    /// index into shd_render_desc.draws
    pub draw: u32,
    /// index into shd_draw.instances, 0 without instances
    pub instance: u32,
    /// row i is vertex first + i of the mesh
    pub first: u32,
    /// number of `attribute` columns
    pub attribute_count: u32,
    /// rows; must not be changed
    pub count: usize,
    /// position, object space
    pub px: *const f32,
    /// position, object space
    pub py: *const f32,
    /// position, object space
    pub pz: *const f32,
    /// normal, object space, unit
    pub nx: *const f32,
    /// normal, object space, unit
    pub ny: *const f32,
    /// normal, object space, unit
    pub nz: *const f32,
    /// tangent, object space, and handedness; NULL if the mesh has no tangents
    pub tx: *const f32,
    /// tangent, object space, and handedness; NULL if the mesh has no tangents
    pub ty: *const f32,
    /// tangent, object space, and handedness; NULL if the mesh has no tangents
    pub tz: *const f32,
    /// tangent, object space, and handedness; NULL if the mesh has no tangents
    pub tw: *const f32,
    /// texture coordinates; 0 if the mesh has none
    pub u: *const f32,
    /// texture coordinates; 0 if the mesh has none
    pub v: *const f32,
    /// second set of texture coordinates; NULL if the mesh has none
    pub u1: *const f32,
    /// second set of texture coordinates; NULL if the mesh has none
    pub v1: *const f32,
    /// \[attribute_count\] columns of the mesh; NULL for absent ones
    pub attribute: *const *const f32,
    /// \[16\], column-major; of the instance
    pub object_to_world: *const f32,
    /// \[16\], column-major
    pub world_to_view: *const f32,
    /// \[16\], column-major
    pub view_to_clip: *const f32,
    /// \[3\], world space
    pub eye: *const f32,
    /// shd_draw.uniforms
    pub uniforms: *const c_void,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_vertices>() == 192);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_vertices>() == 8);
init!(shd_vertices);

/// Values that a program may change, as packed columns of `count` elements.
///
/// Each column starts with the values that the draw has without a program. A vertex whose values stay unchanged gives
/// the same bits as without a program. Triangles with a vertex that has NaN or infinity in any column are dropped;
/// shd_render_stats.nonfinite counts them.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_vertex_outputs {
    /// size of the library's struct
    pub struct_size: u32,
    /// shd_material_desc.varying_count
    pub varying_count: u32,
    /// clip space: visible with -w..w for x and y, 0..w for z
    pub x: *mut f32,
    /// clip space: visible with -w..w for x and y, 0..w for z
    pub y: *mut f32,
    /// clip space: visible with -w..w for x and y, 0..w for z
    pub z: *mut f32,
    /// clip space: visible with -w..w for x and y, 0..w for z
    pub w: *mut f32,
    /// position, world space, for lighting and wo
    pub px: *mut f32,
    /// position, world space, for lighting and wo
    pub py: *mut f32,
    /// position, world space, for lighting and wo
    pub pz: *mut f32,
    /// normal, world space; changed normals are normalised afterwards
    pub nx: *mut f32,
    /// normal, world space; changed normals are normalised afterwards
    pub ny: *mut f32,
    /// normal, world space; changed normals are normalised afterwards
    pub nz: *mut f32,
    /// texture coordinates
    pub u: *mut f32,
    /// texture coordinates
    pub v: *mut f32,
    /// \[varying_count\] columns that start as 0
    pub varying: *const *mut f32,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_vertex_outputs>() == 112);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_vertex_outputs>() == 8);
init!(shd_vertex_outputs);

/// Transforms from world to clip space. Frozen, because it is a member of shd_render_desc. Later options of a picture
/// are appended to shd_render_desc.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_view {
    /// rigid, finite
    pub world_to_view: [f32; 16],
    /// projection, finite
    pub view_to_clip: [f32; 16],
    /// world space; viewing directions (wo) point to it
    pub eye: [f32; 3],
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_view>() == 140);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_view>() == 4);
init!(shd_view);

/// A perspective camera.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_camera {
    /// set by shd_camera_default()
    pub struct_size: u32,
    /// world space; default (0, 0, 3)
    pub eye: [f32; 3],
    /// world space, different from the eye; default 0
    pub target: [f32; 3],
    /// world space, any length, not along the line of sight; default (0, 1, 0)
    pub up: [f32; 3],
    /// vertical field of view \[rad\], (0, pi); default 0.8
    pub fov_y: f32,
    /// width / height, > 0; 0 = aspect of the picture, or 1 if there is no picture; default 0
    pub aspect: f32,
    /// distance, > 0; default 0.1
    pub near_plane: f32,
    /// distance, > near_plane; default 100
    pub far_plane: f32,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_camera>() == 56);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_camera>() == 4);
init!(shd_camera, SHD_DESC_KIND_CAMERA);

/// Density, transfer function, steps and shading of a volume. Required: point_count, texture, density, extinction.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_volume_desc {
    /// set by shd_volume_desc_default()
    pub struct_size: u32,
    /// points of the transfer function, 1..256
    pub point_count: u32,
    /// 3D texture; retained
    pub texture: *mut shd_texture,
    /// \[point_count\] densities of the points, -1e38..1e38, never decreasing. Values are
    /// interpolated between points; two points of one density are a jump
    pub density: shd_f32_in,
    /// \[point_count\] sigma \[1 / world unit\], 0..1e12
    pub extinction: shd_f32_in,
    /// \[point_count\] scene-linear r, g, b, 0..1e6: radiance, or the diffuse colour of
    /// `material`; absent = 1
    pub color: [shd_f32_in; 3],
    /// Shades the points by the lights of the frame, with shadows and cookies, but not by its environment: an opaque
    /// material without slots and debug view, of a model that reflects light; others are SHD_ERROR_UNSUPPORTED. Its
    /// diffuse colour is multiplied by `color`. The normal is the direction in which density falls fastest, by central
    /// differences over two texels; it faces the viewer where the gradient is 0, and always with
    /// SHD_MATERIAL_DOUBLE_SIDED. NULL = `color` is radiance; retained.
    pub material: *mut shd_material,
    /// corner of the texture's (0, 0, 0) in object space, finite; default 0
    pub box_min: [f32; 3],
    /// corner of the texture's (1, 1, 1); above box_min on each axis; default 1
    pub box_max: [f32; 3],
    /// length of a step \[world units\], above 0, at most 1e12; default 1/256
    pub step: f32,
    /// the point of a step lies at a fraction 1/2 + jitter (h - 1/2) of the step, with h in \[0, 1) hashed
    /// from the pixel of the picture and `seed`; 0..1; default 0
    pub jitter: f32,
    /// seed of the jitter; default 0
    pub seed: u32,
    /// reserved; 0
    pub flags: u32,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_volume_desc>() == 144);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_volume_desc>() == 8);
init!(shd_volume_desc, SHD_DESC_KIND_VOLUME_DESC);

/// One volume in the frame. Required: volume.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_volume_draw {
    /// set by shd_volume_draw_default(); the same in every element of the array
    pub struct_size: u32,
    /// borrowed for the call
    pub volume: *const shd_volume,
    /// affine, finite, invertible; default identity
    pub object_to_world: [f32; 16],
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_volume_draw>() == 80);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_volume_draw>() == 8);
init!(shd_volume_draw, SHD_DESC_KIND_VOLUME_DRAW);

/// Layout of a file of voxels. Required: width, height, depth.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_raw_desc {
    /// set by shd_raw_desc_default()
    pub struct_size: u32,
    /// voxels along x, 1..65536; width * height * depth at most 2^28
    pub width: u32,
    /// voxels along y, 1..65536
    pub height: u32,
    /// voxels along z, 1..65536
    pub depth: u32,
    /// default SHD_RAW_SAMPLE_U8
    pub sample: shd_raw_sample,
    /// numbers of a voxel, one behind the other, 1..4; default 1
    pub channels: u32,
    /// default SHD_BYTE_ORDER_LITTLE
    pub byte_order: shd_byte_order,
    /// reserved; 0
    pub flags: u32,
    /// bytes before the first voxel, or SHD_RAW_HEADER_REST; default 0
    pub header_bytes: u64,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_raw_desc>() == 40);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_raw_desc>() == 8);
init!(shd_raw_desc, SHD_DESC_KIND_RAW_DESC);

/// Files of a stack. Required: either paths and path_count, or pattern.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_stack_desc {
    /// set by shd_stack_desc_default()
    pub struct_size: u32,
    /// number of `paths`, 0..65536
    pub path_count: u32,
    /// \[path_count\] files, slice 0 first; of a single file all pages are slices
    pub paths: *const *const c_char,
    /// A path with one place for a number, instead of `paths`: %d, %5d (padded by spaces to five characters) or %05d
    /// (by zeros); %% is a percent sign. Slice k is the file of the number first + k.
    pub pattern: *const c_char,
    /// number of slice 0 of `pattern`; default 0
    pub first: u32,
    /// number of the last slice, first..first + 65535; default 0
    pub last: u32,
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_stack_desc>() == 32);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_stack_desc>() == 8);
init!(shd_stack_desc, SHD_DESC_KIND_STACK_DESC);

/// Grid and box of an OpenVDB load.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_vdb_desc {
    /// set by shd_vdb_desc_default()
    pub struct_size: u32,
    /// default none
    pub flags: shd_vdb_flags,
    /// name, at most 255 bytes; default NULL = the first grid of float or double
    pub grid: *const c_char,
    /// first voxel of the box, in index space, -2^30..2^30; read with SHD_VDB_BOX
    pub box_min: [i32; 3],
    /// last voxel of the box, at least box_min on each axis; read with SHD_VDB_BOX
    pub box_max: [i32; 3],
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_vdb_desc>() == 40);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_vdb_desc>() == 8);
init!(shd_vdb_desc, SHD_DESC_KIND_VDB_DESC);

/// Properties of a loaded grid.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct shd_vdb_info {
    /// set by shd_vdb_info_default()
    pub struct_size: u32,
    /// as declared by the file
    pub grid_class: shd_vdb_class,
    /// voxel of texel (0, 0, 0), in index space
    pub index_min: [i32; 3],
    /// value of all voxels that the file does not store
    pub background: f32,
    /// in the whole grid
    pub active_voxels: u64,
    /// from texture coordinates (u, v, w) to the world of the file, column-major: for
    /// shd_volume_draw, if the box of the volume is the default box
    pub object_to_world: [f32; 16],
    /// name of the grid; its first 63 bytes, control characters replaced
    pub grid: [c_char; 64],
}
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::size_of::<shd_vdb_info>() == 160);
#[cfg(target_pointer_width = "64")]
const _: () = assert!(core::mem::align_of::<shd_vdb_info>() == 8);
init!(shd_vdb_info, SHD_DESC_KIND_VDB_INFO);

extern "C" {
    /// Shade the surfaces of draws into a framebuffer at their texture coordinates.
    ///
    /// A bake reads these fields of the frame: the framebuffer (with one sample per pixel), clear_color, camera or view,
    /// draws, lights, shadows, environment with its intensity and rotation, progress and stats. The view gives the eye.
    /// Vertex programs run; their clip positions have no effect. The other fields must have their defaults, except
    /// pass_triangles, which has no effect: all triangles are processed together. Depth becomes 1, and overdraw stays 0.
    ///
    /// Every draw has a material. Its colour replaces that of the texel: blends have no effect, and a is the opacity of the
    /// material. Fragments that a program or the alpha test drops leave their texel empty. SHD_MATERIAL_DOUBLE_SIDED and
    /// _ALPHA_TO_COVERAGE, and cull, fill, compare, depth biases and flags of a draw have no effect. The bits of the result
    /// do not depend on workers or SIMD targets.
    ///
    /// - `context`: its executor, allocator and SIMD target do the work; the objects may come from any context
    /// - `frame`: borrowed for the call
    /// - `desc`: borrowed for the call; NULL = all defaults
    pub fn shd_bake(context: *mut shd_context, frame: *const shd_render_desc, desc: *const shd_bake_desc) -> shd_result;
    /// Version of the library that is running: major \<\< 16 | minor \<\< 8 | patch.
    ///
    /// It may differ from SHD_VERSION_*, which is the version of the headers.
    pub fn shd_version() -> u32;
    /// Get the precision that the rules of a graphics API require at least.
    ///
    /// - `rules`: one of shd_rules
    /// - `out_desc`: its struct_size is read; the rest is written, all zero on failure
    pub fn shd_bounds_preset(rules: shd_rules, out_desc: *mut shd_bounds_desc) -> shd_result;
    /// Compute the legal values of `lookups->count` lookups.
    ///
    /// - `texture`: concurrent reads
    /// - `sampler`: may come from another context
    /// - `lookups`: columns, borrowed for the call
    /// - `desc`: borrowed for the call; NULL = all defaults
    /// - `lower`: smallest legal values; columns of `channel` only, which must not overlap any input or each other
    /// (checked)
    /// - `upper`: largest legal values, as `lower`
    pub fn shd_texture_bounds(texture: *const shd_texture, sampler: *const shd_sampler, lookups: *const shd_lookups, desc: *const shd_bounds_desc, lower: *mut shd_texels, upper: *mut shd_texels) -> shd_result;
    /// Make a context.
    ///
    /// - `desc`: options, borrowed for the call; NULL = all defaults
    /// - `out_context`: owned; NULL on failure
    pub fn shd_context_create(desc: *const shd_context_desc, out_context: *mut *mut shd_context) -> shd_result;
    /// Add a reference; NULL is ignored. Any thread.
    pub fn shd_context_retain(context: *mut shd_context);
    /// Drop a reference; NULL is ignored. Objects hold references too; the last release frees everything. Any thread.
    pub fn shd_context_release(context: *mut shd_context);
    /// Return the working memory that the context keeps between calls to the allocator. Calls that run at the same time
    /// keep theirs. NULL is ignored. Any thread.
    pub fn shd_context_trim(context: *mut shd_context);
    /// Name of the SIMD target of the context's kernels, such as "AVX2"; "" for a bad handle. Static.
    pub fn shd_context_simd_target(context: *const shd_context) -> *const c_char;
    /// Number of workers of the executor, at least 1; 0 for a bad handle.
    pub fn shd_context_worker_count(context: *const shd_context) -> u32;
    /// Write the defaults of a sized struct into the caller's memory and set its struct_size.
    ///
    /// SHD_ERROR_INVALID_ARGUMENT for an unknown kind, a NULL pointer, or a size that lacks required fields or is
    /// not a multiple of the alignment of the struct
    ///
    /// - `kind`: the struct that `ptr` points at
    /// - `ptr`: the caller's struct, aligned for it
    /// - `size`: size in bytes of the caller's struct. If it is smaller than the library's struct, only the fields inside
    /// it are written; it must contain every required field. If it is larger, the remaining bytes become
    /// zero
    pub fn shd_desc_init(kind: shd_desc_kind, ptr: *mut c_void, size: usize) -> shd_result;
    /// Find all edges of the requested kinds in a mesh. Each edge is listed once, in the order of the edges' first
    /// triangles.
    ///
    /// The result has the same bits on every machine.
    ///
    /// - `mesh`: made with SHD_MESH_ADJACENCY
    /// - `desc`: borrowed for the call
    /// - `capacity`: elements of the columns; 0 to count edges
    /// - `out`: gets the first `capacity` edges; may be NULL if capacity is 0
    /// - `out_count`: number of edges found, which may exceed `capacity`; 0 on failure
    pub fn shd_mesh_find_edges(mesh: *const shd_mesh, desc: *const shd_edges_desc, capacity: usize, out: *const shd_edges, out_count: *mut usize) -> shd_result;
    /// Make an environment on the executor of the context.
    ///
    /// Kept: 11 bytes for each of 1 to 4 texels a pixel, of at least 64^2 (12 bytes each) and at most 2048^2 texels, and
    /// 4.2 MB or less for each kind of lobe. Temporary: 16 bytes a pixel, 224 bytes a row, and twice the bytes kept. Fixed:
    /// lobes and CONVOLVED take up to 12 MB of temporary memory more. Maps hold three channels of 16 bits with a common
    /// exponent: errors of up to 2^-16 of the largest channel.
    ///
    /// - `context`: retained
    /// - `desc`: borrowed for the call
    /// - `out_environment`: owned; NULL on failure
    pub fn shd_environment_create(context: *mut shd_context, desc: *const shd_environment_desc, out_environment: *mut *mut shd_environment) -> shd_result;
    /// Add a reference; NULL is ignored. Any thread.
    pub fn shd_environment_retain(environment: *mut shd_environment);
    /// Drop a reference; NULL is ignored. Any thread.
    pub fn shd_environment_release(environment: *mut shd_environment);
    /// Get the properties of an environment.
    ///
    /// - `out_info`: its struct_size is read; the rest is written, all zero on failure
    pub fn shd_environment_get_info(environment: *const shd_environment, out_info: *mut shd_environment_info) -> shd_result;
    /// Look up the irradiance of surfaces whose normals are the directions, on the executor of the environment's context.
    ///
    /// - `lookups`: columns, borrowed for the call, without roughness and exponent
    /// - `out`: columns, borrowed for the call; must not overlap any input or each other (checked)
    pub fn shd_environment_irradiance(environment: *const shd_environment, lookups: *const shd_environment_lookups, out: *const shd_environment_light) -> shd_result;
    /// Look up the radiance, or its mean over lobes, on the executor of the environment's context.
    ///
    /// - `lookups`: columns, borrowed for the call, with at most one of roughness and exponent
    /// - `out`: columns, borrowed for the call; must not overlap any input or each other (checked)
    pub fn shd_environment_radiance(environment: *const shd_environment, lookups: *const shd_environment_lookups, out: *const shd_environment_light) -> shd_result;
    /// Explain lookup `index` of a batch. Call once without memory for the counts, then again with it.
    ///
    /// - `texture`: concurrent reads
    /// - `sampler`: any filter except SUMMED_AREA and EXACT (SHD_ERROR_UNSUPPORTED)
    /// - `lookups`: as for shd_texture_sample, borrowed for the call
    /// - `index`: 0..lookups->count - 1
    /// - `explanation`: its tables are borrowed for the call
    pub fn shd_texture_explain(texture: *const shd_texture, sampler: *const shd_sampler, lookups: *const shd_lookups, index: usize, explanation: *mut shd_explanation) -> shd_result;
    /// Store `message` as the calling thread's shd_last_error() and return `result`.
    ///
    /// The message is copied and cut at 1023 bytes. It is not a format string.
    pub fn shd_report_error(result: shd_result, message: *const c_char) -> shd_result;
    /// Allocate from the context's allocator.
    ///
    /// NULL if the allocator fails, size is 0, alignment is not a power of two (0 counts as 8) or the handle is bad
    pub fn shd_context_allocate(context: *mut shd_context, size: usize, alignment: usize) -> *mut c_void;
    /// Free memory with the size and alignment of its allocation; NULL is ignored.
    pub fn shd_context_free(context: *mut shd_context, memory: *mut c_void, size: usize, alignment: usize);
    /// Write a line to the context's log.
    pub fn shd_context_log(context: *mut shd_context, level: shd_log_level, message: *const c_char);
    /// Run tasks on the context's executor, with IEEE default floating-point control.
    pub fn shd_context_parallel_for(context: *mut shd_context, count: u32, task: shd_task_fn, task_data: *mut c_void) -> shd_result;
    /// Make a handle in the context's slabs, with one owned reference.
    ///
    /// - `type`: four characters that name the type, such as 'COLR', packed big-endian; above 0xffff
    /// - `body`: the object behind the handle
    /// - `destroy`: called with `body` by the thread that releases the last reference; must not throw
    /// - `out_object`: owned; NULL on failure, and then `destroy` is not called
    pub fn shd_object_create(context: *mut shd_context, r#type: u32, body: *mut c_void, destroy: shd_object_create_destroy_fn, out_object: *mut *mut shd_object) -> shd_result;
    /// Body of a live handle of that type; NULL, with the error text set, for any other pointer value.
    pub fn shd_object_body(object: *const shd_object, r#type: u32) -> *mut c_void;
    /// Context of a handle; borrowed; NULL for a bad handle.
    pub fn shd_object_context(object: *const shd_object) -> *mut shd_context;
    /// Context of a framebuffer; borrowed; NULL for a bad handle.
    pub fn shd_framebuffer_context(framebuffer: *const shd_framebuffer) -> *mut shd_context;
    /// Add a reference; NULL is ignored.
    pub fn shd_object_retain(object: *mut shd_object, r#type: u32);
    /// Drop a reference; NULL is ignored.
    pub fn shd_object_release(object: *mut shd_object, r#type: u32);
    /// Compute derivatives from ray differentials.
    ///
    /// The change of the hit point is d(o + t d) + dt d, with dt chosen so that it lies in the surface. It is then expressed
    /// in dp/du and dp/dv (Igehy, "Tracing Ray Differentials", 1999, sections 3.1 and 3.2).
    ///
    /// - `rays`: columns, borrowed for the call
    /// - `out`: columns, borrowed for the call; must not overlap any input or each other (checked)
    pub fn shd_derivatives_from_differentials(rays: *const shd_ray_differentials, out: *const shd_derivatives) -> shd_result;
    /// Compute derivatives from ray cones.
    ///
    /// The derivatives are the axes of the ellipse in which the cone meets the surface: along the projected direction (x)
    /// and across it (y). Each is as long as the ellipse in its direction (Akenine-Moller et al., "Improved Shader and
    /// Texture Level of Detail Using Ray Cones", 2021, section 5). Angles between ray and surface below 2^-10 rad count as
    /// 2^-10 rad.
    ///
    /// - `cones`: columns, borrowed for the call
    /// - `out`: columns, borrowed for the call; must not overlap any input or each other (checked)
    pub fn shd_derivatives_from_cones(cones: *const shd_ray_cones, out: *const shd_derivatives) -> shd_result;
    /// Make a framebuffer: colour 0, depth 1, AOVs 0, triangle and draw 0xffffffff.
    ///
    /// - `context`: retained
    /// - `desc`: borrowed for the call
    /// - `out_framebuffer`: owned; NULL on failure
    pub fn shd_framebuffer_create(context: *mut shd_context, desc: *const shd_framebuffer_desc, out_framebuffer: *mut *mut shd_framebuffer) -> shd_result;
    /// Add a reference; NULL is ignored. Any thread.
    pub fn shd_framebuffer_retain(framebuffer: *mut shd_framebuffer);
    /// Drop a reference; NULL is ignored. Any thread.
    pub fn shd_framebuffer_release(framebuffer: *mut shd_framebuffer);
    /// Get size and planes of a framebuffer.
    ///
    /// - `out_info`: its struct_size is read; the rest is written, all zero on failure
    pub fn shd_framebuffer_get_info(framebuffer: *const shd_framebuffer, out_info: *mut shd_framebuffer_info) -> shd_result;
    /// Get the position of a sample in its pixel. Positions and order are the standard sample locations of the Vulkan 1.3
    /// specification ("Multisampling"), which are those of Direct3D 11's standard pattern. They are multiples of 1/16 pixel.
    ///
    /// - `samples`: samples of a pixel: 1, 2, 4, 8 or 16
    /// - `index`: number of the sample, 0..samples - 1
    /// - `out_x`: pixels from the left edge of the pixel; 0 on failure
    /// - `out_y`: pixels from the top edge of the pixel; 0 on failure
    pub fn shd_sample_position(samples: u32, index: u32, out_x: *mut f32, out_y: *mut f32) -> shd_result;
    /// Get a plane without copying.
    ///
    /// - `out_view`: its struct_size is read; the rest is written. Borrowed until release of the framebuffer; the next
    /// shd_render changes its contents. All zero on failure; a plane that the framebuffer does not have is
    /// SHD_ERROR_NOT_FOUND
    pub fn shd_framebuffer_view_plane(framebuffer: *const shd_framebuffer, plane: shd_plane, out_view: *mut shd_plane_view) -> shd_result;
    /// Get interleaved colour without copying.
    ///
    /// - `out_view`: its struct_size is read; the rest is written: an image of the framebuffer's size and color_format.
    /// Its pixels must not be written. They are borrowed until release of the framebuffer; the next
    /// shd_render changes them. All zero on failure; SHD_ERROR_NOT_FOUND for color_format
    /// SHD_FORMAT_RGBA32F, whose colour is planes
    pub fn shd_framebuffer_view_color(framebuffer: *const shd_framebuffer, out_view: *mut shd_image) -> shd_result;
    /// Copy a float plane into a column. R, G, B and A are decoded to linear floats if colour is interleaved.
    ///
    /// - `out`: column of width * height elements, row by row from the top. A stride writes one channel of an interleaved
    /// image
    pub fn shd_framebuffer_read_plane(framebuffer: *const shd_framebuffer, plane: shd_plane, out: *const shd_f32_out) -> shd_result;
    /// Copy a plane of uint32_t into a column.
    ///
    /// - `out`: column of width * height elements, row by row from the top
    pub fn shd_framebuffer_read_u32_plane(framebuffer: *const shd_framebuffer, plane: shd_plane, out: *const shd_u32_out) -> shd_result;
    /// Copy colour as interleaved RGBA. Pixels of the framebuffer's own color_format are copied bit by bit.
    ///
    /// Colour stays linear, except that SHD_FORMAT_RGBA8_SRGB is encoded. Integer formats clamp to 0..1 (NaN to 0) and round
    /// to nearest; sRGB codes are the correctly rounded ones of IEC 61966-2-1.
    ///
    /// - `out`: RGBA8, RGBA8_SRGB, RGBA16, RGBA16F or RGBA32F image of the framebuffer's size
    pub fn shd_framebuffer_read_color(framebuffer: *const shd_framebuffer, out: *const shd_image) -> shd_result;
    /// Bytes of one pixel; 0 for an unknown format, and for formats of blocks. Any thread.
    pub fn shd_format_size(format: shd_format) -> usize;
    /// Bytes of one block of 4 x 4 texels: 8 or 16; 0 for formats of pixels, and unknown ones. Any thread.
    pub fn shd_format_block_size(format: shd_format) -> usize;
    /// Make a light.
    ///
    /// - `context`: retained
    /// - `desc`: borrowed for the call; NULL = all defaults
    /// - `out_light`: owned; NULL on failure
    pub fn shd_light_create(context: *mut shd_context, desc: *const shd_light_desc, out_light: *mut *mut shd_light) -> shd_result;
    /// Add a reference; NULL is ignored. Any thread.
    pub fn shd_light_retain(light: *mut shd_light);
    /// Drop a reference; NULL is ignored. Any thread.
    pub fn shd_light_release(light: *mut shd_light);
    /// Filter `lookups->count` points of a texture.
    ///
    /// - `texture`: concurrent reads
    /// - `sampler`: may come from another context
    /// - `lookups`: columns, borrowed for the call
    /// - `out`: columns, borrowed for the call; must not overlap any input or each other (checked)
    pub fn shd_texture_sample(texture: *const shd_texture, sampler: *const shd_sampler, lookups: *const shd_lookups, out: *mut shd_texels) -> shd_result;
    /// Compute the levels of detail of `lookups->count` points, as trilinear filtering uses them.
    ///
    /// - `texture`: concurrent reads
    /// - `sampler`: its bias, clamps, width, blur and profile are used; its filter has no effect
    /// - `lookups`: columns, borrowed for the call
    /// - `out`: columns, borrowed for the call; must not overlap any input or each other (checked)
    pub fn shd_texture_query_levels(texture: *const shd_texture, sampler: *const shd_sampler, lookups: *const shd_lookups, out: *const shd_levels) -> shd_result;
    /// Make a material.
    ///
    /// - `context`: retained
    /// - `desc`: borrowed for the call; NULL = all defaults
    /// - `out_material`: owned; NULL on failure
    pub fn shd_material_create(context: *mut shd_context, desc: *const shd_material_desc, out_material: *mut *mut shd_material) -> shd_result;
    /// Add a reference; NULL is ignored. Any thread.
    pub fn shd_material_retain(material: *mut shd_material);
    /// Drop a reference; NULL is ignored. Any thread.
    pub fn shd_material_release(material: *mut shd_material);
    /// Copy and check vertices and indices; compute normals if there are none.
    ///
    /// The call refuses these inputs, and the error text names the element: an index >= vertex_count, an index count that is
    /// not a multiple of 3 (SHD_TOPOLOGY_TRIANGLES), a position that is not finite (unless SHD_MESH_KEEP_NONFINITE).
    /// Normals, uv, tangents and attributes that are not finite count as 0.
    ///
    /// tangents
    /// Tangents: the tangent t points towards increasing u, in the plane of the normal n. The bitangent is handedness *
    /// cross(n, t) and points towards decreasing v, up in the picture, as in glTF 2.0.
    ///
    /// SHD_MESH_TANGENTS computes them to the MikkTSpace convention (Mikkelsen, "Simulation of Wrinkled Surfaces Revisited",
    /// 2008) for (u, 1 - v). Vertices of equal position, normal and uv count as one. The directions of the triangles around
    /// it are weighted by angle, and triangles with mirrored uv stay apart. A vertex is split where mirrored and other
    /// triangles meet, and where it belongs to several fans that share no edge. The first part keeps the caller's vertex
    /// number. The copies have the other tangents; they follow the caller's vertices in the order of their originals. One
    /// rule differs from Mikkelsen's generator: at its threshold of 180 degrees it leaves a triangle out of a corner's sum
    /// if their directions are exactly opposite after rounding. Here each triangle of a fan counts for all its corners, so
    /// that folded or stretched uv do not split vertices.
    ///
    /// Triangles without area in uv, or with two corners at the same position, use the tangent of their neighbours at each
    /// vertex. A vertex without any tangent gets a unit vector perpendicular to n: the x axis projected into the plane of n,
    /// or the y axis where |n.x| > 0.9. Such a vertex has degenerate or missing uv, has no triangles, or has directions that
    /// cancel. Its handedness is 1, or -1 where all its triangles are mirrored.
    ///
    /// - `context`: retained
    /// - `desc`: borrowed for the call
    /// - `out_mesh`: owned; NULL on failure
    pub fn shd_mesh_create(context: *mut shd_context, desc: *const shd_mesh_desc, out_mesh: *mut *mut shd_mesh) -> shd_result;
    /// Make the mesh of a shape: shd_shape_fill() and shd_mesh_create() in one call.
    ///
    /// - `context`: retained
    /// - `desc`: borrowed for the call; NULL = all defaults, a sphere of radius 1
    /// - `flags`: as shd_mesh_desc.flags
    /// - `out_mesh`: owned; NULL on failure
    pub fn shd_mesh_create_shape(context: *mut shd_context, desc: *const shd_shape_desc, flags: shd_mesh_flags, out_mesh: *mut *mut shd_mesh) -> shd_result;
    /// Add a reference; NULL is ignored. Any thread.
    pub fn shd_mesh_retain(mesh: *mut shd_mesh);
    /// Drop a reference; NULL is ignored. Any thread.
    pub fn shd_mesh_release(mesh: *mut shd_mesh);
    /// Get counts and bounds of a mesh.
    ///
    /// - `out_info`: its struct_size is read; the rest is written, all zero on failure
    pub fn shd_mesh_get_info(mesh: *const shd_mesh, out_info: *mut shd_mesh_info) -> shd_result;
    /// Copy the positions out, object space.
    ///
    /// - `out`: \[3\] columns x, y, z of shd_mesh_info.vertex_count elements; NULL data = not wanted
    pub fn shd_mesh_read_positions(mesh: *const shd_mesh, out: *const shd_f32_out) -> shd_result;
    /// Copy the unit vertex normals out, given or computed.
    ///
    /// - `out`: \[3\] columns x, y, z of shd_mesh_info.vertex_count elements; NULL data = not wanted
    pub fn shd_mesh_read_normals(mesh: *const shd_mesh, out: *const shd_f32_out) -> shd_result;
    /// Copy the tangents out, given or computed; 0 if the mesh has none.
    ///
    /// - `out`: \[4\] columns x, y, z and handedness of shd_mesh_info.vertex_count elements; NULL data = not wanted
    pub fn shd_mesh_read_tangents(mesh: *const shd_mesh, out: *const shd_f32_out) -> shd_result;
    /// Copy the texture coordinates out; 0 if the mesh has none.
    ///
    /// - `out`: \[2\] columns u, v of shd_mesh_info.vertex_count elements; NULL data = not wanted
    pub fn shd_mesh_read_uv(mesh: *const shd_mesh, out: *const shd_f32_out) -> shd_result;
    /// Copy the second set of texture coordinates out; 0 if the mesh has none.
    ///
    /// - `out`: \[2\] columns u, v of shd_mesh_info.vertex_count elements; NULL data = not wanted
    pub fn shd_mesh_read_uv1(mesh: *const shd_mesh, out: *const shd_f32_out) -> shd_result;
    /// Copy one of the caller's own columns out; 0 if it was absent.
    ///
    /// - `index`: 0..SHD_MAX_ATTRIBUTES - 1
    /// - `out`: column of shd_mesh_info.vertex_count elements
    pub fn shd_mesh_read_attribute(mesh: *const shd_mesh, index: u32, out: *const shd_f32_out) -> shd_result;
    /// Copy the indices out as separate triangles, also for strips and fans.
    ///
    /// - `out`: column of 3 * shd_mesh_info.triangle_count elements, each below shd_mesh_info.vertex_count
    pub fn shd_mesh_read_indices(mesh: *const shd_mesh, out: *const shd_u32_out) -> shd_result;
    /// Make mip levels 1..level_count of an image, in the caller's memory, on the context's executor.
    ///
    /// With the defaults the levels are those of SHD_TABLE_MIPMAP. Results are clamped to the range of the format, because
    /// kernels with negative lobes can exceed it. Finite texels give finite levels.
    ///
    /// - `base`: at most 2^28 pixels; borrowed for the call
    /// - `desc`: borrowed for the call
    /// - `level_count`: 0..floor(log2(max(width, height)))
    /// - `levels`: \[level_count\], all with the same struct_size; level l is levels\[l - 1\]: the format of the base,
    /// max(1, width >> l) by max(1, height >> l). Pixels are written; they are unspecified if an
    /// allocation or the executor fails. They must not overlap each other or the base (checked)
    pub fn shd_mip_build(context: *mut shd_context, base: *const shd_image, desc: *const shd_mip_desc, level_count: u32, levels: *const shd_image) -> shd_result;
    /// Turn a normal map into the moments of its slopes, whose averages keep the roughness of normals.
    ///
    /// A texel is (bx, by, bx^2, by^2) with (bx, by) = (nx / nz, ny / nz), and bx by in an image of its own (Olano and
    /// Baker, "LEAN Mapping", 2010, section 3). Build the levels of the results as SHD_TEXEL_CONTENT_DATA; any filter may
    /// read them. A filtered texel (bx, by, Mxx, Myy) and Mxy give the mean normal normalise(bx, by, 1) and the covariance
    /// of slopes (Mxx - bx^2, Mxy - bx by; Mxy - bx by, Myy - by^2), over which lobes are averaged (shd_normal_encoding).
    ///
    /// nz is raised to at least 1/32 of the normal's length, so |bx| and |by| are at most 32. Normals that point backwards
    /// are limited in the same way. A texel that is 0 or not finite becomes flat: four zeros.
    ///
    /// - `normals`: three or four channels, as for SHD_TEXEL_CONTENT_NORMAL, of any length; borrowed for the call
    /// - `out`: an image of that width and height, SHD_FORMAT_RGBA16F or SHD_FORMAT_RGBA32F. Pixels are written; they
    /// are unspecified if the executor fails. They must not overlap `normals` (checked)
    /// - `mixed`: bx by, for SHD_SLOT_NORMAL_MIXED: as `out`, but SHD_FORMAT_R16F or SHD_FORMAT_R32F. NULL = not wanted
    pub fn shd_normal_moments(context: *mut shd_context, normals: *const shd_image, out: *const shd_image, mixed: *const shd_image) -> shd_result;
    /// Compute the occlusion of points.
    ///
    /// - `context`: its executor, allocator and SIMD target do the work; the objects may come from any context
    /// - `desc`: borrowed for the call
    /// - `out`: column of points->count elements; must not overlap the points (checked)
    pub fn shd_occlusion_compute(context: *mut shd_context, desc: *const shd_occlusion_desc, points: *const shd_occlusion_points, out: *const shd_f32_out) -> shd_result;
    /// Compute the occlusion of the vertices of a draw, with their vertex normals. Its mesh and object_to_world are read.
    ///
    /// - `context`: as in shd_occlusion_compute()
    /// - `desc`: borrowed for the call; the draw occludes only if it is among the occluders
    /// - `draw`: borrowed for the call; without instances
    /// - `out`: column of shd_mesh_info.vertex_count elements
    pub fn shd_occlusion_compute_vertices(context: *mut shd_context, desc: *const shd_occlusion_desc, draw: *const shd_draw, out: *const shd_f32_out) -> shd_result;
    /// Compute the occlusion of the texels of a texture, each at the point where shd_bake() shades it.
    ///
    /// Takes about 100 bytes of working memory for each texel.
    ///
    /// - `context`: as in shd_occlusion_compute()
    /// - `desc`: borrowed for the call
    /// - `atlas`: borrowed for the call
    /// - `out`: column of width * height elements, row by row from the top: packed, an image of SHD_FORMAT_R32F
    pub fn shd_occlusion_bake(context: *mut shd_context, desc: *const shd_occlusion_desc, atlas: *const shd_occlusion_atlas, out: *const shd_f32_out) -> shd_result;
    /// Compute the barycentric coordinates of points.
    ///
    /// SHD_ERROR_UNSUPPORTED for HARMONIC in a build without Eigen; SHD_ERROR_OUT_OF_MEMORY; a polygon that is too
    /// thin for the triangles of HARMONIC is SHD_ERROR_INVALID_ARGUMENT
    ///
    /// - `context`: executor and memory; NULL = the calling thread and malloc. The solver of HARMONIC also uses malloc
    /// - `desc`: columns, borrowed for the call
    /// - `points`: columns, borrowed for the call
    /// - `out`: columns, borrowed for the call; must not overlap any input or each other (checked)
    pub fn shd_polygon_evaluate(context: *const shd_context, desc: *const shd_polygon_desc, points: *const shd_polygon_points, out: *mut shd_polygon_weights) -> shd_result;
    /// Project directions to points of an image, with derivatives.
    ///
    /// u and v are within 3e-7 of the exact values. Derivatives are those of the formulas above. Angles below 2^-50 rad
    /// from the poles of LAT_LONG and from the rim of MIRROR_BALL and ANGULAR, where a derivative goes to infinity, count as
    /// 2^-50 rad. NaN derivatives of directions count as 0, and so do finite components beside infinite ones. A component
    /// below 2^-100 of the largest one of its derivative may count as 0.
    ///
    /// - `context`: its executor and SIMD target are used; concurrent reads
    /// - `directions`: columns, borrowed for the call
    /// - `out`: columns, borrowed for the call; must not overlap any input or each other (checked)
    pub fn shd_project_directions(context: *mut shd_context, directions: *const shd_directions, out: *mut shd_projected_points) -> shd_result;
    /// Compute the directions of points of an image.
    ///
    /// The components of directions are within 4e-7 of the exact values; at a distance e from the rim of MIRROR_BALL, within
    /// 4e-7 + 1e-7 / sqrt(2 e). Solid angles are within 1e-5 of their largest value.
    ///
    /// - `context`: its executor and SIMD target are used; concurrent reads
    /// - `points`: columns, borrowed for the call
    /// - `out`: columns, borrowed for the call; must not overlap any input or each other (checked)
    pub fn shd_unproject_directions(context: *mut shd_context, points: *const shd_image_points, out: *mut shd_point_directions) -> shd_result;
    /// Convert images of directions to another projection, layout, size or format.
    ///
    /// Faces of the same projection and size are copied. Otherwise each texel becomes the average over its solid angle of
    /// the bilinear lookups of the source, in linear light. Samples along u and along v are at most half as far apart as the
    /// texels of the source (measured at the narrowest ones; on the equator of LAT_LONG; from LAT_LONG to LAT_LONG in
    /// columns), with at least 2 x 2 in each texel, weighted by their solid angle. Near the rim of a MIRROR_BALL target they
    /// are this far apart on average. LAT_LONG sources with far more texels along one axis than a target texel can resolve
    /// along both are averaged along it first, so that the work is at most about 64 samples for each pixel of the target and
    /// 16 for each pixel of the source. Equal texels give exactly their value. The integral over the sphere is kept to the
    /// rounding of the format and the error of the samples: docs/environments.md has measurements. Texels of MIRROR_BALL and
    /// ANGULAR outside the disc continue the image across the rim, so that bilinear lookups and mip levels there have no
    /// border. Unused parts of crosses become 0. Channels that the source lacks are 0, alpha 1; channels that the target
    /// lacks are dropped.
    ///
    /// - `context`: its executor and SIMD target are used; its allocator provides 16 bytes for each pixel of the source
    /// - `from`: source; at most 2^26 pixels
    /// - `to`: target; at most 2^26 pixels; its pixels are written; they must not overlap other images (checked)
    pub fn shd_projection_convert(context: *mut shd_context, from: *const shd_direction_images, to: *const shd_direction_images) -> shd_result;
    /// Render a frame.
    ///
    /// On SHD_ERROR_OUT_OF_MEMORY, SHD_ERROR_CALLBACK or SHD_ERROR_CANCELLED the framebuffer may hold a part of
    /// the frame; all other objects are unchanged, and the next render works.
    ///
    /// - `context`: its executor, allocator and SIMD target do the work; the objects may come from any context
    pub fn shd_render(context: *mut shd_context, desc: *const shd_render_desc) -> shd_result;
    /// Text of the latest failure on the calling thread, "" if none.
    ///
    /// UTF-8, one line, at most 1023 bytes. Borrowed: valid until the next call of shd on this thread that fails. Success
    /// does not clear it.
    pub fn shd_last_error() -> *const c_char;
    /// Name of a result as in the source, such as "SHD_ERROR_OUT_OF_MEMORY"; "SHD_RESULT_UNKNOWN" for other values.
    ///
    /// The string is static.
    pub fn shd_result_name(result: shd_result) -> *const c_char;
    /// Make a sampler.
    ///
    /// - `context`: retained
    /// - `desc`: borrowed for the call; NULL = all defaults
    /// - `out_sampler`: owned; NULL on failure
    pub fn shd_sampler_create(context: *mut shd_context, desc: *const shd_sampler_desc, out_sampler: *mut *mut shd_sampler) -> shd_result;
    /// Add a reference; NULL is ignored. Any thread.
    pub fn shd_sampler_retain(sampler: *mut shd_sampler);
    /// Drop a reference; NULL is ignored. Any thread.
    pub fn shd_sampler_release(sampler: *mut shd_sampler);
    /// Make a shadow without a map. Call shd_shadow_render() before any lookup.
    ///
    /// - `context`: retained
    /// - `desc`: borrowed for the call; NULL = all defaults
    /// - `out_shadow`: owned; NULL on failure
    pub fn shd_shadow_create(context: *mut shd_context, desc: *const shd_shadow_desc, out_shadow: *mut *mut shd_shadow) -> shd_result;
    /// Add a reference; NULL is ignored. Any thread.
    pub fn shd_shadow_retain(shadow: *mut shd_shadow);
    /// Drop a reference; NULL is ignored. Any thread.
    pub fn shd_shadow_release(shadow: *mut shd_shadow);
    /// Render the map and replace the previous one. On failure the previous map stays.
    ///
    /// The cone of a spot has one map up to an outer angle of 1.1 rad \[63 degrees\], and six faces as a point light beyond.
    /// Filters read up to size / 8 texels (PCF and VARIANCE: size / 4) beyond the edge of a face, so each face is rendered
    /// wider by this margin. The fitted range uses the bounds of the meshes: set bounds and planes if vertex programs move
    /// the vertices. Bounds beyond 1e18 are SHD_ERROR_INVALID_ARGUMENT. The map takes 4 bytes per texel (VARIANCE 8,
    /// SUMMED_AREA_VARIANCE 16), and during rendering 4 bytes per texel more and a framebuffer of up to 2048 x 2048 pixels.
    ///
    /// - `context`: its executor, allocator and SIMD target do the work; the objects may come from any context
    pub fn shd_shadow_render(context: *mut shd_context, shadow: *mut shd_shadow, desc: *const shd_shadow_render_desc) -> shd_result;
    /// Compute the fraction of the light that reaches each point, 0 (in shadow) to 1 (lit), as frames do.
    ///
    /// Runs on the executor of the shadow's context.
    ///
    /// - `out`: column of `count` elements; must not overlap the points (checked)
    pub fn shd_shadow_sample(shadow: *const shd_shadow, lookups: *const shd_shadow_lookups, out: *const shd_f32_out) -> shd_result;
    /// Compute the numbers of vertices and indices of a shape.
    ///
    /// - `desc`: borrowed for the call; NULL = all defaults
    /// - `out_vertex_count`: 0 on failure
    /// - `out_index_count`: three for each triangle; 0 on failure
    pub fn shd_shape_count(desc: *const shd_shape_desc, out_vertex_count: *mut u32, out_index_count: *mut usize) -> shd_result;
    /// Write a shape. Elements beyond the numbers from shd_shape_count() do not change.
    ///
    /// SHD_ERROR_INVALID_ARGUMENT also when a column is too short; nothing is written then
    ///
    /// - `desc`: borrowed for the call; NULL = all defaults
    /// - `columns`: borrowed for the call
    pub fn shd_shape_fill(desc: *const shd_shape_desc, columns: *const shd_shape_columns) -> shd_result;
    /// Evaluate a solid texture at `points->count` points.
    ///
    /// - `context`: executor and SIMD target; NULL = the calling thread and the best target of the machine
    /// - `desc`: borrowed for the call
    /// - `points`: columns, borrowed for the call
    /// - `out`: columns, borrowed for the call; must not overlap any input or each other (checked)
    pub fn shd_solid_evaluate(context: *const shd_context, desc: *const shd_solid_desc, points: *const shd_solid_points, out: *mut shd_solid_values) -> shd_result;
    /// Make a mesh of smaller triangles.
    ///
    /// Triangles follow the order of the original triangles. The vertices of `mesh` come first and keep their numbers and
    /// columns, except that -0 becomes 0; vertices on edges and inside triangles follow. Every column is interpolated
    /// linearly, normals and tangents are normalised, and handedness is the sign of the interpolated value. A triangle whose
    /// edges have different numbers of parts is cut into rows across its two most finely cut edges. Parts meet at vertices
    /// only, so a closed mesh stays closed.
    ///
    /// Displacement moves a vertex along its unit normal by amplitude * (texel - offset), with the texel at its uv. A height
    /// that is not finite, or moves a vertex beyond the range of float, counts as 0. Vertices at one position move together
    /// by the mean of their displacements, so seams of uv and creases stay closed. A sheet whose two sides are faces at the
    /// same positions therefore does not move. Tangents are projected into the planes of the new normals. Heights are looked
    /// up only at the vertices: if parts are longer than two texels of level `lod`, texels between vertices have no effect.
    ///
    /// If the result would have more than max_triangles, the call is refused before it allocates memory, and the error text
    /// names the field. In ADAPTIVE mode an edge with an end that is not finite has 1 part. The info of the new mesh has the
    /// normalless_count, tangentless_count and split_count of `mesh`.
    ///
    /// - `context`: retained by the new mesh
    /// - `mesh`: concurrent reads
    /// - `desc`: borrowed for the call
    /// - `out_mesh`: owned; NULL on failure
    pub fn shd_mesh_tessellate(context: *mut shd_context, mesh: *const shd_mesh, desc: *const shd_tessellation_desc, out_mesh: *mut *mut shd_mesh) -> shd_result;
    /// Make a texture: copy or borrow texels, and build the tables.
    ///
    /// Mip levels that are not given are area averages of the base level, exact for any size, computed in linear light.
    /// Levels of sRGB formats are stored sRGB-encoded and rounded to nearest.
    ///
    /// - `context`: retained
    /// - `desc`: borrowed for the call; its texels until release with SHD_TEXTURE_BORROW
    /// - `out_texture`: owned; NULL on failure
    pub fn shd_texture_create(context: *mut shd_context, desc: *const shd_texture_desc, out_texture: *mut *mut shd_texture) -> shd_result;
    /// Add a reference; NULL is ignored. Any thread.
    pub fn shd_texture_retain(texture: *mut shd_texture);
    /// Drop a reference; NULL is ignored. Any thread.
    pub fn shd_texture_release(texture: *mut shd_texture);
    /// Get size, format and memory of a texture.
    ///
    /// - `out_info`: its struct_size is read; the rest is written, all zero on failure
    pub fn shd_texture_get_info(texture: *const shd_texture, out_info: *mut shd_texture_info) -> shd_result;
    /// Copy one mip level of a layer, or a slice of it in 3D, out as stored: sRGB stays encoded, and the swizzle does not
    /// apply. The fourth channel of a format of three is 0 here, while lookups give `fill`. Tiles of blocks are read again.
    ///
    /// - `layer`: 0..layers - 1; of a 3D texture the slice, 0..max(1, depth >> level) - 1
    /// - `level`: 0..level_count - 1; its size is max(1, width >> level) by max(1, height >> level)
    /// - `out`: image of that size, and of the format in shd_texture_info; blocks are copied as they are
    pub fn shd_texture_read_level(texture: *const shd_texture, layer: u32, level: u32, out: *const shd_image) -> shd_result;
    /// Write a rectangle of the base level of one layer or slice, and rebuild the tables that depend on it. Textures of
    /// compressed blocks give SHD_ERROR_UNSUPPORTED.
    ///
    /// The texture then has the bits that shd_texture_create() gives for the changed base. Mip levels that the caller gave
    /// stay as they are.
    ///
    /// Cost: the first update of a layer whose size halves evenly several times rebuilds all its mip levels and keeps
    /// unrounded averages of every 16 x 16 texels (32 x 32 of floats), 1/32 of the memory of RGBA8 texels. Other updates
    /// compute only the texels that cover the rectangle. Levels below an odd width or height read all base texels under
    /// these texels; ripmap levels do so in whole rows. A summed-area table is recomputed for the whole layer. Levels of 3D
    /// textures read 16 slices under the rectangle, or all base texels below an odd size.
    ///
    /// If the base level is borrowed, the caller writes its texels before this call, while no other call uses the texture.
    /// `texels` then has the size of the rectangle, and its pixels are NULL.
    ///
    /// Nothing is written if an argument is refused or memory runs out. After SHD_ERROR_CALLBACK, when the executor fails,
    /// the rectangle and the table entries that cover it are undefined until the same update succeeds.
    ///
    /// - `texture`: used by no other call concurrently
    /// - `layer`: 0..layers - 1; of a 3D texture the slice, 0..depth - 1
    /// - `x`: first column and row of the rectangle
    /// - `y`: first column and row of the rectangle
    /// - `texels`: size and texels of the rectangle, in the format of shd_texture_desc or of shd_texture_info; borrowed
    /// for the call
    pub fn shd_texture_update(texture: *mut shd_texture, layer: u32, x: u32, y: u32, texels: *const shd_image) -> shd_result;
    /// Make a tile cache.
    ///
    /// - `context`: retained; its allocator gives the memory
    /// - `desc`: borrowed for the call; NULL = all defaults
    /// - `out_cache`: owned; NULL on failure
    pub fn shd_tile_cache_create(context: *mut shd_context, desc: *const shd_tile_cache_desc, out_cache: *mut *mut shd_tile_cache) -> shd_result;
    /// Add a reference; NULL is ignored. Any thread.
    pub fn shd_tile_cache_retain(cache: *mut shd_tile_cache);
    /// Drop a reference; NULL is ignored. Any thread.
    pub fn shd_tile_cache_release(cache: *mut shd_tile_cache);
    /// Get the counters of a cache.
    ///
    /// - `out_stats`: its struct_size is read; the rest is written, all zero on failure
    pub fn shd_tile_cache_get_stats(cache: *const shd_tile_cache, out_stats: *mut shd_tile_cache_stats) -> shd_result;
    /// Load tiles that lookups with SHD_MISSING_TILES_COARSER did not find, the latest request first. A cache keeps the
    /// latest requests: up to 4096, or fewer if it has fewer tiles. An engine calls this on the threads that stream.
    ///
    /// - `max_tiles`: most tiles to load; 0 = all that are requested
    /// - `out_loaded`: number of tiles that were loaded; may be NULL; 0 on failure
    pub fn shd_tile_cache_load_requested(cache: *mut shd_tile_cache, max_tiles: u32, out_loaded: *mut u32) -> shd_result;
    /// Load the tiles of a region that are not resident. They may be evicted again, also by later tiles of the region if it
    /// is larger than the cache.
    pub fn shd_texture_load_tiles(texture: *const shd_texture, region: *const shd_tile_region) -> shd_result;
    /// Load the tiles of a region, and keep them until shd_texture_unpin_tiles(). Each call counts. Half of the tiles of a
    /// cache can be pinned; more give SHD_ERROR_LIMIT. If the call fails, it pins no tile.
    pub fn shd_texture_pin_tiles(texture: *const shd_texture, region: *const shd_tile_region) -> shd_result;
    /// Undo one shd_texture_pin_tiles() of the same region. A region with a tile that is not pinned gives
    /// SHD_ERROR_INVALID_ARGUMENT, and nothing changes.
    pub fn shd_texture_unpin_tiles(texture: *const shd_texture, region: *const shd_tile_region) -> shd_result;
    /// Drop the tiles of a region, and the tiles of all coarser levels that cover it, because their source has changed.
    /// Lookups that begin later load them again; lookups that run meanwhile may use either content. Pinned tiles stay
    /// pinned. This call loads them again. If a load fails, it returns the error, and the next call that needs a tile loads
    /// it.
    pub fn shd_texture_drop_tiles(texture: *const shd_texture, region: *const shd_tile_region) -> shd_result;
    /// Perspective projection, view to clip space. With SHD_DEPTH_ORDER_FORWARD and a finite far plane it has the bits of
    /// shd_view_from_camera().
    ///
    /// - `fov_y`: vertical field of view \[rad\], (0, pi)
    /// - `aspect`: width / height, > 0
    /// - `near_plane`: distance, > 0
    /// - `far_plane`: distance, > near_plane; INFINITY = no far plane
    /// - `order`: depths of the two planes
    /// - `out_matrix`: \[16\]
    pub fn shd_matrix_perspective(fov_y: f32, aspect: f32, near_plane: f32, far_plane: f32, order: shd_depth_order, out_matrix: *mut f32) -> shd_result;
    /// Parallel projection, view to clip space.
    ///
    /// - `rectangle`: left, right, bottom, top of the volume in view space; left is not right, bottom is not top
    /// - `near_plane`: distance along -Z, may be negative
    /// - `far_plane`: distance, > near_plane
    /// - `order`: depths of the two planes
    /// - `out_matrix`: \[16\]
    pub fn shd_matrix_orthographic(rectangle: *const f32, near_plane: f32, far_plane: f32, order: shd_depth_order, out_matrix: *mut f32) -> shd_result;
    /// Rigid transform from world to view space: the eye is at the origin, the target on -Z. It has the bits of
    /// shd_view_from_camera().
    ///
    /// - `eye`: world space
    /// - `target`: world space, not the eye
    /// - `up`: world space, any length, not along the line of sight
    /// - `out_matrix`: \[16\]
    pub fn shd_matrix_look_at(eye: *const f32, target: *const f32, up: *const f32, out_matrix: *mut f32) -> shd_result;
    /// translation * rotation * scale, as glTF 2.0 places nodes.
    ///
    /// - `translation`: NULL = none
    /// - `rotation`: quaternion x, y, z, w of any length except 0; NULL = none
    /// - `scale`: factors along x, y, z; NULL = none
    /// - `out_matrix`: \[16\]
    pub fn shd_matrix_from_trs(translation: *const f32, rotation: *const f32, scale: *const f32, out_matrix: *mut f32) -> shd_result;
    /// The product a b. Applied to a vector, b acts first.
    ///
    /// SHD_ERROR_INVALID_ARGUMENT also for a product beyond the range of float
    ///
    /// - `a`: \[16\]
    /// - `b`: \[16\]
    /// - `out_matrix`: \[16\]
    pub fn shd_matrix_multiply(a: *const f32, b: *const f32, out_matrix: *mut f32) -> shd_result;
    /// The inverse. An affine matrix, with (0, 0, 0, 1) as its last row, has an affine inverse.
    ///
    /// SHD_ERROR_INVALID_ARGUMENT for a matrix that is singular, or indistinguishable from a singular one in double
    /// precision, and for an inverse beyond the range of float
    ///
    /// - `matrix`: \[16\]
    /// - `out_matrix`: \[16\]
    pub fn shd_matrix_invert(matrix: *const f32, out_matrix: *mut f32) -> shd_result;
    /// The matrix for normals that belongs to `matrix`: the inverse transpose of its upper left 3 x 3. Transformed normals
    /// are not unit vectors and need normalising. shd_render() transforms normals by itself.
    ///
    /// SHD_ERROR_INVALID_ARGUMENT as shd_matrix_invert, of the 3 x 3
    ///
    /// - `matrix`: \[16\]
    /// - `out_3x3`: \[9\], column-major
    pub fn shd_matrix_normal(matrix: *const f32, out_3x3: *mut f32) -> shd_result;
    /// A point, (x, y, z, 1), transformed and divided by its w.
    ///
    /// SHD_ERROR_INVALID_ARGUMENT also where w is 0, and for a result beyond the range of float
    ///
    /// - `matrix`: \[16\]
    /// - `point`: x, y, z
    /// - `out_point`: \[3\]
    pub fn shd_matrix_transform_point(matrix: *const f32, point: *const f32, out_point: *mut f32) -> shd_result;
    /// A direction, (x, y, z, 0), transformed; the translation and the last row of the matrix have no effect.
    ///
    /// SHD_ERROR_INVALID_ARGUMENT also for a result beyond the range of float
    ///
    /// - `matrix`: \[16\]
    /// - `direction`: x, y, z
    /// - `out_direction`: \[3\]
    pub fn shd_matrix_transform_direction(matrix: *const f32, direction: *const f32, out_direction: *mut f32) -> shd_result;
    /// Compute the view of a camera; the same bits on every machine. An aspect of 0 counts as 1 here, because there is no
    /// picture. Frames that take the camera itself (shd_render_desc.camera) use the aspect of their picture.
    ///
    /// - `out_view`: all zero on failure
    pub fn shd_view_from_camera(camera: *const shd_camera, out_view: *mut shd_view) -> shd_result;
    /// Make a volume. Finds the range of density in each block of the texture, so that rays skip blocks without extinction;
    /// the pictures have the same bits as without skipping. A texture in tiles loads each tile of its base level once; a
    /// tile that cannot be loaded fails the call.
    ///
    /// - `context`: retained
    /// - `desc`: borrowed for the call
    /// - `out_volume`: owned; NULL on failure
    pub fn shd_volume_create(context: *mut shd_context, desc: *const shd_volume_desc, out_volume: *mut *mut shd_volume) -> shd_result;
    /// Add a reference; NULL is ignored. Any thread.
    pub fn shd_volume_retain(volume: *mut shd_volume);
    /// Drop a reference; NULL is ignored. Any thread.
    pub fn shd_volume_release(volume: *mut shd_volume);
}

#[cfg(feature = "color")]
extern "C" {
    /// Text of the built-in config, as a starting point for other configs. Static. Any thread.
    pub fn shd_color_default_config() -> *const c_char;
    /// Read a config.
    ///
    /// SHD_ERROR_NOT_FOUND for a missing file or working space, SHD_ERROR_CORRUPT for a malformed config
    /// or one whose colour spaces are defined cyclically, SHD_ERROR_UNSUPPORTED for one of a newer version,
    /// SHD_ERROR_LIMIT for a file above 64 MiB or colour spaces nested more than 64 deep
    ///
    /// - `context`: retained; its executor runs the transforms
    /// - `desc`: borrowed for the call; NULL = all defaults
    /// - `out_color`: owned; NULL on failure
    pub fn shd_color_create(context: *mut shd_context, desc: *const shd_color_desc, out_color: *mut *mut shd_color) -> shd_result;
    /// Add a reference; NULL is ignored. Any thread.
    pub fn shd_color_retain(color: *mut shd_color);
    /// Drop a reference; NULL is ignored. Any thread.
    pub fn shd_color_release(color: *mut shd_color);
    /// Transform a framebuffer for a display.
    ///
    /// The framebuffer is premultiplied by alpha. Its colour is divided by alpha, transformed, and written with
    /// straight (not premultiplied) alpha, as in PNG. Alpha is clamped to 0..1 (NaN to 0) and never encoded; a pixel of
    /// alpha 0 becomes 0, 0, 0, 0.
    ///
    /// The first call for a display and view builds the transform (about 10 ms), and the first one to an 8-bit image bakes
    /// it (6 ms for plain sRGB, 25 ms for ACES); later calls find it in a cache.
    ///
    /// SHD_ERROR_NOT_FOUND for an unknown display or view; the error text lists the valid names. Pixels are
    /// untouched on failure, unless the executor or OpenColorIO fails half-way.
    ///
    /// - `color`: concurrent reads
    /// - `framebuffer`: a framebuffer of the same context; colour in the working space; concurrent reads
    /// - `display`: name of a display; NULL = the config's default
    /// - `view`: name of one of its views; NULL = the display's default
    /// - `out`: RGBA8, RGBA8_SRGB, RGBA16, RGBA16F or RGBA32F image of the framebuffer's size
    pub fn shd_color_apply_display(color: *const shd_color, framebuffer: *const shd_framebuffer, display: *const c_char, view: *const c_char, out: *const shd_image) -> shd_result;
    /// Render a frame and transform it for a display, tile by tile.
    ///
    /// The pixels are those of shd_render() with a framebuffer of color_format SHD_FORMAT_RGBA32F, followed by
    /// shd_color_apply_display(). The worker that drew a tile transforms it as soon as it is finished, so that its colours
    /// are still in the caches. The framebuffer holds the frame as after shd_render(). A framebuffer of color_format
    /// SHD_FORMAT_RGBA8 saves memory traffic; its rounding has no effect on `out`, except for pixels that the frame leaves
    /// unchanged (shd/present.h).
    ///
    /// the failures of shd_render() and shd_color_apply_display(). If the frame fails half-way, framebuffer and
    /// pixels may hold a part of it; otherwise a failed call changes neither.
    ///
    /// - `color`: concurrent reads; its context renders
    /// - `render`: a frame with a framebuffer of the same context; colour in the working space; render->present must be
    /// unset. All pixels of the framebuffer are written to `out`, also those outside the scissor
    /// - `display`: name of a display; NULL = the config's default
    /// - `view`: name of one of its views; NULL = the display's default
    /// - `out`: RGBA8, RGBA8_SRGB, RGBA16, RGBA16F or RGBA32F image of the framebuffer's size; must not overlap the
    /// framebuffer
    pub fn shd_color_render(color: *const shd_color, render: *const shd_render_desc, display: *const c_char, view: *const c_char, out: *const shd_image) -> shd_result;
    /// Callback for shd_display.apply that calls shd_color_apply_display(), so that one call saves a display image:
    /// `save.display.apply = shd_color_apply_view, save.display.user_data = &view`.
    ///
    /// - `color_view`: a shd_color_view
    pub fn shd_color_apply_view(color_view: *mut c_void, framebuffer: *const shd_framebuffer, out: *const shd_image) -> shd_result;
    /// Transform an image for a display, as shd_color_apply_display() does with a framebuffer.
    ///
    /// - `in`: RGBA16F or RGBA32F image, premultiplied by alpha
    /// - `from_space`: colour space or role of `in`; NULL = the working space
    /// - `display`: name of a display; NULL = the config's default
    /// - `view`: name of one of its views; NULL = the display's default
    /// - `out`: image of the same size: either the memory of `in` with the same format and row stride, or memory
    /// that does not overlap it (checked)
    pub fn shd_color_apply_display_image(color: *const shd_color, r#in: *const shd_image, from_space: *const c_char, display: *const c_char, view: *const c_char, out: *const shd_image) -> shd_result;
    /// Convert an image from one colour space to another in place.
    ///
    /// For example, convert a texture from "ACEScg" to the working space before shd_texture_create(). Alpha is
    /// unchanged and not multiplied in.
    ///
    /// - `from_space`: colour space or role of the pixels; never NULL
    /// - `to_space`: colour space or role of the result; NULL = the working space
    /// - `in_out`: RGBA16F or RGBA32F image
    pub fn shd_color_convert(color: *const shd_color, from_space: *const c_char, to_space: *const c_char, in_out: *const shd_image) -> shd_result;
    /// Number of displays; 0 for a bad handle.
    pub fn shd_color_display_count(color: *const shd_color) -> u32;
    /// Name of a display; borrowed until release; NULL if there is none. Index 0 is not always the default.
    pub fn shd_color_display_name(color: *const shd_color, index: u32) -> *const c_char;
    /// Name of the default display; borrowed until release; NULL for a bad handle.
    pub fn shd_color_default_display(color: *const shd_color) -> *const c_char;
    /// Number of views of a display, NULL = the default one; 0 for an unknown display.
    pub fn shd_color_view_count(color: *const shd_color, display: *const c_char) -> u32;
    /// Name of a view of a display, NULL = the default one; borrowed until release; NULL if there is none.
    pub fn shd_color_view_name(color: *const shd_color, display: *const c_char, index: u32) -> *const c_char;
    /// Default view of a display, NULL = the default one; borrowed until release; NULL if there is none.
    pub fn shd_color_default_view(color: *const shd_color, display: *const c_char) -> *const c_char;
    /// Number of colour spaces, including those of the displays.
    pub fn shd_color_space_count(color: *const shd_color) -> u32;
    /// Name of a colour space; borrowed until release; NULL if there is none.
    pub fn shd_color_space_name(color: *const shd_color, index: u32) -> *const c_char;
    /// Name of the working space; borrowed until release; NULL for a bad handle.
    pub fn shd_color_working_space(color: *const shd_color) -> *const c_char;
}

#[cfg(feature = "embree")]
extern "C" {
    /// Build a tree of the triangles of draws. Triangles with a position that is not finite are left out.
    ///
    /// SHD_ERROR_INTERNAL if Embree fails
    ///
    /// - `context`: retained
    /// - `draws`: \[draw_count\], all with the same struct_size; mesh, object_to_world and instances are read; NULL if
    /// draw_count is 0. Borrowed for the call
    /// - `draw_count`: up to 2^20 with all instances; a tree without triangles blocks no ray
    /// - `out_embree`: owned; NULL on failure
    pub fn shd_embree_create(context: *mut shd_context, draws: *const shd_draw, draw_count: usize, out_embree: *mut *mut shd_embree) -> shd_result;
    /// Add a reference; NULL is ignored. Any thread.
    pub fn shd_embree_retain(embree: *mut shd_embree);
    /// Drop a reference; NULL is ignored. Any thread.
    pub fn shd_embree_release(embree: *mut shd_embree);
    /// Get the tracer of a tree.
    ///
    /// - `out_tracer`: valid until release of the tree; all zero on failure
    pub fn shd_embree_get_tracer(embree: *const shd_embree, out_tracer: *mut shd_tracer) -> shd_result;
}

#[cfg(feature = "io")]
extern "C" {
    /// Read an image file.
    ///
    /// The result has channels R, G, B, A: the channels with these names, or the first ones if no channel has such a name. A
    /// single channel (with or without alpha) is grey, r = g = b. If there is no alpha, it is 1. 8-bit integers become
    /// RGBA8_SRGB or RGBA8, 16-bit integers RGBA16, half floats RGBA16F, all others RGBA32F. No transfer curve is applied.
    /// An EXR data window is placed into its display window: pixels outside the data window are zero, and parts outside the
    /// display window are cropped. EXIF orientation is not applied. Deep images, subsampled channels and volumes are
    /// SHD_ERROR_UNSUPPORTED.
    ///
    /// - `context`: retained
    /// - `path`: UTF-8 or any bytes the system accepts; a regular file; used literally (no UDIM, no format
    /// directives); borrowed for the call
    /// - `desc`: borrowed for the call; NULL = all defaults
    /// - `out_bitmap`: owned; NULL on failure
    pub fn shd_bitmap_load(context: *mut shd_context, path: *const c_char, desc: *const shd_load_desc, out_bitmap: *mut *mut shd_bitmap) -> shd_result;
    /// Read an image file that is in memory, as shd_bitmap_load() does.
    ///
    /// - `bytes`: \[size\]; borrowed for the call
    pub fn shd_bitmap_load_memory(context: *mut shd_context, bytes: *const c_void, size: usize, desc: *const shd_load_desc, out_bitmap: *mut *mut shd_bitmap) -> shd_result;
    /// Add a reference; NULL is ignored.
    pub fn shd_bitmap_retain(bitmap: *mut shd_bitmap);
    /// Drop a reference; NULL is ignored.
    pub fn shd_bitmap_release(bitmap: *mut shd_bitmap);
    /// Get the pixels without copying.
    ///
    /// - `out_image`: its struct_size is read; the rest is written, all zero on failure. Borrowed until release of the
    /// bitmap; read only
    pub fn shd_bitmap_image(bitmap: *const shd_bitmap, out_image: *mut shd_image) -> shd_result;
    /// Colour space of the pixels: "sRGB", "Linear Rec.709", "ACEScg", "ACES2065-1", "Rec709", "Gamma2.2" (any
    /// number), "data", or the name in the file (printable ASCII, at most 63 characters).
    ///
    /// A file without a declared colour space is sRGB if its channels are integers and Linear Rec.709 if they are floats;
    /// PNM of integers is Rec709, as its specification requires.
    ///
    /// borrowed until release of the bitmap; "" for a bad handle
    pub fn shd_bitmap_color_space(bitmap: *const shd_bitmap) -> *const c_char;
    /// Get format and properties of a loaded file.
    ///
    /// - `out_info`: its struct_size is read; the rest is written, all zero on failure
    pub fn shd_bitmap_get_info(bitmap: *const shd_bitmap, out_info: *mut shd_bitmap_info) -> shd_result;
    /// Make a texture from a file. The content decides its kind:
    ///
    /// - Images (2D). sRGB and linear 8-bit files become RGBA8_SRGB and RGBA8, linear half files RGBA16F and linear float
    /// files RGBA32F with the same numbers. All others (16-bit integers, other transfer curves) are linearised to
    /// RGBA32F. Primaries are not converted; callers who need this use shd_bitmap_load(). Premultiplied files
    /// (SHD_BITMAP_PREMULTIPLIED) give SHD_TEXTURE_PREMULTIPLIED textures. A colour space that shd_bitmap_color_space()
    /// does not list is SHD_ERROR_UNSUPPORTED unless desc.color_space overrides it. The mip levels are those of
    /// shd_texture_create(): exact averages of the base in linear light. Levels in the file are ignored unless
    /// SHD_LOAD_FILE_LEVELS is set; then they are converted like the base.
    /// - KTX 2.0 and DDS (2D, 3D, arrays, cube maps), as they are stored, with all levels; see shd/texture_file.h.
    /// - OpenVDB (3D), and with desc.raw or desc.stack voxels and stacks of images; see shd/volume_file.h.
    ///
    /// Textures whose tiles stay in a file are opened by shd_texture_open().
    ///
    /// - `path`: as for shd_bitmap_load(); NULL with desc.stack
    /// - `desc`: borrowed for the call; NULL = all defaults
    /// - `out_texture`: owned; NULL on failure
    pub fn shd_texture_load(context: *mut shd_context, path: *const c_char, desc: *const shd_load_desc, out_texture: *mut *mut shd_texture) -> shd_result;
    /// Make a texture from a file that is in memory, as shd_texture_load() does. desc.stack is SHD_ERROR_INVALID_ARGUMENT.
    ///
    /// - `bytes`: \[size\], at any address; borrowed for the call
    pub fn shd_texture_load_memory(context: *mut shd_context, bytes: *const c_void, size: usize, desc: *const shd_load_desc, out_texture: *mut *mut shd_texture) -> shd_result;
    /// Write a framebuffer. The extension of `path` decides the format:
    ///
    /// `.exr`          R, G, B, A as half or float, linear, premultiplied, and every other plane under its usual
    /// name: Z (0 near .. 1 far), uv.u, uv.v, uv.dudx, uv.dvdx, uv.dudy, uv.dvdy, N.x, N.y, N.z, P.x, P.y,
    /// P.z, bary.0, bary.1, bary.2, lod (float), triangle, level, draw, overdraw (uint);
    /// `.hdr`          r, g, b, linear, premultiplied (negative numbers become 0);
    /// `.png`          straight alpha; colour clamped to 0..1, NaN to 0, sRGB-encoded, rounded to nearest;
    /// `display` and `dither` replace the last two steps;
    /// `.tif` `.tiff`  8 and 16 bits as PNG, 32 bits float as EXR.
    ///
    /// The file appears whole or not at all: it is written to a temporary file beside it, flushed to the disk and renamed. A
    /// failure does not change the previous file, and readers that have it open keep the old contents. A symbolic link is
    /// followed; a path that names something other than a regular file is refused.
    ///
    /// - `path`: used literally; borrowed for the call
    /// - `desc`: borrowed for the call; NULL = all defaults
    pub fn shd_framebuffer_save(framebuffer: *const shd_framebuffer, path: *const c_char, desc: *const shd_save_desc) -> shd_result;
    /// Write an image without conversion. Paths and files are handled as by shd_framebuffer_save().
    ///
    /// PNG accepts R8, RGBA8, RGBA8_SRGB and RGBA16; EXR accepts RGBA16F and RGBA32F; HDR accepts RGBA32F; TIFF accepts all
    /// except RGBA16F; TGA and BMP accept R8, RGBA8 and RGBA8_SRGB. Alpha is tagged as straight, except in EXR.
    ///
    /// - `image`: borrowed for the call
    pub fn shd_image_save(image: *const shd_image, path: *const c_char, desc: *const shd_save_desc) -> shd_result;
    /// Write a texture to a KTX 2.0 file: all levels, layers, slices and faces, as stored. Blocks stay compressed. The
    /// swizzle of the texture is not written.
    ///
    /// The file appears whole or not at all, as described for shd_framebuffer_save().
    ///
    /// - `texture`: any format; projections other than NONE and CUBE are SHD_ERROR_UNSUPPORTED
    /// - `path`: used literally; borrowed for the call
    /// - `desc`: borrowed for the call; NULL = all defaults
    pub fn shd_texture_save_ktx2(texture: *const shd_texture, path: *const c_char, desc: *const shd_ktx2_desc) -> shd_result;
    /// Open a tiled file, or a UDIM set, as a texture.
    ///
    /// Files that are not tiled, or lack mip levels although they are larger than a tile, give SHD_ERROR_UNSUPPORTED:
    /// shd-maketx converts them. Files whose levels do not halve (rounded down), or differ in channels, give
    /// SHD_ERROR_UNSUPPORTED or SHD_ERROR_CORRUPT. Tiles have at most 2^26 bytes. This does not apply to KTX2 and DDS files;
    /// sets of them give SHD_ERROR_UNSUPPORTED.
    ///
    /// - `path`: a file, or a set by one `<UDIM>`; used literally otherwise; borrowed for the call
    /// - `desc`: borrowed for the call
    /// - `out_texture`: owned; NULL on failure
    /// - `out_info`: its struct_size is read; the rest is written, all zero on failure; may be NULL
    pub fn shd_texture_open(context: *mut shd_context, path: *const c_char, desc: *const shd_tile_file_desc, out_texture: *mut *mut shd_texture, out_info: *mut shd_tile_file_info) -> shd_result;
}

#[cfg(feature = "scene")]
extern "C" {
    /// Read a model file.
    ///
    /// Materials: unlit materials become SHD_MODEL_UNLIT, and those that transmit at least half of the light and are no
    /// metals SHD_MODEL_GLASS, which needs an environment. Others with a roughness become SHD_MODEL_METALLIC_ROUGHNESS, and
    /// the rest SHD_MODEL_BLINN_PHONG. All reflect ambient light with their diffuse colour (ambient_share = 1). Every slot
    /// whose texture is in the file is set. Heights have no effect unless the file scales them. An opacity below 1, an
    /// opacity map and glTF's BLEND become SHD_BLEND_SORTED; glTF's MASK becomes alpha_cutoff, and a cutoff above 1 makes
    /// the opacity 0. The first two sets of texture coordinates are used. Colours of vertices are the attributes 0 to 3 of a
    /// mesh, and multiply the diffuse colour and the opacity.
    ///
    /// Faces: the backs of surfaces that are not double-sided are culled; a node that mirrors turns the front around.
    ///
    /// Normals that the file has not, and normals of length 0 or not finite, are computed.
    ///
    /// Lights: points, spots, directional and ambient ones, with the file's numbers as intensities. If the light of the file
    /// does not decrease with the square of the distance, its intensity is chosen so that both agree at the distance of half
    /// the diagonal of the model.
    ///
    /// Skins and morph targets have the pose and the weights of the file; shd_scene_pose() samples animations. Points and
    /// lines are left out.
    ///
    /// A model whose centre is more than 1024 radii away from 0 is moved to 0, because floats would lose its details:
    /// shd_scene_info.origin.
    ///
    /// SHD_ERROR_NOT_FOUND for a missing file, SHD_ERROR_CORRUPT for a damaged file,
    /// SHD_ERROR_UNSUPPORTED for an unknown format and for a file without triangles
    ///
    /// - `context`: retained
    /// - `path`: UTF-8 or any bytes the system accepts; a regular file; borrowed for the call
    /// - `desc`: borrowed for the call; NULL = all defaults
    /// - `out_scene`: owned; NULL on failure
    pub fn shd_scene_load(context: *mut shd_context, path: *const c_char, desc: *const shd_scene_desc, out_scene: *mut *mut shd_scene) -> shd_result;
    /// Read a model file in memory. The files that it names come from shd_scene_desc.find.
    ///
    /// as shd_scene_load()
    ///
    /// - `bytes`: \[size\]; borrowed for the call
    /// - `name`: name of the file, for formats without a mark of their own, such as "model.obj"; NULL = ""; borrowed for
    /// the call
    pub fn shd_scene_load_memory(context: *mut shd_context, bytes: *const c_void, size: usize, name: *const c_char, desc: *const shd_scene_desc, out_scene: *mut *mut shd_scene) -> shd_result;
    /// Add a reference; NULL is ignored. Any thread.
    pub fn shd_scene_retain(scene: *mut shd_scene);
    /// Drop a reference; NULL is ignored. Handles that the caller retained stay. Any thread.
    pub fn shd_scene_release(scene: *mut shd_scene);
    /// Counts and bounds of a scene.
    ///
    /// - `out_info`: its struct_size is read; the rest is written, all zero on failure
    pub fn shd_scene_get_info(scene: *const shd_scene, out_info: *mut shd_scene_info) -> shd_result;
    /// A problem with a part of the file, as one line of UTF-8. All warnings are also written to the log of the context.
    ///
    /// borrowed until release of the scene; NULL if there is none
    pub fn shd_scene_warning(scene: *const shd_scene, index: u32) -> *const c_char;
    /// Name of a part in the file, made printable, at most 400 bytes; may be "".
    ///
    /// borrowed until release of the scene; NULL if there is no such part
    pub fn shd_scene_name(scene: *const shd_scene, part: shd_scene_part, index: u32) -> *const c_char;
    /// A mesh; borrowed until release of the scene (retain it to keep it longer); NULL if there is none.
    pub fn shd_scene_mesh(scene: *const shd_scene, index: u32) -> *mut shd_mesh;
    /// A material; borrowed until release of the scene; NULL if there is none.
    pub fn shd_scene_material(scene: *const shd_scene, index: u32) -> *mut shd_material;
    /// A texture; borrowed until release of the scene; NULL if there is none.
    pub fn shd_scene_texture(scene: *const shd_scene, index: u32) -> *mut shd_texture;
    /// A light; borrowed until release of the scene; NULL if there is none.
    pub fn shd_scene_light(scene: *const shd_scene, index: u32) -> *mut shd_light;
    /// The desc of a material, as a starting point for variants of it.
    ///
    /// - `out_desc`: its struct_size is read; the rest is written, all zero on failure. Slots, textures and samplers are
    /// borrowed until release of the scene
    pub fn shd_scene_get_material_desc(scene: *const shd_scene, index: u32, out_desc: *mut shd_material_desc) -> shd_result;
    /// The desc of a light.
    ///
    /// - `out_desc`: its struct_size is read; the rest is written, all zero on failure
    pub fn shd_scene_get_light_desc(scene: *const shd_scene, index: u32, out_desc: *mut shd_light_desc) -> shd_result;
    /// A camera of the file. If the file has no aspect, it is 0, which means the aspect of the picture. If the file has no
    /// near and far plane, they enclose the whole model.
    ///
    /// - `out_camera`: its struct_size is read; the rest is written, all zero on failure
    pub fn shd_scene_get_camera(scene: *const shd_scene, index: u32, out_camera: *mut shd_camera) -> shd_result;
    /// An instance of the scene.
    ///
    /// - `out_instance`: its struct_size is read; the rest is written, all zero on failure
    pub fn shd_scene_get_instance(scene: *const shd_scene, index: u32, out_instance: *mut shd_scene_instance) -> shd_result;
    /// Set draws, draw_count, lights and light_count of a frame: one draw for each instance, in their order, and the lights
    /// of the file. All other fields stay as they are. The caller sets the camera and the framebuffer, and adds lights if
    /// the file has none.
    ///
    /// - `in_out_render`: borrowed for the call; afterwards its draws and lights are borrowed until release of the scene
    pub fn shd_scene_fill_render(scene: *const shd_scene, in_out_render: *mut shd_render_desc) -> shd_result;
    /// The times of an animation \[s\]: its first key and its last one. Poses before and after are those of the keys. Its name
    /// is that of SHD_SCENE_PART_ANIMATION.
    ///
    /// SHD_ERROR_NOT_FOUND if there is no such animation
    ///
    /// - `index`: below shd_scene_info.animation_count
    /// - `out_first`: written; 0 on failure
    /// - `out_last`: written; 0 on failure
    pub fn shd_scene_get_animation_times(scene: *const shd_scene, index: u32, out_first: *mut f64, out_last: *mut f64) -> shd_result;
    /// Make a scene of the file at some second of an animation, with all that nodes move: instances, skins, morph targets,
    /// lights and cameras. Interpolation is that of glTF 2.0, appendix C. The new scene does not depend on the pose of
    /// `scene`. It shares materials, textures and all meshes without skins and morph targets with it; parts keep their
    /// indices, except instances, lights and cameras whose numbers are out of range in the pose, which give a warning.
    ///
    /// SHD_ERROR_NOT_FOUND if there is no such animation
    ///
    /// - `animation`: index, below shd_scene_info.animation_count
    /// - `seconds`: finite; clamped to the times of each property
    /// - `out_scene`: owned; NULL on failure
    pub fn shd_scene_pose(scene: *const shd_scene, animation: u32, seconds: f64, out_scene: *mut *mut shd_scene) -> shd_result;
}
