// SPDX-License-Identifier: MIT
// Grids of OpenVDB files as 3D textures. OpenVDB writes the files. A build without OpenVDB tests the error.
#ifdef SHD_TEST_OPENVDB
// Before cmocka, whose macros fail and skip are names in OpenVDB.
#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>
#endif

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include <shd/shd.h>

#include "support/loads.h"
#include "support/volume_files.h"

#ifndef SHD_TEST_OPENVDB

int main()
{
    shd_context *context = nullptr;
    shd_texture *texture = nullptr;
    void *state = nullptr;
    if (io_make_folder(&state) != 0 || shd_context_create(nullptr, &context) != SHD_OK) return 1;
    const std::string path = io_path("any.vdb");
    std::FILE *file = std::fopen(path.c_str(), "wb");
    if (!file || std::fputs("any", file) < 0 || std::fclose(file) != 0) return 1;
    const shd_vdb_desc vdb = shd_vdb_desc_default();
    const shd_result result = load_vdb(context, path.c_str(), &vdb, nullptr, nullptr, &texture);
    const bool refused = result == SHD_ERROR_UNSUPPORTED && std::strstr(shd_last_error(), "built without OpenVDB");
    std::printf("built without OpenVDB (Debian: libopenvdb-dev libboost-dev): a load %s\n",
                refused ? "is refused" : "FAILS");
    io_remove_folder(&state);
    shd_context_release(context);
    return refused ? 0 : 1;
}

#else

#include <cmath>
#include <fstream>
#include <limits>
#include <vector>

namespace
{

using openvdb::Coord;
using openvdb::CoordBBox;
using openvdb::FloatGrid;

shd_context *g_context;

/// Scattered voxels, an active tile and an inactive one, with negative coordinates; NaN and infinity.
template <class Grid>
typename Grid::Ptr make_grid(const char *name, uint64_t seed)
{
    auto grid = Grid::create(0.25f);
    auto accessor = grid->getAccessor();
    for (int i = 0; i < 40; ++i) {
        const auto at = [&] { return static_cast<int>(io_random(&seed) % 23); };
        const Coord place(at() - 9, at() - 3, at() / 2 + 1);
        accessor.setValue(place, static_cast<float>(io_random(&seed) >> 40) / 4096.0f - 5.0f);
    }
    accessor.setValue(Coord(-9, 0, 1), std::numeric_limits<float>::infinity());
    accessor.setValue(Coord(13, 19, 12), std::numeric_limits<float>::quiet_NaN());
    grid->tree().addTile(1, Coord(0, 0, 0), 3.5f, true);
    grid->tree().addTile(1, Coord(-8, 8, 0), -1.5f, false);
    grid->setName(name);
    grid->setGridClass(openvdb::GRID_FOG_VOLUME);
    return grid;
}

void write_grids(const std::string &path, const openvdb::GridCPtrVec &grids, uint32_t compression, bool statistics)
{
    openvdb::io::File file(path);
    file.setCompression(compression);
    file.setGridStatsMetadataEnabled(statistics);
    file.write(grids);
    file.close();
}

std::string write_one(const openvdb::GridBase::Ptr &grid)
{
    const std::string path = io_path("grid.vdb");
    write_grids(path, {grid}, openvdb::io::COMPRESS_ACTIVE_MASK, true);
    return path;
}

template <class Grid>
void check_texels(const Grid &grid, const CoordBBox &box, const shd_texture *texture)
{
    shd_texture_info info;
    const io_bytes got = io_read_texels(texture, &info);
    const auto accessor = grid.getConstAccessor();
    size_t i = 0;
    assert_int_equal(info.format, SHD_FORMAT_R32F);
    assert_true(static_cast<int>(info.width) == box.dim().x() && static_cast<int>(info.height) == box.dim().y() &&
                static_cast<int>(info.depth) == box.dim().z());
    for (int z = box.min().z(); z <= box.max().z(); ++z) {
        for (int y = box.min().y(); y <= box.max().y(); ++y) {
            for (int x = box.min().x(); x <= box.max().x(); ++x, ++i) {
                const auto want = static_cast<float>(accessor.getValue(Coord(x, y, z)));
                float value;
                std::memcpy(&value, got.data + 4 * i, 4);
                if (value != want && !(std::isnan(value) && std::isnan(want))) {
                    fail_msg("voxel %d %d %d: got %g, want %g", x, y, z, value, want);
                }
            }
        }
    }
    std::free(got.data);
}

/// Centres of the first and last texel lie where the grid has their voxels.
void check_place(const openvdb::GridBase &grid, const CoordBBox &box, const shd_vdb_info &info)
{
    const Coord size = box.dim();
    for (const Coord &voxel : {box.min(), box.max(), Coord(box.min().x(), box.max().y(), box.min().z())}) {
        const Coord texel = voxel - box.min();
        const openvdb::Vec3d want = grid.transform().indexToWorld(voxel);
        for (int row = 0; row < 3; ++row) {
            double got = info.object_to_world[12 + row];
            for (int a = 0; a < 3; ++a) {
                got += double{info.object_to_world[4 * a + row]} * (texel[a] + 0.5) / size[a];
            }
            shd_assert_close("place", 0, got, want[row], 1e-4, 1e-6);
        }
    }
    for (int a = 0; a < 3; ++a) assert_int_equal(info.index_min[a], box.min()[a]);
}

/// Loads by the worker and in process, with a desc.
template <class Grid>
void check_load(const std::string &path, const shd_vdb_desc &desc, const Grid &grid, const char *name)
{
    CoordBBox box;
    grid.tree().evalActiveVoxelBoundingBox(box);
    if (desc.flags & SHD_VDB_BOX) box = CoordBBox(Coord(desc.bounds_min), Coord(desc.bounds_max));
    for (const uint32_t flags : {0u, uint32_t{SHD_LOAD_IN_PROCESS}}) {
        shd_load_desc load = shd_load_desc_default();
        shd_vdb_info info = shd_vdb_info_default();
        shd_texture *texture = nullptr;
        load.flags = flags;
        shd_assert_ok(load_vdb(g_context, path.c_str(), &desc, &load, &info, &texture));
        check_texels(grid, box, texture);
        check_place(grid, box, info);
        assert_string_equal(info.grid, name);
        assert_int_equal(info.grid_class, grid.getGridClass() == openvdb::GRID_LEVEL_SET    ? SHD_VDB_CLASS_LEVEL_SET
                                          : grid.getGridClass() == openvdb::GRID_FOG_VOLUME ? SHD_VDB_CLASS_FOG_VOLUME
                                                                                            : SHD_VDB_CLASS_UNKNOWN);
        assert_int_equal(info.active_voxel_count, grid.activeVoxelCount());
        assert_true(info.background == static_cast<float>(grid.background()));
        shd_texture_release(texture);
    }
}

shd_vdb_desc named(const char *name)
{
    shd_vdb_desc desc = shd_vdb_desc_default();
    desc.grid = name;
    return desc;
}

void test_grids(void **)
{
    const auto vectors = openvdb::Vec3SGrid::create();
    const auto first = make_grid<FloatGrid>("density", 1), second = make_grid<FloatGrid>("density", 2);
    const auto doubles = make_grid<openvdb::DoubleGrid>("temp\xc3\xa9rature", 3);
    const auto shared = openvdb::gridPtrCast<FloatGrid>(first->copyGrid());
    const std::string path = io_path("grids.vdb");
    shared->setName("shared");
    shared->setGridClass(openvdb::GRID_UNKNOWN);
    vectors->setName("velocity");
    vectors->tree().setValue(Coord(1, 2, 3), openvdb::Vec3s(1, 2, 3));
    openvdb::Mat4d turned = openvdb::Mat4d::identity();
    turned.preRotate(openvdb::math::X_AXIS, 0.7);
    turned.preRotate(openvdb::math::Z_AXIS, -0.4);
    turned.preScale(openvdb::Vec3d(0.5, 0.25, 2));
    turned.postTranslate(openvdb::Vec3d(7, -8, 9));
    doubles->setTransform(openvdb::math::Transform::createLinearTransform(turned));
    second->setTransform(openvdb::math::Transform::createLinearTransform(0.1));
    second->setGridClass(openvdb::GRID_LEVEL_SET);
    for (const uint32_t compression : {uint32_t{openvdb::io::COMPRESS_NONE}, uint32_t{openvdb::io::COMPRESS_ZIP},
                                       uint32_t{openvdb::io::COMPRESS_ACTIVE_MASK | openvdb::io::COMPRESS_BLOSC}}) {
        write_grids(path, {vectors, first, second, doubles, shared}, compression, compression != 0);
        check_load(path, named(nullptr), *first, "density");
        check_load(path, named("density[1]"), *second, "density");
        check_load(path, named("temp\xc3\xa9rature"), *doubles, "temp\xc3\xa9rature");
        check_load(path, named("shared"), *shared, "shared");
    }
}

/// Numbers that are exact as halves.
void test_halves(void **)
{
    const auto grid = FloatGrid::create(0.5f);
    for (int i = 0; i < 12; ++i) grid->tree().setValue(Coord(i, i / 2, -i), static_cast<float>(i) / 8.0f);
    grid->setSaveFloatAsHalf(true);
    check_load(write_one(grid), named(nullptr), *grid, "");
}

/// Boxes inside, across and outside the active voxels.
void test_boxes(void **)
{
    const auto grid = make_grid<FloatGrid>("density", 5);
    const std::string path = write_one(grid);
    static const int boxes[][6] = {{0, 0, 0, 7, 7, 7},
                                   {-20, -1, 3, 30, 2, 3},
                                   {100, 100, 100, 101, 102, 103},
                                   {-4, 5, 6, -4, 5, 6},
                                   {-1073741824, 1073741823, 0, -1073741824, 1073741824, 0}};
    for (const auto &box : boxes) {
        shd_vdb_desc desc = shd_vdb_desc_default();
        desc.flags = SHD_VDB_BOX;
        for (int a = 0; a < 3; ++a) desc.bounds_min[a] = box[a], desc.bounds_max[a] = box[3 + a];
        check_load(path, desc, *grid, "density");
    }
}

/// Files cut off at every byte, or with bytes behind the last grid.
void test_cut(void **)
{
    const auto grid = make_grid<FloatGrid>("density", 6);
    const io_bytes whole = io_read(write_one(grid).c_str());
    const std::string path = io_path("cut.vdb");
    shd_load_desc load = shd_load_desc_default();
    size_t count = 0;
    for (size_t size = 0; size < whole.size; size += size + 40 < whole.size && size > 600 ? 37 : 1, ++count) {
        shd_texture *texture = reinterpret_cast<shd_texture *>(g_context);
        shd_vdb_info info = shd_vdb_info_default();
        io_write(path.c_str(), whole.data, size);
        load.flags = count % 32 == 0 ? 0 : SHD_LOAD_IN_PROCESS;
        shd_assert_result("cut", load_vdb(g_context, path.c_str(), nullptr, &load, &info, &texture),
                          size > 0 && size < 8 ? SHD_ERROR_UNSUPPORTED : SHD_ERROR_CORRUPT,
                          size == 0  ? "is empty"
                          : size < 8 ? "of no known image format"
                                     : "is cut off");
        assert_null(texture);
        assert_true(info.active_voxel_count == 0 && info.object_to_world[0] == 0.0f);
    }
    print_message("%zu truncations of %zu bytes are refused\n", count, whole.size);
    std::free(whole.data);
}

/// Changed bytes give an error or some voxels; the worker contains crashes. Tests of OpenVDB itself are not the point.
void test_changed(void **)
{
    const auto grid = make_grid<FloatGrid>("density", 7);
    const io_bytes whole = io_read(write_one(grid).c_str());
    const std::string path = io_path("changed.vdb");
    int loaded = 0;
    for (uint64_t i = 0; i < 40; ++i) {
        std::vector<unsigned char> bytes(whole.data, whole.data + whole.size);
        uint64_t random = 0x9e3779b97f4a7c15ull * (i + 1);
        shd_load_desc load = shd_load_desc_default();
        shd_texture *texture = nullptr;
        for (uint64_t flips = 1 + io_random(&random) % 3; flips > 0; --flips) {
            const size_t at = io_random(&random) % (i % 2 ? bytes.size() : 700);
            bytes[at] = static_cast<unsigned char>(bytes[at] ^ (1 + io_random(&random) % 255));
        }
        io_write(path.c_str(), bytes.data(), bytes.size());
        load.time_limit = 0.25;
        load.max_pixels = 1 << 22;
        const shd_result result = load_vdb(g_context, path.c_str(), nullptr, &load, nullptr, &texture);
        assert_true((result == SHD_OK) == (texture != nullptr));
        if (result != SHD_OK) {
            assert_true(result == SHD_ERROR_CORRUPT || result == SHD_ERROR_UNSUPPORTED || result == SHD_ERROR_LIMIT ||
                        result == SHD_ERROR_OUT_OF_MEMORY || result == SHD_ERROR_NOT_FOUND);
            if (std::strstr(shd_last_error(), "/proc/")) fail_msg("%s", shd_last_error());
        }
        loaded += result == SHD_OK;
        shd_texture_release(texture);
    }
    print_message("%d of 40 changed files load\n", loaded);
    std::free(whole.data);
}

/// Grids that no texture can have, and changes of the descs.
struct BadCase {
    const char *name;
    shd_result expected;
    const char *message;
    void (*change)(FloatGrid &grid, shd_vdb_desc &desc, shd_load_desc &load);
};
#define CHANGE [](FloatGrid & grid, shd_vdb_desc & desc, shd_load_desc & load) -> void
#define ARGUMENT SHD_ERROR_INVALID_ARGUMENT

void far_voxels(FloatGrid &grid, int distance)
{
    for (int a = 0; a < 3; ++a) {
        Coord place(0, 0, 0);
        place[a] = distance;
        grid.tree().setValue(place, 1.0f);
    }
}

void set_box(shd_vdb_desc &desc, int axis, int low, int high)
{
    desc.flags = SHD_VDB_BOX;
    desc.bounds_min[axis] = low;
    desc.bounds_max[axis] = high;
}

const std::string k_long(256, 'x');

const BadCase k_bad[] = {{"bad/nothing", SHD_OK, "", CHANGE{(void)grid, (void)desc, (void)load;
}  // namespace
}
, {"bad/no_grid", SHD_ERROR_NOT_FOUND, "vdb.grid: the file has no grid \"fog?\"",
   CHANGE{(void)grid, (void)load, desc.grid = "fog\x01";
}
}
, {"bad/empty_name", ARGUMENT, "vdb.grid: empty", CHANGE{(void)grid, (void)load, desc.grid = "";
}
}
, {"bad/long_name", ARGUMENT, "vdb.grid: longer than 255 bytes",
   CHANGE{(void)grid, (void)load, desc.grid = k_long.c_str();
}
}
, {"bad/flags", SHD_ERROR_UNSUPPORTED, "vdb.flags: bits 0x2", CHANGE{(void)grid, (void)load, desc.flags = 2;
}
}
, {"bad/box_order", ARGUMENT, "vdb.bounds_max[1]: 4 is not in bounds_min..2^30, bounds_min is 5",
   CHANGE{(void)grid, (void)load, set_box(desc, 1, 5, 4);
}
}
, {"bad/box_low", ARGUMENT, "vdb.bounds_min[2]: -2147483648 is not in",
   CHANGE{(void)grid, (void)load, set_box(desc, 2, std::numeric_limits<int>::min(), 0);
}
}
, {"bad/box_high", ARGUMENT, "vdb.bounds_max[0]: 2147483647 is not in",
   CHANGE{(void)grid, (void)load, set_box(desc, 0, 0, std::numeric_limits<int>::max());
}
}
, {"bad/box_side", SHD_ERROR_LIMIT, "slice of 65537 x 1 pixels: a side is above 65536",
   CHANGE{(void)grid, (void)load, set_box(desc, 0, 0, 65536);
}
}
, {"bad/box_depth", SHD_ERROR_LIMIT, "a volume of 2147483649 slices",
   CHANGE{(void)grid, (void)load, set_box(desc, 2, -(1 << 30), 1 << 30);
}
}
, {"bad/box_product", SHD_ERROR_LIMIT, "volume of 65536 x 65536 x 65536 voxels is above load.max_pixels",
   CHANGE{(void)grid, (void)load, set_box(desc, 0, 0, 65535), set_box(desc, 1, 0, 65535), set_box(desc, 2, 0, 65535);
}
}
, {"bad/no_active", SHD_ERROR_UNSUPPORTED, "the grid has no active voxels", CHANGE{(void)desc, (void)load, grid.clear();
}
}
, {"bad/no_active_box", SHD_OK, "", CHANGE{(void)load, grid.clear(), set_box(desc, 0, -2, 3);
}
}
, {"bad/far", SHD_ERROR_LIMIT, "volume of 1010 x 1004 x 1001 voxels is above load.max_pixels 268435456",
   CHANGE{(void)desc, (void)load, far_voxels(grid, 1000);
}
}
, {"bad/farther", SHD_ERROR_LIMIT, "a side is above 65536", CHANGE{(void)desc, (void)load, far_voxels(grid, 70000);
}
}
, {"bad/farthest", SHD_ERROR_LIMIT, "voxels beyond 2^30", CHANGE{(void)desc, (void)load, far_voxels(grid, 2000000000);
}
}
, {"bad/frustum", SHD_ERROR_UNSUPPORTED, "the transform of the grid is not affine",
   CHANGE{(void)desc, (void)load,
          grid.setTransform(openvdb::math::Transform::createFrustumTransform(
              openvdb::BBoxd(openvdb::Vec3d(0), openvdb::Vec3d(10)), 0.5, 2.0, 1.0));
}
}
, {"bad/pixels", SHD_ERROR_LIMIT, "above load.max_pixels 6876", CHANGE{(void)grid, (void)desc, load.max_pixels = 6876;
}
}
, {"bad/bytes", SHD_ERROR_LIMIT, "27508 decoded bytes are above load.max_bytes 27507",
   CHANGE{(void)grid, (void)desc, load.max_bytes = 27507;
}
}
, {"bad/enough", SHD_OK, "", CHANGE{(void)grid, (void)desc, load.max_pixels = 6877, load.max_bytes = 27508;
}
}
, {"bad/ratio", SHD_ERROR_LIMIT, "above load.max_ratio 100",
   CHANGE{(void)desc, load.max_ratio = 100, far_voxels(grid, 300);
}
}
, {"bad/load_flags", SHD_ERROR_UNSUPPORTED, "load.flags: bits 0x4 have no meaning for OpenVDB",
   CHANGE{(void)grid, (void)desc, load.flags = SHD_LOAD_FLIP_V;
}
}
, {"bad/file_bytes", SHD_ERROR_LIMIT, "above load.max_file_bytes 99",
   CHANGE{(void)grid, (void)desc, load.max_file_bytes = 99;
}
}
,
}
;

/// With and without the bounds of the active voxels in the metadata of the file.
void test_bad(void **state)
{
    const BadCase &c = *static_cast<const BadCase *>(*state);
    for (const bool statistics : {true, false}) {
        for (const uint32_t flags : {0u, uint32_t{SHD_LOAD_IN_PROCESS}}) {
            const auto grid = make_grid<FloatGrid>("density", 8);
            const std::string path = io_path("bad.vdb");
            shd_vdb_desc desc = shd_vdb_desc_default();
            shd_load_desc load = shd_load_desc_default();
            shd_texture *texture = reinterpret_cast<shd_texture *>(g_context);
            c.change(*grid, desc, load);
            load.flags |= flags;
            write_grids(path, {grid}, openvdb::io::COMPRESS_ACTIVE_MASK, statistics);
            shd_assert_result(c.name, load_vdb(g_context, path.c_str(), &desc, &load, nullptr, &texture), c.expected,
                              c.message);
            assert_true((texture != nullptr) == (c.expected == SHD_OK));
            shd_texture_release(texture);
        }
    }
}

/// Files without a grid of numbers, other files, and streams.
void test_others(void **)
{
    const auto bools = openvdb::BoolGrid::create(false);
    const std::string path = io_path("others.vdb");
    shd_texture *texture = nullptr;
    shd_vdb_desc desc = named("mask");
    bools->setName("mask");
    bools->tree().setValue(Coord(0, 0, 0), true);
    write_grids(path, {bools}, 0, true);
    shd_assert_result("first", load_vdb(g_context, path.c_str(), nullptr, nullptr, nullptr, &texture),
                      SHD_ERROR_UNSUPPORTED, "no grid of float or double");
    shd_assert_result("named", load_vdb(g_context, path.c_str(), &desc, nullptr, nullptr, &texture),
                      SHD_ERROR_UNSUPPORTED, "\"mask\" is a Tree_bool_5_4_3, not a grid of float or double");
    {
        std::ofstream out(path, std::ios::binary);
        openvdb::io::Stream(out).write(openvdb::GridCPtrVec{make_grid<FloatGrid>("density", 9)});
    }
    shd_assert_result("stream", load_vdb(g_context, path.c_str(), nullptr, nullptr, nullptr, &texture),
                      SHD_ERROR_UNSUPPORTED, "a stream, without offsets of grids");
    io_write(path.c_str(), "P6\n2 2\n255\nabcdefghijkl", 23);
    desc = shd_vdb_desc_default();
    shd_assert_result("ppm", load_vdb(g_context, path.c_str(), &desc, nullptr, nullptr, &texture),
                      SHD_ERROR_UNSUPPORTED, "not OpenVDB");
    // A name that OpenVDB does not find again. Its message contains the path that it was given, which differs between
    // loads.
    io_bytes bytes = io_read(write_one(make_grid<FloatGrid>("density", 10)).c_str());
    for (size_t at = 0; at + 7 <= bytes.size; ++at) {
        if (std::memcmp(bytes.data + at, "density", 7) == 0)
            std::memcpy(bytes.data + at,
                        "a[b\x1e"
                        "cde",
                        7);
    }
    io_write(path.c_str(), bytes.data, bytes.size);
    std::free(bytes.data);
    for (const uint32_t flags : {0u, uint32_t{SHD_LOAD_IN_PROCESS}}) {
        shd_load_desc load = shd_load_desc_default();
        load.flags = flags;
        shd_assert_result("name", load_vdb(g_context, path.c_str(), nullptr, &load, nullptr, &texture),
                          SHD_ERROR_CORRUPT, "OpenVDB: KeyError: the file has no grid named \"a[b[cde]\"");
    }
    shd_assert_result("absent", load_vdb(g_context, io_path("no.vdb"), nullptr, nullptr, nullptr, &texture),
                      SHD_ERROR_NOT_FOUND, "no.vdb");
    shd_assert_result("out", load_vdb(g_context, path.c_str(), nullptr, nullptr, nullptr, nullptr), ARGUMENT,
                      "out_texture: NULL");
}

}  // namespace

int main()
{
    std::vector<CMUnitTest> tests = {
        {"grids", test_grids, nullptr, nullptr, nullptr},     {"halves", test_halves, nullptr, nullptr, nullptr},
        {"boxes", test_boxes, nullptr, nullptr, nullptr},     {"cut", test_cut, nullptr, nullptr, nullptr},
        {"changed", test_changed, nullptr, nullptr, nullptr}, {"others", test_others, nullptr, nullptr, nullptr}};
    void *state = nullptr;
    openvdb::initialize();
    for (const BadCase &row : k_bad)
        tests.push_back({row.name, test_bad, nullptr, nullptr, const_cast<BadCase *>(&row)});
    if (io_make_folder(&state) != 0 || shd_context_create(nullptr, &g_context) != SHD_OK) return 1;
    const int failed = _cmocka_run_group_tests("api.io_vdb", tests.data(), tests.size(), nullptr, nullptr);
    io_remove_folder(&state);
    shd_context_release(g_context);
    return failed;
}

#endif
