// SPDX-License-Identifier: MIT
#include <shd/io.h>

#include <cmath>
#include <cstring>
#include <new>

#include "abi/io/common.h"
#include "io/io.h"
#include "io/isolate.h"
#include "io/levels.h"
#include "io/load.h"
#include "io/printable.h"
#include "io/read_file.h"
#include "io/transfer.h"

namespace {

using namespace shd;
using namespace shd::extension;

constexpr uint32_t kBitmapType = 0x424d4150;  // 'BMAP'
constexpr uint32_t kMaxLevels = 16;           // below a base of io::kMaxSide

/// Body of a shd_bitmap, in memory of its context.
struct BitmapBody {
  shd_context* context;
  io::Bitmap bitmap;
};

void destroy_bitmap(void* memory) {
  auto* body = static_cast<BitmapBody*>(memory);
  shd_context* context = body->context;
  body->~BitmapBody();
  shd_context_free(context, memory, sizeof(BitmapBody), alignof(BitmapBody));
}

const BitmapBody* body_of(const shd_bitmap* bitmap) {
  const void* body = shd_object_body(reinterpret_cast<const shd_object*>(bitmap), kBitmapType);
  if (!body) {
    (void)fail(SHD_ERROR_INVALID_ARGUMENT, "bitmap: %s", bitmap ? "not a live handle of its type" : "NULL");
  }
  return static_cast<const BitmapBody*>(body);
}

shd_bitmap* make_bitmap(shd_context* context, io::Bitmap&& bitmap) {
  void* memory = shd_context_allocate(context, sizeof(BitmapBody), alignof(BitmapBody));
  if (!memory) throw std::bad_alloc();
  auto* body = ::new (memory) BitmapBody{context, std::move(bitmap)};
  shd_object* object = nullptr;
  const shd_result result = shd_object_create(context, kBitmapType, body, destroy_bitmap, &object);
  if (result != SHD_OK) destroy_bitmap(body);
  require(result);
  return reinterpret_cast<shd_bitmap*>(object);
}

void require_flags(const char* field, uint32_t value, uint32_t known) {
  if (value & ~known) refuse(SHD_ERROR_UNSUPPORTED, "%s: bits 0x%x are not known", field, value & ~known);
}

/// A budget where 0 is the default and everything else must be positive and finite.
double positive(const char* field, double value, double standard) {
  if (value == 0) return standard;
  if (!(value > 0) || !std::isfinite(value)) refuse(SHD_ERROR_INVALID_ARGUMENT, "%s: %g is not positive", field, value);
  return value;
}

/// A load desc, read and checked.
struct LoadRequest {
  shd_load_desc desc = shd_load_desc_default();
  io::LoadOptions options;
};

LoadRequest read_load_desc(const shd_load_desc* in) {
  LoadRequest request;
  shd_load_desc& desc = request.desc;
  read_desc("load", in, &desc);
  constexpr uint32_t kFormats = 0x1fff | SHD_FILE_FORMAT_ANY;
  require_flags("load.formats", desc.formats, kFormats);
  require_flags("load.flags", desc.flags,
                SHD_LOAD_IN_PROCESS | SHD_LOAD_PARTIAL | SHD_LOAD_FLIP_V | SHD_LOAD_FILE_LEVELS);
  if (static_cast<uint32_t>(desc.color_space) > SHD_COLOR_ENCODING_DATA) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "load.color_space: %d is not a shd_color_encoding",
           static_cast<int>(desc.color_space));
  }
  if (desc.subimage > 65535) refuse(SHD_ERROR_INVALID_ARGUMENT, "load.subimage: %u is not in 0..65535", desc.subimage);
  if (desc.worker_path && !*desc.worker_path) refuse(SHD_ERROR_INVALID_ARGUMENT, "load.worker_path: empty");
  io::LoadOptions& options = request.options;
  if (desc.formats) options.formats = desc.formats;
  options.flags = desc.flags;
  options.encoding = desc.color_space;
  options.subimage = desc.subimage;
  io::Limits& limits = options.limits;
  if (desc.max_file_bytes) limits.file_bytes = desc.max_file_bytes;
  if (desc.max_pixels) limits.pixels = desc.max_pixels;
  if (desc.max_bytes) limits.bytes = desc.max_bytes;
  limits.ratio = positive("load.max_ratio", desc.max_ratio, limits.ratio);
  limits.seconds = positive("load.time_limit", desc.time_limit, limits.seconds);
  return request;
}

/// A load desc of a bitmap, which has the base level alone.
LoadRequest read_bitmap_load(const shd_load_desc* in) {
  LoadRequest request = read_load_desc(in);
  request.options.flags &= ~uint32_t{SHD_LOAD_FILE_LEVELS};
  return request;
}

LoadRequest read_texture_load(const shd_load_desc* in) {
  const LoadRequest request = read_load_desc(in);
  if ((request.desc.flags & SHD_LOAD_FILE_LEVELS) && !(request.desc.tables & SHD_TABLE_MIPMAP)) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "load.flags: SHD_LOAD_FILE_LEVELS, but load.tables 0x%x has no SHD_TABLE_MIPMAP",
           request.desc.tables);
  }
  return request;
}

bool in_process(const LoadRequest& request) {
  return (request.desc.flags & SHD_LOAD_IN_PROCESS) != 0;
}

io::Bitmap load_path(shd_context* context, const char* path, const LoadRequest& request) {
  require_path(path);
  const io::OpenFile file = io::open_file(path, request.options.limits);
  const io::Deadline deadline(request.options.limits.seconds);
  const io::Memory memory = memory_of(context);
  try {
    if (!in_process(request)) {
      const io::Source source = {file.file.fd, nullptr, file.size};
      return io::load_isolated(request.desc.worker_path, source, request.options, memory, deadline);
    }
    const io::Buffer bytes = io::read_bytes(file.file.fd, file.size, memory);
    return io::load(bytes.data(), bytes.size(), request.options, memory, deadline, nullptr);
  } catch (const Failure& failure) {
    refuse(failure.code, "\"%s\": %s", io::printable(path).c_str(), failure.what());
  }
}

/// A file in the caller's memory. Its header is checked before a copy or a worker costs anything.
io::Bitmap load_copy(shd_context* context, const void* bytes, size_t size, const LoadRequest& request) {
  if (!bytes) refuse(SHD_ERROR_INVALID_ARGUMENT, "bytes: NULL");
  if (size > request.options.limits.file_bytes) {
    refuse(SHD_ERROR_LIMIT, "size: %zu bytes are above load.max_file_bytes %llu", size,
           static_cast<unsigned long long>(request.options.limits.file_bytes));
  }
  const auto* data = static_cast<const unsigned char*>(bytes);
  const io::Deadline deadline(request.options.limits.seconds);
  const io::Memory memory = memory_of(context);
  io::accept(data, size, request.options);
  if (!in_process(request)) {
    const io::Source source = {-1, data, size};
    return io::load_isolated(request.desc.worker_path, source, request.options, memory, deadline);
  }
  const io::Buffer copy(memory, size);
  std::memcpy(copy.data(), data, size);
  return io::load(copy.data(), size, request.options, memory, deadline, nullptr);
}

/// Texels of all levels of a bitmap whose numbers no texture format means, linear.
io::Buffer linear_texels(const io::Bitmap& bitmap, const io::Memory& memory) {
  const io::Transfer transfer = io::transfer_of(bitmap.color_space);
  if (transfer.curve == io::Curve::kUnknown) {
    refuse(SHD_ERROR_UNSUPPORTED, "colour space \"%s\" of the file is not known: set load.color_space",
           bitmap.color_space);
  }
  const auto pixels = static_cast<size_t>(io::level_pixels(bitmap.width, bitmap.height, bitmap.level_count));
  const bool as_stored = transfer.curve == io::Curve::kLinear && bitmap.format != SHD_FORMAT_RGBA16;
  if (as_stored || bitmap.format == SHD_FORMAT_RGBA8_SRGB) return io::Buffer();
  io::Buffer texels(memory, pixels * 16);
  io::linearise(transfer, bitmap.format, bitmap.pixels.data(), pixels, reinterpret_cast<float*>(texels.data()));
  return texels;
}

shd_result make_texture(shd_context* context, const io::Bitmap& bitmap, uint32_t tables, shd_texture** out_texture) {
  const io::Buffer linear = linear_texels(bitmap, memory_of(context));
  shd_texture_desc texture = shd_texture_desc_default();
  texture.format = linear.size() ? SHD_FORMAT_RGBA32F : bitmap.format;
  texture.width = bitmap.width;
  texture.height = bitmap.height;
  texture.texels = linear.size() ? linear.data() : bitmap.pixels.data();
  texture.tables = tables;
  shd_image levels[kMaxLevels];
  texture.level_count = bitmap.level_count - 1;
  texture.levels = bitmap.level_count > 1 ? levels : nullptr;
  const size_t pixel = shd_format_size(texture.format);
  const auto* next = static_cast<const unsigned char*>(texture.texels);
  for (uint32_t l = 1; l < bitmap.level_count; ++l) {
    next += pixel * io::level_side(bitmap.width, l - 1) * io::level_side(bitmap.height, l - 1);
    shd_image& level = levels[l - 1] = shd_image_default();
    level.format = texture.format;
    level.width = io::level_side(bitmap.width, l);
    level.height = io::level_side(bitmap.height, l);
    level.pixels = const_cast<unsigned char*>(next);
  }
  return shd_texture_create(context, &texture, out_texture);
}

}  // namespace

extern "C" {

shd_result shd_bitmap_load(shd_context* context, const char* path, const shd_load_desc* desc, shd_bitmap** out_bitmap) {
  return guard([&]() -> shd_result {
    if (!out_bitmap) return fail(SHD_ERROR_INVALID_ARGUMENT, "out_bitmap: NULL");
    *out_bitmap = nullptr;
    require_context(context);
    *out_bitmap = make_bitmap(context, load_path(context, path, read_bitmap_load(desc)));
    return SHD_OK;
  });
}

shd_result shd_bitmap_load_memory(shd_context* context, const void* bytes, size_t size, const shd_load_desc* desc,
                                  shd_bitmap** out_bitmap) {
  return guard([&]() -> shd_result {
    if (!out_bitmap) return fail(SHD_ERROR_INVALID_ARGUMENT, "out_bitmap: NULL");
    *out_bitmap = nullptr;
    require_context(context);
    *out_bitmap = make_bitmap(context, load_copy(context, bytes, size, read_bitmap_load(desc)));
    return SHD_OK;
  });
}

void shd_bitmap_retain(shd_bitmap* bitmap) {
  shd_object_retain(reinterpret_cast<shd_object*>(bitmap), kBitmapType);
}

void shd_bitmap_release(shd_bitmap* bitmap) {
  shd_object_release(reinterpret_cast<shd_object*>(bitmap), kBitmapType);
}

shd_result shd_bitmap_image(const shd_bitmap* bitmap, shd_image* out_image) {
  if (const shd_result result = begin_output("out_image", out_image)) return result;
  const BitmapBody* body = body_of(bitmap);
  if (!body) return SHD_ERROR_INVALID_ARGUMENT;
  shd_image image = shd_image_default();
  image.format = body->bitmap.format;
  image.width = body->bitmap.width;
  image.height = body->bitmap.height;
  image.pixels = body->bitmap.pixels.data();
  image.row_stride = body->bitmap.width * io::bitmap_pixel_size(body->bitmap.format);
  write_desc(image, out_image);
  return SHD_OK;
}

const char* shd_bitmap_color_space(const shd_bitmap* bitmap) {
  const BitmapBody* body = body_of(bitmap);
  return body ? body->bitmap.color_space : "";
}

shd_result shd_bitmap_get_info(const shd_bitmap* bitmap, shd_bitmap_info* out_info) {
  if (const shd_result result = begin_output("out_info", out_info)) return result;
  const BitmapBody* body = body_of(bitmap);
  if (!body) return SHD_ERROR_INVALID_ARGUMENT;
  write_desc(body->bitmap.info, out_info);
  return SHD_OK;
}

shd_result shd_texture_load(shd_context* context, const char* path, const shd_load_desc* desc,
                            shd_texture** out_texture) {
  return guard([&]() -> shd_result {
    if (!out_texture) return fail(SHD_ERROR_INVALID_ARGUMENT, "out_texture: NULL");
    *out_texture = nullptr;
    require_context(context);
    const LoadRequest request = read_texture_load(desc);
    return make_texture(context, load_path(context, path, request), request.desc.tables, out_texture);
  });
}

shd_result shd_texture_load_memory(shd_context* context, const void* bytes, size_t size, const shd_load_desc* desc,
                                   shd_texture** out_texture) {
  return guard([&]() -> shd_result {
    if (!out_texture) return fail(SHD_ERROR_INVALID_ARGUMENT, "out_texture: NULL");
    *out_texture = nullptr;
    require_context(context);
    const LoadRequest request = read_texture_load(desc);
    return make_texture(context, load_copy(context, bytes, size, request), request.desc.tables, out_texture);
  });
}

}  // extern "C"
