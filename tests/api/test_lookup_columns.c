/* SPDX-License-Identifier: MIT */
/* Lookups with some of their columns: calls of every length give the bits of one large call on every SIMD target, and
 * absent columns give the bits of columns of zeros. Textures are 2D in layers, 3D, and of directions. */
#include "support/filters.h"
#include "support/rows.h"

enum { POINTS = 37, REALS = 10, LAYER = REALS, RANDOM, COLUMNS, U = 1, V = 2, W = 1 << 7 };

/* Optional columns: bits of a mask, in the order of column_of(). */
enum { DUDX = 4, DVDX = 8, DUDY = 16, DVDY = 32, LOD = 64, DWDX = 256, DWDY = 512, ALL_STEPS = 0x33c };
static const unsigned k_masks[] = {
    0,
    ALL_STEPS,
    DUDX | DVDY,
    DVDX | DUDY | DWDX,
    DWDY,
    LOD,
    LOD | ALL_STEPS,
    1u << LAYER,
    DUDX | DVDY | 1u << LAYER | 1u << RANDOM,
    LOD | 1u << LAYER,
    1u << RANDOM,
};

struct kind {
    const char *name;
    uint32_t layers, depth;
    shd_projection projection;
};
static const struct kind k_kinds[] = {
    {"layers", 3, 0, SHD_PROJECTION_NONE},
    {"slices", 1, 5, SHD_PROJECTION_NONE},
    {"directions", 1, 0, SHD_PROJECTION_LAT_LONG},
};

static float g_reals[REALS][POINTS], g_zeros[POINTS];
static uint32_t g_integers[2][POINTS], g_zero_integers[POINTS];

static void fill_inputs(void)
{
    uint32_t state = 23;
    size_t c, i;
    for (i = 0; i < POINTS; ++i) {
        for (c = 0; c < REALS; ++c) {
            const float x = (float)(shd_noise(&state) >> 8) * (2.0f / 16777216.0f) - 1.0f;
            g_reals[c][i] = c < 2 || 1u << c == W ? x : ldexpf(x, -(int)((i + c) % 6));
            if ((i + 7 * c) % 23 == 0) g_reals[c][i] = (i + c) % 2 ? NAN : INFINITY;
        }
        g_integers[0][i] = shd_noise(&state) % 4;
        g_integers[1][i] = shd_noise(&state);
    }
}

static shd_f32_in *column_of(shd_lookups *lookups, size_t c)
{
    shd_f32_in *const columns[REALS] = {&lookups->u,    &lookups->v,   &lookups->dudx, &lookups->dvdx, &lookups->dudy,
                                        &lookups->dvdy, &lookups->lod, &lookups->w,    &lookups->dwdx, &lookups->dwdy};
    return columns[c];
}

/** Looks up with the columns of a mask. If `zeros`, those steps and layers that are not in the mask are 0. */
static shd_result look_up(const shd_texture *texture, const shd_sampler *sampler, unsigned mask, int zeros,
                          size_t first, size_t count, float out[4][POINTS], size_t *nonfinite)
{
    shd_lookups lookups = shd_lookups_default();
    shd_texels texels = shd_texels_default();
    shd_result result;
    size_t c;
    lookups.count = count;
    mask |= U | V | W;
    for (c = 0; c < REALS; ++c) {
        const int is_step = (ALL_STEPS >> c & 1) != 0;
        if (mask >> c & 1) column_of(&lookups, c)->data = g_reals[c] + first;
        if (zeros && is_step && !(mask >> c & 1)) column_of(&lookups, c)->data = g_zeros + first;
    }
    if (mask >> LAYER & 1) lookups.layer.data = g_integers[0] + first;
    if (zeros && !(mask >> LAYER & 1)) lookups.layer.data = g_zero_integers + first;
    if (mask >> RANDOM & 1) lookups.random.data = g_integers[1] + first;
    for (c = 0; c < 4; ++c) texels.channel[c].data = out[c] + first;
    result = shd_texture_sample(texture, sampler, &lookups, &texels);
    *nonfinite += texels.nonfinite_count;
    return result;
}

static void check_mask(const char *what, const shd_texture *texture, const shd_sampler *sampler, unsigned mask)
{
    static float whole[4][POINTS], other[4][POINTS];
    size_t found = 0, in_parts, with_zeros = 0, step, first;
    shd_assert_ok(look_up(texture, sampler, mask, 0, 0, POINTS, whole, &found));
    for (step = 1; step <= 19; ++step) {
        in_parts = 0;
        memset(other, 0x7f, sizeof other);
        for (first = 0; first < POINTS; first += step) {
            const size_t count = POINTS - first < step ? POINTS - first : step;
            shd_assert_ok(look_up(texture, sampler, mask, 0, first, count, other, &in_parts));
        }
        if (memcmp(other, whole, sizeof whole) != 0)
            fail_msg("%s, columns %x: calls of %zu lookups differ", what, mask, step);
        if (in_parts != found) fail_msg("%s, columns %x: calls of %zu count %zu", what, mask, step, in_parts);
    }
    shd_assert_ok(look_up(texture, sampler, mask, 1, 0, POINTS, other, &with_zeros));
    if (memcmp(other, whole, sizeof whole) != 0 || with_zeros != found)
        fail_msg("%s, columns %x: columns of zeros differ", what, mask);
}

static shd_texture *make_texture(int target, const struct kind *kind, const shd_filter_row *row)
{
    static unsigned char texels[16 * 8 * 5 * 4];
    shd_texture_desc desc = shd_texture_desc_default();
    shd_texture *texture = NULL;
    uint32_t state = 9;
    size_t i;
    for (i = 0; i < sizeof texels; ++i) texels[i] = (unsigned char)(shd_noise(&state) >> 24);
    desc.format = SHD_FORMAT_RGBA8;
    desc.width = 16;
    desc.height = 8;
    desc.layer_count = kind->layers;
    if (kind->depth) desc.kind = SHD_TEXTURE_KIND_3D;
    if (kind->projection) desc.kind = SHD_TEXTURE_KIND_DIRECTIONS;
    desc.depth = kind->depth;
    desc.projection = kind->projection;
    desc.texels = texels;
    desc.tables = SHD_TABLE_MIPMAP;
    if (row->filter == SHD_FILTER_RIPMAP) desc.tables |= SHD_TABLE_RIPMAP;
    if (row->filter == SHD_FILTER_SUMMED_AREA) desc.tables |= SHD_TABLE_SUMMED_AREA;
    shd_assert_ok(shd_texture_create(g_targets.context[target], &desc, &texture));
    return texture;
}

static void test_columns(void **state)
{
    const shd_filter_row *row = (const shd_filter_row *)*state;
    const int flat = row->filter == SHD_FILTER_RIPMAP || row->filter == SHD_FILTER_SUMMED_AREA;
    shd_sampler *sampler = shd_make_sampler(row, 0);
    size_t kind, m;
    int target;
    for (kind = 0; kind < (flat ? 1 : sizeof k_kinds / sizeof k_kinds[0]); ++kind) {
        for (target = 0; target < g_targets.count; ++target) {
            shd_texture *texture = make_texture(target, &k_kinds[kind], row);
            char what[96];
            snprintf(what, sizeof what, "%s, %s, %s", row->name, k_kinds[kind].name,
                     shd_context_get_simd_target(g_targets.context[target]));
            for (m = 0; m < sizeof k_masks / sizeof k_masks[0]; ++m) check_mask(what, texture, sampler, k_masks[m]);
            shd_texture_release(texture);
        }
    }
    shd_sampler_release(sampler);
}

int main(void)
{
    fill_inputs();
    ADD_ROWS(k_filters, test_columns);
    return _cmocka_run_group_tests("api.lookup_columns", g_tests, g_count, shd_open_targets, shd_close_targets);
}
