// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace shd::io {

/// `text` fit for a message: UTF-8 stays, control and stray bytes become '?', the middle of a long text is cut out.
std::string printable(const std::string& text);

}  // namespace shd::io
