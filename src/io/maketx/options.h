// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <shd/mip.h>

enum class Encoding { kFile, kSrgb, kLinear };

/// Meaning of the coordinates of the output.
enum class Content { kPlain, kLatLong, kProbe };  // kProbe: an angular probe that becomes lat-long

/// A property of the output.
struct Attribute {
  std::string name, value;
};

/// The command line of shd-maketx, checked.
struct Options {
  std::vector<std::string> inputs;  // arguments of the command line
  std::string input, output;        // names of one file and its output
  std::string format;               // "" = of the input, else uint8, uint16, half or float
  std::string compression = "zip";
  std::string wrap_s = "black", wrap_t = "black";
  bool has_wrap = false;  // the command line names wraps
  Content content = Content::kPlain;
  shd_mip_kernel kernel = SHD_MIP_KERNEL_BOX;
  std::vector<Attribute> attributes;
  std::string color_from, color_to;  // empty = no conversion
  bool update = false, check_nan = false;
  Encoding encoding = Encoding::kFile;
  bool normal = false;
  int channels = 0;  // 0 = those of the file
  int tile = 64;
  uint64_t memory = uint64_t{512} << 20;  // [bytes]
  int threads = 0;                        // 0 = one per core
  double checkpoint = 5;                  // [s]
  double time_limit = 0;                  // seconds of a file; 0 = none
  double stall_limit = 60;                // seconds between two pieces of the decoder
  bool force = false, quiet = false;
};

/// Reads the command line. Returns false after it has printed a page such as --help. Throws Failure
/// (kExitUsage) that names the option and its valid values.
bool read_options(int argc, const char* const* argv, Options& out);
