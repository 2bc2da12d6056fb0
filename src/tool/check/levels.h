// SPDX-License-Identifier: MIT
#pragma once
#include "tool/check/bounds.h"

/// Bounds of the lookups of a case with rows, by the library alone.
Bounds bounds_of_lookups(shd_context* context, const shd_texture* texture, const Case& judged);

/// Bounds of lookups whose coordinates are `shift` texels off on each level that they read. The library has bounds of
/// points, which are the same on all levels, so each level is judged alone, and legal levels blend their bounds.
/// Filters: all but ANISOTROPIC, in 2D. The case has rows.
Bounds bounds_by_level(Textures& textures, const Case& judged);
