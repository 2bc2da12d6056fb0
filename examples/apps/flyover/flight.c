/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "flight.h"

static const double k_high = 2.0, k_low = 0.0019; /* altitudes [radii] */

/* Altitude at part t of the flight, 0..1. Equal times change it by equal factors. */
static double altitude_at(double t)
{
    double s = fmin(t / 0.6, 1.0);
    s = s * s * (3.0 - 2.0 * s);
    return k_high * pow(k_low / k_high, s);
}

/* Angle of the way over ground. The speed falls with the altitude. */
static double way_at(double t)
{
    enum { STEPS = 1024 };
    double way = 0;
    int i;
    for (i = 0; i < STEPS; ++i) way += fmin(200.0 * altitude_at(t * (i + 0.5) / STEPS), 0.9) * t / STEPS;
    return way;
}

struct flight flight_at(uint32_t frame, uint32_t count)
{
    static const double k_start[3] = {-0.2425, 0.0, 0.9701},
                        k_heading[3] = {0.8731, -0.4359, 0.2183}; /* at right angles */
    const double t = count > 1 ? (double)frame / (double)(count - 1) : 0.0;
    const double altitude = altitude_at(t), way = way_at(t);
    const double low = 1.0 - log(altitude / k_low) / log(k_high / k_low);
    const double horizon = acos(1.0 / (1.0 + altitude)); /* below the level line */
    const double pitch = 1.5707963 + (horizon + 0.24 - 1.5707963) * low * low;
    struct flight flight;
    int c;
    flight.camera = shd_camera_default();
    flight.altitude = (float)altitude;
    for (c = 0; c < 3; ++c) {
        const double up = cos(way) * k_start[c] + sin(way) * k_heading[c];
        const double ahead = cos(way) * k_heading[c] - sin(way) * k_start[c];
        const double eye = up * (1.0 + altitude);
        flight.camera.eye[c] = (float)eye;
        flight.camera.target[c] = (float)(eye + cos(pitch) * ahead - sin(pitch) * up);
        flight.camera.up[c] = (float)(sin(pitch) * ahead + cos(pitch) * up);
    }
    flight.camera.near_plane = (float)(0.3 * altitude);
    flight.camera.far_plane = (float)(altitude + 2.0);
    return flight;
}
