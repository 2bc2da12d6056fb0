// SPDX-License-Identifier: MIT
#include <shd/io.h>

#include <new>

#include "io/abi/common.h"
#include "io/abi/loads.h"

namespace {

using namespace shd;
using namespace shd::extension;

constexpr uint32_t kBitmapType = 0x424d4150;  // 'BMAP'

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
  const void* body = shd_object_get_body(reinterpret_cast<const shd_object*>(bitmap), kBitmapType);
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
  const shd_load_desc& desc = request.desc;
  if (desc.raw || desc.stack || desc.vdb || desc.info || desc.vdb_info) {
    refuse(SHD_ERROR_UNSUPPORTED, "load.%s: set, but a bitmap has no such desc",
           desc.raw     ? "raw"
           : desc.stack ? "stack"
           : desc.vdb   ? "vdb"
           : desc.info  ? "info"
                        : "vdb_info");
  }
  request.options.flags &= ~uint32_t{SHD_LOAD_FILE_LEVELS};
  return request;
}

/// The pixels of a file: of an image, or of the first level of a texture.
io::Bitmap load_pixels(shd_context* context, const Input& input, const LoadRequest& request) {
  io::Bitmap bitmap = load_bitmap(context, input, request);
  if (request.desc.flags & SHD_LOAD_LINEAR) make_linear(memory_of(context), &bitmap);
  return bitmap;
}

/// The descs of a load, which exclude each other, and its outputs.
void check_texture_desc(const shd_load_desc& desc) {
  if (desc.info) require(begin_output("load.info", desc.info));
  if (desc.vdb_info) require(begin_output("load.vdb_info", desc.vdb_info));
  const char* const other = desc.stack ? "stack" : "vdb";
  if (desc.raw && (desc.stack || desc.vdb)) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "load.raw: given together with load.%s", other);
  }
  if (desc.stack && desc.vdb) refuse(SHD_ERROR_INVALID_ARGUMENT, "load.stack: given together with load.vdb");
  if (desc.flags & SHD_LOAD_LINEAR) {
    refuse(SHD_ERROR_UNSUPPORTED, "load.flags: SHD_LOAD_LINEAR, but textures are always linear");
  }
}

/// A texture of a file that is neither voxels nor a stack.
shd_result load_by_content(shd_context* context, const Input& input, LoadRequest request, shd_texture** out_texture) {
  if (request.desc.vdb) return load_grid_texture(context, input, request, out_texture);
  switch (container_of(input)) {
    case io::Container::kGrid: return load_grid_texture(context, input, request, out_texture);
    case io::Container::kTexture: return load_stored_texture(context, input, request, out_texture);
    default: return load_image_texture(context, input, request, out_texture);
  }
}

/// Both loads of textures; `open(request)` gives the input.
template <class Open>
shd_result load_texture(shd_context* context, bool has_source, const shd_load_desc* desc, shd_texture** out_texture,
                        Open&& open) {
  if (!out_texture) return fail(SHD_ERROR_INVALID_ARGUMENT, "out_texture: NULL");
  *out_texture = nullptr;
  require_context(context);
  const LoadRequest request = read_load_desc(desc);
  check_texture_desc(request.desc);
  if (request.desc.stack) {
    if (has_source) refuse(SHD_ERROR_INVALID_ARGUMENT, "load.stack: given together with a path or bytes");
    return load_stack_texture(context, request, out_texture);
  }
  const Input input = open(request);
  return with_path(input, [&] {
    return request.desc.raw ? load_raw_texture(context, input, request, out_texture)
                            : load_by_content(context, input, request, out_texture);
  });
}

}  // namespace

extern "C" {

shd_result shd_bitmap_load(shd_context* context, const char* path, const shd_load_desc* desc, shd_bitmap** out_bitmap) {
  return guard([&]() -> shd_result {
    if (!out_bitmap) return fail(SHD_ERROR_INVALID_ARGUMENT, "out_bitmap: NULL");
    *out_bitmap = nullptr;
    require_context(context);
    const LoadRequest request = read_bitmap_load(desc);
    const Input input = open_input(path, request);
    *out_bitmap = make_bitmap(context, with_path(input, [&] { return load_pixels(context, input, request); }));
    return SHD_OK;
  });
}

shd_result shd_bitmap_load_memory(shd_context* context, const void* bytes, size_t size, const shd_load_desc* desc,
                                  shd_bitmap** out_bitmap) {
  return guard([&]() -> shd_result {
    if (!out_bitmap) return fail(SHD_ERROR_INVALID_ARGUMENT, "out_bitmap: NULL");
    *out_bitmap = nullptr;
    require_context(context);
    const LoadRequest request = read_bitmap_load(desc);
    *out_bitmap = make_bitmap(context, load_pixels(context, memory_input(bytes, size, request), request));
    return SHD_OK;
  });
}

void shd_bitmap_retain(shd_bitmap* bitmap) {
  shd_object_retain(reinterpret_cast<shd_object*>(bitmap), kBitmapType);
}

void shd_bitmap_release(shd_bitmap* bitmap) {
  shd_object_release(reinterpret_cast<shd_object*>(bitmap), kBitmapType);
}

shd_result shd_bitmap_get_image(const shd_bitmap* bitmap, shd_image* out_image) {
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

const char* shd_bitmap_get_color_space(const shd_bitmap* bitmap) {
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
    return load_texture(context, path != nullptr, desc, out_texture,
                        [&](const LoadRequest& request) { return open_input(path, request); });
  });
}

shd_result shd_texture_load_memory(shd_context* context, const void* bytes, size_t size, const shd_load_desc* desc,
                                   shd_texture** out_texture) {
  return guard([&]() -> shd_result {
    return load_texture(context, true, desc, out_texture,
                        [&](const LoadRequest& request) { return memory_input(bytes, size, request); });
  });
}

}  // extern "C"
