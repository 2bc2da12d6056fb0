// SPDX-License-Identifier: MIT
#include "scene/read/gltf_decode.h"

#include <cstring>
#include <memory>

#include "core/failure.h"

#if defined(SHD_HAS_DRACO)
#include <draco/compression/decode.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>
#endif

namespace shd::scene::gltf {

#if defined(SHD_HAS_DRACO)
namespace {

[[noreturn]] void refuse_draco(const char* reason) {
  core::refuse(SHD_ERROR_CORRUPT, "its Draco data: %s", reason);
}

/// Reads the sizes at the start of a bitstream ("Draco Bitstream Specification", sections 3 to 6), before the decoder
/// takes memory for them. Edgebreaker gives no number of points before it is decoded.
void check_sizes(Bytes bytes, uint64_t face_count, uint64_t point_count) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data), bytes.size);
  char magic[5];
  uint8_t major = 0, minor = 0, kind = 0, method = 0;
  uint16_t flags = 0;
  if (!buffer.Decode(magic, sizeof magic) || !buffer.Decode(&major) || !buffer.Decode(&minor) ||
      !buffer.Decode(&kind) || !buffer.Decode(&method) || !buffer.Decode(&flags)) {
    refuse_draco("it ends too early");
  }
  if (major != 2 || minor < 2 || kind != draco::TRIANGULAR_MESH) refuse_draco("it is not a mesh of version 2.2");
  buffer.set_bitstream_version(DRACO_BITSTREAM_VERSION(major, minor));
  if (flags & METADATA_FLAG_MASK) {
    draco::GeometryMetadata metadata;
    if (!draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &metadata)) refuse_draco("its metadata are damaged");
  }
  uint32_t faces = 0, points = 0;
  uint8_t traversal = 0;
  bool good = true;
  if (method == draco::MESH_SEQUENTIAL_ENCODING) {
    good = draco::DecodeVarint(&faces, &buffer) && draco::DecodeVarint(&points, &buffer);
  } else {
    good = buffer.Decode(&traversal) && draco::DecodeVarint(&points, &buffer) && draco::DecodeVarint(&faces, &buffer);
  }
  if (!good) refuse_draco("it ends too early");
  if (faces > face_count) refuse_draco("it has more triangles than its accessor of indices");
  if (points > point_count) refuse_draco("it has more points than its accessors");
}

template <class Number>
bool copy_points(const draco::Mesh& mesh, const draco::PointAttribute& attribute, DracoColumn& column) {
  const size_t size = sizeof(Number) * column.components;
  column.bytes.resize(size * mesh.num_points());
  Number numbers[4] = {};
  for (draco::PointIndex i(0); i < mesh.num_points(); ++i) {
    const auto components = static_cast<int8_t>(column.components);
    if (!attribute.ConvertValue<Number>(attribute.mapped_index(i), components, numbers)) return false;
    std::memcpy(column.bytes.data() + i.value() * size, numbers, size);
  }
  return true;
}

bool copy_points(const draco::Mesh& mesh, const draco::PointAttribute& attribute, DracoColumn& column) {
  switch (column.component_type) {
    case 5120: return copy_points<int8_t>(mesh, attribute, column);
    case 5121: return copy_points<uint8_t>(mesh, attribute, column);
    case 5122: return copy_points<int16_t>(mesh, attribute, column);
    case 5123: return copy_points<uint16_t>(mesh, attribute, column);
    case 5125: return copy_points<uint32_t>(mesh, attribute, column);
    default: return copy_points<float>(mesh, attribute, column);
  }
}

}  // namespace

std::vector<uint32_t> decode_draco(Bytes bytes, uint64_t face_count, uint64_t point_count,
                                   std::vector<DracoColumn>& columns) {
  check_sizes(bytes, face_count, point_count);
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data), bytes.size);
  auto decoded = draco::Decoder().DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) refuse_draco(decoded.status().error_msg());
  const std::unique_ptr<draco::Mesh> mesh = std::move(decoded).value();
  if (mesh->num_faces() > face_count || mesh->num_points() > point_count)
    refuse_draco("it is larger than its accessors");
  for (DracoColumn& column : columns) {
    const draco::PointAttribute* attribute = mesh->GetAttributeByUniqueId(column.id);
    if (!attribute || column.components > 4 || attribute->num_components() != column.components) {
      refuse_draco("it has no such attribute");
    }
    if (!copy_points(*mesh, *attribute, column)) refuse_draco("an attribute has another type");
  }
  std::vector<uint32_t> indices;
  indices.reserve(size_t{3} * mesh->num_faces());
  for (draco::FaceIndex i(0); i < mesh->num_faces(); ++i) {
    for (const draco::PointIndex& corner : mesh->face(i)) indices.push_back(corner.value());
  }
  return indices;
}
#else
std::vector<uint32_t> decode_draco(Bytes, uint64_t, uint64_t, std::vector<DracoColumn>&) {
  core::refuse(SHD_ERROR_UNSUPPORTED, "this build has no Draco");
}
#endif

}  // namespace shd::scene::gltf
