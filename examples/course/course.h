/* SPDX-License-Identifier: MIT */
/*
 * What the five programs of this folder share: a model, its texture, the camera, and the way to a file.
 *
 * The programs are those of a course, GAMES101 "Introduction to Modern Computer Graphics" (Lingqi Yan, 2020), with its
 * constants: two point lights of intensity 500 over an eye at (0, 0, 10). Positions and normals are in world space.
 *
 * The course shades in the numbers of the files: texels go in as they are stored, sRGB-encoded, and what comes out is
 * stored as it is. So do these programs, to show its pictures: textures are read as if they were linear, and no curve
 * is applied to the picture. A renderer decodes texels, shades light, and encodes the picture, as ../frame.c does.
 *
 * Usage of each: NAME [MODEL [PICTURE.png [TEXTURE]]]. MODEL is what assimp reads, or - for a sphere made in code;
 * without one, or for "", the duck of Debian's assimp-testmodels or, for height maps, its spider, and the sphere where
 * that package or assimp is missing. Without TEXTURE the model's first, or one made in code.
 */
#ifndef SHD_EXAMPLES_COURSE_H
#define SHD_EXAMPLES_COURSE_H

#include <shd/shd.h>

enum { COURSE_SIZE = 512, COURSE_ROWS = 256 };

/* Triangles to draw, and the file of the texture that goes with them ("" = none). */
struct course_model {
    uint32_t vertex_count;
    float *position, *normal, *uv; /* [vertex][3], [vertex][3], [vertex][2]; uv's v grows downwards */
    uint32_t *indices;
    size_t index_count;
    char texture[4096];
};

/* Reads a model through assimp, or makes a sphere for "-". 0 on failure; release it in any case. */
int course_model_create(const char *path, struct course_model *model);
void course_model_release(struct course_model *model);

/* The model that is drawn when none is named: one whose texture makes a good height map, or any. */
const char *course_default_model(int relief);

/* One run of a program; its user_data. */
struct course {
    shd_context *context;
    shd_mesh *mesh;
    shd_texture *texture;
    shd_sampler *sampler;
    float texels_u, texels_v; /* size of the texture */
    float object_to_world[16];
};

struct course_program {
    const char *name;
    int relief; /* 1 = the texture is a height map */
    shd_fragment_fn fragment;
    int (*check)(struct course *course, const shd_framebuffer *frame); /* is this the picture it should be? */
};

/* Loads, renders, checks and saves; what main returns. */
int course_main(int argc, char **argv, const struct course_program *program);

/* A frame of the model in a material, lit by the course's lights where the material is a model, with its normals. */
shd_result course_render(const struct course *course, const shd_material_desc *material, uint32_t samples,
                         shd_framebuffer **out_frame);

/* A material that the program shades. */
shd_material_desc course_material(struct course *course, shd_fragment_fn fragment);

/* Puts a single black texel in the place of the texture: height 0 everywhere. */
shd_result course_flatten(struct course *course);

/* Largest difference of two frames over all channels; 1e9 where one of them cannot be read. */
double course_difference(const shd_framebuffer *a, const shd_framebuffer *b);

/* Texels at rows first .. first + count - 1, at most COURSE_ROWS, `du` and `dv` away from their place; NaN on failure,
   which fails the frame. Any thread: a program may look textures up. */
struct course_texels {
    float r[COURSE_ROWS], g[COURSE_ROWS], b[COURSE_ROWS];
};
void course_look_up(const struct course *course, const shd_fragments *in, size_t first, size_t count, float du,
                    float dv, struct course_texels *out);

/* Rows to shade at a time. */
static inline size_t course_rows(const shd_fragments *in, size_t first)
{
    return in->count - first < COURSE_ROWS ? in->count - first : COURSE_ROWS;
}

#endif /* SHD_EXAMPLES_COURSE_H */
