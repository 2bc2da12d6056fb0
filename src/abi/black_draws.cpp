// SPDX-License-Identifier: MIT
#include "abi/black_draws.h"

#include "material/material.h"

namespace shd::abi {

namespace {

/// Whether a material has no colour without light: it has lobes and does not emit.
bool needs_light(const material::Material& material) {
  const bool emits = material.emission[0] > 0.0f || material.emission[1] > 0.0f || material.emission[2] > 0.0f;
  return material::info_of(material.model).lobes != 0 && !emits;
}

/// The caller's draws that `is_black` accepts; an instance counts with its draw.
struct Found {
  size_t count = 0;
  uint32_t first = 0;
};
template <class Test>
Found find(const frame::Frame& frame, Test&& is_black) {
  Found found;
  uint32_t last = 0;
  for (size_t i = 0; i < frame.draw_count; ++i) {
    const frame::Draw& draw = frame.draws[i];
    if (!is_black(draw) || (found.count != 0 && draw.index == last)) continue;
    if (found.count++ == 0) found.first = draw.index;
    last = draw.index;
  }
  return found;
}

}  // namespace

uint64_t report_black_draws(const core::Context& context, const frame::Frame& frame) {
  const Found bare = find(frame, [](const frame::Draw& draw) { return !draw.material; });
  if (bare.count) {
    core::log(context, SHD_LOG_LEVEL_INFO,
              "render.draws[%u]: no material, so no colour is written (draws like it: %zu)", bare.first, bare.count);
  }
  if (frame.light_count != 0 || frame.environment.map) return bare.count;
  const Found dark = find(frame, [](const frame::Draw& draw) { return draw.material && needs_light(*draw.material); });
  if (dark.count) {
    core::log(context, SHD_LOG_LEVEL_INFO,
              "render.draws[%u]: no lights and no environment, so it is black (draws like it: %zu)", dark.first,
              dark.count);
  }
  return bare.count + dark.count;
}

}  // namespace shd::abi
