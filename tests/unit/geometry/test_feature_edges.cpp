// SPDX-License-Identifier: MIT
// The centre of projection of a view, tested by projecting it with the matrices.
#include "support/check.h"

#include <algorithm>

#include "geometry/feature_edges.h"
#include "support/random.h"

namespace shd::tests {
namespace {

/// Rows x, y and w of the product of three matrices and a point, and bounds of their magnitudes.
void project(const shd_view& view, const float* model, const double* p, double out[3], double size[3]) {
  double at[4] = {p[0], p[1], p[2], p[3]}, largest[4];
  for (int i = 0; i < 4; ++i) largest[i] = std::fabs(p[i]);
  for (const float* m : {model, view.world_to_view, view.view_to_clip}) {
    double next[4] = {}, bound[4] = {};
    for (int r = 0; r < 4; ++r) {
      for (int c = 0; c < 4; ++c) {
        next[r] += static_cast<double>(m[4 * c + r]) * at[c];
        bound[r] += std::fabs(static_cast<double>(m[4 * c + r])) * largest[c];
      }
    }
    memcpy(at, next, sizeof at);
    memcpy(largest, bound, sizeof largest);
  }
  const int row[3] = {0, 1, 3};
  for (int i = 0; i < 3; ++i) {
    out[i] = at[row[i]];
    size[i] = largest[row[i]];
  }
}

void set_identity(float* m) {
  for (int i = 0; i < 16; ++i) m[i] = i % 5 == 0;
}

/// The centre of any matrices projects to zero: affine or not, with and without perspective, of every size.
void test_projects_to_nothing(void**) {
  Random random = {1};
  for (int n = 0; n < 3000; ++n) {
    shd_view view = {};
    float model[16];
    const double scale = n % 3 ? 0 : random.in(-60, 60);
    for (float* m : {model, view.world_to_view, view.view_to_clip}) {
      for (int i = 0; i < 16; ++i) m[i] = random.scaled(scale - 4, scale + 4);
      const bool is_affine = m != view.view_to_clip || n % 2;
      for (int c = 0; c < 4 && is_affine; ++c) m[4 * c + 3] = c == 3;
    }
    double eye[4], got[3], size[3], largest = 0;
    geometry::centre_of_projection(view, model, eye);
    for (const double value : eye) largest = std::max(largest, std::fabs(value));
    assert_true(largest > 0 && std::isfinite(largest));
    project(view, model, eye, got, size);
    for (size_t i = 0; i < 3; ++i) shd_assert_close("row", i, got[i], 0, 1e-12 * size[i], 0);
    // Without perspective the result is a direction.
    if (n % 2) shd_assert_close("w", 0, eye[3], 0, 1e-12 * largest, 0);
  }
}

/// With a camera the result is the eye of the camera.
void test_camera(void**) {
  Random random = {2};
  for (int n = 0; n < 500; ++n) {
    shd_camera camera = shd_camera_default();
    for (int c = 0; c < 3; ++c) {
      camera.eye[c] = random.real(-9, 9);
      camera.target[c] = random.real(-1, 1);
      camera.up[c] = random.real(-1, 1);
    }
    shd_view view;
    shd_assert_ok(shd_view_from_camera(&camera, &view));
    float model[16];
    set_identity(model);
    for (int c = 0; c < 3; ++c) {
      model[5 * c] = random.scaled(-3, 3);
      model[12 + c] = random.real(-5, 5);
    }
    double eye[4];
    geometry::centre_of_projection(view, model, eye);
    for (size_t c = 0; c < 3; ++c) {
      const double want =
          (static_cast<double>(camera.eye[c]) - static_cast<double>(model[12 + c])) / static_cast<double>(model[5 * c]);
      shd_assert_close("eye", c, eye[c] / eye[3], want, 3e-5 / std::fabs(static_cast<double>(model[5 * c])), 0);
    }
  }
}

/// With an identity view the eye looks along z; with a zero projection there is no centre.
void test_plain(void**) {
  shd_view view = {};
  float model[16];
  double eye[4];
  set_identity(model);
  set_identity(view.world_to_view);
  set_identity(view.view_to_clip);
  geometry::centre_of_projection(view, model, eye);
  assert_true(eye[0] == 0 && eye[1] == 0 && std::fabs(eye[2]) == 1 && eye[3] == 0);
  memset(view.view_to_clip, 0, sizeof view.view_to_clip);
  geometry::centre_of_projection(view, model, eye);
  assert_true(eye[0] == 0 && eye[1] == 0 && eye[2] == 0 && eye[3] == 0);
}

/// Floats of any size stay finite.
void test_extreme(void**) {
  Random random = {3};
  for (int n = 0; n < 3000; ++n) {
    shd_view view = {};
    float model[16];
    for (float* m : {model, view.world_to_view, view.view_to_clip}) {
      for (int i = 0; i < 16; ++i) m[i] = random.scaled(n % 2 ? 120 : -149, n % 2 ? 128 : -120);
    }
    double eye[4];
    geometry::centre_of_projection(view, model, eye);
    for (const double value : eye) assert_true(std::isfinite(value) && std::fabs(value) <= 6);
  }
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  const CMUnitTest tests[] = {
      {"projects_to_nothing", test_projects_to_nothing, nullptr, nullptr, nullptr},
      {"camera", test_camera, nullptr, nullptr, nullptr},
      {"plain", test_plain, nullptr, nullptr, nullptr},
      {"extreme", test_extreme, nullptr, nullptr, nullptr},
  };
  return _cmocka_run_group_tests("unit.geometry.feature_edges", tests, sizeof tests / sizeof tests[0], nullptr,
                                 nullptr);
}
