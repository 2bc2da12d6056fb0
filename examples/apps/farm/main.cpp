// SPDX-License-Identifier: MIT
// shd-farm: pictures of up to 65536 x 65536 pixels on the ranks of an MPI job. docs/farm.md describes it.
#include <mpi.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>

#include "command/program.h"
#include "node_memory.h"
#include "part_file.h"
#include "ranks.h"

namespace farm {
namespace {

constexpr double kSetUpSeconds = 120.0;  // time to load a scene, added to --timeout

extern "C" void end_late(int) {
  const char text[] = "shd-farm: a rank did not answer while the job began or ended; the same command resumes it\n";
  if (write(STDERR_FILENO, text, sizeof text - 1) < 0) _exit(kExitSilent);
  _exit(kExitSilent);
}

/// Begins and ends are collective and would wait for ever for a stopped rank.
void limit_time(double seconds) {
  alarm(static_cast<unsigned>(std::ceil(seconds)));
}

int run_rank(const Options& options) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  std::signal(SIGALRM, end_late);
  limit_time(kSetUpSeconds + options.timeout);
  NodeMemory memory = load_on_node(options);
  StagePtr stage;
  std::string error;
  try {
    if (memory.block) stage = make_stage(options, memory.block);
  } catch (const std::exception& failure) {
    error = failure.what();
  }
  int status = kExitFailed;
  if (agree(memory, error)) {
    limit_time(0);
    if (rank == 0) {
      std::printf("shd-farm: scene of %.1f MiB once a node, %.1f MiB of texels borrowed\n",
                  static_cast<double>(memory.bytes) / 1048576,
                  static_cast<double>(borrowed_bytes(memory.block)) / 1048576);
    }
    status = rank == 0 ? serve(options, memory.sum, stage.get()) : work(options, stage.get());
    limit_time(options.timeout);
  }
  stage.reset();
  release(&memory);
  return status;
}

/// Throws Failure for bad options.
int run(int argc, char** argv) {
  Options options;
  if (!read_options(argc, argv, &options)) return 0;
  if (options.single) return render_alone(options);
  int threads = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &threads);
  const int status = run_rank(options);
  MPI_Finalize();
  return status;
}

}  // namespace
}  // namespace farm

int main(int argc, char** argv) {
  const uint32_t one = 1;
  char first = 0;
  std::memcpy(&first, &one, 1);
  if (first != 1) {
    std::fprintf(stderr, "shd-farm: OpenEXR files are little-endian, and this machine is not\n");
    return kExitFailed;
  }
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on the size of files becomes an error of write()
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  return command::run("shd-farm", [&] { return farm::run(argc, argv); });
}
