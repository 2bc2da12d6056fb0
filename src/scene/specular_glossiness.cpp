// SPDX-License-Identifier: MIT
#include "scene/specular_glossiness.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "extension/error.h"
#include "image/half.h"

namespace shd::scene {
namespace {

using Color = std::array<float, 3>;
using extension::require;

/// Perceived brightness of a colour, with the weights of KHR_materials_pbrSpecularGlossiness, appendix.
float brightness_of(const Color& c) {
  return std::sqrt(0.299f * c[0] * c[0] + 0.587f * c[1] * c[1] + 0.114f * c[2] * c[2]);
}

/// Reads textures at the centres of the texels of a larger one, row by row.
class Rows {
 public:
  Rows(shd_context* context, uint32_t width, uint32_t height) : height_(height), u_(width), v_(width) {
    shd_sampler_desc desc = shd_sampler_desc_default();
    desc.filter = SHD_FILTER_BILINEAR;
    desc.wrap_u = desc.wrap_v = SHD_WRAP_CLAMP;
    require(shd_sampler_create(context, &desc, sampler_.out()));
    for (uint32_t x = 0; x < width; ++x) u_[x] = (static_cast<float>(x) + 0.5f) / static_cast<float>(width);
  }

  /// Channels of row y; all are 1 without a texture.
  void read(shd_texture* texture, uint32_t y, std::array<std::vector<float>, 4>& out) {
    shd_lookups lookups = shd_lookups_default();
    shd_texels texels = shd_texels_default();
    for (std::vector<float>& channel : out) channel.assign(u_.size(), 1.0f);
    if (!texture) return;
    std::fill(v_.begin(), v_.end(), (static_cast<float>(y) + 0.5f) / static_cast<float>(height_));
    lookups.count = u_.size();
    lookups.u = shd_f32_column(u_.data(), sizeof(float));
    lookups.v = shd_f32_column(v_.data(), sizeof(float));
    for (size_t c = 0; c < 4; ++c) texels.channel[c] = shd_f32_out_column(out[c].data(), sizeof(float));
    require(shd_texture_sample(texture, sampler_.get(), &lookups, &texels));
  }

 private:
  uint32_t height_;
  std::vector<float> u_, v_;
  Sampler sampler_;
};

/// The texels of the new textures of a surface.
struct Converted {
  uint32_t width = 1, height = 1;
  std::vector<uint16_t> base;   // [height][width][4], binary16; premultiplied if the surface blends
  std::vector<uint16_t> shape;  // [height][width][2]: roughness and metallic factor, of 65535
};

void grow(shd_texture* texture, Converted& out) {
  shd_texture_info info = shd_texture_info_default();
  if (!texture) return;
  require(shd_texture_get_info(texture, &info));
  out.width = std::max(out.width, info.width);
  out.height = std::max(out.height, info.height);
}

uint16_t code_of(float value) {
  return static_cast<uint16_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 65535.0f));
}

Converted convert_texels(const TextureLoad& load, const Surface& s, shd_texture* diffuse, shd_texture* specular) {
  Converted out;
  grow(diffuse, out);
  grow(specular, out);
  const uint64_t bytes = uint64_t{12} * out.width * out.height;
  check_limit("bytes of textures", load.bytes + bytes, "max_texture_bytes", load.limits.texture_bytes);
  Rows rows(load.context, out.width, out.height);
  std::array<std::vector<float>, 4> d, g;
  out.base.reserve(size_t{4} * out.width * out.height);
  out.shape.reserve(size_t{2} * out.width * out.height);
  for (uint32_t y = 0; y < out.height; ++y) {
    load.deadline.check();
    rows.read(diffuse, y, d);
    rows.read(specular, y, g);
    for (uint32_t x = 0; x < out.width; ++x) {
      Color matt, bright;
      for (size_t c = 0; c < 3; ++c) {
        matt[c] = std::clamp(s.diffuse[c] * d[c][x], 0.0f, 1.0f);
        bright[c] = std::clamp(s.specular[c] * g[c][x], 0.0f, 1.0f);
      }
      const BaseMetal made = convert_specular(matt, bright);
      const float alpha = d[3][x], factor = s.alpha == Alpha::kBlend ? alpha : 1.0f;
      for (const float c : made.base) out.base.push_back(image::float_to_half(c * factor));
      out.base.push_back(image::float_to_half(alpha));
      out.shape.push_back(code_of(1.0f - (1.0f - s.roughness) * g[3][x]));
      out.shape.push_back(code_of(made.metallic));
    }
  }
  return out;
}

Texture make_texture(const TextureLoad& load, const Converted& texels, bool base, bool blends) {
  shd_texture_desc desc = shd_texture_desc_default();
  Texture out;
  desc.format = base ? SHD_FORMAT_RGBA16F : SHD_FORMAT_RG16;
  desc.width = texels.width;
  desc.height = texels.height;
  desc.texels = base ? texels.base.data() : texels.shape.data();
  desc.tables = load.tables;
  if (base && blends) desc.flags = SHD_TEXTURE_PREMULTIPLIED;
  require(shd_texture_create(load.context, &desc, out.out()));
  return out;
}

bool have_equal_places(const Map& a, const Map& b) {
  return a.uv_set == b.uv_set && a.uv_transform == b.uv_transform && a.wrap_u == b.wrap_u && a.wrap_v == b.wrap_v;
}

/// The surface with its factors alone; a diffuse map stays as it is.
void convert_factors(Surface& s) {
  const BaseMetal made = convert_specular(s.diffuse, s.specular);
  s.diffuse = made.base;
  s.metallic = made.metallic;
  // Below the dielectric the index of refraction has the colour at normal incidence.
  const float root = std::sqrt(*std::max_element(s.specular.begin(), s.specular.end()));
  if (made.metallic == 0.0f) s.ior = (1.0f + root) / (1.0f - root);
}

/// The factors alone are 1 in most files with this texture, which is a perfect mirror.
void leave_out_specular_map(Surface& s) {
  for (float& c : s.specular) c = std::min(c, kDielectric);
  s.roughness = 1.0f - (1.0f - s.roughness) * 0.5f;
  s.maps[SHD_SLOT_SPECULAR] = Map();
}

/// The maps of a converted surface: texture `first` is the base colour, the next one roughness and metal.
void place_maps(Surface& s, bool has_diffuse, bool has_specular, int32_t first) {
  const Map diffuse = s.maps[SHD_SLOT_DIFFUSE], specular = s.maps[SHD_SLOT_SPECULAR];
  Map& base = s.maps[SHD_SLOT_DIFFUSE] = has_diffuse ? diffuse : specular;
  base.texture = first;
  for (const shd_slot_target target : {SHD_SLOT_ROUGHNESS, SHD_SLOT_METALLIC}) {
    s.maps[target] = has_specular ? specular : diffuse;
    s.maps[target].texture = first + 1;
    s.maps[target].channel = target == SHD_SLOT_METALLIC ? 1 : 0;
  }
  s.maps[SHD_SLOT_SPECULAR] = Map();
  s.diffuse = {1, 1, 1};
  s.metallic = s.roughness = 1.0f;
}

}  // namespace

BaseMetal convert_specular(const Color& diffuse, const Color& specular) {
  const float rest = 1.0f - *std::max_element(specular.begin(), specular.end());
  const float bright = brightness_of(specular), matt = brightness_of(diffuse) * rest;
  BaseMetal out = {};
  if (bright >= kDielectric) {
    const float b = matt + bright - 2.0f * kDielectric, c = kDielectric - bright;
    const float root = std::sqrt(std::max(b * b - 4.0f * kDielectric * c, 0.0f));
    out.metallic = std::clamp((root - b) / (2.0f * kDielectric), 0.0f, 1.0f);
  }
  const float m = out.metallic;
  for (size_t c = 0; c < 3; ++c) {
    const float from_diffuse = diffuse[c] * rest / std::max(1.0f - m, 1e-6f);
    const float from_specular = (specular[c] - kDielectric * (1.0f - m)) / std::max(m, 1e-6f);
    out.base[c] = std::clamp(from_diffuse + (from_specular - from_diffuse) * m * m, 0.0f, 1.0f);
  }
  return out;
}

void add_texture(TextureLoad& load, Texture&& texture, const std::string& name) {
  shd_texture_info info = shd_texture_info_default();
  if (texture.get()) require(shd_texture_get_info(texture.get(), &info));
  load.bytes += info.byte_size;
  check_limit("bytes of textures", load.bytes, "max_texture_bytes", load.limits.texture_bytes);
  load.textures.push_back(std::move(texture));
  load.names.push_back(name);
}

void convert_surfaces(TextureLoad& load, Model& model, std::vector<std::string>* warnings) {
  const auto texture_of = [&](const Map& map) {
    return map.texture < 0 ? nullptr : load.textures[static_cast<size_t>(map.texture)].get();
  };
  for (Surface& s : model.surfaces) {
    if (!s.specular_glossiness) continue;
    shd_texture* const diffuse = texture_of(s.maps[SHD_SLOT_DIFFUSE]);
    shd_texture* specular = texture_of(s.maps[SHD_SLOT_SPECULAR]);
    if (diffuse && specular && !have_equal_places(s.maps[SHD_SLOT_DIFFUSE], s.maps[SHD_SLOT_SPECULAR])) {
      specular = nullptr;
      warnings->push_back("material \"" + s.name +
                          "\": specularGlossinessTexture is left out, because its coordinates "
                          "are not those of diffuseTexture; half as glossy, and no metal");
    }
    if (!specular && s.maps[SHD_SLOT_SPECULAR].texture >= 0) leave_out_specular_map(s);
    if (s.unlit || (!specular && (!diffuse || brightness_of(s.specular) < kDielectric))) {
      convert_factors(s);
      continue;
    }
    const Converted made = convert_texels(load, s, diffuse, specular);
    place_maps(s, diffuse != nullptr, specular != nullptr, static_cast<int32_t>(load.textures.size()));
    add_texture(load, make_texture(load, made, true, s.alpha == Alpha::kBlend), s.name + " (base colour)");
    add_texture(load, make_texture(load, made, false, false), s.name + " (roughness and metal)");
  }
}

}  // namespace shd::scene
