// SPDX-License-Identifier: MIT
#include "tool/environment.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "command/failure.h"

namespace {

/// Where a face lies among the squares of an image.
struct Cell {
  uint32_t column, row;
  bool turned;  // by 180 degrees
};

/// Squares of an image that are the faces +X, -X, +Y, -Y, +Z, -Z of a cube map.
struct CubeLayout {
  uint32_t columns, rows;
  std::array<Cell, 6> face;
};

constexpr CubeLayout kCubeLayouts[] = {
    {1, 6, {{{0, 0, false}, {0, 1, false}, {0, 2, false}, {0, 3, false}, {0, 4, false}, {0, 5, false}}}},
    {6, 1, {{{0, 0, false}, {1, 0, false}, {2, 0, false}, {3, 0, false}, {4, 0, false}, {5, 0, false}}}},
    {4, 3, {{{2, 1, false}, {0, 1, false}, {1, 0, false}, {1, 2, false}, {1, 1, false}, {3, 1, false}}}},
    {3, 4, {{{2, 1, false}, {0, 1, false}, {1, 0, false}, {1, 2, false}, {1, 1, false}, {1, 3, true}}}},
};

/// An image in memory of its own.
struct Pixels {
  shd_image image = shd_image_default();
  std::vector<unsigned char> memory;
};

const unsigned char* pixel_at(const shd_image& image, uint32_t x, uint32_t y) {
  return static_cast<const unsigned char*>(image.pixels) + y * image.row_stride + x * shd_format_size(image.format);
}

/// Whether a pixel has the colour of the first one. Bytes may differ a little, as after lossy compression.
bool is_blank(const shd_image& image, uint32_t x, uint32_t y) {
  const unsigned char *a = pixel_at(image, 0, 0), *b = pixel_at(image, x, y);
  const size_t size = shd_format_size(image.format);
  if (size != 4) return std::memcmp(a, b, size / 4 * 3) == 0;
  for (int c = 0; c < 3; ++c) {
    if (std::abs(a[c] - b[c]) > 16) return false;
  }
  return true;
}

/// Whether the squares of an image that are no faces have one colour.
bool has_blank_squares(const shd_image& image, const CubeLayout& layout) {
  const uint32_t side = image.width / layout.columns;
  for (uint32_t y = 0; y < image.height; ++y) {
    for (uint32_t x = 0; x < image.width; ++x) {
      bool face = false;
      for (const Cell& cell : layout.face) face = face || (cell.column == x / side && cell.row == y / side);
      if (!face && !is_blank(image, x, y)) return false;
    }
  }
  return true;
}

/// Whether a square image has one colour outside its disc.
bool has_blank_corners(const shd_image& image) {
  const double radius = image.width / 2.0;
  for (uint32_t y = 0; y < image.height; ++y) {
    for (uint32_t x = 0; x < image.width; ++x) {
      if (std::hypot(x + 0.5 - radius, y + 0.5 - radius) > radius + 1.5 && !is_blank(image, x, y)) return false;
    }
  }
  return image.width > 8;
}

/// The layout of an image with the aspect of one; null if there is none.
const CubeLayout* find_layout(const shd_image& image) {
  for (const CubeLayout& layout : kCubeLayouts) {
    const uint64_t side = image.width / layout.columns;
    if (side > 0 && side * layout.columns == image.width && side * layout.rows == image.height) return &layout;
  }
  return nullptr;
}

/// The six faces of an image on top of each other.
Pixels stack_faces(const shd_image& image, const CubeLayout& layout) {
  const uint32_t side = image.width / layout.columns;
  const size_t pixel = shd_format_size(image.format);
  Pixels out;
  out.memory.resize(size_t{6} * side * side * pixel);
  out.image.format = image.format;
  out.image.width = side;
  out.image.height = 6 * side;
  unsigned char* to = out.memory.data();
  for (const Cell& cell : layout.face) {
    for (uint32_t y = 0; y < side; ++y) {
      for (uint32_t x = 0; x < side; ++x, to += pixel) {
        const uint32_t u = cell.turned ? side - 1 - x : x, v = cell.turned ? side - 1 - y : y;
        std::memcpy(to, pixel_at(image, cell.column * side + u, cell.row * side + v), pixel);
      }
    }
  }
  out.image.pixels = out.memory.data();
  return out;
}

/// The linear pixels of a file, and one image of it.
shd_image load_image(shd_context* context, const std::string& path, uint32_t subimage, Bitmap& bitmap) {
  shd_load_desc load = shd_load_desc_default();
  load.flags = SHD_LOAD_LINEAR;
  load.subimage = subimage;
  shd_image image = shd_image_default();
  if (shd_bitmap_load(context, path.c_str(), &load, bitmap.out()) != SHD_OK ||
      shd_bitmap_get_image(bitmap.get(), &image) != SHD_OK) {
    throw Failure(kExitInput, path + ": " + shd_last_error());
  }
  return image;
}

/// Whether a KTX2 or DDS file has a cube map.
bool is_cube_file(shd_context* context, const std::string& path, const shd_bitmap* bitmap) {
  shd_bitmap_info info = shd_bitmap_info_default();
  check(shd_bitmap_get_info(bitmap, &info), "environment");
  if (info.file_format != SHD_FILE_FORMAT_DDS && info.file_format != SHD_FILE_FORMAT_KTX2) return false;
  shd_texture_file_info file = shd_texture_file_info_default();
  shd_load_desc load = shd_load_desc_default();
  load.tables = SHD_TABLE_NONE;
  load.info = &file;
  Texture texture;
  check(shd_texture_load(context, path.c_str(), &load, texture.out()), "environment", kExitInput);
  return file.face_count == 6;
}

/// The faces of a cube map in a KTX2 or DDS file.
Pixels load_faces(shd_context* context, const std::string& path) {
  Pixels out;
  for (uint32_t face = 0; face < 6; ++face) {
    Bitmap bitmap;
    const shd_image image = load_image(context, path, face, bitmap);
    const size_t size = shd_format_size(image.format) * image.width * image.height;
    out.image = image;
    const auto* pixels = static_cast<const unsigned char*>(image.pixels);
    out.memory.insert(out.memory.end(), pixels, pixels + size);
  }
  out.image.height *= 6;
  out.image.row_stride = 0;
  out.image.pixels = out.memory.data();
  return out;
}

void say_taken(const std::string& path, const shd_image& image, const char* as) {
  std::fprintf(stderr, "shd-render: %s: %u x %u pixels, taken as %s (--environment-projection)\n", path.c_str(),
               image.width, image.height, as);
}

/// Chooses the projection of an image without one by its aspect and its blank parts.
shd_projection choose_projection(const std::string& path, const shd_image& image, const CubeLayout* layout) {
  if (image.width == 2 * image.height) return SHD_PROJECTION_LAT_LONG;
  if (layout && has_blank_squares(image, *layout)) return SHD_PROJECTION_CUBE;
  if (image.width == image.height && has_blank_corners(image)) {
    say_taken(path, image, "an angular probe, not a mirror-ball");
    return SHD_PROJECTION_ANGULAR;
  }
  say_taken(path, image, "lat-long");
  return SHD_PROJECTION_LAT_LONG;
}

}  // namespace

Environment load_environment(shd_context* context, const Options& options) {
  Environment environment;
  const std::string& path = options.environment;
  if (path.empty()) return environment;
  Bitmap bitmap;
  shd_image image = load_image(context, path, 0, bitmap);
  shd_environment_desc desc = shd_environment_desc_default();
  desc.projection = options.environment_projection;
  Pixels faces;
  if (is_cube_file(context, path, bitmap.get())) {
    if (desc.projection != SHD_PROJECTION_NONE && desc.projection != SHD_PROJECTION_CUBE) {
      throw Failure(kExitUsage, path + " is a cube map: --environment-projection cube");
    }
    faces = load_faces(context, path);
    desc.projection = SHD_PROJECTION_CUBE;
  } else {
    const CubeLayout* const layout = find_layout(image);
    if (desc.projection == SHD_PROJECTION_NONE) desc.projection = choose_projection(path, image, layout);
    if (desc.projection == SHD_PROJECTION_CUBE) {
      if (!layout) {
        throw Failure(kExitInput, path + ": " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                                      " pixels are no cube map: a strip of 1:6 or 6:1, or a cross of 4:3 or 3:4");
      }
      faces = stack_faces(image, *layout);
    }
  }
  if (desc.projection == SHD_PROJECTION_CUBE) image = faces.image;
  desc.image = &image;
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
