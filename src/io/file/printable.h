// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace shd::io {

/// Makes `text` safe for a message: UTF-8 is kept, control and invalid bytes become '?', the middle of a long text is
/// left out.
std::string printable(const std::string& text);

}  // namespace shd::io
