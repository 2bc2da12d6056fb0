/* SPDX-License-Identifier: MIT */
/* shd_scene_load: results of small OBJ and glTF files, every refusal of the desc, handles that outlive their scene,
 * a frame of the draws and lights, allocations that fail, and the models of assimp if they are installed. */
#define _GNU_SOURCE
#include "support/fault_allocator.h"
#include "support/rows.h"
#include "support/scene_files.h"

#include <shd/shd.h>

#define BAD SHD_ERROR_INVALID_ARGUMENT

static shd_context *g_context;

static int set_up(void **state) { return scene_set_up(state, &g_context); }
static int tear_down(void **state) { return scene_tear_down(state, g_context); }

static shd_scene *load(const char *name)
{
    shd_scene *scene = NULL;
    shd_assert_ok(shd_scene_load(g_context, io_path(name), NULL, &scene));
    assert_non_null(scene);
    return scene;
}

static shd_scene_info info_of(const shd_scene *scene)
{
    shd_scene_info info = shd_scene_info_default();
    shd_assert_ok(shd_scene_get_info(scene, &info));
    return info;
}

static void assert_three(const char *what, const float *got, double x, double y, double z)
{
    shd_assert_close(what, 0, got[0], x, 1e-6, 1e-6);
    shd_assert_close(what, 1, got[1], y, 1e-6, 1e-6);
    shd_assert_close(what, 2, got[2], z, 1e-6, 1e-6);
}

/* The slot of a material for a target; NULL if there is none. */
static const shd_slot *slot_of(const shd_material_desc *material, shd_slot_target target)
{
    uint32_t i;
    for (i = 0; i < material->slot_count; ++i) {
        if (material->slots[i].target == target) return &material->slots[i];
    }
    return NULL;
}

/* Diffuse and specular maps are slots of the file; ambient light follows the diffuse map. */
static void test_obj_slots(void **state)
{
    shd_scene *scene = load("tri.obj");
    shd_material_desc material = shd_material_desc_default();
    const shd_slot *diffuse, *specular;
    shd_scene_instance instance = shd_scene_instance_default();
    (void)state;
    shd_assert_ok(shd_scene_get_instance(scene, 0, &instance));
    shd_assert_ok(shd_scene_get_material_desc(scene, instance.material, &material));
    assert_int_equal(material.slot_count, 2);
    diffuse = slot_of(&material, SHD_SLOT_DIFFUSE);
    specular = slot_of(&material, SHD_SLOT_SPECULAR);
    assert_true(diffuse && specular);
    assert_true(material.ambient_share == 1.0f);
    assert_int_equal(diffuse->source, SHD_SLOT_SOURCE_TEXTURE);
    assert_int_equal(diffuse->struct_size, sizeof *diffuse);
    assert_true(diffuse->texture && diffuse->sampler && specular->texture);
    assert_ptr_not_equal(diffuse->texture, specular->texture);
    shd_scene_release(scene);
}

static void test_obj(void **state)
{
    shd_scene *scene = load("tri.obj");
    const shd_scene_info info = info_of(scene);
    shd_material_desc material = shd_material_desc_default();
    shd_scene_instance instance = shd_scene_instance_default();
    float position[3][3], uv[2][3];
    int c, i;
    (void)state;
    assert_int_equal(info.mesh_count, 1);
    assert_int_equal(info.texture_count, 2);
    assert_int_equal(info.light_count + info.camera_count, 0);
    assert_int_equal(info.instance_count, 1);
    assert_int_equal(info.warning_count, 0);
    assert_int_equal(info.vertex_count, 3);
    assert_int_equal(info.triangle_count, 1);
    assert_three("low", info.bounds_min, 0, 0, 0);
    assert_three("high", info.bounds_max, 2, 1, 0);
    shd_assert_ok(shd_scene_get_instance(scene, 0, &instance));
    shd_assert_ok(shd_scene_get_material_desc(scene, instance.material, &material));
    assert_string_equal(shd_scene_get_name(scene, SHD_SCENE_PART_MATERIAL, instance.material), "red");
    assert_int_equal(material.model, SHD_MODEL_BLINN_PHONG);
    assert_three("diffuse", material.diffuse, 0.5, 0.25, 0.125);
    assert_three("ambient", material.ambient, -1, -1, -1);
    assert_three("specular", material.specular, 0.75, 0.5, 0.25);
    assert_three("emission", material.emission, 0.5, 0, 0);
    shd_assert_close("exponent", 0, material.exponent, 20, 0, 0);
    for (i = 0; i < 3; ++i) {
        for (c = 0; c < 3; ++c) {
            const shd_f32_out column[3] = {{position[0], 0}, {position[1], 0}, {position[2], 0}};
            if (c == 0 && i == 0) shd_assert_ok(shd_mesh_read_positions(shd_scene_get_mesh(scene, 0), column));
        }
    }
    {
        const shd_f32_out column[2] = {{uv[0], 0}, {uv[1], 0}};
        shd_assert_ok(shd_mesh_read_uv(shd_scene_get_mesh(scene, 0), column));
    }
    for (i = 0; i < 3; ++i) { /* v grows downwards: 0.75 in the file is 0.25 */
        shd_assert_close("v", (size_t)i, uv[1][i], position[1][i] == 1 ? 0.25 : 1, 0, 0);
        shd_assert_close("u", (size_t)i, uv[0][i], position[0][i] / 2, 0, 0);
    }
    assert_non_null(strstr(shd_scene_get_name(scene, SHD_SCENE_PART_TEXTURE, 0), ".png"));
    shd_scene_release(scene);
}

static void test_gltf_material(void **state)
{
    shd_scene *scene = load("room.gltf");
    shd_material_desc material = shd_material_desc_default();
    (void)state;
    shd_assert_ok(shd_scene_get_material_desc(scene, 0, &material));
    assert_string_equal(shd_scene_get_name(scene, SHD_SCENE_PART_MATERIAL, 0), "steel");
    assert_int_equal(material.model, SHD_MODEL_METALLIC_ROUGHNESS);
    assert_three("base colour", material.diffuse, 0.25, 0.5, 0.75);
    assert_three("emission", material.emission, 0, 0.5, 1);
    shd_assert_close("metallic", 0, material.metallic, 0.5, 0, 0);
    shd_assert_close("roughness", 0, material.roughness, 0.25, 0, 0);
    shd_assert_close("cutoff", 0, material.alpha_cutoff, 0.25, 0, 0);
    assert_true(material.flags & SHD_MATERIAL_DOUBLE_SIDED);
    assert_int_equal(material.struct_size, sizeof material);
    shd_scene_release(scene);
}

/* Two instances of one mesh, below a node that moves both. */
static void test_gltf_nodes(void **state)
{
    shd_scene *scene = load("room.gltf");
    const shd_scene_info info = info_of(scene);
    shd_scene_instance first = shd_scene_instance_default(), second = first;
    (void)state;
    assert_int_equal(info.mesh_count, 1);
    assert_int_equal(info.instance_count, 2);
    shd_assert_ok(shd_scene_get_instance(scene, 0, &first));
    shd_assert_ok(shd_scene_get_instance(scene, 1, &second));
    assert_int_equal(first.mesh, second.mesh);
    assert_three("scale", first.object_to_world, 2, 0, 0);
    assert_three("left", first.object_to_world + 12, 10, 0, 0);
    assert_three("right", second.object_to_world + 12, 10, 3, 0);
    assert_true(first.object_to_world[15] == 1);
    assert_three("low", info.bounds_min, 10, 0, 0);
    assert_three("high", info.bounds_max, 12, 4, 0);
    shd_scene_release(scene);
}

static void test_gltf_lights(void **state)
{
    shd_scene *scene = load("room.gltf");
    uint32_t i, seen = 0;
    (void)state;
    assert_int_equal(info_of(scene).light_count, 3);
    for (i = 0; i < 3; ++i) {
        shd_light_desc light = shd_light_desc_default();
        const char *name = shd_scene_get_name(scene, SHD_SCENE_PART_LIGHT, i);
        shd_assert_ok(shd_scene_get_light_desc(scene, i, &light));
        assert_non_null(shd_scene_get_light(scene, i));
        if (strcmp(name, "bulb") == 0) {
            assert_int_equal(light.kind, SHD_LIGHT_KIND_POINT);
            assert_three("bulb", light.intensity, 8, 4, 2);
            assert_three("bulb", light.position, 1, 2, 3);
            shd_assert_close("range", 0, light.range, 6, 0, 0);
            seen |= 1;
        } else if (strcmp(name, "sun") == 0) {
            assert_int_equal(light.kind, SHD_LIGHT_KIND_DIRECTIONAL);
            assert_three("sun", light.intensity, 3, 3, 3);
            assert_three("sun", light.direction, 0, -1, 0); /* -Z, turned a quarter about X */
            seen |= 2;
        } else {
            assert_int_equal(light.kind, SHD_LIGHT_KIND_SPOT);
            assert_three("lamp", light.position, 0, 4, 0);
            assert_three("lamp", light.direction, 0, 0, -1);
            shd_assert_close("inner", 0, light.inner_angle, 0.25, 1e-6, 0);
            shd_assert_close("outer", 0, light.outer_angle, 0.5, 1e-6, 0);
            seen |= 4;
        }
    }
    assert_int_equal(seen, 7);
    shd_scene_release(scene);
}

static void test_gltf_camera(void **state)
{
    shd_scene *scene = load("room.gltf");
    shd_camera camera = shd_camera_default();
    (void)state;
    assert_int_equal(info_of(scene).camera_count, 1);
    assert_string_equal(shd_scene_get_name(scene, SHD_SCENE_PART_CAMERA, 0), "eye");
    shd_assert_ok(shd_scene_get_camera(scene, 0, &camera));
    shd_assert_close("fov", 0, camera.fov_y, 0.75, 1e-5, 0);
    shd_assert_close("aspect", 0, camera.aspect, 2, 1e-6, 0);
    shd_assert_close("near", 0, camera.near_plane, 0.5, 0, 0);
    shd_assert_close("far", 0, camera.far_plane, 50, 0, 0);
    assert_three("eye", camera.eye, 0, 0, 5);
    assert_three("target", camera.target, 0, 0, 4);
    assert_three("up", camera.up, 0, 1, 0);
    shd_scene_release(scene);
}

/* If a texture is missing, its slot is left out, or the load fails if the flag is set. */
static void test_missing_texture(void **state)
{
    shd_scene_desc desc = shd_scene_desc_default();
    shd_scene *scene = NULL;
    (void)state;
    scene_write_text("bare.obj",
                     "mtllib bare.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl m\n"
                     "f 1/1 2/2 3/3\n");
    scene_write_text("bare.mtl", "newmtl m\nKd 1 1 1\nmap_Kd C:\\art\\Missing.png\nmap_Ks SKIN.PNG\n");
    scene = load("bare.obj");
    assert_int_equal(info_of(scene).warning_count, 1);
    assert_int_equal(info_of(scene).texture_count, 1); /* found in spite of the case of its letters */
    assert_non_null(strstr(shd_scene_get_warning(scene, 0), "Missing.png"));
    assert_null(shd_scene_get_warning(scene, 1));
    shd_scene_release(scene);
    desc.flags = SHD_SCENE_REQUIRE_TEXTURES;
    shd_assert_result("required", shd_scene_load(g_context, io_path("bare.obj"), &desc, &scene), SHD_ERROR_NOT_FOUND,
                      "Missing.png");
    assert_null(scene);
}

/* Colours of blended materials are premultiplied, but not if another slot or an opaque material reads the texture. */
static void test_blended_textures(void **state)
{
    static const uint8_t pixels[8] = {255, 128, 0, 255, 9, 9, 9, 100};
    static const char *const names[] = {"blended.png", "shared.png", "opaque.png"};
    shd_scene *scene;
    uint32_t i;
    (void)state;
    for (i = 0; i < 3; ++i) {
        shd_image image = shd_image_default();
        image.format = SHD_FORMAT_RGBA8_SRGB;
        image.width = 2, image.height = 1, image.pixels = (void *)pixels;
        shd_assert_ok(shd_image_save(&image, io_path(names[i]), NULL));
    }
    scene_write_text("blended.obj",
                     "mtllib blended.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl a\n"
                     "f 1/1 2/2 3/3\nusemtl b\nf 1/1 2/2 3/3\nusemtl c\nf 1/1 2/2 3/3\n");
    scene_write_text("blended.mtl",
                     "newmtl a\nd .5\nmap_Kd blended.png\nnewmtl b\nd .5\nmap_Kd shared.png\nmap_Ks shared.png\n"
                     "newmtl c\nmap_Kd opaque.png\n");
    scene = load("blended.obj");
    for (i = 0; i < info_of(scene).texture_count; ++i) {
        shd_texture_info info = shd_texture_info_default();
        const char *name = shd_scene_get_name(scene, SHD_SCENE_PART_TEXTURE, i);
        shd_assert_ok(shd_texture_get_info(shd_scene_get_texture(scene, i), &info));
        assert_int_equal(info.flags, strstr(name, "blended.png") ? SHD_TEXTURE_PREMULTIPLIED : SHD_TEXTURE_NONE);
    }
    assert_true(i >= 3);
    shd_scene_release(scene);
}

/* The draws and lights of a scene, in a frame; the mesh outlives the scene. */
static void test_render(void **state)
{
    shd_scene *scene = load("room.gltf");
    shd_framebuffer_desc made = shd_framebuffer_desc_default();
    shd_render_desc render = shd_render_desc_default();
    shd_camera camera = shd_camera_default();
    shd_render_stats stats = shd_render_stats_default();
    shd_framebuffer *framebuffer = NULL;
    shd_plane_view green = shd_plane_view_default();
    shd_mesh *mesh = shd_scene_get_mesh(scene, 0);
    shd_mesh_info info = shd_mesh_info_default();
    (void)state;
    made.width = 48;
    made.height = 32;
    shd_assert_ok(shd_framebuffer_create(g_context, &made, &framebuffer));
    render.clear_depth = 0.75f;
    shd_assert_ok(shd_scene_fill_render(scene, &render));
    assert_true(render.draw_count == 2 && render.light_count == 3 && render.clear_depth == 0.75f);
    render.clear_depth = 1;
    camera.eye[0] = camera.target[0] = 10.5f;
    camera.eye[1] = camera.target[1] = 0.5f;
    render.camera = &camera;
    render.framebuffer = framebuffer;
    render.stats = &stats;
    shd_assert_ok(shd_render(g_context, &render));
    assert_true(stats.triangle_count == 2 && stats.fragment_count > 100 && stats.nonfinite_fragment_count == 0);
    shd_assert_ok(shd_framebuffer_view_plane(framebuffer, SHD_PLANE_G, &green));
    assert_true(green.f32[16 * (green.row_stride / sizeof(float)) + 24] > 0);
    shd_mesh_retain(mesh);
    shd_scene_retain(scene);
    shd_scene_release(scene);
    assert_int_equal(info_of(scene).mesh_count, 1);
    shd_scene_release(scene);
    shd_assert_ok(shd_mesh_get_info(mesh, &info));
    assert_int_equal(info.triangle_count, 1);
    shd_mesh_release(mesh);
    shd_framebuffer_release(framebuffer);
}

/* Refusals. */

struct desc_case {
    const char *name;
    void (*edit)(shd_scene_desc *desc);
    shd_result result;
    const char *message;
};

static void edit_size(shd_scene_desc *d) { d->struct_size = 4; }
static void edit_flags(shd_scene_desc *d) { d->flags = 0x100; }
static void edit_mesh_flags(shd_scene_desc *d) { d->mesh_flags = 0x100; }
static void edit_vertices(shd_scene_desc *d) { d->max_vertices = 2; }
static void edit_nodes(shd_scene_desc *d) { d->max_nodes = 3; }
static void edit_instances(shd_scene_desc *d) { d->max_instances = 1; }
static void edit_many_instances(shd_scene_desc *d) { d->max_instances = ((uint64_t)1 << 20) + 1; }
static void edit_file_bytes(shd_scene_desc *d) { d->max_file_bytes = 100; }
static void edit_all_bytes(shd_scene_desc *d) { d->max_file_bytes = strlen(k_room_gltf) + 67; }
static void edit_time(shd_scene_desc *d) { d->time_limit = -1; }
static void edit_time_nan(shd_scene_desc *d) { d->time_limit = NAN; }
static void edit_time_short(shd_scene_desc *d) { d->time_limit = 1e-9; }
static void edit_sampler(shd_scene_desc *d)
{
    static shd_sampler_desc sampler;
    sampler = shd_sampler_desc_default();
    sampler.filter = (shd_filter)1000;
    d->sampler = &sampler;
}
static void edit_texture(shd_scene_desc *d)
{
    static shd_load_desc texture;
    texture = shd_load_desc_default();
    texture.struct_size = 4;
    d->texture = &texture;
}
static void edit_nothing(shd_scene_desc *d) { (void)d; }

static const struct desc_case k_descs[] = {
    {"desc/defaults", edit_nothing, SHD_OK, ""},
    {"desc/struct_size", edit_size, BAD, "scene.struct_size: 4"},
    {"desc/flags", edit_flags, SHD_ERROR_UNSUPPORTED, "scene.flags: bits 0x100"},
    {"desc/mesh_flags", edit_mesh_flags, SHD_ERROR_UNSUPPORTED, "scene.mesh_flags: bits 0x100"},
    {"desc/sampler", edit_sampler, BAD, "sampler.filter"},
    {"desc/texture", edit_texture, BAD, "scene.texture.struct_size: 4"},
    {"desc/time_negative", edit_time, BAD, "scene.time_limit: -1"},
    {"desc/time_nan", edit_time_nan, BAD, "scene.time_limit: "},
    {"desc/max_instances", edit_many_instances, BAD, "scene.max_instances: 1048577"},
    {"limit/time", edit_time_short, SHD_ERROR_LIMIT, "room.gltf\": loading took longer than scene.time_limit"},
    {"limit/vertices", edit_vertices, SHD_ERROR_LIMIT, "room.gltf\": 3 vertices are above scene.max_vertices 2"},
    {"limit/nodes", edit_nodes, SHD_ERROR_LIMIT, "nodes are above scene.max_nodes 3"},
    {"limit/instances", edit_instances, SHD_ERROR_LIMIT, "2 instances are above scene.max_instances 1"},
    {"limit/file", edit_file_bytes, SHD_ERROR_LIMIT, "above scene.max_file_bytes 100"},
    {"limit/files_together", edit_all_bytes, SHD_ERROR_LIMIT, "room.bin"},
};

static void test_desc(void **state)
{
    const struct desc_case *c = (const struct desc_case *)*state;
    shd_scene_desc desc = shd_scene_desc_default();
    shd_scene *scene = (shd_scene *)(void *)&desc;
    c->edit(&desc);
    shd_assert_result(c->name, shd_scene_load(g_context, io_path("room.gltf"), &desc, &scene), c->result, c->message);
    assert_true((scene != NULL) == (c->result == SHD_OK));
    shd_scene_release(scene);
}

static void test_texture_budget(void **state)
{
    shd_scene_desc desc = shd_scene_desc_default();
    shd_scene *scene = NULL;
    (void)state;
    desc.max_texture_bytes = 30; /* each has 16 bytes and a level of 4 */
    shd_assert_result("bytes", shd_scene_load(g_context, io_path("tri.obj"), &desc, &scene), SHD_ERROR_LIMIT,
                      "scene.max_texture_bytes 30");
}

static void test_null(void **state)
{
    shd_scene *scene = load("tri.obj"), *none = NULL;
    shd_scene_info info = shd_scene_info_default();
    shd_material_desc material = shd_material_desc_default();
    shd_light_desc light = shd_light_desc_default();
    shd_camera camera = shd_camera_default();
    shd_scene_instance instance = shd_scene_instance_default();
    shd_render_desc render = shd_render_desc_default();
    (void)state;
    shd_assert_result("context", shd_scene_load(NULL, "a.obj", NULL, &none), BAD, "context: NULL");
    shd_assert_result("path", shd_scene_load(g_context, NULL, NULL, &none), BAD, "path: NULL");
    shd_assert_result("path", shd_scene_load(g_context, "", NULL, &none), BAD, "path: empty");
    shd_assert_result("out", shd_scene_load(g_context, "a.obj", NULL, NULL), BAD, "out_scene: NULL");
    shd_assert_result("info", shd_scene_get_info(NULL, &info), BAD, "scene: NULL");
    assert_true(info.mesh_count == 0 && info.struct_size == sizeof info);
    shd_assert_result("info", shd_scene_get_info(scene, NULL), BAD, "info: NULL");
    info.struct_size = 4;
    shd_assert_result("info", shd_scene_get_info(scene, &info), BAD, "out_info.struct_size: 4");
    shd_assert_result("handle", shd_scene_fill_render((shd_scene *)(void *)shd_scene_get_mesh(scene, 0), &render), BAD,
                      "");
    shd_assert_result("material", shd_scene_get_material_desc(scene, 99, &material), SHD_ERROR_NOT_FOUND, "index: 99");
    shd_assert_result("light", shd_scene_get_light_desc(scene, 0, &light), SHD_ERROR_NOT_FOUND, "0 lights");
    shd_assert_result("camera", shd_scene_get_camera(scene, 0, &camera), SHD_ERROR_NOT_FOUND, "0 cameras");
    shd_assert_result("instance", shd_scene_get_instance(scene, 1, &instance), SHD_ERROR_NOT_FOUND, "1 instances");
    shd_assert_result("render", shd_scene_fill_render(scene, NULL), BAD, "render: NULL");
    render.struct_size = 16;
    shd_assert_result("render", shd_scene_fill_render(scene, &render), BAD, "render.struct_size: 16");
    assert_null(shd_scene_get_mesh(scene, 1));
    assert_null(shd_scene_get_mesh(NULL, 0));
    assert_null(shd_scene_get_material(scene, 77));
    assert_null(shd_scene_get_texture(scene, 2));
    assert_null(shd_scene_get_light(scene, 0));
    assert_null(shd_scene_get_warning(scene, 0));
    assert_null(shd_scene_get_name(scene, SHD_SCENE_PART_CAMERA, 0));
    assert_null(shd_scene_get_name(scene, (shd_scene_part)9, 0));
    shd_scene_retain(NULL);
    shd_scene_release(NULL);
    shd_scene_release(scene);
}

/* Every allocation of the context fails in turn: the result is OUT_OF_MEMORY and nothing leaks. */
static void test_faults(void **state)
{
    static const char *const k_files[] = {"tri.obj", "room.gltf"};
    size_t f, n;
    (void)state;
    for (f = 0; f < 2; ++f) {
        for (n = 1; n < 2000; ++n) {
            shd_fault_allocator allocator;
            shd_context_desc desc;
            shd_context *context = NULL;
            shd_scene *scene = NULL;
            shd_result result;
            memset(&allocator, 0, sizeof allocator);
            desc = shd_fault_context_desc(&allocator);
            shd_assert_ok(shd_context_create(&desc, &context));
            shd_fault_arm(&allocator, n, 0);
            result = shd_scene_load(context, io_path(k_files[f]), NULL, &scene);
            if (result != SHD_OK) {
                shd_assert_result(k_files[f], result, SHD_ERROR_OUT_OF_MEMORY, "");
                assert_null(scene);
            }
            shd_scene_release(scene);
            shd_context_release(context);
            shd_assert_all_freed(k_files[f], &allocator);
            if (allocator.calls < n) break;
        }
        assert_true(n > 10 && n < 2000);
    }
}

/* Models of assimp's own tests. */

struct model_case {
    const char *name;
    uint32_t meshes, textures;
};

static const struct model_case k_models[] = {
#if defined(SHD_HAS_ASSIMP)
    {"Collada/duck.dae", 1, 1},
    {"glTF/CesiumMilkTruck/CesiumMilkTruck.gltf", 0, 1},
#endif
    {"OBJ/spider.obj", 19, 5},
    {"glTF2/BoxTextured-glTF-Binary/BoxTextured.glb", 1, 1},
    {"glTF2/ClearCoat-glTF/ClearCoatTest.gltf", 0, 0},
    {"PLY/cube.ply", 1, 0},
    {"STL/Spider_ascii.stl", 1, 0},
#if defined(SHD_HAS_ASSIMP)
    {"3DS/fels.3ds", 0, 0},
    {"FBX/box.fbx", 0, 0},
#endif
};

static void test_model(void **state)
{
    const struct model_case *c = (const struct model_case *)*state;
    char path[256];
    shd_scene *scene = NULL;
    shd_scene_info info;
    uint32_t i;
    snprintf(path, sizeof path, "/usr/share/assimp/models/%s", c->name);
    if (access(path, R_OK) != 0) {
        print_message("%s is not installed (assimp-testmodels)\n", path);
        skip();
    }
    shd_assert_ok(shd_scene_load(g_context, path, NULL, &scene));
    info = info_of(scene);
    if (c->meshes) assert_int_equal(info.mesh_count, c->meshes);
    if (c->textures) assert_int_equal(info.texture_count, c->textures);
    assert_true(info.instance_count > 0 && info.triangle_count > 0 && info.vertex_count >= 3);
    for (i = 0; i < 3; ++i) assert_true(isfinite(info.bounds_min[i]) && info.bounds_min[i] <= info.bounds_max[i]);
    for (i = 0; i < info.camera_count; ++i) {
        shd_camera camera = shd_camera_default();
        shd_view view;
        shd_assert_ok(shd_scene_get_camera(scene, i, &camera));
        shd_assert_ok(shd_view_from_camera(&camera, &view));
    }
    shd_scene_release(scene);
}

int main(void)
{
    add("obj", test_obj, NULL);
    add("obj/slots", test_obj_slots, NULL);
    add("gltf/material", test_gltf_material, NULL);
    add("gltf/nodes", test_gltf_nodes, NULL);
    add("gltf/lights", test_gltf_lights, NULL);
    add("gltf/camera", test_gltf_camera, NULL);
    add("missing_texture", test_missing_texture, NULL);
    add("blended_textures", test_blended_textures, NULL);
    add("render", test_render, NULL);
    ADD_ROWS(k_descs, test_desc);
    add("limit/texture_bytes", test_texture_budget, NULL);
    add("null", test_null, NULL);
    add("faults", test_faults, NULL);
    ADD_ROWS(k_models, test_model);
    return _cmocka_run_group_tests("api.scene", g_tests, g_count, set_up, tear_down);
}
