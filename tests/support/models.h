// SPDX-License-Identifier: MIT
// Models made by hand, and their scenes.
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "scene/host_files.h"
#include "scene/objects.h"

namespace shd::test
{

inline scene::Matrix moved(double x, double y, double z)
{
    scene::Matrix m = scene::kIdentity;
    m[12] = x, m[13] = y, m[14] = z;
    return m;
}

inline scene::Matrix scaled(double x, double y, double z)
{
    scene::Matrix m = scene::kIdentity;
    m[0] = x, m[5] = y, m[10] = z;
    return m;
}

/// The square 0..1 in x and y, front towards +z, with normals.
inline scene::Geometry square_geometry()
{
    scene::Geometry g;
    g.name = "square";
    g.position = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    g.normal = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
    g.indices = {0, 1, 2, 0, 2, 3};
    return g;
}

/// One geometry at one node.
inline scene::Model model_of(scene::Geometry geometry, const scene::Matrix &matrix = scene::kIdentity)
{
    scene::Model model;
    model.geometries.push_back(std::move(geometry));
    model.surfaces.emplace_back();
    model.surfaces[0].name = "paint";
    model.nodes.emplace_back();
    model.nodes[0].name = "root";
    model.nodes[0].matrix = matrix;
    model.placements.push_back({0, 0, 0, -1, {}});
    return model;
}

inline scene::ObjectOptions default_options()
{
    return {shd_sampler_desc_default(), shd_load_desc_default(), 0, false, false};
}

/// No files around a model.
class NoFiles : public scene::HostFiles
{
   public:
    using HostFiles::HostFiles;
    scene::Opened model() override { return scene::Opened(); }
    std::string name() const override { return ""; }
    bool locate(const std::string &, const std::string &, scene::Opened *, std::string *) override { return false; }
};

inline void make_scene(shd_context *context, scene::Model model, scene::Objects *out)
{
    const scene::Limits limits;
    const scene::Deadline deadline(60);
    NoFiles files(limits, deadline);
    scene::make_objects(context, files, std::move(model), default_options(), limits, deadline, out);
}

/// Positions of a mesh, [vertex][3].
inline std::vector<float> positions_of(const shd_mesh *mesh)
{
    shd_mesh_info info = shd_mesh_info_default();
    if (shd_mesh_get_info(mesh, &info) != SHD_OK) return {};
    std::vector<float> out(size_t{3} * info.vertex_count);
    shd_f32_out columns[3];
    for (size_t c = 0; c < 3; ++c) columns[c] = {out.data() + c, 3 * sizeof(float)};
    return shd_mesh_read_positions(mesh, columns) == SHD_OK ? out : std::vector<float>();
}

inline std::vector<float> normals_of(const shd_mesh *mesh)
{
    std::vector<float> out(positions_of(mesh).size());
    shd_f32_out columns[3];
    for (size_t c = 0; c < 3; ++c) columns[c] = {out.data() + c, 3 * sizeof(float)};
    return shd_mesh_read_normals(mesh, columns) == SHD_OK ? out : std::vector<float>();
}

}  // namespace shd::test
