-- SPDX-License-Identifier: MIT
-- Declarations of libshd and its components. Written by generate.py; do not edit.
return [[
typedef struct shd_bitmap shd_bitmap;
typedef struct shd_color shd_color;
typedef struct shd_context shd_context;
typedef struct shd_embree shd_embree;
typedef struct shd_environment shd_environment;
typedef struct shd_framebuffer shd_framebuffer;
typedef struct shd_light shd_light;
typedef struct shd_material shd_material;
typedef struct shd_mesh shd_mesh;
typedef struct shd_object shd_object;
typedef struct shd_sampler shd_sampler;
typedef struct shd_scene shd_scene;
typedef struct shd_shadow shd_shadow;
typedef struct shd_texture shd_texture;
typedef struct shd_tile_cache shd_tile_cache;
typedef struct shd_volume shd_volume;
typedef enum shd_texel_state {
  SHD_TEXEL_STATE_EMPTY = 0,
  SHD_TEXEL_STATE_CENTRE = 1,
  SHD_TEXEL_STATE_TOUCHED = 2,
  SHD_TEXEL_STATE_DILATED = 3,
  SHD_TEXEL_STATE_MAX_ENUM = 2147483647
} shd_texel_state;
typedef enum shd_level_rule {
  SHD_LEVEL_RULE_LENGTHS = 1,
  SHD_LEVEL_RULE_ELLIPSE = 2,
  SHD_LEVEL_RULE_VULKAN = 4,
  SHD_LEVEL_RULE_OPENGL = 8,
  SHD_LEVEL_RULE_PROFILE = 16,
  SHD_LEVEL_RULE_MAX_ENUM = 2147483647
} shd_level_rule;
typedef enum shd_rules {
  SHD_RULES_VULKAN = 0,
  SHD_RULES_D3D11 = 1,
  SHD_RULES_WEBGPU = 2,
  SHD_RULES_OPENGL = 3,
  SHD_RULES_MAX_ENUM = 2147483647
} shd_rules;
typedef enum shd_display_precision {
  SHD_DISPLAY_PRECISION_BAKED = 0,
  SHD_DISPLAY_PRECISION_EXACT = 1,
  SHD_DISPLAY_PRECISION_MAX_ENUM = 2147483647
} shd_display_precision;
typedef enum shd_log_level {
  SHD_LOG_LEVEL_DEBUG = 0,
  SHD_LOG_LEVEL_INFO = 1,
  SHD_LOG_LEVEL_WARNING = 2,
  SHD_LOG_LEVEL_ERROR = 3,
  SHD_LOG_LEVEL_MAX_ENUM = 2147483647
} shd_log_level;
typedef enum shd_simd {
  SHD_SIMD_BEST = 0,
  SHD_SIMD_BASELINE = 1,
  SHD_SIMD_SCALAR = 2,
  SHD_SIMD_SSE2 = 3,
  SHD_SIMD_SSSE3 = 4,
  SHD_SIMD_SSE4 = 5,
  SHD_SIMD_AVX2 = 6,
  SHD_SIMD_AVX512 = 7,
  SHD_SIMD_NEON = 8,
  SHD_SIMD_WASM = 9,
  SHD_SIMD_MAX_ENUM = 2147483647
} shd_simd;
typedef enum shd_context_flag {
  SHD_CONTEXT_DEFAULT = 0,
  SHD_CONTEXT_RETURN_MEMORY = 1,
  SHD_CONTEXT_FLAG_MAX_ENUM = 2147483647
} shd_context_flag;
typedef enum shd_desc_kind {
  SHD_DESC_KIND_NONE = 0,
  SHD_DESC_KIND_CONTEXT_DESC = 1,
  SHD_DESC_KIND_IMAGE = 2,
  SHD_DESC_KIND_TEXTURE_DESC = 3,
  SHD_DESC_KIND_TEXTURE_INFO = 4,
  SHD_DESC_KIND_MIP_DESC = 5,
  SHD_DESC_KIND_SAMPLER_DESC = 6,
  SHD_DESC_KIND_LOOKUPS = 7,
  SHD_DESC_KIND_TEXELS = 8,
  SHD_DESC_KIND_LEVELS = 9,
  SHD_DESC_KIND_EXPLANATION = 10,
  SHD_DESC_KIND_RAY_DIFFERENTIALS = 11,
  SHD_DESC_KIND_RAY_CONES = 12,
  SHD_DESC_KIND_DERIVATIVES = 13,
  SHD_DESC_KIND_MESH_DESC = 14,
  SHD_DESC_KIND_MESH_INFO = 15,
  SHD_DESC_KIND_EDGES_DESC = 16,
  SHD_DESC_KIND_EDGES = 17,
  SHD_DESC_KIND_TESSELLATION_DESC = 18,
  SHD_DESC_KIND_MATERIAL_DESC = 19,
  SHD_DESC_KIND_SLOT = 20,
  SHD_DESC_KIND_LIGHT_DESC = 21,
  SHD_DESC_KIND_SHADOW_DESC = 22,
  SHD_DESC_KIND_SHADOW_RENDER_DESC = 23,
  SHD_DESC_KIND_SHADOW_LOOKUPS = 24,
  SHD_DESC_KIND_FRAMEBUFFER_DESC = 25,
  SHD_DESC_KIND_FRAMEBUFFER_INFO = 26,
  SHD_DESC_KIND_PLANE_VIEW = 27,
  SHD_DESC_KIND_CAMERA = 28,
  SHD_DESC_KIND_DRAW = 29,
  SHD_DESC_KIND_RENDER_DESC = 30,
  SHD_DESC_KIND_RENDER_STATS = 31,
  SHD_DESC_KIND_COLOR_DESC = 32,
  SHD_DESC_KIND_LOAD_DESC = 33,
  SHD_DESC_KIND_SAVE_DESC = 34,
  SHD_DESC_KIND_BITMAP_INFO = 35,
  SHD_DESC_KIND_SHAPE_DESC = 36,
  SHD_DESC_KIND_SHAPE_COLUMNS = 37,
  SHD_DESC_KIND_SCENE_DESC = 38,
  SHD_DESC_KIND_SCENE_INFO = 39,
  SHD_DESC_KIND_SCENE_INSTANCE = 40,
  SHD_DESC_KIND_SOLID_DESC = 41,
  SHD_DESC_KIND_SOLID_POINTS = 42,
  SHD_DESC_KIND_SOLID_VALUES = 43,
  SHD_DESC_KIND_DIRECTIONS = 44,
  SHD_DESC_KIND_PROJECTED_POINTS = 45,
  SHD_DESC_KIND_IMAGE_POINTS = 46,
  SHD_DESC_KIND_POINT_DIRECTIONS = 47,
  SHD_DESC_KIND_VOLUME_DESC = 48,
  SHD_DESC_KIND_VOLUME_DRAW = 49,
  SHD_DESC_KIND_ENVIRONMENT_DESC = 50,
  SHD_DESC_KIND_ENVIRONMENT_INFO = 51,
  SHD_DESC_KIND_ENVIRONMENT_LOOKUPS = 52,
  SHD_DESC_KIND_ENVIRONMENT_LIGHT = 53,
  SHD_DESC_KIND_DIRECTION_IMAGES = 54,
  SHD_DESC_KIND_POLYGON_DESC = 55,
  SHD_DESC_KIND_POLYGON_POINTS = 56,
  SHD_DESC_KIND_POLYGON_WEIGHTS = 57,
  SHD_DESC_KIND_RAW_DESC = 58,
  SHD_DESC_KIND_STACK_DESC = 59,
  SHD_DESC_KIND_VDB_DESC = 60,
  SHD_DESC_KIND_VDB_INFO = 61,
  SHD_DESC_KIND_BAKE_DESC = 62,
  SHD_DESC_KIND_BAKE_STATS = 63,
  SHD_DESC_KIND_OCCLUSION_DESC = 64,
  SHD_DESC_KIND_OCCLUSION_POINTS = 65,
  SHD_DESC_KIND_OCCLUSION_ATLAS = 66,
  SHD_DESC_KIND_BOUNDS_DESC = 67,
  SHD_DESC_KIND_TEXTURE_FILE_INFO = 68,
  SHD_DESC_KIND_KTX2_DESC = 69,
  SHD_DESC_KIND_TILE_REGION = 70,
  SHD_DESC_KIND_TILE_CACHE_DESC = 71,
  SHD_DESC_KIND_TILE_CACHE_STATS = 72,
  SHD_DESC_KIND_TILE_FILE_DESC = 73,
  SHD_DESC_KIND_TILE_FILE_INFO = 74,
  SHD_DESC_KIND_MAX_ENUM = 2147483647
} shd_desc_kind;
typedef enum shd_edge {
  SHD_EDGE_NONE = 0,
  SHD_EDGE_SILHOUETTE = 1,
  SHD_EDGE_CREASE = 2,
  SHD_EDGE_BORDER = 4,
  SHD_EDGE_NONMANIFOLD = 8,
  SHD_EDGE_ALL = 15,
  SHD_EDGE_MAX_ENUM = 2147483647
} shd_edge;
typedef enum shd_irradiance {
  SHD_IRRADIANCE_HARMONICS = 0,
  SHD_IRRADIANCE_CONVOLVED = 1,
  SHD_IRRADIANCE_MAX_ENUM = 2147483647
} shd_irradiance;
typedef enum shd_environment_table {
  SHD_ENVIRONMENT_TABLE_NONE = 0,
  SHD_ENVIRONMENT_TABLE_RADIANCE = 1,
  SHD_ENVIRONMENT_TABLE_GGX = 2,
  SHD_ENVIRONMENT_TABLE_PHONG = 4,
  SHD_ENVIRONMENT_TABLE_ALL = 7,
  SHD_ENVIRONMENT_TABLE_MAX_ENUM = 2147483647
} shd_environment_table;
typedef enum shd_aov {
  SHD_AOV_NONE = 0,
  SHD_AOV_UV = 1,
  SHD_AOV_NORMAL = 2,
  SHD_AOV_TRIANGLE = 4,
  SHD_AOV_POSITION = 8,
  SHD_AOV_DERIVATIVES = 16,
  SHD_AOV_BARYCENTRICS = 32,
  SHD_AOV_LEVEL = 64,
  SHD_AOV_DRAW = 128,
  SHD_AOV_OVERDRAW = 256,
  SHD_AOV_TARGET1 = 512,
  SHD_AOV_TARGET2 = 1024,
  SHD_AOV_TARGET3 = 2048,
  SHD_AOV_MAX_ENUM = 2147483647
} shd_aov;
typedef enum shd_plane {
  SHD_PLANE_R = 0,
  SHD_PLANE_G = 1,
  SHD_PLANE_B = 2,
  SHD_PLANE_A = 3,
  SHD_PLANE_DEPTH = 4,
  SHD_PLANE_U = 5,
  SHD_PLANE_V = 6,
  SHD_PLANE_NX = 7,
  SHD_PLANE_NY = 8,
  SHD_PLANE_NZ = 9,
  SHD_PLANE_TRIANGLE = 10,
  SHD_PLANE_PX = 11,
  SHD_PLANE_PY = 12,
  SHD_PLANE_PZ = 13,
  SHD_PLANE_DUDX = 14,
  SHD_PLANE_DVDX = 15,
  SHD_PLANE_DUDY = 16,
  SHD_PLANE_DVDY = 17,
  SHD_PLANE_B0 = 18,
  SHD_PLANE_B1 = 19,
  SHD_PLANE_B2 = 20,
  SHD_PLANE_LOD = 21,
  SHD_PLANE_LEVEL = 22,
  SHD_PLANE_DRAW = 23,
  SHD_PLANE_OVERDRAW = 24,
  SHD_PLANE_TARGET1_R = 25,
  SHD_PLANE_TARGET1_G = 26,
  SHD_PLANE_TARGET1_B = 27,
  SHD_PLANE_TARGET1_A = 28,
  SHD_PLANE_TARGET2_R = 29,
  SHD_PLANE_TARGET2_G = 30,
  SHD_PLANE_TARGET2_B = 31,
  SHD_PLANE_TARGET2_A = 32,
  SHD_PLANE_TARGET3_R = 33,
  SHD_PLANE_TARGET3_G = 34,
  SHD_PLANE_TARGET3_B = 35,
  SHD_PLANE_TARGET3_A = 36,
  SHD_PLANE_MAX_ENUM = 2147483647
} shd_plane;
typedef enum shd_format {
  SHD_FORMAT_NONE = 0,
  SHD_FORMAT_R8 = 1,
  SHD_FORMAT_RGBA8 = 2,
  SHD_FORMAT_RGBA8_SRGB = 3,
  SHD_FORMAT_RGBA16F = 4,
  SHD_FORMAT_RGBA32F = 5,
  SHD_FORMAT_RGBA16 = 6,
  SHD_FORMAT_RG8 = 7,
  SHD_FORMAT_RGB8 = 8,
  SHD_FORMAT_R8_SRGB = 9,
  SHD_FORMAT_RG8_SRGB = 10,
  SHD_FORMAT_RGB8_SRGB = 11,
  SHD_FORMAT_R16 = 12,
  SHD_FORMAT_RG16 = 13,
  SHD_FORMAT_RGB16 = 14,
  SHD_FORMAT_R16F = 15,
  SHD_FORMAT_RG16F = 16,
  SHD_FORMAT_RGB16F = 17,
  SHD_FORMAT_R32F = 18,
  SHD_FORMAT_RG32F = 19,
  SHD_FORMAT_RGB32F = 20,
  SHD_FORMAT_BC1_RGB = 21,
  SHD_FORMAT_BC1_RGB_SRGB = 22,
  SHD_FORMAT_BC1_RGBA = 23,
  SHD_FORMAT_BC1_RGBA_SRGB = 24,
  SHD_FORMAT_BC2 = 25,
  SHD_FORMAT_BC2_SRGB = 26,
  SHD_FORMAT_BC3 = 27,
  SHD_FORMAT_BC3_SRGB = 28,
  SHD_FORMAT_BC4 = 29,
  SHD_FORMAT_BC4_SNORM = 30,
  SHD_FORMAT_BC5 = 31,
  SHD_FORMAT_BC5_SNORM = 32,
  SHD_FORMAT_BC6H_UFLOAT = 33,
  SHD_FORMAT_BC6H_SFLOAT = 34,
  SHD_FORMAT_BC7 = 35,
  SHD_FORMAT_BC7_SRGB = 36,
  SHD_FORMAT_RGB9E5 = 37,
  SHD_FORMAT_MAX_ENUM = 2147483647
} shd_format;
typedef enum shd_file_format {
  SHD_FILE_FORMAT_NONE = 0,
  SHD_FILE_FORMAT_PNG = 1,
  SHD_FILE_FORMAT_JPEG = 2,
  SHD_FILE_FORMAT_EXR = 4,
  SHD_FILE_FORMAT_TIFF = 8,
  SHD_FILE_FORMAT_HDR = 16,
  SHD_FILE_FORMAT_TGA = 32,
  SHD_FILE_FORMAT_BMP = 64,
  SHD_FILE_FORMAT_DDS = 128,
  SHD_FILE_FORMAT_WEBP = 256,
  SHD_FILE_FORMAT_PNM = 512,
  SHD_FILE_FORMAT_PSD = 1024,
  SHD_FILE_FORMAT_DPX = 2048,
  SHD_FILE_FORMAT_GIF = 4096,
  SHD_FILE_FORMAT_KTX2 = 8192,
  SHD_FILE_FORMAT_VDB = 16384,
  SHD_FILE_FORMAT_DEFAULT = 25599,
  SHD_FILE_FORMAT_ANY = 1073741824,
  SHD_FILE_FORMAT_MAX_ENUM = 2147483647
} shd_file_format;
typedef enum shd_color_encoding {
  SHD_COLOR_ENCODING_AUTO = 0,
  SHD_COLOR_ENCODING_SRGB = 1,
  SHD_COLOR_ENCODING_LINEAR = 2,
  SHD_COLOR_ENCODING_DATA = 3,
  SHD_COLOR_ENCODING_MAX_ENUM = 2147483647
} shd_color_encoding;
typedef enum shd_load_flag {
  SHD_LOAD_DEFAULT = 0,
  SHD_LOAD_IN_PROCESS = 1,
  SHD_LOAD_PARTIAL = 2,
  SHD_LOAD_FLIP_V = 4,
  SHD_LOAD_FILE_LEVELS = 8,
  SHD_LOAD_LINEAR = 16,
  SHD_LOAD_ALPHA_WEIGHTED = 32,
  SHD_LOAD_PREMULTIPLY = 64,
  SHD_LOAD_FLAG_MAX_ENUM = 2147483647
} shd_load_flag;
typedef enum shd_bitmap_flag {
  SHD_BITMAP_NONE = 0,
  SHD_BITMAP_PARTIAL = 1,
  SHD_BITMAP_PREMULTIPLIED = 2,
  SHD_BITMAP_FLAG_MAX_ENUM = 2147483647
} shd_bitmap_flag;
typedef enum shd_dither {
  SHD_DITHER_NONE = 0,
  SHD_DITHER_ORDERED = 1,
  SHD_DITHER_MAX_ENUM = 2147483647
} shd_dither;
typedef enum shd_light_kind {
  SHD_LIGHT_KIND_POINT = 0,
  SHD_LIGHT_KIND_DIRECTIONAL = 1,
  SHD_LIGHT_KIND_AMBIENT = 2,
  SHD_LIGHT_KIND_SPOT = 3,
  SHD_LIGHT_KIND_MAX_ENUM = 2147483647
} shd_light_kind;
typedef enum shd_model {
  SHD_MODEL_LAMBERT = 0,
  SHD_MODEL_BLINN_PHONG = 1,
  SHD_MODEL_PROGRAM = 2,
  SHD_MODEL_UNLIT = 3,
  SHD_MODEL_PHONG = 4,
  SHD_MODEL_BLINN_PHONG_NORMALIZED = 5,
  SHD_MODEL_COMBINED = 6,
  SHD_MODEL_GOOCH = 7,
  SHD_MODEL_TOON = 8,
  SHD_MODEL_METALLIC_ROUGHNESS = 9,
  SHD_MODEL_MATCAP = 10,
  SHD_MODEL_GLASS = 11,
  SHD_MODEL_MAX_ENUM = 2147483647
} shd_model;
typedef enum shd_debug_view {
  SHD_DEBUG_VIEW_NONE = 0,
  SHD_DEBUG_VIEW_NORMAL = 1,
  SHD_DEBUG_VIEW_UV = 2,
  SHD_DEBUG_VIEW_LEVEL = 3,
  SHD_DEBUG_VIEW_BARYCENTRICS = 4,
  SHD_DEBUG_VIEW_MAX_ENUM = 2147483647
} shd_debug_view;
typedef enum shd_normal_encoding {
  SHD_NORMAL_ENCODING_XYZ = 0,
  SHD_NORMAL_ENCODING_XY = 1,
  SHD_NORMAL_ENCODING_TOKSVIG = 2,
  SHD_NORMAL_ENCODING_MOMENTS = 3,
  SHD_NORMAL_ENCODING_MAX_ENUM = 2147483647
} shd_normal_encoding;
typedef enum shd_bump {
  SHD_BUMP_NONE = 0,
  SHD_BUMP_GRADIENT = 1,
  SHD_BUMP_TEXEL = 2,
  SHD_BUMP_MAX_ENUM = 2147483647
} shd_bump;
typedef enum shd_blend {
  SHD_BLEND_OPAQUE = 0,
  SHD_BLEND_PREMULTIPLIED = 1,
  SHD_BLEND_STRAIGHT = 2,
  SHD_BLEND_ADD = 3,
  SHD_BLEND_MULTIPLY = 4,
  SHD_BLEND_WEIGHTED = 5,
  SHD_BLEND_SORTED = 6,
  SHD_BLEND_MAX_ENUM = 2147483647
} shd_blend;
typedef enum shd_material_flag {
  SHD_MATERIAL_NONE = 0,
  SHD_MATERIAL_SPECULAR_UNGATED = 1,
  SHD_MATERIAL_AMBIENT_PER_LIGHT = 2,
  SHD_MATERIAL_DISCARDS = 4,
  SHD_MATERIAL_ALPHA_TO_COVERAGE = 8,
  SHD_MATERIAL_DOUBLE_SIDED = 16,
  SHD_MATERIAL_NORMAL_Y_DOWN = 32,
  SHD_MATERIAL_FLAG_MAX_ENUM = 2147483647
} shd_material_flag;
typedef enum shd_normal_weight {
  SHD_NORMAL_WEIGHT_AREA = 0,
  SHD_NORMAL_WEIGHT_UNIFORM = 1,
  SHD_NORMAL_WEIGHT_ANGLE = 2,
  SHD_NORMAL_WEIGHT_MAX_ENUM = 2147483647
} shd_normal_weight;
typedef enum shd_topology {
  SHD_TOPOLOGY_TRIANGLES = 0,
  SHD_TOPOLOGY_STRIP = 1,
  SHD_TOPOLOGY_FAN = 2,
  SHD_TOPOLOGY_MAX_ENUM = 2147483647
} shd_topology;
typedef enum shd_mesh_flag {
  SHD_MESH_NONE = 0,
  SHD_MESH_KEEP_NONFINITE = 1,
  SHD_MESH_TANGENTS = 2,
  SHD_MESH_ADJACENCY = 4,
  SHD_MESH_FLAG_MAX_ENUM = 2147483647
} shd_mesh_flag;
typedef enum shd_mip_kernel {
  SHD_MIP_KERNEL_BOX = 0,
  SHD_MIP_KERNEL_TRIANGLE = 1,
  SHD_MIP_KERNEL_KAISER = 2,
  SHD_MIP_KERNEL_LANCZOS = 3,
  SHD_MIP_KERNEL_MAX_ENUM = 2147483647
} shd_mip_kernel;
typedef enum shd_mip_source {
  SHD_MIP_SOURCE_BASE = 0,
  SHD_MIP_SOURCE_PREVIOUS = 1,
  SHD_MIP_SOURCE_MAX_ENUM = 2147483647
} shd_mip_source;
typedef enum shd_texel_content {
  SHD_TEXEL_CONTENT_COLOR = 0,
  SHD_TEXEL_CONTENT_DATA = 1,
  SHD_TEXEL_CONTENT_NORMAL = 2,
  SHD_TEXEL_CONTENT_HEIGHT = 3,
  SHD_TEXEL_CONTENT_ALPHA_COVERAGE = 4,
  SHD_TEXEL_CONTENT_ALPHA_WEIGHTED = 5,
  SHD_TEXEL_CONTENT_MAX_ENUM = 2147483647
} shd_texel_content;
typedef enum shd_barycentric {
  SHD_BARYCENTRIC_WACHSPRESS = 0,
  SHD_BARYCENTRIC_MEAN_VALUE = 1,
  SHD_BARYCENTRIC_DISCRETE_HARMONIC = 2,
  SHD_BARYCENTRIC_HARMONIC = 3,
  SHD_BARYCENTRIC_MAX_ENUM = 2147483647
} shd_barycentric;
typedef enum shd_projection {
  SHD_PROJECTION_NONE = 0,
  SHD_PROJECTION_LAT_LONG = 1,
  SHD_PROJECTION_MIRROR_BALL = 2,
  SHD_PROJECTION_ANGULAR = 3,
  SHD_PROJECTION_CUBE = 4,
  SHD_PROJECTION_OCTAHEDRAL = 5,
  SHD_PROJECTION_MAX_ENUM = 2147483647
} shd_projection;
typedef enum shd_cube_layout {
  SHD_CUBE_LAYOUT_FACES = 0,
  SHD_CUBE_LAYOUT_ROW = 1,
  SHD_CUBE_LAYOUT_COLUMN = 2,
  SHD_CUBE_LAYOUT_HORIZONTAL_CROSS = 3,
  SHD_CUBE_LAYOUT_VERTICAL_CROSS = 4,
  SHD_CUBE_LAYOUT_MAX_ENUM = 2147483647
} shd_cube_layout;
typedef enum shd_frequency {
  SHD_FREQUENCY_PHONG = 0,
  SHD_FREQUENCY_GOURAUD = 1,
  SHD_FREQUENCY_FLAT = 2,
  SHD_FREQUENCY_MAX_ENUM = 2147483647
} shd_frequency;
typedef enum shd_cull {
  SHD_CULL_NONE = 0,
  SHD_CULL_BACK = 1,
  SHD_CULL_FRONT = 2,
  SHD_CULL_MAX_ENUM = 2147483647
} shd_cull;
typedef enum shd_draw_flag {
  SHD_DRAW_NONE = 0,
  SHD_DRAW_KEEP_DEPTH = 1,
  SHD_DRAW_SAMPLE_SHADING = 2,
  SHD_DRAW_FLAG_MAX_ENUM = 2147483647
} shd_draw_flag;
typedef enum shd_fill {
  SHD_FILL_SOLID = 0,
  SHD_FILL_WIREFRAME = 1,
  SHD_FILL_POINTS = 2,
  SHD_FILL_LINES = 3,
  SHD_FILL_MAX_ENUM = 2147483647
} shd_fill;
typedef enum shd_render_flag {
  SHD_RENDER_NONE = 0,
  SHD_RENDER_COUNT_HIDDEN = 1,
  SHD_RENDER_LOAD = 2,
  SHD_RENDER_FLAG_MAX_ENUM = 2147483647
} shd_render_flag;
typedef enum shd_visibility {
  SHD_VISIBILITY_DEPTH = 0,
  SHD_VISIBILITY_PAINTER = 1,
  SHD_VISIBILITY_NEWELL = 2,
  SHD_VISIBILITY_MAX_ENUM = 2147483647
} shd_visibility;
typedef enum shd_background {
  SHD_BACKGROUND_CLEAR = 0,
  SHD_BACKGROUND_ENVIRONMENT = 1,
  SHD_BACKGROUND_MAX_ENUM = 2147483647
} shd_background;
typedef enum shd_result {
  SHD_OK = 0,
  SHD_ERROR_INVALID_ARGUMENT = 1,
  SHD_ERROR_OUT_OF_MEMORY = 2,
  SHD_ERROR_UNSUPPORTED = 3,
  SHD_ERROR_NOT_FOUND = 4,
  SHD_ERROR_IO = 5,
  SHD_ERROR_CORRUPT = 6,
  SHD_ERROR_LIMIT = 7,
  SHD_ERROR_CANCELLED = 8,
  SHD_ERROR_CALLBACK = 9,
  SHD_ERROR_INTERNAL = 10,
  SHD_RESULT_MAX_ENUM = 2147483647
} shd_result;
typedef enum shd_filter {
  SHD_FILTER_TRILINEAR = 0,
  SHD_FILTER_NEAREST = 1,
  SHD_FILTER_BILINEAR = 2,
  SHD_FILTER_BICUBIC = 3,
  SHD_FILTER_NEAREST_MIP = 4,
  SHD_FILTER_BILINEAR_MIP = 5,
  SHD_FILTER_RIPMAP = 6,
  SHD_FILTER_SUMMED_AREA = 7,
  SHD_FILTER_ANISOTROPIC = 8,
  SHD_FILTER_EWA = 9,
  SHD_FILTER_STOCHASTIC = 10,
  SHD_FILTER_EXACT = 11,
  SHD_FILTER_NEAREST_MIP_LINEAR = 12,
  SHD_FILTER_MAX_ENUM = 2147483647
} shd_filter;
typedef enum shd_magnification {
  SHD_MAGNIFICATION_DEFAULT = 0,
  SHD_MAGNIFICATION_NEAREST = 1,
  SHD_MAGNIFICATION_BILINEAR = 2,
  SHD_MAGNIFICATION_BICUBIC = 3,
  SHD_MAGNIFICATION_MAX_ENUM = 2147483647
} shd_magnification;
typedef enum shd_cubic {
  SHD_CUBIC_CATMULL_ROM = 0,
  SHD_CUBIC_B_SPLINE = 1,
  SHD_CUBIC_MITCHELL = 2,
  SHD_CUBIC_MAX_ENUM = 2147483647
} shd_cubic;
typedef enum shd_probe_weights {
  SHD_PROBE_WEIGHTS_EQUAL = 0,
  SHD_PROBE_WEIGHTS_GAUSSIAN = 1,
  SHD_PROBE_WEIGHTS_MAX_ENUM = 2147483647
} shd_probe_weights;
typedef enum shd_box {
  SHD_BOX_BOUNDING = 0,
  SHD_BOX_ORIENTED = 1,
  SHD_BOX_MAX_ENUM = 2147483647
} shd_box;
typedef enum shd_profile {
  SHD_PROFILE_LEAST_ERROR = 0,
  SHD_PROFILE_VULKAN = 1,
  SHD_PROFILE_D3D11 = 2,
  SHD_PROFILE_OIIO = 3,
  SHD_PROFILE_EXACT = 4,
  SHD_PROFILE_MAX_ENUM = 2147483647
} shd_profile;
typedef enum shd_precision {
  SHD_PRECISION_FULL = 0,
  SHD_PRECISION_FAST = 1,
  SHD_PRECISION_MAX_ENUM = 2147483647
} shd_precision;
typedef enum shd_stochastic {
  SHD_STOCHASTIC_TEXEL = 0,
  SHD_STOCHASTIC_QUAD = 1,
  SHD_STOCHASTIC_MAX_ENUM = 2147483647
} shd_stochastic;
typedef enum shd_missing_tiles {
  SHD_MISSING_TILES_WAIT = 0,
  SHD_MISSING_TILES_COARSER = 1,
  SHD_MISSING_TILES_MAX_ENUM = 2147483647
} shd_missing_tiles;
typedef enum shd_compare {
  SHD_COMPARE_LESS = 0,
  SHD_COMPARE_LESS_EQUAL = 1,
  SHD_COMPARE_EQUAL = 2,
  SHD_COMPARE_GREATER_EQUAL = 3,
  SHD_COMPARE_GREATER = 4,
  SHD_COMPARE_NOT_EQUAL = 5,
  SHD_COMPARE_ALWAYS = 6,
  SHD_COMPARE_NEVER = 7,
  SHD_COMPARE_MAX_ENUM = 2147483647
} shd_compare;
typedef enum shd_scene_flag {
  SHD_SCENE_NONE = 0,
  SHD_SCENE_REQUIRE_TEXTURES = 1,
  SHD_SCENE_HOST_FILTERS = 2,
  SHD_SCENE_IN_PROCESS = 4,
  SHD_SCENE_ANY_FOLDER = 8,
  SHD_SCENE_FLAG_MAX_ENUM = 2147483647
} shd_scene_flag;
typedef enum shd_scene_part {
  SHD_SCENE_PART_MESH = 0,
  SHD_SCENE_PART_MATERIAL = 1,
  SHD_SCENE_PART_TEXTURE = 2,
  SHD_SCENE_PART_LIGHT = 3,
  SHD_SCENE_PART_CAMERA = 4,
  SHD_SCENE_PART_ANIMATION = 5,
  SHD_SCENE_PART_MAX_ENUM = 2147483647
} shd_scene_part;
typedef enum shd_shadow_filter {
  SHD_SHADOW_FILTER_HARD = 0,
  SHD_SHADOW_FILTER_PCF = 1,
  SHD_SHADOW_FILTER_VARIANCE = 2,
  SHD_SHADOW_FILTER_SUMMED_AREA_VARIANCE = 3,
  SHD_SHADOW_FILTER_PCSS = 4,
  SHD_SHADOW_FILTER_MAX_ENUM = 2147483647
} shd_shadow_filter;
typedef enum shd_shape {
  SHD_SHAPE_SPHERE = 0,
  SHD_SHAPE_BOX = 1,
  SHD_SHAPE_PLANE = 2,
  SHD_SHAPE_TORUS = 3,
  SHD_SHAPE_TEAPOT = 4,
  SHD_SHAPE_MAX_ENUM = 2147483647
} shd_shape;
typedef enum shd_slot_target {
  SHD_SLOT_DIFFUSE = 0,
  SHD_SLOT_AMBIENT = 1,
  SHD_SLOT_SPECULAR = 2,
  SHD_SLOT_EXPONENT = 3,
  SHD_SLOT_OPACITY = 4,
  SHD_SLOT_EMISSION = 5,
  SHD_SLOT_METALLIC = 6,
  SHD_SLOT_ROUGHNESS = 7,
  SHD_SLOT_OCCLUSION = 8,
  SHD_SLOT_NORMAL = 9,
  SHD_SLOT_HEIGHT = 10,
  SHD_SLOT_MATCAP = 11,
  SHD_SLOT_NORMAL_MIXED = 12,
  SHD_SLOT_CLEARCOAT = 13,
  SHD_SLOT_CLEARCOAT_ROUGHNESS = 14,
  SHD_SLOT_CLEARCOAT_NORMAL = 15,
  SHD_SLOT_TINT = 16,
  SHD_SLOT_TARGET_MAX_ENUM = 2147483647
} shd_slot_target;
typedef enum shd_slot_source {
  SHD_SLOT_SOURCE_CONSTANT = 0,
  SHD_SLOT_SOURCE_TEXTURE = 1,
  SHD_SLOT_SOURCE_VERTEX = 2,
  SHD_SLOT_SOURCE_PROCEDURE = 3,
  SHD_SLOT_SOURCE_SOLID = 4,
  SHD_SLOT_SOURCE_MAX_ENUM = 2147483647
} shd_slot_source;
typedef enum shd_place_space {
  SHD_PLACE_SPACE_OBJECT = 0,
  SHD_PLACE_SPACE_WORLD = 1,
  SHD_PLACE_SPACE_MAX_ENUM = 2147483647
} shd_place_space;
typedef enum shd_solid {
  SHD_SOLID_STRIPES = 0,
  SHD_SOLID_CHECKER = 1,
  SHD_SOLID_PERLIN = 2,
  SHD_SOLID_VALUE = 3,
  SHD_SOLID_SIMPLEX = 4,
  SHD_SOLID_WORLEY = 5,
  SHD_SOLID_MARBLE = 6,
  SHD_SOLID_WOOD = 7,
  SHD_SOLID_MAX_ENUM = 2147483647
} shd_solid;
typedef enum shd_solid_sum {
  SHD_SOLID_SUM_FBM = 0,
  SHD_SOLID_SUM_TURBULENCE = 1,
  SHD_SOLID_SUM_MAX_ENUM = 2147483647
} shd_solid_sum;
typedef enum shd_solid_gradients {
  SHD_SOLID_GRADIENTS_HASHED = 0,
  SHD_SOLID_GRADIENTS_TABLE = 1,
  SHD_SOLID_GRADIENTS_MAX_ENUM = 2147483647
} shd_solid_gradients;
typedef enum shd_solid_fade {
  SHD_SOLID_FADE_QUINTIC = 0,
  SHD_SOLID_FADE_CUBIC = 1,
  SHD_SOLID_FADE_MAX_ENUM = 2147483647
} shd_solid_fade;
typedef enum shd_solid_distance {
  SHD_SOLID_DISTANCE_F1 = 0,
  SHD_SOLID_DISTANCE_F2 = 1,
  SHD_SOLID_DISTANCE_F2_F1 = 2,
  SHD_SOLID_DISTANCE_MAX_ENUM = 2147483647
} shd_solid_distance;
typedef enum shd_tessellation_mode {
  SHD_TESSELLATION_MODE_UNIFORM = 0,
  SHD_TESSELLATION_MODE_ADAPTIVE = 1,
  SHD_TESSELLATION_MODE_MAX_ENUM = 2147483647
} shd_tessellation_mode;
typedef enum shd_displaced_normals {
  SHD_DISPLACED_NORMALS_TILTED = 0,
  SHD_DISPLACED_NORMALS_KEPT = 1,
  SHD_DISPLACED_NORMALS_FACES = 2,
  SHD_DISPLACED_NORMALS_MAX_ENUM = 2147483647
} shd_displaced_normals;
typedef enum shd_table {
  SHD_TABLE_NONE = 0,
  SHD_TABLE_MIPMAP = 1,
  SHD_TABLE_RIPMAP = 2,
  SHD_TABLE_SUMMED_AREA = 4,
  SHD_TABLE_MAX_ENUM = 2147483647
} shd_table;
typedef enum shd_channel {
  SHD_CHANNEL_DEFAULT = 0,
  SHD_CHANNEL_R = 1,
  SHD_CHANNEL_G = 2,
  SHD_CHANNEL_B = 3,
  SHD_CHANNEL_A = 4,
  SHD_CHANNEL_FILL = 5,
  SHD_CHANNEL_MAX_ENUM = 2147483647
} shd_channel;
typedef enum shd_texture_flag {
  SHD_TEXTURE_NONE = 0,
  SHD_TEXTURE_BORROW = 1,
  SHD_TEXTURE_BORROW_LEVELS = 2,
  SHD_TEXTURE_PREMULTIPLIED = 4,
  SHD_TEXTURE_FLAG_MAX_ENUM = 2147483647
} shd_texture_flag;
typedef enum shd_texture_file_kind {
  SHD_TEXTURE_FILE_KIND_NONE = 0,
  SHD_TEXTURE_FILE_KIND_KTX2 = 1,
  SHD_TEXTURE_FILE_KIND_DDS = 2,
  SHD_TEXTURE_FILE_KIND_MAX_ENUM = 2147483647
} shd_texture_file_kind;
typedef enum shd_supercompression {
  SHD_SUPERCOMPRESSION_NONE = 0,
  SHD_SUPERCOMPRESSION_BASIS_LZ = 1,
  SHD_SUPERCOMPRESSION_ZSTD = 2,
  SHD_SUPERCOMPRESSION_ZLIB = 3,
  SHD_SUPERCOMPRESSION_MAX_ENUM = 2147483647
} shd_supercompression;
typedef enum shd_texture_file_flag {
  SHD_TEXTURE_FILE_NONE = 0,
  SHD_TEXTURE_FILE_PREMULTIPLIED = 1,
  SHD_TEXTURE_FILE_ARRAY = 2,
  SHD_TEXTURE_FILE_BOTTOM_UP = 4,
  SHD_TEXTURE_FILE_RIGHT_TO_LEFT = 8,
  SHD_TEXTURE_FILE_FLAG_MAX_ENUM = 2147483647
} shd_texture_file_flag;
typedef enum shd_depth_order {
  SHD_DEPTH_ORDER_FORWARD = 0,
  SHD_DEPTH_ORDER_REVERSED = 1,
  SHD_DEPTH_ORDER_MAX_ENUM = 2147483647
} shd_depth_order;
typedef enum shd_interpolation {
  SHD_INTERPOLATION_PERSPECTIVE = 0,
  SHD_INTERPOLATION_AFFINE = 1,
  SHD_INTERPOLATION_FLAT = 2,
  SHD_INTERPOLATION_MAX_ENUM = 2147483647
} shd_interpolation;
typedef enum shd_raw_sample {
  SHD_RAW_SAMPLE_U8 = 0,
  SHD_RAW_SAMPLE_U16 = 1,
  SHD_RAW_SAMPLE_F16 = 2,
  SHD_RAW_SAMPLE_F32 = 3,
  SHD_RAW_SAMPLE_I8 = 4,
  SHD_RAW_SAMPLE_I16 = 5,
  SHD_RAW_SAMPLE_U32 = 6,
  SHD_RAW_SAMPLE_I32 = 7,
  SHD_RAW_SAMPLE_MAX_ENUM = 2147483647
} shd_raw_sample;
typedef enum shd_byte_order {
  SHD_BYTE_ORDER_LITTLE = 0,
  SHD_BYTE_ORDER_BIG = 1,
  SHD_BYTE_ORDER_MAX_ENUM = 2147483647
} shd_byte_order;
typedef enum shd_vdb_flag {
  SHD_VDB_DEFAULT = 0,
  SHD_VDB_BOX = 1,
  SHD_VDB_FLAG_MAX_ENUM = 2147483647
} shd_vdb_flag;
typedef enum shd_vdb_class {
  SHD_VDB_CLASS_UNKNOWN = 0,
  SHD_VDB_CLASS_LEVEL_SET = 1,
  SHD_VDB_CLASS_FOG_VOLUME = 2,
  SHD_VDB_CLASS_MAX_ENUM = 2147483647
} shd_vdb_class;
typedef enum shd_wrap {
  SHD_WRAP_REPEAT = 0,
  SHD_WRAP_CLAMP = 1,
  SHD_WRAP_MIRROR = 2,
  SHD_WRAP_BORDER = 3,
  SHD_WRAP_MIRROR_ONCE = 4,
  SHD_WRAP_MAX_ENUM = 2147483647
} shd_wrap;
typedef uint32_t shd_level_rules;
typedef uint32_t shd_context_flags;
typedef uint32_t shd_edge_flags;
typedef uint32_t shd_environment_tables;
typedef uint32_t shd_aov_flags;
typedef uint32_t shd_file_format_flags;
typedef uint32_t shd_load_flags;
typedef uint32_t shd_bitmap_flags;
typedef uint32_t shd_material_flags;
typedef uint32_t shd_mesh_flags;
typedef uint32_t shd_draw_flags;
typedef uint32_t shd_render_flags;
typedef uint32_t shd_scene_flags;
typedef uint32_t shd_table_flags;
typedef uint32_t shd_texture_flags;
typedef uint32_t shd_texture_file_flags;
typedef uint32_t shd_vdb_flags;
typedef struct shd_bake_stats shd_bake_stats;
typedef struct shd_bake_desc shd_bake_desc;
typedef struct shd_bounds_desc shd_bounds_desc;
typedef struct shd_color_desc shd_color_desc;
typedef struct shd_color_view shd_color_view;
typedef struct shd_f32_in shd_f32_in;
typedef struct shd_f32_out shd_f32_out;
typedef struct shd_u32_in shd_u32_in;
typedef struct shd_u32_out shd_u32_out;
typedef struct shd_u16_in shd_u16_in;
typedef struct shd_allocator shd_allocator;
typedef struct shd_executor shd_executor;
typedef struct shd_log shd_log;
typedef struct shd_context_desc shd_context_desc;
typedef struct shd_edges_desc shd_edges_desc;
typedef struct shd_edges shd_edges;
typedef struct shd_environment_desc shd_environment_desc;
typedef struct shd_environment_info shd_environment_info;
typedef struct shd_environment_lookups shd_environment_lookups;
typedef struct shd_environment_light shd_environment_light;
typedef struct shd_tap shd_tap;
typedef struct shd_blend_step shd_blend_step;
typedef struct shd_explanation shd_explanation;
typedef struct shd_derivatives shd_derivatives;
typedef struct shd_ray_differentials shd_ray_differentials;
typedef struct shd_ray_cones shd_ray_cones;
typedef struct shd_fragments shd_fragments;
typedef struct shd_radiance shd_radiance;
typedef struct shd_framebuffer_desc shd_framebuffer_desc;
typedef struct shd_framebuffer_info shd_framebuffer_info;
typedef struct shd_plane_view shd_plane_view;
typedef struct shd_display shd_display;
typedef struct shd_image shd_image;
typedef struct shd_load_desc shd_load_desc;
typedef struct shd_bitmap_info shd_bitmap_info;
typedef struct shd_save_desc shd_save_desc;
typedef struct shd_light_desc shd_light_desc;
typedef struct shd_lookups shd_lookups;
typedef struct shd_texels shd_texels;
typedef struct shd_levels shd_levels;
typedef struct shd_material_program shd_material_program;
typedef struct shd_material_desc shd_material_desc;
typedef struct shd_mesh_desc shd_mesh_desc;
typedef struct shd_mesh_info shd_mesh_info;
typedef struct shd_mip_desc shd_mip_desc;
typedef struct shd_rays shd_rays;
typedef struct shd_tracer shd_tracer;
typedef struct shd_occlusion_desc shd_occlusion_desc;
typedef struct shd_occlusion_points shd_occlusion_points;
typedef struct shd_occlusion_atlas shd_occlusion_atlas;
typedef struct shd_polygon_desc shd_polygon_desc;
typedef struct shd_polygon_points shd_polygon_points;
typedef struct shd_polygon_weights shd_polygon_weights;
typedef struct shd_present_tile shd_present_tile;
typedef struct shd_present shd_present;
typedef struct shd_directions shd_directions;
typedef struct shd_projected_points shd_projected_points;
typedef struct shd_image_points shd_image_points;
typedef struct shd_point_directions shd_point_directions;
typedef struct shd_direction_images shd_direction_images;
typedef struct shd_draw shd_draw;
typedef struct shd_render_stats shd_render_stats;
typedef struct shd_progress shd_progress;
typedef struct shd_region shd_region;
typedef struct shd_render_desc shd_render_desc;
typedef struct shd_sampler_desc shd_sampler_desc;
typedef struct shd_scene_desc shd_scene_desc;
typedef struct shd_scene_info shd_scene_info;
typedef struct shd_scene_instance shd_scene_instance;
typedef struct shd_shadow_desc shd_shadow_desc;
typedef struct shd_shadow_render_desc shd_shadow_render_desc;
typedef struct shd_shadow_lookups shd_shadow_lookups;
typedef struct shd_shape_desc shd_shape_desc;
typedef struct shd_shape_columns shd_shape_columns;
typedef struct shd_slot shd_slot;
typedef struct shd_solid_desc shd_solid_desc;
typedef struct shd_solid_points shd_solid_points;
typedef struct shd_solid_values shd_solid_values;
typedef struct shd_tessellation_desc shd_tessellation_desc;
typedef struct shd_texture_desc shd_texture_desc;
typedef struct shd_texture_info shd_texture_info;
typedef struct shd_texture_file_info shd_texture_file_info;
typedef struct shd_ktx2_desc shd_ktx2_desc;
typedef struct shd_tile_cache_desc shd_tile_cache_desc;
typedef struct shd_tile shd_tile;
typedef struct shd_tile_source shd_tile_source;
typedef struct shd_tile_cache_stats shd_tile_cache_stats;
typedef struct shd_tile_file_desc shd_tile_file_desc;
typedef struct shd_tile_file_info shd_tile_file_info;
typedef struct shd_tile_region shd_tile_region;
typedef struct shd_vertices shd_vertices;
typedef struct shd_vertex_outputs shd_vertex_outputs;
typedef struct shd_view shd_view;
typedef struct shd_camera shd_camera;
typedef struct shd_volume_desc shd_volume_desc;
typedef struct shd_volume_draw shd_volume_draw;
typedef struct shd_raw_desc shd_raw_desc;
typedef struct shd_stack_desc shd_stack_desc;
typedef struct shd_vdb_desc shd_vdb_desc;
typedef struct shd_vdb_info shd_vdb_info;
typedef void *(*shd_allocator_allocate_fn)(void *user_data, size_t size, size_t alignment);
typedef void (*shd_allocator_free_fn)(void *user_data, void *memory, size_t size, size_t alignment);
typedef void (*shd_task_fn)(void *task_data, uint32_t index, uint32_t worker);
typedef shd_result (*shd_executor_parallel_for_fn)(void *user_data, uint32_t count, shd_task_fn task, void *task_data);
typedef void (*shd_log_write_fn)(void *user_data, shd_log_level level, const char *message);
typedef void (*shd_object_create_destroy_fn)(void *body);
typedef void (*shd_fragment_fn)(const shd_fragments *in, shd_radiance *out, void *user_data);
typedef shd_result (*shd_display_apply_fn)(void *user_data, const shd_framebuffer *framebuffer, const shd_image *out);
typedef void (*shd_trace_fn)(const shd_rays *rays, uint32_t *blocked, void *user_data);
typedef shd_result (*shd_present_tile_fn)(void *user_data, const shd_present_tile *tile);
typedef int32_t (*shd_progress_report_fn)(void *user_data, float fraction);
typedef shd_result (*shd_scene_desc_find_fn)(void *user_data, const char *name, const void **out_bytes, size_t *out_size);
typedef void (*shd_slot_fn)(const shd_fragments *in, float *const *out, void *user_data);
typedef shd_result (*shd_load_tiles_fn)(void *user_data, const shd_tile *tiles, size_t count);
typedef void (*shd_tile_source_release_fn)(void *user_data);
typedef void (*shd_vertex_fn)(const shd_vertices *in, shd_vertex_outputs *out, void *user_data);
struct shd_bake_stats {
  uint32_t struct_size;
  uint64_t triangles;
  uint64_t zero_area_triangles;
  uint64_t nonfinite_triangles;
  uint64_t outside_triangles;
  uint64_t centre_texels;
  uint64_t touched_texels;
  uint64_t dilated_texels;
  uint64_t overlapping_texels;
  uint64_t nonfinite_texels;
};
struct shd_u32_out {
  uint32_t *data;
  size_t stride;
};
struct shd_bake_desc {
  uint32_t struct_size;
  uint32_t uv_set;
  uint32_t dilation;
  uint32_t flags;
  shd_u32_out states;
  shd_bake_stats *stats;
};
struct shd_bounds_desc {
  uint32_t struct_size;
  shd_level_rules level_rules;
  uint32_t subtexel_bits;
  uint32_t level_bits;
  uint32_t weight_bits;
  uint32_t result_bits;
  float coordinate_error;
  float derivative_error;
  float level_error;
  float relative_error;
  float srgb_error;
};
struct shd_color_desc {
  uint32_t struct_size;
  shd_display_precision display_precision;
  const char *config_path;
  const char *config_text;
  const char *working_space;
};
struct shd_color_view {
  const shd_color *color;
  const char *display;
  const char *view;
};
struct shd_f32_in {
  const float *data;
  size_t stride;
};
struct shd_f32_out {
  float *data;
  size_t stride;
};
struct shd_u32_in {
  const uint32_t *data;
  size_t stride;
};
struct shd_u16_in {
  const uint16_t *data;
  size_t stride;
};
struct shd_allocator {
  shd_allocator_allocate_fn allocate;
  shd_allocator_free_fn free;
  void *user_data;
};
struct shd_executor {
  shd_executor_parallel_for_fn parallel_for;
  void *user_data;
  uint32_t worker_count;
};
struct shd_log {
  shd_log_write_fn write;
  void *user_data;
};
struct shd_context_desc {
  uint32_t struct_size;
  shd_context_flags flags;
  uint32_t worker_count;
  shd_simd simd;
  shd_allocator allocator;
  shd_executor executor;
  shd_log log;
};
struct shd_edges_desc {
  uint32_t struct_size;
  shd_edge_flags edges;
  float eye[4];
  float crease_cosine;
};
struct shd_edges {
  uint32_t struct_size;
  shd_u32_out vertex[2];
  shd_u32_out triangle[2];
  shd_u32_out kinds;
};
struct shd_environment_desc {
  uint32_t struct_size;
  shd_projection projection;
  const shd_image *image;
  shd_irradiance irradiance;
  shd_environment_tables tables;
};
struct shd_environment_info {
  uint32_t struct_size;
  shd_projection projection;
  shd_irradiance irradiance;
  shd_environment_tables tables;
  uint32_t map_size;
  float mean[3];
  uint64_t replaced_count;
  size_t byte_size;
};
struct shd_environment_lookups {
  uint32_t struct_size;
  size_t count;
  shd_f32_in direction[3];
  shd_f32_in roughness;
  shd_f32_in exponent;
};
struct shd_environment_light {
  uint32_t struct_size;
  shd_f32_out rgb[3];
};
struct shd_tap {
  uint32_t layer;
  uint32_t level_u;
  uint32_t level_v;
  uint32_t x;
  uint32_t y;
  uint32_t border;
  float weight;
  float value[4];
  uint32_t z;
};
struct shd_blend_step {
  uint32_t a;
  uint32_t b;
  float s;
};
struct shd_explanation {
  uint32_t struct_size;
  shd_tap *taps;
  shd_blend_step *blends;
  uint32_t tap_size;
  uint32_t tap_capacity;
  uint32_t tap_count;
  uint32_t blend_size;
  uint32_t blend_capacity;
  uint32_t blend_count;
  shd_filter filter;
  float result[4];
  float lod;
  float scale_high[4];
  float scale_low[4];
  uint32_t channel_source[4];
  float longer_axis[2];
  float shorter_axis[2];
};
struct shd_derivatives {
  uint32_t struct_size;
  shd_f32_out dudx;
  shd_f32_out dvdx;
  shd_f32_out dudy;
  shd_f32_out dvdy;
};
struct shd_ray_differentials {
  uint32_t struct_size;
  size_t count;
  shd_f32_in dpdu[3];
  shd_f32_in dpdv[3];
  shd_f32_in direction[3];
  shd_f32_in distance;
  shd_f32_in origin_dx[3];
  shd_f32_in origin_dy[3];
  shd_f32_in direction_dx[3];
  shd_f32_in direction_dy[3];
};
struct shd_ray_cones {
  uint32_t struct_size;
  size_t count;
  shd_f32_in dpdu[3];
  shd_f32_in dpdv[3];
  shd_f32_in direction[3];
  shd_f32_in width;
};
struct shd_fragments {
  uint32_t struct_size;
  uint32_t draw;
  uint32_t instance;
  uint32_t varying_count;
  uint32_t attribute_count;
  size_t count;
  const void *uniforms;
  const float *x;
  const float *y;
  const float *depth;
  const uint32_t *triangle;
  const float *px;
  const float *py;
  const float *pz;
  const float *nx;
  const float *ny;
  const float *nz;
  const float *ox;
  const float *oy;
  const float *oz;
  const float *tx;
  const float *ty;
  const float *tz;
  const float *tw;
  const float *u;
  const float *v;
  const float *u1;
  const float *v1;
  const float *dudx;
  const float *dvdx;
  const float *dudy;
  const float *dvdy;
  const float *const *attribute;
  const float *const *varying;
};
struct shd_radiance {
  uint32_t struct_size;
  uint32_t target_count;
  float *r;
  float *g;
  float *b;
  float *a;
  uint32_t *discard;
  float *const (*target)[4];
};
struct shd_framebuffer_desc {
  uint32_t struct_size;
  uint32_t width;
  uint32_t height;
  uint32_t samples;
  shd_aov_flags aovs;
  shd_format color_format;
};
struct shd_framebuffer_info {
  uint32_t struct_size;
  uint32_t width;
  uint32_t height;
  uint32_t samples;
  shd_aov_flags aovs;
  shd_format color_format;
  size_t byte_size;
};
struct shd_plane_view {
  uint32_t struct_size;
  const float *f32;
  const uint32_t *u32;
  size_t row_stride;
};
struct shd_display {
  shd_display_apply_fn apply;
  void *user_data;
};
struct shd_image {
  uint32_t struct_size;
  shd_format format;
  uint32_t width;
  uint32_t height;
  void *pixels;
  size_t row_stride;
};
struct shd_load_desc {
  uint32_t struct_size;
  shd_file_format_flags formats;
  shd_load_flags flags;
  shd_color_encoding color_space;
  shd_table_flags tables;
  uint32_t subimage;
  uint64_t max_file_bytes;
  uint64_t max_pixels;
  uint64_t max_bytes;
  double max_ratio;
  double time_limit;
  const char *worker_path;
  const shd_raw_desc *raw;
  const shd_stack_desc *stack;
  const shd_vdb_desc *vdb;
  shd_texture_file_info *info;
  shd_vdb_info *vdb_info;
};
struct shd_bitmap_info {
  uint32_t struct_size;
  shd_file_format file_format;
  uint32_t channels;
  shd_bitmap_flags flags;
};
struct shd_save_desc {
  uint32_t struct_size;
  uint32_t bit_depth;
  shd_color_encoding color_space;
  shd_dither dither;
  shd_display display;
};
struct shd_light_desc {
  uint32_t struct_size;
  shd_light_kind kind;
  float intensity[3];
  float position[3];
  float direction[3];
  float range;
  float inner_angle;
  float outer_angle;
  float up[3];
  float extent[2];
  shd_texture *texture;
  shd_sampler *sampler;
};
struct shd_lookups {
  uint32_t struct_size;
  size_t count;
  shd_f32_in u;
  shd_f32_in v;
  shd_f32_in dudx;
  shd_f32_in dvdx;
  shd_f32_in dudy;
  shd_f32_in dvdy;
  shd_f32_in lod;
  shd_u32_in layer;
  shd_u32_in random;
  shd_f32_in w;
  shd_f32_in dwdx;
  shd_f32_in dwdy;
  shd_f32_in reference;
};
struct shd_texels {
  uint32_t struct_size;
  shd_f32_out channel[4];
  shd_f32_out du[4];
  shd_f32_out dv[4];
  size_t nonfinite_count;
  shd_f32_out dw[4];
  shd_u32_out coarser;
};
struct shd_levels {
  uint32_t struct_size;
  shd_f32_out lod;
  shd_u32_out level;
};
struct shd_material_program {
  shd_fragment_fn fragment;
  shd_vertex_fn vertex;
  void *user_data;
};
struct shd_material_desc {
  uint32_t struct_size;
  shd_model model;
  shd_debug_view debug_view;
  shd_material_flags flags;
  float ambient[3];
  float ambient_share;
  float diffuse[3];
  float specular[3];
  float exponent;
  float metallic;
  float roughness;
  float ior;
  float emission[3];
  float opacity;
  float occlusion_strength;
  const shd_slot *slots;
  uint32_t slot_count;
  shd_normal_encoding normal_encoding;
  float normal_scale;
  shd_bump bump;
  float bump_scale;
  float parallax_depth;
  uint32_t parallax_steps;
  float warm[3];
  float cool[3];
  float warm_mix;
  float cool_mix;
  uint32_t toon_steps;
  shd_blend blend;
  float alpha_cutoff;
  shd_material_program program;
  const shd_interpolation *interpolation;
  size_t varying_count;
  float clearcoat;
  float clearcoat_roughness;
};
struct shd_mesh_desc {
  uint32_t struct_size;
  uint32_t vertex_count;
  shd_f32_in position[3];
  shd_f32_in normal[3];
  shd_normal_weight normal_weight;
  shd_mesh_flags flags;
  shd_f32_in tangent[4];
  shd_f32_in uv[2];
  shd_f32_in uv1[2];
  const shd_f32_in *attributes;
  uint32_t attribute_count;
  shd_topology topology;
  shd_u32_in indices;
  shd_u16_in indices16;
  size_t index_count;
};
struct shd_mesh_info {
  uint32_t struct_size;
  uint32_t vertex_count;
  uint32_t triangle_count;
  float bounds_min[3];
  float bounds_max[3];
  uint32_t nonfinite_count;
  uint32_t normalless_count;
  uint32_t tangentless_count;
  uint32_t split_count;
};
struct shd_mip_desc {
  uint32_t struct_size;
  shd_texel_content content;
  shd_mip_kernel kernel;
  shd_mip_source source;
  shd_wrap wrap_u;
  shd_wrap wrap_v;
  float alpha_cutoff;
};
struct shd_rays {
  uint32_t struct_size;
  size_t count;
  const float *ox;
  const float *oy;
  const float *oz;
  const float *dx;
  const float *dy;
  const float *dz;
  const float *length;
};
struct shd_tracer {
  shd_trace_fn trace;
  void *user_data;
};
struct shd_occlusion_desc {
  uint32_t struct_size;
  uint32_t rays;
  uint32_t seed;
  float radius;
  float bias;
  uint32_t map_size;
  shd_tracer tracer;
  const shd_draw *draws;
  size_t draw_count;
};
struct shd_occlusion_points {
  uint32_t struct_size;
  size_t count;
  shd_f32_in position[3];
  shd_f32_in normal[3];
};
struct shd_occlusion_atlas {
  uint32_t struct_size;
  uint32_t width;
  uint32_t height;
  uint32_t uv_set;
  uint32_t dilation;
  float empty;
  const shd_draw *draws;
  size_t draw_count;
  shd_u32_out states;
  shd_bake_stats *stats;
};
struct shd_polygon_desc {
  uint32_t struct_size;
  shd_barycentric kind;
  shd_f32_in vertex[2];
  uint32_t vertex_count;
  uint32_t segments;
};
struct shd_polygon_points {
  uint32_t struct_size;
  size_t count;
  shd_f32_in position[2];
};
struct shd_polygon_weights {
  uint32_t struct_size;
  uint32_t weight_count;
  const shd_f32_out *weight;
  size_t outside_count;
  size_t nonfinite_count;
};
struct shd_present_tile {
  uint32_t struct_size;
  uint32_t worker;
  uint32_t x;
  uint32_t y;
  uint32_t width;
  uint32_t height;
  const float *channel[4];
  size_t row_stride;
};
struct shd_present {
  shd_present_tile_fn tile;
  void *user_data;
};
struct shd_directions {
  uint32_t struct_size;
  shd_projection projection;
  size_t count;
  shd_f32_in direction[3];
  shd_f32_in direction_dx[3];
  shd_f32_in direction_dy[3];
};
struct shd_projected_points {
  uint32_t struct_size;
  shd_f32_out u;
  shd_f32_out v;
  shd_u32_out face;
  shd_f32_out dudx;
  shd_f32_out dvdx;
  shd_f32_out dudy;
  shd_f32_out dvdy;
  size_t nonfinite_count;
};
struct shd_image_points {
  uint32_t struct_size;
  shd_projection projection;
  size_t count;
  shd_f32_in u;
  shd_f32_in v;
  shd_u32_in face;
};
struct shd_point_directions {
  uint32_t struct_size;
  shd_f32_out direction[3];
  shd_f32_out solid_angle;
  size_t nonfinite_count;
};
struct shd_direction_images {
  uint32_t struct_size;
  shd_projection projection;
  shd_cube_layout layout;
  const shd_image *images;
};
struct shd_draw {
  uint32_t struct_size;
  const shd_mesh *mesh;
  const shd_material *material;
  const void *uniforms;
  float object_to_world[16];
  const float *instances;
  size_t instance_count;
  shd_frequency frequency;
  shd_draw_flags flags;
  shd_cull cull;
  shd_compare compare;
  float depth_bias;
  float depth_bias_slope;
  shd_fill fill;
  float fill_width;
  shd_edge_flags edges;
  float crease_cosine;
};
struct shd_render_stats {
  uint32_t struct_size;
  uint64_t triangles;
  uint64_t nonfinite;
  uint64_t outside;
  uint64_t culled;
  uint64_t empty;
  uint64_t rasterised;
  uint64_t clipped;
  uint64_t fragments;
  uint64_t nonfinite_fragments;
  uint64_t hidden_samples;
  uint64_t order_conflicts;
  uint64_t splits;
  uint64_t scratch_bytes;
  double vertex_seconds;
  double assembly_seconds;
  double binning_seconds;
  double tile_seconds;
};
struct shd_progress {
  shd_progress_report_fn report;
  void *user_data;
};
struct shd_region {
  uint32_t x;
  uint32_t y;
  uint32_t width;
  uint32_t height;
};
struct shd_view {
  float world_to_view[16];
  float view_to_clip[16];
  float eye[3];
};
struct shd_render_desc {
  uint32_t struct_size;
  shd_framebuffer *framebuffer;
  float clear_color[4];
  float clear_depth;
  shd_render_flags flags;
  const shd_camera *camera;
  shd_view view;
  shd_visibility visibility;
  const shd_draw *draws;
  size_t draw_count;
  const shd_light *const *lights;
  const shd_shadow *const *shadows;
  size_t light_count;
  uint32_t picture_width;
  uint32_t picture_height;
  uint32_t crop_x;
  uint32_t crop_y;
  const shd_region *viewport;
  const shd_region *scissor;
  uint32_t supersampling;
  uint32_t pass_triangles;
  shd_render_stats *stats;
  shd_progress progress;
  shd_present present;
  const shd_environment *environment;
  float environment_intensity;
  float environment_to_world[9];
  shd_background background;
  float background_roughness;
  const shd_volume_draw *volumes;
  size_t volume_count;
};
struct shd_sampler_desc {
  uint32_t struct_size;
  shd_filter filter;
  shd_magnification magnification;
  shd_wrap wrap_u;
  shd_wrap wrap_v;
  float border[4];
  shd_profile profile;
  float lod_bias;
  float lod_min;
  float lod_max;
  float width_x;
  float width_y;
  float blur_u;
  float blur_v;
  float max_anisotropy;
  shd_probe_weights probe_weights;
  shd_cubic cubic;
  shd_box box;
  float tolerance;
  shd_filter stochastic_filter;
  uint32_t seed;
  shd_precision precision;
  uint32_t max_texels;
  float probe_slack;
  float level_blend;
  shd_stochastic stochastic;
  shd_wrap wrap_w;
  shd_missing_tiles missing_tiles;
  uint32_t compares;
  shd_compare compare;
};
struct shd_scene_desc {
  uint32_t struct_size;
  shd_scene_flags flags;
  shd_mesh_flags mesh_flags;
  const shd_sampler_desc *sampler;
  const shd_load_desc *texture;
  uint64_t max_file_bytes;
  uint64_t max_vertices;
  uint64_t max_triangles;
  uint64_t max_nodes;
  uint64_t max_instances;
  uint64_t max_texture_bytes;
  double time_limit;
  uint64_t max_reader_bytes;
  shd_scene_desc_find_fn find;
  void *find_user_data;
};
struct shd_scene_info {
  uint32_t struct_size;
  uint32_t mesh_count;
  uint32_t material_count;
  uint32_t texture_count;
  uint32_t light_count;
  uint32_t camera_count;
  uint32_t instance_count;
  uint32_t warning_count;
  uint64_t vertex_count;
  uint64_t triangle_count;
  float bounds_min[3];
  float bounds_max[3];
  double origin[3];
  uint32_t animation_count;
  uint32_t deformed_mesh_count;
};
struct shd_scene_instance {
  uint32_t struct_size;
  uint32_t mesh;
  uint32_t material;
  float object_to_world[16];
  shd_cull cull;
};
struct shd_shadow_desc {
  uint32_t struct_size;
  uint32_t size;
  shd_shadow_filter filter;
  uint32_t taps;
  float filter_size;
  float light_size;
  float bias;
  float bias_slope;
  float normal_offset;
  shd_cull caster_cull;
  float bleed;
  float min_variance;
};
struct shd_shadow_render_desc {
  uint32_t struct_size;
  const shd_light *light;
  const shd_draw *draws;
  size_t draw_count;
  float near_plane;
  float far_plane;
  float bounds_min[3];
  float bounds_max[3];
};
struct shd_shadow_lookups {
  uint32_t struct_size;
  size_t count;
  shd_f32_in position[3];
  shd_f32_in normal[3];
};
struct shd_shape_desc {
  uint32_t struct_size;
  shd_shape shape;
  float radius;
  float tube_radius;
  float size[3];
  uint32_t segments[3];
};
struct shd_shape_columns {
  uint32_t struct_size;
  uint32_t vertex_count;
  size_t index_count;
  shd_f32_out position[3];
  shd_f32_out normal[3];
  shd_f32_out uv[2];
  shd_u32_out indices;
};
struct shd_slot {
  uint32_t struct_size;
  shd_slot_target target;
  shd_slot_source source;
  uint32_t attribute;
  shd_texture *texture;
  shd_sampler *sampler;
  shd_slot_fn procedure;
  void *user_data;
  uint32_t channel;
  uint32_t uv_set;
  float uv_transform[6];
  const shd_solid_desc *solid;
  float place_transform[16];
  shd_place_space place_space;
  float place_width;
};
struct shd_solid_desc {
  uint32_t struct_size;
  shd_solid kind;
  uint32_t seed;
  float size;
  uint32_t octaves;
  float lacunarity;
  float gain;
  shd_solid_sum sum;
  shd_solid_gradients gradients;
  shd_solid_fade fade;
  shd_solid_distance distance;
  float distortion;
  float range[2];
  uint32_t color_count;
  float colors[8][4];
};
struct shd_solid_points {
  uint32_t struct_size;
  size_t count;
  shd_f32_in position[3];
  shd_f32_in width;
};
struct shd_solid_values {
  uint32_t struct_size;
  shd_f32_out value;
  shd_f32_out gradient[3];
  shd_f32_out color[4];
  size_t nonfinite_count;
};
struct shd_tessellation_desc {
  uint32_t struct_size;
  shd_tessellation_mode mode;
  uint32_t segments;
  uint32_t max_segments;
  float edge_length;
  uint32_t width;
  uint32_t height;
  uint32_t max_triangles;
  const shd_view *view;
  const float *object_to_world;
  const shd_texture *displacement;
  const shd_sampler *sampler;
  float lod;
  float amplitude;
  float offset;
  shd_displaced_normals normals;
};
struct shd_tile_source {
  shd_tile_cache *cache;
  shd_load_tiles_fn load;
  shd_tile_source_release_fn release;
  void *user_data;
};
struct shd_texture_desc {
  uint32_t struct_size;
  shd_format format;
  uint32_t width;
  uint32_t height;
  const void *texels;
  size_t row_stride;
  size_t layer_stride;
  uint32_t layers;
  shd_texture_flags flags;
  shd_channel swizzle[4];
  float fill[4];
  shd_table_flags tables;
  uint32_t level_count;
  const shd_image *levels;
  uint32_t depth;
  shd_projection projection;
  shd_tile_source tiles;
};
struct shd_texture_info {
  uint32_t struct_size;
  shd_format format;
  uint32_t width;
  uint32_t height;
  uint32_t layers;
  uint32_t level_count;
  shd_table_flags tables;
  shd_texture_flags flags;
  size_t byte_size;
  uint32_t depth;
  shd_projection projection;
};
struct shd_texture_file_info {
  uint32_t struct_size;
  shd_texture_file_kind kind;
  uint32_t file_code;
  shd_supercompression supercompression;
  shd_texture_file_flags flags;
  shd_format format;
  uint32_t width;
  uint32_t height;
  uint32_t depth;
  uint32_t layers;
  uint32_t faces;
  uint32_t level_count;
};
struct shd_ktx2_desc {
  uint32_t struct_size;
  shd_supercompression supercompression;
  int32_t effort;
  uint32_t channels;
};
struct shd_tile_cache_desc {
  uint32_t struct_size;
  uint32_t tile_bytes;
  uint64_t budget_bytes;
};
struct shd_tile {
  uint32_t layer;
  uint32_t level;
  uint32_t x;
  uint32_t y;
  uint32_t width;
  uint32_t height;
  void *texels;
  size_t row_stride;
};
struct shd_tile_cache_stats {
  uint32_t struct_size;
  uint32_t tile_bytes;
  uint64_t budget_bytes;
  uint64_t allocated_bytes;
  uint32_t tile_count;
  uint32_t resident_tiles;
  uint32_t pinned_tiles;
  uint32_t requested_tiles;
  uint64_t loads;
  uint64_t loaded_tiles;
  uint64_t failed_tiles;
  uint64_t evicted_tiles;
  uint64_t waits;
};
struct shd_tile_file_desc {
  uint32_t struct_size;
  shd_color_encoding color_space;
  shd_tile_cache *cache;
  size_t max_readers;
  float fill[4];
};
struct shd_tile_file_info {
  uint32_t struct_size;
  uint32_t columns;
  uint32_t rows;
  uint32_t files;
  uint32_t tile_width;
  uint32_t tile_height;
};
struct shd_tile_region {
  uint32_t struct_size;
  uint32_t layer;
  uint32_t level;
  uint32_t x;
  uint32_t y;
  uint32_t width;
  uint32_t height;
};
struct shd_vertices {
  uint32_t struct_size;
  uint32_t draw;
  uint32_t instance;
  uint32_t first;
  uint32_t attribute_count;
  size_t count;
  const float *px;
  const float *py;
  const float *pz;
  const float *nx;
  const float *ny;
  const float *nz;
  const float *tx;
  const float *ty;
  const float *tz;
  const float *tw;
  const float *u;
  const float *v;
  const float *u1;
  const float *v1;
  const float *const *attribute;
  const float *object_to_world;
  const float *world_to_view;
  const float *view_to_clip;
  const float *eye;
  const void *uniforms;
};
struct shd_vertex_outputs {
  uint32_t struct_size;
  uint32_t varying_count;
  float *x;
  float *y;
  float *z;
  float *w;
  float *px;
  float *py;
  float *pz;
  float *nx;
  float *ny;
  float *nz;
  float *u;
  float *v;
  float *const *varying;
};
struct shd_camera {
  uint32_t struct_size;
  float eye[3];
  float target[3];
  float up[3];
  float fov_y;
  float aspect;
  float near_plane;
  float far_plane;
};
struct shd_volume_desc {
  uint32_t struct_size;
  uint32_t point_count;
  shd_texture *texture;
  shd_f32_in density;
  shd_f32_in extinction;
  shd_f32_in color[3];
  shd_material *material;
  float box_min[3];
  float box_max[3];
  float step;
  float jitter;
  uint32_t seed;
  uint32_t flags;
};
struct shd_volume_draw {
  uint32_t struct_size;
  const shd_volume *volume;
  float object_to_world[16];
};
struct shd_raw_desc {
  uint32_t struct_size;
  uint32_t width;
  uint32_t height;
  uint32_t depth;
  shd_raw_sample sample;
  uint32_t channels;
  shd_byte_order byte_order;
  uint32_t flags;
  uint64_t header_bytes;
};
struct shd_stack_desc {
  uint32_t struct_size;
  uint32_t path_count;
  const char *const *paths;
  const char *pattern;
  uint32_t first;
  uint32_t last;
};
struct shd_vdb_desc {
  uint32_t struct_size;
  shd_vdb_flags flags;
  const char *grid;
  int32_t box_min[3];
  int32_t box_max[3];
};
struct shd_vdb_info {
  uint32_t struct_size;
  shd_vdb_class grid_class;
  int32_t index_min[3];
  float background;
  uint64_t active_voxels;
  float object_to_world[16];
  char grid[64];
};
shd_result shd_bake(shd_context *context, const shd_render_desc *frame, const shd_bake_desc *desc);
uint32_t shd_version(void);
shd_result shd_bounds_preset(shd_rules rules, shd_bounds_desc *out_desc);
shd_result shd_texture_bounds(const shd_texture *texture, const shd_sampler *sampler, const shd_lookups *lookups, const shd_bounds_desc *desc, shd_texels *lower, shd_texels *upper);
const char *shd_color_default_config(void);
shd_result shd_color_create(shd_context *context, const shd_color_desc *desc, shd_color **out_color);
void shd_color_retain(shd_color *color);
void shd_color_release(shd_color *color);
shd_result shd_color_apply_display(const shd_color *color, const shd_framebuffer *framebuffer, const char *display, const char *view, const shd_image *out);
shd_result shd_color_render(const shd_color *color, const shd_render_desc *render, const char *display, const char *view, const shd_image *out);
shd_result shd_color_apply_view(void *color_view, const shd_framebuffer *framebuffer, const shd_image *out);
shd_result shd_color_apply_display_image(const shd_color *color, const shd_image *in, const char *from_space, const char *display, const char *view, const shd_image *out);
shd_result shd_color_convert(const shd_color *color, const char *from_space, const char *to_space, const shd_image *in_out);
uint32_t shd_color_display_count(const shd_color *color);
const char *shd_color_display_name(const shd_color *color, uint32_t index);
const char *shd_color_default_display(const shd_color *color);
uint32_t shd_color_view_count(const shd_color *color, const char *display);
const char *shd_color_view_name(const shd_color *color, const char *display, uint32_t index);
const char *shd_color_default_view(const shd_color *color, const char *display);
uint32_t shd_color_space_count(const shd_color *color);
const char *shd_color_space_name(const shd_color *color, uint32_t index);
const char *shd_color_working_space(const shd_color *color);
shd_result shd_context_create(const shd_context_desc *desc, shd_context **out_context);
void shd_context_retain(shd_context *context);
void shd_context_release(shd_context *context);
void shd_context_trim(shd_context *context);
const char *shd_context_simd_target(const shd_context *context);
uint32_t shd_context_worker_count(const shd_context *context);
shd_result shd_desc_init(shd_desc_kind kind, void *ptr, size_t size);
shd_result shd_mesh_find_edges(const shd_mesh *mesh, const shd_edges_desc *desc, size_t capacity, const shd_edges *out, size_t *out_count);
shd_result shd_embree_create(shd_context *context, const shd_draw *draws, size_t draw_count, shd_embree **out_embree);
void shd_embree_retain(shd_embree *embree);
void shd_embree_release(shd_embree *embree);
shd_result shd_embree_get_tracer(const shd_embree *embree, shd_tracer *out_tracer);
shd_result shd_environment_create(shd_context *context, const shd_environment_desc *desc, shd_environment **out_environment);
void shd_environment_retain(shd_environment *environment);
void shd_environment_release(shd_environment *environment);
shd_result shd_environment_get_info(const shd_environment *environment, shd_environment_info *out_info);
shd_result shd_environment_irradiance(const shd_environment *environment, const shd_environment_lookups *lookups, const shd_environment_light *out);
shd_result shd_environment_radiance(const shd_environment *environment, const shd_environment_lookups *lookups, const shd_environment_light *out);
shd_result shd_texture_explain(const shd_texture *texture, const shd_sampler *sampler, const shd_lookups *lookups, size_t index, shd_explanation *explanation);
shd_result shd_report_error(shd_result result, const char *message);
void *shd_context_allocate(shd_context *context, size_t size, size_t alignment);
void shd_context_free(shd_context *context, void *memory, size_t size, size_t alignment);
void shd_context_log(shd_context *context, shd_log_level level, const char *message);
shd_result shd_context_parallel_for(shd_context *context, uint32_t count, shd_task_fn task, void *task_data);
shd_result shd_object_create(shd_context *context, uint32_t type, void *body, shd_object_create_destroy_fn destroy, shd_object **out_object);
void *shd_object_body(const shd_object *object, uint32_t type);
shd_context *shd_object_context(const shd_object *object);
shd_context *shd_framebuffer_context(const shd_framebuffer *framebuffer);
void shd_object_retain(shd_object *object, uint32_t type);
void shd_object_release(shd_object *object, uint32_t type);
shd_result shd_derivatives_from_differentials(const shd_ray_differentials *rays, const shd_derivatives *out);
shd_result shd_derivatives_from_cones(const shd_ray_cones *cones, const shd_derivatives *out);
shd_result shd_framebuffer_create(shd_context *context, const shd_framebuffer_desc *desc, shd_framebuffer **out_framebuffer);
void shd_framebuffer_retain(shd_framebuffer *framebuffer);
void shd_framebuffer_release(shd_framebuffer *framebuffer);
shd_result shd_framebuffer_get_info(const shd_framebuffer *framebuffer, shd_framebuffer_info *out_info);
shd_result shd_sample_position(uint32_t samples, uint32_t index, float *out_x, float *out_y);
shd_result shd_framebuffer_view_plane(const shd_framebuffer *framebuffer, shd_plane plane, shd_plane_view *out_view);
shd_result shd_framebuffer_view_color(const shd_framebuffer *framebuffer, shd_image *out_view);
shd_result shd_framebuffer_read_plane(const shd_framebuffer *framebuffer, shd_plane plane, const shd_f32_out *out);
shd_result shd_framebuffer_read_u32_plane(const shd_framebuffer *framebuffer, shd_plane plane, const shd_u32_out *out);
shd_result shd_framebuffer_read_color(const shd_framebuffer *framebuffer, const shd_image *out);
size_t shd_format_size(shd_format format);
size_t shd_format_block_size(shd_format format);
shd_result shd_bitmap_load(shd_context *context, const char *path, const shd_load_desc *desc, shd_bitmap **out_bitmap);
shd_result shd_bitmap_load_memory(shd_context *context, const void *bytes, size_t size, const shd_load_desc *desc, shd_bitmap **out_bitmap);
void shd_bitmap_retain(shd_bitmap *bitmap);
void shd_bitmap_release(shd_bitmap *bitmap);
shd_result shd_bitmap_image(const shd_bitmap *bitmap, shd_image *out_image);
const char *shd_bitmap_color_space(const shd_bitmap *bitmap);
shd_result shd_bitmap_get_info(const shd_bitmap *bitmap, shd_bitmap_info *out_info);
shd_result shd_texture_load(shd_context *context, const char *path, const shd_load_desc *desc, shd_texture **out_texture);
shd_result shd_texture_load_memory(shd_context *context, const void *bytes, size_t size, const shd_load_desc *desc, shd_texture **out_texture);
shd_result shd_framebuffer_save(const shd_framebuffer *framebuffer, const char *path, const shd_save_desc *desc);
shd_result shd_image_save(const shd_image *image, const char *path, const shd_save_desc *desc);
shd_result shd_light_create(shd_context *context, const shd_light_desc *desc, shd_light **out_light);
void shd_light_retain(shd_light *light);
void shd_light_release(shd_light *light);
shd_result shd_texture_sample(const shd_texture *texture, const shd_sampler *sampler, const shd_lookups *lookups, shd_texels *out);
shd_result shd_texture_query_levels(const shd_texture *texture, const shd_sampler *sampler, const shd_lookups *lookups, const shd_levels *out);
shd_result shd_material_create(shd_context *context, const shd_material_desc *desc, shd_material **out_material);
void shd_material_retain(shd_material *material);
void shd_material_release(shd_material *material);
shd_result shd_mesh_create(shd_context *context, const shd_mesh_desc *desc, shd_mesh **out_mesh);
shd_result shd_mesh_create_shape(shd_context *context, const shd_shape_desc *desc, shd_mesh_flags flags, shd_mesh **out_mesh);
void shd_mesh_retain(shd_mesh *mesh);
void shd_mesh_release(shd_mesh *mesh);
shd_result shd_mesh_get_info(const shd_mesh *mesh, shd_mesh_info *out_info);
shd_result shd_mesh_read_positions(const shd_mesh *mesh, const shd_f32_out *out);
shd_result shd_mesh_read_normals(const shd_mesh *mesh, const shd_f32_out *out);
shd_result shd_mesh_read_tangents(const shd_mesh *mesh, const shd_f32_out *out);
shd_result shd_mesh_read_uv(const shd_mesh *mesh, const shd_f32_out *out);
shd_result shd_mesh_read_uv1(const shd_mesh *mesh, const shd_f32_out *out);
shd_result shd_mesh_read_attribute(const shd_mesh *mesh, uint32_t index, const shd_f32_out *out);
shd_result shd_mesh_read_indices(const shd_mesh *mesh, const shd_u32_out *out);
shd_result shd_mip_build(shd_context *context, const shd_image *base, const shd_mip_desc *desc, uint32_t level_count, const shd_image *levels);
shd_result shd_normal_moments(shd_context *context, const shd_image *normals, const shd_image *out, const shd_image *mixed);
shd_result shd_occlusion_compute(shd_context *context, const shd_occlusion_desc *desc, const shd_occlusion_points *points, const shd_f32_out *out);
shd_result shd_occlusion_compute_vertices(shd_context *context, const shd_occlusion_desc *desc, const shd_draw *draw, const shd_f32_out *out);
shd_result shd_occlusion_bake(shd_context *context, const shd_occlusion_desc *desc, const shd_occlusion_atlas *atlas, const shd_f32_out *out);
shd_result shd_polygon_evaluate(const shd_context *context, const shd_polygon_desc *desc, const shd_polygon_points *points, shd_polygon_weights *out);
shd_result shd_project_directions(shd_context *context, const shd_directions *directions, shd_projected_points *out);
shd_result shd_unproject_directions(shd_context *context, const shd_image_points *points, shd_point_directions *out);
shd_result shd_projection_convert(shd_context *context, const shd_direction_images *from, const shd_direction_images *to);
shd_result shd_render(shd_context *context, const shd_render_desc *desc);
const char *shd_last_error(void);
const char *shd_result_name(shd_result result);
shd_result shd_sampler_create(shd_context *context, const shd_sampler_desc *desc, shd_sampler **out_sampler);
void shd_sampler_retain(shd_sampler *sampler);
void shd_sampler_release(shd_sampler *sampler);
shd_result shd_scene_load(shd_context *context, const char *path, const shd_scene_desc *desc, shd_scene **out_scene);
shd_result shd_scene_load_memory(shd_context *context, const void *bytes, size_t size, const char *name, const shd_scene_desc *desc, shd_scene **out_scene);
void shd_scene_retain(shd_scene *scene);
void shd_scene_release(shd_scene *scene);
shd_result shd_scene_get_info(const shd_scene *scene, shd_scene_info *out_info);
const char *shd_scene_warning(const shd_scene *scene, uint32_t index);
const char *shd_scene_name(const shd_scene *scene, shd_scene_part part, uint32_t index);
shd_mesh *shd_scene_mesh(const shd_scene *scene, uint32_t index);
shd_material *shd_scene_material(const shd_scene *scene, uint32_t index);
shd_texture *shd_scene_texture(const shd_scene *scene, uint32_t index);
shd_light *shd_scene_light(const shd_scene *scene, uint32_t index);
shd_result shd_scene_get_material_desc(const shd_scene *scene, uint32_t index, shd_material_desc *out_desc);
shd_result shd_scene_get_light_desc(const shd_scene *scene, uint32_t index, shd_light_desc *out_desc);
shd_result shd_scene_get_camera(const shd_scene *scene, uint32_t index, shd_camera *out_camera);
shd_result shd_scene_get_instance(const shd_scene *scene, uint32_t index, shd_scene_instance *out_instance);
shd_result shd_scene_fill_render(const shd_scene *scene, shd_render_desc *in_out_render);
shd_result shd_scene_get_animation_times(const shd_scene *scene, uint32_t index, double *out_first, double *out_last);
shd_result shd_scene_pose(const shd_scene *scene, uint32_t animation, double seconds, shd_scene **out_scene);
shd_result shd_shadow_create(shd_context *context, const shd_shadow_desc *desc, shd_shadow **out_shadow);
void shd_shadow_retain(shd_shadow *shadow);
void shd_shadow_release(shd_shadow *shadow);
shd_result shd_shadow_render(shd_context *context, shd_shadow *shadow, const shd_shadow_render_desc *desc);
shd_result shd_shadow_sample(const shd_shadow *shadow, const shd_shadow_lookups *lookups, const shd_f32_out *out);
shd_result shd_shape_count(const shd_shape_desc *desc, uint32_t *out_vertex_count, size_t *out_index_count);
shd_result shd_shape_fill(const shd_shape_desc *desc, const shd_shape_columns *columns);
shd_result shd_solid_evaluate(const shd_context *context, const shd_solid_desc *desc, const shd_solid_points *points, shd_solid_values *out);
shd_result shd_mesh_tessellate(shd_context *context, const shd_mesh *mesh, const shd_tessellation_desc *desc, shd_mesh **out_mesh);
shd_result shd_texture_create(shd_context *context, const shd_texture_desc *desc, shd_texture **out_texture);
void shd_texture_retain(shd_texture *texture);
void shd_texture_release(shd_texture *texture);
shd_result shd_texture_get_info(const shd_texture *texture, shd_texture_info *out_info);
shd_result shd_texture_read_level(const shd_texture *texture, uint32_t layer, uint32_t level, const shd_image *out);
shd_result shd_texture_update(shd_texture *texture, uint32_t layer, uint32_t x, uint32_t y, const shd_image *texels);
shd_result shd_texture_save_ktx2(const shd_texture *texture, const char *path, const shd_ktx2_desc *desc);
shd_result shd_tile_cache_create(shd_context *context, const shd_tile_cache_desc *desc, shd_tile_cache **out_cache);
void shd_tile_cache_retain(shd_tile_cache *cache);
void shd_tile_cache_release(shd_tile_cache *cache);
shd_result shd_tile_cache_get_stats(const shd_tile_cache *cache, shd_tile_cache_stats *out_stats);
shd_result shd_tile_cache_load_requested(shd_tile_cache *cache, uint32_t max_tiles, uint32_t *out_loaded);
shd_result shd_texture_open(shd_context *context, const char *path, const shd_tile_file_desc *desc, shd_texture **out_texture, shd_tile_file_info *out_info);
shd_result shd_texture_load_tiles(const shd_texture *texture, const shd_tile_region *region);
shd_result shd_texture_pin_tiles(const shd_texture *texture, const shd_tile_region *region);
shd_result shd_texture_unpin_tiles(const shd_texture *texture, const shd_tile_region *region);
shd_result shd_texture_drop_tiles(const shd_texture *texture, const shd_tile_region *region);
shd_result shd_matrix_perspective(float fov_y, float aspect, float near_plane, float far_plane, shd_depth_order order, float *out_matrix);
shd_result shd_matrix_orthographic(const float *rectangle, float near_plane, float far_plane, shd_depth_order order, float *out_matrix);
shd_result shd_matrix_look_at(const float *eye, const float *target, const float *up, float *out_matrix);
shd_result shd_matrix_from_trs(const float *translation, const float *rotation, const float *scale, float *out_matrix);
shd_result shd_matrix_multiply(const float *a, const float *b, float *out_matrix);
shd_result shd_matrix_invert(const float *matrix, float *out_matrix);
shd_result shd_matrix_normal(const float *matrix, float *out_3x3);
shd_result shd_matrix_transform_point(const float *matrix, const float *point, float *out_point);
shd_result shd_matrix_transform_direction(const float *matrix, const float *direction, float *out_direction);
shd_result shd_view_from_camera(const shd_camera *camera, shd_view *out_view);
shd_result shd_volume_create(shd_context *context, const shd_volume_desc *desc, shd_volume **out_volume);
void shd_volume_retain(shd_volume *volume);
void shd_volume_release(shd_volume *volume);
]]
