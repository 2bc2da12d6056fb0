// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "io/check/hdr_header.h"
#include "io/codec/codec.h"

namespace shd::io {

/// Size, channels and colour space from the header of a picture.
struct Picture {
  uint32_t width = 0;
  uint32_t height = 0;
  int channels = 0;    // 1 is grey, 2 are grey and alpha or red and green
  bool alpha = false;  // the last channel is alpha
  Sample sample = Sample::kU8;
  std::string color_space;  // name_color_space() takes it; "" = none
  Turn turn;                // order of the pixels of the file
};

/// The rows of a picture in the order of the file.
class PictureRows {
 public:
  virtual ~PictureRows() = default;
  /// Reads the next row: [width][channels], packed, native endian. Throws Failure (SHD_ERROR_CORRUPT) for damage.
  virtual void read(unsigned char* row) = 0;

  Picture picture;
};

/// Name of the colour space of numbers with the exponent `gamma`: the exponent of decoding with two digits, as
/// OpenImageIO writes it. "Linear" for 1.
std::string gamma_space(double gamma);

/// Open a file whose header has been checked. They read the header and take no memory for pixels.
std::unique_ptr<PictureRows> open_png(const DecodeInput& input);
std::unique_ptr<PictureRows> open_jpeg(const DecodeInput& input);
std::unique_ptr<PictureRows> open_hdr(const DecodeInput& input);

/// Write the files of a job.
std::vector<unsigned char> encode_png(const EncodeJob& job);
std::vector<unsigned char> encode_hdr(const EncodeJob& job);

}  // namespace shd::io
