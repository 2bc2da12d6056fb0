// SPDX-License-Identifier: MIT
// JPEG by libjpeg. Errors of libjpeg return by longjmp: the functions between setjmp and a call of libjpeg have no
// objects with destructors. Warnings, such as of bytes between two markers, are ignored, as OpenImageIO ignores them.
#include <cstddef>
#include <cstdio>
// After <cstdio>, which it needs.
#include <jpeglib.h>

#include <csetjmp>
#include <cstring>
#include <vector>

#include "core/failure.h"
#include "core/printable.h"
#include "io/small/rows.h"

namespace shd::io {

namespace {

/// Where an error of libjpeg goes. The manager is the first member, so that its address is that of the struct.
struct JpegErrors {
  jpeg_error_mgr manager;
  std::jmp_buf jump;
  char text[JMSG_LENGTH_MAX];
};

[[noreturn]] void jpeg_failed(j_common_ptr decoder) {
  auto* errors = reinterpret_cast<JpegErrors*>(decoder->err);
  decoder->err->format_message(decoder, errors->text);
  core::make_printable(errors->text, std::strlen(errors->text));
  std::longjmp(errors->jump, 1);
}

void jpeg_warned(j_common_ptr) {}

/// Runs a body that calls libjpeg. Returns false after an error.
template <class Body>
bool run_jpeg(JpegErrors& errors, Body&& body) {
  if (setjmp(errors.jump)) return false;
  body();
  return true;
}

/// Files have the complements of the inks.
unsigned char ink_to_light(unsigned ink, unsigned black) {
  const float light = (static_cast<float>(ink) * (1.0f / 255.0f)) * (static_cast<float>(black) * (1.0f / 255.0f));
  return static_cast<unsigned char>(light * 255.0f + 0.5f);
}

class JpegRows : public PictureRows {
 public:
  explicit JpegRows(const DecodeInput& input) {
    errors_.text[0] = 0;
    decoder_.err = jpeg_std_error(&errors_.manager);
    errors_.manager.error_exit = jpeg_failed;
    errors_.manager.output_message = jpeg_warned;
    const bool opened = run_jpeg(errors_, [&] {
      jpeg_create_decompress(&decoder_);
      jpeg_mem_src(&decoder_, input.bytes, input.size);
      (void)jpeg_read_header(&decoder_, TRUE);
    });
    if (!opened) refuse_opened("cannot open");
    inks_ = decoder_.jpeg_color_space == JCS_CMYK || decoder_.jpeg_color_space == JCS_YCCK;
    if (inks_) decoder_.out_color_space = JCS_CMYK;
    picture.width = decoder_.image_width;
    picture.height = decoder_.image_height;
    picture.channels = inks_ ? 3 : decoder_.num_components;
    picture.color_space = "sRGB";
    if (picture.channels > 4) {
      jpeg_destroy_decompress(&decoder_);
      core::refuse(SHD_ERROR_UNSUPPORTED, "JPEG: %d components", picture.channels);
    }
  }
  JpegRows(const JpegRows&) = delete;
  JpegRows& operator=(const JpegRows&) = delete;
  ~JpegRows() override { jpeg_destroy_decompress(&decoder_); }

  void read(unsigned char* row) override {
    if (inks_) ink_row_.resize(size_t{4} * picture.width);
    unsigned char* to = inks_ ? ink_row_.data() : row;
    const bool ok = run_jpeg(errors_, [&] {
      if (!started_) (void)jpeg_start_decompress(&decoder_);  // decodes all scans of a progressive file
      started_ = true;
      (void)jpeg_read_scanlines(&decoder_, &to, 1);
    });
    if (!ok) core::refuse(SHD_ERROR_CORRUPT, "JPEG: damaged: %s", errors_.text);
    for (size_t x = 0; inks_ && x < picture.width; ++x) {
      for (size_t c = 0; c < 3; ++c) row[3 * x + c] = ink_to_light(to[4 * x + c], to[4 * x + 3]);
    }
  }

 private:
  [[noreturn]] void refuse_opened(const char* what) {
    jpeg_destroy_decompress(&decoder_);
    core::refuse(SHD_ERROR_CORRUPT, "JPEG: %s: %s", what, errors_.text);
  }

  JpegErrors errors_ = {};
  jpeg_decompress_struct decoder_ = {};
  bool inks_ = false;
  bool started_ = false;
  std::vector<unsigned char> ink_row_;
};

}  // namespace

std::unique_ptr<PictureRows> open_jpeg(const DecodeInput& input) {
  return std::make_unique<JpegRows>(input);
}

}  // namespace shd::io
