/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief The context: memory, tasks, log and SIMD target of everything created from it.
 *
 * shd keeps no global state but the per-thread error text. Two contexts share nothing.
 *
 * Lifetime:      reference counted; create returns an owned reference. Every object made from a context
 *                retains it, so the order of releases does not matter. A handle whose last reference is
 *                gone is refused with SHD_ERROR_INVALID_ARGUMENT while its context lives, until its place
 *                is given to a new handle: places never used go first, then the one free for longest.
 * Thread safety: retain/release and every function taking `const shd_context *` may run on any thread.
 */
#ifndef SHD_CONTEXT_H
#define SHD_CONTEXT_H

#include <shd/result.h>

SHD_BEGIN_DECLS

/** Owner of the allocator, executor and log that its objects use. */
typedef struct shd_context shd_context;

/**
 * Host memory. Both callbacks are set, or neither (then malloc and free). They run on any thread, the
 * executor's workers included, must not throw or longjmp and must not call shd.
 */
typedef struct shd_allocator {
    /** Memory of `size` > 0 bytes aligned to `alignment` (a power of two, at least 8), or NULL. */
    void *(*allocate)(void *user_data, size_t size, size_t alignment);
    /** Give back what allocate returned, with the same size and alignment; `memory` is never NULL. */
    void (*free)(void *user_data, void *memory, size_t size, size_t alignment);
    void *user_data; /**< passed to both; borrowed until release of the context */
} shd_allocator;

/** One task of a parallel_for: `index` in [0, count), `worker` in [0, worker_count). */
typedef void (*shd_task_fn)(void *task_data, uint32_t index, uint32_t worker);

/**
 * Host job system. Zero = the built-in executor: oneTBB if built in, else the calling thread; the latter too where no
 * thread may be started, and for a context that a forked child inherits.
 */
typedef struct shd_executor {
    /**
     * Run task(task_data, i, worker) once for every i in [0, count), in any order and on any threads, and
     * return when all are done. Two tasks that run at the same time must not share a `worker`. Returning
     * anything but SHD_OK makes the shd call fail with SHD_ERROR_CALLBACK. Runs on the thread that called
     * shd; must not throw or longjmp; may call shd.
     */
    shd_result (*parallel_for)(void *user_data, uint32_t count, shd_task_fn task, void *task_data);
    void *user_data;       /**< borrowed until release of the context */
    uint32_t worker_count; /**< bound of `worker`, 1..1024, for per-worker scratch */
    uint32_t reserved;     /**< 0 */
} shd_executor;

/** How much a log line matters. */
typedef enum shd_log_level {
    SHD_LOG_DEBUG = 0,
    SHD_LOG_INFO = 1,
    SHD_LOG_WARNING = 2,
    SHD_LOG_ERROR = 3,
    SHD_LOG_LEVEL_MAX_ENUM = 0x7fffffff
} shd_log_level;

/** Host log. Without one shd is silent: it never writes to stdout or stderr. */
typedef struct shd_log {
    /** One line without newline. Any thread, possibly several at once; must not throw, longjmp or call shd. */
    void (*write)(void *user_data, shd_log_level level, const char *message);
    void *user_data; /**< borrowed until release of the context */
} shd_log;

/**
 * Instruction set of the kernels. Every one gives the same bits. Which ones can be chosen depends on the build (CMake
 * option SHD_SIMD) and on the machine.
 */
typedef enum shd_simd {
    SHD_SIMD_BEST = 0,     /**< the fastest that this machine and build offer */
    SHD_SIMD_BASELINE = 1, /**< the lowest of this build: runs wherever the library runs */
    SHD_SIMD_SCALAR = 2,   /**< one lane or generic vectors; a baseline, so absent where another one is built */
    SHD_SIMD_SSE2 = 3,     /**< the baseline of x86-64 with a Highway after 1.0.3 */
    SHD_SIMD_SSSE3 = 4,    /**< in builds with SHD_SIMD=all */
    SHD_SIMD_SSE4 = 5,     /**< SSE4.2 */
    SHD_SIMD_AVX2 = 6,
    SHD_SIMD_AVX512 = 7, /**< AVX-512 F, BW, CD, DQ and VL */
    SHD_SIMD_NEON = 8,
    SHD_SIMD_WASM = 9,
    SHD_SIMD_MAX_ENUM = 0x7fffffff
} shd_simd;

/** Options of a context; zero is a good default for each. */
typedef struct shd_context_desc {
    uint32_t struct_size;    /**< set by shd_context_desc_default() */
    uint32_t worker_count;   /**< built-in executor: threads, 0..1024, at most one per core; 0 = one per
                                 core, 1 = calling thread */
    shd_simd simd;           /**< default SHD_SIMD_BEST; one that cannot run here is SHD_ERROR_UNSUPPORTED */
    uint32_t reserved;       /**< 0 */
    shd_allocator allocator; /**< default malloc/free, huge pages asked for from 8 MiB on */
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

/** Drop a reference; NULL is ignored. The last one, objects included, frees everything. Any thread. @since 0.1 */
SHD_API void shd_context_release(shd_context *context);

/** Name of the target the kernels of this context run on, such as "AVX2"; "" for a bad handle. Static. @since 0.1 */
SHD_API const char *shd_simd_target(const shd_context *context);

/** Number of workers of the executor, at least 1; 0 for a bad handle. @since 0.1 */
SHD_API uint32_t shd_context_worker_count(const shd_context *context);

SHD_END_DECLS

#endif /* SHD_CONTEXT_H */
