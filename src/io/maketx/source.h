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
#include "io/maketx/color.h"
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
  std::string color_space;  // "sRGB", "Linear", or that of --colorconvert
  int64_t changed = 0;      // time of the last change of the file [ns]

  bool operator==(const Image& other) const {
    return width == other.width && height == other.height && channels == other.channels &&
           component == other.component && alpha == other.alpha && straight == other.straight && names == other.names &&
           color_space == other.color_space && changed == other.changed;
  }
  size_t pixel_size() const { return shd::image::format_info(channels, component).pixel_size; }
  size_t row_size() const { return width * pixel_size(); }
};

/// A regular file that is not empty.
struct FileState {
  uint64_t bytes = 0;
  int64_t changed = 0;  // time of the last change [ns]
};

/// The state of an input. Throws Failure (kExitInput).
FileState file_state(const std::string& path);

/// Ends the run of a file that takes longer than --time-limit. Throws Failure (kExitFailed).
void check_time(const shd::io::Deadline& end);

/// The rows of an image, from the top.
class Rows {
 public:
  virtual ~Rows() = default;
  virtual const Image& image() const = 0;
  /// Rows that are in memory beside those that read() fills.
  virtual uint32_t step() const = 0;
  /// Reads the next `count` rows.
  virtual void read(uint32_t count, uint8_t* out) = 0;
};

/// The input, which a decoder reads in another process. Throws Failure: kExitInput for what cannot be read or
/// converted, also if the decoder dies or stops; kExitFailed after --time-limit.
class Source : public Rows {
 public:
  /// @param end        end of the run
  /// @param converter  null = no conversion of colours
  Source(const Options& options, const shd::io::Deadline& end, const Converter* converter);
  const Image& image() const override { return image_; }
  uint32_t step() const override { return step_; }
  void read(uint32_t count, uint8_t* out) override;
  /// The key of the file that an earlier run has made, "" if it has none or cannot be read.
  static std::string stored_key(const Options& options, const std::string& path);

 private:
  Source(const Options& options, const shd::io::Deadline& end, const std::string& path);
  struct Process {
    pid_t pid = 0;
    ~Process() { shd::io::kill_process(pid); }
  };
  void start();
  Description receive_description();
  void read_wire(uint32_t count, uint8_t* out);
  void convert(const float* row, uint8_t* out) const;
  size_t wire_row() const;
  void describe(const Description& file);
  void choose_encoding(const std::string& said, const char* type);
  void choose_converted();
  void choose_names(const Description& file);
  void choose_step(uint32_t tile_height);
  [[noreturn]] void refuse(const std::string& what) const;
  [[noreturn]] void refuse_end(shd::io::Stream stream);
  void send(const void* bytes, size_t size);
  void receive(void* bytes, size_t size);
  uint32_t receive_piece(PieceKind wanted, uint32_t most);
  shd::io::Deadline deadline() const;

  const Options& options_;
  const std::string path_;
  const shd::io::Deadline& end_;
  const Converter* const converter_ = nullptr;
  FileState state_;
  Image image_;
  uint32_t step_ = 1;
  Process decoder_;
  shd::io::FileDescriptor socket_;
  uint32_t piece_ = 0;  // rows of the current piece that have not been read
  uint32_t left_ = 0;   // rows of the image that no piece has announced
};
