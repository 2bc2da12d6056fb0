// SPDX-License-Identifier: MIT
// Subdivided triangles for every mix of parts; closed meshes stay closed; columns are interpolated; areas are kept.
#include "support/check.h"

#include <algorithm>
#include <array>
#include <vector>

#include "core/context.h"
#include "data/camera.h"
#include "data/transform.h"
#include "geometry/cut.h"
#include "geometry/row_pattern.h"
#include "geometry/split_edges.h"
#include "geometry/tessellate.h"
#include "support/random.h"

namespace {

using namespace shd::geometry;

shd::core::Context* g_context;

/// Working memory of a test. It is static because cmocka leaves a test by longjmp.
struct Work {
  std::vector<float> rows;  // position, normal, uv
  std::vector<uint32_t> indices;
  std::vector<uint64_t> sides;
  Mesh mesh, cut;
};
Work g_work;

void clear() {
  g_work.rows.clear();
  g_work.indices.clear();
}
uint32_t add_vertex(double x, double y, double z, double nx, double ny, double nz, double u, double v) {
  for (const double value : {x, y, z, nx, ny, nz, u, v}) g_work.rows.push_back(static_cast<float>(value));
  return static_cast<uint32_t>(g_work.rows.size() / 8 - 1);
}
void add_triangle(uint32_t a, uint32_t b, uint32_t c) {
  for (const uint32_t i : {a, b, c}) g_work.indices.push_back(i);
}

/// Columns that are affine in the position, as references for the interpolation.
constexpr int kAffine = 3;
double affine(int which, const float* p) {
  const double x = static_cast<double>(p[0]), y = static_cast<double>(p[1]), z = static_cast<double>(p[2]);
  return which == 0 ? x + 2 * y - z : which == 1 ? 0.5 - 0.25 * x + z : 3 * z - y;
}

void build_mesh(uint32_t flags) {
  shd_mesh_desc desc = shd_mesh_desc_default();
  static std::vector<float> extra[kAffine];
  desc.vertex_count = static_cast<uint32_t>(g_work.rows.size() / 8);
  for (size_t c = 0; c < 3; ++c) desc.position[c] = {&g_work.rows[c], 32};
  for (size_t c = 0; c < 3; ++c) desc.normal[c] = {&g_work.rows[3 + c], 32};
  for (size_t c = 0; c < 2; ++c) desc.uv[c] = {&g_work.rows[6 + c], 32};
  for (int c = 0; c < kAffine; ++c) {
    extra[c].clear();
    for (size_t i = 0; i < desc.vertex_count; ++i) {
      extra[c].push_back(static_cast<float>(affine(c, &g_work.rows[8 * i])));
    }
  }
  desc.uv1[0].data = extra[0].data();
  desc.uv1[1].data = extra[1].data();
  shd_f32_in attributes[6] = {};
  attributes[5].data = extra[2].data();
  desc.attributes = attributes;
  desc.attribute_count = 6;
  desc.indices.data = g_work.indices.data();
  desc.index_count = g_work.indices.size();
  desc.flags = flags;
  Mesh mesh{};
  build(*g_context, desc, &mesh);
  g_work.mesh = std::move(mesh);
}

void run_tessellate(const shd_tessellation_desc& desc) {
  Mesh cut{};
  tessellate(*g_context, g_work.mesh, desc, nullptr, nullptr, &cut);
  g_work.cut = std::move(cut);
}

/// Every side of a triangle, between positions, is used once in each direction. With degenerate triangles it is used
/// equally often in both directions.
void check_closed(const char* name, const Mesh& mesh, bool once) {
  std::vector<std::array<uint32_t, 3>> keys(mesh.vertex_count);
  std::vector<uint32_t> order(mesh.vertex_count), place(mesh.vertex_count);
  for (uint32_t i = 0; i < mesh.vertex_count; ++i) {
    const float p[3] = {mesh.px[i], mesh.py[i], mesh.pz[i]};
    memcpy(keys[i].data(), p, sizeof p);
    order[i] = i;
  }
  std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return keys[a] < keys[b]; });
  for (uint32_t i = 0, id = 0; i < mesh.vertex_count; ++i) {
    if (i && keys[order[i]] != keys[order[i - 1]]) ++id;
    place[order[i]] = id;
  }
  g_work.sides.clear();
  for (size_t s = 0; s < mesh.indices.size(); ++s) {
    const uint64_t a = place[mesh.indices[s]], b = place[mesh.indices[s % 3 == 2 ? s - 2 : s + 1]];
    if (a != b) g_work.sides.push_back(a << 32 | b);
  }
  std::vector<uint64_t>& sides = g_work.sides;
  std::sort(sides.begin(), sides.end());
  size_t open = 0, doubled = 0;
  for (size_t i = 0; i < sides.size(); ++i) {
    const uint64_t back = sides[i] << 32 | sides[i] >> 32;
    const auto there = std::equal_range(sides.begin(), sides.end(), sides[i]);
    const auto opposite = std::equal_range(sides.begin(), sides.end(), back);
    open += there.second - there.first != opposite.second - opposite.first;
    doubled += there.second - there.first != 1;
  }
  if (open || (once && doubled)) fail_msg("%s: %zu sides open, %zu doubled", name, open, doubled);
}

double area_of(const Mesh& mesh) {
  double sum = 0;
  for (size_t t = 0; t < mesh.triangle_count; ++t) {
    double e[2][3], n[3];
    const uint32_t* v = mesh.indices.data() + 3 * t;
    for (int k = 0; k < 2; ++k) {
      const uint32_t a = v[0], b = v[k + 1];
      e[k][0] = static_cast<double>(mesh.px[b]) - static_cast<double>(mesh.px[a]);
      e[k][1] = static_cast<double>(mesh.py[b]) - static_cast<double>(mesh.py[a]);
      e[k][2] = static_cast<double>(mesh.pz[b]) - static_cast<double>(mesh.pz[a]);
    }
    for (int c = 0; c < 3; ++c) n[c] = e[0][(c + 1) % 3] * e[1][(c + 2) % 3] - e[0][(c + 2) % 3] * e[1][(c + 1) % 3];
    sum += 0.5 * std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  }
  return sum;
}

// Shapes, all closed.

void tetrahedron() {
  clear();
  const double p[4][3] = {{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}};
  for (const auto& q : p) add_vertex(q[0], q[1], q[2], q[0], q[1], q[2], q[0], q[1]);
  add_triangle(0, 1, 3);
  add_triangle(0, 2, 1);
  add_triangle(0, 3, 2);
  add_triangle(1, 2, 3);
}
/// Six sides, each with its own vertices, normals and uv.
void cube_of_six_sides() {
  clear();
  for (int axis = 0; axis < 3; ++axis) {
    for (int sign = -1; sign <= 1; sign += 2) {
      uint32_t corner[4];
      for (int k = 0; k < 4; ++k) {
        const double a = k == 1 || k == 2 ? 1 : -1, b = k >= 2 ? 1 : -1;
        double p[3], n[3] = {0, 0, 0};
        p[axis] = n[axis] = sign;
        p[(axis + 1) % 3] = sign * a;
        p[(axis + 2) % 3] = b;
        corner[k] = add_vertex(p[0] * 0.7, p[1] * 1.3, p[2], n[0], n[1], n[2], 0.5 + 0.5 * a, 0.5 + 0.5 * b);
      }
      add_triangle(corner[0], corner[1], corner[2]);
      add_triangle(corner[0], corner[2], corner[3]);
    }
  }
}
void sphere(uint32_t across, uint32_t down, bool whole_poles) {
  clear();
  for (uint32_t y = 0; y <= down; ++y) {
    for (uint32_t x = 0; x <= across; ++x) {
      const double u = 1.0 * x / across, v = 1.0 * y / down;
      const double a = 6.283185307179586 * (x % across) / across, b = 3.141592653589793 * v;
      const double s = y == 0 || y == down ? 0 : std::sin(b);
      const double n[3] = {std::cos(a) * s, std::cos(b), -std::sin(a) * s};
      add_vertex(2 * n[0], n[1], n[2], n[0], n[1], n[2], u, v);
    }
  }
  for (uint32_t y = 0; y < down; ++y) {
    for (uint32_t x = 0; x < across; ++x) {
      const uint32_t a = y * (across + 1) + x, b = a + across + 1;
      if (y + 1 < down || whole_poles) add_triangle(a, b, b + 1);
      if (y > 0 || whole_poles) add_triangle(a, b + 1, a + 1);
    }
  }
}
void sphere_with_seam() {
  sphere(13, 9, false);
}
void sphere_with_flat_poles() {
  sphere(7, 5, true);
}
void octahedron_moved() {
  clear();
  shd::tests::Random random{3};
  for (int k = 0; k < 6; ++k) {
    double p[3] = {random.in(-0.3, 0.3), random.in(-0.3, 0.3), random.in(-0.3, 0.3)};
    p[k / 2] += k % 2 ? -3 : 3;
    add_vertex(p[0], p[1], p[2], p[0], p[1], p[2], p[0], p[2]);
  }
  for (uint32_t k = 0; k < 8; ++k) {
    const uint32_t x = k & 1, y = 2 + (k >> 1 & 1), z = 4 + (k >> 2);
    if ((x + y + z) % 2 == 0) {
      add_triangle(x, y, z);
    } else {
      add_triangle(x, z, y);
    }
  }
}
void torus_unindexed() {
  clear();
  constexpr int kBig = 9, kSmall = 6;
  const auto corner = [](int i, int j) {
    const double a = 6.283185307179586 * (i % kBig) / kBig, b = 6.283185307179586 * (j % kSmall) / kSmall;
    const double n[3] = {std::cos(a) * std::cos(b), std::sin(b), -std::sin(a) * std::cos(b)};
    return add_vertex(3 * std::cos(a) + n[0], n[1], -3 * std::sin(a) + n[2], n[0], n[1], n[2], 1.0 * i / kBig,
                      1.0 * j / kSmall);
  };
  for (int i = 0; i < kBig; ++i) {
    for (int j = 0; j < kSmall; ++j) {
      const uint32_t a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1);
      add_triangle(a, b, c);
      const uint32_t d = corner(i, j), e = corner(i + 1, j + 1), f = corner(i, j + 1);
      add_triangle(d, e, f);
    }
  }
}

struct Shape {
  const char* name;
  void (*make)();
  bool once;
};
const Shape kShapes[] = {
    {"tetrahedron", tetrahedron, true},           {"cube_of_six_sides", cube_of_six_sides, true},
    {"sphere_with_seam", sphere_with_seam, true}, {"sphere_with_flat_poles", sphere_with_flat_poles, false},
    {"octahedron_moved", octahedron_moved, true}, {"torus_unindexed", torus_unindexed, true},
};

shd_tessellation_desc uniform(uint32_t segments) {
  shd_tessellation_desc desc = shd_tessellation_desc_default();
  desc.segments = segments;
  return desc;
}
shd_tessellation_desc adaptive(float edge_length) {
  shd_tessellation_desc desc = shd_tessellation_desc_default();
  desc.mode = SHD_TESSELLATION_MODE_ADAPTIVE;
  desc.edge_length = edge_length;
  return desc;
}

/// Tests the columns of every vertex against the affine functions of its position, and normals for unit length.
void check_columns(const char* name, const Mesh& mesh) {
  for (size_t i = 0; i < mesh.vertex_count; ++i) {
    const float p[3] = {mesh.px[i], mesh.py[i], mesh.pz[i]};
    shd_assert_close(name, i, static_cast<double>(mesh.u1[i]), affine(0, p), 3e-6, 0);
    shd_assert_close(name, i, static_cast<double>(mesh.v1[i]), affine(1, p), 3e-6, 0);
    shd_assert_close(name, i, static_cast<double>(mesh.attribute[5][i]), affine(2, p), 3e-6, 0);
    const double n[3] = {static_cast<double>(mesh.nx[i]), static_cast<double>(mesh.ny[i]),
                         static_cast<double>(mesh.nz[i])};
    shd_assert_close(name, i, n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1.0, 3e-7, 0);
    assert_true(mesh.attribute[4].size() == 0);
  }
}

void check_shape(const Shape& shape, const shd_tessellation_desc& desc) {
  run_tessellate(desc);
  check_closed(shape.name, g_work.cut, shape.once);
  check_columns(shape.name, g_work.cut);
  const double want = area_of(g_work.mesh);
  shd_assert_close(shape.name, 0, area_of(g_work.cut), want, 0, 1e-6);
  assert_int_equal(g_work.cut.info.triangle_count, g_work.cut.triangle_count);
  assert_int_equal(g_work.cut.info.vertex_count, g_work.cut.vertex_count);
}

void test_uniform(void** state) {
  const Shape& shape = *static_cast<const Shape*>(*state);
  for (const uint32_t segments : {1u, 2u, 3u, 4u, 7u, 16u}) {
    shape.make();
    build_mesh(SHD_MESH_TANGENTS);
    check_shape(shape, uniform(segments));
    assert_int_equal(g_work.cut.triangle_count, g_work.mesh.triangle_count * segments * segments);
    for (size_t i = 0; i < g_work.mesh.vertex_count; ++i) {  // the vertices of the original mesh come first
      assert_true(g_work.cut.px[i] == g_work.mesh.px[i] && g_work.cut.nx[i] == g_work.mesh.nx[i]);
      assert_true(g_work.cut.tx[i] == g_work.mesh.tx[i] && g_work.cut.tw[i] == g_work.mesh.tw[i]);
    }
  }
}

void test_adaptive(void** state) {
  const Shape& shape = *static_cast<const Shape*>(*state);
  size_t before = 0;
  for (const float length : {100.0f, 1.0f, 0.43f, 0.2f, 0.07f}) {
    shape.make();
    build_mesh(0);
    check_shape(shape, adaptive(length));
    assert_true(g_work.cut.triangle_count >= before);
    before = g_work.cut.triangle_count;
  }
  assert_true(before > 4000);
}

void set_look_at(const float* eye, const float* target, const float* up, shd_view* view) {
  shd::data::Vec3d axes[3];
  assert_true(shd::data::find_axes(eye, target, up, axes));
  shd::data::look_at(eye, axes, view->world_to_view);
}

void test_adaptive_in_pixels(void** state) {
  const Shape& shape = *static_cast<const Shape*>(*state);
  shd_view view = {};
  const float eye[3] = {2.6f, 0.7f, 1.1f}, target[3] = {0, 0, 0}, up[3] = {0, 1, 0};  // close to the mesh, or inside it
  const float object_to_world[16] = {0, 2, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0.5f, 0, 0, 1};
  set_look_at(eye, target, up, &view);
  shd::data::perspective(1.0f, 1.5f, 0.1f, 100.0f, view.view_to_clip);
  shd_tessellation_desc desc = adaptive(30.0f);
  desc.view = view;
  desc.picture_width = 1500;
  desc.picture_height = 1000;
  for (const bool is_placed : {false, true}) {
    shape.make();
    build_mesh(0);
    if (is_placed) std::copy_n(object_to_world, 16, desc.object_to_world);
    check_shape(shape, desc);
    assert_true(g_work.cut.triangle_count > 10 * g_work.mesh.triangle_count);
  }
}

/// Random numbers of parts for every edge, independent of lengths.
void test_random_parts(void** state) {
  const Shape& shape = *static_cast<const Shape*>(*state);
  for (uint64_t seed = 1; seed <= 12; ++seed) {
    const int64_t maximum = seed < 5 ? 4 : 20;
    shape.make();
    build_mesh(0);
    SplitEdges edges = split_edges(g_context->allocator, g_work.mesh, EdgeFactor(uniform(1)));
    edges.vertex_count = g_work.mesh.vertex_count;
    const auto bits = [&](uint32_t v) {  // seams agree: the parts depend only on positions
      float p[3] = {g_work.mesh.px[v] + 0.0f, g_work.mesh.py[v] + 0.0f, g_work.mesh.pz[v] + 0.0f};
      return shd_hash(seed, p, sizeof p);
    };
    for (size_t e = 0; e < edges.edge.size(); ++e) {
      SplitEdge& edge = edges.edge[e];
      shd::tests::Random of_edge{bits(edge.start) + bits(edge.end)};
      edge.segments = static_cast<uint32_t>(of_edge.whole(1, maximum));
      edge.first = edges.vertex_count;
      edges.vertex_count += edge.segments - 1;
    }
    const CutMesh cut = cut_triangles(g_context->allocator, g_work.mesh, edges);
    Mesh out{};
    out.vertex_count = static_cast<uint32_t>(cut.origins.size());
    out.triangle_count = static_cast<uint32_t>(cut.indices.size() / 3);
    out.px = shd::core::Array<float>(g_context->allocator, out.vertex_count);
    out.py = shd::core::Array<float>(g_context->allocator, out.vertex_count);
    out.pz = shd::core::Array<float>(g_context->allocator, out.vertex_count);
    out.indices = shd::core::Array<uint32_t>(g_context->allocator, cut.indices.size());
    memcpy(out.indices.data(), cut.indices.data(), cut.indices.size() * sizeof(uint32_t));
    const auto mix = [&](const shd::core::Array<float>& from, const Origin& o) {
      const double a = static_cast<double>(from[o.a]), b = static_cast<double>(from[o.b]);
      return static_cast<float>(a + o.s * (b - a) + o.t * (static_cast<double>(from[o.c]) - a));
    };
    for (size_t i = 0; i < out.vertex_count; ++i) {
      out.px[i] = mix(g_work.mesh.px, cut.origins[i]);
      out.py[i] = mix(g_work.mesh.py, cut.origins[i]);
      out.pz[i] = mix(g_work.mesh.pz, cut.origins[i]);
    }
    check_closed(shape.name, out, shape.once);
    shd_assert_close(shape.name, seed, area_of(out), area_of(g_work.mesh), 0, 1e-6);
  }
}

/// One triangle in barycentric coordinates: every piece has area, and the areas add up to the whole.
void check_pieces(uint32_t a, uint32_t b, uint32_t c) {
  const uint32_t parts[3] = {a, b, c};
  const RowPattern pattern(parts);
  uint32_t next = 3;
  SplitEdges edges = {shd::core::Buffer<SplitEdge>(g_context->allocator),
                      shd::core::Array<uint32_t>(g_context->allocator, 3), 0};
  for (uint32_t k = 0; k < 3; ++k) {
    const bool back = (a + b + c + k) % 2;
    edges.edge.push_back({back ? (k + 1) % 3 : k, back ? k : (k + 1) % 3, parts[k], next});
    edges.of_side[k] = k;
    next += parts[k] - 1;
  }
  edges.vertex_count = next;
  Mesh mesh{};
  mesh.vertex_count = 3;
  mesh.triangle_count = 1;
  mesh.indices = shd::core::Array<uint32_t>(g_context->allocator, 3);
  for (uint32_t k = 0; k < 3; ++k) mesh.indices[k] = k;
  const CutMesh cut = cut_triangles(g_context->allocator, mesh, edges);
  assert_int_equal(cut.indices.size(), 3 * pattern.triangle_count());
  assert_int_equal(cut.origins.size(), next + pattern.inner_count());
  const double corner[3][2] = {{0, 0}, {1, 0}, {0, 1}};
  const auto place = [&](uint32_t v, int axis) {
    const Origin& o = cut.origins[v];
    const double p = corner[o.a][axis];
    return p + o.s * (corner[o.b][axis] - p) + o.t * (corner[o.c][axis] - p);
  };
  double sum = 0;
  for (size_t t = 0; t < cut.indices.size(); t += 3) {
    const uint32_t* v = cut.indices.data() + t;
    const double x = place(v[0], 0), y = place(v[0], 1);
    const double twice = (place(v[1], 0) - x) * (place(v[2], 1) - y) - (place(v[2], 0) - x) * (place(v[1], 1) - y);
    if (!(twice > 1e-12)) fail_msg("parts %u %u %u: triangle %zu has area %g", a, b, c, t / 3, twice);
    sum += twice;
  }
  shd_assert_close("area", 0, sum, 1.0, 1e-9, 0);
  std::vector<uint64_t>& sides = g_work.sides;  // inner sides twice, outer sides once
  sides.clear();
  for (size_t s = 0; s < cut.indices.size(); ++s) {
    const uint64_t p = cut.indices[s], q = cut.indices[s % 3 == 2 ? s - 2 : s + 1];
    sides.push_back(p < q ? p << 32 | q : q << 32 | p);
  }
  std::sort(sides.begin(), sides.end());
  size_t outer = 0;
  for (size_t i = 0; i < sides.size();) {
    size_t n = 1;
    while (i + n < sides.size() && sides[i + n] == sides[i]) ++n;
    assert_in_range(n, 1, 2);
    outer += n == 1;
    i += n;
  }
  assert_int_equal(outer, a + b + c);
}

void test_every_mix_of_parts(void**) {
  for (uint32_t a = 1; a <= 9; ++a) {
    for (uint32_t b = 1; b <= 9; ++b) {
      for (uint32_t c = 1; c <= 9; ++c) check_pieces(a, b, c);
    }
  }
  shd::tests::Random random{9};
  for (int i = 0; i < 60; ++i) {
    const auto parts = [&] { return static_cast<uint32_t>(random.whole(1, 1 << random.whole(0, 7))); };
    const uint32_t a = parts(), b = parts();
    check_pieces(a, b, parts());
  }
  check_pieces(1024, 1, 1);
  check_pieces(1, 1024, 1023);
  check_pieces(512, 3, 1024);
}

/// The factor of an edge does not depend on the order of its ends, and equals the value from the desc.
void test_factor(void**) {
  clear();
  add_vertex(0, 0, -5, 0, 0, 1, 0, 0);
  add_vertex(1, 0, -5, 0, 0, 1, 0, 0);
  add_vertex(0, 0, 5, 0, 0, 1, 0, 0);
  add_vertex(0, 1, 7, 0, 0, 1, 0, 0);
  add_vertex(NAN, 0, 0, 0, 0, 1, 0, 0);
  add_vertex(3e38, 3e38, 3e38, 0, 0, 1, 0, 0);
  add_vertex(-3e38, -3e38, -3e38, 0, 0, 1, 0, 0);
  add_triangle(0, 1, 2);
  build_mesh(SHD_MESH_KEEP_NONFINITE);
  shd_view view = {};  // 90 degrees: a unit length at distance d covers 500 / d of 1000 pixels
  const float eye[3] = {0, 0, 0}, target[3] = {0, 0, -1}, up[3] = {0, 1, 0};
  set_look_at(eye, target, up, &view);
  shd::data::perspective(1.5707963267948966f, 1.0f, 0.1f, 100.0f, view.view_to_clip);
  shd_tessellation_desc desc = adaptive(7.0f);
  desc.view = view;
  desc.picture_width = desc.picture_height = 1000;
  desc.max_segments = 50;
  const struct {
    uint32_t a, b, want;
  } rows[] = {{0, 1, 15}, {0, 0, 1}, {2, 3, 1}, {0, 2, 50}, {0, 4, 1}, {5, 6, 50}, {4, 4, 1}};
  for (const auto& row : rows) {
    assert_int_equal(EdgeFactor(desc)(g_work.mesh, row.a, row.b), row.want);
    assert_int_equal(EdgeFactor(desc)(g_work.mesh, row.b, row.a), row.want);
  }
  desc = adaptive(0.3f);
  const float twice[16] = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 9, 9, 9, 1};
  assert_int_equal(EdgeFactor(desc)(g_work.mesh, 0, 1), 4);
  std::copy_n(twice, 16, desc.object_to_world);
  assert_int_equal(EdgeFactor(desc)(g_work.mesh, 0, 1), 7);
}

/// The bits of two subdivided meshes are equal on every machine and compiler.
void test_bits(void**) {
  uint64_t hash = SHD_HASH_START;
  for (int pass = 0; pass < 2; ++pass) {
    octahedron_moved();
    build_mesh(SHD_MESH_TANGENTS);
    run_tessellate(pass ? adaptive(0.21f) : uniform(9));
    const Mesh& mesh = g_work.cut;
    for_each_column(&mesh, [&](const shd::core::Array<float>* column) {
      if (column->size()) hash = shd_hash(hash, column->data(), mesh.vertex_count * sizeof(float));
    });
    hash = shd_hash(hash, mesh.indices.data(), mesh.indices.size() * sizeof(uint32_t));
  }
  assert_int_equal(hash, 0xb12e7dfa58951490ull);
}

/// The vertices of the mesh keep their bits, infinity included, except that -0 becomes 0.
void test_copied_vertices(void**) {
  const double inf = static_cast<double>(INFINITY), small = -0x1p-149;
  clear();
  add_vertex(-0.0, 1.0, -0.0, -0.0, -0.0, 1.0, -0.0, 0.0);
  add_vertex(inf, small, 3e38, 0.0, -1.0, -0.0, small, -0.0);
  add_vertex(-inf, -0.0, -3e38, 1.0, -0.0, 0.0, 1e38, -1e38);
  add_triangle(0, 1, 2);
  for (const bool by_length : {false, true}) {
    build_mesh(SHD_MESH_KEEP_NONFINITE);
    run_tessellate(by_length ? adaptive(0.5f) : uniform(3));
    const shd::core::Array<float>*before[kMaxColumns], *after[kMaxColumns];
    size_t count = 0, n = 0;
    for_each_column(&g_work.mesh, [&](const shd::core::Array<float>* column) { before[count++] = column; });
    for_each_column(&g_work.cut, [&](const shd::core::Array<float>* column) { after[n++] = column; });
    for (size_t c = 0; c < count; ++c) {
      for (size_t i = 0; i < 3 && before[c]->size(); ++i) {
        const float want = (*before[c])[i] + 0.0f;
        assert_memory_equal(&want, &(*after[c])[i], sizeof want);
      }
    }
  }
}

}  // namespace

int main() {
  static CMUnitTest tests[64];
  static char names[64][64];
  const struct {
    const char* name;
    CMUnitTestFunction body;
  } bodies[] = {{"uniform", test_uniform},
                {"adaptive", test_adaptive},
                {"adaptive_in_pixels", test_adaptive_in_pixels},
                {"random_parts", test_random_parts}};
  size_t n = 0;
  for (const auto& body : bodies) {
    for (const Shape& shape : kShapes) {
      snprintf(names[n], sizeof names[n], "%s/%s", body.name, shape.name);
      tests[n] = {names[n], body.body, nullptr, nullptr, const_cast<Shape*>(&shape)};
      ++n;
    }
  }
  tests[n++] = {"every_mix_of_parts", test_every_mix_of_parts, nullptr, nullptr, nullptr};
  tests[n++] = {"factor", test_factor, nullptr, nullptr, nullptr};
  tests[n++] = {"copied_vertices", test_copied_vertices, nullptr, nullptr, nullptr};
  tests[n++] = {"bits", test_bits, nullptr, nullptr, nullptr};
  g_context = shd::core::create_context(shd_context_desc_default());
  const int failed = _cmocka_run_group_tests("unit.geometry.tessellate", tests, n, nullptr, nullptr);
  g_work = Work();
  shd::core::release(*g_context);
  return failed;
}
