// SPDX-License-Identifier: MIT
#include "tool/check/textures.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "command/failure.h"
#include "image/srgb.h"

namespace {

using shd::image::srgb_to_linear;

float number_of(uint8_t code, size_t channel, Decode decode) {
  const double x = code / 255.0;
  if (decode == Decode::kPower && channel < 3) return static_cast<float>(std::pow(x, 2.2));
  if (decode == Decode::kTwice && channel < 3) return static_cast<float>(srgb_to_linear(srgb_to_linear(x)));
  return static_cast<float>(channel < 3 || decode == Decode::kAlphaToo ? srgb_to_linear(x) : x);
}

Picture with_floats(const Picture& from, Decode decode) {
  const size_t channels = channels_of(from);
  Picture out = {format_with(Channel::kFloat, channels), from.width, from.height, from.layers, {}};
  out.texels.resize(from.texels.size() * sizeof(float));
  for (size_t i = 0; i < from.texels.size(); ++i) {
    const float value = number_of(from.texels[i], i % channels, decode);
    std::memcpy(&out.texels[i * sizeof value], &value, sizeof value);
  }
  return out;
}

shd_image image_of(const Picture& picture, uint32_t layer) {
  shd_image image = shd_image_default();
  image.format = picture.format;
  image.width = picture.width;
  image.height = picture.height;
  image.pixels = const_cast<uint8_t*>(picture.texels.data()) + layer * (picture.texels.size() / picture.layers);
  return image;
}

Picture constant(uint32_t width, uint32_t height, uint32_t layers, float value) {
  Picture out = {SHD_FORMAT_R32F, width, height, layers, {}};
  const std::vector<float> texels(size_t{width} * height * layers, value);
  const auto* const first = reinterpret_cast<const uint8_t*>(texels.data());
  out.texels.assign(first, first + texels.size() * sizeof value);
  return out;
}

}  // namespace

Textures::Textures(shd_context* context, const Options& options)
    : context_(context), options_(options), pictures_(read_pictures(context, options)) {}

uint32_t Textures::level_count() const {
  if (!options_.mipmap) return 1;
  if (!pictures_.levels.empty()) return static_cast<uint32_t>(pictures_.levels.size()) + 1;
  uint32_t count = 1;
  while (std::max(base().width, base().height) >> count) ++count;
  return count;
}

Texture Textures::make(const Pictures& pictures) const {
  std::vector<shd_image> images;
  for (uint32_t layer = 0; layer < pictures.base.layers; ++layer) {
    for (const Picture& level : pictures.levels) images.push_back(image_of(level, layer));
  }
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = pictures.base.format;
  desc.width = pictures.base.width;
  desc.height = pictures.base.height;
  desc.layer_count = pictures.base.layers;
  desc.texels = pictures.base.texels.data();
  desc.tables = options_.mipmap ? SHD_TABLE_MIPMAP : SHD_TABLE_NONE;
  desc.level_images = images.empty() ? nullptr : images.data();
  desc.level_count = pictures.levels.size();
  if (options_.cube) desc.kind = SHD_TEXTURE_KIND_DIRECTIONS, desc.projection = SHD_PROJECTION_CUBE;
  Texture texture;
  check(shd_texture_create(context_, &desc, texture.out()), options_.texture, kExitInput);
  return texture;
}

Pictures Textures::decoded(Decode decode) const {
  Pictures out = pictures_;
  if (!has_codes(out.base)) return out;
  const auto change = [decode](Picture& picture) {
    if (!has_codes(picture)) return;
    if (!is_stored(decode)) {
      picture = with_floats(picture, decode);
    } else {
      picture.format = format_with(decode == Decode::kSrgb ? Channel::kSrgb : Channel::kCode, channels_of(picture));
    }
  };
  change(out.base);
  for (Picture& level : out.levels) change(level);
  return out;
}

const shd_texture* Textures::get(Decode decode) {
  Texture& texture = made_[decode];
  if (!texture.get()) texture = make(decoded(decode));
  return texture.get();
}

const shd_texture* Textures::level_numbers() {
  if (numbers_.get()) return numbers_.get();
  Pictures pictures = {constant(base().width, base().height, base().layers, 0), {}};
  for (uint32_t level = 1; level < level_count(); ++level) {
    pictures.levels.push_back(constant(std::max(base().width >> level, 1u), std::max(base().height >> level, 1u),
                                       base().layers, static_cast<float>(level)));
  }
  numbers_ = make(pictures);
  return numbers_.get();
}
