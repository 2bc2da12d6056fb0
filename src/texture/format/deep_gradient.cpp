// SPDX-License-Identifier: MIT
// Consumers of derivatives in w, for 3D textures.
#include "texture/stream.h"

#define SHD_FORMAT_KERNELS
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/format/deep_gradient.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/format/formats-inl.h"
#include "texture/format/formats.h"
#include "texture/format/gradient-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {

Consume DeepGradientOf(image::Component component) {
  switch (component) {
#define SHD_TEXTURE_CASE(name, Format) \
  case image::Component::name: return ConsumeStream<DeepBlend<Format>, Format, true>;
    SHD_TEXTURE_FORMATS(SHD_TEXTURE_CASE)
#undef SHD_TEXTURE_CASE
  }
  return nullptr;
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
