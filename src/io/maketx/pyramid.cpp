// SPDX-License-Identifier: MIT
#include "io/maketx/pyramid.h"

#include <OpenImageIO/parallel.h>

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

}  // namespace

std::unique_ptr<Pyramid> make_pyramid(shd::image::Component component, size_t channels, bool normal, uint32_t width,
                                      uint32_t height) {
  const TexelCodec& codec = codec_of(component, channels);
  if (normal) return std::make_unique<PyramidOf<NormalStream>>(codec, width, height);
  return std::make_unique<PyramidOf<MipStream>>(codec, width, height);
}

uint64_t pyramid_bytes(size_t channels, bool normal, uint32_t width, uint32_t height) {
  const uint64_t row = uint64_t{width} * channels * sizeof(double);
  return normal ? row * (full_level_count(width, height) - 1) : 2 * row;
}
