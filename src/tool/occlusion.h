// SPDX-License-Identifier: MIT
#pragma once

#include "tool/model.h"

/// Attribute of the meshes that holds the occlusion, after the colours of vertices.
constexpr uint32_t kOcclusionAttribute = 4;

/// Replaces the mesh of each instance by a copy with ambient occlusion at its vertices, which all instances cause.
void add_occlusion(shd_context* context, const Options& options, const Bounds& bounds, Model& model);
