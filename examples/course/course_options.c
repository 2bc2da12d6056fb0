/* SPDX-License-Identifier: MIT */
/* The command line of the programs. */
#include "course.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const k_filters[] = {"trilinear",   "nearest",      "bilinear",   "bicubic",
                                        "nearest-mip", "bilinear-mip", "ripmap",     "summed-area",
                                        "anisotropic", "ewa",          "stochastic", "exact"};
static const char *const k_moves[] = {"homework", "notes", "small"};

/* Lamps of the third assignment, and of the lecture, which stand farther away. */
static const struct lamp k_homework[2] = {{{20, 20, 20}, 500, 0}, {{-20, 20, 0}, 500, 0}};
static const struct lamp k_notes[2] = {{{30, 50, 20}, 500, 0}, {{-30, 50, 0}, 500, 0}};

static const char k_help[] =
    "[options] [MODEL]\n"
    "  -o PICTURE.png          default NAME.png\n"
    "  --texture FILE          instead of the model's\n"
    "  --filter NAME           nearest, bilinear, trilinear ... (default trilinear)\n"
    "  --size N                pixels a side, 8..4096 (default 512)\n"
    "  --angle DEGREES         the model turned about the y axis (default -34)\n"
    "  --scale S               the model S times as large, about its own origin (default: fitted into the picture)\n"
    "  --lights homework|notes two points at (20, 20, 20), (-20, 20, 0); or (30, 50, 20), (-30, 50, 0)\n"
    "                          (default homework)\n"
    "  --light X,Y,Z[:I]       a point light instead of these, of intensity I (default 500); up to 8\n"
    "  --spot X,Y,Z[:I[:DEG]]  a spot light that shines at the origin, DEG its half angle (default 10); up to 8\n"
    "  --intensity I           intensity of all lights\n"
    "  --ka K  --ks K  --exponent P  --kh K  --kn K\n"
    "                          constants of the formulas (default 0.005, 0.7937, 150, 0.2, 0.1)\n"
    "  --move homework|notes|small\n"
    "                          displacement: by kn height, which reaches 44; not at all; by kn height / 255\n"
    "MODEL is a file that assimp reads, or - for a sphere.\n"
    "Spot the cow as in the third assignment: --angle 140 --scale 2.5 --size 700 --filter nearest\n"
    "  --texture spot_texture.png spot_triangulated_good.obj\n";

static int find(const char *const *names, int count, const char *value)
{
    int i;
    for (i = 0; i < count; ++i) {
        if (strcmp(names[i], value) == 0) return i;
    }
    return -1;
}

/* One number in low..high. */
static int number(const char *value, float low, float high, float *out)
{
    char *end = NULL;
    *out = strtof(value, &end);
    return end != value && *end == '\0' && *out >= low && *out <= high;
}

/* X,Y,Z[:I[:DEGREES]] */
static int lamp(const char *value, int is_spot, struct shading *shading)
{
    float p[3], intensity = 500.0f, degrees = 10.0f;
    int used = 0;
    struct lamp *lamp = &shading->lamps[shading->lamp_count];
    if (shading->lamp_count == COURSE_LAMPS || sscanf(value, "%f,%f,%f%n", &p[0], &p[1], &p[2], &used) != 3) return 0;
    value += used;
    if (*value == ':' && sscanf(value, ":%f%n", &intensity, &used) == 1) value += used;
    if (is_spot && *value == ':' && sscanf(value, ":%f%n", &degrees, &used) == 1) value += used;
    if (*value || !(dot(p, p) > 0.0f && dot(p, p) < 1e12f) || !(intensity >= 0.0f && intensity <= 1e9f)) return 0;
    if (!(degrees >= 0.1f && degrees <= 89.0f)) return 0;
    memcpy(lamp->position, p, sizeof p);
    lamp->intensity = intensity;
    lamp->cone = is_spot ? degrees * 0.0174532925f : 0.0f;
    ++shading->lamp_count;
    return 1;
}

static int set_shading(const char *name, const char *value, struct shading *shading)
{
    if (strcmp(name, "--light") == 0) return lamp(value, 0, shading);
    if (strcmp(name, "--spot") == 0) return lamp(value, 1, shading);
    if (strcmp(name, "--ka") == 0) return number(value, 0, 1e3f, &shading->ambient);
    if (strcmp(name, "--ks") == 0) return number(value, 0, 1e3f, &shading->specular);
    if (strcmp(name, "--exponent") == 0) return number(value, 0, 1e4f, &shading->exponent);
    if (strcmp(name, "--kh") == 0) return number(value, -1e3f, 1e3f, &shading->kh);
    if (strcmp(name, "--kn") == 0) return number(value, -1e3f, 1e3f, &shading->kn);
    return 0;
}

static int set(const char *name, const char *value, struct course_options *options)
{
    float size;
    int index;
    if (strcmp(name, "-o") == 0) return options->picture = value, *value != '\0';
    if (strcmp(name, "--texture") == 0) return options->texture = value, *value != '\0';
    if (strcmp(name, "--angle") == 0) return number(value, -1e4f, 1e4f, &options->angle);
    if (strcmp(name, "--scale") == 0) return number(value, 1e-6f, 1e6f, &options->scale);
    if (strcmp(name, "--intensity") == 0) return number(value, 0, 1e9f, &options->intensity);
    if (strcmp(name, "--size") == 0) {
        if (!number(value, 8, 4096, &size)) return 0;
        return options->size = (uint32_t)size, 1;
    }
    if (strcmp(name, "--filter") == 0) {
        index = find(k_filters, (int)(sizeof k_filters / sizeof k_filters[0]), value);
        return options->filter = (shd_filter)index, index >= 0;
    }
    if (strcmp(name, "--move") == 0) {
        index = find(k_moves, 3, value);
        return options->move = (enum course_move)index, index >= 0;
    }
    if (strcmp(name, "--lights") == 0) {
        options->notes = strcmp(value, "notes") == 0;
        return options->notes || strcmp(value, "homework") == 0;
    }
    return set_shading(name, value, &options->shading);
}

static void place_lamps(struct course_options *options)
{
    int i;
    if (options->shading.lamp_count == 0) {
        memcpy(options->shading.lamps, options->notes ? k_notes : k_homework, sizeof k_notes);
        options->shading.lamp_count = 2;
        options->is_default = !options->notes && options->intensity < 0.0f;
    }
    for (i = 0; i < options->shading.lamp_count && options->intensity >= 0.0f; ++i) {
        options->shading.lamps[i].intensity = options->intensity;
    }
}

int course_parse(int argc, char **argv, const char *name, struct course_options *options)
{
    int i;
    memset(options, 0, sizeof *options);
    options->size = 512, options->angle = -34.0f, options->intensity = -1.0f;
    options->shading.ambient = 0.005f, options->shading.ambient_light = 10.0f;
    options->shading.specular = 0.7937f, options->shading.exponent = 150.0f;
    options->shading.kh = 0.2f, options->shading.kn = 0.1f;
    for (i = 1; i < argc; ++i) {
        if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0) {
            printf("%s %s", name, k_help);
            return 0;
        }
        if (argv[i][0] != '-' || strcmp(argv[i], "-") == 0) {
            if (options->model || !*argv[i]) break;
            options->model = argv[i];
        } else if (i + 1 == argc || !set(argv[i], argv[i + 1], options)) {
            break;
        } else {
            ++i;
        }
    }
    if (i < argc) {
        fprintf(stderr, "%s: %s %s: unknown, incomplete or out of range; --help lists the options\n", name, argv[i],
                i + 1 < argc ? argv[i + 1] : "");
        return 2;
    }
    place_lamps(options);
    return -1;
}
