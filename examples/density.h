/* SPDX-License-Identifier: MIT */
/* Densities for the examples and benchmarks: a head and a cloud, as n^3 texels of 8 bits. */
#ifndef EXAMPLES_DENSITY_H
#define EXAMPLES_DENSITY_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>

/* An ellipsoid that adds `density`: half axes, centre, and a turn around z [degrees]. */
struct ellipsoid {
    float density, a, b, c, x, y, z, turn;
};

/* The head of Shepp and Logan, "The Fourier Reconstruction of a Head Section" (1974), with the ellipsoids of Kak and
   Slaney, "Principles of Computerized Tomographic Imaging" (1988), 3.1, and the contrast of Toft, "The Radon Transform"
   (1996). */
static const struct ellipsoid k_head[10] = {
    {1.0f, 0.69f, 0.92f, 0.81f, 0.0f, 0.0f, 0.0f, 0.0f},
    {-0.8f, 0.6624f, 0.874f, 0.78f, 0.0f, -0.0184f, 0.0f, 0.0f},
    {-0.2f, 0.11f, 0.31f, 0.22f, 0.22f, 0.0f, 0.0f, -18.0f},
    {-0.2f, 0.16f, 0.41f, 0.28f, -0.22f, 0.0f, 0.0f, 18.0f},
    {0.1f, 0.21f, 0.25f, 0.41f, 0.0f, 0.35f, -0.15f, 0.0f},
    {0.1f, 0.046f, 0.046f, 0.05f, 0.0f, 0.1f, 0.25f, 0.0f},
    {0.1f, 0.046f, 0.046f, 0.05f, 0.0f, -0.1f, 0.25f, 0.0f},
    {0.1f, 0.046f, 0.023f, 0.05f, -0.08f, -0.605f, 0.0f, 0.0f},
    {0.1f, 0.023f, 0.023f, 0.02f, 0.0f, -0.606f, 0.0f, 0.0f},
    {0.1f, 0.023f, 0.046f, 0.02f, 0.06f, -0.605f, 0.0f, 0.0f},
};

/* Density of the head at a point of [-1, 1]^3. The ellipsoids have soft edges, so that gradients are smooth. */
static inline float head_density(float x, float y, float z)
{
    const float softness = 0.05f;
    float sum = 0.0f;
    size_t i;
    for (i = 0; i < 10; ++i) {
        const struct ellipsoid *e = &k_head[i];
        const float turn = e->turn * 0.0174532925f, cosine = cosf(turn), sine = sinf(turn);
        const float dx = x - e->x, dy = y - e->y, dz = z - e->z;
        const float u = (dx * cosine + dy * sine) / e->a, v = (dy * cosine - dx * sine) / e->b, w = dz / e->c;
        const float axis = e->a < e->b ? e->a : e->b;
        const float share = 0.5f + (1.0f - sqrtf(u * u + v * v + w * w)) * axis / softness;
        sum += e->density * (share < 0 ? 0 : share > 1 ? 1 : share);
    }
    return sum;
}

/* A random number in [0, 1) for each point of the integer lattice. */
static inline float lattice(int32_t x, int32_t y, int32_t z)
{
    uint32_t h = (uint32_t)x * 0x8da6b343u ^ (uint32_t)y * 0xd8163841u ^ (uint32_t)z * 0xcb1ab31fu;
    h = (h ^ h >> 15) * 0x2c1b3c6du;
    h = (h ^ h >> 12) * 0x297a2d39u;
    return (float)((h ^ h >> 15) >> 8) * 5.9604645e-8f;
}

/* Smooth noise in [0, 1). */
static inline float smooth_noise(float x, float y, float z)
{
    const float fx = floorf(x), fy = floorf(y), fz = floorf(z);
    const float s = x - fx, t = y - fy, r = z - fz;
    const float weight[3] = {s * s * (3 - 2 * s), t * t * (3 - 2 * t), r * r * (3 - 2 * r)};
    float sum = 0.0f;
    int k;
    for (k = 0; k < 8; ++k) {
        const float wx = k & 1 ? weight[0] : 1 - weight[0], wy = k & 2 ? weight[1] : 1 - weight[1];
        const float wz = k & 4 ? weight[2] : 1 - weight[2];
        sum += wx * wy * wz * lattice((int32_t)fx + (k & 1), (int32_t)fy + (k >> 1 & 1), (int32_t)fz + (k >> 2));
    }
    return sum;
}

/* Density of a cloud at a point of [-1, 1]^3: four octaves of noise in a flat ellipsoid. */
static inline float cloud_density(float x, float y, float z)
{
    float sum = 0.0f, scale = 0.55f, f = 3.0f;
    int octave;
    for (octave = 0; octave < 4; ++octave, scale *= 0.5f, f *= 2.1f) {
        sum += scale * smooth_noise(f * x + 10.0f, f * y, f * z);
    }
    return 1.5f * (sum - 0.25f - 0.9f * (x * x + 2.2f * y * y + z * z));
}

/* Fills [n][n][n] texels. */
static inline void fill_density(float (*density)(float, float, float), uint32_t n, unsigned char *texels)
{
    uint32_t x, y, z;
    for (z = 0; z < n; ++z) {
        for (y = 0; y < n; ++y) {
            for (x = 0; x < n; ++x) {
                const float step = 2.0f / (float)n;
                const float value =
                    density(((float)x + 0.5f) * step - 1, ((float)y + 0.5f) * step - 1, ((float)z + 0.5f) * step - 1);
                *texels++ = (unsigned char)(value <= 0 ? 0 : value >= 1 ? 255 : value * 255.0f + 0.5f);
            }
        }
    }
}

#endif /* EXAMPLES_DENSITY_H */
