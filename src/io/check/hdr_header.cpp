// SPDX-License-Identifier: MIT
#include "io/check/hdr_header.h"

#include <algorithm>
#include <string>

#include "core/failure.h"

namespace shd::io {

namespace {

constexpr size_t kMaxHeader = 1 << 16;

}  // namespace

Turn read_hdr_header(const unsigned char* bytes, size_t size) {
  const std::string text(reinterpret_cast<const char*>(bytes), std::min(size, kMaxHeader));
  const size_t blank = text.find("\n\n");
  if (text.substr(0, blank).find("\nFORMAT=32-bit_rle_xyze") != std::string::npos) {
    core::refuse(SHD_ERROR_UNSUPPORTED, "Radiance HDR: the pixels are XYZE, not RGBE");
  }
  Turn turn;
  if (blank == std::string::npos) return turn;
  const std::string line = text.substr(blank + 2, text.find('\n', blank + 2) - blank - 2);
  const size_t second = line.find_first_of("+-", 1);
  if (line.size() < 2 || second == std::string::npos || second + 1 >= line.size()) return turn;
  turn.columns = line[1] == 'X';
  const char x = turn.columns ? line[0] : line[second], y = turn.columns ? line[second] : line[0];
  turn.mirror_x = x == '-';
  turn.mirror_y = y == '+';
  return turn;
}

}  // namespace shd::io
