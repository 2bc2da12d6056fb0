// SPDX-License-Identifier: MIT
#include "io/maketx/convert.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "command/failure.h"
#include "io/file/printable.h"
#include "io/maketx/bar.h"
#include "io/maketx/part.h"
#include "io/maketx/pyramid.h"
#include "io/maketx/source.h"
#include "io/maketx/target.h"

namespace {

using shd::texture::completed_rows;
using shd::texture::level_size;

constexpr uint64_t kMaxBand = uint64_t{64} << 20;  // larger bands gain nothing [bytes]

/// Everything that decides the bits of the output, and the input.
std::string key_of(const Options& options, const Image& image) {
  char text[512];
  std::snprintf(text, sizeof text, "1 %u %u %u %d %d %llu %lld %d %d %s %s %d ", image.width, image.height,
                image.channels, static_cast<int>(image.component), image.straight,
                static_cast<unsigned long long>(image.file_bytes), static_cast<long long>(image.changed), options.tile,
                options.normal, options.compression.c_str(), options.wrap.c_str(), image.alpha);
  return text + options.input;
}

/// Memory for a band of rows, beside the pyramid: the band, a copy of it in OpenImageIO with compressed tiles, the
/// rows of levels that it completes, and the rows of the decoder.
uint64_t band_bytes(const Image& image, uint32_t rows, uint32_t step) {
  const uint64_t row = image.row_size();
  return row * rows * 3 + row * rows / 2 + 2 * row + row * step;
}

uint32_t choose_band(const Options& options, const Image& image, uint32_t step) {
  const auto tile = static_cast<uint32_t>(options.tile);
  const uint64_t sums = pyramid_bytes(image.channels, options.normal, image.width, image.height);
  const auto needs = [&](uint32_t rows) { return sums + band_bytes(image, std::min(rows, image.height), step); };
  if (needs(tile) > options.memory) {
    throw Failure(kExitUsage, "--memory: rows of " + std::to_string(image.row_size()) + " bytes need " +
                                  std::to_string((needs(tile) >> 20) + 1) + "M, not " +
                                  std::to_string(options.memory >> 20) + "M; or choose a smaller --tile");
  }
  uint32_t rows = tile;
  while (rows < image.height && needs(2 * rows) <= options.memory && 2 * rows * image.row_size() <= kMaxBand) rows *= 2;
  return rows;
}

std::vector<size_t> row_sizes(const Image& image) {
  std::vector<size_t> sizes;
  const uint32_t count = shd::texture::full_level_count(image.width, image.height);
  for (uint32_t level = 1; level < count; ++level) {
    sizes.push_back(level_size(image.width, level) * image.pixel_size());
  }
  return sizes;
}

uint64_t texels_of(const Image& image) {
  uint64_t texels = 0;
  const uint32_t count = shd::texture::full_level_count(image.width, image.height);
  for (uint32_t level = 0; level < count; ++level) {
    texels += uint64_t{level_size(image.width, level)} * level_size(image.height, level);
  }
  return texels;
}

/// One run, from the first band to the complete file.
class Run {
 public:
  Run(const Options& options, Source& source)
      : options_(options),
        source_(source),
        image_(source.image()),
        band_(choose_band(options, image_, source.step())),
        row_sizes_(row_sizes(image_)),
        target_(options, image_),
        part_(options.output, key_of(options, image_), options.force, row_sizes_, image_.height),
        pyramid_(make_pyramid(image_.component, image_.channels, options.normal, image_.width, image_.height)),
        bar_(options.quiet, texels_of(image_), 0) {}

  void run() {
    std::string damaged;
    done_ = saved_ = part_.restore(&pyramid_->state(), &damaged);
    if (!damaged.empty()) {
      std::fprintf(stderr, "shd-maketx: %s of the unfinished run is damaged: begins anew\n", damaged.c_str());
    }
    if (done_ > 0 && !options_.quiet) {
      std::fprintf(stderr, "shd-maketx: continues: levels of %u of %u rows are there\n", done_, image_.height);
    }
    try {
      target_.open(part_.create_file());
      write_base();
      write_levels();
      target_.finish();
    } catch (...) {
      part_.abandon(saved_ > 0);
      throw;
    }
    part_.publish(options_.output);
  }

 private:
  using Clock = std::chrono::steady_clock;

  void show(uint64_t texels, const std::string& what) {
    source_.check_time();
    bar_.show(texels, what);
  }

  void write_base() {
    target_.begin_level(0);
    std::vector<uint8_t> rows(band_ * image_.row_size());
    Clock::time_point saved = Clock::now();
    for (uint32_t y = 0; y < image_.height; y += band_) {
      const uint32_t count = std::min(band_, image_.height - y);
      show(uint64_t{y} * image_.width, "base");
      source_.read(count, rows.data());
      target_.write(y, count, rows.data());
      if (y + count <= done_) continue;
      add({rows.data(), image_.row_size(), y, count});
      const bool last = y + count == image_.height;
      if (!last && std::chrono::duration<double>(Clock::now() - saved).count() < options_.checkpoint) continue;
      part_.save(done_, pyramid_->state());
      saved_ = done_;
      saved = Clock::now();
    }
  }

  /// Adds the rows of a band that no earlier run has added.
  void add(shd::texture::StreamRows rows) {
    const uint32_t skip = done_ > rows.first ? done_ - rows.first : 0;
    rows = {rows.texels + skip * rows.stride, rows.stride, rows.first + skip, rows.count - skip};
    std::vector<std::vector<uint8_t>> finished;
    std::vector<uint8_t*> out;
    const auto count = static_cast<uint32_t>(row_sizes_.size());
    for (uint32_t level = 1; level <= count; ++level) {
      finished.emplace_back(finished_rows(level, rows) * row_sizes_[level - 1]);
      out.push_back(finished.back().data());
    }
    pyramid_->push(rows, out.data());
    for (uint32_t level = 1; level <= count; ++level) {
      const uint32_t first = completed_rows(image_.height, level, rows.first);
      part_.write(level, first, finished_rows(level, rows), out[level - 1]);
    }
    done_ = rows.end();
  }

  uint32_t finished_rows(uint32_t level, const shd::texture::StreamRows& rows) const {
    return completed_rows(image_.height, level, rows.end()) - completed_rows(image_.height, level, rows.first);
  }

  void write_levels() {
    uint64_t texels = uint64_t{image_.width} * image_.height;
    for (uint32_t level = 1; level <= row_sizes_.size(); ++level) {
      target_.begin_level(level);
      const uint32_t height = level_size(image_.height, level), width = level_size(image_.width, level);
      std::vector<uint8_t> rows(std::min(band_, height) * row_sizes_[level - 1]);
      for (uint32_t y = 0; y < height; y += band_) {
        const uint32_t count = std::min(band_, height - y);
        show(texels, "level " + std::to_string(level));
        part_.read(level, y, count, rows.data());
        target_.write(y, count, rows.data());
        texels += uint64_t{count} * width;
      }
    }
    bar_.show(texels, "done");
  }

  const Options& options_;
  Source& source_;
  const Image& image_;
  uint32_t band_;  // rows, a multiple of the tile
  std::vector<size_t> row_sizes_;
  Target target_;
  Part part_;
  std::unique_ptr<Pyramid> pyramid_;
  Bar bar_;
  uint32_t done_ = 0;   // rows of the base that are in the pyramid
  uint32_t saved_ = 0;  // rows from which a later run continues
};

}  // namespace

void convert(const Options& options) {
  const std::string shown = shd::io::printable(options.output);
  if (!options.force && ::access(options.output.c_str(), F_OK) == 0) {
    throw Failure(kExitOutput, "\"" + shown + "\" exists: --force replaces it");
  }
  Source source(options);
  Run(options, source).run();
  const Image& image = source.image();
  std::printf("%s: %u x %u, %u levels\n", shown.c_str(), image.width, image.height,
              shd::texture::full_level_count(image.width, image.height));
}
