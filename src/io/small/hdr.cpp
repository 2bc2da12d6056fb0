// SPDX-License-Identifier: MIT
// Radiance pictures of RGBE pixels (Ward, "Radiance File Formats"): three mantissas with a common exponent.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <vector>

#include "core/failure.h"
#include "io/bitmap/transfer.h"
#include "io/file/byte_reader.h"
#include "io/small/rows.h"

namespace shd::io {

namespace {

constexpr size_t kShortestRun = 8, kLongestRun = 0x7fff;  // widths that run lengths can have [pixels]
constexpr size_t kMaxHdrHeader = 1 << 16;

[[noreturn]] void refuse_hdr(const char* what) {
  core::refuse(SHD_ERROR_CORRUPT, "Radiance HDR: %s", what);
}

/// Reads "-Y 480 +X 640": a sign and an axis, a number, twice.
void read_resolution(const std::string& line, Picture* picture) {
  char axis[2][3] = {};
  unsigned size[2] = {};
  if (std::sscanf(line.c_str(), "%2s %9u %2s %9u", axis[0], &size[0], axis[1], &size[1]) != 4) {
    refuse_hdr("no size in the header");
  }
  const bool columns = axis[0][1] == 'X';
  for (const char* text : axis) {
    if (text[0] != '-' && text[0] != '+') refuse_hdr("no size in the header");
  }
  if (axis[0][1] != (columns ? 'X' : 'Y') || axis[1][1] != (columns ? 'Y' : 'X')) refuse_hdr("no size in the header");
  picture->height = size[0];
  picture->width = size[1];
}

/// The number of the line GAMMA, 1 without one.
double read_gamma(const std::string& header) {
  const size_t line = header.find("\nGAMMA=");
  if (line == std::string::npos) return 1;
  const size_t first = header.find_first_not_of(' ', line + 7);
  const double gamma = parse_gamma(header.substr(first, header.find_first_of(" \r\n", first) - first));
  return gamma > 0 ? gamma : 1;
}

class HdrRows : public PictureRows {
 public:
  explicit HdrRows(const DecodeInput& input) : in_{input.bytes, input.size, true} {
    picture.turn = read_hdr_header(input.bytes, input.size);
    const std::string text(reinterpret_cast<const char*>(input.bytes), std::min(input.size, kMaxHdrHeader));
    const size_t blank = text.find("\n\n");
    const size_t end = blank == std::string::npos ? blank : text.find('\n', blank + 2);
    if (end == std::string::npos) refuse_hdr("the header is cut off");
    if (text.find("\nFORMAT=32-bit_rle_rgbe\n") >= blank) refuse_hdr("no FORMAT in the header");
    read_resolution(text.substr(blank + 2, end - blank - 2), &picture);
    at_ = end + 1;
    picture.channels = 3;
    picture.sample = Sample::kFloat;
    picture.color_space = gamma_space(read_gamma(text.substr(0, blank)));
  }

  void read(unsigned char* row) override {
    const size_t width = picture.width;
    pixels_.resize(4 * width);
    const bool packed = width >= kShortestRun && width <= kLongestRun && in_.has(at_, 4) && in_.bytes[at_] == 2 &&
                        in_.bytes[at_ + 1] == 2 && in_.bytes[at_ + 2] < 0x80;
    packed ? read_runs() : read_flat();
    for (size_t x = 0; x < width; ++x) {
      const unsigned char* rgbe = pixels_.data() + 4 * x;
      const float scale = rgbe[3] ? std::ldexp(1.0f, static_cast<int>(rgbe[3]) - (128 + 8)) : 0.0f;
      for (size_t c = 0; c < 3; ++c) {
        const float value = static_cast<float>(rgbe[c]) * scale;
        std::memcpy(row + (3 * x + c) * sizeof value, &value, sizeof value);
      }
    }
  }

 private:
  void read_flat() {
    if (!in_.has(at_, pixels_.size())) refuse_hdr("cut off");
    std::memcpy(pixels_.data(), in_.bytes + at_, pixels_.size());
    at_ += pixels_.size();
  }

  /// The four numbers of the pixels one after the other: each as runs (128 + count, value) and pieces (count, values).
  void read_runs() {
    const size_t width = picture.width;
    if (in_.u16(at_ + 2) != width) refuse_hdr("a row of another width");
    at_ += 4;
    for (size_t c = 0; c < 4; ++c) {
      for (size_t x = 0; x < width;) {
        const size_t code = in_.u8(at_++);
        const bool run = code > 128;
        const size_t count = run ? code - 128 : code;
        if (count == 0 || count > width - x || !in_.has(at_, run ? 1 : count)) refuse_hdr("a damaged row");
        for (size_t i = 0; i < count; ++i, ++x) pixels_[4 * x + c] = in_.bytes[at_ + (run ? 0 : i)];
        at_ += run ? 1 : count;
      }
    }
  }

  ByteReader in_;
  uint64_t at_ = 0;
  std::vector<unsigned char> pixels_;  // one row: [width][r, g, b, exponent]
};

/// The nearest code below: the largest component decides the exponent.
void store_rgbe(const float* rgb, unsigned char* out) {
  const float largest = std::max({rgb[0], rgb[1], rgb[2]});
  std::memset(out, 0, 4);
  if (!(largest >= 1e-32f)) return;
  int exponent = 0;
  const float scale = std::frexp(std::min(largest, 1.7e38f), &exponent) * 256.0f / std::min(largest, 1.7e38f);
  for (int c = 0; c < 3; ++c) {
    const float code = rgb[c] > 0 ? rgb[c] * scale : 0.0f;
    out[c] = static_cast<unsigned char>(std::min(code, 255.0f));
  }
  out[3] = static_cast<unsigned char>(exponent + 128);
}

/// Runs of four or more equal bytes, and pieces of up to 128 others.
void pack_bytes(const std::vector<unsigned char>& row, std::vector<unsigned char>* out) {
  const auto run_at = [&](size_t x) {
    size_t end = x + 1;
    while (end < row.size() && end - x < 127 && row[end] == row[x]) ++end;
    return end - x;
  };
  for (size_t x = 0; x < row.size();) {
    const size_t run = run_at(x);
    if (run >= 4) {
      out->insert(out->end(), {static_cast<unsigned char>(128 + run), row[x]});
      x += run;
      continue;
    }
    size_t end = x;
    while (end < row.size() && end - x < 128 && run_at(end) < 4) ++end;
    out->push_back(static_cast<unsigned char>(end - x));
    out->insert(out->end(), row.begin() + static_cast<std::ptrdiff_t>(x),
                row.begin() + static_cast<std::ptrdiff_t>(end));
    x = end;
  }
}

void pack_row(const std::vector<unsigned char>& pixels, size_t width, std::vector<unsigned char>* out) {
  if (width < kShortestRun || width > kLongestRun) {
    out->insert(out->end(), pixels.begin(), pixels.end());
    return;
  }
  out->insert(out->end(), {2, 2, static_cast<unsigned char>(width >> 8), static_cast<unsigned char>(width & 0xff)});
  std::vector<unsigned char> row(width);
  for (size_t c = 0; c < 4; ++c) {
    for (size_t x = 0; x < width; ++x) row[x] = pixels[4 * x + c];
    pack_bytes(row, out);
  }
}

}  // namespace

std::unique_ptr<PictureRows> open_hdr(const DecodeInput& input) {
  return std::make_unique<HdrRows>(input);
}

std::vector<unsigned char> encode_hdr(const EncodeJob& job) {
  char head[128];
  const int size =
      std::snprintf(head, sizeof head, "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %u +X %u\n", job.height, job.width);
  std::vector<unsigned char> out(head, head + size);
  std::vector<float> rgb(size_t{3} * job.width);
  std::vector<unsigned char> pixels(size_t{4} * job.width);
  for (uint32_t y = 0; y < job.height; ++y) {
    job.row(job.user_data, y, reinterpret_cast<unsigned char*>(rgb.data()));
    for (size_t x = 0; x < job.width; ++x) store_rgbe(rgb.data() + 3 * x, pixels.data() + 4 * x);
    pack_row(pixels, job.width, &out);
  }
  return out;
}

}  // namespace shd::io
