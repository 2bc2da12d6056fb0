// SPDX-License-Identifier: MIT
// Draws that cannot have a colour. A black picture itself gives no reason.
#pragma once

#include "core/context.h"
#include "frame/frame.h"

namespace shd::abi {

/// Counts draws without a material, and draws whose materials reflect light in a frame that has none. Logs one line for
/// each reason, with SHD_LOG_LEVEL_INFO, because depth alone and silhouettes may be meant.
uint64_t report_black_draws(const core::Context& context, const frame::Frame& frame);

}  // namespace shd::abi
