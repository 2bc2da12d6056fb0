/* SPDX-License-Identifier: MIT */
/* Names of enums: each constant has one, other numbers have none, and a loop from 0 on finds them all. */
#include "support/check.h"

#include <shd/names.h>

struct enum_case {
    const char *name;
    const char *(*name_of)(uint32_t value);
    uint32_t count;
    const char *first, *last;
};

#define ENUM(noun)                                    \
    static const char *name_of_##noun(uint32_t value) \
    {                                                 \
        shd_##noun constant;                          \
        memcpy(&constant, &value, sizeof constant);   \
        return shd_##noun##_name(constant);           \
    }
ENUM(simd)
ENUM(format)
ENUM(wrap)
ENUM(filter)
ENUM(magnification)
ENUM(cubic)
ENUM(profile)
ENUM(precision)
ENUM(stochastic)
ENUM(compare)
ENUM(texture_kind)
ENUM(projection)
ENUM(mip_kernel)
ENUM(texel_content)
ENUM(shape)
ENUM(solid)
ENUM(model)
ENUM(blend)
ENUM(normal_encoding)
ENUM(slot_target)
ENUM(light_kind)
ENUM(shadow_filter)
ENUM(frequency)
ENUM(cull)
ENUM(fill)
ENUM(visibility)

static const struct enum_case k_enums[] = {
    {"simd", name_of_simd, 10, "best", "wasm"},
    {"format", name_of_format, 38, "none", "rgb9e5"},
    {"wrap", name_of_wrap, 5, "repeat", "mirror_once"},
    {"filter", name_of_filter, 14, "trilinear", "hermite"},
    {"magnification", name_of_magnification, 5, "default", "hermite"},
    {"cubic", name_of_cubic, 3, "catmull_rom", "mitchell"},
    {"profile", name_of_profile, 5, "least_error", "exact"},
    {"precision", name_of_precision, 2, "full", "fast"},
    {"stochastic", name_of_stochastic, 2, "texel", "quad"},
    {"compare", name_of_compare, 8, "less", "never"},
    {"texture_kind", name_of_texture_kind, 3, "2d", "directions"},
    {"projection", name_of_projection, 6, "none", "octahedral"},
    {"mip_kernel", name_of_mip_kernel, 4, "box", "lanczos"},
    {"texel_content", name_of_texel_content, 6, "color", "alpha_weighted"},
    {"shape", name_of_shape, 5, "sphere", "teapot"},
    {"solid", name_of_solid, 8, "stripes", "wood"},
    {"model", name_of_model, 12, "lambert", "glass"},
    {"blend", name_of_blend, 7, "opaque", "sorted"},
    {"normal_encoding", name_of_normal_encoding, 4, "xyz", "moments"},
    {"slot_target", name_of_slot_target, 17, "diffuse", "tint"},
    {"light_kind", name_of_light_kind, 4, "point", "spot"},
    {"shadow_filter", name_of_shadow_filter, 5, "hard", "pcss"},
    {"frequency", name_of_frequency, 3, "phong", "flat"},
    {"cull", name_of_cull, 3, "none", "front"},
    {"fill", name_of_fill, 4, "solid", "lines"},
    {"visibility", name_of_visibility, 3, "depth", "newell"},
};

static void test_names(void **state)
{
    const struct enum_case *c = (const struct enum_case *)*state;
    const uint32_t others[] = {c->count, 255, 0x7fffffff, 0xffffffff};
    uint32_t i, k;
    for (i = 0; i < c->count; ++i) {
        assert_non_null(c->name_of(i));
        for (k = 0; k < i; ++k) assert_string_not_equal(c->name_of(i), c->name_of(k));
    }
    assert_string_equal(c->name_of(0), c->first);
    assert_string_equal(c->name_of(c->count - 1), c->last);
    for (i = 0; i < sizeof others / sizeof others[0]; ++i) assert_null(c->name_of(others[i]));
}

int main(void)
{
    struct CMUnitTest tests[sizeof k_enums / sizeof k_enums[0]];
    size_t i;
    for (i = 0; i < sizeof k_enums / sizeof k_enums[0]; ++i) {
        tests[i] = (struct CMUnitTest){k_enums[i].name, test_names, NULL, NULL, (void *)&k_enums[i]};
    }
    return _cmocka_run_group_tests("api.names", tests, i, NULL, NULL);
}
