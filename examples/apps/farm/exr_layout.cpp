// SPDX-License-Identifier: MIT
#include "exr_layout.h"

#include <algorithm>
#include <cstring>

namespace farm {
namespace {

constexpr uint64_t kChunkHead = 20, kPixel = 8;

// Files are little-endian. The program refuses machines of the other order in main().
template <class T>
void put(std::vector<char>* out, T value) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof value);
  out->insert(out->end(), bytes, bytes + sizeof bytes);
}

void put_text(std::vector<char>* out, const std::string& text) {
  out->insert(out->end(), text.begin(), text.end());
  out->push_back('\0');
}

void put_attribute(std::vector<char>* out, const char* name, const char* type, const std::vector<char>& value) {
  put_text(out, name);
  put_text(out, type);
  put(out, static_cast<int32_t>(value.size()));
  out->insert(out->end(), value.begin(), value.end());
}

template <class... T>
std::vector<char> values(T... value) {
  std::vector<char> bytes;
  (put(&bytes, value), ...);
  return bytes;
}

std::vector<char> channel_list() {
  std::vector<char> bytes;
  for (const char* name : {"A", "B", "G", "R"}) {
    put_text(&bytes, name);
    put(&bytes, int32_t{1});  // half
    put(&bytes, int32_t{0});  // not perceptually linear, reserved
    put(&bytes, int32_t{1}), put(&bytes, int32_t{1});
  }
  bytes.push_back('\0');
  return bytes;
}

std::vector<char> make_header(uint32_t width, uint32_t height, uint32_t edge, const std::string& identity) {
  std::vector<char> out;
  const auto box = values(int32_t{0}, int32_t{0}, static_cast<int32_t>(width - 1), static_cast<int32_t>(height - 1));
  put(&out, int32_t{20000630});   // magic number
  put(&out, int32_t{2 | 0x200});  // version, one part of tiles
  put_attribute(&out, "channels", "chlist", channel_list());
  put_attribute(&out, "compression", "compression", {'\0'});
  put_attribute(&out, "dataWindow", "box2i", box);
  put_attribute(&out, "displayWindow", "box2i", box);
  put_attribute(&out, "lineOrder", "lineOrder", {'\0'});
  put_attribute(&out, "pixelAspectRatio", "float", values(1.0f));
  put_attribute(&out, "screenWindowCenter", "v2f", values(0.0f, 0.0f));
  put_attribute(&out, "screenWindowWidth", "float", values(1.0f));
  put_attribute(&out, "shdFarm", "string", {identity.begin(), identity.end()});
  put_attribute(&out, "tiles", "tiledesc", values(edge, edge, char{0}));
  out.push_back('\0');
  return out;
}

}  // namespace

Layout make_layout(uint32_t width, uint32_t height, uint32_t edge, const std::string& identity) {
  Layout layout;
  layout.width = width, layout.height = height, layout.edge = edge;
  layout.columns = (width + edge - 1) / edge;
  layout.rows = (height + edge - 1) / edge;
  layout.header = make_header(width, height, edge, identity);
  return layout;
}

uint32_t window_count(const Layout& layout) {
  return layout.columns * layout.rows;
}

Window window_at(const Layout& layout, uint32_t index) {
  const uint32_t x = index % layout.columns * layout.edge, y = index / layout.columns * layout.edge;
  return {x, y, std::min(layout.edge, layout.width - x), std::min(layout.edge, layout.height - y)};
}

uint64_t chunk_size(const Layout& layout, uint32_t index) {
  const Window window = window_at(layout, index);
  return kChunkHead + kPixel * window.width * window.height;
}

uint64_t chunk_offset(const Layout& layout, uint32_t index) {
  // All tiles before this row cover whole rows of pixels; the tiles to the left are as high as this one.
  const Window window = window_at(layout, index);
  const uint64_t pixels = uint64_t{window.y} * layout.width + uint64_t{window.x} * window.height;
  return layout.header.size() + uint64_t{8} * window_count(layout) + kChunkHead * index + kPixel * pixels;
}

uint64_t file_size(const Layout& layout) {
  const uint32_t last = window_count(layout) - 1;
  return chunk_offset(layout, last) + chunk_size(layout, last);
}

std::vector<char> file_head(const Layout& layout) {
  std::vector<char> head = layout.header;
  for (uint32_t i = 0; i < window_count(layout); ++i) put(&head, chunk_offset(layout, i));
  return head;
}

void encode_chunk(const Layout& layout, uint32_t index, const Pixels& pixels, std::vector<char>* chunk) {
  const Window window = window_at(layout, index);
  chunk->resize(chunk_size(layout, index));
  const int32_t head[5] = {static_cast<int32_t>(index % layout.columns), static_cast<int32_t>(index / layout.columns),
                           0, 0, static_cast<int32_t>(chunk->size() - kChunkHead)};
  std::memcpy(chunk->data(), head, sizeof head);
  char* out = chunk->data() + kChunkHead;
  std::vector<uint16_t> line(window.width);
  for (uint32_t y = 0; y < window.height; ++y) {
    const uint16_t* row = pixels.halves + y * pixels.row_stride;
    for (int channel = 3; channel >= 0; --channel) {  // A, B, G, R
      for (uint32_t x = 0; x < window.width; ++x) line[x] = row[4 * x + static_cast<uint32_t>(channel)];
      std::memcpy(out, line.data(), line.size() * sizeof(uint16_t));
      out += line.size() * sizeof(uint16_t);
    }
  }
}

uint64_t checksum(const void* data, size_t size, uint64_t seed) {
  constexpr uint64_t kOdd = 0x9e3779b97f4a7c15u;
  const char* bytes = static_cast<const char*>(data);
  uint64_t sum = seed ^ size * kOdd;
  for (size_t i = 0; i < size; i += 8) {
    uint64_t word = 0;
    std::memcpy(&word, bytes + i, std::min<size_t>(8, size - i));
    sum = (sum ^ word) * kOdd;
    sum ^= sum >> 29;
  }
  return sum;
}

}  // namespace farm
