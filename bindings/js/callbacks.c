// SPDX-License-Identifier: MIT
// Functions that C calls and JavaScript implements. Written by generate.py; do not edit.
// clang-format off
#include <shd/extension.h>
#include <shd/shd.h>

__attribute__((import_module("shd"), import_name("allocator_allocate")))
extern void * shd_js_allocator_allocate(void *user_data, size_t size, size_t alignment);
__attribute__((import_module("shd"), import_name("allocator_free")))
extern void shd_js_allocator_free(void *user_data, void *memory, size_t size, size_t alignment);
__attribute__((import_module("shd"), import_name("task_fn")))
extern void shd_js_task_fn(void *task_data, uint32_t index, uint32_t worker);
__attribute__((import_module("shd"), import_name("executor_parallel_for")))
extern shd_result shd_js_executor_parallel_for(void *user_data, uint32_t count, shd_task_fn task, void *task_data);
__attribute__((import_module("shd"), import_name("log_write")))
extern void shd_js_log_write(void *user_data, shd_log_level level, const char *message);
__attribute__((import_module("shd"), import_name("object_create_destroy")))
extern void shd_js_object_create_destroy(void *body);
__attribute__((import_module("shd"), import_name("fragment_fn")))
extern void shd_js_fragment_fn(const shd_fragments *in, shd_radiance *out, void *user_data);
__attribute__((import_module("shd"), import_name("display_apply")))
extern shd_result shd_js_display_apply(void *user_data, const shd_framebuffer *framebuffer, const shd_image *out);
__attribute__((import_module("shd"), import_name("trace_fn")))
extern void shd_js_trace_fn(const shd_rays *rays, uint32_t *blocked, void *user_data);
__attribute__((import_module("shd"), import_name("present_tile")))
extern shd_result shd_js_present_tile(void *user_data, const shd_present_tile *tile);
__attribute__((import_module("shd"), import_name("progress_report")))
extern int32_t shd_js_progress_report(void *user_data, float fraction);
__attribute__((import_module("shd"), import_name("slot_fn")))
extern void shd_js_slot_fn(const shd_fragments *in, float *const *out, void *user_data);
__attribute__((import_module("shd"), import_name("load_tiles_fn")))
extern shd_result shd_js_load_tiles_fn(void *user_data, const shd_tile *tiles, size_t count);
__attribute__((import_module("shd"), import_name("tile_source_release")))
extern void shd_js_tile_source_release(void *user_data);
__attribute__((import_module("shd"), import_name("vertex_fn")))
extern void shd_js_vertex_fn(const shd_vertices *in, shd_vertex_outputs *out, void *user_data);

/* The address of a function by its index in lib/api.js. */
__attribute__((export_name("shd_js_callback"))) void *shd_js_callback(uint32_t index)
{
    switch (index) {
    case 0: return (void *)shd_js_allocator_allocate;
    case 1: return (void *)shd_js_allocator_free;
    case 2: return (void *)shd_js_task_fn;
    case 3: return (void *)shd_js_executor_parallel_for;
    case 4: return (void *)shd_js_log_write;
    case 5: return (void *)shd_js_object_create_destroy;
    case 6: return (void *)shd_js_fragment_fn;
    case 7: return (void *)shd_js_display_apply;
    case 8: return (void *)shd_js_trace_fn;
    case 9: return (void *)shd_js_present_tile;
    case 10: return (void *)shd_js_progress_report;
    case 11: return (void *)shd_js_slot_fn;
    case 12: return (void *)shd_js_load_tiles_fn;
    case 13: return (void *)shd_js_tile_source_release;
    case 14: return (void *)shd_js_vertex_fn;
    default: return NULL;
    }
}
