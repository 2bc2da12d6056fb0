// SPDX-License-Identifier: MIT
#pragma once

#include <shd.hpp>

#include "settings.h"
#include "textures.h"
#include "workloads/workload.h"

namespace shootout {

/// The columns that lookups of shd read.
shd_lookups columns_of(const Lookups& q);

/// A texture of shd with the tables of one setting, and its sampler, on the calling thread.
class ShdPass {
 public:
  ShdPass(const Texture& texture, const Setting& setting);

  /// Every lookup as packed RGBA.
  std::vector<float> filter(const Lookups& q) const;
  /// Runs the lookups into memory of `rgba`, which has 4 floats a lookup.
  void run(const Lookups& q, std::vector<float>* rgba) const;
  /// Levels of detail of the sampler's profile.
  std::vector<float> levels(const Lookups& q) const;
  /// The texels that lookup `index` reads. False for filters that cannot be explained.
  bool explain(const Lookups& q, size_t index, std::vector<shd_tap>* taps, shd_explanation* explanation) const;

  double build_seconds() const { return build_seconds_; }
  size_t table_bytes() const { return table_bytes_; }

 private:
  shd::context context_;
  shd::texture texture_;
  shd::sampler sampler_;
  double build_seconds_ = 0.0;
  size_t table_bytes_ = 0;
};

/// Seconds of a steady clock.
double now();

}  // namespace shootout
