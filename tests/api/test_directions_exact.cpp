// SPDX-License-Identifier: MIT
// EXACT on textures of directions: footprints against many samples, inside a face against a plane, points against
// BILINEAR, constants, hostile inputs, texels that are not finite, and the same bits on every target and in every
// batch.
#include "ref/direction_exact_ref.h"
#include "support/directions.h"
#include "support/simd.h"

namespace shd::tests
{
namespace
{

shd_sampler *make_exact(shd_context *context, float tolerance, float bias = 0.0f)
{
    shd_sampler_desc desc = shd_sampler_desc_default();
    desc.filter = SHD_FILTER_EXACT;
    desc.tolerance = tolerance;
    desc.lod_bias = bias;
    shd_sampler *sampler = nullptr;
    shd_assert_ok(shd_sampler_create(context, &desc, &sampler));
    return sampler;
}

DirectionImage noise(shd_projection projection, uint32_t size)
{
    const bool lat_long = projection == SHD_PROJECTION_LAT_LONG;
    DirectionImage image(projection, lat_long ? 2 * size - size % 2 : size, size);
    image.fill_noise(size);
    return image;
}

ref::DirectionTexels texels_of(const DirectionImage &image)
{
    return {image.projection, static_cast<int>(image.width), static_cast<int>(image.height), image.texels.data()};
}

/// Directions anywhere and near edges, corners and poles, with changes of 2^low to 2^high, some of them parallel.
void add_footprints(DirectionLookups *to, size_t count, double low, double high)
{
    Random random{count};
    for (size_t i = 0; i < count; ++i) {
        double n[3], dx[3], dy[3];
        random_direction(&random, n);
        const int c = static_cast<int>(i / 4 % 3), j = (c + 1) % 3, k = (c + 2) % 3;
        if (i % 4 == 1 || i % 4 == 2) n[j] = std::copysign(n[c] * random.in(0.7, 1.4), n[j]);
        if (i % 4 == 2) n[k] = std::copysign(n[c] * random.in(0.7, 1.4), n[k]);
        if (i % 4 == 3) n[j] *= 0.2, n[k] *= 0.2;
        const double length = std::exp2(random.in(low, high)), other = std::exp2(random.in(low, high));
        random_direction(&random, dx);
        random_direction(&random, dy);
        for (int axis = 0; axis < 3; ++axis) {
            dx[axis] *= length;
            dy[axis] = i % 5 == 4 ? dx[axis] / 2 : dy[axis] * other;
        }
        to->add(n, dx, dy);
    }
}

ref::DirectionFootprint footprint_of(const ref::DirectionTexels &image, const DirectionLookups &at, size_t i)
{
    long double n[3][3];
    for (int c = 0; c < 9; ++c) n[c / 3][c % 3] = at.column[c][i];
    if (at.lod.empty()) return ref::direction_footprint(image.projection, n[0], n[1], n[2]);
    return ref::square_footprint(image, n[0], std::exp2(double{at.lod[i]}));
}

/// Compares lookups with the oracle on an image. The error is mostly in the samples.
void compare(const ref::DirectionTexels &image, const DirectionLookups &at, const char *what)
{
    double worst = 0.0;
    for (size_t i = 0; i < at.count(); i += SHD_ORACLE_STRIDE) {
        const double want = ref::direction_average(image, footprint_of(image, at, i), 160);
        const double error = std::fabs(double{at.value[i]} - want);
        worst = std::fmax(worst, error);
        if (!(error <= 4e-4)) {
            fail_msg("%s %s of %d texels [%zu] (%g, %g, %g): %.7g instead of %.7g", kProjectionNames[image.projection],
                     what, image.width, i, double{at.column[0][i]}, double{at.column[1][i]}, double{at.column[2][i]},
                     double{at.value[i]}, want);
        }
    }
    print_message("%s %s of %d texels: %.2g\n", kProjectionNames[image.projection], what, image.width, worst);
}

void test_footprints(void **)
{
    shd_sampler *sampler = make_exact(g_context, 0x1p-6f);
    for (shd_projection projection : kProjections) {
        for (uint32_t size : {16u, 7u, 2u, 1u}) {
            const DirectionImage image = noise(projection, size);
            shd_texture *texture = image.texture(g_context);
            DirectionLookups at;
            add_footprints(&at, 48, -std::log2(size) - 1.0, 1.0);
            at.sample(texture, sampler);
            assert_int_equal(0, at.nonfinite);
            compare(texels_of(image), at, "footprints");
            for (size_t i = 0; i < at.count(); ++i) at.lod.push_back(static_cast<float>(i % 24) / 6.0f - 1.0f);
            at.sample(texture, sampler);
            compare(texels_of(image), at, "squares");
            shd_texture_release(texture);
        }
    }
    shd_sampler_release(sampler);
}

/// Footprints of more cells than the tolerance allows use the next level.
void test_level(void **)
{
    shd_sampler *sampler = make_exact(g_context, 0.125f);
    for (shd_projection projection : kProjections) {
        const DirectionImage image = noise(projection, 64);
        DirectionImage half(projection, image.width / 2, 32);
        for (size_t i = 0; i < half.texels.size(); ++i) {
            const size_t x = i % half.width, row = i / half.width;
            const float *from = &image.texels[(2 * row * half.width + x) * 2];
            half.texels[i] = (from[0] + from[1] + from[image.width] + from[image.width + 1]) / 4.0f;
        }
        shd_texture *texture = image.texture(g_context);
        DirectionLookups at;
        Random random{5};
        for (int i = 0; i < 40; ++i) {
            double n[3];
            random_direction(&random, n);
            if (projection == SHD_PROJECTION_LAT_LONG) n[1] *= 0.3;  // squares at the poles are wider
            at.add(n);
            at.lod.push_back(5.0f);  // 32 texels: 1024 cells and more on level 0
        }
        at.sample(texture, sampler);
        for (float &lod : at.lod) lod = 4.0f;
        compare(texels_of(half), at, "level");
        shd_texture_release(texture);
    }
    shd_sampler_release(sampler);
}

/// A texture of one image without a projection.
shd_texture *plane_of(const DirectionImage &image, uint32_t face)
{
    DirectionImage plane(SHD_PROJECTION_NONE, image.width, image.height);
    const size_t size = plane.texels.size();
    plane.texels.assign(image.texels.begin() + face * size, image.texels.begin() + (face + 1) * size);
    return plane.texture(g_context);
}

/// A footprint inside a face has the bits of the face as a 2D texture. All points and changes are floats.
void test_inside(void **)
{
    shd_sampler *sampler = make_exact(g_context, 0x1p-6f);
    for (shd_projection projection : {SHD_PROJECTION_CUBE, SHD_PROJECTION_OCTAHEDRAL}) {
        const bool cube = projection == SHD_PROJECTION_CUBE;
        const DirectionImage image = noise(projection, 37);
        shd_texture *texture = image.texture(g_context);
        for (uint32_t face = 0; face < (cube ? 6 : 1); ++face) {
            shd_texture *plane = plane_of(image, face);
            DirectionLookups at, flat;
            Random random{face};
            for (int i = 0; i < 200; ++i) {
                // On the cube (1, s, t); in front of the octahedron (x, y, 1) with |x| + |y| = 1.
                const double s = random.whole(-32, 32) / 64.0,
                             t = cube ? random.whole(-32, 32) / 64.0 : 1.0 - std::fabs(s);
                double d[4], n[9] = {};
                for (double &x : d) x = random.whole(-64, 64) / 256.0;
                const int *row = ref_cube_table[cube ? face : 4];
                const double parts[3][3] = {{1.0, s, t}, {0.0, d[0], d[1]}, {0.0, d[2], d[3]}};
                for (int k = 0; k < 9; ++k) {
                    const int axis = row[k % 3];
                    n[k / 3 * 3 + std::abs(axis) - 1] = axis > 0 ? parts[k / 3][k % 3] : -parts[k / 3][k % 3];
                }
                at.add(n, n + 3, n + 6);
                long double in[3][3];
                for (int k = 0; k < 9; ++k) in[k / 3][k % 3] = n[k];
                const ref_place place = ref_project(projection, in[0]);
                const ref_change dx = ref_step(projection, in[0], in[1]), dy = ref_step(projection, in[0], in[2]);
                const double point[3] = {static_cast<double>(place.u), static_cast<double>(place.v), 0.0};
                const double x[3] = {static_cast<double>(dx.du), static_cast<double>(dx.dv), 0.0};
                const double y[3] = {static_cast<double>(dy.du), static_cast<double>(dy.dv), 0.0};
                flat.add(point, x, y);
            }
            at.sample(texture, sampler);
            flat.sample(plane, sampler);
            for (size_t i = 0; i < at.count(); ++i) {
                if (memcmp(&at.value[i], &flat.value[i], sizeof(float)) != 0)
                    fail_msg("%s face %u [%zu]: %.9g instead of %.9g", kProjectionNames[projection], face, i,
                             double{at.value[i]}, double{flat.value[i]});
            }
            shd_texture_release(plane);
        }
        shd_texture_release(texture);
    }
    shd_sampler_release(sampler);
}

/// Directions and changes of all bad values; some are small footprints.
void add_hostile(DirectionLookups *to)
{
    const double special[] = {0.0, -0.0, 1.0, -1.0, 1e-30, 3e38, 1e-44, NAN, INFINITY, -INFINITY};
    for (size_t i = 0; i < 1000; ++i) {
        double value[9];
        for (size_t c = 0; c < 9; ++c)
            value[c] = special[(i / (c % 3 == 0 ? 1 : c % 3 == 1 ? 10 : 100) + c * i / 3) % 10];
        const double usual[3] = {0.01 * static_cast<double>(i % 40), 0.02, -0.03};
        to->add(value, i % 3 ? value + 3 : usual, i % 4 ? value + 6 : usual);
    }
}

/// Any input gives a value between the smallest and the largest texel, a constant texture gives its value, and inputs
/// count as in other filters.
void test_hostile(void **)
{
    DirectionLookups at;
    add_hostile(&at);
    shd_sampler *trilinear = make_sampler(g_context, SHD_FILTER_TRILINEAR);
    for (shd_projection projection : kProjections) {
        for (uint32_t size : {9u, 1u}) {
            DirectionImage image = noise(projection, size);
            for (bool constant : {false, true}) {
                for (float &texel : image.texels) texel = constant ? 0.3f : texel;
                shd_texture *texture = image.texture(g_context);
                for (float bias : {0.0f, -14.0f, 9.0f}) {
                    shd_sampler *sampler = make_exact(g_context, 1.0f, bias);
                    for (bool lod : {false, true}) {
                        at.lod.clear();
                        for (size_t i = 0; lod && i < at.count(); ++i) at.lod.push_back(at.column[3][i]);
                        at.sample(texture, trilinear);
                        const size_t nonfinite = at.nonfinite;
                        at.sample(texture, sampler);
                        assert_int_equal(nonfinite, at.nonfinite);
                        for (float value : at.value)
                            assert_true(constant ? value == 0.3f : value >= 0.0f && value <= 1.0f);
                    }
                    shd_sampler_release(sampler);
                }
                shd_texture_release(texture);
            }
        }
    }
    shd_sampler_release(trilinear);
}

/// Lookups without a footprint have the bits of BILINEAR.
void test_points(void **)
{
    shd_sampler *bilinear = make_sampler(g_context, SHD_FILTER_BILINEAR), *exact = make_exact(g_context, 0x1p-6f);
    for (shd_projection projection : kProjections) {
        const DirectionImage image = noise(projection, 9);
        shd_texture *texture = image.texture(g_context);
        DirectionLookups at;
        add_footprints(&at, 400, -60.0, -50.0);
        const std::vector<float> want = at.sample(texture, bilinear);
        const std::vector<float> short_sides = at.sample(texture, exact);
        at.lod.assign(at.count(), -INFINITY);
        at.sample(texture, exact);
        for (size_t i = 0; i < at.count(); ++i) {
            assert_true(at.value[i] == want[i]);
            // At a pole, and at -Z of a disc, sides of any length of the direction are long in the image.
            assert_true(short_sides[i] == want[i]);
        }
        shd_texture_release(texture);
    }
    shd_sampler_release(bilinear);
    shd_sampler_release(exact);
}

/// NaN texels of other faces have no effect on a footprint that ends half a texel before the edge; a footprint over the
/// edge has their value.
void test_nan(void **)
{
    DirectionImage image = noise(SHD_PROJECTION_CUBE, 8);
    for (size_t i = 64; i < image.texels.size(); ++i) image.texels[i] = NAN;
    shd_texture *texture = image.texture(g_context);
    shd_sampler *sampler = make_exact(g_context, 0x1p-6f);
    DirectionLookups at;
    const double n[3] = {1.0, 0.0, 0.0}, to_centres[2][3] = {{0.0, 1.75, 0.0}, {0.0, 0.0, 1.75}};
    const double beyond[3] = {0.0, 0.0, 1.76};
    at.add(n, to_centres[0], to_centres[1]);
    at.add(n, to_centres[0], beyond);
    at.sample(texture, sampler);
    assert_true(at.value[0] >= 0.0f && at.value[0] <= 1.0f);
    assert_true(std::isnan(at.value[1]));
    shd_sampler_release(sampler);
    shd_texture_release(texture);
}

/// The same bits on every target, in batches of any size.
void test_alone(void **)
{
    for (shd_projection projection : kProjections) {
        const DirectionImage image = noise(projection, 13);
        DirectionLookups at;
        add_footprints(&at, 101, -12.0, 2.0);
        for (int c = 0; c < 9; ++c) at.column[c][static_cast<size_t>(7 * c)] = c % 2 ? INFINITY : NAN;
        std::vector<float> want;
        for (int simd = SHD_SIMD_BEST; simd < 32; ++simd) {
            if (!shd_simd_can_run(simd)) continue;
            shd_context_desc desc = shd_context_desc_default();
            desc.simd = static_cast<shd_simd>(simd);
            shd_context *context = nullptr;
            shd_assert_ok(shd_context_create(&desc, &context));
            shd_texture *texture = image.texture(context);
            shd_sampler *sampler = make_exact(context, 0.125f);
            at.sample(texture, sampler);
            if (want.empty()) want = at.value;
            assert_memory_equal(want.data(), at.value.data(), want.size() * sizeof(float));
            for (size_t i = 0, count = 1; i + count <= at.count(); i += count, count = count % 7 + 1) {
                DirectionLookups few;
                for (int c = 0; c < 9; ++c) few.column[c].assign(&at.column[c][i], &at.column[c][i] + count);
                few.sample(texture, sampler);
                assert_memory_equal(&want[i], few.value.data(), count * sizeof(float));
            }
            shd_sampler_release(sampler);
            shd_texture_release(texture);
            shd_context_release(context);
        }
    }
}

}  // namespace
}  // namespace shd::tests

int main()
{
    using namespace shd::tests;
    const CMUnitTest tests[] = {
        {"footprints", test_footprints, nullptr, nullptr, nullptr},
        {"level", test_level, nullptr, nullptr, nullptr},
        {"inside", test_inside, nullptr, nullptr, nullptr},
        {"hostile", test_hostile, nullptr, nullptr, nullptr},
        {"points", test_points, nullptr, nullptr, nullptr},
        {"nan", test_nan, nullptr, nullptr, nullptr},
        {"alone", test_alone, nullptr, nullptr, nullptr},
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
