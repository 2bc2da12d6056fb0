// SPDX-License-Identifier: MIT
// Lines of the host's log about draws that cannot have a colour. A black picture itself gives no reason.
#pragma once

#include "core/context.h"
#include "frame/frame.h"

namespace shd::abi {

/// Logs draws without a material, and draws whose materials reflect light in a frame that has none. One line each, with
/// SHD_LOG_LEVEL_INFO, because depth alone and silhouettes may be meant.
void log_black_draws(const core::Context& context, const frame::Frame& frame);

}  // namespace shd::abi
