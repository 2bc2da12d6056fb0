// SPDX-License-Identifier: MIT
#include "state.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <initializer_list>

namespace viewer {

const Choices<14> kFilters = {{{"nearest", "Nearest", SHD_FILTER_NEAREST},
                               {"bilinear", "Bilinear", SHD_FILTER_BILINEAR},
                               {"bicubic", "Bicubic", SHD_FILTER_BICUBIC},
                               {"hermite", "Hermite", SHD_FILTER_HERMITE},
                               {"nearest-mip", "Nearest, nearest level", SHD_FILTER_NEAREST_MIP},
                               {"nearest-mip-linear", "Nearest, two levels", SHD_FILTER_NEAREST_MIP_LINEAR},
                               {"bilinear-mip", "Bilinear, nearest level", SHD_FILTER_BILINEAR_MIP},
                               {"trilinear", "Trilinear", SHD_FILTER_TRILINEAR},
                               {"ripmap", "Ripmap", SHD_FILTER_RIPMAP},
                               {"summed-area", "Summed-area table", SHD_FILTER_SUMMED_AREA},
                               {"anisotropic", "Anisotropic", SHD_FILTER_ANISOTROPIC},
                               {"ewa", "EWA", SHD_FILTER_EWA},
                               {"stochastic", "Stochastic", SHD_FILTER_STOCHASTIC},
                               {"exact", "Exact (slow)", SHD_FILTER_EXACT}}};

const Choices<5> kProfiles = {{{"least-error", "Least error", SHD_PROFILE_LEAST_ERROR},
                               {"vulkan", "Vulkan", SHD_PROFILE_VULKAN},
                               {"d3d11", "Direct3D 11", SHD_PROFILE_D3D11},
                               {"oiio", "OpenImageIO", SHD_PROFILE_OIIO},
                               {"exact", "Exact levels", SHD_PROFILE_EXACT}}};

const Choices<2> kPrecisions = {{{"full", "Full", SHD_PRECISION_FULL}, {"fast", "Fast", SHD_PRECISION_FAST}}};

const Choices<10> kModels = {{{"metallic-roughness", "Metallic-roughness", SHD_MODEL_METALLIC_ROUGHNESS},
                              {"blinn-phong", "Blinn-Phong", SHD_MODEL_BLINN_PHONG},
                              {"blinn-phong-normalized", "Blinn-Phong, normalised", SHD_MODEL_BLINN_PHONG_NORMALIZED},
                              {"phong", "Phong", SHD_MODEL_PHONG},
                              {"combined", "Combined", SHD_MODEL_COMBINED},
                              {"lambert", "Lambert", SHD_MODEL_LAMBERT},
                              {"gooch", "Gooch", SHD_MODEL_GOOCH},
                              {"toon", "Toon", SHD_MODEL_TOON},
                              {"glass", "Glass", SHD_MODEL_GLASS},
                              {"unlit", "Unlit", SHD_MODEL_UNLIT}}};

const Choices<7> kShows = {{{"model", "Shaded", int(Show::kModel)},
                            {"normals", "Normals", int(Show::kNormals)},
                            {"uv", "Texture coordinates", int(Show::kUv)},
                            {"level", "Level of detail", int(Show::kLevel)},
                            {"barycentrics", "Barycentrics", int(Show::kBarycentrics)},
                            {"overdraw", "Overdraw", int(Show::kOverdraw)},
                            {"depth", "Depth", int(Show::kDepth)}}};

const Choices<5> kShapes = {{{"teapot", "Teapot", SHD_SHAPE_TEAPOT},
                             {"sphere", "Sphere", SHD_SHAPE_SPHERE},
                             {"box", "Box", SHD_SHAPE_BOX},
                             {"torus", "Torus", SHD_SHAPE_TORUS},
                             {"plane", "Plane", SHD_SHAPE_PLANE}}};

bool same_pixels(const State& a, const State& b) {
  return a.content == b.content && a.lighting == b.lighting && a.display == b.display && a.orbit == b.orbit &&
         a.side[0] == b.side[0] && a.wipe == b.wipe && (!a.wipe || a.side[1] == b.side[1]) && a.width == b.width &&
         a.height == b.height;
}

uint32_t divider_column(const State& state) {
  if (!state.wipe) return state.width;
  const float part = std::clamp(state.divider, 0.0f, 1.0f);
  return static_cast<uint32_t>(std::lround(part * static_cast<float>(state.width)));
}

int side_at(const State& state, uint32_t x) {
  return x < divider_column(state) ? 0 : 1;
}

shd_table_flags tables_of(shd_filter filter) {
  if (filter == SHD_FILTER_RIPMAP) return SHD_TABLE_MIPMAP | SHD_TABLE_RIPMAP;
  if (filter == SHD_FILTER_SUMMED_AREA) return SHD_TABLE_MIPMAP | SHD_TABLE_SUMMED_AREA;
  return SHD_TABLE_MIPMAP;
}

shd_table_flags tables_of(const State& state) {
  const shd_table_flags a = tables_of(state.side[0].sampling.filter);
  return state.wipe ? a | tables_of(state.side[1].sampling.filter) : a;
}

FileKind kind_of_file(const std::string& path) {
  std::string end = path.substr(std::min(path.rfind('.'), path.size()));
  for (char& c : end) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const auto is_one_of = [&](std::initializer_list<const char*> ends) {
    return std::find(ends.begin(), ends.end(), end) != ends.end();
  };
  if (is_one_of({".hdr", ".exr"})) return FileKind::kEnvironment;
  if (is_one_of({".png", ".jpg", ".jpeg", ".tif", ".tiff", ".tga", ".bmp", ".webp", ".gif"})) return FileKind::kTexture;
  if (is_one_of({".glb", ".gltf", ".obj", ".ply", ".stl", ".fbx", ".dae", ".3ds", ".blend", ".x", ".off"})) {
    return FileKind::kModel;
  }
  return FileKind::kOther;
}

void open_file(State& state, const std::string& path) {
  const FileKind kind = kind_of_file(path);
  state.pick.reset();
  if (kind == FileKind::kEnvironment) {
    state.lighting.environment = path;
  } else if (kind == FileKind::kTexture) {
    state.content.texture = path;
  } else {
    state.content.model = path;
    state.content.texture = "default";
    state.orbit.shift = {0, 0, 0};
    state.orbit.distance = 0.0f;
  }
}

Side other_side(const Side& side) {
  Side other = side;
  const bool is_trilinear = side.sampling.filter == SHD_FILTER_TRILINEAR;
  other.sampling.filter = is_trilinear ? SHD_FILTER_ANISOTROPIC : SHD_FILTER_TRILINEAR;
  return other;
}

std::optional<shd_shape> shape_of(const std::string& model) {
  for (const Choice& choice : kShapes) {
    if (model == choice.word) return static_cast<shd_shape>(choice.value);
  }
  return std::nullopt;
}

}  // namespace viewer
