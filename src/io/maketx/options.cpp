// SPDX-License-Identifier: MIT
#include "io/maketx/options.h"

#include <charconv>
#include <cstring>
#include <initializer_list>

#include "command/failure.h"

const char* const kHelp =
    R"(Usage: shd-maketx [options] INPUT -o OUTPUT
Converts an image of any size to a tiled file with all mip levels, for lookups that load tiles.

INPUT is any image that OpenImageIO reads, also an untrusted one: a process of its own decodes it.
OUTPUT is .tx, .tif or .tiff (tiled TIFF) or .exr (half and float).
Levels are exact averages of the input in linear light, with the bits of SHD_TABLE_MIPMAP.

  -o, --output FILE    where the file appears, whole or not at all
  --tile N             width and height of tiles, a multiple of 16 from 16 to 4096 (default 64)
  --format F           uint8, uint16, half or float (default: as the input)
  --srgb, --linear     what 8-bit numbers mean (default: what the input says, sRGB if it does not)
  --normal             unit vectors in 3 or 4 channels: levels are renormalised; a fourth channel gets the length
  --channels N         take the first N channels, 1 to 4 (default: all)
  --wrap W             tag for other programs: black, clamp, periodic or mirror (default black)
  --compression C      zip, none, lzw, packbits; .exr: zip, none, rle, zips, piz (default zip)
  --memory SIZE        most memory for rows and sums, in MB or with K, M, G (default 512)
  --threads N          threads (default one per core); the file does not depend on it
  --checkpoint S       seconds between places from which an interrupted run continues (default 5)
  --stall-limit S      most seconds without a row from the decoder of INPUT (default 60)
  --time-limit S       most seconds of the run (default none)
  --force              replace an existing OUTPUT, and begin anew beside an unfinished run of other options
  --quiet              no progress
  --help, --version    this text; the version

An interrupted run leaves the folder OUTPUT.part. The same command continues it and gives the same file, byte for byte.
Exit codes: 0 done, 1 failed, 2 wrong options, 3 INPUT cannot be read or converted, 4 OUTPUT cannot be written.
)";

namespace {

constexpr const char* kSeeHelp = " (shd-maketx --help)";

[[noreturn]] void refuse(const std::string& option, const std::string& text, const std::string& wanted) {
  throw Failure(kExitUsage, option + ": \"" + text + "\" is not " + wanted + kSeeHelp);
}

std::string pick(const std::string& option, const std::string& text, std::initializer_list<const char*> known) {
  std::string wanted = "one of";
  for (const char* const name : known) {
    if (text == name) return text;
    wanted += std::string(" ") + name;
  }
  refuse(option, text, wanted);
}

template <class T>
T number(const std::string& option, const std::string& text, T low, T high, const char* wanted) {
  T value = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  if (read.ec != std::errc() || read.ptr != end || !(value >= low) || value > high) refuse(option, text, wanted);
  return value;
}

uint64_t read_size(const std::string& option, const std::string& text) {
  const char* const wanted = "a size from 1M to 1024G";
  const size_t units = text.empty() ? std::string::npos : std::string("KMG").find(text.back());
  const bool named = units != std::string::npos;
  const auto count =
      number<uint64_t>(option, text.substr(0, text.size() - (named ? 1 : 0)), 1, uint64_t{1} << 30, wanted);
  const uint64_t bytes = count << (named ? 10 * (units + 1) : 20);
  if (bytes < uint64_t{1} << 20 || bytes > uint64_t{1} << 40) refuse(option, text, wanted);
  return bytes;
}

/// Sets an option without a value. Returns whether there is one of this name.
bool set_switch(const std::string& name, Options* out) {
  if (name == "--help" || name == "-h") return out->help = true;
  if (name == "--version") return out->version = true;
  if (name == "--normal") return out->normal = true;
  if (name == "--force") return out->force = true;
  if (name == "--quiet") return out->quiet = true;
  if (name != "--srgb" && name != "--linear") return false;
  const Encoding wanted = name == "--srgb" ? Encoding::kSrgb : Encoding::kLinear;
  if (out->encoding != Encoding::kFile && out->encoding != wanted) {
    throw Failure(kExitUsage, std::string("--srgb and --linear exclude each other") + kSeeHelp);
  }
  out->encoding = wanted;
  return true;
}

bool set_value(const std::string& name, const std::string& text, Options* out) {
  if (name == "-o" || name == "--output") {
    out->output = text;
  } else if (name == "--tile") {
    out->tile = number(name, text, 16, 4096, "a multiple of 16 from 16 to 4096");
    if (out->tile % 16) refuse(name, text, "a multiple of 16 from 16 to 4096");
  } else if (name == "--format") {
    out->format = pick(name, text, {"uint8", "uint16", "half", "float"});
  } else if (name == "--channels") {
    out->channels = number(name, text, 1, 4, "a number from 1 to 4");
  } else if (name == "--wrap") {
    out->wrap = pick(name, text, {"black", "clamp", "periodic", "mirror"});
  } else if (name == "--compression") {
    out->compression = pick(name, text, {"zip", "none", "lzw", "packbits", "rle", "zips", "piz"});
  } else if (name == "--memory") {
    out->memory = read_size(name, text);
  } else if (name == "--threads") {
    out->threads = number(name, text, 0, 1024, "a number from 0 to 1024");
  } else if (name == "--checkpoint") {
    out->checkpoint = number(name, text, 0.0, 1e6, "a number of seconds from 0 to 1000000");
  } else if (name == "--stall-limit" || name == "--time-limit") {
    (name == "--stall-limit" ? out->stall_limit : out->time_limit) =
        number(name, text, 0.1, 1e6, "a number of seconds from 0.1 to 1000000");
  } else {
    return false;
  }
  return true;
}

bool ends_with(const std::string& text, const char* end) {
  const size_t size = std::strlen(end);
  return text.size() > size && text.compare(text.size() - size, size, end) == 0;
}

void check(const Options& options) {
  if (options.input.empty()) throw Failure(kExitUsage, std::string("no INPUT") + kSeeHelp);
  if (options.output.empty()) throw Failure(kExitUsage, std::string("no OUTPUT: give it with -o") + kSeeHelp);
  const bool exr = ends_with(options.output, ".exr");
  if (!exr && !ends_with(options.output, ".tx") && !ends_with(options.output, ".tif") &&
      !ends_with(options.output, ".tiff")) {
    refuse("--output", options.output, "a name that ends in .tx, .tif, .tiff or .exr");
  }
  const std::string& name = options.compression;
  if (exr) (void)pick("--compression of .exr", name, {"zip", "none", "rle", "zips", "piz"});
  if (!exr) (void)pick("--compression of TIFF", name, {"zip", "none", "lzw", "packbits"});
  if (exr && options.format.rfind("uint", 0) == 0) refuse("--format of .exr", options.format, "half or float");
  if (options.normal && options.encoding == Encoding::kSrgb) {
    throw Failure(kExitUsage, std::string("--normal: vectors are numbers, not --srgb") + kSeeHelp);
  }
}

}  // namespace

Options read_options(int argc, const char* const* argv) {
  Options options;
  bool only_files = false;
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    if (!only_files && name == "--") {
      only_files = true;
    } else if (only_files || name.empty() || name[0] != '-') {
      if (name.empty()) throw Failure(kExitUsage, "the name of INPUT is empty");
      if (!options.input.empty()) {
        throw Failure(kExitUsage, "two inputs: \"" + options.input + "\" and \"" + name + "\"" + kSeeHelp);
      }
      options.input = name;
    } else if (!set_switch(name, &options)) {
      if (i + 1 == argc) throw Failure(kExitUsage, name + " needs a value, or is not an option" + kSeeHelp);
      if (!set_value(name, argv[++i], &options)) throw Failure(kExitUsage, name + " is not an option" + kSeeHelp);
    }
  }
  if (!options.help && !options.version) check(options);
  return options;
}
