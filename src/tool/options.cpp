// SPDX-License-Identifier: MIT
#include "tool/options.h"

#include <algorithm>

#include "command/names.h"
#include "tool/option_groups.h"
#include "tool/settings.h"

using namespace command;

namespace {

constexpr const char* kDescription =
    R"(Draws a 3D model, or the Utah teapot without one, on the CPU, and writes PNG, JPEG, TIFF, EXR or Radiance HDR.
MODEL is glTF, OBJ, PLY, or any other file that assimp reads: Collada, FBX, STL, 3DS and more. The picture has
the same bits for any number of threads and any instruction set.

Metallic-roughness materials are taken whole: base colour, metallic-roughness, normal, occlusion and emissive
textures. Textures are looked for as the model names them, then beside it, whatever the case of their letters.
A texture that cannot be read is reported, and its colour is used instead.)";

const std::vector<Section> kSections = {
    {"Files",
     "MODEL may be -, standard input, without the files that it names, such as textures; formats without a mark of "
     "their own need their name in front, as obj:-. FILE of -o may be -, standard output, as PNG, or exr:-, jpg:- and "
     "so on; several pictures follow each other. In a name such as view.%04d.exr the number of the picture, from 1, "
     "replaces %04d. Without that, several pictures are view-0001.exr and on.\n\n"
     "An .exr has the header attributes worldToCamera and worldToNDC of OpenEXR and RenderMan, and Software. Z is the "
     "distance from the eye along the viewing direction in world units, which ZDefocus of Nuke reads with math depth; "
     "where nothing was drawn, it is that of the far plane. With several samples, it is that of the first one.\n\n"
     "Cryptomatte ids are those of specification 1.2, six ranks. Coverage counts the samples of the picture: "
     "--samples times the square of --supersampling. The scene is drawn once for each of them, without light. Blended "
     "surfaces and volumes have no ids. Parts of the file with one name and one place are one object; others with that "
     "name get _2, _3 and on. The material of --lines is named lines."},
    {"Output",
     "The name and size of every picture that is written, on standard output. The ranges of the values of --show and "
     "--difference are on standard error. Lights, cameras and animations of "
     "the model that the options do not use are reported on standard error."},
    {"Exit status",
     "0 done, 1 failed, 2 wrong options, 3 the model, the volume or a named texture cannot be read, 4 the "
     "picture cannot be written."},
    {"Environment", "OCIO names the colour config, instead of the one that libshd_color has."},
    {"Examples", R"(  shd-render model.gltf -o model.png
  shd-render --volume head.raw --volume-size 256x256x113 --volume-format u16be --volume-up z -o head.png
  shd-render --turntable 36 --shadows pcss --floor model.obj -o turn.png
  shd-render --shape plane --texture checker --compare "filter=nearest:filter=ewa" --difference -o ewa.png
  shd-render --texture checker --show level --samples 1 --zoom 400,300,16 -o level.png
  shd-render --texture bricks.png --table ripmap -o ripmap.png
  shd-render --camera 0 --lights file --filter anisotropic --supersampling 4 scene.dae -o scene.exr)"},
    {"Caveats", "Some damaged models make assimp end the whole process: run models of strangers in a sandbox."},
    {"See also", "shd-check(1), shd-maketx(1)"}};

/// Refuses options that do not fit together.
void check_model(const Options& options) {
  refuse_if(!options.model.empty() && options.has_shape, "--shape is drawn instead of a model");
  refuse_if(!options.model.empty() && !options.volume.file.empty(), "--volume is drawn instead of a model");
  refuse_if(options.turntable && options.shots[0].camera, "--turntable turns no --camera of the file");
  refuse_if(options.shots.size() > 1 && (options.turntable || options.frames),
            "--turntable and --frames take one view: one --orbit or --camera");
  refuse_if(options.animation.empty() && options.time, "--time needs an --animation");
  refuse_if(options.animation.empty() && options.frames, "--frames needs an --animation");
  refuse_if(options.time && options.frames, "--frames has all times: --time is one");
  refuse_if(options.turntable && options.frames, "--turntable and --frames: one of them");
}

void check_solid(const SolidOptions& solid) {
  const bool is_changed = solid.octaves || solid.fade || solid.turbulence || solid.table;
  refuse_if(is_changed && !solid.kind, "--solid-octaves, -turbulence, -table and -fade change a --solid");
  if (!solid.kind) return;
  const shd_solid kind = *solid.kind;
  const bool is_value = kind == SHD_SOLID_PERLIN || kind == SHD_SOLID_VALUE;
  const std::string name = shd_solid_name(kind);
  refuse_if(solid.octaves && kind <= SHD_SOLID_CHECKER, "--solid-octaves: " + name + " has no noise");
  refuse_if(solid.turbulence && !is_value && kind != SHD_SOLID_SIMPLEX,
            "--solid-turbulence is for perlin, value and simplex, not for " + name);
  refuse_if(solid.table && kind != SHD_SOLID_PERLIN, "--solid-table is for perlin, not for " + name);
  refuse_if(solid.fade && !is_value && kind != SHD_SOLID_MARBLE && kind != SHD_SOLID_WOOD,
            "--solid-fade is for perlin, value, marble and wood, not for " + name);
}

void check_table(const Options& options) {
  refuse_if(shows_texture(options) && (options.texture.empty() || options.texture == "none"),
            "--table needs a --texture");
  refuse_if(options.table && (options.show != Show::kNone || options.zoom.size > 0),
            "--table is drawn instead of the model: not with --show and --zoom");
}

void check_show(const Options& options) {
  const bool over = options.show == Show::kTangents || options.show == Show::kFootprint;
  refuse_if(options.show_step && !over, "--show-step is for --show tangents and footprint");
  refuse_if(options.show >= Show::kDepth && !options.volume.file.empty(), "--show shows surfaces, not a --volume");
  refuse_if(options.show == Show::kFootprint && options.solid.kind, "--show footprint needs a texture, not a --solid");
  const bool is_uv = options.uv != Uv::kTriplanar && options.uv != Uv::kCamera;
  refuse_if(!is_uv && (options.show == Show::kFootprint || options.show == Show::kUvLayout),
            "--show footprint and uv-layout are of the coordinates of vertices: not of --uv triplanar and camera");
  refuse_if(options.show == Show::kTerms && !options.environment.empty(),
            "--show terms shows the light of lights, not of an --environment");
  refuse_if(options.show == Show::kTerms && options.reflectance && !has_terms(*options.reflectance),
            "--show terms: the model has no terms that add up");
  const uint32_t side = std::max(options.width, options.height) * options.supersampling;
  refuse_if(options.show >= Show::kDepth && shows_data(options.show) && side > 16384,
            "--show: --supersampling times --size is " + std::to_string(side) + ", more than 16384");
  const ZoomOption& zoom = options.zoom;
  refuse_if(zoom.size && !options.volume.file.empty(), "--zoom shows samples of surfaces, not of a --volume");
  refuse_if(zoom.size && options.show >= Show::kUvLayout, "--zoom enlarges pixels of one view of the model");
  refuse_if(zoom.size > std::min(options.width, options.height) || (zoom.size && zoom.x >= options.width) ||
                (zoom.size && zoom.y >= options.height),
            "--zoom: the pixels are outside of the picture of --size");
}

/// Completes the options of one picture.
void finish(Options& out) {
  if (out.shots.empty()) {
    out.shots.emplace_back();
    if (out.cycle) out.shots[0].azimuth = out.shots[0].elevation = 0.0f;
  }
  check_model(out);
  check_solid(out.solid);
  check_table(out);
  check_show(out);
  const bool lit = !out.lights.empty() || out.lamps > 0 || !out.environment.empty();
  if (!out.preset) out.preset = lit ? LightPreset::kNone : LightPreset::kStudio;
  if (!out.ambient) out.ambient.emplace().fill(out.environment.empty() ? 0.15f : 0.0f);
  if (out.table == Table::kShadowMap) {  // PCSS has the margin of summed areas, and depths
    const shd_shadow_filter filter = out.shadows.value_or(SHD_SHADOW_FILTER_HARD);
    out.shadows = filter == SHD_SHADOW_FILTER_SUMMED_AREA_VARIANCE ? SHD_SHADOW_FILTER_PCSS : filter;
  }
  if (shows_data(out.show) || out.table) out.color = false;
}

Program make_program(Options& out) {
  return {"shd-render",
          "render pictures of a 3D model on the CPU",
          "[options] [MODEL] [-o OUT.png]",
          kDescription,
          {picture_options(out), camera_options(out), show_options(out), light_options(out), environment_options(out),
           surface_options(out), shape_options(out), volume_options(out.volume), machine_options(out)},
          kSections};
}

/// The options with those of one setting of `--compare`. Its views replace those of the command line.
Options add_setting(const Options& options, const std::vector<std::string>& setting) {
  Options out = options;
  out.shots.clear();
  std::vector<const char*> words = {"shd-render"};
  for (const std::string& word : setting) words.push_back(word.c_str());
  std::vector<std::string> files;
  try {
    parse(make_program(out), static_cast<int>(words.size()), words.data(), files);
    if (out.shots.empty()) out.shots = options.shots;
    finish(out);
  } catch (const Failure& failure) {
    throw Failure(failure.code, std::string("--compare: ") + failure.what());
  }
  refuse_if(out.shots.size() > 1, "--compare takes one view of each picture");
  return out;
}

/// The options of each picture side by side.
std::vector<Options> make_settings(const Options& options, const Program& program) {
  const auto settings = cut_settings(options.compare, program);
  refuse_if(settings.size() < 2, "--compare: \"" + options.compare + "\" is one setting; a colon is between two");
  refuse_if(options.difference && settings.size() != 2, "--difference is of two settings");
  refuse_if(options.model == "-" || ends_with(options.model, ":-"),
            "--compare reads the model for each picture: not from standard input");
  std::vector<Options> out;
  for (const std::vector<std::string>& setting : settings) {
    out.push_back(add_setting(options, setting));
    refuse_if(out.back().table.has_value(), "--table is a picture of its own: not with --compare");
  }
  bool color = false;
  for (const Options& one : out) color = color || one.color;
  for (Options& one : out) one.color = color;
  return out;
}

}  // namespace

Values color_values(std::optional<std::array<float, 3>>& out) {
  const auto read = [&out](const std::string& text) {
    const auto numbers = read_numbers(text);
    if (!numbers || (numbers->size() != 1 && numbers->size() != 3)) return false;
    std::array<float, 3>& color = out.emplace();
    for (size_t c = 0; c < 3; ++c) {
      color[c] = (*numbers)[numbers->size() == 1 ? 0 : c];
      if (color[c] < 0.0f || color[c] > 1e6f) return false;
    }
    return true;
  };
  return {"R,G,B or one number for all, each 0..1e6", {}, "", read};
}

Group machine_options(Options& out) {
  return {
      "Machine",
      {{"--threads", "N", initially(number(out.threads, 0, 1024), "one for each core"),
        "Workers. The picture does not depend on it."},
       {"--simd", "T", named(out.simd, names_of(shd_simd_name)), "Instruction set. The picture does not depend on it."},
       {"--progress", "", flag(out.progress),
        "Report progress and the time left even when standard error is no terminal."},
       {"--stats", "", flag(out.stats), "Print what was drawn and how long each stage took, on standard error."}}};
}

bool read_options(int argc, const char* const* argv, std::vector<Options>& settings) {
  Options out;
  const Program program = make_program(out);
  std::vector<std::string> files;
  if (!parse(program, argc, argv, files)) return false;
  files.resize(std::max(files.size(), size_t{1}));
  refuse_if(files.size() > 1, "one model at a time: \"" + files.front() + "\" and \"" + files.back() + "\"");
  out.model = files[0];
  refuse_if(out.difference && out.compare.empty(), "--difference needs --compare");
  if (!out.compare.empty()) settings = make_settings(out, program);
  if (settings.empty()) finish(out);
  if (settings.empty()) settings.push_back(out);
  const bool is_beside = settings.size() > 1 || out.show == Show::kTerms;
  uint64_t width = out.difference ? out.width : 0;
  for (const Options& one : settings) width += uint64_t{one.width} * (one.show == Show::kTerms ? 4 : 1);
  refuse_if(is_beside && width > 16000,
            "--compare and --show terms: pictures of --size side by side are wider than 16000 pixels");
  refuse_if((is_beside || is_composed(out)) && (out.aovs || out.mattes),
            "--aov, --aovs and --cryptomatte are planes of a frame: not of --show, --zoom and --compare");
  refuse_if(out.table && (out.aovs || out.mattes),
            "--aov, --aovs and --cryptomatte are planes of a frame: not of a --table");
  return true;
}
