/* SPDX-License-Identifier: MIT */
/* The course's formulas for one point: Blinn-Phong, and a normal that a height map tilts. */
#ifndef SHD_EXAMPLES_COURSE_SHADING_H
#define SHD_EXAMPLES_COURSE_SHADING_H

#include <math.h>

static const float k_ambient = 0.005f, k_ambient_light = 10.0f; /* k_a I_a, once for each light */
static const float k_specular = 0.7937f, k_exponent = 150.0f;
static const float k_light[2][3] = {{30, 50, 20}, {-30, 50, 0}};
static const float k_intensity = 500.0f;
static const float k_eye[3] = {0, 0, 10};
static const float k_color[3] = {148 / 255.0f, 121 / 255.0f, 92 / 255.0f}; /* colour of a model without texture */
static const float k_h = 0.2f, k_n = 0.1f;                                 /* factors of heights */

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

/* Sum over the lights of k_a I_a + k_d I / r^2 max(0, n.l) + k_s I / r^2 max(0, n.h)^p (Blinn 1977). */
static inline void blinn_phong(const float kd[3], float intensity, const float point[3], const float n[3], float out[3])
{
    int k, c;
    out[0] = out[1] = out[2] = 0.0f;
    for (k = 0; k < 2; ++k) {
        float l[3], v[3], h[3], received, diffuse, specular;
        for (c = 0; c < 3; ++c) l[c] = k_light[k][c] - point[c], v[c] = k_eye[c] - point[c];
        received = intensity / dot(l, l);
        normalize(l), normalize(v);
        for (c = 0; c < 3; ++c) h[c] = v[c] + l[c];
        normalize(h);
        diffuse = received * fmaxf(0.0f, dot(n, l));
        specular = k_specular * received * powf(fmaxf(0.0f, dot(n, h)), k_exponent);
        for (c = 0; c < 3; ++c) out[c] += k_ambient * k_ambient_light + kd[c] * diffuse + specular;
    }
}

/*
 * The normal of a bumpy surface (Blinn, "Simulation of Wrinkled Surfaces", 1978), from the height at the point and at
 * the next texel in u and in v: n + dh/du t + dh/dv b with the course's frame. The course's t is perpendicular to n
 * only where n.y = 0, which is part of its look. Along +-y, where t has no direction, any frame is used.
 */
static inline void tilt(const float here, const float next_u, const float next_v, float n[3])
{
    const float du = k_h * k_n * (next_u - here), dv = k_h * k_n * (next_v - here);
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
