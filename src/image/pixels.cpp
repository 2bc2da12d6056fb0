// SPDX-License-Identifier: MIT
#include "image/pixels.h"

#include <cmath>
#include <cstring>

#include "image/channel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "image/pixels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "image/encode-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::image::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Stores the only word of each pixel.
HWY_INLINE void StorePixels(VU word, unsigned char* out) {
#if HWY_TARGET == HWY_SCALAR  // has no vector of bytes
  const uint32_t lane = hn::GetLane(word);
  std::memcpy(out, &lane, sizeof lane);
#else
  const hn::Repartition<uint8_t, DF> bytes;
  hn::StoreU(hn::BitCast(bytes, word), bytes, out);
#endif
}

/// Stores pixels that `interleave(words)` writes as words.
template <size_t kWords, class Interleave>
HWY_INLINE void StorePixels(const Interleave& interleave, unsigned char* out) {
  uint32_t words[kWords * HWY_MAX_BYTES / sizeof(uint32_t)];
  interleave(words);
  std::memcpy(out, words, kWords * hn::Lanes(DU()) * sizeof(uint32_t));
}

/// The formats: pixels of kWords words of 32 bits, written one vector of pixels after the other.
struct Unorm8 {
  static constexpr size_t kWords = 1;
  static HWY_INLINE void Encode(const VF (&p)[4], unsigned char* out) { StorePixels(Unorm8Codes<4>(p), out); }
};
struct Srgb8 {
  static constexpr size_t kWords = 1;
  static HWY_INLINE void Encode(const VF (&p)[4], unsigned char* out) {
    const VU rgb[3] = {SrgbCode(p[0]), SrgbCode(p[1]), SrgbCode(p[2])};
    StorePixels(hn::Or(PackCodes(rgb), hn::ShiftLeft<24>(Unorm8Codes<1>(p + 3))), out);
  }
};
struct Unorm16 {
  static constexpr size_t kWords = 2;
  static HWY_INLINE void Encode(const VF (&p)[4], unsigned char* out) {
    const VU low = hn::Or(UnormCode<16>(p[0]), hn::ShiftLeft<16>(UnormCode<16>(p[1])));
    const VU high = hn::Or(UnormCode<16>(p[2]), hn::ShiftLeft<16>(UnormCode<16>(p[3])));
    StorePixels<kWords>([&](uint32_t* words) { hn::StoreInterleaved2(low, high, DU(), words); }, out);
  }
};
struct Half {
  static constexpr size_t kWords = 2;
  static HWY_INLINE void Encode(const VF (&p)[4], unsigned char* out) {
    const VU low = hn::Or(HalfBits(p[0]), hn::ShiftLeft<16>(HalfBits(p[1])));
    const VU high = hn::Or(HalfBits(p[2]), hn::ShiftLeft<16>(HalfBits(p[3])));
    StorePixels<kWords>([&](uint32_t* words) { hn::StoreInterleaved2(low, high, DU(), words); }, out);
  }
};
struct Float {
  static constexpr size_t kWords = 4;
  static HWY_INLINE void Encode(const VF (&p)[4], unsigned char* out) {
    const DU du;
    const VU r = hn::BitCast(du, p[0]), g = hn::BitCast(du, p[1]), b = hn::BitCast(du, p[2]), a = hn::BitCast(du, p[3]);
    StorePixels<kWords>([&](uint32_t* words) { hn::StoreInterleaved4(r, g, b, a, du, words); }, out);
  }
};

template <class Pixel>
void EncodeRow(const float* const plane[4], size_t count, unsigned char* out) {
  const DF d;
  const size_t lanes = hn::Lanes(d);
  constexpr size_t kBytes = Pixel::kWords * sizeof(uint32_t);
  size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    const VF p[4] = {hn::LoadU(d, plane[0] + i), hn::LoadU(d, plane[1] + i), hn::LoadU(d, plane[2] + i),
                     hn::LoadU(d, plane[3] + i)};
    Pixel::Encode(p, out + i * kBytes);
  }
  if (i == count) return;
  float rest[4][HWY_MAX_BYTES / sizeof(float)] = {};
  for (size_t c = 0; c < 4; ++c) std::memcpy(rest[c], plane[c] + i, (count - i) * sizeof(float));
  const VF p[4] = {hn::LoadU(d, rest[0]), hn::LoadU(d, rest[1]), hn::LoadU(d, rest[2]), hn::LoadU(d, rest[3])};
  unsigned char pixels[Pixel::kWords * HWY_MAX_BYTES];
  Pixel::Encode(p, pixels);
  std::memcpy(out + i * kBytes, pixels, (count - i) * kBytes);
}

void Encode(shd_format format, const float* const plane[4], size_t count, void* out) {
  auto* bytes = static_cast<unsigned char*>(out);
  switch (format) {
    case SHD_FORMAT_RGBA8: return EncodeRow<Unorm8>(plane, count, bytes);
    case SHD_FORMAT_RGBA8_SRGB: return EncodeRow<Srgb8>(plane, count, bytes);
    case SHD_FORMAT_RGBA16: return EncodeRow<Unorm16>(plane, count, bytes);
    case SHD_FORMAT_RGBA16F: return EncodeRow<Half>(plane, count, bytes);
    default: return EncodeRow<Float>(plane, count, bytes);
  }
}

}  // namespace shd::image::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::image {
namespace {
HWY_EXPORT(Encode);

/// Decodes pixels, and calls store(pixel, channel, value) for each of four channels.
template <size_t kChannels, class Store>
void decode(Component component, const uint8_t* pixel, ptrdiff_t step, size_t count, const Store& store) {
  const auto each = [&](auto code, const auto& value) {
    for (size_t i = 0; i < count; ++i, pixel += step) {
      decltype(code) channel[kChannels];
      std::memcpy(channel, pixel, sizeof channel);
      for (size_t c = 0; c < kChannels; ++c) store(i, c, value(channel[c], c));
      for (size_t c = kChannels; c < 4; ++c) store(i, c, c == 3 ? 1.0f : 0.0f);
    }
  };
  const auto unorm = [](auto code, size_t) { return unorm_value<float>(code); };
  switch (component) {
    case Component::kUnorm8: return each(uint8_t{}, unorm);
    case Component::kSrgb8:
      return each(uint8_t{}, [&](uint8_t code, size_t c) { return c == 3 ? unorm(code, c) : srgb8_to_linear(code); });
    case Component::kUnorm16: return each(uint16_t{}, unorm);
    case Component::kFloat16: return each(uint16_t{}, [](uint16_t half, size_t) { return half_to_float(half); });
    case Component::kFloat32: return each(float{}, [](float value, size_t) { return value; });
    case Component::kRgb9e5: break;  // decode_shared()
  }
}

/// decode() of three numbers of 9 bits with one exponent (OpenGL extension EXT_texture_shared_exponent).
template <class Store>
void decode_shared(const uint8_t* pixel, ptrdiff_t step, size_t count, const Store& store) {
  for (size_t i = 0; i < count; ++i, pixel += step) {
    const auto word = load_as<uint32_t>(pixel);
    const float unit = std::ldexp(1.0f, static_cast<int>(word >> 27) - 24);
    for (size_t c = 0; c < 3; ++c) store(i, c, static_cast<float>(word >> 9 * c & 511) * unit);
    store(i, 3, 1.0f);
  }
}

template <class Store>
void decode(shd_format format, const void* in, ptrdiff_t step, size_t count, const Store& store) {
  const auto* const pixel = static_cast<const uint8_t*>(in);
  const FormatInfo info = format_info(format);
  if (info.component == Component::kRgb9e5) return decode_shared(pixel, step, count, store);
  switch (info.channels) {
    case 1: return decode<1>(info.component, pixel, step, count, store);
    case 2: return decode<2>(info.component, pixel, step, count, store);
    case 3: return decode<3>(info.component, pixel, step, count, store);
    default: return decode<4>(info.component, pixel, step, count, store);
  }
}

}  // namespace

void encode_pixels(const core::SimdTarget& simd, shd_format format, const float* const plane[4], size_t count,
                   void* out) {
  SHD_DISPATCH(Encode, simd)(format, plane, count, out);
}

void decode_pixels(shd_format format, const void* in, size_t count, float* const plane[4]) {
  decode(format, in, static_cast<ptrdiff_t>(format_info(format).pixel_size), count,
         [&](size_t i, size_t c, float value) { plane[c][i] = value; });
}

void decode_pixels(shd_format format, const void* in, ptrdiff_t step, size_t count, float* rgba) {
  decode(format, in, step, count, [&](size_t i, size_t c, float value) { rgba[4 * i + c] = value; });
}

}  // namespace shd::image
#endif
