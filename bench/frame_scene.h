// SPDX-License-Identifier: MIT
#pragma once

#include "bench.h"
#include "workload.h"

/// The frames that rows of the rasteriser share, as objects of the library.
namespace shd::bench {

/// 8 x 256, 64 x 1,560 and 1,000 x 1,000 triangles.
const std::vector<Spheres>& sphere_frames();

/// Texels of every frame, kFrameTextureEdge x kFrameTextureEdge.
const std::vector<uint8_t>& frame_texels();

/// A step that a frame of spheres has in addition.
enum class Feature {
  kNone,
  kVertexProgram,  // moves each vertex
  kNormalMap,      // the texture as tangent-space normals
  kShadows,        // both points have maps of 1024 x 1024 texels on six faces, 3 x 3 taps, rendered before
  kLines           // edges of triangles, one pixel wide
};

/// Variant of a frame of spheres.
struct Variant {
  const char* name;
  uint32_t samples;
  bool shaded;
  shd_blend blend;
  shd_format color = SHD_FORMAT_RGBA32F;
  Feature feature = Feature::kNone;
};

/// Filter of the texture of a surface.
struct SurfaceFilter {
  shd_filter filter;
  shd_precision precision;
  SurfaceFilter(shd_filter of, shd_precision with = SHD_PRECISION_FULL) : filter(of), precision(with) {}
};

/// A scene with one mesh and one material, and its frame of kFrameEdge x kFrameEdge pixels.
class FrameScene {
 public:
  FrameScene(const Spheres& spheres, shd_simd simd, const Variant& variant, uint32_t workers = 1);
  /// Unlit, with a mipmapped texture.
  FrameScene(const Surface& surface, shd_simd simd, const SurfaceFilter& filter, shd_format color,
             uint32_t workers = 1);
  ~FrameScene();
  FrameScene(const FrameScene&) = delete;
  FrameScene& operator=(const FrameScene&) = delete;

  void render() { check(shd_render(context_, &desc_)); }
  const shd_render_stats& stats() const { return stats_; }
  shd_context* context() const { return context_; }
  const shd_render_desc& desc() const { return desc_; }
  std::vector<float> image() const;

 private:
  FrameScene(shd_simd simd, uint32_t samples, shd_format color, uint32_t workers);
  void make_mesh(const Spheres& spheres, Feature feature);
  void make_mesh(const Surface& surface);
  void make_material(const shd_material_desc& desc, Feature feature = Feature::kNone);
  void make_lights();
  void make_shadows();
  void set_draws();

  shd_context* context_;
  shd_texture* texture_ = nullptr;
  shd_sampler* sampler_ = nullptr;
  shd_mesh* mesh_ = nullptr;
  shd_material* material_ = nullptr;
  shd_light* lights_[2] = {};
  shd_shadow* shadows_[2] = {};
  shd_framebuffer* framebuffer_ = nullptr;
  std::vector<shd_draw> draws_;
  shd_render_stats stats_ = shd_render_stats_default();
  shd_render_desc desc_ = shd_render_desc_default();
};

}  // namespace shd::bench
