// SPDX-License-Identifier: MIT
// Normals turned by maps and heights against long double; degenerate tangents and texels; lobes widened by the variance
// of maps.
#include "unit/shade/normals_fixture.h"

namespace shd::tests {
namespace {

struct EncodingCase {
  const char* name;
  shd_normal_encoding encoding;
  float scale;
  uint32_t flags;
};
const EncodingCase k_encodings[] = {
    {"map/xyz", SHD_NORMAL_ENCODING_XYZ, 1, 0},
    {"map/xyz/scaled", SHD_NORMAL_ENCODING_XYZ, -0.5f, 0},
    {"map/xyz/y_down", SHD_NORMAL_ENCODING_XYZ, 1, SHD_MATERIAL_NORMAL_Y_DOWN},
    {"map/xy", SHD_NORMAL_ENCODING_XY, 1, 0},
    {"map/xy/scaled/y_down", SHD_NORMAL_ENCODING_XY, 3, SHD_MATERIAL_NORMAL_Y_DOWN},
    {"map/toksvig", SHD_NORMAL_ENCODING_TOKSVIG, 1, 0},
    {"map/toksvig/scaled/y_down", SHD_NORMAL_ENCODING_TOKSVIG, 0.5f, SHD_MATERIAL_NORMAL_Y_DOWN},
    {"map/toksvig/flat", SHD_NORMAL_ENCODING_TOKSVIG, 0, 0},
    {"map/moments", SHD_NORMAL_ENCODING_MOMENTS, 1, 0},
    {"map/moments/scaled/y_down", SHD_NORMAL_ENCODING_MOMENTS, -2, SHD_MATERIAL_NORMAL_Y_DOWN},
};

void set_encoding(shd_normal_encoding encoding, float scale, uint32_t flags = 0) {
  shd_material_desc desc = shd_material_desc_default();
  desc.normal_encoding = encoding;
  desc.normal_scale = scale;
  desc.flags = flags;
  const material::SlotInput slots[material::kSlotCount] = {};
  material::build(desc, slots, &g->material);
  g->material.normal_factor = 2;  // as for a texture of bytes
  g->material.normal_offset = -1;
}

/// Random texels of an encoding: unit normals shortened as by a mip level, or slopes and their squares.
void random_texels(Random* random, shd_normal_encoding encoding) {
  float* const* map = g->given.slot[SHD_SLOT_NORMAL];
  for (size_t i = 0; i < kBatch; ++i) {
    Vector m = random_unit(random);
    m.z = fabsl(m.z) + 0.05L;
    m = ref::unit(m);
    const double length = i % 3 ? random->in(0.0, 1.0) : 1.0;
    double t[4] = {double(0.5L + 0.5L * m.x), double(0.5L + 0.5L * m.y), double(0.5L + 0.5L * m.z), length};
    if (encoding == SHD_NORMAL_ENCODING_MOMENTS) {
      t[0] = double(m.x / m.z), t[1] = double(m.y / m.z);
      t[2] = t[0] * t[0] + random->in(-0.01, 1.0), t[3] = t[1] * t[1] + random->in(-0.01, 1.0);
      const double largest = std::sqrt(std::max(0.0, t[2] - t[0] * t[0]) * std::max(0.0, t[3] - t[1] * t[1]));
      g->given.slot[SHD_SLOT_NORMAL_MIXED][0][i] = static_cast<float>(t[0] * t[1] + largest * random->in(-1.1, 1.1));
    }
    for (int c = 0; c < 4; ++c) map[c][i] = static_cast<float>(t[c]);
  }
}

void map_everywhere(bool tails) {
  const auto run = [&](const core::SimdTarget& target, raster::Fragments* points) {
    float* const* map = g->given.slot[SHD_SLOT_NORMAL];
    if (g->material.normal_encoding == SHD_NORMAL_ENCODING_MOMENTS) {
      shade::map_moments(target, g->material, map, g->given.slot[SHD_SLOT_NORMAL_MIXED][0], points, g->columns.spread);
    } else {
      shade::map_normals(target, g->material, map, points, g->columns.variance);
    }
  };
  tails ? turn_tails(run) : turn_everywhere(run);
}

/// Compares a a^T + b b^T in world space with the covariance of slopes, in units of the length of the mean.
void check_spread(size_t i, const Vector& m, const ref::SlopeCovariance& c) {
  const Vector n = normal_of(g->before, i), t = ref::unit(load(g->before.tx, g->before.ty, g->before.tz, i));
  const Vector w = static_cast<long double>(g->before.tw[i]) * ref::cross(n, t);
  const long double size = ref::length(m.x * t + m.y * w + n);
  const Vector x = 1 / size * t, y = 1 / size * w;
  float* const* s = g->columns.spread;
  const Vector a = load(s[0], s[1], s[2], i), b = load(s[3], s[4], s[5], i);
  const Vector axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const double tolerance = 2e-6 * static_cast<double>(ref::dot(m, m) + c.xx + c.yy);
  for (const Vector& p : axes) {
    for (const Vector& q : axes) {
      const long double px = ref::dot(p, x), py = ref::dot(p, y), qx = ref::dot(q, x), qy = ref::dot(q, y);
      const long double want = c.xx * px * qx + c.xy * (px * qy + py * qx) + c.yy * py * qy;
      const long double got = ref::dot(a, p) * ref::dot(a, q) + ref::dot(b, p) * ref::dot(b, q);
      shd_assert_close("covariance", i, static_cast<double>(got), static_cast<double>(want), tolerance, 0.0);
    }
  }
}

void test_map(void** state) {
  const auto* c = static_cast<const EncodingCase*>(*state);
  Random random = {101};
  set_encoding(c->encoding, c->scale, c->flags);
  random_points(&random);
  random_texels(&random, c->encoding);
  map_everywhere(true);
  map_everywhere(false);
  for (size_t i = 0; i < kBatch; ++i) {
    long double t[4];
    for (int k = 0; k < 4; ++k) t[k] = g->given.slot[SHD_SLOT_NORMAL][k][i];
    const ref::MappedNormal want = ref::decode(g->material, t);
    const Vector n = normal_of(g->before, i), tangent = ref::unit(load(g->before.tx, g->before.ty, g->before.tz, i));
    const Vector turned = ref::from_tangent_space(n, tangent, g->before.tw[i], want.m);
    // XY: the square root magnifies the rounding error of a small z.
    const long double z = c->encoding == SHD_NORMAL_ENCODING_XY ? std::max(want.m.z, 1e-3L) : 1;
    const long double size = std::max(1.0L, ref::length(want.m));
    check_normal("n", i, ref::unit(turned), static_cast<double>(6e-7L * size / z / ref::length(turned)));
    if (c->encoding == SHD_NORMAL_ENCODING_MOMENTS) {
      check_spread(i, want.m, ref::slope_covariance(g->material, t, g->given.slot[SHD_SLOT_NORMAL_MIXED][0][i]));
    } else {
      shd_assert_close("variance", i, g->columns.variance[i], static_cast<double>(want.variance), 0.0, 1e-6);
    }
  }
}

/// Without mixed moments, slopes have no covariance. Texels that are not finite give no spread.
void test_moments_alone(void**) {
  const float bad[] = {NAN, INFINITY, -INFINITY, 3e38f};
  Random random = {105};
  set_encoding(SHD_NORMAL_ENCODING_MOMENTS, 1.0f);
  random_points(&random);
  random_texels(&random, SHD_NORMAL_ENCODING_MOMENTS);
  for (size_t i = 0; i < kBatch; ++i) {
    if (i % 4 == 3) g->given.slot[SHD_SLOT_NORMAL][i / 4 % 4][i] = bad[i / 16 % 4];
  }
  turn_everywhere([&](const core::SimdTarget& target, raster::Fragments* points) {
    shade::map_moments(target, g->material, g->given.slot[SHD_SLOT_NORMAL], nullptr, points, g->columns.spread);
  });
  for (size_t i = 0; i < kBatch; ++i) {
    long double t[4];
    for (int k = 0; k < 4; ++k) t[k] = g->given.slot[SHD_SLOT_NORMAL][k][i];
    for (const float* column : g->columns.spread) assert_true(std::fabs(column[i]) <= 1e6f);
    if (i % 4 == 3) continue;
    check_spread(i, ref::decode(g->material, t).m, ref::slope_covariance(g->material, t, t[0] * t[1]));
  }
}

struct DegenerateCase {
  const char* name;
  float n[3], t[3];
};
const DegenerateCase k_degenerate[] = {
    {"tangent/0", {0, 0.6f, 0.8f}, {0, 0, 0}},
    {"tangent/0/up", {0, 0, 1}, {0, 0, 0}},
    {"tangent/0/down", {0, 0, -1}, {0, 0, 0}},
    {"tangent/along_n", {0, 0.6f, 0.8f}, {0, 0.6f, 0.8f}},
    {"tangent/against_n", {0, 0.6f, -0.8f}, {0, -1.2f, 1.6f}},
    {"tangent/nan", {0, 0.6f, 0.8f}, {NAN, 0, 0}},
    {"tangent/infinite", {0, 0.6f, 0.8f}, {INFINITY, 0, 0}},
    {"tangent/huge", {0, 0.6f, 0.8f}, {3e38f, 0, 0}},
};

/// Any frame around n is valid: the mapped normal is unit and keeps its angle to n.
void test_degenerate(void** state) {
  const auto* c = static_cast<const DegenerateCase*>(*state);
  Random random = {102};
  set_encoding(SHD_NORMAL_ENCODING_XYZ, 1.0f);
  random_points(&random);
  random_texels(&random, SHD_NORMAL_ENCODING_XYZ);
  for (size_t i = 0; i < kBatch; ++i) {
    store(ref::vector(c->n), g->before.nx, g->before.ny, g->before.nz, i);
    store(ref::vector(c->t), g->before.tx, g->before.ty, g->before.tz, i);
  }
  map_everywhere(false);
  for (size_t i = 0; i < kBatch; ++i) {
    const Vector got = normal_of(g->first, i);
    const double z = 2.0 * g->given.slot[SHD_SLOT_NORMAL][2][i] - 1.0;
    shd_assert_close("length", i, static_cast<double>(ref::length(got)), 1.0, 3e-7, 0.0);
    shd_assert_close("angle", i, static_cast<double>(ref::dot(got, ref::vector(c->n))), z, 1e-6, 0.0);
  }
}

/// Texels that are non-finite or represent no normal do not change the normal; their variance is finite.
void test_nonfinite_texels(void**) {
  const float bad[] = {NAN, INFINITY, -INFINITY, 3e38f};
  for (shd_normal_encoding encoding : {SHD_NORMAL_ENCODING_XYZ, SHD_NORMAL_ENCODING_XY, SHD_NORMAL_ENCODING_TOKSVIG}) {
    Random random = {103};
    set_encoding(encoding, 1.0f);
    random_points(&random);
    random_texels(&random, encoding);
    for (size_t i = 0; i < kBatch; ++i) {
      if (i % 2) g->given.slot[SHD_SLOT_NORMAL][i / 2 % 4][i] = bad[i / 8 % 4];
      if (i % 32 == 0 && encoding == SHD_NORMAL_ENCODING_XYZ) {
        for (int c = 0; c < 3; ++c) g->given.slot[SHD_SLOT_NORMAL][c][i] = 0.5f;
      }
    }
    map_everywhere(false);
    for (size_t i = 0; i < kBatch; ++i) {
      const double length = static_cast<double>(ref::length(normal_of(g->first, i)));
      shd_assert_close("length", i, length, 1.0, 3e-7, 0.0);
      assert_true(std::isfinite(g->columns.variance[i]) && g->columns.variance[i] >= 0.0f);
    }
  }
}

/// Texel differences as (x, y, 1).
void test_tilt(void**) {
  Random random = {104};
  random_points(&random);
  for (size_t i = 0; i < kBatch; ++i) {
    for (int c = 0; c < 2; ++c) g->given.tilt[c][i] = i % 16 == 15 ? NAN : random.scaled(-10, 10);
  }
  const auto run = [&](const core::SimdTarget& target, raster::Fragments* points) {
    shade::tilt_normals(target, g->given.tilt, points);
  };
  turn_tails(run);
  turn_everywhere(run);
  for (size_t i = 0; i < kBatch; ++i) {
    const Vector n = normal_of(g->before, i), t = ref::unit(load(g->before.tx, g->before.ty, g->before.tz, i));
    const Vector m = {g->given.tilt[0][i], g->given.tilt[1][i], 1};
    const Vector turned = ref::from_tangent_space(n, t, g->before.tw[i], m);
    const auto tolerance = static_cast<double>(6e-7L * ref::length(m) / ref::length(turned));
    check_normal("n", i, i % 16 == 15 ? n : ref::unit(turned), i % 16 == 15 ? 0.0 : tolerance);
  }
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  CMUnitTest tests[32];
  size_t n = 0;
  for (const EncodingCase& c : k_encodings)
    tests[n++] = {c.name, test_map, nullptr, nullptr, const_cast<EncodingCase*>(&c)};
  for (const DegenerateCase& c : k_degenerate) {
    tests[n++] = {c.name, test_degenerate, nullptr, nullptr, const_cast<DegenerateCase*>(&c)};
  }
  tests[n++] = {"map/nonfinite_texels", test_nonfinite_texels, nullptr, nullptr, nullptr};
  tests[n++] = {"map/moments/alone", test_moments_alone, nullptr, nullptr, nullptr};
  tests[n++] = {"tilt", test_tilt, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.shade.normal_maps", tests, n, set_up, tear_down);
}
