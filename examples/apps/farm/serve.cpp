// SPDX-License-Identifier: MIT
#include <mpi.h>

#include <cinttypes>
#include <cstdio>
#include <vector>

#include "messages.h"
#include "progress.h"
#include "queue.h"
#include "ranks.h"
#include "worker.h"

namespace farm {
namespace {

struct Peer {
  bool ready = false;
  uint32_t rendering = 0;  // windows that were handed out and are not rendered
  Clock::time_point heard = Clock::now();
  bool ended = false;
  Statistics statistics{};
};

struct Server {
  const Options& options;
  Queue queue;
  Worker& worker;
  std::vector<Peer> peers;  // [ranks]; 0 is this process
  Progress progress;
  std::vector<char> tile;  // the only one of another rank in memory
  std::string failure;     // the first one
  Clock::time_point last_ping = Clock::now();
};

/// A second window hides the time of messages. Near the end it would lie idle beside a rank without work.
bool has_room(const Server& server, const Peer& peer) {
  if (!peer.ready || peer.rendering > 1) return false;
  return peer.rendering == 0 || server.queue.left > 2 * server.peers.size();
}

void send(uint32_t rank, const Message& message) {
  MPI_Send(&message, sizeof message, MPI_BYTE, static_cast<int>(rank), kTagMessage, MPI_COMM_WORLD);
}

void hand_out(Server* server) {
  bool given = true;
  while (given) {  // one window to each rank in turn
    given = false;
    for (uint32_t rank = 0; rank < server->peers.size(); ++rank) {
      Peer& peer = server->peers[rank];
      Message job{};
      if (!has_room(*server, peer) || !next_job(&server->queue, &job)) continue;
      peer.rendering += 1;
      given = true;
      if (rank == 0) {
        server->worker.submit(job);
      } else {
        send(rank, job);
      }
    }
  }
}

[[noreturn]] void end_silent(const Server& server, uint32_t rank) {
  std::fprintf(stderr,
               "shd-farm: rank %u has not answered for %g s, the job ends; %" PRIu64 " of %" PRIu64
               " windows are kept, the same command resumes it\n",
               rank, server.options.timeout, server.queue.done, server.queue.total);
  for (const auto& [frame, file] : server.queue.open) sync_data(file.journal);
  MPI_Abort(MPI_COMM_WORLD, kExitSilent);
  std::abort();
}

/// Receives the tile that follows a message of `rank`, without blocking for ever.
void receive_tile(Server* server, const Message& message) {
  MPI_Request request;
  int there = 0;
  const Clock::time_point begin = Clock::now();
  server->tile.resize(message.tile_bytes);
  MPI_Irecv(server->tile.data(), static_cast<int>(message.tile_bytes), MPI_BYTE, static_cast<int>(message.rank),
            kTagTile, MPI_COMM_WORLD, &request);
  while (MPI_Test(&request, &there, MPI_STATUS_IGNORE), !there) {
    if (seconds_since(begin) > server->options.timeout) end_silent(*server, message.rank);
  }
}

void take(Server* server, const Message& message, const std::vector<char>& tile) {
  Peer& peer = server->peers[message.rank];
  peer.heard = Clock::now();
  switch (message.kind) {
    case Kind::kHello: peer.ready = true; break;
    case Kind::kRendered: peer.rendering -= 1; break;
    case Kind::kFinished:
      if (!server->failure.empty()) break;
      if (!tile.empty()) write_tile(&server->queue, message, tile);
      finish_job(&server->queue, message);
      add_times(message, &server->progress);
      break;
    case Kind::kFailed:
      if (server->failure.empty()) server->failure = "rank " + std::to_string(message.rank) + ": " + message.text;
      break;
    case Kind::kStatistics: peer.ended = true, peer.statistics = message.statistics; break;
    default: break;
  }
}

void receive_all(Server* server) {
  static const std::vector<char> no_tile;
  MPI_Status status;
  for (int there = 0; MPI_Iprobe(MPI_ANY_SOURCE, kTagMessage, MPI_COMM_WORLD, &there, &status), there;) {
    Message message{};
    MPI_Recv(&message, sizeof message, MPI_BYTE, status.MPI_SOURCE, kTagMessage, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    const bool with_tile = message.kind == Kind::kFinished && message.tile_bytes > 0;
    if (with_tile) receive_tile(server, message);
    take(server, message, with_tile ? server->tile : no_tile);
  }
}

/// Ranks answer pings while they render, so a long window is no silence.
void check_silence(Server* server) {
  const double period = server->options.timeout / 4;
  const bool ping = seconds_since(server->last_ping) > period;
  Message message{};
  message.kind = Kind::kPing;
  for (uint32_t rank = 1; rank < server->peers.size(); ++rank) {
    const Peer& peer = server->peers[rank];
    if (peer.ended) continue;
    if (seconds_since(peer.heard) > server->options.timeout) end_silent(*server, rank);
    if (ping) send(rank, message);
  }
  if (ping) server->last_ping = Clock::now();
}

void step(Server* server) {
  Event event;
  if (server->worker.next_event(std::chrono::microseconds(300), &event)) take(server, event.message, event.tile);
  receive_all(server);
  check_silence(server);
}

void render_all(Server* server) {
  try {
    open_times(server->options, &server->progress);
    while (server->failure.empty() && !all_done(server->queue)) {
      hand_out(server);
      step(server);
      show_progress(server->queue, &server->progress);
    }
  } catch (const std::exception& error) {
    server->failure = error.what();
  }
}

/// Ends all ranks and collects their statistics.
void stop_all(Server* server) {
  Message stop{};
  stop.kind = Kind::kStop;
  for (uint32_t rank = 1; rank < server->peers.size(); ++rank) send(rank, stop);
  server->peers[0].statistics = server->worker.stop();
  for (uint32_t rank = 1; rank < server->peers.size();) {
    if (server->peers[rank].ended) {
      ++rank;
    } else {
      step(server);
    }
  }
}

int report(const Server& server, double seconds) {
  if (server.progress.times) std::fclose(server.progress.times);
  for (const auto& [frame, file] : server.queue.open) sync_data(file.journal);
  std::vector<Statistics> statistics;
  for (const Peer& peer : server.peers) statistics.push_back(peer.statistics);
  print_statistics(statistics, seconds);
  std::printf("%" PRIu64 " windows: %" PRIu64 " from earlier jobs\n", server.queue.total, server.queue.kept);
  for (const std::string& line : server.queue.finished) std::printf("%s\n", line.c_str());
  if (server.failure.empty()) return 0;
  std::fprintf(stderr,
               "shd-farm: %s\nshd-farm: the job ends; %" PRIu64 " of %" PRIu64
               " windows are kept, the same command resumes it\n",
               server.failure.c_str(), server.queue.done, server.queue.total);
  return kExitFailed;
}

}  // namespace

int serve(const Options& options, uint64_t scene_sum, Stage* stage) {
  int size = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  Worker worker(options, stage);
  Server server{options, make_queue(options, scene_sum), worker, std::vector<Peer>(static_cast<size_t>(size)), {}, {},
                {}};
  server.peers[0].ready = true;
  const Clock::time_point begin = Clock::now();
  render_all(&server);
  const double seconds = seconds_since(begin);
  stop_all(&server);
  return report(server, seconds);
}

}  // namespace farm
