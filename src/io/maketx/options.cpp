// SPDX-License-Identifier: MIT
#include "io/maketx/options.h"

#include <algorithm>

#include "command/values.h"

using namespace command;

namespace {

constexpr const char* kDescription =
    R"(Converts an image of any size to a tiled file with all mip levels, for lookups that load tiles. Reads INPUT,
any image that OpenImageIO reads, in bands of rows, and writes a tiled TIFF (.tx, .tif, .tiff) or OpenEXR file
(.exr, half and float) with all mip levels down to 1 x 1. The levels are exact averages of the input in linear
light, for any size. They have the bits of the mip levels that libshd builds in memory. The image may be
larger than memory, up to 1048576 pixels a side.

INPUT may be untrusted. A process of its own decodes it, with limited memory, without new privileges and
without writing files, but with the rights of the user. If that process dies or stops, the run ends with
status 3.

Three channels stay three; shd_texture_open(3) reads them as four. Numbers of level 0 are those of the input:
alpha is neither multiplied into the colour nor divided out of it, and a tag of the output says what it is.
OpenEXR stores half and float only, and only colour that is multiplied by alpha.

The output works in OpenImageIO's TextureSystem, too. It appears under its name when it is complete.)";

const std::vector<Section> kSections = {
    {"Files",
     "OUTPUT.part is a folder with the mip levels that an unfinished run has made. They take a third of the size "
     "of the uncompressed image. The same command continues with them, reads and compresses level 0 again, and "
     "gives the same file, byte for byte. Damaged ones are found by checksums, and the run begins anew. The folder "
     "must belong to the user and be writable for no other."},
    {"Exit status",
     "0 done, 1 failed, 2 wrong options, 3 the input cannot be read or converted, 4 the output cannot be "
     "written."},
    {"Examples", "  shd-maketx --memory 256M earth.tif -o earth.tx"},
    {"See also", "shd-render(1), shd-check(1), maketx(1)"}};

const std::vector<std::string> kOfTiff = {"zip", "none", "lzw", "packbits"},
                               kOfExr = {"zip", "none", "rle", "zips", "piz"};

/// A number with K, M or G behind it, or of MB.
Values memory_values(uint64_t& out) {
  const auto read = [&out](const std::string& text) {
    const size_t units = text.empty() ? std::string::npos : std::string("KMG").find(text.back());
    const bool named = units != std::string::npos;
    uint64_t count = 0;
    if (!number(count, 1, 1 << 30).read(text.substr(0, text.size() - (named ? 1 : 0)))) return false;
    out = count << (named ? 10 * (units + 1) : 20);
    return out >= uint64_t{1} << 20 && out <= uint64_t{1} << 40;
  };
  return {"a size from 1M to 1024G", {}, "512M", read};
}

Values tile_values(int& out) {
  const auto read = [&out](const std::string& text) { return number(out, 16, 4096).read(text) && out % 16 == 0; };
  return {"a multiple of 16 from 16 to 4096", {}, "64", read};
}

Values encoding_values(Encoding& out, Encoding wanted) {
  const auto read = [&out, wanted](const std::string&) {
    refuse_if(out != Encoding::kFile && out != wanted, "--srgb and --linear exclude each other");
    return out = wanted, true;
  };
  return {"", {}, "", read};
}

Group image_options(Options& out) {
  std::vector<std::string> compressions = kOfTiff;
  compressions.insert(compressions.end(), kOfExr.begin() + 2, kOfExr.end());
  return {
      "Image",
      {{"-o,--output", "FILE", file(out.output), "Where the file appears, whole or not at all."},
       {"--tile", "N", tile_values(out.tile), "Width and height of tiles."},
       {"--format", "F", initially(one_of(out.format, {"uint8", "uint16", "half", "float"}), "that of the input"),
        "Format of the numbers."},
       {"--srgb", "", encoding_values(out.encoding, Encoding::kSrgb),
        "8-bit numbers are sRGB. Other numbers must be linear. Default: what the input declares, sRGB if it declares "
        "nothing."},
       {"--linear", "", encoding_values(out.encoding, Encoding::kLinear), "8-bit numbers are linear."},
       {"--normal", "", flag(out.normal),
        "The image has unit vectors in three or four channels. Levels are renormalised, and a fourth channel gets the "
        "length of the mean."},
       {"--channels", "N", initially(number(out.channels, 1, 4), "all"), "Take the first N channels."},
       {"--wrap", "W", one_of(out.wrap, {"black", "clamp", "periodic", "mirror"}), "Tag for other programs."},
       {"--compression", "C", one_of(out.compression, compressions),
        "TIFF has " + join(kOfTiff, " and ") + ", OpenEXR " + join(kOfExr, " and ") + "."}}};
}

Group run_options(Options& out) {
  const std::string seconds = " seconds";
  return {
      "Run",
      {{"--memory", "SIZE", memory_values(out.memory),
        "Most memory for rows and sums, in MB or with K, M or G. A decoder that must hold a whole image, as for "
        "interlaced PNG, takes more: at most about 1 GB, eight times this size and three times the size of INPUT."},
       {"--threads", "N", initially(number(out.threads, 0, 1024), "one for each core"),
        "Threads. The file does not depend on them."},
       {"--checkpoint", "S", number(out.checkpoint, 0, 1e6, seconds),
        "Time between places from which an interrupted run continues."},
       {"--stall-limit", "S", number(out.stall_limit, 0.1, 1e6, seconds), "Most time without a row from the decoder."},
       {"--time-limit", "S", initially(number(out.time_limit, 0.1, 1e6, seconds), "none"),
        "Most time of the run, which ends with status 1 and can be continued."},
       {"--force", "", flag(out.force),
        "Replace an existing OUTPUT, and begin anew beside an unfinished run of other options."},
       {"--quiet", "", flag(out.quiet), "No progress."}}};
}

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

void check_together(const Options& options) {
  refuse_if(options.input.empty(), "no INPUT");
  refuse_if(options.output.empty(), "no OUTPUT: give it with -o");
  const bool exr = ends_with(options.output, ".exr");
  if (!exr && !ends_with(options.output, ".tx") && !ends_with(options.output, ".tif") &&
      !ends_with(options.output, ".tiff")) {
    ::refuse("--output", options.output, "a name that ends in .tx, .tif, .tiff or .exr");
  }
  const std::vector<std::string>& known = exr ? kOfExr : kOfTiff;
  if (std::find(known.begin(), known.end(), options.compression) == known.end()) {
    ::refuse(exr ? "--compression of .exr" : "--compression of TIFF", options.compression, "one of " + join(known));
  }
  if (exr && options.format.rfind("uint", 0) == 0) ::refuse("--format of .exr", options.format, "half or float");
  refuse_if(options.normal && options.encoding == Encoding::kSrgb, "--normal: vectors are numbers, not --srgb");
}

}  // namespace

bool read_options(int argc, const char* const* argv, Options& out) {
  const Program program = {"shd-maketx",
                           "convert an image of any size to a tiled file with mip levels",
                           "[options] INPUT -o OUTPUT",
                           kDescription,
                           {image_options(out), run_options(out)},
                           kSections};
  std::vector<std::string> files;
  if (!parse(program, argc, argv, files)) return false;
  if (files.size() > 1) throw Failure(kExitUsage, "two inputs: \"" + files[0] + "\" and \"" + files[1] + "\"");
  if (!files.empty()) out.input = files[0];
  check_together(out);
  return true;
}
