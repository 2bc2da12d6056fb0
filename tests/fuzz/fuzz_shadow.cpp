// SPDX-License-Identifier: MIT
// Shadow maps of random meshes and lights, by every filter. Visibilities lie in 0..1, points without a finite position
// are lit, a refused render leaves the previous map, and a frame with the shadow works.
#include "mesh_case.h"
#include "mutator.h"

namespace shd::fuzz {
namespace {

constexpr size_t kMaxPoints = 6;
constexpr size_t kMaps = 2;

struct Map {
  shd_light_desc light = shd_light_desc_default();
  shd_shadow_render_desc render = shd_shadow_render_desc_default();
  shd_draw draw = shd_draw_default();
};

struct Case {
  shd_shadow_desc shadow = shd_shadow_desc_default();
  MeshCase mesh;
  Map maps[kMaps];
  size_t map_count = 1;
  size_t count = 0;
  bool normals = false;
  float points[6][kMaxPoints] = {};
  uint64_t budget = 0;
};

void choose_shadow(Source& source, shd_shadow_desc& desc) {
  desc.size = source.one_in(32) ? source.below(65536) % 64 : 16 + source.below(9);
  desc.filter = source.constant<shd_shadow_filter>(5);
  desc.taps = source.one_in(16) ? source.below(20) : 1 + source.below(3);
  desc.filter_size = source.one_in(2) ? source.real(0, 2) : 0.0f;
  desc.light_size = source.one_in(2) ? source.real(0, 2) : 0.0f;
  desc.bias = source.one_in(4) ? source.real(0, 1) : 0.0f;
  desc.bias_slope = source.real(0, 2);
  desc.normal_offset = source.one_in(4) ? source.real(0, 1) : 0.0f;
  desc.caster_cull = source.constant<shd_cull>(3);
  desc.bleed = source.one_in(2) ? source.real(0, 0.99f) : 0.0f;
  desc.min_variance = source.one_in(2) ? source.real(0, 1) : 0.0f;
}

void choose_light(Source& source, shd_light_desc& desc) {
  // Directional lights and spots have one map, points six.
  constexpr shd_light_kind kKinds[] = {SHD_LIGHT_KIND_DIRECTIONAL, SHD_LIGHT_KIND_SPOT,    SHD_LIGHT_KIND_DIRECTIONAL,
                                       SHD_LIGHT_KIND_SPOT,        SHD_LIGHT_KIND_AMBIENT, SHD_LIGHT_KIND_POINT};
  desc.kind = kKinds[source.below(6)];
  for (float& value : desc.position) value = source.one_in(16) ? source.hostile_finite() : 3.0f * source.real();
  for (float& value : desc.direction) value = source.one_in(16) ? source.hostile_finite() : source.real();
  for (float& value : desc.up) value = source.real();
  desc.outer_angle = source.real(0.01f, 1.57f);
  desc.inner_angle = 0.5f * desc.outer_angle;
  if (source.one_in(8)) desc.range = source.real(0, 8);
}

void choose_map(Source& source, Map& map) {
  choose_light(source, map.light);
  const bool hostile = source.one_in(16);
  for (int i = 0; i < 12; ++i) {  // the last row stays (0, 0, 0, 1)
    const float value = hostile ? source.hostile() : source.real();
    if (hostile || source.one_in(4)) map.draw.object_to_world[i / 3 * 4 + i % 3] = value;
  }
  map.draw.flags = source.one_in(16) ? source.flags(3) : 0;
  map.draw.fill = source.one_in(8) ? source.constant<shd_fill>(4) : SHD_FILL_SOLID;
  if (source.one_in(4)) {
    map.render.near_plane = source.real(0, 1);
    map.render.far_plane = source.real(0.5f, 8);
  }
  if (source.one_in(4)) {
    for (float& value : map.render.bounds_min) value = source.real(-2, 0);
    for (float& value : map.render.bounds_max) value = source.real(0, 2);
  }
}

void choose_case(Source& source, Case& c) {
  c.budget = choose_budget(source);
  choose_shadow(source, c.shadow);
  c.map_count = source.one_in(4) ? 2 : 1;
  for (size_t i = 0; i < c.map_count; ++i) choose_map(source, c.maps[i]);
  c.count = source.below(kMaxPoints + 1);
  c.normals = source.one_in(2);
  const bool hostile = source.one_in(8);
  for (float(&column)[kMaxPoints] : c.points) {
    for (size_t i = 0; i < c.count; ++i) column[i] = hostile ? source.hostile() : 2.0f * source.real();
  }
  choose_mesh(source, c.mesh, 6, 9);
}

/// Visibilities of the points. Returns false if the lookup was refused.
bool sample(const Host& host, const Case& c, const shd_shadow* shadow, std::vector<float>& out) {
  shd_shadow_lookups lookups = shd_shadow_lookups_default();
  lookups.count = c.count;
  for (int k = 0; k < 3; ++k) {
    lookups.position[k].data = c.points[k];
    if (c.normals) lookups.normal[k].data = c.points[3 + k];
  }
  Column<float> column(c.count, 2, kCanary);
  shd_shadow_values place = shd_shadow_values_default();
  place.visibility = to_column(column);
  const bool made = host.ok(shd_shadow_sample(shadow, &lookups, &place));
  column.check_canaries(made ? c.count : 0);
  for (size_t i = 0; made && i < c.count; ++i) {
    SHD_FUZZ_CHECK(column[i] >= 0.0f && column[i] <= 1.0f);
    const bool finite = std::isfinite(c.points[0][i]) && std::isfinite(c.points[1][i]) && std::isfinite(c.points[2][i]);
    if (!finite) SHD_FUZZ_CHECK(column[i] == 1.0f);
    out.push_back(column[i]);
  }
  return made;
}

struct Objects {
  shd_shadow* shadow = nullptr;
  shd_mesh* mesh = nullptr;
  ~Objects() {
    shd_shadow_release(shadow);
    shd_mesh_release(mesh);
  }
};

/// Renders the maps in order; a refused map leaves the previous map.
void run_maps(const Host& host, const Case& c, const Objects& o, std::vector<float>& out) {
  bool rendered = false;
  std::vector<float> before;
  for (size_t i = 0; i < c.map_count; ++i) {
    const Map& map = c.maps[i];
    shd_light* light = nullptr;
    if (!host.ok(shd_light_create(host.context, &map.light, &light))) continue;
    shd_draw draw = map.draw;
    draw.mesh = o.mesh;
    shd_shadow_render_desc desc = map.render;
    desc.light = light;
    desc.draws = &draw;
    desc.draw_count = 1;
    const bool made = host.ok(shd_shadow_render(host.context, o.shadow, &desc));
    rendered = rendered || made;
    std::vector<float> now;
    const bool sampled = sample(host, c, o.shadow, now);
    SHD_FUZZ_CHECK(rendered || !sampled || c.count == 0);
    if (!made && rendered && host.memory.budget != 0) SHD_FUZZ_CHECK(same_values(before, now));
    before = now;
    out.insert(out.end(), now.begin(), now.end());
    shd_light_release(light);
  }
}

void run(const Case& c, shd_simd simd, std::vector<float>& out) {
  Host host(simd, c.budget);
  if (!host.context) return;
  Objects o;
  if (!host.ok(shd_shadow_create(host.context, &c.shadow, &o.shadow)) ||
      !host.ok(shd_mesh_create(host.context, &c.mesh.desc, &o.mesh))) {
    SHD_FUZZ_CHECK(!o.mesh);
    return;
  }
  run_maps(host, c, o, out);
}

}  // namespace

void describe(Source& source) {
  Case c;
  choose_case(source, c);
}

}  // namespace shd::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace shd::fuzz;
  compare_targets<Case, std::vector<float>>(data, size, choose_case, run,
                                            [](const std::vector<float>& best, const std::vector<float>& baseline) {
                                              SHD_FUZZ_CHECK(same_values(best, baseline));
                                            });
  return 0;
}
