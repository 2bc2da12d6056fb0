/* SPDX-License-Identifier: MIT */
/* Illegal lookup tables of a colour config, in the formats of CLF (Academy S-2014-006), Iridas, Sony Imageworks and
 * others: a conversion that needs one is refused with a message and writes nothing; other conversions work. OpenColorIO
 * accepts a few of them; those give finite pixels. */
#define _POSIX_C_SOURCE 200809L
#include "support/color.h"
#include "support/io_files.h"
#include "support/rows.h"

#include <shd/shd.h>

static shd_context *g_context;

enum outcome { REFUSED, LEGAL, ACCEPTED };
struct table_case {
    const char *file;
    const char *text;
    enum outcome outcome;
};

#define CLF(body)                                                                                    \
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<ProcessList id=\"a\" compCLFversion=\"3\">\n" body \
    "\n</ProcessList>\n"
#define ARRAY(dim, values) "<Array dim=\"" dim "\">\n" values "\n</Array>"
#define LUT1(head, array) CLF("<LUT1D inBitDepth=\"32f\" outBitDepth=\"32f\"" head ">" array "</LUT1D>")
#define LUT3(head, array) CLF("<LUT3D inBitDepth=\"32f\" outBitDepth=\"32f\"" head ">" array "</LUT3D>")
#define MATRIX(array) CLF("<Matrix inBitDepth=\"32f\" outBitDepth=\"32f\">" array "</Matrix>")
#define CORNERS "0 0 0\n0 0 1\n0 1 0\n0 1 1\n1 0 0\n1 0 1\n1 1 0\n1 1 1"

static const struct table_case k_tables[] = {
    {"legal_lut1d.clf", LUT1("", ARRAY("2 1", "0\n1")), LEGAL},
    {"legal_lut3d.clf", LUT3("", ARRAY("2 2 2 3", CORNERS)), LEGAL},
    {"legal_matrix.clf", MATRIX(ARRAY("3 3", "1 0 0\n0 1 0\n0 0 1")), LEGAL},
    {"legal.cube", "LUT_3D_SIZE 2\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n", LEGAL},
    {"legal.spi1d", "Version 1\nFrom 0.0 1.0\nLength 2\nComponents 1\n{\n0.0\n1.0\n}\n", LEGAL},
    {"empty.clf", "", REFUSED},
    {"binary.clf", "\x01\x02\xff\xfe\x7f", REFUSED},
    {"no_xml.clf", "1 2 3\n", REFUSED},
    {"unfinished.clf", "<?xml version=\"1.0\"?><ProcessList id=\"a\" compCLFversion=\"3\"><LUT1D", REFUSED},
    {"no_process_list.clf", "<?xml version=\"1.0\"?><Nothing></Nothing>", REFUSED},
    {"no_operators.clf", CLF(""), REFUSED},
    {"no_id.clf", "<?xml version=\"1.0\"?><ProcessList compCLFversion=\"3\"><Matrix/></ProcessList>", REFUSED},
    {"version_99.clf", "<?xml version=\"1.0\"?><ProcessList id=\"a\" compCLFversion=\"99\"></ProcessList>", REFUSED},
    {"lut1d_no_array.clf", LUT1("", ""), ACCEPTED},
    {"lut1d_dim_0.clf", LUT1("", ARRAY("0 1", "")), REFUSED},
    {"lut1d_dim_negative.clf", LUT1("", ARRAY("-2 1", "0\n1")), REFUSED},
    {"lut1d_dim_2^31.clf", LUT1("", ARRAY("2147483648 3", "0 0 0")), REFUSED},
    {"lut1d_dim_text.clf", LUT1("", ARRAY("two 1", "0\n1")), REFUSED},
    {"lut1d_dim_missing.clf", LUT1("", "<Array>0\n1</Array>"), REFUSED},
    {"lut1d_5_channels.clf", LUT1("", ARRAY("2 5", "0 0 0 0 0\n1 1 1 1 1")), REFUSED},
    {"lut1d_few_values.clf", LUT1("", ARRAY("4 1", "0\n1")), REFUSED},
    {"lut1d_many_values.clf", LUT1("", ARRAY("2 1", "0\n1\n2\n3")), REFUSED},
    {"lut1d_text_value.clf", LUT1("", ARRAY("2 1", "0\nlight")), REFUSED},
    {"lut1d_bad_depth.clf", CLF("<LUT1D inBitDepth=\"7i\" outBitDepth=\"32f\">" ARRAY("2 1", "0\n1") "</LUT1D>"),
     REFUSED},
    {"lut1d_bad_interpolation.clf", LUT1(" interpolation=\"magic\"", ARRAY("2 1", "0\n1")), REFUSED},
    {"lut1d_two_arrays.clf", LUT1("", ARRAY("2 1", "0\n1") ARRAY("2 1", "0\n1")), ACCEPTED},
    {"lut3d_uneven.clf", LUT3("", ARRAY("2 3 2 3", CORNERS)), REFUSED},
    {"lut3d_few_values.clf", LUT3("", ARRAY("2 2 2 3", "0 0 0\n1 1 1")), REFUSED},
    {"lut3d_1_channel.clf", LUT3("", ARRAY("2 2 2 1", "0 0 0 0 1 1 1 1")), REFUSED},
    {"lut3d_dim_65536.clf", LUT3("", ARRAY("65536 65536 65536 3", "0 0 0")), REFUSED},
    {"matrix_2x2.clf", MATRIX(ARRAY("2 2", "1 0\n0 1")), REFUSED},
    {"matrix_few_values.clf", MATRIX(ARRAY("3 3", "1 0 0\n0 1")), REFUSED},
    {"matrix_text.clf", MATRIX(ARRAY("3 3", "1 0 0\n0 one 0\n0 0 1")), REFUSED},
    {"range_reversed.clf",
     CLF("<Range inBitDepth=\"32f\" outBitDepth=\"32f\"><minInValue>1</minInValue><maxInValue>0</maxInValue>"
         "<minOutValue>0</minOutValue><maxOutValue>1</maxOutValue></Range>"),
     REFUSED},
    {"range_half.clf", CLF("<Range inBitDepth=\"32f\" outBitDepth=\"32f\"><minInValue>0</minInValue></Range>"),
     REFUSED},
    {"log_bad_style.clf", CLF("<Log inBitDepth=\"32f\" outBitDepth=\"32f\" style=\"log7\"></Log>"), REFUSED},
    {"exponent_bad_style.clf",
     CLF("<Exponent inBitDepth=\"32f\" outBitDepth=\"32f\" style=\"x\"><ExponentParams exponent=\"2\"/></Exponent>"),
     REFUSED},
    {"cdl_bad_style.clf", CLF("<ASC_CDL inBitDepth=\"32f\" outBitDepth=\"32f\" style=\"x\"></ASC_CDL>"), REFUSED},
    {"no_size.cube", "0 0 0\n1 1 1\n", REFUSED},
    {"size_0.cube", "LUT_3D_SIZE 0\n", REFUSED},
    {"size_negative.cube", "LUT_3D_SIZE -2\n0 0 0\n", REFUSED},
    {"size_2^31.cube", "LUT_3D_SIZE 2147483647\n0 0 0\n", REFUSED},
    {"size_1024.cube", "LUT_3D_SIZE 1024\n0 0 0\n", REFUSED},
    {"size_text.cube", "LUT_3D_SIZE many\n0 0 0\n", REFUSED},
    {"few_values.cube", "LUT_3D_SIZE 2\n0 0 0\n1 0 0\n", REFUSED},
    {"text_value.cube", "LUT_1D_SIZE 2\n0 0 0\n1 x 1\n", REFUSED},
    {"two_columns.cube", "LUT_1D_SIZE 2\n0 0\n1 1\n", REFUSED},
    {"decimal_comma.cube", "LUT_1D_SIZE 2\n0,5 0,5 0,5\n1,0 1,0 1,0\n", ACCEPTED},
    {"no_length.spi1d", "Version 1\nFrom 0.0 1.0\nComponents 1\n{\n0.0\n1.0\n}\n", REFUSED},
    {"length_-1.spi1d", "Version 1\nFrom 0.0 1.0\nLength -1\nComponents 1\n{\n0.0\n}\n", REFUSED},
    {"few_values.spi1d", "Version 1\nFrom 0.0 1.0\nLength 4\nComponents 1\n{\n0.0\n1.0\n}\n", REFUSED},
    {"components_9.spi1d", "Version 1\nFrom 0.0 1.0\nLength 2\nComponents 9\n{\n0.0\n1.0\n}\n", REFUSED},
    {"empty.spi3d", "", REFUSED},
    {"few_values.spi3d", "SPILUT 1.0\n3 3\n2 2 2\n0 0 0 0 0 0\n", REFUSED},
    {"index_outside.spi3d", "SPILUT 1.0\n3 3\n2 2 2\n9 9 9 0 0 0\n", REFUSED},
    {"size_negative.spi3d", "SPILUT 1.0\n3 3\n-2 -2 -2\n0 0 0 0 0 0\n", REFUSED},
    {"text.csp", "CSPLUTV100\nWHAT\n", REFUSED},
    {"cut_off.csp", "CSPLUTV100\n3D\n\n2\n0 1\n0 1\n2\n0 1\n", REFUSED},
    {"empty.3dl", "", REFUSED},
    {"not_a_cube.3dl", "0 64 128\n0 0 0\n1 1 1\n", REFUSED},
    {"unfinished.cc", "<ColorCorrection id=\"a\"><SOPNode><Slope>1", REFUSED},
    {"text_slope.cc", "<ColorCorrection id=\"a\"><SOPNode><Slope>a b c</Slope></SOPNode></ColorCorrection>", REFUSED},
    {"no_profile.icc", "acsp", REFUSED},
    {"unknown_extension.what", "LUT\n", REFUSED},
};

/* Converts a pixel of the working space to the space of the table. */
static shd_result convert(const struct table_case *c, float pixel[4], shd_color **out_color)
{
    char text[2048];
    shd_image image = shd_test_image(SHD_FORMAT_RGBA32F, 1, 1, pixel);
    shd_color_desc desc = shd_color_desc_default();
    snprintf(text, sizeof text,
             "ocio_profile_version: 2\nsearch_path: %s\nroles: {default: lin, scene_linear: lin}\n"
             "file_rules:\n  - !<Rule> {name: Default, colorspace: default}\n"
             "displays:\n  screen:\n    - !<View> {name: v, colorspace: lin}\n"
             "colorspaces:\n  - !<ColorSpace>\n    name: lin\n  - !<ColorSpace>\n    name: table\n"
             "    from_scene_reference: !<FileTransform> {src: \"%s\"}\n",
             g_folder, c->file);
    desc.config_text = text;
    shd_assert_ok(shd_color_create(g_context, &desc, out_color));
    return shd_color_convert(*out_color, &image, "lin", "table");
}

static void test_table(void **state)
{
    static const float k_pixel[4] = {0.25f, 0.5f, 0.75f, 1.0f};
    const struct table_case *c = (const struct table_case *)*state;
    shd_color *color = NULL;
    float pixel[4];
    shd_image image = shd_test_image(SHD_FORMAT_RGBA32F, 1, 1, pixel);
    shd_result result;
    int round, k;
    io_write(io_path(c->file), c->text, strlen(c->text));
    for (round = 0; round < 2; ++round) {
        memcpy(pixel, k_pixel, sizeof pixel);
        result = convert(c, pixel, &color);
        if (c->outcome == REFUSED) {
            if (result == SHD_OK || result == SHD_ERROR_INTERNAL) fail_msg("%s: %s", c->file, shd_result_name(result));
            assert_string_not_equal(shd_last_error(), "");
            assert_memory_equal(pixel, k_pixel, sizeof pixel);
        } else {
            shd_assert_result(c->file, result, SHD_OK, "");
        }
        for (k = 0; k < 4; ++k) {
            assert_true(isfinite(pixel[k]));
            if (c->outcome == LEGAL) shd_assert_close(c->file, (size_t)k, pixel[k], (double)k_pixel[k], 1e-6, 0);
        }
        shd_assert_ok(shd_color_convert(color, &image, "lin", "lin"));
        shd_color_release(color);
    }
}

int main(void)
{
    void *state = NULL;
    int failed;
    unsetenv("OCIO");
    if (io_make_folder(&state) != 0 || shd_context_create(NULL, &g_context) != SHD_OK) return 1;
    ADD_ROWS(k_tables, test_table);
    failed = _cmocka_run_group_tests("api.color_tables", g_tests, g_count, NULL, NULL);
    shd_context_release(g_context);
    return io_remove_folder(&state) == 0 ? failed : 1;
}
