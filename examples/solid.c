/* SPDX-License-Identifier: MIT */
/* Solid textures of every kind, each on a sphere, in one picture: the pattern is a function of the place, so that the
   spheres need no texture coordinates. */
#include <stdio.h>

#include <shd/shd.h>
#ifdef EXAMPLE_HAS_IO
#include <shd/io.h>
#endif

enum { TILE = 180, COLUMNS = 4, ROWS = 2 };

static uint8_t pixels[ROWS * TILE][COLUMNS * TILE][4];

/* Two or three colours each. */
static const float palettes[][3][4] = {
    {{0.8f, 0.1f, 0.08f, 1}, {0.9f, 0.85f, 0.8f, 1}},                           /* stripes */
    {{0.02f, 0.02f, 0.03f, 1}, {0.8f, 0.8f, 0.75f, 1}},                         /* checker */
    {{0.1f, 0.25f, 0.7f, 1}, {0.9f, 0.9f, 0.95f, 1}},                           /* Perlin: clouds */
    {{0.02f, 0.1f, 0.02f, 1}, {0.3f, 0.55f, 0.1f, 1}},                          /* value */
    {{0.02f, 0.005f, 0, 1}, {0.9f, 0.2f, 0.01f, 1}, {1, 0.9f, 0.3f, 1}},        /* simplex: embers */
    {{0.6f, 0.9f, 0.85f, 1}, {0.02f, 0.2f, 0.3f, 1}},                           /* Worley: scales */
    {{0.03f, 0.05f, 0.06f, 1}, {0.45f, 0.5f, 0.5f, 1}, {0.9f, 0.9f, 0.85f, 1}}, /* marble */
    {{0.55f, 0.28f, 0.1f, 1}, {0.2f, 0.07f, 0.02f, 1}},                         /* wood */
};

static shd_solid_desc describe(shd_solid kind)
{
    shd_solid_desc desc = shd_solid_desc_default();
    uint32_t k;
    int c;
    desc.kind = kind;
    desc.color_count = palettes[kind][2][3] > 0 ? 3 : 2;
    for (k = 0; k < desc.color_count; ++k) {
        for (c = 0; c < 4; ++c) desc.colors[k][c] = palettes[kind][k][c];
    }
    desc.size = kind == SHD_SOLID_STRIPES || kind == SHD_SOLID_CHECKER ? 0.25f : 0.5f;
    desc.octaves = 6;
    if (kind == SHD_SOLID_SIMPLEX) desc.sum = SHD_SOLID_SUM_TURBULENCE;
    if (kind == SHD_SOLID_WORLEY) desc.octaves = 1, desc.size = 0.35f, desc.distance = SHD_SOLID_DISTANCE_F2_F1;
    if (kind == SHD_SOLID_PERLIN || kind == SHD_SOLID_VALUE) desc.range[0] = -0.6f, desc.range[1] = 0.6f;
    if (kind == SHD_SOLID_SIMPLEX) desc.range[1] = 0.7f;
    if (kind == SHD_SOLID_WORLEY) desc.range[1] = 0.25f;
    if (kind == SHD_SOLID_MARBLE) desc.distortion = 3.0f;
    if (kind == SHD_SOLID_WOOD) desc.size = 0.16f, desc.distortion = 0.8f;
    return desc;
}

/* A glossy sphere whose diffuse colour is a solid texture. */
static shd_result create_material(shd_context *context, shd_solid kind, shd_material **out)
{
    const shd_solid_desc solid = describe(kind);
    const shd_slot slot = shd_slot_solid(SHD_SLOT_DIFFUSE, &solid); /* copied by the material */
    shd_material_desc desc = shd_material_desc_default();
    int c;
    desc.model = SHD_MODEL_BLINN_PHONG;
    for (c = 0; c < 3; ++c) desc.diffuse[c] = 1.0f, desc.specular[c] = 0.25f;
    desc.exponent = 60.0f;
    desc.slots = &slot;
    desc.slot_count = 1;
    return shd_material_create(context, &desc, out);
}

static shd_result render(shd_context *context, shd_framebuffer *framebuffer, const shd_mesh *mesh,
                         const shd_light *const *lights, shd_solid kind)
{
    shd_material *material = NULL;
    shd_camera camera = shd_camera_default();
    shd_draw draw = shd_draw_default();
    shd_render_desc rd = shd_render_desc_default();
    shd_image image = shd_image_default();
    shd_result result = create_material(context, kind, &material);
    camera.eye[0] = 1.2f, camera.eye[1] = 1.0f, camera.eye[2] = 2.6f;
    camera.fov_y = 0.75f;
    draw.mesh = mesh;
    draw.material = material;
    rd.framebuffer = framebuffer;
    rd.camera = &camera;
    rd.draws = &draw;
    rd.draw_count = 1;
    rd.lights = lights;
    rd.light_count = 2;
    rd.clear_color[0] = rd.clear_color[1] = rd.clear_color[2] = 0.3f;
    rd.clear_color[3] = 1.0f;
    if (result == SHD_OK) result = shd_render(context, &rd);
    image.format = SHD_FORMAT_RGBA8_SRGB;
    image.width = image.height = TILE;
    image.pixels = pixels[kind / COLUMNS * TILE][kind % COLUMNS * TILE];
    image.row_stride = sizeof pixels[0];
    if (result == SHD_OK) result = shd_framebuffer_read_color(framebuffer, &image);
    shd_material_release(material);
    return result;
}

/* Each sphere has both dark and bright pixels around its centre. */
static int is_patterned(int kind)
{
    int low = 255, high = 0, x, y;
    for (y = TILE / 4; y < 3 * TILE / 4; ++y) {
        for (x = TILE / 4; x < 3 * TILE / 4; ++x) {
            const int green = pixels[kind / COLUMNS * TILE + y][kind % COLUMNS * TILE + x][1];
            if (green < low) low = green;
            if (green > high) high = green;
        }
    }
    return high - low > 60;
}

int main(void)
{
    shd_context *context = NULL;
    shd_mesh *mesh = NULL;
    shd_light *lights[2] = {NULL, NULL};
    shd_framebuffer *framebuffer = NULL;
    shd_framebuffer_desc fd = shd_framebuffer_desc_default();
    shd_light_desc sun = shd_light_desc_default(), sky = shd_light_desc_default();
    int kind, good;
    fd.width = fd.height = TILE;
    fd.sample_count = 8;
    sun.kind = SHD_LIGHT_KIND_DIRECTIONAL;
    sun.direction[0] = 0.4f, sun.direction[1] = -0.8f, sun.direction[2] = -0.6f;
    sky.kind = SHD_LIGHT_KIND_AMBIENT;
    for (kind = 0; kind < 3; ++kind) sun.intensity[kind] = 0.9f, sky.intensity[kind] = 0.25f;
    good = shd_context_create(NULL, &context) == SHD_OK &&
           shd_mesh_create_shape(context, NULL, SHD_MESH_NONE, &mesh) == SHD_OK &&
           shd_light_create(context, &sun, &lights[0]) == SHD_OK &&
           shd_light_create(context, &sky, &lights[1]) == SHD_OK &&
           shd_framebuffer_create(context, &fd, &framebuffer) == SHD_OK;
    for (kind = 0; good && kind <= SHD_SOLID_WOOD; ++kind) {
        good = render(context, framebuffer, mesh, (const shd_light *const *)lights, (shd_solid)kind) == SHD_OK &&
               is_patterned(kind);
    }
#ifdef EXAMPLE_HAS_IO
    if (good) {
        shd_image image = shd_image_default();
        image.format = SHD_FORMAT_RGBA8_SRGB;
        image.width = COLUMNS * TILE, image.height = ROWS * TILE;
        image.pixels = pixels;
        good = shd_image_save(&image, "solid.png", NULL) == SHD_OK && printf("solid.png written\n") > 0;
    }
#endif
    if (!good) fprintf(stderr, "solid: wrong picture or error: %s\n", shd_last_error());
    shd_framebuffer_release(framebuffer);
    shd_light_release(lights[1]);
    shd_light_release(lights[0]);
    shd_mesh_release(mesh);
    shd_context_release(context);
    return good ? 0 : 1;
}
