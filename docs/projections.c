/* SPDX-License-Identifier: MIT */
/*
 * The pictures of docs/environments.md, one SVG for each projection: projections FOLDER.
 *
 * Each picture shows the meridians and parallels of the sphere, 15 degrees apart, and the axes, at the points that
 * shd_projection_project() returns. The equator is red, the meridian through +Z blue. The cube is a horizontal cross.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <shd/shd.h>

enum { UNIT = 120, STEPS = 72, LINES = 12 };

static const struct figure {
    const char *file;
    shd_projection projection;
    float width, height; /* size of a face */
    int across, down;    /* faces */
} k_figures[] = {
    {"projection-lat-long", SHD_PROJECTION_LAT_LONG, 4 * UNIT, 2 * UNIT, 1, 1},
    {"projection-mirror-ball", SHD_PROJECTION_MIRROR_BALL, 2 * UNIT, 2 * UNIT, 1, 1},
    {"projection-angular", SHD_PROJECTION_ANGULAR, 2 * UNIT, 2 * UNIT, 1, 1},
    {"projection-cube", SHD_PROJECTION_CUBE, UNIT, UNIT, 4, 3},
    {"projection-octahedral", SHD_PROJECTION_OCTAHEDRAL, 2 * UNIT, 2 * UNIT, 1, 1},
};

/* Cells of the faces in a horizontal cross. */
static const int k_cell[6][2] = {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}};

static shd_context *g_context;

static void require(shd_result result)
{
    if (result == SHD_OK) return;
    fprintf(stderr, "projections: %s\n", shd_last_error());
    exit(EXIT_FAILURE);
}

struct place {
    float x, y;
    uint32_t face;
};

/* The point of a direction in a picture. */
static struct place place_of(const struct figure *figure, float x, float y, float z)
{
    const float n[3] = {x, y, z};
    shd_directions in = shd_directions_default();
    shd_projected_points out = shd_projected_points_default();
    struct place place;
    int c;
    in.projection = figure->projection;
    in.count = 1;
    for (c = 0; c < 3; ++c) in.direction[c] = shd_f32_column(n + c, 0);
    out.u = shd_f32_out_column(&place.x, 0);
    out.v = shd_f32_out_column(&place.y, 0);
    out.face = shd_u32_out_column(&place.face, 0);
    require(shd_projection_project(g_context, &in, &out));
    if (figure->projection == SHD_PROJECTION_CUBE) {
        place.x += (float)k_cell[place.face][0];
        place.y += (float)k_cell[place.face][1];
    }
    place.x *= figure->width;
    place.y *= figure->height;
    return place;
}

/* A circle of the sphere: `step` of STEPS to a point. The line ends where the image is cut. */
static void draw_line(FILE *file, const struct figure *figure, int meridian, double angle, const char *style)
{
    struct place last = {0, 0, 0};
    int i, open = 0;
    /* Half a step off the start, so that no point lies on a seam. */
    for (i = 0; i < STEPS; ++i) {
        const double turn = 6.283185307179586 * (i + 0.5) / (meridian ? 2.0 * STEPS : (double)STEPS);
        const double longitude = meridian ? angle : turn, latitude = meridian ? turn - 1.5707963267948966 : angle;
        const struct place place = place_of(figure, (float)(cos(latitude) * sin(longitude)), (float)sin(latitude),
                                            (float)(cos(latitude) * cos(longitude)));
        const float jump = hypotf(place.x - last.x, place.y - last.y);
        if (open && (place.face != last.face || jump > 0.25f * figure->width)) {
            fprintf(file, "\"/>\n");
            open = 0;
        }
        if (!open) fprintf(file, "<polyline %s points=\"", style);
        open = 1;
        fprintf(file, "%.1f,%.1f ", (double)place.x, (double)place.y);
        last = place;
    }
    if (open) fprintf(file, "\"/>\n");
}

static void draw_axis(FILE *file, const struct figure *figure, const char *name, float x, float y, float z)
{
    const struct place place = place_of(figure, x, y, z);
    const float width = figure->width * (float)figure->across, height = figure->height * (float)figure->down;
    const float left = fminf(fmaxf(place.x, 12.0f), width - 12.0f), top = fminf(fmaxf(place.y, 10.0f), height - 8.0f);
    fprintf(file,
            "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\" font-weight=\"bold\" stroke=\"white\" "
            "stroke-width=\"3\" paint-order=\"stroke\">%s</text>\n",
            (double)left, (double)top + 4.0, name);
}

static void draw(const struct figure *figure, const char *folder)
{
    const float width = figure->width * (float)figure->across, height = figure->height * (float)figure->down;
    char path[4096];
    FILE *file;
    int i;
    snprintf(path, sizeof path, "%s/%s.svg", folder, figure->file);
    file = fopen(path, "w");
    if (!file) exit(EXIT_FAILURE);
    fprintf(file,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" viewBox=\"-2 -2 %.0f %.0f\" "
            "font-family=\"sans-serif\" font-size=\"12\">\n<rect x=\"-2\" y=\"-2\" width=\"%.0f\" height=\"%.0f\" "
            "fill=\"white\"/>\n<g fill=\"none\" stroke=\"#888\" stroke-width=\"0.6\">\n",
            (double)width + 4, (double)height + 4, (double)width + 4, (double)height + 4, (double)width + 4,
            (double)height + 4);
    if (figure->projection == SHD_PROJECTION_CUBE) {
        for (i = 0; i < 6; ++i) {
            fprintf(file, "<rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" fill=\"#f4f4f4\" stroke=\"#444\"/>\n",
                    k_cell[i][0] * UNIT, k_cell[i][1] * UNIT, UNIT, UNIT);
        }
    } else {
        fprintf(file, "<rect x=\"0\" y=\"0\" width=\"%.0f\" height=\"%.0f\" fill=\"#f4f4f4\" stroke=\"#444\"/>\n",
                (double)width, (double)height);
    }
    for (i = 0; i < 2 * LINES; ++i) {
        draw_line(file, figure, 1, 6.283185307179586 * (i + 1e-4) / (2 * LINES),
                  i == 0 ? "stroke=\"#06c\" stroke-width=\"1.6\"" : "");
    }
    for (i = 1; i < LINES; ++i) {
        draw_line(file, figure, 0, 3.141592653589793 * ((double)i / LINES - 0.5),
                  2 * i == LINES ? "stroke=\"#c30\" stroke-width=\"1.6\"" : "");
    }
    fprintf(file, "</g>\n");
    draw_axis(file, figure, "+X", 1, 0, 0);
    draw_axis(file, figure, "-X", -1, 0, 0);
    draw_axis(file, figure, "+Y", 0, 1, 0);
    draw_axis(file, figure, "-Y", 0, -1, 0);
    draw_axis(file, figure, "+Z", 0, 0, 1);
    draw_axis(file, figure, "-Z", 0, 0, -1);
    fprintf(file, "</svg>\n");
    if (fclose(file) != 0) exit(EXIT_FAILURE);
}

int main(int argc, char **argv)
{
    size_t i;
    if (argc != 2) {
        fprintf(stderr, "usage: projections FOLDER\n");
        return EXIT_FAILURE;
    }
    require(shd_context_create(NULL, &g_context));
    for (i = 0; i < sizeof k_figures / sizeof *k_figures; ++i) draw(&k_figures[i], argv[1]);
    shd_context_release(g_context);
    return EXIT_SUCCESS;
}
