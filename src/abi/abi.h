// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: abi, the boundary between C callers and the C++ inside.
///
/// Input:      the caller's handles, descs and columns, all of which are checked.
/// Output:     calls of the stages with checked values; results and error texts.
/// Invariants: the only place with extern "C" bodies, one file for each public header. No exception leaves a function.
///             Floating-point control is the IEEE default inside; the host's control bits and errno are restored. A
///             failed call changes nothing and sets its out handle to NULL. This folder may include every other one,
///             and only the abi/ of the other libraries includes it. Functions that are named check_<what> and
///             read_<what> return a result; those of the other libraries throw a Failure.
///
/// | file             | content                                                                           |
/// |------------------|-----------------------------------------------------------------------------------|
/// | guard.h          | the guard of libshd's functions                                                   |
/// | desc.h           | descs of any version in and out, checks that name the field, shd_desc_init        |
/// | handle.h         | handles to bodies and back                                                        |
/// | batch.h          | the columns of one call: checked, split over the executor, copied if strided      |
/// | solid.h          | solid textures of the caller, checked                                             |
/// | volume.h         | volumes of a frame, checked                                                       |
/// | lookup.h         | the columns of lookups; whether a texture has the tables that a filter reads      |
/// | call_in_place.h  | calls of shd_texture_sample() that need few checks                                |
/// | camera.h         | cameras, axes of views and look-at matrices                                       |
/// | draws.h          | the draws of a frame or a shadow                                                  |
/// | render.h         | frames and bakes from one desc                                                    |
/// | bake.h           | statistics of a bake from the states of its texels                                |
/// | levels.h         | mip levels that the caller gives                                                  |
/// | texture_desc.h   | descs of textures                                                                 |
/// | black_draws.h    | draws that cannot have a colour                                                   |
#pragma once
