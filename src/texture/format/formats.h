// SPDX-License-Identifier: MIT
/// @file
/// Table of the formats. Each component type has a row here and a file of its own. Format F defines the struct FCodec
/// (codec.h). Files that are compiled for each target define SHD_FORMAT_KERNELS; for them it also defines the struct F
/// (consume-inl.h).

// These includes are outside of the guard, because kernels are included once for each target.
#include "texture/format/float16-inl.h"
#include "texture/format/float32-inl.h"
#include "texture/format/rgb9e5-inl.h"
#include "texture/format/srgb8-inl.h"
#include "texture/format/unorm16-inl.h"
#include "texture/format/unorm8-inl.h"

#ifndef SHD_TEXTURE_FORMATS_H_
#define SHD_TEXTURE_FORMATS_H_

#include "image/format.h"

#define SHD_TEXTURE_FORMATS(ROW) \
  ROW(kUnorm8, Unorm8)           \
  ROW(kSrgb8, Srgb8)             \
  ROW(kUnorm16, Unorm16)         \
  ROW(kFloat16, Float16)         \
  ROW(kFloat32, Float32)         \
  ROW(kRgb9e5, Rgb9e5)

namespace shd::texture {

template <template <size_t> class Codec, class Body>
void visit_channels(size_t channels, Body&& body) {
  switch (channels) {
    case 1: return body(Codec<1>());
    case 2: return body(Codec<2>());
    case 3: return body(Codec<3>());
    default: return body(Codec<4>());
  }
}

/// Calls body(Codec<channels>()) with the codec of a component.
template <class Body>
void visit_codec(image::Component component, size_t channels, Body&& body) {
  switch (component) {
#define SHD_TEXTURE_CASE(component, Format) \
  case image::Component::component: return visit_channels<Format##Codec>(channels, body);
    SHD_TEXTURE_FORMATS(SHD_TEXTURE_CASE)
#undef SHD_TEXTURE_CASE
  }
}

/// Calls body(Codec<channels>()) for a number of channels that textures store: 1, 2 or 4.
template <class Body>
void visit_stored(image::Component component, size_t channels, Body&& body) {
  visit_codec(component, channels, [&](auto codec) {
    if constexpr (decltype(codec)::kChannels != 3) body(codec);
  });
}

/// Returns the stored number of a channel whose value is 1.
inline double one_of(image::Component component, size_t channel) {
  double one = 1;
  visit_codec(component, 4, [&](auto codec) { one = codec.one(channel); });
  return one;
}

/// Returns the largest finite value of a channel.
inline double largest_of(image::Component component, size_t channel) {
  double largest = 1;
  visit_codec(component, 4, [&](auto codec) { largest = codec.largest(channel) / codec.one(channel); });
  return largest;
}

/// Returns whether stored numbers may be infinite or NaN.
inline bool is_float(image::Component component) {
  bool floats = false;
  visit_codec(component, 4, [&](auto codec) { floats = codec.kFloat; });
  return floats;
}

/// Returns the reference of a comparison lookup as texels of a component type are compared with it. NaN stays NaN.
inline float clamped_reference(image::Component component, float reference) {
  if (!image::is_unorm(component)) return reference;
  return reference < 0.0f ? 0.0f : reference > 1.0f ? 1.0f : reference;
}

}  // namespace shd::texture

#endif  // SHD_TEXTURE_FORMATS_H_
