// SPDX-License-Identifier: MIT
// shd_scene_desc.uv_projection: meshes without uv get them from the bounds of the model, in the pose of the file, and
// keep them in other poses.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "support/context.h"
#include "support/gltf_file.h"

#include <shd/scene.h>

namespace
{

using namespace shd::tests;
using namespace shd_test;

/// A quad of x 2..6 and y 0..2, and a square of x 0..1 that has uv; the node of the quad moves it by (1, 0, 0) in the
/// file and by (9, 0, 0) at the end of the animation, which also raises its morph target. Its second place is twice as
/// large, and the bounds of the model are x 0..14.
std::string text_of_scene()
{
    GltfFile file;
    const auto text = [](int i) { return std::to_string(i); };
    const std::string quad = text(file.column<float>({2, 0, 0, 6, 0, 0, 6, 2, 0, 2, 2, 0}, 3));
    const std::string square = text(file.square());
    const std::string uv = text(file.column<float>({0.25f, 0.75f, 0.5f, 0.75f, 0.5f, 0.5f, 0.25f, 0.5f}, 2));
    const std::string target = text(file.column<float>({0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 2, 0}, 3));
    const std::string times = text(file.column<float>({1, 3}, 1));
    const std::string moves = text(file.column<float>({1, 0, 0, 9, 0, 0}, 3));
    const std::string weights = text(file.column<float>({0, 1}, 1));
    const std::string indices = text(file.square_indices());
    file.members =
        ",\"scenes\":[{\"nodes\":[0,1,2,3]}],\"nodes\":[{\"mesh\":0,\"translation\":[1,0,0]},{\"mesh\":1},"
        "{\"mesh\":2,\"translation\":[1,0,0]},{\"mesh\":2,\"translation\":[2,0,0],\"scale\":[2,2,2]}],\"meshes\":["
        "{\"primitives\":[{\"attributes\":{\"POSITION\":" +
        quad + "},\"indices\":" + indices + ",\"targets\":[{\"POSITION\":" + target +
        "}]}]},{\"primitives\":[{\"attributes\":{\"POSITION\":" + square + ",\"TEXCOORD_0\":" + uv +
        "},\"indices\":" + indices + "}]},{\"primitives\":[{\"attributes\":{\"POSITION\":" + quad +
        "},\"indices\":" + indices +
        "}]}],\"animations\":[{\"channels\":[{\"sampler\":0,\"target\":{\"node\":0,\"path\":\"translation\"}},"
        "{\"sampler\":1,\"target\":{\"node\":0,\"path\":\"weights\"}}],\"samplers\":[{\"input\":" +
        times + ",\"output\":" + moves + "},{\"input\":" + times + ",\"output\":" + weights + "}]}]";
    return file.text();
}

/// A skin of two joints on a wall behind and one in front; the upper joint rises by 2 until the end.
/// @param length  length of the normals in the file
std::string text_of_skin(float length = 1)
{
    GltfFile file;
    const auto text = [](int i) { return std::to_string(i); };
    std::vector<float> position, normal, weight;
    std::vector<uint8_t> joint;
    for (const float z : {-1.0f, 1.0f}) {
        for (const float y : {-1.0f, 1.0f}) {
            for (const float x : {-1.0f, 0.0f, 1.0f}) {
                position.insert(position.end(), {x, y, z});
                normal.insert(normal.end(), {0, 0, length * z});  // without them each triangle has vertices of its own
                joint.insert(joint.end(), {static_cast<uint8_t>(y > 0 ? 1 : 0), 0, 0, 0});
                weight.insert(weight.end(), {1, 0, 0, 0});
            }
        }
    }
    const std::string indices =
        text(file.column<uint16_t>({0, 3, 1, 1, 3, 4, 1, 4, 2, 2, 4, 5, 6, 7, 9, 7, 10, 9, 7, 8, 10, 8, 11, 10}, 1));
    const std::string attributes = "{\"POSITION\":" + text(file.column<float>(position, 3)) +
                                   ",\"NORMAL\":" + text(file.column<float>(normal, 3)) +
                                   ",\"JOINTS_0\":" + text(file.column<uint8_t>(joint, 4)) +
                                   ",\"WEIGHTS_0\":" + text(file.column<float>(weight, 4)) + "}";
    const std::string times = text(file.column<float>({1, 3}, 1));
    const std::string moves = text(file.column<float>({0, 0, 0, 0, 2, 0}, 3));
    file.members =
        ",\"scenes\":[{\"nodes\":[0,1,2]}],\"nodes\":[{\"mesh\":0,\"skin\":0},{\"translation\":[0,0,0]},"
        "{\"translation\":[0,0,0]}],\"skins\":[{\"joints\":[1,2]}],\"meshes\":[{\"primitives\":[{\"attributes\":" +
        attributes + ",\"indices\":" + indices +
        "}]}],\"animations\":[{\"channels\":[{\"sampler\":0,\"target\":{\"node\":2,\"path\":\"translation\"}}],"
        "\"samplers\":[{\"input\":" +
        times + ",\"output\":" + moves + "}]}]";
    return file.text();
}

shd_result load(shd_uv_projection projection, shd_scene **out, const std::string &text = text_of_scene())
{
    shd_scene_desc desc = shd_scene_desc_default();
    desc.flags = SHD_SCENE_IN_PROCESS;
    desc.uv_projection = projection;
    return shd_scene_load_memory(g_context, text.data(), text.size(), "a.gltf", &desc, out);
}

struct Vertices {
    std::vector<float> position, normal, uv, tangent;
};
Vertices read(const shd_scene *scene, size_t instance_index)
{
    shd_scene_instance instance = shd_scene_instance_default();
    shd_mesh_info info = shd_mesh_info_default();
    Vertices out;
    shd_assert_ok(shd_scene_get_instance(scene, instance_index, &instance));
    const shd_mesh *mesh = shd_scene_get_mesh(scene, instance.mesh);
    shd_assert_ok(shd_mesh_get_info(mesh, &info));
    out.position.resize(3 * info.vertex_count);
    out.uv.resize(2 * info.vertex_count);
    out.tangent.resize(4 * info.vertex_count);
    shd_f32_out columns[9];
    for (size_t c = 0; c < 9; ++c) {
        columns[c] = c < 3   ? shd_f32_out{out.position.data() + c, 3 * sizeof(float)}
                     : c < 5 ? shd_f32_out{out.uv.data() + c - 3, 2 * sizeof(float)}
                             : shd_f32_out{out.tangent.data() + c - 5, 4 * sizeof(float)};
    }
    shd_assert_ok(shd_mesh_read_positions(mesh, columns));
    shd_assert_ok(shd_mesh_read_uv(mesh, columns + 3));
    shd_assert_ok(shd_mesh_read_tangents(mesh, columns + 5));
    out.normal.resize(out.position.size());
    for (size_t c = 0; c < 3; ++c) columns[c].data = out.normal.data() + c;
    shd_assert_ok(shd_mesh_read_normals(mesh, columns));
    return out;
}

/// Planar uv of a position that the first place moves by 1: the box of the model is x 0..14, y 0..4.
void expect_planar(const Vertices &vertices)
{
    for (size_t i = 0; i < vertices.uv.size() / 2; ++i) {
        const double x = static_cast<double>(vertices.position[3 * i]) + 1,
                     y = static_cast<double>(vertices.position[3 * i + 1]);
        shd_assert_close("u", i, static_cast<double>(vertices.uv[2 * i]), x / 14, 1e-6, 0);
        shd_assert_close("v", i, static_cast<double>(vertices.uv[2 * i + 1]), 0.5 - (y - 2) / 14, 1e-6, 0);
        assert_true(vertices.tangent[4 * i] == 1.0f && vertices.tangent[4 * i + 3] == 1.0f);
    }
}

void test_planar(void **)
{
    shd_scene *scene = nullptr, *pose = nullptr;
    shd_assert_ok(load(SHD_UV_PROJECTION_PLANAR, &scene));
    const Vertices moving = read(scene, 0);
    expect_planar(moving);
    expect_planar(read(scene, 2));
    assert_true(read(scene, 2).uv == read(scene, 3).uv);
    const Vertices given = read(scene, 1);
    assert_true(given.uv[0] == 0.25f && given.uv[1] == 0.75f);
    shd_assert_ok(shd_scene_pose(scene, 0, 3, &pose));
    const Vertices posed = read(pose, 0);
    assert_true(posed.uv == moving.uv && posed.position != moving.position);
    shd_scene_release(pose);
    shd_scene_release(scene);
}

/// Other projections split vertices; the morph target moves the copies with their originals.
void test_split(void **)
{
    for (int kind = SHD_UV_PROJECTION_SPHERICAL; kind <= SHD_UV_PROJECTION_BOX; ++kind) {
        shd_scene *scene = nullptr, *pose = nullptr;
        shd_assert_ok(load(static_cast<shd_uv_projection>(kind), &scene));
        shd_assert_ok(shd_scene_pose(scene, 0, 3, &pose));
        const Vertices before = read(scene, 0), after = read(pose, 0);
        assert_true(before.uv == after.uv);
        for (size_t i = 0; i < before.position.size() / 3; ++i) {
            const float y = before.position[3 * i + 1];
            assert_true(after.position[3 * i + 1] == (y > 1 ? y + 2 : y));
        }
        shd_scene_release(pose);
        shd_scene_release(scene);
    }
}

/// Copies at the seam move with the joints of their originals.
void test_skin(void **)
{
    shd_scene *scene = nullptr, *pose = nullptr;
    shd_assert_ok(load(SHD_UV_PROJECTION_CYLINDRICAL, &scene, text_of_skin()));
    shd_assert_ok(shd_scene_pose(scene, 0, 3, &pose));
    const Vertices before = read(scene, 0), after = read(pose, 0);
    assert_true(before.uv == after.uv);
    size_t at_seam[2] = {0, 0};
    for (size_t i = 0; i < before.position.size() / 3; ++i) {
        const float *p = &before.position[3 * i], *q = &after.position[3 * i], *uv = &before.uv[2 * i];
        shd_assert_close("y", i, static_cast<double>(q[1]), p[1] > 0 ? 3 : -1, 1e-6, 0);
        if (p[0] == 0 && p[2] < 0 && (uv[0] == 0 || uv[0] == 1)) ++at_seam[uv[0] > 0 ? 1 : 0];
    }
    assert_int_equal(before.uv.size() / 2, 14);
    assert_true(at_seam[0] == 2 && at_seam[1] == 2);
    shd_scene_release(pose);
    shd_scene_release(scene);
}

/// Normals of length 0 are computed before vertices are split: copies have those of their originals.
void test_normals(void **)
{
    shd_scene *scene = nullptr;
    shd_assert_ok(load(SHD_UV_PROJECTION_CYLINDRICAL, &scene, text_of_skin(0)));
    const Vertices walls = read(scene, 0);
    assert_int_equal(walls.normal.size() / 3, 14);
    for (size_t i = 0; i < walls.normal.size(); i += 3) {
        const float z = walls.position[i + 2];
        assert_true(walls.normal[i] == 0 && walls.normal[i + 1] == 0 && walls.normal[i + 2] == z);
    }
    shd_scene_release(scene);
}

void test_none(void **)
{
    shd_scene *scene = nullptr;
    shd_assert_ok(load(SHD_UV_PROJECTION_NONE, &scene));
    for (const float value : read(scene, 0).uv) assert_true(value == 0.0f);
    shd_scene_release(scene);
}

void test_bad(void **)
{
    shd_scene *scene = nullptr;
    shd_assert_result("bad", load(static_cast<shd_uv_projection>(5), &scene), SHD_ERROR_INVALID_ARGUMENT,
                      "scene.uv_projection: 5 is not in 0..4");
    assert_null(scene);
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        {"planar", test_planar, nullptr, nullptr, nullptr}, {"split", test_split, nullptr, nullptr, nullptr},
        {"skin", test_skin, nullptr, nullptr, nullptr},     {"none", test_none, nullptr, nullptr, nullptr},
        {"bad", test_bad, nullptr, nullptr, nullptr},       {"normals", test_normals, nullptr, nullptr, nullptr},
    };
    return _cmocka_run_group_tests("api.scene_uv", tests, 6, set_up, tear_down);
}
