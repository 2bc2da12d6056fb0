// SPDX-License-Identifier: MIT
#include "color/apply.h"

#include <algorithm>
#include <atomic>
#include <cstdio>

#include "core/guard.h"
#include "extension/error.h"

namespace shd::color {
namespace {

/// Pixels of one task. Fixed, so that spans start at the same pixels whatever the number of workers.
constexpr size_t kTask = 16 * kSpan;

/// run(first, count, span) over all pixels, in spans.
template <class Run>
void for_each_span(shd_context* context, size_t pixels, const Run& run) {
  struct Job {
    const Run& run;
    size_t pixels;
    std::atomic<bool> failed{false};
    char text[512] = "";  // written by the one task that sets failed
  };
  Job job{run, pixels};
  const auto task = [](void* data, uint32_t index, uint32_t) {
    Job& mine = *static_cast<Job*>(data);
    const size_t begin = index * kTask;
    const size_t end = std::min(mine.pixels, begin + kTask);
    const auto note = [&](shd_result code, const char* text) {
      if (!mine.failed.exchange(true)) std::snprintf(mine.text, sizeof mine.text, "%s", text);
      return code;
    };
    core::guard(note, [&] {
      Span span;
      for (size_t first = begin; first < end; first += kSpan) mine.run(first, std::min(kSpan, end - first), &span);
      return SHD_OK;
    });
  };
  const auto tasks = static_cast<uint32_t>((pixels + kTask - 1) / kTask);
  extension::require(shd_context_parallel_for(context, tasks, task, &job));
  if (job.failed) extension::refuse(SHD_ERROR_INTERNAL, "color transform: %s", job.text);
}

}  // namespace

void apply_planes(shd_context* context, const Transform& transform, const Planes& in, const shd_image& out) {
  for_each_span(context, size_t{in.width} * in.height, [&](size_t first, size_t count, Span* span) {
    load_planes(in, first, count, span);
    unpremultiply(span, count);
    transform.apply(span->r, span->g, span->b, count);
    store_pixels(*span, out, first, count);
  });
}

void apply_image(shd_context* context, const Transform& transform, const shd_image& in, const shd_image& out) {
  for_each_span(context, size_t{in.width} * in.height, [&](size_t first, size_t count, Span* span) {
    load_image(in, first, count, span);
    unpremultiply(span, count);
    transform.apply(span->r, span->g, span->b, count);
    store_pixels(*span, out, first, count);
  });
}

void apply_in_place(shd_context* context, const Transform& transform, const shd_image& in_out) {
  for_each_span(context, size_t{in_out.width} * in_out.height, [&](size_t first, size_t count, Span* span) {
    load_image(in_out, first, count, span);
    clean_color(span, count);
    transform.apply(span->r, span->g, span->b, count);
    store_color(*span, in_out, first, count);
  });
}

}  // namespace shd::color
