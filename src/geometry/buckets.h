// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/allocator.h"

namespace shd::geometry {

constexpr uint32_t kNoBucket = ~0u;

/// Numbers sorted into buckets: item[start[b]] .. item[start[b + 1]] are the numbers of bucket b, ascending.
struct Buckets {
  core::Array<uint32_t> start, item;

  const uint32_t* begin(size_t bucket) const { return item.data() + start[bucket]; }
  const uint32_t* end(size_t bucket) const { return item.data() + start[bucket + 1]; }
};

/// Sorts the numbers below `count` by bucket_of(number), which is below bucket_count, or kNoBucket to leave the number
/// out. Throws std::bad_alloc.
template <class BucketOf>
Buckets make_buckets(const core::Allocator& allocator, uint32_t count, uint32_t bucket_count,
                     const BucketOf& bucket_of) {
  Buckets out = {core::Array<uint32_t>(allocator, size_t{bucket_count} + 2), {}};
  out.start.fill_zero();
  uint32_t* next = out.start.data() + 1;  // position of the next number of each bucket; start[b + 1] after the last one
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t bucket = bucket_of(i);
    if (bucket != kNoBucket) ++next[size_t{bucket} + 1];
  }
  for (size_t b = 0; b < bucket_count; ++b) next[b + 1] += next[b];
  out.item = core::Array<uint32_t>(allocator, next[bucket_count]);
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t bucket = bucket_of(i);
    if (bucket != kNoBucket) out.item[next[bucket]++] = i;
  }
  return out;
}

}  // namespace shd::geometry
