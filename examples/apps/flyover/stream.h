/* SPDX-License-Identifier: MIT */
/* A thread that loads the tiles that lookups did not find. */
#ifndef FLYOVER_STREAM_H
#define FLYOVER_STREAM_H

#include <pthread.h>

#include <shd/shd.h>

struct stream {
    shd_tile_cache *cache;
    pthread_t thread;
    pthread_mutex_t lock; /* guards `stop` and `result` */
    int stop;
    shd_result result; /* result of the load that failed */
};

/* Returns 0 if no thread can be made. */
int stream_start(struct stream *stream, shd_tile_cache *cache);

/* Ends the thread, and returns the result of its loads. */
shd_result stream_stop(struct stream *stream);

#endif
