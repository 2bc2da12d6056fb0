// SPDX-License-Identifier: MIT
#include "scene/deform.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/bounds.h"

namespace shd::scene {
namespace {

using Vector = std::array<double, 3>;

/// Adds the targets of one column by their weights; a column of `width` numbers, of which a target changes three.
/// Rows that are 0 stay 0, because they are computed later.
void add_targets(const Geometry& geometry, const std::vector<double>& weights, std::vector<float> MorphTarget::*target,
                 size_t width, bool keep_zero, std::vector<double>* column) {
  for (size_t m = 0; m < geometry.morphs.size() && m < weights.size(); ++m) {
    const std::vector<float>& change = geometry.morphs[m].*target;
    for (size_t i = 0; 3 * i < change.size() && weights[m] != 0.0; ++i) {
      double* out = column->data() + width * i;
      if (keep_zero && out[0] == 0.0 && out[1] == 0.0 && out[2] == 0.0) continue;
      for (size_t c = 0; c < 3; ++c) out[c] += weights[m] * static_cast<double>(change[3 * i + c]);
    }
  }
}

std::vector<double> wide(const std::vector<float>& column) {
  return std::vector<double>(column.begin(), column.end());
}

std::vector<float> narrow(const std::vector<double>& column) {
  std::vector<float> out;
  out.reserve(column.size());
  for (const double value : column) out.push_back(static_cast<float>(value));
  return out;
}

Vector turn(const Matrix& m, const double* v) {
  Vector out;
  for (size_t r = 0; r < 3; ++r) out[r] = m[r] * v[0] + m[4 + r] * v[1] + m[8 + r] * v[2];
  return out;
}

/// A normal by the inverse transpose of a matrix: its cofactors, with the sign of the determinant.
Vector turn_normal(const Matrix& m, double sign, const double* n) {
  Vector out = {0, 0, 0};
  for (size_t r = 0; r < 3; ++r) {
    for (size_t c = 0; c < 3; ++c) {
      const size_t r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = 4 * ((c + 1) % 3), c2 = 4 * ((c + 2) % 3);
      out[r] += sign * (m[c1 + r1] * m[c2 + r2] - m[c1 + r2] * m[c2 + r1]) * n[c];
    }
  }
  return out;
}

void normalise(Vector& v) {
  const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  for (double& c : v) c = length > 0.0 ? c / length : 0.0;
}

/// Mean of the matrices of a vertex's joints by its weights; the identity without weights.
Matrix matrix_of_vertex(const Geometry& geometry, const std::vector<Matrix>& joints, size_t vertex) {
  Matrix mean = {};
  double sum = 0.0;
  for (size_t i = vertex * geometry.influences; i < (vertex + 1) * geometry.influences; ++i) {
    const auto weight = static_cast<double>(geometry.weight[i]);
    if (geometry.joint[i] >= joints.size() || !std::isfinite(weight) || weight == 0.0) continue;
    for (size_t k = 0; k < 16; ++k) mean[k] += weight * joints[geometry.joint[i]][k];
    sum += weight;
  }
  if (!(std::fabs(sum) > 0.0)) return kIdentity;
  for (double& value : mean) value /= sum;
  return mean;
}

/// The columns of a geometry while they move.
struct Columns {
  std::vector<double> position, normal, tangent;
};

/// Moves all vertices by a skin; returns the sign of the determinant for each.
std::vector<bool> move_by_skin(const Model& model, const MeshRow& row, const Pose& pose, Columns* columns) {
  const Geometry& geometry = model.geometries[row.geometry];
  const Skin& skin = model.skins[static_cast<size_t>(row.skin)];
  std::vector<Matrix> joints;
  for (size_t i = 0; i < skin.joints.size(); ++i) {
    joints.push_back(multiply(pose.worlds[skin.joints[i]], skin.inverse_binds[i]));
  }
  std::vector<bool> mirrored(columns->position.size() / 3);
  for (size_t i = 0; i < mirrored.size(); ++i) {
    const Matrix m = matrix_of_vertex(geometry, joints, i);
    mirrored[i] = determinant(m) < 0.0;
    double* p = &columns->position[3 * i];
    const Vector place =
        transform(m, {p[0] + geometry.origin[0], p[1] + geometry.origin[1], p[2] + geometry.origin[2]});
    for (size_t c = 0; c < 3; ++c) p[c] = std::isfinite(place[c]) ? place[c] : 0.0;
    if (!columns->normal.empty()) {
      Vector n = turn_normal(m, mirrored[i] ? -1.0 : 1.0, &columns->normal[3 * i]);
      normalise(n);
      for (size_t c = 0; c < 3; ++c) columns->normal[3 * i + c] = n[c];
    }
    if (!columns->tangent.empty()) {
      Vector t = turn(m, &columns->tangent[4 * i]);
      normalise(t);
      for (size_t c = 0; c < 3; ++c) columns->tangent[4 * i + c] = t[c];
      if (mirrored[i]) columns->tangent[4 * i + 3] = -columns->tangent[4 * i + 3];
    }
  }
  return mirrored;
}

/// The origin for positions in world space.
std::array<double, 3> choose_origin(const std::vector<double>& position) {
  Bounds box;
  for (size_t i = 0; i < position.size(); ++i) {
    double &low = box.low[i % 3], &high = box.high[i % 3];
    low = i < 3 ? position[i] : std::min(low, position[i]);
    high = i < 3 ? position[i] : std::max(high, position[i]);
  }
  return origin_of(box);
}

}  // namespace

Vertices deform(const Model& model, const MeshRow& row, const Pose& pose) {
  const Geometry& geometry = model.geometries[row.geometry];
  Columns columns = {wide(geometry.position), wide(geometry.normal), wide(geometry.tangent)};
  if (row.node >= 0) {
    const std::vector<double>& weights = pose.weights[static_cast<size_t>(row.node)];
    add_targets(geometry, weights, &MorphTarget::position, 3, false, &columns.position);
    if (!columns.normal.empty()) add_targets(geometry, weights, &MorphTarget::normal, 3, true, &columns.normal);
    if (!columns.tangent.empty()) add_targets(geometry, weights, &MorphTarget::tangent, 4, false, &columns.tangent);
  }
  Vertices out;
  out.indices = geometry.indices;
  out.origin = geometry.origin;
  if (row.skin >= 0) {
    const std::vector<bool> mirrored = move_by_skin(model, row, pose, &columns);
    for (size_t i = 0; i + 2 < out.indices.size(); i += 3) {
      if (mirrored[out.indices[i]]) std::swap(out.indices[i + 1], out.indices[i + 2]);
    }
    out.origin = choose_origin(columns.position);
    for (size_t i = 0; i < columns.position.size(); ++i) columns.position[i] -= out.origin[i % 3];
  }
  out.position = narrow(columns.position);
  out.normal = narrow(columns.normal);
  out.tangent = narrow(columns.tangent);
  return out;
}

}  // namespace shd::scene
