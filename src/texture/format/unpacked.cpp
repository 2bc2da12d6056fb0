// SPDX-License-Identifier: MIT
// Consumers of unpacked texels: of values that may be the border colour, of comparisons and of derivatives.
#include "texture/stream.h"

#define SHD_FORMAT_KERNELS
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/format/unpacked.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/format/compared-inl.h"
#include "texture/format/formats-inl.h"
#include "texture/format/formats.h"
#include "texture/format/gradient-inl.h"
#include "texture/format/unpacked-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace {

template <class B>
Consume ConsumerOf(image::Component component) {
  switch (component) {
#define SHD_TEXTURE_CASE(name, Format) \
  case image::Component::name: return ConsumeThrough<B, Format>;
    SHD_TEXTURE_FORMATS(SHD_TEXTURE_CASE)
#undef SHD_TEXTURE_CASE
  }
  return nullptr;
}

}  // namespace

Consume BorderedOf(image::Component component) {
  return ConsumerOf<Blend<Unpacked, true>>(component);
}

Consume ComparedOf(image::Component component) {
  return ConsumerOf<Compared>(component);
}

Consume GradientOf(image::Component component) {
  return ConsumerOf<GradientBlend>(component);
}

Consume DeepGradientOf(image::Component component) {
  return ConsumerOf<DeepBlend>(component);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
