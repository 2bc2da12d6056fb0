// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: scene/read, the bytes of a model file to a Model.
///
/// Input:      untrusted bytes, and the files that they name, through Files.
/// Output:     a Model that check_model() accepts. v of texture coordinates grows downwards.
/// Invariants: nothing of this folder opens a file, prints or calls a function of libshd, so that the worker process
///             can run it. The content decides the format. A problem with the whole file is a Failure. Each thing that
///             a file has and the Model has not is a warning that names it, once for each name.
///
/// | file                | contents                                                    |
/// |---------------------|-------------------------------------------------------------|
/// | files.h             | the files that a model names                                |
/// | fields.h            | the fields of a Model, one list for writing and reading     |
/// | stream.h            | these fields as bytes                                       |
/// | module.h            | the readers in a module of their own                        |
/// | readers.cpp         | the table of readers                                        |
/// | warnings.h          | warnings of one reader, each one given once                 |
/// | check_model.h       | indices, sizes and numbers of a Model                       |
/// | gltf.cpp            | glTF 2.0: containers, extensions                            |
/// | gltf_document.h     | a glTF file in memory, and what its readers share           |
/// | gltf_part.h         | values of the JSON text, with their places                  |
/// | gltf_buffer.cpp     | URIs, buffers and buffer views                              |
/// | gltf_accessor.cpp   | accessors, sparse ones too                                  |
/// | gltf_decode.h       | compressed geometry: Draco, meshoptimizer                   |
/// | gltf_mesh.cpp       | primitives of meshes                                        |
/// | gltf_material.cpp   | materials, textures and samplers                            |
/// | gltf_node.cpp       | nodes, skins and instances                                  |
/// | gltf_stage.cpp      | lights, cameras and animations                              |
/// | obj.h               | declarations that the obj*.cpp files share                  |
/// | obj.cpp             | Wavefront OBJ: vertices, normals and surfaces of the faces  |
/// | obj_parse.cpp       | the statements of an OBJ file                               |
/// | obj_mtl.cpp         | MTL: materials of OBJ files                                 |
/// | ply.h               | declarations that the ply*.cpp files share                  |
/// | ply.cpp             | PLY: polygons, strips, colours and textures                 |
/// | ply_file.cpp        | the header and the rows of a PLY file                       |
/// | stl.cpp             | STL, text and binary, with colours of facets                |
/// | text_lines.h        | statements, words and numbers of text files                 |
/// | polygon.h           | polygons to triangles                                       |
/// | positions.h         | positions in doubles to floats around an origin             |
/// | join.h              | equal vertices made one                                     |
/// | creases.h           | computed normals, sharp at edges of more than 60 degrees    |
/// | colors.h            | colours of vertices and faces to linear light               |
/// | assimp_import.cpp   | every format without a reader of its own: meshes and nodes  |
/// | assimp_sanitize.cpp | faces and nodes that assimp's own steps can work on         |
/// | assimp_surface.cpp  | materials and the textures that they name                   |
/// | assimp_light.cpp    | lights and cameras                                          |
/// | assimp_files.cpp    | Files as the file system of assimp                          |
/// | assimp_parts.h      | declarations that the assimp_*.cpp files share              |
#pragma once

#include <string>

#include "scene/limits.h"
#include "scene/model.h"
#include "scene/read/files.h"

namespace shd::scene {

/// Input of a reader.
struct Source {
  Bytes bytes;       // the whole model file
  std::string name;  // name of the file, without folders; may be empty
  Files& files;
  const Limits& limits;
  const Deadline& deadline;
};

/// Reads a model of any format. Throws Failure if there is nothing to draw or a budget is exceeded.
Model read_model(const Source& source);

/// The readers. Each is a row of readers.cpp.
bool is_gltf(const Source& source);
Model read_gltf(const Source& source);
bool is_obj(const Source& source);
Model read_obj(const Source& source);
bool is_ply(const Source& source);
Model read_ply(const Source& source);
bool is_stl(const Source& source);
Model read_stl(const Source& source);
Model read_by_assimp(const Source& source);

/// The last row of a build without assimp: throws the Failure that names the formats which this build reads.
Model refuse_format(const Source& source);

}  // namespace shd::scene
