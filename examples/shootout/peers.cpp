// SPDX-License-Identifier: MIT
#include "peers.h"

#include <algorithm>
#include <stdexcept>

#include "shd_pass.h"

namespace shootout {

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
  (void)workload, (void)phases;
  throw std::logic_error("setting " + setting.name + " is of no peer in this build");
}

std::vector<float> Peers::filter(const Setting& setting, const Workload& workload, const Lookups& q, uint32_t phases) {
  shd::bench::Peer* pass = pass_of(setting, workload, q, phases);
  pass->run();
  return pass->image();
}

double Peers::seconds(const Setting& setting, const Workload& workload, const Lookups& q, int repeats) {
  shd::bench::Peer* pass = pass_of(setting, workload, q, 1);
  pass->run();
  // A lookup without a surface is drawn as four pixels.
  const double pixels = setting.who == Who::kLlvmpipe && !workload.surface ? 4.0 : 1.0;
  double best = 1e9;
  for (int i = 0; i < repeats; ++i) {
    const double start = now();
    pass->run();
    best = std::min(best, (now() - start) / pixels);
  }
  return best;
}

}  // namespace shootout
