// SPDX-License-Identifier: MIT
#include "texture/table/halve.h"

#include <algorithm>

namespace shd::texture {
namespace {

constexpr size_t kRun = 64;  // texels that are decoded or encoded together; even

template <size_t kChannels>
void halve(const double* row, size_t down, uint32_t width, double* to) {
  const size_t right = width > 1 ? kChannels : 0;
  for (uint32_t x = 0; x < (width + 1) / 2; ++x, row += 2 * right) {
    for (size_t c = 0; c < kChannels; ++c) {
      *to++ = 0.25 * ((row[c] + row[c + right]) + (row[c + down] + row[c + right + down]));
    }
  }
}

/// Adds texels to a sum, in their order.
template <size_t kChannels>
void add_texels(const double* texel, const double* end, double* sum) {
  for (; texel < end; texel += kChannels) {
    for (size_t c = 0; c < kChannels; ++c) sum[c] += texel[c];
  }
}

}  // namespace

void halve_rows(size_t channels, const double* row, size_t down, uint32_t width, double* to) {
  with_channels(channels, [&](auto count) { halve<count>(row, down, width, to); });
}

void halve_texels(const TexelCodec& codec, const uint8_t* top, const uint8_t* bottom, uint32_t width, double* to) {
  double rows[2 * kRun * 4];
  for (size_t x = 0; x < width; x += kRun) {
    const size_t run = std::min<size_t>(kRun, width - x), pitch = run * codec.channels;
    codec.load(top + x * codec.size, run, rows);
    codec.load(bottom + x * codec.size, run, rows + pitch);
    halve_rows(codec.channels, rows, pitch, static_cast<uint32_t>(run), to);
    to += (run + 1) / 2 * codec.channels;
  }
}

void add_row(const TexelCodec& codec, const uint8_t* row, const AxisSpan& span, double weight, double* sum) {
  const size_t channels = codec.channels, inner = span.last > span.first ? span.last - span.first - 1 : 0;
  double first[4], last[4], total[4] = {};
  size_t done = 0;  // texels before the run
  for_runs(codec, row + span.first * codec.size, inner + (span.last > span.first ? 2 : 1),
           [&](const double* texel, size_t count) {
             const size_t begin = done == 0 ? 1 : 0, end = std::min(count, inner + 1 - done);
             if (begin == 1) std::copy_n(texel, channels, first);
             with_channels(channels, [&](auto n) { add_texels<n>(texel + begin * n, texel + end * n, total); });
             std::copy_n(texel + (count - 1) * channels, channels, last);
             done += count;
           });
  for (size_t c = 0; c < channels; ++c) {
    total[c] = total[c] * span.full + span.head * first[c];
    if (span.last > span.first) total[c] += span.tail * last[c];
    sum[c] += weight * total[c];
  }
}

void store_averages(const TexelCodec& codec, const double* sums, double area, size_t count, uint8_t* texels) {
  double average[kRun * 4];
  for (size_t x = 0; x < count; x += kRun) {
    const size_t run = std::min(kRun, count - x), size = run * codec.channels;
    for (size_t i = 0; i < size; ++i) average[i] = sums[x * codec.channels + i] / area;
    codec.store(average, run, texels + x * codec.size);
  }
}

}  // namespace shd::texture
