/* SPDX-License-Identifier: MIT */
/*
 * The pictures of the filter pages, one SVG for each filter: footprints FOLDER.
 *
 * All pictures show the same lookup. The left side shows the texels that it reads, as shd_texture_explain() lists them.
 * The right side shows the weight of each texel of level 0 in the result. The weights are measured: layer k of an array
 * is 1 at texel k and 0 elsewhere, so a lookup in layer k returns the weight of texel k.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <shd/shd.h>

enum {
    SIZE = 32,
    TEXELS = SIZE * SIZE,
    DRAWS = 4096,
    FIRST = 6,
    SHOWN = 20,
    CELL = 14,
    GAP = 24,
    TOP = 26,
    TAPS = 4096
};

static const float k_u = 16.4f / SIZE, k_v = 15.8f / SIZE; /* the point */
static const float k_dudx = 5.4f / SIZE, k_dvdx = 2.7f / SIZE, k_dudy = -0.7f / SIZE, k_dvdy = 1.9f / SIZE;

static const struct figure {
    const char *file;
    shd_filter filter;
    shd_box box;
    int explained; /* shd_texture_explain() supports the filter */
} k_figures[] = {
    {"nearest", SHD_FILTER_NEAREST, SHD_BOX_BOUNDING, 1},
    {"bilinear", SHD_FILTER_BILINEAR, SHD_BOX_BOUNDING, 1},
    {"bicubic", SHD_FILTER_BICUBIC, SHD_BOX_BOUNDING, 1},
    {"hermite", SHD_FILTER_HERMITE, SHD_BOX_BOUNDING, 1},
    {"nearest-mip", SHD_FILTER_NEAREST_MIP, SHD_BOX_BOUNDING, 1},
    {"nearest-mip-linear", SHD_FILTER_NEAREST_MIP_LINEAR, SHD_BOX_BOUNDING, 1},
    {"bilinear-mip", SHD_FILTER_BILINEAR_MIP, SHD_BOX_BOUNDING, 1},
    {"trilinear", SHD_FILTER_TRILINEAR, SHD_BOX_BOUNDING, 1},
    {"ripmap", SHD_FILTER_RIPMAP, SHD_BOX_BOUNDING, 1},
    {"summed-area", SHD_FILTER_SUMMED_AREA, SHD_BOX_BOUNDING, 0},
    {"summed-area-oriented", SHD_FILTER_SUMMED_AREA, SHD_BOX_ORIENTED, 0},
    {"anisotropic", SHD_FILTER_ANISOTROPIC, SHD_BOX_BOUNDING, 1},
    {"ewa", SHD_FILTER_EWA, SHD_BOX_BOUNDING, 1},
    {"stochastic", SHD_FILTER_STOCHASTIC, SHD_BOX_BOUNDING, 1},
    {"exact", SHD_FILTER_EXACT, SHD_BOX_BOUNDING, 0},
};

static void require(shd_result result)
{
    if (result == SHD_OK) return;
    fprintf(stderr, "footprints: %s\n", shd_last_error());
    exit(EXIT_FAILURE);
}

static shd_texture *create_impulses(shd_context *context)
{
    float *texels = (float *)calloc((size_t)TEXELS * TEXELS, sizeof(float));
    shd_texture *texture = NULL;
    shd_texture_desc desc = shd_texture_desc_default();
    size_t k;
    if (texels == NULL) exit(EXIT_FAILURE);
    for (k = 0; k < TEXELS; ++k) texels[k * TEXELS + k] = 1.0f;
    desc.format = SHD_FORMAT_R32F;
    desc.width = desc.height = SIZE;
    desc.layer_count = TEXELS;
    desc.texels = texels;
    desc.tables = SHD_TABLE_MIPMAP | SHD_TABLE_RIPMAP | SHD_TABLE_SUMMED_AREA;
    require(shd_texture_create(context, &desc, &texture));
    free(texels);
    return texture;
}

/* The same footprint for `count` lookups. */
static shd_lookups look_up(size_t count)
{
    static float u[DRAWS], v[DRAWS], dudx[DRAWS], dvdx[DRAWS], dudy[DRAWS], dvdy[DRAWS];
    shd_lookups lookups = shd_lookups_default();
    size_t i;
    for (i = 0; i < count; ++i) {
        u[i] = k_u, v[i] = k_v;
        dudx[i] = k_dudx, dvdx[i] = k_dvdx, dudy[i] = k_dudy, dvdy[i] = k_dvdy;
    }
    lookups.count = count;
    lookups.u.data = u, lookups.v.data = v;
    lookups.dudx.data = dudx, lookups.dvdx.data = dvdx, lookups.dudy.data = dudy, lookups.dvdy.data = dvdy;
    return lookups;
}

/* Weights of all texels of level 0: of a stochastic filter, the mean of `draws` lookups. */
static void measure(const shd_texture *impulses, const shd_sampler *sampler, size_t draws, double weights[TEXELS])
{
    static float values[DRAWS];
    static uint32_t layer[DRAWS], random[DRAWS];
    shd_lookups lookups = look_up(draws);
    shd_texels out = {0};
    size_t i, k;
    for (i = 0; i < draws; ++i) random[i] = (uint32_t)(i * 2654435761u);
    lookups.layer.data = layer, lookups.random.data = random;
    out.channel[0].data = values;
    for (k = 0; k < TEXELS; ++k) {
        for (i = 0; i < draws; ++i) layer[i] = (uint32_t)k;
        require(shd_texture_sample(impulses, sampler, &lookups, &out));
        weights[k] = 0.0;
        for (i = 0; i < draws; ++i) weights[k] += values[i] / (double)draws;
    }
}

static void rectangle(FILE *svg, double x, double y, double width, double height, double weight)
{
    fprintf(svg, "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"%s\" fill-opacity=\"%.3f\"/>\n",
            (x - FIRST) * CELL, (y - FIRST) * CELL, width * CELL, height * CELL, weight < 0 ? "#c02" : "#05a",
            fmin(fabs(weight), 1.0));
}

/* Grid of texels, and the outlines of the pixel, of its inscribed ellipse and of the ellipse's axes. */
static void outlines(FILE *svg, const shd_explanation *lookup)
{
    const double x = k_u * SIZE - FIRST, y = k_v * SIZE - FIRST;
    const double a[2] = {k_dudx * SIZE / 2.0, k_dvdx * SIZE / 2.0}, b[2] = {k_dudy * SIZE / 2.0, k_dvdy * SIZE / 2.0};
    const float *longer = lookup->longer_axis, *shorter = lookup->shorter_axis;
    int i;
    fprintf(svg, "<g stroke=\"#bbb\" stroke-width=\"0.5\">\n");
    for (i = 0; i <= SHOWN; ++i) {
        fprintf(svg, "<path d=\"M%d 0V%dM0 %dH%d\"/>\n", i * CELL, SHOWN * CELL, i * CELL, SHOWN * CELL);
    }
    fprintf(svg, "</g>\n<g transform=\"scale(%d)\" fill=\"none\" stroke=\"#000\" stroke-width=\"0.12\">\n", CELL);
    fprintf(svg, "<path d=\"M%.3f %.3fL%.3f %.3fL%.3f %.3fL%.3f %.3fZ\"/>\n", x - a[0] - b[0], y - a[1] - b[1],
            x + a[0] - b[0], y + a[1] - b[1], x + a[0] + b[0], y + a[1] + b[1], x - a[0] + b[0], y - a[1] + b[1]);
    fprintf(svg, "<g stroke=\"#e60\"><ellipse cx=\"%.3f\" cy=\"%.3f\" rx=\"%.3f\" ry=\"%.3f\"", x, y,
            hypot(longer[0], longer[1]) / 2, hypot(shorter[0], shorter[1]) / 2);
    fprintf(svg, " transform=\"rotate(%.2f %.3f %.3f)\"/>\n", atan2(longer[1], longer[0]) * 57.29577951, x, y);
    fprintf(svg, "<path d=\"M%.3f %.3fL%.3f %.3fM%.3f %.3fL%.3f %.3f\" stroke-width=\"0.08\"/></g></g>\n",
            x - longer[0] / 2, y - longer[1] / 2, x + longer[0] / 2, y + longer[1] / 2, x - shorter[0] / 2,
            y - shorter[1] / 2, x + shorter[0] / 2, y + shorter[1] / 2);
}

static void draw_taps(FILE *svg, const shd_explanation *lookup)
{
    double most = 0.0;
    uint32_t i;
    for (i = 0; i < lookup->tap_count; ++i) most = fmax(most, fabs(lookup->taps[i].weight));
    for (i = 0; i < lookup->tap_count; ++i) {
        const shd_tap *tap = &lookup->taps[i];
        const double width = ldexp(1.0, (int)tap->level_u), height = ldexp(1.0, (int)tap->level_v);
        if (tap->weight == 0.0f) continue;
        rectangle(svg, tap->x * width + 0.04, tap->y * height + 0.04, width - 0.08, height - 0.08,
                  copysign(0.1 + 0.5 * fabs(tap->weight) / most, tap->weight));
    }
}

static void draw_weights(FILE *svg, const double weights[TEXELS])
{
    double most = 0.0;
    int x, y;
    for (x = 0; x < TEXELS; ++x) most = fmax(most, fabs(weights[x]));
    for (y = FIRST; y < FIRST + SHOWN; ++y) {
        for (x = FIRST; x < FIRST + SHOWN; ++x) {
            const double weight = weights[y * SIZE + x];
            if (fabs(weight) >= 0.002 * most) rectangle(svg, x, y, 1, 1, weight / most);
        }
    }
}

static void write_figure(const char *folder, const struct figure *figure, const shd_explanation *lookup,
                         const double weights[TEXELS])
{
    const int side = SHOWN * CELL;
    char path[1024];
    FILE *svg;
    snprintf(path, sizeof path, "%s/%s.svg", folder, figure->file);
    svg = fopen(path, "w");
    if (svg == NULL) exit(EXIT_FAILURE);
    fprintf(svg, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\">\n",
            2 * side + GAP + 2, side + TOP + 1, 2 * side + GAP + 2, side + TOP + 1);
    fprintf(svg,
            "<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n<g font-family=\"sans-serif\" "
            "font-size=\"13\">\n");
    if (figure->explained) {
        fprintf(svg, "<text x=\"1\" y=\"15\">Taps: %u</text>\n", (unsigned)lookup->tap_count);
    } else {
        fprintf(svg, "<text x=\"1\" y=\"15\">The footprint</text>\n");
    }
    fprintf(svg, "<text x=\"%d\" y=\"15\">Weights of the texels of level 0</text></g>\n", side + GAP + 1);
    fprintf(svg, "<svg x=\"1\" y=\"%d\" width=\"%d\" height=\"%d\">\n", TOP, side, side);
    if (figure->explained) draw_taps(svg, lookup);
    outlines(svg, lookup);
    fprintf(svg, "</svg>\n<svg x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\">\n", side + GAP + 1, TOP, side, side);
    draw_weights(svg, weights);
    outlines(svg, lookup);
    fprintf(svg, "</svg></svg>\n");
    if (fclose(svg) != 0) exit(EXIT_FAILURE);
    printf("%s\n", path);
}

static void draw_figure(shd_context *context, const shd_texture *impulses, const struct figure *figure,
                        const char *folder)
{
    static double weights[TEXELS];
    static shd_tap taps[TAPS];
    static shd_blend_step blends[TAPS];
    const shd_lookups one = look_up(1);
    shd_sampler *sampler = NULL, *explained = NULL;
    shd_sampler_desc desc = shd_sampler_desc_default();
    shd_explanation lookup = shd_explanation_default();
    desc.wrap_u = desc.wrap_v = SHD_WRAP_CLAMP;
    desc.box = figure->box;
    desc.stochastic_filter = SHD_FILTER_ANISOTROPIC;
    desc.filter = figure->filter;
    require(shd_sampler_create(context, &desc, &sampler));
    if (!figure->explained) desc.filter = SHD_FILTER_EWA; /* for the axes of the ellipse */
    require(shd_sampler_create(context, &desc, &explained));
    lookup.taps = taps, lookup.tap_capacity = TAPS;
    lookup.blends = blends, lookup.blend_capacity = TAPS;
    require(shd_texture_explain(impulses, explained, &one, 0, &lookup));
    measure(impulses, sampler, figure->filter == SHD_FILTER_STOCHASTIC ? DRAWS : 1, weights);
    write_figure(folder, figure, &lookup, weights);
    shd_sampler_release(sampler);
    shd_sampler_release(explained);
}

int main(int argc, char **argv)
{
    shd_context *context = NULL;
    shd_texture *impulses;
    size_t i;
    if (argc != 2) return EXIT_FAILURE;
    require(shd_context_create(NULL, &context));
    impulses = create_impulses(context);
    for (i = 0; i < sizeof k_figures / sizeof k_figures[0]; ++i) draw_figure(context, impulses, &k_figures[i], argv[1]);
    shd_texture_release(impulses);
    shd_context_release(context);
    return EXIT_SUCCESS;
}
