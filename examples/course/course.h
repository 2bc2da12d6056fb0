/* SPDX-License-Identifier: MIT */
/*
 * Common code of the five programs in this folder: a model, its texture, the camera, and writing to a file.
 *
 * The programs are exercises of a course, GAMES101 "Introduction to Modern Computer Graphics" (Lingqi Yan, 2020), with
 * the constants of its third assignment: two point lights of intensity 500 at (20, 20, 20) and (-20, 20, 0), and an eye
 * at (0, 0, 10) with a field of view of 45 degrees. Positions and normals are in world space. --lights notes takes the
 * lights of the lecture, which are farther away, so its pictures are nearly black.
 *
 * The course shades in the numbers of the files: sRGB-encoded texels are read without decoding, and the result is
 * stored without encoding. These programs do the same, to reproduce its pictures: textures are read as if they were
 * linear, and no curve is applied to the picture. A renderer should decode texels, shade light, and encode the picture,
 * as ../frame.c does.
 *
 * Usage of each program: NAME [options] [MODEL]; --help lists the options. MODEL is a file that assimp reads, or - for
 * a sphere made in code. If it is missing, the model is the duck of Debian's assimp-testmodels, or its spider for
 * height maps, or the sphere if that package or assimp is missing. Without --texture, the program uses the model's
 * first texture, or one made in code.
 */
#ifndef SHD_EXAMPLES_COURSE_H
#define SHD_EXAMPLES_COURSE_H

#include <shd/shd.h>

#include "shading.h"

enum { COURSE_ROWS = 256 };

/* Triangles to draw, and the file of their texture ("" = none). */
struct course_model {
    uint32_t vertex_count;
    float *position, *normal, *uv; /* [vertex][3], [vertex][3], [vertex][2]; uv's v grows downwards */
    uint32_t *indices;
    size_t index_count;
    char texture[4096];
};

/* Reads a model with assimp, or makes a sphere for "-". Returns 0 on failure. Must be released in any case. */
int course_model_create(const char *path, struct course_model *model);
void course_model_release(struct course_model *model);

/* The default model: one whose texture makes a good height map, or any. */
const char *course_default_model(int relief);

/* Distance by which the displacement program moves points along the normal: kn height as in the assignment, nothing as
   in the lecture, or kn height / 255. */
enum course_move { COURSE_MOVE_HOMEWORK = 0, COURSE_MOVE_NOTES = 1, COURSE_MOVE_SMALL = 2 };

/* The command line. */
struct course_options {
    const char *model, *picture, *texture; /* NULL = not given */
    shd_filter filter;
    uint32_t size;   /* pixels a side */
    float angle;     /* about the y axis [degrees] */
    float scale;     /* 0 = fitted into the picture */
    float intensity; /* replaces that of every lamp; below 0 = none */
    int notes;       /* the lamps of the lecture */
    int is_default;  /* no option that changes the lamps */
    enum course_move move;
    struct shading shading;
};

/* Reads the command line. Returns -1, or the exit code of a program that has nothing else to do. */
int course_parse(int argc, char **argv, const char *name, struct course_options *options);

/* One run of a program, and its user_data. */
struct course {
    shd_context *context;
    shd_mesh *mesh;
    shd_texture *texture;
    shd_sampler *sampler;
    float texels_u, texels_v; /* size of the texture */
    float object_to_world[16];
    struct course_options options;
};

struct course_program {
    const char *name;
    int relief; /* 1 = the texture is a height map */
    shd_fragment_fn fragment;
    int (*check)(struct course *course, const shd_framebuffer *frame); /* whether the picture is correct */
};

/* Loads, renders, checks and saves. Returns the exit code of main. */
int course_main(int argc, char **argv, const struct course_program *program);

/* Renders a frame of the model in a material, with its normals. The course's lights are used if the material is a
   reflectance model. */
shd_result course_render(const struct course *course, const shd_material_desc *material, uint32_t samples,
                         shd_framebuffer **out_frame);

/* A material that is shaded by the program. */
shd_material_desc course_material(struct course *course, shd_fragment_fn fragment);

/* Replaces the texture by a single black texel: height 0 everywhere. */
shd_result course_flatten(struct course *course);

/* Mean of green over the model; 0 if the frame cannot be read. */
double course_brightness(const shd_framebuffer *frame);

/* Largest difference of two frames over all channels, relative to values above 1; 1e9 if one of them cannot be read. */
double course_difference(const shd_framebuffer *a, const shd_framebuffer *b);

/* Texels at rows first .. first + count - 1, at most COURSE_ROWS, displaced by `du` and `dv`. They are NaN on failure,
   which makes the frame fail. Any thread: a program may look textures up. */
struct course_texels {
    float r[COURSE_ROWS], g[COURSE_ROWS], b[COURSE_ROWS];
};
void course_look_up(const struct course *course, const shd_fragments *in, size_t first, size_t count, float du,
                    float dv, struct course_texels *out);

/* Number of rows to shade in one step. */
static inline size_t course_rows(const shd_fragments *in, size_t first)
{
    return in->count - first < COURSE_ROWS ? in->count - first : COURSE_ROWS;
}

#endif /* SHD_EXAMPLES_COURSE_H */
