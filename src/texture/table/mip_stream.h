// SPDX-License-Identifier: MIT
/// @file
/// Mip levels of an image whose rows arrive from top to bottom, with the bits of build_mip_levels() (MipStream) and,
/// for normals, of filter_level() with the box (NormalStream). The image itself is never in memory.
///
/// Sums are added in the order of the builders. Levels that halve evenly need two unrounded rows of each level. Levels
/// after an uneven step need one row of sums each, to which every row of the base is added. All of this is `state`,
/// plain numbers: a copy of it and the number of rows continue an interrupted stream.
///
///   push    adds rows of the base and stores the rows of levels that they complete
///   state   numbers that the next push() needs; 0 before the first row
///
/// `parallel(count, body)` runs body(0) .. body(count - 1) in any order or at the same time.
#pragma once

#include <vector>

#include "texture/table/halve.h"
#include "texture/table/mip_axis.h"
#include "texture/table/mip_normal.h"
#include "texture/table/tables.h"

namespace shd::texture {

/// Rows of the base.
struct StreamRows {
  const uint8_t* texels;
  size_t stride;   // bytes between rows
  uint32_t first;  // row of the first one; even, and `count` is even unless they are the last rows
  uint32_t count;

  const uint8_t* row(uint32_t y) const { return texels + (y - first) * stride; }
  uint32_t end() const { return first + count; }
};

/// Number of rows of a level that `rows` rows of the base complete.
inline uint32_t completed_rows(uint32_t height, uint32_t level, uint32_t rows) {
  return static_cast<uint32_t>(uint64_t{rows} * level_size(height, level) / height);
}

/// Sizes of all levels, and where completed rows go.
struct StreamLevels {
  const TexelCodec& codec;
  uint32_t width, height, count;  // size of the base; number of levels with the base

  uint32_t width_of(uint32_t level) const { return level_size(width, level); }
  uint32_t height_of(uint32_t level) const { return level_size(height, level); }
  size_t pitch(uint32_t level) const { return width_of(level) * codec.channels; }
  /// Place of texel (x, y) of a level in the memory for the rows that a push from row `first` on completes.
  uint8_t* texel(uint8_t* const* out, uint32_t first, uint32_t level, uint32_t x, uint32_t y) const {
    const size_t row = y - completed_rows(height, level, first);
    return out[level - 1] + (row * width_of(level) + x) * codec.size;
  }
};

class MipStream {
 public:
  MipStream(const TexelCodec& codec, uint32_t width, uint32_t height)
      : levels_{codec, width, height, full_level_count(width, height)},
        even_(even_halvings(width, height, levels_.count)) {
    size_t size = 0;
    for (uint32_t level = 1; level < levels_.count; ++level) {
      at_.push_back(size);
      size += levels_.pitch(level) * (level <= even_ ? 2 : 1);
    }
    state_.resize(size);
  }

  std::vector<double>& state() { return state_; }

  /// @param out  [levels] memory for the completed rows of level 1, 2 and so on, packed
  template <class Parallel>
  void push(const StreamRows& rows, uint8_t* const* out, const Parallel& parallel) {
    const uint32_t wide = even_ < kSteps ? even_ : kSteps, step = 1u << kSteps;
    if (even_ > 0) {
      for (uint32_t y = rows.first; y < rows.end();) {
        const uint32_t aligned = (y / step + 1) * step, end = aligned < rows.end() ? aligned : rows.end();
        push_even({rows.row(y), rows.stride, y, end - y}, wide, rows.first, out, parallel);
        y = end;
      }
    }
    push_uneven(rows, out, parallel);
  }

 private:
  static constexpr uint32_t kSteps = 6;       // levels of a task
  static constexpr uint32_t kColumns = 1024;  // base columns of a task, a multiple of 2^kSteps
  static constexpr uint32_t kTexels = 256;    // texels of an uneven level that one task computes

  double* state_of(uint32_t level) { return state_.data() + at_[level - 1]; }

  /// Adds rows that lie between two multiples of 2^kSteps to the levels that halve evenly.
  template <class Parallel>
  void push_even(const StreamRows& rows, uint32_t wide, uint32_t first, uint8_t* const* out, const Parallel& parallel) {
    const Walk walk{*this, out, first, wide};
    parallel((levels_.width + kColumns - 1) / kColumns, [&](size_t task) {
      const auto x = static_cast<uint32_t>(task) * kColumns;
      const uint32_t width = levels_.width - x < kColumns ? levels_.width - x : kColumns;
      for (uint32_t y = rows.first; y<rows.end(); y += levels_.height> 1 ? 2 : 1) {
        double* to = state_of(1) + (y / 2 & 1) * levels_.pitch(1) + x / 2 * levels_.codec.channels;
        const size_t offset = x * levels_.codec.size;
        halve_texels(levels_.codec, rows.row(y) + offset, rows.row(levels_.height > 1 ? y + 1 : y) + offset, width, to);
        walk.row(1, y / 2, x / 2, width > 1 ? width / 2 : 1);
      }
    });
    const uint32_t row = completed_rows(levels_.height, wide, rows.end());
    if (wide < even_ && row > completed_rows(levels_.height, wide, rows.first)) {
      Walk{*this, out, first, even_}.next(wide, row - 1, 0, levels_.width_of(wide));
    }
  }

  /// Columns of the levels up to `last`.
  struct Walk {
    MipStream& stream;
    uint8_t* const* out;
    uint32_t first, last;

    /// Stores columns of an unrounded row that is in the state, and continues with the level after it.
    void row(uint32_t level, uint32_t y, uint32_t x, uint32_t width) const {
      const size_t pitch = stream.levels_.pitch(level);
      const TexelCodec& codec = stream.levels_.codec;
      const double* average = stream.state_of(level) + (y & 1) * pitch + x * codec.channels;
      codec.store(average, width, stream.levels_.texel(out, first, level, x, y));
      if (level < last) next(level, y, x, width);
    }

    /// Averages columns of a row of `level`, if it completes a row of the level after it.
    void next(uint32_t level, uint32_t y, uint32_t x, uint32_t width) const {
      const bool pairs = stream.levels_.height_of(level) > 1;
      if (pairs && y % 2 == 0) return;
      const size_t pitch = stream.levels_.pitch(level), channels = stream.levels_.codec.channels;
      const double* from = stream.state_of(level) + x * channels;
      double* to = stream.state_of(level + 1) + (y / 2 & 1) * stream.levels_.pitch(level + 1) + x / 2 * channels;
      halve_rows(channels, from, pairs ? pitch : 0, width, to);
      row(level + 1, y / 2, x / 2, width > 1 ? width / 2 : 1);
    }
  };

  /// Columns of one level.
  struct Task {
    uint32_t level, begin, end;
  };

  template <class Parallel>
  void push_uneven(const StreamRows& rows, uint8_t* const* out, const Parallel& parallel) {
    std::vector<Task> tasks;
    for (uint32_t level = even_ + 1; level < levels_.count; ++level) {
      const uint32_t width = levels_.width_of(level);
      for (uint32_t x = 0; x < width; x += kTexels)
        tasks.push_back({level, x, width - x < kTexels ? width : x + kTexels});
    }
    parallel(tasks.size(), [&](size_t task) { add(tasks[task], rows, out); });
  }

  void add(const Task& task, const StreamRows& rows, uint8_t* const* out) {
    const uint32_t width = levels_.width_of(task.level), height = levels_.height_of(task.level);
    const AxisRange range = level_range({rows.first, rows.end()}, levels_.height, height);
    const double area = static_cast<double>(levels_.width) * levels_.height;
    for (uint32_t y = range.first; y < range.end; ++y) {
      const AxisSpan down(y, levels_.height, height);
      const uint32_t begin = down.first < rows.first ? rows.first : down.first;
      const uint32_t end = down.last < rows.end() ? down.last + 1 : rows.end();
      for (uint32_t x = task.begin; x < task.end; ++x) {
        const AxisSpan across(x, levels_.width, width);
        double* sum = state_of(task.level) + x * levels_.codec.channels;
        for (uint32_t row = begin; row < end; ++row) {
          add_row(levels_.codec, rows.row(row), across, down.weight(row), sum);
        }
        if (down.last >= rows.end()) continue;
        store_averages(levels_.codec, sum, area, 1, levels_.texel(out, rows.first, task.level, x, y));
        for (size_t c = 0; c < levels_.codec.channels; ++c) sum[c] = 0;
      }
    }
  }

  StreamLevels levels_;
  uint32_t even_;           // levels that halve evenly
  std::vector<size_t> at_;  // place of each level in the state
  std::vector<double> state_;
};

/// Mip levels of unit vectors in three or four channels. The state of a level is a row of weighted sums of the columns
/// of the base.
class NormalStream {
 public:
  NormalStream(const TexelCodec& codec, uint32_t width, uint32_t height)
      : levels_{codec, width, height, full_level_count(width, height)},
        state_(levels_.pitch(0) * (levels_.count - 1)) {}

  std::vector<double>& state() { return state_; }

  /// @param out  as for MipStream
  template <class Parallel>
  void push(const StreamRows& rows, uint8_t* const* out, const Parallel& parallel) {
    parallel(levels_.count - 1, [&](size_t task) { add(static_cast<uint32_t>(task) + 1, rows, out); });
  }

 private:
  void add(uint32_t level, const StreamRows& rows, uint8_t* const* out) {
    const uint32_t height = levels_.height_of(level);
    const AxisRange range = level_range({rows.first, rows.end()}, levels_.height, height);
    double* const sums = state_.data() + levels_.pitch(0) * (level - 1);
    for (uint32_t y = range.first; y < range.end; ++y) {
      const AxisSpan down(y, levels_.height, height);
      const uint32_t begin = down.first < rows.first ? rows.first : down.first;
      const uint32_t end = down.last < rows.end() ? down.last + 1 : rows.end();
      for (uint32_t row = begin; row < end; ++row) accumulate_row(rows.row(row), down.weight(row), sums);
      if (down.last >= rows.end()) continue;
      store(level, sums, levels_.texel(out, rows.first, level, 0, y));
      for (size_t i = 0; i < levels_.pitch(0); ++i) sums[i] = 0;
    }
  }

  void accumulate_row(const uint8_t* texels, double weight, double* sums) const {
    const TexelCodec& codec = levels_.codec;
    for_runs(codec, texels, levels_.width, [&](const double* numbers, size_t count) {
      for (size_t x = 0; x < count; ++x, numbers += codec.channels) {
        double value[4];
        for (size_t c = 0; c < codec.channels; ++c) value[c] = numbers[c];
        decode_normal(codec, false, value);
        for (size_t c = 0; c < codec.channels; ++c) *sums++ += weight * value[c];
      }
    });
  }

  void store(uint32_t level, const double* sums, uint8_t* texel) const {
    const double area = static_cast<double>(levels_.width) * levels_.height;
    const uint32_t width = levels_.width_of(level);
    const TexelCodec& codec = levels_.codec;
    for (uint32_t x = 0; x < width; ++x, texel += codec.size) {
      const AxisSpan across(x, levels_.width, width);
      double mean[4] = {};
      for (uint32_t column = across.first; column <= across.last; ++column) {
        for (size_t c = 0; c < codec.channels; ++c) {
          mean[c] += across.weight(column) * sums[column * codec.channels + c];
        }
      }
      for (size_t c = 0; c < codec.channels; ++c) mean[c] /= area;
      encode_normal(codec, mean);
      for (size_t c = 0; c < codec.channels; ++c) mean[c] = codec.clamp(c, mean[c]);
      codec.store(mean, 1, texel);
    }
  }

  StreamLevels levels_;
  std::vector<double> state_;
};

}  // namespace shd::texture
