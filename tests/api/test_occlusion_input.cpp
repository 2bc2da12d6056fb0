// SPDX-License-Identifier: MIT
// Rays, splits, vertices and textures of occlusion, and bad input.
#include <cstring>
#include <stdexcept>

#include "support/bake_scene.h"
#include "support/occlusion_scene.h"
#include "support/random.h"

namespace shd::tests
{
namespace
{

struct method_case {
    const char *name;
    Method method;
};
constexpr method_case k_methods[] = {{"tracer", kTracer}, {"maps", kMaps}};

// ---- rays ----

struct Checked {
    uint32_t count = 0, calls = 0, over = 0;
    double least_cosine = 2, largest_length_error = 0;
};
Checked g_checked;

void check_rays(const shd_rays *rays, uint32_t *blocked, void *)
{
    ++g_checked.calls;
    g_checked.count += static_cast<uint32_t>(rays->count);
    assert_true(rays->struct_size == sizeof *rays && rays->count >= 1);
    for (size_t i = 0; i < rays->count; ++i) {
        const Vec3 d = {rays->dx[i], rays->dy[i], rays->dz[i]};
        assert_int_equal(blocked[i], 0);
        assert_true(rays->length[i] == 2.5f && rays->oz[i] > 1.25f && rays->oz[i] < 1.2501f);
        g_checked.least_cosine = std::fmin(g_checked.least_cosine, d[2]);
        g_checked.largest_length_error = std::fmax(g_checked.largest_length_error, std::fabs(std::sqrt(dot(d, d)) - 1));
        blocked[i] = d[0] > 0 ? 0x80000000u : 0;
        g_checked.over += d[2] > 0.5;
    }
}

/// Counts, lengths and directions of rays, for numbers of rays around the size of a batch.
void test_rays(void **)
{
    const uint32_t counts[] = {1, 2, 63, 64, 65, 1000, 4095, 4096, 4097, 65536};
    for (uint32_t rays : counts) {
        Columns columns;
        for (int i = 0; i < 3; ++i) add_point(columns, {0.5 * i, 1.0 - i, 1.25}, {0, 0, 1});
        shd_occlusion_desc desc = shd_occlusion_desc_default();
        shd_context_desc one = shd_context_desc_default();
        shd_context *context = nullptr;
        one.worker_count = 1;
        shd_assert_ok(shd_context_create(&one, &context));
        std::swap(context, g_context);
        desc.ray_count = rays;
        desc.radius = 2.5f;
        desc.tracer.trace = check_rays;
        g_checked = {};
        const std::vector<float> values = compute(desc, columns);
        std::swap(context, g_context);
        shd_context_release(context);
        assert_int_equal(g_checked.count, 3 * rays);
        assert_true(g_checked.largest_length_error < 4e-7 && g_checked.least_cosine > 0);
        for (float value : values) shd_assert_close("half", rays, value, 0.5, rays < 60 ? 0.5 : 0.03, 0);
        // Directions with a cosine above 1/2 have 3/4 of the weight.
        if (rays >= 1000) shd_assert_close("cosine", rays, g_checked.over / (3.0 * rays), 0.75, 0.003, 0);
    }
}

/// The value of a point does not depend on the others, and the seed has an effect.
void test_splits(void **state)
{
    const auto &c = *static_cast<const method_case *>(*state);
    Solid solid;
    Columns columns, part;
    Random random = {9};
    shd_shape_desc torus = shd_shape_desc_default();
    torus.kind = SHD_SHAPE_TORUS;
    add_shape(&solid, torus, {0, 0, 0});
    finish(&solid);
    for (int i = 0; i < 1201; ++i) {
        add_point(columns, {random.in(-1, 1), random.in(-1, 1), random.in(-1, 1)},
                  {random.in(-1, 1), random.in(-1, 1), random.in(-1, 1)});
    }
    shd_occlusion_desc desc = desc_of(&solid, c.method, 24);
    desc.map_size = 64;
    const std::vector<float> whole = compute(desc, columns);
    for (size_t k = 0; k < 6; ++k) part[k].assign(columns[k].begin() + 77, columns[k].begin() + 1140);
    const std::vector<float> some = compute(desc, part);
    for (size_t i = 0; i < some.size(); ++i) assert_memory_equal(&some[i], &whole[77 + i], sizeof some[i]);
    desc.seed = 1;
    size_t differ = 0;
    const std::vector<float> other = compute(desc, columns);
    for (size_t i = 0; i < other.size(); ++i) differ += other[i] != whole[i];
    assert_true(differ > 200);
    close(&solid);
}

// ---- vertices and textures ----

/// Vertices of a transformed draw are the points that the matrix gives.
void test_vertices(void **)
{
    Solid solid;
    shd_shape_desc torus = shd_shape_desc_default();
    torus.kind = SHD_SHAPE_TORUS;
    add_shape(&solid, torus, {0, 0, 0});
    finish(&solid);
    const float matrix[16] = {-2, 0, 0, 0, 0.5f, 1, 0, 0, 0, 0, 0.75f, 0, 3, -1, 0.5f, 1};  // mirrors and shears
    std::copy_n(matrix, 16, solid.draw.object_to_world);
    shd_occlusion_desc desc = desc_of(&solid, kMaps, 24);
    desc.map_size = 256;
    shd_mesh_info info = shd_mesh_info_default();
    shd_assert_ok(shd_mesh_get_info(solid.mesh, &info));
    std::vector<float> value(info.vertex_count);
    const shd_f32_out out = {value.data(), 0};
    shd_assert_ok(shd_occlusion_compute_vertices(g_context, &desc, &solid.draw, &out));
    // Outer vertices of a torus see most of the sky also when it is mirrored: normals stay outwards.
    double outer = 0, inner = 0;
    size_t outers = 0, inners = 0;
    for (size_t i = 0; i < value.size(); ++i) {
        const double r = std::hypot(double{solid.position[3 * i]}, double{solid.position[3 * i + 2]});
        if (r > 1.24) outer += value[i], ++outers;
        if (r < 0.76) inner += value[i], ++inners;
    }
    assert_true(outer / double(outers) > 0.95 && inner / double(inners) < 0.85);
    close(&solid);
}

/// The texels of an atlas have the values of the points that a bake puts there.
void test_atlas(void **)
{
    enum { kWidth = 90, kHeight = 70, kTexels = kWidth * kHeight };
    shd_mesh *mesh = shd_bake_mesh(g_context, 60, 12);
    shd_draw draw = shd_draw_default();
    shd_occlusion_desc desc = shd_occlusion_desc_default();
    shd_occlusion_atlas atlas = shd_occlusion_atlas_default();
    shd_bake_stats stats = shd_bake_stats_default();
    std::vector<float> value(kTexels);
    std::vector<uint32_t> states(kTexels);
    const shd_f32_out out = {value.data(), 0};
    draw.mesh = mesh;
    draw.object_to_world[4] = 0.5f;
    atlas.width = kWidth;
    atlas.height = kHeight;
    atlas.draws = &draw;
    atlas.draw_count = 1;
    atlas.dilation = 3;
    atlas.empty = -2;
    atlas.states.data = states.data();
    atlas.stats = &stats;
    desc.draws = &draw;
    desc.draw_count = 1;
    desc.ray_count = 20;
    desc.map_size = 200;
    shd_assert_ok(shd_occlusion_bake(g_context, &desc, &atlas, &out));

    shd_framebuffer_desc planes = shd_framebuffer_desc_default();
    shd_render_desc frame = shd_render_desc_default();
    shd_bake_desc bake = shd_bake_desc_default();
    shd_bake_stats same = shd_bake_stats_default();
    shd_material *material = nullptr;
    std::vector<uint32_t> bake_states(kTexels);
    planes.width = kWidth;
    planes.height = kHeight;
    planes.aovs = SHD_AOV_POSITION | SHD_AOV_NORMAL;
    shd_assert_ok(shd_framebuffer_create(g_context, &planes, &frame.framebuffer));
    shd_assert_ok(shd_material_create(g_context, nullptr, &material));
    draw.material = material;
    frame.draws = &draw;
    frame.draw_count = 1;
    bake.dilation = 3;
    bake.states.data = bake_states.data();
    bake.stats = &same;
    shd_assert_ok(shd_bake(g_context, &frame, &bake));
    assert_memory_equal(&stats, &same, sizeof stats);
    assert_memory_equal(states.data(), bake_states.data(), kTexels * sizeof(uint32_t));
    assert_true(stats.overlapping_texel_count > 0 && stats.zero_area_triangle_count > 0 &&
                stats.dilated_texel_count > 0);
    Columns columns;
    for (size_t k = 0; k < 6; ++k) {
        columns[k].resize(kTexels);
        const shd_f32_out column = {columns[k].data(), 0};
        const int plane = k < 3 ? SHD_PLANE_PX + int(k) : SHD_PLANE_NX + int(k) - 3;
        shd_assert_ok(shd_framebuffer_read_plane(frame.framebuffer, shd_plane(plane), &column));
    }
    const std::vector<float> want = compute(desc, columns);
    for (size_t i = 0; i < kTexels; ++i) {
        const float expected = states[i] == SHD_TEXEL_STATE_EMPTY ? -2.0f : want[i];
        if (std::memcmp(&value[i], &expected, 4) != 0)
            fail_msg("texel %zu: %g, not %g", i, double{value[i]}, double{expected});
    }
    shd_material_release(material);
    shd_framebuffer_release(frame.framebuffer);
    shd_mesh_release(mesh);
}

// ---- bad input ----

struct bad_case {
    const char *name;
    void (*edit)(shd_occlusion_desc *desc, shd_occlusion_atlas *atlas);
    const char *message;
};
const bad_case k_bad[] = {
    {"bad/rays_0", [](auto *d, auto *) { d->ray_count = 0; }, "occlusion.ray_count: 0 is not in 1..65536"},
    {"bad/rays_huge", [](auto *d, auto *) { d->ray_count = 4000000000u; },
     "occlusion.ray_count: 4000000000 is not in 1..65536"},
    {"bad/radius_0", [](auto *d, auto *) { d->radius = 0; }, "occlusion.radius: 0 is not above 0"},
    {"bad/radius_negative", [](auto *d, auto *) { d->radius = -1; }, "occlusion.radius: -1 is not above 0"},
    {"bad/radius_nan", [](auto *d, auto *) { d->radius = NAN; }, "occlusion.radius: nan"},
    {"bad/bias_negative", [](auto *d, auto *) { d->bias = -1; }, "occlusion.bias: -1 is not in 0..1e+09"},
    {"bad/bias_nan", [](auto *d, auto *) { d->bias = NAN; }, "occlusion.bias: nan"},
    {"bad/map_size", [](auto *d, auto *) { d->map_size = 15; }, "occlusion.map_size: 15 is not in 16..8192"},
    {"bad/draws", [](auto *d, auto *) { d->draws = nullptr; }, "occlusion.draws: NULL"},
    {"bad/draw_count", [](auto *d, auto *) { d->draw_count = size_t{1} << 21; }, "occlusion.draw_count: 2097152"},
    {"bad/width_0", [](auto *, auto *a) { a->width = 0; }, "occlusion_atlas.width: 0 is not in 1..16384"},
    {"bad/height", [](auto *, auto *a) { a->height = 16385; }, "occlusion_atlas.height: 16385"},
    {"bad/uv_set", [](auto *, auto *a) { a->uv_set = 2; }, "occlusion_atlas.uv_set: 2 is not in 0..1"},
    {"bad/dilation", [](auto *, auto *a) { a->dilation = 1025; }, "occlusion_atlas.dilation: 1025"},
    {"bad/empty", [](auto *, auto *a) { a->empty = INFINITY; }, "occlusion_atlas.empty[0]: inf"},
    {"bad/atlas_draws", [](auto *, auto *a) { a->draws = nullptr; }, "occlusion_atlas.draws: NULL"},
    {"bad/states", [](auto *, auto *a) { a->states.stride = 5; }, "occlusion_atlas.states.stride: 5"},
    {"bad/mesh", [](auto *, auto *a) { const_cast<shd_draw *>(a->draws)->mesh = nullptr; }, "draw.mesh: NULL"},
};

void test_bad(void **state)
{
    const auto &c = *static_cast<const bad_case *>(*state);
    shd_mesh *mesh = shd_bake_mesh(g_context, 3, 1);
    shd_draw draws[2] = {shd_draw_default(), shd_draw_default()};
    float value[64];
    uint32_t states[64];
    const shd_f32_out out = {value, 0};
    shd_occlusion_desc desc = shd_occlusion_desc_default();
    shd_occlusion_atlas atlas = shd_occlusion_atlas_default();
    shd_bake_stats stats = shd_bake_stats_default();
    draws[0].mesh = draws[1].mesh = mesh;
    desc.draws = draws;
    atlas.draws = draws + 1;
    desc.draw_count = atlas.draw_count = 1;
    atlas.width = atlas.height = 8;
    atlas.stats = &stats;
    atlas.states.data = states;
    stats.triangle_count = 9;
    c.edit(&desc, &atlas);
    shd_assert_result(c.name, shd_occlusion_bake(g_context, &desc, &atlas, &out), SHD_ERROR_INVALID_ARGUMENT,
                      c.message);
    assert_int_equal(stats.triangle_count, 0);
    shd_mesh_release(mesh);
}

void test_bad_points(void **)
{
    float value[4], column[4] = {0, 0, 0, 1};
    shd_occlusion_values out = {sizeof out, {value, 0}, 0};
    const shd_occlusion_desc desc = shd_occlusion_desc_default();
    shd_occlusion_points points = shd_occlusion_points_default();
    const auto refused = [&](const char *message) {
        shd_assert_result(message, shd_occlusion_compute(g_context, &desc, &points, &out), SHD_ERROR_INVALID_ARGUMENT,
                          message);
    };
    shd_assert_ok(shd_occlusion_compute(g_context, nullptr, &points, &out));  // no points
    points.count = 4;
    refused("points.position[0].data: NULL");
    for (auto &c : points.position) c.data = column;
    refused("points.normal[0].data: NULL");
    for (auto &c : points.normal) c.data = column;
    out.visibility.data = nullptr;
    refused("values.visibility.data: NULL");
    out.visibility.data = column;
    refused("overlap");
    out.visibility.data = value;
    points.normal[1].stride = 3;
    refused("points.normal[1].stride: 3");
    shd_assert_result("desc", shd_occlusion_compute(g_context, &desc, nullptr, &out), SHD_ERROR_INVALID_ARGUMENT,
                      "points: NULL");
    shd_assert_result("context", shd_occlusion_compute(nullptr, &desc, &points, &out), SHD_ERROR_INVALID_ARGUMENT,
                      "context: NULL");
    shd_f32_out column_out = {value, 0};
    shd_draw draw = shd_draw_default();
    shd_assert_result("mesh", shd_occlusion_compute_vertices(g_context, &desc, &draw, &column_out),
                      SHD_ERROR_INVALID_ARGUMENT, "draw.mesh: NULL");
    draw.mesh = shd_bake_mesh(g_context, 1, 1);
    draw.instances = column;
    draw.instance_count = 1;
    shd_assert_result("instances", shd_occlusion_compute_vertices(g_context, &desc, &draw, &column_out),
                      SHD_ERROR_INVALID_ARGUMENT, "draw.instance_count: 1");
    draw.instance_count = 0;
    draw.object_to_world[0] = NAN;
    shd_assert_result("matrix", shd_occlusion_compute_vertices(g_context, &desc, &draw, &column_out),
                      SHD_ERROR_INVALID_ARGUMENT, "draw.object_to_world[0]: nan");
    draw.object_to_world[0] = 1;
    column_out.data = nullptr;
    shd_assert_result("out", shd_occlusion_compute_vertices(g_context, &desc, &draw, &column_out),
                      SHD_ERROR_INVALID_ARGUMENT, "out.data: NULL");
    shd_mesh_release(const_cast<shd_mesh *>(draw.mesh));
}

/// Points that are not finite, without a normal, or without any occluder are open; others keep their values. Normals
/// of any length count.
void test_odd_points(void **state)
{
    const auto &c = *static_cast<const method_case *>(*state);
    Solid solid;
    Columns columns;
    add_quad(&solid, {-50, 2, 50}, {100, 0, 0}, {0, 0, -100});
    finish(&solid);
    const double bad[] = {NAN, INFINITY, -INFINITY};
    for (double value : bad) add_point(columns, {value, 0, 0}, {0, 1, 0});
    for (double value : bad) add_point(columns, {0, 0, 0}, {0, value, 1});
    add_point(columns, {0, 0, 0}, {0, 0, 0});
    const size_t open = columns[0].size();
    for (double length : {1e-30, 1e-10, 1.0, 1e18}) add_point(columns, {0, 0, 0}, {0, length, 0});
    std::vector<float> values = compute(desc_of(&solid, c.method, 64), columns);
    for (size_t i = 0; i < open; ++i) assert_true(values[i] == 1.0f);
    for (size_t i = open; i < values.size(); ++i) assert_true(values[i] < 0.05f);
    shd_occlusion_desc none = desc_of(&solid, kMaps, 64);
    none.draw_count = 0;
    values = compute(none, columns);
    for (float value : values) assert_true(value == 1.0f);
    close(&solid);
}

/// Occluders whose positions are not finite, and meshes without vertices.
void test_odd_occluders(void **)
{
    const float position[9] = {0, 0, 0, NAN, 0, 0, 0, INFINITY, 0};
    Columns columns;
    add_point(columns, {0, 0, 0}, {0, 1, 0});
    for (uint32_t count : {0u, 3u}) {
        shd_mesh_desc mesh_desc = shd_mesh_desc_default();
        shd_draw draw = shd_draw_default();
        shd_mesh *mesh = nullptr;
        float value[4];
        const shd_f32_out out = {value, 0};
        mesh_desc.vertex_count = count;
        mesh_desc.flags = SHD_MESH_KEEP_NONFINITE;
        for (size_t c = 0; c < 3; ++c) mesh_desc.position[c] = shd_f32_column(position + c, 12);
        shd_assert_ok(shd_mesh_create(g_context, &mesh_desc, &mesh));
        draw.mesh = mesh;
        shd_occlusion_desc desc = shd_occlusion_desc_default();
        desc.draws = &draw;
        desc.draw_count = 1;
        desc.ray_count = 4;
        assert_true(compute(desc, columns)[0] == 1.0f);
        shd_assert_ok(shd_occlusion_compute_vertices(g_context, &desc, &draw, &out));
        for (uint32_t i = 0; i < count; ++i) assert_true(value[i] == 1.0f);
        shd_mesh_release(mesh);
    }
}

void throwing(const shd_rays *, uint32_t *, void *) { throw std::runtime_error("no rays"); }

void test_throws(void **)
{
    float column[3] = {0, 1, 2}, value[3];
    shd_occlusion_values out = {sizeof out, {value, 0}, 0};
    shd_occlusion_desc desc = shd_occlusion_desc_default();
    shd_occlusion_points points = shd_occlusion_points_default();
    points.count = 3;
    for (auto &c : points.position) c.data = column;
    for (auto &c : points.normal) c.data = column;
    desc.tracer.trace = throwing;
    shd_assert_result("throws", shd_occlusion_compute(g_context, &desc, &points, &out), SHD_ERROR_CALLBACK,
                      "occlusion.tracer threw: no rays");
}

}  // namespace
}  // namespace shd::tests

int main()
{
    using namespace shd::tests;
    CMUnitTest tests[64];
    size_t n = 0;
    const auto add = [&](const char *name, CMUnitTestFunction body, const void *row) {
        tests[n++] = {name, body, nullptr, nullptr, const_cast<void *>(row)};
    };
    for (const method_case &c : k_methods) {
        add(c.method == kTracer ? "splits/tracer" : "splits/maps", test_splits, &c);
        add(c.method == kTracer ? "odd_points/tracer" : "odd_points/maps", test_odd_points, &c);
    }
    add("rays", test_rays, nullptr);
    add("vertices", test_vertices, nullptr);
    add("atlas", test_atlas, nullptr);
    for (const bad_case &c : k_bad) add(c.name, test_bad, &c);
    add("bad_points", test_bad_points, nullptr);
    add("odd_occluders", test_odd_occluders, nullptr);
    add("throws", test_throws, nullptr);
    return _cmocka_run_group_tests("api.occlusion_input", tests, n, set_up, tear_down);
}
