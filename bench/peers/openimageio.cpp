// SPDX-License-Identifier: MIT
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/texture.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "peers.h"

namespace shd::bench {
namespace {

/// Lookups through TextureSystem with a cached handle, from a tiled and mipmapped file that it holds in memory.
class TextureSystemPass final : public Peer {
 public:
  TextureSystemPass(const Lookups& lookups, uint32_t edge, const std::vector<uint8_t>& texels, shd_filter filter)
      : lookups_(lookups), out_(kLookupCount * 4) {
    path_ = "/tmp/shd-bench-" + std::to_string(getpid()) + "-" + std::to_string(edge) + ".tx";
    const int size = static_cast<int>(edge);
    const OIIO::ImageBuf image(OIIO::ImageSpec(size, size, 4, OIIO::TypeDesc::UINT8),
                               const_cast<uint8_t*>(texels.data()));
    OIIO::ImageSpec config;
    config.attribute("maketx:highlightcomp", 0);
    config.attribute("maketx:filtername", "box");
    if (!OIIO::ImageBufAlgo::make_texture(OIIO::ImageBufAlgo::MakeTxTexture, image, path_, config)) {
      std::fprintf(stderr, "OpenImageIO: %s\n", OIIO::geterror().c_str());
      std::exit(1);
    }
    system_ = OIIO::TextureSystem::create(false);
    system_->attribute("max_memory_MB", 1024.0f);
    thread_ = system_->get_perthread_info();
    handle_ = system_->get_texture_handle(OIIO::ustring(path_), thread_);
    options_.swrap = options_.twrap = OIIO::TextureOpt::WrapPeriodic;
    options_.interpmode =
        filter == SHD_FILTER_NEAREST ? OIIO::TextureOpt::InterpClosest : OIIO::TextureOpt::InterpBilinear;
    options_.mipmode =
        filter == SHD_FILTER_TRILINEAR ? OIIO::TextureOpt::MipModeTrilinear : OIIO::TextureOpt::MipModeNoMIP;
  }
  ~TextureSystemPass() override {
    OIIO::TextureSystem::destroy(system_, true);
    std::remove(path_.c_str());
  }
  TextureSystemPass(const TextureSystemPass&) = delete;
  TextureSystemPass& operator=(const TextureSystemPass&) = delete;

  void run() override {
    const Lookups& q = lookups_;
    for (size_t i = 0; i < kLookupCount; ++i) {
      system_->texture(handle_, thread_, options_, q.u[i], q.v[i], q.dudx[i], q.dvdx[i], q.dudy[i], q.dvdy[i], 4,
                       &out_[4 * i]);
    }
  }
  std::vector<float> image() override { return out_; }

 private:
  const Lookups& lookups_;
  std::vector<float> out_;
  std::string path_;
  OIIO::TextureSystem* system_ = nullptr;
  OIIO::TextureSystem::Perthread* thread_ = nullptr;
  OIIO::TextureSystem::TextureHandle* handle_ = nullptr;
  OIIO::TextureOpt options_;
};

}  // namespace

std::string openimageio_description() {
  return OIIO_VERSION_STRING;
}

std::unique_ptr<Peer> make_openimageio(const Lookups& lookups, uint32_t edge, const std::vector<uint8_t>& texels,
                                       shd_filter filter) {
  return std::make_unique<TextureSystemPass>(lookups, edge, texels, filter);
}

}  // namespace shd::bench
