/* SPDX-License-Identifier: MIT */
/* A flight over a planet whose texture has 1 TiB, with 256 MiB for its tiles. Without --check it writes flyover.csv,
   one line for each frame, and some of the frames as pictures; docs/draw_flyover.py draws the memory of the flight. */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "record.h"
#include "stream.h"

struct options {
    uint32_t frames, width, height, every;
    uint64_t budget;
    int stream, check;
    const char *folder; /* NULL = no files */
};

/* Results of a flight. */
struct outcome {
    uint64_t hash;          /* hash of the pixels of all frames */
    uint64_t peak_resident; /* bytes of tiles after a frame */
    uint64_t allocated[2];  /* memory of the cache after the first and the last frame */
    uint64_t evicted;
    uint64_t loaded;
};

static double milliseconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return 1e3 * (double)now.tv_sec + 1e-6 * (double)now.tv_nsec;
}

/* FNV-1a (Fowler, Noll and Vo). */
static uint64_t hash_bytes(uint64_t hash, const uint8_t *bytes, size_t count)
{
    size_t i;
    for (i = 0; i < count; ++i) hash = (hash ^ bytes[i]) * 1099511628211u;
    return hash;
}

static shd_result fly_frame(const struct options *o, const struct scene *scene, uint32_t frame, uint8_t *pixels,
                            FILE *csv, struct outcome *out)
{
    const struct flight flight = flight_at(frame, o->frames);
    const double start = milliseconds();
    shd_tile_cache_stats stats = shd_tile_cache_stats_default();
    shd_result result = scene_render(scene, &flight, pixels);
    const double time = milliseconds() - start;
    uint64_t resident;
    if (result == SHD_OK) result = shd_tile_cache_get_stats(scene->cache, &stats);
    if (result != SHD_OK) return result;
    resident = (uint64_t)stats.resident_tile_count * stats.tile_bytes;
    out->hash = hash_bytes(out->hash, pixels, (size_t)o->width * o->height * 4);
    if (resident > out->peak_resident) out->peak_resident = resident;
    out->allocated[frame != 0] = stats.allocated_bytes;
    out->evicted = stats.evicted_tile_count;
    out->loaded = stats.loaded_tile_count;
    if (csv) record_frame(csv, frame, flight.altitude, &stats, time);
    if (csv && frame % o->every == 0) result = record_picture(o->folder, frame, scene, pixels);
    return result;
}

static shd_result fly(const struct options *o, FILE *csv, struct outcome *out)
{
    const shd_missing_tiles missing = o->stream ? SHD_MISSING_TILES_COARSER : SHD_MISSING_TILES_WAIT;
    struct scene scene;
    struct stream stream;
    uint8_t *const pixels = (uint8_t *)malloc((size_t)o->width * o->height * 4);
    uint32_t frame;
    int streams = 0;
    shd_result result = scene_create(&scene, o->width, o->height, o->budget, missing);
    memset(out, 0, sizeof *out);
    out->hash = 14695981039346656037u;
    if (result == SHD_OK && !pixels) result = SHD_ERROR_OUT_OF_MEMORY;
    if (result == SHD_OK && o->stream) {
        streams = stream_start(&stream, scene.cache);
        if (!streams) result = SHD_ERROR_OUT_OF_MEMORY;
    }
    for (frame = 0; frame < o->frames && result == SHD_OK; ++frame) {
        result = fly_frame(o, &scene, frame, pixels, csv, out);
    }
    if (result != SHD_OK) fprintf(stderr, "flyover: %s\n", shd_last_error());
    if (streams) {
        const shd_result streamed = stream_stop(&stream);
        if (result == SHD_OK) result = streamed;
    }
    scene_release(&scene);
    free(pixels);
    return result;
}

/* ---- the check ---- */

static int is_within_budget(const struct options *o, const struct outcome *out)
{
    return out->peak_resident > 0 && out->peak_resident <= o->budget && out->allocated[0] <= o->budget &&
           out->allocated[1] == out->allocated[0];
}

/* A short flight in 4 MiB has the pixels of one in 32 MiB, and no flight exceeds its budget. */
static int check(void)
{
    struct options o = {8, 64, 36, 1, (uint64_t)4 << 20, 0, 1, NULL};
    struct outcome small, large, streamed;
    int good = fly(&o, NULL, &small) == SHD_OK && is_within_budget(&o, &small) && small.evicted > 0;
    o.budget = (uint64_t)32 << 20;
    good = good && fly(&o, NULL, &large) == SHD_OK && is_within_budget(&o, &large);
    good = good && large.hash == small.hash && large.loaded <= small.loaded;
    o.budget = (uint64_t)4 << 20;
    o.stream = 1;
    good = good && fly(&o, NULL, &streamed) == SHD_OK && is_within_budget(&o, &streamed);
    if (good) {
        printf("pixels %016llx; 4 MiB: %llu tiles loaded, %llu evicted; 32 MiB: %llu loaded\n",
               (unsigned long long)small.hash, (unsigned long long)small.loaded, (unsigned long long)small.evicted,
               (unsigned long long)large.loaded);
    }
    return good;
}

/* ---- the command ---- */

static int usage(void)
{
    fprintf(stderr,
            "usage: flyover [--frames N] [--size W H] [--budget MIB] [--stream] [--every N] [--out FOLDER]\n"
            "       flyover --check\n"
            "Frames 1..100000 [120], pixels 1..4096 [640 360], budget 3..2048 MiB [256], a picture every N\n"
            "frames [10]. --stream does not wait for tiles: a thread loads them.\n");
    return 0;
}

/* Reads the number after an option, low..high. */
static int number(char **args, int count, int *i, long low, long high, long *out)
{
    char *end;
    if (++*i >= count) return usage();
    *out = strtol(args[*i], &end, 10);
    return (*end == 0 && end != args[*i] && *out >= low && *out <= high) || usage();
}

static int parse(char **args, int count, struct options *o)
{
    int i;
    for (i = 1; i < count; ++i) {
        long value = 0, second = 0;
        if (strcmp(args[i], "--stream") == 0) {
            o->stream = 1;
        } else if (strcmp(args[i], "--check") == 0) {
            o->check = 1;
        } else if (strcmp(args[i], "--out") == 0 && i + 1 < count) {
            o->folder = args[++i];
        } else if (strcmp(args[i], "--frames") == 0) {
            if (!number(args, count, &i, 1, 100000, &value)) return 0;
            o->frames = (uint32_t)value;
        } else if (strcmp(args[i], "--every") == 0) {
            if (!number(args, count, &i, 1, 100000, &value)) return 0;
            o->every = (uint32_t)value;
        } else if (strcmp(args[i], "--budget") == 0) {
            if (!number(args, count, &i, 3, 2048, &value)) return 0;
            o->budget = (uint64_t)value << 20;
        } else if (strcmp(args[i], "--size") == 0) {
            if (!number(args, count, &i, 1, 4096, &value) || !number(args, count, &i, 1, 4096, &second)) return 0;
            o->width = (uint32_t)value, o->height = (uint32_t)second;
        } else {
            return usage();
        }
    }
    return 1;
}

int main(int argc, char **argv)
{
    struct options o = {120, 640, 360, 10, (uint64_t)256 << 20, 0, 0, "."};
    struct outcome out;
    char path[1024];
    FILE *csv;
    int good;
    if (!parse(argv, argc, &o)) return 2;
    if (o.check) {
        good = check();
        if (!good) fprintf(stderr, "flyover: a flight failed, exceeded its budget, or has other pixels\n");
        return good ? 0 : 1;
    }
    snprintf(path, sizeof path, "%s/flyover.csv", o.folder);
    csv = fopen(path, "w");
    if (!csv) return fprintf(stderr, "flyover: cannot write %s\n", path), 1;
    record_header(csv);
    good = fly(&o, csv, &out) == SHD_OK;
    good = fclose(csv) == 0 && good;
    printf("%s: %u frames, pixels %016llx, %llu tiles loaded, %llu evicted, at most %llu bytes of tiles\n", path,
           (unsigned)o.frames, (unsigned long long)out.hash, (unsigned long long)out.loaded,
           (unsigned long long)out.evicted, (unsigned long long)out.peak_resident);
    return good ? 0 : 1;
}
