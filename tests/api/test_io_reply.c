/* SPDX-License-Identifier: MIT */
/* Workers that misbehave: replies with wrong fields, too few or too many bytes or none, and workers that do not start.
 * Each load ends with its error before its time limit and a second more, and the next load with the real worker
 * succeeds. */
#define _GNU_SOURCE
#include "support/io_files.h"
#include "support/io_samples.h"
#include "support/io_worker.h"
#include "support/loads.h"
#include "support/volume_files.h"

#include <sys/wait.h>

static shd_context *g_context;
static const double k_limit = 0.4;

struct reply_case {
    const char *mode; /* name of a fault in tests/support/fake_worker.cpp */
    shd_result expected;
    const char *message;
};

static const struct reply_case k_cases[] = {
    {"good", SHD_OK, ""},
    {"long", SHD_ERROR_CORRUPT, "the decoder sent too many pixels"},
    {"huge_piece", SHD_ERROR_CORRUPT, "the decoder sent too many pixels"},
    {"few", SHD_ERROR_CORRUPT, "the decoder sent a wrong size"},
    {"no_final", SHD_ERROR_CORRUPT, "the decoder died on the file (signal 9)"},
    {"final_magic", SHD_ERROR_CORRUPT, "the decoder sent a wrong reply"},
    {"final_refuses", SHD_ERROR_CORRUPT, "row 3 is damaged"},
    {"final_turned", SHD_ERROR_CORRUPT, "the decoder sent a wrong size"},
    {"final_format", SHD_ERROR_CORRUPT, "the decoder sent a wrong size"},
    {"final_grows", SHD_ERROR_CORRUPT, "the decoder sent a wrong size"},
    {"final_info", SHD_ERROR_CORRUPT, "the decoder sent wrong properties"},
    {"final_channels", SHD_ERROR_CORRUPT, "the decoder sent other channels"},
    {"color_space", SHD_OK, ""},
    {"rgb", SHD_OK, ""}, /* three channels a pixel, which the host expands */
    {"grey", SHD_OK, ""},
    {"no_channels", SHD_ERROR_CORRUPT, "the decoder sent 0 channels"},
    {"channels", SHD_ERROR_CORRUPT, "the decoder sent 5 channels"},
    {"map_above", SHD_ERROR_CORRUPT, "the decoder sent channel 4 of 4"},
    {"map_below", SHD_ERROR_CORRUPT, "the decoder sent channel -2 of 4"},
    {"rgb_map", SHD_ERROR_CORRUPT, "the decoder sent channel 3 of 3"},
    {"rgb_final_map", SHD_ERROR_CORRUPT, "the decoder sent other channels"},
    {"rgb_long", SHD_ERROR_CORRUPT, "the decoder sent too many pixels"},
    {"rgb_wide", SHD_ERROR_CORRUPT, "the decoder sent too many pixels"},
    {"rgb_few", SHD_ERROR_CORRUPT, "the decoder sent a wrong size"},
    {"rgb_split", SHD_ERROR_CORRUPT, "the decoder sent a part of a pixel"},
    {"rgb_short", SHD_ERROR_CORRUPT, "the decoder died on the file (signal 9)"},
    {"grey_long", SHD_ERROR_CORRUPT, "the decoder sent too many pixels"},
    {"grey_few", SHD_ERROR_CORRUPT, "the decoder sent a wrong size"},
    {"reply_magic", SHD_ERROR_CORRUPT, "the decoder sent a wrong reply"},
    {"code", SHD_ERROR_CORRUPT, "the decoder sent a wrong reply"},
    {"text", SHD_ERROR_CORRUPT, "????????"},
    {"format", SHD_ERROR_CORRUPT, "the decoder sent format 77"},
    {"zero", SHD_ERROR_CORRUPT, "image of 0 x 4 pixels"},
    {"wide", SHD_ERROR_LIMIT, "image of 70000 x 4 pixels"},
    {"pixels", SHD_ERROR_LIMIT, "above load.max_pixels"},
    {"no_level", SHD_ERROR_CORRUPT, "the decoder sent 0 mip levels"},
    {"levels", SHD_ERROR_CORRUPT, "the decoder sent 2 mip levels"}, /* the load did not ask for levels */
    {"no_slice", SHD_ERROR_CORRUPT, "the decoder sent 0 slices"},
    {"slices", SHD_ERROR_CORRUPT, "the decoder sent 2 slices"}, /* the load did not ask for slices */
    {"one_channel", SHD_ERROR_CORRUPT, "the decoder sent format 1"},
    {"grid", SHD_OK, ""},
    {"grid_matrix", SHD_ERROR_CORRUPT, "the decoder sent a wrong grid"},
    {"grid_class", SHD_ERROR_CORRUPT, "the decoder sent a wrong grid"},
    {"grid_format", SHD_ERROR_CORRUPT, "the decoder sent a wrong grid"},
    {"size", SHD_ERROR_CORRUPT, "the decoder sent a wrong size"},
    {"overflow", SHD_ERROR_CORRUPT, "the decoder sent a wrong size"},
    {"info_format", SHD_ERROR_CORRUPT, "the decoder sent wrong properties"},
    {"info_flags", SHD_ERROR_CORRUPT, "the decoder sent wrong properties"},
    {"short", SHD_ERROR_CORRUPT, "the decoder died on the file (signal 9)"},
    {"cut", SHD_ERROR_CORRUPT, "the decoder died on the file (signal 9)"},
    {"closes", SHD_ERROR_CORRUPT, "the decoder died on the file (no reply)"},
    {"hangs", SHD_ERROR_LIMIT, "load.time_limit 0.4 s"},
    {"drips", SHD_ERROR_LIMIT, "load.time_limit 0.4 s"},
    {"refuses", SHD_ERROR_OUT_OF_MEMORY, "cannot start \"a child of the worker\""},
    {"ends", SHD_ERROR_INTERNAL, "ends when it gets a file"},
    {"silent", SHD_ERROR_INTERNAL, "ends when it gets a file"}, /* closes the connection of the load */
    {"started_short", SHD_ERROR_INTERNAL, "ends when it gets a file"},
    {"hello_magic", SHD_ERROR_INTERNAL, "belongs to another version of shd"},
    {"hello_error", SHD_ERROR_IO, "Resource temporarily unavailable"},
    {"hello_short", SHD_ERROR_INTERNAL, "did not start"},
    {"hello_never", SHD_ERROR_INTERNAL, "did not start (exit status 7)"},
    {"hello_late", SHD_ERROR_LIMIT, "load.time_limit 0.4 s"},
};

/* The channels of pixel i of a good reply: bytes of the wire, which counts from 1, and 255 for an absent alpha. */
static void assert_pixels(const shd_bitmap *bitmap, int channels)
{
    shd_image image = shd_image_default();
    int i, c;
    shd_assert_ok(shd_bitmap_get_image(bitmap, &image));
    assert_int_equal(image.width * image.height, 20);
    for (i = 0; i < 20; ++i) {
        for (c = 0; c < 4; ++c) {
            const int from = channels == 2 ? c / 3 : c;
            const int expected = from < channels ? i * channels + from + 1 : 255;
            assert_int_equal(((const unsigned char *)image.pixels)[4 * i + c], expected);
        }
    }
}

/* A load of a grid, of which a good reply has 5 x 4 x 1 voxels. */
static shd_result load_grid(const shd_load_desc *desc)
{
    const char *path = io_path("any.vdb");
    shd_vdb_info info = shd_vdb_info_default();
    shd_texture_info size = shd_texture_info_default();
    shd_texture *texture = NULL;
    shd_result result;
    io_write(path, " BDV\0\0\0\0", 8); /* the first bytes of OpenVDB */
    result = load_vdb(g_context, path, NULL, desc, &info, &texture);
    assert_true((texture != NULL) == (result == SHD_OK));
    if (result != SHD_OK) return result;
    shd_assert_ok(shd_texture_get_info(texture, &size));
    assert_true(size.width == 5 && size.height == 4 && size.depth == 1 && size.format == SHD_FORMAT_R32F);
    assert_true(info.object_to_world[0] == 5.0f && info.object_to_world[12] == -0.5f);
    assert_int_equal(info.grid_class, SHD_VDB_CLASS_LEVEL_SET);
    assert_int_equal(strlen(info.grid), 63);
    assert_int_equal(strspn(info.grid, "?"), 63);
    shd_texture_release(texture);
    return result;
}

static void test_case(void **state)
{
    const struct reply_case *c = (const struct reply_case *)*state;
    const int grid = strncmp(c->mode, "grid", 4) == 0;
    shd_load_desc desc = shd_load_desc_default();
    shd_bitmap *bitmap = NULL;
    char name[64];
    const char *path;
    shd_result result;
    snprintf(name, sizeof name, "fake-%s", c->mode);
    path = io_path(name);
    assert_int_equal(symlink(SHD_FAKE_WORKER, path), 0);
    desc.worker_path = path;
    desc.time_limit = c->expected == SHD_ERROR_LIMIT ? k_limit : 60;
    result = grid ? load_grid(&desc)
                  : shd_bitmap_load_memory(g_context, k_sample_jpeg, sizeof k_sample_jpeg, &desc, &bitmap);
    shd_assert_result(c->mode, result, c->expected, c->message);
    assert_true((bitmap != NULL) == (result == SHD_OK && !grid));
    if (strcmp(c->mode, "color_space") == 0) {
        const char *text = shd_bitmap_get_color_space(bitmap);
        assert_int_equal(strlen(text), 63);
        assert_int_equal(strspn(text, "?"), 63);
    }
    if (bitmap) assert_pixels(bitmap, strcmp(c->mode, "rgb") == 0 ? 3 : strcmp(c->mode, "grey") == 0 ? 2 : 4);
    shd_bitmap_release(bitmap);
    bitmap = NULL;
    desc.worker_path = SHD_IO_WORKER;
    desc.time_limit = 60;
    shd_assert_ok(shd_bitmap_load_memory(g_context, k_sample_jpeg, sizeof k_sample_jpeg, &desc, &bitmap));
    shd_bitmap_release(bitmap);
    assert_int_equal(waitpid(-1, NULL, WNOHANG), -1); /* no child is left, running or zombie */
}

int main(void)
{
    enum { CASES = sizeof k_cases / sizeof k_cases[0] };
    struct CMUnitTest tests[CASES];
    void *state = NULL;
    size_t i;
    int failed;
    if (io_make_folder(&state) != 0 || shd_context_create(NULL, &g_context) != SHD_OK) return 1;
    for (i = 0; i < CASES; ++i)
        tests[i] = (struct CMUnitTest){k_cases[i].mode, test_case, NULL, NULL, (void *)&k_cases[i]};
    failed = _cmocka_run_group_tests("api.io_reply", tests, CASES, NULL, NULL);
    io_remove_folder(&state);
    shd_context_release(g_context);
    return failed;
}
