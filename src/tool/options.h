// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <shd/shd.h>
#include <shd/volume_file.h>

/// The volume of the command line.
struct VolumeOptions {
  std::string file;                   // .vdb, a pattern or a file of pages, or voxels of `size`; empty = no volume
  std::array<uint32_t, 3> size = {};  // voxels of a file without a format; 0 = another file
  shd_raw_sample sample = SHD_RAW_SAMPLE_U8;
  shd_byte_order order = SHD_BYTE_ORDER_LITTLE;
  uint64_t header = 0;                        // [bytes]
  uint32_t first = 0, last = 0;               // numbers of a pattern
  std::string grid;                           // name in a .vdb file; empty = the first one
  std::array<float, 3> spacing = {1, 1, 1};   // distances of voxels along x, y and z
  bool slices_up = false;                     // the axis of the slices is +Y, not -Z
  std::optional<std::array<float, 2>> range;  // densities of the transfer function; absent = all densities
  float density = 1.0f;                       // factor of extinction
};

/// A light of the command line. Positions are in radii of the model around its centre; directions point to the light;
/// spots are aimed at the centre.
struct LightOption {
  shd_light_kind kind = SHD_LIGHT_KIND_POINT;
  std::array<float, 3> place = {0, 0, 0};
  std::array<float, 3> color = {1, 1, 1};
};

enum class LightPreset { kStudio, kHeadlight, kCourse, kFile, kNone };

/// Method by which mip levels of normal maps keep the roughness of bumps that they no longer resolve.
enum class KeepRoughness { kNone, kToksvig, kLean };

/// A table that is drawn in place of the model.
enum class Table { kMipmap, kRipmap, kSummedArea, kShadowMap };

/// Coordinates of textures: those of the meshes, rules that give them to the vertices of meshes without any
/// (shd_uv_projection), or coordinates of each fragment.
enum class Uv { kMesh, kPlanar, kSpherical, kCylindrical, kBox, kTriplanar, kCamera };

/// Where the eye of a picture is: around the model, or at a camera of the file.
struct Shot {
  float azimuth = 30.0f, elevation = 20.0f;  // [deg]
  float distance = 0.0f;                     // [radii of the model]; 0 = the whole model fits
  std::optional<uint32_t> camera;            // number of a camera of the file; replaces the fields above
};

/// The views of `--show`.
enum class Show {
  kNone,  // the shaded model
  kNormal,
  kUv,
  kBarycentrics,
  kDepth,
  kPosition,
  kOverdraw,
  kLevel,
  kLevelNearest,
  kTangents,
  kFootprint,
  kUvLayout,
  kTerms
};

/// Terms of the models of reflectance.
enum class Term { kAll, kAmbient, kDiffuse, kSpecular };

/// The pixels that `--zoom` enlarges: `size` x `size` around the pixel (x, y); size 0 = no zoom.
struct ZoomOption {
  uint32_t x = 0, y = 0, size = 0;
};

/// A built-in solid texture of the command line; absent fields are those of its kind.
struct SolidOptions {
  std::optional<shd_solid> kind;  // replaces the model's textures
  float size = 0.5f;              // side of a cell [world units]
  std::optional<uint32_t> octaves;
  std::optional<shd_solid_fade> fade;
  bool turbulence = false, table = false;
};

/// Layers of a Cryptomatte; combine with |.
enum MatteLayer : uint32_t { kMatteNone = 0, kMatteObject = 1, kMatteMaterial = 2 };

/// The command line, checked.
struct Options {
  std::string model;  // empty = `shape`; "-" and "EXT:-" = standard input
  shd_shape shape = SHD_SHAPE_TEAPOT;
  bool has_shape = false;   // `shape` was given
  bool cycle = false;       // three triangles that overlap cyclically, instead of `shape`
  VolumeOptions volume;     // instead of a model
  std::string output;       // empty = out.png, or with `hash` no file; "-" and "EXT:-" = standard output
  std::string compression;  // compression of the file; empty = that of the format
  uint32_t width = 960, height = 640, samples = 4, supersampling = 1;
  bool sample_shading = false;  // every sample at its own position
  shd_visibility visibility = SHD_VISIBILITY_DEPTH;
  std::vector<Shot> shots;     // a picture each; one after the command line is read
  float fov = 35.0f;           // vertical [deg]
  uint32_t turntable = 0;      // pictures once around; 0 = one picture
  std::string animation;       // number or name of one of the file; empty = the pose of the file
  std::optional<double> time;  // place in the animation [s]; absent = its first key
  uint32_t frames = 0;         // pictures from the first to the last key; 0 = one picture
  shd_filter filter = SHD_FILTER_TRILINEAR;
  shd_magnification magnification = SHD_MAGNIFICATION_DEFAULT;
  bool any_folder = false;  // names of the model may leave its folder
  bool has_filter = false;  // `filter` or `magnification` was given, and both replace those of the file
  bool affine = false;      // attributes are linear on the screen
  float lod_bias = 0.0f;
  Show show = Show::kNone;
  uint32_t show_step = 0;                // distance of what is drawn over a picture [pixels]; 0 = 32
  Term term = Term::kAll;                // the term that is drawn; no option sets it
  ZoomOption zoom;                       // applied to the finished picture
  std::string compare;                   // settings side by side; empty = one picture
  bool difference = false;               // also the difference of the settings
  std::optional<shd_model> reflectance;  // absent = chosen by the model's materials
  shd_frequency frequency = SHD_FREQUENCY_PHONG;
  std::vector<LightOption> lights;
  std::optional<LightPreset> preset;                            // absent = studio, or none if lights are given
  std::optional<std::array<float, 3>> ambient;                  // absent = 0.15, or 0 with an environment
  std::string environment;                                      // image of all directions; empty = none
  shd_projection environment_projection = SHD_PROJECTION_NONE;  // projection of the image; none = lat-long
  float environment_turn = 0.0f;                                // about +Y [deg]
  float environment_blur = 0.0f;                                // roughness of the background
  float exposure = 1.0f;                                        // factor on all lights
  float inner_cone = 15.0f, cone = 25.0f;                       // spots: half angles [deg]
  std::string cookie;                                           // projected by spots; "window" = built in
  uint32_t lamps = 0;                                           // small coloured lights around the model
  std::optional<shd_shadow_filter> shadows;
  float softness = 0.05f;             // size of light sources [radii of the model]
  uint32_t shadow_size = 1024;        // texels per side of each map
  std::optional<uint32_t> occlusion;  // rays of a vertex; absent = no ambient occlusion
  float occlusion_radius = 0.0f;      // [radii of the model]; 0 = unlimited
  bool floor = false;
  std::optional<float> exponent, specular, metallic, roughness;
  std::optional<std::array<float, 3>> diffuse;
  std::string texture;  // replaces the model's textures; "checker" = built in
  SolidOptions solid;
  std::optional<Table> table;  // drawn in place of the model
  std::string normal_map, height_map;
  KeepRoughness keep = KeepRoughness::kNone;
  shd_bump bump_form = SHD_BUMP_NONE;
  float bump_scale = 1.0f, parallax = 0.0f;       // [world units]
  float displacement = 0.0f, edge_length = 4.0f;  // [world units]; edges of displaced triangles [pixels]
  Uv uv = Uv::kMesh;
  float uv_scale = 1.0f;                    // factor for all textures
  float line_width = 0.0f, crease = 60.0f;  // drawn edges [pixels], 0 = none; crease angle [deg]
  float wire_width = 0.0f;                  // edges of all triangles instead of surfaces [pixels], 0 = surfaces
  int tessellation = 16;
  bool color = true;
  std::string display = "sRGB", view = "ACES 1.0 SDR-video";
  std::array<float, 4> background = {0, 0, 0, 0};  // linear, straight alpha
  bool has_background = false;                     // `background` was given
  uint32_t aovs = SHD_AOV_NONE;
  uint32_t mattes = kMatteNone;
  bool dither = false;
  uint32_t threads = 0;
  shd_simd simd = SHD_SIMD_BEST;
  bool progress = false, stats = false, hash = false;
};

/// Whether a table of the texture is drawn.
inline bool shows_texture(const Options& options) {
  return options.table && *options.table != Table::kShadowMap;
}

/// Whether a picture shows values instead of light.
bool shows_data(Show show);

/// Whether the terms of a model add up to its light.
bool has_terms(shd_model model);

/// Whether a picture is made of its frames by the program, so that it has no planes of its own.
bool is_composed(const Options& options);

/// Reads the command line to the options of each picture side by side: of the settings of `--compare`, or one. Returns
/// false after it has printed a page such as --help. Throws Failure (kExitUsage) that names the option and its valid
/// values.
bool read_options(int argc, const char* const* argv, std::vector<Options>& settings);
