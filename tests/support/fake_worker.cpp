// SPDX-License-Identifier: MIT
// A worker that misbehaves; the end of its program's name selects the fault. It sends replies that a decoder under the
// control of a hostile file could send.
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "io/worker/packet.h"
#include "io/worker/protocol.h"

namespace
{

using namespace shd::io;

const Deadline kLong(3600);

void send_bytes(int pipe, const void *bytes, size_t size)
{
    const auto *next = static_cast<const char *>(bytes);
    while (size > 0) {
        const ssize_t put = ::write(pipe, next, size);
        if (put <= 0) return;
        next += put;
        size -= static_cast<size_t>(put);
    }
}

bool has(const std::string &mode, const char *part) { return mode.find(part) != std::string::npos; }

/// Channels of the pixels on the wire, and their meaning.
void set_channels(const std::string &mode, WorkerReply *reply)
{
    const bool rgb = has(mode, "rgb"), grey = has(mode, "grey");
    reply->channels = rgb ? 3 : grey ? 2 : mode == "no_channels" ? 0 : mode == "channels" ? 5 : 4;
    for (int c = 0; c < 4; ++c) reply->map[c] = grey ? c / 3 : rgb && c == 3 ? -1 : c;
    if (mode == "map_above") reply->map[1] = 4;
    if (mode == "map_below") reply->map[3] = -2;
    if (mode == "rgb_map") reply->map[3] = 3;
}

/// A good reply for the 5 x 4 pixels that the test expects, and its faults.
WorkerReply make_reply(const std::string &mode)
{
    WorkerReply reply = {};
    reply.magic = mode == "reply_magic" ? 7 : kWorkerMagic;
    reply.format = mode == "format" ? 77u : uint32_t{mode == "one_channel" ? SHD_FORMAT_R8 : SHD_FORMAT_RGBA8};
    reply.width = mode == "zero" ? 0 : mode == "wide" ? 70000 : mode == "pixels" ? 60000 : 5;
    reply.height = mode == "pixels" ? 60000 : 4;
    reply.depth = mode == "no_slice" ? 0 : mode == "slices" ? 2 : 1;
    reply.level_count = mode == "no_level" ? 0 : mode == "levels" ? 2 : 1;
    reply.size = mode == "size" ? 81 : mode == "overflow" ? ~uint64_t{0} : 80;
    reply.info.file_format = static_cast<shd_file_format>(mode == "info_format" ? 3 : SHD_FILE_FORMAT_PNG);
    reply.info.flags = mode == "info_flags" ? 1u << 30 : 0;
    reply.code = mode == "code" ? 4711 : mode == "text" ? uint32_t{SHD_ERROR_CORRUPT} : uint32_t{SHD_OK};
    set_channels(mode, &reply);
    if (has(mode, "grid")) {
        reply.format = mode == "grid_format" ? SHD_FORMAT_R16F : SHD_FORMAT_R32F;
        if (mode == "grid_format") reply.size = 40;
        reply.channels = 1;
        for (int c = 0; c < 4; ++c) reply.map[c] = c < 3 ? 0 : -1;
        reply.info.file_format = SHD_FILE_FORMAT_ANY;
        reply.grid.index_to_world[0] = mode == "grid_matrix" ? 1 / std::strtod("0", nullptr) : 1;
        reply.grid.grid_class = mode == "grid_class" ? 3 : 1;
        std::memset(reply.grid.name, 7, sizeof reply.grid.name);
    }
    std::memset(reply.color_space, mode == "color_space" ? 7 : 0, sizeof reply.color_space);
    std::memset(reply.message, mode == "text" ? 0x1b : 0, sizeof reply.message);
    return reply;
}

/// Pixels on the wire of every mode, and the size of a piece of them [bytes].
struct Wire {
    size_t total, piece;
};

Wire wire_of(const std::string &mode)
{
    if (mode == "grid_format") return {40, 10};
    const Wire by_mode = has(mode, "rgb") ? Wire{60, 15} : has(mode, "grey") ? Wire{40, 10} : Wire{80, 8};
    if (has(mode, "short")) return {by_mode.total - 1, by_mode.total - 1};
    if (has(mode, "few")) return {by_mode.total / 2, by_mode.piece};
    if (has(mode, "long")) return {by_mode.total + 2 * by_mode.piece, by_mode.piece};
    if (mode == "drips") return {80, 4};
    if (mode == "rgb_split") return {60, 10};
    return mode == "rgb_wide" ? Wire{80, 80} : by_mode;
}

/// Sends pieces of the pixels, each behind its announced size. Pixels on the wire are the bytes 1, 2, 3...
void send_pixels(const std::string &mode, int pipe)
{
    const Wire wire = wire_of(mode);
    std::vector<unsigned char> pixels(wire.total);
    for (size_t i = 0; i < wire.total; ++i) pixels[i] = static_cast<unsigned char>(i + 1);
    for (size_t at = 0; at < wire.total; at += wire.piece) {
        const uint64_t announced = mode == "huge_piece" ? ~uint64_t{0} : wire.piece + (has(mode, "short") ? 1 : 0);
        send_bytes(pipe, &announced, sizeof announced);
        send_bytes(pipe, pixels.data() + at, wire.piece);
        if (mode == "drips") (void)::usleep(50000);
    }
}

/// Ends the pixels, and sends the final reply.
void send_final(const std::string &mode, int pipe, WorkerReply reply)
{
    const uint64_t end = 0;
    send_bytes(pipe, &end, sizeof end);
    if (mode == "final_magic") reply.magic = 7;
    if (mode == "final_refuses") {
        reply.code = SHD_ERROR_CORRUPT;
        std::strcpy(reply.message, "row 3 is damaged");
    }
    if (mode == "final_turned") std::swap(reply.width, reply.height);
    if (mode == "final_format") reply.format = SHD_FORMAT_RGBA8_SRGB;
    if (mode == "final_grows") reply.size = 160, reply.height = 8;
    if (mode == "final_channels") reply.channels = 3, reply.map[3] = -1;
    if (mode == "rgb_final_map") std::swap(reply.map[0], reply.map[2]);
    if (mode == "final_info") reply.info.flags = 1u << 30;
    send_bytes(pipe, &reply, sizeof reply);
}

/// Answers one request. Returns false if the worker shall end.
void answer(const std::string &mode, FileDescriptor &control, FileDescriptor &data)
{
    const WorkerStarted started = {mode == "refuses" ? ENOMEM : 0};
    if (mode == "silent") return;
    (void)send_packet(control.fd, &started, mode == "started_short" ? 1 : sizeof started, nullptr, 0, kLong);
    if (mode == "hangs" || mode == "refuses") {
        (void)::sleep(5);
        return;
    }
    if (mode == "closes") {
        data.reset();
        (void)::sleep(5);
        return;
    }
    const WorkerReply reply = make_reply(mode);
    send_bytes(data.fd, &reply, mode == "cut" ? sizeof reply - 1 : sizeof reply);
    if (mode != "cut") send_pixels(mode, data.fd);
    if (mode != "cut" && !has(mode, "short") && mode != "no_final") send_final(mode, data.fd, reply);
    const WorkerEnded ended = {9};
    if (has(mode, "short") || mode == "cut" || mode == "no_final")
        (void)send_packet(control.fd, &ended, sizeof ended, nullptr, 0, kLong);
}

}  // namespace

int main(int, char **arguments)
{
    const std::string program = arguments[0];
    const std::string mode = program.substr(program.rfind('-') + 1);
    // The host kills its own child after the greeting, so the worker is a process of its own by then.
    if (mode.compare(0, 5, "hello") != 0 && ::fork() != 0) _exit(0);
    WorkerHello hello = {kWorkerMagic, 0};
    if (mode == "hello_magic") hello.magic = 1;
    if (mode == "hello_error") hello.error = EAGAIN;
    if (mode == "hello_late") (void)::sleep(5);
    if (mode == "hello_never") return 7;
    if (send_packet(0, &hello, mode == "hello_short" ? 3 : sizeof hello, nullptr, 0, kLong) != Stream::kDone) return 1;
    while (true) {
        WorkerRequest request;
        FileDescriptor handed[kMaxDescriptors];
        if (receive_packet(0, &request, sizeof request, handed, kMaxDescriptors, kLong) != Stream::kDone) _exit(0);
        if (mode == "ends") _exit(0);
        answer(mode, handed[0], handed[1]);
    }
}
