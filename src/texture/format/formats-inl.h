// SPDX-License-Identifier: MIT
// The consumers of every format, for one target. Each function returns the consumer of a component type.

#if defined(SHD_TEXTURE_FORMATS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_FORMATS_INL_H_
#undef SHD_TEXTURE_FORMATS_INL_H_
#else
#define SHD_TEXTURE_FORMATS_INL_H_
#endif

#include <hwy/highway.h>

#include "image/format.h"
#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {

Consume ValuesOf(image::Component component);
Consume BorderedOf(image::Component component);
Consume GradientOf(image::Component component);
/// Comparisons of texels with the references of lookups.
Consume ComparedOf(image::Component component);
/// Derivatives in w, of 3D textures.
Consume DeepGradientOf(image::Component component);

/// Values of rows of quads; null if a component type has no such consumer.
ConsumeRows RowsOf(image::Component component);
/// Values of rows of quads of 8-bit unorm texels, blended in 16 bits. `channels`: those that the texture stores.
ConsumeRows FixedRowsOf(uint32_t channels);
/// Encodes the values of lookups first..first + count - 1 as opaque pixels. A whole vector may be written at the end.
void EncodePixels(const Texels& out, size_t first, size_t count);

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_FORMATS_INL_H_
