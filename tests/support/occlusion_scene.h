// SPDX-License-Identifier: MIT
// Meshes with rays in double (tests/ref/ray_ref.h) as tracers of occlusion.
#pragma once

#include <vector>

#include <shd/shd.h>

#include "ref/ray_ref.h"
#include "support/check.h"
#include "support/context.h"

namespace shd::tests
{

using ref::Vec3;

/// A mesh with the triangles of an oracle.
struct Solid {
    shd_mesh *mesh = nullptr;
    shd_draw draw = shd_draw_default();
    std::vector<float> position;
    std::vector<uint32_t> indices;
    ref::RayScene *rays = nullptr;
};

inline void close(Solid *solid)
{
    shd_mesh_release(solid->mesh);
    delete solid->rays;
}

inline void finish(Solid *solid)
{
    shd_mesh_desc desc = shd_mesh_desc_default();
    desc.vertex_count = static_cast<uint32_t>(solid->position.size() / 3);
    for (size_t c = 0; c < 3; ++c) desc.position[c] = shd_f32_column(solid->position.data() + c, 12);
    desc.indices.data = solid->indices.data();
    desc.index_count = solid->indices.size();
    shd_assert_ok(shd_mesh_create(g_context, &desc, &solid->mesh));
    solid->draw.mesh = solid->mesh;
    std::vector<ref::RayTriangle> triangles;
    for (size_t i = 0; i < solid->indices.size(); i += 3) {
        ref::RayTriangle triangle = {};
        for (size_t k = 0; k < 3; ++k) {
            for (size_t c = 0; c < 3; ++c) {
                triangle.corner[k][c] = static_cast<double>(solid->position[3 * solid->indices[i + k] + c]);
            }
        }
        triangles.push_back(triangle);
    }
    solid->rays = new ref::RayScene(triangles);
}

inline void add_quad(Solid *out, const Vec3 &at, const Vec3 &u, const Vec3 &v)
{
    const auto first = static_cast<uint32_t>(out->position.size() / 3);
    for (const Vec3 &p : {at, at + u, at + u + v, at + v}) {
        for (size_t c = 0; c < 3; ++c) out->position.push_back(static_cast<float>(p[c]));
    }
    for (uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) out->indices.push_back(first + i);
}

inline void add_shape(Solid *out, const shd_shape_desc &desc, const Vec3 &at)
{
    shd_shape_columns columns = shd_shape_columns_default();
    shd_assert_ok(shd_shape_count(&desc, &columns.vertex_count, &columns.index_count));
    const size_t first = out->position.size() / 3, first_index = out->indices.size();
    out->position.resize(3 * (first + columns.vertex_count));
    out->indices.resize(first_index + columns.index_count);
    for (size_t c = 0; c < 3; ++c) columns.position[c] = {&out->position[3 * first + c], 12};
    columns.indices.data = &out->indices[first_index];
    shd_assert_ok(shd_shape_fill(&desc, &columns));
    for (size_t i = first; i < first + columns.vertex_count; ++i) {
        for (size_t c = 0; c < 3; ++c) out->position[3 * i + c] += static_cast<float>(at[c]);
    }
    for (size_t i = first_index; i < out->indices.size(); ++i) out->indices[i] += static_cast<uint32_t>(first);
}

/// The tracer of a host: rays in double.
inline void trace(const shd_rays *rays, uint32_t *blocked, void *user_data)
{
    const auto &solid = *static_cast<const Solid *>(user_data);
    for (size_t i = 0; i < rays->count; ++i) {
        const Vec3 from = {rays->ox[i], rays->oy[i], rays->oz[i]}, way = {rays->dx[i], rays->dy[i], rays->dz[i]};
        blocked[i] = solid.rays->is_blocked(from, std::fmin(double{rays->length[i]}, 1e6) * way);
    }
}

enum Method { kTracer, kMaps };

inline shd_occlusion_desc desc_of(Solid *solid, Method method, uint32_t rays)
{
    shd_occlusion_desc desc = shd_occlusion_desc_default();
    desc.ray_count = rays;
    if (method == kTracer) desc.tracer = {trace, solid};
    if (method == kMaps) desc.draws = &solid->draw, desc.draw_count = 1, desc.map_size = 384;
    return desc;
}

using Columns = std::vector<float>[6];  // positions and normals

inline std::vector<float> compute(const shd_occlusion_desc &desc, const Columns &columns)
{
    std::vector<float> values(columns[0].size(), -7.0f);
    shd_occlusion_points points = shd_occlusion_points_default();
    shd_occlusion_values out = {sizeof out, {values.data(), 0}, 0};
    points.count = values.size();
    for (size_t c = 0; c < 3; ++c) {
        points.position[c].data = columns[c].data();
        points.normal[c].data = columns[3 + c].data();
    }
    shd_assert_ok(shd_occlusion_compute(g_context, &desc, &points, &out));
    return values;
}

inline void add_point(Columns &columns, const Vec3 &p, const Vec3 &n)
{
    for (size_t c = 0; c < 3; ++c) {
        columns[c].push_back(static_cast<float>(p[c]));
        columns[3 + c].push_back(static_cast<float>(n[c]));
    }
}

}  // namespace shd::tests
