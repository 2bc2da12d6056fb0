/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief libshd_io: work on untrusted bytes in a child of the worker, for libraries built on shd, such as libshd_scene.
 *
 * A process has one worker, the program shd-io-worker of shd/io.h. It opens a module, which is a shared object with the
 * function shd_worker_entry(), once, and calls that function in a fresh child of each run. The child has a limit of
 * memory and of time, and opens no file: the host opens files for it by their names. Its crash is SHD_ERROR_CORRUPT in
 * the host and names the signal. The host treats every byte of the reply as untrusted.
 *
 * Linux alone has a worker: elsewhere shd_worker_run() is SHD_ERROR_UNSUPPORTED.
 *
 * Thread safety: any thread.
 *
 * @code
 * char module[4096];
 * shd_worker_task task = {0};
 * result = shd_worker_find_module("libshd_scene_reader.so", module, sizeof module);
 * task.module = module, task.request = &request, task.request_size = sizeof request;
 * task.receive = read_reply, task.user_data = &reply; // read_reply() calls shd_worker_read()
 * result = shd_worker_run(&task);
 * @endcode
 */
#ifndef SHD_WORKER_H
#define SHD_WORKER_H

#include <shd/io.h>

SHD_BEGIN_DECLS

/** A file for the child: an open regular file, which it reads from the start, or bytes. Frozen. */
typedef struct shd_worker_file {
    int64_t descriptor; /**< owned, shd_worker_run() closes it; default -1 = `bytes` */
    const void *bytes;  /**< borrowed until the next call of `find`, or the end of the run */
    uint64_t size;      /**< [bytes] */
} shd_worker_file;

/** The reply of a child, while it arrives. */
typedef struct shd_worker_stream shd_worker_stream;

/**
 * Work for a child; zero is the default of each field. Callbacks run on the thread of shd_worker_run(); they must not
 * throw or longjmp. Frozen.
 */
typedef struct shd_worker_task {
    const char *module;      /**< absolute path of the module, below 1024 bytes; borrowed for the call */
    const char *worker_path; /**< as in shd_load_desc; default NULL; borrowed for the call */
    const void *request;     /**< bytes for the module; borrowed for the call */
    size_t request_size;     /**< 0..1024 [bytes] */
    uint64_t max_bytes;      /**< memory of the child; 0 = 2^32 [bytes] */
    double time_limit;       /**< 0 = 60 [s] */
    /**
     * Answers a question of the child, at most 65536 in a run. `name` has below 4096 untrusted bytes. SHD_OK answers
     * with `out_file`, SHD_ERROR_NOT_FOUND means that there is no such file, and any other result ends the run
     * with this result and the text of shd_last_error(). NULL = no files.
     */
    shd_result (*find)(const char *name, shd_worker_file *out_file, void *user_data);
    /** Reads the reply by shd_worker_read(). A result other than SHD_OK ends the run. */
    shd_result (*receive)(shd_worker_stream *reply, void *user_data);
    void *user_data; /**< last argument of the callbacks */
} shd_worker_task;

/**
 * Run the module in a child of the worker.
 * @return the result of the module with its message, the result of a callback, SHD_ERROR_CORRUPT if the child dies or
 *         replies more or less than `receive` reads, SHD_ERROR_LIMIT after time_limit
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_worker_run(const shd_worker_task *task);

/**
 * Read the next `size` bytes of the reply, and answer questions of the child meanwhile. Only in `receive`.
 * @param bytes  [size]
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_worker_read(shd_worker_stream *reply, void *bytes, size_t size);

/**
 * Path of a module of shd: in the folder shd beside libshd_io, beside libshd_io, or beside shd-io-worker.
 * @param file      name of the file, without folders
 * @param out_path  [size], an absolute path; "" on failure
 * @return SHD_ERROR_NOT_FOUND if there is no such file
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_worker_find_module(const char *file, char *out_path, size_t size);

/** Input of a module in the child. All pointers are valid until the process ends. Frozen. */
typedef struct shd_worker_call {
    const void *request; /**< request of shd_worker_task */
    size_t request_size; /**< [bytes] */
    /** The whole file `name`. SHD_ERROR_NOT_FOUND if the host has none. Its bytes stay until the process ends. */
    shd_result (*find)(const char *name, const void **out_bytes, size_t *out_size);
    /** Sends bytes of the reply. They must stay unchanged until the process ends: large ones are not copied. */
    void (*send)(const void *bytes, size_t size);
    char *message;       /**< [message_size], for a result other than SHD_OK */
    size_t message_size; /**< [bytes] */
} shd_worker_call;

/**
 * The function of a module, which each module defines and exports. It runs once in its process, which ends after it.
 * @since 0.1
 */
typedef shd_result (*shd_worker_entry_fn)(const shd_worker_call *call);

SHD_END_DECLS

#endif /* SHD_WORKER_H */
