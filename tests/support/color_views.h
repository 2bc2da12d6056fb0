/* SPDX-License-Identifier: MIT */
/* A config with many kinds of views: every output transform of ACES that OpenColorIO 2.1 has, matrices, looks, lookup
   tables; and views that no table describes. Files are written into g_folder of io_files.h. */
#ifndef SHD_TESTS_SUPPORT_COLOR_VIEWS_H
#define SHD_TESTS_SUPPORT_COLOR_VIEWS_H

#include "support/color.h"
#include "support/io_files.h"

/** Builtin transforms of ACES light to CIE XYZ, and the display's curve: names of OpenColorIO. */
static const char *const k_aces_views[][2] = {
    {"SDR-CINEMA_1.0", "G2.6-P3-D60-BFD"},
    {"SDR-VIDEO_1.0", "REC.1886-REC.2020"},
    {"SDR-CINEMA-REC709lim_1.1", "G2.6-P3-D65"},
    {"SDR-VIDEO-REC709lim_1.1", "G2.2-REC.709"},
    {"SDR-VIDEO-P3lim_1.1", "G2.6-P3-D65"},
    {"SDR-CINEMA-D60sim-D65_1.1", "REC.1886-REC.709"},
    {"SDR-VIDEO-D60sim-D65_1.0", "sRGB"},
    {"SDR-CINEMA-D60sim-DCI_1.0", "G2.6-P3-DCI-BFD"},
    {"SDR-CINEMA-D65sim-DCI_1.1", "G2.6-P3-DCI-BFD"},
    {"HDR-VIDEO-1000nit-15nit-REC2020lim_1.1", "REC.2100-PQ"},
    {"HDR-VIDEO-1000nit-15nit-P3lim_1.1", "REC.2100-HLG-1000nit"},
    {"HDR-VIDEO-2000nit-15nit-P3lim_1.1", "ST2084-P3-D65"},
    {"HDR-VIDEO-4000nit-15nit-REC2020lim_1.1", "REC.2100-PQ"},
    {"HDR-CINEMA-108nit-7.2nit-P3lim_1.1", "ST2084-P3-D65"},
};

/** A view made of transforms of the working space. */
struct view_row {
    const char *name;
    const char *transforms; /* children of a GroupTransform */
};

#define CURVE_SRGB \
    "        - !<ExponentWithLinearTransform> {gamma: 2.4, offset: 0.055, style: mirror, direction: inverse}\n"
#define CURVE_LOG                                                                          \
    "        - !<LogAffineTransform> {base: 2, lin_side_offset: 0.001, lin_side_slope: 1," \
    " log_side_slope: 0.06, log_side_offset: 0.6}\n"

#define CURVE_ACESCCT "        - !<BuiltinTransform> {style: CURVE - ACEScct-LOG_to_LINEAR, direction: inverse}\n"
#define MIX                                                                                            \
    "        - !<MatrixTransform> {matrix: [0.8, 0.1, 0.1, 0, 0.1, 0.8, 0.1, 0, 0.1, 0.1, 0.8, 0, 0, " \
    "0, 0, 1], offset: [0.02, -0.01, 0.03, 0]}\n"

static const struct view_row k_made_views[] = {
    {"contrast",
     "        - !<CDLTransform> {slope: [1.1, 1, 0.9], offset: [0.01, 0, -0.01], power: [1.2, 1.1, 1], "
     "style: asc}\n" CURVE_SRGB},
    {"saturated look", "        - !<CDLTransform> {power: [0.9, 0.9, 0.9], sat: 1.4, style: noclamp}\n" CURVE_SRGB},
    {"log", CURVE_LOG},
    {"log and offset matrix", CURVE_ACESCCT MIX},
    {"film tetrahedral", CURVE_LOG "        - !<FileTransform> {src: film.cube, interpolation: tetrahedral}\n"},
    {"film linear", CURVE_LOG "        - !<FileTransform> {src: film.cube, interpolation: linear}\n"},
    {"table of 1D", "        - !<FileTransform> {src: curve.spi1d, interpolation: linear}\n"},
    {"exposure",
     "        - !<ExposureContrastTransform> {style: linear, exposure: 1.5, contrast: 1.1, gamma: 1, "
     "pivot: 0.18}\n" CURVE_SRGB},
    {"grade",
     "        - !<GradingPrimaryTransform> {style: linear, contrast: {rgb: [1.1, 1, 1], master: 1.1}, "
     "saturation: 1.2}\n" CURVE_SRGB},
    {"tones",
     "        - !<GradingToneTransform> {style: linear, shadows: {rgb: [1.2, 1, 1], master: 1, start: 0.1, pivot: "
     "0}, s_contrast: 1.2}\n" CURVE_SRGB},
    {"surround back", "        - !<FixedFunctionTransform> {style: ACES_DarkToDim10, direction: inverse}\n" CURVE_SRGB},
};

/** Views that have to stay exact. */
static const struct view_row k_unbaked_views[] = {
    {"hue as red", "        - !<FixedFunctionTransform> {style: RGB_TO_HSV}\n"},
    {"gamut compression",
     "        - !<BuiltinTransform> {style: ACES-LMT - ACES 1.3 Reference Gamut Compression}\n"
     "        - !<BuiltinTransform> {style: ACES-OUTPUT - ACES2065-1_to_CIE-XYZ-D65 - "
     "SDR-VIDEO_1.0}\n        - !<BuiltinTransform> {style: DISPLAY - CIE-XYZ-D65_to_sRGB}\n"},
    {"logarithm of zero before a mix", CURVE_LOG MIX},
    {"noise", "        - !<FileTransform> {src: noise.spi1d, interpolation: nearest}\n"},
};

static inline void write_tables(void)
{
    const size_t size = 1 << 20;
    char *text = (char *)malloc(size);
    size_t used = (size_t)snprintf(text, size, "LUT_3D_SIZE 17\n");
    uint32_t i;
    for (i = 0; i < 17 * 17 * 17; ++i) { /* red fastest */
        const double r = i % 17 / 16.0, g = i / 17 % 17 / 16.0, b = i / 289 / 16.0;
        const double grey = 0.3 * r + 0.6 * g + 0.1 * b, film = grey * grey * (3 - 2 * grey);
        used += (size_t)snprintf(text + used, size - used, "%.6f %.6f %.6f\n", 0.7 * r * r + 0.3 * film,
                                 0.8 * g + 0.2 * film * b, 0.6 * b + 0.4 * film * (1 - r));
    }
    io_write(io_path("film.cube"), text, used);
    used = (size_t)snprintf(text, size, "Version 1\nFrom -0.1 1.5\nLength 64\nComponents 1\n{\n");
    for (i = 0; i < 64; ++i) used += (size_t)snprintf(text + used, size - used, "%.6f\n", pow(i / 63.0, 0.4));
    used += (size_t)snprintf(text + used, size - used, "}\n");
    io_write(io_path("curve.spi1d"), text, used);
    used = (size_t)snprintf(text, size, "Version 1\nFrom 0.0 64.0\nLength 60000\nComponents 1\n{\n");
    for (i = 0; i < 60000; ++i) {
        used += (size_t)snprintf(text + used, size - used, "%.6f\n", (i * 2654435761u >> 8) / 16777216.0);
    }
    used += (size_t)snprintf(text + used, size - used, "}\n");
    io_write(io_path("noise.spi1d"), text, used);
    free(text);
}

/** The config; the caller must free() it. */
static inline char *make_views_config(void)
{
    const size_t size = 1 << 16;
    char *text = (char *)malloc(size);
    size_t n = 0, i;
    const size_t aces = sizeof k_aces_views / sizeof k_aces_views[0];
    const size_t made = sizeof k_made_views / sizeof k_made_views[0];
    const size_t unbaked = sizeof k_unbaked_views / sizeof k_unbaked_views[0];
#define PUT(...) n += (size_t)snprintf(text + n, size - n, __VA_ARGS__)
    PUT("ocio_profile_version: 2.1\nsearch_path: %s\nroles: {default: lin, scene_linear: lin}\n"
        "file_rules:\n  - !<Rule> {name: Default, colorspace: default}\ndisplays:\n  aces:\n",
        g_folder);
    for (i = 0; i < aces; ++i) PUT("    - !<View> {name: %s, colorspace: aces %zu}\n", k_aces_views[i][0], i);
    PUT("  made:\n");
    for (i = 0; i < made; ++i) PUT("    - !<View> {name: %s, colorspace: made %zu}\n", k_made_views[i].name, i);
    PUT("  unbaked:\n");
    for (i = 0; i < unbaked; ++i)
        PUT("    - !<View> {name: %s, colorspace: unbaked %zu}\n", k_unbaked_views[i].name, i);
    PUT("colorspaces:\n  - !<ColorSpace>\n    name: lin\n");
    for (i = 0; i < aces; ++i) {
        PUT("  - !<ColorSpace>\n    name: aces %zu\n    from_scene_reference: !<GroupTransform>\n      children:\n"
            "        - !<BuiltinTransform> {style: ACES-OUTPUT - ACES2065-1_to_CIE-XYZ-D65 - %s}\n"
            "        - !<BuiltinTransform> {style: DISPLAY - CIE-XYZ-D65_to_%s}\n",
            i, k_aces_views[i][0], k_aces_views[i][1]);
    }
    for (i = 0; i < made; ++i) {
        PUT("  - !<ColorSpace>\n    name: made %zu\n    from_scene_reference: !<GroupTransform>\n      children:\n%s",
            i, k_made_views[i].transforms);
    }
    for (i = 0; i < unbaked; ++i) {
        PUT("  - !<ColorSpace>\n    name: unbaked %zu\n    from_scene_reference: !<GroupTransform>\n"
            "      children:\n%s",
            i, k_unbaked_views[i].transforms);
    }
#undef PUT
    if (n + 1 >= size) fail_msg("the config is longer than %zu bytes", size);
    return text;
}

#endif /* SHD_TESTS_SUPPORT_COLOR_VIEWS_H */
