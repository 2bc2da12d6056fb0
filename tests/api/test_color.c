/* SPDX-License-Identifier: MIT */
/* Colour configs: sources, refusals and names. */
#define _GNU_SOURCE
#include "support/color.h"
#include "support/odd_paths.h"

#include <fcntl.h>
#include <locale.h>
#include <sys/stat.h>
#include <unistd.h>

#include <shd/shd.h>

#define SPACE(name, body) "  - !<ColorSpace>\n    name: " name "\n    isdata: false\n" body
#define HEAD                                                          \
    "ocio_profile_version: 2\n"                                       \
    "roles: {default: lin, scene_linear: lin}\n"                      \
    "file_rules:\n  - !<Rule> {name: Default, colorspace: default}\n" \
    "displays:\n  screen:\n    - !<View> {name: look at it, colorspace: lin}\n"
#define SPACES "colorspaces:\n" SPACE("lin", "")
#define CST(src, dst) "!<ColorSpaceTransform> {src: " src ", dst: " dst "}\n"

struct config_case {
    const char *name;
    const char *text;
    shd_result expected;
    const char *message;
};

static const struct config_case k_config[] = {
    {"config/minimal", HEAD SPACES, SHD_OK, ""},
    {"config/unknown_key", HEAD "what_is_this: 7\n" SPACES, SHD_OK, ""},
    {"config/empty", "", SHD_ERROR_CORRUPT, "color.config_text: "},
    {"config/not_yaml", "{[}]: %s %n", SHD_ERROR_CORRUPT, "color.config_text: "},
    {"config/binary", "\x01\x02\x7f\x1b[31m", SHD_ERROR_CORRUPT, "color.config_text: "},
    {"config/no_spaces", "ocio_profile_version: 2\n", SHD_ERROR_CORRUPT, "color.config_text: "},
    {"config/version_3", "ocio_profile_version: 3\n" SPACES, SHD_ERROR_UNSUPPORTED, "version"},
    {"config/version_2_4", "ocio_profile_version: 2.4\n" SPACES, SHD_ERROR_UNSUPPORTED, "version"},
    {"config/version_text", "ocio_profile_version: two\n" SPACES, SHD_ERROR_CORRUPT, "color.config_text: "},
    {"config/view_of_no_space",
     "ocio_profile_version: 2\nroles: {default: lin, scene_linear: lin}\n"
     "displays:\n  screen:\n    - !<View> {name: v, colorspace: gone %s}\n" SPACES,
     SHD_ERROR_CORRUPT, "gone %s"},
    {"config/no_scene_linear",
     "ocio_profile_version: 1\nroles: {default: lin}\n"
     "displays:\n  screen:\n    - !<View> {name: v, colorspace: lin}\n" SPACES,
     SHD_ERROR_NOT_FOUND, "color.working_space: no colour space 'scene_linear'; there are 'lin'"},
    {"config/defined_by_itself", HEAD SPACES SPACE("a", "    to_scene_reference: " CST("a", "lin")), SHD_ERROR_CORRUPT,
     "a' is defined in a circle"},
    {"config/circle_of_two",
     HEAD SPACES SPACE("a", "    to_scene_reference: " CST("b", "lin"))
         SPACE("b", "    from_scene_reference: " CST("lin", "a")),
     SHD_ERROR_CORRUPT, "is defined in a circle"},
    {"config/circle_in_a_group",
     HEAD SPACES SPACE("a",
                       "    from_scene_reference: !<GroupTransform>\n      children:\n"
                       "        - !<MatrixTransform> {offset: [1, 2, 3, 0]}\n        - " CST("lin", "a")),
     SHD_ERROR_CORRUPT, "is defined in a circle"},
    {"config/circle_through_a_look",
     HEAD "looks:\n  - !<Look>\n    name: warm\n    process_space: a\n    transform: " CST("a", "lin")
         SPACES SPACE("a", "    to_scene_reference: !<LookTransform> {src: lin, dst: lin, looks: warm}\n"),
     SHD_ERROR_CORRUPT, "is defined in a circle"},
    {"config/circle_through_a_view",
     HEAD SPACES SPACE("a",
                       "    to_scene_reference: !<DisplayViewTransform> {src: a, display: screen, "
                       "view: look at it}\n"),
     SHD_ERROR_CORRUPT, "is defined in a circle"},
    {"config/not_a_circle",
     HEAD SPACES SPACE("a", "    to_scene_reference: " CST("b", "lin"))
         SPACE("b", "    to_scene_reference: !<MatrixTransform> {offset: [0.5, 0, 0, 0]}\n"),
     SHD_OK, ""},
};

static shd_context *make_context(void)
{
    shd_context *context = NULL;
    shd_assert_ok(shd_context_create(NULL, &context));
    return context;
}

/** Checks that the handle works: transforms one pixel for the default display. */
static void assert_works(const shd_color *color)
{
    const float in[4] = {0.18f, 0.18f, 0.18f, 1.0f};
    float out[4] = {-1, -1, -1, -1};
    shd_image source = shd_test_image(SHD_FORMAT_RGBA32F, 1, 1, (void *)in);
    shd_image image = shd_test_image(SHD_FORMAT_RGBA32F, 1, 1, out);
    shd_assert_ok(shd_color_apply_display_image(color, &source, NULL, NULL, NULL, &image));
    assert_true(out[0] > 0.0f && out[0] < 1.0f && out[3] == 1.0f);
}

static void test_config(void **state)
{
    const struct config_case *c = (const struct config_case *)*state;
    shd_context *context = make_context();
    shd_color_desc desc = shd_color_desc_default();
    shd_color *color = (shd_color *)&desc;
    desc.config_text = c->text;
    shd_assert_result(c->name, shd_color_create(context, &desc, &color), c->expected, c->message);
    assert_null(strchr(shd_last_error(), '\n'));
    if (c->expected == SHD_OK) {
        assert_works(color);
        shd_color_release(color);
    } else {
        assert_null(color);
    }
    desc.config_text = shd_color_default_config();
    shd_assert_ok(shd_color_create(context, &desc, &color));
    assert_works(color);
    shd_color_release(color);
    shd_context_release(context);
}

/** Space s0 is defined by s1, s1 by s2 and so on. */
static void test_chain(void **state)
{
    static const struct {
        int length;
        shd_result expected;
    } cases[] = {{1, SHD_OK}, {30, SHD_OK}, {70, SHD_ERROR_LIMIT}, {3000, SHD_ERROR_LIMIT}};
    const size_t size = 1 << 20;
    char *text = (char *)malloc(size);
    shd_context *context = make_context();
    size_t k;
    (void)state;
    for (k = 0; k < sizeof cases / sizeof cases[0]; ++k) {
        shd_color_desc desc = shd_color_desc_default();
        shd_color *color = NULL;
        size_t used = (size_t)snprintf(text, size, "%s", HEAD SPACES);
        int i;
        for (i = 0; i < cases[k].length; ++i) {
            used += (size_t)snprintf(text + used, size - used,
                                     SPACE("s%d", "    to_scene_reference: " CST("s%d", "lin")), i, i + 1);
        }
        snprintf(text + used, size - used, SPACE("s%d", ""), i);
        desc.config_text = text;
        desc.working_space = "s0";
        shd_assert_result("chain", shd_color_create(context, &desc, &color), cases[k].expected, "chain of more than");
        if (color) assert_works(color);
        shd_color_release(color);
    }
    free(text);
    shd_context_release(context);
}

struct desc_case {
    const char *name;
    void (*edit)(shd_color_desc *desc);
    shd_result expected;
    const char *message;
};

static void edit_nothing(shd_color_desc *d) { (void)d; }
static void edit_size_zero(shd_color_desc *d) { d->struct_size = 0; }
static void edit_size_small(shd_color_desc *d) { d->struct_size = 8; }
static void edit_size_huge(shd_color_desc *d) { d->struct_size = 0xffffffffu; }
static void edit_both(shd_color_desc *d) { d->config_path = d->config_text = "x"; }
static void edit_no_file(shd_color_desc *d) { d->config_path = "/nowhere/%s%n.ocio"; }
static void edit_empty_path(shd_color_desc *d) { d->config_path = ""; }
static void edit_directory(shd_color_desc *d) { d->config_path = "/"; }
static void edit_device(shd_color_desc *d) { d->config_path = "/dev/zero"; }
static void edit_builtin_name(shd_color_desc *d) { d->config_path = "ocio://default"; }
static void edit_invalid_utf8(shd_color_desc *d) { d->config_path = "\xff\xfe\x80.ocio"; }
static void edit_space(shd_color_desc *d) { d->working_space = "ACEScg"; }
static void edit_role(shd_color_desc *d) { d->working_space = "rendering"; }
static void edit_space_unknown(shd_color_desc *d) { d->working_space = "%s%s%n"; }
static void edit_space_empty(shd_color_desc *d) { d->working_space = ""; }

static const struct desc_case k_desc[] = {
    {"desc/defaults", edit_nothing, SHD_OK, ""},
    {"desc/working_space", edit_space, SHD_OK, ""},
    {"desc/working_space_role", edit_role, SHD_OK, ""},
    {"desc/struct_size_zero", edit_size_zero, SHD_ERROR_INVALID_ARGUMENT, "color.struct_size: 0 is below"},
    {"desc/struct_size_small", edit_size_small, SHD_ERROR_INVALID_ARGUMENT, "color.struct_size: 8 is below"},
    {"desc/struct_size_huge", edit_size_huge, SHD_ERROR_INVALID_ARGUMENT, "color.struct_size: 4294967295"},
    {"desc/path_and_text", edit_both, SHD_ERROR_INVALID_ARGUMENT, "color.config_text: set, but config_path"},
    {"desc/missing_file", edit_no_file, SHD_ERROR_NOT_FOUND, "color.config_path: no file \"/nowhere/%s%n.ocio\""},
    {"desc/empty_path", edit_empty_path, SHD_ERROR_INVALID_ARGUMENT, "color.config_path: empty"},
    {"desc/directory", edit_directory, SHD_ERROR_IO, "not a regular file"},
    {"desc/endless_device", edit_device, SHD_ERROR_IO, "not a regular file"},
    {"desc/name_of_a_later_version", edit_builtin_name, SHD_ERROR_NOT_FOUND, "ocio://default"},
    {"desc/path_not_utf8", edit_invalid_utf8, SHD_ERROR_NOT_FOUND, "color.config_path"},
    {"desc/unknown_space", edit_space_unknown, SHD_ERROR_NOT_FOUND,
     "color.working_space: no colour space '%s%s%n'; there are 'sRGB', 'Rec.709', 'ACES2065-1', 'ACEScg'"},
    {"desc/empty_space", edit_space_empty, SHD_ERROR_NOT_FOUND, "color.working_space: no colour space ''"},
};

static void test_desc(void **state)
{
    const struct desc_case *c = (const struct desc_case *)*state;
    shd_context *context = make_context();
    shd_color_desc desc = shd_color_desc_default();
    shd_color *color = (shd_color *)&desc;
    c->edit(&desc);
    shd_assert_result(c->name, shd_color_create(context, &desc, &color), c->expected, c->message);
    assert_true((color != NULL) == (c->expected == SHD_OK));
    shd_color_release(color);
    shd_context_release(context);
}

static void test_null_arguments(void **state)
{
    shd_context *context = make_context();
    shd_color *color = (shd_color *)&context;
    (void)state;
    shd_assert_result("out", shd_color_create(context, NULL, NULL), SHD_ERROR_INVALID_ARGUMENT, "out_color: NULL");
    shd_assert_result("context", shd_color_create(NULL, NULL, &color), SHD_ERROR_INVALID_ARGUMENT, "context: NULL");
    assert_null(color);
    shd_color_retain(NULL);
    shd_color_release(NULL);
    assert_int_equal(shd_color_get_display_count(NULL), 0);
    assert_int_equal(shd_color_get_view_count(NULL, NULL), 0);
    assert_int_equal(shd_color_get_space_count(NULL), 0);
    assert_null(shd_color_get_display_name(NULL, 0));
    assert_null(shd_color_get_view_name(NULL, NULL, 0));
    assert_null(shd_color_get_space_name(NULL, 0));
    assert_null(shd_color_get_default_display(NULL));
    assert_null(shd_color_get_default_view(NULL, NULL));
    assert_null(shd_color_get_working_space(NULL));
    shd_context_release(context);
}

static void test_lifecycle(void **state)
{
    shd_context *context = make_context();
    shd_color *color = NULL;
    const float pixel[4] = {0, 0, 0, 1};
    float out[4];
    shd_image in = shd_test_image(SHD_FORMAT_RGBA32F, 1, 1, (void *)pixel);
    shd_image image = shd_test_image(SHD_FORMAT_RGBA32F, 1, 1, out);
    (void)state;
    shd_assert_ok(shd_color_create(context, NULL, &color));
    shd_color_retain(color);
    shd_color_release(color);
    assert_works(color);
    shd_color_release(color);
    shd_assert_result("released", shd_color_apply_display_image(color, &in, NULL, NULL, NULL, &image),
                      SHD_ERROR_INVALID_ARGUMENT, "color: not a live handle");
    shd_color_release(color);
    shd_assert_ok(shd_color_create(context, NULL, &color));
    shd_context_release(context);
    assert_works(color); /* keeps its context */
    shd_color_release(color);
}

static void test_names(void **state)
{
    static const char *const displays[] = {"sRGB", "Rec.709"};
    static const char *const views[] = {SHD_ACES_VIEW, "Plain", "Raw"};
    static const char *const spaces[] = {"ACES2065-1", "ACEScg", "Linear Rec.709", "sRGB - Texture", "Raw"};
    shd_context *context = NULL;
    shd_color *color = shd_test_color(1, &context);
    uint32_t d, v, s, found = 0;
    (void)state;
    assert_int_equal(shd_color_get_display_count(color), 2);
    assert_string_equal(shd_color_get_default_display(color), "sRGB");
    assert_string_equal(shd_color_get_default_view(color, NULL), SHD_ACES_VIEW);
    assert_string_equal(shd_color_get_working_space(color), "Linear Rec.709");
    for (d = 0; d < 2; ++d) {
        assert_string_equal(shd_color_get_display_name(color, d), displays[d]);
        assert_int_equal(shd_color_get_view_count(color, displays[d]), 3);
        for (v = 0; v < 3; ++v) assert_string_equal(shd_color_get_view_name(color, displays[d], v), views[v]);
        assert_null(shd_color_get_view_name(color, displays[d], 3));
    }
    assert_null(shd_color_get_display_name(color, 2));
    assert_int_equal(shd_color_get_view_count(color, "Nothing"), 0);
    assert_null(shd_color_get_view_name(color, "Nothing", 0));
    assert_null(shd_color_get_default_view(color, "Nothing"));
    for (s = 0; s < shd_color_get_space_count(color); ++s) {
        size_t k;
        for (k = 0; k < 5; ++k) found += strcmp(shd_color_get_space_name(color, s), spaces[k]) == 0;
    }
    assert_int_equal(found, 5);
    assert_null(shd_color_get_space_name(color, s));
    shd_color_release(color);
    shd_context_release(context);
}

/** Writes `text` to a new file and returns its path. */
static void write_file(char *path, const char *text)
{
    const int fd = mkstemp(path);
    assert_true(fd >= 0);
    assert_int_equal(write(fd, text, strlen(text)), (ssize_t)strlen(text));
    close(fd);
}

static void test_files(void **state)
{
    char path[] = "/tmp/shd_color_XXXXXX", broken[] = "/tmp/shd_color_XXXXXX", fifo[] = "/tmp/shd_color_XXXXXX";
    shd_context *context = make_context();
    shd_color_desc desc = shd_color_desc_default();
    shd_color *color = NULL;
    (void)state;
    write_file(path, shd_color_default_config());
    write_file(broken, "ocio_profile_version: [");
    write_file(fifo, "");
    unlink(fifo);
    assert_int_equal(mkfifo(fifo, 0600), 0);
    desc.config_path = path;
    shd_assert_ok(shd_color_create(context, &desc, &color));
    assert_int_equal(shd_color_get_display_count(color), 2);
    shd_color_release(color);
    desc.config_path = broken;
    shd_assert_result("broken", shd_color_create(context, &desc, &color), SHD_ERROR_CORRUPT, "color.config_path: ");
    desc.config_path = fifo;
    shd_assert_result("fifo", shd_color_create(context, &desc, &color), SHD_ERROR_IO, "not a regular file");

    desc.config_path = NULL;
    setenv("OCIO", path, 1);
    shd_assert_ok(shd_color_create(context, &desc, &color));
    shd_color_release(color);
    setenv("OCIO", "/nowhere/config.ocio", 1);
    shd_assert_result("environment", shd_color_create(context, &desc, &color), SHD_ERROR_NOT_FOUND, "from $OCIO");
    desc.config_text = shd_color_default_config();
    shd_assert_ok(shd_color_create(context, &desc, &color));
    shd_color_release(color);
    desc.config_text = NULL;
    setenv("OCIO", "", 1);
    shd_assert_ok(shd_color_create(context, &desc, &color));
    shd_color_release(color);
    unsetenv("OCIO");
    unlink(path);
    unlink(broken);
    unlink(fifo);
    shd_context_release(context);
}

/** Configs, and tables that a config names, which are no readable regular files. */
static void test_odd_paths(void **state)
{
    static const char k_text[] = HEAD SPACES SPACE("table", "    to_scene_reference: !<FileTransform> {src: %s}\n");
    shd_context *context = make_context();
    char text[4096], path[600];
    size_t i;
    assert_int_equal(io_make_folder(state), 0);
    make_odd_paths();
    for (i = 0; i < ODD_PATHS; ++i) {
        const odd_path *p = &k_odd_paths[i];
        shd_color_desc desc = shd_color_desc_default();
        shd_color *color = (shd_color *)&desc;
        if (!has_odd_path(p)) continue;
        snprintf(path, sizeof path, "%s", io_path(p->name));
        desc.config_path = path;
        alarm(20); /* ends the test if the load waits */
        shd_assert_result(p->name, shd_color_create(context, &desc, &color), p->expected, p->message);
        assert_null(color);
        assert_non_null(strstr(shd_last_error(), p->name));
        if (strcmp(p->message, "is not a regular file") != 0) continue; /* refused by the transforms that need it */
        snprintf(text, sizeof text, k_text, path);
        desc.config_path = NULL;
        desc.config_text = text;
        shd_assert_result(p->name, shd_color_create(context, &desc, &color), SHD_ERROR_IO, p->message);
        assert_non_null(strstr(shd_last_error(), p->name));
    }
    alarm(0);
    io_remove_folder(state);
    shd_context_release(context);
}

/** A view whose lookup table is missing is refused with its name; the other views work. */
static void test_missing_table(void **state)
{
    static const char text[] = HEAD "search_path: /nowhere\n" SPACES SPACE(
        "table", "    from_scene_reference: !<FileTransform> {src: gone.cube}\n");
    const float pixel[4] = {0.5f, 0.5f, 0.5f, 1.0f};
    float out[4] = {-1, -1, -1, -1};
    shd_image image = shd_test_image(SHD_FORMAT_RGBA32F, 1, 1, out);
    shd_context *context = make_context();
    shd_color_desc desc = shd_color_desc_default();
    shd_color *color = NULL;
    int i;
    (void)state;
    desc.config_text = text;
    shd_assert_ok(shd_color_create(context, &desc, &color));
    for (i = 0; i < 2; ++i) {
        memcpy(out, pixel, sizeof out);
        shd_assert_result("table", shd_color_convert(color, &image, "lin", "table"), SHD_ERROR_NOT_FOUND, "gone.cube");
        assert_memory_equal(out, pixel, sizeof out);
        assert_works(color);
    }
    shd_color_release(color);
    shd_context_release(context);
}

/** Messages of OpenColorIO do not reach stderr. */
static void test_silent(void **state)
{
    char path[] = "/tmp/shd_color_XXXXXX";
    const int fd = mkstemp(path), saved = dup(2);
    shd_context *context = make_context();
    off_t written;
    size_t i;
    (void)state;
    fflush(stderr);
    dup2(fd, 2);
    for (i = 0; i < sizeof k_config / sizeof k_config[0]; ++i) {
        shd_color_desc desc = shd_color_desc_default();
        shd_color *color = NULL;
        desc.config_text = k_config[i].text;
        if (shd_color_create(context, &desc, &color) == SHD_OK) assert_works(color);
        shd_color_release(color);
    }
    fflush(stderr);
    dup2(saved, 2);
    written = lseek(fd, 0, SEEK_END);
    close(saved);
    close(fd);
    unlink(path);
    assert_int_equal(written, 0);
    shd_context_release(context);
}

/** A host that writes decimals with a comma gets the same numbers, and keeps its locale. */
static void test_locale(void **state)
{
    static const char *const names[] = {"de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8", "fr_FR.utf8"};
    static const char text[] =
        HEAD SPACES SPACE("a", "    to_scene_reference: !<MatrixTransform> {offset: [0.25, 0.5, 0.75, 0]}\n");
    shd_context *context = make_context();
    shd_color_desc desc = shd_color_desc_default();
    shd_color *color = NULL;
    float out[4] = {0, 0, 0, 1};
    shd_image image = shd_test_image(SHD_FORMAT_RGBA32F, 1, 1, out);
    const char *chosen = NULL;
    size_t i;
    (void)state;
    for (i = 0; i < sizeof names / sizeof names[0] && !chosen; ++i) chosen = setlocale(LC_ALL, names[i]);
    if (!chosen) {
        print_message("no locale with a decimal comma on this machine\n");
        shd_context_release(context);
        skip();
    }
    assert_string_equal(localeconv()->decimal_point, ",");
    desc.config_text = text;
    shd_assert_ok(shd_color_create(context, &desc, &color));
    shd_assert_ok(shd_color_convert(color, &image, "a", NULL));
    assert_true(out[0] == 0.25f && out[1] == 0.5f && out[2] == 0.75f);
    shd_color_release(color);
    desc.config_text = shd_color_default_config();
    desc.working_space = "ACEScg";
    shd_assert_ok(shd_color_create(context, &desc, &color));
    out[0] = out[1] = out[2] = 0.18f;
    shd_assert_ok(shd_color_apply_display_image(color, &image, NULL, "sRGB", SHD_ACES_VIEW, &image));
    shd_assert_close("ACES", 0, out[1], 0.356, 5e-4, 0);
    assert_string_equal(localeconv()->decimal_point, ",");
    setlocale(LC_ALL, "C");
    shd_color_release(color);
    shd_context_release(context);
}

/** Every prefix of the built-in config, and the config with one byte changed, gives a result and never crashes. */
static void test_damaged(void **state)
{
    static const char changes[] = {'\0', '\n', ':', '{', '[', '!', '&', '*', '"', '9', '\xff', '\t', '%'};
    const size_t size = strlen(shd_color_default_config());
    char *text = (char *)malloc(size + 1);
    shd_context *context = make_context();
    size_t cut, accepted = 0;
    (void)state;
    for (cut = 0; cut < 2 * size; ++cut) {
        shd_color_desc desc = shd_color_desc_default();
        shd_color *color = NULL;
        shd_result result;
        memcpy(text, shd_color_default_config(), size + 1);
        if (cut < size) {
            text[cut] = '\0';
        } else {
            text[cut - size] = changes[cut % sizeof changes];
        }
        desc.config_text = text;
        result = shd_color_create(context, &desc, &color);
        accepted += result == SHD_OK;
        assert_true((color != NULL) == (result == SHD_OK));
        if (result != SHD_OK) assert_string_not_equal(shd_last_error(), "");
        if (color && shd_color_get_default_view(color, NULL)) {
            float out[4] = {0.5f, 0.5f, 0.5f, 1.0f};
            shd_image image = shd_test_image(SHD_FORMAT_RGBA32F, 1, 1, out);
            result = shd_color_apply_display_image(color, &image, NULL, NULL, NULL, &image);
            assert_int_not_equal(result, SHD_ERROR_INTERNAL);
        }
        shd_color_release(color);
    }
    assert_true(accepted > 0);
    free(text);
    shd_context_release(context);
}

int main(void)
{
    struct CMUnitTest tests[64];
    size_t n = 0, i;
    unsetenv("OCIO");
    for (i = 0; i < sizeof k_config / sizeof k_config[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_config[i].name, test_config, NULL, NULL, (void *)&k_config[i]};
    }
    for (i = 0; i < sizeof k_desc / sizeof k_desc[0]; ++i) {
        tests[n++] = (struct CMUnitTest){k_desc[i].name, test_desc, NULL, NULL, (void *)&k_desc[i]};
    }
    tests[n++] = (struct CMUnitTest){"config/chain", test_chain, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"config/damaged", test_damaged, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"null_arguments", test_null_arguments, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"lifecycle", test_lifecycle, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"names", test_names, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"files", test_files, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"odd_paths", test_odd_paths, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"missing_table", test_missing_table, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"silent", test_silent, NULL, NULL, NULL};
    tests[n++] = (struct CMUnitTest){"locale", test_locale, NULL, NULL, NULL};
    return _cmocka_run_group_tests("api.color", tests, n, NULL, NULL);
}
