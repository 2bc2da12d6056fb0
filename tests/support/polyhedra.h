// SPDX-License-Identifier: MIT
// Polyhedra of the interface, their points and weights.
#pragma once

#include <vector>

#include <shd/shd.h>

#include "support/cages.h"
#include "support/context.h"
#include "support/random.h"

namespace shd::tests
{

using ref::PolyhedronPoint;
using Points = std::vector<PolyhedronPoint>;

struct CageCase {
    const char *name;
    Cage (*make)();
    bool is_convex;
    bool has_wachspress;
};
inline const CageCase kCages[] = {
    {"tetrahedron", tetrahedron, true, true},
    {"cube", cube, true, true},
    {"octahedron", octahedron, true, true},
    {"ball", [] { return ball(6, 7, 0.0); }, true, true},
    {"spikes", [] { return ball(8, 10, 0.5); }, false, false},
    {"torus", [] { return torus(9); }, false, false},
    {"pair", pair, false, false},
};

/// The columns of a mesh, and a handle.
struct Polyhedron {
    std::vector<float> column[3];
    shd_polyhedron_desc desc = shd_polyhedron_desc_default();
    shd_polyhedron *handle = nullptr;

    Polyhedron(shd_context *context, const Cage &cage, shd_barycentric kind)
    {
        for (const PolyhedronPoint &v : cage.vertex) {
            const double c[3] = {v.x, v.y, v.z};
            for (int k = 0; k < 3; ++k) column[k].push_back(static_cast<float>(c[k]));
        }
        desc.kind = kind;
        desc.vertex_count = cage.vertex.size();
        desc.index_count = cage.index.size();
        desc.indices.data = cage.index.data();
        for (int k = 0; k < 3; ++k) desc.position[k].data = column[k].data();
        shd_assert_ok(shd_polyhedron_create(context, &desc, &handle));
    }
    ~Polyhedron() { shd_polyhedron_release(handle); }
    Polyhedron(const Polyhedron &) = delete;
};

/// Points as columns of floats.
struct PointColumns {
    std::vector<float> column[3];
    shd_polyhedron_points points = shd_polyhedron_points_default();

    explicit PointColumns(const Points &from)
    {
        for (const PolyhedronPoint &p : from) {
            const double c[3] = {p.x, p.y, p.z};
            for (int k = 0; k < 3; ++k) column[k].push_back(static_cast<float>(c[k]));
        }
        points.count = from.size();
        for (int k = 0; k < 3; ++k) points.position[k].data = column[k].data();
    }
    PolyhedronPoint at(size_t i) const { return {double{column[0][i]}, double{column[1][i]}, double{column[2][i]}}; }
};

struct Weights {
    std::vector<std::vector<float>> weight;  // [vertex][point]
    size_t outside = 0, nonfinite = 0;

    double at(size_t vertex, size_t point) const { return double{weight[vertex][point]}; }
};

inline Weights evaluate(const Polyhedron &p, const PointColumns &points)
{
    Weights out;
    std::vector<shd_f32_out> columns;
    out.weight.assign(p.desc.vertex_count, std::vector<float>(points.points.count + 1, 77.0f));
    for (std::vector<float> &column : out.weight) columns.push_back(shd_f32_out_column(column.data(), 0));
    shd_polyhedron_weights weights = shd_polyhedron_weights_default();
    weights.weight = columns.data();
    weights.weight_count = columns.size();
    shd_assert_ok(shd_polyhedron_evaluate(p.handle, &points.points, &weights));
    for (const std::vector<float> &column : out.weight) assert_true(column.back() == 77.0f);
    out.outside = weights.outside_count;
    out.nonfinite = weights.nonfinite_count;
    return out;
}

/// Interpolates the positions of the vertices.
inline Points interpolate(const Polyhedron &p, const PointColumns &points)
{
    std::vector<float> result[3];
    shd_f32_out out[3];
    for (int k = 0; k < 3; ++k) {
        result[k].resize(points.points.count);
        out[k] = shd_f32_out_column(result[k].data(), 0);
    }
    shd_polyhedron_values values = shd_polyhedron_values_default();
    values.value_count = 3;
    values.vertex_value = p.desc.position;
    values.value = out;
    shd_assert_ok(shd_polyhedron_interpolate(p.handle, &points.points, &values));
    Points found;
    for (size_t i = 0; i < points.points.count; ++i) {
        found.push_back({double{result[0][i]}, double{result[1][i]}, double{result[2][i]}});
    }
    return found;
}

inline PolyhedronPoint sum_of(const Cage &cage, const Weights &weights, size_t point, double *sum)
{
    PolyhedronPoint at = {0, 0, 0};
    *sum = 0;
    for (size_t v = 0; v < cage.vertex.size(); ++v) {
        *sum += weights.at(v, point);
        at = at + weights.at(v, point) * cage.vertex[v];
    }
    return at;
}

inline Points random_points(size_t count, double extent, uint64_t seed)
{
    Random random{seed};
    Points points;
    for (size_t i = 0; i < count; ++i) {
        points.push_back({random.in(-extent, extent), random.in(-extent, extent), random.in(-extent, extent)});
    }
    return points;
}

}  // namespace shd::tests
