// SPDX-License-Identifier: MIT
// Levels of detail of directions: those of the exact derivatives of the projection, of any length, for every filter and
// profile on every SIMD target.
#include <memory>

#include "ref/ewa_ref.h"
#include "ref/least_error_ref.h"
#include "ref/profile_ref.h"
#include "support/directions.h"
#include "support/level_texture.h"
#include "support/simd.h"

namespace shd::tests
{
namespace
{

constexpr shd_profile kProfiles[] = {SHD_PROFILE_LEAST_ERROR, SHD_PROFILE_VULKAN, SHD_PROFILE_D3D11, SHD_PROFILE_OIIO,
                                     SHD_PROFILE_EXACT};
constexpr size_t kPadding = 16;

/// A context of every SIMD target.
struct Targets {
    std::vector<shd_context *> contexts;

    Targets()
    {
        for (int simd = SHD_SIMD_BEST; simd < 32; ++simd) {
            if (!shd_simd_can_run(simd)) continue;
            shd_context_desc desc = shd_context_desc_default();
            desc.simd = static_cast<shd_simd>(simd);
            contexts.push_back(nullptr);
            shd_assert_ok(shd_context_create(&desc, &contexts.back()));
        }
    }
    ~Targets()
    {
        for (shd_context *context : contexts) shd_context_release(context);
    }
};

ref::Image image_of(const LevelTexture &texture, const shd_sampler_desc &sampler)
{
    return {SHD_FORMAT_R32F, texture.levels.data(), static_cast<int>(texture.levels.size()), &sampler};
}

/// Values of the first `count` lookups; nothing is written behind them.
std::vector<float> values_of(shd_context *context, const LevelTexture &texture, const shd_sampler_desc &desc,
                             const DirectionLookups &at, size_t count)
{
    shd_sampler *sampler = nullptr;
    shd_assert_ok(shd_sampler_create(context, &desc, &sampler));
    std::vector<float> value(count + kPadding, -7.0f);
    shd_lookups in = at.lookups();
    in.count = count;
    shd_texels out = shd_texels_default();
    out.channel[0] = shd_f32_out_column(value.data(), 0);
    shd_assert_ok(shd_texture_sample(texture.texture, sampler, &in, &out));
    shd_sampler_release(sampler);
    for (size_t i = count; i < value.size(); ++i) assert_true(value[i] == -7.0f);
    value.resize(count);
    return value;
}

/// A footprint on the image, on the equator for LAT_LONG, and the error of its derivatives in floats.
struct Footprint {
    ref::Jacobian j;
    double error;
};

Footprint footprint_of(shd_projection projection, const DirectionLookups &at, size_t i)
{
    long double n[3], d[2][3], square = 0.0L, longest = 0.0L;
    for (size_t c = 0; c < 3; ++c) {
        n[c] = at.column[c][i];
        square += n[c] * n[c];
        for (size_t axis = 0; axis < 2; ++axis) {
            const float given = at.column[3 + 3 * axis + c][i];
            d[axis][c] = std::isnan(given) ? 0.0L : static_cast<long double>(given);
        }
    }
    for (const auto &step : d) longest = std::max(longest, std::hypot(std::hypot(step[0], step[1]), step[2]));
    const long double length = std::sqrt(square), rho = std::hypot(n[0], n[1]);
    const bool lat_long = projection == SHD_PROJECTION_LAT_LONG;
    const long double even = lat_long ? std::hypot(n[0], n[2]) / length : 1.0L;
    const ref_change x = ref_step(projection, n, d[0]), y = ref_step(projection, n, d[1]);
    const long double growth = is_disc(projection) && n[2] < 0.0L ? length / rho : 1.0L;
    return {{static_cast<double>(x.du * even), static_cast<double>(x.dv), static_cast<double>(y.du * even),
             static_cast<double>(y.dv)},
            static_cast<double>(1e-6L * growth * longest / length)};
}

bool is_isotropic(shd_filter filter) { return filter != SHD_FILTER_ANISOTROPIC && filter != SHD_FILTER_EWA; }

/// Level of detail before bias and clamps.
double lambda_of(const ref::Image &image, const ref::Jacobian &j)
{
    const shd_sampler_desc &s = *image.sampler;
    const auto w = static_cast<double>(image.levels[0].width), h = static_cast<double>(image.levels[0].height);
    const auto cap = static_cast<double>(s.max_anisotropy);
    const ref::Ellipse e = ref::ellipse(ref::Jacobian{j.ux * w, j.vx * h, j.uy * w, j.vy * h});
    const double least = std::log2(e.a / ref::aspect(e, cap));
    if (s.filter == SHD_FILTER_EWA) return least;
    const bool isotropic = is_isotropic(s.filter);
    switch (s.profile) {
        case SHD_PROFILE_LEAST_ERROR:
            return isotropic ? ref::least_error_lambda(j, w, h) : ref::least_error_probe_lambda(e, cap);
        case SHD_PROFILE_EXACT: return isotropic ? ref::lambda(j.ux, j.vx, j.uy, j.vy, w, h) : least;
        case SHD_PROFILE_D3D11:  // the steps of the specification cancel where the axes differ by more than 1e8
            if (!isotropic) return least;
            break;
        default: break;
    }
    const bool one_level = s.filter == SHD_FILTER_NEAREST_MIP || s.filter == SHD_FILTER_BILINEAR_MIP;
    return isotropic ? ref::profile_lambda(image, j, one_level) : ref::profile_line(image, j, 0.0).lambda;
}

/// The value of a lookup whose level of detail is lambda.
double level_at(const ref::Image &image, double lambda)
{
    const shd_sampler_desc &s = *image.sampler;
    switch (s.filter) {
        case SHD_FILTER_NEAREST_MIP:
        case SHD_FILTER_BILINEAR_MIP: return ref::profile_level(image, lambda);
        case SHD_FILTER_EWA: return std::floor(ref::clamp_lod(image, lambda));
        default: break;
    }
    const bool rounded = s.profile == SHD_PROFILE_VULKAN || s.profile == SHD_PROFILE_D3D11;
    return rounded ? ref::profile_lod(image, lambda) : ref::clamp_lod(image, lambda);
}

/// Legal values of a lookup: levels grow with the footprint.
struct Interval {
    double low, high;
};

Interval levels_of(const ref::Image &image, const Footprint &f)
{
    const auto w = static_cast<double>(image.levels[0].width), h = static_cast<double>(image.levels[0].height);
    const bool texture_units = image.sampler->profile == SHD_PROFILE_OIIO && image.sampler->filter != SHD_FILTER_EWA;
    const ref::Jacobian &j = f.j;
    const ref::Ellipse e = texture_units ? ref::ellipse(j) : ref::ellipse({j.ux * w, j.vx * h, j.uy * w, j.vy * h});
    const double size = is_isotropic(image.sampler->filter)
                            ? e.a
                            : std::fmax(e.b, e.a / static_cast<double>(image.sampler->max_anisotropy));
    const double error = f.error * (texture_units ? 1.0 : std::fmax(w, h));
    const double part = size > 0.0 ? std::fmin(error / size + 1e-5, 1.0) : 1.0;
    const auto scaled = [&](double x) { return ref::Jacobian{x * j.ux, x * j.vx, x * j.uy, x * j.vy}; };
    return {level_at(image, lambda_of(image, scaled(1.0 - part))) - 1e-5,
            level_at(image, lambda_of(image, scaled(1.0 + part))) + 1e-5};
}

/// Footprints from a part of a texel to more than the sphere, and far longer ones; some components are NaN.
DirectionLookups random_lookups(size_t count)
{
    DirectionLookups at;
    Random random{31};
    for (size_t i = 0; i < count; ++i) {
        double n[3], d[2][3];
        random_direction(&random, n);
        const double length = i % 3 ? 1.0 : std::exp2(random.whole(-60, 60));
        const bool is_long = i % 5 == 4;
        const double size = std::exp2(is_long ? random.in(20.0, 67.0) : random.in(-9.0, 6.0));
        const double ratio = i % 2 ? 1.0 : std::exp2(random.in(-7.0, 0.0));
        for (int c = 0; c < 6; ++c) d[c / 3][c % 3] = random.in(-1.0, 1.0) * size * length * (c < 3 ? 1.0 : ratio);
        for (double &x : n) x *= length;
        if (i % 20 == 9) d[0][i % 3] = 1e30 * std::fmin(length, 1.0);  // a long change and a short one
        if (i % 20 == 9) std::fill(d[1], d[1] + 3, 1e-3 * length);
        if (i % 20 == 11) std::fill(d[1], d[1] + 3, 0.0);
        if (i % 20 == 13) d[0][i % 3] = NAN, d[1][i / 3 % 3] = NAN;
        at.add(n, d[0], d[1]);
    }
    return at;
}

void check_levels(shd_projection projection, const std::vector<std::unique_ptr<LevelTexture>> &textures,
                  const Targets &targets, const DirectionLookups &at, const shd_sampler_desc &desc)
{
    const ref::Image image = image_of(*textures[0], desc);
    std::vector<float> first;
    for (size_t t = 0; t < textures.size(); ++t) {
        const std::vector<float> value = values_of(targets.contexts[t], *textures[t], desc, at, at.count());
        if (t == 0) first = value;
        for (size_t i = 0; i < value.size(); ++i) assert_true(value[i] == first[i]);
        for (size_t count = 1; count < 40; count += 1 + count / 20) {
            const std::vector<float> part = values_of(targets.contexts[t], *textures[t], desc, at, count);
            for (size_t i = 0; i < count; ++i) assert_true(part[i] == first[i]);
        }
    }
    for (size_t i = 0; i < first.size(); i += SHD_ORACLE_STRIDE) {
        const Footprint f = footprint_of(projection, at, i);
        const Interval want = levels_of(image, f);
        if (double{first[i]} >= want.low && double{first[i]} <= want.high) continue;
        fail_msg("%s, filter %d, profile %d, bias %g [%zu] (%g %g; %g %g): level %g is not in %g..%g",
                 kProjectionNames[projection], desc.filter, desc.profile, double{desc.lod_bias}, i, f.j.ux, f.j.vx,
                 f.j.uy, f.j.vy, double{first[i]}, want.low, want.high);
    }
}

constexpr shd_filter kLevelFilters[] = {SHD_FILTER_NEAREST_MIP, SHD_FILTER_BILINEAR_MIP, SHD_FILTER_TRILINEAR,
                                        SHD_FILTER_ANISOTROPIC, SHD_FILTER_EWA};

/// Levels against the exact Jacobian of the projection. `state` is the projection.
void test_levels(void **state)
{
    const auto projection = *static_cast<const shd_projection *>(*state);
    const Targets targets;
    const DirectionLookups at = random_lookups(1500);
    std::vector<std::unique_ptr<LevelTexture>> textures;
    for (shd_context *context : targets.contexts) {
        textures.push_back(std::make_unique<LevelTexture>(context, projection, 37));
    }
    shd_sampler_desc desc = shd_sampler_desc_default();
    for (shd_profile profile : kProfiles) {
        for (shd_filter filter : kLevelFilters) {
            for (float bias : {0.0f, -2.0f}) {
                desc.filter = filter, desc.profile = profile, desc.lod_bias = bias;
                check_levels(projection, textures, targets, at, desc);
            }
        }
    }
}

/// One infinite derivative of six gives the coarsest level of an 8 x 8 image, for any values of the other five. A width
/// of 0 removes it. `state` is the projection.
void test_infinite(void **state)
{
    const auto projection = *static_cast<const shd_projection *>(*state);
    const Targets targets;
    DirectionLookups at;
    Random random{32};
    for (size_t i = 0; i < 360; ++i) {
        double n[3], d[6];
        random_direction(&random, n);
        if (i % 4 == 3) n[0] = n[1] = 0.0, n[2] = i % 8 == 3 ? 1.0 : -1.0;  // the change may be along the direction
        for (double &x : d) x = i % 2 ? 0.0 : random.in(-1e-3, 1e-3);
        if (i % 3 == 1) d[(i + 1) % 6] = NAN;
        if (i % 3 == 2) d[(i + 5) % 6] = -3e38;
        d[i / 2 % 6] = i % 7 ? HUGE_VAL : -HUGE_VAL;
        at.add(n, d, d + 3);
    }
    shd_sampler_desc desc = shd_sampler_desc_default();
    for (shd_context *context : targets.contexts) {
        const LevelTexture texture(context, projection, 8);
        const auto last = static_cast<float>(texture.levels.size() - 1);
        for (shd_profile profile : kProfiles) {
            for (shd_filter filter : kLevelFilters) {
                desc.profile = profile, desc.filter = filter;
                desc.width_x = desc.width_y = 1.0f;
                for (float value : values_of(context, texture, desc, at, at.count())) assert_true(value == last);
                desc.width_x = desc.width_y = 0.0f;
                for (float value : values_of(context, texture, desc, at, at.count())) assert_true(value == 0.0f);
            }
        }
    }
}

/// shd_texture_query_levels() has the levels of lookups.
void test_query(void **)
{
    const Targets targets;
    const DirectionLookups at = random_lookups(500);
    shd_sampler_desc desc = shd_sampler_desc_default();
    shd_sampler *sampler = nullptr;
    shd_assert_ok(shd_sampler_create(targets.contexts[0], &desc, &sampler));
    for (shd_projection projection : kProjections) {
        const LevelTexture texture(targets.contexts[0], projection, 37);
        std::vector<float> lod(at.count());
        const shd_lookups in = at.lookups();
        shd_levels levels = shd_levels_default();
        levels.lod = shd_f32_out_column(lod.data(), 0);
        shd_assert_ok(shd_texture_query_levels(texture.texture, sampler, &in, &levels));
        const std::vector<float> value = values_of(targets.contexts[0], texture, desc, at, at.count());
        for (size_t i = 0; i < at.count(); ++i) {
            shd_assert_close("lod", i, double{value[i]}, std::fmax(double{lod[i]}, 0.0), 1e-6, 0.0);
        }
    }
    shd_sampler_release(sampler);
}

}  // namespace
}  // namespace shd::tests

int main()
{
    using namespace shd::tests;
    static const char *const levels[] = {
        "", "levels/lat_long", "levels/mirror_ball", "levels/angular", "levels/cube", "levels/octahedral"};
    static const char *const infinite[] = {
        "", "infinite/lat_long", "infinite/mirror_ball", "infinite/angular", "infinite/cube", "infinite/octahedral"};
    std::vector<CMUnitTest> tests;
    for (const shd_projection &projection : kProjections) {
        void *const state = const_cast<shd_projection *>(&projection);
        tests.push_back({levels[projection], test_levels, nullptr, nullptr, state});
        tests.push_back({infinite[projection], test_infinite, nullptr, nullptr, state});
    }
    tests.push_back({"query", test_query, nullptr, nullptr, nullptr});
    return _cmocka_run_group_tests("api.directions_levels", tests.data(), tests.size(), nullptr, nullptr);
}
