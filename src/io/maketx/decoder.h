// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

// The input is decoded by a second process of this program, the decoder. Its descriptor 0 is a stream to the first
// process, which checks all that it receives: hostile bytes may have taken over the decoder.
//   first process: DecodeFile
//   decoder:       Piece of kDescription and a Description
//   first process: DecodeRows
//   decoder:       Pieces of kRows with rows of the image, from the top, until all of them are sent
// Instead of any piece, the decoder may send a Piece of kError and a text; then it ends.

/// The only argument of the decoder.
constexpr const char* kDecoderArgument = "--decoder";

/// The attribute of an output that has the checksum of its input and options, for -u.
constexpr const char* kKeyAttribute = "shd:key";

struct DecodeFile {
  uint64_t memory;  // limit of the decoder, in addition to its libraries [bytes]
  int32_t threads;  // 0 = one per core
  char path[4096];
};

/// Description of the file by OpenImageIO. No field is valid before it has been checked.
struct Description {
  int32_t width, height, depth, x, y, full_x, full_y, full_width, full_height;
  int32_t tile_width, tile_height, channels, alpha, base_type;
  uint32_t deep, straight;
  char color_space[64];
  char key[32];        // kKeyAttribute of a file of shd-maketx
  char names[4][256];  // names of the first channels
};

struct DecodeRows {
  int32_t channels, base_type;
  uint32_t step;  // rows of a piece
};

enum class PieceKind : uint32_t { kDescription, kRows, kError };

struct Piece {
  PieceKind kind;
  uint32_t count;  // rows, or bytes of the text
};

/// Longest text of an error [bytes].
constexpr uint32_t kMaxErrorText = 1024;

/// Runs the decoder. Returns its exit status.
int run_decoder();
