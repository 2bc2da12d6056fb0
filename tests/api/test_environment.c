/* SPDX-License-Identifier: MIT */
/* Environments: every field of the desc, irradiance and radiance against sums over all texels, bad texels and
   directions, equal bits of SIMD targets and workers, and allocation failures. */
#include "support/environments.h"

#include "ref/environment_ref.h"
#include "support/fault_allocator.h"
#include "support/rows.h"

enum { WIDTH = 128, HEIGHT = 64 };

/** A smooth sky, and in red a small sun of about 10 times its irradiance. */
static void sky(const long double *n, float *rgb)
{
    const double x = (double)n[0], y = (double)n[1], z = (double)n[2];
    const double away = (x - 0.48) * (x - 0.48) + (y - 0.6) * (y - 0.6) + (z - 0.64) * (z - 0.64);
    rgb[0] = (float)(0.2 + 0.1 * y + (away < 0.01 ? 2000.0 * (1.0 - away / 0.01) : 0.0));
    rgb[1] = (float)(0.6 + 0.3 * y + 0.1 * sin(5.0 * x) * cos(4.0 * z));
    rgb[2] = (float)(1.0 + 0.5 * y - 0.3 * z * x);
}

/** An RGB32F image of the sky in a projection; free its pixels. */
static shd_image sky_image(shd_projection projection, uint32_t width, uint32_t height)
{
    const uint32_t faces = projection == SHD_PROJECTION_CUBE ? 6 : 1;
    shd_image image = shd_image_default();
    float *texel = (float *)malloc((size_t)width * height * faces * 3 * sizeof *texel);
    image.format = SHD_FORMAT_RGB32F;
    image.width = width, image.height = height * faces;
    image.pixels = texel;
    for (uint32_t y = 0; y < image.height; ++y) {
        for (uint32_t x = 0; x < width; ++x, texel += 3) {
            long double n[3];
            ref_unproject(projection, (x + 0.5L) / width, (y % height + 0.5L) / height, y / height, n);
            sky(n, texel);
        }
    }
    return image;
}

static void direction_at(size_t i, double *n)
{
    for (int c = 0; c < 3; ++c) n[c] = (double)g_direction[c][i];
}

/** Largest and mean error of the outputs against the oracle, divided by the largest output of a channel. */
typedef void (*oracle_fn)(const void *data, const double *n, double *rgb);
static void compare(const char *what, oracle_fn oracle, const void *data, double max_error, double rms_error)
{
    double want[3][DIRECTIONS], largest, worst = 0.0, squares = 0.0;
    size_t count = 0;
    for (size_t i = 0; i < DIRECTIONS; i += SHD_ORACLE_STRIDE) {
        double n[3], rgb[3];
        direction_at(i, n);
        oracle(data, n, rgb);
        for (int c = 0; c < 3; ++c) want[c][i] = rgb[c];
    }
    for (int c = 0; c < 3; ++c) {
        largest = 0.0;
        for (size_t i = 0; i < DIRECTIONS; ++i) largest = fmax(largest, (double)g_out[c][i]);
        for (size_t i = 0; i < DIRECTIONS; i += SHD_ORACLE_STRIDE, ++count) {
            const double error = fabs((double)g_out[c][i] - want[c][i]) / largest;
            if (!(error <= worst)) worst = error;
            squares += error * error;
        }
    }
    if (getenv("SHD_TEST_VERBOSE")) printf("%s: %.5f %.5f\n", what, worst, sqrt(squares / (double)count));
    if (!(worst <= max_error) || !(sqrt(squares / (double)count) <= rms_error)) {
        fail_msg("%s: largest error %.5f, mean %.5f", what, worst, sqrt(squares / (double)count));
    }
}

static void oracle_harmonics(const void *data, const double *n, double *rgb)
{
    ref_harmonic_irradiance((const ref_environment *)data, n, rgb);
}
static void oracle_irradiance(const void *data, const double *n, double *rgb)
{
    ref_irradiance((const ref_environment *)data, n, rgb);
}

static void test_irradiance(void **state)
{
    shd_image image = sky_image(SHD_PROJECTION_LAT_LONG, WIDTH, HEIGHT);
    const ref_environment ref = ref_environment_of(SHD_PROJECTION_LAT_LONG, &image);
    shd_environment *harmonics = create(g_context, SHD_PROJECTION_LAT_LONG, &image, SHD_IRRADIANCE_HARMONICS);
    shd_environment *convolved = create(g_context, SHD_PROJECTION_LAT_LONG, &image, SHD_IRRADIANCE_CONVOLVED);
    (void)state;
    irradiance_of(harmonics);
    compare("harmonics", oracle_harmonics, &ref, 2e-5, 1e-5);
    compare("harmonics against the truth", oracle_irradiance, &ref, 0.1, 0.03);
    irradiance_of(convolved);
    compare("convolved", oracle_irradiance, &ref, 0.015, 0.003);
    shd_environment_release(harmonics);
    shd_environment_release(convolved);
    free(ref.lights);
    free(image.pixels);
}

struct lobe {
    const ref_environment *ref;
    double (*weight)(double, double);
    double parameter, integral;
};
static void oracle_lobe(const void *data, const double *n, double *rgb)
{
    const struct lobe *lobe = (const struct lobe *)data;
    ref_lobe_mean(lobe->ref, lobe->weight, lobe->parameter, lobe->integral, n, rgb);
}

/** Lobes at a node of the tables, and between nodes. */
struct lobe_case {
    const char *name;
    int phong;
    float width;
    double max_error, rms_error;
};
static const struct lobe_case k_lobes[] = {
    {"lobes/ggx/roughness_1", 0, 1.0f, 0.03, 0.01},
    {"lobes/ggx/roughness_0.9", 0, 0.9f, 0.03, 0.01},
    {"lobes/ggx/roughness_0.7", 0, 0.7f, 0.03, 0.01},
    {"lobes/ggx/roughness_0.5", 0, 0.5f, 0.03, 0.01},
    {"lobes/ggx/roughness_0.45", 0, 0.45f, 0.05, 0.01},
    {"lobes/ggx/roughness_0.3", 0, 0.3f, 0.05, 0.01},
    {"lobes/phong/1", 1, 1.0f, 0.03, 0.01},
    {"lobes/phong/2.5", 1, 2.5f, 0.05, 0.02},
    {"lobes/phong/10", 1, 10.0f, 0.05, 0.01},
    {"lobes/phong/31", 1, 31.0f, 0.03, 0.01},
    {"lobes/phong/100", 1, 100.0f, 0.1, 0.01},
};

static void test_lobe(void **state)
{
    const struct lobe_case *row = (const struct lobe_case *)*state;
    shd_image image = sky_image(SHD_PROJECTION_LAT_LONG, WIDTH, HEIGHT);
    const ref_environment ref = ref_environment_of(SHD_PROJECTION_LAT_LONG, &image);
    shd_environment *environment = create(g_context, SHD_PROJECTION_LAT_LONG, &image, SHD_IRRADIANCE_HARMONICS);
    struct lobe lobe = {&ref, row->phong ? ref_phong_lobe : ref_ggx_lobe, (double)row->width, 0.0};
    float width[DIRECTIONS];
    if (!row->phong) lobe.parameter *= lobe.parameter;
    lobe.integral = ref_lobe_integral(lobe.weight, lobe.parameter);
    for (size_t i = 0; i < DIRECTIONS; ++i) width[i] = row->width;
    look_up(environment, row->phong ? NULL : width, row->phong ? width : NULL);
    compare(row->name, oracle_lobe, &lobe, row->max_error, row->rms_error);
    shd_environment_release(environment);
    free(ref.lights);
    free(image.pixels);
}

/** Radiance 1 from everywhere: irradiance pi, and every lobe gives 1. */
static void test_constant(void **state)
{
    static const float k_widths[] = {0.0f, 0.03f, 0.2f, 0.55f, 1.0f, 7.0f, 300.0f, 1e6f};
    shd_image image = shd_image_default();
    shd_environment *environment;
    float width[DIRECTIONS];
    (void)state;
    image.format = SHD_FORMAT_RGB32F;
    for (shd_projection p = SHD_PROJECTION_LAT_LONG; p <= SHD_PROJECTION_OCTAHEDRAL; p = (shd_projection)(p + 1)) {
        float *texels = (float *)malloc(6 * 40 * 40 * 3 * sizeof *texels);
        for (size_t i = 0; i < 6 * 40 * 40 * 3; ++i) texels[i] = 1.0f;
        image.width = 40;
        image.height = p == SHD_PROJECTION_CUBE ? 240 : 40;
        image.pixels = texels;
        environment = create(g_context, p, &image, SHD_IRRADIANCE_HARMONICS);
        irradiance_of(environment);
        for (size_t i = 0; i < DIRECTIONS; ++i)
            shd_assert_close("irradiance", i, (double)g_out[1][i], (double)REF_PI, 0.0, 0.02);
        for (size_t k = 0; k < sizeof k_widths / sizeof k_widths[0]; ++k) {
            for (size_t i = 0; i < DIRECTIONS; ++i) width[i] = k_widths[k];
            look_up(environment, k_widths[k] <= 1.0f ? width : NULL, k_widths[k] <= 1.0f ? NULL : width);
            for (size_t i = 0; i < DIRECTIONS; ++i) shd_assert_close("lobe", i, (double)g_out[2][i], 1.0, 0.0, 3e-5);
        }
        look_up(environment, NULL, NULL);
        for (size_t i = 0; i < DIRECTIONS; ++i) shd_assert_close("radiance", i, (double)g_out[0][i], 1.0, 0.0, 3e-5);
        shd_environment_release(environment);
        free(texels);
    }
}

/** Images of one sky in all projections give about the same light. */
struct projection_case {
    const char *name;
    shd_projection projection;
    uint32_t size;
};
static const struct projection_case k_projections[] = {
    {"projection/mirror_ball", SHD_PROJECTION_MIRROR_BALL, 160},
    {"projection/angular", SHD_PROJECTION_ANGULAR, 160},
    {"projection/cube", SHD_PROJECTION_CUBE, 48},
    {"projection/octahedral", SHD_PROJECTION_OCTAHEDRAL, 96},
};
static void test_projection(void **state)
{
    const struct projection_case *row = (const struct projection_case *)*state;
    shd_image lat_long = sky_image(SHD_PROJECTION_LAT_LONG, WIDTH, HEIGHT);
    shd_image image = sky_image(row->projection, row->size, row->size);
    const ref_environment ref = ref_environment_of(SHD_PROJECTION_LAT_LONG, &lat_long);
    shd_environment *environment = create(g_context, row->projection, &image, SHD_IRRADIANCE_HARMONICS);
    struct lobe lobe = {&ref, ref_ggx_lobe, 0.25, ref_lobe_integral(ref_ggx_lobe, 0.25)};
    float width[DIRECTIONS];
    irradiance_of(environment);
    compare(row->name, oracle_harmonics, &ref, 0.02, 0.01);
    for (size_t i = 0; i < DIRECTIONS; ++i) width[i] = 0.5f;
    look_up(environment, width, NULL);
    compare(row->name, oracle_lobe, &lobe, 0.04, 0.015);
    look_up(environment, NULL, NULL);
    for (size_t i = 0; i < DIRECTIONS; ++i) {
        const long double n[3] = {g_direction[0][i], g_direction[1][i], g_direction[2][i]};
        float want[3];
        sky(n, want);
        for (size_t c = 1; c < 3; ++c) shd_assert_close(row->name, i, (double)g_out[c][i], (double)want[c], 0.03, 0.0);
    }
    shd_environment_release(environment);
    free(ref.lights);
    free(lat_long.pixels);
    free(image.pixels);
}

static uint64_t hash_of(shd_context *context, const shd_image *image)
{
    uint64_t hash = SHD_HASH_START;
    float width[DIRECTIONS];
    for (int irradiance = 0; irradiance < 2; ++irradiance) {
        shd_environment *environment = create(context, SHD_PROJECTION_LAT_LONG, image, (shd_irradiance)irradiance);
        irradiance_of(environment);
        hash = shd_hash(hash, g_out, sizeof g_out);
        for (size_t i = 0; i < DIRECTIONS; ++i) width[i] = (float)i / (DIRECTIONS - 1);
        look_up(environment, width, NULL);
        hash = shd_hash(hash, g_out, sizeof g_out);
        for (size_t i = 0; i < DIRECTIONS; ++i) width[i] = (float)(i * i);
        look_up(environment, NULL, width);
        hash = shd_hash(hash, g_out, sizeof g_out);
        shd_environment_release(environment);
    }
    return hash;
}

/** Every SIMD target and worker count gives the same bits. */
static void test_same_bits(void **state)
{
    shd_image image = sky_image(SHD_PROJECTION_LAT_LONG, 61, 29);
    const uint64_t want = hash_of(g_context, &image);
    int tried = 0;
    (void)state;
    for (int simd = SHD_SIMD_BASELINE; simd <= SHD_SIMD_WASM; ++simd) {
        for (uint32_t workers = 1; workers <= 3; workers += 2) {
            shd_context_desc desc = shd_context_desc_default();
            shd_context *context = NULL;
            desc.simd = (shd_simd)simd;
            desc.worker_count = workers;
            if (shd_context_create(&desc, &context) != SHD_OK) continue;
            assert_true(hash_of(context, &image) == want);
            shd_context_release(context);
            ++tried;
        }
    }
    assert_true(tried >= 2);
    free(image.pixels);
}

/** Negative, NaN and infinite channels are counted and replaced; all results are finite. */
static void test_bad_texels(void **state)
{
    shd_image image = sky_image(SHD_PROJECTION_LAT_LONG, 32, 16);
    float *texels = (float *)image.pixels;
    shd_environment_info info = shd_environment_info_default();
    shd_environment *environment;
    float width[DIRECTIONS];
    (void)state;
    texels[5] = (float)NAN;
    texels[100] = -1.0f;
    texels[300] = -INFINITY;
    texels[301] = -0.0f;
    texels[777] = 1e12f;
    texels[778] = 1.1e12f;
    texels[1000] = INFINITY;
    environment = create(g_context, SHD_PROJECTION_LAT_LONG, &image, SHD_IRRADIANCE_CONVOLVED);
    shd_assert_ok(shd_environment_get_info(environment, &info));
    assert_int_equal(info.replaced_count, 5);
    assert_int_equal(info.map_size, 64);
    assert_int_equal(info.tables, SHD_ENVIRONMENT_TABLE_ALL);
    assert_int_equal(info.irradiance, SHD_IRRADIANCE_CONVOLVED);
    assert_true(info.byte_size > 64 * 64 * 8);
    assert_true(info.mean[1] > 1e8f && info.mean[1] < 1e12f);
    for (size_t i = 0; i < DIRECTIONS; ++i) width[i] = (float)(i % 10) * 0.1f;
    for (int k = 0; k < 3; ++k) {
        if (k == 0) irradiance_of(environment);
        if (k) look_up(environment, k == 1 ? width : NULL, k == 1 ? NULL : width);
        for (size_t i = 0; i < 3 * DIRECTIONS; ++i) {
            const double value = (double)g_out[i / DIRECTIONS][i % DIRECTIONS];
            assert_true(value >= 0.0 && value <= 4e12);
        }
    }
    shd_environment_release(environment);
    free(image.pixels);
}

/** Directions and widths that are no numbers count as +Z and as the widest lobe. */
static void test_bad_lookups(void **state)
{
    static const float k_bad[][5] = {{0, 0, 0, 0.5f, 3},
                                     {NAN, 0, 1, 0.5f, 3},
                                     {0, INFINITY, 0, 0.5f, 3},
                                     {3e38f, 3e38f, 3e38f, 0.5f, 3},
                                     {1e-45f, 0, 0, 0.5f, 3},
                                     {0, 0, 1, NAN, NAN},
                                     {0, 0, 1, -1, -1},
                                     {0, 0, 1, 2, INFINITY},
                                     {0, 0, 1, INFINITY, -INFINITY},
                                     {0, 0, -2, 1e-30f, 1e30f}};
    enum { BAD = sizeof k_bad / sizeof k_bad[0] };
    shd_image image = sky_image(SHD_PROJECTION_LAT_LONG, 32, 16);
    shd_environment *environment = create(g_context, SHD_PROJECTION_LAT_LONG, &image, SHD_IRRADIANCE_HARMONICS);
    shd_environment_lookups lookups = shd_environment_lookups_default();
    shd_environment_values light;
    (void)state;
    outputs(&light);
    lookups.count = BAD;
    for (int c = 0; c < 3; ++c) lookups.direction[c] = shd_f32_column(&k_bad[0][c], sizeof k_bad[0]);
    for (int k = 0; k < 4; ++k) {
        lookups.roughness = shd_f32_column(k == 2 ? &k_bad[0][3] : NULL, sizeof k_bad[0]);
        lookups.exponent = shd_f32_column(k == 3 ? &k_bad[0][4] : NULL, sizeof k_bad[0]);
        g_out[1][BAD] = -5.0f;
        if (k == 0) shd_assert_ok(shd_environment_sample_irradiance(environment, &lookups, &light));
        if (k != 0) shd_assert_ok(shd_environment_sample_radiance(environment, &lookups, &light));
        for (size_t i = 0; i < BAD; ++i) {
            if (!(g_out[1][i] >= 0.0f && g_out[1][i] < 10.0f)) fail_msg("%d: [%zu] is %g", k, i, (double)g_out[1][i]);
        }
        assert_true(g_out[1][0] == g_out[1][1]);
        assert_true(g_out[1][BAD] == -5.0f);
    }
    shd_environment_release(environment);
    free(image.pixels);
}

static void edit_nothing(shd_environment_desc *d, shd_image *i) { (void)d, (void)i; }
static void edit_size(shd_environment_desc *d, shd_image *i) { d->struct_size = 8, (void)i; }
static void edit_no_projection(shd_environment_desc *d, shd_image *i) { d->projection = SHD_PROJECTION_NONE, (void)i; }
static void edit_projection(shd_environment_desc *d, shd_image *i) { d->projection = (shd_projection)6, (void)i; }
static void edit_no_image(shd_environment_desc *d, shd_image *i) { d->image = NULL, (void)i; }
static void edit_no_pixels(shd_environment_desc *d, shd_image *i) { i->pixels = NULL, (void)d; }
static void edit_format(shd_environment_desc *d, shd_image *i) { i->format = SHD_FORMAT_NONE, (void)d; }
static void edit_width(shd_environment_desc *d, shd_image *i) { i->width = 0, (void)d; }
static void edit_huge(shd_environment_desc *d, shd_image *i)
{
    i->width = 65536, i->height = 1025, i->row_stride = 0, (void)d;
}
static void edit_cube(shd_environment_desc *d, shd_image *i) { d->projection = SHD_PROJECTION_CUBE, i->height = 7; }
static void edit_disc(shd_environment_desc *d, shd_image *i) { d->projection = SHD_PROJECTION_ANGULAR, i->height = 7; }
static void edit_irradiance(shd_environment_desc *d, shd_image *i) { d->irradiance = (shd_irradiance)2, (void)i; }
static void edit_irradiance_minus(shd_environment_desc *d, shd_image *i)
{
    d->irradiance = (shd_irradiance)-1, (void)i;
}
static void edit_tables(shd_environment_desc *d, shd_image *i) { d->tables = 8, (void)i; }
static void edit_no_tables(shd_environment_desc *d, shd_image *i) { d->tables = SHD_ENVIRONMENT_TABLE_NONE, (void)i; }

struct create_case {
    const char *name;
    void (*edit)(shd_environment_desc *desc, shd_image *image);
    shd_result expected;
    const char *message;
};
static const struct create_case k_create[] = {
    {"create/default", edit_nothing, SHD_OK, ""},
    {"create/no_tables", edit_no_tables, SHD_OK, ""},
    {"create/size", edit_size, SHD_ERROR_INVALID_ARGUMENT, "environment.struct_size"},
    {"create/no_projection", edit_no_projection, SHD_ERROR_INVALID_ARGUMENT,
     "environment.projection: 0 is not in 1..5"},
    {"create/projection", edit_projection, SHD_ERROR_INVALID_ARGUMENT, "environment.projection: 6 is not in 1..5"},
    {"create/no_image", edit_no_image, SHD_ERROR_INVALID_ARGUMENT, "environment.image: NULL"},
    {"create/no_pixels", edit_no_pixels, SHD_ERROR_INVALID_ARGUMENT, "environment.image.pixels: NULL"},
    {"create/format", edit_format, SHD_ERROR_INVALID_ARGUMENT, "environment.image.format: 0 is not a format"},
    {"create/width", edit_width, SHD_ERROR_INVALID_ARGUMENT, "environment.image.width: 0"},
    {"create/huge", edit_huge, SHD_ERROR_INVALID_ARGUMENT, "67174400 is not in 1..67108864"},
    {"create/cube", edit_cube, SHD_ERROR_INVALID_ARGUMENT, "environment.image.height: 7 is not 48"},
    {"create/disc", edit_disc, SHD_ERROR_INVALID_ARGUMENT, "environment.image.height: 7 is not 8"},
    {"create/irradiance", edit_irradiance, SHD_ERROR_INVALID_ARGUMENT, "environment.irradiance: 2 is not in 0..1"},
    {"create/irradiance_minus", edit_irradiance_minus, SHD_ERROR_INVALID_ARGUMENT, "environment.irradiance"},
    {"create/tables", edit_tables, SHD_ERROR_UNSUPPORTED, "environment.tables: bits 0x8"},
};

static void test_create(void **state)
{
    const struct create_case *row = (const struct create_case *)*state;
    shd_image image = sky_image(SHD_PROJECTION_LAT_LONG, 8, 8);
    shd_environment_desc desc = shd_environment_desc_default();
    shd_environment *environment = (shd_environment *)(void *)&desc;
    void *pixels = image.pixels;
    desc.image = &image;
    row->edit(&desc, &image);
    shd_assert_result(row->name, shd_environment_create(g_context, &desc, &environment), row->expected, row->message);
    assert_true((environment != NULL) == (row->expected == SHD_OK));
    shd_environment_release(environment);
    free(pixels);
}

/** Every wrong argument of the lookups. */
static void test_refusals(void **state)
{
    shd_image image = sky_image(SHD_PROJECTION_LAT_LONG, 8, 8);
    shd_environment_desc desc = shd_environment_desc_default();
    shd_environment_lookups lookups = lookups_of(DIRECTIONS), none = lookups_of(0);
    shd_environment_info info = shd_environment_info_default();
    shd_environment *bare = NULL;
    shd_environment_values light;
    const shd_result bad = SHD_ERROR_INVALID_ARGUMENT;
    (void)state;
    outputs(&light);
    desc.image = &image;
    desc.tables = SHD_ENVIRONMENT_TABLE_NONE;
    shd_assert_result("out", shd_environment_create(g_context, &desc, NULL), bad, "out_environment: NULL");
    shd_assert_result("context", shd_environment_create(NULL, &desc, &bare), bad, "context: NULL");
    shd_assert_result("desc", shd_environment_create(g_context, NULL, &bare), bad, "environment: NULL");
    shd_assert_ok(shd_environment_create(g_context, &desc, &bare));
    shd_assert_ok(shd_environment_get_info(bare, &info));
    assert_int_equal(info.tables, 0);
    assert_int_equal(info.map_size, 0);
    shd_assert_ok(shd_environment_sample_irradiance(bare, &lookups, &light));
    shd_assert_ok(shd_environment_sample_irradiance(bare, &none, &light));
    shd_assert_result("no radiance", shd_environment_sample_radiance(bare, &lookups, &light), bad,
                      "environment: made without SHD_ENVIRONMENT_TABLE_RADIANCE");
    lookups.roughness = shd_f32_column(g_direction[0], 0);
    shd_assert_result("no GGX", shd_environment_sample_radiance(bare, &lookups, &light), bad,
                      "SHD_ENVIRONMENT_TABLE_GGX");
    shd_assert_result("roughness", shd_environment_sample_irradiance(bare, &lookups, &light), bad,
                      "lookups.roughness: set");
    lookups.exponent = lookups.roughness;
    shd_assert_result("both", shd_environment_sample_radiance(bare, &lookups, &light), bad, "lookups.exponent: set");
    lookups.roughness.data = NULL;
    shd_assert_result("no Phong", shd_environment_sample_radiance(bare, &lookups, &light), bad,
                      "SHD_ENVIRONMENT_TABLE_PHONG");
    lookups.exponent.data = NULL;
    shd_assert_result("rgb", shd_environment_sample_irradiance(bare, &lookups, NULL), bad, "values: NULL");
    shd_assert_result("lookups", shd_environment_sample_irradiance(bare, NULL, &light), bad, "lookups: NULL");
    shd_assert_result("handle", shd_environment_sample_irradiance(NULL, &lookups, &light), bad, "environment: NULL");
    shd_assert_result("info", shd_environment_get_info(NULL, &info), bad, "environment: NULL");
    shd_assert_result("out_info", shd_environment_get_info(bare, NULL), bad, "out_info: NULL");
    light.channel[1].data = g_direction[0];
    shd_assert_result("overlap", shd_environment_sample_irradiance(bare, &lookups, &light), bad, "overlap");
    outputs(&light);
    lookups.direction[2].data = NULL;
    shd_assert_result("direction", shd_environment_sample_irradiance(bare, &lookups, &light), bad,
                      "lookups.direction[2]");
    light.channel[0].data = light.channel[2].data = NULL;
    shd_assert_ok(shd_environment_sample_irradiance(bare, &none, &light));
    shd_environment_release(bare);
    free(image.pixels);
}

/** The n-th allocation fails, for every n, once or for good. */
static void test_faults(void **state)
{
    shd_fault_allocator faults = {0};
    const shd_context_desc desc = shd_fault_context_desc(&faults);
    shd_image image = sky_image(SHD_PROJECTION_LAT_LONG, 9, 5);
    shd_environment_desc of = shd_environment_desc_default();
    shd_context *context = NULL;
    int failures = 0;
    (void)state;
    of.image = &image;
    of.irradiance = SHD_IRRADIANCE_CONVOLVED;
    shd_assert_ok(shd_context_create(&desc, &context));
    for (int persistent = 0; persistent < 2; ++persistent) {
        for (size_t n = 1;; n += n < 40 ? 1 : 61) {
            shd_environment *environment = NULL;
            const size_t blocks = faults.live_blocks;
            shd_result result;
            shd_fault_arm(&faults, n, persistent);
            result = shd_environment_create(context, &of, &environment);
            shd_fault_arm(&faults, 0, 0);
            if (result == SHD_OK) {
                shd_environment_release(environment);
                break;
            }
            assert_int_equal(result, SHD_ERROR_OUT_OF_MEMORY);
            assert_null(environment);
            assert_true(faults.live_blocks <= blocks + 1); /* a slab of handles may stay */
            ++failures;
        }
    }
    assert_true(failures > 20);
    shd_context_release(context);
    shd_assert_all_freed("environment", &faults);
    free(image.pixels);
}

int main(void)
{
    ADD_ROWS(k_create, test_create);
    ADD_ROWS(k_lobes, test_lobe);
    ADD_ROWS(k_projections, test_projection);
    add("irradiance", test_irradiance, NULL);
    add("constant", test_constant, NULL);
    add("same_bits", test_same_bits, NULL);
    add("bad_texels", test_bad_texels, NULL);
    add("bad_lookups", test_bad_lookups, NULL);
    add("refusals", test_refusals, NULL);
    add("faults", test_faults, NULL);
    return _cmocka_run_group_tests("environment", g_tests, g_count, open_context, close_context);
}
