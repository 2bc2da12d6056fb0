// SPDX-License-Identifier: MIT
// Conversion of images of directions: averages over texels against dense sums, energy, layouts, workers, bad inputs.
#include <array>
#include <map>
#include <memory>

#include "support/directions.h"

namespace shd::tests
{
namespace
{

/// Images over texels of one format.
struct Images {
    shd_image image[6];
    shd_direction_images desc;

    Images(shd_projection projection, shd_cube_layout layout, shd_format format, uint32_t width, uint32_t height,
           void *pixels)
    {
        const bool faces = projection == SHD_PROJECTION_CUBE && layout == SHD_CUBE_LAYOUT_FACES;
        for (size_t i = 0; i < (faces ? 6 : 1); ++i) {
            image[i] = shd_image_default();
            image[i].format = format;
            image[i].width = width, image[i].height = height;
            image[i].pixels = static_cast<char *>(pixels) + i * width * height * shd_format_size(format);
        }
        desc = shd_direction_images_default();
        desc.projection = projection;
        desc.layout = layout;
        desc.images = image;
    }
    explicit Images(DirectionImage &of)
        : Images(of.projection, SHD_CUBE_LAYOUT_FACES, SHD_FORMAT_R32F, of.width, of.height, of.texels.data())
    {
    }
    Images(const Images &) = delete;
};

DirectionImage image_of(shd_projection projection, uint32_t size)
{
    return DirectionImage(projection, projection == SHD_PROJECTION_LAT_LONG ? 2 * size : size, size);
}

DirectionImage converted(DirectionImage &from, shd_projection projection, uint32_t size)
{
    DirectionImage to = image_of(projection, size);
    const Images source(from), target(to);
    shd_assert_ok(shd_projection_convert(g_context, &source.desc, &target.desc));
    return to;
}

double smooth(const double *n)
{
    return 2.0 + 0.5 * n[0] - 0.7 * n[1] + 0.3 * n[2] + 0.4 * n[0] * n[1] - 0.2 * n[1] * n[2];
}

/// Mean of a function over the solid angle of a texel, by 16 x 16 points; the solid angle itself [sr].
double texel_mean(const DirectionImage &image, size_t i, double *solid_angle, bool *behind)
{
    constexpr int kSide = 16;
    const auto face = static_cast<uint32_t>(i / (size_t{image.width} * image.height));
    const auto x = static_cast<uint32_t>(i % image.width), y = static_cast<uint32_t>(i / image.width % image.height);
    double sum = 0.0, weight = 0.0;
    for (int k = 0; k < kSide * kSide; ++k) {
        const long double u = (x + (k % kSide + 0.5L) / kSide) / image.width;
        const long double v = (y + (k / kSide + 0.5L) / kSide) / image.height;
        long double n[3];
        if (!ref_unproject(image.projection, u, v, face, n)) continue;
        const double direction[3] = {static_cast<double>(n[0]), static_cast<double>(n[1]), static_cast<double>(n[2])};
        const auto density = static_cast<double>(ref_density(image.projection, u, v, face));
        sum += density * smooth(direction);
        *behind = *behind || direction[2] < -0.8;
        weight += density;
    }
    *solid_angle = weight / (double{kSide * kSide} * image.width * image.height);
    return sum / weight;
}

/// Every pair of projections. The source has smaller texels than the target, then larger ones.
void test_means(void **)
{
    for (shd_projection from : kProjections) {
        DirectionImage source = image_of(from, 64);
        source.fill(smooth);
        for (shd_projection to : kProjections) {
            for (uint32_t size : {5u, 40u}) {
                const DirectionImage got = converted(source, to, size);
                for (size_t i = 0; i < got.texels.size(); i += size == 5 ? SHD_ORACLE_STRIDE : 61 * SHD_ORACLE_STRIDE) {
                    double solid_angle;
                    bool behind = false;
                    const double want = texel_mean(got, i, &solid_angle, &behind);
                    assert_true(std::isfinite(got.texels[i]));
                    if (!(solid_angle > 0.3 * 4.0 / (size * size))) continue;  // cut by the rim
                    // The rim of a disc is one direction: its texels in the source are long arcs.
                    const double tolerance = is_disc(from) ? (behind ? 0.3 : 0.02) : is_disc(to) ? 0.01 : 0.004;
                    if (!(std::fabs(double{got.texels[i]} - want) <= tolerance)) {
                        fail_msg("%s to %s, size %u, texel %zu: %g instead of %g", kProjectionNames[from],
                                 kProjectionNames[to], size, i, double{got.texels[i]}, want);
                    }
                }
            }
        }
    }
}

void test_constant(void **)
{
    for (shd_projection from : kProjections) {
        DirectionImage source = image_of(from, 9);
        source.texels.assign(source.texels.size(), 0.7f);
        for (shd_projection to : kProjections) {
            for (uint32_t size : {1u, 7u, 30u}) {
                for (float texel : converted(source, to, size).texels) assert_true(texel == 0.7f);
            }
        }
    }
}

/// Solid angles of the texels, by 8 x 8 points each.
std::vector<double> solid_angles_of(const DirectionImage &image)
{
    std::vector<double> solid_angles(image.texels.size());
    for (size_t i = 0; i < solid_angles.size(); ++i) {
        const auto face = static_cast<uint32_t>(i / (size_t{image.width} * image.height));
        for (int k = 0; k < 64; ++k) {
            const long double u = (i % image.width + (k % 8 + 0.5L) / 8) / image.width;
            const long double v = (i / image.width % image.height + (k / 8 + 0.5L) / 8) / image.height;
            long double n[3];
            if (ref_unproject(image.projection, u, v, face, n)) {
                solid_angles[i] += static_cast<double>(ref_density(image.projection, u, v, face));
            }
        }
        solid_angles[i] /= 64.0 * image.width * image.height;
    }
    return solid_angles;
}

/// Integral over the sphere.
double energy_of(const DirectionImage &image)
{
    static std::map<std::pair<int, uint32_t>, std::vector<double>> cache;
    std::vector<double> &solid_angles = cache[{image.projection, image.height}];
    if (solid_angles.empty()) solid_angles = solid_angles_of(image);
    double sum = 0.0;
    for (size_t i = 0; i < image.texels.size(); ++i) sum += solid_angles[i] * double{image.texels[i]};
    return sum;
}

/// Noise with a sun 1000 times as bright: half of the energy lies in 9 texels.
void test_energy(void **)
{
    for (shd_projection from : {SHD_PROJECTION_LAT_LONG, SHD_PROJECTION_CUBE, SHD_PROJECTION_OCTAHEDRAL}) {
        DirectionImage source = image_of(from, 32);
        source.fill_noise(3);
        for (size_t i = 0; i < 9; ++i) source.texels[(11 + i / 3) * source.width + 9 + i % 3] = 100.0f;
        const double want = energy_of(source);
        for (shd_projection to : kProjections) {
            for (uint32_t size : {9u, 40u}) {
                const double got = energy_of(converted(source, to, size));
                if (!(std::fabs(got / want - 1.0) <= 0.006)) {
                    fail_msg("%s to %s, size %u: energy %g instead of %g", kProjectionNames[from], kProjectionNames[to],
                             size, got, want);
                }
            }
        }
    }
}

/// Targets of a few texels, or of one row or column: a bright band of meridians is neither lost nor doubled.
void test_small_targets(void **)
{
    DirectionImage band(SHD_PROJECTION_LAT_LONG, 256, 128);
    for (size_t i = 0; i < band.texels.size(); ++i) band.texels[i] = i % 256 >= 20 && i % 256 < 30 ? 10.0f : 0.0f;
    const double mean = 100.0 / 256.0;
    const Images from(band);
    for (shd_projection projection : kProjections) {
        for (uint32_t width : {1u, 2u, 7u, 64u}) {
            for (uint32_t height : {1u, 2u, 7u, 64u}) {
                if (width * height > 64 * 7) continue;
                if (width != height && projection != SHD_PROJECTION_LAT_LONG) continue;
                DirectionImage to(projection, width, height);
                const Images target(to);
                shd_assert_ok(shd_projection_convert(g_context, &from.desc, &target.desc));
                const std::vector<double> solid_angles = solid_angles_of(to);
                double sum = 0.0, total = 0.0;
                for (size_t i = 0; i < to.texels.size(); ++i) {
                    sum += solid_angles[i] * double{to.texels[i]};
                    total += solid_angles[i];
                }
                if (!(std::fabs(sum / (total * mean) - 1.0) <= 0.02)) {
                    fail_msg("%s, %u x %u: mean %g instead of %g", kProjectionNames[projection], width, height,
                             sum / total, mean);
                }
                // All texels of one column show the band equally.
                for (size_t i = 0; width == 1 && projection == SHD_PROJECTION_LAT_LONG && i < height; ++i) {
                    shd_assert_close("column", i, double{to.texels[i]}, mean, 0.0, 0.002);
                }
            }
        }
    }
}

/// Thin images: the number of samples follows the number of texels, not the longer side. Each of these takes
/// seconds if it follows the longer side.
void test_thin_sources(void **)
{
    const uint32_t sizes[][2] = {{8192, 1}, {1, 8191}, {4093, 3}};
    for (const auto &size : sizes) {
        DirectionImage thin(SHD_PROJECTION_LAT_LONG, size[0], size[1]);
        thin.fill(smooth);
        const Images from(thin);
        for (shd_projection projection : kProjections) {
            DirectionImage to(projection, 3, 3);
            const Images target(to);
            shd_assert_ok(shd_projection_convert(g_context, &from.desc, &target.desc));
            double want = 0.0, got = 0.0, total = 0.0;
            const std::vector<double> solid_angles = solid_angles_of(to);
            for (size_t i = 0; i < to.texels.size(); ++i) {
                got += solid_angles[i] * double{to.texels[i]};
                total += solid_angles[i];
            }
            for (size_t i = 0; i < thin.texels.size(); ++i) {
                const double v = (static_cast<double>(i / size[0]) + 0.5) / size[1];
                want +=
                    std::sin(M_PI * v) * std::sin(0.5 * M_PI / size[1]) * 4.0 * M_PI / size[0] * double{thin.texels[i]};
            }
            shd_assert_close(kProjectionNames[projection], size[0], got / total, want / (4.0 * M_PI), 0.1, 0.0);
        }
    }
}

/// A change of layout copies texels. The neighbours in a cross show adjacent directions.
void test_layouts(void **)
{
    constexpr uint32_t kSize = 6;
    const uint32_t across[] = {1, 6, 1, 4, 3}, down[] = {1, 1, 6, 3, 4};
    DirectionImage source = image_of(SHD_PROJECTION_CUBE, kSize);
    source.fill_noise(5);
    const Images faces(source);
    for (int layout = SHD_CUBE_LAYOUT_ROW; layout <= SHD_CUBE_LAYOUT_VERTICAL_CROSS; ++layout) {
        const uint32_t width = across[layout] * kSize, height = down[layout] * kSize;
        std::vector<float> pixels(size_t{width} * height, -1.0f);
        DirectionImage back = image_of(SHD_PROJECTION_CUBE, kSize);
        const Images one(SHD_PROJECTION_CUBE, static_cast<shd_cube_layout>(layout), SHD_FORMAT_R32F, width, height,
                         pixels.data());
        const Images again(back);
        shd_assert_ok(shd_projection_convert(g_context, &faces.desc, &one.desc));
        shd_assert_ok(shd_projection_convert(g_context, &one.desc, &again.desc));
        assert_memory_equal(source.texels.data(), back.texels.data(), source.texels.size() * sizeof(float));
        size_t zeros = 0;
        for (float pixel : pixels) zeros += pixel == 0.0f;
        assert_int_equal((across[layout] * down[layout] - 6) * kSize * kSize, zeros);
    }
    // On a cross the image is continuous: neighbours differ by the slope at most.
    source.fill(smooth);
    for (int layout = SHD_CUBE_LAYOUT_HORIZONTAL_CROSS; layout <= SHD_CUBE_LAYOUT_VERTICAL_CROSS; ++layout) {
        const uint32_t width = across[layout] * kSize, height = down[layout] * kSize;
        std::vector<float> pixels(size_t{width} * height);
        const Images one(SHD_PROJECTION_CUBE, static_cast<shd_cube_layout>(layout), SHD_FORMAT_R32F, width, height,
                         pixels.data());
        shd_assert_ok(shd_projection_convert(g_context, &faces.desc, &one.desc));
        for (uint32_t y = 0; y + 1 < height; ++y) {
            for (uint32_t x = 0; x + 1 < width; ++x) {
                const float here = pixels[y * width + x], right = pixels[y * width + x + 1];
                const float below = pixels[(y + 1) * width + x];
                if (here == 0.0f) continue;
                assert_true(right == 0.0f || std::fabs(here - right) < 0.5f);
                assert_true(below == 0.0f || std::fabs(here - below) < 0.5f);
            }
        }
    }
}

void test_formats(void **)
{
    DirectionImage source = image_of(SHD_PROJECTION_LAT_LONG, 8);
    source.fill(smooth);
    for (float &texel : source.texels) texel *= 0.2f;
    const DirectionImage want = converted(source, SHD_PROJECTION_OCTAHEDRAL, 6);
    const Images from(source);
    std::vector<uint16_t> halves(6 * 6 * 4);
    std::vector<uint8_t> codes(6 * 6 * 3);
    const Images half(SHD_PROJECTION_OCTAHEDRAL, SHD_CUBE_LAYOUT_FACES, SHD_FORMAT_RGBA16F, 6, 6, halves.data());
    const Images code(SHD_PROJECTION_OCTAHEDRAL, SHD_CUBE_LAYOUT_FACES, SHD_FORMAT_RGB8, 6, 6, codes.data());
    shd_assert_ok(shd_projection_convert(g_context, &from.desc, &half.desc));
    shd_assert_ok(shd_projection_convert(g_context, &from.desc, &code.desc));
    for (size_t i = 0; i < 36; ++i) {
        shd_assert_close("code", i, codes[3 * i], 255.0 * double{want.texels[i]}, 0.501, 0.0);
        assert_int_equal(0, codes[3 * i + 1]);
        assert_int_equal(0x3c00, halves[4 * i + 3]);  // alpha 1
        assert_int_equal(0, halves[4 * i + 2]);
    }
}

/// The bits do not depend on the number of workers or the SIMD target.
void test_same_bits(void **)
{
    DirectionImage source = image_of(SHD_PROJECTION_LAT_LONG, 12);
    source.fill_noise(8);
    source.texels[7] = NAN, source.texels[40] = INFINITY;
    std::array<uint64_t, 6> first = {};
    for (int run = 0; run < 8; ++run) {
        shd_context_desc desc = shd_context_desc_default();
        desc.worker_count = run == 7 ? 4 : 1;
        desc.simd = run == 7 ? SHD_SIMD_BEST : static_cast<shd_simd>(SHD_SIMD_SCALAR + run);
        shd_context *context = nullptr;
        if (shd_context_create(&desc, &context) != SHD_OK) continue;
        for (shd_projection projection : kProjections) {
            DirectionImage to = image_of(projection, 7);
            const Images from(source), target(to);
            shd_assert_ok(shd_projection_convert(context, &from.desc, &target.desc));
            const uint64_t hash = shd_hash(SHD_HASH_START, to.texels.data(), to.texels.size() * sizeof(float));
            if (!first[projection]) first[projection] = hash;
            assert_true(hash == first[projection]);
        }
        shd_context_release(context);
    }
}

void test_errors(void **)
{
    float pixels[64 * 64];
    const shd_result bad = SHD_ERROR_INVALID_ARGUMENT;
    const auto convert = [](const Images &from, const Images &to) {
        return shd_projection_convert(g_context, &from.desc, &to.desc);
    };
    const auto of = [&](shd_projection projection, uint32_t width, uint32_t height, uint32_t first,
                        shd_cube_layout layout = SHD_CUBE_LAYOUT_FACES) {
        return std::make_unique<Images>(projection, layout, SHD_FORMAT_R32F, width, height, pixels + first);
    };
    const auto good = of(SHD_PROJECTION_LAT_LONG, 4, 2, 0), target = of(SHD_PROJECTION_ANGULAR, 4, 4, 64);
    shd_assert_ok(convert(*good, *target));
    shd_assert_result("context", shd_projection_convert(nullptr, &good->desc, &target->desc), bad, "context: NULL");
    shd_assert_result("from", shd_projection_convert(g_context, nullptr, &target->desc), bad, "from: NULL");
    shd_assert_result("to", shd_projection_convert(g_context, &good->desc, nullptr), bad, "to: NULL");
    const struct {
        const char *message;
        shd_projection projection;
        uint32_t width, height;
        shd_cube_layout layout;
    } rows[] = {
        {"to.projection: 0 is not in 1..5", SHD_PROJECTION_NONE, 4, 4, SHD_CUBE_LAYOUT_FACES},
        {"to.projection: 9 is not in 1..5", static_cast<shd_projection>(9), 4, 4, SHD_CUBE_LAYOUT_FACES},
        {"to.layout: 5 is not in 0..4", SHD_PROJECTION_CUBE, 4, 4, static_cast<shd_cube_layout>(5)},
        {"to.images[0]: 4 x 5 pixels are not 1 x 1 squares", SHD_PROJECTION_MIRROR_BALL, 4, 5, SHD_CUBE_LAYOUT_FACES},
        {"to.images[0]: 4 x 5 pixels are not 1 x 1 squares", SHD_PROJECTION_ANGULAR, 4, 5, SHD_CUBE_LAYOUT_FACES},
        {"to.images[0]: 4 x 5 pixels are not 1 x 1 squares", SHD_PROJECTION_OCTAHEDRAL, 4, 5, SHD_CUBE_LAYOUT_FACES},
        {"to.images[0]: 4 x 5 pixels are not 1 x 1 squares", SHD_PROJECTION_CUBE, 4, 5, SHD_CUBE_LAYOUT_FACES},
        {"to.images[0]: 12 x 3 pixels are not 6 x 1 squares", SHD_PROJECTION_CUBE, 12, 3, SHD_CUBE_LAYOUT_ROW},
        {"to.images[0]: 2 x 13 pixels are not 1 x 6 squares", SHD_PROJECTION_CUBE, 2, 13, SHD_CUBE_LAYOUT_COLUMN},
        {"to.images[0]: 9 x 12 pixels are not 4 x 3 squares", SHD_PROJECTION_CUBE, 9, 12,
         SHD_CUBE_LAYOUT_HORIZONTAL_CROSS},
        {"to.images[0]: 12 x 9 pixels are not 3 x 4 squares", SHD_PROJECTION_CUBE, 12, 9,
         SHD_CUBE_LAYOUT_VERTICAL_CROSS},
        {"to.images[0].width: 0", SHD_PROJECTION_LAT_LONG, 0, 4, SHD_CUBE_LAYOUT_FACES},
        {"pixels are not in 1..67108864", SHD_PROJECTION_LAT_LONG, 65536, 65536, SHD_CUBE_LAYOUT_FACES},
    };
    for (const auto &row : rows) {
        const auto to = of(row.projection, row.width, row.height, 64, row.layout);
        shd_assert_result(row.message, convert(*good, *to), bad, row.message);
    }
    auto cube = of(SHD_PROJECTION_CUBE, 2, 2, 64);
    cube->image[3].width = 3;
    shd_assert_result("faces", convert(*good, *cube), bad, "to.images[3]: 3 x 2 of format");
    cube->image[3].width = 2, cube->image[5].struct_size += 8;
    shd_assert_result("sizes", convert(*good, *cube), bad,
                      "to.images[5].struct_size: 40 is not the 32 of to.images[0]");
    cube->image[5].struct_size -= 8, cube->image[4].pixels = cube->image[1].pixels;
    shd_assert_result("overlap", convert(*good, *cube), bad, "to.images[4].pixels: overlaps to.images[1].pixels");
    shd_assert_result("in place", convert(*good, *of(SHD_PROJECTION_ANGULAR, 4, 4, 2)), bad, "overlaps from.images[0]");
    target->desc.images = nullptr;
    shd_assert_result("NULL", convert(*good, *target), bad, "to.images: NULL");
}

}  // namespace
}  // namespace shd::tests

int main()
{
    using namespace shd::tests;
    const CMUnitTest tests[] = {
        {"means", test_means, nullptr, nullptr, nullptr},
        {"constant", test_constant, nullptr, nullptr, nullptr},
        {"energy", test_energy, nullptr, nullptr, nullptr},
        {"small_targets", test_small_targets, nullptr, nullptr, nullptr},
        {"thin_sources", test_thin_sources, nullptr, nullptr, nullptr},
        {"layouts", test_layouts, nullptr, nullptr, nullptr},
        {"formats", test_formats, nullptr, nullptr, nullptr},
        {"same_bits", test_same_bits, nullptr, nullptr, nullptr},
        {"errors", test_errors, nullptr, nullptr, nullptr},
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
