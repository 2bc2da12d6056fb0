/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Names of the constants of enums, for messages, menus and command lines.
 *
 * A name is the constant without its prefix, in lower case: "anisotropic" for SHD_FILTER_ANISOTROPIC. The functions
 * give NULL for a number that is no constant, so a loop from 0 on finds all names. shd_result_name() is in
 * shd/result.h.
 *
 * Thread safety: any thread. The texts are static.
 *
 * @code
 * shd_filter filter = SHD_FILTER_TRILINEAR;
 * while (shd_filter_name(filter) && strcmp(shd_filter_name(filter), wanted)) filter = (shd_filter)(filter + 1);
 * @endcode
 */
#ifndef SHD_NAMES_H
#define SHD_NAMES_H

#include <shd/context.h>
#include <shd/draw.h>
#include <shd/image.h>
#include <shd/light.h>
#include <shd/material.h>
#include <shd/mip.h>
#include <shd/projection.h>
#include <shd/render.h>
#include <shd/sampler.h>
#include <shd/shadow.h>
#include <shd/shapes.h>
#include <shd/solid.h>
#include <shd/texture.h>

SHD_BEGIN_DECLS

/** Name of a constant of shd_simd; NULL for other numbers. @since 0.1 */
SHD_API const char *shd_simd_name(shd_simd value);

/** Name of a constant of shd_format; NULL for other numbers. @since 0.1 */
SHD_API const char *shd_format_name(shd_format value);

/** Name of a constant of shd_wrap; NULL for other numbers. @since 0.1 */
SHD_API const char *shd_wrap_name(shd_wrap value);

/** Name of a constant of shd_filter; NULL for other numbers. @since 0.1 */
SHD_API const char *shd_filter_name(shd_filter value);

/** Name of a constant of shd_magnification; NULL for other numbers. @since 0.1 */
SHD_API const char *shd_magnification_name(shd_magnification value);

/** Name of a constant of shd_cubic; NULL for other numbers. @since 0.1 */
SHD_API const char *shd_cubic_name(shd_cubic value);

/** Name of a constant of shd_profile; NULL for other numbers. @since 0.1 */
SHD_API const char *shd_profile_name(shd_profile value);

/** Name of a constant of shd_precision; NULL for other numbers. @since 0.1 */
SHD_API const char *shd_precision_name(shd_precision value);

/** Name of a constant of shd_stochastic; NULL for other numbers. @since 0.1 */
SHD_API const char *shd_stochastic_name(shd_stochastic value);

/** Name of a constant of shd_compare; NULL for other numbers. @since 0.1 */
SHD_API const char *shd_compare_name(shd_compare value);

/** Name of a constant of shd_texture_kind; NULL for other numbers. @since 0.1 */
SHD_API const char *shd_texture_kind_name(shd_texture_kind value);

/** Name of a constant of shd_projection; NULL for other numbers. @since 0.1 */
SHD_API const char *shd_projection_name(shd_projection value);

/** Name of a constant of shd_mip_kernel; NULL for other numbers. @since 0.1 */
SHD_API const char *shd_mip_kernel_name(shd_mip_kernel value);

/** Name of a constant of shd_texel_content; NULL for other numbers. @since 0.1 */
SHD_API const char *shd_texel_content_name(shd_texel_content value);

/** Name of a constant of shd_shape; NULL for other numbers. @since 0.1 */
SHD_API const char *shd_shape_name(shd_shape value);

/** Name of a constant of shd_solid; NULL for other numbers. @since 0.1 */
SHD_API const char *shd_solid_name(shd_solid value);

/** Name of a constant of shd_model; NULL for other numbers. @since 0.1 */
SHD_API const char *shd_model_name(shd_model value);

/** Name of a constant of shd_blend; NULL for other numbers. @since 0.1 */
SHD_API const char *shd_blend_name(shd_blend value);

/** Name of a constant of shd_normal_encoding; NULL for other numbers. @since 0.1 */
SHD_API const char *shd_normal_encoding_name(shd_normal_encoding value);

/** Name of a constant of shd_slot_target; NULL for other numbers. @since 0.1 */
SHD_API const char *shd_slot_target_name(shd_slot_target value);

/** Name of a constant of shd_light_kind; NULL for other numbers. @since 0.1 */
SHD_API const char *shd_light_kind_name(shd_light_kind value);

/** Name of a constant of shd_shadow_filter; NULL for other numbers. @since 0.1 */
SHD_API const char *shd_shadow_filter_name(shd_shadow_filter value);

/** Name of a constant of shd_frequency; NULL for other numbers. @since 0.1 */
SHD_API const char *shd_frequency_name(shd_frequency value);

/** Name of a constant of shd_cull; NULL for other numbers. @since 0.1 */
SHD_API const char *shd_cull_name(shd_cull value);

/** Name of a constant of shd_fill; NULL for other numbers. @since 0.1 */
SHD_API const char *shd_fill_name(shd_fill value);

/** Name of a constant of shd_visibility; NULL for other numbers. @since 0.1 */
SHD_API const char *shd_visibility_name(shd_visibility value);

SHD_END_DECLS

#endif /* SHD_NAMES_H */
