// SPDX-License-Identifier: MIT
#include "io/maketx/target.h"

#include <OpenImageIO/filesystem.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <utility>

#include "command/failure.h"
#include "command/values.h"
#include "io/file/printable.h"
#include "texture/store/storage.h"

namespace {

using shd::texture::level_size;

/// Time of the last change of the input, so that equal inputs give equal files.
std::string date_of(const Image& image) {
  const auto seconds = static_cast<std::time_t>(image.changed / 1000000000);
  std::tm parts = {};
  char text[32] = "";
  if (::gmtime_r(&seconds, &parts)) std::strftime(text, sizeof text, "%Y:%m:%d %H:%M:%S", &parts);
  return text;
}

void set_attribute(const Attribute& attribute, OIIO::ImageSpec& spec) {
  int whole = 0;
  float number = 0;
  if (command::read_number(attribute.value, whole)) {
    spec.attribute(attribute.name, whole);
  } else if (command::read_number(attribute.value, number)) {
    spec.attribute(attribute.name, number);
  } else {
    spec.attribute(attribute.name, attribute.value);
  }
}

OIIO::ImageSpec make_spec(const Options& options, const Image& image) {
  OIIO::ImageSpec spec(static_cast<int>(image.width), static_cast<int>(image.height), static_cast<int>(image.channels),
                       image.type);
  spec.channelnames = image.names;
  spec.alpha_channel = image.alpha;
  spec.tile_width = spec.tile_height = options.tile;
  spec.attribute("compression", options.compression);
  spec.attribute("planarconfig", "contig");
  spec.attribute("textureformat", options.content == Content::kPlain ? "Plain Texture" : "LatLong Environment");
  spec.attribute("wrapmodes", options.wrap_s + "," + options.wrap_t);
  spec.attribute("fovcot", static_cast<float>(image.width) / static_cast<float>(image.height));
  spec.attribute("oiio:ColorSpace", image.color_space);
  spec.attribute("DateTime", date_of(image));
  // OpenImageIO uses the hash and the colours of files alone whose Software begins with "OpenImageIO" or "maketx".
  spec.attribute("Software", "maketx (shd-maketx)");
  if (image.straight) spec.attribute("oiio:UnassociatedAlpha", 1);
  spec.attribute("tiff:half", 1);
  // Decided by the size of the numbers, because the size of compressed tiles is not known.
  const double bytes = static_cast<double>(image.row_size()) * image.height * 4 / 3;
  spec.attribute("tiff:bigtiff", bytes > 3.9e9 ? 1 : 0);
  spec.attribute("openexr:levelmode", 1);     // mip levels
  spec.attribute("openexr:roundingmode", 0);  // sizes are rounded down
  for (const Attribute& attribute : options.attributes) set_attribute(attribute, spec);
  return spec;
}

}  // namespace

Target::Target(const Options& options, const Image& image)
    : name_(options.output),
      spec_(make_spec(options, image)),
      type_(image.type),
      width_(image.width),
      height_(image.height),
      levels_(shd::texture::full_level_count(image.width, image.height)) {
  exr_ = command::ends_with(name_, ".exr");
  if (exr_ && image.straight) {
    throw Failure(kExitInput, "\"" + shd::io::printable(options.input) +
                                  "\": colour is not multiplied by alpha, as OpenEXR requires: write .tx");
  }
  if (exr_ && type_ != OIIO::TypeHalf && type_ != OIIO::TypeFloat) {
    throw Failure(kExitUsage,
                  std::string("OpenEXR stores no ") + type_.c_str() + ": write .tx, or choose --format half");
  }
  output_ = OIIO::ImageOutput::create(exr_ ? "openexr" : "tiff");
  if (!output_) refuse("cannot create", OIIO::geterror());
  if (!options.attributes.empty()) check_attributes(options);
}

/// Writes one tile into memory, and refuses properties that are not in it.
void Target::check_attributes(const Options& options) const {
  OIIO::ImageSpec spec = spec_;
  spec.width = spec.full_width = spec.height = spec.full_height = spec.tile_width = spec.tile_height = 16;
  spec.erase_attribute("openexr:levelmode");
  spec.erase_attribute("oiio:ColorSpace");  // OpenImageIO 2.4 spoils TIFF files in memory by it
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput out(bytes);
  const auto output = OIIO::ImageOutput::create(exr_ ? "openexr" : "tiff");
  const std::vector<uint8_t> tile(256 * spec.pixel_bytes());
  output->set_ioproxy(&out);
  if (!output->open(exr_ ? "x.exr" : "x.tif", spec) || !output->write_tile(0, 0, 0, type_, tile.data()) ||
      !output->close()) {
    refuse("cannot store the properties of --attrib", output->geterror());
  }
  OIIO::Filesystem::IOMemReader in(bytes.data(), bytes.size());
  const auto input = OIIO::ImageInput::open(exr_ ? "x.exr" : "x.tif", nullptr, &in);
  if (!input) refuse("cannot store the properties of --attrib", OIIO::geterror());
  for (const Attribute& attribute : options.attributes) {
    if (input->spec().find_attribute(attribute.name)) continue;
    throw Failure(kExitUsage, "--attrib: " + std::string(exr_ ? "OpenEXR" : "TIFF") +
                                  " files of OpenImageIO have no \"" + shd::io::printable(attribute.name) + "\"" +
                                  (exr_ ? "" : ": write .exr"));
  }
}

void Target::mark(const Marks& marks) {
  const std::pair<const char*, const std::string&> texts[] = {{"oiio:SHA-1", marks.hash},
                                                              {"oiio:ConstantColor", marks.constant},
                                                              {"oiio:AverageColor", marks.average},
                                                              {kKeyAttribute, marks.key}};
  std::string description = spec_.get_string_attribute("ImageDescription");
  for (const auto& [name, text] : texts) {
    if (text.empty()) continue;
    if (exr_) {
      spec_.attribute(name, text);
    } else {
      description += (description.empty() ? "" : " ") + std::string(name) + "=" + text;  // TIFF has no other place
    }
  }
  if (!exr_) spec_.attribute("ImageDescription", description);
}

void Target::refuse(const std::string& action, const std::string& reason) const {
  const std::string why = reason.empty() ? std::strerror(errno) : reason;
  throw Failure(kExitOutput, "\"" + shd::io::printable(name_) + "\": " + action + ": " + shd::io::printable(why));
}

void Target::open(shd::io::FileDescriptor file) {
  file_ = std::move(file);
  path_ = "/proc/self/fd/" + std::to_string(file_.fd);
}

void Target::begin_level(uint32_t level) {
  level_ = level;
  OIIO::ImageSpec spec = spec_;
  spec.width = spec.full_width = static_cast<int>(level_size(width_, level));
  spec.height = spec.full_height = static_cast<int>(level_size(height_, level));
  const auto append =
      output_->supports("mipmap") ? OIIO::ImageOutput::AppendMIPLevel : OIIO::ImageOutput::AppendSubimage;
  errno = 0;
  if (!output_->open(path_, spec, level == 0 ? OIIO::ImageOutput::Create : append)) {
    refuse("cannot begin mip level " + std::to_string(level), output_->geterror());
  }
}

/// Writes a tile of TIFF, whole: zeros behind the right and lower edge, where OpenImageIO would store undefined bytes.
/// Tiles are written one by one, because write_tiles() compresses them in another way if it has many and threads.
bool Target::write_tile(uint32_t x, uint32_t y, uint32_t width, uint32_t height, const uint8_t* texels, size_t stride) {
  const auto side = static_cast<size_t>(spec_.tile_width);
  const size_t pixel = spec_.pixel_bytes();
  tile_.assign(side * side * pixel, 0);
  for (uint32_t row = 0; row < height; ++row) {
    std::memcpy(tile_.data() + row * side * pixel, texels + row * stride, width * pixel);
  }
  return output_->write_tile(static_cast<int>(x), static_cast<int>(y), 0, type_, tile_.data());
}

bool Target::write_tiles(uint32_t y, uint32_t count, const uint8_t* rows) {
  const uint32_t width = level_size(width_, level_), side = static_cast<uint32_t>(spec_.tile_width);
  if (exr_) {
    return output_->write_tiles(0, static_cast<int>(width), static_cast<int>(y), static_cast<int>(y + count), 0, 1,
                                type_, rows);
  }
  const size_t pixel = spec_.pixel_bytes(), stride = width * pixel;
  for (uint32_t row = 0; row < count; row += side) {
    for (uint32_t x = 0; x < width; x += side) {
      if (!write_tile(x, y + row, std::min(side, width - x), std::min(side, count - row),
                      rows + row * stride + x * pixel, stride)) {
        return false;
      }
    }
  }
  return true;
}

void Target::write(uint32_t y, uint32_t count, const uint8_t* rows) {
  errno = 0;
  if (!write_tiles(y, count, rows)) {
    refuse("cannot write mip level " + std::to_string(level_), output_->geterror());
  }
}

void Target::check_level(OIIO::ImageInput& input, uint32_t level) const {
  const int width = static_cast<int>(level_size(width_, level)), height = static_cast<int>(level_size(height_, level));
  const OIIO::ImageSpec spec = input.spec(0, static_cast<int>(level));
  if (spec.width != width || spec.height != height || spec.format != type_) {
    refuse("mip level " + std::to_string(level) + " cannot be read back", input.geterror());
  }
  const int tile = spec_.tile_width, x = (width - 1) / tile * tile, y = (height - 1) / tile * tile;
  std::vector<uint8_t> texels(static_cast<size_t>(tile) * static_cast<size_t>(tile) * spec.pixel_bytes());
  if (!input.read_tiles(0, static_cast<int>(level), x, width, y, height, 0, 1, 0, spec.nchannels, type_,
                        texels.data())) {
    refuse("the last tile of mip level " + std::to_string(level) + " cannot be read back", input.geterror());
  }
}

void Target::finish() {
  errno = 0;
  if (!output_->close()) refuse("cannot complete", output_->geterror());
  output_.reset();
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  const auto input = OIIO::ImageInput::open(path_, &config);
  if (!input) refuse("cannot be read back", OIIO::geterror());
  for (uint32_t level = 0; level < levels_; ++level) check_level(*input, level);
  if (::fsync(file_.fd) != 0) refuse("cannot flush", "");
}
