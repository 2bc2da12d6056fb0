// SPDX-License-Identifier: MIT
// The messages of ranks: one struct of constant size, and the tiles of --through-root. All machines of a job
// have the same architecture.
#ifndef SHD_FARM_MESSAGES_H
#define SHD_FARM_MESSAGES_H

#include <cstdint>

namespace farm {

enum class Kind : uint32_t {
  // to rank 0
  kHello,     // the stage is made
  kRendered,  // a window is rendered, there is room for another one
  kFinished,  // a window is durable; with --through-root its tile follows
  kFailed,    // `text`
  kPong,
  kStatistics,
  // from rank 0
  kJob,
  kPing,
  kStop,
};

constexpr int kTagMessage = 1, kTagTile = 2;

struct Statistics {
  uint64_t windows, checked, peak_kib;
  double render, wait, write;  // [s]
};

struct Message {
  Kind kind;
  uint32_t frame, window;
  uint32_t check;      // job: the tile may be there, with this sum
  uint32_t unchanged;  // finished: the tile was there
  uint32_t rank;
  uint64_t sum;
  uint64_t tile_bytes;
  double render, write;  // [s]
  Statistics statistics;
  char text[256];
};

}  // namespace farm

#endif  // SHD_FARM_MESSAGES_H
