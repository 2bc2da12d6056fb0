/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Columns: strided streams of one scalar, the way data enters and leaves shd.
 *
 * Element i lies i * stride bytes after data; stride 0 means packed (sizeof the element). One type serves
 * separate arrays (stride 0) and interleaved records (stride = size of the record). A stride must be a
 * multiple of the element's size and data must be aligned to it; count * stride must fit in size_t.
 */
#ifndef SHD_COLUMN_H
#define SHD_COLUMN_H

#include <shd/base.h>

SHD_BEGIN_DECLS

/** Column of floats that shd reads; borrowed for the call. */
typedef struct shd_f32_in {
    const float *data; /**< first element; NULL = the column is absent */
    size_t stride;     /**< bytes between elements; 0 = packed */
} shd_f32_in;

/** Column of floats that shd writes; borrowed for the call. */
typedef struct shd_f32_out {
    float *data;   /**< first element; NULL = not wanted */
    size_t stride; /**< bytes between elements; 0 = packed */
} shd_f32_out;

/** Column of 32-bit unsigned integers that shd reads; borrowed for the call. */
typedef struct shd_u32_in {
    const uint32_t *data; /**< first element; NULL = the column is absent */
    size_t stride;        /**< bytes between elements; 0 = packed */
} shd_u32_in;

/** Column of 32-bit unsigned integers that shd writes; borrowed for the call. */
typedef struct shd_u32_out {
    uint32_t *data; /**< first element; NULL = not wanted */
    size_t stride;  /**< bytes between elements; 0 = packed */
} shd_u32_out;

SHD_END_DECLS

#endif /* SHD_COLUMN_H */
