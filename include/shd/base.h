/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Linkage, version and the macros that every header of shd uses.
 *
 * Thread safety: every function of this header may be called from any thread.
 *
 * @code
 * if (shd_version() >> 16 != SHD_VERSION_MAJOR) fprintf(stderr, "the library has another major version\n");
 * @endcode
 */
#ifndef SHD_BASE_H
#define SHD_BASE_H

#include <stddef.h>
#include <stdint.h>

#define SHD_VERSION_MAJOR 0
#define SHD_VERSION_MINOR 1
#define SHD_VERSION_PATCH 0

#ifdef __cplusplus
#define SHD_BEGIN_DECLS extern "C" {
#define SHD_END_DECLS }
#define SHD_ZERO_INIT \
    {                 \
    }
#else
#define SHD_BEGIN_DECLS
#define SHD_END_DECLS
#define SHD_ZERO_INIT \
    {                 \
        0             \
    }
#endif

/* Define SHD_STATIC when linking the static libraries on Windows. */
#if defined(_WIN32) && !defined(SHD_STATIC)
#ifdef SHD_BUILDING
#define SHD_API __declspec(dllexport)
#else
#define SHD_API __declspec(dllimport)
#endif
#elif defined(__GNUC__)
#define SHD_API __attribute__((visibility("default")))
#else
#define SHD_API
#endif

/* The compiler warns about a result that is not used. */
#if defined(__GNUC__)
#define SHD_NODISCARD __attribute__((warn_unused_result))
#elif defined(_MSC_VER)
#define SHD_NODISCARD _Check_return_
#else
#define SHD_NODISCARD
#endif

SHD_BEGIN_DECLS

/**
 * Version of the library that is running: major << 16 | minor << 8 | patch.
 *
 * It may differ from SHD_VERSION_*, which is the version of the headers.
 * @since 0.1
 */
SHD_API uint32_t shd_version(void);

SHD_END_DECLS

#endif /* SHD_BASE_H */
