// SPDX-License-Identifier: MIT
#pragma once

#include <OpenImageIO/texture.h>

#include <cstdint>
#include <string>
#include <vector>

#include "peers.h"

namespace shd::bench {

constexpr uint32_t kFileTile = 64;  // texels on an edge of a tile, as maketx makes them

/// A tiled file with mip levels in the temporary folder, made by OpenImageIO as maketx makes it, compressed by zip.
/// Texels are RGBA8; an "exr" file has halves. Failures throw std::runtime_error.
class TiledFile {
 public:
  TiledFile(const std::string& extension, uint32_t edge, const std::vector<uint8_t>& texels);
  ~TiledFile();
  TiledFile(const TiledFile&) = delete;
  TiledFile& operator=(const TiledFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// A TextureSystem with nothing in memory but one open file. Failures throw std::runtime_error.
class ColdOpenImageIO {
 public:
  ColdOpenImageIO(const std::string& path, double budget_mb);
  ~ColdOpenImageIO();
  ColdOpenImageIO(const ColdOpenImageIO&) = delete;
  ColdOpenImageIO& operator=(const ColdOpenImageIO&) = delete;
  /// The lookups one by one into four channels.
  void run(const Lookups& lookups, PeerFilter filter, std::vector<float>* rgba);
  /// Texels that were read from the file [MiB], decoded.
  double megabytes() const;

 private:
  OIIO::TextureSystem* system_;
  OIIO::TextureSystem::Perthread* thread_;
  OIIO::TextureSystem::TextureHandle* handle_;
};

}  // namespace shd::bench
