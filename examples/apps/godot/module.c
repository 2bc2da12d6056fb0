/* SPDX-License-Identifier: MIT */
/*
 * A NativeScript class for Godot 3, ShdView: frames of shd as pixels for an Image.
 *
 *   open(width, height) -> String             "" or the text of the error
 *   draw(frame) -> PoolByteArray              width * height RGBA8 pixels; empty after an error
 *
 * The library writes the pixels straight into Godot's array.
 */
#include <stdbool.h>
#include <stddef.h>

#include <gdnative_api_struct.gen.h>

#include "scene.h"

/* All other symbols are hidden, so that they do not meet those of other modules. */
#if defined(_WIN32)
#define MODULE_EXPORT __declspec(dllexport)
#else
#define MODULE_EXPORT __attribute__((visibility("default")))
#endif

static const godot_gdnative_core_api_struct *s_api;
static const godot_gdnative_ext_nativescript_api_struct *s_nativescript;

static void *view_create(godot_object *object, void *data)
{
    struct scene *scene = s_api->godot_alloc((int)sizeof *scene);
    static const struct scene closed;
    (void)object, (void)data;
    if (scene) *scene = closed;
    return scene;
}

static void view_destroy(godot_object *object, void *data, void *user_data)
{
    struct scene *scene = user_data;
    (void)object, (void)data;
    if (!scene) return;
    scene_close(scene);
    s_api->godot_free(scene);
}

/* The arguments as integers; false if there are others, or of another type. */
static bool read_ints(int count, godot_variant **arguments, int expected, int64_t *out)
{
    int i;
    if (count != expected) return false;
    for (i = 0; i < count; ++i) {
        if (s_api->godot_variant_get_type(arguments[i]) != GODOT_VARIANT_TYPE_INT) return false;
        out[i] = s_api->godot_variant_as_int(arguments[i]);
    }
    return true;
}

static godot_variant text_variant(const char *text)
{
    godot_variant variant;
    godot_string string;
    s_api->godot_string_new(&string);
    s_api->godot_string_parse_utf8(&string, text);
    s_api->godot_variant_new_string(&variant, &string);
    s_api->godot_string_destroy(&string);
    return variant;
}

static godot_variant view_open(godot_object *object, void *data, void *user_data, int count, godot_variant **arguments)
{
    struct scene *scene = user_data;
    int64_t size[2];
    (void)object, (void)data;
    if (!scene) return text_variant("ShdView.open: out of memory");
    if (!read_ints(count, arguments, 2, size)) return text_variant("ShdView.open: two integers, width and height");
    if (size[0] < 1 || size[0] > 16384 || size[1] < 1 || size[1] > 16384) {
        return text_variant("ShdView.open: width and height are in 1..16384");
    }
    scene_close(scene);
    return text_variant(scene_open(scene, (uint32_t)size[0], (uint32_t)size[1]) == SHD_OK ? "" : shd_last_error());
}

/* Draws a frame into an array; returns the text of the error, or NULL. */
static const char *draw_into(struct scene *scene, int count, godot_variant **arguments, godot_pool_byte_array *bytes)
{
    godot_pool_byte_array_write_access *access;
    shd_result result;
    int64_t frame;
    if (!scene || !scene->context) return "ShdView.draw: the view is not open";
    if (!read_ints(count, arguments, 1, &frame)) return "ShdView.draw: one integer, the number of the frame";
    if (frame < 0 || frame > 1000000) return "ShdView.draw: the number of the frame is in 0..1000000";
    s_api->godot_pool_byte_array_resize(bytes, (godot_int)(scene->width * scene->height * 4));
    access = s_api->godot_pool_byte_array_write(bytes);
    result = scene_draw(scene, (int)frame, s_api->godot_pool_byte_array_write_access_ptr(access));
    s_api->godot_pool_byte_array_write_access_destroy(access);
    return result == SHD_OK ? NULL : shd_last_error();
}

static godot_variant view_draw(godot_object *object, void *data, void *user_data, int count, godot_variant **arguments)
{
    godot_variant variant;
    godot_pool_byte_array bytes;
    const char *problem;
    (void)object, (void)data;
    s_api->godot_pool_byte_array_new(&bytes);
    problem = draw_into(user_data, count, arguments, &bytes);
    if (problem) {
        s_api->godot_pool_byte_array_resize(&bytes, 0);
        s_api->godot_print_error(problem, __func__, __FILE__, __LINE__);
    }
    s_api->godot_variant_new_pool_byte_array(&variant, &bytes);
    s_api->godot_pool_byte_array_destroy(&bytes);
    return variant;
}

MODULE_EXPORT void godot_gdnative_init(godot_gdnative_init_options *options)
{
    unsigned i;
    s_api = options->api_struct;
    for (i = 0; i < s_api->num_extensions; ++i) {
        if (s_api->extensions[i]->type == GDNATIVE_EXT_NATIVESCRIPT) {
            s_nativescript = (const godot_gdnative_ext_nativescript_api_struct *)(const void *)s_api->extensions[i];
        }
    }
}

MODULE_EXPORT void godot_gdnative_terminate(godot_gdnative_terminate_options *options)
{
    (void)options;
    s_api = NULL;
    s_nativescript = NULL;
}

MODULE_EXPORT void godot_nativescript_init(void *handle)
{
    const godot_instance_create_func create = {view_create, NULL, NULL};
    const godot_instance_destroy_func destroy = {view_destroy, NULL, NULL};
    const godot_method_attributes attributes = {GODOT_METHOD_RPC_MODE_DISABLED};
    const godot_instance_method open = {view_open, NULL, NULL}, draw = {view_draw, NULL, NULL};
    if (!s_nativescript) return;
    s_nativescript->godot_nativescript_register_class(handle, "ShdView", "Reference", create, destroy);
    s_nativescript->godot_nativescript_register_method(handle, "ShdView", "open", attributes, open);
    s_nativescript->godot_nativescript_register_method(handle, "ShdView", "draw", attributes, draw);
}
