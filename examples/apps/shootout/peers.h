// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <stdexcept>
#include <tuple>

#include "settings.h"
#include "textures.h"
#include "workloads/workload.h"

namespace shootout {

/// The failure of a peer in the middle of a run.
struct PeerFailure : std::runtime_error {
  PeerFailure(Who failed, const std::string& message) : std::runtime_error(message), who(failed) {}
  Who who;
};

/// The peers on one texture. Calls throw PeerFailure. Their wrappers belong to the thread that makes them.
class Peers {
 public:
  explicit Peers(const Texture& texture) : texture_(texture) {}

  /// Every lookup as packed RGBA. A rasteriser draws the workload's surface where it has one and `phases` is 1.
  std::vector<float> filter(const Setting& setting, const Workload& workload, const Lookups& q, uint32_t phases = 1);
  /// Seconds of the fastest of `repeats` whole frames.
  double seconds(const Setting& setting, const Workload& workload, const Lookups& q, int repeats);

 private:
  /// A wrapper of OpenImageIO reads its lookups by reference, so new ones take the place of the old ones.
  struct Kept {
    Lookups lookups;
    std::unique_ptr<shd::bench::Peer> pass;
  };
  shd::bench::Peer* pass_of(const Setting& setting, const Workload& workload, const Lookups& q, uint32_t phases);

  const Texture& texture_;
  std::map<std::tuple<Who, shd::bench::PeerFilter, size_t>, Kept> kept_;
};

}  // namespace shootout
