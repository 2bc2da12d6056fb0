// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "abi/lookup.h"
#include "texture/texture.h"

namespace shd::abi {

/// A call of shd_texture_sample() whose columns kernels can use in place: they are sound, apart, and packed or of one
/// element; no derivatives are wanted; one thread takes all lookups. Most calls are in place, and reading them takes a
/// few nanoseconds. Other calls, and all wrong ones, are checked with a message for each error.
class CallInPlace {
 public:
  texture::Lookups in;
  texture::Texels out;

  /// Returns false if the call is not in place. `needs_w`: that of the texture. `compares`: the sampler compares.
  [[gnu::always_inline]] bool read(const shd_lookups* lookups, const shd_texels* texels, bool needs_w, bool compares) {
    if (!has_size(lookups, sizeof *lookups)) return false;
    if (!has_size(texels, sizeof *texels) && !has_size(texels, 0)) return false;
    const size_t count = in.count = lookups->count;
    if (count - 1 >= batch_detail::kTaskElements) return false;
    Hull inputs, outputs;
    in.u = inputs.use(lookups->u);
    in.v = inputs.use(lookups->v);
    in.dudx = inputs.use(lookups->dudx);
    in.dvdx = inputs.use(lookups->dvdx);
    in.dudy = inputs.use(lookups->dudy);
    in.dvdy = inputs.use(lookups->dvdy);
    in.lod = inputs.use(lookups->lod);
    in.layer = inputs.use(lookups->layer);
    in.random = inputs.use(lookups->random);
    if (HWY_UNLIKELY(needs_w)) {
      in.w = inputs.use(lookups->w);
      in.dwdx = inputs.use(lookups->dwdx);
      in.dwdy = inputs.use(lookups->dwdy);
    }
    if (HWY_UNLIKELY(compares)) in.reference = inputs.use(lookups->reference);
    out.channel[0] = outputs.use(texels->channel[0]);
    out.channel[1] = outputs.use(texels->channel[1]);
    out.channel[2] = outputs.use(texels->channel[2]);
    out.channel[3] = outputs.use(texels->channel[3]);
    for (size_t c = 0; c < 4; ++c) out.du[c] = out.dv[c] = nullptr;
    if (!in.u || !in.v || (needs_w && !in.w) || outputs.most == 0 || wants_more(*texels)) return false;
    const size_t strides = inputs.strides | outputs.strides;
    if ((inputs.addresses | outputs.addresses | strides) % batch_detail::kElementSize != 0) return false;
    if ((strides & ~batch_detail::kElementSize) != 0 && (count != 1 || strides > PTRDIFF_MAX)) return false;
    const size_t size = count * batch_detail::kElementSize;
    return (inputs.is_apart(outputs, size) && channels_apart(size)) || columns_apart(size);
  }

 private:
  /// The bits of columns, and the range of their first bytes. Absent columns are not in the range.
  struct Hull {
    uintptr_t addresses = 0;
    size_t strides = 0;
    uintptr_t before = UINTPTR_MAX, most = 0;  // the byte before the least address, and the greatest address

    template <class Column>
    [[gnu::always_inline]] decltype(Column::data) use(const Column& column) {
      const auto address = reinterpret_cast<uintptr_t>(column.data);
      addresses |= address;
      strides |= column.stride;
      before = address - 1 < before ? address - 1 : before;  // UINTPTR_MAX for absent columns
      most = address > most ? address : most;
      return column.data;
    }

    /// Whether no column of `size` bytes shares a byte with one of the other hull.
    bool is_apart(const Hull& other, size_t size) const {
      return other.before >= most + (size - 1) || before >= other.most + (size - 1);
    }
  };

  template <class Desc>
  static bool has_size(const Desc* desc, size_t size) {
    return desc && reinterpret_cast<uintptr_t>(desc) % alignof(Desc) == 0 && desc->struct_size == size;
  }

  /// Whether derivatives are wanted, or the column that textures in tiles have.
  static bool wants_more(const shd_texels& texels) {
    const auto bits = [](const auto& column) { return reinterpret_cast<uintptr_t>(column.data); };
    const auto rates = [&](size_t c) { return bits(texels.du[c]) | bits(texels.dv[c]) | bits(texels.dw[c]); };
    return (bits(texels.coarser) | rates(0) | rates(1) | rates(2) | rates(3)) != 0;
  }

  /// Whether two columns of `size` bytes share no byte.
  static bool are_apart(const void* a, const void* b, size_t size) {
    return reinterpret_cast<uintptr_t>(a) - reinterpret_cast<uintptr_t>(b) + size - 1 >= 2 * size - 1;
  }

  /// Whether the output columns share no byte.
  [[gnu::always_inline]] bool channels_apart(size_t size) const {
    const auto apart = [&](size_t a, size_t b) { return are_apart(out.channel[a], out.channel[b], size); };
    return (!out.channel[1] || apart(1, 0)) && (!out.channel[2] || (apart(2, 0) && apart(2, 1))) &&
           (!out.channel[3] || (apart(3, 0) && apart(3, 1) && apart(3, 2)));
  }

  /// Whether no output column shares a byte with another column, for columns in any order.
  [[gnu::noinline]] bool columns_apart(size_t size) const {
    if (!channels_apart(size)) return false;
    for (const float* channel : out.channel) {
      for (size_t c = 0; channel && c < texture::kFloatColumns; ++c) {
        if (!are_apart(in.real(c), channel, size)) return false;
      }
      for (size_t c = 0; channel && c < texture::kIntegerColumns; ++c) {
        if (!are_apart(in.integer(c), channel, size)) return false;
      }
    }
    return true;
  }
};

}  // namespace shd::abi
