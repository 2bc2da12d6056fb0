// SPDX-License-Identifier: MIT
#pragma once
#include <OpenImageIO/imageio.h>
#include <sys/types.h>

#include <cstdint>
#include <string>
#include <vector>

#include "image/format.h"
#include "io/file/file_descriptor.h"
#include "io/file/limits.h"
#include "io/maketx/decoder.h"
#include "io/maketx/options.h"
#include "io/worker/child_process.h"
#include "io/worker/packet.h"

/// Description of the image that the output consists of.
struct Image {
  uint32_t width = 0, height = 0, channels = 0;
  shd::image::Component component = shd::image::Component::kUnorm8;
  OIIO::TypeDesc type;    // type of rows in memory and of the output
  int alpha = -1;         // channel, -1 = none
  bool straight = false;  // alpha is not multiplied into the colour
  std::vector<std::string> names;
  uint64_t file_bytes = 0;
  int64_t changed = 0;  // time of the last change [ns]

  size_t pixel_size() const { return shd::image::format_info(channels, component).pixel_size; }
  size_t row_size() const { return width * pixel_size(); }
};

/// The input, which a decoder reads in another process. Throws Failure: kExitInput for what cannot be read or
/// converted, also if the decoder dies or stops; kExitFailed after --time-limit.
class Source {
 public:
  explicit Source(const Options& options);
  const Image& image() const { return image_; }
  /// Rows that the decoder has in memory.
  uint32_t step() const { return step_; }
  /// Reads the next `count` rows.
  void read(uint32_t count, uint8_t* out);
  /// Ends a run that takes longer than --time-limit.
  void check_time() const;

 private:
  struct Process {
    pid_t pid = 0;
    ~Process() { shd::io::kill_process(pid); }
  };
  void start();
  void describe(const Description& file);
  void choose_encoding(const std::string& said, const char* type);
  void choose_names(const Description& file);
  void choose_step(uint32_t tile_height);
  [[noreturn]] void refuse(const std::string& what) const;
  [[noreturn]] void refuse_end(shd::io::Stream stream);
  void send(const void* bytes, size_t size);
  void receive(void* bytes, size_t size);
  uint32_t receive_piece(PieceKind wanted, uint32_t most);
  shd::io::Deadline deadline() const;

  const Options& options_;
  const shd::io::Deadline end_;  // end of the run
  Image image_;
  uint32_t step_ = 1;
  Process decoder_;
  shd::io::FileDescriptor socket_;
  uint32_t piece_ = 0;  // rows of the current piece that have not been read
  uint32_t left_ = 0;   // rows of the image that no piece has announced
};
