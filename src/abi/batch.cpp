// SPDX-License-Identifier: MIT
#include "abi/batch.h"

#include <cstdio>

#include "abi/desc.h"

namespace shd::abi {
namespace {

/// The name of a column, as "lookups.u" or "texels.channel[0]".
struct ColumnName {
  char text[64];

  template <class Void>
  explicit ColumnName(const BatchColumn<Void>& column) {
    if (column.index < 0) {
      std::snprintf(text, sizeof text, "%s", column.name);
    } else {
      std::snprintf(text, sizeof text, "%s[%d]", column.name, column.index);
    }
  }
};

/// Whether check_column() accepts a column. A lookup of one point would spend most of its time on names for messages.
template <class Void>
bool is_sound(const BatchColumn<Void>& column, size_t count) {
  if (!column.data) return !column.required || count == 0;
  constexpr size_t kSize = batch_detail::kElementSize;
  size_t bytes;
  return (reinterpret_cast<uintptr_t>(column.data) | column.stride) % kSize == 0 &&
         !__builtin_mul_overflow(column.stride ? column.stride : kSize, count, &bytes) && bytes <= PTRDIFF_MAX;
}

template <class Void>
shd_result check_each(const BatchColumn<Void>* columns, size_t column_count, size_t count) {
  for (size_t c = 0; c < column_count; ++c) {
    if (is_sound(columns[c], count)) continue;
    const ColumnName name(columns[c]);
    SHD_TRY(check_column(name.text, columns[c].data, columns[c].stride, count));
    if (columns[c].required && count > 0 && !columns[c].data) {
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s.data: NULL", name.text);
    }
  }
  return SHD_OK;
}

/// Where a column lies: element i at first + i * stride, i < count.
struct Extent {
  uintptr_t first;
  size_t stride, count;

  template <class Void>
  Extent(const BatchColumn<Void>& column, size_t column_count)
      : first(reinterpret_cast<uintptr_t>(column.data)),
        stride(column.stride ? column.stride : batch_detail::kElementSize),
        count(column_count) {}
  uintptr_t last() const { return first + (count - 1) * stride; }
};

/// Whether `packed`, which has no gaps, holds an element of `other`.
bool holds_element(const Extent& packed, const Extent& other) {
  if (other.last() < packed.first || other.first > packed.last()) return false;
  if (other.first >= packed.first) return true;
  const size_t skipped = (packed.first - other.first + other.stride - 1) / other.stride;
  return other.first + skipped * other.stride <= packed.last();
}

bool overlap(const Extent& a, const Extent& b) {
  if (a.stride == batch_detail::kElementSize) return holds_element(a, b);
  if (b.stride == batch_detail::kElementSize) return holds_element(b, a);
  if (a.stride != b.stride || a.last() < b.first || b.last() < a.first) return false;
  const uintptr_t apart = a.first > b.first ? a.first - b.first : b.first - a.first;
  if (apart < a.stride) return apart == 0;  // fields of one record, without a division
  return apart % a.stride == 0;
}

template <class Void>
shd_result check_pair(const OutColumn& out, const BatchColumn<Void>& other, size_t count) {
  if (!other.data || !overlap(Extent(out, count), Extent(other, count))) return SHD_OK;
  return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: overlaps %s", ColumnName(out).text, ColumnName(other).text);
}

}  // namespace

shd_result check_columns(const InColumn* columns, size_t column_count, size_t count) {
  return check_each(columns, column_count, count);
}

shd_result check_columns(const OutColumn* columns, size_t column_count, size_t count) {
  return check_each(columns, column_count, count);
}

shd_result check_overlap(const InColumn* in, size_t in_count, const OutColumn* out, size_t out_count, size_t count) {
  if (count == 0) return SHD_OK;
  for (size_t c = 0; c < out_count; ++c) {
    if (!out[c].data) continue;
    for (size_t i = 0; i < in_count; ++i) SHD_TRY(check_pair(out[c], in[i], count));
    for (size_t i = 0; i < c; ++i) SHD_TRY(check_pair(out[c], out[i], count));
  }
  return SHD_OK;
}

}  // namespace shd::abi
