/* SPDX-License-Identifier: MIT */
#include "support/scene.h"

/** Position and contents of a draw. */
typedef struct shd_scene_placement {
    unsigned mesh, material;
    float scale[3], at[3];
    shd_frequency frequency;
    shd_cull cull;
} shd_scene_placement;

float shd_scene_random(uint32_t *state)
{
    shd_noise(state);
    return (float)(*state >> 8) * (1.0f / 16777216.0f);
}

void *shd_scene_memory(size_t size)
{
    void *memory = malloc(size);
    if (!memory) abort();
    return memory;
}

static shd_result shd_scene_get_texture(shd_scene *s, size_t which)
{
    static const shd_format k_format[SHD_SCENE_TEXTURES] = {SHD_FORMAT_RGBA8_SRGB, SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA32F,
                                                            SHD_FORMAT_R8};
    static const uint32_t k_width[SHD_SCENE_TEXTURES] = {61, 16, 7, 8}, k_height[SHD_SCENE_TEXTURES] = {37, 16, 5, 8};
    const size_t pixel = shd_format_size(k_format[which]);
    const size_t pixels = (size_t)k_width[which] * k_height[which];
    unsigned char *texels = (unsigned char *)shd_scene_memory(pixels * pixel);
    shd_texture_desc desc = shd_texture_desc_default();
    uint32_t seed = 77u + (uint32_t)which;
    shd_result result;
    size_t i;
    if (k_format[which] == SHD_FORMAT_RGBA32F) {
        for (i = 0; i < pixels * 4; ++i) ((float *)(void *)texels)[i] = 3.0f * shd_scene_random(&seed);
    } else {
        for (i = 0; i < pixels * pixel; ++i) texels[i] = (unsigned char)(255.0f * shd_scene_random(&seed));
    }
    desc.format = k_format[which];
    desc.width = k_width[which];
    desc.height = k_height[which];
    desc.texels = texels;
    desc.tables = which == 2 ? SHD_TABLE_NONE : SHD_TABLE_MIPMAP;
    if (which == 3) desc.tables |= SHD_TABLE_RIPMAP;
    result = shd_texture_create(s->context, &desc, &s->texture[which]);
    free(texels);
    return result;
}

static shd_result shd_scene_sampler(shd_scene *s, size_t which)
{
    static const shd_filter k_filter[SHD_SCENE_SAMPLERS] = {SHD_FILTER_TRILINEAR, SHD_FILTER_BILINEAR,
                                                            SHD_FILTER_NEAREST, SHD_FILTER_TRILINEAR};
    static const shd_wrap k_wrap[SHD_SCENE_SAMPLERS] = {SHD_WRAP_REPEAT, SHD_WRAP_MIRROR, SHD_WRAP_CLAMP,
                                                        SHD_WRAP_BORDER};
    shd_sampler_desc desc = shd_sampler_desc_default();
    desc.filter = k_filter[which];
    desc.wrap_u = k_wrap[which];
    desc.wrap_v = k_wrap[(which + 1) % SHD_SCENE_SAMPLERS];
    desc.border[0] = 0.25f;
    desc.border[3] = 1.0f;
    desc.lod_bias = which == 3 ? 0.5f : 0.0f;
    return shd_sampler_create(s->context, &desc, &s->sampler[which]);
}

void shd_scene_vertex(shd_scene_geometry *g, float x, float y, float z, float u, float v)
{
    float *out = g->vertices + 5 * (size_t)g->vertex_count++;
    out[0] = x;
    out[1] = y;
    out[2] = z;
    out[3] = u;
    out[4] = v;
}

/** Triangulates the latest (n + 1) x (n + 1) vertices as a grid. */
static void shd_scene_grid_indices(shd_scene_geometry *g, uint32_t n)
{
    const uint32_t first = g->vertex_count - (n + 1) * (n + 1);
    uint32_t x, y, k;
    for (y = 0; y < n; ++y) {
        for (x = 0; x < n; ++x) {
            const uint32_t a = first + y * (n + 1) + x;
            const uint32_t corner[6] = {a, a + 1, a + n + 2, a, a + n + 2, a + n + 1};
            for (k = 0; k < 6; ++k) g->indices[g->index_count++] = corner[k];
        }
    }
}

/** A unit sphere: a cube of n x n cells per side, with its vertices projected outwards. */
static void shd_scene_sphere(shd_scene_geometry *g, uint32_t n)
{
    uint32_t face, x, y;
    for (face = 0; face < 6; ++face) {
        for (y = 0; y <= n; ++y) {
            for (x = 0; x <= n; ++x) {
                const float a = 2.0f * (float)x / (float)n - 1.0f, b = 2.0f * (float)y / (float)n - 1.0f;
                const float side = face < 3 ? 1.0f : -1.0f;
                const float length = sqrtf(a * a + b * b + 1.0f);
                float p[3];
                p[face % 3] = side / length;
                p[(face + 1) % 3] = side * a / length;
                p[(face + 2) % 3] = b / length;
                shd_scene_vertex(g, p[0], p[1], p[2], 2.0f * (float)x / (float)n, (float)y / (float)n);
            }
        }
        shd_scene_grid_indices(g, n);
    }
}

void shd_scene_hills(shd_scene_geometry *g, uint32_t n)
{
    uint32_t seed = 5, x, y;
    for (y = 0; y <= n; ++y) {
        for (x = 0; x <= n; ++x) {
            const float a = 2.0f * (float)x / (float)n - 1.0f, b = 2.0f * (float)y / (float)n - 1.0f;
            shd_scene_vertex(g, a, 0.15f * shd_scene_random(&seed) - 0.3f * a * b, -b, a, b);
        }
    }
    shd_scene_grid_indices(g, n);
}

/** A plane y = 0 of half-width 1000, as one quad. */
static void shd_scene_plane(shd_scene_geometry *g)
{
    shd_scene_vertex(g, -1000.0f, 0.0f, 1000.0f, -500.0f, 500.0f);
    shd_scene_vertex(g, 1000.0f, 0.0f, 1000.0f, 500.0f, 500.0f);
    shd_scene_vertex(g, -1000.0f, 0.0f, -1000.0f, -500.0f, -500.0f);
    shd_scene_vertex(g, 1000.0f, 0.0f, -1000.0f, 500.0f, -500.0f);
    shd_scene_grid_indices(g, 1);
}

/** Separate triangles, every third with a non-finite vertex, some without area. */
static void shd_scene_broken(shd_scene_geometry *g, uint32_t triangles)
{
    uint32_t seed = 9, i, k;
    for (i = 0; i < triangles; ++i) {
        const float x = 4.0f * shd_scene_random(&seed) - 2.0f, y = 2.0f * shd_scene_random(&seed);
        for (k = 0; k < 3; ++k) {
            const float bad = k == i / 3 % 3 && i % 3 == 1 ? (i % 2 ? (float)NAN : (float)INFINITY) : 0.0f;
            const float spread = i % 5 == 4 ? 0.0f : 0.4f;
            const float dx = spread * shd_scene_random(&seed), dy = spread * shd_scene_random(&seed);
            shd_scene_vertex(g, x + dx, y + dy + bad, -1.0f - dx * dy, dx, dy);
            g->indices[g->index_count++] = g->vertex_count - 1;
        }
    }
}

static shd_result shd_scene_get_mesh(shd_scene *s, size_t which)
{
    const int small = s->kind == SHD_SCENE_SMALL;
    shd_scene_geometry g = {NULL, NULL, 0, 0};
    shd_mesh_desc desc = shd_mesh_desc_default();
    shd_result result;
    int c;
    g.vertices = (float *)shd_scene_memory(4096 * 5 * sizeof(float));
    g.indices = (uint32_t *)shd_scene_memory(16384 * sizeof(uint32_t));
    switch (which) {
        case 0: shd_scene_plane(&g); break;
        case 1: shd_scene_sphere(&g, small ? 2 : 8); break;
        case 2: shd_scene_hills(&g, small ? 3 : 28); break;
        default: shd_scene_broken(&g, small ? 9 : 60); break;
    }
    desc.vertex_count = g.vertex_count;
    for (c = 0; c < 5; ++c) {
        shd_f32_in *column = c < 3 ? &desc.position[c] : &desc.uv[c - 3];
        *column = shd_f32_column(g.vertices + c, 5 * sizeof(float));
        if (c < 3 && which == 1) desc.normal[c] = *column; /* the unit sphere is its own normal */
    }
    desc.indices.data = g.indices;
    desc.index_count = g.index_count;
    desc.normal_weight = SHD_NORMAL_WEIGHT_ANGLE;
    desc.flags = which == 3 ? SHD_MESH_KEEP_NONFINITE : SHD_MESH_NONE;
    if (s->kind == SHD_SCENE_LINES || s->kind == SHD_SCENE_SMALL) desc.flags |= SHD_MESH_ADJACENCY;
    if (s->kind == SHD_SCENE_SURFACE) {
        desc.flags |= which == 2 ? 0 : SHD_MESH_TANGENTS;
        desc.uv1[0] = desc.position[0];
        desc.uv1[1] = desc.position[2];
        desc.attributes = desc.position;
        desc.attribute_count = 3;
    }
    result = shd_mesh_create(s->context, &desc, &s->mesh[which]);
    free(g.vertices);
    free(g.indices);
    return result;
}

/** A program that moves vertices along their normals and outputs three varyings. */
static void shd_scene_wave(const shd_vertices *in, shd_vertex_outputs *out, void *user_data)
{
    size_t i;
    (void)user_data;
    for (i = 0; i < in->count; ++i) {
        const float push = 0.1f * (in->u[i] - in->v[i]) * in->v[i];
        float world[4], view[4], clip[4];
        int r;
        out->px[i] += push * out->nx[i];
        out->py[i] += push * out->ny[i];
        out->pz[i] += push * out->nz[i];
        out->nx[i] += push;
        world[0] = out->px[i];
        world[1] = out->py[i];
        world[2] = out->pz[i];
        world[3] = 1.0f;
        for (r = 0; r < 4; ++r) {
            const float *m = in->world_to_view + r;
            view[r] = m[0] * world[0] + m[4] * world[1] + m[8] * world[2] + m[12] * world[3];
        }
        for (r = 0; r < 4; ++r) {
            const float *m = in->view_to_clip + r;
            clip[r] = m[0] * view[0] + m[4] * view[1] + m[8] * view[2] + m[12] * view[3];
        }
        out->x[i] = clip[0];
        out->y[i] = clip[1];
        out->z[i] = clip[2];
        out->w[i] = clip[3];
        if (out->varying_count == 0) continue;
        out->varying[0][i] = in->px[i] + in->pz[i];
        out->varying[1][i] = in->u[i] * in->u[i];
        out->varying[2][i] = in->v[i];
    }
}

void shd_scene_program(const shd_fragments *in, shd_radiance *out, void *user_data)
{
    size_t i;
    (void)user_data;
    for (i = 0; i < in->count; ++i) {
        const float facing = in->nx[i] * in->ox[i] + in->ny[i] * in->oy[i] + in->nz[i] * in->oz[i];
        const float spread = in->dudx[i] + in->dvdx[i] + in->dudy[i] + in->dvdy[i];
        out->r[i] = facing * in->u[i] + 0.01f * in->px[i];
        out->g[i] = facing * in->v[i] + 0.01f * in->py[i] + 0.001f * (float)(in->triangle[i] % 7);
        out->b[i] = spread + 0.01f * in->pz[i] + 0.001f * (in->x[i] - in->y[i]) + in->depth[i];
        out->a[i] = 0.5f;
        if (in->varying_count == 0) continue;
        out->r[i] += 0.1f * in->varying[0][i];
        out->g[i] += 0.1f * in->varying[1][i];
        out->b[i] += 0.1f * in->varying[2][i];
    }
}

shd_slot *shd_scene_slot(shd_scene *s, shd_slot_list *slots, shd_material_desc *desc, shd_slot_target target,
                         size_t texture)
{
    shd_sampler *sampler = texture == 1 ? NULL : s->sampler[texture];
    return shd_slot_list_add(slots, desc, shd_slot_texture(target, s->texture[texture], sampler));
}

static void shd_scene_stripes(const shd_fragments *in, float *const out[4], void *user_data)
{
    size_t i;
    (void)user_data;
    for (i = 0; i < in->count; ++i) out[0][i] = in->px[i] * in->px[i] + in->u1[i];
}

/** Moments of slopes with a variance of at least 1/32 along u and 1/128 along v. */
static void shd_scene_moments(const shd_fragments *in, float *const out[4], void *user_data)
{
    size_t i;
    (void)user_data;
    for (i = 0; i < in->count; ++i) {
        const float x = 0.5f * in->u[i] - 0.25f, y = 0.5f - 0.5f * in->v[i];
        out[0][i] = x;
        out[1][i] = y;
        out[2][i] = x * x + 0.03125f + 0.25f * in->v[i];
        out[3][i] = y * y + 0.0078125f;
    }
}

/** Sets a constant k_a, that of the defaults without a texture. */
static void shd_scene_ambient(shd_material_desc *desc)
{
    desc->ambient[0] = desc->ambient[1] = desc->ambient[2] = 0.05f;
}

/** Materials of SHD_SCENE_SURFACE. */
static shd_result shd_scene_surface(shd_scene *s, size_t which)
{
    static const shd_model k_models[SHD_SCENE_MATERIALS] = {SHD_MODEL_METALLIC_ROUGHNESS,
                                                            SHD_MODEL_TOON,
                                                            SHD_MODEL_BLINN_PHONG_NORMALIZED,
                                                            SHD_MODEL_PHONG,
                                                            SHD_MODEL_GOOCH,
                                                            SHD_MODEL_COMBINED,
                                                            SHD_MODEL_PROGRAM,
                                                            SHD_MODEL_MATCAP,
                                                            SHD_MODEL_METALLIC_ROUGHNESS,
                                                            SHD_MODEL_BLINN_PHONG};
    shd_slot_list slots;
    shd_material_desc desc = shd_material_desc_default();
    slots.count = 0;
    desc.model = k_models[which];
    desc.flags = SHD_MATERIAL_DOUBLE_SIDED;
    desc.metallic = 0.4f;
    shd_scene_ambient(&desc);
    if (which == 0) {
        shd_scene_slot(s, &slots, &desc, SHD_SLOT_NORMAL, 0)->uv_set = 1;
        shd_scene_slot(s, &slots, &desc, SHD_SLOT_ROUGHNESS, 1)->channel = 1;
        shd_scene_slot(s, &slots, &desc, SHD_SLOT_OCCLUSION, 1)->channel = 2;
        shd_scene_slot(s, &slots, &desc, SHD_SLOT_DIFFUSE, 2)->uv_transform[1] = 0.5f;
        desc.normal_encoding = SHD_NORMAL_ENCODING_TOKSVIG;
    } else if (which == 2 || which == 3) {
        shd_scene_slot(s, &slots, &desc, SHD_SLOT_HEIGHT, which == 2 ? 2 : 0)->channel = (uint32_t)which - 2;
        desc.bump = which == 2 ? SHD_BUMP_TEXEL : SHD_BUMP_GRADIENT;
        desc.bump_scale = 0.25f;
    } else if (which == 5) {
        shd_scene_slot(s, &slots, &desc, SHD_SLOT_HEIGHT, 0);
        shd_scene_slot(s, &slots, &desc, SHD_SLOT_DIFFUSE, 0);
        desc.parallax_depth = 0.125f;
        desc.parallax_steps = 9;
    } else if (which == 6) {
        desc.program.fragment = shd_scene_program;
    } else if (which == 7) {
        shd_scene_slot(s, &slots, &desc, SHD_SLOT_MATCAP, 1);
        shd_scene_slot(s, &slots, &desc, SHD_SLOT_NORMAL, 2);
        desc.normal_encoding = SHD_NORMAL_ENCODING_MOMENTS;
    } else if (which >= 8) {
        shd_slot_list_add(&slots, &desc, shd_slot_procedure(SHD_SLOT_NORMAL, shd_scene_moments, NULL));
        shd_scene_slot(s, &slots, &desc, SHD_SLOT_NORMAL_MIXED, 3);
        desc.normal_encoding = SHD_NORMAL_ENCODING_MOMENTS;
        desc.roughness = 0.375f;
    }
    if (which == 1 || which == 4) {
        shd_slot_list_add(&slots, &desc, shd_slot_vertex(SHD_SLOT_DIFFUSE, 0));
        shd_slot_list_add(&slots, &desc, shd_slot_procedure(SHD_SLOT_EXPONENT, shd_scene_stripes, NULL));
        shd_slot_list_add(&slots, &desc, shd_slot_vertex(SHD_SLOT_EMISSION, 1));
        desc.emission[1] = 0.125f;
    }
    return shd_material_create(s->context, &desc, &s->material[which]);
}

static shd_result shd_scene_get_material(shd_scene *s, size_t which)
{
    static const shd_interpolation k_interpolation[3] = {SHD_INTERPOLATION_PERSPECTIVE, SHD_INTERPOLATION_AFFINE,
                                                         SHD_INTERPOLATION_FLAT};
    shd_slot_list slots;
    shd_material_desc desc = shd_material_desc_default();
    slots.count = 0;
    if (s->kind == SHD_SCENE_SURFACE) return shd_scene_surface(s, which);
    desc.model = which < 2 ? SHD_MODEL_LAMBERT : SHD_MODEL_BLINN_PHONG;
    desc.exponent = which == 2 ? 7.5f : 64.0f;
    if (which < SHD_SCENE_TEXTURES || which == 5) shd_scene_ambient(&desc);
    if (which < SHD_SCENE_TEXTURES) {
        shd_scene_slot(s, &slots, &desc, SHD_SLOT_DIFFUSE, which);
    } else if (which == 4) {
        desc.flags = SHD_MATERIAL_SPECULAR_UNGATED;
    } else if (which == 5) {
        desc.flags = SHD_MATERIAL_AMBIENT_PER_LIGHT;
        shd_slot_list_add(&slots, &desc, shd_slot_texture(SHD_SLOT_DIFFUSE, s->texture[0], s->sampler[1]));
    } else if (which == 6) {
        desc.model = SHD_MODEL_PROGRAM;
        desc.program.fragment = shd_scene_program;
    } else {
        desc.model = SHD_MODEL_LAMBERT;
    }
    if (s->kind >= SHD_SCENE_GLASS) {
        desc.blend = (shd_blend)(which % (SHD_BLEND_SORTED + 1));
        desc.opacity = 0.6f;
        desc.alpha_cutoff = which == 1 ? 0.3f : 0.0f;
        if (which == 4) desc.flags |= SHD_MATERIAL_ALPHA_TO_COVERAGE;
    }
    desc.program.vertex = s->vertex;
    if (s->kind == SHD_SCENE_MOVED || (s->kind == SHD_SCENE_SMALL && which == 6)) {
        desc.program.vertex = shd_scene_wave;
        desc.varying_count = 3;
        desc.interpolation = k_interpolation;
    }
    return shd_material_create(s->context, &desc, &s->material[which]);
}

static shd_result shd_scene_get_light(shd_scene *s, size_t which)
{
    shd_light_desc desc = shd_light_desc_default();
    desc.kind = which == 0 ? SHD_LIGHT_KIND_AMBIENT : which == 1 ? SHD_LIGHT_KIND_DIRECTIONAL : SHD_LIGHT_KIND_POINT;
    desc.position[0] = which == 2 ? 2.0f : -1.5f;
    desc.position[1] = which == 2 ? 3.0f : 1.0f;
    desc.position[2] = 1.0f;
    desc.direction[0] = 0.3f;
    desc.direction[2] = -0.6f;
    desc.intensity[0] = which == 2 ? 9.0f : 0.7f;
    desc.intensity[1] = which == 3 ? 2.0f : 0.5f;
    if (s->kind == SHD_SCENE_SURFACE) {
        if (which == 1) desc.extent[0] = 3.0f;
        if (which == 2) desc.kind = SHD_LIGHT_KIND_SPOT;
        if (which == 2) desc.direction[2] = -0.5f;
        if (which == 1 || which == 2) desc.texture = s->texture[which];
        if (which == 3) desc.range = 3.5f;
    }
    return shd_light_create(s->context, &desc, &s->light[which]);
}

static shd_result shd_scene_framebuffer(shd_scene *s)
{
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    desc.width = s->kind == SHD_SCENE_SMALL ? 100 : 203;
    desc.height = s->kind == SHD_SCENE_SMALL ? 70 : 151;
    desc.sample_count = s->kind == SHD_SCENE_SMALL                                 ? 2
                        : s->kind == SHD_SCENE_GLASS || s->kind == SHD_SCENE_LINES ? 4
                                                                                   : 1;
    desc.aovs = SHD_AOV_UV | SHD_AOV_NORMAL | SHD_AOV_TRIANGLE;
    if (s->kind == SHD_SCENE_SMALL || s->kind == SHD_SCENE_FLOOR) desc.aovs = 2 * SHD_AOV_OVERDRAW - 1;
    return shd_framebuffer_create(s->context, &desc, &s->framebuffer);
}

shd_result shd_scene_step(shd_scene *s, size_t step)
{
    if (step < SHD_SCENE_TEXTURES) return shd_scene_get_texture(s, step);
    step -= SHD_SCENE_TEXTURES;
    if (step < SHD_SCENE_SAMPLERS) return shd_scene_sampler(s, step);
    step -= SHD_SCENE_SAMPLERS;
    if (step < SHD_SCENE_MESHES) return shd_scene_get_mesh(s, step);
    step -= SHD_SCENE_MESHES;
    if (step < SHD_SCENE_MATERIALS) return shd_scene_get_material(s, step);
    step -= SHD_SCENE_MATERIALS;
    if (step < SHD_SCENE_LIGHTS) return shd_scene_get_light(s, step);
    return shd_scene_framebuffer(s);
}

static void shd_scene_place(shd_scene *s, const shd_scene_placement *p)
{
    shd_draw *draw = &s->draw[s->desc.draw_count++];
    int c;
    *draw = shd_draw_default();
    draw->mesh = s->mesh[p->mesh];
    draw->material = s->material[p->material];
    draw->frequency = p->frequency;
    draw->cull = p->cull;
    for (c = 0; c < 3; ++c) {
        draw->object_to_world[5 * c] = p->scale[c];
        draw->object_to_world[12 + c] = p->at[c];
    }
}

/** Turns draws into lines of every kind, width and depth state. */
static void shd_scene_draw_lines(shd_scene *s, size_t first, size_t step)
{
    size_t i;
    for (i = first; i < s->desc.draw_count; i += step) {
        s->draw[i].fill = SHD_FILL_LINES;
        s->draw[i].fill_width = 0.5f * (float)(i + 1);
        s->draw[i].edges = i % 4 == 3 ? SHD_EDGE_SILHOUETTE : SHD_EDGE_ALL;
        s->draw[i].crease_cosine = i % 2 ? 0.9f : 0.98f;
        if (i % 4 == 1) s->draw[i].compare = SHD_COMPARE_LESS_EQUAL;
    }
}

void shd_scene_compose(shd_scene *s)
{
    static const shd_scene_placement k_mixed[SHD_SCENE_DRAWS] = {
        {0, 0, {1, 1, 1}, {0, -1, 0}, SHD_FREQUENCY_PHONG, SHD_CULL_NONE},
        {1, 3, {1, 1, 1}, {-1, 0, -1}, SHD_FREQUENCY_PHONG, SHD_CULL_BACK},
        {1, 2, {0.7f, 1.2f, 0.5f}, {1.2f, 0, 0}, SHD_FREQUENCY_GOURAUD, SHD_CULL_NONE},
        {1, 4, {-0.5f, 0.5f, 0.5f}, {0, 1, -0.5f}, SHD_FREQUENCY_GOURAUD, SHD_CULL_BACK},
        {2, 1, {2, 1, 2}, {0, -0.8f, -3}, SHD_FREQUENCY_FLAT, SHD_CULL_BACK},
        {1, 6, {0.4f, 0.4f, 0.4f}, {0.2f, 0.1f, 1}, SHD_FREQUENCY_PHONG, SHD_CULL_NONE},
        {2, 6, {0.5f, 0.5f, 0.5f}, {-1.5f, 1, -1}, SHD_FREQUENCY_FLAT, SHD_CULL_NONE},
        {1, 6, {0.3f, 0.3f, 0.3f}, {1.4f, 1.2f, 0}, SHD_FREQUENCY_GOURAUD, SHD_CULL_FRONT},
        {3, 5, {1, 1, 1}, {0, 0, 0}, SHD_FREQUENCY_PHONG, SHD_CULL_NONE},
        {1, 7, {0.4f, 0.4f, 0.4f}, {0.5f, 0.4f, 2.75f}, SHD_FREQUENCY_PHONG, SHD_CULL_NONE},
        {1, 8, {0.4f, 0.4f, 0.4f}, {-0.9f, -0.45f, 0.5f}, SHD_FREQUENCY_PHONG, SHD_CULL_BACK},
        {1, 9, {0.3f, 0.3f, 0.3f}, {0.3f, -0.35f, 1}, SHD_FREQUENCY_GOURAUD, SHD_CULL_BACK},
    };
    static const shd_scene_placement k_lit[3] = {
        {1, 4, {1, 1, 1}, {-1.2f, 0, -1}, SHD_FREQUENCY_PHONG, SHD_CULL_BACK},
        {1, 4, {1, 1, 1}, {1.2f, 0, -1}, SHD_FREQUENCY_GOURAUD, SHD_CULL_BACK},
        {2, 4, {3, 1, 3}, {0, -1, -1}, SHD_FREQUENCY_FLAT, SHD_CULL_NONE},
    };
    const int is_floor = s->kind == SHD_SCENE_FLOOR, is_lit = s->kind == SHD_SCENE_LIT;
    const size_t count = is_floor ? 1 : is_lit ? 3 : s->kind == SHD_SCENE_SURFACE ? SHD_SCENE_DRAWS : 10;
    shd_camera camera = shd_camera_default();
    size_t i;
    s->desc = shd_render_desc_default();
    camera.eye[1] = is_floor ? 0.2f : 0.5f;
    camera.aspect = 4.0f / 3.0f;
    shd_assert_ok(shd_view_from_camera(&camera, &s->desc.view));
    for (i = 0; i < count; ++i) shd_scene_place(s, is_lit ? &k_lit[i] : &k_mixed[i]);
    if (s->kind >= SHD_SCENE_GLASS) {
        s->draw[1].compare = SHD_COMPARE_LESS_EQUAL;
        s->draw[2].depth_bias = -0.001f;
        s->draw[3].depth_bias_slope = 0.5f;
        s->draw[7].flags = SHD_DRAW_SAMPLE_SHADING;
        s->draw[8].flags = SHD_DRAW_KEEP_DEPTH;
    }
    if (s->kind == SHD_SCENE_LINES) shd_scene_draw_lines(s, 1, 1);
    if (s->kind == SHD_SCENE_SMALL) shd_scene_draw_lines(s, 6, 9);
    s->desc.framebuffer = s->framebuffer;
    s->desc.draws = s->draw;
    s->desc.lights = (const shd_light *const *)s->light;
    s->desc.light_count = SHD_SCENE_LIGHTS;
    s->desc.clear_color[2] = 0.25f;
    s->desc.clear_color[3] = 1.0f;
    s->stats = shd_render_stats_default();
    s->desc.stats = &s->stats;
}

void shd_scene_open(shd_scene *s, shd_scene_kind kind, shd_context *context)
{
    size_t step;
    memset(s, 0, sizeof *s);
    s->kind = kind;
    s->context = context;
    for (step = 0; step < SHD_SCENE_STEPS; ++step) shd_assert_ok(shd_scene_step(s, step));
    shd_scene_compose(s);
}

void shd_scene_close(shd_scene *s)
{
    size_t i;
    for (i = 0; i < SHD_SCENE_TEXTURES; ++i) shd_texture_release(s->texture[i]);
    for (i = 0; i < SHD_SCENE_SAMPLERS; ++i) shd_sampler_release(s->sampler[i]);
    for (i = 0; i < SHD_SCENE_MESHES; ++i) shd_mesh_release(s->mesh[i]);
    for (i = 0; i < SHD_SCENE_MATERIALS; ++i) shd_material_release(s->material[i]);
    for (i = 0; i < SHD_SCENE_LIGHTS; ++i) shd_light_release(s->light[i]);
    shd_framebuffer_release(s->framebuffer);
    memset(s, 0, sizeof *s);
}

uint64_t shd_hash_framebuffer(const shd_framebuffer *framebuffer)
{
    uint64_t hash = SHD_HASH_START;
    shd_framebuffer_info info = shd_framebuffer_info_default();
    int plane;
    shd_assert_ok(shd_framebuffer_get_info(framebuffer, &info));
    for (plane = SHD_PLANE_R; plane <= SHD_PLANE_TARGET3_A; ++plane) {
        shd_plane_view view = shd_plane_view_default();
        uint32_t x, y;
        if (shd_framebuffer_view_plane(framebuffer, (shd_plane)plane, &view) != SHD_OK) continue;
        for (y = 0; y < info.height; ++y) {
            const char *row = (view.f32 ? (const char *)view.f32 : (const char *)view.u32) + y * view.row_stride;
            for (x = 0; x < info.width; ++x) {
                uint32_t bits;
                memcpy(&bits, row + 4 * (size_t)x, sizeof bits);
                if (view.f32 && (bits & 0x7fffffffu) > 0x7f800000u) bits = 0x7fc00000u;
                hash = shd_hash(hash, &bits, sizeof bits);
            }
        }
    }
    return hash;
}

uint64_t shd_hash_stats(uint64_t hash, const shd_render_stats *stats)
{
    const size_t begin = offsetof(shd_render_stats, triangle_count),
                 end = offsetof(shd_render_stats, hidden_sample_count);
    const uint64_t rare[3] = {stats->hidden_sample_count, stats->order_conflict_count, stats->split_count};
    hash = shd_hash(hash, (const unsigned char *)stats + begin, end - begin);
    return rare[0] | rare[1] | rare[2] ? shd_hash(hash, rare, sizeof rare) : hash;
}

uint64_t shd_scene_render(shd_scene *s)
{
    memset(&s->stats, 0xee, sizeof s->stats);
    s->stats.struct_size = sizeof s->stats;
    shd_assert_ok(shd_render(s->context, &s->desc));
    return shd_hash_stats(shd_hash_framebuffer(s->framebuffer), &s->stats);
}

uint64_t shd_scene_reference(shd_scene_kind kind)
{
    shd_context_desc desc = shd_context_desc_default();
    shd_context *context = NULL;
    shd_scene scene;
    uint64_t hash;
    desc.worker_count = 1;
    shd_assert_ok(shd_context_create(&desc, &context));
    shd_scene_open(&scene, kind, context);
    hash = shd_scene_render(&scene);
    shd_scene_close(&scene);
    shd_context_release(context);
    return hash;
}
