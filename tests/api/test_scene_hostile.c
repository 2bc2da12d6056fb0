/* SPDX-License-Identifier: MIT */
/* Damaged files, and files that are not models: each load either fails with a message that names the file, or leaves
 * out unusable parts and reports them. */
#define _GNU_SOURCE
#include "support/odd_paths.h"
#include "support/rows.h"
#include "support/scene_files.h"

#include <fcntl.h>

#include <shd/shd.h>

static shd_context *g_context;

static int set_up(void **state) { return scene_set_up(state, &g_context); }
static int tear_down(void **state) { return scene_tear_down(state, g_context); }

/* Loads any file: a loaded scene is complete, and an error names the file. Returns the result. */
static shd_result survive(const char *name)
{
    shd_scene *scene = NULL;
    const shd_result result = shd_scene_load(g_context, io_path(name), NULL, &scene);
    if (result == SHD_OK) {
        shd_scene_info info = shd_scene_info_default();
        uint32_t i;
        shd_assert_ok(shd_scene_get_info(scene, &info));
        assert_true(info.mesh_count > 0 && info.instance_count > 0 && info.material_count > 0);
        for (i = 0; i < info.instance_count; ++i) {
            shd_scene_instance instance = shd_scene_instance_default();
            shd_assert_ok(shd_scene_get_instance(scene, i, &instance));
            assert_true(instance.mesh < info.mesh_count && instance.material < info.material_count);
        }
    } else {
        assert_null(scene);
        if (!strstr(shd_last_error(), name)) fail_msg("%s: \"%s\" does not name it", name, shd_last_error());
        assert_true(result == SHD_ERROR_CORRUPT || result == SHD_ERROR_UNSUPPORTED || result == SHD_ERROR_LIMIT ||
                    result == SHD_ERROR_IO || result == SHD_ERROR_NOT_FOUND);
    }
    shd_scene_release(scene);
    return result;
}

/* Files of a few bytes. */

struct file_case {
    const char *name;
    const char *text;
    shd_result result;
    const char *message;
};

static const struct file_case k_files[] = {
    {"empty.obj", "", SHD_ERROR_CORRUPT, "is empty"},
    {"noise.obj", "\x01\x02\xff\xfe noise \n noise", SHD_ERROR_UNSUPPORTED, ""},
    {"noise.xyz", "\x01\x02\xff\xfe noise \n noise", SHD_ERROR_UNSUPPORTED,
#if defined(SHD_HAS_ASSIMP)
     "assimp has no reader for this format or version"},
#else
     "the content is not glTF 2.0, OBJ, PLY or STL, which this build reads: it has no assimp"},
#endif
    {"lines.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n", SHD_ERROR_UNSUPPORTED, "no triangles in it"},
    {"points.obj", "v 0 0 0\nv 1 0 0\np 1\n", SHD_ERROR_UNSUPPORTED, "no triangles in it"},
    {"nowhere.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", SHD_ERROR_UNSUPPORTED, "no triangles in it: mesh \""},
#if defined(SHD_HAS_ASSIMP)
    {"brace.gltf", "{", SHD_ERROR_CORRUPT, ""},
    {"array.gltf", "[1, 2, 3]", SHD_ERROR_CORRUPT, ""},
#else
    {"brace.gltf", "{", SHD_ERROR_UNSUPPORTED, "not glTF 2.0"},
    {"array.gltf", "[1, 2, 3]", SHD_ERROR_UNSUPPORTED, "not glTF 2.0"},
#endif
    {"version.gltf", "{\"asset\":{\"version\":\"2.0\"}}", SHD_ERROR_UNSUPPORTED, "no triangles in it"},
    {"header.glb", "glTF\x02", SHD_ERROR_CORRUPT, "binary glTF"},
    {"header.ply", "ply\nformat ascii 1.0\nelement vertex 3\n", SHD_ERROR_CORRUPT, ""},
    {"header.stl", "solid nothing\nendsolid nothing\n", SHD_ERROR_UNSUPPORTED, "no triangles in it"},
#if defined(SHD_HAS_ASSIMP)
    {"tree.dae", "<?xml version=\"1.0\"?><COLLADA version=\"1.4.1\"></COLLADA>", SHD_ERROR_CORRUPT, ""},
#else
    {"tree.dae", "<?xml version=\"1.0\"?><COLLADA version=\"1.4.1\"></COLLADA>", SHD_ERROR_UNSUPPORTED, "no assimp"},
#endif
};

static void test_file(void **state)
{
    const struct file_case *c = (const struct file_case *)*state;
    scene_write_text(c->name, c->text);
    shd_assert_result(c->name, survive(c->name), c->result, c->message);
}

/* Models, and materials, textures and buffers of models, that are no readable regular files. */
static void test_paths(void **state)
{
    size_t i;
    (void)state;
    make_odd_paths();
    for (i = 0; i < ODD_PATHS; ++i) {
        const odd_path *p = &k_odd_paths[i];
        shd_scene *scene = NULL;
        char text[1024];
        if (!has_odd_path(p)) continue;
        alarm(20); /* ends the test if a load waits */
        shd_assert_result(p->name, survive(p->name), p->expected, p->message);
        snprintf(text, sizeof text, "mtllib %s\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", p->name);
        scene_write_text("odd.obj", text);
        assert_int_equal(survive("odd.obj"), SHD_OK);
        snprintf(text, sizeof text, "mtllib odd.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\n");
        scene_write_text("odd.obj", text);
        snprintf(text, sizeof text, "newmtl a\nKd 1 1 1\nmap_Kd %s\n", p->name);
        scene_write_text("odd.mtl", text);
        shd_assert_ok(shd_scene_load(g_context, io_path("odd.obj"), NULL, &scene));
        assert_non_null(shd_scene_get_warning(scene, 0));
        shd_scene_release(scene);
        snprintf(text, sizeof text,
                 "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],"
                 "\"buffers\":[{\"uri\":\"%s\",\"byteLength\":36}],"
                 "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],"
                 "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],"
                 "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}]}",
                 p->name);
        scene_write_text("odd.gltf", text);
        assert_int_equal(survive("odd.gltf"), SHD_ERROR_UNSUPPORTED);
        alarm(0);
    }
}

#if defined(SHD_HAS_ASSIMP)
/* Number of bytes that a load prints to standard output and standard error. */
static long printed_by(const char *name, shd_result expected)
{
    const int out = dup(1), error = dup(2), file = open(io_path("printed"), O_RDWR | O_CREAT | O_TRUNC, 0600);
    struct stat status;
    shd_result result;
    fflush(NULL);
    dup2(file, 1);
    dup2(file, 2);
    result = survive(name);
    fflush(NULL);
    dup2(out, 1);
    dup2(error, 2);
    assert_int_equal(fstat(file, &status), 0);
    close(file);
    close(out);
    close(error);
    assert_int_equal(result, expected);
    return (long)status.st_size;
}

/* A valid Ogre mesh with a skeleton, and a damaged file of OpenGEX: assimp's readers print about both. */
static void test_silent(void **state)
{
    (void)state;
    scene_write_text("fish.mesh.xml",
                     "<mesh><sharedgeometry vertexcount=\"3\"><vertexbuffer positions=\"true\">"
                     "<vertex><position x=\"0\" y=\"0\" z=\"0\"/></vertex>"
                     "<vertex><position x=\"1\" y=\"0\" z=\"0\"/></vertex>"
                     "<vertex><position x=\"0\" y=\"1\" z=\"0\"/></vertex></vertexbuffer></sharedgeometry>"
                     "<submeshes><submesh usesharedvertices=\"true\" use32bitindexes=\"false\" "
                     "operationtype=\"triangle_list\"><faces count=\"1\"><face v1=\"0\" v2=\"1\" v3=\"2\"/></faces>"
                     "</submesh></submeshes><skeletonlink name=\"fish.skeleton\"/></mesh>");
    scene_write_text("fish.skeleton.xml",
                     "<skeleton><bones><bone id=\"0\" name=\"tail\"><position x=\"0\" y=\"0\" z=\"0\"/>"
                     "<rotation angle=\"0\"><axis x=\"1\" y=\"0\" z=\"0\"/></rotation></bone></bones></skeleton>");
    scene_write_text("empty.ogex", "Metric (key = \"up\") {string {\"z\"}}\nGeometryNode {float[0] {}}\n");
    assert_int_equal(printed_by("fish.mesh.xml", SHD_OK), 0);
    assert_int_equal(printed_by("empty.ogex", SHD_ERROR_UNSUPPORTED), 0);
}
#endif

/* Unusable triangles are left out and reported; the others stay. */
static void test_bad_triangles(void **state)
{
    shd_scene *scene = NULL;
    shd_scene_info info = shd_scene_info_default();
    (void)state;
    scene_write_text("nan.ply",
                     "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                     "property float z\nelement face 2\nproperty list uchar int vertex_indices\n"
                     "end_header\n0 0 0\n1 0 0\n0 1 0\nnan 1 1\n3 0 1 2\n3 1 2 3\n");
    shd_assert_ok(shd_scene_load(g_context, io_path("nan.ply"), NULL, &scene));
    shd_assert_ok(shd_scene_get_info(scene, &info));
    assert_int_equal(info.triangle_count, 1);
    assert_int_equal(info.warning_count, 1);
    assert_non_null(strstr(shd_scene_get_warning(scene, 0), "1 faces with indices out of range or positions"));
    shd_scene_release(scene);
}

/* A node below a node below a node: as deep as allowed, and deeper. */
static void test_deep_nodes(void **state)
{
    static const int k_depths[2] = {500, 2000};
    int k, i;
    (void)state;
    for (k = 0; k < 2; ++k) {
        const size_t room = 4096 + 40 * (size_t)k_depths[k];
        char *text = (char *)malloc(room);
        size_t size = (size_t)snprintf(text, room,
                                       "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
                                       "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[");
        for (i = 0; i < k_depths[k]; ++i) {
            size += (size_t)snprintf(text + size, room - size, "{\"children\":[%d]},", i + 1);
        }
        snprintf(text + size, room - size, "{\"mesh\":0}],\"materials\":[{}]," ROOM_BUFFERS "\"samplers\":[]}");
        scene_write_text("deep.gltf", text);
        free(text);
        if (k == 0) {
            assert_int_equal(survive("deep.gltf"), SHD_OK);
        } else {
            shd_assert_result("deep", survive("deep.gltf"), SHD_ERROR_LIMIT, "nested more than 512 deep");
        }
    }
}

/* Instances with a matrix that is not finite are left out; here no others exist. */
static void test_wild_matrix(void **state)
{
    char text[4096];
    (void)state;
    snprintf(text, sizeof text,
             "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
             "\"nodes\":[{\"scale\":[1e30,1,1],\"children\":[1]},{\"scale\":[1e30,1,1],\"mesh\":0}],"
             "\"materials\":[{}]," ROOM_BUFFERS "\"samplers\":[]}");
    scene_write_text("wild.gltf", text);
    shd_assert_result("wild", survive("wild.gltf"), SHD_ERROR_UNSUPPORTED,
                      "no triangles in it: instances whose matrices");
}

/* Valid files, truncated at every byte, and with changed bytes. */
static void test_cut(void **state)
{
    static const char *const k_names[2] = {"cut.obj", "cut.ply"};
    static const char k_ply[] =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
        "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    const char *texts[2];
    size_t k, n;
    (void)state;
    texts[0] = k_triangle_obj;
    texts[1] = k_ply;
    for (k = 0; k < 2; ++k) {
        const size_t size = strlen(texts[k]);
        for (n = 0; n <= size; ++n) {
            io_write(io_path(k_names[k]), texts[k], n);
            survive(k_names[k]);
        }
    }
    for (n = 0; n < strlen(k_room_gltf); n += 7) {
        io_write(io_path("cut.gltf"), k_room_gltf, n);
        survive("cut.gltf");
    }
}

/* Names of a hostile file in messages: one line of text. */
static void test_names(void **state)
{
    shd_scene *scene = NULL;
    const char *c;
    (void)state;
    scene_write_text("names.obj",
                     "mtllib names.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl \x1b[31mred\n"
                     "f 1/1 2/1 3/1\n");
    scene_write_text("names.mtl", "newmtl \x1b[31mred\nKd 1 1 1\nmap_Kd \x1b[2J\xff.png\n");
    shd_assert_ok(shd_scene_load(g_context, io_path("names.obj"), NULL, &scene));
    for (c = shd_scene_get_name(scene, SHD_SCENE_PART_MATERIAL, 0); *c; ++c) assert_true(*c >= 0x20);
    assert_non_null(shd_scene_get_warning(scene, 0));
    for (c = shd_scene_get_warning(scene, 0); *c; ++c)
        assert_true((unsigned char)*c >= 0x20 && (unsigned char)*c < 0x7f);
    shd_scene_release(scene);
}

int main(void)
{
    ADD_ROWS(k_files, test_file);
    add("paths", test_paths, NULL);
    add("bad_triangles", test_bad_triangles, NULL);
    add("deep_nodes", test_deep_nodes, NULL);
    add("wild_matrix", test_wild_matrix, NULL);
    add("cut", test_cut, NULL);
    add("names", test_names, NULL);
#if defined(SHD_HAS_ASSIMP)
    add("silent", test_silent, NULL);
#endif
    return _cmocka_run_group_tests("api.scene_hostile", g_tests, g_count, set_up, tear_down);
}
