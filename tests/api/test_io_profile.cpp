// SPDX-License-Identifier: MIT
// SHD_PROFILE_OIIO against OpenImageIO's TextureSystem, with the same levels: OpenImageIO reads a tiled and mipmapped
// file, shd gets its levels in memory.
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <vector>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/texture.h>

#include <shd/shd.h>

#include "support/check.h"

namespace
{

enum { kPoints = 4000 };

struct Case {
    const char *name;
    int width, height;
    shd_filter filter;
    OIIO::TextureOpt::MipMode mip;
    shd_wrap wrap;
    OIIO::TextureOpt::Wrap peer_wrap;
    float width_u, width_v, blur_u, blur_v;
    int anisotropy;
    double worst;
};

/// In every case at least 98 % of the points are this close.
const double kClose = 1e-5;
/// For ellipses a thousand times as long as wide, OpenImageIO computes the shorter axis from a difference of rounded
/// squares, with an error of up to 3e-4 of the longer axis. Measured 2.9e-3.
const double kThin = 6e-3;

const OIIO::TextureOpt::MipMode kNone = OIIO::TextureOpt::MipModeNoMIP, kOne = OIIO::TextureOpt::MipModeOneLevel,
                                kTri = OIIO::TextureOpt::MipModeTrilinear, kAniso = OIIO::TextureOpt::MipModeAniso;
const OIIO::TextureOpt::Wrap kRepeat = OIIO::TextureOpt::WrapPeriodic, kClamp = OIIO::TextureOpt::WrapClamp,
                             kMirror = OIIO::TextureOpt::WrapMirror, kBlack = OIIO::TextureOpt::WrapBlack;

const Case k_cases[] = {
    {"bilinear", 64, 64, SHD_FILTER_BILINEAR, kNone, SHD_WRAP_REPEAT, kRepeat, 1, 1, 0, 0, 16, 1e-5},
    {"bilinear/clamp", 64, 64, SHD_FILTER_BILINEAR, kNone, SHD_WRAP_CLAMP, kClamp, 1, 1, 0, 0, 16, 1e-5},
    {"bilinear/mirror", 48, 20, SHD_FILTER_BILINEAR, kNone, SHD_WRAP_MIRROR, kMirror, 1, 1, 0, 0, 16, 1e-5},
    {"bilinear/black", 48, 20, SHD_FILTER_BILINEAR, kNone, SHD_WRAP_BORDER, kBlack, 1, 1, 0, 0, 16, 1e-5},
    {"bilinear_mip", 64, 64, SHD_FILTER_BILINEAR_MIP, kOne, SHD_WRAP_REPEAT, kRepeat, 1, 1, 0, 0, 16, 1e-5},
    {"bilinear_mip/odd", 45, 21, SHD_FILTER_BILINEAR_MIP, kOne, SHD_WRAP_REPEAT, kRepeat, 1, 1, 0, 0, 16, 1e-5},
    {"trilinear", 64, 64, SHD_FILTER_TRILINEAR, kTri, SHD_WRAP_REPEAT, kRepeat, 1, 1, 0, 0, 16, 1e-5},
    {"trilinear/oblong", 128, 32, SHD_FILTER_TRILINEAR, kTri, SHD_WRAP_REPEAT, kRepeat, 1, 1, 0, 0, 16, 1e-5},
    {"trilinear/odd", 45, 21, SHD_FILTER_TRILINEAR, kTri, SHD_WRAP_CLAMP, kClamp, 1, 1, 0, 0, 16, 1e-5},
    {"trilinear/width_blur", 64, 64, SHD_FILTER_TRILINEAR, kTri, SHD_WRAP_REPEAT, kRepeat, 2, 0.5f, 0.03f, 0.1f, 16,
     1e-5},
    {"anisotropic", 64, 64, SHD_FILTER_ANISOTROPIC, kAniso, SHD_WRAP_REPEAT, kRepeat, 1, 1, 0, 0, 16, kThin},
    {"anisotropic/4", 64, 64, SHD_FILTER_ANISOTROPIC, kAniso, SHD_WRAP_CLAMP, kClamp, 1, 1, 0, 0, 4, kThin},
    {"anisotropic/oblong", 128, 32, SHD_FILTER_ANISOTROPIC, kAniso, SHD_WRAP_REPEAT, kRepeat, 1, 1, 0, 0, 16, kThin},
    {"anisotropic/width", 64, 64, SHD_FILTER_ANISOTROPIC, kAniso, SHD_WRAP_REPEAT, kRepeat, 3, 0.5f, 0, 0, 16, kThin},
    {"anisotropic/blur", 64, 64, SHD_FILTER_ANISOTROPIC, kAniso, SHD_WRAP_REPEAT, kRepeat, 1, 1, 0.02f, 0.15f, 16,
     1e-5},
};

struct Columns {
    float u[kPoints], v[kPoints], dudx[kPoints], dvdx[kPoints], dudy[kPoints], dvdy[kPoints];
    float got[3][kPoints], want[3 * kPoints];
};
Columns t_columns;

uint32_t t_seed;
float random_in(float low, float high)
{
    t_seed = t_seed * 1664525u + 1013904223u;
    return low + (high - low) * static_cast<float>(t_seed >> 8) * 0x1p-24f;
}

/// Footprints from 2^-9 to 1/2 of the texture, some of them degenerate. With blur all are round enough for OpenImageIO,
/// which asserts that the shorter axis is above 0, although rounding can make it 0.
void place_points(bool round)
{
    t_seed = 7;
    for (int i = 0; i < kPoints; ++i) {
        const float scale = exp2f(random_in(-9, -1)), thin = exp2f(random_in(-5, 0));
        const float a = scale * random_in(-1, 1), b = scale * random_in(-1, 1);
        const float c = i % 50 == 3 ? 0 : thin * scale * random_in(-1, 1);
        const float d = i % 50 == 3 ? 0 : thin * scale * random_in(-1, 1);
        t_columns.u[i] = random_in(-1, 2);
        t_columns.v[i] = random_in(-1, 2);
        t_columns.dudx[i] = a;
        t_columns.dvdx[i] = b;
        t_columns.dudy[i] = round ? 0.3f * a - thin * b : c;
        t_columns.dvdy[i] = round ? 0.3f * b + thin * a : d;
    }
}

std::string write_file(const Case &c)
{
    // OpenImageIO caches files by name.
    const std::string path =
        "/tmp/shd-test-profile-" + std::to_string(getpid()) + "-" + std::to_string(&c - k_cases) + ".tx";
    OIIO::ImageBuf image(OIIO::ImageSpec(c.width, c.height, 3, OIIO::TypeDesc::UINT8));
    t_seed = 99;
    for (OIIO::ImageBuf::Iterator<unsigned char> p(image); !p.done(); ++p) {
        for (int k = 0; k < 3; ++k) p[k] = random_in(0, 1);
    }
    OIIO::ImageSpec config;
    config.attribute("maketx:highlightcomp", 0);
    config.attribute("maketx:resize", 0);
    const bool made = OIIO::ImageBufAlgo::make_texture(OIIO::ImageBufAlgo::MakeTxTexture, image, path, config);
    assert_true(made);
    return path;
}

shd_texture *load_levels(shd_context *context, const Case &c, const std::string &path)
{
    std::vector<std::vector<uint8_t>> texels;
    std::vector<shd_image> levels;
    const auto file = OIIO::ImageInput::open(path);
    assert_true(file != nullptr);
    int count = 0;
    while (file->seek_subimage(0, count)) ++count;
    assert_true(count > 0);
    for (int l = 0; l < count; ++l) {
        const OIIO::ImageBuf level(path, 0, l);
        texels.emplace_back(static_cast<size_t>(level.spec().width) * level.spec().height * 3);
        const bool read = level.get_pixels(level.roi(), OIIO::TypeDesc::UINT8, texels.back().data());
        assert_true(read);
        shd_image image = shd_image_default();
        image.format = SHD_FORMAT_RGB8;
        image.width = static_cast<uint32_t>(level.spec().width);
        image.height = static_cast<uint32_t>(level.spec().height);
        levels.push_back(image);
    }
    for (size_t l = 0; l < levels.size(); ++l) levels[l].pixels = texels[l].data();
    shd_texture_desc desc = shd_texture_desc_default();
    desc.format = SHD_FORMAT_RGB8;
    desc.width = static_cast<uint32_t>(c.width);
    desc.height = static_cast<uint32_t>(c.height);
    desc.texels = texels[0].data();
    desc.tables = SHD_TABLE_MIPMAP;
    desc.level_images = levels.data() + 1;
    desc.level_count = static_cast<uint32_t>(levels.size() - 1);
    shd_texture *texture = nullptr;
    shd_assert_ok(shd_texture_create(context, &desc, &texture));
    return texture;
}

void look_up(const Case &c, shd_context *context, const std::string &path)
{
    shd_texture *texture = load_levels(context, c, path);
    shd_sampler_desc desc = shd_sampler_desc_default();
    desc.profile = SHD_PROFILE_OIIO;
    desc.filter = c.filter;
    desc.wrap_u = desc.wrap_v = c.wrap;
    desc.width_x = c.width_u;
    desc.width_y = c.width_v;
    desc.blur_u = c.blur_u;
    desc.blur_v = c.blur_v;
    desc.max_anisotropy = static_cast<float>(c.anisotropy);
    shd_sampler *sampler = nullptr;
    shd_assert_ok(shd_sampler_create(context, &desc, &sampler));
    shd_lookups in = shd_lookups_default();
    in.count = kPoints;
    in.u.data = t_columns.u;
    in.v.data = t_columns.v;
    in.dudx.data = t_columns.dudx;
    in.dvdx.data = t_columns.dvdx;
    in.dudy.data = t_columns.dudy;
    in.dvdy.data = t_columns.dvdy;
    shd_texels out = {};
    for (int k = 0; k < 3; ++k) out.channel[k].data = t_columns.got[k];
    shd_assert_ok(shd_texture_sample(texture, sampler, &in, &out));
    shd_sampler_release(sampler);
    shd_texture_release(texture);
}

void look_up_peer(const Case &c, const std::string &path)
{
    // The shared TextureSystem: destroying a private one frees it through its base type, which sanitizers report.
    OIIO::TextureSystem *system = OIIO::TextureSystem::create(true);
    system->invalidate_all(true);
    OIIO::TextureOpt options;
    options.interpmode = OIIO::TextureOpt::InterpBilinear;
    options.mipmode = c.mip;
    options.swrap = options.twrap = c.peer_wrap;
    options.swidth = c.width_u;
    options.twidth = c.width_v;
    options.sblur = c.blur_u;
    options.tblur = c.blur_v;
    options.anisotropic = c.anisotropy;
    bool good = true;
    for (int i = 0; i < kPoints; ++i) {
        good = system->texture(OIIO::ustring(path), options, t_columns.u[i], t_columns.v[i], t_columns.dudx[i],
                               t_columns.dvdx[i], t_columns.dudy[i], t_columns.dvdy[i], 3, &t_columns.want[3 * i]) &&
               good;
    }
    OIIO::TextureSystem::destroy(system);
    assert_true(good);
}

void test_parity(void **state)
{
    const Case &c = *static_cast<const Case *>(*state);
    shd_context *context = nullptr;
    shd_assert_ok(shd_context_create(nullptr, &context));
    place_points(c.blur_u > 0);
    const std::string path = write_file(c);
    look_up(c, context, path);
    look_up_peer(c, path);
    std::remove(path.c_str());
    shd_context_release(context);

    double worst = 0;
    int apart = 0, at = 0;
    for (int i = 0; i < kPoints; ++i) {
        double error = 0;
        for (int k = 0; k < 3; ++k) {
            error = fmax(error, fabs(static_cast<double>(t_columns.got[k][i] - t_columns.want[3 * i + k])));
        }
        apart += error > kClose;
        if (error > worst) at = i;
        worst = fmax(worst, error);
    }
    print_message("%s: %d of %d points further apart than %g, the worst %g\n", c.name, apart, int{kPoints}, kClose,
                  worst);
    if (apart > kPoints / 50 || worst > c.worst) {
        fail_msg("%s: %d points further apart than %g, the worst %g at (%g, %g), dX = (%g, %g), dY = (%g, %g)", c.name,
                 apart, kClose, worst, static_cast<double>(t_columns.u[at]), static_cast<double>(t_columns.v[at]),
                 static_cast<double>(t_columns.dudx[at]), static_cast<double>(t_columns.dvdx[at]),
                 static_cast<double>(t_columns.dudy[at]), static_cast<double>(t_columns.dvdy[at]));
    }
}

}  // namespace

int main()
{
    CMUnitTest tests[sizeof k_cases / sizeof k_cases[0]];
    size_t n = 0;
    for (const Case &c : k_cases) tests[n++] = {c.name, test_parity, nullptr, nullptr, const_cast<Case *>(&c)};
    return _cmocka_run_group_tests("api.io_profile", tests, n, nullptr, nullptr);
}
