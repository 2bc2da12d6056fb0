/* SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "record.h"
#ifdef EXAMPLE_HAS_IO
#include <shd/io.h>
#endif

struct process_memory process_memory(void)
{
    struct process_memory memory = {0, 0};
    char line[256];
    FILE *file = fopen("/proc/self/status", "r");
    if (!file) return memory;
    while (fgets(line, sizeof line, file)) {
        if (strncmp(line, "VmRSS:", 6) == 0) memory.resident = strtoull(line + 6, NULL, 10) << 10;
        if (strncmp(line, "VmHWM:", 6) == 0) memory.peak = strtoull(line + 6, NULL, 10) << 10;
    }
    fclose(file);
    return memory;
}

void record_header(FILE *out)
{
    fprintf(out,
            "frame,altitude_km,rss_bytes,peak_rss_bytes,resident_bytes,budget_bytes,loaded_tiles,evicted_tiles,"
            "requested_tiles,milliseconds\n");
}

void record_frame(FILE *out, uint32_t frame, float altitude, const shd_tile_cache_stats *stats, double milliseconds)
{
    const struct process_memory memory = process_memory();
    fprintf(out, "%u,%.1f,%llu,%llu,%llu,%llu,%llu,%llu,%u,%.1f\n", (unsigned)frame, 6371.0 * (double)altitude,
            (unsigned long long)memory.resident, (unsigned long long)memory.peak,
            (unsigned long long)stats->resident_tile_count * stats->tile_bytes, (unsigned long long)stats->budget_bytes,
            (unsigned long long)stats->loaded_tile_count, (unsigned long long)stats->evicted_tile_count,
            (unsigned)stats->requested_tile_count, milliseconds);
    fflush(out);
}

#ifdef EXAMPLE_HAS_IO
static shd_result save(const char *stem, const struct scene *scene, uint8_t *pixels)
{
    shd_image image = shd_image_default();
    char path[1024];
    snprintf(path, sizeof path, "%s.png", stem);
    image.format = SHD_FORMAT_RGBA8_SRGB;
    image.width = scene->width, image.height = scene->height;
    image.pixels = pixels;
    return shd_image_save(&image, path, NULL);
}
#else
static shd_result save(const char *stem, const struct scene *scene, uint8_t *pixels)
{
    const size_t count = (size_t)scene->width * scene->height;
    size_t i;
    int good;
    char path[1024];
    FILE *file;
    snprintf(path, sizeof path, "%s.ppm", stem);
    file = fopen(path, "wb");
    if (!file) return SHD_ERROR_IO;
    fprintf(file, "P6\n%u %u\n255\n", (unsigned)scene->width, (unsigned)scene->height);
    for (i = 0; i < count; ++i) fwrite(pixels + 4 * i, 1, 3, file);
    good = !ferror(file);
    return fclose(file) == 0 && good ? SHD_OK : SHD_ERROR_IO;
}
#endif

shd_result record_picture(const char *folder, uint32_t frame, const struct scene *scene, uint8_t *pixels)
{
    char stem[1000];
    snprintf(stem, sizeof stem, "%s/flyover-%04u", folder, (unsigned)frame);
    return save(stem, scene, pixels);
}
