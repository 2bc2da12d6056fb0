/* SPDX-License-Identifier: MIT */
/* Each allocation of calls about directions, polygons and polyhedra fails in turn, as in api.call_faults. */
#include "support/call_stage.h"

enum { PIXELS = 16 * 8 };

/* A small image of latitude and longitude, of the texels of the stage. */
static shd_image sky(struct stage *s)
{
    shd_image image = shd_image_default();
    image.format = SHD_FORMAT_RGBA8;
    image.width = 16;
    image.height = 8;
    image.pixels = s->texels;
    return image;
}

static shd_result make_environment(struct stage *s, shd_irradiance irradiance, shd_environment_table_flags tables,
                                   shd_environment **out)
{
    const shd_image image = sky(s);
    shd_environment_desc desc = shd_environment_desc_default();
    desc.image = &image;
    desc.irradiance = irradiance;
    desc.tables = tables;
    return shd_environment_create(s->context, &desc, out);
}

/* The irradiance, and the radiance of a lobe where there is a table of lobes. */
static shd_result environment(struct stage *s, shd_irradiance irradiance, shd_environment_table_flags tables)
{
    shd_environment_lookups lookups = shd_environment_lookups_default();
    shd_environment_values light = shd_environment_values_default();
    shd_environment *made = (shd_environment *)s;
    const shd_result result = make_environment(s, irradiance, tables, &made);
    if (result != SHD_OK) {
        assert_null(made);
        return result;
    }
    lookups.count = 500;
    lookups.direction[0].data = s->columns[3];
    lookups.direction[1].data = s->columns[3] + 7;
    lookups.direction[2].data = s->columns[3] + 11;
    light.channel[0].data = s->columns[0];
    light.channel[2].data = s->columns[1];
    shd_assert_ok(shd_environment_sample_irradiance(made, &lookups, &light));
    s->hash = shd_hash(SHD_HASH_START, s->columns[0], 500 * sizeof(float));
    if (tables & SHD_ENVIRONMENT_TABLE_GGX) lookups.roughness.data = s->columns[3] + 100;
    shd_assert_ok(shd_environment_sample_radiance(made, &lookups, &light));
    s->hash = shd_hash(s->hash, s->columns[1], 500 * sizeof(float));
    shd_environment_release(made);
    return result;
}
static shd_result environment_radiance(struct stage *s)
{
    return environment(s, SHD_IRRADIANCE_HARMONICS, SHD_ENVIRONMENT_TABLE_RADIANCE);
}
static shd_result environment_lobes(struct stage *s)
{
    return environment(s, SHD_IRRADIANCE_CONVOLVED, SHD_ENVIRONMENT_TABLE_GGX);
}

/* A frame that shows an environment. */
static shd_result render_environment(struct stage *s)
{
    shd_render_desc frame = s->scene.desc;
    shd_environment *made = NULL;
    shd_result result = make_environment(s, SHD_IRRADIANCE_HARMONICS, SHD_ENVIRONMENT_TABLE_RADIANCE, &made);
    frame.environment = made;
    frame.draw_count = 0;
    frame.background = SHD_BACKGROUND_ENVIRONMENT;
    if (result == SHD_OK) result = shd_render(s->context, &frame);
    if (result == SHD_OK) s->hash = shd_hash_framebuffer(s->scene.framebuffer);
    shd_environment_release(made);
    return result;
}

/* A texture of directions, with lookups of it. */
static shd_result texture_directions(struct stage *s)
{
    shd_texture_desc desc = shd_texture_desc_default();
    shd_lookups lookups = shd_lookups_default();
    shd_texels texels = shd_texels_default();
    shd_texture *texture = NULL;
    shd_result result;
    desc.format = SHD_FORMAT_RGBA8;
    desc.width = desc.height = 16;
    desc.layer_count = 6;
    desc.kind = SHD_TEXTURE_KIND_DIRECTIONS;
    desc.projection = SHD_PROJECTION_CUBE;
    desc.tables = SHD_TABLE_MIPMAP;
    desc.texels = s->texels;
    result = shd_texture_create(s->context, &desc, &texture);
    lookups.count = 500;
    lookups.u.data = lookups.dudx.data = s->columns[3];
    lookups.v.data = lookups.dvdy.data = s->columns[3] + 7;
    lookups.w.data = lookups.dwdx.data = s->columns[3] + 11;
    texels.channel[0].data = s->columns[0];
    if (result == SHD_OK) result = shd_texture_sample(texture, s->sampler[SHD_FILTER_EWA], &lookups, &texels);
    if (result == SHD_OK) s->hash = shd_hash(SHD_HASH_START, s->columns[0], 500 * sizeof(float));
    shd_texture_release(texture);
    return result;
}

static shd_result convert(struct stage *s)
{
    static unsigned char faces[6 * PIXELS * 4];
    const shd_image from_image = sky(s);
    shd_image to_image = shd_image_default();
    shd_direction_images from = shd_direction_images_default(), to = shd_direction_images_default();
    shd_result result;
    from.projection = SHD_PROJECTION_LAT_LONG;
    from.images = &from_image;
    to_image.format = SHD_FORMAT_RGBA8;
    to_image.width = 8;
    to_image.height = 48;
    to_image.pixels = faces;
    to.projection = SHD_PROJECTION_CUBE;
    to.layout = SHD_CUBE_LAYOUT_COLUMN;
    to.images = &to_image;
    result = shd_projection_convert(s->context, &from, &to);
    if (result == SHD_OK) s->hash = shd_hash(SHD_HASH_START, faces, 4 * 8 * 48);
    return result;
}

static shd_result polygon(struct stage *s, shd_barycentric kind)
{
    static const float k_vertex[2][5] = {{0, 1, 1.5f, 0.5f, -0.5f}, {0, 0, 1, 1.75f, 1}};
    shd_polygon_desc desc = shd_polygon_desc_default();
    shd_polygon_points points = shd_polygon_points_default();
    shd_polygon_weights weights = shd_polygon_weights_default();
    shd_f32_out columns[5] = {{s->columns[0], 0}};
    shd_result result;
    desc.kind = kind;
    desc.vertex[0].data = k_vertex[0];
    desc.vertex[1].data = k_vertex[1];
    desc.vertex_count = weights.weight_count = 5;
    desc.segments = 4;
    points.count = 500;
    points.position[0].data = s->columns[3];
    points.position[1].data = s->columns[3] + 7;
    weights.weight = columns;
    result = shd_polygon_evaluate(s->context, &desc, &points, &weights);
    if (result == SHD_ERROR_UNSUPPORTED && kind == SHD_BARYCENTRIC_HARMONIC) return SHD_OK; /* without Eigen */
    if (result == SHD_OK) s->hash = shd_hash(SHD_HASH_START, s->columns[0], 500 * sizeof(float));
    return result;
}
static shd_result polygon_mean_value(struct stage *s) { return polygon(s, SHD_BARYCENTRIC_MEAN_VALUE); }
static shd_result polygon_harmonic(struct stage *s) { return polygon(s, SHD_BARYCENTRIC_HARMONIC); }

static shd_result polyhedron(struct stage *s, shd_barycentric kind)
{
    static const float k_vertex[3][4] = {{0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
    static const uint32_t k_index[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    shd_polyhedron_desc desc = shd_polyhedron_desc_default();
    shd_polyhedron_points points = shd_polyhedron_points_default();
    shd_polyhedron_weights weights = shd_polyhedron_weights_default();
    shd_polyhedron_values values = shd_polyhedron_values_default();
    shd_f32_out columns[4] = {{s->columns[0], 0}}, sum = {s->columns[1], 0};
    shd_polyhedron *made = NULL;
    shd_result result;
    int c;
    desc.kind = kind;
    desc.vertex_count = weights.weight_count = 4;
    desc.index_count = 12;
    desc.indices.data = k_index;
    points.count = 500;
    for (c = 0; c < 3; ++c) desc.position[c].data = k_vertex[c], points.position[c].data = s->columns[3] + 7 * c;
    weights.weight = columns;
    values.value_count = 1;
    values.vertex_value = desc.position;
    values.value = &sum;
    result = shd_polyhedron_create(s->context, &desc, &made);
    if (result == SHD_OK) result = shd_polyhedron_evaluate(made, &points, &weights);
    if (result == SHD_OK) result = shd_polyhedron_interpolate(made, &points, &values);
    shd_polyhedron_release(made);
    if (result == SHD_OK) s->hash = shd_hash(SHD_HASH_START, s->columns[0], 500 * sizeof(float));
    if (result == SHD_OK) s->hash = shd_hash(s->hash, s->columns[1], 500 * sizeof(float));
    return result;
}
static shd_result polyhedron_mean_value(struct stage *s) { return polyhedron(s, SHD_BARYCENTRIC_MEAN_VALUE); }
static shd_result polyhedron_wachspress(struct stage *s) { return polyhedron(s, SHD_BARYCENTRIC_WACHSPRESS); }

static const struct call_case k_calls[] = {
    {"environment/radiance", environment_radiance},
    {"environment/lobes", environment_lobes},
    {"environment/render", render_environment},
    {"texture/cube", texture_directions},
    {"projection/convert", convert},
    {"polygon/mean_value", polygon_mean_value},
    {"polygon/harmonic", polygon_harmonic},
    {"polyhedron/mean_value", polyhedron_mean_value},
    {"polyhedron/wachspress", polyhedron_wachspress},
};

int main(void)
{
    ADD_ROWS(k_calls, test_call);
    return _cmocka_run_group_tests("api.call_faults_directions", g_tests, g_count, NULL, NULL);
}
