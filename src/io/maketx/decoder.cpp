// SPDX-License-Identifier: MIT
#include "io/maketx/decoder.h"

#include <OpenImageIO/imageio.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/server/confine.h"
#include "io/worker/packet.h"

namespace {

using shd::io::Deadline;
using shd::io::Stream;

constexpr int kSocket = 0;

/// The other process has gone: there is nobody left to decode for.
struct Gone {};

const Deadline& no_deadline() {
  static const Deadline deadline(1e9);
  return deadline;
}

void send(const void* bytes, size_t size) {
  if (shd::io::send_all(kSocket, bytes, size, no_deadline()) != Stream::kDone) throw Gone();
}

void send_piece(PieceKind kind, uint32_t count) {
  const Piece piece = {kind, count};
  send(&piece, sizeof piece);
}

template <class Message>
Message receive() {
  Message message;
  if (shd::io::receive_all(kSocket, &message, sizeof message, no_deadline()) != Stream::kDone) throw Gone();
  return message;
}

/// An error of the file, as a text for the user.
[[noreturn]] void refuse(const std::string& action, const std::string& reason) {
  throw std::runtime_error(action + ": " + (reason.empty() ? "OpenImageIO gives no reason" : reason));
}

template <size_t kSize>
void copy_text(const std::string& text, char (&out)[kSize]) {
  std::memset(out, 0, kSize);
  text.copy(out, kSize - 1);
}

/// The key that a Target has stored: an attribute of OpenEXR, the last such word of the description of TIFF, because
/// the words before may be those of --attrib.
std::string key_in(const OIIO::ImageSpec& spec) {
  const std::string key = spec.get_string_attribute(kKeyAttribute);
  if (!key.empty()) return key;
  const std::string text = spec.get_string_attribute("ImageDescription"), mark = std::string(kKeyAttribute) + "=";
  const size_t at = text.rfind(mark);
  if (at == std::string::npos) return "";
  return text.substr(at + mark.size(), text.find(' ', at) - at - mark.size());
}

Description describe(const OIIO::ImageSpec& spec) {
  Description d = {};
  d.width = spec.width, d.height = spec.height, d.depth = spec.depth;
  d.x = spec.x, d.y = spec.y, d.full_x = spec.full_x, d.full_y = spec.full_y;
  d.full_width = spec.full_width, d.full_height = spec.full_height;
  d.tile_width = spec.tile_width, d.tile_height = spec.tile_height;
  d.channels = spec.nchannels, d.alpha = spec.alpha_channel, d.base_type = spec.format.basetype;
  d.deep = spec.deep;
  d.straight = spec.get_int_attribute("oiio:UnassociatedAlpha", 0) != 0;
  copy_text(spec.get_string_attribute("oiio:ColorSpace"), d.color_space);
  copy_text(key_in(spec), d.key);
  for (int c = 0; c < 4; ++c) copy_text(spec.channel_name(c), d.names[c]);
  return d;
}

void send_rows(OIIO::ImageInput& input, const DecodeRows& rows) {
  const OIIO::ImageSpec spec = input.spec();
  const OIIO::TypeDesc type(static_cast<OIIO::TypeDesc::BASETYPE>(rows.base_type));
  const size_t row = static_cast<size_t>(spec.width) * static_cast<size_t>(rows.channels) * type.size();
  std::vector<uint8_t> band(row * rows.step);
  const int step = static_cast<int>(rows.step);
  for (int y = 0; y < spec.height; y += step) {
    const int end = std::min(spec.height, y + step), count = end - y;
    std::fill(band.begin(), band.end(), uint8_t{0});  // a reader may succeed without writing all of it
    const bool read =
        spec.tile_width > 0
            ? input.read_tiles(0, 0, spec.x, spec.x + spec.width, spec.y + y, spec.y + end, spec.z, spec.z + 1, 0,
                               rows.channels, type, band.data())
            : input.read_scanlines(0, 0, spec.y + y, spec.y + end, spec.z, 0, rows.channels, type, band.data());
    // Some readers report damage by a message only.
    const std::string message = input.geterror();
    if (!read || !message.empty()) refuse("rows " + std::to_string(y) + " to " + std::to_string(end - 1), message);
    send_piece(PieceKind::kRows, static_cast<uint32_t>(count));
    send(band.data(), row * static_cast<size_t>(count));
  }
}

void decode(const DecodeFile& file) {
  OIIO::attribute("threads", file.threads);
  OIIO::attribute("exr_threads", file.threads);
  OIIO::attribute("limits:imagesize_MB", 0);
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);  // numbers as they are stored
  const auto input = OIIO::ImageInput::open(file.path, &config);
  if (!input) refuse("cannot read", OIIO::geterror());
  const Description description = describe(input->spec());
  send_piece(PieceKind::kDescription, 1);
  send(&description, sizeof description);
  send_rows(*input, receive<DecodeRows>());
}

void send_error(const std::string& text) {
  const auto size = static_cast<uint32_t>(std::min<size_t>(text.size(), kMaxErrorText));
  send_piece(PieceKind::kError, size);
  send(text.data(), size);
}

}  // namespace

int run_decoder() {
  try {
    (void)::prctl(PR_SET_PDEATHSIG, SIGKILL);
    DecodeFile file = receive<DecodeFile>();
    file.path[sizeof file.path - 1] = 0;
    pollfd peer = {kSocket, 0, 0};
    if (::poll(&peer, 1, 0) > 0) throw Gone();  // it has ended before this process asked for a signal
    constexpr double kNoLimit = 1e8;            // the first process ends the decoder
    shd::io::confine({file.memory, 0, kNoLimit});
    try {
      decode(file);
    } catch (const std::bad_alloc&) {
      send_error("the decoder needs more memory than " + std::to_string(file.memory >> 20) + "M: raise --memory");
    } catch (const std::exception& error) {
      send_error(error.what());
    }
  } catch (const Gone&) {
  }
  // Destructors are skipped: damaged memory must not keep the process, and libraries take long to unload.
  _exit(0);
}
