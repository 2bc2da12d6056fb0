/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief A tracer for shd/occlusion.h over Embree 3 or 4 (libshd_embree).
 *
 * Rays are tested one by one against triangles in world space, in Embree's robust mode, without vertex programs. A ray
 * that passes within rounding of an edge or starts within rounding of a triangle may be decided either way. The answers
 * do not depend on the number of workers, nor on how rays are split into batches. Embree chooses its kernels by the
 * processor, and with them the rounding: the answers for such rays, and so the bits of occlusion, may differ between
 * machines and between versions of Embree.
 *
 * Memory:        Embree allocates its tree with its own allocator, about 200 bytes a triangle.
 * Threads:       Embree builds the tree on threads of oneTBB, not on the context's executor. Rays are traced by the
 *                threads that call the tracer.
 * Lifetime:      reference counted; create returns an owned reference.
 * Thread safety: retain/release from any thread; a tree never changes, so concurrent use is free.
 *
 * @code
 * shd_occlusion_desc desc = shd_occlusion_desc_default();
 * result = shd_embree_create(context, draws, draw_count, &tree);
 * result = shd_embree_get_tracer(tree, &desc.tracer);
 * result = shd_occlusion_compute_vertices(context, &desc, &draws[0], &out);
 * shd_embree_release(tree);
 * @endcode
 */
#ifndef SHD_EMBREE_H
#define SHD_EMBREE_H

#include <shd/occlusion.h>

SHD_BEGIN_DECLS

/** The triangles of draws, in a tree. */
typedef struct shd_embree shd_embree;

/**
 * Build a tree of the triangles of draws. Triangles with a position that is not finite are left out.
 * @param context     retained
 * @param draws       [draw_count], all with the same struct_size; mesh, object_to_world and instances are read; NULL if
 *                    draw_count is 0. Borrowed for the call
 * @param draw_count  up to 2^20 with all instances; a tree without triangles blocks no ray
 * @param out_embree  owned; NULL on failure
 * @return SHD_ERROR_INTERNAL if Embree fails
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_embree_create(shd_context *context, const shd_draw *draws, size_t draw_count,
                                                   shd_embree **out_embree);

/** Add a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_embree_retain(shd_embree *embree);

/** Drop a reference; NULL is ignored. Any thread. @since 0.1 */
SHD_API void shd_embree_release(shd_embree *embree);

/**
 * Get the tracer of a tree.
 * @param out_tracer  valid until release of the tree; all zero on failure
 * @since 0.1
 */
SHD_NODISCARD SHD_API shd_result shd_embree_get_tracer(const shd_embree *embree, shd_tracer *out_tracer);

SHD_END_DECLS

#endif /* SHD_EMBREE_H */
