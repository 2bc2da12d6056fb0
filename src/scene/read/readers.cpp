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
    {[](const Source&) { return true; }, read_by_assimp},
};

}  // namespace

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
