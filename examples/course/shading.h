/* SPDX-License-Identifier: MIT */
/* The course's formulas for one point: Blinn-Phong, and a normal that a height map tilts. */
#ifndef SHD_EXAMPLES_COURSE_SHADING_H
#define SHD_EXAMPLES_COURSE_SHADING_H

#include <math.h>

enum { COURSE_LAMPS = 8 };

static const float k_eye[3] = {0, 0, 10};
static const float k_color[3] = {148 / 255.0f, 121 / 255.0f, 92 / 255.0f}; /* colour of a model without texture */

/* A point light, or a spot light that shines at the origin. */
struct lamp {
    float position[3];
    float intensity;
    float cone; /* half angle [rad] of a spot light; 0 = a point light */
};

/* Lamps and constants of the formulas. */
struct shading {
    struct lamp lamps[COURSE_LAMPS];
    int lamp_count;
    float ambient, ambient_light; /* k_a I_a, once for each lamp */
    float specular, exponent;     /* k_s, p */
    float kh, kn;                 /* factors of heights */
};

static inline float dot(const float a[3], const float b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void normalize(float a[3])
{
    float length = sqrtf(dot(a, a));
    int c;
    for (c = 0; c < 3 && length > 0.0f; ++c) a[c] /= length;
}

/* Part of a lamp's light that leaves it against the unit vector l: 1 on the axis of a spot light, 0 at its cone
   (shd/light.h). */
static inline float in_cone(const struct lamp *lamp, const float l[3])
{
    float axis[3] = {lamp->position[0], lamp->position[1], lamp->position[2]}, t;
    if (lamp->cone == 0.0f) return 1.0f;
    normalize(axis);
    t = (dot(axis, l) - cosf(lamp->cone)) / (1.0f - cosf(lamp->cone));
    t = fminf(fmaxf(t, 0.0f), 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

/* Sum over the lamps of k_a I_a + k_d I / r^2 max(0, n.l) + k_s I / r^2 max(0, n.h)^p (Blinn 1977). */
static inline void blinn_phong(const struct shading *s, const float kd[3], const float point[3], const float n[3],
                               float out[3])
{
    int k, c;
    out[0] = out[1] = out[2] = 0.0f;
    for (k = 0; k < s->lamp_count; ++k) {
        const struct lamp *lamp = &s->lamps[k];
        float l[3], v[3], h[3], received, diffuse, specular;
        for (c = 0; c < 3; ++c) l[c] = lamp->position[c] - point[c], v[c] = k_eye[c] - point[c];
        received = lamp->intensity / dot(l, l);
        normalize(l), normalize(v);
        received *= in_cone(lamp, l);
        for (c = 0; c < 3; ++c) h[c] = v[c] + l[c];
        normalize(h);
        diffuse = received * fmaxf(0.0f, dot(n, l));
        specular = s->specular * received * powf(fmaxf(0.0f, dot(n, h)), s->exponent);
        for (c = 0; c < 3; ++c) out[c] += s->ambient * s->ambient_light + kd[c] * diffuse + specular;
    }
}

/*
 * The normal of a bumpy surface (Blinn, "Simulation of Wrinkled Surfaces", 1978), from the height at the point and at
 * the next texel in u and in v: n + dh/du t + dh/dv b with the course's frame. The course's t is perpendicular to n
 * only where n.y = 0, which is part of its look. Along +-y, where t has no direction, any frame is used.
 */
static inline void tilt(const struct shading *s, float here, float next_u, float next_v, float n[3])
{
    const float du = s->kh * s->kn * (next_u - here), dv = s->kh * s->kn * (next_v - here);
    const float across = sqrtf(n[0] * n[0] + n[2] * n[2]);
    float t[3] = {1, 0, 0}, b[3];
    int c;
    if (across > 1e-6f) t[0] = n[0] * n[1] / across, t[1] = across, t[2] = n[1] * n[2] / across;
    b[0] = n[1] * t[2] - n[2] * t[1];
    b[1] = n[2] * t[0] - n[0] * t[2];
    b[2] = n[0] * t[1] - n[1] * t[0];
    for (c = 0; c < 3; ++c) n[c] = -du * t[c] - dv * b[c] + n[c];
    normalize(n);
}

/* Height: the length of a colour, with channels in 0..255 as in the course's textures. */
static inline float height_of(float r, float g, float b)
{
    return 255.0f * sqrtf(r * r + g * g + b * b);
}

#endif /* SHD_EXAMPLES_COURSE_SHADING_H */
