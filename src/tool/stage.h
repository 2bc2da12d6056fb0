// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "tool/camera.h"
#include "tool/draws.h"
#include "tool/environment.h"
#include "tool/picture.h"
#include "tool/volumes.h"

/// The poses of the pictures.
struct Poses {
  Animation animation;
  std::vector<double> times;  // [s]; empty = the pose of the file
};

/// Objects that the pictures of one setting of the options share.
struct Stage {
  shd_context* context = nullptr;
  Options options;
  StageVolume volume;
  Model model;  // in the pose of the picture
  Poses poses;
  Model all;  // the box around all poses; no geometry if there is one pose
  Bounds bounds;
  shd_slot uv = shd_slot_default();  // the coordinates of the textures of the options
  Paint paint;
  Framebuffer framebuffer;
  Environment environment;
};

/// A picture: where it is seen from, and what is drawn.
struct Frame {
  Camera camera;
  Draws draws;
};

/// Loads all that the options name. Throws Failure.
/// @param reports  whether report_model() is called
Stage open_stage(shd_context* context, const Options& options, bool reports);

/// Prepares one of several pictures, counted from 0.
Frame make_frame(Stage& stage, uint32_t picture, uint32_t pictures);

/// Draws a frame to the framebuffer of the stage. The options may differ from those of the stage in their lights.
void render(const Stage& stage, const Options& options, const Frame& frame, const shd_progress& progress);
