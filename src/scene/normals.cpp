// SPDX-License-Identifier: MIT
#include "scene/normals.h"

#include <cmath>

#include "scene/columns.h"

namespace shd::scene {
namespace {

double square(const float* v) {
  double sum = 0.0;
  for (size_t c = 0; c < 3; ++c) sum += static_cast<double>(v[c]) * static_cast<double>(v[c]);
  return sum;
}

/// Sets normals without a direction to 0; returns their number.
size_t clear_bad_normals(std::vector<float>& normal) {
  size_t bad = 0;
  for (size_t i = 0; i < normal.size(); i += 3) {
    const double length = square(&normal[i]);
    if (length > 0.0 && std::isfinite(length)) continue;
    for (size_t c = 0; c < 3; ++c) normal[i + c] = 0.0f;
    ++bad;
  }
  return bad;
}

bool are_good_tangents(const std::vector<float>& tangent) {
  for (size_t i = 0; i < tangent.size(); i += 4) {
    const double length = square(&tangent[i]);
    if (!(length > 0.0 && std::isfinite(length) && std::fabs(tangent[i + 3]) == 1.0f)) return false;
  }
  return true;
}

}  // namespace

void prepare_normals(Geometry& g, const Limits& limits, std::vector<std::string>* warnings) {
  const std::string name = "mesh \"" + g.name + "\": ";
  const size_t count = g.normal.size() / 3, bad = clear_bad_normals(g.normal);
  if (bad > 0) {
    warnings->push_back(name + std::to_string(bad) + " of " + std::to_string(count) +
                        " normals have length 0 or are not finite; they are computed");
  }
  if (bad == count) g.normal.clear();
  if (g.normal.empty()) {
    g.tangent.clear();
    for (MorphTarget& morph : g.morphs) morph.normal.clear();
  }
  if (!are_good_tangents(g.tangent)) {
    warnings->push_back(name + "tangents have length 0 or no handedness; they are computed");
    g.tangent.clear();
  }
  if (g.tangent.empty()) {
    for (MorphTarget& morph : g.morphs) morph.tangent.clear();
  }
  if (g.shading != Shading::kFlat || (bad == 0 && !g.normal.empty())) return;
  check_limit("vertices", g.indices.size(), "max_vertices", limits.vertices);
  take_vertices(g, g.indices);  // each triangle has vertices of its own
  for (size_t i = 0; i < g.indices.size(); ++i) g.indices[i] = static_cast<uint32_t>(i);
}

void fill_normals(const std::vector<float>& position, const std::vector<uint32_t>& indices,
                  std::vector<float>* normal) {
  std::vector<double> sums(normal->size());
  for (size_t i = 0; i + 2 < indices.size(); i += 3) {
    const float *p = &position[size_t{3} * indices[i]], *q = &position[size_t{3} * indices[i + 1]],
                *r = &position[size_t{3} * indices[i + 2]];
    double a[3], b[3];
    for (size_t c = 0; c < 3; ++c) {
      a[c] = static_cast<double>(q[c]) - static_cast<double>(p[c]);
      b[c] = static_cast<double>(r[c]) - static_cast<double>(p[c]);
    }
    for (size_t c = 0; c < 3; ++c) {
      const double face = a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
      for (size_t corner = 0; corner < 3; ++corner) sums[size_t{3} * indices[i + corner] + c] += face;
    }
  }
  for (size_t i = 0; i < normal->size(); i += 3) {
    if (square(&(*normal)[i]) > 0.0) continue;
    const double length = std::sqrt(sums[i] * sums[i] + sums[i + 1] * sums[i + 1] + sums[i + 2] * sums[i + 2]);
    for (size_t c = 0; c < 3 && length > 0.0; ++c) (*normal)[i + c] = static_cast<float>(sums[i + c] / length);
  }
}

}  // namespace shd::scene
