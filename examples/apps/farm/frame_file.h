// SPDX-License-Identifier: MIT
// A picture on disk while it is rendered, as rank 0 keeps it: NAME.part has the tiles at their final places, and
// NAME.journal the checksum of each window that is durable. The finished part is renamed to NAME.
#ifndef SHD_FARM_FRAME_FILE_H
#define SHD_FARM_FRAME_FILE_H

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "exr_layout.h"
#include "options.h"
#include "part_file.h"

namespace farm {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin);

/// A hash of the scene and of the options that change the bits of a picture.
std::string make_identity(const Options& options, uint64_t scene_sum, uint32_t frame);

struct FrameFile {
  uint32_t frame = 0;
  std::string path;
  Layout layout;
  File part, journal;
  std::vector<uint64_t> sums;      // [windows]
  std::vector<uint8_t> journaled;  // [windows] `sums` comes from the journal of an earlier job
  std::vector<uint8_t> done;       // [windows]
  uint32_t done_count = 0;
  uint32_t kept_count = 0;  // windows of the journal
  Clock::time_point last_sync = Clock::now();
  bool complete = false;  // the file was finished by an earlier job
};

std::string part_path(const std::string& path);
std::string journal_path(const std::string& path);

/// Begins or resumes a picture. Throws Failure if the files belong to another picture.
FrameFile open_frame(const Options& options, uint64_t scene_sum, uint32_t frame);

/// Keeps a window whose tile is durable in the part.
void record_window(FrameFile* file, uint32_t window, uint64_t sum, bool unchanged);

/// Flushes the file and gives it its name.
void finish_frame(FrameFile* file);

/// Checksum of all windows: equal for equal pictures.
uint64_t picture_sum(const FrameFile& file);

}  // namespace farm

#endif  // SHD_FARM_FRAME_FILE_H
