// SPDX-License-Identifier: MIT
#pragma once
#include <map>

#include "tool/check/case.h"
#include "tool/check/picture.h"
#include "tool/handles.h"

/// The texture of the command line, with each decoding that a case has, made at first use.
class Textures {
 public:
  /// Reads the files. Throws Failure.
  Textures(shd_context* context, const Options& options);

  /// The texture with a decoding. Throws Failure.
  const shd_texture* get(Decode decode);
  /// A texture of the same sizes in which each texel of level l is the number l.
  const shd_texture* level_numbers();

  shd_context* context() const { return context_; }
  const Picture& base() const { return pictures_.base; }
  bool is_cube() const { return options_.cube; }
  uint32_t level_count() const;

 private:
  Texture make(const Pictures& pictures) const;
  Pictures decoded(Decode decode) const;

  shd_context* context_;
  const Options options_;
  const Pictures pictures_;
  std::map<Decode, Texture> made_;
  Texture numbers_;
};
