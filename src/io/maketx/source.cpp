// SPDX-License-Identifier: MIT
#include "io/maketx/source.h"

#include <sys/socket.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <thread>
#include <utility>

#include "command/failure.h"
#include "core/failure.h"
#include "io/bitmap/transfer.h"
#include "io/file/printable.h"
#include "io/file/read_file.h"
#include "texture/format/texel_codec.h"

namespace {

using shd::image::Component;

constexpr int kMaxSide = 1 << 20;

/// Memory of the decoder for tables of codecs, and for the stacks of a thread in each of two pools [bytes].
constexpr uint64_t kCodecMemory = uint64_t{1} << 30, kThreadMemory = uint64_t{32} << 20;

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
  return line;
}

/// A text of the decoder, which need not end.
template <size_t kSize>
std::string text_of(const char (&text)[kSize]) {
  return std::string(text, ::strnlen(text, kSize));
}

const Storage* find_storage(const std::string& name, OIIO::TypeDesc type) {
  for (const Storage& storage : kStorages) {
    if (name.empty() ? type == storage.type : name == storage.name) return &storage;
  }
  return nullptr;
}

}  // namespace

void check_time(const shd::io::Deadline& end) {
  if (end.seconds_left() > 0) return;
  throw Failure(kExitFailed, "not done within --time-limit: an unfinished run continues by the same command");
}

FileState file_state(const std::string& path) {
  struct stat status;
  FileState state;
  try {
    const shd::core::RegularFile file = shd::io::open_file(path.c_str());
    if (::fstat(file.file.fd, &status) != 0) throw Failure(kExitInput, std::strerror(errno));
    state.bytes = file.size;
  } catch (const shd::core::Failure& failure) {
    throw Failure(kExitInput, failure.what());
  }
  if (state.bytes == 0) throw Failure(kExitInput, "\"" + shd::io::printable(path) + "\": the file is empty");
  state.changed = int64_t{status.st_mtim.tv_sec} * 1000000000 + status.st_mtim.tv_nsec;
  return state;
}

Source::Source(const Options& options, const shd::io::Deadline& end, const std::string& path)
    : options_(options), path_(path), end_(end), state_(file_state(path)) {
  start();
}

Source::Source(const Options& options, const shd::io::Deadline& end, const Converter* converter)
    : options_(options), path_(options.input), end_(end), converter_(converter), state_(file_state(path_)) {
  start();
  image_.changed = state_.changed;
  describe(receive_description());
  const OIIO::TypeDesc wire = converter_ ? OIIO::TypeFloat : image_.type;
  const DecodeRows rows = {static_cast<int32_t>(image_.channels), wire.basetype, step_};
  send(&rows, sizeof rows);
  left_ = image_.height;
}

std::string Source::stored_key(const Options& options, const std::string& path) {
  const shd::io::Deadline end(options.stall_limit);
  try {
    return text_of(Source(options, end, path).receive_description().key);
  } catch (const Failure&) {
    return "";
  }
}

Description Source::receive_description() {
  Description file;
  (void)receive_piece(PieceKind::kDescription, 1);
  receive(&file, sizeof file);
  return file;
}

void Source::start() {
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    throw Failure(kExitFailed, std::string("cannot make a socket: ") + std::strerror(errno));
  }
  socket_ = shd::io::FileDescriptor(ends[0]);
  const shd::io::FileDescriptor theirs(ends[1]);
  decoder_.pid = shd::io::start_process("/proc/self/exe", theirs.fd, kDecoderArgument);
  const std::string path = std::filesystem::absolute(path_).string();  // the decoder has another folder
  DecodeFile file = {};
  if (path.size() >= sizeof file.path) refuse("the path is too long");
  const unsigned threads =
      options_.threads ? static_cast<unsigned>(options_.threads) : std::thread::hardware_concurrency();
  file.memory = kCodecMemory + threads * kThreadMemory + 8 * options_.memory + 3 * state_.bytes;
  file.threads = options_.threads;
  path.copy(file.path, path.size());
  send(&file, sizeof file);
}

void Source::refuse(const std::string& what) const {
  throw Failure(kExitInput, "\"" + shd::io::printable(path_) + "\": " + what);
}

/// Refuses the input because the decoder has ended, or sends nothing.
void Source::refuse_end(shd::io::Stream stream) {
  const pid_t pid = std::exchange(decoder_.pid, 0);
  if (stream == shd::io::Stream::kLate) {
    shd::io::kill_process(pid);
    check_time(end_);
    char limit[32];
    std::snprintf(limit, sizeof limit, "%g", options_.stall_limit);
    refuse(std::string("the decoder has sent nothing for ") + limit + " s (--stall-limit)");
  }
  refuse("the decoder died on the file (" + shd::io::finish_process(pid) + ")");
}

shd::io::Deadline Source::deadline() const {
  return shd::io::Deadline(std::min(options_.stall_limit, end_.seconds_left()));
}

void Source::send(const void* bytes, size_t size) {
  const shd::io::Stream stream = shd::io::send_all(socket_.fd, bytes, size, deadline());
  if (stream != shd::io::Stream::kDone) refuse_end(stream);
}

void Source::receive(void* bytes, size_t size) {
  const shd::io::Stream stream = shd::io::receive_all(socket_.fd, bytes, size, deadline());
  if (stream != shd::io::Stream::kDone) refuse_end(stream);
}

/// Receives the head of a piece, of 1 to `most` rows or descriptions.
uint32_t Source::receive_piece(PieceKind wanted, uint32_t most) {
  Piece piece;
  receive(&piece, sizeof piece);
  if (piece.kind == PieceKind::kError && piece.count <= kMaxErrorText) {
    std::string text(piece.count, ' ');
    receive(text.data(), text.size());
    refuse(sentence(text));
  }
  if (piece.kind != wanted || piece.count < 1 || piece.count > most) refuse("the decoder sent a wrong piece");
  return piece.count;
}

void Source::describe(const Description& file) {
  const auto text = [](int value) { return std::to_string(value); };
  if (file.deep || file.depth > 1) refuse("deep images and volumes cannot be converted");
  if (file.width < 1 || file.height < 1 || file.channels < 1) refuse("the file describes an image without pixels");
  if (file.width > kMaxSide || file.height > kMaxSide) {
    refuse(text(file.width) + " x " + text(file.height) + " pixels; each side may have 1 to " + text(kMaxSide));
  }
  if (file.x != file.full_x || file.y != file.full_y || file.width != file.full_width ||
      file.height != file.full_height) {
    refuse("the data window is not the display window: crop the image to one of them first");
  }
  if (file.tile_width < 0 || file.tile_height < 0 || file.tile_height > kMaxSide) refuse("bad tile size");
  const int channels = options_.channels ? options_.channels : file.channels;
  if (channels > file.channels) refuse("--channels " + text(channels) + ", but the file has " + text(file.channels));
  if (channels > 4) refuse(text(channels) + " channels: choose the first 1 to 4 with --channels");
  if (options_.normal && channels < 3) refuse("--normal needs 3 or 4 channels, not " + text(channels));
  if (file.base_type < 0 || file.base_type >= OIIO::TypeDesc::LASTBASE) refuse("numbers of no known type");
  const OIIO::TypeDesc type(static_cast<OIIO::TypeDesc::BASETYPE>(file.base_type));
  const bool widens = converter_ && options_.format.empty() && type != OIIO::TypeFloat;
  const Storage* const storage = find_storage(widens ? "half" : options_.format, type);
  if (!storage) refuse(std::string("numbers of type ") + type.c_str() + ": choose another one with --format");
  image_.width = static_cast<uint32_t>(file.width);
  image_.height = static_cast<uint32_t>(file.height);
  image_.channels = static_cast<uint32_t>(channels);
  image_.type = storage->type;
  image_.component = storage->component;
  image_.alpha = file.alpha >= 0 && file.alpha < channels ? file.alpha : -1;
  image_.straight = image_.alpha >= 0 && file.straight != 0;
  choose_names(file);
  if (converter_) {
    if (channels < 3) refuse("--colorconvert needs 3 or 4 channels, not " + text(channels));
    choose_converted();
  } else {
    choose_encoding(text_of(file.color_space), storage->name);
  }
  choose_step(static_cast<uint32_t>(file.tile_height));
}

/// Takes the names of the file if the output can have them: different ones, of printable characters.
void Source::choose_names(const Description& file) {
  std::vector<std::string>& names = image_.names;
  bool good = true;
  for (uint32_t c = 0; c < image_.channels; ++c) {
    const std::string name = text_of(file.names[c]);
    good = good && !name.empty() && shd::io::printable(name) == name &&
           std::find(names.begin(), names.end(), name) == names.end();
    names.push_back(name);
  }
  if (!good) names = OIIO::ImageSpec(1, 1, static_cast<int>(image_.channels), image_.type).channelnames;
}

/// Rows of a piece: whole tiles, or blocks of lines.
void Source::choose_step(uint32_t tile_height) {
  constexpr uint64_t kLargest = uint64_t{4} << 20, kBlock = 64;
  const uint64_t bytes = std::min(kLargest, options_.memory / 8), row = wire_row();
  const uint64_t block = tile_height ? tile_height : kBlock;
  uint64_t rows = std::max<uint64_t>(bytes / (row * block), 1) * block;
  if (tile_height == 0) rows = std::min(rows, std::max<uint64_t>(bytes / row, 1));
  step_ = static_cast<uint32_t>(std::min<uint64_t>(rows, image_.height));
}

size_t Source::wire_row() const {
  return converter_ ? size_t{image_.width} * image_.channels * sizeof(float) : image_.row_size();
}

/// A conversion may make sRGB codes of 8 bits: levels are averages of their light.
void Source::choose_converted() {
  image_.color_space = options_.color_to;
  const bool srgb = shd::io::transfer_of(options_.color_to).curve == shd::io::Curve::kSrgb;
  if (srgb && image_.component == Component::kUnorm8) image_.component = Component::kSrgb8;
}

void Source::choose_encoding(const std::string& said, const char* type) {
  const bool linear = options_.normal || options_.encoding == Encoding::kLinear;
  const bool integers = image_.type == OIIO::TypeUInt8 || image_.type == OIIO::TypeUInt16;
  const std::string space = shd::io::name_color_space(SHD_COLOR_ENCODING_AUTO, said, integers, nullptr);
  const shd::io::Curve curve = shd::io::transfer_of(space).curve;
  const bool srgb = options_.encoding == Encoding::kSrgb || (!linear && curve == shd::io::Curve::kSrgb);
  if (!linear && !srgb && curve != shd::io::Curve::kLinear) {
    refuse("colour space \"" + shd::io::printable(space) + "\": say --srgb or --linear");
  }
  image_.color_space = srgb ? "sRGB" : "Linear";
  if (!srgb) return;
  if (image_.component != Component::kUnorm8) {
    refuse(std::string("sRGB-encoded numbers of type ") + type +
           ": textures are sRGB in 8 bits only; --linear takes the numbers as they are");
  }
  image_.component = Component::kSrgb8;
}

void Source::read(uint32_t count, uint8_t* out) {
  check_time(end_);
  if (!converter_) return read_wire(count, out);
  std::vector<float> row(wire_row() / sizeof(float));
  for (uint32_t y = 0; y < count; ++y) {
    read_wire(1, reinterpret_cast<uint8_t*>(row.data()));
    convert(row.data(), out + y * image_.row_size());
  }
}

/// Converts a row. Colour that is multiplied by alpha is divided by it for the conversion.
void Source::convert(const float* row, uint8_t* out) const {
  const size_t channels = image_.channels;
  const auto alpha_of = [&](const float* pixel) {
    return image_.alpha == 3 && !image_.straight && pixel[3] > 0 ? pixel[3] : 1.0f;
  };
  std::vector<float> rgba(size_t{4} * image_.width, 1.0f);
  for (size_t x = 0; x < image_.width; ++x) {
    const float* const pixel = row + x * channels;
    for (size_t c = 0; c < 3; ++c) rgba[4 * x + c] = pixel[c] / alpha_of(pixel);
  }
  converter_->convert(rgba.data(), image_.width);
  const Component stored = image_.component == Component::kSrgb8 ? Component::kUnorm8 : image_.component;
  const shd::texture::TexelCodec& codec = shd::texture::codec_of(stored, channels);
  for (size_t x = 0; x < image_.width; ++x) {
    const float* const pixel = row + x * channels;
    double numbers[4];
    for (size_t c = 0; c < channels; ++c) {
      const float value = c < 3 ? rgba[4 * x + c] * alpha_of(pixel) : pixel[c];
      numbers[c] = codec.clamp(c, static_cast<double>(value) * codec.one[c]);
    }
    codec.store(numbers, 1, out + x * codec.size);
  }
}

void Source::read_wire(uint32_t count, uint8_t* out) {
  const size_t row = wire_row();
  while (count > 0) {
    if (piece_ == 0) {
      piece_ = receive_piece(PieceKind::kRows, left_);
      left_ -= piece_;
    }
    const uint32_t rows = std::min(count, piece_);
    receive(out, rows * row);
    out += rows * row;
    piece_ -= rows;
    count -= rows;
  }
}
