// SPDX-License-Identifier: MIT
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/texture.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "cold.h"

namespace shd::bench {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw std::runtime_error("OpenImageIO: " + what + ": " + OIIO::geterror());
}

/// All of OpenImageIO in this process works on the calling thread, readers of libshd_io included.
void use_one_thread() {
  OIIO::attribute("threads", 1);
  OIIO::attribute("exr_threads", -1);
}

}  // namespace

TiledFile::TiledFile(const std::string& extension, uint32_t edge, const std::vector<uint8_t>& texels)
    : path_(std::filesystem::temp_directory_path() / ("shd-bench-" + std::to_string(getpid()) + "-cold." + extension)) {
  const int size = static_cast<int>(edge);
  const OIIO::ImageBuf image(OIIO::ImageSpec(size, size, 4, OIIO::TypeDesc::UINT8),
                             const_cast<uint8_t*>(texels.data()));
  OIIO::ImageSpec config;
  config.tile_width = config.tile_height = static_cast<int>(kFileTile);
  config.format = extension == "exr" ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::UINT8;
  config.attribute("compression", "zip");
  config.attribute("maketx:highlightcomp", 0);
  config.attribute("maketx:filtername", "box");
  if (!OIIO::ImageBufAlgo::make_texture(OIIO::ImageBufAlgo::MakeTxTexture, image, path_, config)) fail(path_);
  use_one_thread();
}

TiledFile::~TiledFile() {
  std::remove(path_.c_str());
}

ColdOpenImageIO::ColdOpenImageIO(const std::string& path, double budget_mb) {
  system_ = OIIO::TextureSystem::create(false);
  system_->attribute("max_memory_MB", static_cast<float>(budget_mb));
  thread_ = system_->get_perthread_info();
  handle_ = system_->get_texture_handle(OIIO::ustring(path), thread_);
  if (!system_->good(handle_)) fail(system_->geterror());
}

ColdOpenImageIO::~ColdOpenImageIO() {
  OIIO::TextureSystem::destroy(system_, true);
}

void ColdOpenImageIO::run(const Lookups& q, PeerFilter filter, std::vector<float>* rgba) {
  OIIO::TextureOpt options;
  options.swrap = options.twrap = OIIO::TextureOpt::WrapPeriodic;
  options.interpmode = OIIO::TextureOpt::InterpBilinear;
  options.mipmode =
      filter == PeerFilter::kTrilinear ? OIIO::TextureOpt::MipModeTrilinear : OIIO::TextureOpt::MipModeAniso;
  options.anisotropic = 16;
  for (size_t i = 0; i < q.count(); ++i) {
    if (!system_->texture(handle_, thread_, options, q.u[i], q.v[i], q.dudx[i], q.dvdx[i], q.dudy[i], q.dvdy[i], 4,
                          &(*rgba)[4 * i])) {
      fail(system_->geterror());
    }
  }
}

double ColdOpenImageIO::megabytes() const {
  long long bytes = 0;
  system_->getattribute("stat:bytes_read", OIIO::TypeDesc::INT64, &bytes);
  return static_cast<double>(bytes) / (1 << 20);
}

}  // namespace shd::bench
