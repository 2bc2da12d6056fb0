/* SPDX-License-Identifier: MIT */
/* KTX2 files that are written: every format and kind of texture is the same after it is read again. */
#define _GNU_SOURCE
#include "support/loads.h"
#include "support/rows.h"
#include "support/texture_formats.h"

#include <shd/shd.h>

/** A texture of every format and kind, written and read again. */
static void test_save(void **state)
{
    static const uint32_t k_schemes[3] = {0, 2, 3};
    size_t row, kind;
    (void)state;
    for (row = 0; row < sizeof k_formats / sizeof k_formats[0]; ++row) {
        for (kind = 0; kind < sizeof k_kinds / sizeof k_kinds[0]; ++kind) {
            const struct format_case *f = &k_formats[row];
            const struct kind_case *c = &k_kinds[kind];
            file_texture t = texture_of(f, c->width, c->height ? c->height : 1, c->levels);
            file_ktx2 k = ktx2_of(f);
            shd_ktx2_desc save = shd_ktx2_desc_default();
            shd_load_desc desc = shd_load_desc_default();
            shd_texture_file_info info;
            shd_texture *first, *second = NULL;
            shd_result result;
            if (f->order != SAME || !f->vulkan || (c->layers > 1 && c->faces == 6)) continue;
            t.depth = c->depth, t.layers = c->layers, t.faces = c->faces;
            desc.tables = c->levels == 1 ? 0 : SHD_TABLE_MIPMAP;
            save.supercompression = (shd_supercompression)k_schemes[(row + kind) % 3];
            save.effort = (int32_t)(kind % 2) * 9;
            if (save.supercompression == 0) save.effort = 0;
            if (f->format != stored_format(f->format)) save.channel_count = 3;
            first = load(file_make_ktx2(&t, &k, NULL), &desc, 0, &info);
            result = shd_texture_save_ktx2(first, io_path("saved.ktx2"), &save);
            if (file_is_absent(result)) {
                shd_texture_release(first);
                skip();
            }
            shd_assert_ok(result);
            shd_assert_ok(load_file(g_context, io_path("saved.ktx2"), &desc, &info, &second));
            if (t.layers == 1) t.layers = 0;
            check_info(&info, SHD_TEXTURE_FILE_KIND_KTX2, &t, f->format);
            assert_int_equal(info.supercompression, save.supercompression);
            assert_int_equal(info.file_code, f->vulkan);
            check_images(f->name, second, &t, 0, f->format, SAME);
            shd_texture_release(first);
            shd_texture_release(second);
        }
    }
}

static void test_save_bad(void **state)
{
    const file_texture t = texture_of(&k_formats[41], 8, 8, 1);
    const file_ktx2 k = ktx2_of(&k_formats[41]);
    shd_texture_file_info info;
    shd_texture *texture = load(file_make_ktx2(&t, &k, NULL), NULL, 0, &info);
    shd_ktx2_desc desc = shd_ktx2_desc_default();
    const char *path = io_path("bad.ktx2");
    shd_result result;
    (void)state;
    shd_assert_result("texture", shd_texture_save_ktx2(NULL, path, NULL), SHD_ERROR_INVALID_ARGUMENT, "texture: NULL");
    shd_assert_result("path", shd_texture_save_ktx2(texture, NULL, NULL), SHD_ERROR_INVALID_ARGUMENT, "path: NULL");
    shd_assert_result("folder", shd_texture_save_ktx2(texture, io_path("no/such"), NULL), SHD_ERROR_NOT_FOUND,
                      "no/such");
    desc.channel_count = 3;
    shd_assert_result("blocks", shd_texture_save_ktx2(texture, path, &desc), SHD_ERROR_INVALID_ARGUMENT,
                      "ktx2.channel_count: 3, but format 35");
    desc.channel_count = 2;
    shd_assert_result("channels", shd_texture_save_ktx2(texture, path, &desc), SHD_ERROR_INVALID_ARGUMENT,
                      "ktx2.channel_count: 2 is not 0 or 3");
    desc.channel_count = 0;
    desc.supercompression = (shd_supercompression)4;
    shd_assert_result("scheme", shd_texture_save_ktx2(texture, path, &desc), SHD_ERROR_INVALID_ARGUMENT,
                      "ktx2.supercompression: 4");
    desc.supercompression = SHD_SUPERCOMPRESSION_BASIS_LZ;
    shd_assert_result("basis", shd_texture_save_ktx2(texture, path, &desc), SHD_ERROR_UNSUPPORTED,
                      "ktx2.supercompression: 1");
    desc.supercompression = SHD_SUPERCOMPRESSION_ZLIB;
    desc.effort = 10;
    result = shd_texture_save_ktx2(texture, path, &desc);
    if (!file_is_absent(result)) {
        shd_assert_result("effort", result, SHD_ERROR_INVALID_ARGUMENT, "ktx2.effort: 10 is not in 0..9");
    }
    assert_int_equal(io_count_files("bad", 0), 0);
    shd_texture_release(texture);
}

int main(void)
{
    void *state = NULL;
    int failed;
    if (io_make_folder(&state) != 0 || shd_context_create(NULL, &g_context) != SHD_OK) return 1;
    add("save", test_save, NULL);
    add("save_bad", test_save_bad, NULL);
    failed = _cmocka_run_group_tests("api.io_texture_save", g_tests, g_count, NULL, NULL);
    shd_context_release(g_context);
    io_remove_folder(&state);
    return failed;
}
