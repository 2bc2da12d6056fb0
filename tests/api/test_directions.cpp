// SPDX-License-Identifier: MIT
// Lookups of textures of directions: values of functions on the sphere, seams, footprints against dense supersampling.
#include "support/directions.h"

namespace shd::tests
{
namespace
{

double smooth(const double *n)
{
    return 2.0 + 0.5 * n[0] - 0.7 * n[1] + 0.3 * n[2] + 0.4 * n[0] * n[1] - 0.2 * n[1] * n[2];
}

/// Random directions, and directions at the poles, axes, edges and corners and near them.
void add_directions(DirectionLookups *to, size_t random_count)
{
    Random random{1};
    double n[3];
    for (size_t i = 0; i < random_count; ++i) {
        random_direction(&random, n);
        to->add(n);
    }
    for (int i = 0; i < 125; ++i) {
        const double near[5] = {-1.0, -1e-3, 0.0, 1e-3, 1.0};
        n[0] = near[i % 5], n[1] = near[i / 5 % 5], n[2] = near[i / 25];
        if (n[0] != 0.0 || n[1] != 0.0 || n[2] != 0.0) to->add(n);
    }
}

void fail_at(const DirectionLookups &at, size_t i, shd_projection projection, const char *what, double got, double want)
{
    fail_msg("%s %s [%zu] (%g, %g, %g): %g instead of %g", kProjectionNames[projection], what, i,
             double{at.column[0][i]}, double{at.column[1][i]}, double{at.column[2][i]}, got, want);
}

/// A smooth function is reproduced everywhere, at every level: a wrong neighbour at a seam would be far off. The error
/// of a level is a part of the change of the function over a texel.
void test_smooth(void **)
{
    DirectionLookups at;
    add_directions(&at, 3000);
    for (shd_projection projection : kProjections) {
        const bool lat_long = projection == SHD_PROJECTION_LAT_LONG;
        for (uint32_t size : {64u, 48u, 31u}) {
            DirectionImage image(projection, lat_long ? 2 * size + size % 2 : size, size);
            image.fill(smooth);
            shd_texture *texture = image.texture(g_context);
            for (const DirectionFilter &filter : kDirectionFilters) {
                shd_sampler *sampler = make_sampler(g_context, filter.filter);
                for (float lod : {0.0f, 1.0f, 2.0f, 2.5f}) {
                    at.lod.assign(at.count(), lod);
                    at.sample(texture, sampler);
                    assert_int_equal(0, at.nonfinite);
                    // The function changes by at most 1.3 per radian.
                    const bool nearest = has_steps(filter.filter);
                    const bool ball = projection == SHD_PROJECTION_MIRROR_BALL;
                    const double side = ball ? 8.0 : is_disc(projection) ? 6.3 : 4.9;
                    const double texel = side / (size >> static_cast<int>(std::ceil(lod)));
                    const double bound = (nearest ? 1.0 : is_disc(projection) ? 0.8 : 0.35) * texel;
                    for (size_t i = 0; i < at.count(); ++i) {
                        double n[3] = {at.column[0][i], at.column[1][i], at.column[2][i]};
                        const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
                        for (double &x : n) x /= length;
                        // Texels at the rim of a disc are long: all of it is one direction.
                        if (is_disc(projection) && n[2] < (ball ? -0.5 : -0.9)) continue;
                        if (std::fabs(double{at.value[i]} - smooth(n)) > bound) {
                            fail_at(at, i, projection, filter.name, double{at.value[i]}, smooth(n));
                        }
                    }
                }
                shd_sampler_release(sampler);
            }
            shd_texture_release(texture);
        }
    }
}

/// Pairs of directions on both sides of a seam, 2e-5 rad apart.
void add_pairs(shd_projection projection, DirectionLookups *to)
{
    Random random{7};
    const double e = 1e-5;
    for (int i = 0; i < 2000; ++i) {
        double a[3], b[3];
        random_direction(&random, a);
        if (projection == SHD_PROJECTION_LAT_LONG) {
            if (i % 2) a[0] = 0.0, a[2] = -std::fabs(a[2]);  // the meridian u = 0
            if (i % 2 == 0) a[0] *= e, a[2] *= e;            // a pole
        } else if (projection == SHD_PROJECTION_CUBE) {
            const int c = i % 3, j = (c + 1) % 3;
            a[j] = std::copysign(a[c], a[j]);                                      // an edge
            if (i % 5 == 0) a[(c + 2) % 3] = std::copysign(a[c], a[(c + 2) % 3]);  // a corner
        } else if (i % 2) {
            a[i / 2 % 2] = 0.0, a[2] = -std::fabs(a[2]);  // an edge of the octahedral map
        } else {
            a[0] *= e, a[1] *= e, a[2] = -1.0;  // its corners
        }
        const double sum = std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
        for (int c = 0; c < 3; ++c) {
            const double push = e * (2.0 * random.unit() - 1.0) * sum;
            b[c] = a[c] - push, a[c] += push;
        }
        to->add(a), to->add(b);
    }
}

/// Lookups in noise have no seam at any level: values on both sides of an edge differ by the slope at most.
void test_no_seam(void **)
{
    for (shd_projection projection : {SHD_PROJECTION_LAT_LONG, SHD_PROJECTION_CUBE, SHD_PROJECTION_OCTAHEDRAL}) {
        DirectionLookups at;
        add_pairs(projection, &at);
        for (uint32_t size : {16u, 13u, 1u}) {
            const bool lat_long = projection == SHD_PROJECTION_LAT_LONG;
            DirectionImage image(projection, lat_long ? 2 * size + 1 : size, size);
            image.fill_noise(size);
            shd_texture *texture = image.texture(g_context);
            for (const DirectionFilter &filter : kDirectionFilters) {
                if (has_steps(filter.filter)) continue;
                if (filter.filter == SHD_FILTER_EWA) continue;  // texels enter the ellipse one by one
                shd_sampler *sampler = make_sampler(g_context, filter.filter);
                for (float lod : {0.0f, 0.6f, 1.0f, 2.4f, 3.0f, 4.0f}) {
                    at.lod.assign(at.count(), lod);
                    at.sample(texture, sampler);
                    for (size_t i = 0; i < at.count(); i += 2) {
                        // Texels at a pole of LAT_LONG are narrow: there the slope across them has no bound.
                        const double near_pole = std::hypot(double{at.column[0][i]}, double{at.column[2][i]});
                        const bool pole = lat_long && near_pole < 0.5 * std::fabs(double{at.column[1][i]});
                        if (pole && i % 4 == 2) continue;
                        const double bound = pole ? 1.0 : 2e-5 * size * 4.0;
                        const double difference = std::fabs(double{at.value[i]} - double{at.value[i + 1]});
                        if (!(difference <= bound)) {
                            fail_at(at, i, projection, filter.name, double{at.value[i]}, double{at.value[i + 1]});
                        }
                    }
                }
                shd_sampler_release(sampler);
            }
            shd_texture_release(texture);
        }
    }
}

/// The value along a meridian is continuous over the pole, for odd and even widths.
void test_over_the_pole(void **)
{
    shd_sampler *sampler = make_sampler(g_context, SHD_FILTER_BILINEAR);
    for (uint32_t width : {16u, 7u, 2u, 1u}) {
        DirectionImage image(SHD_PROJECTION_LAT_LONG, width, 5);
        image.fill_noise(width);
        shd_texture *texture = image.texture(g_context);
        DirectionLookups at;
        for (int i = 0; i < 400; ++i) {
            const double a = 0.05 * i, pole = i % 2 ? 1.0 : -1.0;
            const double x = 1e-6 * std::cos(a), z = 1e-6 * std::sin(a);
            const double near[3] = {x, pole, z}, far[3] = {-x, pole, -z};
            at.add(near), at.add(far);
        }
        at.sample(texture, sampler);
        for (size_t i = 0; i < at.count(); i += 2) {
            shd_assert_close("pole", i, double{at.value[i]}, double{at.value[i + 1]}, 2e-5, 0.0);
        }
        shd_texture_release(texture);
    }
    shd_sampler_release(sampler);
}

/// A corner of the cube is the average of its three texels.
void test_corners(void **)
{
    for (uint32_t size : {1u, 2u, 5u, 8u}) {
        DirectionImage image(SHD_PROJECTION_CUBE, size, size);
        image.fill_noise(size);
        shd_texture *texture = image.texture(g_context);
        shd_sampler *sampler = make_sampler(g_context, SHD_FILTER_BILINEAR);
        DirectionLookups at;
        for (int i = 0; i < 8; ++i) {
            const double n[3] = {i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0};
            at.add(n);
        }
        at.sample(texture, sampler);
        for (size_t i = 0; i < 8; ++i) {
            const long double n[3] = {at.column[0][i], at.column[1][i], at.column[2][i]};
            double sum = 0.0;
            for (int axis = 0; axis < 3; ++axis) {
                const uint32_t face = 2 * static_cast<uint32_t>(axis) + (n[axis] < 0.0L);
                const ref_place place = ref_on_face(n, face);
                const auto x = place.u > 0.5L ? size - 1 : 0, y = place.v > 0.5L ? size - 1 : 0;
                sum += double{image.texels[(face * size + y) * size + x]};
            }
            shd_assert_close("corner", i, double{at.value[i]}, sum / 3.0, 1e-6, 0.0);
        }
        shd_sampler_release(sampler);
        shd_texture_release(texture);
    }
}

/// Detail of many sizes on the sphere.
double detailed(const double *n)
{
    double sum = 0.5;
    for (int k = 0; k < 5; ++k) {
        const double f = 3.0 * (1 << k), a = 0.7 * k;
        sum += 0.12 * std::sin(f * (n[0] * std::cos(a) + n[1] * std::sin(a)) + k) * std::cos(f * n[2] + 2 * k);
    }
    return sum;
}

struct Errors {
    double square = 0.0, sum = 0.0;
    size_t count = 0;

    void add(double error)
    {
        square += error * error, sum += error;
        ++count;
    }
    double rms() const { return std::sqrt(square / static_cast<double>(count)); }
    double bias() const { return std::fabs(sum / static_cast<double>(count)); }
};

/// Two unit vectors that are perpendicular to n and to each other.
void tangents(const double *n, double turn, double *a, double *b)
{
    const double up[3] = {std::fabs(n[1]) < 0.9 ? 0.0 : 1.0, std::fabs(n[1]) < 0.9 ? 1.0 : 0.0, 0.0};
    double s[3], t[3], length = 0.0;
    for (int c = 0; c < 3; ++c) s[c] = up[(c + 1) % 3] * n[(c + 2) % 3] - up[(c + 2) % 3] * n[(c + 1) % 3];
    for (double x : s) length += x * x;
    for (double &x : s) x /= std::sqrt(length);
    for (int c = 0; c < 3; ++c) t[c] = n[(c + 1) % 3] * s[(c + 2) % 3] - n[(c + 2) % 3] * s[(c + 1) % 3];
    for (int c = 0; c < 3; ++c) {
        a[c] = std::cos(turn) * s[c] + std::sin(turn) * t[c];
        b[c] = std::cos(turn) * t[c] - std::sin(turn) * s[c];
    }
}

/// Mean of `detailed` over the parallelogram n + x dx + y dy, x and y in -1/2..1/2.
double box_of(const double *n, const double *dx, const double *dy)
{
    constexpr int kSide = 16;
    double sum = 0.0;
    for (int i = 0; i < kSide * kSide; ++i) {
        const double x = (i % kSide + 0.5) / kSide - 0.5, y = (i / kSide + 0.5) / kSide - 0.5;
        double p[3], length = 0.0;
        for (int c = 0; c < 3; ++c) p[c] = n[c] + x * dx[c] + y * dy[c];
        for (double q : p) length += q * q;
        for (double &q : p) q /= std::sqrt(length);
        sum += detailed(p);
    }
    return sum / (kSide * kSide);
}

/// Footprints of 0.02 to 0.3 rad around directions of a kind, against the supersampled function.
Errors errors_of(shd_texture *texture, shd_sampler *sampler, bool at_seam, double ratio)
{
    DirectionLookups at;
    std::vector<double> want;
    Random random{11};
    for (int i = 0; i < 400; ++i) {
        double n[3], a[3], b[3];
        random_direction(&random, n);
        if (at_seam && i % 2) n[0] *= 0.1, n[2] *= 0.1;                // around the poles
        if (at_seam && i % 2 == 0) n[i / 2 % 3] = n[(i / 2 + 1) % 3];  // edges of the cube
        double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        for (double &x : n) x /= length;
        tangents(n, 6.3 * random.unit(), a, b);
        const double size = 0.02 * std::pow(15.0 / ratio, random.unit());
        for (int c = 0; c < 3; ++c) a[c] *= size * ratio, b[c] *= size;
        want.push_back(box_of(n, a, b));
        at.add(n, a, b);
    }
    at.sample(texture, sampler);
    Errors errors;
    for (size_t i = 0; i < want.size(); ++i) errors.add(double{at.value[i]} - want[i]);
    return errors;
}

/// Bounds of the RMS error. A lookup without its footprint (bilinear on level 0) is far off.
void test_footprints(void **)
{
    const struct {
        shd_filter filter;
        const char *name;
        double ratio, least, most;
    } rows[] = {
        {SHD_FILTER_BILINEAR, "bilinear", 1.0, 0.04, 1.0},
        {SHD_FILTER_TRILINEAR, "trilinear", 1.0, 0.0, 0.03},
        {SHD_FILTER_ANISOTROPIC, "anisotropic", 1.0, 0.0, 0.02},
        {SHD_FILTER_ANISOTROPIC, "anisotropic 5:1", 5.0, 0.0, 0.02},
        {SHD_FILTER_EWA, "ewa", 1.0, 0.0, 0.022},
        {SHD_FILTER_EWA, "ewa 5:1", 5.0, 0.0, 0.02},
        {SHD_FILTER_EXACT, "exact", 1.0, 0.0, 0.01},
        {SHD_FILTER_EXACT, "exact 5:1", 5.0, 0.0, 0.02},
    };
    for (shd_projection projection : {SHD_PROJECTION_LAT_LONG, SHD_PROJECTION_CUBE, SHD_PROJECTION_OCTAHEDRAL}) {
        const bool lat_long = projection == SHD_PROJECTION_LAT_LONG;
        DirectionImage image(projection, lat_long ? 512 : 256, 256);
        image.fill(detailed);
        shd_texture *texture = image.texture(g_context);
        for (const auto &row : rows) {
            shd_sampler *sampler = make_sampler(g_context, row.filter);
            for (bool at_seam : {false, true}) {
                const Errors errors = errors_of(texture, sampler, at_seam, row.ratio);
                if (!(errors.rms() <= row.most && errors.rms() >= row.least &&
                      errors.bias() <= (row.least > 0.0 ? 0.01 : 0.003))) {
                    fail_msg("%s %s %s: rms %g, bias %g", kProjectionNames[projection], row.name,
                             at_seam ? "seams" : "all", errors.rms(), errors.bias());
                }
            }
            shd_sampler_release(sampler);
        }
        shd_texture_release(texture);
    }
}

}  // namespace
}  // namespace shd::tests

int main()
{
    using namespace shd::tests;
    const CMUnitTest tests[] = {
        {"smooth", test_smooth, nullptr, nullptr, nullptr},
        {"no_seam", test_no_seam, nullptr, nullptr, nullptr},
        {"over_the_pole", test_over_the_pole, nullptr, nullptr, nullptr},
        {"corners", test_corners, nullptr, nullptr, nullptr},
        {"footprints", test_footprints, nullptr, nullptr, nullptr},
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
