/* SPDX-License-Identifier: MIT */
/* The path of the camera over a planet of radius 1. */
#ifndef FLYOVER_FLIGHT_H
#define FLYOVER_FLIGHT_H

#include <shd/shd.h>

struct flight {
    shd_camera camera;
    float altitude; /* above the ground, in radii */
};

/* The camera of frame `frame` of `count`: down from two radii to 12 km (on Earth) in 3/5 of the frames, then along. */
struct flight flight_at(uint32_t frame, uint32_t count);

#endif
