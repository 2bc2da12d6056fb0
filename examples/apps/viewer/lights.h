// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include <shd.hpp>

#include "assets.h"
#include "state.h"

namespace viewer {

/// The light of a state: a key light with its shadow, ambient light, and an environment.
class Lights {
 public:
  /// Makes what differs from the previous state. `energy` = the model divides by pi. Throws shd::error.
  void prepare(shd_context* context, const Lighting& lighting, const Assets& assets, bool assets_changed);

  /// Sets the lights, shadows, environment and background of a frame. They stay valid until the next prepare().
  void set(bool over_pi, shd_render_desc& frame) const;

 private:
  struct Set {
    shd::light key, ambient;
    const shd_light* list[2] = {};
  };

  std::optional<Lighting> lighting_;  // settings of the members below
  Set sets_[2];                       // for models that reflect E, and for those that reflect E / pi
  shd::shadow shadow_;
  const shd_shadow* shadows_[2] = {};
  std::optional<std::string> environment_name_;
  shd::environment environment_;
};

}  // namespace viewer
