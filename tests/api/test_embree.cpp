// SPDX-License-Identifier: MIT
// The tracer of libshd_embree: against rays in double, for any number of workers, and bad input.
#include <vector>

#include <shd/embree.h>
#include <shd/shd.h>

#include "ref/ray_ref.h"
#include "support/bake_scene.h"
#include "support/check.h"
#include "support/random.h"

namespace shd::tests
{
namespace
{

using ref::Vec3;

shd_context *g_context;
shd_mesh *g_teapot;
ref::RayScene *g_rays;

int set_up(void **)
{
    shd_shape_desc shape = shd_shape_desc_default();
    shd_mesh_info info = shd_mesh_info_default();
    shape.kind = SHD_SHAPE_TEAPOT;
    shd_assert_ok(shd_context_create(nullptr, &g_context));
    shd_assert_ok(shd_mesh_create_shape(g_context, &shape, SHD_MESH_NONE, &g_teapot));
    shd_assert_ok(shd_mesh_get_info(g_teapot, &info));
    std::vector<float> position(size_t{3} * info.vertex_count);
    std::vector<uint32_t> indices(size_t{3} * info.triangle_count);
    const shd_f32_out columns[3] = {{&position[0], 12}, {&position[1], 12}, {&position[2], 12}};
    const shd_u32_out column = {indices.data(), 0};
    shd_assert_ok(shd_mesh_read_positions(g_teapot, columns));
    shd_assert_ok(shd_mesh_read_indices(g_teapot, &column));
    std::vector<ref::RayTriangle> triangles(info.triangle_count);
    for (size_t i = 0; i < indices.size(); ++i) {
        for (size_t c = 0; c < 3; ++c) {
            triangles[i / 3].corner[i % 3][c] = static_cast<double>(position[3 * indices[i] + c]);
        }
    }
    g_rays = new ref::RayScene(triangles);
    return 0;
}
int tear_down(void **)
{
    delete g_rays;
    shd_mesh_release(g_teapot);
    shd_context_release(g_context);
    return 0;
}

shd_draw draw_of(const shd_mesh *mesh)
{
    shd_draw draw = shd_draw_default();
    draw.mesh = mesh;
    return draw;
}

/// Random rays, long and short: nearly all answers are those of double precision.
void test_rays(void **)
{
    enum { kRays = 20000 };
    shd_embree *tree = nullptr;
    shd_tracer tracer;
    const shd_draw draw = draw_of(g_teapot);
    std::vector<float> column[7];
    std::vector<uint32_t> blocked(kRays);
    Random random = {3};
    shd_assert_ok(shd_embree_create(g_context, &draw, 1, &tree));
    shd_assert_ok(shd_embree_get_tracer(tree, &tracer));
    for (auto &c : column) c.resize(kRays);
    for (size_t i = 0; i < kRays; ++i) {
        const Vec3 d = ref::unit({random.in(-1, 1), random.in(-1, 1), random.in(-1, 1)});
        for (size_t c = 0; c < 3; ++c) {
            column[c][i] = random.real(-2, 2);
            column[3 + c][i] = static_cast<float>(d[c]);
        }
        column[6][i] = i % 3 == 0 ? INFINITY : random.real(0.1, 2);
    }
    const shd_rays rays = {sizeof rays,      kRays,
                           column[0].data(), column[1].data(),
                           column[2].data(), column[3].data(),
                           column[4].data(), column[5].data(),
                           column[6].data()};
    tracer.trace(&rays, blocked.data(), tracer.user_data);
    size_t hits = 0, wrong = 0;
    for (size_t i = 0; i < kRays; ++i) {
        const Vec3 from = {column[0][i], column[1][i], column[2][i]};
        const Vec3 way = {column[3][i], column[4][i], column[5][i]};
        wrong += g_rays->is_blocked(from, std::fmin(double{column[6][i]}, 1e4) * way) != (blocked[i] != 0);
        hits += blocked[i] != 0;
    }
    print_message("%zu of %d rays hit, %zu differ\n", hits, int(kRays), wrong);
    assert_true(hits > kRays / 10 && hits < kRays * 9 / 10 && wrong <= 4);
    shd_embree_release(tree);
}

std::vector<float> occlusion(shd_context *context, const shd_tracer &tracer, size_t begin, size_t end)
{
    std::vector<float> value(end - begin), column[6];
    shd_occlusion_desc desc = shd_occlusion_desc_default();
    shd_occlusion_points points = shd_occlusion_points_default();
    shd_occlusion_values out = {sizeof out, {value.data(), 0}, 0};
    Random random = {7};
    for (auto &c : column) c.resize(end);
    for (size_t i = 0; i < end; ++i) {
        for (auto &c : column) c[i] = random.real(-1, 1);
    }
    for (size_t c = 0; c < 3; ++c) {
        points.position[c].data = column[c].data() + begin;
        points.normal[c].data = column[3 + c].data() + begin;
    }
    points.count = end - begin;
    desc.tracer = tracer;
    desc.ray_count = 37;
    shd_assert_ok(shd_occlusion_compute(context, &desc, &points, &out));
    return value;
}

/// The same bits for any number of workers and any split, and for instances instead of draws.
void test_workers(void **)
{
    const shd_draw draw = draw_of(g_teapot);
    shd_draw instanced = draw;
    shd_draw draws[2] = {draw, draw};
    float matrices[32];
    for (int i = 0; i < 16; ++i) matrices[i] = matrices[16 + i] = draw.object_to_world[i];
    matrices[28] = draws[1].object_to_world[12] = 1.5f;
    instanced.instances = matrices;
    instanced.instance_count = 2;
    shd_embree *tree[2] = {};
    shd_tracer tracer[2];
    shd_assert_ok(shd_embree_create(g_context, draws, 2, &tree[0]));
    shd_assert_ok(shd_embree_create(g_context, &instanced, 1, &tree[1]));
    for (int i = 0; i < 2; ++i) shd_assert_ok(shd_embree_get_tracer(tree[i], &tracer[i]));
    const std::vector<float> want = occlusion(g_context, tracer[0], 0, 900);
    for (uint32_t workers : {1u, 2u, 3u}) {
        shd_context_desc desc = shd_context_desc_default();
        shd_context *context = nullptr;
        desc.worker_count = workers;
        shd_assert_ok(shd_context_create(&desc, &context));
        for (const shd_tracer &t : tracer) {
            const std::vector<float> got = occlusion(context, t, 100, 900);
            assert_memory_equal(got.data(), want.data() + 100, got.size() * sizeof(float));
        }
        shd_context_release(context);
    }
    for (shd_embree *t : tree) shd_embree_release(t);
}

/// Meshes without triangles or with positions that are not finite, and no draws: no ray is blocked.
void test_odd_meshes(void **)
{
    const float position[9] = {0, 0, 0, NAN, 0, 0, 0, INFINITY, 0};
    for (uint32_t count : {0u, 3u, 9u}) {
        shd_mesh_desc mesh_desc = shd_mesh_desc_default();
        shd_mesh *mesh = nullptr;
        shd_embree *tree = nullptr;
        shd_tracer tracer;
        mesh_desc.vertex_count = count % 9;
        mesh_desc.flags = SHD_MESH_KEEP_NONFINITE;
        for (size_t c = 0; c < 3; ++c) mesh_desc.position[c] = shd_f32_column(position + c, 12);
        shd_assert_ok(shd_mesh_create(g_context, &mesh_desc, &mesh));
        const shd_draw draw = draw_of(mesh);
        shd_assert_ok(shd_embree_create(g_context, &draw, count == 9 ? 0 : 1, &tree));
        shd_assert_ok(shd_embree_get_tracer(tree, &tracer));
        for (float value : occlusion(g_context, tracer, 0, 20)) assert_true(value == 1.0f);
        shd_embree_release(tree);
        shd_mesh_release(mesh);
    }
}

struct bad_case {
    const char *name;
    void (*edit)(shd_draw *draw);
    const char *message;
};
float g_matrix[16];
const bad_case k_bad[] = {
    {"bad/mesh", [](shd_draw *d) { d->mesh = nullptr; }, "embree.draws[1].mesh: NULL"},
    {"bad/handle", [](shd_draw *d) { d->mesh = reinterpret_cast<shd_mesh *>(g_context); }, "mesh: not a live handle"},
    {"bad/matrix_nan", [](shd_draw *d) { d->object_to_world[5] = NAN; },
     "embree.draws[1]: element 5 of a matrix is nan"},
    {"bad/matrix_row", [](shd_draw *d) { d->object_to_world[15] = 2; }, "embree.draws[1]: the last row of a matrix"},
    {"bad/instances", [](shd_draw *d) { d->instance_count = 1; }, "embree.draws[1].instances: NULL"},
    {"bad/instance", [](shd_draw *d) { d->instances = g_matrix, d->instance_count = 1; }, "the last row of a matrix"},
    {"bad/instance_count", [](shd_draw *d) { d->instances = g_matrix, d->instance_count = 2000000; },
     "embree.draws[1].instance_count: 2000000"},
    {"bad/struct_size", [](shd_draw *d) { d->struct_size -= 4; }, "embree.draws[1].struct_size"},
};

void test_bad(void **state)
{
    const auto &c = *static_cast<const bad_case *>(*state);
    shd_draw draws[2] = {draw_of(g_teapot), draw_of(g_teapot)};
    auto *tree = reinterpret_cast<shd_embree *>(g_context);
    c.edit(&draws[1]);
    shd_assert_result(c.name, shd_embree_create(g_context, draws, 2, &tree), SHD_ERROR_INVALID_ARGUMENT, c.message);
    assert_null(tree);
}

void test_bad_handles(void **)
{
    const shd_draw draw = draw_of(g_teapot);
    shd_embree *tree = nullptr;
    shd_tracer tracer = {nullptr, &tree};
    const auto refused = [](shd_result result, const char *message) {
        shd_assert_result(message, result, SHD_ERROR_INVALID_ARGUMENT, message);
    };
    refused(shd_embree_create(nullptr, &draw, 1, &tree), "context: NULL");
    refused(shd_embree_create(g_context, nullptr, 1, &tree), "embree.draws: NULL");
    refused(shd_embree_create(g_context, &draw, size_t{1} << 21, &tree), "embree.draw_count: 2097152");
    refused(shd_embree_create(g_context, &draw, 1, nullptr), "out_embree: NULL");
    refused(shd_embree_get_tracer(nullptr, &tracer), "embree: NULL");
    assert_null(tracer.user_data);
    refused(shd_embree_get_tracer(reinterpret_cast<shd_embree *>(g_teapot), &tracer), "");
    shd_assert_ok(shd_embree_create(g_context, &draw, 1, &tree));
    refused(shd_embree_get_tracer(tree, nullptr), "out_tracer: NULL");
    shd_embree_retain(tree);
    shd_embree_release(tree);
    shd_assert_ok(shd_embree_get_tracer(tree, &tracer));
    shd_embree_release(tree);
    shd_embree_retain(nullptr);
    shd_embree_release(nullptr);
}

}  // namespace
}  // namespace shd::tests

int main()
{
    using namespace shd::tests;
    CMUnitTest tests[16];
    size_t n = 0;
    tests[n++] = {"rays", test_rays, nullptr, nullptr, nullptr};
    tests[n++] = {"workers", test_workers, nullptr, nullptr, nullptr};
    tests[n++] = {"odd_meshes", test_odd_meshes, nullptr, nullptr, nullptr};
    for (const bad_case &c : k_bad) tests[n++] = {c.name, test_bad, nullptr, nullptr, const_cast<bad_case *>(&c)};
    tests[n++] = {"bad_handles", test_bad_handles, nullptr, nullptr, nullptr};
    return _cmocka_run_group_tests("api.embree", tests, n, set_up, tear_down);
}
