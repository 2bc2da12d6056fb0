// SPDX-License-Identifier: MIT
// Consumers of rows of quads, for samplers without border colour. Formats of floats have none: most of their time goes
// into blends, and their code would be as long as that of all other formats.
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
    case image::Component::kUnorm8: return ConsumeRowsOf<Unorm8>;
    case image::Component::kSrgb8: return ConsumeRowsOf<Srgb8>;
    case image::Component::kUnorm16: return ConsumeRowsOf<Unorm16>;
    default: return nullptr;
  }
}

void EncodePixels(const Texels& out, size_t first, size_t count) {
  const BatchTag d;
  for (size_t i = first; i < first + count; i += hn::Lanes(d)) {
    hn::Vec<BatchTag> color[3];
    for (size_t c = 0; c < 3; ++c) color[c] = simd::HWY_NAMESPACE::LoadFirst(d, out.channel[c] + i, first + count - i);
    StorePixels(color, out.rgba8 + i);
  }
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
