// SPDX-License-Identifier: MIT
#include "tool/maketx/pyramid.h"

#include <OpenImageIO/parallel.h>

namespace {

using namespace shd::texture;

template <class Stream>
class PyramidOf : public Pyramid {
 public:
  PyramidOf(uint32_t width, uint32_t height) : stream_(width, height) {}
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
  std::unique_ptr<Pyramid> pyramid;
  visit_codec(component, channels, [&](auto codec) {
    using Codec = decltype(codec);
    if constexpr (Codec::kChannels >= 3) {
      if (normal) {
        pyramid = std::make_unique<PyramidOf<NormalStream<Codec>>>(width, height);
        return;
      }
    }
    pyramid = std::make_unique<PyramidOf<MipStream<Codec>>>(width, height);
  });
  return pyramid;
}

uint64_t pyramid_bytes(size_t channels, bool normal, uint32_t width, uint32_t height) {
  const uint64_t row = uint64_t{width} * channels * sizeof(double);
  return normal ? row * (full_level_count(width, height) - 1) : 2 * row;
}
