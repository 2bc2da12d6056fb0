// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstring>
#include <string_view>

#include "scene/read/gltf_decode.h"
#include "scene/read/gltf_document.h"

namespace shd::scene {
namespace gltf {
namespace {

constexpr int kMaxJsonDepth = 128;
constexpr uint64_t kMaxJsonValues = uint64_t{1} << 23;
constexpr uint32_t kJsonChunk = 0x4e4f534a, kBinaryChunk = 0x004e4942;

/// Extensions that the reader honours. Warnings name the members of them that it leaves out.
/// KHR_texture_basisu is not among them.
constexpr const char* kHonoured[] = {
    "EXT_mesh_gpu_instancing",
    "EXT_texture_webp",
    "KHR_lights_punctual",
    "KHR_materials_clearcoat",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_pbrSpecularGlossiness",
    "KHR_materials_specular",
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_materials_variants",
    "KHR_mesh_quantization",
    "KHR_texture_transform",
    "MSFT_texture_dds",
};

uint32_t word_at(const unsigned char* at) {
  return static_cast<uint32_t>(at[0]) | static_cast<uint32_t>(at[1]) << 8 | static_cast<uint32_t>(at[2]) << 16 |
         static_cast<uint32_t>(at[3]) << 24;
}

bool is_binary(Bytes bytes) {
  return bytes.size >= 4 && std::memcmp(bytes.data, "glTF", 4) == 0;
}

/// The text without a byte order mark and blanks before it.
std::string_view text_of_bytes(Bytes bytes) {
  std::string_view text(reinterpret_cast<const char*>(bytes.data), bytes.size);
  if (text.substr(0, 3) == "\xef\xbb\xbf") text.remove_prefix(3);
  const size_t start = text.find_first_not_of(" \t\r\n");
  return start == std::string_view::npos ? std::string_view() : text.substr(start);
}

/// Whether the object "asset" has a version 1. Its text is not parsed yet.
bool is_version_1(std::string_view asset) {
  asset = asset.substr(0, asset.find('}'));
  const size_t name = asset.find("\"version\"");
  if (name == std::string_view::npos) return false;
  const size_t value = asset.find_first_not_of(" \t\r\n:\"", name + 9);
  return value != std::string_view::npos && asset.substr(value, 2) == "1.";
}

/// Section 4.4. Returns the chunk of JSON.
std::string_view split_binary(Document& document) {
  const Bytes bytes = document.source.bytes;
  if (bytes.size < 20) core::refuse(SHD_ERROR_CORRUPT, "binary glTF: %zu bytes have no header", bytes.size);
  const uint32_t version = word_at(bytes.data + 4), length = word_at(bytes.data + 8);
  if (version != 2) core::refuse(SHD_ERROR_UNSUPPORTED, "binary glTF: version %u is not 2", version);
  if (length > bytes.size) {
    core::refuse(SHD_ERROR_CORRUPT, "binary glTF: the header says %u bytes, the file has %zu", length, bytes.size);
  }
  std::string_view json;
  for (size_t at = 12; at + 8 <= length;) {
    const uint32_t size = word_at(bytes.data + at), kind = word_at(bytes.data + at + 4);
    at += 8;
    if (size > length - at) core::refuse(SHD_ERROR_CORRUPT, "binary glTF: a chunk of %u bytes is cut", size);
    if (kind == kJsonChunk && json.empty()) json = {reinterpret_cast<const char*>(bytes.data + at), size};
    if (kind == kBinaryChunk && !document.binary.data) document.binary = {bytes.data + at, size};
    at += size;
  }
  while (!json.empty() && json.back() == '\0') json.remove_suffix(1);
  return json;
}

/// Parses within budgets of depth and values: a value takes up to a hundred bytes, even if its text has two.
Json parse(std::string_view text, const Deadline& deadline) {
  uint64_t values = 0;
  const auto count = [&](int depth, Json::parse_event_t, Json&) {
    if (depth > kMaxJsonDepth) core::refuse(SHD_ERROR_LIMIT, "JSON: nested more than %d deep", kMaxJsonDepth);
    if (++values > kMaxJsonValues)
      core::refuse(SHD_ERROR_LIMIT, "JSON: more than %llu values", static_cast<unsigned long long>(kMaxJsonValues));
    if (values % 4096 == 0) deadline.check();
    return true;
  };
  try {
    return Json::parse(text.begin(), text.end(), count);
  } catch (const Json::exception& error) {
    const std::string what = text_of(error.what());
    const size_t start = what.find("] ");
    core::refuse(SHD_ERROR_CORRUPT, "JSON: %s", what.c_str() + (start == std::string::npos ? 0 : start + 2));
  }
}

/// Collects the names of all extensions below a value. `extras` belong to applications.
void collect_extensions(const Json& value, std::set<std::string>& names) {
  if (value.is_object()) {
    for (const auto& item : value.items()) {
      if (item.key() == "extensions" && item.value().is_object()) {
        for (const auto& extension : item.value().items()) names.insert(extension.key());
      }
      if (item.key() != "extras") collect_extensions(item.value(), names);
    }
  } else if (value.is_array()) {
    for (const Json& element : value) collect_extensions(element, names);
  }
}

/// Section 3.12.
void check_extensions(Document& document) {
  std::string missing;
  const Part required = document.root["extensionsRequired"], used = document.root["extensionsUsed"];
  for (size_t i = 0; i < required.size(); ++i) {
    const std::string name = required.at(i).text();
    if (!honours(name)) missing += (missing.empty() ? "" : ", ") + name;
  }
  if (!missing.empty()) {
    core::refuse(SHD_ERROR_UNSUPPORTED, "required extensions are not supported: %s", text_of(missing).c_str());
  }
  std::set<std::string> names;
  collect_extensions(document.json, names);
  for (size_t i = 0; i < used.size(); ++i) names.insert(used.at(i).text());
  for (const std::string& name : names) {
    if (!honours(name)) document.warnings.add("extension " + text_of(name) + " is ignored");
  }
}

void check_version(const Part& root) {
  const Part asset = root["asset"];
  if (!asset) root.refuse("has no asset");
  const std::string version = asset.text("version"), least = asset.text("minVersion");
  if (version.rfind("2.", 0) != 0 || (!least.empty() && least != "2.0")) {
    core::refuse(SHD_ERROR_UNSUPPORTED, "asset.version: \"%s\" is not 2.0",
                 text_of(least.empty() ? version : least).c_str());
  }
}

void warn_about_variants(Document& document) {
  const Part variants = document.root.extension("KHR_materials_variants")["variants"];
  if (variants.size() == 0) return;
  std::string others = "the default";
  for (size_t i = 1; i < variants.size(); ++i) others += ", \"" + name_of(variants.at(i)) + "\"";
  document.warnings.add("KHR_materials_variants: \"" + name_of(variants.at(0)) + "\" is drawn, not " + text_of(others));
}

}  // namespace

bool honours(const std::string& name) {
  if (name == "KHR_draco_mesh_compression") return kHasDraco;
  if (name == "EXT_meshopt_compression" || name == "KHR_meshopt_compression") return kHasMeshopt;
  return std::find(std::begin(kHonoured), std::end(kHonoured), name) != std::end(kHonoured);
}

std::string name_of(const Part& part) {
  const Part name = part["name"];
  const bool named = name && name.json()->is_string() && !name.json()->get_ref<const std::string&>().empty();
  return named ? text_of(name.text()) : part.where();
}

std::string title_of(const char* kind, const Part& part) {
  return std::string(kind) + " \"" + name_of(part) + "\"";
}

}  // namespace gltf

bool is_gltf(const Source& source) {
  if (gltf::is_binary(source.bytes)) return source.bytes.size < 8 || gltf::word_at(source.bytes.data + 4) != 1;
  const std::string_view text = gltf::text_of_bytes(source.bytes);
  if (text.empty() || text[0] != '{') return false;
  const size_t asset = text.find("\"asset\"");
  return asset != std::string_view::npos && !gltf::is_version_1(text.substr(asset));
}

Model read_gltf(const Source& source) {
  gltf::Document document(source);
  const bool binary = gltf::is_binary(source.bytes);
  const std::string_view text = binary ? gltf::split_binary(document) : gltf::text_of_bytes(source.bytes);
  document.json = gltf::parse(text, source.deadline);
  gltf::check_version(document.root);
  gltf::check_extensions(document);
  gltf::warn_about_variants(document);
  gltf::add_surfaces(document);
  const std::vector<int32_t> node_of = gltf::add_nodes(document);
  if (document.model.placements.empty()) refuse_empty(document.model);
  gltf::add_animations(document, node_of);
  return std::move(document.model);
}

}  // namespace shd::scene
