/* SPDX-License-Identifier: MIT */
/* Meshes with known edges, as records of x, y, z and index triples. */
#ifndef SHD_TESTS_SUPPORT_SHAPES_H
#define SHD_TESTS_SUPPORT_SHAPES_H

#include "support/check.h"
#include "support/noise.h"

#include <shd/mesh.h>

enum { SHD_SHAPE_VERTICES = 2000, SHD_SHAPE_TRIANGLES = 4000 };

typedef struct shd_test_shape {
    float position[3 * SHD_SHAPE_VERTICES];
    uint32_t indices[3 * SHD_SHAPE_TRIANGLES];
    uint32_t vertices, triangles;
} shd_test_shape;

static inline uint32_t shd_test_shape_vertex(shd_test_shape *s, float x, float y, float z)
{
    float *p = s->position + 3 * (size_t)s->vertices;
    p[0] = x;
    p[1] = y;
    p[2] = z;
    return s->vertices++;
}

static inline void shd_test_shape_triangle(shd_test_shape *s, uint32_t a, uint32_t b, uint32_t c)
{
    uint32_t *t = s->indices + 3 * (size_t)s->triangles++;
    t[0] = a;
    t[1] = b;
    t[2] = c;
}

/** The cube [-1, 1]^3 of n x n cells per side; its sides share no vertices. */
static inline void shd_test_shape_cube(shd_test_shape *s, uint32_t n)
{
    uint32_t face, x, y;
    for (face = 0; face < 6; ++face) {
        const float side = face < 3 ? 1.0f : -1.0f;
        const uint32_t first = s->vertices;
        for (y = 0; y <= n; ++y) {
            for (x = 0; x <= n; ++x) {
                float p[3];
                p[face % 3] = side;
                p[(face + 1) % 3] = side * ((float)(2 * x) - (float)n) / (float)n;
                p[(face + 2) % 3] = ((float)(2 * y) - (float)n) / (float)n;
                (void)shd_test_shape_vertex(s, p[0], p[1], p[2]);
            }
        }
        for (y = 0; y < n; ++y) {
            for (x = 0; x < n; ++x) {
                const uint32_t a = first + y * (n + 1) + x;
                shd_test_shape_triangle(s, a, a + 1, a + n + 2);
                shd_test_shape_triangle(s, a, a + n + 2, a + n + 1);
            }
        }
    }
}

/** The unit sphere of that cube. Its sides still meet, because opposite numbers have opposite signs. */
static inline void shd_test_shape_sphere(shd_test_shape *s, uint32_t n)
{
    uint32_t i, first = s->vertices;
    shd_test_shape_cube(s, n);
    for (i = first; i < s->vertices; ++i) {
        float *p = s->position + 3 * (size_t)i;
        const float length = sqrtf(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        p[0] /= length;
        p[1] /= length;
        p[2] /= length;
    }
}

/** n x m cells of the plane z = 0, each with its own vertices. */
static inline void shd_test_shape_grid(shd_test_shape *s, uint32_t n, uint32_t m)
{
    uint32_t x, y;
    for (y = 0; y < m; ++y) {
        for (x = 0; x < n; ++x) {
            const uint32_t a = shd_test_shape_vertex(s, (float)x, (float)y, 0);
            (void)shd_test_shape_vertex(s, (float)x + 1, (float)y, x % 2 ? 0.0f : -0.0f);
            (void)shd_test_shape_vertex(s, (float)x + 1, (float)y + 1, 0);
            (void)shd_test_shape_vertex(s, (float)x, (float)y + 1, -0.0f);
            shd_test_shape_triangle(s, a, a + 1, a + 2);
            shd_test_shape_triangle(s, a, a + 2, a + 3);
        }
    }
}

/** A book: `pages` triangles that share the edge from (0, 0, 0) to (0, 1, 0). */
static inline void shd_test_shape_book(shd_test_shape *s, uint32_t pages)
{
    const uint32_t a = shd_test_shape_vertex(s, 0, 0, 0), b = shd_test_shape_vertex(s, 0, 1, 0);
    uint32_t i;
    for (i = 0; i < pages; ++i) {
        const uint32_t c = shd_test_shape_vertex(s, 1, 0.5f, (float)i - 0.5f);
        shd_test_shape_triangle(s, i % 2 ? a : b, i % 2 ? b : a, c);
    }
}

/** A Moebius strip of n cells around the z axis. */
static inline void shd_test_shape_moebius(shd_test_shape *s, uint32_t n)
{
    uint32_t i;
    const uint32_t first = s->vertices;
    for (i = 0; i < n; ++i) {
        const double angle = 6.283185307179586 * i / n;
        const float x = (float)cos(angle), y = (float)sin(angle);
        const float across = 0.4f * (float)cos(angle / 2), up = 0.4f * (float)sin(angle / 2);
        (void)shd_test_shape_vertex(s, x * (1 + across), y * (1 + across), up);
        (void)shd_test_shape_vertex(s, x * (1 - across), y * (1 - across), -up);
    }
    for (i = 0; i < n; ++i) {
        const uint32_t a = first + 2 * i, turned = i + 1 == n;
        const uint32_t c = turned ? first + 1 : a + 2, d = turned ? first : a + 3;
        shd_test_shape_triangle(s, a, a + 1, d);
        shd_test_shape_triangle(s, a, d, c);
    }
}

/** Triangles between random points of a lattice so small that most edges are shared and many have no area. */
static inline void shd_test_shape_lattice(shd_test_shape *s, uint32_t triangles, uint32_t seed)
{
    uint32_t i, c;
    for (i = 0; i < 3 * triangles; ++i) {
        float p[3];
        for (c = 0; c < 3; ++c) {
            shd_noise(&seed);
            p[c] = (float)(seed >> 28) / 4 - 2;
            if (p[c] == 0 && (seed >> 27 & 1)) p[c] = -0.0f;
            if (triangles > 100) p[c] = floorf(p[c]);
        }
        s->indices[3 * (size_t)s->triangles + i] = shd_test_shape_vertex(s, p[0], p[1], p[2]);
    }
    s->triangles += triangles;
}

/** Makes a mesh of a shape. */
static inline shd_mesh *shd_test_shape_mesh(shd_context *context, const shd_test_shape *s, uint32_t flags)
{
    shd_mesh_desc desc = shd_mesh_desc_default();
    shd_mesh *mesh = NULL;
    int c;
    desc.vertex_count = s->vertices;
    for (c = 0; c < 3; ++c) {
        desc.position[c].data = s->position + c;
        desc.position[c].stride = 3 * sizeof(float);
    }
    desc.indices.data = s->indices;
    desc.index_count = 3 * (size_t)s->triangles;
    desc.flags = flags;
    shd_assert_ok(shd_mesh_create(context, &desc, &mesh));
    return mesh;
}

#endif /* SHD_TESTS_SUPPORT_SHAPES_H */
