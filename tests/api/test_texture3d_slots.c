/* SPDX-License-Identifier: MIT */
/* 3D textures in slots: the colours of frames are those of shd_texture_sample() at the places of the pixels. */
#include "support/frame.h"
#include "support/slots.h"
#include "support/volume_scene.h"

enum { k_size = 24, k_pixels = k_size * k_size };

/* A frame of one quad with an unlit material that reads one 3D texture. */
typedef struct scene {
    shd_frame f;
    shd_material_desc material;
    shd_slot_list slots;
    shd_texture *texture;
    shd_sampler *sampler;
    float quad[48];
} scene;

static void open_scene(scene *s, shd_format format, shd_filter filter)
{
    shd_sampler_desc sampler = shd_sampler_desc_default();
    int c;
    memset(s, 0, sizeof *s);
    shd_frame_open_aovs(&s->f, k_size, k_size, 1, SHD_AOV_TRIANGLE | SHD_AOV_LEVEL);
    shd_frame_quad(-1, -1, 1, 1, 0.25f, 0.75f, s->quad);
    s->material = shd_material_desc_default();
    s->material.model = SHD_MODEL_UNLIT;
    for (c = 0; c < 3; ++c) s->material.diffuse[c] = 1.0f;
    s->texture = shd_solid_texture(s->f.context, format);
    sampler.filter = filter;
    sampler.wrap_u = SHD_WRAP_MIRROR;
    sampler.wrap_v = SHD_WRAP_REPEAT;
    sampler.wrap_w = SHD_WRAP_CLAMP;
    shd_assert_ok(shd_sampler_create(s->f.context, &sampler, &s->sampler));
}

static void close_scene(scene *s)
{
    shd_texture_release(s->texture);
    shd_sampler_release(s->sampler);
    shd_frame_close(&s->f);
}

static shd_slot *add_slot(scene *s, shd_slot_target target, shd_place_space space)
{
    shd_slot *slot = shd_slot_list_add(&s->slots, &s->material, shd_slot_texture(target, s->texture, s->sampler));
    slot->place_space = space;
    return slot;
}

/* Places of the pixels with their derivatives, and the values there. */
static struct pixels {
    float in[9][k_pixels]; /* u, v, w, then d/dx and d/dy of each */
    float color[4][k_pixels], lod[k_pixels];
    uint32_t level[k_pixels];
} g;

static void sample(const scene *s)
{
    shd_lookups lookups = shd_lookups_default();
    shd_texels texels = shd_texels_default();
    shd_levels levels = shd_levels_default();
    shd_f32_in *const column[9] = {&lookups.u,    &lookups.v,    &lookups.w,    &lookups.dudx, &lookups.dvdx,
                                   &lookups.dwdx, &lookups.dudy, &lookups.dvdy, &lookups.dwdy};
    int c;
    lookups.count = k_pixels;
    for (c = 0; c < 9; ++c) column[c]->data = g.in[c];
    for (c = 0; c < 4; ++c) texels.channel[c].data = g.color[c];
    levels.lod.data = g.lod;
    levels.level.data = g.level;
    shd_assert_ok(shd_texture_sample(s->texture, s->sampler, &lookups, &texels));
    shd_assert_ok(shd_texture_query_levels(s->texture, s->sampler, &lookups, &levels));
}

/* World positions of the pixels of the quad under the identity view, and `width` times their steps. */
static void find_quad_places(float width)
{
    const double step = 2.0 / k_size;
    int i;
    memset(&g, 0, sizeof g);
    for (i = 0; i < k_pixels; ++i) {
        const double x = (i % k_size + 0.5) * step - 1, y = 1 - (i / k_size + 0.5) * step;
        g.in[0][i] = (float)x;
        g.in[1][i] = (float)y;
        g.in[2][i] = (float)(0.5 + 0.25 * x);
        g.in[3][i] = width * (float)step;
        g.in[5][i] = width * (float)(0.25 * step);
        g.in[7][i] = width * (float)-step;
    }
}

static void expect_colors(const scene *s, double error)
{
    size_t i;
    int c;
    for (i = 0; i < k_pixels; ++i) {
        assert_true(s->f.triangle[i] < 2);
        for (c = 0; c < 3; ++c) {
            shd_assert_close("colour", i, (double)s->f.plane[c][i], (double)g.color[c][i], error, 0);
        }
        shd_assert_close("lod", i, (double)s->f.plane[SHD_PLANE_LOD][i], (double)g.lod[i], 1e-4, 0);
        assert_true(s->f.u32[SHD_PLANE_LEVEL][i] == g.level[i]);
    }
}

/* World space, at every frequency, with factors of the derivatives; 0 reads level 0. */
static void test_world(void **state)
{
    static const shd_filter k_filters[] = {SHD_FILTER_TRILINEAR, SHD_FILTER_ANISOTROPIC, SHD_FILTER_BILINEAR};
    int k, frequency;
    (void)state;
    for (k = 0; k < 3; ++k) {
        for (frequency = SHD_FREQUENCY_PHONG; frequency <= SHD_FREQUENCY_FLAT; ++frequency) {
            const float width = (float)(2 - frequency);
            scene s;
            open_scene(&s, SHD_FORMAT_RGBA8, k_filters[k]);
            add_slot(&s, SHD_SLOT_DIFFUSE, SHD_PLACE_SPACE_WORLD)->place_width = width;
            shd_frame_draw(&s.f, s.quad, 6, &s.material)->frequency = (shd_frequency)frequency;
            shd_frame_render(&s.f);
            find_quad_places(width);
            sample(&s);
            assert_true(g.lod[0] > 0.2f || width == 0.0f);
            expect_colors(&s, 1e-4);
            close_scene(&s);
        }
    }
}

/* Object space through a matrix, and the transform of the slot after it. */
static void test_object(void **state)
{
    static const float k_to_world[16] = {0, 2, 0, 0, -4, 0, 0, 0, 0, 0, 1, 0, 0.5f, 0.25f, 0, 1};
    static const float k_place[16] = {3, 0, 0, 0, 0, 0, 0.5f, 0, 0, -1, 0, 0, 7, -2, 1, 1};
    const double step = 2.0 / k_size;
    scene s;
    int i;
    (void)state;
    open_scene(&s, SHD_FORMAT_RGBA8_SRGB, SHD_FILTER_TRILINEAR);
    memcpy(add_slot(&s, SHD_SLOT_DIFFUSE, SHD_PLACE_SPACE_OBJECT)->place_transform, k_place, sizeof k_place);
    memcpy(shd_frame_draw(&s.f, s.quad, 6, &s.material)->object_to_world, k_to_world, sizeof k_to_world);
    shd_frame_render(&s.f);
    memset(&g, 0, sizeof g);
    for (i = 0; i < k_pixels; ++i) {
        /* (X, Y) = (-4 y + 1/2, 2 x + 1/4) and z = 1/2 + x / 4 */
        const double world_x = (i % k_size + 0.5) * step - 1, world_y = 1 - (i / k_size + 0.5) * step;
        const double x = (world_y - 0.25) / 2, y = (0.5 - world_x) / 4, z = 0.5 + x / 4;
        g.in[0][i] = (float)(3 * x + 7);
        g.in[1][i] = (float)(-z - 2);
        g.in[2][i] = (float)(0.5 * y + 1);
        g.in[5][i] = (float)(-0.5 * step / 4);
        g.in[6][i] = (float)(-3 * step / 2);
        g.in[7][i] = (float)(step / 8);
    }
    sample(&s);
    expect_colors(&s, 1e-4);
    close_scene(&s);
}

/* A procedure that looks up its fragments' positions: the same bits as the slot. */
static void procedure(const shd_fragments *in, float *const out[4], void *user_data)
{
    const scene *const s = (const scene *)user_data;
    shd_lookups lookups = shd_lookups_default();
    shd_texels texels = shd_texels_default();
    int c;
    lookups.count = in->count;
    lookups.u.data = in->px;
    lookups.v.data = in->py;
    lookups.w.data = in->pz;
    for (c = 0; c < 3; ++c) texels.channel[c].data = out[c];
    if (shd_texture_sample(s->texture, s->sampler, &lookups, &texels) != SHD_OK) out[0][0] = -1;
}

static void test_same_bits_as_procedure(void **state)
{
    static const shd_format k_formats[] = {SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA16F};
    static float want[3][k_pixels];
    int format, kind, c;
    (void)state;
    for (format = 0; format < 2; ++format) {
        for (kind = 0; kind < 2; ++kind) {
            scene s;
            open_scene(&s, k_formats[format], SHD_FILTER_BILINEAR);
            if (kind == 0) add_slot(&s, SHD_SLOT_DIFFUSE, SHD_PLACE_SPACE_WORLD);
            if (kind == 1) {
                shd_slot_list_add(&s.slots, &s.material, shd_slot_procedure(SHD_SLOT_DIFFUSE, procedure, &s));
            }
            shd_frame_draw(&s.f, s.quad, 6, &s.material);
            shd_frame_render(&s.f);
            for (c = 0; c < 3; ++c) {
                if (kind == 0) memcpy(want[c], s.f.plane[c], sizeof want[c]);
                assert_memory_equal(s.f.plane[c], want[c], sizeof want[c]);
            }
            close_scene(&s);
        }
    }
}

/* Slots with equal places share lookups, and others do not: each changed field moves the values of the second slot. */
static void move_nothing(shd_slot *slot) { (void)slot; }
static void move_transform(shd_slot *slot) { slot->place_transform[13] = 0.3f; }
static void move_space(shd_slot *slot) { slot->place_space = SHD_PLACE_SPACE_OBJECT; }
static void move_width(shd_slot *slot) { slot->place_width = 3; }
static void move_uv(shd_slot *slot) { slot->uv_transform[2] = 0.5f; }

static void test_two_slots(void **state)
{
    static void (*const k_moves[])(shd_slot *) = {move_nothing, move_transform, move_space, move_width, move_uv};
    static float one[2][k_pixels];
    size_t k, i;
    int kind;
    (void)state;
    for (k = 0; k < sizeof k_moves / sizeof k_moves[0]; ++k) {
        for (kind = 0; kind < 3; ++kind) { /* the first slot, the second slot, both */
            scene s;
            shd_slot *slot;
            open_scene(&s, SHD_FORMAT_RGBA8, SHD_FILTER_TRILINEAR);
            s.material.blend = SHD_BLEND_STRAIGHT;
            if (kind != 1) add_slot(&s, SHD_SLOT_DIFFUSE, SHD_PLACE_SPACE_WORLD);
            if (kind != 0) {
                slot = add_slot(&s, SHD_SLOT_OPACITY, SHD_PLACE_SPACE_WORLD);
                slot->channel = 1;
                k_moves[k](slot);
            }
            shd_frame_draw(&s.f, s.quad, 6, &s.material)->object_to_world[12] = 0.125f;
            shd_frame_render(&s.f);
            for (i = 0; i < k_pixels; ++i) {
                const float a = s.f.plane[SHD_PLANE_A][i];
                if (kind < 2) one[kind][i] = kind == 0 ? s.f.plane[0][i] : a;
                if (kind == 2 && s.f.triangle[i] < 2) {
                    const double alpha = (double)one[1][i];
                    shd_assert_close("colour", i, (double)s.f.plane[0][i], alpha * (double)one[0][i], 1e-5, 0);
                }
            }
            close_scene(&s);
        }
    }
}

/* Workers and SIMD targets give the same bits. */
static void test_workers(void **state)
{
    static float whole[3][k_pixels], part[k_pixels];
    int simd, c, tried = 0;
    scene s;
    (void)state;
    open_scene(&s, SHD_FORMAT_RGBA8, SHD_FILTER_ANISOTROPIC);
    add_slot(&s, SHD_SLOT_DIFFUSE, SHD_PLACE_SPACE_OBJECT)->place_transform[4] = 0.5f;
    shd_frame_draw(&s.f, s.quad, 6, &s.material);
    shd_frame_render(&s.f);
    for (c = 0; c < 3; ++c) memcpy(whole[c], s.f.plane[c], sizeof whole[c]);
    for (simd = SHD_SIMD_BASELINE; simd <= SHD_SIMD_WASM; ++simd) {
        shd_context_desc desc = shd_context_desc_default();
        shd_context *context = NULL;
        desc.simd = (shd_simd)simd;
        desc.worker_count = simd % 2 ? 1 : 3;
        if (shd_context_create(&desc, &context) != SHD_OK) continue;
        shd_assert_ok(shd_render(context, &s.f.desc));
        for (c = 0; c < 3; ++c) {
            const shd_f32_out out = {part, 0};
            shd_assert_ok(shd_framebuffer_read_plane(s.f.framebuffer, (shd_plane)c, &out));
            assert_memory_equal(part, whole[c], sizeof part);
        }
        shd_context_release(context);
        ++tried;
    }
    assert_true(tried >= 1);
    close_scene(&s);
}

/* ---- refused slots ---- */

struct bad_case {
    const char *name;
    void (*edit)(shd_slot *slot);
    shd_filter filter;
    shd_result expected;
    const char *message;
};
static void edit_nothing(shd_slot *s) { (void)s; }
static void edit_height(shd_slot *s) { s->target = SHD_SLOT_HEIGHT; }
static void edit_matcap(shd_slot *s) { s->target = SHD_SLOT_MATCAP; }
static void edit_default_sampler(shd_slot *s) { s->sampler = NULL; }
static void edit_space(shd_slot *s) { s->place_space = (shd_place_space)2; }
static void edit_transform(shd_slot *s) { s->place_transform[9] = (float)NAN; }
static void edit_projective(shd_slot *s) { s->place_transform[3] = 1; }
static void edit_coordinates(shd_slot *s) { s->coordinates = SHD_SLOT_COORDINATES_PROJECTED; }
static void edit_width(shd_slot *s) { s->place_width = 1001; }

static const struct bad_case k_bad[] = {
    {"slot/trilinear", edit_nothing, SHD_FILTER_TRILINEAR, SHD_OK, ""},
    {"slot/ewa", edit_nothing, SHD_FILTER_EWA, SHD_OK, ""},
    {"slot/default_sampler", edit_default_sampler, SHD_FILTER_RIPMAP, SHD_OK, ""},
    {"slot/height", edit_height, SHD_FILTER_TRILINEAR, SHD_ERROR_UNSUPPORTED,
     "material.slots[0].texture: a texture of 3D, not a 2D one"},
    {"slot/matcap", edit_matcap, SHD_FILTER_TRILINEAR, SHD_ERROR_UNSUPPORTED,
     "material.slots[0].texture: a texture of 3D, not a 2D one"},
    {"slot/ripmap", edit_nothing, SHD_FILTER_RIPMAP, SHD_ERROR_UNSUPPORTED,
     "material.slots[0].sampler.filter: RIPMAP, but the texture is 3D"},
    {"slot/space", edit_space, SHD_FILTER_TRILINEAR, SHD_ERROR_INVALID_ARGUMENT,
     "material.slots[0].place_space: 2 is not in 0..1"},
    {"slot/transform", edit_transform, SHD_FILTER_TRILINEAR, SHD_ERROR_INVALID_ARGUMENT,
     "material.slots[0].place_transform[9]: "},
    {"slot/projective", edit_projective, SHD_FILTER_TRILINEAR, SHD_ERROR_INVALID_ARGUMENT,
     "material.slots[0].place_transform: last row is (1, 0, 0, 1), not (0, 0, 0, 1)"},
    {"slot/coordinates", edit_coordinates, SHD_FILTER_TRILINEAR, SHD_ERROR_INVALID_ARGUMENT,
     "material.slots[0].coordinates: 1, but the texture is 3D"},
    {"slot/width", edit_width, SHD_FILTER_TRILINEAR, SHD_ERROR_INVALID_ARGUMENT,
     "material.slots[0].place_width: 1001 is not in 0..1000"},
};

static void test_bad(void **state)
{
    const struct bad_case *row = (const struct bad_case *)*state;
    shd_material *material = NULL;
    scene s;
    open_scene(&s, SHD_FORMAT_RGBA8, row->filter);
    row->edit(add_slot(&s, SHD_SLOT_DIFFUSE, SHD_PLACE_SPACE_OBJECT));
    shd_assert_result(row->name, shd_material_create(s.f.context, &s.material, &material), row->expected, row->message);
    assert_true((material != NULL) == (row->expected == SHD_OK));
    shd_material_release(material);
    close_scene(&s);
}

int main(void)
{
    struct CMUnitTest tests[24] = {
        {"world", test_world, NULL, NULL, NULL},
        {"object", test_object, NULL, NULL, NULL},
        {"same_bits_as_procedure", test_same_bits_as_procedure, NULL, NULL, NULL},
        {"two_slots", test_two_slots, NULL, NULL, NULL},
        {"workers", test_workers, NULL, NULL, NULL},
    };
    size_t n = 5, i;
    for (i = 0; i < sizeof k_bad / sizeof k_bad[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_bad[i].name, test_bad, NULL, NULL, (void *)&k_bad[i]};
    }
    return _cmocka_run_group_tests("api.texture3d_slots", tests, n, NULL, NULL);
}
