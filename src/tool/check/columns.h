// SPDX-License-Identifier: MIT
#pragma once
#include <initializer_list>

#include "tool/check/case.h"

// Changes of the columns of a case. Absent columns stay absent.

/// Adds a constant to u and to v.
void move_coordinates(Case& judged, float du, float dv);

/// Multiplies columns.
void scale(Case& judged, std::initializer_list<Input> columns, float factor);

void swap_columns(Case& judged, Input one, Input other);

/// Swaps two coordinates (kU, kV, kW) and their derivatives.
void swap_axes(Case& judged, Input one, Input other);

/// Makes a coordinate 1 - x, or -x for directions, with its derivatives.
void flip_axis(Case& judged, Input axis, bool is_direction);

/// Multiplies the level of detail: the column lod, or the logarithm of the longer derivative. 2D only.
void scale_levels(Case& judged, float factor, float width, float height);

/// Replaces the longer derivative, in texels of level 0, by the shorter one. 2D only.
void keep_shorter_axis(Case& judged, float width, float height);
