// SPDX-License-Identifier: MIT
// Encoding by OpenImageIO.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cstring>
#include <optional>

#include "core/failure.h"
#include "io/bitmap/transfer.h"
#include "io/codec/codec.h"
#include "io/file/printable.h"
#include "io/oiio/handle.h"

namespace shd::io {

namespace {

OIIO::TypeDesc sample_type(Sample sample) {
  switch (sample) {
    case Sample::kU8: return OIIO::TypeUInt8;
    case Sample::kU16: return OIIO::TypeUInt16;
    case Sample::kHalf: return OIIO::TypeHalf;
    case Sample::kU32: return OIIO::TypeUInt32;
    default: return OIIO::TypeFloat;
  }
}

OIIO::ImageSpec encode_spec(const EncodeJob& job) {
  OIIO::ImageSpec spec(static_cast<int>(job.width), static_cast<int>(job.height), static_cast<int>(job.channels.size()),
                       sample_type(job.channels[0].sample));
  spec.channelnames.clear();
  bool mixed = false;
  for (const EncodeChannel& channel : job.channels) {
    spec.channelnames.push_back(channel.name);
    spec.channelformats.push_back(sample_type(channel.sample));
    mixed = mixed || channel.sample != job.channels[0].sample;
  }
  if (!mixed) spec.channelformats.clear();
  spec.alpha_channel = job.alpha;
  if (job.straight) spec.attribute("oiio:UnassociatedAlpha", 1);
  // OpenImageIO would write the time of day; the constant makes the file depend on the pixels alone.
  if (std::strcmp(job.writer, "openexr") == 0 || std::strcmp(job.writer, "tiff") == 0)
    spec.attribute("DateTime", "1970:01:01 00:00:00");
  // With an sRGB tag, OpenImageIO 2.4's TIFF writer ends a file in memory with its EXIF directory alone, which is
  // unreadable.
  const bool tagged = job.color_space[0] != 0 && std::strcmp(job.writer, "tiff") != 0;
  if (tagged) spec.attribute("oiio:ColorSpace", job.color_space);
  if (std::strcmp(job.writer, "openexr") == 0 && std::strcmp(job.color_space, "Linear") == 0) {
    spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), kRec709);
  }
  if (!job.compression.empty()) spec.attribute("compression", job.compression);
  for (const EncodeAttribute& attribute : job.attributes) {
    if (attribute.matrix.empty()) {
      spec.attribute(attribute.name, attribute.text);
    } else {
      spec.attribute(attribute.name, OIIO::TypeMatrix, attribute.matrix.data());
    }
  }
  return spec;
}

}  // namespace

std::vector<unsigned char> encode(const EncodeJob& job) {
  g_image_files.attach();
  begin_pixels(job.writer);
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput proxy(bytes);
  Quiet<OIIO::ImageOutput> output;
  std::optional<core::ForkGate::Scope> inside(g_image_files);
  output.handle = OIIO::ImageOutput::create(job.writer, nullptr, "");
  if (!output.handle) core::refuse(SHD_ERROR_UNSUPPORTED, "OpenImageIO was built without a writer of %s", job.writer);
  const OIIO::ImageSpec spec = encode_spec(job);
  output.handle->threads(1);
  output.handle->set_ioproxy(&proxy);
  const auto require_ok = [&](bool ok) {
    if (!ok) core::refuse(SHD_ERROR_IO, "cannot encode %s: %s", job.writer, printable(output.error()).c_str());
  };
  require_ok(output.handle->open(std::string("memory.") + job.writer, spec));
  inside.reset();
  std::vector<unsigned char> row(spec.scanline_bytes(true));
  const auto stride = static_cast<OIIO::stride_t>(spec.pixel_bytes(true));
  for (uint32_t y = 0; y < job.height; ++y) {
    job.row(job.user_data, y, row.data());
    const core::ForkGate::Scope row_inside(g_image_files);
    require_ok(output.handle->write_scanline(static_cast<int>(y), 0, OIIO::TypeUnknown, row.data(), stride));
  }
  inside.emplace(g_image_files);
  require_ok(output.handle->close());
  output.handle.reset();
  return bytes;
}

}  // namespace shd::io
