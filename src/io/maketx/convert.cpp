// SPDX-License-Identifier: MIT
#include "io/maketx/convert.h"

#include <shd/names.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cinttypes>
#include <cstdio>
#include <functional>
#include <memory>

#include "command/program.h"
#include "data/checksum.h"
#include "io/file/printable.h"
#include "io/maketx/bar.h"
#include "io/maketx/color.h"
#include "io/maketx/jobs.h"
#include "io/maketx/part.h"
#include "io/maketx/probe.h"
#include "io/maketx/pyramid.h"
#include "io/maketx/source.h"
#include "io/maketx/stats.h"
#include "io/maketx/target.h"
#include "io/maketx/whole.h"

namespace {

using shd::texture::completed_rows;
using shd::texture::level_size;

constexpr uint64_t kMaxBand = uint64_t{64} << 20;  // larger bands gain nothing [bytes]

/// The options that decide the bits of the output.
std::string options_text(const Options& options) {
  std::string text = "2";
  for (const std::string& part :
       {std::to_string(options.tile), options.format, options.compression, options.wrap_s, options.wrap_t,
        std::to_string(options.kernel), std::to_string(static_cast<int>(options.content)),
        std::to_string(static_cast<int>(options.encoding)), std::to_string(options.normal),
        std::to_string(options.channels), options.color_from, options.color_to}) {
    text += "\n" + part;
  }
  for (const Attribute& attribute : options.attributes) text += "\n" + attribute.name + "=" + attribute.value;
  return text + config_text(options);
}

/// A checksum of the options and of the state of the input, 16 hexadecimal digits.
std::string key_of(const Options& options) {
  const FileState state = file_state(options.input);
  const std::string text = options_text(options) + "\n" + std::to_string(state.bytes) + "\n" +
                           std::to_string(state.changed) + "\n" + options.input;
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016" PRIx64, shd::data::checksum(text.data(), text.size()));
  return digits;
}

/// Differs where the levels above level 0 differ.
std::string hash_text(const Options& options, const Image& image) {
  const bool srgb = image.component == shd::image::Component::kSrgb8;
  const bool wraps = options.kernel != SHD_MIP_KERNEL_BOX;
  return std::string("shd ") + shd_mip_kernel_name(options.kernel) + (srgb ? " srgb" : "") +
         (options.normal ? " normal" : "") + (wraps ? " " + options.wrap_s + "," + options.wrap_t : "") + " ";
}

/// Memory for a band of rows, beside the pyramid: the band, a copy of it in OpenImageIO with compressed tiles, the
/// rows of levels that it completes, and the rows of the decoder.
uint64_t band_bytes(const Image& image, uint32_t rows, uint32_t step) {
  const uint64_t row = image.row_size();
  return row * rows * 3 + row * rows / 2 + 2 * row + row * step;
}

uint32_t choose_band(const Options& options, const Image& image, uint32_t step) {
  const auto tile = static_cast<uint32_t>(options.tile);
  const uint64_t sums = pyramid_bytes(options, image);
  if (options.kernel != SHD_MIP_KERNEL_BOX) require_memory(options, "--filter", sums);
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

/// The rows of the input as the output has them: converted, and unfolded from a probe.
class Input {
 public:
  Input(const Options& options, const shd::io::Deadline& end, const Converter* converter)
      : source_(options, end, converter),
        probe_(options.content == Content::kProbe ? make_probe(options, source_) : nullptr) {}
  Rows& rows() { return probe_ ? *probe_ : source_; }

 private:
  Source source_;
  std::unique_ptr<Rows> probe_;
};

/// One run, from the first band to the complete file. The rows of the input are read twice: for the levels, the hash
/// and the mean, which the header has; then for level 0.
class Run {
 public:
  using OpenInput = std::function<std::unique_ptr<Input>()>;

  Run(const Options& options, const shd::io::Deadline& end, const OpenInput& open)
      : options_(options),
        end_(end),
        open_(open),
        input_(open()),
        image_(input_->rows().image()),
        key_(key_of(options)),
        band_(choose_band(options, image_, input_->rows().step())),
        row_sizes_(row_sizes(image_)),
        target_(options, image_),
        part_(options.output, key_, options.force || options.update, row_sizes_, image_.height),
        pyramid_(make_pyramid(options, image_)),
        bar_(options.quiet, texels_of(image_) + base_texels(), 0) {}

  const Image& image() const { return image_; }

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
      Stats stats(options_, image_, hash_text(options_, image_));
      read_base(stats);
      const Marks marks = {stats.hash(), stats.average(), stats.constant(), key_};
      target_.mark(marks);
      input_.reset();
      input_ = open_();
      target_.open(part_.create_file());
      write_base(marks.hash);
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

  uint64_t base_texels() const { return uint64_t{image_.width} * image_.height; }

  /// Reads the rows of the base for the levels and the header.
  void read_base(Stats& stats) {
    std::vector<uint8_t> rows(band_ * image_.row_size());
    Clock::time_point saved = Clock::now();
    for (uint32_t y = 0; y < image_.height; y += band_) {
      const uint32_t count = std::min(band_, image_.height - y);
      bar_.show(uint64_t{y} * image_.width, "levels");
      input_->rows().read(count, rows.data());
      stats.add(rows.data(), count);
      if (y + count <= done_) continue;
      add({rows.data(), image_.row_size(), y, count});
      const bool last = y + count == image_.height;
      const bool due = std::chrono::duration<double>(Clock::now() - saved).count() >= options_.checkpoint;
      if (!last && (!due || pyramid_->is_whole())) continue;
      part_.save(done_, pyramid_->state());
      saved_ = done_;
      saved = Clock::now();
    }
  }

  /// Reads them again for the file. Other rows than before are refused.
  void write_base(const std::string& hash) {
    if (!(input_->rows().image() == image_)) refuse_change();
    Stats again(options_, image_, hash_text(options_, image_));
    target_.begin_level(0);
    std::vector<uint8_t> rows(band_ * image_.row_size());
    for (uint32_t y = 0; y < image_.height; y += band_) {
      const uint32_t count = std::min(band_, image_.height - y);
      bar_.show(base_texels() + uint64_t{y} * image_.width, "base");
      input_->rows().read(count, rows.data());
      again.add(rows.data(), count);
      target_.write(y, count, rows.data());
    }
    if (again.hash() != hash) refuse_change();
  }

  [[noreturn]] void refuse_change() const {
    throw Failure(kExitInput, "\"" + shd::io::printable(options_.input) + "\": the file changed while it was read");
  }

  /// Adds the rows of a band that no earlier run has added.
  void add(shd::texture::StreamRows rows) {
    if (!pyramid_->is_whole()) {
      const uint32_t skip = done_ > rows.first ? done_ - rows.first : 0;
      rows = {rows.texels + skip * rows.stride, rows.stride, rows.first + skip, rows.count - skip};
    }
    const uint32_t before = pyramid_->is_whole() ? 0 : rows.first;  // rows whose levels are complete
    const uint32_t after = pyramid_->is_whole() && rows.end() < image_.height ? 0 : rows.end();
    std::vector<std::vector<uint8_t>> finished;
    std::vector<uint8_t*> out;
    const auto count = static_cast<uint32_t>(row_sizes_.size());
    for (uint32_t level = 1; level <= count; ++level) {
      finished.emplace_back(finished_rows(level, before, after) * row_sizes_[level - 1]);
      out.push_back(finished.back().data());
    }
    pyramid_->push(rows, out.data());
    for (uint32_t level = 1; level <= count; ++level) {
      const uint32_t first = completed_rows(image_.height, level, before);
      part_.write(level, first, finished_rows(level, before, after), out[level - 1]);
    }
    done_ = after;
  }

  uint32_t finished_rows(uint32_t level, uint32_t before, uint32_t after) const {
    return completed_rows(image_.height, level, after) - completed_rows(image_.height, level, before);
  }

  void write_levels() {
    uint64_t texels = 2 * base_texels();
    for (uint32_t level = 1; level <= row_sizes_.size(); ++level) {
      target_.begin_level(level);
      const uint32_t height = level_size(image_.height, level), width = level_size(image_.width, level);
      std::vector<uint8_t> rows(std::min(band_, height) * row_sizes_[level - 1]);
      for (uint32_t y = 0; y < height; y += band_) {
        const uint32_t count = std::min(band_, height - y);
        bar_.show(texels, "level " + std::to_string(level));
        check_time(end_);
        part_.read(level, y, count, rows.data());
        target_.write(y, count, rows.data());
        texels += uint64_t{count} * width;
      }
    }
    bar_.show(texels, "done");
  }

  const Options& options_;
  const shd::io::Deadline& end_;
  const OpenInput open_;
  std::unique_ptr<Input> input_;
  const Image image_;
  const std::string key_;
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
  if (::access(options.output.c_str(), F_OK) == 0) {
    if (options.update && Source::stored_key(options, options.output) == key_of(options)) {
      std::printf("%s: is up to date\n", shown.c_str());
      return;
    }
    if (!options.force && !options.update) {
      throw Failure(kExitOutput, "\"" + shown + "\" exists: --force replaces it, -u if it is out of date");
    }
  }
  const shd::io::Deadline end(options.time_limit > 0 ? options.time_limit : 1e9);
  const std::unique_ptr<Converter> converter = make_converter(options);
  Run run(options, end, [&] { return std::make_unique<Input>(options, end, converter.get()); });
  run.run();
  const Image& image = run.image();
  std::printf("%s: %u x %u, %u levels\n", shown.c_str(), image.width, image.height,
              shd::texture::full_level_count(image.width, image.height));
}

int convert_all(const Options& options) {
  const std::vector<Options> jobs = make_jobs(options);
  int status = kExitOk;
  for (const Options& job : jobs) {
    const int result = command::run("shd-maketx", [&]() -> int {
      convert(job);
      return kExitOk;
    });
    if (status == kExitOk) status = result;
  }
  return status;
}
