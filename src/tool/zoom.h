// SPDX-License-Identifier: MIT
#pragma once
#include "tool/stage.h"

/// The pixels of `--zoom`, each as a square, with their samples as dots and the edges of the triangles.
/// @param picture  picture of the frame by show_frame()
Picture zoom_picture(const Stage& stage, const Frame& frame, const Picture& picture);
