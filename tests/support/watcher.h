/* SPDX-License-Identifier: MIT */
/* A host that records the progress of a frame, and cancels it at one of the reports. */
#ifndef SHD_TESTS_SUPPORT_WATCHER_H
#define SHD_TESTS_SUPPORT_WATCHER_H

#include <shd/render.h>

/** `mistakes` counts fractions that do not increase or are not in (0, 1]; cancel_at 0 = never. */
typedef struct shd_watcher {
    int reports, mistakes, cancel_at;
    float latest;
} shd_watcher;

static inline shd_result shd_watch(float fraction, void *user_data)
{
    shd_watcher *w = (shd_watcher *)user_data;
    w->mistakes += !(fraction > w->latest) || !(fraction <= 1.0f);
    w->latest = fraction;
    return ++w->reports == w->cancel_at ? SHD_ERROR_CANCELLED : SHD_OK;
}

#endif /* SHD_TESTS_SUPPORT_WATCHER_H */
