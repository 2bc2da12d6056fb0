// SPDX-License-Identifier: MIT
/// @file
/// Sizes of the structs that begin with struct_size, from the table of sized_structs.h. Links to nothing.
///
/// Version 0.1 is the first one, so no caller of a released header has less than its layout. The library still accepts
/// smaller structs that contain every required field: later fields have defaults. Only fields up to the required one
/// are read from a struct without a check of its struct_size.
///
/// A size is a multiple of the alignment of the struct, as C makes it: other sizes would cut a pointer in two. A field
/// that raises the alignment needs a row that accepts the older sizes too.
#pragma once

#include <cstddef>

#include <shd/color.h>
#include <shd/io.h>
#include <shd/scene.h>
#include <shd/shadow.h>
#include <shd/shd.h>
#include <shd/texture_file.h>
#include <shd/tile_file.h>
#include <shd/volume_file.h>

#include "core/read_desc.h"
#include "core/sized_structs.h"

namespace shd::core {

constexpr size_t round_up(size_t size, size_t alignment) {
  return (size + alignment - 1) / alignment * alignment;
}

/// `kRule` has the smallest struct_size that is accepted, and `kFirst` is the size in 0.1.
template <class Desc>
struct DescSize;

#if defined(__LP64__) || defined(_LP64)
#define SHD_FIRST_SIZE_IS(first, size) ((first) == (size))
#else
#define SHD_FIRST_SIZE_IS(first, size) true  // sizes are stated for LP64 only
#endif
#define SHD_DESC_SIZE(kind, type, required, last, size)                                    \
  template <>                                                                              \
  struct DescSize<type> {                                                                  \
    static constexpr size_t kRequired = offsetof(type, required) + sizeof(type::required); \
    static constexpr size_t kFirst = offsetof(type, last) + sizeof(type::last);            \
    static_assert(kRequired <= kFirst, #type);                                             \
    static_assert(SHD_FIRST_SIZE_IS(kFirst, size), "fields of 0.1 moved: " #type);         \
    static_assert(SHD_FIRST_SIZE_IS((size) % alignof(type), 0), "alignment rose: " #type); \
    static constexpr SizeRule kRule = {round_up(kRequired, alignof(type)), alignof(type)}; \
  };
SHD_SIZED_STRUCTS(SHD_DESC_SIZE)
#undef SHD_DESC_SIZE
#undef SHD_FIRST_SIZE_IS

}  // namespace shd::core
