// SPDX-License-Identifier: MIT
#include "color/apply.h"

#include <algorithm>
#include <atomic>
#include <cstdio>

#include "core/guard.h"
#include "core/simd_name.h"
#include "extension/error.h"

namespace shd::color {
namespace {

/// Pixels of one task. The number is fixed, so that blocks start at the same pixels for any number of workers.
constexpr size_t kTaskPixels = 16 * kBlockPixels;

/// Calls run(first, count, block) over all pixels, in blocks.
template <class Run>
void for_each_block(shd_context* context, size_t pixels, const Run& run) {
  struct Job {
    const Run& run;
    size_t pixels;
    std::atomic<bool> failed{false};
    char text[512] = "";  // written by the single task that sets failed
  };
  Job job{run, pixels};
  const auto task = [](size_t index, size_t, void* data) {
    Job& mine = *static_cast<Job*>(data);
    const size_t begin = index * kTaskPixels;
    const size_t end = std::min(mine.pixels, begin + kTaskPixels);
    const auto note = [&](shd_result code, const char* text) {
      if (!mine.failed.exchange(true)) std::snprintf(mine.text, sizeof mine.text, "%s", text);
      return code;
    };
    core::guard(note, [&] {
      PixelBlock block;
      for (size_t first = begin; first < end; first += kBlockPixels)
        mine.run(first, std::min(kBlockPixels, end - first), &block);
      return SHD_OK;
    });
  };
  const auto tasks = static_cast<uint32_t>((pixels + kTaskPixels - 1) / kTaskPixels);
  extension::require(shd_context_parallel_for(context, tasks, task, &job));
  if (job.failed) extension::refuse(SHD_ERROR_INTERNAL, "color transform: %s", job.text);
}

core::SimdTarget simd_of(shd_context* context) {
  return core::find_simd_target(shd_context_get_simd_target(context));
}

/// Transforms a block of loaded pixels from `first` on.
void apply_block(const core::SimdTarget& simd, const Transform& transform, PixelBlock* block, size_t first,
                 size_t count, const shd_image& out) {
  unpremultiply(block, count);
  transform.apply(block->r, block->g, block->b, count);
  store_pixels(simd, block, out, first, count);
}

void apply_range(const core::SimdTarget& simd, const Program& program, const Planes& in, size_t first, size_t count,
                 const shd_image& out) {
  for_each_piece(in.width, first, count, [&](size_t row, size_t column, size_t, size_t pixels) {
    const float* plane[4];
    for (size_t c = 0; c < 4; ++c) {
      const auto* bytes = reinterpret_cast<const unsigned char*>(in.plane[c]) + row * in.row_stride[c];
      plane[c] = reinterpret_cast<const float*>(bytes) + column;
    }
    show(simd, program, plane, pixels, pixel_at(out, row, column));
  });
}

}  // namespace

void apply_planes(shd_context* context, const Transform& transform, const Planes& in, const shd_image& out) {
  const core::SimdTarget simd = simd_of(context);
  for_each_block(context, size_t{in.width} * in.height, [&](size_t first, size_t count, PixelBlock* block) {
    load_planes(in, first, count, block);
    apply_block(simd, transform, block, first, count, out);
  });
}

void apply_image(shd_context* context, const Transform& transform, const shd_image& in, const shd_image& out) {
  const core::SimdTarget simd = simd_of(context);
  for_each_block(context, size_t{in.width} * in.height, [&](size_t first, size_t count, PixelBlock* block) {
    load_image(in, first, count, block);
    apply_block(simd, transform, block, first, count, out);
  });
}

void apply_planes(shd_context* context, const Program& program, const Planes& in, const shd_image& out) {
  const core::SimdTarget simd = simd_of(context);
  for_each_block(context, size_t{in.width} * in.height,
                 [&](size_t first, size_t count, PixelBlock*) { apply_range(simd, program, in, first, count, out); });
}

void apply_image(shd_context* context, const Program& program, const shd_image& in, const shd_image& out) {
  const core::SimdTarget simd = simd_of(context);
  for_each_block(context, size_t{in.width} * in.height, [&](size_t first, size_t count, PixelBlock* block) {
    load_image(in, first, count, block);
    for_each_piece(in.width, first, count, [&](size_t row, size_t column, size_t at, size_t pixels) {
      const float* const plane[4] = {block->r + at, block->g + at, block->b + at, block->a + at};
      show(simd, program, plane, pixels, pixel_at(out, row, column));
    });
  });
}

void apply_tile(shd_context* context, const Transform& transform, const Planes& in, const shd_image& out) {
  const core::SimdTarget simd = simd_of(context);
  PixelBlock block;
  const size_t pixels = size_t{in.width} * in.height;
  for (size_t first = 0; first < pixels; first += kBlockPixels) {
    const size_t count = std::min(kBlockPixels, pixels - first);
    load_planes(in, first, count, &block);
    apply_block(simd, transform, &block, first, count, out);
  }
}

void apply_tile(shd_context* context, const Program& program, const Planes& in, const shd_image& out) {
  Rectangle pixels = {{}, {}, in.width, in.height, static_cast<unsigned char*>(out.pixels), out.row_stride};
  std::copy(in.plane, in.plane + 4, pixels.plane);
  std::copy(in.row_stride, in.row_stride + 4, pixels.row_stride);
  show(simd_of(context), program, pixels);
}

void apply_in_place(shd_context* context, const Transform& transform, const shd_image& in_out) {
  const core::SimdTarget simd = simd_of(context);
  for_each_block(context, size_t{in_out.width} * in_out.height, [&](size_t first, size_t count, PixelBlock* block) {
    load_image(in_out, first, count, block);
    clean_color(block, count);
    transform.apply(block->r, block->g, block->b, count);
    store_color(simd, block, in_out, first, count);
  });
}

}  // namespace shd::color
