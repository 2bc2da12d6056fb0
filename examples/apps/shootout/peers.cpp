// SPDX-License-Identifier: MIT
#include "peers.h"

#include <algorithm>
#include <stdexcept>

#include "shd_pass.h"

namespace shootout {
namespace {

/// Calls body(), whose failures are those of a peer.
template <class Body>
auto guarded(Who who, Body body) {
  try {
    return body();
  } catch (const std::runtime_error& e) {
    throw PeerFailure(who, e.what());
  }
}

}  // namespace

shd::bench::Peer* Peers::pass_of(const Setting& setting, const Workload& workload, const Lookups& q, uint32_t phases) {
  Kept& kept = kept_[{setting.who, setting.peer, q.count()}];
  kept.lookups = q;
#ifdef SHD_BENCH_OIIO
  if (setting.who == Who::kOpenImageIO) {
    if (!kept.pass) {
      kept.pass = shd::bench::make_openimageio(kept.lookups, texture_.edge, texture_.rgba, setting.peer);
    }
    return kept.pass.get();
  }
#endif
#ifdef SHD_BENCH_OSMESA
  if (setting.who == Who::kLlvmpipe) {
    if (workload.surface && phases == 1) {
      kept.pass = shd::bench::make_llvmpipe_surface(*workload.surface, workload.edge, texture_.edge, texture_.rgba,
                                                    setting.peer);
    } else {
      kept.pass = shd::bench::make_llvmpipe_lookups(kept.lookups, texture_.edge, texture_.rgba, setting.peer);
    }
    return kept.pass.get();
  }
#endif
#ifdef SHD_BENCH_LAVAPIPE
  if (setting.who == Who::kLavapipe) {
    if (kept.pass) {
      kept.pass->refresh();
    } else {
      kept.pass = shd::bench::make_lavapipe(kept.lookups, texture_.edge, texture_.rgba, setting.peer);
    }
    return kept.pass.get();
  }
#endif
  (void)workload, (void)phases;
  throw std::logic_error("setting " + setting.name + " is of no peer in this build");
}

std::vector<float> Peers::filter(const Setting& setting, const Workload& workload, const Lookups& q, uint32_t phases) {
  return guarded(setting.who, [&] {
    shd::bench::Peer* pass = pass_of(setting, workload, q, phases);
    pass->run();
    return pass->image();
  });
}

double Peers::seconds(const Setting& setting, const Workload& workload, const Lookups& q, int repeats) {
  return guarded(setting.who, [&] {
    shd::bench::Peer* pass = pass_of(setting, workload, q, 1);
    pass->run();
    double best = 1e9;
    for (int i = 0; i < repeats; ++i) {
      const double start = now();
      pass->run();
      best = std::min(best, (now() - start) / pass->copies());
    }
    return best;
  });
}

}  // namespace shootout
