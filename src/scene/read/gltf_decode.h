// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "scene/read/files.h"

/// Decoders of compressed geometry, which are optional. Their results are as long as asked; all throw Failure
/// (SHD_ERROR_CORRUPT) for damaged data, and refuse sizes that the data cannot have before they take memory.
namespace shd::scene::gltf {

#if defined(SHD_HAS_DRACO)
constexpr bool kHasDraco = true;
#else
constexpr bool kHasDraco = false;
#endif
#if defined(SHD_HAS_MESHOPT)
constexpr bool kHasMeshopt = true;
#else
constexpr bool kHasMeshopt = false;
#endif

/// An attribute of a Draco mesh, in the component type that glTF's accessor gives.
struct DracoColumn {
  uint32_t id;              // unique id of the attribute
  uint32_t component_type;  // number in glTF
  uint32_t components;
  std::vector<unsigned char> bytes;  // [point][component]
};

/// Decodes a mesh of `face_count` faces and `point_count` points, and those of its attributes that `columns` name.
std::vector<uint32_t> decode_draco(Bytes bytes, uint64_t face_count, uint64_t point_count,
                                   std::vector<DracoColumn>& columns);

enum class MeshoptMode { kAttributes, kTriangles, kIndices };
enum class MeshoptFilter { kNone, kOctahedral, kQuaternion, kExponential };

/// Decodes `count` elements of `stride` bytes (EXT_meshopt_compression) into `out`, which has room for them.
void decode_meshopt(Bytes bytes, MeshoptMode mode, MeshoptFilter filter, size_t count, size_t stride,
                    unsigned char* out);

}  // namespace shd::scene::gltf
