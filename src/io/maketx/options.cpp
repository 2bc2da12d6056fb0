// SPDX-License-Identifier: MIT
#include "io/maketx/options.h"

#include <algorithm>

#include "command/names.h"
#include "io/maketx/jobs.h"

using namespace command;

namespace {

constexpr const char* kDescription =
    R"(Converts an image of any size to a tiled file with all mip levels, for lookups that load tiles. Reads INPUT,
any image that OpenImageIO reads, twice, in bands of rows, and writes a tiled TIFF (.tx, .tif, .tiff) or OpenEXR file
(.exr, half and float) with all mip levels down to 1 x 1. The levels are exact averages of the input in linear
light, for any size. They have the bits of the mip levels that libshd builds in memory. The image may be
larger than memory, up to 1048576 pixels a side.

INPUT may be untrusted. A process of its own decodes it, with limited memory, without new privileges and
without writing files, but with the rights of the user. If that process dies or stops, the run ends with
status 3.

Three channels stay three; shd_texture_open(3) reads them as four. Numbers of level 0 are those of the input:
alpha is neither multiplied into the colour nor divided out of it, and a tag of the output says what it is.
OpenEXR stores half and float only, and only colour that is multiplied by alpha.

Several INPUTs, and a name with <UDIM> in place of the numbers of a set, give a file each. Then OUTPUT is a
folder, which ends in / or exists, or has <UDIM>, too.

The output works in OpenImageIO's TextureSystem, too, and has the properties that maketx gives its files: format
and wrap modes, oiio:AverageColor and oiio:SHA-1. It appears under its name when it is complete.)";

const std::vector<Section> kSections = {
    {"Files",
     "OUTPUT.part is a folder with the mip levels that an unfinished run has made. They take a third of the size "
     "of the uncompressed image. The same command continues with them, reads and compresses level 0 again, and "
     "gives the same file, byte for byte. Damaged ones are found by checksums, and the run begins anew. The folder "
     "must belong to the user and be writable for no other."},
    {"Exit status",
     "0 done, 1 failed, 2 wrong options, 3 the input cannot be read or converted, 4 the output cannot be "
     "written. Several files are all tried; the status is that of the first failure."},
    {"Environment", "OCIO names the colour config of --colorconvert, instead of the one that libshd_color has."},
    {"Examples",
     "  shd-maketx --memory 256M earth.tif -o earth.tx\n"
     "  shd-maketx -u 'skin.<UDIM>.exr' -o textures/\n"
     "  shd-maketx --envlatl --filter lanczos sky.hdr -o sky.tx"},
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

Values wrap_values(std::string& s, std::string& t) {
  Values values = one_of(s, {"black", "clamp", "periodic", "mirror"});
  values.read = [read = values.read, &s, &t](const std::string& text) {
    if (!read(text)) return false;
    return t = s, true;
  };
  return values;
}

Values content_values(Content& out, Content wanted) {
  const auto read = [&out, wanted](const std::string&) {
    refuse_if(out != Content::kPlain && out != wanted, "--envlatl and --lightprobe exclude each other");
    return out = wanted, true;
  };
  return {"", {}, "", read};
}

/// Two names, with a line end between them.
Values color_values(Options& out) {
  const auto read = [&out](const std::string& text) {
    const size_t end = text.find('\n');
    if (end == std::string::npos) return false;
    out.color_from = text.substr(0, end);
    out.color_to = text.substr(end + 1);
    return !out.color_from.empty() && !out.color_to.empty();
  };
  return {"two colour spaces", {}, "", read, true};
}

/// Properties that other options set, or that depend on the pixels.
bool is_own(const std::string& name) {
  static const char* const kOwn[] = {"compression", "wrapmodes", "textureformat", "planarconfig", "fovcot"};
  for (const char* const prefix : {"oiio:", "tiff:", "openexr:", "shd:"}) {
    if (name.rfind(prefix, 0) == 0) return true;
  }
  return std::find(std::begin(kOwn), std::end(kOwn), name) != std::end(kOwn);
}

Values attribute_values(std::vector<Attribute>& out) {
  const auto read = [&out](const std::string& text) {
    const size_t end = text.find('=');
    if (end == std::string::npos || end == 0) return false;
    out.push_back({text.substr(0, end), text.substr(end + 1)});
    refuse_if(is_own(out.back().name), "--attrib: \"" + out.back().name + "\" is set by shd-maketx");
    return true;
  };
  return {"NAME=VALUE", {}, "", read, true};
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
      {{"-o,--output", "FILE", file(out.output), "Where the file appears, whole or not at all; or a folder."},
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
       {"--wrap", "W", marked(wrap_values(out.wrap_s, out.wrap_t), out.has_wrap),
        "What is beyond the edges, for other programs and for filters that are wider than the box."},
       {"--swrap", "W", marked(wrap_values(out.wrap_s, out.wrap_s), out.has_wrap), "Wrap along u."},
       {"--twrap", "W", marked(wrap_values(out.wrap_t, out.wrap_t), out.has_wrap), "Wrap along v."},
       {"--filter", "F", named(out.kernel, names_of(shd_mip_kernel_name)),
        "Filter of the levels. All but the box hold the image in memory."},
       {"--envlatl", "", content_values(out.content, Content::kLatLong),
        "The image has all directions, in latitude and longitude. Its wraps are periodic along u and clamp along v: no "
        "--wrap, --swrap and --twrap. TIFF only, because texels of environments in OpenEXR lie on the borders."},
       {"--lightprobe", "", content_values(out.content, Content::kProbe),
        "The image is an angular probe, which becomes one for --envlatl, in memory: as wide, and half as high."},
       {"--colorconvert", "FROM TO", color_values(out),
        "Convert colours, by the config of OCIO or the built-in one, whose sRGB images are \"sRGB - Texture\" and "
        "whose "
        "linear spaces are \"Linear Rec.709\", ACEScg and ACES2065-1. Without --format, integers become half.",
        2},
       {"--checknan", "", flag(out.check_nan), "Refuse an image with a number that is NaN or infinite."},
       {"--attrib", "NAME=VALUE", attribute_values(out.attributes),
        "Property of the output: a whole number, a number, or else a text. May be given several times."},
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
        "Most time of each file, whose run ends with status 1 and can be continued."},
       {"-u,--update", "", flag(out.update),
        "Make OUTPUT only if it is absent, or the input or the options have changed since it was made."},
       {"--force", "", flag(out.force),
        "Replace an existing OUTPUT, and begin anew beside an unfinished run of other options."},
       {"--quiet", "", flag(out.quiet), "No progress."}}};
}

void check_file(const Options& options, const std::string& output) {
  const bool exr = ends_with(output, ".exr");
  if (!exr && !ends_with(output, ".tx") && !ends_with(output, ".tif") && !ends_with(output, ".tiff")) {
    ::refuse("--output", output, "a name that ends in .tx, .tif, .tiff or .exr");
  }
  const std::vector<std::string>& known = exr ? kOfExr : kOfTiff;
  if (std::find(known.begin(), known.end(), options.compression) == known.end()) {
    ::refuse(exr ? "--compression of .exr" : "--compression of TIFF", options.compression, "one of " + join(known));
  }
  if (exr && options.format.rfind("uint", 0) == 0) ::refuse("--format of .exr", options.format, "half or float");
  refuse_if(exr && options.content != Content::kPlain,
            "--envlatl: texels of environments in OpenEXR lie on the borders: write .tx");
}

void check_together(const Options& options) {
  refuse_if(options.inputs.empty(), "no INPUT");
  refuse_if(options.output.empty(), "no OUTPUT: give it with -o");
  refuse_if(options.has_wrap && options.content != Content::kPlain,
            "--envlatl and --lightprobe set the wraps: no --wrap, --swrap and --twrap");
  refuse_if(options.normal && options.content != Content::kPlain, "--normal: vectors are no light of an environment");
  refuse_if(options.normal && !options.color_from.empty(), "--normal: vectors are no colours for --colorconvert");
  refuse_if(options.normal && options.encoding == Encoding::kSrgb, "--normal: vectors are numbers, not --srgb");
  refuse_if(!options.color_from.empty() && options.encoding != Encoding::kFile,
            "--colorconvert names the colour space: no --srgb and no --linear");
  if (is_folder(options.output)) return check_file(options, options.output + "/x.tx");
  check_file(options, options.output);
}

}  // namespace

bool read_options(int argc, const char* const* argv, Options& out) {
  const Program program = {"shd-maketx",
                           "convert an image of any size to a tiled file with mip levels",
                           "[options] INPUT... -o OUTPUT",
                           kDescription,
                           {image_options(out), run_options(out)},
                           kSections};
  if (!parse(program, argc, argv, out.inputs)) return false;
  if (out.content != Content::kPlain) out.wrap_s = "periodic", out.wrap_t = "clamp";
  check_together(out);
  return true;
}
