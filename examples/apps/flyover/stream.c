/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L /* nanosleep */
#include <string.h>
#include <time.h>

#include "stream.h"

static void *run(void *user_data)
{
    struct stream *const stream = (struct stream *)user_data;
    const struct timespec pause = {0, 1000000};
    for (;;) {
        size_t loaded = 0;
        const shd_result result = shd_tile_cache_load_requested(stream->cache, 16, &loaded);
        int stop;
        pthread_mutex_lock(&stream->lock);
        if (result != SHD_OK) stream->result = result, stream->stop = 1;
        stop = stream->stop;
        pthread_mutex_unlock(&stream->lock);
        if (stop) return NULL;
        if (loaded == 0) nanosleep(&pause, NULL);
    }
}

int stream_start(struct stream *stream, shd_tile_cache *cache)
{
    memset(stream, 0, sizeof *stream);
    stream->cache = cache;
    if (pthread_mutex_init(&stream->lock, NULL) != 0) return 0;
    if (pthread_create(&stream->thread, NULL, run, stream) == 0) return 1;
    pthread_mutex_destroy(&stream->lock);
    return 0;
}

shd_result stream_stop(struct stream *stream)
{
    pthread_mutex_lock(&stream->lock);
    stream->stop = 1;
    pthread_mutex_unlock(&stream->lock);
    pthread_join(stream->thread, NULL);
    pthread_mutex_destroy(&stream->lock);
    return stream->result;
}
