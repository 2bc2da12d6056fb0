// SPDX-License-Identifier: MIT
#include <cstdio>

#include <shd/projection.h>

#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "abi/levels.h"
#include "projection/projection.h"
#include "texture/convert/convert.h"
#include "texture/store/image_list.h"

namespace {

using namespace shd;
using namespace shd::abi;

constexpr uint64_t kMaxConvertedPixels = uint64_t{1} << 26;

/// A caller's images, in the layout of this version.
struct Images {
  shd_direction_images desc;
  uint32_t count;
  shd_image image[projection::most_faces()];
  char name[projection::most_faces()][32];  // "from.images[0]"
};

shd_result check_size(const char* name, const Images& in) {
  const shd_image& first = in.image[0];
  const uint64_t pixels = uint64_t{first.width} * first.height * in.count;
  if (pixels > kMaxConvertedPixels) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s.images: %llu pixels are not in 1..%llu", name,
                      static_cast<unsigned long long>(pixels), static_cast<unsigned long long>(kMaxConvertedPixels));
  }
  if (in.desc.projection == SHD_PROJECTION_LAT_LONG) return SHD_OK;
  const texture::LayoutSize faces = texture::layout_size(in.desc.layout);
  const bool fits = first.width % faces.across == 0 && first.height % faces.down == 0 &&
                    first.width / faces.across == first.height / faces.down;
  if (fits) return SHD_OK;
  return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s.images[0]: %u x %u pixels are not %u x %u squares", name,
                    first.width, first.height, faces.across, faces.down);
}

shd_result read_images(const char* name, const shd_direction_images* in, Images* out) {
  out->desc = shd_direction_images_default();
  SHD_TRY(read_desc(name, in, false, &out->desc));
  char field[24];
  std::snprintf(field, sizeof field, "%s.projection", name);
  SHD_TRY(check_enum(field, out->desc.projection, SHD_PROJECTION_LAT_LONG, projection::kLastProjection));
  const bool cube = out->desc.projection == SHD_PROJECTION_CUBE;
  std::snprintf(field, sizeof field, "%s.layout", name);
  if (!cube) out->desc.layout = SHD_CUBE_LAYOUT_FACES;
  SHD_TRY(check_enum(field, out->desc.layout, SHD_CUBE_LAYOUT_FACES, SHD_CUBE_LAYOUT_VERTICAL_CROSS));
  std::snprintf(field, sizeof field, "%s.images", name);
  SHD_TRY(check_not_null(field, out->desc.images));
  out->count = out->desc.layout == SHD_CUBE_LAYOUT_FACES ? projection::face_count(out->desc.projection) : 1;
  for (uint32_t i = 0; i < out->count; ++i) {
    std::snprintf(out->name[i], sizeof out->name[i], "%s.images[%u]", name, i);
    const shd_image* const given = texture::element_of(out->desc.images, i);
    SHD_TRY(check_same_size(out->name[i], given, out->name[0], out->desc.images));
    SHD_TRY(read_image(out->name[i], given, &out->image[i]));
    const shd_image &first = out->image[0], &image = out->image[i];
    if (image.format != first.format || image.width != first.width || image.height != first.height) {
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: %u x %u of format %d, but %s is %u x %u of format %d",
                        out->name[i], image.width, image.height, static_cast<int>(image.format), out->name[0],
                        first.width, first.height, static_cast<int>(first.format));
    }
  }
  return check_size(name, *out);
}

shd_result check_images_apart(const Images& from, const Images& to) {
  for (uint32_t i = 0; i < to.count; ++i) {
    for (uint32_t j = 0; j < from.count; ++j) {
      SHD_TRY(check_apart(to.name[i], to.image[i], from.name[j], from.image[j]));
    }
    for (uint32_t j = 0; j < i; ++j) SHD_TRY(check_apart(to.name[i], to.image[i], to.name[j], to.image[j]));
  }
  return SHD_OK;
}

}  // namespace

extern "C" shd_result shd_projection_convert(shd_context* context, const shd_direction_images* from,
                                             const shd_direction_images* to) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_context(context));
    Images source, target;
    SHD_TRY(read_images("from", from, &source));
    SHD_TRY(read_images("to", to, &target));
    SHD_TRY(check_images_apart(source, target));
    texture::convert(context_of(static_cast<const shd_context*>(context)),
                     texture::faces_of(source.desc.projection, source.desc.layout, source.image),
                     texture::faces_of(target.desc.projection, target.desc.layout, target.image));
    if (target.desc.projection == SHD_PROJECTION_CUBE) texture::clear_unused(target.desc.layout, target.image[0]);
    return SHD_OK;
  });
}
