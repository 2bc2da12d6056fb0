// SPDX-License-Identifier: MIT
#pragma once

#include "core/context.h"
#include "film/framebuffer.h"

namespace shd::film {

/// Planes of colour for a framebuffer with interleaved pixels while it is drawn in several passes or from a larger
/// picture: the passes add to linear floats, and the pixels are encoded once, at the end. Nothing changes for a
/// framebuffer with planes.
class ExpandedColor {
 public:
  /// Decodes the pixels. Throws std::bad_alloc.
  ExpandedColor(const core::Context& context, Framebuffer* framebuffer);
  /// Encodes the pixels.
  ~ExpandedColor();
  ExpandedColor(const ExpandedColor&) = delete;
  ExpandedColor& operator=(const ExpandedColor&) = delete;

 private:
  const core::Context& context_;
  Framebuffer& framebuffer_;
  const shd_format format_;
};

}  // namespace shd::film
