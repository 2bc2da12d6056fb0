// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <set>
#include <vector>

#include "scene/read/gltf_part.h"
#include "scene/read/read.h"
#include "scene/read/warnings.h"
#include "scene/text.h"

/// glTF 2.0 (Khronos Group, "glTF 2.0 Specification", ISO/IEC 12113), section numbers below are of version 2.0.1.
namespace shd::scene::gltf {

/// A glTF file, and the Model that the readers fill.
struct Document {
  explicit Document(const Source& from) : source(from), root(&json, ""), warnings(model) {}
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  const Source& source;
  Json json;
  Part root;
  Bytes binary;  // chunk BIN of a GLB, or empty
  Model model;
  Warnings warnings;
  std::vector<std::optional<Bytes>> buffers, views;  // read ones have a value
  std::deque<std::vector<unsigned char>> made;       // decoded bytes
  uint64_t made_bytes = 0, vertices = 0, triangles = 0, instances = 0;
};

/// Runs `body`. A fault of the file becomes a warning "<name>: <fault>", and the part is left out.
template <class Body>
bool attempt(Document& document, const std::string& name, Body&& body) {
  try {
    body();
    return true;
  } catch (const core::Failure& failure) {
    const shd_result code = failure.code;
    if (code != SHD_ERROR_CORRUPT && code != SHD_ERROR_UNSUPPORTED && code != SHD_ERROR_NOT_FOUND) throw;
    document.warnings.add(name + ": " + failure.what());
    return false;
  }
}

/// `mesh "a"`, or `mesh "meshes[0]"` of a part without a name.
std::string title_of(const char* kind, const Part& part);
std::string name_of(const Part& part);

// gltf_buffer.cpp

/// Counts bytes that a file makes of fewer ones, before they are made. Throws Failure beyond the budget.
void spend_bytes(Document& document, uint64_t size);

/// Room for decoded bytes, which stays as long as the document.
std::vector<unsigned char>& make_bytes(Document& document, uint64_t size);

/// A file name of a URI reference (RFC 3986), of which the files around the model decide between spellings. Empty for
/// a URI of another scheme.
std::string file_of_uri(Document& document, const std::string& uri);

/// The bytes of a URI "data:" (RFC 2397); no value for another URI.
std::optional<std::vector<unsigned char>> read_data_uri(Document& document, const Part& uri);

/// The bytes of a buffer view, decompressed.
Bytes view_bytes(Document& document, uint32_t view);

// gltf_accessor.cpp

/// Elements of an accessor (section 3.6.2). Without data all numbers are 0.
struct Accessor {
  const unsigned char* data = nullptr;
  size_t count = 0, stride = 0;
  uint32_t components = 1, component_type = 0;
  bool normalized = false;
};

Accessor open_accessor(Document& document, const Part& reference);

/// Rows of an accessor, all if `rows` is null. Normalised integers become -1..1 or 0..1 (section 3.6.2.2).
std::vector<float> read_floats(const Accessor& accessor, const std::vector<uint32_t>* rows = nullptr);
std::vector<uint32_t> read_integers(const Accessor& accessor, const std::vector<uint32_t>* rows = nullptr);

/// Bytes of a component type (section 3.6.2.2); 0 for others.
size_t component_size(uint64_t component_type);
constexpr uint32_t kFloat = 5126;

// The parts of a Model, each in its file.

/// Names of extensions that the reader honours.
bool honours(const std::string& extension);

void add_surfaces(Document& document);
uint32_t default_surface(Document& document);
/// A primitive of a mesh as a geometry of the Model.
struct MeshPart {
  uint32_t geometry = 0, surface = 0;
};
/// The primitives of a mesh that can be drawn.
std::vector<MeshPart> add_mesh(Document& document, uint32_t mesh);
/// Adds all nodes, and the meshes, cameras and lights below the default scene. Returns the Model's node of each node;
/// -1 means none.
std::vector<int32_t> add_nodes(Document& document);
void add_light(Document& document, const Part& light, uint32_t node);
void add_camera(Document& document, const Part& camera, uint32_t node);
void add_animations(Document& document, const std::vector<int32_t>& node_of);

}  // namespace shd::scene::gltf
