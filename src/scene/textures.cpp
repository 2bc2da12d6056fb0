// SPDX-License-Identifier: MIT
#include "scene/textures.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <iterator>

#include "extension/error.h"
#include "scene/specular_glossiness.h"
#include "scene/text.h"

namespace shd::scene {
namespace {

using extension::require;

/// Makes a texture of texels that are embedded in the model without an image file format.
shd_result create_texture(shd_context* context, const TextureSource& source, uint32_t tables, Texture& out) {
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = source.data ? SHD_FORMAT_RGBA8 : SHD_FORMAT_RGBA8_SRGB;
  desc.width = source.width;
  desc.height = source.height;
  desc.texels = source.rgba.data();
  desc.tables = tables;
  return shd_texture_create(context, &desc, out.out());
}

/// Loads a texture of a file of its own; `path` becomes that of the file that was read.
shd_result load_named(shd_context* context, HostFiles& files, const TextureSource& source, const shd_load_desc& desc,
                      Texture& out, std::string& path) {
  Opened opened;
  std::string why = std::strerror(ENOENT), reason;
  path = source.name;
  if (!files.locate(source.folder, source.name, &opened, &reason)) {
    if (!reason.empty()) why = reason;
    return extension::fail(SHD_ERROR_NOT_FOUND, "cannot open \"%s\": %s", text_of(source.name).c_str(), why.c_str());
  }
  if (opened.bytes.data) {
    const shd_result result = shd_texture_load_memory(context, opened.bytes.data, opened.bytes.size, &desc, out.out());
    const std::string text = shd_last_error();
    return result == SHD_OK ? result : extension::fail(result, "\"%s\": %s", text_of(path).c_str(), text.c_str());
  }
  path = opened.path;
  return shd_texture_load(context, path.c_str(), &desc, out.out());
}

shd_result load_as(shd_context* context, HostFiles& files, const TextureSource& source, const shd_load_desc& desc,
                   Texture& out, std::string& path) {
  path = source.name;
  if (!source.file.empty()) {
    return shd_texture_load_memory(context, source.file.data(), source.file.size(), &desc, out.out());
  }
  if (!source.rgba.empty()) return create_texture(context, source, desc.tables, out);
  return load_named(context, files, source, desc, out, path);
}

shd_result load_texture(shd_context* context, HostFiles& files, const TextureSource& source, shd_load_desc desc,
                        Texture& out, std::string& path) {
  if (source.srgb && desc.encoding == SHD_COLOR_ENCODING_AUTO) {
    constexpr shd_file_format_flags kImages = SHD_FILE_FORMAT_PNG | SHD_FILE_FORMAT_JPEG | SHD_FILE_FORMAT_WEBP;
    shd_load_desc image = desc;
    image.formats = (desc.formats ? desc.formats : shd_file_format_flags{SHD_FILE_FORMAT_DEFAULT}) & kImages;
    image.encoding = SHD_COLOR_ENCODING_SRGB;
    const shd_result result = image.formats ? load_as(context, files, source, image, out, path) : SHD_ERROR_UNSUPPORTED;
    if (result != SHD_ERROR_UNSUPPORTED) return result;
  }
  if (source.data) desc.encoding = SHD_COLOR_ENCODING_DATA;
  return load_as(context, files, source, desc, out, path);
}

/// The message for a texture that failed. Messages about files contain the name already.
std::string message_of(const TextureSource& source) {
  const std::string text = shd_last_error();
  return source.file.empty() && source.rgba.empty() ? text : text_of(source.name) + ": " + text;
}

/// Flags of each load. Where the alpha of a texture hides parts of a surface, colours of invisible texels must not
/// bleed into visible ones. Blended colours are premultiplied, but not if another slot or surface reads the texture,
/// too.
std::vector<shd_load_flags> alpha_flags(const Model& model) {
  std::vector<shd_load_flags> out(model.textures.size(), SHD_LOAD_PREMULTIPLY);
  std::vector<bool> hides(model.textures.size());
  for (const Surface& surface : model.surfaces) {
    for (uint32_t slot = 0; slot < std::size(surface.maps); ++slot) {
      const int32_t texture = surface.maps[slot].texture;
      if (texture < 0) continue;
      const bool is_color = slot == SHD_SLOT_DIFFUSE;
      if (is_color && surface.alpha != Alpha::kOpaque && !surface.specular_glossiness)
        hides[static_cast<size_t>(texture)] = true;
      if (!is_color || surface.alpha != Alpha::kBlend || surface.specular_glossiness)
        out[static_cast<size_t>(texture)] = SHD_LOAD_ALPHA_WEIGHTED;
    }
  }
  for (size_t i = 0; i < out.size(); ++i) {
    if (!hides[i]) out[i] = SHD_LOAD_NONE;
  }
  return out;
}

}  // namespace

std::vector<Texture> load_textures(shd_context* context, HostFiles& files, Model& model, const shd_load_desc& load,
                                   bool all_required, const Limits& limits, const Deadline& deadline,
                                   std::vector<std::string>* names, std::vector<std::string>* warnings) {
  TextureLoad made = {context, load.tables, limits, deadline, 0, {}, {}};
  const std::vector<shd_load_flags> flags = alpha_flags(model);
  for (const TextureSource& source : model.textures) {
    deadline.check();
    shd_load_desc desc = load;
    if (!(load.flags & (SHD_LOAD_ALPHA_WEIGHTED | SHD_LOAD_PREMULTIPLY))) desc.flags |= flags[made.textures.size()];
    const double left = std::max(deadline.seconds_left(), 1e-3);
    desc.time_limit = desc.time_limit > 0 ? std::min(desc.time_limit, left) : left;
    Texture texture;
    std::string path;
    const shd_result result = load_texture(context, files, source, desc, texture, path);
    if (result == SHD_ERROR_OUT_OF_MEMORY || (result != SHD_OK && all_required)) {
      core::refuse(result, "%s", message_of(source).c_str());
    }
    if (result != SHD_OK) warnings->push_back(message_of(source) + "; its material is plain");
    add_texture(made, std::move(texture), text_of(path));
  }
  convert_surfaces(made, model, warnings);
  for (size_t i = 0; i < made.textures.size(); ++i) {
    if (made.textures[i].get()) names->push_back(made.names[i]);
  }
  return std::move(made.textures);
}

}  // namespace shd::scene
