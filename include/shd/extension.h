/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Extensions: handles, errors, memory and tasks for libraries built on shd, such as libshd_color, libshd_io,
 *        libshd_scene and libshd_embree.
 *
 * First calls: shd_object_create(), shd_object_get_body(), shd_report_error() and shd_context_parallel_for().
 *
 * Objects of such libraries have the same guarantees as objects of libshd.
 *
 * Thread safety: any thread.
 *
 * @code
 * result = shd_object_create(context, 'N' << 24 | 'O' << 16 | 'I' << 8 | 'S', body, destroy_body, &object);
 * body = shd_object_get_body(object, 'N' << 24 | 'O' << 16 | 'I' << 8 | 'S'); // NULL for any other handle
 * @endcode
 */
#ifndef SHD_EXTENSION_H
#define SHD_EXTENSION_H

#include <shd/context.h>
#include <shd/framebuffer.h>

SHD_BEGIN_DECLS

/**
 * Store `message` as the calling thread's shd_last_error() and return `result`.
 *
 * The message is copied and cut at 1023 bytes. It is not a format string.
 * @since 0.1
 */
SHD_API shd_result shd_report_error(shd_result result, const char *message);

/**
 * Allocate from the context's allocator.
 * @return NULL if the allocator fails, size is 0, alignment is not a power of two (0 counts as 8) or the handle is bad
 * @since 0.1
 */
SHD_API void *shd_context_allocate(shd_context *context, size_t size, size_t alignment);

/** Free memory with the size and alignment of its allocation; NULL is ignored. @since 0.1 */
SHD_API void shd_context_free(shd_context *context, void *memory, size_t size, size_t alignment);

/** Write a line to the context's log. @since 0.1 */
SHD_API void shd_context_log(shd_context *context, shd_log_level level, const char *message);

/** Run tasks on the context's executor, with IEEE default floating-point control. @since 0.1 */
SHD_NODISCARD SHD_API shd_result shd_context_parallel_for(shd_context *context, size_t count, shd_task_fn task,
                                                          void *task_data);

/** A handle of the extension's own type. */
typedef struct shd_object shd_object;

/**
 * Make a handle in the context's slabs, with one owned reference.
 * @param type        four characters that name the type, such as 'COLR', packed big-endian; above 0xffff
 * @param body        the object behind the handle
 * @param destroy     called with `body` by the thread that releases the last reference; must not throw
 * @param out_object  owned; NULL on failure, and then `destroy` is not called
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_object_create(shd_context *context, uint32_t type, void *body,
                                                   void (*destroy)(void *body), shd_object **out_object);

/** Body of a live handle of that type; NULL, with the error text set, for any other pointer value. @since 0.1 */
SHD_API void *shd_object_get_body(const shd_object *object, uint32_t type);

/** Context of a handle; borrowed; NULL for a bad handle. @since 0.1 */
SHD_API shd_context *shd_object_get_context(const shd_object *object);

/** Context of a framebuffer; borrowed; NULL for a bad handle. @since 0.1 */
SHD_API shd_context *shd_framebuffer_get_context(const shd_framebuffer *framebuffer);

/** Add a reference; NULL is ignored. @since 0.1 */
SHD_API void shd_object_retain(shd_object *object, uint32_t type);

/** Drop a reference; NULL is ignored. @since 0.1 */
SHD_API void shd_object_release(shd_object *object, uint32_t type);

SHD_END_DECLS

#endif /* SHD_EXTENSION_H */
