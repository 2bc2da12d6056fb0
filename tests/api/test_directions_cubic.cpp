// SPDX-License-Identifier: MIT
// BICUBIC and STOCHASTIC on textures of directions: bicubic values and derivatives against a double oracle; picks whose
// mean is the filter that they estimate, with the same bits on every target and in every batch.
#include "ref/direction_filter_ref.h"
#include "support/directions.h"
#include "support/simd.h"

namespace shd::tests
{
namespace
{

shd_sampler *make_cubic(shd_context *context, shd_filter filter, shd_filter estimated, shd_cubic cubic)
{
    shd_sampler_desc desc = shd_sampler_desc_default();
    desc.filter = filter;
    desc.stochastic_filter = estimated;
    desc.cubic = cubic;
    shd_sampler *sampler = nullptr;
    shd_assert_ok(shd_sampler_create(context, &desc, &sampler));
    return sampler;
}

/// Directions anywhere, and near edges, corners and poles.
void add_directions(DirectionLookups *to, size_t count)
{
    Random random{count};
    for (size_t i = 0; i < count; ++i) {
        double n[3];
        random_direction(&random, n);
        const int c = static_cast<int>(i / 4 % 3), j = (c + 1) % 3, k = (c + 2) % 3;
        if (i % 4 == 1 || i % 4 == 2) n[j] = std::copysign(n[c] * random.in(0.7, 1.4), n[j]);
        if (i % 4 == 2) n[k] = std::copysign(n[c] * random.in(0.7, 1.4), n[k]);
        if (i % 4 == 3) n[j] *= 0.2, n[k] *= 0.2;
        to->add(n);
    }
}

void test_bicubic(void **)
{
    for (shd_projection projection : {SHD_PROJECTION_LAT_LONG, SHD_PROJECTION_CUBE, SHD_PROJECTION_OCTAHEDRAL}) {
        for (uint32_t size : {16u, 7u, 3u, 2u, 1u}) {
            const bool lat_long = projection == SHD_PROJECTION_LAT_LONG;
            DirectionImage image(projection, lat_long ? 2 * size + size % 2 : size, size);
            image.fill_noise(size);
            shd_texture *texture = image.texture(g_context);
            const ref::DirectionTexels texels = {projection, static_cast<int>(image.width),
                                                 static_cast<int>(image.height), image.texels.data()};
            for (shd_cubic cubic : {SHD_CUBIC_CATMULL_ROM, SHD_CUBIC_B_SPLINE, SHD_CUBIC_MITCHELL}) {
                shd_sampler *sampler = make_cubic(g_context, SHD_FILTER_BICUBIC, SHD_FILTER_BILINEAR, cubic);
                DirectionLookups at;
                add_directions(&at, 1501);
                at.sample_slopes(texture, sampler);
                size_t checked = 0;
                for (size_t i = 0; i < at.count(); ++i) {
                    long double n[3] = {at.column[0][i], at.column[1][i], at.column[2][i]};
                    const char *name = kProjectionNames[projection];
                    const double even = lat_long ? static_cast<double>(std::hypot(n[0], n[2])) : 1.0;
                    const double got = double{at.value[i]}, want = ref::bicubic(texels, cubic, n);
                    // The point moves by 1e-6 radians; where it crosses an edge of another face, texels may change.
                    if (!(std::fabs(got - want) <= 2e-5 * size / even)) {
                        fail_msg("%s %u [%zu] (%g, %g, %g): %g, not %g", name, size, i, double{at.column[0][i]},
                                 double{at.column[1][i]}, double{at.column[2][i]}, got, want);
                    }
                    for (size_t c = 0; c < 3; ++c) {
                        const long double h = 1e-5L * even, middle = n[c];
                        double value[3];
                        for (int k = 0; k < 3; ++k) {
                            n[c] = middle + (k - 1) * h;
                            value[k] = ref::bicubic(texels, cubic, n);
                        }
                        n[c] = middle;
                        const double before = (value[1] - value[0]) / static_cast<double>(h);
                        const double after = (value[2] - value[1]) / static_cast<double>(h);
                        if (std::fabs(after - before) > 2e-3 * size * (size + 1) / even) continue;  // an edge
                        ++checked;
                        shd_assert_close(name, i, double{at.slope[c][i]}, 0.5 * (before + after),
                                         2e-3 * (size + 1) / even, 0.0);
                    }
                }
                assert_true(checked > 2 * at.count());
                shd_sampler_release(sampler);
            }
            shd_texture_release(texture);
        }
    }
}

struct Estimate {
    const char *name;
    shd_filter filter;
    shd_stochastic stochastic;
    float lod;
    double ratio;
};
const Estimate kEstimates[] = {
    {"bilinear", SHD_FILTER_BILINEAR, SHD_STOCHASTIC_TEXEL, 0.0f, 1.0},
    {"bicubic", SHD_FILTER_BICUBIC, SHD_STOCHASTIC_TEXEL, 0.0f, 1.0},
    {"trilinear", SHD_FILTER_TRILINEAR, SHD_STOCHASTIC_TEXEL, 1.3f, 1.0},
    {"trilinear quads", SHD_FILTER_TRILINEAR, SHD_STOCHASTIC_QUAD, 1.3f, 1.0},
    {"anisotropic", SHD_FILTER_ANISOTROPIC, SHD_STOCHASTIC_TEXEL, 0.0f, 5.0},
    {"anisotropic quads", SHD_FILTER_ANISOTROPIC, SHD_STOCHASTIC_QUAD, 0.0f, 5.0},
    {"ewa", SHD_FILTER_EWA, SHD_STOCHASTIC_TEXEL, 0.0f, 4.0},
};
constexpr size_t kPicks = 2000;

/// Each direction `repeats` times, with footprints of a ratio, and random bits.
struct Picks {
    DirectionLookups at;
    std::vector<uint32_t> random;

    Picks(size_t directions, size_t repeats, const Estimate &row)
    {
        DirectionLookups some;
        add_directions(&some, directions);
        Random bits{5};
        for (size_t i = 0; i < directions; ++i) {
            const double n[3] = {double{some.column[0][i]}, double{some.column[1][i]}, double{some.column[2][i]}};
            double dx[3], dy[3];
            for (int c = 0; c < 3; ++c) dx[c] = 0.08 * row.ratio * (c == 0), dy[c] = 0.08 * (c == 1);
            for (size_t k = 0; k < repeats; ++k) {
                at.add(n, dx, dy);
                random.push_back(static_cast<uint32_t>(bits.bits()));
            }
        }
        if (row.ratio == 1.0) at.lod.assign(at.count(), row.lod);
    }
    std::vector<float> sample(const shd_texture *texture, const shd_sampler *sampler, size_t first, size_t count) const
    {
        std::vector<float> value(count);
        shd_lookups in = at.lookups();
        shd_f32_in *const columns[10] = {&in.u,    &in.v,    &in.w,    &in.dudx, &in.dvdx,
                                         &in.dwdx, &in.dudy, &in.dvdy, &in.dwdy, &in.lod};
        for (shd_f32_in *column : columns) {
            if (column->data) column->data += first;
        }
        in.count = count;
        in.random.data = random.data() + first;
        shd_texels out = shd_texels_default();
        out.channel[0] = shd_f32_out_column(value.data(), 0);
        shd_assert_ok(shd_texture_sample(texture, sampler, &in, &out));
        return value;
    }
};

shd_sampler *estimator(shd_context *context, const Estimate &row)
{
    shd_sampler_desc desc = shd_sampler_desc_default();
    desc.filter = SHD_FILTER_STOCHASTIC;
    desc.stochastic_filter = row.filter;
    desc.stochastic = row.stochastic;
    desc.cubic = SHD_CUBIC_B_SPLINE;
    shd_sampler *sampler = nullptr;
    shd_assert_ok(shd_sampler_create(context, &desc, &sampler));
    return sampler;
}

/// The mean of the picks is the value of the filter, within five standard errors.
void test_mean(void **)
{
    for (shd_projection projection : kProjections) {
        DirectionImage image(projection, projection == SHD_PROJECTION_LAT_LONG ? 15 : 8, 8);
        image.fill_noise(3);
        shd_texture *texture = image.texture(g_context);
        for (const Estimate &row : kEstimates) {
            constexpr size_t kDirections = 60;
            const Picks picks(kDirections, kPicks, row), once(kDirections, 1, row);
            shd_sampler *random = estimator(g_context, row);
            shd_sampler *filter = make_cubic(g_context, row.filter, SHD_FILTER_BILINEAR, SHD_CUBIC_B_SPLINE);
            const std::vector<float> got = picks.sample(texture, random, 0, picks.at.count());
            const std::vector<float> want = once.sample(texture, filter, 0, kDirections);
            for (size_t i = 0; i < kDirections; ++i) {
                double sum = 0.0, squares = 0.0;
                for (size_t k = 0; k < kPicks; ++k) {
                    const double value = double{got[i * kPicks + k]};
                    sum += value, squares += value * value;
                }
                const double mean = sum / kPicks, spread = std::sqrt(std::fmax(squares / kPicks - mean * mean, 0.0));
                const double bound = 5.0 * spread / std::sqrt(double{kPicks}) + 1e-3;
                if (!(std::fabs(mean - double{want[i]}) <= bound)) {
                    fail_msg("%s %s [%zu] (%g, %g, %g): mean %g, not %g +- %g", kProjectionNames[projection], row.name,
                             i, double{once.at.column[0][i]}, double{once.at.column[1][i]},
                             double{once.at.column[2][i]}, mean, double{want[i]}, bound);
                }
            }
            shd_sampler_release(filter);
            shd_sampler_release(random);
        }
        shd_texture_release(texture);
    }
}

/// A pick depends on its lookup alone: not on the target, and not on the lookups beside it.
void test_alone(void **)
{
    for (shd_projection projection : kProjections) {
        DirectionImage image(projection, projection == SHD_PROJECTION_LAT_LONG ? 11 : 7, 7);
        image.fill_noise(5);
        for (const Estimate &row : kEstimates) {
            const Picks picks(401, 1, row);
            std::vector<float> want;
            for (int simd = SHD_SIMD_BEST; simd < 32; ++simd) {
                if (!shd_simd_can_run(simd)) continue;
                shd_context_desc desc = shd_context_desc_default();
                desc.simd = static_cast<shd_simd>(simd);
                shd_context *context = nullptr;
                shd_assert_ok(shd_context_create(&desc, &context));
                shd_texture *texture = image.texture(context);
                shd_sampler *sampler = estimator(context, row);
                const std::vector<float> got = picks.sample(texture, sampler, 0, picks.at.count());
                if (want.empty()) want = got;
                assert_memory_equal(want.data(), got.data(), want.size() * sizeof(float));
                for (size_t i = 0; i < got.size(); i += 7) {
                    const size_t count = std::min<size_t>(1 + i % 5, got.size() - i);
                    const std::vector<float> few = picks.sample(texture, sampler, i, count);
                    assert_memory_equal(&want[i], few.data(), count * sizeof(float));
                }
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
        {"bicubic", test_bicubic, nullptr, nullptr, nullptr},
        {"mean", test_mean, nullptr, nullptr, nullptr},
        {"alone", test_alone, nullptr, nullptr, nullptr},
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
