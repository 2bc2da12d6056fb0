// SPDX-License-Identifier: MIT
// The decoders and encoders of builds without OpenImageIO, against OpenImageIO in libshd_io: the same pixels, colour
// space and properties of every kind of PNG, JPEG and Radiance HDR file, and the same files refused.
#include <algorithm>
#include <cmath>
#include <cstring>

#include <shd/io.h>

// Before cmocka, which has a macro named fail.
#include "core/failure.h"
#include "io/check/scrub.h"
#include "io/check/sniff.h"
#include "io/codec/codec.h"
#include "support/picture_files.h"

#include "support/context.h"

namespace {

using namespace shd;
using namespace shd::tests;
using namespace shd_test;

const io::Memory kHeap = {nullptr, [](void*, size_t size) { return std::calloc(1, size); },
                          [](void*, void* memory, size_t) { std::free(memory); }, true};

/// A decoded picture, or the text of the refusal.
struct Result {
  shd_result code = SHD_OK;
  std::string text, space;
  shd_format format = SHD_FORMAT_NONE;
  uint32_t width = 0, height = 0, channels = 0, flags = 0;
  FileBytes pixels;
};

/// By the small decoders, with the checks of io::load() before them.
Result by_small(FileBytes bytes, uint32_t flags, const io::Sink* sink = nullptr) {
  Result out;
  try {
    io::LoadOptions options;
    options.flags = flags;
    const io::Deadline deadline(60);
    const size_t size = bytes.size();
    const shd_file_format format = io::sniff(bytes.data(), size);
    io::check_header(format, bytes.data(), size, options.limits);
    const bool complete = format != SHD_FILE_FORMAT_JPEG || io::jpeg_is_complete(bytes.data(), size);
    const bool strict = (flags & SHD_LOAD_PARTIAL) == 0;
    if (!complete && strict) core::refuse(SHD_ERROR_CORRUPT, "JPEG: the end is missing");
    const size_t scrubbed = io::scrub(format, bytes.data(), size, strict);
    const io::Bitmap bitmap =
        io::decode({format, bytes.data(), scrubbed, size, complete}, options, kHeap, deadline, sink);
    out.space = bitmap.color_space;
    out.format = bitmap.format;
    out.width = bitmap.width;
    out.height = bitmap.height;
    out.channels = bitmap.info.channel_count;
    out.flags = bitmap.info.flags;
    out.pixels.assign(bitmap.pixels.data(), bitmap.pixels.data() + bitmap.pixels.size());
  } catch (const core::Failure& failure) {
    out.code = failure.code;
    out.text = failure.what();
  }
  return out;
}

/// By OpenImageIO in this process.
Result by_oiio(const FileBytes& bytes, uint32_t flags) {
  Result out;
  shd_load_desc desc = shd_load_desc_default();
  desc.flags = flags | SHD_LOAD_IN_PROCESS;
  shd_bitmap* bitmap = nullptr;
  out.code = shd_bitmap_load_memory(g_context, bytes.data(), bytes.size(), &desc, &bitmap);
  if (out.code != SHD_OK) {
    out.text = shd_last_error();
    return out;
  }
  shd_image image = shd_image_default();
  shd_bitmap_info info = shd_bitmap_info_default();
  shd_assert_ok(shd_bitmap_get_image(bitmap, &image));
  shd_assert_ok(shd_bitmap_get_info(bitmap, &info));
  out.space = shd_bitmap_get_color_space(bitmap);
  out.format = image.format;
  out.width = image.width;
  out.height = image.height;
  out.channels = info.channel_count;
  out.flags = info.flags;
  const auto* pixels = static_cast<const unsigned char*>(image.pixels);
  out.pixels.assign(pixels, pixels + image.row_stride * image.height);
  shd_bitmap_release(bitmap);
  return out;
}

void assert_same(const std::string& name, const Result& small, const Result& oiio) {
  if (small.code != oiio.code) {
    fail_msg("%s: small: %d \"%s\", OpenImageIO: %d \"%s\"", name.c_str(), small.code, small.text.c_str(), oiio.code,
             oiio.text.c_str());
  }
  if (small.code != SHD_OK) return;
  if (small.space != oiio.space) fail_msg("%s: %s, not %s", name.c_str(), small.space.c_str(), oiio.space.c_str());
  const bool same = small.format == oiio.format && small.width == oiio.width && small.height == oiio.height &&
                    small.channels == oiio.channels && small.flags == oiio.flags;
  if (!same) {
    fail_msg("%s: format %d, %u x %u, %u channels, flags %u, not format %d, %u x %u, %u channels, flags %u",
             name.c_str(), small.format, small.width, small.height, small.channels, small.flags, oiio.format,
             oiio.width, oiio.height, oiio.channels, oiio.flags);
  }
  assert_int_equal(small.pixels.size(), oiio.pixels.size());
  for (size_t i = 0; i < small.pixels.size(); ++i) {
    if (small.pixels[i] == oiio.pixels[i]) continue;
    fail_msg("%s: byte %zu is %u, not %u", name.c_str(), i, small.pixels[i], oiio.pixels[i]);
  }
}

void assert_same_both(const std::string& name, const FileBytes& bytes) {
  assert_same(name, by_small(bytes, 0), by_oiio(bytes, 0));
  assert_same(name + "/flip", by_small(bytes, SHD_LOAD_FLIP_V), by_oiio(bytes, SHD_LOAD_FLIP_V));
}

/// Every colour type and depth of PNG (ISO/IEC 15948, 11.2.2), with transparency and interlacing.
std::vector<PngKind> png_kinds() {
  std::vector<PngKind> kinds;
  const auto add = [&](int color, std::initializer_list<int> depths) {
    for (const int bits : depths) {
      for (const bool transparency : {false, true}) {
        if (transparency && (color & PNG_COLOR_MASK_ALPHA)) continue;
        for (const bool interlaced : {false, true}) {
          PngKind kind;
          kind.name = "png/" + std::to_string(color) + "/" + std::to_string(bits) + (transparency ? "/tRNS" : "") +
                      (interlaced ? "/adam7" : "");
          kind.color = color;
          kind.bits = bits;
          kind.transparency = transparency;
          kind.interlaced = interlaced;
          kinds.push_back(kind);
        }
      }
    }
  };
  add(PNG_COLOR_TYPE_GRAY, {1, 2, 4, 8, 16});
  add(PNG_COLOR_TYPE_RGB, {8, 16});
  add(PNG_COLOR_TYPE_PALETTE, {1, 2, 4, 8});
  add(PNG_COLOR_TYPE_GRAY_ALPHA, {8, 16});
  add(PNG_COLOR_TYPE_RGB_ALPHA, {8, 16});
  return kinds;
}

void test_png(void**) {
  for (const PngKind& kind : png_kinds()) assert_same_both(kind.name, make_png(kind));
}

/// The gamma chunk and the sRGB chunk (11.3.3) as names of colour spaces.
void test_png_gamma(void**) {
  for (const double gamma : {-1.0, 1.0, 0.999, 0.45455, 0.4545, 0.5, 0.55556, 0.41667, 0.625, 0.33333, 0.9, 0.1, 0.12,
                             0.11, 2.0, 2.2, 3.7, 0.01}) {
    for (const int bits : {8, 16}) {
      PngKind kind;
      kind.name = "png/gamma " + std::to_string(gamma);
      kind.color = PNG_COLOR_TYPE_RGB_ALPHA;
      kind.bits = bits;
      kind.gamma = gamma;
      assert_same_both(kind.name, make_png(kind));
    }
  }
}

std::vector<JpegKind> jpeg_kinds() {
  std::vector<JpegKind> kinds;
  const auto add = [&](const char* name) -> JpegKind& {
    kinds.emplace_back();
    kinds.back().name = name;
    return kinds.back();
  };
  add("jpeg/420");
  JpegKind& plain = add("jpeg/444");
  plain.sampling_x = plain.sampling_y = 1;
  add("jpeg/422").sampling_y = 1;
  add("jpeg/440").sampling_x = 1;
  add("jpeg/progressive").progressive = true;
  add("jpeg/arithmetic").arithmetic = true;
  add("jpeg/restart").restart = 3;
  add("jpeg/quality").quality = 100;
  JpegKind& rgb = add("jpeg/rgb");
  rgb.stored = JCS_RGB;
  rgb.sampling_x = rgb.sampling_y = 1;
  for (const bool ycck : {false, true}) {
    JpegKind& inks = add(ycck ? "jpeg/ycck" : "jpeg/cmyk");
    inks.components = 4;
    inks.in = JCS_CMYK;
    inks.stored = ycck ? JCS_YCCK : JCS_CMYK;
    inks.sampling_x = inks.sampling_y = 1;
    inks.quality = 100;
    inks.width = inks.height = 300;
  }
  for (const int components : {1, 2}) {
    JpegKind& grey = add(components == 1 ? "jpeg/grey" : "jpeg/two");
    grey.components = components;
    grey.in = grey.stored = components == 1 ? JCS_GRAYSCALE : JCS_UNKNOWN;
    grey.sampling_x = grey.sampling_y = 1;
  }
  JpegKind& line = add("jpeg/1x1");
  line.width = line.height = 1;
  return kinds;
}

void test_jpeg(void**) {
  for (const JpegKind& kind : jpeg_kinds()) assert_same_both(kind.name, make_jpeg(kind));
}

/// Exponents whose power of two is inexact in the table of OpenImageIO 2.4.
bool is_inexact(unsigned exponent) {
  return exponent == 40 || exponent == 223 || exponent == 226;
}

/// Flat pixels with all other exponents.
FileBytes hdr_file(const char* head, const char* size, uint32_t width, uint32_t height) {
  const std::string text = std::string(head) + "\n" + size + "\n";
  FileBytes out(text.begin(), text.end());
  for (uint32_t i = 0; i < 4 * width * height; ++i) {
    const unsigned code = (noise(i, 5, 0) & 0xff) | 3;
    out.push_back(static_cast<unsigned char>(is_inexact(code) ? 129 : code));
  }
  return out;
}

void test_hdr(void**) {
  const char* const kHeads[] = {"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n", "#?RGBE\n",
                                "#?RADIANCE\nGAMMA=2.2\nEXPOSURE=3\nFORMAT=32-bit_rle_rgbe\n",
                                "#?RADIANCE\n# a comment\nGAMMA=1.0\nFORMAT=32-bit_rle_rgbe\n"};
  for (const char* head : kHeads) assert_same_both(head, hdr_file(head, "-Y 6 +X 7", 7, 6));
  for (const char* size :
       {"-Y 6 +X 5", "+Y 6 +X 5", "-Y 6 -X 5", "+Y 6 -X 5", "+X 6 -Y 5", "-X 6 +Y 5", "+X 6 +Y 5", "-X 6 -Y 5"}) {
    assert_same_both(size, hdr_file(kHeads[0], size, 5, 6));
  }
  for (const char* size : {"", "-Y 6", "-Y 6 +X", "6 5", "-Z 6 +X 5", "-Y 6 +Y 5", "-Y 0 +X 5", "-Y 6 +X 900000"}) {
    assert_true(by_small(hdr_file(kHeads[0], size, 5, 6), 0).code != SHD_OK);
  }
}

/// A job of noise.
struct Job {
  io::EncodeJob job;
  io::Sample sample;
  bool smooth = false;

  Job(const char* writer, size_t channels, io::Sample kind, uint32_t width, uint32_t height) : sample(kind) {
    constexpr const char* kNames[4] = {"R", "G", "B", "A"};
    job.writer = writer;
    job.width = width;
    job.height = height;
    for (size_t c = 0; c < channels; ++c) job.channels.push_back({channels == 1 ? "Y" : kNames[c], kind});
    job.alpha = channels == 4 ? 3 : -1;
    job.straight = true;
    job.row = write_row;
    job.user_data = this;
  }
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  static void write_row(const void* user_data, uint32_t y, unsigned char* out) {
    const Job& self = *static_cast<const Job*>(user_data);
    const auto channels = static_cast<uint32_t>(self.job.channels.size());
    for (uint32_t i = 0; i < self.job.width * channels; ++i) {
      const uint32_t x = self.smooth ? i / channels / 9 : i / channels;
      const unsigned value = noise(x, y, i % channels);
      if (self.sample == io::Sample::kU8) {
        out[i] = static_cast<unsigned char>(value);
      } else if (self.sample == io::Sample::kU16) {
        const auto code = static_cast<uint16_t>(value);
        std::memcpy(out + 2 * i, &code, 2);
      } else {
        const float light = std::ldexp(static_cast<float>(value & 0xff), static_cast<int>(value >> 8) % 64 - 40);
        std::memcpy(out + 4 * i, &light, 4);
      }
    }
  }
};

/// Both read a written file, and its numbers are those of the job.
void test_write_png(void**) {
  for (const size_t channels : {1, 3, 4}) {
    for (const io::Sample sample : {io::Sample::kU8, io::Sample::kU16}) {
      for (const char* space : {"", "sRGB", "Linear"}) {
        Job job("png", channels, sample, 31, 17);
        job.job.color_space = space;
        const FileBytes bytes = io::encode(job.job);
        const Result result = by_oiio(bytes, 0);
        assert_same("png", by_small(bytes, 0), result);
        assert_string_equal(result.space.c_str(), *space == 'L' ? "Linear Rec.709" : "sRGB");
        const size_t size = sample == io::Sample::kU8 ? 1 : 2;
        FileBytes row(31 * channels * size);
        for (uint32_t y = 0; y < 17; ++y) {
          Job::write_row(&job, y, row.data());
          for (size_t x = 0; x < 31; ++x) {
            assert_memory_equal(result.pixels.data() + (y * 31 + x) * 4 * size, row.data() + x * channels * size, size);
          }
        }
      }
    }
  }
}

/// The numbers are below those of the job by less than one code, also in runs.
void test_write_hdr(void**) {
  for (const uint32_t width : {5u, 8u, 300u}) {
    for (const bool smooth : {false, true}) {
      Job job("hdr", 3, io::Sample::kFloat, width, 9);
      job.smooth = smooth;
      const FileBytes bytes = io::encode(job.job);
      const Result result = by_oiio(bytes, 0);
      assert_same("hdr", by_small(bytes, 0), result);
      std::vector<float> row(3 * width);
      for (uint32_t y = 0; y < 9; ++y) {
        Job::write_row(&job, y, reinterpret_cast<unsigned char*>(row.data()));
        for (size_t x = 0; x < width; ++x) {
          float read[4];
          std::memcpy(read, result.pixels.data() + (y * width + x) * 16, 16);
          const float largest = std::max({row[3 * x], row[3 * x + 1], row[3 * x + 2]});
          for (size_t c = 0; c < 3; ++c) {
            const float wanted = row[3 * x + c];
            const bool good = read[c] <= wanted && wanted - read[c] <= std::max(largest / 128, 1e-32f);
            if (!good) fail_msg("%g is written as %g", static_cast<double>(wanted), static_cast<double>(read[c]));
          }
        }
      }
    }
  }
}

/// A file that is cut off anywhere or has a wrong byte is refused by both, or read by both with the same pixels.
void test_damaged(void**) {
  PngKind png;
  png.width = png.height = 9;
  JpegKind jpeg, scans;
  jpeg.width = scans.width = jpeg.height = scans.height = 20;
  scans.progressive = true;
  const FileBytes files[] = {make_png(png), make_jpeg(jpeg), make_jpeg(scans),
                             hdr_file("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n", "-Y 6 +X 5", 5, 6)};
  for (const FileBytes& file : files) {
    for (size_t size = 12; size < file.size(); ++size) {
      const FileBytes cut(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size));
      assert_same("cut at " + std::to_string(size), by_small(cut, 0), by_oiio(cut, 0));
      (void)by_small(cut, SHD_LOAD_PARTIAL);
    }
    for (size_t at = 12; at < file.size(); ++at) {
      FileBytes wrong = file;
      wrong[at] = static_cast<unsigned char>(wrong[at] ^ (1 + noise(static_cast<uint32_t>(at), 0, 9) % 255));
      if (&file == &files[3] && is_inexact(wrong[at])) continue;
      assert_same("byte " + std::to_string(at), by_small(wrong, 0), by_oiio(wrong, 0));
      (void)by_small(wrong, SHD_LOAD_PARTIAL);
    }
  }
}

/// With SHD_LOAD_PARTIAL the rows above the damage stay.
void test_partial(void**) {
  PngKind kind;
  kind.height = 200;
  const FileBytes file = make_png(kind);
  const Result whole = by_small(file, 0);
  const FileBytes half(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(file.size() / 2));
  const Result part = by_small(half, SHD_LOAD_PARTIAL);
  assert_int_equal(part.code, SHD_OK);
  assert_int_equal(part.flags, SHD_BITMAP_PARTIAL);
  const size_t row = size_t{4} * kind.width;
  size_t rows = 0;
  while (rows < 200 && std::memcmp(part.pixels.data() + rows * row, whole.pixels.data() + rows * row, row) == 0) ++rows;
  assert_true(rows > 60 && rows < 140);
  for (size_t i = rows * row; i < part.pixels.size(); ++i) assert_int_equal(part.pixels[i], 0);
}

/// Formats that need OpenImageIO.
void test_refused(void**) {
  const Result gif = by_small({'G', 'I', 'F', '8', '9', 'a', 1, 0, 1, 0, 0, 0, 0}, 0);
  assert_int_equal(gif.code, SHD_ERROR_UNSUPPORTED);
  assert_string_equal(gif.text.c_str(),
                      "the content is GIF; this build reads PNG, JPEG and Radiance HDR, because it "
                      "has no OpenImageIO");
  Job job("openexr", 3, io::Sample::kFloat, 1, 1);
  try {
    (void)io::encode(job.job);
    fail_msg("an OpenEXR file was written");
  } catch (const core::Failure& failure) {
    assert_int_equal(failure.code, SHD_ERROR_UNSUPPORTED);
    assert_string_equal(failure.what(), "this build writes .png and .hdr, because it has no OpenImageIO for openexr");
  }
}

}  // namespace

int main() {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_png),     cmocka_unit_test(test_png_gamma), cmocka_unit_test(test_jpeg),
      cmocka_unit_test(test_hdr),     cmocka_unit_test(test_write_png), cmocka_unit_test(test_write_hdr),
      cmocka_unit_test(test_damaged), cmocka_unit_test(test_partial),   cmocka_unit_test(test_refused),
  };
  return _cmocka_run_group_tests("unit.io.small", tests, sizeof tests / sizeof tests[0], set_up, tear_down);
}
