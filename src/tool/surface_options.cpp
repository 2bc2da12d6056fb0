// SPDX-License-Identifier: MIT
#include "command/names.h"
#include "tool/option_groups.h"

using namespace command;

namespace {

const Name<KeepRoughness> kKeep[] = {
    {"none", KeepRoughness::kNone}, {"toksvig", KeepRoughness::kToksvig}, {"lean", KeepRoughness::kLean}};
const Name<shd_solid_fade> kFades[] = {
    {"quintic", SHD_SOLID_FADE_QUINTIC}, {"cubic", SHD_SOLID_FADE_CUBIC}, {"linear", SHD_SOLID_FADE_LINEAR}};

/// The shapes of the library, and cycle.
Values shape_values(Options& out) {
  Values values = marked(named(out.shape, names_of(shd_shape_name)), out.has_shape);
  values.names.emplace_back("cycle");
  values.wanted = "one of " + join(values.names);
  values.read = [&out, read = values.read](const std::string& text) {
    out.cycle = text == "cycle";
    if (!out.cycle) return read(text);
    return out.has_shape = true, true;
  };
  return values;
}

const Name<Table> kTables[] = {{"mipmap", Table::kMipmap},
                               {"ripmap", Table::kRipmap},
                               {"summed-area", Table::kSummedArea},
                               {"shadow-map", Table::kShadowMap}};

const Name<Uv> kUvs[] = {{"mesh", Uv::kMesh},
                         {"planar", Uv::kPlanar},
                         {"spherical", Uv::kSpherical},
                         {"cylindrical", Uv::kCylindrical},
                         {"box", Uv::kBox},
                         {"triplanar", Uv::kTriplanar},
                         {"camera", Uv::kCamera}};

}  // namespace

Group surface_options(Options& out) {
  return {
      "Surface",
      {{"--model", "M",
        initially(named(out.reflectance, names_of(shd_model_name, {SHD_MODEL_PROGRAM})),
                  "metallic-roughness for the materials of glTF and environments, else blinn-phong"),
        "Model of reflectance."},
       {"--frequency", "F", named(out.frequency, names_of(shd_frequency_name)), "Where the model is shaded."},
       {"--diffuse", "R,G,B", color_values(out.diffuse), "Colour, instead of the model's."},
       {"--specular", "KS", number(out.specular, 0, 1e6), "Strength of the highlight, instead of the model's."},
       {"--exponent", "P", number(out.exponent, 0, 1e6), "Sharpness of the highlight, instead of the model's."},
       {"--metallic", "M", number(out.metallic, 0, 1),
        "Metallic factor of metallic-roughness, instead of the model's."},
       {"--roughness", "R", number(out.roughness, 0, 1), "Roughness of metallic-roughness, instead of the model's."},
       {"--texture", "FILE", file(out.texture),
        "A texture on everything, instead of the model's. checker is a built-in pattern, none is no texture."},
       {"--table", "T", initially(named(out.table, kTables), ""),
        "A table instead of the model: all levels of --texture as one picture, or its means from the corner; "
        "shadow-map is the depths of the first light that casts shadows, near ones dark."},
       {"--solid", "K", named(out.solid.kind, names_of(shd_solid_name)),
        "A solid texture on everything, instead of the model's textures."},
       {"--solid-size", "S", number(out.solid.size, 0, 1e6),
        "The size of its cells, stripes or rings, in world units."},
       {"--solid-octaves", "N", initially(number(out.solid.octaves, 1, 32), "6, and 1 for worley"),
        "The number of its octaves of noise, each of twice the frequency and half the amplitude."},
       {"--solid-turbulence", "", flag(out.solid.turbulence),
        "Add the absolute values of the octaves of perlin, value or simplex."},
       {"--solid-table", "", flag(out.solid.table),
        "Choose the gradients of perlin by a table of permutations, instead of a hash."},
       {"--solid-fade", "F", initially(named(out.solid.fade, kFades), "quintic"),
        "How perlin, value, marble and wood are interpolated between lattice points."},
       {"--filter", "F", marked(named(out.filter, names_of(shd_filter_name)), out.has_filter),
        "Filter of textures, instead of the model's."},
       {"--magnify", "F", marked(named(out.magnification, names_of(shd_magnification_name)), out.has_filter),
        "Filter of textures where they are magnified; --filter then replaces the model's filters, even if not given."},
       {"--lod-bias", "B", number(out.lod_bias, -15, 15),
        "Added to the level of detail: below 0 is sharper, above 0 smoother."},
       {"--affine", "", flag(out.affine),
        "Interpolate textures and normals linearly on the screen, without perspective, as old consoles did."},
       {"--uv", "K", named(out.uv, kUvs),
        "Coordinates of textures. planar to box: projected from the bounds of the model, for shapes and for meshes "
        "without any. triplanar, camera: for --texture and --normal-map, blended along three axes, or thrown from the "
        "camera."},
       {"--uv-scale", "S", number(out.uv_scale, 0, 1e6), "Textures S times as often."},
       {"--normal-map", "FILE", file(out.normal_map), "Tangent-space normals on everything, instead of the model's."},
       {"--keep-roughness", "K", named(out.keep, kKeep), "What its mip levels do about bumps that they lose."}}};
}

Group shape_options(Options& out) {
  return {
      "Shape",
      {{"--shape", "S", shape_values(out),
        "A shape instead of a model. Cycle is three triangles each of which hides a part of the next one, for "
        "--visibility."},
       {"--tessellation", "N", number(out.tessellation, 1, 256),
        "Divisions of each of the teapot's 32 patches, and of other shapes' sides."},
       {"--floor", "", flag(out.floor), "A floor under the model."},
       {"--any-folder", "", flag(out.any_folder), "Files that the model names may lie outside its folder."},
       {"--height", "FILE", file(out.height_map), "Heights 0..1 on everything, for the following."},
       {"--bump", "FORM", named(out.bump_form, kBumps), "Tilt normals by the heights."},
       {"--bump-scale", "S", number(out.bump_scale, -1e6, 1e6),
        "Height 1 in world units; with texel, a factor on differences."},
       {"--parallax", "D", number(out.parallax, 0, 1e6),
        "Shift textures as if height 0 were D below the surface, in world units."},
       {"--displace", "D", number(out.displacement, -1e6, 1e6),
        "Move the surface itself by the height times D, in world units, finely tessellated."},
       {"--edge-length", "PX", number(out.edge_length, 0.5, 1e4, " pixels"), "Edges of the triangles that are moved."},
       {"--lines", "WIDTH", number(out.line_width, 0, 64, " pixels"), "Draw silhouettes, creases and borders so wide."},
       {"--wireframe", "WIDTH", initially(number(out.wire_width, 0.0625, 64, " pixels"), ""),
        "Draw the edges of all triangles so wide, instead of surfaces."},
       {"--crease", "DEGREES", number(out.crease, 0, 180, " degrees"), "How sharp an edge is a crease."}}};
}
