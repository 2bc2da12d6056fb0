// SPDX-License-Identifier: MIT
// The stream of a Model from a child of the worker: every field arrives, and a reader that lies is refused.
#include <cstring>

#include "scene/read/check_model.h"
#include "scene/read/stream.h"
#include "support/rows.h"

namespace {

using namespace shd::scene;

std::vector<unsigned char> bytes_of(Model& model) {
  std::vector<unsigned char> out;
  FieldWriter writer([&out](const void* bytes, size_t size) {
    const auto* first = static_cast<const unsigned char*>(bytes);
    out.insert(out.end(), first, first + size);
  });
  writer(model);
  return out;
}

/// Reads and checks a model. Throws Failure.
Model model_of(const std::vector<unsigned char>& bytes, uint64_t budget) {
  size_t next = 0;
  FieldReader reader(
      [&](void* out, size_t size) {
        if (size > bytes.size() - next) shd::core::refuse(SHD_ERROR_CORRUPT, "the reply ends too early");
        if (size) std::memcpy(out, bytes.data() + next, size);
        next += size;
      },
      budget);
  Model model;
  reader(model);
  check_model(model, Limits());
  return model;
}

/// A model that uses every vector.
Model full_model() {
  Model m;
  Geometry g;
  g.name = "triangle";
  g.origin = {1, 2, 3};
  g.position = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  g.normal = {0, 0, 1, 0, 0, 1, 0, 0, 1};
  g.tangent = {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, -1};
  g.uv = {0, 0, 1, 0, 0, 1};
  g.uv1 = {0, 0, 2, 0, 0, 2};
  g.color = {1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1};
  g.influences = 1;
  g.joint = {0, 0, 0};
  g.weight = {1, 1, 1};
  g.morphs = {{{1, 1, 1, 1, 1, 1, 1, 1, 1}, {}, {}}};
  g.indices = {0, 1, 2};
  g.shading = Shading::kFlat;
  m.geometries = {g};
  Surface s;
  s.name = "red";
  s.alpha = Alpha::kMask;
  s.maps[SHD_SLOT_DIFFUSE].texture = 0;
  s.maps[SHD_SLOT_DIFFUSE].magnify = Filter::kNearest;
  m.surfaces = {s};
  TextureSource texture;
  texture.name = "texels";
  texture.rgba = {1, 2, 3, 4, 5, 6, 7, 8};
  texture.width = 2;
  texture.height = 1;
  m.textures = {texture};
  Node root, child;
  root.weights = {0.5f};
  child.parent = 0;
  child.parts = true;
  m.nodes = {root, child};
  m.skins = {{{1}, {kIdentity}}};
  m.placements = {{0, 0, 0, 0, {kIdentity, kIdentity}}};
  m.animations = {{"turn", {{1, Target::kRotation, Interpolation::kLinear, {0, 1}, {0, 0, 0, 1, 0, 0, 1, 0}}}}};
  m.lights = {{"sun", shd_light_desc_default(), 1}};
  m.lights[0].desc.intensity[1] = 7;
  m.cameras = {{"eye", shd_camera_default(), -1}};
  m.warnings = {"one", "two"};
  return m;
}

void test_round_trip(void**) {
  Model model = full_model();
  const std::vector<unsigned char> bytes = bytes_of(model);
  Model again = model_of(bytes, 1 << 20);
  assert_true(bytes_of(again) == bytes);
  assert_true(again.geometries[0].color == model.geometries[0].color);
  assert_true(again.lights[0].desc.struct_size == sizeof(shd_light_desc));
  assert_true(again.lights[0].desc.intensity[1] == 7.0f);
  assert_true(again.cameras[0].camera.struct_size == sizeof(shd_camera));
  assert_true(again.warnings == model.warnings);
}

/// A change of the model that the host must refuse.
struct Lie {
  const char* name;
  void (*change)(Model& model);
};
const Lie kLies[] = {
    {"lie/index", [](Model& m) { m.geometries[0].indices[0] = 3; }},
    {"lie/column", [](Model& m) { m.geometries[0].uv.pop_back(); }},
    {"lie/influences", [](Model& m) { m.geometries[0].influences = 4; }},
    {"lie/joint_without_weight", [](Model& m) { m.geometries[0].weight.clear(); }},
    {"lie/morph", [](Model& m) { m.geometries[0].morphs[0].position.pop_back(); }},
    {"lie/shading", [](Model& m) { m.geometries[0].shading = static_cast<Shading>(2); }},
    {"lie/position", [](Model& m) { m.geometries[0].position[0] = HUGE_VALF; }},
    {"lie/alpha", [](Model& m) { m.surfaces[0].alpha = static_cast<Alpha>(3); }},
    {"lie/map", [](Model& m) { m.surfaces[0].maps[0].texture = 1; }},
    {"lie/wrap", [](Model& m) { m.surfaces[0].maps[0].wrap_u = 5; }},
    {"lie/negative_wrap", [](Model& m) { m.surfaces[0].maps[0].wrap_v = -1; }},
    {"lie/filter", [](Model& m) { m.surfaces[0].maps[0].minify = static_cast<Filter>(3); }},
    {"lie/texels", [](Model& m) { m.textures[0].width = 3; }},
    {"lie/texels_overflow", [](Model& m) { m.textures[0].width = m.textures[0].height = 0xffffffffu; }},
    {"lie/parent", [](Model& m) { m.nodes[0].parent = 1; }},
    {"lie/own_parent", [](Model& m) { m.nodes[1].parent = 1; }},
    {"lie/joints", [](Model& m) { m.skins[0].joints[0] = 2; }},
    {"lie/binds", [](Model& m) { m.skins[0].inverse_binds.clear(); }},
    {"lie/geometry", [](Model& m) { m.placements[0].geometry = 1; }},
    {"lie/surface", [](Model& m) { m.placements[0].surface = 1; }},
    {"lie/node", [](Model& m) { m.placements[0].node = 2; }},
    {"lie/skin", [](Model& m) { m.placements[0].skin = 1; }},
    {"lie/no_keys", [](Model& m) { m.animations[0].channels[0].times.clear(); }},
    {"lie/target", [](Model& m) { m.animations[0].channels[0].target = static_cast<Target>(4); }},
    {"lie/interpolation", [](Model& m) { m.animations[0].channels[0].interpolation = static_cast<Interpolation>(3); }},
    {"lie/channel_node", [](Model& m) { m.animations[0].channels[0].node = 2; }},
    {"lie/light_node", [](Model& m) { m.lights[0].node = 2; }},
    {"lie/camera_node", [](Model& m) { m.cameras[0].node = 2; }},
};

void test_lie(void** state) {
  const Lie& lie = *static_cast<const Lie*>(*state);
  Model model = full_model();
  lie.change(model);
  const std::vector<unsigned char> bytes = bytes_of(model);
  bool refused = false;
  try {
    (void)model_of(bytes, 1 << 20);
  } catch (const shd::core::Failure& failure) {
    refused = failure.code == SHD_ERROR_CORRUPT;
  }
  assert_true(refused);
}

/// A reply that ends anywhere is refused.
void test_cut(void**) {
  Model model = full_model();
  const std::vector<unsigned char> bytes = bytes_of(model);
  for (size_t size = 0; size < bytes.size(); ++size) {
    bool refused = false;
    try {
      (void)model_of({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)}, 1 << 20);
    } catch (const shd::core::Failure&) {
      refused = true;
    }
    assert_true(refused);
  }
}

/// Any bytes are refused, or are a model that check_model() accepts; no vector is larger than the budget.
void test_changed(void**) {
  Model model = full_model();
  const std::vector<unsigned char> bytes = bytes_of(model);
  size_t refused = 0;
  uint64_t random = 1;
  for (int i = 0; i < 20000; ++i) {
    std::vector<unsigned char> changed = bytes;
    for (int k = 0; k <= i % 4; ++k) {
      random = random * 6364136223846793005u + 1442695040888963407u;
      changed[(random >> 33) % changed.size()] = static_cast<unsigned char>(random >> 25);
    }
    try {
      (void)model_of(changed, 1 << 16);
    } catch (const shd::core::Failure&) {
      ++refused;
    }
  }
  assert_true(refused > 1000 && refused < 20000);
}

/// Sizes above the budget are refused before memory is taken.
void test_budget(void**) {
  Model model = full_model();
  std::vector<unsigned char> bytes = bytes_of(model);
  const uint64_t huge = uint64_t{1} << 60;
  std::memcpy(bytes.data(), &huge, sizeof huge);  // the number of geometries
  bool refused = false;
  try {
    (void)model_of(bytes, 1 << 20);
  } catch (const shd::core::Failure& failure) {
    refused = failure.code == SHD_ERROR_LIMIT;
  }
  assert_true(refused);
}

}  // namespace

int main() {
  add("round_trip", test_round_trip, nullptr);
  ADD_ROWS(kLies, test_lie);
  add("cut", test_cut, nullptr);
  add("changed", test_changed, nullptr);
  add("budget", test_budget, nullptr);
  return _cmocka_run_group_tests("unit.scene.reply", g_tests, g_count, nullptr, nullptr);
}
