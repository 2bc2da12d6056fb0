/* SPDX-License-Identifier: MIT */
/* Entry points called with every wrong handle: NULL, a released handle, handles of each other type, a context, plain
 * memory. Each call is refused with the name of the argument, and the object of the wrong type does not change. */
#ifndef SHD_TESTS_SUPPORT_HANDLES_H
#define SHD_TESTS_SUPPORT_HANDLES_H

#include "support/scene.h"

/* Handles to try; the last one of each type in `live` is correct. */
enum { k_texture, k_sampler, k_mesh, k_material, k_light, k_framebuffer, k_shadow, k_object, k_types };
enum { k_context = k_types }; /* type of an entry point that takes a context */
struct fixture {
    shd_context *context;
    shd_scene scene;
    shd_object *object;
    void *live[k_types], *dead[k_types];
    uint64_t zeros[16];
    float column[4096];
    int ends;
};

struct entry {
    const char *name;
    int type;
    shd_result (*call)(struct fixture *f, void *handle);
    const char *message; /* "" = the call sets no error text */
    int optional;        /* NULL is allowed */
};

static inline void count_end(void *body) { ++*(int *)body; }

static inline void open_fixture(struct fixture *f)
{
    shd_shadow_desc shadow_desc = shd_shadow_desc_default();
    shd_shadow *shadow[2];
    shd_scene doomed;
    int i;
    memset(f, 0, sizeof *f);
    shd_assert_ok(shd_context_create(NULL, &f->context));
    shd_scene_open(&f->scene, SHD_SCENE_SMALL, f->context);
    shd_scene_open(&doomed, SHD_SCENE_SMALL, f->context);
    shd_assert_ok(shd_object_create(f->context, 0x54455354, &f->ends, count_end, &f->object));
    shadow_desc.size = 16;
    for (i = 0; i < 2; ++i) {
        const shd_scene *s = i ? &doomed : &f->scene;
        void **to = i ? f->dead : f->live;
        to[k_texture] = s->texture[0];
        to[k_sampler] = s->sampler[0];
        to[k_mesh] = s->mesh[0];
        to[k_material] = s->material[0];
        to[k_light] = s->light[1];
        to[k_framebuffer] = s->framebuffer;
        shd_assert_ok(shd_shadow_create(f->context, &shadow_desc, &shadow[i]));
        to[k_shadow] = shadow[i];
    }
    f->live[k_object] = f->object;
    shd_scene_close(&doomed);
    shd_shadow_release(shadow[1]);
    f->dead[k_object] = f->dead[k_light];
}

static inline void close_fixture(struct fixture *f)
{
    shd_object_release(f->object, 0x54455354);
    assert_int_equal(f->ends, 1);
    shd_shadow_release((shd_shadow *)f->live[k_shadow]);
    shd_scene_close(&f->scene);
    shd_context_release(f->context);
}

static inline void expect_refusal(const struct entry *e, struct fixture *f, void *handle)
{
    shd_assert_result(e->name, e->call(f, handle), SHD_ERROR_INVALID_ARGUMENT, e->message);
}

static inline void test_entry(void **state)
{
    const struct entry *e = (const struct entry *)*state;
    struct fixture f;
    uint64_t want;
    int type, refused = 0;
    void *right;
    open_fixture(&f);
    right = e->type == k_context ? (void *)f.context : f.live[e->type];
    want = shd_scene_render(&f.scene);
    shd_assert_ok(e->call(&f, right));
    if (e->optional) {
        shd_assert_ok(e->call(&f, NULL));
    } else {
        expect_refusal(e, &f, NULL);
    }
    for (type = 0; type < k_types; ++type) {
        expect_refusal(e, &f, f.dead[type]);
        ++refused;
        if (type == e->type) continue;
        expect_refusal(e, &f, f.live[type]);
        ++refused;
    }
    if (e->type != k_context) expect_refusal(e, &f, f.context);
    expect_refusal(e, &f, f.zeros);
    assert_int_equal(refused, 2 * k_types - (e->type != k_context));
    shd_assert_ok(e->call(&f, right));
    assert_true(shd_scene_render(&f.scene) == want);
    close_fixture(&f);
}

#endif /* SHD_TESTS_SUPPORT_HANDLES_H */
