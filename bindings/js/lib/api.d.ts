// SPDX-License-Identifier: MIT
// Types of descs, enums and functions. Written by generate.py; do not edit.
import type { Environment, Framebuffer, Light, Material, Mesh, Sampler, Shadow, Texture, Volume, Context, Column,
              OutColumn, Columns, OutColumns, Numbers, Pixels, Fragments, Radiance, Vertices, VertexOutputs, Rays,
              PresentTile, Tile, TileCache } from "./index.js";

/**
 * Source of the value of a baked texel.
 * - `empty`: no triangle: the clear values of the frame
 * - `centre`: a triangle that covers the centre of the texel
 * - `dilated`: a copy of the nearest texel that a triangle shaded
 */
export type TexelState =
  | "empty"
  | "centre"
  | "touched"
  | "dilated"
  ;

/**
 * Legal definitions of the size p of a footprint, whose level of detail is log2 p; combine with |. Below, x and y
 * are
 * the derivatives in base-level texels. Derivatives of 3D textures have a third component, x_w and y_w, which
 * joins
 * every sum and every maximum.
 * - `lengths`: axes x and y: p = max(|x|, |y|). Vulkan's and OpenGL's definition
 * - `ellipse`: the axes of the ellipse that x and y span, as Direct3D 11 defines
 * - `vulkan`: Vulkan's approximations, each of its own size: max(|x_u|, |x_v|) <= |x| <= sqrt(2) (|x_u| + |x_v|),
 * and y
 * likewise.
 * - `opengl`: OpenGL's: with m_u = max(|x_u|, |y_u|) and m_v = max(|x_v|, |y_v|), max(m_u, m_v) <= p <= m_u + m_v.
 * - `profile`: The profile of the sampler (shd_profile); not OIIO, which returns SHD_ERROR_UNSUPPORTED.
 */
export type LevelRule =
  | "lengths"
  | "ellipse"
  | "vulkan"
  | "opengl"
  | "profile"
  ;

/**
 * Rules of a graphics API, for shd_bounds_preset().
 * - `vulkan`: The least precision that Vulkan 1.3 allows: 4 bits of coordinates and of levels; LENGTHS, ELLIPSE,
 * VULKAN.
 * - `d3d11`: Direct3D 11.3: 8 bits of coordinates and of levels; LENGTHS, ELLIPSE.
 * - `webgpu`: WebGPU has no rules of its own and runs on other APIs: VULKAN's bits, and the rules of the other
 * three.
 * - `opengl`: OpenGL 4.6 has no least number of bits: VULKAN's bits; LENGTHS, OPENGL.
 */
export type Rules =
  | "vulkan"
  | "d3d11"
  | "webgpu"
  | "opengl"
  ;

/** Severity of a line of the log. */
export type LogLevel =
  | "debug"
  | "info"
  | "warning"
  | "error"
  ;

/**
 * Instruction set of the kernels. All give the same bits.
 *
 * The build (CMake option SHD_SIMD) and the machine decide which ones can be chosen.
 * - `best`: the fastest one of this machine and build
 * - `baseline`: the lowest one of this build: runs wherever the library runs
 * - `scalar`: one lane or generic vectors; only in builds whose baseline it is
 * - `sse2`: the baseline of x86-64 with a Highway after 1.0.3
 * - `ssse3`: in builds with SHD_SIMD=all
 * - `sse4`: SSE4.2
 * - `avx512`: AVX-512 F, BW, CD, DQ and VL
 */
export type Simd =
  | "best"
  | "baseline"
  | "scalar"
  | "sse2"
  | "ssse3"
  | "sse4"
  | "avx2"
  | "avx512"
  | "neon"
  | "wasm"
  ;

/**
 * Options of a context; combine with |.
 * - `return_memory`: Working memory of a call is allocated and freed block by block. Without this flag the context
 * keeps it for the
 * next call, so that a loop of equal frames allocates nothing after each worker has drawn a part of a frame, with
 * one worker after the first frame; see shd_context_trim().
 */
export type ContextFlag =
  | "default"
  | "return_memory"
  ;

/**
 * A sized struct, for shd_desc_init().
 * - `context_desc`: shd_context_desc
 * - `image`: shd_image
 * - `texture_desc`: shd_texture_desc
 * - `texture_info`: shd_texture_info
 * - `mip_desc`: shd_mip_desc
 * - `sampler_desc`: shd_sampler_desc
 * - `lookups`: shd_lookups
 * - `texels`: shd_texels
 * - `levels`: shd_levels
 * - `explanation`: shd_explanation; sets tap_size and blend_size to the library's
 * - `ray_differentials`: shd_ray_differentials
 * - `ray_cones`: shd_ray_cones
 * - `derivatives`: shd_derivatives
 * - `mesh_desc`: shd_mesh_desc
 * - `mesh_info`: shd_mesh_info
 * - `edges_desc`: shd_edges_desc
 * - `edges`: shd_edges
 * - `tessellation_desc`: shd_tessellation_desc
 * - `material_desc`: shd_material_desc
 * - `slot`: shd_slot; `target` becomes SHD_SLOT_DIFFUSE
 * - `light_desc`: shd_light_desc
 * - `shadow_desc`: shd_shadow_desc
 * - `shadow_render_desc`: shd_shadow_render_desc
 * - `shadow_lookups`: shd_shadow_lookups
 * - `framebuffer_desc`: shd_framebuffer_desc
 * - `framebuffer_info`: shd_framebuffer_info
 * - `plane_view`: shd_plane_view
 * - `camera`: shd_camera
 * - `draw`: shd_draw
 * - `render_desc`: shd_render_desc
 * - `render_stats`: shd_render_stats
 * - `color_desc`: shd_color_desc, of shd/color.h
 * - `load_desc`: shd_load_desc, of shd/io.h
 * - `save_desc`: shd_save_desc, of shd/io.h
 * - `bitmap_info`: shd_bitmap_info, of shd/io.h
 * - `shape_desc`: shd_shape_desc
 * - `shape_columns`: shd_shape_columns
 * - `scene_desc`: shd_scene_desc, of shd/scene.h
 * - `scene_info`: shd_scene_info, of shd/scene.h
 * - `scene_instance`: shd_scene_instance, of shd/scene.h
 * - `solid_desc`: shd_solid_desc
 * - `solid_points`: shd_solid_points
 * - `solid_values`: shd_solid_values
 * - `directions`: shd_directions
 * - `projected_points`: shd_projected_points
 * - `image_points`: shd_image_points
 * - `point_directions`: shd_point_directions
 * - `volume_desc`: shd_volume_desc
 * - `volume_draw`: shd_volume_draw
 * - `environment_desc`: shd_environment_desc
 * - `environment_info`: shd_environment_info
 * - `environment_lookups`: shd_environment_lookups
 * - `environment_light`: shd_environment_light
 * - `direction_images`: shd_direction_images
 * - `polygon_desc`: shd_polygon_desc
 * - `polygon_points`: shd_polygon_points
 * - `polygon_weights`: shd_polygon_weights
 * - `raw_desc`: shd_raw_desc, of shd/volume_file.h
 * - `stack_desc`: shd_stack_desc, of shd/volume_file.h
 * - `vdb_desc`: shd_vdb_desc, of shd/volume_file.h
 * - `vdb_info`: shd_vdb_info, of shd/volume_file.h
 * - `bake_desc`: shd_bake_desc
 * - `bake_stats`: shd_bake_stats
 * - `occlusion_desc`: shd_occlusion_desc
 * - `occlusion_points`: shd_occlusion_points
 * - `occlusion_atlas`: shd_occlusion_atlas
 * - `bounds_desc`: shd_bounds_desc
 * - `texture_file_info`: shd_texture_file_info, of shd/texture_file.h
 * - `ktx2_desc`: shd_ktx2_desc, of shd/texture_file.h
 * - `tile_region`: shd_tile_region
 * - `tile_cache_desc`: shd_tile_cache_desc
 * - `tile_cache_stats`: shd_tile_cache_stats
 * - `tile_file_desc`: shd_tile_file_desc, of shd/tile_file.h
 * - `tile_file_info`: shd_tile_file_info, of shd/tile_file.h
 */
export type DescKind =
  | "none"
  | "context_desc"
  | "image"
  | "texture_desc"
  | "texture_info"
  | "mip_desc"
  | "sampler_desc"
  | "lookups"
  | "texels"
  | "levels"
  | "explanation"
  | "ray_differentials"
  | "ray_cones"
  | "derivatives"
  | "mesh_desc"
  | "mesh_info"
  | "edges_desc"
  | "edges"
  | "tessellation_desc"
  | "material_desc"
  | "slot"
  | "light_desc"
  | "shadow_desc"
  | "shadow_render_desc"
  | "shadow_lookups"
  | "framebuffer_desc"
  | "framebuffer_info"
  | "plane_view"
  | "camera"
  | "draw"
  | "render_desc"
  | "render_stats"
  | "color_desc"
  | "load_desc"
  | "save_desc"
  | "bitmap_info"
  | "shape_desc"
  | "shape_columns"
  | "scene_desc"
  | "scene_info"
  | "scene_instance"
  | "solid_desc"
  | "solid_points"
  | "solid_values"
  | "directions"
  | "projected_points"
  | "image_points"
  | "point_directions"
  | "volume_desc"
  | "volume_draw"
  | "environment_desc"
  | "environment_info"
  | "environment_lookups"
  | "environment_light"
  | "direction_images"
  | "polygon_desc"
  | "polygon_points"
  | "polygon_weights"
  | "raw_desc"
  | "stack_desc"
  | "vdb_desc"
  | "vdb_info"
  | "bake_desc"
  | "bake_stats"
  | "occlusion_desc"
  | "occlusion_points"
  | "occlusion_atlas"
  | "bounds_desc"
  | "texture_file_info"
  | "ktx2_desc"
  | "tile_region"
  | "tile_cache_desc"
  | "tile_cache_stats"
  | "tile_file_desc"
  | "tile_file_info"
  ;

/**
 * Kinds of edges; combine with |.
 *
 * An edge of two triangles may be both SILHOUETTE and CREASE. Where both triangles run along it in the same
 * direction,
 * as on a Moebius strip, the second triangle counts as flipped.
 * - `silhouette`: Between two triangles of which one faces the eye e and the other does not: f0(e) f1(e) <= 0 with
 * f(e) = (e - p) . n, p a corner of the triangle and n its normal.
 * - `crease`: between two triangles with unit normals n0 . n1 <= crease_cosine, in object space
 * - `border`: an edge of one triangle
 * - `nonmanifold`: an edge of three triangles or more
 * - `all`: all kinds
 */
export type Edge =
  | "none"
  | "silhouette"
  | "crease"
  | "border"
  | "nonmanifold"
  | "all"
  ;

/**
 * Method that computes the irradiance.
 * - `harmonics`: Spherical harmonics of the orders 0 to 2 (Ramamoorthi and Hanrahan, "An Efficient Representation
 * for Irradiance
 * Environment Maps", 2001), at least 0. The error is up to 0.1 of the irradiance of a single light that faces the
 * surface, and about 0.01 for environments without a sun.
 * - `convolved`: a map of 96 x 96 directions: error up to 0.018 of such a light
 */
export type Irradiance =
  | "harmonics"
  | "convolved"
  ;

/**
 * Tables of an environment in addition to the irradiance; combine with |.
 * - `radiance`: the image itself, for backgrounds and mirrors; part of every other table
 * - `ggx`: lobes of METALLIC_ROUGHNESS
 * - `phong`: lobes of PHONG, COMBINED, TOON and both models of Blinn
 */
export type EnvironmentTable =
  | "none"
  | "radiance"
  | "ggx"
  | "phong"
  | "all"
  ;

/**
 * Optional planes; combine with |.
 * - `uv`: SHD_PLANE_U, _V
 * - `normal`: SHD_PLANE_NX, _NY, _NZ: shading normal, world space
 * - `triangle`: SHD_PLANE_TRIANGLE
 * - `position`: SHD_PLANE_PX, _PY, _PZ: world space
 * - `derivatives`: SHD_PLANE_DUDX, _DVDX, _DUDY, _DVDY: of uv, per pixel to the right and down
 * - `barycentrics`: SHD_PLANE_B0, _B1, _B2: perspective-correct weights of the triangle's corners
 * - `level`: SHD_PLANE_LOD, _LEVEL: shd_texture_query_levels() of the diffuse texture
 * - `draw`: SHD_PLANE_DRAW
 * - `overdraw`: SHD_PLANE_OVERDRAW
 * - `target1`: SHD_PLANE_TARGET1_R, _G, _B, _A: a colour target besides R, G, B, A
 * - `target2`: SHD_PLANE_TARGET2_R, _G, _B, _A
 * - `target3`: SHD_PLANE_TARGET3_R, _G, _B, _A
 */
export type Aov =
  | "none"
  | "uv"
  | "normal"
  | "triangle"
  | "position"
  | "derivatives"
  | "barycentrics"
  | "level"
  | "draw"
  | "overdraw"
  | "target1"
  | "target2"
  | "target3"
  ;

/**
 * One plane of a framebuffer: width * height elements, row by row from the top.
 *
 * Planes after SHD_PLANE_DEPTH, except overdraw and targets, hold the values of the last opaque fragment visible
 * at the
 * first sample of a pixel. Blended draws and draws of depth alone do not change them.
 *
 * Targets are additional colours of the same samples. Programs write them as shd_radiance.target; other materials
 * write
 * 0 to all four channels. They start as 0. Each target is blended with the material's blend and its own a, except
 * that
 * WEIGHTED and SORTED leave targets unchanged. The alpha test uses the alpha of the main colour target.
 * - `r`: R, G, B and A are in memory only with color_format SHD_FORMAT_RGBA32F
 * - `depth`: D32F, 0 near .. 1 far
 * - `triangle`: uint32_t: triangle index in its mesh, 0xffffffff where nothing was drawn
 * - `lod`: continuous level of detail; 0 without texture
 * - `level`: uint32_t: the mip level nearest to it
 * - `draw`: uint32_t: index into shd_render_desc.draws, 0xffffffff where nothing was drawn
 * - `overdraw`: uint32_t: number of times that the first sample was drawn, hidden later or not
 */
export type Plane =
  | "r"
  | "g"
  | "b"
  | "a"
  | "depth"
  | "u"
  | "v"
  | "nx"
  | "ny"
  | "nz"
  | "triangle"
  | "px"
  | "py"
  | "pz"
  | "dudx"
  | "dvdx"
  | "dudy"
  | "dvdy"
  | "b0"
  | "b1"
  | "b2"
  | "lod"
  | "level"
  | "draw"
  | "overdraw"
  | "target1_r"
  | "target1_g"
  | "target1_b"
  | "target1_a"
  | "target2_r"
  | "target2_g"
  | "target2_b"
  | "target2_a"
  | "target3_r"
  | "target3_g"
  | "target3_b"
  | "target3_a"
  ;

/**
 * Storage of one pixel or texel.
 *
 * Unsigned integer channels hold value / maximum, in [0, 1]; F channels are IEEE 754 binary16 or binary32. All
 * channels
 * are linear, except r, g and b of the _SRGB formats, which are encoded (IEC 61966-2-1). Textures take every
 * format;
 * framebuffers, colour transforms and files list the formats that they take.
 *
 * BC formats are blocks of 4 x 4 texels, row by row from the top left (Khronos Data Format Specification 1.3,
 * chapters
 * 18 to 20). Only shd_texture_create() and shd_texture_read_level() take them. docs/compressed.md has their
 * values.
 * - `bc1_rgb`: blocks of 8 bytes; every texel is opaque
 * - `bc1_rgba`: blocks of 8 bytes; texels may be transparent black
 * - `bc2`: blocks of 16 bytes, as all of the following except BC4
 * - `bc4`: one channel in 0..1, blocks of 8 bytes
 * - `bc4_snorm`: one channel in -1..1, blocks of 8 bytes
 * - `bc5`: two channels in 0..1
 * - `bc5_snorm`: two channels in -1..1
 * - `bc6h_ufloat`: three channels from 0 to 65504
 * - `bc6h_sfloat`: three channels from -65504 to 65504
 * - `rgb9e5`: one uint32_t: r, g, b as numbers of 9 bits from bit 0 on, e in bits 27 to 31. A channel
 * is its number times 2^(e - 24): 0 to 65408
 */
export type Format =
  | "none"
  | "r8"
  | "rgba8"
  | "rgba8_srgb"
  | "rgba16f"
  | "rgba32f"
  | "rgba16"
  | "rg8"
  | "rgb8"
  | "r8_srgb"
  | "rg8_srgb"
  | "rgb8_srgb"
  | "r16"
  | "rg16"
  | "rgb16"
  | "r16f"
  | "rg16f"
  | "rgb16f"
  | "r32f"
  | "rg32f"
  | "rgb32f"
  | "bc1_rgb"
  | "bc1_rgb_srgb"
  | "bc1_rgba"
  | "bc1_rgba_srgb"
  | "bc2"
  | "bc2_srgb"
  | "bc3"
  | "bc3_srgb"
  | "bc4"
  | "bc4_snorm"
  | "bc5"
  | "bc5_snorm"
  | "bc6h_ufloat"
  | "bc6h_sfloat"
  | "bc7"
  | "bc7_srgb"
  | "rgb9e5"
  ;

/**
 * Kind of light.
 * - `point`: from a point in all directions
 * - `directional`: parallel rays of equal E everywhere
 * - `ambient`: I_a, from all directions; ambient lights add up
 * - `spot`: from a point into a cone
 */
export type LightKind =
  | "point"
  | "directional"
  | "ambient"
  | "spot"
  ;

/**
 * Reflectance model: the radiance L towards the eye.
 *
 * n: unit normal, l: unit vector to a light, v: unit vector to the eye, h = (v + l) / |v + l|, E: irradiance
 * (shd/light.h). Sums are over all lights except ambient lights, whose sum is I_a. k_d, k_a, k_s, p and so on are
 * constants of the material times their slots. "Specular" terms are 0 where n.l <= 0 (except with
 * SHD_MATERIAL_SPECULAR_UNGATED) and where v + l = 0; 0^0 = 1. Every model adds the emission, and multiplies I_a
 * by the
 * occlusion.
 *
 * BLINN_PHONG_NORMALIZED and METALLIC_ROUGHNESS divide the diffuse term by pi, the other models do not: with
 * lights
 * whose intensity is pi times as large, their diffuse surfaces are as bright as those of LAMBERT (shd/light.h).
 * - `lambert`: k_a I_a + sum of k_d E max(0, n.l)
 * - `blinn_phong`: Lambert + sum of k_s E max(0, n.h)^p (Blinn 1977)
 * - `program`: program.fragment
 * - `unlit`: k_d, independent of lights and frequency
 * - `phong`: Lambert + sum of k_s E max(0, v.r)^p with r = 2 (n.l) n - l (Phong 1975)
 * - `blinn_phong_normalized`: k_a I_a + sum of (k_d / pi + k_s N max(0, n.h)^p) E max(0, n.l), N = (p + 2)(p + 4)
 * / (8 pi (2^(-p/2) + p)):
 * reflects at most the incident light where k_d + k_s <= 1 (Giesen, "Phong and Blinn-Phong Normalization Factors",
 * 2009)
 * - `combined`: k_d (I_a + sum of E max(0, n.l)) + sum of E k_s max(0, n.h)^p (Shirley and Marschner,
 * "Fundamentals of Computer
 * Graphics", 2009, 10.2)
 * - `gooch`: k_w w + (1 - k_w) c with k_w the mean of (1 + n.l) / 2 over the lights, 1/2 without any: w = warm +
 * warm_mix k_d,
 * c = cool + cool_mix k_d (Gooch et al., "A Non-Photorealistic Lighting Model", 1998)
 * - `toon`: Blinn-Phong with n.l rounded up to a multiple of 1 / toon_steps, and max(0, n.h)^p replaced by 0 below
 * 1/2 and by
 * 1 from 1/2 on
 * - `metallic_roughness`: Metallic-roughness of glTF 2.0, appendix B: k_a I_a (b (1 - m) + F0) + sum of E max(0,
 * n.l) (b (1 - m) (1 - f)
 * (1 - (1 - v.h)^5) / pi + F D V), with base colour b = k_d, metallic m, alpha = max(roughness^2, 0.001),
 * F = F0 + (1 - F0) (1 - v.h)^5, F0 = f (1 - m) + b m, f = ((ior - 1) / (ior + 1))^2, the distribution D of
 * Trowbridge and Reitz (GGX) and V, the height-correlated masking and shadowing of Smith over 4 (n.l) (n.v), where
 * n.v counts as at least 1e-4: interpolated normals may face away from the eye. Metals reflect at most the
 * incident
 * light. Dielectrics exceed it at grazing angles (1.2 at 75 degrees from n, 1.6 at 85), diffuse plus specular
 * - `matcap`: k_d times SHD_SLOT_MATCAP at (1/2 + x/2, 1/2 - y/2) of the normal in view space; a normal
 * without a direction reads the middle
 * - `glass`: A clear solid: k_a I_a + sum of E max(0, n.l) F D V + k_d (1 - F) T, with F, D and V of
 * METALLIC_ROUGHNESS for
 * F0 = ((ior - 1) / (ior + 1))^2, and T the radiance of the frame's environment (shd_render_desc.environment)
 * along
 * the refracted line of sight, 0 without one. The solid counts as a sphere with the normal of the fragment, which
 * turns the line of sight twice. Other draws are not seen through it
 */
export type Model =
  | "lambert"
  | "blinn_phong"
  | "program"
  | "unlit"
  | "phong"
  | "blinn_phong_normalized"
  | "combined"
  | "gooch"
  | "toon"
  | "metallic_roughness"
  | "matcap"
  | "glass"
  ;

/**
 * Debug views of values that the rasteriser computes. They replace the model's radiance L; the emission is added.
 * - `none`: the model
 * - `normal`: shading normal: (n + 1) / 2
 * - `uv`: texture coordinates: (u - floor(u), v - floor(v), 0)
 * - `level`: level of detail of the diffuse texture: blue for level 0, over green, to red for
 * the last level
 * - `barycentrics`: barycentric coordinates in the triangle
 */
export type DebugView =
  | "none"
  | "normal"
  | "uv"
  | "level"
  | "barycentrics"
  ;

/**
 * Encoding of a tangent-space normal in the values of SHD_SLOT_NORMAL.
 *
 * x points along u, z along the normal, and y up in the image, against v, as in glTF 2.0 (down with
 * SHD_MATERIAL_NORMAL_Y_DOWN). Textures of 8 and 16 bits hold (c + 1) / 2 of a component c; float textures,
 * vertices
 * and procedures hold c itself.
 * - `xyz`: (x, y, z)
 * - `xy`: (x, y), z = sqrt(1 - x^2 - y^2)
 * - `toksvig`: XYZ with the length of the mean normal as the fourth channel, as shd_mip_build() makes it. The
 * variance of
 * normals within a pixel widens the specular lobe (Toksvig, "Mipmapping Normal Maps", 2005)
 * - `moments`: (x / z, y / z) and their squares, in floats, and their product in SHD_SLOT_NORMAL_MIXED, as
 * shd_normal_moments()
 * makes them. Lobes are averaged over normals with slopes of mean b and covariance S within the pixel (Olano and
 * Baker, "LEAN Mapping", 2010), so grooves stretch highlights across them. With S = 0 the results are those of
 * XYZ:
 * - diffuse: the mean of max(0, n.l) over a Gaussian of slopes around the mean normal, divided by
 *   sqrt(1 + trace S);
 * - max(0, n.h)^p: Laplace's method, that is the lobe of the normal between b and h where its product with the
 *   Gaussian is largest, times the Gaussian there, divided by sqrt(det(1 + p S G)), G being the metric of angles;
 * - max(0, v.r)^p: the same with 4 p h.l in place of p;
 * - METALLIC_ROUGHNESS: adaptive Gauss-Hermite quadrature (Naylor and Smith, "Applications of a Method for the
 *   Efficient Computation of Posterior Distributions", 1982): the sum of the lobes of four normals along the
 * longer
 *   axis of S. Normals and weights suit the Gaussian of slopes times a Gaussian around h with the precision
 *   2 (0.2 + r^2) / (1 + r^2) / alpha^2, r = s / (6 alpha^2) for the larger variance s of S.
 * GOOCH and TOON use the mean normal only. SHD_FILTER_EWA with a lod_bias of -0.5 to -0.25 is closest to shading
 * many samples a pixel: its default footprint is wider than a pixel
 */
export type NormalEncoding =
  | "xyz"
  | "xy"
  | "toksvig"
  | "moments"
  ;

/**
 * Tilt of normals by SHD_SLOT_HEIGHT.
 * - `none`: no tilt; heights are for parallax only
 * - `gradient`: The normal of the surface moved along n by bump_scale h [world units]: n - bump_scale grad h. The
 * gradient on the
 * surface uses the exact derivative of the filtered height in u and v (Mikkelsen, "Bump Mapping Unparametrized
 * Surfaces on the GPU", 2010). Filters without derivatives use differences over a texel.
 * - `texel`: (-s (h(u + 1/w, v) - h(u, v)), -s (h(u, v + 1/h) - h(u, v)), 1) along t, v and n, with s =
 * bump_scale:
 * differences over one texel, independent of the size of the surface (after Blinn, "Simulation of Wrinkled
 * Surfaces", 1978)
 */
export type Bump =
  | "none"
  | "gradient"
  | "texel"
  ;

/**
 * Blending of a fragment of colour c and opacity a onto a sample of colour d and opacity A.
 *
 * Models give c = a L with the radiance L and a = opacity times its slot times the alpha of the diffuse slot. For
 * STRAIGHT and OPAQUE they give c = L.
 * - `opaque`: colour c; A becomes the a of a program, or 1 for a model
 * - `premultiplied`: c + (1 - a) d, a + (1 - a) A: "over" (Porter and Duff 1984)
 * - `straight`: a c + (1 - a) d, a + (1 - a) A
 * - `add`: c + d, A
 * - `multiply`: c d + (1 - a) d, A
 * - `weighted`: After all other draws, independent of order: with R the product of 1 - a, w = max(0.01, 3000 (1 -
 * depth)^3) and
 * C = sum of w c / sum of w a, the result is (1 - R) C + R d, 1 - R + R A. An approximation (McGuire and Bavoil,
 * "Weighted Blended Order-Independent Transparency", 2013, equation 10). Depth is tested, not written.
 * - `sorted`: After all other draws, PREMULTIPLIED from far to near per sample; equal depths in the order of draws
 * and
 * triangles. Depth is tested, not written.
 */
export type Blend =
  | "opaque"
  | "premultiplied"
  | "straight"
  | "add"
  | "multiply"
  | "weighted"
  | "sorted"
  ;

/**
 * Options of a material; combine with |.
 * - `specular_ungated`: Keep the specular term where n.l <= 0, as in the textbook formula; by default it is 0
 * there.
 * - `ambient_per_light`: Add the ambient term once for each light that is not ambient, instead of once in total.
 * - `discards`: The program may set shd_radiance.discard.
 * - `alpha_to_coverage`: Keep the first round(a * sample count) samples of a pixel and drop the others.
 * - `double_sided`: Flip normals on triangles seen from behind.
 * - `normal_y_down`: Mapped normals have y down in the image, along v, as usual with Direct3D; default is up, as
 * in glTF.
 */
export type MaterialFlag =
  | "none"
  | "specular_ungated"
  | "ambient_per_light"
  | "discards"
  | "alpha_to_coverage"
  | "double_sided"
  | "normal_y_down"
  ;

/**
 * Weights of face normals in computed vertex normals. Degenerate faces contribute nothing.
 * - `area`: sum of face normals times face area (the cross products)
 * - `uniform`: plain average of unit face normals
 * - `angle`: weighted by the corner angle (Thuermer and Wuethrich 1998)
 */
export type NormalWeight =
  | "area"
  | "uniform"
  | "angle"
  ;

/**
 * Assembly of triangles from indices. A triangle of coincident vertices counts as a triangle, but covers nothing.
 * There is no topology of lines or points: shd_draw.fill draws the edges or the vertices of triangles.
 * - `triangles`: three indices each: (0, 1, 2), (3, 4, 5), ...
 * - `strip`: each further index adds a triangle: (0, 1, 2), (1, 3, 2), (2, 3, 4), ...
 * - `fan`: each further index adds a triangle around vertex 0: (0, 1, 2), (0, 2, 3), ...
 */
export type Topology =
  | "triangles"
  | "strip"
  | "fan"
  ;

/**
 * Options of a mesh; combine with |.
 * - `keep_nonfinite`: Accept NaN and infinite positions; rendering drops and counts the triangles that use them.
 * - `tangents`: Compute tangents when none are given; see @ref tangents. Vertices may be appended to the caller's
 * vertices:
 * shd_mesh_info.vertex_count is vertex_count + split_count.
 * - `adjacency`: Find the triangles that share each edge, for shd_mesh_find_edges() and SHD_FILL_LINES. The mesh
 * takes 12 more
 * bytes per triangle. Its creation temporarily takes another 12 bytes per triangle and 12 per vertex, and linear
 * time.
 */
export type MeshFlag =
  | "none"
  | "keep_nonfinite"
  | "tangents"
  | "adjacency"
  ;

/**
 * Filter kernel along one axis, in texels of the new level.
 *
 * The weight of a source texel is the integral of the kernel over the texel, for any ratio of sizes. The weights
 * of a
 * level's texel sum to 1, so constant images stay constant.
 * - `box`: the texel's own area (Williams 1983)
 * - `triangle`: 1 - |x|, radius 1
 * - `kaiser`: sinc under a Kaiser window of parameter 4, radius 3
 * - `lanczos`: sinc(x) sinc(x / 3), radius 3
 */
export type MipKernel =
  | "box"
  | "triangle"
  | "kaiser"
  | "lanczos"
  ;

/**
 * Source of each level.
 * - `base`: every level is made from the base and rounded once
 * - `previous`: every level is made from the previous, stored level; faster for many levels,
 * but rounding errors add up
 */
export type MipSource =
  | "base"
  | "previous"
  ;

/**
 * Content of the texels, which decides how they are averaged.
 * - `color`: light: _SRGB formats are decoded before filtering
 * - `data`: numbers: _SRGB formats are filtered without decoding
 * - `normal`: Unit vectors in three or four channels. Integer channels, of _SRGB formats too, hold (n + 1) / 2.
 * Levels are
 * renormalised; a zero mean becomes (0, 0, 1). The fourth channel of a level is the length of the mean, at most 1;
 * materials compute a wider specular lobe from it (Toksvig, "Mipmapping Normal Maps", 2005). The caller sets the
 * fourth channel of the base, 1 for unit vectors.
 * - `height`: as data
 * - `alpha_coverage`: Colour whose alpha is tested, in four channels. Alpha of every level is scaled so that the
 * share of texels that
 * reach `alpha_cutoff` is the share of the base (Castano, "Computing Alpha Mipmaps", 2010). The share is exact to
 * the nearest texel, except where texels of equal alpha lie at the cutoff.
 * - `alpha_weighted`: Colour with straight alpha, in four channels. r, g and b of a level are averages weighted by
 * alpha, as averages
 * of premultiplied colour: transparent texels do not shine through (Porter and Duff, "Compositing Digital Images",
 * 1984). The weight of a texel is max(alpha, 0) + 2^-20, so that colours under alpha 0 alone are averaged, too.
 */
export type TexelContent =
  | "color"
  | "data"
  | "normal"
  | "height"
  | "alpha_coverage"
  | "alpha_weighted"
  ;

/**
 * Kind of generalised barycentric coordinates; the file's comment has the formulas.
 * - `wachspress`: rational functions on convex polygons
 * - `mean_value`: closed form on simple polygons
 * - `discrete_harmonic`: cotangent weights on convex polygons
 * - `harmonic`: solution of the Laplace equation on simple polygons
 */
export type Barycentric =
  | "wachspress"
  | "mean_value"
  | "discrete_harmonic"
  | "harmonic"
  ;

/**
 * Maps from directions to points of images.
 * - `none`: an image that shows no directions
 * - `lat_long`: longitude across, latitude down; any size, customary: width = 2 height
 * - `mirror_ball`: photograph of a mirror ball; square
 * - `angular`: the distance from the centre is the angle from +Z; square
 * - `cube`: six square faces: +X, -X, +Y, -Y, +Z, -Z
 * - `octahedral`: an octahedron unfolded into a square
 */
export type Projection =
  | "none"
  | "lat_long"
  | "mirror_ball"
  | "angular"
  | "cube"
  | "octahedral"
  ;

/**
 * Arrangement of the faces of a cube map in images. n is the size of a face.
 * - `faces`: six images of n x n: +X, -X, +Y, -Y, +Z, -Z
 * - `row`: one image of 6n x n: the faces from left to right
 * - `column`: one image of n x 6n: the faces from top to bottom
 * - `horizontal_cross`: 4n x 3n: +Y above +Z; -X, +Z, +X, -Z; -Y below +Z
 * - `vertical_cross`: 3n x 4n: +Y; -X, +Z, +X; -Y; -Z turned by half a turn
 */
export type CubeLayout =
  | "faces"
  | "row"
  | "column"
  | "horizontal_cross"
  | "vertical_cross"
  ;

/**
 * Points at which the reflectance model is evaluated. Textures are looked up per fragment at every frequency.
 * - `phong`: per fragment, with interpolated and renormalised normals (Phong 1975)
 * - `gouraud`: per vertex, colours interpolated (Gouraud 1971)
 * - `flat`: once per triangle, with the face normal at the centroid
 */
export type Frequency =
  | "phong"
  | "gouraud"
  | "flat"
  ;

/** Triangles that are skipped; front = counter-clockwise on the screen, seen with y up. */
export type Cull =
  | "none"
  | "back"
  | "front"
  ;

/**
 * Options of a draw; combine with |.
 * - `keep_depth`: test depth without writing it
 * - `sample_shading`: shade every sample at its own position, instead of every pixel once
 */
export type DrawFlag =
  | "none"
  | "keep_depth"
  | "sample_shading"
  ;

/**
 * Parts of a triangle that are drawn.
 * - `wireframe`: its three edges
 * - `points`: its three vertices
 * - `lines`: its edges of the kinds in shd_draw.edges; for meshes with SHD_MESH_ADJACENCY
 */
export type Fill =
  | "solid"
  | "wireframe"
  | "points"
  | "lines"
  ;

/**
 * Options of a frame; combine with |.
 * - `count_hidden`: fill shd_render_stats.hidden_samples: coverage is computed at least twice
 * - `load`: keep the planes instead of clearing them: each sample starts with the values of its
 * pixel
 */
export type RenderFlag =
  | "none"
  | "count_hidden"
  | "load"
  ;

/**
 * Method that decides which triangle is visible at a sample.
 *
 * PAINTER and NEWELL order the triangles of all draws and paint each over the previous ones. Depths are not
 * compared,
 * as with SHD_COMPARE_ALWAYS; the final depth is that of the triangle painted last. Depth decreases with the
 * distance
 * in draws that compare GREATER or GREATER_EQUAL and increases in all others; biases apply. shd_draw_flag works as
 * usual. Opaque draws are shaded after all of them are painted. PREMULTIPLIED, STRAIGHT, ADD and MULTIPLY take
 * effect
 * in the order of painting. WEIGHTED and SORTED come last and test the painted depths. A draw without a material
 * writes
 * its depth and hides nothing.
 * - `depth`: the depth of the sample, by the draw's comparison (Catmull 1974)
 * - `painter`: The painter's algorithm: triangles by their farthest vertex, far ones first, equal ones in the
 * order of draws and
 * triangles. The picture is wrong where two triangles overlap and the one painted first is nearer in the overlap;
 * shd_render_stats.order_conflicts counts these pairs. O(n log n).
 * - `newell`: The painter's algorithm with the tests, reordering and cuts of Newell, Newell and Sancha, "A
 * Solution to the
 * Hidden Surface Problem" (1972). Correct, except where depths differ by less than the effect of a shift by 1/256
 * pixel, or by less than 2^-23.
 *
 * Triangles that overlap cyclically or pass through each other are cut along the plane of one of them. New
 * vertices
 * lie on the grid of 1/256 pixel. A sample within 1/256 pixel of a cut, or of an edge that was cut, may lie on
 * either side, and windows of a picture may differ there. Pieces keep the attributes and ids of their triangle.
 * A triangle is not cut if a piece would have no area on the grid.
 *
 * For n triangles there are at most n + 1024 cuts and 1024 n + 2^22 comparisons; order_conflicts counts the
 * remaining errors. Runs on one thread and takes up to 1000 bytes a triangle.
 */
export type Visibility =
  | "depth"
  | "painter"
  | "newell"
  ;

/**
 * Colour of the samples that no draw covers.
 * - `clear`: clear_color
 * - `environment`: Radiance of the environment along the line of sight through the centre of the pixel, averaged
 * over the pixel;
 * a = 1. No effect with SHD_RENDER_LOAD.
 */
export type Background =
  | "clear"
  | "environment"
  ;

/**
 * Result of every call that can fail. A call that fails changes nothing.
 * - `ok`: done
 * - `error_invalid_argument`: the text names desc, field, value and range
 * - `error_out_of_memory`: an allocation failed; nothing leaked, every object is as before
 * - `error_unsupported`: well formed, but this build or version does not offer it
 * - `error_not_found`: a file, colour space, display, view or plane does not exist
 * - `error_io`: reading or writing a file failed
 * - `error_corrupt`: a file is damaged, or its content does not have the claimed format
 * - `error_limit`: a budget that the caller set (pixels, bytes, time) would be exceeded
 * - `error_cancelled`: the host's progress callback requested cancellation
 * - `error_callback`: a host callback reported failure
 * - `error_internal`: a bug in shd or a library below it; please report the text
 */
export type Result =
  | "ok"
  | "error_invalid_argument"
  | "error_out_of_memory"
  | "error_unsupported"
  | "error_not_found"
  | "error_io"
  | "error_corrupt"
  | "error_limit"
  | "error_cancelled"
  | "error_callback"
  | "error_internal"
  ;

/**
 * Reconstruction and minification filter.
 *
 * Filters that use mip levels read only level 0 of a texture without a mipmap. Ripmap and summed-area lookups are
 * refused if the texture does not have the table.
 * - `trilinear`: Bilinear on the two nearest mip levels, blended by the fraction of the level of detail (Williams
 * 1983).
 * - `nearest`: the texel of level 0 that contains (u, v)
 * - `bilinear`: the four texels of level 0 around (u, v)
 * - `bicubic`: The 4 x 4 texels of level 0 around (u, v), weighted by the cubic `cubic` (Mitchell and Netravali
 * 1988).
 * - `nearest_mip`: the texel of the nearest mip level that contains (u, v)
 * - `bilinear_mip`: bilinear on the nearest mip level
 * - `ripmap`: Bilinear on the four nearest ripmap levels, which halve each axis on its own. Needs
 * SHD_TABLE_RIPMAP.
 * - `summed_area`: The average of the texels over `box`, where each texel is a square of constant value, from sums
 * over rectangles
 * (Crow 1984). Needs SHD_TABLE_SUMMED_AREA. Sides of a box are at least 1 texel, which makes magnification
 * bilinear, and at most 2^22. Bias and clamps of the level of detail apply to log2 of a side; `lod` is a square of
 * 2^lod texels. If a box touches a texel that is not finite, the result is NaN in its channel.
 * - `anisotropic`: Trilinear probes of the footprint's shorter axis, along the longer one (McCormack et al. 1999).
 * - `ewa`: The texels inside the footprint's ellipse, weighted by exp(-2 r^2) - exp(-2) with r from 0 at its
 * centre to 1 on
 * its edge (Greene and Heckbert 1986), on the mip level on which the footprint's shorter half axis b is 1..2
 * texels, b >= a / max_anisotropy; on the finest level, b = max(b, 1). Half axes: sqrt(0.84^2 a^2 + c) and
 * sqrt(0.84^2 b^2 + c) in texels of level l, c = 1 - 0.6127 (1 - 4^-l): Heckbert's reconstruction filter without
 * the averaging of level l. Bilinear where a is at most one texel of level 0; blended from bilinear to EWA where a
 * is one to two texels. `lod` is a circle. Reads at most 16 (max_anisotropy + 1) texels, 4 times as many in 3D.
 * - `stochastic`: An unbiased estimate of the filter that `stochastic_filter` names, from what shd_stochastic
 * picks at random.
 * - `exact`: The average of the bilinear reconstruction over the footprint's parallelogram, computed in double:
 * the ground
 * truth. It uses the finest level on which the parallelogram covers at most 16 / tolerance^2 cells (2^10..2^24).
 * If
 * it covers more cells even on the coarsest level, it is shortened to this number. `lod` is a square of 2^lod
 * texels, in 3D a box. docs/filter-exact.md has its definition on images of directions. Slow.
 * - `nearest_mip_linear`: The texels that contain (u, v) of the two nearest mip levels, blended by the fraction of
 * the level of detail:
 * VK_FILTER_NEAREST with VK_SAMPLER_MIPMAP_MODE_LINEAR, GL_NEAREST_MIPMAP_LINEAR, D3D's MIN_MAG_POINT_MIP_LINEAR.
 */
export type Filter =
  | "trilinear"
  | "nearest"
  | "bilinear"
  | "bicubic"
  | "nearest_mip"
  | "bilinear_mip"
  | "ripmap"
  | "summed_area"
  | "anisotropic"
  | "ewa"
  | "stochastic"
  | "exact"
  | "nearest_mip_linear"
  ;

/**
 * Filter for magnification: where the level of detail of NEAREST_MIP, NEAREST_MIP_LINEAR, BILINEAR_MIP and
 * TRILINEAR is
 * 0 or below, and where the footprint of all other filters is at most one texel long.
 * - `default`: the default of the filter: nearest for NEAREST, NEAREST_MIP and
 * NEAREST_MIP_LINEAR, bicubic for BICUBIC, bilinear for all others
 * - `nearest`: SHD_FILTER_NEAREST
 * - `bilinear`: SHD_FILTER_BILINEAR
 * - `bicubic`: SHD_FILTER_BICUBIC
 */
export type Magnification =
  | "default"
  | "nearest"
  | "bilinear"
  | "bicubic"
  ;

/**
 * Cubic kernels by their (B, C) of Mitchell and Netravali, "Reconstruction Filters in Computer Graphics" (1988).
 * - `catmull_rom`: (0, 1/2): interpolates, overshoots
 * - `b_spline`: (1, 0): smooths, never overshoots
 * - `mitchell`: (1/3, 1/3): in between
 */
export type Cubic =
  | "catmull_rom"
  | "b_spline"
  | "mitchell"
  ;

/**
 * Weights of the probes of SHD_FILTER_ANISOTROPIC along the longer axis.
 * - `equal`: a box
 * - `gaussian`: exp(-2 x^2), x = -1..1 from end to end of the probes
 */
export type ProbeWeights =
  | "equal"
  | "gaussian"
  ;

/**
 * Area that SHD_FILTER_SUMMED_AREA averages.
 * - `bounding`: The bounding rectangle of the footprint's parallelogram: |dudx| + |dudy| by |dvdx| + |dvdy|.
 * - `oriented`: The average over the bounding rectangles of N equal parts of the parallelogram along its longer
 * side a. If b is
 * the other side in texels, N = ceil(|a| / max(|b|, 1)), at most max_anisotropy.
 */
export type Box =
  | "bounding"
  | "oriented"
  ;

/**
 * Definition of the level of detail, the levels and the probes of NEAREST_MIP, NEAREST_MIP_LINEAR, BILINEAR_MIP,
 * TRILINEAR and ANISOTROPIC.
 *
 * LEAST_ERROR differs from EXACT in RIPMAP as well, and in STOCHASTIC of these filters. All other filters are the
 * same
 * in all profiles, because EWA, SUMMED_AREA and EXACT have the least error as they are.
 *
 * Mean PSNR [dB] of five scenes under a box of one pixel and a tent of two: four photographs, then checker, noise
 * and
 * zone plate. docs/filters.md has more rules and figures, measured by `SHD_BENCH_PHOTOGRAPHS=folder shd-bench
 * --benchmark_filter=^default/` (bench/README.md).
 *
 * | filter | LEAST_ERROR | EXACT | OpenImageIO |
 * |---|---|---|---|
 * | BILINEAR_MIP | 41.0 41.2, 34.2 33.5 | 37.0 39.0, 31.9 33.1 | 34.5 36.3, 29.4 31.5 |
 * | TRILINEAR | 42.7 43.0, 36.3 35.1 | 37.5 40.1, 33.3 34.5 | 39.5 41.5, 34.1 34.7 |
 * | ANISOTROPIC (16) | 49.5 46.2, 43.4 37.6 | 46.1 46.6, 42.8 38.9 | 43.8 47.5, 38.1 39.0 |
 * | RIPMAP | 44.4 44.9, 37.7 36.2 | 40.5 43.8, 36.9 37.1 | |
 *
 * Below, x and y are the columns of the matrix J of derivatives in base-level texels, a = max_anisotropy, and
 * lambda is
 * the level of detail before bias and clamps.
 * - `least_error`: The levels of least measured error, a little finer than the footprint. Let s1 >= s2 be the
 * singular values of J,
 * and rms(x, y) = sqrt((x^2 + y^2) / 2). lambda = log2(rms(s1, s2)) - 3/8. ANISOTROPIC: r = min(s1 / s2, a),
 * lambda
 * = log2(rms(s1 / r, s2)) - 1/8 - 1 / (4 r), and ceil(r - 1/8) probes along the longer axis. RIPMAP: log2 of the
 * extent along each axis, less 3/8. The column `lod` of lookups is used as it is.
 * - `vulkan`: Vulkan 1.3 specification, "Image Operations": lambda = log2(max(|x|, |y|)). ANISOTROPIC: eta =
 * min(longer /
 * shorter, a) for the longer and the shorter one of x and y, lambda = log2(longer / eta), and ceil(eta) probes of
 * equal weight at i / (ceil(eta) + 1) - 1/2 of the longer one. Fractions of levels and weights of bilinear lookups
 * (BILINEAR's too) have 8 bits, as most desktop GPUs report in mipmapPrecisionBits and subTexelPrecisionBits.
 * Weights of textures with a projection are not rounded.
 * - `d3d11`: Direct3D 11.3 functional specification, 7.18.10 and 7.18.11: lambda = log2(m), with m the major axis
 * of J's
 * ellipse, or the longer of x and y if they are parallel. ANISOTROPIC: r = min(m^2 / |det J|, a), lambda = log2(m
 * /
 * r), ceil(min(r, max(m, 1))) probes along m. The specification does not define the places and weights of probes;
 * shd uses the places and weights of SHD_PROFILE_VULKAN. Fractions of levels and weights of bilinear lookups have
 * 8 bits, as in SHD_PROFILE_VULKAN, and the nearest level is floor(lod + 1/2).
 * - `oiio`: OpenImageIO 2.4, TextureSystem with default options. The width w of the filter, in units of the
 * texture, is the
 * largest of |du/dx| .. |dv/dy| plus the larger blur. The coarser level is the first one on which w is at most one
 * texel of the smaller side; the finer level is the next finer one. The weight of the coarser level is 2 w - 1,
 * with w in texels of this level; NEAREST_MIP and BILINEAR_MIP use the coarser level. ANISOTROPIC: axes m >= n of
 * the ellipse in units of the texture, lengthened by blur; where m > a n they become m' = (m + a n) / 2 and n' =
 * m'
 * / a. Levels by w = n. N = floor(2 m / n - 1) probes, at least 1 and at most one per half texel of level 0, at p
 * (m - n), p = (2 k + 1 - N) / N, k = 0 to N - 1, of weight exp(-2 x^2), x = p m / (2 (m - n)). `width_x` and
 * `width_y` scale the derivatives of u and of v, as swidth and twidth do.
 * - `exact`: As LEAST_ERROR with lambda = log2(s1), log2(s1 / r) for ANISOTROPIC, and without the 3/8 of a level.
 */
export type Profile =
  | "least_error"
  | "vulkan"
  | "d3d11"
  | "oiio"
  | "exact"
  ;

/**
 * Arithmetic of lookups. Each has the same bits on every SIMD target.
 * - `full`: weights and sums are binary32 floats
 * - `fast`: Texels are blended in integers of 16 bits, with fractions of 15 bits. Values are within 2^-11 of
 * SHD_PRECISION_FULL, an eighth of a step of 8 bits. Where all texels are equal, values have the same bits.
 *
 * Levels of detail are the same. In LEAST_ERROR and EXACT, ANISOTROPIC blends levels in a part of the way between
 * them: it has the levels and probes of a level_blend of at most 9/32. Its values are within
 * 2^-11 + 2^-22 (width + height) of SHD_PRECISION_FULL with that level_blend, for footprints of up to 4 textures.
 *
 * It applies to 2D textures of 8-bit unorm formats of one to four channels, the filters BILINEAR, BILINEAR_MIP,
 * TRILINEAR and ANISOTROPIC with equal weights of the probes, and every wrap except SHD_WRAP_BORDER. All other
 * lookups, derivatives of values, and shd_texture_explain() have SHD_PRECISION_FULL.
 *
 * Choose it for pictures of 8 bits. Keep SHD_PRECISION_FULL for measurements, and for values whose differences
 * matter, such as heights and normals.
 */
export type Precision =
  | "full"
  | "fast"
  ;

/**
 * Random choice of SHD_FILTER_STOCHASTIC. The expected value of each is the named filter F = sum of w_k t_k, with
 * the
 * texels t_k and their weights w_k.
 * - `texel`: One texel, with its weight as the probability. Variance: sum of w_k (t_k - F)^2.
 * - `quad`: One of the two levels of TRILINEAR, or one probe of ANISOTROPIC and one of its levels; then the
 * bilinear lookup
 * b_i of its four texels, or eight in 3D. With the probabilities p_i the variance is sum of p_i (b_i - F)^2: the
 * variance of one texel less the mean variance within a quad. Where the level of detail is at most 0, trilinear
 * has
 * none. Other filters are refused.
 */
export type Stochastic =
  | "texel"
  | "quad"
  ;

/**
 * Lookups where a tile of the texture is not in memory (shd/tile_cache.h). No effect for other textures.
 * - `wait`: load the tile; the result does not depend on the content of the cache
 * - `coarser`: Never load and wait for no callback: filter from the finest levels with resident tiles, and request
 * missing ones
 * (shd_tile_cache_load_requested()). A lookup that needs a missing tile of level l is done again with a level of
 * detail of at least l + 1, and so on; BILINEAR and BICUBIC become BILINEAR_MIP, and NEAREST becomes NEAREST_MIP.
 * If no tile of any level is resident, the result is 0. shd_texels has the column `coarser`.
 */
export type MissingTiles =
  | "wait"
  | "coarser"
  ;

/**
 * Comparisons `z OP d`: of a depth z with the depth d of a sample in depth tests, or of a reference z with a texel
 * d in
 * comparison lookups (shd_sampler_desc.compares). If z or d is NaN, every comparison except ALWAYS is false.
 * - `less`: z < d
 * - `less_equal`: z <= d
 * - `equal`: z = d
 * - `greater_equal`: z >= d
 * - `greater`: z > d, for depth that decreases with the distance (clear_depth 0)
 * - `not_equal`: z < d or z > d
 * - `always`: true
 * - `never`: false
 */
export type Compare =
  | "less"
  | "less_equal"
  | "equal"
  | "greater_equal"
  | "greater"
  | "not_equal"
  | "always"
  | "never"
  ;

/**
 * Computation of visibility from depths.
 * - `hard`: the nearest texel, 0 or 1
 * - `pcf`: The mean of n x n bilinear comparisons a texel apart (Reeves, Salesin and Cook, "Rendering Antialiased
 * Shadows
 * with Depth Maps", 1987). It varies continuously. Reads (n + 1)^2 texels, n = taps.
 * - `variance`: Chebyshev's bound of the distribution of depths in n x n texels, n = taps, interpolated from four
 * neighbours
 * (Donnelly and Lauritzen, "Variance Shadow Maps", 2006).
 * - `summed_area_variance`: Chebyshev's bound over a square of edge length filter_size around the point, from a
 * summed-area table (Lauritzen,
 * GPU Gems 3, 2007, 8).
 * - `pcss`: Penumbras that widen with the distance to the blockers (Fernando, "Percentage-Closer Soft Shadows",
 * 2005): the
 * mean depth of blockers from n x n texels, then the mean of n x n bilinear comparisons over the width of the
 * penumbra, n = taps. Only blockers that a ray from the point to the light meets determine the width, if there are
 * any (Guennebaud, Barthe and Paulin, "Real-Time Soft Shadow Mapping by Backprojection", 2006). Reads 5 n^2 texels
 * for any width; in wide penumbras they are not adjacent. The pattern of the texels is shifted at each point
 * (Cranley and Patterson, 1976) by a hash of the bits of its position, so penumbras have fine noise, less with
 * more
 * taps. Equal positions have equal patterns in every frame, tile and batch.
 */
export type ShadowFilter =
  | "hard"
  | "pcf"
  | "variance"
  | "summed_area_variance"
  | "pcss"
  ;

/**
 * Kinds of shapes.
 * - `sphere`: uses `radius`
 * - `box`: uses `size`
 * - `plane`: a rectangle, size[0] by size[2]
 * - `torus`: `radius` of the circle in the middle of the tube, `tube_radius`
 * - `teapot`: The Utah teapot: 32 bicubic Bezier patches by Martin Newell (1975), with the bottom that Frank Crow
 * added ("The
 * Origins of the Teapot", IEEE Computer Graphics and Applications 7(1), 1987). The body with its bottom, the lid,
 * the handle and the spout are separate open surfaces that meet or intersect.
 */
export type Shape =
  | "sphere"
  | "box"
  | "plane"
  | "torus"
  | "teapot"
  ;

/**
 * Coefficient of a material that a slot feeds.
 *
 * The value of the slot multiplies the constant of the same name in shd_material_desc, if there is one. Colours
 * have
 * three channels, scalars one.
 * - `diffuse`: colour k_d or base colour; the fourth channel multiplies opacity
 * - `ambient`: colour k_a
 * - `specular`: colour k_s
 * - `exponent`: scalar p
 * - `opacity`: scalar
 * - `emission`: colour
 * - `metallic`: scalar
 * - `roughness`: scalar
 * - `occlusion`: scalar o: ambient light times 1 + occlusion_strength (o - 1)
 * - `normal`: tangent-space normal in shd_material_desc.normal_encoding
 * - `height`: scalar height, for bumps and parallax; takes 2D textures only
 * - `matcap`: colour by the direction of the normal in view; takes 2D textures only
 * - `normal_mixed`: scalar: mixed moment of slopes; read with SHD_NORMAL_ENCODING_MOMENTS and
 * SHD_SLOT_NORMAL only. A constant slot gives slopes without covariance
 * - `clearcoat`: scalar: strength of the clear coat, clamped to 0..1
 * - `clearcoat_roughness`: scalar: roughness of the clear coat
 * - `clearcoat_normal`: tangent-space normal of the clear coat, SHD_NORMAL_ENCODING_XYZ with z > 0
 */
export type SlotTarget =
  | "diffuse"
  | "ambient"
  | "specular"
  | "exponent"
  | "opacity"
  | "emission"
  | "metallic"
  | "roughness"
  | "occlusion"
  | "normal"
  | "height"
  | "matcap"
  | "normal_mixed"
  | "clearcoat"
  | "clearcoat_roughness"
  | "clearcoat_normal"
  | "tint"
  ;

/**
 * Source of the values of a slot.
 * - `constant`: 1; for the normal (0, 0, 1) in tangent space
 * - `texture`: `texture` through `sampler`: 2D at uv, 3D at the place of a point. If it is
 * SHD_TEXTURE_PREMULTIPLIED, the slots
 * DIFFUSE and TINT have r / a, g / a, b / a of the lookup, or 0 where a is not positive; other slots read the
 * lookup as it is.
 * - `vertex`: interpolated attributes of the mesh from `attribute` on; 1 for absent ones
 * - `procedure`: `procedure`
 * - `solid`: colours of `solid` at the place of a point
 */
export type SlotSource =
  | "constant"
  | "texture"
  | "vertex"
  | "procedure"
  | "solid"
  ;

/**
 * Space of the places at which solid textures are evaluated.
 * - `object`: Object space: the position in world space through the inverse of shd_draw.object_to_world. The
 * pattern moves with
 * the object. If the matrix has no inverse, the place is 0 before place_transform.
 * - `world`: world space: objects move through the pattern
 */
export type PlaceSpace =
  | "object"
  | "world"
  ;

/**
 * Pattern of a solid texture; the file's comment has the formulas.
 * - `stripes`: two colours, across x
 * - `checker`: cubes of two colours
 * - `perlin`: gradient noise on the integer lattice
 * - `value`: interpolated random values
 * - `simplex`: gradient noise on a lattice of tetrahedra
 * - `worley`: distances to random points
 * - `marble`: waves across x, distorted by turbulence
 * - `wood`: rings around y, distorted by noise
 */
export type Solid =
  | "stripes"
  | "checker"
  | "perlin"
  | "value"
  | "simplex"
  | "worley"
  | "marble"
  | "wood"
  ;

/**
 * Sum of octaves.
 * - `fbm`: fractional Brownian motion: the sum of n
 * - `turbulence`: the sum of |n|
 */
export type SolidSum =
  | "fbm"
  | "turbulence"
  ;

/**
 * Gradients of SHD_SOLID_PERLIN.
 * - `hashed`: twelve gradients, chosen by an integer hash; fastest
 * - `table`: 256 random unit vectors, through a permutation table
 */
export type SolidGradients =
  | "hashed"
  | "table"
  ;

/**
 * Weight of a lattice point at distance t along an axis.
 * - `quintic`: second derivatives are continuous
 * - `cubic`: first derivatives are continuous
 */
export type SolidFade =
  | "quintic"
  | "cubic"
  ;

/**
 * Distance of SHD_SOLID_WORLEY.
 * - `f1`: to the nearest feature point
 * - `f2`: to the second nearest feature point
 * - `f2_f1`: F2 - F1: 0 on the borders between the cells of the points
 */
export type SolidDistance =
  | "f1"
  | "f2"
  | "f2_f1"
  ;

/**
 * Number of parts of an edge.
 * - `uniform`: `segments` for each edge: a triangle becomes segments^2
 * - `adaptive`: The smallest number for which no part is longer than `edge_length`. It depends only on the
 * positions of the
 * edge's two ends, so triangles on both sides agree and no cracks open, even where uv or normals differ.
 */
export type TessellationMode =
  | "uniform"
  | "adaptive"
  ;

/**
 * Normals of a displaced mesh.
 *
 * The mean of face normals, weighted by area. Vertices that shared position and normal before displacement share
 * the
 * mean. Seams of uv therefore stay smooth, and creases stay sharp.
 * - `tilted`: The previous normals, tilted by the slope of the heights: n - grad h, where grad h is the gradient
 * on the faces
 * around the vertex before displacement. Coarse triangles with smooth normals keep their smooth look.
 * - `kept`: the previous normals
 * - `faces`: the normals of the faces around the vertex after displacement
 */
export type DisplacedNormals =
  | "tilted"
  | "kept"
  | "faces"
  ;

/**
 * Prefiltered tables of a texture; combine with |.
 * - `none`: the base level alone
 * - `mipmap`: levels max(1, floor(size / 2^l)) down to 1 x 1 (Williams 1983); 4/3 of the memory
 * - `ripmap`: Levels max(1, floor(width / 2^i)) x max(1, floor(height / 2^j)) for every i and j. Takes at most 4
 * times the
 * memory, including the mipmap, whose levels are shared. For textures of up to 2^26 texels.
 * - `summed_area`: Sums over all rectangles at the origin (Crow 1984): (width + 1) x (height + 1) sums for every
 * stored channel and
 * layer. A sum takes 4 bytes for 8-bit unorm of up to 2^24 texels a layer, else 8, and 4 more where a binary16 or
 * binary32 texel is not finite. Sums are exact for unorm. For sRGB and floats of magnitude up to m they are within
 * 2^-51 width height m.
 */
export type Table =
  | "none"
  | "mipmap"
  | "ripmap"
  | "summed_area"
  ;

/**
 * Source of an output channel.
 * - `default`: the channel at the same position; `fill` if the format lacks it
 * - `fill`: the element of `fill` at the same position
 */
export type Channel =
  | "default"
  | "r"
  | "g"
  | "b"
  | "a"
  | "fill"
  ;

/**
 * Options of a texture; combine with |.
 * - `borrow`: Borrow `texels` until release instead of copying them. Only shd_texture_update() may change them.
 * Requires one
 * layer of packed rows, or packed slices of packed rows, a format without three channels or RGB9E5, and texels
 * aligned to min(size of a texel, 4) bytes. SHD_TEXTURE_PADDING bytes behind the last texel must be readable,
 * because lookups load whole vectors. Blocks need neither the alignment nor the padding, and must not change while
 * the texture lives, because decoded blocks are kept between calls. Lookups give the same bits as for copied
 * texels.
 * - `borrow_levels`: With SHD_TEXTURE_BORROW: borrow the mip levels as well. Levels 0, 1, 2 ... then follow one
 * another without gaps
 * from `texels` on, as in a file that is mapped to memory; `levels` has their addresses. Not for 3D textures, and
 * not for blocks. shd_texture_update() gives SHD_ERROR_UNSUPPORTED.
 * - `premultiplied`: The texels are premultiplied: r, g and b are multiplied by a. Lookups give such numbers, too.
 * The slots
 * SHD_SLOT_DIFFUSE and SHD_SLOT_TINT divide filtered r, g and b by filtered a (shd/slot.h).
 */
export type TextureFlag =
  | "none"
  | "borrow"
  | "borrow_levels"
  | "premultiplied"
  ;

/**
 * Depths of the near and far plane.
 * - `forward`: 0 near .. 1 far
 * - `reversed`: 1 near .. 0 far, for draws that compare with SHD_COMPARE_GREATER and a clear_depth of 0.
 */
export type DepthOrder =
  | "forward"
  | "reversed"
  ;

/**
 * Interpolation of a varying from the three vertices of a triangle to a fragment.
 * - `perspective`: Linear on the triangle itself.
 * - `affine`: Linear on the screen between the three projected vertices, also for clipped triangles. If a vertex
 * cannot be
 * projected (w < 2^-100, or more than 2^60 pixels away), PERSPECTIVE is used.
 * - `flat`: The value of the triangle's first vertex, for all fragments and at every frequency.
 */
export type Interpolation =
  | "perspective"
  | "affine"
  | "flat"
  ;

/**
 * Texel that index i reads along an axis of n texels (Vulkan specification, "Wrapping Operation").
 * - `repeat`: i mod n
 * - `clamp`: clamp(i, 0, n - 1)
 * - `mirror`: repeat with every second copy flipped
 * - `border`: the border colour outside 0..n - 1
 * - `mirror_once`: one flipped copy below 0, clamped beyond: clamp(i < 0 ? -1 - i : i, 0, n - 1)
 */
export type Wrap =
  | "repeat"
  | "clamp"
  | "mirror"
  | "border"
  | "mirror_once"
  ;

/** Statistics of a bake. */
export interface BakeStats {
  /** in all draws */
  triangles: number;
  /** without area in texture coordinates, rounded to 1/256 texel; not baked */
  zeroAreaTriangles: number;
  /** with a position or texture coordinate that is not finite; not baked */
  nonfiniteTriangles: number;
  /** with a corner outside 0..1; the part inside is baked */
  outsideTriangles: number;
  /** texels of SHD_TEXEL_STATE_CENTRE */
  centreTexels: number;
  /** texels of SHD_TEXEL_STATE_TOUCHED */
  touchedTexels: number;
  /** texels of SHD_TEXEL_STATE_DILATED */
  dilatedTexels: number;
  /** texels whose centre several triangles cover */
  overlappingTexels: number;
  /** shaded texels whose r, g, b or a is NaN or infinite (kept as written) */
  nonfiniteTexels: number;
}

/** Options of a bake; nothing is required. */
export interface BakeDesc {
  /** texture coordinates at which triangles lie: 0 = uv of the mesh, 1 = uv1; default 0 */
  uvSet?: number;
  /**
   * Largest distance [texels], 0..1024, over which empty texels get a copy of the nearest shaded texel, in all
   * planes
   * except depth: seams then do not mix with the background when the texture is filtered. Distances are between
   * centres; of equally near texels the one in the upper row is copied, then the left one. Default 0 = none.
   */
  dilation?: number;
  /** reserved; 0 */
  flags?: number;
  /** shd_texel_state of width * height texels; default not wanted */
  states?: OutColumn;
  /** its struct_size is read; NULL = not wanted; all zero on failure */
  stats?: BakeStats | BakeStats[];
}

/** The precision of implementations. Defaults are the rules of SHD_RULES_VULKAN. */
export interface BoundsDesc {
  /** at least one; default LENGTHS | ELLIPSE | VULKAN */
  levelRules?: LevelRule | (string & {}) | number;
  /** fraction bits of a texel coordinate, 2..24; default 4 */
  subtexelBits?: number;
  /** fraction bits of a level of detail, 1..24; default 4 */
  levelBits?: number;
  /** bits of the weights of texels, 1..24; 0 = exact; default 9 */
  weightBits?: number;
  /** bits of the results of unorm formats, 1..24; 0 = not rounded; default 8 */
  resultBits?: number;
  /** error of a coordinate, relative to max(1, |u|), 0..1/16; default 2^-21 */
  coordinateError?: number;
  /** relative error of the derivatives, 0..1/2; default 0 */
  derivativeError?: number;
  /** error of a level of detail before bias, 0..16; default 2^-10 */
  levelError?: number;
  /** error of a result relative to the largest texel, 0..1; default 2^-16 */
  relativeError?: number;
  /** error of a decoded sRGB texel [codes], 0..1; default 1/2 */
  srgbError?: number;
}

/**
 * Host memory. Frozen.
 *
 * Set both callbacks or neither (then malloc and free). They run on any thread, workers of the executor included.
 * They
 * must not throw, longjmp or call shd.
 */
export interface Allocator {
  /** Returns `size` > 0 bytes aligned to `alignment` (a power of two, at least 8), or NULL. */
  allocate?: number;
  /**
   * Frees memory that `allocate` returned. `size` and `alignment` are those of its allocation; `memory` is never
   * NULL.
   */
  free?: number;
}

/**
 * Host job system. Frozen.
 *
 * Zero = the built-in executor: oneTBB if the library was built with it, else the calling thread. The built-in
 * executor
 * also uses the calling thread if no thread can be started, in contexts that a child process inherits by fork(),
 * and in
 * all contexts of a child whose parent has used oneTBB.
 */
export interface Executor {
  /**
   * Runs task(task_data, i, worker) once for every i in [0, count), in any order and on any threads, and returns
   * when
   * all are done. Tasks that run concurrently must have different values of `worker`. A result other than SHD_OK
   * makes the call of shd fail with SHD_ERROR_CALLBACK. Runs on the thread that called shd; must not throw or
   * longjmp; may call shd.
   */
  parallelFor?: number;
  /**
   * `worker` is below this number, 1..1024; scratch memory is allocated for this number
   * of workers
   */
  workerCount?: number;
}

/** Host log. Frozen. Without a log shd writes nothing: it never uses stdout or stderr. */
export interface Log {
  /** Takes one line without newline. Any thread, calls may be concurrent; must not throw, longjmp or call shd. */
  write?: (level: LogLevel, message: string) => void;
}

/** Options of a context. Zero is the default of each. */
export interface ContextDesc {
  /** default 0 */
  flags?: ContextFlag | (string & {}) | number;
  /**
   * threads of the built-in executor, 0..1024, at most one per core; 1 = calling thread;
   * default 0 = one per core
   */
  workerCount?: number;
  /** default SHD_SIMD_BEST; SHD_ERROR_UNSUPPORTED if it cannot run here */
  simd?: Simd | number;
  /** default malloc and free; huge pages are requested for blocks of 8 MiB and more */
  allocator?: Allocator;
  /** default built-in */
  executor?: Executor;
  /** default none */
  log?: Log | ((level: LogLevel, message: string) => void);
}

/** Edges to find. */
export interface EdgesDesc {
  /** kinds to find; default SHD_EDGE_ALL */
  edges?: Edge | (string & {}) | number;
  /**
   * Eye in object space, finite: the point (x, y, z) with w = 1, or with w = 0 the direction to an eye at
   * infinity.
   * Any other (x, y, z, w) except 0 is the point (x, y, z) / w. Default (0, 0, 1, 0).
   */
  eye?: Numbers;
  /** -1..1; default 0.5: edges of 60 degrees and sharper */
  creaseCosine?: number;
}

/** Columns for edges; NULL = not wanted. */
export interface Edges {
  /** the two ends, in the direction of the first triangle */
  vertex?: OutColumns;
  /** the first triangle, and the other one; 0xffffffff for borders and non-manifold edges */
  triangle?: OutColumns;
  /** shd_edge bits, among the requested ones */
  kinds?: OutColumn;
}

/** Image and tables of an environment. Required: image. */
export interface EnvironmentDesc {
  /** any but SHD_PROJECTION_NONE; default SHD_PROJECTION_LAT_LONG */
  projection?: Projection | number;
  /**
   * Linear radiance, of any format and of 1 x 1 up to 2^26 pixels; borrowed for the call. One channel means grey;
   * the
   * fourth is ignored. CUBE takes the six faces on top of each other: height = 6 width. MIRROR_BALL, ANGULAR and
   * OCTAHEDRAL are square. Channels that are negative or NaN count as 0, and those above 1e12 as 1e12;
   * shd_environment_info counts them.
   */
  image: Image;
  /** default SHD_IRRADIANCE_HARMONICS */
  irradiance?: Irradiance | number;
  /** default SHD_ENVIRONMENT_TABLE_ALL */
  tables?: EnvironmentTable | (string & {}) | number;
}

/** Properties of an environment. */
export interface EnvironmentInfo {
  /** as in its desc */
  projection: Projection | number;
  /** as in its desc */
  irradiance: Irradiance | number;
  /** as in its desc, with SHD_ENVIRONMENT_TABLE_RADIANCE if there are lobes */
  tables: EnvironmentTable | (string & {}) | number;
  /** texels a side of the largest map, 0 without SHD_ENVIRONMENT_TABLE_RADIANCE */
  mapSize: number;
  /** mean radiance of all directions */
  mean: Numbers;
  /** channels of the image that were negative, NaN or above 1e12 */
  replacedCount: number;
  /** bytes of all tables */
  byteSize: number;
}

/** Lookups of an environment, as columns of `count` elements. */
export interface EnvironmentLookups {
  /** number of lookups; 0 is allowed */
  count?: number;
  /** x, y, z, any length; required. 0, NaN and infinity count as +Z */
  direction?: Columns;
  /**
   * Roughness of a GGX lobe around the direction, clamped to 0..1, NaN = 1: the mean of the radiance, weighted by
   * D(h) n.l with n = v = direction (Karis, "Real Shading in Unreal Engine 4", 2013). Only for environments with
   * SHD_ENVIRONMENT_TABLE_GGX.
   */
  roughness?: Column;
  /**
   * Exponent p of a Phong lobe around the direction r, clamped to 0..1e6, NaN = 0: the mean of the radiance,
   * weighted
   * by max(0, r.l)^p. Only for environments with SHD_ENVIRONMENT_TABLE_PHONG. Without roughness and exponent,
   * lookups
   * give the radiance itself.
   */
  exponent?: Column;
}

/** Columns for irradiance or radiance; NULL = not wanted. */
export interface EnvironmentLight {
  /** red, green, blue; irradiance, or radiance in the unit of the image */
  rgb?: OutColumns;
}

/** A texel that a lookup reads. Grows with shd_explanation.tap_size. */
export interface Tap {
  /** layer of the array */
  layer: number;
  /** number of times the width was halved: the mip level, or the ripmap's level across */
  levelU: number;
  /** number of times the height was halved: the mip level, or the ripmap's level down */
  levelV: number;
  /** column, after wrapping */
  x: number;
  /** row, after wrapping */
  y: number;
  /** 1 = the border colour instead of the texel, else 0 */
  border: number;
  /** share of the result; the weights of all taps sum to 1 up to rounding */
  weight: number;
  /**
   * stored channels as the blends read them: unorm channels as integers, unless a wrap is
   * SHD_WRAP_BORDER; comparison lookups: 0 or 1 in the channel of r
   */
  value: Numbers;
  /** slice of a 3D texture, after wrapping; else 0 */
  z: number;
}

/** A blend of two nodes of the tree. Grows with shd_explanation.blend_size. */
export interface BlendStep {
  /** node */
  a: number;
  /** node */
  b: number;
  /** weight of b */
  s: number;
}

/** An explanation, with the caller's memory for its tables. */
export interface Explanation {
  /** [tap_capacity]; gets the first taps; NULL with a capacity of 0 */
  taps?: Tap | Tap[];
  /** [blend_capacity]; gets the first blends; NULL with a capacity of 0 */
  blends?: BlendStep | BlendStep[];
  /** bytes of the caller's shd_tap; set by shd_explanation_default() */
  tapSize?: number;
  /** elements of `taps` */
  tapCapacity?: number;
  /** written: taps of the lookup */
  tapCount?: number;
  /** bytes of the caller's shd_blend_step; set by shd_explanation_default() */
  blendSize?: number;
  /** elements of `blends` */
  blendCapacity?: number;
  /** written: blends of the lookup; fewer than taps */
  blendCount?: number;
  /** written: the filter that was used, after magnification */
  filter?: Filter | number;
  /** written: r, g, b, a of shd_texture_sample() with SHD_PRECISION_FULL */
  result?: Numbers;
  /** written: level of detail of trilinear in the profile, after bias and clamps */
  lod?: number;
  /** written: factor from the blends' units to the result, by stored channel */
  scaleHigh?: Numbers;
  /** written: lower bits of that factor */
  scaleLow?: Numbers;
  /** Written: the stored channel of r, g, b, a of the result; 4 = a constant: `fill`, or 0, 0, 1 of comparisons. */
  channelSource?: Numbers;
  /**
   * Written: longer half axis of the footprint's ellipse, u and v in base-level texels, width and blur included;
   * (2^lod, 0) if the lookup has a level of detail. At most 2^100 long. 3D textures: the first two components.
   */
  longerAxis?: Numbers;
  /** written: the shorter half axis, before any limit of anisotropy; 0 for 3D textures */
  shorterAxis?: Numbers;
}

/** Columns for derivatives per pixel step; NULL = not wanted. */
export interface Derivatives {
  /** du/dx */
  dudx?: OutColumn;
  /** dv/dx */
  dvdx?: OutColumn;
  /** du/dy */
  dudy?: OutColumn;
  /** dv/dy */
  dvdy?: OutColumn;
}

/** Hits of rays with their differentials, as columns of `count` elements; x, y, z in one space. */
export interface RayDifferentials {
  /** number of hits; 0 is allowed */
  count?: number;
  /** change of the surface point with u; required */
  dpdu?: Columns;
  /** change of the surface point with v; required */
  dpdv?: Columns;
  /** direction of the ray, any length; required */
  direction?: Columns;
  /** distance to the hit, in lengths of `direction`; absent = 0 */
  distance?: Column;
  /** change of the ray's origin per pixel step in x; absent = 0 */
  originDx?: Columns;
  /** change of the ray's origin per pixel step in y; absent = 0 */
  originDy?: Columns;
  /** change of `direction` per pixel step in x; absent = 0 */
  directionDx?: Columns;
  /** change of `direction` per pixel step in y; absent = 0 */
  directionDy?: Columns;
}

/** Hits of rays with their cones, as columns of `count` elements; x, y, z in one space. */
export interface RayCones {
  /** number of hits; 0 is allowed */
  count?: number;
  /** change of the surface point with u; required */
  dpdu?: Columns;
  /** change of the surface point with v; required */
  dpdv?: Columns;
  /** direction of the ray, any length; required */
  direction?: Columns;
  /** diameter of the cone at the hit, in the units of the points; required */
  width?: Column;
}

/** Size and planes of a framebuffer. Required: width, height. */
export interface FramebufferDesc {
  /** pixels, 1..16384 */
  width?: number;
  /** pixels, 1..16384 */
  height?: number;
  /** per pixel: 1, 2, 4, 8 or 16, at shd_sample_position(); default 1 */
  samples?: number;
  /** optional planes; default none */
  aovs?: Aov | (string & {}) | number;
  /**
   * Storage of colour: SHD_FORMAT_RGBA32F, four planes; or interleaved SHD_FORMAT_RGBA16F, _RGBA8_SRGB or _RGBA8.
   * Default SHD_FORMAT_RGBA32F. Targets are planes in any case. shd_render with SHD_RENDER_LOAD reads colour as it
   * was rounded.
   */
  colorFormat?: Format | number;
}

/** Size and planes of a framebuffer. */
export interface FramebufferInfo {
  /** pixels */
  width: number;
  /** pixels */
  height: number;
  /** per pixel */
  samples: number;
  /** optional planes */
  aovs: Aov | (string & {}) | number;
  /** storage of colour */
  colorFormat: Format | number;
  /** bytes of all planes and pixels */
  byteSize: number;
}

/** A plane in place: no copy. */
export interface PlaneView {
  /** [height][row_stride / 4]; NULL for planes of uint32_t */
  f32: Numbers;
  /** [height][row_stride / 4]; NULL for planes of floats */
  u32: Numbers;
  /** bytes between rows */
  rowStride: number;
}

/** Conversion of linear colour for a display: a transform of libshd_color, or a function of the caller. Frozen. */
export interface Display {
  /**
   * Fills every pixel of `out`, a packed RGBA32F image of the framebuffer's size, with display colour: encoded,
   * straight alpha, 0..1. Runs on the thread of the call that takes the shd_display; must not throw or longjmp. A
   * result other than SHD_OK, with its text from shd_report_error(), becomes the result of the call. NULL = none.
   */
  apply?: number;
}

/** An image in the caller's memory. Required: format, width, height, pixels. */
export interface Image {
  /** storage of `pixels` */
  format: Format | number;
  /** pixels, 1..65536 */
  width?: number;
  /** pixels, 1..65536 */
  height?: number;
  /**
   * [height][width], row 0 on top; borrowed for the call; blocks are
   * [ceil(height / 4)][ceil(width / 4)]
   */
  pixels: Pixels;
  /** bytes between rows of pixels or blocks, at least the bytes of a row; 0 = packed */
  rowStride?: number;
}

/** Kind, intensity and placement of a light. */
export interface LightDesc {
  /** default SHD_LIGHT_KIND_POINT */
  kind?: LightKind | number;
  /**
   * I, scene-linear RGB, 0..1e12; default 1. Points and spots: E = 1 at distance r takes
   * I = r^2
   */
  intensity?: Numbers;
  /**
   * position of points, spots and the cookie of directional lights; world space, finite;
   * default 0
   */
  position?: Numbers;
  /**
   * directional lights and spots: direction of the light rays, world space, any length
   * except 0; default (0, -1, 0)
   */
  direction?: Numbers;
  /**
   * points and spots: distance from which E is 0 [world units]; default 0 = no limit. Lights
   * with a finite range are culled beyond it
   */
  range?: number;
  /** spots: half angle of the full cone [rad], 0..outer_angle; default 0 */
  innerAngle?: number;
  /**
   * spots: half angle of the cone [rad], 0.001..pi/2, with a cookie up to 1.55; default
   * pi/4
   */
  outerAngle?: number;
  /**
   * up direction of the cookie and of shadow maps, world space. Orthogonalised against
   * `direction`; replaced by another direction if parallel to it. Default (0, 1, 0)
   */
  up?: Numbers;
  /**
   * directional lights: width and height of the cookie [world units], above 0; default 1.
   * The centre of the cookie lies on the ray from `position`; with wraps that repeat, the
   * cookie tiles the plane
   */
  extent?: Numbers;
  /**
   * Light cookie: a texture of colours that multiply E, as seen from the light. It covers the square around the
   * outer
   * cone of a spot, or a rectangle of size `extent` for a directional light. The fourth channel is ignored. Points
   * and ambient lights have no cookie. NULL = none; retained.
   */
  texture?: Texture | null;
  /** sampler of `texture`; NULL = bilinear, black outside; retained */
  sampler?: Sampler | null;
}

/** Points to look up, as columns of `count` elements. Required: u, v. Absent columns are NULL. */
export interface Lookups {
  /** number of lookups; 0 is allowed */
  count?: number;
  /** normalised coordinate across; required */
  u: Column;
  /** normalised coordinate down; required */
  v: Column;
  /** du/dx per pixel step; absent = 0 */
  dudx?: Column;
  /** dv/dx; absent = 0 */
  dvdx?: Column;
  /** du/dy; absent = 0 */
  dudy?: Column;
  /** dv/dy; absent = 0 */
  dvdy?: Column;
  /** log2 of the footprint in base texels; replaces the derivatives, width and blur */
  lod?: Column;
  /** layer of the array; absent = 0; numbers beyond the last layer mean the last layer */
  layer?: Column;
  /** random bits of SHD_FILTER_STOCHASTIC; absent = hashed from u, v and, if read, w */
  random?: Column;
  /**
   * third coordinate: across the slices of a 3D texture, or of a direction; required by these
   * textures, without effect for others
   */
  w?: Column;
  /** dw/dx per pixel step, where w has effect; absent = 0 */
  dwdx?: Column;
  /** dw/dy; absent = 0 */
  dwdy?: Column;
  /** compared with texels by samplers with `compares`; absent = 0 */
  reference?: Column;
}

/** Columns for the filtered values: linear, and premultiplied only if the texels are. */
export interface Texels {
  /** r, g, b, a after the texture's swizzle; NULL = not wanted */
  channel?: OutColumns;
  /**
   * d/du and d/dv of the channels, with u and v normalised and the footprint held constant; NULL = not wanted.
   * Available for BILINEAR, BICUBIC, BILINEAR_MIP, TRILINEAR, RIPMAP, ANISOTROPIC and EWA, and for a magnification
   * filter in this list; other filters return SHD_ERROR_UNSUPPORTED. BILINEAR has kinks at texel centres; the
   * result
   * there is the derivative to the right. EWA has kinks where a texel enters the ellipse; the result there is the
   * derivative of the weights. du, dv and dw of a texture of directions are the derivatives in the three
   * components
   * of the direction, not normalised, with the footprint held constant in the image.
   */
  du?: OutColumns;
  dv?: OutColumns;
  /** written: lookups whose coordinates, derivatives or lod were not finite */
  nonfiniteCount?: number;
  /**
   * d/dw of the channels of a 3D texture or of one of directions, as du; NULL = not wanted.
   * 2D textures return SHD_ERROR_UNSUPPORTED
   */
  dw?: OutColumns;
  /**
   * 0 for lookups that found all their tiles. With SHD_MISSING_TILES_COARSER, l + 1 if a tile of level l is
   * missing
   * and coarser levels were filtered instead. NULL = not wanted.
   */
  coarser?: OutColumn;
}

/** Columns for levels of detail; NULL = not wanted. */
export interface Levels {
  /** continuous level of trilinear in the sampler's profile, after bias and clamps */
  lod?: OutColumn;
  /** nearest mip level: ceil(lod + 1/2) - 1, or the profile's */
  level?: OutColumn;
}

/**
 * Functions of the caller. Frozen.
 *
 * A C++ exception that reaches shd becomes SHD_ERROR_CALLBACK. The frame is undefined if a program throws,
 * longjmps or
 * changes the count.
 */
export interface MaterialProgram {
  /** required for SHD_MODEL_PROGRAM, else NULL */
  fragment?: (fragments: Fragments, out: Radiance) => void;
  /** for any model; NULL = only the matrices of view and draw */
  vertex?: (vertices: Vertices, out: VertexOutputs) => void;
}

/** Model and coefficients, scene-linear RGB. */
export interface MaterialDesc {
  /** default SHD_MODEL_LAMBERT */
  model?: Model | number;
  /** shown instead of the model; default SHD_DEBUG_VIEW_NONE */
  debugView?: DebugView | number;
  /** default none */
  flags?: MaterialFlag | (string & {}) | number;
  /**
   * k_a, 0..1e6. Default -1 in all channels: k_a is ambient_share times the diffuse
   * colour, k_d times its slot. SHD_SLOT_AMBIENT replaces the slot of the diffuse
   * colour in this product
   */
  ambient?: Numbers;
  /**
   * 0..1; default 1/16; used if ambient is -1. METALLIC_ROUGHNESS multiplies k_a by its
   * base colour in any case, so k_a is ambient_share there
   */
  ambientShare?: number;
  /** k_d or base colour, 0..1e6; default 0.8 */
  diffuse?: Numbers;
  /** k_s, 0..1e6; default 0.5 */
  specular?: Numbers;
  /** p, 0..1e6; default 64 */
  exponent?: number;
  /** 0..1; default 0 */
  metallic?: number;
  /** 0..1; default 0.5 */
  roughness?: number;
  /**
   * index of refraction of GLASS, and of METALLIC_ROUGHNESS for the part that is not
   * metal, 1..10;
   * default 1.5
   */
  ior?: number;
  /** 0..1e12; default 0, so a slot needs a larger value here */
  emission?: Numbers;
  /** opacity of models, 0..1; default 1 */
  opacity?: number;
  /** effect of SHD_SLOT_OCCLUSION, 0..1; default 1 */
  occlusionStrength?: number;
  /**
   * [slot_count], all with the same struct_size, at most one for each target;
   * borrowed for the call; coefficients without a slot are constant
   */
  slots?: Slot | Slot[];
  /** default 0 */
  slotCount?: number;
  /** default SHD_NORMAL_ENCODING_XYZ */
  normalEncoding?: NormalEncoding | number;
  /** factor of x and y of mapped normals, -1e3..1e3; default 1 */
  normalScale?: number;
  /** default SHD_BUMP_NONE */
  bump?: Bump | number;
  /** factor of heights, -1e6..1e6; default 1 */
  bumpScale?: number;
  /**
   * Depth of height 0 below the surface [world units], 0..1e6; height 1 lies on the surface. At Phong frequency,
   * all
   * textures with the uv set of the height are looked up at the point where the line of sight meets the height
   * field
   * (parallax occlusion mapping, Tatarchuk 2006). The triangles do not move. Default 0 = off.
   */
  parallaxDepth?: number;
  /** maximum number of lookups of the height per fragment, 2..256; default 24 */
  parallaxSteps?: number;
  /** warm colour of GOOCH, 0..1e6; default (0.4, 0.4, 0) */
  warm?: Numbers;
  /** cool colour of GOOCH, 0..1e6; default (0, 0, 0.4) */
  cool?: Numbers;
  /** share of k_d added to `warm`, 0..1; default 0.6 */
  warmMix?: number;
  /** share of k_d added to `cool`, 0..1; default 0.2 */
  coolMix?: number;
  /** steps of TOON, 1..256; default 3 */
  toonSteps?: number;
  /** default SHD_BLEND_OPAQUE */
  blend?: Blend | number;
  /** fragments with a smaller alpha are dropped, 0..1; default 0 = none */
  alphaCutoff?: number;
  /** default none */
  program?: MaterialProgram;
  /**
   * [varying_count]; borrowed for the call; NULL = all
   * SHD_INTERPOLATION_PERSPECTIVE
   */
  interpolation?: (Interpolation | number)[];
  /**
   * varyings that program.vertex writes, 0..SHD_MAX_VARYINGS; 0 without
   * program.vertex
   */
  varyingCount?: number;
  /**
   * Strength c of a clear coat over METALLIC_ROUGHNESS, 0..1; default 0 = none. As KHR_materials_clearcoat of
   * glTF,
   * with its own roughness and normal n_c and F = 0.04 + 0.96 (1 - |n_c.v|)^5: the model times 1 - c F, plus the
   * sum
   * of E max(0, n_c.l) c F D V. Without SHD_SLOT_CLEARCOAT_NORMAL, n_c is the normal without normal maps and
   * bumps.
   * Ambient light and emission are not darkened. No effect on other models.
   */
  clearcoat?: number;
  /** 0..1; default 0 */
  clearcoatRoughness?: number;
}

/** Vertices and triangles of a mesh; copied. Required: vertex_count, position. */
export interface MeshDesc {
  /** 0..2^28; 0 makes an empty mesh */
  vertexCount?: number;
  /** x, y, z, object space; required unless vertex_count is 0 */
  position: Columns;
  /** x, y, z, object space, any length; all three or none; computed if absent */
  normal?: Columns;
  /** used when `normal` is absent; default SHD_NORMAL_WEIGHT_AREA */
  normalWeight?: NormalWeight | number;
  /** default none */
  flags?: MeshFlag | (string & {}) | number;
  /** x, y, z, object space, and handedness, +1 or -1; see @ref tangents. All four or none; stored unchanged. */
  tangent?: Columns;
  /** u, v; both or none; 0 if absent */
  uv?: Columns;
  /** u, v of a second set; both or none; 0 if absent */
  uv1?: Columns;
  /**
   * [attribute_count] columns for materials and programs, such as colours; any may be
   * absent
   */
  attributes?: Column[];
  /** 0..SHD_MAX_ATTRIBUTES; default 0 */
  attributeCount?: number;
  /** default SHD_TOPOLOGY_TRIANGLES */
  topology?: Topology | number;
  /**
   * Vertex numbers of the triangles in the order of `topology`; counter-clockwise = front. NULL = indices16; if
   * that
   * is NULL too, 0, 1, 2, ... In strips and fans the largest number (0xffffffff, or 0xffff in indices16) starts a
   * new
   * strip or fan.
   */
  indices?: Column;
  /** 16-bit vertex numbers; at most one of indices and indices16 is set */
  indices16?: Column;
  /** A multiple of 3 up to 3 * 2^28 for triangles, else up to 2^28 + 2. Without indices: 0 = vertex_count. */
  indexCount?: number;
}

/** Counts and bounds of a mesh. */
export interface MeshInfo {
  /** including the vertices that SHD_MESH_TANGENTS added */
  vertexCount: number;
  /** number of separate triangles, also for strips and fans */
  triangleCount: number;
  /** bound of the finite positions; 0 if there are none */
  boundsMin: Numbers;
  /** bound of the finite positions; 0 if there are none */
  boundsMax: Numbers;
  /** vertices with a position that is not finite */
  nonfiniteCount: number;
  /** vertices whose faces have no area or whose normal was 0; they get (0, 0, 1) */
  normallessCount: number;
  /**
   * SHD_MESH_TANGENTS: vertices without a tangent from uv; they get a perpendicular
   * one
   */
  tangentlessCount: number;
  /** SHD_MESH_TANGENTS: vertices that were added */
  splitCount: number;
}

/** Options of mip levels. Zero is the default of each except alpha_cutoff. */
export interface MipDesc {
  /** default SHD_TEXEL_CONTENT_COLOR */
  content?: TexelContent | number;
  /** default SHD_MIP_KERNEL_BOX */
  kernel?: MipKernel | number;
  /** default SHD_MIP_SOURCE_BASE */
  source?: MipSource | number;
  /**
   * texels beyond the edge, for kernels wider than the box; default SHD_WRAP_REPEAT.
   * With SHD_WRAP_BORDER only texels inside count, with weights scaled to sum 1
   */
  wrapU?: Wrap | number;
  /** as wrap_u, for v */
  wrapV?: Wrap | number;
  /** cutoff of SHD_TEXEL_CONTENT_ALPHA_COVERAGE, 0..1; default 0.5 */
  alphaCutoff?: number;
}

/** A tracer and its data. Frozen. */
export interface Tracer {
  /** NULL = none: depth maps */
  trace?: (rays: Rays, blocked: Uint32Array) => void;
}

/** Occluders and rays; borrowed for the call. Required: nothing. */
export interface OcclusionDesc {
  /** per point, 1..65536; default 64 */
  rays?: number;
  /** any value; default 0 */
  seed?: number;
  /** world length over which occluders count, > 0; default FLT_MAX = unlimited */
  radius?: number;
  /**
   * World length by which rays start above the surface, 0..1e9, besides 2^-18 of the largest coordinate of the
   * point.
   * Depth maps: shd_shadow_desc.bias. Default 0.
   */
  bias?: number;
  /** depth maps: edge length [texels], 16..8192; default 1024 */
  mapSize?: number;
  /** default none */
  tracer?: Tracer | ((rays: Rays, blocked: Uint32Array) => void);
  /**
   * Occluders of the depth maps, as in shd_shadow_render_desc; NULL if draw_count is 0. Not read if there is a
   * tracer, which has occluders of its own.
   */
  draws?: Draw | Draw[];
  /** up to 2^20 */
  drawCount?: number;
}

/** Points on surfaces; borrowed for the call. */
export interface OcclusionPoints {
  /** number of points; 0 is allowed */
  count?: number;
  /** x, y, z, world space; required unless count is 0 */
  position?: Columns;
  /** x, y, z, world space, any length; required unless count is 0 */
  normal?: Columns;
}

/** A texture of occlusion, with the coverage of shd/bake.h. Required: width, height. */
export interface OcclusionAtlas {
  /** texels, 1..16384 */
  width?: number;
  /** texels, 1..16384 */
  height?: number;
  /** as shd_bake_desc.uv_set: 0 or 1; default 0 */
  uvSet?: number;
  /** as shd_bake_desc.dilation, 0..1024 texels; default 0 */
  dilation?: number;
  /** value of texels that stay empty, finite; default 1 */
  empty?: number;
  /**
   * [draw_count] surfaces; mesh, object_to_world and instances are read; NULL if draw_count
   * is 0
   */
  draws?: Draw | Draw[];
  /** up to 2^20 */
  drawCount?: number;
  /** shd_texel_state of width * height texels; default not wanted */
  states?: OutColumn;
  /** statistics; its struct_size is read; NULL = not wanted; all zero on failure */
  stats?: BakeStats | BakeStats[];
}

/**
 * A polygon and the kind of its coordinates.
 *
 * The polygon is simple: its edges meet in its vertices only, where exactly two of them meet, and no edge is a
 * point.
 * Its vertices run in either direction. Convex kinds need a turn at every vertex.
 */
export interface PolygonDesc {
  /** default SHD_BARYCENTRIC_WACHSPRESS */
  kind?: Barycentric | number;
  /** [vertex_count] x and y, finite; required */
  vertex?: Columns;
  /** 3..SHD_MAX_POLYGON_VERTICES */
  vertexCount?: number;
  /**
   * HARMONIC: parts of each side of a triangle, 1..256; default 32. The solution has about
   * vertex_count segments^2 / 2 nodes. Nodes times vertices are limited to 2^24.
   */
  segments?: number;
}

/** Points at which coordinates are computed, as columns of `count` elements. Required: position. */
export interface PolygonPoints {
  /** number of points; 0 is allowed */
  count?: number;
  /** x and y; required */
  position: Columns;
}

/** Columns for the coordinates. */
export interface PolygonWeights {
  /** number of columns; vertex_count of the polygon */
  weightCount?: number;
  /** [weight_count] b_i, one column for each vertex; NULL columns are not wanted */
  weight?: OutColumn[];
  /** written: points outside the polygon */
  outsideCount?: number;
  /** written: points that are not finite */
  nonfiniteCount?: number;
}

/** Host callback for finished tiles. Frozen. */
export interface Present {
  /**
   * Called once for each tile of the framebuffer in no particular order, also for tiles that the frame does not
   * change. In a frame of several passes (shd_render_desc.pass_triangles) this is in the last pass, and with
   * supersampling after the last block. A result other than SHD_OK, with its text from shd_report_error(), becomes
   * the result of the render; tiles that follow are skipped. NULL = none.
   */
  tile?: (tile: PresentTile) => void;
}

/** Directions to project, as columns of `count` elements. */
export interface Directions {
  /** any but SHD_PROJECTION_NONE; required */
  projection?: Projection | number;
  /** number of directions; 0 is allowed */
  count?: number;
  /** x, y, z, any length; required */
  direction?: Columns;
  /** change of `direction` per pixel step in x; absent = 0 */
  directionDx?: Columns;
  /** change of `direction` per pixel step in y; absent = 0 */
  directionDy?: Columns;
}

/** Columns for points of images; NULL = not wanted. */
export interface ProjectedPoints {
  /** across, 0..1 */
  u?: OutColumn;
  /** down, 0..1 */
  v?: OutColumn;
  /** face of CUBE, 0..5; 0 for other projections */
  face?: OutColumn;
  /** du/dx, within +-1e30; for CUBE on the plane of the face */
  dudx?: OutColumn;
  /** dv/dx */
  dvdx?: OutColumn;
  /** du/dy */
  dudy?: OutColumn;
  /** dv/dy */
  dvdy?: OutColumn;
  /** written: directions that count as +Z */
  nonfiniteCount?: number;
}

/** Points of images, as columns of `count` elements. */
export interface ImagePoints {
  /** any but SHD_PROJECTION_NONE; required */
  projection?: Projection | number;
  /** number of points; 0 is allowed */
  count?: number;
  /** across, clamped to 0..1; LAT_LONG repeats; required */
  u?: Column;
  /** down, clamped to 0..1; required */
  v?: Column;
  /** face of CUBE; absent = 0; numbers above 5 mean 5; other projections ignore it */
  face?: Column;
}

/** Columns for the directions of points; NULL = not wanted. */
export interface PointDirections {
  /** x, y, z, unit; -Z outside the disc of MIRROR_BALL and ANGULAR */
  direction?: OutColumns;
  /**
   * Solid angle per area of (u, v) at the point [sr]; 0 outside the disc. A texel of a small image of n texels has
   * about the n-th part of it; the integral over the image (six faces) is 4 pi.
   */
  solidAngle?: OutColumn;
  /** written: points with a coordinate that is not finite; it counts as 0 */
  nonfiniteCount?: number;
}

/** All directions, in one image or six. Required: projection, images. */
export interface DirectionImages {
  /** any but SHD_PROJECTION_NONE */
  projection: Projection | number;
  /** arrangement of CUBE; default six images; others ignore it */
  layout?: CubeLayout | number;
  /**
   * One image, or the six of SHD_CUBE_LAYOUT_FACES, of one struct_size, format and size. Square for MIRROR_BALL,
   * ANGULAR and OCTAHEDRAL, and the size of the layout for CUBE. Borrowed for the call.
   */
  images: Image | Image[];
}

/**
 * One mesh in the frame. Required: mesh.
 *
 * Lines are rectangles around the edge, as long as the edge, with square ends (OpenGL 4.6 core specification,
 * 14.5, antialiased lines). Points are squares around the vertices. Both lie on the grid of 8 subpixel bits and
 * cover
 * samples as triangles do, so a line or point narrower than 1 may fall between samples. Depth varies along a line
 * and
 * is constant across it; a point has the depth of its vertex. depth_bias_slope uses these depths instead of the
 * triangle's. Attributes are interpolated at the pixel, with barycentric coordinates clamped to the triangle, and
 * texture coordinates clamped to those of its vertices; a triangle without area gives the mean of its corners.
 *
 * Culling drops all lines and points of a triangle. A triangle without area is dropped if `cull` is not NONE.
 * Clipping
 * at the near and far plane adds no edges. A vertex beyond these planes has no point, and an edge without length
 * has no
 * line. A shared edge or vertex is drawn once by each of its triangles, with the same samples and depths.
 * SHD_COMPARE_LESS therefore shows it once, but with SHD_DRAW_KEEP_DEPTH a blend is applied several times.
 *
 * SHD_FILL_LINES draws each edge of the mesh once, for triangles facing either way: `cull` has no effect. The edge
 * belongs to its first triangle: this triangle's vertices shade it, and it is ordered and counted with this
 * triangle.
 * Silhouettes are found for the centre of projection of world_to_view and view_to_clip (view.eye, if a camera made
 * the
 * view), or for the direction of a parallel projection. They depend on object_to_world and the positions of the
 * mesh;
 * vertex programs have no effect on them.
 *
 * A drawing without hidden lines takes two draws. The first draws the mesh as usual (without a material, if only
 * lines
 * shall be visible), with depth_bias 1e-5 and depth_bias_slope fill_width / 2 + 1. This bias moves the surface
 * behind
 * the lines that lie on its front. The second draws the lines with SHD_COMPARE_LESS_EQUAL. Lines over everything
 * use
 * SHD_COMPARE_ALWAYS.
 */
export interface Draw {
  /** required; borrowed for the call */
  mesh: Mesh | null;
  /** borrowed for the call; NULL = draw depth only, without programs */
  material?: Material | null;
  /** passed to the programs of the material; borrowed for the call; default NULL */
  uniforms?: Pixels;
  /** affine, finite; default identity */
  objectToWorld?: Numbers;
  /**
   * Object-to-world matrices, [instance_count][16], each affine and finite, instead of object_to_world. The mesh
   * is
   * drawn with each of them as if by separate draws, in order. Borrowed for the call.
   */
  instances?: Numbers;
  /** all draws together up to 2^20; default 0 = once, with object_to_world */
  instanceCount?: number;
  /** default SHD_FREQUENCY_PHONG */
  frequency?: Frequency | number;
  /** default none */
  flags?: DrawFlag | (string & {}) | number;
  /** default SHD_CULL_NONE */
  cull?: Cull | number;
  /** default SHD_COMPARE_LESS */
  compare?: Compare | number;
  /** added to depth, -1..1; the sum is clamped to 0..1; default 0 */
  depthBias?: number;
  /**
   * factor of another bias: the larger of |dz/dx| and |dz/dy| per pixel; finite;
   * default 0
   */
  depthBiasSlope?: number;
  /** default SHD_FILL_SOLID */
  fill?: Fill | number;
  /** width of lines and points [pixels], 1/16..64; default 0 = 1 */
  fillWidth?: number;
  /** edges of SHD_FILL_LINES; default SHD_EDGE_ALL */
  edges?: Edge | (string & {}) | number;
  /** threshold of SHD_EDGE_CREASE, as in shd_edges_desc: -1..1; default 0.5 */
  creaseCosine?: number;
}

/** Statistics of a frame: the counts from nonfinite to rasterised add up to `triangles`. */
export interface RenderStats {
  /** in all draws */
  triangles: number;
  /** dropped: a vertex is NaN or infinite after transformation */
  nonfinite: number;
  /** dropped: outside the view volume */
  outside: number;
  /**
   * dropped: facing the culled way, without area on the pixel grid, or
   * (SHD_FILL_LINES) without a visible edge that belongs to the triangle
   */
  culled: number;
  /** dropped: between pixel centres */
  empty: number;
  /** drawn, hidden or not */
  rasterised: number;
  /** cut by a clip plane, among outside, culled, empty and rasterised */
  clipped: number;
  /**
   * shaded; opaque draws count a pixel once for every triangle that is visible in
   * it, in each pass (shd_render_desc.pass_triangles)
   */
  fragments: number;
  /** fragments whose r, g, b or a was NaN or infinite (kept as written) */
  nonfiniteFragments: number;
  /**
   * covered, but failed the depth test before shading; 0 without
   * SHD_RENDER_COUNT_HIDDEN. Draws that blend or drop fragments may be tested against
   * stale depth, so their count is approximate
   */
  hiddenSamples: number;
  /**
   * PAINTER and NEWELL: pairs of triangles or pieces that overlap on the screen where the one painted first is
   * nearer
   * somewhere in the overlap, by more than the tolerance of NEWELL. A lower bound where triangles are dense: pairs
   * are searched in the cells of a grid, and in a cell of n triangles up to 64 n + 1024 pairs are compared.
   */
  orderConflicts: number;
  /** cuts of NEWELL */
  splits: number;
  /**
   * peak of working memory, with what the context keeps from earlier calls; depends on
   * the number of workers
   */
  scratchBytes: number;
  /** wall-clock time of transforming vertices */
  vertexSeconds: number;
  /** wall-clock time of finding visible triangles and clipping them */
  assemblySeconds: number;
  /** wall-clock time of sorting triangles by distance (if at all) and into tiles */
  binningSeconds: number;
  /** wall-clock time of coverage, shading and blending */
  tileSeconds: number;
}

/** Host progress callback. Frozen. */
export interface Progress {
  /**
   * Called after each piece of the frame, with the finished fraction of the frame, (0, 1]. Runs on any worker;
   * calls
   * are never concurrent. Must not throw, longjmp or call shd. A result other than 0 cancels: the render returns
   * SHD_ERROR_CANCELLED and the framebuffer holds a part of the frame.
   */
  report?: (fraction: number) => boolean | void;
}

/** Rectangle of pixels of a picture. Frozen. */
export interface Region {
  /** first column from the left */
  x?: number;
  /** first row from the top */
  y?: number;
  /** columns */
  width?: number;
  /** rows */
  height?: number;
}

/**
 * A whole frame, or a window of it. All pointers are borrowed for the call. Required: framebuffer.
 *
 * Draws are projected to the picture. The framebuffer holds the window of the picture that begins at pixel
 * (crop_x,
 * crop_y). Its pixels have the same bits as in the whole picture.
 */
export interface RenderDesc {
  /** required */
  framebuffer: Framebuffer | null;
  /** linear, premultiplied RGBA; default 0 */
  clearColor?: Numbers;
  /** 0..1; default 1 */
  clearDepth?: number;
  /** default none */
  flags?: RenderFlag | (string & {}) | number;
  /**
   * Replaces `view`. An aspect of 0, the default, means the aspect of the viewport, or of the picture if there is
   * no
   * viewport. NULL = `view`.
   */
  camera?: Camera;
  /** default: identity matrices, eye at 0 */
  view?: View;
  /** default SHD_VISIBILITY_DEPTH */
  visibility?: Visibility | number;
  /**
   * [draw_count], all with the same struct_size, in order; NULL if draw_count is
   * 0
   */
  draws?: Draw | Draw[];
  /** up to 2^20 */
  drawCount?: number;
  /** [light_count]; NULL if light_count is 0 */
  lights?: (Light | null)[];
  /**
   * [light_count], each NULL or a shadow of shd/shadow.h that was rendered for a light of the same kind. The light
   * that reaches a fragment is multiplied by the visibility at its position, with its shading normal. NULL = none.
   */
  shadows?: (Shadow | null)[];
  /** up to 2^20 */
  lightCount?: number;
  /** pixels, framebuffer size..65536; default 0 = framebuffer size */
  pictureWidth?: number;
  /** pixels, framebuffer size..65536; default 0 = framebuffer size */
  pictureHeight?: number;
  /**
   * column of the picture at which the framebuffer begins; the framebuffer lies
   * inside the picture; default 0
   */
  cropX?: number;
  /** row of the picture at which the framebuffer begins; default 0 */
  cropY?: number;
  /**
   * target of NDC -1..1 in the picture, not empty; cuts triangles, lines and points
   * at its edge; NULL = the whole picture
   */
  viewport?: Region;
  /** pixels of the picture that may change; NULL = all */
  scissor?: Region;
  /**
   * n, 2..16; 0 and 1 = off. The frame is drawn as a picture n times as large, up to 65536 pixels a side, with the
   * framebuffer's number of samples in each pixel; crop, viewport and scissor are scaled by n. Colour and targets
   * of
   * a pixel are the plain average of its n x n pixels; depth and the other planes have the values of the top left
   * one. Derivatives (and so footprints of textures) and raster positions in programs refer to the large picture;
   * lines and points are n times as wide in it. With SHD_RENDER_LOAD each of the n x n pixels starts with the
   * pixel's
   * values. The large picture is drawn in blocks of up to 1024 x 1024 pixels; only one block is in memory.
   * Statistics
   * are sums over blocks, so a triangle counts in each block.
   */
  supersampling?: number;
  /**
   * Largest number of triangles that are processed together, 1024..2^31-1; 0 = 2^21. A larger frame is drawn in
   * passes. A pass has several whole draws, each of which counts as at least 16 triangles, or a part of one draw.
   * The
   * framebuffer has the same bits for any number. Draws of SHD_BLEND_WEIGHTED and SHD_BLEND_SORTED form the last
   * pass
   * together. Only with SHD_VISIBILITY_DEPTH: the other methods order all triangles together.
   *
   * Working memory is at most 512 bytes for each of these triangles, 256 for each draw or instance, 24 for each
   * sample of the framebuffer and 16 more for each of its targets, and 8 MiB for each worker. Additional memory: 4
   * bytes for each tile of 64 x 64 pixels that a triangle touches beyond dozens, 48 for each piece of a clipped
   * triangle, 4 for each varying of up to three vertices a triangle, and the triangles of the last pass. A frame
   * in
   * several passes or with supersampling takes 16 bytes for each pixel of a framebuffer with interleaved colour.
   */
  passTriangles?: number;
  /**
   * statistics; its struct_size is read; NULL = not wanted. All zero on failure, except
   * where the struct_size or the unknown end of this desc is refused
   */
  stats?: RenderStats | RenderStats[];
  /** default none */
  progress?: Progress | ((fraction: number) => boolean | void);
  /** receives the finished tiles; default none */
  present?: Present | ((tile: PresentTile) => void);
  /**
   * Light from all directions, in addition to the lights; NULL = none. Every model with lights reflects it, except
   * GOOCH. It casts no shadows; SHD_SLOT_OCCLUSION multiplies all of its reflected light. It must
   * have been created with the tables of the models of the draws (shd_environment_desc.tables).
   */
  environment?: Environment | null;
  /** factor of its radiance, 0..1e12; default 1 */
  environmentIntensity?: number;
  /**
   * rotation or reflection of its directions, column-major, with orthonormal
   * columns within 1e-3; default identity
   */
  environmentToWorld?: Numbers;
  /** default SHD_BACKGROUND_CLEAR */
  background?: Background | number;
  /**
   * roughness of the GGX lobe that blurs the environment behind the picture, 0..1;
   * values above 0 need SHD_ENVIRONMENT_TABLE_GGX; default 0 = sharp
   */
  backgroundRoughness?: number;
  /**
   * [volume_count], all with the same struct_size. They are blended over the finished draws in this order, so the
   * caller sorts volumes from far to near. A ray of a pixel ends at the depth of a sample, with one march for all
   * samples of equal depth. Depth decreases with the distance if clear_depth is below 1/2, and increases
   * otherwise.
   * Depth and planes other than colour keep their values. NULL if volume_count is 0.
   */
  volumes?: VolumeDraw | VolumeDraw[];
  /** up to 1024; default 0 */
  volumeCount?: number;
}

/** Settings of a sampler. */
export interface SamplerDesc {
  /** default SHD_FILTER_TRILINEAR */
  filter?: Filter | number;
  /** default SHD_MAGNIFICATION_DEFAULT */
  magnification?: Magnification | number;
  /** default SHD_WRAP_REPEAT */
  wrapU?: Wrap | number;
  /** default SHD_WRAP_REPEAT */
  wrapV?: Wrap | number;
  /**
   * colour of texels outside with SHD_WRAP_BORDER: stored r, g, b, a, linear,
   * before the swizzle of the texture; channels that come from its `fill` are
   * `fill` outside, too; finite; default 0
   */
  border?: Numbers;
  /**
   * default SHD_PROFILE_LEAST_ERROR. It also determines which
   * lookups are magnified (shd_magnification)
   */
  profile?: Profile | number;
  /** added to the level of detail, -15..15; default 0 */
  lodBias?: number;
  /** lowest level of detail, 0..32; default 0; it is used where lod_max is lower */
  lodMin?: number;
  /** highest level of detail, 0..32; default 32 */
  lodMax?: number;
  /** factor of the derivatives in x, 0..64; default 1 */
  widthX?: number;
  /** factor of the derivatives in y, 0..64; default 1 */
  widthY?: number;
  /** blur in u, 0..1, added to the footprint as covariance; default 0 */
  blurU?: number;
  /** blur in v, 0..1, added to the footprint as covariance; default 0 */
  blurV?: number;
  /** largest ratio of the footprint's axes, 1..64; default 16 */
  maxAnisotropy?: number;
  /** weights of ANISOTROPIC in LEAST_ERROR and EXACT; default SHD_PROBE_WEIGHTS_EQUAL */
  probeWeights?: ProbeWeights | number;
  /** kernel of bicubic filters; default SHD_CUBIC_CATMULL_ROM */
  cubic?: Cubic | number;
  /** area of SHD_FILTER_SUMMED_AREA; default SHD_BOX_BOUNDING */
  box?: Box | number;
  /** tolerance of SHD_FILTER_EXACT, 2^-12..1; default 2^-6 */
  tolerance?: number;
  /**
   * Filter that SHD_FILTER_STOCHASTIC estimates: BILINEAR, BICUBIC (B-spline only), TRILINEAR, ANISOTROPIC or EWA;
   * default SHD_FILTER_TRILINEAR.
   */
  stochasticFilter?: Filter | number;
  /** seed of SHD_FILTER_STOCHASTIC; default 0 */
  seed?: number;
  /** default SHD_PRECISION_FULL */
  precision?: Precision | number;
  /**
   * Largest number of texels that a lookup of ANISOTROPIC or EWA reads; in 3D textures 2 or 4 times as many. 0 =
   * no
   * limit besides max_anisotropy, or 32 or more; default 0. It limits the ratio of the footprint's axes as
   * max_anisotropy does: longer footprints use coarser levels.
   */
  maxTexels?: number;
  /**
   * Length by which a footprint may exceed the probes of ANISOTROPIC in LEAST_ERROR and EXACT before another one
   * is
   * added, in widths of a probe, 0..1; default 1/8. A footprint r times as long as wide has ceil(r - probe_slack)
   * probes.
   */
  probeSlack?: number;
  /**
   * Part of the way between two mip levels in which TRILINEAR, NEAREST_MIP_LINEAR and ANISOTROPIC in LEAST_ERROR
   * and
   * EXACT blend them, 0..1; default 1. If f is the fraction of the level of detail, the share of the coarser level
   * is
   * clamp((f - 1/2) / level_blend + 1/2, 0, 1), and a level without share is not read. With 0, only the nearer
   * level
   * is read.
   */
  levelBlend?: number;
  /** random choice of SHD_FILTER_STOCHASTIC; default SHD_STOCHASTIC_TEXEL */
  stochastic?: Stochastic | number;
  /** across the slices of a 3D texture; no effect for others; default SHD_WRAP_REPEAT */
  wrapW?: Wrap | number;
  /** default SHD_MISSING_TILES_WAIT */
  missingTiles?: MissingTiles | number;
  /**
   * 1 = comparison lookups, as texture units have them for shadow maps (percentage-closer filtering; Reeves,
   * Salesin
   * and Cook 1987; Vulkan 1.3 specification, "Depth Compare Operation"); 0 = lookups return texels; default 0.
   * Each
   * texel that the filter reads becomes 1 if the comparison of the lookup's `reference` with it is true, else 0.
   * The
   * filter blends these numbers. The result is in r; g and b are 0, and a is 1.
   *
   * A texel is its channel of r after the texture's swizzle, which may be a constant of `fill`. Texels outside
   * with
   * SHD_WRAP_BORDER have the border colour. UNORM and SRGB formats clamp the reference to [0, 1]. Numbers are
   * compared as floats, after sRGB is decoded.
   *
   * Works with NEAREST, BILINEAR, NEAREST_MIP, NEAREST_MIP_LINEAR, BILINEAR_MIP, TRILINEAR and ANISOTROPIC on all
   * textures. Other filters, derivatives, and samplers of materials, lights and tessellations return
   * SHD_ERROR_UNSUPPORTED. SHD_PRECISION_FAST has no effect.
   */
  compares?: number;
  /** comparison of these lookups; default SHD_COMPARE_LESS */
  compare?: Compare | number;
}

/** Options of a shadow. */
export interface ShadowDesc {
  /** edge length of each face [texels], 16..8192; default 1024 */
  size?: number;
  /** default SHD_SHADOW_FILTER_HARD */
  filter?: ShadowFilter | number;
  /** n of PCF, VARIANCE and PCSS, 1..15; default 3 */
  taps?: number;
  /**
   * SUMMED_AREA_VARIANCE: edge length of the averaged square, world length at the point, 0..1e9; clamped to one
   * texel
   * to size / 4 texels. Default 0.
   */
  filterSize?: number;
  /**
   * PCSS: edge length of the square light, world length, 0..1e9; default 0. For directional lights: width of the
   * penumbra per distance of blocker and receiver, which is twice the tangent of half the angular size of the
   * light
   * (the sun: 0.0093). Search and penumbra are at most size / 4 texels wide.
   */
  lightSize?: number;
  /** points are moved towards the light by this depth, world length, 0..1e9; default 0 */
  bias?: number;
  /**
   * Factor of another bias: the edge length of a texel at the point times 1/4 + s. s is the sum of the |slopes| of
   * the surface across and along the map, at most 8. A slope is depth over length. The plane of the surface is
   * exact
   * at each texel, so this bias covers only the difference of the surface from its plane. Without a normal, 1/4 +
   * s
   * is replaced by 2, or by n + 1 for PCF. 0..1000; default 1.
   */
  biasSlope?: number;
  /**
   * before the lookup, points are moved along their normal by this world length, 0..1e9;
   * default 0. For coarse meshes with smooth normals: about the edge length of a texel
   */
  normalOffset?: number;
  /**
   * faces that cast no shadow: BACK faces are turned away from the light, FRONT faces
   * towards it. Replaces the culling of the draws. Default SHD_CULL_NONE, for open surfaces.
   * FRONT avoids acne on closed objects without a bias, but light leaks where they touch
   * other surfaces
   */
  casterCull?: Cull | number;
  /**
   * VARIANCE, SUMMED_AREA_VARIANCE: visibilities below this value become 0, 0..0.99;
   * default 0
   */
  bleed?: number;
  /** VARIANCE, SUMMED_AREA_VARIANCE: world length squared, 0..1e9; default 0 */
  minVariance?: number;
}

/** Light and draws of a map; borrowed for the call. Required: light. */
export interface ShadowRenderDesc {
  /** required; directional, spot or point */
  light: Light | null;
  /**
   * Draws that cast shadows, as in shd_render_desc; NULL if draw_count is 0. Depth comparison, depth biases and
   * culling of a draw are ignored; a draw with SHD_DRAW_KEEP_DEPTH casts no shadow. Vertex programs run with the
   * light's view. Alpha tests and programs that drop fragments apply too, except for draws with WEIGHTED or SORTED
   * blending. Opacity by itself has no effect.
   */
  draws?: Draw | Draw[];
  /** up to 2^20 */
  drawCount?: number;
  /**
   * Range of depths, near_plane < far_plane. Surfaces outside cast no shadow. Both 0 = fitted to the draws.
   * Directional lights: measured from the origin of the world along the direction of the light, any sign. Other
   * lights: measured from the light along the axis of the face, > 0; a fitted near_plane is at least 1/256 of
   * far_plane.
   */
  nearPlane?: number;
  farPlane?: number;
  /**
   * Directional lights: the part of the world that needs shadows. Both 0 = the bounds of the draws. Draws between
   * this part and the light still cast shadows. The size of texels is rounded up in steps of 1/8 to 1/16, and
   * texels
   * lie at multiples of their size, so shadows do not shimmer while bounds of constant size move.
   */
  boundsMin?: Numbers;
  boundsMax?: Numbers;
}

/** Points on surfaces; borrowed for the call. */
export interface ShadowLookups {
  /** number of points; 0 is allowed */
  count?: number;
  /** x, y, z, world space; required unless count is 0 */
  position?: Columns;
  /** unit, world space; all three columns or none */
  normal?: Columns;
}

/** A shape and its subdivision. */
export interface ShapeDesc {
  /** default sphere */
  shape?: Shape | number;
  /** spheres and tori: 1e-30..1e30; default 1 */
  radius?: number;
  /** tori: 1e-30..1e30, below `radius`; default 0.25 */
  tubeRadius?: number;
  /** boxes and planes: length along x, y, z, 1e-30..1e30; default 2 */
  size?: Numbers;
  /**
   * Parts; 0 = the number in brackets. Sphere: around, 3..4096 [32], and from pole to pole, 2..4096 [16]. Box:
   * along
   * x, y and z, 1..4096 [1]. Plane: [0] along x and [2] along z, as of `size`, 1..4096 [1]. Torus: around the
   * axis,
   * 3..4096 [48], and around the tube, 3..4096 [24]. Teapot: along each side of a patch, 2..256 [8]. Unused
   * numbers
   * are ignored, as size[1] and segments[1] of a plane.
   */
  segments?: Numbers;
}

/** Output columns of a shape. They do not overlap; each may be absent. */
export interface ShapeColumns {
  /** elements in each column of vertices, at least the number from shd_shape_count() */
  vertexCount?: number;
  /**
   * elements in `indices`, at least the number from shd_shape_count() unless `indices`
   * is absent
   */
  indexCount?: number;
  /** x, y, z, object space */
  position?: OutColumns;
  /** x, y, z, unit, outwards */
  normal?: OutColumns;
  /** u, v */
  uv?: OutColumns;
  /** three for each triangle */
  indices?: OutColumn;
}

/**
 * A source for a coefficient. Required: target, and the fields that the source uses.
 *
 * Slots that scale light (diffuse, tint, ambient, specular, opacity, emission, metallic, occlusion, matcap) are
 * looked
 * up for every fragment at every frequency. Slots that shape a lobe (exponent, roughness, normal, normal_mixed,
 * height
 * and those of the clear coat) are looked up where lobes are evaluated: at flat and Gouraud frequency at the
 * centroid
 * or vertex, on level 0.
 *
 * Values are not clamped, even if negative. NaN and infinity propagate to the colours of their fragments, which
 * shd_render_stats.nonfinite_fragments counts. There are two exceptions. Exponents are clamped to 0..1e6 (NaN
 * becomes
 * 0) and roughness to 0..1 (NaN becomes 1). The surface keeps its normal where a mapped normal is 0 or not finite,
 * or a
 * slope of heights is not finite.
 */
export interface Slot {
  /** the coefficient; each slot of a material has a different one */
  target: SlotTarget | number;
  /** default SHD_SLOT_SOURCE_CONSTANT */
  source?: SlotSource | number;
  /** SHD_SLOT_SOURCE_VERTEX: first column, 0..7; default 0 */
  attribute?: number;
  /**
   * SHD_SLOT_SOURCE_TEXTURE: a 2D texture, or a 3D texture that is looked up at places;
   * else NULL; retained by the material
   */
  texture?: Texture | null;
  /** SHD_SLOT_SOURCE_TEXTURE: NULL = default sampler; retained by the material */
  sampler?: Sampler | null;
  /** function of SHD_SLOT_SOURCE_PROCEDURE */
  procedure?: (fragments: Fragments, out: (Float32Array | null)[]) => void;
  /** channel of the texture or the solid texture for scalars, 0..3; default 0 */
  channel?: number;
  /** coordinates for the texture: 0 = uv of the mesh, 1 = uv1; default 0 */
  uvSet?: number;
  /**
   * (u', v') = (t[0] u + t[1] v + t[2], t[3] u + t[4] v + t[5]), finite; default identity. glTF's
   * KHR_texture_transform is T R S, with the rotation r and v downwards
   * t = {sx cos r, sy sin r, ox, -sx sin r, sy cos r, oy}.
   */
  uvTransform?: Numbers;
  /**
   * Solid texture of SHD_SLOT_SOURCE_SOLID, else NULL; copied by the material. Colours take r, g, b and, for the
   * diffuse slot and normals, a; scalars take `channel`. At Phong frequency, and for slots that scale light, the
   * width of a pixel is max(|dp/dx|, |dp/dy|), with the exact derivatives of the place p by pixel steps; where
   * lobes
   * are evaluated at vertices or centroids it is 0. `place_width` multiplies it.
   */
  solid?: SolidDesc;
  /**
   * Place = place_transform * position, column-major, affine: the last row is 0, 0, 0, 1; default identity. A
   * solid
   * texture is evaluated at the place. A 3D texture is looked up at (u, v, w) = place, with the derivatives of the
   * place by pixel steps times `place_width`: it fills the cube from 0 to 1, and its sampler wraps it.
   */
  placeTransform?: Numbers;
  /** space of the position; default SHD_PLACE_SPACE_OBJECT */
  placeSpace?: PlaceSpace | number;
  /**
   * factor of the width of a pixel, 0..1000; 0 = no band limit, level 0 of
   * 3D textures; default 1
   */
  placeWidth?: number;
}

/** A solid texture: a pattern, its octaves and its colours. It has no pointers, so a copy is independent. */
export interface SolidDesc {
  /** default SHD_SOLID_STRIPES */
  kind?: Solid | number;
  /** another seed gives another pattern of the same kind; no effect on STRIPES, CHECKER */
  seed?: number;
  /** side of a cell or width of a stripe [units of the positions], 1e-30..1e30; default 1 */
  size?: number;
  /**
   * Number of octaves of PERLIN, VALUE, SIMPLEX, WORLEY, and of the noise in MARBLE and WOOD, 1..32; default 1.
   * The
   * sum is N = sum of gain^i n(lacunarity^i p) / sum of gain^i, for i from 0 on. Each octave has a pattern of its
   * own, except with SHD_SOLID_GRADIENTS_TABLE, as in the classic form.
   */
  octaves?: number;
  /** ratio of the frequencies of successive octaves, 1..16; default 2 */
  lacunarity?: number;
  /** ratio of the amplitudes of successive octaves, 0..1; default 1/2 */
  gain?: number;
  /** PERLIN, VALUE and SIMPLEX: default SHD_SOLID_SUM_FBM */
  sum?: SolidSum | number;
  /** PERLIN: default SHD_SOLID_GRADIENTS_HASHED */
  gradients?: SolidGradients | number;
  /** PERLIN, VALUE, MARBLE and WOOD: default SHD_SOLID_FADE_QUINTIC */
  fade?: SolidFade | number;
  /** WORLEY: default SHD_SOLID_DISTANCE_F1 */
  distance?: SolidDistance | number;
  /** MARBLE and WOOD: factor of the noise [cells], 0..1000; default 1 */
  distortion?: number;
  /** Values of the first and the last colour, -1e6..1e6; equal = the limits of the kind's range; default 0, 0. */
  range?: Numbers;
  /** 2..SHD_MAX_SOLID_COLORS; default 2 */
  colorCount?: number;
  /**
   * r, g, b, a at equal distances over `range`, linear, -1e6..1e6; values in between are interpolated, values
   * beyond
   * `range` have the nearest colour. Default black and white, both opaque.
   */
  colors?: Numbers;
}

/** Points at which a solid texture is evaluated, as columns of `count` elements. Required: position. */
export interface SolidPoints {
  /** number of points; 0 is allowed */
  count?: number;
  /** x, y, z; required */
  position: Columns;
  /** diameter of a pixel at the point [units of the positions]; absent = 0: no band limit */
  width?: Column;
}

/** Columns for the values of a solid texture; NULL = not wanted. At least one is required. */
export interface SolidValues {
  /** the pattern, in the range of its kind */
  value?: OutColumn;
  /**
   * d value / dx, dy and dz, with the width held constant, limited to -1e30..1e30. Where the pattern jumps or has
   * no
   * derivative the result is that of one side, or 0.
   */
  gradient?: OutColumns;
  /** r, g, b, a of shd_solid_desc.colors at the value, linear */
  color?: OutColumns;
  /** written: points whose position or width is not finite */
  nonfiniteCount?: number;
}

/** Options of tessellation and displacement. */
export interface TessellationDesc {
  /** default SHD_TESSELLATION_MODE_UNIFORM */
  mode?: TessellationMode | number;
  /** UNIFORM: parts of an edge, 1..SHD_MAX_SEGMENTS; default 1 */
  segments?: number;
  /** ADAPTIVE: largest number of parts of an edge, 1..SHD_MAX_SEGMENTS; default 64 */
  maxSegments?: number;
  /** ADAPTIVE: longest part [pixels], without `view` [world units]; > 0; default 8 */
  edgeLength?: number;
  /** ADAPTIVE with `view`: of the picture [pixels], 1..65536; default 1024 */
  width?: number;
  /** ADAPTIVE with `view`: of the picture [pixels], 1..65536; default 1024 */
  height?: number;
  /** the call is refused if the result would have more, 1..2^28; default 2^24 */
  maxTriangles?: number;
  /**
   * ADAPTIVE: view for lengths in pixels. An edge counts as turned about its middle until it is perpendicular to
   * the
   * line of sight; its length is then projected to the picture. An edge that passes the eye has max_segments
   * parts,
   * an edge behind the eye has 1. Borrowed for the call; NULL = lengths in world units.
   */
  view?: View;
  /** ADAPTIVE: [16], column-major; borrowed for the call; NULL = identity */
  objectToWorld?: Numbers;
  /** channel r is the height; borrowed for the call; NULL = no displacement */
  displacement?: Texture | null;
  /** sampler of `displacement`; borrowed for the call; NULL = the default sampler */
  sampler?: Sampler | null;
  /** level of detail of the lookups, log2 of base texels, -32..32; default 0 */
  lod?: number;
  /** factor of heights [object units], -1e12..1e12; default 0 = no displacement */
  amplitude?: number;
  /** height that is not displaced, -1e12..1e12; default 0 */
  offset?: number;
  /** used with displacement; default SHD_DISPLACED_NORMALS_TILTED */
  normals?: DisplacedNormals | number;
}

/** Texels and tables of a texture. Required: format, width, height, texels. */
export interface TextureDesc {
  /**
   * any; no default. RGB8 to RGB32F are stored as RGBA. Blocks stay compressed, and lookups
   * decode them (docs/compressed.md): the caller gives its mip levels; other tables are
   * kept decoded
   */
  format: Format | number;
  /** texels, 1..65536; width * height * layers at most 2^28; see `tiles` for larger ones */
  width?: number;
  /** texels, 1..65536 */
  height?: number;
  /**
   * [layers][height][width], row 0 on top, aligned to a channel; copied without
   * SHD_TEXTURE_BORROW. Blocks: [layers][ceil(height / 4)][ceil(width / 4)], at any
   * address
   */
  texels: Pixels;
  /** bytes between rows of texels or blocks, at least the bytes of a row; 0 = packed */
  rowStride?: number;
  /** bytes between layers, at least the rows of a layer times the row stride; 0 = packed */
  layerStride?: number;
  /** images of the array, 1..2048; default 1 */
  layers?: number;
  /** default none */
  flags?: TextureFlag | (string & {}) | number;
  /** sources of r, g, b, a of lookups; default SHD_CHANNEL_DEFAULT */
  swizzle?: (Channel | number)[];
  /**
   * values of channels that the format does not have, in lookups inside and outside the
   * image; finite; default 0, 0, 0, 1
   */
  fill?: Numbers;
  /** default none */
  tables?: Table | (string & {}) | number;
  /**
   * number of `levels` per layer; the mipmap ends with the last one, even if it is
   * larger than 1 x 1; default 0 = the library builds the levels
   */
  levelCount?: number;
  /**
   * The caller's mip levels for SHD_TABLE_MIPMAP: [layers][level_count], all of one struct_size, of this format;
   * copied. Element l is level l + 1: max(1, width >> (l + 1)) by max(1, height >> (l + 1)). A ripmap of the same
   * texture uses them for the levels that it shares with the mipmap. A 3D texture has the max(1, depth >> 1)
   * slices
   * of level 1 first, then the slices of level 2, and so on.
   */
  levels?: Image | Image[];
  /**
   * Slices of a 3D texture, 1..65536; default 0 = a 2D texture. width * height * depth is at most 2^28, `layers`
   * is
   * 1, and SHD_TABLE_MIPMAP is the only table. Texels are [depth][height][width], and `layer_stride` is the
   * distance
   * of slices. Lookups read (u, v, w); w = 0 is the outer face of slice 0. A level halves all three sizes.
   */
  depth?: number;
  /**
   * Default SHD_PROJECTION_NONE. With any other one, lookups read (u, v, w) as a direction of any length. `width`
   * and
   * `height` are equal unless it is LAT_LONG; `layers` of CUBE are the 6 faces +X, -X, +Y, -Y, +Z, -Z; `depth` is
   * 0;
   * `tables` has SHD_TABLE_MIPMAP at most. Mip levels are averages of texels of one image, unweighted.
   */
  projection?: Projection | number;
  /**
   * Default none. With a cache, the texture keeps no texels: `texels` is NULL, strides are 0, nothing is borrowed,
   * and the format has not three channels. `width` and `height` are 1..2^20, and the tiles of all levels and
   * layers
   * at most 2^30. SHD_TABLE_RIPMAP and SHD_TABLE_SUMMED_AREA are built in memory, of all levels, when the texture
   * is
   * made; dropped tiles do not change them. The callback writes the mip levels too. `level_count` is their
   * number, 0 = down to 1 x 1; `levels` is NULL. Coordinates are binary32 floats: beyond 65536 texels, filters
   * have
   * fewer than 8 bits for the fraction of a texel. SHD_PRECISION_FAST has no effect. SHD_FILTER_EXACT,
   * shd_texture_explain() and shd_texture_bounds() wait for the tiles that they read, also with
   * SHD_MISSING_TILES_COARSER.
   */
  tiles?: TileSource;
}

/** Size, format and memory of a texture. */
export interface TextureInfo {
  /** format of every level; RGBA for RGB8 to RGB32F, with _SRGB */
  format: Format | number;
  /** texels of level 0 */
  width: number;
  /** texels of level 0 */
  height: number;
  /** images of the array */
  layers: number;
  /**
   * 1; with SHD_TABLE_MIPMAP the number of levels down to 1 x 1, or the number of given
   * levels + 1
   */
  levelCount: number;
  /** tables of the texture */
  tables: Table | (string & {}) | number;
  /** as in its desc */
  flags: TextureFlag | (string & {}) | number;
  /**
   * bytes of all tables and of the data that shd_texture_update() keeps, without a borrowed
   * base level
   */
  byteSize: number;
  /** slices of level 0; 0 = not a 3D texture */
  depth: number;
  /** as in its desc */
  projection: Projection | number;
}

/** Size of a tile cache. */
export interface TileCacheDesc {
  /** bytes of a tile, a power of two from 1024 to 2^20; default 65536 */
  tileBytes?: number;
  /**
   * All memory of the cache: tiles, their table, and places for copies of texels; from 4 tiles plus 64 KiB to 2^31
   * bytes; default 2^28. It is allocated once. A small budget makes lookups slower, because tiles are loaded
   * again.
   * Half of the tiles can be pinned.
   */
  budgetBytes?: number;
}

/** Source of the tiles of a texture. Frozen. */
export interface TileSource {
  /** retained; NULL = the texture has its texels in memory */
  cache?: TileCache | null;
  /** required with `cache` */
  load?: (tiles: Tile[]) => void;
  /**
   * called once, after the last `load`, when the texture is destroyed; may be
   * NULL. It is not called if shd_texture_create() fails
   */
  release?: () => void;
}

/** Counters of a tile cache since its creation. */
export interface TileCacheStats {
  /** bytes of a tile */
  tileBytes: number;
  /** as in its desc */
  budgetBytes: number;
  /** memory of the cache, at most the budget; it does not change */
  allocatedBytes: number;
  /** tiles that fit */
  tileCount: number;
  /** tiles in memory now */
  residentTiles: number;
  /** tiles that are pinned now */
  pinnedTiles: number;
  /** tiles that shd_tile_cache_load_requested() would load now */
  requestedTiles: number;
  /** calls of load callbacks */
  loads: number;
  /** tiles that callbacks wrote */
  loadedTiles: number;
  /** tiles of calls that failed */
  failedTiles: number;
  /** tiles that gave their place to others */
  evictedTiles: number;
  /** waits of lookups for tiles that other threads loaded */
  waits: number;
}

/** A rectangle of a level. Required: width, height. */
export interface TileRegion {
  /** layer, face, or slice of the level of a 3D texture; default 0 */
  layer?: number;
  /** 0..level_count - 1; default 0 */
  level?: number;
  /** first column, in texels of the level; default 0 */
  x?: number;
  /** first row; default 0 */
  y?: number;
  /** 1 or more; x + width is at most the width of the level */
  width?: number;
  /** 1 or more; y + height is at most the height of the level */
  height?: number;
}

/**
 * Transforms from world to clip space. Frozen, because it is a member of shd_render_desc. Later options of a
 * picture
 * are appended to shd_render_desc.
 */
export interface View {
  /** rigid, finite */
  worldToView: Numbers;
  /** projection, finite */
  viewToClip: Numbers;
  /** world space; viewing directions (wo) point to it */
  eye: Numbers;
}

/** A perspective camera. */
export interface Camera {
  /** world space; default (0, 0, 3) */
  eye?: Numbers;
  /** world space, different from the eye; default 0 */
  target?: Numbers;
  /** world space, any length, not along the line of sight; default (0, 1, 0) */
  up?: Numbers;
  /** vertical field of view [rad], (0, pi); default 0.8 */
  fovY?: number;
  /** width / height, > 0; 0 = aspect of the picture, or 1 if there is no picture; default 0 */
  aspect?: number;
  /** distance, > 0; default 0.1 */
  nearPlane?: number;
  /** distance, > near_plane; default 100 */
  farPlane?: number;
}

/** Density, transfer function, steps and shading of a volume. Required: point_count, texture, density, extinction. */
export interface VolumeDesc {
  /** points of the transfer function, 1..256 */
  pointCount?: number;
  /** 3D texture; retained */
  texture: Texture | null;
  /**
   * [point_count] densities of the points, -1e38..1e38, never decreasing. Values are
   * interpolated between points; two points of one density are a jump
   */
  density: Column;
  /** [point_count] sigma [1 / world unit], 0..1e12 */
  extinction: Column;
  /**
   * [point_count] scene-linear r, g, b, 0..1e6: radiance, or the diffuse colour of
   * `material`; absent = 1
   */
  color?: Columns;
  /**
   * Shades the points by the lights of the frame, with shadows and cookies, but not by its environment: an opaque
   * material without slots and debug view, of a model that reflects light; others are SHD_ERROR_UNSUPPORTED. Its
   * diffuse colour is multiplied by `color`. The normal is the direction in which density falls fastest, by
   * central
   * differences over two texels; it faces the viewer where the gradient is 0, and always with
   * SHD_MATERIAL_DOUBLE_SIDED. NULL = `color` is radiance; retained.
   */
  material?: Material | null;
  /** corner of the texture's (0, 0, 0) in object space, finite; default 0 */
  boxMin?: Numbers;
  /** corner of the texture's (1, 1, 1); above box_min on each axis; default 1 */
  boxMax?: Numbers;
  /** length of a step [world units], above 0, at most 1e12; default 1/256 */
  step?: number;
  /**
   * the point of a step lies at a fraction 1/2 + jitter (h - 1/2) of the step, with h in [0, 1) hashed
   * from the pixel of the picture and `seed`; 0..1; default 0
   */
  jitter?: number;
  /** seed of the jitter; default 0 */
  seed?: number;
  /** reserved; 0 */
  flags?: number;
}

/** One volume in the frame. Required: volume. */
export interface VolumeDraw {
  /** borrowed for the call */
  volume: Volume | null;
  /** affine, finite, invertible; default identity */
  objectToWorld?: Numbers;
}

/** The functions of C. Pointers are addresses in the memory of WebAssembly. */
export interface Raw {
  malloc(size: number): number;
  free(address: number): void;
  /**
   * Shade the surfaces of draws into a framebuffer at their texture coordinates.
   *
   * A bake reads these fields of the frame: the framebuffer (with one sample per pixel), clear_color, camera or
   * view,
   * draws, lights, shadows, environment with its intensity and rotation, progress and stats. The view gives the
   * eye.
   * Vertex programs run; their clip positions have no effect. The other fields must have their defaults, except
   * pass_triangles, which has no effect: all triangles are processed together. Depth becomes 1, and overdraw stays
   * 0.
   *
   * Every draw has a material. Its colour replaces that of the texel: blends have no effect, and a is the opacity
   * of the
   * material. Fragments that a program or the alpha test drops leave their texel empty. SHD_MATERIAL_DOUBLE_SIDED
   * and
   * _ALPHA_TO_COVERAGE, and cull, fill, compare, depth biases and flags of a draw have no effect. The bits of the
   * result
   * do not depend on workers or SIMD targets.
   * @param context its executor, allocator and SIMD target do the work; the objects may come from any context
   * @param frame borrowed for the call
   * @param desc borrowed for the call; NULL = all defaults
   */
  shd_bake(context: number, frame: number, desc: number): number;
  /**
   * Version of the library that is running: major << 16 | minor << 8 | patch.
   *
   * It may differ from SHD_VERSION_*, which is the version of the headers.
   */
  shd_version(): number;
  /**
   * Get the precision that the rules of a graphics API require at least.
   * @param rules one of shd_rules
   * @param outDesc its struct_size is read; the rest is written, all zero on failure
   */
  shd_bounds_preset(rules: number, outDesc: number): number;
  /**
   * Compute the legal values of `lookups->count` lookups.
   * @param texture concurrent reads
   * @param sampler may come from another context
   * @param lookups columns, borrowed for the call
   * @param desc borrowed for the call; NULL = all defaults
   * @param lower smallest legal values; columns of `channel` only, which must not overlap any input or each other
   * (checked)
   * @param upper largest legal values, as `lower`
   */
  shd_texture_bounds(texture: number, sampler: number, lookups: number, desc: number, lower: number, upper: number): number;
  /**
   * Make a context.
   * @param desc options, borrowed for the call; NULL = all defaults
   * @param outContext owned; NULL on failure
   */
  shd_context_create(desc: number, outContext: number): number;
  /** Add a reference; NULL is ignored. Any thread. */
  shd_context_retain(context: number): void;
  /** Drop a reference; NULL is ignored. Objects hold references too; the last release frees everything. Any thread. */
  shd_context_release(context: number): void;
  /**
   * Return the working memory that the context keeps between calls to the allocator. Calls that run at the same
   * time
   * keep theirs. NULL is ignored. Any thread.
   */
  shd_context_trim(context: number): void;
  /** Name of the SIMD target of the context's kernels, such as "AVX2"; "" for a bad handle. Static. */
  shd_context_simd_target(context: number): number;
  /** Number of workers of the executor, at least 1; 0 for a bad handle. */
  shd_context_worker_count(context: number): number;
  /**
   * Write the defaults of a sized struct into the caller's memory and set its struct_size.
   * @param kind the struct that `ptr` points at
   * @param ptr the caller's struct, aligned for it
   * @param size size in bytes of the caller's struct. If it is smaller than the library's struct, only the fields
   * inside
   * it are written; it must contain every required field. If it is larger, the remaining bytes become
   * zero
   * @returns SHD_ERROR_INVALID_ARGUMENT for an unknown kind, a NULL pointer, or a size that lacks required fields
   * or is
   * not a multiple of the alignment of the struct
   */
  shd_desc_init(kind: number, ptr: number, size: number): number;
  /**
   * Find all edges of the requested kinds in a mesh. Each edge is listed once, in the order of the edges' first
   * triangles.
   *
   * The result has the same bits on every machine.
   * @param mesh made with SHD_MESH_ADJACENCY
   * @param desc borrowed for the call
   * @param capacity elements of the columns; 0 to count edges
   * @param out gets the first `capacity` edges; may be NULL if capacity is 0
   * @param outCount number of edges found, which may exceed `capacity`; 0 on failure
   */
  shd_mesh_find_edges(mesh: number, desc: number, capacity: number, out: number, outCount: number): number;
  /**
   * Make an environment on the executor of the context.
   *
   * Kept: 11 bytes for each of 1 to 4 texels a pixel, of at least 64^2 (12 bytes each) and at most 2048^2 texels,
   * and
   * 4.2 MB or less for each kind of lobe. Temporary: 16 bytes a pixel, 224 bytes a row, and twice the bytes kept.
   * Fixed:
   * lobes and CONVOLVED take up to 12 MB of temporary memory more. Maps hold three channels of 16 bits with a
   * common
   * exponent: errors of up to 2^-16 of the largest channel.
   * @param context retained
   * @param desc borrowed for the call
   * @param outEnvironment owned; NULL on failure
   */
  shd_environment_create(context: number, desc: number, outEnvironment: number): number;
  /** Add a reference; NULL is ignored. Any thread. */
  shd_environment_retain(environment: number): void;
  /** Drop a reference; NULL is ignored. Any thread. */
  shd_environment_release(environment: number): void;
  /**
   * Get the properties of an environment.
   * @param outInfo its struct_size is read; the rest is written, all zero on failure
   */
  shd_environment_get_info(environment: number, outInfo: number): number;
  /**
   * Look up the irradiance of surfaces whose normals are the directions, on the executor of the environment's
   * context.
   * @param lookups columns, borrowed for the call, without roughness and exponent
   * @param out columns, borrowed for the call; must not overlap any input or each other (checked)
   */
  shd_environment_irradiance(environment: number, lookups: number, out: number): number;
  /**
   * Look up the radiance, or its mean over lobes, on the executor of the environment's context.
   * @param lookups columns, borrowed for the call, with at most one of roughness and exponent
   * @param out columns, borrowed for the call; must not overlap any input or each other (checked)
   */
  shd_environment_radiance(environment: number, lookups: number, out: number): number;
  /**
   * Explain lookup `index` of a batch. Call once without memory for the counts, then again with it.
   * @param texture concurrent reads
   * @param sampler any filter except SUMMED_AREA and EXACT (SHD_ERROR_UNSUPPORTED)
   * @param lookups as for shd_texture_sample, borrowed for the call
   * @param index 0..lookups->count - 1
   * @param explanation its tables are borrowed for the call
   */
  shd_texture_explain(texture: number, sampler: number, lookups: number, index: number, explanation: number): number;
  /**
   * Store `message` as the calling thread's shd_last_error() and return `result`.
   *
   * The message is copied and cut at 1023 bytes. It is not a format string.
   */
  shd_report_error(result: number, message: number): number;
  /**
   * Allocate from the context's allocator.
   * @returns NULL if the allocator fails, size is 0, alignment is not a power of two (0 counts as 8) or the handle
   * is bad
   */
  shd_context_allocate(context: number, size: number, alignment: number): number;
  /** Free memory with the size and alignment of its allocation; NULL is ignored. */
  shd_context_free(context: number, memory: number, size: number, alignment: number): void;
  /** Write a line to the context's log. */
  shd_context_log(context: number, level: number, message: number): void;
  /** Run tasks on the context's executor, with IEEE default floating-point control. */
  shd_context_parallel_for(context: number, count: number, task: number, taskData: number): number;
  /**
   * Make a handle in the context's slabs, with one owned reference.
   * @param type four characters that name the type, such as 'COLR', packed big-endian; above 0xffff
   * @param body the object behind the handle
   * @param destroy called with `body` by the thread that releases the last reference; must not throw
   * @param outObject owned; NULL on failure, and then `destroy` is not called
   */
  shd_object_create(context: number, type: number, body: number, destroy: number, outObject: number): number;
  /** Body of a live handle of that type; NULL, with the error text set, for any other pointer value. */
  shd_object_body(object: number, type: number): number;
  /** Context of a handle; borrowed; NULL for a bad handle. */
  shd_object_context(object: number): number;
  /** Context of a framebuffer; borrowed; NULL for a bad handle. */
  shd_framebuffer_context(framebuffer: number): number;
  /** Add a reference; NULL is ignored. */
  shd_object_retain(object: number, type: number): void;
  /** Drop a reference; NULL is ignored. */
  shd_object_release(object: number, type: number): void;
  /**
   * Compute derivatives from ray differentials.
   *
   * The change of the hit point is d(o + t d) + dt d, with dt chosen so that it lies in the surface. It is then
   * expressed
   * in dp/du and dp/dv (Igehy, "Tracing Ray Differentials", 1999, sections 3.1 and 3.2).
   * @param rays columns, borrowed for the call
   * @param out columns, borrowed for the call; must not overlap any input or each other (checked)
   */
  shd_derivatives_from_differentials(rays: number, out: number): number;
  /**
   * Compute derivatives from ray cones.
   *
   * The derivatives are the axes of the ellipse in which the cone meets the surface: along the projected direction
   * (x)
   * and across it (y). Each is as long as the ellipse in its direction (Akenine-Moller et al., "Improved Shader
   * and
   * Texture Level of Detail Using Ray Cones", 2021, section 5). Angles between ray and surface below 2^-10 rad
   * count as
   * 2^-10 rad.
   * @param cones columns, borrowed for the call
   * @param out columns, borrowed for the call; must not overlap any input or each other (checked)
   */
  shd_derivatives_from_cones(cones: number, out: number): number;
  /**
   * Make a framebuffer: colour 0, depth 1, AOVs 0, triangle and draw 0xffffffff.
   * @param context retained
   * @param desc borrowed for the call
   * @param outFramebuffer owned; NULL on failure
   */
  shd_framebuffer_create(context: number, desc: number, outFramebuffer: number): number;
  /** Add a reference; NULL is ignored. Any thread. */
  shd_framebuffer_retain(framebuffer: number): void;
  /** Drop a reference; NULL is ignored. Any thread. */
  shd_framebuffer_release(framebuffer: number): void;
  /**
   * Get size and planes of a framebuffer.
   * @param outInfo its struct_size is read; the rest is written, all zero on failure
   */
  shd_framebuffer_get_info(framebuffer: number, outInfo: number): number;
  /**
   * Get the position of a sample in its pixel. Positions and order are the standard sample locations of the Vulkan
   * 1.3
   * specification ("Multisampling"), which are those of Direct3D 11's standard pattern. They are multiples of 1/16
   * pixel.
   * @param samples samples of a pixel: 1, 2, 4, 8 or 16
   * @param index number of the sample, 0..samples - 1
   * @param outX pixels from the left edge of the pixel; 0 on failure
   * @param outY pixels from the top edge of the pixel; 0 on failure
   */
  shd_sample_position(samples: number, index: number, outX: number, outY: number): number;
  /**
   * Get a plane without copying.
   * @param outView its struct_size is read; the rest is written. Borrowed until release of the framebuffer; the
   * next
   * shd_render changes its contents. All zero on failure; a plane that the framebuffer does not have is
   * SHD_ERROR_NOT_FOUND
   */
  shd_framebuffer_view_plane(framebuffer: number, plane: number, outView: number): number;
  /**
   * Get interleaved colour without copying.
   * @param outView its struct_size is read; the rest is written: an image of the framebuffer's size and
   * color_format.
   * Its pixels must not be written. They are borrowed until release of the framebuffer; the next
   * shd_render changes them. All zero on failure; SHD_ERROR_NOT_FOUND for color_format
   * SHD_FORMAT_RGBA32F, whose colour is planes
   */
  shd_framebuffer_view_color(framebuffer: number, outView: number): number;
  /**
   * Copy a float plane into a column. R, G, B and A are decoded to linear floats if colour is interleaved.
   * @param out column of width * height elements, row by row from the top. A stride writes one channel of an
   * interleaved
   * image
   */
  shd_framebuffer_read_plane(framebuffer: number, plane: number, out: number): number;
  /**
   * Copy a plane of uint32_t into a column.
   * @param out column of width * height elements, row by row from the top
   */
  shd_framebuffer_read_u32_plane(framebuffer: number, plane: number, out: number): number;
  /**
   * Copy colour as interleaved RGBA. Pixels of the framebuffer's own color_format are copied bit by bit.
   *
   * Colour stays linear, except that SHD_FORMAT_RGBA8_SRGB is encoded. Integer formats clamp to 0..1 (NaN to 0)
   * and round
   * to nearest; sRGB codes are the correctly rounded ones of IEC 61966-2-1.
   * @param out RGBA8, RGBA8_SRGB, RGBA16, RGBA16F or RGBA32F image of the framebuffer's size
   */
  shd_framebuffer_read_color(framebuffer: number, out: number): number;
  /** Bytes of one pixel; 0 for an unknown format, and for formats of blocks. Any thread. */
  shd_format_size(format: number): number;
  /** Bytes of one block of 4 x 4 texels: 8 or 16; 0 for formats of pixels, and unknown ones. Any thread. */
  shd_format_block_size(format: number): number;
  /**
   * Make a light.
   * @param context retained
   * @param desc borrowed for the call; NULL = all defaults
   * @param outLight owned; NULL on failure
   */
  shd_light_create(context: number, desc: number, outLight: number): number;
  /** Add a reference; NULL is ignored. Any thread. */
  shd_light_retain(light: number): void;
  /** Drop a reference; NULL is ignored. Any thread. */
  shd_light_release(light: number): void;
  /**
   * Filter `lookups->count` points of a texture.
   * @param texture concurrent reads
   * @param sampler may come from another context
   * @param lookups columns, borrowed for the call
   * @param out columns, borrowed for the call; must not overlap any input or each other (checked)
   */
  shd_texture_sample(texture: number, sampler: number, lookups: number, out: number): number;
  /**
   * Compute the levels of detail of `lookups->count` points, as trilinear filtering uses them.
   * @param texture concurrent reads
   * @param sampler its bias, clamps, width, blur and profile are used; its filter has no effect
   * @param lookups columns, borrowed for the call
   * @param out columns, borrowed for the call; must not overlap any input or each other (checked)
   */
  shd_texture_query_levels(texture: number, sampler: number, lookups: number, out: number): number;
  /**
   * Make a material.
   * @param context retained
   * @param desc borrowed for the call; NULL = all defaults
   * @param outMaterial owned; NULL on failure
   */
  shd_material_create(context: number, desc: number, outMaterial: number): number;
  /** Add a reference; NULL is ignored. Any thread. */
  shd_material_retain(material: number): void;
  /** Drop a reference; NULL is ignored. Any thread. */
  shd_material_release(material: number): void;
  /**
   * Copy and check vertices and indices; compute normals if there are none.
   *
   * The call refuses these inputs, and the error text names the element: an index >= vertex_count, an index count
   * that is
   * not a multiple of 3 (SHD_TOPOLOGY_TRIANGLES), a position that is not finite (unless SHD_MESH_KEEP_NONFINITE).
   * Normals, uv, tangents and attributes that are not finite count as 0.
   *
   * @anchor tangents
   * Tangents: the tangent t points towards increasing u, in the plane of the normal n. The bitangent is handedness
   * *
   * cross(n, t) and points towards decreasing v, up in the picture, as in glTF 2.0.
   *
   * SHD_MESH_TANGENTS computes them to the MikkTSpace convention (Mikkelsen, "Simulation of Wrinkled Surfaces
   * Revisited",
   * 2008) for (u, 1 - v). Vertices of equal position, normal and uv count as one. The directions of the triangles
   * around
   * it are weighted by angle, and triangles with mirrored uv stay apart. A vertex is split where mirrored and
   * other
   * triangles meet, and where it belongs to several fans that share no edge. The first part keeps the caller's
   * vertex
   * number. The copies have the other tangents; they follow the caller's vertices in the order of their originals.
   * One
   * rule differs from Mikkelsen's generator: at its threshold of 180 degrees it leaves a triangle out of a
   * corner's sum
   * if their directions are exactly opposite after rounding. Here each triangle of a fan counts for all its
   * corners, so
   * that folded or stretched uv do not split vertices.
   *
   * Triangles without area in uv, or with two corners at the same position, use the tangent of their neighbours at
   * each
   * vertex. A vertex without any tangent gets a unit vector perpendicular to n: the x axis projected into the
   * plane of n,
   * or the y axis where |n.x| > 0.9. Such a vertex has degenerate or missing uv, has no triangles, or has
   * directions that
   * cancel. Its handedness is 1, or -1 where all its triangles are mirrored.
   * @param context retained
   * @param desc borrowed for the call
   * @param outMesh owned; NULL on failure
   */
  shd_mesh_create(context: number, desc: number, outMesh: number): number;
  /**
   * Make the mesh of a shape: shd_shape_fill() and shd_mesh_create() in one call.
   * @param context retained
   * @param desc borrowed for the call; NULL = all defaults, a sphere of radius 1
   * @param flags as shd_mesh_desc.flags
   * @param outMesh owned; NULL on failure
   */
  shd_mesh_create_shape(context: number, desc: number, flags: number, outMesh: number): number;
  /** Add a reference; NULL is ignored. Any thread. */
  shd_mesh_retain(mesh: number): void;
  /** Drop a reference; NULL is ignored. Any thread. */
  shd_mesh_release(mesh: number): void;
  /**
   * Get counts and bounds of a mesh.
   * @param outInfo its struct_size is read; the rest is written, all zero on failure
   */
  shd_mesh_get_info(mesh: number, outInfo: number): number;
  /**
   * Copy the positions out, object space.
   * @param out [3] columns x, y, z of shd_mesh_info.vertex_count elements; NULL data = not wanted
   */
  shd_mesh_read_positions(mesh: number, out: number): number;
  /**
   * Copy the unit vertex normals out, given or computed.
   * @param out [3] columns x, y, z of shd_mesh_info.vertex_count elements; NULL data = not wanted
   */
  shd_mesh_read_normals(mesh: number, out: number): number;
  /**
   * Copy the tangents out, given or computed; 0 if the mesh has none.
   * @param out [4] columns x, y, z and handedness of shd_mesh_info.vertex_count elements; NULL data = not wanted
   */
  shd_mesh_read_tangents(mesh: number, out: number): number;
  /**
   * Copy the texture coordinates out; 0 if the mesh has none.
   * @param out [2] columns u, v of shd_mesh_info.vertex_count elements; NULL data = not wanted
   */
  shd_mesh_read_uv(mesh: number, out: number): number;
  /**
   * Copy the second set of texture coordinates out; 0 if the mesh has none.
   * @param out [2] columns u, v of shd_mesh_info.vertex_count elements; NULL data = not wanted
   */
  shd_mesh_read_uv1(mesh: number, out: number): number;
  /**
   * Copy one of the caller's own columns out; 0 if it was absent.
   * @param index 0..SHD_MAX_ATTRIBUTES - 1
   * @param out column of shd_mesh_info.vertex_count elements
   */
  shd_mesh_read_attribute(mesh: number, index: number, out: number): number;
  /**
   * Copy the indices out as separate triangles, also for strips and fans.
   * @param out column of 3 * shd_mesh_info.triangle_count elements, each below shd_mesh_info.vertex_count
   */
  shd_mesh_read_indices(mesh: number, out: number): number;
  /**
   * Make mip levels 1..level_count of an image, in the caller's memory, on the context's executor.
   *
   * With the defaults the levels are those of SHD_TABLE_MIPMAP. Results are clamped to the range of the format,
   * because
   * kernels with negative lobes can exceed it. Finite texels give finite levels.
   * @param base at most 2^28 pixels; borrowed for the call
   * @param desc borrowed for the call
   * @param levelCount 0..floor(log2(max(width, height)))
   * @param levels [level_count], all with the same struct_size; level l is levels[l - 1]: the format of the base,
   * max(1, width >> l) by max(1, height >> l). Pixels are written; they are unspecified if an
   * allocation or the executor fails. They must not overlap each other or the base (checked)
   */
  shd_mip_build(context: number, base: number, desc: number, levelCount: number, levels: number): number;
  /**
   * Turn a normal map into the moments of its slopes, whose averages keep the roughness of normals.
   *
   * A texel is (bx, by, bx^2, by^2) with (bx, by) = (nx / nz, ny / nz), and bx by in an image of its own (Olano
   * and
   * Baker, "LEAN Mapping", 2010, section 3). Build the levels of the results as SHD_TEXEL_CONTENT_DATA; any filter
   * may
   * read them. A filtered texel (bx, by, Mxx, Myy) and Mxy give the mean normal normalise(bx, by, 1) and the
   * covariance
   * of slopes (Mxx - bx^2, Mxy - bx by; Mxy - bx by, Myy - by^2), over which lobes are averaged
   * (shd_normal_encoding).
   *
   * nz is raised to at least 1/32 of the normal's length, so |bx| and |by| are at most 32. Normals that point
   * backwards
   * are limited in the same way. A texel that is 0 or not finite becomes flat: four zeros.
   * @param normals three or four channels, as for SHD_TEXEL_CONTENT_NORMAL, of any length; borrowed for the call
   * @param out an image of that width and height, SHD_FORMAT_RGBA16F or SHD_FORMAT_RGBA32F. Pixels are written;
   * they
   * are unspecified if the executor fails. They must not overlap `normals` (checked)
   * @param mixed bx by, for SHD_SLOT_NORMAL_MIXED: as `out`, but SHD_FORMAT_R16F or SHD_FORMAT_R32F. NULL = not
   * wanted
   */
  shd_normal_moments(context: number, normals: number, out: number, mixed: number): number;
  /**
   * Compute the occlusion of points.
   * @param context its executor, allocator and SIMD target do the work; the objects may come from any context
   * @param desc borrowed for the call
   * @param out column of points->count elements; must not overlap the points (checked)
   */
  shd_occlusion_compute(context: number, desc: number, points: number, out: number): number;
  /**
   * Compute the occlusion of the vertices of a draw, with their vertex normals. Its mesh and object_to_world are
   * read.
   * @param context as in shd_occlusion_compute()
   * @param desc borrowed for the call; the draw occludes only if it is among the occluders
   * @param draw borrowed for the call; without instances
   * @param out column of shd_mesh_info.vertex_count elements
   */
  shd_occlusion_compute_vertices(context: number, desc: number, draw: number, out: number): number;
  /**
   * Compute the occlusion of the texels of a texture, each at the point where shd_bake() shades it.
   *
   * Takes about 100 bytes of working memory for each texel.
   * @param context as in shd_occlusion_compute()
   * @param desc borrowed for the call
   * @param atlas borrowed for the call
   * @param out column of width * height elements, row by row from the top: packed, an image of SHD_FORMAT_R32F
   */
  shd_occlusion_bake(context: number, desc: number, atlas: number, out: number): number;
  /**
   * Compute the barycentric coordinates of points.
   * @param context executor and memory; NULL = the calling thread and malloc. The solver of HARMONIC also uses
   * malloc
   * @param desc columns, borrowed for the call
   * @param points columns, borrowed for the call
   * @param out columns, borrowed for the call; must not overlap any input or each other (checked)
   * @returns SHD_ERROR_UNSUPPORTED for HARMONIC in a build without Eigen; SHD_ERROR_OUT_OF_MEMORY; a polygon that
   * is too
   * thin for the triangles of HARMONIC is SHD_ERROR_INVALID_ARGUMENT
   */
  shd_polygon_evaluate(context: number, desc: number, points: number, out: number): number;
  /**
   * Project directions to points of an image, with derivatives.
   *
   * u and v are within 3e-7 of the exact values. Derivatives are those of the formulas above. Angles below 2^-50
   * rad
   * from the poles of LAT_LONG and from the rim of MIRROR_BALL and ANGULAR, where a derivative goes to infinity,
   * count as
   * 2^-50 rad. NaN derivatives of directions count as 0, and so do finite components beside infinite ones. A
   * component
   * below 2^-100 of the largest one of its derivative may count as 0.
   * @param context its executor and SIMD target are used; concurrent reads
   * @param directions columns, borrowed for the call
   * @param out columns, borrowed for the call; must not overlap any input or each other (checked)
   */
  shd_project_directions(context: number, directions: number, out: number): number;
  /**
   * Compute the directions of points of an image.
   *
   * The components of directions are within 4e-7 of the exact values; at a distance e from the rim of MIRROR_BALL,
   * within
   * 4e-7 + 1e-7 / sqrt(2 e). Solid angles are within 1e-5 of their largest value.
   * @param context its executor and SIMD target are used; concurrent reads
   * @param points columns, borrowed for the call
   * @param out columns, borrowed for the call; must not overlap any input or each other (checked)
   */
  shd_unproject_directions(context: number, points: number, out: number): number;
  /**
   * Convert images of directions to another projection, layout, size or format.
   *
   * Faces of the same projection and size are copied. Otherwise each texel becomes the average over its solid
   * angle of
   * the bilinear lookups of the source, in linear light. Samples along u and along v are at most half as far apart
   * as the
   * texels of the source (measured at the narrowest ones; on the equator of LAT_LONG; from LAT_LONG to LAT_LONG in
   * columns), with at least 2 x 2 in each texel, weighted by their solid angle. Near the rim of a MIRROR_BALL
   * target they
   * are this far apart on average. LAT_LONG sources with far more texels along one axis than a target texel can
   * resolve
   * along both are averaged along it first, so that the work is at most about 64 samples for each pixel of the
   * target and
   * 16 for each pixel of the source. Equal texels give exactly their value. The integral over the sphere is kept
   * to the
   * rounding of the format and the error of the samples: docs/environments.md has measurements. Texels of
   * MIRROR_BALL and
   * ANGULAR outside the disc continue the image across the rim, so that bilinear lookups and mip levels there have
   * no
   * border. Unused parts of crosses become 0. Channels that the source lacks are 0, alpha 1; channels that the
   * target
   * lacks are dropped.
   * @param context its executor and SIMD target are used; its allocator provides 16 bytes for each pixel of the
   * source
   * @param from source; at most 2^26 pixels
   * @param to target; at most 2^26 pixels; its pixels are written; they must not overlap other images (checked)
   */
  shd_projection_convert(context: number, from: number, to: number): number;
  /**
   * Render a frame.
   *
   * On SHD_ERROR_OUT_OF_MEMORY, SHD_ERROR_CALLBACK or SHD_ERROR_CANCELLED the framebuffer may hold a part of
   * the frame; all other objects are unchanged, and the next render works.
   * @param context its executor, allocator and SIMD target do the work; the objects may come from any context
   */
  shd_render(context: number, desc: number): number;
  /**
   * Text of the latest failure on the calling thread, "" if none.
   *
   * UTF-8, one line, at most 1023 bytes. Borrowed: valid until the next call of shd on this thread that fails.
   * Success
   * does not clear it.
   */
  shd_last_error(): number;
  /**
   * Name of a result as in the source, such as "SHD_ERROR_OUT_OF_MEMORY"; "SHD_RESULT_UNKNOWN" for other values.
   *
   * The string is static.
   */
  shd_result_name(result: number): number;
  /**
   * Make a sampler.
   * @param context retained
   * @param desc borrowed for the call; NULL = all defaults
   * @param outSampler owned; NULL on failure
   */
  shd_sampler_create(context: number, desc: number, outSampler: number): number;
  /** Add a reference; NULL is ignored. Any thread. */
  shd_sampler_retain(sampler: number): void;
  /** Drop a reference; NULL is ignored. Any thread. */
  shd_sampler_release(sampler: number): void;
  /**
   * Make a shadow without a map. Call shd_shadow_render() before any lookup.
   * @param context retained
   * @param desc borrowed for the call; NULL = all defaults
   * @param outShadow owned; NULL on failure
   */
  shd_shadow_create(context: number, desc: number, outShadow: number): number;
  /** Add a reference; NULL is ignored. Any thread. */
  shd_shadow_retain(shadow: number): void;
  /** Drop a reference; NULL is ignored. Any thread. */
  shd_shadow_release(shadow: number): void;
  /**
   * Render the map and replace the previous one. On failure the previous map stays.
   *
   * The cone of a spot has one map up to an outer angle of 1.1 rad [63 degrees], and six faces as a point light
   * beyond.
   * Filters read up to size / 8 texels (PCF and VARIANCE: size / 4) beyond the edge of a face, so each face is
   * rendered
   * wider by this margin. The fitted range uses the bounds of the meshes: set bounds and planes if vertex programs
   * move
   * the vertices. Bounds beyond 1e18 are SHD_ERROR_INVALID_ARGUMENT. The map takes 4 bytes per texel (VARIANCE 8,
   * SUMMED_AREA_VARIANCE 16), and during rendering 4 bytes per texel more and a framebuffer of up to 2048 x 2048
   * pixels.
   * @param context its executor, allocator and SIMD target do the work; the objects may come from any context
   */
  shd_shadow_render(context: number, shadow: number, desc: number): number;
  /**
   * Compute the fraction of the light that reaches each point, 0 (in shadow) to 1 (lit), as frames do.
   *
   * Runs on the executor of the shadow's context.
   * @param out column of `count` elements; must not overlap the points (checked)
   */
  shd_shadow_sample(shadow: number, lookups: number, out: number): number;
  /**
   * Compute the numbers of vertices and indices of a shape.
   * @param desc borrowed for the call; NULL = all defaults
   * @param outVertexCount 0 on failure
   * @param outIndexCount three for each triangle; 0 on failure
   */
  shd_shape_count(desc: number, outVertexCount: number, outIndexCount: number): number;
  /**
   * Write a shape. Elements beyond the numbers from shd_shape_count() do not change.
   * @param desc borrowed for the call; NULL = all defaults
   * @param columns borrowed for the call
   * @returns SHD_ERROR_INVALID_ARGUMENT also when a column is too short; nothing is written then
   */
  shd_shape_fill(desc: number, columns: number): number;
  /**
   * Evaluate a solid texture at `points->count` points.
   * @param context executor and SIMD target; NULL = the calling thread and the best target of the machine
   * @param desc borrowed for the call
   * @param points columns, borrowed for the call
   * @param out columns, borrowed for the call; must not overlap any input or each other (checked)
   */
  shd_solid_evaluate(context: number, desc: number, points: number, out: number): number;
  /**
   * Make a mesh of smaller triangles.
   *
   * Triangles follow the order of the original triangles. The vertices of `mesh` come first and keep their numbers
   * and
   * columns, except that -0 becomes 0; vertices on edges and inside triangles follow. Every column is interpolated
   * linearly, normals and tangents are normalised, and handedness is the sign of the interpolated value. A
   * triangle whose
   * edges have different numbers of parts is cut into rows across its two most finely cut edges. Parts meet at
   * vertices
   * only, so a closed mesh stays closed.
   *
   * Displacement moves a vertex along its unit normal by amplitude * (texel - offset), with the texel at its uv. A
   * height
   * that is not finite, or moves a vertex beyond the range of float, counts as 0. Vertices at one position move
   * together
   * by the mean of their displacements, so seams of uv and creases stay closed. A sheet whose two sides are faces
   * at the
   * same positions therefore does not move. Tangents are projected into the planes of the new normals. Heights are
   * looked
   * up only at the vertices: if parts are longer than two texels of level `lod`, texels between vertices have no
   * effect.
   *
   * If the result would have more than max_triangles, the call is refused before it allocates memory, and the
   * error text
   * names the field. In ADAPTIVE mode an edge with an end that is not finite has 1 part. The info of the new mesh
   * has the
   * normalless_count, tangentless_count and split_count of `mesh`.
   * @param context retained by the new mesh
   * @param mesh concurrent reads
   * @param desc borrowed for the call
   * @param outMesh owned; NULL on failure
   */
  shd_mesh_tessellate(context: number, mesh: number, desc: number, outMesh: number): number;
  /**
   * Make a texture: copy or borrow texels, and build the tables.
   *
   * Mip levels that are not given are area averages of the base level, exact for any size, computed in linear
   * light.
   * Levels of sRGB formats are stored sRGB-encoded and rounded to nearest.
   * @param context retained
   * @param desc borrowed for the call; its texels until release with SHD_TEXTURE_BORROW
   * @param outTexture owned; NULL on failure
   */
  shd_texture_create(context: number, desc: number, outTexture: number): number;
  /** Add a reference; NULL is ignored. Any thread. */
  shd_texture_retain(texture: number): void;
  /** Drop a reference; NULL is ignored. Any thread. */
  shd_texture_release(texture: number): void;
  /**
   * Get size, format and memory of a texture.
   * @param outInfo its struct_size is read; the rest is written, all zero on failure
   */
  shd_texture_get_info(texture: number, outInfo: number): number;
  /**
   * Copy one mip level of a layer, or a slice of it in 3D, out as stored: sRGB stays encoded, and the swizzle does
   * not
   * apply. The fourth channel of a format of three is 0 here, while lookups give `fill`. Tiles of blocks are read
   * again.
   * @param layer 0..layers - 1; of a 3D texture the slice, 0..max(1, depth >> level) - 1
   * @param level 0..level_count - 1; its size is max(1, width >> level) by max(1, height >> level)
   * @param out image of that size, and of the format in shd_texture_info; blocks are copied as they are
   */
  shd_texture_read_level(texture: number, layer: number, level: number, out: number): number;
  /**
   * Write a rectangle of the base level of one layer or slice, and rebuild the tables that depend on it. Textures
   * of
   * compressed blocks give SHD_ERROR_UNSUPPORTED.
   *
   * The texture then has the bits that shd_texture_create() gives for the changed base. Mip levels that the caller
   * gave
   * stay as they are.
   *
   * Cost: the first update of a layer whose size halves evenly several times rebuilds all its mip levels and keeps
   * unrounded averages of every 16 x 16 texels (32 x 32 of floats), 1/32 of the memory of RGBA8 texels. Other
   * updates
   * compute only the texels that cover the rectangle. Levels below an odd width or height read all base texels
   * under
   * these texels; ripmap levels do so in whole rows. A summed-area table is recomputed for the whole layer. Levels
   * of 3D
   * textures read 16 slices under the rectangle, or all base texels below an odd size.
   *
   * If the base level is borrowed, the caller writes its texels before this call, while no other call uses the
   * texture.
   * `texels` then has the size of the rectangle, and its pixels are NULL.
   *
   * Nothing is written if an argument is refused or memory runs out. After SHD_ERROR_CALLBACK, when the executor
   * fails,
   * the rectangle and the table entries that cover it are undefined until the same update succeeds.
   * @param texture used by no other call concurrently
   * @param layer 0..layers - 1; of a 3D texture the slice, 0..depth - 1
   * @param x first column and row of the rectangle
   * @param y first column and row of the rectangle
   * @param texels size and texels of the rectangle, in the format of shd_texture_desc or of shd_texture_info;
   * borrowed
   * for the call
   */
  shd_texture_update(texture: number, layer: number, x: number, y: number, texels: number): number;
  /**
   * Make a tile cache.
   * @param context retained; its allocator gives the memory
   * @param desc borrowed for the call; NULL = all defaults
   * @param outCache owned; NULL on failure
   */
  shd_tile_cache_create(context: number, desc: number, outCache: number): number;
  /** Add a reference; NULL is ignored. Any thread. */
  shd_tile_cache_retain(cache: number): void;
  /** Drop a reference; NULL is ignored. Any thread. */
  shd_tile_cache_release(cache: number): void;
  /**
   * Get the counters of a cache.
   * @param outStats its struct_size is read; the rest is written, all zero on failure
   */
  shd_tile_cache_get_stats(cache: number, outStats: number): number;
  /**
   * Load tiles that lookups with SHD_MISSING_TILES_COARSER did not find, the latest request first. A cache keeps
   * the
   * latest requests: up to 4096, or fewer if it has fewer tiles. An engine calls this on the threads that stream.
   * @param maxTiles most tiles to load; 0 = all that are requested
   * @param outLoaded number of tiles that were loaded; may be NULL; 0 on failure
   */
  shd_tile_cache_load_requested(cache: number, maxTiles: number, outLoaded: number): number;
  /**
   * Load the tiles of a region that are not resident. They may be evicted again, also by later tiles of the region
   * if it
   * is larger than the cache.
   */
  shd_texture_load_tiles(texture: number, region: number): number;
  /**
   * Load the tiles of a region, and keep them until shd_texture_unpin_tiles(). Each call counts. Half of the tiles
   * of a
   * cache can be pinned; more give SHD_ERROR_LIMIT. If the call fails, it pins no tile.
   */
  shd_texture_pin_tiles(texture: number, region: number): number;
  /**
   * Undo one shd_texture_pin_tiles() of the same region. A region with a tile that is not pinned gives
   * SHD_ERROR_INVALID_ARGUMENT, and nothing changes.
   */
  shd_texture_unpin_tiles(texture: number, region: number): number;
  /**
   * Drop the tiles of a region, and the tiles of all coarser levels that cover it, because their source has
   * changed.
   * Lookups that begin later load them again; lookups that run meanwhile may use either content. Pinned tiles stay
   * pinned. This call loads them again. If a load fails, it returns the error, and the next call that needs a tile
   * loads
   * it.
   */
  shd_texture_drop_tiles(texture: number, region: number): number;
  /**
   * Perspective projection, view to clip space. With SHD_DEPTH_ORDER_FORWARD and a finite far plane it has the
   * bits of
   * shd_view_from_camera().
   * @param fovY vertical field of view [rad], (0, pi)
   * @param aspect width / height, > 0
   * @param nearPlane distance, > 0
   * @param farPlane distance, > near_plane; INFINITY = no far plane
   * @param order depths of the two planes
   * @param outMatrix [16]
   */
  shd_matrix_perspective(fovY: number, aspect: number, nearPlane: number, farPlane: number, order: number, outMatrix: number): number;
  /**
   * Parallel projection, view to clip space.
   * @param rectangle left, right, bottom, top of the volume in view space; left is not right, bottom is not top
   * @param nearPlane distance along -Z, may be negative
   * @param farPlane distance, > near_plane
   * @param order depths of the two planes
   * @param outMatrix [16]
   */
  shd_matrix_orthographic(rectangle: number, nearPlane: number, farPlane: number, order: number, outMatrix: number): number;
  /**
   * Rigid transform from world to view space: the eye is at the origin, the target on -Z. It has the bits of
   * shd_view_from_camera().
   * @param eye world space
   * @param target world space, not the eye
   * @param up world space, any length, not along the line of sight
   * @param outMatrix [16]
   */
  shd_matrix_look_at(eye: number, target: number, up: number, outMatrix: number): number;
  /**
   * translation * rotation * scale, as glTF 2.0 places nodes.
   * @param translation NULL = none
   * @param rotation quaternion x, y, z, w of any length except 0; NULL = none
   * @param scale factors along x, y, z; NULL = none
   * @param outMatrix [16]
   */
  shd_matrix_from_trs(translation: number, rotation: number, scale: number, outMatrix: number): number;
  /**
   * The product a b. Applied to a vector, b acts first.
   * @param a [16]
   * @param b [16]
   * @param outMatrix [16]
   * @returns SHD_ERROR_INVALID_ARGUMENT also for a product beyond the range of float
   */
  shd_matrix_multiply(a: number, b: number, outMatrix: number): number;
  /**
   * The inverse. An affine matrix, with (0, 0, 0, 1) as its last row, has an affine inverse.
   * @param matrix [16]
   * @param outMatrix [16]
   * @returns SHD_ERROR_INVALID_ARGUMENT for a matrix that is singular, or indistinguishable from a singular one in
   * double
   * precision, and for an inverse beyond the range of float
   */
  shd_matrix_invert(matrix: number, outMatrix: number): number;
  /**
   * The matrix for normals that belongs to `matrix`: the inverse transpose of its upper left 3 x 3. Transformed
   * normals
   * are not unit vectors and need normalising. shd_render() transforms normals by itself.
   * @param matrix [16]
   * @param out3x3 [9], column-major
   * @returns SHD_ERROR_INVALID_ARGUMENT as shd_matrix_invert, of the 3 x 3
   */
  shd_matrix_normal(matrix: number, out3x3: number): number;
  /**
   * A point, (x, y, z, 1), transformed and divided by its w.
   * @param matrix [16]
   * @param point x, y, z
   * @param outPoint [3]
   * @returns SHD_ERROR_INVALID_ARGUMENT also where w is 0, and for a result beyond the range of float
   */
  shd_matrix_transform_point(matrix: number, point: number, outPoint: number): number;
  /**
   * A direction, (x, y, z, 0), transformed; the translation and the last row of the matrix have no effect.
   * @param matrix [16]
   * @param direction x, y, z
   * @param outDirection [3]
   * @returns SHD_ERROR_INVALID_ARGUMENT also for a result beyond the range of float
   */
  shd_matrix_transform_direction(matrix: number, direction: number, outDirection: number): number;
  /**
   * Compute the view of a camera; the same bits on every machine. An aspect of 0 counts as 1 here, because there
   * is no
   * picture. Frames that take the camera itself (shd_render_desc.camera) use the aspect of their picture.
   * @param outView all zero on failure
   */
  shd_view_from_camera(camera: number, outView: number): number;
  /**
   * Make a volume. Finds the range of density in each block of the texture, so that rays skip blocks without
   * extinction;
   * the pictures have the same bits as without skipping. A texture in tiles loads each tile of its base level
   * once; a
   * tile that cannot be loaded fails the call.
   * @param context retained
   * @param desc borrowed for the call
   * @param outVolume owned; NULL on failure
   */
  shd_volume_create(context: number, desc: number, outVolume: number): number;
  /** Add a reference; NULL is ignored. Any thread. */
  shd_volume_retain(volume: number): void;
  /** Drop a reference; NULL is ignored. Any thread. */
  shd_volume_release(volume: number): void;
}
