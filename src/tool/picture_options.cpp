// SPDX-License-Identifier: MIT
#include "command/names.h"
#include "tool/option_groups.h"

using namespace command;

namespace {

const Name<uint32_t> kSampleCounts[] = {{"1", 1}, {"2", 2}, {"4", 4}, {"8", 8}, {"16", 16}};

Values background_values(Options& out) {
  const auto read = [&out](const std::string& text) {
    std::optional<std::array<float, 3>> color;
    out.has_background = true;
    out.background = {0, 0, 0, 0};
    if (text == "none") return true;
    if (!color_values(color).read(text)) return false;
    out.background = {(*color)[0], (*color)[1], (*color)[2], 1.0f};
    return true;
  };
  return {"R,G,B, one number for grey, or none = transparent", {}, "none, or the environment", read};
}

/// Names of flags between commas.
Values list_values(uint32_t& out, const std::vector<Name<uint32_t>>& table) {
  Values values = named(out, table);
  values.wanted = "a list of " + join(values.names, " and ");
  values.read = [&out, table](const std::string& text) {
    for (const std::string& name : split(text, ',')) {
      uint32_t flags = 0;
      if (!named(flags, table).read(name)) return false;
      out |= flags;
    }
    return true;
  };
  return values;
}

Values plane_values(uint32_t& out) {
  return list_values(out, std::vector<Name<uint32_t>>(std::begin(kAovs), std::end(kAovs)));
}

Values matte_values(uint32_t& out) {
  const std::vector<Name<uint32_t>> layers = {{"object", kMatteObject}, {"material", kMatteMaterial}};
  Values values = list_values(out, layers);
  values.wanted = "object, material or object,material";
  return values;
}

Values triangle_planes(uint32_t& out) {
  return {
      "", {}, "", [&out](const std::string&) { return out |= SHD_AOV_UV | SHD_AOV_NORMAL | SHD_AOV_TRIANGLE, true; }};
}

}  // namespace

Group picture_options(Options& out) {
  return {
      "Picture",
      {{"-o,--output", "FILE", initially(file(out.output), "out.png"),
        ".png, .jpg and .tif are written through the display transform, .exr and .hdr are scene-linear. JPEG is over "
        "black where nothing is drawn. See Files."},
       {"--compression", "C", initially(text(out.compression), "zip, and 95 for JPEG"),
        "Of .exr: none, rle, zips, zip, piz, b44, b44a, dwaa or dwab; of .tif: none, lzw, zip or packbits; of .jpg: a "
        "quality from 1 to 100."},
       {"--size", "WxH", size({out.width, out.height}, 16384), "Pixels."},
       {"--samples", "N", named(out.samples, kSampleCounts), "Samples of a pixel."},
       {"--sample-shading", "", flag(out.sample_shading),
        "Shade every sample at its own position, instead of every pixel once."},
       {"--supersampling", "N", number(out.supersampling, 1, 16), "Each pixel is the average of N x N."},
       {"--visibility", "V", named(out.visibility, names_of(shd_visibility_name)),
        "What decides which triangle shows."},
       {"--background", "R,G,B", background_values(out), "Scene-linear colour."},
       {"--display", "NAME", text(out.display), "Display of the colour config."},
       {"--view", "NAME", text(out.view), "View of that display. Plain is the encoding alone."},
       {"--no-color", "", flag(out.color, false), "No display transform: the sRGB curve alone, clamped."},
       {"--dither", "", flag(out.dither), "Ordered dither of 8-bit colours."},
       {"--hash", "", flag(out.hash),
        "Print a hash of the picture, the same on every machine: FNV-1a of 64 bits over the linear floats r, g, b "
        "and a of each pixel. The picture is saved only if -o is given."},
       {"--aov", "", triangle_planes(out.aovs),
        "Also save texture coordinates, normals and triangle numbers (.exr only)."},
       {"--aovs", "A,B,...", plane_values(out.aovs), "Also save these planes (.exr only)."},
       {"--cryptomatte", "A,B", matte_values(out.mattes),
        "Also save mattes of objects, of materials, or of both, for compositing (.exr only). See Files."}}};
}

Group camera_options(Options& out) {
  const auto orbit = [&out](const std::string& text) {
    const auto numbers = read_numbers(text);
    if (!numbers || numbers->size() < 2 || numbers->size() > 3) return false;
    Shot& shot = out.shots.emplace_back();
    shot.azimuth = (*numbers)[0];
    shot.elevation = (*numbers)[1];
    shot.distance = numbers->size() > 2 ? (*numbers)[2] : 0.0f;
    const bool is_far = numbers->size() == 2 || (shot.distance > 1.0f && shot.distance <= 1e4f);
    return is_far && std::fabs(shot.elevation) <= 90.0f;
  };
  const auto camera = [&out](const std::string& text) {
    return number(out.shots.emplace_back().camera, 0, 65535).read(text);
  };
  const auto animation = [&out](const std::string& text) { return out.animation = text, !text.empty(); };
  return {"Camera",
          {{"--orbit",
            "AZ,EL[,DIST]",
            {"AZIMUTH,ELEVATION[,DISTANCE] in degrees (elevation -90..90) and radii (above 1)",
             {},
             "30,20 and far enough to show all",
             orbit},
            "Where the eye is, seen from the centre of the model: degrees to the right of the front, degrees up, radii "
            "away. Each --orbit and --camera is a picture."},
           {"--fov", "DEGREES", number(out.fov, 1, 170, " degrees"), "Vertical field of view."},
           {"--camera",
            "N",
            {"a whole number 0..65535", {}, "", camera},
            "Camera of this number of the file, instead of an orbit."},
           {"--turntable", "N", initially(number(out.turntable, 1, 9999), ""),
            "N pictures once around the model, OUT-0001.png and on."},
           {"--animation",
            "N|NAME",
            {"the number from 0 or the name of an animation of the file", {}, "", animation},
            "The pose of the file at a time of this animation."},
           {"--time", "SECONDS", initially(number(out.time, -1e9, 1e9, " seconds"), "the first key of the animation"),
            "That time."},
           {"--frames", "N", initially(number(out.frames, 1, 9999), ""),
            "N pictures from the first key to the last one, OUT-0001.png and on. The camera stays, and takes in all "
            "poses."}}};
}
