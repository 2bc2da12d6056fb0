// SPDX-License-Identifier: MIT
/// Makes pictures of states with the library alone: no window, no SDL, no ImGui.
#pragma once
#include <optional>

#include <shd.hpp>

#include "assets.h"
#include "lights.h"
#include "picture.h"
#include "tiles.h"

namespace viewer {

/// Keeps what the next picture can use again: assets, shadows, environment, framebuffers. One thread uses it.
class Stage {
 public:
  /// `workers` 0 = one per core. Throws shd::error.
  explicit Stage(uint32_t workers);

  /// Renders a state and explains its pick. Problems are in Picture::error; nothing is thrown.
  /// `previous` saves the rendering if its pixels are those of the state; may be null. `tiles` gets the finished tiles
  /// of colour planes; may be null.
  Picture show(const State& state, const shd_progress& progress, const Picture* previous, Tiles* tiles = nullptr);

  /// Displays and views of libshd_color, as "display / view"; empty without it.
  const std::vector<Display>& displays() const { return displays_; }

 private:
  /// Materials, samplers and draws of one side.
  struct Look {
    std::vector<std::vector<shd::sampler>> samplers;  // by surface and slot; null for slots without texture
    std::vector<shd::material> materials;             // by surface
    std::vector<shd_draw> draws;                      // by part
    bool over_pi = false;                             // the reflectance model divides by pi
  };

  void prepare(const State& state);
  std::shared_ptr<const Image> render(const State& state, int side, const shd_progress& progress, Tiles* tiles);
  void explain_pick(const State& state, Explanation& explanation) const;
  void explain_surface(const Look& look, const SurfaceAsset& surface, size_t index, const Lookup& lookup,
                       Explanation& explanation) const;
  Look make_look(const Side& side) const;
  shd::material make_material(const Side& side, shd_model model, const SurfaceAsset& surface, Look& look) const;
  shd_render_desc make_frame(const State& state, const Side& side, const Look& look) const;
  void encode(const State& state, const Side& side, const shd_framebuffer* framebuffer, Image& image) const;

  shd::context context_;
  std::optional<Content> content_;  // content of assets_
  shd_table_flags tables_ = SHD_TABLE_NONE;
  Assets assets_;
  Lights lights_;
  shd::framebuffer framebuffers_[2];
  std::vector<Display> displays_;
#ifdef VIEWER_WITH_COLOR
  shd::color color_;
#endif
};

}  // namespace viewer
