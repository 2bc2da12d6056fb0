/* SPDX-License-Identifier: MIT */
/* Files of a fly-over: a line of figures for each frame, and pictures. */
#ifndef FLYOVER_RECORD_H
#define FLYOVER_RECORD_H

#include <stdio.h>

#include "scene.h"

/* Memory of the process in bytes, now and at its peak; 0 where /proc/self/status is absent. */
struct process_memory {
    uint64_t resident, peak;
};
struct process_memory process_memory(void);

/* Writes the names of the columns, or a line. */
void record_header(FILE *out);
void record_frame(FILE *out, uint32_t frame, float altitude, const shd_tile_cache_stats *stats, double milliseconds);

/* Writes FOLDER/flyover-NNNN.png, or .ppm without libshd_io. */
shd_result record_picture(const char *folder, uint32_t frame, const struct scene *scene, uint8_t *pixels);

#endif
