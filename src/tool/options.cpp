// SPDX-License-Identifier: MIT
#include "tool/options.h"

#include <algorithm>

#include "command/names.h"
#include "tool/option_groups.h"

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
     "The name and size of every picture that is written, on standard output. Lights, cameras and animations of "
     "the model that the options do not use are reported on standard error."},
    {"Exit status",
     "0 done, 1 failed, 2 wrong options, 3 the model, the volume or a named texture cannot be read, 4 the "
     "picture cannot be written."},
    {"Environment", "OCIO names the colour config, instead of the one that libshd_color has."},
    {"Examples", R"(  shd-render model.gltf -o model.png
  shd-render --volume head.raw --volume-size 256x256x113 --volume-format u16be --volume-up z -o head.png
  shd-render --turntable 36 --shadows pcss --floor model.obj -o turn.png
  shd-render --texture bricks.png --table ripmap -o ripmap.png
  shd-render --camera 0 --lights file --filter anisotropic --supersampling 4 scene.dae -o scene.exr)"},
    {"Caveats", "Some damaged models make assimp end the whole process: run models of strangers in a sandbox."},
    {"See also", "shd-check(1), shd-maketx(1)"}};

void check_together(const Options& options) {
  refuse_if(!options.model.empty() && options.has_shape, "--shape is drawn instead of a model");
  refuse_if(!options.model.empty() && !options.volume.file.empty(), "--volume is drawn instead of a model");
  refuse_if(options.turntable && options.shots[0].camera, "--turntable turns no --camera of the file");
  refuse_if(options.shots.size() > 1 && (options.turntable || options.frames),
            "--turntable and --frames take one view: one --orbit or --camera");
  refuse_if(options.animation.empty() && options.time, "--time needs an --animation");
  refuse_if(options.animation.empty() && options.frames, "--frames needs an --animation");
  refuse_if(options.time && options.frames, "--frames has all times: --time is one");
  refuse_if(options.turntable && options.frames, "--turntable and --frames: one of them");
  refuse_if(shows_texture(options) && (options.texture.empty() || options.texture == "none"),
            "--table needs a --texture");
  refuse_if(options.table && options.hash, "--hash is of frames, not of a --table");
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

bool read_options(int argc, const char* const* argv, Options& out) {
  const Program program = {"shd-render",
                           "render pictures of a 3D model on the CPU",
                           "[options] [MODEL] [-o OUT.png]",
                           kDescription,
                           {picture_options(out), camera_options(out), light_options(out), environment_options(out),
                            surface_options(out), shape_options(out), volume_options(out.volume), machine_options(out)},
                           kSections};
  std::vector<std::string> files;
  if (!parse(program, argc, argv, files)) return false;
  files.resize(std::max(files.size(), size_t{1}));
  refuse_if(files.size() > 1, "one model at a time: \"" + files.front() + "\" and \"" + files.back() + "\"");
  out.model = files[0];
  if (out.shots.empty()) out.shots.emplace_back();
  check_together(out);
  const bool lit = !out.lights.empty() || out.lamps > 0 || !out.environment.empty();
  if (!out.preset) out.preset = lit ? LightPreset::kNone : LightPreset::kStudio;
  if (out.table == Table::kShadowMap) {  // PCSS has the margin of summed areas, and depths
    const shd_shadow_filter filter = out.shadows.value_or(SHD_SHADOW_FILTER_HARD);
    out.shadows = filter == SHD_SHADOW_FILTER_SUMMED_AREA_VARIANCE ? SHD_SHADOW_FILTER_PCSS : filter;
  }
  if (!out.ambient) out.ambient.emplace().fill(out.environment.empty() ? 0.15f : 0.0f);
  return true;
}
