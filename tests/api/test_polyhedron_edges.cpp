// SPDX-License-Identifier: MIT
// Coordinates on polyhedra at vertices, on edges and faces, next to them, and far away.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "support/polyhedra.h"
#include "support/rows.h"

namespace
{

using namespace shd::tests;

/// At a vertex its weight is 1; on edges and faces the weights of their vertices are linear, and others are 0.
void test_surface(void **state)
{
    const auto &c = *static_cast<const CageCase *>(*state);
    const Cage cage = c.make();
    Random random{77};
    Points on;
    std::vector<double> want;
    for (size_t t = 0; t < cage.index.size(); t += 3) {
        for (int k = 0; k < 7; ++k) {
            double b[3] = {random.unit(), random.unit(), random.unit()};
            if (k < 3) b[k] = 0;
            if (k >= 3 && k < 6) b[k - 3] = b[(k - 2) % 3] = 0;
            const double sum = b[0] + b[1] + b[2];
            PolyhedronPoint at = {0, 0, 0};
            for (size_t i = 0; i < 3; ++i) at = at + b[i] / sum * cage.vertex[cage.index[t + i]];
            on.push_back(at);
            for (const double weight : b) want.push_back(weight / sum);
        }
    }
    for (const shd_barycentric kind : {SHD_BARYCENTRIC_MEAN_VALUE, SHD_BARYCENTRIC_WACHSPRESS}) {
        if (kind == SHD_BARYCENTRIC_WACHSPRESS && !c.has_wachspress) continue;
        const Polyhedron p(g_context, cage, kind);
        const PointColumns points(on);
        const Weights weights = evaluate(p, points);
        double worst = 0;
        for (size_t i = 0; i < on.size(); ++i) {
            const bool is_corner = i % 7 >= 3 && i % 7 < 6;
            double sum, others = 0;
            const PolyhedronPoint at = sum_of(cage, weights, i, &sum);
            shd_assert_close("sum", i, sum, 1, 1e-6, 0);
            assert_true(polyhedron_length(at - points.at(i)) < 2e-6);
            // Flat parts of several triangles are one face of WACHSPRESS, with weights of the polygon inside.
            const bool is_polygon =
                kind == SHD_BARYCENTRIC_WACHSPRESS && (c.make == kCages[1].make || c.make == kCages[3].make);
            if (is_polygon && !is_corner) continue;
            for (size_t v = 0; v < cage.vertex.size(); ++v) {
                double own = 0;
                for (size_t k = 0; k < 3; ++k) {
                    if (cage.index[i / 7 * 3 + k] == v) own = want[3 * i + k];
                }
                others = std::max(others, std::fabs(weights.at(v, i) - own));
            }
            if (is_corner && kind == SHD_BARYCENTRIC_MEAN_VALUE) assert_true(others == 0.0);
            worst = std::max(worst, others);
        }
        print_message("%s %d: on the surface %.2g\n", c.name, static_cast<int>(kind), worst);
        assert_true(worst < 3e-6);
    }
}

/// Weights change continuously through faces and edges: at a distance of d they differ from those of the surface by a
/// multiple of d log(1 / d).
void test_continuity(void **state)
{
    const auto &c = *static_cast<const CageCase *>(*state);
    const Cage cage = c.make();
    const Polyhedron p(g_context, cage, SHD_BARYCENTRIC_MEAN_VALUE);
    Random random{78};
    for (size_t t = 0; t < cage.index.size(); t += 3) {
        const PolyhedronPoint v[3] = {cage.vertex[cage.index[t]], cage.vertex[cage.index[t + 1]],
                                      cage.vertex[cage.index[t + 2]]};
        const PolyhedronPoint normal = polyhedron_cross(v[1] - v[0], v[2] - v[0]);
        const PolyhedronPoint unit = 1 / polyhedron_length(normal) * normal;
        for (int place = 0; place < 3; ++place) {  // in the face, on an edge, at a vertex
            double b[3] = {0.2 + random.unit(), place > 1 ? 0 : 0.2 + random.unit(),
                           place > 0 ? 0 : 0.2 + random.unit()};
            const double sum = b[0] + b[1] + b[2];
            const PolyhedronPoint at = b[0] / sum * v[0] + b[1] / sum * v[1] + b[2] / sum * v[2];
            Points near = {at};
            const double steps[] = {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9};
            for (const double step : steps) near.push_back(at + step * unit), near.push_back(at - step * unit);
            const Weights weights = evaluate(p, PointColumns(near));
            for (size_t i = 1; i < near.size(); ++i) {
                const double step = steps[(i - 1) / 2], bound = 12 * step * (1 - std::log(step)) + 3e-6;
                for (size_t k = 0; k < cage.vertex.size(); ++k) {
                    const double apart = std::fabs(weights.at(k, i) - weights.at(k, 0));
                    if (apart > bound)
                        print_message("%s triangle %zu place %d step %g: %g\n", c.name, t / 3, place, step, apart);
                    assert_true(apart <= bound);
                }
            }
        }
    }
}

/// Far away, sums of weights are 1 and reproduce the point, as far as floats can; beyond the limit, the point there.
void test_far(void **)
{
    const Cage cage = octahedron();  // in a box of 2 x 2 x 2 around 0
    const Polyhedron p(g_context, cage, SHD_BARYCENTRIC_MEAN_VALUE);
    for (const double distance : {3.0, 10.0, 100.0, 500.0, 1e6, 1e20, 3e38}) {
        const PolyhedronPoint direction = {0.48, -0.6, 0.64};
        const PointColumns points({distance * direction});
        const Points at = interpolate(p, points);
        const double reached = std::min(distance, 512.0);
        print_message("distance %g: error %.2g\n", distance, polyhedron_length(at[0] - reached * direction) / reached);
        assert_true(polyhedron_length(at[0] - reached * direction) < 1e-6 * reached);
        double sum;
        sum_of(cage, evaluate(p, points), 0, &sum);
        shd_assert_close("sum", 0, sum, 1, 1e-6 * reached, 0);
    }
}

}  // namespace

int main()
{
    static std::vector<std::string> names;
    names.reserve(64);
    for (const CageCase &c : kCages) {
        names.push_back("surface/" + std::string(c.name));
        add(names.back().c_str(), test_surface, &c);
        names.push_back("continuity/" + std::string(c.name));
        add(names.back().c_str(), test_continuity, &c);
    }
    add("far", test_far, nullptr);
    return _cmocka_run_group_tests("api.polyhedron_edges", g_tests, g_count, set_up, tear_down);
}
