// SPDX-License-Identifier: MIT
#pragma once

#include "core/context.h"
#include "occlusion/occlusion.h"

namespace shd::occlusion {

/// Sets the values of points by rays of the tracer, on the context's executor. Throws Failure and std::bad_alloc.
void trace(const core::Context& context, const Options& options, const Points& points);

}  // namespace shd::occlusion
