// SPDX-License-Identifier: MIT
// Edges of random meshes. The edges of some kinds are those among all edges; each is listed once and belongs to its
// triangles; a short column gets the first edges; nothing else is written.
#include "mesh_case.h"
#include "mutator.h"

#include <set>
#include <utility>

namespace shd::fuzz {
namespace {

struct Case {
  MeshCase mesh;
  shd_edges_desc desc = shd_edges_desc_default();
  uint32_t capacity = 0, step = 1;
  uint64_t budget = 0;
};

void choose_case(Source& source, Case& c) {
  c.budget = choose_budget(source);
  c.desc.edges = source.flags(SHD_EDGE_ALL);
  for (float& value : c.desc.eye) value = source.one_in(8) ? source.hostile() : source.real();
  if (source.one_in(2)) c.desc.eye[3] = static_cast<float>(source.below(2));
  c.desc.crease_cosine = source.real();
  c.capacity = source.below(40);
  c.step = 1 + source.below(3);
  choose_mesh(source, c.mesh, 12, 36);
  if (!source.one_in(64)) c.mesh.desc.flags |= SHD_MESH_ADJACENCY;
}

struct Edge {
  uint32_t vertex[2], triangle[2], kinds;
};

/// Finds edges into columns with canaries. Returns false if the call was refused.
bool find(const Host& host, const shd_mesh* mesh, const shd_edges_desc& desc, size_t capacity, size_t step,
          std::vector<Edge>& found, size_t& count) {
  std::vector<Column<uint32_t>> columns(5, Column<uint32_t>(capacity, step, kCanaryWord));
  shd_edges out = shd_edges_default();
  for (size_t k = 0; k < 2; ++k) {
    out.vertex[k] = to_column(columns[k]);
    out.triangle[k] = to_column(columns[2 + k]);
  }
  out.kinds = to_column(columns[4]);
  count = 0;
  const bool made = host.ok(shd_mesh_find_edges(mesh, &desc, capacity, &out, &count));
  SHD_FUZZ_CHECK(made || count == 0);
  const size_t written = count < capacity ? count : capacity;
  for (const Column<uint32_t>& column : columns) column.check_canaries(written);
  for (size_t i = 0; i < written; ++i) {
    found.push_back({{columns[0][i], columns[1][i]}, {columns[2][i], columns[3][i]}, columns[4][i]});
  }
  return made;
}

bool is_corner(const MeshData& data, uint32_t triangle, uint32_t vertex) {
  for (size_t k = 0; k < 3; ++k) {
    const uint32_t corner = data.indices[size_t{3} * triangle + k];
    bool same = true;
    for (const std::vector<float>& column : data.positions) same = same && column[corner] == column[vertex];
    if (same) return true;
  }
  return false;
}

void check_edge(const MeshData& data, const Edge& edge, std::set<std::pair<uint32_t, uint32_t>>& seen) {
  SHD_FUZZ_CHECK(edge.kinds != 0 && (edge.kinds & ~uint32_t{SHD_EDGE_ALL}) == 0);
  SHD_FUZZ_CHECK(edge.triangle[0] < data.info.triangle_count);
  const bool two = (edge.kinds & (SHD_EDGE_SILHOUETTE | SHD_EDGE_CREASE)) != 0;
  SHD_FUZZ_CHECK(two ? edge.triangle[1] < data.info.triangle_count && edge.triangle[1] > edge.triangle[0]
                     : edge.triangle[1] == 0xffffffffu);
  for (const uint32_t vertex : edge.vertex) {
    SHD_FUZZ_CHECK(vertex < data.info.vertex_count);
    SHD_FUZZ_CHECK(is_corner(data, edge.triangle[0], vertex));
    if (two) SHD_FUZZ_CHECK(is_corner(data, edge.triangle[1], vertex));
  }
  const uint32_t low = edge.vertex[0] < edge.vertex[1] ? edge.vertex[0] : edge.vertex[1];
  SHD_FUZZ_CHECK(edge.vertex[0] != edge.vertex[1]);
  SHD_FUZZ_CHECK(seen.insert({low, edge.vertex[0] + edge.vertex[1] - low}).second);
}

/// The edges that were found are those of `all` with the kinds that were asked for.
void check_selection(const std::vector<Edge>& all, const std::vector<Edge>& found, uint32_t kinds, size_t count) {
  size_t n = 0;
  for (Edge edge : all) {
    edge.kinds &= kinds;
    if (edge.kinds == 0) continue;
    if (n < found.size()) SHD_FUZZ_CHECK(std::memcmp(&edge, &found[n], sizeof edge) == 0);
    ++n;
  }
  SHD_FUZZ_CHECK(n == count);
}

void run(const Case& c, shd_simd simd, std::vector<Edge>& found) {
  Host host(simd, c.budget);
  if (!host.context) return;
  shd_mesh* mesh = nullptr;
  if (host.ok(shd_mesh_create(host.context, &c.mesh.desc, &mesh))) {
    MeshData data;
    read_mesh(mesh, data);
    size_t count = 0, all_count = 0;
    if (find(host, mesh, c.desc, c.capacity, c.step, found, count)) {
      shd_edges_desc desc = c.desc;
      desc.edges = SHD_EDGE_ALL;
      std::vector<Edge> all;
      if (find(host, mesh, desc, size_t{3} * data.info.triangle_count, 1, all, all_count)) {
        std::set<std::pair<uint32_t, uint32_t>> seen;
        for (const Edge& edge : all) check_edge(data, edge, seen);
        check_selection(all, found, c.desc.edges, count);
      }
    }
  } else {
    SHD_FUZZ_CHECK(!mesh);
  }
  shd_mesh_release(mesh);
}

}  // namespace

void describe(Source& source) {
  Case c;
  choose_case(source, c);
}

}  // namespace shd::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace shd::fuzz;
  compare_targets<Case, std::vector<Edge>>(
      data, size, choose_case, run, [](const std::vector<Edge>& best, const std::vector<Edge>& baseline) {
        SHD_FUZZ_CHECK(best.size() == baseline.size());
        SHD_FUZZ_CHECK(best.empty() || std::memcmp(best.data(), baseline.data(), best.size() * sizeof best[0]) == 0);
      });
  return 0;
}
