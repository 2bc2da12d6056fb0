// SPDX-License-Identifier: MIT
#include "io/maketx/pyramid.h"

#include <OpenImageIO/parallel.h>

#include <cstring>

#include <shd/mip.h>

#include "command/failure.h"
#include "io/maketx/whole.h"

namespace {

using namespace shd::texture;

template <class Stream>
class PyramidOf : public Pyramid {
 public:
  PyramidOf(const TexelCodec& codec, uint32_t width, uint32_t height) : stream_(codec, width, height) {}
  void push(const StreamRows& rows, uint8_t* const* out) override {
    stream_.push(rows, out, [](size_t count, const auto& body) {
      OIIO::parallel_for(int64_t{0}, static_cast<int64_t>(count), [&](int64_t i) { body(static_cast<size_t>(i)); });
    });
  }
  std::vector<double>& state() override { return stream_.state(); }

 private:
  Stream stream_;
};

shd_wrap wrap_of(const std::string& name) {
  return name == "periodic" ? SHD_WRAP_REPEAT
         : name == "mirror" ? SHD_WRAP_MIRROR
         : name == "clamp"  ? SHD_WRAP_CLAMP
                            : SHD_WRAP_BORDER;
}

/// Levels by shd_mip_build(), for filters that are wider than the box.
class Whole : public Pyramid {
 public:
  Whole(const Options& options, const Image& image) : options_(options), image_(image), context_(options) {
    base_.resize(image.row_size() * image.height);
  }
  void push(const StreamRows& rows, uint8_t* const* out) override {
    const size_t row = image_.row_size();
    for (uint32_t y = rows.first; y < rows.end(); ++y) std::memcpy(base_.data() + y * row, rows.row(y), row);
    if (rows.end() == image_.height) build(out);
  }
  std::vector<double>& state() override { return state_; }
  bool is_whole() const override { return true; }

 private:
  void build(uint8_t* const* out) {
    const uint32_t count = full_level_count(image_.width, image_.height);
    std::vector<shd_image> levels(count, shd_image_default());
    for (uint32_t level = 0; level < count; ++level) {
      levels[level].format = format_of(image_);
      levels[level].width = level_size(image_.width, level);
      levels[level].height = level_size(image_.height, level);
      levels[level].pixels = level == 0 ? base_.data() : out[level - 1];
    }
    shd_mip_desc desc = shd_mip_desc_default();
    desc.kernel = options_.kernel;
    desc.content = options_.normal ? SHD_TEXEL_CONTENT_NORMAL : SHD_TEXEL_CONTENT_COLOR;
    desc.wrap_u = wrap_of(options_.wrap_s);
    desc.wrap_v = wrap_of(options_.wrap_t);
    check(shd_mip_build(context_.handle, levels.data(), &desc, count - 1, levels.data() + 1), "--filter");
  }

  const Options& options_;
  const Image& image_;
  const Context context_;
  std::vector<uint8_t> base_;
  std::vector<double> state_;
};

}  // namespace

std::unique_ptr<Pyramid> make_pyramid(const Options& options, const Image& image) {
  if (options.kernel != SHD_MIP_KERNEL_BOX) return std::make_unique<Whole>(options, image);
  const TexelCodec& codec = codec_of(image.component, image.channels);
  if (options.normal) return std::make_unique<PyramidOf<NormalStream>>(codec, image.width, image.height);
  return std::make_unique<PyramidOf<MipStream>>(codec, image.width, image.height);
}

uint64_t pyramid_bytes(const Options& options, const Image& image) {
  if (options.kernel != SHD_MIP_KERNEL_BOX) return image.row_size() * image.height * 4 / 3;
  const uint64_t row = uint64_t{image.width} * image.channels * sizeof(double);
  return options.normal ? row * (full_level_count(image.width, image.height) - 1) : 2 * row;
}
