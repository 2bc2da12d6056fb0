/* SPDX-License-Identifier: MIT */
/* Light of the texels of an image: large and thin texels, bright texels where the image is narrow, solid angles at
   folds and rims; and the radiance between texels. */
#include "support/environments.h"

#include <stdlib.h>
#include <string.h>

#include "ref/environment_ref.h"
#include "support/rows.h"

static shd_image image_of(shd_projection projection, uint32_t width, uint32_t height, float radiance)
{
    const uint32_t faces = projection == SHD_PROJECTION_CUBE ? 6 : 1;
    const size_t count = (size_t)width * height * faces * 3;
    shd_image image = shd_image_default();
    float *texels = (float *)malloc(count * sizeof *texels);
    for (size_t i = 0; i < count; ++i) texels[i] = radiance;
    image.format = SHD_FORMAT_RGB32F;
    image.width = width, image.height = height * faces;
    image.pixels = texels;
    return image;
}

/** Sets all channels of texel (x, y). */
static void set_texel(const shd_image *image, uint32_t x, uint32_t y, float radiance)
{
    float *texel = (float *)image->pixels + 3 * ((size_t)y * image->width + x);
    texel[0] = texel[1] = texel[2] = radiance;
}

static float mean_of(const shd_environment *environment)
{
    shd_environment_info info = shd_environment_info_default();
    shd_assert_ok(shd_environment_get_info(environment, &info));
    return info.mean[0];
}

struct size_case {
    const char *name;
    shd_projection projection;
    uint32_t width, height;
};
static const struct size_case k_sizes[] = {
    {"constant/lat_long_1x1", SHD_PROJECTION_LAT_LONG, 1, 1},
    {"constant/lat_long_2x1", SHD_PROJECTION_LAT_LONG, 2, 1},
    {"constant/lat_long_4x2", SHD_PROJECTION_LAT_LONG, 4, 2},
    {"constant/lat_long_16x8", SHD_PROJECTION_LAT_LONG, 16, 8},
    {"constant/lat_long_1021x1", SHD_PROJECTION_LAT_LONG, 1021, 1},
    {"constant/lat_long_1x1021", SHD_PROJECTION_LAT_LONG, 1, 1021},
    {"constant/lat_long_211x7", SHD_PROJECTION_LAT_LONG, 211, 7},
    {"constant/mirror_ball_1", SHD_PROJECTION_MIRROR_BALL, 1, 1},
    {"constant/mirror_ball_4", SHD_PROJECTION_MIRROR_BALL, 4, 4},
    {"constant/angular_1", SHD_PROJECTION_ANGULAR, 1, 1},
    {"constant/angular_5", SHD_PROJECTION_ANGULAR, 5, 5},
    {"constant/cube_1", SHD_PROJECTION_CUBE, 1, 1},
    {"constant/cube_3", SHD_PROJECTION_CUBE, 3, 3},
    {"constant/octahedral_1", SHD_PROJECTION_OCTAHEDRAL, 1, 1},
    {"constant/octahedral_2", SHD_PROJECTION_OCTAHEDRAL, 2, 2},
};

/** Radiance 1 from everywhere: the irradiance is pi, and every lobe gives 1. */
static void test_size(void **state)
{
    static const float k_widths[] = {0.0f, 0.1f, 0.2f, 0.5f, 1.0f, 20.0f, 100.0f, 255.0f, 1000.0f};
    const struct size_case *row = (const struct size_case *)*state;
    const shd_image image = image_of(row->projection, row->width, row->height, 1.0f);
    float width[DIRECTIONS];
    for (int irradiance = 0; irradiance < 2; ++irradiance) {
        shd_environment *environment = create(g_context, row->projection, &image, (shd_irradiance)irradiance);
        irradiance_of(environment);
        for (size_t i = 0; i < DIRECTIONS; ++i)
            shd_assert_close(row->name, i, (double)g_out[1][i], (double)REF_PI, 0.0, 2e-3);
        for (size_t k = 0; k < sizeof k_widths / sizeof k_widths[0]; ++k) {
            for (size_t i = 0; i < DIRECTIONS; ++i) width[i] = k_widths[k];
            look_up(environment, k_widths[k] <= 1.0f ? width : NULL, k_widths[k] <= 1.0f ? NULL : width);
            for (size_t i = 0; i < DIRECTIONS; ++i) shd_assert_close(row->name, i, (double)g_out[2][i], 1.0, 0.0, 3e-5);
        }
        look_up(environment, NULL, NULL);
        for (size_t i = 0; i < DIRECTIONS; ++i) shd_assert_close(row->name, i, (double)g_out[0][i], 1.0, 0.0, 3e-5);
        shd_environment_release(environment);
    }
    free(image.pixels);
}

/** Integral of channel c of the radiance minus `sky` over the cap of a radius around a direction. */
static double light_around(const shd_environment *environment, const long double *sun, double radius, int c, double sky)
{
    enum { SIDE = 192 };
    static float n[3][SIDE * SIDE], out[SIDE * SIDE];
    shd_environment_lookups lookups = shd_environment_lookups_default();
    shd_environment_values columns = shd_environment_values_default();
    const double d[3] = {(double)sun[0], (double)sun[1], (double)sun[2]};
    const int k = fabs(d[0]) < 0.6 ? 0 : 1;
    double x[3] = {0, 0, 0}, y[3], length, sum = 0.0;
    x[k] = 1.0;
    for (int axis = 0; axis < 3; ++axis) x[axis] -= d[k] * d[axis];
    length = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    for (int axis = 0; axis < 3; ++axis) x[axis] /= length;
    for (int axis = 0; axis < 3; ++axis) {
        y[axis] = d[(axis + 1) % 3] * x[(axis + 2) % 3] - d[(axis + 2) % 3] * x[(axis + 1) % 3];
    }
    for (size_t i = 0; i < SIDE * SIDE; ++i) { /* equal areas, whose spacing is far below a texel */
        const double z = 1.0 - (1.0 - cos(radius)) * ((double)(i / SIDE) + 0.5) / SIDE, s = sqrt(1.0 - z * z);
        const double a = 2.0 * (double)REF_PI * ((double)(i % SIDE) + 0.5 + 0.618 * (double)(i / SIDE)) / SIDE;
        for (int axis = 0; axis < 3; ++axis) {
            n[axis][i] = (float)(z * d[axis] + s * (cos(a) * x[axis] + sin(a) * y[axis]));
        }
    }
    lookups.count = SIDE * SIDE;
    for (int axis = 0; axis < 3; ++axis) lookups.direction[axis] = shd_f32_column(n[axis], 0);
    columns.channel[c] = shd_f32_out_column(out, 0);
    shd_assert_ok(shd_environment_sample_radiance(environment, &lookups, &columns));
    for (size_t i = 0; i < SIDE * SIDE; ++i) sum += (double)out[i] - sky;
    return sum * 2.0 * (double)REF_PI * (1.0 - cos(radius)) / (SIDE * SIDE);
}

/** A texel far brighter than a sky of radiance 1. */
struct bright_case {
    const char *name;
    shd_projection projection;
    uint32_t width, height, x, y;
    double radius; /* angle that bilinear lookups of the texel reach */
};
static const struct bright_case k_bright[] = {
    {"bright/pole", SHD_PROJECTION_LAT_LONG, 512, 256, 100, 0, 0.06},
    {"bright/next_to_pole", SHD_PROJECTION_LAT_LONG, 512, 256, 300, 1, 0.06},
    {"bright/row_9", SHD_PROJECTION_LAT_LONG, 512, 256, 77, 9, 0.06},
    {"bright/row_60", SHD_PROJECTION_LAT_LONG, 512, 256, 77, 60, 0.06},
    {"bright/equator", SHD_PROJECTION_LAT_LONG, 512, 256, 11, 128, 0.06},
    {"bright/south", SHD_PROJECTION_LAT_LONG, 128, 64, 40, 63, 0.25},
    {"bright/thin_columns", SHD_PROJECTION_LAT_LONG, 4096, 16, 300, 3, 0.5},
    {"bright/thin_rows", SHD_PROJECTION_LAT_LONG, 16, 2048, 3, 700, 0.8},
    {"bright/mirror_ball_rim", SHD_PROJECTION_MIRROR_BALL, 128, 128, 126, 60, 0.3},
    {"bright/angular_rim", SHD_PROJECTION_ANGULAR, 128, 128, 126, 60, 0.25},
    {"bright/cube_corner", SHD_PROJECTION_CUBE, 64, 64, 0, 0, 0.25},
};

static void check_light(const char *name, uint32_t y, double got, double want)
{
    if (getenv("SHD_TEST_VERBOSE")) printf("%s, row %u: light %.4f\n", name, y, got / want);
    if (!(fabs(got / want - 1.0) <= 0.12)) fail_msg("%s, row %u: light %g instead of %g", name, y, got, want);
}

/** Directions away from the texel keep their radiance of 1, and the map has the light of the texel. */
static void test_bright(void **state)
{
    const struct bright_case *row = (const struct bright_case *)*state;
    const shd_image image = image_of(row->projection, row->width, row->height, 1.0f);
    const long double u = (row->x + 0.5L) / row->width, v = (row->y + 0.5L) / row->height;
    shd_environment *environment;
    long double sun[3];
    assert_true(ref_unproject(row->projection, u, v, 0, sun));
    set_texel(&image, row->x, row->y, 1e9f);
    environment =
        create_with(g_context, row->projection, &image, SHD_IRRADIANCE_HARMONICS, SHD_ENVIRONMENT_TABLE_RADIANCE);
    look_up(environment, NULL, NULL);
    for (size_t i = 0; i < DIRECTIONS; ++i) {
        double cosine = 0.0;
        for (int c = 0; c < 3; ++c) cosine += (double)g_direction[c][i] * (double)sun[c];
        if (cosine < cos(row->radius)) shd_assert_close(row->name, i, (double)g_out[0][i], 1.0, 0.0, 1e-4);
    }
    check_light(row->name, row->y, light_around(environment, sun, row->radius, 0, 1.0),
                4.0 * (double)REF_PI * ((double)mean_of(environment) - 1.0));
    shd_environment_release(environment);
    free(image.pixels);
}

/** A texel of every row, or of every `step`-th row beyond row `dense` from the poles, has its light; one a channel. */
struct rows_case {
    const char *name;
    uint32_t height, dense, step; /* width = 2 height */
};
static const struct rows_case k_rows[] = {
    {"rows/8", 8, 8, 1},    {"rows/16", 16, 16, 1},   {"rows/32", 32, 32, 1},    {"rows/33", 33, 33, 1},
    {"rows/64", 64, 64, 1}, {"rows/128", 128, 32, 7}, {"rows/256", 256, 12, 23}, {"rows/500", 500, 6, 61},
};
static void test_rows(void **state)
{
    const struct rows_case *row = (const struct rows_case *)*state;
    const uint32_t height = row->height, width = 2 * height;
    const shd_image image = image_of(SHD_PROJECTION_LAT_LONG, width, height, 0.0f);
    float *texels = (float *)image.pixels;
    const uint32_t skip = SHD_ORACLE_STRIDE;
    for (uint32_t y = 0; y < height;) {
        shd_environment_info info = shd_environment_info_default();
        shd_environment *environment;
        uint32_t of[3], count = 0;
        for (; count < 3 && y < height; ++count) {
            const uint32_t from_pole = y < height - 1 - y ? y : height - 1 - y;
            of[count] = y;
            texels[3 * (y * width + y * 7919 % width) + count] = 1000.0f;
            y += (from_pole < row->dense ? 1 : row->step) * (from_pole < 3 ? 1 : skip);
            if (from_pole >= row->dense && y > height - 3) y = height - 3; /* the other pole */
        }
        environment = create_with(g_context, SHD_PROJECTION_LAT_LONG, &image, SHD_IRRADIANCE_HARMONICS,
                                  SHD_ENVIRONMENT_TABLE_RADIANCE);
        shd_assert_ok(shd_environment_get_info(environment, &info));
        for (uint32_t c = 0; c < count; ++c) {
            const uint32_t x = of[c] * 7919 % width;
            const double radius = fmin(3.0, 4.5 * (double)REF_PI / height + 6.0 / info.map_size);
            long double sun[3];
            ref_unproject(SHD_PROJECTION_LAT_LONG, (x + 0.5L) / width, (of[c] + 0.5L) / height, 0, sun);
            check_light(row->name, of[c], light_around(environment, sun, radius, (int)c, 0.0),
                        4.0 * (double)REF_PI * (double)info.mean[c]);
            texels[3 * (of[c] * width + x) + c] = 0.0f;
        }
        shd_environment_release(environment);
    }
    free(image.pixels);
}

/** Solid angle of a texel, by a fine grid of points. */
static double solid_angle_of(shd_projection projection, uint32_t size, uint32_t x, uint32_t y)
{
    enum { GRID = 101 };
    long double sum = 0.0L, n[3];
    for (int i = 0; i < GRID * GRID; ++i) {
        const long double u = (x + (i % GRID + 0.4L) / GRID) / size, v = (y + (i / GRID + 0.6L) / GRID) / size;
        if (ref_unproject(projection, u, v, 0, n)) sum += ref_density(projection, u, v, 0);
    }
    return (double)(sum / ((long double)GRID * GRID * size * size));
}

struct solid_angle_case {
    const char *name;
    shd_projection projection;
    uint32_t size, x, y;
};
static const struct solid_angle_case k_solid_angles[] = {
    {"solid_angle/fold_8", SHD_PROJECTION_OCTAHEDRAL, 8, 2, 1},
    {"solid_angle/fold_64", SHD_PROJECTION_OCTAHEDRAL, 64, 21, 10},
    {"solid_angle/odd_fold", SHD_PROJECTION_OCTAHEDRAL, 9, 4, 2},
    {"solid_angle/corner", SHD_PROJECTION_CUBE, 4, 0, 0},
    {"solid_angle/pole", SHD_PROJECTION_LAT_LONG, 7, 3, 0},
    {"solid_angle/mirror_ball_rim", SHD_PROJECTION_MIRROR_BALL, 16, 0, 7},
    {"solid_angle/angular_rim", SHD_PROJECTION_ANGULAR, 16, 0, 6},
};

/** The mean radiance of an image with one bright texel is its solid angle. */
static void test_solid_angle(void **state)
{
    const struct solid_angle_case *row = (const struct solid_angle_case *)*state;
    const shd_image image = image_of(row->projection, row->size, row->size, 0.0f);
    const double want = solid_angle_of(row->projection, row->size, row->x, row->y);
    shd_environment *environment;
    set_texel(&image, row->x, row->y, 1000.0f);
    environment =
        create_with(g_context, row->projection, &image, SHD_IRRADIANCE_HARMONICS, SHD_ENVIRONMENT_TABLE_RADIANCE);
    shd_assert_close(row->name, 0, 4.0 * (double)REF_PI * (double)mean_of(environment) / 1000.0, want, 0.0, 2e-3);
    shd_environment_release(environment);
    free(image.pixels);
}

/** Texels outside the disc have no effect, and the texels at the rim count. */
static void test_outside_disc(void **state)
{
    (void)state;
    for (shd_projection p = SHD_PROJECTION_MIRROR_BALL; p <= SHD_PROJECTION_ANGULAR; p = (shd_projection)(p + 1)) {
        const shd_image image = image_of(p, 37, 37, 1.0f);
        shd_environment *environment;
        for (uint32_t i = 0; i < 37 * 37; ++i) {
            const double x = 2.0 * (i % 37 + 0.5) / 37.0 - 1.0, y = 2.0 * (i / 37 + 0.5) / 37.0 - 1.0;
            if (x * x + y * y > 1.0) set_texel(&image, i % 37, i / 37, i % 2 ? 1e6f : 0.0f);
        }
        environment = create(g_context, p, &image, SHD_IRRADIANCE_CONVOLVED);
        shd_assert_close("mean", 0, (double)mean_of(environment), 1.0, 0.0, 1e-5);
        look_up(environment, NULL, NULL);
        for (size_t i = 0; i < DIRECTIONS; ++i) shd_assert_close("radiance", i, (double)g_out[0][i], 1.0, 0.0, 3e-5);
        irradiance_of(environment);
        for (size_t i = 0; i < DIRECTIONS; ++i)
            shd_assert_close("irradiance", i, (double)g_out[0][i], (double)REF_PI, 0.0, 2e-3);
        shd_environment_release(environment);
        free(image.pixels);
    }
}

/** Between texels, at poles, edges and seams the radiance is that of a texture of directions. */
struct edge_case {
    const char *name;
    shd_projection projection;
    uint32_t width, height;
    double max_error;
};
static const struct edge_case k_edges[] = {
    {"edge/lat_long", SHD_PROJECTION_LAT_LONG, 32, 16, 0.015},
    {"edge/cube", SHD_PROJECTION_CUBE, 16, 16, 0.016},
    {"edge/octahedral", SHD_PROJECTION_OCTAHEDRAL, 16, 16, 0.056},
};
static void test_edge(void **state)
{
    enum { COUNT = 20011 };
    static float n[3][COUNT], out[COUNT];
    const struct edge_case *row = (const struct edge_case *)*state;
    const shd_image image = image_of(row->projection, row->width, row->height, 0.0f);
    shd_environment_lookups lookups = shd_environment_lookups_default();
    shd_environment_values columns = shd_environment_values_default();
    shd_environment *environment;
    double worst = 0.0;
    for (uint32_t i = 0; i < image.width * image.height; ++i) {
        const uint32_t x = i % row->width, y = i / row->width % row->height;
        long double d[3];
        ref_unproject(row->projection, (x + 0.5L) / row->width, (y + 0.5L) / row->height,
                      i / (row->width * row->height), d);
        set_texel(&image, x, i / row->width, (float)(2.0L + d[0] + 0.5L * d[1] - 0.3L * d[2]));
    }
    for (size_t i = 0; i < COUNT; ++i) {
        const double z = 1.0 - 2.0 * ((double)i + 0.5) / COUNT, a = (double)i * 2.399963, r = sqrt(1.0 - z * z);
        n[0][i] = (float)(r * cos(a)), n[1][i] = (float)z, n[2][i] = (float)(r * sin(a));
    }
    environment =
        create_with(g_context, row->projection, &image, SHD_IRRADIANCE_HARMONICS, SHD_ENVIRONMENT_TABLE_RADIANCE);
    lookups.count = COUNT;
    for (int c = 0; c < 3; ++c) lookups.direction[c] = shd_f32_column(n[c], 0);
    columns.channel[0] = shd_f32_out_column(out, 0);
    shd_assert_ok(shd_environment_sample_radiance(environment, &lookups, &columns));
    for (size_t i = 0; i < COUNT; ++i) {
        const double want = 2.0 + (double)n[0][i] + 0.5 * (double)n[1][i] - 0.3 * (double)n[2][i];
        worst = fmax(worst, fabs((double)out[i] - want));
    }
    if (getenv("SHD_TEST_VERBOSE")) printf("%s: %.4f\n", row->name, worst);
    if (!(worst <= row->max_error)) fail_msg("%s: error %g", row->name, worst);
    shd_environment_release(environment);
    free(image.pixels);
}

/** The irradiance map of one bright texel, in places where it is widest and at random ones. */
struct convolved_case {
    const char *name;
    uint32_t width, height, x, y;
};
static const struct convolved_case k_convolved[] = {
    {"convolved/fold", 512, 256, 464, 116},  {"convolved/face", 512, 256, 64, 80}, {"convolved/pole", 512, 256, 3, 0},
    {"convolved/equator", 512, 256, 7, 128}, {"convolved/random", 512, 256, 0, 0},
};
static void test_convolved(void **state)
{
    enum { COUNT = 20011, PLACES = 24 };
    static float n[3][COUNT], out[COUNT];
    const struct convolved_case *row = (const struct convolved_case *)*state;
    const shd_image image = image_of(SHD_PROJECTION_LAT_LONG, row->width, row->height, 0.0f);
    shd_environment_lookups lookups = shd_environment_lookups_default();
    shd_environment_values columns = shd_environment_values_default();
    const int places = strcmp(row->name, "convolved/random") ? 1 : PLACES / SHD_ORACLE_STRIDE;
    uint32_t random = 11;
    double worst = 0.0;
    for (size_t i = 0; i < COUNT; ++i) {
        const double z = 1.0 - 2.0 * ((double)i + 0.5) / COUNT, a = (double)i * 2.399963, r = sqrt(1.0 - z * z);
        n[0][i] = (float)(r * cos(a)), n[1][i] = (float)z, n[2][i] = (float)(r * sin(a));
    }
    n[0][0] = -0.83370f, n[1][0] = 0.00421f, n[2][0] = 0.55225f; /* the terminator of convolved/fold, on a fold */
    lookups.count = COUNT;
    for (int c = 0; c < 3; ++c) lookups.direction[c] = shd_f32_column(n[c], 0);
    columns.channel[1] = shd_f32_out_column(out, 0);
    for (int place = 0; place < places; ++place) {
        const uint32_t x = places == 1 ? row->x : shd_noise(&random) % row->width;
        const uint32_t y = places == 1 ? row->y : shd_noise(&random) % row->height;
        shd_environment *environment;
        ref_environment ref;
        double light;
        set_texel(&image, x, y, 1000.0f);
        ref = ref_environment_of(SHD_PROJECTION_LAT_LONG, &image);
        environment = create_with(g_context, SHD_PROJECTION_LAT_LONG, &image, SHD_IRRADIANCE_CONVOLVED,
                                  SHD_ENVIRONMENT_TABLE_NONE);
        light = 1000.0 * ref.lights[(size_t)y * row->width + x].solid_angle;
        shd_assert_ok(shd_environment_sample_irradiance(environment, &lookups, &columns));
        for (size_t i = 0; i < COUNT; ++i) {
            const double *l = ref.lights[(size_t)y * row->width + x].direction;
            const double cosine = (double)n[0][i] * l[0] + (double)n[1][i] * l[1] + (double)n[2][i] * l[2];
            worst = fmax(worst, fabs((double)out[i] / light - fmax(0.0, cosine)));
        }
        set_texel(&image, x, y, 0.0f);
        shd_environment_release(environment);
        free(ref.lights);
    }
    if (getenv("SHD_TEST_VERBOSE")) printf("%s: %.5f\n", row->name, worst);
    if (!(worst <= 0.018)) fail_msg("%s: error %g of the light", row->name, worst);
    free(image.pixels);
}

int main(void)
{
    ADD_ROWS(k_sizes, test_size);
    ADD_ROWS(k_bright, test_bright);
    ADD_ROWS(k_rows, test_rows);
    ADD_ROWS(k_convolved, test_convolved);
    ADD_ROWS(k_solid_angles, test_solid_angle);
    add("outside_disc", test_outside_disc, NULL);
    ADD_ROWS(k_edges, test_edge);
    return _cmocka_run_group_tests("environment_texels", g_tests, g_count, open_context, close_context);
}
