// SPDX-License-Identifier: MIT
// The command line of shd-farm.
#ifndef SHD_FARM_OPTIONS_H
#define SHD_FARM_OPTIONS_H

#include <cstdint>
#include <string>

namespace farm {

struct Options {
  uint32_t width = 1024, height = 1024;  // pixels, 1..65536
  uint32_t window = 256;                 // edge length of windows and of the tiles of the file, 16..4096
  uint32_t samples = 4;                  // per pixel
  uint32_t supersampling = 1;            // n x n pixels are averaged, 1..16
  uint32_t frames = 1;                   // the camera turns once around the scene
  int64_t frame = -1;                    // the only frame to render; -1 = all
  uint32_t threads = 1;                  // number of each rank
  uint32_t copies = 3;                   // the model stands in copies x copies places
  uint32_t single = 0;                   // rows of a band of the single process; 0 = windows on all ranks
  float azimuth = 35.0f, elevation = 30.0f;
  double timeout = 60.0;            // [s] without a message of a rank
  bool through_root = false;        // windows travel to rank 0, which alone writes
  bool reserve = true;              // allocate the space of a file when it is begun
  bool fresh = false;               // ignore and remove earlier work
  std::string model;                // "" = built-in scene
  std::string output = "farm.exr";  // with several frames farm.0000.exr, farm.0001.exr, ...
  std::string times;                // CSV of the seconds of each window; "" = none
};

/// Throws Failure that names the option, its value and its range. False after --help.
bool read_options(int argc, char** argv, Options* options);

/// Name of the file of a frame.
std::string frame_path(const Options& options, uint32_t frame);

}  // namespace farm

#endif  // SHD_FARM_OPTIONS_H
