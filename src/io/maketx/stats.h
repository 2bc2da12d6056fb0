// SPDX-License-Identifier: MIT
#pragma once
#include <OpenImageIO/hash.h>

#include <memory>
#include <string>
#include <vector>

#include "io/maketx/source.h"
#include "texture/format/texel_codec.h"

/// Hash and mean colour of level 0, which maketx of OpenImageIO stores, too. Both are of the stored numbers.
class Stats {
 public:
  /// @param extra  text for the hash, which differs where the other levels differ
  Stats(const Options& options, const Image& image, std::string extra);
  /// Adds the next rows. Throws Failure (kExitInput) for the first number that --checknan refuses.
  void add(const uint8_t* rows, uint32_t count);
  /// After all rows: SHA-1 of the digests of blocks of 256 rows, as computePixelHashSHA1() of OpenImageIO 2.4.
  std::string hash();
  /// Numbers with commas between them. Numbers that are not finite do not count.
  std::string average() const;
  /// The colour of all pixels, "" if they differ.
  std::string constant() const;

 private:
  void add_row(const uint8_t* row);
  void end_block();
  void add_to_constant(const uint8_t* row);

  const Options& options_;
  const Image& image_;
  const shd::texture::TexelCodec& codec_;
  std::string extra_, digests_;
  std::unique_ptr<OIIO::SHA1> block_ = std::make_unique<OIIO::SHA1>();
  uint32_t y_ = 0;
  double sum_[4] = {};
  uint64_t count_[4] = {};
  std::vector<uint8_t> first_;  // the first pixel; empty after a different one
};
