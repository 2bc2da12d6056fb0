// SPDX-License-Identifier: MIT
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/texture.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "peers.h"

namespace shd::bench {
namespace {

constexpr int kAnisotropy = 16;

OIIO::Tex::MipMode mip_mode(PeerFilter filter) {
  switch (filter) {
    case PeerFilter::kNearestMip:
    case PeerFilter::kBilinearMip: return OIIO::Tex::MipMode::OneLevel;
    case PeerFilter::kTrilinear: return OIIO::Tex::MipMode::Trilinear;
    case PeerFilter::kAnisotropic16: return OIIO::Tex::MipMode::Aniso;
    default: return OIIO::Tex::MipMode::NoMIP;
  }
}

OIIO::Tex::InterpMode interp_mode(PeerFilter filter) {
  const bool nearest = filter == PeerFilter::kNearest || filter == PeerFilter::kNearestMip;
  return nearest ? OIIO::Tex::InterpMode::Closest : OIIO::Tex::InterpMode::Bilinear;
}

/// A tiled and mipmapped file that TextureSystem holds in memory, with a cached handle.
class TextureFile {
 public:
  TextureFile(uint32_t edge, const std::vector<uint8_t>& texels) {
    path_ = "/tmp/shd-bench-" + std::to_string(getpid()) + "-" + std::to_string(edge) + ".tx";
    if (!(has_levels(edge, texels) ? write_levels(edge, texels) : make_levels(edge, texels))) {
      std::fprintf(stderr, "OpenImageIO: %s\n", OIIO::geterror().c_str());
      std::exit(1);
    }
    system = OIIO::TextureSystem::create(false);
    system->attribute("max_memory_MB", 1024.0f);
    thread = system->get_perthread_info();
    handle = system->get_texture_handle(OIIO::ustring(path_), thread);
  }
  ~TextureFile() {
    OIIO::TextureSystem::destroy(system, true);
    std::remove(path_.c_str());
  }
  TextureFile(const TextureFile&) = delete;
  TextureFile& operator=(const TextureFile&) = delete;

  OIIO::TextureSystem* system = nullptr;
  OIIO::TextureSystem::Perthread* thread = nullptr;
  OIIO::TextureSystem::TextureHandle* handle = nullptr;

 private:
  bool make_levels(uint32_t edge, const std::vector<uint8_t>& texels) const {
    const int size = static_cast<int>(edge);
    const OIIO::ImageBuf image(OIIO::ImageSpec(size, size, 4, OIIO::TypeDesc::UINT8),
                               const_cast<uint8_t*>(texels.data()));
    OIIO::ImageSpec config;
    config.attribute("maketx:highlightcomp", 0);
    config.attribute("maketx:filtername", "box");
    return OIIO::ImageBufAlgo::make_texture(OIIO::ImageBufAlgo::MakeTxTexture, image, path_, config);
  }

  bool write_levels(uint32_t edge, const std::vector<uint8_t>& texels) const {
    const std::unique_ptr<OIIO::ImageOutput> file = OIIO::ImageOutput::create("tif");
    auto mode = OIIO::ImageOutput::Create;
    size_t offset = 0;
    for (uint32_t size = edge; file && offset < texels.size(); size = std::max(size / 2, 1u)) {
      OIIO::ImageSpec spec(static_cast<int>(size), static_cast<int>(size), 4, OIIO::TypeDesc::UINT8);
      spec.tile_width = spec.tile_height = 64;
      spec.attribute("textureformat", "Plain Texture");
      if (!file->open(path_, spec, mode) || !file->write_image(spec.format, &texels[offset])) return false;
      offset += size_t{size} * size * 4;
      mode = OIIO::ImageOutput::AppendSubimage;  // TIFF with `textureformat`: the next subimage is a mip level
    }
    return file && file->close();
  }

  std::string path_;
};

class SinglePass final : public Peer {
 public:
  SinglePass(const Lookups& lookups, uint32_t edge, const std::vector<uint8_t>& texels, PeerFilter filter)
      : lookups_(lookups), file_(edge, texels), out_(lookups.count() * 4) {
    options_.swrap = options_.twrap = OIIO::TextureOpt::WrapPeriodic;
    options_.interpmode = static_cast<OIIO::TextureOpt::InterpMode>(interp_mode(filter));
    options_.mipmode = static_cast<OIIO::TextureOpt::MipMode>(mip_mode(filter));
    options_.anisotropic = kAnisotropy;
  }
  void run() override {
    const Lookups& q = lookups_;
    for (size_t i = 0; i < q.count(); ++i) {
      file_.system->texture(file_.handle, file_.thread, options_, q.u[i], q.v[i], q.dudx[i], q.dvdx[i], q.dudy[i],
                            q.dvdy[i], 4, &out_[4 * i]);
    }
  }
  std::vector<float> image() override { return out_; }

 private:
  const Lookups& lookups_;
  TextureFile file_;
  std::vector<float> out_;
  OIIO::TextureOpt options_;
};

/// Makes kWidth lookups per call. The results of a call are kWidth reds, then kWidth greens, and so on.
class BatchPass final : public Peer {
 public:
  BatchPass(const Lookups& lookups, uint32_t edge, const std::vector<uint8_t>& texels, PeerFilter filter)
      : lookups_(lookups), file_(edge, texels), out_(lookups.count() * 4) {
    for (size_t i = 0; i < kWidth; ++i) {
      options_.sblur[i] = options_.tblur[i] = options_.rblur[i] = 0.0f;
      options_.swidth[i] = options_.twidth[i] = options_.rwidth[i] = 1.0f;
    }
    options_.swrap = options_.twrap = OIIO::Tex::Wrap::Periodic;
    options_.interpmode = interp_mode(filter);
    options_.mipmode = mip_mode(filter);
    options_.anisotropic = kAnisotropy;
  }
  void run() override {
    const Lookups& q = lookups_;
    for (size_t i = 0; i < q.count(); i += kWidth) {
      file_.system->texture(file_.handle, file_.thread, options_, OIIO::Tex::RunMaskOn, &q.u[i], &q.v[i], &q.dudx[i],
                            &q.dvdx[i], &q.dudy[i], &q.dvdy[i], 4, &out_[4 * i]);
    }
  }
  std::vector<float> image() override {
    std::vector<float> rgba(out_.size());
    for (size_t i = 0; i < lookups_.count(); ++i) {
      const size_t lane = i % kWidth;
      for (size_t c = 0; c < 4; ++c) rgba[4 * i + c] = out_[4 * (i - lane) + c * kWidth + lane];
    }
    return rgba;
  }

 private:
  static constexpr size_t kWidth = OIIO::Tex::BatchWidth;
  static_assert(kFrameEdge % kWidth == 0, "batches fill the rows of a frame");

  const Lookups& lookups_;
  TextureFile file_;
  std::vector<float> out_;
  OIIO::TextureOptBatch options_;
};

}  // namespace

std::string openimageio_description() {
  return OIIO_VERSION_STRING;
}

std::unique_ptr<Peer> make_openimageio(const Lookups& lookups, uint32_t edge, const std::vector<uint8_t>& texels,
                                       PeerFilter filter) {
  return std::make_unique<SinglePass>(lookups, edge, texels, filter);
}

std::unique_ptr<Peer> make_openimageio_batch(const Lookups& lookups, uint32_t edge, const std::vector<uint8_t>& texels,
                                             PeerFilter filter) {
  return std::make_unique<BatchPass>(lookups, edge, texels, filter);
}

std::vector<uint8_t> load_rgba8(const std::string& path, uint32_t edge) {
  OIIO::ImageBuf file(path);
  if (!file.read(0, 0, true, OIIO::TypeDesc::FLOAT)) return {};
  const int size = static_cast<int>(edge);
  const float opaque[] = {0.0f, 0.0f, 0.0f, 1.0f};
  const int order[] = {0, 1, 2, -1};
  const OIIO::ImageBuf rgba = OIIO::ImageBufAlgo::channels(
      OIIO::ImageBufAlgo::resize(file, "", 0.0f, OIIO::ROI(0, size, 0, size)), 4, order, opaque);
  std::vector<uint8_t> texels(size_t{edge} * edge * 4);
  if (!rgba.get_pixels(OIIO::ROI(0, size, 0, size, 0, 1, 0, 4), OIIO::TypeDesc::UINT8, texels.data())) return {};
  return texels;
}

}  // namespace shd::bench
