// SPDX-License-Identifier: MIT
/// @file
/// Mattes of objects and materials: "Cryptomatte Specification", version 1.2.0 (Psyop, 2018), after Friedman and Jones,
/// "Fully Automatic ID Mattes with Support for Motion Blur and Transparency" (2015).
#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "tool/draws.h"
#include "tool/output.h"

/// MurmurHash3_x86_32 of seed 0 (Appleby, SMHasher).
uint32_t murmur_hash(std::string_view bytes);

/// The bits of the float that is the id of a name: its hash with an exponent that is neither 0 nor 255.
uint32_t matte_id(std::string_view name);

/// One Cryptomatte of a picture.
struct MatteSet {
  std::string name;                                        // "CryptoObject"
  std::vector<std::pair<std::string, std::string>> texts;  // attributes
  std::vector<std::pair<std::string, std::vector<float>>> channels;
};

struct Mattes {
  std::vector<MatteSet> sets;
  /// Their channels and texts, and the view. Borrows all.
  FileExtras extras(const shd_view& view) const;
};

/// Makes the mattes that the options name; none without them.
Mattes make_mattes(shd_context* context, const Options& options, const Model& model, const shd_view& view,
                   const Draws& draws);
