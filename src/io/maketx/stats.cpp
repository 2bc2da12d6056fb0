// SPDX-License-Identifier: MIT
#include "io/maketx/stats.h"

#include <OpenImageIO/strutil.h>

#include <cmath>
#include <cstring>

#include "command/failure.h"
#include "io/file/printable.h"

namespace {

using shd::image::Component;

constexpr uint32_t kBlock = 256;  // rows; maketexture.cpp of OpenImageIO, sha1_blocksize

/// The codec of stored numbers: without a curve.
const shd::texture::TexelCodec& codec_for(const Image& image) {
  const bool srgb = image.component == Component::kSrgb8;
  return shd::texture::codec_of(srgb ? Component::kUnorm8 : image.component, image.channels);
}

std::string join(const double* numbers, size_t count) {
  const std::vector<float> floats(numbers, numbers + count);
  return OIIO::Strutil::join(floats, ",");
}

}  // namespace

Stats::Stats(const Options& options, const Image& image, std::string extra)
    : options_(options), image_(image), codec_(codec_for(image)), extra_(std::move(extra)) {}

void Stats::add(const uint8_t* rows, uint32_t count) {
  const size_t size = image_.row_size();
  for (uint32_t i = 0; i < count; ++i, ++y_, rows += size) {
    if (y_ > 0 && y_ % kBlock == 0) end_block();
    block_->append(rows, size);
    add_row(rows);
    add_to_constant(rows);
  }
}

void Stats::add_row(const uint8_t* row) {
  size_t x = 0;
  shd::texture::for_runs(codec_, row, image_.width, [&](const double* numbers, size_t count) {
    for (size_t i = 0; i < count * codec_.channels; ++i) {
      const size_t c = i % codec_.channels;
      if (std::isfinite(numbers[i])) {
        sum_[c] += numbers[i];
        ++count_[c];
      } else if (options_.check_nan) {
        throw Failure(kExitInput, "\"" + shd::io::printable(options_.input) + "\": " + image_.names[c] + " of pixel " +
                                      std::to_string(x + i / codec_.channels) + ", " + std::to_string(y_) + " is " +
                                      (std::isnan(numbers[i]) ? "NaN" : "infinite") + " (--checknan)");
      }
    }
    x += count;
  });
}

void Stats::add_to_constant(const uint8_t* row) {
  const size_t pixel = image_.pixel_size();
  if (y_ == 0) first_.assign(row, row + pixel);
  for (uint32_t x = 0; x < image_.width && !first_.empty(); ++x) {
    if (std::memcmp(row + x * pixel, first_.data(), pixel) != 0) first_.clear();
  }
}

void Stats::end_block() {
  digests_ += block_->digest();
  block_ = std::make_unique<OIIO::SHA1>();
}

std::string Stats::hash() {
  if (y_ > kBlock) {
    end_block();
    block_->append(digests_.data(), digests_.size());
  }
  block_->append(extra_.data(), extra_.size());
  return block_->digest();
}

std::string Stats::average() const {
  double mean[4];
  for (size_t c = 0; c < codec_.channels; ++c) {
    mean[c] = count_[c] ? sum_[c] / (static_cast<double>(count_[c]) * codec_.one[c]) : 0;
  }
  return join(mean, codec_.channels);
}

std::string Stats::constant() const {
  if (first_.empty()) return "";
  double numbers[4];
  codec_.load(first_.data(), 1, numbers);
  for (size_t c = 0; c < codec_.channels; ++c) numbers[c] /= codec_.one[c];
  return join(numbers, codec_.channels);
}
