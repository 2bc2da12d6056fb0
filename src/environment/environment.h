// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: environment, (image of the radiance of all directions -> tables for lighting).
///
/// Input:      an image with a projection.
/// Output:     an Environment: irradiance, and the mean radiance over lobes, by direction.
/// Units:      radiance and irradiance in the unit of the image; directions in the space of the image, +Y up.
/// Invariants: an Environment is immutable. A texel of radiance L and solid angle w counts as a directional light of
///             irradiance L w. Bits depend on neither workers nor SIMD targets. Radiance is finite and not negative.
///
/// | file           | contents                                                                      |
/// |----------------|-------------------------------------------------------------------------------|
/// | harmonics-inl.h | the spherical harmonics of the orders 0 to 2                                 |
/// | source.h       | kernel: texels as floats, and their integrals with spherical harmonics        |
/// | map.h          | square maps of directions, and chains of maps for all lobes                   |
/// | radiance.h     | maps of an image                                                              |
/// | cells.h        | quadtree of the light of an image                                             |
/// | convolve.h     | kernel: maps of the mean radiance over a lobe                                 |
/// | lobe_table.h   | reflection of uniform light by the lobes of the models                        |
/// | look_up-inl.h  | irradiance and radiance at points                                             |
/// | look_up.h      | kernels: batches of look_up-inl.h                                             |
#pragma once

#include <shd/environment.h>

#include "core/context.h"
#include "environment/map.h"

namespace shd::environment {

constexpr int kHarmonics = 9;  // real spherical harmonics of the orders 0 to 2 (harmonics-inl.h)

struct Environment {
  shd_projection projection;        // projection of the image
  core::Array<PackedTexel> texels;  // all maps, one after another
  Chain radiance;                   // levels of the image alone: Chain::lobes is 0
  Chain ggx, phong;                 // count 0 = absent
  Level irradiance;                 // size 0 = harmonics
  float harmonics[3][kHarmonics];   // [channel] factors of the harmonics
  float mean[3];                    // mean radiance
  uint64_t replaced;                // channels of the image that were replaced
};

/// Builds the tables of a checked desc. Throws Failure and std::bad_alloc.
void build(const core::Context& context, const shd_environment_desc& desc, Environment* out);

}  // namespace shd::environment
