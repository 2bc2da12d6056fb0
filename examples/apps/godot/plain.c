/* SPDX-License-Identifier: MIT */
/* The frames of the Godot project without Godot, and the hash of each: plain FRAMES WIDTH HEIGHT */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "scene.h"

/* FNV-1a of 64 bits (Fowler, Noll and Vo, 1991), byte by byte. */
static uint64_t hash_bytes(const uint8_t *bytes, size_t count)
{
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    size_t i;
    for (i = 0; i < count; ++i) hash = (hash ^ bytes[i]) * UINT64_C(0x100000001b3);
    return hash;
}

int main(int count, char **arguments)
{
    const int frames = count > 3 ? atoi(arguments[1]) : 0;
    const int width = count > 3 ? atoi(arguments[2]) : 0, height = count > 3 ? atoi(arguments[3]) : 0;
    struct scene scene;
    uint8_t *pixels;
    int frame;
    if (frames < 1 || width < 1 || height < 1) {
        fprintf(stderr, "usage: plain FRAMES WIDTH HEIGHT\n");
        return 2;
    }
    pixels = malloc((size_t)width * (size_t)height * 4);
    if (!pixels || scene_open(&scene, (uint32_t)width, (uint32_t)height) != SHD_OK) {
        fprintf(stderr, "plain: %s\n", pixels ? shd_last_error() : "out of memory");
        free(pixels);
        return EXIT_FAILURE;
    }
    for (frame = 1; frame <= frames; ++frame) {
        if (scene_draw(&scene, frame, pixels) != SHD_OK) break;
        printf("frame %d %016" PRIx64 "\n", frame, hash_bytes(pixels, (size_t)width * (size_t)height * 4));
    }
    if (frame <= frames) fprintf(stderr, "plain: %s\n", shd_last_error());
    scene_close(&scene);
    free(pixels);
    return frame > frames ? EXIT_SUCCESS : EXIT_FAILURE;
}
