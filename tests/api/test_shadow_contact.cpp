// SPDX-License-Identifier: MIT
// Shadows where objects touch or nearly touch, against rays to the light (tests/ref/ray_ref.h): no light in contacts,
// feet attached to their shadows, and penumbras without a pattern.
#include <vector>

#include <shd/shd.h>

#include "ref/ray_ref.h"
#include "support/check.h"
#include "support/random.h"

namespace shd::tests
{
namespace
{

using ref::Vec3;

constexpr double kPi = 3.14159265358979323846;

shd_context *g_context;

int set_up(void **)
{
    shd_assert_ok(shd_context_create(nullptr, &g_context));
    return 0;
}
int tear_down(void **)
{
    shd_context_release(g_context);
    return 0;
}

using Triangles = std::vector<ref::RayTriangle>;

void add_triangle(Triangles *out, const Vec3 &a, const Vec3 &b, const Vec3 &c)
{
    const Vec3 n = ref::unit(ref::cross(b - a, c - a));
    out->push_back({{a, b, c}, {n, n, n}});
}

/// A parallelogram with corners at, at + u, at + v; its normal is u x v.
void add_quad(Triangles *out, const Vec3 &at, const Vec3 &u, const Vec3 &v)
{
    add_triangle(out, at, at + u, at + u + v);
    add_triangle(out, at, at + u + v, at + v);
}

/// A square prism from `foot` on the floor to `foot` + `top`, with sides of length 2 half.
void add_leg(Triangles *out, const Vec3 &foot, double half, const Vec3 &top)
{
    const Vec3 corner[4] = {{-half, 0, -half}, {-half, 0, half}, {half, 0, half}, {half, 0, -half}};
    for (int i = 0; i < 4; ++i) add_quad(out, foot + corner[i], corner[(i + 1) % 4] - corner[i], top);
}

Triangles triangles_of(const shd_shape_desc &desc)
{
    shd_shape_columns columns = shd_shape_columns_default();
    shd_assert_ok(shd_shape_count(&desc, &columns.vertex_count, &columns.index_count));
    std::vector<float> vertices(size_t{6} * columns.vertex_count);
    std::vector<uint32_t> indices(columns.index_count);
    for (size_t c = 0; c < 3; ++c) {
        columns.position[c] = {vertices.data() + c, 6 * sizeof(float)};
        columns.normal[c] = {vertices.data() + 3 + c, 6 * sizeof(float)};
    }
    columns.indices.data = indices.data();
    shd_assert_ok(shd_shape_fill(&desc, &columns));
    Triangles out;
    for (size_t i = 0; i < indices.size(); i += 3) {
        ref::RayTriangle triangle;
        for (size_t k = 0; k < 3; ++k) {
            for (size_t c = 0; c < 3; ++c) {
                const float *vertex = vertices.data() + size_t{6} * indices[i + k];
                triangle.corner[k][c] = static_cast<double>(vertex[c]);
                triangle.normal[k][c] = static_cast<double>(vertex[3 + c]);
            }
        }
        out.push_back(triangle);
    }
    return out;
}

Triangles teapot_on_floor()
{
    shd_shape_desc desc = shd_shape_desc_default();
    desc.kind = SHD_SHAPE_TEAPOT;
    desc.segments[0] = 32;
    Triangles out = triangles_of(desc);
    add_quad(&out, {-12, 0, -12}, {0, 0, 24}, {24, 0, 0});
    return out;
}

/// A square light: directional with the width of its directions, or a spot with the width of its surface.
struct SquareLight {
    shd_light_kind kind;
    Vec3 position, direction;  // direction: unit
    double size;
};

/// Shadow map, rays and points of a scene.
class Scene
{
   public:
    Scene(const Triangles &triangles, const SquareLight &light, const shd_shadow_desc &desc)
        : light_(light), rays_(triangles)
    {
        for (const ref::RayTriangle &triangle : triangles) {
            for (size_t k = 0; k < 3; ++k) {
                for (size_t c = 0; c < 3; ++c) vertices_.push_back(static_cast<float>(triangle.corner[k][c]));
                indices_.push_back(static_cast<uint32_t>(indices_.size()));
            }
        }
        shd_mesh_desc mesh_desc = shd_mesh_desc_default();
        mesh_desc.vertex_count = static_cast<uint32_t>(indices_.size());
        for (size_t c = 0; c < 3; ++c) mesh_desc.position[c] = {vertices_.data() + c, 3 * sizeof(float)};
        mesh_desc.indices.data = indices_.data();
        mesh_desc.index_count = indices_.size();
        shd_assert_ok(shd_mesh_create(g_context, &mesh_desc, &mesh_));
        shd_light_desc light_desc = shd_light_desc_default();
        light_desc.kind = light.kind;
        for (size_t c = 0; c < 3; ++c) {
            light_desc.position[c] = static_cast<float>(light.position[c]);
            light_desc.direction[c] = static_cast<float>(light.direction[c]);
        }
        light_desc.outer_angle = 0.5236f;
        shd_assert_ok(shd_light_create(g_context, &light_desc, &shd_light_));
        shd_draw draw = shd_draw_default();
        draw.mesh = mesh_;
        shd_shadow_render_desc render = shd_shadow_render_desc_default();
        render.light = shd_light_;
        render.draws = &draw;
        render.draw_count = 1;
        shd_assert_ok(shd_shadow_create(g_context, &desc, &shadow_));
        shd_assert_ok(shd_shadow_render(g_context, shadow_, &render));
    }
    ~Scene()
    {
        shd_shadow_release(shadow_);
        shd_light_release(shd_light_);
        shd_mesh_release(mesh_);
    }
    Scene(const Scene &) = delete;
    Scene &operator=(const Scene &) = delete;

    float visibility(const Vec3 &p, const Vec3 &n) const
    {
        float value = -1.0f, columns[6];
        for (size_t c = 0; c < 3; ++c) {
            columns[c] = static_cast<float>(p[c]);
            columns[3 + c] = static_cast<float>(n[c]);
        }
        shd_shadow_lookups lookups = shd_shadow_lookups_default();
        lookups.count = 1;
        for (size_t c = 0; c < 3; ++c) {
            lookups.position[c].data = columns + c;
            lookups.normal[c].data = columns + 3 + c;
        }
        shd_shadow_values out = {sizeof out, {&value, 0}, 0};
        shd_assert_ok(shd_shadow_sample(shadow_, &lookups, &out));
        return value;
    }
    /// Fraction of n x n points of the light that are visible from a point on a surface with this geometric normal.
    double truth(const Vec3 &p, const Vec3 &normal, int n) const
    {
        const Vec3 right = ref::unit(ref::cross(light_.direction, {0, 1, 0})), up = ref::cross(right, light_.direction);
        int lit = 0;
        for (int i = 0; i < n * n; ++i) {
            const double u = ((i % n + 0.5) / n - 0.5) * light_.size, v = ((i / n + 0.5) / n - 0.5) * light_.size;
            const Vec3 offset = u * right + v * up;
            const Vec3 way = light_.kind == SHD_LIGHT_KIND_DIRECTIONAL ? 100.0 * (offset - light_.direction)
                                                                       : light_.position + offset - p;
            if (ref::dot(way, normal) > 0 && !rays_.is_blocked(p + 1e-4 * normal, way)) ++lit;
        }
        return static_cast<double>(lit) / (n * n);
    }
    const ref::RayScene &rays() const { return rays_; }

   private:
    const SquareLight light_;
    ref::RayScene rays_;
    std::vector<float> vertices_;
    std::vector<uint32_t> indices_;
    shd_mesh *mesh_ = nullptr;
    shd_light *shd_light_ = nullptr;
    shd_shadow *shadow_ = nullptr;
};

shd_shadow_desc soft_desc(uint32_t taps, float light_size)
{
    shd_shadow_desc desc = shd_shadow_desc_default();
    desc.filter = SHD_SHADOW_FILTER_PCSS;
    desc.taps = taps;
    desc.light_size = light_size;
    return desc;
}

/// Differences of a filter from the truth at points.
struct Score {
    size_t count, leaks, dark;  // leaks: lighter than the truth by more than 1/4
    double rms;
};

void add_difference(const Scene &scene, const Vec3 &p, const Vec3 &normal, const Vec3 &facet, Score *score)
{
    const double e = static_cast<double>(scene.visibility(p, normal)) - scene.truth(p, facet, 8);
    score->leaks += e > 0.25;
    score->dark += e < -0.25;
    score->rms += e * e;
    ++score->count;
}

/// Replaces the sum of squares by their root mean square.
Score mean_of(Score score)
{
    score.rms = std::sqrt(score.rms / static_cast<double>(score.count));
    return score;
}

/// A square picture of the edge length 2 reach around a target.
struct Picture {
    Vec3 eye, target;
    double reach;
};

Score score_view(const Scene &scene, const SquareLight &light, const Picture &picture)
{
    const Vec3 ahead = ref::unit(picture.target - picture.eye), right = ref::unit(ref::cross(ahead, {0, 1, 0}));
    const Vec3 up = ref::cross(right, ahead);
    constexpr int kSide = 90;
    Score score = {0, 0, 0, 0};
    for (int i = 0; i < kSide * kSide; ++i) {
        const double x = (2.0 * (i % kSide) / kSide - 1.0) * picture.reach;
        const double y = (2.0 * (i / kSide) / kSide - 1.0) * picture.reach;
        const Vec3 way = picture.target + x * right + y * up - picture.eye;
        const ref::RayHit hit = scene.rays().first(picture.eye, way, 100.0);
        if (!std::isfinite(hit.t)) continue;
        const ref::RayTriangle &at = scene.rays().triangle(hit.triangle);
        const Vec3 p = picture.eye + hit.t * way, to_light = ref::unit(light.position - p);
        const Vec3 facet = ref::unit(ref::cross(at.corner[1] - at.corner[0], at.corner[2] - at.corner[0]));
        const Vec3 n = ref::unit(ref::mix(at.normal, hit.u, hit.v));
        // Where light grazes a facet, its smooth normal may face the light while the facet does not.
        if (ref::dot(n, to_light) < 0.05 || ref::dot(facet, to_light) < 0.05) continue;
        add_difference(scene, p, n, facet, &score);
    }
    return mean_of(score);
}

void expect_score(const char *name, const Score &score, size_t max_leaks, size_t max_dark, double max_rms)
{
    if (score.count < 3000 || score.leaks > max_leaks || score.dark > max_dark || !(score.rms <= max_rms)) {
        fail_msg("%s: %zu points, %zu of them too light, %zu too dark, RMS %.4f", name, score.count, score.leaks,
                 score.dark, score.rms);
    }
}

/// The teapot of the pictures "spot" and "light cookie": contacts of spout, lid and knob. The leaks that remain at the
/// spout are about a texel wide.
void test_teapot(void **)
{
    const Vec3 centre = {0.217, 1.575, 0}, eye = {5.56, 7.47, 11.46};
    const double radius = 4.102;
    SquareLight light = {SHD_LIGHT_KIND_SPOT, centre + radius * Vec3{-1.5, 2.5, 1.5}, {}, 0.2 * radius};
    light.direction = ref::unit(Vec3{1.5, -2.5, -1.5});
    const Scene scene(teapot_on_floor(), light, soft_desc(11, static_cast<float>(light.size)));
    expect_score("spout", score_view(scene, light, {eye, {1.95, 1.38, 0.2}, 0.2}), 110, 0, 0.082);
    expect_score("lid", score_view(scene, light, {eye, {-0.2, 2.6, 0.2}, 0.9}), 3, 5, 0.014);
}

/// Thin legs that lean over a floor, as those of a spider: the shadow of a foot starts at the foot.
void test_foot(void **)
{
    const SquareLight light = {SHD_LIGHT_KIND_DIRECTIONAL, {}, ref::unit(Vec3{0.8, -1.1, -0.3}), 0.2};
    Triangles triangles;
    add_quad(&triangles, {-2, 0, -2}, {0, 0, 4}, {4, 0, 0});
    add_leg(&triangles, {0, 0, 0}, 0.008, {-0.2, 0.6, 0.1});
    add_leg(&triangles, {-0.5, 0, 0.6}, 0.008, {0.3, 0.6, 0.0});
    add_leg(&triangles, {0.5, 0, -0.5}, 0.008, {0.1, 0.6, 0.2});
    const Scene scene(triangles, light, soft_desc(7, static_cast<float>(light.size)));
    Score score = {0, 0, 0, 0};
    for (int i = 0; i < 3600; ++i) {  // around the shadow of the first foot, from its side
        add_difference(scene, {0.0085 + 0.003 * (i % 60), 0, 0.03 - 0.0015 * (i / 60)}, {0, 1, 0}, {0, 1, 0}, &score);
    }
    expect_score("foot", mean_of(score), 20, 60, 0.08);
    const Vec3 along = ref::unit(Vec3{0.8 - 0.2 * 1.1 / 0.6, 0, -0.3 + 0.1 * 1.1 / 0.6});
    for (double t = 0.01; t < 0.03; t += 0.002) assert_true(scene.visibility(t * along, {0, 1, 0}) < 0.25f);
}

/// Smooth balls of few triangles: the clamped bias causes no stripes of shadow on their lit side.
void test_balls(void **)
{
    const SquareLight light = {SHD_LIGHT_KIND_DIRECTIONAL, {}, ref::unit(Vec3{0.3, -1, 0.2}), 0.05};
    for (const uint32_t segments : {16u, 32u}) {
        shd_shape_desc ball = shd_shape_desc_default();
        ball.segments[0] = 2 * segments;
        ball.segments[1] = segments;
        const Triangles triangles = triangles_of(ball);
        for (const shd_shadow_filter filter : {SHD_SHADOW_FILTER_HARD, SHD_SHADOW_FILTER_PCF, SHD_SHADOW_FILTER_PCSS}) {
            shd_shadow_desc desc = soft_desc(3, static_cast<float>(light.size));
            desc.filter = filter;
            const Scene scene(triangles, light, desc);
            Random random = {9};
            for (size_t i = 0; i < 20 * triangles.size(); ++i) {
                const ref::RayTriangle &at = triangles[i / 20];
                const double u = random.unit(), v = (1 - u) * random.unit();
                const Vec3 p = ref::mix(at.corner, u, v), n = ref::unit(ref::mix(at.normal, u, v));
                if (-ref::dot(n, light.direction) < 0.15) continue;
                if (scene.visibility(p, n) < 0.9f) fail_msg("%u parts, filter %d: a shadow", segments, filter);
            }
        }
    }
}

/// A plate a little above a floor, under light that grazes both: the floor is in shadow, although the gap is narrower
/// than the slope of the light across a texel.
void test_grazing(void **)
{
    Triangles triangles;
    add_quad(&triangles, {-2, 0, -2}, {0, 0, 4}, {4, 0, 0});
    add_quad(&triangles, {-1, 0.003, -1}, {0, 0, 2}, {2, 0, 0});
    const SquareLight light = {SHD_LIGHT_KIND_DIRECTIONAL, {}, ref::unit(Vec3{20, -1, 0}), 0};
    for (const shd_shadow_filter filter : {SHD_SHADOW_FILTER_HARD, SHD_SHADOW_FILTER_PCF, SHD_SHADOW_FILTER_PCSS}) {
        shd_shadow_desc desc = shd_shadow_desc_default();
        desc.filter = filter;
        const Scene scene(triangles, light, desc);
        Random random = {3};
        for (int i = 0; i < 500; ++i) {
            const Vec3 p = {random.in(-0.5, 0.5), 0, random.in(-0.5, 0.5)};
            if (scene.visibility(p, {0, 1, 0}) != 0.0f) fail_msg("filter %d: light under a plate", filter);
        }
    }
}

/// Errors against the truth in a wide penumbra, at points 1/4 of a texel apart: their mean, standard deviation and
/// correlation with the neighbour across, along and three points away.
struct Pattern {
    double mean, deviation, correlation[3];
};

Pattern pattern_of(const Scene &scene)
{
    constexpr int kSide = 160, kCount = kSide * kSide;
    const int step[3] = {1, kSide, 3};
    std::vector<double> error;
    Pattern out = {0, 0, {0, 0, 0}};
    for (int i = 0; i < kCount; ++i) {
        const Vec3 p = {1.1 + 0.002 * (i % kSide), 0, 0.002 * (i / kSide)}, up = {0, 1, 0};
        error.push_back(static_cast<double>(scene.visibility(p, up)) - scene.truth(p, up, 12));
        out.mean += error.back() / kCount;
    }
    double variance = 0;
    for (const double e : error) variance += (e - out.mean) * (e - out.mean);
    for (int k = 0; k < 3; ++k) {
        for (size_t i = 0, j = static_cast<size_t>(step[k]); j < error.size(); ++i, ++j) {
            out.correlation[k] += (error[i] - out.mean) * (error[j] - out.mean) / variance;
        }
    }
    out.deviation = std::sqrt(variance / kCount);
    return out;
}

/// Wide penumbras show noise, not copies of an edge: errors of neighbours are independent, and their mean is near 0.
void test_pattern(void **)
{
    Triangles triangles;
    add_quad(&triangles, {-4, 0, -4}, {0, 0, 8}, {8, 0, 0});
    add_quad(&triangles, {-6, 1, -3}, {1.2, 0, 6}, {6, 0, -1.2});
    const SquareLight light = {SHD_LIGHT_KIND_DIRECTIONAL, {}, ref::unit(Vec3{0.1, -1, 0.05}), 0.4};
    const struct {
        uint32_t taps;
        double deviation;
    } k_cases[] = {{3, 0.045}, {5, 0.02}, {11, 0.008}};
    for (const auto &c : k_cases) {
        const Scene scene(triangles, light, soft_desc(c.taps, static_cast<float>(light.size)));
        const Pattern pattern = pattern_of(scene);
        bool good = std::fabs(pattern.mean) < 0.004 && pattern.deviation < c.deviation;
        for (const double correlation : pattern.correlation) good = good && std::fabs(correlation) < 0.2;
        if (!good) {
            fail_msg("%u taps: mean %.4f, deviation %.4f, correlations %.3f, %.3f, %.3f", c.taps, pattern.mean,
                     pattern.deviation, pattern.correlation[0], pattern.correlation[1], pattern.correlation[2]);
        }
    }
}

}  // namespace
}  // namespace shd::tests

int main()
{
    using namespace shd::tests;
    const CMUnitTest tests[] = {{"teapot", test_teapot, nullptr, nullptr, nullptr},
                                {"foot", test_foot, nullptr, nullptr, nullptr},
                                {"balls", test_balls, nullptr, nullptr, nullptr},
                                {"grazing", test_grazing, nullptr, nullptr, nullptr},
                                {"pattern", test_pattern, nullptr, nullptr, nullptr}};
    return _cmocka_run_group_tests("api.shadow_contact", tests, sizeof tests / sizeof tests[0], set_up, tear_down);
}
