/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief All headers of libshd. libshd_color, libshd_io, libshd_scene and libshd_embree have headers of their own:
 *        shd/color.h, shd/io.h, shd/texture_file.h, shd/volume_file.h, shd/scene.h and shd/embree.h.
 *
 * @page order Read in this order
 * Each group needs the groups before it only.
 * - Rules: this page; shd/result.h for errors, shd/desc.h for structs that may grow, shd/column.h for batches.
 * - Filtering: shd/context.h, shd/image.h, shd/texture.h, shd/sampler.h, shd/lookup.h; then shd/mip.h, shd/footprint.h
 *   and shd/projection.h for other levels, footprints and directions, shd/explain.h, shd/bounds.h and shd/table.h to
 *   judge lookups and tables, shd/tile_cache.h and shd/tiles.h for textures larger than memory.
 * - A first frame: shd/transform.h, shd/view.h, shd/mesh.h, shd/material.h, shd/light.h, shd/draw.h, shd/framebuffer.h
 *   and shd/render.h. examples/triangle.c is the shortest program.
 * - Surfaces: shd/slot.h puts textures on a material; shd/solid.h, shd/shapes.h, shd/uv_projection.h,
 *   shd/tessellate.h, shd/edges.h.
 * - Light: shd/shadow.h, shd/environment.h, shd/occlusion.h, shd/bake.h, shd/volume.h.
 * - Own code in a frame: shd/vertices.h, shd/fragments.h, shd/present.h; in a library of handles: shd/extension.h.
 * - Files and colour: shd/io.h, shd/texture_file.h, shd/tile_file.h, shd/volume_file.h, shd/scene.h, shd/color.h.
 *
 * @page conventions Conventions
 * World: right-handed, +Y up; matrices `float[16]`, column-major, for column vectors. Clip space: NDC y up,
 * depth 0..1. Front faces are counter-clockwise seen with y up. Images and textures: row 0 on top, centres at
 * +1/2, (u, v) = (0, 0) at the outer corner of the first texel of row 0, v downwards. Angles in radians.
 *
 * @page names Names
 * Types are `shd_<noun>`, functions `shd_<noun>_<verb>`. Constants of an enum are `SHD_<NOUN>_<VALUE>`; the noun is the
 * name of the enum, without `_flag` or `_target`. The results are the exception: SHD_OK and SHD_ERROR_<VALUE>. Every
 * enum ends with a `_MAX_ENUM`. Words of flags have the type `shd_<noun>_flags`.
 *
 * @page growth Growth
 * Structs that may grow begin with `struct_size`; shd/desc.h states the rules. All other structs are frozen.
 *
 * @page ownership Ownership
 * *Copied*: shd keeps its own copy. *Borrowed for the call* / *until release*: the caller keeps it alive that
 * long. *Retained*: shd adds a reference. *Owned*: the caller must release it. Releasing NULL does nothing.
 * A handle that is NULL or of another type is refused with SHD_ERROR_INVALID_ARGUMENT. A released handle is refused
 * while its context lives, until a new handle takes its place. A context whose last reference was released must not be
 * used, nor a pointer that never was a handle.
 *
 * @page errors Errors
 * Every call that can fail returns shd_result; shd_last_error() returns the text, per thread. A failed call
 * changes nothing and nulls its out handle. No exception, signal or output on stdout crosses the boundary.
 *
 * @page threads Threads
 * *Any thread*; *concurrent reads* (functions on const handles); *exclusive use of the object*. Each callback
 * documents its threads. shd restores floating-point control and errno, and does not change locale or signal masks.
 *
 * @page streams Streams
 * Batches are columns with byte strides (shd/column.h); a batch of n lookups costs one call.
 *
 * @page colour Colour
 * Everything between texture decode and libshd_color is scene-linear float; framebuffer colour is
 * premultiplied by alpha. sRGB texels are decoded before filtering; alpha is never encoded.
 *
 * @page determinism Determinism
 * For the same inputs libshd gives the same bits for any worker count, any way of splitting a batch and any
 * SIMD target. libshd_color is outside this promise: OpenColorIO's own kernels run there.
 *
 * @code
 * #include <shd/shd.h>
 * @endcode
 */
#ifndef SHD_SHD_H
#define SHD_SHD_H

#include <shd/bake.h>
#include <shd/base.h>
#include <shd/bounds.h>
#include <shd/column.h>
#include <shd/context.h>
#include <shd/desc.h>
#include <shd/draw.h>
#include <shd/edges.h>
#include <shd/environment.h>
#include <shd/explain.h>
#include <shd/footprint.h>
#include <shd/fragments.h>
#include <shd/framebuffer.h>
#include <shd/image.h>
#include <shd/light.h>
#include <shd/lookup.h>
#include <shd/material.h>
#include <shd/mesh.h>
#include <shd/mip.h>
#include <shd/names.h>
#include <shd/occlusion.h>
#include <shd/polygon.h>
#include <shd/polyhedron.h>
#include <shd/present.h>
#include <shd/projection.h>
#include <shd/render.h>
#include <shd/result.h>
#include <shd/sampler.h>
#include <shd/shadow.h>
#include <shd/shapes.h>
#include <shd/slot.h>
#include <shd/solid.h>
#include <shd/table.h>
#include <shd/tessellate.h>
#include <shd/texture.h>
#include <shd/tile_cache.h>
#include <shd/tiles.h>
#include <shd/transform.h>
#include <shd/vertices.h>
#include <shd/view.h>
#include <shd/volume.h>
#include <shd/wrap.h>

#endif /* SHD_SHD_H */
