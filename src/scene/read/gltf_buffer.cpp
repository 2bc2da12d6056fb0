// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <cstring>

#include "scene/read/gltf_decode.h"
#include "scene/read/gltf_document.h"
#include "scene/text.h"

namespace shd::scene::gltf {
namespace {

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  const int letter = std::tolower(static_cast<unsigned char>(c));
  return letter >= 'a' && letter <= 'f' ? letter - 'a' + 10 : -1;
}

/// RFC 3986, section 2.1. A '%' without two digits stays.
std::string percent_decoded(const std::string& text) {
  std::string out;
  out.reserve(text.size());
  for (size_t i = 0; i < text.size(); ++i) {
    const bool coded = text[i] == '%' && i + 2 < text.size();
    const int high = coded ? hex_digit(text[i + 1]) : -1, low = coded ? hex_digit(text[i + 2]) : -1;
    if (high < 0 || low < 0) {
      out.push_back(text[i]);
    } else {
      out.push_back(static_cast<char>(16 * high + low));
      i += 2;
    }
  }
  return out;
}

/// RFC 4648, section 4. Blanks and line ends are skipped; the padding may be absent.
void decode_base64(const Part& uri, const char* at, const char* end, std::vector<unsigned char>& out) {
  out.reserve(static_cast<size_t>(end - at) / 4 * 3 + 3);
  uint32_t bits = 0;
  int count = 0;
  for (; at < end && *at != '='; ++at) {
    const char c = *at;
    const int value = c >= 'A' && c <= 'Z'   ? c - 'A'
                      : c >= 'a' && c <= 'z' ? c - 'a' + 26
                      : c >= '0' && c <= '9' ? c - '0' + 52
                      : c == '+' || c == '-' ? 62
                      : c == '/' || c == '_' ? 63
                                             : -1;
    if (value < 0 && std::isspace(static_cast<unsigned char>(c))) continue;
    if (value < 0) uri.refuse("has a character that is not of base64");
    bits = bits << 6 | static_cast<uint32_t>(value);
    if ((count += 6) >= 8) out.push_back(static_cast<unsigned char>(bits >> (count -= 8)));
  }
}

/// The scheme of a URI; empty for a relative reference. One letter is the drive of a Windows path.
std::string scheme_of(const std::string& uri) {
  const size_t end = uri.find(':');
  if (end == std::string::npos || end < 2 || !std::isalpha(static_cast<unsigned char>(uri[0]))) return {};
  for (size_t i = 1; i < end; ++i) {
    if (!std::isalnum(static_cast<unsigned char>(uri[i])) && !std::strchr("+-.", uri[i])) return {};
  }
  return uri.substr(0, end);
}

Bytes load_buffer(Document& document, const Part& buffer, uint32_t index) {
  const Part uri = buffer["uri"];
  if (!uri) {
    if (index != 0 || !document.binary.data) buffer.refuse("has neither a uri nor a chunk of a binary file");
    return document.binary;
  }
  if (std::optional<std::vector<unsigned char>> data = read_data_uri(document, uri)) {
    document.made.push_back(std::move(*data));
    return {document.made.back().data(), document.made.back().size()};
  }
  const std::string name = file_of_uri(document, uri.text());
  if (name.empty()) uri.refuse("a URI of this scheme is not read: " + text_of(uri.text()), SHD_ERROR_UNSUPPORTED);
  const Bytes* bytes = document.source.files.find(name);
  if (!bytes) uri.refuse("cannot open \"" + name + "\"", SHD_ERROR_NOT_FOUND);
  return *bytes;
}

/// The bytes of a buffer, at most byteLength.
Bytes buffer_bytes(Document& document, uint32_t index) {
  const Part buffers = document.root["buffers"];
  if (document.buffers.empty()) document.buffers.resize(buffers.size());
  std::optional<Bytes>& known = document.buffers.at(index);
  if (!known) {
    const Part buffer = buffers.at(index);
    Bytes bytes = load_buffer(document, buffer, index);
    const uint64_t length = buffer.required_integer("byteLength");
    bytes.size = static_cast<size_t>(std::min<uint64_t>(bytes.size, length));
    known = bytes;
  }
  return *known;
}

/// The range of a buffer that `view` names.
Bytes range_of(Document& document, const Part& view) {
  const std::optional<uint32_t> index = view.index("buffer", document.root["buffers"].size());
  if (!index) view.refuse("has no buffer");
  const uint64_t offset = view.integer("byteOffset", 0), length = view.required_integer("byteLength");
  const Bytes bytes = buffer_bytes(document, *index);
  if (offset > bytes.size || length > bytes.size - offset) {
    view.refuse("bytes " + std::to_string(offset) + " to " + std::to_string(offset + length) + " lie outside buffers[" +
                std::to_string(*index) + "], which has " + std::to_string(bytes.size));
  }
  return {bytes.data + offset, static_cast<size_t>(length)};
}

struct Named {
  const char* name;
  int value;
};

/// The value of a row with this name.
template <class Value, size_t n>
Value choose(const Part& from, const char* member, const Named (&rows)[n], const char* fallback) {
  const std::string text = from[member] ? from.text(member) : fallback;
  for (const Named& row : rows) {
    if (text == row.name) return static_cast<Value>(row.value);
  }
  from.refuse(std::string(member) + " \"" + text + "\" is not supported", SHD_ERROR_UNSUPPORTED);
}

constexpr Named kModes[] = {{"ATTRIBUTES", static_cast<int>(MeshoptMode::kAttributes)},
                            {"TRIANGLES", static_cast<int>(MeshoptMode::kTriangles)},
                            {"INDICES", static_cast<int>(MeshoptMode::kIndices)}};
constexpr Named kFilters[] = {{"NONE", static_cast<int>(MeshoptFilter::kNone)},
                              {"OCTAHEDRAL", static_cast<int>(MeshoptFilter::kOctahedral)},
                              {"QUATERNION", static_cast<int>(MeshoptFilter::kQuaternion)},
                              {"EXPONENTIAL", static_cast<int>(MeshoptFilter::kExponential)}};

Bytes decompressed(Document& document, const Part& compressed) {
  const uint64_t count = compressed.required_integer("count"), stride = compressed.required_integer("byteStride", 256);
  const auto mode = choose<MeshoptMode>(compressed, "mode", kModes, "");
  const auto filter = choose<MeshoptFilter>(compressed, "filter", kFilters, "NONE");
  const Bytes bytes = range_of(document, compressed);
  // The codecs need at least a bit for each element, or a byte for 16 vertices.
  if (count > 128 * (static_cast<uint64_t>(bytes.size) + 1))
    compressed.refuse("has more elements than its bytes can code");
  std::vector<unsigned char>& out = make_bytes(document, count * stride);
  try {
    decode_meshopt(bytes, mode, filter, static_cast<size_t>(count), static_cast<size_t>(stride), out.data());
  } catch (const core::Failure& failure) {
    compressed.refuse(failure.what(), failure.code);
  }
  return {out.data(), out.size()};
}

}  // namespace

void spend_bytes(Document& document, uint64_t size) {
  const uint64_t limit = document.source.limits.file_bytes;
  if (size <= limit - document.made_bytes) {
    document.made_bytes += size;
    return;
  }
  core::refuse(SHD_ERROR_LIMIT, "%llu more decoded bytes are above scene.max_file_bytes %llu",
               static_cast<unsigned long long>(size), static_cast<unsigned long long>(limit));
}

std::vector<unsigned char>& make_bytes(Document& document, uint64_t size) {
  spend_bytes(document, size);
  return document.made.emplace_back(static_cast<size_t>(size));
}

std::string file_of_uri(Document& document, const std::string& uri) {
  if (!scheme_of(uri).empty()) return {};
  // Some writers encode nothing, so that '?', '#' and '%' are characters of the name.
  const std::string names[] = {percent_decoded(uri.substr(0, uri.find_first_of("?#"))), percent_decoded(uri), uri};
  if (names[0] == uri) return uri;
  for (const std::string& name : names) {
    if (!name.empty() && document.source.files.find(name)) return name;
  }
  return names[0].empty() ? uri : names[0];
}

std::optional<std::vector<unsigned char>> read_data_uri(Document& document, const Part& uri) {
  const std::string text = uri.text();
  if (lower_case(text.substr(0, 5)) != "data:") return std::nullopt;
  const size_t comma = text.find(',');
  if (comma == std::string::npos) uri.refuse("has no comma");
  spend_bytes(document, text.size() - comma);
  std::vector<unsigned char> out;
  const std::string kind = lower_case(text.substr(5, comma - 5));
  const bool is_encoded = text.find('%', comma) != std::string::npos;
  const std::string plain = is_encoded ? percent_decoded(text.substr(comma + 1)) : text.substr(comma + 1);
  if (kind.size() >= 7 && kind.compare(kind.size() - 7, 7, ";base64") == 0) {
    decode_base64(uri, plain.data(), plain.data() + plain.size(), out);
  } else {
    out.assign(plain.begin(), plain.end());
  }
  return out;
}

Bytes view_bytes(Document& document, uint32_t index) {
  const Part views = document.root["bufferViews"];
  if (document.views.empty()) document.views.resize(views.size());
  const Part view = views.at(index);
  std::optional<Bytes>& known = document.views.at(index);
  if (known) return *known;
  Part compressed = view.extension("EXT_meshopt_compression");
  if (!compressed) compressed = view.extension("KHR_meshopt_compression");
  known = compressed && kHasMeshopt ? decompressed(document, compressed) : range_of(document, view);
  return *known;
}

}  // namespace shd::scene::gltf
