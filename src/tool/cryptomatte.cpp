// SPDX-License-Identifier: MIT
#include "tool/cryptomatte.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <map>

#include "tool/samples.h"

namespace {

constexpr size_t kRanks = 6;  // "the suggested default value is 6 levels"

uint32_t rotate(uint32_t x, int bits) {
  return x << bits | x >> (32 - bits);
}

uint32_t scramble(uint32_t block) {
  return rotate(block * 0xcc9e2d51u, 15) * 0x1b873593u;
}

std::string hexadecimal(uint32_t bits) {
  char text[9];
  std::snprintf(text, sizeof text, "%08x", bits);
  return text;
}

/// Name of each draw; draws of one name have one id.
using Names = std::vector<std::string>;

/// Parts with one name and one place are one object. Others with that name get a number.
Names object_names(const Model& model, const Draws& draws) {
  std::map<std::string, std::vector<std::array<float, 16>>> places;
  Names names;
  for (const size_t index : draws.instance) {
    const Instance& instance = model.instances[index];
    const Geometry& geometry = model.geometries[instance.geometry];
    const std::string name = geometry.name.empty() ? "mesh" + std::to_string(instance.geometry) : geometry.name;
    std::vector<std::array<float, 16>>& known = places[name];
    const auto found = std::find(known.begin(), known.end(), instance.object_to_world);
    const auto number = found - known.begin() + 1;
    if (found == known.end()) known.push_back(instance.object_to_world);
    names.push_back(number == 1 ? name : name + "_" + std::to_string(number));
  }
  return names;
}

Names material_names(const Model& model, const Draws& draws) {
  Names names;
  for (size_t i = 0; i < draws.instance.size(); ++i) {
    const size_t surface = model.instances[draws.instance[i]].surface;
    const std::string& name = model.surfaces[surface].name;
    names.push_back(i >= draws.solid_count ? "lines" : name.empty() ? "material" + std::to_string(surface) : name);
  }
  return names;
}

/// A string of JSON. Names of models are printable.
std::string quoted(const std::string& name) {
  std::string text = "\"";
  for (const char c : name) text += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
  return text + "\"";
}

std::string manifest_of(const Names& names) {
  std::map<std::string, uint32_t> ids;
  for (const std::string& name : names) ids[name] = matte_id(name);
  std::string text;
  for (const auto& [name, id] : ids) text += (text.empty() ? "{" : ",") + quoted(name) + ":\"" + hexadecimal(id) + "\"";
  return text.empty() ? "{}" : text + "}";
}

struct Share {
  uint32_t id, count;
};

/// Ranks the ids of a pixel: by coverage, then by id.
void rank(std::vector<Share>& shares) {
  std::sort(shares.begin(), shares.end(), [](const Share& a, const Share& b) { return a.id < b.id; });
  size_t kept = 0;
  for (const Share& share : shares) {
    if (kept > 0 && shares[kept - 1].id == share.id) {
      shares[kept - 1].count += share.count;
    } else {
      shares[kept++] = share;
    }
  }
  shares.resize(kept);
  std::stable_sort(shares.begin(), shares.end(), [](const Share& a, const Share& b) { return a.count > b.count; });
}

void fill_channels(const Samples& samples, const Names& names, MatteSet& set) {
  const size_t pixels = samples.draw.size();
  for (size_t c = 0; c < 2 * kRanks; ++c) {
    const std::string layer = set.name + "0" + std::to_string(c / 4) + "." + "rgba"[c % 4];
    set.channels.push_back({layer, std::vector<float>(pixels)});
  }
  std::vector<uint32_t> ids;
  for (const std::string& name : names) ids.push_back(matte_id(name));
  const auto samples_of = static_cast<float>(samples.per_pixel);
  std::vector<Share> shares;
  size_t other = 0;
  for (size_t pixel = 0; pixel < pixels; ++pixel) {
    shares.clear();
    const auto add = [&](uint32_t draw, uint32_t count) {
      if (draw < ids.size()) shares.push_back({ids[draw], count});
    };
    add(samples.draw[pixel], samples.count[pixel]);
    for (; other < samples.others.size() && samples.others[other].pixel == pixel; ++other) {
      add(samples.others[other].draw, samples.others[other].count);
    }
    rank(shares);
    for (size_t r = 0; r < std::min(shares.size(), kRanks); ++r) {
      std::memcpy(&set.channels[2 * r].second[pixel], &shares[r].id, sizeof(float));
      set.channels[2 * r + 1].second[pixel] = static_cast<float>(shares[r].count) / samples_of;
    }
  }
}

MatteSet make_set(const std::string& name, const Samples& samples, const Names& names) {
  MatteSet set;
  set.name = name;
  const std::string key = "cryptomatte/" + hexadecimal(murmur_hash(name)).substr(0, 7) + "/";
  set.texts = {{key + "name", name},
               {key + "hash", "MurmurHash3_32"},
               {key + "conversion", "uint32_to_float32"},
               {key + "manifest", manifest_of(names)}};
  fill_channels(samples, names, set);
  return set;
}

}  // namespace

uint32_t murmur_hash(std::string_view bytes) {
  uint32_t hash = 0;
  const auto byte = [&](size_t i) { return static_cast<uint32_t>(static_cast<unsigned char>(bytes[i])); };
  size_t at = 0;
  for (; at + 4 <= bytes.size(); at += 4) {
    hash ^= scramble(byte(at) | byte(at + 1) << 8 | byte(at + 2) << 16 | byte(at + 3) << 24);
    hash = rotate(hash, 13) * 5 + 0xe6546b64u;
  }
  uint32_t rest = 0;
  for (size_t i = bytes.size(); i > at; --i) rest = rest << 8 | byte(i - 1);
  hash ^= scramble(rest);
  hash ^= static_cast<uint32_t>(bytes.size());
  hash = (hash ^ hash >> 16) * 0x85ebca6bu;
  hash = (hash ^ hash >> 13) * 0xc2b2ae35u;
  return hash ^ hash >> 16;
}

uint32_t matte_id(std::string_view name) {
  const uint32_t hash = murmur_hash(name), exponent = hash >> 23 & 255;
  return exponent == 0 || exponent == 255 ? hash ^ 1u << 23 : hash;
}

FileExtras Mattes::extras(const shd_view& view) const {
  FileExtras out;
  out.view = &view;
  for (const MatteSet& set : sets) {
    for (const auto& [name, text] : set.texts) out.attributes.push_back({name.c_str(), text.c_str()});
    for (const auto& [name, floats] : set.channels) {
      out.channels.push_back({name.c_str(), shd_f32_column(floats.data(), 0)});
    }
  }
  return out;
}

Mattes make_mattes(shd_context* context, const Options& options, const Model& model, const shd_view& view,
                   const Draws& draws) {
  Mattes mattes;
  if (options.mattes == kMatteNone) return mattes;
  const Samples samples = draw_samples(context, options, view, draws);
  if (options.mattes & kMatteObject) {
    mattes.sets.push_back(make_set("CryptoObject", samples, object_names(model, draws)));
  }
  if (options.mattes & kMatteMaterial) {
    mattes.sets.push_back(make_set("CryptoMaterial", samples, material_names(model, draws)));
  }
  return mattes;
}
