/* SPDX-License-Identifier: MIT */
/* Models by the worker: memory, callbacks, the rules for names, and damaged files. */
#define _XOPEN_SOURCE 700
#include "support/io_worker.h"
#include "support/rows.h"
#include "support/scene_files.h"

static shd_context *g_context;

static int set_up(void **state)
{
    if (scene_set_up(state, &g_context)) return -1;
    assert_int_equal(mkdir(io_path("inner"), 0700), 0);
    return 0;
}

static int tear_down(void **state)
{
    static const char *const files[] = {"inner/link.mtl", "inner/m.obj", "inner/tri.mtl"};
    for (size_t i = 0; i < sizeof files / sizeof *files; ++i) unlink(io_path(files[i]));
    rmdir(io_path("inner"));
    return scene_tear_down(state, g_context);
}

static shd_scene_info info_of(const shd_scene *scene)
{
    shd_scene_info info = shd_scene_info_default();
    shd_assert_ok(shd_scene_get_info(scene, &info));
    return info;
}

/* FNV-1a of all that a scene has. */
static uint64_t mix(uint64_t hash, const void *bytes, size_t size)
{
    const unsigned char *next = bytes;
    for (size_t i = 0; i < size; ++i) hash = (hash ^ next[i]) * 1099511628211u;
    return hash;
}

static uint64_t hash_of(const shd_scene *scene)
{
    const shd_scene_info info = info_of(scene);
    uint64_t hash = mix(14695981039346656037u, &info, sizeof info);
    for (uint32_t i = 0; i < info.mesh_count; ++i) {
        shd_mesh_info mesh = shd_mesh_info_default();
        shd_assert_ok(shd_mesh_get_info(shd_scene_get_mesh(scene, i), &mesh));
        float *p = malloc(sizeof *p * 3 * (mesh.vertex_count + 1));
        shd_f32_out columns[3] = {{p, 12}, {p + 1, 12}, {p + 2, 12}};
        shd_assert_ok(shd_mesh_read_positions(shd_scene_get_mesh(scene, i), columns));
        hash = mix(hash, p, sizeof *p * 3 * mesh.vertex_count);
        free(p);
    }
    for (uint32_t i = 0; i < info.instance_count; ++i) {
        shd_scene_instance instance = shd_scene_instance_default();
        shd_assert_ok(shd_scene_get_instance(scene, i, &instance));
        hash = mix(hash, instance.object_to_world, sizeof instance.object_to_world);
    }
    for (uint32_t i = 0; i < info.light_count; ++i) {
        shd_light_desc light = shd_light_desc_default();
        shd_assert_ok(shd_scene_get_light_desc(scene, i, &light));
        hash = mix(hash, light.position, 6 * sizeof(float));
    }
    for (uint32_t i = 0; i < info.warning_count; ++i) {
        const char *text = shd_scene_get_warning(scene, i);
        hash = mix(hash, text, strlen(text));
    }
    return hash;
}

/* One model gives one scene, read by the worker, in this process, and from memory. */
static const char *const k_models[] = {"tri.obj", "room.gltf"};

/* Files that a load borrows. */
struct lent {
    io_bytes file[8];
    size_t count;
};

static shd_result find_in_folder(const char *name, const void **out_bytes, size_t *out_size, void *user)
{
    struct lent *lent = user;
    if (lent->count == sizeof lent->file / sizeof lent->file[0]) return SHD_ERROR_LIMIT;
    if (strchr(name, '/') || access(io_path(name), R_OK) != 0) return SHD_ERROR_NOT_FOUND;
    lent->file[lent->count] = io_read(io_path(name));
    *out_bytes = lent->file[lent->count].data;
    *out_size = lent->file[lent->count++].size;
    return SHD_OK;
}

static void free_lent(struct lent *lent)
{
    while (lent->count > 0) free(lent->file[--lent->count].data);
}

static void test_one_scene(void **state)
{
    for (size_t i = 0; i < 2; ++i) {
        shd_scene *scene = NULL;
        shd_scene_desc desc = shd_scene_desc_default();
        io_bytes file = io_read(io_path(k_models[i]));
        struct lent lent = {.count = 0};
        uint64_t hashes[3];
        (void)state;
        for (size_t k = 0; k < 3; ++k) {
            desc.flags = k == 1 ? SHD_SCENE_IN_PROCESS : SHD_SCENE_NONE;
            desc.find = k == 2 ? find_in_folder : NULL;
            desc.user_data = &lent;
            shd_assert_ok(k == 2 ? shd_scene_load_memory(g_context, file.data, file.size, k_models[i], &desc, &scene)
                                 : shd_scene_load(g_context, io_path(k_models[i]), &desc, &scene));
            hashes[k] = hash_of(scene);
            assert_int_equal(info_of(scene).texture_count, i == 0 ? 2 : 0);
            shd_scene_release(scene);
            free_lent(&lent);
        }
        assert_true(hashes[0] == hashes[1]);
        assert_true(hashes[0] == hashes[2]);
        free(file.data);
    }
}

static void count_warning(shd_log_level level, const char *message, void *count)
{
    if (level == SHD_LOG_LEVEL_WARNING && *message) ++*(size_t *)count;
}

/* A model in memory reads no file of the disk: its textures and materials are warnings, which are logged, too. */
static void test_memory_alone(void **state)
{
    shd_scene *scene = NULL;
    shd_context *context = NULL;
    shd_context_desc desc = shd_context_desc_default();
    size_t logged = 0;
    (void)state;
    desc.log.write = count_warning;
    desc.log.user_data = &logged;
    shd_assert_ok(shd_context_create(&desc, &context));
    shd_assert_ok(shd_scene_load_memory(context, k_triangle_obj, strlen(k_triangle_obj), "tri.obj", NULL, &scene));
    assert_int_equal(info_of(scene).texture_count, 0);
    assert_true(info_of(scene).warning_count > 0);
    assert_int_equal(info_of(scene).warning_count, logged);
    shd_scene_release(scene);
    shd_context_release(context);
    shd_assert_result("null", shd_scene_load_memory(g_context, NULL, 1, "x", NULL, &scene), SHD_ERROR_INVALID_ARGUMENT,
                      "bytes: NULL");
}

/* The worker of the first load serves all later ones, of models and of images. */
static void test_one_worker(void **state)
{
    const char *program = io_copy_worker(SHD_IO_WORKER, "one-worker");
    shd_load_desc texture = shd_load_desc_default();
    shd_scene_desc desc = shd_scene_desc_default();
    io_worker first, later;
    (void)state;
    texture.worker_path = program;
    desc.texture = &texture;
    for (int i = 0; i < 3; ++i) {
        shd_scene *scene = NULL;
        shd_assert_ok(shd_scene_load(g_context, io_path("tri.obj"), &desc, &scene));
        assert_int_equal(info_of(scene).texture_count, 2);
        shd_scene_release(scene);
        later = io_await_worker(program, 1);
        if (i == 0) first = later;
        assert_int_equal(later.server, first.server);
    }
    kill(later.server, SIGTERM);
    (void)io_await_worker(program, -1);
    unlink(program);
}

static shd_result find_nothing_more(const char *name, const void **out_bytes, size_t *out_size, void *user)
{
    (void)user, (void)name, (void)out_bytes, (void)out_size;
    return SHD_ERROR_LIMIT;
}

static void test_find_refuses(void **state)
{
    shd_scene *scene = NULL;
    shd_scene_desc desc = shd_scene_desc_default();
    (void)state;
    desc.find = find_nothing_more;
    shd_assert_result("find", shd_scene_load(g_context, io_path("tri.obj"), &desc, &scene), SHD_ERROR_LIMIT,
                      "scene.find failed for \"tri.mtl\"");
    assert_null(scene);
}

/* Names that leave the folder of the model are read only with SHD_SCENE_ANY_FOLDER. %s is the folder above it. */
struct name_case {
    const char *name, *mtllib;
};
static const struct name_case k_names[] = {
    {"name/above", "../tri.mtl"},
    {"name/above_by_detour", "x/../../tri.mtl"},
    {"name/absolute", "%s/tri.mtl"},
    {"name/link", "link.mtl"},
};

static int has_warning(const shd_scene *scene, const char *text)
{
    for (uint32_t i = 0; i < info_of(scene).warning_count; ++i) {
        if (strstr(shd_scene_get_warning(scene, i), text)) return 1;
    }
    return 0;
}

static void test_name(void **state)
{
    const struct name_case *c = *state;
    char name[512], text[1024];
    const char *percent = strstr(c->mtllib, "%s");
    snprintf(name, sizeof name, "%s%s", percent ? g_folder : c->mtllib, percent ? percent + 2 : "");
    snprintf(text, sizeof text, "mtllib %s\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", name);
    scene_write_text("inner/m.obj", text);
    unlink(io_path("inner/link.mtl"));
    assert_int_equal(symlink("../tri.mtl", io_path("inner/link.mtl")), 0);
    for (int allowed = 0; allowed < 2; ++allowed) {
        shd_scene *scene = NULL;
        shd_material_desc material = shd_material_desc_default();
        shd_scene_desc desc = shd_scene_desc_default();
        if (allowed) desc.flags = SHD_SCENE_ANY_FOLDER;
        assert_int_equal(mkdir(io_path("inner/x"), 0700), 0);
        shd_assert_ok(shd_scene_load(g_context, io_path("inner/m.obj"), &desc, &scene));
        rmdir(io_path("inner/x"));
        shd_assert_ok(shd_scene_get_material_desc(scene, 0, &material));
        assert_int_equal(material.diffuse[0] == 0.5f && material.diffuse[1] == 0.25f, allowed);
        assert_int_equal(has_warning(scene, "SHD_SCENE_ANY_FOLDER"), !allowed);
        shd_scene_release(scene);
    }
}

/* Seeds of mutants. Each is small, so that most bytes matter. */
static const char k_ply[] =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
static const char k_stl[] =
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid "
    "a\n";
struct seed {
    const char *name, *file, *text;
};
static const struct seed k_seeds[] = {
    {"mutants/gltf", "m.gltf", k_room_gltf},
    {"mutants/obj", "m.obj", k_triangle_obj},
    {"mutants/stl", "m.stl", k_stl},
    {"mutants/ply", "m.ply", k_ply},
};

static uint32_t g_random;
static uint32_t next_random(void) { return g_random = g_random * 1664525u + 1013904223u, g_random >> 8; }

/* Changes, removes and repeats bytes. */
static size_t mutate(const char *text, char *out)
{
    size_t size = strlen(text);
    memcpy(out, text, size);
    for (uint32_t k = next_random() % 4 + 1; k > 0 && size > 8; --k) {
        const size_t at = next_random() % size, length = next_random() % 8;
        switch (next_random() % 4) {
            case 0: out[at] = (char)next_random(); break;
            case 1: out[at] = "0123456789-e.\n{}"[next_random() % 16]; break;
            case 2:
                if (at + length < size) memmove(out + at, out + at + length, size - at - length), size -= length;
                break;
            default: memmove(out + at + length, out + at, size - at), size += length; break;
        }
    }
    return size;
}

/* The host lives, keeps its limit of time, and gets one answer for one file. SHD_TEST_MUTANTS sets their number. */
static void test_mutants(void **state)
{
    const struct seed *seed = *state;
    const char *count = getenv("SHD_TEST_MUTANTS");
    char *text = malloc(strlen(seed->text) + 64);
    struct lent lent = {.count = 0};
    shd_scene_desc desc = shd_scene_desc_default();
    desc.time_limit = 20;
    desc.max_reader_bytes = (uint64_t)1 << 28;
    desc.find = find_in_folder;
    desc.user_data = &lent;
    g_random = 1;
    for (int i = count ? atoi(count) : 12; i > 0; --i) {
        const size_t size = mutate(seed->text, text);
        uint64_t answers[2];
        for (int k = 0; k < 2; ++k) {
            shd_scene *scene = NULL;
            const double start = io_seconds();
            const shd_result result = shd_scene_load_memory(g_context, text, size, seed->file, &desc, &scene);
            assert_true(io_seconds() - start < desc.time_limit + 10);
            assert_true(result != SHD_ERROR_INTERNAL);
            answers[k] =
                result == SHD_OK ? hash_of(scene) : mix((uint64_t)result, shd_last_error(), strlen(shd_last_error()));
            shd_scene_release(scene);
            free_lent(&lent);
        }
        assert_true(answers[0] == answers[1]);
    }
    free(text);
}

int main(void)
{
    add("one_scene", test_one_scene, NULL);
    add("memory_alone", test_memory_alone, NULL);
    add("find_refuses", test_find_refuses, NULL);
    add("one_worker", test_one_worker, NULL);
    ADD_ROWS(k_names, test_name);
    ADD_ROWS(k_seeds, test_mutants);
    return _cmocka_run_group_tests("api.scene_worker", g_tests, g_count, set_up, tear_down);
}
