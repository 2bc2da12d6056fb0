// SPDX-License-Identifier: MIT
// Images for shd-maketx, and what is in the files that it makes.
//   pyramid make FILE WIDTH HEIGHT CHANNELS TYPE   noise; TYPE is uint8, uint16, half or float; "+tiles": 32 x 48
//                                                  tiles; "+grey": all pixels are 0.25; "+nan": one is NaN
//   pyramid check INPUT FILE [srgb|linear|normal]  base = INPUT, levels = those of libshd, bit for bit
//   pyramid filter FILE KERNEL WRAP_U WRAP_V [normal]  levels = those of shd_mip_build(), from numbers of the enums
//   pyramid raw FILE OUT                           the bytes of level 0
//   pyramid info FILE                              what OpenImageIO's TextureSystem and reader say of it, as lines
//   pyramid lookup FILE                            OpenImageIO's TextureSystem reads the base, and the last level
//   pyramid COMMAND -- COMMAND ...                 several of these
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/texture.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include <shd/shd.h>

namespace {

[[noreturn]] void fail(const std::string& text) {
  std::fprintf(stderr, "pyramid: %s\n", text.c_str());
  std::exit(1);
}

int make(const char* path, int width, int height, int channels, std::string type) {
  const bool tiles = type.find("+tiles") != std::string::npos, grey = type.find("+grey") != std::string::npos;
  const bool nan = type.find("+nan") != std::string::npos;
  type = type.substr(0, type.find('+'));
  OIIO::ImageSpec spec(width, height, channels, OIIO::TypeDesc(type));
  if (tiles) spec.tile_width = 32, spec.tile_height = 48;
  spec.attribute("compression", "none");
  spec.attribute("tiff:half", 1);
  std::mt19937 random(static_cast<unsigned>(width * 31 + height));
  std::vector<float> row(static_cast<size_t>(width) * static_cast<size_t>(channels));
  std::vector<float> all;
  for (int y = 0; y < height; ++y) {
    for (float& value : row) value = grey ? 0.25f : static_cast<float>(random() % 4096) / 4095.0f;
    if (nan && y == height / 2) row[static_cast<size_t>(channels) * 3 + 1] = NAN;
    all.insert(all.end(), row.begin(), row.end());
  }
  const auto out = OIIO::ImageOutput::create(path);
  if (!out || !out->open(path, spec) || !out->write_image(OIIO::TypeFloat, all.data()) || !out->close()) fail("make");
  return 0;
}

/// Packed texels of a level, in the type of the file.
struct Level {
  OIIO::ImageSpec spec;
  std::vector<uint8_t> texels;
};

std::vector<Level> read_levels(const char* path) {
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  const auto in = OIIO::ImageInput::open(path, &config);
  if (!in) fail(std::string(path) + ": " + OIIO::geterror());
  std::vector<Level> levels;
  for (int l = 0; in->seek_subimage(0, l); ++l) {
    levels.push_back({in->spec(), std::vector<uint8_t>(in->spec().image_bytes())});
    Level& level = levels.back();
    if (!in->read_image(0, l, 0, level.spec.nchannels, level.spec.format, level.texels.data())) fail(in->geterror());
  }
  return levels;
}

shd_format format_of(const Level& base, bool srgb) {
  const int type = base.spec.format == OIIO::TypeUInt8    ? (srgb ? 1 : 0)
                   : base.spec.format == OIIO::TypeUInt16 ? 2
                   : base.spec.format == OIIO::TypeHalf   ? 3
                                                          : 4;
  constexpr shd_format kFormats[5][4] = {
      {SHD_FORMAT_R8, SHD_FORMAT_RG8, SHD_FORMAT_RGB8, SHD_FORMAT_RGBA8},
      {SHD_FORMAT_R8_SRGB, SHD_FORMAT_RG8_SRGB, SHD_FORMAT_RGB8_SRGB, SHD_FORMAT_RGBA8_SRGB},
      {SHD_FORMAT_R16, SHD_FORMAT_RG16, SHD_FORMAT_RGB16, SHD_FORMAT_RGBA16},
      {SHD_FORMAT_R16F, SHD_FORMAT_RG16F, SHD_FORMAT_RGB16F, SHD_FORMAT_RGBA16F},
      {SHD_FORMAT_R32F, SHD_FORMAT_RG32F, SHD_FORMAT_RGB32F, SHD_FORMAT_RGBA32F}};
  return kFormats[type][base.spec.nchannels - 1];
}

shd_image image_of(shd_format format, const OIIO::ImageSpec& spec, void* pixels) {
  shd_image image = shd_image_default();
  image.format = format;
  image.width = static_cast<uint32_t>(spec.width);
  image.height = static_cast<uint32_t>(spec.height);
  image.pixels = pixels;
  return image;
}

void check_ok(shd_result result) {
  if (result != SHD_OK) fail(shd_last_error());
}

/// Levels 1.. of a base by the texture builder, packed with the channels of the base.
std::vector<std::vector<uint8_t>> texture_levels(shd_context* context, shd_format format, std::vector<Level>& file) {
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = format;
  desc.width = static_cast<uint32_t>(file[0].spec.width);
  desc.height = static_cast<uint32_t>(file[0].spec.height);
  desc.texels = file[0].texels.data();
  desc.tables = SHD_TABLE_MIPMAP;
  shd_texture* texture = nullptr;
  check_ok(shd_texture_create(context, &desc, &texture));
  shd_texture_info info = shd_texture_info_default();
  check_ok(shd_texture_get_info(texture, &info));
  if (info.level_count != file.size()) fail("wrong number of levels");
  const size_t stored = shd_format_size(info.format), pixel = shd_format_size(format);
  std::vector<std::vector<uint8_t>> levels;
  for (uint32_t l = 1; l < info.level_count; ++l) {
    const size_t count = file[l].texels.size() / pixel;
    std::vector<uint8_t> wide(count * stored), packed(count * pixel);
    const shd_image image = image_of(info.format, file[l].spec, wide.data());
    check_ok(shd_texture_read_level(texture, 0, l, &image));
    for (size_t i = 0; i < count; ++i) std::memcpy(&packed[i * pixel], &wide[i * stored], pixel);
    levels.push_back(packed);
  }
  shd_texture_release(texture);
  return levels;
}

std::vector<std::vector<uint8_t>> built_levels(shd_context* context, shd_format format, std::vector<Level>& file,
                                               const shd_mip_desc& desc) {
  std::vector<std::vector<uint8_t>> levels;
  std::vector<shd_image> images;
  for (size_t l = 1; l < file.size(); ++l) levels.emplace_back(file[l].texels.size());
  for (size_t l = 1; l < file.size(); ++l) images.push_back(image_of(format, file[l].spec, levels[l - 1].data()));
  const shd_image base = image_of(format, file[0].spec, file[0].texels.data());
  check_ok(shd_mip_build(context, &base, &desc, static_cast<uint32_t>(images.size()), images.data()));
  return levels;
}

void compare_levels(const std::vector<Level>& file, const std::vector<std::vector<uint8_t>>& wanted) {
  for (size_t l = 1; l < file.size(); ++l) {
    if (file[l].texels != wanted[l - 1]) fail("level " + std::to_string(l) + " differs");
  }
  if (file.back().spec.width != 1 || file.back().spec.height != 1) fail("the last level is not 1 x 1");
}

int check(const char* input, const char* path, const std::string& content) {
  std::vector<Level> file = read_levels(path);
  const std::vector<Level> base = read_levels(input);
  if (file[0].texels != base[0].texels) fail("the base differs from the input");
  if (!file[0].spec.tile_width || file[0].spec.get_string_attribute("textureformat") != "Plain Texture") fail("tags");
  shd_context* context = nullptr;
  check_ok(shd_context_create(nullptr, &context));
  const shd_format format = format_of(file[0], content == "srgb");
  shd_mip_desc normals = shd_mip_desc_default();
  normals.content = SHD_TEXEL_CONTENT_NORMAL;
  compare_levels(
      file, content == "normal" ? built_levels(context, format, file, normals) : texture_levels(context, format, file));
  shd_context_release(context);
  return 0;
}

int filter(const std::vector<std::string>& words) {
  std::vector<Level> file = read_levels(words[1].c_str());
  const auto number = [&](size_t i) { return std::atoi(words[i].c_str()); };
  shd_context* context = nullptr;
  check_ok(shd_context_create(nullptr, &context));
  shd_mip_desc desc = shd_mip_desc_default();
  desc.kernel = static_cast<shd_mip_kernel>(number(2));
  desc.wrap_u = static_cast<shd_wrap>(number(3));
  desc.wrap_v = static_cast<shd_wrap>(number(4));
  if (words.size() > 5) desc.content = SHD_TEXEL_CONTENT_NORMAL;
  const bool srgb = file[0].spec.get_string_attribute("oiio:ColorSpace") == "sRGB";
  compare_levels(file, built_levels(context, format_of(file[0], srgb), file, desc));
  shd_context_release(context);
  return 0;
}

int raw(const char* path, const char* out) {
  const Level base = read_levels(path)[0];
  std::FILE* const file = std::fopen(out, "wb");
  if (!file || std::fwrite(base.texels.data(), 1, base.texels.size(), file) != base.texels.size()) fail("raw");
  std::fclose(file);
  return 0;
}

int info(const char* path) {
  OIIO::TextureSystem* const system = OIIO::TextureSystem::create(true);
  const OIIO::ustring name(path);
  std::printf("file=%s\n", path);
  for (const char* const what : {"averagecolor", "constantcolor"}) {
    float color[4];
    const OIIO::TypeDesc floats(OIIO::TypeDesc::FLOAT, 4);
    if (!system->get_texture_info(name, 0, OIIO::ustring(what), floats, color)) continue;
    std::printf("%s=%.9g,%.9g,%.9g\n", what, static_cast<double>(color[0]), static_cast<double>(color[1]),
                static_cast<double>(color[2]));
  }
  const OIIO::ImageSpec spec = read_levels(path)[0].spec;
  std::printf("size=%d,%d,%d\ntype=%s\n", spec.width, spec.height, spec.nchannels, spec.format.c_str());
  for (const OIIO::ParamValue& value : spec.extra_attribs) {
    std::printf("%s=%s\n", value.name().c_str(), value.get_string().c_str());
  }
  return 0;
}

/// A texel in the middle of the base, and a lookup over the whole image.
int lookup(const char* path) {
  const std::vector<Level> file = read_levels(path);
  OIIO::TextureSystem* const system = OIIO::TextureSystem::create(true);
  system->attribute("unassociatedalpha", 1);
  OIIO::TextureOpt options;
  options.mipmode = OIIO::TextureOpt::MipModeTrilinear;
  options.interpmode = OIIO::TextureOpt::InterpBilinear;
  const OIIO::ImageSpec& spec = file[0].spec;
  const int channels = spec.nchannels;
  const auto texel = [&](const Level& level, int x, int y, std::vector<float>* out) {
    const size_t size = level.spec.pixel_bytes();
    const uint8_t* at =
        level.texels.data() +
        (static_cast<size_t>(y) * static_cast<size_t>(level.spec.width) + static_cast<size_t>(x)) * size;
    OIIO::convert_types(level.spec.format, at, OIIO::TypeFloat, out->data(), channels);
  };
  std::vector<float> wanted(static_cast<size_t>(channels)), got(wanted);
  const auto compare = [&](const char* what) {
    for (int c = 0; c < channels; ++c) {
      const auto i = static_cast<size_t>(c);
      if (!(std::fabs(wanted[i] - got[i]) <= 1e-3f)) fail(std::string(what) + " differs");
    }
  };
  const int x = spec.width / 2, y = spec.height / 2;
  const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(spec.width);
  const float v = (static_cast<float>(y) + 0.5f) / static_cast<float>(spec.height);
  texel(file[0], x, y, &wanted);
  if (!system->texture(OIIO::ustring(path), options, u, v, 0, 0, 0, 0, channels, got.data())) fail(system->geterror());
  compare("a texel of the base");
  texel(file.back(), 0, 0, &wanted);
  if (!system->texture(OIIO::ustring(path), options, 0.5f, 0.5f, 8, 0, 0, 8, channels, got.data())) {
    fail(system->geterror());
  }
  compare("the last level");
  int levels = 0;
  system->get_texture_info(OIIO::ustring(path), 0, OIIO::ustring("miplevels"), OIIO::TypeInt, &levels);
  if (static_cast<size_t>(levels) != file.size()) fail("TextureSystem has other levels");
  return 0;
}

int run(const std::vector<std::string>& words) {
  const size_t count = words.size();
  const std::string verb = count ? words[0] : "";
  const auto number = [&](size_t i) { return std::atoi(words[i].c_str()); };
  if (verb == "make" && count == 6) return make(words[1].c_str(), number(2), number(3), number(4), words[5].c_str());
  if (verb == "check" && (count == 3 || count == 4)) {
    return check(words[1].c_str(), words[2].c_str(), count > 3 ? words[3].c_str() : "linear");
  }
  if (verb == "filter" && (count == 5 || count == 6)) return filter(words);
  if (verb == "raw" && count == 3) return raw(words[1].c_str(), words[2].c_str());
  if (verb == "info" && count == 2) return info(words[1].c_str());
  if (verb == "lookup" && count == 2) return lookup(words[1].c_str());
  fail("usage: see the head of the source");
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> command;
  int result = 0;
  for (int i = 1; i <= argc && result == 0; ++i) {
    if (i < argc && std::strcmp(argv[i], "--") != 0) {
      command.push_back(argv[i]);
      continue;
    }
    result = run(command);
    command.clear();
  }
  return result;
}
