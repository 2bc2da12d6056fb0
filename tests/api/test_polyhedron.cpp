// SPDX-License-Identifier: MIT
// Coordinates on polyhedra through the public functions: the oracle, the properties on vertices, edges, faces and
// outside, equal bits, checks of descs and columns.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "support/cages.h"
#include "support/context.h"
#include "support/random.h"
#include "support/rows.h"

#include <shd/shd.h>

namespace
{

using namespace shd::tests;
using ref::PolyhedronPoint;
using Points = std::vector<PolyhedronPoint>;

struct cage_case {
    const char *name;
    Cage (*make)();
    bool is_convex;
    bool has_wachspress;
};
const cage_case k_cages[] = {
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

Weights evaluate(const Polyhedron &p, const PointColumns &points)
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
Points interpolate(const Polyhedron &p, const PointColumns &points)
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

PolyhedronPoint sum_of(const Cage &cage, const Weights &weights, size_t point, double *sum)
{
    PolyhedronPoint at = {0, 0, 0};
    *sum = 0;
    for (size_t v = 0; v < cage.vertex.size(); ++v) {
        *sum += weights.at(v, point);
        at = at + weights.at(v, point) * cage.vertex[v];
    }
    return at;
}

Points random_points(size_t count, double extent, uint64_t seed)
{
    Random random{seed};
    Points points;
    for (size_t i = 0; i < count; ++i) {
        points.push_back({random.in(-extent, extent), random.in(-extent, extent), random.in(-extent, extent)});
    }
    return points;
}

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
    const auto &c = *static_cast<const cage_case *>(*state);
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

/// At a vertex its weight is 1; on edges and faces the weights of their vertices are linear, and others are 0.
void test_surface(void **state)
{
    const auto &c = *static_cast<const cage_case *>(*state);
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
                kind == SHD_BARYCENTRIC_WACHSPRESS && (c.make == k_cages[1].make || c.make == k_cages[3].make);
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
    const auto &c = *static_cast<const cage_case *>(*state);
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

struct bad_case {
    const char *name;
    void (*change)(Cage &, shd_polyhedron_desc &);
    const char *message;
};
const bad_case k_bad[] = {
    {"kind", [](Cage &, shd_polyhedron_desc &d) { d.kind = SHD_BARYCENTRIC_HARMONIC; },
     "polyhedron.kind: 3 is not in 0..1"},
    {"vertices", [](Cage &, shd_polyhedron_desc &d) { d.vertex_count = 3; },
     "polyhedron.vertex_count: 3 is not in 4..4096"},
    {"many", [](Cage &, shd_polyhedron_desc &d) { d.vertex_count = 4097; },
     "polyhedron.vertex_count: 4097 is not in 4..4096"},
    {"few_indices", [](Cage &, shd_polyhedron_desc &d) { d.index_count = 9; },
     "polyhedron.index_count: 9 is not in 12..24576"},
    {"indices", [](Cage &, shd_polyhedron_desc &d) { d.index_count = 13; },
     "polyhedron.index_count: 13 is not a multiple of 3"},
    {"no_position", [](Cage &, shd_polyhedron_desc &d) { d.position[1].data = nullptr; },
     "polyhedron.position[1]: NULL"},
    {"no_indices", [](Cage &, shd_polyhedron_desc &d) { d.indices.data = nullptr; }, "polyhedron.indices: NULL"},
    {"nan", [](Cage &c, shd_polyhedron_desc &) { c.vertex[2].z = std::nan(""); },
     "polyhedron.position[2]: element 2, nan, is not finite"},
    {"range", [](Cage &c, shd_polyhedron_desc &) { c.index[4] = 8; }, "polyhedron.indices[4]: 8 is not in 0..7"},
    {"twice", [](Cage &c, shd_polyhedron_desc &) { c.index[4] = c.index[3]; },
     "polyhedron.indices: triangle 1 has vertex 0 twice"},
    {"thin", [](Cage &c, shd_polyhedron_desc &) { c.vertex[2] = c.vertex[0]; },
     "polyhedron.indices: triangle 0 has no area"},
    {"open", [](Cage &, shd_polyhedron_desc &d) { d.index_count = 33; },
     "polyhedron.indices: the edge of vertices 1 and 5 is in 1 triangles, not in 2"},
    {"turned", [](Cage &c, shd_polyhedron_desc &) { std::swap(c.index[0], c.index[1]); },
     "polyhedron.indices: both triangles of vertices 0 and 2 run in one direction"},
    {"unused",
     [](Cage &c, shd_polyhedron_desc &d) {
         c.vertex.push_back({5, 5, 5});
         ++d.vertex_count;
     },
     "polyhedron.position: vertex 8 is in no triangle"},
    {"flat",
     [](Cage &c, shd_polyhedron_desc &) {
         c = tetrahedron();
         c.vertex[3] = {0.25, 0.25, 0};
     },
     "polyhedron.position: the triangles enclose no volume"},
};

void test_bad(void **state)
{
    const auto &c = *static_cast<const bad_case *>(*state);
    Cage cage = cube();
    shd_polyhedron_desc changed = shd_polyhedron_desc_default();
    changed.vertex_count = 8;
    changed.index_count = 36;
    const float *const marker = reinterpret_cast<const float *>(&cage);
    for (auto &column : changed.position) column.data = marker;
    changed.indices.data = cage.index.data();
    c.change(cage, changed);
    if (std::string(c.name) == "flat") changed.vertex_count = 4, changed.index_count = 12;
    std::vector<float> column[3];
    for (const PolyhedronPoint &v : cage.vertex) {
        const double p[3] = {v.x, v.y, v.z};
        for (int k = 0; k < 3; ++k) column[k].push_back(static_cast<float>(p[k]));
    }
    for (int k = 0; k < 3; ++k) {
        column[k].resize(5000);
        if (changed.position[k].data) changed.position[k].data = column[k].data();
    }
    if (changed.indices.data) changed.indices.data = cage.index.data();
    shd_polyhedron *handle = reinterpret_cast<shd_polyhedron *>(&changed);
    shd_assert_result(c.name, shd_polyhedron_create(g_context, &changed, &handle), SHD_ERROR_INVALID_ARGUMENT,
                      c.message);
    assert_null(handle);
}

/// Shapes that WACHSPRESS refuses, and MEAN_VALUE takes.
void test_not_convex(void **)
{
    Cage dent = cube(), straight = octahedron();
    dent.vertex[7] = {0.25, 0.25, 0.25};
    // A vertex in the middle of an edge of an octahedron.
    straight.vertex.push_back({0.5, 0.5, 0});
    straight.index = {0, 6, 4, 6, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 6, 5, 6, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
    const struct {
        const Cage &cage;
        const char *message;
    } cases[] = {{dent, "polyhedron.position: vertex"},
                 {straight, "polyhedron.position: no corner at vertex 6, but kind 0 needs one"}};
    for (const auto &c : cases) {
        Polyhedron good(g_context, c.cage, SHD_BARYCENTRIC_MEAN_VALUE);
        shd_polyhedron *handle = nullptr;
        good.desc.kind = SHD_BARYCENTRIC_WACHSPRESS;
        shd_assert_result("wachspress", shd_polyhedron_create(g_context, &good.desc, &handle),
                          SHD_ERROR_INVALID_ARGUMENT, c.message);
        assert_null(handle);
    }
}

void test_bad_calls(void **)
{
    const shd_result bad = SHD_ERROR_INVALID_ARGUMENT;
    Polyhedron p(g_context, cube(), SHD_BARYCENTRIC_MEAN_VALUE);
    const PointColumns columns(random_points(5, 1, 1));
    shd_polyhedron_points points = columns.points;
    std::vector<float> memory(8 * 5);
    std::vector<shd_f32_out> out(8);
    for (size_t v = 0; v < 8; ++v) out[v] = shd_f32_out_column(&memory[5 * v], 0);
    shd_polyhedron_weights weights = shd_polyhedron_weights_default();
    weights.weight = out.data();
    weights.weight_count = 7;
    const auto evaluated = [&] { return shd_polyhedron_evaluate(p.handle, &points, &weights); };
    shd_assert_result("count", evaluated(), bad, "weights.weight_count: 7 is not in 8..8");
    weights.weight_count = 8;
    shd_assert_result("handle", shd_polyhedron_evaluate(nullptr, &points, &weights), bad, "polyhedron: NULL");
    shd_assert_result("points", shd_polyhedron_evaluate(p.handle, nullptr, &weights), bad, "points: NULL");
    shd_assert_result("weights", shd_polyhedron_evaluate(p.handle, &points, nullptr), bad, "weights: NULL");
    out[3].data = const_cast<float *>(columns.column[1].data());
    shd_assert_result("overlap", evaluated(), bad, "weights.weight[3]: overlaps points.position[1]");
    out.assign(8, shd_f32_out{});
    shd_assert_result("none", evaluated(), bad, "weights.weight: NULL for all");
    out[0].data = memory.data();
    points.position[2].data = nullptr;
    shd_assert_result("position", evaluated(), bad, "points.position[2].data: NULL");
    points = columns.points;

    shd_polyhedron_values values = shd_polyhedron_values_default();
    out[0].data = memory.data();
    values.value = out.data();
    values.vertex_value = p.desc.position;
    const auto blended = [&] { return shd_polyhedron_interpolate(p.handle, &points, &values); };
    shd_assert_result("value_count", blended(), bad, "values.value_count: 0 is not in 1..64");
    values.value_count = 2;
    shd_assert_result("value", blended(), bad, "values.value[1].data: NULL");
    values.value_count = 1;
    shd_assert_ok(blended());
    p.column[0][6] = std::numeric_limits<float>::infinity();
    shd_assert_result("infinite", blended(), bad, "values.vertex_value[0]: element 6, inf, is not finite");
    values.vertex_value = nullptr;
    shd_assert_result("vertex_value", blended(), bad, "values.vertex_value: NULL");
    shd_polyhedron_retain(p.handle);
    shd_polyhedron_release(p.handle);
    shd_polyhedron_release(nullptr);
    shd_polyhedron *handle = p.handle;
    shd_assert_result("context", shd_polyhedron_create(nullptr, &p.desc, &handle), bad, "context: NULL");
    assert_null(handle);
}

}  // namespace

int main()
{
    static std::vector<std::string> names;
    names.reserve(64);
    for (const cage_case &c : k_cages) {
        for (const auto &row : {std::make_pair("points/", test_points), std::make_pair("surface/", test_surface),
                                std::make_pair("continuity/", test_continuity)}) {
            names.push_back(std::string(row.first) + c.name);
            add(names.back().c_str(), row.second, &c);
        }
    }
    add("cube", test_cube, nullptr);
    add("far", test_far, nullptr);
    add("scales", test_scales, nullptr);
    add("nonfinite", test_nonfinite, nullptr);
    add("bits", test_bits, nullptr);
    add("columns", test_columns, nullptr);
    ADD_ROWS(k_bad, test_bad);
    add("not_convex", test_not_convex, nullptr);
    add("bad_calls", test_bad_calls, nullptr);
    return _cmocka_run_group_tests("api.polyhedron", g_tests, g_count, set_up, tear_down);
}
