/* SPDX-License-Identifier: MIT */
/* The barycentric coordinates of one vertex of a polygon, of every kind, in one picture with lines of equal value. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <shd/shd.h>
#ifdef EXAMPLE_HAS_IO
#include <shd/io.h>
#endif

enum { TILE = 300, VERTICES = 7, KINDS = 4, VERTEX = 3 };

static const float vertex_x[VERTICES] = {0.12f, 0.55f, 0.93f, 0.88f, 0.6f, 0.24f, 0.06f};
static const float vertex_y[VERTICES] = {0.3f, 0.08f, 0.25f, 0.7f, 0.93f, 0.88f, 0.62f};

static uint8_t pixels[TILE][KINDS * TILE][4];
static float x[TILE * TILE], y[TILE * TILE], weight[VERTICES][TILE * TILE];

/* Whether a point lies inside: left of each edge, in picture coordinates. */
static int is_inside(float px, float py)
{
    int i;
    for (i = 0; i < VERTICES; ++i) {
        const int k = (i + 1) % VERTICES;
        const float dx = vertex_x[k] - vertex_x[i], dy = vertex_y[k] - vertex_y[i];
        if (dx * (py - vertex_y[i]) - dy * (px - vertex_x[i]) < 0) return 0;
    }
    return 1;
}

/* Computes the coordinates of all pixels of a tile. */
static shd_result evaluate(shd_context *context, shd_barycentric kind)
{
    shd_polygon_desc desc = shd_polygon_desc_default();
    shd_polygon_points points = shd_polygon_points_default();
    shd_polygon_weights weights = shd_polygon_weights_default();
    shd_f32_out columns[VERTICES];
    int i;
    desc.kind = kind;
    desc.vertex[0] = shd_f32_column(vertex_x, 0);
    desc.vertex[1] = shd_f32_column(vertex_y, 0);
    desc.vertex_count = VERTICES;
    points.count = TILE * TILE;
    points.position[0] = shd_f32_column(x, 0);
    points.position[1] = shd_f32_column(y, 0);
    for (i = 0; i < VERTICES; ++i) columns[i] = shd_f32_out_column(weight[i], 0);
    weights.weight = columns;
    weights.weight_count = VERTICES;
    return shd_polygon_evaluate(context, &desc, &points, &weights);
}

/* Draws the coordinate of one vertex: from blue at 0 to yellow at 1, with a line at each tenth. */
static void draw(int tile)
{
    size_t i;
    for (i = 0; i < TILE * TILE; ++i) {
        uint8_t *const to = pixels[i / TILE][(size_t)tile * TILE + i % TILE];
        const float b = weight[VERTEX][i], next = weight[VERTEX][i % TILE + 1 < TILE ? i + 1 : i],
                    below = weight[VERTEX][i + TILE < TILE * TILE ? i + TILE : i];
        const float level = floorf(10 * b + 0.5f);
        const int is_line = floorf(10 * next + 0.5f) != level || floorf(10 * below + 0.5f) != level;
        const float t = b < 0 ? 0 : b > 1 ? 1 : b;
        to[3] = 255;
        if (!is_inside(x[i], y[i])) {
            memset(to, 255, 3);
        } else {
            to[0] = (uint8_t)(is_line ? 255 : 20 + 225 * t);
            to[1] = (uint8_t)(is_line ? 255 : 40 + 160 * t);
            to[2] = (uint8_t)(is_line ? 255 : 130 - 100 * t);
        }
    }
}

/* The weights of a point inside have the sum 1 and reproduce the point. */
static int is_precise(void)
{
    size_t i;
    for (i = 0; i < TILE * TILE; ++i) {
        float sum = 0, sum_x = 0, sum_y = 0;
        int v;
        if (!is_inside(x[i], y[i])) continue;
        for (v = 0; v < VERTICES; ++v) {
            sum += weight[v][i];
            sum_x += weight[v][i] * vertex_x[v];
            sum_y += weight[v][i] * vertex_y[v];
        }
        if (fabsf(sum - 1) > 1e-5f || fabsf(sum_x - x[i]) > 1e-5f || fabsf(sum_y - y[i]) > 1e-5f) return 0;
    }
    return 1;
}

int main(void)
{
    shd_context *context = NULL;
    int kind, good = shd_context_create(NULL, &context) == SHD_OK;
    size_t i;
    for (i = 0; i < TILE * TILE; ++i) {
        x[i] = ((float)(i % TILE) + 0.5f) / TILE;
        y[i] = ((float)(i / TILE) + 0.5f) / TILE;
    }
    for (kind = 0; good && kind < KINDS; ++kind) {
        const shd_result result = evaluate(context, (shd_barycentric)kind);
        if (result == SHD_ERROR_UNSUPPORTED) continue; /* HARMONIC without Eigen */
        good = result == SHD_OK && is_precise();
        if (good) draw(kind);
    }
#ifdef EXAMPLE_HAS_IO
    if (good) {
        shd_image image = shd_image_default();
        image.format = SHD_FORMAT_RGBA8_SRGB;
        image.width = KINDS * TILE, image.height = TILE;
        image.pixels = pixels;
        good = shd_image_save(&image, "polygon.png", NULL) == SHD_OK && printf("polygon.png written\n") > 0;
    }
#endif
    if (!good) fprintf(stderr, "polygon: wrong weights or error: %s\n", shd_last_error());
    shd_context_release(context);
    return good ? 0 : 1;
}
