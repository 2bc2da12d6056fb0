// SPDX-License-Identifier: MIT
#include "io/maketx/probe.h"

#include <cstring>

#include <shd/projection.h>

#include "command/failure.h"
#include "io/file/printable.h"
#include "io/maketx/whole.h"

namespace {

class Probe : public Rows {
 public:
  Probe(const Options& options, Rows& probe) : image_(probe.image()) {
    const uint32_t side = image_.width;
    if (side != image_.height || side < 2) {
      throw Failure(kExitInput, "\"" + shd::io::printable(options.input) + "\": " + std::to_string(side) + " x " +
                                    std::to_string(image_.height) +
                                    " pixels, but a --lightprobe is a square of 2 x 2 "
                                    "or more");
    }
    const uint64_t row = image_.row_size();
    require_memory(options, "--lightprobe", row * side * 3 / 2 + uint64_t{16} * side * side);
    std::vector<uint8_t> pixels(row * side);
    probe.read(side, pixels.data());
    image_.height = side / 2;
    pixels_.resize(row * image_.height);
    convert(options, side, pixels);
  }
  const Image& image() const override { return image_; }
  uint32_t step() const override { return 0; }
  void read(uint32_t count, uint8_t* out) override {
    const size_t row = image_.row_size();
    std::memcpy(out, pixels_.data() + next_ * row, count * row);
    next_ += count;
  }

 private:
  void convert(const Options& options, uint32_t side, std::vector<uint8_t>& pixels) {
    const Context context(options);
    shd_image probe = shd_image_default(), sphere = shd_image_default();
    probe.format = sphere.format = format_of(image_);
    probe.width = probe.height = sphere.width = side;
    sphere.height = image_.height;
    probe.pixels = pixels.data();
    sphere.pixels = pixels_.data();
    shd_direction_images from = shd_direction_images_default(), to = shd_direction_images_default();
    from.projection = SHD_PROJECTION_ANGULAR;
    to.projection = SHD_PROJECTION_LAT_LONG;
    from.images = &probe;
    to.images = &sphere;
    check(shd_projection_convert(context.handle, &from, &to), "--lightprobe");
  }

  Image image_;
  std::vector<uint8_t> pixels_;
  size_t next_ = 0;
};

}  // namespace

std::unique_ptr<Rows> make_probe(const Options& options, Rows& probe) {
  return std::make_unique<Probe>(options, probe);
}
