// SPDX-License-Identifier: MIT
/// @file
/// The table of the names in shd/names.h. A row has an enum, and a macro whose rows are its constants with their names.
/// style.abi_names compares them with the headers.
#pragma once

#include <shd/names.h>

#include "core/read_desc.h"

#define SHD_NAMES_OF_SIMD(NAME)       \
  NAME(SHD_SIMD_BEST, "best")         \
  NAME(SHD_SIMD_BASELINE, "baseline") \
  NAME(SHD_SIMD_SCALAR, "scalar")     \
  NAME(SHD_SIMD_SSE2, "sse2")         \
  NAME(SHD_SIMD_SSSE3, "ssse3")       \
  NAME(SHD_SIMD_SSE4, "sse4")         \
  NAME(SHD_SIMD_AVX2, "avx2")         \
  NAME(SHD_SIMD_AVX512, "avx512")     \
  NAME(SHD_SIMD_NEON, "neon")         \
  NAME(SHD_SIMD_WASM, "wasm")

#define SHD_NAMES_OF_FORMAT(NAME)                 \
  NAME(SHD_FORMAT_NONE, "none")                   \
  NAME(SHD_FORMAT_R8, "r8")                       \
  NAME(SHD_FORMAT_RGBA8, "rgba8")                 \
  NAME(SHD_FORMAT_RGBA8_SRGB, "rgba8_srgb")       \
  NAME(SHD_FORMAT_RGBA16F, "rgba16f")             \
  NAME(SHD_FORMAT_RGBA32F, "rgba32f")             \
  NAME(SHD_FORMAT_RGBA16, "rgba16")               \
  NAME(SHD_FORMAT_RG8, "rg8")                     \
  NAME(SHD_FORMAT_RGB8, "rgb8")                   \
  NAME(SHD_FORMAT_R8_SRGB, "r8_srgb")             \
  NAME(SHD_FORMAT_RG8_SRGB, "rg8_srgb")           \
  NAME(SHD_FORMAT_RGB8_SRGB, "rgb8_srgb")         \
  NAME(SHD_FORMAT_R16, "r16")                     \
  NAME(SHD_FORMAT_RG16, "rg16")                   \
  NAME(SHD_FORMAT_RGB16, "rgb16")                 \
  NAME(SHD_FORMAT_R16F, "r16f")                   \
  NAME(SHD_FORMAT_RG16F, "rg16f")                 \
  NAME(SHD_FORMAT_RGB16F, "rgb16f")               \
  NAME(SHD_FORMAT_R32F, "r32f")                   \
  NAME(SHD_FORMAT_RG32F, "rg32f")                 \
  NAME(SHD_FORMAT_RGB32F, "rgb32f")               \
  NAME(SHD_FORMAT_BC1_RGB, "bc1_rgb")             \
  NAME(SHD_FORMAT_BC1_RGB_SRGB, "bc1_rgb_srgb")   \
  NAME(SHD_FORMAT_BC1_RGBA, "bc1_rgba")           \
  NAME(SHD_FORMAT_BC1_RGBA_SRGB, "bc1_rgba_srgb") \
  NAME(SHD_FORMAT_BC2, "bc2")                     \
  NAME(SHD_FORMAT_BC2_SRGB, "bc2_srgb")           \
  NAME(SHD_FORMAT_BC3, "bc3")                     \
  NAME(SHD_FORMAT_BC3_SRGB, "bc3_srgb")           \
  NAME(SHD_FORMAT_BC4, "bc4")                     \
  NAME(SHD_FORMAT_BC4_SNORM, "bc4_snorm")         \
  NAME(SHD_FORMAT_BC5, "bc5")                     \
  NAME(SHD_FORMAT_BC5_SNORM, "bc5_snorm")         \
  NAME(SHD_FORMAT_BC6H_UFLOAT, "bc6h_ufloat")     \
  NAME(SHD_FORMAT_BC6H_SFLOAT, "bc6h_sfloat")     \
  NAME(SHD_FORMAT_BC7, "bc7")                     \
  NAME(SHD_FORMAT_BC7_SRGB, "bc7_srgb")           \
  NAME(SHD_FORMAT_RGB9E5, "rgb9e5")

#define SHD_NAMES_OF_WRAP(NAME)   \
  NAME(SHD_WRAP_REPEAT, "repeat") \
  NAME(SHD_WRAP_CLAMP, "clamp")   \
  NAME(SHD_WRAP_MIRROR, "mirror") \
  NAME(SHD_WRAP_BORDER, "border") \
  NAME(SHD_WRAP_MIRROR_ONCE, "mirror_once")

#define SHD_NAMES_OF_FILTER(NAME)                           \
  NAME(SHD_FILTER_TRILINEAR, "trilinear")                   \
  NAME(SHD_FILTER_NEAREST, "nearest")                       \
  NAME(SHD_FILTER_BILINEAR, "bilinear")                     \
  NAME(SHD_FILTER_BICUBIC, "bicubic")                       \
  NAME(SHD_FILTER_NEAREST_MIP, "nearest_mip")               \
  NAME(SHD_FILTER_BILINEAR_MIP, "bilinear_mip")             \
  NAME(SHD_FILTER_RIPMAP, "ripmap")                         \
  NAME(SHD_FILTER_SUMMED_AREA, "summed_area")               \
  NAME(SHD_FILTER_ANISOTROPIC, "anisotropic")               \
  NAME(SHD_FILTER_EWA, "ewa")                               \
  NAME(SHD_FILTER_STOCHASTIC, "stochastic")                 \
  NAME(SHD_FILTER_EXACT, "exact")                           \
  NAME(SHD_FILTER_NEAREST_MIP_LINEAR, "nearest_mip_linear") \
  NAME(SHD_FILTER_HERMITE, "hermite")

#define SHD_NAMES_OF_MAGNIFICATION(NAME)       \
  NAME(SHD_MAGNIFICATION_DEFAULT, "default")   \
  NAME(SHD_MAGNIFICATION_NEAREST, "nearest")   \
  NAME(SHD_MAGNIFICATION_BILINEAR, "bilinear") \
  NAME(SHD_MAGNIFICATION_BICUBIC, "bicubic")   \
  NAME(SHD_MAGNIFICATION_HERMITE, "hermite")

#define SHD_NAMES_OF_CUBIC(NAME)             \
  NAME(SHD_CUBIC_CATMULL_ROM, "catmull_rom") \
  NAME(SHD_CUBIC_B_SPLINE, "b_spline")       \
  NAME(SHD_CUBIC_MITCHELL, "mitchell")

#define SHD_NAMES_OF_PROFILE(NAME)             \
  NAME(SHD_PROFILE_LEAST_ERROR, "least_error") \
  NAME(SHD_PROFILE_VULKAN, "vulkan")           \
  NAME(SHD_PROFILE_D3D11, "d3d11")             \
  NAME(SHD_PROFILE_OIIO, "oiio")               \
  NAME(SHD_PROFILE_EXACT, "exact")

#define SHD_NAMES_OF_PRECISION(NAME) \
  NAME(SHD_PRECISION_FULL, "full")   \
  NAME(SHD_PRECISION_FAST, "fast")

#define SHD_NAMES_OF_STOCHASTIC(NAME) \
  NAME(SHD_STOCHASTIC_TEXEL, "texel") \
  NAME(SHD_STOCHASTIC_QUAD, "quad")

#define SHD_NAMES_OF_COMPARE(NAME)                 \
  NAME(SHD_COMPARE_LESS, "less")                   \
  NAME(SHD_COMPARE_LESS_EQUAL, "less_equal")       \
  NAME(SHD_COMPARE_EQUAL, "equal")                 \
  NAME(SHD_COMPARE_GREATER_EQUAL, "greater_equal") \
  NAME(SHD_COMPARE_GREATER, "greater")             \
  NAME(SHD_COMPARE_NOT_EQUAL, "not_equal")         \
  NAME(SHD_COMPARE_ALWAYS, "always")               \
  NAME(SHD_COMPARE_NEVER, "never")

#define SHD_NAMES_OF_TEXTURE_KIND(NAME) \
  NAME(SHD_TEXTURE_KIND_2D, "2d")       \
  NAME(SHD_TEXTURE_KIND_3D, "3d")       \
  NAME(SHD_TEXTURE_KIND_DIRECTIONS, "directions")

#define SHD_NAMES_OF_PROJECTION(NAME)             \
  NAME(SHD_PROJECTION_NONE, "none")               \
  NAME(SHD_PROJECTION_LAT_LONG, "lat_long")       \
  NAME(SHD_PROJECTION_MIRROR_BALL, "mirror_ball") \
  NAME(SHD_PROJECTION_ANGULAR, "angular")         \
  NAME(SHD_PROJECTION_CUBE, "cube")               \
  NAME(SHD_PROJECTION_OCTAHEDRAL, "octahedral")

#define SHD_NAMES_OF_MIP_KERNEL(NAME)       \
  NAME(SHD_MIP_KERNEL_BOX, "box")           \
  NAME(SHD_MIP_KERNEL_TRIANGLE, "triangle") \
  NAME(SHD_MIP_KERNEL_KAISER, "kaiser")     \
  NAME(SHD_MIP_KERNEL_LANCZOS, "lanczos")

#define SHD_NAMES_OF_TEXEL_CONTENT(NAME)                   \
  NAME(SHD_TEXEL_CONTENT_COLOR, "color")                   \
  NAME(SHD_TEXEL_CONTENT_DATA, "data")                     \
  NAME(SHD_TEXEL_CONTENT_NORMAL, "normal")                 \
  NAME(SHD_TEXEL_CONTENT_HEIGHT, "height")                 \
  NAME(SHD_TEXEL_CONTENT_ALPHA_COVERAGE, "alpha_coverage") \
  NAME(SHD_TEXEL_CONTENT_ALPHA_WEIGHTED, "alpha_weighted")

#define SHD_NAMES_OF_SHAPE(NAME)   \
  NAME(SHD_SHAPE_SPHERE, "sphere") \
  NAME(SHD_SHAPE_BOX, "box")       \
  NAME(SHD_SHAPE_PLANE, "plane")   \
  NAME(SHD_SHAPE_TORUS, "torus")   \
  NAME(SHD_SHAPE_TEAPOT, "teapot")

#define SHD_NAMES_OF_SOLID(NAME)     \
  NAME(SHD_SOLID_STRIPES, "stripes") \
  NAME(SHD_SOLID_CHECKER, "checker") \
  NAME(SHD_SOLID_PERLIN, "perlin")   \
  NAME(SHD_SOLID_VALUE, "value")     \
  NAME(SHD_SOLID_SIMPLEX, "simplex") \
  NAME(SHD_SOLID_WORLEY, "worley")   \
  NAME(SHD_SOLID_MARBLE, "marble")   \
  NAME(SHD_SOLID_WOOD, "wood")

#define SHD_NAMES_OF_MODEL(NAME)                                   \
  NAME(SHD_MODEL_LAMBERT, "lambert")                               \
  NAME(SHD_MODEL_BLINN_PHONG, "blinn_phong")                       \
  NAME(SHD_MODEL_PROGRAM, "program")                               \
  NAME(SHD_MODEL_UNLIT, "unlit")                                   \
  NAME(SHD_MODEL_PHONG, "phong")                                   \
  NAME(SHD_MODEL_BLINN_PHONG_NORMALIZED, "blinn_phong_normalized") \
  NAME(SHD_MODEL_COMBINED, "combined")                             \
  NAME(SHD_MODEL_GOOCH, "gooch")                                   \
  NAME(SHD_MODEL_TOON, "toon")                                     \
  NAME(SHD_MODEL_METALLIC_ROUGHNESS, "metallic_roughness")         \
  NAME(SHD_MODEL_MATCAP, "matcap")                                 \
  NAME(SHD_MODEL_GLASS, "glass")

#define SHD_NAMES_OF_BLEND(NAME)                 \
  NAME(SHD_BLEND_OPAQUE, "opaque")               \
  NAME(SHD_BLEND_PREMULTIPLIED, "premultiplied") \
  NAME(SHD_BLEND_STRAIGHT, "straight")           \
  NAME(SHD_BLEND_ADD, "add")                     \
  NAME(SHD_BLEND_MULTIPLY, "multiply")           \
  NAME(SHD_BLEND_WEIGHTED, "weighted")           \
  NAME(SHD_BLEND_SORTED, "sorted")

#define SHD_NAMES_OF_NORMAL_ENCODING(NAME)     \
  NAME(SHD_NORMAL_ENCODING_XYZ, "xyz")         \
  NAME(SHD_NORMAL_ENCODING_XY, "xy")           \
  NAME(SHD_NORMAL_ENCODING_TOKSVIG, "toksvig") \
  NAME(SHD_NORMAL_ENCODING_MOMENTS, "moments")

#define SHD_NAMES_OF_SLOT_TARGET(NAME)                      \
  NAME(SHD_SLOT_DIFFUSE, "diffuse")                         \
  NAME(SHD_SLOT_AMBIENT, "ambient")                         \
  NAME(SHD_SLOT_SPECULAR, "specular")                       \
  NAME(SHD_SLOT_EXPONENT, "exponent")                       \
  NAME(SHD_SLOT_OPACITY, "opacity")                         \
  NAME(SHD_SLOT_EMISSION, "emission")                       \
  NAME(SHD_SLOT_METALLIC, "metallic")                       \
  NAME(SHD_SLOT_ROUGHNESS, "roughness")                     \
  NAME(SHD_SLOT_OCCLUSION, "occlusion")                     \
  NAME(SHD_SLOT_NORMAL, "normal")                           \
  NAME(SHD_SLOT_HEIGHT, "height")                           \
  NAME(SHD_SLOT_MATCAP, "matcap")                           \
  NAME(SHD_SLOT_NORMAL_MIXED, "normal_mixed")               \
  NAME(SHD_SLOT_CLEARCOAT, "clearcoat")                     \
  NAME(SHD_SLOT_CLEARCOAT_ROUGHNESS, "clearcoat_roughness") \
  NAME(SHD_SLOT_CLEARCOAT_NORMAL, "clearcoat_normal")       \
  NAME(SHD_SLOT_TINT, "tint")

#define SHD_NAMES_OF_LIGHT_KIND(NAME)             \
  NAME(SHD_LIGHT_KIND_POINT, "point")             \
  NAME(SHD_LIGHT_KIND_DIRECTIONAL, "directional") \
  NAME(SHD_LIGHT_KIND_AMBIENT, "ambient")         \
  NAME(SHD_LIGHT_KIND_SPOT, "spot")

#define SHD_NAMES_OF_SHADOW_FILTER(NAME)                               \
  NAME(SHD_SHADOW_FILTER_HARD, "hard")                                 \
  NAME(SHD_SHADOW_FILTER_PCF, "pcf")                                   \
  NAME(SHD_SHADOW_FILTER_VARIANCE, "variance")                         \
  NAME(SHD_SHADOW_FILTER_SUMMED_AREA_VARIANCE, "summed_area_variance") \
  NAME(SHD_SHADOW_FILTER_PCSS, "pcss")

#define SHD_NAMES_OF_FREQUENCY(NAME)     \
  NAME(SHD_FREQUENCY_PHONG, "phong")     \
  NAME(SHD_FREQUENCY_GOURAUD, "gouraud") \
  NAME(SHD_FREQUENCY_FLAT, "flat")

#define SHD_NAMES_OF_CULL(NAME) \
  NAME(SHD_CULL_NONE, "none")   \
  NAME(SHD_CULL_BACK, "back")   \
  NAME(SHD_CULL_FRONT, "front")

#define SHD_NAMES_OF_FILL(NAME)         \
  NAME(SHD_FILL_SOLID, "solid")         \
  NAME(SHD_FILL_WIREFRAME, "wireframe") \
  NAME(SHD_FILL_POINTS, "points")       \
  NAME(SHD_FILL_LINES, "lines")

#define SHD_NAMES_OF_VISIBILITY(NAME)     \
  NAME(SHD_VISIBILITY_DEPTH, "depth")     \
  NAME(SHD_VISIBILITY_PAINTER, "painter") \
  NAME(SHD_VISIBILITY_NEWELL, "newell")

#define SHD_NAMED_ENUMS(ENUM)                                                       \
  ENUM(shd_simd, shd_simd_name, SHD_NAMES_OF_SIMD)                                  \
  ENUM(shd_format, shd_format_name, SHD_NAMES_OF_FORMAT)                            \
  ENUM(shd_wrap, shd_wrap_name, SHD_NAMES_OF_WRAP)                                  \
  ENUM(shd_filter, shd_filter_name, SHD_NAMES_OF_FILTER)                            \
  ENUM(shd_magnification, shd_magnification_name, SHD_NAMES_OF_MAGNIFICATION)       \
  ENUM(shd_cubic, shd_cubic_name, SHD_NAMES_OF_CUBIC)                               \
  ENUM(shd_profile, shd_profile_name, SHD_NAMES_OF_PROFILE)                         \
  ENUM(shd_precision, shd_precision_name, SHD_NAMES_OF_PRECISION)                   \
  ENUM(shd_stochastic, shd_stochastic_name, SHD_NAMES_OF_STOCHASTIC)                \
  ENUM(shd_compare, shd_compare_name, SHD_NAMES_OF_COMPARE)                         \
  ENUM(shd_texture_kind, shd_texture_kind_name, SHD_NAMES_OF_TEXTURE_KIND)          \
  ENUM(shd_projection, shd_projection_name, SHD_NAMES_OF_PROJECTION)                \
  ENUM(shd_mip_kernel, shd_mip_kernel_name, SHD_NAMES_OF_MIP_KERNEL)                \
  ENUM(shd_texel_content, shd_texel_content_name, SHD_NAMES_OF_TEXEL_CONTENT)       \
  ENUM(shd_shape, shd_shape_name, SHD_NAMES_OF_SHAPE)                               \
  ENUM(shd_solid, shd_solid_name, SHD_NAMES_OF_SOLID)                               \
  ENUM(shd_model, shd_model_name, SHD_NAMES_OF_MODEL)                               \
  ENUM(shd_blend, shd_blend_name, SHD_NAMES_OF_BLEND)                               \
  ENUM(shd_normal_encoding, shd_normal_encoding_name, SHD_NAMES_OF_NORMAL_ENCODING) \
  ENUM(shd_slot_target, shd_slot_target_name, SHD_NAMES_OF_SLOT_TARGET)             \
  ENUM(shd_light_kind, shd_light_kind_name, SHD_NAMES_OF_LIGHT_KIND)                \
  ENUM(shd_shadow_filter, shd_shadow_filter_name, SHD_NAMES_OF_SHADOW_FILTER)       \
  ENUM(shd_frequency, shd_frequency_name, SHD_NAMES_OF_FREQUENCY)                   \
  ENUM(shd_cull, shd_cull_name, SHD_NAMES_OF_CULL)                                  \
  ENUM(shd_fill, shd_fill_name, SHD_NAMES_OF_FILL)                                  \
  ENUM(shd_visibility, shd_visibility_name, SHD_NAMES_OF_VISIBILITY)

namespace shd::core {

/// The value of a constant as messages have it: "TRILINEAR" for SHD_FILTER_TRILINEAR.
#define SHD_VALUE_CASE(constant, name) \
  case constant:                       \
    return &(#constant)[sizeof #constant - sizeof name];
#define SHD_VALUE_FUNCTION(type, function, names)                                   \
  inline const char* value_name(type value) {                                       \
    switch (enum_bits(value)) { names(SHD_VALUE_CASE) default : return "unknown"; } \
  }
SHD_NAMED_ENUMS(SHD_VALUE_FUNCTION)
#undef SHD_VALUE_FUNCTION
#undef SHD_VALUE_CASE

}  // namespace shd::core
