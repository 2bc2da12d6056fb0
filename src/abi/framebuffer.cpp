// SPDX-License-Identifier: MIT
#include <shd/extension.h>
#include <shd/framebuffer.h>

#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "film/framebuffer.h"
#include "film/planes.h"
#include "film/readback.h"
#include "image/pixels.h"
#include "raster/sample_pattern.h"

namespace {

using namespace shd;
using namespace shd::abi;
using film::Framebuffer;

constexpr core::ObjectType kFramebufferType = core::ObjectType::kFramebuffer;

shd_result check_samples(const char* field, uint64_t samples) {
  switch (samples) {
    case 1:
    case 2:
    case 4:
    case 8:
    case 16: return SHD_OK;
    default:
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: %llu is not 1, 2, 4, 8 or 16", field,
                        static_cast<unsigned long long>(samples));
  }
}

shd_result check_framebuffer_desc(const shd_framebuffer_desc& desc) {
  SHD_TRY(check_count("framebuffer.width", desc.width, 1, 16384));
  SHD_TRY(check_count("framebuffer.height", desc.height, 1, 16384));
  SHD_TRY(check_samples("framebuffer.sample_count", desc.sample_count));
  SHD_TRY(check_enum("framebuffer.color_format", desc.color_format, SHD_FORMAT_NONE, SHD_FORMAT_RGB32F));
  if (!film::can_draw(desc.color_format)) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT,
                      "framebuffer.color_format: %d is not RGBA32F, RGBA16F, RGBA8_SRGB or RGBA8",
                      static_cast<int>(desc.color_format));
  }
  return check_flags("framebuffer.aovs", desc.aovs, film::all_aovs());
}

shd_result read_framebuffer(const shd_framebuffer* handle, const Framebuffer** out) {
  return read_handle("framebuffer", handle, kFramebufferType, out);
}

shd_result check_plane_value(const shd_plane& plane) {
  return check_enum("plane", plane, SHD_PLANE_R, SHD_PLANE_TARGET3_A);
}

shd_result check_kind(const shd_plane& plane, bool is_integer) {
  if (film::kPlanes[plane].is_integer == is_integer) return SHD_OK;
  return core::fail(
      SHD_ERROR_INVALID_ARGUMENT, "plane: %d holds %s", static_cast<int>(plane),
      is_integer ? "floats; take shd_framebuffer_read_plane" : "integers; take shd_framebuffer_read_u32_plane");
}

shd_result check_plane(const Framebuffer& framebuffer, const shd_plane& plane) {
  if (film::has_plane(framebuffer, plane)) return SHD_OK;
  if (plane < SHD_PLANE_DEPTH) {
    return core::fail(SHD_ERROR_NOT_FOUND,
                      "plane: %d is not in memory of its own, because framebuffer.color_format is %d; take "
                      "shd_framebuffer_view_color or shd_framebuffer_read_plane",
                      static_cast<int>(plane), static_cast<int>(framebuffer.color_format));
  }
  return core::fail(SHD_ERROR_NOT_FOUND, "plane: %d is not among the framebuffer's aovs 0x%x", static_cast<int>(plane),
                    framebuffer.aovs);
}

size_t pixel_count(const Framebuffer& framebuffer) {
  return size_t{framebuffer.width} * framebuffer.height;
}

}  // namespace

extern "C" {

shd_result shd_framebuffer_create(shd_context* context, const shd_framebuffer_desc* desc,
                                  shd_framebuffer** out_framebuffer) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_not_null("out_framebuffer", out_framebuffer));
    *out_framebuffer = nullptr;
    SHD_TRY(check_context(context));
    shd_framebuffer_desc read = shd_framebuffer_desc_default();
    SHD_TRY(read_desc("framebuffer", desc, false, &read));
    SHD_TRY(check_framebuffer_desc(read));
    core::Context& owner = context_of(context);
    Framebuffer framebuffer{};
    film::build(owner, read, &framebuffer);
    make_handle(owner, kFramebufferType, core::create<Framebuffer>(owner.allocator, std::move(framebuffer)),
                out_framebuffer);
    return SHD_OK;
  });
}

void shd_framebuffer_retain(shd_framebuffer* framebuffer) {
  retain_handle(framebuffer, kFramebufferType);
}

void shd_framebuffer_release(shd_framebuffer* framebuffer) {
  release_handle(framebuffer, kFramebufferType);
}

shd_result shd_framebuffer_get_info(const shd_framebuffer* framebuffer, shd_framebuffer_info* out_info) {
  return guard([&]() -> shd_result {
    SHD_TRY(begin_output("out_info", out_info));
    const Framebuffer* body = nullptr;
    SHD_TRY(read_framebuffer(framebuffer, &body));
    shd_framebuffer_info info = shd_framebuffer_info_default();
    info.width = body->width;
    info.height = body->height;
    info.sample_count = body->samples;
    info.color_format = body->color_format;
    info.aovs = body->aovs;
    info.byte_size = film::byte_size(*body);
    write_desc(info, out_info);
    return SHD_OK;
  });
}

shd_result shd_sample_position(size_t sample_count, size_t index, float* out_x, float* out_y) {
  return guard([&]() -> shd_result {
    if (out_x) *out_x = 0.0f;
    if (out_y) *out_y = 0.0f;
    SHD_TRY(check_samples("sample_count", sample_count));
    SHD_TRY(check_count("index", index, 0, sample_count - 1));
    SHD_TRY(check_not_null("out_x", out_x));
    SHD_TRY(check_not_null("out_y", out_y));
    const raster::SamplePoint& point = raster::sample_pattern(static_cast<uint32_t>(sample_count)).point[index];
    *out_x = static_cast<float>(point.x) / geometry::kSubpixels;
    *out_y = static_cast<float>(point.y) / geometry::kSubpixels;
    return SHD_OK;
  });
}

shd_result shd_framebuffer_view_plane(const shd_framebuffer* framebuffer, shd_plane plane, shd_plane_view* out_view) {
  return guard([&]() -> shd_result {
    SHD_TRY(begin_output("out_view", out_view));
    const Framebuffer* body = nullptr;
    SHD_TRY(read_framebuffer(framebuffer, &body));
    SHD_TRY(check_plane_value(plane));
    SHD_TRY(check_plane(*body, plane));
    shd_plane_view view = shd_plane_view_default();
    view.row_stride = body->stride * sizeof(float);
    if (film::kPlanes[plane].is_integer) {
      view.u32 = body->u32_plane[plane].data();
    } else {
      view.f32 = body->plane[plane].data();
    }
    write_desc(view, out_view);
    return SHD_OK;
  });
}

shd_result shd_framebuffer_view_color(const shd_framebuffer* framebuffer, shd_image* out_view) {
  return guard([&]() -> shd_result {
    SHD_TRY(begin_output("out_view", out_view));
    const Framebuffer* body = nullptr;
    SHD_TRY(read_framebuffer(framebuffer, &body));
    if (film::has_color_planes(*body)) {
      return core::fail(SHD_ERROR_NOT_FOUND,
                        "framebuffer: its colour is four planes, because framebuffer.color_format is RGBA32F; take "
                        "shd_framebuffer_view_plane");
    }
    shd_image view = shd_image_default();
    view.format = body->color_format;
    view.width = body->width;
    view.height = body->height;
    view.pixels = const_cast<uint8_t*>(body->pixels.data());
    view.row_stride = body->stride * shd_format_size(body->color_format);
    write_desc(view, out_view);
    return SHD_OK;
  });
}

shd_result shd_framebuffer_read_plane(const shd_framebuffer* framebuffer, shd_plane plane, const shd_f32_out* out) {
  return guard([&]() -> shd_result {
    const Framebuffer* body = nullptr;
    SHD_TRY(read_framebuffer(framebuffer, &body));
    SHD_TRY(check_plane_value(plane));
    SHD_TRY(check_kind(plane, false));
    if (plane >= SHD_PLANE_DEPTH) SHD_TRY(check_plane(*body, plane));
    SHD_TRY(check_not_null("out", out));
    SHD_TRY(check_not_null("out.data", out->data));
    SHD_TRY(check_column("out", *out, pixel_count(*body)));
    film::read_plane(*body, plane, *out);
    return SHD_OK;
  });
}

shd_result shd_framebuffer_read_u32_plane(const shd_framebuffer* framebuffer, shd_plane plane, const shd_u32_out* out) {
  return guard([&]() -> shd_result {
    const Framebuffer* body = nullptr;
    SHD_TRY(read_framebuffer(framebuffer, &body));
    SHD_TRY(check_plane_value(plane));
    SHD_TRY(check_kind(plane, true));
    SHD_TRY(check_plane(*body, plane));
    SHD_TRY(check_not_null("out", out));
    SHD_TRY(check_not_null("out.data", out->data));
    SHD_TRY(check_column("out", *out, pixel_count(*body)));
    film::read_u32_plane(*body, plane, *out);
    return SHD_OK;
  });
}

shd_result shd_framebuffer_read_color(const shd_framebuffer* framebuffer, const shd_image* out) {
  return guard([&]() -> shd_result {
    const Framebuffer* body = nullptr;
    SHD_TRY(read_framebuffer(framebuffer, &body));
    shd_image image;
    SHD_TRY(read_image("out", out, &image));
    if (!image::can_encode(image.format)) {
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "out.format: %d is not an RGBA format",
                        static_cast<int>(image.format));
    }
    if (image.width != body->width || image.height != body->height) {
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "out.%s: %ux%u is not the framebuffer's %ux%u",
                        image.width != body->width ? "width" : "height", image.width, image.height, body->width,
                        body->height);
    }
    film::read_color(context_of(shd_framebuffer_get_context(framebuffer)).simd, *body, image);
    return SHD_OK;
  });
}

}  // extern "C"
