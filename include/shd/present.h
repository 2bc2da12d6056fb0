/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Finished tiles of a frame, for hosts that show or send a frame while it is drawn.
 *
 * A tile is passed to the host as soon as no draw changes it any more, while its colours are still in the caches of the
 * core that drew them. The host converts it to the pixels that it needs, so that linear colour does not travel through
 * memory. shd_color_render() of shd/color.h does so for the displays of a colour config.
 *
 * Thread safety: a callback runs on any worker of the executor, and calls for different tiles may be concurrent. It
 *                must not throw or longjmp. Floating-point control is the IEEE default while it runs.
 *
 * @code
 * static shd_result copy_red(const shd_present_tile *tile, void *user_data)
 * {
 *     float *image = user_data; // [height][WIDTH]
 *     uint32_t y;
 *     for (y = 0; y < tile->area.height; ++y) {
 *         memcpy(image + (size_t)(tile->area.y + y) * WIDTH + tile->area.x,
 *                (const char *)tile->channel[0] + y * tile->row_stride, sizeof *image * tile->area.width);
 *     }
 *     return SHD_OK;
 * }
 * desc.present.tile = copy_red, desc.present.user_data = image;
 * result = shd_render(context, &desc);
 * @endcode
 */
#ifndef SHD_PRESENT_H
#define SHD_PRESENT_H

#include <shd/image.h>
#include <shd/result.h>

SHD_BEGIN_DECLS

/**
 * Colour of a rectangle of the framebuffer: scene-linear, premultiplied by alpha, the average of the samples of each
 * pixel. Its bits are those that a framebuffer with color_format SHD_FORMAT_RGBA32F holds after the frame. Interleaved
 * formats round these values, so a tile is more precise than their pixels; only pixels that the frame leaves unchanged
 * (SHD_RENDER_LOAD, or outside the scissor) are decoded from the framebuffer.
 *
 * The struct goes from the library to the callback: struct_size is the size of the library's struct.
 */
typedef struct shd_present_tile {
    uint32_t struct_size;    /**< size of the library's struct */
    size_t worker;           /**< below shd_context_get_worker_count(); calls with one worker are never concurrent */
    shd_region area;         /**< pixels of the framebuffer, up to 64 x 64 */
    const float *channel[4]; /**< r, g, b and a: [height][row_stride / 4]; borrowed for the call */
    size_t row_stride;       /**< bytes between rows */
    /* ---- end of 0.1; append below ---- */
} shd_present_tile;

/** Host callback for finished tiles. Frozen. */
typedef struct shd_present {
    /**
     * Called once for each tile of the framebuffer in no particular order, also for tiles that the frame does not
     * change. In a frame of several passes (shd_render_desc.pass_triangles) this is in the last pass, and with
     * supersampling after the last block. A result other than SHD_OK, with its text from shd_report_error(), becomes
     * the result of the render; tiles that follow are skipped. NULL = none.
     */
    shd_result (*tile)(const shd_present_tile *tile, void *user_data);
    void *user_data; /**< borrowed for the call that takes the shd_present */
} shd_present;

SHD_END_DECLS

#endif /* SHD_PRESENT_H */
