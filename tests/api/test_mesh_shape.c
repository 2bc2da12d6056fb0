/* SPDX-License-Identifier: MIT */
/* Meshes of shapes in one call: those that shd_shape_fill() and shd_mesh_create() make; refusals; allocations that
   fail. */
#include <stdlib.h>

#include "support/check.h"
#include "support/fault_allocator.h"

#include <shd/mesh.h>

enum { COLUMNS = 8 };

/* A mesh as columns: position, normal, uv, tangent; free with drop(). */
struct contents {
    shd_mesh_info info;
    float *column[COLUMNS + 4];
    uint32_t *index;
};

static struct contents contents_of(const shd_mesh *mesh)
{
    struct contents out;
    shd_f32_out columns[COLUMNS + 4];
    shd_u32_out indices = {NULL, 0};
    int c;
    out.info = shd_mesh_info_default();
    shd_assert_ok(shd_mesh_get_info(mesh, &out.info));
    for (c = 0; c < COLUMNS + 4; ++c) {
        out.column[c] = (float *)malloc(sizeof(float) * out.info.vertex_count);
        columns[c] = shd_f32_out_column(out.column[c], 0);
    }
    out.index = indices.data = (uint32_t *)malloc(sizeof(uint32_t) * 3 * out.info.triangle_count);
    shd_assert_ok(shd_mesh_read_positions(mesh, columns));
    shd_assert_ok(shd_mesh_read_normals(mesh, columns + 3));
    shd_assert_ok(shd_mesh_read_uv(mesh, columns + 6));
    shd_assert_ok(shd_mesh_read_tangents(mesh, columns + 8));
    shd_assert_ok(shd_mesh_read_indices(mesh, &indices));
    return out;
}

static void drop(struct contents *contents)
{
    int c;
    for (c = 0; c < COLUMNS + 4; ++c) free(contents->column[c]);
    free(contents->index);
}

/* The mesh from the caller's columns. */
static shd_mesh *from_columns(shd_context *context, const shd_shape_desc *desc, shd_mesh_flags flags)
{
    shd_shape_columns columns = shd_shape_columns_default();
    shd_mesh_desc made = shd_mesh_desc_default();
    shd_mesh *mesh = NULL;
    float *values;
    int c;
    shd_assert_ok(shd_shape_count(desc, &columns.vertex_count, &columns.index_count));
    values = (float *)malloc(sizeof(float) * COLUMNS * columns.vertex_count);
    columns.indices.data = (uint32_t *)malloc(sizeof(uint32_t) * columns.index_count);
    for (c = 0; c < COLUMNS; ++c) {
        float *column = values + (size_t)c * columns.vertex_count;
        *(c < 3   ? &columns.position[c]
          : c < 6 ? &columns.normal[c - 3]
                  : &columns.uv[c - 6]) = shd_f32_out_column(column, 0);
        *(c < 3 ? &made.position[c] : c < 6 ? &made.normal[c - 3] : &made.uv[c - 6]) = shd_f32_column(column, 0);
    }
    shd_assert_ok(shd_shape_fill(desc, &columns));
    made.vertex_count = columns.vertex_count;
    made.index_count = columns.index_count;
    made.indices.data = columns.indices.data;
    made.flags = flags;
    shd_assert_ok(shd_mesh_create(context, &made, &mesh));
    free(values);
    free(columns.indices.data);
    return mesh;
}

static void test_same(void **state)
{
    shd_context *context = NULL;
    int shape, tangents, c;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    for (shape = -1; shape <= SHD_SHAPE_TEAPOT; ++shape) {
        for (tangents = 0; tangents < 2; ++tangents) {
            const shd_mesh_flags flags = tangents ? SHD_MESH_TANGENTS : SHD_MESH_NONE;
            shd_shape_desc desc = shd_shape_desc_default();
            const shd_shape_desc *passed = shape < 0 ? NULL : &desc;
            shd_mesh *mesh = NULL, *expected;
            struct contents got, want;
            desc.kind = shape < 0 ? SHD_SHAPE_SPHERE : (shd_shape)shape;
            desc.segments[0] = shape < 0 ? 0 : 5;
            shd_assert_ok(shd_mesh_create_shape(context, passed, flags, &mesh));
            expected = from_columns(context, passed, flags);
            got = contents_of(mesh);
            want = contents_of(expected);
            assert_true(want.info.vertex_count > 3 && want.info.triangle_count > 1);
            assert_memory_equal(&got.info, &want.info, sizeof got.info);
            for (c = 0; c < COLUMNS + 4; ++c) {
                assert_memory_equal(got.column[c], want.column[c], sizeof(float) * want.info.vertex_count);
            }
            assert_memory_equal(got.index, want.index, sizeof(uint32_t) * 3 * want.info.triangle_count);
            drop(&got);
            drop(&want);
            shd_mesh_release(mesh);
            shd_mesh_release(expected);
        }
    }
    shd_context_release(context);
}

static void test_refusals(void **state)
{
    shd_context *context = NULL;
    shd_shape_desc desc = shd_shape_desc_default();
    shd_mesh *mesh = (shd_mesh *)&desc;
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &context));
    shd_assert_result("context", shd_mesh_create_shape(NULL, &desc, 0, &mesh), SHD_ERROR_INVALID_ARGUMENT, "context");
    assert_null(mesh);
    shd_assert_result("out_mesh", shd_mesh_create_shape(context, &desc, 0, NULL), SHD_ERROR_INVALID_ARGUMENT,
                      "out_mesh: NULL");
    shd_assert_result("flags", shd_mesh_create_shape(context, &desc, 64, &mesh), SHD_ERROR_UNSUPPORTED,
                      "flags: bits 0x40 ");
    desc.radius = 0;
    mesh = (shd_mesh *)&desc;
    shd_assert_result("radius", shd_mesh_create_shape(context, &desc, 0, &mesh), SHD_ERROR_INVALID_ARGUMENT,
                      "shape.radius: 0 is not in 1e-30..1e+30");
    assert_null(mesh);
    shd_context_release(context);
}

/* Each allocation fails in turn, and nothing is left. */
static void test_faults(void **state)
{
    shd_fault_allocator memory;
    shd_context_desc context_desc;
    shd_context *context = NULL;
    shd_mesh *mesh = NULL;
    size_t at = 0, blocks;
    shd_result result = SHD_ERROR_OUT_OF_MEMORY;
    (void)state;
    memset(&memory, 0, sizeof memory);
    context_desc = shd_fault_context_desc(&memory);
    shd_assert_ok(shd_context_create(&context_desc, &context));
    blocks = memory.live_blocks;
    while (result != SHD_OK) {
        shd_fault_arm(&memory, ++at, 0);
        result = shd_mesh_create_shape(context, NULL, SHD_MESH_TANGENTS | SHD_MESH_ADJACENCY, &mesh);
        if (result == SHD_OK) break;
        shd_assert_result("fault", result, SHD_ERROR_OUT_OF_MEMORY, "out of memory");
        assert_null(mesh);
        assert_int_equal(memory.live_blocks, blocks);
    }
    assert_true(at > 4);
    shd_mesh_release(mesh);
    shd_context_release(context);
    shd_assert_all_freed("shape", &memory);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        {"same", test_same, NULL, NULL, NULL},
        {"refusals", test_refusals, NULL, NULL, NULL},
        {"faults", test_faults, NULL, NULL, NULL},
    };
    return cmocka_run_group_tests_name("api.mesh_shape", tests, NULL, NULL);
}
