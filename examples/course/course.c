/* SPDX-License-Identifier: MIT */
#include "course.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#ifdef EXAMPLE_HAS_IO
#include <shd/io.h>
#endif

enum { RELIEF = 512 };

/* Turns the model and scales it about its own origin; or centres it at 0 and scales it to fill the picture. */
static void place(const struct course_options *options, const shd_mesh_info *info, float m[16])
{
    const float turn = options->angle * 0.0174532925f;
    float scale = 0.0f, center[3];
    int c;
    for (c = 0; c < 3; ++c) {
        const float half = 0.5f * (info->bounds_max[c] - info->bounds_min[c]);
        center[c] = info->bounds_min[c] + half;
        scale = fmaxf(scale, half);
    }
    scale = scale > 0.0f ? 2.9f / scale : 1.0f;
    if (options->scale > 0.0f) {
        scale = options->scale;
        center[0] = center[1] = center[2] = 0.0f;
    }
    memset(m, 0, 16 * sizeof *m);
    m[0] = m[10] = scale * cosf(turn), m[8] = scale * sinf(turn), m[2] = -m[8];
    m[5] = scale, m[15] = 1.0f;
    for (c = 0; c < 3; ++c) m[12 + c] = -(m[c] * center[0] + m[4 + c] * center[1] + m[8 + c] * center[2]);
}

/* Tables that the filter reads. */
static shd_table_flags tables_of(shd_filter filter)
{
    if (filter == SHD_FILTER_RIPMAP) return SHD_TABLE_MIPMAP | SHD_TABLE_RIPMAP;
    if (filter == SHD_FILTER_SUMMED_AREA) return SHD_TABLE_MIPMAP | SHD_TABLE_SUMMED_AREA;
    return SHD_TABLE_MIPMAP;
}

static shd_result create_mesh(struct course *course, const struct course_model *model)
{
    shd_mesh_desc desc = shd_mesh_desc_default();
    shd_mesh_info info = shd_mesh_info_default();
    shd_result result;
    int c;
    desc.vertex_count = model->vertex_count;
    for (c = 0; c < 3; ++c) {
        desc.position[c] = shd_f32_column(model->position + c, 3 * sizeof(float));
        desc.normal[c] = shd_f32_column(model->normal + c, 3 * sizeof(float));
    }
    for (c = 0; c < 2; ++c) desc.uv[c] = shd_f32_column(model->uv + c, 2 * sizeof(float));
    desc.indices = shd_u32_column(model->indices, 0);
    desc.index_count = model->index_count;
    result = shd_mesh_create(course->context, &desc, &course->mesh);
    if (result == SHD_OK) result = shd_mesh_get_info(course->mesh, &info);
    if (result == SHD_OK) place(&course->options, &info, course->object_to_world);
    return result;
}

/* Bumps on a grid: as a height map, or as colours. */
static shd_result create_pattern(struct course *course, int relief)
{
    static uint8_t pixels[RELIEF][RELIEF][4];
    shd_texture_desc desc = shd_texture_desc_default();
    int x, y;
    for (y = 0; y < RELIEF; ++y) {
        for (x = 0; x < RELIEF; ++x) {
            const float wave = 6.28318531f * 12.0f / RELIEF;
            const float height = sinf(wave * ((float)x + 0.5f)) * sinf(wave * ((float)y + 0.5f));
            pixels[y][x][0] = (uint8_t)(128.0f + 100.0f * height);
            pixels[y][x][1] = relief ? pixels[y][x][0] : (uint8_t)(140.0f - 40.0f * height);
            pixels[y][x][2] = relief ? pixels[y][x][0] : 90;
            pixels[y][x][3] = 255;
        }
    }
    desc.format = SHD_FORMAT_RGBA8; /* the stored numbers: see course.h */
    desc.width = desc.height = RELIEF;
    desc.texels = pixels;
    desc.tables = tables_of(course->options.filter);
    return shd_texture_create(course->context, &desc, &course->texture);
}

static shd_result create_texture(struct course *course, const char *path, int relief)
{
    shd_result result;
    shd_texture_info info = shd_texture_info_default();
#ifdef EXAMPLE_HAS_IO
    shd_load_desc desc = shd_load_desc_default();
    desc.encoding = SHD_COLOR_ENCODING_LINEAR; /* the stored numbers: see course.h */
    desc.tables = tables_of(course->options.filter);
    result = *path ? shd_texture_load(course->context, path, &desc, &course->texture) : create_pattern(course, relief);
#else
    (void)path;
    result = create_pattern(course, relief);
#endif
    if (result == SHD_OK) result = shd_texture_get_info(course->texture, &info);
    if (result == SHD_OK) course->texels_u = (float)info.width, course->texels_v = (float)info.height;
    return result;
}

shd_result course_flatten(struct course *course)
{
    static const uint8_t black[4] = {0, 0, 0, 255};
    shd_texture_desc desc = shd_texture_desc_default();
    desc.format = SHD_FORMAT_RGBA8;
    desc.width = desc.height = 1;
    desc.texels = black;
    desc.tables = tables_of(course->options.filter);
    shd_texture_release(course->texture);
    course->texture = NULL;
    return shd_texture_create(course->context, &desc, &course->texture);
}

void course_look_up(const struct course *course, const shd_fragments *in, size_t first, size_t count, float du,
                    float dv, struct course_texels *out)
{
    float u[COURSE_ROWS], v[COURSE_ROWS];
    shd_lookups where = shd_lookups_default();
    shd_texels texels = {0};
    size_t i;
    for (i = 0; i < count; ++i) u[i] = in->u[first + i] + du, v[i] = in->v[first + i] + dv;
    where.count = count;
    where.u.data = u, where.v.data = v;
    where.dudx.data = in->dudx + first, where.dvdx.data = in->dvdx + first;
    where.dudy.data = in->dudy + first, where.dvdy.data = in->dvdy + first;
    texels.channel[0].data = out->r, texels.channel[1].data = out->g, texels.channel[2].data = out->b;
    if (shd_texture_sample(course->texture, course->sampler, &where, &texels) != SHD_OK) {
        for (i = 0; i < count; ++i) out->r[i] = out->g[i] = out->b[i] = NAN;
    }
}

shd_material_desc course_material(struct course *course, shd_fragment_fn fragment)
{
    shd_material_desc desc = shd_material_desc_default();
    desc.model = SHD_MODEL_PROGRAM;
    desc.program.fragment = fragment;
    desc.program.user_data = course;
    return desc;
}

/* The lamps, and the ambient light behind them. */
static shd_result create_lights(const struct course *course, shd_light *lights[COURSE_LAMPS + 1])
{
    const struct shading *shading = &course->options.shading;
    shd_result result = SHD_OK;
    int i, c;
    for (i = 0; i <= shading->lamp_count && result == SHD_OK; ++i) {
        shd_light_desc desc = shd_light_desc_default();
        const struct lamp *lamp = &shading->lamps[i];
        if (i == shading->lamp_count) {
            desc.kind = SHD_LIGHT_KIND_AMBIENT;
            for (c = 0; c < 3; ++c) desc.intensity[c] = shading->ambient_light;
        } else {
            if (lamp->cone > 0.0f) desc.kind = SHD_LIGHT_KIND_SPOT, desc.outer_angle = lamp->cone;
            for (c = 0; c < 3; ++c) {
                desc.intensity[c] = lamp->intensity;
                desc.position[c] = lamp->position[c], desc.direction[c] = -lamp->position[c];
            }
        }
        result = shd_light_create(course->context, &desc, &lights[i]);
    }
    return result;
}

shd_result course_render(const struct course *course, const shd_material_desc *material_desc, uint32_t samples,
                         shd_framebuffer **out_frame)
{
    shd_light *lights[COURSE_LAMPS + 1] = {NULL};
    shd_material *material = NULL;
    shd_framebuffer_desc fd = shd_framebuffer_desc_default();
    shd_camera camera = shd_camera_default();
    shd_render_desc rd = shd_render_desc_default();
    shd_draw draw = shd_draw_default();
    shd_render_stats stats = shd_render_stats_default();
    shd_result result = create_lights(course, lights);
    int i;
    fd.width = fd.height = course->options.size, fd.sample_count = samples;
    fd.aovs = SHD_AOV_NORMAL;
    camera.fov_y = 0.785398163f;
    memcpy(camera.eye, k_eye, sizeof camera.eye);
    if (result == SHD_OK) result = shd_material_create(course->context, material_desc, &material);
    if (result == SHD_OK) result = shd_framebuffer_create(course->context, &fd, out_frame);
    if (result == SHD_OK) result = shd_view_from_camera(&camera, &rd.view);
    draw.mesh = course->mesh, draw.material = material;
    memcpy(draw.object_to_world, course->object_to_world, sizeof draw.object_to_world);
    rd.framebuffer = *out_frame;
    rd.draws = &draw, rd.draw_count = 1;
    rd.lights = (const shd_light *const *)lights, rd.light_count = (size_t)course->options.shading.lamp_count + 1;
    rd.stats = &stats;
    if (result == SHD_OK) result = shd_render(course->context, &rd);
    if (result == SHD_OK && (stats.fragment_count == 0 || stats.nonfinite_fragment_count > 0)) {
        fprintf(stderr, "course: %llu fragments, %llu of them not finite\n", (unsigned long long)stats.fragment_count,
                (unsigned long long)stats.nonfinite_fragment_count);
        result = SHD_ERROR_INTERNAL;
    }
    shd_material_release(material);
    for (i = 0; i <= COURSE_LAMPS; ++i) shd_light_release(lights[i]);
    return result;
}

double course_brightness(const shd_framebuffer *frame)
{
    shd_framebuffer_info info = shd_framebuffer_info_default();
    shd_plane_view green = shd_plane_view_default(), alpha = shd_plane_view_default();
    double sum = 0.0, covered = 0.0;
    size_t x, y;
    if (shd_framebuffer_get_info(frame, &info) != SHD_OK ||
        shd_framebuffer_view_plane(frame, SHD_PLANE_G, &green) != SHD_OK ||
        shd_framebuffer_view_plane(frame, SHD_PLANE_A, &alpha) != SHD_OK) {
        return 0.0;
    }
    for (y = 0; y < info.height; ++y) {
        for (x = 0; x < info.width; ++x) {
            sum += (double)green.f32[y * (green.row_stride / sizeof(float)) + x];
            covered += (double)alpha.f32[y * (alpha.row_stride / sizeof(float)) + x];
        }
    }
    return covered > 0.0 ? sum / covered : 0.0;
}

double course_difference(const shd_framebuffer *a, const shd_framebuffer *b)
{
    shd_framebuffer_info info = shd_framebuffer_info_default();
    double largest = 0.0;
    size_t x, y;
    int c;
    if (shd_framebuffer_get_info(a, &info) != SHD_OK) return 1e9;
    for (c = 0; c < 4; ++c) {
        shd_plane_view p = shd_plane_view_default(), q = shd_plane_view_default();
        if (shd_framebuffer_view_plane(a, (shd_plane)(SHD_PLANE_R + c), &p) != SHD_OK ||
            shd_framebuffer_view_plane(b, (shd_plane)(SHD_PLANE_R + c), &q) != SHD_OK) {
            return 1e9;
        }
        for (y = 0; y < info.height; ++y) {
            for (x = 0; x < info.width; ++x) {
                const double have = (double)p.f32[y * (p.row_stride / sizeof(float)) + x];
                const double want = (double)q.f32[y * (q.row_stride / sizeof(float)) + x];
                const double d = fabs(have - want) / fmax(1.0, fabs(want));
                if (!(d <= largest)) largest = d;
            }
        }
    }
    return largest;
}

/* Saves the picture with four samples per pixel. Its numbers are already encoded. */
static shd_result save(struct course *course, const struct course_program *program, const char *path)
{
    const shd_material_desc material = course_material(course, program->fragment);
    shd_framebuffer *frame = NULL;
    shd_result result = course_render(course, &material, 4, &frame);
#ifdef EXAMPLE_HAS_IO
    shd_save_desc desc = shd_save_desc_default();
    desc.encoding = SHD_COLOR_ENCODING_DATA;
    if (result == SHD_OK) result = shd_framebuffer_save(frame, path, &desc);
    if (result == SHD_OK) printf("%s: %s written\n", program->name, path);
#else
    if (result == SHD_OK) printf("%s: rendered; %s is not written without libshd_io\n", program->name, path);
#endif
    shd_framebuffer_release(frame);
    return result;
}

/* Makes what a program needs, renders, saves and checks. */
static int run(struct course *course, const struct course_model *model, const struct course_program *program)
{
    const struct course_options *options = &course->options;
    const shd_material_desc material = course_material(course, program->fragment);
    shd_sampler_desc sampler = shd_sampler_desc_default();
    shd_framebuffer *frame = NULL;
    char picture[64];
    int good = 0;
    sampler.filter = options->filter;
    snprintf(picture, sizeof picture, "%s.png", program->name);
    if (shd_context_create(NULL, &course->context) == SHD_OK && create_mesh(course, model) == SHD_OK &&
        create_texture(course, options->texture ? options->texture : model->texture, program->relief) == SHD_OK &&
        shd_sampler_create(course->context, &sampler, &course->sampler) == SHD_OK &&
        course_render(course, &material, 1, &frame) == SHD_OK &&
        save(course, program, options->picture ? options->picture : picture) == SHD_OK) {
        good = program->check(course, frame);
        if (!good) fprintf(stderr, "%s: the picture is not what it should be\n", program->name);
    } else if (*shd_last_error()) {
        fprintf(stderr, "%s: %s\n", program->name, shd_last_error());
    }
    shd_framebuffer_release(frame);
    return good;
}

int course_main(int argc, char **argv, const struct course_program *program)
{
    struct course course;
    struct course_model model = {0, NULL, NULL, NULL, NULL, 0, ""};
    const char *path;
    int code;
    memset(&course, 0, sizeof course);
    code = course_parse(argc, argv, program->name, &course.options);
    if (code >= 0) return code;
    path = course.options.model ? course.options.model : course_default_model(program->relief);
    if (course_model_create(path, &model)) {
        code = run(&course, &model, program) ? 0 : 1;
    } else {
        fprintf(stderr, "%s: no triangles from %s\n", program->name, path);
        code = 1;
    }
    shd_sampler_release(course.sampler);
    shd_texture_release(course.texture);
    shd_mesh_release(course.mesh);
    shd_context_release(course.context);
    course_model_release(&model);
    return code;
}
