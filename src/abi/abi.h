// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: abi, the boundary between C callers and the C++ inside.
///
/// Input:      the caller's handles, descs and columns, of which nothing is trusted.
/// Output:     calls of the stages with checked values; results and error texts.
/// Invariants: the only place with extern "C" bodies, one file for each public header; nothing throws across it;
///             floating-point control is the IEEE default inside and the host's again outside; errno comes back; a
///             failed call changes nothing and nulls its out handle. Every folder may be included, none includes it.
///
/// | file              | what                                                                         |
/// |-------------------|------------------------------------------------------------------------------|
/// | guard.h           | exceptions to results, control bits and errno, for libshd                    |
/// | desc.h            | reading descs of any version, checks that name the field, shd_desc_init      |
/// | handle.h          | handles to bodies and back                                                   |
/// | draws.h           | the draws of a frame or a shadow                                             |
/// | levels.h          | mip levels of the caller's                                                   |
/// | batch.h           | the columns of one call: checked, split over the executor, staged if strided |
/// | lookup_columns.h  | the columns of lookups, and whether a texture has what a filter reads         |
/// | color/            | the C functions of libshd_color                                              |
/// | io/               | the C functions of libshd_io; common.h is what its files share               |
#pragma once
