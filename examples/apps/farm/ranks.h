// SPDX-License-Identifier: MIT
// The loops of rank 0, which hands out windows, and of all other ranks. Both render.
#ifndef SHD_FARM_RANKS_H
#define SHD_FARM_RANKS_H

#include "command/failure.h"
#include "options.h"
#include "stage.h"

namespace farm {

constexpr int kExitSilent = 4;  // beside those of command/failure.h

/// Returns the exit status of the job.
int serve(const Options& options, uint64_t scene_sum, Stage* stage);
int work(const Options& options, Stage* stage);

/// One process without MPI: bands of the picture in as few calls of shd_render() as the options allow.
int render_alone(const Options& options);

}  // namespace farm

#endif  // SHD_FARM_RANKS_H
