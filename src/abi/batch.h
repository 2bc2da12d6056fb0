// SPDX-License-Identifier: MIT
/// @file
/// Batches: the columns of one call, checked, split over the executor and handed to kernels as packed pieces.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include <shd/column.h>

#include "core/executor.h"
#include "core/status.h"
#include "data/column.h"

namespace shd::abi {

/// A column of a caller, of float or uint32_t. Void is const void for inputs and void for outputs.
template <class Void>
struct BatchColumn {
  const char* name;  // name of its field, in messages
  int index;         // in an array of columns with that name; -1 = none
  bool required;
  Void* data;     // null = absent
  size_t stride;  // bytes from element to element; 0 = packed
};
using InColumn = BatchColumn<const void>;
using OutColumn = BatchColumn<void>;

enum class Need { kOptional, kRequired };

template <class Column>
InColumn in_column(const char* name, const Column& column, Need need, int index = -1) {
  return {name, index, need == Need::kRequired, column.data, column.stride};
}
template <class Column>
OutColumn out_column(const char* name, const Column& column, Need need, int index = -1) {
  return {name, index, need == Need::kRequired, column.data, column.stride};
}

/// Describes the three columns of a vector.
inline void set_vector(const char* name, const shd_f32_in (&columns)[3], Need need, InColumn* out) {
  for (int c = 0; c < 3; ++c) out[c] = in_column(name, columns[c], need, c);
}

/// Elements [0, count) of the columns of a call.
template <size_t kIn, size_t kOut>
struct Batch {
  size_t count;
  std::array<InColumn, kIn> in;
  std::array<OutColumn, kOut> out;
};

/// Elements of a batch next to each other, in the order of its columns; absent columns are null.
template <size_t kIn, size_t kOut>
struct Piece {
  size_t count;
  std::array<const void*, kIn> in;
  std::array<void*, kOut> out;

  const float* floats(size_t column) const { return static_cast<const float*>(in[column]); }
  const uint32_t* integers(size_t column) const { return static_cast<const uint32_t*>(in[column]); }
  float* out_floats(size_t column) const { return static_cast<float*>(out[column]); }
  uint32_t* out_integers(size_t column) const { return static_cast<uint32_t*>(out[column]); }
};

/// Elements first..first + count - 1 of a piece.
template <size_t kIn, size_t kOut>
Piece<kIn, kOut> part_of(const Piece<kIn, kOut>& piece, size_t first, size_t count) {
  Piece<kIn, kOut> part = {count, {}, {}};
  for (size_t c = 0; c < kIn; ++c) part.in[c] = piece.in[c] ? piece.floats(c) + first : nullptr;
  for (size_t c = 0; c < kOut; ++c) part.out[c] = piece.out[c] ? piece.out_floats(c) + first : nullptr;
  return part;
}

/// Alignment, stride and size of each column, and that required ones are there if `count` is not 0.
shd_result check_columns(const InColumn* columns, size_t column_count, size_t count);
shd_result check_columns(const OutColumn* columns, size_t column_count, size_t count);

/// That no output shares an element with an input or another output. Strides that differ are not compared unless one
/// of the two columns is packed.
shd_result check_overlap(const InColumn* in, size_t in_count, const OutColumn* out, size_t out_count, size_t count);

/// All of the above for a batch.
template <size_t kIn, size_t kOut>
shd_result check_batch(const Batch<kIn, kOut>& batch) {
  if (const shd_result result = check_columns(batch.in.data(), kIn, batch.count)) return result;
  if (const shd_result result = check_columns(batch.out.data(), kOut, batch.count)) return result;
  return check_overlap(batch.in.data(), kIn, batch.out.data(), kOut, batch.count);
}

/// All of the above for `kOut` optional outputs alone, which messages name out[0] and on. A null `out` fails.
template <size_t kOut>
shd_result check_outputs(const shd_f32_out* out, uint64_t count) {
  if (!out) return core::fail(SHD_ERROR_INVALID_ARGUMENT, "out: NULL");
  if (count > PTRDIFF_MAX) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "out: %llu elements exceed the address space",
                      static_cast<unsigned long long>(count));
  }
  Batch<0, kOut> batch = {static_cast<size_t>(count), {}, {}};
  for (size_t c = 0; c < kOut; ++c) batch.out[c] = out_column("out", out[c], Need::kOptional, static_cast<int>(c));
  return check_batch(batch);
}

namespace batch_detail {

constexpr size_t kElementSize = sizeof(float);
constexpr size_t kTaskElements = 16384;
constexpr size_t kMaxTasks = size_t{1} << 20;
constexpr size_t kStageElements = 128;  // in a packed copy, if a batch has at most kStageColumns columns
constexpr size_t kStageColumns = 21;    // 11 KB of stack

/// Elements on the stack for packed copies of all columns of a batch.
template <size_t kIn, size_t kOut>
constexpr size_t stage_size() {
  return (kIn + kOut < kStageColumns ? kIn + kOut : kStageColumns) * kStageElements;
}

template <class Columns>
bool is_packed(const Columns& columns) {
  bool packed = true;
  for (const auto& column : columns) packed = packed && (!column.data || data::is_packed(column.stride));
  return packed;
}

template <class Byte, class Void>
Byte* element_of(const BatchColumn<Void>& column, size_t index) {
  return static_cast<Byte*>(column.data) + index * (column.stride ? column.stride : kElementSize);
}

/// Returns elements of packed columns.
template <size_t kIn, size_t kOut>
Piece<kIn, kOut> packed_part(const Batch<kIn, kOut>& batch, size_t first, size_t count) {
  Piece<kIn, kOut> piece = {count, {}, {}};
  for (size_t c = 0; c < kIn; ++c) {
    if (batch.in[c].data) piece.in[c] = element_of<const char>(batch.in[c], first);
  }
  for (size_t c = 0; c < kOut; ++c) {
    if (batch.out[c].data) piece.out[c] = element_of<char>(batch.out[c], first);
  }
  return piece;
}

/// Returns the number of elements of a batch for which packed copies of all columns fit on the stack.
template <size_t kIn, size_t kOut>
size_t staged_elements(const Batch<kIn, kOut>& batch) {
  size_t columns = 0;
  for (const auto& column : batch.in) columns += column.data != nullptr;
  for (const auto& column : batch.out) columns += column.data != nullptr;
  if (columns <= kStageColumns) return kStageElements;
  return stage_size<kIn, kOut>() / columns / 16 * 16;
}

/// run(piece) on up to staged_elements() elements, through packed copies.
template <size_t kIn, size_t kOut, class Run>
void run_staged(const Batch<kIn, kOut>& batch, size_t first, size_t count, Run& run) {
  uint32_t stage[stage_size<kIn, kOut>()], *next = stage;
  const size_t stride = (count + 15) / 16 * 16;
  Piece<kIn, kOut> piece = {count, {}, {}};
  for (size_t c = 0; c < kIn; ++c) {
    if (!batch.in[c].data) continue;
    for (size_t i = 0; i < count; ++i) {
      std::memcpy(&next[i], element_of<const char>(batch.in[c], first + i), kElementSize);
    }
    piece.in[c] = next;
    next += stride;
  }
  for (size_t c = 0; c < kOut; ++c) {
    if (!batch.out[c].data) continue;
    piece.out[c] = next;
    next += stride;
  }
  run(static_cast<const Piece<kIn, kOut>&>(piece));
  for (size_t c = 0; c < kOut; ++c) {
    for (size_t i = 0; batch.out[c].data && i < count; ++i) {
      std::memcpy(element_of<char>(batch.out[c], first + i), static_cast<const uint32_t*>(piece.out[c]) + i,
                  kElementSize);
    }
  }
}

}  // namespace batch_detail

/// Rows of a piece of which one of the first `columns` inputs, all of floats, is not finite.
template <size_t kIn, size_t kOut>
size_t count_nonfinite(const Piece<kIn, kOut>& piece, size_t columns = kIn) {
  constexpr size_t kRows = 256;
  constexpr uint32_t kExponent = 0x7f800000;
  size_t rows = 0;
  for (size_t first = 0; first < piece.count; first += kRows) {
    const size_t count = piece.count - first < kRows ? piece.count - first : kRows;
    uint32_t bad[kRows] = {};
    for (size_t c = 0; c < columns; ++c) {
      if (!piece.in[c]) continue;
      const uint32_t* bits = piece.integers(c) + first;
      for (size_t i = 0; i < count; ++i) bad[i] |= (bits[i] & kExponent) == kExponent;
    }
    for (size_t i = 0; i < count; ++i) rows += bad[i];
  }
  return rows;
}

/// Calls run(piece) for pieces that cover a batch, concurrently on the executor of the context. Packed columns are used
/// where they are, others through copies. The results must not depend on where pieces end.
template <size_t kIn, size_t kOut, class Run>
void run_batch(const core::Context& context, const Batch<kIn, kOut>& batch, Run&& run) {
  using namespace batch_detail;
  const bool packed = is_packed(batch.in) && is_packed(batch.out);
  const auto run_part = [&](size_t first, size_t count) {
    if (packed) return run(packed_part(batch, first, count));
    const size_t fit = staged_elements(batch);
    for (size_t done = 0; done < count; done += fit) {
      run_staged(batch, first + done, count - done < fit ? count - done : fit, run);
    }
  };
  const size_t size = batch.count / kMaxTasks < kTaskElements ? kTaskElements : batch.count / kMaxTasks + 1;
  const auto tasks = static_cast<uint32_t>(batch.count / size + (batch.count % size != 0));
  core::parallel_for(context, tasks, [&](uint32_t task, uint32_t) {
    const size_t first = task * size;
    run_part(first, batch.count - first < size ? batch.count - first : size);
  });
}

/// As run_batch(). Returns the number of rows of which one of the first `columns` inputs is not finite.
template <size_t kIn, size_t kOut, class Run>
size_t run_counting(const core::Context& context, const Batch<kIn, kOut>& batch, size_t columns, Run&& run) {
  std::atomic<size_t> nonfinite{0};
  run_batch(context, batch, [&](const Piece<kIn, kOut>& piece) {
    if (const size_t found = count_nonfinite(piece, columns)) nonfinite.fetch_add(found, std::memory_order_relaxed);
    run(piece);
  });
  return nonfinite.load(std::memory_order_relaxed);
}

/// Calls run(piece) for one element of a batch, on the calling thread.
template <size_t kIn, size_t kOut, class Run>
void run_element(const Batch<kIn, kOut>& batch, size_t index, Run&& run) {
  batch_detail::run_staged(batch, index, 1, run);
}

}  // namespace shd::abi
