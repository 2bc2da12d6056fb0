// SPDX-License-Identifier: MIT
// Coordinates on polyhedra through the public functions: the oracle, sizes, points that are not finite, equal bits,
// columns.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "support/polyhedra.h"
#include "support/rows.h"

namespace
{

using namespace shd::tests;

/// Whether a point is inside, by the sum of the solid angles of the triangles (Van Oosterom and Strackee 1983).
bool is_inside(const Cage &cage, const PolyhedronPoint &x)
{
    double angle = 0;
    for (size_t t = 0; t < cage.index.size(); t += 3) {
        const PolyhedronPoint a = cage.vertex[cage.index[t]] - x, b = cage.vertex[cage.index[t + 1]] - x,
                              c = cage.vertex[cage.index[t + 2]] - x;
        const double la = polyhedron_length(a), lb = polyhedron_length(b), lc = polyhedron_length(c);
        angle += 2 * std::atan2(polyhedron_dot(a, polyhedron_cross(b, c)), la * lb * lc + polyhedron_dot(a, b) * lc +
                                                                               polyhedron_dot(b, c) * la +
                                                                               polyhedron_dot(c, a) * lb);
    }
    return angle > 6.0;
}

/// Weights by the oracle, partition of unity, linear precision, signs in convex cages, and the count of points outside.
void test_points(void **state)
{
    const auto &c = *static_cast<const CageCase *>(*state);
    const Cage cage = c.make();
    for (const shd_barycentric kind : {SHD_BARYCENTRIC_MEAN_VALUE, SHD_BARYCENTRIC_WACHSPRESS}) {
        if (kind == SHD_BARYCENTRIC_WACHSPRESS && !c.has_wachspress) continue;
        const Polyhedron p(g_context, cage, kind);
        const PointColumns points(random_points(1500, 1.6, 5));
        const Weights weights = evaluate(p, points);
        const Points positions = interpolate(p, points);
        size_t outside = 0;
        double worst = 0;
        for (size_t i = 0; i < points.points.count; ++i) {
            const PolyhedronPoint x = points.at(i);
            double sum;
            const PolyhedronPoint at = sum_of(cage, weights, i, &sum);
            const bool inside = is_inside(cage, x);
            outside += !inside;
            shd_assert_close("sum", i, sum, 1, 1e-6, 0);
            if (kind == SHD_BARYCENTRIC_WACHSPRESS && !inside) continue;
            assert_true(polyhedron_length(at - x) < 2e-6);
            assert_true(polyhedron_length(positions[i] - x) < 1e-6);
            const std::vector<double> want = kind == SHD_BARYCENTRIC_WACHSPRESS ? ref::wachspress_weights(cage, x)
                                                                                : ref::mean_value_weights(cage, x);
            for (size_t v = 0; v < want.size(); ++v) {
                worst = std::max(worst, std::fabs(want[v] - weights.at(v, i)));
                if (c.is_convex && inside) assert_true(weights.at(v, i) >= 0.0);
            }
        }
        print_message("%s %d: error %.2g, %zu outside\n", c.name, static_cast<int>(kind), worst, outside);
        assert_true(worst < 4e-6);
        assert_int_equal(weights.outside, outside);
        assert_true(outside > 100 && outside < 1500);
    }
}

/// Wachspress coordinates of a cube are trilinear; points outside have the weights of the nearest point.
void test_cube(void **)
{
    const Cage cage = cube();
    const Polyhedron p(g_context, cage, SHD_BARYCENTRIC_WACHSPRESS);
    const PointColumns points(random_points(1000, 1.5, 9));
    const Weights weights = evaluate(p, points);
    for (size_t i = 0; i < points.points.count; ++i) {
        PolyhedronPoint x = points.at(i);
        for (double *coordinate : {&x.x, &x.y, &x.z}) *coordinate = std::min(std::max(*coordinate, 0.0), 1.0);
        for (int v = 0; v < 8; ++v) {
            const double want = (v & 1 ? x.x : 1 - x.x) * (v & 2 ? x.y : 1 - x.y) * (v & 4 ? x.z : 1 - x.z);
            shd_assert_close("trilinear", i, weights.at(static_cast<size_t>(v), i), want, 1e-7, 0);
        }
    }
}

/// Cages of any size and place have the weights of the same cage of unit size.
void test_scales(void **)
{
    const Cage cage = ball(5, 6, 0.25);
    const PointColumns points(random_points(200, 1.4, 12));
    const Weights want = evaluate(Polyhedron(g_context, cage, SHD_BARYCENTRIC_MEAN_VALUE), points);
    for (const double scale : {0x1p-100, 0x1p-20, 0x1p30, 0x1p120}) {
        Cage scaled = cage;
        Points moved;
        for (PolyhedronPoint &v : scaled.vertex) v = scale * v;
        for (size_t i = 0; i < points.points.count; ++i) moved.push_back(scale * points.at(i));
        const Weights got = evaluate(Polyhedron(g_context, scaled, SHD_BARYCENTRIC_MEAN_VALUE), PointColumns(moved));
        for (size_t v = 0; v < cage.vertex.size(); ++v) assert_true(got.weight[v] == want.weight[v]);
    }
}

void test_nonfinite(void **)
{
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    const float bad[3] = {nan, infinity, -infinity};
    for (const shd_barycentric kind : {SHD_BARYCENTRIC_MEAN_VALUE, SHD_BARYCENTRIC_WACHSPRESS}) {
        const Polyhedron p(g_context, octahedron(), kind);
        PointColumns points(Points(6, {0.25, 0.125, -0.25})), clean(Points(6, {0.25, 0.125, -0.25}));
        for (size_t i = 0; i < 3; ++i) points.column[i][2 * i] = bad[i], clean.column[i][2 * i] = 0;
        const Weights got = evaluate(p, points), want = evaluate(p, clean);
        assert_int_equal(got.nonfinite, 3);
        assert_int_equal(got.outside, 0);
        assert_int_equal(want.nonfinite, 0);
        assert_true(got.weight == want.weight);
    }
}

/// The same bits for each split of a batch, stride, number of workers and SIMD target.
void test_bits(void **)
{
    const Cage cage = ball(7, 9, 0.3);
    Points from = random_points(6001, 1.5, 21);
    for (const PolyhedronPoint &v : cage.vertex) from.push_back(v);
    const PointColumns points(from);
    const Weights want = evaluate(Polyhedron(g_context, cage, SHD_BARYCENTRIC_MEAN_VALUE), points);
    size_t contexts = 0;
    for (int simd = SHD_SIMD_SCALAR; simd <= SHD_SIMD_WASM; ++simd) {
        for (const uint32_t workers : {1u, 3u}) {
            shd_context_desc desc = shd_context_desc_default();
            shd_context *context = nullptr;
            desc.simd = static_cast<shd_simd>(simd);
            desc.worker_count = workers;
            if (shd_context_create(&desc, &context) != SHD_OK) continue;
            ++contexts;
            {
                const Polyhedron p(context, cage, SHD_BARYCENTRIC_MEAN_VALUE);
                const Weights got = evaluate(p, points);
                assert_true(got.weight == want.weight);
                assert_int_equal(got.outside, want.outside);
            }
            shd_context_release(context);
        }
    }
    assert_true(contexts >= 2);
    const Polyhedron p(g_context, cage, SHD_BARYCENTRIC_MEAN_VALUE);
    for (const size_t count : {0, 1, 2, 7, 8, 9, 15, 17, 33}) {
        const size_t first = 11 * count;
        const Weights got = evaluate(p, PointColumns(Points(from.begin() + static_cast<ptrdiff_t>(first),
                                                            from.begin() + static_cast<ptrdiff_t>(first + count))));
        for (size_t v = 0; v < cage.vertex.size(); ++v) {
            for (size_t i = 0; i < count; ++i) assert_true(got.weight[v][i] == want.weight[v][first + i]);
        }
    }
}

/// Interleaved columns, columns that are not wanted, and 64 values.
void test_columns(void **)
{
    const Cage cage = cube();
    const Polyhedron p(g_context, cage, SHD_BARYCENTRIC_MEAN_VALUE);
    const PointColumns packed(random_points(21, 1.0, 30));
    const Weights want = evaluate(p, packed);
    std::vector<float> records(21 * 5, 3.0f), results(21 * 8, 9.0f);
    shd_polyhedron_points points = packed.points;
    for (size_t k = 0; k < 3; ++k) {
        for (size_t i = 0; i < 21; ++i) records[5 * i + k] = packed.column[k][i];
        points.position[k] = shd_f32_column(&records[k], 5 * sizeof(float));
    }
    std::vector<shd_f32_out> columns(8);
    for (size_t v = 0; v < 8; v += 2) columns[v] = shd_f32_out_column(&results[v], 8 * sizeof(float));
    shd_polyhedron_weights weights = shd_polyhedron_weights_default();
    weights.weight = columns.data();
    weights.weight_count = 8;
    shd_assert_ok(shd_polyhedron_evaluate(p.handle, &points, &weights));
    for (size_t i = 0; i < 21; ++i) {
        for (size_t v = 0; v < 8; ++v) assert_true(results[8 * i + v] == (v % 2 ? 9.0f : want.weight[v][i]));
    }
    std::vector<float> vertex(64 * 8), value(64 * 21);
    std::vector<shd_f32_in> in(64);
    std::vector<shd_f32_out> out(64);
    for (size_t k = 0; k < 64; ++k) {
        for (size_t v = 0; v < 8; ++v) vertex[8 * k + v] = v == k % 8 ? static_cast<float>(1 + k / 8) : 0.0f;
        in[k] = shd_f32_column(&vertex[8 * k], 0);
        out[k] = shd_f32_out_column(&value[21 * k], 0);
    }
    shd_polyhedron_values values = shd_polyhedron_values_default();
    values.value_count = 64;
    values.vertex_value = in.data();
    values.value = out.data();
    shd_assert_ok(shd_polyhedron_interpolate(p.handle, &points, &values));
    for (size_t k = 0; k < 64; ++k) {
        for (size_t i = 0; i < 21; ++i) {
            shd_assert_close("value", i, double{value[21 * k + i]},
                             (1.0 + static_cast<double>(k / 8)) * want.at(k % 8, i), 1e-6, 1e-6);
        }
    }
}

}  // namespace

int main()
{
    static std::vector<std::string> names;
    names.reserve(64);
    for (const CageCase &c : kCages) {
        names.push_back("points/" + std::string(c.name));
        add(names.back().c_str(), test_points, &c);
    }
    add("cube", test_cube, nullptr);
    add("scales", test_scales, nullptr);
    add("nonfinite", test_nonfinite, nullptr);
    add("bits", test_bits, nullptr);
    add("columns", test_columns, nullptr);
    return _cmocka_run_group_tests("api.polyhedron", g_tests, g_count, set_up, tear_down);
}
