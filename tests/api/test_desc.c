/* SPDX-License-Identifier: MIT */
/* shd_desc_init writes the values that the inline defaults return, into structs of any size that contains the
 * required fields. */
#include "support/check.h"

#include <shd/color.h>
#include <shd/scene.h>
#include <shd/shd.h>
#include <shd/texture_file.h>
#include <shd/tile_file.h>
#include <shd/volume_file.h>

#include "../../src/core/sized_structs.h"

enum { LARGEST = 4096 };

struct kind_case {
    const char *name;
    shd_desc_kind kind;
    size_t size, alignment;
    size_t required; /* size up to the end of the last required field */
    void (*defaults)(void *out);
};

/* A function for each struct, and a row. */
#define DEFAULTS(kind, type, required, last, size) \
    static void defaults_##type(void *p)           \
    {                                              \
        const type value = type##_default();       \
        memcpy(p, &value, sizeof value);           \
    }
SHD_SIZED_STRUCTS(DEFAULTS)

#define ALIGNMENT(type)  \
    offsetof(            \
        struct {         \
            char first;  \
            type second; \
        },               \
        second)
#define REQUIRED(type, field) (offsetof(type, field) + sizeof(((type *)0)->field))
#define KIND(kind, type, required, last, size) \
    {#type, SHD_DESC_KIND_##kind, sizeof(type), ALIGNMENT(type), REQUIRED(type, required), defaults_##type},
static const struct kind_case k_kinds[] = {SHD_SIZED_STRUCTS(KIND)};

/* Padding bytes are unspecified, so both structs get the same bytes there. */
static void level_padding(const char *name, size_t end, unsigned char *a, unsigned char *b)
{
    static const struct {
        const char *type;
        size_t offset, size;
    } k_padding[] = {
#define SHD_PADDING(type, offset, size) {#type, offset, size},
#include "paddings.inc" /* written by tests/abi/layout.py */
        {"shd_context_desc", offsetof(shd_context_desc, executor) + offsetof(shd_executor, worker_count) + 4, 4},
    };
    size_t i;
    for (i = 0; i < sizeof k_padding / sizeof k_padding[0]; ++i) {
        if (strcmp(k_padding[i].type, name) || k_padding[i].offset + k_padding[i].size > end) continue;
        memset(a + k_padding[i].offset, 0, k_padding[i].size);
        memset(b + k_padding[i].offset, 0, k_padding[i].size);
    }
}

static void test_kind(void **state)
{
    const struct kind_case *c = (const struct kind_case *)*state;
    union {
        unsigned char bytes[LARGEST];
        double aligned;
    } got, want, untouched;
    uint32_t size;
    assert_true(c->size + 24 <= LARGEST);

    memset(got.bytes, 0xa5, LARGEST);
    memset(want.bytes, 0xa5, LARGEST);
    memset(untouched.bytes, 0xa5, LARGEST);
    c->defaults(want.bytes);
    shd_assert_ok(shd_desc_init(c->kind, got.bytes, c->size));
    level_padding(c->name, c->size, got.bytes, want.bytes);
    assert_memory_equal(got.bytes, want.bytes, LARGEST);

    /* A later header's struct: the known part, then zero. */
    size = (uint32_t)(c->size + 16);
    memset(want.bytes + c->size, 0, 16);
    memcpy(want.bytes, &size, sizeof size);
    shd_assert_ok(shd_desc_init(c->kind, got.bytes, size));
    level_padding(c->name, c->size, got.bytes, want.bytes);
    assert_memory_equal(got.bytes, want.bytes, LARGEST);

    /* An older header's struct: the first fields, and nothing behind them. Other sizes are those of no header. */
    for (size = (uint32_t)c->required; size < c->size; ++size) {
        memset(got.bytes, 0xa5, LARGEST);
        if (size % c->alignment != 0) {
            const size_t smallest = (c->required + c->alignment - 1) / c->alignment * c->alignment;
            shd_assert_result(c->name, shd_desc_init(c->kind, got.bytes, size), SHD_ERROR_INVALID_ARGUMENT,
                              size < smallest ? "is below" : "is not a multiple of");
            assert_memory_equal(got.bytes, untouched.bytes, LARGEST);
            continue;
        }
        memset(want.bytes, 0xa5, LARGEST);
        c->defaults(want.bytes);
        memset(want.bytes + size, 0xa5, c->size - size);
        memcpy(want.bytes, &size, sizeof size);
        shd_assert_ok(shd_desc_init(c->kind, got.bytes, size));
        level_padding(c->name, size, got.bytes, want.bytes);
        assert_memory_equal(got.bytes, want.bytes, LARGEST);
    }

    memset(got.bytes, 0xa5, LARGEST);
    shd_assert_result("small", shd_desc_init(c->kind, got.bytes, c->required - 1), SHD_ERROR_INVALID_ARGUMENT,
                      "desc_init.size");
    shd_assert_result("huge", shd_desc_init(c->kind, got.bytes, 65537), SHD_ERROR_INVALID_ARGUMENT,
                      "desc_init.size: 65537 is above 65536");
    shd_assert_result("null", shd_desc_init(c->kind, NULL, c->size), SHD_ERROR_INVALID_ARGUMENT, "desc_init.ptr: NULL");
    assert_memory_equal(got.bytes, untouched.bytes, LARGEST);
}

static void test_unknown_kinds(void **state)
{
    const int32_t kinds[] = {0, sizeof k_kinds / sizeof k_kinds[0] + 1, 999, 1000, 0x7fffffff, -1};
    unsigned char bytes[LARGEST];
    size_t i;
    (void)state;
    for (i = 0; i < sizeof kinds / sizeof kinds[0]; ++i) {
        shd_desc_kind kind;
        memcpy(&kind, &kinds[i], sizeof kind);
        shd_assert_result("unknown", shd_desc_init(kind, bytes, sizeof bytes), SHD_ERROR_INVALID_ARGUMENT,
                          "is not a desc");
    }
}

int main(void)
{
    struct CMUnitTest tests[sizeof k_kinds / sizeof k_kinds[0] + 8];
    size_t n = 0, i;
    for (i = 0; i < sizeof k_kinds / sizeof k_kinds[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_kinds[i].name, test_kind, NULL, NULL, (void *)&k_kinds[i]};
    }
    tests[n++] = (struct CMUnitTest){"unknown_kinds", test_unknown_kinds, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.desc", tests, n, NULL, NULL);
}
