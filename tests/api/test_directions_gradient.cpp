// SPDX-License-Identifier: MIT
// Derivatives of lookups of directions in the components of the directions: against a double oracle of bilinear, and
// against differences of the library's own values for every filter and projection.
#include "ref/direction_filter_ref.h"
#include "support/directions.h"
#include "support/simd.h"

namespace shd::tests
{
namespace
{

/// Directions anywhere, and near edges, corners, poles and axes.
void add_directions(DirectionLookups *to, size_t count, uint64_t seed)
{
    Random random{seed};
    for (size_t i = 0; i < count; ++i) {
        double n[3];
        random_direction(&random, n);
        const int c = static_cast<int>(i / 5 % 3), j = (c + 1) % 3, k = (c + 2) % 3;
        if (i % 5 == 1) n[j] = std::copysign(n[c] * random.in(0.9, 1.1), n[j]);  // edges of the cube
        if (i % 5 == 2) {                                                        // corners
            n[j] = std::copysign(n[c] * random.in(0.9, 1.1), n[j]);
            n[k] = std::copysign(n[c] * random.in(0.9, 1.1), n[k]);
        }
        if (i % 5 == 3) n[j] *= 0.1, n[k] *= 0.1;  // poles and centres
        if (i % 5 == 4) n[j] *= 0.05;              // seams of the other maps
        const double length = random.in(0.3, 3.0);
        for (double &x : n) x *= length;
        to->add(n);
    }
}

shd_texture *noise(shd_projection projection, uint32_t size, DirectionImage **keep)
{
    delete *keep;
    const bool lat_long = projection == SHD_PROJECTION_LAT_LONG;
    *keep = new DirectionImage(projection, lat_long ? 2 * size + size % 2 : size, size);
    (*keep)->fill_noise(size + 3);
    return (*keep)->texture(g_context);
}

/// Moving along the direction changes nothing.
void check_radial(const DirectionLookups &at, size_t i, const char *name)
{
    double along = 0.0, squares[2] = {};
    for (size_t c = 0; c < 3; ++c) {
        const double n = double{at.column[c][i]}, slope = double{at.slope[c][i]};
        along += n * slope, squares[0] += n * n, squares[1] += slope * slope;
    }
    const double bound = 4e-6 * std::sqrt(squares[0] * squares[1]);
    if (!(std::fabs(along) <= bound)) fail_msg("%s [%zu]: n . gradient is %g", name, i, along);
}

/// Bilinear or Hermite against central differences of the oracle, in noise of even and odd sizes and of one texel.
void test_bilinear(void **state)
{
    const bool smooth = *state != nullptr;
    DirectionImage *image = nullptr;
    shd_sampler *sampler = make_sampler(g_context, smooth ? SHD_FILTER_HERMITE : SHD_FILTER_BILINEAR);
    for (shd_projection projection : {SHD_PROJECTION_LAT_LONG, SHD_PROJECTION_CUBE, SHD_PROJECTION_OCTAHEDRAL}) {
        for (uint32_t size : {16u, 7u, 2u, 1u}) {
            shd_texture *texture = noise(projection, size, &image);
            const ref::DirectionTexels texels = {projection, static_cast<int>(image->width),
                                                 static_cast<int>(image->height), image->texels.data()};
            DirectionLookups at;
            add_directions(&at, 2003, size);
            at.sample_slopes(texture, sampler);
            size_t checked = 0;
            for (size_t i = 0; i < at.count(); ++i) {
                check_radial(at, i, kProjectionNames[projection]);
                for (size_t c = 0; c < 3; ++c) {
                    long double n[3] = {at.column[0][i], at.column[1][i], at.column[2][i]};
                    const long double rho = std::hypot(n[0], n[2]), length = std::hypot(rho, n[1]);
                    // The derivative of the longitude has no bound at a pole.
                    const double even = projection == SHD_PROJECTION_LAT_LONG ? static_cast<double>(rho / length) : 1.0;
                    const long double h = 1e-5L * even, middle = n[c];
                    double value[3];
                    for (int k = 0; k < 3; ++k) {
                        n[c] = middle + (k - 1) * h;
                        value[k] = ref::bilinear(texels, n, smooth ? ::ref::hermite_weight : ref::linear_weight);
                    }
                    const double step = static_cast<double>(h), before = (value[1] - value[0]) / step;
                    const double after = (value[2] - value[1]) / step;
                    const double unit = size / static_cast<double>(length) / even;
                    if (std::fabs(after - before) > 1e-3 * unit) continue;  // a kink
                    ++checked;
                    const double want = 0.5 * (after + before), got = double{at.slope[c][i]};
                    if (!(std::fabs(got - want) <= 1e-3 * unit)) {
                        fail_msg("%s %u [%zu] (%g, %g, %g): d/d%zu is %g, not %g", kProjectionNames[projection], size,
                                 i, double{at.column[0][i]}, double{at.column[1][i]}, double{at.column[2][i]}, c, got,
                                 want);
                    }
                }
            }
            assert_true(checked > 2 * at.count());
            shd_texture_release(texture);
        }
    }
    shd_sampler_release(sampler);
    delete image;
}

struct Case {
    const char *name;
    shd_filter filter;
    float lod;
    double along, across;  // lengths of a constant footprint of the image [texels]; 0: lod
};
const Case kCases[] = {
    {"bilinear", SHD_FILTER_BILINEAR, 0.0f, 0.0, 0.0},
    {"bicubic", SHD_FILTER_BICUBIC, 0.0f, 0.0, 0.0},
    {"bilinear_mip", SHD_FILTER_BILINEAR_MIP, 1.0f, 0.0, 0.0},
    {"trilinear", SHD_FILTER_TRILINEAR, 0.6f, 0.0, 0.0},
    {"anisotropic", SHD_FILTER_ANISOTROPIC, 0.6f, 0.0, 0.0},
    {"anisotropic, 6 probes", SHD_FILTER_ANISOTROPIC, 0.0f, 6.0, 0.8},
    {"ewa", SHD_FILTER_EWA, 0.6f, 0.0, 0.0},
    {"ewa, 4 : 1", SHD_FILTER_EWA, 0.0f, 5.0, 1.2},
};

/// A change of the direction n whose change of the point is (du, dv), perpendicular to n.
void change_of(shd_projection projection, const double *n, double du, double dv, double *change)
{
    const long double at[3] = {n[0], n[1], n[2]};
    const int least = std::fabs(n[0]) < std::fabs(n[1]) ? 0 : 1;
    long double a[3] = {}, b[3];
    a[least] = 1.0L;
    for (int c = 0; c < 3; ++c) b[c] = at[(c + 1) % 3] * a[(c + 2) % 3] - at[(c + 2) % 3] * a[(c + 1) % 3];
    for (int c = 0; c < 3; ++c) a[c] = at[(c + 1) % 3] * b[(c + 2) % 3] - at[(c + 2) % 3] * b[(c + 1) % 3];
    const ref_change p = ref_step(projection, at, a), q = ref_step(projection, at, b);
    const long double area = p.du * q.dv - p.dv * q.du;
    const long double s = (du * q.dv - dv * q.du) / area, t = (dv * p.du - du * p.dv) / area;
    for (int c = 0; c < 3; ++c) change[c] = static_cast<double>(s * a[c] + t * b[c]);
}

/// Change of the longitude, relative to the direction's: large at the poles of LAT_LONG and at -Z of the discs.
double growth_of(shd_projection projection, double x, double y, double z)
{
    const bool lat_long = projection == SHD_PROJECTION_LAT_LONG;
    if (!lat_long && !(is_disc(projection) && z < 0.0)) return 1.0;
    return std::hypot(std::hypot(x, y), z) / (lat_long ? std::hypot(x, z) : std::hypot(x, y));
}

/// Every filter against differences of its values, where they are smooth. Footprints are constant in the image. The
/// footprints of LAT_LONG depend on the latitude, so that lookups move along the parallel unless the footprint is not
/// stretched.
void test_differences(void **)
{
    DirectionImage *image = nullptr;
    for (shd_projection projection : kProjections) {
        const bool lat_long = projection == SHD_PROJECTION_LAT_LONG;
        for (uint32_t size : {16u, 9u}) {
            shd_texture *texture = noise(projection, size, &image);
            for (const Case &row : kCases) {
                shd_sampler *sampler = make_sampler(g_context, row.filter);
                DirectionLookups middles, at;
                add_directions(&middles, 700, size);
                Random random{size};
                const bool stretched = lat_long && (row.lod > 0.0f || row.filter == SHD_FILTER_EWA);
                for (size_t i = 0; i < middles.count(); ++i) {
                    const double n[3] = {double{middles.column[0][i]}, double{middles.column[1][i]},
                                         double{middles.column[2][i]}};
                    const double length = std::hypot(std::hypot(n[0], n[1]), n[2]);
                    double turn = random.unit() * 2.0 * M_PI, move[3];
                    random_direction(&random, move);
                    const double growth = growth_of(projection, n[0], n[1], n[2]);
                    const double around[3] = {n[2] / length, 0.0, -n[0] / length};
                    if (lat_long && !stretched) turn = 0.5 * M_PI;
                    for (int k = -1; k <= 1; ++k) {
                        double m[3], d[2][3] = {};
                        const double a = 1e-4 / growth * k;  // a rotation around the Y axis keeps the latitude
                        for (int c = 0; c < 3; ++c) m[c] = n[c] + a * length * move[c];
                        if (stretched) {
                            m[0] = n[0] * std::cos(a) + length * around[0] * std::sin(a), m[1] = n[1];
                            m[2] = n[2] * std::cos(a) + length * around[2] * std::sin(a);
                        }
                        if (row.along > 0.0) {
                            const double x = std::cos(turn) / image->width, y = std::sin(turn) / image->height;
                            change_of(projection, m, row.along * x, row.along * y, d[0]);
                            change_of(projection, m, -row.across * std::sin(turn) / image->width,
                                      row.across * std::cos(turn) / image->height, d[1]);
                        }
                        at.add(m, d[0], d[1]);
                    }
                }
                if (!(row.along > 0.0)) at.lod.assign(at.count(), row.lod);
                at.sample_slopes(texture, sampler);
                const std::vector<float> value = at.value;
                at.sample(texture, sampler);
                for (size_t i = 0; i < at.count(); ++i) assert_true(value[i] == at.value[i]);
                size_t checked = 0;
                for (size_t i = 0; i < at.count(); i += 3) {
                    check_radial(at, i + 1, row.name);
                    double want = 0.0, length = 0.0, n = 0.0;
                    for (size_t c = 0; c < 3; ++c) {
                        const double step = double{at.column[c][i + 2]} - double{at.column[c][i]};
                        want += step * double{at.slope[c][i + 1]}, length += step * step;
                        n += double{at.column[c][i + 1]} * double{at.column[c][i + 1]};
                    }
                    const double growth = growth_of(projection, double{at.column[0][i + 1]},
                                                    double{at.column[1][i + 1]}, double{at.column[2][i + 1]});
                    const double unit = size * growth;
                    if (row.along > 0.0 && growth > 8.0) continue;  // such footprints are not constant in floats
                    const double per_radian = std::sqrt(n / length);
                    const double before = 2.0 * per_radian * (double{value[i + 1]} - double{value[i]});
                    const double after = 2.0 * per_radian * (double{value[i + 2]} - double{value[i + 1]});
                    if (std::fabs(after - before) > 0.006 * unit) continue;  // a kink
                    ++checked;
                    const double got = want * per_radian, differences = 0.5 * (before + after);
                    if (!(std::fabs(got - differences) <= 0.006 * unit)) {
                        fail_msg("%s %u, %s [%zu] (%g, %g, %g): %g, not %g", kProjectionNames[projection], size,
                                 row.name, i / 3, double{at.column[0][i + 1]}, double{at.column[1][i + 1]},
                                 double{at.column[2][i + 1]}, got, differences);
                    }
                }
                if (checked < middles.count() * 2 / 3)
                    fail_msg("%s, %s: only %zu", kProjectionNames[projection], row.name, checked);
                shd_sampler_release(sampler);
            }
            shd_texture_release(texture);
        }
    }
    delete image;
}

/// Derivatives have the same bits on every target, with and without values, and nothing is written behind them.
void test_targets(void **)
{
    for (shd_projection projection : kProjections) {
        DirectionImage image(projection, projection == SHD_PROJECTION_LAT_LONG ? 11 : 7, 7);
        image.fill_noise(5);
        for (const Case &row : kCases) {
            std::vector<float> want;
            for (int simd = SHD_SIMD_BEST; simd < 32; ++simd) {
                if (!shd_simd_can_run(simd)) continue;
                shd_context_desc desc = shd_context_desc_default();
                desc.simd = static_cast<shd_simd>(simd);
                shd_context *context = nullptr;
                shd_assert_ok(shd_context_create(&desc, &context));
                shd_texture *texture = image.texture(context);
                shd_sampler *sampler = make_sampler(context, row.filter);
                DirectionLookups at;
                add_directions(&at, 541, 3);
                Random random{6};
                for (size_t c = 3; c < 9; ++c) {
                    for (float &x : at.column[c]) x = random.real(-0.4, 0.4);
                }
                std::vector<float> got(at.count() + 16, -7.0f);
                shd_lookups in = at.lookups();
                shd_texels out = shd_texels_default();
                out.dw[0] = shd_f32_out_column(got.data(), 0);
                shd_assert_ok(shd_texture_sample(texture, sampler, &in, &out));
                for (size_t i = at.count(); i < got.size(); ++i) assert_true(got[i] == -7.0f);
                at.sample_slopes(texture, sampler);
                for (size_t i = 0; i < at.count(); ++i) assert_true(got[i] == at.slope[2][i]);
                got.resize(at.count());
                for (size_t c = 0; c < 2; ++c) got.insert(got.end(), at.slope[c].begin(), at.slope[c].end());
                if (want.empty()) want = got;
                assert_memory_equal(want.data(), got.data(), want.size() * sizeof(float));
                shd_sampler_release(sampler);
                shd_texture_release(texture);
                shd_context_release(context);
            }
        }
    }
}

}  // namespace
}  // namespace shd::tests

int main()
{
    using namespace shd::tests;
    const CMUnitTest tests[] = {
        {"bilinear", test_bilinear, nullptr, nullptr, nullptr},
        {"hermite", test_bilinear, nullptr, nullptr, &g_context},
        {"differences", test_differences, nullptr, nullptr, nullptr},
        {"targets", test_targets, nullptr, nullptr, nullptr},
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
