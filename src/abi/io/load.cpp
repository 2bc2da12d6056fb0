// SPDX-License-Identifier: MIT
#include <shd/io.h>

#include <cstring>
#include <new>

#include "abi/io/common.h"
#include "abi/io/request.h"
#include "io/io.h"
#include "io/isolate.h"
#include "io/levels.h"
#include "io/load.h"
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
