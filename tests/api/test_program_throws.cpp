// SPDX-License-Identifier: MIT
// Programs that break their contract by throwing or by changing the number of rows: the call fails with a message,
// nothing leaks, and the next render works.
#include "support/frame.h"

#include <cstdlib>
#include <stdexcept>

#include <atomic>

namespace
{

std::atomic<long long> g_bytes{0};

void *take(size_t size, size_t alignment, void *)
{
    g_bytes += static_cast<long long>(size);
    return aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}
void give_back(void *memory, size_t size, size_t, void *)
{
    g_bytes -= static_cast<long long>(size);
    free(memory);
}

/// Action of both programs, and the draw in which it happens.
enum class Deed { kNothing, kThrowException, kThrowNumber, kThrowBadAlloc, kChangeCount };
struct Plan {
    Deed vertex, fragment;
};

template <class In>
void act(Deed deed, const In *in)
{
    switch (deed) {
        case Deed::kThrowException: throw std::runtime_error("no more sugar");
        case Deed::kThrowNumber: throw 7;
        case Deed::kThrowBadAlloc: throw std::bad_alloc();
        case Deed::kChangeCount: ++const_cast<In *>(in)->count; return;
        default: return;
    }
}

extern "C" void vertex(const shd_vertices *in, shd_vertex_outputs *, void *user_data)
{
    act(static_cast<const Plan *>(user_data)->vertex, in);
}
extern "C" void fragment(const shd_fragments *in, shd_radiance *, void *user_data)
{
    act(static_cast<const Plan *>(user_data)->fragment, in);
}

struct throw_case {
    const char *name;
    Plan plan;
    shd_frequency frequency;
    const char *message;
};
const throw_case k_throws[] = {
    {"vertex/exception",
     {Deed::kThrowException, Deed::kNothing},
     SHD_FREQUENCY_PHONG,
     "material.program.vertex threw in render.draws[1]: no more sugar"},
    {"vertex/number",
     {Deed::kThrowNumber, Deed::kNothing},
     SHD_FREQUENCY_PHONG,
     "material.program.vertex threw in render.draws[1]"},
    {"vertex/bad_alloc",
     {Deed::kThrowBadAlloc, Deed::kNothing},
     SHD_FREQUENCY_PHONG,
     "material.program.vertex threw in render.draws[1]: "},
    {"fragment/exception",
     {Deed::kNothing, Deed::kThrowException},
     SHD_FREQUENCY_PHONG,
     "material.program.fragment threw in render.draws[1]: no more sugar"},
    {"fragment/gouraud",
     {Deed::kNothing, Deed::kThrowException},
     SHD_FREQUENCY_GOURAUD,
     "material.program.fragment threw in render.draws[1]: no more sugar"},
    {"fragment/number",
     {Deed::kNothing, Deed::kThrowNumber},
     SHD_FREQUENCY_PHONG,
     "material.program.fragment threw in render.draws[1]"},
    {"fragment/bad_alloc",
     {Deed::kNothing, Deed::kThrowBadAlloc},
     SHD_FREQUENCY_FLAT,
     "material.program.fragment threw in render.draws[1]: "},
#ifndef NDEBUG
    {"vertex/count",
     {Deed::kChangeCount, Deed::kNothing},
     SHD_FREQUENCY_PHONG,
     "material.program.vertex changed the count in render.draws[1]"},
    {"fragment/count",
     {Deed::kNothing, Deed::kChangeCount},
     SHD_FREQUENCY_PHONG,
     "material.program.fragment changed the count in render.draws[1]"},
#endif
};

void test_throw(void **state)
{
    const auto &c = *static_cast<const throw_case *>(*state);
    shd_context_desc desc = shd_context_desc_default();
    shd_material_desc m = shd_frame_plain(1, 1, 1);
    Plan plan = c.plan;
    float quad[48];
    shd_frame f;
    shd_frame_open(&f, 150, 150);
    shd_frame_quad(-1, -1, 1, 1, 0.5f, 0.5f, quad);
    shd_frame_draw(&f, quad, 6, &m);
    m.model = SHD_MODEL_PROGRAM;
    m.program = {fragment, vertex, &plan};
    m.varying_count = 4;
    shd_frame_quad(-1, -1, 1, 1, 0.25f, 0.25f, quad);
    shd_frame_draw(&f, quad, 6, &m)->frequency = c.frequency;
    shd_context_release(f.context);
    desc.flags = SHD_CONTEXT_RETURN_MEMORY;
    desc.allocator.allocate = take;
    desc.allocator.free = give_back;
    desc.worker_count = 3;
    shd_assert_ok(shd_context_create(&desc, &f.context));
    const long long before = g_bytes;
    for (int run = 0; run < 3; ++run) {
        shd_assert_result(c.name, shd_render(f.context, &f.desc), SHD_ERROR_CALLBACK, c.message);
        assert_int_equal(f.stats.triangle_count, 0);
        assert_true(g_bytes == before);
    }
    plan = {Deed::kNothing, Deed::kNothing};
    shd_frame_render(&f);
    assert_int_equal(f.stats.fragment_count, 150 * 150);
    assert_true(g_bytes == before);
    shd_frame_close(&f);
    assert_true(g_bytes == 0);
}

}  // namespace

int main()
{
    CMUnitTest tests[16];
    size_t n = 0;
    for (const throw_case &c : k_throws) {
        tests[n++] = {c.name, test_throw, nullptr, nullptr, const_cast<throw_case *>(&c)};
    }
    return _cmocka_run_group_tests("api.program_throws", tests, n, nullptr, nullptr);
}
