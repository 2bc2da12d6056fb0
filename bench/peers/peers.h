// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "../workload.h"

/// Other renderers on the same workload. Their own headers stay in this folder.
namespace shd::bench {

/// Filters of the peers; each peer supports some of them.
enum class PeerFilter { kNone, kNearest, kBilinear, kNearestMip, kBilinearMip, kTrilinear, kAnisotropic16 };

/// One pass over the workload on one thread, finished when run() returns.
class Peer {
 public:
  virtual ~Peer() = default;
  virtual void run() = 0;
  /// Takes over lookups that have changed in their place; their number stays.
  virtual void refresh() {}
  /// The number of times that run() filters each lookup.
  virtual uint32_t copies() const { return 1; }
  /// The latest pass as RGBA floats, one per lookup or pixel, row 0 on top.
  virtual std::vector<float> image() = 0;
};

/// Texels of a peer are level 0 alone, from which the peer makes its own mip levels, or every level down to 1 x 1, one
/// after another.
inline bool has_levels(uint32_t edge, const std::vector<uint8_t>& texels) {
  return texels.size() > size_t{edge} * edge * 4;
}

/// Version and settings, for the context of the results.
std::string llvmpipe_description();
std::string lavapipe_description();
std::string openimageio_description();
std::string opencolorio_description();

/// Mesa llvmpipe: the frame with a GLSL shader of the same reflectance model, into RGBA8 with a 32-bit depth.
std::unique_ptr<Peer> make_llvmpipe_spheres(const Spheres& spheres, const std::vector<uint8_t>& texels);

/// Mesa llvmpipe: a surface over a frame x frame picture, into RGBA8.
std::unique_ptr<Peer> make_llvmpipe_surface(const Surface& surface, uint32_t frame, uint32_t edge,
                                            const std::vector<uint8_t>& texels, PeerFilter filter);

/// Mesa llvmpipe: a square number of lookups, each drawn as 2 x 2 pixels with its point and derivatives from float
/// textures, into RGBA8.
std::unique_ptr<Peer> make_llvmpipe_lookups(const Lookups& lookups, uint32_t edge, const std::vector<uint8_t>& texels,
                                            PeerFilter filter);

/// Why lavapipe does not work on this machine; empty = it works.
std::string lavapipe_problem();
/// Mesa lavapipe: the lookups by textureGrad of a compute shader, into RGBA floats. Failures throw std::runtime_error.
std::unique_ptr<Peer> make_lavapipe(const Lookups& lookups, uint32_t edge, const std::vector<uint8_t>& texels,
                                    PeerFilter filter);

/// OpenImageIO TextureSystem: the lookups one by one, four float channels out.
std::unique_ptr<Peer> make_openimageio(const Lookups& lookups, uint32_t edge, const std::vector<uint8_t>& texels,
                                       PeerFilter filter);
/// The same lookups through the batched calls.
std::unique_ptr<Peer> make_openimageio_batch(const Lookups& lookups, uint32_t edge, const std::vector<uint8_t>& texels,
                                             PeerFilter filter);

/// OpenColorIO: edge x edge RGBA floats through a view of shd's built-in config, to RGBA8.
std::unique_ptr<Peer> make_opencolorio(const std::vector<float>& rgba, uint32_t edge, const std::string& display,
                                       const std::string& view);

/// An image file as RGBA8, resized to edge x edge texels; empty if it cannot be read.
std::vector<uint8_t> load_rgba8(const std::string& path, uint32_t edge);

}  // namespace shd::bench
