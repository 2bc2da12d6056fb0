// SPDX-License-Identifier: MIT
#include "options.h"

#include <cmath>
#include <cstdlib>
#include <functional>
#include <vector>

namespace viewer {
namespace {

/// The arguments that are left, and the sides that options of a side change.
struct Parser {
  Options options;
  std::string name, value;
  bool only_b = false;
  bool has_size = false;

  [[noreturn]] void fail(const std::string& valid) const {
    throw UsageError(name + ": \"" + value + "\" is not " + valid);
  }

  template <class Change>
  void change_sides(Change change) {
    if (!only_b) change(options.state.side[0]);
    change(options.state.side[1]);
  }

  std::vector<float> numbers(size_t least, size_t most, float low, float high, char separator = ',') const {
    const std::string valid =
        (most == 1 ? "a number" : std::to_string(least) + " to " + std::to_string(most) + " numbers") + " in " +
        text_of(low) + ".." + text_of(high);
    std::vector<float> list;
    const char* at = value.c_str();
    for (;;) {
      char* end = nullptr;
      const float number = std::strtof(at, &end);
      if (end == at || !(number >= low && number <= high)) fail(valid);
      list.push_back(number);
      at = end;
      if (*at == '\0') break;
      if (*at != separator) fail(valid);
      ++at;
    }
    if (list.size() < least || list.size() > most) fail(valid);
    return list;
  }

  float number(float low, float high) const { return numbers(1, 1, low, high)[0]; }

  uint32_t whole(float low, float high) const {
    const float x = number(low, high);
    if (x != std::floor(x)) fail("a whole number");
    return static_cast<uint32_t>(x);
  }

  Pixel pixel() const {
    const std::vector<float> xy = numbers(2, 2, 0.0f, 16383.0f);
    return {static_cast<uint32_t>(xy[0]), static_cast<uint32_t>(xy[1])};
  }

  bool flag() const {
    if (value != "on" && value != "off") fail("on or off");
    return value == "on";
  }

  template <size_t N>
  int choice(const Choices<N>& choices) const {
    std::string words;
    for (const Choice& choice : choices) {
      if (value == choice.word) return choice.value;
      words += std::string(words.empty() ? "" : ", ") + choice.word;
    }
    fail("one of " + words);
  }

  static std::string text_of(float x) {
    const std::string text = std::to_string(x);
    return text.substr(0, text.find_last_not_of('0') + (text[text.find_last_not_of('0')] == '.' ? 0 : 1));
  }
};

struct Option {
  const char* name;
  void (*read)(Parser&);
};

void read_view(Parser& p) {
  const size_t slash = p.value.find('/');
  if (p.value == "plain") {
    p.options.state.display = Display();
  } else if (slash == std::string::npos) {
    p.fail("plain, or a display and a view as in sRGB/Plain");
  } else {
    p.options.state.display = {p.value.substr(0, slash), p.value.substr(slash + 1)};
  }
}

void read_orbit(Parser& p) {
  const std::vector<float> list = p.numbers(2, 3, -360.0f, 360.0f);
  if (std::abs(list[1]) > 89.0f) p.fail("an azimuth, an elevation in -89..89 and a distance");
  if (list.size() > 2 && !(list[2] >= 0.05f && list[2] <= 60.0f)) p.fail("with a distance in 0.05..60");
  Orbit& orbit = p.options.state.orbit;
  orbit.azimuth = list[0], orbit.elevation = list[1];
  if (list.size() > 2) orbit.distance = list[2];
}

void read_size(Parser& p) {
  const std::vector<float> list = p.numbers(2, 2, 64.0f, 8192.0f, 'x');
  p.options.width = static_cast<int>(list[0]), p.options.height = static_cast<int>(list[1]);
}

void read_samples(Parser& p) {
  if (p.value != "1" && p.value != "4") p.fail("1 or 4");
  p.change_sides([&](Side& side) { side.samples = p.value == "1" ? 1 : 4; });
}

void read_color(Parser& p) {
  const std::vector<float> rgb = p.numbers(3, 3, 0.0f, 1.0f);
  p.change_sides([&](Side& side) {
    side.surface.color = {rgb[0], rgb[1], rgb[2]};
    side.surface.from_file = false;
  });
}

template <float Surface::*member, int most>
void read_coefficient(Parser& p) {
  const float x = p.number(0.0f, most);
  p.change_sides([&](Side& side) {
    side.surface.*member = x;
    side.surface.from_file = false;
  });
}

void read_panel(Parser& p) {
  if (p.value != "settings" && p.value != "pixel") p.fail("settings or pixel");
  p.options.pixel_tab = p.value == "pixel";
}

void read_light(Parser& p) {
  const std::vector<float> list = p.numbers(2, 2, -360.0f, 360.0f);
  p.options.state.lighting.azimuth = list[0];
  p.options.state.lighting.elevation = list[1];
}

void read_target(Parser& p) {
  const std::vector<float> list = p.numbers(3, 3, -50.0f, 50.0f);
  p.options.state.orbit.shift = {list[0], list[1], list[2]};
}

const Option kOptions[] = {
    {"--model", [](Parser& p) { p.options.state.content.model = p.value; }},
    {"--texture", [](Parser& p) { p.options.state.content.texture = p.value; }},
    {"--floor", [](Parser& p) { p.options.state.content.floor = p.flag(); }},
    {"--occlusion", [](Parser& p) { p.options.state.content.occlusion = p.flag(); }},
    {"--environment", [](Parser& p) { p.options.state.lighting.environment = p.value; }},
    {"--environment-intensity",
     [](Parser& p) { p.options.state.lighting.environment_intensity = p.number(0.0f, 1000.0f); }},
    {"--light", read_light},
    {"--intensity", [](Parser& p) { p.options.state.lighting.intensity = p.number(0.0f, 1000.0f); }},
    {"--ambient", [](Parser& p) { p.options.state.lighting.ambient = p.number(0.0f, 1000.0f); }},
    {"--shadows", [](Parser& p) { p.options.state.lighting.shadows = p.flag(); }},
    {"--view", read_view},
    {"--orbit", read_orbit},
    {"--target", read_target},
    {"--fov", [](Parser& p) { p.options.state.orbit.fov = p.number(5.0f, 120.0f); }},
    {"--wipe",
     [](Parser& p) {
       p.options.state.wipe = true;
       p.options.state.divider = p.number(0.0f, 1.0f);
     }},
    {"--filter",
     [](Parser& p) {
       const auto filter = static_cast<shd_filter>(p.choice(kFilters));
       p.change_sides([&](Side& side) { side.sampling.filter = filter; });
     }},
    {"--anisotropy",
     [](Parser& p) {
       const float most = p.number(1.0f, 64.0f);
       p.change_sides([&](Side& side) { side.sampling.max_anisotropy = most; });
     }},
    {"--precision",
     [](Parser& p) {
       const auto precision = static_cast<shd_precision>(p.choice(kPrecisions));
       p.change_sides([&](Side& side) { side.sampling.precision = precision; });
     }},
    {"--lod-bias",
     [](Parser& p) {
       const float bias = p.number(-15.0f, 15.0f);
       p.change_sides([&](Side& side) { side.sampling.lod_bias = bias; });
     }},
    {"--profile",
     [](Parser& p) {
       const auto profile = static_cast<shd_profile>(p.choice(kProfiles));
       p.change_sides([&](Side& side) { side.sampling.profile = profile; });
     }},
    {"--surface",
     [](Parser& p) {
       const auto model = static_cast<shd_model>(p.choice(kModels));
       p.change_sides([&](Side& side) {
         side.surface.model = model;
         side.surface.from_file = false;
       });
     }},
    {"--color", read_color},
    {"--roughness", read_coefficient<&Surface::roughness, 1>},
    {"--metallic", read_coefficient<&Surface::metallic, 1>},
    {"--clearcoat", read_coefficient<&Surface::clearcoat, 1>},
    {"--specular", read_coefficient<&Surface::specular, 1>},
    {"--exponent", read_coefficient<&Surface::exponent, 1000>},
    {"--show",
     [](Parser& p) {
       const auto show = static_cast<Show>(p.choice(kShows));
       p.change_sides([&](Side& side) { side.show = show; });
     }},
    {"--samples", read_samples},
    {"--size", read_size},
    {"--scale", [](Parser& p) { p.options.scale = p.number(0.5f, 4.0f); }},
    {"--font", [](Parser& p) { p.options.font = p.value; }},
    {"--screenshot", [](Parser& p) { p.options.screenshot = p.value; }},
    {"--picture", [](Parser& p) { p.options.picture = p.value; }},
    {"--frames", [](Parser& p) { p.options.frames = static_cast<int>(p.whole(1.0f, 1000.0f)); }},
    {"--click",
     [](Parser& p) {
       p.options.state.pick = p.pixel();
       p.options.pixel_tab = true;
     }},
    {"--magnify", [](Parser& p) { p.options.magnify = p.pixel(); }},
    {"--panel", read_panel},
    {"--threads", [](Parser& p) { p.options.threads = p.whole(0.0f, 1024.0f); }},
};

}  // namespace

Options parse_options(int argc, const char* const* argv) {
  Parser parser;
  for (int i = 1; i < argc; ++i) {
    parser.name = argv[i];
    if (parser.name == "--help" || parser.name == "-h") {
      parser.options.help = true;
      continue;
    }
    if (parser.name == "--b") {
      parser.only_b = true;
      parser.options.state.wipe = true;
      continue;
    }
    if (!parser.name.empty() && parser.name[0] != '-') {  // a file, as a desktop starts programs
      parser.options.state.content.model = parser.name;
      continue;
    }
    const Option* found = nullptr;
    for (const Option& option : kOptions) {
      if (parser.name == option.name) found = &option;
    }
    if (!found) throw UsageError(parser.name + ": there is no such option; --help lists all");
    if (i + 1 == argc) throw UsageError(parser.name + ": the value is missing");
    parser.value = argv[++i];
    found->read(parser);
  }
  return parser.options;
}

const char* help_text() {
  return R"(shd-viewer [options] [model]: shows a model and explains its texture lookups.

Model
  --model M          teapot, sphere, box, torus, plane, or a file (glTF, OBJ, PLY, FBX ...); default teapot
  --texture T        default, porcelain, tiles, none, or an image file
  --floor on|off     default on
  --occlusion on|off ambient occlusion at the vertices; default on
Light
  --light AZ,EL      direction to the light [degrees]
  --intensity X      of the light;  --ambient X: ambient light;  --shadows on|off
  --environment E    studio, none, or an image of latitude and longitude;  --environment-intensity X
Camera
  --orbit AZ,EL[,D]  direction to the eye [degrees] and its distance [radii of the model]
  --target X,Y,Z     shift of the point of interest [radii];  --fov D: vertical field of view [degrees]
Sides (options after --b change side B alone)
  --filter F         nearest, bilinear, bicubic, nearest-mip, bilinear-mip, trilinear, ripmap, summed-area,
                     anisotropic, ewa, stochastic or exact
  --anisotropy N     1..64;  --lod-bias X: -15..15;  --precision full|fast
  --profile P        least-error, vulkan, d3d11, oiio or exact
  --surface S        metallic-roughness, blinn-phong, blinn-phong-normalized, phong, combined, lambert, gooch, toon,
                     glass or unlit
  --color R,G,B  --roughness X  --metallic X  --clearcoat X  --specular X  --exponent X
  --show V           model, normals, uv, level, barycentrics, overdraw or depth
  --samples 1|4
  --b                begins the options of side B and turns the wipe on;  --wipe X: divider at this part of the width
Window
  --view V           plain, or a display and a view of libshd_color, as in "sRGB/ACES 1.0 SDR-video"
  --size WxH         default 1280x800;  --scale X: size of texts;  --font FILE;  --panel settings|pixel
  --click X,Y        explains the lookup of that pixel;  --magnify X,Y: magnifies the pixels around it
  --screenshot FILE  writes the window as PNG and ends;  --frames N: frames of the window before that, default 3
  --picture FILE     writes the viewport as PNG without a window and ends
  --threads N        workers of the library, 0 = one per core
)";
}

}  // namespace viewer
