// SPDX-License-Identifier: MIT
#include <shd/color.h>

#include <cstring>
#include <memory>
#include <string>
#include <type_traits>

#include <shd/extension.h>

#include "color/apply.h"
#include "color/baked_views.h"
#include "color/config.h"
#include "color/default_config.h"
#include "color/source.h"
#include "extension/color_planes.h"
#include "extension/desc.h"
#include "extension/guard.h"

namespace {

using namespace shd;
using extension::guard;
using extension::refuse;

constexpr uint32_t kColorType = 'C' << 24 | 'O' << 16 | 'L' << 8 | 'R';

struct Body {
  std::unique_ptr<color::Config> config;
  std::string working_space;
  shd_display_precision precision = SHD_DISPLAY_PRECISION_BAKED;
  std::unique_ptr<color::BakedViews> baked;
};

const shd_object* object_of(const shd_color* handle) {
  return reinterpret_cast<const shd_object*>(handle);
}
shd_object* object_of(shd_color* handle) {
  return reinterpret_cast<shd_object*>(handle);
}

const Body& body_of(const shd_color* handle) {
  if (!handle) refuse(SHD_ERROR_INVALID_ARGUMENT, "color: NULL");
  const void* body = shd_object_get_body(object_of(handle), kColorType);
  if (!body) refuse(SHD_ERROR_INVALID_ARGUMENT, "color: not a live handle of its type");
  return *static_cast<const Body*>(body);
}

/// Reads the bytes, because a load of an enum without such a value is undefined.
void check_precision(const shd_color_desc& desc) {
  uint32_t value;
  std::memcpy(&value, &desc.display_precision, sizeof value);
  if (value <= SHD_DISPLAY_PRECISION_EXACT) return;
  refuse(SHD_ERROR_INVALID_ARGUMENT,
         "color.display_precision: %u is not SHD_DISPLAY_PRECISION_BAKED or SHD_DISPLAY_PRECISION_EXACT",
         static_cast<unsigned>(value));
}

std::unique_ptr<Body> make_body(shd_context* context, const shd_color_desc& desc) {
  check_precision(desc);
  auto body = std::make_unique<Body>();
  body->precision = desc.display_precision;
  body->config = color::load_config(color::read_source(desc));
  body->working_space =
      body->config->space("color.working_space", desc.working_space ? desc.working_space : "scene_linear");
  body->baked = std::make_unique<color::BakedViews>(context, *body->config);
  return body;
}

/// `name` null = the working space.
std::string read_space(const Body& body, const char* field, const char* name) {
  return name ? body.config->space(field, name) : body.working_space;
}

color::ViewKey find_view(const Body& body, const std::string& from, const char* display_name, const char* view_name) {
  const color::Display& display = body.config->catalog().display(display_name);
  return {from, display.name, color::Catalog::view(display, view_name)};
}

/// Calls apply(Program) for 8-bit images of views that are baked, otherwise apply(Transform).
template <class Apply>
void with_transform(const Body& body, const color::ViewKey& key, shd_format format, const Apply& apply) {
  const color::TransformRef exact = body.config->to_display(key.from, key.display, key.view);
  const bool is_8_bit = format == SHD_FORMAT_RGBA8 || format == SHD_FORMAT_RGBA8_SRGB;
  const bool bakes = is_8_bit && body.precision == SHD_DISPLAY_PRECISION_BAKED;
  const color::Program* program = bakes ? body.baked->find(key, *exact) : nullptr;
  if (program) return apply(*program);
  apply(*exact);
}

shd_image read_float_image(const char* name, const shd_image* in) {
  const shd_image image = extension::read_image(name, in);
  if (image.format == SHD_FORMAT_RGBA16F || image.format == SHD_FORMAT_RGBA32F) return image;
  refuse(SHD_ERROR_INVALID_ARGUMENT, "%s.format: %d is not RGBA16F or RGBA32F", name, static_cast<int>(image.format));
}

shd_image read_output_image(const char* name, const shd_image* in, uint32_t width, uint32_t height) {
  const shd_image image = extension::read_image(name, in);
  if (image.format == SHD_FORMAT_R8) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "%s.format: %d has not four channels", name, static_cast<int>(image.format));
  }
  if (image.width != width || image.height != height) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "%s: %u x %u is not the input's %u x %u", name, image.width, image.height, width,
           height);
  }
  return image;
}

/// Refuses images that share pixels unless they are the same image.
void require_no_overlap(const shd_image& in, const shd_image& out) {
  const auto* in_begin = static_cast<const unsigned char*>(in.pixels);
  const auto* out_begin = static_cast<const unsigned char*>(out.pixels);
  const bool same = in_begin == out_begin && in.format == out.format && in.row_stride == out.row_stride;
  const auto bytes = [](const shd_image& image) {
    return image.row_stride * (image.height - 1) + shd_format_size(image.format) * image.width;
  };
  if (same || in_begin + bytes(in) <= out_begin || out_begin + bytes(out) <= in_begin) return;
  refuse(SHD_ERROR_INVALID_ARGUMENT, "out.pixels: overlaps in.pixels, but is not the same image");
}

/// Checks a framebuffer for a transform. Messages begin with `owner`, the desc that holds the framebuffer.
shd_framebuffer_info read_framebuffer(const char* owner, const shd_framebuffer* framebuffer,
                                      const shd_context* context) {
  if (!framebuffer) refuse(SHD_ERROR_INVALID_ARGUMENT, "%sframebuffer: NULL", owner);
  shd_framebuffer_info info = shd_framebuffer_info_default();
  const shd_result result = shd_framebuffer_get_info(framebuffer, &info);
  if (result != SHD_OK) refuse(result, "%s%s", owner, shd_last_error());
  if (shd_framebuffer_get_context(framebuffer) != context) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "%sframebuffer: of another context than color", owner);
  }
  return info;
}

/// Refuses an image that shares memory with the colour or the depth of a framebuffer.
void require_apart(const shd_framebuffer* framebuffer, const shd_framebuffer_info& info, const shd_image& image) {
  const auto check = [&](const void* pixels, size_t row_stride) {
    const auto *begin = static_cast<const unsigned char*>(pixels), *end = begin + row_stride * info.height;
    const auto* out = static_cast<const unsigned char*>(image.pixels);
    if (end <= out || out + image.row_stride * image.height <= begin) return;
    refuse(SHD_ERROR_INVALID_ARGUMENT, "out.pixels: overlaps render.framebuffer");
  };
  const bool has_planes = info.color_format == SHD_FORMAT_RGBA32F;
  for (int p = has_planes ? SHD_PLANE_R : SHD_PLANE_DEPTH; p <= SHD_PLANE_DEPTH; ++p) {
    shd_plane_view view = shd_plane_view_default();
    extension::require(shd_framebuffer_view_plane(framebuffer, static_cast<shd_plane>(p), &view));
    check(view.f32, view.row_stride);
  }
  if (has_planes) return;
  shd_image view = shd_image_default();
  extension::require(shd_framebuffer_view_color(framebuffer, &view));
  check(view.pixels, view.row_stride);
}

/// The frame of a call that sets the callback for tiles itself.
shd_render_desc read_render(const shd_render_desc* desc) {
  if (!desc) refuse(SHD_ERROR_INVALID_ARGUMENT, "render: NULL");
  shd_render_desc render = shd_render_desc_default();
  extension::read_desc("render", desc, &render);
  render.struct_size = sizeof render;
  if (render.present.tile) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "render.present.tile: set, but shd_color_render takes the tiles");
  }
  return render;
}

/// Target of the tiles of a frame: user_data of show_tile().
template <class Transform>
struct Screen {
  shd_context* context;
  const Transform& transform;
  const shd_image& out;
};

/// shd_present.tile that brings a tile to its rectangle of a screen.
template <class Transform>
shd_result show_tile(const shd_present_tile* tile, void* screen) {
  return guard([&]() -> shd_result {
    const auto& to = *static_cast<const Screen<Transform>*>(screen);
    color::Planes planes{{}, {}, tile->area.width, tile->area.height};
    for (int c = 0; c < 4; ++c) {
      planes.plane[c] = tile->channel[c];
      planes.row_stride[c] = tile->row_stride;
    }
    shd_image out = to.out;
    out.width = tile->area.width;
    out.height = tile->area.height;
    out.pixels = static_cast<unsigned char*>(to.out.pixels) + tile->area.y * to.out.row_stride +
                 tile->area.x * shd_format_size(to.out.format);
    color::apply_tile(to.context, to.transform, planes, out);
    return SHD_OK;
  });
}

color::Planes planes_of(const extension::ColorPlanes& colors, const shd_framebuffer_info& info) {
  color::Planes planes{{}, {}, info.width, info.height};
  for (int c = 0; c < 4; ++c) {
    planes.plane[c] = colors.view[c].f32;
    planes.row_stride[c] = colors.view[c].row_stride;
  }
  return planes;
}

/// The value that `find` returns, or `none` with an error text: for functions that return no result.
template <class Answer, class Find>
Answer ask(Answer none, Find&& find) {
  Answer answer = none;
  if (guard([&]() -> shd_result {
        answer = find();
        return SHD_OK;
      }) != SHD_OK) {
    return none;
  }
  return answer;
}

const char* name_at(const std::vector<std::string>& names, uint32_t index) {
  return index < names.size() ? names[index].c_str() : nullptr;
}

}  // namespace

extern "C" {

const char* shd_color_default_config(void) {
  return color::kDefaultConfig;
}

shd_result shd_color_create(shd_context* context, const shd_color_desc* desc, shd_color** out_color) {
  return guard([&]() -> shd_result {
    if (!out_color) refuse(SHD_ERROR_INVALID_ARGUMENT, "out_color: NULL");
    *out_color = nullptr;
    extension::require_context(context);
    shd_color_desc read = shd_color_desc_default();
    extension::read_desc("color", desc, &read);
    std::unique_ptr<Body> body = make_body(context, read);
    const auto destroy = [](void* memory) { delete static_cast<Body*>(memory); };
    shd_object* object = nullptr;
    extension::require(shd_object_create(context, kColorType, body.get(), destroy, &object));
    (void)body.release();
    *out_color = reinterpret_cast<shd_color*>(object);
    return SHD_OK;
  });
}

void shd_color_retain(shd_color* color) {
  shd_object_retain(object_of(color), kColorType);
}

void shd_color_release(shd_color* color) {
  shd_object_release(object_of(color), kColorType);
}

shd_result shd_color_apply_display(const shd_color* color, const shd_framebuffer* framebuffer, const char* display,
                                   const char* view, const shd_image* out) {
  return guard([&]() -> shd_result {
    const Body& body = body_of(color);
    shd_context* context = shd_object_get_context(object_of(color));
    const shd_framebuffer_info info = read_framebuffer("", framebuffer, context);
    const shd_image image = read_output_image("out", out, info.width, info.height);
    const color::ViewKey key = find_view(body, body.working_space, display, view);
    with_transform(body, key, image.format, [&](const auto& transform) {
      const extension::ColorPlanes colors(framebuffer, info);
      color::apply_planes(context, transform, planes_of(colors, info), image);
    });
    return SHD_OK;
  });
}

shd_result shd_color_apply_view(const shd_framebuffer* framebuffer, const shd_image* out, void* color_view) {
  return guard([&]() -> shd_result {
    if (!color_view) refuse(SHD_ERROR_INVALID_ARGUMENT, "color_view: NULL");
    const auto& view = *static_cast<const shd_color_view*>(color_view);
    return shd_color_apply_display(view.color, framebuffer, view.display, view.view, out);
  });
}

shd_result shd_color_render(const shd_color* color, const shd_render_desc* render, const char* display,
                            const char* view, const shd_image* out) {
  return guard([&]() -> shd_result {
    const Body& body = body_of(color);
    shd_context* context = shd_object_get_context(object_of(color));
    shd_render_desc frame = read_render(render);
    const shd_framebuffer_info info = read_framebuffer("render.", frame.framebuffer, context);
    const shd_image image = read_output_image("out", out, info.width, info.height);
    require_apart(frame.framebuffer, info, image);
    const color::ViewKey key = find_view(body, body.working_space, display, view);
    with_transform(body, key, image.format, [&](const auto& transform) {
      using Transform = std::remove_const_t<std::remove_reference_t<decltype(transform)>>;
      Screen<Transform> screen = {context, transform, image};
      frame.present = {show_tile<Transform>, &screen};
      extension::require(shd_render(context, &frame));
    });
    return SHD_OK;
  });
}

shd_result shd_color_apply_display_image(const shd_color* color, const shd_image* in, const char* from_space,
                                         const char* display, const char* view, const shd_image* out) {
  return guard([&]() -> shd_result {
    const Body& body = body_of(color);
    const shd_image source = read_float_image("in", in);
    const shd_image image = read_output_image("out", out, source.width, source.height);
    require_no_overlap(source, image);
    const std::string from = read_space(body, "from_space", from_space);
    with_transform(body, find_view(body, from, display, view), image.format, [&](const auto& transform) {
      color::apply_image(shd_object_get_context(object_of(color)), transform, source, image);
    });
    return SHD_OK;
  });
}

shd_result shd_color_convert(const shd_color* color, const shd_image* in_out, const char* from_space,
                             const char* to_space) {
  return guard([&]() -> shd_result {
    const Body& body = body_of(color);
    if (!from_space) refuse(SHD_ERROR_INVALID_ARGUMENT, "from_space: NULL");
    const shd_image image = read_float_image("in_out", in_out);
    const std::string from = read_space(body, "from_space", from_space);
    const std::string to = read_space(body, "to_space", to_space);
    const color::TransformRef transform = body.config->between(from, to);
    color::apply_in_place(shd_object_get_context(object_of(color)), *transform, image);
    return SHD_OK;
  });
}

size_t shd_color_get_display_count(const shd_color* color) {
  return ask(size_t{0}, [&] { return body_of(color).config->catalog().displays.size(); });
}

const char* shd_color_get_display_name(const shd_color* color, size_t index) {
  return ask<const char*>(nullptr, [&] {
    const auto& displays = body_of(color).config->catalog().displays;
    return index < displays.size() ? displays[index].name.c_str() : nullptr;
  });
}

const char* shd_color_get_default_display(const shd_color* color) {
  return ask<const char*>(nullptr, [&] { return body_of(color).config->catalog().display(nullptr).name.c_str(); });
}

size_t shd_color_get_view_count(const shd_color* color, const char* display) {
  return ask(size_t{0}, [&] {
    const color::Display* found = body_of(color).config->catalog().find_display(display);
    return found ? found->views.size() : size_t{0};
  });
}

const char* shd_color_get_view_name(const shd_color* color, const char* display, size_t index) {
  return ask<const char*>(nullptr, [&] {
    const color::Display* found = body_of(color).config->catalog().find_display(display);
    return found ? name_at(found->views, index) : nullptr;
  });
}

const char* shd_color_get_default_view(const shd_color* color, const char* display) {
  return ask<const char*>(nullptr, [&] {
    const color::Display* found = body_of(color).config->catalog().find_display(display);
    return found ? found->default_view.c_str() : nullptr;
  });
}

size_t shd_color_get_space_count(const shd_color* color) {
  return ask(size_t{0}, [&] { return body_of(color).config->catalog().spaces.size(); });
}

const char* shd_color_get_space_name(const shd_color* color, size_t index) {
  return ask<const char*>(nullptr, [&] { return name_at(body_of(color).config->catalog().spaces, index); });
}

const char* shd_color_get_working_space(const shd_color* color) {
  return ask<const char*>(nullptr, [&] { return body_of(color).working_space.c_str(); });
}

}  // extern "C"
