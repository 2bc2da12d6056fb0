// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>

#include "abi/lookup.h"
#include "data/column.h"
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
    count_ = in.count = lookups->count;
    if (count_ == 0 || count_ > batch_detail::kTaskElements) return false;
    for (size_t c = 0; c < texture::kPlaneColumns; ++c) in.real(c) = use(lookups->*kFloatRows[c].column, &read_);
    in.w = in.dwdx = in.dwdy = nullptr;
    if (needs_w) use_third(*lookups);
    if (HWY_UNLIKELY(compares)) in.reference = use(lookups->reference, &read_);
    for (size_t c = 0; c < std::size(kIntegerRows); ++c) in.integer(c) = use(lookups->*kIntegerRows[c].column, &read_);
    for (size_t c = 0; c < 4; ++c) {
      out.channel[c] = use(texels->channel[c], &written_);
      out.du[c] = out.dv[c] = out.dw[c] = nullptr;
    }
    return sound_ && !wants_more(*texels) && in.u && in.v && (in.w || !needs_w) && written_.count > 0 && are_apart();
  }

 private:
  /// The first bytes of columns, and the least and the greatest of them.
  template <size_t kMax>
  struct Places {
    size_t count = 0;
    uintptr_t first[kMax];
    uintptr_t least = UINTPTR_MAX, most = 0;

    void add(uintptr_t address) {
      first[count++] = address;
      least = address < least ? address : least;
      most = address > most ? address : most;
    }
  };

  size_t count_;
  bool sound_ = true;
  Places<kLookupColumns> read_;
  Places<4> written_;

  template <class Desc>
  static bool has_size(const Desc* desc, size_t size) {
    return desc && reinterpret_cast<uintptr_t>(desc) % alignof(Desc) == 0 && desc->struct_size == size;
  }

  /// Returns the elements of a column.
  template <class Column, size_t kMax>
  decltype(Column::data) use(const Column& column, Places<kMax>* places) {
    if (!column.data) return nullptr;
    const auto address = reinterpret_cast<uintptr_t>(column.data);
    const bool adjacent = data::is_packed(column.stride) || (count_ == 1 && column.stride <= PTRDIFF_MAX);
    sound_ = sound_ && adjacent && (address | column.stride) % batch_detail::kElementSize == 0;
    places->add(address);
    return column.data;
  }

  /// Whether derivatives are wanted, or the column that textures in tiles have.
  static bool wants_more(const shd_texels& texels) {
    auto any = reinterpret_cast<uintptr_t>(texels.coarser.data);
    for (size_t c = 0; c < 4; ++c) {
      any |= reinterpret_cast<uintptr_t>(texels.du[c].data) | reinterpret_cast<uintptr_t>(texels.dv[c].data) |
             reinterpret_cast<uintptr_t>(texels.dw[c].data);
    }
    return any != 0;
  }

  /// Uses the columns of the third coordinate.
  [[gnu::noinline]] void use_third(const shd_lookups& lookups) {
    for (size_t c = texture::kPlaneColumns; c < texture::kPlaceColumns; ++c) {
      in.real(c) = use(lookups.*kFloatRows[c].column, &read_);
    }
  }

  bool are_apart() const {
    const size_t size = count_ * batch_detail::kElementSize;
    bool apart = true;
    const auto compare = [&](uintptr_t a, uintptr_t b) { apart = apart && a - b + size - 1 >= 2 * size - 1; };
    // Columns often lie in a structure of inputs and one of outputs.
    const bool disjoint = written_.least > read_.most
                              ? written_.least - read_.most >= size
                              : read_.least > written_.most && read_.least - written_.most >= size;
    for (size_t w = 0; w < written_.count; ++w) {
      for (size_t r = 0; r < read_.count && !disjoint; ++r) compare(written_.first[w], read_.first[r]);
      for (size_t other = 0; other < w; ++other) compare(written_.first[w], written_.first[other]);
    }
    return apart;
  }
};

}  // namespace shd::abi
