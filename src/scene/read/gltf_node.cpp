// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>

#include "scene/read/gltf_document.h"

namespace shd::scene::gltf {
namespace {

constexpr int kMaxNodeDepth = 512;

/// State of the walk over the nodes.
struct Tree {
  Document& document;
  Part nodes;
  std::vector<int32_t> node_of;  // -1: not yet in the Model
  std::vector<bool> is_drawn;    // below the default scene
  std::set<size_t> animated;
  std::map<uint32_t, std::vector<MeshPart>> mesh_of;
  std::map<uint32_t, int32_t> skin_of;
};

/// Translation, rotation and scale of a node.
void read_parts(Document& document, const Part& from, Node& node) {
  from.numbers("translation", node.translation);
  from.numbers("scale", node.scale);
  if (!from.numbers("rotation", node.rotation)) return;
  double square = 0.0;
  for (const double c : node.rotation) square += c * c;
  if (!(square > 0.0)) document.warnings.add(title_of("node", from) + ": its rotation has length 0");
  for (double& c : node.rotation) c = square > 0.0 ? c / std::sqrt(square) : 0.0;
  if (!(square > 0.0)) node.rotation = {0, 0, 0, 1};
}

std::vector<float> weights_of(const Part& part) {
  std::vector<float> out;
  const Part weights = part["weights"];
  for (size_t i = 0; i < weights.size(); ++i) out.push_back(static_cast<float>(weights.at(i).number()));
  return out;
}

Node read_node(Tree& tree, size_t index, int32_t parent) {
  const Part from = tree.nodes.at(index);
  Node node;
  node.name = name_of(from);
  node.parent = parent;
  node.parts = !from.numbers("matrix", node.matrix) || tree.animated.count(index) != 0;
  if (!from["matrix"]) read_parts(tree.document, from, node);
  if (from["matrix"] && node.parts) {
    tree.document.warnings.add(title_of("node", from) + ": it has a matrix, so that it is not animated");
    node.parts = false;
  }
  node.weights = weights_of(from);
  const Part meshes = tree.document.root["meshes"];
  const std::optional<uint32_t> mesh = from.index("mesh", meshes.size());
  if (node.weights.empty() && mesh) node.weights = weights_of(meshes.at(*mesh));
  return node;
}

/// Adds the nodes below `root`, parents first.
void add_tree(Tree& tree, size_t root, bool drawn) {
  struct Visit {
    size_t node;
    int32_t parent;
    int depth;
  };
  std::vector<Visit> open = {{root, -1, 0}};
  Model& model = tree.document.model;
  while (!open.empty()) {
    const Visit visit = open.back();
    open.pop_back();
    const Part from = tree.nodes.at(visit.node);
    if (tree.node_of[visit.node] >= 0) {
      if (drawn) from.refuse("has two parents, or is below itself");
      tree.document.warnings.add(title_of("node", from) + ": a parent outside the scene is left out");
      continue;
    }
    if (visit.depth > kMaxNodeDepth)
      core::refuse(SHD_ERROR_LIMIT, "its nodes are nested more than %d deep", kMaxNodeDepth);
    const auto index = static_cast<int32_t>(model.nodes.size());
    tree.node_of[visit.node] = index;
    tree.is_drawn[visit.node] = drawn;
    model.nodes.push_back(read_node(tree, visit.node, visit.parent));
    const Part children = from["children"];
    for (size_t i = children.size(); i-- > 0;) {
      const uint64_t child = children.at(i).integer();
      if (child >= tree.nodes.size()) children.at(i).refuse(std::to_string(child) + " is no node");
      open.push_back({static_cast<size_t>(child), index, visit.depth + 1});
    }
  }
}

/// The nodes of the default scene, or of the first one; without scenes all that have no parent.
std::vector<size_t> roots_of(Tree& tree) {
  Document& document = tree.document;
  const Part scenes = document.root["scenes"];
  std::vector<size_t> out;
  if (scenes.size() == 0) return out;
  const uint32_t chosen = document.root.index("scene", scenes.size()).value_or(0);
  const Part nodes = scenes.at(chosen)["nodes"];
  for (size_t i = 0; i < nodes.size(); ++i) {
    const uint64_t node = nodes.at(i).integer();
    if (node >= tree.nodes.size()) nodes.at(i).refuse(std::to_string(node) + " is no node");
    out.push_back(static_cast<size_t>(node));
  }
  if (scenes.size() > 1) {
    document.warnings.add(title_of("scene", scenes.at(chosen)) + " is drawn, not the " +
                          std::to_string(scenes.size() - 1) + " other scenes");
  }
  return out;
}

void find_animated(Tree& tree) {
  const Part animations = tree.document.root["animations"];
  for (size_t i = 0; i < animations.size(); ++i) {
    const Part channels = animations.at(i)["channels"];
    for (size_t k = 0; k < channels.size(); ++k) {
      const Part target = channels.at(k)["target"];
      const std::optional<uint32_t> node = target.index("node", tree.nodes.size());
      if (node && target.text("path") != "weights") tree.animated.insert(*node);
    }
  }
}

/// The Model's skin of a skin; -1 if it has a fault.
int32_t skin_of(Tree& tree, uint32_t index) {
  const auto known = tree.skin_of.find(index);
  if (known != tree.skin_of.end()) return known->second;
  Document& document = tree.document;
  const Part from = document.root["skins"].at(index);
  Skin skin;
  const bool good = attempt(document, title_of("skin", from), [&] {
    const Part joints = from["joints"];
    for (size_t i = 0; i < joints.size(); ++i) {
      const uint64_t node = joints.at(i).integer();
      if (node >= tree.nodes.size() || tree.node_of[static_cast<size_t>(node)] < 0) joints.at(i).refuse("is no node");
      skin.joints.push_back(static_cast<uint32_t>(tree.node_of[static_cast<size_t>(node)]));
    }
    if (skin.joints.empty()) from.refuse("has no joints");
    skin.inverse_binds.assign(skin.joints.size(), kIdentity);
    const Part reference = from["inverseBindMatrices"];
    if (!reference) return;
    const Accessor accessor = open_accessor(document, reference);
    if (accessor.components != 16 || accessor.count < skin.joints.size()) reference.refuse("has too few matrices");
    std::vector<uint32_t> rows(skin.joints.size());
    for (uint32_t i = 0; i < rows.size(); ++i) rows[i] = i;
    const std::vector<float> numbers = read_floats(accessor, &rows);
    for (size_t i = 0; i < numbers.size(); ++i) {
      if (!std::isfinite(numbers[i])) reference.refuse("has numbers that are not finite");
      skin.inverse_binds[i / 16][i % 16] = static_cast<double>(numbers[i]);
    }
  });
  const int32_t made = good ? static_cast<int32_t>(document.model.skins.size()) : -1;
  if (good) document.model.skins.push_back(std::move(skin));
  tree.skin_of[index] = made;
  return made;
}

void spend_instances(Document& document, uint64_t count) {
  document.instances += count;
  check_limit("instances", document.instances, "max_instances", document.source.limits.instances);
}

Matrix matrix_of_parts(const float* t, const float* r, const float* s) {
  const double x = static_cast<double>(r[0]), y = static_cast<double>(r[1]), z = static_cast<double>(r[2]),
               w = static_cast<double>(r[3]), square = x * x + y * y + z * z + w * w;
  const double f = square > 0.0 ? 2.0 / square : 0.0;
  const double columns[3][3] = {{1 - f * (y * y + z * z), f * (x * y + z * w), f * (x * z - y * w)},
                                {f * (x * y - z * w), 1 - f * (x * x + z * z), f * (y * z + x * w)},
                                {f * (x * z + y * w), f * (y * z - x * w), 1 - f * (x * x + y * y)}};
  Matrix out = kIdentity;
  for (size_t c = 0; c < 3; ++c) {
    for (size_t k = 0; k < 3; ++k) out[4 * c + k] = columns[c][k] * static_cast<double>(s[c]);
    out[12 + c] = static_cast<double>(t[c]);
  }
  return out;
}

/// EXT_mesh_gpu_instancing. `size` numbers for each of `count` copies, or none.
std::vector<float> read_copies(Document& document, const Part& attributes, const char* name, uint32_t size,
                               size_t* count) {
  const Part reference = attributes[name];
  if (!reference) return {};
  const Accessor accessor = open_accessor(document, reference);
  if (accessor.components != size) reference.refuse("its elements do not have " + std::to_string(size) + " components");
  if (*count != 0 && accessor.count != *count) reference.refuse("has another count than the other attributes");
  if (*count == 0) spend_instances(document, accessor.count);
  *count = accessor.count;
  std::vector<float> out = read_floats(accessor);
  for (const float number : out) {
    if (!std::isfinite(number)) reference.refuse("has numbers that are not finite");
  }
  return out;
}

std::vector<Matrix> copies_of(Document& document, const Part& instancing) {
  const Part attributes = instancing["attributes"];
  size_t count = 0;
  const std::vector<float> t = read_copies(document, attributes, "TRANSLATION", 3, &count);
  const std::vector<float> r = read_copies(document, attributes, "ROTATION", 4, &count);
  const std::vector<float> s = read_copies(document, attributes, "SCALE", 3, &count);
  const float zero[3] = {0, 0, 0}, one[3] = {1, 1, 1}, straight[4] = {0, 0, 0, 1};
  std::vector<Matrix> out;
  for (size_t i = 0; i < count; ++i) {
    out.push_back(
        matrix_of_parts(t.empty() ? zero : &t[3 * i], r.empty() ? straight : &r[4 * i], s.empty() ? one : &s[3 * i]));
  }
  return out;
}

void place_mesh(Tree& tree, const Part& from, uint32_t node, uint32_t mesh) {
  Document& document = tree.document;
  auto known = tree.mesh_of.find(mesh);
  if (known == tree.mesh_of.end()) known = tree.mesh_of.emplace(mesh, add_mesh(document, mesh)).first;
  if (known->second.empty()) return;
  Placement placement;
  placement.node = node;
  if (const auto skin = from.index("skin", document.root["skins"].size())) placement.skin = skin_of(tree, *skin);
  const Part instancing = from.extension("EXT_mesh_gpu_instancing");
  if (instancing) {
    const bool good = attempt(document, title_of("node", from) + ": EXT_mesh_gpu_instancing",
                              [&] { placement.copies = copies_of(document, instancing); });
    if (good && placement.copies.empty()) return;
  }
  for (const MeshPart& part : known->second) {
    placement.geometry = part.geometry;
    placement.surface = part.surface;
    spend_instances(document, placement.copies.empty() ? 1 : placement.copies.size());
    document.model.placements.push_back(placement);
  }
}

/// Adds mesh, camera and light of a node of the scene.
void fill_node(Tree& tree, size_t index) {
  Document& document = tree.document;
  const Part from = tree.nodes.at(index);
  const auto node = static_cast<uint32_t>(tree.node_of[index]);
  const auto mesh = from.index("mesh", document.root["meshes"].size());
  if (mesh) place_mesh(tree, from, node, *mesh);
  const Part cameras = document.root["cameras"];
  if (const auto camera = from.index("camera", cameras.size())) add_camera(document, cameras.at(*camera), node);
  const Part lights = document.root.extension("KHR_lights_punctual")["lights"];
  const Part light = from.extension("KHR_lights_punctual");
  if (const auto row = light.index("light", lights.size())) add_light(document, lights.at(*row), node);
}

}  // namespace

std::vector<int32_t> add_nodes(Document& document) {
  Tree tree = {document, document.root["nodes"], {}, {}, {}, {}, {}};
  const size_t count = tree.nodes.size();
  check_limit("nodes", count, "max_nodes", document.source.limits.nodes);
  tree.node_of.assign(count, -1);
  tree.is_drawn.assign(count, false);
  find_animated(tree);
  for (const size_t root : roots_of(tree)) add_tree(tree, root, true);
  // Nodes outside the scene may be joints of its skins.
  std::vector<bool> is_child(count);
  for (size_t i = 0; i < count; ++i) {
    const Part children = tree.nodes.at(i)["children"];
    for (size_t k = 0; k < children.size(); ++k) {
      const uint64_t child = children.at(k).integer();
      if (child < count) is_child[static_cast<size_t>(child)] = true;
    }
  }
  const bool no_scene = document.root["scenes"].size() == 0;
  for (size_t i = 0; i < count; ++i) {
    if (!is_child[i] && tree.node_of[i] < 0) add_tree(tree, i, no_scene);
  }
  for (size_t i = 0; i < count; ++i) {
    document.source.deadline.check();
    if (tree.is_drawn[i]) fill_node(tree, i);
  }
  return tree.node_of;
}

}  // namespace shd::scene::gltf
