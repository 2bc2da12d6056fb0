// SPDX-License-Identifier: MIT
#include <shd/io.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "core/simd_name.h"
#include "extension/color_planes.h"
#include "io/abi/common.h"
#include "io/abi/plane_rows.h"
#include "io/abi/save_extras.h"
#include "io/codec/codec.h"
#include "io/file/printable.h"
#include "io/file/write_file.h"

namespace {

using namespace shd;
using namespace shd::extension;
using io::EncodeJob;
using io::Sample;

/// The kind of file that an extension names.
enum class Kind { kPng, kJpeg, kExr, kHdr, kTiff, kTga, kBmp };
struct Extension {
  const char* text;
  Kind kind;
  const char* writer;
};
constexpr Extension kExtensions[] = {
    {".png", Kind::kPng, "png"},     {".jpg", Kind::kJpeg, "jpeg"}, {".jpeg", Kind::kJpeg, "jpeg"},
    {".exr", Kind::kExr, "openexr"}, {".hdr", Kind::kHdr, "hdr"},   {".tif", Kind::kTiff, "tiff"},
    {".tiff", Kind::kTiff, "tiff"},  {".tga", Kind::kTga, "targa"}, {".bmp", Kind::kBmp, "bmp"},
};

const Extension& extension_of(const char* path) {
  const std::string whole(path);
  const size_t dot = whole.rfind('.');
  std::string text = dot == std::string::npos || whole.find('/', dot) != std::string::npos ? "" : whole.substr(dot);
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + ('a' - 'A'));
  }
  for (const Extension& extension : kExtensions) {
    if (text == extension.text) return extension;
  }
  refuse(SHD_ERROR_UNSUPPORTED,
         "path: extension \"%s\" is not .png, .jpg, .jpeg, .exr, .hdr, .tif, .tiff, .tga or .bmp",
         io::printable(text).c_str());
}

shd_save_desc read_save_desc(const shd_save_desc* in) {
  shd_save_desc desc = shd_save_desc_default();
  read_desc("save", in, &desc);
  if (static_cast<uint32_t>(desc.encoding) > SHD_COLOR_ENCODING_DATA) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "save.encoding: %d is not a shd_color_encoding",
           static_cast<int>(desc.encoding));
  }
  if (core::enum_bits(desc.dither) > SHD_DITHER_ORDERED) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "save.dither: %u is not a shd_dither", core::enum_bits(desc.dither));
  }
  return desc;
}

/// Compressions of a kind of files, between spaces; null = none to choose.
const char* compressions_of(Kind kind) {
  switch (kind) {
    case Kind::kExr: return " none rle zips zip piz b44 b44a dwaa dwab ";
    case Kind::kTiff: return " none lzw zip packbits ";
    default: return nullptr;
  }
}

std::string compression_of(const Extension& extension, const char* wanted) {
  if (extension.kind == Kind::kJpeg) {
    const std::string quality = wanted ? wanted : "95";
    const bool digits = quality.find_first_not_of("0123456789") == std::string::npos;
    const int number = digits && quality.size() < 4 ? std::atoi(quality.c_str()) : 0;
    if (number >= 1 && number <= 100) return "jpeg:" + std::to_string(number);
    refuse(SHD_ERROR_INVALID_ARGUMENT, "save.compression: \"%s\" is not a quality of 1..100, for JPEG",
           io::printable(quality).c_str());
  }
  if (!wanted) return "";
  const char* const known = compressions_of(extension.kind);
  if (!known) refuse(SHD_ERROR_INVALID_ARGUMENT, "save.compression: %s has none to choose", extension.text);
  const std::string text(wanted);
  if (text.empty() || text.find(' ') != std::string::npos || !std::strstr(known, (" " + text + " ").c_str())) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "save.compression: \"%s\" is not one of%sof %s", io::printable(text).c_str(),
           known, extension.text);
  }
  return text;
}

void save(const EncodeJob& job, const char* path) {
  const std::vector<unsigned char> bytes = io::encode(job);
  io::write_file(path, bytes.data(), bytes.size());
}

// Framebuffers.

constexpr int kPlaneCount = SHD_PLANE_TARGET3_A + 1;

/// Planes as channels of a file, by shd_plane.
constexpr struct {
  const char* name;
  uint32_t aov;  // 0 = every framebuffer has it
} kPlanes[kPlaneCount] = {
    {"R", 0},
    {"G", 0},
    {"B", 0},
    {"A", 0},
    {"Z", 0},
    {"uv.u", SHD_AOV_UV},
    {"uv.v", SHD_AOV_UV},
    {"N.x", SHD_AOV_NORMAL},
    {"N.y", SHD_AOV_NORMAL},
    {"N.z", SHD_AOV_NORMAL},
    {"triangle", SHD_AOV_TRIANGLE},
    {"P.x", SHD_AOV_POSITION},
    {"P.y", SHD_AOV_POSITION},
    {"P.z", SHD_AOV_POSITION},
    {"uv.dudx", SHD_AOV_DERIVATIVES},
    {"uv.dvdx", SHD_AOV_DERIVATIVES},
    {"uv.dudy", SHD_AOV_DERIVATIVES},
    {"uv.dvdy", SHD_AOV_DERIVATIVES},
    {"bary.0", SHD_AOV_BARYCENTRICS},
    {"bary.1", SHD_AOV_BARYCENTRICS},
    {"bary.2", SHD_AOV_BARYCENTRICS},
    {"lod", SHD_AOV_LEVEL},
    {"level", SHD_AOV_LEVEL},
    {"draw", SHD_AOV_DRAW},
    {"overdraw", SHD_AOV_OVERDRAW},
    {"target1.R", SHD_AOV_TARGET1},
    {"target1.G", SHD_AOV_TARGET1},
    {"target1.B", SHD_AOV_TARGET1},
    {"target1.A", SHD_AOV_TARGET1},
    {"target2.R", SHD_AOV_TARGET2},
    {"target2.G", SHD_AOV_TARGET2},
    {"target2.B", SHD_AOV_TARGET2},
    {"target2.A", SHD_AOV_TARGET2},
    {"target3.R", SHD_AOV_TARGET3},
    {"target3.G", SHD_AOV_TARGET3},
    {"target3.B", SHD_AOV_TARGET3},
    {"target3.A", SHD_AOV_TARGET3},
};

/// Planes of a framebuffer by shd_plane; absent ones are all null.
struct Planes {
  shd_plane_view view[kPlaneCount] = {};
};

Planes view_planes(const shd_framebuffer* framebuffer, const shd_framebuffer_info& info,
                   const extension::ColorPlanes& color) {
  Planes planes;
  for (int c = 0; c < 4; ++c) planes.view[c] = color.view[c];
  for (int plane = SHD_PLANE_DEPTH; plane < kPlaneCount; ++plane) {
    if (kPlanes[plane].aov && !(info.aovs & kPlanes[plane].aov)) continue;
    planes.view[plane] = shd_plane_view_default();
    require(shd_framebuffer_view_plane(framebuffer, static_cast<shd_plane>(plane), &planes.view[plane]));
  }
  return planes;
}

/// The first `count` planes as they are; colour is half if `depth` is 16.
void describe_planes(const Planes& planes, int count, uint32_t depth, io::PlaneRows* rows, EncodeJob* job) {
  rows->width = job->width;
  for (int plane = 0; plane < count; ++plane) {
    const shd_plane_view& view = planes.view[plane];
    if (!view.f32 && !view.u32) continue;
    const Sample sample = view.u32                              ? Sample::kU32
                          : depth == 16 && plane <= SHD_PLANE_A ? Sample::kHalf
                                                                : Sample::kFloat;
    rows->channels.push_back({view, sample});
    job->channels.push_back({kPlanes[plane].name, sample});
  }
  job->alpha = count > SHD_PLANE_A ? 3 : -1;
  job->row = io::plane_row;
  job->user_data = rows;
}

void describe_color(EncodeJob* job, Sample sample, int channels) {
  constexpr const char* kNames[4] = {"R", "G", "B", "A"};
  for (int i = 0; i < channels; ++i) job->channels.push_back({kNames[i], sample});
  job->alpha = channels == 4 ? 3 : -1;
}

void describe_codes(const Planes& planes, uint32_t depth, const shd_save_desc& desc, io::CodeRows* rows,
                    EncodeJob* job) {
  rows->width = job->width;
  rows->bits = depth;
  std::copy(planes.view, planes.view + 4, rows->plane);
  rows->curve = desc.encoding == SHD_COLOR_ENCODING_AUTO || desc.encoding == SHD_COLOR_ENCODING_SRGB;
  rows->dither = desc.dither == SHD_DITHER_ORDERED;
  rows->over_black = std::strcmp(job->writer, "jpeg") == 0;
  describe_color(job, depth == 8 ? Sample::kU8 : Sample::kU16, rows->over_black ? 3 : 4);
  job->straight = true;
  job->color_space = rows->curve ? "sRGB" : "Linear";
  job->row = io::code_row;
  job->user_data = rows;
}

uint32_t depth_for(const Extension& extension, uint32_t wanted) {
  const bool png = extension.kind == Kind::kPng, jpeg = extension.kind == Kind::kJpeg;
  const bool exr = extension.kind == Kind::kExr;
  const bool tiff = extension.kind == Kind::kTiff;
  if (!png && !jpeg && !exr && !tiff && extension.kind != Kind::kHdr) {
    refuse(SHD_ERROR_UNSUPPORTED, "path: a framebuffer cannot be saved as %s", extension.text);
  }
  if (wanted == 0) return png || jpeg ? 8 : exr ? 16 : 32;
  const bool known = (wanted == 8 && (png || jpeg || tiff)) || (wanted == 16 && (png || exr || tiff)) ||
                     (wanted == 32 && !png && !jpeg);
  if (!known) refuse(SHD_ERROR_INVALID_ARGUMENT, "save.bit_depth: %u is not one that %s has", wanted, extension.text);
  return wanted;
}

/// Lets the caller's display make encoded pixels of the framebuffer.
io::Buffer show(const shd_framebuffer* framebuffer, const shd_display& display, const EncodeJob& job) {
  shd_image image = shd_image_default();
  image.format = SHD_FORMAT_RGBA32F;
  image.width = job.width;
  image.height = job.height;
  const size_t size = size_t{16} * job.width * job.height;
  io::Buffer pixels(memory_of(shd_framebuffer_get_context(framebuffer)), size);
  std::memset(pixels.data(), 0, size);
  image.pixels = pixels.data();
  require(display.apply(framebuffer, &image, display.user_data));
  return pixels;
}

/// Adds the matrices of a view, and replaces the plane of depth by one of distances, whose memory it returns.
io::Buffer add_view(const shd_framebuffer* framebuffer, const shd_view& view, shd_plane_view* plane, EncodeJob* job) {
  io::add_matrices(view, job);
  const io::Memory memory = memory_of(shd_framebuffer_get_context(framebuffer));
  io::Buffer distances = io::make_distances(view, *plane, job->width, job->height, memory);
  plane->f32 = reinterpret_cast<const float*>(distances.data());
  plane->row_stride = sizeof(float) * job->width;
  return distances;
}

void save_framebuffer(const shd_framebuffer* framebuffer, const char* path, const shd_save_desc& desc) {
  const Extension& extension = extension_of(path);
  const uint32_t depth = depth_for(extension, desc.bit_depth);
  EncodeJob job;
  job.writer = extension.writer;
  shd_framebuffer_info info = shd_framebuffer_info_default();
  require(shd_framebuffer_get_info(framebuffer, &info));
  job.width = info.width;
  job.height = info.height;
  const extension::ColorPlanes color(framebuffer, info);
  Planes planes = view_planes(framebuffer, info, color);
  job.compression = compression_of(extension, desc.compression);
  io::PlaneRows plane_rows;
  io::CodeRows code_rows;
  io::Buffer further;
  const bool is_exr = extension.kind == Kind::kExr;
  if (extension.kind == Kind::kHdr) {
    describe_planes(planes, 3, depth, &plane_rows, &job);
  } else if (is_exr || depth == 32) {
    if (is_exr && desc.view) further = add_view(framebuffer, *desc.view, &planes.view[SHD_PLANE_DEPTH], &job);
    describe_planes(planes, is_exr ? kPlaneCount : 4, depth, &plane_rows, &job);
    job.color_space = "Linear";
  } else {
    code_rows.simd = core::find_simd_target(shd_context_get_simd_target(shd_framebuffer_get_context(framebuffer)));
    describe_codes(planes, depth, desc, &code_rows, &job);
    if (desc.display.apply) further = show(framebuffer, desc.display, job);
    if (further.size()) code_rows.display = reinterpret_cast<const float*>(further.data());
  }
  io::add_channels(desc, is_exr, &plane_rows, &job);
  io::add_attributes(desc, is_exr, &job);
  save(job, path);
}

// Images.

bool takes(Kind kind, shd_format format) {
  const bool bytes = format == SHD_FORMAT_R8 || format == SHD_FORMAT_RGBA8 || format == SHD_FORMAT_RGBA8_SRGB;
  switch (kind) {
    case Kind::kPng: return bytes || format == SHD_FORMAT_RGBA16;
    case Kind::kExr: return format == SHD_FORMAT_RGBA16F || format == SHD_FORMAT_RGBA32F;
    case Kind::kHdr: return format == SHD_FORMAT_RGBA32F;
    case Kind::kTiff: return format != SHD_FORMAT_RGBA16F;  // OpenImageIO stores float instead
    case Kind::kJpeg: return false;                         // without alpha
    default: return bytes;
  }
}

Sample sample_of(shd_format format) {
  switch (format) {
    case SHD_FORMAT_RGBA16: return Sample::kU16;
    case SHD_FORMAT_RGBA16F: return Sample::kHalf;
    case SHD_FORMAT_RGBA32F: return Sample::kFloat;
    default: return Sample::kU8;
  }
}

const char* tag_of(shd_color_encoding encoding, shd_format format) {
  switch (encoding) {
    case SHD_COLOR_ENCODING_SRGB: return "sRGB";
    case SHD_COLOR_ENCODING_LINEAR:
    case SHD_COLOR_ENCODING_DATA: return "Linear";
    default: break;
  }
  if (format == SHD_FORMAT_RGBA8_SRGB) return "sRGB";
  return format == SHD_FORMAT_RGBA16F || format == SHD_FORMAT_RGBA32F ? "Linear" : "";
}

void image_row(const void* user_data, uint32_t y, unsigned char* out) {
  const auto& image = *static_cast<const shd_image*>(user_data);
  std::memcpy(out, static_cast<const char*>(image.pixels) + y * image.row_stride,
              image.width * shd_format_size(image.format));
}

/// Radiance files have no alpha.
void image_row_rgb(const void* user_data, uint32_t y, unsigned char* out) {
  const auto& image = *static_cast<const shd_image*>(user_data);
  const char* row = static_cast<const char*>(image.pixels) + y * image.row_stride;
  for (uint32_t x = 0; x < image.width; ++x) std::memcpy(out + x * 12, row + x * 16, 12);
}

void save_image(const shd_image& image, const char* path, const shd_save_desc& desc) {
  if (desc.bit_depth != 0)
    refuse(SHD_ERROR_INVALID_ARGUMENT, "save.bit_depth: %u is not 0, for an image", desc.bit_depth);
  if (desc.dither != SHD_DITHER_NONE) refuse(SHD_ERROR_INVALID_ARGUMENT, "save.dither: an image keeps its pixels");
  if (desc.display.apply) refuse(SHD_ERROR_INVALID_ARGUMENT, "save.display: an image keeps its pixels");
  if (desc.view) refuse(SHD_ERROR_INVALID_ARGUMENT, "save.view: an image has none");
  if (desc.channels) refuse(SHD_ERROR_INVALID_ARGUMENT, "save.channels: an image has its own alone");
  const Extension& extension = extension_of(path);
  if (!takes(extension.kind, image.format)) {
    refuse(SHD_ERROR_UNSUPPORTED, "image.format: pixels of format %d cannot be stored in %s as they are",
           static_cast<int>(image.format), extension.text);
  }
  EncodeJob job;
  job.writer = extension.writer;
  job.width = image.width;
  job.height = image.height;
  job.user_data = &image;
  job.straight = extension.kind != Kind::kExr;
  job.color_space = tag_of(desc.encoding, image.format);
  job.row = extension.kind == Kind::kHdr ? image_row_rgb : image_row;
  if (image.format == SHD_FORMAT_R8) {
    job.channels.push_back({"Y", Sample::kU8});
  } else {
    describe_color(&job, sample_of(image.format), extension.kind == Kind::kHdr ? 3 : 4);
  }
  job.compression = compression_of(extension, desc.compression);
  io::add_attributes(desc, extension.kind == Kind::kExr, &job);
  save(job, path);
}

}  // namespace

extern "C" {

shd_result shd_framebuffer_save(const shd_framebuffer* framebuffer, const char* path, const shd_save_desc* desc) {
  return guard([&]() -> shd_result {
    if (!framebuffer) return fail(SHD_ERROR_INVALID_ARGUMENT, "framebuffer: NULL");
    require_path(path);
    save_framebuffer(framebuffer, path, read_save_desc(desc));
    return SHD_OK;
  });
}

shd_result shd_image_save(const shd_image* image, const char* path, const shd_save_desc* desc) {
  return guard([&]() -> shd_result {
    const shd_image read = read_image("image", image);
    require_path(path);
    save_image(read, path, read_save_desc(desc));
    return SHD_OK;
  });
}

}  // extern "C"
