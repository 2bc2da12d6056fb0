// SPDX-License-Identifier: MIT
#include "tool/maketx/source.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "io/printable.h"
#include "io/transfer.h"
#include "tool/failure.h"

namespace {

using shd::image::Component;

constexpr int kMaxSide = 1 << 20;

struct Storage {
  const char* name;
  OIIO::TypeDesc::BASETYPE type;
  Component component;
};
constexpr Storage kStorages[] = {{"uint8", OIIO::TypeDesc::UINT8, Component::kUnorm8},
                                 {"uint16", OIIO::TypeDesc::UINT16, Component::kUnorm16},
                                 {"half", OIIO::TypeDesc::HALF, Component::kFloat16},
                                 {"float", OIIO::TypeDesc::FLOAT, Component::kFloat32}};

std::string sentence(const std::string& text) {
  std::string line = shd::io::printable(text);
  while (!line.empty() && (line.back() == '?' || line.back() == ' ')) line.pop_back();
  return line.empty() ? "OpenImageIO gives no reason" : line;
}

const Storage* find_storage(const std::string& name, OIIO::TypeDesc type) {
  for (const Storage& storage : kStorages) {
    if (name.empty() ? type == storage.type : name == storage.name) return &storage;
  }
  return nullptr;
}

}  // namespace

Source::Source(const Options& options) : path_(options.input) {
  struct stat status;
  if (::stat(path_.c_str(), &status) != 0) refuse(std::string("cannot open: ") + std::strerror(errno));
  if (!S_ISREG(status.st_mode)) refuse("not a regular file");
  if (status.st_size == 0) refuse("the file is empty");
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);  // numbers as they are stored
  input_ = OIIO::ImageInput::open(path_, &config);
  if (!input_) refuse("cannot read: " + sentence(OIIO::geterror()));
  spec_ = input_->spec();
  image_.file_bytes = static_cast<uint64_t>(status.st_size);
  image_.changed = int64_t{status.st_mtim.tv_sec} * 1000000000 + status.st_mtim.tv_nsec;
  describe(options);
  tile_rows_ = static_cast<uint32_t>(spec_.tile_height);
}

void Source::refuse(const std::string& what) const {
  throw Failure(kExitInput, "\"" + shd::io::printable(path_) + "\": " + what);
}

void Source::describe(const Options& options) {
  const auto text = [](int value) { return std::to_string(value); };
  if (spec_.deep || spec_.depth > 1) refuse("deep images and volumes cannot be converted");
  if (spec_.width < 1 || spec_.height < 1 || spec_.nchannels < 1) refuse("the file describes an image without pixels");
  if (spec_.width > kMaxSide || spec_.height > kMaxSide) {
    refuse(text(spec_.width) + " x " + text(spec_.height) + " pixels; each side may have 1 to " + text(kMaxSide));
  }
  if (spec_.x != spec_.full_x || spec_.y != spec_.full_y || spec_.width != spec_.full_width ||
      spec_.height != spec_.full_height) {
    refuse("the data window is not the display window: crop the image to one of them first");
  }
  if (spec_.tile_width < 0 || spec_.tile_height < 0 || spec_.tile_height > kMaxSide) refuse("bad tile size");
  const int channels = options.channels ? options.channels : spec_.nchannels;
  if (channels > spec_.nchannels)
    refuse("--channels " + text(channels) + ", but the file has " + text(spec_.nchannels));
  if (channels > 4) refuse(text(channels) + " channels: choose the first 1 to 4 with --channels");
  if (options.normal && channels < 3) refuse("--normal needs 3 or 4 channels, not " + text(channels));
  const Storage* const storage = find_storage(options.format, spec_.format);
  if (!storage) refuse(std::string("numbers of type ") + spec_.format.c_str() + ": choose another one with --format");
  image_.width = static_cast<uint32_t>(spec_.width);
  image_.height = static_cast<uint32_t>(spec_.height);
  image_.channels = static_cast<uint32_t>(channels);
  image_.type = storage->type;
  image_.component = storage->component;
  image_.alpha = spec_.alpha_channel < channels ? spec_.alpha_channel : -1;
  image_.straight = image_.alpha >= 0 && spec_.get_int_attribute("oiio:UnassociatedAlpha", 0) != 0;
  for (int c = 0; c < channels; ++c) image_.names.push_back(spec_.channel_name(c));
  choose_encoding(options, storage->name);
}

void Source::choose_encoding(const Options& options, const char* type) {
  const bool linear = options.normal || options.encoding == Encoding::kLinear;
  const bool integers = image_.type == OIIO::TypeUInt8 || image_.type == OIIO::TypeUInt16;
  const std::string space = shd::io::name_color_space(SHD_COLOR_ENCODING_AUTO,
                                                      spec_.get_string_attribute("oiio:ColorSpace"), integers, nullptr);
  const shd::io::Curve curve = shd::io::transfer_of(space).curve;
  const bool srgb = options.encoding == Encoding::kSrgb || (!linear && curve == shd::io::Curve::kSrgb);
  if (!linear && !srgb && curve != shd::io::Curve::kLinear) {
    refuse("colour space \"" + shd::io::printable(space) + "\": say --srgb or --linear");
  }
  if (!srgb) return;
  if (image_.component != Component::kUnorm8) {
    refuse(std::string("sRGB-encoded numbers of type ") + type +
           ": textures are sRGB in 8 bits only; --linear takes the numbers as they are");
  }
  image_.component = Component::kSrgb8;
}

/// Refuses rows whose read failed, or left a message: some readers report damage in this way only.
void Source::check_read(bool read, uint32_t begin, uint32_t end) {
  const std::string message = input_->geterror();
  if (read && message.empty()) return;
  refuse("rows " + std::to_string(begin) + " to " + std::to_string(end - 1) + ": " + sentence(message));
}

void Source::read_tiles(uint32_t y) {
  const uint32_t begin = y / tile_rows_ * tile_rows_;
  end_ = std::min(begin + tile_rows_, image_.height);
  buffered_ = begin;
  buffer_.assign(size_t{end_ - begin} * image_.row_size(), 0);
  const bool read = input_->read_tiles(0, 0, 0, spec_.width, static_cast<int>(begin), static_cast<int>(end_), 0, 1, 0,
                                       static_cast<int>(image_.channels), image_.type, buffer_.data());
  check_read(read, begin, end_);
}

void Source::read(uint32_t y, uint32_t count, uint8_t* out) {
  const size_t row = image_.row_size();
  if (tile_rows_ == 0) {
    const bool read = input_->read_scanlines(0, 0, static_cast<int>(y), static_cast<int>(y + count), 0, 0,
                                             static_cast<int>(image_.channels), image_.type, out);
    check_read(read, y, y + count);
    return;
  }
  for (const uint32_t last = y + count; y < last;) {
    if (y < buffered_ || y >= end_) read_tiles(y);
    const uint32_t rows = std::min(last, end_) - y;
    std::memcpy(out, buffer_.data() + (y - buffered_) * row, rows * row);
    out += rows * row;
    y += rows;
  }
}
