// SPDX-License-Identifier: MIT
#include "scene/read/check_model.h"
#include "scene/read/read.h"

namespace shd::scene {
namespace {

/// A reader, and whether a file is of its format. The last row takes everything.
struct Reader {
  bool (*takes)(const Source& source);
  Model (*read)(const Source& source);
};

constexpr Reader kReaders[] = {
    {is_gltf, read_gltf},
    {is_obj, read_obj},
    {is_ply, read_ply},
    {is_stl, read_stl},
#if defined(SHD_HAS_ASSIMP)
    {[](const Source&) { return true; }, read_by_assimp},
#else
    {[](const Source&) { return true; }, refuse_format},
#endif
};

}  // namespace

Model refuse_format(const Source&) {
  core::refuse(SHD_ERROR_UNSUPPORTED,
               "the content is not glTF 2.0, OBJ, PLY or STL, which this build reads: it has no assimp");
}

Model read_model(const Source& source) {
  for (const Reader& reader : kReaders) {
    if (!reader.takes(source)) continue;
    Model model = reader.read(source);
    check_model(model, source.limits);
    return model;
  }
  core::refuse(SHD_ERROR_UNSUPPORTED, "no reader takes it");
}

}  // namespace shd::scene
