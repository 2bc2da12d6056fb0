/* SPDX-License-Identifier: MIT */
/* Calls of few lookups: every filter, wrap and format on every SIMD target gives the bits of one large call, for every
 * length up to two vectors, with columns in records, with some channels and of borrowed texels. Nothing is written
 * beyond the last lookup. */
#include "support/filters.h"
#include "support/rows.h"

enum { POINTS = 67, CANARY = 20, RECORD = 11 };
static const float k_canary = -7.25f;

static const shd_format k_formats[] = {SHD_FORMAT_R8,   SHD_FORMAT_RGB8,    SHD_FORMAT_RGBA8,  SHD_FORMAT_RGBA8_SRGB,
                                       SHD_FORMAT_RG16, SHD_FORMAT_RGBA16F, SHD_FORMAT_RGBA32F};

static int g_borrows;       /* textures borrow their base level */
static unsigned g_unwanted; /* bit c: look_up() leaves channel c out */
static float g_in[6][POINTS];
static float g_whole[4][POINTS + CANARY], g_parts[4][POINTS + CANARY];

/** Coordinates in [-2, 2) and footprints of all sizes; some are huge or not finite. */
static void fill_inputs(void)
{
    static const float k_special[] = {NAN, INFINITY, -INFINITY, 3e38f, -1e30f, 16777216.5f, 1e-45f, -0.0f};
    uint32_t state = 11;
    size_t c, i;
    for (c = 0; c < 6; ++c) {
        for (i = 0; i < POINTS; ++i) {
            const float x = (float)(shd_noise(&state) >> 8) * (4.0f / 16777216.0f) - 2.0f;
            g_in[c][i] = c < 2 ? x : ldexpf(x, -(int)(i % 8));
            if ((i + 5 * c) % 19 == 0) g_in[c][i] = k_special[(i + c) % 8];
        }
    }
}

static shd_texture *make_texture(int target, shd_format format)
{
    static float aligned[(13 * 9 * 16 + SHD_TEXTURE_PADDING) / sizeof(float)];
    unsigned char *texels = (unsigned char *)aligned;
    shd_texture_desc desc = shd_texture_desc_default();
    shd_texture *texture = NULL;
    uint32_t state = 5;
    size_t i;
    for (i = 0; i < sizeof aligned; ++i) texels[i] = (unsigned char)(shd_noise(&state) >> 24);
    desc.format = format;
    desc.width = 13;
    desc.height = 9;
    desc.texels = texels;
    if (g_borrows) desc.flags = SHD_TEXTURE_BORROW;
    desc.tables = SHD_TABLE_MIPMAP | SHD_TABLE_RIPMAP | SHD_TABLE_SUMMED_AREA;
    shd_assert_ok(shd_texture_create(g_targets.context[target], &desc, &texture));
    return texture;
}

static shd_f32_in *column_of(shd_lookups *lookups, size_t c)
{
    shd_f32_in *const columns[6] = {&lookups->u,    &lookups->v,    &lookups->dudx,
                                    &lookups->dvdx, &lookups->dudy, &lookups->dvdy};
    return columns[c];
}

/** Filters `count` points from `first` on, with packed columns. Returns the number of points that are not finite. */
static size_t look_up(const shd_texture *texture, const shd_sampler *sampler, size_t first, size_t count,
                      float out[4][POINTS + CANARY])
{
    shd_lookups lookups = shd_lookups_default();
    shd_texels texels = shd_texels_default();
    size_t c;
    lookups.count = count;
    for (c = 0; c < 6; ++c) column_of(&lookups, c)->data = g_in[c] + first;
    for (c = 0; c < 4; ++c) texels.channel[c].data = g_unwanted >> c & 1 ? NULL : out[c] + first;
    shd_assert_ok(shd_texture_sample(texture, sampler, &lookups, &texels));
    return texels.nonfinite_count;
}

/** Filters the same points with inputs and outputs in one array of records. */
static size_t look_up_records(const shd_texture *texture, const shd_sampler *sampler, size_t first, size_t count,
                              float out[4][POINTS + CANARY])
{
    static float records[POINTS][RECORD];
    shd_lookups lookups = shd_lookups_default();
    shd_texels texels = {0}; /* the layout of 0.1 */
    size_t c, i;
    for (i = 0; i < POINTS; ++i) {
        for (c = 0; c < RECORD; ++c) records[i][c] = c < 6 && i >= first && i < first + count ? g_in[c][i] : k_canary;
    }
    lookups.count = count;
    for (c = 0; c < 6; ++c) *column_of(&lookups, c) = shd_f32_column(&records[first][c], sizeof records[0]);
    for (c = 0; c < 4; ++c) texels.channel[c] = shd_f32_out_column(&records[first][6 + c], sizeof records[0]);
    shd_assert_ok(shd_texture_sample(texture, sampler, &lookups, &texels));
    for (i = 0; i < POINTS; ++i) {
        const int filled = i >= first && i < first + count;
        assert_true(records[i][10] == k_canary);
        for (c = 0; c < 4; ++c) {
            if (filled) out[c][i] = records[i][6 + c];
            if (!filled) assert_true(records[i][6 + c] == k_canary);
        }
    }
    return texels.nonfinite_count;
}

static void clear(float out[4][POINTS + CANARY])
{
    size_t c, i;
    for (c = 0; c < 4; ++c) {
        for (i = 0; i < POINTS + CANARY; ++i) out[c][i] = k_canary;
    }
}

/** Calls of `step` lookups each give the bits of one call. */
static void check_split(const char *what, const shd_texture *texture, const shd_sampler *sampler, size_t step,
                        int records, size_t nonfinite)
{
    size_t first, c, i;
    clear(g_parts);
    for (first = 0; first < POINTS; first += step) {
        const size_t count = POINTS - first < step ? POINTS - first : step;
        nonfinite -= (records ? look_up_records : look_up)(texture, sampler, first, count, g_parts);
        for (c = 0; c < 4; ++c) {
            for (i = first + count; i < first + count + CANARY && i < POINTS + CANARY; ++i) {
                if (g_parts[c][i] != k_canary) fail_msg("%s: %zu lookups: wrote element %zu", what, count, i - first);
            }
        }
    }
    for (c = 0; c < 4; ++c) {
        if (g_unwanted >> c & 1) continue;
        if (memcmp(g_parts[c], g_whole[c], sizeof g_whole[c]) != 0)
            fail_msg("%s: calls of %zu lookups differ", what, step);
    }
    if (nonfinite != 0) fail_msg("%s: calls of %zu lookups: the number that is not finite differs", what, step);
}

static void test_bits(void **state)
{
    const shd_filter_row *row = (const shd_filter_row *)*state;
    const size_t most = row->filter == SHD_FILTER_EXACT ? 2 : 2 * 16 + 3;
    size_t f, step;
    int wrap, target;
    for (f = 0; f < sizeof k_formats / sizeof k_formats[0]; ++f) {
        if (g_borrows && k_formats[f] != SHD_FORMAT_RGBA8) continue;
        for (wrap = 0; wrap < SHD_TEST_WRAPS; ++wrap) {
            shd_sampler *sampler = shd_make_sampler(row, wrap);
            uint64_t want = 0;
            for (target = 0; target < g_targets.count; ++target) {
                shd_texture *texture = make_texture(target, k_formats[f]);
                const char *name = shd_context_get_simd_target(g_targets.context[target]);
                uint64_t hash;
                size_t nonfinite;
                char what[96];
                snprintf(what, sizeof what, "%s, format %d, %s, %s", row->name, (int)k_formats[f], k_wraps[wrap], name);
                clear(g_whole);
                nonfinite = look_up(texture, sampler, 0, POINTS, g_whole);
                hash = shd_hash(SHD_HASH_START, g_whole, sizeof g_whole);
                if (target == 0) want = hash;
                if (hash != want) fail_msg("%s: differs from the first target", what);
                for (step = 1; step <= most; ++step) check_split(what, texture, sampler, step, 0, nonfinite);
                check_split(what, texture, sampler, 1, 1, nonfinite);
                check_split(what, texture, sampler, 5, 1, nonfinite);
                for (g_unwanted = 2; g_unwanted < 16; g_unwanted += 11) {
                    check_split(what, texture, sampler, 3, 0, nonfinite);
                }
                g_unwanted = 0;
                shd_texture_release(texture);
            }
            shd_sampler_release(sampler);
        }
    }
}

static void test_borrowed(void **state)
{
    g_borrows = 1;
    test_bits(state);
    g_borrows = 0;
}

/* ---- outputs beside and on inputs ---- */

struct place_case {
    const char *name;
    size_t count;
    size_t u, v, red, green; /* first element of each column in one array */
    size_t stride;           /* stride of every column [elements] */
    const char *message;     /* NULL = accepted */
};
static const struct place_case k_places[] = {
    {"place/1_beside", 1, 0, 1, 2, 3, 1, NULL},
    {"place/1_before", 1, 3, 2, 1, 0, 1, NULL},
    {"place/1_on_u", 1, 0, 1, 0, 3, 1, "texels.channel[0]: overlaps lookups.u"},
    {"place/1_on_v", 1, 0, 1, 2, 1, 1, "texels.channel[1]: overlaps lookups.v"},
    {"place/1_on_red", 1, 0, 1, 2, 2, 1, "texels.channel[1]: overlaps texels.channel[0]"},
    {"place/1_wide_stride", 1, 0, 1, 2, 3, 1000, NULL},
    {"place/1_wide_stride_on_u", 1, 0, 1, 0, 3, 1000, "texels.channel[0]: overlaps lookups.u"},
    {"place/5_beside", 5, 0, 5, 10, 15, 1, NULL},
    {"place/5_before", 5, 15, 10, 5, 0, 1, NULL},
    {"place/5_end_of_u", 5, 0, 10, 4, 20, 1, "texels.channel[0]: overlaps lookups.u"},
    {"place/5_start_of_v", 5, 0, 10, 20, 6, 1, "texels.channel[1]: overlaps lookups.v"},
    {"place/5_end_of_red", 5, 0, 5, 10, 14, 1, "texels.channel[1]: overlaps texels.channel[0]"},
    {"place/5_between", 5, 0, 10, 5, 15, 1, NULL},
    {"place/5_end_of_v", 5, 0, 5, 9, 20, 1, "texels.channel[0]: overlaps lookups.v"},
    {"place/5_start_of_u", 5, 9, 20, 0, 5, 1, "texels.channel[1]: overlaps lookups.u"},
    {"place/5_records", 5, 0, 1, 2, 3, 4, NULL},
    {"place/5_wide_stride", 5, 0, 100, 200, 300, 4, NULL},
    {"place/5_records_on_v", 5, 0, 1, 2, 1, 4, "texels.channel[1]: overlaps lookups.v"},
    {"place/5_next_record", 5, 0, 1, 2, 7, 4, NULL},
    {"place/5_next_record_on_u", 5, 0, 1, 4, 3, 4, "texels.channel[0]: overlaps lookups.u"},
};

/** Looks up with red in channel `first` and green in channel `second`. */
static void check_place(const struct place_case *c, const shd_sampler *sampler, char first, char second)
{
    static float all[4096];
    shd_lookups lookups = shd_lookups_default();
    shd_texels texels = shd_texels_default();
    char message[96] = "", *digit;
    size_t i;
    if (c->message) snprintf(message, sizeof message, "%s", c->message);
    for (digit = message; (digit = strchr(digit, '[')) != NULL; ++digit) {
        digit[1] = (char)('0' + (digit[1] == '0' ? first : second));
    }
    for (i = 0; i < sizeof all / sizeof all[0]; ++i) all[i] = 0.25f;
    lookups.count = c->count;
    lookups.u = shd_f32_column(all + c->u, c->stride * sizeof(float));
    lookups.v = shd_f32_column(all + c->v, c->stride * sizeof(float));
    texels.channel[(int)first] = shd_f32_out_column(all + c->red, c->stride * sizeof(float));
    texels.channel[(int)second] = shd_f32_out_column(all + c->green, c->stride * sizeof(float));
    shd_assert_result(c->name, shd_texture_sample(g_targets.texture[0], sampler, &lookups, &texels),
                      c->message ? SHD_ERROR_INVALID_ARGUMENT : SHD_OK, c->message ? message : NULL);
    for (i = 0; i < sizeof all / sizeof all[0]; ++i) {
        const size_t red = i - c->red, green = i - c->green, end = c->count * c->stride;
        const int is_output = (red < end && red % c->stride == 0) || (green < end && green % c->stride == 0);
        if (c->message || !is_output) assert_true(all[i] == 0.25f);
    }
}

static void test_place(void **state)
{
    shd_sampler *sampler = shd_make_sampler(&k_filters[1], 0);
    char first, second;
    for (second = 1; second < 4; ++second) {
        for (first = 0; first < second; ++first) {
            check_place((const struct place_case *)*state, sampler, first, second);
        }
    }
    shd_sampler_release(sampler);
}

int main(void)
{
    fill_inputs();
    ADD_ROWS(k_filters, test_bits);
    ADD_ROWS(k_filters, test_borrowed);
    ADD_ROWS(k_places, test_place);
    return _cmocka_run_group_tests("api.lookup_small", g_tests, g_count, shd_open_targets, shd_close_targets);
}
