// SPDX-License-Identifier: MIT
#include "node_memory.h"

#include <cstdio>
#include <cstring>
#include <shd.hpp>
#include <vector>

#include "exr_layout.h"
#include "scene_block.h"

namespace farm {
namespace {

std::vector<char> load(const Options& options, std::string* error) {
  try {
    const shd::context context = shd::context_create(nullptr);
    return make_scene_block(context, options);
  } catch (const std::exception& failure) {
    *error = failure.what();
    return {};
  }
}

}  // namespace

NodeMemory load_on_node(const Options& options) {
  NodeMemory memory;
  int rank = 0, node_rank = 0, unit = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, rank, MPI_INFO_NULL, &memory.node);
  MPI_Comm_rank(memory.node, &node_rank);
  std::vector<char> loaded;
  if (node_rank == 0) loaded = load(options, &memory.error);
  memory.bytes = loaded.size();
  MPI_Bcast(&memory.bytes, 1, MPI_UINT64_T, 0, memory.node);
  if (memory.bytes == 0) return memory;
  char* own = nullptr;
  MPI_Aint size = node_rank == 0 ? static_cast<MPI_Aint>(memory.bytes) : 0;
  MPI_Win_allocate_shared(size, 1, MPI_INFO_NULL, memory.node, &own, &memory.window);
  char* shared = nullptr;
  MPI_Win_shared_query(memory.window, 0, &size, &unit, &shared);
  MPI_Win_fence(0, memory.window);
  if (node_rank == 0) std::memcpy(shared, loaded.data(), loaded.size());
  MPI_Win_fence(0, memory.window);
  memory.block = shared;
  if (node_rank == 0) memory.sum = checksum(shared, memory.bytes);
  MPI_Bcast(&memory.sum, 1, MPI_UINT64_T, 0, memory.node);
  return memory;
}

bool agree(const NodeMemory& memory, const std::string& error) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  const std::string text = memory.error.empty() ? error : memory.error;
  if (!text.empty()) std::fprintf(stderr, "shd-farm: rank %d: %s\n", rank, text.c_str());
  uint64_t mine[3] = {text.empty() && memory.bytes > 0, memory.sum, ~memory.sum}, least[3];
  MPI_Allreduce(mine, least, 3, MPI_UINT64_T, MPI_MIN, MPI_COMM_WORLD);
  if (!least[0]) return false;
  if (least[1] == ~least[2]) return true;
  if (rank == 0) std::fprintf(stderr, "shd-farm: the nodes have loaded different scenes\n");
  return false;
}

void release(NodeMemory* memory) {
  if (memory->window != MPI_WIN_NULL) MPI_Win_free(&memory->window);
  if (memory->node != MPI_COMM_NULL) MPI_Comm_free(&memory->node);
}

}  // namespace farm
