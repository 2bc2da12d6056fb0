/* SPDX-License-Identifier: MIT */
/* Small model files: a triangle as OBJ, and a glTF with nodes, a camera, lights and a material. */
#ifndef SHD_TESTS_SUPPORT_SCENE_FILES_H
#define SHD_TESTS_SUPPORT_SCENE_FILES_H

#include "support/io_files.h"

#include <shd/scene.h>

static inline void scene_write_text(const char *name, const char *text) { io_write(io_path(name), text, strlen(text)); }

/* A grey PNG of 2 x 2, made by libshd_io. */
static inline void scene_write_png(const char *name)
{
    static const uint8_t k_pixels[16] = {128, 128, 128, 255, 128, 128, 128, 255,
                                         128, 128, 128, 255, 128, 128, 128, 255};
    shd_image image = shd_image_default();
    image.format = SHD_FORMAT_RGBA8_SRGB;
    image.width = image.height = 2;
    image.pixels = (void *)(uintptr_t)k_pixels;
    shd_assert_ok(shd_image_save(&image, io_path(name), NULL));
}

static const char k_triangle_obj[] =
    "mtllib tri.mtl\nv 0 0 0\nv 2 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 0.75\nvn 0 0 1\n"
    "o first\nusemtl red\nf 1/1/1 2/2/1 3/3/1\n";
static const char k_triangle_mtl[] =
    "newmtl red\nKd 0.5 0.25 0.125\nKs 0.75 0.5 0.25\nNs 20\nKe 0.5 0 0\nmap_Kd skin.png\nmap_Ks gloss.png\n";

static inline void scene_write_triangle(void)
{
    scene_write_text("tri.obj", k_triangle_obj);
    scene_write_text("tri.mtl", k_triangle_mtl);
    scene_write_png("skin.png");
    scene_write_png("gloss.png");
}

/* Positions of one triangle, (0, 0, 0), (1, 0, 0), (0, 1, 0), then its uv and indices: room.bin. */
static const float k_room_floats[15] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1};
static const uint16_t k_room_indices[4] = {0, 1, 2, 0};

#define ROOM_BUFFERS                                                                                                  \
    "\"buffers\":[{\"uri\":\"room.bin\",\"byteLength\":68}],"                                                         \
    "\"bufferViews\":[{\"buffer\":0,\"byteOffset\":0,\"byteLength\":36},"                                             \
    "{\"buffer\":0,\"byteOffset\":36,\"byteLength\":24},{\"buffer\":0,\"byteOffset\":60,\"byteLength\":6}],"          \
    "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\",\"min\":[0,0,0],"          \
    "\"max\":[1,1,0]},{\"bufferView\":1,\"componentType\":5126,\"count\":3,\"type\":\"VEC2\"},"                       \
    "{\"bufferView\":2,\"componentType\":5123,\"count\":3,\"type\":\"SCALAR\"}],"                                     \
    "\"meshes\":[{\"name\":\"wall\",\"primitives\":[{\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":1},\"indices\":2," \
    "\"material\":0}]}],"

static const char k_room_gltf[] =
    "{\"asset\":{\"version\":\"2.0\"},\"extensionsUsed\":[\"KHR_lights_punctual\"],"
    "\"extensions\":{\"KHR_lights_punctual\":{\"lights\":["
    "{\"type\":\"point\",\"name\":\"bulb\",\"color\":[1,0.5,0.25],\"intensity\":8,\"range\":6},"
    "{\"type\":\"directional\",\"name\":\"sun\",\"intensity\":3},"
    "{\"type\":\"spot\",\"name\":\"lamp\",\"intensity\":4,\"spot\":{\"innerConeAngle\":0.25,\"outerConeAngle\":0.5}}]}}"
    ","
    "\"scene\":0,\"scenes\":[{\"nodes\":[0,1,2,3,4]}],\"nodes\":["
    "{\"name\":\"parent\",\"translation\":[10,0,0],\"children\":[5,6]},"
    "{\"name\":\"eye\",\"camera\":0,\"translation\":[0,0,5]},"
    "{\"name\":\"bulb\",\"translation\":[1,2,3],\"extensions\":{\"KHR_lights_punctual\":{\"light\":0}}},"
    "{\"name\":\"sun\",\"rotation\":[-0.70710678,0,0,0.70710678],\"extensions\":{\"KHR_lights_punctual\":{\"light\":1}}"
    "},"
    "{\"name\":\"lamp\",\"translation\":[0,4,0],\"extensions\":{\"KHR_lights_punctual\":{\"light\":2}}},"
    "{\"name\":\"left\",\"mesh\":0,\"scale\":[2,2,2]},{\"name\":\"right\",\"mesh\":0,\"translation\":[0,3,0]}],"
    "\"cameras\":[{\"type\":\"perspective\",\"perspective\":{\"yfov\":0.75,\"aspectRatio\":2,\"znear\":0.5,\"zfar\":50}"
    "}],"
    "\"materials\":[{\"name\":\"steel\",\"doubleSided\":true,\"alphaMode\":\"MASK\",\"alphaCutoff\":0.25,"
    "\"emissiveFactor\":[0,0.5,1],\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.25,0.5,0.75,1],"
    "\"metallicFactor\":0.5,\"roughnessFactor\":0.25}}]," ROOM_BUFFERS "\"samplers\":[]}";

static inline void scene_write_room(void)
{
    unsigned char bytes[68];
    memcpy(bytes, k_room_floats, 60);
    memcpy(bytes + 60, k_room_indices, 8);
    io_write(io_path("room.bin"), bytes, sizeof bytes);
    scene_write_text("room.gltf", k_room_gltf);
}

/* The fixture of a test: a folder with these files, and a context. */
static inline int scene_set_up(void **state, shd_context **out_context)
{
    if (io_make_folder(state)) return -1;
    shd_assert_ok(shd_context_create(NULL, out_context));
    scene_write_triangle();
    scene_write_room();
    return 0;
}

static inline int scene_tear_down(void **state, shd_context *context)
{
    shd_context_release(context);
    return io_remove_folder(state);
}

#endif /* SHD_TESTS_SUPPORT_SCENE_FILES_H */
