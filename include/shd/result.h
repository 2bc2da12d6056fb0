/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Results of calls, and the text that explains a refusal.
 *
 * Thread safety: every function of this header may be called from any thread; each thread has its own error text.
 *
 * @code
 * shd_result result = shd_sampler_create(context, &desc, &sampler);
 * if (result != SHD_OK) fprintf(stderr, "%s: %s\n", shd_result_name(result), shd_last_error());
 * @endcode
 */
#ifndef SHD_RESULT_H
#define SHD_RESULT_H

#include <shd/base.h>

SHD_BEGIN_DECLS

/** Result of every call that can fail. A call that fails changes nothing. */
typedef enum shd_result {
    SHD_OK = 0,                     /**< done */
    SHD_ERROR_INVALID_ARGUMENT = 1, /**< the text names desc, field, value and range */
    SHD_ERROR_OUT_OF_MEMORY = 2,    /**< an allocation failed; nothing leaked, every object is as before */
    SHD_ERROR_UNSUPPORTED = 3,      /**< well formed, but this build or version does not offer it */
    SHD_ERROR_NOT_FOUND = 4,        /**< a file, colour space, display, view or plane does not exist */
    SHD_ERROR_IO = 5,               /**< reading or writing a file failed */
    SHD_ERROR_CORRUPT = 6,          /**< a file is damaged, or its content does not have the claimed format */
    SHD_ERROR_LIMIT = 7,            /**< a budget that the caller set (pixels, bytes, time) would be exceeded */
    SHD_ERROR_CANCELLED = 8,        /**< the host's progress callback requested cancellation */
    SHD_ERROR_CALLBACK = 9,         /**< a host callback reported failure */
    SHD_ERROR_INTERNAL = 10,        /**< a bug in shd or a library below it; please report the text */
    SHD_RESULT_MAX_ENUM = 0x7fffffff
} shd_result;

/**
 * Text of the latest failure on the calling thread, "" if none.
 *
 * UTF-8, one line, at most 1023 bytes. Borrowed: valid until the next call of shd on this thread that fails. Success
 * does not clear it.
 * @since 0.1
 */
SHD_API const char *shd_last_error(void);

/**
 * Name of a result as in the source, such as "SHD_ERROR_OUT_OF_MEMORY"; "SHD_RESULT_UNKNOWN" for other values.
 *
 * The string is static.
 * @since 0.1
 */
SHD_API const char *shd_result_name(shd_result result);

SHD_END_DECLS

#endif /* SHD_RESULT_H */
