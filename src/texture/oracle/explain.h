// SPDX-License-Identifier: MIT
#pragma once

#include <shd/explain.h>

#include "core/context.h"
#include "texture/texture.h"

namespace shd::texture {

/// Returns whether a filter is a tree of blends, which explain() can show.
bool is_explainable(shd_filter filter);

/// Explains the single lookup in `lookups` with a filter that is_explainable(). Fills the output fields of
/// shd_explanation.
void explain(const core::Context& context, const Texture& texture, const Sampler& sampler, const Lookups& lookups,
             shd_explanation* out);

}  // namespace shd::texture
