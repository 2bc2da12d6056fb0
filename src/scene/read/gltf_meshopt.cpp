// SPDX-License-Identifier: MIT
#include "scene/read/gltf_decode.h"

#include "core/failure.h"

#if defined(SHD_HAS_MESHOPT)
#include <meshoptimizer.h>
#endif

namespace shd::scene::gltf {

#if defined(SHD_HAS_MESHOPT)
namespace {

/// The strides that the extension allows; the decoders assert them.
bool fits(MeshoptMode mode, MeshoptFilter filter, size_t count, size_t stride) {
  const bool index = stride == 2 || stride == 4;
  if (mode == MeshoptMode::kTriangles) return filter == MeshoptFilter::kNone && index && count % 3 == 0;
  if (mode == MeshoptMode::kIndices) return filter == MeshoptFilter::kNone && index;
  if (stride == 0 || stride > 256 || stride % 4 != 0) return false;
  if (filter == MeshoptFilter::kOctahedral) return stride == 4 || stride == 8;
  return filter != MeshoptFilter::kQuaternion || stride == 8;
}

}  // namespace

void decode_meshopt(Bytes bytes, MeshoptMode mode, MeshoptFilter filter, size_t count, size_t stride,
                    unsigned char* out) {
  if (!fits(mode, filter, count, stride)) {
    core::refuse(SHD_ERROR_CORRUPT, "mode, filter, count %zu and byteStride %zu do not fit together", count, stride);
  }
  if (count == 0) return;
  const int result =
      mode == MeshoptMode::kTriangles ? meshopt_decodeIndexBuffer(out, count, stride, bytes.data, bytes.size)
      : mode == MeshoptMode::kIndices ? meshopt_decodeIndexSequence(out, count, stride, bytes.data, bytes.size)
                                      : meshopt_decodeVertexBuffer(out, count, stride, bytes.data, bytes.size);
  // A stream of vertices starts with 0xa0 + the version of its codec.
  if (result != 0 && mode == MeshoptMode::kAttributes && bytes.size > 0 && bytes.data[0] > 0xa0 &&
      bytes.data[0] <= 0xaf) {
    core::refuse(SHD_ERROR_UNSUPPORTED, "this build's meshoptimizer does not read version %d of the vertex codec",
                 bytes.data[0] - 0xa0);
  }
  if (result != 0) core::refuse(SHD_ERROR_CORRUPT, "its compressed bytes are damaged (meshoptimizer: %d)", result);
  if (filter == MeshoptFilter::kOctahedral) meshopt_decodeFilterOct(out, count, stride);
  if (filter == MeshoptFilter::kQuaternion) meshopt_decodeFilterQuat(out, count, stride);
  if (filter == MeshoptFilter::kExponential) meshopt_decodeFilterExp(out, count, stride);
}
#else
void decode_meshopt(Bytes, MeshoptMode, MeshoptFilter, size_t, size_t, unsigned char*) {
  core::refuse(SHD_ERROR_UNSUPPORTED, "this build has no meshoptimizer");
}
#endif

}  // namespace shd::scene::gltf
