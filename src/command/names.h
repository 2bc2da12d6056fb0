// SPDX-License-Identifier: MIT
#pragma once
#include <shd/bounds.h>
#include <shd/shd.h>

#include "command/values.h"

namespace command {

// The names on the command line. Help, manual pages, errors and completions take them from here.
inline constexpr Name<shd_filter> kFilters[] = {{"nearest", SHD_FILTER_NEAREST},
                                                {"bilinear", SHD_FILTER_BILINEAR},
                                                {"trilinear", SHD_FILTER_TRILINEAR},
                                                {"bicubic", SHD_FILTER_BICUBIC},
                                                {"nearest-mip", SHD_FILTER_NEAREST_MIP},
                                                {"nearest-mip-linear", SHD_FILTER_NEAREST_MIP_LINEAR},
                                                {"bilinear-mip", SHD_FILTER_BILINEAR_MIP},
                                                {"ripmap", SHD_FILTER_RIPMAP},
                                                {"summed-area", SHD_FILTER_SUMMED_AREA},
                                                {"anisotropic", SHD_FILTER_ANISOTROPIC},
                                                {"ewa", SHD_FILTER_EWA},
                                                {"stochastic", SHD_FILTER_STOCHASTIC},
                                                {"exact", SHD_FILTER_EXACT}};
inline constexpr Name<shd_solid> kSolids[] = {{"stripes", SHD_SOLID_STRIPES}, {"checker", SHD_SOLID_CHECKER},
                                              {"perlin", SHD_SOLID_PERLIN},   {"value", SHD_SOLID_VALUE},
                                              {"simplex", SHD_SOLID_SIMPLEX}, {"worley", SHD_SOLID_WORLEY},
                                              {"marble", SHD_SOLID_MARBLE},   {"wood", SHD_SOLID_WOOD}};
inline constexpr Name<shd_visibility> kVisibilities[] = {
    {"depth", SHD_VISIBILITY_DEPTH}, {"painter", SHD_VISIBILITY_PAINTER}, {"newell", SHD_VISIBILITY_NEWELL}};
inline constexpr Name<uint32_t> kAovs[] = {{"uv", SHD_AOV_UV},
                                           {"normal", SHD_AOV_NORMAL},
                                           {"triangle", SHD_AOV_TRIANGLE},
                                           {"position", SHD_AOV_POSITION},
                                           {"derivatives", SHD_AOV_DERIVATIVES},
                                           {"barycentrics", SHD_AOV_BARYCENTRICS},
                                           {"level", SHD_AOV_LEVEL},
                                           {"draw", SHD_AOV_DRAW},
                                           {"overdraw", SHD_AOV_OVERDRAW},
                                           {"all", 2 * SHD_AOV_OVERDRAW - 1}};
inline constexpr Name<shd_model> kModels[] = {{"lambert", SHD_MODEL_LAMBERT},
                                              {"phong", SHD_MODEL_PHONG},
                                              {"blinn-phong", SHD_MODEL_BLINN_PHONG},
                                              {"normalized", SHD_MODEL_BLINN_PHONG_NORMALIZED},
                                              {"combined", SHD_MODEL_COMBINED},
                                              {"ggx", SHD_MODEL_METALLIC_ROUGHNESS},
                                              {"gooch", SHD_MODEL_GOOCH},
                                              {"toon", SHD_MODEL_TOON},
                                              {"unlit", SHD_MODEL_UNLIT},
                                              {"matcap", SHD_MODEL_MATCAP},
                                              {"glass", SHD_MODEL_GLASS}};
inline constexpr Name<shd_debug_view> kViews[] = {{"normal", SHD_DEBUG_VIEW_NORMAL},
                                                  {"uv", SHD_DEBUG_VIEW_UV},
                                                  {"level", SHD_DEBUG_VIEW_LEVEL},
                                                  {"barycentrics", SHD_DEBUG_VIEW_BARYCENTRICS}};
inline constexpr Name<shd_frequency> kFrequencies[] = {
    {"flat", SHD_FREQUENCY_FLAT}, {"gouraud", SHD_FREQUENCY_GOURAUD}, {"phong", SHD_FREQUENCY_PHONG}};
inline constexpr Name<shd_shape> kShapes[] = {{"teapot", SHD_SHAPE_TEAPOT},
                                              {"sphere", SHD_SHAPE_SPHERE},
                                              {"plane", SHD_SHAPE_PLANE},
                                              {"box", SHD_SHAPE_BOX},
                                              {"torus", SHD_SHAPE_TORUS}};
inline constexpr Name<shd_shadow_filter> kShadows[] = {{"hard", SHD_SHADOW_FILTER_HARD},
                                                       {"pcf", SHD_SHADOW_FILTER_PCF},
                                                       {"variance", SHD_SHADOW_FILTER_VARIANCE},
                                                       {"summed-area", SHD_SHADOW_FILTER_SUMMED_AREA_VARIANCE},
                                                       {"pcss", SHD_SHADOW_FILTER_PCSS}};
inline constexpr Name<shd_projection> kProjections[] = {{"lat-long", SHD_PROJECTION_LAT_LONG},
                                                        {"mirror-ball", SHD_PROJECTION_MIRROR_BALL},
                                                        {"angular", SHD_PROJECTION_ANGULAR},
                                                        {"cube", SHD_PROJECTION_CUBE},
                                                        {"octahedral", SHD_PROJECTION_OCTAHEDRAL}};
inline constexpr Name<shd_bump> kBumps[] = {
    {"none", SHD_BUMP_NONE}, {"gradient", SHD_BUMP_GRADIENT}, {"texel", SHD_BUMP_TEXEL}};
inline constexpr Name<shd_simd> kSimd[] = {{"best", SHD_SIMD_BEST},     {"baseline", SHD_SIMD_BASELINE},
                                           {"scalar", SHD_SIMD_SCALAR}, {"sse2", SHD_SIMD_SSE2},
                                           {"ssse3", SHD_SIMD_SSSE3},   {"sse4", SHD_SIMD_SSE4},
                                           {"avx2", SHD_SIMD_AVX2},     {"avx512", SHD_SIMD_AVX512},
                                           {"neon", SHD_SIMD_NEON},     {"wasm", SHD_SIMD_WASM}};
inline constexpr Name<shd_rules> kRules[] = {{"vulkan", SHD_RULES_VULKAN},
                                             {"d3d11", SHD_RULES_D3D11},
                                             {"webgpu", SHD_RULES_WEBGPU},
                                             {"opengl", SHD_RULES_OPENGL}};
inline constexpr Name<shd_compare> kComparisons[] = {
    {"less", SHD_COMPARE_LESS},       {"less-equal", SHD_COMPARE_LESS_EQUAL},
    {"equal", SHD_COMPARE_EQUAL},     {"greater-equal", SHD_COMPARE_GREATER_EQUAL},
    {"greater", SHD_COMPARE_GREATER}, {"not-equal", SHD_COMPARE_NOT_EQUAL},
    {"always", SHD_COMPARE_ALWAYS},   {"never", SHD_COMPARE_NEVER}};
inline constexpr Name<shd_wrap> kWraps[] = {{"repeat", SHD_WRAP_REPEAT},
                                            {"clamp", SHD_WRAP_CLAMP},
                                            {"mirror", SHD_WRAP_MIRROR},
                                            {"border", SHD_WRAP_BORDER},
                                            {"mirror-once", SHD_WRAP_MIRROR_ONCE}};

}  // namespace command
