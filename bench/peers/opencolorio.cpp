// SPDX-License-Identifier: MIT
#include <OpenColorIO/OpenColorIO.h>

#include <sstream>

#include <shd/color.h>

#include "peers.h"

namespace shd::bench {
namespace {

namespace ocio = OCIO_NAMESPACE;

/// OpenColorIO's processor from packed RGBA floats to packed RGBA8, on the calling thread.
class OpenColorIo final : public Peer {
 public:
  OpenColorIo(const std::vector<float>& rgba, uint32_t edge, const std::string& display, const std::string& view)
      : edge_(edge), rgba_(rgba), out_(rgba.size()) {
    std::istringstream text(shd_color_default_config());
    const auto config = ocio::Config::CreateFromStream(text);
    const auto processor =
        config->getProcessor("scene_linear", display.c_str(), view.c_str(), ocio::TRANSFORM_DIR_FORWARD);
    cpu_ = processor->getOptimizedCPUProcessor(ocio::BIT_DEPTH_F32, ocio::BIT_DEPTH_UINT8, ocio::OPTIMIZATION_DEFAULT);
  }

  void run() override {
    const ocio::PackedImageDesc in(rgba_.data(), edge_, edge_, 4);
    ocio::PackedImageDesc out(out_.data(), edge_, edge_, 4, ocio::BIT_DEPTH_UINT8, 1, 4, 4 * edge_);
    cpu_->apply(in, out);
  }

  std::vector<float> image() override {
    std::vector<float> codes(out_.size());
    for (size_t i = 0; i < codes.size(); ++i) codes[i] = static_cast<float>(out_[i]) / 255.0f;
    return codes;
  }

 private:
  long edge_;
  std::vector<float> rgba_;
  std::vector<uint8_t> out_;
  ocio::ConstCPUProcessorRcPtr cpu_;
};

}  // namespace

std::string opencolorio_description() {
  return std::string("OpenColorIO ") + ocio::GetVersion();
}

std::unique_ptr<Peer> make_opencolorio(const std::vector<float>& rgba, uint32_t edge, const std::string& display,
                                       const std::string& view) {
  return std::make_unique<OpenColorIo>(rgba, edge, display, view);
}

}  // namespace shd::bench
