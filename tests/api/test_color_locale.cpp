// SPDX-License-Identifier: MIT
// Colour under a global C++ locale that writes 1234.5 as 1.234,5. A C test cannot set such a locale.
#include <clocale>
#include <locale>
#include <sstream>
#include <string>

#include <shd/color.h>
#include <shd/shd.h>

#include "support/check.h"

namespace
{

struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

int set_comma(void **)
{
    std::locale::global(std::locale(std::locale::classic(), new Comma));
    return 0;
}

int set_classic(void **)
{
    std::locale::global(std::locale::classic());
    return 0;
}

void assert_comma()
{
    std::ostringstream text;
    text << 1234.5;
    const bool comma = text.str() == "1.234,5";
    assert_true(comma);
    assert_string_equal(std::setlocale(LC_ALL, nullptr), "C");
}

const char *const kConfig =
    "ocio_profile_version: 2\n"
    "roles: {default: lin, scene_linear: lin}\n"
    "file_rules:\n  - !<Rule> {name: Default, colorspace: default}\n"
    "displays:\n  screen:\n    - !<View> {name: v, colorspace: lin}\n"
    "colorspaces:\n  - !<ColorSpace>\n    name: lin\n  - !<ColorSpace>\n    name: a\n"
    "    to_scene_reference: !<MatrixTransform> {offset: [0.25, 1000.5, 1234567.75, 0]}\n";

void test_offsets(void **)
{
    shd_context *context = nullptr;
    shd_color *color = nullptr;
    float pixel[4] = {0, 0, 0, 1};
    shd_image image = shd_image_default();
    image.format = SHD_FORMAT_RGBA32F;
    image.width = image.height = 1;
    image.pixels = pixel;
    shd_color_desc desc = shd_color_desc_default();
    desc.config_text = kConfig;
    shd_assert_ok(shd_context_create(nullptr, &context));
    shd_assert_ok(shd_color_create(context, &desc, &color));
    assert_comma();
    shd_assert_ok(shd_color_convert(color, &image, "a", nullptr));
    assert_comma();
    assert_true(pixel[0] == 0.25f && pixel[1] == 1000.5f && pixel[2] == 1234567.75f);
    shd_color_release(color);
    shd_context_release(context);
}

void test_builtin(void **)
{
    shd_context *context = nullptr;
    shd_color *color = nullptr;
    float pixel[4] = {0.18f, 0.18f, 0.18f, 1};
    shd_image image = shd_image_default();
    image.format = SHD_FORMAT_RGBA32F;
    image.width = image.height = 1;
    image.pixels = pixel;
    shd_color_desc desc = shd_color_desc_default();
    desc.config_text = shd_color_default_config();
    shd_assert_ok(shd_context_create(nullptr, &context));
    shd_assert_ok(shd_color_create(context, &desc, &color));
    shd_assert_ok(shd_color_apply_display_image(color, &image, "ACEScg", nullptr, nullptr, &image));
    shd_assert_close("ACES", 0, static_cast<double>(pixel[0]), 0.356, 5e-4, 0.0);
    desc.config_text = "broken";
    shd_color *none = nullptr;
    shd_assert_result("broken", shd_color_create(context, &desc, &none), SHD_ERROR_CORRUPT, "color.config_text");
    assert_comma();
    shd_color_release(color);
    shd_context_release(context);
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        {"offsets", test_offsets, set_comma, set_classic, nullptr},
        {"builtin", test_builtin, set_comma, set_classic, nullptr},
    };
    return _cmocka_run_group_tests("api.color_locale", tests, sizeof tests / sizeof tests[0], nullptr, nullptr);
}
