// SPDX-License-Identifier: MIT
#include "tool/shadows.h"

#include "command/failure.h"

namespace {

shd_shadow_desc desc_of(const Options& options, const Bounds& bounds, shd_light_kind kind) {
  shd_shadow_desc desc = shd_shadow_desc_default();
  const float soft = options.softness * bounds.radius;
  desc.size = options.shadow_size;
  desc.filter = *options.shadows;
  desc.taps = desc.filter == SHD_SHADOW_FILTER_PCSS ? 11 : desc.filter == SHD_SHADOW_FILTER_PCF ? 3 : 5;
  desc.filter_size = soft;
  // For directional lights: the width of a penumbra at the distance of one radius. For other lights: the size of the
  // light.
  desc.light_size = kind == SHD_LIGHT_KIND_DIRECTIONAL ? 4.0f * options.softness : 4.0f * soft;
  desc.bleed = 0.2f;
  return desc;
}

}  // namespace

std::vector<Shadow> make_shadows(shd_context* context, const Options& options, const Bounds& bounds, const Draws& draws,
                                 const std::vector<StageLight>& lights) {
  std::vector<Shadow> shadows;
  if (!options.shadows) return shadows;
  for (const StageLight& light : lights) {
    Shadow shadow;
    if (light.casts) {
      const shd_shadow_desc desc = desc_of(options, bounds, light.kind);
      shd_shadow_render_desc render = shd_shadow_render_desc_default();
      render.light = light.light.get();
      render.draws = draws.draws.data();
      render.draw_count = draws.solid_count;
      for (size_t c = 0; c < 3; ++c) {  // bounds of the model and the nearby floor, not of the whole floor
        render.bounds_min[c] = bounds.center[c] - 2.0f * bounds.radius;
        render.bounds_max[c] = bounds.center[c] + 2.0f * bounds.radius;
      }
      check(shd_shadow_create(context, &desc, shadow.out()), "shadow");
      check(shd_shadow_render(context, shadow.get(), &render), "shadow");
    }
    shadows.push_back(std::move(shadow));
  }
  return shadows;
}
