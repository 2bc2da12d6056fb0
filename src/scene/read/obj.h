// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "scene/read/read.h"
#include "scene/read/warnings.h"

/// Declarations that the obj*.cpp files share. The format: Wavefront, "Advanced Visualizer", appendix B1 (OBJ) and
/// the MTL specification (1995), with the vertex colours and PBR statements that later programs write.
///
/// tinyobjloader 2.0 rc10 was tried. It refuses a whole file for a comment after a face, a continued line and a face of
/// the index 0. It cuts names of materials at blanks, and loses a texture after `-s 2`.
namespace shd::scene {

constexpr int32_t kNone = -1;

/// Rows of the file's tables, or kNone.
struct ObjCorner {
  int32_t position = kNone, uv = kNone, normal = kNone;
};

/// Smoothing groups of faces.
constexpr uint32_t kNoGroup = 0;        // `s off`: the normal of the face
constexpr uint32_t kNoStatement = ~0u;  // no `s` before it: smooth

struct ObjFace {
  size_t first = 0;  // row of ObjFile::corners
  uint32_t count = 0;
  uint32_t part = 0;   // ObjFile::parts
  uint32_t group = 0;  // smoothing group
};

/// The faces of one material in one object or group.
struct ObjPart {
  std::string name;
  int32_t material = kNone;  // row of ObjFile::material_names
};

/// The statements of an OBJ file.
struct ObjFile {
  std::vector<double> positions;   // [position][3]
  std::vector<float> colors;       // [position][3] as in the file, NaN for none, or empty
  std::vector<float> uvs;          // [uv][2], v up
  std::vector<float> normals;      // [normal][3]
  std::vector<ObjCorner> corners;  // corners of all faces
  std::vector<ObjFace> faces;
  std::vector<ObjPart> parts;
  std::vector<std::string> material_names;  // names of usemtl
  std::vector<std::string> libraries;       // the rests of the mtllib statements
};

/// Reads the statements. Faces with corners that do not exist are left out.
ObjFile parse_obj(const Source& source, const std::string& text, Warnings& warnings);

/// Reads all material libraries and appends their materials to the model, those with these names first. Returns a
/// surface for each name, kNone if there is no such material.
std::vector<int32_t> add_mtl_surfaces(const Source& source, const std::vector<std::string>& libraries,
                                      const std::vector<std::string>& names, Model& model, Warnings& warnings);

}  // namespace shd::scene
