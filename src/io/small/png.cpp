// SPDX-License-Identifier: MIT
// PNG by libpng. Errors of libpng return by longjmp: the functions between setjmp and a call of libpng have no objects
// with destructors.
#include <png.h>

#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <vector>

#include "core/failure.h"
#include "core/printable.h"
#include "io/small/rows.h"

namespace shd::io {

namespace {

/// Where an error of libpng goes.
struct PngErrors {
  std::jmp_buf jump;
  char text[128] = "";
};

[[noreturn]] void png_failed(png_structp png, png_const_charp text) {
  auto* errors = static_cast<PngErrors*>(png_get_error_ptr(png));
  std::snprintf(errors->text, sizeof errors->text, "%s", text);
  core::make_printable(errors->text, std::strlen(errors->text));
  std::longjmp(errors->jump, 1);
}

void png_warned(png_structp, png_const_charp) {}

/// Runs a body that calls libpng. Returns false after an error.
template <class Body>
bool run_png(PngErrors& errors, Body&& body) {
  if (setjmp(errors.jump)) return false;
  body();
  return true;
}

bool is_little_endian() {
  const uint16_t one = 1;
  unsigned char first = 0;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

class PngRows : public PictureRows {
 public:
  explicit PngRows(const DecodeInput& input) : next_(input.bytes), end_(input.bytes + input.size) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &errors_, png_failed, png_warned);
    info_ = png_ ? png_create_info_struct(png_) : nullptr;
    if (!info_) {
      png_destroy_read_struct(&png_, nullptr, nullptr);
      throw std::bad_alloc();
    }
    if (!run_png(errors_, [this] { read_header(); })) {
      png_destroy_read_struct(&png_, &info_, nullptr);
      core::refuse(SHD_ERROR_CORRUPT, "PNG: cannot open: %s", errors_.text);
    }
    picture.color_space = gamma_ > 0 ? gamma_space(gamma_) : "sRGB";
  }
  PngRows(const PngRows&) = delete;
  PngRows& operator=(const PngRows&) = delete;
  ~PngRows() override { png_destroy_read_struct(&png_, &info_, nullptr); }

  void read(unsigned char* row) override {
    if (interlaced_ && whole_.empty()) read_whole();
    if (interlaced_) {
      std::memcpy(row, whole_.data() + row_size_ * row_++, row_size_);
    } else if (!run_png(errors_, [this, row] { png_read_row(png_, row, nullptr); })) {
      core::refuse(SHD_ERROR_CORRUPT, "PNG: damaged: %s", errors_.text);
    }
  }

 private:
  static void read_bytes(png_structp png, png_bytep out, size_t size) {
    auto* self = static_cast<PngRows*>(png_get_io_ptr(png));
    if (size > static_cast<size_t>(self->end_ - self->next_)) png_error(png, "cut off");
    std::memcpy(out, self->next_, size);
    self->next_ += size;
  }

  void read_header() {
    png_set_read_fn(png_, this, read_bytes);
    png_read_info(png_, info_);
    png_set_expand(png_);  // palettes to colours, 1 to 4 bits to 8, transparency to alpha
    if (is_little_endian()) png_set_swap(png_);
    interlaced_ = png_get_interlace_type(png_, info_) != PNG_INTERLACE_NONE;
    if (interlaced_) (void)png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    picture.width = png_get_image_width(png_, info_);
    picture.height = png_get_image_height(png_, info_);
    picture.channels = png_get_channels(png_, info_);
    picture.alpha = picture.channels % 2 == 0;
    picture.sample = png_get_bit_depth(png_, info_) == 16 ? Sample::kU16 : Sample::kU8;
    row_size_ = png_get_rowbytes(png_, info_);
    int intent = 0;
    double gamma = 0;
    if (png_get_sRGB(png_, info_, &intent) == 0 && png_get_gAMA(png_, info_, &gamma) != 0 && gamma > 0) {
      gamma_ = gamma;
    }
  }

  /// The passes of an interlaced picture.
  void read_whole() {
    whole_.resize(row_size_ * picture.height);
    std::vector<png_bytep> rows(picture.height);
    for (size_t y = 0; y < rows.size(); ++y) rows[y] = whole_.data() + y * row_size_;
    if (!run_png(errors_, [this, &rows] { png_read_image(png_, rows.data()); })) {
      core::refuse(SHD_ERROR_CORRUPT, "PNG: damaged: %s", errors_.text);
    }
  }

  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  PngErrors errors_;
  const unsigned char *next_, *end_;
  size_t row_size_ = 0;
  bool interlaced_ = false;
  double gamma_ = 0;
  size_t row_ = 0;                    // the next row of whole_
  std::vector<unsigned char> whole_;  // all rows of an interlaced picture
};

/// State of one writing.
struct PngWriter {
  PngErrors errors;
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::vector<unsigned char>* out = nullptr;
  bool full = false;  // no memory for the bytes

  PngWriter() = default;
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;
  ~PngWriter() { png_destroy_write_struct(&png, &info); }
};

void write_bytes(png_structp png, png_bytep bytes, size_t size) {
  auto* writer = static_cast<PngWriter*>(png_get_io_ptr(png));
  try {
    writer->out->insert(writer->out->end(), bytes, bytes + size);
    return;
  } catch (...) {
    writer->full = true;
  }
  png_error(png, "out of memory");
}

void flush_bytes(png_structp) {}

void write_header(PngWriter& writer, const EncodeJob& job) {
  constexpr int kKinds[5] = {0, PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                             PNG_COLOR_TYPE_RGB_ALPHA};
  const bool wide = job.channels[0].sample == Sample::kU16;
  png_set_write_fn(writer.png, &writer, write_bytes, flush_bytes);
  png_set_IHDR(writer.png, writer.info, job.width, job.height, wide ? 16 : 8, kKinds[job.channels.size()],
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (std::strcmp(job.color_space, "sRGB") == 0) {
    png_set_sRGB_gAMA_and_cHRM(writer.png, writer.info, PNG_sRGB_INTENT_ABSOLUTE);
  } else if (std::strcmp(job.color_space, "Linear") == 0) {
    png_set_gAMA(writer.png, writer.info, 1.0);
  }
  png_write_info(writer.png, writer.info);
  if (wide && is_little_endian()) png_set_swap(writer.png);
}

void require_written(const PngWriter& writer, bool written) {
  if (writer.full) throw std::bad_alloc();
  if (!written) core::refuse(SHD_ERROR_IO, "cannot encode png: %s", writer.errors.text);
}

}  // namespace

std::unique_ptr<PictureRows> open_png(const DecodeInput& input) {
  return std::make_unique<PngRows>(input);
}

std::vector<unsigned char> encode_png(const EncodeJob& job) {
  std::vector<unsigned char> out;
  PngWriter writer;
  writer.out = &out;
  writer.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &writer.errors, png_failed, png_warned);
  writer.info = writer.png ? png_create_info_struct(writer.png) : nullptr;
  if (!writer.info) throw std::bad_alloc();
  require_written(writer, run_png(writer.errors, [&] { write_header(writer, job); }));
  const size_t sample = job.channels[0].sample == Sample::kU16 ? 2 : 1;
  std::vector<unsigned char> row(size_t{job.width} * job.channels.size() * sample);
  for (uint32_t y = 0; y < job.height; ++y) {
    job.row(job.user_data, y, row.data());
    require_written(writer, run_png(writer.errors, [&] { png_write_row(writer.png, row.data()); }));
  }
  require_written(writer, run_png(writer.errors, [&] { png_write_end(writer.png, nullptr); }));
  return out;
}

}  // namespace shd::io
