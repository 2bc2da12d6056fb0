/* SPDX-License-Identifier: MIT */
/* The surface of a planet as a texture of 2^19 x 2^19 texels, 1 TiB. Tiles are computed when lookups need them. */
#ifndef FLYOVER_PLANET_H
#define FLYOVER_PLANET_H

#include <shd/shd.h>

/* Texels around the equator, and from pole to pole. On Earth a texel is 76 m by 38 m. The base has 2^40 bytes. */
#define PLANET_EDGE 524288u

/* Unit vector towards the sun, in world space. Hills in the texture are bright on this side. */
extern const float k_planet_sun[3];

/* Makes the texture: u from west to east, v from the north pole down, as on SHD_SHAPE_SPHERE. */
shd_result planet_create_texture(shd_context *context, shd_tile_cache *cache, shd_texture **out);

/* Loads the coarse levels of at most 512 x 512 texels, and keeps them: every lookup then finds some level. */
shd_result planet_pin_coarse_levels(const shd_texture *planet, uint32_t first_level);

#endif
