// SPDX-License-Identifier: MIT
// Consumers of rows of quads, for samplers without border colour.
#include "texture/rows.h"

#define SHD_FORMAT_KERNELS
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/format/rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/format/consume_rows-inl.h"
#include "texture/format/formats-inl.h"
#include "texture/format/formats.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {

ConsumeRows RowsOf(image::Component component) {
  switch (component) {
#define SHD_TEXTURE_CASE(name, Format) \
  case image::Component::name: return ConsumeRowsOf<Format>;
    SHD_TEXTURE_FORMATS(SHD_TEXTURE_CASE)
#undef SHD_TEXTURE_CASE
  }
  return nullptr;
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
