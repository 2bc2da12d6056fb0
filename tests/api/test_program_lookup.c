/* SPDX-License-Identifier: MIT */
/* A fragment program that looks textures up: the frame has the bits of a model with this texture, and the lookups do
 * not use the executor. */
#include <pthread.h>

#include "support/frame.h"
#include "support/noise.h"

enum { k_width = 96, k_height = 64, k_side = 32 };

/* Two triangles in perspective over the frame; position, normal, uv. */
static const float k_quad[6][8] = {{-1, -1, 0.2f, 0, 0, 1, 0, 3}, {1, -1, 0.2f, 0, 0, 1, 2, 3},
                                   {1, 1, 0.8f, 0, 0, 1, 2, 0},   {-1, -1, 0.2f, 0, 0, 1, 0, 3},
                                   {1, 1, 0.8f, 0, 0, 1, 2, 0},   {-1, 1, 0.8f, 0, 0, 1, 0, 0}};

/* Input of the program, and its count of failures. */
struct look {
    shd_texture *texture;
    shd_sampler *sampler;
    pthread_mutex_t lock;
    size_t calls, failures;
};

static void look_up(const shd_fragments *in, shd_radiance *out, void *user_data)
{
    struct look *look = (struct look *)user_data;
    shd_lookups where = shd_lookups_default();
    shd_texels texels = {0};
    shd_result result;
    where.count = in->count;
    where.u.data = in->u, where.v.data = in->v;
    where.dudx.data = in->dudx, where.dvdx.data = in->dvdx, where.dudy.data = in->dudy, where.dvdy.data = in->dvdy;
    texels.channel[0].data = out->r, texels.channel[1].data = out->g, texels.channel[2].data = out->b;
    result = shd_texture_sample(look->texture, look->sampler, &where, &texels);
    pthread_mutex_lock(&look->lock);
    look->calls += 1;
    look->failures += result != SHD_OK;
    pthread_mutex_unlock(&look->lock);
}

/* The executor of the texture's context: lookups of few rows must not call it. */
static shd_result count_calls(size_t count, shd_task_fn task, void *task_data, void *user_data)
{
    uint32_t i;
    ++*(size_t *)user_data;
    for (i = 0; i < count; ++i) task(i, 0, task_data);
    return SHD_OK;
}

static shd_texture *create_texture(shd_context *context)
{
    static uint8_t texels[k_side][k_side][4];
    shd_texture_desc desc = shd_texture_desc_default();
    shd_texture *texture = NULL;
    uint32_t seed = 5, i;
    for (i = 0; i < sizeof texels; ++i) {
        shd_noise(&seed);
        (&texels[0][0][0])[i] = (uint8_t)(seed >> 24);
    }
    desc.format = SHD_FORMAT_RGBA8_SRGB;
    desc.width = desc.height = k_side;
    desc.texels = texels;
    desc.tables = SHD_TABLE_MIPMAP;
    shd_assert_ok(shd_texture_create(context, &desc, &texture));
    return texture;
}

static void render(const shd_material_desc *material, float *colors)
{
    shd_frame f;
    int c;
    shd_frame_open(&f, k_width, k_height);
    shd_frame_draw(&f, k_quad[0], 6, material);
    shd_frame_render(&f);
    for (c = 0; c < 3; ++c) {
        memcpy(colors + c * k_width * k_height, f.plane[SHD_PLANE_R + c], k_width * k_height * sizeof *colors);
    }
    shd_frame_close(&f);
}

static void test_bits(void **state)
{
    static float expected[3 * k_width * k_height], got[3 * k_width * k_height];
    static struct look look = {NULL, NULL, PTHREAD_MUTEX_INITIALIZER, 0, 0};
    shd_material_desc model = shd_material_desc_default(), program = shd_material_desc_default();
    shd_context_desc cd = shd_context_desc_default();
    shd_context *context = NULL;
    shd_slot slot;
    size_t i, different = 0, calls = 0;
    (void)state;
    cd.executor.parallel_for = count_calls, cd.executor.user_data = &calls, cd.executor.worker_count = 2;
    shd_assert_ok(shd_context_create(&cd, &context));
    look.texture = create_texture(context);
    shd_assert_ok(shd_sampler_create(context, NULL, &look.sampler));
    model.model = SHD_MODEL_UNLIT;
    for (i = 0; i < 3; ++i) model.diffuse[i] = 1.0f;
    slot = shd_slot_texture(SHD_SLOT_DIFFUSE, look.texture, look.sampler);
    model.slots = &slot;
    model.slot_count = 1;
    program.model = SHD_MODEL_PROGRAM;
    program.program.fragment = look_up, program.program.user_data = &look;
    render(&model, expected);
    calls = 0;
    render(&program, got);
    assert_int_equal(calls, 0);
    assert_true(look.calls > 0);
    assert_int_equal(look.failures, 0);
    assert_memory_equal(got, expected, sizeof got);
    for (i = 1; i < k_width * k_height; ++i) different += got[i] != got[0];
    assert_true(different > k_width * k_height / 2);
    shd_texture_release(look.texture);
    shd_sampler_release(look.sampler);
    shd_context_release(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {{"program/looks_up", test_bits, NULL, NULL, NULL}};
    return _cmocka_run_group_tests("api.program_lookup", tests, 1, NULL, NULL);
}
