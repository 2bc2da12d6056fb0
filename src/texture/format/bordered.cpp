// SPDX-License-Identifier: MIT
// Consumers of values, for samplers whose lookups may read the border colour.
#include "texture/stream.h"

#define SHD_FORMAT_KERNELS
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/format/bordered.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/format/consume-inl.h"
#include "texture/format/formats-inl.h"
#include "texture/format/formats.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {

Consume BorderedOf(image::Component component) {
  switch (component) {
#define SHD_TEXTURE_CASE(name, Format) \
  case image::Component::name: return ConsumeStream<Blend<Format, true>, Format, true>;
    SHD_TEXTURE_FORMATS(SHD_TEXTURE_CASE)
#undef SHD_TEXTURE_CASE
  }
  return nullptr;
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
