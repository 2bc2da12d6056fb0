/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Columns: strided streams of one scalar, the form in which data enters and leaves shd.
 *
 * Element i lies i * stride bytes after `data`. Stride 0 means packed: the size of an element. One type therefore
 * serves separate arrays (stride 0) and interleaved records (stride = size of the record).
 *
 * `data` must be aligned to an element, the stride must be a multiple of its size, and count * stride must fit in
 * size_t. Columns are borrowed for the call. Functions take output columns by pointer, one or an array of them.
 *
 * The column types are frozen: they never get another field, so they may stand in arrays and inside other structs.
 *
 * Thread safety: any thread.
 *
 * @code
 * const float vertices[3][5]; // x, y, z, u, v
 * mesh.position[0] = shd_f32_column(&vertices[0][0], sizeof vertices[0]);
 * mesh.uv[0] = shd_f32_column(&vertices[0][3], sizeof vertices[0]);
 * texels.channel[0] = shd_f32_out_column(red, 0);
 * @endcode
 */
#ifndef SHD_COLUMN_H
#define SHD_COLUMN_H

#include <shd/base.h>

SHD_BEGIN_DECLS

/** Column of floats that shd reads. Frozen. */
typedef struct shd_f32_in {
    const float *data; /**< first element; NULL = the column is absent */
    size_t stride;     /**< bytes between elements; 0 = packed */
} shd_f32_in;

/** Column of floats that shd writes. Frozen. */
typedef struct shd_f32_out {
    float *data;   /**< first element; NULL = not wanted */
    size_t stride; /**< bytes between elements; 0 = packed */
} shd_f32_out;

/** Column of 32-bit unsigned integers that shd reads. Frozen. */
typedef struct shd_u32_in {
    const uint32_t *data; /**< first element; NULL = the column is absent */
    size_t stride;        /**< bytes between elements; 0 = packed */
} shd_u32_in;

/** Column of 32-bit unsigned integers that shd writes. Frozen. */
typedef struct shd_u32_out {
    uint32_t *data; /**< first element; NULL = not wanted */
    size_t stride;  /**< bytes between elements; 0 = packed */
} shd_u32_out;

/** Column of 16-bit unsigned integers that shd reads. Frozen. */
typedef struct shd_u16_in {
    const uint16_t *data; /**< first element; NULL = the column is absent */
    size_t stride;        /**< bytes between elements; 0 = packed */
} shd_u16_in;

/** Column of floats to read from `data` on, `stride` bytes apart; stride 0 = packed. */
static inline shd_f32_in shd_f32_column(const float *data, size_t stride)
{
    shd_f32_in column = SHD_ZERO_INIT;
    column.data = data;
    column.stride = stride;
    return column;
}

/** Column of floats to write from `data` on, `stride` bytes apart; stride 0 = packed. */
static inline shd_f32_out shd_f32_out_column(float *data, size_t stride)
{
    shd_f32_out column = SHD_ZERO_INIT;
    column.data = data;
    column.stride = stride;
    return column;
}

/** Column of 32-bit integers to read from `data` on, `stride` bytes apart; stride 0 = packed. */
static inline shd_u32_in shd_u32_column(const uint32_t *data, size_t stride)
{
    shd_u32_in column = SHD_ZERO_INIT;
    column.data = data;
    column.stride = stride;
    return column;
}

/** Column of 32-bit integers to write from `data` on, `stride` bytes apart; stride 0 = packed. */
static inline shd_u32_out shd_u32_out_column(uint32_t *data, size_t stride)
{
    shd_u32_out column = SHD_ZERO_INIT;
    column.data = data;
    column.stride = stride;
    return column;
}

/** Column of 16-bit integers to read from `data` on, `stride` bytes apart; stride 0 = packed. */
static inline shd_u16_in shd_u16_column(const uint16_t *data, size_t stride)
{
    shd_u16_in column = SHD_ZERO_INIT;
    column.data = data;
    column.stride = stride;
    return column;
}

SHD_END_DECLS

#endif /* SHD_COLUMN_H */
