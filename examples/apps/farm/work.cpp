// SPDX-License-Identifier: MIT
#include <mpi.h>

#include <chrono>
#include <cstdio>
#include <vector>

#include "frame_file.h"
#include "messages.h"
#include "ranks.h"
#include "worker.h"

namespace farm {
namespace {

struct Link {
  const Options& options;
  Worker& worker;
  uint32_t rank;
  Clock::time_point heard = Clock::now();
  bool stop = false;
};

void check_silence(const Link& link) {
  if (seconds_since(link.heard) < link.options.timeout) return;
  std::fprintf(stderr,
               "shd-farm: rank %u: rank 0 has not answered for %g s, the job ends; the same command resumes it\n",
               link.rank, link.options.timeout);
  MPI_Abort(MPI_COMM_WORLD, kExitSilent);
}

/// Without blocking for ever: a stopped rank 0 must not hang this rank.
void send(Link* link, const void* data, size_t size, int tag) {
  MPI_Request request;
  int sent = 0;
  MPI_Isend(data, static_cast<int>(size), MPI_BYTE, 0, tag, MPI_COMM_WORLD, &request);
  while (MPI_Test(&request, &sent, MPI_STATUS_IGNORE), !sent) {
    std::this_thread::sleep_for(std::chrono::microseconds(100));
    check_silence(*link);
  }
}

void send(Link* link, Message message) {
  message.rank = link->rank;
  send(link, &message, sizeof message, kTagMessage);
}

void receive_all(Link* link) {
  for (int there = 0; MPI_Iprobe(0, kTagMessage, MPI_COMM_WORLD, &there, MPI_STATUS_IGNORE), there;) {
    Message message{};
    MPI_Recv(&message, sizeof message, MPI_BYTE, 0, kTagMessage, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    link->heard = Clock::now();
    if (message.kind == Kind::kJob) link->worker.submit(message);
    if (message.kind == Kind::kStop) link->stop = true;
    if (message.kind == Kind::kPing) {
      message.kind = Kind::kPong;
      send(link, message);
    }
  }
}

}  // namespace

int work(const Options& options, Stage* stage) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  Worker worker(options, stage);
  Link link{options, worker, static_cast<uint32_t>(rank)};
  Message hello{};
  hello.kind = Kind::kHello;
  send(&link, hello);
  Event event;
  while (!link.stop) {
    if (worker.next_event(std::chrono::microseconds(300), &event)) {
      send(&link, event.message);
      if (!event.tile.empty()) send(&link, event.tile.data(), event.tile.size(), kTagTile);
    }
    receive_all(&link);
    check_silence(link);
  }
  Message last{};
  last.kind = Kind::kStatistics;
  last.statistics = worker.stop();
  send(&link, last);
  return 0;
}

}  // namespace farm
