// SPDX-License-Identifier: MIT
// The scene in memory that the ranks of a node share: one rank of each node loads it.
#ifndef SHD_FARM_NODE_MEMORY_H
#define SHD_FARM_NODE_MEMORY_H

#include <mpi.h>

#include <cstdint>
#include <string>

#include "options.h"

namespace farm {

struct NodeMemory {
  MPI_Comm node = MPI_COMM_NULL;
  MPI_Win window = MPI_WIN_NULL;
  const char* block = nullptr;
  uint64_t bytes = 0;
  uint64_t sum = 0;   // checksum of the block
  std::string error;  // message of the rank that loads
};

/// Collective. All ranks fail together: see agree().
NodeMemory load_on_node(const Options& options);

/// Whether no rank has an error and all nodes have the same scene. Prints the errors. Collective.
bool agree(const NodeMemory& memory, const std::string& error);

void release(NodeMemory* memory);

}  // namespace farm

#endif  // SHD_FARM_NODE_MEMORY_H
