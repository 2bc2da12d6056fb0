/* SPDX-License-Identifier: MIT */
/* Instances: a frame has the bits of the same draws one by one, and programs get the number of the instance. */
#include "support/scene.h"

enum { MOST = 40, DRAWS = SHD_SCENE_DRAWS };

/* Matrices that place instances next to, behind and through each other; one is singular, one mirrors. */
static void make_matrices(const float own[16], size_t count, float *out)
{
    uint32_t seed = 31;
    size_t i, c;
    for (i = 0; i < count; ++i, out += 16) {
        memcpy(out, own, 16 * sizeof(float));
        for (c = 12; c < 15; ++c) out[c] += 2.0f * shd_scene_random(&seed) - 1.0f;
        for (c = 0; c < 11; c += 5) out[c] *= 0.3f + shd_scene_random(&seed);
        out[4] = shd_scene_random(&seed) - 0.5f;
        if (i % 4 == 2) out[0] = -out[0];
        if (i % 7 == 5) out[5] = out[4] = 0.0f;
    }
}

static void open_scene(shd_scene *s, shd_scene_kind kind, uint32_t workers, shd_context **context)
{
    shd_context_desc desc = shd_context_desc_default();
    desc.worker_count = workers;
    shd_assert_ok(shd_context_create(&desc, context));
    shd_scene_open(s, kind, *context);
    { /* without the index of the draw, in which they differ */
        shd_framebuffer_info info = shd_framebuffer_info_default();
        shd_framebuffer_desc framebuffer = shd_framebuffer_desc_default();
        shd_assert_ok(shd_framebuffer_get_info(s->framebuffer, &info));
        framebuffer.width = info.width;
        framebuffer.height = info.height;
        framebuffer.sample_count = info.sample_count;
        framebuffer.aovs = info.aovs & ~(uint32_t)SHD_AOV_DRAW;
        shd_framebuffer_release(s->framebuffer);
        shd_assert_ok(shd_framebuffer_create(*context, &framebuffer, &s->framebuffer));
        s->desc.framebuffer = s->framebuffer;
    }
}

static void close_scene(shd_scene *s, shd_context *context)
{
    shd_scene_close(s);
    shd_context_release(context);
}

/* Each draw of a scene of every blend as `count` instances, against `count` separate draws. */
static void expect_same(shd_scene_kind kind, size_t count, uint32_t workers)
{
    static shd_draw separate[DRAWS * MOST];
    static float matrices[DRAWS][MOST * 16];
    shd_context *context = NULL;
    const shd_draw *draws;
    shd_scene s;
    size_t draw, i, draw_count;
    uint64_t want;
    open_scene(&s, kind, workers, &context);
    draws = s.desc.draws;
    draw_count = s.desc.draw_count;
    for (draw = 0; draw < draw_count; ++draw) {
        make_matrices(s.draw[draw].object_to_world, count, matrices[draw]);
        for (i = 0; i < count; ++i) {
            separate[draw * count + i] = s.draw[draw];
            memcpy(separate[draw * count + i].object_to_world, matrices[draw] + 16 * i, 16 * sizeof(float));
        }
        s.draw[draw].instances = matrices[draw];
        s.draw[draw].instance_count = count;
        s.draw[draw].object_to_world[12] = 77.0f; /* not used */
    }
    s.desc.draws = separate;
    s.desc.draw_count = draw_count * count;
    want = shd_scene_render(&s);
    s.desc.draws = draws;
    s.desc.draw_count = draw_count;
    assert_true(shd_scene_render(&s) == want);
    close_scene(&s, context);
}

static void test_same(void **state)
{
    static const size_t k_counts[] = {1, 2, 7, MOST};
    size_t i;
    (void)state;
    for (i = 0; i < sizeof k_counts / sizeof k_counts[0]; ++i) {
        expect_same(SHD_SCENE_SMALL, k_counts[i], 1);
        expect_same(SHD_SCENE_SMALL, k_counts[i], 3);
    }
    expect_same(SHD_SCENE_MIXED, 3, 2);
    expect_same(SHD_SCENE_GLASS, 2, 2);
}

/* Number of rows that a program got for each instance of each draw. */
struct seen {
    size_t rows[2][3];
};
static void count_rows(const shd_fragments *in, shd_radiance *out, void *user_data)
{
    struct seen *seen = (struct seen *)user_data;
    (void)out;
    assert_true(in->draw < 2 && in->instance < 3);
    assert_int_equal(in->struct_size, sizeof *in);
    seen->rows[in->draw][in->instance] += in->count;
}

static void test_program(void **state)
{
    static const float k_x[3] = {-1, 1, -1}, k_y[3] = {-1, -1, 1}, k_z[3] = {0, 0, 0};
    float matrices[3][16];
    shd_mesh_desc triangle = shd_mesh_desc_default();
    shd_material_desc program = shd_material_desc_default();
    shd_context *context = NULL;
    shd_material *material = NULL;
    shd_mesh *mesh = NULL;
    shd_draw draws[2];
    struct seen seen;
    shd_scene s;
    size_t i;
    (void)state;
    memset(&seen, 0, sizeof seen);
    open_scene(&s, SHD_SCENE_SMALL, 1, &context);
    triangle.vertex_count = 3;
    triangle.position[0].data = k_x;
    triangle.position[1].data = k_y;
    triangle.position[2].data = k_z;
    shd_assert_ok(shd_mesh_create(context, &triangle, &mesh));
    program.model = SHD_MODEL_PROGRAM;
    program.program.fragment = count_rows;
    program.program.user_data = &seen;
    shd_assert_ok(shd_material_create(context, &program, &material));
    s.desc.view = shd_render_desc_default().view;
    s.desc.draws = draws;
    s.desc.draw_count = 2;
    for (i = 0; i < 2; ++i) {
        draws[i] = shd_draw_default();
        draws[i].mesh = mesh;
        draws[i].material = material;
        draws[i].object_to_world[14] = 0.5f;
    }
    for (i = 0; i < 3; ++i) { /* the nearer ones cover less */
        memcpy(matrices[i], draws[1].object_to_world, sizeof matrices[i]);
        matrices[i][14] = 0.25f - 0.0625f * (float)i;
        matrices[i][0] = 0.5f / (float)(i + 1);
    }
    draws[1].instances = matrices[0];
    draws[1].instance_count = 3;
    (void)shd_scene_render(&s);
    assert_int_equal(s.stats.triangle_count, 4);
    for (i = 0; i < 3; ++i) assert_true(seen.rows[1][i] > 0);
    assert_true(seen.rows[0][0] > 0 && seen.rows[0][1] == 0 && seen.rows[0][2] == 0);
    shd_material_release(material);
    shd_mesh_release(mesh);
    close_scene(&s, context);
}

/* Refused: the frame keeps its bits. */
static void test_refused(void **state)
{
    static float matrices[4 * 16];
    shd_context *context = NULL;
    shd_scene s;
    uint64_t before;
    size_t i;
    (void)state;
    open_scene(&s, SHD_SCENE_SMALL, 1, &context);
    (void)shd_scene_render(&s);
    before = shd_hash_framebuffer(s.framebuffer);
    s.desc.clear_color[0] = 0.5f;
    for (i = 0; i < 4; ++i) memcpy(matrices + 16 * i, s.draw[1].object_to_world, 16 * sizeof(float));
    s.draw[1].instance_count = 4;
#define EXPECT(message) shd_assert_result(message, shd_render(context, &s.desc), SHD_ERROR_INVALID_ARGUMENT, message)
    EXPECT("render.draws[1]: draw.instances: NULL");
    s.draw[1].instances = matrices;
    matrices[2 * 16 + 5] = NAN;
    EXPECT("render.draws[1]: draw.instances[2][5]: nan is not finite");
    matrices[2 * 16 + 5] = 1.0f;
    matrices[3 * 16 + 7] = 1.0f;
    EXPECT("render.draws[1]: draw.instances[3]: the last row is not 0 0 0 1");
    matrices[3 * 16 + 7] = 0.0f;
    s.draw[1].instance_count = ((size_t)1 << 20) + 1;
    EXPECT("render.draws[1]: draw.instance_count: 1048577 is not in 0..1048576");
    s.draw[1].instance_count = (size_t)1 << 20;
    EXPECT("render.draws[1]: draw.instance_count: 1048576 after 1 in other draws exceed 1048576");
    s.draw[1].instance_count = SIZE_MAX;
    EXPECT("render.draws[1]: draw.instance_count: 18446744073709551615 is not in 0..1048576");
    assert_true(shd_hash_framebuffer(s.framebuffer) == before);
    s.draw[1].instance_count = 0; /* then the matrices have no effect */
    matrices[0] = NAN;
    shd_assert_ok(shd_render(context, &s.desc));
    close_scene(&s, context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        {"same", test_same, NULL, NULL, NULL},
        {"program", test_program, NULL, NULL, NULL},
        {"refused", test_refused, NULL, NULL, NULL},
    };
    return _cmocka_run_group_tests("api.render_instances", tests, sizeof tests / sizeof tests[0], NULL, NULL);
}
