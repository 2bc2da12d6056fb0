/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief What a call answers, and the text that explains a refusal.
 *
 * Thread safety: every function here may be called from any thread; the error text is per thread.
 */
#ifndef SHD_RESULT_H
#define SHD_RESULT_H

#include <shd/base.h>

SHD_BEGIN_DECLS

/** Answer of every call that can fail. A call that fails changes nothing. */
typedef enum shd_result {
    SHD_OK = 0,                     /**< done */
    SHD_ERROR_INVALID_ARGUMENT = 1, /**< the text names desc, field, value and range */
    SHD_ERROR_OUT_OF_MEMORY = 2,    /**< an allocation failed; nothing leaked, every object as before */
    SHD_ERROR_UNSUPPORTED = 3,      /**< well formed, but this build or version does not offer it */
    SHD_ERROR_NOT_FOUND = 4,        /**< a file, colour space, display or view does not exist */
    SHD_ERROR_IO = 5,               /**< reading or writing a file failed */
    SHD_ERROR_CORRUPT = 6,          /**< a file is damaged or not what it claims to be */
    SHD_ERROR_LIMIT = 7,            /**< a budget the caller set (pixels, bytes, time) would be exceeded */
    SHD_ERROR_CANCELLED = 8,        /**< the host's progress callback asked to stop */
    SHD_ERROR_CALLBACK = 9,         /**< a host callback reported failure */
    SHD_ERROR_INTERNAL = 10,        /**< a bug in shd or a library below it; please report the text */
    SHD_RESULT_MAX_ENUM = 0x7fffffff
} shd_result;

/**
 * Text of the latest failure on the calling thread, "" if none. UTF-8, one line, at most 1023 bytes.
 * Borrowed: valid until the next shd call on this thread that fails. Success does not clear it.
 * @since 0.1
 */
SHD_API const char *shd_last_error(void);

/**
 * Name of a result, as in the source: "SHD_ERROR_OUT_OF_MEMORY"; "SHD_RESULT_UNKNOWN" for other values.
 * The string is static.
 * @since 0.1
 */
SHD_API const char *shd_result_name(shd_result result);

SHD_END_DECLS

#endif /* SHD_RESULT_H */
