/* SPDX-License-Identifier: MIT */
/* A cage bends and twists a teapot of wood: mean value coordinates of the vertices in the cage, applied to the moved
   cage. The grain was evaluated before, so that it moves with the wood. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <shd/shd.h>
#ifdef EXAMPLE_HAS_IO
#include <shd/io.h>
#endif

enum { PARTS = 3, SIDE = PARTS + 1, TILE = 480, HEIGHT = 440 };
enum { CAGE_VERTICES = 6 * PARTS * PARTS + 2, CAGE_INDICES = 36 * PARTS * PARTS };

/* The surface of a box in PARTS x PARTS squares a side, as one closed mesh. */
struct cage {
    float rest[3][CAGE_VERTICES], moved[3][CAGE_VERTICES];
    uint32_t index[CAGE_INDICES];
};

/* Columns of the vertices: three points each, at the vertex and beside it along two tangents. */
struct pot {
    size_t count, index_count;
    float *position[3], *normal[3], *color[3], *deformed[3];
    uint32_t *index;
};

static uint8_t pixels[HEIGHT][2 * TILE][4];

/* Adds the two triangles of a square whose corners are lattice points, counter-clockwise from outside. */
static uint32_t *add_square(uint32_t *to, int number[SIDE][SIDE][SIDE], int axis, int side, int i, int k)
{
    static const int k_order[2][6] = {{0, 2, 3, 0, 3, 1}, {0, 1, 3, 0, 3, 2}};
    int n;
    for (n = 0; n < 6; ++n) {
        const int corner = k_order[side][n];
        int at[3];
        at[axis] = side * PARTS;
        at[(axis + 1) % 3] = i + corner % 2;
        at[(axis + 2) % 3] = k + corner / 2;
        *to++ = (uint32_t)number[at[0]][at[1]][at[2]];
    }
    return to;
}

/* Makes the cage around the box from low to high. The moved cage leans, and its layers turn. */
static void make_cage(const float low[3], const float high[3], struct cage *cage)
{
    int number[SIDE][SIDE][SIDE], n = 0, x, y, z, i;
    uint32_t *to = cage->index;
    for (x = 0; x < SIDE; ++x) {
        for (y = 0; y < SIDE; ++y) {
            for (z = 0; z < SIDE; ++z) {
                const int at[3] = {x, y, z};
                float place[3], up, angle;
                if (x % PARTS && y % PARTS && z % PARTS) continue; /* inside */
                for (i = 0; i < 3; ++i) place[i] = low[i] + (high[i] - low[i]) * (float)at[i] / PARTS;
                for (i = 0; i < 3; ++i) cage->rest[i][n] = place[i];
                up = (float)y / PARTS, angle = 0.9f * up;
                cage->moved[0][n] = cosf(angle) * place[0] + sinf(angle) * place[2] + 0.9f * up * up;
                cage->moved[1][n] = place[1] * (1.15f + 0.25f * (float)x / PARTS);
                cage->moved[2][n] = cosf(angle) * place[2] - sinf(angle) * place[0];
                number[x][y][z] = n++;
            }
        }
    }
    for (i = 0; i < 6; ++i) {
        for (x = 0; x < PARTS; ++x) {
            for (y = 0; y < PARTS; ++y) to = add_square(to, number, i / 2, i % 2, x, y);
        }
    }
}

static int allocate(struct pot *pot, const shd_shape_desc *shape)
{
    int c, good = shd_shape_count(shape, &pot->count, &pot->index_count) == SHD_OK;
    pot->index = (uint32_t *)malloc((pot->index_count + 1) * sizeof(uint32_t));
    for (c = 0; c < 3; ++c) {
        pot->position[c] = (float *)malloc((3 * pot->count + 1) * sizeof(float));
        pot->normal[c] = (float *)malloc((pot->count + 1) * sizeof(float));
        pot->color[c] = (float *)malloc((pot->count + 1) * sizeof(float));
        pot->deformed[c] = (float *)malloc((3 * pot->count + 1) * sizeof(float));
        good = good && pot->position[c] && pot->normal[c] && pot->color[c] && pot->deformed[c];
    }
    return good && pot->index;
}

static void release(struct pot *pot)
{
    int c;
    for (c = 0; c < 3; ++c) {
        free(pot->position[c]), free(pot->normal[c]), free(pot->color[c]), free(pot->deformed[c]);
    }
    free(pot->index);
}

/* The teapot, two more points beside each vertex, and the colours of the wood at the vertices. */
static int fill(shd_context *context, struct pot *pot, const shd_shape_desc *shape)
{
    static const float k_colors[2][4] = {{0.55f, 0.28f, 0.1f, 1}, {0.2f, 0.07f, 0.02f, 1}};
    shd_shape_columns columns = shd_shape_columns_default();
    shd_solid_desc wood = shd_solid_desc_default();
    shd_solid_points points = shd_solid_points_default();
    shd_solid_values values = shd_solid_values_default();
    size_t i;
    int c;
    columns.vertex_count = points.count = pot->count;
    columns.index_count = pot->index_count;
    columns.indices = shd_u32_out_column(pot->index, 0);
    wood.kind = SHD_SOLID_WOOD;
    wood.size = 0.3f, wood.distortion = 0.8f, wood.octaves = 5;
    wood.color_count = 2;
    for (c = 0; c < 4; ++c) wood.colors[0][c] = k_colors[0][c], wood.colors[1][c] = k_colors[1][c];
    for (c = 0; c < 3; ++c) {
        columns.position[c] = shd_f32_out_column(pot->position[c], 0);
        columns.normal[c] = shd_f32_out_column(pot->normal[c], 0);
        points.position[c] = shd_f32_column(pot->position[c], 0);
        values.channel[c] = shd_f32_out_column(pot->color[c], 0);
    }
    if (shd_shape_fill(shape, &columns) != SHD_OK) return 0;
    for (i = 0; i < pot->count; ++i) {
        const float n[3] = {pot->normal[0][i], pot->normal[1][i], pot->normal[2][i]};
        const float a[3] = {fabsf(n[0]) < 0.7f, fabsf(n[0]) >= 0.7f, 0}; /* an axis beside the normal */
        const float t[3] = {a[1] * n[2] - a[2] * n[1], a[2] * n[0] - a[0] * n[2], a[0] * n[1] - a[1] * n[0]};
        for (c = 0; c < 3; ++c) {
            const int d = (c + 1) % 3, e = (c + 2) % 3;
            pot->position[c][pot->count + i] = pot->position[c][i] + 0.01f * t[c];
            pot->position[c][2 * pot->count + i] = pot->position[c][i] + 0.01f * (n[d] * t[e] - n[e] * t[d]);
        }
    }
    return shd_solid_evaluate(context, &wood, &points, &values) == SHD_OK;
}

/* Moves all points with the cage: interpolates the positions of its vertices. */
static int deform(shd_context *context, const struct cage *cage, int moved, struct pot *pot)
{
    shd_polyhedron_desc desc = shd_polyhedron_desc_default();
    shd_polyhedron_points points = shd_polyhedron_points_default();
    shd_polyhedron_values values = shd_polyhedron_values_default();
    shd_polyhedron *polyhedron = NULL;
    shd_f32_in in[3];
    shd_f32_out out[3];
    shd_result result;
    size_t i;
    int c;
    desc.vertex_count = CAGE_VERTICES;
    desc.index_count = CAGE_INDICES;
    desc.indices = shd_u32_column(cage->index, 0);
    points.count = 3 * pot->count;
    values.value_count = 3;
    values.vertex_value = in;
    values.value = out;
    for (c = 0; c < 3; ++c) {
        desc.position[c] = shd_f32_column(cage->rest[c], 0);
        points.position[c] = shd_f32_column(pot->position[c], 0);
        in[c] = shd_f32_column(moved ? cage->moved[c] : cage->rest[c], 0);
        out[c] = shd_f32_out_column(pot->deformed[c], 0);
    }
    result = shd_polyhedron_create(context, &desc, &polyhedron);
    if (result == SHD_OK) result = shd_polyhedron_interpolate(polyhedron, &points, &values);
    shd_polyhedron_release(polyhedron);
    for (i = 0; result == SHD_OK && i < pot->count; ++i) {
        float s[3], t[3];
        for (c = 0; c < 3; ++c) {
            s[c] = pot->deformed[c][pot->count + i] - pot->deformed[c][i];
            t[c] = pot->deformed[c][2 * pot->count + i] - pot->deformed[c][i];
        }
        for (c = 0; c < 3; ++c) pot->normal[c][i] = s[(c + 1) % 3] * t[(c + 2) % 3] - s[(c + 2) % 3] * t[(c + 1) % 3];
    }
    return result == SHD_OK && values.outside_count == 0;
}

static shd_result create_mesh(shd_context *context, const struct pot *pot, shd_mesh **out)
{
    shd_mesh_desc desc = shd_mesh_desc_default();
    shd_f32_in colors[3];
    int c;
    desc.vertex_count = pot->count;
    desc.index_count = pot->index_count;
    desc.indices = shd_u32_column(pot->index, 0);
    desc.attributes = colors;
    desc.attribute_count = 3;
    for (c = 0; c < 3; ++c) {
        desc.position[c] = shd_f32_column(pot->deformed[c], 0);
        desc.normal[c] = shd_f32_column(pot->normal[c], 0);
        colors[c] = shd_f32_column(pot->color[c], 0);
    }
    return shd_mesh_create(context, &desc, out);
}

static shd_result create_cage_mesh(shd_context *context, const struct cage *cage, int moved, shd_mesh **out)
{
    shd_mesh_desc desc = shd_mesh_desc_default();
    int c;
    desc.flags = SHD_MESH_ADJACENCY;
    desc.vertex_count = CAGE_VERTICES;
    desc.index_count = CAGE_INDICES;
    desc.indices = shd_u32_column(cage->index, 0);
    for (c = 0; c < 3; ++c) desc.position[c] = shd_f32_column(moved ? cage->moved[c] : cage->rest[c], 0);
    return shd_mesh_create(context, &desc, out);
}

static shd_result create_materials(shd_context *context, shd_material **wood, shd_material **lines)
{
    const shd_slot grain = shd_slot_vertex(SHD_SLOT_DIFFUSE, 0);
    shd_material_desc desc = shd_material_desc_default();
    shd_result result;
    int c;
    desc.model = SHD_MODEL_BLINN_PHONG;
    for (c = 0; c < 3; ++c) desc.diffuse[c] = 1.0f, desc.specular[c] = 0.2f;
    desc.exponent = 60.0f;
    desc.slots = &grain;
    desc.slot_count = 1;
    result = shd_material_create(context, &desc, wood);
    if (result != SHD_OK) return result;
    desc = shd_material_desc_default();
    desc.model = SHD_MODEL_UNLIT;
    desc.diffuse[0] = 0.05f, desc.diffuse[1] = 0.25f, desc.diffuse[2] = 0.6f;
    return shd_material_create(context, &desc, lines);
}

/* Draws the teapot and the edges of its cage into one half of the picture. */
static shd_result render(shd_context *context, int tile, const shd_draw *draws, const shd_light *const *lights)
{
    shd_framebuffer_desc fd = shd_framebuffer_desc_default();
    shd_framebuffer *framebuffer = NULL;
    shd_camera camera = shd_camera_default();
    shd_render_desc rd = shd_render_desc_default();
    shd_image image = shd_image_default();
    shd_result result;
    fd.width = TILE, fd.height = HEIGHT, fd.sample_count = 8;
    result = shd_framebuffer_create(context, &fd, &framebuffer);
    camera.eye[0] = 3.0f, camera.eye[1] = 6.0f, camera.eye[2] = 15.0f;
    camera.target[0] = 0.5f, camera.target[1] = 1.7f;
    camera.fov_y = 0.5f;
    rd.framebuffer = framebuffer;
    rd.camera = &camera;
    rd.draws = draws, rd.draw_count = 2;
    rd.lights = lights, rd.light_count = 2;
    rd.clear_color[0] = rd.clear_color[1] = rd.clear_color[2] = rd.clear_color[3] = 1.0f;
    if (result == SHD_OK) result = shd_render(context, &rd);
    image.format = SHD_FORMAT_RGBA8_SRGB;
    image.width = TILE, image.height = HEIGHT;
    image.pixels = pixels[0][(size_t)tile * TILE];
    image.row_stride = sizeof pixels[0];
    if (result == SHD_OK) result = shd_framebuffer_read_color(framebuffer, &image);
    shd_framebuffer_release(framebuffer);
    return result;
}

/* Renders the teapot in its cage at rest, or moved. */
static int draw_half(shd_context *context, int moved, const struct cage *cage, struct pot *pot,
                     const shd_light *const *lights)
{
    shd_material *wood = NULL, *lines = NULL;
    shd_mesh *mesh = NULL, *edges = NULL;
    shd_draw draws[2];
    int good = deform(context, cage, moved, pot) && create_mesh(context, pot, &mesh) == SHD_OK &&
               create_cage_mesh(context, cage, moved, &edges) == SHD_OK &&
               create_materials(context, &wood, &lines) == SHD_OK;
    draws[0] = draws[1] = shd_draw_default();
    draws[0].mesh = mesh, draws[0].material = wood;
    draws[1].mesh = edges, draws[1].material = lines;
    draws[1].fill = SHD_FILL_LINES;
    draws[1].crease_cosine = 1.0f; /* flat edges, too */
    good = good && render(context, moved, draws, lights) == SHD_OK;
    shd_mesh_release(mesh);
    shd_mesh_release(edges);
    shd_material_release(wood);
    shd_material_release(lines);
    return good;
}

/* The cage at rest reproduces every point: linear precision. */
static int is_precise(const struct pot *pot)
{
    size_t i;
    int c;
    for (i = 0; i < 3 * pot->count; ++i) {
        for (c = 0; c < 3; ++c) {
            if (fabsf(pot->deformed[c][i] - pot->position[c][i]) > 2e-6f) return 0;
        }
    }
    return 1;
}

int main(void)
{
    static struct cage cage;
    struct pot pot = {0, 0, {NULL, NULL, NULL}, {NULL, NULL, NULL}, {NULL, NULL, NULL}, {NULL, NULL, NULL}, NULL};
    shd_context *context = NULL;
    shd_light *lights[2] = {NULL, NULL};
    shd_shape_desc shape = shd_shape_desc_default();
    shd_light_desc sun = shd_light_desc_default(), sky = shd_light_desc_default();
    float low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
    size_t i;
    int c, good;
    shape.kind = SHD_SHAPE_TEAPOT;
    shape.segments[0] = 40;
    sun.kind = SHD_LIGHT_KIND_DIRECTIONAL;
    sun.direction[0] = -0.6f, sun.direction[1] = -0.8f, sun.direction[2] = -0.5f;
    sky.kind = SHD_LIGHT_KIND_AMBIENT;
    for (c = 0; c < 3; ++c) sun.intensity[c] = 0.9f, sky.intensity[c] = 0.3f;
    good = shd_context_create(NULL, &context) == SHD_OK && allocate(&pot, &shape) && fill(context, &pot, &shape) &&
           shd_light_create(context, &sun, &lights[0]) == SHD_OK &&
           shd_light_create(context, &sky, &lights[1]) == SHD_OK;
    for (i = 0; good && i < pot.count; ++i) {
        for (c = 0; c < 3; ++c) {
            low[c] = fminf(low[c], pot.position[c][i] - 0.1f);
            high[c] = fmaxf(high[c], pot.position[c][i] + 0.1f);
        }
    }
    if (good) make_cage(low, high, &cage);
    good = good && draw_half(context, 0, &cage, &pot, (const shd_light *const *)lights) && is_precise(&pot) &&
           draw_half(context, 1, &cage, &pot, (const shd_light *const *)lights);
#ifdef EXAMPLE_HAS_IO
    if (good) {
        shd_image image = shd_image_default();
        image.format = SHD_FORMAT_RGBA8_SRGB;
        image.width = 2 * TILE, image.height = HEIGHT;
        image.pixels = pixels;
        good = shd_image_save(&image, "deform.png", NULL) == SHD_OK && printf("deform.png written\n") > 0;
    }
#endif
    if (!good) fprintf(stderr, "deform: wrong picture or error: %s\n", shd_last_error());
    for (c = 0; c < 2; ++c) shd_light_release(lights[c]);
    release(&pot);
    shd_context_release(context);
    return good ? 0 : 1;
}
