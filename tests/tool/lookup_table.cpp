// SPDX-License-Identifier: MIT
// Writes a table of lookups by a texture unit with one bug, for tests of shd-check.
//   lookup_table FOLDER KEY=VALUE...
// FOLDER receives level0.npy, level1.npy ... and lookups.csv.
// Keys of the texture: width height layers seed, format (rgba8, srgb8), cube (1 = six faces).
// Keys of the sampler: filter wrap_u wrap_v (numbers of the API) bias lod_min lod_max max_anisotropy.
// Keys of the lookups: rows, lod (1 = a column lod, no derivatives).
// Keys of the unit: bug (a name below) a b option subtexel_bits level_bits weight_bits result_bits.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "ref/unit_filter_ref.h"
#include "support/random.h"

namespace {

const std::map<std::string, ref::Bug> kBugs = {{"none", ref::Bug::kNone},
                                               {"shift", ref::Bug::kShift},
                                               {"wrap", ref::Bug::kWrap},
                                               {"swapped_axes", ref::Bug::kSwappedAxes},
                                               {"mirrored_axis", ref::Bug::kMirroredAxis},
                                               {"level_shift", ref::Bug::kLevelShift},
                                               {"level_scale", ref::Bug::kLevelScale},
                                               {"one_step", ref::Bug::kOneStep},
                                               {"shorter_axis", ref::Bug::kShorterAxis},
                                               {"one_size", ref::Bug::kOneSize},
                                               {"no_bias", ref::Bug::kNoBias},
                                               {"no_clamps", ref::Bug::kNoClamps},
                                               {"few_bits", ref::Bug::kFewBits},
                                               {"few_level_bits", ref::Bug::kFewLevelBits},
                                               {"filter_first", ref::Bug::kFilterFirst},
                                               {"no_decode", ref::Bug::kNoDecode},
                                               {"alpha_decoded", ref::Bug::kAlphaDecoded},
                                               {"layer", ref::Bug::kLayer},
                                               {"border", ref::Bug::kBorder}};

class Arguments {
 public:
  Arguments(int argc, char** argv) {
    for (int i = 2; i < argc; ++i) {
      const std::string text = argv[i];
      const size_t equals = text.find('=');
      if (equals == std::string::npos) fail(text + " is not KEY=VALUE");
      values_[text.substr(0, equals)] = text.substr(equals + 1);
    }
  }
  std::string text(const std::string& key, const std::string& otherwise) {
    const auto at = values_.find(key);
    if (at == values_.end()) return otherwise;
    const std::string value = at->second;
    values_.erase(at);
    return value;
  }
  double number(const std::string& key, double otherwise) {
    return std::atof(text(key, std::to_string(otherwise)).c_str());
  }
  int whole(const std::string& key, int otherwise) { return static_cast<int>(number(key, otherwise)); }
  void check_all_read() const {
    if (!values_.empty()) fail(values_.begin()->first + " is not a key");
  }
  [[noreturn]] static void fail(const std::string& text) {
    std::fprintf(stderr, "lookup_table: %s\n", text.c_str());
    std::exit(2);
  }

 private:
  std::map<std::string, std::string> values_;
};

struct Image {
  uint32_t width, height, layers;
  std::vector<std::vector<uint8_t>> bytes;  // [layers][levels]
  ref::UnitImage unit;
};

/// Noise about a colour of each level and layer, so that a wrong level shows.
Image make_image(Arguments* arguments, shd::tests::Random* random) {
  const bool cube = arguments->whole("cube", 0) != 0;
  Image out = {static_cast<uint32_t>(arguments->whole("width", 32)),
               static_cast<uint32_t>(arguments->whole("height", 32)),
               static_cast<uint32_t>(arguments->whole("layers", cube ? 6 : 1)),
               {},
               {}};
  const bool srgb = arguments->text("format", "rgba8") == "srgb8";
  out.unit = {srgb ? SHD_FORMAT_RGBA8_SRGB : SHD_FORMAT_RGBA8,
              1,
              static_cast<int>(out.layers),
              cube ? SHD_PROJECTION_CUBE : SHD_PROJECTION_NONE,
              0,
              {},
              shd_sampler_desc_default()};
  while ((out.width | out.height) >> out.unit.level_count) ++out.unit.level_count;
  for (uint32_t layer = 0; layer < out.layers; ++layer) {
    for (int level = 0; level < out.unit.level_count; ++level) {
      const uint32_t w = std::max(out.width >> level, 1u), h = std::max(out.height >> level, 1u);
      std::vector<uint8_t> texels(size_t{w} * h * 4);
      for (size_t i = 0; i < texels.size(); ++i) {
        const double base = static_cast<double>((static_cast<size_t>(level) * 5 + layer * 3 + i % 4 * 2) % 11) / 10;
        texels[i] = static_cast<uint8_t>(255 * (0.3 * base + 0.7 * random->unit()));
      }
      out.bytes.push_back(std::move(texels));
      out.unit.levels.push_back({out.bytes.back().data(), w, h});
    }
  }
  return out;
}

void read_sampler(Arguments* arguments, shd_sampler_desc* sampler) {
  sampler->filter = static_cast<shd_filter>(arguments->whole("filter", SHD_FILTER_BILINEAR));
  sampler->wrap_u = static_cast<shd_wrap>(arguments->whole("wrap_u", SHD_WRAP_REPEAT));
  sampler->wrap_v = static_cast<shd_wrap>(arguments->whole("wrap_v", SHD_WRAP_REPEAT));
  sampler->lod_bias = static_cast<float>(arguments->number("bias", 0));
  sampler->lod_min = static_cast<float>(arguments->number("lod_min", 0));
  sampler->lod_max = static_cast<float>(arguments->number("lod_max", 32));
  sampler->max_anisotropy = static_cast<float>(arguments->number("max_anisotropy", 16));
  for (float& x : sampler->border) x = 0.6f;
}

ref::Unit read_unit(Arguments* arguments) {
  ref::Unit unit;
  const std::string bug = arguments->text("bug", "none");
  if (!kBugs.count(bug)) Arguments::fail(bug + " is not a bug");
  unit.bug = kBugs.at(bug);
  unit.a = arguments->number("a", 0);
  unit.b = arguments->number("b", 0);
  unit.option = arguments->whole("option", 0);
  unit.subtexel_bits = arguments->whole("subtexel_bits", 8);
  unit.level_bits = arguments->whole("level_bits", 8);
  unit.weight_bits = arguments->whole("weight_bits", 0);
  unit.result_bits = arguments->whole("result_bits", 0);
  return unit;
}

void write_level(const std::string& path, const Image& image, int level) {
  const auto& first = image.unit.at(0, level);
  std::string header = "{'descr': '|u1', 'fortran_order': False, 'shape': (" +
                       (image.layers > 1 ? std::to_string(image.layers) + ", " : "") + std::to_string(first.height) +
                       ", " + std::to_string(first.width) + ", 4), }";
  header += std::string(63 - (header.size() + 10) % 64, ' ') + "\n";
  std::ofstream file(path, std::ios::binary);
  file << "\x93NUMPY\x01" << '\0' << static_cast<char>(header.size()) << '\0' << header;
  for (uint32_t layer = 0; layer < image.layers; ++layer) {
    const auto& texels =
        image.bytes[size_t{layer} * static_cast<size_t>(image.unit.level_count) + static_cast<size_t>(level)];
    file.write(reinterpret_cast<const char*>(texels.data()), static_cast<std::streamsize>(texels.size()));
  }
  if (!file.flush()) Arguments::fail(path + ": cannot be written");
}

/// A point that lies in the image or beside it, or a direction, and a footprint of 1/2 to 16 texels.
ref::UnitLookup make_lookup(const Image& image, bool with_lod, shd::tests::Random* random) {
  ref::UnitLookup lookup = {};
  const int axes = image.unit.is_flat() ? 2 : 3;
  for (int i = 0; i < axes; ++i) lookup.p[i] = static_cast<double>(random->real(-1.5, 2.5));
  const double size = std::exp2(random->in(-1, 4)), ratio = std::exp2(random->in(0, 3));
  const double sizes[3] = {static_cast<double>(image.width), static_cast<double>(image.height),
                           static_cast<double>(image.width)};
  for (int i = 0; i < axes; ++i) {
    lookup.dx[i] = static_cast<double>(static_cast<float>(random->in(-1, 1) * size / sizes[i]));
    lookup.dy[i] = static_cast<double>(static_cast<float>(random->in(-1, 1) * size / ratio / sizes[i]));
  }
  lookup.has_lod = with_lod;
  lookup.lod = static_cast<double>(random->real(-1, 5));
  lookup.layer = image.unit.is_flat() ? random->whole(0, static_cast<int64_t>(image.layers) - 1) : 0;
  return lookup;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) Arguments::fail("FOLDER is missing");
  Arguments arguments(argc, argv);
  shd::tests::Random random{static_cast<uint64_t>(arguments.whole("seed", 1))};
  Image image = make_image(&arguments, &random);
  read_sampler(&arguments, &image.unit.sampler);
  const ref::Unit unit = read_unit(&arguments);
  const int rows = arguments.whole("rows", 200);
  const bool with_lod = arguments.whole("lod", 0) != 0;
  arguments.check_all_read();
  const std::string folder = std::string(argv[1]) + "/";
  for (int level = 0; level < image.unit.level_count; ++level)
    write_level(folder + "level" + std::to_string(level) + ".npy", image, level);
  std::FILE* const file = std::fopen((folder + "lookups.csv").c_str(), "w");
  if (!file) Arguments::fail(folder + "lookups.csv: cannot be written");
  const bool flat = image.unit.is_flat();
  std::fprintf(file, "u,v,%s%slayer,r,g,b,a\n", with_lod ? "lod," : "dudx,dvdx,dudy,dvdy,", flat ? "" : "w,dwdx,dwdy,");
  for (int i = 0; i < rows; ++i) {
    const ref::UnitLookup q = make_lookup(image, with_lod, &random);
    const ref::Value value = ref::unit_sample(image.unit, unit, q);
    std::fprintf(file, "%.9g,%.9g,", q.p[0], q.p[1]);
    if (with_lod) std::fprintf(file, "%.9g,", q.lod);
    if (!with_lod) std::fprintf(file, "%.9g,%.9g,%.9g,%.9g,", q.dx[0], q.dx[1], q.dy[0], q.dy[1]);
    if (!flat) std::fprintf(file, "%.9g,%.9g,%.9g,", q.p[2], q.dx[2], q.dy[2]);
    std::fprintf(file, "%d,%.9g,%.9g,%.9g,%.9g\n", q.layer, value[0], value[1], value[2], value[3]);
  }
  return std::fclose(file) == 0 ? 0 : 1;
}
