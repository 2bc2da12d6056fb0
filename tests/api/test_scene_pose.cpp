// SPDX-License-Identifier: MIT
// shd_scene_pose() through the C interface: one node that moves, one mesh with a morph target, and one that stays.
#include <cmath>
#include <limits>

#include "support/context.h"
#include "support/gltf_file.h"
#include "support/rows.h"

#include <shd/scene.h>

namespace
{

using namespace shd::tests;
using namespace shd_test;

shd_scene *g_scene;

/// Instance 0: the moving square, from x = 0 at 1 s to x = 4 at 3 s. Instance 1: a square of weight 0 at 1 s and 1 at
/// 3 s, whose upper corners move by 2 in y. Instance 2: a square that stays.
std::string text_of_scene()
{
    GltfFile file;
    const std::string position = std::to_string(file.square());
    const std::string target = std::to_string(file.column<float>({0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 2, 0}, 3));
    const std::string times = std::to_string(file.column<float>({1, 3}, 1));
    const std::string moves = std::to_string(file.column<float>({0, 0, 0, 4, 0, 0}, 3));
    const std::string weights = std::to_string(file.column<float>({0, 1}, 1));
    const std::string indices = std::to_string(file.square_indices());
    const std::string primitive = "{\"attributes\":{\"POSITION\":" + position + "},\"indices\":" + indices;
    file.members =
        ",\"scenes\":[{\"nodes\":[0,1,2]}],\"nodes\":[{\"mesh\":0},{\"mesh\":1},{\"mesh\":0}],"
        "\"meshes\":[{\"primitives\":[" +
        primitive + "}]},{\"primitives\":[" + primitive + ",\"targets\":[{\"POSITION\":" + target +
        "}]}]}],\"animations\":[{\"name\":\"walk\",\"channels\":[{\"sampler\":0,\"target\":{\"node\":0,"
        "\"path\":\"translation\"}},{\"sampler\":1,\"target\":{\"node\":1,\"path\":\"weights\"}}],"
        "\"samplers\":[{\"input\":" +
        times + ",\"output\":" + moves + "},{\"input\":" + times + ",\"output\":" + weights + "}]}]";
    return file.text();
}

int open_scene(void **state)
{
    const std::string text = text_of_scene();
    shd_scene_desc desc = shd_scene_desc_default();
    desc.flags = SHD_SCENE_IN_PROCESS;
    if (set_up(state) != 0) return -1;
    return shd_scene_load_memory(g_context, text.data(), text.size(), "a.gltf", &desc, &g_scene) == SHD_OK ? 0 : -1;
}

int close_scene(void **state)
{
    shd_scene_release(g_scene);
    return tear_down(state);
}

float x_of(const shd_scene *scene, uint32_t index)
{
    shd_scene_instance instance = shd_scene_instance_default();
    shd_assert_ok(shd_scene_get_instance(scene, index, &instance));
    return instance.object_to_world[12];
}

/// Greatest y of a mesh in object space.
float top_of(const shd_scene *scene, uint32_t index)
{
    shd_scene_instance instance = shd_scene_instance_default();
    shd_assert_ok(shd_scene_get_instance(scene, index, &instance));
    float positions[3][6];
    shd_f32_out columns[3];
    shd_mesh_info info = shd_mesh_info_default();
    shd_assert_ok(shd_mesh_get_info(shd_scene_get_mesh(scene, instance.mesh), &info));
    assert_in_range(info.vertex_count, 4, 6);
    for (size_t c = 0; c < 3; ++c) columns[c] = {positions[c], sizeof(float)};
    shd_assert_ok(shd_mesh_read_positions(shd_scene_get_mesh(scene, instance.mesh), columns));
    float top = positions[1][0];
    for (uint32_t i = 1; i < info.vertex_count; ++i) top = std::fmax(top, positions[1][i]);
    return top;
}

void test_info(void **)
{
    shd_scene_info info = shd_scene_info_default();
    double first = -1, last = -1;
    shd_assert_ok(shd_scene_get_info(g_scene, &info));
    assert_int_equal(info.animation_count, 1);
    assert_int_equal(info.deformed_mesh_count, 1);
    assert_int_equal(info.instance_count, 3);
    assert_int_equal(info.warning_count, 0);
    assert_string_equal(shd_scene_get_name(g_scene, SHD_SCENE_PART_ANIMATION, 0), "walk");
    shd_assert_ok(shd_scene_get_animation_times(g_scene, 0, &first, &last));
    assert_true(first == 1 && last == 3);
}

/// Seconds, and where both parts are then.
struct Time {
    const char *name;
    double seconds;
    float x, top;
};

const Time kTimes[] = {
    {"time/before", -5, 0, 1}, {"time/first", 1, 0, 1}, {"time/quarter", 1.5, 1, 1.5f},
    {"time/middle", 2, 2, 2},  {"time/last", 3, 4, 3},  {"time/after", 1e300, 4, 3},
};

void test_time(void **state)
{
    const Time &row = *static_cast<const Time *>(*state);
    shd_scene *pose = nullptr, *again = nullptr;
    shd_assert_ok(shd_scene_pose(g_scene, 0, row.seconds, &pose));
    shd_assert_close(row.name, 0, double(x_of(pose, 0)), double(row.x), 1e-6, 0);
    shd_assert_close(row.name, 1, double(top_of(pose, 1)), double(row.top), 1e-6, 0);
    shd_assert_close(row.name, 2, double(top_of(pose, 2)), 1, 0, 0);
    shd_assert_ok(shd_scene_pose(pose, 0, row.seconds, &again));  // the pose of a pose is that of the file
    assert_true(x_of(again, 0) == x_of(pose, 0) && top_of(again, 1) == top_of(pose, 1));
    shd_scene_release(again);
    shd_scene_release(pose);
    assert_true(x_of(g_scene, 0) == 0 && top_of(g_scene, 1) == 1);
}

/// Parts that do not move are those of the scene, and outlive it.
void test_shared(void **)
{
    shd_scene *pose = nullptr;
    shd_scene_instance moved = shd_scene_instance_default(), rigid = shd_scene_instance_default();
    shd_assert_ok(shd_scene_pose(g_scene, 0, 2, &pose));
    shd_assert_ok(shd_scene_get_instance(pose, 1, &moved));
    shd_assert_ok(shd_scene_get_instance(pose, 2, &rigid));
    assert_ptr_equal(shd_scene_get_mesh(pose, rigid.mesh), shd_scene_get_mesh(g_scene, rigid.mesh));
    assert_ptr_not_equal(shd_scene_get_mesh(pose, moved.mesh), shd_scene_get_mesh(g_scene, moved.mesh));
    assert_ptr_equal(shd_scene_get_material(pose, rigid.material), shd_scene_get_material(g_scene, rigid.material));
    shd_scene_release(pose);
}

struct Bad {
    const char *name;
    uint32_t animation;
    double seconds;
    shd_result result;
    const char *message;
};

const Bad kBad[] = {
    {"bad/animation", 1, 0, SHD_ERROR_NOT_FOUND, "animation: 1"},
    {"bad/nan", 0, std::numeric_limits<double>::quiet_NaN(), SHD_ERROR_INVALID_ARGUMENT, "seconds"},
    {"bad/infinite", 0, std::numeric_limits<double>::infinity(), SHD_ERROR_INVALID_ARGUMENT, "seconds"},
};

void test_bad(void **state)
{
    const Bad &row = *static_cast<const Bad *>(*state);
    shd_scene *pose = g_scene;
    shd_assert_result(row.name, shd_scene_pose(g_scene, row.animation, row.seconds, &pose), row.result, row.message);
    assert_null(pose);
}

void test_null(void **)
{
    shd_scene *pose = nullptr;
    double first = 7, last = 7;
    shd_assert_result("scene", shd_scene_pose(nullptr, 0, 0, &pose), SHD_ERROR_INVALID_ARGUMENT, "scene");
    shd_assert_result("out", shd_scene_pose(g_scene, 0, 0, nullptr), SHD_ERROR_INVALID_ARGUMENT, "out_scene");
    shd_assert_result("times", shd_scene_get_animation_times(g_scene, 9, &first, &last), SHD_ERROR_NOT_FOUND, "9");
    assert_true(first == 0 && last == 0);
}

}  // namespace

int main()
{
    add("info", test_info, nullptr);
    ADD_ROWS(kTimes, test_time);
    add("shared", test_shared, nullptr);
    ADD_ROWS(kBad, test_bad);
    add("null", test_null, nullptr);
    return _cmocka_run_group_tests("api.scene_pose", g_tests, g_count, open_scene, close_scene);
}
