// SPDX-License-Identifier: MIT
#include "tool/environment.h"

#include <cmath>
#include <cstdio>

#include "tool/failure.h"

namespace {

/// Whether an image has the shape of a disc, an octahedral map, or the faces of a cube, rather than of latitude and
/// longitude.
bool has_other_shape(const shd_image& image) {
  const uint64_t width = image.width, height = image.height;
  return width == height || 3 * width == 4 * height || 4 * width == 3 * height || width == 6 * height ||
         6 * width == height;
}

}  // namespace

Environment load_environment(shd_context* context, const Options& options) {
  Environment environment;
  if (options.environment.empty()) return environment;
  const shd_load_desc load = shd_load_desc_default();
  Bitmap bitmap;
  shd_image image = shd_image_default();
  if (shd_bitmap_load(context, options.environment.c_str(), &load, bitmap.out()) != SHD_OK ||
      shd_bitmap_image(bitmap.get(), &image) != SHD_OK) {
    throw Failure(kExitInput, options.environment + ": " + shd_last_error());
  }
  shd_environment_desc desc = shd_environment_desc_default();
  desc.image = &image;
  if (options.environment_projection != SHD_PROJECTION_NONE) {
    desc.projection = options.environment_projection;
  } else if (has_other_shape(image)) {
    std::fprintf(stderr, "shd-render: %s: %u x %u pixels, taken as lat-long (--environment-projection)\n",
                 options.environment.c_str(), image.width, image.height);
  }
  check(shd_environment_create(context, &desc, environment.out()), "environment", kExitInput);
  return environment;
}

void set_environment(const Options& options, shd_environment* environment, shd_render_desc& desc) {
  if (!environment) return;
  const float angle = options.environment_turn * (3.14159265f / 180.0f);
  desc.environment = environment;
  desc.environment_intensity = options.exposure;
  desc.environment_to_world[0] = desc.environment_to_world[8] = std::cos(angle);
  desc.environment_to_world[2] = -std::sin(angle);
  desc.environment_to_world[6] = std::sin(angle);
  desc.background = options.has_background ? SHD_BACKGROUND_CLEAR : SHD_BACKGROUND_ENVIRONMENT;
  desc.background_roughness = options.environment_blur;
}
