// SPDX-License-Identifier: MIT
// 2D textures in slots with coordinates from positions: the colours and levels of frames are those of
// shd_texture_sample() at coordinates that are computed here in double.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "support/frame.h"
#include "support/random.h"
#include "support/slots.h"

using namespace shd::tests;

namespace
{

constexpr uint32_t kSize = 32, kPixels = kSize * kSize, kTexels = 64;
constexpr double kStep = 2.0 / kSize;

using Vec = std::array<double, 4>;

/// uv of a point and its derivatives by pixel steps.
struct Coordinates {
    double uv[2], dx[2], dy[2];
};

/// A frame of one quad with an unlit material.
struct Scene {
    shd_frame f = {};
    shd_material_desc material = shd_material_desc_default();
    shd_slot_list slots = {};
    shd_texture *texture = nullptr;
    shd_sampler *sampler = nullptr;
    float quad[48];

    Scene(shd_filter filter, shd_wrap wrap)
    {
        shd_frame_open_aovs(&f, kSize, kSize, 1, SHD_AOV_TRIANGLE | SHD_AOV_LEVEL);
        shd_frame_quad(-1, -1, 1, 1, 0.25f, 0.75f, quad);
        material.model = SHD_MODEL_UNLIT;
        std::fill_n(material.diffuse, 3, 1.0f);
        Random random = {3};
        std::vector<unsigned char> texels(4 * kTexels * kTexels);
        for (unsigned char &texel : texels) texel = static_cast<unsigned char>(random.whole(0, 255));
        shd_texture_desc desc = shd_texture_desc_default();
        desc.width = desc.height = kTexels;
        desc.format = SHD_FORMAT_RGBA8;
        desc.texels = texels.data();
        desc.tables = SHD_TABLE_MIPMAP;
        shd_assert_ok(shd_texture_create(f.context, &desc, &texture));
        shd_sampler_desc sampling = shd_sampler_desc_default();
        sampling.filter = filter;
        sampling.wrap_u = sampling.wrap_v = wrap;
        for (size_t c = 0; c < 4; ++c) sampling.border[c] = 0.25f * static_cast<float>(c + 1);
        shd_assert_ok(shd_sampler_create(f.context, &sampling, &sampler));
    }
    Scene(const Scene &) = delete;
    ~Scene()
    {
        shd_texture_release(texture);
        shd_sampler_release(sampler);
        shd_frame_close(&f);
    }

    shd_slot *add(shd_slot_target target, shd_slot_coordinates coordinates)
    {
        shd_slot *slot = shd_slot_list_add(&slots, &material, shd_slot_texture(target, texture, sampler));
        slot->coordinates = coordinates;
        slot->place_space = SHD_PLACE_SPACE_WORLD;
        return slot;
    }

    void render()
    {
        shd_frame_draw(&f, quad, 6, &material);
        shd_frame_render(&f);
    }
};

/// World position of a pixel of the quad, and its change by a pixel to the right and down.
struct Point {
    Vec p, dx, dy;
};
Point point_of(size_t pixel)
{
    const double x = (static_cast<double>(pixel % kSize) + 0.5) * kStep - 1;
    const double y = 1 - (static_cast<double>(pixel / kSize) + 0.5) * kStep;
    return {{x, y, 0.5 + 0.25 * x, 1}, {kStep, 0, 0.25 * kStep, 0}, {0, -kStep, 0, 0}};
}

Vec product(const float *m, const Vec &p)
{
    Vec out = {};
    for (size_t r = 0; r < 4; ++r) {
        for (size_t c = 0; c < 4; ++c) out[r] += static_cast<double>(m[4 * c + r]) * p[c];
    }
    return out;
}

/// Values and levels of lookups at the coordinates of all pixels.
struct Looked {
    std::vector<float> in[6], color[4], lod;
};
Looked look_up(const Scene &s, const std::function<Coordinates(size_t)> &coordinates)
{
    Looked out;
    for (auto &column : out.in) column.resize(kPixels);
    for (auto &column : out.color) column.resize(kPixels);
    out.lod.resize(kPixels);
    for (size_t i = 0; i < kPixels; ++i) {
        const Coordinates at = coordinates(i);
        for (size_t c = 0; c < 2; ++c) {
            out.in[c][i] = static_cast<float>(at.uv[c]);
            out.in[2 + c][i] = static_cast<float>(at.dx[c]);
            out.in[4 + c][i] = static_cast<float>(at.dy[c]);
        }
    }
    shd_lookups lookups = shd_lookups_default();
    shd_f32_in *const columns[6] = {&lookups.u, &lookups.v, &lookups.dudx, &lookups.dvdx, &lookups.dudy, &lookups.dvdy};
    lookups.count = kPixels;
    for (size_t c = 0; c < 6; ++c) columns[c]->data = out.in[c].data();
    shd_texels texels = shd_texels_default();
    for (size_t c = 0; c < 4; ++c) texels.channel[c].data = out.color[c].data();
    shd_levels levels = shd_levels_default();
    levels.lod.data = out.lod.data();
    shd_assert_ok(shd_texture_sample(s.texture, s.sampler, &lookups, &texels));
    shd_assert_ok(shd_texture_query_levels(s.texture, s.sampler, &lookups, &levels));
    return out;
}

/// The quotients of a projector, by the quotient rule.
Coordinates project(const shd_slot &slot, const Point &point)
{
    const Vec p = product(slot.place_transform, point.p);
    const Vec steps[2] = {product(slot.place_transform, point.dx), product(slot.place_transform, point.dy)};
    const float *t = slot.uv_transform;
    const auto width = static_cast<double>(slot.place_width);
    Coordinates out = {{-1, -1}, {0, 0}, {0, 0}};
    if (!(p[3] > 0)) return out;
    for (size_t k = 0; k < 2; ++k) {
        const double a = static_cast<double>(t[3 * k]), b = static_cast<double>(t[3 * k + 1]);
        out.uv[k] = a * p[0] / p[3] + b * p[1] / p[3] + static_cast<double>(t[3 * k + 2]);
        for (size_t s = 0; s < 2; ++s) {
            const double dx = (steps[s][0] * p[3] - p[0] * steps[s][3]) / (p[3] * p[3]);
            const double dy = (steps[s][1] * p[3] - p[1] * steps[s][3]) / (p[3] * p[3]);
            (s ? out.dy : out.dx)[k] = width * (a * dx + b * dy);
        }
    }
    return out;
}

void expect(const Scene &s, const std::vector<float> *color, const std::vector<float> &lod, double error)
{
    for (size_t i = 0; i < kPixels; ++i) {
        assert_true(s.f.triangle[i] < 2);
        for (size_t c = 0; c < 3; ++c) {
            shd_assert_close("colour", i, static_cast<double>(s.f.plane[c][i]), static_cast<double>(color[c][i]), error,
                             0);
        }
        shd_assert_close("lod", i, static_cast<double>(s.f.plane[SHD_PLANE_LOD][i]), static_cast<double>(lod[i]), 5e-4,
                         0);
    }
}

/// A projector in front of the whole quad, with and without a transform of uv, at several widths and filters.
void test_projected(void **)
{
    constexpr float kProjector[16] = {1.5f, 0.25f, 0, 0.5f,   -0.125f, 2,    0, 0.25f,
                                      0.5f, 0,     1, -0.75f, 0.25f,   0.5f, 0, 2};
    constexpr float kTransform[6] = {0.5f, 0.25f, 0.5f, 0, -0.5f, 0.5f};
    for (const shd_filter filter : {SHD_FILTER_BILINEAR, SHD_FILTER_TRILINEAR, SHD_FILTER_ANISOTROPIC}) {
        for (int round = 0; round < 4; ++round) {
            Scene s(filter, SHD_WRAP_REPEAT);
            shd_slot *slot = s.add(SHD_SLOT_DIFFUSE, SHD_SLOT_COORDINATES_PROJECTED);
            std::copy_n(kProjector, 16, slot->place_transform);
            if (round & 1) std::copy_n(kTransform, 6, slot->uv_transform);
            slot->place_width = static_cast<float>(1 + round);
            s.render();
            const Looked want = look_up(s, [&](size_t i) { return project(*slot, point_of(i)); });
            assert_true(want.lod[0] > 0.2f || filter == SHD_FILTER_BILINEAR);
            expect(s, want.color, want.lod, 2e-4);
        }
    }
}

/// Behind the projector, and in its plane, lookups are at (-1, -1): the border where there is one.
void test_behind(void **)
{
    for (const shd_wrap wrap : {SHD_WRAP_BORDER, SHD_WRAP_CLAMP}) {
        Scene s(SHD_FILTER_TRILINEAR, wrap);
        shd_slot *slot = s.add(SHD_SLOT_DIFFUSE, SHD_SLOT_COORDINATES_PROJECTED);
        slot->place_transform[3] = 1;  // w = x - 1 / (2 size): 0 at the middle of a pixel
        slot->place_transform[15] = static_cast<float>(-0.5 * kStep);
        s.render();
        const Looked want = look_up(s, [&](size_t i) { return project(*slot, point_of(i)); });
        for (size_t i = 0; i < kPixels; ++i) {
            const double w = point_of(i).p[0] - 0.5 * kStep;
            for (size_t c = 0; c < 3 && w <= 0.0; ++c) {
                const float value = s.f.plane[c][i];
                assert_true(value == (wrap == SHD_WRAP_BORDER ? 0.25f * static_cast<float>(c + 1) : want.color[c][i]));
            }
        }
        expect(s, want.color, want.lod, 2e-3);
    }
}

/// Every matrix has a picture without NaN, and 0 = no derivatives reads level 0.
void test_total(void **)
{
    for (const float value : {0.0f, 3e38f, -3e38f, 1e-45f, -1e-45f}) {
        for (size_t k = 0; k < 16; ++k) {
            Scene s(SHD_FILTER_ANISOTROPIC, SHD_WRAP_MIRROR);
            shd_slot *slot = s.add(SHD_SLOT_DIFFUSE, SHD_SLOT_COORDINATES_PROJECTED);
            slot->place_transform[k] = value;
            if (k % 2) slot->place_transform[3] = slot->place_transform[7] = value;
            if (k % 3 == 0) slot->place_width = 0;
            s.render();
            for (size_t i = 0; i < kPixels; ++i) {
                for (size_t c = 0; c < 3; ++c) assert_true(s.f.plane[c][i] >= 0.0f && s.f.plane[c][i] <= 1.0f);
                if (k % 3 == 0) assert_true(s.f.plane[SHD_PLANE_LOD][i] == 0.0f);
            }
        }
    }
}

/// Normals of the corners of the quad: left bottom, right bottom, left top, right top.
constexpr float kNormals[4][3] = {{1, 0.5f, -0.25f}, {-0.5f, 1, 0.25f}, {0.25f, -0.25f, -1}, {-1, 0.125f, 0.5f}};

void tilt(float *quad)
{
    for (size_t v = 0; v < 6; ++v) {
        const size_t corner = (quad[8 * v] > 0 ? 1 : 0) + (quad[8 * v + 1] > 0 ? 2 : 0);
        std::copy_n(kNormals[corner], 3, &quad[8 * v + 3]);
    }
}

/// Triplanar lookups: coordinates, levels and weights of the three axes.
struct Triplanar {
    Looked axis[3];
    std::vector<double> weight[3];
};

/// @param normal  [3][kPixels] normals in the space of places
Triplanar triplanar(const Scene &s, const shd_slot &slot, const std::vector<float> *normal)
{
    Triplanar out;
    const float *t = slot.uv_transform;
    for (size_t axis = 0; axis < 3; ++axis) {
        out.weight[axis].resize(kPixels);
        out.axis[axis] = look_up(s, [&](size_t i) {
            const Point at = point_of(i);
            const Vec p = product(slot.place_transform, at.p);
            const Vec steps[2] = {product(slot.place_transform, at.dx), product(slot.place_transform, at.dy)};
            const bool away = normal[axis][i] < 0;
            const size_t right = axis == 0 ? 2 : 0, down = axis == 1 ? 2 : 1;
            const bool flip_right = axis == 1 ? false : (axis == 0) != away, flip_down = axis == 1 ? away : true;
            const double u = flip_right ? 1 - p[right] : p[right], v = flip_down ? 1 - p[down] : p[down];
            Coordinates c;
            for (size_t k = 0; k < 2; ++k) {
                const double a = static_cast<double>(t[3 * k]), b = static_cast<double>(t[3 * k + 1]);
                c.uv[k] = a * u + b * v + static_cast<double>(t[3 * k + 2]);
                for (size_t s2 = 0; s2 < 2; ++s2) {
                    const double du = flip_right ? -steps[s2][right] : steps[s2][right];
                    const double dv = flip_down ? -steps[s2][down] : steps[s2][down];
                    (s2 ? c.dy : c.dx)[k] = static_cast<double>(slot.place_width) * (a * du + b * dv);
                }
            }
            return c;
        });
    }
    for (size_t i = 0; i < kPixels; ++i) {
        double power[3], sum = 0;
        for (size_t k = 0; k < 3; ++k)
            sum += power[k] = std::pow(std::fabs(static_cast<double>(normal[k][i])), slot.triplanar_sharpness);
        for (size_t k = 0; k < 3; ++k) out.weight[k][i] = power[k] / sum;
    }
    return out;
}

/// The normals that the frame has at its pixels.
void find_normals(Scene &s, std::vector<float> *normal)
{
    Scene n(SHD_FILTER_NEAREST, SHD_WRAP_REPEAT);
    std::copy_n(s.quad, 48, n.quad);
    n.material.debug_view = SHD_DEBUG_VIEW_NORMAL;
    n.render();
    for (size_t c = 0; c < 3; ++c) {
        for (size_t i = 0; i < kPixels; ++i) normal[c].push_back(2 * n.f.plane[c][i] - 1);
    }
}

void test_triplanar(void **)
{
    constexpr float kPlace[16] = {0.5f, 0, 0, 0, 0, 0.75f, 0, 0, 0, 0, -1.25f, 0, 0.25f, 0.5f, 0.125f, 1};
    constexpr float kTransform[6] = {2, 0.25f, 0.5f, 0.125f, -1.5f, 0.25f};
    for (const uint32_t sharpness : {1u, 4u, 64u}) {
        for (int round = 0; round < 2; ++round) {
            Scene s(SHD_FILTER_TRILINEAR, SHD_WRAP_REPEAT);
            tilt(s.quad);
            shd_slot *slot = s.add(SHD_SLOT_DIFFUSE, SHD_SLOT_COORDINATES_TRIPLANAR);
            slot->triplanar_sharpness = sharpness;
            if (round == 1) {
                std::copy_n(kPlace, 16, slot->place_transform);
                std::copy_n(kTransform, 6, slot->uv_transform);
                slot->place_width = 2;
            }
            s.render();
            std::vector<float> normal[3];
            find_normals(s, normal);
            for (size_t c = 0; c < 3 && round == 1; ++c) {
                for (float &n : normal[c]) n /= kPlace[5 * c];
            }
            const Triplanar want = triplanar(s, *slot, normal);
            std::vector<float> color[3], lod(kPixels);
            for (auto &column : color) column.resize(kPixels);
            for (size_t i = 0; i < kPixels; ++i) {
                for (size_t k = 0; k < 3; ++k) {
                    const auto w = static_cast<float>(want.weight[k][i]);
                    for (size_t c = 0; c < 3; ++c) color[c][i] += w * want.axis[k].color[c][i];
                    lod[i] += w * want.axis[k].lod[i];
                }
            }
            expect(s, color, lod, 1e-4 + 1e-5 * sharpness);
        }
    }
}

/// A normal along an axis reads that axis alone; a mesh without normals, too. Weights have the sum 1.
void test_weights(void **)
{
    const float zero[3] = {0, 0, 0}, axes[3][3] = {{2, 0, 0}, {0, -3, 0}, {0, 0, 1}};
    for (size_t k = 0; k < 4; ++k) {
        Scene s(SHD_FILTER_TRILINEAR, SHD_WRAP_REPEAT);
        for (size_t v = 0; v < 6; ++v) std::copy_n(k < 3 ? axes[k] : zero, 3, &s.quad[8 * v + 3]);
        shd_slot *slot = s.add(SHD_SLOT_DIFFUSE, SHD_SLOT_COORDINATES_TRIPLANAR);
        s.render();
        std::vector<float> normal[3];
        for (size_t c = 0; c < 3; ++c) normal[c].assign(kPixels, k < 3 ? axes[k][c] : (c == 2 ? 1.0f : 0.0f));
        const Triplanar want = triplanar(s, *slot, normal);
        expect(s, want.axis[std::min<size_t>(k, 2)].color, want.axis[std::min<size_t>(k, 2)].lod, 1e-4);
    }
    Scene s(SHD_FILTER_TRILINEAR, SHD_WRAP_REPEAT);
    const std::vector<unsigned char> white(4, 255);
    shd_texture_desc desc = shd_texture_desc_default();
    desc.width = desc.height = 1;
    desc.format = SHD_FORMAT_RGBA8;
    desc.texels = white.data();
    shd_texture_release(s.texture);
    shd_assert_ok(shd_texture_create(s.f.context, &desc, &s.texture));
    tilt(s.quad);
    s.add(SHD_SLOT_DIFFUSE, SHD_SLOT_COORDINATES_TRIPLANAR)->triplanar_sharpness = 7;
    s.render();
    for (size_t i = 0; i < kPixels; ++i) shd_assert_close("sum", i, static_cast<double>(s.f.plane[0][i]), 1, 3e-7, 0);
}

/// Object space: the projector and the blend move with the object, at every frequency.
void test_object(void **)
{
    constexpr float kToWorld[16] = {0.5f, 0, 0, 0, 0, 0.5f, 0, 0, 0, 0, 0.5f, 0, 0, 0, 0.25f, 1};
    for (const shd_slot_coordinates kind : {SHD_SLOT_COORDINATES_PROJECTED, SHD_SLOT_COORDINATES_TRIPLANAR}) {
        for (const shd_frequency frequency : {SHD_FREQUENCY_PHONG, SHD_FREQUENCY_GOURAUD, SHD_FREQUENCY_FLAT}) {
            std::vector<float> still;
            for (int moves = 0; moves < 2; ++moves) {
                Scene s(SHD_FILTER_BILINEAR, SHD_WRAP_REPEAT);
                shd_slot *slot = s.add(SHD_SLOT_DIFFUSE, kind);
                slot->place_space = SHD_PLACE_SPACE_OBJECT;
                for (size_t v = 0; v < 6 && moves; ++v) {  // in an object that the matrix halves
                    for (size_t c = 0; c < 3; ++c) s.quad[8 * v + c] = 2 * (s.quad[8 * v + c] - kToWorld[12 + c]);
                }
                if (moves) std::copy_n(kToWorld, 12, slot->place_transform);
                if (moves) std::copy_n(kToWorld + 12, 4, slot->place_transform + 12);
                shd_draw *draw = shd_frame_draw(&s.f, s.quad, 6, &s.material);
                draw->frequency = frequency;
                if (moves) std::copy_n(kToWorld, 16, draw->object_to_world);
                shd_frame_render(&s.f);
                if (!moves) still.assign(s.f.plane[0], s.f.plane[0] + kPixels);
                for (size_t i = 0; i < kPixels; ++i) {
                    shd_assert_close("red", i, static_cast<double>(s.f.plane[0][i]), static_cast<double>(still[i]),
                                     1e-4, 0);
                }
            }
        }
    }
}

/// Slots with equal coordinates share lookups, and others do not: each changed field moves the second slot alone.
void test_two_slots(void **)
{
    static void (*const kMoves[])(shd_slot *) = {
        [](shd_slot *) {},
        [](shd_slot *s) { s->place_transform[12] = 0.3f; },
        [](shd_slot *s) { s->uv_transform[1] = 0.5f; },
        [](shd_slot *s) { s->triplanar_sharpness = 1; },
        [](shd_slot *s) { s->coordinates = SHD_SLOT_COORDINATES_PROJECTED; },
        [](shd_slot *s) { s->coordinates = SHD_SLOT_COORDINATES_UV; },
    };
    for (const auto move : kMoves) {
        std::vector<float> one[2];
        for (int kind = 0; kind < 3; ++kind) {  // the first slot, the second slot, both
            Scene s(SHD_FILTER_TRILINEAR, SHD_WRAP_REPEAT);
            tilt(s.quad);
            s.material.blend = SHD_BLEND_STRAIGHT;
            if (kind != 1) s.add(SHD_SLOT_DIFFUSE, SHD_SLOT_COORDINATES_TRIPLANAR);
            if (kind != 0) {
                shd_slot *slot = s.add(SHD_SLOT_OPACITY, SHD_SLOT_COORDINATES_TRIPLANAR);
                slot->channel = 1;
                move(slot);
            }
            s.render();
            for (size_t i = 0; i < kPixels; ++i) {
                const float a = s.f.plane[SHD_PLANE_A][i], red = s.f.plane[0][i];
                if (kind < 2) one[kind].push_back(kind == 0 ? red : a);
                if (kind < 2 || s.f.triangle[i] >= 2) continue;
                const double want = static_cast<double>(one[1][i]) * static_cast<double>(one[0][i]);
                shd_assert_close("red", i, static_cast<double>(red), want, 1e-5, 0);
            }
        }
    }
}

/// Workers and SIMD targets give the same bits.
void test_workers(void **)
{
    for (const shd_slot_coordinates kind : {SHD_SLOT_COORDINATES_PROJECTED, SHD_SLOT_COORDINATES_TRIPLANAR}) {
        Scene s(SHD_FILTER_ANISOTROPIC, SHD_WRAP_REPEAT);
        tilt(s.quad);
        shd_slot *slot = s.add(SHD_SLOT_DIFFUSE, kind);
        if (kind == SHD_SLOT_COORDINATES_PROJECTED) slot->place_transform[3] = 0.75f;
        s.render();
        std::vector<float> whole[3], part(kPixels);
        for (size_t c = 0; c < 3; ++c) whole[c].assign(s.f.plane[c], s.f.plane[c] + kPixels);
        for (int simd = SHD_SIMD_BASELINE; simd <= SHD_SIMD_WASM; ++simd) {
            shd_context_desc desc = shd_context_desc_default();
            shd_context *context = nullptr;
            desc.simd = static_cast<shd_simd>(simd);
            desc.worker_count = simd % 2 ? 1 : 3;
            if (shd_context_create(&desc, &context) != SHD_OK) continue;
            shd_assert_ok(shd_render(context, &s.f.desc));
            for (size_t c = 0; c < 3; ++c) {
                const shd_f32_out out = {part.data(), 0};
                shd_assert_ok(shd_framebuffer_read_plane(s.f.framebuffer, static_cast<shd_plane>(c), &out));
                assert_memory_equal(part.data(), whole[c].data(), kPixels * sizeof(float));
            }
            shd_context_release(context);
        }
    }
}

struct Bad {
    const char *name;
    void (*edit)(shd_slot *slot);
    shd_result expected;
    const char *message;
};
const Bad kBad[] = {
    {"bad/nothing", [](shd_slot *) {}, SHD_OK, ""},
    {"bad/kind", [](shd_slot *s) { s->coordinates = static_cast<shd_slot_coordinates>(3); }, SHD_ERROR_INVALID_ARGUMENT,
     "material.slots[0].coordinates: 3 is not in 0..2"},
    {"bad/sharpness_0", [](shd_slot *s) { s->triplanar_sharpness = 0; }, SHD_ERROR_INVALID_ARGUMENT,
     "material.slots[0].triplanar_sharpness: 0 is not in 1..64"},
    {"bad/sharpness_65", [](shd_slot *s) { s->triplanar_sharpness = 65; }, SHD_ERROR_INVALID_ARGUMENT,
     "material.slots[0].triplanar_sharpness: 65 is not in 1..64"},
    {"bad/affine", [](shd_slot *s) { s->place_transform[3] = 1; }, SHD_ERROR_INVALID_ARGUMENT,
     "material.slots[0].place_transform: last row is (1, 0, 0, 1), not (0, 0, 0, 1)"},
    {"bad/projective",
     [](shd_slot *s) {
         s->coordinates = SHD_SLOT_COORDINATES_PROJECTED;
         s->place_transform[3] = 1;
     },
     SHD_OK, ""},
    {"bad/nan",
     [](shd_slot *s) {
         s->coordinates = SHD_SLOT_COORDINATES_PROJECTED;
         s->place_transform[15] = static_cast<float>(NAN);
     },
     SHD_ERROR_INVALID_ARGUMENT, "material.slots[0].place_transform[15]: "},
    {"bad/width", [](shd_slot *s) { s->place_width = -1; }, SHD_ERROR_INVALID_ARGUMENT,
     "material.slots[0].place_width: -1 is not in 0..1000"},
    {"bad/height", [](shd_slot *s) { s->target = SHD_SLOT_HEIGHT; }, SHD_ERROR_INVALID_ARGUMENT,
     "material.slots[0].coordinates: 2, but this slot takes the uv of the mesh only"},
    {"bad/source",
     [](shd_slot *s) {
         s->source = SHD_SLOT_SOURCE_VERTEX;
         s->texture = nullptr;
         s->sampler = nullptr;
     },
     SHD_ERROR_INVALID_ARGUMENT, "material.slots[0].source: 2, but coordinates of a texture are set"},
};

void test_bad(void **state)
{
    const auto *row = static_cast<const Bad *>(*state);
    shd_material *material = nullptr;
    Scene s(SHD_FILTER_TRILINEAR, SHD_WRAP_REPEAT);
    row->edit(s.add(SHD_SLOT_DIFFUSE, SHD_SLOT_COORDINATES_TRIPLANAR));
    shd_assert_result(row->name, shd_material_create(s.f.context, &s.material, &material), row->expected, row->message);
    assert_true((material != nullptr) == (row->expected == SHD_OK));
    shd_material_release(material);
}

}  // namespace

int main()
{
    std::vector<CMUnitTest> tests = {
        {"projected", test_projected, nullptr, nullptr, nullptr},
        {"behind", test_behind, nullptr, nullptr, nullptr},
        {"total", test_total, nullptr, nullptr, nullptr},
        {"triplanar", test_triplanar, nullptr, nullptr, nullptr},
        {"weights", test_weights, nullptr, nullptr, nullptr},
        {"object", test_object, nullptr, nullptr, nullptr},
        {"two_slots", test_two_slots, nullptr, nullptr, nullptr},
        {"workers", test_workers, nullptr, nullptr, nullptr},
    };
    for (const Bad &row : kBad) tests.push_back({row.name, test_bad, nullptr, nullptr, const_cast<Bad *>(&row)});
    return _cmocka_run_group_tests("api.uv_slots", tests.data(), tests.size(), nullptr, nullptr);
}
