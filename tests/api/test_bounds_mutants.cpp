// SPDX-License-Identifier: MIT
// A thousand texture units with one bug each: the bounds of every preset refuse at least 99.9 % of them, and no unit
// without a bug. A unit is refused if one of its values is outside.
//
//     test_api_bounds_mutants [legal units]
#include "support/bounds_scene.h"

namespace shd::tests
{
namespace
{

using ref::Bug;

constexpr int kMutants = 1000, kLookups = 96;
constexpr double kLeastCaught = 0.999;
int g_legal_units = 40;

const char *const kBugNames[] = {"none",           "shift",       "wrap",         "swapped axes",   "mirrored axis",
                                 "level shift",    "level scale", "one step",     "shorter axis",   "one size",
                                 "no bias",        "no clamps",   "few bits",     "few level bits", "swapped weights",
                                 "flipped weight", "one column",  "filter first", "no decode",      "alpha decoded",
                                 "address bit",    "weight bit",  "result bit",   "level bit",      "swapped channels",
                                 "layer",          "no filter",   "no blend",     "blend flipped",  "long line",
                                 "wrong line",     "probe sum",   "line shift",   "flipped face",   "no seam",
                                 "larger levels",  "border"};
static_assert(std::size(kBugNames) == static_cast<size_t>(Bug::kCount), "a name for each bug");

double pick(Random *random, std::initializer_list<double> values)
{
    return values.begin()[random->whole(0, static_cast<int64_t>(values.size()) - 1)];
}

void set_levels(Random *random, const shd_bounds_desc &rules, ref::Unit *unit)
{
    switch (unit->bug) {
        case Bug::kLevelShift: unit->a = pick(random, {-2, -1, -0.5, -0.25, 0.25, 0.5, 1, 2}); break;
        case Bug::kLevelScale: unit->a = pick(random, {0.5, 0.693147, 1.442695, 2}); break;
        case Bug::kFewLevelBits: unit->option = random->whole(0, static_cast<int64_t>(rules.level_bits) - 2); break;
        case Bug::kLongLine: unit->a = pick(random, {1.5, 2, 3}); break;
        case Bug::kProbeSum: unit->a = pick(random, {-0.5, 0.5, 1}); break;
        case Bug::kLineShift: unit->a = pick(random, {-0.5, -0.25, 0.25, 0.5}); break;
        default: break;
    }
}

/// A texture unit of average precision with a random bug. Errors are larger than the rules allow: numbers of bits are
/// at least two below the least one.
ref::Unit mutant(int number, const shd_bounds_desc &rules, Random *random)
{
    ref::Unit unit;
    unit.subtexel_bits = static_cast<int>(rules.subtexel_bits) + 2;
    unit.level_bits = static_cast<int>(rules.level_bits) + 2;
    unit.bug = static_cast<Bug>(1 + number % (static_cast<int>(Bug::kCount) - 1));
    unit.option = random->whole(0, 2);
    const auto fewer = static_cast<int64_t>(rules.subtexel_bits) - 2;
    set_levels(random, rules, &unit);
    switch (unit.bug) {
        case Bug::kShift:
            unit.a = pick(random, {-1, -0.5, -0.25, 0.25, 0.5, 1});
            unit.b = pick(random, {-1, -0.5, -0.25, 0, 0.25, 0.5, 1});
            if (random->whole(0, 1)) std::swap(unit.a, unit.b);
            if (!random->whole(0, 4)) unit.c = unit.a, unit.a = unit.b = 0;
            break;
        case Bug::kWrap: unit.option |= 4 * random->whole(0, 4); break;
        case Bug::kFewBits: unit.option = random->whole(0, fewer); break;
        case Bug::kAddressBit: unit.option = random->whole(0, 7); break;
        case Bug::kWeightBit: unit.a = std::exp2(-static_cast<double>(random->whole(1, fewer))); break;
        case Bug::kResultBit: unit.option = random->whole(0, 31); break;
        case Bug::kSwappedChannels: unit.option = random->whole(0, 2), unit.option |= 4 * (unit.option + 1); break;
        case Bug::kFlippedFace: unit.option = random->whole(0, 11); break;
        default: break;
    }
    return unit;
}

/// Scenes with their bounds by some rules.
struct Judge {
    Scenes scenes;
    std::vector<std::unique_ptr<SceneBounds>> bounds;

    Judge(const shd_bounds_desc &rules, uint64_t seed) : scenes(g_context, kLookups, seed)
    {
        for (const Scene &scene : scenes.list) bounds.push_back(std::make_unique<SceneBounds>(g_context, scene, rules));
    }

    /// Whether a unit has a value that is not legal. `which` receives its scene.
    bool refuses(const ref::Unit &unit, size_t *which) const
    {
        for (*which = 0; *which < bounds.size(); ++*which) {
            const Scene &scene = scenes.list[*which];
            for (size_t i = 0; i < scene.lookups.count(); ++i) {
                const ref::Value got = ref::unit_sample(scene.image, unit, scene.lookups.at(i));
                const double value[4] = {got[0], got[1], got[2], got[3]};
                if (bounds[*which]->illegal(i, value) >= 0) return true;
            }
        }
        return false;
    }
};

int count_caught(const Judge &judge, const shd_bounds_desc &rules, Random *random)
{
    int caught = 0;
    for (int k = 0; k < kMutants; ++k) {
        const ref::Unit unit = mutant(k, rules, random);
        size_t scene;
        if (judge.refuses(unit, &scene)) {
            ++caught;
        } else {
            print_message("  missed: %s, option %d, %g, %g\n", kBugNames[static_cast<int>(unit.bug)], unit.option,
                          unit.a, unit.b);
        }
    }
    return caught;
}

void test_mutants(void **)
{
    const char *const names[] = {"Vulkan", "D3D11", "WebGPU", "OpenGL"};
    for (int number = SHD_RULES_VULKAN; number <= SHD_RULES_OPENGL; ++number) {
        const shd_bounds_desc rules = preset(static_cast<shd_rules>(number));
        Random random{77};
        const Judge judge(rules, 100 + static_cast<uint64_t>(number));
        const int caught = count_caught(judge, rules, &random);
        int refused = 0;
        for (int k = 0; k < g_legal_units / SHD_ORACLE_STRIDE; ++k) {
            size_t scene;
            refused += judge.refuses(legal_unit(rules, &random), &scene);
        }
        print_message("%-7s %4d of %d bugs caught, %d of %d legal units refused\n", names[number], caught, kMutants,
                      refused, g_legal_units / SHD_ORACLE_STRIDE);
        assert_true(caught >= kLeastCaught * kMutants);
        assert_int_equal(refused, 0);
    }
}

}  // namespace
}  // namespace shd::tests

int main(int argc, char **argv)
{
    using namespace shd::tests;
    if (argc > 1) g_legal_units = atoi(argv[1]);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_mutants)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
