// SPDX-License-Identifier: MIT
// Texture coordinates of meshes from positions: the rules of shd/uv_projection.h against their oracle, the vertices
// that are split, the coordinates of shapes, frames, input that is not finite, and refused descs.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "ref/uv_projection_ref.h"
#include "support/context.h"
#include "support/fault_allocator.h"
#include "support/random.h"

#include <shd/shd.h>

using namespace shd::tests;

namespace
{

constexpr float kNan = NAN, kInf = INFINITY;
constexpr shd_uv_projection kAll[] = {SHD_UV_PROJECTION_PLANAR, SHD_UV_PROJECTION_SPHERICAL,
                                      SHD_UV_PROJECTION_CYLINDRICAL, SHD_UV_PROJECTION_BOX};

using Matrix = std::array<float, 16>;
constexpr Matrix kIdentity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

/// The caller's columns.
struct Input {
    std::vector<float> position;  // [vertex][3]
    std::vector<uint32_t> indices;

    uint32_t count() const { return static_cast<uint32_t>(position.size() / 3); }
};

/// A mesh read back.
struct Output {
    shd_mesh_info info = shd_mesh_info_default();
    std::vector<float> position, normal, uv, tangent;
    std::vector<uint32_t> indices;
};

shd_mesh_desc desc_of(const Input &in, shd_uv_projection projection, const Matrix &matrix)
{
    shd_mesh_desc desc = shd_mesh_desc_default();
    desc.vertex_count = in.count();
    for (size_t c = 0; c < 3; ++c) desc.position[c] = {in.position.data() + c, 3 * sizeof(float)};
    desc.indices.data = in.indices.data();
    desc.index_count = in.indices.size();
    desc.uv_projection = projection;
    std::copy(matrix.begin(), matrix.end(), desc.object_to_projection);
    return desc;
}

template <class Read>
std::vector<float> read(shd_mesh *mesh, size_t count, size_t width, const Read &function)
{
    std::vector<float> out(count * width);
    shd_f32_out columns[4];
    for (size_t c = 0; c < width; ++c) columns[c] = {out.data() + c, width * sizeof(float)};
    shd_assert_ok(function(mesh, columns));
    return out;
}

Output build(shd_context *context, const shd_mesh_desc &desc)
{
    Output out;
    shd_mesh *mesh = nullptr;
    shd_assert_ok(shd_mesh_create(context, &desc, &mesh));
    shd_assert_ok(shd_mesh_get_info(mesh, &out.info));
    out.position = read(mesh, out.info.vertex_count, 3, shd_mesh_read_positions);
    out.normal = read(mesh, out.info.vertex_count, 3, shd_mesh_read_normals);
    out.uv = read(mesh, out.info.vertex_count, 2, shd_mesh_read_uv);
    out.tangent = read(mesh, out.info.vertex_count, 4, shd_mesh_read_tangents);
    out.indices.resize(3 * out.info.triangle_count);
    const shd_u32_out indices = {out.indices.data(), 0};
    shd_assert_ok(shd_mesh_read_indices(mesh, &indices));
    shd_mesh_release(mesh);
    return out;
}

/// Random vertices, some on the axis of `matrix`^-1 for the identity, and random triangles.
Input random_input(Random &random, size_t vertices, size_t triangles)
{
    Input in;
    for (size_t i = 0; i < vertices; ++i) {
        const bool on_axis = random.whole(0, 5) == 0;
        in.position.push_back(on_axis ? 0.0f : random.real(-1, 1));
        in.position.push_back(random.real(-2, 2));
        in.position.push_back(on_axis ? 0.0f : random.real(-1, 1));
    }
    for (size_t i = 0; i < 3 * triangles; ++i) {
        in.indices.push_back(static_cast<uint32_t>(random.whole(0, static_cast<int64_t>(vertices) - 1)));
    }
    return in;
}

/// Every corner has the coordinates of the oracle, and its vertex is the one of the caller or a copy of it.
void expect_reference(const Input &in, const Output &out, shd_uv_projection projection, const Matrix &matrix)
{
    assert_int_equal(out.indices.size(), in.indices.size());
    for (size_t t = 0; t < in.indices.size(); t += 3) {
        const float *p[3];
        double want[3][2];
        for (size_t k = 0; k < 3; ++k) p[k] = &in.position[size_t{3} * in.indices[t + k]];
        shd_ref_project_uv(projection, matrix.data(), p, want);
        for (size_t k = 0; k < 3; ++k) {
            const uint32_t from = in.indices[t + k], to = out.indices[t + k];
            assert_true(to == from || to >= in.count());
            assert_memory_equal(&in.position[size_t{3} * from], &out.position[size_t{3} * to], 3 * sizeof(float));
            assert_memory_equal(&out.normal[size_t{3} * from], &out.normal[size_t{3} * to], 3 * sizeof(float));
            for (size_t c = 0; c < 2; ++c) {
                shd_assert_close(c ? "v" : "u", t + k, static_cast<double>(out.uv[2 * to + c]), want[k][c], 5e-7, 5e-7);
            }
        }
    }
}

void test_reference(void **)
{
    Random random = {1};
    for (int round = 0; round < 24; ++round) {
        Matrix matrix = kIdentity;
        if (round > 3) {
            for (size_t c = 0; c < 4; ++c) {
                for (size_t r = 0; r < 3; ++r) matrix[4 * c + r] = random.real(-1, 1);
            }
        }
        const Input in = random_input(random, 60, 120);
        for (const shd_uv_projection projection : kAll) {
            const Output out = build(g_context, desc_of(in, projection, matrix));
            expect_reference(in, out, projection, matrix);
            assert_int_equal(out.info.vertex_count, in.count() + out.info.split_count);
            if (projection == SHD_UV_PROJECTION_PLANAR) assert_int_equal(out.info.split_count, 0);
            if (round < 4 && projection != SHD_UV_PROJECTION_PLANAR) assert_true(out.info.split_count > 20);
        }
    }
}

/// The copies follow in the order of their originals and of their uv, none twice, and the original keeps the uv of its
/// first triangle.
void test_order_of_copies(void **)
{
    Random random = {2};
    const Input in = random_input(random, 40, 200);
    for (const shd_uv_projection projection : kAll) {
        const Output out = build(g_context, desc_of(in, projection, kIdentity));
        std::vector<uint32_t> source(out.info.vertex_count);
        std::vector<bool> is_seen(in.count());
        for (size_t i = 0; i < in.indices.size(); ++i) {
            source[out.indices[i]] = in.indices[i];
            if (!is_seen[in.indices[i]]) assert_int_equal(out.indices[i], in.indices[i]);
            is_seen[in.indices[i]] = true;
        }
        for (size_t i = in.count() + size_t{1}; i < source.size(); ++i) {
            const std::array<float, 2> a = {out.uv[2 * i - 2], out.uv[2 * i - 1]},
                                       b = {out.uv[2 * i], out.uv[2 * i + 1]};
            assert_true(source[i - 1] < source[i] || (source[i - 1] == source[i] && a < b));
        }
    }
}

/// A shape without its uv gets them back.
void expect_shape(shd_shape shape, shd_uv_projection projection)
{
    shd_shape_desc desc = shd_shape_desc_default();
    desc.kind = shape;
    shd_shape_columns columns = shd_shape_columns_default();
    shd_assert_ok(shd_shape_count(&desc, &columns.vertex_count, &columns.index_count));
    Input in;
    in.position.resize(3 * columns.vertex_count);
    in.indices.resize(columns.index_count);
    std::vector<float> uv(2 * columns.vertex_count);
    for (size_t c = 0; c < 3; ++c) columns.position[c] = {in.position.data() + c, 3 * sizeof(float)};
    for (size_t c = 0; c < 2; ++c) columns.uv[c] = {uv.data() + c, 2 * sizeof(float)};
    columns.indices.data = in.indices.data();
    shd_assert_ok(shd_shape_fill(&desc, &columns));
    const Output out = build(g_context, desc_of(in, projection, kIdentity));
    for (size_t i = 0; i < in.indices.size(); ++i) {
        for (size_t c = 0; c < 2; ++c) {
            shd_assert_close("uv", i, static_cast<double>(out.uv[2 * out.indices[i] + c]),
                             static_cast<double>(uv[2 * in.indices[i] + c]), 2e-7, 0);
        }
    }
}

void test_shapes(void **)
{
    expect_shape(SHD_SHAPE_SPHERE, SHD_UV_PROJECTION_SPHERICAL);
    expect_shape(SHD_SHAPE_BOX, SHD_UV_PROJECTION_BOX);
}

/// A globe of `around` x `down` vertices with one vertex at each pole and no seam, moved by `offset`; without poles a
/// tube.
Input globe(uint32_t around, uint32_t down, bool has_poles, float offset)
{
    Input in;
    const auto add = [&](double x, double y, double z) {
        for (const double c : {x, y, z}) in.position.push_back(static_cast<float>(c + static_cast<double>(offset)));
    };
    for (uint32_t j = 1; j < down; ++j) {
        const double latitude = 3.14159265358979 * j / down, r = has_poles ? std::sin(latitude) : 1.0;
        for (uint32_t i = 0; i < around; ++i) {
            const double turn = 6.283185307179586 * (i + 0.3) / around;
            add(-r * std::sin(turn), std::cos(latitude), -r * std::cos(turn));
        }
    }
    for (uint32_t j = 0; j + 2 < down; ++j) {
        for (uint32_t i = 0; i < around; ++i) {
            const uint32_t a = j * around + i, b = j * around + (i + 1) % around;
            for (const uint32_t v : {a, a + around, b, b, a + around, b + around}) in.indices.push_back(v);
        }
    }
    if (!has_poles) return in;
    const uint32_t north = in.count(), last = (down - 2) * around;
    add(0, 1, 0);
    add(0, -1, 0);
    for (uint32_t i = 0; i < around; ++i) {
        for (const uint32_t v : {north, i, (i + 1) % around}) in.indices.push_back(v);
        for (const uint32_t v : {north + 1, last + (i + 1) % around, last + i}) in.indices.push_back(v);
    }
    return in;
}

Matrix moved(float offset)
{
    Matrix matrix = kIdentity;
    for (size_t c = 12; c < 15; ++c) matrix[c] = -offset;
    return matrix;
}

/// Seams: each triangle has the width of one part of the globe, and u grows with the turn. Poles: u in the middle. One
/// copy for each triangle at a pole but the first, and one for each vertex beside the seam.
void test_seams(void **)
{
    constexpr uint32_t kAround = 24, kDown = 12;
    for (const bool has_poles : {true, false}) {
        for (const float offset : {0.0f, 0.3f, -7.7f}) {
            const shd_uv_projection projection =
                has_poles ? SHD_UV_PROJECTION_SPHERICAL : SHD_UV_PROJECTION_CYLINDRICAL;
            const Input in = globe(kAround, kDown, has_poles, offset);
            const Output out = build(g_context, desc_of(in, projection, moved(offset)));
            const uint32_t rows = kDown - 1;
            assert_int_equal(out.info.split_count, rows + (has_poles ? 2 * (kAround - 1) : 0));
            for (size_t t = 0; t < out.indices.size(); t += 3) {
                float u[3];
                for (size_t k = 0; k < 3; ++k) u[k] = out.uv[size_t{2} * out.indices[t + k]];
                const float low = std::min({u[0], u[1], u[2]}), high = std::max({u[0], u[1], u[2]});
                assert_true(low >= 0.0f && low < 1.0f && high < 1.5f);
                shd_assert_close("width", t, static_cast<double>(high - low), 1.0 / kAround, 2e-6, 0);
                for (size_t k = 0; k < 3; ++k) {
                    if (!has_poles || in.indices[t + k] < in.count() - 2) continue;
                    shd_assert_close("pole", t, static_cast<double>(u[k]), 0.5 * static_cast<double>(low + high), 2e-6,
                                     0);
                }
            }
        }
    }
}

/// A cone whose tip has 2^16 triangles takes as many vertices, and no time that grows with their square.
void test_many_at_pole(void **)
{
    const Input in = globe(1u << 16, 2, true, 0.0f);
    const Output out = build(g_context, desc_of(in, SHD_UV_PROJECTION_SPHERICAL, kIdentity));
    assert_true(out.info.split_count > (1u << 17) - 64 && out.info.split_count < (1u << 17) + 64);
}

/// A triangle around the axis has the smallest range that there is.
void test_around_axis(void **)
{
    const Input in = {{0, 1, -1, -0.8f, 1, 0.6f, 0.8f, 1, 0.6f}, {0, 1, 2}};
    const Output out = build(g_context, desc_of(in, SHD_UV_PROJECTION_CYLINDRICAL, kIdentity));
    const float low = std::min({out.uv[0], out.uv[2], out.uv[4]}), high = std::max({out.uv[0], out.uv[2], out.uv[4]});
    assert_true(high - low < 0.6476f + 1e-3f && high - low > 0.6f);
}

/// Sides of a box in the fixed order of ties, and of triangles without area.
void test_box_ties(void **)
{
    struct Case {
        float p[9];
        float want[6];
    };
    static const Case kCases[] = {
        {{0, 0, 0, 1, -1, 0, 0, 0, -1}, {0.5f, 0.5f, 0.5f, 1, 1, 0.5f}},   // n = (1, 1, 0): +X
        {{0, 0, 0, 0, 0, -1, 1, -1, 0}, {0.5f, 0.5f, 0, 0.5f, 0.5f, 1}},   // n = (-1, -1, 0): -X
        {{0, 0, 0, 0, 1, -1, -1, 0, 0}, {0.5f, 0.5f, 0.5f, 0, 0, 0.5f}},   // n = (0, 1, 1): +Y
        {{0, 0, 0, -1, 0, 0, 0, 1, -1}, {0.5f, 0.5f, 0, 0.5f, 0.5f, 1}},   // n = (0, -1, -1): -Y
        {{0.5f, 0, 1, 0.5f, 0, 1, 0, 1, 0}, {0, 0.5f, 0, 0.5f, 0.5f, 0}},  // no area: +X
    };
    for (const Case &row : kCases) {
        const Input in = {std::vector<float>(row.p, row.p + 9), {0, 1, 2}};
        const Output out = build(g_context, desc_of(in, SHD_UV_PROJECTION_BOX, kIdentity));
        for (size_t i = 0; i < 6; ++i) {
            shd_assert_close("uv", i, static_cast<double>(out.uv[i]), static_cast<double>(row.want[i]), 1e-6, 0);
        }
    }
}

/// Every bit pattern of a position has coordinates: finite ones, 0 where the position is not finite.
void test_total(void **)
{
    const Input in = {
        {0, 0, 0, kNan, 0, 0, 0, kInf, 0, 0, 0, -kInf, 3e38f, -3e38f, 3e38f, 1e-45f, -1e-45f, 0, 0, 5, 0, 1, 1, -1e-9f},
        {0, 1, 2, 3, 4, 5, 6, 7, 0, 4, 6, 6, 6, 6, 6, 5, 0, 4, 7, 7, 4, 1, 6, 7}};
    Matrix huge = kIdentity, zero = {};
    huge[0] = huge[5] = huge[10] = 3e38f;
    zero[15] = 1;
    for (const Matrix &matrix : {kIdentity, huge, zero}) {
        for (const shd_uv_projection projection : kAll) {
            shd_mesh_desc desc = desc_of(in, projection, matrix);
            desc.flags = SHD_MESH_KEEP_NONFINITE | SHD_MESH_TANGENTS;
            const Output out = build(g_context, desc);
            for (size_t i = 0; i < out.uv.size(); ++i) {
                assert_true(std::isfinite(out.uv[i]));
                const float *p = &out.position[i / 2 * 3];
                const bool is_finite = std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
                assert_true(is_finite || out.uv[i] == 0.0f);
            }
        }
    }
    const Output centre = build(g_context, desc_of({{0, 0, 0}, {0, 0, 0}}, SHD_UV_PROJECTION_SPHERICAL, kIdentity));
    assert_true(centre.uv[0] == 0.0f && centre.uv[1] == 0.5f);
    shd_mesh_desc empty = shd_mesh_desc_default();
    empty.uv_projection = SHD_UV_PROJECTION_BOX;
    assert_int_equal(build(g_context, empty).info.vertex_count, 0);
}

/// A frame of a sphere has u and v of the place at every pixel: no streak. The tangent runs towards growing u.
void test_frame(void **)
{
    constexpr uint32_t kSize = 160;
    for (const float azimuth : {0.4f, 2.9f}) {
        const Input in = globe(96, 48, true, 0.0f);
        shd_mesh_desc desc = desc_of(in, SHD_UV_PROJECTION_SPHERICAL, kIdentity);
        desc.flags = SHD_MESH_TANGENTS;
        shd_mesh *mesh = nullptr;
        shd_material *material = nullptr;
        shd_framebuffer *framebuffer = nullptr;
        shd_assert_ok(shd_mesh_create(g_context, &desc, &mesh));
        shd_assert_ok(shd_material_create(g_context, nullptr, &material));
        shd_framebuffer_desc target = shd_framebuffer_desc_default();
        target.width = target.height = kSize;
        target.aovs = SHD_AOV_UV | SHD_AOV_POSITION | SHD_AOV_DERIVATIVES;
        shd_assert_ok(shd_framebuffer_create(g_context, &target, &framebuffer));
        shd_camera camera = shd_camera_default();
        camera.eye[0] = 3 * std::sin(azimuth), camera.eye[1] = 1.5f, camera.eye[2] = 3 * std::cos(azimuth);
        shd_draw draw = shd_draw_default();
        draw.mesh = mesh;
        draw.material = material;
        shd_render_desc frame = shd_render_desc_default();
        frame.framebuffer = framebuffer;
        shd_assert_ok(shd_view_from_camera(&camera, &frame.view));
        frame.draws = &draw;
        frame.draw_count = 1;
        shd_assert_ok(shd_render(g_context, &frame));
        constexpr shd_plane kPlanes[] = {SHD_PLANE_PX, SHD_PLANE_PY,   SHD_PLANE_PZ,  SHD_PLANE_U,
                                         SHD_PLANE_V,  SHD_PLANE_DUDX, SHD_PLANE_DUDY};
        std::vector<std::vector<float>> planes(7, std::vector<float>(kSize * kSize));
        for (size_t p = 0; p < 7; ++p) {
            const shd_f32_out out = {planes[p].data(), 0};
            shd_assert_ok(shd_framebuffer_read_plane(framebuffer, kPlanes[p], &out));
        }
        size_t covered = 0;
        for (size_t i = 0; i < planes[0].size(); ++i) {
            const double p[3] = {static_cast<double>(planes[0][i]), static_cast<double>(planes[1][i]),
                                 static_cast<double>(planes[2][i])};
            const double r = std::hypot(p[0], p[2]);
            if (r + std::fabs(p[1]) < 0.5) continue;  // nothing was drawn
            ++covered;
            const double apart = static_cast<double>(planes[3][i]) - shd_ref_turn(p);
            if (r > 0.1) assert_true(std::fabs(apart - std::round(apart)) < 2e-3 / r);
            shd_assert_close("v", i, static_cast<double>(planes[4][i]), std::atan2(r, p[1]) * 2 / SHD_REF_TURN, 2e-3,
                             0);
            double facing = 0;
            for (size_t c = 0; c < 3; ++c) facing += p[c] * static_cast<double>(camera.eye[c]);
            if (r < 0.5 || facing < 1.8) continue;
            assert_true(std::fabs(planes[5][i]) < 0.02f && std::fabs(planes[6][i]) < 0.02f);
        }
        assert_true(covered > kSize * kSize / 8);
        const Output out = build(g_context, desc);
        for (size_t i = 0; i < out.info.vertex_count; ++i) {
            const float *p = &out.position[3 * i], *t = &out.tangent[4 * i];
            const float r = std::hypot(p[0], p[2]);
            if (r > 0.1f) assert_true((t[0] * p[2] - t[2] * p[0]) / r > 0.99f && t[3] == 1.0f);
        }
        shd_framebuffer_release(framebuffer);
        shd_material_release(material);
        shd_mesh_release(mesh);
    }
}

/// Other columns of a vertex follow its copies, and strips are split as triangles.
void test_columns(void **)
{
    const Input in = globe(8, 5, true, 0.0f);
    std::vector<float> number(in.count()), normal(in.position);
    for (size_t i = 0; i < number.size(); ++i) number[i] = static_cast<float>(i);
    const shd_f32_in attribute = {number.data(), 0};
    shd_mesh_desc desc = desc_of(in, SHD_UV_PROJECTION_SPHERICAL, kIdentity);
    desc.attributes = &attribute;
    desc.attribute_count = 1;
    desc.uv1[0] = desc.uv1[1] = attribute;
    for (size_t c = 0; c < 3; ++c) desc.normal[c] = {normal.data() + c, 3 * sizeof(float)};
    for (size_t c = 0; c < 4; ++c) desc.tangent[c] = attribute;
    shd_mesh *mesh = nullptr;
    shd_assert_ok(shd_mesh_create(g_context, &desc, &mesh));
    const Output out = build(g_context, desc);
    const std::vector<float> got = read(mesh, out.info.vertex_count, 1, [](shd_mesh *m, const shd_f32_out *o) {
        return shd_mesh_read_attribute(m, 0, o);
    });
    const std::vector<float> uv1 = read(mesh, out.info.vertex_count, 2, shd_mesh_read_uv1);
    for (size_t i = 0; i < in.indices.size(); ++i) {
        const auto want = static_cast<float>(in.indices[i]);
        assert_true(got[out.indices[i]] == want && uv1[2 * out.indices[i]] == want);
        assert_true(out.tangent[4 * out.indices[i] + 3] == want);
    }
    shd_mesh_release(mesh);
}

/// The same bits on every machine, for every number of workers and SIMD target: the hash is stored.
void test_bits(void **)
{
    Random random = {5};
    const Input in = random_input(random, 300, 900);
    Matrix matrix = kIdentity;
    for (size_t i = 0; i < 12; ++i) matrix[i] += i % 4 == 3 ? 0.0f : 0.25f * static_cast<float>(i % 3) - 0.125f;
    for (const int simd : {SHD_SIMD_BEST, SHD_SIMD_BASELINE}) {
        shd_context_desc context_desc = shd_context_desc_default();
        shd_context *context = nullptr;
        context_desc.simd = static_cast<shd_simd>(simd);
        context_desc.worker_count = simd == SHD_SIMD_BEST ? 3 : 1;
        shd_assert_ok(shd_context_create(&context_desc, &context));
        uint64_t hash = SHD_HASH_START;
        for (const shd_uv_projection projection : kAll) {
            const Output out = build(context, desc_of(in, projection, matrix));
            hash = shd_hash(hash, out.uv.data(), out.uv.size() * sizeof(float));
            hash = shd_hash(hash, out.indices.data(), out.indices.size() * sizeof(uint32_t));
        }
        shd_context_release(context);
        if (hash != 0x29a3dd4a277d404dull) fail_msg("hash 0x%llxull", static_cast<unsigned long long>(hash));
    }
}

/// Each allocation may fail: the call reports it, and nothing leaks.
void test_faults(void **)
{
    const Input in = globe(8, 5, true, 0.0f);
    shd_fault_allocator memory = {};
    const shd_context_desc desc = shd_fault_context_desc(&memory);
    shd_context *context = nullptr;
    shd_assert_ok(shd_context_create(&desc, &context));
    for (const shd_uv_projection projection : kAll) {
        const shd_mesh_desc mesh_desc = desc_of(in, projection, kIdentity);
        for (size_t at = 1;; ++at) {
            shd_mesh *mesh = nullptr;
            shd_fault_arm(&memory, at, 0);
            const shd_result result = shd_mesh_create(context, &mesh_desc, &mesh);
            shd_fault_arm(&memory, 0, 0);
            shd_mesh_release(mesh);
            if (result == SHD_OK) break;
            assert_int_equal(result, SHD_ERROR_OUT_OF_MEMORY);
            assert_true(at < 200);
        }
    }
    shd_context_release(context);
    shd_assert_all_freed("uv", &memory);
}

struct Bad {
    const char *name;
    void (*edit)(shd_mesh_desc *desc);
    shd_result expected;
    const char *message;
};
const float kColumn[3] = {0, 1, 2};
const Bad kBad[] = {
    {"bad/kind", [](shd_mesh_desc *d) { d->uv_projection = static_cast<shd_uv_projection>(5); },
     SHD_ERROR_INVALID_ARGUMENT, "mesh.uv_projection: 5 is not in 0..4"},
    {"bad/uv_too", [](shd_mesh_desc *d) { d->uv[0].data = d->uv[1].data = kColumn; }, SHD_ERROR_INVALID_ARGUMENT,
     "mesh.uv_projection: 4, but mesh.uv is set too"},
    {"bad/nan", [](shd_mesh_desc *d) { d->object_to_projection[6] = kNan; }, SHD_ERROR_INVALID_ARGUMENT,
     "mesh.object_to_projection[6]: "},
    {"bad/last_row", [](shd_mesh_desc *d) { d->object_to_projection[7] = 1; }, SHD_ERROR_INVALID_ARGUMENT,
     "mesh.object_to_projection: the last row is not 0 0 0 1"},
    {"bad/unused_matrix",
     [](shd_mesh_desc *d) {
         d->uv_projection = SHD_UV_PROJECTION_NONE;
         d->object_to_projection[7] = 1;
     },
     SHD_OK, ""},
};

void test_bad(void **state)
{
    const auto *row = static_cast<const Bad *>(*state);
    const Input in = {{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2}};
    shd_mesh_desc desc = desc_of(in, SHD_UV_PROJECTION_BOX, kIdentity);
    shd_mesh *mesh = nullptr;
    row->edit(&desc);
    shd_assert_result(row->name, shd_mesh_create(g_context, &desc, &mesh), row->expected, row->message);
    assert_true((mesh != nullptr) == (row->expected == SHD_OK));
    shd_mesh_release(mesh);
}

}  // namespace

int main()
{
    std::vector<CMUnitTest> tests = {
        {"reference", test_reference, nullptr, nullptr, nullptr},
        {"order_of_copies", test_order_of_copies, nullptr, nullptr, nullptr},
        {"shapes", test_shapes, nullptr, nullptr, nullptr},
        {"seams", test_seams, nullptr, nullptr, nullptr},
        {"many_at_pole", test_many_at_pole, nullptr, nullptr, nullptr},
        {"around_axis", test_around_axis, nullptr, nullptr, nullptr},
        {"box_ties", test_box_ties, nullptr, nullptr, nullptr},
        {"total", test_total, nullptr, nullptr, nullptr},
        {"frame", test_frame, nullptr, nullptr, nullptr},
        {"columns", test_columns, nullptr, nullptr, nullptr},
        {"bits", test_bits, nullptr, nullptr, nullptr},
        {"faults", test_faults, nullptr, nullptr, nullptr},
    };
    for (const Bad &row : kBad) tests.push_back({row.name, test_bad, nullptr, nullptr, const_cast<Bad *>(&row)});
    return _cmocka_run_group_tests("api.uv_projection", tests.data(), tests.size(), set_up, tear_down);
}
