// SPDX-License-Identifier: MIT
#pragma once

#include "scene/limits.h"
#include "scene/model.h"

namespace shd::scene {

/// Throws Failure unless all indices are in range, all columns have the length of their geometry, all numbers are
/// finite and the budgets are kept. All later steps trust a model that has passed.
void check_model(const Model& model, const Limits& limits);

}  // namespace shd::scene
