// SPDX-License-Identifier: MIT
/// @file
/// Contract of oracle/: answers about lookups. explain.cpp lists the texels and weights of one lookup, as its kernels
/// blended them. bounds/ computes what conforming implementations may return, without the kernels, in doubles.
#pragma once

#include <shd/explain.h>

#include "core/context.h"
#include "texture/texture.h"

namespace shd::texture {

/// Explains the single lookup in `lookups` with a filter that has explanations (support.h). Fills the output fields of
/// shd_explanation.
void explain(const core::Context& context, const Texture& texture, const Sampler& sampler, const Lookups& lookups,
             shd_explanation* out);

}  // namespace shd::texture
