/* SPDX-License-Identifier: MIT */
/* A folder for the files of one test program, whole-file reading and writing, and a repeatable generator. */
#ifndef SHD_TESTS_SUPPORT_IO_FILES_H
#define SHD_TESTS_SUPPORT_IO_FILES_H

#include "support/check.h"

#include <dirent.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <shd/io.h>

/** Bytes of a file; the caller must free() them. */
typedef struct io_bytes {
    unsigned char *data;
    size_t size;
} io_bytes;

static char g_folder[256];

/** Group setup: makes the folder. */
static inline int io_make_folder(void **state)
{
    const char *base = getenv("TMPDIR");
    (void)state;
    snprintf(g_folder, sizeof g_folder, "%s/shd-io-XXXXXX", base && *base ? base : "/tmp");
    return mkdtemp(g_folder) ? 0 : -1;
}

/** Number of entries of the folder whose name starts with `prefix`; removes them if remove_them. */
static inline int io_count_files(const char *prefix, int remove_them)
{
    DIR *folder = opendir(g_folder);
    struct dirent *entry;
    int count = 0;
    if (!folder) return -1;
    while ((entry = readdir(folder)) != NULL) {
        char path[600];
        if (strcmp(entry->d_name, ".") == 0 || strcmp(entry->d_name, "..") == 0) continue;
        if (strncmp(entry->d_name, prefix, strlen(prefix)) != 0) continue;
        ++count;
        snprintf(path, sizeof path, "%s/%s", g_folder, entry->d_name);
        if (remove_them) remove(path);
    }
    closedir(folder);
    return count;
}

/** Group teardown: removes the folder and its contents. */
static inline int io_remove_folder(void **state)
{
    (void)state;
    io_count_files("", 1);
    return rmdir(g_folder);
}

/** Path of a name in the folder, in one of eight buffers that are reused in turn. */
static inline const char *io_path(const char *name)
{
    static char paths[8][600];
    static int next;
    char *path = paths[next++ % 8];
    snprintf(path, sizeof paths[0], "%s/%s", g_folder, name);
    return path;
}

static inline io_bytes io_read(const char *path)
{
    io_bytes bytes = {NULL, 0};
    FILE *file = fopen(path, "rb");
    long size;
    if (!file) return bytes;
    fseek(file, 0, SEEK_END);
    size = ftell(file);
    rewind(file);
    bytes.data = (unsigned char *)malloc((size_t)size + 1);
    bytes.size = fread(bytes.data, 1, (size_t)size, file);
    fclose(file);
    return bytes;
}

static inline void io_write(const char *path, const void *data, size_t size)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(data, 1, size, file), size);
    assert_int_equal(fclose(file), 0);
}

/** xorshift64 (Marsaglia, "Xorshift RNGs", 2003). */
static inline uint64_t io_random(uint64_t *state)
{
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    return *state;
}

/** Hash of the contents of a bitmap. */
static inline uint64_t io_hash_bitmap(const shd_bitmap *bitmap)
{
    shd_image image = shd_image_default();
    uint64_t hash = SHD_HASH_START;
    if (shd_bitmap_get_image(bitmap, &image) != SHD_OK) return 0;
    hash = shd_hash(hash, &image.format, sizeof image.format);
    hash = shd_hash(hash, &image.width, sizeof image.width);
    hash = shd_hash(hash, &image.height, sizeof image.height);
    hash = shd_hash(hash, shd_bitmap_get_color_space(bitmap), strlen(shd_bitmap_get_color_space(bitmap)));
    return shd_hash(hash, image.pixels, image.row_stride * image.height);
}

#endif /* SHD_TESTS_SUPPORT_IO_FILES_H */
