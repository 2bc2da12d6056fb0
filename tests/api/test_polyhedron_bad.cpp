// SPDX-License-Identifier: MIT
// Polyhedra that are refused, and bad calls.
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "support/polyhedra.h"
#include "support/rows.h"

namespace
{

using namespace shd::tests;

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
    ADD_ROWS(k_bad, test_bad);
    add("not_convex", test_not_convex, nullptr);
    add("bad_calls", test_bad_calls, nullptr);
    return _cmocka_run_group_tests("api.polyhedron_bad", g_tests, g_count, set_up, tear_down);
}
