// SPDX-License-Identifier: MIT
// Interpolation, morph targets and skins against tests/ref/pose_ref.h, the matrices of nodes, and normals.
#include <algorithm>
#include <limits>

#include "ref/pose_ref.h"
#include "scene/bounds.h"
#include "scene/deform.h"
#include "scene/normals.h"
#include "scene/sample.h"
#include "support/check.h"
#include "support/models.h"

namespace {

using namespace shd;
using namespace shd::scene;
using shd::ref::Mat4;
using shd::ref::Row;

Mat4 rows_of(const Matrix& m) {
  Mat4 out;
  for (size_t r = 0; r < 4; ++r) {
    for (size_t c = 0; c < 4; ++c) out[r][c] = m[4 * c + r];
  }
  return out;
}

void assert_row(const char* what, const std::vector<double>& got, const Row& want, double error) {
  assert_int_equal(got.size(), want.size());
  for (size_t c = 0; c < want.size(); ++c) shd_assert_close(what, c, got[c], want[c], error, 0);
}

/// Keys at 1, 2 and 4 seconds.
Channel channel_of(Target target, Interpolation interpolation, const std::vector<Row>& values) {
  Channel channel;
  channel.target = target;
  channel.interpolation = interpolation;
  channel.times = {1, 2, 4};
  for (const Row& row : values) channel.values.insert(channel.values.end(), row.begin(), row.end());
  return channel;
}

const std::vector<Row> kPlaces = {{1, 2, 3}, {-2, 5, 0.5}, {4, 4, -4}};
const std::vector<Row> kTurns = {{0, 0, 0, 1}, {0, 0.6, 0, 0.8}, {-0.48, -0.6, -0.64, 0}};  // the last is the long way

void test_step(void**) {
  const Channel channel = channel_of(Target::kTranslation, Interpolation::kStep, kPlaces);
  const struct {
    double time;
    size_t key;
  } cases[] = {{0, 0}, {1, 0}, {1.999, 0}, {2, 1}, {3.5, 1}, {4, 2}, {99, 2}};
  for (const auto& c : cases) assert_row("step", sample(channel, c.time), kPlaces[c.key], 0);
}

void test_linear(void**) {
  const Channel channel = channel_of(Target::kTranslation, Interpolation::kLinear, kPlaces);
  assert_row("before", sample(channel, -5), kPlaces[0], 0);
  assert_row("after", sample(channel, 5), kPlaces[2], 0);
  for (double t = 0; t < 1; t += 0.125) {
    assert_row("first", sample(channel, 1 + t), ref::linear(kPlaces[0], kPlaces[1], t), 1e-6);
    assert_row("second", sample(channel, 2 + 2 * t), ref::linear(kPlaces[1], kPlaces[2], t), 1e-6);
  }
}

void test_slerp(void**) {
  const Channel channel = channel_of(Target::kRotation, Interpolation::kLinear, kTurns);
  for (double t = 0.125; t < 1; t += 0.125) {
    assert_row("first", sample(channel, 1 + t), ref::slerp(kTurns[0], kTurns[1], t), 1e-6);
    assert_row("second", sample(channel, 2 + 2 * t), ref::slerp(kTurns[1], kTurns[2], t), 1e-6);
  }
  // Equal and opposite quaternions are one rotation.
  const Channel still =
      channel_of(Target::kRotation, Interpolation::kLinear, {kTurns[1], kTurns[1], {0, -0.6, 0, -0.8}});
  assert_row("equal", sample(still, 1.5), kTurns[1], 1e-6);
  assert_row("opposite", sample(still, 3), kTurns[1], 1e-6);
}

void test_cubic(void**) {
  // in-tangent, value, out-tangent of each key
  std::vector<Row> keys = {{9, 9, 9}, kPlaces[0], {1, 0, -2}, {0.5, 3, 1}, kPlaces[1],
                           {2, 2, 2}, {-1, 0, 1}, kPlaces[2], {9, 9, 9}};
  const Channel channel = channel_of(Target::kScale, Interpolation::kCubicSpline, keys);
  assert_int_equal(component_count(channel), 3);
  assert_row("before", sample(channel, 0), keys[1], 0);
  assert_row("after", sample(channel, 7), keys[7], 0);
  for (double t = 0; t < 1; t += 0.125) {
    assert_row("first", sample(channel, 1 + t), ref::cubic(keys[1], keys[2], keys[3], keys[4], t, 1), 1e-5);
    assert_row("second", sample(channel, 2 + 2 * t), ref::cubic(keys[4], keys[5], keys[6], keys[7], t, 2), 1e-5);
  }
}

/// An animation of a parent moves its child; the other node stays.
void test_nodes(void**) {
  Model model;
  model.nodes.resize(3);
  model.nodes[0].parts = true;
  model.nodes[0].scale = {2, 2, 2};
  model.nodes[1].parent = 0;
  model.nodes[1].matrix = test::moved(1, 0, 0);
  model.nodes[2].matrix = test::moved(7, 0, 0);
  model.animations.resize(1);
  Channel channel = channel_of(Target::kTranslation, Interpolation::kLinear, kPlaces);
  model.animations[0].channels.push_back(channel);
  channel.node = 2;  // it has a matrix: no property to move
  model.animations[0].channels.push_back(channel);
  assert_true(is_usable(model, model.animations[0].channels[0]));
  assert_false(is_usable(model, model.animations[0].channels[1]));
  const Pose rest = pose_of(model), pose = pose_of(model, &model.animations[0], 1);
  shd_assert_close("rest", 0, rest.worlds[1][12], 2, 0, 0);
  shd_assert_close("x", 0, pose.worlds[1][12], 1 + 2, 1e-6, 0);
  shd_assert_close("y", 0, pose.worlds[1][13], 2, 1e-6, 0);
  shd_assert_close("other", 0, pose.worlds[2][12], 7, 0, 0);
}

void test_morph(void**) {
  Model model = test::model_of(test::square_geometry());
  Geometry& g = model.geometries[0];
  g.tangent = {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1};
  g.morphs.resize(2);
  g.morphs[0].position = {0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 4};
  g.morphs[1].position = std::vector<float>(12, 10);
  g.morphs[1].normal = {1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0};
  g.morphs[1].tangent = {0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0, -1};
  model.nodes[0].weights = {0.5f, 0.25f};
  const Vertices out = deform(model, {0, -1, 0}, pose_of(model));
  for (size_t i = 0; i < 4; ++i) {
    for (size_t c = 0; c < 3; ++c) {
      const double want =
          static_cast<double>(g.position[3 * i + c]) + 0.25 * 10 + (c == 2 ? 0.5 * (1.0 + static_cast<double>(i)) : 0);
      shd_assert_close("position", i, out.position[3 * i + c], want, 1e-6, 0);
    }
    shd_assert_close("normal x", i, out.normal[3 * i], 0.25, 1e-6, 0);
    shd_assert_close("normal z", i, out.normal[3 * i + 2], 1, 1e-6, 0);
    shd_assert_close("tangent z", i, out.tangent[4 * i + 2], -0.25, 1e-6, 0);
    shd_assert_close("handedness", i, out.tangent[4 * i + 3], 1, 0, 0);
  }
}

/// Two joints, one of them mirrored by the row, with weights between them.
Model skinned_model(const Matrix& second) {
  Model model = test::model_of(test::square_geometry(), test::moved(100, 0, 0));  // the node has no effect
  model.geometries[0].tangent = {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1};
  model.geometries[0].influences = 4;
  model.geometries[0].joint = {0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
  model.geometries[0].weight = {1, 0, 0, 0, 0.75f, 0.25f, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0};
  model.nodes.resize(3);
  model.nodes[1].parts = true;
  model.nodes[1].rotation = {0, 0, 0.6, 0.8};
  model.nodes[1].scale = {1, 2, 0.5};
  model.nodes[2].parent = 1;
  model.nodes[2].matrix = second;
  model.skins.push_back({{1, 2}, {test::moved(0, -0.25, 0), test::moved(0, -0.5, 1)}});
  model.placements[0].skin = 0;
  return model;
}

void test_skin(void**) {
  for (const Matrix& second : {test::moved(0.5, 1, -2), test::scaled(-1.3, -2.1, -0.4)}) {
    const Model model = skinned_model(second);
    const Geometry& g = model.geometries[0];
    const Pose pose = pose_of(model);
    const Vertices out = deform(model, {0, 0, -1}, pose);
    const std::vector<Mat4> joints = {rows_of(pose.worlds[1]), rows_of(pose.worlds[2])};
    const std::vector<Mat4> binds = {rows_of(model.skins[0].inverse_binds[0]),
                                     rows_of(model.skins[0].inverse_binds[1])};
    for (size_t i = 0; i < 4; ++i) {
      const std::vector<size_t> joint(g.joint.begin() + static_cast<long>(4 * i),
                                      g.joint.begin() + static_cast<long>(4 * i + 4));
      const std::vector<double> weight(g.weight.begin() + static_cast<long>(4 * i),
                                       g.weight.begin() + static_cast<long>(4 * i + 4));
      const Mat4 m = ref::skin_matrix(joints, binds, joint, weight);
      const auto p =
          ref::point(m, {static_cast<double>(g.position[3 * i]), static_cast<double>(g.position[3 * i + 1]), 0});
      const auto n = ref::normal(m, {0, 0, 1});
      for (size_t c = 0; c < 3; ++c) {
        shd_assert_close("position", i, out.position[3 * i + c], p[c], 1e-6, 1e-6);
        shd_assert_close("normal", i, out.normal[3 * i + c], n[c], 1e-6, 0);
      }
      // The tangent is the image of x, and the bitangent, handedness * cross(n, t), is on the side of the image of y.
      const float *t = &out.tangent[4 * i], *u = &out.normal[3 * i];
      double side = 0;
      for (size_t c = 0; c < 3; ++c) {
        const double length = std::sqrt(m[0][0] * m[0][0] + m[1][0] * m[1][0] + m[2][0] * m[2][0]);
        shd_assert_close("tangent", i, t[c], m[c][0] / length, 1e-6, 0);
        side +=
            static_cast<double>(t[3] * (u[(c + 1) % 3] * t[(c + 2) % 3] - u[(c + 2) % 3] * t[(c + 1) % 3])) * m[c][1];
      }
      assert_true(side > 0);
    }
  }
}

/// A skin that mirrors turns its triangles around, so that the front stays on the side of the normal.
void test_mirrored_skin(void**) {
  Model model = skinned_model(kIdentity);
  model.nodes[1].scale = {-1, 1, 1};
  std::fill(model.geometries[0].joint.begin(), model.geometries[0].joint.end(), uint16_t{0});
  const Vertices out = deform(model, {0, 0, -1}, pose_of(model));
  const float *a = &out.position[3 * out.indices[0]], *b = &out.position[3 * out.indices[1]],
              *c = &out.position[3 * out.indices[2]];
  const double up = static_cast<double>((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  assert_true(up > 0 && out.normal[2] > 0);
}

/// Weights need not add up to 1; a vertex without weights, and one of joints that are not there, stay.
void test_odd_weights(void**) {
  Model model = skinned_model(kIdentity);
  model.nodes[1].scale = {1, 1, 1};
  model.nodes[1].rotation = {0, 0, 0, 1};
  model.nodes[1].translation = {0, 0, 5};
  model.skins[0].inverse_binds = {kIdentity, kIdentity};
  model.geometries[0].joint = {0, 0, 0, 0, 0, 0, 0, 0, 9, 0, 0, 0, 0, 0, 0, 0};
  model.geometries[0].weight = {0.5f, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, std::numeric_limits<float>::quiet_NaN(),
                                1,    0, 0};
  const Vertices out = deform(model, {0, 0, -1}, pose_of(model));
  const double want[] = {5, 0, 0, 5};
  for (size_t i = 0; i < 4; ++i) shd_assert_close("z", i, out.position[3 * i + 2], want[i], 1e-6, 0);
}

/// A skin far away from 0: positions are relative to an origin, and keep their differences.
void test_far_skin(void**) {
  Model model = skinned_model(kIdentity);
  model.nodes[1].translation = {4e6, 4e6, 0};
  const Vertices out = deform(model, {0, 0, -1}, pose_of(model));
  const Vertices near = deform(skinned_model(kIdentity), {0, 0, -1}, pose_of(skinned_model(kIdentity)));
  assert_true(out.origin[0] > 3.9e6);
  for (size_t i = 0; i < 12; ++i) {
    const double got = static_cast<double>(out.position[i]) + out.origin[i % 3] - (i % 3 < 2 ? 4e6 : 0);
    shd_assert_close("place", i, got, near.position[i], 1e-6, 0);
  }
}

/// A roof of two squares that share their ridge.
Geometry roof() {
  Geometry g;
  g.name = "roof";
  g.position = {-1, 0, 0, 0, 1, 0, 1, 0, 0, -1, 0, -1, 0, 1, -1, 1, 0, -1};
  g.indices = {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4};
  g.uv = {0, 0, 1, 0, 2, 0, 0, 1, 1, 1, 2, 1};
  return g;
}

void test_flat(void**) {
  Geometry g = roof();
  g.shading = Shading::kFlat;
  g.color = std::vector<float>(24, 0.5f);
  g.influences = 1;
  g.joint = {0, 1, 2, 3, 4, 5};
  g.weight = std::vector<float>(6, 1);
  g.morphs.resize(1);
  g.morphs[0].position = g.position;
  const Geometry before = g;
  std::vector<std::string> warnings;
  prepare_normals(g, Limits(), &warnings);
  assert_true(warnings.empty());  // flat normals are no defect
  assert_int_equal(g.position.size(), 36);
  assert_int_equal(g.indices.size(), 12);
  assert_int_equal(g.color.size(), 48);
  for (uint32_t i = 0; i < 12; ++i) {
    const size_t from = before.indices[i];
    assert_int_equal(g.indices[i], i);
    assert_int_equal(g.joint[i], from);
    assert_true(g.uv[2 * i] == before.uv[2 * from] && g.uv[2 * i + 1] == before.uv[2 * from + 1]);
    for (size_t c = 0; c < 3; ++c) {
      assert_true(g.position[3 * i + c] == before.position[3 * from + c]);
      assert_true(g.morphs[0].position[3 * i + c] == before.position[3 * from + c]);
    }
  }
}

void test_flat_budget(void**) {
  Geometry g = roof();
  g.shading = Shading::kFlat;
  Limits limits;
  limits.vertices = 11;
  bool refused = false;
  std::vector<std::string> warnings;
  try {
    prepare_normals(g, limits, &warnings);
  } catch (const core::Failure& failure) {
    refused = failure.code == SHD_ERROR_LIMIT;
  }
  assert_true(refused);
}

/// Normals of length 0, NaN or infinity are the area-weighted means of the faces around the vertex, with one warning.
void test_bad_normals(void**) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  Geometry g = roof();
  g.normal = {0, 0, 0, nan, 0, 1, 0, inf, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1};
  std::vector<std::string> warnings;
  prepare_normals(g, Limits(), &warnings);
  assert_int_equal(warnings.size(), 1);
  assert_non_null(strstr(warnings[0].c_str(), "mesh \"roof\": 4 of 6 normals"));
  fill_normals(g.position, g.indices, &g.normal);
  const double s = std::sqrt(0.5);
  // The faces have normals (-s, s, 0) and (s, s, 0); one of the triangles of each side touches vertex 0, 2 and 3.
  const double want[6][3] = {{-s, s, 0}, {0, 1, 0}, {s, s, 0}, {-s, s, 0}, {0, 0, 1}, {0, 0, 1}};
  double at_ridge[3] = {-s + 2 * s, s + 2 * s, 0};  // one triangle on the left, two on the right
  const double length = std::sqrt(at_ridge[0] * at_ridge[0] + at_ridge[1] * at_ridge[1]);
  for (size_t i = 0; i < 6; ++i) {
    for (size_t c = 0; c < 3; ++c) {
      const double right = i == 1 ? at_ridge[c] / length : want[i][c];
      shd_assert_close("normal", 3 * i + c, g.normal[3 * i + c], right, 1e-6, 0);
    }
  }
}

/// A column of bad normals alone is as no column; bad tangents are left out.
void test_all_bad(void**) {
  Geometry g = roof();
  g.normal = std::vector<float>(18, 0);
  g.shading = Shading::kFlat;
  std::vector<std::string> warnings;
  prepare_normals(g, Limits(), &warnings);
  assert_true(g.normal.empty() && g.position.size() == 36 && warnings.size() == 1);
  Geometry h = roof();
  h.normal = std::vector<float>(18, 1);
  h.tangent = std::vector<float>(24, 0);
  prepare_normals(h, Limits(), &warnings);
  assert_true(h.tangent.empty() && warnings.size() == 2);
}

void test_origin(void**) {
  const struct {
    double center, radius, origin;
  } cases[] = {{0, 1, 0}, {100, 1, 0}, {4e6, 1, 4e6}, {4e6, 1e6, 0}, {1, 1e-12, 1}, {1e12, 1e12, 0}, {0, 1e-12, 0}};
  for (const auto& c : cases) {
    Bounds box;
    box.low = {c.center - c.radius, 0, 0};
    box.high = {c.center + c.radius, 0, 0};
    shd_assert_close("origin", 0, origin_of(box)[0], c.origin, 0, 1e-15);
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(test_step),        cmocka_unit_test(test_linear),        cmocka_unit_test(test_slerp),
      cmocka_unit_test(test_cubic),       cmocka_unit_test(test_nodes),         cmocka_unit_test(test_morph),
      cmocka_unit_test(test_skin),        cmocka_unit_test(test_mirrored_skin), cmocka_unit_test(test_odd_weights),
      cmocka_unit_test(test_far_skin),    cmocka_unit_test(test_flat),          cmocka_unit_test(test_flat_budget),
      cmocka_unit_test(test_bad_normals), cmocka_unit_test(test_all_bad),       cmocka_unit_test(test_origin),
  };
  return cmocka_run_group_tests_name("unit.scene.pose", tests, nullptr, nullptr);
}
