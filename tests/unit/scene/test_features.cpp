// SPDX-License-Identifier: MIT
// The tables of docs/scenes.md: each of their rows has an input here, and each input a row there. Drawn parts change
// the model without a warning. Warned parts have a warning that names them. Refused ones fail.
#include <algorithm>
#include <cstring>
#include <fstream>
#include <functional>
#include <set>
#include <sstream>
#include <vector>

#include "core/failure.h"
#include "scene/read/gltf_document.h"
#include "scene/read/stream.h"
#include "scene/read/text_lines.h"
#include "support/gltf_file.h"
#include "support/rows.h"
#include "support/scene_model.h"

namespace {

using namespace shd::scene;
using namespace shd_test;

struct Input {
  std::string text;
  std::map<std::string, std::string> files;
};

/// A row of the tables: the section, the feature without backticks, and what happens.
struct Row {
  std::string section, feature, verdict;
  Input base, input;  // without and with the feature
  std::string word;   // in the warning or the message
};
std::vector<Row> g_rows;

std::string number(int value) {
  return std::to_string(value);
}

// ---- glTF ----

/// The members of a glTF file of one primitive.
struct Gltf {
  std::string attributes, primitive, nodes = "{\"mesh\":0}", mesh, members, scene = "[0]", scenes;
};

using Edit = std::function<void(Gltf& gltf, GltfFile& file)>;

Input gltf_input(const Edit& edit) {
  Gltf gltf;
  GltfFile file;
  gltf.attributes = "\"POSITION\":" + number(file.square());
  gltf.primitive = "\"indices\":" + number(file.square_indices()) + ",\"material\":0";
  edit(gltf, file);
  const std::string materials = gltf.members.find("\"materials\"") == std::string::npos ? ",\"materials\":[{}]" : "";
  file.members = ",\"scene\":0,\"scenes\":[{\"nodes\":" + gltf.scene + "}" + gltf.scenes + "],\"nodes\":[" +
                 gltf.nodes + "],\"meshes\":[{\"name\":\"m\",\"primitives\":[{\"attributes\":{" + gltf.attributes +
                 "}," + gltf.primitive + "}]" + gltf.mesh + "}]" + materials + gltf.members;
  return {file.text(), {}};
}

void gltf(
    const char* feature, const char* verdict, const char* word, const Edit& edit,
    const Edit& base = [](Gltf&, GltfFile&) {}) {
  g_rows.push_back({"glTF 2.0", feature, verdict, gltf_input(base), gltf_input(edit), word});
}

/// An attribute of the square in floats.
Edit attribute(const char* name, std::vector<float> corner) {
  return [=](Gltf& gltf, GltfFile& file) {
    std::vector<float> column;
    for (int i = 0; i < 4; ++i) column.insert(column.end(), corner.begin(), corner.end());
    gltf.attributes += ",\"" + std::string(name) + "\":" + number(file.column<float>(column, corner.size()));
  };
}

Edit both(const Edit& first, const Edit& second) {
  return [=](Gltf& gltf, GltfFile& file) {
    first(gltf, file);
    second(gltf, file);
  };
}

Edit mode(int mode) {
  return [=](Gltf& gltf, GltfFile& file) {
    gltf.primitive += ",\"mode\":" + number(mode) + "},{\"attributes\":{" + gltf.attributes +
                      "},\"indices\":" + number(file.column<uint16_t>({1, 2, 3}, 1));
  };
}

Edit target(const char* name) {
  return [=](Gltf& gltf, GltfFile& file) {
    attribute("NORMAL", {0, 0, 1})(gltf, file);
    attribute("TANGENT", {1, 0, 0, 1})(gltf, file);
    const std::string column = number(file.column<float>({0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0}, 3));
    gltf.primitive += ",\"targets\":[{\"" + std::string(name) + "\":" + column + "}]";
  };
}

Edit members(const std::string& text) {
  return [=](Gltf& gltf, GltfFile&) { gltf.members += text; };
}

Edit nodes(const std::string& text, const std::string& more = "") {
  return [=](Gltf& gltf, GltfFile&) {
    gltf.nodes = text;
    gltf.members += more;
  };
}

/// A material, with two images and textures, and a sampler.
Edit material(const std::string& text, const std::string& texture = "") {
  return members(",\"materials\":[{" + text + "}],\"images\":[{\"uri\":\"a.png\"},{\"uri\":\"b\"}],\"samplers\":[{" +
                 (texture.empty() ? "" : "\"wrapS\":33071,\"magFilter\":9728") + "}],\"textures\":[{\"source\":0" +
                 (texture.empty() ? "" : ",") + texture + "}]");
}

Edit extension(const char* name, const char* text) {
  return material("\"extensions\":{\"" + std::string(name) + "\":{" + text + "}}");
}

#define TEXTURE(name) "\"" name "\":{\"index\":0}"

void gltf_meshes() {
  const Edit normal = attribute("NORMAL", {0, 0, 1});
  const auto nothing = [](Gltf&, GltfFile&) {};
  gltf("triangles, strips and fans", "drawn", "", [](Gltf& g, GltfFile&) { g.primitive += ",\"mode\":5"; });
  gltf("triangles, strips and fans", "drawn", "", [](Gltf& g, GltfFile&) { g.primitive += ",\"mode\":6"; });
  gltf("points and lines", "warned", "points", mode(0));
  for (const int lines : {1, 2, 3}) gltf("points and lines", "warned", "lines", mode(lines));
  gltf("triangles with indices out of range or positions that are not finite", "warned", "indices out of range",
       [](Gltf& g, GltfFile& f) {
         g.primitive = "\"indices\":" + number(f.column<uint16_t>({0, 1, 2, 0, 2, 9}, 1)) + ",\"material\":0";
       });
  gltf("interleaved, sparse and integer accessors", "drawn", "", [](Gltf& g, GltfFile& f) {
    const int rows = f.view(GltfFile::bytes_of<uint8_t>({2})), values = f.view(GltfFile::bytes_of<float>({2, 2, 0}));
    g.attributes =
        "\"POSITION\":" + number(f.accessor(0, 5126, 4, "VEC3",
                                            ",\"sparse\":{\"count\":1,\"indices\":{\"bufferView\":" + number(rows) +
                                                ",\"componentType\":5121},\"values\":{"
                                                "\"bufferView\":" +
                                                number(values) + "}}"));
  });
  gltf("NORMAL, TANGENT", "drawn", "", normal);
  gltf("NORMAL, TANGENT", "drawn", "", both(normal, attribute("TANGENT", {1, 0, 0, 1})), normal);
  gltf("TEXCOORD_0, TEXCOORD_1, COLOR_0", "drawn", "", attribute("TEXCOORD_0", {0.5f, 0.25f}));
  gltf("TEXCOORD_0, TEXCOORD_1, COLOR_0", "drawn", "", attribute("TEXCOORD_1", {0.5f, 0.25f}));
  gltf("TEXCOORD_0, TEXCOORD_1, COLOR_0", "drawn", "", attribute("COLOR_0", {1, 0, 0}));
  gltf("other attributes", "warned", "TEXCOORD_2", attribute("TEXCOORD_2", {0.5f, 0.25f}));
  for (const char* name : {"POSITION", "NORMAL", "TANGENT"}) {
    const Edit columns = both(normal, attribute("TANGENT", {1, 0, 0, 1}));
    gltf("morph targets of POSITION, NORMAL and TANGENT", "drawn", "", target(name), columns);
  }
  gltf("other morph targets", "warned", "COLOR_0", target("COLOR_0"), nothing);
}

void gltf_scenes() {
  const Edit skin = [](Gltf& g, GltfFile& f) {
    const std::vector<uint8_t> joints(16, 0);
    const std::vector<float> weights = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    g.attributes += ",\"JOINTS_0\":" + number(f.column<uint8_t>(joints, 4)) +
                    ",\"WEIGHTS_0\":" + number(f.column<float>(weights, 4));
    g.nodes = "{\"mesh\":0,\"skin\":0},{\"translation\":[1,0,0]}";
    g.members += ",\"skins\":[{\"joints\":[1]}]";
  };
  const auto animation = [](const char* path, int width) {
    return [=](Gltf& g, GltfFile& f) {
      const std::string times = number(f.column<float>({0, 2}, 1));
      const std::string values = number(f.column<float>(std::vector<float>(size_t(2 * width), 0.5f), size_t(width)));
      g.members += ",\"animations\":[{\"channels\":[{\"sampler\":0,\"target\":{\"node\":0,\"path\":\"" +
                   std::string(path) + "\"}}],\"samplers\":[{\"input\":" + times + ",\"output\":" + values + "}]}]";
    };
  };
  gltf("nodes, skins, animations", "drawn", "", nodes("{\"mesh\":0,\"translation\":[1,2,3]}"));
  gltf("nodes, skins, animations", "drawn", "", skin);
  gltf("nodes, skins, animations", "drawn", "", animation("translation", 3));
  gltf("nodes, skins, animations", "drawn", "", animation("rotation", 4));
  gltf("nodes, skins, animations", "drawn", "", animation("scale", 3));
  gltf("nodes, skins, animations", "drawn", "", both(target("POSITION"), animation("weights", 1)), target("POSITION"));
  gltf("other scenes than the default one", "warned", "is drawn, not the",
       [](Gltf& g, GltfFile&) { g.scenes = ",{\"nodes\":[]}"; });
  const char* with_camera = "{\"mesh\":0,\"camera\":0}";
  gltf("perspective cameras", "drawn", "",
       nodes(with_camera, ",\"cameras\":[{\"type\":\"perspective\",\"perspective\":{\"yfov\":1,\"znear\":0.1}}]"));
  gltf("orthographic cameras", "warned", "no perspective",
       nodes(with_camera,
             ",\"cameras\":[{\"type\":\"orthographic\",\"orthographic\":{\"xmag\":1,\"ymag\":1,"
             "\"znear\":0,\"zfar\":1}}]"));
  for (const char* kind : {"point", "directional", "spot"}) {
    const std::string lights =
        ",\"extensions\":{\"KHR_lights_punctual\":{\"lights\":[{\"type\":\"" + std::string(kind) + "\",\"spot\":{}}]}}";
    gltf("KHR_lights_punctual", "drawn", "",
         nodes("{\"mesh\":0,\"extensions\":{\"KHR_lights_punctual\":{\"light\":0}}}", lights));
  }
  gltf("EXT_mesh_gpu_instancing", "drawn", "", [](Gltf& g, GltfFile& f) {
    g.nodes = "{\"mesh\":0,\"extensions\":{\"EXT_mesh_gpu_instancing\":{\"attributes\":{\"TRANSLATION\":" +
              number(f.column<float>({0, 0, 0, 2, 0, 0}, 3)) + "}}}}";
  });
  gltf("KHR_mesh_quantization", "drawn", "", [](Gltf& g, GltfFile& f) {
    g.attributes = "\"POSITION\":" + number(f.column<int16_t>({0, 0, 0, 9, 0, 0, 9, 9, 0, 0, 9, 0}, 3));
    g.members += ",\"extensionsRequired\":[\"KHR_mesh_quantization\"]";
  });
}

void gltf_materials() {
  const auto drawn = [](const char* feature, const std::string& text, const std::string& base = "",
                        const std::string& texture = "") {
    gltf(feature, "drawn", "", material(text, texture), material(base));
  };
  const char* core = "metallic-roughness materials";
  const std::string base_texture = "\"pbrMetallicRoughness\":{" TEXTURE("baseColorTexture") "}";
  for (const char* value : {"\"baseColorFactor\":[0.5,0,0,1]", "\"metallicFactor\":0.5", "\"roughnessFactor\":0.5",
                            TEXTURE("baseColorTexture"), TEXTURE("metallicRoughnessTexture")}) {
    drawn(core, "\"pbrMetallicRoughness\":{" + std::string(value) + "}");
  }
  for (const char* value : {TEXTURE("normalTexture"), TEXTURE("occlusionTexture"), TEXTURE("emissiveTexture"),
                            "\"emissiveFactor\":[1,0,0]", "\"doubleSided\":true", "\"alphaMode\":\"BLEND\""}) {
    drawn(core, value);
  }
  drawn(core, "\"alphaMode\":\"MASK\",\"alphaCutoff\":0.25", "\"alphaMode\":\"MASK\"");
  drawn("samplers", base_texture, base_texture, "\"sampler\":0");
  gltf("KHR_materials_unlit", "drawn", "", extension("KHR_materials_unlit", ""));
  drawn("KHR_materials_emissive_strength",
        "\"emissiveFactor\":[1,1,1],\"extensions\":{\"KHR_materials_emissive_strength\":{\"emissiveStrength\":5}}",
        "\"emissiveFactor\":[1,1,1]");
  gltf("KHR_materials_ior", "drawn", "", extension("KHR_materials_ior", "\"ior\":1.25"));
  gltf("KHR_materials_transmission", "drawn", "", extension("KHR_materials_transmission", "\"transmissionFactor\":1"));
  gltf("its transmissionTexture", "warned", "transmissionTexture",
       extension("KHR_materials_transmission", "\"transmissionFactor\":1," TEXTURE("transmissionTexture")));
  gltf("KHR_materials_clearcoat", "drawn", "",
       extension("KHR_materials_clearcoat", "\"clearcoatFactor\":1," TEXTURE("clearcoatNormalTexture")));
  gltf("the scale of its clearcoatNormalTexture", "warned", "scale of clearcoatNormalTexture",
       extension("KHR_materials_clearcoat",
                 "\"clearcoatFactor\":1,\"clearcoatNormalTexture\":{\"index\":0,\"scale\":2}"));
  for (const char* value : {"\"specularFactor\":0.5", "\"specularColorFactor\":[1,0,0]", TEXTURE("specularTexture"),
                            TEXTURE("specularColorTexture")}) {
    gltf("KHR_materials_specular", "warned", "KHR_materials_specular", extension("KHR_materials_specular", value));
  }
  gltf("KHR_materials_pbrSpecularGlossiness", "drawn", "",
       extension("KHR_materials_pbrSpecularGlossiness", "\"diffuseFactor\":[0.5,0,0,1]"));
  gltf("its specularGlossinessTexture", "drawn", "",
       extension("KHR_materials_pbrSpecularGlossiness", TEXTURE("specularGlossinessTexture")));
  drawn("KHR_texture_transform",
        "\"emissiveTexture\":{\"index\":0,\"extensions\":{\"KHR_texture_transform\":{\"scale\":"
        "[2,2]}}}",
        TEXTURE("emissiveTexture"));
  for (const char* name : {"EXT_texture_webp", "MSFT_texture_dds"}) {
    drawn(name, base_texture, base_texture, "\"extensions\":{\"" + std::string(name) + "\":{\"source\":1}}");
  }
  gltf("KHR_texture_basisu", "warned", "KHR_texture_basisu",
       material(base_texture, "\"extensions\":{\"KHR_texture_basisu\":{\"source\":1}}"));
  for (const char* name : {"sheen", "anisotropy", "iridescence", "volume", "dispersion", "diffuse_transmission"}) {
    const std::string full = std::string("KHR_materials_") + name;
    gltf("sheen, anisotropy, iridescence, volume, dispersion and other extensions", "warned", full.c_str(),
         extension(full.c_str(), ""));
  }
  gltf("sheen, anisotropy, iridescence, volume, dispersion and other extensions", "warned", "VENDOR_a",
       members(",\"extensionsUsed\":[\"VENDOR_a\"]"));
  gltf("one of these in extensionsRequired", "refused", "KHR_materials_sheen",
       members(",\"extensionsRequired\":[\"KHR_materials_sheen\"]"));
  gltf("KHR_materials_variants", "warned", "\"two\"",
       members(",\"extensions\":{\"KHR_materials_variants\":{\"variants\":[{\"name\":\"one\"},{\"name\":\"two\"}]}}"));
}

/// Compressed geometry needs an encoder: unit.scene.gltf_file has it.
void gltf_compression() {
#ifdef SHD_HAS_DRACO
  assert_true(gltf::honours("KHR_draco_mesh_compression"));
#endif
#ifdef SHD_HAS_MESHOPT
  assert_true(gltf::honours("EXT_meshopt_compression") && gltf::honours("KHR_meshopt_compression"));
#endif
  g_rows.push_back({"glTF 2.0",
                    "KHR_draco_mesh_compression, EXT_meshopt_compression, KHR_meshopt_compression",
                    "drawn",
                    {},
                    {},
                    ""});
}

// ---- text formats ----

void text(const char* section, const char* feature, const char* verdict, const char* word, const std::string& with,
          const std::string& without) {
  g_rows.push_back({section, feature, verdict, {without, {}}, {with, {}}, word});
}

void obj_rows() {
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n", face = "f 1 2 3\n", base = corners + face;
  const auto drawn = [&](const char* feature, const std::string& more) {
    text("Wavefront OBJ", feature, "drawn", "", corners + more, base);
  };
  const auto warned = [&](const char* feature, const char* word, const std::string& more) {
    text("Wavefront OBJ", feature, "warned", word, base + more, base);
  };
  drawn("f with any number of corners", "f 1 2 3 4\n");
  drawn("vt, vn", "vt 0 0\nf 1/1 2/1 3/1\n");
  drawn("vt, vn", "vn 1 0 0\nf 1//1 2//1 3//1\n");
  text("Wavefront OBJ", "v with a colour", "drawn", "", "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0 1 0 0\n" + face,
       "v 0 0 0\nv 1 0 0\nv 1 1 0\n" + face);
  const std::string roof = "v 0 0 1\nf 1 2 3\nf 1 3 5\n";
  text("Wavefront OBJ", "s", "drawn", "", corners + "s off\n" + roof, corners + "s 1\n" + roof);
  drawn("o, g, usemtl", "o part\n" + face);
  drawn("o, g, usemtl", "g part\n" + face);
  warned("f with an index of 0 or out of range", "indices out of range", "f 0 1 2\n");
  warned("f with an index of 0 or out of range", "indices out of range", "f 1 2 9\n");
  warned("f with an index of 0 or out of range", "normals with indices out of range", "f 1//1 2//1 3//1\n");
  for (const char* line : {"l 1 2\n", "p 1\n"}) warned("l, p", line[0] == 'l' ? "lines" : "points", line);
  for (const char* line : {"curv 0 1 1 2\n", "surf 0 1 0 1 1 2\n", "lod 2\n", "shadow_obj a.obj\n", "word 1\n"}) {
    const std::string word(line, std::string(line).find(' '));
    warned("curves, surfaces, display attributes and unknown statements", word.c_str(), line);
  }
  warned("mtllib of a file that is missing", "gone.mtl", "mtllib gone.mtl\nusemtl a\nf 1 3 4\n");
}

void mtl(const char* feature, const char* verdict, const char* word, const std::string& with,
         const std::string& without = "") {
  const char* model = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nusemtl m\nf 1/1 2/1 3/1\n";
  const auto input = [&](const std::string& lines) { return Input{model, {{"a.mtl", "newmtl m\n" + lines}}}; };
  g_rows.push_back({"MTL", feature, verdict, input(without), input(with), word});
}

void mtl_rows() {
  for (const char* line : {"Kd 1 0 0", "Ks 1 0 0", "Ke 1 0 0", "Ns 99", "d 0.5", "Tr 0.5", "illum 0"}) {
    mtl("Kd, Ks, Ke, Ns, d, Tr, illum 0 to 2", "drawn", "", line);
  }
  mtl("Kd, Ks, Ke, Ns, d, Tr, illum 0 to 2", "drawn", "", "Ks 1 1 1\nNs 9\nillum 1", "Ks 1 1 1\nNs 9\nillum 2");
  mtl("Ka of another colour than grey", "warned", "Ka", "Ka 1 0 0");
  for (const char* line : {"Pr 0.25", "Pm 1", "Pr 0.5\nPc 1", "Pm 0\nPc 1\nPcr 0.5"})
    mtl("Pr, Pm, Pc, Pcr", "drawn", "", line);
  mtl("Pc without Pr and Pm; map_Ks and map_Ns beside them", "warned", "Pc without", "Pc 1");
  for (const char* map : {"map_ks", "map_ns"}) {
    mtl("Pc without Pr and Pm; map_Ks and map_Ns beside them", "warned", map, "Pr 1\n" + std::string(map) + " a.png",
        "Pr 1");
  }
  mtl("illum 3 to 10, Tf, Ps, aniso, anisor", "warned", "illum 3", "illum 3");
  for (const char* line : {"Tf 0.5 1 1", "Ps 0.5", "aniso 0.5", "anisor 0.5"}) {
    const std::string word(line, std::string(line).find(' '));
    mtl("illum 3 to 10, Tf, Ps, aniso, anisor", "warned", word.c_str(), line);
  }
  for (const char* map : {"map_Kd", "map_Ks", "map_Ke", "map_Ns", "map_d", "map_bump", "norm", "map_Pr", "map_Pm"}) {
    mtl("map_Kd, map_Ks, map_Ke, map_Ns, map_d, map_bump, norm, map_Pr, map_Pm", "drawn", "",
        std::string(map) + " a.png");
  }
  for (const char* option : {"-s 2 2 1", "-o 0.5 0 0", "-clamp on"}) {
    mtl("options -s, -o, -bm, -clamp, -imfchan", "drawn", "", "map_Kd " + std::string(option) + " a.png",
        "map_Kd a.png");
  }
  mtl("options -s, -o, -bm, -clamp, -imfchan", "drawn", "", "bump -bm 2 a.png", "bump a.png");
  mtl("options -s, -o, -bm, -clamp, -imfchan", "drawn", "", "map_d -imfchan g a.png", "map_d a.png");
  for (const char* option : {"-t 1 1 1", "-mm 0 2", "-blendu off", "-texres 64", "-type sphere"}) {
    const std::string word(option, std::string(option).find(' '));
    mtl("other options", "warned", word.c_str(), "map_Kd " + std::string(option) + " a.png", "map_Kd a.png");
  }
  for (const char* map : {"disp", "decal", "refl", "map_Ka", "map_Ps", "map_aat"}) {
    const std::string word = map == std::string("map_Ka") ? "map_ka" : map == std::string("map_Ps") ? "map_ps" : map;
    mtl("disp, decal, refl, other maps", "warned", word.c_str(), std::string(map) + " a.png");
  }
}

void ply_rows() {
  const auto ply = [](const std::string& vertex, const std::string& vertex_row, const std::string& face = "",
                      const std::string& face_row = "", const std::string& comment = "") {
    std::string out = "ply\nformat ascii 1.0\n" + comment + "element vertex 3\nproperty double x\nproperty double y\n" +
                      "property double z\n" + vertex + "element face 1\nproperty list uchar int vertex_indices\n" +
                      face;
    for (const char* position : {"end_header\n0 0 0", "1 0 0", "1 1 0"}) out += position + vertex_row + "\n";
    return out + "3 0 1 2" + face_row + "\n";
  };
  const std::string base = ply("", ""), rgb = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  const std::string uv = "property float s\nproperty float t\n";
  const auto drawn = [&](const char* feature, const std::string& with) {
    text("PLY", feature, "drawn", "", with, base);
  };
  std::string strip = base, point = base;
  strip.replace(strip.find("face 1"), 6, "tristrips 1").replace(strip.find("3 0 1 2"), 7, "3 1 2 0");
  point.erase(point.find("element face"), point.find("end_header") - point.find("element face"));
  drawn("polygons, tristrips", strip);
  drawn("colours of vertices and of faces", ply(rgb, " 255 0 0"));
  drawn("colours of vertices and of faces", ply("", "", rgb, " 255 0 0"));
  drawn("normals, texture coordinates of vertices and of corners",
        ply("property float nx\nproperty float ny\nproperty float nz\n", " 1 0 0"));
  drawn("normals, texture coordinates of vertices and of corners", ply(uv, " 0 0.5"));
  drawn("normals, texture coordinates of vertices and of corners",
        ply("", "", "property list uchar float texcoord\n", " 6 0 0 1 0 1 1"));
  text("PLY", "comment TextureFile, texnumber", "drawn", "", ply(uv, " 0 0", "", "", "comment TextureFile a.png\n"),
       ply(uv, " 0 0"));
  text("PLY", "other properties and elements", "warned", "quality", ply("property float quality\n", " 1"), base);
  text("PLY", "other properties and elements", "warned", "edge",
       ply("", "", "element edge 1\nproperty int vertex1\n", "\n0"), base);
  text("PLY", "points without faces", "refused", "points", point, base);
}

void stl_rows() {
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\nendfacet\n";
  const std::string base = "solid a\n" + facet + "endsolid a\n";
  const auto binary = [](const std::string& header, uint16_t attribute) {
    std::string out = header;
    out.resize(80, ' ');
    const uint32_t count = 1;
    const float numbers[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 1, 0};
    out.append(reinterpret_cast<const char*>(&count), 4).append(reinterpret_cast<const char*>(numbers), sizeof numbers);
    return out.append(reinterpret_cast<const char*>(&attribute), 2);
  };
  text("STL", "facets, text and binary", "drawn", "", "solid a\n" + facet + facet + "endsolid a\n", base);
  text("STL", "colours of VisCAM and Magics", "drawn", "", binary("part", 0xfc00), binary("part", 0));
  text("STL", "colours of VisCAM and Magics", "drawn", "", binary("COLOR=\xff\x01\x01\xff", 0x8000), binary("part", 0));
  text("STL", "MATERIAL of Magics", "warned", "MATERIAL", binary("COLOR=\xff\x01\x01\xff,MATERIAL=", 0x8000),
       binary("part", 0));
  text("STL", "solids without facets", "warned", "it has no triangles", base + "solid b\nendsolid b\n", base);
  text("STL", "normals of length 0", "warned", "normals of length 0",
       std::string(base).replace(base.find("0 0 1"), 5, "0 0 0"), base);
}

void other_rows() {
  const auto off = [](const char* text) {
    return "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n" + std::string(text) + "\n";
  };
  const char* section = "Other formats";
  text(section, "triangles and polygons", "drawn", "", off("4 0 1 2 3"), off("3 0 1 2"));
  text(section, "lines and points", "warned", "lines and points", off("2 0 1\n3 0 1 2").replace(6, 1, "2"),
       off("3 0 1 2"));
  const char* mesh =
      "xof 0303txt 0032\nFrame a { Mesh m { 3; 0;0;0;, 1;0;0;, 1;1;0;; 1; 3;0,1,2;; XSkinMeshHeader { 1; 1; 1; }\n";
  const char* skin =
      "SkinWeights { \"a\"; 3; 0, 1, 2; 1.0, 1.0, 1.0; 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, "
      "0.0, 0.0, 0.0, 1.0;; }\n";
  const char* animation = "AnimationSet s { Animation { {a} AnimationKey { 2; 2; 0;3;0;0;0;;, 10;3;1;0;0;;; } } }\n";
  const std::string plain = std::string(mesh) + "} }\n";
  text(section, "skins, morph targets, animations", "warned", "skins", std::string(mesh) + skin + "} }\n", plain);
  text(section, "skins, morph targets, animations", "warned", "animations", plain + animation, plain);
}

// ---- the checks ----

std::string bytes_of(Model model) {
  std::string out;
  FieldWriter writer([&out](const void* bytes, size_t size) { out.append(static_cast<const char*>(bytes), size); });
  model.warnings.clear();
  fields(writer, model);
  return out;
}

Model read(const Row& row, const Input& input) {
  return read_text(input.text,
                   row.section != "Other formats" ? "m"
                   : input.text[0] == 'x'         ? "m.x"
                                                  : "m.off",
                   input.files);
}

void test_row(void** state) {
  const Row& row = *static_cast<const Row*>(*state);
  if (row.input.text.empty()) return;
  const Model base = read(row, row.base);
  if (row.verdict == "refused") {
    try {
      read(row, row.input);
    } catch (const shd::core::Failure& failure) {
      if (!std::strstr(failure.what(), row.word.c_str())) fail_msg("%s", failure.what());
      return;
    }
    fail_msg("%s: it is read", row.feature.c_str());
  }
  const Model model = read(row, row.input);
  if (row.verdict == "warned") {
    if (has_warning(base, row.word.c_str()) || !has_warning(model, row.word.c_str()))
      fail_msg("%s: warnings \"%s\"", row.feature.c_str(), warnings_of(model).c_str());
    return;
  }
  assert_string_equal(row.verdict.c_str(), "drawn");
  assert_string_equal(warnings_of(model).c_str(), warnings_of(base).c_str());
  if (bytes_of(model) == bytes_of(base)) fail_msg("%s: the model has nothing of it", row.feature.c_str());
}

/// Rows "| feature | verdict | remark |" of the document, as "section: feature: verdict".
std::set<std::string> rows_of_document() {
  std::ifstream file(SHD_SCENES_DOCUMENT);
  std::set<std::string> rows;
  std::string line, section;
  bool in_table = false;
  while (std::getline(file, line)) {
    if (line.rfind("## ", 0) == 0) section = line.substr(3);
    if (line.rfind("| in the file | picture |", 0) == 0) in_table = true;
    if (line.empty()) in_table = false;
    if (!in_table || line.rfind("| in the file", 0) == 0 || line.rfind("|---", 0) == 0) continue;
    line.erase(std::remove(line.begin(), line.end(), '`'), line.end());
    std::istringstream cells(line);
    std::string empty, feature, verdict;
    std::getline(cells, empty, '|');
    std::getline(cells, feature, '|');
    std::getline(cells, verdict, '|');
    rows.insert(section + ": " + std::string(trimmed(feature)) + ": " + std::string(trimmed(verdict)));
  }
  return rows;
}

void test_document(void**) {
  const std::set<std::string> document = rows_of_document();
  std::set<std::string> tested;
  for (const Row& row : g_rows) tested.insert(row.section + ": " + row.feature + ": " + row.verdict);
  for (const std::string& row : document) {
    if (!tested.count(row)) fail_msg("no test of \"%s\"", row.c_str());
  }
  for (const std::string& row : tested) {
    if (!document.count(row)) fail_msg("not in the document: \"%s\"", row.c_str());
  }
}

}  // namespace

int main() {
  gltf_meshes();
  gltf_scenes();
  gltf_materials();
  gltf_compression();
  obj_rows();
  mtl_rows();
  ply_rows();
  stl_rows();
  other_rows();
  add("document", test_document, nullptr);
  std::vector<std::string> names;
  for (const Row& row : g_rows) names.push_back(row.section + "/" + row.feature);
  for (size_t i = 0; i < g_rows.size(); ++i) {
#if !defined(SHD_HAS_ASSIMP)
    if (g_rows[i].section == std::string("Other formats")) continue;
#endif
    add(names[i].c_str(), test_row, &g_rows[i]);
  }
  return _cmocka_run_group_tests("unit.scene.features", g_tests, g_count, nullptr, nullptr);
}
