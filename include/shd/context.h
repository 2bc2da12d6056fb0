/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief The context: memory, tasks, log and SIMD target of everything created from it.
 *
 * The only global state of shd is the error text of each thread, and tables of constants. Two contexts share nothing.
 *
 * Lifetime:      reference counted; create returns an owned reference. Every object retains its context, so objects
 *                may be released in any order. A handle whose last reference was released is refused with
 *                SHD_ERROR_INVALID_ARGUMENT while its context lives, until a new handle takes its place. New handles
 *                take places that were never used first, then the place that has been free for longest.
 * Thread safety: retain/release and every function taking `const shd_context *` may run on any thread.
 *
 * @code
 * shd_context_desc desc = shd_context_desc_default();
 * shd_context *context = NULL;
 * desc.worker_count = 1; // everything on the calling thread
 * if (shd_context_create(&desc, &context) != SHD_OK) fprintf(stderr, "%s\n", shd_last_error());
 * @endcode
 */
#ifndef SHD_CONTEXT_H
#define SHD_CONTEXT_H

#include <shd/result.h>

SHD_BEGIN_DECLS

/** Owner of the allocator, executor and log that its objects use. */
typedef struct shd_context shd_context;

/**
 * Host memory. Frozen.
 *
 * Set both callbacks or neither (then malloc and free). They run on any thread, workers of the executor included. They
 * must not throw, longjmp or call shd.
 */
typedef struct shd_allocator {
    /** Returns `size` > 0 bytes aligned to `alignment` (a power of two, at least 8), or NULL. */
    void *(*allocate)(size_t size, size_t alignment, void *user_data);
    /**
     * Frees memory that `allocate` returned. `size` and `alignment` are those of its allocation; `memory` is never
     * NULL.
     */
    void (*free)(void *memory, size_t size, size_t alignment, void *user_data);
    void *user_data; /**< passed to both; borrowed until release of the context */
} shd_allocator;

/** One task of a parallel_for: `index` in [0, count), `worker` in [0, worker_count). */
typedef void (*shd_task_fn)(size_t index, size_t worker, void *task_data);

/**
 * Host job system. Frozen.
 *
 * Zero = the built-in executor: oneTBB if the library was built with it, else the calling thread. The built-in executor
 * also uses the calling thread if no thread can be started, in contexts that a child process inherits by fork(), and in
 * all contexts of a child whose parent has used oneTBB.
 */
typedef struct shd_executor {
    /**
     * Runs task(i, worker, task_data) once for every i in [0, count), in any order and on any threads, and returns when
     * all are done. Tasks that run concurrently must have different values of `worker`. A result other than SHD_OK
     * makes the call of shd fail with SHD_ERROR_CALLBACK. Runs on the thread that called shd; must not throw or
     * longjmp; may call shd.
     */
    shd_result (*parallel_for)(size_t count, shd_task_fn task, void *task_data, void *user_data);
    void *user_data; /**< borrowed until release of the context */
    /** `worker` is below this number, 1..1024; scratch memory is allocated for this number of workers. */
    size_t worker_count;
} shd_executor;

/** Severity of a line of the log. */
typedef enum shd_log_level {
    SHD_LOG_LEVEL_DEBUG = 0,
    SHD_LOG_LEVEL_INFO = 1,
    SHD_LOG_LEVEL_WARNING = 2,
    SHD_LOG_LEVEL_ERROR = 3,
    SHD_LOG_LEVEL_MAX_ENUM = 0x7fffffff
} shd_log_level;

/** Host log. Frozen. Without a log shd writes nothing: it never uses stdout or stderr. */
typedef struct shd_log {
    /** Takes one line without newline. Any thread, calls may be concurrent; must not throw, longjmp or call shd. */
    void (*write)(shd_log_level level, const char *message, void *user_data);
    void *user_data; /**< borrowed until release of the context */
} shd_log;

/**
 * Instruction set of the kernels. All give the same bits.
 *
 * The build (CMake option SHD_SIMD) and the machine decide which ones can be chosen.
 */
typedef enum shd_simd {
    SHD_SIMD_BEST = 0,     /**< the fastest one of this machine and build */
    SHD_SIMD_BASELINE = 1, /**< the lowest one of this build: runs wherever the library runs */
    SHD_SIMD_SCALAR = 2,   /**< one lane or generic vectors; only in builds whose baseline it is */
    SHD_SIMD_SSE2 = 3,     /**< the baseline of x86-64 with a Highway after 1.0.3 */
    SHD_SIMD_SSSE3 = 4,    /**< in builds with SHD_SIMD=all */
    SHD_SIMD_SSE4 = 5,     /**< SSE4.2 */
    SHD_SIMD_AVX2 = 6,
    SHD_SIMD_AVX512 = 7, /**< AVX-512 F, BW, CD, DQ and VL */
    SHD_SIMD_NEON = 8,
    SHD_SIMD_WASM = 9,
    SHD_SIMD_MAX_ENUM = 0x7fffffff
} shd_simd;

/** Options of a context; combine with |. */
typedef enum shd_context_flag {
    SHD_CONTEXT_NONE = 0,
    /**
     * Working memory of a call is allocated and freed block by block. Without this flag the context keeps it for the
     * next call, so that a loop of equal frames allocates nothing after each worker has drawn a part of a frame, with
     * one worker after the first frame; see shd_context_trim().
     */
    SHD_CONTEXT_RETURN_MEMORY = 1,
    SHD_CONTEXT_FLAG_MAX_ENUM = 0x7fffffff
} shd_context_flag;
typedef uint32_t shd_context_flags; /**< shd_context_flag bits */

/** Options of a context. Zero is the default of each. */
typedef struct shd_context_desc {
    uint32_t struct_size;    /**< set by shd_context_desc_default() */
    shd_context_flags flags; /**< default 0 */
    /**
     * Threads of the built-in executor, 0..1024, at most one per core; 1 = calling thread; default 0 = one per core.
     */
    size_t worker_count;
    shd_simd simd;           /**< default SHD_SIMD_BEST; SHD_ERROR_UNSUPPORTED if it cannot run here */
    shd_allocator allocator; /**< default malloc and free; huge pages are requested for blocks of 8 MiB and more */
    shd_executor executor;   /**< default built-in */
    shd_log log;             /**< default none */
    /* ---- end of 0.1; append below ---- */
} shd_context_desc;

/** Defaults, compiled into the caller so that struct_size is the caller's. */
static inline shd_context_desc shd_context_desc_default(void)
{
    shd_context_desc desc = SHD_ZERO_INIT;
    desc.struct_size = (uint32_t)sizeof desc;
    return desc;
}

/**
 * Make a context.
 * @param desc         options, borrowed for the call; NULL = all defaults
 * @param out_context  owned; NULL on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_context_create(const shd_context_desc *desc, shd_context **out_context);

/** Add a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_context_retain(shd_context *context);

/**
 * Drop a reference; NULL is ignored. Objects hold references too; the last release frees everything. Any thread.
 * @since 0.1
 */
SHD_API void shd_context_release(shd_context *context);

/**
 * Return the working memory that the context keeps between calls to the allocator. Calls that run at the same time
 * keep theirs. NULL is ignored. Any thread.
 * @since 0.1
 */
SHD_API void shd_context_trim(shd_context *context);

/** Name of the SIMD target of the context's kernels, such as "AVX2"; "" for a bad handle. Static. @since 0.1 */
SHD_API const char *shd_context_get_simd_target(const shd_context *context);

/** Number of workers of the executor, at least 1; 0 for a bad handle. @since 0.1 */
SHD_API size_t shd_context_get_worker_count(const shd_context *context);

SHD_END_DECLS

#endif /* SHD_CONTEXT_H */
