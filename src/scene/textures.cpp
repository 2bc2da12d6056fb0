// SPDX-License-Identifier: MIT
#include "scene/textures.h"

#include <algorithm>
#include <set>

#include "extension/error.h"
#include "scene/disk_files.h"

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

shd_result load_texture(shd_context* context, const std::string& folder, const TextureSource& source,
                        shd_load_desc desc, Texture& out) {
  if (source.data) desc.color_space = SHD_COLOR_ENCODING_DATA;
  if (!source.file.empty()) {
    return shd_texture_load_memory(context, source.file.data(), source.file.size(), &desc, out.out());
  }
  if (!source.rgba.empty()) return create_texture(context, source, desc.tables, out);
  const std::string path = find_file(folder + source.folder, source.name);
  return shd_texture_load(context, path.empty() ? source.name.c_str() : path.c_str(), &desc, out.out());
}

/// The message for a texture that failed. Messages about files contain the name already.
std::string message_of(const TextureSource& source) {
  const std::string text = shd_last_error();
  return source.file.empty() && source.rgba.empty() ? text : source.name + ": " + text;
}

/// Textures whose alpha blends a surface: colours of invisible texels must not bleed into visible ones.
std::set<int32_t> blended_textures(const Model& model) {
  std::set<int32_t> out;
  for (const Surface& surface : model.surfaces) {
    if (surface.alpha == Alpha::kBlend) out.insert(surface.maps[SHD_SLOT_DIFFUSE].texture);
  }
  return out;
}

}  // namespace

std::vector<Texture> load_textures(shd_context* context, const std::string& folder, const Model& model,
                                   const shd_load_desc& load, bool all_required, const Limits& limits,
                                   const Deadline& deadline, std::vector<std::string>* warnings) {
  std::vector<Texture> textures;
  uint64_t bytes = 0;
  const std::set<int32_t> blended = blended_textures(model);
  for (const TextureSource& source : model.textures) {
    deadline.check();
    shd_load_desc desc = load;
    if (blended.count(static_cast<int32_t>(textures.size())) != 0) desc.flags |= SHD_LOAD_ALPHA_WEIGHTED;
    const double left = std::max(deadline.seconds_left(), 1e-3);
    desc.time_limit = desc.time_limit > 0 ? std::min(desc.time_limit, left) : left;
    Texture texture;
    const shd_result result = load_texture(context, folder, source, desc, texture);
    if (result == SHD_ERROR_OUT_OF_MEMORY || (result != SHD_OK && all_required)) {
      core::refuse(result, "%s", message_of(source).c_str());
    }
    if (result != SHD_OK) warnings->push_back(message_of(source) + "; its material is plain");
    if (texture.get()) {
      shd_texture_info info = shd_texture_info_default();
      require(shd_texture_get_info(texture.get(), &info));
      bytes += info.byte_size;
      check_limit("bytes of textures", bytes, "max_texture_bytes", limits.texture_bytes);
    }
    textures.push_back(std::move(texture));
  }
  return textures;
}

}  // namespace shd::scene
